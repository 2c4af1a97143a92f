//! The ten structures in motion: verdicts, phase portraits (Fig. 8) and orbital speeds
//! (Fig. 9).

use cageless::Snapshot;
use cageless::closed_forms::{Eq11, half_angle_for_gap_rad};
use cageless::collision::{Collision, CollisionDetector};
use cageless::kinematics::rolling_orbit_speed_rad_s;
use cageless::numerics::Moments;
use cageless::numerics::wrap_angle_rad;
use cageless::passage::{Passage, PassageRecorder};
use cageless::recorder::{Recorder, keeping};
use cageless::{Case, RacewayForm};
use cageless_design::{Judgement, judge, judge_watched, steady_after_s, steady_case};
use cageless_report::{OrbitSpeed, OrbitSpeeds, PhasePortrait, PhasePortraits, Provenance};
use rayon::prelude::*;

use crate::cases::{self, PUBLISHED, Published, READINGS, Reading, label};
use crate::printed::PRINTED;
use cageless_study::threads::each;
use cageless_study::{StudyError, Work, provenance};

/// Steps, about.
pub const WORK: f64 = 8.7e6;
/// Steps of [`between`], about.
pub const WORK_BETWEEN: f64 = 4.1e6;

/// Sampling of portraits and passages.
const INTERVAL_S: f64 = 20e-6;
/// Orbits in a portrait.
const PORTRAIT_ORBITS: f64 = 6.0;
/// Width of the places at which speeds are compared from passage to passage, degrees.
const PLACE_DEG: f64 = 0.25;
/// Fig. 9 shows this much on either side of the raceway's middle, degrees.
const WINDOW_DEG: f64 = 60.0;

/// The ten structures under one reading of the equations.
pub struct Ten {
    /// Fig. 8.
    pub portraits: PhasePortraits,
    /// Fig. 9.
    pub speeds: OrbitSpeeds,
    /// Verdicts and steady motion.
    pub found: Vec<Found>,
}

/// A structure in motion.
#[derive(Debug, Clone)]
pub struct Found {
    /// Verdict.
    pub judgement: Judgement,
    /// Motion after the transient.
    pub steady: Steady,
}

/// Steady motion of all balls, evenly spaced at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steady {
    /// Contacts between two balls that are both outside the discrete raceway, per ball and orbit.
    pub contacts_outside: f64,
    /// All contacts, per ball and orbit.
    pub contacts: f64,
    /// Mean duration of a contact, s; NaN without contacts.
    pub contact_duration_s: f64,
    /// Standard deviation of the gaps between balls outside the raceway, degrees.
    pub gap_outside_deviation_deg: f64,
    /// Mean gap between balls inside it, degrees; NaN if no two are inside at once.
    pub gap_inside_mean_deg: f64,
    /// RMS deviation of the orbital speed at one place in the raceway from passage to passage, over the drop of a
    /// rolling ball.
    pub speed_scatter: f64,
    /// Pairs that enter the raceway with another gap than β0, and those of them that keep the rule of Section 2.3:
    /// they touch in it if their gap is below β0, and do not if it is above.
    pub pairs: [usize; 2],
}

impl Steady {
    /// From the contacts that begin within `orbits` orbits, and passages and snapshots of the same motion.
    fn new(
        case: &Case,
        contacts: &[Collision],
        orbits: f64,
        passages: &[Passage],
        snapshots: &[Snapshot],
    ) -> Self {
        let theta = case.raceways[0].half_angle_rad();
        let outside = theta + case.bearing.ball_angle_rad() / 2.0;
        let ball_orbits = case.bearing.balls() as f64 * orbits;
        let count = contacts.len() as f64;
        let apart = contacts.iter().filter(|c| c.angle_rad.abs() >= outside);
        let [mut inside_gaps, mut outside_gaps] = [Moments::default(), Moments::default()];
        for s in snapshots {
            let inside = |k: usize| wrap_angle_rad(s.angle_rad[k]).abs() < theta;
            for k in 0..s.balls() {
                match [inside(k), inside((k + 1) % s.balls())] {
                    [true, true] => inside_gaps.add(s.gap_rad[k].to_degrees(), 1.0),
                    [false, false] => outside_gaps.add(s.gap_rad[k].to_degrees(), 1.0),
                    _ => {}
                }
            }
        }
        Self {
            contacts_outside: apart.count() as f64 / ball_orbits,
            contacts: count / ball_orbits,
            contact_duration_s: contacts.iter().map(|c| c.duration_s).sum::<f64>() / count,
            gap_outside_deviation_deg: outside_gaps.deviation(),
            gap_inside_mean_deg: if inside_gaps.weight > 0.0 {
                inside_gaps.mean
            } else {
                f64::NAN
            },
            speed_scatter: speed_scatter(case, snapshots),
            pairs: pairs(case, passages),
        }
    }
}

