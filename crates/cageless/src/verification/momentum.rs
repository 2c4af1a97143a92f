//! Balance of linear momentum.

use std::sync::Arc;

use crate::ball::{AxialMotion, Ball};
use crate::contact::published;
use crate::dynamics::Contacts;
use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use crate::dynamics::layout::Layout;
use crate::dynamics::{Model, RightHandSide};
use crate::integrator::System;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// Compares the linear momentum of balls and inner ring with the impulses of the external
/// forces: the outer ring, the loads, the weights, the drag on the inner ring and, in
/// the `paper` formulation, the centrifugal force of Zhao 2022, Eq. (15). The forces that balls
/// and inner ring exert on each other must cancel. A rotor pushes the inner ring from outside; with a support the
/// momentum of the outer ring counts, too, which the support then pushes.
///
/// Impulses are sums by the trapezoidal rule over the steps.
#[derive(Debug, Clone, Default)]
pub(super) struct MomentumBalance {
    model: Option<Arc<Model>>,
    start: [f64; 3],
    now: [f64; 3],
    impulse: [f64; 3],
    absolute_impulse: f64,
    last: Option<([f64; 3], f64)>,
}

impl MomentumBalance {
    /// |momentum now − momentum at the start − impulses| over the sum of absolute impulses.
    pub(super) fn residual_relative(&self) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|k| self.now[k] - self.start[k] - self.impulse[k]);
        if self.absolute_impulse > 0.0 {
            x.hypot(y).hypot(z) / self.absolute_impulse
        } else {
            0.0
        }
    }
}

/// Sum of the momenta of balls, inner ring and outer ring, N·s.
fn momentum(model: &Model, layout: Layout, values: &[f64]) -> [f64; 3] {
    let of = |coordinate: BallCoordinate, ring: RingCoordinate| {
        let balls = model.balls.iter().enumerate();
        let of_ball = |(k, ball): (usize, &Ball)| ball.mass * layout.ball_at(values, coordinate, k);
        balls.map(of_ball).sum::<f64>() + model.ring.mass * layout.at(values, ring)
    };
    let [x, y, z] = [
        of(BallCoordinate::Vx, RingCoordinate::Vx),
        of(BallCoordinate::Vy, RingCoordinate::Vy),
        of(BallCoordinate::Vz, RingCoordinate::Vz),
    ];
    let (outer, mass) = (layout.outer_ring_motion(values), model.outer_ring.mass);
    let AxialMotion { vz: outer_vz, .. } = layout.outer_ring_along_axis(values);
    [
        x + mass * outer.vx,
        y + mass * outer.vy,
        z + mass * outer_vz,
    ]
}

/// Forces of the bearing on what surrounds it, N.
struct Pressed {
    /// On the outer ring.
    outer: [f64; 3],
    /// On the rotor.
    rotor: [f64; 3],
}

impl Pressed {
    /// Forces of these contacts, N.
    fn of(contacts: &Contacts<'_>) -> Self {
        let [x, y] = contacts.outer_ring_force_n();
        Self {
            outer: [x, y, contacts.outer_ring_axial_force_n()],
            rotor: contacts.loads_on_rotor().unwrap_or_default().force,
        }
    }
}

/// Sum of the external forces at a time and state where the bearing presses what surrounds it, and
/// the sum of their absolute values, N.
fn external(
    model: &Model,
    layout: Layout,
    time_s: f64,
    values: &[f64],
    pressed: &Pressed,
) -> ([f64; 3], f64) {
    let Pressed { outer, rotor } = *pressed;
    let motion = layout.ring_motion(values);
    let ring = &model.ring;
    let balls: f64 = model.balls.iter().map(|ball| ball.mass).sum();
    let weight = (ring.mass + balls) * ring.gravity;
    let outer = if model.outer_ring.mass > 0.0 {
        let outer_ring = layout.outer_ring_motion(values);
        let support = &model.outer_ring.support;
        let [x, y] = support.force(&outer_ring);
        let along_axis = layout.outer_ring_along_axis(values);
        [-x, -y, -support.force_along_axis(&along_axis)]
    } else {
        outer
    };
    let (axial_load, vz, upward) = match &model.space {
        Some(space) => (
            space.axial_load,
            values[layout.ring(RingCoordinate::Vz)],
            space.upward,
        ),
        None => (0.0, 0.0, 1),
    };
    let [load_x, load_y] = model.load_n(time_s);
    let mut force = [
        -outer[0] - rotor[0] - ring.drag * motion.vx + load_x,
        -outer[1] - rotor[1] - ring.drag * motion.vy + load_y,
        -outer[2] - rotor[2] - ring.drag * vz + axial_load,
    ];
    force[upward] -= weight;
    let mut absolute = outer[0].hypot(outer[1]).hypot(outer[2])
        + rotor[0].hypot(rotor[1]).hypot(rotor[2])
        + ring.drag * motion.vx.hypot(motion.vy).hypot(vz)
        + load_x.hypot(load_y)
        + axial_load.abs()
        + weight;
    if model.formulation.equations().centrifugal_force {
        for (k, ball) in model.balls.iter().enumerate() {
            let polar = layout
                .ball_motion(values, k)
                .about(&layout.outer_ring_motion(values));
            let centrifugal = published::centrifugal_force(ball, &model.outer, &polar);
            force[0] += centrifugal * polar.ex;
            force[1] += centrifugal * polar.ey;
            absolute += centrifugal;
        }
    }
    (force, absolute)
}

impl Observer for MomentumBalance {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let (layout, values) = (context.start.layout(), context.start.values());
        let mut rhs = RightHandSide::new(context.model);
        rhs.derivative(0.0, values, &mut vec![0.0; values.len()]);
        let pressed = Pressed::of(&rhs.contacts());
        let start = momentum(context.model, layout, values);
        *self = Self {
            start,
            now: start,
            last: Some(external(context.model, layout, 0.0, values, &pressed)),
            model: Some(Arc::clone(context.model)),
            ..Self::default()
        };
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let Some(model) = &self.model else {
            return Ok(Control::Continue(()));
        };
        let (step, layout) = (view.step, view.layout());
        let pressed = Pressed::of(&view.contacts);
        let (force, absolute) = external(model, layout, step.t1_s, &step.y1, &pressed);
        if let Some((force_before, absolute_before)) = self.last {
            let half = 0.5 * step.size_s();
            for k in 0..3 {
                self.impulse[k] += half * (force_before[k] + force[k]);
            }
            self.absolute_impulse += half * (absolute_before + absolute);
        }
        self.last = Some((force, absolute));
        self.now = momentum(model, layout, &step.y1);
        Ok(Control::Continue(()))
    }
}
