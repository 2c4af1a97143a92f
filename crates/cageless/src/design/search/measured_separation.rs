//! Critical gaps of the maps against closed forms: what sliding takes from them, before candidates are laid.

use super::grid::SpeedMap;
use super::raceway_layout::ClosedForms;

/// Critical gaps of the maps at the operating points over β0 of closed forms, line by line of constant θ.
pub(super) struct MeasuredSeparation {
    /// θ, with β0 over the steady gap and the critical gap over β0 of its cells, from the shallowest on.
    lines: Vec<(f64, Vec<[f64; 2]>)>,
}

impl MeasuredSeparation {
    /// Of maps of the same cells; a cell has the mean over the maps.
    pub fn new(maps: &[SpeedMap]) -> Self {
        let Some(first) = maps.first() else {
            return Self { lines: vec![] };
        };
        let columns = first.axial_span_m.len();
        let of_cell = |k: usize| {
            let forms: ClosedForms = first.cells[k].forms?;
            let gaps: Option<Vec<f64>> = maps
                .iter()
                .map(|map| Some(map.cells[k].spacing?.critical_gap_rad))
                .collect();
            let gap = gaps?.iter().sum::<f64>() / maps.len() as f64;
            let kept = gap / forms.theoretical_gap_rad;
            (forms.theoretical_gap_rad > 0.0).then_some([forms.fraction(), kept])
        };
        let rows = first.half_angle_rad.iter().enumerate();
        let lines = rows.map(|(row, &half_angle_rad)| {
            let mut cells: Vec<[f64; 2]> = (row * columns..(row + 1) * columns)
                .filter_map(of_cell)
                .collect();
            cells.sort_by(|a, b| a[0].total_cmp(&b[0]));
            (half_angle_rad, cells)
        });
        Self {
            lines: lines.filter(|(_, cells)| !cells.is_empty()).collect(),
        }
    }

    /// Critical gap over the steady gap that a raceway of this θ and β0 over the steady gap is expected to have:
    /// linear between the cells of the nearest line.
    pub fn expected(&self, half_angle_rad: f64, fraction: f64) -> f64 {
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
    use crate::common::structure;
    use crate::design::search::grid::MapCell;
    use crate::design::search::{OperatingPoint, PairSeparation, RacewayLayout};

    /// Linear between the cells of the nearest line, constant beyond them; the mean over several maps.
    #[test]
    fn what_maps_measure_is_interpolated() {
        let case = structure(5.1, 25.2);
        let layout = RacewayLayout::from_case(&case).unwrap();
        let cell = |theoretical_gap_rad: f64, kept: f64| MapCell {
            structure: layout.clone(),
            forms: Some(ClosedForms {
                theoretical_gap_rad,
                steady_gap_rad: 0.04,
            }),
            spacing: Some(PairSeparation {
                critical_gap_rad: kept * theoretical_gap_rad,
                shortfall: 1.0 - kept,
                stress_pa: 1e9,
            }),
            cause: None,
        };
        let map = |more: f64| SpeedMap {
            point: OperatingPoint::from_case(&case),
            axial_span_m: vec![4e-3, 5e-3],
            half_angle_rad: vec![0.3, 0.4],
            cells: vec![
                cell(0.02, 0.9 + more),
                cell(0.04, 0.7 + more),
                cell(0.03, 0.5),
                MapCell {
                    spacing: None,
                    ..cell(0.05, 0.0)
                },
            ],
        };
        let measured = MeasuredSeparation::new(&[map(0.0), map(0.02)]);
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
        assert_eq!(MeasuredSeparation::new(&[]).expected(0.3, 0.9), 0.9);
    }
}
