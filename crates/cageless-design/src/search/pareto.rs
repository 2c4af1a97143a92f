//! Objectives, Pareto front and compromise choice of a search.

/// Number of objectives.
pub(crate) const OBJECTIVES: usize = 7;

/// Differences below this fraction of the range count as none.
pub(crate) const RESOLUTION: f64 = 0.01;

/// Scale of the objectives: smallest and largest on the front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObjectiveScale {
    low: [f64; OBJECTIVES],
    high: [f64; OBJECTIVES],
}

impl ObjectiveScale {
    /// Scale over a set of objectives; `None` if the set is empty.
    pub fn new<'a>(all: impl IntoIterator<Item = &'a [f64; OBJECTIVES]>) -> Option<Self> {
        let mut scale: Option<Self> = None;
        for one in all {
            let s = scale.get_or_insert(Self {
                low: *one,
                high: *one,
            });
            for k in 0..OBJECTIVES {
                s.low[k] = s.low[k].min(one[k]);
                s.high[k] = s.high[k].max(one[k]);
            }
        }
        scale
    }

    fn range(&self, k: usize) -> f64 {
        self.high[k] - self.low[k]
    }

    /// Distance from the best that any has in each objective, root mean square over the
    /// objectives, 0 to 1 within the scale: compromise programming (Zeleny 1973) with equal
    /// weights.
    pub fn distance(&self, one: &[f64; OBJECTIVES]) -> f64 {
        let square = |k: usize| {
            let range = self.range(k);
            // What is the same for all does not decide.
            if range > 0.0 {
                ((one[k] - self.low[k]) / range).powi(2)
            } else {
                0.0
            }
        };
        ((0..OBJECTIVES).map(square).sum::<f64>() / OBJECTIVES as f64).sqrt()
    }
}

/// Indices of those that no other beats: none is at least as good in everything, to
/// [`RESOLUTION`] of the range, and better by more than that in something.
pub(crate) fn pareto_front(all: &[[f64; OBJECTIVES]]) -> Vec<usize> {
    let Some(scale) = ObjectiveScale::new(all) else {
        return vec![];
    };
    let beats = |a: &[f64; OBJECTIVES], b: &[f64; OBJECTIVES]| {
        let better = |k: usize| (b[k] - a[k]) / scale.range(k).max(f64::MIN_POSITIVE);
        (0..OBJECTIVES).all(|k| better(k) >= 0.0) && (0..OBJECTIVES).any(|k| better(k) > RESOLUTION)
    };
    (0..all.len())
        .filter(|&k| !all.iter().any(|other| beats(other, &all[k])))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(first: f64, second: f64) -> [f64; OBJECTIVES] {
        let mut all = [1.0; OBJECTIVES];
        all[0] = first;
        all[1] = second;
        all
    }

    #[test]
    fn the_front_of_a_staircase() {
        let all = [
            point(0.0, 4.0),
            point(1.0, 1.0),
            point(4.0, 0.0),
            point(2.0, 2.0),
            point(4.0, 1.0),
        ];
        assert_eq!(pareto_front(&all), [0, 1, 2]);
        assert!(pareto_front(&[]).is_empty());
        // All the same: none beats another.
        assert_eq!(pareto_front(&[point(1.0, 1.0); 3]), [0, 1, 2]);
    }

    /// Candidates worse by less than the resolution in one objective, and better in none, stay.
    #[test]
    fn differences_within_the_resolution_count_as_none() {
        for k in 0..OBJECTIVES {
            let (best, mut other, far) = ([1.0; OBJECTIVES], [1.0; OBJECTIVES], [2.0; OBJECTIVES]);
            other[k] = 1.0 + 0.995 * RESOLUTION;
            assert_eq!(pareto_front(&[best, other, far]), [0, 1], "{k}");
            other[k] = 1.0 + 1.005 * RESOLUTION;
            assert_eq!(pareto_front(&[best, other, far]), [0], "{k}");
            // Better in something else, however little: no other is as good in everything.
            other[(k + 1) % OBJECTIVES] = 0.999_999;
            assert_eq!(pareto_front(&[best, other, far]), [0, 1], "{k}");
        }
        assert_eq!(RESOLUTION, 0.01);
    }

    #[test]
    fn the_corner_of_the_front_is_nearest_to_the_best() {
        let all = [point(0.0, 4.0), point(1.0, 1.0), point(4.0, 0.0)];
        let scale = ObjectiveScale::new(&all).unwrap();
        let distances = all.map(|p| scale.distance(&p));
        assert!(distances[1] < distances[0] && distances[1] < distances[2]);
        let expected = (2.0 * 0.25f64.powi(2) / OBJECTIVES as f64).sqrt();
        assert!((distances[1] - expected).abs() < 1e-15);
    }
}
