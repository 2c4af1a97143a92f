//! Progress, cancellation and errors of studies.

use std::num::NonZeroUsize;
use std::sync::Mutex;

use cageless_io::case_file::{CaseFile, template};
use cageless_results::Record;
use cageless_study::comparison::{BenefitWord, in_steady_operation};
use cageless_study::design::{Asked, design};
use cageless_study::run::{Options, run};
use cageless_study::tolerance::{Request, tolerance};
use cageless_study::{Progress, Silent, StudyError, THREADS_MAX, Workload, on_threads, search};

/// Notes the tasks and what is done, and ends the work after so many calls.
#[derive(Default)]
struct Listener {
    workload: Mutex<Workload>,
    told: Mutex<Vec<(String, f64)>>,
    enough: Option<usize>,
    /// Fraction of the work after which it ends.
    until: Option<f64>,
    /// Task at whose begin it ends.
    last: Option<&'static str>,
}

impl Progress for Listener {
    fn interrupted(&self) -> bool {
        let told = self.told.lock().unwrap();
        let done = told.last().map_or(0.0, |(_, fraction)| *fraction);
        if told
            .last()
            .is_some_and(|(task, _)| Some(task.as_str()) == self.last)
        {
            return true;
        }
        self.enough.is_some_and(|enough| told.len() > enough)
            || self.until.is_some_and(|until| done > until)
    }

    fn workload(&self) -> Option<&Mutex<Workload>> {
        Some(&self.workload)
    }

    fn show(&self, task: &str, fraction: f64) {
        self.told.lock().unwrap().push((task.to_owned(), fraction));
    }
}

fn case(changes: &[&str]) -> CaseFile {
    let changes: Vec<String> = changes.iter().map(|c| (*c).to_owned()).collect();
    CaseFile::parse(&template(false), "template", &changes).unwrap()
}

const REQUEST: Request = Request {
    samples: 2,
    groove_depth_um: 2.0,
    axial_span_um: 0.0,
    half_angle_deg: 0.0,
    contact_angle_deg: 0.0,
    ball_grade: 0,
    friction: 0.0,
    clearance_um: 0.0,
    speed_percent: 0.0,
    load_percent: 0.0,
    viscosity_percent: 30.0,
    supply_factor: 2.0,
    benefit: false,
};

/// What was announced is what was done, but for what runs did after they last asked.
#[test]
fn progress_comes_to_its_end() {
    let file = case(&["solver.duration_s=0.02"]);
    let options = Options {
        rows: None,
        verify: true,
    };
    let mut record = run(&file, options, &Silent).unwrap();
    let listener = Listener::default();
    record.verify(&file, &listener);
    let summary = &record.summary;
    assert!(summary.verification.is_some(), "{:?}", summary.warnings);
    let told = listener.told.into_inner().unwrap();
    assert!(told.iter().all(|(task, _)| task == "verify"), "{told:?}");
    assert_eq!(told[0].1, 0.0);
    let last = told.last().unwrap().1;
    assert!((0.9..1.001).contains(&last), "{last}");
}

#[test]
fn what_is_told_to_end_has_no_result() {
    let file = case(&[]);
    let ended = || Listener {
        enough: Some(1),
        ..Listener::default()
    };
    let tolerance = tolerance(&file, "case", &REQUEST, &ended());
    assert!(matches!(tolerance, Err(StudyError::Interrupted)));
    let listener = ended();
    let search = search::run(&file, None, &[], &listener);
    assert!(matches!(search, Err(StudyError::Interrupted)));
    // Nothing more was begun.
    let told = listener.told.into_inner().unwrap();
    assert!(told.iter().all(|(task, _)| *task == told[0].0), "{told:?}");
}

/// A design that is ended after its verdict keeps it.
#[test]
fn a_design_keeps_the_verdict_that_was_reached() {
    let file = case(&["solver.method=verlet", "solver.step_us=auto"]);
    for (last, near) in [("recommendation", false), ("axial load", true)] {
        let listener = Listener {
            last: Some(last),
            ..Listener::default()
        };
        let asked = Asked {
            axial: true,
            ..Asked::default()
        };
        let designed = design(&file, asked, &listener).unwrap();
        assert!(designed.interrupted, "{last}");
        assert_eq!(designed.result.record.flag("passes"), Some(true));
        assert_eq!(designed.result.recommendation().is_some(), near, "{last}");
        assert_eq!(
            (designed.result.axial, designed.axial_unknown),
            (None, None)
        );
    }
    // Before the verdict there is nothing to be kept.
    let listener = Listener {
        last: Some("design"),
        ..Listener::default()
    };
    let designed = design(&file, Asked::default(), &listener);
    assert!(matches!(designed, Err(StudyError::Interrupted)));
}

