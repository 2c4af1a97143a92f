//! `cageless design`.

use std::path::Path;

use anyhow::Context as _;
use cageless_io::results::write_atomically;
use cageless_paper::structures_of;
use cageless_report::design_report::{design_data, rings_of};
use cageless_report::recommended::recommended_document;
use cageless_report::{design_page, to_json};
use cageless_study::design::{DesignResult, Judged, judged as study, task};
use cageless_study::rings::rings;
use cageless_study::{Progress, StudyError, search};

use super::files::{deliver, make_folder, open_page, read_case, writable};
use crate::args::DesignArgs;
use crate::failure::Failure;
use crate::format::{judged, page_line, pairs, values, warnings};
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
    let mut result = DesignResult::new(file.case(), &judgement, recommendation.as_ref());
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
        None => text(&result) + &recommended + &page_line(args.out.as_deref(), PAGE),
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

fn text(r: &DesignResult) -> String {
    let record = &r.record;
    let mut lines = vec![];
    for raceway in record.parts("raceways") {
        let number = |name| raceway.results.number(name);
        lines.push((
            "raceway",
            format!(
                "lC {:.4} mm, θ {:.4}°, at ψ = {:.2}°",
                number("axial_span_mm"),
                number("half_angle_deg"),
                number("centre_angle_deg")
            ),
        ));
    }
    lines.extend(values(&record.results));
    if let Some(passages) = record.part("passages") {
        lines.extend(values(&passages.results));
    }
    let (passes, headline) = (
        record.results.flag("passes"),
        record.results.text("headline"),
    );
    lines.push(("verdict", judged(passes, headline)));
    let mut text = pairs(&lines) + &bullets(record.sentences("reasons"));
    // The search knows better.
    let by = if r.search.is_some() {
        "near the curve of Eq. (11), "
    } else {
        ""
    };
    text += &match r.recommendation() {
        Some(near) => format!(
            "{by}{}\n  - its verdict: {}\n",
            near.sentence(),
            judged(near.passes(), near.0.results.text("headline"))
        ),
        None => format!(
            "{by}nothing recommended: on the curve of Eq. (11) balls slip too much wherever three \
             do not fit inside at once; design --search looks further\n"
        ),
    };
    text += &warnings(record.sentences("warnings"));
    if let Some(search) = &r.search {
        text += &("search:\n".to_owned() + &bullets(&search.findings));
    }
    text
}

fn bullets(sentences: &[String]) -> String {
    sentences.iter().map(|s| format!("  - {s}\n")).collect()
}
