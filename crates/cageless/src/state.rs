//! The state vector: what the integrators advance.

/// Places of the groups in the flat state vector. Arrays over the balls are padded
/// to a multiple of [`LANES`], so that whole vectors can be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// N.
    pub balls: usize,
    /// Length of one padded array over the balls.
    pub stride: usize,
}

/// Padding of the arrays over the balls.
pub const LANES: usize = 8;

/// Largest number of balls.
pub const BALLS_MAX: usize = 256;

/// Entries of the energy ledger, carried in the state so that they are integrated
/// with the accuracy of the motion. All in joules since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// By the drive that keeps the inner ring at ωi.
    Drive,
    /// By the radial load.
    Load,
    /// By gravity on balls and ring.
    Weight,
    /// Lost to friction at the inner raceway.
    InnerFriction,
    /// Lost to friction at the outer raceway.
    OuterFriction,
    /// Lost to friction between balls.
    BallFriction,
    /// Lost to damping of the contacts.
    Damping,
    /// Lost to the drag on the inner ring.
    Drag,
    /// `paper` profile: by the centrifugal force added to Zhao 2022, Eq. (12).
    Centrifugal,
    /// `paper` profile: by outer friction acting along the contact path instead of
    /// along the sliding velocity.
    Direction,
    /// `paper` profile: by the relative spin of Eq. (13) standing for the absolute one.
    Frame,
}

impl Work {
    /// All entries, in the order of the state vector.
    pub const ALL: [Self; 11] = [
        Self::Drive,
        Self::Load,
        Self::Weight,
        Self::InnerFriction,
        Self::OuterFriction,
        Self::BallFriction,
        Self::Damping,
        Self::Drag,
        Self::Centrifugal,
        Self::Direction,
        Self::Frame,
    ];

    /// Whether the entry counts what leaves the bearing.
    pub fn is_loss(self) -> bool {
        matches!(
            self,
            Self::InnerFriction
                | Self::OuterFriction
                | Self::BallFriction
                | Self::Damping
                | Self::Drag
        )
    }

    /// Name in tables and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Drive => "drive",
            Self::Load => "radial_load",
            Self::Weight => "weight",
            Self::InnerFriction => "inner_friction",
            Self::OuterFriction => "outer_friction",
            Self::BallFriction => "ball_friction",
            Self::Damping => "damping",
            Self::Drag => "drag",
            Self::Centrifugal => "centrifugal_force",
            Self::Direction => "friction_direction",
            Self::Frame => "relative_spin",
        }
    }
}

impl Layout {
    /// Layout for `balls` balls.
    pub fn new(balls: usize) -> Self {
        Self {
            balls,
            stride: balls.next_multiple_of(LANES),
        }
    }

    /// Length of the state vector.
    #[allow(clippy::len_without_is_empty)] // never empty
    pub fn len(&self) -> usize {
        self.ledger() + Work::ALL.len()
    }

    /// Start of x, y, vx, vy, spin (groups 0 to 4).
    pub fn group(&self, group: usize) -> usize {
        group * self.stride
    }

    /// Start of the ring's X, Y, Ẋ, Ẏ.
    pub fn ring(&self) -> usize {
        5 * self.stride
    }

    /// Start of the energy ledger.
    pub fn ledger(&self) -> usize {
        self.ring() + 4
    }
}

/// Positions and velocities of balls and ring, and the energy ledger.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    layout: Layout,
    values: Vec<f64>,
}

impl State {
    /// Everything zero, but for padding balls, which sit apart from each other on a
    /// circle of radius `pitch_radius_m` so that no distance between them vanishes.
    pub fn new(balls: usize, pitch_radius_m: f64) -> Self {
        let layout = Layout::new(balls);
        let mut values = vec![0.0; layout.len()];
        for k in balls..layout.stride {
            let (sin, cos) = (k as f64).sin_cos();
            values[layout.group(0) + k] = pitch_radius_m * sin;
            values[layout.group(1) + k] = -pitch_radius_m * cos;
        }
        Self { layout, values }
    }

    /// Wraps a vector that an integrator has advanced.
    pub fn from_values(layout: Layout, values: Vec<f64>) -> Self {
        assert_eq!(values.len(), layout.len());
        Self { layout, values }
    }

    /// Layout of [`Self::values`].
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// The flat vector.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The flat vector.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    fn group(&self, group: usize) -> &[f64] {
        &self.values[self.layout.group(group)..][..self.layout.balls]
    }

    fn group_mut(&mut self, group: usize) -> &mut [f64] {
        &mut self.values[self.layout.group(group)..][..self.layout.balls]
    }

    /// x of every ball, m.
    pub fn x_m(&self) -> &[f64] {
        self.group(0)
    }

    /// y of every ball, m.
    pub fn y_m(&self) -> &[f64] {
        self.group(1)
    }

    /// Velocity along x of every ball, m/s.
    pub fn vx_m_s(&self) -> &[f64] {
        self.group(2)
    }

    /// Velocity along y of every ball, m/s.
    pub fn vy_m_s(&self) -> &[f64] {
        self.group(3)
    }

    /// Spin state of every ball, rad/s, clockwise positive: absolute in the `physical`
    /// profile, relative to the orbit in `paper` (Zhao 2022, Eq. (13)).
    pub fn spin_state_rad_s(&self) -> &[f64] {
        self.group(4)
    }

    /// Puts ball `k`: position, velocity, spin state.
    pub fn set_ball(&mut self, k: usize, position_m: [f64; 2], velocity_m_s: [f64; 2], spin: f64) {
        for (group, value) in [
            position_m[0],
            position_m[1],
            velocity_m_s[0],
            velocity_m_s[1],
            spin,
        ]
        .into_iter()
        .enumerate()
        {
            self.group_mut(group)[k] = value;
        }
    }

    /// X, Y, Ẋ, Ẏ of the ring's centre, m and m/s.
    pub fn ring(&self) -> [f64; 4] {
        let at = self.layout.ring();
        [
            self.values[at],
            self.values[at + 1],
            self.values[at + 2],
            self.values[at + 3],
        ]
    }

    /// Puts the ring.
    pub fn set_ring(&mut self, ring: [f64; 4]) {
        let at = self.layout.ring();
        self.values[at..at + 4].copy_from_slice(&ring);
    }

    /// One entry of the energy ledger, J.
    pub fn work_j(&self, work: Work) -> f64 {
        self.values[self.layout.ledger() + work as usize]
    }
}
