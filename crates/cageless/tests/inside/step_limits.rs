//! Every step limit against its closed form, term by term.

use crate::common::{conventional, dimensions, drop_case, raceway, structure, undamped};
use cageless::contact::FrictionTable;
use cageless::step_limits::StepLimits;
use cageless::{
    Case, FrictionModel, Gaps, IntegrationMethod, Start, StartState, SupportStop, Tilt,
};

const METHODS: [IntegrationMethod; 3] = [
    IntegrationMethod::Abm4,
    IntegrationMethod::VelocityVerlet,
    IntegrationMethod::Adaptive,
];

/// Rates that a case has by its closed forms.
#[derive(Default)]
struct Expected {
    /// Force of a loaded ball, N.
    load: f64,
    contact_rad_s: f64,
    damping_1_s: f64,
    friction_1_s: f64,
    falling_1_s: f64,
    light: bool,
}

/// Stiffness of a Hertz contact under a force, N/m.
fn slope(k: f64, force: f64) -> f64 {
    1.5 * k * (force / k).powf(1.0 / 3.0)
}

/// Peak force of an impact at a speed of a reduced mass: ½mv² = ⅖Kδ^(5/2).
fn impact(k: f64, reduced: f64, speed: f64) -> f64 {
    k * (1.25 * reduced * speed * speed / k).powf(0.6)
}

/// What a rotor adds: the force at the bottom of its fall, N, its contact under it, N/m and
/// N·s/m, and mass.
struct Fall {
    force: f64,
    stiffness: f64,
    damping: f64,
    mobility: f64,
}

fn fall(case: &Case, carrying: f64) -> Option<Fall> {
    let rotor = case.rotor.as_ref()?;
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let weight = rotor.mass_kg * case.operation.gravity_m_s2;
    let journal_y = rotor.y_m - rotor.eccentricity_m * rotor.eccentricity_phase_rad.sin();
    let speed_square = rotor.vx_m_s.powi(2) + rotor.vy_m_s.powi(2);
    let energy =
        0.5 * rotor.mass_kg * speed_square + weight * (journal_y + rotor.radial_clearance_m);
    let unbalance = rotor.mass_kg * rotor.eccentricity_m * rotor.speed_rad_s.powi(2);
    let support = case.support.as_ref();
    let yielding = support.map_or(0.0, |s| {
        1.0 / (s.stiffness_n_m + s.stop.map_or(0.0, |stop| stop.stiffness_n_m))
    });
    let (k, p) = (rotor.contact_stiffness_n_mp, rotor.contact_exponent);
    let contact = |force: f64| p * force / (force / k).powf(1.0 / p);
    let mut force = 1e4;
    for _ in 0..60 {
        let ball = force / carrying;
        let balls = (1.0 / slope(inner, ball) + 1.0 / slope(outer, ball)) / carrying;
        let series = 1.0 / (1.0 / contact(force) + balls + yielding);
        force = weight + weight.hypot((2.0 * series * energy).sqrt()) + unbalance;
    }
    let bore = case.bearing.inner_ring_bore().unwrap();
    let journal = bore.radius_m - rotor.radial_clearance_m;
    let impact_speed = (2.0 * energy / rotor.mass_kg).sqrt();
    Some(Fall {
        force,
        stiffness: contact(force) * (1.0 + 1.5 * rotor.contact_damping_s_m * impact_speed),
        damping: 1.5 * rotor.contact_damping_s_m * force,
        mobility: 1.0 / rotor.mass_kg
            + journal.powi(2) / rotor.polar_inertia_kg_m2
            + 1.0 / case.bearing.dimensions().inner_ring_mass_kg
            + bore.radius_m.powi(2) / bore.polar_inertia_kg_m2,
    })
}

