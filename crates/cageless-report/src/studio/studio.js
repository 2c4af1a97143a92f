// The studio: controls, case file, drawings, verdict, comparison. Everything follows from the text
// of the case; the controls change the text.

const QUIET_MS = 350;
const UNDO_MAX = 200;

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
const shown = (value, count = 4) => (value === null || value === undefined || !isFinite(value) ? "–" : Number(value).toFixed(count).replace("-", "\u2212"));

class Studio {
  constructor(root, engine, toml) {
    Object.assign(this, { root, engine, toml, original: toml, undo: [], redo: [], pinned: null });
    this.slow = 500;
    this.now = 0;
    this.playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.build();
    this.motion = new LiveMotion(engine, "motion", () => this.paint(), (error) => this.say("motion", error.message));
    this.motionA = new LiveMotion(engine, "motion-a", () => this.paint(), (error) => this.say("motion", error.message));
    requestAnimationFrame((stamp) => this.tick(stamp));
    new ResizeObserver(() => this.paint()).observe(root);
    this.update();
  }

  // --- the page ---

  build() {
    const part = (name) => element("div", { class: name, "data-part": name });
    this.parts = {};
    const make = (name) => (this.parts[name] = part(name));
    this.canvas = {};
    const canvas = (name, label) => (this.canvas[name] = element("canvas", { role: "img", "aria-label": label, "data-canvas": name }));
    const controls = element("form", { "aria-label": "Values of the case", onsubmit: (e) => e.preventDefault() });
    this.controls = new Map();
    let group = null, fieldset = null;
    for (const control of CONTROLS) {
      if (control.group !== group) {
        group = control.group;
        fieldset = element("fieldset", {}, element("legend", {}, group));
        controls.append(fieldset);
      }
      const id = "studio-" + control.id;
      const title = control.help;
      const name = control.label + (control.unit ? " in " + control.unit : "");
      const range = element("input", { type: "range", id, step: control.step, title, "aria-label": name, "data-range": control.id, oninput: () => this.set(control, Number(range.value), true), onchange: () => { this.set(control, Number(range.value), true); this.sliding = null; } });
      const number = element("input", { type: "number", step: "any", title, "aria-label": name + ", number", "data-number": control.id, onchange: () => this.set(control, Number(number.value), false) });
      const band = element("span", { class: "allowed", "aria-hidden": "true" });
      const row = element("div", { class: "control", "data-control": control.id }, element("label", { for: id, title }, control.label, control.unit ? element("small", {}, " " + control.unit) : ""), number, element("span", { class: "slide" }, band, range));
      fieldset.append(row);
      this.controls.set(control.id, { control, range, number, band, row });
    }
    this.start = element("select", { "aria-label": "Spacing of the balls at the start", "data-start": true, onchange: () => this.edit(withValue(this.toml, "start.gaps", startGaps(this.start.value, this.g))) },
      ...[["uniform", "even"], ["bunched", "half the room in one gap"], ["random-1", "random 1"], ["random-2", "random 2"], ["random-3", "random 3"]].map(([value, label]) => element("option", { value }, label)), element("option", { value: "own", disabled: true }, "as in the file"));
    fieldset.append(element("div", { class: "control" }, element("label", {}, "Start spacing"), this.start));
    this.text = element("textarea", { spellcheck: "false", "aria-label": "Case file in TOML", "data-toml": true, oninput: () => this.edit(this.text.value, true) });
    this.play = button("Pause", () => this.run(!this.playing), { "data-play": true });
    const speed = element("select", { "aria-label": "Slow motion", "data-speed": true, onchange: () => { this.slow = Number(speed.value); } }, ...[2000, 1000, 500, 200, 100].map((v) => element("option", { value: v, selected: v === this.slow }, v + " ×")));
    const file = element("input", { type: "file", accept: ".toml,text/plain", hidden: true, onchange: async () => { if (file.files[0]) this.edit(await file.files[0].text()); file.value = ""; } });
    this.buttons = {
      undo: button("Undo", () => this.back(this.undo, this.redo), { "data-undo": true }),
      redo: button("Redo", () => this.back(this.redo, this.undo), { "data-redo": true }),
    };
    const copy = (label, make) => button(label, async (event) => {
      const text = await make();
      this.copied = text;
      try { await navigator.clipboard.writeText(text); } catch { this.root.dispatchEvent(new CustomEvent("copy-failed")); prompt("Copy this text:", text); }
      event.target.textContent = "Copied";
      setTimeout(() => { event.target.textContent = label; }, 1200);
    });
    const bar = element("div", { class: "bar", role: "toolbar", "aria-label": "Case" }, this.buttons.undo, this.buttons.redo,
      button("As computed", () => this.edit(this.original), { title: "back to the case of this page", "data-original": true }),
      button("Open…", () => file.click()), file, button("Save", () => window.cagelessSave(new Blob([this.toml], { type: "text/plain" }), "case.toml")),
      copy("Copy TOML", () => this.toml), copy("Copy command", () => asCommand(this.toml)), copy("Copy Python", () => asPython(this.toml)),
      copy("Copy link", async () => location.href.split("#")[0] + "#case=" + (await packed(this.toml))));
    const compare = element("div", { class: "bar", role: "toolbar", "aria-label": "Comparison" }, button("Pin as A", () => this.pin(this.toml, "A, pinned"), { "data-pin": true }),
      button("Conventional ring as A", () => this.pin(withoutSection(this.toml, "raceway"), "A, conventional"), { "data-conventional": true }),
      button("Unpin", () => { this.pinned = null; this.motionA.reset(); this.paint(); this.table(); }, { "data-unpin": true }));
    const moving = element("div", { class: "bar" }, this.play, element("label", {}, "slowed down ", speed), button("From the start", () => { this.now = 0; this.paint(); }));
    const views = element("div", { class: "stage" }, element("div", { class: "pair" }, canvas("a", "Bearing A in motion"), canvas("b", "Bearing in motion")), moving, canvas("gaps", "Gap ahead of each ball"), element("div", { class: "pair" }, canvas("depth", "Unrolled groove depth and contact track"), canvas("section", "Section in the middle of the raceway")));
    make("message").setAttribute("role", "alert");
    make("host");
    make("verdict").setAttribute("role", "status");
    this.parts.verdict.className = "lamp";
    make("terms"); make("numbers"); make("table");
    make("motion").className = "moving";
    this.parts.numbers.className = "forms";
    this.root.classList.add("studio");
    this.root.replaceChildren(this.parts.host, element("div", { class: "columns" },
      element("div", {}, controls, bar, this.parts.message, this.text),
      element("div", {}, this.parts.verdict, this.parts.terms, views, this.parts.motion, this.parts.numbers, compare, this.parts.table)));
    this.root.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.target === this.text) return;
      const key = event.key.toLowerCase();
      if (key === "z" && !event.shiftKey) { this.back(this.undo, this.redo); event.preventDefault(); }
      if (key === "y" || (key === "z" && event.shiftKey)) { this.back(this.redo, this.undo); event.preventDefault(); }
    });
  }

  say(part, text) { this.parts[part].textContent = text || ""; }

  host(engine, changed) {
    this.say("host", "Computed " + engine.name + (changed ? ". The server has ended: the page goes on by itself." : "."));
  }

  // --- changes ---

  set(control, value, sliding) {
    if (!this.g || !isFinite(value)) return;
    const held = sliding ? this.nearestPossible(control, value) : value;
    let text = this.toml;
    for (const [key, v] of Object.entries(control.keys(held, this.g))) {
      text = withValue(text, key, written(control.whole ? Math.round(v) : digits(v, 6)));
    }
    // A list of gaps belongs to one number of balls and one ball diameter.
    if (control.group === "Bearing" && Array.isArray(this.g.document.start.gaps)) text = withValue(text, "start.gaps", "\"uniform\"");
    // One movement of a slider is undone as one.
    const joined = sliding && this.sliding === control.id;
    this.sliding = sliding ? control.id : null;
    this.edit(text, joined);
    if (sliding) this.controls.get(control.id).range.value = held;
  }

  // A slider stops at the end of what is possible.
  nearestPossible(control, value) {
    const ranges = this.ranges && this.ranges[control.id];
    if (!ranges || !ranges.length || ranges.some(([low, high]) => value >= low && value <= high)) return value;
    const ends = ranges.flat();
    const near = ends.reduce((a, b) => (Math.abs(b - value) < Math.abs(a - value) ? b : a));
    const inward = ranges.some(([low]) => low === near) ? Math.ceil : Math.floor;
    const scale = 10 ** decimals(control);
    const rounded = inward(near * scale) / scale;
    return ranges.some(([low, high]) => rounded >= low && rounded <= high) ? rounded : near;
  }

  // Takes a new text; `joined` changes are undone together with the one before.
  edit(text, joined = false) {
    if (text === this.toml) return;
    if (!joined || !this.undo.length) {
      this.undo.push(this.toml);
      if (this.undo.length > UNDO_MAX) this.undo.shift();
    }
    this.redo.length = 0;
    this.toml = text;
    this.update();
  }

  back(from, to) {
    if (!from.length) return;
    to.push(this.toml);
    this.toml = from.pop();
    this.update();
  }

  // --- computing ---

  async update() {
    if (this.text.value !== this.toml) this.text.value = this.toml;
    this.buttons.undo.disabled = !this.undo.length;
    this.buttons.redo.disabled = !this.redo.length;
    if (this.busy) { this.again = true; return; }
    this.busy = true;
    const toml = this.toml, began = performance.now();
    clearTimeout(this.quiet);
    if (this.judging) this.judging.abort();
    try {
      const g = await this.engine.request("quick", { op: "geometry", case: toml });
      this.g = g;
      this.say("message", "");
      this.text.removeAttribute("aria-invalid");
      this.judged = null;
      this.show();
      this.root.dataset.estimateMs = (performance.now() - began).toFixed(1);
      this.quiet = setTimeout(() => this.settle(toml), QUIET_MS);
    } catch (error) {
      if (error.name !== "AbortError") {
        this.say("message", error.message);
        this.text.setAttribute("aria-invalid", "true");
        this.motion.reset();
      }
    }
    this.busy = false;
    if (this.again) { this.again = false; this.update(); }
  }

  // What takes longer, once the reader has paused: ranges, motion, verdict, link.
  async settle(toml) {
    packed(toml).then((code) => { if (toml === this.toml && toml !== this.original) history.replaceState(null, "", "#case=" + code); });
    this.now = 0;
    this.say("motion", "");
    this.motion.start(toml, this.g.numbers.rolling_orbit_ms / 1000);
    if (this.pinned) this.motionA.start(this.pinned.toml, this.pinned.g.numbers.rolling_orbit_ms / 1000);
    const g = this.g;
    this.engine.request("ranges", rangesRequest(toml, g)).then((ranges) => { if (g === this.g) { this.ranges = ranges; this.shade(); } }, (error) => { if (error.name !== "AbortError") this.say("message", error.message); });
    if (!g.raceways.length) { this.judged = { passes: null, headline: "not judged: the outer ring has no discrete raceway" }; this.show(); return; }
    const judging = this.judging = new AbortController();
    const began = performance.now();
    try {
      const judged = await this.engine.request("verdict", { op: "verdict", case: toml }, {
        signal: judging.signal,
        onProgress: (fraction) => { if (judging === this.judging) this.progress(fraction); },
      });
      if (judging !== this.judging) return;
      this.judged = judged;
      this.root.dataset.verdictMs = (performance.now() - began).toFixed(0);
      this.show();
    } catch (error) {
      if (judging === this.judging && error.name !== "AbortError") { this.judged = { passes: null, headline: error.message }; this.show(); }
    }
  }

  progress(fraction) {
    const bar = this.parts.verdict.querySelector("progress");
    if (bar) bar.value = fraction;
  }

  // --- showing ---

  show() {
    const g = this.g;
    for (const { control, range, number, row } of this.controls.values()) {
      const value = control.read(g);
      row.classList.toggle("absent", value === undefined);
      range.disabled = number.disabled = value === undefined;
      if (value === undefined) continue;
      const [low, high] = control.range(g);
      range.min = low; range.max = high;
      range.value = value;
      if (document.activeElement !== number) number.value = digits(value, decimals(control) + 2);
      range.setAttribute("aria-valuetext", shown(value, decimals(control)) + " " + control.unit);
    }
    const gaps = g.document.start.gaps;
    this.start.value = gaps === "uniform" ? "uniform" : [...this.start.options].map((o) => o.value).find((v) => v !== "own" && startGaps(v, g) === "[" + [].concat(gaps).join(", ") + "]") || "own";
    this.shade();
    this.lamp();
    const n = g.numbers;
    this.parts.numbers.replaceChildren(element("dl", {}, ...[
      ["ε", shown(n.epsilon_deg) + "°", "angle of a ball, Eq. (10)"], ["gap 360°/N − ε", shown(n.uniform_gap_deg) + "°", ""],
      ["β0, Eq. (11)", shown(n.beta0_deg) + "°", "gap that a passage without slip closes"], ["gap outside the raceway", shown(n.steady_gap_deg) + "°", "steady state"],
      ["lC at most, Eq. (8)", shown(n.axial_span_limit_mm, 3) + " mm", ""], ["θ of Eq. (11)", shown(n.half_angle_deg_for_span, 3) + "°", "for this lC"],
      ["ring displacement", g.static.error ? "–" : shown(g.static.ring_y_um, 2) + " µm", "static"], ["largest contact stress", g.static.error ? "–" : shown(Math.max(g.static.inner_stress_max_gpa, g.static.outer_stress_max_gpa), 3) + " GPa", "static"],
    ].map(([name, value, title]) => element("div", { title }, element("dt", {}, name), element("dd", {}, value)))));
    if (g.static.error) this.say("message", g.static.error);
    this.paint();
    this.table();
  }

  shade() {
    for (const { control, range, band } of this.controls.values()) {
      const ranges = this.ranges && this.ranges[control.id];
      if (!ranges || !this.g) { band.style.background = ""; continue; }
      const low = Number(range.min), high = Number(range.max);
      const percent = (v) => (100 * (v - low) / (high - low)).toFixed(2) + "%";
      const bad = "var(--impossible)", stops = [bad + " 0%"];
      for (const [from, to] of ranges) stops.push(bad + " " + percent(from), "transparent " + percent(from), "transparent " + percent(to), bad + " " + percent(to));
      band.style.background = "linear-gradient(90deg, " + stops.join(", ") + ", " + bad + " 100%)";
    }
  }

  lamp() {
    const { g, judged } = this, lamp = this.parts.verdict, estimate = g.estimate;
    const passes = judged ? judged.passes : estimate && g.raceways.length ? estimate.passes : null;
    lamp.className = "lamp judged " + (passes === null ? "unjudged" : passes ? "pass" : "fail") + (judged ? "" : " estimated");
    lamp.dataset.kind = judged ? "simulated" : "estimate";
    if (judged) lamp.replaceChildren((passes === null ? "" : passes ? "✔ " : "✘ ") + judged.headline);
    else lamp.replaceChildren((passes ? "✔ " : passes === null ? "" : "✘ ") + "Estimate from closed forms: " + (passes === null ? "nothing to judge" : passes ? "passes" : "fails"), g.raceways.length ? element("progress", { max: 1, value: 0, "aria-label": "Simulated verdict" }) : "");
    const rows = judged && judged.criteria && judged.criteria.length
      ? judged.criteria.map((c) => [c.name, c.value, c.limit, c.margin, c.text])
      : ((estimate && estimate.terms) || []).map((t) => [t.name, t.value, t.limit, t.margin, t.meaning]);
    this.parts.terms.replaceChildren(element("table", {}, element("caption", {}, judged && judged.criteria && judged.criteria.length ? "Simulated" : "Estimated"), element("thead", {}, element("tr", {}, ...["criterion", "value", "limit", "margin"].map((h, k) => element("th", { scope: "col", class: k ? "num" : "" }, h)))),
      element("tbody", {}, ...rows.map(([name, value, limit, margin, title]) => element("tr", { title, class: margin < 0 ? "missed" : "met" }, element("td", {}, name), ...[value, limit, margin].map((v) => element("td", { class: "num" }, shown(v, 3))))))));
  }

  // --- A against B ---

  async pin(toml, name) {
    try {
      const g = await this.engine.request("quick", { op: "geometry", case: toml });
      const pinned = this.pinned = { toml, name, g, judged: toml === this.toml ? this.judged : null };
      this.now = 0;
      this.motionA.start(toml, g.numbers.rolling_orbit_ms / 1000);
      this.table();
      if (!pinned.judged && g.raceways.length) {
        pinned.judged = await this.engine.request("verdict-a", { op: "verdict", case: toml });
        if (pinned === this.pinned) this.table();
      }
    } catch (error) { if (error.name !== "AbortError") this.say("message", error.message); }
  }

  table() {
    const a = this.pinned;
    this.root.classList.toggle("comparing", !!a);
    if (!a || !this.g) { this.parts.table.replaceChildren(); return; }
    const b = { g: this.g, judged: this.judged };
    const value = (of) => [a, b].map((x) => { try { const v = of(x); return v === null || v === undefined ? NaN : v; } catch { return NaN; } });
    const lines = [
      ["lC, mm", (x) => x.g.raceways[0].axial_span_mm, 0], ["θ, °", (x) => x.g.raceways[0].half_angle_deg, 0], ["balls", (x) => x.g.bearing.balls, 0],
      ["speed, rpm", (x) => x.g.document.operation.inner_speed_rpm, 0], ["load, N", (x) => x.g.document.operation.radial_load_n, 0], ["gap 360°/N − ε, °", (x) => x.g.numbers.uniform_gap_deg, 0],
      ["β0, °", (x) => x.g.numbers.beta0_deg, 0], ["largest contact stress, GPa", (x) => Math.max(x.g.static.inner_stress_max_gpa, x.g.static.outer_stress_max_gpa), -1],
      ["critical gap, °", (x) => x.judged.critical_gap_deg, 1], ["contacts per passage", (x) => x.judged.passages.collisions_mean, -1],
      ["passages hit from both sides, %", (x) => 100 * x.judged.passages.double_collision_fraction, -1], ["slip in a passage, m/s", (x) => x.judged.passages.slip_mean_m_s, -1],
    ];
    const rows = lines.map(([name, of, better]) => {
      const [va, vb] = value(of), difference = vb - va;
      const word = !better || !difference || !isFinite(difference) ? "" : Math.sign(difference) === better ? "better" : "worse";
      return element("tr", { class: word }, element("th", { scope: "row" }, name), ...[va, vb, difference].map((v) => element("td", { class: "num" }, isFinite(v) ? String(Number(v.toPrecision(5))).replace("-", "\u2212") : "–")), element("td", {}, word));
    });
    const verdict = element("tr", {}, element("th", { scope: "row" }, "verdict"), ...[a, b].map((x) => element("td", {}, x.judged ? x.judged.label || "not judged" : x.g.raceways.length ? "computing" : "not judged")), element("td"), element("td"));
    this.parts.table.replaceChildren(element("div", { class: "scroll" }, element("table", {}, element("caption", {}, a.name + ", against B, this case"), element("thead", {}, element("tr", {}, ...["", "A", "B", "B − A", ""].map((h) => element("th", { scope: "col" }, h)))), element("tbody", {}, verdict, ...rows))));
  }

  // --- motion ---

  run(on) {
    this.playing = on;
    this.paint();
  }

  tick(stamp) {
    if (this.playing && this.stamp && this.motion.frames.length) {
      this.now += Math.min(100, stamp - this.stamp) / 1000 / this.slow;
      this.now = Math.min(Math.max(this.now, this.motion.first), this.motion.last);
      this.paint();
    }
    this.stamp = stamp;
    requestAnimationFrame((next) => this.tick(next));
  }

  paint() {
    if (!this.g) return;
    this.play.textContent = this.playing ? "Pause" : "Play";
    const frame = this.motion.frames.length ? this.motion.at(this.now) : null;
    this.frame = frame;
    drawBearing(this.canvas.b, this.g, frame, this.pinned ? "B" : "");
    drawGaps(this.canvas.gaps, this.g, frame);
    if (this.drawn !== this.g || this.width !== this.root.clientWidth) {
      drawDepth(this.canvas.depth, this.g);
      drawSection(this.canvas.section, this.g);
      this.drawn = this.g;
      this.width = this.root.clientWidth;
    }
    if (this.pinned) drawBearing(this.canvas.a, this.pinned.g, this.motionA.frames.length ? this.motionA.at(this.now) : null, this.pinned.name);
  }
}

