//! A run with everything that observers recorded of it, and its state at every step.

use std::f64::consts::TAU;
use std::sync::LazyLock;

use crate::common::{conventional, dimensions, raceway};
use cageless::collision::{Collision, CollisionDetector};
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::dynamics::energy::EnergyTerm;
use cageless::passage::{Passage, PassageRecorder};
use cageless::simulation::{
    Control, Observer, ObserverError, RunContext, RunOutcome, StepView, run,
};
use cageless::steady::{SteadyRecorder, SteadySummary};
use cageless::summary::{Summary, SummaryRecorder};
use cageless::verification::{Record, replicas};
use cageless::{Case, Gaps, Start, StartState};

/// One ball at the end of a step; its pair is the one with the ball ahead.
#[derive(Clone, Copy, Default)]
pub struct Seen {
    pub x: f64,
    pub y: f64,
    pub vx: f64,
    pub vy: f64,
    pub spin: f64,
    pub inner_n: f64,
    pub outer_n: f64,
    pub inner_slip: f64,
    pub outer_slip: f64,
    pub inner_friction_n: f64,
    pub outer_friction_n: f64,
    pub radius: f64,
    pub pair_n: f64,
    pub pair_slip: f64,
}

impl Seen {
    pub fn psi(&self) -> f64 {
        self.x.atan2(-self.y)
    }

    pub fn orbit(&self) -> f64 {
        (self.x * self.vy - self.y * self.vx) / (self.x * self.x + self.y * self.y)
    }
}

/// The end of a step.
pub struct Row {
    pub time_s: f64,
    pub ring: [f64; 2],
    pub balls: Vec<Seen>,
    pub ledger: Vec<f64>,
}

#[derive(Default)]
pub struct EveryStep(Vec<Row>);

impl Observer for EveryStep {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let start = context.start;
        let ball = |k| {
            let motion = start.ball_motion(k);
            Seen {
                x: motion.x,
                y: motion.y,
                vx: motion.vx,
                vy: motion.vy,
                ..Seen::default()
            }
        };
        self.0.push(Row {
            time_s: 0.0,
            ring: [start.ring_motion().x, start.ring_motion().y],
            balls: (0..context.model.balls()).map(ball).collect(),
            ledger: vec![0.0; EnergyTerm::without_rotor().len()],
        });
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let (c, layout) = (&view.contacts, view.layout());
        let ball = |k| {
            let at = |coordinate| view.after(coordinate)[k];
            Seen {
                x: at(BallCoordinate::X),
                y: at(BallCoordinate::Y),
                vx: at(BallCoordinate::Vx),
                vy: at(BallCoordinate::Vy),
                spin: c.rotation_rad_s(k),
                inner_n: c.inner_force_n(k),
                outer_n: c.outer_force_n(k),
                inner_slip: c.inner_sliding_m_s(k),
                outer_slip: c.outer_sliding_m_s(k),
                inner_friction_n: c.inner_friction_n(k),
                outer_friction_n: c.outer_friction_n(k),
                radius: c.effective_radius_m(k),
                pair_n: c.pair_force_n(k),
                pair_slip: c.pair_sliding_m_s(k),
            }
        };
        let ring = layout.ring_motion(&view.step.y1);
        let terms = EnergyTerm::without_rotor().iter();
        self.0.push(Row {
            time_s: view.step.t1_s,
            ring: [ring.x, ring.y],
            balls: (0..layout.balls).map(ball).collect(),
            ledger: terms
                .map(|term| view.step.y1[layout.energy_term(*term)])
                .collect(),
        });
        Ok(Control::Continue(()))
    }
}

/// One run with everything that was recorded of it.
pub struct Recording {
    pub case: Case,
    pub rows: Vec<Row>,
    pub collisions: Vec<Collision>,
    pub passages: Vec<Passage>,
    pub summary: Summary,
    pub steady: SteadySummary,
    pub record: Record,
    pub outcome: RunOutcome,
}

