// One interactive picture.  Numbers come as text and stay plain objects: plotly reads them many times, and every
// look through the watched objects of the page would take longer than drawing.
const PINNED = { color: "#6b5b00", width: 2, dash: "2px,3px" };
const PAUSE = 120; // the longest that pictures outside the window wait for another frame, after the last change [ms]
const MOUSE = "(hover: hover) and (pointer: fine)";

const plain = (html) => (html ?? "").replace(/<sub>/g, "_").replace(/<[^>]*>/g, "");
const later = window.requestIdleCallback ?? ((call) => setTimeout(call, 0.5 * PAUSE));
const notLater = window.cancelIdleCallback ?? clearTimeout;
const cell = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

export default {
  template: "<div></div>",
  props: { first: String, pinned: String },
  async mounted() {
    const [{ Plotly }, redraw] = await Promise.all([import("nicegui-plotly"), import("winkler-redraw")]);
    if (!this.$el?.isConnected) return;
    this.Plotly = Plotly;
    this.fast = redraw;
    this.newest ??= this.first;
    this.under ??= this.pinned ? JSON.parse(this.pinned) : null;
    this.redraw();
    this.width = this.$el.clientWidth;
    this.sized = new ResizeObserver(() => {
      if (!this.$el.clientWidth || this.$el.clientWidth === this.width) return;
      this.width = this.$el.clientWidth;
      Plotly.Plots.resize(this.$el).catch(() => {}); // it may have been taken away by the time
    });
    this.sized.observe(this.$el);
    this.sight = new IntersectionObserver((entries) => {
      this.unseen = !entries.at(-1).isIntersecting;
      if (!this.unseen && this.later) this.redraw();
    });
    this.sight.observe(this.$el);
  },
  beforeUnmount() {
    this.sized?.disconnect();
    this.sight?.disconnect();
    notLater(this.later);
    this.Plotly?.purge(this.$el);
  },
  methods: {
    // All pictures that come before the next frame are drawn in it, so that the page is laid out once; those outside
    // the window behind it, or when nothing else is to be done if they need another frame: those in sight follow the slider.
    draw(text) {
      this.newest = text;
      this.request();
    },
    request() {
      notLater(this.later);
      this.later = undefined;
      this.requested ??= requestAnimationFrame(() => (this.unseen ? setTimeout(() => this.redraw(true)) : this.redraw()));
    },
    // Draw the curves of a pinned answer below all that come; an empty text takes them away.
    pin(text) {
      this.under = text ? JSON.parse(text) : null;
      this.request();
    },
    redraw(patient = false) {
      notLater(this.later);
      this.requested = this.later = undefined;
      if (!this.Plotly || !this.$el?.isConnected) return;
      const { data, layout, config } = JSON.parse(this.newest);
      const under = this.under ? this.curvesBelow(layout) : [];
      if (matchMedia(MOUSE).matches) this.zoom(layout, config); // a finger scrolls the page
      const figure = { data: [...data, ...under], layout };
      if (this.moves(figure)) return;
      if (patient) {
        this.later = later(() => this.redraw(), { timeout: PAUSE });
        return;
      }
      this.fast.remember(this.$el, figure);
      this.Plotly.react(this.$el, figure.data, layout, config);
      if (this.watched) return;
      this.watched = true;
      this.$el.on("plotly_relayout", (change) => this.note(change));
      this.$el.on("plotly_click", ({ points }) => {
        const one = points.find(({ customdata }) => Number.isFinite(customdata));
        if (one) this.$emit("chosen", one.customdata);
      });
      this.$el.on("plotly_doubleclick", () => {
        this.zoomed = {};
        this.fast.forget(this.$el);
        this.redraw();
      });
    },
    // Whether the figure that is there could take the new data.
    moves(figure) {
      try {
        return this.fast.redrawn(this.$el, figure);
      } catch (error) {
        console.debug(error);
        return false;
      }
    },
    // What the mouse has zoomed to stays when new numbers come, as long as the axis has the same title and unit.
    zoom(layout, config) {
      layout.dragmode = "zoom";
      config.doubleClick = false;
      this.titles = {};
      for (const name in layout) {
        if (!/^[xy]axis/.test(name)) continue;
        const axis = layout[name];
        axis.fixedrange = false;
        this.titles[name] = axis.title?.text;
        const kept = this.zoomed?.[name];
        if (kept?.title === axis.title?.text) Object.assign(axis, { range: [...kept.range], autorange: false });
      }
    },
    note(change) {
      for (const name in this.titles ?? {}) {
        const range = change[`${name}.range`] ?? [change[`${name}.range[0]`], change[`${name}.range[1]`]];
        if (range[0] !== undefined) (this.zoomed ??= {})[name] = { title: this.titles[name], range };
      }
    },
    // The curves of the pinned answer, in the units of this one; axes reach over both.
    curvesBelow(layout) {
      const { data, layout: before } = this.under;
      const factor = (axis) => (before.meta?.[axis] ?? 1) / (layout.meta?.[axis] ?? 1);
      for (const name in layout) {
        if (!/^[xy]axis/.test(name) || !layout[name].range || !before[name]?.range) continue;
        const by = factor(name.replace("axis", ""));
        const old = before[name].range.map((end) => (layout[name].type === "log" ? end + Math.log10(by) : end * by));
        const [low, high] = layout[name].range;
        layout[name].range = low <= high
          ? [Math.min(low, ...old), Math.max(high, ...old)]
          : [Math.max(low, ...old), Math.min(high, ...old)];
      }
      return data
        .filter(({ type, mode, hoverinfo, x }) => type === "scatter" && mode?.includes("lines") && hoverinfo !== "skip" && x.length > 1)
        .map((curve) => {
          const [across, upright] = [factor("x"), factor(curve.yaxis ?? "y")];
          const scaled = (numbers, by) => numbers.map((one) => (one === null ? null : one * by));
          return {
            type: "scatter",
            mode: "lines",
            x: scaled(curve.x, across),
            y: scaled(curve.y, upright),
            yaxis: curve.yaxis,
            line: PINNED,
            hovertemplate: layout.meta?.hover?.[curve.yaxis ?? "y"]?.replace("<extra></extra>", "<extra>A</extra>"),
            showlegend: false,
          };
        });
    },
    // Save this picture: an image, or the numbers of its curves in the units of its axes.
    async save(format, name) {
      if (this.later) this.redraw();
      const { data, layout } = JSON.parse(this.newest);
      if (format === "csv") return this.give(this.table(data, layout), "text/csv", `${name}.csv`);
      const { clientWidth: width, clientHeight: height } = this.$el;
      const image = await this.Plotly.toImage(this.$el, { format: "svg", width, height });
      const svg = decodeURIComponent(image.slice(image.indexOf(",") + 1));
      if (format === "svg") return this.give(svg, "image/svg+xml", `${name}.svg`);
      const picture = new Image();
      picture.src = image;
      await picture.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [3 * width, 3 * height];
      const pen = canvas.getContext("2d");
      pen.scale(3, 3);
      pen.drawImage(picture, 0, 0, width, height);
      canvas.toBlob((blob) => this.give(blob, "image/png", `${name}.png`), "image/png");
    },
    table(data, layout) {
      const title = (axis) => plain(layout[axis.replace(/^([xy])/, "$1axis")]?.title?.text);
      const rows = [];
      for (const { name, x, y, z, yaxis, hoverinfo } of data) {
        if (hoverinfo === "skip" || !x || !y) continue;
        const heads = ["curve", title("x"), title(yaxis ?? "y"), ...(z ? ["value"] : [])].map(cell).join(",");
        if (rows[0] !== heads && !rows.includes(heads)) rows.push(heads);
        const called = cell(plain(name));
        if (z) z.forEach((row, j) => row.forEach((one, i) => rows.push([called, x[i], y[j], one].join(","))));
        else x.forEach((one, i) => rows.push([called, one, y[i]].join(",")));
      }
      return rows.join("\n") + "\n";
    },
    give(content, type, name) {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    },
  },
};
