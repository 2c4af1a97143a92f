//! Places of the coordinates in the vector that the integrators advance.
//!
//! ```
//! use cageless::dynamics::{Layout, RingCoordinate};
//! use cageless::reference;
//!
//! let layout = Layout::of_case(&reference::conventional());
//! // The inner ring stands behind five coordinates of all balls.
//! assert_eq!(layout.ring(RingCoordinate::X), 5 * layout.stride);
//! ```

use super::coordinates::{
    BALL, BALL_IN_SPACE, BallCoordinate, Coordinate, Kind, Pair, Run, runs, second_order_pairs,
};
use super::energy::EnergyTerm;
use crate::ball::{AxialMotion, BallMotion, Centre};
use crate::case::Case;
use crate::integrator::SecondOrderBlock;
use crate::numerics::lanes::{BATCH_WIDTH, LANES, Lanes};
use crate::simd::{InstructionSet, with_instructions};
use crate::world::body::{
    BodyCoordinate, BodyKind, Freedoms, LONGEST, OuterRingCoordinate, RingCoordinate,
    RotorCoordinate, RotorMotion, SlidingCoordinate,
    rotor::{self, ROTOR},
    sliding_ring,
};

/// Places of the coordinates in the flat vector that an integrator advances: of one bearing,
/// or of [`BATCH_WIDTH`] bearings side by side, whose entries for the same ball lie next to each
/// other.
///
/// First the coordinates of the balls (`BALL`, in space `BALL_IN_SPACE`), an array each, padded to a
/// multiple of `LANES`, so that whole vectors are computed either way; then those that move of each
/// ring and those of the outer rings that slide, an array each; then the terms of
/// the energy ledger ([`EnergyTerm`]). A rotor stands behind its bearings, with a ledger of its own.
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
    /// Place of each coordinate of each ring among those of both; [`HELD`] where it does not move.
    bodies: [[u8; LONGEST]; BodyKind::RINGS.len()],
    /// Places of the rotor at this bearing, of the first of those side by side.
    rotor: [u32; ROTOR],
    /// Coordinates of the rings that move.
    moving: usize,
    /// Outer rings that slide.
    sliding: usize,
    /// Freedoms of the bodies.
    freedoms: Freedoms,
    /// Bearings side by side.
    width: usize,
    /// The one whose places are given.
    bearing: usize,
    /// First place, in a vector that holds more than these bearings.
    start: usize,
    /// Places from there to the coordinates of the bodies and to the energy ledger.
    parts: [usize; 2],
}

/// Place of a coordinate that is held.
const HELD: u8 = u8::MAX;

/// Contents of a bearing in the state vector: its balls, sliding rings and freedoms.
#[derive(Clone, Copy)]
struct Contents {
    balls: usize,
    row: usize,
    sliding: usize,
    freedoms: Freedoms,
}

impl Layout {
    /// Layout of the bearing of a case, alone in its vector.
    pub fn of_case(case: &Case) -> Self {
        let contents = Contents {
            balls: case.balls(),
            row: case.bearing.balls(),
            sliding: case.sprung_rows().len(),
            freedoms: Freedoms {
                in_space: case.moves_in_space(),
                under_rotor: case.rotor.is_some(),
            },
        };
        Self::with(contents, 1)
    }

    /// Layout for one bearing of `balls` balls.
    #[cfg(test)]
    pub(crate) fn new(balls: usize) -> Self {
        let contents = Contents {
            balls,
            row: balls,
            sliding: 0,
            freedoms: Freedoms {
                in_space: false,
                under_rotor: false,
            },
        };
        Self::with(contents, 1)
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
        let contents = Contents {
            balls: self.balls,
            row: self.row,
            sliding: self.sliding,
            freedoms: self.freedoms,
        };
        Self::with(contents, width)
    }

