//! Every row of the table of results against the field that it names, in its unit.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use cageless::Case;
use cageless::SpatialSummary;
use cageless::dynamics::EnergyTerm;
use cageless::film::{Film, OilGrade};
use cageless::passage::{PassageRecorder, PassageTally};
use cageless::raceway::MeasuredFlanks;
use cageless::simulation::{Cause, Control, Stop, run};
use cageless::summary::SummaryRecorder;
use cageless::surface::{MeasuredSlot, MeasuredValue, PointDeviation};
use cageless_design::{
    AxialLag, Judgement, LagAndAngle, NoLag, PassageStatistics, RacewayVerdict, RunVerdict,
};
use cageless_io::case_file::{CaseFile, template};

use super::*;

mod drops;
mod statics;
mod verdicts;

#[test]
fn names_are_unique_and_end_with_their_unit() {
    let all: Vec<_> = quantities().filter(|q| q.in_sweeps).collect();
    for (k, quantity) in all.iter().enumerate() {
        let unit = quantity.unit.to_lowercase().replace(['/', '.', ' '], "_");
        // A length times a speed of rotation keeps rpm in its name.
        let unit = unit.replace('^', "").replace("mm_min", "mm_rpm");
        let has = quantity.name.ends_with(&unit);
        assert!(has, "{} {unit}", quantity.name);
        let same = |other: &Quantity| other.column_name() == quantity.column_name();
        assert!(
            !all[k + 1..].iter().any(|other| same(other)),
            "{}",
            quantity.name
        );
        assert!(quantity.label.chars().next().is_some(), "{}", quantity.name);
    }
}

/// One result has one label, whichever computation gives it.
#[test]
fn results_of_one_name_have_one_label_and_labels_name_one_result() {
    let mut labels: BTreeMap<_, &str> = BTreeMap::new();
    for quantity in quantities().filter(|q| q.in_sweeps) {
        let key = (quantity.computation(), quantity.label);
        let name = labels.entry(key).or_insert(quantity.name);
        assert_eq!(*name, quantity.name, "{}", quantity.label);
    }
}

fn case() -> Case {
    let sets = [
        "solver.duration_s=0.04",
        "start.state=rolling",
        "start.gaps=bunched",
    ];
    let sets = sets.map(str::to_owned);
    let file = CaseFile::parse(&template(false), "case.toml", &sets).unwrap();
    file.case().clone()
}

/// Those of a file, whose type is that of the library that is not under test.
fn particulars(file: &CaseFile) -> Particulars {
    let own = file.particulars();
    Particulars {
        title: own.title.clone(),
        seed: own.seed,
        interval_s: own.interval_s,
        fit: own.fit,
        lubrication: own.lubrication.clone(),
        thermal: own.thermal.clone(),
        limits: own.limits.clone(),
    }
}

/// Those of a case that says nothing.
fn no_particulars() -> Particulars {
    particulars(&CaseFile::parse(&template(false), "case.toml", &[]).unwrap())
}

const MPA: f64 = 1e6;
const DEGREE: f64 = PI / 180.0;
const MICROMETRE: f64 = 1e-6;
const REVOLUTION_PER_MINUTE: f64 = 2.0 * PI / 60.0;

/// Compares the numbers of `results` with `expected`, whose values all differ, to a fraction of each;
/// rows of counts, lists, texts and what `others` names are left out.
fn compare(results: &Results, expected: &[(&str, f64)], others: &[&str], fraction: f64) {
    for (k, (name, value)) in expected.iter().enumerate() {
        for (other, second) in &expected[k + 1..] {
            assert!(*value == 0.0 || value != second, "{name} and {other}");
        }
        let found = results.number(name);
        let close = (found - value).abs() <= fraction * value.abs();
        assert!(close, "{name}: {found} for {value}");
    }
    let numbers = results.iter().filter(|(q, _)| q.kind == Kind::Number);
    for (quantity, _) in numbers.filter(|(q, _)| !others.contains(&q.name)) {
        let named = expected.iter().any(|(name, _)| *name == quantity.name);
        assert!(named, "{} is not compared", quantity.name);
    }
}

/// Numbers that all differ, and that no factor of units makes equal.
fn next(counter: &mut f64) -> f64 {
    *counter += 0.0173;
    *counter
}

