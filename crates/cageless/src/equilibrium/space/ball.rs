//! The energy of one ball between the rings, and where it is least.
//!
//! A ball stays at its ψ; it moves along the radius and along the axis, by (u, ζ) from where it
//! touches the plain outer groove in its middle. With friction left out its energy is
//!
//!   U = ⅖ Ki δi^(5/2) + ⅖ Ko δe^(5/2) − S u − C ln(1 + u/T),
//!
//! S and C/ρ the steady and the centrifugal push outwards. In the frame of the inner ring, at **R**
//! with the axis **a**, the ball is at ζi = (**c** − **R**)·**a**, ρi = |**c** − **R** − ζi **a**|:
//! from there δi is that of a groove as well. U is convex in (u, ζ) up to the geometric part
//! of the inner contact.

use super::outer_section::OuterSection;
use crate::equilibrium::minimum::{Local, minimum};
use crate::numerics::taylor::Taylor;

/// One ball at its angle in a row.
#[derive(Debug, Clone)]
pub(super) struct SpatialBall {
    /// Number of the row.
    pub row: usize,
    pub angle_rad: f64,
    pub radius_m: f64,
    pub mass_kg: f64,
    /// T, distance from the axis at which it touches the plain outer groove.
    pub orbit_radius_m: f64,
    pub outer: OuterSection,
    /// z of the row.
    pub axial_m: f64,
    /// ri − R.
    pub inner_gap_m: f64,
    /// Pi, distance of the inner groove's centre from the ring's axis.
    pub inner_centre_m: f64,
    /// zi, of the inner groove's centre from the row.
    pub inner_axial_m: f64,
    pub inner_stiffness_n_m1_5: f64,
    pub outer_stiffness_n_m1_5: f64,
    /// S, N.
    pub steady_n: f64,
    /// C, N·m.
    pub turning_n_m: f64,
}

/// Coordinates of the ring: **R**, p, q.
pub(super) type Ring = [f64; 5];

/// One ball where its energy is least.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rest {
    /// u and ζ.
    pub place: [f64; 2],
    /// Energy over u, ζ and the coordinates of the ring.
    pub energy: Taylor<7>,
    pub magnitude: f64,
}

/// ⅖ K δ^(5/2).
fn elastic<const N: usize>(stiffness: f64, approach: Taylor<N>) -> Taylor<N> {
    let (depth, root) = (approach.value, approach.value.sqrt());
    let force = stiffness * depth * root;
    approach.map([0.4 * force * depth, force, 1.5 * stiffness * root])
}

impl SpatialBall {
    /// d from the inner groove's centre in the meridian plane of the ring through the ball.
    fn relative_to_inner_centre<const N: usize>(
        &self,
        [beyond, axial]: [Taylor<N>; 2],
        [x, y, z, p, q]: [Taylor<N>; 5],
    ) -> [Taylor<N>; 2] {
        let (sin, cos) = self.angle_rad.sin_cos();
        let distance = beyond + self.orbit_radius_m;
        let c = [
            distance * sin - x,
            distance * -cos - y,
            axial + self.axial_m - z,
        ];
        let square = p * p + q * q;
        let a = [p, q, (square * -1.0 + 1.0).sqrt()];
        let along = c[0] * a[0] + c[1] * a[1] + c[2] * a[2];
        let [w0, w1, w2] = std::array::from_fn(|k| c[k] - along * a[k]);
        let radial = (w0 * w0 + w1 * w1 + w2 * w2).sqrt();
        [
            radial + -self.inner_centre_m,
            along + -(self.axial_m + self.inner_axial_m),
        ]
    }

    /// δi; `None` where it is open.
    fn inner_approach<const N: usize>(
        &self,
        place: [Taylor<N>; 2],
        ring: [Taylor<N>; 5],
    ) -> Option<Taylor<N>> {
        let [radial, axial] = self.relative_to_inner_centre(place, ring);
        (radial.value.hypot(axial.value) > self.inner_gap_m)
            .then(|| radial.hypot(axial) + -self.inner_gap_m)
    }

