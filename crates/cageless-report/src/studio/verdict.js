// Pass or fail with margins, first estimated, then simulated; numbers of closed forms.

const PROGRESS_STEP = 0.05;
// What the criteria leave open.
const OPEN = "Whether a raceway that works also helps, cageless compare CASE --remedies says.";
// What the criteria measure.
const SIMULATED = {
  separation: "β0 lost by sliding (critical gap)", deceleration: "reduction of orbital speed, of that in pure rolling",
  "both-neighbours": "passages with double collision", lag: "lag per pass, of that of rolling on rigid flanks",
  pressure: "contact pressure at rest, of 4200 MPa (ISO 76)", "steady-gap": "critical gap, of the gap outside the raceway (80 to 100 %, in oil to 110 %)",
  "film-queue": "speed lost to the film, of the free share", "film-outweighs": "gap that the film opens, of the critical gap",
};
const ESTIMATED = {
  separation: "β0 over the gap outside the raceway", depth: "the same, beyond which evenly spaced balls collide", sliding: "friction demand over that available",
  "both-neighbours": "2θ over the angle of three balls", stress: "contact pressure over 4200 MPa (ISO 76)", lag: "lag of rolling over that on rigid flanks",
  "film-queue": "speed lost to the film over the free share", "film-outweighs": "gap that the film opens over β0",
};

class Verdict {
  constructor(studio) {
    this.studio = studio;
    this.lamp = element("div", { class: "lamp", "data-part": "verdict", role: "status" }, "Computing the first answer…");
    this.terms = element("div", { class: "terms scroll", "data-part": "terms" });
    this.numbers = element("div", { class: "forms", "data-part": "numbers" });
  }

  // In steps: the browser draws the page anew for each.
  progress(fraction) {
    const bar = this.lamp.querySelector("progress");
    if (bar && fraction - bar.value >= PROGRESS_STEP) bar.value = fraction;
  }

  // Criteria that are shown, with value, limit and margin in their units: those of the simulation
  // in per cent, those of the estimate as ratios to their limits.
  rows() {
    const { g, judged } = this.studio;
    if (!judged) return { kind: "estimated", rows: ((g.estimate && g.estimate.terms) || []).map((t) => ({ ...t, label: ESTIMATED[t.name], unit: "", by: 1, title: t.meaning })) };
    return { kind: "simulated", rows: (judged.criteria || []).map((c) => ({ ...c, label: SIMULATED[c.name], unit: "%", by: 100, title: c.text })) };
  }

  show() {
    const { g, judged } = this.studio, { lamp } = this, { estimate } = g;
    const passes = judged ? judged.passes : estimate && g.raceways.length ? estimate.passes : null;
    const mark = passes === null ? "" : passes ? "✔ " : "✘ ";
    lamp.className = "lamp judged " + (passes === null ? "unjudged" : passes ? "pass" : "fail") + (judged ? "" : " estimated");
    lamp.dataset.kind = judged ? "simulated" : "estimate";
    if (judged) lamp.replaceChildren(mark + judged.headline);
    else {
      const found = passes === null ? (g.raceways.length && estimate ? "not judged: a number is not known" : "nothing to judge") : passes ? "passes" : "fails";
      lamp.replaceChildren(mark + "Estimate from closed forms: " + found, g.raceways.length ? element("progress", { max: 1, value: 0, "aria-label": "Simulated verdict" }) : "");
    }
    const { kind, rows } = this.rows();
    const caption = (kind === "simulated" ? "Simulated. " : "Estimated from closed forms, before the simulation. ") + OPEN;
    const heads = ["criterion", "value", "limit", "margin", "unit"];
    const table = () => dataTable(caption, heads, rows.map(({ label, name, value, limit, margin, at_least, unit, by, title }) => {
      const numbers = [shown(by * value, by > 1 ? 1 : 3), (at_least ? "≥ " : "≤ ") + shown(by * limit, by > 1 ? 0 : 3), shown(by * margin, by > 1 ? 1 : 3)];
      return element("tr", { title, class: margin < 0 ? "missed" : "met" }, element("td", {}, label || name),
        ...numbers.map((v) => element("td", { class: "num" }, v)), element("td", {}, unit || "ratio"));
    }));
    this.terms.replaceChildren(...(rows.length ? [table()] : []));
    this.showNumbers();
  }

  // No verdict on a case that cannot be.
  refuse(why) {
    this.lamp.className = "lamp judged unjudged";
    this.lamp.dataset.kind = "impossible";
    this.lamp.replaceChildren("Not judged: " + why + ". Drawings and numbers below are of the last possible case.");
    this.terms.replaceChildren();
  }

  // Labels, values and units are those of the table of results.
  showNumbers() {
    const { rows } = this.studio.g;
    const list = (part) => element("dl", {}, ...part.map(([label, value, unit]) =>
      element("div", {}, element("dt", {}, label.trim()), element("dd", {}, value + (unit && unit !== "°" ? " " : "") + unit))));
    const open = this.numbers.querySelector("details")?.open || false;
    const rest = rows.static.length ? [element("details", { open }, element("summary", {}, "Static equilibrium, ratings and frequencies"), list(rows.static))] : [];
    this.numbers.replaceChildren(list(rows.design), ...rest);
  }
}
