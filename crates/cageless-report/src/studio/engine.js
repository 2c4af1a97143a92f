// One protocol, two hosts: a request goes in, progress and an answer come out. The page sees
// only `request`, whether the engine runs in workers of the page or behind a server.

class EngineError extends Error {
  constructor(refusal) {
    super(refusal.message);
    this.line = refusal.line;
    this.key = refusal.key;
  }
}

function unpacked(answer) {
  if (answer.error) throw new EngineError(answer.error);
  return answer.ok;
}

function cancelled() { return new DOMException("cancelled", "AbortError"); }

// The engine in the page: one worker for each lane, so that a verdict does not hold up a motion.
class PageEngine {
  static async open(base64, workerSource) {
    const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
    const url = URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" }));
    return new PageEngine(module, url);
  }

  constructor(module, url) {
    this.name = "in this page (WebAssembly)";
    this.module = module;
    this.url = url;
    this.lanes = new Map();
    this.last = 0;
  }

  lane(name) {
    if (!this.lanes.has(name)) {
      const lane = { worker: new Worker(this.url), waiting: new Map() };
      lane.worker.onmessage = ({ data }) => {
        const waiting = lane.waiting.get(data.id);
        if (!waiting) return;
        if (data.progress !== undefined) { waiting.onProgress(data.progress); return; }
        lane.waiting.delete(data.id);
        if (data.failed) {
          // A trap leaves the memory of the engine in an unknown state.
          this.close(name);
          waiting.reject(new EngineError({ message: "the engine failed: " + data.failed }));
          return;
        }
        try { waiting.resolve(unpacked(JSON.parse(data.answer))); } catch (error) { waiting.reject(error); }
      };
      lane.worker.postMessage({ module: this.module });
      this.lanes.set(name, lane);
    }
    return this.lanes.get(name);
  }

  close(name) {
    const lane = this.lanes.get(name);
    if (!lane) return;
    lane.worker.terminate();
    this.lanes.delete(name);
    lane.waiting.forEach((waiting) => waiting.reject(cancelled()));
  }

  request(lane, request, { onProgress = () => {}, signal } = {}) {
    return new Promise((resolve, reject) => {
      if (signal && signal.aborted) { reject(cancelled()); return; }
      const { worker, waiting } = this.lane(lane);
      const id = ++this.last;
      waiting.set(id, { resolve, reject, onProgress });
      // A worker that computes hears nothing: it is replaced.
      if (signal) signal.addEventListener("abort", () => { if (waiting.has(id)) this.close(lane); }, { once: true });
      worker.postMessage({ id, request: JSON.stringify(request) });
    });
  }
}

// The engine behind `cageless studio`.
class ServerEngine {
  constructor(token) {
    this.name = "native, all cores (cageless studio)";
    this.token = token;
  }

  async request(_lane, request, { onProgress = () => {}, signal } = {}) {
    let response;
    try {
      response = await fetch("request", {
        method: "POST", signal, body: JSON.stringify(request),
        headers: { "Content-Type": "application/json", "X-Cageless-Token": this.token },
      });
    } catch (error) {
      if (error.name === "AbortError") throw error;
      throw new ServerGone();
    }
    if (!response.ok) throw new EngineError({ message: await response.text() });
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    let text = "";
    for (;;) {
      let part;
      try { part = await reader.read(); } catch (error) {
        if (error.name === "AbortError") throw error;
        throw new ServerGone();
      }
      if (part.done) throw new ServerGone();
      text += part.value;
      const lines = text.split("\n");
      text = lines.pop();
      for (const line of lines) {
        const message = JSON.parse(line);
        if (message.progress !== undefined) onProgress(message.progress);
        else return unpacked(message);
      }
    }
  }
}

// What no engine of a page computes.
const SERVER_ONLY = ["search", "tolerance", "export"];

class ServerGone extends Error {
  constructor() { super("the server of cageless studio has ended"); }
}

// The server's engine while it runs, else the page's own.
class Engine {
  constructor(server, page, onHost) {
    this.server = server;
    this.page = page;
    this.onHost = onHost;
    onHost(this.host(), false);
  }

  host() { return this.server || this.page; }

  async request(lane, request, options) {
    try {
      return await this.host().request(lane, request, options);
    } catch (error) {
      if (!(error instanceof ServerGone) || !this.page) throw error;
      this.server = null;
      this.onHost(this.page, true);
      if (SERVER_ONLY.includes(request.op)) throw error;
      return this.page.request(lane, request, options);
    }
  }
}
