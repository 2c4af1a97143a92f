// Pass or fail with margins, first estimated, then simulated; numbers of closed forms.

const PROGRESS_STEP = 0.05;
// What the criteria measure.
const SIMULATED = {
  separation: "β0 lost by sliding (critical gap)", deceleration: "reduction of orbital speed, of that in pure rolling",
  "both-neighbours": "passages with double collision",
};
const ESTIMATED = {
  separation: "β0 over the gap outside the raceway", sliding: "friction demand over that available",
  "both-neighbours": "2θ over the angle of three balls", stress: "contact pressure over 4.2 GPa (ISO 76)",
};

class Verdict {
  constructor(studio) {
    this.studio = studio;
    this.lamp = element("div", { class: "lamp", "data-part": "verdict", role: "status" });
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
      const found = passes === null ? "nothing to judge" : passes ? "passes" : "fails";
      lamp.replaceChildren(mark + "Estimate from closed forms: " + found, g.raceways.length ? element("progress", { max: 1, value: 0, "aria-label": "Simulated verdict" }) : "");
    }
    const { kind, rows } = this.rows();
    const caption = kind === "simulated" ? "Simulated" : "Estimated from closed forms, before the simulation";
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

  showNumbers() {
    const { g } = this.studio, n = g.numbers, atRest = (value, count, unit) => (g.static.error ? "–" : shown(value, count) + unit);
    this.numbers.replaceChildren(element("dl", {}, ...[
      ["ε", shown(n.epsilon_deg) + "°", "angle of a ball, Eq. (10)"],
      ["gap 360°/N − ε", shown(n.uniform_gap_deg) + "°", "gap of evenly spaced balls"],
      ["β0, Eq. (11)", shown(n.beta0_deg) + "°", "gap that a passage without slip closes"],
      ["gap outside the raceway", shown(n.steady_gap_deg) + "°", "steady state"],
      ["lC at most, Eq. (8)", shown(n.axial_span_limit_mm, 3) + " mm", "the contact points stay on the groove"],
      ["θ of Eq. (11)", shown(n.half_angle_deg_for_span, 3) + "°", "for this lC"],
      ["ring displacement", atRest(g.static.ring_y_um, 2, " µm"), "static"],
      ["largest contact pressure", atRest(Math.max(g.static.inner_stress_max_gpa, g.static.outer_stress_max_gpa), 3, " GPa"), "static"],
    ].map(([name, value, title]) => element("div", { title }, element("dt", {}, name), element("dd", {}, value)))));
  }
}
