"use strict";
// Text from the frame reaches the page through textContent alone, never as markup.
const problems = [];
const note = (problem) => problems.push(String(problem));
addEventListener("error", (e) => note(e.message || "an element failed to load"), true);
addEventListener("unhandledrejection", (e) => note(e.reason));
addEventListener("securitypolicyviolation", (e) => note("blocked: " + e.blockedURI));

const holder = document.getElementById("data");
const frame = JSON.parse(holder.textContent);
holder.textContent = "";
const other = frame.other || null;

const SVG = "http://www.w3.org/2000/svg";
function make(name, attributes, ...children) {
  const svg = name.startsWith("svg:");
  const element = svg ? document.createElementNS(SVG, name.slice(4)) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {}))
    if (value !== null && value !== undefined) element.setAttribute(key, value);
  for (const child of children.flat())
    if (child !== null && child !== undefined) element.append(child);
  return element;
}
const number = (value) => Number(value).toLocaleString("en");
const time = (value) => Number(value).toFixed(Number(value) < 10 ? 2 : 1);
const main = document.getElementById("main");

// ---- colours that stand for values ---------------------------------------------------------------------------------

const DISTANCES = [[255, 246, 214], [252, 190, 92], [238, 110, 72], [176, 52, 108], [96, 28, 120], [30, 16, 70]];
function distanceColor(t) {  // near to far
  const at = Math.min(Math.max(t, 0), 1) * (DISTANCES.length - 1), i = Math.min(Math.floor(at), DISTANCES.length - 2);
  return DISTANCES[i].map((c, k) => Math.round(c + (DISTANCES[i + 1][k] - c) * (at - i)));
}
function countColor(t) {  // as shaders/passes/debug/debug_view.frag
  const x = Math.min(Math.max(t, 0), 1) * 5, clip = (v) => Math.min(Math.max(v, 0), 1), white = clip(x - 4);
  return [clip(x - 2), clip(1 - Math.abs(x - 2.5) * 0.5 + 0.25) + white, clip(Math.min(x, 3 - x)) + white]
    .map((v) => Math.round(255 * Math.min(v, 1)));
}
const metres = (v) => v < 10 ? v.toFixed(2) : v < 1000 ? v.toFixed(1) : v.toFixed(0);
function legendOf(picture) {
  const distance = picture.readout === "distance";
  if (!distance && picture.readout !== "count") return null;
  const canvas = make("canvas", {width: 110, height: 1}), context = canvas.getContext("2d");
  for (let x = 0; x < 110; ++x) {
    context.fillStyle = "rgb(" + (distance ? distanceColor : countColor)(x / 109).join(",") + ")";
    context.fillRect(x, 0, 1, 1);
  }
  const [low, high] = distance ? [metres(picture.low) + " m", metres(picture.high) + " m"] : ["0", picture.high + " or more"];
  return make("span", {class: "legend"}, low, canvas, high);
}
function valueText(picture, [r, g, b]) {
  const signed = (v) => (v / 127.5 - 1).toFixed(2);
  switch (picture.readout) {
    case "unit": return (r / 255).toFixed(3);
    case "direction": return "(" + [r, g, b].map(signed).join(", ") + ")";
    case "velocity": {
      const share = (v) => { const s = (v - 127.5) / 127.5; return Math.abs(s) < 0.006 ? 0 : Math.sign(s) * s * s * 100; };
      return b === 0 ? "nothing" : share(r).toFixed(2) + " % right, " + share(g).toFixed(2) + " % up";
    }
    case "distance":
      return r === 0 ? "nothing" : metres(picture.low * Math.pow(picture.high / picture.low, 1 - r / 255)) + " m";
    case "count": {
      let best = 0, least = Infinity;
      for (let n = 0; n <= picture.high; ++n) {
        const c = countColor(n / picture.high), d = Math.abs(c[0] - r) + Math.abs(c[1] - g) + Math.abs(c[2] - b);
        if (d < least) [least, best] = [d, n];
      }
      return best + (best === picture.high ? " or more" : "");
    }
  }
  return "sRGB " + r + " " + g + " " + b;
}

// ---- pictures ------------------------------------------------------------------------------------------------------

