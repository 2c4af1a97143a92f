//! The impact of a falling rotor on journal and shoulder: what the limits of steps allow for.

use super::journal::RotorContact;
use crate::case::Case;
use crate::rotor::{Rotor, Shaft};
use crate::world::body::inner_ring::InnerRing;
use crate::world::body::outer_ring::OuterRing;
use crate::world::body::rigid_rotor::RigidRotor;
use crate::world::under_rotor::UnderRotor;

/// Sine of the contact angle under which balls without clearance bear an axial load at least: they are
/// wedged to it.
const LEAST_SINE: f64 = 0.1;

/// Largest loads of the first impact; nothing without a rotor.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Impact {
    /// Whether a rotor falls.
    pub falls: bool,
    /// Peak force of the first impact and of the unbalance, N.
    pub force_n: f64,
    /// Radial load under which a ball bears what it does under the peak along the axis of a rotor that a
    /// shoulder stops, N.
    pub axial_as_radial_n: f64,
    /// Stiffness of the contact of rotor and inner ring under it, N/m.
    pub contact_n_m: f64,
    /// Damping of that contact, N·s/m.
    pub contact_n_s_m: f64,
    /// Decay of the slip of the rotor by friction, 1/s; 0 under Coulomb's law.
    pub friction_1_s: f64,
    /// Growth of the slip of the rotor where friction falls with it, 1/s.
    pub falling_1_s: f64,
}

/// Springs in series below a rotor.
struct Springs<'a> {
    case: &'a Case,
    rotor: &'a Rotor,
    /// Compliance of the support, m/N.
    soft: f64,
}

/// Fall of a rotor.
struct Fall {
    /// W, N.
    load: f64,
    /// E, J.
    energy: f64,
    /// Further force on the contact at the peak, N.
    more: f64,
}

impl Fall {
    /// That to the bottom of the air gap, with the unbalance.
    fn to_bottom(rotor: &Rotor, weight: f64) -> Self {
        let height = match rotor.shaft {
            Shaft::Horizontal => rotor.journal_start_m()[1] + rotor.radial_clearance_m,
            Shaft::Vertical => 0.0,
        };
        Self {
            load: weight,
            energy: 0.5 * rotor.mass_kg * (rotor.vx_m_s.powi(2) + rotor.vy_m_s.powi(2))
                + weight * height.max(0.0),
            more: rotor.mass_kg * rotor.eccentricity_m * rotor.speed_rad_s.powi(2),
        }
    }
}

/// Springs on which a rotor lands.
struct Landing {
    /// Stiffness of the contact of journal and bore, or of shoulder and face, N/m.
    contact: f64,
    /// Stiffness of the contacts of the balls, N/m.
    balls: f64,
}

impl Springs<'_> {
    /// dF/dδ of the contact of journal and bore under a force, N/m.
    fn contact(&self, force: f64) -> f64 {
        let (k, p) = (
            self.rotor.contact_stiffness_n_mp,
            self.rotor.contact_exponent,
        );
        p * k.powf(1.0 / p) * force.powf(1.0 - 1.0 / p)
    }

    /// dF/dδ of a ball between both raceways under a force, N/m.
    fn ball(&self, own: f64) -> f64 {
        let [inner, outer, _] = self.case.stiffness_n_m1_5();
        let one = |k: f64| 1.5 * k.powf(2.0 / 3.0) * own.cbrt();
        1.0 / (1.0 / one(inner) + 1.0 / one(outer))
    }

    /// Peak force of a fall onto springs, N: F = W + √(W² + 2·k·E), and `more`.
    fn peak(&self, fall: &Fall, springs: Landing) -> f64 {
        let (load, energy) = (fall.load, fall.energy);
        let series = 1.0 / (1.0 / springs.contact + 1.0 / springs.balls + self.soft);
        load + (load * load + 2.0 * series * energy).sqrt() + fall.more
    }
}

impl Impact {
    /// The rotor falls to the bottom of the air gap onto the springs of its contact and of the
    /// balls, of which so many carry the ring, in series with the support.
    pub(crate) fn of_case(case: &Case, carrying: f64) -> Self {
        let ring = InnerRing {
            mass: case.bearing.dimensions().inner_ring_mass_kg,
            ..InnerRing::default()
        };
        let under = UnderRotor::of_case(case, ring, OuterRing::default());
        let Some((rotor, under)) = case.rotor.as_ref().zip(under) else {
            return Self::default();
        };
        let support_n_m = case.support.as_ref().map_or(0.0, |support| {
            support.stiffness_n_m + support.stop.map_or(0.0, |stop| stop.stiffness_n_m)
        });
        let soft = if support_n_m > 0.0 {
            1.0 / support_n_m
        } else {
            0.0
        };
        let springs = Springs { case, rotor, soft };
        let weight = rotor.mass_kg * case.operation.gravity_m_s2;
        let fall = Fall::to_bottom(rotor, weight);
        let balls = |force: f64| carrying * springs.ball(case.preload_n() + force / carrying);
        let mut force = weight.max(1.0);
        for _ in 0..4 {
            let landing = Landing {
                contact: springs.contact(force),
                balls: balls(force),
            };
            force = springs.peak(&fall, landing);
        }
        let rigid = RigidRotor::of_case(rotor, case).compliance();
        let mobility = (under.joint).slip_mobility(&rigid, &under.ring, &RotorContact::below());
        let law = rotor.friction_law;
        let friction_1_s = if law.sticks() {
            0.0
        } else {
            law.coefficient_max(&rotor.friction) * force * mobility
                / rotor.friction.regularisation_speed_m_s
        };
        let speed = (2.0 * fall.energy / rotor.mass_kg).sqrt();
        let (k, p) = (rotor.contact_stiffness_n_mp, rotor.contact_exponent);
        let depth = (force / k).powf(1.0 / p);
        Self {
            falls: true,
            force_n: force,
            axial_as_radial_n: axial_as_radial_n(&springs, weight),
            contact_n_m: springs.contact(force) * (1.0 + 1.5 * rotor.contact_damping_s_m * speed),
            contact_n_s_m: 1.5 * rotor.contact_damping_s_m * k * depth.powf(p),
            friction_1_s,
            falling_1_s: law.steepest_fall(&rotor.friction) * force * mobility,
        }
    }
}

/// Radial load that presses a ball as the peak along the axis does, N: a row under a radial load F presses a
/// ball with 5 F/N, and all balls of a row share an axial load at their contact angle.
fn axial_as_radial_n(springs: &Springs<'_>, weight: f64) -> f64 {
    let (case, rotor) = (springs.case, springs.rotor);
    let sine = case.bearing.free_contact_angle_rad().sin().max(LEAST_SINE);
    let row = case.bearing.balls() as f64 * sine;
    // Thrust and weight take the rotor through its axial clearance, at most from the other shoulder.
    let thrust = match rotor.shaft {
        Shaft::Horizontal => rotor.axial_load_n.abs(),
        Shaft::Vertical => (rotor.axial_load_n - weight).abs(),
    };
    let mut along_axis = thrust;
    if let Some(clearance) = rotor.axial_clearance_m {
        let fall = Fall {
            load: thrust,
            energy: 0.5 * rotor.mass_kg * rotor.vz_m_s.powi(2)
                + thrust * (clearance + rotor.z_m.abs()),
            more: 0.0,
        };
        for _ in 0..4 {
            let balls = row * sine * springs.ball(case.axial_preload_n() + along_axis / row);
            let onto = Landing {
                contact: springs.contact(along_axis.max(1.0)),
                balls,
            };
            along_axis = springs.peak(&fall, onto);
        }
    }
    0.2 * along_axis / sine
}
