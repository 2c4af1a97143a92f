//! Every cause for which a run stops, by a state that is edited, from both sides of its limit.

use crate::common::{conventional, dimensions, drop_case, run_from};
use cageless::ball::BallMotion;
use cageless::dynamics::Model;
use cageless::dynamics::coordinates::{
    BallCoordinate, BodyCoordinate, OuterRingCoordinate, RingCoordinate, RotorCoordinate,
};
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::state::State;
use cageless::initial_conditions::initial_state;
use cageless::simulation::{Cause, Control, Ending};
use cageless::{Case, IntegrationMethod, Motion, Row};

/// A time in which nothing moves.
const STEP_S: f64 = 1e-13;

/// What stops a run of some steps from the start of a case after a change.
fn stopped(case: &Case, steps: f64, change: impl FnOnce(&mut State)) -> Option<Cause> {
    let mut case = case.clone();
    case.solver.method = IntegrationMethod::VelocityVerlet;
    (case.solver.step_s, case.solver.duration_s) = (STEP_S, steps * STEP_S);
    let (mut state, angles) = initial_state(&case).unwrap();
    change(&mut state);
    let outcome = run_from(&case, &state, &angles, &mut [], &mut |_| {
        Control::Continue(())
    });
    match outcome.unwrap().ending {
        Ending::Complete => None,
        Ending::Stopped(stop) => Some(stop.cause),
        other => panic!("{other:?}"),
    }
}

/// The cause beyond a limit, and none short of it; at the end of a run and, of one that goes on,
/// within eight steps.
fn at_limit(case: &Case, limit: f64, cause: &Cause, change: impl Fn(&mut State, f64)) {
    for steps in [1.0, 20.0] {
        let at = |share: f64| stopped(case, steps, |state| change(state, share * limit));
        assert_eq!(at(0.999), None, "{cause:?}");
        assert_eq!(at(1.001).as_ref(), Some(cause));
    }
}

/// Moves ball `k` along its radius to a distance from the centre.
fn put(state: &mut State, k: usize, distance_m: f64) {
    let ball = state.ball_motion(k);
    let scale = distance_m / ball.x.hypot(ball.y);
    state.set_ball(
        k,
        BallMotion {
            x: scale * ball.x,
            y: scale * ball.y,
            ..ball
        },
    );
}

/// Twentieths of the radius of a ball, m.
const DEPTH_M: f64 = 0.05 * 4.7625e-3;
const OUTER_ORBIT_M: f64 = 27.765e-3 - 4.7625e-3;
const INNER_ORBIT_M: f64 = 18.24e-3 + 4.7625e-3;

/// Every cause that the state alone brings, once, from both sides of its limit.
#[test]
fn every_cause_has_its_limit() {
    let case = drop_case();
    assert_eq!(stopped(&case, 1.0, |_| ()), None);
    at_limit(
        &case,
        DEPTH_M,
        &Cause::ThroughOuterRing(3),
        |state, depth| {
            put(state, 3, OUTER_ORBIT_M + depth);
        },
    );
    at_limit(
        &case,
        DEPTH_M,
        &Cause::ThroughInnerRing(5),
        |state, depth| {
            put(state, 5, INNER_ORBIT_M - depth);
        },
    );
    at_limit(&case, DEPTH_M, &Cause::ThroughBall(0), |state, depth| {
        let [one, next] = [0, 1].map(|k| state.ball_motion(k));
        let (dx, dy) = (one.x - next.x, one.y - next.y);
        let scale = (2.0 * 4.7625e-3 - depth) / dx.hypot(dy);
        let near = BallMotion {
            x: next.x + scale * dx,
            y: next.y + scale * dy,
            ..one
        };
        // Along the chord the ball comes off the outer raceway, by less than it may.
        state.set_ball(0, near);
    });
    let radial = |state: &mut State, x: RotorCoordinate, y: RotorCoordinate, distance: f64| {
        let layout = state.layout();
        state.values_mut()[layout.body(x)] = 0.6 * distance;
        state.values_mut()[layout.body(y)] = -0.8 * distance;
    };
    let gap = case.rotor.as_ref().unwrap().radial_clearance_m;
    at_limit(
        &case,
        0.05 * 15e-3,
        &Cause::RotorThroughInnerRing,
        |state, depth| {
            radial(state, RotorCoordinate::X, RotorCoordinate::Y, gap + depth);
        },
    );
}

/// A rotor in space goes through a face of the inner ring as well as through its bore.
#[test]
fn a_shoulder_has_its_limit() {
    let mut case = drop_case();
    case.motion = Motion::Space;
    let clearance_m = 1e-4;
    case.rotor.as_mut().unwrap().axial_clearance_m = Some(clearance_m);
    for side in [1.0, -1.0] {
        at_limit(
            &case,
            0.05 * 15e-3,
            &Cause::RotorThroughInnerRing,
            |state, depth| state.set(RotorCoordinate::Z, side * (clearance_m + depth)),
        );
    }
}

