//! Energy of the ring with every ball where its energy is least, and the places where it is lowest.
//!
//! V(**R**, p, q) = Fr Y − Fa Z − My p + Mx q + Σ min U. Its gradient is the force and the moment
//! left on the ring, its Hessian Uxx − Uxu Uuu⁻¹ Uux the stiffness with the balls in equilibrium.
//! A spring of the constant force σF moves the outer ring of its row until the balls push back with as
//! much; to its row that is a ring at another Z, over which V is least as well.
//! Moments act on p and q; a couple that stays fixed in space differs by the square of the tilt.

use super::ball::{Rest, Ring, SpatialBall};
use crate::case::Tilt;
use crate::control::Control;
use crate::equilibrium::EquilibriumError;
use crate::numerics::minimum::{Local, norm, try_minimum};

/// Coordinate of the ring along the axis among **R**, p, q.
pub(super) const Z: usize = 2;
/// Fraction of the force of a spring that may be left on its outer ring.
const SPRING_TOLERANCE: f64 = 1e-12;
const SPRING_ITERATIONS: usize = 100;

/// Fraction of all forces that may be left on the ring.
const FORCE_TOLERANCE: f64 = 1e-9;

/// Places where the search starts, over the depth at which the balls carry the ring.
const SIDES: [[f64; 2]; 4] = [[1.0, -1.0], [-1.0, -1.0], [0.0, -1.0], [0.0; 2]];

/// Ring and balls.
#[derive(Debug, Clone)]
pub(in crate::equilibrium) struct LoadBalance {
    /// Whether ring and balls stay in the plane.
    pub planar: bool,
    pub balls: Vec<SpatialBall>,
    /// Axial force of the preload spring of each row, that of its balls on the outer ring, N; `None`
    /// where the outer ring is held.
    pub springs_n: Vec<Option<f64>>,
    /// Load and weight on the ring, −Y.
    pub down_n: f64,
    /// Fa.
    pub axial_n: f64,
    pub tilt: Tilt,
    /// Length by which tilts become displacements: the radius of the pitch circle.
    pub arm_m: f64,
    /// No step of the ring is longer.
    pub longest_m: f64,
    /// Displacement of the ring at which it meets the shoulders of the outer one.
    pub clearance_m: f64,
}

/// Places of the ring and of every ball.
#[derive(Debug, Clone)]
pub(in crate::equilibrium) struct Balanced {
    pub ring: Ring,
    pub rests: Vec<Rest>,
    /// Displacement of the outer ring of every row by its spring, m.
    pub shifts_m: Vec<f64>,
    /// V over **R**, p, q.
    pub local: Local<5>,
}

impl Balanced {
    /// Coordinates of the ring, seen from the outer ring of a row.
    pub(crate) fn ring_of(&self, row: usize) -> Ring {
        seen_from(self.ring, self.shifts_m[row])
    }
}

fn seen_from([x, y, z, p, q]: Ring, shift_m: f64) -> Ring {
    [x, y, z - shift_m, p, q]
}

/// Every ball of a row where its energy is least; their sum is added to an energy over the coordinates
/// of the ring.
fn add_row(balls: &[SpatialBall], ring: Ring, local: &mut Local<5>) -> Vec<Rest> {
    let rests: Vec<Rest> = balls.iter().map(|ball| ball.rest(ring)).collect();
    for Rest { local: own, .. } in &rests {
        local.energy += own.energy;
        local.magnitude += own.magnitude;
        for i in 0..5 {
            local.gradient[i] += own.gradient[i];
            for j in 0..5 {
                local.hessian[j][i] += own.hessian[j][i];
            }
        }
    }
    rests
}