/// The closed forms, with the force that presses a ball without load.
fn expected(case: &Case, preload: f64) -> Expected {
    let (d, contact) = (case.bearing.dimensions(), &case.contact);
    let [inner, outer, ball] = case.stiffness_n_m1_5();
    let mass = 4.0 / 3.0 * std::f64::consts::PI * d.ball_radius_m.powi(3) * 7850.0;
    let (balls, carrying) = (d.balls as f64, 0.25 * d.balls as f64);
    let ring_speed = case.largest_inner_speed_rad_s() * d.inner_groove_bottom_radius_m;
    // A ball that rolls at a radius of contact r: ωRi·r/(r + Rw).
    let orbit = |r: f64| ring_speed * r / (r + d.ball_radius_m);
    let rolling = orbit(d.ball_radius_m);
    let fall = fall(case, carrying);
    let down = case.operation.radial_load_n
        + fall.as_ref().map_or(0.0, |f| f.force)
        + (d.inner_ring_mass_kg + mass) * case.operation.gravity_m_s2;
    let centrifugal = mass * rolling * rolling / case.bearing.pitch_radius_m();
    let carried = 1.25 * (5.0 * down / balls + centrifugal);
    let struck = impact(inner.max(outer), mass, 0.1);
    let load = carried.max(struck).max(preload);
    let catching = case.raceways.iter().fold(0.1, |most: f64, r| {
        let deepest = r.effective_radius_m(r.dimensions().centre_angle_rad);
        most.max(rolling - orbit(deepest))
    });
    let between = slope(ball, impact(ball, mass / 2.0, catching));
    let (at_inner, at_outer) = (slope(inner, load), slope(outer, load));
    let damper = |k: f64| contact.damping_n_s_m1_5 * (load / k).cbrt();
    let (drop_k, drop_c) = fall
        .as_ref()
        .map_or((0.0, 0.0), |f| (f.stiffness, f.damping));
    let mut square = (at_inner + at_outer + 2.0 * between) / mass
        + (carrying * at_inner + drop_k) / d.inner_ring_mass_kg;
    let mut damping = (damper(inner) + damper(outer)) / mass
        + (carrying * damper(inner) + d.inner_ring_damping_n_s_m + drop_c) / d.inner_ring_mass_kg;
    if let Some(rotor) = &case.rotor {
        square += drop_k / rotor.mass_kg;
    }
    if let Some(support) = &case.support {
        let stop = support.stop.map_or(0.0, |s| s.stiffness_n_m);
        square += (carrying * at_outer + support.stiffness_n_m + stop) / support.mass_kg;
        damping += (carrying * damper(outer) + support.damping_n_s_m) / support.mass_kg;
    }
    let at_rotor = |of: &dyn Fn(&cageless::Rotor) -> f64| {
        let pair = case.rotor.as_ref().zip(fall.as_ref());
        pair.map_or(0.0, |(rotor, f)| of(rotor) * f.force * f.mobility)
    };
    let smooth = f64::from(u8::from(contact.friction_law != FrictionModel::Coulomb));
    let coefficient = contact
        .friction
        .static_coefficient
        .unwrap_or(contact.friction.coefficient);
    let fall_of = |high: Option<f64>, low: f64, speed: Option<f64>| {
        high.zip(speed)
            .map_or(0.0, |(high, speed)| (high - low) / speed)
    };
    let falling = fall_of(
        contact.friction.static_coefficient,
        contact.friction.coefficient,
        contact.friction.stribeck_speed_m_s,
    );
    Expected {
        load,
        contact_rad_s: square.sqrt(),
        damping_1_s: damping,
        friction_1_s: (smooth * 5.0 * coefficient * load
            / (mass * contact.friction.regularisation_speed_m_s))
            .max(at_rotor(&|r| match r.friction_law {
                FrictionModel::Coulomb => 0.0,
                _ => {
                    r.friction
                        .static_coefficient
                        .unwrap_or(r.friction.coefficient)
                        / r.friction.regularisation_speed_m_s
                }
            })),
        falling_1_s: (5.0 * falling * load / mass).max(at_rotor(&|r| {
            fall_of(
                r.friction.static_coefficient,
                r.friction.coefficient,
                r.friction.stribeck_speed_m_s,
            )
        })),
        light: carried < 4.0 * struck,
    }
}

/// Compares all rates; `within` is the accuracy of the force of a fall.
fn compare(name: &str, case: &Case, preload: f64, within: f64) {
    let (limits, expected) = (StepLimits::new(case), expected(case, preload));
    for (rate, found, closed) in [
        ("contact", limits.contact_rad_s, expected.contact_rad_s),
        ("damping", limits.damping_1_s, expected.damping_1_s),
        ("friction", limits.friction_1_s, expected.friction_1_s),
        ("falling", limits.falling_1_s, expected.falling_1_s),
    ] {
        let miss = (found - closed).abs() / closed.max(1e-300);
        assert!(
            miss < within || found == closed,
            "{name}, {rate}: {found} {closed}"
        );
    }
    assert_eq!(limits.light, expected.light, "{name}");
}

