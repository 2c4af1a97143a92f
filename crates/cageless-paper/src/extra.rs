//! Simulations that claims need beyond the figures.

use cageless_design::critical_gap::{CriticalGapError, PairTest, critical_gap_rad};
use cageless_design::{StartingPoint, starting_point};
use cageless_study::threads::both;
use cageless_study::{StudyError, Work};

use crate::cases::{self, READINGS, Reading};

/// Steps, about.
pub const WORK: f64 = 6.4e5;

/// Structures whose critical gap is measured at two speeds: (d) and (h).
const AT_SPEEDS: [usize; 2] = [3, 7];

/// Usable range of Eq. (11) and critical gaps at two speeds.
#[derive(Debug, Clone)]
pub struct Extra {
    /// Usable part of the curve of Eq. (11) under each reading.
    pub starting_points: [Option<StartingPoint>; 2],
    /// Critical gap of (d) and (h), `physical`, smooth, at 3000 and 12 000 rpm, degrees.
    pub at_speeds_deg: [[f64; 2]; 2],
}

/// Computes them.
pub fn compute(progress: &Work<'_>) -> Result<Extra, StudyError> {
    let usable = |reading: Reading| {
        let case = cases::structure(3, reading, &[])?;
        let found = match starting_point(&case, &mut |_| progress.control()) {
            Ok(found) => found,
            Err(CriticalGapError::Case(error)) => return Err(error.into()),
            Err(_) => None,
        };
        let _ = progress.add(WORK / 3.0);
        Ok::<_, StudyError>(found)
    };
    let at_speeds = |structure: usize| {
        let mut gaps_deg = [f64::NAN; 2];
        for (gap, rpm) in gaps_deg.iter_mut().zip(["3000.0", "12000.0"]) {
            let overrides = [format!("operation.inner_speed_rpm={rpm}")];
            let case = cases::structure(structure, READINGS[1], &overrides)?;
            let found = critical_gap_rad(&case, &PairTest::default(), &mut |_| progress.control());
            *gap = found?.to_degrees();
        }
        let _ = progress.add(WORK / 6.0);
        Ok::<_, StudyError>(gaps_deg)
    };
    let ((published, consistent), (d, h)) = both(
        || both(|| usable(READINGS[0]), || usable(READINGS[1])),
        || both(|| at_speeds(AT_SPEEDS[0]), || at_speeds(AT_SPEEDS[1])),
    );
    Ok(Extra {
        starting_points: [published?, consistent?],
        at_speeds_deg: [d?, h?],
    })
}
