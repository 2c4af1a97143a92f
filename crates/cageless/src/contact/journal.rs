//! Contact between the journal of a rotor and the bore of the inner ring.

use super::{Friction, positive};

/// Constants of the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Journal {
    /// Rj, radius of the journal, m.
    pub radius: f64,
    /// Rb, radius of the bore, m.
    pub bore_radius: f64,
    /// r0 = Rb − Rj, m.
    pub radial_clearance: f64,
    /// K, N/m^p.
    pub stiffness: f64,
    /// p.
    pub exponent: f64,
    /// α, s/m.
    pub damping: f64,
}

/// Motion of the centre of a journal or bore and the speed at which it turns.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct JournalMotion {
    /// x, m.
    pub x: f64,
    /// y, m.
    pub y: f64,
    /// ẋ, m/s.
    pub vx: f64,
    /// ẏ, m/s.
    pub vy: f64,
    /// Speed, rad/s, counter-clockwise.
    pub speed: f64,
}

/// Contact of journal and bore without its friction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct JournalContact {
    /// δ, m; negative: apart.
    pub deflection: f64,
    /// dδ/dt, m/s.
    pub rate: f64,
    /// Normal force, N.
    pub force: f64,
    /// Sliding speed of the journal on the bore along t, m/s.
    pub slip: f64,
    /// x of the unit vector n from the centre of the bore to that of the journal; t is n turned
    /// by +90°.
    pub nx: f64,
    /// y of n.
    pub ny: f64,
    /// Power dissipated by damping, W.
    pub damping_power: f64,
}

/// Deflection, normal force and sliding speed between journal and bore.
///
/// With ρ = zr − zi, n = ρ/|ρ| and t = i·n, δ = |ρ| − r0 and F = max(0, K δ^p (1 + 1.5 α δ̇))
/// (Hunt & Crossley 1975, J. Appl. Mech. 42, 440–445); the surfaces slide at
/// t·(żr − żi) + Ω·Rj − ωi·Rb. Elastic energy that the clamp at 0 withholds counts as damping.
#[inline(always)]
pub(crate) fn journal_contact(
    constants: &Journal,
    rotor: &JournalMotion,
    ring: &JournalMotion,
) -> JournalContact {
    let (x, y) = (rotor.x - ring.x, rotor.y - ring.y);
    let distance = (x * x + y * y).sqrt();
    // Concentric: no direction, and no contact.
    let (nx, ny) = if distance > 0.0 {
        (x / distance, y / distance)
    } else {
        (0.0, -1.0)
    };
    let (vx, vy) = (rotor.vx - ring.vx, rotor.vy - ring.vy);
    let rate = vx * nx + vy * ny;
    let deflection = distance - constants.radial_clearance;
    let [force, damping_power] = constants.normal(deflection, rate);
    JournalContact {
        deflection,
        rate,
        force,
        slip: journal_slip(constants, [nx, ny], rotor, ring),
        nx,
        ny,
        damping_power,
    }
}

impl Journal {
    /// F, N, and the power that damping takes out, W, at a deflection and its rate.
    #[inline(always)]
    pub(crate) fn normal(&self, deflection: f64, rate: f64) -> [f64; 2] {
        let elastic = self.stiffness * power(positive(deflection), self.exponent);
        let force = positive(elastic * (1.0 + 1.5 * self.damping * rate));
        [force, (force - elastic) * rate]
    }
}

/// t·(żr − żi) + Ω·Rj − ωi·Rb, m/s, with n = `normal`.
#[inline(always)]
pub(crate) fn journal_slip(
    constants: &Journal,
    normal: [f64; 2],
    rotor: &JournalMotion,
    ring: &JournalMotion,
) -> f64 {
    let [nx, ny] = normal;
    let (vx, vy) = (rotor.vx - ring.vx, rotor.vy - ring.vy);
    vy * nx - vx * ny + rotor.speed * constants.radius - ring.speed * constants.bore_radius
}

/// Energy stored at a deflection, K δ^(p+1)/(p+1), J.
pub(crate) fn journal_energy_j(constants: &Journal, deflection_m: f64) -> f64 {
    let (depth, p) = (positive(deflection_m), constants.exponent);
    constants.stiffness * depth * power(depth, p) / (p + 1.0)
}

/// δ^p; the conformal and the Hertzian exponent without logarithms.
#[inline(always)]
fn power(depth: f64, exponent: f64) -> f64 {
    if exponent == 1.0 {
        depth
    } else if exponent == 1.5 {
        depth * depth.sqrt()
    } else if depth > 0.0 {
        depth.powf(exponent)
    } else {
        0.0
    }
}

impl JournalContact {
    /// Force of the ring on the journal under the friction `friction_n` along −slip, N: −F·n − f·t.
    #[inline(always)]
    pub(crate) fn force_on_journal(&self, friction_n: f64) -> [f64; 2] {
        [
            -self.force * self.nx + friction_n * self.ny,
            -self.force * self.ny - friction_n * self.nx,
        ]
    }
}

/// Sliding of a journal and the friction that belongs to it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct JournalSlip {
    /// Sliding speed, m/s.
    pub slip: f64,
    /// Friction along −slip, N.
    pub friction: f64,
    /// Slope of the friction over the sliding speed, N·s/m; 0 under laws that stick.
    pub slope: f64,
}

impl JournalSlip {
    /// Friction at a sliding speed under the normal force `normal_n`.
    #[inline(always)]
    pub(crate) fn at(slip: f64, law: &Friction, normal_n: f64) -> Self {
        let [friction, slope] = law.force(slip, normal_n);
        Self {
            slip,
            friction,
            slope,
        }
    }
}

