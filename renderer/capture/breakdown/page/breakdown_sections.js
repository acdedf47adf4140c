// ---- the head: what, where, how much ---------------------------------------------------------------------------------

const sections = [];  // {id, title, element, passes}
function addSection(id, title, text, ...children) {
  const element = make("section", {id, "aria-label": title}, make("h2", {}, title), text ? make("p", {class: "lead"}, text) : null, children);
  main.append(element);
  const section = {id, title, element, passes: []};
  sections.push(section);
  return section;
}
const f = frame.frame;
function head() {
  const title = frame.breakdown.title || "Frame";
  document.title = title + " – frame breakdown";
  const where = [frame.size && frame.size.join("×"), frame.gl_renderer, frame.context].filter(Boolean).join(" · ");
  const tiles = [["draws", f.draws], ["triangles", f.triangles], ["GL calls", f.gl_calls], ["state changes", f.state_changes],
    ["passes", frame.passes.length], ["objects seen", f.visible], ["lights in view", f.lights_visible]];
  const tile = (value, name) => make("div", {class: "tile"}, make("b", {}, value), make("span", {}, name));
  main.append(make("h1", {}, title), make("p", {class: "facts"}, where || "A frame, taken apart."),
    make("div", {class: "tiles"}, tiles.map(([name, value]) => tile(number(value), name)),
      tile(time(f.cpu_build_ms + f.cpu_execute_ms), "CPU ms"), tile(time(f.gpu_ms), "GPU ms")));
}

// ---- overview: costs and flow ----------------------------------------------------------------------------------------

const anchor = (index) => "pass-" + index;
function overview() {
  const most = Math.max(...frame.passes.map((p) => p.gpu_ms), 1e-6);
  const row = (pass, i) => make("tr", {},
    make("td", {}, make("a", {href: "#" + anchor(i)}, (i + 1) + " " + pass.name)),
    [pass.draws, pass.triangles, pass.gl_calls, pass.state_changes].map((v) => make("td", {}, number(v))),
    make("td", {}, time(pass.cpu_ms)),
    make("td", {class: "time", style: `--share:${100 * pass.gpu_ms / most}%`}, time(pass.gpu_ms)),
    make("td", {}, pass.bytes_per_pixel));
  const outside = frame.breakdown.outside_passes;
  const names = ["Pass", "Draws", "Triangles", "GL calls", "State changes", "CPU ms", "GPU ms", "Bytes a pixel"];
  addSection("overview", "Overview", "Every pass in the order in which it ran. Counters are exact; GPU times are those of the same frame, drawn just before.",
    make("div", {class: "card scroll"}, make("table", {},
      make("thead", {}, make("tr", {}, names.map((n) => make("th", {}, n)))),
      make("tbody", {}, frame.passes.map(row), make("tr", {}, make("td", {}, "beside passes"), make("td", {}, "0"), make("td", {}, "0"),
        make("td", {}, number(outside.gl_calls)), make("td", {}, number(outside.state_changes)), make("td"), make("td"), make("td"))),
      make("tfoot", {}, make("tr", {}, make("td", {}, "Frame"), [f.draws, f.triangles, f.gl_calls, f.state_changes].map((v) => make("td", {}, number(v))),
        make("td", {}, time(f.cpu_execute_ms)), make("td", {}, time(f.gpu_ms)), make("td"))))));
  addSection("flow", "Reads and writes", "Images run downwards from the pass that first writes them to the last that needs them: a full dot is written, a ring is read.",
    make("div", {class: "card scroll", id: "graph"}, graph()));
}