const shown = [];   // what the viewer steps through
const waiting = []; // until the page is checked
function pixelsOf(image) {
  const canvas = make("canvas", {width: image.naturalWidth, height: image.naturalHeight});
  const context = canvas.getContext("2d", {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  return {canvas, context, data: context.getImageData(0, 0, canvas.width, canvas.height)};
}
function inFalseColor(image) {
  const {canvas, context, data} = pixelsOf(image), p = data.data;
  const table = [];
  for (let g = 0; g < 256; ++g) table.push(g === 0 ? [12, 12, 14] : distanceColor(1 - g / 255));
  for (let i = 0; i < p.length; i += 4) [p[i], p[i + 1], p[i + 2]] = table[p[i]];
  context.putImageData(data, 0, 0);
  return canvas;
}
function sourceOf(whole, picture) {
  return (whole.data && whole.data[picture.name]) || frame.data[picture.name];
}
function factsOf(whole, picture) {
  const pass = picture.pass >= 0 ? whole.passes[picture.pass] : null;
  const image = pass && pass.images[picture.image];
  if (!image) return picture.width + "×" + picture.height;
  return image.width + "×" + image.height + " · " + String(image.format).toUpperCase() + " · " + image.bytes_per_pixel +
    " bytes a pixel";
}
// Drawn once, as broken data shows only then. Not decode(): a browser whose clock runs ahead does not wait for that.
const probe = make("canvas", {width: 1, height: 1}).getContext("2d");
const loaded = (source) => new Promise((done, failed) => {
  const image = new Image();
  image.onload = () => { probe.drawImage(image, 0, 0, 1, 1); done(image); };
  image.onerror = () => failed("it does not load");
  image.src = source;
});
function figure(whole, picture, label) {
  const image = make("img", {alt: picture.title, src: sourceOf(whole, picture)});
  const ready = loaded(image.src).then((source) => {
    entry.source = source;  // as stored: what is read out
    if (source.naturalWidth < 64) image.className = "tiny";
    if (picture.readout === "distance") image.src = inFalseColor(source).toDataURL();
  });
  waiting.push(ready.catch(() => note("the picture " + picture.name + " does not decode")));
  const entry = {picture, source: image, image, facts: factsOf(whole, picture)};
  shown.push(entry);
  const button = make("button", {type: "button", "aria-label": "Enlarge " + picture.title}, image);
  button.addEventListener("click", () => openViewer(entry));
  return make("figure", {}, button, make("figcaption", {}, make("b", {}, label || picture.title), " ",
    make("span", {}, factsOf(whole, picture)), picture.note ? make("br") : null,
    picture.note ? make("span", {}, picture.note) : null, legendOf(picture) ? make("br") : null, legendOf(picture)));
}

// ---- the viewer ----------------------------------------------------------------------------------------------------

const viewer = document.getElementById("viewer"), stage = document.getElementById("stage");
const canvas = document.getElementById("canvas"), readout = document.getElementById("readout");
let current = null, pixels = null, view = {x: 0, y: 0, scale: 1};
function place() {
  canvas.style.transform = `translate(${view.x}px, ${view.y}px) scale(${view.scale})`;
  canvas.style.imageRendering = view.scale >= 2 ? "pixelated" : "auto";
  document.getElementById("viewer-scale").textContent = Math.round(view.scale * 100) + " %";
}
function zoomAbout(x, y, factor) {
  const scale = Math.min(Math.max(view.scale * factor, 0.05), 64), f = scale / view.scale;
  view = {x: x - (x - view.x) * f, y: y - (y - view.y) * f, scale};
  place();
}
function fit() {
  const scale = Math.min(stage.clientWidth / canvas.width, stage.clientHeight / canvas.height);
  view = {x: (stage.clientWidth - canvas.width * scale) / 2, y: (stage.clientHeight - canvas.height * scale) / 2, scale};
  place();
}
function openViewer(entry) {
  current = entry;
  if (!viewer.open) viewer.showModal();
  pixels = pixelsOf(entry.source);
  canvas.width = entry.source.naturalWidth;
  canvas.height = entry.source.naturalHeight;
  canvas.getContext("2d").drawImage(entry.image, 0, 0);
  document.getElementById("viewer-title").textContent = entry.picture.title;
  document.getElementById("viewer-facts").textContent = entry.facts;
  document.getElementById("viewer-legend").replaceChildren(legendOf(entry.picture) || "");
  fit();
}
function step(by) {
  const at = shown.indexOf(current);
  openViewer(shown[(at + by + shown.length) % shown.length]);
}
const middle = () => [stage.clientWidth / 2, stage.clientHeight / 2];
const actions = {
  previous: () => step(-1), next: () => step(1), fit, close: () => viewer.close(),
  in: () => zoomAbout(...middle(), 1.5), out: () => zoomAbout(...middle(), 1 / 1.5),
  one: () => zoomAbout(...middle(), 1 / view.scale),
};
for (const button of viewer.querySelectorAll("button"))
  button.addEventListener("click", () => actions[button.dataset.do]());
viewer.addEventListener("keydown", (e) => {
  const name = {ArrowLeft: "previous", ArrowRight: "next", "+": "in", "=": "in", "-": "out", 0: "fit", 1: "one"}[e.key];
  if (name) { actions[name](); e.preventDefault(); }
  e.stopPropagation();
});
stage.addEventListener("wheel", (e) => {
  e.preventDefault();
  const box = stage.getBoundingClientRect();
  zoomAbout(e.clientX - box.left, e.clientY - box.top, Math.pow(1.0015, -e.deltaY));
}, {passive: false});
let drag = null;
stage.addEventListener("pointerdown", (e) => { drag = {x: e.clientX - view.x, y: e.clientY - view.y}; stage.setPointerCapture(e.pointerId); });
stage.addEventListener("pointerup", () => { drag = null; });
stage.addEventListener("pointermove", (e) => {
  if (drag) { view.x = e.clientX - drag.x; view.y = e.clientY - drag.y; place(); }
  const box = stage.getBoundingClientRect();
  readPixel(Math.floor((e.clientX - box.left - view.x) / view.scale), Math.floor((e.clientY - box.top - view.y) / view.scale));
});
function readPixel(x, y) {
  if (x < 0 || y < 0 || x >= canvas.width || y >= canvas.height) return;
  const at = (y * canvas.width + x) * 4, rgb = [...pixels.data.data.slice(at, at + 3)];
  const swatch = make("i", {style: `background:rgb(${canvas.getContext("2d").getImageData(x, y, 1, 1).data.slice(0, 3).join(",")})`});
  readout.replaceChildren(swatch, x + ", " + y + ": " + valueText(current.picture, rgb));
}
