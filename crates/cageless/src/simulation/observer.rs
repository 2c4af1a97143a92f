//! Observers of a run.

use std::cell::RefCell;
use std::sync::Arc;

use crate::case::Case;
use crate::control::Control;
use crate::dynamics::coordinates::{BallCoordinate, OuterRingCoordinate};
use crate::dynamics::layout::{Balls, Layout};
use crate::dynamics::state::State;
use crate::dynamics::{Contacts, Model, RightHandSide};
use crate::integrator::StepState;
use crate::numerics::angle::unwrap_angle_rad;
use crate::numerics::vector::PlaneVector;
use crate::snapshot::Snapshot;

/// Error of an observer, for example a file that cannot be written.
pub type ObserverError = Box<dyn std::error::Error + Send + Sync>;

/// Case, equations and initial state of a run.
#[derive(Clone, Copy)]
pub struct RunContext<'a> {
    /// The case.
    pub case: &'a Case,
    /// Equations of motion of the case.
    pub model: &'a Arc<Model>,
    /// State at t = 0.
    pub start: &'a State,
    /// ψ of every ball at t = 0.
    pub start_angle_rad: &'a [f64],
}

/// One step of a run.
#[derive(Clone, Copy)]
pub struct StepView<'a> {
    /// States and rates at both ends, perhaps with those of other bearings in between:
    /// [`Self::layout`] has the places.
    pub step: &'a StepState,
    /// Contacts at the end of the step.
    pub(crate) contacts: Contacts<'a>,
    /// Constants of the bearing.
    pub(super) model: &'a Model,
    /// A second right-hand side for snapshots within the step.
    pub(super) interpolator: &'a RefCell<RightHandSide>,
    /// Continuous ψ of each ball less than half a turn ago.
    pub(super) recent_angle_rad: &'a [f64],
    pub(super) layout: &'a Layout,
}

