//! Closed forms of a rotor in a ring without balls. Each holds for all parameters; those that
//! idealise a rigid contact are met to the order of its compliance, which vanishes with the
//! stiffness.

use std::f64::consts::TAU;

use super::rotor_in_ring::{Coordinate, RingMount, RotorInRing};
use crate::common::drop_case;
use cageless::contact::FrictionParameters;
use cageless::integrator::{Adaptive, Integrator, System};
use cageless::{InnerRingBore, Rotor, Support};

const G: f64 = 9.81;

/// A rotor of 20 kg at rest in the middle of an air gap of 0.25 mm, without damping; its friction
/// has reached μ at a thousandth of the sliding speed.
pub fn rotor() -> Rotor {
    Rotor {
        radial_clearance_m: 2.5e-4,
        contact_damping_s_m: 0.0,
        friction: friction(0.15),
        ..drop_case().rotor.unwrap()
    }
}

/// Smooth friction with its knee at 1 mm/s.
fn friction(coefficient: f64) -> FrictionParameters {
    FrictionParameters::smooth(coefficient, 1e-3)
}

pub fn bore() -> InnerRingBore {
    drop_case().bearing.inner_ring_bore().unwrap()
}

/// A run of `system` with error control.
struct Run {
    system: RotorInRing,
    integrator: Integrator<Adaptive>,
}

impl Run {
    fn new(rotor: &Rotor, mount: RingMount) -> Self {
        let system = RotorInRing::new(rotor, bore(), G, mount);
        let start = system.start(rotor);
        Self::from(system, &start)
    }

    fn from(mut system: RotorInRing, start: &[f64]) -> Self {
        let size = system.dimension();
        let mut integrator = Integrator::new(Adaptive::new(size, 1e-3, 1e-11), size);
        integrator.restart(&mut system, 0.0, start);
        Self { system, integrator }
    }

    /// Advances to the first zero of `f` from below after the start and returns the state there;
    /// `f` sees the state and the system evaluated at it.
    fn until(&mut self, limit_s: f64, f: impl Fn(&[f64], &RotorInRing) -> f64) -> (f64, Vec<f64>) {
        let mut before = f64::NAN;
        loop {
            let start = self.integrator.step().y1.to_vec();
            let start_s = self.integrator.step().t1_s;
            self.integrator.advance(&mut self.system, limit_s).unwrap();
            let step = self.integrator.step();
            let now = f(&step.y1, &self.system);
            if before <= 0.0 && now > 0.0 {
                let end_s = step.t1_s;
                return self.locate(start_s, &start, end_s, &f);
            }
            assert!(step.t1_s < limit_s, "no event before {limit_s} s");
            before = now;
        }
    }

    /// The zero of `f` within a step, by runs of part of it.
    fn locate(
        &self,
        start_s: f64,
        start: &[f64],
        end_s: f64,
        f: &impl Fn(&[f64], &RotorInRing) -> f64,
    ) -> (f64, Vec<f64>) {
        let part = |time_s: f64| {
            let mut run = Self::from(self.system.clone(), start);
            while run.integrator.step().t1_s < time_s - start_s {
                run.integrator
                    .advance(&mut run.system, time_s - start_s)
                    .unwrap();
            }
            run
        };
        let value = |time_s: f64| {
            let run = part(time_s);
            f(&run.integrator.step().y1, &run.system)
        };
        let inside = start_s + 1e-9 * (end_s - start_s);
        let time_s = root(value, inside, end_s);
        (time_s, part(time_s).integrator.step().y1.to_vec())
    }

    fn to(&mut self, time_s: f64) -> &[f64] {
        while self.integrator.step().t1_s < time_s {
            self.integrator.advance(&mut self.system, time_s).unwrap();
        }
        &self.integrator.step().y1
    }
}

pub fn at(state: &[f64], coordinate: Coordinate) -> f64 {
    state[coordinate as usize]
}

/// Root of `f` between two values of different sign, by bisection.
pub fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle).signum() == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

pub fn close(found: f64, expected: f64, relative: f64, what: &str) {
    let error = (found / expected - 1.0).abs();
    println!("{what}: {found} for {expected}, {error:.1e}");
    assert!(
        error < relative,
        "{what}: {found} for {expected}, {error:e}"
    );
}

