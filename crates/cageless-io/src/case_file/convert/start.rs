//! Initial state of a case.

use cageless::numerics::random::RandomStream;
use cageless::{Bearing, Gaps, Start};

use crate::case_file::converter::Converter;
use crate::case_file::declaration::Field;
use crate::case_file::error::CaseError;
use crate::case_file::fields::GapsDocument;
use crate::case_file::named::StartState;

impl Converter<'_> {
    pub(in crate::case_file) fn start(&self, bearing: &Bearing) -> Result<Start, CaseError> {
        let s = &self.document.start;
        let gaps = match (&s.gaps, s.gaps.si(&|value| self.si("start.gaps", value))?) {
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
