//! Placements of the raceways in a search.

use std::f64::consts::TAU;

/// Steps between the places of one raceway.
const STEP_DEG: f64 = 15.0;
/// Distances between the middles of neighbouring raceways that are tried.
const APART_DEG: [f64; 6] = [45.0, 60.0, 75.0, 90.0, 120.0, 180.0];

/// Places of up to `raceways_max` raceways: one, at every 15° of the range of ψ and at its ends,
/// that nearest to the bottom first; then two and more, the distances between neighbours 45° to 180°, all
/// together about the first place. Those that overlap are rejected later, by their width.
pub fn placements(centre_range_rad: [f64; 2], raceways_max: usize) -> Vec<Vec<f64>> {
    let [low, high] = centre_range_rad;
    let step = STEP_DEG.to_radians();
    let count = ((high - low) / step + 1e-9).floor() as usize;
    let mut centres: Vec<f64> = (0..=count).map(|k| low + step * k as f64).collect();
    if high - centres[count] > 0.1 * step {
        centres.push(high);
    }
    // Rounding at the bottom would look odd in every file.
    for centre in &mut centres {
        *centre = (centre.to_degrees() * 1e6).round() / 1e6;
        *centre = (*centre + 0.0).to_radians();
    }
    centres.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    let about = centres[0];
    let mut placements: Vec<Vec<f64>> = centres.into_iter().map(|c| vec![c]).collect();
    for raceways in 2..=raceways_max {
        for apart in APART_DEG.map(f64::to_radians) {
            if raceways as f64 * apart > TAU + 1e-9 {
                continue;
            }
            let first = -0.5 * (raceways - 1) as f64 * apart;
            placements.push(
                (0..raceways)
                    .map(|k| about + first + apart * k as f64)
                    .collect(),
            );
        }
    }
    placements
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_raceway_from_the_bottom_outwards_then_pairs() {
        assert_eq!(placements([0.0, 0.0], 1), [[0.0]]);
        let right = std::f64::consts::FRAC_PI_2;
        let found = placements([-right, right], 2);
        let single = found.iter().filter(|p| p.len() == 1).count();
        assert_eq!((single, found.len()), (13, 13 + 6));
        assert_eq!(found[0], [0.0]);
        for pair in &found[13..] {
            assert!((pair[0] + pair[1]).abs() < 1e-12, "{pair:?}");
        }
        let degrees: Vec<f64> = placements([170f64.to_radians(), 180f64.to_radians()], 1)
            .iter()
            .map(|p| p[0].to_degrees().round())
            .collect();
        assert_eq!(degrees, [170.0, 180.0]);
        let three = placements([0.0, 0.0], 3);
        assert!(three.iter().all(|p| p.len() < 3 || p[1].abs() < 1e-12));
        assert!(three.iter().any(|p| p.len() == 3));
    }
}
