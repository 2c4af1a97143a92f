// A rotor that falls onto the inner ring: the rotor in the bore, speeds, loads.

// Air gap as drawn, mm: real ones would not be seen.
const DRAWN_GAP_MM = 1.2;
const HISTORY_MAX = 3000;
const TRAIL = 240;
// Bore over groove radius of an inner ring whose bore is not given.
const BORE = 0.82;

// The case at rest with the assumed rotor of the engine in its inner ring.
function withRotor(text, g, rotor) {
  let drop = text;
  for (const section of ["solver", "housing", "search"]) drop = without(drop, section);
  drop = without(drop, "operation", ["inner_speed_rpm", "radial_load_n", "axial_load_n", "tilt_x_mrad", "tilt_y_mrad", "moment_x_n_m", "moment_y_n_m"]);
  drop = without(drop, "start", ["state", "ring_x_um", "ring_y_um"]);
  drop = without(drop, "model", ["formulation"]);
  drop = without(drop, "bearing", ["inner_ring_damping_n_s_m"]);
  const { bearing } = g.document, groove = g.bearing.inner_radius_mm;
  const bore = bearing.inner_ring_bore_radius_mm || digits(BORE * groove, 2);
  const inertia = 0.5e-6 * bearing.inner_ring_mass_kg * (bore * bore + groove * groove);
  drop = withValue(drop, "bearing.inner_ring_bore_radius_mm", bore);
  if (!bearing.inner_ring_polar_inertia_kg_m2) drop = withValue(drop, "bearing.inner_ring_polar_inertia_kg_m2", inertia.toPrecision(3));
  return drop.replace(/\n*$/, "\n\n") + "# Rotor and support are assumptions: replace them by your own."
    + rotor + "\n[solver]\nduration_s = 1.0\n";
}

function drawRotor(canvas, g, frame, trail) {
  const { c, width, height } = context(canvas, 0.9);
  const k = colours(canvas), { rotor } = g, r = frame.rotor;
  const bore = rotor.bore_radius_mm, journal = Math.max(bore - DRAWN_GAP_MM, 0.3 * bore);
  const gap = bore - journal, enlarged = gap / rotor.radial_clearance_um;
  const scale = (Math.min(width, height) / 2 - 22) / g.bearing.inner_radius_mm, x = width / 2, y = height / 2;
  disc(c, x, y, g.bearing.inner_radius_mm * scale, k.ring, k.soft);
  disc(c, x, y, bore * scale, k.paper, k.soft);
  // Marks that turn with ring and rotor; angles from +X, counter-clockwise.
  const mark = (angle, ends, px, py, colour, wide = 2) => lineThrough(c, ends.map((r) => [px + r * scale * Math.cos(angle), py - r * scale * Math.sin(angle)]), colour, wide);
  mark(frame.ring_rad, [bore, g.bearing.inner_radius_mm], x, y, k.first);
  const place = (um) => [x + um[0] * enlarged * scale, y - um[1] * enlarged * scale];
  const [jx, jy] = place(r.journal_um);
  c.globalAlpha = 0.85; disc(c, jx, jy, journal * scale, "#f3e3d3", "#946200"); c.globalAlpha = 1;
  mark(r.angle_deg[0] * RAD, [0.55 * journal, journal], jx, jy, "#946200");
  // The clearance circle, which the centre of the journal leaves only into the ring, and its path.
  c.setLineDash([4, 3]); disc(c, x, y, gap * scale, null, k.soft); c.setLineDash([]);
  lineThrough(c, trail.map(place), k.hit, 1.2);
  disc(c, jx, jy, 3, k.hit);
  if (r.force_n[0] > 0) {
    const long = 10 + 22 * Math.min(1, r.force_n[0] / (30 * rotor.weight_n));
    mark(Math.atan2(r.journal_um[1], r.journal_um[0]), [bore, bore + long / scale], x, y, k.hit, 4);
  }
  c.fillStyle = k.soft; c.textAlign = "left";
  c.fillText("touch-down clearance " + rotor.radial_clearance_um.toFixed(0) + " µm, enlarged " + (enlarged * 1000).toFixed(0) + " ×", 4, 12);
  c.fillText("t = " + (frame.t * 1000).toFixed(2) + " ms", 4, height - 5);
  c.textAlign = "right"; c.fillText(r.force_n[0].toFixed(0) + " N = " + (r.force_n[0] / rotor.weight_n).toFixed(1) + " × weight", width - 4, height - 5);
}

