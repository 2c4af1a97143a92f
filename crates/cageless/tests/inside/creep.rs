//! Friction with the creep of rolling contacts in place of a given regularisation speed.

use super::film_motion::summary;
use crate::common::*;
use cageless::contact::Friction;
use cageless::contact::creep::creep_coefficient;
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::dynamics::{Model, RightHandSide};
use cageless::equilibrium::settle;
use cageless::integrator::System;
use cageless::passage::{Passage, PassageRecorder};
use cageless::prelude::*;
use cageless::reference::Structure;
use cageless::{FlankModel, Formulation, FrictionModel, FrictionTable, Motion, Regularisation};

fn with_creep(mut case: Case) -> Case {
    case.contact.regularisation = Regularisation::Kalker;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.step_s = 1e-6;
    case
}

/// C11 of steel, of the rows of the table, of a line and beyond a/b = 10; quadratic in ν.
#[test]
fn creep_coefficients() {
    for (ratio, poisson, expected, within) in [
        (0.106754, 0.3, 3.56193, 5e-6),
        (0.137897, 0.3, 3.57638, 5e-6),
        (1.0, 0.3, 4.30720, 5e-6),
        (0.1, 0.25, 3.31, 1e-12),
        (0.5, 0.0, 2.88, 1e-12),
        (1.0 / 0.9, 0.5, 5.30, 1e-12),
        (10.0, 0.25, 11.7, 1e-12),
        (0.0, 0.25, std::f64::consts::PI.powi(2) / 3.0, 1e-12),
    ] {
        let found = creep_coefficient(ratio, poisson);
        assert!(
            (found - expected).abs() < within,
            "{ratio} {poisson}: {found}"
        );
    }
    for ratio in [0.1, 1.0, 10.0] {
        let [below, above] = [1.0 - 1e-9, 1.0 + 1e-9].map(|f| creep_coefficient(f * ratio, 0.3));
        assert!((above / below - 1.0).abs() < 1e-7, "{ratio}");
    }
}

/// v_s of structure (d) at 12 000 rpm, and of unequal materials.
#[test]
fn regularisation_speeds() {
    let mut case = with_creep(Structure::D.case());
    for (coefficient, [outer, inner], load_n, expected) in [
        (0.1, [1.0, 0.0], 470.0, 14.826e-3),
        (0.1, [1.0, 0.0], 100.0, 8.851e-3),
        (0.1, [1.0, 0.0], 20.0, 5.176e-3),
        (0.1, [1.0, 0.0], 10.0, 4.108e-3),
        (0.1, [0.0, 1.0], 470.0, 18.015e-3),
        (0.007, [1.0, 0.0], 470.0, 1.0378e-3),
    ] {
        case.contact.friction.coefficient = coefficient;
        let creep = case.creep().unwrap();
        let stiffness = outer * creep.outer + inner * creep.inner;
        let found = 13.74 * f64::cbrt(load_n) / stiffness;
        assert!((found / expected - 1.0).abs() < 1e-3, "{load_n}: {found}");
    }
}

/// The mean over contacts at rest is that of the formula, and over a run close to it; none where the speed is given.
#[test]
fn regularisation_speeds_in_the_mean() {
    for raceways in [true, false] {
        let mut case = with_creep(Structure::D.case());
        if !raceways {
            case = case.conventional();
        }
        case.solver.duration_s = 0.01;
        let settled = settle(&case).unwrap();
        let creep = case.creep().unwrap();
        let d = case.bearing.dimensions();
        let orbit = case.rolling_orbit_speed_rad_s();
        let outer_m_s = orbit * d.outer_groove_bottom_radius_m;
        let inner_m_s = (case.operation.inner_speed_rad_s - orbit) * d.inner_groove_bottom_radius_m;
        let most = |flanks: &[f64; 2]| flanks[0].max(flanks[1]);
        let outer = settled
            .flank_force_n
            .iter()
            .map(|n| (most(n), outer_m_s / creep.outer));
        let inner = settled
            .rest
            .inner_force_n
            .iter()
            .map(|n| (*n, inner_m_s / creep.inner));
        let loaded: Vec<_> = outer.chain(inner).filter(|(n, _)| *n > 0.0).collect();
        let sum: f64 = loaded.iter().map(|(n, slope)| n.cbrt() * slope).sum();
        let expected = sum / loaded.len() as f64;
        let at_rest = case.regularisation_speed_mean_m_s(&settled).unwrap();
        assert!(
            (at_rest / expected - 1.0).abs() < 1e-6,
            "{at_rest} {expected}"
        );
        let run = summary(&case).regularisation_speed_mean_m_s.unwrap();
        assert!((run / at_rest - 1.0).abs() < 0.03, "{run} {at_rest}");
        let mut smooth = case.clone();
        smooth.contact.friction.coefficient = 0.0;
        assert_eq!(smooth.regularisation_speed_mean_m_s(&settled), None);
        case.contact.regularisation = Regularisation::Speed;
        assert_eq!(case.regularisation_speed_mean_m_s(&settled), None);
        assert_eq!(summary(&case).regularisation_speed_mean_m_s, None);
    }
}