fn given_stiffness(mut case: Case) -> Case {
    case.contact.inner_stiffness_n_m1_5 = Some(3.1e10);
    case.contact.outer_stiffness_n_m1_5 = Some(2.3e10);
    case.contact.ball_stiffness_n_m1_5 = Some(7e9);
    case
}

fn stribeck(case: &mut Case) {
    let contact = &mut case.contact;
    contact.friction_law = FrictionModel::Stribeck;
    contact.friction.static_coefficient = Some(0.02);
    contact.friction.stribeck_speed_m_s = Some(0.3);
}

/// Load, speed, raceways, damping and friction of a bearing.
#[test]
fn rates_of_a_loaded_bearing_are_the_closed_forms() {
    let cases = [
        ("conventional", conventional(dimensions())),
        ("discrete", structure(4.95, 35.0)),
        ("given stiffness", given_stiffness(structure(5.1, 25.2))),
        ("undamped", undamped(conventional(dimensions()))),
    ];
    for (name, case) in cases {
        compare(name, &case, 0.0, 1e-9);
        let mut other = case.clone();
        other.operation.radial_load_n = 120.0;
        other.operation.inner_speed_rad_s = 3.0;
        other.operation.gravity_m_s2 = 40.0;
        compare(name, &other, 0.0, 1e-9);
        other.operation.radial_load_n = 0.0;
        compare(name, &other, 0.0, 1e-9);
        stribeck(&mut other);
        compare(name, &other, 0.0, 1e-9);
        other.contact.friction_law = FrictionModel::Coulomb;
        other.contact.friction.static_coefficient = None;
        other.contact.friction.stribeck_speed_m_s = None;
        compare(name, &other, 0.0, 1e-9);
    }
}

/// What presses a ball without load: two contacts in series under twice the deviation of a ball
/// and what a raceway is too shallow, or a rolling start with overlap.
#[test]
fn parts_that_press_each_other_set_the_step() {
    let mut case = given_stiffness(structure(5.1, 25.2));
    (
        case.operation.radial_load_n,
        case.operation.inner_speed_rad_s,
    ) = (0.0, 1.0);
    let (inner, outer): (f64, f64) = (3.1e10, 2.3e10);
    let series = |depth: f64| {
        // δi + δo = depth under one force.
        let share = 1.0 + (inner / outer).powf(2.0 / 3.0);
        inner * (depth / share).powf(1.5)
    };
    let deviation = 6e-6;
    let mut larger = case.clone();
    let mut deviations = vec![-1e-6; 14];
    deviations[4] = deviation;
    larger.bearing = larger
        .bearing
        .with_ball_radius_deviations(deviations)
        .unwrap();
    compare("a larger ball", &larger, series(2.0 * deviation), 1e-9);
    let shallow = |case: &Case| {
        let raceway = case.raceways[0].clone().with_depth_error(-5e-6).unwrap();
        case.clone().with_raceways(vec![raceway])
    };
    compare("a shallow raceway", &shallow(&case), series(5e-6), 1e-9);
    compare(
        "both",
        &shallow(&larger),
        series(2.0 * deviation + 5e-6),
        1e-9,
    );
    let rolling = |case: &Case| Case {
        start: Start::new(
            StartState::Rolling {
                ring_x_m: 6e-6,
                ring_y_m: -8e-6,
            },
            Gaps::Uniform,
            0.0,
        ),
        ..case.clone()
    };
    compare("overlap", &rolling(&case), inner * 1e-5_f64.powf(1.5), 1e-9);
    let both = inner * (1e-5 + deviation).powf(1.5);
    compare("overlap of a larger ball", &rolling(&larger), both, 1e-9);
    let mut light = case;
    light.operation.gravity_m_s2 = 0.0;
    assert!(StepLimits::new(&light).light);
    assert!(expected(&light, 0.0).load > 1.0, "the least impact");
}

