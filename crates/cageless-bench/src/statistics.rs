//! Statistics of an ensemble of CB74 beyond the time that trajectories can be compared,
//! against those of the reference ensemble.

use std::time::Instant;

use anyhow::{Result, bail};
use cageless::Case;
use cageless::case::Start;
use cageless::contact_tracker::ContactTracker;
use cageless::dynamics::coordinates::BallCoordinate;
use cageless::simulation::{self, Control, Ending, Observer, ObserverError, RunContext, StepView};
use clap::Args;
use rayon::prelude::*;

use crate::problem;

/// Options of `statistics`.
#[derive(Debug, Args)]
pub struct Options {
    /// Method, as in a case file.
    #[arg(long, default_value = "abm4")]
    method: String,
    /// Step, µs.
    #[arg(long, default_value_t = 0.5)]
    step_us: f64,
    /// Members; member k starts turned by k times the turn.
    #[arg(long, default_value_t = 32)]
    members: usize,
    /// Turn of the start from one member to the next, rad.
    #[arg(long, default_value_t = TURN_RAD)]
    turn_rad: f64,
    /// Window that is averaged over, s; the published ensemble has 0.1 to 0.4.
    #[arg(long, num_args = 2, default_values_t = [0.1, 0.4])]
    window_s: Vec<f64>,
    /// Structure (d) of the paper in place of CB74.
    #[arg(long, requires = "against_step_us")]
    structure_d: bool,
    /// Compute each bearing for itself instead of several side by side.
    #[arg(long)]
    alone: bool,
    /// Further keys of the case, as `run --set` takes them.
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    set: Vec<String>,
    /// Members of the reference ensemble: not given, only the spread of one of them
    /// is. The given means carry this uncertainty.
    #[arg(long, default_value_t = 16)]
    reference_members: usize,
    /// Compare with an ensemble of this step, µs, and as many members, computed here with
    /// `--against-method`, instead of with the reference one.
    #[arg(long)]
    against_step_us: Option<f64>,
    /// Members of that ensemble; as many as of the first if not given.
    #[arg(long)]
    against_members: Option<usize>,
    /// Method of that ensemble.
    #[arg(long, default_value = "abm4")]
    against_method: String,
}

/// Steps between two samples of the ball speeds, which hardly change in between.
const BALLS_EVERY: u64 = 8;
/// Number of statistics.
pub const STATISTICS: usize = 6;
/// Their names, with units.
pub const NAMES: [&str; STATISTICS] = [
    "ring mean y, µm",
    "ring std y, µm",
    "ring std x, µm",
    "mean ball speed, m/s",
    "mean spin, rad/s",
    "onsets of contact",
];
/// Between one member of the reference ensemble and the next.
const TURN_RAD: f64 = 1.7e-11;
/// One statistic of the reference ensemble (RK4, 0.5 µs): mean, spread of one member.
#[derive(Debug, Clone, Copy)]
struct Published {
    name: &'static str,
    mean: f64,
    spread: f64,
    digits: usize,
}

const PUBLISHED: [Published; STATISTICS] = [
    published(NAMES[0], -22.5219, 0.0037, 4),
    published(NAMES[1], 0.135, 0.009, 4),
    published(NAMES[2], 0.165, 0.011, 4),
    published(NAMES[3], 11.3830, 0.000_07, 5),
    published(NAMES[4], 2420.66, 0.007, 4),
    published(NAMES[5], 82.0, 29.0, 1),
];

const fn published(name: &'static str, mean: f64, spread: f64, digits: usize) -> Published {
    Published {
        name,
        mean,
        spread,
        digits,
    }
}

/// Sums over the window, weighted with the step.
pub struct Sums {
    window_from_s: f64,
    contact_tracker: ContactTracker,
    time_s: f64,
    x: f64,
    y: f64,
    x2: f64,
    y2: f64,
    speed: f64,
    spin: f64,
    /// Time that the sums over the balls stand for, and that waits for the next look.
    balls_s: f64,
    balls_waiting_s: f64,
    steps: u64,
    contacts: u64,
    /// Shifts the squares to where they do not cancel.
    origin: [f64; 2],
}

