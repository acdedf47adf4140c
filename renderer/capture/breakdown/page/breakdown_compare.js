// ---- beside another frame ----------------------------------------------------------------------------------------------

const badges = (pair) => {
  const badge = (kind, text) => make("span", {class: "badge " + kind}, text);
  if (pair.a === null || pair.b === null) return [badge("warn", pair.a === null ? "only in the other" : "only in this")];
  const list = [];
  if (pair.outputs) list.push(badge("bad", "writes differ"));
  if (pair.counters.length) list.push(badge("warn", "counters differ"));
  return list.length ? list : [badge("good", "same")];
};
function counterTable(pair) {
  const a = pair.a === null ? null : frame.passes[pair.a], b = pair.b === null ? null : other.passes[pair.b];
  const keys = ["draws", "triangles", "gl_calls", "state_changes", "bytes_per_pixel", "cpu_ms", "gpu_ms"];
  const text = (pass, key) => pass ? (key.endsWith("_ms") ? time(pass[key]) : number(pass[key] || 0)) : "–";
  return make("div", {class: "scroll"}, make("table", {}, make("thead", {}, make("tr", {}, ["", "This", "Other"].map((n) => make("th", {}, n)))),
    make("tbody", {}, keys.map((key) => make("tr", {class: pair.counters.includes(key) ? "changed" : null},
      make("td", {}, key.replaceAll("_", " ")), make("td", {}, text(a, key)), make("td", {}, text(b, key)))))));
}
function differencePicture(a, b, title) {
  const image = make("img", {alt: title}), picture = {title, name: title, readout: "color", note: "Eight times the difference."};
  const entry = {picture, source: image, image, facts: ""};
  const caption = make("figcaption", {}, make("b", {}, "Difference"), " ");
  const load = (whole, p) => loaded(sourceOf(whole, p)).then(pixelsOf);
  waiting.push(Promise.all([load(frame, a), load(other, b)]).then(([one, two]) => {
    if (one.canvas.width !== two.canvas.width || one.canvas.height !== two.canvas.height) {
      caption.append("Not of one size.");
      one.context.fillRect(0, 0, one.canvas.width, one.canvas.height);
    } else {
      const p = one.data.data, q = two.data.data;
      let differing = 0;
      for (let i = 0; i < p.length; i += 4) {
        const d = [0, 1, 2].map((k) => Math.abs(p[i + k] - q[i + k]));
        if (Math.max(...d) > 2) ++differing;
        for (let k = 0; k < 3; ++k) p[i + k] = Math.min(8 * d[k], 255);
      }
      one.context.putImageData(one.data, 0, 0);
      caption.append(make("span", {}, (400 * differing / p.length).toFixed(2) + " % of the pixels, eight times enlarged"));
    }
    image.src = one.canvas.toDataURL();
  }).catch(() => note("the difference of " + title + " cannot be shown")));
  shown.push(entry);
  const button = make("button", {type: "button", "aria-label": "Enlarge the difference of " + title}, image);
  button.addEventListener("click", () => openViewer(entry));
  return make("figure", {}, button, caption);
}
function imagesOf(pair) {
  const of = (whole, index) => index === null ? [] : whole.breakdown.pictures.filter((p) => p.pass === index);
  const as = of(frame, pair.a), bs = of(other, pair.b), rows = [];
  for (const a of as) {
    const b = bs.find((p) => p.title === a.title);
    rows.push(make("div", {class: "pair"}, figure(frame, a, "This: " + a.title), b ? figure(other, b, "Other: " + b.title) : null,
      b ? differencePicture(a, b, a.title) : null));
  }
  for (const b of bs)
    if (!as.some((p) => p.title === b.title)) rows.push(make("div", {class: "pair"}, figure(other, b, "Other: " + b.title)));
  return rows;
}
function viewPairs() {
  return frame.breakdown.pictures.filter((p) => p.pass < 0).map((a) => {
    const b = other.breakdown.pictures.find((p) => p.pass < 0 && p.name === a.name);
    if (!b || !other.data[b.name]) return null;  // the same bytes are kept once
    return make("div", {class: "pair"}, figure(frame, a, "This: " + a.title), figure(other, b, "Other: " + b.title), differencePicture(a, b, a.title));
  }).filter(Boolean);
}
function totalsTable() {
  const keys = Object.keys(f).filter((key) => typeof f[key] === "number" && typeof other.frame[key] === "number");
  const row = (key) => {
    const measured = key.endsWith("_ms") || key === "allocations", changed = !measured && f[key] !== other.frame[key];
    const text = (v) => key.endsWith("_ms") ? time(v) : number(v);
    return make("tr", {class: changed ? "changed" : null}, make("td", {}, key.replaceAll("_", " ")), make("td", {}, text(f[key])),
      make("td", {}, text(other.frame[key])), make("td", {class: "delta"}, changed ? (f[key] > other.frame[key] ? "+" : "−") + number(Math.abs(f[key] - other.frame[key])) : ""));
  };
  return make("details", {}, make("summary", {}, "Counters of the frames"), make("div", {class: "card scroll"}, make("table", {},
    make("thead", {}, make("tr", {}, ["Frame", "This: " + frame.breakdown.title, "Other: " + other.breakdown.title, "Difference"].map((n) => make("th", {}, n)))),
    make("tbody", {}, keys.map(row)))));
}
function comparison() {
  const pairs = frame.compared, same = pairs.filter((p) => p.a !== null && p.b !== null && !p.outputs && !p.counters.length);
  const different = pairs.filter((p) => !same.includes(p));
  const section = addSection("comparison", "Comparison",
    "This frame beside " + other.breakdown.title + ". Passes that write something else come first, in the order of the frame: the first of them is where the difference begins.");
  section.element.append(make("p", {class: "facts"}, different.length + " passes differ, " + same.length + " are the same" +
    (same.length ? ": " + same.map((p) => p.name).join(", ") : "") + "."), totalsTable());
  const views = viewPairs();
  different.forEach((pair) => section.element.append(make("article", {class: "card"},
    make("header", {}, make("h3", {}, pair.name), badges(pair)),
    make("details", {open: pair.counters.length ? "" : null}, make("summary", {}, "Counters"), counterTable(pair)),
    pair.outputs || pair.a === null || pair.b === null ? imagesOf(pair) : null)));
  if (views.length) section.element.append(make("article", {class: "card"}, make("header", {}, make("h3", {}, "Views into the frames")), views));
}

