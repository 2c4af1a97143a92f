//! Requests to end: Ctrl-C, and the signals by which batch systems end a job or warn of its end.

use std::ops::Deref;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Set once the user has asked to stop.
pub type StopFlag = Arc<AtomicBool>;

/// Signals of which a second one ends the program at once.
#[cfg(unix)]
const IMPATIENT: [i32; 3] = {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    [SIGINT, SIGTERM, SIGHUP]
};

/// Warnings of batch systems, which may come again and again: `sbatch --signal`, `qsub -notify`, `bsub -wa`, and a
/// limit of processor time.
#[cfg(unix)]
const WARNINGS: [i32; 3] = {
    use signal_hook::consts::{SIGUSR1, SIGUSR2, SIGXCPU};
    [SIGUSR1, SIGUSR2, SIGXCPU]
};

/// Ends the work in good order once that is asked for, as long as it lives.
pub struct Interrupt {
    flag: StopFlag,
    told: AtomicBool,
    #[cfg(unix)]
    actions: Vec<signal_hook::SigId>,
}

impl Interrupt {
    /// Catches the requests. Where that is not possible they end the process as they always do.
    pub fn caught() -> Self {
        let flag = StopFlag::default();
        Self {
            #[cfg(unix)]
            actions: actions(&flag),
            told: AtomicBool::new({
                #[cfg(not(unix))]
                watch(&flag);
                false
            }),
            flag,
        }
    }

    /// Whether the work is to end.
    pub fn asked(&self) -> bool {
        self.flag.load(Ordering::Relaxed)
    }

    /// Whether nobody has asked this before.
    pub fn is_new(&self) -> bool {
        !self.told.swap(true, Ordering::Relaxed)
    }
}

impl Deref for Interrupt {
    type Target = StopFlag;

    fn deref(&self) -> &StopFlag {
        &self.flag
    }
}

/// Sets the flag, without a thread: there may be none to be had.
#[cfg(unix)]
fn actions(flag: &StopFlag) -> Vec<signal_hook::SigId> {
    use signal_hook::flag::{register, register_conditional_shutdown};
    let quit = |signal: &i32| register_conditional_shutdown(*signal, 1, Arc::clone(flag));
    let stop = |signal: &i32| register(*signal, Arc::clone(flag));
    // In this order: the first signal sets the flag that the second one finds.
    let quits = IMPATIENT.iter().map(quit);
    let stops = IMPATIENT.iter().chain(&WARNINGS).map(stop);
    quits.chain(stops).flatten().collect()
}

#[cfg(unix)]
impl Drop for Interrupt {
    fn drop(&mut self) {
        for action in self.actions.drain(..) {
            signal_hook::low_level::unregister(action);
        }
    }
}

/// Lets the events of the console set the flag.
#[cfg(not(unix))]
fn watch(flag: &StopFlag) {
    let seen = Arc::clone(flag);
    let _ = ctrlc::set_handler(move || {
        if seen.swap(true, Ordering::Relaxed) {
            std::process::exit(1);
        }
    });
}
