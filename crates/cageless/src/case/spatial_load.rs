//! Load, tilt and rows of a bearing in space.

/// Load on the inner ring out of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpatialLoad {
    /// Fa, along +Z.
    pub axial_load_n: f64,
    /// What holds or turns the axis of the inner ring.
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
            balls: None,
        }
    }
}
