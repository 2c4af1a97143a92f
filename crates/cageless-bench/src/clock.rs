//! Processor time, which other programs on the machine lengthen little.

use std::time::Instant;

/// Start of a measurement on the thread that makes it.
pub struct Clock {
    wall: Instant,
    processor_s: Option<f64>,
}

impl Clock {
    /// Starts.
    pub fn start() -> Self {
        Self {
            wall: Instant::now(),
            processor_s: processor_s(),
        }
    }

    /// Processor time of this thread since the start, s; where the system does not tell, the time
    /// on the wall.
    pub fn elapsed_s(&self) -> f64 {
        match (self.processor_s, processor_s()) {
            (Some(start), Some(now)) => now - start,
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

/// Processor time of this thread since its start, s.
#[cfg(unix)]
fn processor_s() -> Option<f64> {
    let mut time = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: the pointer is to a value that lives on.
    let code = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
    (code == 0).then_some(time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64)
}

#[cfg(not(unix))]
fn processor_s() -> Option<f64> {
    None
}
