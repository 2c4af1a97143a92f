"""The studio in a real browser: controls, map, materials, files, undo, links, errors, cancelled work.

    python studio.py folder/for/screenshots name=path/to/page.html-or-address …

An address is served by `cageless studio --no-browser`; `stopping=path/to/cageless` starts a server
of its own and ends it.
"""

import json
import math
import re
import sys
from pathlib import Path

from browser import in_browsers, thrown_text
from pages import axe
from studio_drawings import drawings
from studio_engine import agreement, alone, drop, same_drop, serve, stop, studies, trap
from studio_map import axes, older, raceway_map
from studio_space import space
from studio_tab import S, StudioTab


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


def impossible(s):
    """A value that cannot be marks its control, says why in its words, and takes the verdict away."""
    s.judged()
    for control, value, label in (("balls", 16, "Balls N = 16"), ("pitch", 20, "Pitch diameter Dpw = 20 mm")):
        s.write(control, value)
        field, why = f"document.querySelector('[data-number={control}]')", f"document.querySelector('[data-why={control}]')"
        s.tab.wait_for(f"!{why}.hidden")
        said = s.js(f"{why}.textContent")
        s.check(f"{control} {value} is refused in its own words", said.startswith(label + " is not possible") and "case" not in said.split(":")[0], said)
        marked = s.js(f"[{field}.getAttribute('aria-invalid'), {field}.getAttribute('aria-describedby') === {why}.id, Number({field}.value)]")
        s.check(f"the control of {control} is marked", marked == ["true", True, value], marked)
        lamp = s.js("(() => { const e = document.querySelector('[data-part=verdict]'); return [e.dataset.kind, e.className, e.textContent]; })()")
        s.check("there is no verdict on it", lamp[0] == "impossible" and "pass" not in lamp[1].split() and "works" not in lamp[2] and label in lamp[2], lamp)
        s.check("nor any criterion", not s.text("terms"), s.text("terms"))
        s.tab.wait_for(f"{why}.textContent.includes('with the other values')")
        s.press("undo")
        s.settled()
        s.check(f"{control} is accepted again", s.js(f"{why}.hidden && !{field}.hasAttribute('aria-invalid')") and not s.text("message"))
    s.judged()


def drawn(s):
    """Ball 1 is drawn where it is: counter-clockwise from the bottom."""
    s.js(f"{S}.stage.run(false)")
    svg = s.js(f"(async () => (await {S}.saving.file({S}.saving.things[0], 'svg')).text())()")
    angle = s.js(f"{S}.stage.frame ? {S}.stage.frame.angle_deg[0] : {S}.g.static.ball_angle_deg[0]")
    pitch, outer = s.js(f"[{S}.g.bearing.pitch_radius_mm, {S}.g.bearing.outer_radius_mm]")
    ball = re.search(r'<path d="M([-\d.]+),([-\d.]+)A([-\d.]+),[^"]*" fill="#0072b2"', svg)
    width, height = (float(v) for v in re.search(r'width="([\d.]+)" height="([\d.]+)"', svg).groups())
    x, y = float(ball[1]) - float(ball[3]) - width / 2, float(ball[2]) - height / 2
    scale = (min(width, height) - 8) / (2 * 1.18 * outer * 1.02)
    wanted = [pitch * scale * math.sin(math.radians(angle)), pitch * scale * math.cos(math.radians(angle))]
    s.check("ball 1 is drawn at its angle", abs(x - wanted[0]) < 0.5 and abs(y - wanted[1]) < 0.5, [x, y, wanted, angle])
    s.check("and not on the axis, where a mirror shows nothing", abs(wanted[0]) > 5, wanted)


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
    s.check("the simulated verdict replaces it", "work" in said, said)
    rows = s.js("document.querySelectorAll('[data-part=terms] tbody tr').length")
    s.check("with its margins", rows == 5, rows)
    terms = s.text("terms")
    s.check("each with its limit and unit", all(part in terms for part in ("Simulated", "≤ 5", "≥ 80", "≤ 25", "%")), terms)


