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
    for (mark, value, count) in [("met\">✓", "0.0074°", 2), ("missed\">✗", "0.074°", 2)] {
        let line = format!(
            "aria-label=\"{mark}</span> critical gap of <code>paper</code> less 1.8190°: \
             <b>{value}</b> (at most 0.02°)</li>"
        );
        assert_eq!(page.matches(&line).count(), count, "{line}");
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
