//! The verdict on one number.

use super::quantity::Quantity;

/// What can be said of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Halving the step and turning the start change it by less than the tolerance.
    Converged,
    /// It changes with the start, and no more with the step: one draw of a distribution,
    /// known to its standard error.
    Statistical,
    /// It changes with the step by more than chance explains: biased by the step.
    Neither,
}

impl Verdict {
    /// Name in tables and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Statistical => "statistical",
            Self::Neither => "neither",
        }
    }
}

/// Values of one number, that of the given start first.
pub(super) struct Draws<'a> {
    /// Given and near starts.
    pub near: &'a [f64],
    /// Given and far starts.
    pub full: &'a [f64],
    /// The same at half the step.
    pub half: &'a [f64],
}

/// A number at the step and at half of it, from all starts. In the number's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Judgement {
    /// Which number.
    pub quantity: Quantity,
    /// What can be said of it.
    pub verdict: Verdict,
    /// Value of the run.
    pub value: f64,
    /// Value at half the step, from the same start.
    pub half_step_value: f64,
    /// Change that passes for converged.
    pub tolerance: f64,
    /// Largest change by halving the step, over the given start and the far ones.
    pub step_change: f64,
    /// Largest change by turning the start to a near one.
    pub turn_change: f64,
    /// Mean of the runs at the step.
    pub mean: f64,
    /// Mean of the runs at half the step.
    pub half_step_mean: f64,
    /// Standard deviation among runs at one step, from both steps together.
    pub spread: f64,
    /// Of [`Self::mean`]: spread/√members.
    pub standard_error: f64,
    /// Difference of the two means over its standard error, spread·√(2/members); infinite
    /// if there is a difference without spread.
    pub z: f64,
    /// A value at an instant beyond the predictability time: not converged even if it
    /// happens to change little.
    pub beyond_predictability: bool,
}

impl Judgement {
    /// Judges a number.
    pub(super) fn new(
        quantity: Quantity,
        draws: &Draws<'_>,
        tolerance: f64,
        z_limit: f64,
        beyond_predictability: bool,
    ) -> Self {
        let Draws { near, full, half } = *draws;
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
        let turn_change = largest(&mut near.iter().map(|v| v - near[0]));
        let unchanged = step_change <= tolerance && turn_change <= tolerance;
        let verdict = if unchanged && !beyond_predictability {
            Verdict::Converged
        } else if unchanged || z.abs() <= z_limit {
            Verdict::Statistical
        } else {
            Verdict::Neither
        };
        Self {
            quantity,
            verdict,
            value: full[0],
            half_step_value: half[0],
            tolerance,
            step_change,
            turn_change,
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

    fn verdict(full: &[f64], half: &[f64], beyond: bool) -> Verdict {
        let draws = Draws {
            near: full,
            full,
            half,
        };
        Judgement::new(Quantity::RingYMean, &draws, 1e-3, 4.0, beyond).verdict
    }

    #[test]
    fn each_word_means_what_it_says() {
        let steady = [1.0, 1.0001, 0.9999];
        let scattered = [1.0, 1.2, 0.9];
        let shifted = [2.0, 2.2, 1.9];
        assert_eq!(verdict(&steady, &steady, false), Verdict::Converged);
        // A point beyond the predictability time never converges.
        assert_eq!(verdict(&steady, &steady, true), Verdict::Statistical);
        assert_eq!(
            verdict(&scattered, &[1.1, 0.95, 1.05], false),
            Verdict::Statistical
        );
        assert_eq!(verdict(&scattered, &shifted, false), Verdict::Neither);
        // No chance at work, but a change with the step.
        assert_eq!(verdict(&[1.0; 3], &[1.01; 3], false), Verdict::Neither);
        assert_eq!(verdict(&[f64::NAN; 3], &[1.0; 3], false), Verdict::Neither);
    }
}
