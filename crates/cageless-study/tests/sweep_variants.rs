//! What a plan says comes out, variant by variant.

use std::path::Path;

use cageless::simulation::Control;
use cageless_io::case_file::{CaseFile, template};
use cageless_io::plan_file::{PlanFile, difference};
use cageless_io::results::{Row, TableWriter};
use cageless_results::{Cell, equilibrium_record};
use cageless_study::sweep::Sweep;

fn plan(text: &str) -> PlanFile {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("case.toml"), template(false)).expect("written");
    let text = format!("case = \"case.toml\"\n{text}");
    PlanFile::parse(&text, "plan", folder.path()).expect("a plan")
}

/// A verdict needs constant operation; the row says so with the key and the unit of the file.
#[test]
fn a_table_over_time_is_refused_in_the_words_of_its_file() {
    let text = "compute = [\"verdict\"]\n[grid]\noperation.gravity_m_s2 = [9.81]\n\
                [set]\noperation.inner_speed_rpm = [[0, 6000], [0.05, 12000]]\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    let reason = format!("{:?}", column(&sweep, &rows, "reason"));
    assert!(reason.contains("operation.inner_speed_rpm"), "{reason}");
    assert!(!reason.contains("inner_speed_rad_s"), "{reason}");
}

fn rows(sweep: &Sweep) -> Vec<Row> {
    sweep
        .evaluate(0..sweep.variants(), &|| Control::Continue(()))
        .expect("rows")
}

fn column(sweep: &Sweep, rows: &[Row], name: &str) -> Vec<Cell> {
    let k = sweep.column(name).unwrap_or_else(|| panic!("no {name}"));
    rows.iter().map(|row| row[k].clone()).collect()
}

fn numbers(sweep: &Sweep, rows: &[Row], name: &str) -> Vec<f64> {
    let cells = column(sweep, rows, name);
    cells
        .iter()
        .map(|c| c.number().expect("a number"))
        .collect()
}

