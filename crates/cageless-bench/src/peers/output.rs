//! Table, JSON and page of the comparison.

use anyhow::{Context, Result};
use cageless_report::Page;
use cageless_report::data::Provenance;
use cageless_report::figure::Figure;
use cageless_report::plot::{PALETTE, Plot, line, with};
use cageless_report::table::{Cell, Row, Table};
use serde::Serialize;
use serde_json::json;

use super::{Curve, Options, Point};

/// Everything that was measured.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    version: &'static str,
    case: &'static str,
    instruction_set: &'static str,
    window_ms: f64,
    at_error: f64,
    notes: &'a [String],
    curves: &'a [Curve],
    comparison: Vec<Comparison<'a>>,
}

/// One solver at the error of comparison.
#[derive(Serialize)]
struct Comparison<'a> {
    name: &'a str,
    equations: &'static str,
    /// Wall seconds per simulated second, fastest repetitions.
    least: Option<f64>,
    /// Likewise, medians.
    median: Option<f64>,
    /// `median` over that of the fastest method of Cageless.
    ratio: Option<f64>,
    /// `least` over that of the fastest method of Cageless.
    ratio_of_least: Option<f64>,
}

/// Prints the tables and writes `peers.json` and `peers.html`.
///
/// # Errors
/// A file cannot be written.
pub fn write(curves: &[Curve], notes: &[String], options: &Options) -> Result<()> {
    let comparison = compare(curves, options.at_error);
    print_points(curves);
    println!();
    print_comparison(&comparison, options.at_error);
    let out = &options.out;
    std::fs::create_dir_all(out).with_context(|| out.display().to_string())?;
    let document = Document {
        schema: 1,
        version: env!("CARGO_PKG_VERSION"),
        case: "cb74",
        instruction_set: cageless::dynamics::InstructionSet::detect().name(),
        window_ms: options.window_ms,
        at_error: options.at_error,
        notes,
        curves,
        comparison,
    };
    let page = page(&document, options);
    for (name, text) in [
        ("peers.json", serde_json::to_string_pretty(&document)?),
        ("peers.html", page),
    ] {
        let path = out.join(name);
        std::fs::write(&path, text).with_context(|| path.display().to_string())?;
        eprintln!("wrote {}", path.display());
    }
    Ok(())
}

fn compare(curves: &[Curve], at_error: f64) -> Vec<Comparison<'_>> {
    let best = |time: fn(&Point) -> f64| {
        curves
            .iter()
            .filter(|curve| curve.name.starts_with("Cageless"))
            .filter_map(|curve| curve.time_at(at_error, time))
            .fold(f64::INFINITY, f64::min)
    };
    let (own_least, own_median) = (best(Point::least), best(Point::median));
    curves
        .iter()
        .map(|curve| {
            let least = curve.time_at(at_error, Point::least);
            let median = curve.time_at(at_error, Point::median);
            Comparison {
                name: &curve.name,
                equations: curve.equations,
                least,
                median,
                ratio: median.map(|t| t / own_median).filter(|r| *r > 0.0),
                ratio_of_least: least.map(|t| t / own_least).filter(|r| *r > 0.0),
            }
        })
        .collect()
}

fn print_points(curves: &[Curve]) {
    println!("Wall seconds per simulated second and RMS scaled error at 2 ms, case CB74");
    println!(
        "{:<22} {:<9} {:<10} {:>8} {:>9} {:>12} {:>9} {:>9}",
        "solver", "equations", "setting", "", "error", "evaluations", "min", "median"
    );
    for curve in curves {
        for point in &curve.points {
            let error = point
                .error
                .map_or("-".to_owned(), |error| format!("{error:.2e}"));
            let setting = if point.setting < 0.01 {
                format!("{:e}", point.setting)
            } else {
                point.setting.to_string()
            };
            print!(
                "{:<22} {:<9} {:<10} {setting:>8} {error:>9}",
                curve.name, curve.equations, curve.setting_name
            );
            match &point.failure {
                Some(failure) => println!("  {failure}"),
                None => println!(
                    " {:>12.3e} {:>9.3} {:>9.3}",
                    point.evaluations_per_s,
                    point.least(),
                    point.median()
                ),
            }
        }
    }
}

fn optional(value: Option<f64>, digits: usize) -> String {
    value.map_or("not reached".to_owned(), |v| format!("{v:.digits$}"))
}

