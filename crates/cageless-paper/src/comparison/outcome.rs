//! Numbers of one start of one combination.

use cageless::Case;
use cageless::collision::Collision;
use cageless::simulation::RunOutcome;
use cageless::vibration::{Measurement, PassingSplit};
use cageless_study::StudyError;

use crate::experiment::{STRETCHES, Stretch, deviation_deg, stretches};
use crate::load_zone::transition_shares;

/// Numbers of one start.
pub struct Outcome {
    pub mean_square: f64,
    pub at_passing: f64,
    pub between: f64,
    pub without_contacts: f64,
    pub from_contacts: f64,
    pub gap_deviation_deg: f64,
    pub contacts_per_s: f64,
    pub approach_speed_m_s: f64,
    pub impulse_n_s: f64,
    pub impulse_rate_n: f64,
    pub stretches: [Stretch; STRETCHES],
    pub transition_shares: [[f64; 2]; 3],
}

/// A run that has ended, with what was recorded of it.
pub struct Recorded<'a> {
    pub ended: &'a RunOutcome,
    /// Vertical vibration of the housing.
    pub vertical: &'a Measurement,
    /// Vertical vibration without the contacts between balls.
    pub quiet: &'a Measurement,
    pub orbit_hz: f64,
    pub contacts: &'a [Collision],
}

/// Numbers of a run that has ended, whose load zone ends at ±`load_zone_rad`.
pub fn outcome(
    case: &Case,
    recorded: &Recorded<'_>,
    load_zone_rad: f64,
) -> Result<Outcome, StudyError> {
    let &Recorded {
        ended,
        vertical,
        quiet,
        orbit_hz,
        contacts,
    } = recorded;
    let after_s = case.solver.duration_s / 2.0;
    let of = |trace: &[[f64; 2]]| -> Vec<f64> {
        let settled = trace.iter().filter(|[time_s, _]| *time_s >= after_s);
        settled.map(|[_, a]| *a).collect()
    };
    let record = vertical.trace();
    let (values, quiet_values) = (of(&record), of(&quiet.trace()));
    let cut_out: Vec<f64> = values
        .iter()
        .zip(&quiet_values)
        .map(|(a, b)| a - b)
        .collect();
    let split = match PassingSplit::new(&values, vertical.interval_s(), orbit_hz) {
        Some(split) if vertical.trace_stretch_s().is_none() => split,
        _ => {
            return Err(StudyError::Input(
                "the run is too short or too long to split its vibration".to_owned(),
            ));
        }
    };
    let measured_s = case.solver.duration_s - after_s;
    let late = |c: &&Collision| c.start_s >= after_s;
    let settled: Vec<Collision> = contacts.iter().filter(late).copied().collect();
    let count = settled.len() as f64;
    let sum = |of: fn(&Collision) -> f64| settled.iter().map(of).sum::<f64>();
    let impulse_n_s = sum(|c| c.impulse_n_s);
    Ok(Outcome {
        mean_square: split.at_passing + split.between,
        at_passing: split.at_passing,
        between: split.between,
        without_contacts: quiet.rms(),
        from_contacts: (cut_out.iter().map(|a| a * a).sum::<f64>() / cut_out.len() as f64).sqrt(),
        gap_deviation_deg: gap_deviation_deg(case, ended),
        contacts_per_s: count / measured_s,
        // Without contacts NaN, which estimates leave out.
        approach_speed_m_s: sum(|c| c.approach_speed_m_s) / count,
        impulse_n_s: impulse_n_s / count,
        impulse_rate_n: impulse_n_s / measured_s,
        stretches: stretches(&record, contacts, case.solver.duration_s),
        transition_shares: transition_shares(&settled, load_zone_rad),
    })
}

fn gap_deviation_deg(case: &Case, ended: &RunOutcome) -> f64 {
    let (x, y) = (ended.state.x_m(), ended.state.y_m());
    let n = case.bearing.balls();
    let gaps: Vec<f64> = (0..n)
        .map(|k| {
            let next = (k + 1) % n;
            let ahead = (x[k] * y[next] - y[k] * x[next]).atan2(x[k] * x[next] + y[k] * y[next]);
            ahead - case.bearing.pair_angle_rad(k)
        })
        .collect();
    deviation_deg(&gaps)
}
