// The menu "Save as": drawings as SVG and PNG, what they show as CSV, the motion as GIF.

const SAVED_WIDTH = 640;
const FILM_WIDTH = 440;
const FILM_FRAMES = 120;
const FILM_HUNDREDTHS = 4;

const asCsv = (heads, rows) => [heads, ...rows].map((row) => row.map((v) => (v === null || v === undefined ? "" : typeof v === "number" ? String(v) : /[",\n]/.test(v) ? '"' + v.replace(/"/g, '""') + '"' : v)).join(",")).join("\n") + "\n";

async function asPng(svg) {
  const image = await window.cagelessPicture(svg);
  const canvas = element("canvas", { width: 2 * image.width, height: 2 * image.height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

class SaveMenu {
  constructor(studio) {
    this.studio = studio;
    const { stage } = studio;
    const frame = () => stage.frame;
    this.things = [
      { id: "bearing", name: "Bearing", draw: (to) => drawBearing(to, studio.g, frame(), ""), film: true, csv: () => this.balls() },
      { id: "gaps", name: "Gaps over time", draw: (to) => drawGaps(to, studio.g, frame()), csv: () => this.gaps() },
      { id: "map", name: "Map", draw: (to) => studio.map.paint(to), ready: () => studio.map.box, csv: () => this.points() },
      { id: "track", name: "Contact track", draw: (to) => drawDepth(to, studio.g), csv: () => this.track() },
      { id: "section", name: "Section", draw: (to) => drawSection(to, studio.g, frame()) },
      { id: "contacts", name: "Contact angles", draw: (to) => drawContacts(to, studio.g, frame(), studio.stage.track()), ready: () => studio.stage.track().length, csv: () => this.contacts() },
      { id: "depth", name: "Groove depth", draw: (to) => studio.surface.paint(to), csv: () => this.depth() },
      { id: "terms", name: "Criteria", csv: () => asCsv(["criterion", "kind", "value", "limit", "margin"], studio.verdict.rows().rows.map(({ name, value, limit, margin }) => [name, studio.verdict.rows().kind, value, limit, margin])) },
      { id: "case", name: "Case file", toml: true },
    ];
    const cell = (thing, format, can) => element("td", {}, can ? button(format.toUpperCase(), (event) => this.save(thing, format, event.target), { "data-saves": thing.id + "." + format, "aria-label": thing.name + " as " + format.toUpperCase() }) : "");
    this.state = element("div", { role: "status", class: "state", "data-part": "saved" });
    this.root = element("details", { class: "save-as", onkeydown: (event) => { if (event.key === "Escape") { this.root.open = false; this.root.firstElementChild.focus(); } } },
      element("summary", {}, "Save as"),
      element("table", {}, element("caption", {}, "White paper, at the moment that is shown"), element("tbody", {}, ...this.things.map((t) => element("tr", {}, element("th", { scope: "row" }, t.name),
        cell(t, "svg", t.draw), cell(t, "png", t.draw), cell(t, t.toml ? "toml" : "csv", t.csv || t.toml), cell(t, "gif", t.film && window.cagelessGif))))), this.state);
  }

  async save(thing, format, pressed) {
    const { studio } = this;
    if (!studio.g || (thing.ready && !thing.ready())) { this.state.textContent = thing.name + ": nothing to save yet"; return; }
    pressed.disabled = true;
    try {
      const blob = await this.file(thing, format);
      if (!blob) return;
      window.cagelessSave(blob, format === "toml" ? "case.toml" : "cageless-" + thing.id + "." + format);
      this.state.textContent = thing.name + " saved, " + Math.ceil(blob.size / 1000) + " kB";
    } catch (error) {
      this.state.textContent = thing.name + " could not be saved: " + (error.message || error);
    } finally { pressed.disabled = false; }
  }

  // The contents of a file; null where there is nothing to be saved.
  async file(thing, format) {
    if (format === "svg") return new Blob([asSvg(thing.draw, SAVED_WIDTH)], { type: "image/svg+xml" });
    if (format === "png") return asPng(asSvg(thing.draw, SAVED_WIDTH));
    if (format === "csv") return new Blob([thing.csv()], { type: "text/csv" });
    if (format === "toml") return new Blob([this.studio.toml], { type: "text/plain" });
    return this.film();
  }

  // --- what is shown, in columns ---

  gaps() {
    const { frames } = this.studio.motion;
    return asCsv(["time_s", ...Array.from({ length: frames.length ? frames[0].gap_deg.length : 0 }, (_, k) => "gap_" + (k + 1) + "_deg")], frames.map((f) => [f.t, ...f.gap_deg]));
  }

  balls() {
    const { frames } = this.studio.motion;
    return asCsv(["time_s", "ball", "angle_deg", "gap_deg", "inner_force_n", "outer_force_n", "outer_sliding_m_s", "ring_x_um", "ring_y_um"],
      frames.flatMap((f) => f.angle_deg.map((angle, k) => [f.t, k + 1, angle, f.gap_deg[k], f.inner_force_n[k], f.outer_force_n[k], f.sliding_m_s[k], ...f.ring_um])));
  }

  track() {
    const r = this.studio.g.raceways[0];
    return asCsv(["angle_deg", "effective_radius_mm", "axial_mm", "other_axial_mm"], r ? r.angle_deg.map((angle, k) => [angle, r.effective_radius_mm[k], ...r.track_mm.map((z) => z[k])]) : []);
  }

  contacts() {
    const heads = ["outer", "other_flank", "inner"].flatMap((name) => [name + "_angle_deg", name + "_half_length_deg"]);
    return asCsv(["time_s", "ball", "angle_deg", ...heads], this.studio.motion.frames.flatMap((f) => f.angle_deg.map((psi, ball) => [f.t, ball + 1, psi, ...contactsOf(f.space, ball).flatMap(([angle, reach]) => (reach ? [angle, reach] : [null, null]))])));
  }

  depth() {
    const r = this.studio.g.raceways[0];
    return asCsv(["angle_deg", "axial_mm", "depth_um"], r ? r.angle_deg.flatMap((angle, k) => (r.across_mm[k] || []).map((z, j) => [angle, z, r.depth_um[k][j]])) : []);
  }

  points() {
    const { grids, axes } = this.studio.map, { terms } = grids[grids.length - 1];
    return asCsv([...axes.map((axis) => axis.key.split(".")[1]), "beta0_deg", ...terms.map((term) => "margin_" + term.replace("-", "_"))],
      grids.flatMap((grid) => grid.up.flatMap((y, j) => grid.across.map((x, k) => [x, y, grid.beta0_deg[j][k], ...terms.map((term) => (grid.margins[term] || [])[j]?.[k])]))));
  }

  // The last frames of the motion, bearing and gaps, as GIF.
  async film() {
    const { studio } = this, { pinned } = studio.comparison, { motion, motionA, g } = studio;
    const frames = motion.frames.slice(-FILM_FRAMES);
    if (!frames.length) { this.state.textContent = "There is no motion yet"; return null; }
    const canvas = () => Object.assign(element("canvas"), { light: true, fixedWidth: FILM_WIDTH });
    const sheets = { a: canvas(), b: canvas(), gaps: canvas() };
    let film = null, whole = null;
    for (const [k, frame] of frames.entries()) {
      drawBearing(sheets.b, g, frame, pinned ? "B" : "");
      drawGaps(sheets.gaps, g, frame);
      if (pinned) drawBearing(sheets.a, pinned.g, motionA.frames.length ? motionA.at(frame.t) : null, pinned.name);
      if (!film) {
        whole = element("canvas", { width: FILM_WIDTH * (pinned ? 2 : 1), height: sheets.b.height + sheets.gaps.height }).getContext("2d", { willReadFrequently: true });
        film = window.cagelessGif(whole.canvas.width, whole.canvas.height, FILM_HUNDREDTHS);
      }
      whole.fillStyle = "#fff";
      whole.fillRect(0, 0, whole.canvas.width, whole.canvas.height);
      if (pinned) whole.drawImage(sheets.a, 0, 0);
      whole.drawImage(sheets.b, whole.canvas.width - FILM_WIDTH, 0);
      whole.drawImage(sheets.gaps, whole.canvas.width - FILM_WIDTH, sheets.b.height);
      film.add(whole.getImageData(0, 0, whole.canvas.width, whole.canvas.height).data);
      if (k % 8 === 7) {
        this.state.textContent = "frame " + (k + 1) + " of " + frames.length;
        await new Promise((done) => setTimeout(done));
      }
    }
    return film.blob();
  }
}