/// Sliding of one contact at the end of a step: s = s_free − H·f(s).
///
/// Friction opposes the sliding that is left without it, so that s lies between 0 and s_free;
/// Newton's method within that interval from `guess`, halved where a step leaves it. Coulomb's
/// law exactly.
#[inline(always)] // into callers compiled for wider vectors
pub(crate) fn implicit_slip(
    law: &Friction,
    free_m_s: f64,
    mobility: f64,
    normal_n: f64,
    guess: JournalSlip,
) -> JournalSlip {
    if normal_n <= 0.0 {
        return JournalSlip {
            slip: free_m_s,
            ..JournalSlip::default()
        };
    }
    let [slip, slope] = if law.sticks() {
        let sliding = free_m_s.abs() - mobility * law.coefficient() * normal_n;
        [sliding.max(0.0).copysign(free_m_s), 0.0]
    } else {
        newton(law, free_m_s, mobility, normal_n, guess)
    };
    // Sliding speed and force belong together exactly.
    let friction = (free_m_s - slip) / mobility;
    JournalSlip {
        slip,
        friction,
        slope,
    }
}

/// Sliding speed and slope of the friction at the end of a step.
#[inline(always)]
fn newton(
    law: &Friction,
    free_m_s: f64,
    mobility: f64,
    normal_n: f64,
    guess: JournalSlip,
) -> [f64; 2] {
    let [mut low, mut high] = [free_m_s.min(0.0), free_m_s.max(0.0)];
    let mut at = guess;
    for _ in 0..ITERATIONS_MAX {
        let miss = at.slip + mobility * at.friction - free_m_s;
        if miss > 0.0 {
            high = high.min(at.slip);
        } else {
            low = low.max(at.slip);
        }
        let next = at.slip - miss / (1.0 + mobility * at.slope);
        if (next - at.slip).abs() * law.inverse_regularisation_speed() <= EXACT {
            return [next, at.slope];
        }
        let within = next > low && next < high;
        at = JournalSlip::at(
            if within { next } else { 0.5 * (low + high) },
            law,
            normal_n,
        );
    }
    [at.slip, at.slope]
}

/// Newton step at which the sliding speed is exact, as a fraction of the slip scale.
const EXACT: f64 = 1e-6;
/// More than bisection alone needs.
const ITERATIONS_MAX: u32 = 100;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{FrictionModel, FrictionParameters, FrictionTable};

    const JOURNAL: Journal = Journal {
        radius: 14.8e-3,
        bore_radius: 15e-3,
        radial_clearance: 2e-4,
        stiffness: 1e9,
        exponent: 1.25,
        damping: 0.3,
    };

    #[test]
    fn journals_that_part_quickly_are_not_pulled() {
        let rotor = JournalMotion {
            x: 2.1e-4,
            vx: -10.0,
            ..JournalMotion::default()
        };
        let contact = journal_contact(&JOURNAL, &rotor, &JournalMotion::default());
        assert_eq!(contact.force, 0.0);
        assert!(contact.damping_power > 0.0);
        let apart = JournalMotion::default();
        let contact = journal_contact(&JOURNAL, &apart, &apart);
        assert_eq!((contact.force, contact.damping_power), (0.0, 0.0));
    }

    /// The friction of every law belongs to the sliding speed at the end of the step.
    #[test]
    fn slip_at_the_end_belongs_to_its_friction() {
        let table = FrictionTable::new(vec![[0.0, 0.25], [0.1, 0.2], [2.0, 0.15]]).unwrap();
        let friction = |law| {
            let parameters = FrictionParameters {
                static_coefficient: Some(0.25),
                stribeck_speed_m_s: Some(0.1),
                table: Some(table.clone()),
                ..FrictionParameters::smooth(0.15, 1e-3)
            };
            Friction::new(law, &parameters, 0.0)
        };
        for law in [
            FrictionModel::Smooth,
            FrictionModel::Stribeck,
            FrictionModel::Table,
        ] {
            let friction = friction(law);
            for free in [-40.0, -0.1, -1e-4, 0.0, 1e-3, 0.3, 46.0] {
                for mobility in [1e-7, 1e-5, 1e-3] {
                    for guess in [-50.0, 0.0, 0.9 * free, free] {
                        let guess = JournalSlip::at(guess, &friction, 2000.0);
                        let end = implicit_slip(&friction, free, mobility, 2000.0, guess);
                        let [expected, _] = friction.force(end.slip, 2000.0);
                        let miss = (end.friction - expected).abs();
                        assert!(miss < 1e-6 * 500.0, "{free} {mobility} {guess:?}");
                    }
                }
            }
        }
        let law = friction(FrictionModel::Coulomb);
        let coulomb = |free| {
            let end = implicit_slip(&law, free, 1e-5, 2000.0, JournalSlip::default());
            [end.slip, end.friction]
        };
        assert_eq!(coulomb(2e-3), [0.0, 200.0]);
        assert_eq!(coulomb(-4e-3), [-1e-3, -300.0]);
    }

    /// The elastic force is the derivative of the energy.
    #[test]
    fn energy_belongs_to_the_force() {
        for exponent in [1.0, 1.2, 1.5] {
            let journal = Journal {
                exponent,
                ..JOURNAL
            };
            let force = |depth: f64| {
                let rotor = JournalMotion {
                    y: -(journal.radial_clearance + depth),
                    ..JournalMotion::default()
                };
                journal_contact(&journal, &rotor, &JournalMotion::default()).force
            };
            let h = 1e-9;
            let [above, below] = [1e-5 + h, 1e-5 - h].map(|d| journal_energy_j(&journal, d));
            let slope = (above - below) / (2.0 * h);
            assert!((slope / force(1e-5) - 1.0).abs() < 1e-6);
        }
    }
}
