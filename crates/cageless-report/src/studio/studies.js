// What takes many runs or the libraries of files: search, tolerance and export, on the engine of
// `cageless studio` alone.

const TOLERANCES = {
  samples: ["bearings drawn", ""], groove_depth_um: ["groove depth ±", "µm"], axial_span_um: ["lC ±", "µm"],
  half_angle_deg: ["θ ±", "°"], contact_angle_deg: ["contact angle of the raceway ±", "°"], ball_grade: ["ball grade G", ""], friction: ["friction ±", ""],
  clearance_um: ["radial internal clearance Gr ±", "µm"], speed_percent: ["speed ±", "%"], load_percent: ["load ±", "%"],
  viscosity_percent: ["oil viscosity ±", "%"], supply_factor: ["oil supply, factor", ""],
};
const FILES = { step: "STEP", stl: "STL", csv: "CSV of the groove" };

// The keys that a slot has, and those that any other shape leaves as they are.
const SLOT_KEYS = ["edge_radius_mm", "slot_depth_mm"], OTHER_KEYS = ["blend_mm", "depth_um"];

// Those of the first raceway, of a slot that it is not the edges that the search asks for.
function kept({ document: { raceway, search } }, shape) {
  const own = [].concat(raceway || {})[0], from = shape === "slot" && own.shape !== shape ? search : own;
  return Object.fromEntries((shape === "slot" ? SLOT_KEYS : OTHER_KEYS).filter((key) => from[key]).map((key) => [key, from[key]]));
}

// `text` with a raceway of this shape at each of these places; comments stay where there is one, as before.
function withRaceways(text, { axial_span_mm, half_angle_deg, centre_angles_deg, shape, contact_angle_deg }, g) {
  const turned = g.space ? { contact_angle_deg } : {};
  const keys = (centre) => ({ axial_span_mm: digits(axial_span_mm, 6), half_angle_deg: digits(half_angle_deg, 6), centre_angle_deg: centre, shape, ...turned });
  if (centre_angles_deg.length === 1 && g.raceways.length === 1) {
    const rest = without(text, "raceway", shape === "slot" ? OTHER_KEYS : SLOT_KEYS);
    return Object.entries({ ...keys(centre_angles_deg[0]), ...kept(g, shape) }).reduce((all, [key, value]) => withValue(all, "raceway." + key, written(value)), rest);
  }
  const blocks = centre_angles_deg.map((centre) => "\n[[raceway]]\n" + Object.entries({ ...keys(centre), ...kept(g, shape) }).map(([key, value]) => key + " = " + written(value) + "\n").join(""));
  return without(text, "raceway").replace(/\n*$/, "\n") + blocks.join("");
}

class Studies {
  constructor(studio) {
    this.studio = studio;
    this.work = null;
    const number = (name, label, unit, value) => element("label", {}, label + " ", element("input", { type: "number", step: "any", min: 0, value, "data-study": name, style: "width:5.5rem" }), unit ? " " + unit : "");
    const numbers = Object.entries(TOLERANCES).map(([name, [label, unit]]) => number(name, label, unit, ""));
    const budget = number("budget", "simulations at most", "", "");
    this.search = button("Search for the best raceway", () => this.run("search", { budget: this.value("budget") || undefined, case: this.searched() }), { "data-search": true });
    this.tolerance = button("Run tolerance study", () => this.run("tolerance", { tolerances: this.tolerances() }), { "data-tolerance": true });
    this.files = Object.entries(FILES).map(([format, label]) => button(label, () => this.run("export", { format }), { "data-export": format, title: "outer ring as " + label }));
    this.cancel = button("Cancel", () => { if (this.work) this.work.abort(); }, { "data-cancel": true });
    this.bar = element("progress", { max: 1, value: 0, "aria-label": "Progress" });
    this.working = element("div", { hidden: true }, this.cancel, this.bar);
    this.said = element("p", { class: "moving", "data-part": "studies", role: "status" });
    this.result = element("div", { class: "scroll", "data-part": "study-result" });
    this.old = element("p", { class: "old", hidden: true }, "Result of the case before the last change.");
    this.root = element("section", { class: "studies", "aria-label": "Search, tolerance, files" },
      element("div", { class: "bar" }, this.search, budget, element("label", {}, element("input", { type: "checkbox", "data-study": "shapes" }), " over all shapes")),
      element("div", { class: "bar" }, this.tolerance, element("details", {}, element("summary", {}, "tolerances"), element("div", { class: "bar" }, ...numbers))),
      element("div", { class: "bar" }, element("span", {}, "Outer ring as"), ...this.files),
      this.working, this.old, this.said, this.result);
    this.able = new Set();
  }

  input(name) { return this.root.querySelector("[data-study=" + name + "]"); }

  value(name) { return Number(this.input(name).value); }

  // The case with what is to be searched.
  searched() {
    const { toml } = this.studio;
    return this.input("shapes").checked ? withValue(toml, "search.shapes", "\"all\"") : toml;
  }

  tolerances() { return Object.fromEntries(Object.keys(TOLERANCES).map((name) => [name, this.value(name)])); }

