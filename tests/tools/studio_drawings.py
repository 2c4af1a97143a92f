"""Drawings and numbers of the studio against places and numbers that are worked out here, from made-up moments in which
every number is another."""

import json
import math
from pathlib import Path

from studio_tab import S

# What a drawing does to its paper, of a width of 640: fills, strokes, bars and texts, with their colours.
PAPER = """
(() => {
  const done = [], c = { width: 640, fillStyle: "", strokeStyle: "", lineWidth: 1, globalAlpha: 1, textAlign: "left", dash: [], path: [] };
  Object.assign(c, {
    setLineDash: (dash) => { c.dash = dash; },
    measureText: (text) => ({ width: 6 * String(text).length }),
    beginPath: () => { c.path = []; },
    closePath: () => {},
    moveTo: (x, y) => c.path.push(["M", x, y]),
    lineTo: (x, y) => c.path.push([c.path.length ? "L" : "M", x, y]),
    arc: (x, y, r, from, to) => c.path.push(["A", x, y, r, from, to]),
    fill: () => done.push({ what: "fill", path: c.path, colour: c.fillStyle }),
    stroke: () => done.push({ what: "stroke", path: c.path, colour: c.strokeStyle, wide: c.lineWidth, dash: c.dash }),
    fillRect: (x, y, w, h) => done.push({ what: "bar", x, y, w, h, colour: c.fillStyle }),
    strokeRect: () => {},
    drawImage: () => {},
    fillText: (text, x, y) => done.push({ what: "text", text: String(text), x, y }),
  });
  return { light: true, clientWidth: 640, done, begin: (ratio) => { c.height = Math.round(640 * ratio); done.height = c.height; return c; } };
})()
"""
FIRST, SECOND, BALL, HIT, SOFT, INNER = "#0072b2", "#56b4e9", "#f4f5f6", "#d55e00", "#59636e", "#009e73"
BROWN, ORANGE = "#946200", "#e69f00"
PAIR = Path(__file__).parents[2] / "cases/preloaded-pair.toml"


def near(found, wanted, by=0.02):
    return len(found) == len(wanted) and all(abs(a - b) <= by for a, b in zip(found, wanted))


def drawing(s, thing, frame):
    """Height and parts of a drawing of the menu at a made-up moment."""
    return s.js(
        f"(() => {{ const {{ stage, saving }} = {S}, to = {PAPER.strip()}; stage.run(false); stage.frame = {json.dumps(frame)};"
        f" saving.things.find((t) => t.id === '{thing}').draw(to); const made = {{ height: to.done.height, parts: [...to.done] }};"
        " stage.paint(); return made; })()"
    )


def discs(parts, what, colour=None):
    """Circles as [x, y, radius], filled or outlined."""
    found = [p for p in parts if p["what"] == what and len(p["path"]) == 1 and p["path"][0][0] == "A"]
    whole = [p for p in found if abs(p["path"][0][5] - p["path"][0][4]) > 6.28]
    return [(p["path"][0][1:4], p) for p in whole if colour is None or p["colour"] == colour]


def strokes(parts, colour, wide):
    """Ends of lines of a colour and width, as [x, y] each."""
    found = [p for p in parts if p["what"] == "stroke" and p["colour"] == colour and p["wide"] == wide and not p["dash"]]
    return [[point[1:3] for point in p["path"]] for p in found if all(point[0] != "A" for point in p["path"])]


