"""Runs every command of docs/tutorials, in their order, and compares what they print with the pages.

    tutorials.py CAGELESS FOLDER           each tutorial in a folder of its own below FOLDER
    tutorials.py CAGELESS FOLDER --write   writes what was printed into the pages

Comments of a page, which readers do not see, are about the block of code below them:

    <!-- in the test OLD -> NEW; … -->     what the test replaces in it, to be done in seconds
    <!-- file NAME: OLD -> NEW; … -->      the block is saved under this name
    <!-- elsewhere STEP -->                the step of ./test that runs the command instead
    <!-- prints PATTERN --> … <!-- / -->   lines that the block before printed and that match
"""

import os
import re
import subprocess
import sys
import time
from pathlib import Path

from checks import check, exit_code
from studies import MACHINE, ROOT, studies

PAGES = ROOT / "docs/tutorials"
PIECE = re.compile(
    r"<!-- prints (?P<pattern>.*?) -->\n(?P<printed>.*?)<!-- / -->"
    r"|(?:<!-- (?P<note>in the test|file|elsewhere) (?P<of>.*?) -->\n)?^```(?P<language>\w+)\n(?P<code>.*?)^```$",
    re.DOTALL | re.MULTILINE,
)
NUMBER = re.compile(r"[-−]?\d+(?:\.\d+)?| +")
# A scheduler that runs the tasks of an array one after the other.
SBATCH = """#!/usr/bin/env bash
set -e
for option; do
    [[ $option == --array=* ]] && array=${option#*=}
done
export SLURM_ARRAY_TASK_COUNT=${array#*-}
for ((SLURM_ARRAY_TASK_ID = 1; SLURM_ARRAY_TASK_ID <= SLURM_ARRAY_TASK_COUNT; SLURM_ARRAY_TASK_ID++)); do
    export SLURM_ARRAY_TASK_ID
    bash -euc "${@: -1}"
done
"""


def replaced(name, code, changes):
    """The code with the changes of a comment, each of which has to be found once."""
    for change in filter(None, map(str.strip, changes.split(";"))):
        old, arrow, new = change.partition(" -> ")
        check(f"{name}: in the test {change}", arrow and code.count(old) == 1, "is not once in the block of code below it")
        code = code.replace(old, new)
    return code


def alike(lines, stored):
    """Whether what was printed is what the page shows; on another machine than that of docs/results, whose last
    bits may differ, whether its words are."""
    if any(study.machine == MACHINE for study in studies().values()):
        return lines == stored
    return [NUMBER.sub("#", line) for line in lines] == [NUMBER.sub("#", line) for line in stored]


class Tutorial:
    """A page, the folder in which its commands run, and what the last of them printed."""

    def __init__(self, path, folder, environment):
        self.path, self.name = path, path.relative_to(ROOT).as_posix()
        self.folder, self.environment = folder, environment
        self.printed, self.failed = "", False
        folder.mkdir(parents=True)
        (folder / "cases").symlink_to(ROOT / "cases")

    def block(self, found):
        language, code, note, of = (found[key] for key in ("language", "code", "note", "of"))
        if note == "elsewhere":
            step = re.search(rf'step "{of}" (.*)', (ROOT / "test").read_text(encoding="utf-8"))
            words = code.split()[:2]
            check(f"{self.name}: {' '.join(words)} in the step {of} of ./test", step and words[1] in step[1])
        elif note == "file":
            name, _, changes = of.partition(": ")
            (self.folder / name).write_text(replaced(self.name, code, changes), encoding="utf-8")
        elif language == "sh":
            self.run(replaced(self.name, code, of or ""))
        else:
            check(f"{self.name}: a block of {language} that nothing runs", False)

    def run(self, code):
        # What comes after a command that failed would only fail as well.
        if self.failed:
            return
        started = time.monotonic()
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", code], cwd=self.folder, env=self.environment,
            capture_output=True, text=True,
        )  # fmt: skip
        self.printed, self.failed = done.stdout, done.returncode != 0
        check(f"{self.name}: {code.strip()}", not self.failed, f"exit code {done.returncode}\n{done.stderr}")
        print(f"{time.monotonic() - started:5.1f} s  {code.splitlines()[0]}", flush=True)

    def lines(self, found, write):
        """The piece of the page with the lines that match."""
        kept = [line.rstrip() for line in self.printed.splitlines() if re.search(found["pattern"], line)]
        check(f"{self.name}: lines that match {found['pattern']}", kept or self.failed)
        text = "\n```text\n" + "\n".join(kept) + "\n```\n\n"
        same = self.failed or alike(text.splitlines(), found["printed"].splitlines())
        if write and not same:
            return f"<!-- prints {found['pattern']} -->\n{text}<!-- / -->"
        check(f"{self.name}: what {found['pattern']} prints", same, f"is now {text}")
        return found.group()

    def follow(self, write):
        def piece(found):
            if found["pattern"] is not None:
                return self.lines(found, write)
            self.block(found)
            return found.group()

        text = self.path.read_text(encoding="utf-8")
        new = PIECE.sub(piece, text)
        check(f"{self.name}: every fence is a block", text.count("\n```") == 2 * sum("```" in f.group() for f in PIECE.finditer(text)))
        if new != text:
            self.path.write_text(new, encoding="utf-8")
            print(f"{self.name} written")


def main():
    cageless, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    subprocess.run(["rm", "-rf", folder], check=True)
    tools = folder / "bin"
    tools.mkdir(parents=True)
    (tools / "cageless").symlink_to(cageless)
    (tools / "sbatch").write_text(SBATCH, encoding="utf-8")
    (tools / "sbatch").chmod(0o755)
    environment = {**os.environ, "PATH": f"{tools}{os.pathsep}{os.environ['PATH']}"}
    pages = sorted(PAGES.glob("*.md"))
    check("tutorials", len(pages) > 3)
    for path in pages:
        Tutorial(path, folder / path.stem, environment).follow("--write" in sys.argv)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
