//! Verdict, search and tolerances of raceways whose balls move in space.

use crate::distinct_rows::distinct_rows;
use cageless::closed_forms::{Eq11, kinematic_gap_rad, kinematic_lag_rad, theoretical_gap_rad};
use cageless::simulation::Control;
use cageless::{Bearing, Case, Gaps, IntegrationMethod, Motion, Raceway, Row, Start, StartState};
use cageless_design::critical_gap::{PairTest, critical_gap_rad};
use cageless_design::search::{
    Cause, ClosedForms, Evaluation, Found, Job, Motion as Perturbed, Numbers, OperatingPoint,
    RacewayLayout, Request, SearchError, Task, UnevenStart, run_jobs, search,
};
use cageless_design::tolerance::{Influence, Outcome, Tolerances, assess, trials};
use cageless_design::{AxialPoint, Judgement, RacewayVerdict, axial_lag, judge};

use crate::common::{dimensions, raceway, steel, structure};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

pub fn go_on(_: f64) -> Control {
    Control::Continue(())
}

/// A case of common as its file would be run in space, dry or lubricated.
pub fn in_space(mut case: Case, friction: f64) -> Case {
    case.motion = Motion::Space;
    case.contact.friction.coefficient = friction;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case
}

/// One dry row with a contact angle of 15° and a shoulder for turned flanks, without a raceway, mostly under
/// axial load.
fn angular_contact() -> Case {
    let mut case = in_space(structure(5.1, 25.2), 0.1);
    let mut dimensions = dimensions();
    dimensions.outer_shoulder_radius_m = 25e-3;
    dimensions.open_to(15.0 * DEGREE, 0.0);
    let bearing = Bearing::new(dimensions, steel()).unwrap();
    case.bearing = bearing.with_contact_angle(15.0 * DEGREE, 0.0).unwrap();
    case.raceways = vec![];
    case.operation.space.axial_load_n = 800.0;
    case.operation.radial_load_n = 300.0;
    case
}

/// Raceway of structure (d) turned by this angle.
fn turned(bearing: &Bearing, section_deg: f64) -> Raceway {
    raceway(bearing, 5.1, 25.2, 0.0)
        .with_section_angle(section_deg * DEGREE, bearing)
        .unwrap()
}

/// Two rows of [`angular_contact`] back to back under a radial load.
fn pair() -> Case {
    let mut case = angular_contact();
    let row = |axial_position_m: f64, contact_sign: f64| Row {
        axial_position_m,
        contact_sign,
        preload_m: 15e-6,
        ..Row::default()
    };
    case.rows = vec![row(-10e-3, 1.0), row(10e-3, -1.0)];
    case.operation.space.axial_load_n = 0.0;
    case.operation.radial_load_n = 1500.0;
    case
}

fn gap_of(case: &Case, row: usize) -> f64 {
    let test = PairTest {
        row,
        tolerance_rad: 1e-5,
        neighbours_wider: 1.4,
        ..PairTest::default()
    };
    critical_gap_rad(case, &test, &mut go_on).unwrap()
}

/// On rigid flanks without a contact angle it is that of Eq. (11) with the polar angle, and the lag that of all
/// of the raceway; a section turned with the contact angle changes nothing of it.
#[test]
fn the_gap_of_rolling_in_space_is_that_of_the_plane() {
    let case = structure(5.1, 25.2);
    let of = |case: &Case| kinematic_gap_rad(&case.bearing, &case.raceways[0], 0.0, 0.0);
    let expected = theoretical_gap_rad(&case.bearing, &case.raceways[0], Eq11::Polar);
    assert!((of(&case) / expected - 1.0).abs() < 1e-6);
    // A raceway narrower than a ball has all of its lag between the balls.
    let short = structure(6.0, 11.0);
    let lag = kinematic_lag_rad(&short.bearing, &short.raceways[0], 0.0, 0.0);
    assert!((of(&short) / lag - 1.0).abs() < 1e-9);
    let bearing = angular_contact().bearing;
    let at = |section_deg: f64| {
        let raceway = turned(&bearing, section_deg);
        kinematic_gap_rad(&bearing, &raceway, section_deg * DEGREE, 0.0)
    };
    assert!((at(15.0) / at(0.0) - 1.0).abs() < 1e-9);
}

