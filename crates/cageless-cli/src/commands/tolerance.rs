//! `cageless tolerance`.

use cageless_report::to_json;
use cageless_report::tolerance::tolerance_page;
use cageless_results::table_of;
use cageless_study::tolerance::{
    Request, ToleranceResult, interruption, nominal_stopped, tolerance as study,
};

use crate::args::ToleranceArgs;
use crate::driver::{Answer, PAGE};
use crate::failure::Failure;
use crate::format::{columns, compared, headlines, pairs, values, warnings};

const NUMBERS: &str = "tolerance.json";

/// Judges the bearing within its tolerances.
pub fn tolerance(args: &ToleranceArgs) -> Result<(), Failure> {
    let file = args.case.read(cageless::Case::check_run)?;
    let name = args.case.case.display().to_string();
    let request = Request {
        samples: args.samples,
        groove_depth_um: args.raceway.groove_depth_um,
        axial_span_um: args.raceway.axial_span_um,
        half_angle_deg: args.raceway.half_angle_deg,
        contact_angle_deg: args.contact_angle_deg,
        ball_grade: args.ball_grade,
        friction: args.friction,
        clearance_um: args.clearance_um,
        speed_percent: args.speed_percent,
        load_percent: args.load_percent,
        viscosity_percent: args.viscosity_percent,
        supply_factor: args.supply_factor,
        benefit: args.benefit,
    };
    // Bad input leaves no folder behind.
    request.check(file.case(), &name)?;
    let output = &args.case.output;
    output.drive(&[PAGE, NUMBERS], |bars| {
        let data = study(&file, &name, &request, bars)?;
        let interrupted =
            interruption(&data.record).map(|why| Failure::Interrupted(why.to_owned()));
        let stopped = nominal_stopped(&data.record).map(|why| Failure::Unphysical(why.to_owned()));
        let failed = interrupted.or(stopped);
        Ok(Answer {
            files: output.files(|| Ok(vec![(PAGE, Some(tolerance_page(&data).into()))]))?,
            ending: failed.map_or(Ok(()), Err),
            ..Answer::new(NUMBERS, to_json(&data)? + "\n", text(&data))
        })
    })
}

fn text(result: &ToleranceResult) -> String {
    let record = &result.record;
    let benefit = result.benefit.as_ref();
    let benefit = benefit.map(|b| compared(&b.answer, &b.comparison));
    let mut text = benefit.unwrap_or_default();
    text += &headlines(record);
    text += &pairs(&values(record));
    text += &format!("\n{}", columns(&table_of(record.parts("influences"))));
    if let Some(samples) = record.part("samples") {
        text += &format!("\n{}", pairs(&values(samples)));
        text += &format!("\n{}", columns(&table_of(samples.parts("verdicts"))));
    }
    let interrupted = interruption(record);
    let shown = record.sentences("warnings").iter();
    let shown: Vec<String> = shown
        .filter(|w| Some(w.as_str()) != interrupted)
        .cloned()
        .collect();
    text + &warnings(&shown)
}