  // Asks the engine that is there what it can do.
  async ask() {
    let about = { operations: [] };
    try { about = await this.studio.engine.request("quick", { op: "about" }); } catch { /* said elsewhere */ }
    this.able = new Set(about.operations);
    this.runs = about.runs_max;
    for (const [name, value] of Object.entries(about.tolerances || {})) if (this.input(name)) this.input(name).value = value;
    this.show();
    return about;
  }

  show() {
    const { g } = this.studio, busy = !!this.work;
    // Empty: what the case says, as for the command.
    if (g) this.input("budget").placeholder = (g.document.search || {}).runs_max || this.runs || "";
    this.search.disabled = busy || !this.able.has("search") || !g || !!g.rotor;
    this.tolerance.disabled = busy || !this.able.has("tolerance") || !g || !!g.rotor || !g.raceways.length;
    this.files.forEach((file) => { file.disabled = busy || !this.able.has("export") || !g; });
    // A search does not depend on the raceway that is there.
    const of = (toml) => (this.found && this.found.op === "search" ? this.studio.map.apart(toml, MAP_DEFAULT) : toml);
    this.old.hidden = !this.found || busy || of(this.found.toml) === of(this.studio.toml);
    this.root.classList.toggle("stale", !this.old.hidden);
    this.working.hidden = !busy;
    if (!busy && !this.able.has("search")) this.say("Search, tolerance and files of the ring are computed by the command cageless studio; this page is stand-alone.");
    else if (this.said.dataset.able === "no") this.say("");
    this.said.dataset.able = this.able.has("search") ? "yes" : "no";
  }

  say(text) { this.said.textContent = text; }

  async run(op, more) {
    const { studio } = this, toml = studio.toml, work = this.work = new AbortController();
    this.bar.value = 0;
    this.say("");
    this.result.replaceChildren();
    this.found = null;
    this.show();
    try {
      const found = await studio.engine.request(op, { op, case: toml, ...more }, { signal: work.signal, onProgress: (fraction) => { this.bar.value = fraction; } });
      this.work = null;
      this.found = { op, toml };
      this[op + "Done"](found, toml);
    } catch (error) {
      this.say(error.name === "AbortError" ? "cancelled" : error.message);
    }
    this.work = null;
    this.show();
  }

  // --- results ---

  searchDone(found) {
    const worst = (structure, of, pick) => {
      const values = structure.points.map(of).filter((v) => typeof v === "number");
      return values.length ? pick(...values) : NaN;
    };
    const motion = (name) => (point) => point.motion && point.motion[name];
    const rows = found.front.map((structure, k) => {
      const numbers = [
        shown(structure.axial_span_mm, 3), shown(structure.half_angle_deg, 2), structure.centre_angles_deg.map((a) => shown(a, 0)).join(", "),
        structure.shape + (structure.contact_angle_deg ? ", turned by " + shown(structure.contact_angle_deg, 1) + "°" : ""),
        shown(worst(structure, (p) => p.margin_deg, Math.min), 3), shown(worst(structure, motion("collisions"), Math.max), 2),
        shown(100 * worst(structure, motion("double_collision_fraction"), Math.max), 1), shown(worst(structure, motion("sliding_m_s"), Math.max), 2),
        shown(worst(structure, (p) => p.pressure_mpa, Math.max), 0),
      ];
      const take = button("Take", () => this.studio.edit(withRaceways(this.studio.toml, structure, this.studio.g)), { "data-take": k, "aria-label": "Take lC " + numbers[0] + " mm, θ " + numbers[1] + "°" });
      return element("tr", {}, element("td", {}, take), ...numbers.map((v) => element("td", { class: "num" }, v)));
    });
    const heads = ["", "lC, mm", "θ, °", "ψ, °", "shape", "margin of the gap, °", "contacts per ball and orbit", "double collisions, %", "sliding speed, m/s", "contact pressure, MPa"];
    const caption = "Pareto front, nearest to the best in everything first; the worst of all speeds and loads";
    this.result.replaceChildren(dataTable(caption, heads, rows));
    const verdict = found.verdicts.map((v) => v.headline).join("; ");
    this.say(found.none || (found.looked_at + " structures evaluated, " + found.front.length + " on the Pareto front. Verdict on the recommended one: " + verdict));
  }

  toleranceDone(judged) {
    const range = (values, count) => (values ? shown(values[0], count) + " to " + shown(values[1], count) : "–");
    const rows = judged.influences.map((row) => element("tr", { class: row.passed < row.trials ? "missed" : "met" }, element("td", {}, row.name),
      ...[range([row.low, row.high], 3) + " " + row.unit, range(row.critical_gap_deg, 3), range(row.sliding_mean_m_s, 2), row.passed + " of " + row.trials].map((v) => element("td", { class: "num" }, v)),
      element("td", {}, row.verdicts.join(", "))));
    const heads = ["deviates", "range", "critical gap, °", "sliding speed, m/s", "pass", "verdicts"];
    this.result.replaceChildren(dataTable("One deviation at a time", heads, rows));
    this.say(judged.headline);
    this.said.dataset.passes = judged.passes;
  }

  exportDone({ name, text, base64 }) {
    const bytes = base64 ? Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)) : text;
    const blob = new Blob([bytes], { type: "application/octet-stream" });
    window.cagelessSave(blob, name);
    this.say(name + " saved, " + blob.size + " bytes");
  }
}
