//! Systems of differential equations.

use std::ops::Range;

/// A system of ordinary differential equations dy/dt = f(t, y).
pub trait System {
    /// Length of y.
    fn dimension(&self) -> usize;

    /// Writes f(t, y) into `dydt`.
    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]);

    /// Fingerprint of the smooth piece of f that the last evaluation lay in. Where it
    /// changes between two steps, f has jumped, or changed so abruptly that the history of
    /// a multistep method must not reach across. The system decides what counts.
    fn mode(&self) -> u64 {
        0
    }

    /// Appends functions of a state, that of the last evaluation, each smooth and zero at an edge of
    /// f: where f jumps or is not smooth. Always the same in the same order, in scales in which 1 is
    /// as large as what is of interest; for methods that end their steps there.
    fn edges(&self, _y: &[f64], _values: &mut Vec<f64>) {}

    /// Components that are positions and their rates, in ascending order of the positions;
    /// for methods that advance them one after the other.
    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &[]
    }

    /// Components that are velocities along x, and behind them those along y, of the same bodies: on curved planar
    /// paths, with forces that depend on the speed along the path; for methods that extrapolate them.
    fn planar_velocities(&self) -> Option<[Range<usize>; 2]> {
        None
    }

    /// Whether f has a stiff, dissipative part that acts on velocities and that
    /// [`Self::add_stiff_part`] solves for.
    fn has_stiff_part(&self) -> bool {
        false
    }

    /// Writes f(t, y) without its stiff part into `dydt`.
    fn nonstiff_derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.derivative(time_s, y, dydt);
    }

    /// Adds the stiff part g over a step of `h_s` from `y0`, implicitly: y holds what the rest of f
    /// leads to and becomes y + h·g, where g is that at the end, g(y + h·g), or a mean of both ends
    /// as stable; g is added to `dydt`. Positions and what depends on them are as of the last
    /// [`Self::nonstiff_derivative`].
    fn add_stiff_part(&mut self, _h_s: f64, _y0: &[f64], _y: &mut [f64], _dydt: &mut [f64]) {}

    /// Size of a difference of two states in the scales of the problem; 1 is as large
    /// as what is of interest.
    fn error_norm(&self, difference: &[f64]) -> f64 {
        difference.iter().fold(0.0, |m, d| m.max(d.abs()))
    }
}

/// Components that are positions and the components that are their rates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SecondOrderBlock {
    /// First position.
    pub positions: usize,
    /// First rate.
    pub rates: usize,
    /// Number of positions.
    pub count: usize,
}
