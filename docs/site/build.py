"""Builds the site of documentation: pages that need neither a network nor a server.

    python docs/site/build.py SITE [--rust TARGET/doc] [--pages CAGELESS [--finished NAME=FOLDER] [--sooner]]

Its pages are those that `docs/README.md` lists, in the sections of that list, and what they link to. The commands
come from what `cageless help` printed (the snapshots of the tests), the Python interface from the docstrings.
`--rust` takes in the pages of `cargo doc`, `--pages` those that the commands of the gallery write, `--finished` one
that is written already; `--sooner` has the commands compute less, for a test. `./test site` installs what this needs,
builds and tests the site.
"""

import argparse
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from urllib.parse import unquote

from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
INDEX = "docs/README.md"
# Pages of the gallery: command and what it shows.
GALLERY = {
    "reproduce": ("reproduce", "every table and figure of the paper, recomputed, with every claim and how it stands"),
    "search": ("design cases/zhao-d.toml --search --set search.runs_max=60", "the best raceway for a bearing: what is feasible, why the rest is not, trade-offs"),
    "axial": ("design cases/zhao-d.toml --axial", "a raceway with its verdict, and how much axial load and tilt it bears"),
    "compare": ("compare cases/zhao-d.toml --with-conventional --set solver.duration_s=0.5", "a discrete raceway against a conventional ring, from the same starts"),
    "run": ("run cases/zhao-d.toml --set operation.axial_load_n=150 --set solver.duration_s=0.2", "the motion of balls and ring in space, under axial load"),
    "tolerance": ("tolerance cases/zhao-d.toml --samples 8", "machining, ball grade, friction and load: what changes the verdict"),
    "drop": ("drop cases/touchdown-d.toml --compare conventional --set solver.duration_s=0.3", "a rotor that falls onto its touch-down bearing"),
    "static": ("static cases/zhao-d.toml", "load distribution, ratings, stiffness, frequencies"),
}
# Of commands of the gallery: what `--sooner` replaces, and by what.
SOONER = {
    "axial": ("--axial", "--axial --set solver.method=verlet --set solver.step_us=auto"),
    "compare": ("duration_s=0.5", "duration_s=0.05 --set steady.transient_orbits=1 --set steady.measured_orbits=3"),
    "tolerance": ("--samples 8", "--samples 2 --set solver.method=verlet --set solver.step_us=auto"),
}
HELP = ROOT / "crates/cageless-cli/tests/snapshots"
LINK = re.compile(r"\]\(([^)\s#]+)[^)]*\)")
COMMENT = re.compile(r"^[ \t]*<!--(?:(?!-->).)*-->[ \t]*\n|<!--.*?-->", re.DOTALL | re.MULTILINE)
FENCE = re.compile(r"^( *)(```|~~~).*?^\1\2$", re.DOTALL | re.MULTILINE)


def outside_of_code(text):
    return FENCE.sub("", text)


def linked(name, text):
    """Files of the repository that a page links to."""
    for target in LINK.findall(outside_of_code(text)):
        if not re.match(r"[a-z]+:", target):
            path = ((ROOT / name).parent / unquote(target)).resolve()
            if not (path.is_file() and path.is_relative_to(ROOT)):
                sys.exit(f"{name} links to {target}, which is no file of the repository")
            yield path.relative_to(ROOT).as_posix()


def sections():
    """Headings of the index and the pages below each."""
    text = (ROOT / INDEX).read_text(encoding="utf-8")
    for part in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        heading, _, body = part.partition("\n")
        yield heading, [name for name in linked(INDEX, body) if name.endswith(".md")]


def for_sphinx(text):
    """A page without the marks of tools, and with languages that Sphinx knows."""
    return COMMENT.sub("", text).replace("```mermaid", "```text")


def staged(source):
    """Copies the pages and all that they link to, in the folders of the repository."""
    todo, done = ["README.md", INDEX], set()
    while todo:
        name = todo.pop()
        if name in done:
            continue
        done.add(name)
        place = source / name
        place.parent.mkdir(parents=True, exist_ok=True)
        if not name.endswith(".md"):
            shutil.copyfile(ROOT / name, place)
            continue
        text = (ROOT / name).read_text(encoding="utf-8")
        todo += linked(name, text)
        place.write_text(for_sphinx(text), encoding="utf-8")
    return done


def commands():
    """The help of every command."""
    lines = ["# Commands", "", "What `cageless help` prints. [Command line](../command-line.md) has what all commands share."]
    for snapshot in ("help.snap", "help_files.snap"):
        text = (HELP / snapshot).read_text(encoding="utf-8")
        for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
            command, _, printed = part.partition("\n")
            printed = re.sub(r"\nexit code \d+\n*$", "\n", printed).rstrip()
            lines += ["", f"## `{command.removesuffix(' --help')}`", "", "```text", printed, "```"]
    return "\n".join(lines) + "\n"


