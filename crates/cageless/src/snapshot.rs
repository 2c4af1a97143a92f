//! Snapshot of a bearing at one instant.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::dynamics::{Model, RightHandSide};
//! use cageless::initial_conditions::initial_state;
//!
//! let case = common::structure(5.1, 25.2); // Zhao 2022, Table 2, structure (d)
//!
//! let model = Model::new(&case)?;
//! let (state, angles) = initial_state(&case)?;
//! let snapshot = RightHandSide::new(&model).snapshot(0.0, &state, &angles);
//! let load_n: f64 = snapshot.inner_force_n.iter().sum();
//! assert!(load_n > case.operation.radial_load_n);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::sync::Arc;

/// Arrays over the balls: in the plane, and all in space.
const ARRAYS: [usize; 2] = [13, 19];
/// Values of a ring.
const RING: usize = 12;
/// Time, ring, whether there is a rotor and whether balls move in space, before the rotor and the
/// arrays of a row.
const HEAD: usize = 1 + RING + 2;
/// Values of a rotor.
const ROTOR: usize = 18;

/// Structure of arrays over the balls; index k is ball k+1.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Snapshot {
    /// Time since the start of the run.
    pub time_s: f64,
    /// ψ, continuous (not wrapped), from the ball's place in its first turn.
    pub angle_rad: Vec<f64>,
    /// Centre of the ball.
    pub x_m: Vec<f64>,
    /// Centre of the ball.
    pub y_m: Vec<f64>,
    /// Velocity of the ball's centre.
    pub vx_m_s: Vec<f64>,
    /// Velocity of the ball's centre.
    pub vy_m_s: Vec<f64>,
    /// Absolute rotation about the bearing axis, clockwise positive: the rolling
    /// sense. It is not the spin about the contact normal of ball-bearing texts.
    pub rotation_rad_s: Vec<f64>,
    /// dψ/dt.
    pub orbit_speed_rad_s: Vec<f64>,
    /// Gap to the ball ahead, ψ(k+1) − ψ(k) − ε; that of ball N to ball 1.
    pub gap_rad: Vec<f64>,
    /// r, effective contact radius at the outer raceway.
    pub effective_radius_m: Vec<f64>,
    /// Fi, normal force at the inner raceway.
    pub inner_force_n: Vec<f64>,
    /// Fo, normal force at the outer raceway (radial sum of both contact points).
    pub outer_force_n: Vec<f64>,
    /// ΔVi; positive speeds orbit and spin up.
    pub inner_sliding_m_s: Vec<f64>,
    /// ΔVo; positive slows the orbit and speeds the spin up.
    pub outer_sliding_m_s: Vec<f64>,
    /// z of the ball; like the next five empty in the plane.
    pub z_m: Vec<f64>,
    /// Velocity of the ball's centre.
    pub vz_m_s: Vec<f64>,
    /// Absolute rotation about X; that about Z is −[`Self::rotation_rad_s`].
    pub omega_x_rad_s: Vec<f64>,
    /// Absolute rotation about Y.
    pub omega_y_rad_s: Vec<f64>,
    /// Contact angle at the inner raceway, positive where an axial load along +Z presses; NaN
    /// without contact.
    pub inner_contact_angle_rad: Vec<f64>,
    /// Angle of the force at the outer raceway; NaN without contact.
    pub outer_contact_angle_rad: Vec<f64>,
    /// The inner ring.
    pub ring: RingSnapshot,
    /// The rotor and what it moves, in a drop.
    pub rotor: Option<RotorSnapshot>,
}

