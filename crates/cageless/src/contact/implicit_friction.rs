//! Friction of the two raceway contacts of a ball at the end of a step, solved implicitly.
//!
//! Over a step h the friction forces f = (fo, fi) change the sliding speeds of a ball from
//! those that all other forces lead to, s = s_free − H·f(s), with H = h·A and A the mobility of
//! the ball at its two contacts. For a ball in plane contact (`physical`, e the angle between
//! the tangents at both contacts)
//!
//!   A = [ 1/m + r²/J,  r·R/J − cos e/m;  r·R/J − cos e/m,  1/m + R²/J ].
//!
//! A ring that is lighter than its balls follows them, which moves all of them; at the inner contact A then has
//! Z/M of Z balls and a ring of mass M on top, an upper bound of what they do to each other, and slip that is
//! left decays over some steps, to first order in h. Solved ball by ball such a ring chattered: with three balls
//! at Z m/M = 1.94, not at 1.55.
//!
//! Laws with a slope are solved by Newton's method, those that stick by [`Law::end_of_step`].

use super::friction::Law;
use super::friction_step::{LAST_STEP, SLIDING};
use super::slip_problem::{SlipProblem, Slips};
use super::{InnerContact, InnerRaceway, OuterContact, OuterGeometry, inner_slip, outer_slip};
use crate::ball::{Ball, BallMotion, BothContacts, PolarMotion};

/// Largest last step of a contact that slides, as a fraction of the slip scale, and the change of
/// the friction over it, as a fraction of μN.
const LAST_SLIDE: [f64; 2] = [1.0, 1e-3];

/// The two contacts of a ball with the raceways and what they slide against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RacewayContacts<'a> {
    /// The ball.
    pub ball: &'a Ball,
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
    /// With Δv = h/m·(fi·ti − fo·to), Δω = h/J·(r·fo + R·fi), to and ti the tangents at both contacts,
    /// ΔVo = vt − r·ω and ΔVi = ωi·Ri − (vt,i + R·ω).
    #[inline(always)]
    pub(crate) fn new(
        contacts: &RacewayContacts<'_>,
        motion: &BallMotion,
        polar: &PolarMotion,
        inner_polar: &PolarMotion,
        h_s: f64,
    ) -> Self {
        let (ball, geometry) = (contacts.ball, contacts.geometry);
        let (r, radius) = (geometry.effective_radius, ball.radius);
        let tangents = polar.ey * inner_polar.ey + polar.ex * inner_polar.ex;
        let (mass, inertia) = (h_s * ball.inverse_mass, h_s * ball.inverse_inertia);
        let turning = r * radius * inertia;
        let both = turning - tangents * mass;
        Self {
            outer_free: outer_slip(geometry, motion, polar),
            inner_free: inner_slip(ball, contacts.inner_raceway, motion, inner_polar),
            outer_outer: mass + r * r * inertia,
            outer_inner: both,
            inner_outer: both,
            inner_inner: mass + radius * radius * inertia + h_s * contacts.inner_raceway.following,
            outer_normal: contacts.outer.friction_normal,
            inner_normal: contacts.inner.force,
        }
    }

    /// The equations of the friction f₁ at the end of the step where the velocities change by
    /// (1 − θ)·f₀ + θ·f₁: s₁ = (s_free − H·(1 − θ)·f₀) − H·θ·f₁, with θ of both contacts and
    /// `rest` = (1 − θ)·f₀.
    #[inline(always)]
    pub(crate) fn split(&self, theta: BothContacts, rest: BothContacts) -> Self {
        let free = self.slips(rest);
        Self {
            outer_free: free.outer,
            inner_free: free.inner,
            outer_outer: self.outer_outer * theta.outer,
            inner_outer: self.inner_outer * theta.outer,
            outer_inner: self.outer_inner * theta.inner,
            inner_inner: self.inner_inner * theta.inner,
            ..*self
        }
    }

    /// ΔVo and ΔVi at the end of the step under this friction, m/s.
    #[inline(always)]
    pub(crate) fn slips(&self, f: BothContacts) -> BothContacts {
        BothContacts {
            outer: self.outer_free - (self.outer_outer * f.outer + self.outer_inner * f.inner),
            inner: self.inner_free - (self.inner_outer * f.outer + self.inner_inner * f.inner),
        }
    }
}

impl Slips {
    /// fo and fi, N.
    #[inline(always)]
    pub(crate) fn friction(&self) -> BothContacts {
        BothContacts {
            outer: self.outer_friction,
            inner: self.inner_friction,
        }
    }

    /// These sliding speeds with the friction and its slopes by `law`, to iterate from.
    #[inline(always)]
    pub(crate) fn with_friction(self, law: &impl Law, problem: &SlipProblem) -> Self {
        let [[outer_friction, outer_slope], [inner_friction, inner_slope]] = law.forces(
            [self.outer, self.inner],
            [problem.outer_normal, problem.inner_normal],
        );
        Self {
            outer_friction,
            inner_friction,
            outer_slope,
            inner_slope,
            ..self
        }
    }
}

