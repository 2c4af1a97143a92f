//! The page of a bearing within its tolerances.

use serde::Serialize;
use serde_json::json;

use crate::data::Provenance;
use crate::figure::Figure;
use crate::page::{Note, Page};
use crate::plot::{GREY, PALETTE, Plot, number, numbers};
use crate::table::{Cell, Row, Table};
use crate::text::{pass_word, short};

/// One influence on its own.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InfluenceRow {
    /// What deviates.
    pub name: String,
    /// Lowest and highest deviation, in `unit`.
    pub low: f64,
    /// As above.
    pub high: f64,
    /// Unit of the deviation; empty for a pure number.
    pub unit: String,
    /// Bearings judged.
    pub trials: usize,
    /// Bearings that pass.
    pub passed: usize,
    /// Verdicts that came out.
    pub verdicts: Vec<String>,
    /// Smallest and largest critical gap, degrees.
    pub critical_gap_deg: Option<[f64; 2]>,
    /// Smallest and largest share of passages hit by both neighbours.
    pub twice_share: Option<[f64; 2]>,
    /// Smallest and largest mean slip per passage, m/s.
    pub slip_mean_m_s: Option<[f64; 2]>,
}

/// How often a verdict came out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VerdictCount {
    /// Its name.
    pub verdict: String,
    /// Whether a bearing with it passes.
    pub passes: Option<bool>,
    /// How often.
    pub count: usize,
    /// Critical gaps of these bearings, degrees.
    pub critical_gap_deg: Vec<f64>,
}

/// Bearings in which everything deviates.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SampleData {
    /// How many.
    pub count: usize,
    /// Seed that they come from.
    pub seed: u64,
    /// Bearings that pass.
    pub passed: usize,
    /// Probability of passing.
    pub pass_probability: f64,
    /// 95 % interval of the probability of passing.
    pub pass_probability_interval: [f64; 2],
    /// By verdict.
    pub verdicts: Vec<VerdictCount>,
    /// 5 %, 50 % and 95 % quantile of the critical gap, degrees.
    pub critical_gap_quantiles_deg: Option<[f64; 3]>,
    /// Why the first infeasible one is.
    pub first_impossible: Option<String>,
}

/// Everything on the page.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ToleranceData {
    /// Heading.
    pub title: String,
    /// Program and instruction set.
    pub software: String,
    /// Where the numbers come from.
    pub provenance: Provenance,
    /// Grade of the balls, 0 for equal ones.
    pub ball_grade: u32,
    /// Whether the tolerances pass: the bearing as drawn, and enough of those that deviate.
    pub passes: bool,
    /// PASS or FAIL with the probability of passing and the reason.
    pub headline: String,
    /// Whether the bearing as drawn passes.
    pub nominal_passes: bool,
    /// Verdict as drawn.
    pub nominal_verdict: String,
    /// Critical gap as drawn, degrees.
    pub nominal_critical_gap_deg: Option<f64>,
    /// Share of passages hit by both neighbours, as drawn.
    pub nominal_twice_share: Option<f64>,
    /// Mean slip per passage, as drawn, m/s.
    pub nominal_slip_m_s: Option<f64>,
    /// Gap of evenly spaced balls, degrees.
    pub uniform_gap_deg: f64,
    /// One influence at a time.
    pub influences: Vec<InfluenceRow>,
    /// All at once.
    pub samples: Option<SampleData>,
}

/// The self-contained page.
pub fn tolerance_page(data: &ToleranceData) -> String {
    let mut page = Page::new(&data.title, "", &data.software);
    page.verdict(Some(data.passes), &data.headline);
    page.section("One at a time");
    page.table(&influence_table(data));
    page.figure(&influence_figure(data));
    if let Some(samples) = &data.samples {
        page.section("All at once");
        if let Some(reason) = &samples.first_impossible {
            page.note(
                Note::Warning,
                &format!("The first infeasible bearing: {reason}"),
            );
        }
        page.table(&verdict_table(data, samples));
        page.figure(&sample_figure(data, samples));
    }
    page.html()
}

