//! Instructions and time per evaluation of the right-hand side, for each instruction set
//! and for the textbook.

use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, bail};
use cageless::dynamics::layout::Layout;
use cageless::dynamics::state::State;
use cageless::dynamics::{InstructionSet, Model, RightHandSide};
use cageless::integrator::System;
use cageless::simulation::{self, Control, Ending, Observer, ObserverError, RunContext, StepView};
use clap::{Args, ValueEnum};

use crate::problem;
use crate::textbook::Textbook;

/// Options of `instructions`.
#[derive(Debug, Args)]
pub struct Options {
    /// Repetitions of each timing; all variants take turns in each.
    #[arg(long, default_value_t = 15)]
    repetitions: usize,
    /// Evaluations per timing.
    #[arg(long, default_value_t = 100_000)]
    evaluations: u64,
}

/// Options of `evaluate`.
#[derive(Debug, Args)]
pub struct EvaluateOptions {
    /// Which right-hand side.
    #[arg(long)]
    variant: Variant,
    /// Number of occurrences.
    #[arg(long)]
    count: u64,
}

/// What is counted and timed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Variant {
    Baseline,
    Avx2,
    Avx512,
    Textbook,
}

impl Variant {
    const ALL: [Self; 4] = [Self::Baseline, Self::Avx2, Self::Avx512, Self::Textbook];

    fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
            Self::Textbook => "textbook",
        }
    }

    fn instruction_set(self) -> InstructionSet {
        match self {
            Self::Baseline | Self::Textbook => InstructionSet::Baseline,
            Self::Avx2 => InstructionSet::Avx2,
            Self::Avx512 => InstructionSet::Avx512,
        }
    }

    fn available(self) -> bool {
        self.instruction_set() as u8 <= InstructionSet::detect() as u8
    }

    /// Calls `work` with its right-hand side, which writes into a vector of its own
    /// order and length.
    fn with<T>(self, work: impl FnOnce(&mut dyn FnMut(&Sample, &mut [f64])) -> T) -> Result<T> {
        let case = problem::cb74(&[])?;
        let model = Model::new(&case)?;
        if self == Self::Textbook {
            let textbook = Textbook::new(&case);
            return Ok(work(&mut |sample, rate| {
                textbook.derivative(&sample.plain, &mut rate[..sample.plain.len()]);
            }));
        }
        let mut rhs = RightHandSide::with_instruction_set(&model, self.instruction_set());
        if rhs.instruction_set() != self.instruction_set() {
            bail!("this processor has no {}", self.name());
        }
        Ok(work(&mut |sample, rate| {
            rhs.derivative(0.0, sample.state.values(), rate);
        }))
    }

    /// The rates without padding and ledger.
    fn plain(self, layout: Layout, rate: Vec<f64>) -> Vec<f64> {
        if self == Self::Textbook {
            return rate[..5 * layout.balls + 4].to_vec();
        }
        plain(&State::from_vector(layout, &rate))
    }
}

/// A state as both implementations take it.
struct Sample {
    state: State,
    /// In the order of [`Textbook::derivative`].
    plain: Vec<f64>,
}

fn plain(state: &State) -> Vec<f64> {
    let ring = state.ring_motion();
    [
        state.x_m(),
        state.y_m(),
        state.vx_m_s(),
        state.vy_m_s(),
        state.spin_state_rad_s(),
        &[ring.x, ring.y, ring.vx, ring.vy],
    ]
    .concat()
}

/// Collects states at regular times.
struct Collector {
    interval_s: f64,
    states: Vec<State>,
}

impl Observer for Collector {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.states.push(context.start.clone());
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        while self.states.len() as f64 * self.interval_s <= view.step.t1_s {
            self.states
                .push(view.state(self.states.len() as f64 * self.interval_s));
        }
        Ok(Control::Continue(()))
    }
}

/// `count` states of CB74, `interval_s` apart.
///
/// # Errors
/// The run did not get so far.
pub fn states_on_the_way(count: usize, interval_s: f64) -> Result<Vec<State>> {
    let mut case = problem::cb74(&["solver.step_us=0.5".into()])?;
    case.solver.duration_s = count as f64 * interval_s;
    let mut collector = Collector {
        interval_s,
        states: vec![],
    };
    let outcome = simulation::run(&case, &mut [&mut collector], &mut |_| Control::Continue(()))?;
    if !matches!(outcome.ending, Ending::Complete) {
        bail!("the run ended early: {:?}", outcome.ending);
    }
    collector.states.truncate(count);
    Ok(collector.states)
}

/// States that are evaluated in turn: 20 over the first 2 ms.
fn samples() -> Result<Vec<Sample>> {
    Ok(states_on_the_way(20, 1e-4)?
        .into_iter()
        .map(|state| Sample {
            plain: plain(&state),
            state,
        })
        .collect())
}

fn cycle(rhs: &mut dyn FnMut(&Sample, &mut [f64]), samples: &[Sample], count: u64) {
    let mut rate = vec![0.0; samples[0].state.layout().len()];
    for (_, sample) in (0..count).zip(samples.iter().cycle()) {
        rhs(black_box(sample), black_box(&mut rate));
    }
}

/// The hidden command that a counter of instructions runs.
///
/// # Errors
/// The processor, or what it is emulated by, has not the instructions.
pub fn evaluate(options: &EvaluateOptions) -> Result<()> {
    let samples = samples()?;
    options
        .variant
        .with(|rhs| cycle(rhs, &samples, options.count))
}

