//! Orbital speeds of the balls, ball advance and drift against closed forms and the motion.

use std::f64::consts::TAU;

use crate::common::{conventional, dimensions, raceway, steel};
use cageless::ball_advance::BallAdvance;
use cageless::equilibrium::settle;
use cageless::simulation::{Control, Ending, Observer, ObserverError, StepView, run};
use cageless::{
    Bearing, BearingDimensions, Case, Formulation, FrictionParameters, IntegrationMethod, Row,
};

fn advance(case: &Case) -> BallAdvance {
    BallAdvance::new(case, &settle(case).unwrap()).unwrap()
}

fn at_load(radial_n: f64, axial_n: f64) -> Case {
    let mut case = conventional(dimensions());
    case.operation.radial_load_n = radial_n;
    case.operation.space.axial_load_n = axial_n;
    case
}

fn weightless(mut case: Case) -> Case {
    case.operation.gravity_m_s2 = 0.0;
    case
}

fn near(found: f64, expected: f64, tolerance: f64) {
    let off = (found / expected - 1.0).abs();
    assert!(off < tolerance, "{found} for {expected}: {off:e}");
}

/// Ω = ½ ωi Ri/|rb|, with clearance and with unequal balls, too. Balls that the outer raceway alone carries keep the
/// energy with which the inner one has released them.
#[test]
fn speeds_in_the_plane_are_the_closed_form() {
    let mut wide = dimensions();
    wide.outer_groove_bottom_radius_m += 4e-6;
    let mut unequal = at_load(1500.0, 0.0);
    let deviations_m = (0..14).map(|k| 1e-7 * f64::from(k % 5)).collect();
    unequal.bearing = unequal
        .bearing
        .with_ball_radius_deviations(deviations_m)
        .unwrap();
    for case in [at_load(1500.0, 0.0), conventional(wide), unequal] {
        let inner_m_s = case.operation.inner_speed_rad_s * 18.24e-3;
        let rest = settle(&case).unwrap().rest;
        let closed = |k: usize| 0.5 * inner_m_s / rest.ball_distance_m[k];
        let floating = advance(&weightless(case.clone()));
        let weighed = advance(&case);
        let height_m = |k: usize| -rest.ball_distance_m[k] * rest.ball_angle_rad[k].cos();
        let energy = |k: usize| {
            let speed_m_s = weighed.orbit_speed_rad_s[k] * rest.ball_distance_m[k];
            0.7 * speed_m_s.powi(2) + 9.81 * height_m(k)
        };
        let free: Vec<usize> = (0..14).filter(|k| rest.inner_force_n[*k] == 0.0).collect();
        assert!((5..11).contains(&free.len()));
        for k in 0..14 {
            let light = settle(&weightless(case.clone())).unwrap().rest;
            near(
                floating.orbit_speed_rad_s[k],
                0.5 * inner_m_s / light.ball_distance_m[k],
                1e-14,
            );
            if !free.contains(&k) {
                near(weighed.orbit_speed_rad_s[k], closed(k), 1e-14);
                continue;
            }
            near(energy(k), energy(free[0]), 1e-9);
            // Its surface rests on the outer raceway.
            let ball_m_s = weighed.rotation_rad_s[k] * case.bearing.ball(k).radius_m;
            near(
                ball_m_s,
                weighed.orbit_speed_rad_s[k] * rest.ball_distance_m[k],
                1e-12,
            );
            // Released between the last ball that carries and the first that does not.
            let at = |k: usize| 0.175 * inner_m_s.powi(2) + 9.81 * height_m(k);
            assert!((at(free[0] - 1)..at(free[0])).contains(&energy(k)));
        }
    }
}

/// Outer raceway control (Harris, *Rolling Bearing Analysis*): ωm/ωi = (1 − γ' cos αi)/(1 + cos(αi − αo)), with the
/// inner contact on the undeformed groove, δi further out than on the ball.
#[test]
fn speeds_under_axial_load_are_those_of_race_control() {
    for (rpm, axial_n) in [(12_000.0, 500.0), (30_000.0, 1000.0)] {
        let mut case = weightless(at_load(0.0, axial_n));
        case.operation.inner_speed_rad_s = rpm * TAU / 60.0;
        let settled = settle(&case).unwrap();
        let rest = &settled.rest;
        let found = advance(&case);
        for k in 0..14 {
            let (ai, ao) = (
                settled.inner_contact_angle_rad[k],
                settled.outer_contact_angle_rad[k],
            );
            assert!(ai - ao > 0.01, "{ai} {ao}");
            let approach = (rest.inner_force_n[k] / rest.inner_stiffness_n_m1_5).powf(2.0 / 3.0);
            let gamma = (4.7625e-3 - approach) / rest.ball_distance_m[k];
            let ratio = (1.0 - gamma * ai.cos()) / (1.0 + (ai - ao).cos());
            near(
                found.orbit_speed_rad_s[k],
                ratio * case.operation.inner_speed_rad_s,
                1e-9,
            );
            near(found.mean_speed_rad_s, found.orbit_speed_rad_s[k], 1e-9);
        }
        // Every ball has the same angles all around.
        assert!(
            found.advance_rad < 1e-9 && found.speed_difference_rad_s < 1e-6,
            "{found:?}"
        );
    }
}

