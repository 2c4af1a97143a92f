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