/// Structure (d) of Zhao 2022 with its raceway turned, against sums and roots apart from this program.
#[test]
fn results_of_a_design_are_those_of_a_computation_by_hand() {
    let sets = ["raceway.centre_angle_deg=30".to_owned()];
    let file = CaseFile::parse(&template(false), "case.toml", &sets).unwrap();
    let expected = [
        ("epsilon_deg", 23.898_207_423_185),
        ("uniform_gap_deg", 1.816_078_291_100_8),
        ("axial_span_limit_mm", 7.401_729_527_617_2),
        ("beta0_deg", 1.817_128_700_096),
        ("beta0_polar_deg", 1.830_392_943_38),
        ("half_angle_for_span_deg", 25.154_712_769),
        ("steady_gap_deg", 1.981_357_037_03),
        // The contact angle ends with the slope √(κ/Rw)/(dψ/dx), κ the curvature of r over x.
        ("slope_discontinuity_deg", 0.654_351_65),
        // Along the path of Eq. (4), over x.
        ("speed_change_max_per_rad", 0.311_500_288),
    ];
    let results = Results::of(DESIGN, Subject::Design(file.case()));
    compare(&results, &expected, &[], 1e-7);
    assert_eq!(results.get("balls_in_raceway_max"), Some(&Cell::Integer(3)));
}

/// Rows of a shuttle of 20° and 25° that miss it by 0.3° in turn, and points of the surface of a ring
/// that are 2 µm off.
#[test]
fn results_of_a_measured_raceway_are_deviations_from_its_fit() {
    let row = |k: i32| {
        let psi = f64::from(k);
        let off = if k == 25 {
            0.0
        } else {
            0.3 * f64::from(1 - 2 * (k % 2))
        };
        [psi, 20.0 * (1.0 - (psi / 25.0).powi(2)) + off].map(|angle| angle * DEGREE)
    };
    let rows: Vec<_> = (0..=25).map(row).collect();
    let profile = MeasuredFlanks::fit(&rows).unwrap();
    let results = Results::of(PROFILE, Subject::Profile(&profile));
    // What turns from row to row is no part of the fit.
    for (name, expected, allowed) in [
        ("profile_flank_angle_deg", 20.0, 0.1),
        ("profile_half_angle_deg", 25.0, 1e-9),
        ("profile_deviation_deg", 0.3, 0.03),
        ("profile_deviation_max_deg", 0.4, 0.1),
    ] {
        let found = results.number(name);
        assert!((found - expected).abs() < allowed, "{name}: {found}");
    }
    assert!(results.number("profile_deviation_deg") < results.number("profile_deviation_max_deg"));

    let deviation = PointDeviation {
        points: 21 * 8,
        mean_m: 2.0 * MICROMETRE,
        largest_m: 2.5 * MICROMETRE,
    };
    let fitted = FittedRaceway {
        deviation,
        depth_error_m: 3.7 * MICROMETRE,
    };
    let results = Results::of(GROOVE, Subject::Points(&fitted));
    assert!((results.number("measured_depth_error_um") - 3.7).abs() < 1e-12);
    assert_eq!(results.get("measured_points"), Some(&Cell::Integer(21 * 8)));
    assert!((results.number("measured_deviation_um") - 2.0).abs() < 1e-12);
    assert!((results.number("measured_deviation_max_um") - 2.5).abs() < 1e-12);
}

#[test]
fn results_of_a_measured_slot_are_its_dimensions() {
    let measured = |value| MeasuredValue {
        value,
        standard_uncertainty: 0.1 * value,
    };
    let mut slot = MeasuredSlot {
        edge_radius_m: measured(0.31e-3),
        axial_span_m: measured(2.41e-3),
        half_angle_rad: measured(25.1 * DEGREE),
        centre_angle_rad: measured(17.2 * DEGREE),
        width_m: 1.97e-3,
        depth_error_m: measured(3.7 * MICROMETRE),
        slot_depth_m: Some(0.63e-3),
        deviation: PointDeviation {
            points: 701,
            mean_m: 1.1 * MICROMETRE,
            largest_m: 4.3 * MICROMETRE,
        },
    };
    let expected = [
        ("edge_radius_mm", 0.31),
        ("axial_span_mm", 2.41),
        ("slot_width_mm", 1.97),
        ("half_angle_deg", 25.1),
        ("centre_angle_deg", 17.2),
        ("slot_depth_mm", 0.63),
    ];
    compare(
        &Results::of(SLOT, Subject::Slot(&slot)),
        &expected,
        &[],
        1e-12,
    );
    let fitted = FittedRaceway {
        deviation: slot.deviation,
        depth_error_m: slot.depth_error_m.value,
    };
    let of_points = Results::of(GROOVE, Subject::Points(&fitted));
    assert_eq!(of_points.get("measured_points"), Some(&Cell::Integer(701)));
    assert!((of_points.number("measured_deviation_um") - 1.1).abs() < 1e-12);
    assert!((of_points.number("measured_deviation_max_um") - 4.3).abs() < 1e-12);
    slot.slot_depth_m = None;
    let results = Results::of(SLOT, Subject::Slot(&slot));
    assert_eq!(results.get("slot_depth_mm"), Some(&Cell::Null));
}

