// Elements of the page and numbers as text.

function element(tag, attributes = {}, ...children) {
  const el = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) el.addEventListener(name.slice(2), value);
    else if (value === true) el.setAttribute(name, "");
    else if (value !== false && value !== undefined) el.setAttribute(name, value);
  }
  el.append(...children);
  return el;
}

const button = (label, onclick, attributes = {}) => element("button", { type: "button", onclick, ...attributes }, label);

// Calls `moved` for a pointer that is down on an element until it is let go.
function follow(el, { pointerId }, moved) {
  const ended = new AbortController(), { signal } = ended;
  el.setPointerCapture(pointerId);
  el.addEventListener("pointermove", moved, { signal });
  for (const name of ["pointerup", "pointercancel"]) el.addEventListener(name, () => ended.abort(), { signal });
}

const minus = (text) => text.replace("-", "\u2212");
const shown = (value, count = 4) => (value === null || value === undefined || !isFinite(value) ? "–" : minus(Number(value).toFixed(count)));

// A table of rows whose cells after the first are numbers or texts.
function dataTable(caption, heads, rows) {
  return element("table", {}, element("caption", {}, caption),
    element("thead", {}, element("tr", {}, ...heads.map((head, k) => (head ? element("th", { scope: "col", class: k ? "num" : "" }, head) : element("td"))))),
    element("tbody", {}, ...rows));
}
