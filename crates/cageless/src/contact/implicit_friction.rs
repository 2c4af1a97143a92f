//! Friction of the two raceway contacts of a ball at the end of a step, solved implicitly.
//!
//! Over a step h the friction forces f = (fo, fi) change the sliding speeds of a ball from
//! those that all other forces lead to, s = s_free − H·f(s), with H = h·A and A the mobility of
//! the ball at its two contacts. For a ball in plane contact (`physical`, e the angle between
//! the tangents at both contacts)
//!
//!   A = [ 1/m + r²/J,  r·R/J − cos e/m;  r·R/J − cos e/m,  1/m + R²/J ].
//!
//! Smooth laws are solved by Newton's method, Coulomb's law exactly.

use super::{
    Friction, InnerContact, InnerRaceway, OuterContact, OuterGeometry, OuterRaceway,
    friction_force, inner_slip, outer_friction_direction, outer_slip,
};
use crate::case::{FrictionLaw, Profile};
use crate::dynamics::ball::{Ball, BallMotion, PolarMotion};
use crate::simd::lanes::lane_struct;

lane_struct! {
    /// The implicit equations s = s_free − H·f(s) of one ball.
    pub struct SlipProblem per lane SlipProblemLanes {
        /// ΔVo at the end of the step without friction, m/s.
        outer_free,
        /// ΔVi at the end of the step without friction, m/s.
        inner_free,
        /// H of ΔVo to fo, m/(s·N).
        outer_outer,
        /// H of ΔVo to fi.
        outer_inner,
        /// H of ΔVi to fo.
        inner_outer,
        /// H of ΔVi to fi.
        inner_inner,
        /// Normal force that outer friction acts under, N.
        outer_normal,
        /// Normal force that inner friction acts under, N.
        inner_normal,
    }
}

lane_struct! {
    /// Sliding speeds of one ball and the friction that belongs to them.
    pub struct Slips per lane SlipsLanes {
        /// ΔVo, m/s.
        outer,
        /// ΔVi, m/s.
        inner,
        /// fo, N.
        outer_friction,
        /// fi, N.
        inner_friction,
        /// 1 once the equations hold to the tolerance, else 0.
        converged,
    }
}

/// Newton step at which the iteration ends, as a fraction of the slip scale. The friction is then
/// linear over the step to within half the square of this fraction times μN, and the end of the
/// step satisfies the linear equations exactly.
const LAST_STEP: f64 = 0.05;

/// Largest number of iterations; from anywhere some ten suffice.
pub const MAX_ITERATIONS: u32 = 30;

/// The two contacts of a ball with the raceways and what they slide against.
#[derive(Debug, Clone, Copy)]
pub struct RacewayContacts<'a> {
    /// The ball.
    pub ball: &'a Ball,
    /// The outer raceway.
    pub outer_raceway: &'a OuterRaceway,
    /// The inner raceway.
    pub inner_raceway: &'a InnerRaceway,
    /// Geometry of the outer contact.
    pub geometry: &'a OuterGeometry,
    /// The outer contact.
    pub outer: &'a OuterContact,
    /// The inner contact.
    pub inner: &'a InnerContact,
}

