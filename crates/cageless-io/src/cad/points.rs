//! Points of the groove for a five-axis program: a table of positions and outward normals,
//! with the track of the contact points.
//!
//! | column | |
//! |---|---|
//! | `kind` | `contact`: where a ball touches, at η = αg ± α; `surface`: the groove; `edge`, `wall` and `floor` of a slot |
//! | `side` | 1 from the ridge or the middle of a slot towards +z, −1 towards −z; both sides have their own row there |
//! | `psi_deg` | ψ from −180 to 180, ascending but around the ends of a slot, where points of one row have their own |
//! | `eta_deg` | η, meridian angle at the centre of the groove's arc, from the outward radius towards +z; of a slot −η is the direction of the normal from the inward radius |
//! | `x_mm`, `y_mm`, `z_mm` | position, frame of the bearing |
//! | `nx`, `ny`, `nz` | unit normal, out of the ring's material |

use std::io::{self, Write};

use cageless::surface::{Grid, GridPoint, GridRow, OuterRing, Side, SurfacePoint};

use super::numbers::Counts;

/// Head of the table.
const COLUMNS: &str = "kind,side,psi_deg,eta_deg,x_mm,y_mm,z_mm,nx,ny,nz";

/// Writes points of the groove no further apart than `spacing_mm`, along its bottom and
/// along its arcs: CSV, LF, ASCII, line by line as they are computed. The largest distance of a point
/// as written from the surface, m, and the contents.
///
/// # Errors
/// Those of `out`.
pub(super) fn write(
    ring: &OuterRing,
    spacing_mm: f64,
    out: &mut dyn Write,
) -> io::Result<(f64, Counts)> {
    let grid = Grid::new(ring, spacing_mm * 1e-3);
    writeln!(out, "{COLUMNS}")?;
    let mut table = Table {
        ring,
        out,
        deviation_m: 0.0,
        rows: 0,
    };
    for side in [Side::Lower, Side::Upper] {
        for row in &grid.rows {
            table.row(row, &row.contact(side))?;
        }
    }
    let contact_points = table.rows;
    for row in &grid.rows {
        for point in grid.points(row) {
            table.row(row, &point)?;
        }
    }
    let counts = Counts::Csv {
        spacing_mm,
        row_distance_mm: grid.row_distance_m(ring) * 1e3,
        surface_points: table.rows - contact_points,
        contact_points,
    };
    Ok((table.deviation_m, counts))
}

/// Distance along the normal of a place from a point of the surface, m.
fn off_m(point: &SurfacePoint, place_m: [f64; 3]) -> f64 {
    let along = |k: usize| (place_m[k] - point.position_m[k]) * point.normal[k];
    along(0) + along(1) + along(2)
}

struct Table<'a> {
    ring: &'a OuterRing,
    out: &'a mut dyn Write,
    deviation_m: f64,
    rows: usize,
}

impl Table<'_> {
    fn row(&mut self, row: &GridRow, of: &GridPoint) -> io::Result<()> {
        let point = of.point;
        // Picometres; the last digit of an f64 is 4e-15 mm here.
        let position = point.position_m.map(|c| format!("{:.9}", c * 1e3));
        let read = [0, 1, 2].map(|k| position[k].parse::<f64>().unwrap_or(f64::NAN) * 1e-3);
        let off_m = match row.passes_slot() {
            true => off_m(&point, read),
            false => self.ring.distance_m(read),
        };
        self.deviation_m = self.deviation_m.max(off_m.abs());
        let [x, y, z] = position;
        let [nx, ny, nz] = point.normal;
        writeln!(
            self.out,
            "{},{},{:.9},{:.9},{x},{y},{z},{nx:.12},{ny:.12},{nz:.12}",
            of.kind_name(),
            of.side.sign(),
            of.angle_rad.to_degrees(),
            of.meridian_rad.to_degrees(),
        )?;
        self.rows += 1;
        Ok(())
    }
}