/// The rotor, the speed of the inner ring and the outer ring on its support at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RotorSnapshot {
    /// Mass centre.
    pub x_m: f64,
    /// Mass centre.
    pub y_m: f64,
    /// Velocity of the mass centre.
    pub vx_m_s: f64,
    /// Velocity of the mass centre.
    pub vy_m_s: f64,
    /// θ, counter-clockwise, since the start.
    pub angle_rad: f64,
    /// Ω, counter-clockwise.
    pub speed_rad_s: f64,
    /// ωi of the inner ring, counter-clockwise.
    pub ring_speed_rad_s: f64,
    /// Outer ring and housing, from their rest place.
    pub housing_x_m: f64,
    /// Outer ring and housing, from their rest place.
    pub housing_y_m: f64,
    /// Velocity of outer ring and housing.
    pub housing_vx_m_s: f64,
    /// Velocity of outer ring and housing.
    pub housing_vy_m_s: f64,
    /// Normal force between rotor and inner ring.
    pub contact_force_n: f64,
    /// Sliding speed of the journal on the bore at their nearest points, counter-clockwise.
    pub contact_sliding_m_s: f64,
    /// Z; like the next four 0 in the plane.
    pub z_m: f64,
    /// Velocity along Z.
    pub vz_m_s: f64,
    /// Outer ring and housing, from their rest place.
    pub housing_z_m: f64,
    /// Velocity of outer ring and housing.
    pub housing_vz_m_s: f64,
    /// Force of the inner ring on a shoulder of the rotor along +Z.
    pub shoulder_force_n: f64,
}

/// The inner ring at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RingSnapshot {
    /// Centre.
    pub x_m: f64,
    /// Centre.
    pub y_m: f64,
    /// Velocity of the centre.
    pub vx_m_s: f64,
    /// Velocity of the centre.
    pub vy_m_s: f64,
    /// Acceleration of the centre.
    pub ax_m_s2: f64,
    /// Acceleration of the centre.
    pub ay_m_s2: f64,
    /// Force of the balls on the outer ring, friction included.
    pub outer_force_x_n: f64,
    /// Force of the balls on the outer ring, friction included.
    pub outer_force_y_n: f64,
    /// Z of the centre; like the next three 0 in the plane.
    pub z_m: f64,
    /// Velocity of the centre.
    pub vz_m_s: f64,
    /// Tilt about X.
    pub tilt_x_rad: f64,
    /// Tilt about Y.
    pub tilt_y_rad: f64,
}

impl Snapshot {
    /// Number of balls.
    pub fn balls(&self) -> usize {
        self.x_m.len()
    }

    /// Whether the balls move in space.
    pub fn is_in_space(&self) -> bool {
        !self.z_m.is_empty()
    }

    /// The arrays over the balls, in the order of the fields.
    pub fn arrays(&self) -> Vec<&[f64]> {
        let all: [&[f64]; ARRAYS[1]] = [
            &self.angle_rad,
            &self.x_m,
            &self.y_m,
            &self.vx_m_s,
            &self.vy_m_s,
            &self.rotation_rad_s,
            &self.orbit_speed_rad_s,
            &self.gap_rad,
            &self.effective_radius_m,
            &self.inner_force_n,
            &self.outer_force_n,
            &self.inner_sliding_m_s,
            &self.outer_sliding_m_s,
            &self.z_m,
            &self.vz_m_s,
            &self.omega_x_rad_s,
            &self.omega_y_rad_s,
            &self.inner_contact_angle_rad,
            &self.outer_contact_angle_rad,
        ];
        all[..ARRAYS[usize::from(self.is_in_space())]].to_vec()
    }

    /// All values in one row: less to allocate where many are kept.
    pub fn to_row(&self) -> Arc<[f64]> {
        let arrays = self.arrays();
        let mut row = Vec::with_capacity(HEAD + ROTOR + arrays.len() * self.balls());
        row.push(self.time_s);
        row.extend(self.ring.values());
        row.extend([self.rotor.is_some(), self.is_in_space()].map(f64::from));
        row.extend(self.rotor.iter().flat_map(RotorSnapshot::values));
        row.extend(arrays.into_iter().flatten());
        row.into()
    }

    /// The inverse of [`Self::to_row`].
    ///
    /// # Panics
    /// If it is no such row.
    pub fn from_row(row: &[f64]) -> Self {
        let (head, rest) = row.split_at(HEAD);
        let ring = head[1..=RING].try_into().expect("time and ring come first");
        let (rotor, arrays) = rest.split_at(if head[HEAD - 2] > 0.0 { ROTOR } else { 0 });
        Self::from_parts(
            head[0],
            RingSnapshot::from_values(ring),
            rotor.try_into().ok().map(RotorSnapshot::from_values),
            arrays,
            head[HEAD - 1] > 0.0,
        )
    }

