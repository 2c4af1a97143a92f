"""The studio in a real browser: controls, undo, links, errors, cancelled work, comparison.

    python studio.py folder/for/screenshots name=path/to/page.html-or-address …

An address is served by `cageless studio --no-browser`.
"""

import json
import re
import sys
import tempfile
from pathlib import Path

from checks import check, exit_code
from pages import Browser

S = "window.cagelessStudio"


class StudioTab:
    def __init__(self, tab, name):
        self.tab, self.name = tab, name

    def js(self, expression):
        return self.tab.js(expression)

    def check(self, what, good, found=None):
        check(f"{self.name}: {what}", good, found)

    def settled(self):
        """Waits for the geometry of the text that stands there."""
        self.tab.wait_for(f"!!{S} && !!{S}.g && !{S}.busy")

    def judged(self):
        self.tab.wait_for("document.querySelector('[data-part=verdict]').dataset.kind === 'simulated'")

    def slide(self, control, value):
        self.js(
            f"(() => {{ const e = document.querySelector('[data-range={control}]'); e.value = {value};"
            " e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); })()"
        )
        self.settled()

    def write(self, control, value):
        self.js(
            f"(() => {{ const e = document.querySelector('[data-number={control}]'); e.value = {value};"
            " e.dispatchEvent(new Event('change')); })()"
        )
        self.settled()

    def type(self, text):
        self.js(
            f"(() => {{ const e = document.querySelector('[data-toml]'); e.value = {json.dumps(text)};"
            " e.dispatchEvent(new Event('input')); })()"
        )
        self.settled()

    def press(self, name):
        # A report has moving balls of its own.
        place = "" if name == "open" else ".studio "
        self.js(f"document.querySelector('{place}[data-{name}]').click()")

    def text(self, part):
        return self.js(f"document.querySelector('[data-part={part}]').textContent")

    def toml(self):
        return self.js("document.querySelector('[data-toml]').value")


def controls(s):
    """Each control changes its keys of the text, and undo takes that back."""
    first = s.toml()
    for control in s.js("[...document.querySelectorAll('[data-range]')].filter((e) => !e.disabled).map((e) => e.dataset.range)"):
        before = s.toml()
        number = f"document.querySelector('[data-number={control}]')"
        value = s.js(f"Number({number}.value)")
        # Towards the middle of the slider, where there is room.
        low, high = s.js(f"(() => {{ const r = document.querySelector('[data-range={control}]'); return [Number(r.min), Number(r.max)]; }})()")
        step = 1 if control in ("balls", "clearance", "centre") else (high - low) / 200
        target = value + (-step if value > (low + high) / 2 else step)
        s.write(control, target)
        changed = s.toml()
        s.check(f"{control} changes the text", changed != before)
        s.check(f"{control} is possible", not s.text("message"), s.text("message"))
        back = s.js(f"Number({number}.value)")
        s.check(f"{control} shows its value", abs(back - target) <= 1e-3 * max(1, abs(target)), [target, back])
        s.press("undo")
        s.settled()
        s.check(f"undo of {control}", s.toml() == before)
    s.check("every change is undone", s.toml() == first)
    s.press("redo")
    s.settled()
    s.check("redo", s.toml() != first)
    s.press("undo")
    s.settled()


def limits(s):
    """Impossible ranges are shaded, and a slider does not enter them."""
    s.tab.wait_for(f"!!{S}.ranges")
    shaded = s.js("[...document.querySelectorAll('.control:not(.absent) .allowed')].filter((e) => e.style.background.includes('gradient')).length")
    s.check("impossible ranges are shaded", shaded >= 9, shaded)
    limit = s.js(f"{S}.g.numbers.axial_span_limit_mm")
    s.slide("span", 8.2)
    span = s.js(f"{S}.g.raceways[0].axial_span_mm")
    s.check("the slider of lC stops at Eq. (8)", 0.98 * limit < span <= limit, [span, limit])
    s.check("nothing impossible was set", not s.text("message"), s.text("message"))
    s.press("undo")
    s.settled()


def messages(s):
    """What the command says of a bad text stands beside it."""
    good = s.toml()
    s.type(good.replace("balls = 14", "balls = 40"))
    s.check("an impossible value is refused with its key", "bearing.balls" in s.text("message"), s.text("message"))
    s.check("the text is marked", s.js("document.querySelector('[data-toml]').hasAttribute('aria-invalid')"))
    s.type(good.replace("axial_span_mm", "axial_spam_mm"))
    s.check("a slip of the pen is named", "did you mean axial_span_mm?" in s.text("message"), s.text("message"))
    s.type("[[[")
    s.check("broken TOML has its line", "case:1" in s.text("message"), s.text("message"))
    s.type(good)
    s.check("a good text again", not s.text("message"), s.text("message"))
    s.type(re.sub(r"(?m)^axial_span_mm = .*$", "axial_span_mm = 4.9", good, count=1))
    s.check("the form follows the text", s.js("Number(document.querySelector('[data-number=span]').value)") == 4.9)
    s.type(good)


