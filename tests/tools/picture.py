"""The pictures of README and docs, with the numbers of their captions.

    python picture.py path/to/cageless folder          draws them in the folder, compares both with what is stored
    python picture.py path/to/cageless folder write    stores both

Runs a conventional bearing and one with a discrete raceway from the same bunch of balls, draws
both at the end of their runs with their gaps: `motion.png`. Opens the studio of the latter, waits for its
verdict and its map: `studio.webp`. Runs an example of the Python package and takes two of its figures. Numbers
are those of `docs/results/pictures.json`, which `docs/studies/readme.py` holds against the captions, with a checksum of
each picture in `docs/images`. A picture that was not stored with these numbers is refused, and one that differs from what
the program draws now.
"""

import base64
import hashlib
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from browser import Browser
from checks import check, exit_code
from studies import RESULTS, ROOT, rounded

IMAGES = ROOT / "docs" / "images"
EXAMPLE = ROOT / "crates/cageless-py/examples/raceway_sweep.py"
# Figures of the example, with the size of their pictures.
FIGURES = {"shares": (900, 300), "effects": (900, 335)}
PICTURES = ["motion.png", "studio.webp", *(f"python-{name}.png" for name in FIGURES)]
# Share of the pixels that may differ clearly between two drawings, by other fonts.
OTHER_FONTS = 0.03

CASES = {"conventional": "conventional.toml", "discrete": "zhao-d.toml"}
TITLES = {
    "conventional": "Conventional outer ring",
    "discrete": "Discrete raceway, <i>l</i><sub>C</sub> 5.1 mm, <i>θ</i> 25.2°",
}
DURATION_S = 1.0
# Gap between the balls of the bunch at the start.
BUNCHED_DEG = 0.1
# End of the scale of the bars; a taller one is cut and has its value beside it.
SCALE_DEG = 5.0
SETTINGS = [f"solver.duration_s={DURATION_S}", "solver.method=verlet", "solver.step_us=auto"]


def room_deg(bearing):
    """360° less the angles of all balls in contact."""
    pitch = (bearing["inner_groove_bottom_radius_mm"] + bearing["outer_groove_bottom_radius_mm"]) / 2
    return 360 - bearing["balls"] * 2 * math.degrees(math.asin(bearing["ball_radius_mm"] / pitch))


class Bearing:
    """One run and what the picture says of it."""

    def __init__(self, cageless, name, folder):
        case, self.name, self.folder = ROOT / "cases" / CASES[name], name, folder / name
        checked = subprocess.run(
            [cageless, "check", case, "--json"], check=True, capture_output=True, text=True
        )
        self.case = json.loads(checked.stdout)["case"]
        balls, room = self.case["bearing"]["balls"], room_deg(self.case["bearing"])
        bunch = [BUNCHED_DEG] * (balls - 1)
        sets = [*SETTINGS, f"start.gaps={[*bunch, round(room - sum(bunch), 9)]}"]
        options = [part for text in sets for part in ("--set", text)]
        run = subprocess.run(
            [cageless, "run", case, "--out", self.folder, "--json", *options],
            check=True, capture_output=True, text=True,
        )  # fmt: skip
        self.summary = json.loads(run.stdout)
        data = json.loads((self.folder / "report.json").read_text())
        self.uniform = room / balls
        gaps = [ball["gap_deg"] for ball in data["balls"]]
        self.gaps = [of_ball[-1] for of_ball in gaps]
        late = [k for k, time in enumerate(data["time_s"]) if time >= DURATION_S / 2]
        self.deviation = statistics.fmean(
            statistics.pstdev(of_ball[k] for of_ball in gaps) for k in late
        )
        self.deviation_at_end = statistics.pstdev(self.gaps)
        self.contacts = self.summary["collisions"]
        self.transient = self.summary["settled_after_s"]

    def drawing(self, browser):
        """The bearing of the report page at the end of the run, as SVG."""
        tab = browser.open((self.folder / "report.html").resolve().as_uri())
        return tab.js(
            "(() => { const f = document.querySelector('figure.motion');"
            " const s = f.querySelector('[data-time]'); s.value = s.max;"
            " s.dispatchEvent(new Event('input'));"
            " const svg = f.querySelector('svg'); svg.setAttribute('width', 620);"
            " return svg.outerHTML; })()"
        )

    def bars(self):
        """The gaps of all pairs as bars, the nominal gap as a line."""
        width, height, tall = 560, 110, 80
        slot, per_degree = width / len(self.gaps), tall / SCALE_DEG
        parts = []
        for k, gap in enumerate(self.gaps):
            size = min(max(gap, 0), SCALE_DEG) * per_degree
            parts.append(
                f'<rect x="{slot * (k + 0.15):.1f}" y="{tall - size:.1f}" width="{0.7 * slot:.1f}"'
                f' height="{size:.1f}" fill="#0072b2"/>'
                f'<text x="{slot * (k + 0.5):.1f}" y="{height - 14}" text-anchor="middle">{k + 1}</text>'
            )
            if gap > SCALE_DEG:
                parts.append(
                    f'<text x="{slot * (k + 0.1):.1f}" y="12" text-anchor="end">{gap:.1f}°</text>'
                )
        line = tall - self.uniform * per_degree
        parts.append(
            f'<path d="M0,{line:.1f}H{width}" stroke="#d55e00" stroke-dasharray="5 4"/>'
            f'<path d="M0,{tall}H{width}" stroke="#555"/>'
        )
        return (
            f'<svg width="620" viewBox="-30 -22 620 {height + 24}" font-size="13" fill="#333">'
            f'<text y="-8">gap from each ball to the next; dashed: nominal, {self.uniform:.1f}°;'
            f" standard deviation {self.deviation_at_end:.1f}°</text>{''.join(parts)}</svg>"
        )


