"""Runs the fenced blocks of README.md and docs: shell, Python and plans.

    commands.py CAGELESS FOLDER            shell and plans, each page in a folder of its own below FOLDER
    commands.py CAGELESS FOLDER --python   Python, as a script for each page, in the folders that the shell has left

A page is one session: a command has the files and variables of those before it. Pages run side by side.
Tutorials are counted only, `tutorials.py` runs them; examples with `>>>` are those of pytest.
`SHORTENED` has the settings that make a command short, `LEFT` what does not run here, each with its reason.
A block in a language without a rule fails, and so does a rule that no command needs. Within sentences the names of
commands, options, tests and keys are checked.
"""

import concurrent.futures
import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from checks import check, exit_code
from studies import ROOT

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
SHELL, PYTHON = ("sh", "console"), ("python", "pycon")
# Shown, not run.
SHOWN = ("math", "mermaid", "rust", "text")
TUTORIALS = "docs/tutorials/"

# What does not run here: a pattern of the command, the reason, and the step of ./test that runs it or its like.
LEFT = [
    (r"^tar -xf cageless-", "a file of a release", "workflows and release"),
    (r"^pip install", "installs", "python package"),
    (r"^rustup target add|^cargo install", "installs", "build"),
    (r"^cargo run --release -- reproduce", "minutes", "reproduce"),
    (r"^cargo run (--release )?-p cageless --example", "compiled as a test", "programs in rust"),
    (r"^\./test ", "every test", ""),
    (r"^python3 docs/studies compute", "hours", "numbers in documents"),
    (r"SLURMCluster|KubeCluster|^FROM python", "needs a cluster", ""),
    (r'load\("result\.mat"\)', "needs MATLAB", ""),
]

