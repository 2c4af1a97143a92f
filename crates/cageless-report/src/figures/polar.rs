//! Loads and contact pressures around the bearing.

use serde_json::{Value, json};

use super::history::figure;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, numbers, plain, with};
use crate::run_data::{LoadProfile, RunData};
use crate::sampling::range;
use crate::text::short;

/// Loads of the balls over the angular position, and the pressures.
pub fn loads(run: &RunData) -> Option<Figure> {
    let profile = run.load_profile.as_ref()?;
    let most = |values: &[f64]| range(values).1;
    let (force, pressure) = (
        most(&profile.outer_force_max_n).max(most(&profile.inner_force_max_n)),
        most(&profile.outer_pressure_max_gpa).max(most(&profile.inner_pressure_max_gpa)),
    );
    let polar = |domain: [f64; 2], most: f64, title: &str| {
        json!({
            "domain": { "x": domain, "y": [0.0, 0.92] }, "bgcolor": "rgba(0,0,0,0)",
            "radialaxis": {
                "range": [0, 1.05 * most.max(1e-9)], "title": { "text": title }, "angle": 90,
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
        .legend()
        .set("margin", json!({ "l": 40, "r": 40, "t": 70, "b": 30 }))
        .set(
            "legend",
            json!({ "orientation": "h", "x": 0, "y": 1.04, "yanchor": "bottom", "font": { "size": 12 } }),
        )
        .set("polar", polar([0.0, 0.46], force, "Force (N)"))
        .set("polar2", polar([0.54, 1.0], pressure, "Pressure (GPa)"));
    for (k, title) in ["Contact force (N)", "Peak contact pressure (GPa)"]
        .iter()
        .enumerate()
    {
        plot = plot.text(
            &format!("<b>{title}</b>"),
            (0.23 + 0.54 * k as f64, 1.0),
            ("paper", "paper"),
            json!({ "yanchor": "bottom", "name": format!("polar{}", if k == 0 { "" } else { "2" }) }),
        );
    }
    plot = sectors(plot, run, force, pressure);
    let traces: [(&str, &[f64], usize, &str, bool); 6] = [
        (
            "outer raceway, largest",
            &profile.outer_force_max_n,
            1,
            "polar",
            true,
        ),
        (
            "outer raceway, mean",
            &profile.outer_force_mean_n,
            1,
            "polar",
            false,
        ),
        (
            "inner raceway, largest",
            &profile.inner_force_max_n,
            0,
            "polar",
            true,
        ),
        (
            "inner raceway, mean",
            &profile.inner_force_mean_n,
            0,
            "polar",
            false,
        ),
        (
            "outer raceway, largest",
            &profile.outer_pressure_max_gpa,
            1,
            "polar2",
            true,
        ),
        (
            "inner raceway, largest",
            &profile.inner_pressure_max_gpa,
            0,
            "polar2",
            true,
        ),
    ];
    for (name, values, colour, subplot, largest) in traces {
        let unit = if subplot == "polar" { "N" } else { "GPa" };
        plot = plot.trace(with(
            ring(profile, values),
            json!({
                "name": plain(name), "subplot": subplot, "legendgroup": name,
                "showlegend": subplot == "polar",
                "line": { "color": PALETTE[colour], "width": if largest { 1.8 } else { 1.2 },
                          "dash": if largest { "solid" } else { "dot" } },
                "hovertemplate": format!("{name}<br>ψ %{{theta:.0f}}°<br>%{{r:.3g}} {unit}<extra></extra>"),
            }),
        ));
    }
    let plot = plot.finding(&format!(
        "The largest contact force is {} N, the highest contact pressure {} GPa.",
        short(force),
        short(pressure)
    ));
    Some(figure(
        run,
        "Loads and pressures",
        &format!(
            "Forces and peak contact pressures (Hertz) of all balls over their angular position ψ, \
             0° at the bottom, t = {} s to {} s: largest and mean in steps of {}°; the discrete \
             raceway is shaded.",
            short(profile.from_s),
            short(profile.to_s),
            short(360.0 / profile.angle_deg.len().max(1) as f64)
        ),
        plot,
    ))
}

/// A closed line around the bearing.
fn ring(profile: &LoadProfile, values: &[f64]) -> Value {
    let closed =
        |values: &[f64]| -> Vec<f64> { values.iter().chain(values.first()).copied().collect() };
    json!({
        "type": "scatterpolar", "mode": "lines",
        "theta": numbers(&closed(&profile.angle_deg)), "r": numbers(&closed(values)),
    })
}

/// Shades the discrete raceways in both plots.
fn sectors(mut plot: Plot, run: &RunData, force: f64, pressure: f64) -> Plot {
    for sector in &run.sectors {
        for (subplot, most) in [("polar", force), ("polar2", pressure)] {
            let arc: Vec<f64> = (0..=24)
                .map(|k| {
                    sector.centre_angle_deg + sector.half_angle_deg * (f64::from(k) / 12.0 - 1.0)
                })
                .collect();
            let mut theta = vec![sector.centre_angle_deg];
            theta.extend(&arc);
            let radius: Vec<f64> = (0..theta.len())
                .map(|k| if k == 0 { 0.0 } else { 1.05 * most })
                .collect();
            plot = plot.trace(json!({
                "type": "scatterpolar", "mode": "lines", "subplot": subplot, "fill": "toself",
                "theta": numbers(&theta), "r": numbers(&radius), "hoverinfo": "skip",
                "line": { "width": 0 }, "fillcolor": crate::plot::SECTOR, "showlegend": false,
            }));
        }
    }
    plot
}
