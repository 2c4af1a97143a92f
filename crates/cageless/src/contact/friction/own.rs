//! Friction by a law of one's own.

use std::sync::{Arc, OnceLock};

use super::law::{Law, LawConstants, LawLanes, knee};
use super::parameters::FrictionParameters;
use super::tanh::tanh;
use crate::error::InputError;
use crate::numerics::lanes::LANES;

/// A law of friction of one's own: μ over the sliding speed.
///
/// The force is μ(|ΔV|)·tanh(ΔV/scale)·N with the regularisation speed of the case as its scale. Implicit treatment and
/// step limits follow from μ and its slope.
///
/// ```
/// use cageless::prelude::*;
///
/// /// Friction that falls from 0.12 at rest to 0.06 of fast sliding.
/// struct Falling;
///
/// impl FrictionLaw for Falling {
///     fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
///         let excess = 0.06 * (-sliding_m_s).exp();
///         [0.06 + excess, -excess]
///     }
/// }
///
/// let case = CaseBuilder::of(reference::bearing()).own_friction(Falling).build()?;
/// assert_eq!(case.contact.friction.coefficient, 0.06);
/// # Ok::<(), InputError>(())
/// ```
pub trait FrictionLaw: Send + Sync {
    /// μ at a sliding speed of 0 or more, m/s, and its slope dμ/d|ΔV|, s/m.
    fn coefficient(&self, sliding_m_s: f64) -> [f64; 2];

    /// Name in messages; that of the type unless it is given.
    fn name(&self) -> &str {
        let path = std::any::type_name::<Self>();
        path.rsplit("::").next().unwrap_or(path)
    }
}

/// Sliding speeds at which a law is tried before a run, m/s.
const TRIED_M_S: [f64; 2] = [1e-4, 1e3];
/// Speeds tried in each decade.
const TRIED_PER_DECADE: i32 = 24;
/// Largest μ, as of the other laws.
const COEFFICIENT_MAX: f64 = 2.0;
/// Largest difference of a slope from that of μ between neighbouring speeds, of the change of μ.
const SLOPE_TOLERANCE: f64 = 0.5;
/// Largest change of μ over the tried speeds that counts as none.
const ROUNDING: f64 = 1e-9;

/// A [`FrictionLaw`] that has been tried over the sliding speeds, shared by whatever evaluates it.
#[derive(Clone)]
pub struct OwnFriction {
    law: Arc<dyn FrictionLaw>,
    fast: f64,
    most: f64,
    steepest_fall_s_m: f64,
    factor: f64,
}

impl std::fmt::Debug for OwnFriction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "OwnFriction({}, {} to {})", self.law.name(), self.most, self.fast)
    }
}

/// Equal if they share the law.
impl PartialEq for OwnFriction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law) && self.factor == other.factor
    }
}

impl OwnFriction {
    /// Tries a law over the sliding speeds from 0 to 1000 m/s.
    ///
    /// # Errors
    /// An [`InputError`] of `own_friction` with what the law returned: μ below 0, above 2 or not finite, or a slope
    /// that is not that of μ.
    pub fn new(law: impl FrictionLaw + 'static) -> Result<Self, InputError> {
        let law: Arc<dyn FrictionLaw> = Arc::new(law);
        let decades = (TRIED_M_S[1] / TRIED_M_S[0]).log10().round() as i32;
        let of = |k: i32| TRIED_M_S[0] * 10f64.powf(f64::from(k) / f64::from(TRIED_PER_DECADE));
        let speeds = std::iter::once(0.0).chain((0..=decades * TRIED_PER_DECADE).map(of));
        let tried: Vec<Tried> = speeds.map(|speed| Tried::of(&*law, speed)).collect();
        for one in &tried {
            if !one.is_possible() || one.mu > COEFFICIENT_MAX {
                return Err(one.refused(&*law, "μ from 0 to 2 and a finite slope"));
            }
        }
        for pair in tried.windows(2) {
            let [before, after] = [&pair[0], &pair[1]];
            let width = after.speed_m_s - before.speed_m_s;
            let change = after.mu - before.mu;
            let middle = Tried::of(&*law, before.speed_m_s + 0.5 * width);
            // Simpson's rule of the slope is the change of μ.
            let sum = width / 6.0 * (before.slope + 4.0 * middle.slope + after.slope);
            let scale = change.abs().max(sum.abs());
            if scale > ROUNDING && (sum - change).abs() > SLOPE_TOLERANCE * scale {
                let rule = format!("the slope of μ, here about {:.3e} s/m", change / width);
                return Err(middle.refused(&*law, &rule));
            }
        }
        let most = tried.iter().fold(0.0, |most: f64, one| most.max(one.mu));
        let fall = tried.iter().fold(0.0, |most: f64, one| most.max(-one.slope));
        Ok(Self {
            fast: tried[tried.len() - 1].mu,
            most,
            steepest_fall_s_m: fall,
            factor: 1.0,
            law,
        })
    }

    /// Name of the law.
    pub fn name(&self) -> &str {
        self.law.name()
    }

    /// μ of fast sliding.
    pub fn coefficient_fast(&self) -> f64 {
        self.factor * self.fast
    }

    /// The law with every μ times `factor`.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self {
            factor: self.factor * factor,
            ..self.clone()
        }
    }
}

/// Answer of a law at a sliding speed.
struct Tried {
    speed_m_s: f64,
    mu: f64,
    slope: f64,
}

