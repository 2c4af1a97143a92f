//! `[start]`.

use cageless::numerics::random::RandomStream;
use cageless::{Bearing, Gaps, Start};

use crate::case_file::CaseError;
use crate::case_file::convert::Converter;
use crate::case_file::declaration::Field;
use crate::case_file::declaration::Line::Commented;
use crate::case_file::declaration::Presence::{Default, Optional};
use crate::case_file::declaration::section;
use crate::case_file::document::{GapsDocument, StartState};
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

impl Converter<'_> {
    pub(in crate::case_file) fn start(&self, bearing: &Bearing) -> Result<Start, CaseError> {
        let s = &self.document.start;
        let gaps = match (&s.gaps, s.gaps.si(self, "start.gaps")?) {
            (_, Some(list)) => Gaps::List(list),
            (GapsDocument::Bunched, _) => Gaps::List(bunched(bearing)),
            (GapsDocument::Random, _) => Gaps::List(random(bearing, self.seed()?)),
            _ => Gaps::Uniform,
        };
        let lead_ball_angle_rad = self.si("start.lead_ball_angle_deg", s.lead_ball_angle_deg)?;
        match s.state {
            StartState::Settled | StartState::AtRest => {
                for (key, value) in [
                    ("start.ring_x_um", s.ring_x_um),
                    ("start.ring_y_um", s.ring_y_um),
                ] {
                    if let Some(value) = value {
                        let allowed = "left out unless start.state = \"rolling\": other starts \
                                       find the place of the ring themselves";
                        return Err(self.refuse(key, &value.to_string(), allowed));
                    }
                }
                if s.state == StartState::AtRest {
                    return Ok(Start::AtRest {
                        gaps,
                        lead_ball_angle_rad,
                    });
                }
                Ok(Start::Settled {
                    gaps,
                    lead_ball_angle_rad,
                })
            }
            StartState::Rolling => Ok(Start::Rolling {
                gaps,
                lead_ball_angle_rad,
                ring_x_m: self.si("start.ring_x_um", s.ring_x_um.unwrap_or(0.0))?,
                ring_y_m: self.si("start.ring_y_um", s.ring_y_um.unwrap_or(0.0))?,
            }),
        }
    }
}

/// Angle that the balls leave free.
fn room_rad(bearing: &Bearing) -> f64 {
    bearing.balls() as f64 * bearing.mean_gap_rad()
}

/// Balls in one group, which begins with ball 1.
fn bunched(bearing: &Bearing) -> Vec<f64> {
    let mut gaps = vec![0.0; bearing.balls()];
    if let Some(last) = gaps.last_mut() {
        *last = room_rad(bearing);
    }
    gaps
}

/// Gaps of which every division of the free angle is equally likely: exponential numbers over
/// their sum.
fn random(bearing: &Bearing, seed: u64) -> Vec<f64> {
    /// Number of this use of random numbers among all.
    const START: u64 = 101;
    let mut stream = RandomStream::new(seed, START, 0, 0);
    let shares: Vec<_> = (0..bearing.balls()).map(|_| stream.exponential()).collect();
    let scale = room_rad(bearing) / shares.iter().sum::<f64>();
    shares.iter().map(|share| share * scale).collect()
}
