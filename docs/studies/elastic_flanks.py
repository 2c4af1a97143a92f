"""Rigid and elastic flanks of the ten structures of the paper."""

from chart import dots
from page import STUDIES, code, fixed, markdown

PAGE = "docs/elastic-flanks.md"
FLANKS, SPACE = STUDIES["flanks"], STUDIES["flanks-space"]
STRUCTURES = [f"({letter})" for letter in "abcdefghij"]
RIGID, ELASTIC = ({name: FLANKS[name, flanks] for name in STRUCTURES} for flanks in ("rigid", "elastic"))


def tables():
    header = ["structure", "β0, °", "critical gap, rigid, °", "elastic, °", "verdict, rigid", "elastic", "lag, rigid, °", "elastic, °", "in space, °"]
    lines = [
        [
            name,
            fixed(RIGID[name]["beta0"], 3),
            *(fixed(of[name]["critical_gap"], 3) for of in (RIGID, ELASTIC)),
            *(code(of[name]["verdict"]) for of in (RIGID, ELASTIC)),
            *(fixed(of[name]["lag"], 2) for of in (RIGID, ELASTIC)),
            fixed(SPACE[name]["lag"], 2),
        ]
        for name in STRUCTURES
    ]
    return {"flanks": markdown(header, lines)}


def picture():
    lags = {
        "plane, rigid": [RIGID[name]["lag"] for name in STRUCTURES],
        "plane, elastic": [ELASTIC[name]["lag"] for name in STRUCTURES],
        "space": [SPACE[name]["lag"] for name in STRUCTURES],
    }
    return dots("Lag per pass, °", STRUCTURES, lags)


def claims(claim):
    at = "answer"
    lost = {name: RIGID[name]["lag"] - ELASTIC[name]["lag"] for name in STRUCTURES}
    claim.between(0.2, lost.values(), 0.4, at, "the lag per pass falls by 0.2 to 0.4°")
    claim.between(0.13, lost["(d)"] / RIGID["(d)"]["lag"], 0.17, at, "for structure (d) by 15 %")
    gaps = [1 - ELASTIC[name]["critical_gap"] / RIGID[name]["critical_gap"] for name in STRUCTURES]
    claim.between(0.15, gaps, 0.2, at, "the critical gap falls by 15 to 20 %")
    claim.between(0, (abs(ELASTIC[name]["lag"] - SPACE[name]["lag"]) for name in STRUCTURES), 0.08, "table", "the plane gives the lag in space to 0.08°")

    at = "Verdicts"
    claim(at, "on elastic flanks all are too shallow", all(ELASTIC[name]["verdict"] == "too-shallow" for name in STRUCTURES))
    kept = [ELASTIC[name]["lag"] / RIGID[name]["lag"] for name in STRUCTURES]
    claim.between(0.75, kept, 1, at, "every structure keeps more than half of its lag")
