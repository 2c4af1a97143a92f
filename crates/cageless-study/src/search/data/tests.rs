use cageless_design::STEADY_GAP;
use cageless_design::search::{
    Cause, ClosedForms, MapCell, Motion, PairSeparation, RacewayLayout, Rejection, Request, Role,
    Statistics,
};
use cageless_io::case_file::template;
use cageless_results::Cell;

use super::*;

/// A number for each field, all of them different.
fn motion(factor: f64) -> Motion {
    Motion::from_values(std::array::from_fn(|k| factor * (k + 2) as f64 / 64.0))
}

fn evaluation(number: f64, objectives: Option<f64>) -> Evaluation {
    let spacing = |part: f64| PairSeparation {
        critical_gap_rad: 0.02 + part,
        shortfall: 0.01 + 2.0 * part,
        stress_pa: 1e9 + 1e12 * part,
    };
    Evaluation {
        structure: RacewayLayout {
            axial_span_m: 5e-3 + 1e-5 * number,
            half_angle_rad: (20.0 + number).to_radians(),
            form: Default::default(),
            section_angle_rad: 0.0,
            centres_rad: vec![0.0, 30f64.to_radians()],
        },
        placement: 0,
        forms: Some(ClosedForms {
            theoretical_gap_rad: 0.03 + 1e-3 * number,
            steady_gap_rad: 0.04 + 1e-3 * number,
            film_lag_rad: 0.02 * number,
        }),
        spacing: vec![Some(spacing(0.001 * number)), Some(spacing(0.002 * number))],
        motion: vec![Some(motion(number)), Some(motion(10.0 * number))],
        axial: vec![],
        rejection: None,
        objectives: objectives.map(|o| [o; 7]),
        on_front: objectives.is_some(),
    }
}

fn found() -> (CaseFile, Found) {
    let file = CaseFile::parse(&template(false), "case.toml", &[]).unwrap();
    let mut request = Request::from_case(file.case());
    request.placements = vec![vec![0.0], vec![-0.5, 0.5]];
    request.points.push(OperatingPoint {
        inner_speed_rad_s: 1000.0,
        radial_load_n: 70.0,
        axial_load_n: 0.0,
    });
    (request.starts, request.critical_gap_min_fraction) = (3, 0.7);
    let mut rejected = evaluation(3.0, None);
    rejected.placement = 1;
    rejected.rejection = Some(Rejection {
        cause: Cause::Missed(STEADY_GAP.of(0.72)),
        point: Some(1),
        bunched: false,
    });
    let mut far = evaluation(4.0, Some(0.9));
    far.placement = 1;
    let evaluations = vec![
        far,
        evaluation(1.0, Some(0.2)),
        rejected,
        evaluation(5.0, None),
    ];
    let cell = |k: usize| MapCell {
        structure: evaluation(k as f64, None).structure,
        forms: evaluation(k as f64, None).forms,
        spacing: evaluation(k as f64, None).spacing[0],
        cause: (k == 4).then_some(Cause::Span),
    };
    let map = SpeedMap {
        point: request.points[1],
        axial_span_m: vec![5e-3, 5.1e-3, 5.2e-3],
        half_angle_rad: vec![0.3, 0.4],
        cells: (0..6).map(cell).collect(),
    };
    let confirmed = |role, number: f64| Confirmed {
        role,
        evaluation: evaluation(number, None),
        statistics: vec![Statistics::new(vec![motion(number), motion(3.0 * number)]); 2],
        bunched: vec![motion(20.0 * number), motion(21.0 * number)],
    };
    let found = Found {
        maps: vec![map.clone(), map.clone(), map],
        evaluations,
        recommended: Some(1),
        confirmed: vec![confirmed(Role::Recommended, 6.0), confirmed(Role::Own, 7.0)],
        request,
    };
    (file, found)
}

fn close(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-9 * expected.abs(),
        "{found} {expected}"
    );
}

/// The numbers of a motion, in the units of their names, over a steady gap of `steady_rad`.
fn assert_motion(found: &Record, m: &Motion, steady_rad: f64) {
    let expected = [
        ("collisions", m.collisions),
        ("collisions_late", m.collisions_late),
        ("impulse_mn_s", 1000.0 * m.impulse_n_s),
        ("double_collision_fraction", m.double_collision_fraction),
        ("spacing_scatter", m.gap_deviation_rad / steady_rad),
        ("gap_min_deg", m.gap_min_rad * 180.0 / std::f64::consts::PI),
        ("sliding_m_s", m.sliding_m_s),
        ("speed_drop_fraction", m.speed_drop_fraction),
        ("lag_fraction", m.lag_fraction),
        ("force_deviation_n", m.force_deviation_n),
        ("friction_w", m.friction_w),
        ("rolling_resistance_w", m.rolling_resistance_w),
    ];
    for (name, expected) in expected {
        close(found.number(name), expected);
    }
    assert_eq!(found.iter().count(), expected.len());
}

