//! What watches a run needs memory that does not depend on how long the run is.

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use cageless::collision::CollisionDetector;
use cageless::min_max_decimator::MinMaxDecimator;
use cageless::passage::{PassageRecorder, PassageTally};
use cageless::recorder::Recorder;
use cageless::simulation::{Control, Ending, run};
use cageless::summary::SummaryRecorder;
use cageless::verification::replicas;
use cageless::vibration::VibrationRecorder;
use cageless::{Case, Housing, IntegrationMethod};

/// Values in a stretch of the average of a spectrum, which is kept: 1.6 s at 5 kHz.
const STRETCH: usize = 8192;

/// Counts what is allocated now, and what was at most.
struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = NOW.fetch_add(layout.size(), Relaxed) + layout.size();
        MOST.fetch_max(now, Relaxed);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Most that was allocated at a time by a run under all observers, and how many passages
/// and samples of vibration it had.
fn peak_bytes(case: &Case) -> (usize, u64, u64) {
    let housing = Housing {
        mass_kg: 1.0,
        stiffness_n_m: 1e8,
        damping_n_s_m: 500.0,
    };
    let before = NOW.load(Relaxed);
    MOST.store(before, Relaxed);
    let mut rows = MinMaxDecimator::new(40);
    let mut tally = PassageTally::new();
    let mut vibration = VibrationRecorder::new(&housing, 1e5, 0.0);
    let mut watch = replicas(case, 0, 1)[0].observer();
    {
        let mut recorder = Recorder::new(1e-4, |snapshot| {
            rows.push(snapshot.to_row());
            Ok(())
        });
        let mut passages = PassageRecorder::new(|passage| {
            tally.add(&passage);
            Ok(())
        });
        let mut collisions = CollisionDetector::new(|_| Ok(()));
        let outcome = run(
            case,
            &mut [
                &mut recorder,
                &mut passages,
                &mut collisions,
                &mut SummaryRecorder::new(),
                &mut vibration,
                &mut watch,
            ],
            &mut |_| Control::Continue(()),
        )
        .unwrap();
        assert!(matches!(outcome.ending, Ending::Complete));
    }
    let samples = vibration.measurements()[1].samples();
    (MOST.load(Relaxed) - before, tally.count, samples)
}

#[test]
fn memory_does_not_grow_with_the_run() {
    let mut case = common::undamped(common::structure(5.1, 25.2));
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 2e-6;
    let mut peak = |seconds: f64| {
        case.solver.duration_s = seconds;
        peak_bytes(&case)
    };
    let (short, _, samples) = peak(0.24);
    assert!(samples as usize > STRETCH, "all buffers were full");
    let (long, passages, _) = peak(1.92);
    assert!(passages > 1800, "{passages}");
    assert!(
        long.abs_diff(short) < 2000,
        "{short} bytes for 0.24 s, {long} for 1.92 s"
    );
}
