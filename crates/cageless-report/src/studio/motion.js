// Motion that is watched while the next stretch is computed.

const STRETCH_ORBITS = 1 / 8;
const FRAMES = 24;
const FRAMES_KEPT = 4000;

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
    Object.assign(this, { toml, orbit_s, ended: false });
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
    const mix = (name) => a[name].map((v, i) => v + (b[name][i] - v) * part);
    return { t: a.t + (b.t - a.t) * part, angle_deg: mix("angle_deg"), gap_deg: mix("gap_deg"), inner_force_n: mix("inner_force_n"), outer_force_n: mix("outer_force_n"), slip_m_s: mix("slip_m_s"), ring_um: mix("ring_um") };
  }
}