// Speeds and contact force over the time so far.
function drawDrop(canvas, g, history, now) {
  const { c, width, height } = context(canvas, 0.9);
  const k = colours(canvas), left = 44, right = width - 8, last = Math.max(1e-4, history.length ? history[history.length - 1].t : 0);
  const px = (t) => left + (right - left) * t / last;
  const panel = (top, bottom, label, most, curves) => {
    const py = (v) => bottom - (bottom - top) * v / most;
    c.fillStyle = k.soft; c.textAlign = "left"; c.fillText(label, left, top - 6);
    c.textAlign = "right";
    for (const tick of ticks(0, most, 4)) { c.fillText(String(tick), left - 4, py(tick) + 4); c.fillRect(left, py(tick), 4, 1); }
    c.textAlign = "center";
    for (const tick of ticks(0, 1000 * last, 5)) { c.fillRect(px(tick / 1000), bottom - 4, 1, 4); c.fillText(String(tick), px(tick / 1000), bottom + 13); }
    for (const [colour, of] of curves) lineThrough(c, history.map((h) => [px(h.t), py(of(h))]), colour, 1.5);
    c.strokeStyle = k.rule; c.lineWidth = 1; c.strokeRect(left, top, right - left, bottom - top);
    lineThrough(c, [top, bottom].map((y) => [px(now), y]), k.ink);
  };
  const middle = height / 2;
  const fastest = Math.max(1, ...history.map((h) => Math.max(h.rotor, h.ring)));
  const largest = Math.max(1, ...history.map((h) => h.force)) / g.rotor.weight_n;
  panel(20, middle - 16, "rotor (brown), inner ring (blue), rpm", fastest, [["#946200", (h) => h.rotor], [k.first, (h) => h.ring]]);
  panel(middle + 18, height - 30, "contact force over weight", Math.max(largest, 1), [[k.hit, (h) => h.force / g.rotor.weight_n]]);
  c.fillStyle = k.soft; c.textAlign = "right"; c.fillText("time, ms", right, height - 4);
}

// Force of each ball at the inner (blue) and the outer raceway (orange).
function drawLoads(canvas, g, frame, peak) {
  const { c, width, height } = context(canvas, 0.3);
  const k = colours(canvas), left = 8, bottom = height - 18, top = 18, n = frame.inner_force_n.length;
  const step = (width - 16) / n, scale = (bottom - top) / Math.max(1, peak);
  c.fillStyle = k.soft; c.textAlign = "left"; c.fillText("load of each ball: inner (blue) and outer raceway (orange)", left, 11);
  c.textAlign = "right"; c.fillText(peak.toFixed(0) + " N", width - 8, 11);
  for (let i = 0; i < n; i++) {
    [[frame.inner_force_n[i], k.first, 0.12], [frame.outer_force_n[i], k.sector, 0.5]].forEach(([force, colour, at]) => {
      const high = Math.max(0, force) * scale;
      c.fillStyle = colour; c.fillRect(left + (i + at) * step, bottom - high, 0.36 * step, high);
    });
    if (step > 14) { c.fillStyle = k.soft; c.textAlign = "center"; c.fillText(String(i + 1), left + (i + 0.5) * step, height - 4); }
  }
  lineThrough(c, [left, width - 8].map((x) => [x, bottom]), k.ink);
}

class RotorDrop {
  constructor(studio) {
    this.studio = studio;
    const canvas = (name, label) => (this[name] = element("canvas", { role: "img", "aria-label": label, "data-canvas": name }));
    this.offer = button("Drop a rotor", () => this.add(), { "data-drop": true, title: "adds a rotor, its support and the bore of the inner ring, all assumed" });
    this.said = element("p", { class: "moving", "data-part": "rotor", role: "status" });
    const pair = element("div", { style: "display:grid;gap:.6rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,230px),1fr))" },
      canvas("rotor", "Rotor in the bore of the inner ring, touch-down clearance enlarged"), canvas("history", "Speeds and contact force over time"));
    this.numbers = element("div", { class: "forms", "data-part": "drop-numbers" });
    this.views = element("div", { hidden: true }, pair, this.numbers, canvas("loads", "Load of each ball"));
    this.root = element("div", { class: "drop" }, element("div", { class: "bar" }, this.offer), this.said, this.views);
    this.reset();
  }

