//! Load, tilt and rows of a bearing in space.

use crate::bearing::Bearing;

/// Damping of a sliding fit over the area of its seat, N·s/m³: a film of oil of 0.03 Pa·s, 5 µm thick.
const FIT_DAMPING_N_S_M3: f64 = 0.03 / 5e-6;

/// Load on the inner ring out of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpatialLoad {
    /// Fa, along +Z.
    pub axial_load_n: f64,
    /// Tilt of the inner ring: angles at which the shaft holds it, or moments that turn it.
    pub tilt: Tilt,
    /// It and Ip of the inner ring with its shaft, with which moments turn it in motion, kg·m².
    pub inertias_kg_m2: Option<[f64; 2]>,
}

crate::named_enum! {
    /// Space in which a bearing moves.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Motion {
        /// The plane where load, tilt and contact angles leave the bearing in it, else space.
        #[default]
        BySymmetry = "auto",
        /// Space.
        Space = "space",
    }
}

/// Tilt of the inner ring: its axis is **a** = (p, q, √(1 − p² − q²)) with p the tilt about Y and
/// −q the tilt about X, exact components and no small angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tilt {
    /// The shaft holds it.
    Held {
        /// −q.
        x_rad: f64,
        /// p.
        y_rad: f64,
    },
    /// Moments turn it.
    Free {
        /// About X.
        moment_x_n_m: f64,
        /// About Y.
        moment_y_n_m: f64,
    },
}

impl Default for Tilt {
    fn default() -> Self {
        Self::Held {
            x_rad: 0.0,
            y_rad: 0.0,
        }
    }
}

/// One row of balls on the common inner ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// z of its middle.
    pub axial_position_m: f64,
    /// σ: 1 where the balls press the outer ring towards +Z, −1 where towards −Z.
    pub contact_sign: f64,
    /// Displacement of its outer ring by −σ times this, which presses rows of opposite signs.
    pub preload_m: f64,
    /// Force of a soft spring on its outer ring by −σ times this; 0: the outer ring is held.
    pub preload_n: f64,
    /// Mass that slides with the outer ring under a spring; that of `Bearing::outer_ring_mass_kg` if `None`.
    pub sliding_mass_kg: Option<f64>,
    /// Viscous damping of that ring in its housing; that of a film of oil if `None`.
    pub sliding_damping_n_s_m: Option<f64>,
    /// Balls; those of the bearing if `None`.
    pub balls: Option<usize>,
}

impl Default for Row {
    fn default() -> Self {
        Self {
            axial_position_m: 0.0,
            contact_sign: 1.0,
            preload_m: 0.0,
            preload_n: 0.0,
            sliding_mass_kg: None,
            sliding_damping_n_s_m: None,
            balls: None,
        }
    }
}

impl Row {
    /// [`Self::sliding_mass_kg`], kg, and [`Self::sliding_damping_n_s_m`], N·s/m, in this bearing.
    pub(crate) fn sliding(&self, bearing: &Bearing) -> [f64; 2] {
        let film = || FIT_DAMPING_N_S_M3 * bearing.outer_seat_area_m2();
        [
            (self.sliding_mass_kg).unwrap_or_else(|| bearing.outer_ring_mass_kg()),
            self.sliding_damping_n_s_m.unwrap_or_else(film),
        ]
    }
}