/// Dry balls hardly slide: the critical gap is that of rolling at the contact angle and deflection of the most
/// loaded ball, with and without a contact angle, which without the section's turn is gone.
#[test]
fn dry_balls_have_the_critical_gap_of_rolling() {
    let straight = in_space(structure(5.1, 25.2), 0.1);
    let plain = angular_contact();
    let inclined = plain.with_raceways(vec![turned(&plain.bearing, 15.0)]);
    for (case, within) in [(straight, 0.02), (inclined, 0.06)] {
        let seat = OperatingPoint::from_case(&case).row_seats(&case).unwrap()[0];
        let rolling = kinematic_gap_rad(&case.bearing, &case.raceways[0], seat[0], seat[1]);
        let found = gap_of(&case, 0);
        assert!((found / rolling - 1.0).abs() < within, "{found} {rolling}");
    }
}

/// Rows are alike by symmetry, and only then is one of them left out.
#[test]
fn a_pair_has_one_kind_of_row_until_it_is_pushed() {
    let mut case = pair();
    assert_eq!(distinct_rows(&case), [0]);
    let case_with = case.with_raceways(vec![turned(&case.bearing, 15.0)]);
    let [one, other] = [0, 1].map(|row| gap_of(&case_with, row));
    assert!((one / other - 1.0).abs() < 1e-3, "{one} {other}");
    case.operation.space.axial_load_n = 300.0;
    assert_eq!(distinct_rows(&case), [0, 1]);
    let pushed = case.with_raceways(vec![turned(&case.bearing, 15.0)]);
    let [one, other] = [0, 1].map(|row| gap_of(&pushed, row));
    assert!((one / other - 1.0).abs() > 0.02, "{one} {other}");
    let judged = judge(&pushed, &mut go_on).unwrap();
    let least = one.min(other);
    let gap = judged.critical_gap_rad.unwrap();
    // Neighbours as close as at even spacing push the pair together a little.
    assert!((gap / least - 1.0).abs() < 0.03, "{gap} {least}");
    case.operation.space.axial_load_n = 0.0;
    case.rows[1].preload_m = 10e-6;
    assert_eq!(distinct_rows(&case), [0, 1]);
    for row in &mut case.rows {
        (row.contact_sign, row.preload_m) = (1.0, 0.0);
    }
    case.operation.space.axial_load_n = 300.0;
    assert_eq!(distinct_rows(&case), [0]);
}

pub fn criterion(judged: &Judgement, name: &str) -> f64 {
    let of = judged.raceways[0].criteria.iter();
    of.copied().find(|c| c.name() == name).unwrap().value
}

/// The verdict rests on the lag that `design --axial` measures, over that of rolling, and on double collisions.
#[test]
fn a_verdict_in_space_is_that_of_the_lag() {
    let planar = structure(5.1, 25.2);
    let case = in_space(planar.clone(), planar.contact.friction.coefficient);
    let judged = judge(&case, &mut go_on).unwrap();
    assert_eq!(judged.verdict, RacewayVerdict::TooShallow);
    let measured = axial_lag(&in_space(planar, 0.007), AxialPoint::default(), &mut go_on).unwrap();
    let lag = measured.lag.unwrap().lag_rad;
    let rolling = kinematic_lag_rad(&case.bearing, &case.raceways[0], 0.0, 0.0);
    // Of later orbits.
    assert!((criterion(&judged, "lag") / (lag / rolling) - 1.0).abs() < 2e-3);
    assert!(criterion(&judged, "both-neighbours") < 0.25);
    // As far apart as the lag of all balls says.
    let even = std::f64::consts::TAU / 14.0 - case.bearing.ball_angle_rad();
    let steady = judged.steady_gap_rad.unwrap();
    assert!((steady - even - lag / 14.0).abs() < 1e-5);

    let plain = angular_contact();
    let of = |section_deg: f64| {
        let case = plain.with_raceways(vec![turned(&plain.bearing, section_deg)]);
        judge(&case, &mut go_on).unwrap()
    };
    let [straight, inclined] = [0.0, 15.0].map(of);
    assert_eq!(straight.verdict, RacewayVerdict::LosesLag);
    assert!(
        straight
            .deciding
            .is_some_and(|c| c.name() == "lag" && c.value < 0.0)
    );
    assert!(criterion(&inclined, "lag") > 0.8);
    let gaps = [straight, inclined].map(|j| j.critical_gap_rad.unwrap());
    assert!(gaps[0] < 0.5 * gaps[1], "{gaps:?}");
}