/// No sliding at either contact, by the velocities of vectors: v + **ω**×R**n** is 0 at the outer groove and that of
/// the inner one there, **ω** without a part along the outer normal.
#[test]
fn speeds_under_combined_load_have_no_sliding() {
    let case = at_load(1500.0, 800.0);
    let settled = settle(&case).unwrap();
    let found = advance(&case);
    let (bottom_m, groove_m, ball_m) = (18.24e-3, 4.953e-3, 4.7625e-3);
    for k in 0..14 {
        let (ai, ao) = (
            settled.inner_contact_angle_rad[k],
            settled.outer_contact_angle_rad[k],
        );
        let speed_m_s = found.orbit_speed_rad_s[k] * settled.rest.ball_distance_m[k];
        // In the meridian plane: outer normal, axis across it, inner normal.
        let (outer, inner) = ([ao.cos(), ao.sin()], [-ai.cos(), -ai.sin()]);
        let spin = speed_m_s / ball_m;
        let axis = [-spin * outer[1], spin * outer[0]];
        let along = |n: [f64; 2]| speed_m_s + ball_m * (axis[0] * n[1] - axis[1] * n[0]);
        let ring_m_s =
            case.operation.inner_speed_rad_s * (bottom_m + groove_m + groove_m * inner[0]);
        assert!(along(outer).abs() < 1e-12 * speed_m_s);
        near(along(inner), ring_m_s, 1e-6);
    }
}

/// Rings that press every ball alike, and a discrete raceway: a ball that rolls loses Λ = ∫ (Ω0/Ω − 1) dψ in it, and
/// Ω̄ is Ω0/(1 + Λ/2π). Neighbours are closest on either side of its middle, s apart, with ∫ Ω0/Ω dψ over s the time
/// between them.
#[test]
fn advance_by_a_discrete_raceway_is_the_closed_form() {
    let tight = BearingDimensions {
        inner_groove_bottom_radius_m: 18.242e-3,
        ..dimensions()
    };
    let mut case = weightless(conventional(tight));
    case.operation.radial_load_n = 0.0;
    case.operation.inner_speed_rad_s = 10.0;
    let raceway = raceway(&case.bearing, 5.1, 25.2, 0.0);
    let case = case.with_raceways(vec![raceway]);
    let half = 25.2f64.to_radians();
    // Ω0/Ω = (r + Rw)/2r, by Simpson's rule from the middle.
    let way = |to: f64| {
        let within = to.min(half * (1.0 - 1e-12));
        let at = |psi: f64| {
            let r = case.raceways[0].effective_radius_m(psi);
            0.5 * (r + 4.7625e-3) / r
        };
        let step = within / 200.0;
        let sum: f64 = (0..200)
            .map(|k| {
                let a = f64::from(k) * step;
                (at(a) + 4.0 * at(a + 0.5 * step) + at(a + step)) * step / 6.0
            })
            .sum();
        sum + (to - within)
    };
    let lag = 2.0 * (way(half) - half);
    let found = advance(&case);
    // a is odd about the middle of the raceway.
    let ahead = |to: f64| to - way(to) * TAU / (TAU + lag);
    let least = (0..400).map(|k| ahead(half * f64::from(k) / 400.0));
    near(found.advance_rad, -2.0 * least.fold(0.0, f64::min), 1e-3);
    let between = (TAU + lag) / 14.0;
    let mut ends = [0.0, 0.5 * between];
    for _ in 0..60 {
        let middle = 0.5 * (ends[0] + ends[1]);
        ends[usize::from(2.0 * way(middle) > between)] = middle;
    }
    near(found.clearance_rad, TAU / 14.0 - 2.0 * ends[0], 1e-3);
    assert!(found.clearance_rad < case.bearing.nominal_gap_rad());
}

/// The results are those of the whole turn: they hardly depend on where the balls are.
#[test]
fn results_are_those_of_the_turn() {
    for axial_n in [0.0, 500.0] {
        let mut case = at_load(1500.0, axial_n);
        let found = advance(&case);
        case.start.lead_ball_angle_rad = 0.21;
        let turned = advance(&case);
        near(turned.mean_speed_rad_s, found.mean_speed_rad_s, 1e-5);
        near(
            turned.speed_difference_rad_s,
            found.speed_difference_rad_s,
            0.01,
        );
        near(turned.advance_rad, found.advance_rad, 0.01);
        near(turned.clearance_rad, found.clearance_rad, 0.01);
        assert_eq!(turned.neighbour_drift_rad_s.is_some(), axial_n == 0.0);
    }
}