fn range(range: Option<[f64; 2]>, digits: usize) -> Cell {
    Cell::number(range.map_or("–".to_owned(), |[low, high]| {
        format!("{low:.digits$} … {high:.digits$}")
    }))
}

fn influence_table(data: &ToleranceData) -> Table {
    let number = |value: Option<f64>, digits: usize| {
        Cell::number(value.map_or("–".to_owned(), |v| format!("{v:.digits$}")))
    };
    let mut rows = vec![Row {
        cells: vec![
            Cell::text("as drawn"),
            Cell::text(""),
            Cell::text(""),
            number(data.nominal_critical_gap_deg, 4),
            number(data.nominal_twice_share.map(|s| 100.0 * s), 0),
            number(data.nominal_slip_m_s, 3),
            Cell::text(pass_word(Some(data.nominal_passes))),
            Cell::text(&data.nominal_verdict),
        ],
        marked: true,
        summary: false,
    }];
    rows.extend(data.influences.iter().map(|row| Row {
        cells: vec![
            Cell::text(&row.name),
            Cell::number(format!("{} … {}", short(row.low + 0.0), short(row.high))),
            Cell::text(&row.unit),
            range(row.critical_gap_deg, 4),
            range(row.twice_share.map(|s| s.map(|v| 100.0 * v)), 0),
            range(row.slip_mean_m_s, 3),
            Cell::text(format!("{} of {}", row.passed, row.trials)),
            Cell::text(row.verdicts.join(", ")),
        ],
        ..Row::default()
    }));
    Table {
        label: "Table 1".to_owned(),
        caption: format!(
            "Each influence at both ends of its range, all else as drawn; numbers span these and the \
             bearing as drawn{}. Machining errors of the \
             depth are largest in the middle of the raceway and run out at its ends.",
            match data.ball_grade {
                0 => String::new(),
                grade => format!(
                    "; balls: four lots of grade G{grade} (ISO 3290-1), each ball at random within \
                     the lot's variation"
                ),
            }
        ),
        columns: [
            ("Deviates", false),
            ("by", true),
            ("Unit", false),
            ("Critical gap (°)", true),
            ("Hit by both neighbours (% of passages)", true),
            ("Slip per passage (m/s)", true),
            ("Pass", false),
            ("Verdicts", false),
        ]
        .map(|(text, numeric)| (text.to_owned(), numeric))
        .to_vec(),
        rows,
        provenance: Some(data.provenance.clone()),
        ..Table::default()
    }
}

/// Range of the critical gap over each influence.
pub fn influence_figure(data: &ToleranceData) -> Figure {
    let rows: Vec<&InfluenceRow> = data
        .influences
        .iter()
        .filter(|row| row.critical_gap_deg.is_some())
        .rev()
        .collect();
    let names: Vec<&str> = rows.iter().map(|row| row.name.as_str()).collect();
    let ends: Vec<[f64; 2]> = rows.iter().filter_map(|row| row.critical_gap_deg).collect();
    let base: Vec<f64> = ends.iter().map(|[low, _]| *low).collect();
    let width: Vec<f64> = ends.iter().map(|[low, high]| high - low).collect();
    let mut plot = Plot::new(90 + 34 * rows.len().max(2) as u32)
        .set("margin", json!({ "l": 150, "r": 24, "t": 44, "b": 58 }))
        .axis("xaxis", "Critical gap (°)", json!({}))
        .axis("yaxis", "", json!({ "type": "category" }))
        .trace(json!({
            "type": "bar", "orientation": "h", "y": names, "x": numbers(&width),
            "base": numbers(&base), "marker": { "color": PALETTE[0] }, "width": 0.6,
            "hovertemplate": "%{y}: %{base:.4f} … %{x:.4f}°<extra></extra>",
        }));
    if let Some(nominal) = data.nominal_critical_gap_deg {
        plot = mark(plot, nominal, "as drawn", 1.0, "solid");
    }
    Figure {
        label: "Figure 1".to_owned(),
        caption: "Critical gap at the ends of each range and as drawn (the line).".to_owned(),
        provenance: data.provenance.clone(),
        plot,
    }
}

