"""Report pages in a real browser: they draw, load nothing, and their controls work.

    python pages.py folder/for/screenshots name=path/to/report.html …

Contrast and accessible names are judged by axe-core (MPL 2.0, used in tests alone), which the
package axe-core-python carries.
"""

import base64
import importlib.util
import json
import re
import sys
import time
from pathlib import Path

from browser import in_browsers, thrown_text
from checks import check

# Every axis that is seen, with its title: [figure, axis, title].
AXES = """
[...document.querySelectorAll(".plot")].flatMap((el) => {
  const full = el._fullLayout;
  const title = (axis) => axis.title && axis.title.text || "";
  const scenes = Object.keys(full).filter((k) => /^scene\\d*$/.test(k)).flatMap(
    (k) => ["x", "y", "z"].map((a) => [k + "." + a, full[k][a + "axis"]]));
  // A polar diagram has a heading of its name, where a title would lie across the numbers of its axis.
  const heading = (k) => ({ text: ((full.annotations || []).find((a) => a.name === k) || {}).text });
  const polar = Object.keys(full).filter((k) => /^polar\\d*$/.test(k))
    .map((k) => [k, { visible: true, title: heading(k) }]);
  const flat = Object.keys(full).filter((k) => /^[xy]axis\\d*$/.test(k)).map((k) => [k, full[k]]);
  // Of axes that go together, the outermost has the title; inner ones have no labels either.
  // Names along an axis need no title above them.
  return flat.concat(scenes, polar).filter(([, axis]) => axis.visible && axis.showticklabels !== false)
    .map(([name, axis]) => [el.id, name, axis.type === "category" ? "names" : title(axis)]);
})
"""


def plots(tab, name):
    count = tab.js("document.querySelectorAll('.plot').length")
    check(f"{name}: has figures", count > (0 if name.startswith(("static", "compare")) else 3), count)
    tab.js("window.cagelessDrawAll()")
    drawn = tab.js("document.querySelectorAll('.plot .main-svg, .plot canvas').length")
    check(f"{name}: figures are drawn", drawn >= count, drawn)
    failures = tab.js("[...document.querySelectorAll('.failed')].map((e) => e.textContent)")
    check(f"{name}: no figure failed", not failures, failures)
    empty = tab.js(
        "[...document.querySelectorAll('.plot')].filter((el) => !el.data || !el.data.length)"
        ".map((el) => el.id)"
    )
    check(f"{name}: every figure has data", not empty, empty)
    # Plotly's own placeholders count as no title.
    placeholder = re.compile(r"^$|^Click to enter|^[xyz]$|undefined|NaN")
    axes = tab.js(AXES)
    for figure in sorted({axis[0] for axis in axes}):
        bare = [a[1:] for a in axes if a[0] == figure and placeholder.search(a[2])]
        check(f"{name}: axes of {figure} have titles", not bare, bare)
    check(f"{name}: every figure has axes", len({a[0] for a in axes}) == count)
    ranges = tab.js(
        "[...document.querySelectorAll('.plot')].filter((el) => Object.entries(el._fullLayout)"
        ".some(([k, a]) => /^[xy]axis\\d*$/.test(k) && !a.range.every((v) => isFinite(a.r2l(v)))))"
        ".map((el) => el.id)"
    )
    check(f"{name}: ranges of axes are finite", not ranges, ranges)


def export(tab, name):
    """One flat plot as SVG and PNG, as the buttons below it do."""
    pick = "[...document.querySelectorAll('.plot')].find((el) => !el._fullLayout.scene && el.offsetParent)"
    url = tab.js(f"window.cagelessImage({pick}, 'svg')")
    check(f"{name}: SVG export", url.startswith("data:image/svg+xml") and "path" in url, url[:80])
    url = tab.js(f"window.cagelessImage({pick}, 'png')")
    data = base64.b64decode(url.partition("base64,")[2])
    check(f"{name}: PNG export", data[:8] == b"\x89PNG\r\n\x1a\n" and len(data) > 10_000, url[:80])
    width = int.from_bytes(data[16:20], "big")
    check(f"{name}: PNG has twice the size of the figure", width >= 1800, width)
    buttons = tab.js("document.querySelectorAll('button[data-save]').length")
    check(f"{name}: has buttons for it", buttons >= 2, buttons)


