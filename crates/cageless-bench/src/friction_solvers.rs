//! Dry friction in other solvers: the loosest setting of each whose statistics are right, and
//! what it costs there.

use anyhow::{Result, bail};
use cageless::Case;
use cageless::case::Start;
use cageless::simulation::{self, Control, Ending};

use crate::clock::Clock;
use crate::equations::Implementation;
use crate::friction::{Options, case};
use crate::peers::cvode;
use crate::peers::others::{LEFT_OUT, others};
use crate::peers::peer::{Follow, Problem};
use crate::problem;
use crate::rk4::Rk4;
use crate::statistics::{NAMES, STATISTICS, Sums};

/// Step of the reference, µs: a fifth of what RK4 is stable at.
const REFERENCE_STEP_US: f64 = 0.05;
/// Angle from ball to ball, over which the starts of the members are spread, rad.
const PITCH_RAD: f64 = std::f64::consts::TAU / 14.0;

/// Statistics of one run.
type Statistics = [f64; STATISTICS];

/// Sums over the steps of a solver, weighted with the step.
struct StepSums {
    from_s: f64,
    last_s: f64,
    balls: usize,
    scales: Vec<f64>,
    pair_distance: f64,
    touching: Vec<bool>,
    time_s: f64,
    x: [f64; 2],
    y: [f64; 2],
    speed: f64,
    spin: f64,
    contacts: f64,
}

impl StepSums {
    fn new(case: &Case, from_s: f64) -> Self {
        let balls = case.bearing.balls();
        Self {
            from_s,
            last_s: 0.0,
            balls,
            scales: problem::scales(balls),
            pair_distance: 2.0 * case.bearing.ball_radius_m(),
            touching: vec![false; balls],
            time_s: 0.0,
            x: [0.0; 2],
            y: [0.0; 2],
            speed: 0.0,
            spin: 0.0,
            contacts: 0.0,
        }
    }

    fn add(&mut self, time_s: f64, z: &[f64]) {
        let n = self.balls;
        let value = |k: usize| z[k] * self.scales[k];
        let weight = time_s - self.last_s;
        let inside = self.last_s >= self.from_s;
        self.last_s = time_s;
        for k in 0..n {
            let next = (k + 1) % n;
            let (dx, dy) = (value(next) - value(k), value(n + next) - value(n + k));
            let touches = dx.hypot(dy) < self.pair_distance;
            if inside && touches && !self.touching[k] {
                self.contacts += 1.0;
            }
            self.touching[k] = touches;
        }
        if !inside {
            return;
        }
        let mean = |group: usize, f: &dyn Fn(usize) -> f64| {
            (group * n..(group + 1) * n).map(f).sum::<f64>() / n as f64
        };
        let speed = mean(2, &|k| value(k).hypot(value(k + n)));
        let spin = mean(4, &value);
        let (x, y) = (value(5 * n), value(5 * n + 1));
        self.time_s += weight;
        for (sum, v) in [(&mut self.x, x), (&mut self.y, y)] {
            sum[0] += weight * v;
            sum[1] += weight * v * v;
        }
        self.speed += weight * speed;
        self.spin += weight * spin;
    }

    fn statistics(&self) -> Statistics {
        let deviation = |[sum, squares]: [f64; 2]| {
            1e6 * (squares / self.time_s - (sum / self.time_s).powi(2))
                .max(0.0)
                .sqrt()
        };
        [
            1e6 * self.y[0] / self.time_s,
            deviation(self.y),
            deviation(self.x),
            self.speed / self.time_s,
            self.spin / self.time_s,
            self.contacts,
        ]
    }
}

/// The case with the balls turned for a member of the ensemble.
fn turned(case: &Case, member: usize, members: usize) -> Case {
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
    *lead_ball_angle_rad += PITCH_RAD * member as f64 / members as f64;
    case
}

/// The reference ensemble.
struct Reference {
    mean: Statistics,
    spread: Statistics,
}

impl Reference {
    fn new(members: &[Statistics]) -> Self {
        let k = members.len() as f64;
        let mean = std::array::from_fn(|at| members.iter().map(|m| m[at]).sum::<f64>() / k);
        let spread = std::array::from_fn(|at| {
            let squares: f64 = members.iter().map(|m| (m[at] - mean[at]).powi(2)).sum();
            (squares / (k - 1.0)).sqrt()
        });
        Self { mean, spread }
    }

    /// Largest deviation of a run from the mean, in spreads of one member; a run that has no
    /// statistics is infinitely far away.
    fn deviation(&self, statistics: &Statistics) -> f64 {
        (0..STATISTICS)
            .map(|at| (statistics[at] - self.mean[at]).abs() / self.spread[at].max(1e-12))
            .fold(0.0, |most, d| if d <= most { most } else { d })
    }
}