/// What was judged until tolerances are ended is kept, and says that it is a part.
#[test]
fn tolerances_that_are_ended_keep_what_was_judged() {
    let file = case(&[]);
    let listener = Listener {
        until: Some(0.6),
        ..Listener::default()
    };
    let request = Request {
        samples: 6,
        ..REQUEST
    };
    let judged = |progress: &dyn Progress| tolerance(&file, "case", &request, progress);
    let part = on_threads(NonZeroUsize::new(1), || judged(&listener)).unwrap();
    let (part, whole) = (part.unwrap().record, judged(&Silent).unwrap().record);
    let count = |record: &Record| record.part("samples").unwrap().number("count") as usize;
    assert_eq!(count(&whole), 6);
    assert!((1..6).contains(&count(&part)), "{}", count(&part));
    assert_eq!(part.parts("influences"), whole.parts("influences"));
    // The nominal bearing and both ends of the depth come first.
    let said = format!("interrupted: these are {} of 9 bearings", 3 + count(&part));
    assert_eq!(part.sentences("warnings"), [said]);
    assert!(whole.sentences("warnings").is_empty());
    // What it has is no verdict.
    assert_eq!(part.flag("nominal_passes"), Some(true));
    assert_eq!(part.flag("passes"), None);
    let headline = part.text("headline");
    assert!(
        headline.starts_with("not judged: interrupted after "),
        "{headline}"
    );
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let file = case(&[]);
    let refused = |request: Request| match tolerance(&file, "case", &request, &Silent) {
        Err(StudyError::Option(error)) => error,
        other => panic!("{other:?}"),
    };
    let error = refused(Request {
        load_percent: 100.5,
        ..REQUEST
    });
    assert_eq!(
        (error.option, error.value.as_str()),
        ("load_percent", "100.5")
    );
    let error = refused(Request {
        axial_span_um: -1.0,
        ..REQUEST
    });
    assert_eq!(error.option, "axial_span_um");
    let many = NonZeroUsize::new(THREADS_MAX + 1);
    assert!(matches!(on_threads(many, || ()), Err(StudyError::Input(_))));
    let threads = NonZeroUsize::new(3);
    assert_eq!(on_threads(threads, rayon::current_num_threads).unwrap(), 3);
}

/// A ring of which a run stops is not judged and says when and why; the others are judged as without it.
#[test]
fn a_ring_that_stops_leaves_the_others() {
    let short = ["steady.transient_orbits=1", "steady.measured_orbits=3"];
    let plain = case(&short).with_conventional_ring().unwrap();
    let raceway = case(&short);
    let few = std::fs::read_to_string("../../cases/full-6205.toml").unwrap();
    let sets = [&short[..], &["bearing.balls=6"]].concat();
    let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
    let falls = CaseFile::parse(&few, "case", &sets).unwrap();
    let named = |name: &str, file: &CaseFile| (name.to_owned(), file.clone());
    let with = [
        named("plain", &plain),
        named("falls", &falls),
        named("raceway", &raceway),
    ];
    let without = [named("plain", &plain), named("raceway", &raceway)];
    let judged = |rings: &[(String, CaseFile)]| {
        let work = (&Silent as &dyn Progress).begin("benefit", 1.0);
        in_steady_operation(rings, 2, &work).unwrap().benefits
    };
    let (all, alone) = (judged(&with), judged(&without));
    assert_eq!(all[2], alone[1]);
    let stopped = all[1].as_ref().unwrap();
    assert_eq!(stopped.benefit, BenefitWord::NotJudged);
    assert_eq!(stopped.score, None);
    assert!(
        stopped.why.starts_with("falls, draw 1: "),
        "{}",
        stopped.why
    );
    assert!(
        stopped.why.contains("fell between the balls"),
        "{}",
        stopped.why
    );
    // Without the first there is nothing to compare with.
    let work = (&Silent as &dyn Progress).begin("benefit", 1.0);
    let error = in_steady_operation(&[with[1].clone(), with[0].clone()], 2, &work).unwrap_err();
    assert!(matches!(error, StudyError::Stopped { .. }), "{error}");
}
