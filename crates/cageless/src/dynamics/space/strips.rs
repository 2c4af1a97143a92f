//! Friction over a contact ellipse in strips across the groove.
//!
//! A point at the distance x from the middle of the contact slides with
//!
//!   sτ = s0τ + x ω′n + κx² ω′l,   sl = s0l − κx² ω′τ,   κ = 1/(2Rc),   1/Rc = ½(1/R + 1/rg),
//!
//! ω′n being the spin and κx² ω′l the differential sliding that Heathcote found. The strips lie at
//! the nodes of Gauss–Jacobi quadrature for ¾(1 − ξ²), the load of Hertz's ellipse per length. Over
//! a strip of half-width h the sliding velocity varies by ±hγ, γ = ω′n + 2κx ω′l, which widens the knee of the law to
//! √(v² + (hγ)²) and leaves a moment. A film is sheared at S² = |**s**|² + (hγ)² in it: with F of the film under the
//! share of the load, **f** = −F **s**/S and m = −F h²γ/S are the gradient of one potential.

use crate::contact::{FilmTraction, Law};
use crate::numerics::lanes::{lane_struct, larger};

lane_struct! {
    /// Sliding of a contact: of its middle, and the rotation of the ball relative to the ring.
    pub(crate) struct Sliding per lane SlidingLanes {
        /// s0 along τ, m/s.
        along,
        /// s0 along l, m/s.
        across,
        /// ω′ along n, rad/s.
        spin,
        /// ω′ along l, rad/s.
        roll,
        /// ω′ along τ, rad/s.
        yaw,
    }
}

lane_struct! {
    /// Sliding of a strip.
    pub(crate) struct StripSliding per lane StripSlidingLanes {
        /// Velocity of its middle along τ, m/s.
        along,
        /// Velocity of its middle along l, m/s.
        across,
        /// γ, how fast the velocity changes across the contact, rad/s.
        shear,
    }
}

impl StripSliding {
    /// |**s**|, m/s.
    #[inline(always)]
    pub(super) fn speed(&self) -> f64 {
        (self.along * self.along + self.across * self.across).sqrt()
    }
}

impl Sliding {
    /// Sliding of the strip at x.
    #[inline(always)]
    pub(crate) fn at(&self, x_m: f64, curvature: f64) -> StripSliding {
        let bend = curvature * x_m * x_m;
        StripSliding {
            along: self.along + x_m * self.spin + bend * self.roll,
            across: self.across - bend * self.yaw,
            shear: self.spin + 2.0 * curvature * x_m * self.roll,
        }
    }
}

/// One strip: place and weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strip {
    /// ξ = x/a.
    pub place: f64,
    /// Share of the normal force.
    pub weight: f64,
    /// h/a.
    pub half_width: f64,
    /// c/a of the moment within the strip.
    pub lever: f64,
    /// γs·h/v, at which that moment has its knee.
    pub knee: f64,
}

/// Zeros of P′(n+1) and the weights of ¾(1 − ξ²) there: the inner nodes of Lobatto's rule.
pub(crate) fn strips(count: usize) -> Vec<Strip> {
    let n = count + 1;
    // P and P′ of degree n at x.
    let legendre = |x: f64| {
        let (mut before, mut p) = (1.0, x);
        for k in 2..=n {
            let k = k as f64;
            (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
        }
        (p, n as f64 * (before - x * p) / (1.0 - x * x))
    };
    (1..=count)
        .map(|k| {
            let mut x = -(std::f64::consts::PI * k as f64 / n as f64).cos();
            for _ in 0..50 {
                let (p, slope) = legendre(x);
                // (1 − x²)P″ = 2xP′ − n(n+1)P.
                let bend = (2.0 * x * slope - (n * (n + 1)) as f64 * p) / (1.0 - x * x);
                x -= slope / bend;
            }
            let place = if 2 * k == count + 1 { 0.0 } else { x };
            let (p, _) = legendre(place);
            let width = 1.0 - place * place;
            let weight = 1.5 * width / ((n * (n + 1)) as f64 * p * p);
            let half_width = weight / (1.5 * width);
            match count {
                1 => Strip {
                    place,
                    weight,
                    half_width,
                    lever: 0.375,
                    knee: 1.25,
                },
                _ => Strip {
                    place,
                    weight,
                    half_width,
                    lever: 0.5 * half_width,
                    knee: 1.5,
                },
            }
        })
        .collect()
}

lane_struct! {
    /// Friction of one strip at a sliding velocity **s** and the shear γ, and its slopes.
    ///
    /// Of the slopes of the law along **s** none is below 0, also where friction falls beyond a peak.
    pub(crate) struct StripFriction per lane StripFrictionLanes {
        /// Force on the ball along τ, N.
        along,
        /// Force on the ball along l, N.
        across,
        /// Moment on the ball within the strip, N·m.
        moment,
        /// −∂f/∂s along τ, N·s/m.
        along_along,
        /// −∂f/∂s between τ and l, N·s/m.
        along_across,
        /// −∂f/∂s along l, N·s/m.
        across_across,
        /// −∂f/∂γ along τ, N·s.
        along_shear,
        /// −∂f/∂γ along l, N·s.
        across_shear,
        /// −∂m/∂γ at the same F′ k, N·m·s.
        shear_shear,
        /// −∂m/∂γ by the change of F′ k, N·m·s.
        widening,
        /// −∂m/∂s over −∂f/∂γ.
        moment_ratio,
        /// |f|/|s|, −∂f/∂s across the sliding velocity, N·s/m.
        secant,
        /// |m|/|γ|, N·m·s.
        moment_secant,
        /// 1/k, s/m.
        inverse_knee,
        /// 1/√(γ² + γs²), s.
        inverse_shear,
    }
}

/// Keeps 0/0 out of contacts that do not bear, m.
const NO_LENGTH_M: f64 = 1e-30;

/// The contact that a strip is part of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patch<L> {
    pub law: L,
    /// Film, of laws that mix.
    pub film: FilmTraction,
    /// Normal force under which friction acts, N; of laws that mix the part that asperities carry.
    pub normal_n: f64,
    /// a, m.
    pub half_length_m: f64,
}

