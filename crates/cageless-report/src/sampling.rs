//! Thinning of long traces, so that a page stays small and no peak is lost.

use std::ops::Range;

/// Points of a line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Points {
    /// First coordinate of each.
    pub x: Vec<f64>,
    /// Second coordinate of each.
    pub y: Vec<f64>,
}

impl FromIterator<(f64, f64)> for Points {
    fn from_iter<I: IntoIterator<Item = (f64, f64)>>(points: I) -> Self {
        let (x, y) = points.into_iter().unzip();
        Self { x, y }
    }
}

/// Decimates a history to about `points` points: in each of `points`/2 segments the
/// lowest and the highest. A stretch with a gap (NaN) keeps it.
pub fn history(x: &[f64], y: &[f64], points: usize) -> Points {
    thinned(x, y, points, |stretch| {
        let finite = || stretch.clone().filter(|&i| y[i].is_finite());
        let low = finite().min_by(|&a, &b| y[a].total_cmp(&y[b]));
        let high = finite().max_by(|&a, &b| y[a].total_cmp(&y[b]));
        let hole = stretch.clone().find(|&i| !y[i].is_finite());
        let mut chosen: Vec<usize> = [low, high, hole].into_iter().flatten().collect();
        chosen.sort_unstable();
        chosen
    })
}

/// At most about `points` points of a curve in the plane: of each of `points`/2
/// stretches the first point and the one farthest from the stretch's chord.
pub fn curve(x: &[f64], y: &[f64], points: usize) -> Points {
    let n = x.len().min(y.len());
    let (sx, sy) = (extent(&x[..n]), extent(&y[..n]));
    thinned(x, y, points, |stretch| {
        let (from, end) = (stretch.start, stretch.end.min(n - 1));
        let (dx, dy) = ((x[end] - x[from]) / sx, (y[end] - y[from]) / sy);
        let off = |i: usize| ((x[i] - x[from]) / sx * dy - (y[i] - y[from]) / sy * dx).abs();
        let farthest = stretch.skip(1).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        std::iter::once(from).chain(farthest).collect()
    })
}

/// Both ends, so that the curve spans the same, and the points `of_stretch` of each of `points`/2
/// stretches.
fn thinned(
    x: &[f64],
    y: &[f64],
    points: usize,
    of_stretch: impl Fn(Range<usize>) -> Vec<usize>,
) -> Points {
    let n = x.len().min(y.len());
    if n <= points || points < 4 {
        return Points {
            x: x[..n].to_vec(),
            y: y[..n].to_vec(),
        };
    }
    let stretches = points / 2;
    let mut kept = vec![0];
    kept.extend(
        (0..stretches).flat_map(|k| of_stretch(k * n / stretches..(k + 1) * n / stretches)),
    );
    kept.push(n - 1);
    kept.dedup();
    let of = |values: &[f64]| kept.iter().map(|&i| values[i]).collect();
    Points { x: of(x), y: of(y) }
}

/// Largest less smallest; 1 if that is nothing.
fn extent(values: &[f64]) -> f64 {
    let (low, high) = range(values);
    if high > low { high - low } else { 1.0 }
}

/// Smallest and largest finite value; `(0, 0)` of none.
pub fn range(values: &[f64]) -> (f64, f64) {
    let mut finite = values.iter().copied().filter(|v| v.is_finite());
    let Some(first) = finite.next() else {
        return (0.0, 0.0);
    };
    finite.fold((first, first), |(low, high), v| (low.min(v), high.max(v)))
}

/// Angles in (−180, 180], with a NaN row wherever the angle jumps back, so that
/// a line against them breaks there.
pub fn wrapped(angle_deg: &[f64], values: &[f64]) -> Points {
    let (mut x, mut y) = (vec![], vec![]);
    for (&angle, &value) in angle_deg.iter().zip(values) {
        let local = angle - 360.0 * ((angle + 180.0) / 360.0).ceil() + 360.0;
        if x.last()
            .is_some_and(|&last: &f64| (local - last).abs() > 180.0)
        {
            x.push(f64::NAN);
            y.push(f64::NAN);
        }
        x.push(local);
        y.push(value);
    }
    Points { x, y }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_peaks_ends_and_holes() {
        let n = 100_000;
        let x: Vec<f64> = (0..n).map(f64::from).collect();
        let mut y: Vec<f64> = x.iter().map(|t| (t * 1e-3).sin()).collect();
        y[54_321] = 9.0;
        y[77_777] = f64::NAN;
        let Points { x: tx, y: ty } = history(&x, &y, 4000);
        assert!(tx.len() <= 4003 && tx.len() == ty.len());
        assert_eq!((tx[0], tx[tx.len() - 1]), (0.0, f64::from(n - 1)));
        assert!(ty.contains(&9.0) && ty.iter().any(|v| v.is_nan()));
        assert!(tx.windows(2).all(|w| w[0] < w[1]));
    }

    #[test]
    fn a_curve_keeps_its_spikes() {
        let n = 50_000;
        let angle = |k: i32| f64::from(k) / f64::from(n) * 6.0;
        let mut x: Vec<f64> = (0..n).map(|k| angle(k).cos()).collect();
        let y: Vec<f64> = (0..n).map(|k| angle(k).sin()).collect();
        x[12_345] = 1.7;
        let Points { x: tx, y: ty } = curve(&x, &y, 1000);
        assert!(tx.contains(&1.7) && tx.len() == ty.len() && tx.len() <= 1001);
    }

    #[test]
    fn angles_wrap_with_a_break() {
        let Points { x, y } = wrapped(&[170.0, 180.0, 190.0, 550.0], &[1.0, 2.0, 3.0, 4.0]);
        assert_eq!(&x[..2], &[170.0, 180.0]);
        assert!(x[2].is_nan() && y[2].is_nan());
        assert_eq!(x[3], -170.0);
        assert_eq!(x[4], -170.0);
    }
}
