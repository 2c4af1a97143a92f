//! Places of the coordinates in the vector that the integrators advance.
//!
//! ```
//! use cageless::dynamics::coordinates::BallCoordinate;
//! use cageless::dynamics::layout::Layout;
//!
//! let layout = Layout::new(14);
//! // The ball after the first stands next to it.
//! let [first, second] = [0, 1].map(|k| layout.ball(BallCoordinate::X, k));
//! assert_eq!(second, first + 1);
//! ```

use super::ball::{BallMotion, Centre};
use super::coordinates::{
    BALL, BALL_IN_SPACE, BallCoordinate, Coordinate, DROP, DROP_IN_SPACE, DropCoordinate, RING,
    RING_IN_SPACE, RingCoordinate, SLIDING, SlidingCoordinate, second_order_runs,
};
use super::energy::EnergyTerm;
use super::rotor::RotorMotion;
use crate::case::Case;
use crate::integrator::SecondOrderBlock;
use crate::numerics::lanes::{BATCH_WIDTH, LANES, Lanes};
use crate::simd::{InstructionSet, with_instructions};

/// Places of the coordinates in the flat vector that an integrator advances: of one bearing,
/// or of [`BATCH_WIDTH`] bearings side by side, whose entries for the same ball lie next to each
/// other.
///
/// First the coordinates of the balls ([`BALL`]), an array each, padded to a multiple of
/// [`LANES`], so that whole vectors are computed either way; then those of the bodies
/// ([`RING`], with a rotor [`DROP`]); then the terms of the energy ledger ([`EnergyTerm`]). In space
/// it is [`BALL_IN_SPACE`], [`RING_IN_SPACE`] and [`DROP_IN_SPACE`], and after the bodies those of the outer
/// rings that slide ([`SLIDING`]), an array each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// N, of all rows.
    pub balls: usize,
    /// Balls of a row.
    pub(crate) row: usize,
    /// Length of one array over the balls.
    pub stride: usize,
    /// Coordinates of a ball.
    of_ball: &'static [Coordinate],
    /// Coordinates of the bodies.
    bodies: &'static [Coordinate],
    /// Outer rings that slide.
    sliding: usize,
    /// Bearings side by side.
    width: usize,
    /// The one whose places are given.
    bearing: usize,
    /// First place, in a vector that holds more than these bearings.
    start: usize,
    /// Places from there to the coordinates of the bodies and to the energy ledger.
    parts: [usize; 2],
}

impl Layout {
    /// Layout of the bearing of a case, alone in its vector.
    pub fn of_case(case: &Case) -> Self {
        let in_space = case.moves_in_space();
        let of_ball: &[Coordinate] = if in_space { &BALL_IN_SPACE } else { &BALL };
        let bodies: &[Coordinate] = match (in_space, case.rotor.is_some()) {
            (false, false) => &RING,
            (false, true) => &DROP,
            (true, false) => &RING_IN_SPACE,
            (true, true) => &DROP_IN_SPACE,
        };
        let of_row = case.bearing.balls();
        let sliding = case.sprung_rows().len();
        Self::with_bodies([case.balls(), of_row], [of_ball, bodies], sliding, 1)
    }

    /// Layout for one bearing of `balls` balls.
    pub fn new(balls: usize) -> Self {
        Self::with_bodies([balls; 2], [&BALL, &RING], 0, 1)
    }

    /// Layout for [`BATCH_WIDTH`] such bearings side by side, with the places of the first.
    pub(crate) fn side_by_side(self) -> Self {
        self.of_width(BATCH_WIDTH)
    }

    /// Layout for one such bearing alone.
    pub(crate) fn alone(self) -> Self {
        self.of_width(1)
    }

    fn of_width(self, width: usize) -> Self {
        let tables = [self.of_ball, self.bodies];
        Self::with_bodies([self.balls, self.row], tables, self.sliding, width)
    }

