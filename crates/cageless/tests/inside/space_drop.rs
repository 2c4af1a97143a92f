//! A rotor that falls in space: onto rows with preload, and along a vertical axis.

use std::sync::Arc;

use cageless::dynamics::coordinates::{
    BallCoordinate, BodyCoordinate, OuterRingCoordinate, RingCoordinate, RotorCoordinate,
};
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::state::State;
use cageless::dynamics::world::World;
use cageless::dynamics::{Model, RightHandSide};
use cageless::initial_conditions::initial_state;
use cageless::integrator::System;
use cageless::simulation::{Control, Ending, RunOutcome, run};
use cageless::time_table::TimeTable;
use cageless::touchdown::{DropRecorder, DropSummary, EndState};
use cageless::{
    Bearing, Case, FrictionModel, IntegrationMethod, Motion, Rotor, Row, Shaft, SupportStop, Tilt,
};

use crate::common::{complete, drop_case, raceway, steel};

/// The coordinates of a drop in the plane beyond those of the inner ring.
fn of_drop() -> [BodyCoordinate; 11] {
    [
        RingCoordinate::Speed.into(),
        OuterRingCoordinate::X.into(),
        OuterRingCoordinate::Y.into(),
        OuterRingCoordinate::Vx.into(),
        OuterRingCoordinate::Vy.into(),
        RotorCoordinate::X.into(),
        RotorCoordinate::Y.into(),
        RotorCoordinate::Angle.into(),
        RotorCoordinate::Vx.into(),
        RotorCoordinate::Vy.into(),
        RotorCoordinate::Speed.into(),
    ]
}

/// Places of what a drop has in the plane, in the vector of a state.
fn planar_places(state: &State) -> Vec<usize> {
    let layout = state.layout();
    let balls = BallCoordinate::ALL.into_iter();
    let balls = balls.flat_map(|c| (0..layout.balls).map(move |k| layout.ball(c, k)));
    let ring = RingCoordinate::ALL.map(|c| layout.ring(c));
    let bodies = of_drop().map(|c| layout.body(c));
    let terms = EnergyTerm::ALL.map(|term| layout.energy_term(term));
    balls.chain(ring).chain(bodies).chain(terms).collect()
}

fn in_space(mut case: Case) -> Case {
    case.motion = Motion::Space;
    case
}

pub fn rotor(case: &mut Case) -> &mut Rotor {
    case.rotor.as_mut().unwrap()
}

/// A rotor just above contact with the speed of its fall, with unbalance, a stop and a soft contact.
fn rough() -> Case {
    let mut case = drop_case();
    let r = rotor(&mut case);
    (r.y_m, r.vy_m_s) = (-0.96 * r.radial_clearance_m, -0.0625);
    (r.eccentricity_m, r.eccentricity_phase_rad) = (5e-6, 0.7);
    r.drive_torque_n_m = -2.0;
    // No factor has its default, and no two balls are alike.
    case.contact.outer_friction_factor = 0.6;
    case.contact.ball_friction_factor = 2.5;
    let deviations = (0..14).map(|k| 1e-7 * ((k * 5 % 7) as f64 - 3.0));
    case.bearing = (case
        .bearing
        .with_ball_radius_deviations(deviations.collect()))
    .unwrap();
    case.support.as_mut().unwrap().stop = Some(SupportStop {
        gap_m: 3e-5,
        stiffness_n_m: 1e8,
    });
    case.solver.duration_s = 3e-3;
    case
}

