(function () {
  "use strict";
  const plots = Array.from(document.querySelectorAll(".plot"));
  const specs = new WeakMap(), done = new WeakMap(), stale = new WeakSet();
  const dark = matchMedia("(prefers-color-scheme: dark)"), small = matchMedia("(max-width: 720px)");
  let printing = false;
  const config = {
    responsive: true, displaylogo: false,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "toImage", "sendDataToCloud"],
  };

  // Colours of ink, rules and lines, and what stands for them on a dark page.
  const PAPER = "#14181d", NIGHT = {
    "#000": "#e4e8ec", "#000000": "#e4e8ec", "#111": "#e4e8ec", "#111111": "#e4e8ec", "#222": "#e4e8ec",
    "#333": "#c9d1d9", "#333333": "#c9d1d9", "#444444": "#c2cad2", "#555": "#a3adb8", "#666": "#a3adb8",
    "#777": "#a3adb8", "#777777": "#a3adb8", "#9a9a9a": "#8a94a0", "#c4c4c4": "#5c6670",
    "#e6e6e6": "#2b333c", "#dddddd": "#39424c", "#0072b2": "#4da6e8",
  };

  // Scales that are lightest in the middle are darkest there.
  const NIGHT_SCALE = { "#f2f2f2": "#262d35", "#67001f": "#ff7a6b", "#b2182b": "#e0484d", "#2166ac": "#5aa9f0", "#92c5de": "#35618c" };

  // The same with the colours of a dark page. Scales of colour stay, and so do the outlines of
  // marks, which lie on them.
  function atNight(value, key, parent) {
    if (Array.isArray(value)) {
      if (key === "colorscale") return value.map(([at, colour]) => [at, NIGHT_SCALE[colour] || colour]);
      if ((value.length && typeof value[0] === "number")) return value;
      return value.map((one) => atNight(one, key, parent));
    }
    if (value && typeof value === "object") {
      if (key === "line" && parent === "marker") return value;
      return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, atNight(v, k, key)]));
    }
    return typeof value === "string" && NIGHT[value] || value;
  }

  const other = (axis, letter) => letter + "axis" + (axis || letter).slice(1);

  // Panels side by side go one below the other unless they are small, legends below the plot.
  function narrowed({ data, layout }, height) {
    const margin = Object.assign({ l: 72, r: 24, t: 44, b: 58 }, layout.margin);
    const inside = height - margin.t - margin.b;
    const names = Object.keys(layout).filter((k) => /^(xaxis|polar)\d*$/.test(k));
    const panels = names.map(function (name) {
      const polar = name[0] === "p", x = layout[name];
      const y = polar ? x.domain : layout[other(x.anchor, "y")];
      return { name, polar, x, y, across: (polar ? x.domain.x : x.domain) || [0, 1], up: (polar ? y.y : y.domain) || [0, 1] };
    }).sort((a, b) => b.up[1] - a.up[1] || a.across[0] - b.across[0]);
    margin.l = Math.min(margin.l, 56);
    // Room for the angles at the right of a polar diagram.
    margin.r = Math.min(margin.r, panels.some((p) => p.polar) ? 40 : 12);
    let full = inside, space = inside;
    if (layout.meta && layout.meta.side_by_side) {
      full = Math.round(0.6 * inside);
    } else if (new Set(panels.map((p) => p.across[0].toFixed(3))).size > 1) {
      const gap = 96, heights = panels.map(function (p) {
        const high = Math.max((p.up[1] - p.up[0]) * inside, 170);
        return p.polar || p.x.scaleanchor || p.y.scaleanchor ? Math.min(high, 290) : high;
      });
      full = heights.reduce((a, b) => a + b, 0) + gap * (panels.length - 1);
      let top = full;
      panels.forEach(function (p, k) {
        const domain = [(top - heights[k]) / full, top / full];
        top -= heights[k] + gap;
        if (p.polar) {
          p.x.domain = { x: [0, 1], y: domain };
          (layout.annotations || []).filter((a) => a.name === p.name)
            .forEach((a) => Object.assign(a, { x: 0.5, y: domain[1], yshift: 24, placed: true }));
          return;
        }
        // Titles and numbers that one panel had for its row or its column.
        for (const [axis, letter] of [[p.x, "x"], [p.y, "y"]]) {
          if (axis.showticklabels !== false) continue;
          axis.showticklabels = true;
          const alike = panels.find((q) => !q.polar && q[letter].title && q[letter].title.text
            && (letter === "x" ? q.across[0] === p.across[0] : q.up[1] === p.up[1]));
          if (alike) axis.title = Object.assign({}, alike[letter].title);
        }
        p.x.domain = [0, 1];
        p.y.domain = domain;
      });
    }
    // What stands above or below the plot keeps its distance.
    const moved = (y) => y > 1 ? 1 + (y - 1) * inside / full : y < 0 ? y * inside / full : y;
    (layout.annotations || []).forEach((a) => { if (a.yref === "paper" && !a.placed) a.y = moved(a.y); });
    if (layout.legend && layout.showlegend) {
      if (layout.legend.orientation === "v") {
        Object.assign(layout.legend, { orientation: "h", x: 0, y: -80 / full, yanchor: "top" });
        space += 90;
      } else {
        // Above the titles of polar panels, which stand above these.
        const titles = panels.some((p) => p.polar) ? 48 : 0;
        layout.legend.y = Math.max(moved(layout.legend.y), 1 + titles / full);
        space += 40;
        margin.t += 40 + titles;
      }
    }
    // A scene has the whole width, and the scale of its colours below it.
    if (layout.scene) {
      for (const axis of ["x", "y", "z"]) layout.scene.camera.eye[axis] *= 1.4;
      data.filter((trace) => trace.colorbar).forEach((trace) => Object.assign(trace.colorbar, { orientation: "h", x: 0.5, xanchor: "center", y: 0, yanchor: "top", len: 0.9 }));
      margin.b += 70;
    }
    layout.margin = margin;
    layout.font = Object.assign({}, layout.font, { size: 11 });
    return Math.round(full + (space - inside) + margin.t + margin.b);
  }

  // In half of the width a legend above the plot has more lines.
  function besideAnother({ layout }, height) {
    if (!layout.showlegend || !layout.legend || layout.legend.orientation !== "h") return height;
    layout.margin = Object.assign({}, layout.margin, { t: (layout.margin && layout.margin.t || 44) + 36 });
    return height + 36;
  }

  // The specification of a plot as it is drawn here, and its height.
  function shown(el, light, wide) {
    if (!specs.has(el)) specs.set(el, document.getElementById(el.id.replace(/-plot$/, "-spec")).textContent);
    let spec = JSON.parse(specs.get(el)), height = Number(el.dataset.height);
    if (dark.matches && !printing && !light) {
      spec = atNight(spec);
      Object.assign(spec.layout, { paper_bgcolor: PAPER, plot_bgcolor: PAPER,
        modebar: { bgcolor: "rgba(0,0,0,0)", color: "#8a94a0", activecolor: "#e4e8ec" } });
    }
    // Paper is wide enough for what stands side by side.
    if (small.matches && !wide && !printing) height = narrowed(spec, height);
    else if (!wide && !printing && el.clientWidth < 700) height = besideAnother(spec, height);
    return { data: spec.data, layout: spec.layout, height };
  }

  function failed(el, error) {
    const message = document.createElement("div");
    message.className = "failed";
    message.textContent = "This figure could not be drawn: " + (error && error.message || error);
    el.replaceChildren(message);
  }

  // WebGL does not reach paper: a picture of the scene, as last turned, stands in for it.
  function keepForPrint(el) {
    const kept = el.parentElement.querySelector("img.printed"), picture = kept || document.createElement("img");
    const take = () => Plotly.toImage(asSaved(el), { format: "png", width: 1000, height: el.clientHeight, scale: 1 })
      .then((url) => { picture.src = url; }, () => picture.remove());
    el.on("plotly_relayout", (change) => { if (Object.keys(change).some((key) => key.startsWith("scene.camera"))) take(); });
    if (kept) return undefined;
    picture.className = "printed";
    picture.alt = el.getAttribute("aria-label");
    el.after(picture);
    return take();
  }

  // The plot has one name as a whole; its tools at the corner, which have but pictures, get one each.
  // Plotly gives every scene of a page the same id.
  function nameParts(el) {
    const tester = document.getElementById("js-plotly-tester");
    for (const svg of [...el.querySelectorAll("svg"), ...(tester ? [tester] : [])]) svg.setAttribute("aria-hidden", "true");
    el.querySelectorAll("[id=scene]").forEach((scene) => { scene.id = el.id + "-scene"; });
    el.querySelectorAll(".modebar-btn").forEach(function (tool) {
      const name = tool.dataset.title || (tool.classList.contains("plotlyjsicon") ? "Plotly" : "");
      tool.setAttribute("role", "button");
      tool.setAttribute("aria-label", name);
    });
  }

  // Draws from nothing: Plotly.react leaves the titles of colour bars where the wider plot had them.
  function render(el, spec) {
    el.style.height = spec.height + "px";
    return Plotly.newPlot(el, spec.data, spec.layout, config).then(function () {
      nameParts(el);
      return spec.layout.scene && keepForPrint(el);
    });
  }

  // Draws a figure for the first time, or for a screen that has changed since.
  function draw(el) {
    if (!done.has(el) || stale.has(el)) {
      stale.delete(el);
      done.set(el, Promise.resolve(done.get(el))
        .then(() => render(el, withChoices(el, shown(el)))).catch((error) => failed(el, error)));
    }
    return done.get(el);
  }

  // What the reader chose: ranges of axes, traces switched on and off, the view of a scene.
  function withChoices(el, spec) {
    Object.keys(spec.layout).filter((k) => /^[xy]axis\d*$/.test(k)).forEach(function (k) {
      const now = el._fullLayout && el._fullLayout[k];
      if (now && now.type !== "category") spec.layout[k].range = now.range.slice();
    });
    if (spec.layout.scene && el.layout && el.layout.scene) spec.layout.scene.camera = el.layout.scene.camera;
    (el.data || []).forEach((trace, k) => { if ("visible" in trace && spec.data[k]) spec.data[k].visible = trace.visible; });
    return spec;
  }

  // For files and paper: light, and as wide as on a large screen.
  function asSaved(el) {
    const spec = withChoices(el, shown(el, true, true));
    return { data: spec.data, layout: spec.layout };
  }

  const all = location.hash === "#all" || /[?&]all\b/.test(location.search) || !("IntersectionObserver" in window);
  const observer = all ? null : new IntersectionObserver(function (entries) {
    entries.filter((entry) => entry.isIntersecting).forEach(function (entry) {
      observer.unobserve(entry.target);
      draw(entry.target);
    });
  }, { rootMargin: "400px 0px" });

  function drawOnceSeen(el) {
    if (!observer) { draw(el); return; }
    observer.unobserve(el);
    observer.observe(el);
  }

  // For another screen, figures have their new height at once and are drawn again once seen.
  function drawAgain() {
    plots.filter((el) => done.has(el)).forEach(function (el) {
      stale.add(el);
      el.style.height = shown(el).height + "px";
      drawOnceSeen(el);
    });
  }

  // Draws every figure of the page, seen or not.
  window.cagelessDrawAll = function () { return Promise.all(plots.map(draw)); };
  // A figure as its buttons save it.
  window.cagelessImage = function (el, format) {
    return draw(el).then(() => Plotly.toImage(asSaved(el), {
      format, width: Math.max(el.clientWidth, 900), height: Number(el.dataset.height), scale: format === "png" ? 2 : 1,
    }));
  };

  window.cagelessSave = function (blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  };

  // An SVG as an image.
  window.cagelessPicture = function (svg) {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    return image.decode().then(function () { URL.revokeObjectURL(image.src); return image; });
  };

  function save(el, button) {
    const { save: format, figure } = button.dataset;
    window.cagelessImage(el, format).then((url) => fetch(url)).then((answer) => answer.blob())
      .then((blob) => window.cagelessSave(blob, figure + "." + format));
  }

  function view(el, button) {
    draw(el).then(function () {
      Plotly.relayout(el, { "xaxis.range": button.dataset.view.split(",").map(Number) });
      button.parentElement.querySelectorAll("button").forEach((b) => b.setAttribute("aria-pressed", b === button));
    });
  }

  document.addEventListener("click", function (event) {
    const button = event.target.closest("button");
    if (!button) return;
    const el = button.dataset.figure && document.getElementById(button.dataset.figure + "-plot");
    if (el && button.dataset.save) save(el, button);
    if (el && button.dataset.view) view(el, button);
    if (button.dataset.copy !== undefined) {
      navigator.clipboard.writeText(button.parentElement.querySelector("pre").textContent)
        .then(() => { button.textContent = "Copied"; }, () => { button.textContent = "Select the text to copy it"; });
    }
  });

  dark.addEventListener("change", drawAgain);
  small.addEventListener("change", drawAgain);
  window.addEventListener("beforeprint", function () { printing = true; drawAgain(); window.cagelessDrawAll(); });
  window.addEventListener("afterprint", function () { printing = false; drawAgain(); });
  document.querySelectorAll("details").forEach((part) => part.addEventListener("toggle", function () {
    part.querySelectorAll(".plot").forEach((el) => { if (part.open && done.has(el)) Plotly.Plots.resize(el); });
  }));

  if ("IntersectionObserver" in window) {
    const links = new Map(Array.from(document.querySelectorAll("nav a"), (a) => [a.getAttribute("href").slice(1), a]));
    const seen = new Set();
    const here = new IntersectionObserver(function (entries) {
      entries.forEach((e) => { if (e.isIntersecting) seen.add(e.target.id); else seen.delete(e.target.id); });
      const first = Array.from(links.keys()).find((id) => seen.has(id));
      links.forEach((a, id) => { if (id === first) a.setAttribute("aria-current", "true"); else a.removeAttribute("aria-current"); });
    }, { rootMargin: "-10% 0px -60% 0px" });
    document.querySelectorAll("main > section").forEach((s) => here.observe(s));
  }

  plots.forEach(drawOnceSeen);
})();
