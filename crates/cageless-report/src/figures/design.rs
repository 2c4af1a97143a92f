//! Choice of the discrete raceway: θ over lC (Fig. 5), and Table 2 as figures.

use serde_json::{Value, json};

use crate::data::Provenance;
use crate::figure::Figure;
use crate::plot::{Margin, PALETTE, Plot, Trace, line, markers, number, plain, with};
use crate::reproduce_data::{
    DesignCurve, DesignLimit, LimitedQuantity, Table2, Table2Row, Variant,
};
use crate::sampling::range;
use crate::text::broken;

/// Fig. 5: θ over lC that satisfies Zhao 2022, Eq. (11), with the paper's structures.
pub fn curve(design: &DesignCurve) -> Figure {
    let spans = &design.axial_span_mm;
    let mut plot = Plot::new(470)
        .legend()
        .axes("Axial span lC (mm)", "Half angle θ of the raceway (°)")
        .trace(line("Eq. (11)", spans, &design.half_angle_deg, PALETTE[0]).width(2.2));
    if !design.half_angle_polar_deg.is_empty() {
        let (name, angles) = (
            "Eq. (11) with the ball's own ψ",
            &design.half_angle_polar_deg,
        );
        let polar = line(name, spans, angles, PALETTE[2]);
        plot = plot.trace(polar.dash("dash").width(1.8));
    }
    let (legend, shown) = match design.paper.as_slice() {
        [] => ("", String::new()),
        [first, .., last] if !first.letter.is_empty() => (
            "structures of the paper",
            format!(
                ", the paper's structures ({}) to ({})",
                first.letter, last.letter
            ),
        ),
        _ => (
            "structure of the case",
            ", and the structure of the case".to_owned(),
        ),
    };
    let spans: Vec<f64> = design.paper.iter().map(|s| s.axial_span_mm).collect();
    let angles: Vec<f64> = design.paper.iter().map(|s| s.half_angle_deg).collect();
    let letters: Value = design.paper.iter().map(|s| plain(&s.letter)).collect();
    let structures = markers(legend, &spans, &angles, PALETTE[1]);
    plot = plot.trace(structures.with(json!({
        "mode": "markers+text", "text": letters, "textposition": "top right",
        "hovertemplate": "(%{text}) lC %{x} mm, θ %{y}°<extra></extra>",
    })));
    plot = design.limits.iter().fold(plot, limited);
    let caption = format!(
        "Half angle θ over axial span lC of the discrete raceways that restore the uniform \
             gap of {:.4}° (Zhao 2022, Eq. (10), (11)){}, and the limits on both.",
        design.uniform_gap_deg, shown,
    );
    Figure::new("Figure 5", &caption, &design.provenance, plot)
}

/// A plot with the line of a limit.
fn limited(plot: Plot, limit: &DesignLimit) -> Plot {
    let label = plain(&limit.label);
    let small = json!({ "font": { "size": 11, "color": "#555" } });
    match limit.quantity {
        LimitedQuantity::AxialSpan => plot.vertical("x", "y", limit.value, "dash").text(
            &label,
            (limit.value, 0.98),
            ("x", "y domain"),
            with(
                json!({ "xanchor": "right", "yanchor": "top", "textangle": -90 }),
                small,
            ),
        ),
        LimitedQuantity::HalfAngle => plot.horizontal("x", "y", limit.value, "dash").text(
            &label,
            (0.985, limit.value),
            ("x domain", "y"),
            with(json!({ "xanchor": "right", "yanchor": "bottom" }), small),
        ),
    }
}

