//! Damped Hertzian normal forces.

use std::f64::consts::PI;

use super::positive;

/// Normal force of a damped Hertz contact, N, and the power that the damping dissipates, W.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NormalForce {
    /// F, never below 0: surfaces do not pull.
    pub force_n: f64,
    /// (F − K δ^(3/2))·dδ/dt. Elastic energy that the clamp at 0 withholds counts as damping.
    pub damping_power_w: f64,
}

impl NormalForce {
    /// Contact with a raceway: F = max(0, K δ^(3/2) + c √δ·dδ/dt) for a deflection δ ≥ 0 in m,
    /// its rate in m/s, K in N·m^(−3/2), c in N·s·m^(−3/2).
    #[inline(always)]
    pub(crate) fn at_raceway(stiffness: f64, damping: f64, deflection: f64, rate: f64) -> Self {
        let root = deflection.sqrt();
        Self::damped(stiffness * deflection * root, damping * root, rate)
    }

    /// Contact between balls: F = max(0, K δ^(3/2) + α √(m K)·δ^(1/4)·dδ/dt), `damping` being
    /// α √(m K) with α of [`restitution_damping`] and m the reduced mass.
    #[inline(always)]
    pub(crate) fn between_balls(stiffness: f64, damping: f64, deflection: f64, rate: f64) -> Self {
        let root = deflection.sqrt();
        Self::damped(stiffness * deflection * root, damping * root.sqrt(), rate)
    }

    #[inline(always)]
    fn damped(elastic: f64, damping: f64, rate: f64) -> Self {
        let force = positive(elastic + damping * rate);
        Self {
            force_n: force,
            damping_power_w: (force - elastic) * rate,
        }
    }
}

/// α(e) of the damped force between balls, K δ^(3/2) + α √(m K) δ^(1/4) dδ/dt, that
/// gives coefficient of restitution e: α = −√5·ln e/√(π² + ln² e)
/// (Tsuji, Tanaka & Ishida 1992, Powder Technology 71, 239–250, in closed form).
///
/// Exact while the force may pull; clamped at zero it restores a little more
/// (e = 0.5 gives 0.55, e = 0.95 gives 0.9505).
pub(crate) fn restitution_damping(restitution: f64) -> f64 {
    let log = restitution.ln();
    // The sign keeps −0 out for e = 1.
    (5f64.sqrt() * log.abs()) / PI.hypot(log)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_loss_at_full_restitution() {
        assert_eq!(restitution_damping(1.0), 0.0);
        assert!((restitution_damping(0.5) - 0.4816).abs() < 1e-3);
    }

    /// A contact that opens faster than the damping lets it must not pull.
    #[test]
    fn the_force_never_pulls() {
        let f = NormalForce::at_raceway(1e10, 2e5, 1e-6, -10.0);
        assert_eq!(f.force_n, 0.0);
        assert!(f.damping_power_w > 0.0);
    }
}
