// Map of the estimate over axial span and half angle, with the raceway as a point to be moved.

const MAP_POINTS = [31, 25];
const MAP_REFINED = [17, 17];
const MAP_RATIO = 0.86;
const MAP_REGIONS = [
  ["pass", "passes the estimate", [0, 158, 115, 150]],
  ["separation", "too shallow: β0 below what even spacing needs", [86, 180, 233, 90]],
  ["sliding", "too steep: balls slide", [230, 159, 0, 110]],
  ["both-neighbours", "too long: double collisions", [204, 121, 167, 120]],
  ["stress", "contact pressure too high", [213, 94, 0, 130]],
  ["unjudged", "no static equilibrium", [128, 128, 128, 60]],
  ["impossible", "impossible (hatched)", [128, 128, 128, 170]],
];

// Values of lC and θ with what the engine found at them, interpolated between them.
class MapGrid {
  constructor(spans, angles, { beta0_deg, margins, possible }) {
    Object.assign(this, { spans, angles, beta0_deg, margins, ranges: possible });
    this.filled = Object.fromEntries(Object.entries({ beta0: beta0_deg, ...margins }).map(([name, rows]) => [name, filled(rows)]));
    this.terms = Object.keys(margins);
  }

  // Cell and share of it at lC, θ; null outside.
  cell(span, angle) {
    const along = (values, v) => {
      const n = values.length - 1, part = (v - values[0]) / (values[n] - values[0]) * n;
      return part >= -1e-9 && part <= n + 1e-9 ? [Math.max(0, Math.min(n - 1, Math.floor(part))), part - Math.max(0, Math.min(n - 1, Math.floor(part)))] : null;
    };
    const k = along(this.spans, span), j = along(this.angles, angle);
    return k && j ? { k: k[0], u: k[1], j: j[0], v: j[1] } : null;
  }

  value(name, c) {
    const [low, high] = [this.filled[name][c.j], this.filled[name][c.j + 1]], along = (row) => row[c.k] + (row[c.k + 1] - row[c.k]) * c.u;
    return along(low) + (along(high) - along(low)) * c.v;
  }

  possible(span, c) {
    const [low, high] = [this.ranges[c.j], this.ranges[c.j + 1]];
    // Ends of a range that goes from row to row move evenly between them.
    if (low.length === 1 && high.length === 1) return [0, 1].every((end) => (end ? 1 : -1) * (low[0][end] + (high[0][end] - low[0][end]) * c.v - span) >= -1e-9);
    return (c.v < 0.5 ? low : high).some(([from, to]) => span >= from && span <= to);
  }

  region(span, angle) {
    const c = this.cell(span, angle);
    if (!c) return null;
    if (!this.possible(span, c)) return "impossible";
    if (!this.terms.length) return "unjudged";
    let least = 0, worst = "pass";
    for (const term of this.terms) {
      const margin = this.value(term, c);
      if (!(margin >= least)) { least = margin; worst = term; }
    }
    return worst;
  }
}

// Rows in which the nearest value of the row, or of the row before, stands for what is missing.
function filled(rows) {
  let before = rows.find((row) => row.some((v) => v !== null)) || rows[0];
  return rows.map((row) => {
    const known = row.map((v, k) => (v === null ? -1 : k)).filter((k) => k >= 0);
    const whole = row.map((v, k) => (v !== null ? v : known.length ? row[known.reduce((a, b) => (Math.abs(b - k) < Math.abs(a - k) ? b : a))] : before[k]));
    before = whole;
    return whole;
  });
}

const evenly = (from, to, count) => Array.from({ length: count }, (_, k) => from + (to - from) * k / (count - 1));

