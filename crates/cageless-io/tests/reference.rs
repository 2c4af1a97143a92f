//! Trajectories against references computed independently: a second implementation of the
//! equations in quadruple precision (DOP853 with error control, r(ψ) by root finding,
//! contact edges located). Files in `reference/`.

use crate::common::{folder, scaled_error_of};
use cageless::simulation::{Control, run};
use cageless::{Case, IntegrationMethod};
use cageless_io::case_file::CaseFile;

fn case(name: &str) -> Case {
    CaseFile::read(&folder().join(format!("{name}.toml")), &[])
        .unwrap()
        .case()
        .clone()
}

/// RMS over the states of (y − reference)/scale at 2 ms, ABM4.
fn scaled_error(name: &str, step_us: f64) -> f64 {
    let mut case = case(name);
    case.solver.step_s = step_us * 1e-6;
    error_of(&case, name)
}

/// The same with the method and step of `case`.
fn error_of(case: &Case, name: &str) -> f64 {
    let end = run(case, &mut [], &mut |_| Control::Continue(()))
        .unwrap()
        .state;
    scaled_error_of(case, name, &end)
}

/// The undamped reference case: under 1e-5 at 0.2 µs, and falling by order 4 or better
/// per halving between 1 and 0.25 µs.
#[test]
fn cb74_converges() {
    let steps = [1.0, 0.5, 0.25];
    let errors = steps.map(|step| scaled_error("cb74", step));
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!(order > 4.0, "{errors:?}");
    }
    let fine = scaled_error("cb74", 0.2);
    assert!(fine < 1e-5, "{fine:e}");
    // Below, the edges of the contacts, where the third derivative of δ^(3/2) is infinite,
    // leave a lower order.
    let finer = scaled_error("cb74", 0.1);
    assert!(finer < fine / 4.0, "{finer:e}");
}

/// Other bearings, profiles, clearances, damping and impacts, with the step of their files.
#[test]
fn other_cases_agree() {
    let mut failed = vec![];
    for (name, step_us) in [
        ("cb74_paper", 0.2),
        ("b16_physical", 0.2),
        ("b16_paper", 0.2),
        ("b16r", 0.2),
        ("clear6_physical", 0.1),
        ("clear6_paper", 0.1),
        ("clear6_damped", 0.2),
        ("crowd", 0.2),
    ] {
        let error = scaled_error(name, step_us);
        println!("{name}: {error:.2e} at {step_us} µs");
        if !(error < 1e-5) {
            failed.push((name, error));
        }
    }
    assert!(failed.is_empty(), "{failed:?}");
}

/// The production step is good for 1e-2 where balls do not fly free.
#[test]
fn a_step_of_1_us_is_good_enough_for_design() {
    for name in ["b16_physical", "b16_paper", "crowd"] {
        let error = scaled_error(name, 1.0);
        println!("{name}: {error:.2e} at 1 µs");
        assert!(error < 1e-2, "{name}: {error:e}");
    }
}

/// The adaptive method gives references of its own.
#[test]
fn adaptive_agrees_with_the_references() {
    for (name, tolerance, most) in [
        ("cb74", 1e-13, 1e-6),
        ("crowd", 1e-12, 1e-6),
        ("b16_paper", 1e-10, 1e-8),
    ] {
        let mut case = case(name);
        case.solver.method = IntegrationMethod::Adaptive;
        case.solver.step_s = 5e-6;
        case.solver.tolerance = tolerance;
        let error = error_of(&case, name);
        println!("{name}: {error:.2e}");
        assert!(error < most, "{name}: {error:e}");
    }
}

/// Leapfrog converges to them, too: order 2 but for the edges of the damped contacts.
#[test]
fn leapfrog_converges_to_the_references() {
    let error = |step_us: f64| {
        let mut case = case("b16_physical");
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.step_s = step_us * 1e-6;
        error_of(&case, "b16_physical")
    };
    let (coarse, fine) = (error(1.0), error(0.25));
    println!("{coarse:.2e} {fine:.2e}");
    assert!((coarse / fine).log2() / 2.0 > 1.4, "{coarse:e} {fine:e}");
}
