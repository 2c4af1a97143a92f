"""Report pages in a real browser: they draw, load nothing, and their controls work.

    python pages.py folder/for/screenshots name=path/to/report.html …

Talks to Chromium through its debugging pipe; needs nothing but Python itself.
"""

import base64
import json
import os
import re
import select
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from checks import check, exit_code

FLAGS = [
    "--headless", "--no-sandbox", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-extensions", "--disable-dev-shm-usage", "--hide-scrollbars",
    # WebGL without a graphics card, for figures in three dimensions.
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--window-size=1280,900", "--remote-debugging-pipe",
]  # fmt: skip
BROWSERS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]
PATIENCE_S = 180


class Browser:
    """One headless Chromium."""

    def __init__(self, profile):
        read_commands, self.to_browser = os.pipe()
        self.from_browser, write_answers = os.pipe()
        command = [find_browser(), *FLAGS, f"--user-data-dir={profile}", "about:blank"]
        # Chromium reads commands from descriptor 3 and answers on 4.
        redirect = f'exec "$@" 3<&{read_commands} 4>&{write_answers}'
        self.process = subprocess.Popen(
            ["bash", "-c", redirect, "bash", *command],
            pass_fds=(read_commands, write_answers),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(read_commands)
        os.close(write_answers)
        self.buffer, self.last, self.events = b"", 0, []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)

    def message(self, deadline):
        """The next message of the browser; None if there is none in time."""
        while b"\0" not in self.buffer:
            wait = deadline - time.monotonic()
            if wait <= 0 or not select.select([self.from_browser], [], [], wait)[0]:
                return None
            piece = os.read(self.from_browser, 1 << 20)
            if not piece:
                raise RuntimeError("the browser has gone")
            self.buffer += piece
        text, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(text)

    def call(self, method, session=None, **params):
        self.last += 1
        command = {"id": self.last, "method": method, "params": params}
        if session:
            command["sessionId"] = session
        data = json.dumps(command).encode() + b"\0"
        while data:
            data = data[os.write(self.to_browser, data) :]
        deadline = time.monotonic() + PATIENCE_S
        while (message := self.message(deadline)) is not None:
            if message.get("id") == self.last:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            if "method" in message:
                self.events.append(message)
        raise RuntimeError(f"{method}: no answer")

    def open(self, url):
        """Opens a page in a tab of its own."""
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        tab = Tab(self, session)
        for domain in ("Page", "Runtime", "Network", "Log"):
            tab.call(f"{domain}.enable")
        tab.call("Page.navigate", url=url)
        tab.wait_for("document.readyState === 'complete' && location.href !== 'about:blank'")
        return tab


