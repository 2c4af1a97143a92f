//! Sweeps of rotors in several bearings.

use std::path::{Path, PathBuf};

use cageless::linear_rotor::{DMatrix, RotorMatrices};
use cageless::simulation::Control;
use cageless_io::arrangement::BearingArrangement;
use cageless_io::plan_file::{PlanFile, difference};
use cageless_io::results::Row;
use cageless_io::rotor_file::write_matrices;
use cageless_results::Cell;
use cageless_results::quantities;
use cageless_study::break_if;
use cageless_study::drop::{DropRequest, DropStudy};

use crate::drops::studied;
use cageless_study::sweep::{Job, Shard, Sweep, merge, run};

const ROTOR: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../cases/rotors/two-bearings.toml"
);

/// Changes after which the rotor touches both bearings at once.
const NEAR: [&str; 3] = [
    "solver.duration_s=0.0012",
    "rotor.y_um=-170.0",
    "rotor.vy_m_s=-0.06",
];

/// A plan of [`ROTOR`] with [`NEAR`] and `rest`.
fn text(rest: &str) -> String {
    let set = NEAR.map(|change| change.replace('=', " = ")).join("\n");
    format!("schema = 1\ncase = {ROTOR:?}\ncompute = [\"drop\"]\n[set]\n{set}\n{rest}")
}

fn plan(rest: &str) -> PlanFile {
    PlanFile::parse(&text(rest), "plan.toml", Path::new("")).unwrap_or_else(|e| panic!("{e}"))
}

fn sweep(rest: &str) -> Sweep {
    Sweep::new(plan(rest)).unwrap_or_else(|e| panic!("{e}"))
}

fn rows(sweep: &Sweep) -> Vec<Row> {
    let all = 0..sweep.variants();
    sweep.evaluate(all, &|| Control::Continue(())).unwrap()
}

/// The drop of `cageless drop ROTOR --set …`.
fn drop(changes: &[&str]) -> DropStudy {
    let set: Vec<String> = NEAR
        .iter()
        .chain(changes)
        .map(|c| (*c).to_owned())
        .collect();
    let file = BearingArrangement::read(Path::new(ROTOR), &set).unwrap();
    studied(&file, DropRequest::default())
}

/// Two speeds, and two air gaps of the second bearing.
const GRID: &str = "[grid]\nrotor.speed_rpm = [15000.0, 30000.0]\n\
                    bearing.2.rotor.radial_clearance_um = [180.0, 200.0]\n\
                    bearing.1.axial_mm = [-100.0]\nunbalance.1.amount_g_mm = [150.0]\n";

