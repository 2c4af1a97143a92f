// Runs the WebAssembly engine beside the page: one request at a time.
"use strict";
let exports = null;
let current = 0;

onmessage = async function (event) {
  const { id, module, request } = event.data;
  if (module) {
    const progress = (fraction) => { postMessage({ id: current, progress: fraction }); return 0; };
    exports = (await WebAssembly.instantiate(module, { page: { progress } })).exports;
    return;
  }
  current = id;
  try {
    const text = new TextEncoder().encode(request);
    const at = exports.cageless_alloc(text.length);
    new Uint8Array(exports.memory.buffer, at, text.length).set(text);
    const answer = exports.cageless_request(at, text.length) >>> 0;
    exports.cageless_free(at, text.length);
    const length = new DataView(exports.memory.buffer).getUint32(answer, true);
    const json = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, answer + 4, length));
    exports.cageless_free(answer, length + 4);
    postMessage({ id, answer: json });
  } catch (error) {
    postMessage({ id, failed: String(error && error.message || error) });
  }
};