class Tab:
    def __init__(self, browser, session):
        self.browser, self.session = browser, session

    def call(self, method, **params):
        return self.browser.call(method, self.session, **params)

    def js(self, expression):
        """Value of an expression, of a promise when it is fulfilled."""
        answer = self.call(
            "Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True
        )
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise RuntimeError(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def wait_for(self, condition):
        deadline = time.monotonic() + PATIENCE_S
        while not self.js(condition):
            if time.monotonic() > deadline:
                raise RuntimeError(f"never came true: {condition}")
            time.sleep(0.05)

    def happened(self, *methods):
        return [
            e["params"]
            for e in self.browser.events
            if e.get("sessionId") == self.session and e["method"] in methods
        ]

    def screenshot(self, path, **how):
        data = self.call("Page.captureScreenshot", format="png", **how)["data"]
        path.write_bytes(base64.b64decode(data))


def find_browser():
    for name in BROWSERS:
        for folder in os.environ["PATH"].split(os.pathsep):
            if os.access(os.path.join(folder, name), os.X_OK):
                return os.path.join(folder, name)
    sys.exit("no Chromium found")


# Every axis that is seen, with its title: [figure, axis, title].
AXES = """
[...document.querySelectorAll(".plot")].flatMap((el) => {
  const full = el._fullLayout;
  const title = (axis) => axis.title && axis.title.text || "";
  const scenes = Object.keys(full).filter((k) => /^scene\\d*$/.test(k)).flatMap(
    (k) => ["x", "y", "z"].map((a) => [k + "." + a, full[k][a + "axis"]]));
  const flat = Object.keys(full).filter((k) => /^[xy]axis\\d*$/.test(k)).map((k) => [k, full[k]]);
  // Of axes that go together, the outermost has the title; inner ones have no labels either.
  // Names along an axis need no title above them.
  return flat.concat(scenes).filter(([, axis]) => axis.visible && axis.showticklabels !== false)
    .map(([name, axis]) => [el.id, name, axis.type === "category" ? "names" : title(axis)]);
})
"""


def plots(tab, name):
    count = tab.js("document.querySelectorAll('.plot').length")
    check(f"{name}: has figures", count > 3, count)
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
    pick = "[...document.querySelectorAll('.plot')].find((el) => !el._fullLayout.scene)"
    url = tab.js(f"Plotly.toImage({pick}, {{format: 'svg', width: 900, height: 500}})")
    check(f"{name}: SVG export", url.startswith("data:image/svg+xml") and "path" in url, url[:80])
    url = tab.js(f"Plotly.toImage({pick}, {{format: 'png', width: 900, height: 500, scale: 2}})")
    data = base64.b64decode(url.partition("base64,")[2])
    check(f"{name}: PNG export", data[:8] == b"\x89PNG\r\n\x1a\n" and len(data) > 10_000, url[:80])
    width = int.from_bytes(data[16:20], "big")
    check(f"{name}: PNG has the size asked for", width == 1800, width)
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


def page(browser, name, path, screens):
    if not path.is_file():
        raise RuntimeError(f"{path} is missing")
    tab = browser.open(path.resolve().as_uri())
    plots(tab, name)
    export(tab, name)
    # A sweep has many bearings, none of them in motion.
    if name != "sweep":
        motion(tab, name)
    text = tab.js("document.body.innerText")
    odd = re.findall(r".{0,40}\b(?:NaN|undefined|Infinity|inf)\b.{0,40}", text)
    check(f"{name}: no odd numbers in the text", not odd, odd[:3])
    tab.js("window.scrollTo(0, 0)")
    tab.screenshot(screens / f"{name}.png")
    height = min(tab.js("document.documentElement.scrollHeight"), 16_000)
    clip = {"x": 0, "y": 0, "width": 1280, "height": height, "scale": 0.5}
    tab.screenshot(screens / f"{name}-whole.png", clip=clip, captureBeyondViewport=True)
    wide = tab.js("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    check(f"{name}: nothing sticks out to the right", wide <= 0, wide)

    # A window of 1400 pixels, of which the page takes 1100. The Pareto front of a search has
    # more columns than fit.
    tab.call(
        "Emulation.setDeviceMetricsOverride", width=1400, height=900, deviceScaleFactor=1, mobile=False
    )
    cut = tab.js(
        "[...document.querySelectorAll('.tab')].filter((f) => { const s = f.querySelector('.scroll');"
        " return s.scrollWidth > s.clientWidth; }).map((f) => f.id)"
    )
    cut = [table for table in cut if not table.startswith("pareto-front")]
    check(f"{name}: no table is cut at 1400 pixels", not cut, cut)
    ticks = tab.js("document.querySelector('main').innerText.includes('`')")
    check(f"{name}: no backticks", not ticks)

    urls = [e["request"]["url"] for e in tab.happened("Network.requestWillBeSent")]
    loaded = [u for u in urls if not u.startswith(("file:", "data:", "blob:"))]
    check(f"{name}: loads nothing", not loaded, loaded)
    own = [u for u in urls if u.startswith("file:") and u != path.resolve().as_uri()]
    check(f"{name}: needs no file beside it", not own, own)
    said = [e["args"] for e in tab.happened("Runtime.consoleAPICalled") if e["type"] in ("error", "assert")]
    thrown = [e["exceptionDetails"]["text"] for e in tab.happened("Runtime.exceptionThrown")]
    logged = [e["entry"]["text"] for e in tab.happened("Log.entryAdded") if e["entry"]["level"] == "error"]
    check(f"{name}: no errors on the console", not (said + thrown + logged), said + thrown + logged)


def main():
    screens = Path(sys.argv[1])
    screens.mkdir(parents=True, exist_ok=True)
    pages = [argument.split("=", 1) for argument in sys.argv[2:]]
    with tempfile.TemporaryDirectory(dir=screens, ignore_cleanup_errors=True) as profile:
        with Browser(profile) as browser:
            for name, path in pages:
                try:
                    page(browser, name, Path(path), screens)
                except RuntimeError as error:
                    check(f"{name}: opens", False, error)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