/// Every number of a structure in the unit of its name.
fn assert_structure(found: &Record, number: f64) {
    let degrees = |angle: f64| angle * 180.0 / std::f64::consts::PI;
    close(found.number("axial_span_mm"), 5.0 + 0.01 * number);
    close(found.number("half_angle_deg"), 20.0 + number);
    let angles = [0.0, 30.0].map(Cell::Number);
    assert_eq!(found.items("centre_angles_deg"), angles);
    close(
        found.number("film_lag_per_turn_deg"),
        degrees(0.02 * number),
    );
    close(found.number("beta0_deg"), degrees(0.03 + 1e-3 * number));
    close(
        found.number("steady_gap_deg"),
        degrees(0.04 + 1e-3 * number),
    );
    for (point, part) in found
        .parts("points")
        .iter()
        .zip([0.001 * number, 0.002 * number])
    {
        close(point.number("critical_gap_deg"), degrees(0.02 + part));
        close(
            point.number("margin_deg"),
            degrees(0.02 + 1e-3 * number - part),
        );
        close(point.number("slip_shortfall"), 0.01 + 2.0 * part);
        close(point.number("pressure_mpa"), 1e3 + 1e6 * part);
    }
}

#[test]
fn structures_have_every_number_in_its_unit() {
    let (file, found) = found();
    let data = search_record(&file, &found, vec![], &[]);
    let values = ["starts", "critical_gap_min_fraction", "seed"].map(|name| data.number(name));
    assert_eq!(values, [3.0, 0.7, file.particulars().seed as f64]);
    let point = &data.parts("points")[1];
    close(point.number("inner_speed_rpm"), 9_549.296_586);
    assert_eq!(point.number("radial_load_n"), 70.0);
    let band = data.parts("band");
    assert_eq!(band.len(), 4);
    for (structure, number) in band.iter().zip([4.0, 1.0, 3.0, 5.0]) {
        assert_structure(structure, number);
        for (point, factor) in structure.parts("points").iter().zip([1.0, 10.0]) {
            let steady = 0.04 + 1e-3 * number;
            let found = point.part("motion").unwrap();
            assert_motion(found, &motion(factor * number), steady);
            assert_eq!(point.part("errors"), None);
        }
    }
    let status = |k: usize| (band[k].text("status"), band[k].flag("passes"));
    assert_eq!(status(0), ("accepted", Some(true)));
    assert_eq!(status(2), ("rejected", Some(false)));
    assert_eq!(status(3), ("left out", None));
    assert_eq!(band[2].text("reason"), "insufficient-separation");
    assert!(
        band[2].text("why").contains("72.0 %"),
        "{}",
        band[2].text("why")
    );
    // Nearest to the best first.
    let front = data.parts("front").iter();
    let front: Vec<f64> = front.map(|s| s.number("half_angle_deg")).collect();
    assert_eq!(front, [21.0, 24.0]);
    for (name, number) in [("recommended", 6.0), ("own", 7.0)] {
        let structure = data.part(name).unwrap();
        assert_structure(structure, number);
        for point in structure.parts("points") {
            let steady = 0.04 + 1e-3 * number;
            // Of one and three: mean 2, standard error 1.
            let [mean, errors] = ["motion", "errors"].map(|name| point.part(name).unwrap());
            assert_motion(mean, &motion(2.0 * number), steady);
            assert_motion(errors, &motion(number), steady);
        }
    }
    for (name, number) in [
        ("recommended_from_usual_starts", 1.0),
        ("own_from_usual_starts", 7.0),
    ] {
        let structure = data.part(name).unwrap();
        assert_structure(structure, number);
        assert_eq!(structure.parts("points")[0].part("errors"), None);
    }
    let json = serde_json::to_value(&data).unwrap();
    assert_eq!(
        Record::read(&cageless_results::SEARCH_SHAPE, &json),
        Ok(data)
    );
}

