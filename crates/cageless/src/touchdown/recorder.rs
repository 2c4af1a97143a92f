//! Observer of a drop.

use super::end_state::EndState;
use super::heat::{EndPower, HeatHistory, InterfaceHeat};
use super::whirl::{WhirlTracker, WhirlWindow, backward_whirl_hz};
use crate::case::Case;
use crate::contact_peaks::ContactPeakTracker;
use crate::contact_tracker::{APPROACH_SPEEDS_M_S, ContactCounter, ContactCounts};
use crate::dynamics::coordinates::DropCoordinate;
use crate::dynamics::outer_ring::OuterRing;
use crate::dynamics::rotor::RotorMotion;
use crate::dynamics::state::State;
use crate::rotor::Shaft;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// Results of a drop, from t = 0 to the end of the run.
#[derive(Debug, Clone, PartialEq)]
pub struct DropSummary {
    /// What the rotor does at the end.
    pub end_state: EndState,
    /// First contact of the rotor with the inner ring, s.
    pub first_contact_s: Option<f64>,
    /// Contacts of the rotor, its journal or a shoulder, with the inner ring that began.
    pub impacts: u64,
    /// Fraction of the time after the first contact in contact.
    pub contact_fraction: f64,
    /// Weight of the rotor that the bearing carries, N; `None` where it carries none.
    pub rotor_weight_n: Option<f64>,
    /// Largest distance of the centre of the journal from the centre of the stator, which is that
    /// of the housing at rest, m.
    pub rotor_displacement_max_m: f64,
    /// Largest normal force between rotor and inner ring, N: of journal and shoulder together.
    pub rotor_force_max_n: f64,
    /// Largest force between a shoulder of the rotor and the inner ring, N; `None` without shoulders.
    pub shoulder_force_max_n: Option<f64>,
    /// Largest displacement of the rotor along the axis, m; `None` in the plane.
    pub rotor_axial_displacement_max_m: Option<f64>,
    /// Largest force that the support passes on to the housing, N; `None` without a support.
    pub housing_force_max_n: Option<f64>,
    /// Largest displacement of the outer ring, m.
    pub housing_displacement_max_m: f64,
    /// Largest sliding speed between rotor and inner ring in contact, m/s.
    pub rotor_sliding_max_m_s: f64,
    /// Time from the start of the drop at which the sliding in contact first falls below 1 % of
    /// that at the first contact, s; `None` if it does not.
    pub spin_up_s: Option<f64>,
    /// Speed of the inner ring at the end, rad/s.
    pub ring_speed_rad_s: f64,
    /// Speed of the rotor at the end, rad/s.
    pub rotor_speed_rad_s: f64,
    /// Largest normal force of each ball at the inner raceway, N.
    pub inner_force_max_n: Vec<f64>,
    /// Largest normal force of each ball at the outer raceway, N.
    pub outer_force_max_n: Vec<f64>,
    /// Largest pressure at the inner raceway, Pa.
    pub inner_pressure_max_pa: f64,
    /// Largest pressure at the outer raceway, Pa.
    pub outer_pressure_max_pa: f64,
    /// In space: largest |α| + a/R to which a contact ellipse reaches, rad: inner, outer groove.
    pub ellipse_edge_max_rad: Option<[f64; 2]>,
    /// Largest pressure between balls, Pa.
    pub ball_pressure_max_pa: f64,
    /// Contacts between balls that began.
    pub collisions: ContactCounts,
    /// Contacts between balls that began, per second of the last fifth of the time after the
    /// first contact, Hz; `None` before that.
    pub end_collision_rate_hz: Option<f64>,
    /// Contacts per second, as [`Self::end_collision_rate_hz`], that began above each of
    /// [`APPROACH_SPEEDS_M_S`], Hz.
    pub end_collision_rate_above_hz: [Option<f64>; APPROACH_SPEEDS_M_S.len()],
    /// Largest force between balls, N.
    pub ball_force_max_n: f64,
    /// Largest |ΔVi| or |ΔVo| at contacts of the balls that carry load, m/s.
    pub ball_sliding_max_m_s: f64,
    /// Largest mean frequency of the journal against the direction of rotation over a window, Hz,
    /// of a whirl or of a swing at the bottom.
    pub backward_whirl_max_hz: f64,
    /// Largest frequency of backward whirl, Hz: of a journal that runs round the bore in contact;
    /// `None` if it never does.
    pub backward_whirl_hz: Option<f64>,
    /// Heat of each interface.
    pub heat: InterfaceHeat,
    /// Heating by the bearing at the end, over the last fifth of the time after the first contact;
    /// `None` before that.
    pub end_power: Option<EndPower>,
    /// Motion of the journal round the bore, window by window.
    pub whirl: Vec<WhirlWindow>,
}

