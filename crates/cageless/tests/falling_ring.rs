//! A ring that falls between the balls: where it meets the outer ring the run ends.

use crate::common::{conventional, dimensions, drop_case, steel, structure};
use cageless::simulation::{Cause, Control, Ending, Stop, run};
use cageless::{Bearing, BearingDimensions, Case, Gaps, IntegrationMethod, Start, StartState};

/// The paper's bearing with `balls` of its fourteen balls in one row, the first at `lead_deg`.
fn bunched(mut case: Case, balls: usize, lead_deg: f64) -> Case {
    let dimensions = BearingDimensions {
        balls,
        ..*case.bearing.dimensions()
    };
    let bearing = Bearing::new(dimensions, steel()).unwrap();
    let mut gaps = vec![0.0; balls];
    gaps[balls - 1] = balls as f64 * bearing.mean_gap_rad();
    let (gaps, lead_ball_angle_rad) = (Gaps::List(gaps), lead_deg.to_radians());
    case.bearing = match case.bearing.inner_ring_bore() {
        Some(bore) => bearing.with_inner_ring_bore(bore).unwrap(),
        None => bearing,
    };
    case.start = match case.rotor {
        Some(_) => Start::new(StartState::AtRest, gaps, lead_ball_angle_rad),
        None => Start::new(
            StartState::Rolling {
                ring_x_m: 0.0,
                ring_y_m: 0.0,
            },
            gaps,
            lead_ball_angle_rad,
        ),
    };
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = 0.05;
    case
}

/// The stop of a run whose ring falls: Ros − Ri − 0.2 Dw = 5.855 mm off the centre.
fn fallen(case: &Case) -> Stop {
    let outcome = run(case, &mut [], &mut |_| Control::Continue(())).unwrap();
    let Ending::Stopped(stop) = &outcome.ending else {
        panic!("{:?}", outcome.ending);
    };
    let Cause::RingsMeet {
        displacement_m,
        balls_that_hold,
    } = stop.cause
    else {
        panic!("{stop}");
    };
    assert!((5.855e-3..6.0e-3).contains(&displacement_m), "{stop}");
    assert_eq!(balls_that_hold, Some(9));
    assert!(outcome.energy_residual_relative.abs() < 1e-3, "{outcome:?}");
    stop.clone()
}

/// Six balls in one row span 119°, seven 143°: the loaded ring falls between the ends of the row,
/// in the raceway or in a conventional ring.
#[test]
fn a_ring_that_falls_between_the_balls_ends_the_run() {
    for case in [
        bunched(structure(5.1, 25.2), 6, 57.3),
        bunched(conventional(dimensions()), 7, 60.0),
    ] {
        let stop = fallen(&case);
        let told = [
            (stop.by_key(), ["start.gaps", "9 or more (bearing.balls)"]),
            (
                stop.to_string(),
                ["CaseBuilder::gaps", "9 or more (BearingDimensions::balls)"],
            ),
        ];
        for (text, names) in told {
            let cause = "fell between the balls and met the outer ring, 5.";
            assert!(text.contains(cause), "{text}");
            assert!(names.iter().all(|name| text.contains(name)), "{text}");
        }
    }
}

/// With the row up to 24° beside the bottom and above it a ball is thrown on the way, by more than its
/// radius off the outer raceway, which is no fault of its own.
#[test]
fn a_ring_that_falls_under_a_rotor_ends_the_drop() {
    for lead_deg in [30.0, 60.0, 120.0] {
        let stop = fallen(&bunched(drop_case(), 5, lead_deg));
        assert!(
            stop.drop && stop.advice().contains("CaseBuilder::gaps"),
            "{stop}"
        );
    }
}