/// One start, few runs, one line of constant θ.
pub fn small(case: &Case, half_angle_deg: f64, spans_mm: [f64; 2]) -> Request {
    let mut request = Request::from_case(case);
    request.starts = 1;
    request.budget = request.budget_least();
    request.half_angle_range_rad = Some([half_angle_deg * DEGREE; 2]);
    request.axial_span_range_m = Some(spans_mm.map(|span| span * 1e-3));
    request
}

/// The search with measured critical gaps, as if the motion of all balls accepted every structure.
pub fn found(case: &Case, request: &Request) -> Found {
    let outcome = |job: &Job| match job.task {
        Task::Motion(_) => Ok(Numbers::Motion(Perturbed {
            lag_fraction: 0.9,
            gap_min_rad: 0.1,
            sliding_m_s: job.structure.axial_span_m,
            ..Perturbed::default()
        })),
        _ => run_jobs(case, &[job], &mut go_on).swap_remove(0).unwrap(),
    };
    search(case, request, &mut |_, jobs| {
        Ok(jobs.iter().map(outcome).collect())
    })
    .unwrap()
}

/// The lag of unevenly spaced balls is, over that of rolling, what the verdict has of evenly spaced ones, and those of
/// a section that is not turned lose it.
#[test]
fn balls_that_start_unevenly_keep_the_same_lag() {
    let share = |case: &Case| {
        let job = Job {
            structure: RacewayLayout::from_case(case).unwrap(),
            point: OperatingPoint::from_case(case),
            task: Task::Motion(UnevenStart::Drawn { seed: 0, number: 0 }),
        };
        match run_jobs(case, &[&job], &mut go_on).swap_remove(0) {
            Some(Ok(Numbers::Motion(motion))) => motion.lag_fraction,
            other => panic!("{other:?}"),
        }
    };
    let case = in_space(structure(5.1, 25.2), 0.007);
    let even = criterion(&judge(&case, &mut go_on).unwrap(), "lag");
    let uneven = share(&case);
    assert!((uneven / even - 1.0).abs() < 0.02, "{uneven} {even}");
    let plain = angular_contact();
    let straight = plain.with_raceways(vec![turned(&plain.bearing, 0.0)]);
    assert!(share(&straight) < 0.3, "{}", share(&straight));
}

