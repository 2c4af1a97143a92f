// The groove as a surface in three dimensions, depth enlarged; drawn while its part is open.

const SURFACE_RATIO = 0.6;

class Surface {
  constructor(studio) {
    this.studio = studio;
    this.turn = -35;
    this.tilt = 35;
    this.canvas = element("canvas", { role: "img", "aria-label": "Deviation from the plain groove as a surface", "data-canvas": "surface", onpointerdown: (event) => this.drag(event) });
    const slider = (name, label, low, high) => element("input", {
      type: "range", min: low, max: high, step: 1, value: this[name], "aria-label": label, "data-surface": name,
      oninput: (event) => { this[name] = Number(event.target.value); this.paint(); },
    });
    this.sliders = { turn: slider("turn", "Turn the surface", -180, 180), tilt: slider("tilt", "Tilt the surface", 5, 90) };
    this.root = element("details", { class: "surface", "data-part": "surface", ontoggle: () => this.paint() }, element("summary", {}, "Groove in three dimensions"),
      this.canvas, element("div", { class: "bar" }, element("label", {}, "turn ", this.sliders.turn), element("label", {}, "tilt ", this.sliders.tilt)));
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paint());
  }

  drag(event) {
    const { canvas } = this;
    let at = [event.clientX, event.clientY];
    follow(canvas, event, (moved) => {
      this.turn = (this.turn + (moved.clientX - at[0]) * 0.5 + 540) % 360 - 180;
      this.tilt = Math.max(5, Math.min(90, this.tilt + (moved.clientY - at[1]) * 0.5));
      at = [moved.clientX, moved.clientY];
      this.sliders.turn.value = this.turn;
      this.sliders.tilt.value = this.tilt;
      this.paint();
    });
  }

  paint(target = this.canvas) {
    const { g } = this.studio;
    if (!g || (target === this.canvas && (!this.root.open || !target.clientWidth))) return;
    drawSurface(target, g, this.turn, this.tilt, this.studio.stage.track());
  }
}

// Deviation from the plain groove over ψ and z, from an oblique view; what is cut away goes down.
function drawSurface(target, g, turn, tilt, frames) {
  const { c, width, height } = context(target, SURFACE_RATIO), k = colours(target), r = g.raceways[0];
  c.fillStyle = k.soft;
  if (!r) { c.textAlign = "center"; c.fillText(NO_GROOVE, width / 2, height / 2); return; }
  const n = r.angle_deg.length, m = r.across_mm[0].length, ends = [r.angle_deg[0], r.angle_deg[n - 1]];
  const [low, high] = extentOf(r), { most, text } = deviations(r);
  const along = (a) => 2 * (a - ends[0]) / (ends[1] - ends[0]) - 1, across = (z) => 2 * (z - low) / (high - low) - 1;
  const [ct, st, cv, sv] = [Math.cos(turn * RAD), Math.sin(turn * RAD), Math.cos(tilt * RAD), Math.sin(tilt * RAD)];
  const size = Math.min(width / 3.4, height / 2.6);
  // x along ψ, y along z, both −1 to 1; u is the deviation as a share of the largest.
  const place = (x, y, u) => {
    const [right, back, up] = [1.3 * x * ct - 0.9 * y * st, 1.3 * x * st + 0.9 * y * ct, -0.35 * u];
    return [width / 2 + size * right, height / 2 - size * (back * sv + up * cv), back * cv - up * sv];
  };
  const points = r.across_mm.map((row, i) => row.map((z, j) => ({ at: place(along(r.angle_deg[i]), across(z), r.depth_um[i][j] / most), depth: r.depth_um[i][j] })));
  const patches = [];
  for (let i = 0; i + 1 < n; i++) {
    for (let q = 0; q + 1 < m; q++) {
      const corners = [points[i][q], points[i + 1][q], points[i + 1][q + 1], points[i][q + 1]];
      patches.push({ corners, far: corners.reduce((sum, p) => sum + p.at[2], 0), depth: corners.reduce((sum, p) => sum + p.depth, 0) / 4 });
    }
  }
  patches.sort((a, b) => b.far - a.far);
  for (const { corners, depth } of patches) {
    c.beginPath();
    corners.forEach(({ at: [x, y] }, index) => c[index ? "lineTo" : "moveTo"](x, y));
    c.closePath();
    c.fillStyle = depthColour(depth / most, k);
    c.fill();
    c.strokeStyle = k.rule; c.lineWidth = 0.4; c.stroke();
  }
  // Tracks of ball 1 on the surface, and the ellipses of all balls at the last of these moments.
  const onSurface = (psi, z) => {
    const i = Math.round((n - 1) * (psi - ends[0]) / (ends[1] - ends[0]));
    const j = r.across_mm[i].reduce((best, v, at) => (Math.abs(v - z) < Math.abs(r.across_mm[i][best] - z) ? at : best), 0);
    return place(along(psi), across(z), r.depth_um[i][j] / most);
  };
  const inside = (f, ball) => { const psi = turned(f.angle_deg[ball] - r.centre_angle_deg); return psi > ends[0] && psi < ends[1] ? psi : null; };
  [0, 1].forEach((flank) => {
    const colour = contactColours(k)[flank];
    lineThrough(c, frames.map((f) => {
      const psi = inside(f, 0), [, reach, z] = f.space.outer[flank];
      return psi !== null && reach[0] > 0 ? onSurface(psi, z[0]) : null;
    }), colour, 1.5);
    const f = frames.at(-1);
    if (f) for (let ball = 0; ball < g.bearing.balls; ball++) {
      const psi = inside(f, ball), [angle, reach, z] = f.space.outer[flank];
      if (psi === null || !reach[ball]) continue;
      const half = g.bearing.ball_radius_mm * reach[ball] * RAD * Math.cos(angle[ball] * RAD);
      lineThrough(c, [-1, -0.5, 0, 0.5, 1].map((end) => onSurface(psi, z[ball] + end * half)), colour, 6);
    }
  });
  // Names stand beside the lower ends of their axes.
  const [middleX, middleY] = place(0, 0, 0);
  const name = (text, x, y) => {
    const front = [1, -1].map((side) => place(x * side, y * side, 0)).sort((a, b) => a[2] - b[2])[0];
    const [dx, dy] = [front[0] - middleX, front[1] - middleY], far = Math.hypot(dx, dy) || 1;
    c.textAlign = dx > 30 ? "left" : dx < -30 ? "right" : "center";
    const half = c.measureText(text).width, reach = front[0] + 10 * dx / far;
    const inside = c.textAlign === "left" ? Math.min(reach, width - half - 4) : c.textAlign === "right" ? Math.max(reach, half + 4) : reach;
    c.fillText(text, inside, Math.min(height - 4, Math.max(28, front[1] + 10 * dy / far + 4)));
  };
  c.fillStyle = k.ink;
  name("ψ " + minus(ends[0].toFixed(1)) + "° to " + ends[1].toFixed(1) + "°", 0, -1);
  name("z " + minus(low.toFixed(1)) + " to " + high.toFixed(1) + " mm", 1, 0);
  c.textAlign = "left";
  c.fillText(text + ", enlarged", 6, 13);
}
