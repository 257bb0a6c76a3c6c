// Search among the options of a list that is open: those without the typed words are hidden, in the browser alone.
export default {
  template: `<div class="find">
    <input type="search" autocomplete="off" :placeholder="label" :aria-label="label" @input="filter" @keydown="pressed"
      @click.stop />
    <p v-show="none" role="status">Nothing has these words.</p>
  </div>`,
  props: { label: String },
  data: () => ({ none: false }),
  mounted() {
    this.input = this.$el.querySelector("input");
    if (matchMedia("(hover: hover)").matches) setTimeout(() => this.input?.focus(), 0); // no keyboard over a phone's list
  },
  methods: {
    items() {
      return [...this.$el.parentElement.querySelectorAll(".q-item")];
    },
    shown() {
      return this.items().filter((item) => item.style.display !== "none");
    },
    filter() {
      const words = this.input.value.toLowerCase().split(/\s+/);
      for (const item of this.items()) {
        const text = item.textContent.toLowerCase();
        item.style.display = words.every((word) => text.includes(word)) ? "" : "none";
      }
      this.none = this.shown().length === 0;
      this.mark(this.input.value ? 0 : -1);
    },
    mark(place) {
      const shown = this.shown();
      this.place = shown.length ? Math.min(Math.max(place, -1), shown.length - 1) : -1;
      for (const item of this.items()) item.classList.toggle("found", item === shown[this.place]);
      shown[this.place]?.scrollIntoView({ block: "nearest" });
    },
    pressed(event) {
      if (event.key === "Escape" || event.key === "Tab") return; // the list closes
      event.stopPropagation(); // letters are for this field, not for the list
      const steps = { ArrowDown: 1, ArrowUp: -1 };
      if (event.key in steps) this.mark((this.place ?? -1) + steps[event.key]);
      else if (event.key === "Enter") this.shown()[this.place]?.click();
      else return;
      event.preventDefault();
    },
  },
};
