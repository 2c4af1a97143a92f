//! A long run without any damping under the production method: does energy drift, is a ball
//! lost?

use std::time::Instant;

use anyhow::{Result, bail};
use cageless::dynamics::Model;
use cageless::dynamics::state::State;
use cageless::gap::GapRange;
use cageless::simulation::{self, Control, Ending, Observer, ObserverError, RunContext, StepView};
use cageless::step_limits::StepLimits;
use clap::Args;

use crate::problem;

/// Options of `endurance`.
#[derive(Debug, Args)]
pub struct Options {
    /// Simulated time, s.
    #[arg(long, default_value_t = 100.0)]
    seconds: f64,
    /// Lines of the table.
    #[arg(long, default_value_t = 10)]
    lines: usize,
    /// Further keys of the case, as `run --set` takes them.
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    set: Vec<String>,
}

/// Energy that the ledger may miss, as a fraction of all its flows.
const RESIDUAL_MAX: f64 = 1e-3;
/// Balls whose centres are closer than in contact by this angle have changed places or are
/// pressed through each other, degrees.
const GAP_LEAST_DEG: f64 = -0.5;
/// Gaps are looked at this often, steps.
const GAPS_EVERY: u64 = 16;

/// One stretch of the run.
struct Line {
    end_s: f64,
    /// Stored energy at the end, J.
    energy_j: f64,
    /// Energy now − energy at the start − net work, J.
    residual_j: f64,
    /// Sum of the absolute flows, J.
    flows_j: f64,
    ring_x_um: [f64; 2],
    ring_y_um: [f64; 2],
    gap_deg: [f64; 2],
    slip_m_s: f64,
}

const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// Ranges within the stretch under way, and the lines so far.
struct Watch<'m> {
    model: &'m Model,
    stretch_s: f64,
    start_energy_j: f64,
    steps: u64,
    ring: [[f64; 2]; 2],
    gaps: GapRange,
    slip: f64,
    lines: Vec<Line>,
}

fn widen(range: &mut [f64; 2], value: f64) {
    *range = [range[0].min(value), range[1].max(value)];
}

impl Observer for Watch<'_> {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.start_energy_j = self.model.energy_j(context.start);
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        let (layout, after) = (view.layout(), &view.step.y1);
        let ring = layout.ring_motion(after);
        for (range, place) in self.ring.iter_mut().zip([ring.x, ring.y]) {
            widen(range, place);
        }
        if self.steps.is_multiple_of(GAPS_EVERY) {
            let [x, y] = view.positions();
            self.gaps.look(x, y, view.outer_ring_m());
            let c = &view.contacts;
            for k in 0..layout.balls {
                for (slip, force) in [
                    (c.inner_slip_m_s(k), c.inner_force_n(k)),
                    (c.outer_slip_m_s(k), c.outer_force_n(k)),
                ] {
                    if force > 0.0 {
                        self.slip = self.slip.max(slip.abs());
                    }
                }
            }
        }
        self.steps += 1;
        let due_s = (self.lines.len() + 1) as f64 * self.stretch_s;
        if view.step.t1_s >= due_s * (1.0 - 1e-12) {
            let (state, model) = (State::from_vector(layout, after), self.model);
            let (residual_j, flows_j) = model.energy_residual_j(self.start_energy_j, &state);
            self.lines.push(Line {
                end_s: view.step.t1_s,
                energy_j: model.energy_j(&state),
                residual_j,
                flows_j,
                ring_x_um: self.ring[0].map(|v| v * 1e6),
                ring_y_um: self.ring[1].map(|v| v * 1e6),
                gap_deg: self.gaps.range_rad().map(f64::to_degrees),
                slip_m_s: self.slip,
            });
            self.ring = [NOTHING; 2];
            self.gaps = GapRange::new(model);
            self.slip = 0.0;
        }
        Ok(Control::Continue(()))
    }
}

