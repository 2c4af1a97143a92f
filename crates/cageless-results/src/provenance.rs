//! The settings under which a number was computed.

use cageless::Case;
use cageless::dynamics::InstructionSet;
use serde::{Deserialize, Serialize};

use crate::number_text::short;
use crate::table::unit::microseconds;

/// Provenance of a figure or table; printed under it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Provenance {
    /// The case: bearing, structure, speed, load.
    pub case: String,
    /// `paper` or `physical`; `None` where nothing was simulated.
    pub formulation: Option<String>,
    /// Friction law with its scale, for example `smooth, 0.02 m/s`.
    pub friction_law: Option<String>,
    /// Integration method.
    pub method: Option<String>,
    /// Step, µs.
    pub step_us: Option<f64>,
    /// Discarded transient as a phrase; empty if nothing was discarded.
    pub discarded: String,
}

impl Provenance {
    /// One line: case, formulation, friction law, method and step, what was discarded.
    pub fn line(&self) -> String {
        let mut parts = vec![self.case.clone()];
        parts.extend(
            self.formulation
                .as_ref()
                .map(|p| format!("formulation {p}")),
        );
        parts.extend(self.friction_law.as_ref().map(|f| format!("friction {f}")));
        match (&self.method, self.step_us) {
            (Some(method), Some(step)) => parts.push(format!("{method}, step {} µs", short(step))),
            (Some(method), None) => parts.push(method.clone()),
            (None, Some(step)) => parts.push(format!("step {} µs", short(step))),
            (None, None) => {}
        }
        if self.formulation.is_none() {
            parts.push("geometry alone, nothing simulated".to_owned());
        } else if self.discarded.is_empty() {
            parts.push("nothing discarded".to_owned());
        } else {
            parts.push(format!("discarded: {}", self.discarded));
        }
        parts.retain(|part| !part.is_empty());
        parts.join(" · ")
    }
}

/// Program and instruction set that compute.
pub fn software() -> String {
    let version = env!("CARGO_PKG_VERSION");
    format!("Cageless {version}, {}", instruction_set())
}

/// Vector instructions that runs are computed with.
pub fn instruction_set() -> &'static str {
    if cfg!(target_feature = "simd128") {
        return "simd128";
    }
    InstructionSet::chosen().name()
}

/// Provenance of a simulated figure; `title` is that of the case.
pub fn provenance(title: &str, case: &Case, discarded: String) -> Provenance {
    Provenance {
        case: title.to_owned(),
        formulation: Some(case.formulation.name().to_owned()),
        friction_law: Some(case.describe_friction()),
        method: Some(case.solver.method.properties().label.to_owned()),
        step_us: Some(microseconds(case.solver.step_s)),
        discarded,
    }
}
