// Motion in space: contact angles of all balls over ψ, unrolled.

// Frames of the track of ball 1.
const TRACKED = 192;

// Contacts of a ball as [angle, half length of the ellipse, whether it is the inner one], in degrees: outer
// raceway, its other flank, inner raceway.
const contactsOf = ({ outer, inner }, ball) => [...outer, inner].map(([angle, reach], n) => [angle[ball], reach[ball], n === 2]);

// Outer raceway above, inner one below: a bar for each contact ellipse, the track of ball 1, flanks, shoulders.
function drawContacts(canvas, g, frame, track) {
  const { c, width, height } = context(canvas, canvas.clientWidth > 600 ? 0.42 : 0.8), k = colours(canvas);
  const left = 34, right = width - 6, px = (a) => left + (right - left) * (turned(a) + 180) / 360;
  const panel = (top, bottom, shoulder, inner) => {
    const py = (a) => (top + bottom) / 2 - a / (1.08 * shoulder) * (bottom - top) / 2;
    const line = (points, colour, wide, dash) => {
      // It breaks where ψ jumps back and where there is no contact.
      const jumps = (p, before) => p && before && Math.abs(p[0] - before[0]) > (right - left) * 0.6;
      lineThrough(c, points.flatMap((p, i) => (jumps(p, points[i - 1]) ? [null, p] : [p])), colour, wide, dash);
    };
    for (const edge of [shoulder, -shoulder]) line([left, (left + right) / 2, right].map((x) => [x, py(edge)]), k.soft, 1);
    if (!inner) {
      for (const r of g.raceways) {
        c.fillStyle = k.sector; c.globalAlpha = 0.16;
        for (const turn of [-360, 0, 360]) {
          const [from, to] = [-1, 1].map((end) => Math.max(-180, Math.min(180, r.centre_angle_deg + turn + end * r.half_angle_deg)));
          if (to > from) c.fillRect(left + (right - left) * (from + 180) / 360, top, (right - left) * (to - from) / 360, bottom - top);
        }
        c.globalAlpha = 1;
        for (const sign of new Set(signsOf(g))) for (const flank of r.flank_deg) {
          line(r.angle_deg.flatMap((a, i) => (Math.abs(a) <= r.half_angle_deg ? [[px(r.centre_angle_deg + a), py(sign * signsOf(g)[0] * flank[i])]] : [])), k.ink, 1, [4, 3]);
        }
      }
    }
    contactColours(k).forEach((colour, n) => {
      const own = ({ space }, ball) => { const [angle, reach, of] = contactsOf(space, ball)[n]; return of === inner && reach ? [angle, reach] : null; };
      line(track.map((f) => { const at = own(f, 0); return at && [px(f.angle_deg[0]), py(at[0])]; }), colour, 1);
      frame.angle_deg.forEach((psi, ball) => {
        const at = own(frame, ball);
        if (at) line([-1, 1].map((end) => [px(psi), py(at[0] + end * at[1])]), colour, ball ? 3 : 6);
      });
    });
    c.fillStyle = k.soft; c.textAlign = "right";
    for (const tick of ticks(-shoulder, shoulder, 5)) c.fillText(minus(tick + "°"), left - 3, py(tick) + 4);
    c.textAlign = "left"; c.fillText(inner ? "at the inner raceway; lines at the edges: shoulders" : "contact angles, outer raceway; thick: ball 1, dashed: flanks", left, top - 4);
  };
  const half = (height - 20) / 2, [inner, outer] = g.space.shoulders_deg;
  panel(16, half, outer, false);
  panel(half + 18, height - 20, inner, true);
  c.fillStyle = k.soft; c.textAlign = "center";
  for (const tick of [-180, -90, 0, 90, 180]) c.fillText(minus(tick + "°"), Math.max(left + 12, Math.min(right - 14, left + (right - left) * (tick + 180) / 360)), height - 5);
}
