//! Laws of friction of one's own, as a case holds them.

use std::sync::Arc;

use crate::error::InputError;
use crate::numerics::lanes::{LANES, Lanes};

/// A law of friction of one's own: μ over the sliding speed.
///
/// The force is μ(|ΔV|)·tanh(ΔV/scale)·N with the regularisation speed of the case as its scale. Implicit treatment and
/// step limits follow from μ and its slope.
///
/// μ lies between 0 and 2, and its slope is finite. `CaseBuilder::build` tries a law at rest and up to four times the
/// speed of the fastest surface of the case, at least 10 m/s, and refuses one that answers anything else there, or a
/// slope that is not that of μ. In a run such an answer ends it. Messages have the name of the law, the sliding speed
/// and what it returned.
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
/// let case = CaseBuilder::of(reference::bearing()).own_friction(Falling);
/// let case = case.inner_speed_rad_s(100.0).build()?;
/// assert!((case.contact.friction.coefficient - 0.06).abs() < 1e-5); // that of fast sliding
/// # Ok::<(), InputError>(())
/// ```
pub trait FrictionLaw: Send + Sync {
    /// μ at a sliding speed of 0 or more, m/s, and its slope dμ/d|ΔV|, s/m.
    fn coefficient(&self, sliding_m_s: f64) -> [f64; 2];

    /// [`Self::coefficient`] of several speeds at once, into arrays of the same length.
    fn coefficients(&self, sliding_m_s: &[f64], mu: &mut [f64], slope_s_m: &mut [f64]) {
        for ((speed, mu), slope) in sliding_m_s.iter().zip(mu).zip(slope_s_m) {
            [*mu, *slope] = self.coefficient(*speed);
        }
    }

    /// Name in messages; that of the type unless it is given.
    fn name(&self) -> &str {
        let path = std::any::type_name::<Self>();
        path.rsplit("::").next().unwrap_or(path)
    }
}

impl std::fmt::Debug for dyn FrictionLaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// Least sliding speed but 0 at which a law is tried before a run, m/s.
const TRIED_FROM_M_S: f64 = 1e-4;
/// Speeds tried in each decade.
const TRIED_PER_DECADE: f64 = 24.0;
/// Largest μ, as of the other laws.
const COEFFICIENT_MAX: f64 = 2.0;
/// Largest difference of a slope from that of μ between neighbouring speeds, of the change of μ.
const SLOPE_TOLERANCE: f64 = 0.5;
/// Largest change of μ over the tried speeds that counts as none.
const ROUNDING: f64 = 1e-9;

/// A [`FrictionLaw`] that has been tried over the sliding speeds, shared by whatever evaluates it.
#[derive(Clone)]
pub(crate) struct OwnFriction {
    law: Arc<dyn FrictionLaw>,
    fast: f64,
    most: f64,
    steepest_fall_s_m: f64,
    kinked: bool,
    factor: f64,
}

impl std::fmt::Debug for OwnFriction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "OwnFriction({}, {} to {})",
            self.law.name(),
            self.most,
            self.fast
        )
    }
}

/// Equal if they share the law.
impl PartialEq for OwnFriction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law) && self.factor == other.factor
    }
}

impl OwnFriction {
    /// Tries a law over the sliding speeds from 0 to `most_m_s`.
    ///
    /// # Errors
    /// An [`InputError`] of `field` with what the law returned: μ below 0, above 2 or not finite, or a slope that is
    /// not that of μ.
    pub(crate) fn new(
        law: Arc<dyn FrictionLaw>,
        field: &'static str,
        most_m_s: f64,
    ) -> Result<Self, InputError> {
        let tried: Vec<Tried> = tried_speeds_m_s(most_m_s)
            .map(|speed| Tried::of(&*law, speed))
            .collect();
        for one in &tried {
            if !one.is_possible() {
                let rule = format!(
                    "μ from 0 to {COEFFICIENT_MAX} and a finite slope at sliding speeds up to {most_m_s:.0} m/s, \
                     which nothing reaches in this case"
                );
                return Err(one.refused(&*law, field, &rule));
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
                return Err(middle.refused(&*law, field, &rule));
            }
        }
        let most = tried.iter().fold(0.0, |most: f64, one| most.max(one.mu));
        let fall = tried
            .iter()
            .fold(0.0, |most: f64, one| most.max(-one.slope));
        Ok(Self {
            fast: tried[tried.len() - 1].mu,
            most,
            steepest_fall_s_m: fall,
            kinked: tried[0].slope != 0.0,
            factor: 1.0,
            law,
        })
    }

