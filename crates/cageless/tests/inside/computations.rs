//! A small computation with each module and item that is not public.

#[test]
fn ball() {
    use cageless::ball::{BallMotion, Centre};

    // A ball 2 mm below the centre that moves to the right orbits counter-clockwise.
    let ball = BallMotion {
        y: -2e-3,
        vx: 1.0,
        ..BallMotion::default()
    };
    let polar = ball.about(&Centre::default());
    assert_eq!(
        (polar.distance, polar.tangential, polar.radial),
        (2e-3, 1.0, 0.0)
    );
}

#[test]
fn collision() {
    use cageless::contact::hertz::impact;

    // Two steel balls of 3.6 g that meet at 0.1 m/s.
    let (deflection_m, force_n, duration_s) = impact(7.4e9, 3.6e-3, 0.1);
    assert!(deflection_m < 1e-5 && force_n > 10.0 && duration_s < 1e-3);
}

#[test]
fn creep() {
    use cageless::contact::creep::creep_coefficient;

    // A round contact of steel.
    assert!((creep_coefficient(1.0, 0.3) - 4.3072).abs() < 1e-5);
}

#[test]
fn flank_friction() {
    use cageless::contact::friction::{Law, Smooth};
    use cageless::contact::{AtFlanks, FlankSliding};

    let law = Smooth {
        coefficient: 0.1,
        inverse_regularisation_speed: 50.0,
    };
    let sliding = FlankSliding {
        along_square: 16.0,
        inverse_knee: 50.0,
        spin_square: 0.0,
    };
    // 3 m/s across and 4 m/s along the groove: three fifths of μN act across.
    let [force_n, _] = AtFlanks { law, sliding }.force(3.0, 500.0);
    assert!((force_n - 30.0).abs() < 1e-12);
}

#[test]
fn flank_section() {
    use cageless::contact::FlankSection;

    let flanks = FlankSection {
        gap: 0.19e-3,
        height: 0.19e-3 * 0.5_f64.cos(),
        cosine: 0.5_f64.cos(),
    };
    // Just touching at αc; pressed in the contact angle falls.
    assert!((flanks.press(0.0).cosine - 0.5_f64.cos()).abs() < 1e-15);
    assert!(flanks.press(6e-6).cosine > 0.5_f64.cos());
}

#[test]
fn flash_temperature() {
    use cageless::contact::flash_temperature::{STEEL_EFFUSIVITY, flash_temperature_k};

    // 1.5 GPa over an ellipse of 0.1 mm in the direction of rolling, surfaces at 8 and 10 m/s.
    let rise = flash_temperature_k(0.1, 1.5e9, 1e-4, [8.0, 10.0], STEEL_EFFUSIVITY);
    assert!((rise - 47.9).abs() < 0.5);
}

#[test]
fn friction_table() -> Result<(), cageless::InputError> {
    use cageless::contact::friction::FrictionTable;

    // Dry steel: 0.3 at rest, 0.2 from 0.5 m/s on.
    let table = FrictionTable::new(vec![[0.0, 0.3], [0.1, 0.24], [0.5, 0.2]])?;
    assert_eq!(table.coefficient(0.1)[0], 0.24);
    assert_eq!(table.coefficient(9.0), [0.2, 0.0]);
    Ok(())
}

#[test]
fn friction() {
    use cageless::contact::friction::{Law, Smooth};

    let law = Smooth {
        coefficient: 0.1,
        inverse_regularisation_speed: 1.0 / 0.02,
    };
    let [sliding_n, _] = law.force(1.0, 500.0);
    assert_eq!(sliding_n, 50.0); // μ·N far from rolling
    let [_, slope_n_s_m] = law.force(0.0, 500.0);
    assert!((slope_n_s_m - 50.0 / 0.02).abs() < 1e-9);
}

#[test]
fn regularisation_of_rolling_m_s() {
    use cageless::FrictionParameters;

    assert_eq!(FrictionParameters::regularisation_of_rolling_m_s(5.0), 5e-3);
    assert_eq!(
        FrictionParameters::regularisation_of_rolling_m_s(50.0),
        0.02
    );
}

