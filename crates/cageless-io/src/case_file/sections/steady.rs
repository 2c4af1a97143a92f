//! `[steady]`.

use cageless::steady::{BenefitWeights, SteadyOperation, SteadyStart};

use crate::case_file::declaration::prelude::*;

section! {
    /// `[steady]`: steady operation with real balls, by which `compare` judges rings.
    struct SteadySection {
        grade => grade: u64 = default(i64::from(SteadyOperation::default().grade.number)), Plain,
            "grade of the balls by ISO 3290-1: radii evenly within a lot, unless bearing.ball_radius_deviation_um gives them",
            Commented("10", "grade of the balls by ISO 3290-1");
        start => start: SteadyStart = default(SteadyStart::Queue.name()), Plain,
            "start: all balls in the queue in which a conventional ring ends, or random gaps",
            Commented("\"queue\"", "all balls behind one, as a conventional ring ends; or \"random\"");
        transient_orbits => transient_orbits: f64 = default(SteadyOperation::default().transient_orbits), Plain; AtLeast(0.0),
            "orbits of the balls that are left out", Commented("120.0", "orbits of the balls that are left out");
        measured_orbits => measured_orbits: f64 = default(SteadyOperation::default().measured_orbits), Plain; Above(0.0),
            "orbits of the balls that are measured", Commented("320.0", "orbits of the balls that are measured");
        weight_contacts => weight_contacts: f64 = default(BenefitWeights::default().contacts), Plain; AtLeast(0.0),
            "weight of fewer contacts in the benefit of a remedy", Commented("1.0", "weight of fewer contacts in the benefit");
        weight_spacing => weight_spacing: f64 = default(BenefitWeights::default().spacing), Plain; AtLeast(0.0),
            "weight of even spacing in the benefit of a remedy", Commented("1.0", "weight of even spacing");
        weight_force => weight_force: f64 = default(BenefitWeights::default().force), Plain; AtLeast(0.0),
            "weight of a steady force on the outer ring in the benefit of a remedy", Commented("1.0", "weight of a steady force on the outer ring");
    }
}
