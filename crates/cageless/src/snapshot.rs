//! Snapshot of a bearing at one instant.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::dynamics::{Model, RightHandSide};
//! use cageless::initial_state;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let model = Model::new(&case)?;
//! let (state, angles) = initial_state(&case)?;
//! let snapshot = RightHandSide::new(&model).snapshot(0.0, &state, &angles);
//! let load_n: f64 = snapshot.inner_force_n.iter().sum();
//! assert!(load_n > case.operation.radial_load_n);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::sync::Arc;

/// Time, ring, whether there is a rotor and whether balls move in space, before the rotor and the
/// arrays of a row.
const HEAD: usize = 1 + RingSnapshot::FIELDS.len() + 2;

/// Declares names and units of the fields of a part of a snapshot: those of the plane come first.
macro_rules! fields {
    ($Part:ident, [$($field:ident: $unit:literal,)*], [$($spatial:ident: $spatial_unit:literal,)*]) => {
        impl $Part {
            /// Names of the fields with their units, those of motion in space last.
            pub const FIELDS: [(&'static str, &'static str); [$($unit,)* $($spatial_unit),*].len()] =
                [$((stringify!($field), $unit),)* $((stringify!($spatial), $spatial_unit)),*];

            /// Number of fields in the plane.
            pub const IN_PLANE: usize = [$($unit),*].len();
        }
    };
}