    fn with(contents: Contents, width: usize) -> Self {
        let Contents {
            balls,
            row,
            sliding,
            freedoms,
        } = contents;
        let of_ball: &[Coordinate] = match freedoms.in_space {
            true => &BALL_IN_SPACE,
            false => &BALL,
        };
        let (mut bodies, mut moving) = ([[HELD; LONGEST]; BodyKind::RINGS.len()], 0);
        for body in BodyKind::RINGS {
            let places = bodies[body as usize].iter_mut();
            for (place, row) in places.zip(body.table()) {
                if row.freedom.moves(freedoms) {
                    (*place, moving) = (moving, moving + 1);
                }
            }
        }
        let moving = usize::from(moving);
        let stride = (balls * width).next_multiple_of(LANES);
        let of_balls = of_ball.len() * stride;
        let of_bodies = (moving + sliding_ring::TABLE.len() * sliding) * width;
        let layout = Self {
            balls,
            row,
            stride,
            of_ball,
            bodies,
            rotor: [0; ROTOR],
            moving,
            sliding,
            freedoms,
            width,
            bearing: 0,
            start: 0,
            parts: [of_balls, of_balls + of_bodies],
        };
        layout.below(std::array::from_fn(|k| layout.end() + k * width))
    }

    /// Layout below a rotor with these places at the first bearing.
    pub(crate) fn below(self, rotor: [usize; ROTOR]) -> Self {
        let rotor = rotor.map(|place| u32::try_from(place).expect("a vector of few numbers"));
        Self { rotor, ..self }
    }

    /// Freedoms of the bodies.
    #[inline]
    pub(crate) fn freedoms(&self) -> Freedoms {
        self.freedoms
    }