/// Rows that mirror each other have the same balls, one row after the other.
#[test]
fn rows_follow_each_other() {
    let mut case = at_load(1500.0, 0.0);
    let bearing = Bearing::new(dimensions(), steel()).unwrap();
    case.bearing = bearing.with_contact_angle(0.26, 0.0).unwrap();
    let row = |contact_sign: f64| Row {
        contact_sign,
        axial_position_m: -7e-3 * contact_sign,
        preload_m: 5e-6,
        ..Row::default()
    };
    case.rows = vec![row(1.0), row(-1.0)];
    let found = advance(&case);
    assert_eq!(found.orbit_speed_rad_s.len(), 28);
    for k in 0..14 {
        near(
            found.orbit_speed_rad_s[k + 14],
            found.orbit_speed_rad_s[k],
            1e-9,
        );
    }
    // A spring that presses as much holds the outer ring there.
    let mut sprung = case.clone();
    sprung.rows[1].preload_m = 0.0;
    sprung.rows[1].preload_n = settle(&case).unwrap().row_axial_force_n[1].abs();
    near(advance(&sprung).advance_rad, found.advance_rad, 1e-6);
}

/// The equations as published have Ω of Eq. (3) on Rm for every ball.
#[test]
fn speeds_of_the_published_equations_are_equal() {
    let mut case = weightless(at_load(1500.0, 0.0));
    case.formulation = Formulation::Paper;
    let ratio = 0.5 * 18.24 / 23.0025;
    for speed in advance(&case).orbit_speed_rad_s {
        near(speed, ratio * case.operation.inner_speed_rad_s, 1e-12);
    }
}

#[test]
fn balls_that_nothing_drives_have_no_advance() {
    let still = weightless(at_load(0.0, 0.0));
    let settled = settle(&still).unwrap();
    assert_eq!(BallAdvance::new(&still, &settled), None);
}

/// Times at which each ball ends its turns, and what each gap loses of its mean in the last of them.
#[derive(Default)]
struct Turns {
    first_rad: Vec<f64>,
    last_rad: Vec<f64>,
    ends_s: Vec<Vec<f64>>,
    /// Sum, number and least value of each gap in the present turn of ball 1.
    gaps: Vec<[f64; 3]>,
    lost_rad: f64,
}

impl Turns {
    /// Turns at the start that are left out.
    const SETTLING: usize = 2;

    fn of(case: &Case, turns: f64) -> Self {
        let mut case = case.clone();
        case.solver.method = IntegrationMethod::VelocityVerlet;
        case.solver.step_s = 2e-6;
        case.solver.duration_s = (turns + 0.1) * case.rolling_orbit_s();
        let mut observed = Self::default();
        let outcome = run(&case, &mut [&mut observed], &mut |_| Control::Continue(())).unwrap();
        assert!(
            matches!(outcome.ending, Ending::Complete),
            "{:?}",
            outcome.ending
        );
        observed
    }

    fn speeds_rad_s(&self) -> Vec<f64> {
        let of = |ends_s: &Vec<f64>| {
            let turns = ends_s.len() - Self::SETTLING;
            turns as f64 * TAU / (ends_s.last().unwrap() - ends_s[Self::SETTLING - 1])
        };
        self.ends_s.iter().map(of).collect()
    }

    fn mean_speed_rad_s(&self) -> f64 {
        self.speeds_rad_s().iter().sum::<f64>() / self.ends_s.len() as f64
    }
}

impl Observer for Turns {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let balls = view.contacts.balls();
        let now: Vec<f64> = (0..balls).map(|k| view.angle_after_rad(k)).collect();
        if self.first_rad.is_empty() {
            self.first_rad = now.clone();
            self.ends_s = vec![vec![]; balls];
            self.gaps = vec![[0.0, 0.0, f64::INFINITY]; balls];
        }
        for k in 0..balls {
            let end_rad = self.first_rad[k] + TAU * (self.ends_s[k].len() + 1) as f64;
            let ahead = now[(k + 1) % balls] + if k + 1 == balls { TAU } else { 0.0 };
            let [sum, count, least] = &mut self.gaps[k];
            let gap = ahead - now[k];
            (*sum, *count, *least) = (*sum + gap, *count + 1.0, least.min(gap));
            if now[k] >= end_rad {
                let part = (end_rad - self.last_rad[k]) / (now[k] - self.last_rad[k]);
                let (begin_s, end_s) = (view.step.t0_s, view.step.t1_s);
                self.ends_s[k].push(begin_s + part * (end_s - begin_s));
                if k == 0 {
                    let lost = self
                        .gaps
                        .iter()
                        .map(|[sum, count, least]| sum / count - least);
                    self.lost_rad = lost.sum::<f64>() / balls as f64;
                    self.gaps = vec![[0.0, 0.0, f64::INFINITY]; balls];
                }
            }
        }
        self.last_rad = now;
        Ok(Control::Continue(()))
    }
}