/// Statistics of a solver over the second half of the window; `None` where it gave up.
fn statistics(solver: &dyn Follow, case: &Case, setting: f64, window_s: f64) -> Option<Statistics> {
    let mut sums = StepSums::new(case, 0.5 * window_s);
    let mut add = |time_s: f64, z: &[f64]| sums.add(time_s, z);
    solver.follow(setting, window_s, &mut add).ok()?;
    let found = sums.statistics();
    found.iter().all(|v| v.is_finite()).then_some(found)
}

/// One solver at one setting.
struct Entry<'p> {
    solver: Box<dyn Follow + 'p>,
    setting: f64,
    deviation: f64,
    least_s: f64,
}

/// Prints the loosest setting of every solver whose statistics are right, with its time.
///
/// # Errors
/// The case is not what it was, or a run ended early.
pub fn compare(options: &Options) -> Result<()> {
    let window_s = options.window_ms * 1e-3;
    let duration = [format!("solver.duration_s={window_s:?}")];
    let own = case(options.compared, "symplectic", &duration)?;
    let driver = cvode::Driver::new();
    match &driver {
        Ok(driver) => println!("\nCVODE of SUNDIALS {}", driver.version()?),
        Err(error) => eprintln!("CVODE left out: {error}. Debian's package is libsundials-dev."),
    }
    if let Some(note) = LEFT_OUT {
        eprintln!("{note}");
    }
    let members = options.members;
    let mut reference = vec![];
    for member in 0..members {
        let problem = Problem::of(turned(&own, member, members))?;
        let rk4 = Rk4 {
            problem: &problem,
            equations: Implementation::Library,
        };
        match statistics(&rk4, &problem.case, REFERENCE_STEP_US, window_s) {
            Some(found) => reference.push(found),
            None => bail!("member {member} of the reference did not get to the end"),
        }
    }
    let reference = Reference::new(&reference);
    println!(
        "mu = {}: statistics over {:.0} to {:.0} ms, RK4 at {REFERENCE_STEP_US} µs, {members} members",
        options.compared,
        0.5 * options.window_ms,
        options.window_ms
    );
    for (at, name) in NAMES.iter().enumerate() {
        println!(
            "{name:<22} {:>14.6} ± {:.6} of one member",
            reference.mean[at], reference.spread[at]
        );
    }
    let problem = Problem::of(own.clone())?;
    let mut entries = vec![];
    for equations in Implementation::ALL {
        let rk4: Box<dyn Follow> = Box::new(Rk4 {
            problem: &problem,
            equations,
        });
        let others = others(&problem, driver.as_ref().ok(), equations);
        for solver in std::iter::once(rk4).chain(others) {
            let found = solver.settings().into_iter().find_map(|setting| {
                let found = statistics(solver.as_ref(), &own, setting, window_s)?;
                let deviation = reference.deviation(&found);
                (deviation <= options.spreads).then_some((setting, deviation))
            });
            match found {
                Some((setting, deviation)) => entries.push(Entry {
                    solver,
                    setting,
                    deviation,
                    least_s: f64::INFINITY,
                }),
                None => println!("{} has no setting with these statistics", solver.name()),
            }
        }
    }
    let (mut own_least_s, mut own_deviation) = (f64::INFINITY, 0.0);
    for _ in 0..options.repetitions {
        let mut sums = Sums::new(0.5 * window_s);
        match simulation::run(&own, &mut [&mut sums], &mut |_| Control::Continue(()))?.ending {
            Ending::Complete => own_deviation = reference.deviation(&sums.statistics()),
            ending => bail!("the run ended early: {ending:?}"),
        }
        let clock = Clock::start();
        simulation::run(&own, &mut [], &mut |_| Control::Continue(()))?;
        own_least_s = own_least_s.min(clock.elapsed_s());
        for entry in &mut entries {
            let clock = Clock::start();
            entry.solver.integrate(entry.setting, window_s)?;
            entry.least_s = entry.least_s.min(clock.elapsed_s());
        }
    }
    println!(
        "\nLoosest setting with every statistic of one run within {} spreads; least processor time of {}",
        options.spreads, options.repetitions
    );
    println!(
        "{:<32} {:>10} {:>9} {:>10} {:>9} {:>7}",
        "", "", "setting", "deviation", "s/s", "ratio"
    );
    println!(
        "{:<32} {:>10} {:>9} {own_deviation:>10.2} {:>9.3} {:>7.1}",
        "Cageless, production",
        "step, µs",
        own.solver.step_s * 1e6,
        own_least_s / window_s,
        1.0
    );
    for entry in &entries {
        println!(
            "{:<32} {:>10} {:>9.0e} {:>10.2} {:>9.3} {:>7.1}",
            format!("{}, {}", entry.solver.name(), entry.solver.equations()),
            entry.solver.setting_name(),
            entry.setting,
            entry.deviation,
            entry.least_s / window_s,
            entry.least_s / own_least_s
        );
    }
    Ok(())
}