fn mark(plot: Plot, at: f64, text: &str, y: f64, dash: &str) -> Plot {
    plot.vertical("x", "y", at, dash).text(
        text,
        (at, y),
        ("x", "y domain"),
        json!({ "yanchor": "bottom", "font": { "size": 11, "color": "#555" } }),
    )
}

fn verdict_table(data: &ToleranceData, samples: &SampleData) -> Table {
    let rows = samples
        .verdicts
        .iter()
        .map(|v| Row {
            cells: vec![
                Cell::text(&v.verdict),
                Cell::text(pass_word(v.passes)),
                Cell::number(v.count.to_string()),
                Cell::number(format!(
                    "{:.1}",
                    100.0 * v.count as f64 / samples.count as f64
                )),
            ],
            marked: v.verdict == data.nominal_verdict,
            summary: false,
        })
        .collect();
    Table {
        label: "Table 2".to_owned(),
        caption: format!(
            "Verdicts on {} bearings, every deviation uniform within its range and independent of the \
             others (seed {}); the verdict as drawn is called out.",
            samples.count, samples.seed
        ),
        columns: vec![
            ("Verdict".to_owned(), false),
            ("Pass or fail".to_owned(), false),
            ("Bearings".to_owned(), true),
            ("Share (%)".to_owned(), true),
        ],
        rows,
        provenance: Some(data.provenance.clone()),
        ..Table::default()
    }
}

/// Critical gaps of the bearings in which everything deviates, by verdict.
pub fn sample_figure(data: &ToleranceData, samples: &SampleData) -> Figure {
    let mut plot = Plot::new(360)
        .legend()
        .set("barmode", json!("stack"))
        .set("margin", json!({ "l": 72, "r": 24, "t": 84, "b": 58 }))
        .set(
            "legend",
            json!({ "orientation": "h", "x": 0, "y": 1.09, "yanchor": "bottom" }),
        )
        .axis("xaxis", "Critical gap (°)", json!({}))
        .axis("yaxis", "Bearings", json!({ "rangemode": "tozero" }));
    let all: Vec<f64> = samples
        .verdicts
        .iter()
        .flat_map(|v| v.critical_gap_deg.iter().copied())
        .collect();
    let low = all.iter().copied().fold(f64::INFINITY, f64::min);
    let high = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // About the square root of the number, as bins.
    let bins = (all.len() as f64).sqrt().clamp(8.0, 40.0).round();
    for (k, verdict) in samples.verdicts.iter().enumerate() {
        if verdict.critical_gap_deg.is_empty() {
            continue;
        }
        plot = plot.trace(json!({
            "type": "histogram", "name": verdict.verdict,
            "x": numbers(&verdict.critical_gap_deg),
            "xbins": { "start": number(low), "end": number(high * (1.0 + 1e-9)), "size": number((high - low) / bins) },
            "marker": { "color": if k == 3 { GREY } else { PALETTE[[2, 4, 1][k]] } },
        }));
    }
    if let Some(nominal) = data.nominal_critical_gap_deg {
        plot = mark(plot, nominal, "as drawn", 1.0, "solid");
    }
    let uniform = data.uniform_gap_deg;
    let quantiles = samples
        .critical_gap_quantiles_deg
        .map_or(String::new(), |[a, b, c]| {
            format!(" 5 %, 50 % and 95 % lie at {a:.4}°, {b:.4}° and {c:.4}°.")
        });
    Figure {
        label: "Figure 2".to_owned(),
        caption: format!(
            "Critical gap of the bearings by verdict. Evenly spaced balls have a gap of \
             {uniform:.4}°.{quantiles}"
        ),
        provenance: data.provenance.clone(),
        plot,
    }
}
