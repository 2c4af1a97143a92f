"""Runs every command of docs/tutorials, in their order, and compares what they print with the pages.

    tutorials.py CAGELESS FOLDER           each tutorial in a folder of its own below FOLDER
    tutorials.py CAGELESS FOLDER --write   writes lines that are printed otherwise now into the pages

Pages are plain Markdown. A block of the shell runs, with the changes of `SHORTENED`; each line of a block of text has to
be one that the command before it printed, or its start before …; a block of TOML is saved under the last name of such a file in the text.
"""

import difflib
import os
import re
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

from checks import check, exit_code
from studies import MACHINE, ROOT, studies

PAGES = ROOT / "docs/tutorials"
BLOCK = re.compile(r"^```(?P<language>\w+)\n(?P<code>.*?)^```$|`(?P<file>[\w-]+\.toml)`", re.DOTALL | re.MULTILINE)
NUMBER = re.compile(r"[-−]?\d+(?:\.\d+)?| +")
# The step of ./test that runs a command instead.
ELSEWHERE = {"cageless reproduce": "reproduce"}
# What the test replaces, to be done in seconds: page, what, by what.
SHORT = "--set solver.duration_s=0.02"
SEARCH = "--set search.axial_span_mm=2.281 --set search.half_angle_deg=9.707 --set search.runs_max=32"
SHORTENED = [
    ("cluster", "count = 100", "count = 1"),
    ("cluster", "duration_s = 0.2", "duration_s = 0.002"),
    ("cluster", "1/1000", "1/50"),
    ("paper", "--out result", f"--out result {SHORT}"),
    ("paper", "count = 12", "count = 2"),
    ("paper", "duration_s = 0.05", "duration_s = 0.005"),
    ("raceway", "--search", f"--search {SEARCH} --set search.initial_states=1 --set solver.method=verlet --set solver.step_us=auto"),
    ("raceway", "--out result", "--out result --set solver.duration_s=0.01"),
    ("raceway", "--out comparison", "--out comparison --set solver.duration_s=0.01 --set steady.transient_orbits=1 --set steady.measured_orbits=2"),
    ("raceway", "--out tolerance", "--out tolerance --samples 0"),
    ("rotor-drop", "--out verified", f"--out verified {SHORT}"),
    ("rotor-drop", "--samples 50", f"--samples 4 {SHORT}"),
    ("rotor-drop", "--out two", f"--out two {SHORT}"),
]
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


def same_machine():
    """Whether this is the machine of docs/results; on another one the last bits may differ."""
    return any(study.machine == MACHINE for study in studies().values())


class Tutorial:
    """A page, the folder in which its commands run, and what the last of them printed."""

    def __init__(self, path, folder, environment, used):
        self.path, self.name = path, path.relative_to(ROOT).as_posix()
        self.folder, self.environment, self.used = folder, environment, used
        self.printed, self.failed, self.file = [], False, None
        folder.mkdir(parents=True)
        (folder / "cases").symlink_to(ROOT / "cases")

    def shortened(self, code):
        for rule in SHORTENED:
            page, old, new = rule
            if page == self.path.stem and old in code:
                code = code.replace(old, new)
                self.used[rule] += 1
        return code

    def run(self, code):
        # What comes after a command that failed would only fail as well.
        if self.failed:
            return
        started = time.monotonic()
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", code], cwd=self.folder, env=self.environment,
            capture_output=True, text=True,
        )  # fmt: skip
        self.printed, self.failed = [line.rstrip() for line in done.stdout.splitlines()], done.returncode != 0
        check(f"{self.name}: {code.strip()}", not self.failed, f"exit code {done.returncode}\n{done.stderr}")
        print(f"{time.monotonic() - started:5.1f} s  {code.splitlines()[0]}", flush=True)

    def now(self, line):
        """A line of the page as the command prints it now; one that is cut by … stands for its start."""
        if self.failed:
            return line
        shown = line.removesuffix("…")
        printed = [of[: len(shown)] for of in self.printed] if line.endswith("…") else self.printed
        if shown in printed or (not same_machine() and NUMBER.sub("#", shown) in [NUMBER.sub("#", of) for of in printed]):
            return line
        closest = next(iter(difflib.get_close_matches(shown, printed, 1, 0.3)), "")
        return closest + line[len(shown) :]

    def block(self, found, write):
        """What a block of the page should be."""
        language, code = found["language"], found["code"]
        if language == "sh":
            step = ELSEWHERE.get(code.strip())
            if step:
                run = re.search(rf'step "{step}" (.*)', (ROOT / "test").read_text(encoding="utf-8"))
                check(f"{self.name}: {code.strip()} in the step {step} of ./test", run and code.split()[1] in run[1])
            else:
                self.run(self.shortened(code))
        elif language == "toml":
            check(f"{self.name}: the name of a file", self.file, code)
            (self.folder / self.file).write_text(self.shortened(code), encoding="utf-8")
        elif language == "text":
            now = "".join(self.now(line) + "\n" for line in code.splitlines())
            if write:
                return f"```text\n{now}```"
            check(f"{self.name}: what a command prints", now == code, f"is now\n{now}")
        else:
            check(f"{self.name}: a block of {language} that nothing runs", False)
        return found.group()

    def follow(self, write):
        def piece(found):
            if found["file"]:
                self.file = found["file"]
                return found.group()
            return self.block(found, write)

        text = self.path.read_text(encoding="utf-8")
        new = BLOCK.sub(piece, text)
        blocks = sum(found["language"] is not None for found in BLOCK.finditer(text))
        check(f"{self.name}: every fence is a block", text.count("\n```") == 2 * blocks)
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
    used = Counter()
    for path in pages:
        Tutorial(path, folder / path.stem, environment, used).follow("--write" in sys.argv)
    check("tutorials.py: a command for each change", not (left := [rule for rule in SHORTENED if not used[rule]]), left)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