def motion(s):
    # The last change of the text starts the motion anew a moment later.
    s.judged()
    s.js(f"{S}.stage.run(true)")
    s.tab.wait_for(f"{S}.motion.frames.length > 30")
    before = s.js(f"{S}.stage.now")
    s.tab.wait_for(f"{S}.stage.now > {before} + 2e-4")
    s.check("the balls move", True)
    s.press("play")
    held = s.js(f"{S}.stage.now")
    s.js("new Promise((done) => setTimeout(done, 200))")
    s.check("pause holds them", s.js(f"{S}.stage.now") == held)
    s.check("a frame is finite", s.js(f"Object.values({S}.stage.frame).flat().every(isFinite)"))
    grows = s.js(f"{S}.motion.frames.map((f) => f.t)")
    s.check("time grows across stretches", all(a < b for a, b in zip(grows, grows[1:])))
    ink = s.js(
        "[...document.querySelectorAll('.studio canvas')].filter((c) => c.clientWidth && c.checkVisibility()).map((c) => c.getContext('2d')"
        ".getImageData(0, 0, c.width, c.height).data.some((v) => v > 0))"
    )
    s.check("every canvas is drawn", all(ink) and len(ink) >= 4, ink)


def comparison(s):
    s.press("conventional")
    s.tab.wait_for("!!document.querySelector('[data-part=table] tbody')")
    table = s.text("table")
    s.check("the table of differences", "β0" in table and "conventional" in table, table[:80])
    s.check("a conventional ring is not judged", "not judged" in table, table[:200])
    s.tab.wait_for(f"!!{S}.comparison.starts")
    rows = s.js(f"{S}.comparison.startRows()")
    scatter = rows[0] if rows else []
    s.check("both run from the same uneven starts", len(rows) == 5 and all("±" in v for v in scatter[1:4]), rows)
    s.check("the raceway evens out the gaps", scatter and scatter[-1] == "better", rows)
    s.check("which the page says", "±" in s.text("table") and "same 8 starts" in s.text("starts"), s.text("starts"))
    s.tab.wait_for(f"{S}.motionA.frames.length > 0")
    s.check("A moves as well", True)
    s.press("pin")
    s.tab.wait_for("document.querySelector('[data-part=table]').textContent.includes('pinned')")
    s.press("unpin")
    s.check("unpinned", not s.text("table"))


def surface(s):
    """The surface is drawn when its part is opened, and turns by mouse and slider."""
    ink = f"(() => {{ const c = {S}.surface.canvas; return c.width && c.clientWidth ? c.toDataURL() : ''; }})()"
    s.js(f"{S}.surface.root.open = true; new Promise((done) => setTimeout(done, 100))")
    first = s.js(ink)
    s.js("(() => { const e = document.querySelector('[data-surface=turn]'); e.value = 20; e.dispatchEvent(new Event('input')); })()")
    turned = s.js(ink)
    s.check("the surface turns", len(first) > 5000 and turned != first, len(first))
    s.slide("theta", 20)
    s.check("the surface follows the case", s.js(ink) != turned)
    s.press("undo")
    s.settled()
    s.js(f"{S}.surface.root.open = false")


def shapes(s):
    """The shape and the blend of the raceway, and what they change."""
    s.tab.wait_for("document.querySelectorAll('[data-shape] option').length > 3")
    first, steepest = s.toml(), f"{S}.g.numbers.speed_change_max_per_rad"
    quartic = s.js(steepest)
    s.press("pin")
    s.js("(() => { const e = document.querySelector('[data-shape]'); e.value = 'steady'; e.dispatchEvent(new Event('change')); })()")
    s.settled()
    s.check("a shape is chosen", s.js(f"{S}.g.raceways[0].shape") == "steady" and 'shape = "steady"' in s.toml())
    s.check("the steady raceway changes the orbital speed least", s.js(steepest) < 0.9 * quartic, quartic)
    s.slide("blend", 1)
    s.check("its ends are blended", "blend_mm = 1" in s.toml())
    s.slide("depth", 10)
    s.check("the raceway is deep", "depth_um = 10" in s.toml() and s.js(f"{S}.g.document.raceway.depth_um") == 10)
    rows = s.js(f"{S}.comparison.rows()")
    s.check("shapes are compared", ["shape", "quartic", "steady"] in rows, rows)
    s.press("unpin")
    s.type(first)


