//! Rows of drops: of one bearing, and of a rotor in two.

use std::path::Path;

use cageless::linear_rotor::Clearance;
use cageless::simulation::{PlaneDisplacement, RotorOutcome, RunOutcome};
use cageless::touchdown::{DropRecorder, DropSummary, EndPower, EndState, Limit, Whirl};

use super::*;
use crate::number_text::short;

const CASE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/touchdown-d.toml");

/// A drop that has ended.
pub(super) struct Ended {
    pub case: Case,
    pub particulars: Particulars,
    pub s: DropSummary,
    pub outcome: RunOutcome,
}

impl Ended {
    fn result(&self) -> DropResult {
        DropResult::new(&self.case, &self.particulars, &self.s, &self.outcome)
    }
}

/// A drop whose numbers all differ, and differ from those of another `counter`.
pub(super) fn drop(counter: &mut f64) -> Ended {
    let sets = [
        "solver.duration_s=0.0001",
        "rotor.clearance_limit_um=437",
        "fit.inner_ring_temperature_c=31",
        "fit.ball_temperature_c=27",
        "fit.outer_ring_temperature_c=29",
    ];
    let file = CaseFile::read(Path::new(CASE), &sets.map(str::to_owned)).unwrap();
    let mut recorder = DropRecorder::new();
    let outcome = run(file.case(), &mut [&mut recorder], &mut |_| {
        Control::Continue(())
    });
    let mut outcome = outcome.unwrap();
    let mut s = recorder.summary(&outcome.state);
    let balls = s.inner_force_max_n.len();
    let mut forces = || -> Vec<f64> { (0..balls).map(|_| next(counter)).collect() };
    (s.inner_force_max_n, s.outer_force_max_n) = (forces(), forces());
    for field in [
        &mut s.first_contact_s,
        &mut s.rotor_weight_n,
        &mut s.housing_force_max_n,
        &mut s.spin_up_s,
        &mut s.end_collision_rate_hz,
        &mut s.shoulder_force_max_n,
        &mut s.rotor_axial_displacement_max_m,
    ]
    .into_iter()
    .chain(&mut s.end_collision_rate_above_hz)
    {
        *field = Some(next(counter));
    }
    for field in [
        &mut s.contact_fraction,
        &mut s.rotor_displacement_max_m,
        &mut s.rotor_force_max_n,
        &mut s.housing_displacement_max_m,
        &mut s.rotor_sliding_max_m_s,
        &mut s.ring_speed_rad_s,
        &mut s.rotor_speed_rad_s,
        &mut s.inner_pressure_max_pa,
        &mut s.outer_pressure_max_pa,
        &mut s.ball_pressure_max_pa,
        &mut s.ball_force_max_n,
        &mut s.ball_sliding_max_m_s,
        &mut s.backward_whirl_max_hz,
        &mut s.end_whirl_hz,
        &mut s.heat.rotor_friction_j,
        &mut s.heat.rotor_damping_j,
        &mut s.heat.inner_friction_j,
        &mut s.heat.outer_friction_j,
        &mut s.heat.ball_friction_j,
        &mut s.heat.contact_damping_j,
        &mut s.heat.support_damping_j,
        &mut outcome.energy_residual_relative,
    ] {
        *field = next(counter);
    }
    s.end_power = Some(EndPower {
        total_w: next(counter),
        parts_w: [next(counter), next(counter), next(counter)],
        torque_n_m: Some(next(counter)),
        torque_change: Some(next(counter)),
    });
    s.end_state = EndState::BackwardWhirl;
    s.backward_whirl = Some(Whirl {
        from_s: next(counter),
        to_s: next(counter),
        frequency_hz: next(counter),
        frequency_max_hz: next(counter),
        force_max_n: next(counter),
        growth: next(counter),
    });
    s.ellipse_edge_max_rad = Some([next(counter), next(counter)]);
    s.impacts = 11;
    (s.collisions.all, s.collisions.above) = (101, [53, 29, 17]);
    Ended {
        case: file.case().clone(),
        particulars: particulars(&file),
        s,
        outcome,
    }
}

