// The drawings: balls in motion with their gaps, unrolled groove, section.

const SLOWED = [2000, 1000, 500, 200, 100];

class Stage {
  constructor(studio) {
    Object.assign(this, { studio, now: 0, slow: 500, frame: null });
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
    this.raceway = element("div", { class: "pair" }, canvas("depth", "Unrolled groove depth and contact track"), canvas("section", "Section in the middle of the raceway"));
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
    const { motion } = this.studio;
    if (this.playing && this.stamp && motion && motion.frames.length) {
      this.now += Math.min(100, stamp - this.stamp) / 1000 / this.slow;
      this.now = Math.min(Math.max(this.now, motion.first), motion.last);
      this.paint();
    }
    this.stamp = stamp;
    requestAnimationFrame((next) => this.tick(next));
  }

  title() {
    const { pinned } = this.studio.comparison;
    return pinned ? "B" : "";
  }

  paint() {
    const { studio, canvas } = this, { g, motion } = studio;
    if (!g || !motion) return;
    this.play.textContent = this.playing ? "Pause" : "Play";
    const frame = motion.frames.length ? motion.at(this.now) : null;
    this.frame = frame;
    const span = motion.last - motion.first;
    this.moment.disabled = !(span > 0);
    this.moment.value = span > 0 ? Math.round(1000 * (this.now - motion.first) / span) : 0;
    // What changes sixty times a second is not read out.
    if (!this.playing) this.moment.setAttribute("aria-valuetext", frame ? (1000 * frame.t).toFixed(2) + " ms" : "at rest");
    drawBearing(canvas.b, g, frame, this.title());
    drawGaps(canvas.gaps, g, frame);
    studio.drop.paint(frame);
    if (this.drawn !== g || this.width !== studio.root.clientWidth) {
      drawDepth(canvas.depth, g);
      drawSection(canvas.section, g);
      this.drawn = g;
      this.width = studio.root.clientWidth;
    }
    const { pinned } = studio.comparison;
    if (pinned) drawBearing(canvas.a, pinned.g, studio.motionA.frames.length ? studio.motionA.at(this.now) : null, pinned.name);
  }
}