def materials(s):
    """Materials by name, from the library, and back."""
    s.tab.wait_for("document.querySelectorAll('[data-material=balls] option').length > 2")
    first, stress = s.toml(), s.js(f"{S}.g.static.inner_pressure_max_mpa")
    names = s.js("[...document.querySelectorAll('[data-material=balls] option')].map((o) => o.value).filter((v) => v && v !== 'own')")
    s.check("the materials of the library are there", {"100Cr6", "M50", "440C", "X30CrMoN15-1", "Si3N4"} <= set(names), names)
    choose = "(() => {{ const e = document.querySelector('[data-material={0}]'); e.value = '{1}'; e.dispatchEvent(new Event('change')); }})()"
    for part, section in (("balls", "ball_material"), ("rings", "ring_material")):
        for name in ("Si3N4", "M50"):
            s.js(choose.format(part, name))
            s.settled()
            s.check(f"{part} of {name}", s.js(f"{S}.g.document.{section}.preset") == name and s.toml().count(f"[{section}]") == 1)
        s.js(choose.format(part, ""))
        s.settled()
        s.check(f"{part} as [material] again", f"[{section}]" not in s.toml())
    s.js(choose.format("balls", "Si3N4"))
    s.settled()
    s.check("ceramic balls raise the contact pressure", s.js(f"{S}.g.static.inner_pressure_max_mpa") > 1.05 * stress)
    s.type(first)


def files(s):
    """Every entry of the menu makes a file that begins as its format does."""
    made = s.js(
        "(async () => { const kept = window.cagelessSave, made = {}; let last = null; window.cagelessSave = (blob, name) => { last = { blob, name }; };"
        " for (const b of document.querySelectorAll('[data-saves]')) { last = null; b.click();"
        "  for (let k = 0; k < 1000 && (b.disabled || !last); k++) await new Promise((d) => setTimeout(d, 10));"
        "  if (!last) continue; const bytes = new Uint8Array(await last.blob.arrayBuffer()), text = new TextDecoder().decode(bytes.slice(0, 400));"
        "  made[b.dataset.saves] = { name: last.name, size: bytes.length, text, magic: [...bytes.slice(0, 8)] }; }"
        " window.cagelessSave = kept; return made; })()"
    )
    entries = s.js("[...document.querySelectorAll('[data-saves]')].map((b) => b.dataset.saves)")
    # In the plane there are no contact angles.
    wanted = {entry for entry in entries if not entry.startswith("contacts.")}
    s.check("every entry of the menu saves a file", set(made) == wanted and len(entries) >= 22, set(entries) ^ set(made))
    heads = {"gaps": "time_s,gap_1_deg,", "track": "angle_deg,effective_radius_mm,axial_mm", "terms": "criterion,kind,value,limit,margin",
             "map": "axial_span_mm,half_angle_deg,beta0_deg,margin_both_neighbours", "bearing": "time_s,ball,angle_deg", "depth": "angle_deg,axial_mm,depth_um"}  # fmt: skip
    for entry, file in made.items():
        thing, _, kind = entry.partition(".")
        begins = {
            "svg": file["text"].startswith("<svg xmlns") and file["size"] > 800,
            "png": file["magic"] == list(b"\x89PNG\r\n\x1a\n") and file["size"] > 3000,
            "gif": file["text"].startswith("GIF89a") and file["size"] > 20_000,
            "csv": file["text"].startswith(heads.get(thing, "?")) and file["text"].count("\n") >= 2,
            "toml": "[bearing]" in file["text"] and file["name"] == "case.toml",
        }[kind]
        s.check(f"{entry} begins as it should", begins, file)
    svg = s.js(f"(async () => (await {S}.saving.file({S}.saving.things[0], 'svg')).text())()")
    s.check("an SVG can be parsed", s.js(f"new DOMParser().parseFromString({json.dumps(svg)}, 'image/svg+xml').querySelector('parsererror') === null"))


