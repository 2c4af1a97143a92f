//! Choice of the discrete raceway: θ over lC (Fig. 5) and Table 2 as a figure.

use serde_json::{Value, json};

use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line, markers, number, plain, with};
use crate::reproduce_data::{DesignCurve, LimitedQuantity, Table2, Table2Row};
use crate::sampling::range;

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
    for limit in &design.limits {
        let label = plain(&limit.label);
        let small = json!({ "font": { "size": 11, "color": "#555" } });
        plot = match limit.quantity {
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
        };
    }
    let caption = format!(
        "Half angle θ over axial span lC of the discrete raceways that restore the uniform \
             gap of {:.4}° (Zhao 2022, Eq. (10), (11)){}, and the limits on both.",
        design.uniform_gap_deg, shown,
    );
    Figure::new("Figure 5", &caption, &design.provenance, plot)
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
    Figure::new("Table 2 as a figure", caption, &table.provenance, plot)
}
