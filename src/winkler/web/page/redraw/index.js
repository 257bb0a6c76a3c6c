// New data for a figure that plotly.js has drawn, without a new layout: curves, areas, points and contours are drawn by
// its own modules, notes and lines across are moved, and axes keep their ends as long as the new curves fit in.
// A whole drawing measures texts and draws axes, which takes ten times as long.
const ARRAYS = ["x", "y", "z", "customdata"];
const PLACES = ["x", "y", "ax", "ay", "x0", "x1", "y0", "y1"];
const LEAST_FILLED = 0.6; // of the length of an axis, below which it gets new ends
const ROOM = 0.15; // beyond the curves, of an axis that has become a little too short
const A_LITTLE = 1.5;
const TINY = 2e-3; // of its length

const isAxis = (name) => /^[xy]axis/.test(name);
const without = (one, names) => Object.fromEntries(Object.entries(one).filter(([name]) => !names.includes(name)));

// What has to stay the same, and cannot be moved.
function frameOf({ data, layout }) {
  const axes = Object.keys(layout).filter(isAxis);
  return JSON.stringify([
    data.map((curve) => without(curve, ARRAYS)),
    without(layout, ["annotations", "shapes", ...axes]),
    axes.map((name) => without(layout[name], ["range", "rangemode", "autorange"])),
    (layout.annotations ?? []).map((note) => ({ ...without(note, PLACES), text: shapeOf(note.text) })),
    (layout.shapes ?? []).map((line) => without(line, PLACES)),
  ]);
}

// A text without its numbers; its lines are exchanged where they have no other marks.
function shapeOf(text) {
  const lines = (text ?? "").split("<br>");
  return lines.some((line) => /[<&]/.test(line)) ? text : lines.length;
}

function extent(data, name) {
  const across = name[0];
  let [low, high] = [Infinity, -Infinity];
  for (const curve of data) {
    if ((curve[`${across}axis`] ?? across).replace(across, `${across}axis`) !== name) continue;
    for (const one of curve[across] ?? []) {
      if (one === null) continue;
      if (one < low) low = one;
      if (one > high) high = one;
    }
  }
  return [low, high];
}

const inside = ([low, high], [a, b]) => {
  const slack = TINY * Math.abs(b - a);
  return Math.min(low, high) >= Math.min(a, b) - slack && Math.max(low, high) <= Math.max(a, b) + slack;
};
const filled = ([low, high], [a, b]) => Math.abs(high - low) >= LEAST_FILLED * Math.abs(b - a);

// Give the axes of a new figure the ends of those that are drawn; of one that has become too short, ends with some room.
// Returns whether all ends are the drawn ones.
function keepEnds(drawn, { data, layout }) {
  let same = true;
  for (const name of Object.keys(layout).filter(isAxis)) {
    const [axis, before] = [layout[name], drawn.layout[name]];
    const [now, full] = [extent(data, name), drawn._fullLayout[name].range];
    const equal = layout.yaxis?.scaleanchor !== undefined;
    const wanted = axis.range ?? now;
    const ends = [...full];
    const fits = axis.range && equal ? inside(wanted, full) && inside(full, wanted) : inside(wanted, full) && filled(wanted, full);
    if (fits || (!axis.range && equal && String(now) === String(extent(drawn.data, name)))) {
      if (axis.range || before.range) [axis.range, axis.autorange] = [ends, false];
      continue;
    }
    same = false;
    const grown = axis.range ?? (axis.rangemode === "tozero" && now[0] >= 0 ? [0, now[1]] : null);
    const length = grown && Math.abs(grown[1] - grown[0]);
    const little = length < A_LITTLE * Math.abs(full[1] - full[0]);
    if (equal || !grown || !little || axis.type === "log" || inside(wanted, full)) continue;
    const room = ROOM * length;
    axis.range = grown.map((end, side) => (end === 0 ? 0 : end + (side === grown.indexOf(Math.max(...grown)) ? room : -room)));
    axis.autorange = false;
  }
  return same;
}

function moveBy(node, dx, dy) {
  const [x, y] = (node.dataset.moved ?? "0,0").split(",").map(Number);
  node.dataset.moved = `${x + dx},${y + dy}`;
  node.setAttribute("transform", `translate(${x + dx},${y + dy})`);
}

