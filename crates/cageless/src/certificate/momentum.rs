//! Balance of linear momentum.

use crate::case::Profile;
use crate::simulation::{Control, Observer, ObserverError, Scene, View};

/// Compares the linear momentum of balls and inner ring with the impulses of the external
/// forces: the outer ring, the radial load, the weights, the drag on the inner ring and, in
/// the `paper` profile, the centrifugal force of Zhao 2022, Eq. (15). The forces that balls
/// and inner ring exert on each other must cancel.
///
/// Impulses are sums by the trapezoidal rule over the steps.
#[derive(Debug, Clone, Default)]
pub(super) struct MomentumBalance {
    ball_masses: Vec<f64>,
    ring_mass: f64,
    ring_drag: f64,
    radial_load: f64,
    gravity: f64,
    /// Rm where Fw acts.
    centrifugal_radius: Option<f64>,
    start: [f64; 2],
    now: [f64; 2],
    impulse: [f64; 2],
    absolute_impulse: f64,
    last: Option<([f64; 2], f64)>,
}

impl MomentumBalance {
    /// |momentum now − momentum at the start − impulses| over the sum of absolute impulses.
    pub fn residual_relative(&self) -> f64 {
        let missing = [0, 1].map(|k| self.now[k] - self.start[k] - self.impulse[k]);
        if self.absolute_impulse > 0.0 {
            missing[0].hypot(missing[1]) / self.absolute_impulse
        } else {
            0.0
        }
    }

    fn momentum(&self, layout: crate::state::Layout, values: &[f64]) -> [f64; 2] {
        [0, 1].map(|k| {
            let speeds = layout.balls_of(values, 2 + k);
            let balls: f64 = self
                .ball_masses
                .iter()
                .zip(speeds.iter())
                .map(|(m, v)| m * v)
                .sum();
            balls + self.ring_mass * values[layout.ring(2 + k)]
        })
    }

    /// Sum of the external forces at a state where the outer ring is pressed by `outer`, and
    /// the sum of their absolute values.
    fn external(
        &self,
        layout: crate::state::Layout,
        values: &[f64],
        outer: [f64; 2],
    ) -> ([f64; 2], f64) {
        let (vx, vy) = (values[layout.ring(2)], values[layout.ring(3)]);
        let weight = (self.ring_mass + self.ball_masses.iter().sum::<f64>()) * self.gravity;
        let mut force = [
            -outer[0] - self.ring_drag * vx,
            -outer[1] - self.ring_drag * vy - self.radial_load - weight,
        ];
        let mut absolute =
            outer[0].hypot(outer[1]) + self.ring_drag * vx.hypot(vy) + self.radial_load + weight;
        if let Some(radius) = self.centrifugal_radius {
            let group = |g: usize| layout.balls_of(values, g);
            let (x, y, vx, vy) = (group(0), group(1), group(2), group(3));
            for k in 0..layout.balls {
                let rho = x[k].hypot(y[k]);
                let vt = (x[k] * vy[k] - y[k] * vx[k]) / rho;
                let centrifugal = self.ball_masses[k] * vt * vt / radius;
                force[0] += centrifugal * x[k] / rho;
                force[1] += centrifugal * y[k] / rho;
                absolute += centrifugal;
            }
        }
        (force, absolute)
    }
}

impl Observer for MomentumBalance {
    fn begin(&mut self, scene: &Scene<'_>) -> Result<(), ObserverError> {
        let case = scene.case;
        let d = case.bearing.dimensions();
        *self = Self {
            ball_masses: (0..case.bearing.balls())
                .map(|k| case.bearing.ball(k).mass_kg)
                .collect(),
            ring_mass: d.inner_ring_mass_kg,
            ring_drag: d.inner_ring_drag_n_s_m,
            radial_load: case.operation.radial_load_n,
            gravity: case.operation.gravity_m_s2,
            centrifugal_radius: (case.profile == Profile::Paper)
                .then(|| case.bearing.pitch_radius_m()),
            ..Self::default()
        };
        let layout = scene.start.layout();
        self.start = self.momentum(layout, scene.start.values());
        self.now = self.start;
        let mut rhs = crate::dynamics::RightHandSide::new(scene.model);
        let s = rhs.snapshot(0.0, scene.start, scene.start_angle_rad).ring;
        let outer = [s.outer_force_x_n, s.outer_force_y_n];
        self.last = Some(self.external(layout, scene.start.values(), outer));
        Ok(())
    }

    fn step(&mut self, view: &View<'_, '_>) -> Result<Control, ObserverError> {
        let step = &view.step;
        let layout = view.layout();
        let (force, absolute) =
            self.external(layout, step.after, view.contacts.outer_ring_force_n());
        if let Some((force_before, absolute_before)) = self.last {
            let half = 0.5 * (step.to_s - step.from_s);
            for k in 0..2 {
                self.impulse[k] += half * (force_before[k] + force[k]);
            }
            self.absolute_impulse += half * (absolute_before + absolute);
        }
        self.last = Some((force, absolute));
        self.now = self.momentum(layout, step.after);
        Ok(Control::Continue)
    }
}