#[test]
fn a_row_has_the_results_of_the_drop_with_the_same_changes() {
    let sweep = sweep(GRID);
    let names: Vec<&str> = sweep.columns().iter().map(|c| &*c.name).collect();
    let reason = names.iter().position(|name| *name == "reason").unwrap();
    assert_eq!(
        names[1..reason],
        [
            "bearing_1_axial_mm",
            "unbalance_1_amount_g_mm",
            "rotor_speed_rpm",
            "bearing_2_rotor_radial_clearance_um",
        ]
    );
    let units: Vec<&str> = sweep.columns()[1..reason]
        .iter()
        .map(|c| &*c.unit)
        .collect();
    assert_eq!(units, ["mm", "g mm", "rpm", "um"]);
    let rows = rows(&sweep);
    assert_eq!(rows.len(), 4);
    let value = |row: usize, name: &str| &rows[row][sweep.column(name).unwrap()];
    // The last axis varies fastest.
    for (row, speed, gap) in [(0, "15000.0", "180.0"), (3, "30000.0", "200.0")] {
        assert_eq!(value(row, "reason"), &Cell::Null);
        let alone = drop(&[
            &format!("rotor.speed_rpm={speed}"),
            &format!("bearing.2.rotor.radial_clearance_um={gap}"),
            "unbalance.1.amount_g_mm=150.0",
        ]);
        let bearings = &alone.record.bearings;
        for (k, bearing) in bearings.iter().enumerate() {
            let results = bearing.result.results.iter();
            for (quantity, cell) in results.filter(|(q, _)| q.in_sweeps) {
                let column = quantity.column_name_in_bearing(k);
                assert_eq!(value(row, &column), cell, "{column}");
            }
        }
        let both = |name: &str| [0, 1].map(|k| bearings[k].result.results.number(name));
        let force = both("rotor_force_max_n");
        assert!(force[0] > 0.0 && force[1] > 0.0 && force[0] != force[1]);
        assert_eq!(
            value(row, "drop_rotor_force_max_n"),
            &Cell::Number(force[0].max(force[1]))
        );
        let impacts = both("impacts");
        assert_eq!(
            value(row, "drop_impacts"),
            &Cell::Integer((impacts[0] + impacts[1]) as i64)
        );
        assert_eq!(
            value(row, "drop_rotor_energy_residual_relative"),
            &Cell::Number(alone.record.rotor.energy_residual_relative)
        );
        // Neither ring has reached its speed.
        assert_eq!(value(row, "drop_spin_up_ms"), &Cell::Null);
    }
    assert!(value(0, "drop_dissipated_j") != value(2, "drop_dissipated_j"));
    assert!(
        value(0, "drop_bearing_2_impacts") != value(1, "drop_bearing_2_impacts")
            || value(0, "drop_bearing_2_dissipated_j") != value(1, "drop_bearing_2_dissipated_j")
    );
}

#[test]
fn every_result_of_a_drop_has_columns() {
    let sweep = sweep("[grid]\nrotor.speed_rpm = [15000.0]\n");
    let drops = quantities().filter(|q| q.in_sweeps && q.column_name().starts_with("drop_"));
    for quantity in drops {
        let name = quantity.column_name();
        let in_bearing = quantity.column_name_in_bearing(1);
        let of_rotor =
            ["rotor_energy_residual_relative", "plane_margin_min_um"].contains(&quantity.name);
        assert_eq!(
            sweep.column(&in_bearing).is_some(),
            !of_rotor,
            "{in_bearing}"
        );
        assert_eq!(
            sweep.column(&name).is_some(),
            quantity.across.is_some() || of_rotor,
            "{name}"
        );
    }
    let case = format!(
        "case = {:?}\ncompute = [\"drop\"]\n",
        ROTOR.replace("rotors/two-bearings", "touchdown-d")
    );
    let of_case = Sweep::new(PlanFile::parse(&case, "", Path::new("")).unwrap()).unwrap();
    assert!(
        of_case
            .column("drop_rotor_energy_residual_relative")
            .is_none()
    );
    assert!(of_case.column("drop_bearing_1_impacts").is_none());
}

/// Columns of a rotor in one bearing are those of a case, with those of the rotor; numbers are for several.
#[test]
fn an_only_bearing_has_the_columns_of_a_case() {
    let folder = tempfile::tempdir().unwrap();
    let case = ROTOR.replace("rotors/two-bearings", "touchdown-d");
    let rotor = folder.path().join("rotor.toml");
    let text = format!(
        "[rotor]\nmass_kg = 20.0\npolar_inertia_kg_m2 = 0.02\ntransverse_inertia_kg_m2 = 0.3\n\
         speed_rpm = 30000.0\n[[bearing]]\ncase = {case:?}\naxial_mm = 0.0\n"
    );
    std::fs::write(&rotor, text).unwrap();
    let names = |file: &str| -> Vec<String> {
        let plan = format!("case = {file:?}\ncompute = [\"drop\"]\n");
        let sweep = Sweep::new(PlanFile::parse(&plan, "", Path::new("")).unwrap()).unwrap();
        let columns = sweep.columns().iter().map(|c| c.name.to_string());
        columns.filter(|name| name.starts_with("drop_")).collect()
    };
    let of_case = names(&case);
    let mut of_rotor = names(rotor.to_str().unwrap());
    let own = [
        "drop_rotor_energy_residual_relative",
        "drop_plane_margin_min_um",
    ];
    for name in own {
        assert!(of_rotor.contains(&name.to_owned()), "{name}");
    }
    of_rotor.retain(|name| !own.contains(&name.as_str()));
    assert_eq!(of_rotor, of_case);
}

