//! Data of the report of a design.

use crate::figures::axial_load::AxialLoads;
use crate::lead;
use crate::recommended::ShownRaceway;
use crate::run_report::motion;
use crate::{
    ContactTrack, DesignCurve, DesignData, DesignLimit, LimitedQuantity, Parameter, Provenance,
    RacewayLabel, RacewaySurface,
};
use cageless::Case;
use cageless::Snapshot;
use cageless::closed_forms::span_angle_curve;
use cageless::raceway::axial_span_limit_m;
use cageless_design::{AXIAL_ORBITS, RacewayVerdict, steady_after_s, steady_case};
use cageless_io::case_file::CaseFile;
use cageless_results::{DryVerdict, Recommended, Record, software};
use cageless_study::{DesignResult, lines, parameter, parameters, provenance};

/// Points of the curve of Eq. (11).
const CURVE_POINTS: usize = 240;

/// Data of the page of a design.
pub fn design_data(file: &CaseFile, result: &DesignResult, snapshots: &[Snapshot]) -> DesignData {
    let (case, name) = (file.case(), file.particulars().title.as_str());
    let steady = steady_case(case);
    let discarded = format!("t < {:.4} s", steady_after_s(case));
    let source = provenance(name, &steady, discarded);
    let first = case.raceways.first();
    let own = RacewayLabel::new("", first);
    let (record, results_of) = (&result.record, &result.record.results);
    let passes = results_of.flag("passes");
    let title = match passes {
        Some(_) => format!(
            "{}: {}",
            RacewayVerdict::works(passes),
            results_of.text("verdict")
        ),
        None => String::new(),
    };
    let near = result.recommendation();
    DesignData {
        // A seed beyond the whole numbers of TOML leaves the page without a studio.
        case_toml: file.document().to_toml().unwrap_or_default(),
        title: match name {
            "" => "Design".to_owned(),
            name => format!("Design: {name}"),
        },
        software: software(),
        lead: lead(case),
        warnings: record.sentences("warnings").to_vec(),
        passes,
        headline: results_of.text("headline").to_owned(),
        dry: DryVerdict::of(results_of).map(|dry| (dry.passes, dry.line())),
        results: results(result),
        recommendation_passes: near.and_then(Recommended::passes),
        recommendation: near.map_or(String::new(), |r| {
            let verdict = r.0.results.text("headline");
            format!("{}. Its verdict: {verdict}", r.sentence())
        }),
        limits: record.limits().verdicts(),
        reasons: record.sentences("reasons").to_vec(),
        curve: Some(curve(file, result, &own)),
        contact_track: first.map(|r| ContactTrack::sample(r, &case.bearing, own.clone())),
        surface: first.map(|r| RacewaySurface::sample(r, &case.bearing, own.clone())),
        motion: (!snapshots.is_empty()).then(|| motion(case, &title, snapshots, source.clone())),
        shown: ShownRaceway::new(file, result),
        axial: result.axial.as_ref().map(|axial| {
            let [settles, counts] = AXIAL_ORBITS;
            let discarded = format!("first {settles} of {} orbits", settles + counts);
            let source = provenance(name, &steady, discarded);
            AxialLoads::new(axial, case.operation.radial_load_n, source)
        }),
        axial_findings: (result.axial.iter())
            .flat_map(|axial| axial.sentences("findings").to_vec())
            .collect(),
        search: result.search.clone(),
        benefit: result.benefit.clone(),
        parameters: parameters(file),
        provenance: source,
    }
}

fn lead(case: &Case) -> String {
    let ring = match case.raceways.len() {
        0 => "conventional outer ring".to_owned(),
        1 => "one discrete raceway".to_owned(),
        n => format!("{n} discrete raceways"),
    };
    format!(
        "{}, {}; initial design: {ring}.",
        lead::balls(case),
        lead::operation(case)
    )
}

fn results(r: &DesignResult) -> Vec<Parameter> {
    let record = &r.record;
    let rows = |record: &Record| lines(record.rows());
    let name = |passes| RacewayVerdict::works(passes).to_owned();
    let mut all = vec![
        parameter("works", name(record.results.flag("passes")), ""),
        parameter("verdict", record.results.text("verdict").to_owned(), ""),
    ];
    all.extend(rows(record));
    all.extend(record.part("passages").into_iter().flat_map(rows));
    let raceways = record.parts("raceways");
    for one in raceways.iter().filter(|_| raceways.len() > 1) {
        if let Some((label, value, unit)) = one.results.row("critical_gap_deg") {
            let label = format!(
                "{label} of the raceway at ψ = {:.1}° ({})",
                one.results.number("centre_angle_deg"),
                one.results.text("verdict")
            );
            all.push(parameter(&label, value, &unit));
        }
    }
    all
}

fn curve(file: &CaseFile, result: &DesignResult, own: &RacewayLabel) -> DesignCurve {
    let case = file.case();
    let bearing = &case.bearing;
    let points = span_angle_curve(bearing, case.raceway_form(), CURVE_POINTS);
    let number = |name| result.record.results.number(name);
    let span_mm = axial_span_limit_m(bearing) * 1e3;
    let three_balls_deg = number("epsilon_deg") + number("uniform_gap_deg");
    let near = result.recommendation().map(|near| {
        let least_deg = near.0.results.number("half_angle_min_deg");
        DesignLimit::new(LimitedQuantity::HalfAngle, least_deg, "slip")
    });
    let limits = [
        DesignLimit::new(LimitedQuantity::AxialSpan, span_mm, "Eq. (8)"),
        DesignLimit::new(
            LimitedQuantity::HalfAngle,
            three_balls_deg,
            "three balls inside",
        ),
    ];
    DesignCurve {
        paper: Vec::from_iter(own.axial_span_mm.is_finite().then(|| own.clone())),
        limits: limits.into_iter().chain(near).collect(),
        provenance: Provenance {
            case: file.particulars().title.clone(),
            ..Provenance::default()
        },
        ..DesignCurve::new(&points, number("uniform_gap_deg"))
    }
}
