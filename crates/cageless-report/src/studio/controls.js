// The controls: what each sets in the case file, and between which values.

// Bearing dimensions as people order them, mm and µm.
function nominal({ bearing: b, document: d }) {
  // The file has the grooves before a contact angle opens them.
  const ball = 2 * b.ball_radius_mm, clearance = d.bearing.contact_angle_deg ? 0 : b.radial_internal_clearance_um;
  return {
    ball, pitch: 2 * b.pitch_radius_mm, clearance,
    conformity_inner: b.inner_curvature_mm / ball, conformity_outer: b.outer_curvature_mm / ball,
    shoulder: (b.pitch_radius_mm + b.ball_radius_mm + clearance / 4000 - b.shoulder_radius_mm) / ball,
  };
}

const digits = (value, count) => Number(value.toFixed(count));

// The keys of the case file for nominal dimensions, in the way in which the file gives them, by
// radii or by diameters; shoulder height and conformity stay in proportion to the ball.
function dimensions(n, g) {
  const given = (name) => g.document.bearing[name] !== undefined && g.document.bearing[name] !== null;
  const keys = {};
  const set = (name, value) => { keys["bearing." + name] = value; };
  if (given("ball_diameter_mm")) set("ball_diameter_mm", n.ball); else set("ball_radius_mm", n.ball / 2);
  const clearance = n.clearance / 2000, ro = (n.pitch + n.ball + clearance) / 2;
  if (given("pitch_diameter_mm")) {
    set("pitch_diameter_mm", n.pitch);
    set("radial_internal_clearance_um", n.clearance);
  } else {
    set("inner_groove_bottom_radius_mm", (n.pitch - n.ball - clearance) / 2);
    set("outer_groove_bottom_radius_mm", ro);
  }
  if (given("outer_shoulder_radius_mm")) set("outer_shoulder_radius_mm", ro - n.shoulder * n.ball);
  for (const side of ["inner", "outer"]) {
    const radius = side + "_groove_curvature_radius_mm", conformity = n["conformity_" + side];
    if (given(radius)) set(radius, conformity * n.ball); else set(side + "_conformity", conformity);
  }
  return keys;
}

// `absent` is the value of a key that its section leaves out.
function ofKey(key, absent) {
  const [section, name] = key.split(".");
  return {
    key,
    read: ({ document: d }) => { const part = section === "raceway" && Array.isArray(d.raceway) ? d.raceway[0] : d[section]; return part ? part[name] ?? absent : undefined; },
    keys: (value) => ({ [key]: value }),
  };
}

function ofNominal(name) {
  return {
    read: (g) => nominal(g)[name],
    keys: (value, g) => dimensions({ ...nominal(g), [name]: value }, g),
  };
}

