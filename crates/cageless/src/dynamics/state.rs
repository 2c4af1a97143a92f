//! The state vector: what the integrators advance.
//!
//! ```
//! use cageless::initial_state;
//! use cageless::reference;
//!
//! let (state, angles_rad) = initial_state(&reference::conventional())?;
//! assert_eq!(state.x_m().len(), angles_rad.len());
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use super::coordinates::BallCoordinate;
use super::energy::EnergyTerm;
use super::layout::Layout;
use crate::ball::{BallMotion, Centre};
#[cfg(test)]
use crate::world::body::RingCoordinate;
use crate::world::body::{BodyCoordinate, RotorMotion, SlidingCoordinate};

/// State of one bearing: the motion of balls and bodies, and the energy ledger.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    layout: Layout,
    values: Vec<f64>,
}

impl State {
    /// The state of a bearing without a rotor in which everything is zero.
    #[cfg(test)]
    pub(crate) fn new(balls: usize) -> Self {
        Self::zero(Layout::new(balls))
    }

    /// The state of a bearing of this layout, alone in its vector, in which everything is zero.
    pub fn zero(layout: Layout) -> Self {
        let layout = layout.alone();
        let mut state = Self {
            layout,
            values: vec![0.0; layout.len()],
        };
        state.layout.spread_padding(&mut state.values);
        state
    }

    /// The state of one bearing in a vector that an integrator has advanced.
    pub(crate) fn from_vector(layout: Layout, values: &[f64]) -> Self {
        if layout.width() == 1 {
            let of_bearing = values[layout.start()..layout.end()].iter();
            let of_rotor = layout.rotor_places().map(|place| &values[place]);
            let mut values: Vec<f64> = of_bearing.chain(of_rotor).copied().collect();
            let layout = layout.alone();
            layout.spread_padding(&mut values);
            return Self { layout, values };
        }
        let mut state = Self::zero(layout);
        for (own, place) in state.layout.pairs(layout) {
            state.values[own] = values[place];
        }
        state
    }

    /// Writes the state to the places of one bearing in a vector.
    pub(crate) fn write_to(&self, layout: Layout, values: &mut [f64]) {
        for (own, place) in self.layout.pairs(layout) {
            values[place] = self.values[own];
        }
    }

    /// The state with nothing in its energy ledger: that of a start.
    pub fn without_ledger(mut self) -> Self {
        for term in self.layout.energy_terms() {
            self.values[self.layout.energy_term(*term)] = 0.0;
        }
        self
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

    fn array(&self, coordinate: BallCoordinate) -> &[f64] {
        &self.values[self.layout.array(coordinate)..][..self.layout.balls]
    }

    /// x of every ball, m.
    pub fn x_m(&self) -> &[f64] {
        self.array(BallCoordinate::X)
    }

    /// y of every ball, m.
    pub fn y_m(&self) -> &[f64] {
        self.array(BallCoordinate::Y)
    }

    /// Velocity along x of every ball, m/s.
    pub(crate) fn vx_m_s(&self) -> &[f64] {
        self.array(BallCoordinate::Vx)
    }

    /// Velocity along y of every ball, m/s.
    pub(crate) fn vy_m_s(&self) -> &[f64] {
        self.array(BallCoordinate::Vy)
    }

    /// Spin state of every ball, rad/s, clockwise positive: absolute in the `physical`
    /// formulation, relative to the orbit in `paper` (Zhao 2022, Eq. (13)).
    #[cfg(test)]
    pub(crate) fn spin_state_rad_s(&self) -> &[f64] {
        self.array(BallCoordinate::Spin)
    }

    /// Motion of ball `k`.
    pub(crate) fn ball_motion(&self, k: usize) -> BallMotion {
        self.layout.ball_motion(&self.values, k)
    }

    /// Sets the motion of ball `k`.
    pub(crate) fn set_ball(&mut self, k: usize, ball: BallMotion) {
        for (coordinate, value) in [
            (BallCoordinate::X, ball.x),
            (BallCoordinate::Y, ball.y),
            (BallCoordinate::Vx, ball.vx),
            (BallCoordinate::Vy, ball.vy),
            (BallCoordinate::Spin, ball.spin),
        ] {
            self.values[self.layout.ball(coordinate, k)] = value;
        }
    }

    /// Sets z and ωx, ωy of a ball, unless they are held.
    pub(crate) fn set_ball_in_space(&mut self, k: usize, z_m: f64, omega_rad_s: [f64; 2]) {
        for (coordinate, value) in [
            (BallCoordinate::Z, z_m),
            (BallCoordinate::OmegaX, omega_rad_s[0]),
            (BallCoordinate::OmegaY, omega_rad_s[1]),
        ] {
            if self.layout.ball_moves(coordinate) {
                self.values[self.layout.ball(coordinate, k)] = value;
            }
        }
    }

    /// Value of a coordinate of a body; 0 where it is held.
    pub(crate) fn at(&self, coordinate: impl Into<BodyCoordinate>) -> f64 {
        self.layout.at(&self.values, coordinate)
    }

    /// Sets a coordinate of a body, unless it is held.
    pub(crate) fn set(&mut self, coordinate: impl Into<BodyCoordinate>, value: f64) {
        self.layout.set(&mut self.values, coordinate, value);
    }

    /// Motion of the centre of the inner ring.
    pub(crate) fn ring_motion(&self) -> Centre {
        self.layout.ring_motion(&self.values)
    }

    /// Sets the motion of the centre of the inner ring.
    #[cfg(test)]
    pub(crate) fn set_ring(&mut self, ring: Centre) {
        for (coordinate, value) in [
            (RingCoordinate::X, ring.x),
            (RingCoordinate::Y, ring.y),
            (RingCoordinate::Vx, ring.vx),
            (RingCoordinate::Vy, ring.vy),
        ] {
            self.values[self.layout.ring(coordinate)] = value;
        }
    }

    /// Motion of the centre of the outer ring; fixed at the origin without a rotor.
    pub(crate) fn outer_ring_motion(&self) -> Centre {
        self.layout.outer_ring_motion(&self.values)
    }

    /// Motion of the rotor, if there is one.
    pub(crate) fn rotor_motion(&self) -> Option<RotorMotion> {
        self.layout.rotor_motion(&self.values)
    }

    /// Angular velocity of the rotor, rad/s, if there is one.
    pub fn rotor_speed_rad_s(&self) -> Option<f64> {
        Some(self.rotor_motion()?.speed)
    }

    /// Sets z of ring `k` of the outer rings that slide.
    pub(crate) fn set_sliding(&mut self, k: usize, z_m: f64) {
        self.values[self.layout.sliding(SlidingCoordinate::Z, k)] = z_m;
    }

    /// ωi of the inner ring, rad/s, where it is a state: under a rotor.
    pub(crate) fn ring_speed_rad_s(&self) -> Option<f64> {
        self.layout.ring_speed_rad_s(&self.values)
    }

    /// One term of the energy ledger, J; 0 for those of a rotor without one.
    pub fn energy_term_j(&self, term: EnergyTerm) -> f64 {
        if self.layout.energy_terms().contains(&term) {
            self.values[self.layout.energy_term(term)]
        } else {
            0.0
        }
    }

    /// Work of the friction of balls at the raceways and against each other, J.
    pub fn friction_j(&self) -> f64 {
        [
            EnergyTerm::InnerFriction,
            EnergyTerm::OuterFriction,
            EnergyTerm::BallFriction,
        ]
        .map(|term| self.energy_term_j(term))
        .iter()
        .sum()
    }
}