def times(s):
    """Prints how long the page takes and how smoothly it moves. Nothing is asserted."""
    took = []
    for value in (24, 24.4, 24.8, 25.6, 26):
        s.slide("theta", value)
        took.append(float(s.js("document.querySelector('.studio').dataset.estimateMs")))
    s.judged()
    verdict, whole = (s.js(f"document.querySelector('.studio').dataset.{name}") for name in ("verdictMs", "mapMs"))
    # Frames that show another moment than the one before, and what the page does for each.
    rate, each, moments = s.js(
        f"(async () => {{ const {{ stage, motion }} = {S}, paint = stage.paint; stage.run(true); stage.slow = 100;"
        " let count = 0, busy = 0, last = null; const from = motion.frames.length;"
        " stage.paint = (part) => { const at = performance.now(); paint.call(stage, part); busy += performance.now() - at; if (stage.frame !== last) count++; last = stage.frame; };"
        " const began = performance.now(); await new Promise((done) => setTimeout(done, 2000));"
        " delete stage.paint; stage.slow = 500; return [count / (performance.now() - began) * 1000, busy / count, motion.frames.length - from]; })()"
    )
    for _ in took:
        s.press("undo")
        s.settled()
    print(f"{s.name}: slider to geometry and estimate {min(took):.0f} to {max(took):.0f} ms, verdict {verdict} ms,"
          f" map {whole} ms, {rate:.0f} frames a second, {each:.1f} ms of the page for each, while {moments:.0f} moments were computed")  # fmt: skip


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
        if s.name == "page":
            bad = axe(s.tab)
            s.check(f"{name}: no violation by axe-core", not bad, bad)
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


def quiet(s, served):
    urls = [e["request"]["url"] for e in s.tab.happened("Network.requestWillBeSent")]
    foreign = [u for u in urls if not u.startswith(("file:", "data:", "blob:", *served))]
    s.check("loads nothing from elsewhere", not foreign, foreign)
    said = [e["args"] for e in s.tab.happened("Runtime.consoleAPICalled") if e["type"] in ("error", "assert")]
    thrown = [thrown_text(e["exceptionDetails"]) for e in s.tab.happened("Runtime.exceptionThrown")]
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
    # Frames that nobody looks at take a core.
    s.js(f"{S}.stage.run(false)")
    limits(s)
    controls(s)
    messages(s)
    motion(s)
    drawn(s)
    verdict(s)
    impossible(s)
    comparison(s)
    # What a report or a server adds to the studio is its place, or another engine.
    if name == "page":
        surface(s)
        shapes(s)
        materials(s)
        files(s)
    if name in ("page", "server"):
        raceway_map(s)
        older(s)
        axes(s)
        times(s)
        drawings(s)
        space(s, screens)
        drop(s, screens)
        studies(s) if served else alone(s)
    links(s, browser)
    looks(s, screens)
    if served and s.js(f"!!{S}.engine.page"):
        agreement(s)
        same_drop(s)
    if name == "page":
        trap(s)
    quiet(s, served)


def stopping(browser, command):
    """A server of its own, which ends while its page is open."""
    server, address = serve(command, "cases/zhao-d.toml")
    try:
        s = StudioTab(browser.open(address), "stopping server")
        s.settled()
        if s.js(f"!!{S}.engine.page"):
            stop(s, server)
    finally:
        server.kill()
        server.wait()


def main():
    screens = Path(sys.argv[1])

    def look(argument):
        name, _, place = argument.partition("=")
        if name == "stopping":
            return name, lambda browser: stopping(browser, place)
        url = place if place.startswith("http") else Path(place).resolve().as_uri()
        return name, lambda browser: studio(browser, name, url, screens)

    return in_browsers(screens, map(look, sys.argv[2:]))


if __name__ == "__main__":
    sys.exit(main())