// Largest magnitude of a number, or of a table over time.
const largest = (value) => Math.max(...(Array.isArray(value) ? value.map(([, v]) => v) : [value || 0]).map(Math.abs));
const fixed = (low, high) => () => [low, high];
const rowsOf = ({ document: { row } }) => [].concat(row || []);
// From 0 to twice what the file says.
const upTo = (section, key) => ({ document: d }) => [0, 2 * Math.abs((d[section] || {})[key] || 1)];
// `mapped` are the ends on the map of a control that cannot be 0, where they are not those of its slider.
const CONTROLS = [
  { group: "Raceway", id: "span", label: "Axial span lC", unit: "mm", step: 0.01, help: "largest axial distance between the two contact points", range: (g) => [0, 1.15 * g.numbers.axial_span_limit_mm], mapped: (g) => [0, 1.08 * g.numbers.axial_span_limit_mm], ...ofKey("raceway.axial_span_mm") },
  { group: "Raceway", id: "theta", label: "Half angle θ", unit: "°", step: 0.1, help: "half the angle that the raceway takes up", range: fixed(1, 90), mapped: ({ numbers: n, raceways: [r] }) => [0, Math.min(90, Math.max(1.7 * (n.epsilon_deg + n.uniform_gap_deg), r ? 1.15 * r.half_angle_deg : 0))], ...ofKey("raceway.half_angle_deg") },
  { group: "Raceway", id: "centre", label: "Centre ψ", unit: "°", step: 1, help: "position of the middle of the raceway; 0° is in the middle of the load zone", range: fixed(-180, 180), ...ofKey("raceway.centre_angle_deg") },
  { group: "Raceway", id: "blend", label: "Blend", unit: "mm", step: 0.05, help: "length over which either end runs out into the plain raceway; 0: ends as the shape has them", range: (g) => [0, g.raceways.length ? digits(g.raceways[0].half_angle_deg * Math.PI / 360 * g.bearing.outer_radius_mm, 2) : 1], ...ofKey("raceway.blend_mm") },
  { group: "Raceway", id: "depth", label: "Depth", unit: "µm", step: 0.5, help: "how much deeper a ball in the middle sits than on the plain raceway", range: (g) => [0, Math.max(30, 2 * (ofKey("raceway.depth_um").read(g) || 0))], ...ofKey("raceway.depth_um") },
  { group: "Raceway", id: "section", label: "Contact angle αg", unit: "°", step: 0.1, help: "angle by which the section is turned about the centre of the ball; in space", range: fixed(-45, 45), ...ofKey("raceway.contact_angle_deg", 0) },
  { group: "Bearing", id: "balls", label: "Balls N", unit: "", step: 1, whole: true, help: "number of balls", range: (g) => [3, Math.max(g.bearing.balls + 4, Math.ceil(420 / g.numbers.epsilon_deg))], ...ofKey("bearing.balls") },
  { group: "Bearing", id: "ball", label: "Ball diameter Dw", unit: "mm", step: 0.001, help: "pitch diameter, clearance and conformity stay", range: (g) => [0.7, 1.3].map((f) => digits(2 * f * g.bearing.ball_radius_mm, 3)), ...ofNominal("ball") },
  { group: "Bearing", id: "pitch", label: "Pitch diameter Dpw", unit: "mm", step: 0.001, help: "diameter of the circle of ball centres", range: (g) => [0.8, 1.3].map((f) => digits(2 * f * g.bearing.pitch_radius_mm, 3)), ...ofNominal("pitch") },
  { group: "Bearing", id: "clearance", label: "Radial internal clearance Gr", unit: "µm", step: 1, help: "ISO 5753-1: twice the radial play of the inner ring; below 0: preload by interference", range: fixed(-40, 80), ...ofNominal("clearance") },
  { group: "Bearing", id: "fi", label: "Conformity, inner", unit: "", step: 0.001, help: "groove radius over ball diameter", range: fixed(0.5, 0.58), ...ofNominal("conformity_inner") },
  { group: "Bearing", id: "fo", label: "Conformity, outer", unit: "", step: 0.001, help: "groove radius over ball diameter", range: fixed(0.5, 0.58), ...ofNominal("conformity_outer") },
  { group: "Bearing", id: "alpha", label: "Contact angle α0", unit: "°", step: 0.1, help: "free contact angle; not 0: in space", range: fixed(0, 45), ...ofKey("bearing.contact_angle_deg", 0) },
  { group: "Bearing", id: "preload", label: "Preload", unit: "µm", step: 0.5, help: "displacement of the outer ring of each row against its contact sign",
    range: (g) => [0, Math.max(30, 2 * Math.max(...rowsOf(g).map((row) => row.preload_um || 0)))],
    read: (g) => { const rows = rowsOf(g); return rows.length && !rows.some((row) => row.preload_n) ? rows[0].preload_um || 0 : undefined; },
    keys: (value, g) => Object.fromEntries(rowsOf(g).map((_, k) => ["row." + (k + 1) + ".preload_um", value])) },
  { group: "Operation", id: "speed", label: "Speed n", unit: "rpm", step: 10, help: "speed of the inner ring; negative: clockwise, seen from the other face", range: (g) => { const most = Math.max(20000, 1.5 * largest(g.document.operation.inner_speed_rpm)); return [-most, most]; }, ...ofKey("operation.inner_speed_rpm") },
  { group: "Operation", id: "load", label: "Radial load Fr", unit: "N", step: 10, help: "load on the inner ring, downwards", range: (g) => [0, Math.max(5000, 2 * largest(g.document.operation.radial_load_n))], ...ofKey("operation.radial_load_n") },
  { group: "Operation", id: "axial", label: "Axial load Fa", unit: "N", step: 10, help: "load on the inner ring along its axis; not 0: in space", range: ({ document: { operation: o } }) => { const most = Math.max(1000, largest(o.radial_load_n), 2 * Math.abs(o.axial_load_n || 0)); return [-most, most]; },
    ...ofKey("operation.axial_load_n", 0), read: (g) => (g.rotor ? undefined : g.document.operation.axial_load_n ?? 0) },
  { group: "Operation", id: "friction", label: "Friction μ", unit: "", step: 0.001, help: "coefficient of friction", range: fixed(0, 0.2), ...ofKey("contact.friction_coefficient") },
  ...[
    ["mass", "Mass m", "kg", 0.1, "share of the rotor mass carried by this bearing", "mass_kg"],
    ["drop-speed", "Speed", "rpm", 10, "rotor speed at the start of the drop", "speed_rpm"],
    ["gap", "Touch-down clearance", "µm", 1, "radial clearance between journal and inner ring", "radial_clearance_um"],
    ["journal-friction", "Friction μ, journal", "", 0.01, "coefficient of friction between journal and inner ring", "friction_coefficient"],
  ].map(([id, label, unit, step, help, key]) => ({ group: "Rotor", id, label, unit, step, help, range: upTo("rotor", key), ...ofKey("rotor." + key) })),
  ...[
    ["stiffness", "Stiffness", "N/m", 1e5, "stiffness of the support of the outer ring", "stiffness_n_m"],
    ["damping", "Damping", "N·s/m", 10, "damping of the support of the outer ring", "damping_n_s_m"],
  ].map(([id, label, unit, step, help, key]) => ({ group: "Support", id, label, unit, step, help, range: upTo("support", key), ...ofKey("support." + key) })),
];

