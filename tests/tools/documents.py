"""Writes the numbers of the documents from results, and checks that they are there.

    python documents.py write                      # fills the documents from docs/results
    python documents.py check                      # fails where a document and its results differ
    python documents.py compute CAGELESS [TARGET]  # computes docs/results anew, then writes
        --only STUDY …       only these studies
        --missing            only rows without results
        --compare            compares with docs/results instead of replacing them
        --sample             with --compare: one row of each study, of drops the first one
        --seed TEXT          of that sample, by default the commit: over commits every row has its turn
        --finished STUDY=DIR uses an earlier run of the command of a study
        --threads N          commands at the same time, default: one for each core

A number between `<!-- = EXPRESSION -->` and `<!-- / -->` is the value of a Python expression over the studies
(`tests/tools/studies.py`), a table after `<!-- table NAME -->` has the rows of its studies and the columns that
`docs/results/studies.toml` declares. `<!-- holds EXPRESSION -->` is a condition on which the words next to it depend. `compute` can be interrupted: the same program does not compute a row twice.

Refused outside of markers, code, formulas and links: numbers with a decimal point, with a unit, of three digits
or more, "n of m", and numbers in tables, unless `docs/results/typed.toml` names them with the reason.
"""

import argparse
import concurrent.futures
import json
import math
import os
import re
import statistics
import sys
import tomllib

from checks import check, exit_code
from studies import MACHINE, RESULTS, ROOT, NoResults, Program, commit, studies

DOCUMENTS = [
    "docs/theory/errata.md",
    "docs/touchdown-drops.md",
    "docs/tutorials/cluster.md",
    "docs/tutorials/paper.md",
    "docs/tutorials/raceway.md",
    "docs/tutorials/rotor-drop.md",
]
MARKER = re.compile(r"<!-- (=|table) (.*?) -->(.*?)<!-- / -->", re.DOTALL)
HOLDS = re.compile(r"<!-- holds (.*?) -->", re.DOTALL)
# Where another machine computes, a sample may differ from a result by this fraction, or lie as far
# outside the drops of its row as these are apart.
ELSEWHERE = 0.05
# What symmetry makes 0 is rounding below this, in the unit of its column.
ROUNDING = 1e-12


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


def percent(fraction, places=0):
    return f"{fixed(100 * fraction, places)} %"


def wilson(count, total):
    """Interval of 95 % for a probability."""
    z = 1.959964
    centre = (count + z * z / 2) / (total + z * z)
    half = z / (total + z * z) * math.sqrt(count * (total - count) / total + z * z / 4)
    return max(centre - half, 0.0), min(centre + half, 1.0)


def changed(row, name):
    """Mean of a result over the drops of a row that have it, and its difference to the reference in the
    same drops; "equal" if that is less than 2 in a thousand."""
    mean, lacking = row.mean(name), row.drops() - len(row.of(name))
    text = figures(mean)
    if row.reference() is not row and (change := row.change(name)):
        difference, error = change
        sign = "−" if difference < 0 else "+"
        equal = abs(difference) + error < 2e-3 * abs(mean)
        text += " (equal)" if equal else f" ({sign}{figures(abs(difference), 2)} ± {figures(error, 2)})"
    return text + (f", {lacking} without" if lacking else "")


def colliding(*rows):
    """Drops of rows whose balls collide to the end."""
    return f"{sum(row.colliding() for row in rows)} of {sum(row.drops() for row in rows)}"


def spun_up(row):
    """Drops whose inner ring comes up to speed, and after how long."""
    times = row.of("spin_up_ms")
    mean = f" in {figures(row.mean('spin_up_ms'))} ms" if times else ""
    return f"{len(times)} of {row.drops()}{mean}"


def compared(row, name):
    """What a search finds on a result: of the recommended raceway, of that of the case, and the mean of their
    difference from the same starts with its standard error."""
    found = re.search(rf"{name} (\S+) against (\S+), difference (\S+) ± (\S+)", " ".join(row["findings"]))
    texts = found.groups()
    return [float(text.replace("−", "-")) for text in texts], [digits(text) for text in texts]


def measured(result, ring):
    """Result of a ring in a comparison with its standard error."""
    found = result["values"][ring]
    return f"{figures(found['mean'], 3)} ± {figures(found['standard_error'], 2)}"


