//! Observer of a drop.

use super::end_state::EndState;
use super::heat::{EndPower, HeatHistory, InterfaceHeat};
use super::whirl::{
    JournalForce, Whirl, WhirlTracker, WhirlWindow, backward_whirl_max_hz, mean_frequency_hz,
};
use crate::case::Case;
use crate::contact_peaks::ContactPeakTracker;
use crate::contact_tracker::{APPROACH_SPEEDS_M_S, ContactCounter, ContactCounts};
use crate::dynamics::coordinates::RotorCoordinate;
use crate::dynamics::state::State;
use crate::numerics::vector::PlaneVector;
use crate::rotor::{Rotor, Shaft};
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};
use crate::world::joint::support::SupportJoint;

/// Results of a drop, from t = 0 to the end of the run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DropSummary {
    /// State of the rotor at the end.
    pub end_state: EndState,
    /// Mean whirl frequency over the last fifth of the time after the first contact, or since
    /// [`Self::end_whirl`] began in it, Hz, counter-clockwise positive; 0 before that.
    pub end_whirl_hz: f64,
    /// Whirl in lasting contact up to the end.
    pub end_whirl: Option<Whirl>,
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
    /// that at the first contact, s; `None` if it does not. That of the first contact with a rotor
    /// that does not turn.
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
    /// `APPROACH_SPEEDS_M_S`, Hz.
    pub end_collision_rate_above_hz: [Option<f64>; APPROACH_SPEEDS_M_S.len()],
    /// Largest force between balls, N.
    pub ball_force_max_n: f64,
    /// Largest |ΔVi| or |ΔVo| at contacts of the balls that carry load, m/s.
    pub ball_sliding_max_m_s: f64,
    /// Largest mean frequency of the journal against the direction of rotation over a window, Hz,
    /// of a whirl or of a swing at the bottom.
    pub backward_whirl_max_hz: f64,
    /// Backward whirl at any time: the journal runs round the bore against the rotation in lasting contact, once at
    /// least, or all through the last fifth of the time after the first contact; `None` if it never does.
    pub backward_whirl: Option<Whirl>,
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
pub const LAST: f64 = 0.2;
/// Shortest time after the first contact on which a drop is judged, s: of two windows the state at the end is made.
pub const JUDGED_AFTER_S: f64 = 2.0 * WINDOW_S / LAST;
/// Sliding at which the ring has come up to speed, as a fraction of that at the first contact.
const SPUN_UP: f64 = 0.01;

/// Gathers a [`DropSummary`].
#[derive(Debug, Clone)]
pub struct DropRecorder {
    carried_n: Option<Option<f64>>,
    dropped: Option<Dropped>,
    whirl: WhirlTracker,
    heat: HeatHistory,
    found: Found,
}

/// Case, rotor and trackers of a drop.
#[derive(Debug, Clone)]
struct Dropped {
    case: Case,
    rotor: Rotor,
    peaks: ContactPeakTracker,
    collisions: ContactCounter,
    /// The outer ring, if it is on a support.
    support: Option<SupportJoint>,
    /// Z of the rotor in the middle between its shoulders, m.
    axial_origin_m: f64,
}

/// Maxima and counts so far.
#[derive(Debug, Clone, Default)]
struct Found {
    in_contact: bool,
    first_sliding_m_s: f64,
    contact_s: f64,
    end_s: f64,
    shoulder_force_n: f64,
    axial_displacement_m: f64,
    /// N².
    housing_force_squared: f64,
    /// m².
    housing_displacement_squared: f64,
    /// m².
    rotor_displacement_squared: f64,
    /// Results known before the end.
    summary: DropSummary,
}

