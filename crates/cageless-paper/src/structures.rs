//! The ten structures in motion: verdicts, phase portraits (Fig. 8) and orbital speeds
//! (Fig. 9).

use cageless::design::{Judgement, judge_watched, steady_after_s, steady_case};
use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::recorder::Recorder;
use cageless::snapshot::Snapshot;
use cageless::{Case, FrictionLaw, Profile};
use cageless_report::{OrbitSpeed, OrbitSpeeds, PhasePortrait, PhasePortraits, Provenance};
use rayon::prelude::*;

use crate::READINGS;
use crate::cases::{self, label};
use crate::error::PaperError;
use cageless_study::Work;
use cageless_study::provenance;

/// Seconds on one core, roughly.
pub const WORK: f64 = 12.0;

/// Sampling of portraits and passages.
const INTERVAL_S: f64 = 20e-6;
/// Orbits in a portrait.
const PORTRAIT_ORBITS: f64 = 6.0;
/// Fig. 9 shows this much on either side of the raceway's middle, degrees.
const WINDOW_DEG: f64 = 60.0;

/// The ten structures under one reading of the equations.
pub struct Ten {
    /// Fig. 8.
    pub portraits: PhasePortraits,
    /// Fig. 9.
    pub speeds: OrbitSpeeds,
    /// Verdicts.
    pub judgements: Vec<Judgement>,
}

struct One {
    judgement: Judgement,
    portrait: PhasePortrait,
    speed: OrbitSpeed,
}

/// Runs all structures under both readings.
pub fn compute(progress: &dyn Work) -> Result<Vec<Ten>, PaperError> {
    let tasks: Vec<(usize, usize)> = (0..2).flat_map(|r| (0..10).map(move |k| (r, k))).collect();
    let share = WORK / tasks.len() as f64;
    let mut found: Vec<One> = tasks
        .par_iter()
        .map(|&(reading, k)| one(READINGS[reading], k, progress, share))
        .collect::<Result<_, PaperError>>()?;
    let physical = found.split_off(10);
    [found, physical]
        .into_iter()
        .zip(READINGS)
        .map(|(ones, reading)| gather(ones, reading))
        .collect()
}

fn one(
    reading: (Profile, FrictionLaw),
    k: usize,
    progress: &dyn Work,
    share: f64,
) -> Result<One, PaperError> {
    let case = cases::structure(k, reading, &[])?;
    let steady = steady_case(&case);
    let end_s = steady.solver.duration_s;
    let orbit_s = end_s / 32.0;
    let from_s = (end_s - PORTRAIT_ORBITS * orbit_s).max(steady_after_s(&case));
    let mut snapshots: Vec<Snapshot> = vec![];
    let judgement = {
        let mut recorder = Recorder::new(INTERVAL_S, |snapshot| {
            if snapshot.time_s >= from_s {
                snapshots.push(snapshot);
            }
            Ok(())
        });
        judge_watched(
            &case,
            &mut [&mut recorder],
            &mut progress.run_control(1.0, share),
        )?
    };
    let structure = label(k, &case);
    let verdict = judgement.verdict.name().to_owned();
    let portrait = PhasePortrait {
        structure: structure.clone(),
        verdict: verdict.clone(),
        x_mm: snapshots.iter().map(|s| s.x_m[0] * 1e3).collect(),
        vx_m_s: snapshots.iter().map(|s| s.vx_m_s[0]).collect(),
        vy_m_s: snapshots.iter().map(|s| s.vy_m_s[0]).collect(),
    };
    let (angle_deg, speed_deg_s) = last_passage(&snapshots);
    let rolling_deg_s = angle_deg
        .iter()
        .map(|&angle: &f64| {
            let r = case.raceways[0].effective_radius_m(angle.to_radians());
            rolling_orbit_speed_rad_s(&case.bearing, case.operation.inner_speed_rad_s, r)
                .to_degrees()
        })
        .collect();
    let speed = OrbitSpeed {
        structure,
        verdict,
        angle_deg,
        speed_deg_s,
        rolling_deg_s,
    };
    Ok(One {
        judgement,
        portrait,
        speed,
    })
}

/// ψ and speed of ball 1 on its last whole way through the window.
fn last_passage(snapshots: &[Snapshot]) -> (Vec<f64>, Vec<f64>) {
    let Some(last) = snapshots.last() else {
        return (vec![], vec![]);
    };
    let end = last.angle_rad[0].to_degrees();
    let turns = ((end - WINDOW_DEG) / 360.0).floor() * 360.0;
    snapshots
        .iter()
        .map(|s| {
            (
                s.angle_rad[0].to_degrees() - turns,
                s.orbit_speed_rad_s[0].to_degrees(),
            )
        })
        .filter(|(angle, _)| angle.abs() <= WINDOW_DEG)
        .unzip()
}

fn gather(ones: Vec<One>, reading: (Profile, FrictionLaw)) -> Result<Ten, PaperError> {
    let case = cases::structure(0, reading, &[])?;
    let source = shared_provenance(&case);
    let mut ten = Ten {
        portraits: PhasePortraits {
            portraits: vec![],
            provenance: source.clone(),
        },
        speeds: OrbitSpeeds {
            passages: vec![],
            provenance: source,
        },
        judgements: vec![],
    };
    for one in ones {
        ten.portraits.portraits.push(one.portrait);
        ten.speeds.passages.push(one.speed);
        ten.judgements.push(one.judgement);
    }
    Ok(ten)
}

fn shared_provenance(case: &Case) -> Provenance {
    Provenance {
        case: "Zhao 2022, structures (a) to (j), balls evenly spaced at the start".to_owned(),
        ..provenance(
            case,
            format!(
                "all but the last {PORTRAIT_ORBITS} of 32 orbits (t < {:.3} s)",
                steady_case(case).solver.duration_s * (1.0 - PORTRAIT_ORBITS / 32.0)
            ),
        )
    }
}