/// A row whose outer ring is where its balls push with `force_n`: its energy and the displacement of
/// that ring are added.
fn add_sprung_row(
    balls: &[SpatialBall],
    ring: Ring,
    force_n: f64,
    longest_m: f64,
    local: &mut Local<5>,
) -> (Vec<Rest>, f64) {
    let mut shift = 0.0;
    let mut bounds = [f64::NEG_INFINITY, f64::INFINITY];
    let mut tries = 0;
    let (mut own, rests) = loop {
        let mut own = Local::nothing(ring);
        let rests = add_row(balls, seen_from(ring, shift), &mut own);
        // Grows as the outer ring moves against Z.
        let beyond = own.gradient[Z] - force_n;
        bounds[usize::from(beyond < 0.0)] = shift;
        let step = match own.hessian[Z][Z] > 0.0 {
            true => (beyond / own.hessian[Z][Z]).clamp(-longest_m, longest_m),
            false => longest_m.copysign(beyond),
        };
        let mut next = shift + step;
        if !(bounds[0] < next && next < bounds[1]) {
            next = 0.5 * (bounds[0] + bounds[1]);
        }
        tries += 1;
        let done = beyond.abs() <= SPRING_TOLERANCE * force_n.abs() || next == shift;
        if done || tries == SPRING_ITERATIONS {
            break (own, rests);
        }
        shift = next;
    };
    let work = force_n * shift;
    own.energy += work;
    own.magnitude += work.abs();
    let h = own.hessian;
    for i in 0..5 {
        local.gradient[i] += own.gradient[i];
        for j in (0..5).filter(|j| h[Z][Z] > 0.0 && i != Z && *j != Z) {
            local.hessian[i][j] += h[i][j] - h[i][Z] * h[Z][j] / h[Z][Z];
        }
    }
    local.energy += own.energy;
    local.magnitude += own.magnitude;
    (rests, shift)
}

impl LoadBalance {
    /// Coordinates of the ring at a place in which tilts count as displacements of the pitch
    /// circle.
    fn ring(&self, place: [f64; 5]) -> Ring {
        let [x, y, z, p, q] = place;
        [x, y, z, p / self.arm_m, q / self.arm_m]
    }

    /// Every ball, and the outer ring of every row, for a place of the ring.
    pub(crate) fn around(&self, ring: Ring) -> Balanced {
        let [mx, my] = match self.tilt {
            Tilt::Held { .. } => [0.0; 2],
            Tilt::Free {
                moment_x_n_m,
                moment_y_n_m,
            } => [moment_x_n_m, moment_y_n_m],
        };
        let load = [0.0, self.down_n, -self.axial_n, -my, mx];
        let work = (0..5).map(|k| load[k] * ring[k]);
        let mut local = Local {
            energy: work.clone().sum(),
            magnitude: work.map(f64::abs).sum(),
            gradient: load,
            ..Local::nothing(ring)
        };
        let (mut rests, mut shifts_m) = (vec![], vec![]);
        let rows = self.balls.chunk_by(|a, b| a.row == b.row);
        for (balls, spring) in rows.zip(&self.springs_n) {
            let (own, shift) = match spring {
                None => (add_row(balls, ring, &mut local), 0.0),
                Some(force) => add_sprung_row(balls, ring, *force, self.longest_m, &mut local),
            };
            rests.extend(own);
            shifts_m.push(shift);
        }
        Balanced {
            ring,
            rests,
            shifts_m,
            local,
        }
    }

