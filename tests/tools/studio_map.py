"""The map of the studio: its axes, its point, moved by mouse, touch and keys, and its age."""

from studio_tab import S

OWN = f"(() => {{ const r = {S}.g.raceways[0]; return [r.axial_span_mm, r.half_angle_deg]; }})()"


def pointer(s):
    """Place of the point of the map in the window, and pixels per mm and per degree."""
    s.js("document.querySelector('[data-point]').scrollIntoView({ block: 'center', behavior: 'instant' })")
    # A map that has just changed its size is drawn anew with the next frame.
    s.tab.wait_for(f"{S}.map.canvas.width === Math.round({S}.map.canvas.clientWidth * devicePixelRatio)")
    return s.js(
        f"(() => {{ const r = document.querySelector('[data-point]').getBoundingClientRect(), m = {S}.map;"
        " return { x: r.x + r.width / 2, y: r.y + r.height / 2, mm: m.plane.wide / (m.box[1] - m.box[0]),"
        " degree: m.plane.high / (m.box[3] - m.box[2]) }; })()"
    )


def drag(s, dx, dy, touch):
    """Moves the point by pixels, in four steps."""
    at = pointer(s)
    path = [(at["x"] + dx * k / 4, at["y"] + dy * k / 4) for k in range(5)]
    if touch:
        for kind, (x, y) in zip(["touchStart"] + ["touchMove"] * 4, path):
            s.tab.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y}])
        s.tab.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    else:
        for kind, (x, y) in zip(["mousePressed"] + ["mouseMoved"] * 4 + ["mouseReleased"], [*path, path[-1]]):
            s.tab.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)
    # The browser passes on the last move with its next frame.
    s.js("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 100))))")
    s.settled()
    return at


def key(s, name):
    for kind in ("keyDown", "keyUp"):
        s.tab.call("Input.dispatchKeyEvent", type=kind, key=name, code=name)


def raceway_map(s):
    """The present raceway is a point of the map that mouse, touch and arrow keys move."""
    # The map of the case as it is now, not that of a case that was there before.
    s.tab.wait_for(f"{S}.map.current({S}.toml) && !{S}.map.root.classList.contains('stale') && {S}.map.grids.length === 2")
    first, before = s.toml(), s.js(OWN)
    there = s.js(
        f"(() => {{ const c = {S}.map.canvas.getBoundingClientRect(), r = document.querySelector('[data-point]').getBoundingClientRect();"
        f" return {S}.map.value({{ clientX: r.x + r.width / 2, clientY: r.y + r.height / 2 }}); }})()"
    )
    s.check("the point of the map is at the case", all(abs(a - b) < 1e-3 * b for a, b in zip(there, before)), [there, before])
    s.check("the case passes in the map as in its estimate", s.js(f"{S}.map.region(...{OWN})") == "pass")
    s.check("the map has a feasible band and an impossible region", s.js(f"{S}.map.region(0.99 * {S}.map.box[1], 20)") == "impossible")
    for way, touch in (("mouse", False), ("touch", True)):
        at = drag(s, -20, 30, touch)
        wanted = [before[0] - 20 / at["mm"], before[1] - 30 / at["degree"]]
        found = s.js(OWN)
        s.check(f"{way} drags the point", all(abs(a - b) < 0.02 * b for a, b in zip(found, wanted)), [found, wanted])
        s.press("undo")
        s.settled()
        s.check(f"one drag by {way} is one step of undo", s.toml() == first)
    drag(s, 2000, 0, False)
    span, limit = s.js(OWN)[0], s.js(f"{S}.g.numbers.axial_span_limit_mm")
    s.check("the point stops at what is impossible", before[0] < span < limit and not s.text("message"), [span, s.text("message")])
    s.press("undo")
    s.settled()
    s.js("document.querySelector('[data-point]').focus()")
    key(s, "ArrowRight")
    key(s, "ArrowUp")
    s.settled()
    found = s.js(OWN)
    s.check("arrow keys move the point", abs(found[0] - before[0] - 0.02) < 1e-6 and abs(found[1] - before[1] - 0.1) < 1e-6, found)
    said = s.js("document.querySelector('[data-point]').getAttribute('aria-valuetext')")
    s.check("and it says its place", f"{found[0]:.2f} mm" in said and "β0" in said, said)
    s.press("undo")
    s.settled()
    s.check("keys in quick succession are one step of undo", s.toml() == first)
    # A map of another bearing replaces the one under way.
    cancelled = s.js(
        f"(async () => {{ const m = {S}.map, other = {S}.toml.replace('balls = 14', 'balls = 13');"
        " const going = m.compute(other), signal = m.abort.signal; m.cancel(); await going;"
        f" const kept = m.grids.length; await m.compute({S}.toml); return [signal.aborted, kept, m.grids.length, m.computed === m.apart({S}.toml)]; }})()"
    )
    s.check("a map can be cancelled and computed again", cancelled == [True, 2, 2, True], cancelled)