/// [`Steady::pairs`] of the balls of passages with those behind; gaps within what the paper neglects are β0.
fn pairs(case: &Case, passages: &[Passage]) -> [usize; 2] {
    let beyond_deg = |p: &Passage| (p.gap_behind_rad - case.bearing.nominal_gap_rad()).to_degrees();
    let others = || {
        passages
            .iter()
            .filter(|p| beyond_deg(p).abs() > PRINTED.neglected_deg)
    };
    let kept = others().filter(|p| (p.collisions_behind > 0) == (beyond_deg(p) < 0.0));
    [others().count(), kept.count()]
}

fn speed_scatter(case: &Case, snapshots: &[Snapshot]) -> f64 {
    let theta_deg = case.raceways[0].half_angle_rad().to_degrees();
    let places = (2.0 * theta_deg / PLACE_DEG) as usize;
    let mut speeds = vec![Moments::default(); places + 1];
    for s in snapshots {
        for k in 0..s.balls() {
            let from_deg = wrap_angle_rad(s.angle_rad[k]).to_degrees() + theta_deg;
            if (0.0..2.0 * theta_deg).contains(&from_deg) {
                speeds[(from_deg / PLACE_DEG) as usize].add(s.orbit_speed_rad_s[k], 1.0);
            }
        }
    }
    let mut squares = Moments::default();
    for place in speeds.iter().filter(|place| place.weight > 1.0) {
        squares.add(place.deviation().powi(2), place.weight);
    }
    let rolling = |r| rolling_orbit_speed_rad_s(&case.bearing, case.operation.inner_speed_rad_s, r);
    let drop =
        rolling(case.bearing.ball_radius_m()) - rolling(case.raceways[0].effective_radius_m(0.0));
    squares.mean.sqrt() / drop
}

/// A structure that no threshold of a verdict was fitted to.
#[derive(Debug, Clone)]
pub struct Between {
    /// Axial span lC, mm.
    pub axial_span_mm: f64,
    /// Half angle θ by Eq. (11), degrees.
    pub half_angle_deg: f64,
    /// Verdict.
    pub judgement: Judgement,
}

/// Judges structures midway in lC between neighbours of Table 2, θ by Eq. (11), under the reading
/// `paper`, to whose ten verdicts the thresholds of a verdict were fitted.
pub fn between(progress: &Work<'_>) -> Result<Vec<Between>, StudyError> {
    let pairs: Vec<&[Published]> = PUBLISHED.windows(2).collect();
    each(&pairs)
        .map(|pair| {
            let axial_span_mm = 0.5 * (pair[0].axial_span_mm + pair[1].axial_span_mm);
            let bearing = &cases::structure(0, READINGS[0], &[])?.bearing;
            let (span_m, gap) = (axial_span_mm * 1e-3, bearing.nominal_gap_rad());
            let angle = half_angle_for_gap_rad(
                bearing,
                RacewayForm::default(),
                span_m,
                gap,
                Eq11::Published,
            );
            let half_angle_deg = angle.map_or(f64::NAN, f64::to_degrees);
            let dimensions = [
                format!("raceway.axial_span_mm={axial_span_mm:.4}"),
                format!("raceway.half_angle_deg={half_angle_deg:.4}"),
            ];
            let case = cases::structure(0, READINGS[0], &dimensions)?;
            let mut control = progress.run_control(1.0, WORK_BETWEEN / pairs.len() as f64);
            Ok(Between {
                axial_span_mm,
                half_angle_deg,
                judgement: judge(&case, &mut control)?,
            })
        })
        .collect()
}

type One = (Found, PhasePortrait, OrbitSpeed);

/// Runs all structures under both readings.
pub fn compute(progress: &Work<'_>) -> Result<[Ten; 2], StudyError> {
    let tasks: Vec<(usize, usize)> = (0..2).flat_map(|r| (0..10).map(move |k| (r, k))).collect();
    let share = WORK / tasks.len() as f64;
    let mut found: Vec<One> = each(&tasks)
        .map(|&(reading, k)| one(READINGS[reading], k, progress, share))
        .collect::<Result<_, StudyError>>()?;
    let physical = found.split_off(10);
    Ok([gather(found, READINGS[0])?, gather(physical, READINGS[1])?])
}

