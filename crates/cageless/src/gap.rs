//! Gaps between neighbouring balls.

use std::f64::consts::TAU;

use crate::dynamics::Model;
use crate::dynamics::layout::Balls;
use crate::numerics::lane_set::LaneSet;
use crate::numerics::lanes::{LANES, Lanes};
use crate::numerics::vector::PlaneVector;
use crate::simd::{InstructionSet, with_instructions};

/// An angle from 0 to 2π by its sine and cosine, both times the same length: two can be
/// compared without angle functions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Direction {
    sine: f64,
    cosine: f64,
}

impl Direction {
    /// Direction from ball `k` to the ball ahead, forwards, about the centre of the outer ring.
    #[inline]
    pub(crate) fn to_next(
        balls_m: PlaneVector<Balls<'_>>,
        centre_m: PlaneVector,
        k: usize,
    ) -> Self {
        let PlaneVector { x, y } = balls_m;
        let about = |k: usize| PlaneVector { x: x[k], y: y[k] }.from(centre_m);
        Self::between(about(k), about(x.next(k)))
    }

    /// Direction from one place to the next, forwards, about the origin.
    #[inline]
    pub(crate) fn between(place: PlaneVector, next: PlaneVector) -> Self {
        Self {
            sine: place.x * next.y - place.y * next.x,
            cosine: place.x * next.x + place.y * next.y,
        }
    }

    /// Direction of an angle.
    pub(crate) fn of(angle_rad: f64) -> Self {
        let (sine, cosine) = angle_rad.sin_cos();
        Self { sine, cosine }
    }

    /// The angle from another direction on, rad, if its tangent is at most 0.2: 11 terms of its series, of which the
    /// next is below 1e-17.
    #[inline]
    pub(crate) fn small_angle_from(self, other: Self) -> Option<f64> {
        let across = self.sine * other.cosine - self.cosine * other.sine;
        let along = self.cosine * other.cosine + self.sine * other.sine;
        let tangent = across / along;
        let series = (0..11).rev().fold(0.0, |rest, k| {
            1.0 / f64::from(2 * k + 1) - tangent * tangent * rest
        });
        (along > 0.0 && tangent.abs() <= 0.2).then_some(tangent * series)
    }

    /// Whether the angle is the smaller one.
    #[inline]
    pub(crate) fn below(self, other: Self) -> bool {
        let (beyond, other_beyond) = (self.sine < 0.0, other.sine < 0.0);
        if beyond != other_beyond {
            return other_beyond;
        }
        // Within half a turn the sign of sin(a − b) orders a and b.
        self.sine * other.cosine < self.cosine * other.sine
    }

    /// The angle, less `pair_angle_rad`, that of two balls that touch
    /// ([`Model::pair_angle_rad`]).
    pub(crate) fn gap_rad(self, pair_angle_rad: f64) -> f64 {
        let angle = self.sine.atan2(self.cosine);
        (if angle < 0.0 { angle + TAU } else { angle }) - pair_angle_rad
    }
}

/// Smallest and largest gap that was seen between each pair of neighbours.
#[derive(Debug, Clone, Default)]
pub(crate) struct GapRange {
    pair_angles: Vec<f64>,
    blocks: Vec<RangeBlock>,
}

/// Smallest and largest angles of the pairs of a block; sines and cosines are 0 before the first look.
#[derive(Debug, Clone)]
struct RangeBlock {
    /// Pairs whose ball ahead does not have the next index.
    apart: LaneSet,
    /// Sines and cosines of smallest and largest.
    range: [[Lanes; 2]; 2],
}

impl RangeBlock {
    fn get(&self, end: usize, lane: usize) -> Direction {
        let [sine, cosine] = self.range[end].each_ref().map(|part| part.0[lane]);
        Direction { sine, cosine }
    }

    fn take(&mut self, now: Direction, lane: usize) {
        let [least, most] = [0, 1].map(|end| self.get(end, lane));
        let first = most == Direction::default();
        for (end, taken) in [now.below(least), most.below(now)].into_iter().enumerate() {
            if taken || first {
                let [sine, cosine] = &mut self.range[end];
                (sine.0[lane], cosine.0[lane]) = (now.sine, now.cosine);
            }
        }
    }

    /// Pairs that may be outside their range: all but those of angles below half a turn, in between.
    #[inline(always)]
    fn outside(
        &self,
        place: PlaneVector<&[f64; LANES]>,
        next: PlaneVector<&[f64; LANES]>,
        centre: PlaneVector,
    ) -> LaneSet {
        let [least, most] = &self.range;
        LaneSet::of(|lane| {
            let about = |at: PlaneVector<&[f64; LANES]>| {
                let (x, y) = (at.x[lane], at.y[lane]);
                PlaneVector { x, y }.from(centre)
            };
            let Direction { sine, cosine } = Direction::between(about(place), about(next));
            let within = (sine > 0.0)
                & (most[0].0[lane] > 0.0)
                & (least[0].0[lane] * cosine <= least[1].0[lane] * sine)
                & (sine * most[1].0[lane] <= cosine * most[0].0[lane]);
            !within
        })
    }
}