    /// U and the sum of its absolute terms.
    fn energy<const N: usize>(
        &self,
        place: [Taylor<N>; 2],
        ring: [Taylor<N>; 5],
    ) -> (Taylor<N>, f64) {
        let flank = self.outer.flanks.map_or(0.0, |f| f.angle_rad);
        let mut terms = vec![
            place[0] * -self.steady_n,
            (place[0] * (1.0 / self.orbit_radius_m)).ln_1p() * -self.turning_n_m,
        ];
        let outer = self.outer.approach(place, Taylor::constant(flank));
        terms.extend(outer.map(|d| elastic(self.outer_stiffness_n_m1_5, d)));
        let inner = self.inner_approach(place, ring);
        terms.extend(inner.map(|d| elastic(self.inner_stiffness_n_m1_5, d)));
        let magnitude = terms.iter().map(|t| t.value.abs()).sum();
        let sum = terms.into_iter().reduce(|a, b| a + b);
        (sum.unwrap_or(Taylor::constant(0.0)), magnitude)
    }

    /// Force and contact angle at the inner raceway; the angle is positive where the ball presses
    /// the ring towards −Z. `None` where it is open.
    pub fn inner_contact(&self, place: [f64; 2], ring: Ring) -> Option<(f64, f64)> {
        let (place, ring) = (place.map(Taylor::<0>::constant), ring.map(Taylor::constant));
        let depth = self.inner_approach(place, ring)?.value;
        let [radial, axial] = self.relative_to_inner_centre(place, ring);
        let force = self.inner_stiffness_n_m1_5 * depth * depth.sqrt();
        Some((force, (-axial.value).atan2(-radial.value)))
    }

    /// Force K δe^(3/2) at the outer raceway.
    pub fn outer_force_n(&self, place: [f64; 2]) -> f64 {
        let flank = self.outer.flanks.map_or(0.0, |f| f.angle_rad);
        let place = place.map(Taylor::<0>::constant);
        let depth = self.outer.approach(place, Taylor::constant(flank));
        depth.map_or(0.0, |d| {
            self.outer_stiffness_n_m1_5 * d.value * d.value.sqrt()
        })
    }

    /// (u, ζ) to start from: on the line through the centres of the plain grooves, or where its push
    /// seats a ball that only one of them holds.
    fn guess(&self, ring: Ring) -> [f64; 2] {
        let softness = |k: f64| k.powf(-2.0 / 3.0);
        let (inner, outer) = (
            softness(self.inner_stiffness_n_m1_5),
            softness(self.outer_stiffness_n_m1_5),
        );
        let start = [0.0, self.outer.axial_m].map(Taylor::<0>::constant);
        let [radial, axial] = self.relative_to_inner_centre(start, ring.map(Taylor::constant));
        // From the outer centre to the inner one.
        let (radial, axial) = (self.outer.gap_m - radial.value, -axial.value);
        let length = radial.hypot(axial);
        let squeeze = length - self.outer.gap_m - self.inner_gap_m;
        let push = self.steady_n + self.turning_n_m / self.orbit_radius_m;
        if squeeze > 0.0 {
            let reach = (self.outer.gap_m + squeeze * outer / (inner + outer)) / length;
            [
                reach * radial - self.outer.gap_m,
                self.outer.axial_m + reach * axial,
            ]
        } else if push >= 0.0 {
            [push.powf(2.0 / 3.0) * outer, self.outer.axial_m]
        } else {
            let sunk = self.inner_gap_m + (-push).powf(2.0 / 3.0) * inner;
            [radial - self.outer.gap_m - sunk, self.outer.axial_m + axial]
        }
    }

    /// Where the energy is least for a place of the ring.
    pub fn rest(&self, ring: Ring) -> Rest {
        let held = ring.map(Taylor::constant);
        let at = |place: [f64; 2]| {
            let (energy, magnitude) = self.energy(Taylor::variables(place), held);
            Local {
                place,
                energy: energy.value,
                magnitude,
                gradient: energy.gradient,
                hessian: energy.hessian,
            }
        };
        let longest = 0.5 * self.outer.gap_m.min(self.inner_gap_m);
        let place = minimum(at, self.guess(ring), longest).place;
        let [x, y, z, p, q] = ring;
        let all = Taylor::variables([place[0], place[1], x, y, z, p, q]);
        let (energy, magnitude) =
            self.energy([all[0], all[1]], std::array::from_fn(|k| all[k + 2]));
        Rest {
            place,
            energy,
            magnitude,
        }
    }
}
