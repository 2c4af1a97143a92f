"""Raceways that the search recommends."""

import re

from chart import dots
from page import STUDIES, digits, fixed, markdown, table

PAGE = "docs/design-examples.md"
SEARCH, PLACES = STUDIES["search"], STUDIES["positions"].rows[0]
RIGID, ELASTIC = ("physical", "6205"), ("elastic", "6205, elastic")


def size(row, which="recommended"):
    """Dimensions of a raceway."""
    return f"{fixed(row[which + '_axial_span_mm'], 3)} mm, {fixed(row[which + '_half_angle_deg'], 2)}°"


def against(row, name):
    """What a search finds on a result: of the recommended raceway, of that of the case, the mean of their
    difference from the same starts and its standard error."""
    found = re.search(rf"{name} (\S+) against (\S+), difference (\S+) ± (\S+)", " ".join(row["findings"]))
    return found.groups()


def compared(row, name):
    return [float(text.replace("−", "-")) for text in against(row, name)]


def text_against(row, name):
    recommended, own, change, error = map(digits, against(row, name))
    return f"{recommended} against {own} ({change} ± {error})"


def critical_gap(row):
    return f"{fixed(row['recommended_critical_gap_deg'], 3)} of {fixed(row['recommended_steady_gap_deg'], 3)}"


def single():
    """Places in the lists of the positions of one raceway that is acceptable, in the order of these positions."""
    angles = PLACES["centre_angles_deg"]
    acceptable = [k for k, of in enumerate(angles) if len(of) == 1 and PLACES["axial_span_mm"][k] is not None]
    return sorted(acceptable, key=lambda k: angles[k])


def tables():
    paper = [
        ("recommended lC, θ", size),
        ("deviation of the gaps, °", lambda r: text_against(r, "gap deviation in degrees")),
        ("contacts per ball and orbit", lambda r: text_against(r, "collisions per ball and orbit")),
        ("in steady state", lambda r: text_against(r, "of these in steady state")),
        ("friction, W", lambda r: text_against(r, "friction loss in W")),
        ("gap reserve, °", lambda r: f"{fixed(r['recommended_margin_deg'], 3)} against {fixed(r['own_margin_deg'], 3)}"),
    ]
    names = "axial_span_mm", "half_angle_deg", "margin_deg", "collisions_late", "gap_min_deg", "spacing_scatter", "sliding_m_s"
    places = [
        [fixed(PLACES["centre_angles_deg"][k][0], 0), *(fixed(PLACES[name][k], 3 if name in ("axial_span_mm", "margin_deg") else 2) for name in names)]
        for k in single()
    ]
    bearings = [
        [
            bearing,
            fixed(SEARCH[rigid]["uniform_gap_deg"], 3),
            *(text(SEARCH[search]) for search in (rigid, elastic) for text in (size, critical_gap)),
            *(fixed(SEARCH[search]["recommended_friction_w"], 2) for search in (rigid, elastic)),
        ]
        for bearing, rigid, elastic in zip(("Zhao 2022", "6205"), RIGID, ELASTIC)
    ]
    header = ["bearing", "nominal gap, °", "rigid flanks: lC, θ", "critical gap of steady-state gap, °", "elastic flanks: lC, θ"]
    return {
        "search": table([SEARCH["physical"], SEARCH["paper"]], paper),
        "positions": markdown(
            ["ψ, °", "best lC, mm", "best θ, °", "gap reserve, °", "contacts in steady state", "smallest gap on arrival, °", "spacing scatter", "sliding speed, m/s"],
            places,
        ),
        "bearings": markdown([*header, "critical gap of steady-state gap, °", "friction, W: rigid", "elastic"], bearings),
    }


def picture():
    names = {"3000 rpm": "3000 rpm", "physical": "12 000 rpm", "elastic": "12 000 rpm, elastic", "6205": "6205", "6205, elastic": "6205, elastic"}
    angles = {"": [SEARCH[name]["recommended_half_angle_deg"] for name in names]}
    return dots("Half angle θ of the recommended raceway, °", list(names.values()), angles)


