//! Speed of a sweep, files and all, against the bare library on the same cases.

use std::num::NonZeroUsize;
use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use cageless::Case;
use cageless::design::{
    Eq11, balls_in_raceway_max, half_angle_for_gap_rad, steady_gap_rad, theoretical_gap_rad,
};
use cageless::numerics::lanes::BATCH_WIDTH;
use cageless::raceway::axial_span_limit_m;
use cageless::simulation::{Control, Observer, batches, run_batch};
use cageless::summary::SummaryRecorder;
use cageless_io::case_file::template;
use cageless_io::plan_file::PlanFile;
use cageless_study::sweep::{Job, Sweep};
use clap::Args;
use rayon::prelude::*;

/// Options of `sweep`.
#[derive(Debug, Args)]
pub struct Options {
    /// Variants of `design` without dynamics.
    #[arg(long, default_value_t = 10_000)]
    designs: u64,
    /// Runs of 0.05 s.
    #[arg(long, default_value_t = 1000)]
    runs: u64,
    /// Threads; as many as there are cores by default.
    #[arg(long)]
    threads: Option<NonZeroUsize>,
    /// Repetitions; sweep and library take turns.
    #[arg(long, default_value_t = 3)]
    repetitions: usize,
}

/// Seconds of the clock and of the processor.
#[derive(Debug, Clone, Copy)]
struct Cost {
    wall_s: f64,
    processor_s: f64,
}

/// Measures both kinds of sweep.
pub fn run_command(options: &Options) -> Result<()> {
    println!("| sweep | variants | library, 1/s | sweep, 1/s | wall | processor |");
    println!("|---|---|---|---|---|---|");
    let axes = "operation.radial_load_n = { from = 500.0, to = 3000.0 }\n\
                raceway.half_angle_deg = { from = 15.0, to = 35.0 }";
    for (name, count, compute, library) in [
        ("design", options.designs, "design", designs as fn(&[Case])),
        ("runs of 0.05 s", options.runs, "run", simulate),
    ] {
        let plan = format!(
            "case = \"case.toml\"\ncompute = [\"{compute}\"]\n[set]\nsolver.duration_s = 0.05\n\
             [samples]\nmethod = \"sobol\"\ncount = {count}\n{axes}\n"
        );
        measure(name, &plan, library, options)?;
    }
    println!(
        "\nwall, processor: time of the library over that of the sweep, medians; the clock also \
         sees what else runs on the machine."
    );
    Ok(())
}

fn measure(name: &str, plan: &str, library: fn(&[Case]), options: &Options) -> Result<()> {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("case.toml"), template(false))?;
    let sweep = Sweep::new(PlanFile::parse(plan, "plan", folder.path())?)?;
    let cases = (0..sweep.variants())
        .map(|k| Ok(sweep.file(k)?.cases()[0].case().clone()))
        .collect::<Result<Vec<Case>>>()?;
    let threads = options.threads.map_or(0, NonZeroUsize::get);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()?;
    let (mut bare, mut whole) = (Vec::new(), Vec::new());
    for _ in 0..options.repetitions.max(1) {
        bare.push(cost(|| {
            pool.install(|| cases.par_chunks(BATCH_WIDTH).for_each(library));
            Ok(())
        })?);
        whole.push(cost(|| compute(&sweep, folder.path(), options))?);
    }
    let count = cases.len() as f64;
    let (bare, whole) = (median(bare), median(whole));
    println!(
        "| {name} | {count} | {:.1} | {:.1} | {:.1} % | {:.1} % |",
        count / bare.wall_s,
        count / whole.wall_s,
        100.0 * bare.wall_s / whole.wall_s,
        100.0 * bare.processor_s / whole.processor_s,
    );
    Ok(())
}

fn compute(sweep: &Sweep, folder: &Path, options: &Options) -> Result<()> {
    let job = Job {
        result: folder.join("sweep.parquet"),
        shard: None,
        threads: options.threads,
    };
    let done = cageless_study::sweep::run(sweep, &job, |_| Control::Continue(()))?;
    ensure!(done.complete, "the sweep is not complete");
    Ok(std::fs::remove_file(&job.result)?)
}

/// What `compute = ["design"]` asks of the library.
fn design(case: &Case) {
    let bearing = &case.bearing;
    let raceway = &case.raceways[0];
    let (gap, span) = (bearing.nominal_gap_rad(), raceway.dimensions().axial_span_m);
    std::hint::black_box((
        axial_span_limit_m(bearing),
        theoretical_gap_rad(bearing, raceway, Eq11::Published),
        theoretical_gap_rad(bearing, raceway, Eq11::Polar),
        half_angle_for_gap_rad(bearing, span, gap, Eq11::Published),
        steady_gap_rad(bearing, &case.raceways),
        balls_in_raceway_max(bearing, raceway),
        raceway.kink_angle_rad(std::f64::consts::FRAC_PI_4),
    ));
}

fn designs(cases: &[Case]) {
    cases.iter().for_each(design);
}

/// As many side by side as the library can.
fn simulate(cases: &[Case]) {
    for members in batches(cases) {
        let mut summaries: Vec<_> = members.iter().map(|_| SummaryRecorder::new()).collect();
        let mut observers: Vec<Vec<&mut dyn Observer>> = summaries
            .iter_mut()
            .map(|summary| vec![summary as &mut dyn Observer])
            .collect();
        let together: Vec<&Case> = members.iter().map(|k| &cases[*k]).collect();
        let outcomes = run_batch(&together, &mut observers, &mut |_| Control::Continue(()));
        std::hint::black_box((outcomes.len(), summaries.len()));
    }
}

fn cost(work: impl FnOnce() -> Result<()>) -> Result<Cost> {
    let (started, before) = (Instant::now(), processor_s()?);
    work()?;
    Ok(Cost {
        wall_s: started.elapsed().as_secs_f64(),
        processor_s: processor_s()? - before,
    })
}

/// Processor time of this process, all threads, so far.
fn processor_s() -> Result<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").context("needs Linux")?;
    // After the name, which may have blanks in it: utime and stime are fields 14 and 15.
    let fields: Vec<&str> = stat
        .rsplit_once(')')
        .map_or(stat.as_str(), |(_, rest)| rest)
        .split_whitespace()
        .collect();
    let ticks = |k: usize| -> Result<f64> { Ok(fields.get(k).context("a field")?.parse()?) };
    Ok((ticks(11)? + ticks(12)?) / 100.0)
}

fn median(mut costs: Vec<Cost>) -> Cost {
    let middle = costs.len() / 2;
    let mut pick = |of: fn(&Cost) -> f64| {
        costs.sort_by(|a, b| of(a).total_cmp(&of(b)));
        of(&costs[middle])
    };
    Cost {
        wall_s: pick(|c| c.wall_s),
        processor_s: pick(|c| c.processor_s),
    }
}
