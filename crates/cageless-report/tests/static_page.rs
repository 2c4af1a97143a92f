//! The figure of `static` on its page.

use std::collections::BTreeMap;
use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_report::static_page;
use cageless_results::equilibrium_record;
use serde_json::Value;

use crate::pages::specs;

/// Bars of several rows are told apart: each row and ring has its entry of the legend and its colour, every
/// ball a bar as long as its force, and no two bars of a ring overlap.
#[test]
fn rows_stand_side_by_side() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let load = ["operation.axial_load_n=800".to_owned()];
    let file = CaseFile::read(&cases.join("preloaded-pair.toml"), &load).expect("a case");
    let record = equilibrium_record(file.case(), file.particulars()).expect("an equilibrium");
    let forces = record.results.values("outer_force_n");
    let (_, spec) = specs(&static_page(&file, &record)).remove(0);
    let bars: Vec<&Value> = (spec["data"].as_array().expect("traces").iter())
        .filter(|trace| trace["type"] == "barpolar")
        .collect();
    let mut colours = BTreeMap::new();
    for bar in &bars {
        let name = bar["name"].as_str().expect("a name").to_owned();
        assert!(bar["showlegend"] == (bar["subplot"] == "polar"));
        let colour = bar["marker"]["color"].to_string();
        assert_eq!(*colours.entry(name).or_insert(colour.clone()), colour);
    }
    let names: Vec<_> = colours.keys().map(String::as_str).collect();
    let rings = ["inner raceway", "outer raceway"];
    let expected: Vec<_> = ["row 1", "row 2"]
        .iter()
        .flat_map(|row| rings.map(|ring| format!("{row}, {ring}")))
        .collect();
    assert_eq!(names, expected);
    let different: std::collections::BTreeSet<_> = colours.values().collect();
    assert_eq!(different.len(), 4);
    let numbers = |bar: &Value, key: &str| -> Vec<f64> {
        let all = bar[key].as_array().expect("a list").iter();
        all.map(|v| v.as_f64().expect("a number")).collect()
    };
    let outer = |bar: &&&Value| {
        bar["subplot"] == "polar"
            && bar["name"]
                .as_str()
                .is_some_and(|n| n.ends_with("outer raceway"))
    };
    let outer: Vec<&&Value> = bars.iter().filter(outer).collect();
    let lengths: Vec<f64> = outer.iter().flat_map(|bar| numbers(bar, "r")).collect();
    assert_eq!(lengths.len(), forces.len());
    for (length, force) in lengths.iter().zip(forces) {
        assert!((length - force).abs() <= 1e-5 * force, "{length} {force}");
    }
    let mut ends: Vec<[f64; 2]> = (outer.iter())
        .flat_map(|bar| {
            let all = numbers(bar, "theta").into_iter().zip(numbers(bar, "width"));
            all.map(|(middle, width)| [middle - width / 2.0, middle + width / 2.0])
                .collect::<Vec<_>>()
        })
        .collect();
    ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert!(
        ends.windows(2).all(|pair| pair[0][1] < pair[1][0]),
        "{ends:?}"
    );
    // Axis titles would lie across the numbers of their axis; the headings name the quantities.
    assert!(spec["layout"]["polar"]["radialaxis"]["title"].is_null());
}