METHOD = "--set solver.method=verlet --set solver.step_us=auto"
SEARCH = f"--search --set search.runs_max=32 --set search.initial_states=1 {METHOD}"
ONE = f"{SEARCH} --set search.axial_span_mm=5.1 --set search.half_angle_deg=25.2"
OF_6008 = f"{SEARCH} --set search.axial_span_mm=2.281 --set search.half_angle_deg=9.707"
# What makes a command short: the start of its pages, what is replaced in it, by what, and why.
SHORTENED = [
    ("docs/studio", r"^cargo run --release -- studio (\S+)", r"timeout --foreground --preserve-status -s INT 2 cageless studio \1 --no-browser", "built already; a server"),
    ("README", r"--search", OF_6008, "the raceway of its recommendation alone"),
    ("README", r"case\.run\(\)", 'case.replace({"solver.duration_s": 0.005}).run()', "a shorter run"),
    ("docs/design-examples", r"cageless design (.*(?:rpm=|full-|formulation).*) --search", r"cageless check \1", "their settings alone"),
    ("docs/", r"--search(?! --set search.runs_max)", ONE, "the raceway of the case alone"),
    ("docs/", r"solver\.duration_s=[0-9.]+", "solver.duration_s=0.005", "shorter runs"),
    ("docs/greaseless", r"--starts=3", "--starts=2 --set solver.duration_s=0.002", "a shorter run"),
    ("docs/axial-load", r"(preloaded-pair.* start\.gaps=bunched)", r"\1 --set solver.duration_s=0.005", "shorter runs"),
    ("docs/axial-load", r"--axial", f"--axial --set contact.friction_strips=1 {METHOD}", "a quicker method, one strip"),
    ("docs/elastic-flanks", r"flanks=elastic", f"flanks=elastic {METHOD}", "a quicker method"),
    ("docs/dry-friction", r"--samples 16", "--samples 0", "each deviation alone"),
    ("docs/touchdown-drops", r"--samples \d+", "--samples 2 --set solver.duration_s=0.02", "fewer and shorter drops"),
    ("docs/cluster", r"Client\(\)", "Client(n_workers=2, threads_per_worker=1)", "two processes"),
    ("docs/sweeps", r"SLURM_ARRAY_TASK_(ID|COUNT)", r"{SLURM_ARRAY_TASK_\1:-1}", "a single shard"),
    ("docs/sweeps", r"count = (64|5|4)\b", "count = 2", "fewer variants"),
    ("docs/sweeps", r"repeats = 10", "repeats = 1", "fewer variants"),
    ("docs/sweeps", r"solver\.duration_s = 0\.05", "solver.duration_s = 0.005", "shorter runs"),
    ("docs/sweeps", r'^(compute = \["drop"\])', r"\1\n[set]\nsolver.duration_s = 0.02", "shorter drops"),
    ("docs/python", r"^.*ross_rotor.*\n", "", "ROSS needs an older Plotly: step rotors of ross"),
    ("docs/python", r"touchdown-d\.toml\"\)", r"\g<0>.replace({'solver.duration_s': 0.01})", "a shorter drop"),
    ("docs/python", r"\{\"rotor\.speed_rpm\": 30000\.0\}", "{'rotor.speed_rpm': 30000.0, 'solver.duration_s': 0.01}", "a shorter drop"),
    ("docs/python", r"samples=50", "samples=2", "fewer drops"),
    ("docs/python", r"compare\(draws=8\)", "replace({'steady.transient_orbits': 1.0, 'steady.measured_orbits': 2.0}).compare(draws=2)", "fewer draws, a few orbits"),
    ("docs/", r"^(cargo run --release -- |cageless )?(compare (?!.*--starts).*)", r"\1\2 --set steady.transient_orbits=1 --set steady.measured_orbits=2", "a few orbits"),
]
# Files that a page takes for granted: what they are copies of, and what is replaced in them.
PLAN = "plans/span-and-angle.toml"
FEWER = [("count = 5", "count = 2"), ("repeats = 10", "repeats = 1"), ("duration_s = 0.05", "duration_s = 0.005")]
HERE = [*FEWER, ("../cases", "cases")]
FILES = {
    "README.md": {PLAN: (PLAN, FEWER)},
    "docs/sweeps.md": {PLAN: (PLAN, FEWER), "plan.toml": (PLAN, HERE)},
    "docs/cluster.md": {"plan.toml": (PLAN, HERE)},
    "docs/axial-load.md": {"mine.toml": ("cases/zhao-d.toml", [])},
    "docs/python.md": {"rotor.toml": ("cases/rotors/two-bearings.toml", [("../touchdown", "cases/touchdown")])},
}
# Code before the Python of a page.
BEFORE = {
    "docs/python.md": """
import cageless
case = cageless.Case.from_file("cases/zhao-d.toml").replace({"solver.duration_s": 0.01})
rotor = cageless.LinearRotor.rigid(
    mass_kg=40.0, polar_inertia_kg_m2=0.04, transverse_inertia_kg_m2=0.6, bearing_axial_mm=[-100.0, 200.0]
)
drive_end, free_end = (
    cageless.Case.from_file(f"cases/touchdown-{name}.toml").replace({"solver.duration_s": 0.01})
    for name in ("d", "conventional")
)
""",
}
# A search of a single raceway may reject it.
CODES = [("--search", (0, 3))]


@dataclass
class Command:
    """A statement of the shell, or a whole block in another language, with its place in the documents."""

    page: str
    line: int
    language: str
    code: str

    @property
    def name(self):
        return f"{self.page}:{self.line}: {self.code.strip().splitlines()[0]}"

    def short(self, used):
        """The code that runs; the rules go into `used`."""
        code = self.code
        for rule in SHORTENED:
            page, old, new, _ = rule
            if self.page.startswith(page) and (changed := re.sub(old, new, code, flags=re.MULTILINE)) != code:
                code = changed
                used[rule] += 1
        return code

    def left(self):
        """The rule by which it does not run here."""
        return next((rule for rule in LEFT if re.search(rule[0], self.code, re.MULTILINE)), None)


def complete(code):
    """Whether the shell would wait for no further line."""
    if code.endswith("\\\n"):
        return False
    return subprocess.run(["bash", "-n"], input=code, text=True, capture_output=True).returncode == 0


def statements(code):
    """The statements of a block of the shell, each with the number of its line in the block."""
    statement, first = "", 0
    for n, line in enumerate(code.splitlines(keepends=True)):
        first = first if statement else n
        statement += line
        if not statement.strip():
            statement = ""
        elif complete(statement):
            yield first, statement
            statement = ""
    if statement:
        yield first, statement