impl SlipProblem {
    /// The equations of a ball over a step of `h_s`; `motion`, `polar` and `inner_polar` hold
    /// the velocities that all forces but friction lead to.
    ///
    /// With Δv = h/m·(fi·ti − fo·do), Δω = h/J·(r·fo + R·fi), do the direction of outer
    /// friction, to and ti the tangents at both contacts, ΔVo = co·vt − r·ω and
    /// ΔVi = ωi·Ri − (ci·vt,i + R·ω), where co = ci = 1 in `physical`, co = (r + Rm)/|rb| and
    /// ci = Ri/|rb − ri| in `paper`.
    #[inline(always)]
    pub fn new(
        profile: Profile,
        contacts: &RacewayContacts<'_>,
        motion: &BallMotion,
        polar: &PolarMotion,
        inner_polar: &PolarMotion,
        h_s: f64,
    ) -> Self {
        let (ball, geometry) = (contacts.ball, contacts.geometry);
        let (r, radius) = (geometry.effective_radius, ball.radius);
        let [dx, dy] = outer_friction_direction(profile, geometry, polar);
        let (co, ci) = match profile {
            Profile::Paper => (
                (r + contacts.outer_raceway.pitch_radius) / polar.distance,
                contacts.inner_raceway.radius / inner_polar.distance,
            ),
            Profile::Physical => (1.0, 1.0),
        };
        let tangents = polar.ey * inner_polar.ey + polar.ex * inner_polar.ex;
        let outer_on_outer = polar.ex * dy - polar.ey * dx;
        let outer_on_inner = inner_polar.ex * dy - inner_polar.ey * dx;
        let (mass, inertia) = (h_s * ball.inverse_mass, h_s * ball.inverse_inertia);
        Self {
            outer_free: outer_slip(profile, contacts.outer_raceway, geometry, motion, polar),
            inner_free: inner_slip(profile, ball, contacts.inner_raceway, motion, inner_polar),
            outer_outer: co * outer_on_outer * mass + r * r * inertia,
            outer_inner: r * radius * inertia - co * tangents * mass,
            inner_outer: r * radius * inertia - ci * outer_on_inner * mass,
            inner_inner: ci * mass + radius * radius * inertia,
            outer_normal: contacts.outer.friction_normal,
            inner_normal: contacts.inner.force,
        }
    }

    /// ΔVo and ΔVi at the end of the step under the friction (fo, fi), m/s.
    #[inline(always)]
    pub fn slips(&self, [outer, inner]: [f64; 2]) -> [f64; 2] {
        [
            self.outer_free - (self.outer_outer * outer + self.outer_inner * inner),
            self.inner_free - (self.inner_outer * outer + self.inner_inner * inner),
        ]
    }
}

/// One step of Newton's method from `slips`; a solution that has converged stays.
///
/// With D = diag(df/ds) the step Δ solves (1 + H·D)·Δ = s_free − H·f(s) − s, so that
/// s + Δ = s_free − H·(f(s) + D·Δ): sliding speeds and linearised friction belong together.
/// A step from full sliding past zero, where the slope of f is largest, ends there.
#[inline(always)]
pub fn newton_step(
    law: FrictionLaw,
    friction: &Friction,
    problem: &SlipProblem,
    slips: &Slips,
) -> Slips {
    let (outer, inner) = (slips.outer, slips.inner);
    let [fo, do_] = friction_force(law, friction, outer, problem.outer_normal);
    let [fi, di] = friction_force(law, friction, inner, problem.inner_normal);
    let [end_o, end_i] = problem.slips([fo, fi]);
    let (miss_o, miss_i) = (end_o - outer, end_i - inner);
    let (a, b) = (1.0 + problem.outer_outer * do_, problem.outer_inner * di);
    let (c, d) = (problem.inner_outer * do_, 1.0 + problem.inner_inner * di);
    let inverse = 1.0 / (a * d - b * c);
    let step_o = (d * miss_o - b * miss_i) * inverse;
    let step_i = (a * miss_i - c * miss_o) * inverse;
    let guarded = |s: f64, step: f64| {
        let passes = s * (s + step) < 0.0 && s.abs() * friction.inverse_slip_scale > 1.0;
        if passes { 0.0 } else { s + step }
    };
    // Without load the sliding speed does not matter.
    let last = |step: f64, normal: f64| {
        (step.abs() * friction.inverse_slip_scale <= LAST_STEP) | (normal <= 0.0)
    };
    let converged = last(step_o, problem.outer_normal) & last(step_i, problem.inner_normal);
    let done = slips.converged > 0.0;
    let keep = |kept: f64, new: f64| if done { kept } else { new };
    let select = |last: f64, other: f64| if converged { last } else { other };
    Slips {
        outer: keep(outer, select(outer + step_o, guarded(outer, step_o))),
        inner: keep(inner, select(inner + step_i, guarded(inner, step_i))),
        outer_friction: keep(slips.outer_friction, select(fo + do_ * step_o, fo)),
        inner_friction: keep(slips.inner_friction, select(fi + di * step_i, fi)),
        converged: keep(1.0, select(1.0, 0.0)),
    }
}

