//! Progress, cancellation and errors of studies.

use std::num::NonZeroUsize;
use std::sync::Mutex;

use cageless::simulation::Control;
use cageless_io::case_file::{CaseFile, template};
use cageless_study::run::{Options, run};
use cageless_study::tolerance::{Request, tolerance};
use cageless_study::{Progress, Silent, StudyError, THREADS_MAX, Work, on_threads, search};

/// Adds up what it hears, and ends the work after so many calls.
#[derive(Default)]
struct Listener {
    begun: Mutex<Vec<(String, f64)>>,
    done: Mutex<f64>,
    calls: Mutex<usize>,
    enough: Option<usize>,
}

impl Progress for Listener {
    fn begin(&self, what: &str, units: f64) -> Box<dyn Work + '_> {
        self.begun.lock().unwrap().push((what.to_owned(), units));
        Box::new(Part(self))
    }

    fn interrupted(&self) -> bool {
        self.enough
            .is_some_and(|enough| *self.calls.lock().unwrap() >= enough)
    }
}

struct Part<'l>(&'l Listener);

impl Work for Part<'_> {
    fn add(&self, units: f64) -> Control {
        *self.0.done.lock().unwrap() += units;
        *self.0.calls.lock().unwrap() += 1;
        if self.interrupted() {
            Control::Break(())
        } else {
            Control::Continue(())
        }
    }

    fn interrupted(&self) -> bool {
        self.0.interrupted()
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
    ball_grade: 0,
    friction: 0.0,
    clearance_um: 0.0,
    speed_percent: 0.0,
    load_percent: 0.0,
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
    let begun = listener.begun.into_inner().unwrap();
    let [(what, units)] = begun.as_slice() else {
        panic!("{begun:?}");
    };
    let done = listener.done.into_inner().unwrap();
    assert_eq!(what, "verify");
    assert!((0.9..1.001).contains(&(done / units)), "{done} of {units}");
}

#[test]
fn what_is_told_to_end_has_no_result() {
    let file = case(&[]);
    let ended = || Listener {
        enough: Some(1),
        ..Listener::default()
    };
    let tolerance = tolerance(file.case(), "case", &REQUEST, &ended());
    assert!(matches!(tolerance, Err(StudyError::Interrupted)));
    let listener = ended();
    let search = search::run(&file, None, &listener);
    assert!(matches!(search, Err(StudyError::Interrupted)));
    // Nothing more was begun.
    assert_eq!(listener.begun.lock().unwrap().len(), 1);
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let file = case(&[]);
    let refused = |request: Request| match tolerance(file.case(), "case", &request, &Silent) {
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
