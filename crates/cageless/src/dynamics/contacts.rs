//! The contacts of one bearing as of the last evaluation of the right-hand side.

use super::space::{BallContacts, SpaceWorkspace};
use crate::ball::BallLanes;
use crate::contact::published::FrictionDirectionLanes;
use crate::numerics::lane_set::LaneSet;
use crate::numerics::lanes::{LANES, Lanes, lane_maxima, larger};
use crate::raceway_contact::RacewayPoint;
use crate::simd::{BlockResults, InstructionSet, Parameters, Workspace, with_instructions};
use crate::world::joint::TouchLoads;
use crate::world::joint::journal::RotorContact;
use crate::world::joint::rotor_touch::RotorTouch;
use crate::world::joint::shoulder::FaceContact;
use crate::world::under_rotor::UnderRotor;

/// Contacts of one bearing as of the last evaluation; balls count from 0.
#[derive(Clone, Copy)]
pub(crate) struct Contacts<'a> {
    pub(super) parameters: &'a Parameters,
    pub(super) work: &'a Workspace,
    pub(super) space: Option<&'a SpaceWorkspace>,
    pub(super) isa: InstructionSet,
    pub(super) bearing: usize,
}

/// A ball on the raceways.
pub(crate) struct Rolling {
    /// Larger of |ΔVi| and |ΔVo| at contacts that carry load, m/s: one without may slide as it likes.
    pub loaded_sliding_m_s: f64,
    /// Whether the inner raceway presses on the ball.
    pub is_loaded: bool,
    /// Orbital speed, rad/s.
    pub orbit_speed_rad_s: f64,
}

