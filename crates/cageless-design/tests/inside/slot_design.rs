//! Estimate, verdict and search of slots against rolling on two rounded edges.

use cageless::closed_forms::{kinematic_gap_rad, kinematic_lag_rad, seats};
use cageless::equilibrium;
use cageless::simulation::Control;
use cageless::{Case, Raceway, RacewayDimensions, RacewayForm, RacewayShape};
use cageless_design::search::{ClosedForms, Evaluation, OperatingPoint, Request};
use cageless_design::{Estimate, RacewayVerdict, judge, pressure_at_rest_pa};

use super::space_design::{criterion, found, go_on, in_space, small};
use crate::common::{conventional, dimensions};

const EDGE_M: f64 = 1.2e-3;
const THETA_DEG: f64 = 25.2;
/// Fewer than ever lie in ±θ within a hair of a tip.
const POINTS: usize = 40_000;

fn form() -> RacewayForm {
    RacewayForm::default().reshaped(RacewayShape::Slot, EDGE_M)
}

fn slot(case: &Case, span_mm: f64) -> Raceway {
    let dimensions = RacewayDimensions {
        axial_span_m: span_mm * 1e-3,
        half_angle_rad: THETA_DEG.to_radians(),
        centre_angle_rad: 0.0,
    };
    Raceway::formed(dimensions, form(), &case.bearing).unwrap()
}

/// A bearing with a slot of this span, dry or lubricated, at a speed and under a load.
fn slotted(span_mm: f64, friction: f64, speed_rpm: f64, load_n: f64) -> Case {
    let mut case = in_space(conventional(dimensions()), friction);
    case.raceways = vec![slot(&case, span_mm)];
    case.operation.inner_speed_rad_s = speed_rpm * std::f64::consts::TAU / 60.0;
    case.operation.radial_load_n = load_n;
    case
}

/// The bearing's lengths that follow: Rw, Re, Ro, Rm.
fn lengths(case: &Case) -> [f64; 4] {
    let d = case.bearing.dimensions();
    let rm = 0.5 * (d.inner_groove_bottom_radius_m + d.outer_groove_bottom_radius_m);
    let (rw, re) = (d.ball_radius_m, d.outer_groove_curvature_radius_m);
    [rw, re, d.outer_groove_bottom_radius_m, rm]
}

/// Sink of a ball that lies between edges whose centres are `beside` the middle plane.
fn sink_m([rw, re, ..]: [f64; 4], beside: f64) -> f64 {
    let from_groove = |reach: f64| (reach * reach - beside * beside).sqrt();
    from_groove(re + EDGE_M) - from_groove(rw + EDGE_M) - (re - rw)
}

/// A ball that rolls on the inner groove and, with the radius Rw cos α, on two edges: ωi Ri = Ω (Rm + s)(1 + 1/cos α)
/// against ωi Ri = 2 Ω0 Rm outside. All along a slot with half circles for ends.
#[test]
fn the_lag_of_rolling_on_edges() {
    for span_mm in [2.4, 5.1] {
        let case = slotted(span_mm, 0.1, 12e3, 1500.0);
        let of = lengths(&case);
        let [rw, _, ro, rm] = of;
        let half_width = (rw + EDGE_M) * span_mm * 1e-3 / (2.0 * rw);
        let theta = THETA_DEG.to_radians();
        let rate = |psi: f64| {
            let into = ((psi - theta) * ro + half_width).max(0.0);
            let beside = (half_width * half_width - into * into).max(0.0).sqrt();
            let cos = (1.0 - (beside / (rw + EDGE_M)).powi(2)).sqrt();
            (1.0 + sink_m(of, beside) / rm) * 0.5 * (1.0 + 1.0 / cos) - 1.0
        };
        let step = theta / POINTS as f64;
        let lag: f64 = (0..POINTS)
            .map(|k| 2.0 * step * rate((k as f64 + 0.5) * step))
            .sum();
        let found = kinematic_lag_rad(&case.bearing, &case.raceways[0], 0.0, 0.0);
        assert!((found / lag - 1.0).abs() < 1e-5, "{span_mm}: {found} {lag}");
        // Half of it is what the drop of speed in the middle takes within ε, of 23.9°.
        let epsilon = case.bearing.ball_angle_rad();
        let gap = kinematic_gap_rad(&case.bearing, &case.raceways[0], 0.0, 0.0);
        assert!((gap / (epsilon * rate(0.0)) - 1.0).abs() < 1e-9, "{gap}");
    }
}

