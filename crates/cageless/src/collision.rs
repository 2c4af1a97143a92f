//! Contacts between neighbouring balls.
//!
//! ```
//! use cageless::prelude::*;
//!
//! let mut found = vec![];
//! let mut detector = CollisionDetector::new(|collision| {
//!     found.push(collision);
//!     Ok(())
//! });
//! let mut simulation = Simulation::new(&reference::conventional())?;
//! simulation.run(1e-4, &mut [&mut detector]);
//! assert!(found.is_empty()); // the balls start evenly spaced
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::dynamics::coordinates::BallCoordinate;
use crate::numerics::root;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// One contact of two neighbouring balls, from touch to parting.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Collision {
    /// Time of first touch.
    pub start_s: f64,
    /// Duration of the contact.
    pub duration_s: f64,
    /// Index (from 0) of the ball behind; the ball ahead is its neighbour.
    pub ball: usize,
    /// Index (from 0) of the ball ahead.
    pub next_ball: usize,
    /// ψ halfway between the two at first touch, wrapped to (−π, π].
    pub angle_rad: f64,
    /// Speed at which the surfaces approached along the line of centres at first touch.
    pub approach_speed_m_s: f64,
    /// Largest normal force, located between steps.
    pub peak_force_n: f64,
    /// ∫ normal force dt.
    pub impulse_n_s: f64,
}

/// Finds the contacts between neighbours that last for a step or longer and passes each
/// on when it ends.
///
/// Times of touch and parting are roots of the interpolated distance; the peak is that of
/// the parabola through the forces at the three steps around it; impulses are sums by the
/// trapezoidal rule over the steps. A contact that is still closed at the
/// end of the run is passed on by [`Self::close`].
pub struct CollisionDetector<F> {
    distances: Vec<f64>,
    deflections: Vec<f64>,
    forces: Vec<f64>,
    /// Forces a step earlier, and the length of that step.
    earlier: Vec<f64>,
    earlier_step_s: f64,
    /// Steps since balls touched; from the third on all of the above is as without contacts.
    steps_apart: u64,
    open: Vec<Option<Collision>>,
    sink: F,
}

impl<F: FnMut(Collision) -> Result<(), ObserverError>> CollisionDetector<F> {
    /// Passes each contact to `sink` when it ends.
    pub fn new(sink: F) -> Self {
        Self {
            distances: vec![],
            deflections: vec![],
            forces: vec![],
            earlier: vec![],
            earlier_step_s: 0.0,
            steps_apart: 0,
            open: vec![],
            sink,
        }
    }

    /// Passes on the contacts that are still closed at `time_s`.
    ///
    /// # Errors
    /// Those of the sink.
    pub fn close(&mut self, time_s: f64) -> Result<(), ObserverError> {
        for collision in self.open.iter_mut().filter_map(Option::take) {
            (self.sink)(Collision {
                duration_s: time_s - collision.start_s,
                ..collision
            })?;
        }
        Ok(())
    }
}

/// A ball and the ball ahead within a step.
pub(crate) struct Pair<'s, 'v> {
    view: &'s StepView<'v>,
    ball: usize,
    next_ball: usize,
    /// Distance of their centres at which they touch.
    distance_m: f64,
}

impl<'s, 'v> Pair<'s, 'v> {
    /// Ball `k` and the ball ahead, which touch at `distance_m` between their centres.
    pub(crate) fn new(view: &'s StepView<'v>, k: usize, distance_m: f64) -> Self {
        Self {
            view,
            ball: k,
            next_ball: view.layout().next(k),
            distance_m,
        }
    }

    fn at(&self, coordinate: BallCoordinate, time_s: f64) -> [f64; 2] {
        let layout = self.view.layout();
        [self.ball, self.next_ball]
            .map(|ball| (self.view.step).interpolate(layout.ball(coordinate, ball), time_s))
    }

    fn offset(&self, coordinate: BallCoordinate, time_s: f64) -> f64 {
        let [own, next] = self.at(coordinate, time_s);
        next - own
    }

    fn deflection_m(&self, time_s: f64) -> f64 {
        let offset = |coordinate| self.offset(coordinate, time_s);
        self.distance_m - offset(BallCoordinate::X).hypot(offset(BallCoordinate::Y))
    }

    /// When the surfaces touch or part within the step; `otherwise` if rounding hides it at an end.
    fn crossing_s(&self, otherwise: f64) -> f64 {
        let (from, to) = (self.view.step.t0_s, self.view.step.t1_s);
        let deflection = |time_s| self.deflection_m(time_s);
        root::brent(deflection, from, to, 1e-6 * (to - from)).unwrap_or(otherwise)
    }