/// Rows in the table of a result.
fn job(result: PathBuf, shard: Option<Shard>) -> Job {
    let threads = std::num::NonZeroUsize::new(1);
    Job {
        result,
        shard,
        threads,
    }
}

#[test]
fn interrupted_and_sharded_sweeps_have_the_bytes_of_one_run() {
    let folder = tempfile::tempdir().unwrap();
    let text = GRID.replace("15000.0, 30000.0", "15000.0");
    let sweep = sweep(&format!(
        "{text}[scatter]\nrepeats = 2\nbearing.1.start.gaps = \"random\"\n"
    ));
    let path = |name: &str| folder.path().join(name).join("sweep.parquet");
    let done = run(&sweep, &job(path("calm"), None), |_| Control::Continue(())).unwrap();
    assert!(done.complete);
    let calm = std::fs::read(path("calm")).unwrap();

    let job_again = job(path("interrupted"), None);
    let stopped = run(&sweep, &job_again, |p| break_if(p.done > 0)).unwrap();
    assert!(!stopped.complete && stopped.progress.done > 0);
    // A changed rotor is another sweep.
    let other = plan(&text.replace("150.0", "151.0"));
    let refused = run(&Sweep::new(other).unwrap(), &job_again, |_| {
        Control::Continue(())
    });
    let message = refused.unwrap_err().to_string();
    assert!(
        message.contains("grid.unbalance.1.amount_g_mm was [150], is [151]"),
        "{message}"
    );
    let resumed = run(&sweep, &job_again, |_| Control::Continue(())).unwrap();
    assert!(resumed.complete && resumed.progress.done_now < 4);
    assert!(std::fs::read(path("interrupted")).unwrap() == calm);

    // A worker far away knows the text of the plan alone.
    let again = PlanFile::parse(sweep.normal(), "plan", Path::new("")).unwrap();
    let far = Sweep::new(again).unwrap();
    let shards: Vec<PathBuf> = (1..=2)
        .map(|number| {
            let path = path(&format!("shard-{number}"));
            run(&far, &job(path.clone(), Shard::new(number, 2)), |_| {
                Control::Continue(())
            })
            .unwrap();
            path
        })
        .collect();
    let merged = folder.path().join("merged.parquet");
    merge(&shards, &merged).unwrap();
    assert!(std::fs::read(merged).unwrap() == calm);
}

