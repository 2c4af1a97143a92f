"""One term for each thing in the documents: prints each other one with its line and what to write instead.

    python words.py
"""

import re
import sys
from pathlib import Path

from checks import check, exit_code

ROOT = Path(__file__).parents[2]
# As in the glossary, in the units of SI and in the spelling of their makers.
TERMS = {
    "touchdown": "touch-down",
    "slip": "sliding",
    "slips": "slides",
    "osculation": "conformity",
    "uniform gap": "nominal gap",
    "speed parameter": "speed factor",
    "furrow": "raceway",
    "um": "µm",
    "us": "µs",
    "N m": "N·m",
    "numpy": "NumPy",
    "plotly": "Plotly",
    "ross": "ROSS",
}
NO_PROSE = re.compile(r"```.*?```|\$\$.*?\$\$|\$[^$\n]+\$|`[^`]*`|\]\([^)]*\)|\w*[./]\w[\w./-]*", re.DOTALL)


def main():
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        prose = NO_PROSE.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), path.read_text(encoding="utf-8"))
        found = [
            f"\n  line {n}: {term}; write {instead}"
            for n, line in enumerate(prose.split("\n"), 1)
            for term, instead in TERMS.items()
            if re.search(rf"(?<![\w-]){term}(?![\w-])", line)
        ]
        check(f"{path.relative_to(ROOT)}: terms", not found, "".join(found))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
