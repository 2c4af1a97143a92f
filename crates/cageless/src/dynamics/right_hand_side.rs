//! The right-hand side of one bearing, or of several side by side, compiled for every
//! instruction set and chosen at run time.

use std::ops::Range;
use std::sync::Arc;

use super::contacts::Contacts;
use super::coordinates::{BallCoordinate, RingCoordinate, RotorCoordinate};
use super::layout::Layout;
use super::model::Model;
use super::space::{self, BallContacts, Drive, SpaceWorkspace};
use super::state::State;
use crate::formulation::Formulation;
use crate::integrator::{SecondOrderBlock, System};
use crate::numerics::lanes::Lanes;
use crate::numerics::lanes::{BATCH_WIDTH, LANES};
use crate::simd::{self, InstructionSet, Parameters, Workspace, with_instructions};
use crate::snapshot::{RingSnapshot, RotorSnapshot, Snapshot};
use crate::time_table::TimeTable;
use crate::world::body::rotor::RotorCompliance;
use crate::world::joint::TouchLoads;

/// The equations of motion with the work arrays to evaluate them.
#[derive(Clone)]
pub struct RightHandSide {
    models: Vec<Arc<Model>>,
    parameters: Parameters,
    work: Workspace,
    /// Work arrays of motion in space.
    space: Option<SpaceWorkspace>,
    isa: InstructionSet,
    evaluations: u64,
    /// Time of the last evaluation, s.
    time_s: f64,
    /// Whether speed or load are given over time.
    over_time: bool,
    second_order_blocks: Vec<SecondOrderBlock>,
}

impl RightHandSide {
    /// The equations of `model` with the instructions of [`InstructionSet::chosen`].
    pub fn new(model: &Arc<Model>) -> Self {
        Self::with_instruction_set(model, InstructionSet::chosen())
    }

    /// The equations of `model` with given instructions; wider ones than the processor has are
    /// replaced by its own widest.
    pub fn with_instruction_set(model: &Arc<Model>, isa: InstructionSet) -> Self {
        Self::placed(model, model.layout, isa)
    }

    /// [`Self::with_instruction_set`] at these places in a vector that holds more.
    pub(super) fn placed(model: &Arc<Model>, layout: Layout, isa: InstructionSet) -> Self {
        Self::build(vec![Arc::clone(model)], layout, isa)
    }

    /// [`BATCH_WIDTH`] bearings side by side, each in its own lanes of every block, with the same number
    /// of balls, formulation and friction law, and all with equal balls or none. Each gets the
    /// bits that it gets alone.
    ///
    /// # Panics
    /// If they differ in one of these.
    pub(crate) fn side_by_side(models: [Arc<Model>; BATCH_WIDTH], isa: InstructionSet) -> Self {
        assert!(
            models.iter().all(|m| m.kind() == models[0].kind()),
            "bearings side by side must be of one kind"
        );
        let layout = models[0].layout.side_by_side();
        Self::build(models.into(), layout, isa)
    }

    fn build(models: Vec<Arc<Model>>, layout: Layout, isa: InstructionSet) -> Self {
        let parameters = Parameters::new(&models, layout);
        Self {
            work: Workspace::new(&parameters, models[0].formulation),
            space: models[0]
                .space
                .as_ref()
                .map(|space| SpaceWorkspace::new(&models[0], space)),
            parameters,
            isa: isa.min(InstructionSet::detect()),
            evaluations: 0,
            time_s: 0.0,
            over_time: models.iter().any(|m| {
                m.inner_speed.is_some() || m.radial_load.is_some() || m.unbalance.is_some()
            }),
            second_order_blocks: layout.second_order_blocks(),
            models,
        }
    }

    /// Sets the speed of the inner ring, rad/s, and the radial load, N, from here on.
    pub(crate) fn set_operation(&mut self, inner_speed_rad_s: f64, radial_load_n: f64) {
        let p = &mut self.parameters;
        for lane in 0..LANES {
            p.inner.surface_speed.0[lane] = inner_speed_rad_s * p.inner.radius.0[lane];
            p.ring.radial_load.0[lane] = radial_load_n;
        }
    }

    /// The model of the first bearing.
    pub(crate) fn model(&self) -> &Arc<Model> {
        &self.models[0]
    }

