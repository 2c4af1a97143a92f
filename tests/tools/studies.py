"""Studies whose results lie in `docs/results`: what they compute and what came out.

`docs/results/studies.toml` declares each study: a command of `cageless` with a row for every combination of its
axes. The results of study NAME are in `docs/results/NAME.json`: per row the arguments of the command and the
values that were kept, of a drop with `--samples` one value for each drop. `python3 docs/studies` computes them and
writes their tables into the documents.
"""

import hashlib
import importlib
import itertools
import json
import math
import os
import platform
import statistics
import subprocess
import tomllib
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "docs" / "results"
COLLIDING_HZ = 500
"""Contacts of each ball per second, at the end of a drop, beyond which the balls collide continuously."""
MACHINE = f"{platform.machine()} {' '.join(platform.libc_ver())}"
"""What the last bits of a result may depend on."""


def rounded(value, digits):
    """A result as it is kept."""
    if isinstance(value, float):
        return float(f"{value:.{digits}g}")
    if isinstance(value, list):
        return [rounded(v, digits) for v in value]
    if isinstance(value, dict):
        return {key: rounded(v, digits) for key, v in value.items()}
    return value


def at(document, path):
    """Value at a path such as `ensemble.drops.0.bearings.0.result.impacts`; `*` is a list of all, a name the entry of a
    list that has it. Nothing has nothing."""
    for n, key in enumerate(keys := path.split(".")):
        if document is None:
            return None
        if key == "*":
            return [at(entry, ".".join(keys[n + 1 :])) for entry in document]
        if isinstance(document, list) and not key.isdecimal():
            document = next(entry for entry in document if entry["name"] == key)
        else:
            document = document[int(key) if isinstance(document, list) else key]
    return document


class NoResults(Exception):
    """A row whose command has not been computed."""


class Row:
    """One row of a study: its place on the axes, its command, its results."""

    def __init__(self, study, places):
        self.study, self.places = study, places
        self.name = " / ".join(places.values()) or study.name
        self.values = None

    def arguments(self, samples=None):
        """Arguments of `cageless`; of a drop with its first `samples` only."""
        declared = self.study.declared
        settings = list(declared.get("set", []))
        case = declared.get("case")
        for axis, place in self.places.items():
            for item in declared["axes"][axis][place]:
                if item.startswith("case="):
                    case = item.removeprefix("case=")
                else:
                    settings.append(item)
        options = [item for item in settings if item.startswith("--")]
        sets = [item for item in settings if not item.startswith("--")]
        arguments = [*declared["command"].split(), *([case] if case else [])]
        for text in sets:
            arguments += ["--set", text]
        for option in options:
            arguments += option.split(" ")
        if "samples" in declared:
            arguments += ["--samples", str(samples or declared["samples"])]
        return arguments

    # --- results ---

    def __getitem__(self, name):
        if self.values is None:
            raise NoResults(f"no results of {self.study.name}: {self.name}")
        return self.values[name]

    def of(self, name):
        """Values of all drops that have one."""
        return [v for v in self[name] if v is not None]

    def mean(self, name):
        found = self.of(name)
        return statistics.fmean(found) if found else None

    def count(self, name, condition):
        """Drops whose result keeps a condition."""
        return sum(condition(v) for v in self.of(name))

    def drops(self):
        return len(self["end_state"])

    def colliding(self):
        """Drops whose balls collide to the end."""
        least_hz = COLLIDING_HZ * self.study.declared.get("balls", 14)
        return self.count("end_collision_rate_hz", lambda rate: rate > least_hz)

    def reference(self):
        """The row at the first place of the axis that the study compares along."""
        axis = self.study.declared["compare"]
        first = next(iter(self.study.declared["axes"][axis]))
        return self.study[{**self.places, axis: first}]

    def change(self, name):
        """Mean difference to the reference in the same drops, and its standard error."""
        pairs = zip(self[name], self.reference()[name])
        differences = [a - b for a, b in pairs if a is not None and b is not None]
        if len(differences) < 2:
            return None
        error = statistics.stdev(differences) / math.sqrt(len(differences))
        return statistics.fmean(differences), error