fn case() -> Case {
    let mut case = conventional(dimensions());
    let smaller = |k: usize| -1e-6 * ((5 * k + 3) % 14) as f64;
    let deviations = (0..14).map(smaller).collect();
    case.bearing = (case.bearing.clone())
        .with_ball_radius_deviations(deviations)
        .unwrap();
    let raceways = [(5.1, 25.2, 30.0), (5.4, 18.167, -100.0)];
    let raceways =
        raceways.map(|(span, angle, centre)| raceway(&case.bearing, span, angle, centre));
    let mut case = case.with_raceways(raceways.to_vec());
    let mean = case.bearing.mean_gap_rad();
    let uneven = |k: usize| mean * [0.1, 1.5, 0.3, 2.1, 0.2, 1.0, 1.8][k % 7];
    case.start = Start::new(
        StartState::Settled,
        Gaps::List((0..14).map(uneven).collect()),
        0.1,
    );
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.05;
    case
}

pub static RECORDING: LazyLock<Recording> = LazyLock::new(|| {
    let case = case();
    let (mut collisions, mut passages) = (vec![], vec![]);
    let mut every = EveryStep::default();
    let mut summary = SummaryRecorder::new();
    let mut steady = SteadyRecorder::new();
    let mut replica = replicas(&case, 0, 1)[0].observer();
    let mut detector = CollisionDetector::new(|collision| {
        collisions.push(collision);
        Ok(())
    });
    let mut recorder = PassageRecorder::new(|passage| {
        passages.push(passage);
        Ok(())
    });
    let outcome = run(
        &case,
        &mut [
            &mut every,
            &mut summary,
            &mut steady,
            &mut replica,
            &mut detector,
            &mut recorder,
        ],
        &mut |_| Control::Continue(()),
    )
    .unwrap();
    drop((detector, recorder));
    Recording {
        rows: every.0,
        summary: summary.summary().unwrap(),
        steady: SteadySummary::new(&case.bearing, &steady.blocks, steady.transient_force_max_n),
        record: replica.record(&outcome).unwrap(),
        case,
        collisions,
        passages,
        outcome,
    }
});

impl Recording {
    pub fn radius_m(&self, k: usize) -> f64 {
        let deviations = self.case.bearing.ball_radius_deviations_m();
        4.7625e-3 + deviations[k % 14]
    }

    /// Gap of ball `k` and the ball ahead in a row.
    pub fn gap_rad(&self, row: &Row, k: usize) -> f64 {
        let pitch = 0.5 * (18.24e-3 + 27.765e-3);
        let half = (self.radius_m(k) + self.radius_m(k + 1)) / 2.0 / pitch;
        let angle = row.balls[(k + 1) % 14].psi() - row.balls[k].psi();
        angle.rem_euclid(TAU) - 2.0 * half.asin()
    }

    /// How far ball `k` and the ball ahead are pressed together.
    pub fn overlap_m(&self, row: &Row, k: usize) -> f64 {
        let (a, b) = (&row.balls[k], &row.balls[(k + 1) % 14]);
        self.radius_m(k) + self.radius_m(k + 1) - (b.x - a.x).hypot(b.y - a.y)
    }

    pub fn touches(&self, step: usize, k: usize) -> bool {
        let [before, after] = [step - 1, step].map(|n| self.overlap_m(&self.rows[n], k) > 0.0);
        after && !before
    }

    /// Rows after the transient: two orbits of the balls, at most half of the run.
    pub fn settled(&self) -> &[Row] {
        let orbit = self.case.operation.inner_speed_rad_s * 18.24e-3 / (18.24e-3 + 27.765e-3);
        let after = (2.0 * TAU / orbit).min(0.025);
        let from = self.rows.iter().position(|row| row.time_s > after);
        &self.rows[from.unwrap()..]
    }
}
