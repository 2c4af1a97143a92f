//! `cageless design`.

use std::path::Path;

use anyhow::Context as _;
use cageless::Case;
use cageless_io::results::write_atomically;
use cageless_paper::structures_of;
use cageless_report::design_report::{design_data, rings_of};
use cageless_report::recommended::recommended_document;
use cageless_report::{design_page, to_json};
use cageless_study::DesignResult;
use cageless_study::design::{Judged, judged as study, task};
use cageless_study::rings::rings;
use cageless_study::{Progress, StudyError, search};

use super::files::{deliver, make_folder, open_page, read_case, writable};
use crate::args::DesignArgs;
use crate::failure::Failure;
use crate::format::{judged, page_line, pairs, warnings};
use crate::progress::{Bars, catch_interrupt};

/// Files in the folder of `--out`.
const NUMBERS: &str = "design.json";
const PAGE: &str = "report.html";
const PAGE_DATA: &str = "report.json";
const CASE: &str = "case.toml";
/// The case with the recommended raceway.
const RECOMMENDED: &str = "recommended.toml";

/// Analyses the case's raceways; searches for a better one if asked to.
pub fn design(args: &DesignArgs) -> Result<(), Failure> {
    let (searching, open) = (args.search, args.open);
    let args = &args.case;
    let file = read_case(args)?;
    if let Some(dir) = &args.out {
        make_folder(dir)?;
        // Better found out now than when the work is done.
        for name in [NUMBERS, PAGE, PAGE_DATA, RECOMMENDED] {
            writable(&dir.join(name))?;
        }
    }
    let stop = catch_interrupt();
    let bars = Bars::new(&stop);
    if searching {
        bars.whole(&[vec![task()], search::tasks(&file)].concat());
    }
    let Judged {
        judgement,
        recommendation,
        snapshots,
    } = study(&file, &bars)?;
    let stopped = judgement.stopped.clone();
    let mut result = DesignResult::new(file.case(), judgement, recommendation);
    let mut none_found = None;
    if searching {
        let out = args.out.as_deref();
        let (found, mut data) =
            search::run(&file, out, &bars).map_err(|error| search_failed(error, out))?;
        none_found = search::refusal(&file, &found);
        data.paper = structures_of(&file.case().bearing)?;
        result.search = Some(data);
    }
    drop(bars);
    if let Some(dir) = &args.out {
        let mut data = design_data(&file, &result, &snapshots);
        data.rings = rings(&rings_of(&file, &result), &Bars::new(&stop))?;
        write_atomically(&dir.join(PAGE), design_page(&data).as_bytes())?;
        write_atomically(&dir.join(PAGE_DATA), to_json(&data)?.as_bytes())?;
    }
    let mut recommended = String::new();
    if let Some(dir) = &args.out {
        let path = dir.join(RECOMMENDED);
        if let Some(document) = recommended_document(&file, &result) {
            write_atomically(&path, document.to_toml_without(file.defaults())?.as_bytes())?;
            recommended = pairs(&[("case with the raceway", path.display().to_string())]);
        } else if path.exists() {
            // One of an earlier call would not be of this case.
            std::fs::remove_file(&path)
                .with_context(|| format!("{}: cannot be removed", path.display()))
                .map_err(Failure::Other)?;
        }
    }
    let text = match none_found {
        Some(_) => String::new(),
        None => text(file.case(), &result) + &recommended + &page_line(args.out.as_deref(), PAGE),
    };
    deliver(args, NUMBERS, &result, &text)?;
    if let (true, Some(dir)) = (searching, &args.out) {
        search::forget(dir);
        // With the case the folder is a result that can be read back.
        let case = file.document().to_toml()?;
        write_atomically(&dir.join(CASE), case.as_bytes())?;
    }
    if let (true, Some(dir)) = (open, &args.out) {
        open_page(&dir.join(PAGE));
    }
    if let Some(message) = none_found {
        let written = args.out.as_ref().map_or(String::new(), |dir| {
            format!("; {} has the maps", dir.join(PAGE).display())
        });
        return Err(Failure::Unphysical(message + &written));
    }
    match stopped {
        // A search does not need the case's own raceway.
        Some(stop) if !searching => Err(Failure::stopped(&stop, "")),
        _ => Ok(()),
    }
}

/// Failure of a search that was interrupted.
fn search_failed(error: StudyError, out: Option<&Path>) -> Failure {
    match (error, out) {
        (StudyError::Interrupted, Some(dir)) => Failure::Interrupted(format!(
            "interrupted: the same command resumes from the checkpoint in {}",
            dir.display()
        )),
        (StudyError::Interrupted, None) => {
            Failure::Interrupted("interrupted: with --out DIR a search can be continued".to_owned())
        }
        (error, _) => error.into(),
    }
}

fn text(case: &Case, r: &DesignResult) -> String {
    let degrees = |value: Option<f64>| value.map_or("–".to_owned(), |v| format!("{v:.4}°"));
    let mut lines = vec![];
    for raceway in &case.raceways {
        let d = raceway.dimensions();
        lines.push((
            "raceway",
            format!(
                "lC {:.4} mm, θ {:.4}°{}",
                d.axial_span_m * 1e3,
                d.half_angle_rad.to_degrees(),
                if case.raceways.len() > 1 {
                    format!(" at ψ = {:.2}°", d.centre_angle_rad.to_degrees())
                } else {
                    String::new()
                }
            ),
        ));
    }
    lines.extend([
        ("ε", format!("{:.4}°", r.epsilon_deg)),
        (
            "nominal gap 360°/N − ε",
            format!("{:.4}°", r.uniform_gap_deg),
        ),
        (
            "upper limit of lC, Eq. (8)",
            format!("{:.4} mm", r.axial_span_limit_mm),
        ),
        ("β0, Eq. (11)", degrees(r.beta0_deg)),
        ("β0 with the polar angle", degrees(r.beta0_polar_deg)),
        (
            "θ of Eq. (11) for this lC",
            degrees(r.half_angle_deg_for_span),
        ),
        (
            "mean ball spacing outside the raceway (steady state)",
            format!("{:.4}°", r.steady_gap_deg),
        ),
        ("critical gap", degrees(r.critical_gap_deg)),
        (
            "largest number of balls in the raceway",
            r.balls_in_raceway_max
                .map_or("–".to_owned(), |n| n.to_string()),
        ),
        (
            "slope discontinuity at raceway ends (at 45° groove angle)",
            degrees(r.kink_deg),
        ),
        ("verdict", judged(r.passes, &r.headline)),
    ]);
    let mut text = pairs(&lines);
    for reason in &r.reasons {
        text += &format!("  - {reason}\n");
    }
    // The search knows better.
    let by = if r.search.is_some() {
        "near the curve of Eq. (11), "
    } else {
        ""
    };
    text += &match &r.recommendation {
        Some(n) => format!(
            "{by}{}\n  - its verdict: {}\n",
            n.sentence(),
            judged(n.passes, &n.headline)
        ),
        None => format!(
            "{by}nothing recommended: on the curve of Eq. (11) balls slip too much wherever three \
             do not fit inside at once; design --search looks further\n"
        ),
    };
    text += &warnings(&r.warnings);
    if let Some(search) = &r.search {
        text += "search:\n";
        for finding in &search.findings {
            text += &format!("  - {finding}\n");
        }
    }
    text
}
