//! Friction of films beside asperities: closed forms, limits, and the motion with it.

use crate::common::oil;
use crate::common::*;
use cageless::contact::{AtFlanks, FilmTraction, FlankSliding};
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::{Model, RightHandSide};
use cageless::film::{Film, LubricatedContact, Oil, Rolling, Traction};
use cageless::integrator::System;
use cageless::prelude::*;
use cageless::reference::{Structure, conventional, rotor_drop};
use cageless::step_limits::StepLimits;
use cageless::summary::Summary;
use cageless::{FlankModel, Formulation, FrictionModel, Gaps, Regularisation, Start, StartState};
use std::f64::consts::PI;

/// The film of an oil as friction; asperities with μ = 0.11.
pub(super) fn sheared(mut case: Case, film: Film) -> Case {
    case.contact.friction.coefficient = 0.11;
    case.film = Some(Film {
        traction: Traction::Film,
        ..film
    });
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.step_s = 1e-6;
    case
}

/// A composite roughness so small that no asperity carries.
pub(super) fn smooth(film: Film) -> Film {
    Film {
        roughness_m: 1e-9,
        ..film
    }
}

/// Contact whose film is sheared.
struct Sheared {
    contact: LubricatedContact,
    oil: Oil,
    /// G ca cb C11, N^(1/3).
    creep_n1_3: f64,
}

impl Sheared {
    /// g, N·s/m, and the area, m²: film and elastic creep in series.
    fn slope(&self, at: Rolling) -> [f64; 2] {
        let (contact, oil) = (&self.contact, &self.oil);
        let area = PI * contact.cross_axis_m(at.load_n).powi(2) * contact.axis_ratio;
        let h = contact.film_thickness(oil, at).central_m;
        let stiff = oil.viscosity_pa_s.ln() + 9.67;
        let z = oil.pressure_viscosity_1_pa / (5.1e-9 * stiff);
        let grown = (1.0 + 5.1e-9 * at.load_n / area).powf(z) - 1.0;
        let viscous = oil.viscosity_pa_s * (stiff * grown).exp() * area / h;
        let creep = self.creep_n1_3 * at.load_n.powf(2.0 / 3.0) / at.speed_m_s;
        [1.0 / (1.0 / viscous + 1.0 / creep), area]
    }

    /// Friction at a sliding speed with asperities of a dry friction, N.
    fn friction_n(&self, at: Rolling, roughness_m: f64, slip_m_s: f64, dry_n: f64) -> f64 {
        let h = self.contact.film_thickness(&self.oil, at).central_m;
        let share = (-2.1 * (h / roughness_m).powf(0.85)).exp();
        let [slope, area] = self.slope(at);
        let shear = area * 5e6;
        let film = shear * (slope * slip_m_s / shear).asinh();
        let film = film / (1.0 + (film / (0.05 * at.load_n)).powi(2)).sqrt();
        share * dry_n + (1.0 - share) * film
    }
}

/// Slopes of the film of 5 mPa·s at the outer contact of structure (d), 0.09 N·s/m at 20 N and 709 at 470 N, and the
/// step limits of what they are stiff for.
#[test]
fn slopes_of_the_film() {
    let oil = Oil {
        pressure_viscosity_1_pa: 1.62e-8,
        ..oil(5.0)
    };
    let case = sheared(Structure::D.case(), smooth(Film::flooded(oil)));
    let film = Model::new(&case).unwrap().film.clone().unwrap();
    let outer = film.traction.unwrap().outer;
    for (load_n, expected) in [(20.0, 0.0885), (470.0, 709.0)] {
        let rolling = Rolling {
            load_n,
            speed_m_s: 13.74,
        };
        let found = outer.slope_n_s_m(rolling);
        assert!((found / expected - 1.0).abs() < 2e-3, "{load_n}: {found}");
        let formula = Sheared {
            contact: LubricatedContact::outer(&case.bearing, 1.0),
            oil,
            creep_n1_3: case.creep_stiffness_n1_3()[0],
        };
        let [slope, _] = formula.slope(rolling);
        assert!((found / slope - 1.0).abs() < 3e-6, "{found} {slope}");
    }
    let mut dry = case.clone();
    dry.film.as_mut().unwrap().traction = Traction::Law;
    let rates = [&case, &dry].map(|case| StepLimits::new(case).friction_1_s);
    let more = rates[0] - rates[1];
    assert!((5.0 * 709.0 / 3.552e-3..1e8).contains(&more), "{rates:?}");
    assert!(StepLimits::friction_is_stiff(&case));
}