def older(s):
    """A map that is older than the controls says so, and judges nothing, until it is computed anew."""
    s.tab.wait_for(f"{S}.map.current({S}.toml) && !{S}.map.root.classList.contains('stale')")
    shown = "document.querySelector('[data-part=map-old]').checkVisibility()"
    s.check("a map of the case is not called old", not s.js(shown) and "estimate" in s.text("map"), s.text("map"))
    s.write("load", s.js(f"{S}.g.document.operation.radial_load_n") * 1.2)
    s.check("after a change of the load the map says that it is old", s.js(shown))
    s.check("and does not judge", "estimate" not in s.text("map"), s.text("map"))
    s.judged()
    s.tab.wait_for(f"{S}.map.current({S}.toml) && !{S}.map.root.classList.contains('stale')")
    s.check("the new map is not old", not s.js(shown))
    s.press("undo")
    s.settled()
    s.judged()


def axes(s):
    """Any two controls of the raceway span the map, its point and what is saved of it."""
    fresh = f"{S}.map.current({S}.toml) && !{S}.map.root.classList.contains('stale') && {S}.map.grids.length > 0"
    choose = "(() => {{ const e = document.querySelector('[data-axis=\"{}\"]'); e.value = '{}'; e.dispatchEvent(new Event('change')); }})()"
    saved = f"{S}.saving.things.find((t) => t.id === 'map').csv()"
    s.tab.wait_for(fresh)
    first, before = s.toml(), s.js(saved).splitlines()[0]
    offered = s.js("[...document.querySelectorAll('[data-axis=\"1\"] option')].map((o) => o.value)")
    s.check("the axes are the controls of the raceway", offered == ["span", "theta", "centre", "blend", "depth", "section"], offered)
    s.js(choose.format(0, "depth"))
    s.check("a map over others is not shown as one of the new axes", s.js(f"{S}.map.box") is None)
    s.tab.wait_for(fresh)
    head, *rows = s.js(saved).splitlines()
    s.check("the map is that of the chosen axis", head == before.replace("axial_span_mm", "depth_um"), head)
    depths, betas = ({row.split(",")[k] for row in rows} for k in (0, 2))
    s.check("from the first depth of its control to the last", "0" in depths and max(map(float, depths)) == 30 and len(depths) >= 31, len(depths))
    s.check("with an estimate at its points", len(betas - {""}) > 10, len(betas))
    s.js("document.querySelector('[data-point]').focus()")
    key(s, "ArrowRight")
    s.settled()
    said = s.js("document.querySelector('[data-point]').getAttribute('aria-valuetext')")
    s.check("arrow keys move along it", "depth_um = 1" in s.toml() and said.startswith("depth 1.0 µm"), said)
    s.press("undo")
    s.settled()
    s.check("in one step of undo", s.toml() == first)
    s.js(choose.format(0, "blend"))
    s.tab.wait_for(fresh)
    # The longest blend on the shortest raceway.
    title = s.js(
        f"(() => {{ const c = {S}.map.canvas, r = c.getBoundingClientRect(), {{ left, top, wide, high }} = {S}.map.plane;"
        " c.dispatchEvent(new PointerEvent('pointermove', { clientX: r.x + left + 0.98 * wide, clientY: r.y + top + 0.98 * high })); return c.title; })()"
    )
    s.check("an impossible place says why it is", title.startswith("raceway.blend_mm"), title)
    s.js(choose.format(0, "theta"))
    chosen = s.js("[...document.querySelectorAll('[data-axis]')].map((e) => e.value)")
    s.check("the axes change places", chosen == ["theta", "blend"], chosen)
    s.js(choose.format(0, "span"))
    s.js(choose.format(1, "theta"))
    s.tab.wait_for(fresh)
    s.check("and the map is as before", s.js(saved).splitlines()[0] == before)
