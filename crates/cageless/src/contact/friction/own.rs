//! Friction by a law of one's own.

use std::sync::{Arc, OnceLock};

use super::law::{EvaluatedLaws, Law, LawConstants, LawLanes, knee};
use super::own_law::{FrictionFault, OwnFriction};
use super::parameters::FrictionParameters;
use crate::numerics::exponential::{tanh, tanh_pair};
use crate::numerics::lanes::{LANES, Lanes};

/// μ(|ΔV|)·tanh(ΔV/scale)·N with μ from a law of one's own.
#[derive(Debug, Clone)]
pub(crate) struct Own {
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
    fn mu(&self, law: &OwnFriction, speed_m_s: f64) -> [f64; 2] {
        law.coefficient(speed_m_s).unwrap_or_else(|returned| {
            self.report(law, speed_m_s, returned);
            [0.0; 2]
        })
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
        let mu = self.mu(law, speed(sliding_m_s));
        let knee = tanh(sliding_m_s * inverse_knee_s_m);
        at_knee(mu, knee, normal_n, inverse_knee_s_m)
    }

    /// Zero sliding, where μ changes to both sides from there.
    #[inline(always)]
    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        let kinked = self.law.as_ref().is_some_and(OwnFriction::is_kinked);
        kinked.then_some(sliding_m_s)
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
        own.map_or(parameters.coefficient, OwnFriction::coefficient_max)
    }

    fn coefficient_at_rest(parameters: &FrictionParameters) -> f64 {
        let own = parameters.own.as_ref();
        own.map_or(parameters.coefficient, OwnFriction::coefficient_at_rest)
    }

    fn steepest_fall(parameters: &FrictionParameters) -> f64 {
        let own = parameters.own.as_ref();
        own.map_or(0.0, OwnFriction::steepest_fall)
    }
}

/// Force and slope under μ with its slope, where the knee at the sliding speed has this value.
#[inline(always)]
fn at_knee([mu, mu_slope]: [f64; 2], knee: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
    let slope = mu * (1.0 - knee * knee) * inverse_knee_s_m + mu_slope * knee.abs();
    [mu * normal_n * knee, slope * normal_n]
}

/// |ΔV|; 0 in the padding of the lanes, which has no number.
#[inline(always)]
fn speed(sliding_m_s: f64) -> f64 {
    let speed = sliding_m_s.abs();
    if speed < f64::INFINITY { speed } else { 0.0 }
}

/// [`Own`] of each lane.
#[derive(Debug, Clone)]
pub(crate) struct OwnLanes {
    lanes: [Own; LANES],
    /// `true` if the lanes have one law.
    same: bool,
    coefficient: Lanes,
    inverse_regularisation_speed: Lanes,
}

impl OwnLanes {
    /// μ and its slope at the sliding speeds of a contact of each lane.
    #[inline(always)]
    fn mu(&self, slips_m_s: &Lanes) -> [Lanes; 2] {
        let [mut mu, mut slope] = [Lanes::ZERO; 2];
        let mut speeds = Lanes::ZERO;
        for lane in 0..LANES {
            speeds.0[lane] = speed(slips_m_s.0[lane]);
        }
        if let Some(law) = self.lanes[0].law.as_ref().filter(|_| self.same)
            && law.coefficients(&speeds, &mut mu, &mut slope)
        {
            return [mu, slope];
        }
        // Lane by lane: an invalid answer of the law stops its own bearing alone.
        for lane in 0..LANES {
            let own = &self.lanes[lane];
            let found = own.law.as_ref().map(|law| own.mu(law, speeds.0[lane]));
            [mu.0[lane], slope.0[lane]] = found.unwrap_or_default();
        }
        [mu, slope]
    }
}

impl LawLanes for OwnLanes {
    type Constants = Own;
    type Law<'a> = &'a Own;
    type Evaluated<'a> = OwnEvaluated<'a>;

    #[inline(always)]
    fn lane(&self, lane: usize) -> &Own {
        &self.lanes[lane]
    }

    #[inline(always)]
    fn evaluated(&self, slips_m_s: [&Lanes; 2]) -> OwnEvaluated<'_> {
        let [outer, inner] = slips_m_s;
        let first = self.mu(outer);
        let second = match std::ptr::eq(outer, inner) {
            true => first,
            false => self.mu(inner),
        };
        OwnEvaluated {
            lanes: self,
            mu: [first, second],
        }
    }

    fn filled(value: impl Fn(usize) -> Own) -> Self {
        let lanes: [Own; LANES] = std::array::from_fn(value);
        let of = |field: fn(&Own) -> f64| Lanes(std::array::from_fn(|lane| field(&lanes[lane])));
        Self {
            same: lanes.iter().all(|own| own.law == lanes[0].law),
            coefficient: of(|own| own.coefficient),
            inverse_regularisation_speed: of(|own| own.inverse_regularisation_speed),
            lanes,
        }
    }
}

impl Law for &Own {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        (**self).force_with_knee(sliding_m_s, normal_n, inverse_knee_s_m)
    }

    #[inline(always)]
    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        (**self).edge(sliding_m_s)
    }

    knee!();
}

/// [`OwnLanes`] with μ at the sliding speeds of two contacts of each lane.
pub(crate) struct OwnEvaluated<'a> {
    lanes: &'a OwnLanes,
    /// μ and its slope at either contact.
    mu: [[Lanes; 2]; 2],
}

impl EvaluatedLaws for OwnEvaluated<'_> {
    type Law<'l>
        = OwnAt
    where
        Self: 'l;

    #[inline(always)]
    fn lane(&self, lane: usize) -> OwnAt {
        let of = |contact: usize| self.mu[contact].each_ref().map(|values| values.0[lane]);
        OwnAt {
            mu: [of(0), of(1)],
            coefficient: self.lanes.coefficient.0[lane],
            inverse_regularisation_speed: self.lanes.inverse_regularisation_speed.0[lane],
        }
    }
}

/// The law of a lane at the two sliding speeds at which it was evaluated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OwnAt {
    mu: [[f64; 2]; 2],
    coefficient: f64,
    inverse_regularisation_speed: f64,
}

impl Law for OwnAt {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let knee = tanh(sliding_m_s * inverse_knee_s_m);
        at_knee(self.mu[0], knee, normal_n, inverse_knee_s_m)
    }

    #[inline(always)]
    fn forces_with_knees(
        &self,
        slips_m_s: [f64; 2],
        normals_n: [f64; 2],
        inverse_knees_s_m: [f64; 2],
    ) -> [[f64; 2]; 2] {
        let ([s, t], [first, second]) = (slips_m_s, inverse_knees_s_m);
        let [outer, inner] = tanh_pair([s * first, t * second]);
        [
            at_knee(self.mu[0], outer, normals_n[0], first),
            at_knee(self.mu[1], inner, normals_n[1], second),
        ]
    }

    knee!();
}