/// Without shoulders, axial load and raceway every rate of the plane is one in space.
#[test]
fn a_drop_onto_a_plain_ring_has_the_rates_of_the_plane() {
    let mut planar = rough();
    planar.set_method(IntegrationMethod::VelocityVerlet);
    // In the middle of the impact.
    planar.solver.duration_s = 5e-4;
    let spatial = in_space(planar.clone());
    let flat = complete(&planar).state;
    let (outer, ring) = (flat.outer_ring_motion(), flat.ring_speed_rad_s().unwrap());
    assert!(outer.y < -1e-7 && ring > 1.0, "{outer:?} {ring}");
    let (mut lifted, _) = initial_state(&spatial).unwrap();
    let places = planar_places(&flat).into_iter().zip(planar_places(&lifted));
    let places: Vec<_> = places.collect();
    for (from, to) in &places {
        lifted.values_mut()[*to] = flat.values()[*from];
    }
    let rates = |case: &Case, state: &State| {
        let model = Model::new(case).unwrap();
        (rates_of(&model, state), model.energy_j(state))
    };
    let ((flat, flat_j), (lifted, lifted_j)) = (rates(&planar, &flat), rates(&spatial, &lifted));
    for (from, to) in &places {
        let (a, b) = (flat[*from], lifted[*to]);
        assert!((a - b).abs() <= 1e-8 * (a.abs() + 1.0), "{from}: {a} {b}");
    }
    assert!((flat_j / lifted_j - 1.0).abs() < 1e-12);
}

/// Rates of a state.
fn rates_of(model: &Arc<Model>, state: &State) -> Vec<f64> {
    let mut world = World::of_bearing(model);
    let y = world.vector([state]);
    let mut rates = vec![0.0; y.len()];
    world.derivative(0.0, &y, &mut rates);
    rates
}