/// One step of Newton's method from `slips` with the friction there.
///
/// With D = diag(df/ds) the step Δ solves (1 + H·D)·Δ = s_free − H·f(s) − s, so that
/// s + Δ = s_free − H·(f(s) + D·Δ): sliding speeds and linearised friction belong together.
/// A step from full sliding past zero, where the slope of f is largest, ends there.
#[inline(always)]
pub(crate) fn newton_step(law: &impl Law, problem: &SlipProblem, slips: &Slips) -> Slips {
    let (outer, inner) = (slips.outer, slips.inner);
    let (fo, fi) = (slips.outer_friction, slips.inner_friction);
    let (do_, di) = (slips.outer_slope, slips.inner_slope);
    let end = problem.slips(slips.friction());
    let (miss_o, miss_i) = (end.outer - outer, end.inner - inner);
    let (a, b) = (1.0 + problem.outer_outer * do_, problem.outer_inner * di);
    let (c, d) = (problem.inner_outer * do_, 1.0 + problem.inner_inner * di);
    let inverse = 1.0 / (a * d - b * c);
    let step_o = (d * miss_o - b * miss_i) * inverse;
    let step_i = (a * miss_i - c * miss_o) * inverse;
    let [knee_o, knee_i] = law.inverse_scales();
    let guarded = |s: f64, step: f64, knee: f64| {
        let passes = s * (s + step) < 0.0 && s.abs() * knee > 1.0;
        if passes { 0.0 } else { s + step }
    };
    // Without load the sliding speed does not matter, and it hardly does where a contact slides.
    let last = |s: f64, step: f64, slope: f64, normal: f64, knee: f64| {
        let in_scales = |speed: f64| speed.abs() * knee;
        let end = s + step;
        let slides = (in_scales(s) > SLIDING) & (in_scales(end) > SLIDING) & (s * end > 0.0);
        let change = (slope * step).abs();
        (in_scales(step) <= LAST_STEP)
            | (normal <= 0.0)
            | (slides
                & (in_scales(step) <= LAST_SLIDE[0])
                & (change <= LAST_SLIDE[1] * law.coefficient() * normal))
    };
    let converged = last(outer, step_o, do_, problem.outer_normal, knee_o)
        & last(inner, step_i, di, problem.inner_normal, knee_i);
    let select = |last: f64, other: f64| if converged { last } else { other };
    Slips {
        outer: select(outer + step_o, guarded(outer, step_o, knee_o)),
        inner: select(inner + step_i, guarded(inner, step_i, knee_i)),
        outer_friction: select(fo + do_ * step_o, fo),
        inner_friction: select(fi + di * step_i, fi),
        outer_slope: do_,
        inner_slope: di,
        converged: select(1.0, 0.0),
    }
}

/// [`newton_step`] from sliding speeds that an earlier step left; a solution that has converged
/// stays.
#[inline(always)]
pub(crate) fn further_step(law: &impl Law, problem: &SlipProblem, slips: &Slips) -> Slips {
    let next = newton_step(law, problem, &slips.with_friction(law, problem));
    let done = slips.converged > 0.0;
    let keep = |kept: f64, new: f64| if done { kept } else { new };
    Slips {
        outer: keep(slips.outer, next.outer),
        inner: keep(slips.inner, next.inner),
        outer_friction: keep(slips.outer_friction, next.outer_friction),
        inner_friction: keep(slips.inner_friction, next.inner_friction),
        outer_slope: keep(slips.outer_slope, next.outer_slope),
        inner_slope: keep(slips.inner_slope, next.inner_slope),
        converged: keep(1.0, next.converged),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::contact::MAX_ITERATIONS;
    use crate::contact::friction::{AtKnees, AtRaceways, FilmTraction, Mixed, Smooth, Stribeck};

    /// A ball in plane contact.
    pub(crate) fn problem(free: [f64; 2], normal: [f64; 2], h_s: f64) -> SlipProblem {
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

    /// Newton's method finds the solution of the smooth laws from anywhere, however stiff.
    #[test]
    fn smooth_laws_converge_from_anywhere() {
        for (scale, h) in [(0.02, 2e-6), (2e-4, 2e-6), (2e-3, 1e-5)] {
            let smooth = Smooth {
                coefficient: 0.3,
                inverse_regularisation_speed: 1.0 / scale,
            };
            converges_from_anywhere(&smooth, h);
        }
        let stribeck = Stribeck {
            coefficient: 0.3,
            static_excess: 0.1,
            inverse_stribeck_speed: 2.0,
            inverse_regularisation_speed: 50.0,
        };
        converges_from_anywhere(&stribeck, 2e-6);
        // Films of any steepness, with and without asperities.
        for (asperity_share, inverse_speed, knee) in
            [(0.0, 700.0, 50.0), (0.3, 5e4, 50.0), (0.3, 0.2, 1e3)]
        {
            let film = FilmTraction {
                asperity_share,
                limit: (1.0 - asperity_share) * 60.0,
                stress_ratio: 0.04,
                inverse_speed,
            };
            let smooth = Smooth {
                coefficient: 0.1,
                inverse_regularisation_speed: knee,
            };
            let law = AtKnees {
                law: Mixed(smooth),
                inverse_knees: [knee; 2],
            };
            let films = [film; 2];
            for h in [2e-6, 1e-5] {
                converges_from_anywhere(&AtRaceways { law, films }, h);
            }
        }
    }

    fn converges_from_anywhere(law: &impl Law, h: f64) {
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
                    s = further_step(law, &p, &s);
                    iterations += 1;
                }
                assert!(s.converged > 0.0, "{free:?} from {start}");
                for (slip, force, normal) in [
                    (s.outer, s.outer_friction, 1500.0),
                    (s.inner, s.inner_friction, 1200.0),
                ] {
                    let [expected, _] = law.force(slip, normal);
                    let miss = (expected - force).abs();
                    assert!(miss < 2.5e-3 * law.coefficient() * normal, "{s:?}");
                }
                let end = p.slips(s.friction());
                assert!((end.outer - s.outer).abs() < 1e-9 && (end.inner - s.inner).abs() < 1e-9);
            }
        }
    }
}
