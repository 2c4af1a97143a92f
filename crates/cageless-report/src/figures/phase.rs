//! Phase portraits of a ball, small multiples of one scale (Fig. 8).

use serde_json::json;

use super::panels::{axis_name, axis_ref, labelled, on, panel_title, panels};
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line, number, with};
use crate::reproduce_data::{PhasePortrait, PhasePortraits};
use crate::sampling::{curve, range};

/// Points of one of ten portraits.
const PORTRAIT_POINTS: usize = 3000;
/// Portraits in a row.
const COLUMNS: usize = 5;

/// Fig. 8: x-velocity against y-velocity, all on one scale.
pub fn velocities(portraits: &PhasePortraits) -> Figure {
    let most = portraits
        .portraits
        .iter()
        .flat_map(|p| [range(&p.vx_m_s), range(&p.vy_m_s)])
        .fold(1e-9, |most: f64, (low, high)| most.max(-low).max(high))
        * 1.06;
    let both = json!([number(-most), number(most)]);
    let plot = multiples(
        portraits,
        480,
        ("vx (m/s)", "vy (m/s)"),
        json!({ "range": both, "constrain": "domain" }),
        true,
        |p| (&p.vx_m_s, &p.vy_m_s),
    );
    Figure {
        label: labelled("Figure 8", &portraits.provenance),
        caption: "Phase portraits of ball 1: velocity of its centre, y against x, for the ten \
                  structures, all on one scale. The discrete raceway lies where vx is positive \
                  and vy small."
            .to_owned(),
        provenance: portraits.provenance.clone(),
        plot,
    }
}

/// Fig. 8, second set: x-velocity against x on the way through the loaded zone.
pub fn positions(portraits: &PhasePortraits) -> Figure {
    let ranges: Vec<(f64, f64)> = portraits
        .portraits
        .iter()
        .map(|p| range(&p.vx_m_s))
        .collect();
    let most = ranges
        .iter()
        .fold(1e-9, |most: f64, (_, high)| most.max(*high))
        * 1.02;
    let plot = multiples(
        portraits,
        480,
        ("x (mm)", "vx (m/s)"),
        json!({ "range": [number(0.55 * most), number(most)] }),
        false,
        |p| (&p.x_mm, &p.vx_m_s),
    );
    Figure {
        label: labelled("Figure 8, position and velocity", &portraits.provenance),
        caption: "The same turns as x-velocity against x, enlarged where the ball passes the \
                  bottom of the bearing; a double click shows all of a panel."
            .to_owned(),
        provenance: portraits.provenance.clone(),
        plot,
    }
}

fn multiples(
    portraits: &PhasePortraits,
    height_px: u32,
    (x_title, y_title): (&str, &str),
    y_more: serde_json::Value,
    equal: bool,
    of: impl Fn(&PhasePortrait) -> (&Vec<f64>, &Vec<f64>),
) -> Plot {
    let count = portraits.portraits.len();
    let rows = count.div_ceil(COLUMNS).max(1);
    let (across, down) = (panels(COLUMNS, 0.025), panels(rows, 0.24));
    let mut plot = Plot::new(height_px * rows as u32 / 2 + 66)
        .set("margin", json!({ "l": 62, "r": 12, "t": 78, "b": 54 }));
    for (k, portrait) in portraits.portraits.iter().enumerate() {
        let (row, column) = (k / COLUMNS, k % COLUMNS);
        let (x, y) = (axis_ref("x", k), axis_ref("y", k));
        let lowest = k + COLUMNS >= count;
        let small = json!({ "tickfont": { "size": 11 }, "nticks": 5, "automargin": false });
        let mut x_axis = with(
            small.clone(),
            json!({
                "domain": across[column], "anchor": y, "showticklabels": lowest,
            }),
        );
        if equal {
            x_axis = with(
                x_axis,
                json!({
                    "scaleanchor": y, "constrain": "domain", "range": y_more["range"],
                }),
            );
        } else {
            x_axis = with(
                x_axis,
                json!({ "matches": if k == 0 { None } else { Some("x") } }),
            );
        }
        let y_axis = with(
            with(small, y_more.clone()),
            json!({
                "domain": down[rows - 1 - row], "anchor": x, "showticklabels": column == 0,
                "matches": if k == 0 || equal { None } else { Some("y") },
            }),
        );
        let (xs, ys) = of(portrait);
        let (px, py) = curve(xs, ys, PORTRAIT_POINTS);
        plot = plot
            .axis(
                &axis_name("x", k),
                if lowest { x_title } else { "" },
                x_axis,
            )
            .axis(
                &axis_name("y", k),
                if column == 0 { y_title } else { "" },
                y_axis,
            )
            .trace(on(
                with(
                    line(&portrait.structure.label(), &px, &py, PALETTE[0]),
                    json!({ "line": { "width": 1 } }),
                ),
                &x,
                &y,
            ))
            .text(
                &panel_title(&portrait.structure, &portrait.verdict),
                (0.5, 1.02),
                (&format!("{x} domain"), &format!("{y} domain")),
                json!({ "yanchor": "bottom", "font": { "size": 11.5 } }),
            );
    }
    plot
}
