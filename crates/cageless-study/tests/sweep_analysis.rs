//! What is made of a finished sweep, against the same numbers worked out from its rows.

use std::collections::BTreeMap;

use cageless::simulation::Control;
use cageless_io::case_file::template;
use cageless_io::plan_file::PlanFile;
use cageless_io::results::Row;
use cageless_results::Aim;
use cageless_results::Cell;
use cageless_study::sweep::analysis::{Goal, Levels, SweepData, analyse};
use cageless_study::sweep::{Job, Sweep, run};

/// Rows and analysis of a plan.
fn analysed(plan: &str, goals: &[Goal]) -> (Sweep, Vec<Row>, SweepData) {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join("case.toml"), template(false)).expect("written");
    let text = format!("case = \"case.toml\"\n{plan}");
    let plan = PlanFile::parse(&text, "plan", dir.path()).expect("a plan");
    let sweep = Sweep::new(plan).expect("a sweep");
    let job = Job {
        result: dir.path().join("sweep.parquet"),
        shard: None,
        threads: None,
    };
    run(&sweep, &job, |_| Control::Continue(())).expect("computed");
    let data = analyse(&job.result, goals).expect("analysed");
    let rows = sweep.evaluate(0..sweep.variants(), &|| Control::Continue(()));
    (sweep, rows.expect("rows"), data)
}