fn one(reading: Reading, k: usize, progress: &Work<'_>, share: f64) -> Result<One, StudyError> {
    let case = cases::structure(k, reading, &[])?;
    let steady = steady_case(&case);
    let end_s = steady.solver.duration_s;
    let orbit_s = end_s / 32.0;
    let from_s = (end_s - PORTRAIT_ORBITS * orbit_s).max(steady_after_s(&case));
    let mut snapshots: Vec<Snapshot> = vec![];
    let mut contacts: Vec<Collision> = vec![];
    let mut passages: Vec<Passage> = vec![];
    let after_s = steady_after_s(&case);
    let judgement = {
        let mut detector = CollisionDetector::new(keeping(&mut contacts, |c| c.start_s > after_s));
        let mut recorder =
            Recorder::new(INTERVAL_S, keeping(&mut snapshots, |s| s.time_s >= from_s));
        let mut ways = PassageRecorder::new(keeping(&mut passages, |p| p.enter_s > after_s));
        judge_watched(
            &case,
            &mut [&mut recorder, &mut detector, &mut ways],
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
    let orbits = (end_s - after_s) / orbit_s;
    let steady = Steady::new(&case, &contacts, orbits, &passages, &snapshots);
    Ok((Found { judgement, steady }, portrait, speed))
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

fn gather(ones: Vec<One>, reading: Reading) -> Result<Ten, StudyError> {
    let provenance = shared_provenance(&cases::structure(0, reading, &[])?);
    let (found, portraits, passages) = ones.into_iter().collect();
    Ok(Ten {
        portraits: PhasePortraits {
            portraits,
            provenance: provenance.clone(),
        },
        speeds: OrbitSpeeds {
            passages,
            provenance,
        },
        found,
    })
}

fn shared_provenance(case: &Case) -> Provenance {
    Provenance {
        case: "Zhao 2022, structures (a) to (j), balls evenly spaced at the start".to_owned(),
        ..provenance(
            "",
            case,
            format!(
                "all but the last {PORTRAIT_ORBITS} of 32 orbits (t < {:.3} s)",
                steady_case(case).solver.duration_s * (1.0 - PORTRAIT_ORBITS / 32.0)
            ),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A passage of a pair with this gap before the raceway.
    fn pair(gap_deg: f64, collisions_behind: u32) -> Passage {
        Passage {
            ball: 0,
            raceway: 0,
            enter_s: 0.0,
            leave_s: 0.0,
            gap_enter_rad: 0.0,
            gap_behind_rad: gap_deg.to_radians(),
            gap_min_rad: 0.0,
            gap_leave_rad: 0.0,
            collisions_ahead: 0,
            collisions_behind,
            sliding_max_m_s: 0.0,
            unloaded_s: 0.0,
            orbit_speed_range_rad_s: [0.0; 2],
            inside_at_largest_s: 0.0,
            slowest_at_largest_rad_s: 0.0,
            angle_rad: 0.0,
            way_here: None,
        }
    }

    /// Contacts at ψ = 180°, in the middle, and of one ball outside with one inside; five balls of
    /// which two are inside.
    #[test]
    fn steady_motion_is_divided_by_the_ends_of_the_raceway() {
        let case = cases::structure(3, READINGS[1], &[]).unwrap();
        let contact = |angle_deg: f64, duration_s| Collision {
            start_s: 0.0,
            duration_s,
            ball: 0,
            next_ball: 1,
            angle_rad: f64::to_radians(angle_deg),
            approach_speed_m_s: 0.1,
            peak_force_n: 1.0,
            impulse_n_s: 1.0,
        };
        let contacts = [
            contact(180.0, 1e-5),
            contact(0.0, 3e-5),
            contact(-30.0, 2e-5),
        ];
        let snapshot = Snapshot {
            x_m: vec![0.0; 5],
            angle_rad: vec![-0.2, 0.2, 1.0, 2.0, 3.0],
            gap_rad: [1f64, 2.0, 3.0, 5.0, 7.0].map(f64::to_radians).to_vec(),
            orbit_speed_rad_s: vec![500.0; 5],
            ..Snapshot::default()
        };
        // By the rule of Section 2.3 with β0 = 1.816°: kept, kept, broken twice; at β0 nothing.
        let passages = [
            pair(1.7, 1),
            pair(1.9, 0),
            pair(1.7, 0),
            pair(1.9, 2),
            pair(1.8, 0),
        ];
        let faster = Snapshot {
            orbit_speed_rad_s: vec![510.0; 5],
            gap_rad: vec![0.5; 5],
            ..snapshot.clone()
        };
        let scatter = Steady::new(&case, &[], 2.0, &[], &[snapshot.clone(), faster]).speed_scatter;
        let steady = Steady::new(&case, &contacts, 2.0, &passages, &[snapshot]);
        assert_eq!(steady.pairs, [4, 2]);
        // ±5 rad/s of the drop Ω(Rw) − Ω(r), r = √(Rw² − lC²/4).
        let r = (4.7625f64.powi(2) - 2.55f64.powi(2)).sqrt();
        let speed = |r: f64| 400.0 * std::f64::consts::PI * 18.24 / 23.0025 * r / (r + 4.7625);
        assert!(
            (scatter * (speed(4.7625) - speed(r)) / 5.0 - 1.0).abs() < 1e-3,
            "{scatter}"
        );
        assert!((steady.contacts_outside - 1.0 / 28.0).abs() < 1e-12);
        assert!((steady.contacts - 3.0 / 28.0).abs() < 1e-12);
        assert!((steady.contact_duration_s - 2e-5).abs() < 1e-12);
        assert!((steady.gap_inside_mean_deg - 1.0).abs() < 1e-12);
        assert!((steady.gap_outside_deviation_deg - 1.0).abs() < 1e-12);
    }
}
