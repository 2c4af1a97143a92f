"""Refuses words that this project uses for nothing else than what they mean in the field.

    python words.py          # prints each hit with its line and what to write instead

Read are Markdown without code, formulas and comments; the string literals of the Rust and JavaScript sources that
have a space in them, and the help of the command; string literals of the Python package, docstrings included. A line
opts out with a comment that gives the reason, `words: REASON`, on the line itself or on the one before.
"""

import io
import re
import subprocess
import sys
import tokenize
from pathlib import Path

from checks import check, exit_code

ROOT = Path(__file__).parents[2]

# Pattern, case-insensitive, and what to write instead.
WORDS = [
    (r"\bbeside\b", "with, next to, compared with, in addition to"),
    (r"\blets? go\b", "at the start of the drop; a contact opens"),
    (r"\bstands?\b(?! for|-alone)", "is, is in"),
    (r"\bcounts? (?:in|as|from|first)\b|\bcounts?[.;]", "is counted in; takes precedence; is relative to"),
    (r"\bin number\b|\bby (?:itself|themselves)\b|\b(?:the|its) inside\b", "N times; stand-alone; internal geometry"),
    (r"if it is another|\bare others\b", "if different"),
    (r"\bbut for\b", "except"),
    (r"\bsays? (?:of|so|it|how|what|which|this)\b", "prints, shows, states that"),
    (r"\b(?:per|a) turn\b|\band turn\b", "orbit of a ball, revolution of the ring"),
    (r"\b(?:above|into) several\b", "on several"),
    (r"\bledger\b|\bproduction method\b|\bleapfrog\b|\bsymplectic\b", "energy balance; default method; velocity Verlet"),
    (r"\bkinks?\b|\bridges?\b|\bfurrows?\b", "slope discontinuity; apex"),
    (r"\bair gaps?\b", "touch-down clearance"),
    (r"(?<![\w/-])touchdown(?![\w-])", "touch-down"),
    (r"passing frequenc|speed parameter|osculation|ISO/TS 16281", "bearing frequencies; speed factor; conformity; ISO 16281:2025"),
    (r"uniform gap|gap of even|mean (?:ball )?spacing|\bseparation\b", "nominal gap, steady-state gap, critical gap"),
    (r"hit (?:from|by) both|both neighbours|collid\w* twice", "double collision"),
    (r"\bslip(?:s|ping|ped)?\b", "sliding, sliding speed"),
    (r"\bstress(?:es)?\b", "contact pressure"),
    (r"same bits|bits and all", "bit-identical"),
    (r"\brattl", "collide continuously"),
    (r"no trouble|something like|\bhardly\b|\bmostly\b", "the number"),
    (r"\bgoes (?:on|with|to|round)\b|\bjudged? within\b|\blooked at\b", "continues; tolerance study; evaluated"),
    (r"(?<![\w./-])(?:numpy|plotly|ross)(?![\w./-])", "NumPy, Plotly, ROSS", True),
    (r"(?<=[^\s] )(?:N m\b|kg m\^2)|\d ?(?:um|us)\b", "N·m, kg·m², µm, µs"),
    (r"\bmagnets? lets?\b", "start of the drop, loss of AMB power"),
    (r"(?<!20[67] )\bGPa\b(?!.*modulus)", "MPa, for pressures"),
]


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def only(spans, text):
    """The text with everything outside of these spans blanked."""
    kept = [c if c == "\n" else " " for c in text]
    for begin, end in spans:
        kept[begin:end] = text[begin:end]
    return "".join(kept)


CODE = re.compile(
    r"^(\s*)(```|~~~).*?^\s*\2[^\n]*$|<!--.*?-->|\$\$.*?\$\$|\$[^$\n]+\$|``.+?``|`[^`]*`|(?<=\])\([^)\n]*\)",
    re.DOTALL | re.MULTILINE,
)
QUOTED = re.compile(r"`[^`\n]*`|\$?\{[^{}\n]*\}")
RUST = re.compile(
    r"""(?P<doc>///[^\n]*)|//[^\n]*|/\*.*?\*/|'(?:\\.[^']*|[^'\\\n])'|b?r(?P<hash>#*)"(?P<raw>.*?)"(?P=hash)|"""
    r"""b?"(?P<text>(?:\\.|[^"\\])*)\"""",
    re.DOTALL,
)
JAVASCRIPT = re.compile(
    r"""//[^\n]*|/\*.*?\*/|"(?P<text>(?:\\.|[^"\\\n])*)"|'(?P<raw>(?:\\.|[^'\\\n])*)'|`(?P<doc>(?:\\.|[^`\\])*)`""",
    re.DOTALL,
)
TESTS = re.compile(r"^#\[cfg\(test\)\]\nmod \w+ \{.*", re.DOTALL | re.MULTILINE)


def literals(pattern, text, names):
    spans = [match.span(name) for match in pattern.finditer(text) for name in names if match[name] is not None]
    return QUOTED.sub(blank, only([s for s in spans if " " in text[s[0] : s[1]].strip()], text))


def python(text):
    starts = [0]
    for line in text.split("\n"):
        starts.append(starts[-1] + len(line) + 1)
    spans = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in (tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", -1)) and " " in token.string.strip():
            spans.append([starts[row - 1] + column for row, column in (token.start, token.end)])
    prose = re.sub(r"``.*?``", blank, only(spans, text), flags=re.DOTALL)
    return re.sub(r"(?m)^\s*(>>>|\.\.\.).*", blank, QUOTED.sub(blank, prose))


def prose(name, text):
    """The text with everything blanked that is not for readers; None if nothing is."""
    if name.endswith(".md"):
        return None if name == "CHANGELOG.md" else CODE.sub(blank, text)
    if name.endswith(".js") and "/src/" in name:
        return literals(JAVASCRIPT, text, ["text", "raw", "doc"])
    if re.match(r"crates/cageless(-\w+)?/src/.*\.rs$", name) and not re.search(r"cageless-bench/|tests?\.rs$|/tests/", name):
        # The tests of a file are its last module. Doc comments are help in one file.
        names = ["raw", "text"] + ["doc"] * name.endswith("cageless-cli/src/args.rs")
        return literals(RUST, TESTS.sub(blank, text), names)
    if name.startswith("crates/cageless-py/python/") and name.endswith(".py"):
        return python(text)
    return None


def opted_out(lines, number):
    return any("words: " in line for line in lines[max(number - 2, 0) : number])


def main():
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    found = {pattern: [] for pattern, *_ in WORDS}
    for name in filter(lambda name: (ROOT / name).is_file(), names):
        text = (ROOT / name).read_text(encoding="utf-8") if re.search(r"\.(md|rs|js|py)$", name) else ""
        read = prose(name, text)
        lines = text.split("\n")
        for pattern, _, *exact in WORDS if read else []:
            for match in re.finditer(pattern, read, 0 if exact else re.IGNORECASE):
                number = text.count("\n", 0, match.start()) + 1
                if not opted_out(lines, number):
                    found[pattern].append(f"{name}:{number}: {match.group()!r} in: {lines[number - 1].strip()[:150]}")
    for pattern, instead, *_ in WORDS:
        hits = found[pattern]
        check(f"/{pattern}/, {len(hits)} times; write: {instead}", not hits, "\n  ".join(["", *hits]))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
