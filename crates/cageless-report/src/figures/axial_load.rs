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
}

impl AxialLoads {
    /// Curves of the results of motion in space under a radial load.
    pub fn new(axial: &Record, radial_load_n: f64, provenance: Provenance) -> Self {
        let of = |name| axial.values(name);
        let points = of("axial_load_n").iter().zip(of("tilt_x_mrad"));
        let values = of("lag_per_pass_deg")
            .iter()
            .zip(of("inner_contact_angle_mean_deg"));
        let mut tilts: Vec<AxialCurve> = vec![];
        for ((&load, &tilt), (&lag, &angle)) in points.zip(values) {
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
            }
        }
        Self {
            radial_load_n,
            tilts,
            provenance,
        }
    }
}

/// Lag per pass over the axial load, a curve per tilt.
pub fn axial_load(data: &AxialLoads) -> Figure {
    let mut plot = Plot::new(400)
        .legend()
        .x("Axial load (N)", json!({ "rangemode": "tozero" }))
        .y("Lag per pass (°)", json!({}))
        .horizontal("x", "y", 0.0, "dot");
    for (curve, colour) in data.tilts.iter().zip(PALETTE) {
        let name = format!("tilt {} mrad", curve.tilt_x_mrad);
        let lags = line(&name, &curve.axial_load_n, &curve.lag_per_pass_deg, colour);
        plot = plot.trace(lags.with(json!({
            "mode": "lines+markers", "customdata": curve.inner_contact_angle_mean_deg,
            "hovertemplate": "%{x:.0f} N, lag %{y:.3f}°<br>contact angle, inner %{customdata:.2f}°<extra></extra>",
        })));
    }
    let caption = format!(
        "What a ball loses in one passage of the raceway under an axial load, with a radial load of \
         {:.0} N, by motion in space with the balls evenly spaced at the start. Below 0 the raceway \
         brings balls together.",
        data.radial_load_n
    );
    Figure::new("Axial load and tilt", &caption, &data.provenance, plot)
}
