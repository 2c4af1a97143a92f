//! Data of a design with its search.

use super::*;

/// A structure of a search.
fn searched(k: usize, status: &str) -> StructureData {
    let x = k as f64;
    StructureData {
        axial_span_mm: 5.0 + 0.1 * x,
        half_angle_deg: 22.0 + x,
        centre_angles_deg: if k == 3 { vec![-30.0, 30.0] } else { vec![0.0] },
        status: status.to_owned(),
        why: if status == "rejected" {
            "slip <takes> 9 %".to_owned()
        } else {
            String::new()
        },
        on_front: k.is_multiple_of(2),
        beta0_deg: Some(1.8),
        steady_gap_deg: Some(1.97),
        points: vec![PointNumbers {
            critical_gap_deg: Some(1.7 + 0.05 * x),
            margin_deg: Some(0.27 - 0.05 * x),
            slip_shortfall: Some(0.02),
            pressure_mpa: Some(1410.0),
            motion: Some(MotionNumbers {
                collisions: 0.3,
                spacing_scatter: 0.2 - 0.02 * x,
                friction_w: 0.8 + 0.1 * x,
                ..MotionNumbers::default()
            }),
            errors: None,
        }],
        ..StructureData::default()
    }
}

/// A design with a search that found something.
pub fn design() -> DesignData {
    let map = |rpm: f64| MapData {
        point: PointData {
            inner_speed_rpm: rpm,
            radial_load_n: 1500.0,
        },
        axial_span_mm: vec![4.0, 5.0, 6.0],
        half_angle_deg: vec![15.0, 25.0],
        critical_gap_deg: vec![
            vec![Some(0.9), Some(1.7), Some(1.2)],
            vec![Some(1.0), None, Some(3.0)],
        ],
        steady_gap_deg: vec![vec![Some(1.97); 3]; 2],
        verdict: vec![
            vec![
                "insufficient-separation".into(),
                "smooth".into(),
                "slips".into(),
            ],
            vec![
                "double-collision".into(),
                "eq-9".into(),
                "excessive-separation".into(),
            ],
        ],
        passes: vec![vec![false, true, false], vec![false; 3]],
    };
    let reproduced = reproduce();
    DesignData {
        case_toml: String::new(),
        title: "Design <synthetic>".to_owned(),
        lead: "What was found.".to_owned(),
        passes: Some(true),
        headline: "PASS: smooth".to_owned(),
        recommendation_passes: Some(false),
        recommendation: "nothing recommended; starting point, which fails".to_owned(),
        reasons: vec!["critical gap 1.7 of 1.8".to_owned()],
        results: run_data().results,
        curve: reproduced.design_curve,
        contact_track: reproduced.contact_track,
        surface: reproduced.surface,
        motion: run_data().motion,
        search: Some(SearchData {
            findings: vec!["Recommended: <this>.".to_owned()],
            points: vec![map(12000.0).point],
            critical_gap_min_fraction: 0.8,
            starts: 2,
            recommended: Some(searched(0, "accepted")),
            own: Some(searched(1, "rejected")),
            front: vec![searched(0, "accepted"), searched(2, "accepted")],
            band: (0..4).map(|k| searched(k, "accepted")).collect(),
            rejections: vec![RejectionCount {
                reason: "slips".to_owned(),
                meaning: "balls slide".to_owned(),
                count: 7,
            }],
            placements: vec![PlacementData::default(), PlacementData::default()],
            maps: vec![map(12000.0), map(3000.0), map(20000.0), map(6000.0)],
            curve_axial_span_mm: vec![4.9, 6.0],
            curve_half_angle_deg: vec![35.0, 12.0],
            paper: vec![structure(3)],
            provenance: run_data().provenance,
            ..SearchData::default()
        }),
        provenance: run_data().provenance,
        ..DesignData::default()
    }
}
