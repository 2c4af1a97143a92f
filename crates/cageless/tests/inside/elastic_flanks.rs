//! Elastic flanks of a discrete raceway in the plane.

use std::f64::consts::TAU;

use crate::common::{complete, conventional, dimensions, drop_case, raceway, structure, undamped};
use cageless::contact::friction::{Law, Smooth};
use cageless::contact::{AtFlanks, FlankContact, FlankSection, FlankSliding};
use cageless::dynamics::energy::EnergyTerm;
use cageless::dynamics::{Model, RightHandSide};
use cageless::equilibrium::space::outer_section::{Flanks, OuterSection};
use cageless::equilibrium::{self, space};
use cageless::initial_conditions::initial_state;
use cageless::numerics::taylor::Taylor;
use cageless::numerics::vector::SectionVector;
use cageless::passage::PassageRecorder;
use cageless::recorder::Recorder;
use cageless::simulation::{Control, RunOutcome, run, run_batch};
use cageless::{
    Case, FlankModel, Formulation, FrictionModel, Gaps, InputError, IntegrationMethod, Snapshot,
    Start, StartState,
};

fn elastic(mut case: Case) -> Case {
    case.flanks = FlankModel::Elastic;
    case
}

/// Unequal balls in a deep raceway, milled deeper still.
fn uneven(mut case: Case) -> Case {
    let n = case.bearing.balls();
    let deviations = (0..n).map(|k| 4e-7 * (k % 5) as f64 - 8e-7).collect();
    case.bearing = case
        .bearing
        .with_ball_radius_deviations(deviations)
        .unwrap();
    let raceways = case.raceways.iter();
    let deep = |r: &cageless::Raceway| {
        let deeper = r.clone().with_depth_error(2e-6)?;
        deeper.with_depth(3e-6)
    };
    case.raceways = raceways.map(deep).collect::<Result<_, _>>().unwrap();
    case
}

/// Verlet with a step.
fn stepped(mut case: Case, step_us: f64, duration_s: f64) -> RunOutcome {
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = step_us * 1e-6;
    case.solver.duration_s = duration_s;
    complete(&case)
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * a.abs().max(b.abs()), "{a} {b}");
}

/// δe, its derivatives and the angles are those of the section in space with the ball in its middle,
/// for balls of any radius in raceways of any depth.
#[test]
fn a_ball_in_the_middle_of_a_section_in_space_is_that_of_the_plane() {
    let nominal: f64 = 0.19e-3;
    for (angle, radius_error, depth_error) in
        [(0.56, 0.0, 0.0), (0.3, 2e-6, 0.0), (0.1, -1e-6, 3e-6)]
    {
        let (gap, cosine) = (nominal - radius_error, f64::cos(angle));
        let own = gap + depth_error;
        let height = (own * own - (nominal * angle.sin()).powi(2)).sqrt();
        let flanks = FlankSection {
            gap: own,
            height,
            cosine,
        };
        let section = OuterSection {
            gap_m: gap,
            axial_m: 0.0,
            flanks: Some(Flanks {
                angle_rad: angle,
                section_angle_rad: 0.0,
                nominal_gap_m: nominal,
                depth_error_m: depth_error,
                depth_m: 0.0,
                slot: None,
            }),
        };
        // From the place of a ball that touches the plain groove to that of one on the flanks.
        let touching = height - nominal * cosine + nominal - gap;
        for beyond in [1e-7, 3e-6, 12e-6] {
            let press = flanks.press(beyond);
            let [radial] = Taylor::<1>::variables([touching + beyond]);
            let place = SectionVector {
                radial,
                axial: Taylor::constant(0.0),
            };
            let known = section.approach(place, Taylor::constant(angle)).unwrap();
            close(press.deflection, known.value, 1e-9);
            close(press.lever, known.gradient[0], 1e-9);
            close(press.curvature, known.hessian[0][0], 1e-6);
            let [one, _] = section.contacts(place.map(|part| part.value))[..] else {
                panic!("two flanks");
            };
            close(press.cosine, one.angle_rad.cos(), 1e-12);
            close(press.sine_square, one.angle_rad.sin().powi(2), 1e-12);
            // Each flank carries F/(2 cos αc).
            close(0.5 * press.inverse_flank_cosine, one.share, 1e-9);
        }
        assert_eq!(flanks.press(-1e-6).deflection, 0.0);
    }
}

