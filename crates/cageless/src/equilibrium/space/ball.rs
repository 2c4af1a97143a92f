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
//! of the inner contact. In the plane ζ stays 0, and so do Z and the tilt of the ring.

use super::outer_section::OuterSection;
use crate::contact::hertz::elastic_energy;
use crate::numerics::cholesky::solve;
use crate::numerics::minimum::{Local, minimum};
use crate::numerics::taylor::Taylor;
use crate::numerics::vector::SectionVector;

/// One ball at its angle in a row.
#[derive(Debug, Clone)]
pub(in crate::equilibrium) struct SpatialBall {
    /// Whether it moves along the radius alone.
    pub planar: bool,
    /// Number of the row.
    pub row: usize,
    /// Number of the ball in the row.
    pub number: usize,
    pub angle_rad: f64,
    /// sin ψ and cos ψ.
    pub sin_cos: (f64, f64),
    pub radius_m: f64,
    pub mass_kg: f64,
    /// T, distance from the axis at which it touches the plain outer groove, in the plane rigid flanks.
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
pub(in crate::equilibrium) type Ring = [f64; 5];

/// One ball where its energy is least.
#[derive(Debug, Clone, Copy)]
pub(in crate::equilibrium) struct Rest {
    /// u and ζ.
    pub place: SectionVector,
    /// Energy over the coordinates of the ring, which the ball follows: the Hessian is
    /// Uxx − Uxu Uuu⁻¹ Uux.
    pub local: Local<5>,
}

/// u, ζ and the coordinates of the ring, of which `free` vary.
fn coordinates<const N: usize>(values: [f64; 7], free: [usize; N]) -> [Taylor<N>; 7] {
    let mut all = values.map(Taylor::constant);
    for (k, variable) in free
        .into_iter()
        .zip(Taylor::variables(free.map(|k| values[k])))
    {
        all[k] = variable;
    }
    all
}

impl SpatialBall {
    /// ρ.
    pub(crate) fn distance_m(&self, place: SectionVector) -> f64 {
        self.orbit_radius_m + place.radial
    }

    /// d from the inner groove's centre in the meridian plane of the ring through the ball.
    fn relative_to_inner_centre<const N: usize>(
        &self,
        place: SectionVector<Taylor<N>>,
        [x, y, z, p, q]: [Taylor<N>; 5],
    ) -> SectionVector<Taylor<N>> {
        let (sin, cos) = self.sin_cos;
        let distance = place.radial + self.orbit_radius_m;
        let c = [
            distance * sin - x,
            distance * -cos - y,
            place.axial + self.axial_m - z,
        ];
        let square = p * p + q * q;
        let a = [p, q, (square * -1.0 + 1.0).sqrt()];
        let along = c[0] * a[0] + c[1] * a[1] + c[2] * a[2];
        // |**c** − along **a**|² − Pi², without the cancellation of a difference of lengths.
        let centre = self.inner_centre_m;
        let more = (place.radial + (self.orbit_radius_m - centre)) * (distance + centre)
            - distance * (x * sin - y * cos) * 2.0
            + (x * x + y * y + (c[2] - along) * (c[2] + along));
        SectionVector {
            radial: more * ((more + centre * centre).sqrt() + centre).recip(),
            axial: along + -(self.axial_m + self.inner_axial_m),
        }
    }

    /// δi; `None` where it is open.
    fn inner_approach<const N: usize>(
        &self,
        place: SectionVector<Taylor<N>>,
        ring: [Taylor<N>; 5],
    ) -> Option<Taylor<N>> {
        let SectionVector { radial, axial } = self.relative_to_inner_centre(place, ring);
        let depth = radial.hypot(axial) + -self.inner_gap_m;
        // Only the inner half of the circle is groove.
        (radial.value < 0.0 && depth.value > 0.0).then_some(depth)
    }

    /// U over those of u, ζ and the coordinates of the ring that vary.
    fn energy<const N: usize>(&self, values: [f64; 7], free: [usize; N]) -> Local<N> {
        let [beyond, axial, ring @ ..] = coordinates(values, free);
        let place = SectionVector {
            radial: beyond,
            axial,
        };
        let flank = self.outer.flanks.map_or(0.0, |f| f.angle_rad);
        let outer = self.outer.approach(place, Taylor::constant(flank));
        let inner = self.inner_approach(place, ring);
        let terms = [
            Some(beyond * -self.steady_n),
            Some((beyond * (1.0 / self.orbit_radius_m)).ln_1p() * -self.turning_n_m),
            outer.map(|d| elastic_energy(self.outer_stiffness_n_m1_5, d)),
            inner.map(|d| elastic_energy(self.inner_stiffness_n_m1_5, d)),
        ];
        Local::sum(free.map(|k| values[k]), terms.into_iter().flatten())
    }

