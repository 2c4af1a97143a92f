// The drawings: balls in motion with their gaps, unrolled groove, section.

const SLOWED = [2000, 1000, 500, 200, 100];
// Milliseconds from frame to frame above which the browser is too slow for all drawings, and below
// which it is not any more: one without a graphics card, or beside other work.
const SLOW_MS = [18, 22];
// What accompanies the balls follows so often then, and the slider always.
const SELDOM_MS = 500;
// Frames that such a browser leaves out after each one while the verdict is simulated.
const RESTS = 3;

class Stage {
  constructor(studio) {
    Object.assign(this, { studio, now: 0, slow: 500, frame: null, pace: 0, painted: 0, rest: 0, last: 0 });
    this.playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.canvas = {};
    const canvas = (name, label) => (this.canvas[name] = element("canvas", { role: "img", "aria-label": label, "data-canvas": name }));
    this.play = button("Pause", () => this.run(!this.playing), { "data-play": true });
    const speed = element("select", { "aria-label": "Slow motion", "data-speed": true, onchange: () => { this.slow = Number(speed.value); } },
      ...SLOWED.map((v) => element("option", { value: v, selected: v === this.slow }, v + " ×")));
    this.moment = element("input", {
      type: "range", min: 0, max: 1000, step: 1, value: 0, "aria-label": "Moment of the motion", "data-moment": true,
      oninput: () => { this.run(false); this.to(Number(this.moment.value) / 1000); },
    });
    this.bar = element("div", { class: "bar moments" }, this.play, element("label", {}, "slowed down ", speed), this.moment);
    this.bearings = [canvas("a", "Bearing A in motion"), canvas("b", "Bearing in motion")];
    this.gaps = canvas("gaps", "Gap ahead of each ball");
    this.contacts = canvas("contacts", "Contact angles of the balls over ψ");
    this.contacts.hidden = true;
    this.raceway = element("div", { class: "pair" }, canvas("depth", "Unrolled groove depth and contact track"), canvas("section", "Section in the middle of the raceway"));
    // Frames of the motion are not drawn where nobody sees them.
    this.views = new IntersectionObserver((seen) => seen.forEach((entry) => { entry.target.unseen = !entry.isIntersecting; }));
    [...this.bearings, this.gaps, this.contacts].forEach((view) => this.views.observe(view));
    new ResizeObserver(() => this.paint()).observe(studio.root);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { this.drawn = null; this.paint(); });
    requestAnimationFrame((stamp) => this.tick(stamp));
  }

  run(on) {
    this.playing = on;
    this.paint();
  }

  // Shows the moment at this share of the time that is held.
  to(share) {
    const { motion } = this.studio;
    this.now = motion.first + share * (motion.last - motion.first);
    this.paint();
  }

  tick(stamp) {
    const { motion } = this.studio, since = stamp - this.stamp;
    // Only frames drawn one after the other say how long one takes.
    if (this.painted > 1) this.pace += 0.2 * (Math.min(200, since) - this.pace);
    if (this.playing && since && motion && motion.frames.length) {
      this.now += Math.min(100, since) / 1000 / this.slow;
      this.now = Math.min(Math.max(this.now, motion.first), motion.last);
      if (stamp < this.rest) this.painted = 0;
      else this.follow(stamp);
    }
    this.stamp = stamp;
    requestAnimationFrame((next) => this.tick(next));
  }

  // Draws one frame of the motion: the balls first, and the verdict before them.
  follow(stamp) {
    this.late = this.pace > SLOW_MS[this.late ? 0 : 1];
    const seldom = stamp - this.last > SELDOM_MS;
    if (seldom) this.last = stamp;
    this.paint({ beside: seldom || !this.late, slider: seldom });
    this.painted++;
    this.rest = this.late && !this.studio.judged ? stamp + RESTS * this.pace : 0;
  }

  // The last moments up to the one that is shown, of motion in space. A moment may be older than the case.
  track() {
    const { frame } = this, { motion, g } = this.studio;
    return frame && frame.space && g.space ? [...motion.frames.filter((f) => f.space && f.t <= frame.t).slice(-TRACKED), frame] : [];
  }

  title() {
    const { pinned } = this.studio.comparison;
    return pinned ? "B" : "";
  }

  // Draws all, or of a frame of the motion what is seen: the balls, and what is beside them if it is due.
  paint(part) {
    const { studio, canvas } = this, { g, motion } = studio, { pinned } = studio.comparison;
    if (!g || !motion) return;
    const frame = motion.frames.length ? motion.at(this.now) : null, due = (view) => !part || part.slider || !view.unseen;
    this.frame = frame;
    if (!part || part.slider) this.slide(frame);
    if (due(canvas.b)) drawBearing(canvas.b, g, frame, this.title());
    if (pinned && due(canvas.a)) drawBearing(canvas.a, pinned.g, studio.motionA.frames.length ? studio.motionA.at(this.now) : null, pinned.name);
    if (!part || part.beside) {
      if (due(canvas.gaps)) drawGaps(canvas.gaps, g, frame);
      const track = this.track();
      this.contacts.hidden = !track.length;
      if (track.length) {
        if (due(canvas.contacts)) drawContacts(canvas.contacts, g, frame, track);
        drawSection(canvas.section, g, frame);
        studio.surface.paint();
      }
      studio.drop.paint(frame);
    } else studio.drop.move(frame);
    if (!part && (this.drawn !== g || this.width !== studio.root.clientWidth)) {
      drawDepth(canvas.depth, g);
      drawSection(canvas.section, g, frame);
      this.drawn = g;
      this.width = studio.root.clientWidth;
    }
  }

  // Button and slider: every change of them lays out a part of the page anew.
  slide(frame) {
    const { play, moment, playing } = this, { motion } = this.studio, span = motion.last - motion.first;
    const label = playing ? "Pause" : "Play", value = String(span > 0 ? Math.round(1000 * (this.now - motion.first) / span) : 0);
    if (play.textContent !== label) play.textContent = label;
    if (moment.disabled !== !(span > 0)) moment.disabled = !(span > 0);
    if (moment.value !== value) moment.value = value;
    // What changes several times a second is not read out.
    if (!playing) moment.setAttribute("aria-valuetext", frame ? (1000 * frame.t).toFixed(2) + " ms" : "at rest");
  }
}
