//! A slot in the bottom of the groove: closed forms, Hertz's theory apart from the library, its motion.

use std::f64::consts::PI;

use cageless::equilibrium;
use cageless::equilibrium::space::solve;
use cageless::numerics::vector::PlaneVector;
use cageless::passage::{PassageRecorder, PassageTally};
use cageless::simulation::{Control, Observer, ObserverError, StepView, run};
use cageless::touchdown::DropRecorder;
use cageless::{
    Case, Ends, Formulation, IntegrationMethod, Raceway, RacewayDimensions, RacewayForm,
    RacewayShape,
};

use crate::common::{complete, drop_case, slotted};

const EDGE: f64 = 0.3e-3;

/// A ball on two circles in the section: where they are, how far it sinks, the ends as they are milled.
#[test]
fn a_ball_rests_on_the_edges() {
    let case = slotted();
    let d = case.bearing.dimensions();
    let (rw, re) = (d.ball_radius_m, d.outer_groove_curvature_radius_m);
    let (ro, raceway) = (d.outer_groove_bottom_radius_m, &case.raceways[0]);
    let slot = raceway.slot().unwrap();
    let theta = raceway.half_angle_rad();
    let middle = (rw + EDGE) * 5.1e-3 / (2.0 * rw);
    assert!((slot.width_m() - 2.0 * (middle - EDGE)).abs() < 1e-15);
    for k in -20..=20 {
        let psi = theta * f64::from(k) / 20.0;
        // Centres of the edges in plan: along the slot, and on a half circle at its end.
        let into = ((psi.abs() - theta) * ro + middle).max(0.0);
        let beside = (middle * middle - into * into).max(0.0).sqrt();
        let [angle, _] = raceway.contact_angle_rad(psi);
        assert!(((rw + EDGE) * angle.sin() - beside).abs() < 1e-9, "{psi}");
        // From the centre of the groove's arc to the edge, and from there to the ball.
        let edge = ((re + EDGE).powi(2) - beside * beside).sqrt();
        let ball = edge - ((rw + EDGE).powi(2) - beside * beside).sqrt();
        let [sink, _] = raceway.depth_at_m(psi);
        assert!((sink - (ball - (re - rw))).abs() < 1e-12, "{psi}");
        let radius = raceway.effective_radius_m(psi);
        assert!((radius - rw * angle.cos()).abs() < 1e-9, "{psi}");
    }
    assert!(raceway.depth_at_m(0.0)[0] > 3e-5);
    assert_eq!(
        raceway.depth_at_m(theta),
        [0.0, raceway.depth_at_m(theta)[1]]
    );
}

/// Complete elliptic integrals of the first and second kind of the parameter 1 − q², by the
/// arithmetic-geometric mean.
fn elliptic(q: f64) -> [f64; 2] {
    let (mut a, mut b, mut c, mut power, mut sum) = (1.0, q, (1.0 - q * q).sqrt(), 0.5, 0.0);
    for _ in 0..12 {
        sum += power * c * c;
        (a, b, c) = ((a + b) / 2.0, f64::sqrt(a * b), (a - b) / 2.0);
        power *= 2.0;
    }
    let first = PI / (2.0 * a);
    [first, first * (1.0 - sum)]
}

/// Approach, semi-axes and pressure of two bodies of steel under a force, with the curvature sums `along`
/// and `across` (Johnson, Contact Mechanics, section 4.2), by bisection of the ratio of the axes.
fn hertz(along: f64, across: f64, force: f64) -> [f64; 4] {
    let modulus = 206e9 / (2.0 * (1.0 - 0.09));
    let (steep, flat) = (along.max(across), along.min(across));
    let (mut low, mut high) = (1e-6, 1.0 - 1e-9);
    for _ in 0..200 {
        let q: f64 = 0.5 * (low + high);
        let [k, e] = elliptic(q);
        let ratio = (e / (q * q) - k) / (k - e);
        (low, high) = if ratio > steep / flat {
            (q, high)
        } else {
            (low, q)
        };
    }
    let q = 0.5 * (low + high);
    let [k, e] = elliptic(q);
    let long = (3.0 * force * (k - e) / (PI * modulus * (1.0 - q * q) * flat)).cbrt();
    let short = q * long;
    let pressure = 1.5 * force / (PI * long * short);
    let approach = 1.5 * force * k / (PI * long * modulus);
    let axes = if along > across {
        [short, long]
    } else {
        [long, short]
    };
    [approach, axes[0], axes[1], pressure]
}

