//! Equivalent loads and lives against worked examples of catalogues, and their continuity.

use cageless::rating::{BasicRatings, EquivalentLoad, LoadFactors, Rating, RowArrangement};
use cageless::{Case, Motion, Row, Tilt};

use crate::common::{conventional, dimensions};

/// A worked example: what a catalogue prints of a bearing in operation, and the digits that it prints.
struct Example {
    name: &'static str,
    arrangement: RowArrangement,
    contact_angle_deg: f64,
    /// f0 Fa/C0r.
    relative_load: f64,
    dynamic_rating_n: f64,
    speed_rpm: f64,
    radial_n: f64,
    axial_n: f64,
    /// Y above e, where it is printed.
    y: Option<f64>,
    equivalent_n: f64,
    life_h: f64,
    /// Relative error of what is printed.
    digits: f64,
}

const DEEP_GROOVE: Example = Example {
    name: "",
    arrangement: RowArrangement::Alike,
    contact_angle_deg: 0.0,
    relative_load: 0.0,
    dynamic_rating_n: 0.0,
    speed_rpm: 0.0,
    radial_n: 0.0,
    axial_n: 0.0,
    y: None,
    equivalent_n: 0.0,
    life_h: 0.0,
    digits: 0.0,
};

/// NTN 2203/E, section 4.5; NSK E1102f, section 5.7; SKF PUB 17000 (2018), sections C.2 and C.3.
const EXAMPLES: [Example; 6] = [
    Example {
        name: "NTN 1, 6208",
        dynamic_rating_n: 32_500.0,
        speed_rpm: 650.0,
        radial_n: 3200.0,
        equivalent_n: 3200.0,
        life_h: 27_000.0,
        digits: 6e-3,
        ..DEEP_GROOVE
    },
    Example {
        name: "NTN 2, 6208",
        // 14.0 · 1.8/17.8, printed as 1.42.
        relative_load: 14.0 * 1.8 / 17.8,
        dynamic_rating_n: 32_500.0,
        speed_rpm: 650.0,
        radial_n: 3200.0,
        axial_n: 1800.0,
        y: Some(1.44),
        equivalent_n: 4380.0,
        life_h: 10_500.0,
        digits: 9e-3,
        ..DEEP_GROOVE
    },
    Example {
        name: "NSK 1, 6208",
        dynamic_rating_n: 29_100.0,
        speed_rpm: 900.0,
        radial_n: 2500.0,
        equivalent_n: 2500.0,
        life_h: 29_000.0,
        digits: 8e-3,
        ..DEEP_GROOVE
    },
    Example {
        name: "NSK 3, 6208",
        relative_load: 14.0 * 1000.0 / 17_900.0,
        dynamic_rating_n: 29_100.0,
        speed_rpm: 900.0,
        radial_n: 2500.0,
        axial_n: 1000.0,
        y: Some(1.67),
        equivalent_n: 3070.0,
        life_h: 15_800.0,
        digits: 3e-3,
        ..DEEP_GROOVE
    },
    Example {
        name: "SKF C.2, 6207",
        dynamic_rating_n: 27_000.0,
        speed_rpm: 2450.0,
        radial_n: 550.0,
        equivalent_n: 550.0,
        life_h: 804_800.0,
        digits: 1e-3,
        ..DEEP_GROOVE
    },
    Example {
        name: "SKF C.3, pair of 7312 BECBP",
        arrangement: RowArrangement::Opposed,
        contact_angle_deg: 40.0,
        dynamic_rating_n: 168_500.0,
        speed_rpm: 3000.0,
        radial_n: 1450.0,
        axial_n: 11_500.0,
        y: Some(0.93),
        equivalent_n: 11_520.0,
        life_h: 17_400.0,
        digits: 3e-3,
        ..DEEP_GROOVE
    },
];

