//! Rows of a static equilibrium in space, of two rows of balls.

use std::path::Path;

use cageless::BallAdvance;
use cageless::equilibrium::settle;
use cageless::rating::{BasicRatings, PassingFrequencies, Rating};

use super::*;

const CASE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../cases/preloaded-pair.toml"
);
/// Balls of both rows.
const BALLS: usize = 28;

/// Every number of the equilibrium and its ratings another, each row against the field that it names.
#[test]
fn results_in_space_are_the_fields_of_the_equilibrium() {
    let loads = ["operation.axial_load_n=4000".to_owned()];
    let file = CaseFile::read(Path::new(CASE), &loads).unwrap();
    let case = file.case();
    let k = &mut 0.2;
    let mut space = settle(case).unwrap();
    let mut e = space.rest.clone();
    for field in [
        &mut e.ring_x_m,
        &mut e.ring_y_m,
        &mut e.inner_pressure_max_pa,
        &mut e.outer_pressure_max_pa,
        &mut e.inner_stiffness_n_m1_5,
        &mut e.outer_stiffness_n_m1_5,
        &mut space.ring_z_m,
        &mut space.tilt_x_rad,
        &mut space.tilt_y_rad,
    ] {
        *field = next(k);
    }
    space.ellipse_edge_max_rad = [next(k), next(k)];
    for list in [
        &mut e.ball_angle_rad,
        &mut e.effective_radius_m,
        &mut e.inner_force_n,
        &mut e.outer_force_n,
        &mut space.inner_contact_angle_rad,
        &mut space.outer_contact_angle_rad,
        &mut space.orbit_speed_rad_s,
    ] {
        *list = (0..BALLS).map(|_| next(k)).collect();
    }
    for contact in e.inner_contact.iter_mut().chain(&mut e.outer_contact) {
        contact.pressure_pa = next(k);
        contact.semi_axes_m = [next(k), next(k)];
    }
    // Without load, and the largest of both lists not in the same place.
    (e.inner_force_n[3], e.inner_force_n[9]) = (0.0, 99.0);
    e.outer_force_n[17] = 77.0;
    e.stiffness_n_m = Some([[next(k), next(k)], [next(k), next(k)]]);
    space.flank_force_n = (0..BALLS).map(|_| [next(k), next(k)]).collect();
    (space.row_preload_m, space.row_axial_force_n) =
        (vec![next(k), next(k)], vec![next(k), next(k)]);
    let matrix: [[f64; 5]; 5] = std::array::from_fn(|_| std::array::from_fn(|_| next(k)));
    space.stiffness = Some(matrix);
    space.rest = e.clone();
    let mut number = || Some(next(k));
    let rating = Rating {
        basic: BasicRatings {
            dynamic_n: number().unwrap(),
            static_n: number().unwrap(),
        },
        l10_mrev: number(),
        l10r_mrev: number(),
        l10r_at_speed_mrev: number(),
        static_safety_factor: number(),
        pressure_safety: number(),
        passing: PassingFrequencies {
            ftf_hz: number().unwrap(),
            bpfo_hz: number().unwrap(),
            bpfi_hz: number().unwrap(),
            bsf_hz: number().unwrap(),
            raceway_ftf_hz: number().unwrap(),
        },
        loaded_contact_angle_rad: Some(0.31),
        speed_factor_mm_rpm: number().unwrap(),
        ..Rating::in_space(case, &space)
    };
    let advance = BallAdvance {
        orbit_speed_rad_s: (0..BALLS).map(|ball| 400.0 + ball as f64).collect(),
        rotation_rad_s: (0..BALLS).map(|ball| 2000.0 + ball as f64).collect(),
        mean_speed_rad_s: 410.0,
        speed_difference_rad_s: 6.25,
        advance_rad: 0.0106,
        clearance_rad: 0.00135,
        neighbour_drift_rad_s: Some(0.015),
    };
    let particulars = no_particulars();
    let solved = Solved {
        case,
        particulars: &particulars,
        lubricated: None,
        equilibrium: &e,
        rating: rating.clone(),
        space: Some(&space),
        advance: Some(advance.clone()),
        film: None,
        regularisation_speed_mean_m_s: Some(0.00125),
        l10r_of_range_mrev: [None; 2],
    };
    let results = [STATIC, SPACE, DEFECTS].map(|rows| Results::of(rows, Subject::Static(&solved)));
    let [plane, in_space, defects] = results;
    let results = plane.and(in_space).and(defects);
    let turns = case.operation.inner_speed_rad_s / (2.0 * PI);
    // Million revolutions over revolutions an hour.
    let hours = |life: Option<f64>| life.unwrap() * 1e6 / (3600.0 * turns);
    // Frequencies at 0.31 rad: γ = Dw cos α/Dpw.
    let d = case.bearing.dimensions();
    let pitch_m = d.inner_groove_bottom_radius_m + d.outer_groove_bottom_radius_m;
    let gamma = 2.0 * d.ball_radius_m * 0.31f64.cos() / pitch_m;
    let plane = e.stiffness_n_m.unwrap();
    let passing = rating.passing;
    let expected = [
        ("ring_x_um", e.ring_x_m / MICROMETRE),
        ("ring_y_um", e.ring_y_m / MICROMETRE),
        ("stiffness_xx_n_m", plane[0][0]),
        ("stiffness_yy_n_m", plane[1][1]),
        ("stiffness_xy_n_m", plane[0][1]),
        ("inner_pressure_max_mpa", e.inner_pressure_max_pa / MPA),
        ("outer_pressure_max_mpa", e.outer_pressure_max_pa / MPA),
        ("inner_force_max_n", 99.0),
        ("outer_force_max_n", 77.0),
        ("equivalent_load_n", rating.equivalent.unwrap().dynamic_n),
        (
            "equivalent_static_load_n",
            rating.equivalent.unwrap().static_n,
        ),
        ("static_safety_factor", rating.static_safety_factor.unwrap()),
        ("pressure_safety", rating.pressure_safety.unwrap()),
        ("basic_dynamic_rating_n", rating.basic.dynamic_n),
        ("basic_static_rating_n", rating.basic.static_n),
        ("l10_mrev", rating.l10_mrev.unwrap()),
        ("l10_h", hours(rating.l10_mrev)),
        ("l10r_mrev", rating.l10r_mrev.unwrap()),
        ("l10r_h", hours(rating.l10r_mrev)),
        ("l10r_at_speed_mrev", rating.l10r_at_speed_mrev.unwrap()),
        ("l10r_at_speed_h", hours(rating.l10r_at_speed_mrev)),
        ("ftf_hz", passing.ftf_hz),
        ("bpfo_hz", passing.bpfo_hz),
        ("bpfi_hz", passing.bpfi_hz),
        ("bsf_hz", passing.bsf_hz),
        ("raceway_ftf_hz", passing.raceway_ftf_hz),
        ("regularisation_speed_mean_m_s", 0.00125),
        ("speed_factor_mm_rpm", rating.speed_factor_mm_rpm),
        ("orbit_speed_difference_rpm", 6.25 / REVOLUTION_PER_MINUTE),
        ("ball_advance_deg", 0.0106 / DEGREE),
        ("ball_advance_clearance_deg", 0.00135 / DEGREE),
        (
            "ball_advance_clearance_um",
            0.00135 * 0.5 * pitch_m / MICROMETRE,
        ),
        ("neighbour_drift_deg_s", 0.015 / DEGREE),
        ("inner_stiffness_n_m1_5", e.inner_stiffness_n_m1_5),
        ("outer_stiffness_n_m1_5", e.outer_stiffness_n_m1_5),
        ("ftf_order", passing.ftf_hz / turns),
        ("bpfo_order", passing.bpfo_hz / turns),
        ("bpfi_order", passing.bpfi_hz / turns),
        ("bsf_order", passing.bsf_hz / turns),
        ("bsf_twice_order", 2.0 * passing.bsf_hz / turns),
        ("bsf_twice_hz", 2.0 * passing.bsf_hz),
        ("ring_z_um", space.ring_z_m / MICROMETRE),
        ("tilt_x_mrad", space.tilt_x_rad / 0.001),
        ("tilt_y_mrad", space.tilt_y_rad / 0.001),
        ("stiffness_zz_n_m", matrix[2][2]),
        ("stiffness_xz_n_m", matrix[0][2]),
        ("stiffness_yz_n_m", matrix[1][2]),
        ("tilt_stiffness_xx_n_m_rad", matrix[3][3]),
        ("tilt_stiffness_yy_n_m_rad", matrix[4][4]),
        ("loaded_contact_angle_deg", 0.31 / DEGREE),
        ("loaded_ftf_hz", 0.5 * turns * (1.0 - gamma)),
        ("loaded_bpfo_hz", 7.0 * turns * (1.0 - gamma)),
        ("loaded_bpfi_hz", 7.0 * turns * (1.0 + gamma)),
        (
            "loaded_bsf_hz",
            0.5 * turns * pitch_m / (2.0 * d.ball_radius_m) * (1.0 - gamma * gamma),
        ),
        (
            "inner_ellipse_edge_max_deg",
            space.ellipse_edge_max_rad[0] / DEGREE,
        ),
        (
            "outer_ellipse_edge_max_deg",
            space.ellipse_edge_max_rad[1] / DEGREE,
        ),
    ];
    compare(&results, &expected, &["rating_factor"], 1e-12);
    let loaded = results.get("loaded_balls");
    assert_eq!(loaded, Some(&Cell::Integer(BALLS as i64 - 1)));
    let contacts = |contacts: &[cageless::RacewayContact], of: usize| -> Vec<f64> {
        let axis = |c: &cageless::RacewayContact| match of {
            0 => c.pressure_pa / MPA,
            of => c.semi_axes_m[of - 1] / 1e-3,
        };
        contacts.iter().map(axis).collect()
    };
    let scaled = |list: &[f64], unit: f64| list.iter().map(|v| v / unit).collect::<Vec<f64>>();
    let flank = |side: usize| space.flank_force_n.iter().map(|f| f[side]).collect();
    let lists: [(&str, Vec<f64>); 19] = [
        ("ball_angle_deg", scaled(&e.ball_angle_rad, DEGREE)),
        ("effective_radius_mm", scaled(&e.effective_radius_m, 1e-3)),
        ("inner_force_n", e.inner_force_n.clone()),
        ("outer_force_n", e.outer_force_n.clone()),
        ("inner_pressure_mpa", contacts(&e.inner_contact, 0)),
        ("outer_pressure_mpa", contacts(&e.outer_contact, 0)),
        ("inner_semi_axis_along_mm", contacts(&e.inner_contact, 1)),
        ("inner_semi_axis_across_mm", contacts(&e.inner_contact, 2)),
        ("outer_semi_axis_along_mm", contacts(&e.outer_contact, 1)),
        ("outer_semi_axis_across_mm", contacts(&e.outer_contact, 2)),
        (
            "ball_orbit_rpm",
            scaled(&advance.orbit_speed_rad_s, REVOLUTION_PER_MINUTE),
        ),
        (
            "ball_rotation_rpm",
            scaled(&advance.rotation_rad_s, REVOLUTION_PER_MINUTE),
        ),
        (
            "inner_contact_angle_deg",
            scaled(&space.inner_contact_angle_rad, DEGREE),
        ),
        (
            "outer_contact_angle_deg",
            scaled(&space.outer_contact_angle_rad, DEGREE),
        ),
        ("flank_plus_force_n", flank(0)),
        ("flank_minus_force_n", flank(1)),
        ("row_preload_um", scaled(&space.row_preload_m, MICROMETRE)),
        ("row_axial_force_n", space.row_axial_force_n.clone()),
        ("stiffness_matrix", matrix.concat()),
    ];
    for (name, expected) in &lists {
        let found = results.values(name);
        assert_eq!(found.len(), expected.len(), "{name}");
        for (a, b) in found.iter().zip(expected) {
            assert!((a - b).abs() <= 1e-12 * b.abs(), "{name}: {a} {b}");
        }
    }
    let rows = results.values("row");
    assert!(rows[..14].iter().all(|row| *row == 1.0) && rows[14..].iter().all(|row| *row == 2.0));
    // No list is left out.
    let known = |name: &str| name == "row" || lists.iter().any(|(list, _)| *list == name);
    for (quantity, cell) in results.iter() {
        assert!(
            !matches!(cell, Cell::Numbers(_)) || known(quantity.name),
            "{}",
            quantity.name
        );
    }
}

