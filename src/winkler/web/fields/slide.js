// A slider that moves by itself: a property of the page for its place would make the whole page look for what has
// changed at every step, which takes longer than solving.
export default {
  template: `<q-slider :model-value="place" @update:model-value="move" />`,
  props: { value: Number },
  emits: ["update:value"],
  data() {
    return { place: this.value };
  },
  watch: {
    value(place) {
      this.place = place;
    },
  },
  methods: {
    put(place) {
      this.place = place;
    },
    move(place) {
      this.place = place;
      this.$emit("update:value", place);
    },
  },
};