impl StepView<'_> {
    /// Places of this bearing in the vectors of the step.
    #[inline]
    pub fn layout(&self) -> Layout {
        *self.layout
    }

    /// One coordinate of the balls at the end of the step.
    #[inline]
    pub(crate) fn after(&self, coordinate: BallCoordinate) -> Balls<'_> {
        self.layout.balls_of(&self.step.y1, coordinate)
    }

    /// x and y of the balls at the end of the step.
    #[inline]
    pub(crate) fn positions(&self) -> PlaneVector<Balls<'_>> {
        PlaneVector {
            x: self.after(BallCoordinate::X),
            y: self.after(BallCoordinate::Y),
        }
    }

    /// Continuous ψ of ball `k` at `time_s` within the step.
    pub fn angle_rad(&self, k: usize, time_s: f64) -> f64 {
        let place = self.ball_at_m(k, time_s);
        let centre = self.outer_ring_at_m(time_s);
        self.angle_at(place.from(centre), k).rad()
    }

    /// Continuous ψ of ball `k` at the end of the step.
    pub fn angle_after_rad(&self, k: usize) -> f64 {
        self.ball_angle(k).rad()
    }

    /// Continuous ψ of ball `k` at the end of the step, to be worked out when it is wanted.
    #[inline]
    pub(crate) fn ball_angle(&self, k: usize) -> BallAngle {
        self.angle_at(self.about_outer_ring_m(k), k)
    }

    /// Place of ball `k` about the centre of the outer ring at the end of the step.
    #[inline]
    pub(crate) fn about_outer_ring_m(&self, k: usize) -> PlaneVector {
        self.ball_m(k).from(self.outer_ring_m())
    }

    /// Place of ball `k` at the end of the step.
    #[inline]
    pub(crate) fn ball_m(&self, k: usize) -> PlaneVector {
        let at = |coordinate| self.step.y1[self.layout.ball(coordinate, k)];
        PlaneVector {
            x: at(BallCoordinate::X),
            y: at(BallCoordinate::Y),
        }
    }

    /// Place of ball `k` at `time_s` within the step.
    pub(crate) fn ball_at_m(&self, k: usize, time_s: f64) -> PlaneVector {
        let at = |coordinate| {
            self.step
                .interpolate(self.layout.ball(coordinate, k), time_s)
        };
        PlaneVector {
            x: at(BallCoordinate::X),
            y: at(BallCoordinate::Y),
        }
    }

    /// Continuous ψ of ball `k` at a place about the centre of the outer ring.
    #[inline]
    fn angle_at(&self, place_m: PlaneVector, k: usize) -> BallAngle {
        BallAngle {
            place_m,
            recent_rad: self.recent_angle_rad[k],
        }
    }

    /// Centre of the outer ring at the end of the step: the origin unless it moves on a support.
    #[inline]
    pub(crate) fn outer_ring_m(&self) -> PlaneVector {
        self.layout.outer_ring_motion(&self.step.y1).place()
    }

    /// ωi at the end of the step over the largest of the case; exactly 1 at constant speed.
    pub(crate) fn inner_speed_ratio(&self, case: &Case) -> f64 {
        match self.layout.ring_speed_rad_s(&self.step.y1) {
            Some(speed) => speed.abs() / case.largest_inner_speed_rad_s().max(f64::MIN_POSITIVE),
            None => case.inner_speed_ratio(self.step.t1_s),
        }
    }

    /// Centre of the outer ring at `time_s` within the step.
    pub(crate) fn outer_ring_at_m(&self, time_s: f64) -> PlaneVector {
        let at = |c: OuterRingCoordinate| match self.layout.moves(c) {
            true => self.step.interpolate(self.layout.body(c), time_s),
            false => 0.0,
        };
        PlaneVector {
            x: at(OuterRingCoordinate::X),
            y: at(OuterRingCoordinate::Y),
        }
    }

    /// State at `time_s` within the step, by interpolation.
    pub fn state(&self, time_s: f64) -> State {
        State::from_vector(*self.layout, &self.step.interpolate_all(time_s))
    }

    /// Snapshot at `time_s` within the step, by interpolation.
    pub fn snapshot(&self, time_s: f64) -> Snapshot {
        let state = self.state(time_s);
        let (x, y) = (state.x_m(), state.y_m());
        let centre = state.outer_ring_motion().place();
        let about = |k: usize| PlaneVector { x: x[k], y: y[k] }.from(centre);
        let angle = |k| self.angle_at(about(k), k);
        let angles: Vec<f64> = (0..self.layout.balls).map(|k| angle(k).rad()).collect();
        self.interpolator
            .borrow_mut()
            .snapshot_within(time_s, &state, &angles, &self.contacts)
    }
}

/// Continuous ψ of a ball by its place about the centre of the outer ring and ψ less than half a turn
/// before.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BallAngle {
    place_m: PlaneVector,
    recent_rad: f64,
}

impl BallAngle {
    /// The angle, rad.
    pub(crate) fn rad(&self) -> f64 {
        unwrap_angle_rad(self.place_m.x.atan2(-self.place_m.y), self.recent_rad)
    }
}

/// Observer of a run, called after every step.
pub trait Observer {
    /// Called once, before the first step.
    ///
    /// # Errors
    /// Ends the run.
    fn begin(&mut self, _context: &RunContext<'_>) -> Result<(), ObserverError> {
        Ok(())
    }

    /// Called after each step; `Break(())` ends the run.
    ///
    /// # Errors
    /// Ends the run.
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError>;
}

/// A closure that sees every step; `Break(())` ends the run.
impl<F: FnMut(&StepView<'_>) -> Control> Observer for F {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        Ok(self(view))
    }
}

/// The closure `watch`, which is an observer, with the type of what it sees.
pub fn each_step<F: FnMut(&StepView<'_>) -> Control>(watch: F) -> F {
    watch
}