function lanesOf(passes) {
  const images = new Map();
  const touch = (name, row, write) => {
    if (!images.has(name)) images.set(name, {name, first: write ? row : -1, last: row, rows: []});
    const image = images.get(name);
    image.last = row;
    const known = image.rows.find((r) => r.row === row);
    if (known) known.write = known.write || write;
    else image.rows.push({row, write});
  };
  passes.forEach((pass, row) => {
    for (const name of pass.reads || []) touch(name, row, false);
    for (const name of pass.writes || []) touch(name, row, true);
  });
  const free = [];  // by lane: the row after which it may be used again
  for (const image of [...images.values()].sort((a, b) => a.first - b.first)) {
    let lane = free.findIndex((end) => end < image.first);
    if (lane < 0) lane = free.push(0) - 1;
    free[lane] = image.last;
    image.lane = lane;
  }
  return {images: [...images.values()], count: free.length};
}
function graph() {
  const passes = frame.passes, height = 27, top = 30, boxWidth = 168, first = boxWidth + 34, gap = 21;
  const {images, count} = lanesOf(passes), right = first + count * gap + 12;
  const y = (row) => top + row * height, x = (image) => first + image.lane * gap;
  const hue = (image) => `hsl(${(images.indexOf(image) * 137.5) % 360} 62% 52%)`;
  const writes = (pass) => (pass.images || []).map((image) => image.name + " " + String(image.format).toUpperCase()).join(",  ");
  const longest = Math.max(...passes.map((pass) => writes(pass).length));
  const svg = make("svg:svg", {width: right + longest * 7.4, height: y(passes.length), role: "img", "aria-label": "Passes and the images between them"});
  const focus = (names) => {
    const box = document.getElementById("graph");
    box.classList.toggle("focus", names !== null);
    for (const part of svg.querySelectorAll(".part")) part.classList.toggle("on", names !== null && names.has(part.dataset.image));
  };
  for (const image of images) {
    const from = image.first < 0 ? top - 22 : y(image.first), lane = make("svg:g", {class: "part", "data-image": image.name});
    lane.append(make("svg:line", {x1: x(image), x2: x(image), y1: from, y2: y(image.last), stroke: hue(image), "stroke-width": 3}));
    for (const {row, write} of image.rows) {
      lane.append(make("svg:line", {x1: boxWidth, x2: x(image), y1: y(row), y2: y(row), stroke: hue(image), "stroke-width": 1.2, opacity: 0.55}));
      lane.append(make("svg:circle", {cx: x(image), cy: y(row), r: 5, fill: write ? hue(image) : "var(--card)", stroke: hue(image), "stroke-width": 2}));
    }
    lane.append(make("svg:title", {}, image.name + (image.first < 0 ? " (kept from before)" : "")));
    lane.addEventListener("mouseenter", () => focus(new Set([image.name])));
    lane.addEventListener("mouseleave", () => focus(null));
    svg.append(lane);
  }
  passes.forEach((pass, row) => {
    const link = make("svg:a", {href: "#" + anchor(row)});
    link.append(make("svg:rect", {class: "pass", x: 0.5, y: y(row) - 11, width: boxWidth, height: 22, rx: 6}),
      make("svg:text", {x: 10, y: y(row) + 4}, (row + 1) + "  " + pass.name));
    const group = make("svg:g", {class: "row"}, link);
    group.addEventListener("mouseenter", () => focus(new Set([...(pass.reads || []), ...(pass.writes || [])])));
    group.addEventListener("mouseleave", () => focus(null));
    group.append(make("svg:text", {x: right, y: y(row) + 4, class: "soft"}, writes(pass)));
    svg.append(group);
  });
  return svg;
}

// ---- the frame in the deck's order -------------------------------------------------------------------------------------