impl DropRecorder {
    /// Recorder of one drop.
    pub fn new() -> Self {
        Self {
            carried_n: None,
            dropped: None,
            whirl: WhirlTracker::new(WINDOW_S),
            heat: HeatHistory::new(WINDOW_S),
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
        let dropped = self.dropped.expect("a run");
        let rotor = &dropped.rotor;
        let rotation = rotor.speed_rad_s;
        let peaks = dropped.peaks.peaks(&dropped.case);
        let found = self.found;
        let first_contact_s = found.summary.first_contact_s;
        let contact_time = first_contact_s.map_or(0.0, |s| found.end_s - s);
        let whirl = self.whirl.windows;
        let last_from_s = first_contact_s.map(|s| found.end_s - LAST * (found.end_s - s));
        let last = last_from_s.map(|s| &whirl[whirl.partition_point(|w| w.end_s <= s)..]);
        // Thrust along +Z carries a part of a vertical rotor.
        let lifted_n = match rotor.shaft {
            Shaft::Horizontal => 0.0,
            Shaft::Vertical => rotor.axial_load_n,
        };
        let weight_n = found.summary.rotor_weight_n;
        let carried_n = weight_n.map(|weight_n| (weight_n - lifted_n).abs());
        let motion = JournalMotion::new(&whirl, last.unwrap_or_default(), rotor, carried_n);
        let rate_hz = |count: &dyn Fn(&ContactCounts) -> u64| {
            last.map(|last| {
                let collisions: u64 = last.iter().map(|w| count(&w.collisions)).sum();
                collisions as f64 / last.iter().map(|w| w.end_s - w.start_s).sum::<f64>()
            })
        };
        let in_space = state.layout().moves(RotorCoordinate::Z);
        DropSummary {
            end_state: motion.end_state,
            end_whirl_hz: motion.end_whirl_hz,
            end_whirl: motion.end_whirl,
            contact_fraction: if contact_time > 0.0 {
                (found.contact_s / contact_time).min(1.0)
            } else {
                0.0
            },
            rotor_displacement_max_m: found.rotor_displacement_squared.sqrt(),
            shoulder_force_max_n: rotor.axial_clearance_m.map(|_| found.shoulder_force_n),
            rotor_axial_displacement_max_m: in_space.then_some(found.axial_displacement_m),
            housing_force_max_n: (dropped.support).map(|_| found.housing_force_squared.sqrt()),
            housing_displacement_max_m: found.housing_displacement_squared.sqrt(),
            ring_speed_rad_s: state.ring_speed_rad_s().expect("a rotor"),
            rotor_speed_rad_s: state.rotor_motion().expect("a rotor").speed,
            inner_pressure_max_pa: peaks.inner.pressure_pa,
            outer_pressure_max_pa: peaks.outer.pressure_pa,
            ellipse_edge_max_rad: in_space.then(|| dropped.peaks.ellipse_edge_max_rad()),
            ball_pressure_max_pa: peaks.balls.pressure_pa,
            end_collision_rate_hz: rate_hz(&|collisions| collisions.all),
            end_collision_rate_above_hz: std::array::from_fn(|k| {
                rate_hz(&|collisions| collisions.above[k])
            }),
            ball_force_max_n: peaks.balls.force_n,
            backward_whirl_max_hz: backward_whirl_max_hz(&whirl, rotation),
            backward_whirl: motion.backward_whirl,
            heat: InterfaceHeat::of(|term| state.energy_term_j(term)),
            end_power: last_from_s
                .and_then(|from_s| self.heat.since(from_s, rotor.polar_inertia_kg_m2)),
            whirl,
            ..found.summary
        }
    }
}

/// Motion of the journal in the bore, in the words of a summary.
struct JournalMotion {
    end_state: EndState,
    end_whirl_hz: f64,
    end_whirl: Option<Whirl>,
    backward_whirl: Option<Whirl>,
}

impl JournalMotion {
    /// Motion over `windows`, of which `last` are those of the end, empty before the first contact.
    fn new(
        windows: &[WhirlWindow],
        last: &[WhirlWindow],
        rotor: &Rotor,
        carried_n: Option<f64>,
    ) -> Self {
        let rotation = rotor.speed_rad_s;
        let end_whirl = Whirl::at_the_end(windows);
        let end_state = match &end_whirl {
            _ if last.is_empty() => EndState::Falling,
            Some(whirl) => EndState::of_whirl(whirl.frequency_hz, rotation),
            None => EndState::classify(last, rotation, carried_n, rotor.shaft),
        };
        let from_s = end_whirl.map_or(0.0, |whirl| whirl.from_s);
        let whirling = &last[last.partition_point(|w| w.start_s < from_s)..];
        let at_the_end = || {
            let whirls = end_state == EndState::BackwardWhirl;
            Whirl::over(last).filter(|_| whirls)
        };
        Self {
            end_state,
            end_whirl_hz: match whirling.is_empty() {
                true => 0.0,
                false => mean_frequency_hz(whirling),
            },
            end_whirl,
            backward_whirl: Whirl::backward(windows, rotation).or_else(at_the_end),
        }
    }
}

impl Dropped {
    fn rotor_contact(&self, view: &StepView<'_>, found: &mut Found, whirl: &mut WhirlTracker) {
        let Some(rotor) = view.contacts.rotor() else {
            return;
        };
        let (time_s, h) = (view.step.t1_s, view.step.t1_s - view.step.t0_s);
        let contact = rotor.contact;
        if let Some(motion) = view.layout().rotor_motion(&view.step.y1) {
            // The place of the journal, from that of the mass centre.
            let (x, y) = (motion.x, motion.y);
            let squared = PlaneVector { x, y }.from(rotor.offset).square();
            found.rotor_displacement_squared = found.rotor_displacement_squared.max(squared);
        }
        let face = view.contacts.face().unwrap_or_default();
        let z = view.layout().at(&view.step.y1, RotorCoordinate::Z);
        let displaced = (z - self.axial_origin_m).abs();
        found.axial_displacement_m = found.axial_displacement_m.max(displaced);
        let force_n = contact.force.hypot(face.axial_force);
        let closed = force_n > 0.0;
        // That of what touches; of the journal, which the bore surrounds, also before it does.
        let slip = match contact.force > 0.0 || face.axial_force == 0.0 {
            true => contact.slip.abs(),
            false => face.slip.abs(),
        };
        let most = &mut found.summary;
        if closed {
            if !found.in_contact {
                most.impacts += 1;
            }
            if most.first_contact_s.is_none() {
                most.first_contact_s = Some(time_s);
                found.first_sliding_m_s = slip;
            }
            let rolls = slip < SPUN_UP * found.first_sliding_m_s || !self.rotor.turns();
            if most.spin_up_s.is_none() && rolls {
                most.spin_up_s = Some(time_s);
            }
            found.contact_s += h;
            most.rotor_force_max_n = most.rotor_force_max_n.max(force_n);
            found.shoulder_force_n = found.shoulder_force_n.max(face.axial_force.abs());
            most.rotor_sliding_max_m_s = most.rotor_sliding_max_m_s.max(slip);
        }
        found.in_contact = closed;
        let lift_n = view.contacts.loads_on_rotor().unwrap_or_default().force;
        // The journal of a vertical rotor runs round the bore only where it touches it, and it is the
        // shoulder that bounces.
        let (lift_n, runs_round, bounces_n) = match self.rotor.shaft {
            Shaft::Horizontal => (lift_n[1], true, contact.force),
            Shaft::Vertical => (lift_n[2], contact.force > 0.0, force_n),
        };
        if most.first_contact_s.is_some() {
            let direction = runs_round.then_some([contact.nx, contact.ny]);
            let pressed = JournalForce {
                contact_n: bounces_n,
                lift_n,
            };
            whirl.update(direction, time_s, h, &pressed);
        }
    }