impl GapRange {
    /// Gap range of the balls of a model.
    pub(crate) fn new(model: &Model) -> Self {
        let (balls, layout) = (model.balls(), model.layout());
        let block = |first: usize| RangeBlock {
            apart: LaneSet::of(|lane| layout.next(first + lane) != first + lane + 1),
            range: [[Lanes::ZERO; 2]; 2],
        };
        Self {
            pair_angles: (0..balls).map(|k| model.pair_angle_rad(k)).collect(),
            blocks: (0..balls).step_by(LANES).map(block).collect(),
        }
    }

    /// Takes the positions of the balls and of the centre of the outer ring.
    pub(crate) fn look(&mut self, balls_m: PlaneVector<Balls<'_>>, centre_m: PlaneVector) {
        let isa = InstructionSet::chosen();
        for (first, block) in (0..).step_by(LANES).zip(&mut self.blocks) {
            let pairs = match (balls_m.x.blocks_at(first), balls_m.y.blocks_at(first)) {
                (Some([x, next_x]), Some([y, next_y])) => {
                    let (place, next) = (
                        PlaneVector { x, y },
                        PlaneVector {
                            x: next_x,
                            y: next_y,
                        },
                    );
                    with_instructions!(
                        isa,
                        [](block: &RangeBlock, place: PlaneVector<&[f64; LANES]>, next: PlaneVector<&[f64; LANES]>,
                            centre_m: PlaneVector) -> LaneSet,
                        block.outside(place, next, centre_m)
                    )
                    .or(block.apart)
                }
                _ => LaneSet::ALL,
            };
            for lane in pairs.of_bearing(0, true, self.pair_angles.len() - first) {
                block.take(Direction::to_next(balls_m, centre_m, first + lane), lane);
            }
        }
    }

    /// Smallest and largest gap of all, rad; infinite before the first look.
    pub(crate) fn range_rad(&self) -> [f64; 2] {
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for (k, &pair) in self.pair_angles.iter().enumerate() {
            let (block, lane) = (&self.blocks[k / LANES], k % LANES);
            let [least, most] = [0, 1].map(|end| block.get(end, lane));
            if most != Direction::default() {
                range[0] = range[0].min(least.gap_rad(pair));
                range[1] = range[1].max(most.gap_rad(pair));
            }
        }
        range
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::coordinates::BallCoordinate;
    use crate::dynamics::layout::Layout;

    /// The series has the angle between directions of any length up to a tangent of 0.2, and none beyond.
    #[test]
    fn small_angles_are_those_of_the_series() {
        let far = |angle_rad: f64, length: f64| Direction {
            sine: length * angle_rad.sin(),
            cosine: length * angle_rad.cos(),
        };
        for (pitch_rad, k) in [0.449, 3.1]
            .into_iter()
            .flat_map(|p| (-9..10).map(move |k| (p, k)))
        {
            let (small, pitch) = (0.02 * f64::from(k), Direction::of(pitch_rad));
            let found = far(pitch_rad + small, 5e-4).small_angle_from(pitch);
            assert!((found.unwrap() - small).abs() < 1e-15, "{found:?} {small}");
        }
        for large in [-0.2, 0.2, 1.5, std::f64::consts::PI, 4.0] {
            assert_eq!(
                far(1.0 + large, 2.0).small_angle_from(Direction::of(1.0)),
                None
            );
        }
    }

    /// The pair across the end of a row is looked at by itself: in vectors its ball ahead is whatever comes next.
    #[test]
    fn the_last_ball_is_behind_the_first() {
        let layout = Layout::new(3);
        let mut values = vec![0.0; layout.len()];
        let mut range = GapRange {
            pair_angles: vec![0.0; 3],
            blocks: vec![RangeBlock {
                apart: LaneSet::of(|lane| layout.next(lane) != lane + 1),
                range: [[Lanes::ZERO; 2]; 2],
            }],
        };
        let mut gaps = |angles_rad: [f64; 4]| {
            for (k, (sin, cos)) in angles_rad.map(f64::sin_cos).into_iter().enumerate() {
                values[layout.array(BallCoordinate::X) + k] = cos;
                values[layout.array(BallCoordinate::Y) + k] = sin;
            }
            let of = |coordinate| layout.balls_of(&values, coordinate);
            let (x, y) = (of(BallCoordinate::X), of(BallCoordinate::Y));
            range.look(PlaneVector { x, y }, PlaneVector::default());
            range.range_rad()
        };
        // What comes after the third ball is always 2.1 rad ahead.
        for (first_rad, seen) in [
            (0.0, [2.0, TAU - 4.1]),
            (-0.2, [TAU - 4.3, 2.2]),
            (0.5, [1.5, TAU - 3.6]),
        ] {
            let found = gaps([first_rad, 2.0, 4.1, 6.2]);
            for (found, seen) in found.into_iter().zip(seen) {
                assert!((found - seen).abs() < 1e-12, "{found} {seen}");
            }
        }
    }
}