/// Forced into space, dry: what separates the balls enough without too much begins and ends at the spans where
/// the closed form has these gaps, and the structure that is recommended is one of them.
#[test]
fn the_search_in_space_finds_what_the_closed_form_has() {
    let case = in_space(structure(5.1, 25.2), 0.1);
    let request = small(&case, 25.2, [4.4, 5.9]);
    let found = found(&case, &request);
    let seats = OperatingPoint::from_case(&case).row_seats(&case).unwrap();
    let fraction = |span_m: f64| {
        let raceway = raceway(&case.bearing, span_m * 1e3, 25.2, 0.0);
        ClosedForms::elastic(&case.bearing, &[raceway], &seats).fraction()
    };
    // The span at which the closed form has this share of the steady-state gap, by bisection.
    let span_of = |share: f64| {
        let [mut low, mut high] = [4.4e-3, 5.9e-3];
        while high - low > 1e-7 {
            let middle = 0.5 * (low + high);
            match fraction(middle) < share {
                true => low = middle,
                false => high = middle,
            }
        }
        low
    };
    let gap =
        |e: &Evaluation| e.spacing[0].unwrap().critical_gap_rad / e.forms.unwrap().steady_gap_rad;
    let measured = found.evaluations.iter().filter(|e| e.spacing[0].is_some());
    let spaces = measured.filter(|e| (0.8..=1.0).contains(&gap(e)));
    let spans: Vec<f64> = spaces.map(|e| e.structure.axial_span_m).collect();
    let least = spans.iter().copied().fold(f64::INFINITY, f64::min);
    let most = spans.iter().copied().fold(0.0, f64::max);
    for (found, share) in [(least, 0.8), (most, 1.0)] {
        let expected = span_of(share);
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
    }
    let best = found.recommended.map(|k| &found.evaluations[k]).unwrap();
    assert!((0.8..=1.0).contains(&gap(best)), "{}", gap(best));
    let rolling = best.forms.unwrap().theoretical_gap_rad;
    let critical = best.spacing[0].unwrap().critical_gap_rad;
    assert!((critical / rolling - 1.0).abs() < 0.03);
}

/// At a contact angle of 15° the search takes the section that is turned by it, and says why not the other.
#[test]
fn a_turned_section_beats_a_straight_one() {
    let case = angular_contact();
    let mut request = small(&case, 25.2, [4.6, 5.4]);
    let of_bearing = case.bearing.contact_angle_rad();
    assert_eq!(request.section_angles_rad, [of_bearing]);
    request.section_angles_rad = vec![15.0 * DEGREE, 0.0];
    let found = found(&case, &request);
    let best = found.recommended.map(|k| &found.evaluations[k].structure);
    let section_deg = best.unwrap().section_angle_rad / DEGREE;
    assert!((section_deg - 15.0).abs() < 1e-9, "{section_deg}");
    let straight: Vec<_> = found
        .evaluations
        .iter()
        .filter(|e| e.structure.section_angle_rad == 0.0)
        .collect();
    let why = |e: &&Evaluation| e.rejection.clone().map(|r| r.cause);
    let shallow =
        |cause: Option<Cause>| cause.is_some_and(|c| c.name() == "insufficient-separation");
    assert!(straight.iter().map(why).all(shallow), "{straight:?}");
    // The raceway of a layout is turned by its angle, and no further than its shoulder.
    let layout = |section_angle_rad| RacewayLayout {
        axial_span_m: 5.1e-3,
        half_angle_rad: 25.2 * DEGREE,
        form: Default::default(),
        section_angle_rad,
        centres_rad: vec![0.0],
    };
    let raceways = layout(0.2).raceways(&case.bearing).unwrap();
    assert_eq!(raceways[0].section_angle_rad(), 0.2);
    assert!(layout(0.9).raceways(&case.bearing).is_err());
    let mut pushed = request.clone();
    pushed.points[0].axial_load_n = 1e6;
    let refused = search(&case, &pushed, &mut |_, _| panic!("nothing to compute"));
    assert!(
        matches!(refused, Err(SearchError::Impossible(_))),
        "{refused:?}"
    );
}

