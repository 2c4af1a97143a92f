//! The page of a drop.

use std::path::Path;

use cageless_io::arrangement::BearingArrangement;
use cageless_report::drop::drop_page;
use cageless_report::figures::{in_page, of_kind};
use cageless_study::Silent;
use cageless_study::drop::{DropRequest, DropStudy, study};
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

fn studied(file: &BearingArrangement, request: DropRequest) -> DropStudy {
    let drop = request.check(file, "file").unwrap();
    let rows = drop.cases().iter().map(|_| None).collect();
    study(file, drop, request, rows, &Silent).unwrap()
}

#[test]
fn the_animation_shows_the_rotor_in_the_bore() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/touchdown-d.toml");
    let file = BearingArrangement::read(&path, &["solver.duration_s=0.007".to_owned()]).unwrap();
    let request = DropRequest {
        compare: true,
        samples: Some(2),
        ..DropRequest::default()
    };
    let study = studied(&file, request);
    let page = drop_page(&file, &study);
    for (name, _) in of_kind("drop") {
        // The drop ends before the rotor is in lasting contact, is the only one, and in the plane.
        let shown = in_page(&page, "drop", name).is_some();
        let later = ["whirl", "temperatures", "along_axis"].contains(&name);
        assert_eq!(shown, !later, "{name}");
    }
    assert_eq!(page.matches("<g data-rotor>").count(), 2);
    assert_eq!(page.matches("<g data-ring-mark>").count(), 2);
    let data = page.split("data-motion>").nth(1).unwrap();
    let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
    let rotor = &data["bearings"][0]["rotor"];
    let y_mm = decode(&rotor["y"]);
    assert_eq!(y_mm.len(), study.record.bearings[0].snapshots.len());
    // The air gap of 0.2 mm is drawn as 1.2 mm; the contact is closed by then.
    assert!(
        (y_mm[0]).abs() < 1e-3 && y_mm.last().unwrap() < &-1.2,
        "{y_mm:?}"
    );
    let last = study.record.bearings[0].snapshots.last().unwrap();
    let turned = decode(&rotor["a"]);
    let angle = last.rotor.unwrap().angle_rad.to_degrees();
    assert!((turned.last().unwrap() - angle).abs() < 1e-3);
    let ring = decode(&rotor["ring"]);
    assert!(ring[0] == 0.0 && *ring.last().unwrap() > 0.0);
    // Below what was computed, the case can be changed.
    let place = page.find("data-studio=\"later\"").expect("a studio");
    assert!(place > page.find("Energy").expect("the last section"));
    assert!(
        page[place..].contains("radial_clearance_um = 200"),
        "its case"
    );
    if let Some(folder) = std::env::var_os("CAGELESS_PAGES") {
        std::fs::write(Path::new(&folder).join("drop.html"), page).unwrap();
    }
}

/// The first trace with this name in a figure of the page of a drop.
fn trace(page: &str, figure: &str, name: &str) -> Value {
    let spec: Value = serde_json::from_str(in_page(page, "drop", figure).unwrap()).unwrap();
    let mut traces = spec["data"].as_array().unwrap().iter();
    traces.find(|trace| trace["name"] == name).unwrap().clone()
}

/// The inner ring moves on its support, so that the path in the bore is not that in the stator.
#[test]
fn the_orbit_is_that_of_the_journal_in_the_ring_and_the_displacement_that_in_the_stator() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/touchdown-d.toml");
    let changes = [
        "solver.duration_s=0.009",
        "rotor.eccentricity_um=20",
        "rotor.clearance_limit_um=400",
    ];
    let file = BearingArrangement::read(&path, &changes.map(str::to_owned)).unwrap();
    let study = studied(&file, DropRequest::default());
    let page = drop_page(&file, &study);
    let paths = ["orbit", "displacement"].map(|f| trace(&page, f, "centre of the journal"));
    let numbers = |trace: &Value, axis: &str| -> Vec<f64> {
        let values = trace[axis].as_array().unwrap().iter();
        values.map(|v| v.as_f64().unwrap()).collect()
    };
    let rows: Vec<_> = (study.record.bearings[0].snapshots.iter())
        .map(|s| {
            let r = s.rotor.unwrap();
            let (sin, cos) = r.angle_rad.sin_cos();
            let journal = [1e6 * r.x_m - 20.0 * cos, 1e6 * r.y_m - 20.0 * sin];
            (journal, [1e6 * s.ring.x_m, 1e6 * s.ring.y_m])
        })
        .collect();
    let ring_moves = rows
        .iter()
        .map(|(_, ring)| ring[1].abs())
        .fold(0.0, f64::max);
    assert!(ring_moves > 5.0, "{ring_moves} µm");
    for (trace, in_ring) in paths.iter().zip([1.0, 0.0]) {
        for (axis, k) in [("x", 0), ("y", 1)] {
            let shown = numbers(trace, axis);
            assert_eq!(shown.len(), rows.len());
            for (shown, (journal, ring)) in shown.iter().zip(&rows) {
                let exact = journal[k] - in_ring * ring[k];
                assert!(
                    (shown - exact).abs() < 0.01 + 1e-3 * exact.abs(),
                    "{axis}: {shown} {exact}"
                );
            }
        }
    }
    let circle = trace(&page, "displacement", "clearance to the stator");
    let radius = numbers(&circle, "x")[0].hypot(numbers(&circle, "y")[0]);
    assert!((radius - 400.0).abs() < 0.5, "{radius}");
    // The verdict with its reason in the head, and the state in words.
    assert!(page.contains("not judged: it ends too early"), "verdict");
    assert!(page.contains("intermittent contact"), "state");
}

