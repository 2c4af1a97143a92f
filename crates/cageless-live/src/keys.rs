//! What the engine knows about itself and about case files.

use cageless::dynamics::InstructionSet;
use cageless_io::case_file::{keys, template};
use serde_json::{Value, json};

/// Version, instruction set, the templates of a case and every key with unit and meaning.
pub(crate) fn about() -> Value {
    let keys: Vec<Value> = keys()
        .map(|k| json!({ "key": k.name, "unit": k.unit, "meaning": k.meaning }))
        .collect();
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "instruction_set": InstructionSet::chosen().name(),
        "keys": keys,
        "template": template(false),
        "template_conventional": template(true),
    })
}