/// Coulomb's law at both contacts: |f| ≤ μN with f = μN·sign(s) where s ≠ 0, exactly.
///
/// The candidates are: both contacts stick; one slides either way while the other sticks as
/// far as its cone allows. The solution is the one at which neither force changes under
/// the projection f → clamp(f + s/H_kk, ±μN). It is unique, for H is a P-matrix.
#[inline(always)]
pub fn coulomb_friction(friction: &Friction, problem: &SlipProblem) -> Slips {
    let p = problem;
    let largest = [
        friction.coefficient * p.outer_normal,
        friction.coefficient * p.inner_normal,
    ];
    // A ball of the padding has no mobility, and so no number here: no load, no friction.
    let clamp = |f: f64, most: f64| if f.abs() <= most { f } else { most.copysign(f) };
    let determinant = p.outer_outer * p.inner_inner - p.outer_inner * p.inner_outer;
    let stick = [
        (p.inner_inner * p.outer_free - p.outer_inner * p.inner_free) / determinant,
        (p.outer_outer * p.inner_free - p.inner_outer * p.outer_free) / determinant,
    ];
    let outer_slides = |fo: f64| {
        let fi = (p.inner_free - p.inner_outer * fo) / p.inner_inner;
        [fo, clamp(fi, largest[1])]
    };
    let inner_slides = |fi: f64| {
        let fo = (p.outer_free - p.outer_inner * fi) / p.outer_outer;
        [clamp(fo, largest[0]), fi]
    };
    let miss = |f: [f64; 2]| {
        let [so, si] = p.slips(f);
        (clamp(f[0] + so / p.outer_outer, largest[0]) - f[0]).abs()
            + (clamp(f[1] + si / p.inner_inner, largest[1]) - f[1]).abs()
    };
    let candidates = [
        outer_slides(largest[0]),
        outer_slides(-largest[0]),
        inner_slides(largest[1]),
        inner_slides(-largest[1]),
    ];
    let within = stick[0].abs() <= largest[0] && stick[1].abs() <= largest[1];
    // Sticking is exact where it is possible: no rounding of `miss` may prefer a slide.
    let mut least = if within { -1.0 } else { f64::INFINITY };
    let mut best = if within { stick } else { [0.0; 2] };
    for candidate in candidates {
        let size = miss(candidate);
        let better = size < least;
        least = if better { size } else { least };
        best[0] = if better { candidate[0] } else { best[0] };
        best[1] = if better { candidate[1] } else { best[1] };
    }
    let [outer, inner] = p.slips(best);
    Slips {
        outer,
        inner,
        outer_friction: best[0],
        inner_friction: best[1],
        converged: 1.0,
    }
}