def numbers(bearings):
    """The numbers of the caption of the picture."""
    plain, discrete = bearings["conventional"], bearings["discrete"]
    return {
        "nominal_gap_deg": plain.uniform,
        "gap_deviation_deg": {"discrete": discrete.deviation, "conventional": plain.deviation},
        "settled_after_s": discrete.transient,
        "contacts": {"discrete": discrete.contacts, "conventional": plain.contacts},
    }


STUDIO = "window.cagelessStudio"
STUDIO_SIZE = (1280, 850)


def studio_picture(cageless, browser, folder):
    """Writes `studio.webp`; the numbers of its caption."""
    page = folder / "studio.html"
    subprocess.run([cageless, "studio", ROOT / "cases" / CASES["discrete"], "--page", page], check=True)
    tab = browser.open(page.resolve().as_uri())
    width, height = STUDIO_SIZE
    tab.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
    tab.wait_for(
        f"!!{STUDIO} && {STUDIO}.map.grids.length === 2 && !!{STUDIO}.judged && {STUDIO}.motion.last > 5e-3"
    )
    # A moment that is the same in every picture.
    tab.js(f"{STUDIO}.stage.run(false); {STUDIO}.stage.now = 5e-3; {STUDIO}.stage.paint()")
    shot = tab.call("Page.captureScreenshot", format="webp", quality=85)
    (folder / "studio.webp").write_bytes(base64.b64decode(shot["data"]))
    headline, beta0 = tab.js(f"[{STUDIO}.judged.headline, {STUDIO}.g.numbers.beta0_deg]")
    return {"headline": headline, "beta0_deg": beta0}


def motion_picture(browser, bearings, folder):
    """Writes `motion.png`."""
    columns = "".join(
        f"<div><h2>{TITLES[name]}</h2>{bearing.drawing(browser)}{bearing.bars()}</div>"
        for name, bearing in bearings.items()
    )
    page = folder / "picture.html"
    page.write_text(
        "<!DOCTYPE html><meta charset='utf-8'><style>body{margin:0;display:flex;"
        "font-family:DejaVu Sans,Helvetica,Arial,sans-serif;background:#fff;color:#222}"
        "div{width:630px;text-align:center}h2{font-size:17px;margin:14px 0 0}"
        "svg{display:block;margin:0 auto}h2+svg{margin-top:-50px}"
        f"h2{{height:22px;line-height:22px;position:relative;z-index:1}}sub{{line-height:0}}</style>{columns}",
        encoding="utf-8",
    )
    tab = browser.open(page.resolve().as_uri())
    height = tab.js("Math.ceil(document.body.getBoundingClientRect().height)")
    clip = {"x": 0, "y": 0, "width": 1260, "height": height + 8, "scale": 1}
    tab.screenshot(folder / "motion.png", clip=clip, captureBeyondViewport=True)


