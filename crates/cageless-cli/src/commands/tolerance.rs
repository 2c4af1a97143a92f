//! `cageless tolerance`.

use cageless_report::text::pass_word;
use cageless_report::to_json;
use cageless_report::tolerance::{ToleranceData, tolerance_page};
use cageless_study::tolerance::{Request, tolerance as study};

use crate::args::ToleranceArgs;
use crate::driver::{Answer, PAGE, read_case};
use crate::failure::Failure;
use crate::format::{columns, judged};

const NUMBERS: &str = "tolerance.json";

/// Judges the bearing within its tolerances.
pub fn tolerance(args: &ToleranceArgs) -> Result<(), Failure> {
    let file = read_case(&args.case)?;
    let name = args.case.case.display().to_string();
    let request = Request {
        samples: args.samples,
        groove_depth_um: args.groove_depth_um,
        axial_span_um: args.axial_span_um,
        half_angle_deg: args.half_angle_deg,
        ball_grade: args.ball_grade,
        friction: args.friction,
        clearance_um: args.clearance_um,
        speed_percent: args.speed_percent,
        load_percent: args.load_percent,
    };
    // Bad input leaves no folder behind.
    request.check(file.case(), &name)?;
    let output = &args.case.output;
    output.drive(&[PAGE, NUMBERS], |bars| {
        let data = study(file.case(), &name, &request, bars)?;
        Ok(Answer {
            files: output.files(|| Ok(vec![(PAGE, Some(tolerance_page(&data)))]))?,
            ..Answer::new(NUMBERS, to_json(&data)? + "\n", text(&data))
        })
    })
}

fn text(data: &ToleranceData) -> String {
    let range = |range: Option<[f64; 2]>, digits: usize| {
        range.map_or("–".to_owned(), |[low, high]| {
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
            "sliding speed, m/s",
            "pass",
            "verdicts",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    for row in &data.influences {
        rows.push(vec![
            row.name.clone(),
            // Not -0.000.
            format!("{:.3}", row.low + 0.0),
            format!("{:.3}", row.high),
            row.unit.clone(),
            range(row.critical_gap_deg, 4),
            range(row.sliding_mean_m_s, 3),
            format!("{} of {}", row.passed, row.trials),
            row.verdicts.join(", "),
        ]);
    }
    let mut text = format!(
        "{}\nnominal: {}, critical gap {}\n\n{}",
        judged(Some(data.passes), &data.headline),
        data.nominal_verdict,
        data.nominal_critical_gap_deg
            .map_or("–".to_owned(), |gap| format!("{gap:.4}°")),
        columns(&rows)
    );
    if let Some(s) = &data.samples {
        text += &format!(
            "\n{} bearings of the Monte Carlo sample: probability of passing {:.1} % (95 %: \
             {:.1} to {:.1} %)\n",
            s.count,
            100.0 * s.pass_probability,
            100.0 * s.pass_probability_interval[0],
            100.0 * s.pass_probability_interval[1]
        );
        for verdict in &s.verdicts {
            text += &format!(
                "  {} ({}): {}\n",
                verdict.verdict,
                pass_word(verdict.passes),
                verdict.count
            );
        }
        if let Some(quantiles) = s.quantiles_text() {
            text += &format!("  {quantiles}\n");
        }
    }
    text
}
