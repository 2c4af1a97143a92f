"""Shapes of the raceway at equal lag, and slots."""

import math

from chart import dots
from page import STUDIES, code, figures, fixed, markdown, mean, measured, table

PAGE = "docs/shapes.md"
PLANE, TOLERANCE, SEARCH, RINGS = (STUDIES[name] for name in ("shapes", "shapes-tolerance", "shapes-search", "shapes-rings"))
FRONT, PRESSURE = STUDIES["shapes-front"], STUDIES["shapes-pressure"]
EDGES, SLOTS, SLOTS_TOLERANCE = STUDIES["slots-edges"], STUDIES["slots-search"], STUDIES["slots-tolerance"]
SHAPES = {"quartic": 5.1, "ellipse": 4.585, "shuttle": 5.035, "steady": 4.906}
"""lC of each shape in mm, for equal lag."""
FRICTION, FLANKS = ("0.007", "0.1"), ("rigid", "elastic")
PAPER, SLOT = "path of the paper", ("slot, 0.3 mm", "slot, 1.2 mm", "slot, 2.4 mm")


def motion(row, name):
    """Motion of the recommended structure at the first operating point."""
    return row["structure"]["points"][0]["motion"][name]


def searched(row, name):
    return f"{figures(motion(row, name))} ± {figures(row['structure']['points'][0]['errors'][name], 2)}"


def gaps(row):
    """Smallest and largest critical gap of all bearings of a tolerance study."""
    found = [gap for verdict in row["verdicts"] for gap in verdict["critical_gap_deg"]]
    return min(found), max(found)


def rejected_for_pressure(row):
    return sum(of["count"] for of in row["rejections"] if of["reason"] == "stress")


VERDICT = [
    ("critical gap, °", lambda r: fixed(r["critical_gap"], 3)),
    ("verdict", lambda r: code(r["verdict"])),
    ("lag per pass, °", lambda r: fixed(r["lag"], 2)),
    ("double collisions, % of the passages", lambda r: fixed(100 * r["double"], 1)),
]
PASSING = [
    ("bearings that pass, %", lambda r: fixed(100 * r["probability"], 1)),
    ("95 % interval, %", lambda r: " to ".join(fixed(100 * of, 1) for of in r["interval"])),
]
STRUCTURE = [
    ("lC, mm", lambda r: fixed(r["structure"]["axial_span_mm"], 3)),
    ("θ, °", lambda r: fixed(r["structure"]["half_angle_deg"], 2)),
]
MOTION = [
    ("double collisions, % of the passages", lambda r: fixed(100 * motion(r, "double_collision_fraction"), 1)),
    ("spacing scatter", lambda r: searched(r, "spacing_scatter")),
    ("vibration, N", lambda r: searched(r, "force_deviation_n")),
    ("sliding friction, W", lambda r: searched(r, "friction_w")),
]


def tables():
    geometry = []
    for shape, span in SHAPES.items():
        row = PLANE[shape, "0.007", "rigid"]
        geometry.append([shape, fixed(span, 3), fixed(row["kinematic"], 2), fixed(row["change"], 3), fixed(row["beta0"], 3)])
    front = [
        ("largest change of the orbital speed per rad", lambda r: fixed(r["change"], 3)),
        ("slope discontinuity, °", lambda r: fixed(r["kink"], 2)),
        ("sliding speed, m/s", lambda r: fixed(r["sliding"], 3)),
        ("critical gap, °", lambda r: fixed(r["critical_gap"], 3)),
        ("pressure in the raceway, MPa", lambda r: fixed(PRESSURE[r.name]["pressure"][0], 0)),
    ]
    rings = [
        ("lag per pass, °", lambda r: fixed(mean(r, "lag"), 2)),
        ("deviation of the gaps, °", lambda r: measured(r, "scatter")),
        ("contacts", lambda r: measured(r, "collisions")),
        ("sliding speed, m/s", lambda r: fixed(mean(r, "sliding"), 2)),
        ("deviation of the force on the outer ring, N", lambda r: measured(r, "force")),
    ]
    slots = [
        ("critical gap, °", lambda r: fixed(r["structure"]["points"][0]["critical_gap_deg"], 3)),
        ("verdict", lambda r: code(r["verdicts"][0]["verdict"])),
        ("contact pressure at rest, MPa", lambda r: fixed(r["verdicts"][0]["pressure_at_rest_mpa"], 0)),
        ("share of the lag, %", lambda r: fixed(100 * motion(r, "lag_fraction"), 0)),
    ]
    others = [
        ("critical gap, °", lambda r: " to ".join(fixed(gap, 2) for gap in gaps(r))),
        ("others", lambda r: ", ".join(f"{v['count']} {code(v['verdict'])}" for v in r["verdicts"] if not v["passes"] and v["count"]) or "none"),
    ]
    return {
        "geometry": markdown(["shape", "lC, mm", "lag in pure rolling under load, °", "largest change of the orbital speed per rad", "β0, °"], geometry),
        "shapes": table(PLANE.rows, [*VERDICT, ("sliding speed, m/s", lambda r: fixed(r["sliding"], 3))]),
        "front": table(FRONT.rows, front),
        "search": table(
            SEARCH.rows,
            [
                ("found", lambda r: r["structure"]["shape"]),
                *STRUCTURE,
                ("gap reserve, °", lambda r: fixed(r["structure"]["points"][0]["margin_deg"], 3)),
                *MOTION,
            ],
        ),
        "tolerance": table(TOLERANCE.rows, PASSING),
        "rings": table(RINGS.rows, rings),
        "slots-edges": table(EDGES.rows, [("contact pressure at rest, MPa", lambda r: fixed(r["pressure"], 0)), *VERDICT]),
        "slots-search": table(SLOTS.rows, [*STRUCTURE, *slots, *MOTION]),
        "slots-tolerance": table(SLOTS_TOLERANCE.rows, [*PASSING, *others]),
    }


