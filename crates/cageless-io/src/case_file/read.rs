//! Completion of a document: its keys are known, none is missing, and defaults are filled in.

use cageless::{FlankModel, Formulation, FrictionModel};

use super::document::CaseDocument;
use super::error::CaseError;
use super::missing;
use super::sections::material::NUMBERS;
use super::sections::{CASE_FILE, bearing};
use super::spanned_toml::{Node, Section, Value, join};
use super::value::CaseValue;

/// More discrete raceways than fit into any ring that balls roll in.
const RACEWAYS_MAX: usize = 64;

/// Completes a document; the dotted keys that took their default.
pub(super) fn complete(document: &mut CaseDocument) -> Result<Vec<String>, CaseError> {
    CASE_FILE.check_names(&document.tree)?;
    missing::check(document)?;
    move_seed(document)?;
    let raceways = document.count("raceway");
    if raceways > RACEWAYS_MAX {
        let message = format!(
            "{raceways} sections [[raceway]] are not possible: there may be at most {RACEWAYS_MAX}"
        );
        let first = format!("raceway.{}", RACEWAYS_MAX + 1);
        return Err(document.tree.error(&first, message).with_key("raceway"));
    }
    let mut defaults = CASE_FILE.fill_in(&mut document.tree)?;
    complete_sections(document, &mut defaults);
    Ok(defaults)
}

/// Fills in what follows from other keys of a section.
fn complete_sections(document: &mut CaseDocument, defaults: &mut Vec<String>) {
    let assumed = bearing::conformities(&document.tree).into_iter();
    defaults.extend(
        assumed
            .filter(|(_, assumed)| *assumed)
            .map(|(key, _)| key.to_owned()),
    );
    let is_default = |key: &str, defaults: &[String]| defaults.iter().any(|d| d == key);
    // The last μ of a friction table is that of fast sliding.
    let coefficient = "contact.friction_coefficient";
    if let (Some(CaseValue::Table(rows)), true) = (
        document.value("contact.friction_table"),
        is_default(coefficient, defaults),
    ) && let Some([_, last]) = rows.last()
    {
        document.set(coefficient, *last);
    }
    // A preset takes the place of the three numbers.
    if document.has("material.preset") {
        for key in NUMBERS.map(|name| join("material", name)) {
            if is_default(&key, defaults) {
                document.remove(&key);
                defaults.retain(|d| *d != key);
            }
        }
    }
    let published = document.value("model.formulation") == Some(Formulation::Paper.name().into());
    let law = document.value("contact.friction_law");
    let sticks = FrictionModel::NAMES
        .iter()
        .any(|(name, of)| of.sticks() && law == Some((*name).into()));
    if is_default("model.flanks", defaults) && (published || sticks) {
        document.set("model.flanks", FlankModel::Rigid.name());
    }
    if document.count("rotor") > 0 && is_default("start.state", defaults) {
        document.set("start.state", "at-rest");
    }
    if document.value("start.state") == Some("rolling".into()) {
        for key in ["start.ring_x_um", "start.ring_y_um"] {
            if !document.has(key) {
                document.set(key, 0.0);
                defaults.push(key.to_owned());
            }
        }
    }
}

/// Puts a seed at the head of the file into its section.
fn move_seed(document: &mut CaseDocument) -> Result<(), CaseError> {
    let root = &mut document.tree.root;
    let Some(seed) = root.remove("seed") else {
        return Ok(());
    };
    let solver = root.entry("solver".to_owned()).or_insert(Node {
        value: Value::Section(Section::new()),
        place: seed.place.clone(),
    });
    let Value::Section(solver) = &mut solver.value else {
        return Ok(());
    };
    match solver.insert("seed".to_owned(), seed) {
        None => Ok(()),
        Some(_) => {
            let why = "solver.seed is at the head of the file as well: drop one";
            Err(document.tree.error("solver.seed", why.to_owned()))
        }
    }
}
