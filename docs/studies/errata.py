"""What the paper has wrong, with numbers of `reproduce`."""

from page import STUDIES, fixed, markdown, ratio

PAGE = "docs/theory/errata.md"
REPRODUCE = STUDIES["reproduce"].rows[0]
FLANKS = STUDIES["flanks"]
REMEDIES = STUDIES["remedies"].rows[0]
CELLS = {
    cell: k for k, cell in enumerate(zip(REPRODUCE["speed_rpm"], REPRODUCE["balls"], REPRODUCE["ring"]))
}
"""Places of the comparison of rings in its lists, by speed, balls and ring."""
CONVENTIONAL, PAPER = "conventional", "structure (d)"


def of(name, *cell):
    return REPRODUCE[name][CELLS[cell]]


def tables():
    columns = zip("abcdefghij", REPRODUCE["theory_deg"], REPRODUCE["theory_polar_deg"])
    eq_11 = [[f"({name})", fixed(published, 4), fixed(polar, 4)] for name, published, polar in columns]
    rings = []
    for speed in (3000, 12000):
        for balls in ("equal balls", "G5", "G10", "G28"):
            line = [fixed(speed, 0), balls]
            for ring in (CONVENTIONAL, PAPER):
                cell = speed, balls, ring
                line += [f"{fixed(of('rms_m_s2', *cell), 3)} ± {fixed(of('rms_error_m_s2', *cell), 3)}", fixed(of("gap_deviation_deg", *cell), 1)]
            rings.append([*line[:2], line[2], line[4], line[3], line[5]])
    return {
        "eq-11": markdown(["structure", "as published, °", "with the position angle, °"], eq_11),
        "rings": markdown(["speed, rpm", "balls", "RMS of the housing, conventional, m/s²", "structure (d)", "deviation of the gaps, conventional, °", "structure (d)"], rings),
    }


def claims(claim):
    at = "4. The angle in Eq. (11)"
    missing = max(polar - published for polar, published in zip(REPRODUCE["theory_polar_deg"], REPRODUCE["theory_deg"]))
    claim.between(0.025, missing, 0.035, at, "designed for a gap up to 0.03° too small")

    at = "14. What the plane leaves out"
    claim.between(0.13, 1 - FLANKS["(d)", "elastic"]["lag"] / FLANKS["(d)", "rigid"]["lag"], 0.17, at, "structure (d) slows a ball by 15 % less")

    at = "Not given"
    for speed, balls in dict.fromkeys(cell[:2] for cell in CELLS):
        rms, gaps = ([of(name, speed, balls, ring) for ring in (CONVENTIONAL, PAPER)] for name in ("rms_m_s2", "gap_deviation_deg"))
        claim(at, f"the vibration is not lower with structure (d) ({speed:.0f} rpm, {balls})", rms[0] < rms[1], rms)
        claim(at, f"the gaps do even out ({speed:.0f} rpm, {balls})", gaps[1] < 0.6 * gaps[0], gaps)
    claim.between(0.28, ratio(REMEDIES, "contacts"), 0.38, at, "in steady operation structure (d) has a third of the contacts")
