//! `cageless design`.

use std::path::Path;

use cageless::Snapshot;
use cageless_io::case_file::{CaseDocument, CaseFile};
use cageless_paper::structures_of;
use cageless_report::design_report::design_data;
use cageless_report::recommended::recommended_document;
use cageless_report::{design_page, to_json};
use cageless_results::{DryVerdict, open_benefit};
use cageless_study::design::{Asked, DesignResult, Designed, design as study};
use cageless_study::{StudyError, search};

use crate::args::DesignArgs;
use crate::driver::{Answer, Files, PAGE, PAGE_DATA, pretty};
use crate::failure::Failure;
use crate::format::{compared, judged, pairs, values, warnings};

/// Files in the folder of `--out`.
const NUMBERS: &str = "design.json";
const CASE: &str = "case.toml";
/// The case with the recommended raceway.
const RECOMMENDED: &str = "recommended.toml";

/// Failure of a design that was interrupted after its verdict.
const INTERRUPTED: &str = "interrupted: the verdict is complete; what was to follow is left out";

/// Analyses the case's raceways; searches for a better one if asked to.
pub fn design(args: &DesignArgs) -> Result<(), Failure> {
    let output = &args.case.output;
    let out = output.out.as_deref();
    // --axial brings its own axial loads and tilts.
    let file = args.case.read(match args.axial {
        true => cageless::Case::check_planar_but_for_slots,
        false => cageless::Case::check_motion,
    })?;
    output.drive(&[NUMBERS, PAGE, PAGE_DATA, RECOMMENDED], |bars| {
        let paper = structures_of(&file.case().bearing)?;
        let asked = Asked {
            axial: args.axial,
            search: args.search.then_some(&paper),
            benefit: args.benefit,
            folder: out,
        };
        let Designed {
            result,
            snapshots,
            stopped,
            none_found,
            axial_unknown,
            interrupted,
        } = study(&file, asked, bars).map_err(|error| match args.search {
            true => search_failed(error, out),
            false => error.into(),
        })?;
        let recommended = recommended_document(&file, &result);
        let mut text = text(&result);
        if let (Some(dir), Some(_)) = (out, &recommended) {
            let path = dir.join(RECOMMENDED).display().to_string();
            text += &pairs(&[("case with the raceway", path)]);
        }
        let files = output.files(|| files(args.search, &file, &result, &snapshots, recommended))?;
        let ending = match (none_found, stopped) {
            _ if interrupted => Err(Failure::Interrupted(INTERRUPTED.to_owned())),
            (Some(message), _) => {
                text = benefit(&result);
                let page = out.map(|dir| dir.join(PAGE));
                let maps = page.map(|page| format!(" {} has the maps.", page.display()));
                Err(Failure::Unphysical(message + &maps.unwrap_or_default()))
            }
            // A search does not need the case's own raceway.
            (None, Some(stop)) if !args.search => Err(Failure::stopped(&stop, "")),
            _ => axial_unknown.map_or(Ok(()), |reason| Err(Failure::Unphysical(reason))),
        };
        Ok(Answer {
            csv: true,
            files,
            journal: args.search.then_some(search::JOURNAL),
            ending,
            ..Answer::new(NUMBERS, pretty(&result)?, text)
        })
    })
}

/// Page, its data and the recommended case; of a search also the case itself.
fn files(
    search: bool,
    file: &CaseFile,
    result: &DesignResult,
    snapshots: &[Snapshot],
    recommended: Option<CaseDocument>,
) -> Result<Files, Failure> {
    let data = design_data(file, result, snapshots);
    let recommended = recommended.map(|case| file.edited(&case));
    let mut files = vec![
        (PAGE, Some(design_page(&data).into())),
        (PAGE_DATA, Some(to_json(&data)?.into())),
        (RECOMMENDED, recommended.transpose()?.map(Into::into)),
    ];
    if search {
        // With the case the folder is a result that can be read back.
        files.push((CASE, Some(file.document().to_toml()?.into())));
    }
    Ok(files)
}

/// Failure of a search that was interrupted.
fn search_failed(error: StudyError, out: Option<&Path>) -> Failure {
    match (error, out) {
        (StudyError::Interrupted, Some(dir)) if !dir.join(search::JOURNAL).is_file() => {
            Failure::Interrupted("interrupted before the first simulation ended".to_owned())
        }
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
    let dry = DryVerdict::of(&record.results);
    lines.extend(dry.map(|dry| (DryVerdict::NAME, judged(dry.passes, dry.headline))));
    let open = open_benefit(passes).filter(|_| r.benefit.is_none());
    lines.extend(open.map(|open| ("benefit", open.to_owned())));
    lines.extend(record.limits().lines());
    let mut text = benefit(r) + &pairs(&lines) + &bullets(record.sentences("reasons"));
    text += &match r.recommendation() {
        // A search has a recommendation of its own.
        _ if r.search.is_some() => String::new(),
        Some(near) => format!(
            "{}\n  - its verdict: {}\n",
            near.sentence(),
            judged(near.passes(), near.0.results.text("headline"))
        ),
        None => "No suggestion from the closed form. Use design --search\n".to_owned(),
    };
    text += &warnings(record.sentences("warnings"));
    if let Some(axial) = &r.axial {
        text += &("axial load, by motion in space:\n".to_owned() + &pairs(&values(axial)));
        text += &bullets(axial.sentences("findings"));
    }
    if let Some(search) = &r.search {
        let what = match r.benefit {
            Some(_) => {
                "search, by short runs of equal balls; of what it accepts the long runs above choose:\n"
            }
            None => "search:\n",
        };
        text += &(what.to_owned() + &bullets(search.sentences("findings")));
    }
    text
}

/// Benefit in steady operation, with the table of the rings.
fn benefit(r: &DesignResult) -> String {
    let Some(benefit) = &r.benefit else {
        return String::new();
    };
    compared(&benefit.answer, &benefit.comparison)
}

fn bullets(sentences: &[String]) -> String {
    sentences.iter().map(|s| format!("  - {s}\n")).collect()
}
