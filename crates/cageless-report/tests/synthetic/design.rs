//! Data of a design with its search.

use cageless_results::{Record, SEARCH_SHAPE};
use serde_json::{Value, json};

use super::*;

/// A structure of a search.
fn searched(k: usize, status: &str) -> Value {
    let x = k as f64;
    json!({
        "axial_span_mm": 5.0 + 0.1 * x, "half_angle_deg": 22.0 + x,
        "shape": "quartic", "contact_angle_deg": 0.0, "centre_angles_deg": if k == 3 { vec![-30.0, 30.0] } else { vec![0.0] },
        "status": status, "passes": status == "accepted", "reason": null,
        "why": if status == "rejected" { "slip <takes> 9 %" } else { "" },
        "on_front": k.is_multiple_of(2), "beta0_deg": 1.8, "film_lag_per_turn_deg": null, "steady_gap_deg": 1.97,
        "points": [{
            "axial_lag_rolling_fraction": null, "axial_lag_fraction": null, "axial_lag_deg": null,
            "critical_gap_deg": 1.7 + 0.05 * x, "margin_deg": 0.27 - 0.05 * x,
            "slip_shortfall": 0.02, "pressure_mpa": 1410.0,
            "motion": {
                "collisions": 0.3, "collisions_late": 0.0, "double_collision_fraction": 0.0,
                "impulse_mn_s": 0.0, "spacing_scatter": 0.2 - 0.02 * x, "gap_min_deg": 0.0,
                "sliding_m_s": 0.0, "speed_drop_fraction": 0.0, "lag_fraction": 0.0, "force_deviation_n": 0.0,
                "friction_w": 0.8 + 0.1 * x, "rolling_resistance_w": null,
            },
            "errors": null,
        }],
    })
}

/// The record of a search that found something, as JSON.
pub fn search_json() -> Value {
    let point =
        |rpm: f64| json!({ "inner_speed_rpm": rpm, "radial_load_n": 1500.0, "axial_load_n": 0.0 });
    let map = |rpm: f64| {
        json!({
            "point": point(rpm), "axial_span_mm": [4.0, 5.0, 6.0], "half_angle_deg": [15.0, 25.0],
            "critical_gap_deg": [[0.9, 1.7, 1.2], [1.0, null, 3.0]],
            "steady_gap_deg": [[1.97, 1.97, 1.97], [1.97, 1.97, 1.97]],
            "verdict": [
                ["insufficient-separation", "smooth", "slips"],
                ["double-collision", "eq-9", "excessive-separation"],
            ],
            "passes": [[false, true, false], [false, false, false]],
        })
    };
    let place = json!({
        "centre_angles_deg": [0.0], "shape": "quartic", "contact_angle_deg": 0.0, "structures": 0, "accepted": 0, "least_shortfall": null, "best": null,
    });
    json!({
        "critical_gap_min_fraction": 0.8, "axial_load_max_n": 0.0, "starts": 2, "seed": 0,
        "curve_axial_span_mm": [4.9, 6.0], "curve_half_angle_deg": [35.0, 12.0],
        "findings": ["Recommended: <this>."], "points": [point(12000.0)],
        "recommended": searched(0, "accepted"), "recommended_verdicts": [],
        "own": searched(1, "rejected"),
        "front": [searched(0, "accepted"), searched(2, "accepted")],
        "band": (0..4).map(|k| searched(k, "accepted")).collect::<Value>(),
        "rejections": [{ "reason": "slips", "meaning": "balls slide", "count": 7 }],
        "placements": [place, place],
        "maps": [map(12000.0), map(3000.0), map(20000.0), map(6000.0)],
        "paper": [{ "letter": "d", "axial_span_mm": 5.1, "half_angle_deg": 25.2 }],
        "provenance": run_data().provenance,
    })
}

/// A design with a search that found something.
pub fn design() -> DesignData {
    let reproduced = reproduce();
    DesignData {
        case_toml: String::new(),
        title: "Design <synthetic>".to_owned(),
        lead: "What was found.".to_owned(),
        passes: Some(true),
        headline: "works: smooth".to_owned(),
        recommendation_passes: None,
        recommendation: String::new(),
        limits: vec![(Some(false), "smallest gap above 1".to_owned())],
        reasons: vec!["critical gap 1.7 of 1.8".to_owned()],
        results: run_data().results,
        curve: reproduced.design_curve,
        contact_track: reproduced.contact_track,
        surface: reproduced.surface,
        motion: run_data().motion,
        search: Some(Record::read(&SEARCH_SHAPE, &search_json()).expect("a search")),
        provenance: run_data().provenance,
        ..DesignData::default()
    }
}