/// The fall onto contact, balls and support in series, the unbalance, the stop of the support, and
/// the friction of the journal.
#[test]
fn rates_of_a_drop_are_the_closed_forms() {
    let drop = drop_case();
    let mut cases = vec![("drop", drop.clone())];
    let mut change = |name, of: &dyn Fn(&mut Case)| {
        let mut case = drop.clone();
        of(&mut case);
        cases.push((name, case));
    };
    change("thrown", &|c| {
        let rotor = c.rotor.as_mut().unwrap();
        (rotor.y_m, rotor.vx_m_s, rotor.vy_m_s) = (-1e-4, 0.3, -0.4);
    });
    change("unbalanced", &|c| {
        let rotor = c.rotor.as_mut().unwrap();
        (rotor.eccentricity_m, rotor.eccentricity_phase_rad) = (5e-5, 0.6);
    });
    change("Hertzian journal", &|c| {
        let rotor = c.rotor.as_mut().unwrap();
        (rotor.contact_exponent, rotor.contact_stiffness_n_mp) = (1.5, 5e10);
    });
    change("stop", &|c| {
        c.support.as_mut().unwrap().stop = Some(SupportStop {
            gap_m: 3e-5,
            stiffness_n_m: 3e8,
        });
    });
    change("fixed", &|c| c.support = None);
    change("journal of falling friction", &|c| {
        let rotor = c.rotor.as_mut().unwrap();
        rotor.friction_law = FrictionModel::Stribeck;
        rotor.friction.static_coefficient = Some(0.5);
        rotor.friction.stribeck_speed_m_s = Some(0.01);
        rotor.friction.regularisation_speed_m_s = 1e-4;
    });
    change("sticking journal", &|c| {
        c.rotor.as_mut().unwrap().friction_law = FrictionModel::Coulomb;
        c.contact.friction.coefficient = 1e-3;
    });
    for (name, case) in &cases {
        compare(name, case, 0.0, 1e-3);
    }
    let rate = |k: usize| StepLimits::new(&cases[k].1).contact_rad_s;
    assert!(rate(2) > 1.2 * rate(0), "an unbalance shortens the step");
}

/// The contact of the journal on the mass that a rotor shows there, its fastest vibration and
/// its fastest decay; heavier than the case says shortens nothing.
#[test]
fn a_linear_rotor_adds_its_journal_vibration_and_decay() {
    let mut case = drop_case();
    case.rotor.as_mut().unwrap().contact_damping_s_m = 0.0;
    let alone = StepLimits::new(&case);
    let with = |mass: f64, fastest: f64, decay: f64| {
        StepLimits::with_linear_rotor(&case, mass, fastest, decay)
    };
    let added = |limits: StepLimits| limits.contact_rad_s.powi(2) - alone.contact_rad_s.powi(2);
    assert_eq!(with(20.0, 0.0, 0.0), alone);
    assert_eq!(with(80.0, 0.0, 0.0), alone);
    // K (1/m′ − 1/m).
    let quarter = 1e9 * (4.0 / 20.0 - 1.0 / 20.0);
    assert!((added(with(5.0, 0.0, 0.0)) / quarter - 1.0).abs() < 1e-6);
    assert!((added(with(0.01, 0.0, 0.0)) / (1e9 * (100.0 - 0.05)) - 1.0).abs() < 1e-6);
    assert!((added(with(20.0, 7e5, 0.0)) / 4.9e11 - 1.0).abs() < 1e-9);
    assert_eq!(with(20.0, 0.0, 3e7).damping_1_s, 3e7);
    assert_eq!(with(20.0, 0.0, 1.0), alone);
}