#[test]
fn results_of_a_drop_are_the_fields_of_its_summary() {
    let Ended {
        case,
        particulars,
        s,
        outcome,
    } = drop(&mut 0.2);
    let (heat, weight_n) = (s.heat, s.rotor_weight_n.unwrap());
    let of_balls = heat.inner_friction_j + heat.outer_friction_j + heat.ball_friction_j;
    let edges = s.ellipse_edge_max_rad.unwrap();
    let rate = |k: usize| s.end_collision_rate_above_hz[k].unwrap();
    let (end, capacities) = (
        s.end_power.unwrap(),
        particulars
            .thermal
            .capacities_j_k(&case.bearing, case.rows.len())
            .unwrap(),
    );
    let inner_j = (heat.rotor_friction_j + heat.rotor_damping_j + heat.inner_friction_j) / 2.0
        + heat.contact_damping_j / 4.0;
    let outer_j = heat.outer_friction_j / 2.0 + heat.contact_damping_j / 4.0;
    let balls_j = of_balls - (heat.inner_friction_j + heat.outer_friction_j) / 2.0
        + heat.contact_damping_j / 2.0;
    let expected = [
        ("first_contact_ms", s.first_contact_s.unwrap() / 1e-3),
        ("contact_fraction", s.contact_fraction),
        ("rotor_force_max_n", s.rotor_force_max_n),
        (
            "rotor_force_max_over_weight",
            s.rotor_force_max_n / weight_n,
        ),
        ("shoulder_force_max_n", s.shoulder_force_max_n.unwrap()),
        (
            "rotor_axial_displacement_max_um",
            s.rotor_axial_displacement_max_m.unwrap() / 1e-6,
        ),
        ("housing_force_max_n", s.housing_force_max_n.unwrap()),
        (
            "housing_force_max_over_weight",
            s.housing_force_max_n.unwrap() / weight_n,
        ),
        (
            "rotor_displacement_max_um",
            s.rotor_displacement_max_m / 1e-6,
        ),
        (
            "clearance_margin_um",
            437.0 - s.rotor_displacement_max_m / 1e-6,
        ),
        (
            "housing_displacement_max_um",
            s.housing_displacement_max_m / 1e-6,
        ),
        ("rotor_sliding_max_m_s", s.rotor_sliding_max_m_s),
        ("spin_up_ms", s.spin_up_s.unwrap() / 1e-3),
        ("ring_speed_rpm", s.ring_speed_rad_s / REVOLUTION_PER_MINUTE),
        (
            "rotor_speed_rpm",
            s.rotor_speed_rad_s / REVOLUTION_PER_MINUTE,
        ),
        ("backward_whirl_max_hz", s.backward_whirl_max_hz),
        (
            "backward_whirl_hz",
            s.backward_whirl.unwrap().frequency_max_hz,
        ),
        ("backward_whirl_end_hz", s.end_whirl_hz),
        ("inner_pressure_max_mpa", s.inner_pressure_max_pa / MPA),
        ("outer_pressure_max_mpa", s.outer_pressure_max_pa / MPA),
        ("inner_ellipse_edge_max_deg", edges[0] / DEGREE),
        ("outer_ellipse_edge_max_deg", edges[1] / DEGREE),
        ("ball_pressure_max_mpa", s.ball_pressure_max_pa / MPA),
        ("end_collision_rate_hz", s.end_collision_rate_hz.unwrap()),
        ("end_collision_rate_above_0_1_m_s_hz", rate(0)),
        ("end_collision_rate_above_0_5_m_s_hz", rate(1)),
        ("end_collision_rate_above_1_m_s_hz", rate(2)),
        ("ball_force_max_n", s.ball_force_max_n),
        ("ball_sliding_max_m_s", s.ball_sliding_max_m_s),
        (
            "dissipated_j",
            of_balls
                + heat.rotor_friction_j
                + heat.rotor_damping_j
                + heat.contact_damping_j
                + heat.support_damping_j,
        ),
        ("ball_friction_total_j", of_balls),
        ("rotor_friction_j", heat.rotor_friction_j),
        ("rotor_damping_j", heat.rotor_damping_j),
        ("inner_friction_j", heat.inner_friction_j),
        ("outer_friction_j", heat.outer_friction_j),
        ("ball_friction_j", heat.ball_friction_j),
        ("contact_damping_j", heat.contact_damping_j),
        ("support_damping_j", heat.support_damping_j),
        ("braking_torque_n_m", end.torque_n_m.unwrap()),
        ("braking_torque_change_fraction", end.torque_change.unwrap()),
        ("end_power_w", end.total_w),
        ("inner_ring_power_w", end.parts_w[0]),
        ("ball_power_w", end.parts_w[1]),
        ("outer_ring_power_w", end.parts_w[2]),
        ("inner_ring_temperature_c", 31.0 + inner_j / capacities[0]),
        ("ball_temperature_c", 27.0 + balls_j / capacities[1]),
        ("outer_ring_temperature_c", 29.0 + outer_j / capacities[2]),
        ("energy_residual_relative", outcome.energy_residual_relative),
        ("simulated_s", 1e-4),
    ];
    let finished = FinishedDrop {
        case: &case,
        particulars: &particulars,
        summary: &s,
        outcome: &outcome,
        judgement: DropJudgement::of_drop(&case, &s, &outcome),
    };
    let reasons = finished.judgement.reasons().join("; ");
    let frequency = short(s.backward_whirl.unwrap().frequency_hz);
    assert!(
        reasons.contains("backward whirl from ") && reasons.contains(&format!("({frequency} Hz)")),
        "{reasons}"
    );
    let results = Results::of(DROP, Subject::Drop(&finished));
    compare(&results, &expected, &[], 1e-12);
    for (name, count) in [
        ("impacts", 11),
        ("collisions", 101),
        ("collisions_above_0_1_m_s", 53),
        ("collisions_above_0_5_m_s", 29),
        ("collisions_above_1_m_s", 17),
    ] {
        assert_eq!(results.get(name), Some(&Cell::Integer(count)), "{name}");
    }
    for (name, forces) in [
        ("inner_force_max_of_ball_n", &s.inner_force_max_n),
        ("outer_force_max_of_ball_n", &s.outer_force_max_n),
    ] {
        assert_eq!(results.get(name), Some(&Cell::Numbers(forces.clone())));
    }
}

