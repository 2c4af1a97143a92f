#!/usr/bin/env python3
"""The licences of third-party code in the command and the Python package.

    licences.py           writes the notice file anew
    licences.py --check   compares it with the dependencies, and looks into the wheels given

The list is that of `cargo metadata` for Linux on x86-64, the texts are those in the crates."""

import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

from checks import check, exit_code

ROOT = Path(__file__).resolve().parents[2]
NOTICE = ROOT / "crates/cageless-py/THIRD-PARTY-LICENSES.txt"
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
OWN = ["LICENSE-MIT", "LICENSE-APACHE", NOTICE.name]
SHIPPED = ["cageless-cli", "cageless-py"]
# Of several licences to choose from, the first of these is chosen.
PREFERRED = ["MIT", "Apache-2.0", "BSD-3-Clause", "BSD-2-Clause", "Zlib"]
MIT = """Permission is hereby granted, free of charge, to any person obtaining a copy of this software
and associated documentation files (the "Software"), to deal in the Software without restriction,
including without limitation the rights to use, copy, modify, merge, publish, distribute,
sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or
substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT
NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND
NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM,
DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT
OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE."""


def dependencies():
    """Packages of others that are linked in, by name and version."""
    command = ["cargo", "metadata", "--format-version", "1", "--locked"]
    command += ["--filter-platform", "x86_64-unknown-linux-gnu"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    metadata = json.loads(done.stdout)
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    todo = [id for id, package in packages.items() if package["name"] in SHIPPED]
    seen = set(todo)
    while todo:
        for dependency in nodes[todo.pop()]["deps"]:
            linked = any(kind["kind"] is None for kind in dependency["dep_kinds"])
            if linked and dependency["pkg"] not in seen:
                seen.add(dependency["pkg"])
                todo.append(dependency["pkg"])
    others = [packages[id] for id in seen if packages[id]["source"]]
    return sorted(others, key=lambda p: (p["name"], p["version"]))


def expression(package):
    return (package["license"] or "see its text").replace("/", " OR ")


def chosen(package):
    """The licence that is chosen, or the expression where all of it applies."""
    terms = expression(package)
    if " AND " in terms:
        return terms
    offered = re.split(r"[ ()]+OR[ ()]+", terms)
    return next((name for name in PREFERRED if name in offered), terms)


def texts(package):
    """The texts that go with the chosen licence, and notices."""
    folder = Path(package["manifest_path"]).parent
    pattern = re.compile(r"^(licen[cs]e|copying|copyright|notice|unlicense)", re.IGNORECASE)
    files = sorted(p for p in folder.iterdir() if p.is_file() and pattern.match(p.name))
    if package["license_file"]:
        files = sorted({*files, folder / package["license_file"]})
    named = {
        "MIT": ["mit"],
        "Apache-2.0": ["apache"],
        "Zlib": ["zlib"],
        "BSD-3-Clause": ["bsd"],
        "BSD-2-Clause": ["bsd"],
    }
    words = named.get(chosen(package), [])
    kept = [p for p in files if any(word in p.name.lower() for word in words)]
    # A single file, whatever its name, or those that are of no licence by name.
    plain = [p for p in files if not re.search("mit|apache|zlib|bsd|unlicense|boost", p.name.lower())]
    found = [read(p) for p in (kept + plain or files)]
    if not found:
        holders = ", ".join(re.sub(r" <.*?>", "", a) for a in package["authors"])
        found = [f"Copyright (c) {holders or 'the authors of ' + package['name']}\n\n{MIT}"]
        assert chosen(package) in ("MIT", "Apache-2.0"), package["name"]
    return found


def read(path):
    text = path.read_text(encoding="utf-8", errors="replace")
    return "\n".join(line.rstrip() for line in text.strip().splitlines())


def plotly_js():
    """Name, licence and text of plotly.js, which is part of every page: the file that the build found names them."""
    built = sorted(TARGET.glob("*/build/cageless-report-*/out/plotly.min.js"), key=lambda p: p.stat().st_mtime)
    if not built:
        sys.exit(f"no plotly.min.js in {TARGET}: build the command first")
    head = re.match(r"/\*\*?(.*?)\*/", built[-1].read_text(encoding="utf-8")[:2000], re.DOTALL)
    name = re.sub(r"^[ *]+", "", head.group(1), flags=re.MULTILINE).strip()
    assert "MIT" in name, "plotly.js names another licence"
    return name.splitlines()[0], "MIT", f"{name}\n\n{MIT}"


def notice(packages):
    lines = [
        "Cageless contains code of others. Their names and licences, then the texts.",
        "",
        "Made by tests/tools/licences.py from the dependencies of the command and the Python package.",
        "",
    ]
    script, terms, script_text = plotly_js()
    rows = [(f"{p['name']} {p['version']}", expression(p)) for p in packages]
    rows = sorted([*rows, (script, terms)])
    width = max(len(name) for name, _ in rows)
    lines += [f"{name:{width}}  {terms}" for name, terms in rows]
    users = {}
    for package in packages:
        for text in texts(package):
            users.setdefault(text, []).append(package["name"])
    users.setdefault(script_text, []).append(script)
    for text, names in users.items():
        lines += ["", "=" * 80, ", ".join(dict.fromkeys(names)), "-" * 80, "", text]
    return "\n".join(lines) + "\n"


def main():
    written = notice(dependencies())
    if "--check" not in sys.argv:
        NOTICE.write_text(written, encoding="utf-8")
        return 0
    there = NOTICE.read_text(encoding="utf-8") if NOTICE.exists() else ""
    check("licences of dependencies", there == written, f"run {Path(__file__).name} and commit")
    for name in ["LICENSE-MIT", "LICENSE-APACHE"]:
        beside = NOTICE.with_name(name)
        same = beside.exists() and beside.read_bytes() == (ROOT / name).read_bytes()
        check(f"{name} of the package", same)
    for wheel in [a for a in sys.argv[1:] if a.endswith(".whl")]:
        with zipfile.ZipFile(wheel) as archive:
            names = archive.namelist()
            for name in OWN:
                held = [n for n in names if n.endswith(f".dist-info/licenses/{name}")]
                check(f"{name} in {Path(wheel).name}", len(held) == 1)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