/// Limits of a user on results at rest: the least where more is better or the case says so, the most else.
#[test]
fn limits_on_a_static_equilibrium_are_judged() {
    let text = template(true)
        + "\n[[limit]]\nresult = \"l10_h\"\nvalue = 20000\nsource = \"works standard\"\n\
           [[limit]]\nresult = \"static_safety_factor\"\nvalue = 1.5\nsource = \"SKF\"\n\
           [[limit]]\nresult = \"ring_y_um\"\nvalue = -5\nside = \"at-least\"\nsource = \"seal\"\n\
           [[limit]]\nresult = \"outer_pressure_max_mpa\"\nvalue = 2000\nsource = \"us\"\n\
           [[limit]]\nresult = \"orbit_speed_rpm\"\nvalue = 1\nsource = \"of a run\"\n";
    let file = CaseFile::parse(&text, "case.toml", &[]).unwrap();
    let record = |file: &CaseFile| {
        let settled = settle(file.case()).unwrap();
        static_record(file.case(), &particulars(file), &settled)
    };
    let judged_of = |file: &CaseFile| record(file).limits();
    let record = record(&file);
    let judged = record.limits();
    let number = |name| record.results.number(name);
    assert!(number("l10_h") < 20_000.0 && number("ring_y_um") < -5.0);
    let [life, place] = judged.limits_exceeded.as_slice() else {
        panic!("{judged:?}");
    };
    assert!(
        life.contains(", at least 20000 h (works standard)"),
        "{life}"
    );
    assert!(place.contains(", at least −5 µm (seal)"), "{place}");
    let [safety, pressure] = judged.limits_kept.as_slice() else {
        panic!("{judged:?}");
    };
    assert!(safety.contains("at least 1.5 (SKF)"), "{safety}");
    assert!(pressure.contains("at most 2000 MPa (us)"), "{pressure}");
    assert!(judged.limits_not_judged.is_empty());

    // Without load there is no life.
    let sets = ["operation.radial_load_n=0".to_owned()];
    let file = CaseFile::parse(&text, "case.toml", &sets).unwrap();
    let judged = judged_of(&file);
    assert_eq!(judged.limits_not_judged.len(), 2, "{judged:?}");
}

