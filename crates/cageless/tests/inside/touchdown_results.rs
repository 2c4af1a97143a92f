//! Results of a drop against what its states, contacts and energy terms give.

use cageless::dynamics::energy::EnergyTerm;
use cageless::raceway_contact::{RacewayContact, RacewayPoint};
use cageless::simulation::{
    Control, Observer, ObserverError, RotorDrop, RunOutcome, StepView, run,
};
use cageless::touchdown::{DropRecorder, DropSummary, EndState, Scatter};
use cageless::{Case, Gaps, Start, StartState};

use crate::common::{drop_case, raceway};

/// A drop that is about to touch.
fn near(duration_s: f64) -> Case {
    let mut case = drop_case();
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.y_m, rotor.vy_m_s) = (-199e-6, -0.0625);
    case.solver.duration_s = duration_s;
    case
}

fn dropped(case: &Case, observer: &mut dyn Observer) -> (DropSummary, RunOutcome) {
    let mut recorder = DropRecorder::new();
    let outcome = run(case, &mut [&mut recorder, observer], &mut |_| {
        Control::Continue(())
    })
    .unwrap();
    (recorder.summary(&outcome.state), outcome)
}

struct Nothing;
impl Observer for Nothing {
    fn step(&mut self, _: &StepView<'_>) -> Result<Control, ObserverError> {
        Ok(Control::Continue(()))
    }
}

/// x → −x with every rotation reversed: the balls are evenly spaced from the bottom on.
#[test]
fn a_clockwise_rotor_gives_the_mirrored_drop() {
    let mut case = near(0.012);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.friction.coefficient, rotor.vx_m_s) = (0.3, 0.02);
    let (one, _) = dropped(&case, &mut Nothing);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.speed_rad_s, rotor.vx_m_s) = (-rotor.speed_rad_s, -rotor.vx_m_s);
    let (other, _) = dropped(&case, &mut Nothing);
    assert_eq!(one.end_state, other.end_state);
    assert!(
        one.backward_whirl_max_hz > 0.1,
        "{}",
        one.backward_whirl_max_hz
    );
    let pairs = |s: &DropSummary| {
        [
            s.backward_whirl_max_hz,
            s.rotor_force_max_n,
            s.rotor_displacement_max_m,
            s.rotor_sliding_max_m_s,
            s.ring_speed_rad_s.abs(),
            s.heat.rotor_friction_j,
            s.contact_fraction,
        ]
    };
    for (k, (a, b)) in pairs(&one).into_iter().zip(pairs(&other)).enumerate() {
        assert!((a / b - 1.0).abs() < 1e-3, "{k}: {a} {b}");
    }
    assert!(one.ring_speed_rad_s > 0.0 && other.ring_speed_rad_s < 0.0);
}

#[test]
fn heat_of_each_interface_is_its_term_of_the_energy_balance() {
    let case = near(0.01);
    let (summary, outcome) = dropped(&case, &mut Nothing);
    let heat = summary.heat;
    let parts = [
        (heat.rotor_friction_j, EnergyTerm::RotorFriction),
        (heat.rotor_damping_j, EnergyTerm::RotorDamping),
        (heat.inner_friction_j, EnergyTerm::InnerFriction),
        (heat.outer_friction_j, EnergyTerm::OuterFriction),
        (heat.ball_friction_j, EnergyTerm::BallFriction),
        (heat.contact_damping_j, EnergyTerm::Damping),
        (heat.support_damping_j, EnergyTerm::SupportDamping),
    ];
    for (k, (found, term)) in parts.iter().enumerate() {
        assert_eq!(*found, outcome.state.energy_term_j(*term), "{term:?}");
        assert!(
            parts[..k].iter().all(|(other, _)| other != found),
            "{term:?} is not distinct"
        );
    }
    let sum: f64 = parts.iter().map(|(found, _)| found).sum();
    assert!((heat.total_j() / sum - 1.0).abs() < 1e-12);
    // Without friction of the balls there is none of its heat, and no other vanishes.
    let mut smooth = case.clone();
    smooth.contact.friction.coefficient = 0.0;
    let cold = dropped(&smooth, &mut Nothing).0.heat;
    assert_eq!(
        [
            cold.inner_friction_j,
            cold.outer_friction_j,
            cold.ball_friction_j
        ],
        [0.0; 3]
    );
    assert!(cold.rotor_friction_j > 0.0 && cold.support_damping_j > 0.0);
    let mut slippery = case;
    slippery.rotor.as_mut().unwrap().friction.coefficient = 0.0;
    assert_eq!(
        dropped(&slippery, &mut Nothing).0.heat.rotor_friction_j,
        0.0
    );
}

