//! A case file with other values keeps what the user wrote.

use cageless_io::case_file::{CaseFile, SectionValues};

fn parse(text: &str, sets: &[&str]) -> CaseFile {
    let sets: Vec<String> = sets.iter().map(|&set| set.to_owned()).collect();
    CaseFile::parse(text, "case.toml", &sets).unwrap()
}

fn raceway(axial_span_mm: f64, half_angle_deg: f64, centre_angle_deg: f64) -> SectionValues {
    vec![
        ("axial_span_mm", axial_span_mm.into()),
        ("half_angle_deg", half_angle_deg.into()),
        ("centre_angle_deg", centre_angle_deg.into()),
        ("shape", "quartic".into()),
        ("blend_mm", 0.0.into()),
        ("depth_um", 0.0.into()),
        ("depth_error_um", 0.0.into()),
    ]
}

/// The edited text, which must read back as the document.
fn edited(file: &CaseFile, raceways: &[SectionValues]) -> String {
    let mut document = file.document().clone();
    document.set_sections("raceway", raceways);
    let text = file.edited(&document).unwrap();
    assert_eq!(parse(&text, &[]).document(), &document, "{text}");
    text
}

/// Lines of `text` that `before` does not have, and the reverse.
fn changes<'t>(before: &'t str, text: &'t str) -> [Vec<&'t str>; 2] {
    let not_in = |a: &'t str, b: &str| -> Vec<&'t str> {
        a.lines()
            .filter(|line| !b.lines().any(|other| other == *line))
            .collect()
    };
    [not_in(text, before), not_in(before, text)]
}

const CASE: &str = include_str!("../../../cases/zhao-d.toml");

/// Every line but those of the raceway and of `--set` stays, comments and all.
#[test]
fn comments_and_order_stay() {
    let file = parse(
        CASE,
        &[
            "operation.inner_speed_rpm=9000",
            "contact.friction_coefficient=0.1",
            "start.gaps=random",
            "seed=7",
        ],
    );
    let text = edited(&file, &[raceway(5.093, 24.06, 0.0)]);
    let [new, gone] = changes(CASE, &text);
    assert_eq!(
        new,
        [
            "axial_span_mm = 5.093                        # lC",
            "half_angle_deg = 24.06                      # θ",
            "centre_angle_deg = 0.0",
            "shape = \"quartic\"",
            "depth_um = 0.0",
            "depth_error_um = 0.0",
            "inner_speed_rpm = 9000.0",
            "friction_coefficient = 0.1",
            "gaps = \"random\"",
            "seed = 7",
        ]
    );
    assert_eq!(gone.len(), 5, "{gone:?}");
    // Nothing changes where nothing is changed, not even a number with an exponent.
    let same = parse(CASE, &["contact.damping=200000"]);
    let document = same.document().clone();
    let text = same.edited(&document).unwrap();
    let [new, gone] = changes(CASE, &text);
    assert_eq!(
        new,
        [
            "centre_angle_deg = 0.0",
            "shape = \"quartic\"",
            "depth_um = 0.0",
            "depth_error_um = 0.0"
        ]
    );
    assert!(gone.is_empty(), "{gone:?}");
}

/// Raceways come, go and multiply; a seed at the head and a file from Windows stay as they are.
#[test]
fn as_many_raceways_as_there_are() {
    let one = [raceway(4.5, 20.0, 10.0)];
    let two = [raceway(4.5, 20.0, -30.0), raceway(4.4, 21.0, 40.0)];
    let (before, rest) = CASE.split_once("[raceway]").unwrap();
    let (_, after) = rest.split_once("[operation]").unwrap();
    let none = format!("{before}[operation]{after}");
    let many = format!(
        "{before}[[raceway]] # left\naxial_span_mm = 4\nhalf_angle_deg = 22\ncentre_angle_deg = -40\n\
         [[raceway]] # right\naxial_span_mm = 4\nhalf_angle_deg = 22\ncentre_angle_deg = 40\n\
         [operation]{after}"
    );
    let windows = CASE.replace('\n', "\r\n").replace("schema = 1", "seed = 3");
    let windows = format!("\u{feff}{}", windows.replace("seed = 0", "# none"));
    for text in [CASE, &none, &many, &windows] {
        let file = parse(text, &[]);
        for raceways in [&one[..], &two[..], &[]] {
            let found = edited(&file, raceways);
            assert!(found.contains("not in the paper: bearing steel"), "{found}");
            let at = |what: &str| {
                found
                    .find(what)
                    .unwrap_or_else(|| panic!("{what}: {found}"))
            };
            assert!(at("[material]") < at("[operation]") && at("[operation]") < at("[contact]"));
            assert_eq!(found.contains("seed = 3"), text == windows, "{found}");
        }
    }
    let file = parse(&many, &[]);
    let found = edited(&file, &two);
    assert!(found.contains("[[raceway]] # left") && found.contains("[[raceway]] # right"));
    // A result file is written in TOML.
    let json = serde_json::to_string(file.document()).unwrap();
    let found = edited(&parse(&json, &[]), &one);
    assert!(
        found.contains("[raceway]\naxial_span_mm = 4.5\n"),
        "{found}"
    );
}

/// A section that the file gets takes the place of the comments that stand for it; all others stay.
#[test]
fn a_section_replaces_the_comments_that_stand_for_it() {
    let conventional = cageless_io::case_file::template(true);
    let text = edited(&parse(&conventional, &[]), &[raceway(5.1, 25.2, 0.0)]);
    assert!(!text.contains("No [raceway] section"), "{text}");
    let [_, gone] = changes(&conventional, &text);
    assert_eq!(gone.len(), 1, "{gone:?}");
    let section =
        "# `cageless design` proposes a raceway.\n# [raceway]\n# axial_span_mm =\n# blend_mm = 0.5";
    let own = "# my own remark on the [raceway]";
    let commented =
        conventional.replace("[operation]", &format!("{section}\n\n{own}\n\n[operation]"));
    let text = edited(&parse(&commented, &[]), &[raceway(5.1, 25.2, 0.0)]);
    assert!(
        text.contains(own) && !text.contains("# axial_span_mm =\n"),
        "{text}"
    );
    // What stays out keeps its comments.
    let file = parse(&commented, &[]);
    let same = file.edited(file.document()).unwrap();
    assert!(same.contains(section), "{same}");
}