def needed(change, half_angle_deg):
    """Lag in degrees of a raceway over which the orbital speed changes at this constant rate per rad."""
    angle = math.radians(half_angle_deg)
    return 2 * half_angle_deg * abs((math.expm1(change * angle) / change - angle) / angle)


def picture():
    passing = {f"friction {of}": [100 * TOLERANCE[shape, of]["probability"] for shape in SHAPES] for of in FRICTION}
    return dots("Machined bearings that pass, %", list(SHAPES), passing)


def claims(claim):
    at = "answer"
    change = {shape: PLANE[shape, "0.007", "rigid"]["change"] for shape in SHAPES}
    claim.between(0.73, change["steady"] / change["quartic"], 0.77, at, "the rate falls to three quarters of that of the path of the paper")
    claim(at, "the steady raceway has the smallest rate", change["steady"] == min(change.values()), change)
    for friction, low, high in (("0.007", 1.85, 2.1), ("0.1", 4, 4.7)):
        passing = TOLERANCE["steady", friction]["probability"] / TOLERANCE["quartic", friction]["probability"]
        claim.between(low, passing, high, at, f"two to four times as many machined bearings pass (friction {friction})")
    for friction in FRICTION:
        for flanks in FLANKS:
            others = [PLANE[shape, friction, flanks]["sliding"] for shape in ("quartic", "shuttle")]
            claim(at, f"on the steady raceway balls slide least ({friction}, {flanks})", PLANE["steady", friction, flanks]["sliding"] < min(others))
    claim.between(2.29, needed(6 / 7 * change["steady"], 25.2), 2.34, at, "no raceway of this half angle and lag can need less than six sevenths of it")

    at = "In the plane"
    verdicts = {(s, f, m): PLANE[s, f, m]["verdict"] for s in SHAPES for f in FRICTION for m in FLANKS}
    rigid = [verdicts[shape, "0.1", "rigid"] for shape in SHAPES]
    claim(at, "dry on rigid flanks the path of the paper has double collisions and the ellipse is too shallow", rigid == ["double-collision", "too-shallow", "smooth", "smooth"], rigid)
    wet = [verdicts[shape, "0.007", "elastic"] for shape in SHAPES]
    claim(at, "on elastic flanks all are too shallow when lubricated", wet == ["too-shallow"] * 4, wet)
    dry = [verdicts[shape, "0.1", "elastic"] for shape in SHAPES]
    claim(at, "dry all but the ellipse pass", dry == ["smooth", "too-shallow", "smooth", "smooth"], dry)

    at = "Friction demand, slope discontinuity and pressure"
    of = {row.name: row for row in FRONT.rows}
    blended = [of[f"{s}, 1 mm"]["change"] / of[f"{s}, sharp"]["change"] for s in ("quartic", "shuttle", "steady")]
    claim.between(0.99, blended, 1.01, at, "a blend of 1 mm costs nothing on three shapes")
    claim(at, "over 2 mm the steady raceway loses its advantage", of["steady, 2 mm"]["change"] > of["shuttle, 2 mm"]["change"])
    claim.between(0.85, (max(r["pressure"][0] for r in PRESSURE.rows) / max(r["pressure"]) for r in PRESSURE.rows), 0.92, at, "each contact in the raceway has some 10 % less than those on the plain one")

    at = "The best raceway of each shape"
    for friction, low, high in (("0.1", 12, 13.5), ("0.007", 22, 27)):
        angles = [SEARCH[friction, s]["structure"]["half_angle_deg"] for s in (*SHAPES, "all")]
        claim.between(low, angles, high, at, f"about the same size on every shape ({friction})")
    heat = SEARCH["0.1", "quartic"]
    apart = [abs(motion(SEARCH["0.1", s], "friction_w") - motion(heat, "friction_w")) for s in SHAPES]
    claim.between(0, apart, 2 * heat["structure"]["points"][0]["errors"]["friction_w"], at, "dry, the friction is the same within its errors")
    claim(at, "lubricated, the search over all shapes keeps the path of the paper", SEARCH["0.007", "all"]["structure"]["shape"] == "quartic")

    at = "Machining errors"
    for friction in FRICTION:
        steady, quartic, ellipse = (TOLERANCE[s, friction] for s in ("steady", "quartic", "ellipse"))
        claim(at, f"the steady raceway leaves room for errors ({friction})", steady["interval"][0] > quartic["interval"][1])
        claim.between(0, ellipse["probability"], 0.05, at, f"almost no ellipse passes ({friction})")

    at = "In space"
    for friction in FRICTION:
        for load in ("none", "a tenth"):
            lags = [mean(RINGS[s, friction, load], "lag") for s in SHAPES]
            claim.between(0, max(lags) - min(lags), 0.03, at, f"all four lag by the same to 0.03° ({friction}, axial load {load})")
            force = [mean(RINGS[s, friction, load], "force") for s in ("quartic", "shuttle", "steady", "ellipse")]
            least, *between, largest = force
            claim(at, f"the force varies least with the path of the paper and most with the ellipse ({friction}, {load})", least < min(between) and max(between) < largest, force)

    at = "Slots"
    lags, closed = ([row[name] for row in EDGES.rows] for name in ("lag", "critical_gap"))
    claim.between(1, [max(lags) / min(lags), max(closed) / min(closed)], 1.02, at, "the radius of the edges leaves lag and critical gap as they are, to 2 %")
    for row in EDGES.rows:
        expected = row.name in ("0.15", "0.3", "0.6")
        claim(at, f"up to 0.6 mm the edges bear more than 4200 MPa ({row.name} mm)", (row["pressure"] > 4200) == (row["verdict"] == "overloaded") == expected)
    paper, slots = SLOTS[PAPER], [SLOTS[name] for name in SLOT]
    claim.between(5, (motion(paper, "friction_w") / motion(s, "friction_w") for s in slots), 21, at, "a slot takes 5 to 20 times less friction")
    claim.between(14, (motion(s, "force_deviation_n") / motion(paper, "force_deviation_n") for s in slots), 21, at, "the force varies 14 to 20 times as much")
    even = [motion(s, "spacing_scatter") / motion(paper, "spacing_scatter") for s in slots[1:]]
    claim.between(0, even, 0.3, at, "with round edges the balls are spaced more evenly")
    claim.between(45, rejected_for_pressure(slots[0]), 55, at, "with edges of 0.3 mm the search rejects 50 structures for their pressure")
    claim(at, "with 2.4 mm none", rejected_for_pressure(slots[2]) == 0)
    claim(at, "all bearings pass with the path of the paper", SLOTS_TOLERANCE[PAPER]["probability"] == 1)
    half = SLOTS_TOLERANCE["slot, 1.2 mm"]
    claim.between(0.4, half["probability"], 0.6, at, "with 1.2 mm half of the bearings fail")
    low, high = gaps(SLOTS_TOLERANCE["slot, 2.4 mm"])
    claim(at, "the critical gap of a deep slot is 1.4 to 3.4°", 1.35 < low < 1.45 and 3.3 < high < 3.4, f"{low} to {high}")
    claim.between(1.8, slots[2]["structure"]["steady_gap_deg"], 2.1, at, "while the balls have about 2° between them")
