//! Verdicts of drops: how each of them ends, and how those of bearings and of later drops combine.

use cageless::linear_rotor::Clearance;
use cageless::simulation::{
    Ending, PlaneDisplacement, RESIDUAL_FRACTION, RotorOutcome, RunOutcome,
};
use cageless::touchdown::{DropSummary, EndState, Whirl};

use super::drops::{Ended, balanced, drop};
use super::*;

/// How a drop went.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Went {
    Well,
    /// The rotor has not touched.
    InTheAir,
    /// A pressure without a number.
    Unknown,
    Interrupted,
    Overloaded,
    /// Left the physical range after it touched.
    Stopped,
    /// Left the physical range before it touched.
    StoppedInTheAir,
}

/// Every way with its verdict.
const WAYS: [(Went, Option<bool>); 7] = [
    (Went::Well, Some(true)),
    (Went::InTheAir, None),
    (Went::Unknown, None),
    (Went::Interrupted, None),
    (Went::Overloaded, Some(false)),
    (Went::Stopped, Some(false)),
    (Went::StoppedInTheAir, Some(false)),
];

/// A drop that keeps every limit.
fn good() -> (Case, DropSummary, RunOutcome) {
    let Ended {
        case,
        mut s,
        mut outcome,
        ..
    } = drop(&mut 0.2);
    outcome.energy_residual_relative = 0.0;
    (s.end_state, s.rotor_displacement_max_m) = (EndState::AtRest, 100e-6);
    s.backward_whirl = None;
    (s.rotor_weight_n, s.inner_pressure_max_pa) = (Some(200.0), 1e9);
    (s.outer_pressure_max_pa, s.ball_pressure_max_pa) = (2e9, 3e9);
    (case, s, outcome)
}

fn verdict(went: Went) -> DropJudgement {
    let (mut case, mut s, mut outcome) = good();
    let stop = Stop {
        time_s: 0.0123,
        step_s: 1e-6,
        automatic_step_s: 1e-6,
        drop: true,
        cause: Cause::OffSupport,
    };
    match went {
        Went::Well => {}
        Went::InTheAir => s.end_state = EndState::Falling,
        Went::Unknown => s.ball_pressure_max_pa = f64::NAN,
        Went::Interrupted => {
            case.solver.duration_s = 0.03;
            (outcome.ending, outcome.end_s) = (Ending::Interrupted, 0.02);
        }
        Went::Overloaded => s.outer_pressure_max_pa = 4.3e9,
        Went::Stopped => outcome.ending = Ending::Stopped(stop),
        Went::StoppedInTheAir => {
            outcome.ending = Ending::Stopped(stop);
            s.end_state = EndState::Falling;
        }
    }
    DropJudgement::of_drop(&case, &s, &outcome)
}

/// Word and reason of each ending.
#[test]
fn each_ending_of_a_drop_has_its_verdict_and_says_why() {
    for (went, passes) in WAYS {
        let found = verdict(went);
        assert_eq!(found.passes(), passes, "{went:?}");
        let (name, begins) = match went {
            Went::Well => ("pass", "PASS: largest contact pressure 3000 MPa"),
            Went::InTheAir => (
                "not-judged",
                "not judged: the rotor has not touched the inner ring",
            ),
            Went::Unknown => (
                "not-judged",
                "not judged: the contact pressure between balls is not known",
            ),
            Went::Interrupted => (
                "not-judged",
                "not judged: interrupted after 0.02 s of 0.03 s",
            ),
            Went::Overloaded => (
                "fail",
                "FAIL: contact pressure at the outer raceway 4300 MPa",
            ),
            Went::Stopped | Went::StoppedInTheAir => (
                "fail",
                "FAIL: stopped at t = 0.012300 s the outer ring left its support",
            ),
        };
        assert_eq!(found.name(), name, "{went:?}");
        assert!(found.headline().starts_with(begins), "{}", found.headline());
    }
}

