//! Loads and contact pressures around the bearing.

use serde_json::json;

use super::history::figure;
use cageless_results::Results;

use crate::data::{Provenance, RacewaySector};
use crate::figure::Figure;
use crate::plot::{Margin, PALETTE, Plot, Trace, numbers, plain};
use crate::run_data::{LoadProfile, RunData};
use crate::sampling::range;
use crate::text::short;

/// A raceway with the colour of what is at it.
const INNER: (&str, &str) = ("inner raceway", PALETTE[0]);
const OUTER: (&str, &str) = ("outer raceway", PALETTE[1]);

/// Colours of the inner and the outer raceway of each row; those of the first are the colours above.
const ROWS: [[&str; 2]; 3] = [
    [INNER.1, OUTER.1],
    [PALETTE[5], PALETTE[4]],
    [PALETTE[2], PALETTE[3]],
];

/// Distance of the bars of two rows over what each row has of the angle.
const BESIDE: f64 = 0.7;

/// A part of the figure with the unit of what it shows.
const FORCE: (&str, &str) = ("polar", "N");
const PRESSURE: (&str, &str) = ("polar2", "MPa");

/// Places of both diagrams along x, with room for the angles between them.
const LEFT: [f64; 2] = [0.0, 0.43];
const RIGHT: [f64; 2] = [0.57, 1.0];

/// Loads of the balls over the angular position, and the pressures.
pub fn loads(run: &RunData) -> Option<Figure> {
    let profile = run.load_profile.as_ref()?;
    let most = |values: &[f64]| range(values).1;
    let (force, pressure) = (
        most(&profile.outer_force_max_n).max(most(&profile.inner_force_max_n)),
        most(&profile.outer_pressure_max_mpa).max(most(&profile.inner_pressure_max_mpa)),
    );
    let mut plot = frame(force, pressure, &run.sectors);
    let traces: [(_, _, _, &[f64]); 6] = [
        (OUTER, "largest", FORCE, &profile.outer_force_max_n),
        (OUTER, "mean", FORCE, &profile.outer_force_mean_n),
        (INNER, "largest", FORCE, &profile.inner_force_max_n),
        (INNER, "mean", FORCE, &profile.inner_force_mean_n),
        (OUTER, "largest", PRESSURE, &profile.outer_pressure_max_mpa),
        (INNER, "largest", PRESSURE, &profile.inner_pressure_max_mpa),
    ];
    for ((raceway, colour), which, (subplot, unit), values) in traces {
        let (width, dash) = match which {
            "largest" => (1.8, "solid"),
            _ => (1.2, "dot"),
        };
        let name = format!("{raceway}, {which}");
        let ring = ring(profile, values).in_group(&name, subplot == "polar");
        plot = plot.trace(ring.width(width).dash(dash).with(json!({
            "name": plain(&name), "subplot": subplot, "line": { "color": colour },
            "hovertemplate": format!("{name}<br>ψ %{{theta:.0f}}°<br>%{{r:.4r}} {unit}<extra></extra>"),
        })));
    }
    let caption = format!(
        "Forces and peak contact pressures (Hertz) of all balls over their angular position ψ, \
             0° at the bottom, t = {} s to {} s: largest and mean in steps of {}°; the discrete \
             raceway is shaded.",
        short(profile.from_s),
        short(profile.to_s),
        short(360.0 / profile.angle_deg.len().max(1) as f64)
    );
    Some(figure(run, "Loads and pressures", &caption, plot))
}

/// Two empty polar diagrams with the discrete raceways shaded: forces to the left, pressures to the right.
fn frame(force: f64, pressure: f64, raceways: &[RacewaySector]) -> Plot {
    let polar = |domain: [f64; 2], most: f64| {
        json!({
            "domain": { "x": domain, "y": [0.0, 0.92] }, "bgcolor": "rgba(0,0,0,0)",
            "barmode": "overlay",
            "radialaxis": {
                "range": [0, 1.05 * most.max(1e-9)], "angle": 90,
                "gridcolor": "#e6e6e6", "linecolor": "#555", "tickangle": 90, "nticks": 5,
            },
            // 0 at the bottom, counter-clockwise as the balls go round.
            "angularaxis": {
                "rotation": 270, "direction": "counterclockwise", "dtick": 30,
                "gridcolor": "#e6e6e6", "linecolor": "#555", "ticksuffix": "°",
            },
        })
    };
    let mut plot = Plot::new(520)
        .legend_above(1.08)
        .margin(Margin {
            left: 40,
            right: 40,
            top: 70,
            bottom: 30,
        })
        .set("polar", polar(LEFT, force))
        .set("polar2", polar(RIGHT, pressure));
    for (subplot, [from, to], title) in [
        ("polar", LEFT, "Contact force (N)"),
        ("polar2", RIGHT, "Peak contact pressure (MPa)"),
    ] {
        plot = plot.text(
            &format!("<b>{title}</b>"),
            (0.5 * (from + to), 1.0),
            ("paper", "paper"),
            json!({ "xanchor": "center", "yanchor": "bottom", "name": subplot }),
        );
    }
    sectors(plot, raceways, force, pressure).finding(&format!(
        "The largest contact force is {} N, the highest contact pressure {} MPa.",
        short(force),
        short(pressure)
    ))
}