/// Flanks that are not there are a plain raceway, to the bit in a run.
#[test]
fn without_an_angle_there_is_the_plain_raceway() {
    let plain = FlankSection {
        gap: 0.19e-3,
        height: 0.19e-3,
        cosine: 1.0,
    };
    let press = plain.press(5e-6);
    close(press.deflection, 5e-6, 1e-14);
    close(press.lever, 1.0, 1e-15);
    assert_eq!(press.sine_square, 0.0);
    let rigid = conventional(dimensions());
    let run = |case: Case| stepped(case, 2.0, 0.002).state;
    assert_eq!(run(rigid.clone()), run(elastic(rigid)));
}

/// Friction keeps its direction, whatever that is, and the moment of spin has the limits of Hertz'
/// pressure: 3/8 μNa of fast spin, μNa²/(5 vs) of creep.
#[test]
fn friction_at_flanks_has_its_limits() {
    let (mu, normal, axis, sine_square): (f64, f64, f64, f64) = (0.1, 400.0, 0.6e-3, 0.25);
    let law = Smooth {
        coefficient: mu,
        inverse_regularisation_speed: 50.0,
    };
    let flanks = FlankContact {
        load: 2.0,
        deflection: 5e-6,
        lever: 1.0,
        sine_square,
        axis_square: axis * axis,
    };
    let at = |radial: f64, rotation: f64| AtFlanks {
        law,
        sliding: FlankSliding::new(&law, &flanks, radial, rotation),
    };
    let moment = |rotation: f64| at(0.0, rotation).drag(&flanks, 0.0, normal)[1] * rotation;
    let sine = sine_square.sqrt();
    close(moment(1e7), 0.375 * mu * normal * axis * sine, 1e-3);
    let creep = mu * normal * axis.powi(2) * sine_square * 50.0 / 5.0;
    close(moment(1e-2), creep * 1e-2, 1e-6);
    // The force is −μN tanh(s/vs) s/s without spin: its parts are as those of s.
    for (slip, radial) in [(0.3, 0.2), (1e-3, -0.01), (0.0, 0.05), (1e-9, 1e-9)] {
        let along = sine * radial;
        let law = at(radial, 0.0);
        let [across, slope] = law.force(slip, normal);
        let [drag, _] = law.drag(&flanks, slip, normal);
        close(across * along, drag * radial / sine * slip, 1e-12);
        let whole = across.hypot(drag * radial / sine);
        let speed = f64::hypot(slip, along);
        assert!((whole - mu * normal * (speed * 50.0).tanh()).abs() < 1e-9 * mu * normal);
        let h = 1e-7;
        let [more, less] = [slip + h, slip - h].map(|s| law.force(s, normal)[0]);
        close((more - less) / (2.0 * h), slope, 1e-4);
    }
    // Fast spin leaves little friction for slow sliding.
    let [spinning, _] = at(0.0, 3000.0).force(0.02, normal);
    let widened = (0.02_f64.powi(2) + (2.0 / 3.0 * axis * sine * 3000.0).powi(2)).sqrt();
    close(spinning, mu * normal * (0.02 / widened).tanh(), 1e-9);
}

fn rough(mut case: Case) -> Case {
    let n = case.bearing.balls();
    let room = n as f64 * case.bearing.mean_gap_rad();
    let mut gaps = vec![(room - 0.02) / (n - 1) as f64; n];
    gaps[2] = 0.02;
    case.start = Start::new(
        StartState::Rolling {
            ring_x_m: 1e-6,
            ring_y_m: -15e-6,
        },
        Gaps::List(gaps),
        0.3,
    );
    case
}

/// The ledger closes to second order in the step of the leapfrog method, with friction explicit or
/// implicit, equal balls or not.
#[test]
fn the_ledger_closes_to_second_order() {
    let undamped = undamped(elastic(structure(5.1, 25.2)));
    let mut dry = rough(undamped.clone());
    dry.contact.friction.coefficient = 0.1;
    let damped = rough(uneven(elastic(structure(5.6, 15.774))));
    for case in [undamped, dry, damped] {
        let residuals = [1.0, 0.5, 0.25].map(|step_us| {
            let outcome = stepped(case.clone(), step_us, 0.004);
            outcome.energy_residual_relative.abs()
        });
        assert!(residuals[0] < 1e-2, "{residuals:?}");
        assert!(
            (1..3).all(|k| residuals[k - 1] > 3.0 * residuals[k]),
            "{residuals:?}"
        );
    }
}

