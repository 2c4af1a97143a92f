(function () {
  "use strict";

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
    const play = figure.querySelector("[data-play]");
    const slider = figure.querySelector("[data-time]");
    const clock = figure.querySelector("[data-clock]");
    const speed = figure.querySelector("[data-speed]");
    const bearings = data.bearings.map(function (raw, k) {
      const group = svg.querySelector('[data-bearing="' + k + '"]');
      return {
        time: decode(raw.t, data.second),
        angle: raw.a.map((row) => decode(row, data.degree)),
        gap: raw.g.map((row) => decode(row, data.degree)),
        eps: raw.eps, pitch: raw.pitch,
        balls: Array.from(group.querySelectorAll("[data-ball]")),
        touches: Array.from(group.querySelectorAll("[data-touch]")),
        lines: Array.from(group.querySelectorAll("[data-line]")),
      };
    }).filter((b) => b.time.length > 0);
    if (!bearings.length) return;
    const begin = Math.max(...bearings.map((b) => b.time[0]));
    const end = Math.min(...bearings.map((b) => b.time[b.time.length - 1]));
    let now = begin, playing = false, before = 0;

    function show(b) {
      let low = 0, high = b.time.length - 1;
      while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (b.time[middle] <= now) low = middle; else high = middle;
      }
      const span = b.time[high] - b.time[low];
      const part = span > 0 ? (now - b.time[low]) / span : 0;
      const at = (row) => row[low] + (row[high] - row[low]) * part;
      const angle = b.angle.map(at), count = angle.length;
      const gap = b.gap.length === count ? b.gap.map(at) : angle.map(
        (a, k) => (k + 1 < count ? angle[k + 1] - a : angle[0] + 360 - a) - b.eps);
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
      b.lines[0].textContent = "t = " + now.toFixed(4) + " s  ·  smallest gap " + gap[least].toFixed(3).replace("-", "\u2212")
        + "° (balls " + (least + 1) + ", " + ((least + 1) % count + 1) + ")";
      b.lines[1].textContent = (pairs === 1 ? "1 pair touches" : pairs + " pairs touch")
        + "  ·  gap of balls 1, 2: " + gap[0].toFixed(3).replace("-", "\u2212") + "°";
    }

    function update() {
      bearings.forEach(show);
      clock.textContent = "t = " + now.toFixed(4) + " s";
      slider.value = end > begin ? Math.round((now - begin) / (end - begin) * 10000) : 0;
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

    play.addEventListener("click", () => run(!playing));
    slider.addEventListener("input", function () {
      run(false);
      now = begin + (end - begin) * slider.value / 10000;
      bearings.forEach(show);
      clock.textContent = "t = " + now.toFixed(4) + " s";
    });
    figure.querySelectorAll("[data-moment]").forEach(function (button) {
      const moment = Number(button.dataset.moment);
      button.disabled = moment < begin - 1e-6 || moment > end + 1e-6;
      button.addEventListener("click", function () { run(false); now = Math.min(Math.max(moment, begin), end); update(); });
    });
    figure.querySelectorAll("button[data-save]").forEach(function (button) {
      button.addEventListener("click", () => save(svg, button.dataset.figure, button.dataset.save));
    });
    update();
  }

  function save(svg, name, format) {
    const box = svg.viewBox.baseVal, copy = svg.cloneNode(true);
    copy.setAttribute("width", box.width * 10);
    copy.setAttribute("height", box.height * 10);
    const blob = new Blob([new XMLSerializer().serializeToString(copy)], { type: "image/svg+xml" });
    if (format === "svg") { window.cagelessSave(blob, name + ".svg"); return; }
    const url = URL.createObjectURL(blob), image = new Image();
    image.onload = function () {
      const canvas = document.createElement("canvas");
      canvas.width = box.width * 20;
      canvas.height = box.height * 20;
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      URL.revokeObjectURL(url);
      canvas.toBlob((png) => window.cagelessSave(png, name + ".png"));
    };
    image.src = url;
  }

  document.querySelectorAll("figure.motion").forEach(setUp);
})();
