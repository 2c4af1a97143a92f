//! Files of rotors above several bearings, and plans of them, that are refused.

use crate::common::call_on;
use crate::rotors::{RIGID, written};

#[test]
fn impossible_rotor_files_are_refused_with_line_and_key() {
    let dir = tempfile::tempdir().unwrap();
    for (from, to, said) in [
        (
            "axial_mm = 200.0",
            "axial_mm = -100.0",
            "two bearings are at the same axial place",
        ),
        (
            "mass_kg = 40.0",
            "mass_kg = -40.0",
            "rotor.toml:2: mass_kg = -40: must be more than 0",
        ),
        (
            "mass_kg = 40.0",
            "mas_kg = 40.0",
            "rotor.toml:2: rotor.mas_kg is not a key of [rotor]; did you mean mass_kg?",
        ),
        (
            "mass_kg = 40.0",
            "mass_kg = \"40 kg\"",
            "rotor.toml:2: rotor.mass_kg = \"40 kg\" is not possible",
        ),
        ("speed_rpm = 30000.0\n", "", "rotor.speed_rpm is missing"),
        (
            "case = \"one.toml\"",
            "case = \"none.toml\"",
            "rotor.toml:8: case = \"none.toml\": ",
        ),
        ("case = \"one.toml\"\n", "", "bearing.1.case is missing"),
        (
            "axial_mm = 30.0",
            "node = 3",
            "rotor.toml:16: unbalance.node = 3 is not possible: it must be left out",
        ),
        (
            "amount_g_mm = 200.0",
            "",
            "unbalance.amount_g_mm is missing",
        ),
        (
            "mass_kg = 40.0",
            "matrices = \"none.json\"",
            "polar_inertia_kg_m2 = 0.04 is not possible: it must be left out",
        ),
    ] {
        let path = written(dir.path(), &RIGID.replacen(from, to, 1));
        let answer = call_on("drop", &path, &[], &[]);
        assert_eq!(answer.code, Some(2), "{said}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}

/// What motion in space does not have is refused by the key of the case of its bearing.
#[test]
fn bearings_of_a_rotor_are_refused_by_their_keys() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    let sets = [
        "bearing.2.bearing.contact_angle_deg=15",
        "bearing.2.model.motion=space",
        "bearing.2.contact.friction_law=coulomb",
    ];
    let answer = call_on("drop", &path, &sets, &[]);
    assert_eq!(answer.code, Some(2), "{answer:?}");
    let said =
        "in bearing 2, contact.friction_law = \"coulomb\" is not possible: it must be smooth";
    assert!(answer.stderr.contains(said), "{answer:?}");
}

#[test]
fn changes_reach_the_rotor_all_bearings_or_one() {
    let dir = tempfile::tempdir().unwrap();
    let path = written(dir.path(), RIGID);
    let sets = [
        "rotor.mass_kg=60",
        "bearing.2.axial_mm=100",
        "contact.damping_n_s_m1_5=3e5",
        "bearing.2.contact.damping_n_s_m1_5=4e5",
        "bearing.1.raceway.half_angle_deg=24",
    ];
    let check = call_on("check", &path, &sets, &["--json"]).json();
    let share = check["mass_shares_kg"][0].as_f64().unwrap();
    assert!((share - 30.0).abs() < 1e-9, "{share}");
    let of = |k: usize, section: &str, key: &str| check["cases"][k][section][key].clone();
    assert_eq!(
        [
            of(0, "contact", "damping_n_s_m1_5"),
            of(1, "contact", "damping_n_s_m1_5")
        ],
        [3e5, 4e5]
    );
    let angles = [0, 1].map(|k: usize| check["cases"][k]["raceway"]["half_angle_deg"].clone());
    assert_eq!(angles, [24.0, 25.2]);
    for (set, said) in [
        (
            "rotor.eccentricity_um=3",
            "is replaced by the unbalances of the rotor",
        ),
        (
            "bearing.2.rotor.speed_rpm=3",
            "belongs to the rotor as a whole: write rotor.speed_rpm",
        ),
        (
            "bearing.3.solver.seed=3",
            "there are 2 [[bearing]] sections, counted from 1",
        ),
        (
            "bearing.2.balls=3",
            "write bearing.2.section.key for a key of its case",
        ),
        ("bearing.1.case=x.toml", "stays as the rotor file gives it"),
        (
            "bearing.axial_mm=1",
            "write bearing.1.axial_mm for the first",
        ),
        ("rotor.sped_rpm=1", "did you mean speed_rpm?"),
        ("rotor.mass_kg=-1", "mass_kg = -1: must be more than 0"),
        (
            "bearing.2.rotor.radial_clearance_um=-3",
            "in bearing 2, rotor.radial_clearance_um = -3 is not possible",
        ),
    ] {
        let answer = call_on("check", &path, &[set], &[]);
        assert_eq!(answer.code, Some(2), "{set}: {}", answer.stdout);
        let place = format!("--set {set}: ");
        assert!(
            answer.stderr.contains(&place) && answer.stderr.contains(said),
            "{}",
            answer.stderr
        );
    }
}

/// What follows the case and the computation in a plan of a rotor, the line at fault, and what the
/// message must have.
#[rustfmt::skip]
const PLANS: &[(&str, usize, &[&str])] = &[
    ("compute = [\"static\", \"drop\"]", 2, &["compute has \"static\", which is for the case of one bearing", "there is \"drop\""]),
    ("compute = [\"drop\"]\n[grid]\nrotor.sped_rpm = [1.0]", 4, &["rotor.sped_rpm is not a key of [rotor]", "did you mean speed_rpm?"]),
    ("compute = [\"drop\"]\n[grid]\nunbalance.1.momnt_g_mm = [1.0]", 4, &["unbalance.1.momnt_g_mm is not a key", "did you mean amount_g_mm?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.balls = [12]", 4, &["grid.bearing.2.balls", "did you mean bearing.2.bearing.balls?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.contact.damping_n_s_m1 = [12]", 4, &["bearing.2.contact.damping_n_s_m1 is not a key of [contact]", "did you mean damping_n_s_m1_5?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.racewey.half_angle_deg = [12]", 4, &["bearing.2.racewey is not a section", "did you mean [raceway]?"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.3.contact.damping_n_s_m1_5 = [1e5]", 4, &["there are 2 [[bearing]] sections"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.1.case = [\"one.toml\"]", 4, &["bearing.1.case: stays as the rotor file gives it"]),
    ("compute = [\"drop\"]\n[grid]\nrotor.matrices = [\"m.json\"]", 4, &["rotor.matrices: stays as the rotor file gives it"]),
    ("compute = [\"drop\"]\n[set]\nrotor.eccentricity_um = 3.0", 4, &["is replaced by the unbalances of the rotor"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.rotor.speed_rpm = [1.0]", 4, &["belongs to the rotor as a whole: write rotor.speed_rpm"]),
    ("compute = [\"drop\"]\n[grid]\nrotor.speed_rpm = [\"fast\"]", 4, &["none of the 1 variants", "rotor.speed_rpm = \"fast\" is not possible: it must be a number"]),
    ("compute = [\"drop\"]\n[grid]\nrotor.mass_kg = [-1.0]", 4, &["none of the 1 variants", "mass_kg = -1: must be more than 0"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.solver.duration_s = [0.1]", 0, &["none of the 1 variants", "solver.duration_s is 1.0 in the case of bearing 1 and 0.1 in that of bearing 2"]),
    ("compute = [\"drop\"]\n[grid]\nbearing.2.node = [1]", 4, &["bearing.2.node = 1 is not possible", "a rigid rotor has places"]),
    ("compute = [\"drop\"]\n[grid]\ncontact.damping_n_s_m1_5 = [1e5]\nbearing.1.contact.damping_n_s_m1_5 = [1e5]", 5, &["bearing.1.contact.damping_n_s_m1_5 is a part of contact.damping_n_s_m1_5 on line 4"]),
    ("compute = [\"drop\"]\n[set]\nbearing.1.contact.damping_n_s_m1_5 = 1e5\n[grid]\ncontact.damping_n_s_m1_5 = [1e5]", 4, &["bearing.1.contact.damping_n_s_m1_5 varies on line 6", "[set] has no effect"]),
    ("compute = [\"drop\"]\nkeep = [\"drop_bearing_3_impacts\"]", 3, &["drop_bearing_3_impacts", "there are drop_verdict"]),
    ("compute = [\"drop\"]\n[scatter]\nrotor.transverse_inertia_kg_m2 = \"any\"", 4, &["{ normal = STANDARD_DEVIATION }"]),
];

#[test]
fn wrong_plans_of_a_rotor_are_refused_with_their_place_and_reason() {
    let dir = tempfile::tempdir().unwrap();
    written(dir.path(), RIGID);
    let plan = dir.path().join("plan.toml");
    for (text, line, fragments) in PLANS {
        std::fs::write(&plan, format!("case = \"rotor.toml\"\n{text}\n")).unwrap();
        let out = dir.path().join("out");
        let answer = call_on("sweep", &plan, &[], &["--out", out.to_str().unwrap()]);
        assert_eq!(answer.code, Some(2), "{text}\n{answer:?}");
        assert!(!out.exists(), "{text} left something");
        let place = match line {
            0 => "rotor.toml: ".to_owned(),
            line => format!("plan.toml:{line}: "),
        };
        for fragment in fragments.iter().copied().chain([place.as_str()]) {
            assert!(
                answer.stderr.contains(fragment),
                "{text}\nlacks {fragment:?}: {answer:?}"
            );
        }
    }
    let alone = RIGID.split("[[bearing]]").next().unwrap();
    std::fs::write(
        dir.path().join("rotor.toml"),
        format!("bearing = []\n{alone}"),
    )
    .unwrap();
    std::fs::write(&plan, "case = \"rotor.toml\"\ncompute = [\"drop\"]\n").unwrap();
    let answer = call_on("sweep", &plan, &[], &[]);
    assert_eq!(answer.code, Some(2));
    assert!(
        answer
            .stderr
            .contains("a rotor needs at least one touch-down bearing"),
        "{answer:?}"
    );
}

#[test]
fn files_of_matrices_are_refused_by_name() {
    let dir = tempfile::tempdir().unwrap();
    let file = "[rotor]\nmatrices = \"m.json\"\nspeed_rpm = 1000\n\
                [[bearing]]\ncase = \"one.toml\"\nnode = 0\n[[bearing]]\ncase = \"one.toml\"\nnode = 1\n";
    let path = written(dir.path(), file);
    for (text, said) in [
        ("{", "m.json:1: is no file of the matrices of a rotor"),
        (
            r#"{"schema": 2, "polar_inertia_kg_m2": 1, "M": [], "K": []}"#,
            "schema = 2 is not possible",
        ),
        (
            r#"{"schema": 1, "polar_inertia_kg_m2": 1, "M": [[1, 0], [0]], "K": []}"#,
            "row 2 of M has 1 numbers",
        ),
        (
            r#"{"schema": 1, "polar_inertia_kg_m2": 1, "M": [[1]], "K": [[1]], "X": []}"#,
            "unknown field `X`",
        ),
        (
            r#"{"schema": 1, "polar_inertia_kg_m2": 1, "M": [[1]], "K": [[1]]}"#,
            "matrix M must be of four coordinates a node",
        ),
    ] {
        std::fs::write(dir.path().join("m.json"), text).unwrap();
        let answer = call_on("drop", &path, &[], &[]);
        assert_eq!(answer.code, Some(2), "{said}: {}", answer.stdout);
        assert!(answer.stderr.contains(said), "{said}: {}", answer.stderr);
    }
}
