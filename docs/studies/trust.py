"""How far to trust it: computed against measured, at eight of the twelve points of the paper."""

import csv
import math

from chart import dots
from page import ROOT, figures, fixed, markdown

PAGE = "docs/trust.md"
DATA = ROOT / "crates/cageless/tests/reference/rolling_torque.csv"


def points():
    """The rows of the measurement, with the torque measured in 1e-5 N·m."""
    lines = [line for line in DATA.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(lines)]
    for row in rows:
        row["measured"] = row["K"] * (row["speed_rpm"] * 2 * math.pi / 60) ** row["n"]
    return rows


POINTS = points()


def name(row):
    return f"{row['ball_diameter_mm']:g} mm, {row['speed_rpm']:.0f} rpm"


def share(row, of="transition"):
    return row[of] / row["measured"]


def tables():
    header = ["ball, load", "speed, rpm", "measured, 10⁻⁵ N·m", "computed", "computed/measured", "rigid surfaces alone"]
    lines = [
        [
            f"{row['ball_diameter_mm']:g} mm, {row['load_n']:g} N",
            fixed(row["speed_rpm"], 0),
            figures(row["measured"]),
            figures(row["transition"]),
            fixed(share(row), 2),
            figures(row["rigid"]),
        ]
        for row in POINTS
    ]
    return {"three-balls": markdown(header, lines)}


def picture():
    series = {
        "measured": [row["measured"] for row in POINTS],
        "computed": [row["transition"] for row in POINTS],
        "rigid surfaces alone": [row["rigid"] for row in POINTS],
    }
    return dots("Torque of three balls in oil, 10⁻⁵ N·m", [name(row) for row in POINTS], series, log=True)


def claims(claim):
    at = "answer"
    claim.between(0.55, (share(row) for row in POINTS), 0.91, at, "0.56 to 0.9 of the torque that was measured")
    claim(at, "at eight of its twelve points", len(POINTS) == 8, len(POINTS))
    at = "Measured"
    sizes = [row["ball_diameter_mm"] for row in POINTS]
    claim(at, "eight are held here, two series of four", [sizes.count(size) for size in set(sizes)] == [4, 4], sizes)
    for size in (3, 6.35):
        of = [share(row) for row in POINTS if row["ball_diameter_mm"] == size]
        claim(at, f"the share rises with the speed ({size:g} mm)", of == sorted(of), of)
    large = [share(row, "rigid") for row in POINTS if row["ball_diameter_mm"] == 6.35]
    claim.between(0.78, large, 1.07, at, "the rigid limit alone is within 0.8 and 1.06 of the larger balls")
    small = [share(row, "rigid") for row in POINTS if row["ball_diameter_mm"] == 3]
    claim.between(1.5, small, 2.1, at, "and one and a half to twice as much of the smaller ones")