/// Friction with which balls roll nearly without sliding.
fn gripping(mut case: Case) -> Case {
    case.contact.friction = FrictionParameters::smooth(0.1, 0.002);
    case
}

/// In the plane the mean speed of a run misses FTF by 5e-4, and that of the turn by less than 5e-6. A
/// gap loses the clearance of the advance.
#[test]
fn a_run_in_the_plane_has_these_speeds() {
    for case in [at_load(1500.0, 0.0), weightless(at_load(1500.0, 0.0))] {
        let case = gripping(case);
        let (turns, found) = (Turns::of(&case, 5.0), advance(&case));
        near(turns.mean_speed_rad_s(), found.mean_speed_rad_s, 5e-6);
        near(turns.lost_rad, found.clearance_rad, 0.02);
    }
}

/// In space they agree where centrifugal forces are small, so that both contact angles of a ball are equal and no
/// raceway controls its axis; at 12 000 rpm within 1e-3.
#[test]
fn a_run_in_space_has_these_speeds() {
    for (axial_n, slower, mean, lost) in [(1000.0, 12.0, 1e-5, 0.02), (500.0, 1.0, 1e-3, 0.2)] {
        let mut case = gripping(at_load(1500.0, axial_n));
        case.operation.inner_speed_rad_s /= slower;
        let (turns, found) = (Turns::of(&case, 4.0), advance(&case));
        near(turns.mean_speed_rad_s(), found.mean_speed_rad_s, mean);
        near(turns.lost_rad, found.clearance_rad, lost);
    }
}

/// Larger balls gain on smaller ones, within twice the standard error of a run; most of it by the weight.
#[test]
fn unequal_neighbours_drift_apart_as_in_a_run() {
    // Nearly without correlation between neighbours, whose sizes the ring follows.
    const LARGER: [f64; 14] = [
        1.0, 1.0, 1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0,
    ];
    for case in [at_load(1500.0, 0.0), weightless(at_load(1500.0, 0.0))] {
        let mut case = gripping(case);
        let deviations_m = LARGER.map(|sign| 0.25e-6 * sign).to_vec();
        case.bearing = case
            .bearing
            .with_ball_radius_deviations(deviations_m)
            .unwrap();
        let speeds = Turns::of(&case, 8.0).speeds_rad_s();
        let of = |sign: f64| {
            let all = (0..14).filter(|k| LARGER[*k] == sign).map(|k| speeds[k]);
            let all: Vec<f64> = all.collect();
            let count = all.len() as f64;
            let mean = all.iter().sum::<f64>() / count;
            let square: f64 = all.iter().map(|v| (v - mean).powi(2)).sum();
            [mean, square / (count - 1.0) / count]
        };
        let [larger, smaller] = [of(1.0), of(-1.0)];
        let (drift, error) = (larger[0] - smaller[0], (larger[1] + smaller[1]).sqrt());
        let expected = advance(&case).neighbour_drift_rad_s.unwrap();
        assert!(
            (drift - expected).abs() < 2.0 * error,
            "{drift} {expected} {error}"
        );
        assert!(drift > 4.0 * error, "{drift} {error}");
    }
}

/// ±0.1 µm at 1500 N and 12 000 rpm without weight: 0.135 °/s. On the outer raceway alone it would be
/// Ω ΔR/(Ro − R) = 0.248 °/s. The weight makes it 0.688.
#[test]
fn drift_of_the_papers_bearing() {
    let mut case = at_load(1500.0, 0.0);
    let deviations_m = (0..14)
        .map(|k| if k % 2 == 0 { 1e-7 } else { -1e-7 })
        .collect();
    case.bearing = case
        .bearing
        .with_ball_radius_deviations(deviations_m)
        .unwrap();
    let drift = |case: &Case| advance(case).neighbour_drift_rad_s.unwrap().to_degrees();
    near(drift(&weightless(case.clone())), 0.1353, 1e-3);
    near(drift(&case), 0.688, 0.01);
    // Equal balls: a lot of grade G10, ±0.125 µm.
    near(drift(&at_load(1500.0, 0.0)), 1.25 * 0.688, 0.01);
}