// Decimals of a control's value.
function decimals(control) { return Math.max(0, -Math.floor(Math.log10(control.step) + 1e-9)); }

// The request for the possible values of every control.
function rangesRequest(toml, g) {
  const document = g.document;
  const controls = CONTROLS.filter((c) => typeof c.read(g) === "number").map((c) => {
    const [low, high] = c.range(g);
    const [at, end] = [c.keys(low, g), c.keys(high, g)];
    const keys = Object.keys(at).filter((key) => at[key] !== end[key] || Object.keys(at).length === 1)
      .map((key) => ({ key: firstOf(key, document), low: at[key], high: end[key] }));
    return { name: c.id, low, high, whole: !!c.whole, keys };
  });
  return { op: "ranges", case: toml, controls };
}

// Of several raceways the controls set the first.
function firstOf(key, document) {
  const several = key.startsWith("raceway.") && Array.isArray(document.raceway) && document.raceway.length > 1;
  return several ? key.replace("raceway.", "raceway.1.") : key;
}

const START_SPACINGS = [["uniform", "even"], ["half-bunched", "one gap takes half the free angle"], ["random-1", "random 1"], ["random-2", "random 2"], ["random-3", "random 3"]];

// N gaps of a start: even, half the free room in one place, or drawn from a seed.
function startGaps(kind, g) {
  const n = g.bearing.balls, room = n * g.numbers.uniform_gap_deg;
  if (kind === "uniform") return "\"uniform\"";
  let parts;
  if (kind === "half-bunched") {
    parts = Array.from({ length: n }, (_, k) => (k === n - 1 ? n : 1));
  } else {
    let seed = Number(kind.split("-")[1]) >>> 0;
    parts = Array.from({ length: n }, () => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return 0.1 + seed / 4294967296;
    });
  }
  const sum = parts.reduce((a, b) => a + b, 0);
  const gaps = parts.map((p) => digits(room * p / sum, 6));
  gaps[n - 1] = digits(room - gaps.slice(0, -1).reduce((a, b) => a + b, 0), 9);
  return "[" + gaps.join(", ") + "]";
}