    fn support_force(&self, view: &StepView<'_>, found: &mut Found) {
        let Some(support) = &self.support else {
            return;
        };
        let motion = view.layout().outer_ring_motion(&view.step.y1);
        let [fx, fy] = support.force(&motion);
        let along_axis = view.layout().outer_ring_along_axis(&view.step.y1);
        let fz = support.force_along_axis(&along_axis);
        let square = |x: f64, y: f64, z: f64| x * x + y * y + z * z;
        found.housing_force_squared = found.housing_force_squared.max(square(fx, fy, fz));
        let displaced = square(motion.x, motion.y, along_axis.z);
        found.housing_displacement_squared = found.housing_displacement_squared.max(displaced);
    }

    fn ball_contacts(
        &mut self,
        view: &StepView<'_>,
        found: &mut DropSummary,
        whirl: &mut WhirlTracker,
    ) {
        let contacts = &view.contacts;
        let begun = self.collisions.step(view).unwrap_or_default();
        found.collisions += begun;
        whirl.collide(begun);
        found.ball_sliding_max_m_s = found.ball_sliding_max_m_s.max(contacts.sliding_max_m_s());
        let most = (found.inner_force_max_n.iter_mut()).zip(&mut found.outer_force_max_n);
        for (k, (inner, outer)) in most.enumerate() {
            *inner = inner.max(contacts.inner_force_n(k));
            *outer = outer.max(contacts.outer_force_n(k));
        }
        let speed_ratio = view.inner_speed_ratio(&self.case);
        self.peaks.look(contacts, speed_ratio);
        if contacts.balls_touch() {
            self.peaks.look_between_balls(contacts, speed_ratio);
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
        let [x, y] = match context.start.rotor_motion() {
            Some(motion) => rotor.journal_m([motion.x, motion.y], motion.angle),
            None => rotor.journal_start_m(),
        };
        let (layout, start) = (context.start.layout(), context.start.values());
        self.found = Found {
            rotor_displacement_squared: x * x + y * y,
            axial_displacement_m: rotor.z_m.abs(),
            summary: DropSummary {
                rotor_weight_n: self.carried_n.unwrap_or(Some(weight_n)),
                inner_force_max_n: vec![0.0; balls],
                outer_force_max_n: vec![0.0; balls],
                ..DropSummary::default()
            },
            ..Found::default()
        };
        self.dropped = Some(Dropped {
            case: case.clone(),
            rotor: rotor.clone(),
            peaks: ContactPeakTracker::new(case),
            collisions: ContactCounter::new(context.model),
            support: case.support.as_ref().map(SupportJoint::new),
            axial_origin_m: match layout.moves(RotorCoordinate::Z) {
                true => layout.at(start, RotorCoordinate::Z) - rotor.z_m,
                false => 0.0,
            },
        });
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let found = &mut self.found;
        found.end_s = view.step.t1_s;
        if let Some(dropped) = &mut self.dropped {
            dropped.ball_contacts(view, &mut found.summary, &mut self.whirl);
            dropped.rotor_contact(view, found, &mut self.whirl);
            dropped.support_force(view, found);
            self.heat.step(view, &dropped.rotor);
        }
        Ok(Control::Continue(()))
    }
}