#[test]
fn maps_and_places_are_those_of_their_cells_and_structures() {
    let (file, found) = found();
    let data = search_record(&file, &found, vec![], &[]);
    let map = &data.parts("maps")[0];
    assert_eq!(map.part("point"), Some(&data.parts("points")[1]));
    for (found, expected) in map.values("axial_span_mm").iter().zip([5.0, 5.1, 5.2]) {
        close(*found, expected);
    }
    close(map.values("half_angle_deg")[1], 22.918_312);
    for (k, cell) in found.maps[0].cells.iter().enumerate() {
        let at = |name: &str| map.items(name)[k / 3].items()[k % 3].clone();
        let critical = at("critical_gap_deg").number().unwrap();
        close(critical, (0.02 + 1e-3 * k as f64).to_degrees());
        let steady = at("steady_gap_deg").number().unwrap();
        close(steady, (0.04 + 1e-3 * k as f64).to_degrees());
        assert_eq!(at("passes"), Cell::Integer(cell.cause.is_none().into()));
        let verdict = if k == 4 { "eq-8" } else { "smooth" };
        assert_eq!(at("verdict").text(), Some(verdict));
    }
    // Of the maps at the two operating points, and of the candidates.
    let excluded = data.parts("rejections").iter();
    let excluded: Vec<(&str, f64)> = excluded
        .map(|r| (r.text("reason"), r.number("count")))
        .collect();
    assert_eq!(excluded, [("eq-8", 2.0), ("insufficient-separation", 1.0)]);

    let [one, two] = data.parts("placements") else {
        panic!("{:?}", data.parts("placements"))
    };
    for placement in [one, two] {
        let counts = ["structures", "accepted"].map(|name| placement.number(name));
        assert_eq!(counts, [2.0, 1.0]);
    }
    let angles = [-28.647_89, 28.647_89].map(Cell::Number);
    assert_eq!(two.items("centre_angles_deg"), angles);
    close(one.number("least_shortfall"), 0.01 + 2.0 * 0.002);
    close(two.number("least_shortfall"), 0.01 + 2.0 * 0.006);
    let best = |placement: &Record| placement.part("best").unwrap().number("half_angle_deg");
    assert_eq!((best(one), best(two)), (21.0, 24.0));

    // The curve of Eq. (11) goes through the structures of Zhao 2022, Table 2.
    let at_5_1 = (data.values("curve_axial_span_mm").windows(2))
        .position(|w| w[0] <= 5.1 && 5.1 < w[1])
        .unwrap();
    let angles = &data.values("curve_half_angle_deg")[at_5_1..at_5_1 + 2];
    assert!(angles[1] < 25.2 && 25.2 < angles[0], "{angles:?}");
}

/// What the sentences compare is the difference from the same starts over its standard error.
#[test]
fn differences_are_told_from_scatter() {
    let (file, mut found) = found();
    let sentence = |found: &Found| {
        let data = search_record(&file, found, vec![], &[]);
        data.sentences("findings")[2].clone()
    };
    let runs = |values: [f64; 3]| {
        Statistics::new(
            values
                .map(|friction_w| Motion {
                    friction_w,
                    ..Motion::default()
                })
                .to_vec(),
        )
    };
    found.confirmed[1].statistics = vec![runs([10.0, 12.0, 14.0]); 2];
    for (own, word) in [
        // Differences −3, −1, −1: −1.67 ± 0.67, beyond twice its error.
        ([7.0, 11.0, 13.0], "difference −1.67 ± 0.67 (less)"),
        ([13.0, 13.0, 15.0], "difference +1.67 ± 0.67 (more)"),
        // Differences −3, 0, −1: −1.33 ± 0.88.
        (
            [7.0, 12.0, 13.0],
            "difference −1.33 ± 0.88 (no different within the scatter)",
        ),
    ] {
        found.confirmed[0].statistics = vec![runs(own); 2];
        let text = sentence(&found);
        assert!(text.contains(word), "{word}: {text}");
    }
    let text = sentence(&found);
    // Steady gap less critical gap: 0.02 rad at the first point for both.
    assert!(text.contains("reserve 1.146° against 1.146°"), "{text}");
}

