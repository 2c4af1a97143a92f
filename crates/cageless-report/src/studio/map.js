// Map of the estimate over two controls of the raceway, with the raceway as a point to be moved.

const MAP_POINTS = [31, 25];
const MAP_REFINED = [17, 17];
const MAP_RATIO = 0.86;
const MAP_REGIONS = [
  ["pass", "passes the estimate", [0, 158, 115, 150]],
  ["separation", "too shallow: β0 below what even spacing needs", [86, 180, 233, 90]],
  ["depth", "too deep: evenly spaced balls collide", [240, 228, 66, 110]],
  ["sliding", "too steep: balls slide", [230, 159, 0, 110]],
  ["lag", "the contact angle takes the lag", [0, 114, 178, 110]],
  ["both-neighbours", "too long: double collisions", [204, 121, 167, 120]],
  ["stress", "contact pressure too high", [213, 94, 0, 130]],
  ["film-queue", "in oil: slowed balls queue", [0, 75, 60, 130]],
  ["film-outweighs", "in oil: the film spaces the balls more", [120, 85, 40, 120]],
  ["unjudged", "no static equilibrium", [128, 128, 128, 60]],
  ["impossible", "impossible (hatched)", [128, 128, 128, 170]],
];

const MAP_AXES = CONTROLS.filter(({ group }) => group === "Raceway");
// lC and θ: the axes at first, and where there is no raceway, which they make.
const MAP_DEFAULT = MAP_AXES.slice(0, 2);

// Name of an axis within a sentence, and its symbol with a value.
const axisName = ({ label }) => label[0].toLowerCase() + label.slice(1);
const axisValue = (axis, v) => axisName(axis).split(" ").at(-1) + " " + shown(v, decimals(axis)) + (axis.unit === "°" ? "" : " ") + axis.unit;

// Values across and up with what the engine found at them, interpolated between them.
class MapGrid {
  constructor(across, up, { beta0_deg, margins, possible, refused }) {
    Object.assign(this, { across, up, beta0_deg, margins, refused, ranges: possible });
    this.filled = Object.fromEntries(Object.entries(margins).map(([name, rows]) => [name, filled(rows)]));
    this.terms = Object.keys(margins);
  }

  // Cell and share of it at a place; null outside.
  cell(x, y) {
    const along = (values, v) => {
      const n = values.length - 1, part = (v - values[0]) / (values[n] - values[0]) * n, whole = Math.max(0, Math.min(n - 1, Math.floor(part)));
      return part >= -1e-9 && part <= n + 1e-9 ? [whole, part - whole] : null;
    };
    const k = along(this.across, x), j = along(this.up, y);
    return k && j && { k: k[0], u: k[1], j: j[0], v: j[1] };
  }

  value(name, c) {
    const [low, high] = [this.filled[name][c.j], this.filled[name][c.j + 1]], along = (row) => row[c.k] + (row[c.k + 1] - row[c.k]) * c.u;
    return along(low) + (along(high) - along(low)) * c.v;
  }

  possible(x, c) {
    const [low, high] = [this.ranges[c.j], this.ranges[c.j + 1]];
    // Ends of a range that goes from row to row move evenly between them.
    if (low.length === 1 && high.length === 1) return [0, 1].every((end) => (end ? 1 : -1) * (low[0][end] + (high[0][end] - low[0][end]) * c.v - x) >= -1e-9);
    return (c.v < 0.5 ? low : high).some(([from, to]) => x >= from && x <= to);
  }

  // The message of the nearest refused corner of a cell.
  reason({ k, u, j, v }) {
    const nearest = (n, share) => (share < 0.5 ? [n, n + 1] : [n + 1, n]);
    return nearest(j, v).flatMap((row) => nearest(k, u).map((at) => this.refused[row][at])).find(Boolean);
  }

