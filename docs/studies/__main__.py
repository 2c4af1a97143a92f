"""Checks and writes tables and pictures of the documents, checks what their text claims, computes the results again.

    python3 docs/studies check                      # tables are those of docs/results, and all claims hold
    python3 docs/studies write                      # writes tables and pictures, then checks
    python3 docs/studies compute CAGELESS [TARGET]  # computes docs/results anew, then writes
        --only STUDY …       only these studies
        --missing            only rows without results
        --compare            compares with docs/results instead of replacing them
        --sample             with --compare: one row of each study, of drops the first one
        --seed TEXT          of that sample, by default the commit: over commits every row has its turn
        --finished STUDY=DIR uses an earlier run of the command of a study
        --threads N          commands at the same time, default: one for each core

Each page with results has a program next to this one: `PAGE`, its `tables()`, its `picture()` if it has one, and its
`claims(claim)`. In the page a
table is between `<!-- NAME -->` and `<!-- / -->`; all else is text, which any editor may change. Studies are
declared in `docs/results/studies.toml`. `compute` can be interrupted: the same program does not compute a row twice.
"""

import argparse
import concurrent.futures
import importlib
import os
import re
import statistics
import sys
import traceback
from pathlib import Path

from page import ROOT, STUDIES, Claims, check

import checks
from studies import MACHINE, Program, commit

TABLE = re.compile(r"<!-- ([\w-]+) -->\n\n(.*?)\n\n<!-- / -->", re.DOTALL)
# Where another machine computes, a sample may differ from a result by this fraction, or lie as far
# outside the drops of its row as these are apart.
ELSEWHERE = 0.05
# What symmetry makes 0 is rounding below this, in the unit of its column.
ROUNDING = 1e-12


# --- pages ---


def programs():
    """The programs of the pages."""
    names = sorted(path.stem for path in Path(__file__).parent.glob("*.py"))
    return [importlib.import_module(name) for name in names if name not in ("__main__", "chart", "page")]


def check_tables(program, write):
    """Compares the tables of a page with those of its program, or writes them."""
    path = ROOT / program.PAGE
    text, tables = path.read_text(encoding="utf-8"), program.tables()
    shown = [name for name, _ in TABLE.findall(text)]
    check(f"{program.PAGE}: its tables, each once", sorted(shown) == sorted(tables), f"are {shown}, those of its program {list(tables)}")

    def of(found):
        name, now = found.groups()
        new = tables.get(name, now)
        if not write:
            wrong = [f"\n  is        {a}\n  should be {b}" for a, b in zip(now.split("\n"), new.split("\n")) if a != b]
            check(f"{program.PAGE}: table {name}", now == new, "".join(wrong) or "has other rows")
        return f"<!-- {name} -->\n\n{new}\n\n<!-- / -->"

    written = TABLE.sub(of, text)
    if write and written != text:
        path.write_text(written, encoding="utf-8")
        print(f"{program.PAGE} written")


def check_picture(program, write):
    """Compares the picture of a page with that of its program, or writes it."""
    if not hasattr(program, "picture"):
        return
    path, new = ROOT / f"docs/images/{Path(program.PAGE).stem}.svg", program.picture()
    if write:
        path.write_text(new, encoding="utf-8")
    check(f"{program.PAGE}: its picture {path.name}", path.exists() and path.read_text(encoding="utf-8") == new, "is another one")
    check(f"{program.PAGE}: shows its picture", f"](images/{path.name})" in (ROOT / program.PAGE).read_text(encoding="utf-8"))


def check_plain():
    """That pages are plain Markdown: no comment but around a table of a program."""
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = TABLE.sub("", path.read_text(encoding="utf-8"))
        comments = re.findall(r"<!--.*?-->", text, re.DOTALL)
        check(f"{path.relative_to(ROOT)}: plain Markdown", not comments, f"has comments that no program reads: {comments[:3]}")


def check_claims(program, _):
    program.claims(Claims(program.PAGE))


def check_pages(write=False):
    check_plain()
    for program in programs():
        for work in (check_tables, check_picture, check_claims):
            try:
                work(program, write)
            except Exception:
                check(f"{program.PAGE}, by {Path(program.__file__).name}", False, "\n" + traceback.format_exc())


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
    if unknown := [name for name in options.only if name not in STUDIES]:
        raise SystemExit(f"no study {unknown}; there are {', '.join(STUDIES)}")
    chosen = [study for name, study in STUDIES.items() if not options.only or name in options.only]
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
    commands.add_parser("check")
    commands.add_parser("write")
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
    if options.command != "compute" or not options.compare:
        check_pages(write=options.command != "check")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())
