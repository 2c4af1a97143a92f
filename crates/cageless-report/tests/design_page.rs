//! Figures of the search on the page of a design.

use cageless_report::*;
use cageless_results::{Record, SEARCH_SHAPE};
use serde_json::Value;

use crate::pages::specs;

/// The figure of a design page whose anchor begins with `id`.
fn search_figure(search: &Value, id: &str) -> Value {
    let data = DesignData {
        search: Some(Record::read(&SEARCH_SHAPE, search).expect("a search")),
        ..crate::synthetic::design()
    };
    let found = specs(&design_page(&data));
    let (_, spec) = (found.into_iter())
        .find(|(name, _)| name.starts_with(id))
        .unwrap_or_else(|| panic!("{id} is missing"));
    spec
}

#[test]
fn axes_of_trade_offs_show_what_is_acceptable() {
    let mut search = crate::synthetic::search_json();
    // The raceway of the case, hit far more often than any that is acceptable.
    let mut own = search["band"][0].clone();
    own["status"] = "rejected".into();
    own["points"][0]["motion"]["collisions_late"] = 36.0.into();
    own["points"][0]["motion"]["spacing_scatter"] = 5.0.into();
    search["own_from_usual_starts"] = own;
    let spec = search_figure(&search, "trade-offs");
    let range = |axis: &str| {
        let range = &spec["layout"][axis]["range"];
        [0, 1].map(|k| range[k].as_f64().expect("a range"))
    };
    let (x, y) = (range("xaxis"), range("yaxis"));
    assert!(y[1] < 36.0 && x[1] < 5.0, "{x:?} {y:?}");
    for trace in spec["data"].as_array().expect("traces") {
        if trace["xaxis"] != "x" || trace["yaxis"] != "y" {
            continue;
        }
        let at = |axis: &str| trace[axis][0].as_f64().expect("a number");
        assert!((x[0]..=x[1]).contains(&at("x")) && (y[0]..=y[1]).contains(&at("y")));
        if trace["name"] == "initial design" {
            // At the edge, with its values.
            assert_eq!([at("x"), at("y")], [x[1], y[1]]);
            assert_eq!(trace["text"][0], "5, 36");
        }
    }
}

#[test]
fn the_recommended_raceway_lies_on_its_own_verdict() {
    let mut search = crate::synthetic::search_json();
    for map in search["maps"].as_array_mut().unwrap() {
        for row in map["verdict"].as_array_mut().unwrap() {
            let cells = row.as_array_mut().unwrap().iter_mut();
            cells.for_each(|verdict| *verdict = "insufficient-separation".into());
        }
    }
    search["band"][1]["status"] = "rejected".into();
    search["band"][1]["reason"] = "slips".into();
    let best_mm = search["band"][0]["axial_span_mm"].as_f64().unwrap();
    let spec = search_figure(&search, "design-map-verdicts");
    let traces = spec["data"].as_array().expect("traces");
    let tried: Vec<_> = (traces.iter())
        .filter(|t| t["name"] == "structures tried")
        .collect();
    assert_eq!(tried.len(), 1, "at the speed that is asked for");
    let (colours, x) = (&tried[0]["marker"]["color"], &tried[0]["x"]);
    assert!((x[0].as_f64().expect("a place") - best_mm).abs() < 1e-3);
    assert_eq!(
        (&colours[0], &colours[1]),
        (&"#009e73".into(), &"#d55e00".into())
    );
    assert!(traces.iter().any(|t| t["name"] == "works"), "the legend");
}
