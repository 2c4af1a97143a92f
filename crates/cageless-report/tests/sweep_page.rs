//! The page of a sweep.

use cageless_report::*;

use crate::pages::{specs, split};

fn swept() -> SweepData {
    let quantity = |name: &str, unit: &str| SweepQuantity {
        name: name.into(),
        unit: unit.into(),
    };
    let output = |name: &str| SweepOutput {
        quantity: quantity(name, ""),
        shares: vec![Some(0.7), Some(0.2)],
        effects: vec![
            MainEffect {
                input: quantity("operation_radial_load_n", "N"),
                levels: Levels::Numbers(vec![500.0, 1500.0]),
                mean: vec![0.2, 0.8],
                min: vec![0.0, 0.5],
                max: vec![0.5, 1.0],
            },
            MainEffect {
                input: quantity("raceway_axial_span_mm", "mm"),
                levels: Levels::Numbers(vec![5.0, 5.1]),
                mean: vec![0.4, 0.6],
                min: vec![0.0, 0.5],
                max: vec![0.5, 1.0],
            },
        ],
        ..SweepOutput::default()
    };
    let names = [
        "verdict_passes",
        "run_collisions",
        "run_gap_min_deg",
        "run_sliding_max_m_s",
        "run_steps",
    ];
    SweepData {
        variants: 40,
        passed: Some([30, 40]),
        inputs: vec![
            quantity("operation_radial_load_n", "N"),
            quantity("raceway_axial_span_mm", "mm"),
        ],
        outputs: names.map(output).to_vec(),
        chosen: 4,
        ..SweepData::default()
    }
}

/// A sweep shows what was asked for, choices before conditions, and folds the rest away.
#[test]
fn a_sweep_shows_its_choice_first() {
    let page = sweep_page(&swept());
    let (html, _) = split(&page);
    assert!(html.contains("30 of 40 variants pass (75 %)"));
    let folded = html.find("<details>").expect("a fold");
    let place = |id: &str| html.find(&format!("id=\"{id}\"")).expect("a figure");
    assert!(place("effects-on-passes") < folded && place("effects-on-smallest-gap") < folded);
    assert!(
        place("effects-on-largest-sliding-speed-under-load") > folded
            && place("effects-on-steps") > folded
    );
    let specs = specs(&page);
    let spec = |id: &str| {
        &specs
            .iter()
            .find(|(name, _)| name == id)
            .expect("a figure")
            .1
    };
    let sensitivity = spec("sensitivity-main-effects");
    assert_eq!(sensitivity["data"][0]["x"][1], "radial load");
    // What only the computation is about is no finding.
    let rows = sensitivity["data"][0]["y"].as_array().expect("outputs");
    assert_eq!(rows.len(), 4);
    assert!(!rows.iter().any(|row| row == "steps"));
    let title = &spec("effects-on-passes")["layout"]["xaxis"]["title"]["text"];
    assert_eq!(title, "Axial span <i>l</i><sub>C</sub> (mm)");
}