def motion(tab, name):
    """Play, pause and the slider of the moving bearing change the drawing."""
    count = tab.js("document.querySelectorAll('figure.motion').length")
    check(f"{name}: has a bearing in motion", count > 0, count)
    for k in range(count):
        figure, where = f"document.querySelectorAll('figure.motion')[{k}]", f"{name}: motion {k + 1}"
        tab.js(f"{figure}.scrollIntoView()")
        places = f"[...{figure}.querySelectorAll('[data-ball]')].map((e) => e.getAttribute('transform')).join()"
        clock = f"{figure}.querySelector('[data-clock]').textContent"
        press = f"{figure}.querySelector('[data-play]').click()"
        label = f"{figure}.querySelector('[data-play]').textContent"
        slide = (
            f"(() => {{ const s = {figure}.querySelector('[data-time]'); s.value = {{}};"
            " s.dispatchEvent(new Event('input')); })()"
        ).replace("{}", "VALUE")
        before, time_before = tab.js(places), tab.js(clock)
        check(f"{where}: has balls", before.count("translate") >= 3, before[:80])
        tab.js(press)
        check(f"{where}: plays", tab.js(label) == "Pause")
        tab.wait_for(f"{clock} !== {json.dumps(time_before)}")
        check(f"{where}: playing moves the balls", tab.js(places) != before)
        tab.js(press)
        paused = tab.js(places)
        time.sleep(0.3)
        check(f"{where}: pause holds them", tab.js(places) == paused and tab.js(label) == "Play")
        tab.js(slide.replace("VALUE", "0"))
        first = tab.js(places)
        tab.js(slide.replace("VALUE", "5000"))
        middle = tab.js(places)
        check(f"{where}: the slider moves the balls", first != middle)
        check(f"{where}: places are numbers", "NaN" not in first + middle)
        tab.js(slide.replace("VALUE", "0"))
        check(f"{where}: the slider goes back", tab.js(places) == first)
        stretch(tab, figure, where)
        film(tab, figure, where)


def stretch(tab, figure, where):
    """A stretch of the recorded time can be chosen, by a passage or by its ends."""
    ends = f"['from', 'until'].map((n) => Number({figure}.querySelector('[data-' + n + ']').value))"
    first = tab.js(ends)
    check(f"{where}: says which time it shows", first[1] > first[0], first)
    change = (
        f"(() => {{ const f = {figure}.querySelector('[data-from]'); f.value = {(first[0] + first[1]) / 2};"
        " f.dispatchEvent(new Event('change')); })()"
    )
    tab.js(change)
    check(f"{where}: takes a later begin", tab.js(ends)[0] > first[0], tab.js(ends))
    if tab.js(f"!!{figure}.querySelector('[data-part]')"):
        pick = (
            f"(() => {{ const p = {figure}.querySelector('[data-part]'); p.selectedIndex = 1;"
            " p.dispatchEvent(new Event('change')); })()"
        )
        tab.js(pick)
        passage = tab.js(ends)
        check(f"{where}: takes a passage", passage[1] - passage[0] < 0.5 * (first[1] - first[0]), passage)
    # A short stretch for the film.
    tab.js(
        f"(() => {{ const f = {figure}.querySelector('[data-until]');"
        f" f.value = Number({figure}.querySelector('[data-from]').value) + 0.004;"
        " f.dispatchEvent(new Event('change')); })()"
    )


def film(tab, figure, where):
    """The film of a stretch is an animated GIF that the browser can decode."""
    tab.js("window.films = []; window.cagelessSave = (blob, name) => window.films.push([blob, name])")
    tab.js(f"{figure}.querySelector('[data-film]').click()")
    tab.wait_for("window.films.length > 0")
    name, frames, differ, ink = tab.js(DECODED)
    check(f"{where}: saves a film", name.endswith(".gif") and 10 < frames <= 240, (name, frames))
    check(f"{where}: its frames show the motion", differ > 0.001, differ)
    check(f"{where}: it shows the drawing and no noise", 0.01 < ink < 0.25, ink)


