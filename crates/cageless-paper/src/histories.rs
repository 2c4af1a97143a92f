//! The gap of a pair over time (Fig. 6) and three neighbours in the raceway (Fig. 7), of
//! structure (a).

use std::collections::HashSet;
use std::f64::consts::TAU;

use cageless::Case;
use cageless::Snapshot;
use cageless::collision::{Collision, CollisionDetector};
use cageless::numerics::wrap_angle_rad;
use cageless::recorder::{Recorder, keeping};
use cageless::simulation::run;
use cageless_report::{Event, GapHistory, Neighbours, Provenance};

use crate::cases::{self, READINGS, Reading, label};
use cageless_study::threads::both;
use cageless_study::{StudyError, Work, provenance};

/// Steps, about.
pub const WORK: f64 = 6.0e5;

/// Sampling.
const INTERVAL_S: f64 = 10e-6;
/// The long history is thinned to this.
const COARSE: usize = 10;
/// Transient of the long history.
const SETTLED_AFTER_S: f64 = 0.1;
/// An inner contact that carries more than this is in the load zone, N.
const LOADED_N: f64 = 1.0;
/// The beginning, in which Fig. 6 of the paper falls rapidly.
const BEGINNING_S: f64 = 1e-3;
/// Fig. 7 begins and ends this much outside the passage.
const MARGIN_S: f64 = 3e-4;

/// Fig. 6 and 7 under one reading of the equations.
pub struct History {
    /// Fig. 6.
    pub gap: GapHistory,
    /// Fig. 7.
    pub neighbours: Neighbours,
    /// Numbers of both.
    pub stages: Stages,
}

/// Numbers of Fig. 6 and 7.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stages {
    /// Change of the gap in the unloaded zone of the turn shown, degrees.
    pub unloaded_change_deg: f64,
    /// Change of the gap within the raceway, degrees.
    pub raceway_change_deg: f64,
    /// Largest departure of the gap from β0 in the load zone outside the raceway (b–c and d–e),
    /// degrees.
    pub loaded_change_deg: f64,
    /// Largest sliding speed of the trailing ball there over the speed of the inner raceway.
    pub loaded_slip: f64,
    /// Largest fall of a gap in the first millisecond, degrees: of pairs of which a ball is in the raceway, and of all
    /// others.
    pub first_fall_deg: [f64; 2],
    /// Passages with both collisions of the paper's Fig. 7.
    pub double_passages: usize,
}

/// Runs structure (a) under both readings.
pub fn compute(progress: &Work<'_>) -> Result<[History; 2], StudyError> {
    let [published, consistent] = READINGS;
    let both = both(|| one(published, progress), || one(consistent, progress));
    Ok([both.0?, both.1?])
}

fn one(reading: Reading, progress: &Work<'_>) -> Result<History, StudyError> {
    // As in the paper: balls in pure rolling, the ring where it was before the load came.
    let overrides = [
        "start.state=\"rolling\"".to_owned(),
        "start.ring_y_um=0.0".to_owned(),
        "solver.duration_s=0.3".to_owned(),
    ];
    let file = cases::structure_file(0, reading, &overrides)?;
    let case = file.case().clone();
    let mut snapshots: Vec<Snapshot> = vec![];
    let mut collisions: Vec<Collision> = vec![];
    let mut recorder = Recorder::new(INTERVAL_S, keeping(&mut snapshots, |_| true));
    let mut detector = CollisionDetector::new(keeping(&mut collisions, |_| true));
    let outcome = run(
        &case,
        &mut [&mut recorder, &mut detector],
        &mut progress.run_control(case.solver.duration_s, WORK / 2.0),
    )?;
    drop((recorder, detector));
    StudyError::unless_complete(&outcome.ending)?;
    let source = provenance(
        &file.particulars().title,
        &case,
        format!("t < {SETTLED_AFTER_S} s (shaded)"),
    );
    let (neighbours, ball, double_passages) = neighbours(&case, &snapshots, &collisions, &source);
    let (gap, stages) = gap_history(&case, &snapshots, ball, source);
    let first_fall_deg = first_fall_deg(&case, &snapshots);
    Ok(History {
        gap,
        neighbours,
        stages: Stages {
            first_fall_deg,
            double_passages,
            ..stages
        },
    })
}

/// Largest fall of a gap in the beginning, as in [`Stages::first_fall_deg`].
fn first_fall_deg(case: &Case, snapshots: &[Snapshot]) -> [f64; 2] {
    let theta = case.raceways[0].half_angle_rad();
    let early = || snapshots.iter().take_while(|s| s.time_s <= BEGINNING_S);
    let balls = case.bearing.balls();
    let inside = |k: usize| early().any(|s| wrap_angle_rad(s.angle_rad[k]).abs() < theta);
    let mut falls = [0.0; 2];
    for k in 0..balls {
        let mut gaps = early().map(|s| s.gap_rad[k].to_degrees());
        let first = gaps.next().unwrap_or(f64::NAN);
        let fall = gaps.fold(0.0, |fall, gap| f64::max(fall, first - gap));
        let apart = usize::from(!inside(k) && !inside((k + 1) % balls));
        falls[apart] = f64::max(falls[apart], fall);
    }
    falls
}