/// The slope is the derivative of the friction; it falls, as Newton's method needs it, to both sides.
#[test]
fn slope_is_the_derivative() {
    let film = FilmTraction {
        asperity_share: 0.2,
        limit: 12.0,
        stress_ratio: 0.03,
        inverse_speed: 400.0,
    };
    let [at_rest_n, steepest] = film.mixed([0.0; 2], 0.0);
    assert_eq!(at_rest_n, 0.0);
    let mut last = steepest;
    for k in 0..200 {
        let slip = 1e-6 * 10f64.powf(0.06 * f64::from(k));
        let force = |slip: f64| film.mixed([0.0; 2], slip)[0];
        let h = 1e-4 * slip;
        let expected = (force(slip + h) - force(slip - h)) / (2.0 * h);
        let [found_n, slope] = film.mixed([0.0; 2], slip);
        assert!((slope / expected - 1.0).abs() < 1e-6, "{slip}: {slope}");
        assert!(slope <= last && found_n <= steepest * slip && found_n < film.limit);
        assert_eq!(force(-slip), -found_n);
        last = slope;
    }
    // Asperities add their share.
    assert_eq!(film.mixed([5.0, 7.0], 0.0), [1.0, 0.2 * 7.0 + steepest]);
}

/// Without film the law is left to the bit, near it to the share that asperities leave; without asperities nothing is
/// left of the law.
#[test]
fn limits_of_no_film_and_of_a_full_one() {
    let case = sheared(Structure::D.case(), Film::flooded(oil(5.0)));
    let model = Model::new(&case).unwrap();
    let inner = model.film.as_ref().unwrap().traction.unwrap().inner;
    let dry = [7.0, 11.0];
    // ln (2.1 Λ^0.85) of the curve as of rougher surfaces.
    let rough = |decades: f64| {
        let asperity = inner.asperity - 0.85 * decades * std::f64::consts::LN_10;
        let curve = cageless::film::TractionCurve { asperity, ..inner };
        curve.at(100.0, 13.75 * 13.75, 0.0)
    };
    assert_eq!(rough(24.0).asperity_share, 1.0);
    assert_eq!(rough(24.0).mixed(dry, 0.3), dry);
    for decades in [4.0, 8.0, 12.0] {
        let film = rough(decades);
        let share = 2.1 * (10f64.powf(-decades) * 3.5).powf(0.85);
        let left = 1.0 - film.asperity_share;
        assert!(
            left > 0.5 * share && left < 2.0 * share,
            "{decades}: {left}"
        );
        let [found, _] = film.mixed(dry, 0.3);
        assert!((found - dry[0]).abs() <= 1.01 * left * dry[0], "{found}");
    }
    assert!(rough(-2.0).asperity_share < 1e-30);
    assert_eq!(
        rough(-2.0).mixed(dry, 0.3),
        rough(-2.0).mixed([0.0; 2], 0.3)
    );
}