    fn with_bodies(
        [balls, row]: [usize; 2],
        [of_ball, bodies]: [&'static [Coordinate]; 2],
        sliding: usize,
        width: usize,
    ) -> Self {
        let stride = (balls * width).next_multiple_of(LANES);
        let of_balls = of_ball.len() * stride;
        let of_bodies = (bodies.len() + SLIDING.len() * sliding) * width;
        Self {
            balls,
            row,
            stride,
            of_ball,
            bodies,
            sliding,
            width,
            bearing: 0,
            start: 0,
            parts: [of_balls, of_balls + of_bodies],
        }
    }

    /// Whether there are a rotor, an inner ring whose speed is a state, and an outer ring on a
    /// support.
    #[inline]
    pub fn has_rotor(&self) -> bool {
        self.bodies.len() >= DROP.len()
    }

    /// Whether balls and ring move in space.
    #[inline]
    pub(crate) fn is_in_space(&self) -> bool {
        self.of_ball.len() > BALL.len()
    }

    /// Terms of the energy ledger.
    pub fn energy_terms(&self) -> &'static [EnergyTerm] {
        if self.has_rotor() {
            &EnergyTerm::ALL
        } else {
            EnergyTerm::without_rotor()
        }
    }

    /// Layout of this vector with the places of bearing number `bearing`.
    pub fn of_bearing(self, bearing: usize) -> Self {
        assert!(bearing < self.width);
        Self { bearing, ..self }
    }

    /// Layout of this vector as a part, from `start` on, of one that holds other bodies as well.
    pub fn at(self, start: usize) -> Self {
        Self { start, ..self }
    }

    /// First place.
    pub(crate) fn start(&self) -> usize {
        self.start
    }

    /// Bearings side by side.
    #[inline]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Index of the bearing whose places are given.
    #[inline]
    pub fn bearing(&self) -> usize {
        self.bearing
    }

    /// Length of the vector, or of this part of it.
    #[allow(clippy::len_without_is_empty)] // never empty
    pub fn len(&self) -> usize {
        self.motion_len() + self.energy_terms().len() * self.width
    }

    /// Length of the motion of one bearing alone, which precedes its energy ledger.
    pub(crate) fn motion_len(&self) -> usize {
        self.parts[1]
    }

    /// Entries of an array over the balls that are not padding.
    pub(crate) fn entries(&self) -> usize {
        self.balls * self.width
    }

    /// Index of ball `k` in an array over the balls.
    #[inline]
    pub(crate) fn entry(&self, k: usize) -> usize {
        k * self.width + self.bearing
    }

    /// Start of the array of one coordinate of all balls and bearings.
    #[inline]
    pub fn array(&self, coordinate: BallCoordinate) -> usize {
        self.start + coordinate as usize * self.stride
    }

    /// Place of a coordinate of ball `k`.
    #[inline]
    pub fn ball(&self, coordinate: BallCoordinate, k: usize) -> usize {
        self.of_table(coordinate as usize, k)
    }

    /// Place of a coordinate of ball `k` by its index in their table.
    #[inline]
    fn of_table(&self, coordinate: usize, k: usize) -> usize {
        debug_assert!(k < self.balls && coordinate < self.of_ball.len());
        self.start + coordinate * self.stride + self.entry(k)
    }

    /// Place of a coordinate of the inner ring.
    #[inline]
    pub fn ring(&self, coordinate: RingCoordinate) -> usize {
        self.body(coordinate as usize)
    }

    /// Place of a coordinate of the bodies under a rotor.
    #[inline]
    pub fn drop(&self, coordinate: DropCoordinate) -> usize {
        debug_assert!(self.has_rotor());
        let more = if self.is_in_space() {
            RING_IN_SPACE.len() - RING.len()
        } else {
            0
        };
        self.body(coordinate as usize + more)
    }

    /// Place of a coordinate of the bodies by its index in their table.
    #[inline]
    fn body(&self, index: usize) -> usize {
        self.start + self.parts[0] + index * self.width + self.bearing
    }

    /// Coordinates of the bodies, those of outer rings that slide included.
    fn body_coordinates(&self) -> usize {
        self.bodies.len() + SLIDING.len() * self.sliding
    }

    /// Place of a coordinate of ring `k` of the outer rings that slide.
    #[inline]
    pub fn sliding(&self, coordinate: SlidingCoordinate, k: usize) -> usize {
        debug_assert!(k < self.sliding);
        self.body(self.bodies.len() + coordinate as usize * self.sliding + k)
    }

    /// Place of a term of the energy ledger.
    #[inline]
    pub fn energy_term(&self, term: EnergyTerm) -> usize {
        self.start + self.parts[1] + term as usize * self.width + self.bearing
    }

    /// Gives the balls of the padding distinct positions away from the centre.
    pub(crate) fn spread_padding(&self, values: &mut [f64]) {
        for k in self.entries()..self.stride {
            let (sin, cos) = (k as f64).sin_cos();
            values[self.array(BallCoordinate::X) + k] = sin;
            values[self.array(BallCoordinate::Y) + k] = -cos;
        }
    }

