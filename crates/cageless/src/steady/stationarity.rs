//! Whether a measured time is stationary, by a test on the runs themselves.

use super::recorder::SteadyBlock;
use crate::numerics::moments::Moments;
use crate::numerics::student::two_sided_limit;

/// Quantity to be settled in the runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settling {
    /// Standard deviation of the gaps.
    Spacing,
    /// Contacts between balls per second.
    Contacts,
    /// Standard deviation of the force on the outer ring.
    Force,
}

impl Settling {
    /// Every one.
    pub(crate) const ALL: [Self; 3] = [Self::Spacing, Self::Contacts, Self::Force];

    /// Name in sentences.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Spacing => "the scatter of the gaps",
            Self::Contacts => "the rate of contacts between balls",
            Self::Force => "the variation of the force",
        }
    }

    /// Change from the first to the second half beyond which a run is not stationary, of the mean of both.
    pub fn limit(self) -> f64 {
        match self {
            Self::Spacing => 0.05,
            Self::Contacts => 0.25,
            Self::Force => 0.1,
        }
    }

    /// Value of the quantity over some blocks.
    fn value(self, blocks: &[SteadyBlock]) -> f64 {
        let sum = |of: &dyn Fn(&SteadyBlock) -> f64| blocks.iter().map(of).sum::<f64>();
        match self {
            Self::Contacts => sum(&|b| b.contacts.all as f64) / sum(&|b| b.time_s),
            Self::Spacing => mean(blocks, |b| &b.gap_variance).sqrt(),
            Self::Force => {
                let square = |b: &SteadyBlock| {
                    let [x, y] = b.force_n.map(|f| f.deviation());
                    x * x + y * y
                };
                (sum(&square) / blocks.len() as f64).sqrt()
            }
        }
    }
}

fn mean(blocks: &[SteadyBlock], of: impl Fn(&SteadyBlock) -> &Moments) -> f64 {
    let (weight, sum) = blocks.iter().fold((0.0, 0.0), |(weight, sum), block| {
        let moments = of(block);
        (weight + moments.weight, sum + moments.weight * moments.mean)
    });
    sum / weight
}

/// Probability of calling a run stationary that changes by the limit.
const RISK: f64 = 0.05;

/// Change of one quantity over the measured time of several runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stationarity {
    /// The quantity.
    pub of: Settling,
    /// Mean change from the first to the second half over the mean of both.
    pub change: f64,
    /// One-sided error of the change at a risk of 5 % (Student).
    pub error: f64,
}

impl Stationarity {
    /// Changes in runs with these blocks, each of two runs or more.
    pub fn all(runs: &[&[SteadyBlock]]) -> Vec<Self> {
        let of = |of: Settling| {
            let mut moments = Moments::default();
            for blocks in runs {
                let (first, second) = blocks.split_at(blocks.len() / 2);
                let (first, second) = (of.value(first), of.value(second));
                let whole = 0.5 * (first + second);
                let change = (second - first) / whole;
                moments.add(if whole == 0.0 { 0.0 } else { change }, 1.0);
            }
            let freedoms = (runs.len() - 1).max(1);
            Self {
                of,
                change: moments.mean,
                error: two_sided_limit(2.0 * RISK, freedoms) * moments.deviation()
                    / (freedoms as f64).sqrt(),
            }
        };
        Settling::ALL.map(of).to_vec()
    }

    /// Whether the change is within a limit beyond its error: an equivalence test (TOST), which calls less than 5 %
    /// of the runs stationary that change by the limit.
    pub(crate) fn is_within(&self, limit: f64) -> bool {
        self.change.abs() + self.error <= limit
    }

    /// Reason for which the runs are not stationary, with this limit of the change; `None` if they are.
    pub fn reason(&self, limit: f64) -> Option<String> {
        (!self.is_within(limit)).then(|| {
            format!(
                "{} changes by {:+.0} ± {:.0} % from the first to the second half of the measured time ({:.0} % at most, with the error)",
                self.of.label(),
                100.0 * self.change,
                100.0 * self.error,
                100.0 * limit
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact_tracker::ContactCounts;
    use crate::numerics::random::RandomStream;

    fn runs(stream: &mut RandomStream, trend: f64) -> Vec<Vec<SteadyBlock>> {
        let block = |k: usize, stream: &mut RandomStream| {
            // A trend of the standard deviation over the halves, whose middles are 8 blocks apart.
            let factor = 1.0 + trend * (k as f64 - 7.5) / 8.0 + 0.02 * stream.normal();
            let mut block = SteadyBlock {
                time_s: 0.1,
                contacts: ContactCounts {
                    all: 100,
                    ..ContactCounts::default()
                },
                ..SteadyBlock::default()
            };
            block.gap_variance.add(factor * factor, 1.0);
            for value in [-1.0, 1.0] {
                block.force_n.iter_mut().for_each(|f| f.add(value, 1.0));
            }
            block
        };
        (0..8)
            .map(|_| (0..16).map(|k| block(k, stream)).collect())
            .collect()
    }

    /// Runs whose spacing changes by its limit are called stationary in at most 5 % of the trials, those
    /// without a trend nearly always.
    #[test]
    fn runs_that_change_by_the_limit_are_rarely_called_stationary() {
        let mut stream = RandomStream::new(3, 1, 0, 0);
        let mut stationary = |trend: f64, trials: usize| {
            let found = (0..trials).filter(|_| {
                let runs = runs(&mut stream, trend);
                let blocks: Vec<&[SteadyBlock]> = runs.iter().map(Vec::as_slice).collect();
                Stationarity::all(&blocks)
                    .iter()
                    .all(|found| found.is_within(found.of.limit()))
            });
            found.count() as f64 / trials as f64
        };
        let wrong = stationary(Settling::Spacing.limit(), 2000);
        assert!(wrong < 0.065, "{wrong}");
        assert!(stationary(0.0, 200) > 0.95);
    }
}
