//! The drop of a rotor into its touchdown bearings.

use std::sync::Arc;

use super::drop_outcome::RotorDropOutcome;
use super::front::Simulation;
use super::observer::{Observer, RunContext};
use crate::case::Case;
use crate::control::Control;
use crate::dynamics::Model;
use crate::dynamics::coordinates::RotorCoordinate;
use crate::dynamics::state::State;
use crate::dynamics::world::World;
use crate::equilibrium::EquilibriumError;
use crate::initial_conditions::initial_state_controlled;
use crate::linear_rotor::{LinearRotor, RotorError};
use crate::rotor::{Rotor, Shaft};
use crate::step_limits::StepLimits;
use crate::world::body::RotorLoads;
use crate::world::body::linear_rotor::{JournalStart, LinearRotorBody};

/// A rotor above its touchdown bearings, each a case of its own: the rotor in the plane of the only
/// bearing that a case describes, or a linear rotor.
///
/// Under a linear rotor the `rotor` of each case describes the contact of journal and bore (air gap,
/// stiffness, damping, friction) and the position and velocity of the journal when the magnets let
/// go; its mass, inertia, unbalance, speed and drive are replaced by those of the rotor.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorDrop {
    rotor: Option<LinearRotor>,
    cases: Vec<Case>,
}

/// Smallest share of the mean load that a bearing counts as carrying.
const LEAST_SHARE: f64 = 1e-3;

impl RotorDrop {
    /// The drop of the rotor of a case into its bearing; `None` if it has no rotor.
    pub fn of_case(case: &Case) -> Option<Self> {
        case.rotor.as_ref()?;
        Some(Self {
            rotor: None,
            cases: vec![case.clone()],
        })
    }

    /// The drop of `rotor`, turning at `speed_rad_s`, into the bearings of `cases`, in the order
    /// of its journals. Steps are `step_s`, or the automatic step of the method without it.
    ///
    /// # Errors
    /// A [`RotorError`]: too few or too many cases, cases without a section `rotor`, with different
    /// methods, durations or gravity, or a step that rotor and bearings do not bear.
    pub fn new(
        rotor: LinearRotor,
        speed_rad_s: f64,
        drive_torque_n_m: f64,
        cases: Vec<Case>,
        step_s: Option<f64>,
    ) -> Result<Self, RotorError> {
        let refuse = |message: String| Err(RotorError::Bearings(message));
        if cases.len() != rotor.bearings() {
            return refuse(format!(
                "{} cases for {} touch-down bearings: each bearing is one case",
                cases.len(),
                rotor.bearings()
            ));
        }
        for (name, value) in [
            ("speed_rad_s", speed_rad_s),
            ("drive_torque_n_m", drive_torque_n_m),
        ] {
            if !value.is_finite() {
                return Err(RotorError::value(name, value, "a finite number"));
            }
        }
        let mut carried = Vec::with_capacity(cases.len());
        for (k, mut case) in cases.into_iter().enumerate() {
            if let Err(error) = case.check_motion() {
                return refuse(format!("bearing {}: {error}", k + 1));
            }
            let Some(journal) = &mut case.rotor else {
                return refuse(format!(
                    "the case of bearing {} has no section [rotor], which describes the contact \
                     of journal and bore",
                    k + 1
                ));
            };
            journal.mass_kg = shown_mass_kg(&rotor, k, journal.shaft);
            journal.polar_inertia_kg_m2 = rotor.polar_inertia_kg_m2;
            journal.speed_rad_s = speed_rad_s;
            journal.eccentricity_m = 0.0;
            journal.drive_torque_n_m = drive_torque_n_m;
            carried.push(case);
        }
        check_common(&carried)?;
        let step_s = bearable_step_s(&rotor, &carried, step_s)?;
        for case in &mut carried {
            case.solver.step_s = step_s;
        }
        Ok(Self {
            rotor: Some(rotor),
            cases: carried,
        })
    }

    /// Weight of the rotor that each bearing carries, N, all of it at a shoulder of a vertical rotor;
    /// `None` where it carries none of it, or the rotor pulls it upwards.
    pub fn carried_n(&self) -> Vec<Option<f64>> {
        let gravity = self.cases[0].operation.gravity_m_s2;
        let Some(rotor) = &self.rotor else {
            return vec![Some(self.of_rotor(|rotor| rotor.mass_kg) * gravity)];
        };
        if self.is_vertical() {
            return self.shouldered_n(rotor.mass_kg * gravity);
        }
        let least = LEAST_SHARE * rotor.mass_kg / self.cases.len() as f64;
        let shares = rotor.mass_shares_kg().into_iter();
        shares
            .map(|share| (share > least).then_some(share * gravity))
            .collect()
    }

