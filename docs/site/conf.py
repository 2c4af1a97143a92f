"""Settings of Sphinx for the site of documentation; `build.py` next to it prepares the pages."""

import html
import re
import sys
import tomllib
from pathlib import Path

from docutils.nodes import SkipNode
from latex2mathml.converter import convert

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "crates/cageless-py/python"))

project = "Cageless"
release = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
copyright = "the Cageless developers"
root_doc = "README"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]

# Markdown as the public host reads it.
myst_enable_extensions = ["dollarmath"]
myst_dmath_allow_labels = False
myst_fence_as_directive = ["math"]
myst_heading_anchors = 4
source_suffix = {".md": "markdown"}

# The Python package is read, not compiled.
autodoc_mock_imports = ["cageless._cageless"]
autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints = "signature"
napoleon_numpy_docstring = True

html_theme = "furo"
html_title = f"Cageless {release}"
html_static_path = [str(Path(__file__).with_name("style.css"))]
html_css_files = ["style.css"]
html_copy_source = html_show_sourcelink = False
# A page on the disk may not read other pages.
html_show_search_summary = False
html_math_renderer = "mathml"
pygments_style, pygments_dark_style = "friendly", "github-dark"


def mathml(text, display):
    """A formula of LaTeX as MathML, which browsers draw without a script."""
    formula = convert(text, display=display)
    if unknown := re.search(r"\\[A-Za-z]+", html.unescape(formula)):
        raise ValueError(f"{unknown.group()} of the formula {text} is not known")
    return formula


def inline(writer, node):
    writer.body.append(mathml(node.astext(), "inline"))
    raise SkipNode


def block(writer, node):
    writer.body.append(f'<div class="formula">{mathml(node.astext(), "block")}</div>')
    raise SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (inline, None), (block, None))
