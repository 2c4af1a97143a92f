//! A ring that falls between the balls: where it meets the outer ring the run ends.

use crate::common::{dimensions, drop_case, steel, structure};
use cageless::linear_rotor::RigidRotor;
use cageless::simulation::{Cause, Control, Ending, Observer, RotorDrop, Stop, run};
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
    let bore = case.bearing.inner_ring_bore();
    case.bearing = match bore {
        Some(bore) => bearing.with_inner_ring_bore(bore).unwrap(),
        None => bearing,
    };
    let gaps = Gaps::List(gaps);
    case.start = match case.start {
        Start::AtRest { .. } => Start::AtRest {
            gaps,
            lead_ball_angle_rad,
        },
        _ => Start::Rolling {
            gaps,
            lead_ball_angle_rad,
            ring_x_m: 0.0,
            ring_y_m: 0.0,
        },
    };
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = 0.05;
    case
}

/// Six balls in one row span 119°: the ring falls between the ends of the row, in a run, under a
/// rotor, and in one of its two bearings. Ros − Ri − 0.2 Dw = 5.855 mm.
#[test]
fn a_ring_that_falls_between_the_balls_ends_the_run() {
    let loaded = bunched(structure(5.1, 25.2), 6, 1.0);
    let mut falling = bunched(drop_case(), 6, 1.57);
    let rotor = falling.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s, rotor.speed_rad_s) = (-1.9e-4, -0.3, 100.0);
    let speed = rotor.speed_rad_s;
    falling.set_method(IntegrationMethod::VelocityVerlet);
    for case in [&loaded, &falling] {
        let outcome = run(case, &mut [], &mut |_| Control::Continue(())).unwrap();
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
    let rotor = RigidRotor {
        mass_kg: 40.0,
        polar_inertia_kg_m2: 0.04,
        transverse_inertia_kg_m2: 0.6,
        bearing_axial_m: vec![-0.2, 0.2],
        unbalances: vec![],
        clearances: vec![],
    };
    let mut held = drop_case();
    held.solver = falling.solver.clone();
    let drop = RotorDrop::new(
        rotor.linear().unwrap(),
        speed,
        0.0,
        vec![held, falling],
        None,
    );
    let mut observers: Vec<Vec<&mut dyn Observer>> = vec![vec![], vec![]];
    let outcome = drop
        .unwrap()
        .run(&mut observers, &mut |_| Control::Continue(()))
        .unwrap();
    let [first, second] = [0, 1].map(|k: usize| &outcome.bearings[k].ending);
    assert!(matches!(first, Ending::Interrupted), "{first:?}");
    assert!(
        matches!(
            second,
            Ending::Stopped(Stop {
                cause: Cause::RingsMeet { .. },
                ..
            })
        ),
        "{second:?}"
    );
}