impl<L: Law> Patch<L> {
    /// Friction of a strip that slides, that of the film included.
    #[inline(always)]
    pub(super) fn friction(&self, strip: &Strip, sliding: &StripSliding) -> StripFriction {
        let mut friction = self.friction_of_law(strip, sliding);
        if L::MIXES {
            self.add_film(strip, sliding, &mut friction);
        }
        friction
    }

    /// Adds the friction of the film. With F′ − F/S = D, D/S² = d and z = h²γ its slopes are those of
    ///
    ///   −∂(**f**, m)/∂(**s**, γ) = (F/S) diag(1, 1, h²) + d (**s**, z)(**s**, z)ᵀ;
    ///
    /// the moments of law and film answer the sliding so that both together leave Newton's matrix positive definite.
    #[inline(always)]
    fn add_film(&self, strip: &Strip, sliding: &StripSliding, friction: &mut StripFriction) {
        let (a, b, shear) = (sliding.along, sliding.across, sliding.shear);
        let half = strip.half_width * self.half_length_m;
        let turn = half * half * shear;
        let sliding = a * a + b * b;
        let square = sliding + half * half * shear * shear;
        let [secant, more] = self.film.secant(square);
        let secant = strip.weight * secant;
        let bend = strip.weight * more / (square + f64::MIN_POSITIVE);
        friction.along -= secant * a;
        friction.across -= secant * b;
        friction.moment -= secant * turn;
        friction.along_along += secant + bend * a * a;
        friction.along_across += bend * a * b;
        friction.across_across += secant + bend * b * b;
        let [pull, push] = [friction.along_shear, friction.across_shear];
        let of_law = (pull * pull + push * push).sqrt();
        let of_film = (bend * turn).abs() * sliding.sqrt();
        let both = of_law + of_film + f64::MIN_POSITIVE;
        let mean = (friction.moment_ratio.sqrt() * of_law + of_film) / both;
        friction.moment_ratio = mean * mean;
        friction.along_shear += bend * a * turn;
        friction.across_shear += bend * b * turn;
        friction.shear_shear += half * half * secant + bend * turn * turn;
        friction.secant += secant;
        friction.moment_secant += half * half * secant;
        let scale = self.film.inverse_speed;
        let spread = half * shear * scale;
        let scale = scale / (1.0 + spread * spread).sqrt();
        friction.inverse_knee = larger(friction.inverse_knee, scale);
        friction.inverse_shear = larger(friction.inverse_shear, half * scale);
    }