def verdict(s):
    """First an estimate, then the simulated verdict; a change cancels the work."""
    span = s.js(f"{S}.g.raceways[0].axial_span_mm")
    s.slide("span", span - 0.02)
    s.check("the estimate is marked", s.js("document.querySelector('[data-part=verdict]').dataset.kind") == "estimate")
    s.check("and says so", "Estimate" in s.text("verdict"), s.text("verdict"))
    s.tab.wait_for(f"!!{S}.judging && !!document.querySelector('progress')")
    s.slide("span", span)
    s.check("a change cancels the verdict", s.js("document.querySelector('[data-part=verdict]').dataset.kind") == "estimate")
    s.judged()
    said = s.text("verdict")
    s.check("the simulated verdict replaces it", "PASS" in said or "FAIL" in said, said)
    rows = s.js("document.querySelectorAll('[data-part=terms] tbody tr').length")
    s.check("with its margins", rows == 3, rows)


def motion(s):
    s.tab.wait_for(f"{S}.motion.frames.length > 30")
    s.js(f"{S}.run(true)")
    before = s.js(f"{S}.now")
    s.tab.wait_for(f"{S}.now > {before} + 2e-4")
    s.check("the balls move", True)
    s.press("play")
    held = s.js(f"{S}.now")
    s.js("new Promise((done) => setTimeout(done, 200))")
    s.check("pause holds them", s.js(f"{S}.now") == held)
    s.check("a frame is finite", s.js(f"Object.values({S}.frame).flat().every(isFinite)"))
    grows = s.js(f"{S}.motion.frames.map((f) => f.t)")
    s.check("time grows across stretches", all(a < b for a, b in zip(grows, grows[1:])))
    ink = s.js(
        "[...document.querySelectorAll('.studio canvas')].filter((c) => c.clientWidth).map((c) => c.getContext('2d')"
        ".getImageData(0, 0, c.width, c.height).data.some((v) => v > 0))"
    )
    s.check("every canvas is drawn", all(ink) and len(ink) >= 4, ink)


def comparison(s):
    s.press("conventional")
    s.tab.wait_for("!!document.querySelector('[data-part=table] tbody')")
    table = s.text("table")
    s.check("the table of differences", "β0" in table and "conventional" in table, table[:80])
    s.check("a conventional ring is not judged", "not judged" in table, table[:200])
    s.tab.wait_for(f"{S}.motionA.frames.length > 0")
    s.check("A moves as well", True)
    s.press("pin")
    s.tab.wait_for("document.querySelector('[data-part=table]').textContent.includes('pinned')")
    s.press("unpin")
    s.check("unpinned", not s.text("table"))


def links(s, browser):
    s.write("theta", 24.5)
    text = s.toml()
    code = s.js("(async () => { const b = [...document.querySelectorAll('button')].find((e) => e.textContent === 'Copy link'); navigator.clipboard.writeText = async () => {}; b.click(); for (let k = 0; k < 100 && !window.cagelessStudio.copied; k++) await new Promise((d) => setTimeout(d, 20)); return window.cagelessStudio.copied; })()")
    s.check("a link carries the case", "#case=" in code, code[:60])
    other = StudioTab(browser.open(code), s.name + " by link")
    other.settled()
    other.check("the link opens the same text", other.toml() == text)
    other.press("original")
    other.settled()
    other.check("back to the case as computed", other.toml() != text)
    for label, part in (("Copy command", "cageless design"), ("Copy Python", "Case.from_toml"), ("Copy TOML", "[bearing]")):
        made = s.js(f"(async () => {{ window.cagelessStudio.copied = ''; [...document.querySelectorAll('button')].find((e) => e.textContent === '{label}').click(); await new Promise((d) => setTimeout(d, 50)); return window.cagelessStudio.copied; }})()")
        s.check(label, part in made, made[:80])
    s.press("undo")
    s.settled()