#[test]
fn hertz() {
    use cageless::Material;
    use cageless::contact::hertz::PointContact;

    let steel = Material {
        density_kg_m3: 7850.0,
        youngs_modulus_pa: 206e9,
        poisson_ratio: 0.3,
    };
    // A ball of radius 5 mm on a plane: F = K δ^(3/2), peak pressure ∝ F^(1/3).
    let contact = PointContact::new([200.0; 2], [0.0; 2], &steel);
    let ratio = contact.peak_pressure_pa(80.0) / contact.peak_pressure_pa(10.0);
    assert!((ratio - 2.0).abs() < 1e-12);
}

#[test]
fn journal() {
    use cageless::contact::{Journal, JournalMotion, journal_contact};

    let journal = Journal {
        radius: 14.8e-3,
        bore_radius: 15e-3,
        radial_clearance: 2e-4,
        stiffness: 1e9,
        exponent: 1.0,
        damping: 0.3,
    };
    // 1 µm deep at the bottom, still falling at 0.1 m/s, spinning at 100 rad/s.
    let rotor = JournalMotion {
        y: -2.01e-4,
        vy: -0.1,
        speed: 100.0,
        ..JournalMotion::default()
    };
    let contact = journal_contact(&journal, &rotor, &JournalMotion::default());
    assert!((contact.force - 1045.0).abs() < 1e-6);
    assert!((contact.slip - 1.48).abs() < 1e-12);
}

#[test]
fn contact() {
    use cageless::contact::friction::{Law, Smooth};

    let friction = Smooth {
        coefficient: 0.007,
        inverse_regularisation_speed: 1.0 / 0.02,
    };
    // Far above the scale of 0.02 m/s the smooth law is μN.
    let [force_n, _] = friction.force(1.0, 100.0);
    assert!((force_n - 0.7).abs() < 1e-12);
}

#[test]
fn published() {
    use cageless::ball::{Ball, PolarMotion};
    use cageless::contact::{OuterRaceway, published::centrifugal_force};

    let ball = Ball {
        mass: 3e-3,
        ..Ball::default()
    };
    let raceway = OuterRaceway {
        pitch_radius: 20e-3,
        ..OuterRaceway::default()
    };
    let polar = PolarMotion {
        tangential: 10.0,
        ..PolarMotion::default()
    };
    let force_n = centrifugal_force(&ball, &raceway, &polar); // m·vt²/Rm
    assert!((force_n - 15.0).abs() < 1e-12);
}

#[test]
fn contact_tracker() -> Result<(), cageless::InputError> {
    use cageless::contact_tracker::ContactTracker;
    use cageless::dynamics::{Model, RightHandSide};
    use cageless::reference::Structure;

    let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
    let model = Model::new(&case)?;
    let rhs = RightHandSide::new(&model);
    let mut tracker = ContactTracker::new(case.bearing.balls());
    tracker.update(&rhs.contacts());
    assert_eq!(tracker.count(), 0);
    Ok(())
}

#[test]
fn coordinates() {
    use cageless::dynamics::coordinates::{BALL, Kind};

    assert_eq!(BALL[2].name, "vx_m_s");
    assert_eq!(BALL[2].kind, Kind::VelocityOf(0));
}

#[test]
fn state() {
    use cageless::ball::BallMotion;
    use cageless::dynamics::state::State;

    let mut state = State::new(14);
    state.set_ball(
        3,
        BallMotion {
            x: 0.02,
            ..BallMotion::default()
        },
    );
    assert_eq!(state.x_m()[3], 0.02);
}