fn print_comparison(comparison: &[Comparison<'_>], at_error: f64) {
    println!("At error {at_error:e} (interpolated), ratio to the fastest method of Cageless");
    println!(
        "{:<22} {:<9} {:>12} {:>12} {:>12} {:>12}",
        "solver", "equations", "min s/s", "median s/s", "ratio (min)", "ratio (med)"
    );
    for row in comparison {
        println!(
            "{:<22} {:<9} {:>12} {:>12} {:>12} {:>12}",
            row.name,
            row.equations,
            optional(row.least, 3),
            optional(row.median, 3),
            row.ratio_of_least.map_or("-".into(), |r| format!("{r:.1}")),
            row.ratio.map_or("-".into(), |r| format!("{r:.1}")),
        );
    }
}

fn page(document: &Document<'_>, options: &Options) -> String {
    let provenance = Provenance {
        case: "CB74: 14 balls and ring, 74 states, undamped".into(),
        profile: Some("physical".into()),
        friction_law: Some("smooth, 0.02 m/s".into()),
        ..Provenance::default()
    };
    let mut page = Page::new(
        "Work against precision",
        "Wall time per simulated second against the error at 2 ms of the reference \
         trajectory. Down and left is better.",
        &format!(
            "Cageless {} · {} · windows of {} ms, {} repetitions in turns, median",
            document.version, document.instruction_set, options.window_ms, options.repetitions
        ),
    );
    page.section("Figure");
    page.figure(&Figure {
        label: "Figure 1".into(),
        caption: "Every solver over its steps or tolerances. Full lines: the right-hand side \
                  of the library; dashed: a scalar textbook one."
            .into(),
        provenance: provenance.clone(),
        plot: plot(document.curves),
    });
    page.section("At one error");
    page.table(&table(document, provenance));
    for note in document.notes {
        page.paragraph(note);
    }
    page.html()
}

fn plot(curves: &[Curve]) -> Plot {
    let log = json!({ "type": "log", "exponentformat": "power", "dtick": 1 });
    let mut plot = Plot::new(560)
        .legend()
        .axis("xaxis", "wall seconds per simulated second", log.clone())
        .axis("yaxis", "RMS scaled error at 2 ms", log);
    let mut names: Vec<&str> = vec![];
    for curve in curves {
        if !names.contains(&curve.name.as_str()) {
            names.push(&curve.name);
        }
    }
    for curve in curves {
        let at = names.iter().position(|n| *n == curve.name).unwrap_or(0);
        let (x, y): (Vec<_>, Vec<_>) = curve
            .points
            .iter()
            .filter_map(|p| Some((p.median(), p.error?)))
            .filter(|(time, _)| time.is_finite())
            .unzip();
        let name = format!("{}, {}", curve.name, curve.equations);
        let own = curve.name.starts_with("Cageless");
        let dash = if curve.equations == "library" {
            "solid"
        } else {
            "dash"
        };
        plot = plot.trace(with(
            line(&name, &x, &y, PALETTE[at % PALETTE.len()]),
            json!({
                "mode": "lines+markers",
                "line": { "dash": dash, "width": if own { 3.0 } else { 1.4 } },
            }),
        ));
    }
    plot
}

fn table(document: &Document<'_>, provenance: Provenance) -> Table {
    let columns = [
        "solver",
        "right-hand side",
        "s/s, min",
        "s/s, median",
        "ratio",
    ];
    Table {
        label: "Table 1".into(),
        caption: format!(
            "Wall seconds per simulated second at error {:e}, interpolated, and the ratio of \
             the medians to the fastest method of Cageless.",
            document.at_error
        ),
        columns: columns
            .iter()
            .enumerate()
            .map(|(k, name)| ((*name).to_owned(), k > 1))
            .collect(),
        rows: document
            .comparison
            .iter()
            .map(|row| Row {
                cells: vec![
                    Cell::text(row.name),
                    Cell::text(row.equations),
                    Cell::number(optional(row.least, 3)),
                    Cell::number(optional(row.median, 3)),
                    Cell::number(row.ratio.map_or("-".into(), |r| format!("{r:.1}"))),
                ],
                marked: row.name.starts_with("Cageless"),
                summary: false,
            })
            .collect(),
        provenance: Some(provenance),
        ..Table::default()
    }
}
