"""Raceways whose ends are blended into the groove."""

from chart import dots
from page import RACEWAY, STUDIES, code, error, fixed, mean, measured, table

PAGE = "docs/blended-ends.md"
PLANE, SPACE = STUDIES["blended"], STUDIES["blended-rings"]
STRUCTURES = "(a)", "(d)", "(j)"


def tables():
    plane = [
        ("critical gap, °", lambda r: fixed(r["critical_gap"], 3)),
        ("verdict", lambda r: code(r["verdict"])),
        ("lag per pass, °", lambda r: fixed(r["lag"], 3)),
        ("double collisions, % of the passages", lambda r: fixed(100 * r["double"], 1)),
        ("sliding speed, m/s", lambda r: fixed(r["sliding"], 3)),
    ]
    space = [
        ("lag per pass, °", lambda r: fixed(mean(r, "lag"), 2)),
        ("deviation of the gaps, °", lambda r: measured(r, "scatter", RACEWAY)),
        ("contacts", lambda r: measured(r, "collisions", RACEWAY)),
        ("sliding speed, m/s", lambda r: fixed(mean(r, "sliding"), 2)),
        ("deviation of the force on the outer ring, N", lambda r: measured(r, "force", RACEWAY)),
    ]
    return {"blended": table(PLANE.rows, plane), "blended-rings": table(SPACE.rows, space)}


def picture():
    blends = "0.5", "1", "2"
    lost = {s: [100 * (1 - PLANE[s, "rigid", b]["lag"] / PLANE[s, "rigid", "0"]["lag"]) for b in blends] for s in STRUCTURES}
    return dots("Lag lost to the blend, %", [f"blend {b} mm" for b in blends], lost)


def claims(claim):
    at = "answer"
    for name, most in (("lag", 0.002), ("critical_gap", 0.003)):
        changes = [abs(PLANE[s, f, "0.5"][name] - PLANE[s, f, "0"][name]) for s in STRUCTURES for f in ("rigid", "elastic")]
        claim.between(0, changes, most, at, f"a blend of 0.5 mm changes the {name.replace('_', ' ')} by less than {most}°")
    claim.between(0.93, PLANE["(j)", "rigid", "2"]["lag"] / PLANE["(j)", "rigid", "0"]["lag"], 0.96, at, "over 2 mm the short raceway (j) loses 6 % of its lag")

    for name in ("scatter", "force", "collisions"):
        changes = [abs(mean(SPACE[s, b], name) - mean(SPACE[s, "0"], name)) / error(SPACE[s, "0"], name) for s in STRUCTURES for b in ("0.5", "1", "2")]
        claim.between(0, changes, 2, "In space", f"{name} as without a blend, within two standard errors")
