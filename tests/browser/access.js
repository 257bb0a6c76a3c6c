// What an audit of a page for access finds, of the rules that this page can break: names of controls, one main part,
// a language, the order of headings, identifiers, and the contrast of text (WCAG 2.2: 4.5, of large text and icons 3).
() => {
  const found = [];
  const seen = (one) => one.checkVisibility({ checkOpacity: true, checkVisibilityCSS: true }) && one.getClientRects().length;
  const all = (what) => [...document.querySelectorAll(what)].filter(seen);
  const called = (one) => `${one.tagName.toLowerCase()}.${[...one.classList].join(".")} "${one.textContent.trim().slice(0, 40)}"`;
  if (!document.documentElement.lang) found.push("no language");
  if (document.querySelectorAll("main").length !== 1) found.push("not one main part");
  let level = 0;
  for (const one of all("h1, h2, h3, h4, h5")) {
    const next = Number(one.tagName[1]);
    if (next > level + 1) found.push(`heading ${next} after ${level}: ${called(one)}`);
    level = next;
  }
  if (document.querySelectorAll("h1").length !== 1) found.push("not one first heading");
  const ids = [...document.querySelectorAll("[id]")].map((one) => one.id);
  for (const id of new Set(ids.filter((id, place) => ids.indexOf(id) !== place))) found.push(`identifier twice: ${id}`);
  const words = (one) => [...one.childNodes].map((node) => (node.nodeType === 3 ? node.data
    : node.nodeType === 1 && node.getAttribute("aria-hidden") !== "true" ? words(node) : "")).join("");
  const name = (one) => one.getAttribute("aria-label") || one.getAttribute("title")
    || (one.getAttribute("aria-labelledby") ?? "").split(" ").map((id) => document.getElementById(id)?.textContent).join("")
    || [...(one.labels ?? [])].map((label) => label.textContent).join("")
    || (/^(INPUT|TEXTAREA)$/.test(one.tagName) ? "" : words(one));
  const controls = "button, a[href], input:not([type=hidden]):not([type=file]), textarea, canvas, [role=slider], [role=checkbox],"
    + "[role=combobox], [role=menuitem], [role=option], [role=img], summary";
  for (const one of all(controls)) if (!name(one)?.trim()) found.push(`no name: ${called(one)} ${one.outerHTML.slice(0, 200)}`);
  const pen = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
  const over = (colours) => { // first below
    pen.clearRect(0, 0, 1, 1);
    for (const colour of ["white", ...colours]) {
      pen.fillStyle = colour;
      pen.fillRect(0, 0, 1, 1);
    }
    return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3);
  };
  const light = (rgb) => rgb.map((c) => c / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, k) => sum + [0.2126, 0.7152, 0.0722][k] * c, 0);
  for (const one of all("body *")) {
    if (one.closest("svg, canvas, [disabled], .disabled, .stale, [aria-disabled=true]")) continue;
    if (![...one.childNodes].some((node) => node.nodeType === 3 && node.data.trim())) continue;
    const behind = [];
    for (let up = one; up; up = up.parentElement) behind.unshift(getComputedStyle(up).backgroundColor);
    const { color, fontSize, fontWeight } = getComputedStyle(one);
    const [text, ground] = [light(over([...behind, color])), light(over(behind))];
    const ratio = (Math.max(text, ground) + 0.05) / (Math.min(text, ground) + 0.05);
    const size = parseFloat(fontSize);
    const large = size >= 24 || (size >= 18.66 && fontWeight >= 700) || one.closest(".q-icon");
    if (ratio < (large ? 3 : 4.5) - 0.01) found.push(`contrast ${ratio.toFixed(2)}: ${called(one)} ${color}`);
  }
  for (const one of all("th")) if (!one.textContent.trim()) found.push(`empty heading: ${called(one.closest("table"))}`);
  for (const one of all(".scroll")) {
    const scrolls = one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1;
    if (scrolls && one.tabIndex < 0) found.push(`not reached by the keyboard: ${called(one)}`);
  }
  if (document.documentElement.scrollWidth > innerWidth) found.push(`wider than the window: ${document.documentElement.scrollWidth}`);
  return found;
}