// ---- the index, keys, theme ----------------------------------------------------------------------------------------------

function index() {
  const list = document.getElementById("contents"), links = new Map();
  for (const section of sections) {
    const link = make("a", {href: "#" + section.id}, section.title);
    links.set(section.element, link);
    const item = make("li", {}, link);
    if (section.passes.length)
      item.append(make("ol", {}, section.passes.map((i) => make("li", {}, make("a", {href: "#" + anchor(i)}, frame.passes[i].name, make("span", {}, time(frame.passes[i].gpu_ms)))))));
    list.append(item);
  }
  const mark = () => {
    let now = sections[0];
    for (const section of sections) if (section.element.getBoundingClientRect().top < innerHeight / 3) now = section;
    for (const [element, link] of links) element === now.element ? link.setAttribute("aria-current", "true") : link.removeAttribute("aria-current");
    return sections.indexOf(now);
  };
  addEventListener("scroll", mark, {passive: true});
  mark();
  return (by) => sections[Math.min(Math.max(mark() + by, 0), sections.length - 1)].element.scrollIntoView();
}
function theme(name) { document.documentElement.dataset.theme = name; }

function checkTotals() {
  const sum = (key) => frame.passes.reduce((total, pass) => total + pass[key], 0), outside = frame.breakdown.outside_passes;
  const expect = (name, value, total) => { if (value !== total) note("the passes' " + name + " are " + value + ", the frame's " + total); };
  expect("draws", sum("draws"), f.draws);
  expect("triangles", sum("triangles"), f.triangles);
  expect("GL calls", sum("gl_calls") + outside.gl_calls, f.gl_calls);
  expect("state changes", sum("state_changes") + outside.state_changes, f.state_changes);
  expect("objects", f.visible + f.culled_frustum + f.culled_occlusion + f.culled_small + f.rejected, f.instances);
  for (const picture of frame.breakdown.pictures)
    if (!shown.some((entry) => entry.picture === picture)) note("the picture " + picture.name + " is not shown");
}

theme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
head();
if (other) comparison();
overview();
chapters();
const search = commands();
const go = index();
addEventListener("keydown", (e) => {
  if (e.ctrlKey || e.metaKey || e.altKey || e.target.matches("input")) return;
  if (e.key === "j") go(1);
  else if (e.key === "k") go(-1);
  else if (e.key === "t") theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
  else if (e.key === "/") { search.focus(); e.preventDefault(); }
});
checkTotals();
// For tests and for readers: whether all that the page says of itself holds.
Promise.all(waiting).then(() => {
  const root = document.documentElement;
  root.dataset.pictures = shown.length;
  root.dataset.check = problems.length ? "failed" : "ok";
  if (!problems.length) return;
  root.dataset.problems = problems.join("; ");
  main.prepend(make("p", {class: "problem"}, "This page does not agree with itself: " + problems.join("; ") + "."));
});