class RacewayMap {
  constructor(studio) {
    this.studio = studio;
    this.grids = [];
    this.canvas = element("canvas", { role: "img", "aria-label": "Map of the estimate over axial span and half angle", "data-canvas": "map", onpointerdown: (event) => this.grab(event), onclick: (event) => this.tap(event) });
    this.point = element("div", { class: "point", role: "slider", tabindex: 0, "data-point": true, "aria-orientation": "horizontal", "aria-label": "Raceway in the map: axial span lC and half angle θ, by arrow keys", onpointerdown: (event) => this.grab(event), onkeydown: (event) => this.step(event) });
    this.state = element("div", { class: "state", "data-part": "map", role: "status" });
    this.old = element("p", { class: "old", "data-part": "map-old" }, "Map of the case before the last change; it is computed anew after the verdict.");
    this.legend = element("ul", { class: "legend" },
      ...MAP_REGIONS.map(([id, label, [r, g, b, a]]) => element("li", { "data-region": id }, element("span", { class: "swatch " + id, style: "background-color: rgb(" + [r, g, b].join(" ") + " / " + (a / 255).toFixed(2) + ")" }), label)),
      element("li", {}, element("span", { class: "swatch line" }), "β0 = nominal gap, Eq. (11)"), element("li", {}, element("span", { class: "swatch thin" }), "equal β0"));
    this.root = element("figure", { class: "map" }, element("div", { class: "plane" }, this.canvas, this.point), this.old, this.state, this.legend);
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paint());
  }

  // The case apart from lC and θ, on which the map does not depend.
  apart(toml) {
    return withValue(withValue(toml, "raceway.axial_span_mm", "0"), "raceway.half_angle_deg", "0");
  }

  // Ends of the axes: all possible lC, and θ to well beyond the longest raceway that passes.
  extent(g) {
    const { epsilon_deg, uniform_gap_deg, axial_span_limit_mm } = g.numbers;
    const own = g.raceways[0] ? g.raceways[0].half_angle_deg : 0;
    return [0, 1.08 * axial_span_limit_mm, 0, Math.min(90, Math.max(1.7 * (epsilon_deg + uniform_gap_deg), 1.15 * own))];
  }

  // Whether the map that is shown or under way is that of this case.
  current(toml) {
    const own = this.own();
    return this.apart(toml) === this.computed && (!own || !this.box || own[1] < this.box[3]);
  }

  // Ends the map of another case than this one, and marks it as such.
  expect(toml) {
    if (this.current(toml)) return;
    this.cancel();
    this.root.classList.add("stale");
  }

  // Computes the map of another case: all of it first, then the band that passes.
  async compute(toml) {
    if (this.current(toml)) return;
    this.expect(toml);
    const { studio } = this, extent = this.extent(studio.g);
    const abort = this.abort = new AbortController(), began = performance.now();
    this.computed = this.apart(toml);
    const points = async ([low, high, from, to], [across, up]) => {
      // lC and θ of 0 are no raceways: the axes begin a little beyond.
      const spans = evenly(low || high / 1000, high, across), angles = evenly(from || to / 1000, to, up);
      const axis = (key, values) => ({ key: firstOf(key, studio.g.document), values });
      const found = await studio.engine.request("map", { op: "map", case: toml, across: axis("raceway.axial_span_mm", spans), up: axis("raceway.half_angle_deg", angles) }, { signal: abort.signal });
      return new MapGrid(spans, angles, found);
    };
    try {
      const whole = await points(extent, MAP_POINTS);
      if (abort !== this.abort) return;
      this.box = extent;
      this.grids = [whole];
      this.root.classList.remove("stale");
      this.picture = null;
      this.show();
      const band = this.band(whole);
      if (band) {
        const fine = await points(band, MAP_REFINED);
        if (abort !== this.abort) return;
        this.grids = [fine, whole];
        this.picture = null;
        this.show();
      }
      studio.root.dataset.mapMs = (performance.now() - began).toFixed(0);
    } catch (error) {
      if (abort !== this.abort || error.name === "AbortError") return;
      this.computed = null;
      this.state.textContent = error.message;
    }
  }

  cancel() {
    if (this.abort) this.abort.abort();
    this.abort = null;
    this.computed = null;
  }

  // The part of a grid that passes, one cell wider; null if nothing does.
  band({ spans, angles, margins }) {
    let box = null;
    const terms = Object.values(margins);
    angles.forEach((_angle, j) => spans.forEach((_span, k) => {
      if (!terms.length || terms.some((rows) => rows[j][k] === null || rows[j][k] < 0)) return;
      box = box ? [Math.min(box[0], k), Math.max(box[1], k), Math.min(box[2], j), Math.max(box[3], j)] : [k, k, j, j];
    }));
    if (!box) return null;
    const end = (values, k) => values[Math.max(0, Math.min(values.length - 1, k))];
    return [end(spans, box[0] - 1), end(spans, box[1] + 1), end(angles, box[2] - 1), end(angles, box[3] + 1)];
  }

  region(span, angle) {
    for (const grid of this.grids) {
      const found = grid.region(span, angle);
      if (found) return found;
    }
    return null;
  }

  // --- the point ---

  own() {
    const r = this.studio.g && this.studio.g.raceways[0];
    return r ? [r.axial_span_mm, r.half_angle_deg] : null;
  }

  // The last possible place on the way from the present raceway.
  towards(span, angle) {
    const possible = (s, a) => s > 0 && a > 0 && !["impossible", null].includes(this.region(s, a));
    if (!this.grids.length || possible(span, angle)) return [span, angle];
    const own = this.own();
    if (!own) return null;
    let good = 0, bad = 1;
    const at = (t) => [own[0] + (span - own[0]) * t, own[1] + (angle - own[1]) * t];
    for (let k = 0; k < 12; k++) { const middle = (good + bad) / 2; if (possible(...at(middle))) good = middle; else bad = middle; }
    return at(good);
  }

  move(span, angle, joined) {
    const held = this.towards(span, angle);
    if (!held) return;
    let text = withValue(this.studio.toml, "raceway.axial_span_mm", written(digits(held[0], 3)));
    text = withValue(text, "raceway.half_angle_deg", written(digits(held[1], 2)));
    this.studio.edit(text, joined);
  }

  // A finger on the map itself scrolls the page; a tap moves the point.
  tap(event) {
    if (this.plane && event.pointerType === "touch") this.move(...this.value(event), false);
  }

  grab(event) {
    const touched = event.pointerType === "touch" && event.currentTarget === this.canvas;
    if (!this.plane || event.button > 0 || touched) return;
    event.preventDefault();
    const held = this.point;
    held.focus();
    held.setPointerCapture(event.pointerId);
    // From where it began, by as much as the pointer has moved: the page may shift below it.
    const start = event.currentTarget === this.canvas ? this.value(event) : this.own(), at = [event.clientX, event.clientY];
    let joined = false;
    const to = (moved) => {
      const { wide, high } = this.plane, [low, most, from, until] = this.box;
      this.move(start[0] + (moved.clientX - at[0]) * (most - low) / wide, start[1] - (moved.clientY - at[1]) * (until - from) / high, joined);
      joined = true;
    };
    if (event.currentTarget === this.canvas) to(event);
    const end = () => { held.removeEventListener("pointermove", to); held.removeEventListener("pointerup", end); held.removeEventListener("pointercancel", end); };
    held.addEventListener("pointermove", to);
    held.addEventListener("pointerup", end);
    held.addEventListener("pointercancel", end);
  }

  step(event) {
    const own = this.own(), far = event.shiftKey ? 10 : 1;
    const by = { ArrowLeft: [-0.02, 0], ArrowRight: [0.02, 0], ArrowDown: [0, -0.1], ArrowUp: [0, 0.1], PageDown: [0, -1], PageUp: [0, 1] }[event.key];
    if (!by || !own || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    // Presses in quick succession are one step of undo, and each goes on from the last.
    const again = this.pressed && event.timeStamp - this.pressed.time < 600;
    const from = again ? this.pressed.at : own;
    const to = this.towards(from[0] + by[0] * far, from[1] + by[1] * far) || own;
    this.pressed = { time: event.timeStamp, at: to };
    this.move(...to, again);
  }

  // --- drawing ---

  // lC and θ at the place of a pointer.
  value(event) {
    const { left, top, wide, high } = this.plane, bounds = this.canvas.getBoundingClientRect(), [low, most, from, to] = this.box;
    const share = (v) => Math.max(0, Math.min(1, v));
    return [low + (most - low) * share((event.clientX - bounds.left - left) / wide), to - (to - from) * share((event.clientY - bounds.top - top) / high)];
  }

  show() {
    if (!this.studio.g) return;
    this.paint();
    const own = this.own(), { point } = this;
    point.hidden = !own || !this.box;
    if (!own) { this.state.textContent = this.grids.length ? "Click into the map for a discrete raceway." : ""; return; }
    // A map of another case says nothing about this one.
    const region = this.root.classList.contains("stale") ? null : this.region(...own), known = MAP_REGIONS.find(([id]) => id === region);
    const beta0 = this.studio.g.numbers.beta0_deg;
    const text = "lC " + shown(own[0], 2) + " mm, θ " + shown(own[1], 1) + "°, β0 " + shown(beta0, 3) + "°" + (known ? ": " + known[1] : "");
    const most = this.box ? this.box[1] : this.studio.g.numbers.axial_span_limit_mm;
    for (const [name, value] of Object.entries({ valuemin: 0, valuemax: digits(most, 3), valuenow: digits(own[0], 3), valuetext: text })) point.setAttribute("aria-" + name, value);
    this.state.textContent = text;
  }

  // Regions in pixels, on a canvas of their own.
  regions(wide, high, paper) {
    const image = element("canvas", { width: Math.max(1, Math.round(wide)), height: Math.max(1, Math.round(high)) }), c = image.getContext("2d");
    const data = c.createImageData(image.width, image.height), [low, most, from, to] = this.box;
    const colour = Object.fromEntries(MAP_REGIONS.map(([id, , rgba]) => [id, rgba])), seen = new Set();
    for (let y = 0; y < image.height; y++) {
      for (let x = 0; x < image.width; x++) {
        const region = this.region(low + (most - low) * (x + 0.5) / image.width, to - (to - from) * (y + 0.5) / image.height);
        if (!region) continue;
        seen.add(region);
        // Impossible: hatched.
        if (region === "impossible" && (x + y) % 8 > 2) continue;
        data.data.set(colour[region], 4 * (y * image.width + x));
      }
    }
    c.putImageData(data, 0, 0);
    if (!paper) this.legend.querySelectorAll("[data-region]").forEach((item) => { item.hidden = !seen.has(item.dataset.region); });
    return image;
  }

  // Draws onto the canvas of the page, or onto `target`.
  paint(target = this.canvas) {
    const { g } = this.studio;
    if (!g || (target === this.canvas && !this.canvas.clientWidth)) return;
    const saved = target !== this.canvas, shownRegions = MAP_REGIONS.filter(([id]) => !this.legend.querySelector("[data-region=" + id + "]").hidden);
    const { c, width, height } = context(target, saved ? MAP_RATIO + 0.028 * (shownRegions.length + 3) : MAP_RATIO), k = colours(target);
    const left = 40, top = 20, wide = width - left - 10, high = MAP_RATIO * width - top - 36;
    this.legend.hidden = !this.box;
    if (!this.box) { c.fillStyle = k.soft; c.textAlign = "center"; c.fillText("computing the map …", width / 2, height / 2); return; }
    const [low, most, from, to] = this.box;
    const px = (span) => left + wide * (span - low) / (most - low), py = (angle) => top + high * (to - angle) / (to - from);
    if (!saved) {
      this.plane = { left, top, wide, high };
      if (!this.picture || this.picture.width !== Math.round(wide)) this.picture = this.regions(wide, high);
      c.drawImage(this.picture, left, top, wide, high);
    } else c.drawImage(this.regions(wide, high, true), left, top, wide, high);
    this.contours(c, k, px, py);
    c.strokeStyle = k.soft; c.lineWidth = 1; c.fillStyle = k.soft;
    c.beginPath(); c.moveTo(left, top); c.lineTo(left, top + high); c.lineTo(left + wide, top + high); c.stroke();
    c.textAlign = "center";
    for (const tick of ticks(low, most, 6)) c.fillText(String(tick), px(tick), top + high + 14);
    c.textAlign = "right";
    for (const tick of ticks(from, to, 6)) c.fillText(tick + "°", left - 4, py(tick) + 4);
    c.textAlign = "left"; c.fillText("half angle θ", 4, 12);
    c.textAlign = "right"; c.fillText("axial span lC, mm", left + wide, top + high + 30);
    if (saved) this.words(c, k, shownRegions, left, MAP_RATIO * width + 10, 0.028 * width);
    const own = this.own();
    if (!own) return;
    const [x, y] = [px(own[0]), py(own[1])];
    if (!saved) { this.point.style.left = x + "px"; this.point.style.top = y + "px"; return; }
    c.beginPath(); c.arc(x, y, 6, 0, 2 * Math.PI); c.fillStyle = k.first; c.fill(); c.strokeStyle = k.paper; c.stroke();
  }

  // The legend of a drawing that is saved, one line below the other.
  words(c, k, regions, x, y, step) {
    c.textAlign = "left";
    [...regions, ["line", "thick: β0 = nominal gap, Eq. (11); thin: equal β0"], ["point", "blue point: this raceway"]].forEach(([, text, rgba], n) => {
      if (rgba) {
        c.fillStyle = "rgb(" + rgba.slice(0, 3).join(",") + ")";
        c.globalAlpha = rgba[3] / 255;
        c.fillRect(x, y + n * step, 14, 10);
        c.globalAlpha = 1;
      }
      c.fillStyle = k.ink;
      c.fillText(text, x + 20, y + n * step + 10);
    });
  }

  // Lines of equal β0; the thick one is that of Eq. (11), the gap of evenly spaced balls.
  contours(c, k, px, py) {
    const grid = this.grids[this.grids.length - 1], even = this.studio.g.numbers.uniform_gap_deg;
    const highest = Math.max(0, ...grid.beta0_deg.flat());
    if (!(highest > 0)) return;
    let right = -Infinity;
    for (const level of [...ticks(0, highest, 8).filter((v) => v > 0), even]) {
      let label = null;
      c.strokeStyle = level === even ? k.ink : k.soft;
      c.lineWidth = level === even ? 2.5 : 0.75;
      c.beginPath();
      for (let j = 0; j + 1 < grid.angles.length; j++) {
        for (let i = 0; i + 1 < grid.spans.length; i++) {
          const cuts = this.cuts(grid, i, j, level).map(([span, angle]) => [px(span), py(angle)]);
          for (let n = 0; n + 1 < cuts.length; n += 2) { c.moveTo(...cuts[n]); c.lineTo(...cuts[n + 1]); }
          if (cuts.length && j === Math.floor(0.86 * grid.angles.length)) label = cuts[0];
        }
      }
      c.stroke();
      c.fillStyle = k.ink; c.textAlign = "center";
      if (label && level !== even && label[0] > right) {
        c.fillText(level + "°", label[0], label[1] - 2);
        right = label[0] + 24;
      }
    }
  }

  // Where β0 has a level on the sides of a cell.
  cuts(grid, i, j, level) {
    const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(([a, b]) => [grid.spans[a], grid.angles[b], grid.beta0_deg[b][a]]);
    if (corners.some(([, , v]) => v === null)) return [];
    return corners.flatMap(([span, angle, v], n) => {
      const [span2, angle2, v2] = corners[(n + 1) % 4];
      if ((v < level) === (v2 < level)) return [];
      const t = (level - v) / (v2 - v);
      return [[span + (span2 - span) * t, angle + (angle2 - angle) * t]];
    });
  }
}
