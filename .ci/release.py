"""What a release is made of; `.github/workflows/release.yml` builds, tests and publishes it.

    release.py version TAG                   fails unless Cargo.toml, CITATION.cff and CHANGELOG.md have this version
    release.py notes TAG                     prints the part of CHANGELOG.md about it
    release.py archive PROGRAM NAME FOLDER   puts the command, with what goes with it, into FOLDER/NAME.tar.gz or .zip
    release.py checksums FOLDER              writes FOLDER/SHA256SUMS of all files in it
"""

import hashlib
import re
import shutil
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# At their places, so that links between them hold.
WITH_THE_COMMAND = [
    "README.md", "CHANGELOG.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "RECIPES.md", "CITATION.cff", "LICENSE-MIT", "LICENSE-APACHE",
    "crates/cageless-py/THIRD-PARTY-LICENSES.txt", "docs", "cases", "plans",
]  # fmt: skip


def notes(tag, changelog):
    """The part of a changelog below the heading of a version."""
    version = tag.removeprefix("v")
    found = re.search(rf"^## {re.escape(version)}(?![\w.-])[^\n]*\n(.*?)(?=^## |\Z)", changelog, re.DOTALL | re.MULTILINE)
    if not found or not found[1].strip():
        sys.exit(f"CHANGELOG.md has no text below a heading \"## {version}\"")
    return found[1].strip() + "\n"


def check_version(tag):
    workspace = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]
    cited = re.search(r"^version: (.*)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    versions = {"Cargo.toml": workspace["package"]["version"], "CITATION.cff": cited[1]}
    versions |= {f"Cargo.toml, {name}": of["version"] for name, of in workspace["dependencies"].items() if "path" in of}
    for place, version in versions.items():
        if f"v{version}" != tag:
            sys.exit(f"the tag is {tag}, the version in {place} is {version}")
    notes(tag, (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))


def archive(program, name, folder):
    """The path of the archive, which unpacks into a folder of its name."""
    with tempfile.TemporaryDirectory() as parent:
        inside = Path(parent) / name
        inside.mkdir()
        shutil.copy2(program, inside)
        for part in WITH_THE_COMMAND:
            (inside / part).parent.mkdir(parents=True, exist_ok=True)
            copy = shutil.copytree if (ROOT / part).is_dir() else shutil.copy2
            copy(ROOT / part, inside / part)
        kind = "zip" if program.suffix == ".exe" else "gztar"
        folder.mkdir(parents=True, exist_ok=True)
        return shutil.make_archive(str(folder / name), kind, root_dir=parent, base_dir=name)


def checksums(folder):
    files = sorted(path for path in folder.iterdir() if path.is_file() and path.name != "SHA256SUMS")
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in files]
    (folder / "SHA256SUMS").write_text("".join(lines), encoding="utf-8", newline="\n")


def main():
    match sys.argv[1:]:
        case ["version", tag]:
            check_version(tag)
        case ["notes", tag]:
            sys.stdout.reconfigure(encoding="utf-8")
            print(notes(tag, (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")), end="")
        case ["archive", program, name, folder]:
            print(archive(Path(program), name, Path(folder)))
        case ["checksums", folder]:
            checksums(Path(folder))
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
