//! Hertz pressures over the 4200 MPa of ISO 76.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, MEGAPASCAL, Requirement};

const BOUND: Bound = Bound {
    limit: 1.0,
    verdict: RacewayVerdict::Overloaded,
    cause: CauseKind {
        name: "stress",
        meaning: "contact pressure above 4200 MPa (ISO 76)",
        remedy: "a lower load",
    },
};

const PRESSURE: Requirement = Requirement {
    most: Some(BOUND),
    unit: &MEGAPASCAL,
    limit_of: " of ISO 76",
    unknown: "the contact pressure",
    power: 3,
    ..Requirement::PERCENT
};

/// Largest pressure at rest.
pub(crate) static PRESSURE_AT_REST: Requirement = Requirement {
    name: "pressure",
    sentence: |_| "the contact pressure at rest reaches {}",
    ..PRESSURE
};

/// Largest pressure of a run, between balls as well.
pub(crate) static PEAK_PRESSURE: Requirement = Requirement {
    name: "peak-pressure",
    sentence: |_| "the contact pressure of the motion reaches {}",
    largest_counts: true,
    ..PRESSURE
};
