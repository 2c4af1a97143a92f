//! Cost of a law of friction of one's own beside the built-in smooth law.

use std::time::Instant;

use anyhow::Result;
use cageless::prelude::*;
use clap::Args;

use crate::problem::complete;

/// The built-in smooth law, through the trait.
struct Constant(f64);

impl FrictionLaw for Constant {
    fn coefficient(&self, _sliding_m_s: f64) -> [f64; 2] {
        [self.0, 0.0]
    }
}

#[derive(Debug, Args)]
pub struct Options {
    /// Pairs of runs, one after the other; the fastest of each counts
    #[arg(long, default_value_t = 20)]
    repetitions: usize,
}

/// Prints the ratio of times for each kind of motion.
///
/// # Errors
/// A run that ends early.
pub fn measure(options: &Options) -> Result<()> {
    println!("| motion | method | own over built-in |");
    println!("|---|---|---|");
    for (name, duration_s, change) in motions() {
        for method in [IntegrationMethod::VelocityVerlet, IntegrationMethod::Abm4] {
            let case = |friction: &dyn Fn(CaseBuilder) -> CaseBuilder| {
                let bearing = reference::bearing();
                let raceway = reference::Structure::D.raceway(&bearing)?;
                let case = CaseBuilder::of(bearing).raceway(raceway).change(change);
                let case = case.inner_speed_rad_s(1257.0).radial_load_n(1500.0);
                friction(case).method(method).duration_s(duration_s).build()
            };
            let built_in = case(&|case| case.friction_coefficient(0.007))?;
            let own = case(&|case| case.own_friction(Constant(0.007)))?;
            let mut fastest_s = [f64::INFINITY; 2];
            for _ in 0..options.repetitions.max(1) {
                for (case, fastest_s) in [&built_in, &own].into_iter().zip(&mut fastest_s) {
                    let clock = Instant::now();
                    std::hint::black_box(complete(case)?);
                    *fastest_s = fastest_s.min(clock.elapsed().as_secs_f64());
                }
            }
            let ratio = fastest_s[1] / fastest_s[0];
            println!("| {name} | {} | {ratio:.2} |", method.label());
        }
    }
    Ok(())
}

/// Name, duration of a run in s, and change of a case.
type Kind = (&'static str, f64, fn(&mut Case));

fn motions() -> [Kind; 3] {
    [
        ("rigid plane", 0.02, |case| case.flanks = FlankModel::Rigid),
        ("elastic plane", 0.02, |_| {}),
        ("space", 0.004, |case| case.motion = Motion::Space),
    ]
}
