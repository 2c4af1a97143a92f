//! Coulomb's law: sliding under μN, rolling as sticking within the cone.

use super::parameters::FrictionParameters;
use super::law::{Law, LawConstants};
use crate::ball::BothContacts;
use crate::contact::slip_problem::{SlipProblem, Slips};
use crate::numerics::lanes::lane_struct;

/// Coulomb law: fraction of a slip within the friction cone that one step takes away.
///
/// Rolling needs a friction force inside the cone that no function of the state
/// gives; F = g·ΔV, bounded by ±μN, with g this fraction of what stops the slip within
/// a step, supplies it. It is implicit stick relaxed over a few steps: the slip that
/// remains is a creep proportional to the step, and where the ball slides, the law
/// is μ·sign(ΔV)·N exactly. Both raceway contacts of a ball together relax at up
/// to 10/7 of it, inside the stability interval of ABM4 (1.25); contacts between balls,
/// which would add to it, always slide.
pub(crate) const STICK_FRACTION: f64 = 0.4;

law_struct! {
    /// μ·sign(ΔV)·N while sliding, at most μN while sticking.
    pub(crate) struct Coulomb per lane CoulombLanes {
        /// μ.
        coefficient,
        /// Explicit methods: friction per sliding speed within the cone, N·s/m.
        stick_gain,
    }
}

impl Law for Coulomb {
    const STICKS: bool = true;

    /// g·ΔV bounded by ±μN, the cone with the relaxed stick of [`crate::dynamics::Model`]; it has no knee.
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, _: f64) -> [f64; 2] {
        let largest = self.coefficient * normal_n;
        let wanted = self.stick_gain * sliding_m_s;
        let bounded = if wanted > largest { largest } else { wanted };
        let force = if bounded < -largest {
            -largest
        } else {
            bounded
        };
        [force, self.stick_gain]
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// Coulomb's law at both contacts: |f| ≤ μN with f = μN·sign(s) where s ≠ 0, exactly.
    ///
    /// The candidates are: both contacts stick; one slides either way while the other sticks as
    /// far as its cone allows. The solution is the one at which neither force changes under
    /// the projection f → clamp(f + s/H_kk, ±μN). It is unique, for H is a P-matrix.
    #[inline(always)]
    fn end_of_step(&self, problem: &SlipProblem) -> Slips {
        let p = problem;
        let largest = BothContacts {
            outer: self.coefficient * p.outer_normal,
            inner: self.coefficient * p.inner_normal,
        };
        // A ball of the padding has no mobility, and so no number here: no load, no friction.
        let clamp = |f: f64, most: f64| if f.abs() <= most { f } else { most.copysign(f) };
        let determinant = p.outer_outer * p.inner_inner - p.outer_inner * p.inner_outer;
        let stick = BothContacts {
            outer: (p.inner_inner * p.outer_free - p.outer_inner * p.inner_free) / determinant,
            inner: (p.outer_outer * p.inner_free - p.inner_outer * p.outer_free) / determinant,
        };
        let outer_slides = |outer: f64| {
            let fi = (p.inner_free - p.inner_outer * outer) / p.inner_inner;
            let inner = clamp(fi, largest.inner);
            BothContacts { outer, inner }
        };
        let inner_slides = |inner: f64| {
            let fo = (p.outer_free - p.outer_inner * inner) / p.outer_outer;
            let outer = clamp(fo, largest.outer);
            BothContacts { outer, inner }
        };
        let miss = |f: BothContacts| {
            let s = p.slips(f);
            (clamp(f.outer + s.outer / p.outer_outer, largest.outer) - f.outer).abs()
                + (clamp(f.inner + s.inner / p.inner_inner, largest.inner) - f.inner).abs()
        };
        let candidates = [
            outer_slides(largest.outer),
            outer_slides(-largest.outer),
            inner_slides(largest.inner),
            inner_slides(-largest.inner),
        ];
        let within = stick.outer.abs() <= largest.outer && stick.inner.abs() <= largest.inner;
        // Sticking is exact where it is possible: no rounding of `miss` may prefer a slide.
        let mut least = if within { -1.0 } else { f64::INFINITY };
        let mut best = if within { stick } else { BothContacts::default() };
        for candidate in candidates {
            let size = miss(candidate);
            let better = size < least;
            least = if better { size } else { least };
            best.outer = if better { candidate.outer } else { best.outer };
            best.inner = if better { candidate.inner } else { best.inner };
        }
        let end = p.slips(best);
        Slips {
            outer: end.outer,
            inner: end.inner,
            outer_friction: best.outer,
            inner_friction: best.inner,
            converged: 1.0,
            ..Slips::default()
        }
    }
}

impl LawConstants for Coulomb {
    const NAME: &'static str = "coulomb";

    fn new(parameters: &FrictionParameters, stick_gain_n_s_m: f64) -> Self {
        Self {
            coefficient: parameters.coefficient,
            stick_gain: stick_gain_n_s_m,
        }
    }

    fn describe(_parameters: &FrictionParameters) -> String {
        "Coulomb".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::implicit_friction::tests::problem;

    /// Every combination of stick and slide satisfies Coulomb's law, and sticking is exact.
    #[test]
    fn coulomb_holds_the_cone() {
        let law = Coulomb {
            coefficient: 0.3,
            stick_gain: 1.0,
        };
        let (mut sticks, mut slides) = (0, 0);
        for a in -10..=10 {
            for b in -10..=10 {
                for normal in [[1000.0, 900.0], [5.0, 800.0], [700.0, 0.0], [0.0, 0.0]] {
                    let free = [0.3 * f64::from(a), 0.2 * f64::from(b)];
                    let p = problem(free, normal, 2e-6);
                    let s = law.end_of_step(&p);
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
}
