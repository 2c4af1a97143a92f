//! Heat of the interfaces of a drop.

use super::thermal::PARTS;
use crate::dynamics::energy::EnergyTerm;
use crate::rotor::Rotor;
use crate::simulation::StepView;

/// Heat of each interface since the magnets let go, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct InterfaceHeat {
    /// Friction between rotor and inner ring.
    pub rotor_friction_j: f64,
    /// Damping of the contact between rotor and inner ring.
    pub rotor_damping_j: f64,
    /// Friction at the inner raceway.
    pub inner_friction_j: f64,
    /// Friction at the outer raceway.
    pub outer_friction_j: f64,
    /// Friction between balls.
    pub ball_friction_j: f64,
    /// Damping of the contacts of the balls.
    pub contact_damping_j: f64,
    /// Damping of the support.
    pub support_damping_j: f64,
}

impl InterfaceHeat {
    /// Heat by the terms of the energy ledger.
    pub(crate) fn of(term_j: impl Fn(EnergyTerm) -> f64) -> Self {
        Self {
            rotor_friction_j: term_j(EnergyTerm::RotorFriction),
            rotor_damping_j: term_j(EnergyTerm::RotorDamping),
            inner_friction_j: term_j(EnergyTerm::InnerFriction),
            outer_friction_j: term_j(EnergyTerm::OuterFriction),
            ball_friction_j: term_j(EnergyTerm::BallFriction),
            contact_damping_j: term_j(EnergyTerm::Damping),
            support_damping_j: term_j(EnergyTerm::SupportDamping),
        }
    }

    /// Heat that goes into inner ring, balls and outer ring, J: half of the friction between two bodies
    /// into each, of the damping of the balls' contacts half into the balls and a quarter into each
    /// ring. The other half of what rotor and inner ring make goes into the rotor, and the heat of the
    /// support stays there.
    pub fn of_parts_j(&self) -> [f64; PARTS] {
        let journal = 0.5 * (self.rotor_friction_j + self.rotor_damping_j);
        let [inner, outer] = [self.inner_friction_j, self.outer_friction_j].map(|heat| 0.5 * heat);
        let damping = 0.25 * self.contact_damping_j;
        [
            journal + inner + damping,
            inner + outer + self.ball_friction_j + 2.0 * damping,
            outer + damping,
        ]
    }

    /// Heat of all interfaces, J.
    pub fn total_j(&self) -> f64 {
        self.rotor_friction_j
            + self.rotor_damping_j
            + self.balls_j()
            + self.contact_damping_j
            + self.support_damping_j
    }

    /// Heat of friction at the balls, J.
    pub fn balls_j(&self) -> f64 {
        self.inner_friction_j + self.outer_friction_j + self.ball_friction_j
    }
}

/// Heating by one bearing at the end of a drop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndPower {
    /// Power of all interfaces, W.
    pub total_w: f64,
    /// Power into inner ring, balls and outer ring, W.
    pub parts_w: [f64; PARTS],
    /// Torque by which the interfaces brake the rotor: their power over its mean speed, N m. `None` of
    /// a slow rotor: it is its fall that makes heat.
    pub torque_n_m: Option<f64>,
    /// Change of that torque from the first to the second half of the time, relative to the first; `None` where
    /// there is no torque or the time is too short.
    pub torque_change: Option<f64>,
}

/// Rotational energy below which a rotor is slow, in its largest other kinetic energy: what bouncing still
/// loses must be little next to it.
const SLOW: f64 = 100.0;

/// Heat and speed of the rotor now and then.
#[derive(Debug, Clone)]
pub(super) struct HeatHistory {
    interval_s: f64,
    /// Largest kinetic energy of the rotor without that of its rotation, J.
    fall_j: f64,
    /// The last one is that of the end of the last step.
    marks: Vec<Mark>,
}

#[derive(Debug, Clone, Copy)]
struct Mark {
    time_s: f64,
    heat: InterfaceHeat,
    /// |Ω|, rad/s.
    speed: f64,
}

