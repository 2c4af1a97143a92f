// What a drawing does to a canvas, as SVG. Only the calls that drawings of the studio make.

class SvgPaper {
  constructor(width, height) {
    Object.assign(this, { width, height, parts: [], path: "", dash: [], fillStyle: "#000", strokeStyle: "#000", lineWidth: 1, globalAlpha: 1, textAlign: "left" });
    this.measure = element("canvas").getContext("2d");
  }

  set font(value) { this.measure.font = value; this.lettering = value; }
  setLineDash(dash) { this.dash = dash; }
  measureText(text) { return this.measure.measureText(text); }
  beginPath() { this.path = ""; }
  closePath() { this.path += "Z"; }
  moveTo(x, y) { this.path += "M" + num(x) + "," + num(y); }
  lineTo(x, y) { this.path += (this.path ? "L" : "M") + num(x) + "," + num(y); }

  arc(x, y, r, from, to, against = false) {
    const full = Math.abs(to - from) >= 2 * Math.PI - 1e-9, on = (a) => num(x + r * Math.cos(a)) + "," + num(y + r * Math.sin(a));
    if (full) { this.path += "M" + on(0) + "A" + num(r) + "," + num(r) + " 0 1 1 " + on(Math.PI) + "A" + num(r) + "," + num(r) + " 0 1 1 " + on(0) + "Z"; return; }
    const turn = 2 * Math.PI, swept = against ? ((from - to) % turn + turn) % turn : ((to - from) % turn + turn) % turn;
    this.path += (this.path ? "L" : "M") + on(from) + "A" + num(r) + "," + num(r) + " 0 " + (swept > Math.PI ? 1 : 0) + " " + (against ? 0 : 1) + " " + on(to);
  }

  common() { return this.globalAlpha < 1 ? ' opacity="' + this.globalAlpha + '"' : ""; }
  fill() { this.parts.push('<path d="' + this.path + '" fill="' + this.fillStyle + '"' + this.common() + "/>"); }
  stroke() { this.parts.push('<path d="' + this.path + '" fill="none" stroke="' + this.strokeStyle + '" stroke-width="' + this.lineWidth + '"' + (this.dash.length ? ' stroke-dasharray="' + this.dash.join(" ") + '"' : "") + this.common() + "/>"); }
  fillRect(x, y, w, h) { this.parts.push('<rect x="' + num(x) + '" y="' + num(y) + '" width="' + num(w) + '" height="' + num(h) + '" fill="' + this.fillStyle + '"' + this.common() + "/>"); }
  drawImage(image, x, y, w, h) { this.parts.push('<image x="' + num(x) + '" y="' + num(y) + '" width="' + num(w) + '" height="' + num(h) + '" href="' + image.toDataURL() + '"/>'); }

  fillText(text, x, y) {
    const anchor = { left: "start", right: "end", center: "middle" }[this.textAlign];
    const plain = String(text).replace(/&/g, "&amp;").replace(/</g, "&lt;");
    this.parts.push('<text x="' + num(x) + '" y="' + num(y) + '" text-anchor="' + anchor + '" fill="' + this.fillStyle + '" style="font:' + this.lettering + '">' + plain + "</text>");
  }

  text() {
    return '<svg xmlns="http://www.w3.org/2000/svg" width="' + this.width + '" height="' + this.height + '" viewBox="0 0 ' + this.width + " " + this.height + '"><rect width="100%" height="100%" fill="#fff"/>' + this.parts.join("\n") + "</svg>\n";
  }
}

const num = (v) => String(Math.round(v * 100) / 100);

// A drawing on white paper, as SVG; `draw` is given what it draws on.
function asSvg(draw, width) {
  const paper = new SvgPaper(width, 0);
  draw({ light: true, begin: (ratio) => { paper.height = Math.round(width * ratio); return paper; } });
  return paper.text();
}
