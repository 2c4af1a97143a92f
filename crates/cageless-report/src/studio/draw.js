// Drawings of the studio, on canvases that follow their width and the colours of the page.

// Colours of the page, which change with those of the system.
let pageColours = null;
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { pageColours = null; });

// Colours of the page; those of white paper for a drawing that is saved.
const colours = (el) => (el.light ? palette(null) : (pageColours = pageColours || palette(getComputedStyle(el))));

function palette(style) {
  const of = (name, other) => (style && style.getPropertyValue(name).trim()) || other;
  const channels = (name, other) => of(name, other).split(" ").map(Number);
  return {
    ink: of("--ink", "#1f2328"), soft: of("--soft", "#59636e"), rule: of("--rule", "#d8dde3"),
    ring: of("--ring", "#dde3e8"), sector: "#e69f00", hit: "#d55e00", paper: of("--paper", "#fff"),
    first: "#0072b2", second: "#56b4e9", inner: "#009e73", ball: of("--ball", "#f4f5f6"),
    flat: channels("--flat", "238 240 242"), cut: channels("--cut", "178 24 43"), left: channels("--left", "33 102 172"),
  };
}

// Width of a canvas that is not shown: margins still leave something to draw on.
const LEAST_WIDTH = 160;

// Context in CSS pixels with a height in proportion to the width: of a canvas in the page, of one
// of a fixed width, or of what takes its place.
function context(canvas, ratio) {
  const font = "12px Helvetica Neue, Helvetica, Arial, sans-serif";
  if (canvas.begin) {
    const c = canvas.begin(ratio);
    c.font = font;
    return { c, width: c.width, height: c.height };
  }
  const width = canvas.fixedWidth || Math.max(canvas.clientWidth, LEAST_WIDTH), height = Math.round(width * ratio);
  const scale = canvas.fixedWidth ? 1 : window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * scale) || canvas.height !== Math.round(height * scale)) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    canvas.style.height = height + "px";
  }
  // Drawn by the processor: machines without a graphics card imitate one far more slowly.
  const c = canvas.getContext("2d", { willReadFrequently: true });
  c.setTransform(scale, 0, 0, scale, 0, 0);
  c.clearRect(0, 0, width, height);
  c.font = font;
  return { c, width, height };
}

// Round numbers between two ends, about `count` of them.
function ticks(low, high, count) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= rough - 1e-12);
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, k) => digits((first + k) * step, 10));
}

// Colour of a deviation from the plain groove as a share of the largest: red where material is cut
// away, blue where it is left.
function depthColour(share, k) {
  const end = share > 0 ? k.cut : k.left, part = Math.min(1, Math.abs(share));
  return "rgb(" + k.flat.map((v, c) => Math.round(v + (end[c] - v) * part)).join(",") + ")";
}

// Largest deviations from the plain groove, µm: cut away, left, and the larger one.
function deviations(r) {
  const all = r.depth_um.flat(), cut = Math.max(0, ...all), left = Math.max(0, -Math.min(...all));
  return { cut, left, most: Math.max(cut, left, 0.01), text: "deviation in µm: " + cut.toFixed(1) + " cut away (red), " + left.toFixed(1) + " left (blue)" };
}

const RAD = Math.PI / 180;
// A disc, filled or outlined or both.
function disc(c, x, y, r, fill, stroke, wide = 1) {
  c.beginPath(); c.arc(x, y, r, 0, 2 * Math.PI);
  if (fill) { c.fillStyle = fill; c.fill(); }
  if (stroke) { c.strokeStyle = stroke; c.lineWidth = wide; c.stroke(); }
}

// A line through points, which breaks where one is null.
function lineThrough(c, points, colour, wide = 1, dash = []) {
  c.beginPath();
  points.forEach((p, i) => { if (p) c[points[i - 1] ? "lineTo" : "moveTo"](...p); });
  c.strokeStyle = colour; c.lineWidth = wide; c.setLineDash(dash); c.stroke(); c.setLineDash([]);
}