    /// Name of the law.
    pub(crate) fn name(&self) -> &str {
        self.law.name()
    }

    /// μ of fast sliding.
    pub(crate) fn coefficient_fast(&self) -> f64 {
        self.factor * self.fast
    }

    /// μ at rest; 0 where the law answers what cannot be.
    pub(super) fn coefficient_at_rest(&self) -> f64 {
        self.coefficient(0.0).map_or(0.0, |[mu, _]| mu)
    }

    /// Largest μ at the speeds that were tried.
    pub(super) fn coefficient_max(&self) -> f64 {
        self.factor * self.most
    }

    /// Largest fall of μ over the sliding speed at the speeds that were tried, s/m.
    pub(super) fn steepest_fall(&self) -> f64 {
        self.factor * self.steepest_fall_s_m
    }

    /// μ and its slope, s/m, at a sliding speed.
    ///
    /// # Errors
    /// What the law returned, where that cannot be.
    #[inline(always)]
    pub(super) fn coefficient(&self, sliding_m_s: f64) -> Result<[f64; 2], [f64; 2]> {
        let [mu, slope] = self.law.coefficient(sliding_m_s);
        match possible(mu, slope) {
            true => Ok([self.factor * mu, self.factor * slope]),
            false => Err([mu, slope]),
        }
    }

    /// [`Self::coefficient`] of a block of speeds; whether the law may answer so at all of them.
    #[inline(always)]
    pub(super) fn coefficients(&self, speeds: &Lanes, mu: &mut Lanes, slope: &mut Lanes) -> bool {
        self.law.coefficients(&speeds.0, &mut mu.0, &mut slope.0);
        let mut all = true;
        for lane in 0..LANES {
            all &= possible(mu.0[lane], slope.0[lane]);
            mu.0[lane] *= self.factor;
            slope.0[lane] *= self.factor;
        }
        all
    }

    /// Whether μ rises or falls from rest on, so that friction has a kink there.
    pub(super) fn is_kinked(&self) -> bool {
        self.kinked
    }

    /// The law with every μ times `factor`.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self {
            factor: self.factor * factor,
            ..self.clone()
        }
    }
}

/// Sliding speeds at which a law is tried, up to this one, m/s.
fn tried_speeds_m_s(most_m_s: f64) -> impl Iterator<Item = f64> {
    let count = ((most_m_s / TRIED_FROM_M_S).log10() * TRIED_PER_DECADE).ceil();
    let of = move |k: u32| TRIED_FROM_M_S * 10f64.powf(f64::from(k) / TRIED_PER_DECADE);
    let beyond_rest = (0..=count.max(0.0) as u32).map(move |k| of(k).min(most_m_s));
    std::iter::once(0.0).chain(beyond_rest)
}

/// Whether a law may answer so.
#[inline(always)]
fn possible(mu: f64, slope: f64) -> bool {
    // Not short-circuited, as lanes are looked at together.
    (0.0..=COEFFICIENT_MAX).contains(&mu) & slope.is_finite()
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
        possible(self.mu, self.slope)
    }

    fn refused(&self, law: &dyn FrictionLaw, field: &'static str, rule: &str) -> InputError {
        let rule = format!(
            "{rule}: {} returned μ = {} with slope {} s/m at {} m/s",
            law.name(),
            self.mu,
            self.slope,
            self.speed_m_s
        );
        InputError::rule(field, self.mu, rule)
    }
}

/// Impossible coefficient or slope from a friction law of one's own during a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FrictionFault {
    /// Name of the law.
    pub law: String,
    /// Sliding speed, m/s.
    pub sliding_m_s: f64,
    /// μ and its slope, s/m, as returned.
    pub returned: [f64; 2],
}
