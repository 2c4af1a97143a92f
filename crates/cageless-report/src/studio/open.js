// A studio in its place on the page, with the engine that is there.

async function openStudio(root) {
  const read = (name) => { const el = root.querySelector("script[data-" + name + "]"); return el ? el.textContent : ""; };
  const given = JSON.parse(read("case")), base64 = read("engine").trim(), worker = document.querySelector("script[data-worker]").textContent;
  const token = new URLSearchParams(location.search).get("token");
  const server = token && location.protocol.startsWith("http") ? new ServerEngine(token) : null;
  let page = null, why = "";
  if (base64) {
    try { page = await PageEngine.open(base64, worker); } catch (error) { why = "this browser cannot run the engine (" + error.message + ")"; }
  } else why = "Cageless was built without the target wasm32-unknown-unknown, so this page has no engine of its own";
  if (!server && !page) {
    root.textContent = "Nothing can be changed here: " + why + ". The command cageless studio computes natively.";
    root.classList.add("note", "warning");
    return;
  }
  let toml = given;
  const linked = /[#&]case=([\w-]+)/.exec(location.hash);
  if (linked) { try { toml = await unpackedText(linked[1]); } catch { /* a link that was cut off */ } }
  let studio = null;
  const told = [];
  const engine = new Engine(server, page, (host, changed) => { if (studio) studio.host(host, changed); else told.push([host, changed]); });
  studio = new Studio(root, engine, toml);
  studio.original = given;
  told.forEach(([host, changed]) => studio.host(host, changed));
  window.cagelessStudio = studio;
}

// In a report the studio waits until its reader asks for it.
for (const root of document.querySelectorAll("[data-studio]")) {
  // A link to a changed case opens it at once.
  if (root.dataset.studio === "now" || location.hash.startsWith("#case=")) openStudio(root);
  else root.append(button("Change values of this case", (event) => { event.target.remove(); openStudio(root); }, { "data-open": true }));
}