#[test]
fn worked_examples_of_catalogues() {
    for example in EXAMPLES {
        let name = example.name;
        let angle_rad = example.contact_angle_deg.to_radians();
        let factors = LoadFactors::new(angle_rad, example.arrangement, example.relative_load);
        let factors = factors.unwrap();
        let load_n = factors.dynamic_n(example.radial_n, example.axial_n);
        let basic = BasicRatings {
            dynamic_n: example.dynamic_rating_n,
            static_n: 1.0,
        };
        let life_h = basic.l10_mrev(load_n) * 1e6 / (60.0 * example.speed_rpm);
        for (found, printed) in [(load_n, example.equivalent_n), (life_h, example.life_h)] {
            let error = (found / printed - 1.0).abs();
            assert!(error <= example.digits, "{name}: {found} {printed}");
        }
        if let Some(y) = example.y {
            assert!((factors.y - y).abs() < 0.006, "{name}: {}", factors.y);
        }
    }
}

/// Rows of NSK E1102f for angular contact ball bearings: contact angle, Fa/(Z Dw²), e, then Y of a row and of rows
/// back to back, up to and above e; 30° and 40° also Y0.
#[test]
fn factors_are_those_of_a_catalogue() {
    use RowArrangement::{Alike, Opposed};
    for (angle_deg, relative, e, [y, opposed_below, opposed]) in [
        (15.0, 0.172, 0.38, [1.47, 1.65, 2.39]),
        (15.0, 1.03, 0.46, [1.23, 1.38, 2.00]),
        (15.0, 6.89, 0.56, [1.00, 1.12, 1.63]),
        (30.0, 1.0, 0.80, [0.76, 0.78, 1.24]),
        (40.0, 1.0, 1.14, [0.57, 0.55, 0.93]),
    ] {
        let angle_rad = f64::to_radians(angle_deg);
        let [one, two] =
            [Alike, Opposed].map(|rows| LoadFactors::new(angle_rad, rows, relative).unwrap());
        let found = [one.e, two.e, one.y, two.y_below, two.y];
        for (found, expected) in found.into_iter().zip([e, e, y, opposed_below, opposed]) {
            assert!(
                (found - expected).abs() < 1e-9,
                "{angle_deg} {relative}: {found}"
            );
        }
        // P0 of opposed rows is Fr + 2 Y0 Fa.
        let twice = two.static_n(1000.0, 500.0) - 1000.0;
        let once = one.static_n(0.0, 500.0);
        assert!((twice / once - 2.0).abs() < 1e-9, "{angle_deg}");
    }
    // SKF 2018: P0 = 0.6 Fr + 0.5 Fa of deep groove, Fr + 0.52 Fa of opposed 40°.
    let deep_groove = LoadFactors::new(0.0, Alike, 1.0).unwrap();
    assert!((deep_groove.static_n(1000.0, 2000.0) - 1600.0).abs() < 1e-9);
    assert_eq!(deep_groove.static_n(1000.0, 500.0), 1000.0);
    let steep = LoadFactors::new(40f64.to_radians(), Opposed, 1.0).unwrap();
    assert!((steep.static_n(1000.0, 500.0) - 1260.0).abs() < 1e-9);
    assert_eq!(LoadFactors::new(0.8, Alike, 1.0), None);
}

/// No load makes P jump, and none lowers it by more axial load of the same factors: over contact angles and loads.
#[test]
fn the_equivalent_load_is_continuous() {
    for arrangement in [RowArrangement::Alike, RowArrangement::Opposed] {
        for angle in 0..=45 {
            for relative in [0.05, 0.172, 0.5, 1.0, 3.0, 9.0] {
                let angle_rad = f64::from(angle).to_radians();
                let factors = LoadFactors::new(angle_rad, arrangement, relative).unwrap();
                let at = |axial_n: f64| factors.dynamic_n(1000.0, axial_n);
                let limit_n = 1000.0 * factors.e;
                let step = at(limit_n + 1e-6) / at(limit_n) - 1.0;
                assert!(
                    (-1e-12..0.025).contains(&step),
                    "{arrangement:?} {angle} {step}"
                );
                assert_eq!(at(0.0), 1000.0);
                assert!(at(1.1 * limit_n) >= at(limit_n));
            }
        }
    }
}

fn rated(case: &Case) -> Rating {
    let found = cageless::equilibrium::space::solve(case).unwrap();
    Rating::in_space(case, &found)
}