def claims(claim):
    physical, paper, slow, fast = (SEARCH[name] for name in ("physical", "paper", "3000 rpm", "20 000 rpm"))
    at = "answer"
    claim.between(0, abs(physical["recommended_axial_span_mm"] - physical["own_axial_span_mm"]), 0.02, at, "the recommended lC is that of structure (d)")
    claim.between(1, physical["recommended_half_angle_deg"] - physical["own_half_angle_deg"], 1.2, at, "its half angle is 1° larger")
    own, difference, error = compared(physical, "gap deviation in degrees")[1:]
    claim.between(0.06, -difference / own, 0.1, at, "the gaps deviate 8 % less")
    claim(at, "which is beyond two standard errors", -difference > 2 * error)
    difference, error = compared(physical, "collisions per ball and orbit")[2:]
    claim(at, "there are more contacts", difference > 2 * error)
    claim(at, "and a smaller gap reserve", physical["recommended_margin_deg"] < physical["own_margin_deg"])

    at = "The paper's bearing"
    claim(at, "structure (d) is acceptable in the physical formulation", not any("not acceptable" in f for f in physical["findings"]))
    bunched = [f for f in paper["findings"] if "not acceptable: double collisions" in f and "bunched start" in f]
    claim(at, "in the paper's it has too many double collisions from a bunched start", bool(bunched), paper["findings"])

    at = "Speed"
    claim.between(0.45, slow["recommended_half_angle_deg"] / physical["recommended_half_angle_deg"], 0.6, at, "at 3000 rpm the raceway is half as long")
    claim.between(5.7, slow["recommended_axial_span_mm"], 5.9, at, "with an lC of 5.8 mm")
    claim(at, "at 20 000 rpm there is none, the nearest is too deep", fast["recommended_axial_span_mm"] is None and "fails: too deep" in fast["findings"][0], fast["findings"])

    at = "Angular position and number"
    found = {tuple(angles) for angles, span in zip(PLACES["centre_angles_deg"], PLACES["axial_span_mm"]) if span is not None}
    claim(at, "raceways from −30° to 30° are acceptable, none beyond and no pair", found == {(float(a),) for a in (-30, -15, 0, 15, 30)}, found)
    gap = {PLACES["centre_angles_deg"][k][0]: PLACES["gap_min_deg"][k] for k in single()}
    claim(at, "behind the bottom balls arrive with smaller gaps", all(gap[a] < gap[-a] - 0.2 for a in (15, 30)), gap)

    at = "Other bearings"
    small = SEARCH["6205"]
    claim.between(0.25, small["uniform_gap_deg"] / physical["uniform_gap_deg"], 0.33, at, "the full complement has less than a third of the gap")
    claim(at, "its raceway has a smaller span", small["recommended_axial_span_mm"] < 0.7 * physical["recommended_axial_span_mm"])
    often = small["recommended_collisions_late"] / physical["recommended_collisions_late"]
    claim.between(5, often, 10, at, "its balls touch several times as often")
    for name in ("6203", "6203, elastic"):
        claim(at, f"for the smallest nothing is recommended, by double collisions: {name}", SEARCH[name]["recommended_axial_span_mm"] is None and "double collisions" in SEARCH[name]["findings"][0])

    at = "On elastic flanks"
    elastic = SEARCH["elastic"]
    claim.between(1.4, elastic["recommended_half_angle_deg"] / physical["recommended_half_angle_deg"], 1.6, at, "the raceway takes up half as much again of the circumference")
    claim.between(2.5, SEARCH["6205, elastic"]["recommended_half_angle_deg"] / small["recommended_half_angle_deg"], 3, at, "in the 6205 almost three times as much")
    claim.between(5, elastic["recommended_friction_w"] / physical["recommended_friction_w"], 7, at, "friction is six times that on rigid flanks")