/// Measures and prints.
///
/// # Errors
/// The case is not what it was.
pub fn run(options: &Options) -> Result<()> {
    let samples = samples()?;
    let variants: Vec<Variant> = Variant::ALL.into_iter().filter(|v| v.available()).collect();
    let mut times = vec![vec![]; variants.len()];
    for _ in 0..options.repetitions {
        for (variant, times) in variants.iter().zip(&mut times) {
            let s = variant.with(|rhs| {
                cycle(rhs, &samples, 1000);
                let clock = Instant::now();
                cycle(rhs, &samples, options.evaluations);
                clock.elapsed().as_secs_f64()
            })?;
            times.push(s / options.evaluations as f64);
        }
    }
    let differences = differences(&variants, &samples)?;
    println!(
        "Right-hand side of CB74, per evaluation, over {} states of the first 2 ms",
        samples.len()
    );
    println!(
        "{:<10} {:>10} {:>10} {:>9} {:>14} {:>14} {:>16}",
        "", "min ns", "median ns", "ratio", "instr. (perf)", "instr. (cg)", "max difference"
    );
    let medians: Vec<f64> = times.iter_mut().map(|t| median(t)).collect();
    let mut reasons: Vec<String> = vec![];
    for (k, variant) in variants.iter().enumerate() {
        let counts =
            [perf as Counter, callgrind].map(|counter| match per_evaluation(counter, *variant) {
                Ok(count) => format!("{count:.0}"),
                Err(error) => {
                    let reason = format!("{error:#}");
                    if !reasons.contains(&reason) {
                        reasons.push(reason);
                    }
                    "-".to_owned()
                }
            });
        println!(
            "{:<10} {:>10.1} {:>10.1} {:>9.2} {:>14} {:>14} {:>16.1e}",
            variant.name(),
            1e9 * times[k].iter().copied().fold(f64::INFINITY, f64::min),
            1e9 * medians[k],
            medians[0] / medians[k],
            counts[0],
            counts[1],
            differences[k],
        );
    }
    for reason in &reasons {
        println!("not counted: {reason}");
    }
    println!("ratio: time of baseline over time; difference: against baseline, over the largest");
    println!("rate of the same quantity; textbook: the scalar implementation");
    Ok(())
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Largest difference against baseline, each over the largest rate of its quantity.
fn differences(variants: &[Variant], samples: &[Sample]) -> Result<Vec<f64>> {
    let rates = |variant: Variant| {
        variant.with(|rhs| {
            samples
                .iter()
                .map(|sample| {
                    let layout = sample.state.layout();
                    let mut rate = vec![0.0; layout.len()];
                    rhs(sample, &mut rate);
                    variant.plain(layout, rate)
                })
                .collect::<Vec<_>>()
        })
    };
    let base = rates(Variant::Baseline)?;
    let scales = largest(&base);
    variants
        .iter()
        .map(|&variant| {
            let own = rates(variant)?;
            let pairs = own.iter().flatten().zip(base.iter().flatten());
            Ok(pairs
                .zip(scales.iter().cycle())
                .filter(|((a, b), _)| a != b)
                .map(|((a, b), scale)| (a - b).abs() / scale)
                .fold(0.0, f64::max))
        })
        .collect()
}

/// For every state, the largest rate of its quantity over all balls and samples.
fn largest(rates: &[Vec<f64>]) -> Vec<f64> {
    let length = rates[0].len();
    let balls = (length - 4) / 5;
    // Group of each state: five of the balls, position and velocity of the ring.
    let group = |k: usize| (k / balls).min(5) + usize::from(k >= 5 * balls + 2);
    let mut most = [0.0f64; 7];
    for rate in rates {
        for (k, value) in rate.iter().enumerate() {
            most[group(k)] = most[group(k)].max(value.abs());
        }
    }
    (0..length).map(|k| most[group(k)]).collect()
}

/// Instructions of `evaluate` with so many evaluations.
type Counter = fn(Variant, u64) -> Result<u64>;

/// Instructions of two runs of this program that differ in the number of evaluations
/// only, divided.
fn per_evaluation(counter: Counter, variant: Variant) -> Result<f64> {
    const FEW: u64 = 1_000;
    const MANY: u64 = 21_000;
    let (few, many) = (counter(variant, FEW)?, counter(variant, MANY)?);
    Ok((many as f64 - few as f64) / (MANY - FEW) as f64)
}

/// Runs this program's `evaluate` under `tool`; what the tool wrote to stderr.
fn under(tool: &str, arguments: &[&str], variant: Variant, count: u64) -> Result<String> {
    let output = Command::new(tool)
        .args(arguments)
        .arg(std::env::current_exe()?)
        .args(["evaluate", "--variant", variant.name()])
        .args(["--count", &count.to_string()])
        .output()
        .with_context(|| format!("{tool} cannot be run"))?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    if !output.status.success() {
        let why = text
            .lines()
            .find(|line| line.contains("Error") || line.contains("Unrecognised"))
            .unwrap_or_default();
        bail!("{tool} failed: {why}");
    }
    Ok(text)
}

/// By the processor's counter, all instruction sets.
fn perf(variant: Variant, count: u64) -> Result<u64> {
    let text = under(
        "perf",
        &["stat", "-x,", "-e", "instructions:u", "--"],
        variant,
        count,
    )?;
    text.lines()
        .filter(|line| line.contains("instructions"))
        .find_map(|line| line.split(',').next()?.parse().ok())
        .context("perf has no counter of instructions here")
}

/// By emulation; without AVX-512, which valgrind does not know.
fn callgrind(variant: Variant, count: u64) -> Result<u64> {
    if variant == Variant::Avx512 {
        bail!("valgrind does not know AVX-512");
    }
    let text = under(
        "valgrind",
        &["--tool=callgrind", "--callgrind-out-file=/dev/null"],
        variant,
        count,
    )?;
    text.lines()
        .find_map(|line| line.split("Collected :").nth(1)?.trim().parse().ok())
        .context("callgrind did not say what it collected")
}