/// Pressed in, the ball sees the edges where it then is; an inner ring displaced along the axis presses it onto both
/// up to their angle, then onto one alone, in line with the centres of that edge and of the inner groove.
#[test]
fn load_and_contact_angle_on_edges() {
    let case = slotted(3.2, 0.1, 12e3, 1500.0);
    let [rw, re, _, rm] = lengths(&case);
    let (ri, gamma) = (
        case.bearing.dimensions().inner_groove_curvature_radius_m,
        rw / rm,
    );
    let (reach, g, room) = (rw + EDGE_M, re - rw, re + ri - 2.0 * rw);
    let sin: f64 = 3.2e-3 / (2.0 * rw);
    let edge = [reach * (1.0 - sin * sin).sqrt(), reach * sin];
    let farther = 1.0 + sink_m(lengths(&case), edge[1]) / rm;
    let epsilon = case.bearing.ball_angle_rad();
    let gap = |angle: f64, pressed_in: f64| {
        kinematic_gap_rad(&case.bearing, &case.raceways[0], angle, pressed_in) / epsilon
    };
    for pressed_in in [0.0, 8e-6] {
        let cos = (edge[0] - pressed_in) / (edge[0] - pressed_in).hypot(edge[1]);
        for degrees in [0.0f64, 4.0, 9.0] {
            let angle = degrees.to_radians();
            let inner = [room * angle.cos() - g, room * angle.sin()];
            let seated = inner[1].atan2(inner[0]);
            let outside = 1.0 - gamma * angle.cos();
            assert!(seated < cos.acos(), "{degrees}");
            let ratio = outside * (cos + seated.cos()) / (2.0 * (1.0 - gamma * seated.cos()) * cos);
            let found = gap(angle, pressed_in);
            let expected = farther * ratio - 1.0;
            assert!(
                (found - expected).abs() < 1e-9,
                "{degrees}: {found} {expected}"
            );
        }
        let angle = 13f64.to_radians();
        let inner = [room * angle.cos() - g, room * angle.sin()];
        let line = (edge[1] - inner[1]).atan2(edge[0] - inner[0]);
        let ratio = (1.0 - gamma * angle.cos()) / (1.0 - gamma * line.cos());
        let expected = farther * ratio - 1.0;
        let found = gap(angle, pressed_in);
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

/// Dry balls that the inner ring follows into the slot roll: lag and critical gap are those of the closed forms, and
/// the verdict that of balls too far apart for it. Lubricated ones that sink out of its reach lose it, as the estimate says.
#[test]
fn verdicts_on_slots() {
    let case = slotted(3.2, 0.1, 12e3, 1500.0);
    let judged = judge(&case, &mut go_on).unwrap();
    let [angle, pressed_in] = seats(&case, &mut || Control::Continue(())).unwrap()[0];
    let gap = kinematic_gap_rad(&case.bearing, &case.raceways[0], angle, pressed_in);
    let critical = judged.critical_gap_rad.unwrap();
    assert!((critical / gap - 1.0).abs() < 0.02, "{critical} {gap}");
    let rigid = kinematic_lag_rad(&case.bearing, &case.raceways[0], 0.0, 0.0);
    let share = criterion(&judged, "lag");
    let lag = judged.passages.unwrap().lag_mean_rad;
    assert!((share - lag / rigid).abs() < 1e-12);
    let rolling = kinematic_lag_rad(&case.bearing, &case.raceways[0], angle, pressed_in);
    assert!((lag / rolling - 1.0).abs() < 0.02, "{lag} {rolling}");
    assert_eq!(judged.verdict, RacewayVerdict::TooShallow);

    let pressure = judged.pressure_at_rest_pa.unwrap();
    let [inner, outer] = pressure_at_rest_pa(&case).unwrap();
    let below = equilibrium::space::solve(&case).unwrap().rest;
    assert!(pressure == inner.max(outer) && outer >= below.outer_pressure_max_pa);
    assert_eq!(criterion(&judged, "pressure"), pressure / 4.2e9);
    // The same balls on sharp edges.
    let mut sharp = case.clone();
    let form = RacewayForm::default().reshaped(RacewayShape::Slot, 0.1e-3);
    let dimensions = *case.raceways[0].dimensions();
    sharp.raceways = vec![Raceway::formed(dimensions, form, &case.bearing).unwrap()];
    let overloaded = judge(&sharp, &mut go_on).unwrap();
    assert_eq!(
        overloaded.verdict,
        RacewayVerdict::Overloaded,
        "{overloaded:?}"
    );
    assert!(
        overloaded
            .deciding
            .is_some_and(|c| c.name() == "pressure" && c.value > 1.0)
    );

    let deep = slotted(5.1, 0.007, 12e3, 1500.0);
    let lost = judge(&deep, &mut go_on).unwrap();
    assert_eq!(lost.verdict, RacewayVerdict::LosesLag);
    let share_of = |case: &Case| {
        let estimate = Estimate::elastic(
            case,
            &seats(case, &mut || Control::Continue(())).unwrap(),
            None,
        );
        let lag = estimate.terms.iter().find(|t| t.name == "lag");
        lag.unwrap().value
    };
    assert!((share_of(&case) - rolling / rigid).abs() < 1e-12);
    assert!(share_of(&deep) < 0.7, "{}", share_of(&deep));
}

/// Spans of slots that separate balls enough without too much are those at which rolling on the edges does, and
/// the structure that is recommended is one of them, with its edges.
#[test]
fn the_search_finds_slots() {
    let case = slotted(4.6, 0.1, 6e3, 3e3);
    let mut request: Request = small(&case, THETA_DEG, [4.2, 5.2]);
    assert_eq!(request.forms, [form()]);
    request.map_speeds_rad_s.clear();
    let found = found(&case, &request);
    let seats = OperatingPoint::from_case(&case).row_seats(&case).unwrap();
    let fraction = |span_m: f64| {
        ClosedForms::elastic(&case.bearing, &[slot(&case, span_m * 1e3)], &seats).fraction()
    };
    let gap =
        |e: &Evaluation| e.spacing[0].unwrap().critical_gap_rad / e.forms.unwrap().steady_gap_rad;
    let measured: Vec<&Evaluation> = found
        .evaluations
        .iter()
        .filter(|e| e.spacing[0].is_some())
        .collect();
    assert!(measured.len() > 5, "{}", measured.len());
    for e in &measured {
        let rolling = fraction(e.structure.axial_span_m);
        assert!(
            (gap(e) / rolling - 1.0).abs() < 0.04,
            "{} {rolling}",
            gap(e)
        );
    }
    let best = found.recommended.map(|k| &found.evaluations[k]);
    let best = best.unwrap_or_else(|| panic!("{:?}", found.rejections()));
    assert!((0.8..=1.0).contains(&gap(best)), "{}", gap(best));
    assert_eq!(best.structure.form, form());
}
