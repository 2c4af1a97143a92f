//! The state vector: what the integrators advance.

/// Places of the groups in the flat vector that an integrator advances: of one bearing,
/// or of [`MEMBERS`] bearings side by side, whose entries for the same ball lie next to each
/// other. Arrays over the balls are padded to a multiple of [`LANES`], so that whole vectors
/// are computed either way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// N.
    pub balls: usize,
    /// Length of one array over the balls.
    pub stride: usize,
    /// Bearings side by side.
    members: usize,
    /// The one whose places are given.
    member: usize,
}

/// Padding of the arrays over the balls.
pub const LANES: usize = 16;

/// Bearings side by side; two balls of each fill a block.
pub const MEMBERS: usize = 8;

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
    /// Layout for one bearing of `balls` balls.
    pub fn new(balls: usize) -> Self {
        Self {
            balls,
            stride: balls.next_multiple_of(LANES),
            members: 1,
            member: 0,
        }
    }

    /// Layout for [`MEMBERS`] bearings of `balls` balls each, with the places of the first.
    pub fn side_by_side(balls: usize) -> Self {
        Self {
            balls,
            stride: (balls * MEMBERS).next_multiple_of(LANES),
            members: MEMBERS,
            member: 0,
        }
    }

    /// The same vector with the places of another bearing.
    pub fn of_member(self, member: usize) -> Self {
        assert!(member < self.members);
        Self { member, ..self }
    }

    /// Bearings side by side.
    pub fn members(&self) -> usize {
        self.members
    }

    /// Which of them the places belong to.
    pub fn member(&self) -> usize {
        self.member
    }

    /// Length of the vector.
    #[allow(clippy::len_without_is_empty)] // never empty
    pub fn len(&self) -> usize {
        5 * self.stride + (4 + Work::ALL.len()) * self.members
    }

    /// Entries of an array over the balls that are not padding.
    pub fn entries(&self) -> usize {
        self.balls * self.members
    }

    /// Start of x, y, vx, vy, spin (groups 0 to 4) of all balls and bearings.
    pub fn group(&self, group: usize) -> usize {
        group * self.stride
    }

    /// Place of ball `k` in a group.
    pub fn ball(&self, group: usize, k: usize) -> usize {
        debug_assert!(k < self.balls);
        group * self.stride + k * self.members + self.member
    }

    /// Place of the ring's X, Y, Ẋ, Ẏ (0 to 3).
    pub fn ring(&self, k: usize) -> usize {
        5 * self.stride + k * self.members + self.member
    }

    /// Place of an entry of the energy ledger.
    pub fn work(&self, work: Work) -> usize {
        5 * self.stride + (4 + work as usize) * self.members + self.member
    }

    /// Puts the balls of the padding somewhere: not at the centre, and no two in one place.
    pub(crate) fn spread_padding(&self, values: &mut [f64]) {
        for k in self.entries()..self.stride {
            let (sin, cos) = (k as f64).sin_cos();
            values[self.group(0) + k] = sin;
            values[self.group(1) + k] = -cos;
        }
    }

    /// One group of a vector, ball by ball.
    pub fn balls_of<'a>(&self, values: &'a [f64], group: usize) -> Balls<'a> {
        Balls {
            values: &values[group * self.stride + self.member..],
            step: self.members,
            count: self.balls,
        }
    }
}

/// One quantity of every ball of a bearing within a vector.
#[derive(Debug, Clone, Copy)]
pub struct Balls<'a> {
    values: &'a [f64],
    step: usize,
    count: usize,
}

impl<'a> Balls<'a> {
    /// N.
    #[allow(clippy::len_without_is_empty)] // never empty
    pub fn len(&self) -> usize {
        self.count
    }

    /// Ball by ball.
    pub fn iter(&self) -> impl Iterator<Item = f64> + use<'a> {
        self.values
            .iter()
            .step_by(self.step)
            .take(self.count)
            .copied()
    }
}

impl std::ops::Index<usize> for Balls<'_> {
    type Output = f64;

    fn index(&self, k: usize) -> &f64 {
        &self.values[k * self.step]
    }
}

/// Positions and velocities of balls and ring, and the energy ledger.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    layout: Layout,
    values: Vec<f64>,
}

impl State {
    /// Everything zero.
    pub fn new(balls: usize) -> Self {
        let layout = Layout::new(balls);
        let mut state = Self {
            layout,
            values: vec![0.0; layout.len()],
        };
        state.layout.spread_padding(&mut state.values);
        state
    }

    /// Takes the state of one bearing out of a vector that an integrator has advanced.
    pub fn taken(layout: Layout, values: &[f64]) -> Self {
        assert_eq!(values.len(), layout.len());
        Self::assembled(layout, |k| values[k])
    }

    /// Puts a state together from the places of one bearing in a vector.
    pub(crate) fn assembled(layout: Layout, value: impl Fn(usize) -> f64) -> Self {
        let own = Layout::new(layout.balls);
        let mut values = vec![0.0; own.len()];
        for group in 0..5 {
            for k in 0..layout.balls {
                values[own.ball(group, k)] = value(layout.ball(group, k));
            }
        }
        for k in 0..4 {
            values[own.ring(k)] = value(layout.ring(k));
        }
        for work in Work::ALL {
            values[own.work(work)] = value(layout.work(work));
        }
        let mut state = Self {
            layout: own,
            values,
        };
        state.layout.spread_padding(&mut state.values);
        state
    }

    /// Puts the state into the places of one bearing in a vector.
    pub fn put_into(&self, layout: Layout, values: &mut [f64]) {
        let own = self.layout;
        for group in 0..5 {
            for k in 0..own.balls {
                values[layout.ball(group, k)] = self.values[own.ball(group, k)];
            }
        }
        for k in 0..4 {
            values[layout.ring(k)] = self.values[own.ring(k)];
        }
        for work in Work::ALL {
            values[layout.work(work)] = self.values[own.work(work)];
        }
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
        std::array::from_fn(|k| self.values[self.layout.ring(k)])
    }

    /// Puts the ring.
    pub fn set_ring(&mut self, ring: [f64; 4]) {
        for (k, value) in ring.into_iter().enumerate() {
            self.values[self.layout.ring(k)] = value;
        }
    }

    /// One entry of the energy ledger, J.
    pub fn work_j(&self, work: Work) -> f64 {
        self.values[self.layout.work(work)]
    }
}
