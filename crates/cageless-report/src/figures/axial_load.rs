//! Lag in the discrete raceway over the axial load.

use cageless_results::Record;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::data::Provenance;
use crate::figure::Figure;
use crate::plot::{PALETTE, Plot, line};

/// Lags under axial load, at one tilt each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AxialLoads {
    /// Fr, N.
    pub radial_load_n: f64,
    /// One curve per tilt.
    pub tilts: Vec<AxialCurve>,
    /// Settings of the runs.
    pub provenance: Provenance,
}

/// Lag and contact angle over the axial load at one tilt.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct AxialCurve {
    /// Tilt about the horizontal axis, mrad.
    pub tilt_x_mrad: f64,
    /// Axial load, N.
    pub axial_load_n: Vec<f64>,
    /// Lag per pass, degrees; NaN where the run stopped.
    pub lag_per_pass_deg: Vec<f64>,
    /// Mean contact angle at the inner raceway, degrees.
    pub inner_contact_angle_mean_deg: Vec<f64>,
    /// Critical gap, degrees; NaN where there is none.
    pub critical_gap_deg: Vec<f64>,
}

impl AxialLoads {
    /// Curves of the results of motion in space under a radial load.
    pub fn new(axial: &Record, radial_load_n: f64, provenance: Provenance) -> Self {
        let of = |name| axial.values(name);
        let points = of("axial_load_n").iter().zip(of("tilt_x_mrad"));
        let values = of("lag_per_pass_deg")
            .iter()
            .zip(of("inner_contact_angle_mean_deg"))
            .zip(of("critical_gap_deg"));
        let mut tilts: Vec<AxialCurve> = vec![];
        for ((&load, &tilt), ((&lag, &angle), &gap)) in points.zip(values) {
            if tilts.last().is_none_or(|curve| curve.tilt_x_mrad != tilt) {
                tilts.push(AxialCurve {
                    tilt_x_mrad: tilt,
                    ..AxialCurve::default()
                });
            }
            if let Some(curve) = tilts.last_mut() {
                curve.axial_load_n.push(load);
                curve.lag_per_pass_deg.push(lag);
                curve.inner_contact_angle_mean_deg.push(angle);
                curve.critical_gap_deg.push(gap);
            }
        }
        Self {
            radial_load_n,
            tilts,
            provenance,
        }
    }
}

/// Curves over the axial load, one per tilt: name of y, its values, and what is said of a point.
fn curves(data: &AxialLoads, y: &str, values: fn(&AxialCurve) -> &[f64], point: &str) -> Plot {
    let mut plot = Plot::new(400)
        .legend()
        .x("Axial load (N)", json!({ "rangemode": "tozero" }))
        .y(y, json!({}))
        .horizontal("x", "y", 0.0, "dot");
    for (curve, colour) in data.tilts.iter().zip(PALETTE) {
        let name = format!("tilt {} mrad", curve.tilt_x_mrad);
        let trace = line(&name, &curve.axial_load_n, values(curve), colour);
        plot = plot.trace(trace.with(json!({
            "mode": "lines+markers", "customdata": curve.inner_contact_angle_mean_deg,
            "hovertemplate": format!(
                "%{{x:.0f}} N, {point} %{{y:.3f}}°<br>contact angle, inner %{{customdata:.2f}}°<extra></extra>"
            ),
        })));
    }
    plot
}

/// Lag per pass over the axial load.
pub fn axial_load(data: &AxialLoads) -> Figure {
    let plot = curves(data, "Lag per pass (°)", |c| &c.lag_per_pass_deg, "lag");
    let caption = format!(
        "What a ball loses in one passage of the raceway under an axial load, with a radial load of \
         {:.0} N, by motion in space with the balls evenly spaced at the start. Below 0 the raceway \
         brings balls together.",
        data.radial_load_n
    );
    Figure::new("Axial load and tilt", &caption, &data.provenance, plot)
}

/// Critical gap over the axial load.
pub fn axial_gap(data: &AxialLoads) -> Figure {
    let plot = curves(
        data,
        "Critical gap (°)",
        |c| &c.critical_gap_deg,
        "critical gap",
    );
    let caption = format!(
        "Largest gap on entry at which two balls touch in the raceway, by runs of pairs in space under a \
         radial load of {:.0} N. Without a point no pair touches, or every pair does, or the bearing does not bear \
         the load.",
        data.radial_load_n
    );
    Figure::new(
        "Critical gap under axial load",
        &caption,
        &data.provenance,
        plot,
    )
}
