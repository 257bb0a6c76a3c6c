// One interactive picture.  Numbers come as text and stay plain objects: plotly reads them many times, and every
// look through the watched objects of the page would take longer than drawing.
export default {
  template: "<div></div>",
  props: { first: String },
  async mounted() {
    const { Plotly } = await import("nicegui-plotly");
    if (!this.$el?.isConnected) return;
    this.Plotly = Plotly;
    this.newest ??= this.first;
    this.redraw();
    this.width = this.$el.clientWidth;
    this.sized = new ResizeObserver(() => {
      if (!this.$el.clientWidth || this.$el.clientWidth === this.width) return;
      this.width = this.$el.clientWidth;
      Plotly.Plots.resize(this.$el).catch(() => {}); // it may have been taken away by the time
    });
    this.sized.observe(this.$el);
  },
  beforeUnmount() {
    this.sized?.disconnect();
    this.Plotly?.purge(this.$el);
  },
  methods: {
    // All pictures that come before the next frame are drawn in it, so that the page is laid out once.
    draw(text) {
      this.newest = text;
      this.requested ??= requestAnimationFrame(() => this.redraw());
    },
    redraw() {
      this.requested = undefined;
      if (!this.Plotly || !this.$el?.isConnected) return;
      const { data, layout, config } = JSON.parse(this.newest);
      this.Plotly.react(this.$el, data, layout, config);
    },
  },
};
