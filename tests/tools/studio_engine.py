"""What the engines behind the studio compute, and what the page does where one fails."""

import json
import re
import signal
import subprocess
from pathlib import Path

from studio_tab import S

# A WebAssembly module with the functions of the engine, whose requests trap.
TRAP = [
    0, 97, 115, 109, 1, 0, 0, 0, 1, 17, 3, 96, 1, 127, 1, 127, 96, 2, 127, 127, 0, 96, 2, 127, 127, 1, 127,
    3, 4, 3, 0, 1, 2, 5, 3, 1, 0, 1, 7, 62, 4, 6, *b"memory", 2, 0, 14, *b"cageless_alloc", 0, 0,
    13, *b"cageless_free", 0, 1, 16, *b"cageless_request", 0, 2, 10, 13, 3, 4, 0, 65, 0, 11, 2, 0, 11, 3, 0, 0, 11,
]  # fmt: skip
# Waits for a study of the server to end.
IDLE = f"!{S}.studies.work"


def drop(s, screens):
    """A rotor is added, falls, meets the ring and spins it up; undo takes it out again."""
    before = s.toml()
    s.press("drop")
    s.settled()
    s.tab.wait_for(f"!!{S}.g.rotor")
    s.check("the case has a rotor and its support", "[rotor]" in s.toml() and "[support]" in s.toml())
    s.check("a rotor is possible", not s.text("message"), s.text("message"))
    s.check("its values are assumptions", "assumptions" in s.text("rotor"), s.text("rotor"))
    s.tab.wait_for("document.querySelector('[data-part=verdict]').textContent.includes('not judged')")
    s.tab.wait_for(f"{S}.motion.frames.length > 10")
    end = s.js(
        f"(async () => {{ const m = {S}.motion; {S}.stage.run(false);"
        " for (let k = 0; k < 400 && !(m.frames.at(-1).t > 7e-3); k++) { await m.more(); await new Promise((d) => setTimeout(d, 20)); }"
        f" {S}.stage.to(1); const f = {S}.stage.frame; return [f.t, f.rotor.speed_rpm, Math.max(...m.frames.map((x) => x.rotor.force_n[0])), f.ring_rad]; }})()"
    )
    s.check("the drop reaches 7 ms", end[0] >= 7e-3, end)
    s.check("the ring turns and the rotor slows down", end[1][1] > 10 and end[1][0] < 30_000 and end[3] > 0, end)
    s.check("the rotor hits the ring", end[2] > 500, end)
    said = re.search(r"first contact at ([\d.]+) ms", s.text("rotor"))
    s.check("the page says when it first touches", said and 6.2 < float(said[1]) < 6.7, s.text("rotor"))
    ink = s.js(
        "['rotor', 'history', 'loads'].map((n) => { const c = document.querySelector('[data-canvas=' + n + ']');"
        " return c.clientWidth > 0 && c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some((v) => v > 0); })"
    )
    s.check("rotor, speeds and loads are drawn", all(ink), ink)
    over = s.js("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    s.check("a drop sticks out nowhere", over <= 0, over)
    s.tab.screenshot(screens / f"studio-{s.name}-drop.png", captureBeyondViewport=True)
    s.press("undo")
    s.settled()
    s.check("undo takes the rotor out", s.toml() == before and s.js(f"{S}.g.rotor") is None)


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
  if (a && typeof a === "object") return Math.max(0, ...Object.keys(a).map((k) => difference(a[k], b[k], Math.abs(a[k.replace("_xy_", "_yy_").replace("_x_", "_y_")]) || 0)));
  return a === b ? 0 : Infinity;
})
"""
# Numbers of the end of a stretch, all digits: time, state, angles of the balls.
NUMBERS = """
((answer) => answer.resume.match(/.{{16}}/g).{}.map((hex) => {{
  const bits = new DataView(new ArrayBuffer(8));
  bits.setBigUint64(0, BigInt("0x" + hex));
  return bits.getFloat64(0);
}}))
"""
STATE = NUMBERS.format("slice(1)")
ANGLES = NUMBERS.format("slice(-answer.frames[0].angle_deg.length)")


def agreement(s):
    """The engine of the page and the native one give the same numbers."""
    own = s.toml()
    paper = own.replace('formulation = "physical"', 'formulation = "paper"')
    s.check("the case can be that of the paper", paper != own)
    cb74 = (Path(__file__).parents[2] / "cases/cb74.toml").read_text(encoding="utf-8")
    for name, toml in ((s.name, own), ("formulation paper", paper), ("CB74", cb74)):
        for what, request, of in (
            ("geometry and closed forms", "{ op: 'geometry' }", "((answer) => answer)"),
            ("static equilibrium", "{ op: 'static' }", "((answer) => answer)"),
            ("angles after 2 ms of motion", "{ op: 'motion', duration_s: 2e-3, frames: 10 }", ANGLES),
        ):
            off = s.js(
                f"(async () => {{ const [a, b] = await Promise.all([{S}.engine.page, {S}.engine.server].map((e) =>"
                f" e.request('agreement', {{ ...{request}, case: {json.dumps(toml)} }}).then({of})));"
                f" return ({DIFFERENCE})(a, b); }})()"
            )
            s.check(f"{name}, {what}: page and server agree", off is not None and off <= 1e-12, off)
            print(f"{name}, {what}: native against WebAssembly {off:.1e}")


def same_drop(s):
    """The state after 1 ms of a drop in SI units, numbers above 1 over their own size."""
    off = s.js(
        f"(async () => {{ const text = await {S}.drop.text(); const [a, b] = await Promise.all([{S}.engine.page, {S}.engine.server].map((e) =>"
        f" e.request('agreement', {{ op: 'motion', case: text, duration_s: 1e-3, frames: 2 }}).then({STATE})));"
        " return Math.max(...a.map((v, k) => Math.abs(v - b[k]) / Math.max(Math.abs(v), Math.abs(b[k]), 1))); })()"
    )
    s.check("state after 1 ms of a drop: page and server agree", off is not None and off <= 1e-12, off)
    print(f"state after 1 ms of a drop: native against WebAssembly {off:.1e}")


def study(s, name, value):
    s.js(f"(() => {{ document.querySelector('[data-study={name}]').value = {value}; }})()")


def studies(s):
    """Search with a small budget, its cancellation, tolerances, files of the ring."""
    first = s.toml()
    small = "\n[search]\naxial_span_mm = 5.1\nhalf_angle_deg = [24.0, 26.0]\nstarts = 1\n"
    s.type(first.rstrip("\n") + "\n" + small)
    study(s, "budget", 32)
    s.js("document.querySelector('[data-study=shapes]').click()")
    s.press("search")
    s.check("a search can be cancelled", s.js("document.querySelector('[data-cancel]').offsetParent !== null"))
    s.tab.wait_for(IDLE)
    rows = s.js("document.querySelectorAll('[data-take]').length")
    s.check("the search has a Pareto front", rows >= 1 and "Pareto front" in s.text("studies"), s.text("studies"))
    span = s.js("Number(document.querySelector('[data-part=study-result] tbody tr td:nth-child(3)').textContent)")
    shape = s.js("document.querySelector('[data-part=study-result] tbody tr td:nth-child(5)').textContent")
    s.press("take")
    s.settled()
    s.check("with its shape", s.js(f"{S}.g.raceways[0].shape") == shape and s.toml().count("shape =") == 1, shape)
    s.check("a click takes a structure into the case", abs(s.js(f"{S}.g.raceways[0].half_angle_deg") - span) < 0.006, span)
    s.type(first)
    study(s, "budget", 200)
    s.press("search")
    s.tab.wait_for(f"{S}.studies.bar.value > 0")
    s.press("cancel")
    s.tab.wait_for(IDLE)
    s.check("a cancelled search says so", s.text("studies") == "cancelled", s.text("studies"))
    s.type(re.sub(r"(?m)^method = .*$", 'method = "verlet"', re.sub(r"(?m)^step_us = .*$", 'step_us = "auto"', first)))
    for name, value in (("samples", 0), ("axial_span_um", 0), ("half_angle_deg", 0), ("friction", 0), ("clearance_um", 0),
                        ("speed_percent", 0), ("load_percent", 0), ("ball_grade", 0)):  # fmt: skip
        study(s, name, value)
    s.press("tolerance")
    s.tab.wait_for(IDLE)
    s.check("tolerances are judged", "work" in s.text("studies"), s.text("studies"))
    s.check("with a row for what deviates", "groove depth" in s.text("study-result"), s.text("study-result")[:80])
    study(s, "ball_grade", 4)
    s.press("tolerance")
    s.tab.wait_for(IDLE)
    s.check("a grade that is none is refused by name", "ball_grade 4" in s.text("studies"), s.text("studies"))
    s.js("document.querySelector('[data-export=step]').click()")
    s.tab.wait_for(IDLE)
    s.check("a ring without its outside is refused by name", "outer_ring_outer" in s.text("studies"), s.text("studies"))
    s.type(first.replace("[bearing]", "[bearing]\nouter_ring_outer_radius_mm = 31.0\nouter_ring_width_mm = 16.0", 1))
    files = s.js(
        "(async () => { const kept = window.cagelessSave, made = {}; window.cagelessSave = (blob, name) => { made[name] = blob; };"
        f" for (const f of ['step', 'csv', 'stl']) {{ document.querySelector('[data-export=' + f + ']').click();"
        f" while ({S}.studies.work) await new Promise((d) => setTimeout(d, 20)); }}"
        " window.cagelessSave = kept; const heads = {}; for (const [n, b] of Object.entries(made)) heads[n] = [b.size, (await b.text()).slice(0, 13)]; return heads; })()"
    )
    s.check("STEP, CSV and STL of the ring are saved", set(files) == {"outer_ring.step", "outer_ring.csv", "outer_ring.stl"}, files)
    s.check("the STEP is one", files["outer_ring.step"][1] == "ISO-10303-21;" and files["outer_ring.step"][0] > 20_000, files)
    s.type(first)


def alone(s):
    """A page without a server says what it lacks."""
    s.check("search needs the server", s.js("document.querySelector('[data-search]').disabled"))
    s.check("the page says which command has it", "cageless studio" in s.text("studies"), s.text("studies"))


def trap(s):
    """The engine fails in the middle: the page says so and goes on with a new one."""
    s.js(
        f"(async () => {{ const page = {S}.engine.page, lane = page.lane('quick');"
        f" lane.worker.postMessage({{ module: await WebAssembly.compile(new Uint8Array({json.dumps(TRAP)})) }}); }})()"
    )
    span = s.js(f"{S}.g.raceways[0].axial_span_mm")
    s.write("span", span - 0.01)
    s.tab.wait_for("document.querySelector('[data-part=message]').textContent.includes('engine failed')")
    s.check("a trap of the engine is said", "unreachable" in s.text("message"), s.text("message"))
    s.write("span", span)
    s.check("the page goes on with a new engine", not s.text("message") and s.js(f"{S}.g.raceways[0].axial_span_mm") == span)


def serve(command, case):
    """A server and its address."""
    server = subprocess.Popen([command, "studio", case, "--no-browser"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return server, server.stdout.readline().strip()


def stop(s, server):
    """The server ends during a search: the page says so and computes by itself."""
    s.press("search")
    s.tab.wait_for(f"{S}.studies.bar.value > 0")
    server.send_signal(signal.SIGINT)
    s.check("the server ends in good order", server.wait(timeout=30) == 0)
    s.tab.wait_for(IDLE)
    s.check("the search says that the server has ended", "has ended" in s.text("studies"), s.text("studies"))
    span = s.js(f"{S}.g.raceways[0].axial_span_mm")
    s.write("span", span - 0.01)
    s.check("the page says that it goes on", "continues on its own" in s.text("host"), s.text("host"))
    s.tab.wait_for("document.querySelector('[data-search]').disabled")
    alone(s)
    s.check("and goes on", abs(s.js(f"{S}.g.raceways[0].axial_span_mm") - span + 0.01) < 1e-9)
    s.tab.wait_for(f"{S}.motion.frames.length > 10")
    s.check("with a motion of its own", not s.text("message"), s.text("message"))