/// Table 2 at a glance: the paper's simulated gaps of its structures, its theory, and what the published and the
/// consistent equations give.
pub fn table2_overview(table: &Table2) -> Figure {
    let letter = |row: &Table2Row| plain(&format!("({})", row.structure.letter));
    let letters: Value = table.rows.iter().map(letter).collect();
    let series = |name: &str, of: &dyn Fn(&Table2Row) -> Option<f64>, style: Value| {
        let gap = |row| number(of(row).unwrap_or(f64::NAN));
        let gaps: Value = table.rows.iter().map(gap).collect();
        let trace = json!({ "type": "scatter", "name": name, "x": letters, "y": gaps });
        Trace(with(trace, style))
    };
    let grey = json!({ "color": "#777777", "dash": "dash", "width": 1.5 });
    let theory = json!({ "mode": "lines", "line": grey });
    let mut plot = Plot::new(350)
        .margin(Margin {
            left: 64,
            right: 16,
            bottom: 46,
            ..Margin::default()
        })
        .legend()
        .x("", json!({ "type": "category" }))
        .y("Critical gap (°)", json!({}))
        .trace(series("theory", &|row| Some(row.theory_deg), theory));
    for (reading, name, symbol, colour) in [
        (
            ["paper", "coulomb"],
            "published equations",
            "square-open",
            PALETTE[0],
        ),
        (
            ["physical", "smooth"],
            "consistent equations",
            "circle-open",
            PALETTE[1],
        ),
    ] {
        let is = |of: &Variant| [of.formulation.as_str(), of.friction_law.as_str()] == reading;
        if let Some(column) = table.variants.iter().position(is) {
            let gap = |row: &Table2Row| row.critical_gap_deg.get(column).copied().flatten();
            let style = json!({
                "mode": "lines+markers", "line": { "color": colour, "width": 1.5 },
                "marker": { "symbol": symbol, "size": 9, "color": colour },
            });
            plot = plot.trace(series(name, &gap, style));
        }
    }
    let cross = json!({ "symbol": "x", "size": 9, "color": "#111111" });
    let crosses = json!({ "mode": "markers", "marker": cross });
    plot = plot.trace(series(
        "paper, simulated",
        &|row| Some(row.paper_simulated_deg),
        crosses,
    ));
    let plot = remarked(plot, table);
    let caption = "Critical gaps of the structures (a) to (j): the paper's simulated values, computed with the \
                   published and with mechanically consistent equations, and the theory of Eq. (11).";
    Figure::new("Table 2, drawn", caption, &Provenance::default(), plot)
}

/// A plot of Table 2 with the remarks on its rows.
fn remarked(mut plot: Plot, table: &Table2) -> Plot {
    let rows = table.rows.iter().enumerate();
    for (k, row) in rows.filter(|(_, row)| !row.remark.is_empty()) {
        let at = (k as f64, row.paper_simulated_deg);
        let arrow = json!({
            "showarrow": true, "arrowhead": 0, "arrowcolor": "#777", "ax": 14, "ay": -40,
            "font": { "size": 11, "color": "#555" },
        });
        plot = plot.text(&broken(&plain(&row.remark)), at, ("x", "y"), arrow);
    }
    plot
}

/// Table 2 drawn: critical gap over θ, per variant, with the paper's columns.
pub fn table2(table: &Table2) -> Figure {
    let column =
        |of: &dyn Fn(&Table2Row) -> f64| -> Vec<f64> { table.rows.iter().map(of).collect() };
    let theta = column(&|r| r.structure.half_angle_deg);
    let theory = column(&|r| r.theory_deg);
    let paper = column(&|r| r.paper_simulated_deg);
    let mut plot = Plot::new(460)
        .legend()
        .y("Critical gap (°)", json!({}))
        .trace(line("theory, Eq. (11)", &theta, &theory, "#777777").dash("dash"));
    let symbols = [
        "square-open",
        "diamond-open",
        "triangle-up-open",
        "triangle-down-open",
        "circle-open",
    ];
    let colours = [PALETTE[0], PALETTE[5], PALETTE[2], PALETTE[4], PALETTE[1]];
    for (k, variant) in table.variants.iter().enumerate() {
        let gap = |r: &Table2Row| r.critical_gap_deg.get(k).copied().flatten();
        let gaps = column(&|r| gap(r).unwrap_or(f64::NAN));
        let name = format!("{}, {}", variant.formulation, variant.friction_law);
        let marker = json!({ "symbol": symbols[k % symbols.len()], "size": 8 });
        let gaps = line(&name, &theta, &gaps, colours[k % colours.len()]);
        plot = plot.trace(gaps.with(json!({ "mode": "lines+markers", "marker": marker })));
    }
    let crosses = markers("paper, simulated", &theta, &paper, "#111111");
    plot = plot.trace(crosses.with(json!({ "marker": { "symbol": "x", "size": 9 } })));
    for row in table.rows.iter().filter(|r| !r.remark.is_empty()) {
        let at = (row.structure.half_angle_deg, row.paper_simulated_deg);
        plot = plot.text(
            &plain(&format!("lC {:.2} mm", row.structure.axial_span_mm)),
            at,
            ("x", "y"),
            json!({
                "showarrow": true, "arrowhead": 0, "arrowcolor": "#777", "ax": -10, "ay": -34,
                "font": { "size": 11, "color": "#555" },
            }),
        );
    }
    let (low, high) = range(&theta);
    let room = (high - low) * 0.04;
    let shown = json!({ "range": [number(low - room), number(high + room)] });
    plot = plot.x("Half angle θ of the raceway (°)", shown);
    let caption = "Critical gap over θ: the paper's simulated column (crosses), the computed \
                  variants, and the theory that supposes rolling without sliding.";
    Figure::new(
        "Table 2 over θ, all readings",
        caption,
        &table.provenance,
        plot,
    )
}