    /// The ball ahead of ball `k` in its row.
    #[inline]
    pub fn next(&self, k: usize) -> usize {
        next_in_row(k, self.row)
    }

    /// Motion of ball `k` in a vector.
    pub(crate) fn ball_motion(&self, values: &[f64], k: usize) -> BallMotion {
        let at = |coordinate| values[self.ball(coordinate, k)];
        BallMotion {
            x: at(BallCoordinate::X),
            y: at(BallCoordinate::Y),
            vx: at(BallCoordinate::Vx),
            vy: at(BallCoordinate::Vy),
            spin: at(BallCoordinate::Spin),
        }
    }

    /// Motion of the centre of the inner ring in a vector.
    #[inline(always)] // into callers compiled for wider vectors
    pub fn ring_motion(&self, values: &[f64]) -> Centre {
        let at = |coordinate| values[self.ring(coordinate)];
        Centre {
            x: at(RingCoordinate::X),
            y: at(RingCoordinate::Y),
            vx: at(RingCoordinate::Vx),
            vy: at(RingCoordinate::Vy),
        }
    }

    /// Motion of the centre of the outer ring in a vector; fixed at the origin without a rotor.
    #[inline(always)] // into callers compiled for wider vectors
    pub fn outer_ring_motion(&self, values: &[f64]) -> Centre {
        if !self.has_rotor() {
            return Centre::default();
        }
        let at = |coordinate| values[self.drop(coordinate)];
        Centre {
            x: at(DropCoordinate::OuterX),
            y: at(DropCoordinate::OuterY),
            vx: at(DropCoordinate::OuterVx),
            vy: at(DropCoordinate::OuterVy),
        }
    }

    /// z and ż of the outer ring in a vector; 0 in the plane, and without a rotor.
    #[inline(always)] // into callers compiled for wider vectors
    pub fn outer_ring_along_axis(&self, values: &[f64]) -> [f64; 2] {
        if !(self.has_rotor() && self.is_in_space()) {
            return [0.0; 2];
        }
        [DropCoordinate::OuterZ, DropCoordinate::OuterVz].map(|c| values[self.drop(c)])
    }

    /// Motion of the rotor in a vector, if there is one.
    #[inline(always)] // into callers compiled for wider vectors
    pub fn rotor_motion(&self, values: &[f64]) -> Option<RotorMotion> {
        if !self.has_rotor() {
            return None;
        }
        let at = |coordinate| values[self.drop(coordinate)];
        Some(RotorMotion {
            x: at(DropCoordinate::RotorX),
            y: at(DropCoordinate::RotorY),
            vx: at(DropCoordinate::RotorVx),
            vy: at(DropCoordinate::RotorVy),
            angle: at(DropCoordinate::RotorAngle),
            speed: at(DropCoordinate::RotorSpeed),
        })
    }

    /// ωi of the inner ring in a vector, rad/s, where it is a state: under a rotor.
    #[inline]
    pub fn ring_speed_rad_s(&self, values: &[f64]) -> Option<f64> {
        self.has_rotor()
            .then(|| values[self.drop(DropCoordinate::RingSpeed)])
    }

