//! A ring that falls between the balls: where it meets the outer ring the run ends.

use crate::common::{dimensions, steel, structure};
use cageless::simulation::{Cause, Control, Ending, run};
use cageless::{Bearing, BearingDimensions, Case, Gaps, IntegrationMethod, Start};

/// The paper's bearing with `balls` of its fourteen balls in one row.
fn bunched(mut case: Case, balls: usize, lead_ball_angle_rad: f64) -> Case {
    let bearing = Bearing::new(
        BearingDimensions {
            balls,
            ..dimensions()
        },
        steel(),
    )
    .unwrap();
    let mut gaps = vec![0.0; balls];
    gaps[balls - 1] = balls as f64 * bearing.mean_gap_rad();
    case.bearing = bearing;
    case.start = Start::Rolling {
        gaps: Gaps::List(gaps),
        lead_ball_angle_rad,
        ring_x_m: 0.0,
        ring_y_m: 0.0,
    };
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = 0.05;
    case
}

/// Six balls in one row span 119°: the loaded ring falls between the ends of the row.
/// Ros − Ri − 0.2 Dw = 5.855 mm.
#[test]
fn a_ring_that_falls_between_the_balls_ends_the_run() {
    let loaded = bunched(structure(5.1, 25.2), 6, 1.0);
    let outcome = run(&loaded, &mut [], &mut |_| Control::Continue(())).unwrap();
    let Ending::Stopped(stop) = &outcome.ending else {
        panic!("{:?}", outcome.ending);
    };
    let &Cause::RingsMeet {
        displacement_m,
        balls_that_hold,
    } = &stop.cause
    else {
        panic!("{stop}");
    };
    assert!((5.855e-3..6.0e-3).contains(&displacement_m), "{stop}");
    assert_eq!(balls_that_hold, Some(9));
    let text = stop.to_string();
    assert!(
        text.contains("fell between the balls and met the outer ring, 5."),
        "{text}"
    );
    assert!(
        text.contains("start.gaps") && text.contains("9 or more (bearing.balls)"),
        "{text}"
    );
}
