"""Whether a discrete raceway or one ball fewer helps, and what papers claim."""

import math

from chart import dots
from page import PLAIN, RACEWAY, STUDIES, error, figures, fixed, markdown, mean, measured, ratio, table, words

PAGE = "docs/benefit.md"
RINGS, SEARCH, AXIAL = STUDIES["benefit"], STUDIES["benefit-search"], STUDIES["axial-remedies"]
HELD, HELD_DESIGN = STUDIES["held"], STUDIES["held-design"]
REMEDIES, PAIR = STUDIES["remedies"].rows[0], STUDIES["remedies-pair"].rows[0]
SPANS = "4.6", "4.9", "5.1", "5.2"
LOTS_UM = {"G3": 0.13, "G10": 0.5, "G28": 1.4}
"""V_DwL of the grades (ISO 3290-1)."""
FEWER = 3
"""The plain ring with one ball fewer, in a comparison of remedies."""
COLLIDING = {"contacts": "contacts, 1/s", "gaps": "scatter of gaps, °", "force": "variation of force, N"}


def best(row):
    """Ring of the best raceway in a search by benefit: the one that the answer is about."""
    of_raceways = range(2, len(row["runs"]))
    return next((k for k in of_raceways if f"{row['benefits'][k]['headline']}." in row["answer"]), 2)


def of_rings(row, name, *rings):
    """Means of several rings as text."""
    return " → ".join(figures(mean(row, name, ring)) for ring in rings)


def of_pair(row):
    """Contacts of a held pair with the raceway in an orbit: thirteen pairs of the bearing of Zhao 2022 at 12 000 rpm."""
    return mean(row, "contacts") / (13 * 200 * 18.24 / (18.24 + 27.765))


def expected(span, grade):
    """Contacts of a held pair in an orbit by the theory of steady operation, in the bearing of Zhao 2022."""
    reserve, critical = HELD_DESIGN[span]["reserve"], HELD_DESIGN[span]["critical"]
    mean_gap = critical + reserve
    circle_um = 1e3 * (27.765 - (27.765 - 18.24) / 2)
    drift = 360 * LOTS_UM[grade] / 6 / circle_um / mean_gap
    return min(1, 1 - math.exp(-((reserve / mean_gap / 0.18) ** 2)) + drift / 0.015)


def remedies(row):
    """A table of remedies, a ring on each line."""
    heads = ["ring", "contacts, 1/s", "above 0.5 m/s, 1/s", "scatter of gaps, °", "variation of force, N", "ball pressure, MPa", "losses, W", "life L10r, h", "verdict"]
    rings = [
        [
            ring,
            *(measured(row, name, k) for name in ("contacts", "hard", "gaps", "force", "pressure", "loss")),
            figures(mean(row, "life", k), 4),
            words(row["benefits"][k]["benefit"]) if k else "–",
        ]
        for k, ring in enumerate(row["runs"])
    ]
    return markdown(heads, rings)


def tables():
    heads = [*COLLIDING.values(), "ball pressure, MPa", "losses, W"]
    rings = [
        (head, lambda r, name=name: of_rings(r, name, PLAIN, RACEWAY))
        for head, name in zip(heads, ("contacts", "gaps", "force", "pressure", "loss"))
    ]
    searched = [
        (head, lambda r, name=name: of_rings(r, name, PLAIN, best(r)))
        for head, name in zip(heads, ("contacts", "gaps", "force", "pressure", "loss"))
    ]
    axial = [(head, lambda r, name=name: of_rings(r, name, PLAIN, RACEWAY, FEWER)) for name, head in COLLIDING.items()]
    held = [
        [
            span,
            fixed(HELD_DESIGN[span]["critical"], 2),
            fixed(HELD_DESIGN[span]["reserve"], 2),
            fixed(math.sqrt(13) * HELD_DESIGN[span]["reserve"], 2),
            fixed(mean(HELD[span, "G10"], "gaps"), 2),
            *(f"{fixed(expected(span, grade), 2)} → {fixed(of_pair(HELD[span, grade]), 2)}" for grade in LOTS_UM),
        ]
        for span in SPANS
    ]
    return {
        "remedies": remedies(REMEDIES),
        "remedies-pair": remedies(PAIR),
        "benefit": table(RINGS.rows, [*rings, ("verdict", lambda r: words(r["benefit"]))]),
        "benefit-search": table(
            SEARCH.rows,
            [
                ("best raceway", lambda r: r["runs"][best(r)]),
                ("verdict", lambda r: words(r["benefit"])),
                *searched,
                ("one ball fewer", lambda r: words(r["benefits"][1]["benefit"])),
            ],
        ),
        "axial-remedies": table(
            AXIAL.rows,
            [*axial, *((name, lambda r, k=k: words(r["benefits"][k]["benefit"])) for name, k in (("raceway", RACEWAY), ("one ball fewer", FEWER)))],
        ),
        "held": markdown(
            ["lC, mm", "critical gap, °", "gap reserve, °", "scatter of gaps, °: theory", "runs, G10", "contacts per pair and orbit, theory → runs, G3", "G10", "G28"],
            held,
        ),
    }


