//! A world: bearings, and the rotor above them.
//!
//! The vector holds the bearings one after the other, then the rotor in a part of its own. Each bearing reads the motion
//! of the rotor where it stands and says what its inner ring does to it.

use std::ops::Range;
use std::sync::Arc;

use super::contacts::Contacts;
use super::energy::{EnergyBalance, EnergyTerm};
use super::layout::Layout;
use super::model::Model;
use super::plane_path::PlaneDisplacement;
use super::right_hand_side::{RightHandSide, mix};
use super::state::State;
use crate::integrator::{Integrator, Method, SecondOrderBlock, System, UnresolvedStep};
use crate::numerics::lanes::BATCH_WIDTH;
use crate::simd::{InstructionSet, with_instructions};
use crate::world::body::rigid_rotors::RigidRotors;
use crate::world::body::rotor_body::{RotorBody, RotorEnergyTerm};
use crate::world::joint::TouchLoads;

/// The equations of motion of bearings that are advanced together, and of their rotor.
pub(crate) struct World {
    bearings: Vec<RightHandSide>,
    rotor: Option<RotorPart>,
    second_order_blocks: Vec<SecondOrderBlock>,
}

/// The rotor in its part of the vector.
struct RotorPart {
    body: Box<dyn RotorBody>,
    /// First place.
    start: usize,
    /// Loads of each bearing as of the last evaluation.
    loads: Vec<TouchLoads>,
    /// Energy of the rotor in each bearing at the start, J.
    start_energy_j: Vec<f64>,
}

impl World {
    /// The bearing of `model`, with its rotor if it has one.
    pub(crate) fn of_bearing(model: &Arc<Model>) -> Self {
        let rotor = model.rotor.clone().map(|rotor| RigidRotors(vec![rotor]));
        Self::new(vec![RightHandSide::new(model)], rotor)
    }

    /// [`BATCH_WIDTH`] bearings side by side, see [`RightHandSide::side_by_side`], each with its rotor if it has one.
    pub(crate) fn side_by_side(models: [Arc<Model>; BATCH_WIDTH], isa: InstructionSet) -> Self {
        let rotors: Vec<_> = models.iter().filter_map(|m| m.rotor.clone()).collect();
        let rotor = (!rotors.is_empty()).then_some(RigidRotors(rotors));
        Self::new(vec![RightHandSide::side_by_side(models, isa)], rotor)
    }

    /// The bearings of `models` below one rotor.
    pub(crate) fn below(rotor: impl RotorBody + 'static, models: &[Arc<Model>]) -> Self {
        let mut start = 0;
        let mut layouts = vec![];
        for model in models {
            let layout = model.layout.starting_at(start);
            start = layout.end();
            layouts.push(layout);
        }
        let isa = InstructionSet::chosen();
        let bearings = (0..).zip(models).zip(layouts).map(|((k, model), layout)| {
            let layout = layout.below(rotor.places(k).map(|place| start + place));
            RightHandSide::placed(model, layout, isa)
        });
        Self::new(bearings.collect(), Some(rotor))
    }

    fn new(bearings: Vec<RightHandSide>, rotor: Option<impl RotorBody + 'static>) -> Self {
        let last = bearings.last().expect("a bearing");
        let start = last.layout().end();
        let mut second_order_blocks: Vec<_> = (bearings.iter())
            .flat_map(|bearing| bearing.layout().second_order_blocks())
            .collect();
        let count = count(&bearings);
        let rotor = rotor.map(|body| {
            let own = body.second_order_block();
            second_order_blocks.push(SecondOrderBlock {
                positions: start + own.positions,
                rates: start + own.rates,
                count: own.count,
            });
            RotorPart {
                body: Box::new(body),
                start,
                loads: vec![TouchLoads::default(); count],
                start_energy_j: vec![0.0; count],
            }
        });
        Self {
            bearings,
            rotor,
            second_order_blocks,
        }
    }

    /// Number of bearings.
    pub(crate) fn count(&self) -> usize {
        count(&self.bearings)
    }

    /// Equations that hold bearing `k`, and its number in them.
    #[inline]
    fn place_of(&self, k: usize) -> (usize, usize) {
        match self.bearings.len() {
            1 => (0, k),
            _ => (k, 0),
        }
    }

    /// Places of bearing `k`.
    pub(crate) fn layout(&self, k: usize) -> Layout {
        let (holder, own) = self.place_of(k);
        self.bearings[holder].layout().of_bearing(own)
    }

