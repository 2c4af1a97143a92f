//! STL: the ring as triangles, binary, millimetres in single precision.

use cageless::InputError;
use cageless::numerics::{cross, dot};
use cageless::surface::{Mesh, OuterRing};

use super::numbers::{Counts, RingFile};

/// The ring meshed with a chord error of at most `chord_um`, rounding to single precision included. The
/// same ring gives the same bytes.
///
/// # Errors
/// `chord_um` is out of the range of [`Mesh::new`].
pub(super) fn write(ring: &OuterRing, chord_um: f64) -> Result<RingFile, InputError> {
    // Half a unit in the last place of the largest coordinate, each way.
    let largest_mm = ring.dimensions.outer_ring_outer_radius_m * 1e3;
    let rounding_m = 3f64.sqrt() * largest_mm * f64::from(f32::EPSILON) / 2.0 * 1e-3;
    let mesh = Mesh::new(ring, chord_um * 1e-6, rounding_m)?;
    let vertices: Vec<[f32; 3]> = (mesh.vertices_m.iter())
        .map(|v| v.map(|c| (c * 1e3) as f32))
        .collect();
    // A header of 80 bytes, the number of triangles; of each its normal and corners, and two bytes.
    let mut bytes = vec![0; 80];
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    for triangle in &mesh.triangles {
        let corners = triangle.map(|k| vertices[k as usize]);
        for vector in [normal(corners), corners[0], corners[1], corners[2]] {
            bytes.extend(vector.iter().flat_map(|c| c.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    Ok(RingFile {
        bytes,
        deviation_m: mesh.deviation_m,
        counts: Counts::Stl {
            chord_um,
            triangles: mesh.triangles.len(),
            vertices: vertices.len(),
            mesh_volume_mm3: mesh.volume_m3() * 1e9,
        },
    })
}

/// Unit normal of a triangle.
fn normal(corners: [[f32; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = corners.map(|p| p.map(f64::from));
    let (u, v) = (
        [b[0] - a[0], b[1] - a[1], b[2] - a[2]],
        [c[0] - a[0], c[1] - a[1], c[2] - a[2]],
    );
    let n = cross(u, v);
    let length = dot(n, n).sqrt();
    n.map(|x| (x / length) as f32)
}
