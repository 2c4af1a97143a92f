//! `cageless tolerance`.

use std::path::Path;

use cageless::Case;
use cageless::design::{Verdict, judge, steady_case};
use cageless::dynamics::InstructionSet;
use cageless::spacing::CriticalGapError;
use cageless::tolerance::{
    Assessment, BALL_GRADES, Influence, Outcome, Tolerances, Trial, assess, ball_grade, trials,
};
use cageless_io::results::{VERSION, write_atomically};
use cageless_report::run_report::provenance;
use cageless_report::tolerance::{
    InfluenceRow, SampleData, ToleranceData, VerdictCount, tolerance_page,
};
use cageless_report::{Provenance, to_json};
use cageless_study::Work;
use rayon::prelude::*;

use super::{make_folder, print, read_case, writable};
use crate::args::ToleranceArgs;
use crate::failure::Failure;
use crate::format::columns;
use crate::progress::{Progress, catch_interrupt};

const PAGE: &str = "report.html";
const NUMBERS: &str = "tolerance.json";
/// More would take days.
const SAMPLES_MAX: u64 = 100_000;

/// Judges the bearing within its tolerances.
pub fn tolerance(args: &ToleranceArgs) -> Result<(), Failure> {
    let file = read_case(&args.case)?;
    let case = file.case();
    let tolerances = tolerances(args, case)?;
    if let Some(dir) = &args.case.out {
        make_folder(dir)?;
        for name in [PAGE, NUMBERS] {
            writable(&dir.join(name))?;
        }
    }
    let trials = trials(case, &tolerances, args.samples, case.seed);
    let outcomes = judge_all(case, &trials)?;
    if outcomes[0].verdict == Verdict::Infeasible {
        return Err(Failure::Input(format!(
            "{}: the raceway as drawn is infeasible, and so are its tolerances: {}",
            args.case.case.display(),
            outcomes[0].reason.as_deref().unwrap_or_default()
        )));
    }
    let assessment = assess(&trials, &outcomes);
    let data = data(case, args, &tolerances, &assessment);
    let json = to_json(&data)?;
    if let Some(dir) = &args.case.out {
        write(dir, &data, &json)?;
    }
    print(&if args.case.json {
        json + "\n"
    } else {
        text(&data)
    })
}

fn write(dir: &Path, data: &ToleranceData, json: &str) -> Result<(), Failure> {
    write_atomically(&dir.join(NUMBERS), json.as_bytes())?;
    write_atomically(&dir.join(PAGE), tolerance_page(data).as_bytes())?;
    Ok(())
}

fn refused(flag: &str, value: &str, allowed: &str) -> Failure {
    Failure::Input(format!(
        "--{flag} {value} is not possible: it must be {allowed}"
    ))
}

fn tolerances(args: &ToleranceArgs, case: &Case) -> Result<Tolerances, Failure> {
    if case.raceways.is_empty() {
        return Err(Failure::Input(format!(
            "{}: there is no [raceway] whose verdict could hold",
            args.case.case.display()
        )));
    }
    if args.samples > SAMPLES_MAX {
        let allowed = format!("at most {SAMPLES_MAX}");
        return Err(refused("samples", &args.samples.to_string(), &allowed));
    }
    let half_angle = case
        .raceways
        .iter()
        .map(|r| r.half_angle_rad().to_degrees());
    let span = case
        .raceways
        .iter()
        .map(|r| r.dimensions().axial_span_m * 1e6);
    let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
    for (flag, value, most) in [
        ("groove-depth-um", args.groove_depth_um, f64::INFINITY),
        (
            "axial-span-um",
            args.axial_span_um,
            least(&mut span.into_iter()),
        ),
        (
            "half-angle-deg",
            args.half_angle_deg,
            least(&mut half_angle.into_iter()),
        ),
        ("friction", args.friction, case.contact.friction_coefficient),
        ("clearance-um", args.clearance_um, f64::INFINITY),
        ("speed-percent", args.speed_percent, 100.0),
        ("load-percent", args.load_percent, 100.0),
    ] {
        if !(value >= 0.0 && value <= most && value.is_finite()) {
            let allowed = if most.is_finite() {
                format!("from 0 to {most:.6}")
            } else {
                "0 or more".to_owned()
            };
            return Err(refused(flag, &value.to_string(), &allowed));
        }
    }
    let grade = ball_grade(args.ball_grade);
    if grade.is_none() && args.ball_grade != 0 {
        let grades: Vec<String> = BALL_GRADES.iter().map(|g| g.number.to_string()).collect();
        let allowed = format!("a grade of ISO 3290-1 ({}), or 0", grades.join(", "));
        return Err(refused(
            "ball-grade",
            &args.ball_grade.to_string(),
            &allowed,
        ));
    }
    Ok(Tolerances {
        groove_depth_m: args.groove_depth_um * 1e-6,
        axial_span_m: args.axial_span_um * 1e-6,
        half_angle_rad: args.half_angle_deg.to_radians(),
        ball_grade: grade,
        friction: args.friction,
        clearance_m: args.clearance_um * 1e-6,
        speed_share: args.speed_percent / 100.0,
        load_share: args.load_percent / 100.0,
    })
}

