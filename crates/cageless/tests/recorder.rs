//! Output rows.

use cageless::recorder::Recorder;
use cageless::simulation::{Control, run};

/// A row per output time, and one at the end if that is none.
#[test]
fn the_last_row_is_at_the_end() {
    for (duration_s, rows) in [(1e-3, 11), (1.05e-3, 12), (0.04e-3, 2)] {
        let mut case = crate::common::conventional(crate::common::dimensions());
        case.solver.duration_s = duration_s;
        let mut times = vec![];
        {
            let mut recorder = Recorder::new(1e-4, |snapshot| {
                times.push(snapshot.time_s);
                Ok(())
            });
            run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
        }
        assert_eq!(times.len(), rows, "{times:?}");
        assert_eq!(times[0], 0.0);
        assert!((times[rows - 1] - duration_s).abs() < 1e-12, "{times:?}");
    }
}