    /// Contacts of bearing `k` as of the last evaluation.
    #[inline]
    pub(crate) fn contacts_of(&self, k: usize) -> Contacts<'_> {
        let (holder, own) = self.place_of(k);
        self.bearings[holder].contacts_of(own)
    }

    /// Whether no bearing acts on another, so that each may end at a time of its own.
    pub(crate) fn independent(&self) -> bool {
        self.bearings.len() == 1
    }

    /// Evaluations so far.
    pub(crate) fn evaluations(&self) -> u64 {
        self.bearings[0].evaluations()
    }

    /// Instructions in use.
    pub(crate) fn instruction_set(&self) -> InstructionSet {
        self.bearings[0].instruction_set()
    }

    /// Equations of the only bearing, or of those side by side.
    pub(crate) fn bearing_mut(&mut self) -> &mut RightHandSide {
        &mut self.bearings[0]
    }

    /// Sets the torque of the drive of the rotor, N·m, from here on.
    pub(crate) fn set_drive_torque(&mut self, torque_n_m: f64) {
        if let Some(rotor) = &mut self.rotor {
            rotor.body.set_drive_torque(torque_n_m);
        }
    }

    /// Vector of the bearings in these states, of those that are missing in the last one; a rotor is where the states
    /// have it.
    pub(crate) fn vector<'a>(&self, states: impl IntoIterator<Item = &'a State>) -> Vec<f64> {
        let mut values = vec![0.0; self.dimension()];
        for bearing in &self.bearings {
            bearing.layout().spread_padding(&mut values);
        }
        let (mut states, mut last) = (states.into_iter(), None);
        for k in 0..self.count() {
            last = states.next().or(last);
            if let Some(state) = last {
                state.write_to(self.layout(k), &mut values);
            }
        }
        values
    }

    /// First place of the rotor.
    pub(crate) fn rotor_start(&self) -> usize {
        self.rotor
            .as_ref()
            .map_or(self.dimension(), |rotor| rotor.start)
    }

    /// Takes a state as the start, from which the balance of the rotor counts.
    pub(crate) fn begin(&mut self, y: &[f64]) {
        if let Some(RotorPart {
            body,
            start,
            start_energy_j,
            ..
        }) = &mut self.rotor
        {
            for (k, energy) in start_energy_j.iter_mut().enumerate() {
                *energy = body.energy_j(&y[*start..], k);
            }
        }
        self.look(y);
    }

    /// Takes the state at the end of a step.
    #[inline]
    pub(crate) fn look(&mut self, y: &[f64]) {
        if let Some(rotor) = &mut self.rotor {
            rotor.body.look(&y[rotor.start..]);
        }
    }

    /// Planes of the rotor with their largest displacements so far.
    pub(crate) fn planes(&self) -> Vec<PlaneDisplacement> {
        self.rotor
            .as_ref()
            .map_or(vec![], |rotor| rotor.body.planes())
    }

    /// Balance of the rotor in bearing `k`, which all bearings below it have in common, in a state.
    pub(crate) fn rotor_balance(&self, y: &[f64], k: usize) -> Option<EnergyBalance> {
        let rotor = self.rotor.as_ref()?;
        let own = &y[rotor.start..];
        let flows = RotorEnergyTerm::ALL.map(|term| {
            let value = own[rotor.body.energy_term(term, k)];
            if term == RotorEnergyTerm::Loss {
                -value
            } else {
                value
            }
        });
        let now_j = rotor.body.energy_j(own, k);
        Some(EnergyBalance::new(rotor.start_energy_j[k], now_j, flows))
    }

    /// Lets `integrator` make a step with the instructions of the bearings.
    ///
    /// # Errors
    /// Those of the method.
    pub(crate) fn advance<M: Method>(
        &mut self,
        integrator: &mut Integrator<M>,
        limit_s: f64,
    ) -> Result<(), UnresolvedStep> {
        let system = self;
        with_instructions!(
            system.instruction_set(),
            [M: Method](integrator: &mut Integrator<M>, system: &mut World, limit_s: f64)
                -> Result<(), UnresolvedStep>,
            integrator.advance(system, limit_s)
        )
    }

    fn evaluate(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64], stiff_too: bool) {
        for bearing in &mut self.bearings {
            bearing.evaluate(time_s, y, dydt, stiff_too);
        }
        if let Some(rotor) = &mut self.rotor {
            rotor.set_rates(&self.bearings, y, dydt);
        }
    }
}

/// Number of bearings that these equations hold: one each, or one set of them side by side.
fn count(equations: &[RightHandSide]) -> usize {
    equations.iter().map(|own| own.layout().width()).sum()
}