fn judge_all(case: &Case, trials: &[Trial]) -> Result<Vec<Outcome>, Failure> {
    let stop = catch_interrupt();
    let progress = Progress::new("tolerance", trials.len() as f64, &stop);
    let outcomes: Result<Vec<Outcome>, Failure> = trials
        .par_iter()
        .map(|trial| match trial.deviation.apply(case) {
            Err(error) => {
                progress.add(1.0);
                Ok(Outcome::impossible(error.to_string()))
            }
            Ok(varied) => {
                let duration_s = steady_case(&varied).solver.duration_s;
                match judge(&varied, &mut progress.run_control(duration_s, 1.0)) {
                    Ok(judgement) => Ok(Outcome::judged(&judgement)),
                    Err(CriticalGapError::Case(error)) => {
                        Ok(Outcome::impossible(error.to_string()))
                    }
                    Err(error) => Err(error.into()),
                }
            }
        })
        .collect();
    if progress.interrupted() {
        return Err(Failure::Interrupted(
            "interrupted before there was a result".to_owned(),
        ));
    }
    outcomes
}

/// Value and unit of an influence's range in the units of the drawing.
fn shown_range(influence: Influence, [low, high]: [f64; 2]) -> ([f64; 2], &'static str) {
    let (factor, unit) = match influence {
        Influence::GrooveDepth
        | Influence::AxialSpan
        | Influence::BallRadius
        | Influence::Clearance => (1e6, "µm"),
        Influence::HalfAngle => (1f64.to_degrees(), "°"),
        Influence::Friction => (1.0, ""),
        Influence::Speed => (30.0 / std::f64::consts::PI, "rpm"),
        Influence::Load => (1.0, "N"),
    };
    ([low * factor, high * factor], unit)
}

fn data(
    case: &Case,
    args: &ToleranceArgs,
    tolerances: &Tolerances,
    a: &Assessment,
) -> ToleranceData {
    let degrees = |range: Option<[f64; 2]>| range.map(|r| r.map(f64::to_degrees));
    ToleranceData {
        title: format!("Tolerances: {}", case.title),
        software: format!("Cageless {VERSION}, {}", InstructionSet::chosen().name()),
        provenance: Provenance {
            discarded: "the first 16 orbits of each run".to_owned(),
            ..provenance(case, String::new())
        },
        ball_grade: args.ball_grade,
        nominal_verdict: a.nominal.verdict.name().to_owned(),
        nominal_critical_gap_deg: a.nominal.critical_gap_rad.map(f64::to_degrees),
        nominal_twice_share: a.nominal.twice_share,
        nominal_slip_m_s: a.nominal.slip_mean_m_s,
        uniform_gap_deg: case.bearing.uniform_gap_rad().to_degrees(),
        influences: a
            .influences
            .iter()
            .map(|row| {
                let (range, unit) =
                    shown_range(row.influence, tolerances.range(case, row.influence));
                InfluenceRow {
                    name: row.influence.name().to_owned(),
                    low: range[0],
                    high: range[1],
                    unit: unit.to_owned(),
                    trials: row.trials,
                    held: row.held,
                    verdicts: row.verdicts.iter().map(|v| v.name().to_owned()).collect(),
                    critical_gap_deg: degrees(row.critical_gap_rad),
                    twice_share: row.twice_share,
                    slip_mean_m_s: row.slip_mean_m_s,
                }
            })
            .collect(),
        samples: a.samples.as_ref().map(|s| SampleData {
            count: s.count,
            seed: case.seed,
            held: s.held,
            probability: s.probability,
            probability_interval: s.probability_interval,
            verdicts: s
                .verdicts
                .iter()
                .map(|(verdict, count)| VerdictCount {
                    verdict: verdict.name().to_owned(),
                    count: *count,
                    critical_gap_deg: s
                        .outcomes
                        .iter()
                        .filter(|o| o.verdict == *verdict)
                        .filter_map(|o| o.critical_gap_rad.map(f64::to_degrees))
                        .collect(),
                })
                .collect(),
            critical_gap_quantiles_deg: s
                .critical_gap_quantiles_rad
                .map(|q| q.map(f64::to_degrees)),
            first_impossible: s.outcomes.iter().find_map(|o| o.reason.clone()),
        }),
    }
}

fn text(data: &ToleranceData) -> String {
    let range = |range: Option<[f64; 2]>, digits: usize| {
        range.map_or("-".to_owned(), |[low, high]| {
            format!("{low:.digits$} to {high:.digits$}")
        })
    };
    let mut rows = vec![
        [
            "deviates",
            "from",
            "to",
            "",
            "critical gap, °",
            "slip, m/s",
            "verdict holds",
            "verdicts",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    for row in &data.influences {
        rows.push(vec![
            row.name.clone(),
            format!("{:.3}", row.low),
            format!("{:.3}", row.high),
            row.unit.clone(),
            range(row.critical_gap_deg, 4),
            range(row.slip_mean_m_s, 3),
            format!("{} of {}", row.held, row.trials),
            row.verdicts.join(", "),
        ]);
    }
    let mut text = format!(
        "as drawn: {}, critical gap {}\n\n{}",
        data.nominal_verdict,
        data.nominal_critical_gap_deg
            .map_or("-".to_owned(), |gap| format!("{gap:.4}°")),
        columns(&rows)
    );
    if let Some(s) = &data.samples {
        text += &format!(
            "\n{} bearings in which everything deviates: the verdict holds with probability \
             {:.1} % (95 %: {:.1} to {:.1} %)\n",
            s.count,
            100.0 * s.probability,
            100.0 * s.probability_interval[0],
            100.0 * s.probability_interval[1]
        );
        for verdict in &s.verdicts {
            text += &format!("  {}: {}\n", verdict.verdict, verdict.count);
        }
        if let Some([low, middle, high]) = s.critical_gap_quantiles_deg {
            text +=
                &format!("  critical gap, 5 %, 50 %, 95 %: {low:.4}°, {middle:.4}°, {high:.4}°\n");
        }
    }
    text
}
