"""The crates as they would be published: what `cargo package` takes, and what each needs of it.

    packages.py    checks the manifests and the files of every crate that is not `publish = false`
"""

import json
import re
import subprocess
import sys
from pathlib import Path

from checks import check, exit_code

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'include(?:_str|_bytes)?!\(\s*"([^"]+)"')


def cargo(*arguments):
    run = subprocess.run(["cargo", *arguments], cwd=ROOT, capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    return run.stdout


def main():
    metadata = json.loads(cargo("metadata", "--locked", "--no-deps", "--format-version", "1"))
    published = [p for p in metadata["packages"] if p["publish"] is None]
    check("crates to publish", len(published) > 3)
    names = {p["name"] for p in published}
    for package in published:
        name = package["name"]
        folder = Path(package["manifest_path"]).parent
        for field in ["description", "keywords", "categories", "license", "readme", "rust_version"]:
            check(f"{name}: {field}", package[field])
        check(f"{name}: at most five keywords", len(package["keywords"]) <= 5)
        for dependency in package["dependencies"]:
            if dependency.get("path") and dependency["kind"] != "dev":
                check(f"{name}: {dependency['name']} is published", dependency["name"] in names)
                check(f"{name}: {dependency['name']} has a version", dependency["req"] != "*")
        listing = cargo("package", "--locked", "--list", "--allow-dirty", "-p", name).split()
        check(f"{name}: its README", "README.md" in listing)
        for source in (folder / "src").rglob("*.rs"):
            for included in INCLUDE.findall(source.read_text()):
                target = (source.parent / included).resolve()
                inside = target.is_relative_to(folder)
                path = str(target.relative_to(folder)) if inside else included
                check(f"{name}: {included} of {source.name} is packaged", path in listing)
            # Of names that are put together.
            text = source.read_text()
            check(f"{name}: {source.name} stays in its crate", "include_str!(concat!" not in text)
    # In the order of their dependencies, each with its lock file; nothing is compiled or sent.
    exclude = [f"--exclude={p['name']}" for p in metadata["packages"] if p["name"] not in names]
    cargo("package", "--locked", "--workspace", *exclude, "--no-verify", "--allow-dirty", "--quiet")
    for package in published:
        archive = Path(metadata["target_directory"]) / "package"
        file = archive / f"{package['name']}-{package['version']}.crate"
        check(f"{package['name']}: archive", file.is_file())
    return exit_code()


sys.exit(main())
