//! Critical gaps of the maps against closed forms: what sliding takes from them, before candidates are laid.

/// Critical gaps of the maps at the operating points over β0 of closed forms, line by line of constant θ.
pub(super) struct MeasuredSeparation {
    /// θ, with β0 over the steady gap and the critical gap over β0 of its cells, from the shallowest on.
    lines: Vec<(f64, Vec<[f64; 2]>)>,
}

impl MeasuredSeparation {
    /// Sorts the cells of each line by β0 over the steady gap; no line may be empty.
    pub(super) fn new(lines: impl Iterator<Item = (f64, Vec<[f64; 2]>)>) -> Self {
        let sorted = lines.map(|(half_angle_rad, mut cells)| {
            cells.sort_by(|a, b| a[0].total_cmp(&b[0]));
            (half_angle_rad, cells)
        });
        Self {
            lines: sorted.filter(|(_, cells)| !cells.is_empty()).collect(),
        }
    }

    /// Critical gap over the steady gap that a raceway of this θ and β0 over the steady gap is expected to have:
    /// linear between the cells of the nearest line.
    pub(super) fn expected(&self, half_angle_rad: f64, fraction: f64) -> f64 {
        let apart = |line: &&(f64, Vec<[f64; 2]>)| (line.0 - half_angle_rad).abs();
        let nearest = self.lines.iter();
        let nearest = nearest.min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let Some((_, cells)) = nearest else {
            return fraction;
        };
        let above = cells.partition_point(|cell| cell[0] < fraction);
        let kept = match (above.checked_sub(1).map(|k| cells[k]), cells.get(above)) {
            (Some([x0, y0]), Some([x1, y1])) => y0 + (y1 - y0) * (fraction - x0) / (x1 - x0),
            (Some(end), None) => end[1],
            (None, end) => end.map_or(1.0, |end| end[1]),
        };
        kept * fraction
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Linear between the cells of the nearest line, constant beyond them.
    #[test]
    fn what_maps_measure_is_interpolated() {
        let lines = [
            (0.3, vec![[1.0, 0.71], [0.5, 0.91]]),
            (0.4, vec![[0.75, 0.5]]),
            (0.31, vec![]),
        ];
        let measured = MeasuredSeparation::new(lines.into_iter());
        for (half_angle, fraction, kept) in [
            (0.3, 0.75, 0.81),
            (0.31, 1.0, 0.71),
            (0.2, 1.5, 0.71),
            (0.3, 0.25, 0.91),
            (0.4, 0.9, 0.5),
        ] {
            let found = measured.expected(half_angle, fraction);
            assert!(
                (found - kept * fraction).abs() < 1e-12,
                "{fraction}: {found}"
            );
        }
        // Without any cell as the closed form has it.
        let none = MeasuredSeparation::new(std::iter::empty());
        assert_eq!(none.expected(0.3, 0.9), 0.9);
    }
}
