//! The contacts of one bearing as of the last evaluation of the right-hand side.

use super::layout::Layout;
use super::rotor::RotorContact;
use super::space::{BallContacts, FaceContact, SpaceWorkspace};
use crate::numerics::lanes::{Lanes, lane_maxima};
use crate::raceway_contact::RacewayPoint;
use crate::simd::Workspace;

/// Contacts of one bearing as of the last evaluation; balls count from 0.
#[derive(Clone, Copy)]
pub struct Contacts<'a> {
    pub(super) work: &'a Workspace,
    pub(super) space: Option<&'a SpaceWorkspace>,
    pub(super) layout: Layout,
}

/// Declares a view of one quantity of ball `k`.
macro_rules! per_ball {
    ($($(#[$meta:meta])* $name:ident: $($field:ident).+;)*) => {
        $($(#[$meta])*
        #[inline]
        pub fn $name(&self, k: usize) -> f64 {
            let (block, lane) = self.layout.place(k);
            let lanes: &Lanes = &self.work.blocks[block].$($field).+;
            lanes.0[lane]
        })*
    };
}

impl Contacts<'_> {
    /// N.
    #[inline]
    pub fn balls(&self) -> usize {
        self.layout.balls
    }

    per_ball! {
        /// Fi, normal force at the inner raceway, N.
        inner_force_n: inner.force;
        /// Fo, normal force at the outer raceway, N.
        outer_force_n: outer.force;
        /// Force along ψ where the outer contact of an unequal ball rises, N, along the motion.
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
        /// Rate of [`Self::pair_deflection_m`] while any two balls touch, else 0, m/s.
        pair_rate_m_s: pair.rate;
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
        let (block, lane) = self.layout.place(k);
        let polar = &self.work.blocks[block].polar;
        polar.ex.0[lane].atan2(-polar.ey.0[lane])
    }

    /// Whether any two balls touch.
    #[inline]
    pub fn balls_touch(&self) -> bool {
        self.work.pair_deflection_max[self.layout.bearing()] > 0.0
    }

    /// Largest |ΔVi| or |ΔVo| at contacts that carry load, m/s.
    #[inline]
    pub fn sliding_max_m_s(&self) -> f64 {
        lane_maxima(&self.work.slip_max, self.layout.width() == 1)[self.layout.bearing()]
    }

    /// Larger of |ΔVi| and |ΔVo| of ball `k` at contacts that carry load, m/s: one without may slide as
    /// it likes.
    #[inline]
    pub(crate) fn loaded_sliding_m_s(&self, k: usize) -> f64 {
        let (block, lane) = self.layout.place(k);
        let (inner, outer) = (
            &self.work.blocks[block].inner,
            &self.work.blocks[block].outer,
        );
        let loaded = |slip: &Lanes, force: &Lanes| match force.0[lane] > 0.0 {
            true => slip.0[lane].abs(),
            false => 0.0,
        };
        loaded(&inner.slip, &inner.force).max(loaded(&outer.slip, &outer.force))
    }

    /// Whether the inner raceway presses on ball `k`.
    #[inline]
    pub(crate) fn is_loaded(&self, k: usize) -> bool {
        let (block, lane) = self.layout.place(k);
        self.work.blocks[block].inner.force.0[lane] > 0.0
    }

    /// Whether any ball is pressed deeper than this into a raceway or the ball ahead.
    pub(crate) fn any_deeper(&self, limit_m: f64) -> bool {
        (0..self.balls()).fold(false, |any, k| {
            let (block, lane) = self.layout.place(k);
            let results = &self.work.blocks[block];
            let [outer, inner] = [&results.outer.deflection, &results.inner.deflection];
            let deep = |deflection: &Lanes| deflection.0[lane] > limit_m;
            any | deep(outer) | deep(inner) | deep(&results.pair.deflection)
        })
    }

    /// Where ball `k` bears on the inner raceway.
    pub fn inner_point(&self, k: usize) -> RacewayPoint {
        match self.in_space(k) {
            Some(ball) => ball.inner_point(),
            None => RacewayPoint {
                force_n: self.inner_force_n(k),
                cosine: 1.0,
            },
        }
    }

    /// Where ball `k`, of this radius, bears on the outer raceway; on a discrete raceway the more
    /// loaded of two points.
    pub fn outer_point(&self, k: usize, radius_m: f64) -> RacewayPoint {
        match self.in_space(k) {
            Some(ball) => ball.outer_point(),
            None => {
                let cosine = self.effective_radius_m(k) / radius_m;
                RacewayPoint::of_outer(cosine, self.outer_force_n(k))
            }
        }
    }

    /// Contacts of ball `k` in space; `None` in the plane.
    pub fn in_space(&self, k: usize) -> Option<BallContacts> {
        self.space.map(|space| space.contacts(k))
    }

    /// Contact of the rotor with the inner ring, if there is a rotor.
    pub fn rotor(&self) -> Option<RotorContact> {
        self.layout
            .has_rotor()
            .then(|| self.work.rotors[self.layout.bearing()])
    }

    /// Contact of a shoulder of the rotor with the inner ring, if there is a rotor in space.
    pub fn face(&self) -> Option<FaceContact> {
        let space = self.space.filter(|_| self.layout.has_rotor());
        space.map(|space| space.rotor.face)
    }

    /// Force of the inner ring on the rotor, friction included, N, if there is a rotor in space.
    pub(crate) fn rotor_force_n(&self) -> Option<[f64; 3]> {
        let space = self.space.filter(|_| self.layout.has_rotor());
        space.map(|space| space.rotor.loads.fixed_rows::<3>(0).into())
    }

    /// Axial force of the balls on the outer ring, friction included, N.
    pub fn outer_ring_axial_force_n(&self) -> f64 {
        self.space
            .map_or(0.0, |space| space.outer_ring_force_n()[2])
    }

    /// Axial force of the balls of a row, from 0, on its outer ring, friction included, N.
    pub fn row_axial_force_n(&self, row: usize) -> f64 {
        self.space
            .map_or(0.0, |space| space.row_force_n(self.layout, row))
    }

    /// Force of the balls on the outer ring along X and Y, friction included, N.
    pub fn outer_ring_force_n(&self) -> [f64; 2] {
        if let Some(space) = self.space {
            let [x, y, _] = space.outer_ring_force_n();
            return [x, y];
        }
        (0..self.balls()).fold([0.0; 2], |[x, y], k| {
            let (block, lane) = self.layout.place(k);
            let results = &self.work.blocks[block];
            let (polar, outer) = (results.polar.get(lane), results.outer.get(lane));
            let slope_force = results.slope_force.0[lane];
            let along_path = self.work.friction_directions.get(block);
            let [dx, dy] = along_path.map_or([-polar.ey, polar.ex], |d| [d.x.0[lane], d.y.0[lane]]);
            let friction = results.outer_friction.0[lane];
            // Along the radius friction at flanks adds to the normal force.
            let normal = match results.on_flanks.has(lane) {
                true => outer.force + results.across_friction.0[lane],
                false => outer.force,
            };
            [
                x + normal * polar.ex + slope_force * polar.ey + friction * dx,
                y + normal * polar.ey - slope_force * polar.ex + friction * dy,
            ]
        })
    }
}
