// Materials of balls and rings: one with a name, or what the file says.

const MATERIAL_PARTS = [
  { id: "balls", section: "ball_material", label: "Balls" },
  { id: "rings", section: "ring_material", label: "Rings" },
];

// `text` with the named material in `section`, in place of its numbers; without the section if
// no name is given.
function withMaterial(text, section, name) {
  const rest = without(text, section).replace(/\n*$/, "\n");
  return name ? rest + "\n[" + section + "]\npreset = " + written(name) + "\n" : rest;
}

class MaterialChoice {
  constructor(studio, { id, section, label }) {
    this.section = section;
    this.select = element("select", {
      id: "studio-material-" + id, "data-material": id,
      onchange: () => studio.edit(withMaterial(studio.toml, section, this.select.value)),
    });
    this.root = element("div", { class: "control choice" }, element("label", { for: this.select.id }, label), this.select);
    this.numbers = (m) => shown(m.density_kg_m3, 0) + " kg/m³, E " + shown(m.youngs_modulus_gpa, 0) + " GPa, ν " + shown(m.poisson_ratio, 2);
    this.ready = studio.about.then((about) => {
      this.select.append(element("option", { value: "" }), ...about.materials.map((m) => element("option", { value: m.name, title: this.numbers(m) }, m.name)),
        element("option", { value: "own", disabled: true }, "numbers of the file"));
      if (studio.g) this.show(studio.g);
    }, () => {});
  }

  show({ document: d }) {
    if (!this.select.options.length) return;
    const own = d[this.section], common = d.material || {};
    this.select.options[0].textContent = "as [material]: " + (common.preset || this.numbers(common));
    this.select.value = !own ? "" : own.preset || "own";
  }
}
