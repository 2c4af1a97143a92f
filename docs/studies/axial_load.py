"""How much axial load and tilt a discrete raceway bears."""

from chart import dots
from page import PLAIN, RACEWAY, STUDIES, error, fixed, mean, measured, ratio, table

PAGE = "docs/axial-load.md"
PLANE, LOAD, BORNE, TILT = (STUDIES[f"axial-{name}"] for name in ("plane", "load", "borne", "tilt"))
DRY, RINGS, STRIPS = (STUDIES[f"axial-{name}"] for name in ("dry", "rings", "strips"))
PAIR, ROW = STUDIES["axial-pair"], STUDIES["axial-row"]


def lag(row):
    return row["lag_per_pass_deg"]


LAG = ("lag per pass, °", lambda r: fixed(lag(r), 2))
HEAT = [
    ("heat, inner, W", lambda r: fixed(r["power_loss_inner_friction_w"], 2)),
    ("heat, outer, W", lambda r: fixed(r["power_loss_outer_friction_w"], 2)),
]
ANGLE = ("contact angle, inner, °", lambda r: fixed(r["inner_contact_angle_mean_deg"] + 0.0, 1).replace("−0.0", "0.0"))
SPACE = [LAG, ("ring z, µm", lambda r: fixed(r["ring_z_mean_um"], 1).replace("−0.0", "0.0")), ANGLE, *HEAT]


def tables():
    turned = [LAG, ANGLE, ("deviation of the gaps, °", lambda r: fixed(r["gap_deviation_deg"], 1))]
    rings = [
        (head, lambda r, name=name: " → ".join(measured(r, name, ring) for ring in (PLAIN, RACEWAY)))
        for head, name in (("deviation of the gaps, °", "scatter"), ("contacts", "collisions"), ("deviation of the force, N", "force"))
    ]
    borne = [
        ("three quarters of the lag up to, N", lambda r: fixed(r["three_quarters"], 0)),
        ("half, N", lambda r: fixed(r["half"], 0)),
        ("none, N", lambda r: fixed(r["none"], 0)),
    ]
    return {
        "load": table(LOAD.rows, SPACE),
        "borne": table(BORNE.rows, borne),
        "tilt": table(TILT.rows, SPACE),
        "dry": table(DRY.rows, SPACE),
        "rings": table(RINGS.rows, rings),
        "pair": table(PAIR.rows, turned),
        "row": table(ROW.rows, turned),
        "plane": table(PLANE.rows, [LAG, *HEAT]),
        "strips": table(STRIPS.rows, SPACE),
    }


def picture():
    shares = "0", "0.1", "0.2", "0.5"
    lags = {"lubricated": [lag(LOAD[share, "structure (d)"]) for share in shares], "dry, μ = 0.1": [lag(DRY[share]) for share in shares]}
    return dots("Lag per pass, °, over the axial load", [f"Fa/Fr = {share}" for share in shares], lags)


def claims(claim):
    at = "answer"
    loaded = {row.places["Fa/Fr"]: lag(row) for row in LOAD.of("structure (d)")}
    claim.between(0.85, loaded["0.1"] / loaded["0"], 0.95, at, "an axial load of a tenth of the radial one leaves nine tenths of the lag")
    claim.between(0.2, loaded["0.5"] / loaded["0"], 0.3, at, "half of it leaves a quarter")

    at = "Axial load"
    for share in ("0.05", "0.1", "0.2", "0.5"):
        stiffer = LOAD[share, "structure (d)"]["ring_z_mean_um"] / LOAD[share, "conventional"]["ring_z_mean_um"]
        claim.between(0.6, stiffer, 0.95, at, f"the raceway stiffens the bearing along its axis (Fa/Fr {share})")

    for structure in "(a)", "(d)", "(g)", "(j)":
        halves = [BORNE[structure, friction]["half"] for friction in ("0.1", "0.007")]
        claim(at, f"dry balls lose half of their lag at a lower axial load {structure}", halves[0] < halves[1], halves)

    at = "Dry balls"
    claim(at, "dry balls lag more without axial load", lag(DRY["0"]) > 1.05 * loaded["0"], lag(DRY["0"]))
    claim(at, "and half of the radial load takes all of it", lag(DRY["0.5"]) <= 0, lag(DRY["0.5"]))

    at = "Tilt"
    claim.between(-0.25, (lag(TILT[tilt]) - lag(TILT["0"]) for tilt in ("0.5", "1", "2")), 0.25, at, "the lag changes by less than a quarter of a degree")

    at = "Rings compared"
    certain = {row.name: row["scatter"]["better"][1] for row in RINGS.rows}
    claim(at, "the raceway evens the gaps up to a fifth of the radial load", all(ok for name, ok in certain.items() if "0.5" not in name), certain)
    claim(at, "under half of it no difference is certain for lubricated balls", not certain["space, Fa/Fr 0.5 / 0.007"], certain)
    space, rigid, elastic = (RINGS[name, "0.007"] for name in ("space", "plane, rigid flanks", "plane, elastic flanks"))
    claim.between(0, mean(space, "collisions") / mean(rigid, "collisions"), 0.3, at, "lubricated balls touch a quarter as often in space as on rigid flanks")
    claim.between(2, (ratio(r, "force") for r in RINGS.rows if "Fa" in r.places["motion"]), 8, at, "under axial load the force varies two to eight times as much with the raceway")
    apart = abs(mean(space, "scatter") - mean(elastic, "scatter"))
    within = (error(space, "scatter") ** 2 + error(elastic, "scatter") ** 2) ** 0.5
    claim(at, "the plane with elastic flanks agrees with space within one standard error", apart < within, f"{apart:.3g} and {within:.3g}")

    at = "Angular contact and preloaded pairs"
    for study in (PAIR, ROW):
        turned, symmetric, plain = (study[name, "0.1"] for name in ("turned", "symmetric", "conventional"))
        claim.between(2, lag(turned), 2.3, at, f"dry, a turned raceway lets the balls lag by about 2° ({study.name})")
        claim.between(0.2, turned["gap_deviation_deg"] / plain["gap_deviation_deg"], 0.5, at, f"and spreads the bunch ({study.name})")
        claim.between(-2, lag(symmetric), -0.5, at, f"a symmetric one lets dry balls run ahead ({study.name})")
        wet = study["turned", "0.007"]
        claim.between(0, lag(wet) / lag(turned), 0.5, at, f"lubricated, the turned raceway does little ({study.name})")
        claim.between(0.7, wet["gap_deviation_deg"] / study["conventional", "0.007"]["gap_deviation_deg"], 1, at, f"to the gaps as well ({study.name})")
    worse = PAIR["symmetric", "0.1"]["gap_deviation_deg"] / PAIR["conventional", "0.1"]["gap_deviation_deg"]
    claim(at, "in the pair they stay bunched, worse than without a raceway", worse > 1, worse)
    better = ROW["symmetric", "0.1"]["gap_deviation_deg"] / ROW["conventional", "0.1"]["gap_deviation_deg"]
    claim.between(0.3, better, 0.6, at, "in the single row they spread")

    at = "In the plane"
    claim.between(-0.01, lag(PLANE["elastic"]) - lag(STRIPS["1"]), 0.01, at, "balls lag as in space with one strip")

    at = "Friction strips"
    claim.between(0.98, lag(STRIPS["3"]) / lag(STRIPS["9"]), 1.02, at, "three strips give the lag within two per cent")
    heat = STRIPS["1"]["power_loss_inner_friction_w"] / STRIPS["9"]["power_loss_inner_friction_w"]
    claim.between(0, heat, 0.1, at, "and misses most of the heat at the inner raceway")
