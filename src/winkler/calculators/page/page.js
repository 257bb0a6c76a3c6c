// The page: which calculator is open, its address, and what is taken along.
import { Panel, codeOf, fromBase64, kernelsOf } from "./calculators.js";

const DELAY = 300; // ms; browsers refuse hundreds of addresses in a few seconds
const CALCULATOR = "calculator";

export async function open({ calculators, module, app }) {
  const run = await kernelsOf(fromBase64(module));
  const byId = (id) => document.getElementById(id);
  const tabs = calculators.map(({ name, title }) => {
    const link = document.createElement("a");
    [link.href, link.textContent] = [`#${CALCULATOR}=${name}`, title];
    link.dataset.name = name;
    byId("classes").append(link);
    return link;
  });
  let [panel, timer] = [null, 0];

  const inAddress = () => {
    const asked = new URLSearchParams(location.hash.slice(1));
    const one = calculators.find(({ name }) => name === asked.get(CALCULATOR)) ?? calculators[0];
    const start = { across: asked.get("across") ?? undefined, up: asked.get("up") ?? undefined };
    one.sliders.forEach(({ name }) => asked.has(name) && (start[name] = Number(asked.get(name))));
    return [one, start];
  };
  const address = () => {
    const { one, values, across, up } = panel;
    const kept = new URLSearchParams({ [CALCULATOR]: one.name });
    one.sliders.forEach(({ name, start }, k) => values[k] !== start && kept.set(name, String(values[k])));
    if (one.sliders[across].name !== one.across) kept.set("across", one.sliders[across].name);
    if (one.numbers[up].name !== one.up) kept.set("up", one.numbers[up].name);
    return `#${kept}`;
  };
  const write = async () => {
    clearTimeout(timer);
    if (location.hash !== address()) history.replaceState(null, "", address());
    byId("study").textContent = panel.study;
    byId("app").href = `${app}/#study=${await codeOf(panel.study)}`;
  };
  const changed = () => {
    clearTimeout(timer);
    timer = setTimeout(write, DELAY);
    byId("done").textContent = "";
  };
  const show = () => {
    const [one, start] = inAddress();
    panel = null;
    byId("title").textContent = one.title;
    byId("question").textContent = one.question;
    byId("manual").href = one.page;
    tabs.forEach((tab) =>
      tab.dataset.name === one.name ? tab.setAttribute("aria-current", "page") : tab.removeAttribute("aria-current"));
    panel = new Panel(byId("holder"), one, run, changed, start);
    document.title = `${one.title} – winkler`;
    write();
  };

  byId("copy").addEventListener("click", async () => {
    write();
    const done = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    byId("done").textContent = done ? "The link is copied." : "The link is the address above; copy it there.";
  });
  byId("download").addEventListener("click", () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([panel.study], { type: "application/toml" }));
    link.download = `${panel.one.name}.toml`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    byId("done").textContent = `Solve it with: winkler run ${panel.one.name}.toml`;
  });
  byId("app").addEventListener("click", () => {
    byId("done").textContent = `The link leads to ${app}; the command "winkler app" must be running there.`;
  });
  byId("again").addEventListener("click", () => {
    history.replaceState(null, "", `#${CALCULATOR}=${panel.one.name}`);
    show();
  });
  addEventListener("hashchange", show);
  addEventListener("pagehide", write);
  show();
  document.documentElement.dataset.ready = "yes";
}