    /// [`Self::carried_n`] of a vertical rotor of this weight: of it that of the shoulder which meets its
    /// face first, and of those that do before the support of that one has yielded.
    fn shouldered_n(&self, weight_n: f64) -> Vec<Option<f64>> {
        let thrust_n: f64 = self.journals().map(|own| own.axial_load_n).sum();
        let down = (weight_n - thrust_n).signum();
        let gap_m = |case: &Case| {
            let own = case.rotor.as_ref()?;
            Some(own.axial_clearance_m? + down * own.z_m)
        };
        let reach_m = |case: &Case| {
            let support = case.support.as_ref();
            let sag_m = support.map_or(0.0, |own| weight_n / own.stiffness_n_m);
            Some(gap_m(case)? + sag_m)
        };
        let first = self.cases.iter().min_by(|a, b| {
            let of = |case| gap_m(case).unwrap_or(f64::INFINITY);
            of(a).total_cmp(&of(b))
        });
        let reach_m = first.and_then(reach_m);
        let meets = |case: &Case| {
            gap_m(case)
                .zip(reach_m)
                .is_some_and(|(gap, reach)| gap <= reach)
        };
        let carried = |case: &Case| meets(case).then_some(weight_n);
        self.cases.iter().map(carried).collect()
    }

    /// The linear rotor; `None` where the rotor is that of the only case.
    pub fn rotor(&self) -> Option<&LinearRotor> {
        self.rotor.as_ref()
    }

    /// Speed of the rotor at the start.
    pub fn speed_rad_s(&self) -> f64 {
        self.of_rotor(|rotor| rotor.speed_rad_s)
    }

    /// Whether the axis of the rotor is vertical.
    pub fn is_vertical(&self) -> bool {
        self.cases[0].upward() == 2
    }

    /// A value of the rotor, which all cases have.
    fn of_rotor(&self, value: fn(&Rotor) -> f64) -> f64 {
        self.cases[0].rotor.as_ref().map_or(0.0, value)
    }

    /// The cases of the bearings as they run: below a linear rotor with the share of the mass of
    /// each, the speed and the drive of the rotor, and the step.
    pub fn cases(&self) -> &[Case] {
        &self.cases
    }

    /// This drop into its bearings with conventional outer rings.
    pub fn conventional(&self) -> Self {
        self.map_cases(Case::conventional)
    }

    /// This drop with each of its cases changed.
    pub(crate) fn map_cases(&self, change: impl FnMut(&Case) -> Case) -> Self {
        Self {
            rotor: self.rotor.clone(),
            cases: self.cases.iter().map(change).collect(),
        }
    }

    /// Turns the unbalance of the rotor of a case to an angle at the start, all unbalances of a
    /// linear rotor by it.
    pub(crate) fn turn_unbalances(&mut self, angle_rad: f64) {
        match &mut self.rotor {
            None => {
                let rotors = self.cases.iter_mut().filter_map(|case| case.rotor.as_mut());
                rotors.for_each(|rotor| rotor.turn_eccentricity(angle_rad));
            }
            Some(rotor) => {
                for unbalance in &mut rotor.unbalances {
                    unbalance.phase_rad += angle_rad;
                }
            }
        }
    }

    /// Rotors of the cases, as their journals are described.
    fn journals(&self) -> impl Iterator<Item = &Rotor> {
        self.cases.iter().filter_map(|case| case.rotor.as_ref())
    }

    /// Loads of a linear rotor beside those of its bearings.
    fn loads(&self, rotor: &LinearRotor) -> RotorLoads {
        let gravity = self.cases[0].operation.gravity_m_s2;
        let [across, along] = match self.is_vertical() {
            false => [gravity, 0.0],
            true => [0.0, gravity],
        };
        let thrust_n: f64 = self.journals().map(|own| own.axial_load_n).sum();
        RotorLoads {
            gravity: across,
            axial: thrust_n - along * rotor.mass_kg,
            drive_torque: self.of_rotor(|rotor| rotor.drive_torque_n_m),
        }
    }