/// Both edges carry a ball as two Hertz contacts of their own.
#[test]
fn edges_are_contacts_of_hertz() {
    for load in [500.0, 9000.0] {
        let mut case = slotted();
        case.operation.radial_load_n = load;
        let rest = solve(&case).unwrap();
        let d = case.bearing.dimensions();
        let (rw, re) = (d.ball_radius_m, d.outer_groove_curvature_radius_m);
        let [force, other] = rest.flank_force_n[0];
        assert!(force > 10.0 && (force - other).abs() < 1e-6 * force);
        let sin: f64 = 5.1e-3 / (2.0 * rw);
        let cos = (1.0 - sin * sin).sqrt();
        let beside = (rw + EDGE) * sin;
        // Centre of an edge from the axis.
        let edge =
            d.outer_groove_bottom_radius_m - re + ((re + EDGE).powi(2) - beside * beside).sqrt();
        let touch = edge - EDGE * cos;
        let along = 1.0 / rw - cos / touch;
        let [approach, rolling, across, pressure] = hertz(along, 1.0 / rw + 1.0 / EDGE, force);
        let apart = (edge - rest.rest.ball_distance_m[0]).hypot(beside);
        let found = rw + EDGE - apart;
        assert!((found / approach - 1.0).abs() < 1e-6, "{found} {approach}");
        let contact = &rest.rest.outer_contact[0];
        assert!((contact.semi_axes_m[0] / rolling - 1.0).abs() < 1e-7);
        assert!((contact.semi_axes_m[1] / across - 1.0).abs() < 1e-7);
        assert!((contact.pressure_pa / pressure - 1.0).abs() < 1e-7);
        assert!((rest.rest.outer_pressure_max_pa / pressure - 1.0).abs() < 1e-7 || load > 1000.0);
    }
}

/// Where the edges have merged with the groove the contact is that of the plain ring.
#[test]
fn the_ends_are_the_plain_groove() {
    let case = slotted();
    let (raceway, bearing) = (&case.raceways[0], &case.bearing);
    let slot = raceway.slot().unwrap();
    let end = slot.contact(raceway.half_angle_rad(), bearing);
    let plain = bearing.outer_contact().stiffness_n_m1_5;
    assert!((end.stiffness_n_m1_5 / plain - 1.0).abs() < 1e-12);
    let section = slot.at(raceway.half_angle_rad());
    let ratio = section.stiffness_ratio[0];
    assert!((ratio - 1.0).abs() < 1e-10, "{ratio}");
    let [first, _] = slot.at(0.0).stiffness_ratio;
    let expected = slot.contact(0.0, bearing).stiffness_n_m1_5 / plain;
    assert!((first / expected - 1.0).abs() < 1e-10);
    assert_eq!(slot.at(0.0).inverse_exponent, [0.4, 0.0]);
}

/// Stiffness, curvature and sink change as a ball enters and leaves: the forces along ψ belong to them.
/// Steps end where the slot does, for the path of a ball has a kink there, which a ball off the middle
/// plane meets at a right angle.
#[test]
fn the_ledger_closes_in_a_slot() {
    let residual = |tolerance, axial_load_n| {
        let mut case = slotted();
        case.solver.method = IntegrationMethod::Adaptive;
        case.solver.tolerance = tolerance;
        case.contact.friction.coefficient = 0.0;
        case.operation.space.axial_load_n = axial_load_n;
        case.solver.duration_s = 2e-3;
        complete(&case).energy_residual_relative.abs()
    };
    for (load, most) in [(0.0, 1e-6), (100.0, 2e-5)] {
        let (coarse, fine) = (residual(1e-6, load), residual(1e-9, load));
        assert!(
            fine < most && fine < 0.05 * coarse,
            "{load} {coarse:e} {fine:e}"
        );
    }
}

