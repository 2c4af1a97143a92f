// A against B: a pinned case beside the one that changes, with a table of differences, and both from
// the same uneven starts.

// Name and value of a side.
const COMPARED = [
  ["lC, mm", (x) => x.g.raceways[0].axial_span_mm],
  ["θ, °", (x) => x.g.raceways[0].half_angle_deg],
  ["shape", (x) => x.g.raceways[0].shape],
  ["balls", (x) => x.g.bearing.balls],
  ["speed, rpm", (x) => x.g.document.operation.inner_speed_rpm],
  ["load, N", (x) => x.g.document.operation.radial_load_n],
  ["axial load, N", (x) => x.g.document.operation.axial_load_n || 0],
  ["gap 360°/N − ε, °", (x) => x.g.numbers.uniform_gap_deg],
  ["β0, °", (x) => x.g.numbers.beta0_deg],
  ["largest contact pressure at rest, MPa", (x) => Math.max(x.g.static.inner_pressure_max_mpa, x.g.static.outer_pressure_max_mpa)],
  ["critical gap, °", (x) => x.judged.critical_gap_deg],
  ["lag per pass, °", (x) => x.judged.passages.lag_per_pass_deg],
  ["contacts per passage", (x) => x.judged.passages.collisions_mean],
  ["passages with double collision, %", (x) => 100 * x.judged.passages.double_collision_fraction],
  ["sliding speed in a passage, m/s", (x) => x.judged.passages.sliding_mean_m_s],
];
// Results from the uneven starts. The less the better; a change over time is no merit by itself.
const FROM_STARTS = [
  ["gap_deviation_deg", "standard deviation of the gaps, °", true],
  ["gap_deviation_change_deg", "its change, second half of the run less the first, °", false],
  ["outer_ring_force_deviation_n", "standard deviation of the force on the outer ring, N", true],
  ["collisions", "contacts between balls", true],
  ["power_loss_w", "power loss of this model, W", true],
];

// Mean ± standard error, this with two significant digits.
function estimated(e) {
  if (!e) return "–";
  if (!(e.standard_error > 0)) return minus(String(Number(e.mean.toPrecision(4))));
  const count = Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(e.standard_error))));
  return shown(e.mean, count) + " ± " + shown(e.standard_error, count);
}

class Comparison {
  constructor(studio) {
    this.studio = studio;
    this.pinned = null;
    this.bar = element("div", { class: "bar", role: "toolbar", "aria-label": "Comparison" },
      button("Pin as A", () => this.pin(studio.toml, "A, pinned"), { "data-pin": true }),
      button("Conventional ring as A", () => this.pin(without(studio.toml, "raceway"), "A, conventional"), { "data-conventional": true }),
      button("Unpin", () => this.unpin(), { "data-unpin": true, disabled: true }));
    this.table = element("div", { "data-part": "table" });
  }

  async pin(toml, name) {
    const { studio } = this;
    try {
      const g = await studio.engine.request("quick", { op: "geometry", case: toml });
      const pinned = this.pinned = { toml, name, g, judged: toml === studio.toml ? studio.judged : null };
      studio.stage.now = 0;
      studio.motionA.start(toml, g.rolling_orbit_ms / 1000);
      this.show();
      this.compute();
      if (!pinned.judged && g.raceways.length) {
        pinned.judged = await studio.engine.request("verdict-a", { op: "verdict", case: toml });
        if (pinned === this.pinned) this.show();
      }
    } catch (error) { if (error.name !== "AbortError") studio.say("message", error.message); }
  }

  unpin() {
    this.cancel();
    this.pinned = null;
    this.studio.motionA.reset();
    this.studio.stage.paint();
    this.show();
  }

  // --- the starts ---

  // Runs both sides from the same uneven starts.
  async compute() {
    const { studio, pinned } = this;
    if (!pinned || pinned.g.rotor || !studio.g || studio.g.rotor || studio.impossible) return;
    this.cancel();
    const toml = studio.toml, work = this.work = new AbortController();
    try {
      const found = await studio.engine.request("compare", { op: "compare", case: toml, reference: pinned.toml }, {
        signal: work.signal, onProgress: (fraction) => { if (work === this.work && this.progress) this.progress.value = fraction; },
      });
      if (work === this.work) this.starts = found;
    } catch (error) {
      if (work !== this.work || error.name === "AbortError") return;
      this.starts = { message: error.message };
    }
    if (work === this.work) this.show();
  }

  cancel() {
    if (this.work) this.work.abort();
    this.work = this.starts = null;
  }

  // Rows of the starts as [label, A, B, B − A, "better", "worse" or ""]: a word only where the
  // cases differ in nothing but the raceway and the difference is significant.
  startRows() {
    const { starts } = this;
    if (!starts || !starts.results) return [];
    return FROM_STARTS.filter(([name]) => starts.results[name]).map(([name, label, judged]) => {
      const { values, difference, change } = starts.results[name];
      const word = !judged || !starts.only_the_raceway_differs || change === "undecided" ? "" : change === "lower" ? "better" : "worse";
      return [label, estimated(values[0]), estimated(values[1]), estimated(difference), word];
    });
  }

  // --- showing ---

  // The rows of the table as [name, A, B].
  rows() {
    const sides = [this.pinned, this.studio];
    return COMPARED.map(([name, of]) => [name, ...sides.map((side) => { try { const v = of(side); return v === null || v === undefined ? NaN : v; } catch { return NaN; } })]);
  }

  show() {
    const a = this.pinned, { studio } = this;
    studio.root.classList.toggle("comparing", !!a);
    this.bar.querySelector("[data-unpin]").disabled = !a;
    this.progress = null;
    if (!a || !studio.g) { this.table.replaceChildren(); return; }
    if (studio.impossible) { this.table.replaceChildren(element("p", { class: "old" }, "No comparison: the values of B are not possible.")); return; }
    const cell = (text) => element("td", { class: "num" }, text), number = (v) => cell(typeof v === "string" ? v : isFinite(v) ? minus(String(Number(v.toPrecision(5)))) : "–");
    const row = (name, cells, word) => element("tr", { class: word }, element("th", { scope: "row" }, name), ...cells, element("td", {}, word));
    const said = (x) => (x.judged ? x.judged.label || "not judged" : x.g.raceways.length ? "computing" : "not judged");
    const verdict = row("verdict", [...[a, studio].map((x) => element("td", {}, said(x))), element("td")], "");
    const rows = this.rows().map(([name, va, vb]) => row(name, [number(va), number(vb), number(vb - va)], ""));
    const started = this.startRows().map(([name, va, vb, difference, word]) => row(name, [va, vb, difference].map(cell), word));
    const table = dataTable(a.name + ", against B, this case", ["", "A", "B", "B − A", ""], [...started, verdict, ...rows]);
    this.table.replaceChildren(element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Differences" }, table), this.note());
  }

  // What the rows of the starts are, or how far they are.
  note() {
    const { starts, pinned, studio } = this, note = element("p", { class: "moving", "data-part": "starts" });
    if (pinned.g.rotor || studio.g.rotor) return note;
    if (!starts) {
      this.progress = element("progress", { max: 1, value: 0, "aria-label": "Both from the same uneven starts" });
      note.append("Both are being run from the same uneven starts.", this.progress);
    } else if (starts.message) note.append(starts.message);
    else {
      note.append("With ±: both run from the same " + starts.starts + " starts with gaps drawn at random (seed " + starts.seed + "), " + starts.orbits + " orbits each; mean ± standard error, "
        + "differences start by start. Better and worse only where nothing but the raceway differs and the difference is significant. The balls above start as the case says.");
    }
    return note;
  }
}
