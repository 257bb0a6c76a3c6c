// Curves that can be read off: at the mouse, at a finger, or by the arrow keys.  A panel is a part of a picture with two
// axes: {box: [left, top, right, bottom], x: {low, high, log, title, unit}, y: {...}, curves: [{name, x: [], y: []}]}.
// `box` is in the coordinates of the picture's viewBox; `panels` is asked anew every time, since curves may change.
const NAMESPACE = "http://www.w3.org/2000/svg";
const POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

export function shown(number, digits = 5) {
  if (!Number.isFinite(number)) return "–";
  if (number === 0) return "0";
  const [mantissa, power] = number.toExponential(digits - 1).split("e").map(Number);
  if (power >= -3 && power < 6) return String(Number(number.toPrecision(digits))).replace("-", "−");
  const raised = String(Math.abs(power)).replace(/\d/g, (digit) => POWERS[digit]);
  const times = mantissa === 1 ? "" : `${String(mantissa).replace("-", "−")}\u00a0×\u00a0`;
  return `${times}10${power < 0 ? "⁻" : ""}${raised}`;
}

export function element(name, attributes = {}, text = "") {
  const made = document.createElementNS(NAMESPACE, name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text) made.textContent = text;
  return made;
}

const along = (axis, at) => {
  const [low, high, one] = axis.log ? [axis.low, axis.high, at].map(Math.log) : [axis.low, axis.high, at];
  return (one - low) / (high - low);
};

export function placed(panel, x, y) {
  const [left, top, right, bottom] = panel.box;
  return [left + along(panel.x, x) * (right - left), bottom - along(panel.y, y) * (bottom - top)];
}

const said = (axis, number) => `${axis.title ? `${axis.title} ` : ""}${shown(number)}${axis.unit ? ` ${axis.unit}` : ""}`;

// Let a picture be read off; `spoken` is an element that screen readers follow.  Returns what hides the reading.
export function readOff(svg, panels, spoken) {
  let held = null; // [panel, curve, index]
  const layer = element("g", { class: "reading", "aria-hidden": "true" });
  svg.append(layer);
  svg.setAttribute("tabindex", "0");

  const inside = (panel, index, curve) => {
    const [x, y] = [panel.curves[curve].x[index], panel.curves[curve].y[index]];
    if (!Number.isFinite(x) || !Number.isFinite(y)) return null;
    const at = placed(panel, x, y);
    const [left, top, right, bottom] = panel.box;
    const slack = 0.01 * (right - left);
    if (!at.every(Number.isFinite)) return null;
    return at[0] >= left - slack && at[0] <= right + slack && at[1] >= top - slack && at[1] <= bottom + slack ? at : null;
  };
  const show = () => {
    layer.replaceChildren();
    if (svg.lastChild !== layer) svg.append(layer);
    if (!held) return;
    const panel = panels()[held[0]];
    const at = panel?.curves[held[1]] && inside(panel, held[2], held[1]);
    if (!at) return;
    const [left, top, right, bottom] = panel.box;
    const curve = panel.curves[held[1]];
    const size = panel.size ?? 12;
    layer.append(element("path", { d: `M${at[0]} ${top}V${bottom}M${left} ${at[1]}H${right}`, class: "cross" }));
    layer.append(element("circle", { cx: at[0], cy: at[1], r: size / 3, class: "at" }));
    const lines = [curve.name, said(panel.x, curve.x[held[2]]), said(panel.y, curve.y[held[2]])].filter(Boolean);
    const box = element("g", { class: "said", "font-size": size });
    const texts = lines.map((line, k) => element("text", { x: 0, y: (k + 1) * 1.35 * size }, line));
    const back = element("rect", { class: "back", rx: size / 4 });
    box.append(back, ...texts);
    layer.append(box);
    const width = Math.max(...texts.map((text) => text.getComputedTextLength()));
    const tall = 1.35 * size * lines.length;
    for (const [key, value] of Object.entries({ x: -size / 2, y: 0, width: width + size, height: tall + 0.6 * size }))
      back.setAttribute(key, value);
    const space = svg.viewBox.baseVal;
    const over = Math.max(space.x + size, Math.min(at[0] + size, space.x + space.width - width - size));
    const above = at[1] - tall - 1.8 * size > space.y ? at[1] - tall - 1.4 * size : at[1] + size;
    box.setAttribute("transform", `translate(${over} ${above})`);
    if (spoken) spoken.textContent = lines.join(", ");
  };
  const near = (event) => {
    const matrix = svg.getScreenCTM();
    if (!matrix) return;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    let best = Infinity;
    held = null;
    panels().forEach((panel, which) => {
      const [left, top, right, bottom] = panel.box;
      if (x < left || x > right || y < top || y > bottom) return;
      panel.curves.forEach((curve, row) => {
        for (let index = 0; index < curve.x.length; index += 1) {
          const at = inside(panel, index, row);
          const distance = at ? Math.hypot(at[0] - x, 0.5 * (at[1] - y)) : Infinity;
          if (distance < best) [best, held] = [distance, [which, row, index]];
        }
      });
    });
    show();
  };
  const hide = () => {
    held = null;
    show();
  };
  const all = () => panels().flatMap((panel, which) => panel.curves.map((_, row) => [which, row]));
  svg.addEventListener("pointermove", near);
  svg.addEventListener("pointerdown", near);
  svg.addEventListener("pointerleave", (event) => event.pointerType === "mouse" && hide());
  svg.addEventListener("blur", hide);
  svg.addEventListener("keydown", (event) => {
    const rows = all();
    const steps = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: "next", ArrowDown: "last", Home: "first", End: "end" };
    if (event.key === "Escape") return hide();
    if (!(event.key in steps) || event.ctrlKey || event.metaKey || event.altKey || !rows.length) return;
    event.preventDefault();
    const curve = ([which, row]) => panels()[which].curves[row].x.length;
    const step = steps[event.key];
    const begins = !held;
    held ??= [...rows[0], Math.floor(curve(rows[0]) / 2)];
    if (begins && step !== "first" && step !== "end") return show();
    if (step === "next" || step === "last") {
      const here = rows.findIndex(([which, row]) => which === held[0] && row === held[1]);
      const next = rows[(here + (step === "next" ? 1 : rows.length - 1)) % rows.length];
      held = [...next, Math.min(held[2], curve(next) - 1)];
    } else {
      const most = curve(held) - 1;
      const index = step === "first" ? 0 : step === "end" ? most : held[2] + step * (event.shiftKey ? 10 : 1);
      held = [held[0], held[1], Math.max(0, Math.min(index, most))];
    }
    show();
  });
  return { hide, refresh: show };
}
