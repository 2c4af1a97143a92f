//! Whatever watches a run.

use std::cell::RefCell;
use std::f64::consts::TAU;

use super::run::Control;
use crate::case::Case;
use crate::dynamics::{Model, RightHandSide};
use crate::integrator::{Step, hermite};
use crate::snapshot::Snapshot;
use crate::state::{Layout, State};

/// An observer could not go on (a file that cannot be written, say).
pub type ObserverError = Box<dyn std::error::Error + Send + Sync>;

/// What stays the same during a run.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The case.
    pub case: &'a Case,
    /// Its equations.
    pub model: &'a Model,
    /// State at t = 0.
    pub start: &'a State,
    /// ψ of every ball at t = 0.
    pub start_angle_rad: &'a [f64],
}

/// One step of a run.
pub struct View<'a, 'm> {
    /// States and rates at both ends.
    pub step: Step<'a>,
    /// The right-hand side, its work arrays as of the end of the step.
    pub rhs: &'a RightHandSide<'m>,
    /// A second right-hand side, to look at states within the step.
    pub probe: &'a RefCell<RightHandSide<'m>>,
    /// Full turns of each ball at the end of the step: ψ = turn·2π + atan2(x, −y).
    pub turns: &'a [i64],
}

impl View<'_, '_> {
    /// Layout of the states.
    pub fn layout(&self) -> Layout {
        self.rhs.model().layout()
    }

    /// Continuous ψ of ball `k` at `time_s` within the step.
    pub fn angle_rad(&self, k: usize, time_s: f64) -> f64 {
        let layout = self.layout();
        let x = hermite(&self.step, layout.group(0) + k, time_s);
        let y = hermite(&self.step, layout.group(1) + k, time_s);
        unwrap_angle(x.atan2(-y), self.angle_after_rad(k))
    }

    /// Continuous ψ of ball `k` at the end of the step.
    pub fn angle_after_rad(&self, k: usize) -> f64 {
        let layout = self.layout();
        let (x, y) = (
            self.step.after[layout.group(0) + k],
            self.step.after[layout.group(1) + k],
        );
        x.atan2(-y) + self.turns[k] as f64 * TAU
    }

    /// State at `time_s` within the step, by interpolation.
    pub fn state(&self, time_s: f64) -> State {
        let values = (0..self.step.after.len())
            .map(|k| hermite(&self.step, k, time_s))
            .collect();
        State::from_values(self.layout(), values)
    }

    /// Everything that can be seen at `time_s` within the step.
    pub fn snapshot(&self, time_s: f64) -> Snapshot {
        let state = self.state(time_s);
        let angles: Vec<f64> = (0..self.layout().balls)
            .map(|k| self.angle_rad(k, time_s))
            .collect();
        self.probe.borrow_mut().snapshot(time_s, &state, &angles)
    }
}

/// `angle` plus whole turns, next to `reference`.
pub(crate) fn unwrap_angle(angle: f64, reference: f64) -> f64 {
    angle + ((reference - angle) / TAU).round() * TAU
}

/// Watches a run step by step.
pub trait Observer {
    /// Called once, before the first step.
    ///
    /// # Errors
    /// Ends the run.
    fn begin(&mut self, _scene: &Scene<'_>) -> Result<(), ObserverError> {
        Ok(())
    }

    /// Called after each step; [`Control::Interrupt`] ends the run.
    ///
    /// # Errors
    /// Ends the run.
    fn step(&mut self, view: &View<'_, '_>) -> Result<Control, ObserverError>;
}