/// Loads of the balls and contact pressures in a static equilibrium. The bars of several rows, whose balls may
/// be at the same angles, stand side by side.
pub fn static_loads(results: &Results, raceways: &[RacewaySector], source: Provenance) -> Figure {
    let of = |name: &str| results.values(name);
    let angles = of("ball_angle_deg");
    let rows = rows(of("row"), angles.len());
    let series = [
        (FORCE, ["inner_force_n", "outer_force_n"].map(of)),
        (
            PRESSURE,
            ["inner_pressure_mpa", "outer_pressure_mpa"].map(of),
        ),
    ];
    let [force, pressure] = series.map(|(_, [inner, outer])| range(inner).1.max(range(outer).1));
    let mut plot = frame(force, pressure, raceways);
    let balls_of_a_row = rows.iter().map(Vec::len).max().unwrap_or(1).max(1);
    // What each row has of the angle from ball to ball.
    let slot = 360.0 / (balls_of_a_row * rows.len()) as f64;
    for ((subplot, unit), values) in series {
        for (k, balls) in rows.iter().enumerate() {
            let beside = slot * (k as f64 - 0.5 * (rows.len() - 1) as f64) * BESIDE;
            let of_row = |values: &[f64]| balls.iter().map(|b| values[*b]).collect::<Vec<_>>();
            let theta: Vec<f64> = of_row(angles).iter().map(|a| a + beside).collect();
            let text: Vec<String> = (balls.iter())
                .map(|b| format!("ball {}, ψ {}°", b + 1, short(angles[*b])))
                .collect();
            // The narrower bars are drawn last, in front.
            for (ring, (raceway, _), share) in [(1, OUTER, 0.6), (0, INNER, 0.3)] {
                let name = match rows.len() {
                    1 => raceway.to_owned(),
                    _ => format!("row {}, {raceway}", k + 1),
                };
                plot = plot.trace(json!({
                    "type": "barpolar", "name": name, "subplot": subplot, "legendgroup": name,
                    "showlegend": subplot == "polar",
                    "theta": numbers(&theta), "r": numbers(&of_row(values[ring])),
                    "width": numbers(&vec![share * slot; balls.len()]),
                    "marker": { "color": ROWS[k % ROWS.len()][ring] }, "opacity": 0.85, "text": text,
                    "hovertemplate": format!("%{{text}}<br>%{{r:.4g}} {unit}<extra>{name}</extra>"),
                }));
            }
        }
    }
    let of_rows = match rows.len() {
        1 => "",
        _ => " Balls of different rows are drawn side by side, next to their angle.",
    };
    let caption = format!(
        "Contact force and peak contact pressure (Hertz) of each ball in static equilibrium over its angular \
         position ψ, 0° at the bottom.{of_rows} Discrete raceways are shaded; there the pressure at the outer \
         raceway is that of one of two contact points."
    );
    Figure::new("Load distribution", &caption, &source, plot)
}

/// Balls of each row, from 0; `row` numbers the row of each ball from 1 and is empty in the plane.
fn rows(row: &[f64], balls: usize) -> Vec<Vec<usize>> {
    let of = |ball: usize| row.get(ball).map_or(0, |row| *row as usize - 1);
    let count = (0..balls).map(of).max().map_or(1, |last| last + 1);
    let balls_of = |k: usize| (0..balls).filter(|ball| of(*ball) == k).collect();
    (0..count).map(balls_of).collect()
}

/// A closed line around the bearing.
fn ring(profile: &LoadProfile, values: &[f64]) -> Trace {
    let closed =
        |values: &[f64]| -> Vec<f64> { values.iter().chain(values.first()).copied().collect() };
    Trace::from(json!({
        "type": "scatterpolar", "mode": "lines",
        "theta": numbers(&closed(&profile.angle_deg)), "r": numbers(&closed(values)),
    }))
}

/// Shades the discrete raceways in both plots.
fn sectors(mut plot: Plot, raceways: &[RacewaySector], force: f64, pressure: f64) -> Plot {
    for sector in raceways {
        for (subplot, most) in [("polar", force), ("polar2", pressure)] {
            let centre = sector.centre_angle_deg;
            let arc =
                (0..=24).map(|k| centre + sector.half_angle_deg * (f64::from(k) / 12.0 - 1.0));
            let theta: Vec<f64> = [centre].into_iter().chain(arc).collect();
            let mut radius = vec![1.05 * most; theta.len()];
            radius[0] = 0.0;
            plot = plot.trace(json!({
                "type": "scatterpolar", "mode": "lines", "subplot": subplot, "fill": "toself",
                "theta": numbers(&theta), "r": numbers(&radius), "hoverinfo": "skip",
                "line": { "width": 0 }, "fillcolor": crate::plot::SECTOR, "showlegend": false,
            }));
        }
    }
    plot
}
