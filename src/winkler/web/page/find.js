// Search among the options of a list that is open: those that have the typed letters stay, below those that the app
// says are meant by the words.
export default {
  template: `<div class="find">
    <input type="search" autocomplete="off" :placeholder="label" :aria-label="label" @input="filter" @keydown="pressed"
      @click.stop />
    <p v-show="none || said" role="status">{{ said || "Nothing has these words." }}</p>
  </div>`,
  props: { label: String },
  data: () => ({ none: false, said: "" }),
  mounted() {
    this.input = this.$el.querySelector("input");
    if (matchMedia("(hover: hover)").matches) setTimeout(() => this.input?.focus(), 0); // no keyboard over a phone's list
    // the form that is rebuilt while the list is open makes its options anew
    this.anew = new MutationObserver((changes) => {
      if (this.input.value && changes.some((change) => !this.$el.contains(change.target))) this.arrange(this.place);
    });
    this.anew.observe(this.$el.parentElement, { childList: true, subtree: true });
  },
  unmounted() {
    this.anew.disconnect();
  },
  methods: {
    items() {
      return [...this.$el.parentElement.querySelectorAll(".q-item")].sort((one, two) => one.style.order - two.style.order);
    },
    shown() {
      return this.items().filter((item) => item.style.display !== "none");
    },
    filter() {
      const text = this.input.value.trim();
      this.said = "";
      this.keep(text.toLowerCase().split(/\s+/), []);
      if (text.length > 1) this.$emit("sought", text);
    },
    // what the app found for a text: labels, the best first, a sentence on what is not covered, one on other hits, and
    // whether the labels are neighbours alone
    found(text, labels, remark, also, beyond) {
      if (text !== this.input?.value.trim()) return; // more was typed by the time
      this.said = [remark, also].filter(Boolean).join(" ");
      this.keep(beyond ? null : text.toLowerCase().split(/\s+/), labels);
    },
    // show options with these labels first, then those with all of these words
    keep(words, labels) {
      Object.assign(this, { words, labels });
      this.arrange(this.input.value ? 0 : -1);
    },
    arrange(place) {
      const { words, labels } = this;
      for (const item of this.items()) {
        const rank = labels.indexOf(item.getAttribute("aria-label"));
        const text = item.textContent.toLowerCase();
        item.style.display = rank >= 0 || words?.every((word) => text.includes(word)) ? "" : "none";
        item.style.order = rank >= 0 ? rank - labels.length : 0;
      }
      this.none = this.shown().length === 0;
      this.mark(place);
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