def looks(s, screens):
    for name, width, dark in (("wide", 1280, False), ("narrow", 420, False), ("dark", 1280, True)):
        s.tab.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        s.tab.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        s.js("new Promise((done) => setTimeout(done, 300))")
        over = s.js("document.documentElement.scrollWidth - document.documentElement.clientWidth")
        s.check(f"{name}: nothing sticks out to the right", over <= 0, over)
        # A report has too much in it besides for a picture beside calculations.
        if s.name == "run":
            continue
        height = min(s.js("document.documentElement.scrollHeight"), 4000)
        clip = {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}
        s.tab.screenshot(screens / f"studio-{s.name}-{name}.png", clip=clip, captureBeyondViewport=True)
    s.tab.call("Emulation.clearDeviceMetricsOverride")
    nameless = s.js(
        "[...document.querySelectorAll('.studio input:not([hidden]), .studio select, .studio textarea, .studio button, .studio canvas, .studio progress')]"
        ".filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || (e.labels && e.labels.length))).map((e) => e.outerHTML)"
    )
    s.check("everything has an accessible name", not nameless, nameless)


# Largest difference of the numbers in two answers, over the largest number of the same array;
# components of a vector over the larger one, single numbers over their own size, at least a
# thousandth of their unit.
DIFFERENCE = """
(function difference(a, b, scale = 0) {
  if (typeof a === "number") return Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b), scale, 1e-3);
  if (Array.isArray(a) && a.length && a.every((v) => typeof v === "number")) {
    const scale = Math.max(...a.map(Math.abs), 1e-3);
    return Math.max(...a.map((v, k) => Math.abs(v - b[k]) / scale));
  }
  if (a && typeof a === "object") return Math.max(0, ...Object.keys(a).map((k) => difference(a[k], b[k], Math.abs(a[k.replace("_x_", "_y_")]) || 0)));
  return a === b ? 0 : Infinity;
})
"""
# The angles at the end of a stretch, all digits.
ANGLES = """
((answer) => answer.resume.angle_rad.match(/.{16}/g).map((hex) => {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setBigUint64(0, BigInt("0x" + hex));
  return bits.getFloat64(0);
}))
"""


def agreement(s):
    """The engine of the page and the native one give the same numbers."""
    for what, request, of in (
        ("geometry and closed forms", "{ op: 'geometry' }", "((answer) => answer)"),
        ("static equilibrium", "{ op: 'static' }", "((answer) => answer)"),
        ("angles after 2 ms of motion", "{ op: 'motion', duration_s: 2e-3, frames: 10 }", ANGLES),
    ):
        off = s.js(
            f"(async () => {{ const [a, b] = await Promise.all([{S}.engine.page, {S}.engine.server].map((e) =>"
            f" e.request('agreement', {{ ...{request}, case: {S}.toml }}).then({of})));"
            f" return ({DIFFERENCE})(a, b); }})()"
        )
        s.check(f"{what}: page and server agree", off is not None and off <= 1e-12, off)
        print(f"{what}: native against WebAssembly {off:.1e}")


def quiet(s, served):
    urls = [e["request"]["url"] for e in s.tab.happened("Network.requestWillBeSent")]
    foreign = [u for u in urls if not u.startswith(("file:", "data:", "blob:", *served))]
    s.check("loads nothing from elsewhere", not foreign, foreign)
    said = [e["args"] for e in s.tab.happened("Runtime.consoleAPICalled") if e["type"] in ("error", "assert")]
    thrown = [e["exceptionDetails"]["text"] for e in s.tab.happened("Runtime.exceptionThrown")]
    logged = [e["entry"]["text"] for e in s.tab.happened("Log.entryAdded") if e["entry"]["level"] == "error"]
    s.check("no errors on the console", not (said + thrown + logged), said + thrown + logged)


def studio(browser, name, url, screens):
    served = () if url.startswith("file:") else (url.split("?")[0],)
    s = StudioTab(browser.open(url), name)
    opened = s.js("!!document.querySelector('[data-open]')")
    if opened:
        s.press("open")
    s.settled()
    host = s.text("host")
    s.check("names its engine", ("native" if served else "WebAssembly") in host, host)
    limits(s)
    controls(s)
    messages(s)
    motion(s)
    verdict(s)
    comparison(s)
    links(s, browser)
    looks(s, screens)
    if served and s.js(f"!!{S}.engine.page"):
        agreement(s)
    quiet(s, served)
    print("estimate", s.js("document.querySelector('.studio').dataset.estimateMs"), "ms, verdict", s.js("document.querySelector('.studio').dataset.verdictMs"), "ms")


def main():
    screens = Path(sys.argv[1])
    screens.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=screens, ignore_cleanup_errors=True) as profile:
        with Browser(profile) as browser:
            for argument in sys.argv[2:]:
                name, _, place = argument.partition("=")
                url = place if place.startswith("http") else Path(place).resolve().as_uri()
                try:
                    studio(browser, name, url, screens)
                except RuntimeError as error:
                    check(f"{name}: the studio works", False, error)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