/// Declares a view of one quantity of ball `k`.
macro_rules! per_ball {
    ($($(#[$meta:meta])* $name:ident: $($field:ident).+;)*) => {
        $($(#[$meta])*
        #[inline]
        pub(crate) fn $name(&self, k: usize) -> f64 {
            let (block, lane) = self.place(k);
            let lanes: &Lanes = &self.work.blocks[block].$($field).+;
            lanes.0[lane]
        })*
    };
}

impl Contacts<'_> {
    /// N.
    #[inline]
    pub(crate) fn balls(&self) -> usize {
        self.parameters.layout.balls
    }

    /// Block and lane of ball `k`.
    #[inline]
    fn place(&self, k: usize) -> (usize, usize) {
        let entry = k * self.parameters.layout.width() + self.bearing;
        (entry / LANES, entry % LANES)
    }

    /// Passes on the balls of this bearing for which a test of their constants and results in a lane holds.
    #[inline]
    pub(crate) fn balls_where<T>(&self, test: &T, mut found: impl FnMut(usize))
    where
        T: Fn(&BallLanes, &BlockResults, usize) -> bool,
    {
        let p = self.parameters;
        let (width, entries) = (p.layout.width(), p.layout.entries());
        for (block, results) in self.work.blocks.iter().enumerate() {
            let (balls, first) = (p.balls(block), block * LANES);
            let lanes = with_instructions!(
                self.isa,
                [T: Fn(&BallLanes, &BlockResults, usize) -> bool](test: &T, balls: &BallLanes, results: &BlockResults) -> LaneSet,
                LaneSet::of(|lane| test(balls, results, lane))
            );
            for lane in lanes.of_bearing(self.bearing, width == 1, entries - first) {
                found((first + lane) / width);
            }
        }
    }

    per_ball! {
        /// Fi, normal force at the inner raceway, N.
        inner_force_n: inner.force;
        /// Fo, normal force at the outer raceway, N.
        outer_force_n: outer.force;
        /// Force along ψ where the outer contact of an unequal ball rises, N, along the motion.
        #[cfg(test)]
        outer_slope_force_n: slope_force;
        /// ΔVi, m/s.
        inner_sliding_m_s: inner.slip;
        /// ΔVo, m/s.
        outer_sliding_m_s: outer.slip;
        /// δi, m; negative: apart.
        inner_deflection_m: inner.deflection;
        /// δo, m; negative: apart.
        outer_deflection_m: outer.deflection;
        /// r, effective contact radius at the outer raceway, m.
        effective_radius_m: geometry.effective_radius;
        /// Orbital speed vt/|rb|, rad/s.
        orbit_speed_rad_s: polar.orbit;
        /// Absolute spin, rad/s.
        rotation_rad_s: spin;
        /// δb between ball `k` and the ball ahead, m; once all balls are apart no longer kept up to
        /// date, but not above 0.
        pair_deflection_m: pair.deflection;
        /// Normal force between ball `k` and the ball ahead, N.
        pair_force_n: pair.force;
        /// Sliding speed between ball `k` and the ball ahead while they touch, m/s.
        pair_sliding_m_s: pair.slip;
        /// Friction force at the inner raceway, N; positive where the ring drives the ball.
        inner_friction_n: inner_friction;
        /// Friction force at the outer raceway, N; positive where it slows the ball.
        outer_friction_n: outer_friction;
    }

    /// ψ of ball `k`.
    pub(crate) fn angle_rad(&self, k: usize) -> f64 {
        let (block, lane) = self.place(k);
        let polar = &self.work.blocks[block].polar;
        polar.ex.0[lane].atan2(-polar.ey.0[lane])
    }

    /// Whether any two balls touch.
    #[inline]
    pub(crate) fn balls_touch(&self) -> bool {
        self.work.pair_deflection_max[self.bearing] > 0.0
    }

    /// Largest |ΔVi| or |ΔVo| at contacts that carry load, m/s.
    #[inline(always)]
    pub(crate) fn sliding_max_m_s(&self) -> f64 {
        match self.parameters.layout.width() {
            1 => lane_maxima(&self.work.slip_max, true)[0],
            _ => lane_maxima(&self.work.slip_max, false)[self.bearing],
        }
    }

    /// Ball `k` on the raceways.
    #[inline]
    pub(crate) fn rolling(&self, k: usize) -> Rolling {
        let (block, lane) = self.place(k);
        let results = &self.work.blocks[block];
        let [inner_n, outer_n] = [results.inner.force.0[lane], results.outer.force.0[lane]];
        let loaded = |slip: &Lanes, force_n: f64| match force_n > 0.0 {
            true => slip.0[lane].abs(),
            false => 0.0,
        };
        let outer_m_s = loaded(&results.outer.slip, outer_n);
        Rolling {
            loaded_sliding_m_s: larger(loaded(&results.inner.slip, inner_n), outer_m_s),
            is_loaded: inner_n > 0.0,
            orbit_speed_rad_s: results.polar.orbit.0[lane],
        }
    }

    /// A ball pressed deeper than this into a raceway or the ball ahead.
    pub(crate) fn deeper(&self, limit_m: f64) -> Option<usize> {
        let is_deeper = |_: &BallLanes, results: &BlockResults, lane: usize| {
            let (outer, inner) = (&results.outer.deflection, &results.inner.deflection);
            let deep = |deflection: &Lanes| deflection.0[lane] > limit_m;
            deep(outer) | deep(inner) | deep(&results.pair.deflection)
        };
        let mut first = None;
        self.balls_where(&is_deeper, |k| first = first.or(Some(k)));
        first
    }

    /// Where ball `k` bears on the inner raceway.
    #[inline]
    pub(crate) fn inner_point(&self, k: usize) -> RacewayPoint {
        match self.in_space(k) {
            Some(ball) => ball.inner_point(),
            None => RacewayPoint {
                force_n: self.inner_force_n(k),
                cosine: 1.0,
            },
        }
    }

    /// R of ball `k`, m.
    #[inline]
    pub(crate) fn radius_m(&self, k: usize) -> f64 {
        let (block, lane) = self.place(k);
        self.parameters.balls(block).radius.0[lane]
    }

    /// Where ball `k` bears on the outer raceway; on a discrete raceway the more loaded of two points.
    #[inline]
    pub(crate) fn outer_point(&self, k: usize) -> RacewayPoint {
        match self.in_space(k) {
            Some(ball) => ball.outer_point(),
            None => {
                let cosine = self.effective_radius_m(k) / self.radius_m(k);
                RacewayPoint::of_outer(cosine, self.outer_force_n(k))
            }
        }
    }

    /// Whether the balls move in space.
    #[inline]
    pub(crate) fn are_in_space(&self) -> bool {
        self.space.is_some()
    }

    /// Contacts of ball `k` in space; `None` in the plane.
    #[inline]
    pub(crate) fn in_space(&self, k: usize) -> Option<BallContacts> {
        self.space.map(|space| space.contacts(k))
    }

    /// Contacts of the balls in space, with their numbers; none in the plane.
    pub(crate) fn balls_in_space(&self) -> impl Iterator<Item = (usize, BallContacts)> {
        let balls = self.balls();
        let space = self.space.into_iter();
        space.flat_map(move |space| (0..balls).map(move |k| (k, space.contacts(k))))
    }

    /// ωi, rad/s, counter-clockwise.
    pub(crate) fn inner_ring_speed_rad_s(&self) -> f64 {
        let (inner, lane) = (&self.parameters.inner, self.bearing);
        inner.surface_speed.0[lane] / inner.radius.0[lane]
    }

    /// The bodies under a rotor, if there is one.
    fn under_rotor(&self) -> Option<&UnderRotor> {
        self.parameters.drops.get(self.bearing)
    }

    /// Contact of the rotor with the inner ring, if there is a rotor.
    pub(crate) fn rotor(&self) -> Option<RotorContact> {
        let under = self.under_rotor();
        under.map(|_| self.work.rotors[self.bearing])
    }

    /// Loads of the inner ring on the rotor, friction included, if there is a rotor.
    pub(crate) fn loads_on_rotor(&self) -> Option<TouchLoads> {
        let (under, contact) = (self.under_rotor()?, self.rotor()?);
        Some(match self.space {
            Some(space) => space.rotor.loads(&contact),
            None => under
                .joint
                .loads(&contact, contact.contact.force, contact.friction),
        })
    }

    /// Contacts and friction of a rotor in space on the inner ring; `None` without one.
    fn rotor_in_space(&self) -> Option<&RotorTouch> {
        self.under_rotor().and(self.space).map(|space| &space.rotor)
    }

    /// Contact of a shoulder of the rotor with the inner ring, if there is a rotor in space.
    pub(crate) fn face(&self) -> Option<FaceContact> {
        self.rotor_in_space().map(|rotor| rotor.face)
    }

    /// Axial force of the balls on the outer ring, friction included, N.
    pub(crate) fn outer_ring_axial_force_n(&self) -> f64 {
        self.space
            .map_or(0.0, |space| space.outer_ring_force_n()[2])
    }

    /// Axial force of the balls of a row, from 0, on its outer ring, friction included, N.
    pub(crate) fn row_axial_force_n(&self, row: usize) -> f64 {
        self.space
            .map_or(0.0, |space| space.row_force_n(self.parameters.layout, row))
    }

    /// Force of the balls on the outer ring along X and Y, friction included, N.
    pub(crate) fn outer_ring_force_n(&self) -> [f64; 2] {
        if let Some(space) = self.space {
            let [x, y, _] = space.outer_ring_force_n();
            return [x, y];
        }
        let (work, width, bearing) = (self.work, self.parameters.layout.width(), self.bearing);
        with_instructions!(
            self.isa,
            [](work: &Workspace, width: usize, bearing: usize) -> [f64; 2],
            outer_ring_force_n(work, width, bearing)
        )
    }
}

/// Number of partial sums, to which the balls add in turn: the same bits whether a bearing is alone or beside
/// others.
const PARTS: usize = 4;

/// Force of the balls of one of `width` bearings on the outer ring along X and Y, N.
#[inline(always)]
fn outer_ring_force_n(work: &Workspace, width: usize, bearing: usize) -> [f64; 2] {
    let [mut x, mut y] = [[0.0; PARTS]; 2];
    for (block, results) in work.blocks.iter().enumerate() {
        let direction = work.friction_directions.get(block);
        // Each with forces of its own, or all go through memory.
        if width == 1 {
            let [force_x, force_y] = outer_forces(results, direction);
            // Padding adds nothing.
            for (sums, force) in [(&mut x, &force_x), (&mut y, &force_y)] {
                for ball in (0..LANES).step_by(PARTS) {
                    for part in 0..PARTS {
                        sums[part] += force[ball + part];
                    }
                }
            }
        } else {
            for lane in (bearing..LANES).step_by(width) {
                let part = (block * LANES + lane) / width % PARTS;
                let [force_x, force_y] = outer_force(results, direction, lane);
                x[part] += force_x;
                y[part] += force_y;
            }
        }
    }
    [(x[0] + x[2]) + (x[1] + x[3]), (y[0] + y[2]) + (y[1] + y[3])]
}

/// [`outer_force`] of all balls of a block.
#[inline(always)]
fn outer_forces(
    results: &BlockResults,
    direction: Option<&FrictionDirectionLanes>,
) -> [[f64; LANES]; 2] {
    let [mut x, mut y] = [[0.0; LANES]; 2];
    for lane in 0..LANES {
        [x[lane], y[lane]] = outer_force(results, direction, lane);
    }
    [x, y]
}

/// Force of a ball of a block on the outer ring along X and Y: normal force, that along ψ where the contact rises, and
/// friction, along the circumference unless in a given direction, N.
#[inline(always)]
fn outer_force(
    results: &BlockResults,
    direction: Option<&FrictionDirectionLanes>,
    lane: usize,
) -> [f64; 2] {
    let (ex, ey) = (results.polar.ex.0[lane], results.polar.ey.0[lane]);
    let (slope, friction) = (results.slope_force.0[lane], results.outer_friction.0[lane]);
    // Along the radius friction at flanks adds to the normal force.
    let across = match results.on_flanks.has(lane) {
        true => results.across_friction.0[lane],
        false => 0.0,
    };
    let normal = results.outer.force.0[lane] + across;
    let [dx, dy] = direction.map_or([-ey, ex], |d| [d.x.0[lane], d.y.0[lane]]);
    [
        normal * ex + slope * ey + friction * dx,
        normal * ey - slope * ex + friction * dy,
    ]
}