# The film: its name, its frames, the share of the pixels that differ between the first and the
# last, and the share that is not light.
DECODED = """
(async () => {
  const [blob, name] = window.films[0];
  const decoder = new ImageDecoder({ data: await blob.arrayBuffer(), type: "image/gif" });
  await decoder.tracks.ready;
  const frames = decoder.tracks.selectedTrack.frameCount;
  const pixels = async (k) => {
    const { image } = await decoder.decode({ frameIndex: k });
    const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight), c = canvas.getContext("2d");
    c.drawImage(image, 0, 0);
    image.close();
    return c.getImageData(0, 0, canvas.width, canvas.height).data;
  };
  const first = await pixels(0), last = await pixels(frames - 1);
  let differ = 0, white = 0;
  for (let k = 0; k < first.length; k += 4) {
    if (Math.abs(first[k] - last[k]) > 40) differ++;
    if (last[k] > 200 && last[k + 1] > 200 && last[k + 2] > 200) white++;
  }
  const all = first.length / 4;
  // Paper, rings and balls are light; codes out of step would be noise.
  return [name, frames, differ / all, 1 - white / all];
})()
"""


# Screens on which a page is looked at: one page on all, the others, which are made of the same
# parts, on two that differ in everything.
SCREENS = {"run": [(1400, False), (1400, True), (420, False), (420, True)]}

# Most pixels of a page that has to be short.
HEIGHTS = {"sweep": 7000}

# Text of plots that stands out too little against the page: [figure, text, ratio].
FAINT = """
(() => {
  const channels = (c) => (c.match(/[\\d.]+/g) || []).map(Number);
  const light = (c) => { const [r, g, b] = c.slice(0, 3).map((v) => v / 255)
    .map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const paper = light(channels(getComputedStyle(document.body).backgroundColor));
  const found = [];
  document.querySelectorAll(".plot .main-svg text, .motion svg .label").forEach((el) => {
    if (el.closest(".hoverlayer, .heatmaplayer, .contourlabels, .textpoint, .modebar, .heatmap-label")) return;
    const style = getComputedStyle(el), fill = channels(style.fill);
    if (!el.textContent.trim() || fill.length < 3 || style.visibility === "hidden") return;
    const [a, b] = [light(fill), paper].sort((x, y) => y - x), ratio = (a + 0.05) / (b + 0.05);
    if (ratio < 4.5 && (fill[3] === undefined || fill[3] > 0))
      found.push([el.closest("figure").id, el.textContent.slice(0, 30), Math.round(ratio * 10) / 10]);
  });
  return found.slice(0, 6);
})()
"""

# Plots and drawings that are wider than their place, and words of them outside of it.
CUT = """
[...document.querySelectorAll(".plot")].filter((el) => el.offsetParent).flatMap((el) => {
  const place = el.getBoundingClientRect();
  const out = [...el.querySelectorAll(".main-svg text")].filter((t) => {
    const r = t.getBoundingClientRect();
    return r.width > 0 && !t.closest(".hoverlayer, .modebar, clipPath, .textpoint")
      && (r.left < place.left - 1 || r.right > place.right + 1 || r.bottom > place.bottom + 1);
  }).map((t) => t.textContent.slice(0, 40));
  const wide = place.right > document.documentElement.clientWidth + 1 ? ["wider than the page"] : [];
  return wide.concat(out).slice(0, 3).map((what) => [el.id, what]);
})
"""


# What the first screen lacks: the result, which is a verdict, key numbers or a lead, or much of a picture.
FIRST_SCREEN = """
(() => {
  window.scrollTo(0, 0);
  const share = (el) => {
    const r = el ? el.getBoundingClientRect() : { height: 0 };
    return r.height > 0 ? (Math.min(r.bottom, innerHeight) - r.top) / r.height : 0;
  };
  const result = document.querySelector("header .head") || document.querySelector("header .lead");
  const picture = document.querySelector(".opening .plot, .opening .motion > svg");
  return [["result", share(result), 1], ["picture", share(picture), 0.4]].filter(([, seen, least]) => seen < least);
})()
"""


