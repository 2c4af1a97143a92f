"""Rotor drops with and without a discrete raceway."""

import math

from chart import dots
from page import STUDIES, digits, figures, fixed, markdown, power, table

PAGE = "docs/touchdown-drops.md"
PAPER, SMALL, QUEUE = STUDIES["drops-paper"], STUDIES["drops-6205"], STUDIES["queue"]
FRICTION, LAW, APART = STUDIES["friction"], STUDIES["law"], STUDIES["apart"]
MASS, INTERFERENCE, PAIR, VERTICAL = (STUDIES[name] for name in ("mass", "interference", "drops-pair", "drops-vertical"))
RESTITUTION = STUDIES["restitution"]
STEP, METHOD, DRY_RACEWAY = STUDIES["step"], STUDIES["method"], STUDIES["dry-raceway"].rows[0]
CONVENTIONAL, DISCRETE = "conventional", "paper's (d)"
END, ABOVE_1 = "end_collision_rate_hz", "end_collision_rate_above_1_m_s_hz"
PRESSURE, HEAT = "ball_pressure_max_mpa", "ball_friction_total_j"


def colliding(row):
    """Drops of a row whose balls collide to the end."""
    return f"{row.colliding()} of {row.drops()}"


def changed(row, name):
    """Mean of a result over the drops of a row that have it, and its difference to the reference in the
    same drops; "equal" if that is less than 2 in a thousand."""
    mean, lacking = row.mean(name), row.drops() - len(row.of(name))
    text = figures(mean)
    if row.reference() is not row and (change := row.change(name)):
        difference, error = change
        sign = "−" if difference < 0 else "+"
        equal = abs(difference) + error < 2e-3 * abs(mean)
        text += " (equal)" if equal else f" ({sign}{figures(abs(difference), 2)} ± {figures(error, 2)})"
    return text + (f", {lacking} without" if lacking else "")


def spun_up(row):
    """Drops whose inner ring comes up to speed, and after how long."""
    times = row.of("spin_up_ms")
    mean = f" in {figures(row.mean('spin_up_ms'))} ms" if times else ""
    return f"{len(times)} of {row.drops()}{mean}"


def of_queue():
    """Rows of the balls of one drop, by angular position."""
    row = QUEUE["10 000"]
    start = row["sector_from_deg"]
    for k, first in enumerate(start):
        yield [
            f"{fixed(first, 0)}° to {fixed(first + start[1] - start[0], 0)}°",
            fixed(100 * row["speed_m_s"][k] / row["rolling_speed_m_s"], 0),
            fixed(100 * row["rotation_rad_s"][k] / row["rolling_rotation_rad_s"], 0),
            fixed(row["contacts_in_sectors_per_s"][k], 0),
            *(fixed(row[f"contacts_above_{speed}_m_s_per_s"][k], 0) for speed in ("0_1", "0_5", "1")),
        ]


RATES = [
    ("colliding", colliding),
    ("contacts per s at the end", lambda r: figures(r.mean(END))),
    ("above 1 m/s", lambda r: figures(r.mean(ABOVE_1))),
    ("pressure between balls, MPa", lambda r: figures(r.mean(PRESSURE))),
]
HEATS = [("dissipated at the balls, J", lambda r: figures(r.mean(HEAT))), ("spun up", spun_up)]
RACEWAYS = ("pressure on the raceways, MPa", lambda r: figures(max(r.mean("inner_pressure_max_mpa"), r.mean("outer_pressure_max_mpa"))))


def tables():
    above = [(f"above {speed} m/s", lambda r, speed=speed: figures(r.mean(f"end_collision_rate_above_{speed.replace('.', '_')}_m_s_hz"))) for speed in ("0.1", "0.5", "1")]
    drops = [
        ("colliding", colliding),
        ("contacts per s at the end", lambda r: changed(r, END)),
        *above,
        ("pressure between balls, MPa", lambda r: changed(r, PRESSURE)),
        ("dissipated at the balls, J", lambda r: changed(r, HEAT)),
        ("spin-up, ms", lambda r: changed(r, "spin_up_ms")),
    ]
    method = [
        ("contacts", lambda r: digits(str(r["collisions"]))),
        ("pressure between balls, MPa", lambda r: figures(r[PRESSURE], 4)),
        ("dissipated at the balls, J", lambda r: figures(r[HEAT], 4)),
        ("spin-up, ms", lambda r: figures(r["spin_up_ms"], 4)),
        ("energy balance error", lambda r: power(r["energy_residual_relative"])),
    ]
    plain = {name: table(STUDIES[name].rows, [*RATES, *HEATS]) for name in ("friction", "law", "apart", "restitution", "mass", "step", "dry-raceway")}
    preloaded = {"interference": INTERFERENCE, "pair": PAIR, "vertical": VERTICAL}
    queue = ["angular position ψ", "orbital speed, % of rolling", "rotational speed, % of rolling", "contacts per s", "above 0.1 m/s", "above 0.5 m/s", "above 1 m/s"]
    return {
        "queue": markdown(queue, of_queue()),
        "drops": table([*PAPER.rows, *SMALL.rows], drops),
        "method": table(METHOD.rows, method),
        **plain,
        **{name: table(study.rows, [*RATES, RACEWAYS, *HEATS]) for name, study in preloaded.items()},
    }


