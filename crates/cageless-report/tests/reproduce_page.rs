//! The page of the reproduced paper.

use cageless_report::*;

use crate::pages::{specs, split};

#[test]
fn rings_are_compared_with_error_bars() {
    let page = reproduce_page(&crate::synthetic::reproduce());
    let (html, _) = split(&page);
    assert!(html.contains("120.0 ± 6.9"), "a mean with its error");
    assert!(html.contains("Left out by the model: tilt."));
    let specs = specs(&page);
    let (_, spec) = specs
        .iter()
        .find(|(id, _)| id == "rings-compared")
        .expect("a figure");
    for trace in spec["data"].as_array().expect("traces") {
        assert_eq!(trace["type"], "bar");
        let (bars, errors) = (&trace["y"], &trace["error_y"]["array"]);
        assert_eq!(
            bars.as_array().map(Vec::len),
            errors.as_array().map(Vec::len)
        );
        assert!(errors[0].as_f64().expect("an error") > 0.0);
    }
}

/// Every status with the requirements that decide it, and the sentences that follow.
#[test]
fn claims_are_shown_with_their_criteria() {
    let data = crate::synthetic::reproduce();
    let status: Vec<ClaimStatus> = data.claims.iter().map(Claim::status).collect();
    let expected = [
        ClaimStatus::Confirmed,
        ClaimStatus::NotConfirmed,
        ClaimStatus::Partly,
        ClaimStatus::Erratum,
        ClaimStatus::NotTested,
    ];
    assert_eq!(status, expected);
    assert_eq!(
        data.claims[2].finding,
        "The computation finds it, in a sentence that states how far. The computation does not \
         find it."
    );
    assert_eq!(data.claims[4].finding, "");
    let page = reproduce_page(&data);
    assert!(page.contains("Each status follows from the requirements listed with it"));
    assert!(
        page.contains("5 claims: 1 confirmed, 1 partly, 1 not confirmed, 1 erratum, 1 not tested.")
    );
    // Folded to a line each: status, claim, and the number that decides.
    for (class, status, number) in [
        ("confirmed", "confirmed", "0.0074° ≤ 0.02°"),
        ("not-confirmed", "not confirmed", "0.074° &gt; 0.02°"),
        ("partly", "partly", "0.074° &gt; 0.02°"),
        ("erratum", "erratum", "0.26° &gt; 0.02°"),
        ("not-tested", "not tested", ""),
    ] {
        let line = format!(
            "<details class=\"claim {class}\"><summary><span class=\"verdict\">{status}</span>"
        );
        let (_, rest) = page.split_once(&line).expect(status);
        let (line, _) = rest.split_once("</summary>").expect("a line");
        let end = format!("<span class=\"number\">{number}</span>");
        assert!(
            line.ends_with(&end) && line.contains("class=\"said\""),
            "{line}"
        );
    }
    for (mark, value, count) in [("met\">✓", "0.0074°", 2), ("missed\">✗", "0.074°", 2)] {
        let line = format!(
            "aria-label=\"{mark}</span> critical gap of <code>paper</code> less 1.8190°: \
             <b>{value}</b> (at most 0.02°)</li>"
        );
        assert_eq!(page.matches(&line).count(), count, "{line}");
    }
}

/// Before the claims, and before anything else but the title and the lead: Table 2, the portraits, the balls.
#[test]
fn the_page_opens_with_the_reproduction() {
    let page = reproduce_page(&crate::synthetic::reproduce());
    let (html, _) = split(&page);
    let opening = &html[html.find("class=\"opening\"").expect("an opening")
        ..html.find("<main>").expect("the rest")];
    let anchors = ["table-2-drawn", "figure-8-drawn", "figures-13-and-14"];
    let places = anchors.map(|id| opening.find(&format!("<figure id=\"{id}\"")).expect(id));
    assert!(places.is_sorted(), "{places:?}");
    assert!(!html.contains("class=\"head") && html.find("class=\"claim") > html.find("<main>"));
    let specs = specs(&page);
    let figure = |id: &str| &specs.iter().find(|(name, _)| name == id).expect(id).1;
    let traces = figure("table-2-drawn")["data"].as_array().expect("traces");
    let names: Vec<_> = traces
        .iter()
        .map(|trace| trace["name"].as_str().expect("a name"))
        .collect();
    assert_eq!(
        names,
        [
            "theory",
            "published equations",
            "consistent equations",
            "paper, simulated"
        ]
    );
    for trace in traces {
        assert_eq!(
            (&trace["x"][0], &trace["x"][9]),
            (&"(a)".into(), &"(j)".into())
        );
    }
    // The columns are those of their names.
    let table = crate::synthetic::reproduce().table2.expect("a table");
    for (name, formulation, law) in [
        ("published equations", "paper", "coulomb"),
        ("consistent equations", "physical", "smooth"),
    ] {
        let column = (table.variants.iter())
            .position(|v| (v.formulation.as_str(), v.friction_law.as_str()) == (formulation, law))
            .expect(name);
        let trace = traces
            .iter()
            .find(|trace| trace["name"] == name)
            .expect(name);
        let gap = table.rows[1].critical_gap_deg[column].expect("a gap");
        assert!(
            (trace["y"][1].as_f64().expect("a number") - gap).abs() < 1e-4,
            "{name}"
        );
    }
    assert_eq!(
        figure("figure-8-drawn")["data"].as_array().map(Vec::len),
        Some(10)
    );
}

/// A value that its rounding would put onto the limit keeps a digit more.
#[test]
fn a_value_stays_on_its_side_of_the_limit() {
    let claim = |value| {
        Claim::of_the_model(
            "§",
            "Small.",
            vec![Requirement::at_most("x", value, 0.02, "°")],
        )
    };
    for (value, shown) in [(0.0301, "0.03° &gt; 0.02°"), (0.0202, "0.0202° &gt; 0.02°")] {
        let data = ReproduceData {
            claims: vec![claim(value)],
            ..ReproduceData::default()
        };
        assert!(reproduce_page(&data).contains(shown), "{shown}");
    }
}

#[test]
fn code_between_backticks_is_set_as_code() {
    let mut data = crate::synthetic::reproduce();
    data.claims[0].numbers = "0.031° in `paper`, 0.034° in `physical`".into();
    data.claims[0].finding = "found in `paper`".into();
    let (html, _) = split(&reproduce_page(&data));
    assert!(html.contains("0.031° in <code>paper</code>, 0.034° in <code>physical</code>"));
    assert!(!html.contains('`'));
}

/// A remark per row would be a column that is empty but for one cell, and the table wider than
/// the page.
#[test]
fn remarks_of_table_2_stand_in_its_caption() {
    let mut data = crate::synthetic::reproduce();
    let table = data.table2.as_mut().expect("a table");
    table.rows.iter_mut().for_each(|row| row.remark.clear());
    table.rows[4].remark = "repeats the value of 5.40 mm".into();
    let span = format!("{:.2}", table.rows[4].structure.axial_span_mm);
    let (html, _) = split(&reproduce_page(&data));
    let (_, table) = html.split_once("id=\"table-2\"").expect("Table 2");
    let (caption, rows) = table.split_once("<tbody>").expect("rows");
    let said = format!("Marked: <i>l</i><sub>C</sub> {span} mm repeats the value of 5.40 mm.");
    assert!(caption.contains(&said), "{caption}");
    assert!(!caption.contains("Remark"));
    let (rows, _) = rows.split_once("</tbody>").expect("an end");
    assert!(!rows.contains("repeats") && rows.contains("class=\"marked\""));
}
