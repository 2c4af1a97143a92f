//! Time per evaluation of the right-hand side, for each instruction set and for the textbook.

use std::hint::black_box;
use std::time::Instant;

use anyhow::{Result, ensure};
use cageless::Case;
use cageless::dynamics::State;
use cageless::dynamics::{InstructionSet, Model, RightHandSide};
use cageless::integrator::{Aligned, System};
use cageless::reference::Textbook;
use cageless::simulation::{self, Control, Ending, Observer, ObserverError, RunContext, StepView};
use clap::Args;

use crate::problem::Problem;

/// Options of `rhs`.
#[derive(Debug, Args)]
pub struct Options {
    /// Repetitions of each timing; all instruction sets take turns in each.
    #[arg(long, default_value_t = 15)]
    repetitions: usize,
    /// Evaluations per timing.
    #[arg(long, default_value_t = 100_000)]
    evaluations: usize,
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

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        while self.states.len() as f64 * self.interval_s <= view.step.t1_s {
            self.states
                .push(view.state(self.states.len() as f64 * self.interval_s));
        }
        Ok(Control::Continue(()))
    }
}

/// States along a case, `interval_s` apart.
///
/// # Errors
/// The run ends early.
pub fn states(case: &Case, interval_s: f64) -> Result<Vec<State>> {
    let mut collector = Collector {
        interval_s,
        states: vec![],
    };
    let outcome = simulation::run(case, &mut [&mut collector], &mut |_| Control::Continue(()))?;
    ensure!(
        matches!(outcome.ending, Ending::Complete),
        "{:?}",
        outcome.ending
    );
    Ok(collector.states)
}

/// One implementation of the equations: it writes the rates of a state.
type Implementation<'m> = (&'static str, Box<dyn FnMut(usize, &mut [f64]) + 'm>);

/// Prints the median time of each.
///
/// # Errors
/// The run that the states are from ends early.
pub fn measure(options: &Options) -> Result<()> {
    let case = Problem::run(&[])?.short;
    let model = Model::new(&case)?;
    let states = states(&case, 1e-4)?;
    let motions: Vec<Vec<f64>> = states
        .iter()
        .map(|s| Textbook::motion(s.layout(), s.values()))
        .collect();
    // As in a run: vectors that begin on a cache line.
    let values: Vec<Aligned> = states.iter().map(|s| Aligned::from(s.values())).collect();
    let textbook = Textbook::new(&case);
    let mut all: Vec<Implementation<'_>> = vec![(
        "textbook",
        Box::new(|k, rate| textbook.derivative(&motions[k], &mut rate[..motions[k].len()])),
    )];
    for set in InstructionSet::ALL
        .into_iter()
        .filter(|set| set.available())
    {
        let mut rhs = RightHandSide::with_instruction_set(&model, set);
        let values = &values;
        all.push((
            set.name(),
            Box::new(move |k, rate| rhs.derivative(0.0, &values[k], rate)),
        ));
    }
    let mut rate = Aligned::from(states[0].values());
    let mut times = vec![vec![]; all.len()];
    for _ in 0..options.repetitions.max(1) {
        for ((_, evaluate), times) in all.iter_mut().zip(&mut times) {
            let clock = Instant::now();
            for k in (0..states.len()).cycle().take(options.evaluations.max(1)) {
                evaluate(black_box(k), black_box(&mut rate));
            }
            times.push(1e9 * clock.elapsed().as_secs_f64() / options.evaluations.max(1) as f64);
        }
    }
    println!("| right-hand side of CB74 | ns, median | times as fast as the textbook |");
    println!("|---|---|---|");
    let medians: Vec<f64> = times
        .iter_mut()
        .map(|times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect();
    for ((name, _), median) in all.iter().zip(&medians) {
        println!("| {name} | {median:.0} | {:.1} |", medians[0] / median);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rates of both implementations along a run and along a drop, over a millisecond in the
    /// scales of the states.
    #[test]
    fn the_textbook_has_the_equations_of_the_library() {
        let mut run = Problem::run(&[]).unwrap().short;
        run.solver.duration_s = 0.1;
        let drop = Problem::drop(&[]).unwrap().short;
        let mut touching = 0;
        for (case, interval_s) in [(run, 5e-5), (drop, 5e-6)] {
            let mut carrying = 0;
            let model = Model::new(&case).unwrap();
            let mut rhs = RightHandSide::new(&model);
            let textbook = Textbook::new(&case);
            for state in states(&case, interval_s).unwrap() {
                let mut rate = vec![0.0; state.layout().len()];
                rhs.derivative(0.0, state.values(), &mut rate);
                let library = Textbook::motion(state.layout(), &rate);
                let y = Textbook::motion(state.layout(), state.values());
                let mut own = vec![0.0; y.len()];
                textbook.derivative(&y, &mut own);
                let scales = Textbook::scales(state.layout());
                for (k, ((a, b), scale)) in own.iter().zip(&library).zip(scales).enumerate() {
                    assert!((a - b).abs() * 1e-3 / scale < 1e-9, "state {k}: {a} {b}");
                }
                let (x, y) = (state.x_m(), state.y_m());
                touching += (0..x.len())
                    .map(|k| (k, (k + 1) % x.len()))
                    .filter(|&(k, j)| (x[j] - x[k]).hypot(y[j] - y[k]) < 2.0 * 4.7625e-3)
                    .count();
                carrying += usize::from(own.last().is_some_and(|rate| *rate != 0.0));
            }
            assert!(carrying > 0, "the last body feels no force");
        }
        assert!(touching > 0, "no contact between balls among the states");
    }
}
