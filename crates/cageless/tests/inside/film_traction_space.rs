//! Friction of films beside asperities in space: the plane, limits, energy, rows, order.

use super::film_motion::summary;
use super::film_traction::{lag_deg, sheared, smooth};
use super::space_rows::{angular_contact, pair};
use crate::common::oil;
use crate::common::*;
use cageless::case::Motion;
use cageless::dynamics::energy::EnergyTerm;
use cageless::film::{Film, FilmAtRest, Traction};
use cageless::prelude::*;
use cageless::reference::{Structure, conventional};
use cageless::{Gaps, Regularisation, Start, StartState, equilibrium};

fn in_space(case: Case) -> Case {
    Case {
        motion: Motion::Space,
        ..case
    }
}

/// Structure (d) with the film of an oil as friction, under this axial load.
fn pressed(mpa_s: f64, axial_load_n: f64) -> Case {
    let mut case = sheared(Structure::D.case(), Film::flooded(oil(mpa_s)));
    case.operation.space.axial_load_n = axial_load_n;
    case
}

/// A case of the plane has in space its lag and its heat of friction: the widths of contacts, which slide differently
/// across the groove, change little.
#[test]
fn as_in_the_plane() {
    for mpa_s in [2.0, 5.0] {
        let mut case = sheared(conventional(), Film::flooded(oil(mpa_s)));
        case.solver.step_s = 2e-6;
        case.solver.duration_s = 0.03;
        case.solver.transient_s = Some(0.02);
        case.contact.friction_strips = 1;
        let [plane, space] = [case.clone(), in_space(case)].map(|case| {
            let summary = summary(&case);
            let means = summary.means.unwrap();
            let heats_w = [EnergyTerm::OuterFriction, EnergyTerm::InnerFriction];
            (
                summary.half_turn_lag_rad.unwrap().to_degrees(),
                heats_w.map(|term| means.power_w(term)).iter().sum::<f64>(),
            )
        });
        assert!((plane.0 - space.0).abs() < 0.02, "{plane:?} {space:?}");
        assert!(
            (plane.1 / space.1 - 1.0).abs() < 0.05,
            "{plane:?} {space:?}"
        );
    }
}

/// At rest the friction coefficient of a case of the plane is that of the plane; under an axial load, at the edges of a
/// slot and in rows there is one.
#[test]
fn coefficient_at_rest() {
    let of = |case: &Case| {
        let settled = equilibrium::settle(case).unwrap();
        let film = FilmAtRest::new(case, &settled).unwrap();
        film.mixed_friction_coefficient.unwrap()
    };
    for case in [conventional(), Structure::D.case()] {
        let case = sheared(case, Film::flooded(oil(5.0)));
        let [plane, space] = [of(&case), of(&in_space(case))];
        assert!((plane / space - 1.0).abs() < 2e-3, "{plane} {space}");
    }
    let rows = pair(&angular_contact(15.0, 15.0), 1.0, 15e-6);
    for case in [slotted(), rows] {
        let film = Film::flooded(oil(5.0));
        let [rough, smooth] = [film, smooth(film)].map(|film| of(&sheared(case.clone(), film)));
        assert!(
            0.005 < smooth && smooth < rough && rough < 0.11,
            "{smooth} {rough}"
        );
    }
    let thin = Film {
        roughness_m: 1e-5,
        ..Film::flooded(oil(0.1))
    };
    let mut case = sheared(conventional(), thin);
    case.operation.space.axial_load_n = 500.0;
    assert!((of(&case) / 0.11 - 1.0).abs() < 1e-2);
}

/// A full film leaves nothing of the law; without a film nothing but the law remains.
#[test]
fn limits_of_no_film_and_of_a_full_one() {
    let mut case = pressed(5.0, 500.0);
    case.solver.duration_s = 1e-3;
    let end = |case: &Case| complete(case).state.values().to_vec();
    let with = |film: Film, coefficient: f64, traction: Traction| {
        let mut case = case.clone();
        case.contact.friction.coefficient = coefficient;
        case.film = Some(Film { traction, ..film });
        end(&case)
    };
    let apart = |[a, b]: [Vec<f64>; 2]| {
        let misses = a
            .iter()
            .zip(&b)
            .map(|(a, b)| (a - b).abs() / (1.0 + a.abs()));
        misses.fold(0.0, f64::max)
    };
    let full = smooth(case.film.unwrap());
    let full = [0.11, 0.3].map(|coefficient| with(full, coefficient, Traction::Film));
    assert!(apart(full) < 1e-12);
    let thin = Film {
        roughness_m: 1e-5,
        ..Film::flooded(oil(0.1))
    };
    let left = [Traction::Film, Traction::Law].map(|traction| with(thin, 0.11, traction));
    assert!(apart(left.clone()) < 0.01, "{}", apart(left));
    let other = [Traction::Film, Traction::Law].map(|t| with(case.film.unwrap(), 0.11, t));
    assert!(apart(other) > 1.0);
}

