//! `[start]`.

use crate::case_file::declaration::prelude::*;
use crate::case_file::fields::GivenGaps;
use crate::case_file::named::StartKind;

section! {
    /// `[start]`: the initial state.
    struct StartSection {
        state => state: StartKind = default(StartKind::Settled.name()), Plain,
            "kind of initial state; \"at-rest\" with a [rotor] unless given",
            Commented("\"settled\"", "static equilibrium at speed, balls rolling; or\n\
                \"rolling\": balls on the pitch circle, ring where put");
        ring_x_um => ring_x_m: Option<f64> = Optional, Micrometre,
            "centre of the inner ring, only for \"rolling\", there 0 by default",
            Commented("0.0", "centre of the inner ring, only for \"rolling\"");
        ring_y_um => ring_y_m: Option<f64> = Optional, Micrometre,
            "centre of the inner ring, only for \"rolling\", there 0 by default",
            Commented("0.0", "");
        gaps => gaps: GivenGaps = default("uniform"), Degree,
            "gaps between neighbouring balls: equal, all balls in one group, random by solver.seed, or a list; the same in every [[row]]",
            Commented("\"uniform\"", "\"bunched\" (one group), \"random\" (by seed) or a list,\n\
                one gap in degrees per ball, to the ball ahead");
        lead_ball_angle_deg => lead_ball_angle_rad: f64 = default(0.0), Degree,
            "initial position of ball 1", Commented("0.0", "initial position ψ of ball 1");
    }
}
