//! JSON schemas of editors, from the declarations of case files, rotor files and plans.
//! `CAGELESS_WRITE=1 cargo test -p cageless-io --test all derived_files` writes them after a key was added.

use cageless_io::case_file::{self, Key, Kind, Presence, SCHEMA, SectionTable};
use cageless_io::plan_file::{self, Scale};
use cageless_io::rotor_file;
use serde_json::{Map, Value, json};

use crate::derived_files::in_step;

/// JSON schema of the value of a key.
fn schema_of(section: &SectionTable, key: &Key) -> serde_json::Value {
    let [low, high] = section.range(key);
    let ends = [
        (low, ["exclusiveMinimum", "minimum"]),
        (high, ["exclusiveMaximum", "maximum"]),
    ];
    let number = |kind: &str| {
        let mut number = json!({ "type": kind });
        for (end, names) in ends {
            if let Some(end) = end {
                number[names[usize::from(end.included)]] = json!(end.at);
            }
        }
        number
    };
    let list = |items: Value| json!({ "type": "array", "items": items });
    let row =
        |items: Value| json!({ "type": "array", "items": items, "minItems": 2, "maxItems": 2 });
    let plain = json!({ "type": "number" });
    let any_of = |one: Value, other: Value| json!({ "anyOf": [one, other] });
    let mut schema = match key.kind {
        Kind::Number => number("number"),
        Kind::Whole => number("integer"),
        Kind::Text => json!({ "type": "string" }),
        Kind::Numbers => list(number("number")),
        Kind::Range => any_of(number("number"), row(number("number"))),
        Kind::OverTime => any_of(number("number"), list(row(plain))),
        Kind::Rows(_) => list(row(plain)),
        Kind::Choice(names) => json!({ "enum": names() }),
        Kind::NumberOr(names) => any_of(json!({ "enum": names }), number("number")),
        Kind::NumbersOr(names) => any_of(json!({ "enum": names }), list(number("number"))),
    };
    let unit = match key.unit().as_str() {
        "" => String::new(),
        unit => format!(" ({unit})"),
    };
    if (section.name, key.name) == ("", "schema") {
        schema = json!({ "const": SCHEMA });
    }
    schema["description"] = json!(format!("{}{unit}", key.meaning));
    if let Presence::Default(value) = (key.presence)() {
        schema["default"] = json!(value);
    }
    schema
}

/// JSON schema of a section.
fn schema_of_section(section: &SectionTable) -> serde_json::Value {
    let mut keys = Map::new();
    for key in section.keys {
        keys.insert(key.name.to_owned(), schema_of(section, key));
        if !key.formerly.is_empty() {
            let mut former = schema_of(section, key);
            former["deprecated"] = json!(true);
            former["description"] = json!(format!("former name of {}", key.name));
            keys.insert(key.formerly.to_owned(), former);
        }
    }
    let required = section.keys.iter();
    let required = required.filter(|key| key.is_required() && key.formerly.is_empty());
    let required: Vec<_> = required.map(|key| key.name).collect();
    json!({
        "type": "object",
        "description": section.meaning,
        "properties": keys,
        "required": required,
        "additionalProperties": false,
    })
}

/// One section, or several in a list.
fn several(one: &Value) -> Value {
    json!({ "anyOf": [one, { "type": "array", "items": one }] })
}

/// One section, several in a list, or several by their numbers: `[bearing.1]`.
fn numbered(one: &Value) -> Value {
    let mut schema = several(one);
    let numbers = json!({
        "type": "object",
        "patternProperties": { "^[0-9]+$": one },
        "additionalProperties": false,
        "minProperties": 1,
    });
    schema["anyOf"].as_array_mut().unwrap().push(numbers);
    schema
}

/// The path of a file, or its content.
fn file_or_section(of: &Value) -> Value {
    json!({ "anyOf": [{ "type": "string" }, { "type": "object" }], "description": of["description"] })
}

/// JSON schema of a file: of its head, with its sections.
fn of_file(
    title: &str,
    description: &str,
    required: &[&str],
    mut sections: impl Iterator<Item = SectionTable>,
) -> Value {
    let mut schema = schema_of_section(&sections.next().unwrap());
    for section in sections {
        let one = schema_of_section(&section);
        schema["properties"][section.name] = match section.several {
            true => several(&one),
            false => one,
        };
    }
    schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
    schema["title"] = json!(title);
    schema["description"] = json!(description);
    schema["required"] = json!(required);
    schema
}

fn of_case_files() -> Value {
    of_file(
        "Case file of Cageless",
        "one bearing, its operating conditions and the simulation",
        &["bearing"],
        case_file::reference(),
    )
}