/// The rotor is braked by SKF's ½ μ P d at least; a slow one, which nothing brakes, has no torque.
#[test]
fn the_braking_torque_is_that_of_the_spin_down() {
    let mut ended = drop(&mut 0.2);
    ended.s.rotor_weight_n = Some(200.0);
    let bore_m = 2.0 * ended.case.bearing.inner_ring_bore().unwrap().radius_m;
    let rolling_n_m = 0.5 * 0.0015 * 200.0 * bore_m;
    let torque = |ended: &Ended| ended.result().results.value("braking_torque_n_m");
    for (own, expected) in [
        (Some(1e-3 * rolling_n_m), Some(rolling_n_m)),
        (Some(2.0 * rolling_n_m), Some(2.0 * rolling_n_m)),
        (None, None),
    ] {
        if let Some(end) = &mut ended.s.end_power {
            end.torque_n_m = own;
        }
        let found = torque(&ended);
        assert_eq!(found.is_some(), expected.is_some());
        let [found, expected] = [found, expected].map(Option::unwrap_or_default);
        assert!((found - expected).abs() <= 1e-12, "{found} {expected}");
    }
}

/// Groups of drops side by side: heading and rows of each.
type Groups = Vec<(&'static str, Vec<crate::ShownBeside>)>;

fn row_of(groups: &Groups, label: &str) -> Option<(&'static str, Vec<String>, String)> {
    let mut rows = groups.iter().flat_map(|(_, rows)| rows);
    rows.find(|row| row.0.trim() == label).cloned()
}

#[test]
fn results_of_drops_stand_in_groups_without_what_none_of_them_has() {
    let mut ended = drop(&mut 0.2);
    ended.s.heat.outer_friction_j = 1e4;
    let full = ended.result();
    let s = &mut ended.s;
    (s.backward_whirl, s.collisions.above[2]) = (None, 0);
    let less = ended.result();
    let groups = DropResult::groups(&[&less]);
    let headings: Vec<&str> = groups.iter().map(|(heading, _)| *heading).collect();
    let expected = [
        "Motion of the rotor",
        "Forces",
        "Pressure",
        "Contacts between balls",
        "Losses and heat",
        "Temperatures",
        "Computation",
    ];
    assert_eq!(headings, expected);
    let [whirl, hard] = [
        "backward whirl round the bore, largest",
        "collisions above 1 m/s",
    ];
    for label in [whirl, hard] {
        assert_eq!(row_of(&groups, label), None, "{label}");
    }
    // A part that no heat warms has no temperature to show.
    let outer = "temperature of the outer ring at the end";
    assert!(row_of(&groups, outer).is_some());
    let heat = &mut ended.s.heat;
    (heat.outer_friction_j, heat.contact_damping_j) = (0.0, 0.0);
    let cold = ended.result();
    assert_eq!(row_of(&DropResult::groups(&[&cold]), outer), None);
    assert_eq!(cold.results.number("outer_ring_temperature_c"), 29.0);
    // Files have it all the same, and tables that of another drop beside it.
    assert_eq!(less.results.number("collisions_above_1_m_s"), 0.0);
    let groups = DropResult::groups(&[&less, &full]);
    assert_eq!(row_of(&groups, hard).unwrap().1, ["0", "17"]);
    assert_eq!(row_of(&groups, whirl).unwrap().1[0], "–");
    assert_eq!(
        row_of(&groups, "verdict on the bearing").unwrap().1,
        ["FAIL", "FAIL"]
    );
    let torque = row_of(
        &groups,
        "torque of the bearing that brakes the rotor, at the end",
    );
    assert_eq!(torque.unwrap().2, "N·mm");
}

/// Counts, rates and heat of the bearings add up, first contact and clearance are those of the worse,
/// of all else the larger number is that of the rotor.
#[test]
fn results_of_a_rotor_are_those_of_its_bearings() {
    let mut counter = 0.2;
    let bearings = [-1.0, 1.0].map(|sign| {
        let mut ended = drop(&mut counter);
        // Neither bearing has all the larger numbers.
        ended.s.rotor_force_max_n += sign;
        ended.s.inner_pressure_max_pa -= sign;
        ended.outcome.energy_residual_relative -= sign;
        ended.result()
    });
    let [a, b] = [0, 1].map(|k: usize| bearings[k].results.clone());
    let plane = |radial_m: f64, displacement_max_m: f64| PlaneDisplacement {
        clearance: Clearance {
            name: "seal".to_owned(),
            radial_m,
        },
        displacement_max_m,
        path_m: vec![],
        farthest_m: [0.0; 2],
    };
    let run = DropRun {
        bearings: bearings.to_vec(),
        rotor: RotorOutcome {
            energy_residual_relative: 0.0123,
            planes: vec![plane(5e-4, 1e-4), plane(4e-4, 2.5e-4)],
        },
        stopped: None,
    };
    let sums = [
        "impacts",
        "collisions",
        "collisions_above_0_1_m_s",
        "collisions_above_0_5_m_s",
        "collisions_above_1_m_s",
        "end_collision_rate_hz",
        "end_collision_rate_above_0_1_m_s_hz",
        "end_collision_rate_above_0_5_m_s_hz",
        "end_collision_rate_above_1_m_s_hz",
        "dissipated_j",
        "ball_friction_total_j",
        "rotor_friction_j",
        "rotor_damping_j",
        "inner_friction_j",
        "outer_friction_j",
        "ball_friction_j",
        "contact_damping_j",
        "support_damping_j",
        "braking_torque_n_m",
        "end_power_w",
        "inner_ring_power_w",
        "ball_power_w",
        "outer_ring_power_w",
    ];
    let mut compared = 0;
    let numbers = DROP.iter().chain(ROTOR_DROP);
    for quantity in numbers.filter(|q| matches!(q.kind, Kind::Number | Kind::Integer)) {
        let (name, cell) = (quantity.name, run.value(quantity));
        let [first, second] = [&a, &b].map(|results| results.number(name));
        let expected = match name {
            // Rings of different bearings turn at different speeds.
            "ring_speed_rpm" => {
                assert_eq!(cell, Cell::Null);
                continue;
            }
            "plane_margin_min_um" => 150.0,
            "rotor_energy_residual_relative" => 0.0123,
            // Those of the rotor and the run: both have them.
            "rotor_speed_rpm" | "simulated_s" => first,
            "first_contact_ms" | "clearance_margin_um" => first.min(second),
            _ if sums.contains(&name) => first + second,
            _ => first.max(second),
        };
        let found = cell.number().unwrap_or(f64::NAN);
        assert!(
            (found - expected).abs() <= 1e-9 * expected.abs(),
            "{name}: {found} for {expected}"
        );
        compared += 1;
    }
    assert!(compared > 35, "{compared}");
}

/// A limit of a user decides with whose it is, where more is better as the least; a result of drops in
/// succession is judged with its drop.
#[test]
fn limits_of_a_user_judge_a_drop_and_its_succession() {
    let mut ended = drop(&mut 0.2);
    ended.outcome.energy_residual_relative = 0.0;
    let s = &mut ended.s;
    s.rotor_force_max_n = 4000.0;
    s.end_state = EndState::AtRest;
    s.backward_whirl = None;
    s.rotor_displacement_max_m = 100e-6;
    (s.rotor_weight_n, s.inner_pressure_max_pa) = (Some(200.0), 1e9);
    (s.outer_pressure_max_pa, s.ball_pressure_max_pa) = (1e9, 1e9);
    let limit = |result: &str, value: f64| Limit {
        result: result.to_owned(),
        value,
        side: None,
        source: "the plant".to_owned(),
    };
    assert_eq!(ended.result().judgement.passes(), Some(true));
    for (name, kept, broken) in [
        ("rotor_force_max_n", 4001.0, 3999.0),
        ("clearance_margin_um", 336.0, 338.0),
    ] {
        ended.particulars.limits = vec![limit(name, kept)];
        let judgement = ended.result().judgement;
        assert_eq!(judgement.passes(), Some(true), "{name}");
        assert!(judgement.headline().contains("(the plant)"), "{name}");
        ended.particulars.limits = vec![limit(name, broken)];
        let judgement = ended.result().judgement;
        assert_eq!(judgement.passes(), Some(false), "{name}");
        assert_eq!(judgement.reasons().len(), 1);
        assert!(
            judgement.reasons()[0].ends_with("(the plant)"),
            "{judgement:?}"
        );
    }

    let per_k = 12.5e-6;
    let gr_um = 2.0 * per_k * (27_765.0 * 9.0 - 18_240.0 * 11.0 - 2.0 * 4_762.5 * 7.0);
    ended.particulars.limits = vec![limit("ball_standstill_c", 90.0)];
    let result = ended.result();
    assert_eq!(result.judgement.passes(), None, "no succession");
    for (ball_c, verdict) in [(89.0, "pass"), (91.0, "fail")] {
        let mut result = result.clone();
        let successive = SuccessiveDrop {
            number: 3,
            bearing: 1,
            case: &ended.case,
            particulars: &ended.particulars,
            heat_j: 271.0,
            spin_down_s: Some(17.0),
            spin_down_heat_j: Some(333.0),
            rotor: &balanced(),
            standstill_c: Some([61.0, ball_c, 43.0]),
            judgement: DropJudgement::default(),
        };
        let record = succession_record(successive, &mut result);
        assert_eq!(record.text("verdict"), verdict);
        assert_eq!(result.results.text("verdict"), verdict);
        assert_eq!(
            record.sentences("reasons").len(),
            usize::from(ball_c > 90.0)
        );
        let expected = [
            ("inner_ring_start_c", 31.0),
            ("ball_start_c", 27.0),
            ("outer_ring_start_c", 29.0),
            ("radial_internal_clearance_um", gr_um),
            ("touchdown_clearance_um", 200.0),
            ("dissipated_j", 271.0),
            ("spin_down_s", 17.0),
            ("spin_down_heat_j", 333.0),
            ("inner_ring_standstill_c", 61.0),
            ("ball_standstill_c", ball_c),
            ("outer_ring_standstill_c", 43.0),
        ];
        compare(&record.results, &expected, &[], 1e-9);
        let own = record.part("result").unwrap();
        assert_eq!(own.value("rotor_force_max_n"), Some(4000.0));
        assert_eq!(record.get("drop"), Some(&Cell::Integer(3)));
        assert_eq!(record.get("bearing"), Some(&Cell::Integer(2)));
    }
}

/// A row does not pass where the rotor meets a seal in its drop, though its bearing does.
#[test]
fn a_row_fails_with_a_plane_of_the_rotor() {
    let mut ended = drop(&mut 0.2);
    ended.outcome.energy_residual_relative = 0.0;
    let s = &mut ended.s;
    s.backward_whirl = None;
    (s.end_state, s.rotor_displacement_max_m) = (EndState::AtRest, 100e-6);
    (s.rotor_weight_n, s.inner_pressure_max_pa) = (Some(200.0), 1e9);
    (s.outer_pressure_max_pa, s.ball_pressure_max_pa) = (1e9, 1e9);
    ended.particulars.limits = vec![];
    let row = |displacement_max_m: f64| {
        let mut result = ended.result();
        let clearance = Clearance {
            name: "seal".to_owned(),
            radial_m: 3e-4,
        };
        let rotor = RotorOutcome {
            energy_residual_relative: 0.0,
            planes: vec![PlaneDisplacement {
                clearance,
                displacement_max_m,
                path_m: vec![],
                farthest_m: [0.0; 2],
            }],
        };
        let planes = plane_records(&rotor.planes);
        let beyond = displacement_max_m > 3e-4;
        assert_eq!(
            planes[0].text("verdict"),
            if beyond { "fail" } else { "pass" }
        );
        let successive = SuccessiveDrop {
            number: 1,
            bearing: 0,
            case: &ended.case,
            particulars: &ended.particulars,
            heat_j: 1.0,
            spin_down_s: None,
            spin_down_heat_j: None,
            rotor: &rotor,
            standstill_c: None,
            judgement: DropJudgement::default(),
        };
        let record = succession_record(successive, &mut result);
        assert_eq!(result.judgement.passes(), Some(true), "the bearing");
        (
            record.text("verdict").to_owned(),
            record.sentences("reasons").join("; "),
        )
    };
    assert_eq!(row(2.9e-4).0, "pass");
    let (verdict, reasons) = row(3.1e-4);
    assert_eq!(verdict, "fail");
    assert!(reasons.starts_with("seal displaced by 310 µm"), "{reasons}");
}

/// A limit on a result without a value does not pass, except one from above on what does not occur: it fails where the event has not come by the limit,
/// and cannot be judged where that is open or where nothing computes the result.
#[test]
fn a_limit_on_a_result_without_a_value_does_not_pass() {
    let mut ended = drop(&mut 0.2);
    ended.outcome.energy_residual_relative = 0.0;
    let s = &mut ended.s;
    (s.end_state, s.rotor_displacement_max_m) = (EndState::AtRest, 100e-6);
    (s.rotor_weight_n, s.inner_pressure_max_pa) = (Some(200.0), 1e9);
    (s.outer_pressure_max_pa, s.ball_pressure_max_pa) = (1e9, 1e9);
    (s.first_contact_s, s.spin_up_s) = (Some(0.01), None);
    s.backward_whirl = None;
    ended.outcome.end_s = 0.1;
    if let Some(rotor) = &mut ended.case.rotor {
        rotor.clearance_limit_m = None;
    }
    for (name, value, verdict, said) in [
        ("rotor_force_max_n", 1e9, "pass", "at most"),
        (
            "spin_up_ms",
            99.0,
            "fail",
            "not reached within 100 ms, at most 99 ms (the plant)",
        ),
        (
            "spin_up_ms",
            101.0,
            "not-judged",
            "not reached within 100 ms",
        ),
        (
            "clearance_margin_um",
            -1e9,
            "not-judged",
            "cannot be judged: at least",
        ),
        ("inner_ring_standstill_c", 1e9, "not-judged", "drop --drops"),
        (
            "backward_whirl_hz",
            0.0,
            "pass",
            "none, at most 0 Hz (the plant)",
        ),
    ] {
        ended.particulars.limits = vec![Limit {
            result: name.to_owned(),
            value,
            side: None,
            source: "the plant".to_owned(),
        }];
        let found = ended.result();
        assert_eq!(found.results.text("verdict"), verdict, "{name} {value}");
        let headline = found.results.text("headline");
        assert!(headline.contains(said), "{headline}");
    }
}

/// A rotor without planes whose energy balances.
pub(super) fn balanced() -> RotorOutcome {
    RotorOutcome {
        energy_residual_relative: 0.0,
        planes: vec![],
    }
}