/// Fall through the gap, and the first impact on a fixed, frictionless, linear ring.
#[test]
fn fall_and_first_impact() {
    let rotor = Rotor {
        friction: friction(0.0),
        ..rotor()
    };
    let gap = rotor.radial_clearance_m;
    let mut run = Run::new(&rotor, RingMount::Fixed);
    let (time_s, state) = run.until(0.1, |_, system| system.contact().contact.deflection);
    close(time_s, (2.0 * gap / G).sqrt(), 1e-9, "time of the fall");
    close(
        -at(&state, Coordinate::Vy),
        (2.0 * G * gap).sqrt(),
        1e-9,
        "its speed",
    );
    assert!((time_s - 7.139e-3).abs() < 1e-6);
    let (_, state) = run.until(0.1, |y, _| at(y, Coordinate::Vy));
    let force = rotor.contact_stiffness_n_mp * (-at(&state, Coordinate::Y) - gap);
    let weight = rotor.mass_kg * G;
    let expected = 1.0 + (1.0 + 2.0 * rotor.contact_stiffness_n_mp * gap / weight).sqrt();
    close(
        force / weight,
        expected,
        1e-9,
        "force of the impact over the weight",
    );
}

/// Pendulum in the clearance of a locked frictionless ring. A rigid ring has 31.527 Hz.
#[test]
fn pendulum_in_the_clearance() {
    for (stiffness, most) in [(1e10, 1e-4), (1e11, 1e-5)] {
        let mut rotor = Rotor {
            friction: friction(0.0),
            contact_stiffness_n_mp: stiffness,
            ..rotor()
        };
        let radius = rotor.radial_clearance_m + rotor.mass_kg * G / stiffness;
        let angle: f64 = 1e-3;
        rotor.radial_clearance_m = 2.5e-4;
        let mut system = RotorInRing::new(&rotor, bore(), G, RingMount::Fixed);
        let mut start = system.start(&rotor);
        start[Coordinate::X as usize] = radius * angle.sin();
        start[Coordinate::Y as usize] = -radius * angle.cos();
        system.derivative(0.0, &start.clone(), &mut vec![0.0; start.len()]);
        let mut run = Run::from(system, &start);
        let crossing = |y: &[f64], _: &RotorInRing| at(y, Coordinate::X);
        let (first, _) = run.until(1.0, crossing);
        let (mut last, periods) = (first, 3);
        for _ in 0..periods {
            last = run.until(1.0, crossing).0;
        }
        let found = f64::from(periods) / (last - first);
        let expected = (G / radius).sqrt() / TAU;
        close(found, expected, most, "frequency of the pendulum");
        assert!((found - 31.527).abs() < 0.02);
    }
}

/// A rotor that rests and slips stands at atan μ from the bottom, towards −X for Ω > 0.
#[test]
fn resting_and_slipping() {
    for speed in [3000.0, -3000.0] {
        let (mut system, state, _) = resting(&Rotor {
            speed_rad_s: speed,
            ..rotor()
        });
        let mut rate = vec![0.0; state.len()];
        system.derivative(0.0, &state, &mut rate);
        let acceleration = at(&rate, Coordinate::Vx).hypot(at(&rate, Coordinate::Vy));
        assert!(acceleration < 1e-6 * G, "{acceleration}");
        let towards = at(&state, Coordinate::X);
        assert!(towards * speed < 0.0);
    }
}

/// The rotor at rest and slipping in a ring whose centre is held, and the normal force.
fn resting(rotor: &Rotor) -> (RotorInRing, Vec<f64>, f64) {
    let system = RotorInRing::new(rotor, bore(), G, RingMount::Turning);
    let angle = rotor.friction.coefficient.atan();
    let normal = rotor.mass_kg * G * angle.cos();
    let radius = rotor.radial_clearance_m + normal / rotor.contact_stiffness_n_mp;
    let mut state = system.start(rotor);
    state[Coordinate::X as usize] = -rotor.speed_rad_s.signum() * radius * angle.sin();
    state[Coordinate::Y as usize] = -radius * angle.cos();
    (system, state, normal)
}

/// Climb in a rigid circle, slipping throughout, from rest at the bottom: the largest angle, or
/// that at which the rotor lifts off, and the error of a compliant ring, which falls with 1/K.
#[test]
fn climb_in_a_rigid_circle() {
    let climb = |friction: f64, stiffness: f64, lifts: bool| {
        let mut rotor = Rotor {
            friction: FrictionParameters::smooth(friction, 1.0),
            contact_stiffness_n_mp: stiffness,
            speed_rad_s: 1e4,
            polar_inertia_kg_m2: 1e4,
            ..rotor()
        };
        rotor.y_m = -rotor.radial_clearance_m;
        let mut system = RotorInRing::new(&rotor, bore(), G, RingMount::Fixed);
        let mut start = system.start(&rotor);
        start[Coordinate::Y as usize] -= rotor.mass_kg * G / stiffness;
        system.derivative(0.0, &start.clone(), &mut vec![0.0; start.len()]);
        let mut run = Run::from(system, &start);
        // Friction drives the rotor towards −X.
        let angle = |y: &[f64]| (-at(y, Coordinate::X)).atan2(-at(y, Coordinate::Y));
        let (_, state) = if lifts {
            run.until(1.0, |_, system| -system.contact().contact.deflection)
        } else {
            run.until(1.0, |y, _| {
                at(y, Coordinate::Vx) * -at(y, Coordinate::Y)
                    + at(y, Coordinate::Vy) * at(y, Coordinate::X)
            })
        };
        angle(&state).to_degrees().rem_euclid(360.0)
    };
    for (friction, expected) in [(0.1, 11.4982), (0.15, 17.3238), (0.3, 35.6223)] {
        let exact = largest_climb_deg(friction);
        assert!((exact - expected).abs() < 6e-5, "{exact} {expected}");
        let errors = [1e10, 1e11].map(|k| (climb(friction, k, false) / exact - 1.0).abs());
        println!(
            "climb, friction {friction}: {exact:.4}°, errors {:.1e} {:.1e}",
            errors[0], errors[1]
        );
        assert!(
            errors[1] < 1e-5 && errors[1] < 0.5 * errors[0],
            "{errors:?}"
        );
    }
    for (friction, expected) in [(0.65, 102.398), (0.705, 140.481)] {
        let found = climb(friction, 1e11, true);
        close(found, expected, 2e-4, "angle of the lift-off");
    }
}