// ψ = 0 at the bottom, counter-clockwise; the canvas has y downwards.
const at = (r, psi, x, y) => [x + r * Math.sin(psi), y + r * Math.cos(psi)];

// The bearing with its balls at one moment, its rows side by side.
function drawBearing(canvas, g, frame, title) {
  const rows = signsOf(g).length, { c, width, height } = context(canvas, 1.02 / rows);
  for (let row = 0; row < rows; row++) drawRow(c, colours(canvas), g, frame, rows > 1 ? (title + " row " + (row + 1)).trim() : title, row, [width / rows, height]);
}

// The sign of each row, 1 where its balls press the outer ring towards +z.
const signsOf = ({ space }) => (space ? space.signs : [1]);

function drawRow(c, k, g, frame, title, row, [width, height]) {
  const b = g.bearing;
  const wall = 0.18 * b.outer_radius_mm, edge = b.outer_radius_mm + wall;
  const scale = (Math.min(width, height) - 8) / (2 * edge * 1.02);
  const x = (row + 0.5) * width, y = height / 2;
  const circle = (r, fill) => disc(c, x, y, r * scale, fill, k.soft);
  c.globalAlpha = 1;
  circle(edge, k.ring);
  for (const r of g.raceways) {
    const [from, to] = [r.centre_angle_deg - r.half_angle_deg, r.centre_angle_deg + r.half_angle_deg].map((a) => Math.PI / 2 - a * RAD);
    c.beginPath(); c.arc(x, y, edge * scale, from, to, true); c.arc(x, y, b.outer_radius_mm * scale, to, from, false);
    c.closePath(); c.fillStyle = k.sector; c.globalAlpha = 0.6; c.fill(); c.globalAlpha = 1;
  }
  circle(b.outer_radius_mm, k.paper);
  circle(b.inner_radius_mm, k.ring);
  circle(Math.max(b.inner_radius_mm - wall, 0.3 * b.inner_radius_mm), k.paper);
  // At rest a row may have fewer balls than the others.
  const ofRow = (values, rows) => (values || []).filter((_, i) => (rows ? rows[i] === row + 1 : Math.floor(i / b.balls) === row));
  const angles = frame ? ofRow(frame.angle_deg) : ofRow(g.static.ball_angle_deg, g.static.row);
  const gaps = frame ? ofRow(frame.gap_deg) : [];
  const forces = frame ? ofRow(frame.inner_force_n) : ofRow(g.static.inner_force_n, g.static.row);
  const most = Math.max(1, ...(frame ? frame.inner_force_n : g.static.inner_force_n || [1]));
  const n = angles.length;
  angles.forEach((a, i) => {
    const [bx, by] = at(b.pitch_radius_mm * scale, a * RAD, x, y);
    const hit = gaps.length && (gaps[i] <= 0 || gaps[(i + n - 1) % n] <= 0);
    disc(c, bx, by, b.ball_radius_mm * scale - 1, i === 0 ? k.first : i === 1 ? k.second : k.ball, hit ? k.hit : k.soft, hit ? 3 : 1);
    const force = forces[i] || 0;
    if (force > 0.01 * most) {
      const far = [b.inner_radius_mm - 0.9 * wall * force / most, b.inner_radius_mm];
      lineThrough(c, far.map((r) => at(r * scale, a * RAD, x, y)), k.first, 3);
    }
    if (gaps.length && gaps[i] <= 0) {
      const [tx, ty] = at(b.pitch_radius_mm * scale, (a + (gaps[i] + g.numbers.epsilon_deg) / 2) * RAD, x, y);
      disc(c, tx, ty, 4, k.hit);
    }
  });
  c.fillStyle = k.ink; c.textAlign = "center";
  c.fillText(title, x, y - 8);
  if ([g.document.operation.inner_speed_rpm].flat(2).some((v) => v < 0)) c.fillText("from the other face", x, y + 28);
  c.fillText(frame ? "t = " + (frame.t * 1000).toFixed(2) + " ms" : "at rest", x, y + 10);
}