  region(x, y) {
    const c = this.cell(x, y);
    if (!c) return null;
    if (!this.possible(x, c)) return "impossible";
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
    this.chosen = this.axes = MAP_DEFAULT;
    this.selects = [0, 1].map((k) => element("select", { "data-axis": k, onchange: (event) => this.choose(k, event.target.value) }, ...MAP_AXES.map(({ id, label }) => element("option", { value: id }, label))));
    this.canvas = element("canvas", { role: "img", "aria-label": "Map of the estimate", "data-canvas": "map", onpointerdown: (event) => this.grab(event), onclick: (event) => this.tap(event), onpointermove: (event) => this.explain(event) });
    this.point = element("div", { class: "point", role: "slider", tabindex: 0, "data-point": true, "aria-orientation": "horizontal", "aria-label": "Raceway in the map, by arrow keys", onpointerdown: (event) => this.grab(event), onkeydown: (event) => this.step(event) });
    this.state = element("div", { class: "state", "data-part": "map", role: "status" });
    this.old = element("p", { class: "old", "data-part": "map-old" }, "Map of the case before the last change; it is computed anew after the verdict.");
    this.legend = element("ul", { class: "legend" },
      ...MAP_REGIONS.map(([id, label, [r, g, b, a]]) => element("li", { "data-region": id }, element("span", { class: "swatch " + id, style: "background-color: rgb(" + [r, g, b].join(" ") + " / " + (a / 255).toFixed(2) + ")" }), label)),
      element("li", {}, element("span", { class: "swatch line" }), "β0 = nominal gap, Eq. (11)"), element("li", {}, element("span", { class: "swatch thin" }), "equal β0"));
    this.root = element("figure", { class: "map" },
      element("div", { class: "bar" }, ...["Across", "Up"].map((label, k) => element("label", {}, label + " ", this.selects[k]))),
      element("div", { class: "plane" }, this.canvas, this.point), this.old, this.state, this.legend);
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paint());
  }

  // Takes another control for an axis; the two change places if it is that of the other axis.
  choose(k, id) {
    const axis = MAP_AXES.find((a) => a.id === id);
    this.chosen = this.chosen.map((other, n) => (n === k ? axis : other === axis ? this.chosen[k] : other));
    this.turn();
    this.show();
    if (!this.studio.impossible) this.compute(this.studio.good);
  }

  // Axes as they were chosen, of a ring with a raceway; a map over others ends.
  turn() {
    const { g } = this.studio, none = !!g && !g.raceways.length, axes = none ? MAP_DEFAULT : this.chosen;
    this.selects.forEach((select, n) => { select.value = axes[n].id; select.disabled = none; });
    if (axes.every((axis, n) => axis === this.axes[n])) return;
    this.cancel();
    Object.assign(this, { axes, grids: [], box: null, plane: null });
    this.canvas.title = "";
  }

  // The case apart from its values on the axes, on which the map does not depend.
  apart(toml, axes = this.axes) {
    return axes.reduce((text, { key }) => withValue(text, key, "0"), toml);
  }

  // Ends of the axes.
  extent(g) {
    const own = this.own();
    return this.axes.flatMap(({ mapped, range }, k) => {
      const [low, high] = (mapped || range)(g);
      return own ? [Math.min(low, own[k]), Math.max(high, own[k])] : [low, high];
    });
  }

  // Whether the map that is shown or under way is that of this case.
  current(toml) {
    const own = this.own();
    return this.apart(toml) === this.computed && (!own || !this.box || own.every((v, k) => v <= this.box[2 * k + 1]));
  }

  // Ends the map of another case than this one, and marks it as such.
  expect(toml) {
    this.turn();
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
    const points = async (ends, counts) => {
      const [across, up] = this.axes.map(({ key, mapped }, k) => {
        const [low, high] = ends.slice(2 * k);
        // lC and θ of 0 are no raceways: these axes begin a little beyond.
        return { key: firstOf(key, studio.g.document), values: evenly(low || (mapped ? high / 1000 : 0), high, counts[k]) };
      });
      const found = await studio.engine.request("map", { op: "map", case: toml, across, up }, { signal: abort.signal });
      return new MapGrid(across.values, up.values, found);
    };
    const take = (...grids) => {
      Object.assign(this, { grids, picture: null, box: extent });
      this.root.classList.remove("stale");
      this.show();
    };
    try {
      const whole = await points(extent, MAP_POINTS);
      if (abort !== this.abort) return;
      take(whole);
      const band = this.band(whole);
      if (band) {
        const fine = await points(band, MAP_REFINED);
        if (abort !== this.abort) return;
        take(fine, whole);
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
  band({ across, up, margins }) {
    let box = null;
    const terms = Object.values(margins);
    up.forEach((_y, j) => across.forEach((_x, k) => {
      if (!terms.length || terms.some((rows) => rows[j][k] === null || rows[j][k] < 0)) return;
      box = box ? [Math.min(box[0], k), Math.max(box[1], k), Math.min(box[2], j), Math.max(box[3], j)] : [k, k, j, j];
    }));
    if (!box) return null;
    return box.map((at, n) => { const values = n < 2 ? across : up; return values[Math.max(0, Math.min(values.length - 1, at + (n % 2 ? 1 : -1)))]; });
  }

  region(x, y) {
    for (const grid of this.grids) {
      const found = grid.region(x, y);
      if (found) return found;
    }
    return null;
  }

  // Says at an impossible place why it is.
  explain(event) {
    if (!this.plane) return;
    const at = this.value(event), grid = this.grids.find((g) => g.cell(...at));
    const why = !this.root.classList.contains("stale") && this.region(...at) === "impossible" && grid.reason(grid.cell(...at));
    this.canvas.title = (why || "").replace(/^\w+(:\d+)?: /, "");
  }

  // --- the point ---

  own() {
    const { g } = this.studio;
    // lC and θ that the case file leaves to a measured profile are those of the raceway.
    return g && g.raceways.length ? this.axes.map((axis) => axis.read(g) ?? g.raceways[0][axis.key.split(".")[1]]) : null;
  }

  // The last possible place on the way from the present raceway.
  towards(x, y) {
    const possible = (a, b) => !["impossible", null].includes(this.region(a, b));
    if (!this.grids.length || possible(x, y)) return [x, y];
    const own = this.own();
    if (!own) return null;
    let good = 0, bad = 1;
    const at = (t) => own.map((v, k) => v + ([x, y][k] - v) * t);
    for (let k = 0; k < 12; k++) { const middle = (good + bad) / 2; if (possible(...at(middle))) good = middle; else bad = middle; }
    return at(good);
  }

  move(x, y, joined) {
    const held = this.towards(x, y);
    if (!held) return;
    this.studio.edit(this.axes.reduce((text, axis, k) => withValue(text, axis.key, written(digits(held[k], decimals(axis) + 1))), this.studio.toml), joined);
  }

  // A finger on the map itself scrolls the page; a tap moves the point.
  tap(event) {
    if (this.plane && event.pointerType === "touch") this.move(...this.value(event), false);
  }

  grab(event) {
    const touched = event.pointerType === "touch" && event.currentTarget === this.canvas;
    if (!this.plane || event.button > 0 || touched) return;
    event.preventDefault();
    this.point.focus();
    // From where it began, by as much as the pointer has moved: the page may shift below it.
    const start = event.currentTarget === this.canvas ? this.value(event) : this.own(), at = [event.clientX, event.clientY];
    let joined = false;
    const to = (moved) => {
      const { wide, high } = this.plane, [low, most, from, until] = this.box;
      this.move(start[0] + (moved.clientX - at[0]) * (most - low) / wide, start[1] - (moved.clientY - at[1]) * (until - from) / high, joined);
      joined = true;
    };
    if (event.currentTarget === this.canvas) to(event);
    follow(this.point, event, to);
  }

  step(event) {
    const own = this.own(), [across, up] = this.axes, far = event.shiftKey ? 10 : 1;
    const [x, y] = [2 * across.step, up.step];
    const by = { ArrowLeft: [-x, 0], ArrowRight: [x, 0], ArrowDown: [0, -y], ArrowUp: [0, y], PageDown: [0, -10 * y], PageUp: [0, 10 * y] }[event.key];
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

  // Values on the axes at the place of a pointer.
  value({ clientX, clientY }) {
    const { left, top, wide, high } = this.plane, { x, y } = this.canvas.getBoundingClientRect(), [low, most, from, to] = this.box;
    const share = (v) => Math.max(0, Math.min(1, v));
    return [low + (most - low) * share((clientX - x - left) / wide), to - (to - from) * share((clientY - y - top) / high)];
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
    const text = this.axes.map((axis, k) => axisValue(axis, own[k])).join(", ") + ", β0 " + shown(beta0, 3) + "°" + (known ? ": " + known[1] : "");
    const [low, most] = this.box || this.extent(this.studio.g);
    for (const [name, value] of Object.entries({ valuemin: low, valuemax: digits(most, 3), valuenow: digits(own[0], 3), valuetext: text })) point.setAttribute("aria-" + name, value);
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
    const px = (x) => left + wide * (x - low) / (most - low), py = (y) => top + high * (to - y) / (to - from);
    if (!saved) {
      this.plane = { left, top, wide, high };
      if (!this.picture || this.picture.width !== Math.round(wide)) this.picture = this.regions(wide, high);
    }
    c.drawImage(saved ? this.regions(wide, high, true) : this.picture, left, top, wide, high);
    this.contours(c, k, px, py);
    lineThrough(c, [[left, top], [left, top + high], [left + wide, top + high]], k.soft);
    c.fillStyle = k.soft;
    // Degrees stand at the numbers, other units at the name.
    const [across, up] = this.axes.map((axis) => (axis.unit === "°" ? [axisName(axis), "°"] : [axisName(axis) + ", " + axis.unit, ""]));
    c.textAlign = "center";
    for (const tick of ticks(low, most, 6)) c.fillText(minus(tick + across[1]), px(tick), top + high + 14);
    c.textAlign = "right";
    for (const tick of ticks(from, to, 6)) c.fillText(minus(tick + up[1]), left - 4, py(tick) + 4);
    c.textAlign = "left"; c.fillText(up[0], 4, 12);
    c.textAlign = "right"; c.fillText(across[0], left + wide, top + high + 30);
    if (saved) this.words(c, k, shownRegions, left, MAP_RATIO * width + 10, 0.028 * width);
    const own = this.own();
    if (!own) return;
    const [x, y] = [px(own[0]), py(own[1])];
    if (!saved) { this.point.style.left = x + "px"; this.point.style.top = y + "px"; return; }
    disc(c, x, y, 6, k.first, k.paper);
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
      for (let j = 0; j + 1 < grid.up.length; j++) {
        for (let i = 0; i + 1 < grid.across.length; i++) {
          const cuts = this.cuts(grid, i, j, level).map(([x, y]) => [px(x), py(y)]);
          for (let n = 0; n + 1 < cuts.length; n += 2) { c.moveTo(...cuts[n]); c.lineTo(...cuts[n + 1]); }
          if (cuts.length && j === Math.floor(0.86 * grid.up.length)) label = cuts[0];
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
    const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(([a, b]) => [grid.across[a], grid.up[b], grid.beta0_deg[b][a]]);
    if (corners.some(([, , v]) => v === null)) return [];
    return corners.flatMap(([x, y, v], n) => {
      const [x2, y2, v2] = corners[(n + 1) % 4];
      if ((v < level) === (v2 < level)) return [];
      const t = (level - v) / (v2 - v);
      return [[x + (x2 - x) * t, y + (y2 - y) * t]];
    });
  }
}