function culling(section) {
  const kinds = [["drawn", f.visible, "#3c9d64"], ["hidden behind others", f.culled_occlusion, "#e0524a"], ["too small", f.culled_small, "#e5b93a"],
    ["outside of the view", f.culled_frustum, "#8a93a1"], ["rejected: not valid", f.rejected, "#7b4fb3"]];
  section.element.append(make("div", {class: "bar", "aria-hidden": "true"}, kinds.filter((k) => k[1] > 0).map(([name, n, color]) =>
    make("i", {style: `flex:${n};background:${color}`, title: name + ": " + n}))),
    make("ul", {class: "kinds"}, make("li", {}, make("b", {}, number(f.instances)), " objects"), kinds.map(([name, n, color]) =>
      make("li", {}, make("i", {style: "background:" + color}), make("b", {}, number(n)), " " + name))));
}
const commandLines = String(frame.commands || "").split("\n").filter((line) => line);
function commandsOf(index) {
  const begin = commandLines.findIndex((line) => new RegExp("^\\s*\\d+\\s+BeginPass " + index + " ").test(line));
  const end = commandLines.findIndex((line) => new RegExp("^\\s*\\d+\\s+EndPass " + index + "$").test(line));
  return begin < 0 || end < begin ? [] : commandLines.slice(begin, end + 1);
}
function costs(pass) {
  const item = (value, name) => make("li", {}, make("b", {}, value), " " + name);
  const counted = (value, name) => item(number(value), value === 1 ? name : name + "s");
  return make("ul", {class: "costs"}, counted(pass.draws, "draw"), counted(pass.triangles, "triangle"),
    counted(pass.gl_calls, "GL call"), counted(pass.state_changes, "state change"), item(time(pass.cpu_ms), "ms CPU"),
    item(time(pass.gpu_ms), "ms GPU"), item(pass.bytes_per_pixel, "bytes a pixel"));
}
function passCard(pass, index) {
  const pictures = frame.breakdown.pictures.filter((p) => p.pass === index);
  const lines = commandsOf(index);
  return make("article", {class: pictures.length > 1 ? "card wide" : "card", id: anchor(index)},
    make("header", {}, make("h3", {}, pass.name), make("span", {class: "order"}, "pass " + (index + 1) + " of " + frame.passes.length)),
    costs(pass),
    make("p", {class: "flows"}, "Reads " + ((pass.reads || []).join(", ") || "nothing of this frame") + ". Writes " + ((pass.writes || []).join(", ") || "nothing") + "."),
    make("div", {class: "figures"}, pictures.map((p) => figure(frame, p))),
    make("details", {}, make("summary", {}, lines.length + " lines of commands"), make("pre", {tabindex: 0}, lines.join("\n"))));
}
function chapters() {
  for (const {id, title, text} of frame.breakdown.sections) {
    const passes = frame.passes.map((pass, index) => ({pass, index})).filter((p) => p.pass.section === id);
    let views = frame.breakdown.pictures.filter((p) => p.pass < 0 && p.section === id);
    if (id === "textures") {  // the light, the colour, and both
      const named = (name) => frame.breakdown.pictures.find((p) => p.name === name);
      views = [named("view.untextured"), named("view.basecolor"), named("lighting.radiance")].filter(Boolean);
    }
    if (!passes.length && !views.length && id !== "culling") continue;
    const section = addSection(id, title, text);
    if (id === "culling") culling(section);
    if (views.length) section.element.append(make("div", {class: views.length < 3 ? "figures two" : "figures"}, views.map((p) => figure(frame, p))));
    section.passes.push(...passes.map((p) => p.index));
    section.element.append(make("div", {class: "cards"}, passes.map((p) => passCard(p.pass, p.index))));
  }
}

// ---- commands --------------------------------------------------------------------------------------------------------

function commands() {
  const search = make("input", {type: "search", placeholder: "Search: a pass, a label, a command", "aria-label": "Search the commands"});
  const count = make("span", {class: "order"}), list = make("pre", {tabindex: 0});
  const marked = (line, wanted) => {
    const at = line.toLowerCase().indexOf(wanted);
    return make("span", {}, line.slice(0, at), make("mark", {}, line.slice(at, at + wanted.length)), line.slice(at + wanted.length) + "\n");
  };
  const update = () => {
    const wanted = search.value.trim().toLowerCase();
    const found = wanted ? commandLines.filter((line) => line.toLowerCase().includes(wanted)) : commandLines;
    count.textContent = " " + number(found.length) + " of " + number(commandLines.length) + " lines";
    list.replaceChildren(...(wanted ? found.map((line) => marked(line, wanted)) : [found.join("\n")]));
  };
  search.addEventListener("input", update);
  update();
  addSection("commands", "Commands", "The frame as the executor plays it. The numbers are those of rushlight replay --list and --until.",
    make("p", {}, search, count), make("details", {open: ""}, make("summary", {}, "All commands"), list));
  return search;
}