/// A ball thrown off the outer raceway by more than its radius is inside the inner ring only where that
/// is, here 5 mm off on the other side of four balls.
#[test]
fn a_thrown_ball_is_not_inside_a_ring_that_is_elsewhere() {
    let case = conventional(cageless::BearingDimensions {
        balls: 4,
        ..dimensions()
    });
    at_limit(
        &case,
        OUTER_ORBIT_M + 5e-3 - INNER_ORBIT_M + DEPTH_M,
        &Cause::ThroughInnerRing(2),
        |state, off| {
            for k in 0..4 {
                let (sin, cos) = (30.0 * k as f64).to_radians().sin_cos();
                let distance = OUTER_ORBIT_M - if k == 2 { off } else { 0.0 };
                let (x, y) = (distance * sin, -distance * cos);
                state.set_ball(
                    k,
                    BallMotion {
                        x,
                        y,
                        ..state.ball_motion(k)
                    },
                );
            }
            let layout = state.layout();
            let (sin, cos) = 60.0_f64.to_radians().sin_cos();
            for (coordinate, value) in [
                (RingCoordinate::X, -5e-3 * sin),
                (RingCoordinate::Y, 5e-3 * cos),
            ] {
                state.values_mut()[layout.ring(coordinate)] = value;
            }
        },
    );
}

/// An outer ring that slid further than the radius of a ball.
#[test]
fn a_sprung_ring_that_slides_off_is_seen() {
    let mut case = conventional(dimensions());
    let row = |axial_position_m, contact_sign, preload_n| Row {
        axial_position_m,
        contact_sign,
        preload_n,
        ..Row::default()
    };
    case.rows = vec![row(0.0, 1.0, 0.0), row(0.02, -1.0, 100.0)];
    let at =
        |share: f64| stopped(&case, 1.0, |state| state.set_sliding(0, share * 4.7625e-3)).unwrap();
    assert_eq!(at(-1.001), Cause::OffSpring(1));
    assert_eq!(at(1.001), Cause::OffSpring(1));
    // Short of it a ball is on no groove any more.
    assert!(!matches!(at(0.999), Cause::OffSpring(_)));
}

/// A housing beyond the radius of a ball.
#[test]
fn a_housing_that_leaves_its_support_is_seen() {
    let mut case = drop_case();
    case.rotor.as_mut().unwrap().radial_clearance_m = 5e-3;
    at_limit(&case, 4.7625e-3, &Cause::OffSupport, |state, off| {
        let layout = state.layout();
        let shift = [0.6 * off, -0.8 * off];
        for (coordinate, by) in [
            (BodyCoordinate::from(OuterRingCoordinate::X), shift[0]),
            (OuterRingCoordinate::Y.into(), shift[1]),
            (RotorCoordinate::X.into(), shift[0]),
            (RotorCoordinate::Y.into(), shift[1]),
        ] {
            state.values_mut()[layout.body(coordinate)] = by;
        }
        for (coordinate, by) in [(RingCoordinate::X, shift[0]), (RingCoordinate::Y, shift[1])] {
            state.values_mut()[layout.ring(coordinate)] = by;
        }
        for k in 0..14 {
            let ball = state.ball_motion(k);
            state.set_ball(
                k,
                BallMotion {
                    x: ball.x + shift[0],
                    y: ball.y + shift[1],
                    ..ball
                },
            );
        }
    });
}

#[test]
fn every_coordinate_must_be_finite() {
    let case = drop_case();
    let (start, _) = initial_state(&case).unwrap();
    let layout = start.layout();
    let balls = BallCoordinate::ALL.into_iter();
    let balls = balls.flat_map(|c| (0..14).map(move |k| layout.ball(c, k)));
    let drop = layout.body(RotorCoordinate::X)..=layout.body(RotorCoordinate::Speed);
    let ring = RingCoordinate::ALL.map(|c| layout.ring(c));
    for place in balls.chain(drop).chain(ring) {
        for bad in [f64::NAN, f64::INFINITY] {
            let cause = stopped(&case, 1.0, |state| state.values_mut()[place] = bad);
            assert_eq!(cause, Some(Cause::NotFinite), "{place}");
        }
    }
}

