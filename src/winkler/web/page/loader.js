// Loads what draws pictures as soon as the page is there, while the first ones are computed.
export default {
  template: "<span hidden></span>",
  mounted() {
    for (const name of ["nicegui-plotly", "winkler-redraw"]) import(name).catch(() => {}); // a picture says so
  },
};