#[test]
fn results_of_a_verdict_are_its_fields() {
    let passages = PassageStatistics {
        passages: 41,
        collisions_mean: 0.31,
        double_collision_fraction: 0.47,
        sliding_mean_m_s: 0.53,
        speed_drop_fraction: 0.91,
        lag_mean_rad: 0.04,
        lag_fraction: 0.9,
        gap_leave_max_rad: 0.037,
        gap_leave_min_rad: 0.029,
    };
    let judgement = Judgement {
        verdict: RacewayVerdict::Smooth,
        reasons: vec![],
        deciding: None,
        critical_gap_rad: Some(0.033),
        pressure_at_rest_pa: Some(2.3e9),
        steady_gap_rad: Some(0.0375),
        passages: Some(passages),
        raceways: vec![],
        film: None,
        dry: None,
        stopped: None,
    };
    let case = case();
    let expected = [
        ("critical_gap_deg", 0.033 / DEGREE),
        ("judged_steady_gap_deg", 0.0375 / DEGREE),
        ("gap_reserve_deg", (0.0375 - 0.033) / DEGREE),
        ("pressure_at_rest_mpa", 2300.0),
        ("collisions_mean", 0.31),
        ("double_collision_fraction", 0.47),
        ("sliding_mean_m_s", 0.53),
        ("speed_drop_fraction", 0.91),
        ("lag_per_pass_deg", 0.04 / DEGREE),
        ("gap_leave_min_deg", 0.029 / DEGREE),
        ("gap_leave_max_deg", 0.037 / DEGREE),
    ];
    let judged = Judged {
        case: &case,
        judgement: &judgement,
    };
    let results = Results::of(VERDICT, Subject::Verdict(&judged))
        .and(Results::of(PASSAGES, Subject::Passages(&passages)));
    compare(&results, &expected, &["margin"], 1e-12);
    assert_eq!(results.get("passages"), Some(&Cell::Integer(41)));
}

fn axial_lag(axial_load_n: f64, tilt_x_rad: f64, lag: Result<[f64; 2], NoLag>) -> AxialLag {
    AxialLag {
        axial_load_n,
        tilt_x_rad,
        critical_gap_rad: lag.is_ok().then_some(Ok(0.25 * PI)),
        lag: lag.map(|[lag_rad, inner_contact_angle_rad]| LagAndAngle {
            lag_rad,
            inner_contact_angle_rad,
        }),
    }
}

#[test]
fn results_under_axial_load_are_the_points() {
    let lags = [
        axial_lag(0.0, 0.0, Ok([0.04, 0.0])),
        axial_lag(100.0, 0.0, Ok([-0.04, 0.25 * PI])),
        axial_lag(100.0, 1e-3, Err(NoLag::NoPassage)),
    ];
    let results = axial_record(&lags);
    let expected = [
        ("axial_load_three_quarters_n", 12.5),
        ("axial_load_half_n", 25.0),
        ("axial_load_none_n", 50.0),
    ];
    compare(&results, &expected, &[], 1e-12);
    assert_eq!(results.values("axial_load_n"), [0.0, 100.0, 100.0]);
    assert_eq!(results.values("tilt_x_mrad"), [0.0, 0.0, 1.0]);
    let [first, second, none] = *results.values("lag_per_pass_deg") else {
        panic!("three lags");
    };
    assert!((first - 0.04 / DEGREE).abs() < 1e-12 && second == -first && none.is_nan());
    let angles = results.values("inner_contact_angle_mean_deg");
    assert_eq!(angles[..2], [0.0, 45.0]);
    let gaps = results.values("critical_gap_deg");
    assert!(gaps[..2] == [45.0; 2] && gaps[2].is_nan());
    assert!(results.sentences("findings").is_empty());
}