#[test]
fn outer_section() {
    use cageless::equilibrium::space::outer_section::{Flanks, OuterSection};
    use cageless::numerics::vector::SectionVector;

    let flanks = Flanks {
        angle_rad: 0.5,
        section_angle_rad: 0.0,
        nominal_gap_m: 0.19e-3,
        depth_error_m: 0.0,
        depth_m: 0.0,
        slot: None,
    };
    let section = OuterSection {
        gap_m: 0.19e-3,
        axial_m: 0.0,
        flanks: Some(flanks),
    };
    // In the middle a ball sits on both flanks, far from it on one.
    for (axial, contacts) in [(0.0, 2), (40e-6, 1)] {
        let place = SectionVector {
            radial: 5e-6,
            axial,
        };
        assert_eq!(section.contacts(place).len(), contacts);
    }
}

#[test]
fn film() {
    use cageless::film::{LubricatedContact, OilGrade, Rolling};
    use cageless::reference;

    let oil = OilGrade::IsoVg32.at(70.0);
    let contact = LubricatedContact::outer(&reference::bearing(), 1.0);
    let rolling = Rolling {
        load_n: 20.0,
        speed_m_s: 13.75,
    };
    let force_n = contact.rolling_force(&oil, rolling).isothermal_n();
    assert!(force_n > 0.05 && force_n < 0.15);
}

#[test]
fn gap() -> Result<(), cageless::equilibrium::EquilibriumError> {
    use cageless::dynamics::Model;
    use cageless::dynamics::coordinates::BallCoordinate;
    use cageless::gap::GapRange;
    use cageless::initial_conditions::initial_state;
    use cageless::numerics::vector::PlaneVector;
    use cageless::reference::Structure;

    let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
    let (state, _angles) = initial_state(&case)?;
    let [x, y] = [BallCoordinate::X, BallCoordinate::Y]
        .map(|coordinate| state.layout().balls_of(state.values(), coordinate));
    let model = Model::new(&case)?;
    let mut range = GapRange::new(&model);
    range.look(PlaneVector { x, y }, PlaneVector::default());
    // All gaps are equal at the start.
    let [least, most] = range.range_rad();
    assert!((most - least).abs() < 1e-12 && (least.to_degrees() - 1.816).abs() < 1e-3);
    Ok(())
}

#[test]
fn tableau() {
    use cageless::integrator::tableau::DORMAND_PRINCE_5;

    let weights: f64 = DORMAND_PRINCE_5.b.iter().sum();
    assert!((weights - 1.0).abs() < 1e-15);
}

#[test]
fn aligned() {
    use cageless::numerics::aligned::Aligned;

    let mut values = Aligned::zeros(3);
    values[2] = 1.0;
    assert_eq!(*values, [0.0, 0.0, 1.0]);
    assert_eq!(values.as_ptr().align_offset(64), 0);
}

#[test]
fn bspline() {
    use cageless::numerics::bspline::{basis, interpolate};

    let line = |x: f64| [x, 2.0 * x, 0.0];
    let control = interpolate(&[0.0, 1.0, 2.0], &[0.0, 1.0, 2.0].map(line), [line(1.0); 2]);
    let weights = basis(&[0.0, 1.0, 2.0], 0, 0.25);
    let y: f64 = weights.iter().zip(&control).map(|(w, c)| w * c[1]).sum();
    assert!((y - 0.5).abs() < 1e-12);
}

#[test]
fn cholesky() {
    use cageless::numerics::cholesky::solve;

    let [x, y] = solve(&[[4.0, 2.0], [2.0, 3.0]], 0.0, [10.0, 9.0]).unwrap();
    assert!((x - 1.5).abs() < 1e-15 && (y - 2.0).abs() < 1e-15);
}

#[test]
fn lanes() {
    use cageless::numerics::lanes::{BATCH_WIDTH, LANES};

    assert_eq!(LANES, 2 * BATCH_WIDTH); // two balls of each bearing in a block
}

#[test]
fn student() {
    use cageless::numerics::student::{two_sided_limit, two_sided_tail};

    let limit = two_sided_limit(0.05, 4);
    assert!((limit - 2.776).abs() < 1e-3); // as in every table
    assert!((two_sided_tail(limit, 4) - 0.05).abs() < 1e-9);
}