/// Declares the arrays of a snapshot over the balls, each with its unit.
macro_rules! arrays {
    (
        $(#[$meta:meta])*
        pub struct $Snapshot:ident {
            $($(#[$of:meta])* $field:ident: $unit:literal,)*
        }
        in space {
            $($(#[$of_spatial:meta])* $spatial:ident: $spatial_unit:literal,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, Default)]
        pub struct $Snapshot {
            /// Time since the start of the run.
            pub time_s: f64,
            $($(#[$of])* pub $field: Vec<f64>,)*
            $($(#[$of_spatial])* pub $spatial: Vec<f64>,)*
            /// The inner ring.
            pub ring: RingSnapshot,
            /// The rotor and what it moves, in a drop.
            pub rotor: Option<RotorSnapshot>,
        }

        fields!($Snapshot, [$($field: $unit,)*], [$($spatial: $spatial_unit,)*]);

        impl $Snapshot {
            /// The arrays over the balls, in the order of the fields.
            pub fn arrays(&self) -> Vec<&[f64]> {
                let mut all: Vec<&[f64]> = vec![$(&self.$field,)* $(&self.$spatial),*];
                all.truncate(Self::array_count(self.is_in_space()));
                all
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
                let count = Self::array_count(in_space);
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
                    $($field: next(),)*
                    $($spatial: next(),)*
                    ring,
                    rotor,
                }
            }
        }
    };
}

/// Declares a part of a snapshot: numbers, each with its unit.
macro_rules! numbers {
    (
        $(#[$meta:meta])*
        pub struct $Part:ident {
            $($(#[$of:meta])* $field:ident: $unit:literal,)*
        }
        in space {
            $($(#[$of_spatial:meta])* $spatial:ident: $spatial_unit:literal,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        pub struct $Part {
            $($(#[$of])* pub $field: f64,)*
            $($(#[$of_spatial])* pub $spatial: f64,)*
        }

        fields!($Part, [$($field: $unit,)*], [$($spatial: $spatial_unit,)*]);

        impl $Part {
            /// Values, in the order of the fields.
            pub fn values(&self) -> [f64; Self::FIELDS.len()] {
                [$(self.$field,)* $(self.$spatial),*]
            }

            /// Inverse of [`Self::values`].
            pub fn from_values(
                [$($field,)* $($spatial),*]: [f64; Self::FIELDS.len()],
            ) -> Self {
                Self { $($field,)* $($spatial),* }
            }
        }
    };
}

arrays! {
    /// Structure of arrays over the balls; index k is ball k+1.
    pub struct Snapshot {
        /// ψ, continuous (not wrapped), from the ball's place in its first turn.
        angle_rad: "rad",
        /// Centre of the ball.
        x_m: "m",
        /// Centre of the ball.
        y_m: "m",
        /// Velocity of the ball's centre.
        vx_m_s: "m/s",
        /// Velocity of the ball's centre.
        vy_m_s: "m/s",
        /// Absolute rotation about the bearing axis, clockwise positive: the rolling
        /// sense. It is not the spin about the contact normal of ball-bearing texts.
        rotation_rad_s: "rad/s",
        /// dψ/dt.
        orbit_speed_rad_s: "rad/s",
        /// Gap to the ball ahead, ψ(k+1) − ψ(k) − ε; that of ball N to ball 1.
        gap_rad: "rad",
        /// r, effective contact radius at the outer raceway.
        effective_radius_m: "m",
        /// Fi, normal force at the inner raceway.
        inner_force_n: "N",
        /// Fo, normal force at the outer raceway (radial sum of both contact points).
        outer_force_n: "N",
        /// ΔVi; positive speeds orbit and spin up.
        inner_sliding_m_s: "m/s",
        /// ΔVo; positive slows the orbit and speeds the spin up.
        outer_sliding_m_s: "m/s",
    }
    in space {
        /// z of the ball; like the next six empty in the plane.
        z_m: "m",
        /// Velocity of the ball's centre.
        vz_m_s: "m/s",
        /// Absolute rotation about X; that about Z is −[`Self::rotation_rad_s`].
        omega_x_rad_s: "rad/s",
        /// Absolute rotation about Y.
        omega_y_rad_s: "rad/s",
        /// Contact angle at the inner raceway, positive where an axial load along +Z presses; NaN
        /// without contact.
        inner_contact_angle_rad: "rad",
        /// Angle of the force at the outer raceway; NaN without contact.
        outer_contact_angle_rad: "rad",
        /// z of the outer ring of the ball's row, from where the case places it: of the housing, or of a ring
        /// that slides under a preload spring.
        outer_ring_z_m: "m",
    }
}

numbers! {
    /// The rotor, the speed of the inner ring and the outer ring on its support at one instant.
    pub struct RotorSnapshot {
        /// Mass centre.
        x_m: "m",
        /// Mass centre.
        y_m: "m",
        /// Velocity of the mass centre.
        vx_m_s: "m/s",
        /// Velocity of the mass centre.
        vy_m_s: "m/s",
        /// θ, counter-clockwise, since the start.
        angle_rad: "rad",
        /// Ω, counter-clockwise.
        speed_rad_s: "rad/s",
        /// ωi of the inner ring, counter-clockwise.
        ring_speed_rad_s: "rad/s",
        /// Outer ring and housing, from their rest place.
        housing_x_m: "m",
        /// Outer ring and housing, from their rest place.
        housing_y_m: "m",
        /// Velocity of outer ring and housing.
        housing_vx_m_s: "m/s",
        /// Velocity of outer ring and housing.
        housing_vy_m_s: "m/s",
        /// Normal force between rotor and inner ring.
        contact_force_n: "N",
        /// Sliding speed of the journal on the bore at their nearest points, counter-clockwise.
        contact_sliding_m_s: "m/s",
    }
    in space {
        /// Z; like the next four 0 in the plane.
        z_m: "m",
        /// Velocity along Z.
        vz_m_s: "m/s",
        /// Outer ring and housing, from their rest place.
        housing_z_m: "m",
        /// Velocity of outer ring and housing.
        housing_vz_m_s: "m/s",
        /// Force of the inner ring on a shoulder of the rotor along +Z.
        shoulder_force_n: "N",
    }
}

numbers! {
    /// The inner ring at one instant.
    pub struct RingSnapshot {
        /// Centre.
        x_m: "m",
        /// Centre.
        y_m: "m",
        /// Velocity of the centre.
        vx_m_s: "m/s",
        /// Velocity of the centre.
        vy_m_s: "m/s",
        /// Acceleration of the centre.
        ax_m_s2: "m/s^2",
        /// Acceleration of the centre.
        ay_m_s2: "m/s^2",
        /// Force of the balls on the outer ring, friction included.
        outer_force_x_n: "N",
        /// Force of the balls on the outer ring, friction included.
        outer_force_y_n: "N",
    }
    in space {
        /// Z of the centre; like the next three 0 in the plane.
        z_m: "m",
        /// Velocity of the centre.
        vz_m_s: "m/s",
        /// Tilt about X.
        tilt_x_rad: "rad",
        /// Tilt about Y.
        tilt_y_rad: "rad",
    }
}

impl Snapshot {
    /// Number of balls.
    pub fn balls(&self) -> usize {
        self.x_m.len()
    }

    /// Distance of ball `k` from the axis of the outer ring and its z from there, in space, m.
    pub fn place_in_outer_ring_m(&self, k: usize) -> [f64; 2] {
        let housing =
            (self.rotor.as_ref()).map_or([0.0; 2], |rotor| [rotor.housing_x_m, rotor.housing_y_m]);
        let place = [self.x_m[k] - housing[0], self.y_m[k] - housing[1]];
        [
            place[0].hypot(place[1]),
            self.z_m[k] - self.outer_ring_z_m[k],
        ]
    }

    /// Whether the balls move in space.
    pub fn is_in_space(&self) -> bool {
        !self.z_m.is_empty()
    }

    /// Number of arrays over the balls.
    fn array_count(in_space: bool) -> usize {
        match in_space {
            true => Self::FIELDS.len(),
            false => Self::IN_PLANE,
        }
    }

    /// All values in one row: less to allocate where many are kept.
    pub fn to_row(&self) -> Arc<[f64]> {
        let arrays = self.arrays();
        let mut row =
            Vec::with_capacity(HEAD + RotorSnapshot::FIELDS.len() + arrays.len() * self.balls());
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
        const ROTOR: usize = RotorSnapshot::FIELDS.len();
        let (head, rest) = row.split_at(HEAD);
        let ring = head[1..HEAD - 2]
            .try_into()
            .expect("time and ring come first");
        let (rotor, arrays) = rest.split_at(if head[HEAD - 2] > 0.0 { ROTOR } else { 0 });
        Self::from_parts(
            head[0],
            RingSnapshot::from_values(ring),
            rotor.try_into().ok().map(RotorSnapshot::from_values),
            arrays,
            head[HEAD - 1] > 0.0,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_leads_back_to_its_snapshot() {
        for (rotor, space) in [(0, 0), (RotorSnapshot::FIELDS.len(), 0), (0, 1)] {
            let count = Snapshot::array_count(space == 1);
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