// Gap ahead of each ball as bars, with the gap of even spacing.
function drawGaps(canvas, g, frame) {
  const { c, width, height } = context(canvas, canvas.clientWidth > 600 ? 0.2 : 0.34);
  const k = colours(canvas);
  const left = 44, bottom = height - 20, top = 16;
  const gaps = frame ? frame.gap_deg : [];
  const even = g.numbers.uniform_gap_deg;
  const most = Math.max(2.5 * even, ...gaps, 0.1);
  const scale = (bottom - top) / most;
  c.fillStyle = k.soft; c.textAlign = "right";
  c.fillText(most.toFixed(1) + "°", left - 5, top + 4); c.fillText("0", left - 5, bottom + 4);
  c.textAlign = "left"; c.fillText("gap ahead of each ball", left, 11);
  const step = (width - left - 6) / Math.max(1, gaps.length);
  gaps.forEach((gap, i) => {
    const high = Math.max(2, gap * scale);
    c.fillStyle = gap <= 0 ? k.hit : i < 2 ? [k.first, k.second][i] : k.soft;
    c.fillRect(left + i * step + 1, bottom - high, Math.max(1, step - 2), high);
    if (step > 14) { c.fillStyle = k.soft; c.textAlign = "center"; c.fillText(String(i + 1), left + (i + 0.5) * step, height - 5); }
  });
  const across = (y, dash) => lineThrough(c, [[left, y], [width - 6, y]], k.ink, 1, dash);
  across(bottom - even * scale, [4, 3]);
  across(bottom);
}

// What is said in place of a groove that is not drawn.
const NO_GROOVE = "no discrete raceway";

// Ends of z of a groove, mm.
const extentOf = (r) => { const all = r.across_mm.flat(); return [Math.min(...all), Math.max(...all)]; };

// Depth of the groove below the plain one, unrolled: ψ to the right, z upwards, with both tracks.
function drawDepth(canvas, g) {
  const { c, width, height } = context(canvas, 0.5);
  const k = colours(canvas), r = g.raceways[0];
  c.fillStyle = k.soft;
  if (!r) { c.textAlign = "center"; c.fillText(NO_GROOVE, width / 2, height / 2); return; }
  const left = 40, right = width - 8, top = 18, bottom = height - 30;
  const n = r.angle_deg.length, [low, high] = extentOf(r);
  const { most, text } = deviations(r);
  const px = (a) => left + (right - left) * (a - r.angle_deg[0]) / (r.angle_deg[n - 1] - r.angle_deg[0]);
  const py = (z) => bottom - (z - low) / (high - low) * (bottom - top);
  for (let i = 0; i + 1 < n; i++) {
    for (let j = 0; j + 1 < r.across_mm[i].length; j++) {
      c.fillStyle = depthColour((r.depth_um[i][j] + r.depth_um[i][j + 1]) / 2 / most, k);
      const [y0, y1] = [py(r.across_mm[i][j]), py(r.across_mm[i][j + 1])];
      c.fillRect(px(r.angle_deg[i]), Math.min(y0, y1), px(r.angle_deg[i + 1]) - px(r.angle_deg[i]) + 0.6, Math.abs(y1 - y0) + 0.6);
    }
  }
  for (const track of r.track_mm) lineThrough(c, r.angle_deg.map((a, i) => [px(a), py(track[i])]), k.ink, 2);
  c.fillStyle = k.soft; c.textAlign = "left";
  c.fillText(text, left, 12);
  c.textAlign = "right"; c.fillText(high.toFixed(1), left - 4, top + 10); c.fillText("z mm", left - 4, (top + bottom) / 2 + 4);
  c.fillText(minus(low.toFixed(1)), left - 4, bottom);
  c.textAlign = "center";
  for (const a of [-r.half_angle_deg, 0, r.half_angle_deg]) c.fillText(minus(a.toFixed(1)) + "°", px(a), bottom + 13);
  c.fillText("ψ from the middle of the raceway; line: contact track", (left + right) / 2, bottom + 26);
}