#[test]
fn taylor() {
    use cageless::numerics::taylor::Taylor;

    let [x, y] = Taylor::variables([3.0, 4.0]);
    let length = (x * x + y * y).sqrt();
    assert_eq!(length.value, 5.0);
    assert!((length.gradient[0] - 0.6).abs() < 1e-15);
    assert!((length.hessian[0][1] + 3.0 * 4.0 / 125.0).abs() < 1e-15);
}

#[test]
fn outer_contact_geometry() -> Result<(), cageless::InputError> {
    use cageless::outer_contact_geometry::outer_contact_geometry;
    use cageless::reference;

    let bearing = reference::bearing(); // Zhao 2022, Table 1
    // On the plain raceway the arm of friction is the radius of the ball.
    let rw = bearing.ball_radius_m();
    assert_eq!(
        outer_contact_geometry(&bearing, &[], 0.0, rw).effective_radius_m,
        rw
    );
    Ok(())
}

#[test]
fn spline_flanks() -> Result<(), cageless::InputError> {
    use cageless::raceway::SplineFlanks;

    // 20° in the middle, 10° half way, 0 at the ends.
    let rows = [
        [0.0, 20.0],
        [6.0, 18.0],
        [12.5, 10.0],
        [19.0, 4.0],
        [25.0, 0.0],
    ];
    let rows = rows.map(|row: [f64; 2]| row.map(f64::to_radians));
    let flanks = SplineFlanks::through(&rows)?;
    assert_eq!(flanks.middle_rad(), 20f64.to_radians());
    assert_eq!(flanks.half_angle_rad(), 25f64.to_radians());
    Ok(())
}

#[test]
fn ring_support() {
    use cageless::reference::Structure;
    let bearing = Structure::D.case().bearing; // Zhao 2022, Table 1: 14 balls
    assert!(!bearing.can_fall_between_balls());
    // Bunched, the balls that hold the ring reach over more than half of the circle.
    let (ball, pitch) = (bearing.ball_radius_m(), bearing.pitch_radius_m());
    let least = cageless::Bearing::balls_that_hold_ring(ball, pitch);
    let epsilon = bearing.ball_angle_rad().to_degrees();
    assert!((least - 1) as f64 * epsilon > 180.0 && (least - 2) as f64 * epsilon <= 180.0);
}

#[test]
fn rotating_ring() {
    use cageless::Material;
    use cageless::rotating_ring::{RingDiameters, rotating_growth_m};

    // The inner ring of Zhao 2022 on a bore of 30 mm at 30,000 rpm: its raceway grows by 3.3 µm.
    let speed_rad_s = 30e3 / 60.0 * std::f64::consts::TAU;
    let diameters = RingDiameters {
        inside_m: 30e-3,
        outside_m: 36.48e-3,
    };
    let growth_m = rotating_growth_m(&Material::STEEL, speed_rad_s, &diameters, 36.48e-3);
    assert!((growth_m - 3.35e-6).abs() < 1e-8);
}

#[test]
fn steady() {
    use cageless::steady::leading_ball;

    // Ball 3 is the slowest, and the balls behind it, 2, 1 and 4, push it along.
    assert_eq!(leading_ball(&[0.0, 2.0, -3.0, 1.0]), 2);
}

#[test]
fn vibration() {
    use cageless::vibration::Measurement;

    // A sine of amplitude 2 sampled every 10 µs, kept at 10 kHz.
    let mut measurement = Measurement::new(1e-5, 1e4, 0.0);
    (0..100_000).for_each(|k| measurement.push(2.0 * (k as f64 * 0.01).sin()));
    assert!((measurement.rms() - 2f64.sqrt()).abs() < 0.02);
}

#[test]
fn world() -> Result<(), cageless::equilibrium::EquilibriumError> {
    use cageless::initial_conditions::initial_state;
    use cageless::reference;
    use cageless::world::body::RotorCoordinate;

    let (state, _angles) = initial_state(&reference::rotor_drop())?;
    assert!((state.at(RotorCoordinate::Speed) - 3141.6).abs() < 0.1); // 30 000 rpm
    assert_eq!(state.at(RotorCoordinate::Z), 0.0); // held in the plane
    Ok(())
}