def moment(s, rows=1):
    """A moment of motion with other numbers for every ball; two gaps of the first row are closed, and one of a second."""
    balls = s.js(f"{S}.g.bearing.balls")
    count = rows * balls
    closed = [2, balls - 1] + ([balls + 5] if rows > 1 else [])
    return closed, {
        "t": 0.00375,
        "angle_deg": [360 / balls * (k % balls) + 7.3 + 4.1 * (k // balls) for k in range(count)],
        "gap_deg": [0 if k in closed else 1 + 0.05 * k for k in range(count)],
        "inner_force_n": [100 + 13 * k for k in range(count)],
        "outer_force_n": [700 + 17 * k for k in range(count)],
        "sliding_m_s": [0.01 * k for k in range(count)],
        "ring_um": [1.25, -8.5],
    }


def bearing(s, rows):
    """Every ball of every row stands at its angle; both balls of a closed gap are outlined, no other."""
    closed, frame = moment(s, rows)
    balls, pitch, radius, outer, inner, epsilon = s.js(
        f"(({{ bearing: b, numbers: n }}) => [b.balls, b.pitch_radius_mm, b.ball_radius_mm, b.outer_radius_mm, b.inner_radius_mm, n.epsilon_deg])({S}.g)"
    )
    made = drawing(s, "bearing", frame)
    width, height = 640 / rows, made["height"]
    wall, scale = 0.18 * outer, (min(width, height) - 8) / (2 * 1.18 * outer * 1.02)
    filled, outlined = discs(made["parts"], "fill"), discs(made["parts"], "stroke")
    bars = strokes(made["parts"], FIRST, 3)
    most = max(frame["inner_force_n"])
    wrong = []
    for k, psi in enumerate(frame["angle_deg"]):
        row, ball = divmod(k, balls)
        x, y = (row + 0.5) * width, height / 2
        sine, cosine = math.sin(math.radians(psi)), math.cos(math.radians(psi))
        wanted = [x + pitch * scale * sine, y + pitch * scale * cosine, radius * scale - 1]
        colour = FIRST if ball == 0 else SECOND if ball == 1 else BALL
        body = [p["colour"] for at, p in filled if near(at, wanted)]
        rim = [(p["colour"], p["wide"]) for at, p in outlined if near(at, wanted)]
        before = row * balls + (ball - 1) % balls
        touches = k in closed or before in closed
        force = frame["inner_force_n"][k]
        ends = [[x + r * scale * sine, y + r * scale * cosine] for r in (inner - 0.9 * wall * force / most, inner)]
        loaded = sum(near(sum(bar, []), sum(ends, [])) for bar in bars)
        if body != [colour] or rim != [(HIT, 3) if touches else (SOFT, 1)] or loaded != 1:
            wrong.append([k + 1, body, rim, loaded])
    s.check(f"{rows} × {balls} balls are drawn at their angles, outlined where they touch, with their loads", not wrong, wrong)
    marks = [at for at, p in filled if p["colour"] == HIT]
    places = []
    for k in closed:
        half = math.radians(frame["angle_deg"][k] + epsilon / 2)
        places.append([(k // balls + 0.5) * width + pitch * scale * math.sin(half), height / 2 + pitch * scale * math.cos(half), 4])
    s.check("contacts are marked between their balls", len(marks) == len(closed) and all(any(near(m, p) for m in marks) for p in places), [marks, places])
    said = [p["text"] for p in made["parts"] if p["what"] == "text"]
    s.check("with their time", "t = 3.75 ms" in said, said)


def gaps(s):
    """A bar as high as each gap, closed ones red."""
    closed, frame = moment(s)
    even = s.js(f"{S}.g.numbers.uniform_gap_deg")
    made = drawing(s, "gaps", frame)
    count, bottom = len(frame["gap_deg"]), made["height"] - 20
    most = max(2.5 * even, *frame["gap_deg"])
    step = (640 - 44 - 6) / count
    bars = [p for p in made["parts"] if p["what"] == "bar"]
    wrong = []
    for k, (gap, bar) in enumerate(zip(frame["gap_deg"], bars)):
        high = max(2, gap * (bottom - 16) / most)
        colour = HIT if k in closed else {0: FIRST, 1: SECOND}.get(k, SOFT)
        if not near([bar["x"], bar["y"], bar["h"]], [44 + k * step + 1, bottom - high, high]) or bar["colour"] != colour:
            wrong.append([k + 1, bar, high])
    s.check("every gap has its bar", len(bars) == count and not wrong, wrong)


def contacts(s):
    """A bar at each contact angle over ψ, upwards towards +z, on the panel of its raceway."""
    _, frame = moment(s, len(s.js(f"{S}.g.space.signs")))
    count = len(frame["angle_deg"])
    # The second half lies on the other flank as well.
    frame["space"] = {
        "outer": [
            [[2 + 0.5 * k - 3 * (k % 3) for k in range(count)], [1 + 0.1 * k for k in range(count)]],
            [[-4 - 0.3 * k for k in range(count)], [(0.5 + 0.05 * k) if k > count // 2 else 0 for k in range(count)]],
        ],
        "inner": [[3.3 - 0.4 * k for k in range(count)], [0.7 + 0.02 * k for k in range(count)]],
    }
    made = drawing(s, "contacts", frame)
    inner, outer = s.js(f"{S}.g.space.shoulders_deg")
    height = made["height"]
    half = (height - 20) / 2
    wrong = []
    for colour, [angles, reaches], (top, bottom, shoulder) in (
        (FIRST, frame["space"]["outer"][0], (16, half, outer)),
        (HIT, frame["space"]["outer"][1], (16, half, outer)),
        (INNER, frame["space"]["inner"], (half + 18, height - 20, inner)),
    ):
        bars = strokes(made["parts"], colour, 6) + strokes(made["parts"], colour, 3)
        wanted = []
        for psi, angle, reach in zip(frame["angle_deg"], angles, reaches):
            x = 34 + (634 - 34) * ((psi + 180) % 360) / 360
            middle, per_degree = (top + bottom) / 2, (bottom - top) / 2 / (1.08 * shoulder)
            if reach:
                wanted.append([x, middle - (angle - reach) * per_degree, x, middle - (angle + reach) * per_degree])
        missing = [w for w in wanted if sum(near(sum(bar, []), w) for bar in bars) != 1]
        if missing or len(bars) != len(wanted):
            wrong.append([colour, len(bars), len(wanted), missing[:2]])
    s.check("contact angles of every ball are drawn at their places", not wrong, wrong)
    # The ball nearest to the middle of the raceway, as seen along the orbit: z to the right, outwards down.
    centre = s.js(f"{S}.g.raceways[0].centre_angle_deg")
    balls = s.js(f"{S}.g.bearing.balls")
    nearest = min(range(balls), key=lambda k: abs((frame["angle_deg"][k] - centre + 180) % 360 - 180))
    for k in (0, 1):
        frame["space"]["outer"][k][1][nearest] = 2.0
    made = drawing(s, "section", frame)
    radius, x, y = 0.37 * made["height"], 320, 0.48 * made["height"]
    wrong = []
    for colour, angles, side in ((FIRST, frame["space"]["outer"][0][0], 1), (HIT, frame["space"]["outer"][1][0], 1), (INNER, frame["space"]["inner"][0], -1)):
        angle = math.radians(angles[nearest])
        wanted = [x, y, x + side * radius * math.sin(angle), y + side * radius * math.cos(angle)]
        lines = [sum(line, []) for line in strokes(made["parts"], colour, 1)]
        if not any(near(line, wanted) for line in lines):
            wrong.append([colour, lines, wanted])
    said = [p["text"] for p in made["parts"] if p["what"] == "text"]
    s.check("and those of the nearest ball in the section", not wrong and f"ball {nearest + 1} with its contact ellipses" in said, [wrong, said])


def table(s):
    """Cells of the table of criteria."""
    return s.js("[...document.querySelectorAll('[data-part=terms] tbody tr')].map((r) => [r.className, ...[...r.children].map((d) => d.textContent)])")


def numbers(row):
    """Value, limit and margin of a row."""
    return [float(cell.replace("\u2212", "-").lstrip("≤≥ ")) for cell in row[2:5]]


def criteria(s):
    """Value, limit and margin of each criterion in the unit of its row; the margin is the distance from the limit."""
    s.judged()
    judged = s.js(f"{S}.judged.criteria")
    rows, wrong = table(s), []
    for criterion, row in zip(judged, rows):
        value, limit, margin = numbers(row)
        own = [100 * criterion["value"], 100 * criterion["limit"]]
        distance = (own[0] - own[1]) * (1 if row[3].startswith("≥") else -1)
        if row[0] != ("missed" if distance < 0 else "met") or row[5] != "%":
            wrong.append([row, criterion])
        # Values and margins to a tenth of a per cent, limits to a whole one.
        if not (near([value, margin], [own[0], distance], 0.0501) and near([limit], own[1:], 0.501)):
            wrong.append([row, criterion])
    s.check("simulated criteria have their numbers", len(rows) == len(judged) > 2 and not wrong, wrong)
    made_up = [
        {"name": "separation", "value": 0.0713, "limit": 0.05, "margin": -0.0213, "at_least": False, "text": "a"},
        {"name": "deceleration", "value": 0.9137, "limit": 0.8, "margin": 0.1137, "at_least": True, "text": "b"},
    ]
    terms = [{"name": "stress", "value": 0.4375, "limit": 1, "margin": 0.5625, "at_least": False, "meaning": "c"}]
    shown = s.js(
        f"(() => {{ const s = {S}, {{ judged, g }} = s, {{ estimate }} = g, read = () => [...s.verdict.terms.querySelectorAll('tbody tr')].map((r) => [r.className, ...[...r.children].map((d) => d.textContent)]);"
        f" s.judged = {{ passes: false, headline: 'made up', criteria: {json.dumps(made_up)} }}; s.verdict.show(); const one = read();"
        f" s.judged = null; g.estimate = {{ ...estimate, terms: {json.dumps(terms)} }}; s.verdict.show(); const other = read();"
        " s.judged = judged; g.estimate = estimate; s.verdict.show(); return [one, other]; })()"
    )
    cells = [[row[0], *row[2:]] for rows in shown for row in rows]
    wanted = [
        ["missed", "7.1", "≤ 5", "\u22122.1", "%"],
        ["met", "91.4", "≥ 80", "11.4", "%"],
        ["met", "0.438", "≤ 1.000", "0.563", "ratio"],
    ]
    s.check("made-up criteria as well, in per cent and as ratios", cells in (wanted, [*wanted[:2], ["met", "0.438", "≤ 1.000", "0.562", "ratio"]]), cells)


def saved(s):
    """Columns of saved tables against the moments of the motion."""
    s.tab.wait_for(f"{S}.motion.frames.length > 3")
    found = s.js(
        f"(async () => {{ const {{ saving, motion }} = {S}; {S}.stage.run(false); const text = async (id) => (await saving.file(saving.things.find((t) => t.id === id), 'csv')).text();"
        " return [motion.frames.slice(0, 3), (await text('bearing')).split('\\n'), (await text('gaps')).split('\\n')]; })()"
    )
    frames, balls, gap_rows = found
    heads = balls[0].split(",")
    wrong = []
    for n, f in enumerate(frames):
        for k, psi in enumerate(f["angle_deg"]):
            row = dict(zip(heads, balls[1 + n * len(f["angle_deg"]) + k].split(",")))
            wanted = {"time_s": f["t"], "ball": k + 1, "angle_deg": psi, "gap_deg": f["gap_deg"][k], "inner_force_n": f["inner_force_n"][k],
                      "outer_force_n": f["outer_force_n"][k], "outer_sliding_m_s": f["sliding_m_s"][k], "ring_x_um": f["ring_um"][0], "ring_y_um": f["ring_um"][1]}  # fmt: skip
            if {name: float(v) for name, v in row.items()} != {name: float(v) for name, v in wanted.items()}:
                wrong.append([row, wanted])
        if [float(v) for v in gap_rows[1 + n].split(",")] != [f["t"], *f["gap_deg"]]:
            wrong.append(gap_rows[1 + n])
    s.check("saved tables have the numbers of their columns", not wrong, wrong[:2])


def compared(s):
    """Each row of the comparison with its own number of either side."""
    # Sums that no two rows have in common.
    found = s.js(
        f"(() => {{ const s = {S}, {{ comparison: c }} = s, {{ pinned }} = c, side = (k) => ({{ g: {{ raceways: [{{ axial_span_mm: k + 1, half_angle_deg: k + 2, shape: 'shape ' + k }}], bearing: {{ balls: k + 3 }},"
        " document: { operation: { inner_speed_rpm: k + 4, radial_load_n: k + 5, axial_load_n: k + 6 } }, numbers: { uniform_gap_deg: k + 7, beta0_deg: k + 8 },"
        " static: { inner_pressure_max_mpa: k + 9 + (k % 200 ? 0 : 1), outer_pressure_max_mpa: k + 9 + (k % 200 ? 1 : 0) } }, judged: { critical_gap_deg: k + 11, passages: { lag_per_pass_deg: k + 12, collisions_mean: k + 13,"
        " double_collision_fraction: k + 14, sliding_mean_m_s: k + 15 } } }); c.pinned = side(100); const { studio } = c; c.studio = side(200); const rows = c.rows(); c.pinned = pinned; c.studio = studio; return rows; })()"
    )
    wanted = [1, 2, None, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14, 15]
    wrong = []
    for row, own in zip(found, wanted):
        by = 100 if "%" in row[0] else 1
        sides = ["shape 100", "shape 200"] if own is None else [by * (100 + own), by * (200 + own)]
        if row[1:] != sides:
            wrong.append([row, sides])
    s.check("rows of the comparison are those of their names", len(found) == len(wanted) and not wrong, wrong)


def rotor(s):
    """Journal, marks, force and history of a drop at their places, its loads ball by ball, its numbers in words."""
    _, frame = moment(s)
    frame |= {"ring_rad": 0.8, "rotor": {"journal_um": [90.0, -150.0], "angle_deg": [35.0], "force_n": [1234.0], "speed_rpm": [29500.0, 4200.0], "z_um": [0.0]}}
    record = [{"t": 0.001 * k, "rotor": 30000 - 100 * k * k, "ring": 700 * k, "force": 250 * k * k, "z": 0} for k in range(5)]
    made = s.js(
        f"(() => {{ const {{ drop, motion, stage }} = {S}, kept = {{ rotor: drop.rotor, history: drop.history, loads: drop.loads, record: drop.record, peak: drop.peak, touched: drop.touched, follow: drop.follow }};"
        f" stage.run(false); const paper = () => {PAPER.strip()}, made = {{ rotor: paper(), history: paper(), loads: paper() }};"
        f" Object.assign(drop, made, {{ record: {json.dumps(record)}, peak: 1500, touched: 0.002, follow: () => {{}} }}); drop.paint({json.dumps(frame)});"
        " const numbers = [...drop.numbers.querySelectorAll('div')].map((d) => [...d.children].map((e) => e.textContent)), said = drop.said.textContent;"
        " Object.assign(drop, kept); stage.paint(); return { numbers, said, ...Object.fromEntries(Object.entries(made).map(([name, { done }]) => [name, { height: done.height, parts: [...done] }])) }; })()"
    )
    bore, clearance, weight, inner = s.js(f"(({{ rotor: r, bearing: b }}) => [r.bore_radius_mm, r.radial_clearance_um, r.weight_n, b.inner_radius_mm])({S}.g)")
    height = made["rotor"]["height"]
    gap, x, y = min(1.2, 0.7 * bore), 320, height / 2
    journal, scale = bore - gap, (min(640, height) / 2 - 22) / inner
    at = [x + 90 * gap / clearance * scale, y + 150 * gap / clearance * scale]
    bodies = [p for p, part in discs(made["rotor"]["parts"], "fill") if part["colour"] == "#f3e3d3"]
    s.check("the journal is drawn where it is, x to the right, y upwards", len(bodies) == 1 and near(bodies[0], [*at, journal * scale]), [bodies, at])

    def ends(angle, radii, px, py):
        """Ends of a mark along a radius; angles from +X, counter-clockwise."""
        return [v for r in radii for v in (px + r * scale * math.cos(angle), py - r * scale * math.sin(angle))]

    marks = {colour: [sum(line, []) for wide in (2, 4) for line in strokes(made["rotor"]["parts"], colour, wide)] for colour in (FIRST, BROWN, HIT)}
    push = math.atan2(-150, 90)
    long = (10 + 22 * min(1, 1234 / (30 * weight))) / scale
    for what, colour, wanted in (
        ("inner ring", FIRST, ends(0.8, [bore, inner], x, y)),
        ("rotor", BROWN, ends(math.radians(35), [0.55 * journal, journal], *at)),
        ("force", HIT, ends(push, [bore, bore + long], x, y)),
    ):
        s.check(f"the mark of the {what} is at its angle", len(marks[colour]) == 1 and near(marks[colour][0], wanted), [marks[colour], wanted])
    said = [p["text"] for p in made["rotor"]["parts"] if p["what"] == "text"]
    s.check("with force and time", f"1234 N = {1234 / weight:.1f} × weight" in said and "t = 3.75 ms" in said, said)
    parts, height = made["history"]["parts"], made["history"]["height"]
    middle = height / 2
    for what, colour, of, most, (top, bottom) in (
        ("the rotor", BROWN, "rotor", 30000, (20, middle - 16)),
        ("the inner ring", FIRST, "ring", 30000, (20, middle - 16)),
        ("the force", HIT, "force", 4000, (middle + 18, height - 30)),
    ):
        wanted = [v for h in record for v in (44 + (632 - 44) * h["t"] / 0.004, bottom - (bottom - top) * h[of] / most)]
        lines = [sum(line, []) for line in strokes(parts, colour, 1.5)]
        s.check(f"the history of {what} is drawn", len(lines) == 1 and near(lines[0], wanted), [lines, wanted])
    bars = [p for p in made["loads"]["parts"] if p["what"] == "bar"]
    bottom, count = made["loads"]["height"] - 18, len(frame["inner_force_n"])
    step, per_newton = (640 - 16) / count, (bottom - 18) / 1500
    wrong = []
    for k in range(count):
        for bar, force, colour, place in ((bars[2 * k], frame["inner_force_n"][k], FIRST, 0.12), (bars[2 * k + 1], frame["outer_force_n"][k], ORANGE, 0.5)):
            wanted = [8 + (k + place) * step, bottom - force * per_newton, force * per_newton]
            if bar["colour"] != colour or not near([bar["x"], bar["y"], bar["h"]], wanted):
                wrong.append([k + 1, bar, wanted])
    s.check("every ball has its loads", len(bars) == 2 * count and not wrong, wrong[:2])
    written = dict(made["numbers"])
    wanted = {"simulated": "4.0 ms", "first contact": "2.00 ms", "largest contact force": "4000 N", "force over rotor weight": f"{4000 / weight:.1f}",
              "rotor": "28400 rpm", "inner ring": "2800 rpm", "largest force of a ball": "1500 N"}  # fmt: skip
    s.check("numbers of a drop are those of their names", written == wanted, [written, wanted])
    s.check("and so are those of the moment", "rotor 29500 rpm, inner ring 4200 rpm, first contact at 2.00 ms" in made["said"], made["said"])


def drawings(s):
    """All of them, and the case as it was."""
    before = s.toml()
    bearing(s, 1)
    gaps(s)
    criteria(s)
    saved(s)
    compared(s)
    s.write("axial", 150)
    contacts(s)
    s.type(PAIR.read_text(encoding="utf-8"))
    bearing(s, 2)
    contacts(s)
    s.type(before)
    s.press("drop")
    s.settled()
    s.tab.wait_for(f"!!{S}.g.rotor && {S}.motion.frames.length > 3 && {S}.motion.frames.every((f) => f.rotor)")
    rotor(s)
    s.type(before)
    s.judged()