fn goal(column: &str, aim: Aim) -> Goal {
    Goal {
        column: column.to_owned(),
        aim,
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Mean of the squared deviations from the mean.
fn variance(values: &[f64]) -> f64 {
    let middle = mean(values);
    mean(
        &values
            .iter()
            .map(|v| (v - middle).powi(2))
            .collect::<Vec<_>>(),
    )
}

fn close(found: f64, expected: f64, what: &str) {
    let error = (found - expected).abs();
    assert!(
        error <= 1e-9 * (1e-3 + expected.abs()),
        "{what}: {found} {expected}"
    );
}

const GRID: &str = "\
compute = [\"design\"]
[grid]
bearing.balls = [12, 13, 14]
raceway.axial_span_mm = [4.9, 5.1, 5.6, 7.9]
raceway.half_angle_deg = [20.0, 24.0]
";

#[test]
fn shares_effects_and_maps_are_those_of_the_rows() {
    let (sweep, rows, data) = analysed(GRID, &[]);
    let at = |name: &str| sweep.column(name).unwrap();
    let inputs = [
        "bearing_balls",
        "raceway_axial_span_mm",
        "raceway_half_angle_deg",
    ];
    let names: Vec<&str> = data.inputs.iter().map(|i| i.name.as_str()).collect();
    assert_eq!(names, inputs);
    let levels: [Vec<f64>; 3] = [
        vec![12.0, 13.0, 14.0],
        vec![4.9, 5.1, 5.6, 7.9],
        vec![20.0, 24.0],
    ];
    assert_eq!((data.variants, data.failed), (24, 6));
    let input = |row: &Row, k: usize| row[at(inputs[k])].number().unwrap();
    let mut told_apart = 0;
    for output in &data.outputs {
        let name = &output.quantity.name;
        let column = at(name);
        let value = |row: &&Row| row[column].number();
        let some: Vec<&Row> = rows.iter().filter(|row| value(row).is_some()).collect();
        let all: Vec<f64> = some.iter().filter_map(value).collect();
        assert_eq!(output.count as usize, all.len(), "{name}");
        close(output.mean, mean(&all), name);
        let group = |wanted: &dyn Fn(&Row) -> bool| -> Vec<f64> {
            some.iter()
                .filter(|row| wanted(row))
                .filter_map(value)
                .collect()
        };
        // η²: variance of the means of the levels, by their number of rows, over that of all.
        let shares = [0, 1, 2].map(|k| {
            let middle = mean(&all);
            let between: f64 = levels[k]
                .iter()
                .map(|level| group(&|row| input(row, k) == *level))
                .filter(|values| !values.is_empty())
                .map(|values| values.len() as f64 * (mean(&values) - middle).powi(2))
                .sum();
            between / (all.len() as f64 * variance(&all))
        });
        for (found, expected) in output.shares.iter().zip(shares) {
            assert!(
                (found.unwrap() - expected).abs() < 1e-6,
                "{name}: {:?} {shares:?}",
                output.shares
            );
        }
        told_apart += usize::from(shares.iter().filter(|s| **s > 0.02).count() > 1);
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| shares[*b].total_cmp(&shares[*a]));
        let drawn: Vec<&str> = order
            .into_iter()
            .filter(|k| shares[*k] >= 0.01)
            .map(|k| inputs[k])
            .collect();
        let effects: Vec<&str> = output
            .effects
            .iter()
            .map(|e| e.input.name.as_str())
            .collect();
        assert_eq!(effects, drawn, "{name}");
        for effect in &output.effects {
            let k = inputs.iter().position(|i| *i == effect.input.name).unwrap();
            assert_eq!(effect.levels, Levels::Numbers(levels[k].clone()));
            for (n, level) in levels[k].iter().enumerate() {
                let here = group(&|row| input(row, k) == *level);
                if here.is_empty() {
                    assert!(effect.mean[n].is_nan(), "{name}");
                    continue;
                }
                close(effect.mean[n], mean(&here), name);
                close(
                    effect.min[n],
                    here.iter().copied().fold(f64::MAX, f64::min),
                    name,
                );
                close(
                    effect.max[n],
                    here.iter().copied().fold(f64::MIN, f64::max),
                    name,
                );
            }
        }
        let map = output.map.as_ref().unwrap();
        let [x, y] =
            [&map.x_input, &map.y_input].map(|i| inputs.iter().position(|n| *n == i.name).unwrap());
        // Of inputs without any effect either may come first.
        for (found, expected) in [(x, order[0]), (y, order[1])] {
            assert!((shares[found] - shares[expected]).abs() < 1e-9, "{name}");
        }
        for (line, y_level) in map.mean.iter().zip(&levels[y]) {
            for (found, x_level) in line.iter().zip(&levels[x]) {
                let here = group(&|row| input(row, x) == *x_level && input(row, y) == *y_level);
                if here.is_empty() {
                    assert!(found.is_nan(), "{name}");
                } else {
                    close(*found, mean(&here), name);
                }
            }
        }
    }
    assert!(told_apart >= 1, "an output that depends on two inputs");
    let [failure] = data.failures.as_slice() else {
        panic!("{:?}", data.failures)
    };
    // The first of those with the span of 7.9 mm.
    assert_eq!((failure.count, failure.variant), (6, 6));
    assert_eq!(Cell::Text(failure.reason.clone()), rows[6][at("reason")]);
}

/// Effects that add up: y = 360°/N − ε depends on one input, and each share is the part of the
/// variance that its input makes.
#[test]
fn shares_of_a_sum_are_those_of_its_terms() {
    // 360°/N is one number for each N, and the groove radius leaves ε alone.
    let plan = "compute = [\"design\"]\n[grid]\nbearing.balls = [10, 14]\n\
                raceway.half_angle_deg = [20.0, 22.0, 26.0]\n";
    let (_, _, data) = analysed(plan, &[]);
    let output = |name: &str| {
        data.outputs
            .iter()
            .find(|o| o.quantity.name == name)
            .unwrap()
    };
    let gap = output("design_uniform_gap_deg");
    assert_eq!(gap.shares, [Some(1.0), Some(0.0)]);
    close(
        gap.effects[0].mean[0] - gap.effects[0].mean[1],
        36.0 - 360.0 / 14.0,
        "gap",
    );
    // β0 does not know the number of balls.
    assert_eq!(output("design_beta0_deg").shares, [Some(0.0), Some(1.0)]);
}

/// Shares of sampled inputs take many points: few give none, however many nodes of a grid they are at.
#[test]
fn points_that_are_drawn_are_no_levels() {
    let plan = |count: usize| {
        format!(
            "compute = [\"design\"]\n[grid]\nbearing.balls = [13, 14]\n[samples]\nmethod = \"sobol\"\n\
             count = {count}\nraceway.half_angle_deg = {{ from = 20.0, to = 26.0 }}\n\
             operation.inner_speed_rpm = {{ from = 9000, to = 12000 }}\n"
        )
    };
    let found = |count: usize| {
        let (_, _, data) = analysed(&plan(count), &[]);
        let mut outputs = data.outputs.iter();
        let beta0 = outputs.find(|o| o.quantity.name == "design_beta0_deg");
        let beta0 = beta0.unwrap();
        let strongest = beta0
            .strongest(&data.inputs)
            .map(|(input, _)| input.name.clone());
        (beta0.shares.clone(), strongest, data.warnings.clone())
    };
    let (shares, strongest, warnings) = found(64);
    // β0 of a raceway is that of its half angle, but for eight ranges of it.
    let [Some(balls), Some(angle), Some(speed)] = shares[..] else {
        panic!("{shares:?}")
    };
    assert!(
        balls < 1e-9 && speed == 0.0 && (0.95..0.999).contains(&angle),
        "{shares:?}"
    );
    assert_eq!(strongest.as_deref(), Some("raceway_half_angle_deg"));
    assert!(warnings.is_empty(), "{warnings:?}");
    let (shares, strongest, warnings) = found(12);
    assert_eq!((&shares[1..], strongest), (&[None, None][..], None));
    assert!(warnings[0].contains("it takes 16 or more"), "{warnings:?}");
}

#[test]
fn the_best_are_the_best_rows_at_each_condition() {
    let plan = "compute = [\"design\"]\n[grid]\noperation.radial_load_n = [500, 1500]\n\
                raceway.axial_span_mm = { from = 4.5, to = 5.9, count = 15 }\n";
    let column = "design_beta0_deg";
    let goals = [
        goal(column, Aim::High),
        goal("design_steady_gap_deg", Aim::Low),
    ];
    let (sweep, rows, data) = analysed(plan, &goals);
    let [high, low] = data.best.as_slice() else {
        panic!("{:?}", data.best)
    };
    assert!(high.high && !low.high);
    let load_at = (data.inputs.iter())
        .position(|i| i.name == "operation_radial_load_n")
        .unwrap();
    for (best, column) in [(high, column), (low, "design_steady_gap_deg")] {
        let column = sweep.column(column).unwrap();
        assert!(best.per_condition);
        let mut of_load: BTreeMap<String, Vec<(f64, u64)>> = BTreeMap::new();
        for (k, row) in rows.iter().enumerate() {
            let load = row[sweep.column("operation_radial_load_n").unwrap()]
                .number()
                .unwrap();
            let value = row[column].number().unwrap();
            of_load
                .entry(format!("{load}"))
                .or_default()
                .push((value, k as u64));
        }
        let mut expected = vec![];
        for (load, mut all) in of_load {
            all.sort_by(|a, b| {
                if best.high {
                    b.0.total_cmp(&a.0)
                } else {
                    a.0.total_cmp(&b.0)
                }
            });
            expected.extend(
                all.into_iter()
                    .take(3)
                    .map(|(value, k)| (load.clone(), value, k)),
            );
        }
        for (found, (load, value, variant)) in best.variants.iter().zip(&expected) {
            assert_eq!((found.variant, found.value), (*variant, *value));
            assert_eq!(&found.inputs[load_at], load);
        }
        assert_eq!(best.variants.len(), expected.len());
    }
    assert!(analyse(std::path::Path::new("nowhere"), &goals).is_err());
}

/// Stiffness has the unit of other pages, and the coupling that a symmetric bearing does not have but for
/// rounding is a constant zero.
#[test]
fn stiffness_has_its_unit_and_rounding_no_share() {
    let plan =
        "compute = [\"static\"]\n[grid]\noperation.radial_load_n = [500.0, 1000.0, 1700.0]\n";
    let (sweep, rows, data) = analysed(plan, &[]);
    let column = |name: &str| {
        let mut columns = sweep.columns().iter();
        columns.position(|c| c.name == name).expect("a column")
    };
    let stiffness = data.outputs.iter();
    let mut stiffness = stiffness.filter(|o| o.quantity.name == "static_stiffness_yy_n_m");
    let output = stiffness.next().expect("an output");
    assert_eq!(output.quantity.unit, "N/µm");
    let at = column("static_stiffness_yy_n_m");
    let values: Vec<f64> = rows.iter().filter_map(|row| row[at].number()).collect();
    close(output.mean, 1e-6 * mean(&values), "stiffness");
    let coupling = "static_stiffness_xy_n_m";
    assert!(!data.outputs.iter().any(|o| o.quantity.name == coupling));
    let constant = data.constants.iter().find(|c| c.name == coupling);
    assert_eq!(constant.map(|c| c.value.as_str()), Some("0"));
}

/// A run that stopped leaves its level, its cell and all shares of the output open; what did not run for want of a
/// possible case is left out.
#[test]
fn nothing_is_the_mean_of_the_runs_that_did_not_stop() {
    // Six balls in a bunch let the loaded ring fall.
    let plan = "compute = [\"design\", \"run\"]\n[set]\nstart.state = \"rolling\"\nstart.gaps = \"bunched\"\nsolver.method = \"verlet\"\n\
                solver.step_us = \"auto\"\nsolver.duration_s = 0.0095\n[grid]\nbearing.balls = [6, 14]\n\
                operation.radial_load_n = [1.0, 1500.0]\n";
    let (sweep, rows, data) = analysed(plan, &[]);
    let column = sweep.column("run_power_loss_w").unwrap();
    let values: Vec<Option<f64>> = rows.iter().map(|row| row[column].number()).collect();
    let [Some(light), None, Some(a), Some(b)] = values[..] else {
        panic!("{values:?}");
    };
    let output = |name: &str| {
        let mut outputs = data.outputs.iter();
        outputs.find(|o| o.quantity.name == name).unwrap()
    };
    let loss = output("run_power_loss_w");
    assert_eq!((loss.count, loss.missing), (3, 1));
    assert!(loss.mean.is_nan() && loss.shares == [None, None]);
    let balls = &loss.effects[0];
    assert_eq!(balls.input.name, "bearing_balls");
    for of_level in [&balls.mean, &balls.min, &balls.max] {
        assert!(of_level[0].is_nan(), "{of_level:?}");
    }
    close(balls.mean[1], mean(&[a, b]), "14 balls");
    let loads = &loss.effects[1];
    assert_eq!(loads.levels, Levels::Numbers(vec![1.0, 1500.0]));
    assert!(loads.mean[1].is_nan());
    close(loads.mean[0], mean(&[light, a]), "light");
    let map = loss.map.as_ref().unwrap();
    assert!(map.mean[1][0].is_nan());
    close(map.mean[0][0], light, "a cell");
    // What needs no run has all of its values.
    let gap = output("design_uniform_gap_deg");
    assert_eq!(gap.missing, 0);
    close(gap.shares[0].unwrap(), 1.0, "share");
    let [warning] = data.warnings.as_slice() else {
        panic!("{:?}", data.warnings);
    };
    let said = "1 of 4 variants lack results, as a computation failed, the most frequent reason: run: at t = ";
    assert!(warning.starts_with(said), "{warning}");
}
