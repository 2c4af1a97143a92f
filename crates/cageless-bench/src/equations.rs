//! Right-hand sides that every solver here can call: dz/dt = f(z), z the states over
//! their scales.

use cageless::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use cageless::dynamics::state::State;
use cageless::dynamics::{Model, RightHandSide};
use cageless::integrator::System;
use cageless::{Case, InputError};

use crate::problem;
use crate::textbook::Textbook;

/// Equations of motion on the scaled states of [`problem::scaled`].
pub trait Equations {
    /// Writes dz/dt at `z`.
    fn derivative(&mut self, z: &[f64], dzdt: &mut [f64]);

    /// Evaluations so far.
    fn evaluations(&self) -> u64;
}

/// Which implementation of the equations a solver is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Implementation {
    /// [`RightHandSide`] of the library: vector instructions, polynomial for r,
    /// energy ledger.
    Library,
    /// [`Textbook`]: one ball after the other, one contact after the other.
    Textbook,
}

impl Implementation {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Library, Self::Textbook];

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Library => "library",
            Self::Textbook => "textbook",
        }
    }

    /// Calls `work` with the equations of `case`.
    ///
    /// # Errors
    /// The case is impossible.
    pub fn with<T>(
        self,
        case: &Case,
        work: impl FnOnce(&mut dyn Equations) -> T,
    ) -> Result<T, InputError> {
        let model = Model::new(case)?;
        Ok(match self {
            Self::Library => work(&mut Library::new(&model, RightHandSide::new(&model))),
            Self::Textbook => work(&mut Scaled::new(Textbook::new(case))),
        })
    }
}

/// The library's right-hand side, its padding and its energy ledger hidden.
pub struct Library<'m> {
    rhs: RightHandSide<'m>,
    balls: usize,
    scales: Vec<f64>,
    state: State,
    rate: Vec<f64>,
}

impl<'m> Library<'m> {
    /// Around a right-hand side of `model`.
    pub fn new(model: &'m Model, rhs: RightHandSide<'m>) -> Self {
        let state = State::new(model.balls());
        Self {
            rhs,
            balls: model.balls(),
            scales: problem::scales(model.balls()),
            rate: vec![0.0; state.layout().len()],
            state,
        }
    }
}

impl Equations for Library<'_> {
    fn derivative(&mut self, z: &[f64], dzdt: &mut [f64]) {
        let (n, layout) = (self.balls, self.state.layout());
        let values = self.state.values_mut();
        for coordinate in BallCoordinate::ALL {
            let group = coordinate as usize;
            let scale = self.scales[group * n];
            let into = &mut values[layout.array(coordinate)..][..n];
            for (v, z) in into.iter_mut().zip(&z[group * n..]) {
                *v = z * scale;
            }
        }
        for coordinate in RingCoordinate::ALL {
            let k = coordinate as usize;
            values[layout.ring(coordinate)] = z[5 * n + k] * self.scales[5 * n + k];
        }
        self.rhs
            .derivative(0.0, self.state.values(), &mut self.rate);
        for coordinate in BallCoordinate::ALL {
            let group = coordinate as usize;
            let inverse = 1.0 / self.scales[group * n];
            let from = &self.rate[layout.array(coordinate)..][..n];
            for (d, rate) in dzdt[group * n..].iter_mut().zip(from) {
                *d = rate * inverse;
            }
        }
        for coordinate in RingCoordinate::ALL {
            let k = coordinate as usize;
            dzdt[5 * n + k] = self.rate[layout.ring(coordinate)] / self.scales[5 * n + k];
        }
    }

    fn evaluations(&self) -> u64 {
        self.rhs.evaluations()
    }
}

/// The textbook's right-hand side on scaled states.
pub struct Scaled {
    textbook: Textbook,
    scales: Vec<f64>,
    y: Vec<f64>,
    evaluations: u64,
}

impl Scaled {
    /// Around a textbook.
    pub fn new(textbook: Textbook) -> Self {
        let scales = problem::scales(textbook.balls());
        Self {
            y: vec![0.0; scales.len()],
            textbook,
            scales,
            evaluations: 0,
        }
    }
}

impl Equations for Scaled {
    fn derivative(&mut self, z: &[f64], dzdt: &mut [f64]) {
        self.evaluations += 1;
        for ((y, z), scale) in self.y.iter_mut().zip(z).zip(&self.scales) {
            *y = z * scale;
        }
        self.textbook.derivative(&self.y, dzdt);
        for (d, scale) in dzdt.iter_mut().zip(&self.scales) {
            *d /= scale;
        }
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both implementations along the reference trajectory, rates over a millisecond in
    /// the scales of the states.
    #[test]
    fn the_textbook_says_what_the_library_says() {
        let mut touching = 0;
        for state in crate::instructions::states_on_the_way(800, 5e-5).unwrap() {
            let (x, y) = (state.x_m(), state.y_m());
            let n = x.len();
            touching += (0..n)
                .filter(|&k| {
                    let next = (k + 1) % n;
                    (x[next] - x[k]).hypot(y[next] - y[k]) < 2.0 * 4.7625e-3
                })
                .count();
            let z = problem::scaled(&state);
            let case = problem::cb74(&[]).unwrap();
            let [a, b] = Implementation::ALL.map(|which| {
                let mut rate = vec![0.0; z.len()];
                which.with(&case, |f| f.derivative(&z, &mut rate)).unwrap();
                rate
            });
            for (k, (a, b)) in a.iter().zip(&b).enumerate() {
                assert!((a - b).abs() * 1e-3 < 1e-9, "state {k}: {a} {b}");
            }
        }
        assert!(touching > 0, "no contact between balls among the states");
    }
}