    /// Friction of a strip that slides, of the law alone.
    ///
    /// With F the law under w N, k = √(vs² + (hγ)²) its knee, u = |s|/k and F′ = ∂F/∂|s|,
    ///
    ///   **f** = −F **s**/|s|,   m = −c (F′ k) γ/√(γ² + γs²),
    ///
    ///   ∂F/∂γ = −F′ u h²γ/k,   ∂m/∂|s| = 2 c F′ tanh u γ/√(γ² + γs²),
    ///
    /// these two as of the smooth law, for which F′ k = μ w N sech² u.
    #[inline(always)]
    fn friction_of_law(&self, strip: &Strip, sliding: &StripSliding) -> StripFriction {
        let shear = sliding.shear;
        let knee = 1.0 / self.law.inverse_regularisation_speed();
        let half = strip.half_width * self.half_length_m;
        let spread = half * shear;
        let wide = (knee * knee + spread * spread).sqrt();
        let inverse_knee = 1.0 / wide;
        let speed = sliding.speed();
        let normal = strip.weight * self.normal_n;
        let [size, slope] = self.law.force_with_knee(speed, normal, inverse_knee);
        let in_knees = speed * inverse_knee;
        let slides = in_knees > 1e-9;
        let inverse = if slides { 1.0 / speed } else { 0.0 };
        let secant = if slides { size * inverse } else { slope };
        let (a, b) = (sliding.along * inverse, sliding.across * inverse);
        let steepness = if slope > 0.0 { slope } else { 0.0 };
        let more = steepness - secant;
        // Within the strip.
        let slow = strip.knee * knee / (half + NO_LENGTH_M);
        let inverse_shear = 1.0 / (shear * shear + slow * slow).sqrt();
        let turning = shear * inverse_shear;
        let arm = strip.lever * self.half_length_m;
        let level = arm * steepness * wide;
        let largest = self.law.coefficient() * normal;
        let tanh = if size < largest { size } else { largest };
        let tanh = if largest > 0.0 { tanh / largest } else { 0.0 };
        let widening = half * half * inverse_knee * in_knees;
        let narrowing = 2.0 * arm * tanh;
        let coupling = -steepness * widening * shear;
        StripFriction {
            along: -secant * sliding.along,
            across: -secant * sliding.across,
            moment: -level * turning,
            along_along: secant + more * a * a,
            along_across: more * a * b,
            across_across: secant + more * b * b,
            along_shear: coupling * a,
            across_shear: coupling * b,
            shear_shear: level * (slow * inverse_shear).powi(2) * inverse_shear,
            widening: steepness * narrowing * widening * shear * turning,
            moment_ratio: narrowing * inverse_shear / (widening + f64::MIN_POSITIVE),
            secant,
            moment_secant: level * inverse_shear,
            inverse_knee,
            inverse_shear,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Patch, Sliding, StripSliding, strips};
    use crate::contact::FilmTraction;
    use crate::contact::friction::{Mixed, Smooth};

    /// ∫ ¾(1 − ξ²)ξ^2k = 3/((2k + 1)(2k + 3)), exact to degree 2n − 1; the nodes of three strips.
    #[test]
    fn strips_integrate_the_load_of_an_ellipse() {
        for count in 1..=21 {
            let strips = strips(count);
            for k in 0..count {
                let sum: f64 = strips
                    .iter()
                    .map(|s| s.weight * s.place.powi(2 * k as i32))
                    .sum();
                let exact = 3.0 / ((2 * k + 1) * (2 * k + 3)) as f64;
                assert!((sum - exact).abs() < 1e-14, "{count} {k}: {sum} {exact}");
            }
        }
        let three = strips(3);
        assert!((three[2].place - (3f64 / 7.0).sqrt()).abs() < 1e-15);
        assert!((three[1].weight - 8.0 / 15.0).abs() < 1e-15);
    }

    /// Friction of a whole contact.
    #[derive(Default)]
    struct ContactFriction {
        /// Force along τ, N.
        along: f64,
        /// Spin moment, N·m.
        moment: f64,
        /// Power that it takes, W.
        power: f64,
    }

    /// Friction of a contact under 1 N with μ = 1, a = 1 mm.
    fn contact_friction(count: usize, sliding: &Sliding, curvature: f64) -> ContactFriction {
        let patch = Patch {
            law: Smooth {
                coefficient: 1.0,
                inverse_regularisation_speed: 1e6,
            },
            film: FilmTraction::default(),
            normal_n: 1.0,
            half_length_m: 1e-3,
        };
        let mut whole = ContactFriction::default();
        for strip in &strips(count) {
            let x = strip.place * patch.half_length_m;
            let at = sliding.at(x, curvature);
            let f = patch.friction(strip, &at);
            whole.along += f.along;
            whole.moment += x * f.along + f.moment;
            whole.power -= f.along * at.along + f.across * at.across + f.moment * at.shear;
        }
        whole
    }

    /// Sliding and spin together, of Coulomb friction: F = ½(3β − β³)μN, M = ⅜(1 − β²)²μNa.
    #[test]
    fn sliding_and_spin_share_the_friction() {
        for (count, within) in [(1, [0.12, 0.08]), (21, [0.009, 0.006])] {
            for k in 0..=10 {
                let share = 0.1 * f64::from(k);
                let sliding = Sliding {
                    along: share,
                    spin: 1e3,
                    ..Sliding::default()
                };
                let ContactFriction {
                    along: force,
                    moment,
                    ..
                } = contact_friction(count, &sliding, 0.0);
                let expected = 0.5 * (3.0 * share - share.powi(3));
                assert!(
                    (force + expected).abs() < within[0],
                    "{count} {share}: {force}"
                );
                let expected = 0.375e-3 * (1.0 - share * share).powi(2);
                assert!(
                    (moment + expected).abs() < within[1] * 1e-3,
                    "{count} {share}: {moment}"
                );
            }
        }
    }

    /// A ball that rolls in a groove without traction does not slide at ξ = 2 cos 80°, and
    /// dissipates 0.161142 μNωa²κ.
    #[test]
    fn rolling_in_a_groove_slides_differentially() {
        let (curvature, roll) = (100.0, 1e4);
        let full = curvature * 1e-6 * roll;
        let sliding = Sliding {
            along: -full * (2.0 * 80f64.to_radians().cos()).powi(2),
            roll,
            ..Sliding::default()
        };
        let whole = contact_friction(21, &sliding, curvature);
        assert!(whole.along.abs() < 0.01, "{}", whole.along);
        let share = whole.power / full;
        assert!((share - 0.161142).abs() < 2e-3, "{share}");
    }

    /// A film and asperities under sliding, shear and both: the slopes are the derivatives, and the power that they
    /// take is that of the film sheared at S.
    #[test]
    fn film_of_a_strip_has_one_potential() {
        let film = FilmTraction {
            asperity_share: 0.0,
            limit: 12.0,
            stress_ratio: 0.03,
            inverse_speed: 400.0,
        };
        let law = Mixed(Smooth {
            coefficient: 0.1,
            inverse_regularisation_speed: 50.0,
        });
        let patch = Patch {
            law,
            film,
            normal_n: 0.0,
            half_length_m: 1e-3,
        };
        for (strip, slip, shear) in [
            (0, [1e-4, -2e-4], 0.3),
            (1, [3e-3, 1e-3], 8.0),
            (1, [0.2, -0.5], -900.0),
            (2, [1e-3, 0.0], 3e3),
            (2, [0.0, 0.0], 3.0),
        ] {
            let strip = &strips(3)[strip];
            let sliding = |[along, across, shear]: [f64; 3]| StripSliding {
                along,
                across,
                shear,
            };
            let at = |place: [f64; 3]| {
                let f = patch.friction(strip, &sliding(place));
                [f.along, f.across, f.moment]
            };
            let here = [slip[0], slip[1], shear];
            let found = patch.friction(strip, &sliding(here));
            let half = strip.half_width * 1e-3;
            let speed = slip[0].hypot(slip[1]).hypot(half * shear);
            let power: f64 = at(here).iter().zip(here).map(|(f, v)| -f * v).sum();
            let expected = strip.weight * film.mixed([0.0; 2], speed)[0] * speed;
            assert!((power / expected - 1.0).abs() < 1e-12, "{power} {expected}");
            // In N·s/m: the shear as hγ, the moment over h.
            let units = [1.0, 1.0, half];
            let slope = |i: usize, j: usize| {
                let h = 1e-4 * speed.max(1e-6) / units[j];
                let [mut more, mut less] = [here; 2];
                (more[j], less[j]) = (here[j] + h, here[j] - h);
                (at(less)[i] - at(more)[i]) / (2.0 * h)
            };
            let ratio = found.moment_ratio;
            let slopes = [
                [found.along_along, found.along_across, found.along_shear],
                [found.along_across, found.across_across, found.across_shear],
                [
                    ratio * found.along_shear,
                    ratio * found.across_shear,
                    found.shear_shear,
                ],
            ];
            let scale = found.secant;
            for i in 0..3 {
                for j in 0..3 {
                    let unit = units[i] * units[j] * scale;
                    let miss = (slopes[i][j] - slope(i, j)).abs() / unit;
                    assert!(miss < 1e-6, "{slip:?} {shear} {i}{j}: {miss}");
                }
            }
        }
        let bearing = Patch {
            normal_n: 7.0,
            ..patch
        };
        let strip = &strips(3)[1];
        let sliding = StripSliding {
            along: 0.01,
            across: 0.02,
            shear: 40.0,
        };
        let both = bearing.friction(strip, &sliding);
        let dry = Patch {
            film: FilmTraction::default(),
            ..bearing
        }
        .friction(strip, &sliding);
        let wet = patch.friction(strip, &sliding);
        assert_eq!(both.along, dry.along + wet.along);
        assert_eq!(both.secant, dry.secant + wet.secant);
        assert!(both.inverse_knee >= dry.inverse_knee && both.inverse_knee >= wet.inverse_knee);
    }
}
