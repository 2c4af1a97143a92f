//! Laws of friction of one's own: over what speeds they are tried, and what ends a run.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::common::*;
use cageless::Regularisation;
use cageless::prelude::*;
use cageless::simulation::{Cause, run};

/// Smooth friction through the trait.
struct Constant(f64);

impl FrictionLaw for Constant {
    fn coefficient(&self, _sliding_m_s: f64) -> [f64; 2] {
        [self.0, 0.0]
    }
}

/// Friction that falls by Stribeck and rises by the viscosity of the oil: above 2 from 980 m/s on.
struct Viscous;

impl FrictionLaw for Viscous {
    fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
        let over = sliding_m_s / 0.1;
        let excess = 0.08 * (-over * over).exp();
        [
            0.04 + excess + 0.002 * sliding_m_s,
            0.002 - 2.0 * over / 0.1 * excess,
        ]
    }
}

/// Friction of speeds that a bearing reaches, and nonsense beyond.
struct UpTo(f64);

impl FrictionLaw for UpTo {
    fn coefficient(&self, sliding_m_s: f64) -> [f64; 2] {
        match sliding_m_s <= self.0 {
            true => [0.05, 0.0],
            false => [f64::NAN, f64::NAN],
        }
    }
}

/// Friction that turns to nonsense after some evaluations.
struct Fickle {
    calls: AtomicU64,
    kept: u64,
}

impl Fickle {
    fn after(kept: u64) -> Self {
        Self {
            calls: AtomicU64::new(0),
            kept,
        }
    }
}

impl FrictionLaw for Fickle {
    fn coefficient(&self, _sliding_m_s: f64) -> [f64; 2] {
        let call = self.calls.fetch_add(1, Ordering::Relaxed);
        [if call < self.kept { 0.05 } else { 1e9 }, 0.0]
    }
}

/// 14 balls, which leave lanes empty, in a raceway.
fn loaded() -> CaseBuilder {
    let bearing = reference::bearing();
    let raceway = reference::Structure::D.raceway(&bearing).unwrap();
    CaseBuilder::of(bearing)
        .raceway(raceway)
        .inner_speed_rad_s(1257.0)
        .radial_load_n(1500.0)
        .duration_s(5e-4)
}

fn in_space(case: &mut Case) {
    case.motion = Motion::Space;
}

fn every_motion() -> Vec<CaseBuilder> {
    let verlet = || loaded().method(IntegrationMethod::VelocityVerlet);
    vec![
        loaded().method(IntegrationMethod::Abm4),
        verlet(),
        loaded().method(IntegrationMethod::Adaptive),
        verlet().change(in_space),
        verlet().regularisation(Regularisation::Kalker),
        loaded().method(IntegrationMethod::Abm4).change(in_space),
    ]
}

/// The drop of a rotor of one's own, its first impact at 6.4 ms.
fn drop() -> CaseBuilder {
    let reference = reference::rotor_drop();
    let rotor = Rotor::estimated(20.0, 0.02, 3142.0, 2e-4);
    CaseBuilder::of(reference.bearing)
        .rotor(rotor, reference.support)
        .friction_coefficient(0.1)
        .duration_s(0.01)
}

/// A law that rises with the speed is a law wherever the case slides.
#[test]
fn a_law_is_tried_to_the_speeds_of_its_case() {
    let case = loaded().own_friction(Viscous).build().unwrap();
    assert!(complete(&case).end_s > 0.0);
    let builder = loaded().own_friction(UpTo(50.0));
    let error = builder.build().unwrap_err().to_string();
    assert!(
        error.contains("sliding speeds up to 92 m/s") && error.contains("UpTo"),
        "{error}"
    );
    // An impossible speed is refused before the law is tried.
    let fast = loaded().own_friction(UpTo(50.0)).inner_speed_rad_s(1e9);
    assert_eq!(fast.build().unwrap_err().field, "inner_speed_rad_s");
}

/// What a law returns beyond the speeds of the case is not asked for: lanes without a ball report nothing.
#[test]
fn nothing_slides_beyond_the_speeds_that_are_tried() {
    for builder in every_motion() {
        let case = builder.own_friction(UpTo(92.0)).build().unwrap();
        assert!(complete(&case).end_s > 0.0);
    }
    let builder = drop().own_friction(UpTo(230.0));
    complete(&builder.own_journal_friction(UpTo(230.0)).build().unwrap());
}

/// μ above 2 ends a run by the name of the law, as it is refused before one.
#[test]
fn too_much_friction_ends_a_run_as_it_is_refused_before() {
    let mut cases: Vec<Case> = every_motion()
        .into_iter()
        .map(|builder| builder.own_friction(Fickle::after(2000)).build().unwrap())
        .collect();
    let journal = drop().own_journal_friction(Fickle::after(600));
    cases.push(journal.build().unwrap());
    for case in cases {
        let outcome = run(&case, &mut [], &mut |_| Control::Continue(())).unwrap();
        let Ending::Stopped(stop) = outcome.ending else {
            panic!("{:?} {:?}", case.solver.method, outcome.ending);
        };
        assert!(matches!(stop.cause, Cause::Friction { .. }), "{stop}");
        let text = stop.to_string();
        let said = [
            "Fickle returned μ = 1000000000",
            "sliding speed of",
            "μ from 0 to 2",
        ];
        assert!(said.iter().all(|words| text.contains(words)), "{text}");
        assert!(outcome.end_s > 0.0, "{text}");
    }
    let error = loaded().own_friction(Constant(2.5)).build().unwrap_err();
    assert!(error.to_string().contains("μ from 0 to 2"), "{error}");
}

/// A law of one's own between journal and bore moves a drop as the built-in one.
#[test]
fn a_journal_has_a_law_of_ones_own() {
    let end = |builder: CaseBuilder| {
        let outcome = complete(&builder.build().unwrap());
        outcome.state.rotor_speed_rad_s().unwrap()
    };
    let built_in = end(drop());
    let own = end(drop().own_journal_friction(Constant(0.15)));
    let slippery = end(drop().own_journal_friction(Constant(0.05)));
    assert!((own / built_in - 1.0).abs() < 1e-9, "{own} {built_in}");
    assert!(
        built_in < 3142.0 && slippery > built_in,
        "{slippery} {built_in}"
    );
}

/// A rotor without a bore, and a journal without a rotor, are refused by the names of the API.
#[test]
fn what_a_rotor_needs_is_named() {
    let message = |builder: CaseBuilder| builder.build().unwrap_err().to_string();
    let rotor = Rotor::estimated(20.0, 0.02, 3142.0, 2e-4);
    let bare = message(CaseBuilder::of(reference::bearing()).rotor(rotor, None));
    assert!(bare.contains("Bearing::with_inner_ring_bore"), "{bare}");
    let lonely = message(loaded().own_journal_friction(Constant(0.1)));
    assert!(
        lonely.contains("own_journal_friction") && lonely.contains("rotor"),
        "{lonely}"
    );
    let wrong = message(drop().own_journal_friction(Constant(-0.1)));
    assert!(
        wrong.contains("own_journal_friction") && wrong.contains("Constant"),
        "{wrong}"
    );
}