    /// Force and contact angle at the inner raceway; the angle is positive where the ball presses
    /// the ring towards −Z. `None` where it is open.
    pub(crate) fn inner_contact(&self, place: SectionVector, ring: Ring) -> Option<(f64, f64)> {
        let (place, ring) = (place.map(Taylor::<0>::constant), ring.map(Taylor::constant));
        let depth = self.inner_approach(place, ring)?.value;
        let SectionVector { radial, axial } = self.relative_to_inner_centre(place, ring);
        let force = self.inner_stiffness_n_m1_5 * depth * depth.sqrt();
        Some((force, (-axial.value).atan2(-radial.value)))
    }

    /// δi, below 0 the gap where the inner raceway is open.
    pub(crate) fn inner_depth_m(&self, place: SectionVector, ring: Ring) -> f64 {
        let (place, ring) = (place.map(Taylor::<0>::constant), ring.map(Taylor::constant));
        let SectionVector { radial, axial } = self.relative_to_inner_centre(place, ring);
        radial.hypot(axial).value - self.inner_gap_m
    }

    /// Force K δe^(3/2) at the outer raceway.
    pub(crate) fn outer_force_n(&self, place: SectionVector) -> f64 {
        let flank = self.outer.flanks.map_or(0.0, |f| f.angle_rad);
        let place = place.map(Taylor::<0>::constant);
        let depth = self.outer.approach(place, Taylor::constant(flank));
        depth.map_or(0.0, |d| {
            self.outer_stiffness_n_m1_5 * d.value * d.value.sqrt()
        })
    }

    /// (u, ζ) to start from: on the line through the centres of the plain grooves, or where its push
    /// seats a ball that only one of them holds.
    fn guess(&self, ring: Ring) -> SectionVector {
        let softness = |k: f64| k.powf(-2.0 / 3.0);
        let (inner, outer) = (
            softness(self.inner_stiffness_n_m1_5),
            softness(self.outer_stiffness_n_m1_5),
        );
        let middle = SectionVector {
            radial: 0.0,
            axial: self.outer.axial_m,
        };
        let start = middle.map(Taylor::<0>::constant);
        let d = self.relative_to_inner_centre(start, ring.map(Taylor::constant));
        // From the outer centre to the inner one.
        let (radial, axial) = (self.outer.gap_m - d.radial.value, -d.axial.value);
        let length = radial.hypot(axial);
        let squeeze = length - self.outer.gap_m - self.inner_gap_m;
        let push = self.steady_n + self.turning_n_m / self.orbit_radius_m;
        if squeeze > 0.0 {
            let reach = (self.outer.gap_m + squeeze * outer / (inner + outer)) / length;
            SectionVector {
                radial: reach * radial - self.outer.gap_m,
                axial: self.outer.axial_m + reach * axial,
            }
        } else if push >= 0.0 {
            SectionVector {
                radial: push.powf(2.0 / 3.0) * outer,
                ..middle
            }
        } else {
            let sunk = self.inner_gap_m + (-push).powf(2.0 / 3.0) * inner;
            SectionVector {
                radial: radial - self.outer.gap_m - sunk,
                axial: self.outer.axial_m + axial,
            }
        }
    }

    /// Where the energy is least for a place of the ring.
    pub(crate) fn rest(&self, ring: Ring) -> Rest {
        match self.planar {
            true => self.rest_over([0], [0, 2, 3], ring),
            false => self.rest_over([0, 1], [0, 1, 2, 3, 4, 5, 6], ring),
        }
    }

    /// Where it is least over the coordinates `own` of u, ζ and those of the ring; `free`, which begin
    /// with them, are those that vary.
    fn rest_over<const B: usize, const N: usize>(
        &self,
        own: [usize; B],
        free: [usize; N],
        ring: Ring,
    ) -> Rest {
        let guess = self.guess(ring);
        let [x, y, z, p, q] = ring;
        let mut all = [guess.radial, guess.axial, x, y, z, p, q];
        let at = |place: [f64; B]| {
            let mut all = all;
            (0..B).for_each(|k| all[own[k]] = place[k]);
            self.energy(all, own)
        };
        let longest = 0.5 * self.outer.gap_m.min(self.inner_gap_m);
        let place = minimum(at, own.map(|k| all[k]), longest).place;
        (0..B).for_each(|k| all[own[k]] = place[k]);
        let whole = self.energy(all, free);
        let mut local = Local {
            energy: whole.energy,
            magnitude: whole.magnitude,
            ..Local::nothing(ring)
        };
        let h = &whole.hessian;
        let held: [[f64; B]; B] = std::array::from_fn(|i| std::array::from_fn(|j| h[i][j]));
        for i in B..N {
            local.gradient[free[i] - 2] = whole.gradient[i];
            let pull = std::array::from_fn(|k| h[k][i]);
            let follows = solve(&held, 0.0, pull).unwrap_or([0.0; B]);
            for j in i..N {
                let eased: f64 = (0..B).map(|k| h[j][k] * follows[k]).sum();
                let (row, column) = (free[i] - 2, free[j] - 2);
                local.hessian[row][column] = h[i][j] - eased;
                local.hessian[column][row] = local.hessian[row][column];
            }
        }
        Rest {
            place: SectionVector {
                radial: all[0],
                axial: all[1],
            },
            local,
        }
    }
}
