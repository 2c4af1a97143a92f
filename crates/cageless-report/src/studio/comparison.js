// A against B: a pinned case beside the one that changes, with a table of differences.

// Name, value of a side, and the sign of a difference that is better (0: neither).
const COMPARED = [
  ["lC, mm", (x) => x.g.raceways[0].axial_span_mm, 0],
  ["θ, °", (x) => x.g.raceways[0].half_angle_deg, 0],
  ["balls", (x) => x.g.bearing.balls, 0],
  ["speed, rpm", (x) => x.g.document.operation.inner_speed_rpm, 0],
  ["load, N", (x) => x.g.document.operation.radial_load_n, 0],
  ["gap 360°/N − ε, °", (x) => x.g.numbers.uniform_gap_deg, 0],
  ["β0, °", (x) => x.g.numbers.beta0_deg, 0],
  ["largest contact stress, GPa", (x) => Math.max(x.g.static.inner_stress_max_gpa, x.g.static.outer_stress_max_gpa), -1],
  ["critical gap, °", (x) => x.judged.critical_gap_deg, 1],
  ["contacts per passage", (x) => x.judged.passages.collisions_mean, -1],
  ["passages hit from both sides, %", (x) => 100 * x.judged.passages.double_collision_fraction, -1],
  ["slip in a passage, m/s", (x) => x.judged.passages.slip_mean_m_s, -1],
];

class Comparison {
  constructor(studio) {
    this.studio = studio;
    this.pinned = null;
    this.bar = element("div", { class: "bar", role: "toolbar", "aria-label": "Comparison" },
      button("Pin as A", () => this.pin(studio.toml, "A, pinned"), { "data-pin": true }),
      button("Conventional ring as A", () => this.pin(withoutSection(studio.toml, "raceway"), "A, conventional"), { "data-conventional": true }),
      button("Unpin", () => this.unpin(), { "data-unpin": true, disabled: true }));
    this.table = element("div", { "data-part": "table" });
  }

  async pin(toml, name) {
    const { studio } = this;
    try {
      const g = await studio.engine.request("quick", { op: "geometry", case: toml });
      const pinned = this.pinned = { toml, name, g, judged: toml === studio.toml ? studio.judged : null };
      studio.stage.now = 0;
      studio.motionA.start(toml, g.numbers.rolling_orbit_ms / 1000);
      this.show();
      if (!pinned.judged && g.raceways.length) {
        pinned.judged = await studio.engine.request("verdict-a", { op: "verdict", case: toml });
        if (pinned === this.pinned) this.show();
      }
    } catch (error) { if (error.name !== "AbortError") studio.say("message", error.message); }
  }

  unpin() {
    this.pinned = null;
    this.studio.motionA.reset();
    this.studio.stage.paint();
    this.show();
  }

  // The rows of the table as [name, A, B, "better", "worse" or ""].
  rows() {
    const sides = [this.pinned, this.studio];
    return COMPARED.map(([name, of, better]) => {
      const [a, b] = sides.map((side) => { try { const v = of(side); return v === null || v === undefined ? NaN : v; } catch { return NaN; } });
      const difference = b - a;
      return [name, a, b, !better || !difference || !isFinite(difference) ? "" : Math.sign(difference) === better ? "better" : "worse"];
    });
  }

  show() {
    const a = this.pinned, { studio } = this;
    studio.root.classList.toggle("comparing", !!a);
    this.bar.querySelector("[data-unpin]").disabled = !a;
    if (!a || !studio.g) { this.table.replaceChildren(); return; }
    const number = (v) => element("td", { class: "num" }, isFinite(v) ? minus(String(Number(v.toPrecision(5)))) : "–");
    const said = (x) => (x.judged ? x.judged.label || "not judged" : x.g.raceways.length ? "computing" : "not judged");
    const verdict = element("tr", {}, element("th", { scope: "row" }, "verdict"), ...[a, studio].map((x) => element("td", {}, said(x))), element("td"), element("td"));
    const rows = this.rows().map(([name, va, vb, word]) => element("tr", { class: word }, element("th", { scope: "row" }, name), number(va), number(vb), number(vb - va), element("td", {}, word)));
    this.table.replaceChildren(element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Differences" }, dataTable(a.name + ", against B, this case", ["", "A", "B", "B − A", ""], [verdict, ...rows])));
  }
}