/// What more starts reject is named with its reason, next to a recommendation and without one.
#[test]
fn candidates_that_are_not_confirmed_are_named() {
    let (file, mut found) = found();
    let mut failed = found.confirmed[0].clone();
    failed.role = Role::Unconfirmed;
    failed.evaluation.rejection = Some(Rejection {
        cause: Cause::Missed(STEADY_GAP.of(1.338)),
        point: Some(1),
        bunched: true,
    });
    found.confirmed.insert(0, failed);
    let data = search_record(&file, &found, vec![], &[]);
    assert_eq!(data.parts("unconfirmed").len(), 1);
    let unconfirmed = &data.parts("unconfirmed")[0];
    assert_structure(unconfirmed, 6.0);
    let judged = ["status", "reason"].map(|name| unconfirmed.text(name));
    assert_eq!(judged, ["rejected", "excessive-separation"]);
    let named = "lC 5.060 mm, θ 26.00° at ψ = 0°, 30°, the critical gap is 133.8 % of the steady-state gap (80 to \
                 100 % needed, missed by 33.8 percentage points) from a bunched start at 9549 rpm, 70 N";
    let sentence = &data.sentences("findings")[2];
    assert!(
        sentence.starts_with("Better rated, but rejected by the same starts: lC"),
        "{sentence}"
    );
    assert!(sentence.contains(named), "{sentence}");
    found.recommended = None;
    found.confirmed.remove(1);
    let data = search_record(&file, &found, vec![], &[]);
    assert_eq!(data.part("recommended"), None);
    let sentence = &data.sentences("findings")[0];
    let starts = "12 random starts and a bunched one";
    let said = format!(
        "no raceway is recommended: 3 raceways meet every requirement from 3 random starts, but \
         the best fails from {starts}: {named}. The initial design is acceptable. To change: shallower raceways \
         (smaller search.axial_span_mm); where these slide too much, a higher load; or more starts for each raceway \
         (search.initial_states)."
    );
    assert_eq!(sentence, &said);
    // That of the case fails by itself.
    let own = found.confirmed.iter_mut().find(|c| c.role == Role::Own);
    own.unwrap().evaluation.rejection = Some(Rejection {
        cause: Cause::Missed(STEADY_GAP.of(1.42)),
        point: None,
        bunched: false,
    });
    let data = search_record(&file, &found, vec![], &[]);
    let sentence = &data.sentences("findings")[0];
    let gap = "the critical gap is 142.0 % of the steady-state gap";
    let in_oil = format!("The initial design is not what the search looks for in oil: {gap}");
    assert!(sentence.contains(&in_oil), "{sentence}");
    for evaluation in &mut found.evaluations {
        evaluation.forms.as_mut().unwrap().film_lag_rad = 0.0;
    }
    let data = search_record(&file, &found, vec![], &[]);
    let sentence = &data.sentences("findings")[0];
    let fails = format!("The initial design fails as well: {gap}");
    assert!(sentence.contains(&fails), "{sentence}");
}

/// A recommendation says how far balls leave apart, and from which starts it is confirmed; reasons are there or
/// left out, never empty; runs that stopped are counted with the first reason.
#[test]
fn findings_are_plain() {
    let (file, mut found) = found();
    let sentences = |found: &Found| {
        let data = search_record(&file, found, vec![], &[]);
        data.sentences("findings").to_vec()
    };
    let all = sentences(&found);
    // 0.026 rad of 0.046, and 0.032 rad.
    assert_eq!(
        all[0],
        "Recommended: lC 5.060 mm, θ 26.00° at ψ = 0°, 30°; at 12000 rpm, 1500 N balls leave about 1.490° apart; \
         even spacing would give 2.636° (reserve 1.146°); at 9549 rpm, 70 N balls leave about 1.833° apart; even \
         spacing would give 2.636° (reserve 0.802°)."
    );
    assert!(all[1].starts_with("Confirmed from 12 random starts and a bunched one: "));
    let has = |all: &[String], text: &str| all.iter().any(|s| s.contains(text));
    assert!(has(
        &all,
        "2 raceways meet every requirement from 3 random starts; the recommended"
    ));
    let reasons = "Reasons against other raceways, with their number: wider than the groove (Zhao 2022, Eq. (8)) (2); \
                   too shallow: balls leave too close together (1).";
    assert!(has(&all, reasons), "{all:?}");
    assert!(!has(&all, "a run stopped") && !has(&all, "leave 4 raceways"));
    // Without any reason there is no sentence for them, and narrow ranges are named.
    found.request.axial_span_range_m = Some([5e-3, 5.1e-3]);
    found.evaluations[2].rejection = Some(Rejection {
        cause: Cause::Failed("stopped at 0.1 s".to_owned()),
        point: Some(0),
        bunched: false,
    });
    for cell in found.maps.iter_mut().flat_map(|map| &mut map.cells) {
        cell.cause = None;
    }
    let all = sentences(&found);
    assert!(!has(&all, "Reasons against"), "{all:?}");
    assert!(has(
        &all,
        "1 raceway could not be judged, as a run stopped; the first: stopped at 0.1 s."
    ));
    assert!(has(
        &all,
        "search.half_angle_deg leave 4 raceways to be tried"
    ));
}

/// A recommendation whose verdict fails is none.
#[test]
fn a_recommendation_that_fails_its_verdict_is_none() {
    let (file, mut found) = found();
    found.reject_recommended(&Rejection {
        cause: Cause::Verdict("does not work: slips".to_owned()),
        point: Some(0),
        bunched: false,
    });
    let data = search_record(&file, &found, vec![], &[]);
    assert_eq!(
        (data.part("recommended"), data.parts("unconfirmed").len()),
        (None, 1)
    );
    assert!(data.part("recommended_from_usual_starts").is_none());
    let sentence = &data.sentences("findings")[0];
    assert!(
        sentence.contains("with evenly spaced balls does not work: slips at 12000 rpm"),
        "{sentence}"
    );
    let fronts = data
        .parts("front")
        .iter()
        .map(|s| s.number("half_angle_deg"));
    assert_eq!(fronts.collect::<Vec<_>>(), [24.0]);
}
