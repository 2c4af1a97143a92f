// Undo, files and copies of the case.

class Toolbar {
  constructor(studio) {
    this.undo = button("Undo", () => studio.back(studio.undo, studio.redo), { "data-undo": true });
    this.redo = button("Redo", () => studio.back(studio.redo, studio.undo), { "data-redo": true });
    const file = element("input", { type: "file", accept: ".toml,text/plain", hidden: true, onchange: async () => { if (file.files[0]) studio.edit(await file.files[0].text()); file.value = ""; } });
    const copy = (label, make) => button(label, async (event) => {
      const text = await make();
      studio.copied = text;
      try { await navigator.clipboard.writeText(text); } catch { studio.root.dispatchEvent(new CustomEvent("copy-failed")); prompt("Copy this text:", text); }
      event.target.textContent = "Copied";
      setTimeout(() => { event.target.textContent = label; }, 1200);
    });
    this.root = element("div", { class: "bar", role: "toolbar", "aria-label": "Case" }, this.undo, this.redo,
      button("As computed", () => studio.edit(studio.original), { title: "back to the case of this page", "data-original": true }),
      button("Open…", () => file.click()), file,
      copy("Copy TOML", () => studio.toml), copy("Copy command", () => asCommand(studio.toml)), copy("Copy Python", () => asPython(studio.toml)),
      copy("Copy link", async () => location.href.split("#")[0] + "#case=" + (await packed(studio.toml))));
    studio.root.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.target === studio.text) return;
      const key = event.key.toLowerCase();
      if (key === "z" && !event.shiftKey) { studio.back(studio.undo, studio.redo); event.preventDefault(); }
      if (key === "y" || (key === "z" && event.shiftKey)) { studio.back(studio.redo, studio.undo); event.preventDefault(); }
    });
  }

  show(studio) {
    this.undo.disabled = !studio.undo.length;
    this.redo.disabled = !studio.redo.length;
  }
}