def python_pictures(browser, folder):
    """Writes the pictures of figures of the Python package."""
    done = subprocess.run([sys.executable, EXAMPLE], cwd=folder, capture_output=True, text=True)
    check(f"picture: {EXAMPLE.name} runs", done.returncode == 0, done.stderr)
    for name, (width, height) in FIGURES.items():
        tab = browser.open((folder / f"{name}.html").resolve().as_uri())
        tab.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        tab.wait_for("!!document.querySelector('.main-svg')")
        tab.js(
            "(async () => { const f = document.querySelector('.plotly-graph-div'); document.body.style.margin = 0;"
            " document.head.insertAdjacentHTML('beforeend', '<style>.modebar { display: none }</style>');"
            f" await Plotly.relayout(f, {{ width: {width}, height: {height}, autosize: false }});"
            " await document.fonts.ready; })()"
        )
        tab.screenshot(folder / f"python-{name}.png", clip={"x": 0, "y": 0, "width": width, "height": height, "scale": 1})


# Share of the pixels that differ clearly; 1 for pictures of different sizes.
DIFFERENCE = """
(async ([a, b]) => {
  const pixels = async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const canvas = new OffscreenCanvas(image.width, image.height), c = canvas.getContext("2d");
    c.drawImage(image, 0, 0);
    return c.getImageData(0, 0, image.width, image.height);
  };
  const [one, other] = [await pixels(a), await pixels(b)];
  if (one.width !== other.width || one.height !== other.height) return 1;
  let differ = 0;
  for (let k = 0; k < one.data.length; k += 4) {
    const far = (n) => Math.abs(one.data[k + n] - other.data[k + n]) > 48;
    differ += far(0) || far(1) || far(2);
  }
  return differ / (one.data.length / 4);
})"""


def checksum(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def compare_pictures(browser, folder, stored):
    """Compares stored pictures with their checksums and with what was drawn into the folder."""
    tab = browser.open((folder / "picture.html").resolve().as_uri())
    for name in PICTURES:
        check(f"picture: {name} was stored with its numbers", checksum(IMAGES / name) == stored.get(name))
        both = [base64.b64encode((at / name).read_bytes()).decode() for at in (IMAGES, folder)]
        differ = tab.js(f"{DIFFERENCE}({json.dumps(both)})")
        print(f"{name}: {100 * differ:.2f} % of the pixels differ", flush=True)
        check(f"picture: {name} is what the program draws", differ < OTHER_FONTS, f"{100 * differ:.1f} % of it differ")


def main():
    cageless, folder, write = sys.argv[1], Path(sys.argv[2]), "write" in sys.argv[3:]
    folder.mkdir(parents=True, exist_ok=True)
    bearings = {name: Bearing(cageless, name, folder) for name in CASES}
    results = RESULTS / "pictures.json"
    with tempfile.TemporaryDirectory(dir=folder, ignore_cleanup_errors=True) as profile:
        with Browser(profile) as browser:
            motion_picture(browser, bearings, folder)
            found = rounded(numbers(bearings) | studio_picture(cageless, browser, folder), 6)
            python_pictures(browser, folder)
            plain, discrete = bearings["conventional"], bearings["discrete"]
            check("picture: the discrete raceway has spread the balls at the instant that is drawn",
                  discrete.deviation_at_end < plain.deviation_at_end / 3,
                  (discrete.deviation_at_end, plain.deviation_at_end))  # fmt: skip
            touching = [sum(gap <= 0 for gap in b.gaps) for b in (plain, discrete)]
            check("picture: no more pairs touch with it than without", touching[1] <= touching[0], touching)
            size = (folder / "studio.webp").stat().st_size
            check("picture: that of the studio is small", size < 150_000, size)
            if write:
                for name in PICTURES:
                    shutil.copy(folder / name, IMAGES / name)
                document = found | {"files": {name: checksum(IMAGES / name) for name in PICTURES}}
                text = json.dumps(document, ensure_ascii=False, indent=2) + "\n"
                part = results.with_suffix(".part")
                part.write_text(text, encoding="utf-8")
                os.replace(part, results)
            stored = json.loads(results.read_text(encoding="utf-8"))
            compare_pictures(browser, folder, stored.pop("files", {}))
    check("picture: the numbers are those of docs/results", found == stored, (found, stored))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
