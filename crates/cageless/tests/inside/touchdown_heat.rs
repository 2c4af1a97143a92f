//! Heat of a drop in the parts of the bearing.

use std::f64::consts::PI;

use crate::common::{drop_case, steel};
use cageless::dynamics::energy::EnergyTerm;
use cageless::simulation::{Control, Observer, ObserverError, StepView, run};
use cageless::touchdown::{DropRecorder, DropSummary, InterfaceHeat, PARTS, Thermal};
use cageless::{Bearing, Case, IntegrationMethod, Material, Materials};

fn close(found: f64, expected: f64, relative: f64, what: &str) {
    let error = (found - expected).abs() / expected.abs();
    assert!(error < relative, "{what}: {found} for {expected}");
}

fn dropped(case: &Case, more: &mut dyn Observer) -> (DropSummary, f64, f64) {
    let mut recorder = DropRecorder::new();
    let outcome = run(case, &mut [&mut recorder, more], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    let work = |term| outcome.state.energy_term_j(term);
    let work_j = work(EnergyTerm::Weight) + work(EnergyTerm::Drive);
    let lost_j = work_j - (outcome.end_energy_j - outcome.start_energy_j);
    let flows_j = EnergyTerm::ALL.map(work).iter().map(|j| j.abs()).sum();
    (recorder.summary(&outcome.state), lost_j, flows_j)
}

/// Heat of all interfaces at the end of each step.
#[derive(Default)]
struct Heats(Vec<(f64, f64, f64)>);

impl Observer for Heats {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let (layout, y) = (view.layout(), &view.step.y1);
        let heat = InterfaceHeat::of(|term| y[layout.energy_term(term)]);
        let speed = layout.rotor_motion(y).unwrap().speed;
        self.0.push((view.step.t1_s, heat.total_j(), speed));
        Ok(Control::Continue(()))
    }
}

fn landed(duration_s: f64) -> Case {
    let mut case = drop_case();
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-0.96 * rotor.radial_clearance_m, -0.0625);
    case.solver.duration_s = duration_s;
    case.set_method(IntegrationMethod::VelocityVerlet);
    case
}

/// Heat capacities times rises of temperature, what the rotor takes and what the support takes are the
/// energy that the drop has lost.
#[test]
fn temperatures_close_with_the_energy() {
    let mut case = landed(0.02);
    case.solver.step_s *= 0.5;
    let (summary, lost_j, flows_j) = dropped(&case, &mut Heats::default());
    let capacities = Thermal::default().capacities_j_k(&case.bearing, 1).unwrap();
    let heat = summary.heat;
    let rises_k: [f64; PARTS] = std::array::from_fn(|k| heat.of_parts_j()[k] / capacities[k]);
    let warmed_j: f64 = rises_k.iter().zip(capacities).map(|(k, c)| k * c).sum();
    let elsewhere_j = 0.5 * (heat.rotor_friction_j + heat.rotor_damping_j) + heat.support_damping_j;
    assert!(rises_k.iter().all(|rise_k| *rise_k > 0.0));
    let error = (warmed_j + elsewhere_j - lost_j) / flows_j;
    assert!(error.abs() < 1e-6, "{error:e}");
}

/// The power at the end is the heat of the last fifth after the first contact, from a mark at most 5 ms
/// earlier on; the torque is the power over the speed.
#[test]
fn power_at_the_end_is_that_of_the_last_fifth() {
    let case = landed(0.1);
    let mut heats = Heats::default();
    let (summary, ..) = dropped(&case, &mut heats);
    let end = summary.end_power.unwrap();
    let (end_s, end_j, end_speed) = *heats.0.last().unwrap();
    let from_s = end_s - 0.2 * (end_s - summary.first_contact_s.unwrap());
    let powers = heats.0.iter().filter_map(|(at_s, at_j, speed)| {
        let power_w = (end_j - at_j) / (end_s - at_s);
        let within = (from_s - 0.0051..from_s + 1e-5).contains(at_s);
        within.then_some((power_w, power_w / (0.5 * (speed + end_speed))))
    });
    let nearest = powers.min_by(|a, b| {
        (a.0 - end.total_w)
            .abs()
            .total_cmp(&(b.0 - end.total_w).abs())
    });
    let (power_w, torque_n_m) = nearest.unwrap();
    close(end.total_w, power_w, 1e-9, "power");
    close(end.torque_n_m.unwrap(), torque_n_m, 1e-9, "torque");
    assert!(end.parts_w.iter().sum::<f64>() < end.total_w);
    assert!(torque_n_m > 0.0);
}