def helpful(row):
    """Ring of the best raceway in a search by benefit: the one that the answer is about."""
    of_raceways = range(2, len(row["runs"]))
    return next((k for k in of_raceways if f"{row['benefits'][k]['headline']}." in row["answer"]), 2)


def of_pair(row):
    """Contacts of a held pair with the raceway in an orbit: thirteen pairs of the bearing of Zhao 2022 at 12 000 rpm."""
    return row["contacts"]["values"][1]["mean"] / (13 * 200 * 18.24 / (18.24 + 27.765))


def searched(structure, name):
    """Motion of the structure that a search recommends, at the first operating point, with its standard error."""
    if structure is None:
        return "–"
    point = structure["points"][0]
    return f"{figures(point['motion'][name], 3)} ± {figures(point['errors'][name], 2)}"


def of_search(structure, path, places=None, factor=1):
    """A result of the structure that a search recommends; "–" if it recommends none."""
    if structure is None:
        return "–"
    for key in path.split("."):
        structure = structure[int(key) if key.isdigit() else key]
    return structure if places is None else fixed(factor * structure, places)


def against(row, name):
    """Result of the recommended raceway of a search against that of the case."""
    recommended, own, change, error = compared(row, name)[1]
    return f"{recommended} against {own} ({change} ± {error})"


def size(row, which="recommended"):
    """Dimensions of a raceway; "none" if there is none."""
    if row[which + "_axial_span_mm"] is None:
        return "none"
    return f"{fixed(row[which + '_axial_span_mm'], 3)} mm, {fixed(row[which + '_half_angle_deg'], 2)}°"


def critical_gap(row):
    """Critical gap of the raceway that a search recommends, of its steady-state gap."""
    critical, steady = row["recommended_critical_gap_deg"], row["recommended_steady_gap_deg"]
    return "–" if critical is None else f"{fixed(critical, 3)} of {fixed(steady, 3)}"


def share(fraction):
    """A share of the passages."""
    return "–" if fraction is None else percent(fraction, 1)


def nearest(row):
    """The raceway that misses by least where a search recommends none, with the reason."""
    return f"{size(row, 'closest')}, {row['closest_why']}"


def said(row):
    """What a search says first."""
    first = row["findings"][0]
    return first[0].upper() + first[1:]


def span(values):
    """An interval of angles."""
    return f"{fixed(values[0], 4)} to {fixed(values[1], 4)}°"


def of_ring(row, name, speed_rpm, balls, ring):
    """Result of one cell of the comparison of rings by `reproduce`."""
    cells = zip(row["speed_rpm"], row["balls"], row["ring"])
    return row[name][list(cells).index((speed_rpm, balls, ring))]


def sector(row, k):
    """Interval of angular position."""
    start = row["sector_from_deg"]
    return f"{fixed(start[k], 0)}° to {fixed(start[k] + start[1] - start[0], 0)}°"


WORDS = {
    of.__name__: of
    for of in (
        (against, changed, colliding, compared, critical_gap, digits, figures, fixed, helpful, measured, nearest, of_pair, of_ring, of_search)
        + (percent, power, said, searched, sector, share, size, span, spun_up, wilson)
    )
}


def text_of(value):
    """Value of an expression as text."""
    if isinstance(value, str):
        return value
    if isinstance(value, float) or value is None:
        return figures(value)
    return digits(str(value))


# --- documents ---


