//! The work that studies announce before they start, in steps, against the steps that they make.

use std::path::Path;
use std::sync::Mutex;

use cageless::simulation::{Control, steps_of_thread};
use cageless_design::{AxialPoint, axial_critical_gap_rad, axial_lag, axial_sample};
use cageless_io::arrangement::BearingArrangement;
use cageless_io::case_file::{CaseFile, template};
use cageless_io::plan_file::PlanFile;
use cageless_study::comparison::{Sampling, compare};
use cageless_study::design::{Asked, design};
use cageless_study::drop::{DropRequest, study};
use cageless_study::run::{Options, run};
use cageless_study::sweep::Sweep;
use cageless_study::tolerance::{Request, tolerance};
use cageless_study::{Expected, Progress, Workload};

/// Adds up what is announced.
#[derive(Default)]
struct Listener {
    workload: Mutex<Workload>,
    announced: Mutex<f64>,
}

impl Progress for Listener {
    fn interrupted(&self) -> bool {
        false
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn expects(&self, expected: Expected) {
        assert_eq!(expected.time_s, None, "nobody asked for it");
        *self.announced.lock().unwrap() += expected.steps;
    }
}

/// Steps that work announces, and those that it makes on threads of its own.
fn steps(work: impl FnOnce(&Listener) + Send) -> [f64; 2] {
    let pool = cageless_study::pool(std::num::NonZeroUsize::new(2)).unwrap();
    let listener = Listener::default();
    pool.install(|| work(&listener));
    let made: u64 = pool.broadcast(|_| steps_of_thread()).iter().sum();
    [listener.announced.into_inner().unwrap(), made as f64]
}

/// Refuses an announcement that is off by more than a factor.
fn close(what: &str, [announced, made]: [f64; 2], factor: f64) {
    let ratio = made / announced;
    assert!(
        ratio <= factor && ratio >= 1.0 / factor,
        "{what}: {made} steps, {announced} announced"
    );
}

fn case(changes: &[&str]) -> CaseFile {
    let quick = ["solver.method=verlet", "solver.step_us=auto"];
    let changes = quick.iter().chain(changes).map(|c| (*c).to_owned());
    CaseFile::parse(&template(false), "template", &changes.collect::<Vec<_>>()).unwrap()
}

/// Runs of a length that is known are counted to the step.
#[test]
fn runs_are_announced_as_they_are() {
    let file = case(&["solver.duration_s=0.004"]);
    let verified = steps(|progress| {
        let options = Options {
            rows: None,
            verify: true,
        };
        let mut record = run(&file, options, progress).unwrap();
        record.verify(&file, progress);
        assert!(record.summary.verification.is_some());
    });
    close("run --verify", verified, 1.001);
    let few = case(&[
        "solver.duration_s=0.004",
        "steady.transient_orbits=0.1",
        "steady.measured_orbits=0.3",
    ]);
    let conventional = few.with_conventional_ring().unwrap();
    let rings = [
        ("conventional".to_owned(), conventional),
        ("A".to_owned(), few),
    ];
    for sampling in [Sampling::Draws(9), Sampling::UnevenStarts(9)] {
        let compared = steps(|progress| {
            compare(&rings, sampling, progress).unwrap();
        });
        close("compare", compared, 1.001);
    }
    let drops = |path: &str, request: DropRequest| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../cases")
            .join(path);
        let set = ["solver.duration_s=0.002".to_owned()];
        let file = BearingArrangement::read(&path, &set).unwrap();
        let drop = request.check(&file, "drop").unwrap();
        let rows = drop.cases().iter().map(|_| None).collect();
        steps(|progress| {
            study(&file, drop, request, rows, progress).unwrap();
        })
    };
    let all = DropRequest {
        compare: true,
        samples: Some(11),
        verify: true,
        drops: None,
    };
    close("drop", drops("touchdown-d.toml", all), 1.01);
    let samples = DropRequest {
        samples: Some(3),
        ..DropRequest::default()
    };
    close(
        "drop of a rotor",
        drops("rotors/two-bearings.toml", samples),
        1.01,
    );
}

/// Verdicts take an estimated number of passages of a pair, and a search those that closed forms leave.
#[test]
fn studies_are_announced_within_a_factor_of_two() {
    let quick = "operation.inner_speed_rpm=24000";
    let heavy = "operation.radial_load_n=6000";
    let file = case(&[quick, heavy]);
    let request = Request {
        samples: 2,
        axial_span_um: 0.0,
        half_angle_deg: 0.0,
        ball_grade: 0,
        friction: 0.0,
        clearance_um: 0.0,
        speed_percent: 0.0,
        load_percent: 0.0,
        ..Request::default()
    };
    let judged = steps(|progress| {
        tolerance(&file, "case", &request, progress).unwrap();
    });
    close("tolerance", judged, 1.3);
    let designed = |changes: &[&str], search: bool| {
        let file = case(&[&[quick, heavy], changes].concat());
        let asked = Asked {
            search: search.then_some(&[]),
            ..Asked::default()
        };
        steps(|progress| {
            design(&file, asked, progress).unwrap();
        })
    };
    close("design", designed(&[], false), 2.0);
    let narrow = [
        "search.axial_span_mm=5.1",
        "search.half_angle_deg=[24,26]",
        "search.initial_states=1",
        "search.runs_max=32",
    ];
    close("design --search", designed(&narrow, true), 2.0);
    let elastic = [&narrow[2..], &["model.flanks=elastic"]].concat();
    close("design --search, elastic", designed(&elastic, true), 2.0);
    let plan = "case = \"case.toml\"\ncompute = [\"verdict\", \"run\"]\n[set]\nsolver.method = \"verlet\"\n\
                solver.step_us = \"auto\"\nsolver.duration_s = 0.002\n[grid]\noperation.inner_speed_rpm = \
                [20000, 30000]\n";
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("case.toml"), template(false)).unwrap();
    let sweep = Sweep::new(PlanFile::parse(plan, "plan", dir.path()).unwrap()).unwrap();
    let swept = steps(|_| {
        sweep.evaluate(0..2, &|| Control::Continue(())).unwrap();
    });
    close("sweep", [sweep.task(2).steps(), swept[1]], 1.3);
}

/// One point of `design --axial`.
#[test]
fn axial_loads_are_announced_within_a_factor_of_two() {
    let file = case(&["operation.inner_speed_rpm=24000"]);
    let point = AxialPoint::untilted(300.0);
    let (_, announced) = axial_sample(file.case(), point);
    let [_, made] = steps(|_| {
        let mut go_on = |_| Control::Continue(());
        axial_lag(file.case(), point, &mut go_on)
            .unwrap()
            .lag
            .unwrap();
        let _ = axial_critical_gap_rad(file.case(), point, &mut go_on);
    });
    close("design --axial", [announced.iter().sum(), made], 1.3);
}
