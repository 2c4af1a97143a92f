//! Full annular rub of a rotor on a shaft.

use super::rotor_in_ring::{Coordinate, RingMount, RotorInRing};
use super::touchdown_exact::{at, bore, close, root, rotor};
use cageless::integrator::{Adaptive, Integrator, System};
use cageless::{FrictionParameters, Rotor};

/// A rotor on a shaft in a fixed ring: the equations of [`RotorInRing`] with the forces of the
/// shaft on the journal, at constant speed.
#[derive(Clone)]
struct OnShaft {
    inner: RotorInRing,
    mass: f64,
    stiffness: f64,
    damping: f64,
    eccentricity: f64,
}

impl System for OnShaft {
    fn dimension(&self) -> usize {
        self.inner.dimension()
    }

    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.inner.derivative(time_s, y, dydt);
        let (sin, cos) = at(y, Coordinate::Angle).sin_cos();
        let speed = at(y, Coordinate::Speed);
        let (ex, ey) = (self.eccentricity * cos, self.eccentricity * sin);
        let x = at(y, Coordinate::X) - ex;
        let v = at(y, Coordinate::Vx) + speed * ey;
        dydt[Coordinate::Vx as usize] -= (self.stiffness * x + self.damping * v) / self.mass;
        let x = at(y, Coordinate::Y) - ey;
        let v = at(y, Coordinate::Vy) - speed * ex;
        dydt[Coordinate::Vy as usize] -= (self.stiffness * x + self.damping * v) / self.mass;
        dydt[Coordinate::Speed as usize] = 0.0;
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        self.inner.error_norm(difference)
    }
}

/// Full annular synchronous rub of a rotor on a shaft against a fixed ring.
#[test]
fn full_annular_rub() {
    let rotor = Rotor {
        mass_kg: 10.0,
        contact_stiffness_n_mp: 2e7,
        friction: FrictionParameters::smooth(0.05, 1e-4),
        eccentricity_m: 4e-4,
        speed_rad_s: 500.0,
        polar_inertia_kg_m2: 1e3,
        ..rotor()
    };
    let (m, k, c) = (rotor.mass_kg, 1e6, 4e3);
    let (stiff, mu, gap, speed) = (
        rotor.contact_stiffness_n_mp,
        rotor.friction.coefficient,
        rotor.radial_clearance_m,
        rotor.speed_rad_s,
    );
    let unbalance = m * rotor.eccentricity_m * speed * speed;
    let excess = |r: f64| {
        let along = (k + stiff - m * speed * speed) * r - stiff * gap;
        let across = (c * speed + mu * stiff) * r - mu * stiff * gap;
        along.hypot(across) - unbalance
    };
    let radius = root(excess, gap, 10.0 * gap);
    let mut system = OnShaft {
        inner: RotorInRing::new(&rotor, bore(), 0.0, RingMount::Fixed),
        mass: m,
        stiffness: k,
        damping: c,
        eccentricity: rotor.eccentricity_m,
    };
    let mut start = system.inner.start(&rotor);
    // The journal on the orbit, lagging behind the unbalance.
    let along = (k + stiff - m * speed * speed) * radius - stiff * gap;
    let across = (c * speed + mu * stiff) * radius - mu * stiff * gap;
    let lag = across.atan2(along);
    let (jx, jy) = (radius * (-lag).cos(), radius * (-lag).sin());
    for (coordinate, value) in [
        (Coordinate::X, jx + rotor.eccentricity_m),
        (Coordinate::Y, jy),
        (Coordinate::Vx, -speed * jy),
        (Coordinate::Vy, speed * (jx + rotor.eccentricity_m)),
    ] {
        start[coordinate as usize] = value;
    }
    let size = system.dimension();
    let mut integrator = Integrator::new(Adaptive::new(size, 1e-4, 1e-12), size);
    integrator.restart(&mut system, 0.0, &start);
    while integrator.step().t1_s < 0.05 {
        integrator.advance(&mut system, 0.05).unwrap();
    }
    let y = &integrator.step().y1;
    let (sin, cos) = at(y, Coordinate::Angle).sin_cos();
    let found = (at(y, Coordinate::X) - rotor.eccentricity_m * cos)
        .hypot(at(y, Coordinate::Y) - rotor.eccentricity_m * sin);
    close(found, radius, 1e-6, "radius of the orbit");
    assert!(system.inner.contact().contact.force > 0.0);
}
