// A curve with labelled axes as a picture in SVG, drawn anew for every frame of a moving slider.
import { element, placed, readOff, shown } from "./reading.js";

const [NARROWEST, WIDEST] = [280, 760]; // px, which are the units of the picture
const [LEFT, TOP, RIGHT, BELOW] = [84, 16, 14, 58];
const SIZE = 15;

function nice(low, high, wanted) {
  const raw = (high - low) / wanted;
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = unit * ([1, 2, 5, 10].find((part) => part * unit >= raw * 0.999) ?? 10);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) ticks.push(k * step);
  return ticks;
}

function decades(low, high, most = 6) {
  const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
  const parts = last - first < 2 ? [1, 2, 5] : [1];
  const every = Math.max(1, Math.ceil((last - first) / most));
  const ticks = [];
  for (let power = first - 1; power <= last; power += 1)
    for (const part of parts) {
      const at = part * 10 ** power;
      if (at >= low * (1 - 1e-9) && at <= high * (1 + 1e-9) && (part > 1 || (power - first) % every === 0)) ticks.push(at);
    }
  return ticks;
}

export class Chart {
  constructor(holder) {
    this.svg = element("svg", { role: "img", class: "chart" });
    this.spoken = document.createElement("p");
    this.spoken.className = "spoken";
    this.spoken.setAttribute("aria-live", "polite");
    this.under = element("g", { class: "axes" });
    this.line = element("path", { class: "curve" });
    this.dot = element("circle", { class: "now", r: 6 });
    this.svg.append(this.under, this.line, this.dot);
    holder.append(this.svg, this.spoken);
    this.panel = { size: SIZE, curves: [] };
    this.holder = holder;
    this.resize();
    this.reading = readOff(this.svg, () => [this.panel], this.spoken);
    this.sized = new ResizeObserver(() => this.resize() && this.last && this.draw(...this.last));
    this.sized.observe(holder);
  }

  resize() {
    const width = Math.round(Math.max(NARROWEST, Math.min(this.holder.clientWidth || WIDEST, WIDEST)));
    if (width === this.width) return false;
    this.width = width;
    const height = Math.round(0.3 * width + 190);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.panel.box = [LEFT, TOP, width - RIGHT, height - BELOW];
    return true;
  }

  // x, y: {title, symbol, unit, log}; at: the present state
  draw(x, y, xs, ys, at) {
    this.last = [x, y, xs, ys, at];
    const known = ys.filter(Number.isFinite);
    if (!known.length) return;
    let [low, high] = [Math.min(...known), Math.max(...known)];
    const log = x.log && low > 0 && high / low > 30;
    if (!log) {
      if (low > 0 && low < 0.4 * high) low = 0;
      if (high < 0 && high > 0.4 * low) high = 0;
      if (high - low < 1e-9 * Math.max(Math.abs(low), Math.abs(high))) [low, high] = [low - Math.abs(low) / 2, high + Math.abs(high) / 2];
      if (high === low) high = low + 1;
      const ticks = nice(low, high, 5);
      const step = ticks[1] - ticks[0];
      [low, high] = [step * Math.floor(low / step + 1e-9), step * Math.ceil(high / step - 1e-9)];
    }
    const panel = this.panel;
    panel.x = { title: x.symbol, unit: x.unit, low: xs[0], high: xs[xs.length - 1], log: x.log };
    panel.y = { title: y.symbol, unit: y.unit, low, high, log };
    panel.curves = [{ name: "", x: xs, y: ys }];
    let path = "";
    xs.forEach((one, k) => {
      if (!Number.isFinite(ys[k])) return;
      const [left, top] = placed(panel, one, ys[k]);
      path += `${path ? "L" : "M"}${left.toFixed(2)} ${top.toFixed(2)}`;
    });
    this.line.setAttribute("d", path);
    const [left, top] = placed(panel, ...at);
    this.dot.setAttribute("visibility", Number.isFinite(top) ? "visible" : "hidden");
    if (Number.isFinite(top)) [["cx", left], ["cy", top]].forEach(([key, value]) => this.dot.setAttribute(key, value));
    this.axes(panel, x, y);
    this.svg.setAttribute("aria-label", `${y.title} over ${x.title}; arrow keys read it off`);
    this.reading.refresh();
  }

  axes(panel, x, y) {
    const [l, t, r, b] = panel.box;
    const across = panel.x.log ? decades(panel.x.low, panel.x.high) : nice(panel.x.low, panel.x.high, this.width < 450 ? 4 : 6);
    const up = panel.y.log ? decades(panel.y.low, panel.y.high) : nice(panel.y.low, panel.y.high, 5);
    const { low, high } = panel.y;
    const key = JSON.stringify([across, up, x.title, y.title, panel.x, low, high, panel.box]);
    if (key === this.key) return;
    this.key = key;
    const parts = [];
    for (const tick of across) {
      const [at] = placed(panel, tick, panel.y.high);
      parts.push(element("path", { d: `M${at} ${t}V${b}`, class: "grid" }));
      parts.push(element("text", { x: at, y: b + 21, "text-anchor": "middle" }, shown(tick, 3)));
    }
    for (const tick of up) {
      const [, at] = placed(panel, panel.x.high, tick);
      parts.push(element("path", { d: `M${l} ${at}H${r}`, class: "grid" }));
      parts.push(element("text", { x: l - 8, y: at + 5, "text-anchor": "end" }, shown(tick, 3)));
    }
    const named = (axis) => `${axis.title}${axis.unit ? ` [${axis.unit}]` : ""}`;
    parts.push(element("path", { d: `M${l} ${t}V${b}H${r}`, class: "frame" }));
    parts.push(element("text", { x: (l + r) / 2, y: b + 48, "text-anchor": "middle" }, named(x)));
    const turned = { transform: `translate(18 ${(t + b) / 2}) rotate(-90)`, "text-anchor": "middle" };
    parts.push(element("text", turned, named(y)));
    this.under.replaceChildren(...parts);
  }
}