def emulate(tab, width, dark):
    """A screen of `width` pixels, dark or light."""
    tab.call(
        "Emulation.setDeviceMetricsOverride",
        width=width, height=800 if width < 600 else 900, deviceScaleFactor=1, mobile=width < 600,
    )  # fmt: skip
    scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
    tab.call("Emulation.setEmulatedMedia", features=[scheme])
    # The page hears of the new screen a frame later.
    tab.js("new Promise((done) => setTimeout(() => requestAnimationFrame(done), 300))")


def axe(tab):
    """Violations that axe-core finds: rule and the first elements."""
    spec = importlib.util.find_spec("axe_core_python")
    if spec is None:
        sys.exit("axe-core-python is not installed: pip install -r tests/tools/requirements.txt")
    source = Path(spec.origin).with_name("axe.min.js").read_text(encoding="utf-8")
    tab.js(source + "; true")
    return tab.js(
        # Inside of a drawing, which has a role and a name, the marks mean nothing to a reader of
        # screens, and there are thousands: they are put aside meanwhile, as are scripts, which are megabytes. FAINT
        # judges the contrast of its text.
        "(() => { const drawings = [...document.querySelectorAll('.plot .main-svg, script')]"
        ".map((el) => [el, el.parentNode, el.nextSibling]);"
        " drawings.forEach(([el]) => el.remove());"
        " return axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'best-practice'], resultTypes: ['violations']})"
        ".finally(() => drawings.reverse().forEach(([el, parent, next]) => parent.insertBefore(el, next))); })()"
        ".then((r) => r.violations.map((v) => [v.id, v.nodes.length,"
        " v.nodes.slice(0, 2).map((n) => n.html.slice(0, 160))]))"
    )