/// When ball `k` passes ψ = `angle` (plus whole turns) nearest to `near_s`, on the side
/// `before` or after it.
fn passes_s(
    snapshots: &[Snapshot],
    k: usize,
    angle: f64,
    near_s: f64,
    before: bool,
) -> Option<f64> {
    let turn = |s: &Snapshot| ((s.angle_rad[k] - angle) / TAU).floor();
    let mut crossings = snapshots
        .windows(2)
        .filter(|pair| turn(&pair[0]) != turn(&pair[1]))
        .map(|pair| pair[1].time_s);
    if before {
        crossings.take_while(|t| *t <= near_s).last()
    } else {
        crossings.find(|t| *t > near_s)
    }
}

/// Largest |ψ| at which an inner contact carries load in the settled part.
fn load_zone_rad(snapshots: &[Snapshot]) -> f64 {
    let mut angles: Vec<f64> = snapshots
        .iter()
        .filter(|s| s.time_s > SETTLED_AFTER_S)
        .step_by(COARSE)
        .flat_map(|s| {
            (0..s.balls())
                .filter(|&k| s.inner_force_n[k] > LOADED_N)
                .map(|k| wrap_angle_rad(s.angle_rad[k]).abs())
        })
        .collect();
    angles.sort_by(f64::total_cmp);
    // A ball thrown against the ring once in a while does not widen the load zone.
    angles.get(angles.len() * 99 / 100).copied().unwrap_or(0.0)
}

/// Ends of the stages of Fig. 6 in one turn of a pair, s.
struct StageEnds {
    /// The trailing ball leaves the load zone.
    a: f64,
    /// It comes back into the load zone.
    b: f64,
    /// The leading ball enters the discrete raceway.
    c: f64,
    /// The trailing ball leaves the discrete raceway.
    d: f64,
    /// The trailing ball leaves the load zone again.
    e: f64,
}

impl StageEnds {
    /// Ends in the last turn that is whole: stage e is the trailing ball leaving the load zone.
    fn of_last_turn(case: &Case, snapshots: &[Snapshot], ball: usize) -> Self {
        let ahead = (ball + 1) % case.bearing.balls();
        let theta = case.raceways[0].half_angle_rad();
        let zone = load_zone_rad(snapshots);
        let end_s = snapshots.last().map_or(0.0, |s| s.time_s);
        let before = |k: usize, angle: f64, near_s: f64| {
            passes_s(snapshots, k, angle, near_s, true).unwrap_or(near_s)
        };
        let e = before(ball, zone, end_s);
        let d = before(ball, theta, e);
        let c = before(ahead, -theta, d);
        let b = before(ball, -zone, c);
        let a = before(ball, zone, b);
        Self { a, b, c, d, e }
    }

    fn events(&self) -> Vec<Event> {
        vec![
            Event::new("a", self.a, "the trailing ball leaves the load zone"),
            Event::new("b", self.b, "it comes back into the load zone"),
            Event::new("c", self.c, "the leading ball enters the discrete raceway"),
            Event::new("d", self.d, "the trailing ball leaves the discrete raceway"),
            Event::new("e", self.e, "the trailing ball leaves the load zone again"),
        ]
    }
}

/// Changes of a gap in the stages of one turn.
fn stages_of(case: &Case, turn: &[&Snapshot], ends: &StageEnds, ball: usize) -> Stages {
    let &StageEnds { a, b, c, d, e } = ends;
    let gap = |s: &Snapshot| s.gap_rad[ball].to_degrees();
    let within = |from: f64, to: f64| {
        turn.iter()
            .filter(move |s| s.time_s >= from && s.time_s <= to)
    };
    let range = |from: f64, to: f64| {
        let gaps = within(from, to).map(|s| gap(s));
        let (low, high) = gaps.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), g| {
            (l.min(g), h.max(g))
        });
        high - low
    };
    let beta0 = case.bearing.nominal_gap_rad().to_degrees();
    let inner_m_s =
        case.operation.inner_speed_rad_s * case.bearing.dimensions().inner_groove_bottom_radius_m;
    let loaded = || within(b, c).chain(within(d, e));
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    Stages {
        unloaded_change_deg: range(a, b),
        raceway_change_deg: range(c, d),
        loaded_change_deg: largest(&mut loaded().map(|s| (gap(s) - beta0).abs())),
        loaded_slip: largest(&mut loaded().map(|s| {
            s.inner_sliding_m_s[ball]
                .abs()
                .max(s.outer_sliding_m_s[ball].abs())
                / inner_m_s
        })),
        ..Stages::default()
    }
}

