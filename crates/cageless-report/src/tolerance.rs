//! The page of a bearing within its tolerances.

use cageless_results::{Record, table_of};
use cageless_study::lines;
use cageless_study::tolerance::ToleranceResult;
use serde_json::json;

use crate::compare::benefit_section;
use crate::figure::Figure;
use crate::head::Head;
use crate::page::{Note, Page};
use crate::plot::{Axes, GREY, Margin, PALETTE, Plot, number, numbers};
use crate::table::Table;

/// The self-contained page.
pub fn tolerance_page(result: &ToleranceResult) -> String {
    let record = &result.record;
    let mut page = Page::new(record.text("title"), "", record.text("software"));
    let mut head = Head::default();
    if let Some(benefit) = &result.benefit {
        head = head.verdict(benefit.helps(), &benefit.answer);
    }
    let head = head.verdict(record.flag("passes"), record.text("headline"));
    let head = head.dry(record);
    page.head(&head.facts(lines(record.rows())));
    page.notes(Note::Warning, record.sentences("warnings"));
    if let Some(benefit) = &result.benefit {
        benefit_section(&mut page, &benefit.comparison, &benefit.provenance);
    }
    page.section("One at a time");
    page.table(&influence_table(record));
    page.figure(&influence_figure(record));
    if let Some(samples) = record.part("samples") {
        page.section("All at once");
        if let Some(reason) = Some(samples.text("first_impossible")).filter(|r| !r.is_empty()) {
            let first = format!("The first infeasible bearing: {reason}");
            page.note(Note::Warning, &first);
        }
        let caption = "Every deviation is uniform within its range and independent of the others.";
        let (rows, source) = (lines(samples.rows()), record.provenance.as_ref());
        page.parameters("Monte Carlo sample", caption, &rows, source);
        page.table(&verdict_table(record, samples));
        page.figure(&sample_figure(record, samples));
    }
    page.html()
}

fn influence_table(record: &Record) -> Table {
    let balls = match record.number("ball_grade") {
        0.0 => String::new(),
        grade => format!(
            "; balls: four lots of grade G{grade} (ISO 3290-1), each ball at random within the lot's \
             variation"
        ),
    };
    let caption = format!(
        "Each influence at both ends of its range, all else nominal; numbers span these and the \
         bearing nominal{balls}. Machining errors of the depth are largest in the middle of the \
         raceway and run out at its ends."
    );
    Table::of(
        "Table 1",
        &caption,
        table_of(record.parts("influences")),
        record.provenance.clone(),
    )
}

/// Range of the critical gap over each influence.
pub fn influence_figure(record: &Record) -> Figure {
    let (mut names, mut base, mut width) = (vec![], vec![], vec![]);
    for row in record.parts("influences").iter().rev() {
        if let [low, high] = row.values("critical_gap_deg") {
            names.push(row.text("name"));
            base.push(*low);
            width.push(high - low);
        }
    }
    let plot = Plot::new(90 + 34 * names.len().max(2) as u32)
        .margin(Margin {
            left: 150,
            ..Margin::default()
        })
        .x("Critical gap (°)", json!({}))
        .y("", json!({ "type": "category" }))
        .trace(json!({
            "type": "bar", "orientation": "h", "y": names, "x": numbers(&width),
            "base": numbers(&base), "marker": { "color": PALETTE[0] }, "width": 0.6,
            "hovertemplate": "%{y}: %{base:.4f} … %{x:.4f}°<extra></extra>",
        }));
    let caption = "Critical gap at the ends of each range and nominal value (line).";
    Figure::of_record("Figure 1", caption, record, with_nominal(plot, record))
}

/// The plot with the critical gap of the nominal bearing, if it has one.
fn with_nominal(plot: Plot, record: &Record) -> Plot {
    match record.value("nominal_critical_gap_deg") {
        Some(gap_deg) => plot.marked(Axes::FIRST, gap_deg, "nominal", "solid"),
        None => plot,
    }
}

fn verdict_table(record: &Record, samples: &Record) -> Table {
    let caption = format!(
        "Verdicts on the bearings of the sample; the nominal one is {}.",
        record.text("nominal_verdict")
    );
    Table::of(
        "Table 2",
        &caption,
        table_of(samples.parts("verdicts")),
        record.provenance.clone(),
    )
}

/// Colour of the bearings with a verdict.
fn colour(verdict: &str) -> &'static str {
    match verdict {
        "smooth" => PALETTE[2],
        "double-collision" => PALETTE[4],
        "slips" => PALETTE[1],
        "loses-lag" => PALETTE[3],
        "overloaded" => PALETTE[5],
        _ => GREY,
    }
}

/// Critical gaps of the bearings of the Monte Carlo sample, by verdict.
pub fn sample_figure(record: &Record, samples: &Record) -> Figure {
    let mut plot = Plot::new(360)
        .legend()
        .set("barmode", json!("stack"))
        .margin(Margin::above(84))
        .set(
            "legend",
            json!({ "orientation": "h", "x": 0, "y": 1.09, "yanchor": "bottom" }),
        )
        .x("Critical gap (°)", json!({}))
        .y("Bearings", json!({ "rangemode": "tozero" }));
    let verdicts = samples.parts("verdicts");
    let gaps = verdicts.iter().map(|v| v.values("critical_gap_deg"));
    let all: Vec<f64> = gaps.flatten().copied().collect();
    let low = all.iter().copied().fold(f64::INFINITY, f64::min);
    let high = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // About the square root of the number, as bins.
    let bins = (all.len() as f64).sqrt().clamp(8.0, 40.0).round();
    for verdict in verdicts {
        let gaps = verdict.values("critical_gap_deg");
        if gaps.is_empty() {
            continue;
        }
        plot = plot.trace(json!({
            "type": "histogram", "name": verdict.text("verdict"),
            "x": numbers(gaps),
            "xbins": { "start": number(low), "end": number(high * (1.0 + 1e-9)), "size": number((high - low) / bins) },
            "marker": { "color": colour(verdict.text("verdict")) },
        }));
    }
    let caption = format!(
        "Critical gap of the bearings by verdict. Evenly spaced balls have a gap of {:.4}°.",
        record.number("uniform_gap_deg")
    );
    Figure::of_record("Figure 2", &caption, record, with_nominal(plot, record))
}