/// Forces are the slopes of the stored energy, and the powers of the losses are what they lose: with
/// a method of high order the ledger closes to rounding of the run.
#[test]
fn the_ledger_closes_in_explicit_methods() {
    let stribeck = {
        let mut case = elastic(structure(5.1, 25.2));
        case.contact.friction_law = FrictionModel::Stribeck;
        case.contact.friction.static_coefficient = Some(0.02);
        case.contact.friction.stribeck_speed_m_s = Some(0.3);
        case
    };
    for case in [
        elastic(structure(5.1, 25.2)),
        uneven(elastic(structure(6.0, 12.717))),
        stribeck,
    ] {
        let mut case = rough(case);
        case.solver.method = IntegrationMethod::Abm4;
        case.solver.step_s = 0.1e-6;
        case.solver.duration_s = 0.002;
        let outcome = complete(&case);
        let residual = outcome.energy_residual_relative.abs();
        assert!(residual < 1e-7, "{residual:e}");
        assert!(outcome.state.energy_term_j(EnergyTerm::OuterFriction) > 0.0);
    }
}

/// Implicit friction in the leapfrog method and explicit friction in a method of high order lead to
/// the same state, to second order.
#[test]
fn implicit_friction_converges_to_explicit() {
    let mut case = elastic(structure(5.1, 25.2));
    case.contact.friction.coefficient = 0.05;
    case.solver.method = IntegrationMethod::Abm4;
    case.solver.step_s = 0.05e-6;
    case.solver.duration_s = 0.001;
    let truth = complete(&case).state;
    let miss = |step_us: f64| {
        let state = stepped(case.clone(), step_us, 0.001).state;
        let spins = (0..14).map(|k| state.ball_motion(k).spin - truth.ball_motion(k).spin);
        spins.map(f64::abs).fold(0.0, f64::max)
    };
    let misses = [2.0, 1.0, 0.5].map(miss);
    assert!(misses[0] < 1e-3, "{misses:?}");
    assert!(
        (1..3).all(|k| misses[k - 1] > 3.0 * misses[k]),
        "{misses:?}"
    );
}

/// Mean lag of a ball per pass, rad: mean orbital speed outside the raceway times the duration of
/// a pass, less the angle of the raceway.
fn lag_rad(case: &Case) -> f64 {
    let settled_s = 0.06;
    let theta = case.raceways[0].half_angle_rad();
    let (mut passes, mut speeds) = (vec![], vec![]);
    let mut passages = PassageRecorder::new(|p| {
        if p.enter_s > settled_s {
            passes.push(p.leave_s - p.enter_s);
        }
        Ok(())
    });
    let mut recorder = Recorder::new(2e-5, |s: Snapshot| {
        if s.time_s > settled_s {
            let outside = s.angle_rad.iter().map(|a| {
                let turn = a.rem_euclid(TAU);
                turn.min(TAU - turn) > theta
            });
            let of_outside = outside.zip(&s.orbit_speed_rad_s).filter(|(out, _)| *out);
            speeds.extend(of_outside.map(|(_, v)| *v));
        }
        Ok(())
    });
    let mut case = case.clone();
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 2e-6;
    case.solver.duration_s = 0.12;
    let observers: &mut [&mut dyn cageless::simulation::Observer] =
        &mut [&mut passages, &mut recorder];
    run(&case, observers, &mut |_| Control::Continue(())).unwrap();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    mean(&speeds) * mean(&passes) - 2.0 * theta
}

/// Lag per pass in structure (d) of Zhao 2022, Table 2, in degrees as an independent program in
/// three dimensions has it with its balls in the middle plane: 2.290 on rigid flanks, 1.935 on elastic
/// ones that spin.
#[test]
fn elastic_flanks_lag_as_in_space() {
    let case = structure(5.1, 25.2);
    for (case, known) in [(case.clone(), 2.290), (elastic(case), 1.935)] {
        let lag = lag_rad(&case).to_degrees();
        assert!((lag - known).abs() < 0.01, "{lag}, not {known}");
    }
}

