//! The studio in pages.

use cageless_report::{engine, reproduce_page, run_page, studio_page};

use crate::synthetic;

/// `text` between `from` and the next `to`.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    let start = text.find(from).expect("begins") + from.len();
    &text[start..start + text[start..].find(to).expect("ends")]
}

#[test]
fn a_studio_page_holds_its_case_whatever_is_in_it() {
    let toml =
        "title = \"</script><script>alert(1)</script> <!-- \\u00e9 θ\"\n[bearing]\nballs = 14\n";
    let page = studio_page(toml);
    let json = between(&page, "data-case>", "</script>");
    assert_eq!(serde_json::from_str::<String>(json).unwrap(), toml);
    assert!(!page.contains("<script>alert"));
    assert!(
        !page.contains("src=\"") && !page.contains("href=\"http"),
        "nothing is loaded"
    );
    // Scripts end where they are closed, not where one of them says so.
    assert_eq!(
        page.matches("<script").count(),
        page.matches("</script>").count()
    );
}

#[test]
fn pages_with_the_engine_stay_small() {
    let page = studio_page("");
    assert!(page.len() < 6_000_000, "{}", page.len());
    let engine = engine().unwrap_or_default().len();
    assert!(
        page.len() - engine < 180_000,
        "{} bytes beside the engine: 180 000 have room for rows, contact angles and their tracks in space",
        page.len() - engine
    );
    // A report grows by the engine and the scripts of the studio.
    assert!(engine < 1_220_000, "{engine}");
}

#[test]
fn a_run_offers_its_case_below_what_was_computed() {
    let page = run_page(&crate::synthetic::run_data());
    let place = page.find("data-studio=\"later\"").expect("a studio");
    assert!(place > page.find("The case as run").expect("the parameters"));
    let without = cageless_report::RunData {
        case_toml: String::new(),
        ..crate::synthetic::run_data()
    };
    assert!(!run_page(&without).contains("data-studio="));
}

#[test]
fn the_reproduction_of_the_paper_offers_structure_d() {
    let page = reproduce_page(&synthetic::reproduce());
    let place = page.find("data-studio=\"later\"").expect("a studio");
    let about = page
        .find("Structure (d) of Table 2")
        .expect("which case it is");
    assert!(about < place && page[place..].contains("structure (d)"));
}
