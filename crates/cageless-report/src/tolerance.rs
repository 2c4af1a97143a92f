//! The page of a bearing within its tolerances.

pub use cageless_study::tolerance::{InfluenceRow, SampleData, ToleranceData, VerdictCount};
use serde_json::json;

use crate::figure::Figure;
use crate::page::{Note, Page};
use crate::plot::{GREY, PALETTE, Plot, number, numbers};
use crate::table::{Cell, Row, Table};
use crate::text::{pass_word, short};

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
            Cell::text("nominal"),
            Cell::text(""),
            Cell::text(""),
            number(data.nominal_critical_gap_deg, 4),
            number(data.nominal_double_collision_fraction.map(|s| 100.0 * s), 0),
            number(data.nominal_sliding_m_s, 3),
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
            range(
                row.double_collision_fraction.map(|s| s.map(|v| 100.0 * v)),
                0,
            ),
            range(row.sliding_mean_m_s, 3),
            Cell::text(format!("{} of {}", row.passed, row.trials)),
            Cell::text(row.verdicts.join(", ")),
        ],
        ..Row::default()
    }));
    Table {
        label: "Table 1".to_owned(),
        caption: format!(
            "Each influence at both ends of its range, all else nominal; numbers span these and the \
             bearing nominal{}. Machining errors of the \
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
            ("Double collisions (% of passages)", true),
            ("Sliding speed per passage (m/s)", true),
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
        plot = mark(plot, nominal, "nominal", 1.0, "solid");
    }
    Figure {
        label: "Figure 1".to_owned(),
        caption: "Critical gap at the ends of each range and nominal value (line).".to_owned(),
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
             others (seed {}); the nominal verdict is highlighted.",
            samples.count, samples.seed
        ),
        columns: vec![
            ("Verdict".to_owned(), false),
            ("Pass or fail".to_owned(), false),
            ("Bearings".to_owned(), true),
            ("Fraction (%)".to_owned(), true),
        ],
        rows,
        provenance: Some(data.provenance.clone()),
        ..Table::default()
    }
}

/// Critical gaps of the bearings of the Monte Carlo sample, by verdict.
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
        plot = mark(plot, nominal, "nominal", 1.0, "solid");
    }
    let uniform = data.uniform_gap_deg;
    let quantiles = samples
        .quantiles_text()
        .map_or(String::new(), |text| format!(" {text}."));
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
