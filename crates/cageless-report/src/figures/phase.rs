//! Phase portraits of a ball, small multiples of one scale (Fig. 8).

use serde_json::json;

use super::panels::{Panel, Space, panel_title};
use crate::data::Provenance;
use crate::figure::Figure;
use crate::plot::{Margin, PALETTE, Plot, line_of, number, plain, with};
use crate::reproduce_data::{PhasePortrait, PhasePortraits};
use crate::sampling::{curve, range};

/// Points of one of ten portraits.
const PORTRAIT_POINTS: usize = 3000;
/// Portraits in a row.
const COLUMNS: usize = 5;
/// Height of a row of portraits, pixels.
const ROW_PX: u32 = 240;

/// Points of a portrait at a glance.
const GLANCE_POINTS: usize = 600;

/// Space between the panels at a glance.
const SPACE_AT_A_GLANCE: Space = Space {
    across: 0.03,
    down: 0.24,
};
/// Space between the panels.
const SPACE: Space = Space {
    across: 0.025,
    down: 0.24,
};

/// Fig. 8 at a glance, small and coloured by the verdict.
pub fn overview(portraits: &PhasePortraits) -> Figure {
    let count = portraits.portraits.len();
    let most = most_m_s(portraits);
    let rows = count.div_ceil(COLUMNS).max(1);
    let mut plot = Plot::new(120 * rows as u32 + 90)
        .margin(Margin {
            left: 54,
            right: 10,
            top: 40,
            bottom: 46,
        })
        .set("meta", json!({ "side_by_side": true }));
    let range = json!([number(-most), number(most)]);
    let panels = Panel::grid(count, COLUMNS, SPACE_AT_A_GLANCE);
    for (panel, portrait) in panels.iter().zip(&portraits.portraits) {
        let axis = |shown: bool, more| {
            let few = json!({
                "tickfont": { "size": 10 }, "nticks": 3, "automargin": false, "range": range,
                "constrain": "domain", "showticklabels": shown,
            });
            with(few, more)
        };
        let axes = panel.axes();
        let across = axis(panel.lowest, json!({ "scaleanchor": axes.y }));
        let up = axis(panel.leftmost, json!({}));
        let colour = match portrait.verdict.as_str() {
            "smooth" => PALETTE[2],
            "slips" => PALETTE[0],
            _ => PALETTE[1],
        };
        let name = portrait.structure.label();
        let drawn = curve(&portrait.vx_m_s, &portrait.vy_m_s, GLANCE_POINTS);
        let title = format!("<b>({})</b>", plain(&portrait.structure.letter));
        plot = plot
            .panel(
                panel,
                [panel.at_bottom("vx (m/s)"), panel.at_left("vy (m/s)")],
                [across, up],
            )
            .trace(line_of(&name, drawn, colour).width(0.8).on(axes))
            .title_above(panel, &title, json!({ "size": 12 }));
    }
    let caption = "Velocity of ball 1 in the structures (a) to (j), published equations: orange with double \
                   collisions, green smooth, blue sliding.";
    Figure::new("Figure 8, drawn", caption, &Provenance::default(), plot)
}

/// Largest component of a velocity with a little room, m/s.
fn most_m_s(portraits: &PhasePortraits) -> f64 {
    let all = portraits.portraits.iter();
    let ranges = all.flat_map(|p| [range(&p.vx_m_s), range(&p.vy_m_s)]);
    1.06 * ranges.fold(1e-9, |most: f64, (low, high)| most.max(-low).max(high))
}

/// Fig. 8: x-velocity against y-velocity, all on one scale.
pub fn velocities(portraits: &PhasePortraits) -> Figure {
    let most = most_m_s(portraits);
    let both = json!([number(-most), number(most)]);
    let y_more = json!({ "range": both, "constrain": "domain" });
    let plot = multiples(portraits, ["vx (m/s)", "vy (m/s)"], y_more, true, |p| {
        (&p.vx_m_s, &p.vy_m_s)
    });
    let caption = "Phase portraits of ball 1: velocity of its centre, y against x, for the ten \
                  structures, all on one scale. The discrete raceway lies where vx is positive \
                  and vy small.";
    Figure::of_paper("Figure 8", caption, &portraits.provenance, plot)
}

/// Fig. 8, second set: x-velocity against x on the way through the loaded zone.
pub fn positions(portraits: &PhasePortraits) -> Figure {
    let speeds = portraits.portraits.iter().map(|p| range(&p.vx_m_s).1);
    let most = speeds.fold(1e-9, f64::max) * 1.02;
    let y_more = json!({ "range": [number(0.55 * most), number(most)] });
    let plot = multiples(portraits, ["x (mm)", "vx (m/s)"], y_more, false, |p| {
        (&p.x_mm, &p.vx_m_s)
    });
    let caption = "The same turns as x-velocity against x, enlarged where the ball passes the \
                  bottom of the bearing; a double click shows all of a panel.";
    Figure::of_paper(
        "Figure 8, position and velocity",
        caption,
        &portraits.provenance,
        plot,
    )
}

fn multiples(
    portraits: &PhasePortraits,
    titles: [&str; 2],
    y_more: serde_json::Value,
    equal: bool,
    of: impl Fn(&PhasePortrait) -> (&Vec<f64>, &Vec<f64>),
) -> Plot {
    let count = portraits.portraits.len();
    let rows = count.div_ceil(COLUMNS).max(1);
    let [x_title, y_title] = titles;
    let mut plot = Plot::new(ROW_PX * rows as u32 + 66).margin(Margin {
        left: 62,
        right: 12,
        top: 78,
        bottom: 54,
    });
    let panels = Panel::grid(count, COLUMNS, SPACE);
    for (panel, portrait) in panels.iter().zip(&portraits.portraits) {
        let axis = |shown: bool, more| {
            let font = json!({ "size": 11 });
            let small = json!({ "tickfont": font, "nticks": 5, "automargin": false });
            with(with(small, json!({ "showticklabels": shown })), more)
        };
        let axes = panel.axes();
        let x_more = match equal {
            true => {
                json!({ "scaleanchor": axes.y, "constrain": "domain", "range": y_more["range"] })
            }
            false => json!({ "matches": (!panel.first).then_some("x") }),
        };
        let matches = json!({ "matches": (!panel.first && !equal).then_some("y") });
        let up = with(y_more.clone(), matches);
        let (xs, ys) = of(portrait);
        let (name, drawn) = (portrait.structure.label(), curve(xs, ys, PORTRAIT_POINTS));
        let title = panel_title(&portrait.structure, &portrait.verdict);
        plot = plot
            .panel(
                panel,
                [panel.at_bottom(x_title), panel.at_left(y_title)],
                [axis(panel.lowest, x_more), axis(panel.leftmost, up)],
            )
            .trace(line_of(&name, drawn, PALETTE[0]).width(1.0).on(axes))
            .title_above(panel, &title, json!({ "size": 11.5 }));
    }
    plot
}