/// Friction of every contact of a motion is that of the formulas, over rolling and sliding; so is its heat.
#[test]
fn friction_of_a_motion_follows_the_formulas() {
    let mut case = sheared(Structure::D.case(), Film::flooded(oil(2.0)));
    case.contact.outer_friction_factor = 3.0;
    let mut simulation = Simulation::new(&case).unwrap();
    simulation.advance_to(1.234e-3).unwrap();
    let state = simulation.outcome().state;
    let model = Model::new(&case).unwrap();
    let mut equations = RightHandSide::new(&model);
    let mut rates = vec![0.0; state.values().len()];
    equations.derivative(0.0, state.values(), &mut rates);
    let (contacts, d) = (equations.contacts(), case.bearing.dimensions());
    let surface = case.operation.inner_speed_rad_s * d.inner_groove_bottom_radius_m;
    let [outer_n1_3, inner_n1_3] = case.creep_stiffness_n1_3();
    let at_inner = Sheared {
        contact: LubricatedContact::inner(&case.bearing),
        oil: oil(2.0),
        creep_n1_3: inner_n1_3,
    };
    let plain = LubricatedContact::outer(&case.bearing, 1.0);
    let dry_n = |load_n: f64, slip: f64| 0.11 * load_n * (slip / 0.02).tanh();
    let (mut counts, mut heat_w) = ([0; 3], [0.0; 2]);
    for k in 0..case.balls() {
        let at = |coordinate| state.values()[state.layout().ball(coordinate, k)];
        let rho = at(BallCoordinate::X).hypot(at(BallCoordinate::Y));
        let (rw, r) = (d.ball_radius_m, contacts.effective_radius_m(k));
        let (spin, orbit) = (contacts.rotation_rad_s(k), contacts.orbit_speed_rad_s(k));
        let on_flanks = r < rw - 1e-9;
        let number = if on_flanks { 2.0 } else { 1.0 };
        let contact = LubricatedContact::outer(&case.bearing, (r / rw).min(1.0));
        let area = |of: &LubricatedContact| of.cross_axis_m_n1_3.powi(2) * of.axis_ratio;
        let at_outer = Sheared {
            contact,
            oil: oil(2.0),
            creep_n1_3: outer_n1_3 * area(&contact) / area(&plain),
        };
        let one = Rolling {
            load_n: contacts.outer_force_n(k) * rw / r / number,
            speed_m_s: 0.5 * (orbit * (rho + 2.0 * r) + spin * r),
        };
        let slip = contacts.outer_sliding_m_s(k);
        let dry = 3.0 * dry_n(one.load_n, slip);
        let expected = number * at_outer.friction_n(one, 1e-7, slip, dry);
        let found = contacts.outer_friction_n(k);
        // The film of a flank is linear over 1 − cos α.
        let within = if on_flanks { 1e-3 } else { 1e-5 };
        let miss = (found - expected).abs();
        assert!(
            miss < within * expected.abs() + 1e-9,
            "{k}: {found} {expected}"
        );
        counts[usize::from(on_flanks)] += 1;
        heat_w[0] += found * slip;
        let slip = contacts.inner_sliding_m_s(k);
        let found = contacts.inner_friction_n(k);
        heat_w[1] += found * slip;
        let tangential = surface - slip - spin * rw;
        let q = d.inner_groove_bottom_radius_m + rw - contacts.inner_deflection_m(k);
        let arm = (d.inner_groove_bottom_radius_m - rw) / q;
        let rolling = Rolling {
            load_n: contacts.inner_force_n(k),
            speed_m_s: 0.5 * (surface + spin * rw - tangential * arm),
        };
        if rolling.load_n < 1.0 {
            continue;
        }
        let expected = at_inner.friction_n(rolling, 1e-7, slip, dry_n(rolling.load_n, slip));
        let miss = (found - expected).abs();
        assert!(
            miss < 1e-5 * expected.abs() + 1e-9,
            "{k}: {found} {expected}"
        );
        counts[2] += 1;
    }
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    for (term, expected) in [EnergyTerm::OuterFriction, EnergyTerm::InnerFriction]
        .into_iter()
        .zip(heat_w)
    {
        let found = rates[state.layout().energy_term(term)];
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
}

/// At flanks the parts of the sliding share one friction, as of any law; at the inner raceway nothing of it remains.
#[test]
fn elastic_flanks_have_the_film_too() {
    let mut case = sheared(Structure::D.case(), Film::flooded(oil(5.0)));
    let lag = |case: &Case| summary(case).half_turn_lag_rad.unwrap().to_degrees();
    case.solver.duration_s = 0.03;
    let rigid = lag(&case);
    case.flanks = FlankModel::Elastic;
    let elastic = lag(&case);
    assert!(
        (rigid - elastic).abs() < 0.01 && rigid != elastic,
        "{rigid} {elastic}"
    );
    let film = FilmTraction {
        asperity_share: 0.1,
        limit: 20.0,
        stress_ratio: 0.04,
        inverse_speed: 300.0,
    };
    let law = cageless::contact::AtRaceways {
        law: cageless::contact::AtKnees {
            law: cageless::contact::friction::Mixed(cageless::contact::friction::Smooth {
                coefficient: 0.1,
                inverse_regularisation_speed: 50.0,
            }),
            inverse_knees: [50.0; 2],
        },
        films: [film, FilmTraction::default()],
    };
    use cageless::contact::Law;
    let sliding = FlankSliding {
        along_square: 0.16,
        inverse_knee: 50.0,
        spin_square: 0.0,
    };
    let at_flanks = AtFlanks { law, sliding };
    let [[across, _], inner] = at_flanks.forces([0.3, 0.3], [400.0, 0.0]);
    let [whole, _] = law.force(0.5, 400.0);
    assert!((across / whole - 0.6).abs() < 1e-12, "{across} {whole}");
    assert_eq!(inner, [0.0; 2]);
    // Spin of 1.2 m/s beside 0.5 m/s: the film is sheared at 1.3 m/s.
    let [spinning, slope] = film.mixed_spinning([0.0; 2], 0.5, 1.44);
    let [of_both, _] = film.mixed([0.0; 2], 1.3);
    assert!((spinning / of_both - 0.5 / 1.3).abs() < 1e-12);
    let at = |slip: f64| film.mixed_spinning([0.0; 2], slip, 1.44)[0];
    let expected = (at(0.5 + 1e-5) - at(0.5 - 1e-5)) / 2e-5;
    assert!((slope / expected - 1.0).abs() < 1e-7, "{slope} {expected}");
    let resting = film.mixed_spinning([1.0, 3.0], 1e-9, 1e-18);
    assert_eq!(resting, film.mixed([1.0, 3.0], 1e-9));
    assert_eq!(at_flanks.inverse_scales(), [300.0, 50.0]);
}

fn summary(case: &Case) -> Summary {
    let mut recorder = SummaryRecorder::new();
    cageless::simulation::run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    recorder.summary().unwrap()
}

/// Lag of half a turn on the plain ring, in degrees.
pub(super) fn lag_deg(case: &Case) -> f64 {
    let mut case = case.clone();
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.12;
    case.solver.transient_s = Some(0.06);
    summary(&case).half_turn_lag_rad.unwrap().to_degrees()
}

/// A film too thin to part the surfaces leaves the law; a thick one changes the lag of the law of μ = 0.007 by less than
/// a tenth.
#[test]
fn lag_with_a_thin_and_a_thick_film() {
    let thin = Film {
        roughness_m: 1e-5,
        ..Film::flooded(oil(0.1))
    };
    let of_law = |case: &Case, coefficient: f64| {
        let mut case = case.clone();
        case.contact.friction.coefficient = coefficient;
        case.film.as_mut().unwrap().traction = Traction::Law;
        lag_deg(&case)
    };
    let case = sheared(conventional(), thin);
    let relative = lag_deg(&case) / of_law(&case, 0.11) - 1.0;
    assert!(relative.abs() < 2e-3, "{relative}");
    for (mpa_s, expected) in [(2.0, 1.00), (5.0, 0.95), (20.0, 0.92)] {
        let case = sheared(conventional(), Film::flooded(oil(mpa_s)));
        let relative = lag_deg(&case) / of_law(&case, 0.007);
        assert!((relative - expected).abs() < 0.01, "{mpa_s}: {relative}");
    }
}

/// Balls reach the load zone sliding on the outer raceway at 0.11 and 0.17 m/s in 5 and 20 mPa·s; at 2 asperities still
/// hold them.
#[test]
fn unloaded_balls_slide() {
    let slips = [2.0, 5.0, 20.0].map(|mpa_s| {
        let oil = Oil::mineral(1e-3 * mpa_s, 0.035);
        let case = sheared(conventional(), Film::flooded(oil));
        let mut simulation = Simulation::new(&case).unwrap();
        let mut largest: f64 = 0.0;
        for k in 0..40 {
            simulation.advance_to(0.05 + 3e-4 * f64::from(k)).unwrap();
            let view = simulation.view();
            for ball in 0..14 {
                if view.ball(ball).inner_force_n() == 0.0 {
                    largest = largest.max(view.ball(ball).outer_sliding_m_s().abs());
                }
            }
        }
        largest
    });
    assert!(slips[0] < 0.02, "{slips:?}");
    assert!((slips[1] - 0.11).abs() < 0.02, "{slips:?}");
    assert!((slips[2] - 0.17).abs() < 0.03, "{slips:?}");
}

/// Implicit friction of the leapfrog method converges to second order to explicit friction of a method of high order,
/// with a regularisation speed and with creep: all balls pressed, so that no contact opens.
#[test]
fn implicit_friction_is_of_second_order() {
    for regularisation in [Regularisation::Speed, Regularisation::Kalker] {
        let mut case = sheared(conventional(), Film::flooded(oil(5.0)));
        let mut dimensions = case.bearing.dimensions().clone();
        dimensions.inner_groove_bottom_radius_m += 10e-6;
        case.bearing = Bearing::new(dimensions, Material::STEEL).unwrap();
        case.operation.radial_load_n = 300.0;
        case.contact.regularisation = regularisation;
        case.solver.duration_s = 0.001;
        let at = |method, step_s| {
            let mut case = case.clone();
            (case.solver.method, case.solver.step_s) = (method, step_s);
            complete(&case).state
        };
        let truth = at(IntegrationMethod::Abm4, 0.05e-6);
        let misses = [2e-6, 1e-6, 0.5e-6].map(|step_s| {
            let state = at(IntegrationMethod::VelocityVerlet, step_s);
            let spins = (0..14).map(|k| state.ball_motion(k).spin - truth.ball_motion(k).spin);
            spins.map(f64::abs).fold(0.0, f64::max)
        });
        let falls = (1..3).all(|k| misses[k - 1] > 3.0 * misses[k]);
        assert!(falls && misses[0] < 0.1, "{regularisation:?}: {misses:?}");
    }
}

/// On flanks, where one contact becomes two at the ends of a raceway, it converges too.
#[test]
fn implicit_friction_converges_on_flanks() {
    for flanks in [FlankModel::Rigid, FlankModel::Elastic] {
        let mut case = sheared(structure(5.1, 25.2), Film::flooded(oil(5.0)));
        case.flanks = flanks;
        case.solver.duration_s = 0.001;
        let at = |method, step_s| {
            let mut case = case.clone();
            (case.solver.method, case.solver.step_s) = (method, step_s);
            complete(&case).state
        };
        let truth = at(IntegrationMethod::Abm4, 0.05e-6);
        let misses = [2e-6, 0.5e-6].map(|step_s| {
            let state = at(IntegrationMethod::VelocityVerlet, step_s);
            let spins = (0..14).map(|k| state.ball_motion(k).spin - truth.ball_motion(k).spin);
            spins.map(f64::abs).fold(0.0, f64::max)
        });
        assert!(
            misses[1] < 0.6 * misses[0] && misses[0] < 0.01,
            "{misses:?}"
        );
    }
}

/// The ledger closes to second order in the leapfrog method, collisions and all, as it does without the traction.
#[test]
fn ledger_closes_with_the_step() {
    for flanks in [FlankModel::Rigid, FlankModel::Elastic] {
        let mut case = sheared(structure(5.1, 25.2), Film::flooded(oil(20.0)));
        case.flanks = flanks;
        let gaps = Gaps::random(&case.bearing, 0);
        case.start = Start::new(StartState::Settled, gaps, 0.0);
        case.solver.duration_s = 1e-2;
        let residual = |case: &Case, step_s: f64| {
            let mut case = case.clone();
            case.solver.step_s = step_s;
            complete(&case).energy_residual_relative.abs()
        };
        let residuals = [1e-6, 0.5e-6, 0.25e-6].map(|step_s| residual(&case, step_s));
        let mut law = case.clone();
        law.film.as_mut().unwrap().traction = Traction::Law;
        let without = residual(&law, 0.5e-6);
        assert!(summary(&case).collisions.all > 0);
        assert!(
            residuals[1] < 3.0 * without && residuals[2] < residuals[0] / 8.0,
            "{residuals:?} {without:e}"
        );
    }
}

/// Where no traction is computed it is refused by name.
#[test]
fn what_has_no_traction_is_refused() {
    let refused = |case: &Case, field: &str, why: &str| {
        let error = case.check().unwrap_err();
        assert_eq!(error.field, field);
        assert!(error.to_string().contains(why), "{error}");
    };
    let case = sheared(Structure::D.case(), Film::flooded(oil(5.0)));
    assert!(case.check().is_ok());
    let mut sticking = case.clone();
    sticking.contact.friction_law = FrictionModel::Coulomb;
    refused(&sticking, "traction", "not coulomb");
    let mut dry = case.clone();
    dry.film.as_mut().unwrap().supply = 0.0;
    refused(&dry, "traction", "without supply");
    let mut negative = case.clone();
    negative.film.as_mut().unwrap().traction_coefficient = -0.1;
    refused(&negative, "traction_coefficient", "at least 0");
    negative.film.as_mut().unwrap().traction_coefficient = 5.0;
    refused(&negative, "traction_coefficient", "at most 0.2");
    let drop = Case {
        film: case.film,
        ..rotor_drop()
    };
    assert!(drop.check().is_err());
    let paper = Case {
        formulation: Formulation::Paper,
        ..case
    };
    assert!(paper.check().is_err());
}
