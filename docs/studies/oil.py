"""How an oil film spaces balls, and when they queue."""

import math

from chart import fields
from page import PLAIN, RACEWAY, STUDIES, error, figures, fixed, markdown, mean, table

PAGE = "docs/oil.md"
OIL, MOTION, DRY = STUDIES["oil"], STUDIES["oil-motion"], STUDIES["oil-dry"]
PAIR = "7205C pair, 7800 rpm"
QUEUE = 1.3
"""Speed deficit over the free share from which balls queue."""


def state(row):
    ratio = row["deficit"] / row["free"]
    return "queue" if ratio > QUEUE else "may queue" if ratio > 1.1 else "spaced"


def contacts(row, ring):
    return mean(row, "contacts", ring)


def does(row):
    """What oil and raceway do to the gaps, by their scatter in runs from the same starts."""
    if contacts(row, PLAIN) > 500:
        return "queue"
    difference = mean(row, "scatter", PLAIN) - mean(row, "scatter", RACEWAY)
    apart = 2 * math.hypot(error(row, "scatter", PLAIN), error(row, "scatter", RACEWAY))
    return "raceway" if difference > apart else "oil alone" if difference < -apart else "equal"


def place(row):
    """A place of the map."""
    found = does(row)
    if found == "queue":
        return f"**queue**, {figures(contacts(row, PLAIN), 2)} contacts a second"
    before, after = (fixed(mean(row, "scatter", ring), 2) for ring in (PLAIN, RACEWAY))
    hits = [figures(contacts(row, ring), 2) for ring in (PLAIN, RACEWAY)]
    return f"**{found}**, {before} → {after}; {' → '.join(hits)}"


def motion_map():
    supplies = list(dict.fromkeys(row.places["supply"] for row in MOTION.rows))
    rows = []
    for dry in DRY.rows:
        bearing = dry.places["bearing"]
        rows.append([bearing, "dry", place(dry), *["" for _ in supplies[1:]]])
        of = [row for row in MOTION.rows if row.places["bearing"] == bearing]
        for viscosity in dict.fromkeys(row.places["viscosity, mPa·s"] for row in of):
            at = [MOTION[bearing, viscosity, supply] for supply in supplies]
            rows.append(["", viscosity, *(place(row) for row in at)])
    return markdown(["bearing", "viscosity, mPa·s", *supplies], rows)


def tables():
    columns = [
        ("speed lost d, %", lambda row: fixed(100 * row["deficit"], 1)),
        ("gap that opens, °", lambda row: fixed(row["gap"], 2)),
        ("balls", state),
        ("rolling resistance, W", lambda row: fixed(row["power"], 1)),
        ("Λ, least", lambda row: fixed(row["lambda"], 1)),
    ]
    return {"oil-motion": motion_map(), "oil": table(OIL.rows, columns)}


def picture():
    shown = {"raceway": "raceway", "equal": "equal", "oil alone": "oil", "queue": "queue"}
    panels = {}
    for dry in DRY.rows:
        bearing = dry.places["bearing"]
        panels[bearing] = {"dry": [does(dry)] * 3}
        for row in (row for row in MOTION.rows if row.places["bearing"] == bearing):
            panels[bearing].setdefault(f"{row.places['viscosity, mPa·s']} mPa·s", []).append(does(row))
    return fields("What spaces the balls better: the raceway or the oil alone?", ["flooded", "two drops", "a tenth"], panels, shown)


def claims(claim):
    at = "At rest in the load"
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
    at = "motion"
    paper = "Zhao 2022, 12 000 rpm"
    thin = [row for row in MOTION.rows if row.places["bearing"] == paper and row.places["viscosity, mPa·s"] != "20"]
    claim(at, "at the high speed the raceway spaces balls in thin oil", {does(row) for row in thin} == {"raceway"})
    thick = MOTION[paper, "20", "flooded"]
    claim(at, "in the thickest oil it does not", does(thick) == "equal", does(thick))
    slow = MOTION["Zhao 2022, 3000 rpm", "5", "flooded"]
    claim(at, "at the low speed 5 mPa·s, flooded, space better alone", does(slow) == "oil alone", does(slow))
    queue = {tuple(row.places.values()) for row in MOTION.rows if does(row) == "queue"}
    expected = {("Zhao 2022, 3000 rpm", "20", "flooded"), ("Zhao 2022, 3000 rpm", "20", "two drops"), ("6205, 9000 rpm", "5", "flooded"), ("6205, 9000 rpm", "20", "flooded"), ("6205, 9000 rpm", "20", "two drops"), (PAIR, "20", "flooded")}
    claim(at, "queues: the slow bearing in thick oil, the 6205 from 5 mPa·s on, flooded, the pair at 20", queue == expected, queue)
    pair = {does(row) for row in MOTION.rows if row.places["bearing"] == PAIR and row.places["viscosity, mPa·s"] == "2"}
    claim(at, "the raceway helps the pair in thin oil", pair == {"raceway"}, pair)
    claim.between(900, (mean(row, "contacts", PLAIN) for row in MOTION.rows if does(row) == "queue"), 40000, at, "balls that queue meet a thousand times a second and more")
    starved = [row for row in MOTION.rows if row.places["supply"] == "0.1"]
    for row in starved:
        dry = next(one for one in DRY.rows if one.places["bearing"] == row.places["bearing"])
        off = mean(row, "scatter", RACEWAY) - mean(dry, "scatter", RACEWAY)
        claim(at, "a tenth of the supply is all but dry", abs(off) < 0.15, off)
