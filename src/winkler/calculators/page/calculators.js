// Twelve calculators: sliders, numbers, one curve, and the study of what is shown.  All laws are in the kernels; here
// numbers only change their units and are drawn.
import { Chart } from "./chart.js";
import { shown } from "./reading.js";

const STEPS = 1000;
const POINTS = 161;
const DIGITS = 4; // of a number that a slider sets
const PRETTY = { um: "µm", ohm: "Ω", mohm: "mΩ", nohm: "nΩ", uJ: "µJ" };

export const unitText = (unit) =>
  unit.replace(/[a-zA-Z]+/g, (word) => PRETTY[word] ?? word).replace(/\^2/g, "²").replace(/\^3/g, "³");

// The kernels: numbers of the sliders in SI units to the numbers of the answer.
export async function kernelsOf(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const { memory, given, found, _initialize, ...own } = instance.exports;
  _initialize?.();
  const [taken, answer] = [given(), found()];
  return (name, numbers, count) => {
    new Float64Array(memory.buffer, taken, numbers.length).set(numbers);
    own[name]();
    return Array.from(new Float64Array(memory.buffer, answer, count));
  };
}

export function fromBase64(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

const rounded = (number) => Number(number.toPrecision(DIGITS));

export function valueAt(slider, part) {
  const { low, high, ratio } = slider;
  if (part <= 0) return low;
  if (part >= 1) return high;
  return ratio ? rounded(low * (high / low) ** part) : rounded(low + (high - low) * part);
}

export function partOf(slider, value) {
  const { low, high, ratio } = slider;
  return ratio ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
}

export function read(text) {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
}

export function answerOf(run, one, values) {
  return run(one.name, values.map((value, k) => value * one.sliders[k].factor), one.numbers.length);
}

// The text of the study file, every number to its last digit.
export function studyOf(one, values, answer) {
  const quantity = (number, unit) => (unit ? `"${number} ${unit}"` : String(number));
  let body = one.study;
  one.sliders.forEach(({ name, unit }, k) => (body = body.replaceAll(`{${name}}`, quantity(values[k], unit))));
  one.numbers.forEach(({ name, base }, k) => (body = body.replaceAll(`{=${name}}`, quantity(answer[k], base))));
  return `title = "${one.title}"\n\n[problem]\nkind = "${one.kind}"\n${body}`;
}

export async function codeOf(text) {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function made(tag, attributes = {}, ...inside) {
  const one = document.createElement(tag);
  for (const key in attributes) one.setAttribute(key, attributes[key]);
  one.append(...inside);
  return one;
}

// A symbol with its index.
function symbolOf(symbol) {
  const one = made("i", {}, " ");
  symbol.split(/_(\w+|∞)/).forEach((part, k) => part && one.append(k % 2 ? made("sub", {}, part) : part));
  return one;
}

const plainOf = (symbol) => symbol.replaceAll("_", "");

// One calculator in an element of the page, its holder.  `changed(values, answer, study)` hears of every change.
export class Panel {
  constructor(holder, one, run, changed, start = {}) {
    [this.one, this.run, this.changed] = [one, run, changed];
    this.values = one.sliders.map((slider) => this.within(slider, start[slider.name]) ?? slider.start);
    this.across = Math.max(0, one.sliders.findIndex(({ name }) => name === (start.across ?? one.across)));
    this.up = Math.max(0, one.numbers.findIndex(({ name }) => name === (start.up ?? one.up)));
    this.fields = one.sliders.map((slider, k) => this.field(slider, k));
    this.head = made("div", { class: "head" });
    this.table = made("dl", { class: "numbers" });
    this.cells = one.numbers.map(({ words, symbol, unit, name }) => {
      const cell = made("dd", { "data-number": name });
      this.table.append(made("div", {}, made("dt", {}, words, symbolOf(symbol)), cell));
      return { cell, unit: unitText(unit) };
    });
    const picks = made("p", { class: "picks" }, "Curve of ", this.pick("up", one.numbers), " over ", this.pick("across", one.sliders));
    const picture = made("div", { class: "picture" });
    const sliders = made("form", { class: "sliders", "aria-label": "What is given" }, ...this.fields.map(({ row }) => row));
    sliders.addEventListener("submit", (event) => event.preventDefault());
    const found = made("div", { class: "found" }, this.head, picks, picture, this.table, made("p", { class: "valid" }, one.valid));
    holder.replaceChildren(sliders, found);
    this.chart = new Chart(picture);
    this.update();
  }

  within(slider, value) {
    return Number.isFinite(value) && value >= slider.low && value <= slider.high ? value : undefined;
  }

  field(slider, k) {
    const { name, words, symbol, low, high } = slider;
    const unit = unitText(slider.unit);
    const label = made("label", { for: `slider-${name}` }, words, symbolOf(symbol));
    const range = made("input", { type: "range", id: `slider-${name}`, min: 0, max: STEPS, "data-slider": name });
    const text = made("input", { type: "text", inputmode: "decimal", "data-field": name, "aria-label": `${words}${unit && ` in ${unit}`}` });
    const wrong = made("span", { class: "wrong", role: "alert" });
    range.addEventListener("input", () => this.set(k, valueAt(slider, range.value / STEPS), text));
    text.addEventListener("input", () => {
      const value = this.within(slider, read(text.value));
      text.setAttribute("aria-invalid", String(value === undefined));
      wrong.textContent = value === undefined ? `Give a number from ${shown(low)} to ${shown(high)}${unit && ` ${unit}`}.` : "";
      if (value !== undefined) this.set(k, value, range);
    });
    text.addEventListener("change", () => this.showValue(k));
    const row = made("div", { class: "row" }, label, made("span", { class: "typed" }, text, made("span", { class: "unit" }, unit)), range, wrong);
    return { row, range, text, wrong, unit };
  }

  pick(which, choices) {
    const select = made("select", { "data-pick": which, "aria-label": which === "up" ? "What the curve shows" : "Over what it is drawn" });
    choices.forEach(({ words }, k) => select.append(made("option", { value: k }, words)));
    select.value = this[which];
    select.addEventListener("change", () => {
      this[which] = Number(select.value);
      this.later();
    });
    return select;
  }

  set(k, value) {
    this.values[k] = value;
    this.later(k);
  }

  // All changes before the next frame are shown in it.
  later(k) {
    if (k !== undefined) this.showValue(k, true);
    this.requested ??= requestAnimationFrame(() => {
      this.requested = undefined;
      this.update();
    });
  }

  showValue(k, typing = false) {
    const { range, text, wrong, unit } = this.fields[k];
    const part = partOf(this.one.sliders[k], this.values[k]);
    if (document.activeElement !== range) range.value = Math.round(part * STEPS);
    range.setAttribute("aria-valuetext", `${shown(this.values[k])} ${unit}`.trim());
    if (typing && document.activeElement === text) return;
    text.value = String(this.values[k]);
    text.setAttribute("aria-invalid", "false");
    wrong.textContent = "";
  }

  update() {
    const { one, values } = this;
    this.answer = answerOf(this.run, one, values);
    this.fields.forEach((_, k) => this.showValue(k, true));
    one.numbers.forEach(({ factor }, k) => {
      const { cell, unit } = this.cells[k];
      cell.textContent = `${shown(this.answer[k] / factor)}${unit && ` ${unit}`}`;
      cell.dataset.value = String(this.answer[k]); // in SI units, to the last digit
    });
    const [first] = one.numbers;
    const known = this.answer.every(Number.isFinite);
    this.head.replaceChildren(
      made("span", { class: "asked" }, first.words),
      made("output", { class: "value" }, this.cells[0].cell.textContent),
      known ? "" : made("p", { class: "wrong", role: "alert" }, "Beyond what was computed beforehand: open it in the app."),
    );
    this.draw();
    this.changed?.(values, this.answer, this.study);
  }

  get study() {
    return studyOf(this.one, this.values, this.answer);
  }

  draw() {
    const { one, values, across, up } = this;
    const [slider, number] = [one.sliders[across], one.numbers[up]];
    const [xs, ys] = [[], []];
    for (let k = 0; k < POINTS; k += 1) {
      const part = k / (POINTS - 1);
      const x = slider.ratio ? slider.low * (slider.high / slider.low) ** part : slider.low + (slider.high - slider.low) * part;
      const others = values.map((value, place) => (place === across ? x : value));
      xs.push(x);
      ys.push(answerOf(this.run, one, others)[up] / number.factor);
    }
    this.chart.draw(
      { title: slider.words, symbol: plainOf(slider.symbol), unit: unitText(slider.unit), log: slider.ratio },
      { title: number.words, symbol: plainOf(number.symbol) || number.words, unit: unitText(number.unit) },
      xs, ys, [values[across], this.answer[up] / number.factor],
    );
  }
}