    /// Layout of the vector that is integrated, with the places of the first bearing.
    pub(crate) fn layout(&self) -> Layout {
        self.parameters.layout
    }

    /// Instructions in use.
    pub(crate) fn instruction_set(&self) -> InstructionSet {
        self.isa
    }

    /// Evaluations so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Contacts of the first bearing as of the last evaluation.
    pub(crate) fn contacts(&self) -> Contacts<'_> {
        self.contacts_of(0)
    }

    /// Contacts of one of the bearings as of the last evaluation.
    #[inline]
    pub(crate) fn contacts_of(&self, bearing: usize) -> Contacts<'_> {
        Contacts {
            parameters: &self.parameters,
            work: &self.work,
            space: self.space.as_ref(),
            isa: self.isa,
            bearing,
        }
    }

    /// Tables of speed and load over time.
    fn tables(&self) -> impl Iterator<Item = &TimeTable> {
        let tables = self
            .models
            .iter()
            .flat_map(|m| [&m.inner_speed, &m.radial_load]);
        tables.flatten()
    }

    pub(super) fn evaluate(
        &mut self,
        time_s: f64,
        y: &[f64],
        dydt: &mut [f64],
        raceway_friction: bool,
    ) {
        self.evaluations += 1;
        self.time_s = time_s;
        if self.over_time {
            self.parameters.set_time(&self.models, time_s);
        }
        self.parameters.set_ring_speed(y);
        let (p, w) = (&self.parameters, &mut self.work);
        if let (Some(space), Some(s)) = (&self.models[0].space, &mut self.space) {
            let b = space::Bearing {
                parameters: p,
                model: &self.models[0],
                space,
                drive: drive(p),
            };
            return with_instructions!(
                self.isa,
                [](b: space::Bearing<'_>, w: &mut Workspace, s: &mut SpaceWorkspace, y: &[f64], dydt: &mut [f64], raceway_friction: bool),
                space::evaluate(b, w, s, y, dydt, raceway_friction)
            );
        }
        if self.models[0].formulation == Formulation::Paper {
            return with_instructions!(
                self.isa,
                [](p: &Parameters, w: &mut Workspace, y: &[f64], dydt: &mut [f64], raceway_friction: bool),
                simd::published::evaluate(p, w, y, dydt, raceway_friction)
            );
        }
        with_instructions!(
            self.isa,
            [](p: &Parameters, w: &mut Workspace, y: &[f64], dydt: &mut [f64], raceway_friction: bool),
            simd::evaluate(p, w, y, dydt, raceway_friction)
        );
    }

    /// Sets what the rotor at one of the bearings yields to the friction of the next step.
    pub(super) fn set_rotor_compliance(&mut self, bearing: usize, compliance: RotorCompliance) {
        self.work.rotor_compliances[bearing] = compliance;
    }

    /// Loads of the inner ring of one of the bearings on the rotor as of the last evaluation.
    #[inline]
    pub(super) fn loads_on_rotor(&self, bearing: usize) -> TouchLoads {
        self.work.rotor_loads[bearing]
    }

    /// Loads of the friction on the rotor that changed velocities over the last step.
    pub(super) fn friction_on_rotor(&self, bearing: usize) -> TouchLoads {
        let contact = &self.work.rotors[bearing];
        match &self.space {
            Some(s) => s.rotor.friction(contact),
            None => {
                let joint = &self.parameters.drops[bearing].joint;
                joint.loads(contact, 0.0, self.work.rotor_friction_mean[bearing])
            }
        }
    }

    /// Axial motion of a rotor in space and the force at its shoulder, in the state of the last evaluation.
    fn along_axis(&self, state: &State) -> RotorSnapshot {
        let (layout, y) = (state.layout(), state.values());
        let Some(face) = self.contacts().face() else {
            return RotorSnapshot::default();
        };
        let housing = layout.outer_ring_along_axis(y);
        let seat_z_m = self.parameters.drops[0].joint.seat.z;
        RotorSnapshot {
            z_m: seat_z_m + layout.at(y, RotorCoordinate::Z),
            vz_m_s: layout.at(y, RotorCoordinate::Vz),
            housing_z_m: housing.z,
            housing_vz_m_s: housing.vz,
            shoulder_force_n: face.axial_force,
            ..RotorSnapshot::default()
        }
    }

    /// The rotor in a state that was evaluated last.
    fn rotor_snapshot(&self, state: &State) -> Option<RotorSnapshot> {
        let contact = self.contacts().rotor()?.contact;
        let (rotor, housing) = (state.rotor_motion()?, state.outer_ring_motion());
        Some(RotorSnapshot {
            x_m: rotor.x,
            y_m: rotor.y,
            vx_m_s: rotor.vx,
            vy_m_s: rotor.vy,
            angle_rad: rotor.angle,
            speed_rad_s: rotor.speed,
            ring_speed_rad_s: state.ring_speed_rad_s()?,
            housing_x_m: housing.x,
            housing_y_m: housing.y,
            housing_vx_m_s: housing.vx,
            housing_vy_m_s: housing.vy,
            contact_force_n: contact.force,
            contact_sliding_m_s: contact.slip,
            ..self.along_axis(state)
        })
    }

    /// Snapshot of a state of the first bearing, alone in its vector.
    /// `angle_rad` are the continuous ψ of its balls, which the state alone does not know
    /// beyond a turn.
    pub fn snapshot(&mut self, time_s: f64, state: &State, angle_rad: &[f64]) -> Snapshot {
        let mut rate = vec![0.0; state.layout().len()];
        self.evaluate(time_s, state.values(), &mut rate, true);
        self.evaluated_snapshot(time_s, state, angle_rad, &rate)
    }

    /// Snapshot of a state within a step whose end has these contacts. Friction that no sliding
    /// speed gives, that of contacts that stick, is that of the step; under any other law it is
    /// that of the sliding speeds.
    pub(crate) fn snapshot_within(
        &mut self,
        time_s: f64,
        state: &State,
        angle_rad: &[f64],
        end: &Contacts<'_>,
    ) -> Snapshot {
        let model = self.model();
        let balls = model.balls();
        if !(model.friction.sticks() && model.implicit_friction) {
            return self.snapshot(time_s, state, angle_rad);
        }
        let mut rate = vec![0.0; state.layout().len()];
        self.evaluate(time_s, state.values(), &mut rate, false);
        let of_step: Vec<[f64; 4]> = (0..balls)
            .map(|k| {
                [
                    end.outer_friction_n(k),
                    end.inner_friction_n(k),
                    end.outer_sliding_m_s(k),
                    end.inner_sliding_m_s(k),
                ]
            })
            .collect();
        let journal = end.rotor().map_or(0.0, |rotor| rotor.friction);
        let (p, w) = (&self.parameters, &mut self.work);
        simd::add_given_friction(p, w, &of_step, journal, &mut rate);
        self.evaluated_snapshot(time_s, state, angle_rad, &rate)
    }

    /// Snapshot of the state that was evaluated last.
    fn evaluated_snapshot(
        &self,
        time_s: f64,
        state: &State,
        angle_rad: &[f64],
        rate: &[f64],
    ) -> Snapshot {
        let (n, layout) = (self.model().balls(), state.layout());
        let c = self.contacts();
        let each = |value: &dyn Fn(usize) -> f64| (0..n).map(value).collect();
        let spatial = layout.ball_moves(BallCoordinate::Z);
        let in_space = |value: &dyn Fn(usize) -> f64| match spatial {
            true => (0..n).map(value).collect(),
            false => vec![],
        };
        let at = |coordinate, k| state.values()[layout.ball(coordinate, k)];
        let angle = |k, of: fn(&BallContacts) -> f64| {
            c.in_space(k).map_or(f64::NAN, |contacts| of(&contacts))
        };
        Snapshot {
            time_s,
            angle_rad: angle_rad.to_vec(),
            x_m: state.x_m().to_vec(),
            y_m: state.y_m().to_vec(),
            vx_m_s: state.vx_m_s().to_vec(),
            vy_m_s: state.vy_m_s().to_vec(),
            rotation_rad_s: each(&|k| c.rotation_rad_s(k)),
            orbit_speed_rad_s: each(&|k| c.orbit_speed_rad_s(k)),
            gap_rad: each(&|k| {
                let ahead = layout.next(k);
                let turn = if ahead <= k {
                    std::f64::consts::TAU
                } else {
                    0.0
                };
                angle_rad[ahead] + turn - angle_rad[k] - self.model().pair_angle_rad(k)
            }),
            effective_radius_m: each(&|k| c.effective_radius_m(k)),
            inner_force_n: each(&|k| c.inner_force_n(k)),
            outer_force_n: each(&|k| c.outer_force_n(k)),
            inner_sliding_m_s: each(&|k| c.inner_sliding_m_s(k)),
            outer_sliding_m_s: each(&|k| c.outer_sliding_m_s(k)),
            z_m: in_space(&|k| at(BallCoordinate::Z, k)),
            vz_m_s: in_space(&|k| at(BallCoordinate::Vz, k)),
            omega_x_rad_s: in_space(&|k| at(BallCoordinate::OmegaX, k)),
            omega_y_rad_s: in_space(&|k| at(BallCoordinate::OmegaY, k)),
            inner_contact_angle_rad: in_space(&|k| angle(k, BallContacts::inner_contact_angle_rad)),
            outer_contact_angle_rad: in_space(&|k| angle(k, BallContacts::outer_contact_angle_rad)),
            outer_ring_z_m: in_space(&|k| {
                let space = self.model().space.as_ref();
                space.map_or(0.0, |s| space::outer_z_m(s, layout, state.values(), k))
            }),
            rotor: self.rotor_snapshot(state),
            ring: self.ring_snapshot(state, rate),
        }
    }

    /// The inner ring in a state that was evaluated last.
    fn ring_snapshot(&self, state: &State, rate: &[f64]) -> RingSnapshot {
        let (layout, ring) = (state.layout(), state.ring_motion());
        let [outer_force_x_n, outer_force_y_n] = self.contacts().outer_ring_force_n();
        RingSnapshot {
            z_m: state.at(RingCoordinate::Z),
            vz_m_s: state.at(RingCoordinate::Vz),
            tilt_x_rad: -state.at(RingCoordinate::TiltQ),
            tilt_y_rad: state.at(RingCoordinate::TiltP),
            x_m: ring.x,
            y_m: ring.y,
            vx_m_s: ring.vx,
            vy_m_s: ring.vy,
            ax_m_s2: rate[layout.ring(RingCoordinate::Vx)],
            ay_m_s2: rate[layout.ring(RingCoordinate::Vy)],
            outer_force_x_n,
            outer_force_y_n,
        }
    }
}