/// The slope of a row of the tolerance table is the difference of two designs, and near that of rolling.
#[test]
fn slopes_of_tolerances_are_differences_of_designs() {
    let plain = angular_contact();
    let mut case = plain.with_raceways(vec![turned(&plain.bearing, 15.0)]);
    case.start = Start::new(StartState::Settled, Gaps::Uniform, 0.0);
    let [span_m, section_rad] = [20e-6, 0.5 * DEGREE];
    let tolerances = Tolerances {
        groove_depth_m: 0.0,
        axial_span_m: span_m,
        half_angle_rad: 0.0,
        section_angle_rad: section_rad,
        ball_grade: None,
        friction: 0.0,
        clearance_m: 0.0,
        speed_fraction: 0.0,
        load_fraction: 0.0,
        viscosity_fraction: 0.3,
        supply_factor: 2.0,
    };
    let trials = trials(&case, &tolerances, 0, 1);
    let judged = trials.iter().map(|trial| {
        let varied = trial.deviation.apply(&case).unwrap();
        Some(Outcome::judged(&judge(&varied, &mut go_on).unwrap()))
    });
    let table = assess(&trials, &judged.collect::<Vec<_>>()).influences;
    let deviates: Vec<Influence> = table.iter().map(|row| row.influence).collect();
    assert_eq!(deviates, [Influence::AxialSpan, Influence::SectionAngle]);

    let of = |span_m: f64, section_rad: f64| {
        let raceway = raceway(&case.bearing, span_m * 1e3, 25.2, 0.0)
            .with_section_angle(section_rad, &case.bearing)
            .unwrap();
        let seat = OperatingPoint::from_case(&case).row_seats(&case).unwrap()[0];
        let rolling = kinematic_gap_rad(&case.bearing, &raceway, seat[0], seat[1]);
        let designed = case.with_raceways(vec![raceway]);
        let gap = critical_gap_rad(&designed, &PairTest::default(), &mut go_on);
        [gap.unwrap(), rolling]
    };
    let ends = [
        [-span_m, span_m].map(|by| of(5.1e-3 + by, 15.0 * DEGREE)),
        [-section_rad, section_rad].map(|by| of(5.1e-3, 15.0 * DEGREE + by)),
    ];
    for (row, [low, high]) in table.iter().zip(ends) {
        let [least, most] = row.critical_gap_rad.unwrap();
        let designs = (high[0] - low[0]).abs();
        assert!(
            ((most - least) / designs - 1.0).abs() < 1e-3,
            "{row:?} {designs}"
        );
        let rolling = (high[1] - low[1]).abs();
        assert!(
            (designs / rolling - 1.0).abs() < 0.25,
            "{row:?} {designs} {rolling}"
        );
    }
}

/// A clearance that deviates is a contact angle that deviates; the load and its direction stay as they were.
#[test]
fn clearance_and_load_deviate_in_space() {
    let case = pair();
    let mut tolerances = Tolerances {
        groove_depth_m: 0.0,
        axial_span_m: 0.0,
        half_angle_rad: 0.0,
        section_angle_rad: 0.0,
        ball_grade: None,
        friction: 0.0,
        clearance_m: 4e-6,
        speed_fraction: 0.0,
        load_fraction: 0.0,
        viscosity_fraction: 0.3,
        supply_factor: 2.0,
    };
    let none = trials(&case, &tolerances, 0, 1);
    assert_eq!(none[0].deviation.apply(&case).unwrap(), case);
    // Gr = 2A(1 − cos α0).
    let d = dimensions();
    let room = d.outer_groove_curvature_radius_m + d.inner_groove_curvature_radius_m
        - 2.0 * d.ball_radius_m;
    let clearance = |case: &Case| case.bearing.radial_internal_clearance_m();
    for trial in &none[1..] {
        let varied = trial.deviation.apply(&case).unwrap();
        let by = clearance(&varied) - clearance(&case);
        assert!((by.abs() - 4e-6).abs() < 1e-12, "{by}");
        let angle = varied.bearing.contact_angle_rad();
        let expected = 2.0 * room * (1.0 - angle.cos());
        assert!((expected - clearance(&varied)).abs() < 1e-12);
        assert_eq!(varied.bearing.preload_change_m(), 0.0);
    }
    (tolerances.clearance_m, tolerances.load_fraction) = (0.0, 0.2);
    let mut loaded = angular_contact();
    loaded.raceways = vec![turned(&loaded.bearing, 15.0)];
    for trial in &trials(&loaded, &tolerances, 0, 1)[1..] {
        let varied = trial.deviation.apply(&loaded).unwrap().operation;
        let ratio = varied.space.axial_load_n / varied.radial_load_n;
        assert!((ratio - 800.0 / 300.0).abs() < 1e-12);
        let by = varied.radial_load_n / 300.0 - 1.0;
        assert!((by.abs() - 0.2).abs() < 1e-12);
    }
}
