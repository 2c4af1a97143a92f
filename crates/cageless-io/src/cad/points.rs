//! Points of the groove for a five-axis program: a table of positions and outward normals,
//! with the track of the contact points.
//!
//! | column | |
//! |---|---|
//! | `kind` | `contact`: where a ball touches, at η = αg ± α; `surface`: the groove |
//! | `side` | 1 from the ridge towards +z, −1 towards −z; both sides have their own row at the ridge |
//! | `psi_deg` | ψ from −180 to 180, ascending |
//! | `eta_deg` | η, meridian angle at the centre of the arc, from the outward radius towards +z |
//! | `x_mm`, `y_mm`, `z_mm` | position, frame of the bearing |
//! | `nx`, `ny`, `nz` | unit normal, out of the ring's material |

use std::io::{self, Write};

use cageless::surface::{Grid, Meridian, OuterRing, Side};

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
        for m in &grid.meridians {
            table.row("contact", m, side, m.arc(side).contact_angle_rad)?;
        }
    }
    let contact_points = table.rows;
    for m in &grid.meridians {
        for (k, eta) in grid.row_rad(m).into_iter().enumerate() {
            let side = if k <= grid.steps {
                Side::Lower
            } else {
                Side::Upper
            };
            table.row("surface", m, side, side.sign() * eta)?;
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

struct Table<'a> {
    ring: &'a OuterRing,
    out: &'a mut dyn Write,
    deviation_m: f64,
    rows: usize,
}

impl Table<'_> {
    /// η counts towards the shoulder of the side.
    fn row(&mut self, kind: &str, meridian: &Meridian, side: Side, eta: f64) -> io::Result<()> {
        let point = meridian.arc(side).point(meridian.angle_rad, eta);
        // Picometres; the last digit of an f64 is 4e-15 mm here.
        let position = point.position_m.map(|c| format!("{:.9}", c * 1e3));
        let read = |k: usize| position[k].parse::<f64>().unwrap_or(f64::NAN) * 1e-3;
        let off = self.ring.distance_m([read(0), read(1), read(2)]).abs();
        self.deviation_m = self.deviation_m.max(off);
        let [x, y, z] = position;
        let [nx, ny, nz] = point.normal;
        let side = side.sign();
        writeln!(
            self.out,
            "{kind},{side},{:.9},{:.9},{x},{y},{z},{nx:.12},{ny:.12},{nz:.12}",
            meridian.angle_rad.to_degrees(),
            side * eta.to_degrees(),
        )?;
        self.rows += 1;
        Ok(())
    }
}
