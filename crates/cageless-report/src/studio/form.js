// The form: one row for each control, possible ranges shaded.

class Form {
  constructor(studio) {
    this.studio = studio;
    this.root = element("form", { "aria-label": "Values of the case", onsubmit: (event) => event.preventDefault() });
    this.rows = new Map();
    this.groups = new Map();
    for (const control of CONTROLS) this.group(control.group).append(this.row(control));
    this.shape = element("select", {
      id: "studio-shape", "data-shape": true,
      onchange: () => studio.edit(withValue(studio.toml, "raceway.shape", written(this.shape.value))),
    });
    this.group("Raceway").append(element("div", { class: "control choice" }, element("label", { for: "studio-shape" }, "Shape"), this.shape));
    studio.about.then((about) => {
      this.shape.append(...about.shapes.map((name) => element("option", { value: name }, name)), ...["measured", "spline"].map((name) => element("option", { value: name, disabled: true }, name + ", as in the file")));
      if (studio.g) this.show(studio.g);
    }, () => {});
    this.materials = MATERIAL_PARTS.map((part) => new MaterialChoice(studio, part));
    this.group("Material").append(...this.materials.map((choice) => choice.root));
    this.start = element("select", {
      id: "studio-start", "data-start": true,
      onchange: () => studio.edit(withValue(studio.toml, "start.gaps", startGaps(this.start.value, studio.g))),
    }, ...START_SPACINGS.map(([value, label]) => element("option", { value }, label)), element("option", { value: "own", disabled: true }, "as in the file"));
    this.group("Operation").append(element("div", { class: "control choice" }, element("label", { for: "studio-start" }, "Start spacing"), this.start));
  }

  group(name) {
    if (!this.groups.has(name)) {
      const fieldset = element("fieldset", {}, element("legend", {}, name));
      this.groups.set(name, fieldset);
      this.root.append(fieldset);
    }
    return this.groups.get(name);
  }

  row(control) {
    const id = "studio-" + control.id, title = control.help;
    const name = control.label + (control.unit ? " in " + control.unit : "");
    const slid = () => this.set(control, Number(range.value), true);
    const range = element("input", {
      type: "range", id, step: control.step, title, "aria-label": name, "data-range": control.id,
      oninput: slid, onchange: () => { slid(); this.sliding = null; },
    });
    const number = element("input", {
      type: "number", step: "any", inputmode: "decimal", title, "aria-label": name + ", number", "data-number": control.id,
      onchange: () => this.set(control, Number(number.value), false),
    });
    const band = element("span", { class: "allowed", "aria-hidden": "true" });
    const why = element("p", { class: "why", id: id + "-why", role: "alert", hidden: true, "data-why": control.id });
    const row = element("div", { class: "control", "data-control": control.id },
      element("label", { for: id, title }, control.label, control.unit ? element("small", {}, " " + control.unit) : ""),
      number, element("span", { class: "slide" }, band, range), why);
    this.rows.set(control.id, { control, range, number, band, row, why });
    return row;
  }

  set(control, value, sliding) {
    const { studio } = this, { g } = studio;
    if (!g || !isFinite(value)) return;
    const held = sliding ? this.nearestPossible(control, value) : value;
    let text = studio.toml;
    for (const [key, v] of Object.entries(control.keys(held, g))) {
      text = withValue(text, key, written(control.whole ? Math.round(v) : digits(v, 6)));
    }
    // A list of gaps belongs to one number of balls and one ball diameter.
    if (control.group === "Bearing" && Array.isArray(g.document.start.gaps)) text = withValue(text, "start.gaps", "\"uniform\"");
    // One movement of a slider is undone as one.
    const joined = sliding && this.sliding === control.id;
    this.sliding = sliding ? control.id : null;
    this.typed = { control, value: held, toml: text };
    studio.edit(text, joined);
    if (sliding) this.rows.get(control.id).range.value = held;
  }

