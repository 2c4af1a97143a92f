// Pass or fail with margins, first estimated, then simulated; numbers of closed forms.

const PROGRESS_STEP = 0.05;

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

  // Criteria that are shown, as name, value, limit, margin and meaning.
  rows() {
    const { g, judged } = this.studio;
    return judged && judged.criteria && judged.criteria.length
      ? { kind: "simulated", rows: judged.criteria.map((c) => [c.name, c.value, c.limit, c.margin, c.text]) }
      : { kind: "estimated", rows: ((g.estimate && g.estimate.terms) || []).map((t) => [t.name, t.value, t.limit, t.margin, t.meaning]) };
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
    const table = () => dataTable(kind === "simulated" ? "Simulated" : "Estimated", ["criterion", "value", "limit", "margin"],
      rows.map(([name, value, limit, margin, title]) => element("tr", { title, class: margin < 0 ? "missed" : "met" },
        element("td", {}, name), ...[value, limit, margin].map((v) => element("td", { class: "num" }, shown(v, 3))))));
    this.terms.replaceChildren(...(rows.length ? [table()] : []));
    this.showNumbers();
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
      ["largest contact stress", atRest(Math.max(g.static.inner_stress_max_gpa, g.static.outer_stress_max_gpa), 3, " GPa"), "static"],
    ].map(([name, value, title]) => element("div", { title }, element("dt", {}, name), element("dd", {}, value)))));
  }
}