/// Weight θ of the end of a step in s₁ = s_free − H·((1 − θ)·f₀ + θ·f₁) for a contact whose slip
/// decays by `rate` = H·df/ds over the step: (6 + 3z + z²)/(12 + 4z + z²).
///
/// It follows the exponentially fitted 1/(1 − e^(−z)) − 1/z from ½ + z/12 to 1 − 1/z: the
/// trapezoidal rule of order 2 for sliding contacts, backward Euler, which damps any stiffness,
/// for rolling ones (Hairer & Wanner, *Solving Ordinary Differential Equations II*,
/// section IV.3).
#[inline(always)]
pub fn end_weight(rate: f64) -> f64 {
    // Squares of larger rates could overflow; 1 is exact to six digits there.
    let z = if rate < 1e6 { rate } else { 1e6 };
    (6.0 + (3.0 + z) * z) / (12.0 + (4.0 + z) * z)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(free: [f64; 2], normal: [f64; 2], h_s: f64) -> SlipProblem {
        let (m, r) = (3.55e-3, 4.76e-3);
        let j = 0.4 * m * r * r;
        let (own, other) = (h_s * (1.0 / m + r * r / j), h_s * (r * r / j - 1.0 / m));
        SlipProblem {
            outer_free: free[0],
            inner_free: free[1],
            outer_outer: own,
            outer_inner: other,
            inner_outer: other,
            inner_inner: own,
            outer_normal: normal[0],
            inner_normal: normal[1],
        }
    }

    fn friction(coefficient: f64, scale: f64) -> Friction {
        Friction {
            coefficient,
            inverse_slip_scale: 1.0 / scale,
            ..Friction::default()
        }
    }

    /// Every combination of stick and slide satisfies Coulomb's law, and sticking is exact.
    #[test]
    fn coulomb_holds_the_cone() {
        let f = friction(0.3, 0.02);
        let (mut sticks, mut slides) = (0, 0);
        for a in -10..=10 {
            for b in -10..=10 {
                for normal in [[1000.0, 900.0], [5.0, 800.0], [700.0, 0.0], [0.0, 0.0]] {
                    let free = [0.3 * f64::from(a), 0.2 * f64::from(b)];
                    let p = problem(free, normal, 2e-6);
                    let s = coulomb_friction(&f, &p);
                    for (slip, force, n) in [
                        (s.outer, s.outer_friction, normal[0]),
                        (s.inner, s.inner_friction, normal[1]),
                    ] {
                        assert!(force.abs() <= 0.3 * n * (1.0 + 1e-12) + 1e-12);
                        if slip.abs() < 1e-12 {
                            sticks += 1;
                        } else {
                            slides += 1;
                            let expected = 0.3 * n * slip.signum();
                            assert!((force - expected).abs() < 1e-9, "{free:?} {normal:?} {s:?}");
                        }
                    }
                }
            }
        }
        assert!(sticks > 100 && slides > 100, "{sticks} {slides}");
    }

    /// Newton's method finds the solution of the smooth laws from anywhere, however stiff.
    #[test]
    fn smooth_laws_converge_from_anywhere() {
        for (law, scale, h) in [
            (FrictionLaw::Smooth, 0.02, 2e-6),
            (FrictionLaw::Smooth, 2e-4, 2e-6),
            (FrictionLaw::Smooth, 2e-3, 1e-5),
            (FrictionLaw::Stribeck, 0.02, 2e-6),
        ] {
            let f = Friction {
                static_excess: 0.1,
                inverse_stribeck_speed: 2.0,
                ..friction(0.3, scale)
            };
            for a in -8..=8 {
                for start in [-50.0, -0.1, 0.0, 1e-3, 7.0] {
                    let free = [0.4 * f64::from(a), 1.0 - 0.1 * f64::from(a)];
                    let p = problem(free, [1500.0, 1200.0], h);
                    let mut s = Slips {
                        outer: start,
                        inner: -start,
                        ..Slips::default()
                    };
                    let mut iterations = 0;
                    while s.converged == 0.0 && iterations < MAX_ITERATIONS {
                        s = newton_step(law, &f, &p, &s);
                        iterations += 1;
                    }
                    assert!(s.converged > 0.0, "{law:?} {scale} {free:?} from {start}");
                    let [fo, _] = friction_force(law, &f, s.outer, p.outer_normal);
                    assert!((fo - s.outer_friction).abs() < 1e-3 * 0.4 * 1500.0, "{s:?}");
                    let [outer, inner] = p.slips([s.outer_friction, s.inner_friction]);
                    assert!((outer - s.outer).abs() < 1e-9 && (inner - s.inner).abs() < 1e-9);
                }
            }
        }
    }
}
