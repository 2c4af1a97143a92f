//! The page of a drop.

use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_report::drop::drop_page;
use cageless_study::Silent;
use cageless_study::drop::{DropRequest, study};
use serde_json::Value;

/// Undoes the coding of samples as differences in steps of 1e-4.
fn decode(steps: &Value) -> Vec<f64> {
    let mut sum = 0;
    let steps = steps.as_array().unwrap().iter();
    steps
        .map(|step| {
            sum += step.as_i64().unwrap();
            sum as f64 * 1e-4
        })
        .collect()
}

#[test]
fn the_animation_shows_the_rotor_in_the_bore() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/touchdown-d.toml");
    let file = CaseFile::read(&path, &["solver.duration_s=0.007".to_owned()]).unwrap();
    let request = DropRequest {
        compare: true,
        ..DropRequest::default()
    };
    let study = study(&file, request, None, &Silent).unwrap();
    let page = drop_page(&file, &study);
    assert_eq!(page.matches("<g data-rotor>").count(), 2);
    assert_eq!(page.matches("<g data-ring-mark>").count(), 2);
    let data = page.split("data-motion>").nth(1).unwrap();
    let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
    let rotor = &data["bearings"][0]["rotor"];
    let y_mm = decode(&rotor["y"]);
    assert_eq!(y_mm.len(), study.drop.snapshots.len());
    // The air gap of 0.2 mm is drawn as 1.2 mm; the contact is closed by then.
    assert!(
        (y_mm[0]).abs() < 1e-3 && y_mm.last().unwrap() < &-1.2,
        "{y_mm:?}"
    );
    let last = study.drop.snapshots.last().unwrap();
    let turned = decode(&rotor["a"]);
    let angle = last.rotor.unwrap().angle_rad.to_degrees();
    assert!((turned.last().unwrap() - angle).abs() < 1e-3);
    let ring = decode(&rotor["ring"]);
    assert!(ring[0] == 0.0 && *ring.last().unwrap() > 0.0);
    // Below what was computed, the case can be changed.
    let place = page.find("data-studio=\"later\"").expect("a studio");
    assert!(place > page.find("Energy").expect("the last section"));
    assert!(page[place..].contains("air_gap_um = 200"), "its case");
    if let Some(folder) = std::env::var_os("CAGELESS_PAGES") {
        std::fs::write(Path::new(&folder).join("drop.html"), page).unwrap();
    }
}