/// A limit beyond a run that stopped is none, and says so with the reason; the number of such runs is stated.
#[test]
fn an_axial_load_without_result_has_its_reason() {
    let stop = Stop {
        time_s: 0.002,
        step_s: 1e-6,
        drop: false,
        automatic_step_s: 1e-6,
        cause: Cause::NotFinite,
    };
    let lags = [
        axial_lag(0.0, 0.0, Ok([0.04, 0.0])),
        axial_lag(100.0, 0.0, Ok([0.028, 0.1])),
        axial_lag(200.0, 0.0, Err(NoLag::Stopped(stop.clone()))),
        axial_lag(300.0, 0.0, Ok([0.01, 0.1])),
        axial_lag(0.0, 1e-3, Err(NoLag::Stopped(stop))),
        axial_lag(
            400.0,
            0.0,
            Err(NoLag::NotBorne("no equilibrium".to_owned())),
        ),
    ];
    let record = axial_record(&lags);
    assert!(record.number("axial_load_three_quarters_n") < 100.0);
    assert_eq!(record.value("axial_load_half_n"), None);
    assert_eq!(record.value("axial_load_none_n"), None);
    let [limit, count] = record.sentences("findings") else {
        panic!("{:?}", record.sentences("findings"));
    };
    assert!(
        limit.starts_with(
            "The axial load that leaves half of the lag is not known: at 200 N the run stopped at t = 0.002000 s"
        ),
        "{limit}"
    );
    assert!(
        count
            .starts_with("2 of 6 loads and tilts lack results, as a run stopped. The first, 200 N")
    );
}

/// Orders by the closed forms with Dw = 9.525 mm, Dpw = 46.005 mm, 14 balls and 200 Hz.
#[test]
fn frequencies_of_defects_are_multiples_of_the_shaft_frequency() {
    let case = case();
    let equilibrium = cageless::equilibrium::settle(&case).unwrap();
    let particulars = no_particulars();
    let solved = Solved::new(&case, &particulars, &equilibrium);
    let g = 9.525 / 46.005;
    let expected = [
        ("ftf_order", 0.5 * (1.0 - g)),
        ("bpfo_order", 7.0 * (1.0 - g)),
        ("bpfi_order", 7.0 * (1.0 + g)),
        ("bsf_order", 0.5 * (1.0 / g - g)),
        ("bsf_twice_order", 1.0 / g - g),
        ("bsf_twice_hz", 200.0 * (1.0 / g - g)),
    ];
    let results = Results::of(DEFECTS, Subject::Static(&solved));
    compare(&results, &expected, &[], 1e-12);
    let record = static_record(&case, &particulars, &equilibrium);
    assert_eq!(
        record.results.number("bpfo_order"),
        results.number("bpfo_order")
    );
}

#[test]
fn results_with_a_fit_are_its_fields() {
    let sets = [
        "bore_diameter_mm=30",
        "outside_diameter_mm=62",
        "shaft_interference_um=9",
        "housing_interference_um=4",
        "outer_ring_temperature_c=45",
    ];
    let sets = sets.map(|set| format!("fit.{set}"));
    let file = CaseFile::parse(&template(false), "case.toml", &sets).unwrap();
    let (case, particulars) = (file.case(), particulars(&file));
    let equilibrium = cageless::equilibrium::settle(case).unwrap();
    let solved = Solved::new(case, &particulars, &equilibrium);
    let fit = particulars.fit.unwrap();
    let um = 1e6;
    let expected = [
        ("initial_clearance_um", fit.initial_m * um),
        (
            "effective_shaft_interference_um",
            fit.shaft_interference_m * um,
        ),
        ("effective_housing_interference_um", 4.0),
        ("shaft_reduction_um", fit.shaft_reduction_m * um),
        ("housing_reduction_um", fit.housing_reduction_m * um),
        ("thermal_clearance_change_um", fit.thermal_change_m * um),
        ("speed_reduction_um", fit.speed_reduction_m * um),
        (
            "operating_clearance_um",
            case.bearing.radial_internal_clearance_m() * um,
        ),
        ("shaft_fit_pressure_mpa", fit.shaft_pressure_pa / MPA),
        ("housing_fit_pressure_mpa", fit.housing_pressure_pa / MPA),
    ];
    let results = Results::of(FIT, Subject::Static(&solved));
    compare(&results, &expected, &[], 1e-9);
    let record = static_record(case, &particulars, &equilibrium);
    assert_eq!(
        record.results.number("operating_clearance_um"),
        results.number("operating_clearance_um")
    );
}