impl Sums {
    /// Sums from `window_from_s` on.
    pub fn new(window_from_s: f64) -> Self {
        Self {
            window_from_s,
            contact_tracker: ContactTracker::new(0),
            time_s: 0.0,
            x: 0.0,
            y: 0.0,
            x2: 0.0,
            y2: 0.0,
            speed: 0.0,
            spin: 0.0,
            balls_s: 0.0,
            balls_waiting_s: 0.0,
            steps: 0,
            contacts: 0,
            origin: [0.0, -22.5e-6],
        }
    }

    /// The statistics in the order and the units of [`PUBLISHED`].
    pub fn statistics(&self) -> [f64; STATISTICS] {
        let mean = |sum: f64| sum / self.time_s;
        let deviation =
            |sum: f64, squares: f64| 1e6 * (mean(squares) - mean(sum).powi(2)).max(0.0).sqrt();
        [
            1e6 * (mean(self.y) + self.origin[1]),
            deviation(self.y, self.y2),
            deviation(self.x, self.x2),
            self.speed / self.balls_s,
            self.spin / self.balls_s,
            self.contacts as f64,
        ]
    }
}

impl Observer for Sums {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.contact_tracker = ContactTracker::new(context.model.balls());
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        let layout = view.layout();
        let n = layout.balls;
        let inside = view.step.t0_s >= self.window_from_s * (1.0 - 1e-12);
        self.contact_tracker.update(&view.contacts);
        if !inside {
            return Ok(Control::Continue(()));
        }
        self.contacts += u64::from(self.contact_tracker.count());
        let weight = view.step.size_s();
        let ring = layout.ring_motion(&view.step.y1);
        let (rx, ry) = (ring.x - self.origin[0], ring.y - self.origin[1]);
        self.time_s += weight;
        self.x += weight * rx;
        self.y += weight * ry;
        self.x2 += weight * rx * rx;
        self.y2 += weight * ry * ry;
        self.balls_waiting_s += weight;
        self.steps += 1;
        if self.steps.is_multiple_of(BALLS_EVERY) {
            let [vx, vy, spin] = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Spin]
                .map(|coordinate| view.after(coordinate));
            let speed: f64 = (0..n).map(|k| (vx[k] * vx[k] + vy[k] * vy[k]).sqrt()).sum();
            self.balls_s += self.balls_waiting_s;
            self.speed += self.balls_waiting_s * speed / n as f64;
            self.spin += self.balls_waiting_s * spin.iter().sum::<f64>() / n as f64;
            self.balls_waiting_s = 0.0;
        }
        Ok(Control::Continue(()))
    }
}

/// Statistics of every member, in the order of [`PUBLISHED`].
///
/// # Errors
/// The case is impossible, or a member did not get to the end.
fn ensemble(
    options: &Options,
    method: &str,
    step_us: f64,
    members: usize,
) -> Result<Vec<[f64; STATISTICS]>> {
    let mut overrides = vec![
        format!("solver.method={method}"),
        format!("solver.step_us={step_us:?}"),
        format!("solver.duration_s={:?}", options.window_s[1]),
    ];
    overrides.extend(options.set.iter().cloned());
    let case = if options.structure_d {
        problem::structure_d(&overrides)?
    } else {
        problem::cb74(&overrides)?
    };
    let cases: Vec<Case> = (0..members)
        .map(|member| {
            let mut case = case.clone();
            let (Start::Rolling {
                lead_ball_angle_rad,
                ..
            }
            | Start::Settled {
                lead_ball_angle_rad,
                ..
            }
            | Start::AtRest {
                lead_ball_angle_rad,
                ..
            }) = &mut case.start;
            *lead_ball_angle_rad += member as f64 * options.turn_rad;
            case
        })
        .collect();
    let batches = if options.alone {
        (0..cases.len()).map(|member| vec![member]).collect()
    } else {
        simulation::batches(&cases)
    };
    let statistics: Vec<Vec<[f64; STATISTICS]>> = batches
        .into_par_iter()
        .map(|batch| together(&cases, &batch, options.window_s[0]))
        .collect::<Result<_>>()?;
    Ok(statistics.concat())
}