/// Under a light load balls in a slot sink out of reach of the inner ring.
#[test]
fn a_slot_unloads_balls() {
    let mut case = slotted();
    case.operation.inner_speed_rad_s /= 12.0;
    case.operation.radial_load_n = 100.0;
    case.solver.method = IntegrationMethod::VelocityVerlet;
    case.solver.step_s = 4e-6;
    case.solver.duration_s = 0.15;
    let mut tally = PassageTally::new();
    let mut recorder = PassageRecorder::new(|passage| {
        tally.add(&passage);
        Ok(())
    });
    run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
    let unloaded = tally.means().unloaded_fraction;
    assert!(unloaded > 0.5, "{unloaded}");
}

/// What a slot cannot be, and what cannot take one, names the key.
/// Largest pressure of the more loaded edge at a ball that stays in the slot.
#[derive(Default)]
struct OnEdge {
    case: Option<Case>,
    pressure_pa: f64,
}

impl Observer for OnEdge {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let case = self.case.as_ref().unwrap();
        let (PlaneVector { x, y }, centre) = (view.positions(), view.outer_ring_m());
        let angle = (x[0] - centre.x).atan2(centre.y - y[0]);
        let slot = case.raceways[0].slot().unwrap();
        let point = view.contacts.outer_point(0);
        let pressure = slot
            .contact(angle, &case.bearing)
            .peak_pressure_pa(point.force_n);
        self.pressure_pa = self.pressure_pa.max(pressure);
        Ok(Control::Continue(()))
    }
}

/// A rotor falls onto a bearing whose lowest ball lies in a slot: its edges bear the largest pressure.
#[test]
fn a_drop_judges_the_pressure_on_edges() {
    let mut case = drop_case().with_raceways(slotted().raceways);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.radial_clearance_m, rotor.vy_m_s) = (1e-6, -0.1);
    case.solver.duration_s = 2e-3;
    let mut drop = DropRecorder::new();
    let mut edge = OnEdge {
        case: Some(case.clone()),
        ..OnEdge::default()
    };
    let outcome = run(&case, &mut [&mut drop, &mut edge], &mut |_| {
        Control::Continue(())
    });
    let summary = drop.summary(&outcome.unwrap().state);
    assert!(edge.pressure_pa > 1e9, "{}", edge.pressure_pa);
    let ratio = summary.outer_pressure_max_pa / edge.pressure_pa;
    assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
    // In a groove the same force presses less.
    let force = summary
        .outer_force_max_n
        .iter()
        .copied()
        .fold(0.0, f64::max);
    let groove = case.bearing.outer_contact().peak_pressure_pa(force);
    assert!(summary.outer_pressure_max_pa > 1.1 * groove);
}

#[test]
fn slots_that_cannot_be() {
    let case = slotted();
    let own = *case.raceways[0].dimensions();
    let form = case.raceway_form();
    let refused = |dimensions: RacewayDimensions, form: RacewayForm| {
        Raceway::formed(dimensions, form, &case.bearing)
            .unwrap_err()
            .field
    };
    let edge = |edge_radius_m| RacewayForm {
        edge_radius_m,
        ..form
    };
    for radius in [0.0, -1e-4, f64::NAN, 5.5e-3] {
        assert_eq!(refused(own, edge(radius)), "edge_radius_m", "{radius}");
    }
    let ellipse = RacewayForm {
        shape: RacewayShape::Ellipse,
        ..form
    };
    assert_eq!(refused(own, ellipse), "edge_radius_m");
    assert_eq!(
        refused(
            own,
            RacewayForm {
                ends: Ends::Blended(1e-4),
                ..form
            }
        ),
        "blend_m"
    );
    assert_eq!(
        refused(
            own,
            RacewayForm {
                depth_m: 1e-6,
                ..form
            }
        ),
        "depth_m"
    );
    let short = RacewayDimensions {
        half_angle_rad: 0.09,
        ..own
    };
    assert_eq!(refused(short, form), "half_angle_rad");
    let mut paper = case.clone();
    paper.formulation = Formulation::Paper;
    assert_eq!(paper.check().unwrap_err().field, "shape");
    assert_eq!(case.check_planar().unwrap_err().field, "edge_radius_m");
    assert!(equilibrium::solve(&case).is_err());
}