/// One newton along the axis leaves what the plane has, in both directions.
#[test]
fn a_small_axial_load_changes_nothing() {
    let case = conventional(dimensions());
    let plane = Rating::new(&case, &cageless::equilibrium::solve(&case).unwrap());
    for axial_n in [0.0, 1.0, -1.0] {
        let mut space = case.clone();
        space.motion = Motion::Space;
        space.operation.space.axial_load_n = axial_n;
        let space = rated(&space);
        assert_eq!(space.equivalent, plane.equivalent, "{axial_n}");
        assert_eq!(space.l10_mrev, plane.l10_mrev);
        assert_eq!(space.static_safety_factor, plane.static_safety_factor);
    }
}

/// Fr = 1500 N, Fa = 900 N: Fa/(Z Dw²) = 0.70857, e = 0.2612, Y = 1.7008 by interpolation with a calculator.
#[test]
fn a_combined_load_of_a_case() {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = 1500.0;
    case.operation.space.axial_load_n = 900.0;
    let rating = rated(&case);
    let relative = 900.0 / (14.0 * 9.525f64.powi(2));
    let share = (relative - 0.689) / (1.03 - 0.689);
    let load_n = 0.56 * 1500.0 + (1.71 - share * 0.16) * 900.0;
    let found = rating.equivalent.unwrap();
    assert!((found.dynamic_n / load_n - 1.0).abs() < 1e-12);
    assert_eq!(found.static_n, 1500.0);
    let life = (rating.basic.dynamic_n / load_n).powi(3);
    assert!((rating.l10_mrev.unwrap() / life - 1.0).abs() < 1e-12);
    // Of the reference life, whose balls carry what they carry, it is an approximation.
    let ratio = rating.l10_mrev.unwrap() / rating.l10r_mrev.unwrap();
    assert!((0.3..3.0).contains(&ratio), "{ratio}");
}

/// Rows back to back take the load of a pair; in tandem each takes half of the axial load.
#[test]
fn rows_share_the_axial_load_by_their_arrangement() {
    let mut case = conventional(dimensions());
    case.bearing = case
        .bearing
        .with_contact_angle(15f64.to_radians(), 0.0)
        .unwrap();
    case.operation.radial_load_n = 1000.0;
    case.operation.space.axial_load_n = 2000.0;
    let row = |sign: f64| Row {
        contact_sign: sign,
        axial_position_m: -0.01 * sign,
        ..Row::default()
    };
    let of = |rows: Vec<Row>| {
        let case = Case {
            rows,
            ..case.clone()
        };
        EquivalentLoad::new(&case).unwrap()
    };
    let capacity = 14.0 * 9.525f64.powi(2);
    let factors = |arrangement, relative: f64| {
        LoadFactors::new(15f64.to_radians(), arrangement, relative).unwrap()
    };
    let opposed = factors(RowArrangement::Opposed, 2000.0 / capacity);
    let tandem = factors(RowArrangement::Alike, 1000.0 / capacity);
    let expected = [&opposed, &tandem].map(|f| f.dynamic_n(1000.0, 2000.0));
    let found = [-1.0, 1.0].map(|sign| of(vec![row(1.0), row(sign)]).dynamic_n);
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    assert!(expected[0] > expected[1]);
}

#[test]
fn moments_and_tilts_have_no_equivalent_load() {
    let mut case = conventional(dimensions());
    assert!(EquivalentLoad::new(&case).is_some());
    for tilt in [
        Tilt::Held {
            x_rad: 1e-4,
            y_rad: 0.0,
        },
        Tilt::Free {
            moment_x_n_m: 0.0,
            moment_y_n_m: 1.0,
        },
    ] {
        case.operation.space.tilt = tilt;
        assert_eq!(EquivalentLoad::new(&case), None);
    }
    case.operation.space.tilt = Tilt::default();
    case.operation.radial_load_n = 0.0;
    assert_eq!(EquivalentLoad::new(&case), None);
    case.operation.space.axial_load_n = -500.0;
    let axial = EquivalentLoad::new(&case).unwrap();
    assert!(axial.dynamic_n > 500.0 && axial.static_n == 250.0);
}
