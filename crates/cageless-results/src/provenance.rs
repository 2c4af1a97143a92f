//! The settings under which a number was computed.

use cageless::Case;
use cageless::dynamics::InstructionSet;
use cageless::film::Film;
use serde::{Deserialize, Serialize};

use crate::number_text::short;
use crate::table::unit::{microseconds, millipascal_seconds};

/// Provenance of a figure or table; printed under it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Provenance {
    /// The case: bearing, structure, speed, load.
    pub case: String,
    /// `paper` or `physical`; `None` where nothing was simulated.
    pub formulation: Option<String>,
    /// Friction law with its scale, for example `smooth, 0.02 m/s`.
    pub friction_law: Option<String>,
    /// Oil film, for example `5 mPa·s, supply 0.65`; `None` without one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub film: Option<String>,
    /// Integration method.
    pub method: Option<String>,
    /// Step, µs.
    pub step_us: Option<f64>,
    /// Discarded transient as a phrase; empty if nothing was discarded.
    pub discarded: String,
}

impl Provenance {
    /// One line: case, formulation, friction law, film, method and step, what was discarded.
    pub fn line(&self) -> String {
        let mut parts = vec![self.case.clone()];
        parts.extend(
            self.formulation
                .as_ref()
                .map(|p| format!("formulation {p}")),
        );
        parts.extend(self.friction_law.as_ref().map(|f| format!("friction {f}")));
        parts.extend(self.film.as_ref().map(|f| format!("film of {f}")));
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
        film: case.film.as_ref().map(film),
        method: Some(case.solver.method.label().to_owned()),
        step_us: Some(microseconds(case.solver.step_s)),
        discarded,
    }
}

/// Oil and supply of a film in a few words.
fn film(film: &Film) -> String {
    let viscosity_mpa_s = millipascal_seconds(film.oil.viscosity_pa_s);
    format!(
        "{} mPa·s, supply {}",
        short(viscosity_mpa_s),
        short(film.supply)
    )
}

#[cfg(test)]
mod tests {
    use cageless::film::{Film, Oil};
    use cageless::reference;

    use super::*;

    #[test]
    fn oil_and_supply_stand_beside_the_friction() {
        let mut case = reference::conventional();
        let line = |case: &Case| provenance("", case, String::new()).line();
        assert!(!line(&case).contains("film"), "{}", line(&case));
        let film = Film::flooded(Oil::mineral(0.005, 0.035));
        case.film = Some(Film {
            supply: 0.65,
            ..film
        });
        let wet = line(&case);
        assert!(wet.contains(" · film of 5 mPa·s, supply 0.65 · "), "{wet}");
    }
}