/// Length of the windows of the whirl, s: short against a spin-up, long against an impact.
const WINDOW_S: f64 = 5e-3;
/// Part of the time after the first contact over which the state at the end is judged.
const LAST: f64 = 0.2;
/// Sliding at which the ring has come up to speed, as a fraction of that at the first contact.
const SPUN_UP: f64 = 0.01;

/// Gathers a [`DropSummary`].
#[derive(Debug, Clone)]
pub struct DropRecorder {
    case: Option<Case>,
    peaks: Option<ContactPeakTracker>,
    /// The outer ring, if it is on a support.
    outer_ring: Option<OuterRing>,
    /// Whether the rotor has shoulders that the bearing catches.
    shoulders: bool,
    shaft: Shaft,
    /// Z of the rotor in the middle between its shoulders, m.
    axial_origin_m: f64,
    lifted_n: f64,
    carried_n: Option<Option<f64>>,
    weight_n: Option<f64>,
    rotation: f64,
    whirl: WhirlTracker,
    heat: HeatHistory,
    collisions: Option<ContactCounter>,
    in_contact: bool,
    first_sliding_m_s: f64,
    contact_s: f64,
    end_s: f64,
    found: Found,
}

/// Maxima and counts so far.
#[derive(Debug, Clone, Default)]
struct Found {
    first_contact_s: Option<f64>,
    impacts: u64,
    rotor_force_n: f64,
    shoulder_force_n: f64,
    axial_displacement_m: f64,
    /// N².
    housing_force_squared: f64,
    /// m².
    housing_displacement_squared: f64,
    /// m².
    rotor_displacement_squared: f64,
    rotor_sliding_m_s: f64,
    spin_up_s: Option<f64>,
    inner_force_n: Vec<f64>,
    outer_force_n: Vec<f64>,
    collisions: ContactCounts,
    ball_sliding_m_s: f64,
}

impl Found {
    /// Takes a place of the mass centre, `offset` from that of the journal.
    fn displace(&mut self, motion: &RotorMotion, offset: [f64; 2]) {
        let (x, y) = (motion.x - offset[0], motion.y - offset[1]);
        let squared = x * x + y * y;
        self.rotor_displacement_squared = self.rotor_displacement_squared.max(squared);
    }
}

impl DropRecorder {
    /// Recorder of one drop.
    pub fn new() -> Self {
        Self {
            case: None,
            peaks: None,
            outer_ring: None,
            shoulders: false,
            shaft: Shaft::Horizontal,
            axial_origin_m: 0.0,
            lifted_n: 0.0,
            carried_n: None,
            weight_n: None,
            rotation: 0.0,
            whirl: WhirlTracker::new(WINDOW_S),
            heat: HeatHistory::new(WINDOW_S),
            collisions: None,
            in_contact: false,
            first_sliding_m_s: 0.0,
            contact_s: 0.0,
            end_s: 0.0,
            found: Found::default(),
        }
    }

    /// Recorder of one bearing of several, which carries a part of the weight of the rotor, or
    /// none.
    pub fn of_bearing(carried_n: Option<f64>) -> Self {
        Self {
            carried_n: Some(carried_n),
            ..Self::new()
        }
    }

