//! Classification of one result: converged, statistical or biased by the step.

use super::quantity::Quantity;

crate::named_enum! {
    /// Classification of a result under perturbation of the initial state and halving of the step.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Convergence {
        /// Halving the step and perturbing the initial state change it by less than the tolerance.
        Converged = "converged",
        /// Depends on the initial state but not on the step: one sample of a distribution, known to
        /// its standard error.
        Statistical = "statistical",
        /// Changes with the step by more than the scatter explains.
        StepBiased = "step-biased",
    }
}

/// Samples of one result; that of the given start comes first.
pub(super) struct Samples<'a> {
    /// Given start and small perturbations.
    pub perturbed: &'a [f64],
    /// Given start and large perturbations.
    pub full: &'a [f64],
    /// Samples at half the step.
    pub half: &'a [f64],
}

/// Statistics of one result at the step and at half the step, in the unit of the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Judgement<Q = Quantity> {
    /// Result that is classified.
    pub quantity: Q,
    /// Classification.
    pub verdict: Convergence,
    /// Value of the run.
    pub value: f64,
    /// Value at half the step, from the same start.
    pub half_step_value: f64,
    /// Largest change of a converged result.
    pub tolerance: f64,
    /// Largest change by halving the step, over the given start and the large perturbations.
    pub step_change: f64,
    /// Largest change by a small perturbation of the start.
    pub start_change: f64,
    /// Mean of the runs at the step.
    pub mean: f64,
    /// Mean of the runs at half the step.
    pub half_step_mean: f64,
    /// Standard deviation among runs at one step, from both steps together.
    pub spread: f64,
    /// Standard error of [`Self::mean`], spread/√replicas.
    pub standard_error: f64,
    /// Difference of the two means over its standard error, spread·√(2/replicas); infinite
    /// if there is a difference without spread.
    pub z: f64,
    /// A value at an instant beyond the predictability time: not converged even if it
    /// happens to change little.
    pub beyond_predictability: bool,
}

impl<Q> Judgement<Q> {
    /// Classifies a result.
    pub(super) fn new(
        quantity: Q,
        samples: &Samples<'_>,
        tolerance: f64,
        z_limit: f64,
        beyond_predictability: bool,
    ) -> Self {
        let Samples {
            perturbed,
            full,
            half,
        } = *samples;
        let count = full.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let (full_mean, half_mean) = (mean(full), mean(half));
        let squares = |values: &[f64], mean: f64| -> f64 {
            values.iter().map(|v| (v - mean) * (v - mean)).sum()
        };
        let freedoms = 2.0 * (count - 1.0);
        let spread = ((squares(full, full_mean) + squares(half, half_mean)) / freedoms).sqrt();
        let difference = half_mean - full_mean;
        let z = if difference == 0.0 {
            0.0
        } else {
            difference / (spread * (2.0 / count).sqrt())
        };
        let largest = |changes: &mut dyn Iterator<Item = f64>| {
            // NaN must not pass for a small change.
            changes.fold(0.0, |m: f64, c| if c.abs() <= m { m } else { c.abs() })
        };
        let step_change = largest(&mut full.iter().zip(half).map(|(a, b)| b - a));
        let start_change = largest(&mut perturbed.iter().map(|v| v - perturbed[0]));
        let unchanged = step_change <= tolerance && start_change <= tolerance;
        let verdict = if unchanged && !beyond_predictability {
            Convergence::Converged
        } else if unchanged || z.abs() <= z_limit {
            Convergence::Statistical
        } else {
            Convergence::StepBiased
        };
        Self {
            quantity,
            verdict,
            value: full[0],
            half_step_value: half[0],
            tolerance,
            step_change,
            start_change,
            mean: full_mean,
            half_step_mean: half_mean,
            spread,
            standard_error: spread / count.sqrt(),
            z,
            beyond_predictability,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(full: &[f64], half: &[f64], beyond: bool) -> Convergence {
        let samples = Samples {
            perturbed: full,
            full,
            half,
        };
        Judgement::new(Quantity::RingYMean, &samples, 1e-3, 4.0, beyond).verdict
    }

    #[test]
    fn each_word_means_what_it_says() {
        let steady = [1.0, 1.0001, 0.9999];
        let scattered = [1.0, 1.2, 0.9];
        let shifted = [2.0, 2.2, 1.9];
        assert_eq!(verdict(&steady, &steady, false), Convergence::Converged);
        // A point beyond the predictability time never converges.
        assert_eq!(verdict(&steady, &steady, true), Convergence::Statistical);
        assert_eq!(
            verdict(&scattered, &[1.1, 0.95, 1.05], false),
            Convergence::Statistical
        );
        assert_eq!(
            verdict(&scattered, &shifted, false),
            Convergence::StepBiased
        );
        // No chance at work, but a change with the step.
        assert_eq!(
            verdict(&[1.0; 3], &[1.01; 3], false),
            Convergence::StepBiased
        );
        assert_eq!(
            verdict(&[f64::NAN; 3], &[1.0; 3], false),
            Convergence::StepBiased
        );
    }
}