    /// One coordinate of the balls of this bearing in a vector.
    #[inline]
    pub fn balls_of<'a>(&self, values: &'a [f64], coordinate: BallCoordinate) -> Balls<'a> {
        Balls {
            values: &values[self.array(coordinate) + self.bearing..],
            step: self.width,
            count: self.balls,
            row: self.row,
        }
    }

    /// Positions and their rates, for methods of second-order systems; in ascending order of
    /// the positions.
    pub(crate) fn second_order_blocks(&self) -> Vec<SecondOrderBlock> {
        let block =
            |[position, rate, count]: [usize; 3], start: usize, size: usize| SecondOrderBlock {
                positions: start + position * size,
                rates: start + rate * size,
                count: count * size,
            };
        let balls = second_order_runs(self.of_ball).into_iter();
        let bodies = second_order_runs(self.bodies).into_iter();
        balls
            .map(|run| block(run, self.start, self.stride))
            .chain(bodies.map(|run| block(run, self.start + self.parts[0], self.width)))
            .chain((self.sliding > 0).then(|| SecondOrderBlock {
                positions: self.sliding(SlidingCoordinate::Z, 0) - self.bearing,
                rates: self.sliding(SlidingCoordinate::Vz, 0) - self.bearing,
                count: self.sliding * self.width,
            }))
            .collect()
    }

    /// Places and coordinates of this bearing's motion, without the energy ledger.
    fn motion(&self) -> impl Iterator<Item = (usize, &'static Coordinate)> + use<> {
        let layout = *self;
        let balls = self
            .of_ball
            .iter()
            .enumerate()
            .flat_map(move |(i, c)| (0..layout.balls).map(move |k| (layout.of_table(i, k), c)));
        let sliding = SLIDING
            .iter()
            .flat_map(move |c| std::iter::repeat_n(c, layout.sliding));
        let bodies = self.bodies.iter().chain(sliding).enumerate();
        balls.chain(bodies.map(move |(k, c)| (layout.body(k), c)))
    }

    /// Whether every coordinate of this bearing is finite.
    pub(crate) fn is_finite(&self, values: &[f64]) -> bool {
        // In any array each place of a bearing is `width` behind the last.
        let own = &values[self.start..][..self.motion_len()];
        if self.width == 1 {
            return with_instructions!(
                InstructionSet::chosen(),
                [](own: &[f64]) -> bool,
                own.iter().fold(true, |finite, v| finite & v.is_finite())
            );
        }
        let mut own = own.iter().skip(self.bearing).step_by(self.width);
        own.all(|v| v.is_finite())
    }

    /// Root mean square over the coordinates of this bearing of a difference of two vectors in
    /// the error scales of the coordinates.
    pub(crate) fn scaled_rms(&self, difference: &[f64]) -> f64 {
        let sum: f64 = self
            .motion()
            .map(|(place, c)| (difference[place] / c.error_scale).powi(2))
            .sum();
        let count = self.of_ball.len() * self.balls + self.body_coordinates();
        (sum / count as f64).sqrt()
    }

    /// Every place of this bearing with the place of the same quantity in `other`.
    pub(super) fn pairs(&self, other: Self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let layout = *self;
        let balls = (0..self.of_ball.len()).flat_map(move |c| {
            (0..layout.balls).map(move |k| (layout.of_table(c, k), other.of_table(c, k)))
        });
        let rest = 0..self.body_coordinates() + self.energy_terms().len();
        balls.chain(rest.map(move |k| (layout.body(k), other.body(k))))
    }
}

/// One quantity of every ball of a bearing within a vector.
#[derive(Debug, Clone, Copy)]
pub struct Balls<'a> {
    values: &'a [f64],
    step: usize,
    count: usize,
    row: usize,
}

/// The ball ahead of ball `k`, which for the last of a row is its first.
#[inline]
fn next_in_row(k: usize, row: usize) -> usize {
    // Rows are few: sooner counted than divided by.
    let mut end = row;
    while end <= k {
        end += row;
    }
    if k + 1 == end { end - row } else { k + 1 }
}

impl<'a> Balls<'a> {
    /// N.
    #[allow(clippy::len_without_is_empty)] // never empty
    #[inline]
    pub fn len(&self) -> usize {
        self.count
    }

    /// The ball ahead of ball `k` in its row.
    #[inline]
    pub fn next(&self, k: usize) -> usize {
        next_in_row(k, self.row)
    }

    /// The ball behind ball `k` in its row.
    #[inline]
    pub(crate) fn previous(&self, k: usize) -> usize {
        match k.is_multiple_of(self.row) {
            true => k + self.row - 1,
            false => k - 1,
        }
    }

    /// A block of values from ball `k` on, and one from the next on; `None` if other bearings are in between.
    #[inline]
    pub(crate) fn blocks_at(&self, k: usize) -> Option<[&'a [f64; LANES]; 2]> {
        let (own, next) = (self.values.get(k..)?, self.values.get(k + 1..)?);
        let blocks = [own.first_chunk()?, next.first_chunk()?];
        (self.step == 1).then_some(blocks)
    }

    /// Copies a block of values from ball `first` on; beyond the last ball of any value.
    #[inline]
    pub(crate) fn copy_block(&self, first: usize, block: &mut Lanes) {
        match self.values[first..].first_chunk() {
            Some(values) if self.step == 1 => block.0 = *values,
            _ => {
                for k in first..self.count.min(first + LANES) {
                    block.0[k - first] = self[k];
                }
            }
        }
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

    #[inline]
    fn index(&self, k: usize) -> &f64 {
        &self.values[k * self.step]
    }
}