    /// Results of the drop that ended in `state`.
    ///
    /// # Panics
    /// If nothing was recorded, or the case has no rotor.
    pub fn summary(mut self, state: &State) -> DropSummary {
        self.whirl.close();
        let (case, peaks) = self.case.as_ref().zip(self.peaks.as_ref()).expect("a run");
        let edges_rad = peaks.ellipse_edge_max_rad();
        let peaks = peaks.peaks(case);
        let rotor = state.rotor_motion().expect("a rotor");
        let ring_speed = state.ring_speed_rad_s().expect("a rotor");
        let found = self.found;
        let contact_time = found.first_contact_s.map_or(0.0, |s| self.end_s - s);
        let whirl = self.whirl.windows;
        let last_from_s = (found.first_contact_s).map(|s| self.end_s - LAST * (self.end_s - s));
        let last = last_from_s.map(|s| &whirl[whirl.partition_point(|w| w.end_s <= s)..]);
        let end_power = last_from_s.and_then(|from_s| self.heat.since(from_s));
        let end_state = last.map_or(EndState::Falling, |last| {
            let carried_n = self
                .weight_n
                .map(|weight_n| (weight_n - self.lifted_n).abs());
            EndState::classify(last, self.rotation, carried_n, self.shaft)
        });
        let rate_hz = |count: &dyn Fn(&ContactCounts) -> u64| {
            last.map(|last| {
                let collisions: u64 = last.iter().map(|w| count(&w.collisions)).sum();
                collisions as f64 / last.iter().map(|w| w.end_s - w.start_s).sum::<f64>()
            })
        };
        let end_collision_rate_hz = rate_hz(&|collisions| collisions.all);
        let end_collision_rate_above_hz =
            std::array::from_fn(|k| rate_hz(&|collisions| collisions.above[k]));
        let backward = whirl
            .iter()
            .filter(|w| w.contact_fraction > 0.5)
            .map(|w| -w.frequency_hz() * self.rotation.signum());
        DropSummary {
            end_state,
            first_contact_s: found.first_contact_s,
            impacts: found.impacts,
            contact_fraction: if contact_time > 0.0 {
                (self.contact_s / contact_time).min(1.0)
            } else {
                0.0
            },
            rotor_weight_n: self.weight_n,
            rotor_displacement_max_m: found.rotor_displacement_squared.sqrt(),
            rotor_force_max_n: found.rotor_force_n,
            shoulder_force_max_n: self.shoulders.then_some(found.shoulder_force_n),
            rotor_axial_displacement_max_m: (state.layout().is_in_space())
                .then_some(found.axial_displacement_m),
            housing_force_max_n: self.outer_ring.map(|_| found.housing_force_squared.sqrt()),
            housing_displacement_max_m: found.housing_displacement_squared.sqrt(),
            rotor_sliding_max_m_s: found.rotor_sliding_m_s,
            spin_up_s: found.spin_up_s,
            ring_speed_rad_s: ring_speed,
            rotor_speed_rad_s: rotor.speed,
            inner_pressure_max_pa: peaks.inner.pressure_pa,
            outer_pressure_max_pa: peaks.outer.pressure_pa,
            ellipse_edge_max_rad: (state.layout().is_in_space()).then_some(edges_rad),
            ball_pressure_max_pa: peaks.balls.pressure_pa,
            inner_force_max_n: found.inner_force_n,
            outer_force_max_n: found.outer_force_n,
            collisions: found.collisions,
            end_collision_rate_hz,
            end_collision_rate_above_hz,
            ball_force_max_n: peaks.balls.force_n,
            ball_sliding_max_m_s: found.ball_sliding_m_s,
            backward_whirl_max_hz: backward.fold(0.0, f64::max),
            backward_whirl_hz: backward_whirl_hz(&whirl, self.rotation),
            heat: InterfaceHeat::of(|term| state.energy_term_j(term)),
            end_power,
            whirl,
        }
    }

    fn rotor_contact(&mut self, view: &StepView<'_, '_>) {
        let Some(rotor) = view.contacts.rotor() else {
            return;
        };
        let (time_s, h) = (view.step.t1_s, view.step.t1_s - view.step.t0_s);
        let contact = rotor.contact;
        let found = &mut self.found;
        if let Some(motion) = view.layout().rotor_motion(&view.step.y1) {
            found.displace(&motion, rotor.offset);
        }
        let face = view.contacts.face().unwrap_or_default();
        if view.layout().is_in_space() {
            let z = view.step.y1[view.layout().drop(DropCoordinate::RotorZ)];
            let displaced = (z - self.axial_origin_m).abs();
            found.axial_displacement_m = found.axial_displacement_m.max(displaced);
        }
        let force_n = contact.force.hypot(face.axial_force);
        let closed = force_n > 0.0;
        // That of what touches; of the journal, which the bore surrounds, also before it does.
        let slip = match contact.force > 0.0 || face.axial_force == 0.0 {
            true => contact.slip.abs(),
            false => face.slip.abs(),
        };
        if closed {
            if !self.in_contact {
                found.impacts += 1;
            }
            if found.first_contact_s.is_none() {
                found.first_contact_s = Some(time_s);
                self.first_sliding_m_s = slip;
            }
            if found.spin_up_s.is_none() && slip < SPUN_UP * self.first_sliding_m_s {
                found.spin_up_s = Some(time_s);
            }
            self.contact_s += h;
            found.rotor_force_n = found.rotor_force_n.max(force_n);
            found.shoulder_force_n = found.shoulder_force_n.max(face.axial_force.abs());
            found.rotor_sliding_m_s = found.rotor_sliding_m_s.max(slip);
        }
        self.in_contact = closed;
        let [lift_x, lift_y] = contact.force_on_journal(rotor.friction);
        let lift_n = (view.contacts.rotor_force_n()).unwrap_or([lift_x, lift_y, 0.0]);
        // The journal of a vertical rotor runs round the bore only where it touches it, and it is the
        // shoulder that bounces.
        let (lift_n, runs_round, bounces_n) = match self.shaft {
            Shaft::Horizontal => (lift_n[1], true, contact.force),
            Shaft::Vertical => (lift_n[2], contact.force > 0.0, force_n),
        };
        if found.first_contact_s.is_some() {
            let direction = runs_round.then_some([contact.nx, contact.ny]);
            self.whirl.update(direction, time_s, h, [bounces_n, lift_n]);
        }
    }