  // The case with a rotor in it.
  async text() {
    const { studio } = this, about = await studio.about;
    return withRotor(studio.toml, studio.g, about.drop);
  }

  async add() { this.studio.edit(await this.text()); }

  reset() {
    this.record = [];
    this.every = 1;
    this.taken = 0;
    this.peak = 0;
    this.run = null;
    this.touched = null;
  }

  show() {
    const { g } = this.studio;
    this.offer.hidden = !!g.rotor;
    this.views.hidden = !g.rotor;
    this.said.textContent = g.rotor ? "A rotor falls. Its values, those of the support and of the inner ring's bore are assumptions unless you replaced them." : "";
  }

  // Results so far, of the whole drop and not of the moment that is shown.
  showNumbers(g) {
    const last = this.record[this.record.length - 1];
    if (!last) return;
    const force = Math.max(...this.record.map((h) => h.force));
    this.numbers.replaceChildren(element("dl", {}, ...[
      ["simulated", shown(1000 * last.t, 1) + " ms"],
      ["first contact", this.touched === null ? "not yet" : shown(1000 * this.touched, 2) + " ms"],
      ["largest contact force", shown(force, 0) + " N"],
      ["force over rotor weight", shown(force / g.rotor.weight_n, 1)],
      ["rotor", shown(last.rotor, 0) + " rpm"],
      ["inner ring", shown(last.ring, 0) + " rpm"],
      ["largest force of a ball", shown(this.peak, 0) + " N"],
      ...(g.space ? [["rotor along the axis", shown(last.z, 1) + " µm"]] : []),
    ].map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value)))));
  }

  // Takes the frames that are new; of a long drop every second, fourth, … remains.
  follow(motion) {
    if (this.run !== motion.abort) { this.reset(); this.run = motion.abort; }
    const fresh = motion.frames.filter((f) => f.rotor && f.t > this.taken);
    if (!this.record.length && motion.frames.length && motion.frames[0].rotor) fresh.unshift(motion.frames[0]);
    for (const f of fresh) {
      this.peak = Math.max(this.peak, ...f.inner_force_n, ...f.outer_force_n);
      if (this.touched === null && f.rotor.force_n[0] > 0) this.touched = f.t;
      const last = this.record[this.record.length - 1], force = f.rotor.force_n[0];
      if (last && f.t - last.t < 1e-5 * this.every) last.force = Math.max(last.force, force);
      else this.record.push({ t: f.t, rotor: Math.abs(f.rotor.speed_rpm[0]), ring: Math.abs(f.rotor.speed_rpm[1]), force, z: f.rotor.z_um[0] });
      this.taken = f.t;
    }
    if (this.record.length > HISTORY_MAX) {
      this.every *= 2;
      this.record = this.record.filter((h, i) => { const next = this.record[i + 1]; if (i % 2 === 0 && next) h.force = Math.max(h.force, next.force); return i % 2 === 0; });
    }
  }

  // The rotor at a moment; null where none falls.
  move(frame) {
    const { g, motion } = this.studio;
    if (!g || !g.rotor || !frame || !frame.rotor) return null;
    const trail = motion.frames.filter((f) => f.t <= frame.t).slice(-TRAIL).map((f) => f.rotor.journal_um);
    drawRotor(this.rotor, g, frame, trail);
    return frame.rotor;
  }

  // The rotor with its history, its loads and what is said of them.
  paint(frame) {
    const r = this.move(frame), { g, motion } = this.studio;
    if (!r) return;
    this.follow(motion);
    drawDrop(this.history, g, this.record, frame.t);
    // Nothing is loaded while the rotor is in the air.
    this.loads.hidden = !(this.peak > 0);
    if (this.peak > 0) drawLoads(this.loads, g, frame, this.peak);
    this.showNumbers(g);
    const after = this.touched === null || frame.t < this.touched ? "falling freely" : "first contact at " + (1000 * this.touched).toFixed(2) + " ms";
    const said = "rotor " + shown(r.speed_rpm[0], 0) + " rpm, inner ring " + shown(r.speed_rpm[1], 0) + " rpm, " + after + ". Values of rotor, support and bore are assumptions unless you replaced them.";
    if (this.said.textContent !== said) this.said.textContent = said;
  }
}