const ALL: &str = "\
seed = 9
compute = [\"design\"]
keep = [\"design_beta0_deg\"]
[grid]
operation.radial_load_n = [500, 1000]
bearing.balls = { from = 12, to = 14, count = 3 }
model.formulation = [\"physical\", \"paper\"]
[samples]
method = \"latin-hypercube\"
count = 4
contact.friction_coefficient = { from = 0.001, to = 0.1, scale = \"log\" }
solver.method = [\"abm4\", \"verlet\"]
[scatter]
repeats = 2
bearing.inner_ring_mass_kg = { uniform = 0.05 }
start.gaps = { normal = 0.2 }
";

#[test]
fn the_grid_is_a_product_whose_last_axis_varies_fastest() {
    let sweep = Sweep::new(plan(ALL)).expect("a sweep");
    assert_eq!(sweep.variants(), 3 * 2 * 2 * 4 * 2);
    let rows = rows(&sweep);
    let balls = numbers(&sweep, &rows, "bearing_balls");
    let loads = numbers(&sweep, &rows, "operation_radial_load_n");
    let formulations = column(&sweep, &rows, "model_formulation");
    let friction = numbers(&sweep, &rows, "contact_friction_coefficient");
    let mass = numbers(&sweep, &rows, "bearing_inner_ring_mass_kg");
    assert!(mass[0] != mass[1] && mass.iter().all(|m| (m - 0.2).abs() <= 0.05));
    for (k, row) in rows.iter().enumerate() {
        assert_eq!(row[0], Cell::Integer(k as i64));
        assert_eq!(row.len(), sweep.columns().len());
        // In the order of a case file: balls, load, formulation; then points, then repeats.
        assert_eq!(balls[k], [12.0, 13.0, 14.0][k / 32]);
        assert_eq!(loads[k], [500.0, 1000.0][k / 16 % 2]);
        assert_eq!(
            formulations[k],
            Cell::Text(["physical", "paper"][k / 8 % 2].to_owned())
        );
        // The same points and the same deviations at every node.
        assert_eq!(mass[k], mass[k % 8]);
        assert_eq!(friction[k], friction[k % 8 / 2 * 2]);
        assert!((0.001..=0.1).contains(&friction[k]));
    }
    // One point in each quarter of the logarithmic axis.
    let mut quarters: Vec<_> = (0..4)
        .map(|k| ((friction[2 * k].log10() + 3.0) * 2.0) as usize)
        .collect();
    quarters.sort_unstable();
    assert_eq!(quarters, [0, 1, 2, 3]);
}

#[test]
fn rows_do_not_depend_on_how_they_are_cut() {
    let sweep = Sweep::new(plan(ALL)).expect("a sweep");
    let whole = rows(&sweep);
    for k in [0, 5, 47, 95] {
        let one = sweep
            .evaluate(k..k + 1, &|| Control::Continue(()))
            .expect("a row");
        assert_eq!(one, whole[k as usize..=k as usize]);
    }
    let again = Sweep::new(plan(ALL)).expect("a sweep");
    assert_eq!(rows(&again), whole);
    let other = Sweep::new(plan(&ALL.replace("seed = 9", "seed = 10"))).expect("a sweep");
    assert_ne!(rows(&other), whole);
    assert_eq!(sweep.evaluate(0..96, &|| Control::Break(())), None);
}

#[test]
fn gaps_are_scattered_about_the_uniform_gap_and_fill_the_turn() {
    for (law, spread) in [
        ("{ normal = 0.2 }", 0.2),
        ("{ uniform = 0.2 }", 0.2 / 3f64.sqrt()),
    ] {
        let text =
            format!("compute = [\"design\"]\n[scatter]\nrepeats = 200\nstart.gaps = {law}\n");
        let sweep = Sweep::new(plan(&text)).expect("a sweep");
        let rows = rows(&sweep);
        let uniform = numbers(&sweep, &rows, "design_uniform_gap_deg")[0];
        let mut squares = 0.0;
        for cell in column(&sweep, &rows, "start_gaps_deg") {
            let Cell::Numbers(gaps) = cell else {
                panic!("a list");
            };
            assert_eq!(gaps.len(), 14);
            assert!((gaps.iter().sum::<f64>() - 14.0 * uniform).abs() < 1e-8);
            squares += gaps.iter().map(|g| (g - uniform).powi(2)).sum::<f64>();
        }
        // The mean taken off costs one degree of freedom.
        let found = (squares / (200.0 * 13.0)).sqrt();
        assert!((found / spread - 1.0).abs() < 0.06, "{law}: {found}");
    }
}

#[test]
fn any_arrangement_is_possible_and_gaps_are_exponential() {
    let text = "compute = [\"design\"]\n[scatter]\nrepeats = 400\nstart.gaps = \"random\"\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    let uniform = numbers(&sweep, &rows, "design_uniform_gap_deg")[0];
    assert!(
        column(&sweep, &rows, "reason")
            .iter()
            .all(|c| *c == Cell::Null)
    );
    let first: Vec<f64> = column(&sweep, &rows, "start_gaps_deg")
        .iter()
        .map(|cell| match cell {
            Cell::Numbers(gaps) => gaps[0] / uniform,
            _ => panic!("a list"),
        })
        .collect();
    // A spacing of 14 in all: P(gap > mean) = (1 − 1/14)^13.
    let wider = first.iter().filter(|g| **g > 1.0).count() as f64 / 400.0;
    assert!((wider - (13.0_f64 / 14.0).powi(13)).abs() < 0.1, "{wider}");
}

#[test]
fn a_failed_variant_is_a_row_with_its_reason() {
    let text = "compute = [\"static\"]\n[grid]\nraceway.half_angle_deg = [25.0, 95.0]\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    assert_eq!(column(&sweep, &rows, "reason")[0], Cell::Null);
    let Cell::Text(reason) = &column(&sweep, &rows, "reason")[1] else {
        panic!("a reason");
    };
    assert!(
        reason.starts_with("raceway.half_angle_deg = 95 is not possible"),
        "{reason}"
    );
    assert_eq!(column(&sweep, &rows, "static_ring_y_um")[1], Cell::Null);
    assert_eq!(
        numbers(&sweep, &rows, "raceway_half_angle_deg"),
        [25.0, 95.0]
    );
}

/// A row is what the command computes of its case: in the plane where nothing takes it out.
#[test]
fn statics_are_in_space_where_their_case_is() {
    let text = "compute = [\"static\"]\n[grid]\noperation.axial_load_n = [0.0, 200.0]\n\
                model.motion = [\"auto\", \"space\"]\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    let [z, safety] =
        ["static_ring_z_um", "static_static_safety_factor"].map(|name| column(&sweep, &rows, name));
    assert_eq!(z[0], Cell::Null);
    assert!(safety[0].number().is_some());
    let ring = numbers(&sweep, &rows, "static_ring_y_um");
    let axes = [(0, "auto"), (0, "space"), (200, "auto"), (200, "space")];
    for (k, (axial_n, motion)) in axes.into_iter().enumerate() {
        let changes = [
            format!("operation.axial_load_n={axial_n}"),
            format!("model.motion={motion}"),
        ];
        let file = CaseFile::parse(&template(false), "case.toml", &changes).unwrap();
        let record = equilibrium_record(file.case(), file.particulars()).unwrap();
        assert_eq!(ring[k], record.results.number("ring_y_um"), "{changes:?}");
    }
    assert!(ring[0] != ring[1] && ring[2] == ring[3], "{ring:?}");
}

/// Results of an oil film are columns where a plan has one, as `static` has them; a dry plan has none of them.
#[test]
fn films_are_in_the_columns_of_a_plan_with_oil() {
    let dry = "compute = [\"static\", \"run\"]\n[grid]\noperation.radial_load_n = [500, 1000]\n";
    let sweep = Sweep::new(plan(dry)).expect("a sweep");
    for name in [
        "static_rolling_resistance_torque_n_m",
        "run_half_turn_lag_deg",
    ] {
        assert_eq!(sweep.column(name), None);
    }
    let oil = "compute = [\"static\"]\n[set]\nfilm.viscosity_temperature_1_k = 0.035\nfilm.supply = \"flooded\"\n\
               film.viscosity_mpa_s = 5\n[grid]\nfilm.viscosity_mpa_s = [2, 20]\n";
    let sweep = Sweep::new(plan(oil)).expect("a sweep");
    let rows = rows(&sweep);
    for (k, mpa_s) in [2, 20].into_iter().enumerate() {
        let changes = [
            "film.viscosity_temperature_1_k=0.035".to_owned(),
            "film.supply=flooded".to_owned(),
            format!("film.viscosity_mpa_s={mpa_s}"),
        ];
        let file = CaseFile::parse(&template(false), "case.toml", &changes).unwrap();
        let record = equilibrium_record(file.case(), file.particulars()).unwrap();
        for name in [
            "rolling_resistance_torque_n_m",
            "film_speed_deficit_fraction",
            "film_parameter_min",
        ] {
            let found = numbers(&sweep, &rows, &format!("static_{name}"));
            assert_eq!(found[k], record.results.number(name), "{mpa_s}: {name}");
        }
    }
}

/// Tables over time are values like others, told apart by how they are written.
#[test]
fn an_axis_may_have_tables() {
    let text = "compute = [\"static\"]\nkeep = [\"static_ring_y_um\"]\n[grid]\n\
                operation.radial_load_n = [[[0.0, 100.0], [1.0, 200.0]], 150]\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    let written = ["[[0, 100], [1, 200]]", "150"].map(|text| Cell::Text(text.to_owned()));
    assert_eq!(column(&sweep, &rows, "operation_radial_load_n"), written);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("rows.parquet");
    let mut table = TableWriter::create(&path, sweep.columns(), &[]).expect("a table");
    rows.into_iter()
        .for_each(|row| table.push(row).expect("fits"));
}

#[test]
fn the_normal_form_is_the_same_plan() {
    let first = plan(ALL);
    let normal = first.normal().expect("text");
    let again = PlanFile::parse(&normal, "normal", Path::new("")).expect("a plan");
    assert_eq!(again.normal().expect("text"), normal);
    let rows_of = |plan| rows(&Sweep::new(plan).expect("a sweep"));
    assert_eq!(rows_of(again), rows_of(first));
    // Order and comments do not matter; a default written out is none.
    let moved = ALL
        .replace("operation.radial_load_n = [500, 1000]\n", "")
        .replace(
            "[samples]",
            "operation.radial_load_n = [500.0, 1e3] # N\n[samples]",
        );
    assert_eq!(plan(&moved).normal().expect("text"), normal);
    let changed = plan(&ALL.replace("count = 3", "count = 2"))
        .normal()
        .expect("text");
    let told = difference(&normal, &changed);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].starts_with("grid.bearing.balls was { from = 12.0, to = 14.0, count = 3"));
}

#[test]
fn one_raceway_of_several_can_vary() {
    let text = "compute = [\"design\"]\n[grid]\nraceway.2.half_angle_deg = [12.0, 14.0]\n";
    let folder = tempfile::tempdir().expect("a folder");
    let case = template(false).replace("[raceway]", "[[raceway]]").replace(
        "[operation]",
        "[[raceway]]\naxial_span_mm = 5.1\nhalf_angle_deg = 13.0\ncentre_angle_deg = 180.0\n[operation]",
    );
    std::fs::write(folder.path().join("case.toml"), case).expect("written");
    let text = format!("case = \"case.toml\"\n{text}");
    let plan = PlanFile::parse(&text, "plan", folder.path()).expect("a plan");
    let sweep = Sweep::new(plan).expect("a sweep");
    assert_eq!(
        sweep.file(1).expect("a case").cases()[0].value("raceway.2.half_angle_deg"),
        Some(14.0.into())
    );
    assert_eq!(
        sweep.file(1).expect("a case").cases()[0].value("raceway.1.half_angle_deg"),
        Some(25.2.into())
    );
    let again = PlanFile::parse(sweep.normal(), "normal", Path::new("")).expect("a plan");
    assert_eq!(again.normal().expect("text"), sweep.normal());
}

/// Some go side by side in the lanes of the vectors, some alone: two numbers of balls, two
/// methods, failures in between.
#[test]
fn runs_do_not_depend_on_what_they_are_computed_with() {
    let text = "compute = [\"run\"]\n[set]\nsolver.duration_s = 0.0005\n[grid]\n\
                bearing.balls = [13, 14]\nraceway.half_angle_deg = [22.0, 25.0, 95.0]\n\
                solver.method = [\"verlet\", \"abm4\"]\n[scatter]\nrepeats = 4\n\
                bearing.ball_radius_deviation_um = { normal = 0.5 }\nstart.gaps = \"random\"\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let whole = rows(&sweep);
    assert_eq!(whole.len(), 48);
    for cut in [1, 5, 16] {
        let starts = (0..48).step_by(cut);
        let pieces = starts.flat_map(|k| {
            let end = (k + cut as u64).min(48);
            sweep
                .evaluate(k..end, &|| Control::Continue(()))
                .expect("rows")
        });
        assert_eq!(pieces.collect::<Vec<_>>(), whole, "{cut}");
    }
    let failed = column(&sweep, &whole, "reason");
    assert_eq!(failed.iter().filter(|c| **c != Cell::Null).count(), 16);
    let steps = column(&sweep, &whole, "run_steps");
    assert!(
        steps
            .iter()
            .zip(&failed)
            .all(|(s, f)| (*s == Cell::Null) == (*f != Cell::Null))
    );
}

#[test]
fn every_ball_gets_a_radius_of_its_own() {
    let text = "compute = [\"static\"]\n[scatter]\nrepeats = 50\n\
                bearing.ball_radius_deviation_um = { uniform = 0.8 }\n";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    let mut all = Vec::new();
    for cell in column(&sweep, &rows, "bearing_ball_radius_deviation_um") {
        let Cell::Numbers(list) = cell else {
            panic!("a list");
        };
        assert_eq!(list.len(), 14);
        all.extend(list);
    }
    assert!(all.iter().all(|d| d.abs() <= 0.8));
    // The variance of a uniform distribution, to four standard errors.
    let variance = all.iter().map(|d| d * d).sum::<f64>() / all.len() as f64;
    assert!((variance / (0.64 / 3.0) - 1.0).abs() < 0.14, "{variance}");
    let ring = numbers(&sweep, &rows, "static_ring_y_um");
    assert!(ring.iter().any(|y| *y != ring[0]), "radii must matter");
}

/// Every sample and every repeat of it has deviations of its own, which are the same at all nodes of the grid; what a
/// sample varies is the same in all of its repeats.
#[test]
fn samples_and_repeats_have_deviations_of_their_own() {
    let (nodes, samples, repeats) = (2, 3, 4);
    let text = "\
compute = [\"design\"]
seed = 3
[grid]
operation.inner_speed_rpm = [6000, 12000]
[samples]
method = \"random\"
count = 3
contact.friction_coefficient = { from = 0.01, to = 0.1 }
[scatter]
repeats = 4
bearing.inner_ring_mass_kg = { uniform = 0.05 }
contact.regularisation_speed_m_s = { normal = 0.001 }
";
    let sweep = Sweep::new(plan(text)).expect("a sweep");
    let rows = rows(&sweep);
    assert_eq!(rows.len(), nodes * samples * repeats);
    let varied = numbers(&sweep, &rows, "contact_friction_coefficient");
    for (k, value) in varied.iter().enumerate() {
        assert_eq!(
            *value,
            varied[(k % (samples * repeats)) / repeats * repeats]
        );
    }
    let distinct = |values: &[f64]| {
        let mut values = values.to_vec();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values.len()
    };
    assert_eq!(distinct(&varied), samples);
    let mut both = vec![];
    for name in [
        "bearing_inner_ring_mass_kg",
        "contact_regularisation_speed_m_s",
    ] {
        let scattered = numbers(&sweep, &rows, name);
        let (one, other) = scattered.split_at(samples * repeats);
        assert_eq!(one, other, "{name}");
        assert_eq!(distinct(one), samples * repeats, "{name}: {one:?}");
        // In the order of their size, which two independent samples do not have in common.
        let mut order: Vec<usize> = (0..one.len()).collect();
        order.sort_by(|a, b| one[*a].total_cmp(&one[*b]));
        both.push(order);
    }
    assert_ne!(both[0], both[1]);
}

/// Each item of a list is drawn as often as any other: samples of a Latin hypercube fall into as many equal parts, and
/// a power of two of Sobol's sequence into two or four halves.
#[test]
fn every_item_of_a_list_is_drawn() {
    for (method, items, count) in [
        ("latin-hypercube", 3, 12),
        ("latin-hypercube", 5, 5),
        ("sobol", 2, 16),
        ("sobol", 4, 16),
        ("random", 3, 60),
    ] {
        let list: Vec<f64> = (1..=items).map(|k| 100.0 * f64::from(k as u8)).collect();
        let text = format!(
            "compute = [\"design\"]\nseed = 11\n[samples]\nmethod = \"{method}\"\n\
             count = {count}\noperation.radial_load_n = {list:?}\n"
        );
        let sweep = Sweep::new(plan(&text)).expect("a sweep");
        let drawn = numbers(&sweep, &rows(&sweep), "operation_radial_load_n");
        for item in list {
            let times = drawn.iter().filter(|value| **value == item).count();
            let share = count / items;
            match method {
                // Four standard deviations of a binomial distribution of 60 and 1/3.
                "random" => assert!(times.abs_diff(share) < 15, "{item}: {times}"),
                _ => assert_eq!(times, share, "{method}: {item}"),
            }
        }
    }
}