def picture():
    remedies = {
        "dry, μ = 0.1": (PAPER, "dry"),
        "μ = 0.07": (FRICTION, "0.07"),
        "μ = 0.05": (FRICTION, "0.05"),
        "μ = 0.03": (FRICTION, "0.03"),
        "0.1 falls to 0.05": (LAW, "0.1 → 0.05"),
        "between balls 0.03": (APART, "between balls: 0.03"),
        "outer raceway 0.007": (APART, "outer raceway: 0.007"),
        "restitution 0.5": (RESTITUTION, "0.5"),
        "2 µm interference": (INTERFERENCE, "2"),
        "pair, no preload": (PAIR, "0"),
    }
    rings = {"conventional ring": CONVENTIONAL, "discrete raceway": DISCRETE}

    def shares(ring):
        of = [study.of(place, "turned" if study is PAIR and ring is DISCRETE else ring) for study, place in remedies.values()]
        return [100 * collided(rows) for rows in of]

    return dots("Drops with balls that collide to the end, %", list(remedies), {name: shares(ring) for name, ring in rings.items()})


def wilson(count, total):
    """Upper end of the interval of 95 % for a probability."""
    z = 1.959964
    half = math.sqrt(count * (total - count) / total + z * z / 4)
    return (count + z * z / 2 + z * half) / (total + z * z)


def collided(rows):
    """Share of the drops of rows that collide to the end."""
    rows = list(rows)
    return sum(row.colliding() for row in rows) / sum(row.drops() for row in rows)