class Study:
    """A study with the results that it has."""

    def __init__(self, name, declared):
        self.name, self.declared = name, declared
        axes = declared.setdefault("axes", {})
        self.rows = [Row(self, dict(zip(axes, places))) for places in itertools.product(*axes.values())]
        self.path = RESULTS / f"{name}.json"
        self.machine = None
        if self.path.exists():
            stored = json.loads(self.path.read_text(encoding="utf-8"))
            self.machine = stored["machine"]
            for row in self.rows:
                found = stored["rows"].get(row.name, {})
                if found.get("arguments") == " ".join(row.arguments()):
                    row.values = found["results"]

    def __getitem__(self, places):
        """The row with all of these places."""
        if isinstance(places, dict):
            places = tuple(places.values())
        wanted = [places] if isinstance(places, str) else places
        found = [row for row in self.rows if all(p in row.places.values() for p in wanted)]
        if len(found) != 1:
            raise KeyError(f"{self.name}: {len(found)} rows with {wanted}")
        return found[0]

    def of(self, *places):
        """All rows with these places that have results."""
        return [row for row in self.rows if row.values and all(p in row.places.values() for p in places)]

    def save(self, version):
        """Writes the rows that have results, each value on a line of its own."""
        rows = {
            row.name: {"arguments": " ".join(row.arguments()), "results": row.values}
            for row in self.rows
            if row.values is not None
        }
        head = json.dumps({"command": "python3 docs/studies compute", "version": version, "machine": MACHINE})
        lines = []
        for name, row in rows.items():
            values = ",\n".join(f"      {json.dumps(k)}: {json.dumps(v)}" for k, v in row["results"].items())
            lines.append(
                f"    {json.dumps(name, ensure_ascii=False)}: {{\n      \"arguments\": {json.dumps(row['arguments'])},\n"
                f"      \"results\": {{\n{values}\n      }}\n    }}"
            )
        text = head[:-1] + ', "rows": {\n' + ",\n".join(lines) + "\n  }\n}\n"
        RESULTS.mkdir(exist_ok=True)
        part = self.path.with_suffix(".part")
        part.write_text(text, encoding="utf-8")
        part.replace(self.path)

    def sampled_row(self, seed):
        """The row that stands for all where only a sample is computed, another one for every seed."""
        places = self.declared.get("sample", [])
        # What an earlier run of its command has.
        places = [] if places == "none" else places
        rows = self.of(*places) or [row for row in self.rows if all(p in row.places.values() for p in places)]
        return rows[zlib.crc32(f"{seed} {self.name}".encode()) % len(rows)]


def commit():
    """The commit of the tree, by which samples are drawn; empty without git."""
    done = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, capture_output=True, text=True)
    return done.stdout.strip()


def studies():
    """All studies by their names."""
    declared = tomllib.loads((RESULTS / "studies.toml").read_text(encoding="utf-8"))
    for study in declared["study"].values():
        study["keep"] = declared["keep"].get(str(study["keep"]), study["keep"])
    return {name: Study(name, of) for name, of in declared["study"].items()}


class Program:
    """The command `cageless`, with a memory of what this very file has computed."""

    def __init__(self, path, target, threads=1):
        self.path, self.folder = Path(path).resolve(), Path(target) / "documents"
        self.digest = hashlib.sha256(self.path.read_bytes()).hexdigest()[:16]
        self.threads = threads
        self.folder.mkdir(parents=True, exist_ok=True)

    def version(self):
        return subprocess.run(
            [self.path, "--version"], check=True, capture_output=True, text=True
        ).stdout.split()[1]

    def results(self, row, samples=None, finished=None):
        """Results of a row as its study keeps them; `finished` is a folder of an earlier run of its command."""
        declared = row.study.declared
        arguments = row.arguments(samples)
        inputs = [a for a in arguments if (ROOT / a).is_file()]
        key = hashlib.sha256(self.digest.encode() + json.dumps([arguments, declared["keep"]]).encode())
        for name in inputs:
            key.update((ROOT / name).read_bytes())
        remembered = self.folder / f"{key.hexdigest()[:24]}.json"
        if not remembered.exists():
            results = self.computed(row, arguments, finished)
            part = remembered.with_suffix(".part")
            part.write_text(json.dumps(results), encoding="utf-8")
            part.replace(remembered)
        return rounded(json.loads(remembered.read_text(encoding="utf-8")), declared.get("digits", 6))

    def computed(self, row, arguments, finished):
        """Results by the command, or of its earlier run."""
        declared = row.study.declared
        folder = finished or self.folder / f"{row.study.name} {row.name}".replace("/", "-").strip()
        document = {} if finished else self.run(arguments, folder, declared)
        results = {}
        if page := declared.get("page"):
            document = json.loads((folder / page).read_text(encoding="utf-8"))
        keep = declared["keep"]
        if "samples" in declared:
            keep = {name: f"ensemble.drops.*.bearings.0.result.{name}" for name in keep}
        for name, path in keep.items():
            results[name] = at(document, path)
        if analysis := declared.get("analysis"):
            results |= importlib.import_module(analysis).results(folder, document)
        return results

    def run(self, arguments, folder, declared):
        """Runs a command; what it printed as JSON."""
        options = []
        if "analysis" in declared or "page" in declared:
            options += ["--out", folder]
        if "analysis" in declared:
            options += ["--csv"]
        if arguments[0] != "reproduce":
            options += ["--json"]
        environment = {**os.environ, "RAYON_NUM_THREADS": str(self.threads)}
        done = subprocess.run(
            [self.path, *arguments, *options, "--quiet"],
            cwd=ROOT, env=environment, capture_output=True, text=True,
        )  # fmt: skip
        if done.returncode not in declared.get("exit_codes", [0]):
            raise RuntimeError(f"cageless {' '.join(arguments)}: exit code {done.returncode}\n{done.stderr}")
        return json.loads(done.stdout) if done.stdout.strip() else {}
