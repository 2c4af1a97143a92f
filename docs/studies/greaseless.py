"""Bearings without grease: friction torque with and without a raceway."""

from chart import dots
from page import PLAIN, RACEWAY, STUDIES, error, figures, fixed, mean, ratio, table

PAGE = "docs/greaseless.md"
SIZES = "608", "6001", "6901"
CONTACTS = "inner", "outer", "between"
ALL, WHERE, DEEP = STUDIES["greaseless"], STUDIES["greaseless-where"], STUDIES["greaseless-deep"]
CHECK, PLANE, SKF = STUDIES["greaseless-check"], STUDIES["greaseless-plane"], STUDIES["greaseless-skf"]


def raceways(row, ring):
    """Friction power at both raceways, W."""
    return mean(row, "inner", ring) + mean(row, "outer", ring)


def share_between(row, ring):
    """Friction between balls over all friction."""
    return mean(row, "between", ring) / sum(mean(row, name, ring) for name in CONTACTS)


def of_greased(row, ring, size):
    """Torque over that of the greased bearing of this size at 1000 rpm."""
    return mean(row, "torque", ring) / SKF[size, "1000"]["torque"]


def both(of, row):
    """A result of the plain ring and of that with the raceway as text."""
    return " → ".join(figures(1000 * of(row, ring), 2) for ring in (PLAIN, RACEWAY))


TORQUE = [("torque, N·mm", lambda r: both(lambda row, ring: mean(row, "torque", ring), r))]
FRICTION = [
    *TORQUE,
    ("friction at the raceways, mW", lambda r: both(raceways, r)),
    ("between balls, mW", lambda r: both(lambda row, ring: mean(row, "between", ring), r)),
]


def tables():
    wear = ("F s between balls, kN·m per hour", lambda r: figures(3.6 * mean(r, "between") / 0.15, 2))
    deep = [
        *TORQUE,
        ("between balls, mW", lambda r: figures(1000 * mean(r, "between"), 2)),
        ("time without force at the inner ring, %", lambda r: fixed(100 * mean(r, "unloaded"), 0)),
        ("lag per pass, °", lambda r: figures(mean(r, "lag"), 2)),
        ("scatter of the gaps, °", lambda r: figures(mean(r, "gaps"), 2)),
        ("of the force on the outer ring, N", lambda r: figures(mean(r, "force"), 2)),
    ]
    return {
        "greaseless": table(ALL.rows, [*FRICTION, wear]),
        "where": table(WHERE.rows, FRICTION),
        "deep": table(DEEP.rows, deep),
        "check": table(CHECK.rows, TORQUE),
        "plane": table(PLANE.rows, TORQUE),
        "skf": table(
            [row for row in SKF.rows if row.places["speed, rpm"] == "1000"],
            [("torque of the lubricant, N·mm", lambda r: fixed(1000 * r["torque"], 2))],
        ),
    }


def picture():
    torques = {
        "greased, with a cage": [1000 * SKF[s, "1000"]["torque"] for s in SIZES],
        "dry, plain ring": [1000 * mean(ALL[s, "steel", "1000"], "torque", PLAIN) for s in SIZES],
        "dry, raceway": [1000 * mean(ALL[s, "steel", "1000"], "torque") for s in SIZES],
        "dry, raceway 10 µm deeper": [1000 * mean(DEEP[s, "10"], "torque") if s != "6001" else None for s in SIZES],
    }
    return dots("Friction torque at 1000 rpm under 20 N, N·mm", SIZES, torques, log=True)


