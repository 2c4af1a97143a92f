"""How an oil film spaces balls, and when they queue."""

from chart import dots
from page import STUDIES, fixed, table

PAGE = "docs/oil.md"
OIL = STUDIES["oil"]
QUEUE = 1.3
"""Speed deficit over the free share from which balls queue."""


def state(row):
    ratio = row["deficit"] / row["free"]
    return "queue" if ratio > QUEUE else "may queue" if ratio > 1.1 else "spaced"


def tables():
    columns = [
        ("speed lost d, %", lambda row: fixed(100 * row["deficit"], 1)),
        ("gap that opens, °", lambda row: fixed(row["gap"], 2)),
        ("balls", state),
        ("rolling resistance, W", lambda row: fixed(row["power"], 1)),
        ("Λ, least", lambda row: fixed(row["lambda"], 1)),
    ]
    return {"oil": table(OIL.rows, columns)}


def picture():
    names = ["flooded", "two drops", "0.1"]
    rows = [(speed, viscosity) for speed in ("3000", "12 000") for viscosity in ("2", "5", "20")]
    series = {name: [100 * OIL[(*row, name)]["deficit"] for row in rows] for name in names}
    return dots("Speed that a free ball loses to the film, %; oil of 2, 5, 20 mPa·s", [f"{speed} rpm, {viscosity}" for speed, viscosity in rows], series, log=True)


def claims(claim):
    at = "answer"
    flooded = [row for row in OIL.rows if row.places["supply"] == "flooded"]
    claim.between(0.009, (row["deficit"] for row in flooded), 0.19, at, "a flooded ball loses 1 to 19 % of its speed")
    claim.between(0.07, (row["free"] for row in OIL.rows), 0.072, at, "7 % of the pitch circle is free")
    queues = {row.places["viscosity, mPa·s"] for row in OIL.rows if state(row) != "spaced"}
    claim(at, "only the thickest oil at the low speed makes them queue", queues == {"20"}, queues)
    at = "What decides"
    for speed in ("3000", "12 000"):
        of = [OIL[speed, "5", supply]["deficit"] for supply in ("flooded", "0.1")]
        claim.between(9.5, of[0] / of[1], 10.5, at, f"supply decides by a factor of ten ({speed})")
        of = [OIL[speed, viscosity, "flooded"]["deficit"] for viscosity in ("20", "2")]
        claim.between(5, of[0] / of[1], 6.5, at, f"viscosity by five to six ({speed})")
    of = [OIL[speed, "5", "flooded"]["deficit"] for speed in ("3000", "12 000")]
    claim.between(3, of[0] / of[1], 4, at, "four times the speed lowers the loss to a third")
