//! Shapes that a search is asked for.

use cageless::{Ends, Raceway, RacewayForm, RacewayShape};
use cageless_io::case_file::{CaseFile, template};

/// All shapes of a search: slots where their edges are given, every other one without edges.
#[test]
fn a_search_tries_slots_with_the_edges_that_it_is_given() {
    let forms = |sets: &[&str]| {
        let all = ["search.shapes=all", "raceway.axial_span_mm=4.5"];
        let sets: Vec<String> = all.iter().chain(sets).map(|set| set.to_string()).collect();
        let file = CaseFile::parse(&template(false), "case", &sets).unwrap();
        for form in &file.search().forms {
            let dimensions = *file.case().raceways[0].dimensions();
            Raceway::formed(dimensions, *form, &file.case().bearing).unwrap();
        }
        file.search().forms.clone()
    };
    let names =
        |forms: &[RacewayForm]| -> Vec<&str> { forms.iter().map(|f| f.shape.name()).collect() };
    let own = ["quartic", "ellipse", "shuttle", "steady"];
    assert_eq!(names(&forms(&["model.motion=space"])), own);
    let given = [
        "model.motion=space",
        "search.edge_radius_mm=0.4",
        "raceway.blend_mm=0.5",
    ];
    let with_slots = forms(&given);
    assert_eq!(names(&with_slots)[..4], own);
    for form in &with_slots[..4] {
        assert_eq!(
            (form.ends, form.edge_radius_m),
            (Ends::Blended(0.5e-3), 0.0)
        );
    }
    let [slot] = &with_slots[4..] else {
        panic!("{with_slots:?}")
    };
    assert_eq!(slot.shape, RacewayShape::Slot);
    assert_eq!((slot.ends, slot.edge_radius_m), (Ends::default(), 0.4e-3));
    let of_slot = forms(&["raceway.shape=slot", "raceway.edge_radius_mm=0.3"]);
    assert_eq!(
        names(&of_slot),
        ["slot", "quartic", "ellipse", "shuttle", "steady"]
    );
}