#[test]
fn the_normal_form_holds_the_rotor_its_matrices_and_its_cases() {
    let folder = tempfile::tempdir().unwrap();
    let diagonal = |values: [f64; 4]| {
        let all: Vec<f64> = values.iter().chain(&values).copied().collect();
        DMatrix::from_diagonal(&all.into())
    };
    let none = DMatrix::zeros(8, 8);
    let mut matrices = RotorMatrices {
        mass: diagonal([10.0, 10.0, 0.1, 0.1 / 3.0]),
        added_mass: none.clone(),
        housings: 0,
        damping: none.clone(),
        gyroscopic: none.clone(),
        stiffness: diagonal([1e6, 1e6, 1e4, 1e4]),
        spin_up: none,
        polar_inertia_kg_m2: 2e-3,
    };
    write_matrices(&folder.path().join("m.json"), &matrices).unwrap();
    let case = ROTOR.replace("rotors/two-bearings", "touchdown-d");
    let bearing = |node: usize| format!("[[bearing]]\ncase = {case:?}\nnode = {node}\n");
    let rotor = format!(
        "[rotor]\nmatrices = \"m.json\"\nspeed_rpm = 9000\n{}{}",
        bearing(0),
        bearing(1)
    );
    std::fs::write(folder.path().join("rotor.toml"), rotor).unwrap();
    let text = "case = \"rotor.toml\"\ncompute = [\"drop\"]\n[set]\nbearing.2.support.mass_kg = 0.75\n\
                [samples]\nmethod = \"random\"\ncount = 2\nrotor.speed_rpm = { from = 8000, to = 9000 }\n";
    let read = || {
        PlanFile::parse(text, "plan", folder.path())
            .unwrap()
            .normal()
            .unwrap()
    };
    let normal = read();
    for line in [
        "case.bearing.2.node = 1",
        "case.bearing.1.case.support.mass_kg = 0.5",
        "case.bearing.2.case.support.mass_kg = 0.75",
        "case.rotor.matrices.polar_inertia_kg_m2 = 0.002",
    ] {
        assert!(normal.lines().any(|l| l == line), "{line}\n{normal}");
    }
    // What the rotor replaces in its cases is not there.
    assert!(
        !normal.contains("case.bearing.1.case.rotor.mass_kg"),
        "{normal}"
    );
    let again = PlanFile::parse(&normal, "", Path::new("")).unwrap();
    assert_eq!(again.normal().unwrap(), normal);
    let of = |plan| {
        let file = Sweep::new(plan).unwrap().file(1).unwrap();
        let cases: Vec<_> = file.cases().iter().map(|c| c.case().clone()).collect();
        (cases, file.drop().cloned())
    };
    let here = PlanFile::parse(text, "plan", folder.path()).unwrap();
    assert_eq!(of(again), of(here));

    matrices.polar_inertia_kg_m2 = 3e-3;
    matrices.mass[(0, 0)] = 11.0;
    write_matrices(&folder.path().join("m.json"), &matrices).unwrap();
    let told = difference(&normal, &read());
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        told[0].starts_with("case.rotor.matrices.M was [[10.0, 0.0"),
        "{told:?}"
    );
    assert!(told.iter().all(|line| line.len() < 300), "{told:?}");
}

#[test]
fn deviations_are_about_the_value_of_each_bearing() {
    let refused = |rest: &str| {
        let plan = PlanFile::parse(&text(rest), "plan.toml", Path::new(""));
        let error = plan.map_or_else(
            |e| e.to_string(),
            |plan| Sweep::new(plan).err().unwrap().to_string(),
        );
        assert!(error.starts_with("plan.toml:"), "{error}");
        error
    };
    let scatter = "[scatter]\nrepeats = 2\nrotor.radial_clearance_um = { uniform = 5.0 }\n\
                   rotor.speed_rpm = { uniform = 100.0 }\nunbalance.amount_g_mm = { normal = 1.0 }\n";
    let found = sweep(scatter);
    let values = |index: u64, key: &str| {
        let value = found.file(index).unwrap().values(key);
        value
            .into_iter()
            .map(|v| v.unwrap().written())
            .collect::<Vec<_>>()
    };
    let gaps = values(0, "rotor.radial_clearance_um");
    assert!(
        gaps.len() == 2 && gaps[0] == gaps[1] && gaps[0] != "200.0",
        "{gaps:?}"
    );
    assert!(values(0, "rotor.speed_rpm") != values(1, "rotor.speed_rpm"));
    assert!(values(0, "unbalance.1.amount_g_mm") != ["200.0"]);
    let differs = "bearing.2.rotor.radial_clearance_um = 210.0\n";
    let message = refused(&format!("{differs}{scatter}"));
    assert!(
        message.contains("rotor.radial_clearance_um differs from bearing to bearing"),
        "{message}"
    );
    let own = scatter.replace("rotor.radial_clearance", "bearing.2.rotor.radial_clearance");
    sweep(&format!("{differs}{own}"));
    let twice = format!("{scatter}bearing.1.rotor.radial_clearance_um = {{ uniform = 5.0 }}\n");
    let message = refused(&twice);
    assert!(
        message.contains("is a part of rotor.radial_clearance_um on line"),
        "{message}"
    );
}