class Writer:
    """Evaluates the markers of documents."""

    def __init__(self):
        self.studies = studies()
        declared = tomllib.loads((RESULTS / "studies.toml").read_text(encoding="utf-8"))
        self.tables = declared["table"]
        for table in self.tables.values():
            table["columns"] = declared["columns"].get(str(table["columns"]), table["columns"])
        self.names = WORDS | {name.replace("-", "_"): study for name, study in self.studies.items()}
        # Of tests/tools/picture.py, which needs a browser.
        self.names["pictures"] = json.loads((RESULTS / "pictures.json").read_text(encoding="utf-8"))

    def text(self, kind, expression):
        if kind == "table":
            return "\n\n" + self.table(expression) + "\n\n"
        return text_of(eval(expression, dict(self.names)))

    def table(self, name):
        """The rows of the studies of a table that have results."""
        declared = self.tables[name]
        if "over" in declared:
            lines = [[heading for heading, _ in declared["columns"]], ["---"] * len(declared["columns"])]
            for k in eval(declared["over"], dict(self.names)):
                lines.append([text_of(eval(of, self.names | {"k": k})) for _, of in declared["columns"]])
            return "\n".join(f"| {' | '.join(line)} |" for line in lines)
        rows = [row for study in declared["studies"] for row in self.studies[study].rows if row.values]
        if wanted := declared.get("rows"):
            rows = [row for row in rows if any(place in wanted for place in row.places.values())]
        if not rows:
            return "*No results yet.*"
        header = [*rows[0].places, *(heading for heading, _ in declared["columns"])]
        lines = [header, ["---"] * len(header)]
        for row in rows:
            columns = (eval(expression, self.names | {"r": row}) for _, expression in declared["columns"])
            lines.append([*row.places.values(), *map(text_of, columns)])
        return "\n".join(f"| {' | '.join(line)} |" for line in lines)

    def filled(self, name, text):
        """The document with the values of its markers, and those that have none."""
        failed = []

        def of(found):
            kind, expression, value = found.groups()
            try:
                value = self.text(kind, expression)
            except Exception as error:
                line = text[: found.start()].count("\n") + 1
                failed.append(f"{name}:{line}: {expression}: {type(error).__name__}: {error}")
            return f"<!-- {kind} {expression} -->{value}<!-- / -->"

        return MARKER.sub(of, text), failed


NUMBER = re.compile(r"(?<![\w.,^])\d+(?: \d{3})*(?:[.,]\d+)*")
UNIT = re.compile(
    r"\s?(%|°|of\b(?= \d)|±|(?:GPa|MPa|N|kN|J|mJ|kJ|W|kW|ms|µs|s|h|min|mm|µm|m|kg|g|rpm|Hz|kHz|rad|K|m/s²?)\b|/s)"
)
NOT_READ = re.compile(
    r"<!--.*?-->|```.*?```|``.*?``|`(?:[^`\n]|\n(?!\n))*`|\$\$.*?\$\$|\$[^$\n]*\$|\]\([^)\n]*\)|https?://\S+", re.DOTALL
)


def typed(name, text, allowed):
    """Numbers that are typed into a document, each with its line."""

    def blank(found):
        return re.sub(r"[^\n]", " ", found.group())

    rest = MARKER.sub(blank, text)
    # What contains another comes first.
    for passage in sorted(allowed, key=len, reverse=True):
        pattern = r"(?<![\w.])" + r"\s+".join(map(re.escape, passage.split())) + r"(?![\w]|\.\d)"
        rest = re.sub(pattern, blank, rest)
    rest = NOT_READ.sub(blank, rest)
    for line, content in enumerate(rest.split("\n"), 1):
        for found in NUMBER.finditer(content):
            number, after = found.group(), content[found.end() :]
            if (
                content.startswith("|")
                or "." in number
                or len(number.replace(" ", "")) >= 3
                or UNIT.match(after)
            ):
                yield f"{name}:{line}: {number}{after[:12]}"


def allowed_of():
    """Passages with numbers that are no results, by document."""
    allowed = {}
    for entry in tomllib.loads((RESULTS / "typed.toml").read_text(encoding="utf-8"))["typed"]:
        for name in entry["documents"]:
            allowed.setdefault(name, []).extend(entry["passages"])
    return allowed


def check_documents():
    writer, allowed = Writer(), allowed_of()
    for name in DOCUMENTS:
        text = (ROOT / name).read_text(encoding="utf-8")
        for found in MARKER.finditer(text):
            kind, expression, content = found.groups()
            line = text[: found.start()].count("\n") + 1
            try:
                value = writer.text(kind, expression)
            except Exception as error:
                value = f"{type(error).__name__}: {error}"
            check(f"{name}:{line}: {expression}", content == value, f"is {content!r}, should be {value!r}")
            if kind == "=":
                # Markdown takes the rest of a line that starts with a comment as HTML.
                start = text[text.rfind("\n", 0, found.start()) + 1 : found.start()]
                check(f"{name}:{line}: a word before the marker", start.strip(" -*>|"), start)
        for found in HOLDS.finditer(text):
            line = text[: found.start()].count("\n") + 1
            try:
                ok, why = eval(found[1], dict(writer.names)), ""
            except NoResults:
                continue
            except Exception as error:
                ok, why = False, f"{type(error).__name__}: {error}"
            check(f"{name}:{line}: {found[1]}", ok, f"does not hold {why}")
        found = list(typed(name, text, allowed.get(name, [])))
        check(f"{name}: numbers are results or named in typed.toml", not found, "\n  ".join(["", *found]))
    return writer


