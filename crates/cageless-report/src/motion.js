(function () {
  "use strict";

  // Most frames of a film.
  const FRAMES = 240;

  // Undoes the coding of samples as differences in whole steps.
  function decode(steps, scale) {
    const out = new Float64Array(steps.length);
    let sum = 0;
    for (let k = 0; k < steps.length; k++) { sum += steps[k]; out[k] = sum / scale; }
    return out;
  }

  function setUp(figure) {
    const data = JSON.parse(figure.querySelector("script[data-motion]").textContent);
    const svg = figure.querySelector("svg");
    const find = (name) => figure.querySelector("[data-" + name + "]");
    const play = find("play"), slider = find("time"), clock = find("clock"), speed = find("speed");
    const from = find("from"), until = find("until"), part = find("part"), film = find("film");
    const bearings = data.bearings.map(function (raw, k) {
      const group = svg.querySelector('[data-bearing="' + k + '"]');
      return {
        time: decode(raw.t, data.second),
        angle: raw.a.map((row) => decode(row, data.degree)),
        gap: raw.g.map((row) => decode(row, data.degree)),
        before: raw.before, eps: raw.eps, pitch: raw.pitch,
        rotor: raw.rotor && {
          x: decode(raw.rotor.x, data.degree), y: decode(raw.rotor.y, data.degree),
          angle: decode(raw.rotor.a, data.degree), ring: decode(raw.rotor.ring, data.degree),
        },
        shaft: group.querySelector("[data-rotor]"), mark: group.querySelector("[data-ring-mark]"),
        balls: Array.from(group.querySelectorAll("[data-ball]")),
        touches: Array.from(group.querySelectorAll("[data-touch]")),
        lines: Array.from(group.querySelectorAll("[data-line]")),
      };
    }).filter((b) => b.time.length > 0);
    if (!bearings.length) return;
    const first = Math.max(...bearings.map((b) => b.time[0]));
    const last = Math.min(...bearings.map((b) => b.time[b.time.length - 1]));
    let begin = first, end = last, now = begin, playing = false, before = 0, filming = false;

    function show(b) {
      let low = 0, high = b.time.length - 1;
      while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (b.time[middle] <= now) low = middle; else high = middle;
      }
      const span = b.time[high] - b.time[low];
      const share = span > 0 ? (now - b.time[low]) / span : 0;
      const at = (row) => row[low] + (row[high] - row[low]) * share;
      const angle = b.angle.map(at), count = angle.length;
      const gap = b.gap.length === count ? b.gap.map(at) : angle.map(
        (a, k) => (k + 1 < count ? angle[k + 1] - a : angle[0] + 360 - a) - b.eps);
      if (b.rotor && b.rotor.x.length > high) {
        const r = b.rotor;
        b.shaft.setAttribute("transform", "translate(" + at(r.x).toFixed(4) + "," + (-at(r.y)).toFixed(4)
          + ") rotate(" + (-at(r.angle) % 360).toFixed(3) + ")");
        b.mark.setAttribute("transform", "rotate(" + (-at(r.ring) % 360).toFixed(3) + ")");
      }
      const touching = gap.map((g) => g <= 0);
      let least = 0, pairs = 0;
      angle.forEach(function (a, k) {
        const psi = a * Math.PI / 180;
        b.balls[k].setAttribute("transform", "translate(" + (b.pitch * Math.sin(psi)).toFixed(4) + ","
          + (b.pitch * Math.cos(psi)).toFixed(4) + ")");
        const hit = touching[k] || touching[(k + count - 1) % count];
        const circle = b.balls[k].firstElementChild;
        circle.setAttribute("stroke", hit ? "#d55e00" : "#555555");
        circle.setAttribute("stroke-width", hit ? "0.7" : "0.2");
        const middle = psi + (gap[k] + b.eps) * Math.PI / 360, touch = b.touches[k];
        touch.setAttribute("visibility", touching[k] ? "visible" : "hidden");
        touch.setAttribute("cx", (b.pitch * Math.sin(middle)).toFixed(4));
        touch.setAttribute("cy", (b.pitch * Math.cos(middle)).toFixed(4));
        if (gap[k] < gap[least]) least = k;
        if (touching[k]) pairs++;
      });
      b.lines[0].textContent = "t = " + now.toFixed(4) + " s  ·  smallest gap " + gap[least].toFixed(3).replace("-", "−")
        + "° (balls " + (b.before + least + 1) + ", " + (b.before + (least + 1) % count + 1) + ")";
      b.lines[1].textContent = (pairs === 1 ? "1 pair touches" : pairs + " pairs touch")
        + "  ·  gap of balls " + (b.before + 1) + ", " + (b.before + 2) + ": " + gap[0].toFixed(3).replace("-", "−") + "°";
    }

    function update() {
      bearings.forEach(show);
      clock.textContent = "t = " + now.toFixed(4) + " s";
      slider.value = end > begin ? Math.round((now - begin) / (end - begin) * 10000) : 0;
      slider.setAttribute("aria-valuetext", clock.textContent);
    }

    function frame(stamp) {
      if (!playing) return;
      if (before) now += (stamp - before) / 1000 / Number(speed.value);
      before = stamp;
      if (now > end) now = begin;
      update();
      requestAnimationFrame(frame);
    }

    function run(on) {
      playing = on;
      before = 0;
      play.textContent = on ? "Pause" : "Play";
      if (on) requestAnimationFrame(frame);
    }

    // The stretch of time that is played, within what was recorded.
    function stretch(a, b) {
      begin = Math.min(Math.max(a, first), last);
      end = Math.min(Math.max(b, begin), last);
      if (!(end > begin)) { begin = first; end = last; }
      from.value = begin.toFixed(4);
      until.value = end.toFixed(4);
      now = begin;
      update();
    }

    play.addEventListener("click", () => run(!playing));
    slider.addEventListener("input", function () {
      run(false);
      now = begin + (end - begin) * slider.value / 10000;
      bearings.forEach(show);
      clock.textContent = "t = " + now.toFixed(4) + " s";
    });
    for (const field of [from, until]) {
      field.min = first.toFixed(4);
      field.max = last.toFixed(4);
      field.addEventListener("change", () => stretch(Number(from.value), Number(until.value)));
    }
    if (part) part.addEventListener("change", function () {
      const [a, b] = part.value ? part.value.split(",").map(Number) : [first, last];
      stretch(a, b);
    });
    figure.querySelectorAll("[data-moment]").forEach(function (button) {
      const moment = Number(button.dataset.moment);
      button.disabled = moment < first - 1e-6 || moment > last + 1e-6;
      button.addEventListener("click", function () {
        run(false);
        if (moment < begin || moment > end) stretch(first, last);
        now = Math.min(Math.max(moment, begin), end);
        update();
      });
    });
    figure.querySelectorAll("button[data-save]").forEach(function (button) {
      button.addEventListener("click", () => save(svg, button.dataset.figure, button.dataset.save));
    });

    // A film of the stretch at the chosen speed; a second press gives it up.
    film.addEventListener("click", function () {
      if (filming) { filming = false; return; }
      run(false);
      filming = true;
      const seconds = (end - begin) * Number(speed.value), back = now;
      const frames = Math.max(2, Math.min(FRAMES, Math.round(seconds * 20)));
      const seek = function (k) {
        film.textContent = "Stop film, " + Math.round(100 * k / frames) + " %";
        now = begin + (end - begin) * k / (frames - 1);
        update();
        return filming;
      };
      record(svg, frames, seconds, seek).then(function (blob) {
        if (blob) window.cagelessSave(blob, film.dataset.figure + ".gif");
        film.textContent = "Save as GIF";
      }, function () { film.textContent = "No GIF could be made"; }).then(function () {
        filming = false;
        now = back;
        update();
      });
    });
    stretch(first, last);
  }

  // A copy of the drawing as a picture.
  function picture(copy, width, height) {
    copy.setAttribute("width", width);
    copy.setAttribute("height", height);
    return window.cagelessPicture(new XMLSerializer().serializeToString(copy));
  }

  // The film as a file, unless it is given up; the page stays alive meanwhile.
  async function record(svg, frames, seconds, seek) {
    const box = svg.viewBox.baseVal, scale = Math.min(8, 1200 / box.width);
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(box.width * scale);
    canvas.height = Math.round(box.height * scale);
    const ctx = canvas.getContext("2d", { willReadFrequently: true });
    // Viewers slow down what is faster than fifty frames a second.
    const film = window.cagelessGif(canvas.width, canvas.height, Math.max(2, Math.round(100 * seconds / frames)));
    for (let k = 0; k < frames; k++) {
      if (!seek(k)) return null;
      ctx.drawImage(await picture(svg.cloneNode(true), canvas.width, canvas.height), 0, 0);
      film.add(ctx.getImageData(0, 0, canvas.width, canvas.height).data);
      await new Promise((done) => setTimeout(done));
    }
    return film.blob();
  }

  function save(svg, name, format) {
    const box = svg.viewBox.baseVal, copy = svg.cloneNode(true);
    copy.removeAttribute("class");
    if (format === "svg") {
      copy.setAttribute("width", box.width * 10);
      copy.setAttribute("height", box.height * 10);
      const blob = new Blob([new XMLSerializer().serializeToString(copy)], { type: "image/svg+xml" });
      window.cagelessSave(blob, name + ".svg");
      return;
    }
    picture(copy, box.width * 20, box.height * 20).then(function (image) {
      const canvas = document.createElement("canvas");
      canvas.width = box.width * 20;
      canvas.height = box.height * 20;
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((png) => window.cagelessSave(png, name + ".png"));
    });
  }

  document.querySelectorAll("figure.motion").forEach(setUp);
})();