    /// Terms of the energy ledger.
    pub fn energy_terms(&self) -> &'static [EnergyTerm] {
        match self.freedoms.under_rotor {
            true => &EnergyTerm::ALL,
            false => EnergyTerm::without_rotor(),
        }
    }

    /// Layout of this vector with the places of bearing number `bearing`.
    pub(crate) fn of_bearing(self, bearing: usize) -> Self {
        assert!(bearing < self.width);
        Self { bearing, ..self }
    }

    /// Layout of these bearings from `start` on in a vector that holds more.
    pub(crate) fn starting_at(self, start: usize) -> Self {
        Self { start, ..self }
    }

    /// First place.
    pub(crate) fn start(&self) -> usize {
        self.start
    }

    /// Bearings side by side.
    #[inline]
    pub(crate) fn width(&self) -> usize {
        self.width
    }

    /// First place behind these bearings.
    #[inline]
    pub(crate) fn end(&self) -> usize {
        self.start + self.motion_len() + self.energy_terms().len() * self.width
    }

    /// Length of the vector of these bearings alone, with the motion of a rotor behind them.
    #[allow(clippy::len_without_is_empty)] // never empty
    pub fn len(&self) -> usize {
        let rotor = usize::from(self.freedoms.under_rotor) * ROTOR;
        self.end() - self.start + rotor * self.width
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
    pub(crate) fn array(&self, coordinate: BallCoordinate) -> usize {
        self.start + coordinate as usize * self.stride
    }

    /// Place of a coordinate of ball `k`.
    #[inline]
    pub(crate) fn ball(&self, coordinate: BallCoordinate, k: usize) -> usize {
        self.of_table(coordinate as usize, k)
    }

    /// Place of a coordinate of ball `k` by its index in their table.
    #[inline]
    fn of_table(&self, coordinate: usize, k: usize) -> usize {
        debug_assert!(k < self.balls && coordinate < self.of_ball.len());
        self.start + coordinate * self.stride + self.entry(k)
    }

    /// Whether a coordinate of the balls moves.
    #[inline]
    pub(crate) fn ball_moves(&self, coordinate: BallCoordinate) -> bool {
        (coordinate as usize) < self.of_ball.len()
    }

    /// Value of a coordinate of ball `k` in a vector; 0 where it is held.
    #[inline]
    pub(crate) fn ball_at(&self, values: &[f64], coordinate: BallCoordinate, k: usize) -> f64 {
        match self.ball_moves(coordinate) {
            true => values[self.ball(coordinate, k)],
            false => 0.0,
        }
    }

    /// Place of a coordinate of the inner ring.
    #[inline]
    pub fn ring(&self, coordinate: RingCoordinate) -> usize {
        self.body(coordinate)
    }

    /// Place of a coordinate of a body; it must move.
    #[inline]
    pub(crate) fn body(&self, coordinate: impl Into<BodyCoordinate>) -> usize {
        let BodyCoordinate { body, index } = coordinate.into();
        if body == BodyKind::Rotor {
            return self.rotor[index] as usize + self.bearing;
        }
        let place = self.bodies[body as usize][index];
        debug_assert!(place != HELD);
        self.of_bodies(usize::from(place))
    }

    /// Whether a coordinate of a body moves.
    #[inline]
    pub(crate) fn moves(&self, coordinate: impl Into<BodyCoordinate>) -> bool {
        let BodyCoordinate { body, index } = coordinate.into();
        match body {
            BodyKind::Rotor => rotor::TABLE[index].moves(self.freedoms),
            _ => self.bodies[body as usize][index] != HELD,
        }
    }

    /// Value of a coordinate of a body in a vector; 0 where it is held.
    #[inline]
    pub(crate) fn at(&self, values: &[f64], coordinate: impl Into<BodyCoordinate>) -> f64 {
        let coordinate = coordinate.into();
        match self.moves(coordinate) {
            true => values[self.body(coordinate)],
            false => 0.0,
        }
    }

    /// Sets a coordinate of a body in a vector, unless it is held.
    #[inline]
    pub(crate) fn set(
        &self,
        values: &mut [f64],
        coordinate: impl Into<BodyCoordinate>,
        value: f64,
    ) {
        let coordinate = coordinate.into();
        if self.moves(coordinate) {
            values[self.body(coordinate)] = value;
        }
    }

    /// Place of a coordinate of the rings by its number among those that move.
    #[inline]
    fn of_bodies(&self, index: usize) -> usize {
        self.start + self.parts[0] + index * self.width + self.bearing
    }

    /// Coordinates of the rings, those of outer rings that slide included.
    fn ring_coordinates(&self) -> usize {
        self.moving + sliding_ring::TABLE.len() * self.sliding
    }

    /// Place of a coordinate of ring `k` of the outer rings that slide.
    #[inline]
    pub(crate) fn sliding(&self, coordinate: SlidingCoordinate, k: usize) -> usize {
        debug_assert!(k < self.sliding);
        self.of_bodies(self.moving + coordinate as usize * self.sliding + k)
    }

    /// Place of a term of the energy ledger.
    #[inline]
    pub(crate) fn energy_term(&self, term: EnergyTerm) -> usize {
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
    pub(crate) fn next(&self, k: usize) -> usize {
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
    pub(crate) fn ring_motion(&self, values: &[f64]) -> Centre {
        let at = |coordinate: RingCoordinate| values[self.ring(coordinate)];
        Centre {
            x: at(RingCoordinate::X),
            y: at(RingCoordinate::Y),
            vx: at(RingCoordinate::Vx),
            vy: at(RingCoordinate::Vy),
        }
    }

    /// Motion of the centre of the outer ring in a vector; fixed at the origin without a rotor.
    #[inline(always)] // into callers compiled for wider vectors
    pub(crate) fn outer_ring_motion(&self, values: &[f64]) -> Centre {
        if !self.moves(OuterRingCoordinate::X) {
            return Centre::default();
        }
        let at = |coordinate: OuterRingCoordinate| values[self.body(coordinate)];
        Centre {
            x: at(OuterRingCoordinate::X),
            y: at(OuterRingCoordinate::Y),
            vx: at(OuterRingCoordinate::Vx),
            vy: at(OuterRingCoordinate::Vy),
        }
    }

    /// Motion of the outer ring along the axis in a vector; 0 in the plane, and without a rotor.
    #[inline(always)] // into callers compiled for wider vectors
    pub(crate) fn outer_ring_along_axis(&self, values: &[f64]) -> AxialMotion {
        AxialMotion {
            z: self.at(values, OuterRingCoordinate::Z),
            vz: self.at(values, OuterRingCoordinate::Vz),
        }
    }

    /// Motion of the rotor in a vector, if there is one.
    #[inline(always)] // into callers compiled for wider vectors
    pub(crate) fn rotor_motion(&self, values: &[f64]) -> Option<RotorMotion> {
        // Those that are held in the plane stand there as 0.
        let at = |coordinate: RotorCoordinate| {
            values[self.rotor[coordinate as usize] as usize + self.bearing]
        };
        (self.freedoms.under_rotor).then(|| RotorMotion::new(at))
    }

    /// ωi of the inner ring in a vector, rad/s, where it is a state: under a rotor.
    #[inline]
    pub(crate) fn ring_speed_rad_s(&self, values: &[f64]) -> Option<f64> {
        self.moves(RingCoordinate::Speed)
            .then(|| values[self.body(RingCoordinate::Speed)])
    }

    /// One coordinate of the balls of this bearing in a vector.
    #[inline]
    pub(crate) fn balls_of<'a>(&self, values: &'a [f64], coordinate: BallCoordinate) -> Balls<'a> {
        Balls {
            values: &values[self.array(coordinate) + self.bearing..],
            step: self.width,
            count: self.balls,
            row: self.row,
        }
    }

    /// Positions and their rates of these bearings, for methods of second-order systems; in ascending order of
    /// the positions.
    pub(crate) fn second_order_blocks(&self) -> Vec<SecondOrderBlock> {
        let block = |run: Run, start: usize, size: usize| SecondOrderBlock {
            positions: start + run.position * size,
            rates: start + run.rate * size,
            count: run.count * size,
        };
        let balls = runs(second_order_pairs(self.of_ball)).into_iter();
        let of_bodies = BodyKind::RINGS.into_iter().flat_map(|body| {
            let places = self.bodies[body as usize].map(usize::from);
            let rows = body.table().iter().zip(places);
            let moving = rows.filter(|(_, place)| *place != usize::from(HELD));
            moving.filter_map(move |(row, rate)| match row.coordinate.kind {
                Kind::VelocityOf(position) => Some(Pair {
                    position: places[position],
                    rate,
                }),
                Kind::Position | Kind::Rate => None,
            })
        });
        let bodies = runs(of_bodies).into_iter();
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
        let sliding = sliding_ring::TABLE
            .iter()
            .flat_map(move |c| std::iter::repeat_n(c, layout.sliding));
        let rings = BodyKind::RINGS.into_iter().flat_map(move |body| {
            let rows = body.table().iter().zip(layout.bodies[body as usize]);
            let moving = rows.filter(|(_, place)| *place != HELD);
            moving.map(|(row, _)| &row.coordinate)
        });
        let rings = rings.chain(sliding).enumerate();
        let rotor = rotor::TABLE.iter().zip(layout.rotor_places());
        let rotor = rotor.filter(move |(row, _)| row.moves(layout.freedoms));
        balls
            .chain(rings.map(move |(k, c)| (layout.of_bodies(k), c)))
            .chain(rotor.map(|(row, place)| (place, &row.coordinate)))
    }

    /// Places of all coordinates of the rotor at this bearing, if there is one.
    pub(super) fn rotor_places(&self) -> impl Iterator<Item = usize> + use<> {
        let (places, bearing) = (self.rotor.into_iter(), self.bearing);
        let there = self.freedoms.under_rotor;
        places
            .filter(move |_| there)
            .map(move |place| place as usize + bearing)
    }

    /// Whether every coordinate of this bearing is finite.
    pub(crate) fn is_finite(&self, values: &[f64]) -> bool {
        if !self.rotor_places().all(|place| values[place].is_finite()) {
            return false;
        }
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
        let squares = self
            .motion()
            .map(|(place, c)| (difference[place] / c.error_scale).powi(2));
        let (sum, count) = squares.fold((0.0, 0), |(sum, count), square| (sum + square, count + 1));
        (sum / f64::from(count)).sqrt()
    }

    /// Every place of this bearing with the place of the same quantity in `other`.
    pub(super) fn pairs(&self, other: Self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let layout = *self;
        let balls = (0..self.of_ball.len()).flat_map(move |c| {
            (0..layout.balls).map(move |k| (layout.of_table(c, k), other.of_table(c, k)))
        });
        let rest = 0..self.ring_coordinates() + self.energy_terms().len();
        balls
            .chain(rest.map(move |k| (layout.of_bodies(k), other.of_bodies(k))))
            .chain(self.rotor_places().zip(other.rotor_places()))
    }
}

/// One quantity of every ball of a bearing within a vector.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balls<'a> {
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
    /// The ball ahead of ball `k` in its row.
    #[inline]
    pub(crate) fn next(&self, k: usize) -> usize {
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
}

impl std::ops::Index<usize> for Balls<'_> {
    type Output = f64;

    #[inline]
    fn index(&self, k: usize) -> &f64 {
        &self.values[k * self.step]
    }
}