/// A closer groove than the table of ISO 281 has keeps its rating, which a note says.
#[test]
fn a_note_says_that_closer_grooves_raise_no_rating() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/full-6008.toml");
    let of = |conformity: f64| {
        let sets = [format!("bearing.inner_conformity={conformity}")];
        let file = CaseFile::read(Path::new(path), &sets).unwrap();
        let settled = settle(file.case()).unwrap();
        let record = static_record(file.case(), &particulars(&file), &settled);
        let notes = record.sentences("notes").join("\n");
        let rating_n = record.results.number("basic_dynamic_rating_n");
        (rating_n, notes.contains("closer to the balls than 0.52 Dw"))
    };
    assert!(!of(0.52).1);
    assert_eq!(of(0.505), (of(0.52).0, true));
}

/// The static record of structure (d) with this film, and its notes on the film.
fn in_oil(sets: &[&str]) -> (Record, String) {
    let oil = [
        "film.viscosity_temperature_1_k=0.035",
        "film.supply=flooded",
    ];
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/zhao-d.toml");
    let sets = oil.iter().chain(sets).map(|set| (*set).to_owned());
    let file = CaseFile::read(Path::new(path), &sets.collect::<Vec<_>>()).unwrap();
    let settled = settle(file.case()).unwrap();
    let record = static_record(file.case(), &particulars(&file), &settled);
    let notes = record.sentences("notes").join("\n");
    (record, notes)
}