/// Numbers of a drop, gathered from the contacts and the motion of every step.
struct Loads<'c> {
    case: &'c Case,
    outer_pa: f64,
    inside: bool,
    displaced_m: f64,
    rotor_n: f64,
    sliding_m_s: f64,
    /// Time in contact, and times at which it begins.
    touched_s: f64,
    begun_s: Vec<f64>,
    housing_n: f64,
    housing_m: f64,
    /// Largest force of each ball at the inner and the outer raceway.
    balls_n: [Vec<f64>; 2],
    pair_n: f64,
    ball_sliding_m_s: f64,
    slip: Vec<(f64, Option<f64>)>,
}

impl<'c> Loads<'c> {
    fn of(case: &'c Case) -> Self {
        Self {
            case,
            outer_pa: 0.0,
            inside: false,
            displaced_m: 0.0,
            rotor_n: 0.0,
            sliding_m_s: 0.0,
            touched_s: 0.0,
            begun_s: vec![],
            housing_n: 0.0,
            housing_m: 0.0,
            balls_n: [vec![0.0; 14], vec![0.0; 14]],
            pair_n: 0.0,
            ball_sliding_m_s: 0.0,
            slip: vec![],
        }
    }
}

impl Observer for Loads<'_> {
    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let contacts = &view.contacts;
        for k in 0..contacts.balls() {
            let (radius, force) = (contacts.effective_radius_m(k), contacts.outer_force_n(k));
            let point = RacewayPoint::of_outer(radius / self.case.bearing.ball(k).radius_m, force);
            let pressure = RacewayContact::outer(&self.case.bearing, point).pressure_pa;
            if pressure > self.outer_pa {
                self.outer_pa = pressure;
                self.inside = radius < self.case.bearing.ball_radius_m();
            }
            let (inner, slips) = (
                contacts.inner_force_n(k),
                [contacts.inner_sliding_m_s(k), contacts.outer_sliding_m_s(k)],
            );
            for (r, force) in [inner, force].into_iter().enumerate() {
                self.balls_n[r][k] = self.balls_n[r][k].max(force);
                if force > 0.0 {
                    self.ball_sliding_m_s = self.ball_sliding_m_s.max(slips[r].abs());
                }
            }
            if contacts.balls_touch() {
                self.pair_n = self.pair_n.max(contacts.pair_force_n(k));
            }
        }
        let motion = view.layout().rotor_motion(&view.step.y1).unwrap();
        self.displaced_m = self.displaced_m.max(motion.x.hypot(motion.y));
        let rotor = contacts.rotor().unwrap().contact;
        let slip = (rotor.force > 0.0).then(|| rotor.slip.abs());
        if let Some(slip) = slip {
            if self.slip.last().is_none_or(|(_, before)| before.is_none()) {
                self.begun_s.push(view.step.t1_s);
            }
            self.touched_s += view.step.t1_s - view.step.t0_s;
            self.rotor_n = self.rotor_n.max(rotor.force);
            self.sliding_m_s = self.sliding_m_s.max(slip);
        }
        self.slip.push((view.step.t1_s, slip));
        let ring = view.layout().outer_ring_motion(&view.step.y1);
        let support = self.case.support.as_ref().unwrap();
        let [fx, fy] = [(ring.x, ring.vx), (ring.y, ring.vy)]
            .map(|(x, v)| support.stiffness_n_m * x + support.damping_n_s_m * v);
        self.housing_n = self.housing_n.max(fx.hypot(fy));
        self.housing_m = self.housing_m.max(ring.x.hypot(ring.y));
        Ok(Control::Continue(()))
    }
}