/// Ratings with a lubricant are there in space, too; SKF's friction is of a single deep groove, and else said to be
/// left out.
#[test]
fn ratings_with_a_lubricant_are_there_or_said_to_be_left_out() {
    let lubricant = [
        "lubrication.viscosity_mm2_s=6",
        "lubrication.contamination_factor=0.3",
        "lubrication.skf_series=\"62\"",
    ];
    for (set, [has_life, has_friction]) in [
        ("model.motion=\"auto\"", [true, true]),
        ("model.motion=\"space\"", [true, true]),
        ("operation.axial_load_n=200", [true, true]),
        ("operation.moment_x_n_m=1", [false, false]),
        ("bearing.contact_angle_deg=15", [true, false]),
    ] {
        let sets = lubricant.into_iter().chain([set]);
        let sets: Vec<String> = sets.map(str::to_owned).collect();
        let file = CaseFile::parse(&template(true), "case.toml", &sets).unwrap();
        let settled = cageless::equilibrium::settle(file.case()).unwrap();
        let record = static_record(file.case(), &particulars(&file), &settled);
        let has = |name: &str| record.results.number(name).is_finite();
        assert!(has("viscosity_ratio") && has("l10mr_h"), "{set}");
        assert_eq!(
            [has("l10m_h"), has("skf_model_torque_n_m")],
            [has_life, has_friction],
            "{set}"
        );
        let notes = record.sentences("notes");
        let said = notes
            .iter()
            .any(|note| note.starts_with("lubrication.skf_series"));
        assert_eq!(said, !has_friction, "{set}: {notes:?}");
    }
}

#[test]
fn results_with_a_lubricant_are_the_fields_of_its_rating() {
    let sets = [
        "viscosity_mm2_s=6",
        "contamination_factor=0.3",
        "minimum_load_factor=0.02",
        "skf_series=\"62\"",
    ];
    let sets = sets.map(|set| format!("lubrication.{set}"));
    let file = CaseFile::parse(&template(false), "case.toml", &sets).unwrap();
    let (case, particulars) = (file.case(), particulars(&file));
    assert_eq!(
        particulars.lubrication.as_ref().unwrap().viscosity_m2_s,
        6e-6
    );
    let equilibrium = cageless::equilibrium::settle(case).unwrap();
    let solved = Solved::new(case, &particulars, &equilibrium);
    let rating = solved.lubricated.unwrap();
    let life = rating.l10m_mrev.unwrap();
    let skf = rating.skf_friction.unwrap();
    let expected = [
        ("viscosity_ratio", rating.viscosity_ratio),
        ("fatigue_load_limit_n", rating.fatigue_load_limit_n),
        (
            "life_modification_factor",
            rating.life_modification_factor.unwrap(),
        ),
        ("l10m_mrev", life),
        // 12 000 rpm.
        ("l10m_h", life / 0.72),
        ("l10mr_mrev", rating.l10mr_mrev.unwrap()),
        ("l10mr_h", rating.l10mr_mrev.unwrap() / 0.72),
        (
            "minimum_radial_load_n",
            rating.minimum_radial_load_n.unwrap(),
        ),
        ("skf_rolling_torque_n_m", skf.rolling_n_m),
        ("skf_sliding_torque_n_m", skf.sliding_n_m),
        ("skf_model_torque_n_m", skf.rolling_n_m + skf.sliding_n_m),
        (
            "skf_model_power_w",
            (skf.rolling_n_m + skf.sliding_n_m) * 400.0 * PI,
        ),
    ];
    let results = Results::of(LUBRICATION, Subject::Static(&solved));
    compare(&results, &expected, &[], 1e-12);
    let record = static_record(case, &particulars, &equilibrium);
    assert_eq!(record.results.number("l10m_mrev"), life);
}