/// Every note names one pair of limits of queueing, and its words fit them; above d = 5 % the film outweighs a raceway
/// for dry balls.
#[test]
fn notes_on_queueing_do_not_contradict_each_other() {
    let limits = "balls queue from some 9.2 % on, never below 7.8 %";
    let outweighed = "above some 5 % it spaces them more than a raceway for dry balls";
    for (mpa_s, says, outweighs) in [
        ("5", "oil spaces the balls", false),
        ("34", "oil spaces the balls", true),
        ("40", "balls may queue", true),
        ("60", "balls will queue", false),
    ] {
        let (record, notes) = in_oil(&[&format!("film.viscosity_mpa_s={mpa_s}")]);
        assert!(
            notes.contains(says) && notes.contains(limits),
            "{mpa_s}: {notes}"
        );
        assert_eq!(notes.contains(outweighed), outweighs, "{mpa_s}: {notes}");
        assert!(
            notes.contains("try film.supply = 0.1\n") || notes.ends_with("try film.supply = 0.1")
        );
        // Both shares of one comparison in per cent.
        let (_, _, unit) = record.row("free_share").unwrap();
        assert_eq!(unit, "%");
    }
}

/// Without a load zone no gap opens; a ball that stops has none; where asperities carry the load there is no film.
#[test]
fn notes_on_a_film_without_load_or_speed() {
    let oil = "film.viscosity_mpa_s=5";
    let free = ["operation.radial_load_n=0", "operation.gravity_m_s2=0", oil];
    let (record, notes) = in_oil(&free);
    assert!(
        notes.contains("no ball touches the inner raceway"),
        "{notes}"
    );
    assert!(!notes.contains("queue"), "{notes}");
    assert_eq!(record.value("film_opening_gap_deg"), None);
    let thick = [
        "operation.inner_speed_rpm=3000",
        "film.viscosity_mpa_s=1000",
    ];
    let (record, notes) = in_oil(&thick);
    assert!(notes.contains("the film stops a free ball"), "{notes}");
    assert_eq!(record.value("film_lag_per_turn_deg"), None);
    assert_eq!(record.value("film_opening_gap_deg"), None);
    let (_, notes) = in_oil(&["operation.inner_speed_rpm=0.001", oil]);
    assert!(notes.contains("there is hardly a film: Λ is 6"), "{notes}");
    assert!(!notes.contains("queue"), "{notes}");
}

/// Beside SKF's model the friction of the motion is that of the case, with a film no dry one.
#[test]
fn the_note_on_skf_has_the_film() {
    let lubricated = [
        "film.viscosity_mpa_s=5",
        "lubrication.contamination_factor=0.5",
        "lubrication.skf_series=62",
    ];
    let (_, notes) = in_oil(&lubricated);
    let expected =
        "the friction of the motion is another: sliding and the rolling resistance of the film";
    assert!(notes.contains(expected), "{notes}");
}
