"""The workflows of the public host, as far as they can be tested without it, and what a release packs.

    workflows.py CAGELESS FOLDER

Of a workflow: the schema of the host, the names of jobs and matrices that it refers to, its shell scripts by
shellcheck, and zizmor's audit, which wants every action pinned to a commit. Of a release: `.ci/release.py`, and the
schemas of files.
"""

import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import jsonschema
from checks import check, exit_code
from ruamel.yaml import YAML

ROOT = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.executable).parent
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))


def run(*command, cwd=ROOT, **options):
    return subprocess.run(command, capture_output=True, text=True, cwd=cwd, **options)


def passes(what, *command, **options):
    done = run(*command, **options)
    check(what, done.returncode == 0, done.stdout + done.stderr)
    return done.returncode == 0


def check_workflow(path):
    workflow, name = YAML(typ="safe").load(path), path.name
    for job, of in workflow["jobs"].items():
        needed = of.get("needs", [])
        for other in [needed] if isinstance(needed, str) else needed:
            check(f"{name}: {job} needs {other}", other in workflow["jobs"], "is no job")
        matrix = of.get("strategy", {}).get("matrix", {})
        keys = set(matrix) | {key for entry in matrix.get("include", []) for key in entry}
        for key in re.findall(r"matrix\.(\w+)", json.dumps(of)):
            check(f"{name}: {job}: matrix.{key}", key in keys, "is not in the matrix")
        check_steps(f"{name}: {job}", of["steps"])


def check_steps(name, steps):
    for step in steps:
        if script := step.get("run"):
            script = re.sub(r"\$\{\{.*?\}\}", "1", script)
            # Variables come from the environment that the workflow sets.
            rules = ["--shell=bash", "--severity=warning", "--exclude=SC2154"]
            passes(f"{name}: {script}", TOOLS / "shellcheck", *rules, "-", input=script)
        for tool in re.findall(r"(?:python3?|bash) ([\w./-]+\.(?:py|sh))\b", step.get("run", "")):
            check(f"{name}: {tool}", (ROOT / tool).is_file(), "is not there")


def check_release(cageless, folder):
    description = importlib.util.spec_from_file_location("release", ROOT / ".ci/release.py")
    release = importlib.util.module_from_spec(description)
    description.loader.exec_module(release)
    text = "# Changelog\n\n## Unreleased\n\n- new\n\n## 0.2.0 (2026-01-31)\n\n- second\n\n## 0.2.0-rc.1\n\n- first\n"
    check("release: notes", release.notes("v0.2.0", text) == "- second\n", release.notes("v0.2.0", text))
    for missing in ("v0.3.0", "v0.2"):
        try:
            check(f"release: no notes of {missing}", False, release.notes(missing, text))
        except SystemExit as refused:
            check(f"release: no notes of {missing}", missing.removeprefix("v") in str(refused), refused)
    done = run(sys.executable, ROOT / ".ci/release.py", "version", "v0.0.0")
    check("release: another tag is refused", done.returncode == 1 and "v0.0.0" in done.stderr, done.stderr)

    shutil.rmtree(folder, ignore_errors=True)
    archive = release.archive(cageless, "cageless-linux-x86_64", folder)
    release.checksums(folder)
    passes("release: checksums", "sha256sum", "--check", "--strict", "SHA256SUMS", cwd=folder)
    shutil.unpack_archive(archive, folder / "unpacked")
    unpacked = folder / "unpacked/cageless-linux-x86_64"
    passes("release: the command with its cases", "./cageless", "check", "cases/rotors/two-bearings.toml", cwd=unpacked)
    check("release: licences", len(list(unpacked.rglob("*LICENSE*"))) == 3, list(unpacked.iterdir()))
    text = (unpacked / "README.md").read_text(encoding="utf-8")
    links = {link.split("#")[0] for link in re.findall(r"\]\(([^)\s]+)\)", text) if "://" not in link}
    dead = sorted(link for link in links - {""} if not (unpacked / link).exists())
    check("release: links of its README", len(links) > 20 and not dead, dead)
    check_schemas(unpacked)


def check_schemas(folder):
    """JSON schemas of editors: each has the files of its format, and refuses a later version of it."""
    for name, files in {"case-file": "cases/*.toml", "rotor-file": "cases/rotors/*.toml", "plan": "plans/*.toml"}.items():
        text = (folder / f"docs/{name}.schema.json").read_text(encoding="utf-8")
        of_wheel = ROOT / f"crates/cageless-py/python/cageless/schemas/{name}.schema.json"
        check(f"schema: {name} of the wheel", of_wheel.read_text(encoding="utf-8") == text)
        schema, found = jsonschema.Draft7Validator(json.loads(text)), sorted(folder.glob(files))
        check(f"schema: {name}: files", found)
        for path in found:
            of_file = tomllib.loads(path.read_text(encoding="utf-8"))
            wrong = [f"{error.json_path}: {error.message}"[:200] for error in schema.iter_errors(of_file)]
            check(f"schema: {path.name}", not wrong, wrong)
            for change in ({"schema": 99}, {"nonsense": 1}):
                check(f"schema: {path.name} with {change}", not schema.is_valid(of_file | change), "is not refused")


def main():
    cageless, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    check("workflows", len(WORKFLOWS) > 3)
    schema = ["--builtin-schema", "vendor.github-workflows"]
    if not passes("workflows: schema", TOOLS / "check-jsonschema", *schema, *WORKFLOWS):
        return exit_code()
    passes("workflows: audit", TOOLS / "zizmor", "--offline", "--no-progress", "--min-severity", "low", *WORKFLOWS)
    for path in WORKFLOWS:
        check_workflow(path)
    check_release(cageless, folder)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
