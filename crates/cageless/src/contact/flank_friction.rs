//! Friction at the two flanks of a discrete raceway, which slide along the groove and spin as well.
//!
//! Beside ΔVo, across the groove, a ball with dρ/dt slides along either flank by ∓sin α dρ/dt, and
//! its rotation ω has the part ±ω sin α normal to the flank: it spins there. One strip stands for the
//! ellipse of each flank (semi-axis a across the groove),
//!
//!   s² = ΔVo² + (sin α dρ/dt)²,   v₁² = vs² + (⅔ a ω sin α)²,
//!
//! vs the regularisation speed of the law: friction μ(s) tanh(s/v₁) N along −**s**, whose parts along
//! the groove leave μ N tanh(s/v₁)/s · sin² α dρ/dt along the radius, the others cancelling. Within the
//! strip spin leaves a moment. With the slope f′ of friction over s it is, of both flanks about the
//! bearing axis and against ω,
//!
//!   M = ¼ a² f′ sin² α ω/√(1 + (3 vs/(4 v₁))²):
//!
//! ⅜ μ N a sin α of fast spin, f′ the slope μN/v₁ of the strip, and μ N a² sin² α ω/(5 vs) of creep,
//! both those of the pressure of Hertz. Slip within the ellipse from its curvature (Heathcote) is
//! left out; it needs several strips.

use super::flanks::FlankContact;
use super::friction::{Law, Spinning};
use super::positive;
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Terms of the friction of a ball at its flanks beside ΔVo.
    pub(crate) struct FlankSliding per lane FlankSlidingLanes {
        /// (sin α dρ/dt)², (m/s)².
        along_square,
        /// 1/v₁, s/m.
        inverse_knee,
        /// (⅔ a ω sin α)², (m/s)².
        spin_square,
    }
}

impl FlankSliding {
    /// Sliding of a ball that moves outwards at `radial_m_s` and rotates at `rotation_rad_s`.
    #[inline(always)]
    pub(crate) fn new(
        law: &impl Law,
        flanks: &FlankContact,
        radial_m_s: f64,
        rotation_rad_s: f64,
    ) -> Self {
        let scale = law.inverse_regularisation_speed();
        let turning = (2.0 / 3.0) * rotation_rad_s;
        let spin = (2.0 / 3.0) * scale * rotation_rad_s;
        let widening = spin * spin * flanks.sine_square * flanks.axis_square;
        Self {
            along_square: flanks.sine_square * radial_m_s * radial_m_s,
            inverse_knee: scale / (1.0 + widening).sqrt(),
            spin_square: turning * turning * flanks.sine_square * flanks.axis_square,
        }
    }
}

/// Sliding speed over that of the knee below which friction is linear to 1e-10.
const LINEAR: f64 = 1e-5;

/// Law of friction over ΔVo at the flanks of a ball.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtFlanks<L> {
    /// Law of the contact.
    pub law: L,
    /// The rest of its sliding.
    pub sliding: FlankSliding,
}

impl<L: Law> AtFlanks<L> {
    /// Friction over s and its slope, N·s/m; ΔVo²/s².
    #[inline(always)]
    fn along_sliding(&self, slip_m_s: f64, normal_n: f64) -> [f64; 3] {
        let FlankSliding {
            along_square,
            inverse_knee,
            spin_square,
        } = self.sliding;
        let square = slip_m_s * slip_m_s;
        // Some speed far below any other keeps 0/0 out.
        let speed = (square + along_square + f64::MIN_POSITIVE).sqrt();
        let inverse = 1.0 / speed;
        let spinning = Spinning {
            inverse_knee_s_m: inverse_knee,
            spin_square,
        };
        let [force, slope] = self.law.spinning_force(speed, normal_n, &spinning);
        let linear = speed * inverse_knee < LINEAR;
        let secant = if linear { slope } else { force * inverse };
        [secant, slope, square * inverse * inverse]
    }

    /// Coefficients of the friction along the radius over dρ/dt, N·s/m, and of the moment of spin
    /// over ω, N·m·s.
    #[inline(always)]
    pub(crate) fn drag(&self, flanks: &FlankContact, slip_m_s: f64, normal_n: f64) -> [f64; 2] {
        let [secant, slope, _] = self.along_sliding(slip_m_s, normal_n);
        let knee = 0.75 * self.sliding.inverse_knee / self.law.inverse_regularisation_speed();
        let moment = 0.25 * flanks.axis_square * positive(slope) / (1.0 + knee * knee).sqrt();
        [secant * flanks.sine_square, moment * flanks.sine_square]
    }
}

impl<L: Law> Law for AtFlanks<L> {
    /// The part of the friction across the groove, with the knee of its own sliding.
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, _: f64) -> [f64; 2] {
        let [secant, slope, share] = self.along_sliding(sliding_m_s, normal_n);
        [secant * sliding_m_s, secant + (slope - secant) * share]
    }

    /// Friction at the flanks and at the inner raceway.
    #[inline(always)]
    fn forces_with_knees(
        &self,
        slips_m_s: [f64; 2],
        normals_n: [f64; 2],
        [outer, inner]: [f64; 2],
    ) -> [[f64; 2]; 2] {
        [
            self.force_with_knee(slips_m_s[0], normals_n[0], outer),
            (self.law).inner_force(slips_m_s[1], normals_n[1], inner),
        ]
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.law.coefficient()
    }

    #[inline(always)]
    fn inverse_regularisation_speed(&self) -> f64 {
        self.law.inverse_regularisation_speed()
    }

    #[inline(always)]
    fn inverse_knees(&self) -> [f64; 2] {
        self.law.inverse_knees()
    }

    #[inline(always)]
    fn inverse_scales(&self) -> [f64; 2] {
        self.law.inverse_scales()
    }
}