/// The plane's static equilibrium on elastic flanks is that in space, whose flanks are.
#[test]
fn static_equilibrium_is_that_in_space() {
    for (case, lead) in [
        (structure(5.1, 25.2), 0.0),
        (structure(6.0, 12.717), 0.13),
        (uneven(structure(5.1, 25.2)), 0.05),
    ] {
        let mut case = elastic(case);
        case.start = Start::new(StartState::Settled, Gaps::Uniform, lead);
        let plane = equilibrium::solve(&case).unwrap();
        let space = space::solve(&case).unwrap();
        close(plane.ring_y_m, space.rest.ring_y_m, 1e-9);
        assert!((plane.ring_x_m - space.rest.ring_x_m).abs() < 1e-14);
        for k in 0..14 {
            close(
                plane.ball_distance_m[k],
                space.rest.ball_distance_m[k],
                1e-12,
            );
            close(
                plane.effective_radius_m[k],
                space.rest.effective_radius_m[k],
                1e-9,
            );
            for (a, b) in [
                (plane.inner_force_n[k], space.rest.inner_force_n[k]),
                (plane.outer_force_n[k], space.rest.outer_force_n[k]),
            ] {
                assert!((a - b).abs() < 1e-9 * 1500.0, "{k}: {a} {b}");
            }
        }
        let [a, b] = [plane.stiffness_n_m, space.rest.stiffness_n_m].map(Option::unwrap);
        close(a[1][1], b[1][1], 1e-7);
        close(a[0][0], b[0][0], 1e-7);
    }
}

/// A settled start is settled: forces are those of the static equilibrium, nothing slides, and the
/// ring stays.
#[test]
fn a_settled_start_is_settled() {
    for case in [structure(5.1, 25.2), uneven(structure(5.1, 25.2))] {
        // A ball passes the ring, which is off the centre, with damping.
        let case = undamped(elastic(case));
        let (state, angles) = initial_state(&case).unwrap();
        let model = Model::new(&case).unwrap();
        let mut rhs = RightHandSide::new(&model);
        let start = rhs.snapshot(0.0, &state, &angles);
        let rest = equilibrium::solve(&case).unwrap();
        for k in 0..14 {
            assert!((start.outer_force_n[k] - rest.outer_force_n[k]).abs() < 1e-6);
            assert!((start.inner_force_n[k] - rest.inner_force_n[k]).abs() < 1e-6);
            close(
                start.effective_radius_m[k],
                rest.effective_radius_m[k],
                1e-12,
            );
            let slips = [start.outer_sliding_m_s[k], start.inner_sliding_m_s[k]];
            assert!(slips.iter().all(|s| s.abs() < 1e-5), "{slips:?}");
        }
        let left = start.ring.ax_m_s2.hypot(start.ring.ay_m_s2);
        assert!(left < 1e-2, "{left:e}");
    }
}

/// A rotor falls onto a bearing with elastic flanks.
#[test]
fn a_drop_closes_its_ledger() {
    let case = drop_case();
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    let mut case = elastic(case.with_raceways(vec![raceway]));
    let rotor = case.rotor.as_mut().unwrap();
    rotor.y_m = -0.995 * rotor.radial_clearance_m;
    rotor.vy_m_s = -0.06;
    let residuals = [0.5, 0.25].map(|step_us| {
        let outcome = stepped(case.clone(), step_us, 0.01);
        assert!(outcome.state.ring_speed_rad_s().unwrap() > 10.0);
        outcome.energy_residual_relative.abs()
    });
    assert!(
        residuals[0] < 1e-6 && residuals[1] < 0.4 * residuals[0],
        "{residuals:?}"
    );
    // Side by side drops have the bits of each alone.
    case.solver.duration_s = 1e-3;
    case.solver.step_s = 1e-6;
    case.solver.method = IntegrationMethod::VelocityVerlet;
    let mut slower = case.clone();
    slower.rotor.as_mut().unwrap().speed_rad_s *= 0.9;
    let together = run_batch(&[&case, &slower], &mut [vec![], vec![]], &mut |_| {
        Control::Continue(())
    });
    for (case, together) in [case, slower].iter().zip(together) {
        assert_eq!(complete(case).state, together.unwrap().state);
    }
}

/// What has no elastic flanks says so.
#[test]
fn what_has_no_elastic_flanks_is_refused() {
    let refused = |change: fn(&mut Case)| -> InputError {
        let mut case = elastic(structure(5.1, 25.2));
        change(&mut case);
        case.check().unwrap_err()
    };
    let paper = refused(|case| case.formulation = Formulation::Paper);
    assert_eq!(paper.field, "flanks");
    assert!(paper.to_string().contains("published equations"), "{paper}");
    let coulomb = refused(|case| case.contact.friction_law = FrictionModel::Coulomb);
    assert!(
        coulomb.to_string().contains("regularisation speed"),
        "{coulomb}"
    );
}