#[test]
fn results_of_a_run_are_the_fields_of_its_summary() {
    let mut case = case();
    case.film = Some(Film::flooded(OilGrade::IsoVg10.at(60.0)));
    let mut recorder = SummaryRecorder::new();
    let mut tally = PassageTally::new();
    let mut passages = PassageRecorder::new(|passage| {
        tally.add(&passage);
        Ok(())
    });
    let outcome = run(&case, &mut [&mut recorder, &mut passages], &mut |_| {
        Control::Continue(())
    });
    let outcome = outcome.unwrap();
    let mut s = recorder.summary().unwrap();
    let mut k = 0.2;
    for peak in [&mut s.peaks.inner, &mut s.peaks.outer, &mut s.peaks.balls] {
        for field in [
            &mut peak.force_n,
            &mut peak.pressure_pa,
            &mut peak.pressure_velocity_pa_m_s,
        ] {
            *field = next(&mut k);
        }
    }
    for field in [
        &mut s.settled_after_s,
        &mut s.gap_min_rad,
        &mut s.gap_max_rad,
        &mut s.gap_deviation_rad,
        &mut s.gap_deviation_change_rad,
        &mut s.outer_ring_force_deviation_n,
        &mut s.ring_x_mean_m,
        &mut s.ring_y_mean_m,
        &mut s.sliding_max_m_s,
    ] {
        *field = next(&mut k);
    }
    let lag_rad = *s.half_turn_lag_rad.insert(next(&mut k));
    let creep_m_s = *s.regularisation_speed_mean_m_s.insert(next(&mut k));
    let space = s.space.insert(SpatialSummary {
        ring_z_mean_m: next(&mut k),
        tilt_mean_rad: [next(&mut k), next(&mut k)],
        inner_contact_angle_mean_rad: next(&mut k),
        outer_contact_angle_mean_rad: next(&mut k),
        ellipse_edge_max_rad: [next(&mut k), next(&mut k)],
        row_preload_start_m: vec![next(&mut k), next(&mut k)],
        row_preload_mean_m: vec![next(&mut k), next(&mut k)],
        row_axial_force_mean_n: vec![next(&mut k), next(&mut k)],
    });
    let space = space.clone();
    let m = s.means.unwrap();
    let finished = Finished {
        case: &case,
        outcome: &outcome,
        summary: Some(&s),
        passages: &tally,
        verdict: &RunVerdict::unfinished(&case, "a test"),
        wall_s: 77.0,
    };
    let turns = case.operation.inner_speed_rad_s / (2.0 * PI);
    let gamma = case.bearing.ball_radius_m() / case.bearing.pitch_radius_m();
    let balls = case.bearing.balls() as f64;
    let orbit = m.orbit_speed_rad_s / (2.0 * PI);
    let bore = 2.0 * (18.24e-3 - 0.3 * 9.525e-3);
    let expected = [
        (
            "friction_torque_n_m",
            m.power_w(EnergyTerm::Drive) / (2.0 * PI * turns),
        ),
        ("friction_torque_skf_n_m", 0.5 * 0.0015 * 1500.0 * bore),
        ("power_loss_w", m.power_w(EnergyTerm::Drive)),
        (
            "power_loss_inner_friction_w",
            m.power_w(EnergyTerm::InnerFriction),
        ),
        (
            "power_loss_outer_friction_w",
            m.power_w(EnergyTerm::OuterFriction),
        ),
        (
            "power_loss_ball_friction_w",
            m.power_w(EnergyTerm::BallFriction),
        ),
        ("power_loss_damping_w", m.power_w(EnergyTerm::Damping)),
        (
            "power_loss_inner_ring_damping_w",
            m.power_w(EnergyTerm::Drag),
        ),
        (
            "power_loss_stored_w",
            m.power_w(EnergyTerm::Drive) - m.heat_w,
        ),
        (
            "rolling_resistance_power_w",
            m.power_w(EnergyTerm::RollingResistance),
        ),
        ("regularisation_speed_mean_m_s", creep_m_s),
        (
            "rolling_resistance_torque_n_m",
            m.power_w(EnergyTerm::RollingResistance) / (2.0 * PI * turns),
        ),
        ("half_turn_lag_deg", lag_rad / DEGREE),
        ("half_turn_deficit_fraction", 2.0 * lag_rad / PI),
        ("inner_pressure_max_mpa", s.peaks.inner.pressure_pa / MPA),
        ("outer_pressure_max_mpa", s.peaks.outer.pressure_pa / MPA),
        ("ball_pressure_max_mpa", s.peaks.balls.pressure_pa / MPA),
        ("inner_force_max_n", s.peaks.inner.force_n),
        ("outer_force_max_n", s.peaks.outer.force_n),
        ("ball_force_max_n", s.peaks.balls.force_n),
        (
            "inner_pressure_velocity_max_mpa_m_s",
            s.peaks.inner.pressure_velocity_pa_m_s / 1e6,
        ),
        (
            "outer_pressure_velocity_max_mpa_m_s",
            s.peaks.outer.pressure_velocity_pa_m_s / 1e6,
        ),
        (
            "ball_pressure_velocity_max_mpa_m_s",
            s.peaks.balls.pressure_velocity_pa_m_s / 1e6,
        ),
        ("ring_x_mean_um", s.ring_x_mean_m / MICROMETRE),
        ("ring_y_mean_um", s.ring_y_mean_m / MICROMETRE),
        ("ring_z_mean_um", space.ring_z_mean_m / MICROMETRE),
        ("tilt_x_mean_mrad", space.tilt_mean_rad[0] / 0.001),
        ("tilt_y_mean_mrad", space.tilt_mean_rad[1] / 0.001),
        (
            "inner_contact_angle_mean_deg",
            space.inner_contact_angle_mean_rad / DEGREE,
        ),
        (
            "outer_contact_angle_mean_deg",
            space.outer_contact_angle_mean_rad / DEGREE,
        ),
        (
            "inner_ellipse_edge_max_deg",
            space.ellipse_edge_max_rad[0] / DEGREE,
        ),
        (
            "outer_ellipse_edge_max_deg",
            space.ellipse_edge_max_rad[1] / DEGREE,
        ),
        ("lag_per_pass_deg", tally.means().lag_rad / DEGREE),
        ("gap_min_deg", s.gap_min_rad / DEGREE),
        ("gap_max_deg", s.gap_max_rad / DEGREE),
        ("gap_deviation_deg", s.gap_deviation_rad / DEGREE),
        (
            "gap_deviation_change_deg",
            s.gap_deviation_change_rad / DEGREE,
        ),
        (
            "outer_ring_force_deviation_n",
            s.outer_ring_force_deviation_n,
        ),
        ("sliding_max_m_s", s.sliding_max_m_s),
        (
            "orbit_speed_rpm",
            m.orbit_speed_rad_s / REVOLUTION_PER_MINUTE,
        ),
        (
            "rotation_speed_rpm",
            m.rotation_rad_s / REVOLUTION_PER_MINUTE,
        ),
        ("ftf_hz", 0.5 * turns * (1.0 - gamma)),
        ("bpfo_hz", 0.5 * balls * turns * (1.0 - gamma)),
        ("bpfi_hz", 0.5 * balls * turns * (1.0 + gamma)),
        ("bsf_hz", 0.5 * turns / gamma * (1.0 - gamma * gamma)),
        ("ftf_observed_hz", orbit),
        ("bpfo_observed_hz", balls * orbit),
        ("bpfi_observed_hz", balls * (turns - orbit)),
        (
            "bsf_observed_hz",
            (m.rotation_rad_s + m.orbit_speed_rad_s) / (2.0 * PI),
        ),
        ("passage_duration_mean_ms", tally.means().duration_s / 1e-3),
        ("passage_collisions_mean", tally.means().collisions),
        (
            "double_collision_fraction",
            tally.means().double_collision_fraction,
        ),
        ("passage_sliding_mean_m_s", tally.means().sliding_m_s),
        ("passage_unloaded_fraction", tally.means().unloaded_fraction),
        (
            "passage_gap_min_mean_deg",
            tally.means().gap_min_rad / DEGREE,
        ),
        ("settled_after_s", s.settled_after_s),
        ("energy_residual_relative", outcome.energy_residual_relative),
        ("simulated_s", 0.04),
        ("wall_s", 77.0),
    ];
    let of_bodies = [
        "margin",
        "power_loss_rotor_friction_w",
        "power_loss_rotor_damping_w",
        "power_loss_support_damping_w",
    ];
    let results = Results::of(RUN, Subject::Run(&finished));
    compare(&results, &expected, &of_bodies, 1e-12);
    for (name, count) in [
        ("collisions", s.collisions.all),
        ("passages", tally.count),
        ("averaged_orbits", u64::from(m.orbits)),
        ("steps", outcome.steps),
        ("rhs_evaluations", outcome.rhs_evaluations),
    ] {
        assert_eq!(
            results.get(name),
            Some(&Cell::Integer(count as i64)),
            "{name}"
        );
    }
    let scaled =
        |values: &[f64], unit: f64| Cell::Numbers(values.iter().map(|v| v / unit).collect());
    for (name, values, unit) in [
        (
            "row_preload_start_um",
            &space.row_preload_start_m,
            MICROMETRE,
        ),
        ("row_preload_mean_um", &space.row_preload_mean_m, MICROMETRE),
        ("row_axial_force_mean_n", &space.row_axial_force_mean_n, 1.0),
    ] {
        let (Some(Cell::Numbers(found)), Cell::Numbers(expected)) =
            (results.get(name), scaled(values, unit))
        else {
            panic!("{name}");
        };
        assert_eq!(found.len(), 2);
        for (a, b) in found.iter().zip(&expected) {
            assert!((a / b - 1.0).abs() < 1e-12, "{name}: {a} {b}");
        }
    }
    // The time of a passage is about that of rolling through 2θ.
    let rolling_ms = 2e3 * 25.2 * DEGREE / m.orbit_speed_rad_s;
    assert!((results.number("passage_duration_mean_ms") / rolling_ms - 1.0).abs() < 0.2);
}

