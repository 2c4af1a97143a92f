//! Initial state of a case.

use cageless::{Bearing, Gaps, Start, StartState};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::fields::GivenGaps;
use crate::case_file::named::StartKind;

impl Converter<'_> {
    pub(in crate::case_file) fn start(&self, bearing: &Bearing) -> Result<Start, CaseError> {
        let s = &self.sections.start;
        let gaps = match &s.gaps {
            GivenGaps::Uniform => Gaps::Uniform,
            GivenGaps::Bunched => Gaps::bunched(bearing),
            GivenGaps::Random => Gaps::random(bearing, self.sections.solver.seed),
            GivenGaps::List(list) => Gaps::List(list.clone()),
        };
        if s.state != StartKind::Rolling {
            for key in ["start.ring_x_um", "start.ring_y_um"] {
                if self.document.has(key) {
                    let allowed = "left out unless start.state = \"rolling\": other starts \
                                   find the place of the ring themselves";
                    return Err(self.refuse(key, allowed));
                }
            }
        }
        let state = match s.state {
            StartKind::Settled => StartState::Settled,
            StartKind::AtRest => StartState::AtRest,
            StartKind::Rolling => StartState::Rolling {
                ring_x_m: s.ring_x_m.unwrap_or(0.0),
                ring_y_m: s.ring_y_m.unwrap_or(0.0),
            },
        };
        Ok(Start::new(state, gaps, s.lead_ball_angle_rad))
    }
}