/// Energy that nothing supplied stops a run from 5 % of the flows or of the energy at the start
/// on; of a drop, of the energy of the fall. Energy that is missing stops none.
#[test]
fn energy_from_nowhere_has_its_limit() {
    let (settled, drop) = (conventional(dimensions()), drop_case());
    let energy = |case: &Case| {
        let (start, _) = initial_state(case).unwrap();
        Model::new(case).unwrap().energy_j(&start)
    };
    for (case, least) in [(&settled, energy(&settled)), (&drop, 20.0 * 9.81 * 2e-4)] {
        // Heat that the ledger holds without anything that supplied it.
        let with = |drive: f64, heat: f64| {
            stopped(case, 600.0, |state| {
                let layout = state.layout();
                state.values_mut()[layout.energy_term(EnergyTerm::Drive)] = drive;
                state.values_mut()[layout.energy_term(EnergyTerm::InnerFriction)] = heat;
            })
        };
        for (share, stops) in [(0.049, false), (0.051, true), (-0.9, false)] {
            let found = with(0.0, share * least);
            assert_eq!(found.is_some(), stops, "{share} of the start");
            // Of 2·drive + excess that flow in all.
            let drive = 1e3 * least;
            let excess = 2.0 * share * drive / (1.0 - share);
            let found = with(drive, drive + excess);
            assert_eq!(found.is_some(), stops, "{share} of the flows");
            if let Some(Cause::EnergyFromNowhere {
                residual_j,
                flows_j,
            }) = found
            {
                assert!((residual_j / excess - 1.0).abs() < 1e-6);
                assert!((flows_j / (2.0 * drive + excess) - 1.0).abs() < 1e-6);
            }
        }
    }
}

/// Shoulders of the inner ring are 0.2 Dw high, or as high as they are given.
#[test]
fn a_ball_over_a_shoulder() {
    over_a_shoulder(&dimensions(), 0.4 * dimensions().ball_radius_m);
    let higher = cageless::BearingDimensions {
        inner_shoulder_radius_m: Some(20.74e-3),
        ..dimensions()
    };
    over_a_shoulder(&higher, 2.5e-3);
}

/// A ball that bears on a groove, 1 µm deep, on either side of its shoulder; the ring has moved away
/// from it.
fn over_a_shoulder(d: &cageless::BearingDimensions, inner_height_m: f64) {
    let mut case = conventional(d.clone());
    case.motion = Motion::Space;
    let rw = d.ball_radius_m;
    let grooves = [
        (inner_height_m, d.inner_groove_curvature_radius_m),
        (
            d.outer_groove_bottom_radius_m - d.outer_shoulder_radius_m,
            d.outer_groove_curvature_radius_m,
        ),
    ];
    for (ring, (height, groove)) in grooves.into_iter().enumerate() {
        let end = (1.0 - height / groove).acos();
        let stopped_at = |angle: f64| {
            stopped(&case, 20.0, |state| {
                let ball = state.ball_motion(5);
                let away_m = -100e-6;
                let length = groove - rw + 1e-6;
                let (radius, z) = match ring {
                    0 => (
                        away_m + d.inner_groove_bottom_radius_m + groove - length * angle.cos(),
                        -length * angle.sin(),
                    ),
                    _ => (
                        d.outer_groove_bottom_radius_m - groove + length * angle.cos(),
                        length * angle.sin(),
                    ),
                };
                let (sin, cos) = ball.y.atan2(ball.x).sin_cos();
                let mut moved = ball;
                (moved.x, moved.y) = (radius * cos, radius * sin);
                state.set_ball(5, moved);
                state.set_ball_in_space(5, z, [0.0; 2]);
                for (coordinate, part) in [(RingCoordinate::X, cos), (RingCoordinate::Y, sin)] {
                    let at = state.layout().ring(coordinate);
                    state.values_mut()[at] = away_m * part;
                }
            })
        };
        for sign in [1.0, -1.0] {
            assert_eq!(stopped_at(sign * 0.999 * end), None, "{ring}");
            let Some(Cause::BeyondGroove {
                ball,
                ring: over,
                angle_rad,
                shoulder_rad,
            }) = stopped_at(sign * 1.001 * end)
            else {
                panic!("{ring}");
            };
            assert_eq!((ball, over), (5, ring));
            assert!((angle_rad / (sign * 1.001 * end) - 1.0).abs() < 1e-6);
            assert!((shoulder_rad / end - 1.0).abs() < 1e-12);
        }
    }
}

/// A bearing fails where its parts part; where the computation fails there is no verdict.
#[test]
fn a_failed_computation_is_no_failed_bearing() {
    let rings_meet = Cause::RingsMeet {
        displacement_m: 1e-3,
        balls_that_hold: None,
    };
    for cause in [rings_meet, Cause::OffSupport, Cause::OffSpring(0)] {
        assert!(cause.gives_way(), "{cause}");
    }
    let gain = Cause::EnergyFromNowhere {
        residual_j: 1.0,
        flows_j: 2.0,
    };
    let unbalanced = Cause::Unbalanced {
        residual_fraction: 0.02,
    };
    for cause in [
        gain,
        unbalanced,
        Cause::NotFinite,
        Cause::NotResolved,
        Cause::ThroughInnerRing(0),
        Cause::ThroughOuterRing(0),
        Cause::ThroughBall(0),
        Cause::RotorThroughInnerRing,
    ] {
        assert!(!cause.gives_way(), "{cause}");
    }
}