/// Friction of every contact of a motion has the slope G ab C11/V over the sliding speed: on plain raceway and flanks in
/// the plane, on the plain one in space, with a factor at the outer raceway.
#[test]
fn friction_has_the_slope_of_creep() {
    for motion in [Motion::BySymmetry, Motion::Space] {
        let mut case = with_creep(Structure::D.case());
        (case.motion, case.contact.outer_friction_factor) = (motion, 3.0);
        let mut simulation = Simulation::new(&case).unwrap();
        simulation.advance_to(1.234e-3).unwrap();
        let state = simulation.outcome().state;
        let model = Model::new(&case).unwrap();
        let mut equations = RightHandSide::new(&model);
        equations.derivative(0.0, state.values(), &mut vec![0.0; state.values().len()]);
        let (contacts, d) = (equations.contacts(), case.bearing.dimensions());
        let surface = case.operation.inner_speed_rad_s * d.inner_groove_bottom_radius_m;
        let [outer, inner] = case.creep_stiffness_n1_3();
        let mut counts = [0; 3];
        for k in 0..case.balls() {
            let at = |coordinate| state.values()[state.layout().ball(coordinate, k)];
            let rho = at(BallCoordinate::X).hypot(at(BallCoordinate::Y));
            let (rw, r) = (d.ball_radius_m, contacts.effective_radius_m(k));
            let (spin, orbit) = (contacts.rotation_rad_s(k), contacts.orbit_speed_rad_s(k));
            let on_flanks = r < rw - 1e-9;
            let one = if on_flanks { 0.5 } else { 1.0 } * contacts.outer_force_n(k) * rw / r;
            let rolling = 0.5 * (orbit * (rho + 2.0 * r) + spin * r);
            let slip = contacts.outer_sliding_m_s(k);
            let places = [(one, rolling, slip, contacts.outer_friction_n(k), outer)];
            let slip = contacts.inner_sliding_m_s(k);
            let tangential = surface - slip - spin * rw;
            let q = d.inner_groove_bottom_radius_m + rw - contacts.inner_deflection_m(k);
            let arm = (d.inner_groove_bottom_radius_m - rw) / q;
            let rolling = 0.5 * (surface + spin * rw - tangential * arm);
            let friction = contacts.inner_friction_n(k);
            let inner = [(contacts.inner_force_n(k), rolling, slip, friction, inner)];
            for (place, (load, rolling, slip, friction, stiffness)) in
                places.into_iter().chain(inner).enumerate()
            {
                let twice = place == 0 && on_flanks;
                let least_n = if motion == Motion::Space { 100.0 } else { 1.0 };
                if load < least_n || (twice && motion == Motion::Space) {
                    continue;
                }
                let speed = (rolling * rolling + 1e-6).sqrt();
                let slope = stiffness * load.powf(2.0 / 3.0) / speed;
                let factor = if place == 0 { 3.0 } else { 1.0 };
                let limit = 0.007 * factor * load;
                let expected =
                    if twice { 2.0 } else { 1.0 } * limit * (slope * slip / limit).tanh();
                // In space the ellipse is that of the elastic part of the load, near it without bouncing.
                let within = if motion == Motion::Space { 1e-2 } else { 1e-6 };
                assert!(
                    (friction - expected).abs() < within * expected.abs() + 1e-9,
                    "{k} {place}: {friction} {expected}"
                );
                counts[if twice { 2 } else { place }] += 1;
            }
        }
        assert!(counts[0] > 1 && counts[1] > 1, "{counts:?}");
        assert!(counts[2] > 0 || motion == Motion::Space);
    }
}

/// Share of μN of a contact that slides at s v_s in a simplified theory of its own (FASTSIM): traction grows from the
/// leading edge of each strip by 3s/8 of its unit per length, up to the bound of Hertz.
fn fastsim(s: f64) -> f64 {
    let count = 400;
    let step = 2.0 / f64::from(count);
    let strips = (0..count).map(|k| {
        let y = -1.0 + (f64::from(k) + 0.5) * step;
        let edge = (1.0 - y * y).sqrt();
        let length = 2.0 * edge / f64::from(count);
        let mut traction: f64 = 0.0;
        (0..count)
            .map(|i| {
                let x = edge - (f64::from(i) + 0.5) * length;
                let grown = traction + 0.375 * s * if i == 0 { 0.5 * length } else { length };
                traction = grown.min(2.0 / std::f64::consts::PI * (edge * edge - x * x));
                traction * length * step
            })
            .sum::<f64>()
    });
    strips.sum()
}