def claims(claim):
    at = "answer"
    dry = [*PAPER.of("dry", CONVENTIONAL), *PAPER.of("dry", DISCRETE)]
    claim.between(0.92, collided(dry), 0.98, at, "dry balls collide continuously with either ring, in 61 of 64 drops")

    at = "Mechanism"
    queue = QUEUE["10 000"]
    claim.between(0.99, [v / queue["rolling_speed_m_s"] for v in queue["speed_m_s"][5:7]], 1.01, at, "in the load zone the balls roll")
    claim.between(0.72, queue["queue_speed_fraction"], 0.74, at, "a queue at 73 % of the speed of rolling")
    claim.between(0.22, queue["rotation_least_fraction"], 0.24, at, "rotation down to 23 % of that of rolling")
    hard = queue["contacts_above_1_m_s_per_s"]
    claim.between(1.8, sum(hard) / queue["passages_per_s"], 2.2, at, "two real impacts for each passage of a ball")
    claim.between(0.9, sum(hard[k] for k in (1, 2, 7)) / sum(hard), 1, at, "at the two edges of the load zone")
    claim.between(0, queue["approach_speed_median_m_s"], 0.1, at, "the rest is chatter")

    at = "Discrete against conventional"
    pressure = [row.mean(PRESSURE) for study in (PAPER, SMALL) for row in study.of("dry")]
    claim.between(5000, pressure, 10000, at, "dry, the pressure between balls is far above 4200 MPa with either ring")
    claim.between(0.8, [collided(SMALL.of("dry", ring)) for ring in (CONVENTIONAL, "searched")], 0.9, at, "the 6205 behaves alike, dry")
    claim(at, "the 6205 behaves alike, lubricated", not any(row.colliding() for row in SMALL.of("lubricated")))
    few = STUDIES["search"]["physical"]["uniform_gap_deg"] / STUDIES["search"]["6205"]["uniform_gap_deg"]
    claim.between(2.5, few, 3.5, at, "the 6205 has gaps a third as wide")
    half = "end_collision_rate_above_0_5_m_s_hz"
    slow, wet = (PAPER[speed, "lubricated", DISCRETE] for speed in ("10 000", "30 000"))
    claim(at, "lubricated, the raceway adds contacts at 10 000 rpm", slow.change(END)[0] > 0)
    claim(at, "at 30 000 rpm it has fewer", wet.change(END)[0] < 0)
    claim(at, "but harder ones", min(wet.change(PRESSURE)[0], wet.change(half)[0]) > 0)
    for study in (FRICTION, LAW, APART):
        for row in study.of(CONVENTIONAL):
            other = study[{**row.places, "raceway": DISCRETE}]
            if not row.colliding() + other.colliding():
                claim(at, f"where balls do not collide continuously the discrete raceway has more contacts ({study.name}: {row.name})", other.mean(END) > row.mean(END))
    all_rows = [row for study in (PAPER, SMALL) for row in study.rows]
    force = "rotor_force_max_over_weight"
    claim.between(0, [abs(row.change(force)[0]) / row.mean(force) for row in all_rows], 0.006, at, "the largest force on the rotor does not depend on the raceway, to 0.6 %")
    claim(at, "no drop of 320 is in backward whirl at its end", sum(row.drops() for row in all_rows) == 320 and not any(row.count("end_state", lambda state: state == "backward-whirl") for row in all_rows))
    claim.between(0, wilson(0, sum(row.drops() for row in all_rows)), 0.0125, at, "at most 1.2 % of such drops are")

    at = "What decides"
    claim(at, "no drop collides continuously up to μ = 0.03", not any(row.colliding() for mu in ("0.02", "0.03") for row in FRICTION.of(mu)))
    light, heavy = (MASS["30 000", kg, CONVENTIONAL].mean("spin_up_ms") for kg in ("60", "200"))
    claim(at, "under a heavier rotor the ring comes up to speed all the same", heavy < light)
    claim(at, "2 µm of interference end the continuous collisions", not any(row.colliding() for um in ("2", "4", "10") for row in INTERFERENCE.of(um)))
    claim(at, "with 10 µm the balls of a conventional ring never touch", not any(row.mean("collisions") for row in INTERFERENCE.of("10", CONVENTIONAL)))
    claim(at, "with a discrete raceway contacts remain", all(row.mean(END) > 0 for row in INTERFERENCE.of("10", DISCRETE)))

    at = "A preloaded pair"
    claim(at, "a pair without clearance ends the continuous collisions", not any(row.colliding() for row in PAIR.rows))
    pressed = [PAIR[speed, "10", CONVENTIONAL].mean(PRESSURE) / PAIR[speed, "0", CONVENTIONAL].mean(PRESSURE) for speed in ("10 000", "30 000")]
    claim.between(0, pressed, 0.2, at, "in conventional rings the largest preload takes most of the pressure between balls")
    heats = []
    for row in PAIR.of(CONVENTIONAL):
        turned, symmetric = (PAIR[{**row.places, "raceways": name}] for name in ("turned", "symmetric"))
        claim(at, f"the turned one leaves at least as many contacts ({row.name})", turned.mean(END) >= row.mean(END))
        heats.append(symmetric.mean(HEAT) / row.mean(HEAT))
    claim.between(2, heats, 6, at, "the symmetric one makes two to six times the heat")
    claim(at, "at 30 000 rpm the turned one presses balls with more than 4200 MPa", all(row.mean(PRESSURE) > 4200 for row in PAIR.of("30 000", "turned")))
    others = [row for name in ("turned", "symmetric") for row in VERTICAL.of(name)]
    plain = [VERTICAL[{**row.places, "raceways": CONVENTIONAL}] for row in others]
    pressures = [a.mean(PRESSURE) / b.mean(PRESSURE) for a, b in zip(others, plain)]
    claim.between(8, pressures, 20, at, "either raceway brings back some ten times the pressure between balls")
    claim(at, "and more heat", all(a.mean(HEAT) > b.mean(HEAT) for a, b in zip(others, plain)))

    at = "How sure is this"
    one, other = METHOD.rows
    claim.between(0.97, [one[name] / other[name] for name in ("collisions", PRESSURE, HEAT, "spin_up_ms")], 1.03, at, "it does not depend on the method of integration")
    claim(at, "nor on the step", abs(STEP["half"].colliding() - STEP["automatic"].colliding()) < 3)
    claim(at, "a raceway searched for dry running does not prevent it", DRY_RACEWAY.colliding() > 4, DRY_RACEWAY.colliding())