/// The angle at which u = (u0 − A)·e^(2μφ) + A cos φ + B sin φ is 0 again, u0 = 0.
fn largest_climb_deg(friction: f64) -> f64 {
    let mu = friction;
    let a = 2.0 * (1.0 - 2.0 * mu * mu) / (1.0 + 4.0 * mu * mu);
    let b = 6.0 * mu / (1.0 + 4.0 * mu * mu);
    let u = |phi: f64| a * phi.cos() + b * phi.sin() - a * (2.0 * mu * phi).exp();
    root(u, mu, 1.5).to_degrees()
}

/// Spin-up of a ring held at the centre by a rotor that slips at rest on it: time, speed, heat.
#[test]
fn spin_up_of_a_held_ring() {
    let rotor = rotor();
    let (system, state, normal) = resting(&rotor);
    let bore = bore();
    let journal = bore.radius_m - rotor.radial_clearance_m;
    let slip = rotor.speed_rad_s * journal;
    let mass = 1.0
        / (journal.powi(2) / rotor.polar_inertia_kg_m2
            + bore.radius_m.powi(2) / bore.polar_inertia_kg_m2);
    let mut run = Run::from(system, &state);
    // Friction is constant until the slip is near its scale: 1 % of the slip is left.
    let (time_s, end) = run.until(2.0, |_, s| 0.01 * slip - s.contact().contact.slip);
    let friction = rotor.friction.coefficient * normal;
    close(
        time_s,
        0.99 * mass * slip / friction,
        1e-6,
        "time of the spin-up",
    );
    let ring_speed = 0.99 * bore.radius_m * mass * slip / bore.polar_inertia_kg_m2;
    close(
        at(&end, Coordinate::RingSpeed),
        ring_speed,
        1e-6,
        "speed of the ring",
    );
    let heat = (1.0 - 1e-4) * 0.5 * mass * slip * slip;
    close(
        at(&end, Coordinate::FrictionHeat),
        heat,
        1e-6,
        "heat of the spin-up",
    );
}

/// Whatever the path and the bouncing: the spin energy that is lost is heat of friction and of
/// damping and orbital energy, and with nearly equal radii ½·Je·Ω0².
#[test]
fn spin_energy_goes_into_heat() {
    let rotor = Rotor {
        radial_clearance_m: 1e-6,
        speed_rad_s: 300.0,
        contact_damping_s_m: 0.3,
        ..rotor()
    };
    let bore = bore();
    let mut run = Run::new(&rotor, RingMount::Turning);
    let start = run.integrator.step().y1.to_vec();
    let before = run.system.energy_j(&start);
    let end = run.to(0.08).to_vec();
    let heat = at(&end, Coordinate::FrictionHeat) + at(&end, Coordinate::DampingHeat);
    let change = before - run.system.energy_j(&end);
    close(heat, change, 1e-8, "heat");
    let spin = |state: &[f64]| {
        0.5 * rotor.polar_inertia_kg_m2 * at(state, Coordinate::Speed).powi(2)
            + 0.5 * bore.polar_inertia_kg_m2 * at(state, Coordinate::RingSpeed).powi(2)
    };
    let equal = bore.polar_inertia_kg_m2 * rotor.polar_inertia_kg_m2
        / (bore.polar_inertia_kg_m2 + rotor.polar_inertia_kg_m2);
    let expected = 0.5 * equal * rotor.speed_rad_s.powi(2);
    // The radii differ by 7e-5.
    close(
        spin(&start) - spin(&end),
        expected,
        5e-4,
        "spin energy lost",
    );
}