    /// Motion of the journals at the start, of a rotor at this Z.
    fn journal_start(&self, z_m: f64) -> JournalStart {
        let mut start = JournalStart {
            z_m,
            speed_rad_s: self.speed_rad_s(),
            ..JournalStart::default()
        };
        for journal in self.journals() {
            start.places_m.extend([journal.x_m, journal.y_m]);
            start
                .velocities_m_s
                .extend([journal.vx_m_s, journal.vy_m_s]);
        }
        let mut axial_speeds = self.journals().map(|own| own.vz_m_s);
        start.axial_speed_m_s = axial_speeds.find(|speed| *speed != 0.0).unwrap_or(0.0);
        start
    }

    /// The bearings and the rotor at the moment when the magnets let go, to be stepped from a loop of one's own.
    /// [`Simulation::views`] shows each bearing with the rotor at its journal.
    ///
    /// # Errors
    /// A bearing is impossible, or has no equilibrium.
    ///
    /// ```
    /// use cageless::linear_rotor::RigidRotor;
    /// use cageless::prelude::*;
    ///
    /// let case = reference::rotor_drop(); // bearing, air gap and contact of each journal
    /// let rotor = RigidRotor {
    ///     mass_kg: 40.0,
    ///     polar_inertia_kg_m2: 0.04,
    ///     transverse_inertia_kg_m2: 0.6,
    ///     bearing_axial_m: vec![-0.1, 0.2],
    ///     unbalances: vec![],
    ///     clearances: vec![],
    /// };
    /// let drop = RotorDrop::new(rotor.linear()?, 3142.0, 0.0, vec![case.clone(), case], None)?;
    /// let mut simulation = drop.simulation()?;
    /// simulation.advance_to(1e-3)?;
    /// for view in simulation.views() {
    ///     assert!(view.rotor().ok_or("no rotor")?.y_m < 0.0);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn simulation(&self) -> Result<Simulation, EquilibriumError> {
        self.simulation_controlled(&mut || Control::Continue(()))
    }

    /// [`Self::simulation`], with `control` called while the start is sought.
    fn simulation_controlled(
        &self,
        control: &mut dyn FnMut() -> Control,
    ) -> Result<Simulation, EquilibriumError> {
        let Some(rotor) = &self.rotor else {
            return Simulation::controlled(&self.cases[0], control);
        };
        let mut starts: Vec<(State, Vec<f64>)> = vec![];
        let mut models = vec![];
        for case in &self.cases {
            starts.push(initial_state_controlled(case, control)?);
        }
        // Along the axis the place of the rotor is that in the first bearing.
        let z_m = |k: usize| starts[k].0.at(RotorCoordinate::Z);
        for (k, case) in self.cases.iter().enumerate() {
            let seat_z_m = z_m(k) - z_m(0);
            models.push(Arc::new(Model::of_case(case)?.of_common_rotor(seat_z_m)));
        }
        let body = LinearRotorBody::new(rotor, self.loads(rotor));
        let begin = body.at_start(&self.journal_start(z_m(0)));
        let world = World::below(body, &models);
        let mut start = world.vector(starts.iter().map(|(state, _)| state));
        let rotor_start = world.rotor_start();
        start[rotor_start..].copy_from_slice(&begin);
        let states: Vec<State> = (0..models.len())
            .map(|k| State::from_vector(world.layout(k), &start))
            .collect();
        let contexts = (0..models.len()).map(|k| RunContext {
            case: &self.cases[k],
            model: &models[k],
            start: &states[k],
            start_angle_rad: &starts[k].1,
        });
        let contexts: Vec<RunContext<'_>> = contexts.collect();
        Ok(Simulation::of_world(world, &start, &contexts))
    }

    /// Drops the rotor. `observers` watch one bearing each; `control` is called every thousand
    /// steps or so with the simulated time.
    ///
    /// # Errors
    /// A bearing is impossible. Everything later is an [`Ending`](super::Ending) of the bearings;
    /// one that stops ends the drop of all.
    ///
    /// # Panics
    /// If there are not as many `observers` as bearings.
    pub fn run(
        &self,
        observers: &mut [Vec<&mut dyn Observer>],
        control: &mut dyn FnMut(f64) -> Control,
    ) -> Result<RotorDropOutcome, EquilibriumError> {
        assert_eq!(
            observers.len(),
            self.cases.len(),
            "observers for each bearing"
        );
        let mut simulation = self.simulation_controlled(&mut || control(0.0))?;
        let observers = observers.iter_mut().map(Vec::as_mut_slice);
        let until_s = self.cases[0].solver.duration_s;
        let outcomes = simulation.run_watched(until_s, observers, control);
        let whole = outcomes.into_iter().zip(&self.cases);
        let bearings = whole.map(|(outcome, case)| outcome.of_whole_run(case));
        Ok(RotorDropOutcome::new(
            bearings.collect(),
            simulation.planes(),
        ))
    }
}