/// A drop that bounces, with balls in one row that touch.
#[test]
fn every_number_of_a_drop_follows_from_its_steps() {
    let mut case = near(0.02);
    let mut gaps = vec![0.0; 14];
    gaps[13] = 14.0 * case.bearing.mean_gap_rad();
    case.start = Start::new(StartState::AtRest, Gaps::List(gaps), 0.4);
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.vy_m_s, rotor.vx_m_s) = (-0.1, 0.05);
    let mut steps = Loads::of(&case);
    let (summary, outcome) = dropped(&case, &mut steps);
    let contact_s = outcome.end_s - steps.begun_s[0];
    for (name, found, expected) in [
        ("rotor", summary.rotor_force_max_n, steps.rotor_n),
        ("slip", summary.rotor_sliding_max_m_s, steps.sliding_m_s),
        (
            "contact",
            summary.contact_fraction,
            steps.touched_s / contact_s,
        ),
        (
            "housing",
            summary.housing_force_max_n.unwrap(),
            steps.housing_n,
        ),
        ("sag", summary.housing_displacement_max_m, steps.housing_m),
        (
            "displaced",
            summary.rotor_displacement_max_m,
            steps.displaced_m,
        ),
        ("pair", summary.ball_force_max_n, steps.pair_n),
        (
            "balls",
            summary.ball_sliding_max_m_s,
            steps.ball_sliding_m_s,
        ),
        (
            "inner",
            summary.inner_pressure_max_pa,
            (case.bearing.inner_contact())
                .peak_pressure_pa(steps.balls_n[0].iter().fold(0.0, |m, f| f.max(m))),
        ),
        ("outer", summary.outer_pressure_max_pa, steps.outer_pa),
    ] {
        assert!(
            (found / expected - 1.0).abs() < 1e-9,
            "{name}: {found} {expected}"
        );
    }
    // The windows of the last fifth, whole.
    let from_s = outcome.end_s - 0.2 * contact_s;
    let last = || summary.whirl.iter().filter(|w| w.end_s > from_s);
    let turned_rad: f64 = last().map(|w| w.turned_rad).sum();
    let time_s: f64 = last().map(|w| w.end_s - w.start_s).sum();
    let whirl_hz = turned_rad / (2.0 * std::f64::consts::PI * time_s);
    assert!((summary.end_whirl_hz - whirl_hz).abs() < 1e-9 * whirl_hz.abs());
    assert!(last().count() < summary.whirl.len() && whirl_hz != 0.0);
    assert_eq!(summary.inner_force_max_n, steps.balls_n[0]);
    assert_eq!(summary.outer_force_max_n, steps.balls_n[1]);
    assert_eq!(summary.impacts, steps.begun_s.len() as u64);
    assert!(summary.impacts > 1 && summary.contact_fraction < 0.99 && steps.pair_n > 1.0);
}

/// Nothing has happened to a rotor in the air.
#[test]
fn a_rotor_in_the_air_has_no_contact() {
    let mut case = drop_case();
    case.solver.duration_s = 1e-3;
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.x_m, rotor.y_m) = (60e-6, -80e-6);
    let (summary, _) = dropped(&case, &mut Nothing);
    assert_eq!(summary.end_state, EndState::Falling);
    let DropSummary {
        first_contact_s,
        spin_up_s,
        end_collision_rate_hz,
        ..
    } = summary;
    assert_eq!(
        [first_contact_s, spin_up_s, end_collision_rate_hz],
        [None; 3]
    );
    assert_eq!((summary.impacts, summary.contact_fraction), (0, 0.0));
    assert_eq!(
        [summary.rotor_force_max_n, summary.rotor_sliding_max_m_s],
        [0.0; 2]
    );
    // Fallen by ½ g t²; a rotor on its way up was furthest off at the start.
    let fallen = (60e-6f64).hypot(80e-6 + 0.5 * 9.81 * 1e-6);
    assert!((summary.rotor_displacement_max_m / fallen - 1.0).abs() < 1e-6);
    let rotor = case.rotor.as_mut().unwrap();
    rotor.vy_m_s = 0.02;
    let start = dropped(&case, &mut Nothing).0.rotor_displacement_max_m;
    assert!((start / 1e-4 - 1.0).abs() < 1e-12, "{start}");
}

