// Text that changes with every move of a slider, and the state of the answer around it.  They are written into the page
// directly: an update of a property would make the whole page look for what has changed, which takes longer than solving.
export default {
  template: "<div></div>",
  props: { first: String },
  mounted() {
    this.show(this.newest ?? this.first ?? "");
    if (this.word) this.mark(this.word);
    if (this.around) this.showAround(...this.around);
  },
  methods: {
    show(html) {
      this.newest = html;
      if (this.$el) this.$el.innerHTML = html;
    },
    showAround(visible, button) {
      this.around = [visible, button];
      const place = this.$el?.parentElement;
      place?.classList.toggle("hidden", !visible);
      place?.querySelector("button")?.classList.toggle("hidden", !button);
    },
    // State of the enclosing answer: busy, done or wrong; requests are counted, as the shortest are over within a frame.
    mark(word) {
      this.word = word;
      const place = this.$el?.closest(".answer-side");
      if (!place) return;
      place.dataset.state = word;
      if (word === "busy") place.dataset.asked = Number(place.dataset.asked ?? 0) + 1;
      place.setAttribute("aria-busy", String(word === "busy"));
    },
  },
};
