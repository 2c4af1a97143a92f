"""What the program of a page works with: stored results, numbers as text, Markdown tables, claims."""

import math
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "tests/tools"))

from checks import check
from studies import RESULTS, ROOT, studies

STUDIES = studies()
"""The studies of docs/results/studies.toml with their stored results, by name."""

PLAIN, RACEWAY = 0, 1
"""Rings of a comparison: the one with a plain groove and the one with a discrete raceway."""


# --- numbers as text ---


def digits(text):
    """Digits in groups of three from five digits on, a minus sign in place of a hyphen."""
    sign, (whole, point, fraction) = "−" if text.startswith("-") else "", text.lstrip("-").partition(".")
    if len(whole) > 4:
        first = len(whole) % 3 or 3
        whole = " ".join([whole[:first], *(whole[k : k + 3] for k in range(first, len(whole), 3))])
    return sign + whole + point + fraction


def fixed(value, places):
    """A number with `places` decimals."""
    return "–" if value is None else digits(f"{value:.{places}f}")


def figures(value, count=3):
    """A number to `count` significant digits, without an exponent."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    places = count - 1 - math.floor(math.log10(abs(value)))
    return digits(f"{round(value, places):.{max(places, 0)}f}")


def power(value):
    """Size of a small number as a power of ten."""
    mantissa, exponent = f"{abs(value):.0e}".split("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{mantissa} × 10{raised}"


def code(text):
    return f"`{text}`"


def words(name):
    """A name of the JSON as words."""
    return name.replace("-", " ")


# --- results ---


def mean(row, name, ring=RACEWAY):
    """Mean of a result of one ring of a comparison."""
    return row[name]["values"][ring]["mean"]


def error(row, name, ring=RACEWAY):
    """Standard error of that mean."""
    return row[name]["values"][ring]["standard_error"]


def measured(row, name, ring=RACEWAY):
    """Mean and standard error as text."""
    return f"{figures(mean(row, name, ring))} ± {figures(error(row, name, ring), 2)}"


def ratio(row, name, ring=RACEWAY, to=PLAIN):
    """Mean of a result of one ring over that of another."""
    return mean(row, name, ring) / mean(row, name, to)


# --- tables ---


def markdown(header, lines):
    """A table of Markdown."""
    return "\n".join(f"| {' | '.join(line)} |" for line in [header, ["---"] * len(header), *lines])


def table(rows, columns):
    """A table with the places of rows of studies on their axes, then with columns, each a heading and the text
    of a row."""
    header = [*rows[0].places, *(heading for heading, _ in columns)]
    return markdown(header, [[*row.places.values(), *(text(row) for _, text in columns)] for row in rows])


# --- claims ---


class Claims:
    """The claims of a page: each is a sentence that the page makes in its own words, and whether it holds."""

    def __init__(self, page):
        self.page = page

    def __call__(self, place, sentence, holds, found=""):
        """Whether a sentence under the heading `place` holds; `found` is what the results have instead."""
        check(f'{self.page}, {place}: "{sentence}"', holds, f"does not hold; the results have {found}" if found else "does not hold")

    def between(self, low, values, high, place, sentence):
        """Whether all values, or the one value, lie between two limits."""
        values = list(values) if hasattr(values, "__iter__") else [values]
        found = " to ".join(f"{value:.4g}" for value in sorted({min(values), max(values)}))
        self(place, sentence, all(low <= value <= high for value in values), found)
