(function () {
  "use strict";
  const plots = Array.from(document.querySelectorAll(".plot"));
  const done = new WeakMap();
  const config = {
    responsive: true, displaylogo: false,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "toImage", "sendDataToCloud"],
  };

  function failed(el, error) {
    const message = document.createElement("div");
    message.className = "failed";
    message.textContent = "This figure could not be drawn: " + (error && error.message || error);
    el.replaceChildren(message);
  }

  // WebGL does not reach paper: a picture of the scene, as last turned, stands in for it.
  function keepForPrint(el) {
    const picture = document.createElement("img");
    picture.className = "printed";
    picture.alt = el.getAttribute("aria-label");
    el.after(picture);
    const take = () => Plotly.toImage(el, { format: "png", width: 1000, height: el.clientHeight, scale: 2 })
      .then((url) => { picture.src = url; }, () => picture.remove());
    el.on("plotly_relayout", take);
    return take();
  }

  function draw(el) {
    if (!done.has(el)) {
      const spec = JSON.parse(document.getElementById(el.id.replace(/-plot$/, "-spec")).textContent);
      const drawn = new Promise((resolve) => resolve(Plotly.newPlot(el, spec.data, spec.layout, config)));
      done.set(el, drawn.then(() => spec.layout.scene && keepForPrint(el)).catch((error) => failed(el, error)));
    }
    return done.get(el);
  }

  // Draws every figure of the page, seen or not.
  window.cagelessDrawAll = function () { return Promise.all(plots.map(draw)); };

  window.cagelessSave = function (blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  };

  document.addEventListener("click", function (event) {
    const button = event.target.closest("button[data-save]");
    const el = button && document.getElementById(button.dataset.figure + "-plot");
    if (!el) return;
    const size = { width: Math.max(el.clientWidth, 900), height: el.clientHeight };
    draw(el).then(() => Plotly.downloadImage(el, {
      format: button.dataset.save, filename: button.dataset.figure,
      width: size.width, height: size.height, scale: button.dataset.save === "png" ? 2 : 1,
    }));
  });

  window.addEventListener("beforeprint", window.cagelessDrawAll);
  if (location.hash === "#all" || /[?&]all\b/.test(location.search) || !("IntersectionObserver" in window)) {
    window.cagelessDrawAll();
    return;
  }
  const observer = new IntersectionObserver(function (entries) {
    entries.filter((entry) => entry.isIntersecting).forEach(function (entry) {
      observer.unobserve(entry.target);
      draw(entry.target);
    });
  }, { rootMargin: "400px 0px" });
  plots.forEach((el) => observer.observe(el));
})();