impl Mark {
    /// Torque of the losses until a later mark; `None` in no time.
    fn torque_n_m(&self, later: &Self) -> Option<f64> {
        let time_s = later.time_s - self.time_s;
        let heat_j = later.heat.total_j() - self.heat.total_j();
        (time_s > 0.0).then(|| heat_j / time_s / (0.5 * (self.speed + later.speed)))
    }
}

impl HeatHistory {
    pub(super) fn new(interval_s: f64) -> Self {
        Self {
            interval_s,
            fall_j: 0.0,
            marks: vec![],
        }
    }

    pub(super) fn step(&mut self, view: &StepView<'_>, rotor: &Rotor) {
        let (layout, y) = (view.layout(), &view.step.y1);
        let Some(motion) = layout.rotor_motion(y) else {
            return;
        };
        let squared = motion.vx * motion.vx + motion.vy * motion.vy + motion.vz * motion.vz;
        self.fall_j = self.fall_j.max(0.5 * rotor.mass_kg * squared);
        let mark = Mark {
            time_s: view.step.t1_s,
            heat: InterfaceHeat::of(|term| y[layout.energy_term(term)]),
            speed: motion.speed.abs(),
        };
        // The last mark moves on until it is far enough from the one before.
        if let [.., before, last] = &mut self.marks[..]
            && last.time_s - before.time_s < self.interval_s
        {
            *last = mark;
        } else {
            self.marks.push(mark);
        }
    }

    /// Heating from the last mark before `from_s` to the end; `None` in no time.
    pub(super) fn since(&self, from_s: f64, polar_inertia_kg_m2: f64) -> Option<EndPower> {
        let last = self.marks.last()?;
        let after = self.marks.partition_point(|mark| mark.time_s <= from_s);
        let first = &self.marks[after.saturating_sub(1)];
        let time_s = last.time_s - first.time_s;
        let power =
            |of: &dyn Fn(&InterfaceHeat) -> f64| (of(&last.heat) - of(&first.heat)) / time_s;
        let total_w = power(&InterfaceHeat::total_j);
        let speed = 0.5 * (first.speed + last.speed);
        let turning_j = 0.5 * polar_inertia_kg_m2 * speed * speed;
        let turns = turning_j > SLOW * self.fall_j;
        let middle_s = 0.5 * (first.time_s + last.time_s);
        let middle = self.marks[..].partition_point(|mark| mark.time_s <= middle_s);
        let middle = &self.marks[middle.saturating_sub(1)];
        let halves = [first.torque_n_m(middle), middle.torque_n_m(last)];
        let change = halves[0].zip(halves[1]).map(|(a, b)| b / a - 1.0);
        (time_s > 0.0).then(|| EndPower {
            total_w,
            parts_w: std::array::from_fn(|k| power(&|heat| heat.of_parts_j()[k])),
            torque_n_m: turns.then(|| total_w / speed),
            torque_change: change.filter(|change| turns && change.is_finite()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 W in the first half of a tenth of a second at 100 rad/s, then as much again and half more.
    #[test]
    fn the_torque_changes_from_half_to_half() {
        let mark = |k: u32, rotor_friction_j: f64| Mark {
            time_s: 0.01 * f64::from(k),
            heat: InterfaceHeat {
                rotor_friction_j,
                ..InterfaceHeat::default()
            },
            speed: 100.0,
        };
        for (more_w, expected) in [(10.0, 0.0), (15.0, 0.5), (5.0, -0.5)] {
            let first = (0..=5).map(|k| mark(k, 0.1 * f64::from(k)));
            let second = (6..=10).map(|k| mark(k, 0.5 + 0.01 * more_w * f64::from(k - 5)));
            let history = HeatHistory {
                marks: first.chain(second).collect(),
                ..HeatHistory::new(0.01)
            };
            let change = history.since(0.0, 1.0).unwrap().torque_change.unwrap();
            assert!((change - expected).abs() < 1e-9, "{change} {expected}");
        }
    }
}
