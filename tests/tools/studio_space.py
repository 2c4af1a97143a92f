"""The studio in space: axial load, contact angles of bearing and raceway, rows with preload."""

from pathlib import Path

from studio_tab import S

# Whether a canvas shows something of this colour.
INK = """
(() => {{
  const c = document.querySelector('[data-canvas={0}]'), [r, g, b] = {1};
  if (!c.clientWidth) return false;
  const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
  for (let k = 0; k < d.length; k += 4) if (d[k] === r && d[k + 1] === g && d[k + 2] === b) return true;
  return false;
}})()
"""
OUTER, OTHER, INNER = [0, 114, 178], [213, 94, 0], [0, 158, 115]


def moving(s, frames):
    """Waits for so many moments and shows one near the last."""
    s.js(
        f"(async () => {{ const m = {S}.motion; {S}.stage.run(false);"
        f" for (let k = 0; k < 2000 && !(m.frames.length > {frames}) && !m.ended; k++) {{ await m.more(); await new Promise((d) => setTimeout(d, 20)); }}"
        f" {S}.stage.to(0.9); }})()"
    )


def space(s, screens):
    """An axial load takes the case out of its plane; nothing of the page is refused as a whole."""
    before = s.toml()
    s.check("in the plane there are no contact angles", s.js(f"{S}.g.space") is None and s.js(f"{S}.stage.contacts.hidden"))
    s.write("axial", 150)
    s.check("the text has the axial load", "axial_load_n = 150" in s.toml() and not s.text("message"), s.text("message"))
    s.check("the case moves in space", s.js(f"{S}.g.space.signs") == [1])
    s.check("the estimate is about the lag", "lag of rolling" in s.text("terms"), s.text("terms"))
    s.check("the ring is displaced along the axis", s.js(f"{S}.g.static.ring_z_um") > 1)
    # A motion begins when the reader has paused.
    s.tab.wait_for(f"{S}.motion.toml === {S}.toml")
    moving(s, 60)
    s.check("the motion goes on", not s.text("motion"), s.text("motion"))
    points = s.js(f"{S}.stage.frame.space.outer.map(([angle, reach]) => angle.filter((_, k) => reach[k] > 0).length)")
    s.check("some balls sit on both flanks, all on one", points[0] >= 13 and 1 <= points[1] <= 4, points)
    for name, colours in (("contacts", (OUTER, OTHER, INNER)), ("section", (OUTER, INNER))):
        s.check(f"contacts are drawn in {name}", all(s.js(INK.format(name, colour)) for colour in colours), name)
    s.js(f"{S}.surface.root.open = true; new Promise((done) => setTimeout(done, 100))")
    s.check("tracks are drawn on the surface", s.js(INK.format("surface", OUTER)))
    s.js(f"{S}.surface.root.open = false")
    table = s.js(f"(async () => (await {S}.saving.file({S}.saving.things.find((t) => t.id === 'contacts'), 'csv')).text())()")
    heads = "time_s,ball,angle_deg,outer_angle_deg,outer_half_length_deg,other_flank_angle_deg"
    s.check("contact angles are saved", table.startswith(heads) and table.count("\n") > 14 * 60, table[:120])
    over = s.js("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    s.check("nothing of it sticks out", over <= 0, over)
    s.judged()
    said = s.text("verdict")
    s.check("the verdict is about the lag in space", "of the steady-state gap" in said and "lag per pass" in s.text("terms"), said)
    s.write("section", 15)
    s.check("a section is turned", "contact_angle_deg = 15" in s.toml() and s.js(f"{S}.g.raceways[0].flank_deg[0][40]") > 45)
    kept = s.js(f"{S}.g.estimate.terms.find((t) => t.name === 'lag').value")
    s.check("and does not suit a small axial load", kept < 0.5, kept)
    s.press("undo")
    s.settled()
    rows(s, screens)
    s.type(before)
    s.judged()
    s.check("the plane is back", s.js(f"{S}.g.space") is None and not s.text("message"), s.text("message"))


def rows(s, screens):
    """A pair with preload: both rows are drawn, their preload has one control, a rotor drops onto it."""
    pair = (Path(__file__).parents[2] / "cases/preloaded-pair.toml").read_text(encoding="utf-8")
    s.type(pair)
    s.check("a pair is taken", not s.text("message") and s.js(f"{S}.g.space.signs") == [1, -1], s.text("message"))
    s.tab.wait_for(f"{S}.motion.toml === {S}.toml")
    moving(s, 30)
    svg = s.js(f"(async () => (await {S}.saving.file({S}.saving.things[0], 'svg')).text())()")
    s.check("both rows are drawn side by side", "row 1" in svg and "row 2" in svg and svg.count('fill="#f4f5f6"') == 24, svg.count('fill="#f4f5f6"'))
    s.check("every ball has its gap", s.js(f"{S}.stage.frame.gap_deg.length") == 28)
    s.check("the rows press to both sides", s.js(f"(({{ space }}) => space.inner[0][1] > 5 && space.inner[0][15] < -5)({S}.stage.frame)"))
    s.tab.screenshot(screens / f"studio-{s.name}-pair.png", captureBeyondViewport=True)
    s.write("preload", 10)
    s.check("the preload of all rows follows", s.toml().count("preload_um = 10") == 2 and not s.text("message"), s.text("message"))
    s.write("alpha", 12)
    s.check("so does the contact angle of the bearing", s.js(f"{S}.g.document.bearing.contact_angle_deg") == 12 and not s.text("message"), s.text("message"))
    s.write("ball", 9.5)
    s.check("a ball of another size fits an angular-contact bearing", not s.text("message"), s.text("message"))
    s.press("drop")
    s.settled()
    s.tab.wait_for(f"!!{S}.g.rotor")
    s.check("a rotor drops onto the pair", not s.text("message") and "axial_load_n" not in s.toml().split("[rotor]")[0], s.text("message"))
    s.tab.wait_for(f"{S}.motion.toml === {S}.toml")
    moving(s, 5)
    s.check("in space", s.js(f"!!{S}.stage.frame.space && isFinite({S}.stage.frame.rotor.z_um[0])") and not s.text("motion"), s.text("motion"))
