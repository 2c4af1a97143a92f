// The studio: controls, case file, drawings, verdict, comparison. Everything follows from the text
// of the case; the controls change the text.

const QUIET_MS = 350;
// Time that a case which was replaced may still take to be settled, ms.
const SOON_MS = 500;
const UNDO_MAX = 200;

class Studio {
  constructor(root, engine, toml) {
    Object.assign(this, { root, engine, toml, original: toml, undo: [], redo: [], g: null, judged: null, ranges: null });
    this.about = engine.request("quick", { op: "about" });
    this.build();
    const failed = (error) => this.say("motion", error.message), arrived = () => { if (!this.stage.playing) this.stage.paint(); };
    this.motion = new LiveMotion(engine, "motion", arrived, failed);
    this.motionA = new LiveMotion(engine, "motion-a", arrived, failed);
    this.update();
  }

  // --- the page ---

  build() {
    this.parts = {};
    const part = (name, attributes = {}) => (this.parts[name] = element("div", { class: name, "data-part": name, ...attributes }));
    this.form = new Form(this);
    this.toolbar = new Toolbar(this);
    this.verdict = new Verdict(this);
    this.stage = new Stage(this);
    this.comparison = new Comparison(this);
    this.map = new RacewayMap(this);
    this.surface = new Surface(this);
    this.drop = new RotorDrop(this);
    this.studies = new Studies(this);
    this.saving = new SaveMenu(this);
    this.text = element("textarea", { spellcheck: "false", "aria-label": "Case file in TOML", "data-toml": true, oninput: () => this.edit(this.text.value, true) });
    this.root.classList.add("studio");
    this.root.replaceChildren(part("host"), element("div", { class: "columns" },
      element("div", {}, this.form.root, this.toolbar.root, part("message", { role: "alert" }), this.text),
      element("div", {}, this.verdict.lamp,
        element("div", { class: "stage" }, ...this.stage.bearings, this.map.root, this.comparison.table),
        this.stage.bar, this.comparison.bar, part("motion", { class: "moving" }), this.stage.gaps, this.stage.contacts, this.drop.root,
        this.verdict.terms, this.stage.raceway, this.surface.root, this.verdict.numbers, this.studies.root, this.saving.root)));
  }

  say(part, text) { this.parts[part].textContent = text || ""; }

  host(engine, changed) {
    const say = (set) => this.say("host", "Computed " + engine.name + (set ? ", " + set : "") + (changed ? ". The server has ended: the page continues on its own." : "."));
    say();
    this.hosted = engine;
    this.studies.ask().then((about) => { if (this.hosted === engine) say(about.instruction_set); });
  }

  // --- changes ---

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
    this.toolbar.show(this);
    if (this.busy) {
      this.again = true;
      // In space an equilibrium takes up to minutes: that of a case which was replaced ends.
      const { settling } = this;
      setTimeout(() => settling.abort(), SOON_MS);
      return;
    }
    this.busy = true;
    const settling = this.settling = new AbortController();
    const toml = this.toml, began = performance.now();
    clearTimeout(this.quiet);
    if (this.judging) this.judging.abort();
    this.comparison.cancel();
    // What is shown is older than the controls until the answer is there.
    this.root.classList.add("pending");
    try {
      const g = await this.engine.request("quick", { op: "geometry", case: toml }, { signal: settling.signal });
      this.g = g;
      this.good = toml;
      this.impossible = null;
      this.say("message", "");
      this.text.removeAttribute("aria-invalid");
      this.judged = null;
      this.root.classList.remove("impossible");
      this.map.expect(toml);
      this.show();
      this.root.dataset.estimateMs = (performance.now() - began).toFixed(1);
      this.quiet = setTimeout(() => this.settle(toml), QUIET_MS);
    } catch (error) {
      if (error.name !== "AbortError") this.refuse(error, toml);
    }
    this.root.classList.remove("pending");
    this.busy = false;
    if (this.again) { this.again = false; this.update(); }
  }

  // A case that cannot be: what was typed is marked and says why, and no verdict stands.
  refuse(error, toml) {
    this.impossible = error;
    this.judged = null;
    this.say("message", error.message);
    this.text.setAttribute("aria-invalid", "true");
    this.root.classList.add("impossible");
    this.motion.reset();
    this.map.cancel();
    this.verdict.refuse(this.form.refuse(error, toml));
    this.comparison.show();
    this.studies.show();
  }

  // What takes longer, once the reader has paused: link, motion, verdict, and then ranges and map.
  async settle(toml) {
    const { g } = this, { pinned } = this.comparison;
    packed(toml).then((code) => { if (toml === this.toml && toml !== this.original) history.replaceState(null, "", "#case=" + code); });
    this.stage.now = 0;
    this.say("motion", "");
    this.motion.start(toml, g.rolling_orbit_ms / 1000);
    if (pinned) this.motionA.start(pinned.toml, pinned.g.rolling_orbit_ms / 1000);
    if (g.rotor) this.judge({ passes: null, headline: "not judged: a rotor falls; its loads and speeds are below" });
    else if (g.raceways.length) await this.simulate(toml);
    else this.judge({ passes: null, headline: "not judged: the outer ring has no discrete raceway" });
    // The verdict has the processor first.
    if (toml !== this.toml || g !== this.g) return;
    if (!g.rotor) this.map.compute(toml);
    this.comparison.compute();
    this.engine.request("ranges", rangesRequest(toml, g)).then((ranges) => {
      if (g === this.g) { this.ranges = ranges; this.form.shade(); }
    }, (error) => { if (error.name !== "AbortError") this.say("message", error.message); });
  }

  async simulate(toml) {
    const judging = this.judging = new AbortController(), began = performance.now();
    try {
      const judged = await this.engine.request("verdict", { op: "verdict", case: toml }, {
        signal: judging.signal,
        onProgress: (fraction) => { if (judging === this.judging) this.verdict.progress(fraction); },
      });
      if (judging !== this.judging) return;
      this.root.dataset.verdictMs = (performance.now() - began).toFixed(0);
      this.judge(judged);
    } catch (error) {
      if (judging === this.judging && error.name !== "AbortError") this.judge({ passes: null, headline: error.message });
    }
  }

  // --- showing ---

  judge(judged) {
    this.judged = judged;
    this.verdict.show();
    this.comparison.show();
  }

  show() {
    const { g } = this;
    this.form.show(g);
    this.verdict.show();
    if (g.static.error) this.say("message", g.static.error);
    this.drop.show();
    this.map.root.hidden = !!g.rotor;
    this.studies.show();
    this.stage.paint();
    this.surface.paint();
    this.map.show();
    this.comparison.show();
  }
}