fn gap_history(
    case: &Case,
    snapshots: &[Snapshot],
    ball: usize,
    provenance: Provenance,
) -> (GapHistory, Stages) {
    let ends = StageEnds::of_last_turn(case, snapshots, ball);
    let turn: Vec<&Snapshot> = snapshots
        .iter()
        .filter(|s| s.time_s >= ends.a && s.time_s <= ends.e)
        .collect();
    let gap = |s: &Snapshot| s.gap_rad[ball].to_degrees();
    let history = GapHistory {
        structure: label(0, case),
        ball: ball + 1,
        time_s: snapshots.iter().step_by(COARSE).map(|s| s.time_s).collect(),
        gap_deg: snapshots.iter().step_by(COARSE).map(gap).collect(),
        settled_after_s: SETTLED_AFTER_S,
        turn_time_s: turn.iter().map(|s| s.time_s).collect(),
        turn_gap_deg: turn.iter().map(|s| gap(s)).collect(),
        stages: ends.events(),
        uniform_gap_deg: case.bearing.nominal_gap_rad().to_degrees(),
        provenance,
    };
    (history, stages_of(case, &turn, &ends, ball))
}

/// A passage of a ball through the discrete raceway.
#[derive(Clone, Copy)]
struct BallPassage {
    ball: usize,
    /// The ball enters the raceway, s.
    enter_s: f64,
    /// It hits the ball ahead, then the ball behind hits it, s; `None` unless both happen.
    hits_s: Option<[f64; 2]>,
}

/// Passages in which a ball is hit by both neighbours, from the last one.
fn double_passages(
    case: &Case,
    snapshots: &[Snapshot],
    collisions: &[Collision],
) -> Vec<BallPassage> {
    let theta = case.raceways[0].half_angle_rad();
    // t2: ball i hits i+1; t4: i−1 hits i, later, while i is still inside.
    collisions
        .iter()
        .rev()
        .filter(|c| c.start_s > SETTLED_AFTER_S)
        .filter_map(|c| {
            let (ball, t4) = (c.next_ball, c.start_s);
            let enter_s = passes_s(snapshots, ball, -theta, t4, true)?;
            let left = passes_s(snapshots, ball, theta, enter_s, false)?;
            let t2 = collisions
                .iter()
                .find(|o| o.ball == ball && o.start_s > enter_s && o.start_s < t4)?
                .start_s;
            (t4 < left).then_some(BallPassage {
                ball,
                enter_s,
                hits_s: Some([t2, t4]),
            })
        })
        .collect()
}

/// A ball hit by both neighbours in one passage, the last one in the run; else the last
/// passage. Also the ball's index, and how many such passages there are.
fn neighbours(
    case: &Case,
    snapshots: &[Snapshot],
    collisions: &[Collision],
    source: &Provenance,
) -> (Neighbours, usize, usize) {
    let n = case.bearing.balls();
    let theta = case.raceways[0].half_angle_rad();
    let end_s = snapshots.last().map_or(0.0, |s| s.time_s);
    let enter = |k: usize, near: f64| passes_s(snapshots, k, -theta, near, true);
    let double = double_passages(case, snapshots, collisions);
    let passages: HashSet<(usize, u64)> =
        (double.iter().map(|p| (p.ball, p.enter_s.to_bits()))).collect();
    let fallback = || BallPassage {
        ball: 1,
        enter_s: enter(1, end_s - 0.01).unwrap_or(0.0),
        hits_s: None,
    };
    let shown = double.first().copied().unwrap_or_else(fallback);
    let (i, t1) = (shown.ball, shown.enter_s);
    let [t2, t4] = shown.hits_s.map_or([None; 2], |hits| hits.map(Some));
    let (behind, ahead) = ((i + n - 1) % n, (i + 1) % n);
    let t0 = enter(ahead, t1).unwrap_or(t1);
    let t3 = passes_s(snapshots, behind, -theta, t1, false).unwrap_or(t1);
    let left = passes_s(snapshots, behind, theta, t3, false).unwrap_or(end_s);
    let shown: Vec<&Snapshot> = snapshots
        .iter()
        .filter(|s| s.time_s >= t0 - MARGIN_S && s.time_s <= left + MARGIN_S)
        .collect();
    let speed = |k: usize| -> Vec<f64> {
        shown
            .iter()
            .map(|s| s.orbit_speed_rad_s[k].to_degrees())
            .collect()
    };
    let gap = |k: usize| -> Vec<f64> { shown.iter().map(|s| s.gap_rad[k].to_degrees()).collect() };
    let event = |label: &str, time: Option<f64>, meaning: &str| {
        time.map(|time_s| Event::new(label, time_s, meaning))
    };
    let figure = Neighbours {
        structure: label(0, case),
        time_s: shown.iter().map(|s| s.time_s).collect(),
        orbit_speed_deg_s: [speed(behind), speed(i), speed(ahead)],
        gap_deg: [gap(behind), gap(i)],
        balls: [behind + 1, i + 1, ahead + 1],
        events: [
            event("t0", Some(t0), "ball i+1 enters the discrete raceway"),
            event("t1", Some(t1), "ball i enters it"),
            event("t2", t2, "ball i hits ball i+1"),
            event("t3", Some(t3), "ball i−1 enters it"),
            event("t4", t4, "ball i−1 hits ball i"),
        ]
        .into_iter()
        .flatten()
        .collect(),
        provenance: source.clone(),
    };
    (figure, i, passages.len())
}
