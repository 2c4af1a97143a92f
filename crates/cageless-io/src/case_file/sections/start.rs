//! `[start]`.

use crate::case_file::declaration::section;
use crate::case_file::fields::GapsDocument;
use crate::case_file::key::Line::Commented;
use crate::case_file::key::Presence::{Default, Optional};
use crate::case_file::named::StartState;
use crate::case_file::reader::Reader;
use crate::case_file::unit::Unit::{Degree, Micrometre, None as Plain};

section! {
    /// `[start]`: the initial state.
    StartDocument {
        state -> state: StartState = Default(StartState::Settled), Plain,
            "kind of initial state; \"at-rest\" with a [rotor] unless given",
            Commented("\"settled\"", "static equilibrium at speed, balls rolling; or\n\
                \"rolling\": balls on the pitch circle, ring where put");
        ring_x_um => ring_x_m: Option<f64> = Optional, Micrometre,
            "centre of the inner ring, only for \"rolling\", there 0 by default",
            Commented("0.0", "centre of the inner ring, only for \"rolling\"");
        ring_y_um => ring_y_m: Option<f64> = Optional, Micrometre,
            "centre of the inner ring, only for \"rolling\", there 0 by default",
            Commented("0.0", "");
        gaps => gaps: GapsDocument = Default(GapsDocument::Uniform), Degree,
            "gaps between neighbouring balls: equal, all balls in one group, random by solver.seed, or a list",
            Commented("\"uniform\"", "\"bunched\" (one group), \"random\" (by seed) or a list,\n\
                one gap in degrees per ball, to the ball ahead");
        lead_ball_angle_deg => lead_ball_angle_rad: f64 = Default(0.0), Degree,
            "initial position of ball 1", Commented("0.0", "initial position ψ of ball 1");
    }
}

impl StartDocument {
    /// Fills in what follows from other keys of the section.
    pub(in crate::case_file) fn complete(&mut self, rotor: bool, reader: &mut Reader<'_>) {
        if rotor && reader.get("state").is_none() {
            self.state = StartState::AtRest;
        }
        if self.state == StartState::Rolling {
            for (name, value) in [
                ("ring_x_um", &mut self.ring_x_um),
                ("ring_y_um", &mut self.ring_y_um),
            ] {
                value.get_or_insert_with(|| {
                    reader.note_default(name);
                    0.0
                });
            }
        }
    }
}