// The ball of the first row that is nearest to the middle of the raceway, or to the bottom.
function nearestBall(g, frame) {
  const centre = g.raceways.length ? g.raceways[0].centre_angle_deg : 0, off = (i) => Math.abs(turned(frame.angle_deg[i] - centre));
  return Array.from({ length: g.bearing.balls }, (_, i) => i).reduce((a, b) => (off(b) < off(a) ? b : a));
}

// An angle in −180° to 180°.
const turned = (a) => a - 360 * Math.round(a / 360);
// Colours of the contacts: outer raceway, its other flank, inner raceway.
const contactColours = (k) => [k.first, k.hit, k.inner];

// Meridian section in the middle of the raceway: ball, plain groove, raceway; of motion in space with the
// contacts of the ball that is there.
function drawSection(canvas, g, frame) {
  const { c, width, height } = context(canvas, 0.62);
  const k = colours(canvas), b = g.bearing, r = g.raceways[0];
  const scale = 0.37 * height / b.ball_radius_mm, x = width / 2, y = 0.48 * height;
  const middle = r ? (r.angle_deg.length - 1) / 2 : 0, flanks = r ? r.flank_deg.map((f) => f[middle]) : [0, 0];
  disc(c, x, y, b.ball_radius_mm * scale, k.ball, k.soft);
  // Plain groove below the ball, which rests in it at the contact angle of the section.
  const seat = r ? (flanks[0] + flanks[1]) / 2 * RAD : 0, back = (b.outer_curvature_mm - b.ball_radius_mm) * scale;
  const re = b.outer_curvature_mm * scale, [cx, cy] = [x - back * Math.sin(seat), y - back * Math.cos(seat)];
  const most = Math.acos(Math.max(-1, Math.min(1, 1 - (b.outer_radius_mm - b.shoulder_radius_mm) / b.outer_curvature_mm)));
  c.beginPath(); c.arc(cx, cy, re, Math.PI / 2 - most, Math.PI / 2 + most); c.setLineDash([5, 4]); c.stroke(); c.setLineDash([]);
  if (r) {
    lineThrough(c, r.across_mm[middle].map((z, j) => {
      const far = re + r.depth_um[middle][j] / 1000 * scale, side = (z - r.centre_mm) * scale;
      return [cx + side, cy + Math.sqrt(Math.max(0, far * far - side * side))];
    }), "#b2182b", 2);
  }
  const contacts = frame && frame.space && g.space ? contactsOf(frame.space, nearestBall(g, frame)) : [];
  if (contacts.length) {
    contacts.forEach(([angle, reach, inner], n) => {
      if (!reach) return;
      const side = inner ? -1 : 1, [dx, dy] = [side * Math.sin(angle * RAD), side * Math.cos(angle * RAD)], far = b.ball_radius_mm * scale;
      lineThrough(c, [[x, y], [x + far * dx, y + far * dy]], contactColours(k)[n]);
      const at = Math.atan2(dy, dx);
      c.lineWidth = 5; c.beginPath(); c.arc(x, y, far, at - reach * RAD, at + reach * RAD); c.stroke();
    });
  } else if (r) {
    for (const flank of flanks) {
      const [fx, fy] = at(b.ball_radius_mm * scale, flank * RAD, x, y);
      disc(c, fx, fy, 4, k.first);
    }
  }
  c.fillStyle = k.soft; c.textAlign = "left";
  c.fillText(contacts.length ? "ball " + (nearestBall(g, frame) + 1) + " with its contact ellipses" : "section in the middle of the raceway", 6, 12);
  const r0 = r ? r.effective_radius_mm[middle] : b.ball_radius_mm;
  c.fillText(contacts.length ? ["outer", "other flank", "inner"].map((name, n) => (contacts[n][1] ? name + " " + shown(contacts[n][0], 1) + "°" : "")).filter(Boolean).join(", ")
    : "r = " + r0.toFixed(4) + " mm" + (r ? ", 2z = " + Math.abs(r.track_mm[0][middle] - r.track_mm[1][middle]).toFixed(3) + " mm" : ""), 6, height - 6);
}