/// Members of one batch, side by side.
fn together(cases: &[Case], batch: &[usize], from_s: f64) -> Result<Vec<[f64; STATISTICS]>> {
    let members: Vec<&Case> = batch.iter().map(|k| &cases[*k]).collect();
    let mut sums: Vec<Sums> = batch.iter().map(|_| Sums::new(from_s)).collect();
    let mut observers: Vec<Vec<&mut dyn Observer>> = sums
        .iter_mut()
        .map(|s| vec![s as &mut dyn Observer])
        .collect();
    let outcomes = simulation::run_batch(&members, &mut observers, &mut |_| Control::Continue(()));
    for (member, outcome) in batch.iter().zip(outcomes) {
        match outcome?.ending {
            Ending::Complete => {}
            Ending::Stopped(stop) => {
                bail!(
                    "member {member} stopped at {} s: {}",
                    stop.time_s,
                    stop.cause
                )
            }
            ending => bail!("member {member}: {ending:?}"),
        }
    }
    Ok(sums.iter().map(Sums::statistics).collect())
}

/// Mean over the members and standard deviation of one, of statistic `at`.
fn mean_and_spread(members: &[[f64; STATISTICS]], at: usize) -> (f64, f64) {
    let k = members.len() as f64;
    let mean = members.iter().map(|m| m[at]).sum::<f64>() / k;
    let squares: f64 = members.iter().map(|m| (m[at] - mean).powi(2)).sum();
    (mean, (squares / (k - 1.0)).sqrt())
}

/// Runs the ensemble and prints the comparison.
///
/// # Errors
/// Those of [`ensemble`], or fewer than two members.
pub fn run(options: &Options) -> Result<()> {
    if options.members < 2 || options.reference_members < 1 {
        bail!("--members must be 2 or more, --reference-members 1 or more: one has no spread");
    }
    let clock = Instant::now();
    let members = ensemble(options, &options.method, options.step_us, options.members)?;
    let wall_s = clock.elapsed().as_secs_f64();
    let mut reference = PUBLISHED;
    let mut reference_members = options.reference_members;
    let mut source = "published (RK4, 0.5 µs)".to_owned();
    if let Some(step_us) = options.against_step_us {
        let own = ensemble(
            options,
            &options.against_method,
            step_us,
            options.against_members.unwrap_or(options.members),
        )?;
        for (at, statistic) in reference.iter_mut().enumerate() {
            (statistic.mean, statistic.spread) = mean_and_spread(&own, at);
        }
        reference_members = own.len();
        source = format!("{}, {step_us} µs", options.against_method);
    }
    println!(
        "{}, {}, {} µs, {} members, {} to {} s; {wall_s:.1} s on {} threads",
        if options.structure_d {
            "structure (d)"
        } else {
            "CB74"
        },
        options.method,
        options.step_us,
        members.len(),
        options.window_s[0],
        options.window_s[1],
        rayon::current_num_threads()
    );
    let threads = rayon::current_num_threads() as f64;
    println!(
        "{:.4} s of a core per bearing and simulated second, {}",
        wall_s * threads / members.len() as f64 / options.window_s[1],
        if options.alone {
            "each for itself"
        } else {
            "side by side"
        }
    );
    println!("reference: {source}, {reference_members} members");
    println!(
        "{:<22} {:>12} {:>10} {:>10} {:>12} {:>10} {:>10}",
        "", "mean", "spread", "error", "reference", "spread", "deviation"
    );
    let mut worst = 0.0f64;
    for (at, r) in reference.iter().enumerate() {
        let (mean, spread) = mean_and_spread(&members, at);
        let error = spread / (members.len() as f64).sqrt();
        let combined = error.hypot(r.spread / (reference_members as f64).sqrt());
        let deviation = (mean - r.mean) / combined;
        worst = worst.max(deviation.abs());
        let (d, e) = (r.digits, r.digits + 1);
        println!(
            "{:<22} {mean:>12.d$} {spread:>10.e$} {error:>10.e$} {:>12.d$} {:>10.e$} {deviation:>+10.2}",
            r.name, r.mean, r.spread,
        );
    }
    println!(
        "spread: standard deviation of one member; error: of the mean; deviation: in combined"
    );
    println!("standard errors; largest {worst:.2}");
    Ok(())
}
