//! Passages through a discrete raceway.

use cageless::numerics::angle::wrap_angle_rad;
use cageless::numerics::vector::PlaneVector;
use cageless::passage::{Passage, PassageRecorder, PassageTally};
use cageless::simulation::{Control, Observer, ObserverError, StepView, run};
use cageless::{Case, Gaps, IntegrationMethod, Start, StartState};

fn passages(case: &Case) -> Vec<Passage> {
    let mut found = vec![];
    {
        let mut recorder = PassageRecorder::new(|passage| {
            found.push(passage);
            Ok(())
        });
        run(case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    }
    found
}

/// Ends of the raceway are located within the step: with steps of 2 µs they come out as
/// with steps of 0.25 µs, far closer than a step.
#[test]
fn ends_are_located_within_the_step() {
    let mut case = crate::common::structure(5.1, 25.2);
    // Centre away from the bottom, so that both ends and the turn are told apart.
    case = case
        .clone()
        .with_raceways(vec![crate::common::raceway(&case.bearing, 5.1, 25.2, 30.0)]);
    case.start = Start::new(StartState::Settled, Gaps::Uniform, 0.1);
    let mut at = |step_s: f64| {
        case.solver.step_s = step_s;
        passages(&case)
    };
    let (coarse, fine) = (at(2e-6), at(0.25e-6));
    assert!(fine.len() > 10 && coarse.len() == fine.len());
    let orbit = 498.0;
    for (a, b) in coarse.iter().zip(&fine).take(8) {
        assert_eq!((a.ball, a.raceway), (b.ball, b.raceway));
        for (x, y) in [(a.enter_s, b.enter_s), (a.leave_s, b.leave_s)] {
            assert!((x - y).abs() < 0.02e-6, "{x} {y}");
        }
        for (x, y) in [
            (a.gap_enter_rad, b.gap_enter_rad),
            (a.gap_leave_rad, b.gap_leave_rad),
        ] {
            assert!((x - y).abs() < 1e-6, "{x} {y}");
        }
        // Balls are slowed by some percent at most.
        let rolled = orbit * (b.leave_s - b.enter_s) / 50.4f64.to_radians();
        assert!((1.0..1.06).contains(&rolled), "{rolled}");
    }
}

/// Comings in and goings out of every ball, by its angle at the end of every step.
struct EveryStep {
    half_rad: f64,
    centre_rad: f64,
    inside: Vec<Option<bool>>,
    crossings: Vec<(usize, bool, f64)>,
}

impl Observer for EveryStep {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let (PlaneVector { x, y }, centre) = (view.positions(), view.outer_ring_m());
        let balls = view.balls().count();
        self.inside.resize(balls, None);
        for k in 0..balls {
            let angle = (x[k] - centre.x).atan2(centre.y - y[k]) - self.centre_rad;
            let inside = wrap_angle_rad(angle).abs() < self.half_rad;
            if self.inside[k].is_some_and(|before| before != inside) {
                self.crossings.push((k, inside, view.step.t1_s));
            }
            self.inside[k] = Some(inside);
        }
        Ok(Control::Continue(()))
    }
}

/// Balls that start from rest, are hit by a rotor and run into each other are not looked at in every
/// step; none of their passages begins or ends later for it.
#[test]
fn no_passage_is_seen_late() {
    let mut case = crate::common::drop_case();
    let (angle_deg, centre_deg) = (25.2, 10.0);
    case = case.clone().with_raceways(vec![crate::common::raceway(
        &case.bearing,
        5.1,
        angle_deg,
        centre_deg,
    )]);
    case.set_method(IntegrationMethod::VelocityVerlet);
    case.solver.duration_s = 0.25;
    let mut every = EveryStep {
        half_rad: f64::to_radians(angle_deg),
        centre_rad: f64::to_radians(centre_deg),
        inside: vec![],
        crossings: vec![],
    };
    let mut found = vec![];
    let mut recorder = PassageRecorder::new(|passage: Passage| {
        found.push((passage.ball, true, passage.enter_s));
        found.push((passage.ball, false, passage.leave_s));
        Ok(())
    });
    run(&case, &mut [&mut every, &mut recorder], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    assert!(found.len() > 60, "{} ends", found.len());
    // Whoever goes out after coming in has made a passage.
    let crossings = &every.crossings;
    let out = crossings.iter().enumerate().filter(|(_, c)| !c.1);
    let came_in = |(at, out): &(usize, &(usize, bool, f64))| {
        crossings[..*at].iter().any(|c| (c.0, c.1) == (out.0, true))
    };
    assert_eq!(found.len(), 2 * out.filter(came_in).count());
    for (ball, inside, time_s) in found {
        let h = case.solver.step_s;
        let same = |c: &&(usize, bool, f64)| (c.0, c.1) == (ball, inside) && c.2 > time_s - 1e-12;
        let (_, _, step_end_s) = every.crossings.iter().find(same).unwrap();
        assert!(
            *step_end_s < time_s + h,
            "{ball} {inside} {time_s} {step_end_s}"
        );
    }
}

/// Time with and without force at the inner raceway of balls that came in and went out, and of each
/// that is inside; `None` since the start.
#[derive(Default)]
struct TimeInside {
    passed_s: [f64; 2],
    inside_s: Vec<Option<[f64; 2]>>,
}

impl Observer for TimeInside {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let (PlaneVector { x, y }, centre) = (view.positions(), view.outer_ring_m());
        let balls = view.balls().count();
        self.inside_s.resize(balls, None);
        for k in 0..balls {
            let inside = (x[k] - centre.x).atan2(centre.y - y[k]).abs() < 25.2f64.to_radians();
            match &mut self.inside_s[k] {
                Some(time_s) if inside => {
                    let loaded = view.contacts.inner_force_n(k) > 0.0;
                    time_s[usize::from(!loaded)] += view.step.size_s();
                }
                None if inside => {}
                time_s => {
                    let [loaded_s, unloaded_s] = time_s.replace([0.0; 2]).unwrap_or_default();
                    self.passed_s[0] += loaded_s;
                    self.passed_s[1] += unloaded_s;
                }
            }
        }
        Ok(Control::Continue(()))
    }
}

/// Under a light load the inner ring drives every ball in a raceway, and lets go of balls where the
/// raceway is deeper than the ring sinks into them.
#[test]
fn a_deep_raceway_unloads_balls() {
    let unloaded = |depth_m: f64| {
        let mut case = crate::common::structure(5.1, 25.2);
        case.operation.inner_speed_rad_s /= 12.0;
        case.operation.radial_load_n = 100.0;
        case.solver.duration_s = 0.4;
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.step_s = 4e-6;
        let deep = case.raceways[0].clone().with_depth(depth_m);
        let case = case.clone().with_raceways(vec![deep.unwrap()]);
        let (mut tally, mut time) = (PassageTally::new(), TimeInside::default());
        let mut recorder = PassageRecorder::new(|passage| {
            tally.add(&passage);
            Ok(())
        });
        run(&case, &mut [&mut recorder, &mut time], &mut |_| {
            Control::Continue(())
        })
        .unwrap();
        let [loaded_s, unloaded_s] = time.passed_s;
        let fraction = unloaded_s / (loaded_s + unloaded_s);
        let passed = tally.means().unloaded_fraction;
        assert!((fraction - passed).abs() < 1e-3, "{fraction} {passed}");
        passed
    };
    let [flush, deep] = [0.0, 1e-5].map(unloaded);
    assert!(flush < 0.02 && deep > 0.3, "{flush} {deep}");
}