/// The ends of the clearance with the lives of bearings that have them, typed without a fit.
#[test]
fn results_with_tolerances_are_those_at_the_ends() {
    let text = template(false);
    let sets = [
        "fit.bore_diameter_mm=30",
        "fit.outside_diameter_mm=62",
        "fit.shaft=k5",
        "fit.housing=J7",
        "bearing.radial_internal_clearance_um=15",
        "fit.clearance_tolerance_um=5",
    ]
    .map(str::to_owned);
    let file = CaseFile::parse(&text, "case.toml", &sets).unwrap();
    let settled = cageless::equilibrium::settle(file.case()).unwrap();
    let record = static_record(file.case(), &particulars(&file), &settled);
    let range = file.particulars().fit.unwrap().range.unwrap();
    let um = 1e6;
    let life_h = |clearance_m: f64| {
        let set = format!(
            "bearing.radial_internal_clearance_um={:?}",
            clearance_m * um
        );
        let file = CaseFile::parse(&text, "case.toml", &[set]).unwrap();
        let settled = cageless::equilibrium::settle(file.case()).unwrap();
        static_record(file.case(), &particulars(&file), &settled)
            .results
            .number("l10r_h")
    };
    let [least, largest] = range.probable_m;
    let expected = [
        ("operating_clearance_least_um", least * um),
        ("operating_clearance_largest_um", largest * um),
        ("l10r_least_clearance_h", life_h(least)),
        ("l10r_largest_clearance_h", life_h(largest)),
    ];
    for (name, expected) in expected {
        let found = record.results.number(name);
        assert!(
            (found / expected - 1.0).abs() < 2e-4,
            "{name} {found} {expected}"
        );
    }
    let [tight, loose] = range.extreme_m;
    assert!(tight < least && least < largest && largest < loose);
    let ratio = life_h(least) / life_h(largest);
    assert!((ratio - 1.0).abs() > 0.02, "{ratio}");
    let json = serde_json::to_string(&record).unwrap();
    assert!(json.contains("operating_clearance_extremes_um"), "{json}");
}

/// A limit on a result that the case does not have is not judged, and not left out.
#[test]
fn a_limit_on_a_film_is_not_judged_without_one() {
    let case = cageless::reference::conventional();
    let limit = |result: &str| cageless::touchdown::Limit {
        result: result.to_owned(),
        value: 3.0,
        side: None,
        source: "a test".to_owned(),
    };
    let particulars = Particulars {
        limits: ["film_parameter_min", "viscosity_ratio", "verdict"]
            .map(limit)
            .to_vec(),
        ..no_particulars()
    };
    let record = crate::static_record(
        &case,
        &particulars,
        &cageless::equilibrium::settle(&case).unwrap(),
    );
    let judged = record.limits();
    let [film, ratio] = &judged.limits_not_judged[..] else {
        panic!("{judged:?}");
    };
    assert!(
        film.starts_with("film parameter Λ, least has no value here; at least 3"),
        "{film}"
    );
    assert!(ratio.contains("has no value here"), "{ratio}");
}
