// Motion that is watched while the next stretch is computed.

const STRETCH_ORBITS = 1 / 8;
const FRAMES = 24;
const FRAMES_KEPT = 4000;

// The moment between two others: numbers, arrays and parts of them alike.
function between(a, b, part) {
  if (typeof a === "number") return a + (b - a) * part;
  if (Array.isArray(a)) return a.map((v, i) => between(v, b[i], part));
  return Object.fromEntries(Object.entries(a).map(([name, value]) => [name, between(value, b[name], part)]));
}

class LiveMotion {
  // `moments` is called with every stretch that arrives, `failed` with an error.
  constructor(engine, lane, moments, failed) {
    Object.assign(this, { engine, lane, moments, failed });
    this.reset();
  }

  reset() {
    if (this.abort) this.abort.abort();
    this.abort = null;
    this.frames = [];
    this.resume = undefined;
    this.ended = true;
    this.pending = false;
  }

  start(toml, orbit_s) {
    this.reset();
    this.abort = new AbortController();
    // A rotor that stands still has no orbit.
    Object.assign(this, { toml, orbit_s: orbit_s > 0 ? orbit_s : 0.01, ended: false });
    return this.more();
  }

  async more() {
    if (this.pending || this.ended) return;
    this.pending = true;
    const abort = this.abort;
    const request = { op: "motion", case: this.toml, duration_s: this.orbit_s * STRETCH_ORBITS, frames: FRAMES };
    if (this.resume) request.resume = this.resume;
    try {
      const part = await this.engine.request(this.lane, request, { signal: abort.signal });
      if (abort !== this.abort) return;
      this.turn(part.frames);
      this.frames.push(...part.frames);
      if (this.frames.length > FRAMES_KEPT) this.frames.splice(0, this.frames.length - FRAMES_KEPT);
      this.resume = part.resume || undefined;
      if (part.stopped) { this.ended = true; this.failed(new Error("at t = " + part.stopped.time_s.toFixed(6) + " s: " + part.stopped.cause + ". " + part.stopped.advice)); }
      this.moments(part);
    } catch (error) {
      if (abort === this.abort && error.name !== "AbortError") { this.ended = true; this.failed(error); }
    } finally {
      if (abort === this.abort) this.pending = false;
    }
  }

  // Angle of the inner ring under a rotor, which is no state of the motion, from its speed.
  turn(frames) {
    let before = this.frames[this.frames.length - 1];
    for (const frame of frames) {
      if (!frame.rotor) return;
      const speed = (f) => f.rotor.speed_rpm[1] * Math.PI / 30;
      frame.ring_rad = before ? before.ring_rad + 0.5 * (speed(before) + speed(frame)) * (frame.t - before.t) : 0;
      before = frame;
    }
  }

  get first() { return this.frames.length ? this.frames[0].t : 0; }
  get last() { return this.frames.length ? this.frames[this.frames.length - 1].t : 0; }

  // The moment `t`, between its neighbours; asks for the next stretch in good time.
  at(t) {
    if (this.last - t < this.orbit_s * STRETCH_ORBITS * 1.5) this.more();
    const f = this.frames;
    if (!f.length) return null;
    let low = 0, high = f.length - 1;
    while (high - low > 1) { const m = (low + high) >> 1; if (f[m].t <= t) low = m; else high = m; }
    const [a, b] = [f[low], f[high]];
    const part = b.t > a.t ? Math.max(0, Math.min(1, (t - a.t) / (b.t - a.t))) : 0;
    const moment = between(a, b, part);
    // A contact that opens is none in one of the two.
    if (a.space) moment.space = (part < 0.5 ? a : b).space;
    return moment;
  }
}