impl Tried {
    fn of(law: &dyn FrictionLaw, speed_m_s: f64) -> Self {
        let [mu, slope] = law.coefficient(speed_m_s);
        Self {
            speed_m_s,
            mu,
            slope,
        }
    }

    fn is_possible(&self) -> bool {
        self.mu.is_finite() && self.mu >= 0.0 && self.slope.is_finite()
    }

    fn refused(&self, law: &dyn FrictionLaw, rule: &str) -> InputError {
        let rule = format!(
            "{rule}: {} returned μ = {} with slope {} s/m at {} m/s",
            law.name(),
            self.mu,
            self.slope,
            self.speed_m_s
        );
        InputError::rule("own_friction", self.mu, rule)
    }
}

/// What an own law returned in a run that cannot be.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionFault {
    /// Name of the law.
    pub law: String,
    /// Sliding speed, m/s.
    pub sliding_m_s: f64,
    /// μ and its slope, s/m, as returned.
    pub returned: [f64; 2],
}

impl std::fmt::Display for FrictionFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "the law of friction {} returned μ = {} with slope {} s/m at a sliding speed of {} m/s",
            self.law, self.returned[0], self.returned[1], self.sliding_m_s
        )
    }
}

/// μ(|ΔV|)·tanh(ΔV/scale)·N with μ from a law of one's own.
#[derive(Debug, Clone)]
pub struct Own {
    law: Option<OwnFriction>,
    coefficient: f64,
    inverse_regularisation_speed: f64,
    /// First answer that cannot be, of whatever shares these constants.
    fault: Arc<OnceLock<FrictionFault>>,
}

impl PartialEq for Own {
    fn eq(&self, other: &Self) -> bool {
        let scale = |own: &Self| own.inverse_regularisation_speed;
        self.law == other.law && scale(self) == scale(other)
    }
}

impl Own {
    /// μ and its slope; none where the law answers what cannot be, which ends the run.
    #[inline(always)]
    fn mu(&self, law: &OwnFriction, speed_m_s: f64, normal_n: f64) -> [f64; 2] {
        let [mu, slope] = law.law.coefficient(speed_m_s);
        if mu >= 0.0 && mu.is_finite() && slope.is_finite() {
            return [law.factor * mu, law.factor * slope];
        }
        // The padding of the lanes slides as it likes.
        if normal_n > 0.0 {
            self.report(law, speed_m_s, [mu, slope]);
        }
        [0.0, 0.0]
    }

    #[cold]
    fn report(&self, law: &OwnFriction, sliding_m_s: f64, returned: [f64; 2]) {
        self.fault.get_or_init(|| FrictionFault {
            law: law.name().to_owned(),
            sliding_m_s,
            returned,
        });
    }

    /// First answer of the law that cannot be.
    pub(crate) fn fault(&self) -> Option<&FrictionFault> {
        self.fault.get()
    }
}

impl Law for Own {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let Some(law) = self.law.as_ref().filter(|_| normal_n != 0.0) else {
            return [0.0; 2];
        };
        let [mu, mu_slope] = self.mu(law, sliding_m_s.abs(), normal_n);
        let knee = tanh(sliding_m_s * inverse_knee_s_m);
        let slope = mu * (1.0 - knee * knee) * inverse_knee_s_m + mu_slope * knee.abs();
        [mu * normal_n * knee, slope * normal_n]
    }

    /// Zero sliding, from which μ changes to both sides.
    #[inline(always)]
    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        Some(sliding_m_s)
    }

    knee!();
}

impl LawConstants for Own {
    const NAME: &'static str = "own";

    /// Without a law, which a checked case has, there is no friction.
    fn new(parameters: &FrictionParameters, _stick_gain_n_s_m: f64) -> Self {
        Self {
            law: parameters.own.clone(),
            coefficient: parameters.coefficient,
            inverse_regularisation_speed: 1.0 / parameters.regularisation_speed_m_s,
            fault: Arc::default(),
        }
    }

    fn describe(parameters: &FrictionParameters) -> String {
        let own = parameters.own.as_ref();
        own.map_or_else(String::new, |own| own.name().to_owned())
    }

    fn coefficient_max(parameters: &FrictionParameters) -> f64 {
        let own = parameters.own.as_ref();
        own.map_or(parameters.coefficient, |own| own.factor * own.most)
    }

    fn steepest_fall(parameters: &FrictionParameters) -> f64 {
        let own = parameters.own.as_ref();
        own.map_or(0.0, |own| own.factor * own.steepest_fall_s_m)
    }
}

/// [`Own`] of each lane.
#[derive(Debug, Clone)]
pub(crate) struct OwnLanes([Own; LANES]);

/// [`Own`] of one lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OwnLane<'a>(&'a Own);

impl LawLanes for OwnLanes {
    type Constants = Own;
    type Law<'a> = OwnLane<'a>;

    #[inline(always)]
    fn lane(&self, lane: usize) -> OwnLane<'_> {
        OwnLane(&self.0[lane])
    }

    fn filled(value: impl Fn(usize) -> Own) -> Self {
        Self(std::array::from_fn(value))
    }
}

impl Law for OwnLane<'_> {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        self.0.force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m)
    }

    #[inline(always)]
    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        self.0.edge(sliding_m_s)
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.0.coefficient
    }

    #[inline(always)]
    fn inverse_regularisation_speed(&self) -> f64 {
        self.0.inverse_regularisation_speed
    }
}
