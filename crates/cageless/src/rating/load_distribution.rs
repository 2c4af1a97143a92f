//! Load distribution of ISO/TS 16281: rigid rings under the radial load alone.

use crate::case::{Case, series_stiffness_n_m1_5};
use crate::contact::hertz::elastic_energy;
use crate::equilibrium::start_angles_rad;
use crate::numerics::minimum::{Local, minimum, norm};
use crate::numerics::taylor::Taylor;
use crate::numerics::vector::PlaneVector;

/// Force left on the ring over the load.
const FORCE_TOLERANCE: f64 = 1e-6;

/// A ball between the rings as one spring: its direction, the deflection it has with the ring in
/// the middle, its K.
struct Spring {
    e: PlaneVector,
    middle_m: f64,
    stiffness_n_m1_5: f64,
}

/// Force of every ball, N, at both raceways alike. With the ring displaced by **X** ball j takes
///
///   Qj = cp δj^(3/2), δj = **X**·**e**j − Gr/2 + 2(R − Rw), cp = (Ki^(−2/3) + Ko^(−2/3))^(−3/2),
///
/// and Σ Qj **e**j balances the radial load, without weight and centrifugal force. The balls
/// stand where the case starts them, the outer raceway is plain. Displacements are small against
/// the bearing, unlike in [`crate::equilibrium`]. `None` without load, or if the balls leave
/// a gap through which the ring falls.
pub(crate) fn rigid_ring_forces_n(case: &Case) -> Option<Vec<f64>> {
    let bearing = &case.bearing;
    let load_n = case.operation.radial_load_n;
    let springs: Vec<Spring> = start_angles_rad(case)
        .into_iter()
        .enumerate()
        .map(|(k, angle)| {
            let (sin, cos) = angle.sin_cos();
            let [inner, outer, _] = case.ball_stiffness_n_m1_5(k);
            let larger = bearing.ball(k).radius_m - bearing.ball_radius_m();
            Spring {
                e: PlaneVector { x: sin, y: -cos },
                middle_m: 2.0 * larger - 0.5 * bearing.radial_internal_clearance_m(),
                stiffness_n_m1_5: series_stiffness_n_m1_5(inner, outer),
            }
        })
        .collect();
    let at = |ring: [f64; 2]| {
        let [x, y] = Taylor::variables(ring);
        let place = PlaneVector { x, y };
        let springs = springs.iter().filter_map(|spring| spring.energy(place));
        Local::sum(ring, springs.chain([place.y * load_n]))
    };
    let longest = 0.05 * bearing.ball_radius_m();
    let found = minimum(at, [0.0, -longest], longest);
    let settles = load_n > 0.0 && norm(found.gradient) <= FORCE_TOLERANCE * load_n;
    let [x, y] = found.place.map(Taylor::<0>::constant);
    let place = PlaneVector { x, y };
    settles.then(|| springs.iter().map(|spring| spring.force_n(place)).collect())
}

impl Spring {
    fn deflection_m<const N: usize>(&self, ring: PlaneVector<Taylor<N>>) -> Taylor<N> {
        ring.x * self.e.x + ring.y * self.e.y + self.middle_m
    }

    fn force_n(&self, ring: PlaneVector<Taylor<0>>) -> f64 {
        self.stiffness_n_m1_5 * self.deflection_m(ring).value.max(0.0).powf(1.5)
    }

    fn energy(&self, ring: PlaneVector<Taylor<2>>) -> Option<Taylor<2>> {
        let depth = self.deflection_m(ring);
        (depth.value > 0.0).then(|| elastic_energy(self.stiffness_n_m1_5, depth))
    }
}