/// A backward whirl fails whenever it was and whatever its force does, a forward one where it lasts to the end and its
/// force still grows; the sentence has its times and force.
#[test]
fn a_whirl_says_from_when_to_when_and_how_hard() {
    for (frequency_hz, growth, to_s, expected) in [
        (-234.0, 1.0, 0.3, Some("backward")),
        (-234.0, 1.3, 0.3, Some("backward")),
        (-234.0, 0.2, 0.0714, Some("backward")),
        (234.0, 1.0, 0.3, None),
        (234.0, 1.3, 0.3, Some("forward")),
    ] {
        let (case, mut s, mut outcome) = good();
        (s.first_contact_s, outcome.end_s) = (Some(0.01), 0.3);
        (s.rotor_speed_rad_s, s.spin_up_s) = (3000.0, None);
        let whirl = Whirl {
            from_s: 0.0514,
            to_s,
            frequency_hz,
            frequency_max_hz: 300.0,
            force_max_n: 13_700.0,
            growth,
        };
        s.end_whirl = (to_s == 0.3).then_some(whirl);
        s.backward_whirl = (frequency_hz < 0.0).then_some(whirl);
        let found = DropJudgement::of_drop(&case, &s, &outcome);
        assert_eq!(found.passes(), Some(expected.is_none()));
        let Some(sense) = expected else {
            // A ring that still slides is said to.
            let slides = format!(
                "inner ring not up to speed yet ({:.0} of",
                30.0 / std::f64::consts::PI * s.ring_speed_rad_s
            );
            assert!(found.headline().contains(&slides), "{}", found.headline());
            continue;
        };
        let growing = if sense == "forward" {
            ", and growing"
        } else {
            ""
        };
        let until = if to_s == 0.3 {
            "the end at 300"
        } else {
            "71.4"
        };
        let text = format!(
            "FAIL: {sense} whirl from 51.4 ms to {until} ms (234 Hz), with up to 13700 N on the rotor, 68.5 times its \
             weight{growing}"
        );
        assert_eq!(found.headline(), text);
    }
}

/// Every limit of a drop from both sides, at the limit itself it is kept.
#[test]
fn each_limit_of_a_drop_fails_beyond_it() {
    type Change = fn(&mut DropSummary, f64);
    let limits: [(&str, f64, Change); 4] = [
        ("inner raceway", 4.2e9, |s, x| {
            s.inner_pressure_max_pa = x;
        }),
        ("outer raceway", 4.2e9, |s, x| {
            s.outer_pressure_max_pa = x;
        }),
        ("between balls", 4.2e9, |s, x| {
            s.ball_pressure_max_pa = x;
        }),
        ("the journal displaced", 437e-6, |s, x| {
            s.rotor_displacement_max_m = x;
        }),
    ];
    for (what, limit, change) in limits {
        for (share, passes) in [(0.999, true), (1.0, true), (1.001, false)] {
            let (mut case, mut s, outcome) = good();
            case.rotor.as_mut().unwrap().clearance_limit_m = Some(437e-6);
            change(&mut s, share * limit);
            let found = DropJudgement::of_drop(&case, &s, &outcome);
            assert_eq!(found.passes(), Some(passes), "{what} {share}");
            assert!(
                passes || found.headline().contains(what),
                "{}",
                found.headline()
            );
        }
    }
}

/// Two of a short time after the first contact, a sliding ring and a sinking rotor leave a drop without a verdict.
#[test]
fn a_drop_that_ends_too_early_is_not_judged() {
    for (after_s, slides, sinks, passes) in [
        (0.049, true, false, None),
        (0.049, false, true, None),
        (0.3, true, true, None),
        (0.049, false, false, Some(true)),
        (0.051, true, false, Some(true)),
        (0.3, false, true, Some(true)),
    ] {
        let (case, mut s, mut outcome) = good();
        (s.first_contact_s, outcome.end_s) = (Some(0.01), 0.01 + after_s);
        s.spin_up_s = (!slides).then_some(0.02);
        if sinks {
            s.end_state = EndState::Settling;
        }
        let found = DropJudgement::of_drop(&case, &s, &outcome);
        assert_eq!(found.passes(), passes, "{after_s} {slides} {sinks}");
        let advice = match after_s < 0.05 {
            true => "simulate longer (solver.duration_s), 0.06 s at least",
            false => "simulate longer (solver.duration_s)",
        };
        assert_eq!(
            found.reasons().iter().any(|r| r.ends_with(advice)),
            passes.is_none(),
            "{found:?}"
        );
        // What fails has failed.
        s.outer_pressure_max_pa = 4.3e9;
        let failed = DropJudgement::of_drop(&case, &s, &outcome);
        assert_eq!(failed.passes(), Some(false));
    }
}

/// The verdict with scattered drops is that on them where the nominal drop passes.
#[test]
fn the_verdict_follows_the_scattered_drops() {
    for (went, of_drop) in WAYS {
        for samples in [Some(true), Some(false), None] {
            let expected = match (of_drop, samples) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (Some(true), Some(true)) => Some(true),
                _ => None,
            };
            let found = verdict(went).with_samples(samples, "8 of 12 scattered drops pass");
            assert_eq!(found.passes(), expected, "{went:?} {samples:?}");
        }
    }
    let found = verdict(Went::Well).with_samples(Some(false), "8 of 12 scattered drops pass");
    let begins = "FAIL: 8 of 12 scattered drops pass; nominal drop PASS: largest contact pressure";
    assert!(found.headline().starts_with(begins), "{}", found.headline());
}