async function openStudio(root) {
  const read = (name) => { const el = root.querySelector("script[data-" + name + "]"); return el ? el.textContent : ""; };
  const given = JSON.parse(read("case")), base64 = read("engine").trim(), worker = document.querySelector("script[data-worker]").textContent;
  const token = new URLSearchParams(location.search).get("token");
  const server = token && location.protocol.startsWith("http") ? new ServerEngine(token) : null;
  let page = null, why = "";
  if (base64) {
    try { page = await PageEngine.open(base64, worker); } catch (error) { why = "this browser cannot run the engine (" + error.message + ")"; }
  } else why = "Cageless was built without the target wasm32-unknown-unknown, so this page has no engine of its own";
  if (!server && !page) {
    root.textContent = "Nothing can be changed here: " + why + ". The command cageless studio computes natively.";
    root.classList.add("note", "warning");
    return;
  }
  let toml = given;
  const linked = /[#&]case=([\w-]+)/.exec(location.hash);
  if (linked) { try { toml = await unpackedText(linked[1]); } catch { /* a link that was cut off */ } }
  let studio = null;
  const told = [];
  const engine = new Engine(server, page, (host, changed) => { if (studio) studio.host(host, changed); else told.push([host, changed]); });
  studio = new Studio(root, engine, toml);
  studio.original = given;
  told.forEach(([host, changed]) => studio.host(host, changed));
  window.cagelessStudio = studio;
}

// In a report the studio waits until its reader asks for it.
for (const root of document.querySelectorAll("[data-studio]")) {
  // A link to a changed case opens it at once.
  if (root.dataset.studio === "now" || location.hash.startsWith("#case=")) openStudio(root);
  else root.append(button("Change values of this case", (event) => { event.target.remove(); openStudio(root); }, { "data-open": true }));
}