    /// The contact that begins within the step. One that is closed at the start of the run has no
    /// approach speed.
    pub(crate) fn touch(&self) -> Collision {
        let from = self.view.step.t0_s;
        let start_s = self.crossing_s(from);
        let closed = start_s == 0.0 && self.deflection_m(start_s) > 0.0;
        let [x, y] = [BallCoordinate::X, BallCoordinate::Y].map(|c| self.at(c, start_s));
        let offset = |coordinate| self.offset(coordinate, start_s);
        let (dx, dy) = (offset(BallCoordinate::X), offset(BallCoordinate::Y));
        let (dvx, dvy) = (offset(BallCoordinate::Vx), offset(BallCoordinate::Vy));
        Collision {
            start_s,
            ball: self.ball,
            next_ball: self.next_ball,
            angle_rad: (x[0] + x[1]).atan2(-(y[0] + y[1])),
            approach_speed_m_s: match closed {
                true => 0.0,
                false => -(dvx * dx + dvy * dy) / dx.hypot(dy),
            },
            ..Collision::default()
        }
    }
}

impl<F: FnMut(Collision) -> Result<(), ObserverError>> Observer for CollisionDetector<F> {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let n = context.model.balls();
        self.distances = (0..n).map(|k| context.model.pair_distance_m(k)).collect();
        self.forces = vec![0.0; n];
        self.earlier = vec![0.0; n];
        self.open = vec![None; n];
        let (x, y) = (context.start.x_m(), context.start.y_m());
        self.deflections = vec![0.0; n];
        for k in 0..n {
            let next = context.model.layout().next(k);
            self.deflections[k] = self.distances[k] - (x[next] - x[k]).hypot(y[next] - y[k]);
            self.open[k] = (self.deflections[k] > 0.0).then(|| Collision {
                ball: k,
                next_ball: next,
                angle_rad: (x[k] + x[next]).atan2(-(y[k] + y[next])),
                ..Collision::default()
            });
        }
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        self.steps_apart = match view.contacts.balls_touch() {
            true => 0,
            false => self.steps_apart + 1,
        };
        if self.steps_apart < 3 {
            self.follow(view)?;
        }
        self.earlier_step_s = view.step.size_s();
        Ok(Control::Continue(()))
    }
}

impl<F: FnMut(Collision) -> Result<(), ObserverError>> CollisionDetector<F> {
    /// Follows the contacts of all pairs through a step.
    #[inline(never)] // most steps have none
    fn follow(&mut self, view: &StepView<'_>) -> Result<(), ObserverError> {
        let c = &view.contacts;
        let (from, to) = (view.step.t0_s, view.step.t1_s);
        for k in 0..c.balls() {
            let (before, after) = (self.deflections[k], c.pair_deflection_m(k));
            let (force_before, force) = (self.forces[k], c.pair_force_n(k));
            (self.deflections[k], self.forces[k]) = (after, force);
            let earlier = std::mem::replace(&mut self.earlier[k], force_before);
            if before <= 0.0 && after <= 0.0 {
                continue;
            }
            let pair = Pair::new(view, k, self.distances[k]);
            let mut since = from;
            if before <= 0.0 {
                let touch = pair.touch();
                since = touch.start_s;
                self.open[k] = Some(touch);
            }
            if let Some(collision) = &mut self.open[k] {
                let around = [earlier, force_before, force];
                let peak = parabola_peak(around, self.earlier_step_s, to - from);
                collision.peak_force_n = collision.peak_force_n.max(peak);
            }
            let until = if after > 0.0 { to } else { pair.crossing_s(to) };
            if let Some(mut collision) = self.open[k] {
                collision.impulse_n_s += 0.5 * (until - since) * (force_before + force);
                if after > 0.0 {
                    self.open[k] = Some(collision);
                } else {
                    self.open[k] = None;
                    collision.duration_s = until - collision.start_s;
                    (self.sink)(collision)?;
                }
            }
        }
        Ok(())
    }
}

/// Highest value of the parabola through three values, `before` and `after` apart, if the
/// middle one is the largest and the others are above zero; else the largest value.
fn parabola_peak([a, b, c]: [f64; 3], before: f64, after: f64) -> f64 {
    let largest = a.max(b).max(c);
    // Where a force is clamped or begins it is no parabola.
    if !(a > 0.0 && c > 0.0 && b > a && b > c) {
        return largest;
    }
    // b + s·t − q·t², by divided differences.
    let (rise, fall) = ((b - a) / before, (b - c) / after);
    let q = (rise + fall) / (before + after);
    let s = rise - q * before;
    b + s * s / (4.0 * q)
}