  // Marks the control whose value cannot be, and says why in its words; else the words of the engine.
  refuse(error, toml) {
    const { typed } = this;
    if (!typed || typed.toml !== toml) return error.message;
    const { control, value } = typed, { number, range, why, row } = this.rows.get(control.id), { studio } = this;
    const worded = (v) => minus(String(digits(v, decimals(control) + 2))) + (control.unit ? " " + control.unit : "");
    const own = Object.keys(control.keys(value, studio.g)), reason = error.message.replace(/^case(:\d+)?: /, "");
    const said = control.label + " = " + worded(value) + " is not possible";
    // The reason where the engine speaks of this value; of another key, its whole sentence.
    const told = own.includes(error.key) && own.length === 1 && reason.includes(": ") ? reason.slice(reason.indexOf(": ") + 2) : reason;
    why.textContent = said + ": " + told;
    why.hidden = false;
    row.classList.add("refused");
    for (const input of [number, range]) {
      input.setAttribute("aria-invalid", "true");
      input.setAttribute("aria-describedby", why.id);
    }
    number.value = digits(value, decimals(control) + 2);
    range.value = value;
    this.askRange(typed, said, worded, why);
    return said;
  }

  // What the other values leave for the control that was refused.
  async askRange(typed, said, worded, why) {
    const { studio } = this, { control } = typed, request = rangesRequest(studio.good, studio.g);
    request.controls = request.controls.filter((c) => c.name === control.id);
    try {
      const ranges = (await studio.engine.request("quick", request))[control.id] || [];
      if (this.typed !== typed || !studio.impossible) return;
      const scale = 10 ** decimals(control), allowed = ranges.map(([low, high]) => worded(Math.ceil(low * scale - 1e-6) / scale) + " to " + worded(Math.floor(high * scale + 1e-6) / scale));
      if (allowed.length) why.textContent = said + " with the other values; possible: " + allowed.join(", or ") + ".";
    } catch { /* the reason is there already */ }
  }

  // No control is marked any more.
  accept() {
    for (const { number, range, why, row } of this.rows.values()) {
      why.hidden = true;
      row.classList.remove("refused");
      for (const input of [number, range]) { input.removeAttribute("aria-invalid"); input.removeAttribute("aria-describedby"); }
    }
  }

  // A slider stops at the end of what is possible.
  nearestPossible(control, value) {
    const ranges = this.studio.ranges && this.studio.ranges[control.id];
    if (!ranges || !ranges.length || ranges.some(([low, high]) => value >= low && value <= high)) return value;
    const ends = ranges.flat();
    const near = ends.reduce((a, b) => (Math.abs(b - value) < Math.abs(a - value) ? b : a));
    const inward = ranges.some(([low]) => low === near) ? Math.ceil : Math.floor;
    const scale = 10 ** decimals(control);
    const rounded = inward(near * scale) / scale;
    return ranges.some(([low, high]) => rounded >= low && rounded <= high) ? rounded : near;
  }

  show(g) {
    this.accept();
    for (const { control, range, number, row } of this.rows.values()) {
      const value = control.read(g), absent = typeof value !== "number";
      row.classList.toggle("absent", absent);
      range.disabled = number.disabled = absent;
      if (absent) continue;
      const [low, high] = control.range(g);
      range.min = low; range.max = high;
      range.value = value;
      if (document.activeElement !== number) number.value = digits(value, decimals(control) + 2);
      range.setAttribute("aria-valuetext", shown(value, decimals(control)) + " " + control.unit);
    }
    const { gaps } = g.document.start, known = START_SPACINGS.map(([value]) => value);
    this.start.value = known.find((value) => startGaps(value, g) === (typeof gaps === "string" ? JSON.stringify(gaps) : "[" + [].concat(gaps).join(", ") + "]")) || "own";
    const [first] = g.raceways;
    this.shape.value = first ? first.shape : "";
    this.shape.parentElement.classList.toggle("absent", !first);
    this.materials.forEach((choice) => choice.show(g));
    this.groups.forEach((fieldset) => { fieldset.hidden = !fieldset.querySelector(".control:not(.absent)"); });
    this.shade();
  }

  shade() {
    for (const { control, range, band } of this.rows.values()) {
      const ranges = this.studio.ranges && this.studio.ranges[control.id];
      if (!ranges || !this.studio.g) { band.style.background = ""; continue; }
      const low = Number(range.min), high = Number(range.max);
      const percent = (v) => (100 * (v - low) / (high - low)).toFixed(2) + "%";
      const bad = "var(--impossible)", stops = [bad + " 0%"];
      for (const [from, to] of ranges) stops.push(bad + " " + percent(from), "transparent " + percent(from), "transparent " + percent(to), bad + " " + percent(to));
      band.style.background = "linear-gradient(90deg, " + stops.join(", ") + ", " + bad + " 100%)";
    }
  }
}
