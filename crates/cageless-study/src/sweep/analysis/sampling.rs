//! Inputs that are drawn, and the rows that share a draw.

use crate::sweep::variants::column_name;

/// Points of which sums are kept, at most; with more, rows count as independent.
pub(super) const POINTS_MAX: u64 = 2048;

/// Origin of the drawn values of an input: points, draws or rows independent of one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Drawn {
    /// The points of `[samples]`, each at all nodes of the grid and with all draws of `[scatter]`.
    Sample,
    /// The draws of `[scatter]`, each at all nodes of the grid.
    Draw,
    /// Each row: an axis of the grid with scatter about its values.
    Row,
}

/// `[samples]` and `[scatter]` of a plan.
#[derive(Debug, Default)]
pub(super) struct Sampling {
    samples: u64,
    repeats: u64,
    /// Section of the plan and column of each key.
    keys: Vec<(String, String)>,
}

impl Sampling {
    /// Sampling of a plan in its normal form.
    pub(super) fn of(plan: &str) -> Self {
        let mut sampling = Self {
            samples: 1,
            repeats: 1,
            keys: vec![],
        };
        for (path, value) in plan.lines().filter_map(|line| line.split_once(" = ")) {
            match path.split_once('.') {
                Some(("samples", "count")) => sampling.samples = value.parse().unwrap_or(1),
                Some(("scatter", "repeats")) => sampling.repeats = value.parse().unwrap_or(1),
                Some((section, key)) => {
                    let key = (section.to_owned(), column_name(key));
                    sampling.keys.push(key);
                }
                None => {}
            }
        }
        sampling
    }

    /// Origin of the drawn values of an input; `None` of an axis of the grid.
    pub(super) fn drawn(&self, column: &str) -> Option<Drawn> {
        let is_in = |section: &str| self.keys.iter().any(|(s, c)| s == section && c == column);
        match (is_in("grid"), is_in("samples"), is_in("scatter")) {
            (true, _, true) => Some(Drawn::Row),
            (_, _, true) => Some(Drawn::Draw),
            (_, true, _) => Some(Drawn::Sample),
            _ => None,
        }
    }

    /// Number of points in `rows` rows.
    pub(super) fn points(&self, drawn: Drawn, rows: u64) -> u64 {
        match drawn {
            Drawn::Sample => self.samples.min(rows),
            Drawn::Draw => (self.samples * self.repeats).min(rows),
            Drawn::Row => rows,
        }
    }

    /// Point of a variant, of those of which sums are kept.
    pub(super) fn point(&self, drawn: Drawn, variant: u64) -> Option<usize> {
        let (point, count) = match drawn {
            Drawn::Sample => (variant / self.repeats % self.samples, self.samples),
            Drawn::Draw => {
                let count = self.samples * self.repeats;
                (variant % count, count)
            }
            Drawn::Row => return None,
        };
        (count <= POINTS_MAX).then_some(point as usize)
    }
}
