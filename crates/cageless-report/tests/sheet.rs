//! The drawing of an outer ring, against the paper's equations and the case.

use std::path::Path;

use cageless_io::case_file::CaseFile;
use cageless_report::drawing::ring_drawing;
use cageless_study::measured::Limits;

const OUTSIDE: [&str; 2] = [
    "bearing.outer_ring_outer_radius_mm=31",
    "bearing.outer_ring_width_mm=16",
];

fn case(name: &str, sets: &[&str]) -> CaseFile {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
    CaseFile::read(&cases.join(name), &sets).expect("a case")
}

/// Texts of an SVG in their order.
fn texts(svg: &str) -> Vec<String> {
    let parts = svg.split("<text ").skip(1);
    let text = |part: &str| {
        let (_, rest) = part.split_once('>').expect("a tag");
        rest.split_once('<').expect("an end").0.to_owned()
    };
    parts.map(text).collect()
}

/// Diameters, radius and width are twice the radii of the case; tolerances are those given, of the whole angle twice
/// that of θ.
#[test]
fn the_drawing_has_the_dimensions_of_the_case() {
    let file = case("zhao-d.toml", &OUTSIDE);
    let limits = Limits {
        groove_depth_um: 3.0,
        axial_span_um: 40.0,
        half_angle_deg: 0.15,
        centre_angle_deg: Some(0.25),
    };
    let texts = texts(&ring_drawing(&file, &limits).expect("a drawing").svg());
    for expected in [
        "Ø 62",
        "Ø 52",
        "Ø 55.53",
        "R 4.953",
        "16",
        "5.1 ± 0.04",
        "50.4° ± 0.3°",
        "0° ± 0.25°",
        "profile ± 3 µm",
        "blend 0.5",
        "A–A (5 : 1)",
    ] {
        assert!(
            texts.iter().any(|text| text == expected),
            "{expected}: {texts:?}"
        );
    }
}

/// z of the contact points along the raceway: Eq. (4) and (5) of the paper, z = √(Rw² − r²), r the distance of the
/// ball's axis from the contact path; the apex lies by Eq. (7) where two arcs of radius Re meet.
#[test]
fn the_stations_follow_the_equations_of_the_paper() {
    let file = case("zhao-d.toml", &OUTSIDE);
    let svg = ring_drawing(&file, &Limits::default())
        .expect("a drawing")
        .svg();
    let texts = texts(&svg);
    let row = |head: &str| -> Vec<f64> {
        let at = texts.iter().position(|text| text == head).expect("a row");
        let cells = texts[at + 1..at + 6].iter();
        let numbers = cells.map(|cell| cell.trim_end_matches('°').parse().expect("a number"));
        numbers.collect()
    };
    let angles = row("Angle from the middle");
    let spans = row("z between contact points, mm");
    let apexes = row("Radius of the apex, mm");
    let [rw, re, orbit] = [4.7625f64, 4.953, 27.765 - 4.7625];
    let raceway = &file.case().raceways[0];
    // The last is the end, in the blend.
    for k in 0..4 {
        let r = 1e3 * raceway.effective_radius_m(angles[k].to_radians());
        let z = (rw * rw - r * r).sqrt();
        assert!((spans[k] - 2.0 * z).abs() < 6e-4, "{k} {} {z}", spans[k]);
        let (sin, cos) = (z / rw, r / rw);
        let centre = [orbit - (re - rw) * cos, (re - rw) * sin];
        let apex = centre[0] + (re * re - centre[1] * centre[1]).sqrt();
        assert!((apexes[k] - apex).abs() < 6e-5, "{k} {} {apex}", apexes[k]);
    }
    assert_eq!(angles, [0.0, 6.3, 12.6, 18.9, 25.2]);
    assert_eq!((spans[4], apexes[4]), (0.0, 27.765));
}

/// Raceways that differ in nothing but their place share a row; a slot has its own dimensions.
#[test]
fn raceways_of_one_kind_share_a_row() {
    let slot = [
        "raceway.shape=\"slot\"",
        "raceway.edge_radius_mm=0.3",
        "raceway.axial_span_mm=4",
        "raceway.half_angle_deg=15",
        "raceway.centre_angle_deg=60",
    ];
    let file = case("full-6008.toml", &slot);
    let drawn = ring_drawing(&file, &Limits::default()).expect("a drawing");
    let texts = texts(&drawn.svg());
    let slot = file.case().raceways[0].slot().expect("a slot");
    let width = format!("{:.4}", 1e3 * slot.width_m());
    for expected in [
        "Distance of the walls, mm",
        &width,
        "60°",
        "30° ± 0.2°",
        "edges ± 2 µm",
    ] {
        assert!(
            texts.iter().any(|text| text == expected),
            "{expected}: {texts:?}"
        );
    }
}

/// A plain ring has neither the section nor the table of a raceway; without its outside there is no drawing.
#[test]
fn a_plain_ring_is_drawn_and_one_without_its_outside_is_not() {
    let plain = case("full-6205.toml", &[]);
    let texts = texts(
        &ring_drawing(&plain, &Limits::default())
            .expect("a drawing")
            .svg(),
    );
    assert!(texts.iter().any(|text| text == "Ø 46.98"), "{texts:?}");
    assert!(
        !texts
            .iter()
            .any(|text| text.starts_with("B–B") || text.starts_with("Discrete"))
    );
    let error =
        ring_drawing(&case("zhao-d.toml", &[]), &Limits::default()).expect_err("no outside");
    assert!(
        error
            .to_string()
            .contains("outer_ring_outer_radius_mm is missing"),
        "{error}"
    );
}

/// Every place is on the paper, of rings of many sizes and places of the raceway.
#[test]
fn nothing_leaves_the_paper() {
    for (outer, centre) in [
        ("31", "-70"),
        ("29", "0"),
        ("100", "50"),
        ("270", "150"),
        ("31", "-170"),
    ] {
        let sets = [
            format!("bearing.outer_ring_outer_radius_mm={outer}"),
            format!("raceway.centre_angle_deg={centre}"),
            "bearing.outer_ring_width_mm=16".to_owned(),
        ];
        let sets: Vec<&str> = sets.iter().map(String::as_str).collect();
        let svg = ring_drawing(&case("zhao-d.toml", &sets), &Limits::default())
            .expect("a drawing")
            .svg();
        for path in svg.split(" d=\"").skip(1) {
            let path = path.split_once('"').expect("an end").0;
            for place in path
                .split(['M', 'L', 'Z'])
                .filter(|p| !p.is_empty() && !p.contains('A'))
            {
                let (x, y) = place.split_once(' ').expect("two numbers");
                let [x, y]: [f64; 2] = [x, y].map(|number| number.parse().expect("a number"));
                assert!(
                    (8.0..=289.0).contains(&x) && (8.0..=202.0).contains(&y),
                    "{outer} {centre}: {x} {y}"
                );
            }
        }
    }
}