/// The implicit friction of the plane and that of space lead to the same motion, a step apart in
/// accuracy.
#[test]
fn a_drop_onto_a_plain_ring_falls_as_in_the_plane() {
    let difference = |step_s: f64| {
        let mut planar = rough();
        planar.solver.method = IntegrationMethod::VelocityVerlet;
        planar.solver.step_s = step_s;
        let (flat, lifted) = (complete(&planar), complete(&in_space(planar)));
        let at = |outcome: &RunOutcome| {
            let rotor = outcome.state.rotor_motion().unwrap();
            [
                rotor.x,
                rotor.y,
                1e-5 * outcome.state.ring_speed_rad_s().unwrap(),
            ]
        };
        let [a, b] = [&flat, &lifted].map(at);
        (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (difference(1e-6), difference(0.25e-6));
    println!("{coarse:e} {fine:e}");
    assert!(coarse < 5e-8 && fine < 0.1 * coarse, "{coarse:e} {fine:e}");
}

/// Back to back rows of 15° with preload, a rotor with shoulders above them.
fn pair(preload_m: f64, turned: bool) -> Case {
    let mut case = drop_case();
    let angle = 15f64.to_radians();
    case.bearing = case.bearing.with_contact_angle(angle, 0.0).unwrap();
    let section = if turned { angle } else { 0.0 };
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    case.raceways = vec![raceway.with_section_angle(section, &case.bearing).unwrap()];
    let row = |axial_position_m: f64, contact_sign: f64| Row {
        axial_position_m,
        contact_sign,
        preload_m,
        ..Row::default()
    };
    case.rows = vec![row(-10e-3, 1.0), row(10e-3, -1.0)];
    rotor(&mut case).axial_clearance_m = Some(1e-4);
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 1e-6;
    case
}

/// [`pair`] under a vertical rotor that is about to land on its shoulder.
pub fn vertical() -> Case {
    let mut case = pair(10e-6, true);
    let r = rotor(&mut case);
    r.shaft = Shaft::Vertical;
    (r.z_m, r.vz_m_s) = (-0.95e-4, -0.04);
    (r.x_m, r.vx_m_s) = (1.9e-4, 0.05);
    r.friction.regularisation_speed_m_s = 0.05;
    case.solver.duration_s = 2e-3;
    case
}

/// A horizontal rotor with thrust that lands on both its journal and a shoulder.
pub fn horizontal() -> Case {
    let mut case = pair(10e-6, true);
    let r = rotor(&mut case);
    (r.y_m, r.vy_m_s) = (-0.96 * r.radial_clearance_m, -0.0625);
    (r.z_m, r.vz_m_s, r.axial_load_n) = (0.95e-4, 0.03, 300.0);
    (r.eccentricity_m, r.eccentricity_phase_rad) = (5e-6, 0.7);
    case.solver.duration_s = 2e-3;
    case
}

/// What the ledger misses shrinks with the square of the step where friction is smooth, and every way
/// of the energy is taken.
#[test]
fn the_ledger_of_a_drop_in_space_closes() {
    for (name, case) in [("vertical", vertical()), ("horizontal", horizontal())] {
        let residual = |step_s: f64| {
            let mut case = case.clone();
            case.solver.step_s = step_s;
            let outcome = complete(&case);
            let work = |term| outcome.state.energy_term_j(term);
            for loss in [
                EnergyTerm::RotorFriction,
                EnergyTerm::RotorDamping,
                EnergyTerm::InnerFriction,
                EnergyTerm::OuterFriction,
                EnergyTerm::SupportDamping,
            ] {
                assert!(work(loss) > 0.0, "{name}: {}", loss.name());
            }
            assert!(work(EnergyTerm::Weight) > 0.0);
            outcome.energy_residual_relative.abs()
        };
        let (coarse, fine) = (residual(1e-6), residual(0.25e-6));
        println!("{name}: {coarse:e} {fine:e}");
        assert!(
            coarse < 1e-7 && fine < 0.3 * coarse.max(1e-8),
            "{name}: {coarse:e} {fine:e}"
        );
    }
}

/// A rotor with a shoulder over a radial bearing without friction and gravity, in the middle of the bore.
fn above_a_face(ring_mass_kg: f64) -> Case {
    let mut case = drop_case();
    let bore = case.bearing.inner_ring_bore().unwrap();
    let mut dimensions = case.bearing.dimensions().clone();
    dimensions.inner_ring_mass_kg = ring_mass_kg;
    case.bearing = Bearing::new(dimensions, steel()).unwrap();
    case.bearing = case.bearing.with_inner_ring_bore(bore).unwrap();
    case.operation.gravity_m_s2 = 0.0;
    case.contact.friction.coefficient = 0.0;
    case.support = None;
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 0.5e-6;
    rotor(&mut case).axial_clearance_m = Some(1e-4);
    case
}

fn dropped(case: &Case) -> (DropSummary, State) {
    let mut recorder = DropRecorder::new();
    let outcome = run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    assert!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    (recorder.summary(&outcome.state), outcome.state)
}

/// Two masses that meet on a spring: F = v √(K m M/(m + M)). The balls hardly hold a ring of a tonne.
#[test]
fn a_shoulder_is_a_spring_between_rotor_and_ring() {
    for sign in [1.0, -1.0] {
        let mut case = above_a_face(1000.0);
        let r = rotor(&mut case);
        (r.contact_damping_s_m, r.z_m, r.vz_m_s) = (0.0, sign * 0.99e-4, sign * 0.1);
        case.solver.duration_s = 5e-4;
        let (summary, _) = dropped(&case);
        let (rotor_kg, ring_kg) = (20.0, 1000.0);
        let expected = 0.1 * (1e9_f64 * rotor_kg * ring_kg / (rotor_kg + ring_kg)).sqrt();
        let found = summary.shoulder_force_max_n.unwrap();
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
        assert_eq!(summary.rotor_force_max_n, found);
    }
}

/// Rows of a drop name what the state holds, every number another; journal and shoulder press with K δ.
#[test]
fn a_row_of_a_drop_names_what_the_state_holds() {
    let mut case = horizontal();
    let r = rotor(&mut case);
    (r.eccentricity_m, r.contact_damping_s_m) = (0.0, 0.0);
    let (clearance_m, axial_m) = (r.radial_clearance_m, r.axial_clearance_m.unwrap());
    let (mut state, angles) = initial_state(&case).unwrap();
    let layout = state.layout();
    let of_drop: [(BodyCoordinate, f64); 15] = [
        (RingCoordinate::Speed.into(), 41.0),
        (OuterRingCoordinate::X.into(), 1e-6),
        (OuterRingCoordinate::Y.into(), -2e-6),
        (OuterRingCoordinate::Z.into(), 3e-6),
        (OuterRingCoordinate::Vx.into(), 0.011),
        (OuterRingCoordinate::Vy.into(), -0.012),
        (OuterRingCoordinate::Vz.into(), 0.013),
        // 0.03 mm deep, 3-4-5 from the centre of the ring.
        (RotorCoordinate::X.into(), 4e-6 + 0.6 * (clearance_m + 3e-5)),
        (
            RotorCoordinate::Y.into(),
            -5e-6 - 0.8 * (clearance_m + 3e-5),
        ),
        (RotorCoordinate::Z.into(), 6e-6 + axial_m + 2e-5),
        (RotorCoordinate::Vx.into(), 0.14),
        (RotorCoordinate::Vy.into(), -0.15),
        (RotorCoordinate::Vz.into(), 0.16),
        (RotorCoordinate::Angle.into(), 0.7),
        (RotorCoordinate::Speed.into(), 310.0),
    ];
    let of_ring = [
        (RingCoordinate::X, 4e-6),
        (RingCoordinate::Y, -5e-6),
        (RingCoordinate::Z, 6e-6),
        (RingCoordinate::Vx, 0.021),
        (RingCoordinate::Vy, -0.022),
        (RingCoordinate::Vz, 0.023),
    ];
    for (coordinate, value) in of_drop {
        state.values_mut()[layout.body(coordinate)] = value;
    }
    for (coordinate, value) in of_ring {
        state.values_mut()[layout.ring(coordinate)] = value;
    }
    let model = Model::new(&case).unwrap();
    let row = RightHandSide::new(&model).snapshot(0.0, &state, &angles);
    let (found, ring) = (row.rotor.unwrap(), row.ring);
    let drop = |coordinate: RotorCoordinate| state.at(coordinate);
    for (name, found, expected) in [
        ("x", found.x_m, drop(RotorCoordinate::X)),
        ("y", found.y_m, drop(RotorCoordinate::Y)),
        ("z", found.z_m, drop(RotorCoordinate::Z)),
        ("vx", found.vx_m_s, 0.14),
        ("vy", found.vy_m_s, -0.15),
        ("vz", found.vz_m_s, 0.16),
        ("angle", found.angle_rad, 0.7),
        ("speed", found.speed_rad_s, 310.0),
        ("speed of the ring", found.ring_speed_rad_s, 41.0),
        ("housing x", found.housing_x_m, 1e-6),
        ("housing y", found.housing_y_m, -2e-6),
        ("housing z", found.housing_z_m, 3e-6),
        ("housing vx", found.housing_vx_m_s, 0.011),
        ("housing vy", found.housing_vy_m_s, -0.012),
        ("housing vz", found.housing_vz_m_s, 0.013),
        ("ring x", ring.x_m, 4e-6),
        ("ring y", ring.y_m, -5e-6),
        ("ring z", ring.z_m, 6e-6),
        ("ring vx", ring.vx_m_s, 0.021),
        ("ring vy", ring.vy_m_s, -0.022),
        ("ring vz", ring.vz_m_s, 0.023),
        ("outer ring of a ball z", row.outer_ring_z_m[5], 3e-6),
    ] {
        assert_eq!(found, expected, "{name}");
    }
    for (name, found, expected) in [
        ("journal", found.contact_force_n, 1e9 * 3e-5),
        ("shoulder", found.shoulder_force_n, -1e9 * 2e-5),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-9, "{name}: {found}");
    }
}

/// A vertical rotor falls through its axial clearance in √(2 s/g), and a horizontal one does not.
#[test]
fn a_vertical_rotor_falls_onto_its_shoulder() {
    let mut case = vertical();
    case.rotor = drop_case().rotor;
    let r = rotor(&mut case);
    (r.shaft, r.axial_clearance_m) = (Shaft::Vertical, Some(1e-4));
    // On a support the ring would sink under its own weight.
    case.support = None;
    case.solver.duration_s = 6e-3;
    let (summary, state) = dropped(&case);
    let expected = (2.0 * 1e-4 / 9.81_f64).sqrt();
    let found = summary.first_contact_s.unwrap();
    assert!(
        (0.0..3e-6).contains(&(found - expected)),
        "{found} {expected}"
    );
    assert!(summary.shoulder_force_max_n.unwrap() > 20.0 * 9.81);
    assert!(summary.rotor_axial_displacement_max_m.unwrap() > 1e-4);
    let rotor_motion = state.rotor_motion().unwrap();
    assert!(
        rotor_motion.x.hypot(rotor_motion.y) < 1e-10,
        "{rotor_motion:?}"
    );
    rotor(&mut case).shaft = Shaft::Horizontal;
    case.solver.duration_s = 5e-3;
    let (summary, _) = dropped(&case);
    assert_eq!(
        (summary.first_contact_s, summary.end_state),
        (None, EndState::Falling)
    );
    assert!(summary.rotor_axial_displacement_max_m.unwrap() < 1e-12);
}

/// A shoulder that presses on the face turns the ring until both turn alike; friction makes heat of
/// ½ J Ω², J = Ip Ji/(Ip + Ji), whatever the force does meanwhile.
#[test]
fn a_shoulder_spins_the_ring_up() {
    let mut case = above_a_face(0.2);
    let r = rotor(&mut case);
    let speed = 300.0;
    (r.speed_rad_s, r.axial_load_n, r.z_m) = (speed, 2000.0, 1e-4);
    case.solver.duration_s = 0.02;
    let (summary, state) = dropped(&case);
    let (rotor_j, ring_j) = (0.02, 5.5e-5);
    let common = rotor_j * speed / (rotor_j + ring_j);
    for found in [summary.ring_speed_rad_s, summary.rotor_speed_rad_s] {
        assert!((found / common - 1.0).abs() < 1e-6, "{found} {common}");
    }
    let heat = 0.5 * rotor_j * ring_j / (rotor_j + ring_j) * speed * speed;
    let found = state.energy_term_j(EnergyTerm::RotorFriction);
    assert!((found / heat - 1.0).abs() < 1e-4, "{found} {heat}");
    assert!(summary.spin_up_s.unwrap() > 0.0);
}

/// A face that turns fast under a force N drags a slow translation v by half of μ N v/(Ω R): the sliding
/// velocity of each place turns by v/(Ω R) at most.
#[test]
fn a_turning_face_drags_a_translation() {
    let mut case = above_a_face(0.2);
    let r = rotor(&mut case);
    let (depth, speed, radius, slow) = (1e-6, 3000.0, 17e-3, 0.01);
    (r.speed_rad_s, r.shoulder_radius_m, r.vx_m_s) = (speed, Some(radius), slow);
    r.z_m = 1e-4;
    let (mut state, _) = initial_state(&case).unwrap();
    state.set(RotorCoordinate::Z, 1e-4 + depth);
    let model = Model::new(&case).unwrap();
    let rates = rates_of(&model, &state);
    let rate = |coordinate: BodyCoordinate| rates[state.layout().body(coordinate)];
    let (friction, force) = (0.15, 1e9 * depth);
    let expected = -0.5 * friction * force * slow / (speed * radius) / 20.0;
    let found = rate(RotorCoordinate::Vx.into());
    assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
    let torque = friction * force * radius;
    let found = rate(RingCoordinate::Speed.into());
    assert!((found / (torque / 5.5e-5) - 1.0).abs() < 1e-6, "{found}");
    let found = rate(RotorCoordinate::Vz.into());
    assert!((found / (-force / 20.0) - 1.0).abs() < 1e-9, "{found}");
}

/// What friction of the rotor takes from rotor and ring over a step is its heat, at any step: journal and
/// shoulder slide along the bore, along the axis and across it, under loads that stop them within the step.
#[test]
fn friction_of_the_rotor_makes_heat_of_what_it_takes() {
    let mut case = above_a_face(0.2);
    let r = rotor(&mut case);
    (r.eccentricity_m, r.eccentricity_phase_rad) = (2e-3, 0.7);
    (r.x_m, r.y_m) = (2e-3 * 0.7_f64.cos(), 2e-3 * 0.7_f64.sin() - 1.999e-4);
    (r.vx_m_s, r.vz_m_s, r.speed_rad_s, r.z_m) = (0.3, 0.2, 40.0, 1e-4);
    let (mut state, _) = initial_state(&case).unwrap();
    state.set(RotorCoordinate::Y, rotor(&mut case).y_m - 2e-6);
    state.set(RotorCoordinate::Z, 1e-4 + 3e-6);
    state.set(RotorCoordinate::Vz, 0.2);
    let model = Model::new(&case).unwrap();
    for h_s in [1e-6, 1e-4, 1e-2] {
        let mut world = World::of_bearing(&model);
        let y0 = world.vector([&state]);
        let (mut y, mut rates) = (y0.clone(), vec![0.0; y0.len()]);
        world.nonstiff_derivative(0.0, &y0, &mut rates);
        world.add_stiff_part(h_s, &y0, &mut y, &mut rates);
        let after = State::from_vector(world.layout(0), &y);
        let energy_j = |state: &State| {
            let motion = state.rotor_motion().unwrap();
            model.energy_j(state) + model.rotor.as_ref().unwrap().energy_j(&motion)
        };
        let taken = energy_j(&state) - energy_j(&after);
        let heat = after.energy_term_j(EnergyTerm::RotorFriction);
        assert!(
            heat > 0.0 && (taken / heat - 1.0).abs() < 1e-9,
            "{h_s}: {taken} {heat}"
        );
    }
}

/// Balls that are dry hold a light ring back against its shoulder: the heat is that of the speeds to which
/// friction has brought the ring.
#[test]
fn the_ledger_closes_for_a_light_ring() {
    let mut case = above_a_face(0.2);
    let bore = cageless::InnerRingBore {
        polar_inertia_kg_m2: 2e-6,
        ..case.bearing.inner_ring_bore().unwrap()
    };
    case.bearing = case.bearing.with_inner_ring_bore(bore).unwrap();
    case.contact.friction.coefficient = 0.3;
    let r = rotor(&mut case);
    (r.speed_rad_s, r.axial_load_n, r.z_m) = (300.0, 2000.0, 1e-4);
    case.solver.duration_s = 4e-3;
    let residual = complete(&case).energy_residual_relative.abs();
    println!("{residual:e}");
    assert!(residual < 1e-5, "{residual:e}");
}

/// On plain rings the pressure of a drop is Hertz's at the contact angle of the pair, 15°, under the
/// largest force of a ball.
#[test]
fn pressures_in_space_are_those_of_the_contacts() {
    let mut case = horizontal().conventional();
    case.solver.duration_s = 1e-3;
    let (summary, _) = dropped(&case);
    let most = |forces: &[f64]| forces.iter().copied().fold(0.0, f64::max);
    let contacts = case.bearing.contacts_at([15f64.to_radians(); 2]);
    for (contact, forces, found) in [
        (
            &contacts[0],
            &summary.inner_force_max_n,
            summary.inner_pressure_max_pa,
        ),
        (
            &contacts[1],
            &summary.outer_force_max_n,
            summary.outer_pressure_max_pa,
        ),
    ] {
        let expected = contact.peak_pressure_pa(most(forces));
        assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    }
}

/// Rows that press each other hold their balls before anything falls on them.
#[test]
fn a_preloaded_pair_waits_at_rest() {
    for (preload_m, turned, pressed_n, within_m) in
        [(10e-6, true, 20.0, 1e-8), (0.0, false, 0.0, 1e-6)]
    {
        rests(pair(preload_m, turned), pressed_n, within_m);
    }
}

fn rests(mut case: Case, pressed_n: f64, within_m: f64) {
    case.operation.gravity_m_s2 = 1e-3;
    case.solver.duration_s = 1e-3;
    let (start, _) = initial_state(&case).unwrap();
    let end = complete(&case).state;
    let pressed = {
        let model = Model::new(&case).unwrap();
        let mut rhs = RightHandSide::new(&model);
        rhs.derivative(0.0, start.values(), &mut vec![0.0; start.values().len()]);
        rhs.contacts().inner_force_n(3)
    };
    assert!(pressed >= pressed_n, "{pressed}");
    for coordinate in [BallCoordinate::X, BallCoordinate::Y, BallCoordinate::Z] {
        for k in 0..28 {
            let place = start.layout().ball(coordinate, k);
            let moved = end.values()[place] - start.values()[place];
            assert!(moved.abs() < within_m, "{coordinate:?} {k}: {moved:e}");
        }
    }
}

/// A pair at rest may be run up from there.
#[test]
fn a_preloaded_pair_starts_at_rest_under_a_table_of_speeds() {
    let mut case = pair(10e-6, true);
    (case.rotor, case.support) = (None, None);
    let table = TimeTable::new("inner_speed_rad_s", vec![0.0, 1.0], vec![0.0, 1000.0]);
    case.operation.inner_speed_table = Some(table.unwrap());
    let (state, _) = initial_state(&case).unwrap();
    assert_eq!(state.ball_motion(0).spin, 0.0);
}

/// Thrust and fall the other way mirror the drop onto a pair.
#[test]
fn thrust_the_other_way_is_the_mirror_image() {
    let after = |sign: f64| {
        let mut case = horizontal();
        let r = rotor(&mut case);
        (r.z_m, r.vz_m_s, r.axial_load_n) = (sign * r.z_m, sign * r.vz_m_s, sign * r.axial_load_n);
        case.solver.duration_s = 1e-3;
        complete(&case).state
    };
    let (a, b) = (after(1.0), after(-1.0));
    let [x, y] = [&a, &b].map(|s| s.rotor_motion().unwrap());
    assert!(
        (x.y - y.y).abs() < 1e-12 && (x.speed - y.speed).abs() < 1e-8,
        "{x:?} {y:?}"
    );
    for coordinate in [
        BodyCoordinate::from(RotorCoordinate::Z),
        OuterRingCoordinate::Z.into(),
    ] {
        let [x, y] = [&a, &b].map(|s| s.values()[s.layout().body(coordinate)]);
        assert!(x != 0.0 && (x + y).abs() < 1e-12, "{coordinate:?}: {x} {y}");
    }
}

#[test]
fn what_cannot_fall_in_space_is_named() {
    let refused = |change: fn(&mut Case)| {
        let mut case = pair(10e-6, true);
        change(&mut case);
        let refused = case.check().and_then(|()| case.check_motion());
        refused.expect_err("refused").field
    };
    for (field, change) in [
        (
            "axial_clearance_m",
            (|case| {
                rotor(case).axial_clearance_m = None;
                rotor(case).shaft = Shaft::Vertical;
            }) as fn(&mut Case),
        ),
        ("rotor_axial_load_n", |case| {
            rotor(case).axial_clearance_m = None;
            rotor(case).axial_load_n = 10.0;
        }),
        ("axial_clearance_m", |case| {
            rotor(case).axial_clearance_m = Some(0.0)
        }),
        ("shoulder_radius_m", |case| {
            rotor(case).shoulder_radius_m = Some(1e-3)
        }),
        ("shoulder_radius_m", |case| {
            rotor(case).shoulder_radius_m = Some(20e-3)
        }),
        ("rotor_z_m", |case| rotor(case).z_m = 2e-4),
        ("axial_load_n", |case| {
            case.operation.space.axial_load_n = 10.0
        }),
        ("tilt_x_rad", |case| {
            case.operation.space.tilt = Tilt::Held {
                x_rad: 1e-3,
                y_rad: 0.0,
            };
        }),
        ("rotor_friction_law", |case| {
            rotor(case).friction_law = FrictionModel::Coulomb
        }),
    ] {
        assert_eq!(refused(change), field);
    }
    // Several bearings under a linear rotor are planar.
    assert_eq!(
        pair(10e-6, true).check_planar().unwrap_err().field,
        "contact_angle_rad"
    );
}