def picture():
    names = {**COLLIDING, "pressure": "ball pressure, MPa", "loss": "losses, W"}
    rings = {"raceway": [ratio(REMEDIES, name) for name in names], "one ball fewer": [ratio(REMEDIES, name, FEWER) for name in names]}
    return dots("Bearing of Zhao 2022 in steady operation, ratio to the plain ring", [head.split(",")[0] for head in names.values()], rings, log=True)


def claims(claim):
    at = "answer"
    verdicts = [of and of["benefit"] for of in REMEDIES["benefits"]]
    claim(at, "structure (d) helps balls that have bunched", verdicts[RACEWAY] == "helps", verdicts)
    claim(at, "one ball fewer makes it worse, and two", verdicts[2:] == ["harms"] * 3, verdicts)

    at = "The bearing of Zhao 2022 and its remedies"
    claim.between(0.28, ratio(REMEDIES, "contacts"), 0.38, at, "a third of the contacts")
    claim.between(0.1, [ratio(REMEDIES, name) for name in ("gaps", "force")], 0.15, at, "an eighth of the scatter and of the force")
    claim.between(3, ratio(REMEDIES, "pressure"), 4, at, "three to four times the pressure between balls")
    claim.between(15, ratio(REMEDIES, "loss"), 18, at, "some 16 times the small losses")
    claim.between(1.8, ratio(REMEDIES, "force", FEWER), 2.2, at, "with one ball fewer the force doubles")
    claim(at, "the life falls with the number of balls", mean(REMEDIES, "life", 4) < mean(REMEDIES, "life", 3) < mean(REMEDIES, "life", 0))

    at = "Raceways and bearings"
    shown = [(r, name, ring) for r in RINGS.rows for name in ("contacts", "gaps", "force", "pressure", "loss") for ring in (PLAIN, RACEWAY)]
    known = [error(*of) / mean(*of) for of in shown if of[0].name != "preloaded pair, 15°"]
    claim.between(0, known, 0.12, at, "standard errors are about a tenth at most")
    claim(at, "a raceway that is too weak (lC 3 mm) is worse than none", RINGS["lC 3 mm, rigid"]["benefit"] == "harms" and ratio(RINGS["lC 3 mm, rigid"], "contacts") > 2)
    claim(at, "one that is slightly too long jams the balls", RINGS["lC 5.4 mm, rigid"]["benefit"] == "harms")
    long, paper = RINGS["lC 5.4 mm, elastic"], RINGS["(d), elastic"]
    claim(at, "on elastic flanks a longer raceway has fewer contacts", mean(long, "contacts") < mean(paper, "contacts"))
    claim(at, "but exceeds the pressure of ISO 76", long["benefit"] == "harms" and mean(long, "pressure") > 4200)
    for name in ("(d), 0.5 mrad of tilt", "(d), 150 N axial"):
        claim(at, f"it still helps with {name}", RINGS[name]["benefit"] == "helps", RINGS[name]["benefit"])
        claim.between(2, ratio(RINGS[name], "loss"), 3.2, at, f"at two to three times the losses: {name}")
    turning = RINGS["(d), unbalance of 158 N"]
    claim(at, "with an unbalance it helps as well", turning["benefit"] == "helps", turning["benefit"])
    dry = RINGS["6001, dry"]
    claim.between(0.75, ratio(dry, "contacts"), 0.87, at, "its raceway leaves a fifth fewer contacts")
    claim.between(11, ratio(dry, "loss"), 13, at, "at 12 times the losses")
    claim(at, "and the force varies more", ratio(dry, "force") > 1, ratio(dry, "force"))
    pair = RINGS["preloaded pair, 15°"]
    claim(at, "it is not judged", pair["benefit"] == "not-judged", pair["benefit"])
    claim.between(0.15, error(pair, "force", PLAIN) / mean(pair, "force", PLAIN), 0.3, at, "the force of the plain pair still wanders")

    at = "A pair of 7205C"
    full, fewer, plain_fewer = 1, 2, FEWER
    claim(at, "leave the full pair plain", all(of["benefit"] == "harms" for of in PAIR["benefits"][1:]), PAIR["benefits"])
    claim.between(1.8, [ratio(PAIR, name, full) for name in ("contacts", "loss")], 2.5, at, "a raceway doubles contacts and losses")
    claim.between(3.3, ratio(PAIR, "force", full), 5.3, at, "the force varies four times as much")
    claim(at, "one ball fewer touches less often", ratio(PAIR, "contacts", plain_fewer) < 0.75, ratio(PAIR, "contacts", plain_fewer))
    claim(at, "but its balls gather", ratio(PAIR, "gaps", plain_fewer) > 10, ratio(PAIR, "gaps", plain_fewer))
    held = {name: ratio(PAIR, name, fewer, plain_fewer) for name in (*COLLIDING, "loss", "pressure")}
    claim(at, "with fourteen balls the raceway pays", max(held[name] for name in COLLIDING) < 0.8, held)
    claim.between(0.14, held["contacts"], 0.2, at, "a sixth of the contacts")
    claim.between(0.68, held["force"], 0.8, at, "three quarters of the varying force")
    claim.between(1.85, held["loss"], 2.15, at, "twice the losses")

    at = "Gaps that a raceway holds"
    for span in SPANS:
        theory = math.sqrt(13) * HELD_DESIGN[span]["reserve"]
        claim.between(1, mean(HELD[span, "G10"], "gaps") / theory, 1.3, at, f"the scatter follows from the gap reserve, and is up to 30 % more (lC {span} mm)")
        claim.between(0.5, of_pair(HELD[span, "G28"]) / of_pair(HELD[span, "G3"]), 2, at, f"better balls do not touch less often (lC {span} mm)")
        for grade in LOTS_UM:
            held_ratio = expected(span, grade) / of_pair(HELD[span, grade])
            claim.between(0.5, held_ratio, 2, at, f"the estimate of the theory holds within a factor of two (lC {span} mm, {grade})")
    claim.between(0.9, of_pair(HELD["4.6", "G10"]), 1.05, at, "with a small critical gap every held pair meets once per orbit")
    claim.between(0.07, of_pair(HELD["5.2", "G10"]), 0.13, at, "near its largest once in ten")

    at = "The raceway that helps most"
    rigid, elastic, small, last = SEARCH.rows
    for row in (rigid, elastic, small):
        claim(at, f"the first three have a raceway that helps: {row.name}", row["benefit"] == "helps", row["benefit"])
    claim(at, "none is helped by one ball fewer", all(r["benefits"][1]["benefit"] == "harms" for r in SEARCH.rows))
    claim(at, "in the third at the cost of more contacts", ratio(small, "contacts", best(small)) > 1.2)
    claim(at, "in the last none is shown to help", last["benefit"] == "not-judged", last["benefit"])
    claim.between(0.45, mean(rigid, "contacts", best(rigid)) / mean(REMEDIES, "contacts"), 0.6, at, "the best raceway leaves half the contacts of structure (d)")
    claim(at, "scatters the gaps less", mean(rigid, "gaps", best(rigid)) < mean(REMEDIES, "gaps"))
    claim.between(0.95, mean(rigid, "pressure", best(rigid)) / mean(REMEDIES, "pressure"), 1.05, at, "and costs as much pressure")

    at = "What papers claim"
    claim(at, "the raceway helps under axial load, one ball fewer harms", all((r["benefits"][RACEWAY]["benefit"], r["benefits"][FEWER]["benefit"]) == ("helps", "harms") for r in AXIAL.rows))
    own = RINGS["(d), rigid"]
    others = RINGS["ellipse, rigid"], RINGS["shuttle, rigid"]
    less = all(r["benefit"] == "helps" and mean(r, n) > mean(own, n) for r in others for n in ("contacts", "gaps", "force"))
    claim(at, "ellipse and shuttle help less than the path of the paper", less)