#[test]
fn pressures_displacement_and_spin_up_follow_from_contacts_and_motion() {
    // The three balls at the bottom, which carry the most, are in a raceway. A light ring under a
    // slow rotor with much friction comes up to speed within the run.
    let mut case = near(0.03);
    let mut bore = case.bearing.inner_ring_bore().unwrap();
    bore.polar_inertia_kg_m2 = 5e-6;
    case.bearing = case.bearing.with_inner_ring_bore(bore).unwrap();
    case.contact.friction.coefficient = 0.007;
    let rotor = case.rotor.as_mut().unwrap();
    (rotor.speed_rad_s, rotor.friction.coefficient) = (300.0, 0.3);
    let raceway = raceway(&case.bearing, 4.95, 35.0, 0.0);
    let case = case.with_raceways(vec![raceway]);
    let mut loads = Loads::of(&case);
    let (summary, _) = dropped(&case, &mut loads);
    assert!(loads.inside, "the largest pressure is on a raceway");
    assert!((summary.outer_pressure_max_pa / loads.outer_pa - 1.0).abs() < 1e-12);
    let displaced = summary.rotor_displacement_max_m;
    assert!((displaced / loads.displaced_m - 1.0).abs() < 1e-12);
    assert!(displaced > 2e-4, "beyond the clearance: {displaced}");
    // From the start of the drop, not from the first contact.
    let touching = || {
        loads
            .slip
            .iter()
            .filter_map(|(time, slip)| Some((*time, (*slip)?)))
    };
    let (first_s, first) = touching().next().unwrap();
    let up = touching().find(|(_, slip)| *slip < 0.01 * first).unwrap();
    assert!(first_s > 1e-5);
    assert_eq!(summary.first_contact_s, Some(first_s));
    assert_eq!(summary.spin_up_s, Some(up.0));
}

#[test]
fn scattered_values_stay_within_their_widths_and_reach_them() {
    let case = drop_case();
    let scatter = Scatter::default();
    let drop = RotorDrop::of_case(&case).unwrap();
    let drawn: Vec<_> = (0..200)
        .map(|index| scatter.draw(&drop, 0, index).1)
        .collect();
    let rotor = case.rotor.as_ref().unwrap();
    let within = |name: &str, of: &dyn Fn(usize) -> f64, [least, most]: [f64; 2]| {
        let all: Vec<f64> = (0..200).map(of).collect();
        let [low, high] = [f64::min, f64::max].map(|f| all.iter().copied().reduce(f).unwrap());
        assert!(low >= least && high <= most, "{name}: {low} {high}");
        // 200 uniform draws miss either 5 % of the range once in 30 000 times.
        let (near, width) = ((low / least).ln(), (most / least).ln());
        assert!(
            near < 0.08 * width && (most / high).ln() < 0.08 * width,
            "{name}: {low} {high}"
        );
    };
    // The magnets held the journal, wherever the mass centre is.
    let mut eccentric = case.clone();
    eccentric.rotor.as_mut().unwrap().eccentricity_m = 2e-5;
    let held = |case: &Case| case.rotor.as_ref().unwrap().journal_start_m();
    for index in 0..20 {
        let drawn = scatter
            .draw(&RotorDrop::of_case(&eccentric).unwrap(), 0, index)
            .0;
        let (drawn, start) = (held(&drawn.cases()[0]), held(&eccentric));
        let off = [0, 1].map(|axis| drawn[axis] - start[axis]);
        assert!(off[0].hypot(off[1]) < 1e-18, "{off:?}");
    }
    let damping = case.support.as_ref().unwrap().damping_n_s_m;
    let bearing = |k: usize| &drawn[k].bearings[0];
    within(
        "damping",
        &|k| bearing(k).support_damping_n_s_m.unwrap() / damping,
        [0.5, 2.0],
    );
    within(
        "gap",
        &|k| bearing(k).radial_clearance_m / rotor.radial_clearance_m,
        [0.9, 1.1],
    );
    let friction = rotor.friction.coefficient;
    within(
        "rotor friction",
        &|k| bearing(k).rotor_friction.coefficient / friction,
        [0.7, 1.3],
    );
    let friction = case.contact.friction.coefficient;
    within(
        "ball friction",
        &|k| bearing(k).ball_friction.coefficient / friction,
        [0.7, 1.3],
    );
}