/// Runs CB74 and prints the table and a verdict.
///
/// # Errors
/// The case is impossible, or the verdict is that energy drifts or a ball was lost.
pub fn run(options: &Options) -> Result<()> {
    let mut overrides = vec![
        "contact.damping=0.0".to_owned(),
        "contact.ball_restitution=1.0".to_owned(),
        "solver.method=symplectic".to_owned(),
        "solver.step_us=auto".to_owned(),
        format!("solver.duration_s={:?}", options.seconds),
    ];
    overrides.extend(options.set.iter().cloned());
    let case = problem::cb74(&overrides)?;
    let omega_h = StepLimits::new(&case).contact_rad_s * case.solver.step_s;
    println!(
        "CB74 without damping, {} s, {:?}, step {} µs (ωh = {omega_h:.2})",
        options.seconds,
        case.solver.method,
        case.solver.step_s * 1e6
    );
    let model = Model::new(&case)?;
    let mut watch = Watch {
        model: &model,
        stretch_s: options.seconds / options.lines.max(1) as f64,
        start_energy_j: 0.0,
        steps: 0,
        ring: [NOTHING; 2],
        gaps: GapRange::new(&model),
        slip: 0.0,
        lines: vec![],
    };
    let clock = Instant::now();
    let outcome = simulation::run(&case, &mut [&mut watch], &mut |_| Control::Continue(()))?;
    let wall_s = clock.elapsed().as_secs_f64();
    print_lines(&watch);
    println!(
        "{} steps, {wall_s:.1} s of computing: {:.3} s per simulated second",
        outcome.steps,
        wall_s / outcome.end_s
    );
    if let Ending::Stopped(stop) = outcome.ending {
        bail!("FAIL: stopped at {} s: {}", stop.time_s, stop.cause);
    }
    verdict(&watch.lines)
}

fn print_lines(watch: &Watch<'_>) {
    println!("at the start {:.6} J are stored", watch.start_energy_j);
    println!(
        "{:>8} {:>11} {:>13} {:>12} {:>10} {:>17} {:>19} {:>17} {:>9}",
        "until s",
        "stored J",
        "flows J",
        "missing J",
        "of flows",
        "ring x µm",
        "ring y µm",
        "gap °",
        "slip m/s"
    );
    let range = |[low, high]: [f64; 2]| format!("{low:.3} … {high:.3}");
    for line in &watch.lines {
        println!(
            "{:>8.2} {:>11.6} {:>13.2} {:>12.3e} {:>10.1e} {:>17} {:>19} {:>17} {:>9.3}",
            line.end_s,
            line.energy_j,
            line.flows_j,
            line.residual_j,
            line.residual_j / line.flows_j,
            range(line.ring_x_um),
            range(line.ring_y_um),
            range(line.gap_deg),
            line.slip_m_s
        );
    }
    println!(
        "stored: kinetic and elastic; flows: sum of the absolute entries of the energy ledger;"
    );
    println!("missing: stored now − stored at the start − net work of the ledger");
}

/// # Errors
/// Energy drifts beyond what the ledger explains, or balls have changed places.
fn verdict(lines: &[Line]) -> Result<()> {
    let fraction = |line: &Line| (line.residual_j / line.flows_j).abs();
    let worst = lines.iter().map(fraction).fold(0.0, f64::max);
    let least = lines.iter().map(|l| l.gap_deg[0]).fold(0.0, f64::min);
    if worst > RESIDUAL_MAX {
        bail!("FAIL: the ledger misses {worst:.1e} of all flows, {RESIDUAL_MAX:.0e} is allowed");
    }
    if least < GAP_LEAST_DEG {
        bail!("FAIL: a gap of {least:.3}°: balls went through each other");
    }
    println!(
        "PASS: the ledger explains all but {worst:.1e} of the energy flows ({RESIDUAL_MAX:.0e} is \
         allowed), no ball was lost"
    );
    Ok(())
}
