//! Raceways that are accepted, as rings.

use super::outer_ring::{bearing, edges_are_shared_by_two, ring};
use super::slot_ring::slot;
use crate::common::OUTER_RING;
use cageless::surface::{Mesh, OuterRing, OuterRingDimensions, Patch};
use cageless::{Raceway, RacewayDimensions};
use proptest::prelude::*;

/// A ring with this raceway: the contact angle falls steadily to 0, contacts are on the groove, the
/// B-spline reaches its tolerance and the mesh closes.
fn check_ring(raceway: Raceway, blend_m: f64) {
    let d = *raceway.dimensions();
    let ring = ring(&[raceway], blend_m);
    let mut last = f64::INFINITY;
    for k in 0..=200 {
        let local = d.half_angle_rad * f64::from(k) / 200.0;
        let m = ring.meridian(d.centre_angle_rad + local);
        let angle = m.flank_angle_rad;
        assert!(angle >= 0.0 && angle <= last + 1e-12, "{local}: {angle}");
        let [arc, _] = m.arcs;
        assert!(arc.valley_rad() <= angle + 1e-12 && angle < arc.shoulder_rad());
        last = angle;
    }
    for sector in ring.sectors() {
        let pair = Patch::pair(&ring, &sector, 1e-8);
        assert!(pair.is_ok(), "{sector:?} {:?}", pair.err());
    }
    let mesh = Mesh::new(&ring, 20e-6, 0.0).unwrap();
    let off = (mesh.volume_m3() - ring.volume_m3()).abs();
    assert!(off < 9000e-6 * 20e-6, "{off}");
}

/// From 40.98393° on the path of 3.765 mm comes to the plain raceway from outside, within its last
/// thousandth at first.
#[test]
fn a_path_that_ends_from_outside_is_refused() {
    let raceway = |angle_deg: f64| {
        let dimensions = RacewayDimensions {
            axial_span_m: 3.764_986_464_759_771e-3,
            half_angle_rad: angle_deg.to_radians(),
            centre_angle_rad: 0.0,
        };
        Raceway::new(dimensions, &bearing())
    };
    for accepted in [40.9, 40.98, 40.983_934] {
        check_ring(raceway(accepted).unwrap(), 0.0);
    }
    for refused in [40.983_935, 40.984, 40.997_187_883_621_73, 41.0] {
        let message = raceway(refused).unwrap_err().to_string();
        assert!(
            message.contains("turns back or leaves the groove"),
            "{message}"
        );
    }
}

proptest! {
    #![proptest_config(super::trials(64))]

    #[test]
    fn every_accepted_raceway_becomes_a_ring(
        span in 0.05f64..7.4,
        angle in 0.5f64..60.0,
        centre in -180.0f64..180.0,
        fraction in 0.0021f64..0.499,
        blended: bool,
    ) {
        let dimensions = RacewayDimensions {
            axial_span_m: span * 1e-3,
            half_angle_rad: angle.to_radians(),
            centre_angle_rad: centre.to_radians(),
        };
        let Ok(raceway) = Raceway::new(dimensions, &bearing()) else {
            return Ok(());
        };
        let blend_m = if blended { fraction * angle.to_radians() * 27.765e-3 } else { 0.0 };
        check_ring(raceway, blend_m);
    }

    /// B-splines and meshes of every slot reach their tolerances.
    #[test]
    fn every_accepted_slot_becomes_a_ring(
        span in 0.05f64..7.4,
        edge in 0.01f64..3.0,
        angle in 0.5f64..80.0,
        centre in -180.0f64..180.0,
        section in -20.0f64..20.0,
        turned: bool,
    ) {
        let section = if turned { section.to_radians() } else { 0.0 };
        // Room for every floor.
        let size = OuterRingDimensions { outer_ring_outer_radius_m: 45e-3, ..OUTER_RING };
        let made = slot(&bearing(), [span, edge, angle, centre])
            .and_then(|slot| slot.with_section_angle(section, &bearing()))
            .and_then(|slot| OuterRing::new(&bearing(), &[slot], size));
        let Ok(ring) = made else {
            return Ok(());
        };
        let recess = &ring.recesses[0];
        for end in [-1.0, 1.0] {
            let patches = recess.end_patches(end, 1e-8);
            prop_assert!(patches.is_ok(), "{patches:?}");
        }
        let mesh = Mesh::new(&ring, 20e-6, 0.0).unwrap();
        edges_are_shared_by_two(&mesh);
        let off = (mesh.volume_m3() - ring.volume_m3()).abs();
        prop_assert!(off < 16_000e-6 * 20e-6, "{off:e}");
    }
}
