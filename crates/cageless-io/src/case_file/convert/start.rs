//! Initial state of a case.

use cageless::numerics::random::RandomStream;
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
            GivenGaps::Bunched => Gaps::List(bunched(bearing)),
            GivenGaps::Random => Gaps::List(random(bearing, self.sections.solver.seed)),
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
