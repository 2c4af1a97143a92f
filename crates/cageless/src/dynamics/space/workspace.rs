//! Work arrays of an evaluation in space.

use super::contact::Contact;
use super::model::SpaceModel;
use super::ring::RingMotion;
use super::strips::StripFriction;

/// Places of contact of a ball: two at the outer ring, one at the inner ring.
pub(crate) const PLACES: usize = 3;

/// Contacts of a ball with the rings as of the last evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallContacts {
    /// Force at the inner raceway along the radius and against the axis of the ring, N.
    pub(crate) inner_force_n: [f64; 2],
    /// Force at the outer raceway along the radius and the axis, N.
    pub(crate) outer_force_n: [f64; 2],
    /// Forces at the outer raceway: the plain groove or the flank towards +Z, and the other flank.
    pub flank_force_n: [f64; 2],
    /// Force on the outer ring along X and Y, friction included.
    pub(crate) outer_ring_force_n: [f64; 2],
}

/// Angle of a force of a contact from the radius; NaN without one.
fn angle_rad([along, across]: [f64; 2]) -> f64 {
    match [along, across] == [0.0; 2] {
        true => f64::NAN,
        false => across.atan2(along),
    }
}

impl BallContacts {
    /// Contact angle at the inner raceway, positive where an axial load along +Z presses, rad;
    /// NaN without contact.
    pub fn inner_contact_angle_rad(&self) -> f64 {
        angle_rad(self.inner_force_n)
    }

    /// Angle of the force at the outer raceway, rad; NaN without contact.
    pub fn outer_contact_angle_rad(&self) -> f64 {
        angle_rad(self.outer_force_n)
    }
}

/// One ball.
#[derive(Debug, Clone)]
pub(crate) struct BallWork {
    pub contacts: [Contact; PLACES],
    /// Whether the ball was within a discrete raceway at the last friction and is now.
    pub inside: [bool; 2],
    /// Velocities at the evaluation: **v**, R**ω**.
    pub velocity: [f64; 6],
}

/// Work arrays of an evaluation in space.
#[derive(Debug, Clone)]
pub(crate) struct SpaceWorkspace {
    pub ring: RingMotion,
    pub balls: Vec<BallWork>,
    pub results: Vec<BallContacts>,
    /// Friction of every strip at the end of the last implicit step; the strips of a place of a ball one
    /// after the other.
    pub strips: Vec<KnownStrip>,
    /// The strips of one ball while its step is solved for.
    pub steps: Vec<StripStep>,
    /// Whether the last evaluation with friction was that step.
    pub known: bool,
}

/// A strip while a step is solved for.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct StripStep {
    /// 1 over the speed of the knee, s/m.
    pub inverse_knee: f64,
    /// Moment within the strip, N·m.
    pub moment: f64,
    /// Sliding velocity of the last iterate along τ and l, m/s, and the friction there.
    pub slip: [f64; 2],
    pub friction: StripFriction,
    /// Friction that changes velocities over the step.
    pub mean: KnownStrip,
}

impl StripStep {
    /// Φ = −∂f/∂s along τ and l; if `safe` that of a cone which no step of Newton's method overshoots.
    #[inline(always)]
    pub fn stiffness(&self, safe: bool) -> [[f64; 2]; 2] {
        let StripFriction {
            secant,
            steepness,
            direction: [a, b],
            ..
        } = self.friction;
        // A law that falls beyond its peak is not stiff there.
        let along = if safe {
            0.0
        } else {
            steepness.max(0.0) - secant
        };
        [
            [secant + along * a * a, along * a * b],
            [along * a * b, secant + along * b * b],
        ]
    }
}

/// Friction of a strip at the end of a step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct KnownStrip {
    pub force: [f64; 2],
    pub moment: f64,
    pub secant: f64,
}

impl SpaceWorkspace {
    pub fn new(model: &SpaceModel) -> Self {
        let none = BallContacts {
            inner_force_n: [0.0; 2],
            outer_force_n: [0.0; 2],
            flank_force_n: [0.0; 2],
            outer_ring_force_n: [0.0; 2],
        };
        let ball = BallWork {
            contacts: [Contact::default(); PLACES],
            inside: [false; 2],
            velocity: [0.0; 6],
        };
        let balls = model.balls.len();
        Self {
            ring: RingMotion::at_rest(),
            balls: vec![ball; balls],
            results: vec![none; balls],
            strips: vec![KnownStrip::default(); balls * PLACES * model.strips.len()],
            steps: vec![StripStep::default(); PLACES * model.strips.len()],
            known: false,
        }
    }

    /// Force of the balls on the outer ring along X and Y, N.
    pub fn outer_ring_force_n(&self) -> [f64; 2] {
        self.results.iter().fold([0.0; 2], |[x, y], ball| {
            let [u, v] = ball.outer_ring_force_n;
            [x + u, y + v]
        })
    }
}
