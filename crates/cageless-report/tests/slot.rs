//! The drawing of a slot against the ring that is exported.

use cageless::surface::{Grid, OuterRing, OuterRingDimensions};
use cageless_io::case_file::{CaseFile, template};
use cageless_report::{RacewayLabel, RacewaySurface};

/// Distance of neighbouring points of the ring, mm.
const SPACING_MM: f64 = 0.04;

/// Largest distance of a point of one line from the nearest of the other.
fn off_mm(line: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    let distance = |a: &[f64; 3], b: &[f64; 3]| (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
    let nearest = line.iter().map(|a| {
        other
            .iter()
            .map(|b| distance(a, b))
            .fold(f64::INFINITY, f64::min)
    });
    nearest.fold(0.0, f64::max)
}

/// The drawn lines are where the rounded edges of the ring leave the groove and where its walls begin, all round the
/// slot, and the surface has a hole with the ring's floor.
#[test]
fn the_drawn_edges_are_those_of_the_ring() {
    let sets = [
        "raceway.shape=slot",
        "raceway.edge_radius_mm=0.3",
        "raceway.axial_span_mm=3.2",
    ];
    let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
    let file = CaseFile::parse(&template(false), "case", &sets).unwrap();
    let case = file.case();
    let size = OuterRingDimensions {
        outer_ring_outer_radius_m: 31e-3,
        outer_ring_width_m: 16e-3,
        blend_m: 0.0,
    };
    let ring = OuterRing::of(case, size).unwrap();
    let drawn = RacewaySurface::sample(&case.raceways[0], &case.bearing, RacewayLabel::default());

    let grid = Grid::new(&ring, SPACING_MM * 1e-3);
    let mut lines = [vec![], vec![]];
    for row in grid.rows.iter().filter(|row| row.passes_slot()) {
        let points = grid.points(row);
        for half in points.split(|point| point.kind_name() != "edge") {
            if let ([first, .., last], up) = (half, half.first().map(|p| p.side.sign())) {
                let ends = if up == Some(-1.0) {
                    [first, last]
                } else {
                    [last, first]
                };
                for (line, end) in lines.iter_mut().zip(ends) {
                    line.push(end.point.position_m.map(|v| v * 1e3));
                }
            }
        }
    }
    assert_eq!(drawn.edges_mm.len(), 2);
    for (line, of_ring) in drawn.edges_mm.iter().zip(&lines) {
        // Drawn points are up to 0.25 mm apart along the slot.
        assert!(
            off_mm(line, of_ring) < SPACING_MM,
            "{}",
            off_mm(line, of_ring)
        );
        assert!(off_mm(of_ring, line) < 0.2, "{}", off_mm(of_ring, line));
        assert!(off_mm(&line[..1], &line[line.len() - 1..]) < 1e-6);
    }
    let recess = &ring.recesses[0];
    let [width, depth, radius] = drawn.slot_mm.unwrap();
    let same = [
        (width, recess.width_m),
        (depth, recess.depth_m),
        (radius, recess.edge_radius_m),
    ];
    assert!(
        same.iter().all(|(mm, m)| (mm - m * 1e3).abs() < 1e-12),
        "{same:?}"
    );
    let bottom = case.bearing.dimensions().outer_groove_bottom_radius_m * 1e3;
    let points = drawn.x_mm.iter().flatten().zip(drawn.y_mm.iter().flatten());
    let deepest = points.map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    assert!((deepest - bottom - depth).abs() < 1e-9, "{deepest}");
    // Nothing is drawn across the slot: the deepest rows and the plain ones are apart.
    assert_eq!(
        drawn.x_mm.iter().filter(|row| row[0].is_nan()).count() % 2,
        0
    );
    assert!(drawn.x_mm.iter().any(|row| row[0].is_nan()));
}