/// A bearing that carries nothing of the rotor, or whose rotor stands on another, need not be touched.
#[test]
fn a_free_bearing_need_not_be_touched() {
    let (case, mut s, outcome) = good();
    s.end_state = EndState::Falling;
    let with = |case: &Case, s: &DropSummary| {
        let well = verdict(Went::Well);
        let other = DropJudgement::of_drop(case, s, &outcome);
        DropJudgement::of_bearings(&[&well, &other], &balanced())
    };
    let waits = with(&case, &s);
    assert_eq!(waits.passes(), None);
    assert_eq!(
        waits.reasons(),
        [
            "bearing 2: the rotor has not touched the inner ring: simulate longer (solver.duration_s)"
        ]
    );
    let mut vertical = case.clone();
    vertical.rotor.as_mut().unwrap().shaft = cageless::Shaft::Vertical;
    assert_eq!(with(&vertical, &s).passes(), Some(true));
    s.rotor_weight_n = None;
    assert_eq!(with(&case, &s).passes(), Some(true));
}

/// A bearing that fails decides on a rotor, else one that was not judged or not touched.
#[test]
fn verdicts_of_bearings_combine() {
    let rotor = |energy_residual_relative: f64, displacement_max_m: f64| RotorOutcome {
        energy_residual_relative,
        planes: vec![PlaneDisplacement {
            clearance: Clearance {
                name: "seal".to_owned(),
                radial_m: 3e-4,
            },
            displacement_max_m,
            path_m: vec![],
            farthest_m: [0.0; 2],
        }],
    };
    let still = rotor(0.0, 2.9e-4);
    for (a, of_a) in WAYS {
        assert_eq!(
            DropJudgement::of_bearings(&[&verdict(a)], &balanced()),
            verdict(a)
        );
        for (b, of_b) in WAYS {
            let both = [verdict(a), verdict(b)];
            let both = [&both[0], &both[1]];
            let open = |went| [Went::Unknown, Went::Interrupted, Went::InTheAir].contains(&went);
            let expected = match (of_a, of_b) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                _ if open(a) || open(b) => None,
                _ => Some(true),
            };
            let passes = |rotor: &RotorOutcome| DropJudgement::of_bearings(&both, rotor).passes();
            assert_eq!(passes(&still), expected, "{a:?} {b:?}");
            assert_eq!(passes(&rotor(0.0, 3.1e-4)), Some(false), "{a:?} {b:?}");
            let leaks = 1.001 * RESIDUAL_FRACTION;
            assert_eq!(passes(&rotor(leaks, 0.0)), Some(false), "{a:?} {b:?}");
            let unknown = expected.filter(|passes| !passes);
            assert_eq!(passes(&rotor(f64::NAN, 0.0)), unknown, "{a:?} {b:?}");
        }
    }
    let all = [verdict(Went::Well), verdict(Went::Overloaded)];
    let all = DropJudgement::of_bearings(&[&all[0], &all[1]], &still);
    let reasons = all.reasons();
    assert!(
        reasons.len() == 1 && reasons[0].starts_with("bearing 2: contact pressure at the outer"),
        "{reasons:?}"
    );
}

/// Of drops one after the other all have to pass; the first that does not is named.
#[test]
fn verdicts_of_later_drops_combine() {
    let missing = "drop 4 was left out".to_owned();
    for (a, of_a) in WAYS {
        assert_eq!(verdict(a).with_later(&[], None), verdict(a));
        for (b, of_b) in WAYS {
            let later = [verdict(Went::Well), verdict(b)];
            let of = |missing| verdict(a).with_later(&later, missing);
            let expected = match (of_a, of_b) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (None, _) | (_, None) => None,
                _ => Some(true),
            };
            let all = of(None);
            assert_eq!(all.passes(), expected, "{a:?} {b:?}");
            let unfinished = expected.filter(|passes| !passes);
            assert_eq!(of(Some(&missing)).passes(), unfinished, "{a:?} {b:?}");
            let named = all.reasons().iter().any(|r| r.starts_with("drop 3: "));
            let of_third = of_b == Some(false) || (of_b.is_none() && of_a != Some(false));
            assert_eq!(named, of_third, "{a:?} {b:?}: {:?}", all.reasons());
        }
    }
    let runaway = verdict(Went::Well).failed(["hot".to_owned()]);
    assert_eq!(runaway.headline(), "FAIL: hot");
}
