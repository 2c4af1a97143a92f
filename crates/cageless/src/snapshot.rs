//! Everything that can be seen of a bearing at one instant.

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
    pub spin_rad_s: Vec<f64>,
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
    pub inner_slip_m_s: Vec<f64>,
    /// ΔVo; positive slows the orbit and speeds the spin up.
    pub outer_slip_m_s: Vec<f64>,
    /// The inner ring.
    pub ring: RingSnapshot,
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
    /// What the balls put on the outer ring, friction included.
    pub outer_force_x_n: f64,
    /// What the balls put on the outer ring, friction included.
    pub outer_force_y_n: f64,
}

impl Snapshot {
    /// Number of balls.
    pub fn balls(&self) -> usize {
        self.x_m.len()
    }

    /// The arrays over the balls, in the order of the fields.
    pub fn arrays(&self) -> [&[f64]; 13] {
        [
            &self.angle_rad,
            &self.x_m,
            &self.y_m,
            &self.vx_m_s,
            &self.vy_m_s,
            &self.spin_rad_s,
            &self.orbit_speed_rad_s,
            &self.gap_rad,
            &self.effective_radius_m,
            &self.inner_force_n,
            &self.outer_force_n,
            &self.inner_slip_m_s,
            &self.outer_slip_m_s,
        ]
    }

    pub(crate) fn arrays_mut(&mut self) -> [&mut [f64]; 13] {
        [
            &mut self.angle_rad,
            &mut self.x_m,
            &mut self.y_m,
            &mut self.vx_m_s,
            &mut self.vy_m_s,
            &mut self.spin_rad_s,
            &mut self.orbit_speed_rad_s,
            &mut self.gap_rad,
            &mut self.effective_radius_m,
            &mut self.inner_force_n,
            &mut self.outer_force_n,
            &mut self.inner_slip_m_s,
            &mut self.outer_slip_m_s,
        ]
    }
}

impl RingSnapshot {
    /// The values, in the order of the fields.
    pub fn values(&self) -> [f64; 8] {
        [
            self.x_m,
            self.y_m,
            self.vx_m_s,
            self.vy_m_s,
            self.ax_m_s2,
            self.ay_m_s2,
            self.outer_force_x_n,
            self.outer_force_y_n,
        ]
    }

    pub(crate) fn from_values(values: [f64; 8]) -> Self {
        let [
            x_m,
            y_m,
            vx_m_s,
            vy_m_s,
            ax_m_s2,
            ay_m_s2,
            outer_force_x_n,
            outer_force_y_n,
        ] = values;
        Self {
            x_m,
            y_m,
            vx_m_s,
            vy_m_s,
            ax_m_s2,
            ay_m_s2,
            outer_force_x_n,
            outer_force_y_n,
        }
    }
}