def python():
    """The interface of the Python package."""
    modules = (ROOT / "crates/cageless-py/python/cageless/__init__.py").read_text(encoding="utf-8")
    names = re.findall(r"^from \.(\w+) import \*", modules, re.MULTILINE)
    lines = ["# Python interface", "", "Everything is a name of the package `cageless`. [Python](../python.md) shows its use."]
    for name in names:
        lines += ["", f"## `{name}`", "", "```{eval-rst}", f".. automodule:: cageless.{name}", "```"]
    return "\n".join(lines) + "\n"


def rust(folder):
    """The crates, with links to their pages where `cargo doc` has made them."""
    lines = ["# Rust interface", ""]
    if not folder:
        lines += ["`cargo doc --workspace --no-deps --open` makes the pages of these crates.", ""]
    for manifest in sorted((ROOT / "crates").glob("*/Cargo.toml")):
        package = tomllib.loads(manifest.read_text(encoding="utf-8"))["package"]
        name, module = package["name"], package["name"].replace("-", "_")
        if folder and (folder / module).is_dir():
            name = f'<a href="../../rust/{module}/index.html">{name}</a>'
        lines.append(f"- {name}: {package['description']}")
    return "\n".join(lines) + "\n"


def gallery(pages):
    """The list of pages that commands write, with links to those that are there."""
    lines = ["# Gallery", "", "Pages as the commands write them: one file each, which computes on its own.", ""]
    for name, (command, shown) in GALLERY.items():
        text = f'<a href="../gallery/{name}.html">{shown}</a>' if name in pages else shown
        lines += [f"- {text}", "", "  ```sh", f"  cageless {command} --out {name}", "  ```", ""]
    return "\n".join(lines)


def written(cageless, finished, sooner, folder):
    """Pages of the gallery by the command, or of earlier runs."""
    folder.mkdir(parents=True)
    for name, (command, _) in GALLERY.items():
        if sooner and name in SOONER:
            long, short = SOONER[name]
            if long not in command:
                sys.exit(f"{long} is not in the command {command} of the gallery")
            command = command.replace(long, short)
        out = finished.get(name, folder / name)
        if name not in finished:
            subprocess.run([cageless, *command.split(), "--quiet", "--out", out], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        shutil.copyfile(out / "report.html", folder / f"{name}.html")
        if name not in finished:
            shutil.rmtree(out)
    return folder


def build(site, doc, cageless, finished, sooner):
    source = site.with_name(site.name + ".source")
    for folder in (source, site, site.with_name(site.name + ".gallery")):
        shutil.rmtree(folder, ignore_errors=True)
    shown = cageless and written(cageless, finished, sooner, site.with_name(site.name + ".gallery"))
    pages = {name for name in staged(source) if name.endswith(".md")}
    (source / "docs/gallery.md").write_text(gallery(GALLERY if shown else []), encoding="utf-8")
    made = {"commands": commands(), "python": python(), "rust": rust(doc)}
    (source / "docs/reference").mkdir(parents=True)
    for name, text in made.items():
        (source / f"docs/reference/{name}.md").write_text(text, encoding="utf-8")

    listed = {"README.md", INDEX}
    trees = []
    for heading, names in sections():
        listed |= set(names)
        if heading == "Studies":
            names = ["docs/gallery.md", *names]
        if heading == "Reference":
            names = names + [f"docs/reference/{name}.md" for name in made]
        trees += ["```{toctree}", ":hidden:", f":caption: {heading}", "", *names, "```", ""]
    # What is linked from elsewhere alone.
    trees += ["```{toctree}", ":hidden:", "", INDEX, *sorted(pages - listed), "```", ""]
    with open(source / "README.md", "a", encoding="utf-8") as root:
        root.write("\n" + "\n".join(trees))

    with patch_docutils(HERE), docutils_namespace():
        app = Sphinx(
            source, HERE, site, source / ".doctrees", "html",
            status=None, warningiserror=True, exception_on_warning=False, parallel=1,
        )  # fmt: skip
        app.build()
    if app.statuscode:
        return app.statuscode
    if doc:
        shutil.copytree(doc, site / "rust")
    if shown:
        shown.rename(site / "gallery")
    shutil.copyfile(site / "README.html", site / "index.html")
    shutil.rmtree(source)
    print(f"{site / 'index.html'} written")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("site", type=Path)
    parser.add_argument("--rust", type=Path, metavar="FOLDER")
    parser.add_argument("--pages", type=Path, metavar="CAGELESS")
    parser.add_argument("--finished", action="append", default=[], metavar="NAME=FOLDER")
    parser.add_argument("--sooner", action="store_true")
    options = parser.parse_args()
    finished = {name: Path(folder).resolve() for name, _, folder in (each.partition("=") for each in options.finished)}
    rust, pages = (path and path.resolve() for path in (options.rust, options.pages))
    return build(options.site.resolve(), rust, pages, finished, options.sooner)


if __name__ == "__main__":
    sys.exit(main())