def claims(claim):
    slow, fast = ALL.of("1000"), ALL.of("10 000")
    steel = {size: ALL[size, "steel", "1000"] for size in SIZES}

    at = "answer"
    claim.between(0.1, (of_greased(steel[s], PLAIN, s) for s in SIZES), 0.2, at, "a plain dry ring has 10 to 20 % of the torque of a greased one")
    claim.between(8, (ratio(r, "torque") for r in ALL.rows), 40, at, "a raceway multiplies the torque by 8 to 40")
    claim.between(1, (of_greased(steel[s], RACEWAY, s) for s in SIZES), 5, at, "with the raceway the torque is above that of the greased bearing")
    deep_ones = [of_greased(DEEP[s, "10"], RACEWAY, s) for s in ("608", "6901")]
    claim.between(0.1, deep_ones, 0.2, at, "a deep raceway keeps the torque below a fifth of that of the greased bearing")

    at = "Friction torque"
    claim.between(0, (error(r, "torque", PLAIN) / mean(r, "torque", PLAIN) for r in ALL.rows), 0.04, at, "errors below 4 % with a plain ring")
    claim.between(0, (error(r, "torque") / mean(r, "torque") for r in ALL.rows), 0.3, at, "up to 30 % with the raceway")
    claim.between(0, (error(r, "between") / mean(r, "between") for r in ALL.rows), 0.6, at, "up to 60 % for the friction between balls")
    claim.between(0.65, (share_between(r, RACEWAY) for r in slow), 0.75, at, "about 70 % of all friction at 1000 rpm")
    claim.between(0.35, (share_between(r, RACEWAY) for r in fast), 0.45, at, "about 40 % at 10 000 rpm")
    claim.between(0, (1000 * mean(r, "torque", PLAIN) for r in ALL.rows), 0.2, at, "in a plain ring the torque stays below 0.2 N·mm")
    claim.between(0, (share_between(r, PLAIN) for r in fast), 0.01, at, "at 10 000 rpm the balls of a plain ring rub for less than 1 % of all friction")

    def lowered(ring, speed):
        torques = ([mean(ALL[s, balls, speed], "torque", ring) for balls in ("Si3N4", "steel")] for s in SIZES)
        return [1 - ceramic / steel for ceramic, steel in torques]

    claim.between(0.35, lowered(PLAIN, "1000"), 0.55, at, "ceramic balls lower the friction of a plain ring by a third to a half at 1000 rpm")
    claim.between(0, lowered(PLAIN, "10 000"), 0.2, at, "less at 10 000 rpm")
    claim.between(-0.2, lowered(RACEWAY, "1000") + lowered(RACEWAY, "10 000"), 0.2, at, "with a raceway by less than a fifth")

    at = "What decides"
    base = WHERE["none"]
    torque = {row.name: mean(row, "torque") for row in WHERE.rows}
    claim.between(0.95, torque["raceway at the top"] / mean(base, "torque", PLAIN), 1.05, at, "out of the load zone the raceway does nothing")
    by_friction = [torque[name] for name in ("friction 0.007", "friction 0.05", "none")]
    grows = by_friction == sorted(by_friction) and torque["lag of a third"] < torque["none"] < torque["load 200 N"]
    claim(at, "with the raceway the torque grows with friction, load and lag", grows, torque)
    loaded = [ratio(row, "torque") for row in WHERE.rows if row.name != "raceway at the top"]
    claim.between(2, loaded, 45, at, "in the load zone it is above that of the plain ring in each row")
    claim.between(1.7, torque["100 rpm"] / torque["none"], 2.4, at, "at 100 rpm about twice as much")
    tight = WHERE["Gr −4 µm"]
    claim.between(3, mean(tight, "torque", PLAIN) / mean(base, "torque", PLAIN), 8, at, "preload makes a plain ring worse")
    claim.between(0, mean(tight, "between", PLAIN) / mean(base, "between", PLAIN), 0.01, at, "no ball touches another")

    at = "Balls that leave the inner ring"
    for size in ("608", "6901"):
        none, second, third = (DEEP[size, depth] for depth in ("0", "4", "10"))
        claim.between(0, mean(second, "torque") / mean(none, "torque"), 0.25, at, f"4 µm of depth take away three quarters of the torque or more ({size})")
        claim.between(1, ratio(third, "torque"), 1.2, at, f"10 µm leave 20 % more than the plain ring at most ({size})")
        claim.between(3, mean(third, "force") / mean(none, "force"), 4, at, f"the force varies three to four times as much ({size})")
    claim.between(1.4, (mean(r, "lag") for r in DEEP.rows), 3, at, "the lag stays")

    at = "What the numbers depend on"
    torque = {row.name: mean(row, "torque", PLAIN) / mean(base, "torque", PLAIN) for row in CHECK.rows}
    claim.between(0, torque["regularisation speed 0.02 m/s"], 0.8, at, "with the default regularisation speed the torque is too small")
    same = [torque[name] for name in ("regularisation speed 2e-4 m/s", "half the step", "15 strips")]
    claim.between(0.9, same, 1.1, at, "a smaller speed, half the step and more strips change the plain ring by less than a tenth")
    planar = {speed: [mean(PLANE[s, speed], "torque", PLAIN) / mean(ALL[s, "steel", speed], "torque", PLAIN) for s in SIZES] for speed in ("1000", "10 000")}
    claim.between(0, planar["1000"], 0.9, at, "the planar model has less torque of a plain ring at 1000 rpm")
    claim.between(0, planar["10 000"], 0.02, at, "next to none at 10 000 rpm")