    /// Coordinates of the ring that are held.
    fn held(&self) -> &'static [usize] {
        match self.tilt {
            _ if self.planar => &[2, 3, 4],
            Tilt::Held { .. } => &[3, 4],
            Tilt::Free { .. } => &[],
        }
    }

    /// V with tilts as displacements; what is held does not move.
    fn at(&self, place: [f64; 5]) -> Local<5> {
        let mut local = self.around(self.ring(place)).local;
        local.place = place;
        for i in 0..5 {
            let of = |k: usize| if k < 3 { 1.0 } else { 1.0 / self.arm_m };
            local.gradient[i] *= of(i);
            for j in 0..5 {
                local.hessian[i][j] *= of(i) * of(j);
            }
        }
        let even = local.hessian[0][0].abs() + local.hessian[1][1].abs() + 1.0;
        for &k in self.held() {
            local.gradient[k] = 0.0;
            (0..5).for_each(|i| local.hessian[i][k] = 0.0);
            local.hessian[k] = [0.0; 5];
            local.hessian[k][k] = even;
        }
        local
    }

    /// Sum of the absolute forces that act from outside.
    fn forces_n(&self) -> f64 {
        let moments = match self.tilt {
            Tilt::Held { .. } => 0.0,
            Tilt::Free {
                moment_x_n_m,
                moment_y_n_m,
            } => (moment_x_n_m.abs() + moment_y_n_m.abs()) / self.arm_m,
        };
        let push =
            |ball: &SpatialBall| (ball.steady_n + ball.turning_n_m / ball.orbit_radius_m).abs();
        let springs: f64 = self.springs_n.iter().flatten().map(|f| f.abs()).sum();
        self.down_n.abs()
            + self.axial_n.abs()
            + moments
            + springs
            + self.balls.iter().map(push).sum::<f64>()
    }

    /// Force with which the balls push back at the places where the search starts, N: what an
    /// interference or a preload adds to the forces.
    fn preload_n(&self, place: [f64; 5]) -> f64 {
        let around = self.around(self.ring(place));
        let balls = self.balls.iter().zip(&around.rests);
        balls
            .map(|(ball, rest)| ball.outer_force_n(rest.place))
            .sum()
    }

    /// z of a deep groove ring under the axial load alone: without clearance the force grows with
    /// z⁴, z⁴ = 2^(3/2) A^(5/2) Fa/(Z Kn), so that no stiffness holds it at 0.
    fn axial_start_m(&self) -> f64 {
        let ball = &self.balls[0];
        let series = crate::case::series_stiffness_n_m1_5(
            ball.inner_stiffness_n_m1_5,
            ball.outer_stiffness_n_m1_5,
        );
        let room = ball.inner_gap_m + ball.outer.gap_m;
        let share = self.axial_n.abs() / self.balls.len() as f64;
        let depth = (2f64.powf(1.5) * room.powf(2.5) * share / series).powf(0.25);
        depth.copysign(self.axial_n)
    }

    /// The lowest minimum that is reached from the right, the left and below at `depth_m` and from
    /// the middle; of two that are level to rounding the first.
    ///
    /// # Errors
    /// There is none, or `control` ended the search.
    pub(crate) fn settle(
        &self,
        depth_m: f64,
        control: &mut dyn FnMut() -> Control,
    ) -> Result<Balanced, EquilibriumError> {
        let [p, q] = match self.tilt {
            Tilt::Held { x_rad, y_rad } => [y_rad * self.arm_m, -x_rad * self.arm_m],
            Tilt::Free { .. } => [0.0; 2],
        };
        let z = self.axial_start_m();
        let middle = [0.0, 0.0, 0.0, p, q];
        // In the plane a loaded ring leaves the middle.
        let sides = match self.down_n == 0.0 {
            true => &SIDES[3..],
            false => &SIDES[..4 - usize::from(self.planar)],
        };
        let forces = self.forces_n() + self.preload_n(middle);
        let mut lowest: Option<Local<5>> = None;
        let fallen = |found: &Local<5>| found.place[0].hypot(found.place[1]) > self.clearance_m;
        let mut failed = EquilibriumError::Unsupported;
        for [x, y] in sides {
            let start = [x * depth_m, y * depth_m, z, p, q];
            let watched = |place| match control() {
                Control::Continue(()) => Ok(self.at(place)),
                Control::Break(()) => Err(EquilibriumError::Interrupted),
            };
            let found = try_minimum(watched, start, self.longest_m)?;
            let residual_n = norm(found.gradient);
            if !(residual_n <= FORCE_TOLERANCE * forces) {
                if !fallen(&found) {
                    failed = EquilibriumError::NotConverged { residual_n };
                }
                continue;
            }
            let rounding = 1e-14 * found.magnitude;
            if lowest.is_none_or(|best| found.energy < best.energy - rounding) {
                lowest = Some(found);
            }
        }
        match lowest.ok_or(failed)? {
            lowest if fallen(&lowest) => Err(EquilibriumError::Unsupported),
            lowest => Ok(self.around(self.ring(lowest.place))),
        }
    }
}
