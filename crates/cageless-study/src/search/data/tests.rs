use cageless::design::search::{
    ClosedForms, Motion, PairSeparation, RacewayLayout, Rejection, Request, Statistics,
};
use cageless_io::case_file::template;

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
            centres_rad: vec![0.0, 30f64.to_radians()],
        },
        placement: 0,
        forms: Some(ClosedForms {
            theoretical_gap_rad: 0.03 + 1e-3 * number,
            steady_gap_rad: 0.04 + 1e-3 * number,
        }),
        spacing: vec![Some(spacing(0.001 * number)), Some(spacing(0.002 * number))],
        motion: vec![Some(motion(number)), Some(motion(10.0 * number))],
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
    });
    (request.starts, request.critical_gap_min_fraction) = (3, 0.7);
    let mut rejected = evaluation(3.0, None);
    rejected.placement = 1;
    rejected.rejection = Some(Rejection {
        cause: Cause::Slips(0.09),
        point: Some(1),
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
    };
    let found = Found {
        maps: vec![map.clone(), map.clone(), map],
        evaluations,
        recommended: Some(1),
        confirmed: vec![confirmed("recommended", 6.0), confirmed("own", 7.0)],
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
fn assert_motion(found: &MotionNumbers, m: &Motion, steady_rad: f64) {
    close(found.collisions, m.collisions);
    close(found.collisions_late, m.collisions_late);
    close(found.impulse_mn_s, 1000.0 * m.impulse_n_s);
    close(found.double_collision_fraction, m.double_collision_fraction);
    close(found.spacing_scatter, m.gap_deviation_rad / steady_rad);
    close(
        found.gap_min_deg,
        m.gap_min_rad * 180.0 / std::f64::consts::PI,
    );
    close(found.sliding_m_s, m.sliding_m_s);
    close(found.speed_drop_fraction, m.speed_drop_fraction);
    close(found.force_deviation_n, m.force_deviation_n);
    close(found.friction_w, m.friction_w);
}

/// Every number of a structure in the unit of its name.
fn assert_structure(found: &StructureData, number: f64) {
    let degrees = |angle: f64| angle * 180.0 / std::f64::consts::PI;
    close(found.axial_span_mm, 5.0 + 0.01 * number);
    close(found.half_angle_deg, 20.0 + number);
    assert_eq!(found.centre_angles_deg, [0.0, 30.0]);
    close(found.beta0_deg.unwrap(), degrees(0.03 + 1e-3 * number));
    close(found.steady_gap_deg.unwrap(), degrees(0.04 + 1e-3 * number));
    for (point, part) in found.points.iter().zip([0.001 * number, 0.002 * number]) {
        close(point.critical_gap_deg.unwrap(), degrees(0.02 + part));
        close(
            point.margin_deg.unwrap(),
            degrees(0.02 + 1e-3 * number - part),
        );
        close(point.slip_shortfall.unwrap(), 0.01 + 2.0 * part);
        close(point.pressure_mpa.unwrap(), 1e3 + 1e6 * part);
    }
}

#[test]
fn structures_have_every_number_in_its_unit() {
    let (file, found) = found();
    let data = search_data(&file, &found, vec![]).unwrap();
    assert_eq!(
        (data.starts, data.critical_gap_min_fraction, data.seed),
        (3, 0.7, file.case().seed)
    );
    let point = data.points[1];
    close(point.inner_speed_rpm, 9_549.296_586);
    assert_eq!(point.radial_load_n, 70.0);
    assert_eq!(data.band.len(), 4);
    for (structure, number) in data.band.iter().zip([4.0, 1.0, 3.0, 5.0]) {
        assert_structure(structure, number);
        for (point, factor) in structure.points.iter().zip([1.0, 10.0]) {
            let steady = 0.04 + 1e-3 * number;
            assert_motion(
                point.motion.as_ref().unwrap(),
                &motion(factor * number),
                steady,
            );
            assert_eq!(point.errors, None);
        }
    }
    let status = |k: usize| (data.band[k].status.as_str(), data.band[k].passes);
    assert_eq!(status(0), ("accepted", Some(true)));
    assert_eq!(status(2), ("rejected", Some(false)));
    assert_eq!(status(3), ("left out", None));
    assert_eq!(data.band[2].reason.as_deref(), Some("slips"));
    assert!(data.band[2].why.contains("9.0 %"), "{}", data.band[2].why);
    // Nearest to the best first.
    let front: Vec<f64> = data.front.iter().map(|s| s.half_angle_deg).collect();
    assert_eq!(front, [21.0, 24.0]);
    for (structure, number) in [(&data.recommended, 6.0), (&data.own, 7.0)] {
        let structure = structure.as_ref().unwrap();
        assert_structure(structure, number);
        for point in &structure.points {
            let steady = 0.04 + 1e-3 * number;
            // Of one and three: mean 2, standard error 1.
            assert_motion(
                point.motion.as_ref().unwrap(),
                &motion(2.0 * number),
                steady,
            );
            assert_motion(point.errors.as_ref().unwrap(), &motion(number), steady);
        }
    }
    let usual = [
        &data.recommended_from_usual_starts,
        &data.own_from_usual_starts,
    ];
    for (structure, number) in usual.into_iter().zip([1.0, 7.0]) {
        let structure = structure.as_ref().unwrap();
        assert_structure(structure, number);
        assert_eq!(structure.points[0].errors, None);
    }
}

#[test]
fn maps_and_places_are_those_of_their_cells_and_structures() {
    let (file, found) = found();
    let data = search_data(&file, &found, vec![]).unwrap();
    let map = &data.maps[0];
    assert_eq!(map.point, data.points[1]);
    for (found, expected) in map.axial_span_mm.iter().zip([5.0, 5.1, 5.2]) {
        close(*found, expected);
    }
    close(map.half_angle_deg[1], 22.918_312);
    for (k, cell) in found.maps[0].cells.iter().enumerate() {
        let (line, column) = (k / 3, k % 3);
        let critical = map.critical_gap_deg[line][column].unwrap();
        close(critical, (0.02 + 1e-3 * k as f64).to_degrees());
        let steady = map.steady_gap_deg[line][column].unwrap();
        close(steady, (0.04 + 1e-3 * k as f64).to_degrees());
        assert_eq!(map.passes[line][column], cell.cause.is_none());
        let verdict = if k == 4 { "eq-8" } else { "smooth" };
        assert_eq!(map.verdict[line][column], verdict);
    }
    // Of the maps at the two operating points, and of the candidates.
    let excluded: Vec<(&str, usize)> = (data.rejections.iter())
        .map(|r| (r.reason.as_str(), r.count))
        .collect();
    assert_eq!(excluded, [("eq-8", 2), ("slips", 1)]);

    let [one, two] = data.placements.as_slice() else {
        panic!("{:?}", data.placements)
    };
    assert_eq!((one.structures, one.accepted), (2, 1));
    assert_eq!((two.structures, two.accepted), (2, 1));
    assert_eq!(two.centre_angles_deg, [-28.647_89, 28.647_89]);
    close(one.least_shortfall.unwrap(), 0.01 + 2.0 * 0.002);
    close(two.least_shortfall.unwrap(), 0.01 + 2.0 * 0.006);
    assert_eq!(one.best.as_ref().unwrap().half_angle_deg, 21.0);
    assert_eq!(two.best.as_ref().unwrap().half_angle_deg, 24.0);

    // The curve of Eq. (11) goes through the structures of Zhao 2022, Table 2.
    let at_5_1 = (data.curve_axial_span_mm.windows(2))
        .position(|w| w[0] <= 5.1 && 5.1 < w[1])
        .unwrap();
    let angles = &data.curve_half_angle_deg[at_5_1..at_5_1 + 2];
    assert!(angles[1] < 25.2 && 25.2 < angles[0], "{angles:?}");
}

/// What the sentences compare is the difference from the same starts over its standard error.
#[test]
fn differences_are_told_from_scatter() {
    let (file, mut found) = found();
    let sentence = |found: &Found| {
        let data = search_data(&file, found, vec![]).unwrap();
        data.findings[1].clone()
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
        ([7.0, 11.0, 13.0], "difference -1.67 ± 0.67 (less)"),
        ([13.0, 13.0, 15.0], "difference +1.67 ± 0.67 (more)"),
        // Differences −3, 0, −1: −1.33 ± 0.88.
        (
            [7.0, 12.0, 13.0],
            "difference -1.33 ± 0.88 (no different within the scatter)",
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