def write_documents():
    """The exit code."""
    writer, failed = Writer(), []
    for name in DOCUMENTS:
        path = ROOT / name
        text = path.read_text(encoding="utf-8")
        filled, without = writer.filled(name, text)
        failed += without
        if filled != text:
            path.write_text(filled, encoding="utf-8")
            print(f"{name} written")
    print("\n".join(failed), file=sys.stderr)
    return 1 if failed else 0


# --- results ---


def agree(found, stored, same_machine):
    """Whether a result computed anew is the stored one, of drops whether it is that of the first ones. On
    another machine, whose last bits may differ, whether it is like it: balls that have touched move
    chaotically, so that only statistics can be compared."""
    if not isinstance(stored, list):
        if not isinstance(found, (int, float)) or not isinstance(stored, (int, float)):
            return found == stored
        return abs(found - stored) <= (0 if same_machine else ELSEWHERE) * abs(stored) + ROUNDING
    if same_machine or found == stored[: len(found)]:
        return found == stored[: len(found)]
    new, old = ([v for v in values if isinstance(v, (int, float))] for values in (found, stored))
    if not new or not old:
        return True
    spread = max(old) - min(old) + ELSEWHERE * max(map(abs, old))
    return abs(statistics.fmean(new) - statistics.fmean(old)) <= spread


def compare(program, row, samples, finished):
    """Computes a row, of drops only the first `samples`, and compares it with the results."""
    what, same = f"{row.study.name}: {row.name}", row.study.machine == MACHINE
    if samples and not row.study.of():
        return
    if row.values is None:
        check(what, False, "has no results for its command; compute --missing")
        return
    results = program.results(row, samples if "samples" in row.study.declared else None, finished)
    check(f"{what}: the same results", results.keys() == row.values.keys(), list(results))
    for name in results.keys() & row.values.keys():
        new, stored = results[name], row.values[name]
        check(f"{what}: {name}", agree(new, stored, same), f"is {new}, in docs/results {stored}")


def compute(options):
    of_name = studies()
    if unknown := [name for name in options.only if name not in of_name]:
        raise SystemExit(f"no study {unknown}; there are {', '.join(of_name)}")
    chosen = [study for name, study in of_name.items() if not options.only or name in options.only]
    finished = {name: ROOT / folder for name, _, folder in (text.partition("=") for text in options.finished)}
    program = Program(options.cageless, options.target)
    version = program.version()
    with concurrent.futures.ThreadPoolExecutor(options.threads) as pool:
        if options.compare:
            rows = [(row, None) for study in chosen for row in study.rows]
            if options.sample:
                chosen = [s for s in chosen if s.declared.get("sample") != "none" or s.name in finished]
                print(f"sample --seed {options.seed}: " + "; ".join(s.sampled_row(options.seed).name for s in chosen))
                rows = [(study.sampled_row(options.seed), 1) for study in chosen]
            done = [pool.submit(compare, program, row, n, finished.get(row.study.name)) for row, n in rows]
            for row in done:
                row.result()
            return

        def of_row(row):
            row.values = program.results(row, finished=finished.get(row.study.name))
            print(f"{row.study.name}: {row.name}", flush=True)
            return row

        rows = [row for s in chosen for row in s.rows if not (options.missing and row.values is not None)]
        for done in concurrent.futures.as_completed([pool.submit(of_row, row) for row in rows]):
            done.result().study.save(version)
    for study in chosen:
        study.save(version)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("write")
    commands.add_parser("check")
    computed = commands.add_parser("compute")
    computed.add_argument("cageless")
    computed.add_argument("target", nargs="?", default=ROOT / "target")
    computed.add_argument("--only", nargs="+", default=[], metavar="STUDY")
    computed.add_argument("--missing", action="store_true")
    computed.add_argument("--compare", action="store_true")
    computed.add_argument("--sample", action="store_true")
    computed.add_argument("--seed", default=commit())
    computed.add_argument("--finished", action="append", default=[], metavar="STUDY=DIR")
    computed.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_args()
    if options.command == "compute":
        compute(options)
    if options.command == "check":
        check_documents()
    if options.command == "write" or (options.command == "compute" and not options.compare):
        return write_documents()
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
