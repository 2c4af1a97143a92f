"""What the front page says of results and pictures."""

import json

from page import RESULTS, STUDIES, mean, ratio

PAGE = "README.md"
PICTURES = json.loads((RESULTS / "pictures.json").read_text(encoding="utf-8"))
REMEDIES = STUDIES["remedies"].rows[0]
FLANKS = STUDIES["flanks"]


def tables():
    return {}


def claims(claim):
    at = "picture of the studio"
    claim.between(1.815, PICTURES["beta0_deg"], 1.825, at, "its β0 is 1.82°")
    claim(at, "its verdict: works from evenly spaced balls, smooth", PICTURES["headline"].startswith("works from evenly spaced balls: smooth"), PICTURES["headline"])

    at = "What a discrete raceway does, and does not"
    claim.between(0.5, PICTURES["gap_deviation_deg"]["discrete"], 1, at, "the gaps scatter by less than 1° with the raceway")
    claim.between(6, PICTURES["gap_deviation_deg"]["conventional"], 7, at, "by more than 6° without")
    claim.between(1.75, PICTURES["nominal_gap_deg"], 1.85, at, "the nominal gap is 1.8°")
    contacts = PICTURES["contacts"]["discrete"] / PICTURES["contacts"]["conventional"]
    claim.between(1.7, contacts, 2.2, at, "with the raceway the balls touch about twice as often")
    claim(at, "in steady operation structure (d) helps", REMEDIES["benefits"][1]["benefit"] == "helps")
    claim.between(0.28, ratio(REMEDIES, "contacts"), 0.38, at, "a third of the contacts")
    claim.between(0.1, ratio(REMEDIES, "force"), 0.15, at, "an eighth of the varying force")
    claim.between(3, ratio(REMEDIES, "pressure"), 4, at, "contacts three to four times as hard")
    claim.between(0.45, mean(REMEDIES, "loss"), 0.55, at, "half a watt lost")
    claim(at, "one ball fewer makes it worse", REMEDIES["benefits"][3]["benefit"] == "harms")
    yielded = 1 - FLANKS["(d)", "elastic"]["critical_gap"] / FLANKS["(d)", "rigid"]["critical_gap"]
    claim.between(0.17, yielded, 0.22, at, "real flanks take a fifth of the critical gap of structure (d)")