fn of_rotor_files() -> Value {
    let description =
        "a rotor, its unbalances and clearances, and the case of each of its bearings";
    let sections = rotor_file::reference();
    let mut schema = of_file(
        "Rotor file of Cageless",
        description,
        &["rotor", "bearing"],
        sections,
    );
    let sections = &mut schema["properties"];
    let matrices = file_or_section(&sections["rotor"]["properties"]["matrices"]);
    sections["rotor"]["properties"]["matrices"] = matrices;
    for name in ["bearing", "unbalance", "clearance"] {
        let mut one = sections[name]["anyOf"][0].clone();
        if name == "bearing" {
            one["properties"]["case"] = file_or_section(&one["properties"]["case"]);
        }
        sections[name] = numbered(&one);
    }
    schema
}

/// Keys of the base of a plan below one of its sections, each with this value; a section may have
/// numbers, `[raceway.2]`, and a key may be written in quotes, `"solver.duration_s"`.
fn keys_of_base(value: impl Fn(&SectionTable, &Key) -> Value) -> Map<String, Value> {
    let mut sections = Map::new();
    for section in case_file::reference().chain(rotor_file::reference()) {
        if section.name.is_empty() || section.name == "search" {
            continue;
        }
        let one = sections.entry(section.name).or_insert_with(|| {
            json!({
                "type": "object",
                "properties": {},
                "patternProperties": { "^[0-9]+$": { "type": "object" }, "\\.": true },
                "additionalProperties": false,
            })
        });
        for key in section.keys {
            let former = [key.formerly].into_iter().filter(|name| !name.is_empty());
            for name in former.chain([key.name]) {
                one["properties"][name] = value(&section, key);
            }
        }
    }
    sections
}

fn of_plans() -> Value {
    let description = "a case or a rotor file, what varies in it and what a sweep computes of it";
    let sections = plan_file::reference();
    let mut schema = of_file(
        "Plan of Cageless",
        description,
        &["case", "compute"],
        sections,
    );
    let keys = &mut schema["properties"];
    keys["case"] = file_or_section(&keys["case"]);
    let list = |items: &Value| json!({ "type": "array", "items": items, "minItems": 1 });
    let described = |mut schema: Value, of: &Value| {
        schema["description"] = of["description"].clone();
        schema
    };
    let computation = json!({ "enum": keys["compute"]["enum"] });
    keys["compute"] = described(list(&computation), &keys["compute"]);
    keys["keep"] = described(list(&json!({ "type": "string" })), &keys["keep"]);
    let scales: Vec<_> = Scale::NAMES.iter().map(|(name, _)| *name).collect();
    let axis = |count: bool| {
        let number = json!({ "type": "number" });
        let mut range = json!({
            "type": "object",
            "properties": { "from": number, "to": number, "scale": { "enum": scales } },
            "required": ["from", "to"],
            "additionalProperties": false,
        });
        if count {
            range["properties"]["count"] = json!({ "type": "integer", "minimum": 2 });
            range["required"] = json!(["from", "to", "count"]);
        }
        json!({ "anyOf": [list(&json!({ "type": ["number", "string"] })), range] })
    };
    let width = json!({ "type": "number", "minimum": 0 });
    let law = |gaps: bool| {
        let of = |name: &str| {
            json!({
                "type": "object",
                "properties": { name: width },
                "required": [name],
                "additionalProperties": false,
            })
        };
        let mut laws = vec![of("normal"), of("uniform")];
        if gaps {
            laws.push(json!({ "enum": ["random"] }));
        }
        json!({ "anyOf": laws })
    };
    let gaps = |key: &Key| key.name == "gaps";
    schema["definitions"] = json!({
        "axis": axis(true),
        "axis_of_samples": axis(false),
        "law": law(false),
        "law_of_gaps": law(true),
    });
    let defined = |name: &str| json!({ "$ref": format!("#/definitions/{name}") });
    let below = [
        ("set", keys_of_base(schema_of)),
        ("grid", keys_of_base(|_, _| defined("axis"))),
        ("samples", keys_of_base(|_, _| defined("axis_of_samples"))),
        (
            "scatter",
            keys_of_base(|_, key| defined(if gaps(key) { "law_of_gaps" } else { "law" })),
        ),
    ];
    let keys = &mut schema["properties"];
    for (name, sections) in below {
        let section = &mut keys[name];
        for (of, keys) in sections {
            section["properties"][of] = keys;
        }
        section["patternProperties"] = json!({ "\\.": true });
    }
    schema
}

#[test]
fn editors_have_the_schemas_of_files() {
    for (name, schema) in [
        ("case-file", of_case_files()),
        ("rotor-file", of_rotor_files()),
        ("plan", of_plans()),
    ] {
        let text = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        for folder in ["docs", "crates/cageless-py/python/cageless/schemas"] {
            in_step(&format!("{folder}/{name}.schema.json"), &text);
        }
    }
}