// Pixels between two places along an axis, or in the frame of the picture.
function pixels(plot, ref, from, to) {
  const axis = plot._fullLayout[(ref ?? "").split(" ")[0].replace(/^([xy])/, "$1axis")];
  if (to === from || from === undefined) return 0;
  if (/domain|paper/.test(ref)) return (ref[0] === "x" ? 1 : -1) * axis._length * (to - from);
  return axis.r2p(to) - axis.r2p(from);
}

function moveNote(plot, node, before, after) {
  const [dx, dy] = [pixels(plot, after.xref, before.x, after.x), pixels(plot, after.yref, before.y, after.y)];
  if (!after.showarrow) {
    if (dx || dy) moveBy(node, dx, dy);
  } else {
    const [tx, ty] = [pixels(plot, after.axref, before.ax, after.ax), pixels(plot, after.ayref, before.ay, after.ay)];
    const [line, ...heads] = node.querySelectorAll(".annotation-arrow-g path");
    const [ax, ay, x, y] = line.getAttribute("d").match(/-?[\d.]+(?:e-?\d+)?/g).map(Number);
    if (Math.sign(x + dx - ax - tx) !== Math.sign(x - ax) || Math.sign(y + dy - ay - ty) !== Math.sign(y - ay)) return false;
    if ((x !== ax && y !== ay) && (dx !== tx || dy !== ty)) return false; // its heads turn
    line.setAttribute("d", `M${ax + tx},${ay + ty}L${x + dx},${y + dy}`);
    const near = ([px, py]) => Math.hypot(px - ax, py - ay) < Math.hypot(px - x, py - y);
    for (const head of heads) {
      const place = head.getAttribute("transform").match(/translate\(([^,]+),([^)]+)\)/).slice(1).map(Number);
      const [mx, my] = near(place) ? [tx, ty] : [dx, dy];
      const moved = `translate(${place[0] + mx},${place[1] + my})`;
      head.setAttribute("transform", head.getAttribute("transform").replace(/translate\([^)]+\)/, moved));
    }
  }
  if (before.text !== after.text) {
    const text = node.querySelector("text");
    const lines = text.querySelectorAll(".line");
    after.text.split("<br>").forEach((line, place) => ((lines[place] ?? text).textContent = line));
  }
  return true;
}

function moveLine(plot, node, before, after) {
  const by = ["x", "y"].map((ref) => [0, 1].map((end) => pixels(plot, after[`${ref}ref`], before[ref + end], after[ref + end])));
  if (by.every((ends) => ends[0] === ends[1])) {
    if (by[0][0] || by[1][0]) moveBy(node, by[0][0], by[1][0]);
    return true;
  }
  return false;
}

// Remember what a figure is drawn from; to be called before, as drawing adds to it.
export function remember(plot, figure) {
  plot.frame = frameOf(figure);
}

// Let the next drawing have its own axes.
export function forget(plot) {
  plot.frame = undefined;
}

// Draw new data into a figure; returns false where it needs a whole drawing.
export function redrawn(plot, figure) {
  const { data, layout } = figure;
  if (!plot.frame || !plot._fullLayout || !plot.calcdata || plot.calcdata.length !== data.length) return false;
  const same = keepEnds(plot, figure);
  if (!same || plot.frame !== frameOf(figure)) return false;
  const parts = plot._fullLayout._basePlotModules;
  if (parts.length !== 1 || parts[0].name !== "cartesian") return false;
  const before = plot.layout;
  const notes = (layout.annotations ?? []).every((note, place) => {
    const node = plot.querySelector(`.annotation[data-index="${place}"]`);
    return node && moveNote(plot, node, before.annotations[place], note);
  });
  const lines = (layout.shapes ?? []).every((line, place) => {
    const node = plot.querySelector(`.shapelayer path[data-index="${place}"]`);
    return node && moveLine(plot, node, before.shapes[place], line);
  });
  if (!notes || !lines) return false;
  data.forEach((curve, place) => {
    const full = plot._fullData[place];
    for (const name of ARRAYS) if (name in curve) full[name] = curve[name];
    if (full.type === "scatter") full._length = Math.min(curve.x.length, curve.y.length);
    const computed = full._module.calc(plot, full);
    const first = (computed[0] ??= { x: undefined, y: undefined });
    first.t ??= {};
    first.trace = full;
    plot.calcdata[place] = computed;
  });
  parts[0].plot(plot);
  for (const { style } of plot._fullLayout._modules) style?.(plot);
  plot.querySelector(".hoverlayer")?.replaceChildren();
  plot.data = data;
  plot.layout = layout;
  return true;
}