    /// Snapshot of its parts; `arrays` are the arrays over the balls, one after another in the
    /// order of [`Self::arrays`], with those of balls that move in space or without.
    ///
    /// # Panics
    /// If the arrays do not all have the same length.
    pub fn from_parts(
        time_s: f64,
        ring: RingSnapshot,
        rotor: Option<RotorSnapshot>,
        arrays: &[f64],
        in_space: bool,
    ) -> Self {
        let count = ARRAYS[usize::from(in_space)];
        let balls = arrays.len() / count;
        assert!(
            balls * count == arrays.len(),
            "{} values over the balls are no multiple of {count}",
            arrays.len()
        );
        let mut arrays = (0..count).map(|k| arrays[k * balls..][..balls].to_vec());
        let mut next = || arrays.next().unwrap_or_default();
        Self {
            time_s,
            angle_rad: next(),
            x_m: next(),
            y_m: next(),
            vx_m_s: next(),
            vy_m_s: next(),
            rotation_rad_s: next(),
            orbit_speed_rad_s: next(),
            gap_rad: next(),
            effective_radius_m: next(),
            inner_force_n: next(),
            outer_force_n: next(),
            inner_sliding_m_s: next(),
            outer_sliding_m_s: next(),
            z_m: next(),
            vz_m_s: next(),
            omega_x_rad_s: next(),
            omega_y_rad_s: next(),
            inner_contact_angle_rad: next(),
            outer_contact_angle_rad: next(),
            ring,
            rotor,
        }
    }
}

/// Values of a snapshot's part in the order of its fields, and the part from them.
macro_rules! values {
    ($part:ident, $count:expr, $($field:ident),*) => {
        impl $part {
            /// Values, in the order of the fields.
            pub fn values(&self) -> [f64; $count] {
                [$(self.$field),*]
            }

            /// Inverse of [`Self::values`].
            pub fn from_values([$($field),*]: [f64; $count]) -> Self {
                Self { $($field),* }
            }
        }
    };
}

values!(
    RingSnapshot,
    RING,
    x_m,
    y_m,
    vx_m_s,
    vy_m_s,
    ax_m_s2,
    ay_m_s2,
    outer_force_x_n,
    outer_force_y_n,
    z_m,
    vz_m_s,
    tilt_x_rad,
    tilt_y_rad
);
values!(
    RotorSnapshot,
    ROTOR,
    x_m,
    y_m,
    vx_m_s,
    vy_m_s,
    angle_rad,
    speed_rad_s,
    ring_speed_rad_s,
    housing_x_m,
    housing_y_m,
    housing_vx_m_s,
    housing_vy_m_s,
    contact_force_n,
    contact_sliding_m_s,
    z_m,
    vz_m_s,
    housing_z_m,
    housing_vz_m_s,
    shoulder_force_n
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_leads_back_to_its_snapshot() {
        for (rotor, space) in [(0, 0), (ROTOR, 0), (0, 1)] {
            let count = ARRAYS[space];
            let mut row: Vec<f64> = (0..HEAD + rotor + 3 * count).map(|k| k as f64).collect();
            row[HEAD - 2] = if rotor > 0 { 1.0 } else { 0.0 };
            row[HEAD - 1] = space as f64;
            let snapshot = Snapshot::from_row(&row);
            assert_eq!((snapshot.time_s, snapshot.ring.tilt_y_rad), (0.0, 12.0));
            let first = (HEAD + rotor) as f64;
            assert_eq!(snapshot.angle_rad, [first, first + 1.0, first + 2.0]);
            let last = first + 36.0;
            assert_eq!(snapshot.outer_sliding_m_s, [last, last + 1.0, last + 2.0]);
            let angle = snapshot.outer_contact_angle_rad.first().copied();
            assert_eq!(angle, (space == 1).then_some(first + 54.0));
            let slip = snapshot.rotor.map(|r| r.contact_sliding_m_s);
            assert_eq!(slip, (rotor > 0).then_some(27.0));
            assert_eq!(*snapshot.to_row(), *row);
        }
    }
}