/// Capacities are mass times specific heat; a ring by its volume, the balls all together.
#[test]
fn heat_capacities_are_those_of_the_bodies() {
    let case = drop_case();
    let d = case.bearing.dimensions().clone();
    let [inner, balls, outer] = Thermal::default().capacities_j_k(&case.bearing, 1).unwrap();
    // The rows of a pair share the inner ring.
    let pair = Thermal::default().capacities_j_k(&case.bearing, 2).unwrap();
    assert_eq!(pair, [inner, 2.0 * balls, 2.0 * outer]);
    close(inner, d.inner_ring_mass_kg * 460.0, 1e-12, "inner ring");
    let volume_m3 = 4.0 / 3.0 * PI * d.ball_radius_m.powi(3);
    let density = steel().density_kg_m3;
    close(balls, 14.0 * volume_m3 * density * 460.0, 1e-12, "balls");
    let ball_m = 2.0 * d.ball_radius_m;
    let outside_m = d.outer_groove_bottom_radius_m + 0.3 * ball_m;
    let area = PI * (outside_m.powi(2) - d.outer_shoulder_radius_m.powi(2));
    close(
        outer,
        area * 1.6 * ball_m * density * 460.0,
        1e-12,
        "outer ring",
    );

    let given = Thermal {
        outer_ring_mass_kg: Some(0.5),
        ring_specific_heat_j_kg_k: Some(500.0),
        ball_specific_heat_j_kg_k: Some(800.0),
        ..Thermal::default()
    };
    let [_, hybrid_balls, own] = given.capacities_j_k(&case.bearing, 1).unwrap();
    close(own, 250.0, 1e-12, "given outer ring");
    close(hybrid_balls, balls / 460.0 * 800.0, 1e-12, "given balls");

    let ceramic = Materials {
        ball: Material {
            density_kg_m3: 3240.0,
            youngs_modulus_pa: 310e9,
            poisson_ratio: 0.27,
        },
        ring: steel(),
    };
    let hybrid = Bearing::new(d, ceramic).unwrap();
    let error = Thermal::default().capacities_j_k(&hybrid, 1).unwrap_err();
    assert_eq!(error.field, "ball_specific_heat_j_kg_k");
    assert!(given.capacities_j_k(&hybrid, 1).is_ok());
}

/// An adiabatic ring that a rotor brings up to speed by sliding has half of the heat of their sliding,
/// ½ m (Ω Rj)² with 1/m = Rj²/Ip + Rb²/Ji, whatever the path and the bouncing; balls without friction
/// take no part.
#[test]
fn an_adiabatic_ring_has_half_the_heat_of_its_spin_up() {
    let mut case = landed(0.1);
    case.contact.friction.coefficient = 1e-9;
    let rotor = case.rotor.as_mut().unwrap();
    rotor.speed_rad_s = 300.0;
    // Little orbital energy is left.
    rotor.vy_m_s = 0.0;
    let rotor = rotor.clone();
    let bore = case.bearing.inner_ring_bore().unwrap();
    let (summary, ..) = dropped(&case, &mut Heats::default());
    assert!(summary.spin_up_s.is_some());
    let journal_m = bore.radius_m - rotor.radial_clearance_m;
    let effective_kg = 1.0
        / (journal_m.powi(2) / rotor.polar_inertia_kg_m2
            + bore.radius_m.powi(2) / bore.polar_inertia_kg_m2);
    let heat_j = 0.5 * effective_kg * (rotor.speed_rad_s * journal_m).powi(2);
    let capacities = Thermal::default().capacities_j_k(&case.bearing, 1).unwrap();
    let rise_k = summary.heat.of_parts_j()[0] / capacities[0];
    close(
        rise_k,
        0.5 * heat_j / capacities[0],
        1e-2,
        "rise of the ring",
    );
}