def commands_of(path):
    page, text = path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")
    fences, blocks = len(re.findall(r"^ *(?:```|~~~)", text, re.MULTILINE)), list(BLOCK.finditer(text))
    check(f"{page}: every fence is a block", fences == 2 * len(blocks), f"{fences} fences, {len(blocks)} blocks")
    for block in blocks:
        language, code = block.groups()
        line = text[: block.start()].count("\n") + 2
        if language in SHELL:
            yield from (Command(page, line + n, language, of) for n, of in statements(code))
        elif language not in SHOWN:
            yield Command(page, line, language, code)


class Session:
    """The commands of a page, in a folder with the cases and plans of the repository."""

    def __init__(self, page, commands, folder, environment):
        self.page, self.commands, self.environment = page, commands, environment
        self.folder, self.used = folder / page.replace("/", "-").removesuffix(".md"), Counter()

    def prepare(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        if not (self.folder / "cases").exists():
            shutil.copytree(ROOT / "cases", self.folder / "cases")
            shutil.copytree(ROOT / "plans", self.folder / "plans")
        for name, (source, changes) in FILES.get(self.page, {}).items():
            text = (ROOT / source).read_text(encoding="utf-8")
            for old, new in changes:
                check(f"{source}: {old}", old in text, "is not in it")
                text = text.replace(old, new)
            (self.folder / name).write_text(text, encoding="utf-8")

    def execute(self, name, words, codes=(0,)):
        started = time.monotonic()
        done = subprocess.run(words, cwd=self.folder, env=self.environment, capture_output=True, text=True)
        check(name, done.returncode in codes, f"exit code {done.returncode}\n{words[-1]}\n{done.stderr[-2000:]}")
        return f"{time.monotonic() - started:5.1f} s  {name}", done.stdout

    def shell(self):
        """Runs all of it; a line for each command."""
        self.prepare()
        lines = []
        for command in self.commands:
            code = command.short(self.used)
            if command.language == "toml" and code.startswith("["):
                # Keys for a case that has none of them.
                case = (self.folder / "cases/conventional.toml").read_text(encoding="utf-8")
                (self.folder / "cases/of-the-page.toml").write_text(f"{case}\n{code}", encoding="utf-8")
                code = "cageless check cases/of-the-page.toml"
            elif command.language == "toml":
                (self.folder / "plans/of-the-page.toml").write_text(code, encoding="utf-8")
                code = f"cageless sweep plans/of-the-page.toml --out of-line-{command.line}"
            codes = next((codes for pattern, codes in CODES if pattern in code), (0,))
            lines.append(self.execute(command.name, ["bash", "-euo", "pipefail", "-c", code], codes)[0])
        return lines

    def python(self):
        """Runs all of it as one script."""
        self.prepare()
        parts = [BEFORE.get(self.page, "")]
        for command in self.commands:
            parts.append(f"# {command.name}\n{command.short(self.used)}\nprint({command.name!r})\n")
        (self.folder / "page.py").write_text("\n".join(parts), encoding="utf-8")
        line, printed = self.execute(f"{self.page}: its Python", [sys.executable, "page.py"])
        for command in self.commands:
            check(command.name, command.name in printed, "did not come to its end")
        return [line]


def check_in_text(cageless):
    """Commands within sentences: whether there is the command of `cageless` with these options, and whether
    `cargo test` finds the tests."""
    options_of = {}

    def options(command):
        if command not in options_of:
            done = subprocess.run([cageless, *command.split(), "--help"], capture_output=True, text=True)
            options_of[command] = set(re.findall(r"--[a-z][a-z-]*", done.stdout)) if done.returncode == 0 else None
        return options_of[command]

    found = 0
    for path in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "RECIPES.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = BLOCK.sub("", path.read_text(encoding="utf-8"))
        for code in dict.fromkeys(" ".join(of.split()) for of in re.findall(r"`((?:cageless|cargo test) [^`]*)`", text)):
            name = f"{path.relative_to(ROOT).as_posix()}: {code}"
            found += 1
            if tests := re.fullmatch(r"cargo test .*-p (\S+) --(test all|lib) (\w+)", code):
                crate, kind, word = tests.groups()
                # Tests of what is not public lie in tests/inside and belong to the library.
                folders = ("src", "tests/inside") if kind == "lib" else ("tests",)
                sources = (file for folder in folders for file in (ROOT / "crates" / crate / folder).rglob("*.rs"))
                ok = any(word in of.as_posix() or re.search(rf"(fn|mod) \w*{word}", of.read_text(encoding="utf-8")) for of in sources)
                check(name, ok, f"no test has {word} in its name")
            elif used := re.match(r"cageless (?!help)([a-z]+)\b", code):
                known = options(used[1])
                check(name, known is not None, f"cageless has no {used[1]}")
                unknown = set(re.findall(r"(?<!\S)--[a-z][a-z-]*", code)) - (known or set())
                check(name, not unknown, f"{used[1]} has no {unknown}")
    check("commands.py: commands within sentences", found > 50, found)


def check_keys():
    """Keys within sentences and commands, `section.key` and `--set section.key=`: whether the files have them."""
    keys = {}
    for schema in ("case-file", "rotor-file"):
        sections = json.loads((ROOT / f"docs/{schema}.schema.json").read_text(encoding="utf-8"))["properties"]
        for name, section in sections.items():
            keys.setdefault(name, set()).update(section.get("anyOf", [section])[0].get("properties", {}))
    found = 0
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        named = re.findall(r"`([a-z_]+)\.(?:\d\.)?([a-z]\w*)(?: = [^`]*)?`", text)
        # Results of a search have its name as well.
        named = [(section, key) for section, key in named if section != "search"]
        for section, key in dict.fromkeys([*named, *re.findall(r"--set \"?([a-z_]+)\.(?:\d\.)?(\w+)=", text)]):
            if keys.get(section) and key not in ("rs", "toml", "parquet", "key"):
                found += 1
                check(f"{path.relative_to(ROOT).as_posix()}: {section}.{key}", key in keys[section], "is no key")
    check("commands.py: keys within sentences", found > 100, found)


def wanted(command, python):
    """Whether a command is of this step."""
    if command.page.startswith(TUTORIALS) or command.left():
        return False
    if command.language in PYTHON:
        return python and ">>>" not in command.code
    return not python


def kinds(commands):
    """Commands by what is done with them, and those without a rule."""
    counts, used = Counter(), Counter()
    for command in commands:
        rule = command.left()
        if command.page.startswith(TUTORIALS):
            counts["by tutorials.py"] += 1
        elif rule:
            counts[f"left: {rule[1]}"] += 1
            used[rule] += 1
        elif command.language in PYTHON and ">>>" in command.code:
            counts["by pytest"] += 1
        else:
            check(f"{command.name}: {command.language}", command.language in (*SHELL, *PYTHON, "toml"), "has no rule")
            before = used.total()
            command.short(used)
            counts["shortened" if used.total() > before else "run as they are"] += 1
    for rule in [*LEFT, *SHORTENED]:
        check(f"commands.py: a command for {rule}", used[rule])
    steps = (ROOT / "test").read_text(encoding="utf-8")
    for rule in LEFT:
        check(f"commands.py: step {rule[2]}", not rule[2] or f'step "{rule[2]}" ' in steps, "is none of ./test")
    return counts


def main():
    cageless, folder, options = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), sys.argv[3:]
    python, only = "--python" in options, [option for option in options if not option.startswith("--")]
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    of_page = {path.relative_to(ROOT).as_posix(): list(commands_of(path)) for path in pages}
    tools = folder / "bin"
    if not python:
        shutil.rmtree(folder, ignore_errors=True)
        tools.mkdir(parents=True)
        (tools / "cageless").symlink_to(cageless)
    environment = {
        **os.environ, "PATH": f"{tools}{os.pathsep}{os.environ['PATH']}", "RAYON_NUM_THREADS": "1",
        # Figures are printed, not opened.
        "PLOTLY_RENDERER": "json",
    }  # fmt: skip
    sessions = []
    for page, commands in of_page.items():
        commands = [command for command in commands if wanted(command, python)]
        if commands and (not only or any(name in page for name in only)):
            sessions.append(Session(page, commands, folder, environment))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done in [pool.submit(Session.python if python else Session.shell, session) for session in sessions]:
            print("\n".join(done.result()), flush=True)
    commands = [command for of in of_page.values() for command in of]
    counts = kinds(commands)
    if not python:
        check_in_text(cageless)
        check_keys()
    print(f"{len(commands)} commands: " + "; ".join(f"{n} {kind}" for kind, n in sorted(counts.items())))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
