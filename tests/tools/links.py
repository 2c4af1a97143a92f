"""Follows the links of the Markdown files, as the public host reads them, and of the site of documentation.

    links.py [SITE]    SITE is the folder that docs/site/build.py wrote

Of Markdown: files, pictures and headings of this repository, of files that git follows alone. Of the site: every
file and every place in a page; and nothing that a page needs comes from a network. Addresses elsewhere are not
opened.
"""

import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from checks import check, exit_code
from markdown_it import MarkdownIt

ROOT = Path(__file__).resolve().parents[2]
# What a page cannot do without, unlike what a reader may follow.
NEEDED = {("script", "src"), ("link", "href"), ("img", "src"), ("source", "src"), ("iframe", "src")}


def slug(heading):
    """Name of a heading in an address, as GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


class Markdown:
    """Headings and links of a Markdown file."""

    def __init__(self, text):
        self.headings, self.links = set(), []
        tokens = MarkdownIt("gfm-like", {"linkify": False}).parse(text)
        for before, token in zip([None, *tokens], tokens):
            if token.type != "inline":
                continue
            if before.type == "heading_open":
                text = "".join(part.content for part in token.children if part.type in ("text", "code_inline"))
                name, n = slug(text), 0
                while name + (f"-{n}" if n else "") in self.headings:
                    n += 1
                self.headings.add(name + (f"-{n}" if n else ""))
            self.follow(token.children)

    def follow(self, parts):
        for part in parts:
            address = part.attrGet("href") or part.attrGet("src")
            if address:
                self.links.append(address)
            if part.type == "image":
                self.follow(part.children)


class Page(HTMLParser):
    """Places and links of a page of the site."""

    def __init__(self, text):
        super().__init__()
        self.places, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.places.add(value)
            if name in ("href", "src") and value:
                self.links.append((value, (tag, name) in NEEDED))


def check_markdown():
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    tracked = {name for name in names if name and (ROOT / name).exists()}
    folders = {parent.as_posix() for name in tracked for parent in Path(name).parents}
    files = {name: Markdown((ROOT / name).read_text(encoding="utf-8")) for name in tracked if name.endswith(".md")}
    check("Markdown files", len(files) > 30)
    for name, file in sorted(files.items()):
        for link in file.links:
            parts = urlsplit(link)
            if parts.scheme:
                check(f"{name}: {link}", parts.scheme in ("https", "http", "mailto"), "is no address of the web")
                continue
            path = ((ROOT / name).parent / unquote(parts.path)).resolve() if parts.path else ROOT / name
            target = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else None
            check(f"{name}: {link}", target in tracked or target in folders, "is not in the repository")
            if parts.fragment and target in files:
                there = parts.fragment in files[target].headings
                check(f"{name}: {link}", there, f"is no heading of {target}")


def found(site, pattern):
    """Files of the site; those of `cargo doc` are rustdoc's, the pages of the gallery have tests of their own."""
    return [path for path in site.rglob(pattern) if path.relative_to(site).parts[0] not in ("rust", "gallery")]


def check_site(site):
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in found(site, "*.html")}
    check("pages of the site", len(pages) > 30)
    for path, page in sorted(pages.items()):
        name = path.relative_to(site)
        for link, needed in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                check(f"{name}: {link}", not needed or parts.scheme == "data", "comes from a network")
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            check(f"{name}: {link}", target.exists(), "is not in the site")
            if parts.fragment and target in pages:
                check(f"{name}: {link}", unquote(parts.fragment) in pages[target].places, "is no place of that page")
    for path in found(site, "*.css") + found(site, "*.js"):
        text = path.read_text(encoding="utf-8")
        fetched = re.findall(r"@import[^;]*//|url\(['\"]?(?:https?:)?//[^)]*|import\(['\"]https?:[^)]*", text)
        check(f"{path.relative_to(site)}: nothing from a network", not fetched, fetched)


def main():
    check_markdown()
    for folder in sys.argv[1:]:
        check_site(Path(folder).resolve())
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