    fn support_force(&mut self, view: &StepView<'_, '_>) {
        let Some(outer_ring) = &self.outer_ring else {
            return;
        };
        let motion = view.layout().outer_ring_motion(&view.step.y1);
        let [fx, fy] = outer_ring.support_force(&motion);
        let [z, vz] = view.layout().outer_ring_along_axis(&view.step.y1);
        let fz = outer_ring.support_force_along_axis(z, vz);
        let found = &mut self.found;
        let square = |x: f64, y: f64, z: f64| x * x + y * y + z * z;
        found.housing_force_squared = found.housing_force_squared.max(square(fx, fy, fz));
        let displaced = square(motion.x, motion.y, z);
        found.housing_displacement_squared = found.housing_displacement_squared.max(displaced);
    }

    fn ball_contacts(&mut self, view: &StepView<'_, '_>) {
        let contacts = &view.contacts;
        let begun =
            (self.collisions.as_mut()).map_or_else(ContactCounts::default, |c| c.step(view));
        let found = &mut self.found;
        found.collisions += begun;
        self.whirl.collide(begun);
        found.ball_sliding_m_s = found.ball_sliding_m_s.max(contacts.sliding_max_m_s());
        let most = found.inner_force_n.iter_mut().zip(&mut found.outer_force_n);
        for (k, (inner, outer)) in most.enumerate() {
            *inner = inner.max(contacts.inner_force_n(k));
            *outer = outer.max(contacts.outer_force_n(k));
        }
        if let Some(peaks) = &mut self.peaks {
            peaks.look(contacts);
            if contacts.balls_touch() {
                peaks.look_between_balls(contacts);
            }
        }
    }
}

impl Default for DropRecorder {
    fn default() -> Self {
        Self::new()
    }
}

impl Observer for DropRecorder {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let case = context.case;
        let rotor = case.rotor.as_ref().ok_or("the case has no rotor")?;
        let balls = context.model.balls();
        let weight_n = rotor.mass_kg * case.operation.gravity_m_s2;
        self.weight_n = self.carried_n.unwrap_or(Some(weight_n));
        let [x, y] = match context.start.rotor_motion() {
            Some(motion) => rotor.journal_m([motion.x, motion.y], motion.angle),
            None => rotor.journal_start_m(),
        };
        self.found.rotor_displacement_squared = x * x + y * y;
        self.rotation = rotor.speed_rad_s;
        (self.shoulders, self.shaft) = (rotor.axial_clearance_m.is_some(), rotor.shaft);
        self.found.axial_displacement_m = rotor.z_m.abs();
        let (layout, start) = (context.start.layout(), context.start.values());
        if layout.is_in_space() {
            self.axial_origin_m = start[layout.drop(DropCoordinate::RotorZ)] - rotor.z_m;
        }
        // Thrust along +Z carries a part of a vertical rotor.
        self.lifted_n = match rotor.shaft {
            Shaft::Horizontal => 0.0,
            Shaft::Vertical => rotor.axial_load_n,
        };
        self.outer_ring = (case.support.as_ref()).map(|support| OuterRing::new(Some(support)));
        self.peaks = Some(ContactPeakTracker::new(case, context.model));
        self.case = Some(case.clone());
        self.collisions = Some(ContactCounter::new(context.model));
        self.found.inner_force_n = vec![0.0; balls];
        self.found.outer_force_n = vec![0.0; balls];
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        self.end_s = view.step.t1_s;
        self.ball_contacts(view);
        self.rotor_contact(view);
        self.support_force(view);
        self.heat.step(view);
        Ok(Control::Continue(()))
    }
}