def looks(tab, name, screens, width, dark):
    """The page on one kind of screen: contrast, names, nothing cut off."""
    where = f"{name}, {width} px, {'dark' if dark else 'light'}"
    emulate(tab, width, dark)
    tab.js("window.cagelessDrawAll()")
    if not name.startswith(("sweep", "sheet")):
        missing = tab.js(FIRST_SCREEN)
        check(f"{where}: the first screen has the result and a picture", not missing, missing)
    bad = axe(tab)
    check(f"{where}: no violation by axe-core", not bad, bad)
    faint = tab.js(FAINT)
    check(f"{where}: text of figures can be read", not faint, faint)
    cut = tab.js(CUT)
    check(f"{where}: no figure is cut off", not cut, cut)
    wide = tab.js("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    check(f"{where}: nothing sticks out to the right", wide <= 0, wide)
    height = min(tab.js("document.documentElement.scrollHeight"), 16_000)
    clip = {"x": 0, "y": 0, "width": width, "height": height, "scale": 0.5 if width > 600 else 0.7}
    path = screens / f"{name}-{width}-{'dark' if dark else 'light'}.png"
    tab.screenshot(path, clip=clip, captureBeyondViewport=True)


def names(tab, name):
    """Buttons say what they do and to what, figures what they show."""
    buttons = tab.js(
        "[...document.querySelectorAll('button[data-save]')].map((b) => b.getAttribute('aria-label'))"
    )
    check(f"{name}: names of buttons differ", len(set(buttons)) == len(buttons), buttons)
    labels = tab.js("[...document.querySelectorAll('.plot')].map((e) => [e.id, e.getAttribute('aria-label')])")
    bare = [label for label in labels if not re.search(r"\d", label[1]) or len(label[1]) < 30]
    check(f"{name}: descriptions of figures state what they show", not bare, bare)
    tree = tab.call("Accessibility.getFullAXTree")["nodes"]
    nameless = [
        node["role"]["value"]
        for node in tree
        if not node.get("ignored")
        and node.get("role", {}).get("value") in ("button", "link", "slider", "combobox", "spinbutton", "image")
        and not node.get("name", {}).get("value")
    ]
    check(f"{name}: every control and image has a name", not nameless, nameless[:5])


def page(browser, name, path, screens):
    if not path.is_file():
        raise RuntimeError(f"{path} is missing")
    tab = browser.open(path.resolve().as_uri())
    tab.js("document.querySelectorAll('details').forEach((part) => { part.open = true; })")
    plots(tab, name)
    names(tab, name)
    tab.js("document.querySelectorAll('details').forEach((part) => { part.open = false; })")
    export(tab, name)
    # A sweep has many bearings, an equilibrium none in motion.
    if not name.startswith(("sweep", "static")):
        motion(tab, name)
    text = tab.js("document.body.innerText")
    odd = re.findall(r".{0,40}\b(?:NaN|undefined|Infinity|inf)\b.{0,40}", text)
    check(f"{name}: no odd numbers in the text", not odd, odd[:3])
    for width, dark in SCREENS.get(name, [(1400, False), (420, True)]):
        looks(tab, name, screens, width, dark)
    emulate(tab, 1400, False)
    # The Pareto front of a search has more columns than fit.
    cut = tab.js(
        "[...document.querySelectorAll('.tab')].filter((f) => { const s = f.querySelector('.scroll');"
        " return s.scrollWidth > s.clientWidth; }).map((f) => f.id)"
    )
    cut = [table for table in cut if not table.startswith("pareto-front")]
    check(f"{name}: no table is cut at 1400 pixels", not cut, cut)
    stays = tab.js(
        "(() => { window.scrollTo(0, 2000); const r = document.querySelector('nav').getBoundingClientRect();"
        " window.scrollTo(0, 0); return r.top >= 0 && r.top < 100; })()"
    )
    check(f"{name}: the contents stay in view on a wide screen", stays)
    if name in HEIGHTS:
        height = tab.js("document.documentElement.scrollHeight")
        check(f"{name}: at most {HEIGHTS[name]} px high at 1400 px", height <= HEIGHTS[name], height)
    ticks = tab.js("document.querySelector('main').innerText.includes('`')")
    check(f"{name}: no backticks", not ticks)

    urls = [e["request"]["url"] for e in tab.happened("Network.requestWillBeSent")]
    loaded = [u for u in urls if not u.startswith(("file:", "data:", "blob:"))]
    check(f"{name}: loads nothing", not loaded, loaded)
    own = [u for u in urls if u.startswith("file:") and u != path.resolve().as_uri()]
    check(f"{name}: needs no file beside it", not own, own)
    said = [e["args"] for e in tab.happened("Runtime.consoleAPICalled") if e["type"] in ("error", "assert")]
    thrown = [thrown_text(e["exceptionDetails"]) for e in tab.happened("Runtime.exceptionThrown")]
    logged = [e["entry"]["text"] for e in tab.happened("Log.entryAdded") if e["entry"]["level"] == "error"]
    check(f"{name}: no errors on the console", not (said + thrown + logged), said + thrown + logged)


def sheet(browser, path, screens):
    """The sheet of a case is two pages of A4."""
    tab = browser.open(path.resolve().as_uri())
    names(tab, "sheet")
    for width, dark in [(1400, False), (420, True)]:
        looks(tab, "sheet", screens, width, dark)
    emulate(tab, 1400, False)
    pdf = base64.b64decode(tab.call("Page.printToPDF", preferCSSPageSize=True)["data"])
    count = len(re.findall(rb"/Type\s*/Page\b", pdf))
    check("sheet: two pages of A4", count == 2, count)


def main():
    screens = Path(sys.argv[1])

    def look(argument):
        name, path = argument.split("=", 1)
        if name == "sheet":
            return name, lambda browser: sheet(browser, Path(path), screens)
        return name, lambda browser: page(browser, name, Path(path), screens)

    return in_browsers(screens, map(look, sys.argv[2:]))


if __name__ == "__main__":
    sys.exit(main())
