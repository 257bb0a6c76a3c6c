// The study in the address of the page, in the store of its tab, and named ones in the store of the browser.
// Nothing is sent anywhere: what stands behind the # of an address stays in the browser, and goes to the app by its socket.
const STUDY = "winkler.study";
const NAMED = "winkler.snapshots";
const DELAY = 300; // ms; browsers refuse hundreds of addresses in a few seconds

function read(store, key, otherwise) {
  try {
    return JSON.parse(store.getItem(key)) ?? otherwise;
  } catch {
    return otherwise;
  }
}

export default {
  template: "<span hidden></span>",
  mounted() {
    this.flush = () => this.write();
    this.back = () => this.$emit("back", { code: this.inAddress() });
    this.others = (event) => event.key === NAMED && this.$emit("named", { named: read(localStorage, NAMED, []) });
    this.keys = (event) => this.pressed(event);
    window.addEventListener("pagehide", this.flush);
    window.addEventListener("popstate", this.back);
    window.addEventListener("storage", this.others);
    document.addEventListener("keydown", this.keys);
    this.popup = new MutationObserver(() => this.lock());
    this.popup.observe(document.getElementById("popup"), { attributeFilter: ["aria-hidden"] });
    const kept = read(sessionStorage, STUDY, {});
    const code = this.inAddress();
    const files = !code || code === kept.code ? (kept.files ?? "") : "";
    this.files = files;
    this.$emit("opened", { code: code || kept.code || "", files, named: read(localStorage, NAMED, []) });
  },
  beforeUnmount() {
    window.removeEventListener("pagehide", this.flush);
    window.removeEventListener("popstate", this.back);
    window.removeEventListener("storage", this.others);
    document.removeEventListener("keydown", this.keys);
    this.popup.disconnect();
  },
  methods: {
    // while the popup says that the connection is lost, nobody would take what is typed
    lock() {
      const lost = document.getElementById("popup").ariaHidden === "false";
      document.querySelector(".study-side").inert = lost;
    },
    inAddress() {
      return new URLSearchParams(location.hash.slice(1)).get("study") ?? "";
    },
    // `step` makes an entry of its own for the button Back; `short` whether the address can hold it
    keep(code, short, step) {
      if (step) this.write();
      this.waiting = { code, short, step: step || (this.waiting?.step ?? false) };
      clearTimeout(this.timer);
      if (step) this.write();
      else this.timer = setTimeout(this.flush, DELAY);
    },
    keepFiles(files) {
      this.files = files;
    },
    write() {
      clearTimeout(this.timer);
      if (!this.waiting) return;
      const { code, short, step } = this.waiting;
      this.waiting = undefined;
      const where = location.pathname + location.search + (short && code ? `#study=${code}` : "");
      if (where !== location.pathname + location.search + location.hash)
        history[step ? "pushState" : "replaceState"](history.state, "", where);
      this.store(sessionStorage, STUDY, { code, files: this.files ?? "" });
    },
    store(store, key, content) {
      try {
        store.setItem(key, JSON.stringify(content));
      } catch {
        if (store === localStorage) this.$emit("full", {});
      }
    },
    storeNamed(named) {
      this.store(localStorage, NAMED, named);
    },
    async copy() {
      this.write();
      const done = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
      this.$emit("copied", { done: done ?? false });
    },
    pressed(event) {
      if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
      if (event.target.closest?.("input, textarea, [contenteditable]")) return; // there it undoes what was typed
      const key = event.key.toLowerCase();
      const what = key === "z" ? (event.shiftKey ? "redo" : "undo") : key === "y" ? "redo" : "";
      if (!what) return;
      event.preventDefault();
      this.$emit(what, {});
    },
  },
};