/// The page leads with what decides: the plane that failed, in the head, first among the limits and as a path that
/// crosses its clearance.
#[test]
fn a_seal_that_the_rotor_meets_leads_the_page() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let text = std::fs::read_to_string(cases.join("rotors/two-bearings.toml")).unwrap();
    let seals = "\n[[clearance]]\nname = \"labyrinth seal\"\naxial_mm = 50.0\nradial_um = 150.0\n\
                 [[clearance]]\nname = \"turbine wheel\"\naxial_mm = 280.0\nradial_um = 900.0\n";
    let text = text.replace("../", &format!("{}/", cases.display())) + seals;
    let changes = ["solver.duration_s=0.02".to_owned()];
    let file = BearingArrangement::parse(&text, "rotor.toml", Path::new("."), &changes).unwrap();
    let study = studied(&file, DropRequest::default());
    let page = drop_page(&file, &study);
    let rotor = &study.record.rotor;
    let most_um = 1e6 * rotor.planes[0].displacement_max_m;
    assert!(most_um > 150.0);
    let head = &page[page.find("class=\"facts\"").unwrap()..page.find("</dl>").unwrap()];
    assert!(
        head.contains("largest displacement at labyrinth seal"),
        "{head}"
    );
    let limits = &page[page.find("id=\"limits\"").unwrap()..];
    let limits = &limits[..limits.find("</table>").unwrap()];
    // Those that fail stand first.
    let failed = limits.split("<td>PASS</td>").next().unwrap();
    let row = failed
        .split("</tr>")
        .find(|row| row.contains("labyrinth seal"));
    assert!(row.unwrap().contains("<td>FAIL</td>"), "{failed}");
    assert!(limits[failed.len()..].find("FAIL").is_none());
    let wheel = limits
        .split("</tr>")
        .find(|row| row.contains("turbine wheel"))
        .unwrap();
    assert!(wheel.contains("PASS"), "{wheel}");
    // The first figure is the path in the planes, with the circles of their clearances.
    let anchor = "id=\"displacement-at-the-clearances-spec\">";
    assert_eq!(
        page.find("-spec\">"),
        page.find(anchor).map(|at| at + anchor.len() - 7)
    );
    let spec = page
        .split(anchor)
        .nth(1)
        .unwrap()
        .split("</script>")
        .next()
        .unwrap();
    let spec: Value = serde_json::from_str(spec).unwrap();
    let traces = spec["data"].as_array().unwrap();
    assert_eq!(traces.len(), 6);
    let radius = |trace: &Value| {
        let [x, y] = ["x", "y"].map(|axis| trace[axis][0].as_f64().unwrap());
        x.hypot(y)
    };
    for (k, expected) in [(0, 150.0), (2, most_um), (3, 900.0)] {
        let found = radius(&traces[k]);
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{k}: {found} {expected}"
        );
    }
}

/// A rotor that only rounding moves along its axis has no figure of that.
#[test]
fn rounding_is_no_motion_along_the_axis() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/touchdown-pair.toml");
    let file = BearingArrangement::read(&path, &["solver.duration_s=0.00005".to_owned()]).unwrap();
    let mut study = studied(&file, DropRequest::default());
    for (way_m, shown) in [(1e-12, false), (1e-8, true)] {
        for (k, row) in (0..).zip(&mut study.record.bearings[0].snapshots) {
            row.ring.z_m = 3e-6;
            row.rotor.as_mut().unwrap().z_m = way_m * f64::from(k % 2);
        }
        let page = drop_page(&file, &study);
        assert_eq!(
            in_page(&page, "drop", "along_axis").is_some(),
            shown,
            "{way_m}"
        );
    }
}