/// Largest steps, automatic steps and the limits of friction follow from the rates and from what
/// the methods bear.
#[test]
fn steps_follow_from_rates_and_methods() {
    let mut light = conventional(dimensions());
    (
        light.operation.radial_load_n,
        light.operation.inner_speed_rad_s,
    ) = (0.0, 10.0);
    let mut dry = drop_case();
    dry.contact.friction.coefficient = 0.5;
    let mut falling = structure(5.1, 25.2);
    stribeck(&mut falling);
    let mut table = structure(5.1, 25.2);
    table.contact.friction_law = FrictionModel::Table;
    table.contact.friction.table = FrictionTable::new(vec![[0.0, 0.1], [0.1, 0.02]]).ok();
    table.contact.friction.coefficient = 0.02;
    let mut damped = conventional(dimensions());
    damped.contact.damping_n_s_m1_5 = 5e6;
    let grid = [1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0];
    for case in [
        undamped(structure(5.1, 25.2)),
        light,
        dry,
        falling,
        table,
        damped,
    ] {
        let limits = StepLimits::new(&case);
        for method in METHODS {
            let properties = method.properties();
            let explicit = !properties.solves_stiff_part;
            let within = |found: f64, limit: f64| (found / limit - 1.0).abs() < 1e-12;
            let largest = (properties.oscillation_limit / limits.contact_rad_s)
                .min(properties.decay_limit / limits.damping_1_s);
            assert!(limits.largest_s(method) == largest, "{method:?}");
            let resolved = limits.friction_resolved_to_s(method);
            let unique = limits.falling_resolved_to_s(method);
            if explicit {
                assert!(resolved == properties.decay_limit / limits.friction_1_s);
                assert_eq!(unique, f64::INFINITY);
            } else {
                assert_eq!(resolved, f64::INFINITY);
                assert!(
                    unique == 1.0 / limits.falling_1_s || within(unique, 1.0 / limits.falling_1_s)
                );
            }
            let mut share = properties.automatic_oscillation[usize::from(limits.damped)];
            if limits.light && method != IntegrationMethod::Adaptive {
                share = share.min(0.2);
            }
            let friction = if explicit { limits.friction_1_s } else { 0.0 };
            let decay = limits.damping_1_s.max(friction);
            let wanted = (share / limits.contact_rad_s).min(properties.automatic_decay / decay);
            let automatic = limits.automatic_s(method);
            let power = 10f64.powf((automatic * 1.000_001).log10().floor());
            let digit = grid
                .iter()
                .position(|d| (automatic / power / d - 1.0).abs() < 1e-9);
            let digit = digit.unwrap_or_else(|| panic!("{method:?}: {automatic}"));
            assert!(
                automatic <= wanted * (1.0 + 1e-12),
                "{method:?}: {automatic} {wanted}"
            );
            assert!(
                grid[digit + 1] * power > wanted,
                "{method:?}: {automatic} {wanted}"
            );
        }
    }
    // Friction is stiff beyond a λh of 0.7, and Coulomb's always.
    let mut case = drop_case();
    let rate = StepLimits::new(&case).friction_1_s;
    for (share, stiff) in [(0.69, false), (0.71, true)] {
        case.solver.step_s = share / rate;
        assert_eq!(StepLimits::friction_is_stiff(&case), stiff);
    }
    case.solver.step_s = 0.1 / rate;
    let mut journal = case.clone();
    journal.rotor.as_mut().unwrap().friction_law = FrictionModel::Coulomb;
    case.contact.friction_law = FrictionModel::Coulomb;
    assert!(StepLimits::friction_is_stiff(&case) && StepLimits::friction_is_stiff(&journal));
}

/// A raceway at another place of the ring changes no rate.
#[test]
fn the_place_of_a_raceway_changes_no_step() {
    let case = conventional(dimensions());
    let at = |angle: f64| {
        let raceway = raceway(&case.bearing, 4.95, 35.0, angle);
        StepLimits::new(&case.clone().with_raceways(vec![raceway]))
    };
    let (bottom, turned) = (at(0.0), at(77.0));
    assert!((bottom.contact_rad_s / turned.contact_rad_s - 1.0).abs() < 1e-12);
}

/// Thrust, moments and tilt count as the radial load does that presses the most loaded ball as the
/// equilibrium in space says they do.
#[test]
fn loads_along_the_axis_press_balls_as_in_equilibrium() {
    let mut plain = conventional(dimensions());
    (plain.operation.radial_load_n, plain.operation.gravity_m_s2) = (1e-3, 0.0);
    plain.operation.inner_speed_rad_s = 10.0;
    let tilted = |tilt: Tilt| {
        let mut case = plain.clone();
        case.operation.space.tilt = tilt;
        case
    };
    let held = tilted(Tilt::Held {
        x_rad: 2e-3,
        y_rad: 1.5e-3,
    });
    let turned = tilted(Tilt::Free {
        moment_x_n_m: 30.0,
        moment_y_n_m: -40.0,
    });
    let mut pushed = plain.clone();
    pushed.bearing = (pushed.bearing)
        .with_contact_angle(15f64.to_radians(), 0.0)
        .unwrap();
    pushed.operation.space.axial_load_n = -4500.0;
    for (name, case, within) in [
        ("thrust", pushed, 0.001),
        ("tilt", held, 0.05),
        ("moment", turned, 0.05),
    ] {
        let e = cageless::equilibrium::space::solve(&case).unwrap();
        let most = e.rest.inner_force_n.iter().copied().fold(0.0, f64::max);
        let mut radial = plain.clone();
        radial.bearing = case.bearing.clone();
        radial.operation.radial_load_n = most * 14.0 / 5.0;
        let rate = |case: &Case| StepLimits::new(case).contact_rad_s;
        let ratio = rate(&case) / rate(&radial);
        println!("{name}: {most} N, {ratio}");
        assert!((ratio - 1.0).abs() < within, "{name}: {most} N, {ratio}");
    }
}
