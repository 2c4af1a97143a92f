//! `cageless sweep`.

use std::path::{Path, PathBuf};

use cageless_io::plan_file::PlanFile;
use cageless_study::sweep::{self, Failures, Job, Shard, Sweep, failures, merge, run_announced};
use cageless_study::{Progress, break_if};
use serde::Serialize;

use crate::args::{MergeArgs, SweepArgs, SweepCommand, SweepOutput};
use crate::driver::{make_folder, print, tell};
use crate::failure::Failure;
use crate::format::pairs;
use crate::interrupt::Interrupt;
use crate::progress::{Bars, announce_long};

/// `sweep --json`.
#[derive(Debug, Serialize)]
struct SweepResult {
    result: PathBuf,
    variants: u64,
    failed: u64,
    first_reason: Option<String>,
    computed_now: u64,
    variants_per_s: Option<f64>,
    wall_s: f64,
}

/// Computes a sweep, or joins shards.
pub fn sweep(args: &SweepArgs) -> Result<(), Failure> {
    if let Some(SweepCommand::Merge(args)) = &args.command {
        return join(args);
    }
    let Some(path) = &args.plan else {
        return Err(Failure::Input("a plan is missing".to_owned()));
    };
    let result = folder(&args.output, path).join(file_name(args.shard));
    printable(&args.output, &result)?;
    let sweep = Sweep::new(PlanFile::read(path)?)?;
    let job = Job {
        result,
        shard: args.shard,
        threads: args.threads,
    };
    let stop = Interrupt::caught();
    let bars = Bars::new(&stop);
    let expects = bars.announces().then_some(announce_long);
    let done = run_announced(&sweep, &job, expects, |progress| {
        let (done, total, rate) = (progress.done, progress.total, shown_rate(progress.rate()));
        let text = format!("{done} of {total} variants, {rate} per second");
        bars.show(&text, progress.fraction());
        break_if(bars.interrupted())
    })?;
    drop(bars);
    let progress = done.progress;
    if !done.complete {
        return Err(Failure::Interrupted(format!(
            "interrupted at {} of {} variants, which are kept: the same command resumes",
            progress.done, progress.total
        )));
    }
    deliver(
        &args.output,
        job.result,
        progress.total,
        Some(&progress),
        args.shard,
    )
}

/// `sweep merge`.
fn join(args: &MergeArgs) -> Result<(), Failure> {
    let folder = match &args.output.out {
        Some(folder) => folder.clone(),
        None => args.shards[0].parent().unwrap_or(Path::new("")).to_owned(),
    };
    let result = folder.join(file_name(None));
    printable(&args.output, &result)?;
    make_folder(&folder)?;
    let variants = merge(&args.shards, &result)?;
    deliver(&args.output, result, variants, None, None)
}

/// Refuses a path that cannot stand in the answer, before anything is computed.
fn printable(output: &SweepOutput, result: &Path) -> Result<(), Failure> {
    if output.json && result.to_str().is_none() {
        return Err(Failure::Input(format!(
            "{}: the path is not UTF-8, which JSON demands: leave out --json or take another --out",
            result.display()
        )));
    }
    Ok(())
}

/// `--out`, or what stands for it.
fn folder(output: &SweepOutput, plan: &Path) -> PathBuf {
    let stem = || Path::new("out").join(plan.file_stem().unwrap_or("sweep".as_ref()));
    output.out.clone().unwrap_or_else(stem)
}

/// Beginning of the name of the result of a shard.
pub(super) const SHARD: &str = "sweep.shard-";

/// Name of the result, or of that of a shard.
pub(super) fn file_name(shard: Option<Shard>) -> String {
    match shard {
        Some(shard) => format!("{SHARD}{}-of-{}.parquet", shard.number(), shard.total()),
        None => "sweep.parquet".to_owned(),
    }
}

fn deliver(
    output: &SweepOutput,
    result: PathBuf,
    variants: u64,
    progress: Option<&sweep::Progress>,
    shard: Option<Shard>,
) -> Result<(), Failure> {
    let Failures { count, first } = failures(&result)?;
    let computed = progress.filter(|p| p.done_now > 0);
    let result = SweepResult {
        result,
        variants,
        failed: count,
        first_reason: first,
        computed_now: progress.map_or(0, |p| p.done_now),
        variants_per_s: computed.map(sweep::Progress::rate),
        wall_s: progress.map_or(0.0, |p| p.elapsed.as_secs_f64()),
    };
    if output.json {
        print(&(serde_json::to_string_pretty(&result)? + "\n"))?;
    } else {
        tell(&text(&result))?;
    }
    // A shard may be a part of the plan in which no case is possible.
    match result.first_reason {
        Some(reason) if result.failed == variants && shard.is_none() => Err(Failure::Unphysical(
            format!("all {variants} variants failed; the first: {reason}"),
        )),
        _ => Ok(()),
    }
}

fn text(result: &SweepResult) -> String {
    let mut lines = vec![
        ("result", result.result.display().to_string()),
        ("variants", result.variants.to_string()),
    ];
    if let Some(rate) = result.variants_per_s {
        lines.push(("computed now", result.computed_now.to_string()));
        lines.push(("rate", format!("{} per second", shown_rate(rate))));
    }
    lines.push(match &result.first_reason {
        None => ("failed", "none".to_owned()),
        Some(reason) => ("failed", format!("{}; the first: {reason}", result.failed)),
    });
    pairs(&lines)
}

fn shown_rate(rate: f64) -> String {
    match rate {
        rate if rate >= 100.0 => format!("{rate:.0}"),
        rate => format!("{rate:.2}"),
    }
}