/// Balls that roll add N[m Rm²(Ωb/ωi)² + J(ωb/ωi)²] to the inertia of the ring.
#[test]
fn rolling_balls_add_to_the_inertia_of_the_ring() {
    let case = drop_case();
    let bearing = &case.bearing;
    let orbit =
        cageless::kinematics::rolling_orbit_speed_rad_s(bearing, 1.0, bearing.ball_radius_m());
    let spin =
        cageless::kinematics::rolling_rotation_rad_s(bearing, orbit, bearing.ball_radius_m());
    assert!((orbit - 0.396479).abs() < 1e-6 && (spin - 1.914961).abs() < 1e-6);
    let one = bearing.ball_mass_kg() * (bearing.pitch_radius_m() * orbit).powi(2)
        + bearing.ball_inertia_kg_m2() * spin.powi(2);
    close(14.0 * one, 5.790405e-6, 1e-6, "inertia of the balls");
}

/// Steady slipping backward whirl of a free rotor in a ring that cannot turn and rides on a damped
/// support: frequency and force, and the orbit attracts.
#[test]
fn backward_whirl_on_a_damped_support() {
    let rotor = Rotor {
        mass_kg: 10.0,
        polar_inertia_kg_m2: 1e6,
        speed_rad_s: 1e4,
        ..rotor()
    };
    let support = Support {
        mass_kg: 0.05,
        stiffness_n_m: 2e7,
        damping_n_s_m: 4e3,
        stop: None,
    };
    let (m, mu, gap) = (
        rotor.mass_kg,
        rotor.friction.coefficient,
        rotor.radial_clearance_m,
    );
    let c = support.damping_n_s_m;
    let d = |w: f64| support.stiffness_n_m - support.mass_kg * w * w;
    let balance =
        |w: f64| mu * (d(w).powi(2) + (c * w).powi(2) - m * w * w * d(w)) - m * c * w.powi(3);
    let whirl = root(balance, 100.0, 2000.0);
    let (d, cw) = (d(whirl), c * whirl);
    let square = d * d + cw * cw;
    let force = gap
        / ((1.0 + mu * mu) * (1.0 / (m * whirl * whirl) - d / square)
            - 1.0 / rotor.contact_stiffness_n_mp);
    close(whirl, 953.630988, 1e-9, "whirl of the formula");
    close(force, 4032.24127, 1e-8, "force of the formula");
    for inside in [1.0, 0.98] {
        let system = RotorInRing::new(&rotor, bore(), 0.0, RingMount::Supported(support.clone()));
        let mut start = system.start(&rotor);
        // n along +X at t = 0, turning clockwise: z = (a + ib)·e^(−iωt), ż = −iω·z.
        let mut set = |places: [Coordinate; 4], a: f64, b: f64| {
            for (place, value) in places.into_iter().zip([a, b, whirl * b, -whirl * a]) {
                start[place as usize] = value * inside;
            }
        };
        use Coordinate::{RingVx, RingVy, RingX, RingY, Vx, Vy, X, Y};
        let radius = force / (m * whirl * whirl);
        set([X, Y, Vx, Vy], radius, mu * radius);
        // (1 + iμ)·F/(D − icω)
        let (a, b) = (
            force * (d - mu * cw) / square,
            force * (cw + mu * d) / square,
        );
        set([RingX, RingY, RingVx, RingVy], a, b);
        let mut run = Run::from(system, &start);
        let settle_s = if inside == 1.0 { 0.01 } else { 0.1 };
        run.to(settle_s);
        let y = run.integrator.step().y1.to_vec();
        let speed = (at(&y, X) * at(&y, Vy) - at(&y, Y) * at(&y, Vx))
            / (at(&y, X).powi(2) + at(&y, Y).powi(2));
        let found = run.system.contact().contact.force;
        let most = if inside == 1.0 { 1e-6 } else { 5e-3 };
        close(-speed, whirl, most, "whirl");
        close(found, force, most, "its force");
    }
}

/// Rolling limit of dry whirl in a rigid ring: backward at Ω·Rj/r0, where nothing slides.
#[test]
fn rolling_limit_of_dry_whirl() {
    let rotor = Rotor {
        friction: friction(0.3),
        ..rotor()
    };
    let journal = bore().radius_m - rotor.radial_clearance_m;
    let whirl = -rotor.speed_rad_s * journal / rotor.radial_clearance_m;
    let mut system = RotorInRing::new(&rotor, bore(), 0.0, RingMount::Fixed);
    let mut state = system.start(&rotor);
    state[Coordinate::X as usize] = rotor.radial_clearance_m;
    state[Coordinate::Vy as usize] = whirl * rotor.radial_clearance_m;
    system.derivative(0.0, &state.clone(), &mut vec![0.0; state.len()]);
    let slip = system.contact().contact.slip;
    assert!(slip.abs() < 1e-9 * rotor.speed_rad_s * journal, "{slip}");
}