impl RotorPart {
    /// Sets the rates of the rotor under the loads of the bearings as of their last evaluation.
    fn set_rates(&mut self, bearings: &[RightHandSide], y: &[f64], dydt: &mut [f64]) {
        let mut loads = self.loads.iter_mut();
        for bearing in bearings {
            for own in 0..bearing.layout().width() {
                if let Some(load) = loads.next() {
                    *load = bearing.loads_on_rotor(own);
                }
            }
        }
        let start = self.start;
        (self.body).set_rates(&y[start..], &self.loads, &mut dydt[start..]);
    }

    /// Adds the friction of all bearings over a step, of one after the other: each sees the rotor move by its own
    /// friction within the step, and by that of the bearings before it.
    fn add_friction(
        &mut self,
        bearings: &mut [RightHandSide],
        h_s: f64,
        y0: &[f64],
        y: &mut [f64],
        dydt: &mut [f64],
    ) {
        let (start, mut first) = (self.start, 0);
        for bearing in bearings {
            let width = bearing.layout().width();
            for own in 0..width {
                let compliance = self.body.compliance(&y[start..], first + own);
                bearing.set_rotor_compliance(own, compliance);
            }
            bearing.add_stiff_part(h_s, y0, y, dydt);
            for own in 0..width {
                let loads = bearing.friction_on_rotor(own);
                let (rotor, rates) = (&mut y[start..], &mut dydt[start..]);
                self.body.add_loads(first + own, &loads, h_s, rotor, rates);
                self.loads[first + own] = loads;
            }
            first += width;
        }
    }

    /// Adds the work of the friction on the rotor over a step to both ledgers, by the mean of the velocities at both
    /// ends.
    fn add_work(
        &self,
        layouts: impl Iterator<Item = Layout>,
        h_s: f64,
        y0: &[f64],
        y: &mut [f64],
        dydt: &mut [f64],
    ) {
        for (k, (layout, loads)) in layouts.zip(&self.loads).enumerate() {
            let power = |y: &[f64]| layout.rotor_motion(y).unwrap_or_default().power(loads);
            let mean = 0.5 * (power(y0) + power(y));
            let rotor = self.start + self.body.energy_term(RotorEnergyTerm::Journals, k);
            let bearing = layout.energy_term(EnergyTerm::Drive);
            for (place, power) in [(rotor, mean), (bearing, -mean)] {
                dydt[place] += power;
                y[place] += h_s * power;
            }
        }
    }
}

impl System for World {
    fn dimension(&self) -> usize {
        match &self.rotor {
            Some(rotor) => rotor.start + rotor.body.dimension(),
            None => self.bearings[0].dimension(),
        }
    }

    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(time_s, y, dydt, true);
    }

    #[inline(always)] // into callers compiled for wider vectors
    fn mode(&self) -> u64 {
        // A fold would be a function of its own, compiled for the baseline.
        let mut modes = 0;
        for bearing in &self.bearings {
            modes = mix(modes, bearing.mode());
        }
        modes
    }

    fn edges(&self, y: &[f64], values: &mut Vec<f64>) {
        for bearing in &self.bearings {
            bearing.edges(y, values);
        }
    }

    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &self.second_order_blocks
    }

    /// Planar velocities of the only bearing.
    fn planar_velocities(&self) -> Option<[Range<usize>; 2]> {
        match &self.bearings[..] {
            [bearing] => bearing.planar_velocities(),
            _ => None,
        }
    }

    /// All bearings have a stiff part or none has.
    fn has_stiff_part(&self) -> bool {
        self.bearings[0].has_stiff_part()
    }

    fn nonstiff_derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(time_s, y, dydt, false);
    }

    #[inline(always)] // into callers compiled for wider vectors
    fn add_stiff_part(&mut self, h_s: f64, y0: &[f64], y: &mut [f64], dydt: &mut [f64]) {
        let Some(rotor) = &mut self.rotor else {
            return self.bearings[0].add_stiff_part(h_s, y0, y, dydt);
        };
        rotor.add_friction(&mut self.bearings, h_s, y0, y, dydt);
        let layouts = self.bearings.iter().flat_map(|bearing| {
            let layout = bearing.layout();
            (0..layout.width()).map(move |own| layout.of_bearing(own))
        });
        rotor.add_work(layouts, h_s, y0, y, dydt);
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        let of_rotor = self.rotor.as_ref().map_or(0.0, |rotor| {
            rotor.body.error_norm(&difference[rotor.start..])
        });
        let bearings = self.bearings.iter().map(|b| b.error_norm(difference));
        bearings.fold(of_rotor, f64::max)
    }
}
