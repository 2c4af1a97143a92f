//! Version of the engine, and its knowledge of case files.

use cageless::RacewayShape;
use cageless_io::case_file::{MaterialPreset, drop_template, keys, template};
use cageless_results::instruction_set;
use serde_json::{Value, json};

/// Operations of the engine.
pub(crate) const OPERATIONS: [&str; 8] = [
    "about", "geometry", "ranges", "map", "static", "motion", "verdict", "compare",
];

/// Version, instruction set, the templates of a case, every key with unit and meaning, the
/// materials that have a name, and the shapes of a raceway that need no profile.
pub(crate) fn about() -> Value {
    let keys: Vec<Value> = keys()
        .map(|(name, k)| json!({ "key": name, "unit": k.unit(), "meaning": k.meaning }))
        .collect();
    let materials: Vec<Value> = MaterialPreset::all()
        .map(|(name, preset)| {
            let [density_kg_m3, youngs_modulus_gpa, poisson_ratio] = preset.numbers();
            json!({
                "name": name, "density_kg_m3": density_kg_m3,
                "youngs_modulus_gpa": youngs_modulus_gpa, "poisson_ratio": poisson_ratio,
            })
        })
        .collect();
    let shapes = RacewayShape::by_dimensions();
    let shapes: Vec<&str> = shapes.map(RacewayShape::name).collect();
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "instruction_set": instruction_set(),
        "operations": OPERATIONS,
        "keys": keys,
        "materials": materials,
        "shapes": shapes,
        "template": template(false),
        "drop": drop_template(),
        "template_conventional": template(true),
    })
}
