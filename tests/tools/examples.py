"""Writes a page of docs/rust for each example of `cageless` and `cageless-design`, with its source and what it prints.

    examples.py           runs the examples and compares the pages
    examples.py --write   runs the examples and writes the pages

An example runs as its own test, which `cargo test` has compiled.
"""

import json
import re
import subprocess
import sys

from checks import check, exit_code
from studies import ROOT
from tutorials import same_machine

EXAMPLES = {path.stem: path for of in ("cageless", "cageless-design") for path in ROOT.glob(f"crates/{of}/examples/*.rs")}
PAGES = ROOT / "docs/rust"
# What the runner of tests says around the output.
RUNNER = re.compile(r"^(?:running 1 test|test runs \.\.\. (?:ok)?|ok|test result: .*)?\n", re.MULTILINE)
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def programs():
    """The examples, compiled with all other tests."""
    command = ["cargo", "test", "--locked", "--profile", "tests", "--workspace", "--exclude", "cageless-bench"]
    command += ["--no-run", "--message-format", "json"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"examples: {run.stderr}")
    artifacts = (json.loads(line) for line in run.stdout.splitlines() if line.startswith("{"))
    return {a["target"]["name"]: a["executable"] for a in artifacts if "example" in a.get("target", {}).get("kind", [])}


def printed(program):
    """What an example prints."""
    run = subprocess.run([program, "--nocapture", "--test-threads=1"], cwd=ROOT, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{program}: {run.stdout}{run.stderr}")
    text = RUNNER.sub("", run.stdout)
    return re.sub(r"^test runs \.\.\. |^\.$", "", text, flags=re.MULTILINE).strip("\n")


def page(name, program):
    """The page of an example."""
    source = EXAMPLES[name].read_text(encoding="utf-8")
    head, _, code = source.partition("\n\n")
    lines = [line.removeprefix("//!").strip() for line in head.splitlines()]
    about, command = " ".join(lines[: lines.index("")]), lines[-1].strip("`")
    code = code.partition("\n#[test]")[0].strip()
    title = name.replace("_", " ").capitalize()
    return "\n".join(
        [f"# {title}", "", *wrapped(about), "", "```sh", command, "```", "", "```rust", code, "```", "", "It prints", ""]
        + ["```text", printed(program), "```", ""]
    )


def wrapped(text):
    """Lines of at most 120 characters."""
    line = ""
    for word in text.split():
        if len(line) + len(word) >= 120:
            yield line
            line = word
        else:
            line = f"{line} {word}".strip()
    yield line


def main():
    compiled = programs()
    for name in sorted(EXAMPLES):
        text = page(name, compiled[name])
        path = PAGES / f"{name}.md"
        if sys.argv[1:] == ["--write"]:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
            continue
        now = path.read_text(encoding="utf-8") if path.is_file() else ""
        # On another machine the last digits may differ.
        told = (lambda page: page) if same_machine() else lambda page: NUMBER.sub("0", page)
        check(f"docs/rust/{name}.md: the page of its example (examples.py --write)", told(now) == told(text))
    sys.exit(exit_code())


main()
