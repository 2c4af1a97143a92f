// Films as GIF: a fixed palette, and of each frame what differs from the one before.
window.cagelessGif = function (width, height, hundredths) {
  "use strict";
  const SAME = 255, CLEAR = 256, END = 257, CODES = 4096;
  const LEVELS = [6, 7, 6], parts = [];
  const table = new Int16Array(CODES * 256), lookup = new Uint8Array(1 << 15);
  let before = null;

  const word = (value) => [value & 255, value >> 8];
  const colours = new Uint8Array(768);
  for (let r = 0, k = 0; r < 6; r++) for (let g = 0; g < 7; g++) for (let b = 0; b < 6; b++, k++)
    colours.set([r, g, b].map((level, c) => Math.round(level * 255 / (LEVELS[c] - 1))), 3 * k);
  // Nearest colour for five bits of each channel.
  for (let k = 0; k < lookup.length; k++) {
    const [r, g, b] = [k >> 10, (k >> 5) & 31, k & 31].map((v, c) => Math.round(v / 31 * (LEVELS[c] - 1)));
    lookup[k] = (r * 7 + g) * 6 + b;
  }
  parts.push(new Uint8Array([71, 73, 70, 56, 57, 97, ...word(width), ...word(height), 0xF7, 0, 0]), colours,
    // Plays for ever.
    new Uint8Array([0x21, 0xFF, 11, ...Array.from("NETSCAPE2.0", (c) => c.charCodeAt(0)), 3, 1, 0, 0, 0]));

  // Lempel, Ziv and Welch with codes of 9 to 12 bits, in blocks of at most 255 bytes.
  function packed(pixels) {
    const out = new Uint8Array(pixels.length * 2 + 1024), used = [];
    let at = 1, block = 0, bits = 0, count = 0, size = 9, next = END + 1;
    const put = function (byte) {
      out[at++] = byte;
      if (at - block === 256) { out[block] = 255; block = at++; }
    };
    const emit = function (code) {
      bits |= code << count;
      count += size;
      while (count >= 8) { put(bits & 255); bits >>= 8; count -= 8; }
    };
    emit(CLEAR);
    let prefix = pixels[0];
    for (let k = 1; k < pixels.length; k++) {
      const key = prefix << 8 | pixels[k], known = table[key];
      if (known) { prefix = known; continue; }
      emit(prefix);
      if (next === CODES) {
        emit(CLEAR);
        for (const old of used) table[old] = 0;
        used.length = 0;
        size = 9;
        next = END + 1;
      } else {
        if (next >= 1 << size) size++;
        table[key] = next++;
        used.push(key);
      }
      prefix = pixels[k];
    }
    emit(prefix);
    emit(END);
    if (count > 0) put(bits & 255);
    for (const old of used) table[old] = 0;
    out[block] = at - block - 1;
    if (out[block]) out[at++] = 0; else at = block + 1;
    return out.slice(0, at);
  }

  return {
    // Adds a frame given by its red, green, blue and opacity.
    add: function (rgba) {
      const pixels = new Uint8Array(width * height), now = new Uint8Array(width * height);
      for (let k = 0, p = 0; k < now.length; k++, p += 4) {
        now[k] = lookup[(rgba[p] >> 3) << 10 | (rgba[p + 1] >> 3) << 5 | rgba[p + 2] >> 3];
        pixels[k] = before && before[k] === now[k] ? SAME : now[k];
      }
      parts.push(new Uint8Array([0x21, 0xF9, 4, 4 | (before ? 1 : 0), ...word(hundredths), SAME, 0,
        0x2C, 0, 0, 0, 0, ...word(width), ...word(height), 0, 8]), packed(pixels));
      before = now;
    },
    blob: () => new Blob([...parts, new Uint8Array([0x3B])], { type: "image/gif" }),
  };
};