/// Mass that a linear rotor shows bearing `k`, kg: steps need one where the bearing carries none, and a shoulder may
/// catch all of the rotor.
fn shown_mass_kg(rotor: &LinearRotor, k: usize, shaft: Shaft) -> f64 {
    let shares_kg = rotor.mass_shares_kg();
    let mean_kg = rotor.mass_kg / shares_kg.len() as f64;
    match shaft {
        Shaft::Horizontal => shares_kg[k].abs().max(LEAST_SHARE * mean_kg),
        Shaft::Vertical => rotor.mass_kg,
    }
}

/// Checks what the bearings of a rotor must have in common.
fn check_common(cases: &[Case]) -> Result<(), RotorError> {
    same(cases, "solver.method", |case| Some(case.solver.method))?;
    same(cases, "solver.duration_s", |case| {
        Some(case.solver.duration_s)
    })?;
    same(cases, "solver.tolerance", |case| {
        Some(case.solver.tolerance)
    })?;
    same(cases, "operation.gravity_m_s2", |case| {
        Some(case.operation.gravity_m_s2)
    })?;
    same(cases, "rotor.shaft", |case| {
        case.rotor.as_ref().map(|rotor| rotor.shaft.name())
    })?;
    same(cases, "rotor.vz_m_s", |case| {
        let rotor = case.rotor.as_ref().filter(|_| case.moves_in_space());
        rotor.map(|rotor| rotor.vz_m_s)
    })
}

/// Checks that all cases that have a value agree in it.
fn same<T: PartialEq + std::fmt::Debug>(
    cases: &[Case],
    key: &str,
    value: impl Fn(&Case) -> Option<T>,
) -> Result<(), RotorError> {
    let mut values = (1..)
        .zip(cases)
        .filter_map(|(k, case)| Some((k, value(case)?)));
    let Some((of, first)) = values.next() else {
        return Ok(());
    };
    match values.find(|(_, own)| *own != first) {
        None => Ok(()),
        Some((k, own)) => Err(RotorError::Bearings(format!(
            "{key} is {first:?} in the case of bearing {of} and {own:?} in that of bearing {k}: all \
             bearings of a rotor need the same"
        ))),
    }
}

/// `step_s`, or the automatic step of the method without it.
fn bearable_step_s(
    rotor: &LinearRotor,
    cases: &[Case],
    step_s: Option<f64>,
) -> Result<f64, RotorError> {
    let method = cases[0].solver.method;
    let (fastest, decay) = (rotor.fastest_rad_s(), rotor.fastest_decay_1_s());
    let limits: Vec<StepLimits> = (cases.iter().enumerate())
        .map(|(k, case)| {
            StepLimits::with_linear_rotor(case, rotor.effective_mass_kg(k), fastest, decay)
        })
        .collect();
    let least = |step: fn(&StepLimits, crate::integrator::IntegrationMethod) -> f64| {
        let steps = limits.iter().map(|l| step(l, method));
        steps.fold(f64::INFINITY, f64::min)
    };
    let (automatic, largest) = (least(StepLimits::automatic_s), least(StepLimits::largest_s));
    let step = step_s.unwrap_or(automatic);
    if step > largest {
        return Err(RotorError::Bearings(format!(
            "a step of {} µs is beyond what rotor and bearings bear, {:.3} µs: the fastest \
             vibration of the rotor has {:.0} Hz, that of the contacts {:.0} Hz, and the damping \
             of the rotor decays at up to {:.3e} 1/s. Choose a smaller step, or leave out the \
             fastest modes",
            1e6 * step,
            1e6 * largest,
            fastest / std::f64::consts::TAU,
            limits
                .iter()
                .fold(0.0, |most: f64, l| most.max(l.contact_rad_s))
                / std::f64::consts::TAU,
            decay,
        )));
    }
    Ok(step)
}
