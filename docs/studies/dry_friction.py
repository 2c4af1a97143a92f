"""A discrete raceway without lubricant, in steady running."""

from chart import dots
from page import STUDIES, code, fixed, power, table

PAGE = "docs/dry-friction.md"
DESIGN, TOLERANCE, SMALL = STUDIES["dry-design"], STUDIES["dry-tolerance"], STUDIES["regularisation"]
SEARCH, VERIFY = STUDIES["dry-search"].rows[0], STUDIES["dry-verify"].rows[0]
DRY = "0.03", "0.1", "0.3"


def critical_gaps(row, influence):
    """Smallest and largest critical gap over the errors of one dimension."""
    return row["critical_gaps_deg"][row["influences"].index(influence)]


def span(row, influence):
    low, high = critical_gaps(row, influence)
    return f"{fixed(low, 3)} to {fixed(high, 3)}"


def tables():
    design = [
        ("critical gap, °", lambda r: fixed(r["critical_gap_deg"], 3)),
        ("double collisions, % of passages", lambda r: fixed(100 * r["double_collision_fraction"], 0)),
        ("sliding speed in a passage, m/s", lambda r: fixed(r["sliding_mean_m_s"], 3)),
        ("verdict", lambda r: code(r["verdict"])),
        ("recommended lC, mm", lambda r: fixed(r["recommended_axial_span_mm"], 3)),
        ("θ, °", lambda r: fixed(r["recommended_half_angle_deg"], 2)),
    ]
    tolerance = [
        ("critical gap, °", lambda r: fixed(r["critical_gap_deg"], 3)),
        ("over the groove depth", lambda r: span(r, "groove depth")),
        ("over μ = 0.2 to 0.4", lambda r: span(r, "friction coefficient")),
        ("bearings that pass", lambda r: f"{r['passed']} of {r['bearings']}"),
    ]
    small = [
        ("mean ring y, µm", lambda r: fixed(r["ring_y_mean_um"], 6)),
        ("energy balance error", lambda r: power(r["energy_residual_relative"])),
    ]
    return {
        "dry-design": table(DESIGN.rows, design),
        "dry-tolerance": table(TOLERANCE.rows, tolerance),
        "regularisation": table(SMALL.rows, small),
    }


def picture():
    shares = [100 * row["double_collision_fraction"] for row in DESIGN.rows]
    return dots("Passages of structure (d) with a double collision, %", [f"μ = {row.name}" for row in DESIGN.rows], {"": shares})


def claims(claim):
    at = "answer"
    claim(at, "structure (d) works lubricated and fails from μ = 0.03 on", DESIGN["0.007"]["passes"] and not any(DESIGN[mu]["passes"] for mu in DRY))
    claim.between(0.5, (DESIGN[mu]["double_collision_fraction"] for mu in DRY), 0.6, at, "more than half of the passages end in double collisions")
    claim.between(5.9, SEARCH["axial_span_mm"], 6.1, at, "the searched raceway has an lC of 6 mm, (d) 5.1 mm")
    claim.between(11, SEARCH["half_angle_deg"], 12, at, "and a half angle of less than half of that of (d)")

    at = "Structure (d) over the friction"
    claim.between(0.14, DESIGN["0.007"]["sliding_mean_m_s"], 0.18, at, "lubricated, a ball slides by about 0.16 m/s")
    claim.between(0, (DESIGN[mu]["sliding_mean_m_s"] for mu in DRY), 0.02, at, "from μ = 0.03 on it rolls nearly all the way")
    over = [DESIGN[mu]["critical_gap_deg"] / DESIGN[mu]["uniform_gap_deg"] for mu in DRY]
    claim.between(1.005, over, 1.015, at, "the critical gap rises above the nominal gap, by 1 %")
    claim.between(1.81, DESIGN["0.1"]["uniform_gap_deg"], 1.82, at, "the nominal gap is 1.82°")
    claim.between(0.9, SEARCH["critical_gap_deg"] / DESIGN["0.1"]["uniform_gap_deg"], 0.93, at, "that of the searched raceway is 9 % below it")
    claim.between(0, SEARCH["double_collision_fraction"], 0.005, at, "and has no double collisions")

    at = "Machining and friction"
    for row in TOLERANCE.rows:
        low, high = critical_gaps(row, "friction coefficient")
        claim.between(0, (high - low) / row["critical_gap_deg"], 0.001, at, f"above μ = 0.1 the result depends little on μ ({row.name})")
        low, high = critical_gaps(row, "groove depth")
        claim.between(0.03, (high - low) / row["critical_gap_deg"], 0.06, at, f"the depth of the groove matters ({row.name})")
    narrow, searched = TOLERANCE.rows
    claim(at, "a raceway that only just keeps the balls apart has no reserve for it", narrow["passed"] < narrow["bearings"])
    claim(at, "the other one has", searched["passed"] == searched["bearings"])

    at = "How small the regularisation speed may be"
    places = [row["ring_y_mean_um"] for row in SMALL.rows]
    claim.between(0, max(places) - min(places), 1e-4, at, "the mean place of the ring agrees to 0.1 nm")
    same = abs(SMALL["0.000001", "0.5"]["ring_y_mean_um"] - SMALL["Coulomb", "0.5"]["ring_y_mean_um"])
    claim.between(0, same, 1e-6, at, "the results go over into those of Coulomb's law")

    total = sum(VERIFY[kind] for kind in ("converged", "statistical", "step_biased"))
    claim(at, "all results but one are independent of step and initial state", VERIFY["converged"] >= total - 1, f"{VERIFY['converged']} of {total}")
