//! Hatching of a cut face.

use super::paper::Place;

/// Lines at 45° within a closed outline, so far apart, mm.
pub(super) fn hatch(outline: &[Place], spacing_mm: f64) -> Vec<[Place; 2]> {
    // Along a line x + y is the same.
    let offsets = || outline.iter().map(|[x, y]| x + y);
    let (least, most) = offsets().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
        (a.min(v), b.max(v))
    });
    let count = ((most - least) / spacing_mm).floor() as usize;
    let lines = (1..=count).map(|k| least + (k as f64 - 0.5) * spacing_mm);
    lines.flat_map(|offset| within(outline, offset)).collect()
}

/// Stretches of the line x + y = `offset` inside of the outline.
fn within(outline: &[Place], offset: f64) -> Vec<[Place; 2]> {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    let mut crossings: Vec<Place> = edges
        .filter_map(|(a, b)| {
            let [before, after] = [a, b].map(|[x, y]| x + y - offset);
            ((before < 0.0) != (after < 0.0)).then(|| {
                let share = before / (before - after);
                [0, 1].map(|k| a[k] + share * (b[k] - a[k]))
            })
        })
        .collect();
    crossings.sort_by(|a, b| a[0].total_cmp(&b[0]));
    crossings
        .chunks_exact(2)
        .map(|pair| [pair[0], pair[1]])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The total length times the distance of the lines is the area, also of an outline with a notch.
    #[test]
    fn the_lines_cover_the_area() {
        let notched = [
            [0.0, 0.0],
            [40.0, 0.0],
            [40.0, 20.0],
            [25.0, 20.0],
            [20.0, 5.0],
            [15.0, 20.0],
            [0.0, 20.0],
        ];
        let spacing = 0.05;
        let lines = hatch(&notched, spacing);
        let length = |[a, b]: &[Place; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
        // Lines of x + y are spaced by their offset over √2.
        let area = lines.iter().map(length).sum::<f64>() * spacing / 2f64.sqrt();
        assert!((area - (800.0 - 75.0)).abs() < 1.0, "{area}");
        let outside = |[x, y]: &Place| (16.0..24.0).contains(x) && *y > 19.0;
        assert!(!lines.iter().flatten().any(outside));
    }
}