/// The smooth law with this slope is near the simplified theory at every sliding speed.
#[test]
fn the_smooth_law_follows_the_simplified_theory() {
    for (s, expected) in [
        (0.25, 0.2296),
        (0.5, 0.4197),
        (1.0, 0.6978),
        (2.0, 0.9538),
        (3.0, 0.9995),
    ] {
        let found = fastsim(s);
        assert!((found - expected).abs() < 2e-3, "{s}: {found}");
        let (mut case, law) = (Structure::D.case(), 1.0 / 0.02);
        case.contact.friction.coefficient = 1.0;
        let friction = Friction::new(FrictionModel::Smooth, &case.contact.friction, 0.0);
        let [smooth, _] = friction.force(s / law, 1.0);
        assert!(
            (0.0..0.066).contains(&(smooth - found)) || s > 2.5,
            "{s}: {smooth} {found}"
        );
    }
}

/// Laws without a regularisation speed, the published equations and a table without friction at rest are refused by name.
#[test]
fn what_has_no_creep_is_refused() {
    let refused = |case: &Case, why: &str| {
        let error = case.check().unwrap_err();
        assert_eq!(error.field, "regularisation");
        assert!(error.to_string().contains(why), "{error}");
    };
    let case = with_creep(Structure::D.case());
    assert!(case.check().is_ok());
    let mut sticking = case.clone();
    sticking.contact.friction_law = FrictionModel::Coulomb;
    refused(&sticking, "Coulomb's law");
    let mut published = case.clone();
    published.formulation = Formulation::Paper;
    refused(&published, "published equations");
    let mut rising = case.clone();
    rising.contact.friction_law = FrictionModel::Table;
    let table = FrictionTable::new(vec![[0.0, 0.0], [0.1, 0.007]]).unwrap();
    rising.contact.friction.table = Some(table);
    refused(&rising, "no friction at rest");
    // Balls without any friction at the outer raceway move.
    let mut without = case;
    without.contact.outer_friction_factor = 0.0;
    without.solver.duration_s = 1e-3;
    assert!(complete(&without).energy_residual_relative.abs() < 1e-3);
}

/// Lag of a pass of the raceway by evenly spaced balls, in degrees.
fn lag_deg(case: &Case) -> f64 {
    let mut case = case.clone();
    case.solver.duration_s = 0.04;
    let [mut time_s, mut count] = [0.0; 2];
    let mut recorder = PassageRecorder::new(|passage: Passage| {
        if passage.enter_s > 0.01 {
            time_s += passage.leave_s - passage.enter_s;
            count += 1.0;
        }
        Ok(())
    });
    cageless::simulation::run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    drop(recorder);
    let angle_rad = 2.0 * case.raceways[0].half_angle_rad();
    (case.rolling_orbit_speed_rad_s() * time_s / count - angle_rad).to_degrees()
}

/// Creep hardly changes a lag, and in space the balls lag as on elastic flanks.
#[test]
fn lags_with_creep_agree_in_plane_and_space() {
    for coefficient in [0.007, 0.1] {
        let mut given = Structure::D.case();
        given.contact.friction.coefficient = coefficient;
        given.flanks = FlankModel::Elastic;
        given.set_method(IntegrationMethod::VelocityVerlet);
        let plane = with_creep(given.clone());
        let mut space = plane.clone();
        space.motion = Motion::Space;
        let [given, plane, space] = [&given, &plane, &space].map(lag_deg);
        assert!(
            (plane - given).abs() < 3e-3,
            "{coefficient}: {plane} {given}"
        );
        assert!(
            (plane - space).abs() < 1e-4,
            "{coefficient}: {plane} {space}"
        );
    }
}

/// Laws whose friction is constant are one law with creep, and bodies at the edges of a slot keep the ledger.
#[test]
fn every_law_has_creep_and_so_has_a_slot() {
    let mut smooth = with_creep(structure(5.1, 25.2));
    smooth.solver.duration_s = 1e-3;
    let mu = smooth.contact.friction.coefficient;
    let mut stribeck = smooth.clone();
    stribeck.contact.friction_law = FrictionModel::Stribeck;
    stribeck.contact.friction.static_coefficient = Some(mu);
    stribeck.contact.friction.stribeck_speed_m_s = Some(0.1);
    let mut table = smooth.clone();
    table.contact.friction_law = FrictionModel::Table;
    let constant = FrictionTable::new(vec![[0.0, mu], [0.1, mu]]).unwrap();
    table.contact.friction.table = Some(constant);
    let end = complete(&smooth).state;
    for case in [stribeck, table] {
        let other = complete(&case).state;
        for (a, b) in end.values().iter().zip(other.values()) {
            assert!((a - b).abs() < 1e-7 * (1e-3 + a.abs()), "{a} {b}");
        }
    }
    let mut slot = with_creep(slotted());
    slot.solver.duration_s = 0.01;
    let residual = complete(&slot).energy_residual_relative;
    assert!(residual.abs() < 1e-3, "{residual:e}");
}