/// Thin and thick films change the lag in space as in the plane.
#[test]
fn lag_as_in_the_plane() {
    let case = sheared(conventional(), Film::flooded(oil(20.0)));
    let [plane, space] = [case.clone(), in_space(case)].map(|case| lag_deg(&case));
    assert!((plane / space - 1.0).abs() < 0.01, "{plane} {space}");
}

/// The ledger closes to second order under an axial load, with collisions, on flanks, at the edges of a slot, and in a
/// pair of rows; with creep too.
#[test]
fn ledger_closes_in_space() {
    let mut bunched = conventional();
    let gaps = Gaps::random(&bunched.bearing, 0);
    bunched.start = Start::new(StartState::Settled, gaps, 0.0);
    let rows = pair(&angular_contact(15.0, 15.0), 1.0, 15e-6);
    let cases = [
        (bunched, Regularisation::Speed),
        (Structure::D.case(), Regularisation::Kalker),
        (slotted(), Regularisation::Speed),
        (rows, Regularisation::Speed),
    ];
    for (case, regularisation) in cases {
        let mut case = sheared(case, Film::flooded(oil(5.0)));
        case.contact.regularisation = regularisation;
        case.operation.space.axial_load_n = 200.0;
        case.solver.duration_s = 3e-3;
        let residual = |traction: Traction, step_s: f64| {
            let mut case = case.clone();
            case.solver.step_s = step_s;
            case.film.as_mut().unwrap().traction = traction;
            complete(&case).energy_residual_relative.abs()
        };
        let [coarse, fine] = [2e-6, 0.5e-6].map(|step_s| residual(Traction::Film, step_s));
        let law = residual(Traction::Law, 0.5e-6);
        assert!(
            fine < 3.0 * law || fine < coarse / 8.0,
            "{coarse:e} {fine:e} {law:e}"
        );
        assert!(fine < 1e-4, "{coarse:e} {fine:e} {law:e}");
    }
}

/// The motion with implicit friction converges to that of small steps as it does with the law alone, all balls pressed.
#[test]
fn implicit_friction_converges_as_that_of_the_law() {
    for regularisation in [Regularisation::Speed, Regularisation::Kalker] {
        let mut case = sheared(conventional(), Film::flooded(oil(5.0)));
        case.operation.space.axial_load_n = 3000.0;
        case.contact.regularisation = regularisation;
        case.solver.duration_s = 5e-4;
        let misses = |traction: Traction| {
            let at = |step_s| {
                let mut case = case.clone();
                case.solver.step_s = step_s;
                case.film.as_mut().unwrap().traction = traction;
                complete(&case).state
            };
            let truth = at(0.0625e-6);
            [2e-6, 1e-6, 0.5e-6].map(|step_s| {
                let state = at(step_s);
                let spins = (0..14).map(|k| state.ball_motion(k).spin - truth.ball_motion(k).spin);
                spins.map(f64::abs).fold(0.0, f64::max)
            })
        };
        let [film, law] = [Traction::Film, Traction::Law].map(misses);
        let falls = (1..3).all(|k| film[k - 1] > 2.2 * film[k]);
        let below = film.iter().zip(law).all(|(film, law)| *film < law);
        assert!(falls && below, "{regularisation:?}: {film:?} {law:?}");
    }
}

/// Rows of a pair under a load in the middle plane slide alike.
#[test]
fn rows_are_mirror_images() {
    let mut case = sheared(
        pair(&angular_contact(15.0, 15.0), 1.0, 15e-6),
        Film::flooded(oil(5.0)),
    );
    case.solver.duration_s = 1e-3;
    let state = complete(&case).state;
    for k in 0..14 {
        let [one, other] = [k, k + 14].map(|k| state.ball_motion(k).spin);
        assert!((one / other - 1.0).abs() < 1e-9, "{k}: {one} {other}");
    }
}