/// Speed and load of the first bearing as of the last evaluation.
fn drive(p: &Parameters) -> Drive {
    Drive {
        inner_speed: p.inner.surface_speed.0[0] / p.inner.radius.0[0],
        radial_load: p.ring.radial_load.0[0],
        unbalance: [p.ring.unbalance_x.0[0], p.ring.unbalance_y.0[0]],
    }
}

/// Lanes whose phases make one word of the fingerprint, eight bits each.
const MODE_LANES: usize = 8;

/// Fingerprint `hash` with more `bits`.
pub(super) fn mix(hash: u64, bits: u64) -> u64 {
    (hash ^ bits)
        .wrapping_mul(0x0000_0100_0000_01b3)
        .rotate_left(5)
}

impl System for RightHandSide {
    fn dimension(&self) -> usize {
        self.parameters.layout.len()
    }

    fn derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(time_s, y, dydt, true);
    }

    /// Friction at the raceways, where it is stiff for the step of the case.
    fn has_stiff_part(&self) -> bool {
        self.model().implicit_friction
    }

    fn nonstiff_derivative(&mut self, time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(time_s, y, dydt, false);
    }

    // Into callers compiled for wider vectors; where there are none, once is enough.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    fn add_stiff_part(&mut self, h_s: f64, y0: &[f64], y: &mut [f64], dydt: &mut [f64]) {
        let (p, w) = (&self.parameters, &mut self.work);
        if let (Some(space), Some(s)) = (&self.models[0].space, &mut self.space) {
            let b = space::Bearing {
                parameters: p,
                model: &self.models[0],
                space,
                drive: drive(p),
            };
            return with_instructions!(
                self.isa,
                [](b: space::Bearing<'_>, w: &mut Workspace, s: &mut SpaceWorkspace, h_s: f64, y0: &[f64], y: &mut [f64], dydt: &mut [f64]),
                space::add_implicit_friction(b, w, s, h_s, y0, y, dydt)
            );
        }
        if self.models[0].formulation == Formulation::Paper {
            return with_instructions!(
                self.isa,
                [](p: &Parameters, w: &mut Workspace, h_s: f64, y0: &[f64], y: &mut [f64], dydt: &mut [f64]),
                simd::published::add_implicit_friction(p, w, h_s, y0, y, dydt)
            );
        }
        with_instructions!(
            self.isa,
            [](p: &Parameters, w: &mut Workspace, h_s: f64, y0: &[f64], y: &mut [f64], dydt: &mut [f64]),
            simd::add_implicit_friction(p, w, h_s, y0, y, dydt)
        );
    }

    /// Damped contacts and that of a rotor, whose force starts with infinite slope and ends with a kink where
    /// it is clamped at zero, in the `paper` formulation the raceway's ends, where the
    /// direction of friction jumps, and the corners of what is given over time.
    #[inline(always)] // into callers compiled for wider vectors
    fn mode(&self) -> u64 {
        let m = self.model();
        let (raceways, balls) = (m.balls[0].raceway_damping > 0.0, m.ball_damped);
        let mut hash = 0u64;
        if self.over_time {
            for table in self.tables() {
                hash = mix(hash, table.piece(self.time_s) as u64);
            }
        }
        let mut phase = |deflection: f64, force: f64| {
            hash = mix(hash, u64::from(deflection > 0.0) + u64::from(force > 0.0));
        };
        for contact in self.work.rotors.iter().take(self.parameters.drops.len()) {
            phase(contact.contact.deflection, contact.contact.force);
        }
        if let Some(space) = self
            .space
            .as_ref()
            .filter(|_| !self.parameters.drops.is_empty())
        {
            let face = &space.rotor.face;
            phase(face.deflection, face.axial_force.abs());
        }
        for direction in &self.work.friction_directions {
            for on_path in direction.on_path.0 {
                hash = mix(hash, u64::from(on_path > 0.0));
            }
        }
        let mut lanes_left = m.balls() * self.parameters.layout.width();
        for block in &self.work.blocks {
            let (inner, outer, pair) = (&block.inner, &block.outer, &block.pair);
            for first in (0..LANES).step_by(MODE_LANES) {
                let mut word = 0;
                for k in 0..MODE_LANES {
                    let lane = first + k;
                    let phase = |damped: bool, deflection: &Lanes, force: &Lanes| {
                        u64::from(damped & (deflection.0[lane] > 0.0))
                            + u64::from(damped & (force.0[lane] > 0.0))
                    };
                    let bits = phase(raceways, &inner.deflection, &inner.force)
                        | phase(raceways, &outer.deflection, &outer.force) << 2
                        | phase(balls, &pair.deflection, &pair.force) << 4;
                    // Lanes beyond the last ball hold no contacts.
                    word |= (bits * u64::from(k < lanes_left)) << (8 * k);
                }
                lanes_left = lanes_left.saturating_sub(MODE_LANES);
                hash = mix(hash, word);
            }
        }
        hash
    }

    /// Edges of the contacts, and corners of the tables over time.
    fn edges(&self, y: &[f64], values: &mut Vec<f64>) {
        let under = self.parameters.drops.first();
        match (&self.models[0].space, &self.space) {
            (Some(space), Some(s)) => {
                let face = under.map(|_| &s.rotor.face);
                space::edges(space, &self.work, face, values);
                simd::rotor_edges(&self.parameters, &self.work, y, values);
            }
            _ => simd::edges(&self.parameters, &self.work, y, values),
        }
        values.extend(self.tables().map(|table| table.corner(self.time_s)));
    }

    fn planar_velocities(&self) -> Option<[Range<usize>; 2]> {
        let layout = self.layout();
        (!layout.ball_moves(BallCoordinate::Vz)).then(|| {
            [BallCoordinate::Vx, BallCoordinate::Vy].map(|coordinate| {
                let first = layout.array(coordinate);
                first..first + layout.stride
            })
        })
    }

    fn second_order_blocks(&self) -> &[SecondOrderBlock] {
        &self.second_order_blocks
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        let layout = self.parameters.layout;
        (0..layout.width())
            .map(|bearing| layout.of_bearing(bearing).scaled_rms(difference))
            .fold(0.0, f64::max)
    }
}
