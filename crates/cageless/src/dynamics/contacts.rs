//! What an evaluation of the right-hand side saw of one bearing.

use super::equations::Workspace;
use super::lanes::{Block, Entry};
use crate::case::Profile;
use crate::state::{LANES, Layout};

/// Contacts of one bearing as of the last evaluation; balls count from 0.
#[derive(Clone, Copy)]
pub struct Contacts<'a> {
    pub(super) work: &'a Workspace,
    pub(super) layout: Layout,
    pub(super) profile: Profile,
}

impl Contacts<'_> {
    /// N.
    pub fn balls(&self) -> usize {
        self.layout.balls
    }

    #[inline]
    fn at(&self, block: impl Fn(&Entry) -> &Block, k: usize) -> f64 {
        let entry = k * self.layout.members() + self.layout.member();
        block(&self.work.entries[entry / LANES]).0[entry % LANES]
    }

    /// Normal force at the inner raceway, N.
    pub fn inner_force_n(&self, k: usize) -> f64 {
        self.at(|e| &e.inner_force, k)
    }

    /// Normal force at the outer raceway, N.
    pub fn outer_force_n(&self, k: usize) -> f64 {
        self.at(|e| &e.outer_force, k)
    }

    /// ΔVi.
    pub fn inner_slip_m_s(&self, k: usize) -> f64 {
        self.at(|e| &e.inner_slip, k)
    }

    /// ΔVo.
    pub fn outer_slip_m_s(&self, k: usize) -> f64 {
        self.at(|e| &e.outer_slip, k)
    }

    /// δi; negative: apart.
    pub fn inner_deflection_m(&self, k: usize) -> f64 {
        self.at(|e| &e.inner_deflection, k)
    }

    /// δo; negative: apart.
    pub fn outer_deflection_m(&self, k: usize) -> f64 {
        self.at(|e| &e.outer_deflection, k)
    }

    /// r.
    pub fn effective_radius_m(&self, k: usize) -> f64 {
        self.at(|e| &e.radius, k)
    }

    /// Orbital speed vt/|rb|.
    pub fn orbit_speed_rad_s(&self, k: usize) -> f64 {
        self.at(|e| &e.orbit, k)
    }

    /// Absolute spin.
    pub fn spin_rad_s(&self, k: usize) -> f64 {
        self.at(|e| &e.absolute, k)
    }

    /// `paper` profile: whether ball `k` is inside a discrete raceway.
    pub(super) fn inside(&self, k: usize) -> bool {
        self.at(|e| &e.inside, k) > 0.0
    }

    /// δb between ball `k` and the ball ahead; negative: apart.
    pub fn pair_deflection_m(&self, k: usize) -> f64 {
        self.at(|e| &e.pair_deflection, k)
    }

    /// Rate of [`Self::pair_deflection_m`] while any two balls touch, else 0.
    pub fn pair_rate_m_s(&self, k: usize) -> f64 {
        self.at(|e| &e.pair_rate, k)
    }

    /// Normal force between ball `k` and the ball ahead, N.
    pub fn pair_force_n(&self, k: usize) -> f64 {
        self.at(|e| &e.pair_force, k)
    }

    /// Whether any two balls touch.
    pub fn balls_touch(&self) -> bool {
        self.work.pair_most[self.layout.member()] > 0.0
    }

    /// Largest |ΔVi| or |ΔVo| at contacts that carry load.
    pub fn slip_max_m_s(&self) -> f64 {
        self.work.slip_most[self.layout.member()]
    }

    /// What the balls put on the outer ring, friction included, N.
    pub fn outer_ring_force_n(&self) -> [f64; 2] {
        (0..self.balls()).fold([0.0; 2], |[x, y], k| {
            let at = |block: fn(&Entry) -> &Block| self.at(block, k);
            let (ex, ey) = (at(|e| &e.ex), at(|e| &e.ey));
            let (force, uphill) = (at(|e| &e.outer_force), at(|e| &e.uphill));
            let friction = at(|e| &e.outer_friction);
            let (dir_x, dir_y) = match self.profile {
                Profile::Paper => (at(|e| &e.dir_x), at(|e| &e.dir_y)),
                Profile::Physical => (-ey, ex),
            };
            [
                x + force * ex + uphill * ey + friction * dir_x,
                y + force * ey - uphill * ex + friction * dir_y,
            ]
        })
    }
}
