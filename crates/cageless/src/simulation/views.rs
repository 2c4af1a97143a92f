//! Views of balls, inner ring and rotor at the end of a step, which copy nothing.
//!
//! ```
//! use cageless::prelude::*;
//!
//! let case = CaseBuilder::of(reference::bearing()).inner_speed_rad_s(1000.0).radial_load_n(500.0);
//! let case = case.change(|case| case.operation.space.axial_load_n = 200.0).build()?; // moves in space
//! let simulation = Simulation::new(&case)?;
//! let view = simulation.view();
//! assert!(view.ring().z_m > 0.0);
//! assert!(view.ball(0).inner_contact_angle_rad() > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::f64::consts::TAU;

use super::observer::StepView;
use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};

/// A ball at the end of a step.
#[derive(Clone, Copy)]
pub struct BallView<'a> {
    step: StepView<'a>,
    index: usize,
}

/// Declares a coordinate of a ball.
macro_rules! coordinates {
    ($($(#[$meta:meta])* $name:ident: $coordinate:ident;)*) => {
        $($(#[$meta])*
        pub fn $name(&self) -> f64 {
            let (layout, y1) = (self.step.layout(), &self.step.step.y1);
            layout.ball_at(y1, BallCoordinate::$coordinate, self.index)
        })*
    };
}

/// Declares a quantity of a ball that its contacts have.
macro_rules! of_contacts {
    ($($(#[$meta:meta])* $name:ident: $quantity:ident;)*) => {
        $($(#[$meta])*
        pub fn $name(&self) -> f64 {
            self.step.contacts.$quantity(self.index)
        })*
    };
}

impl BallView<'_> {
    /// Index, from 0, along the motion.
    pub fn index(&self) -> usize {
        self.index
    }

    coordinates! {
        /// X of the centre, m.
        x_m: X;
        /// Y of the centre, m.
        y_m: Y;
        /// Ẋ of the centre, m/s.
        vx_m_s: Vx;
        /// Ẏ of the centre, m/s.
        vy_m_s: Vy;
        /// Z of the centre, m; 0 in the plane.
        z_m: Z;
        /// Ż of the centre, m/s; 0 in the plane.
        vz_m_s: Vz;
        /// Rotation about X, rad/s; 0 in the plane.
        omega_x_rad_s: OmegaX;
        /// Rotation about Y, rad/s; 0 in the plane.
        omega_y_rad_s: OmegaY;
    }

    /// Continuous ψ, rad.
    pub fn angle_rad(&self) -> f64 {
        self.step.angle_after_rad(self.index)
    }

    /// Gap to the ball ahead, rad on the pitch circle: 0 where they touch.
    pub fn gap_rad(&self) -> f64 {
        let ahead = self.step.layout().next(self.index);
        let turn = if ahead <= self.index { TAU } else { 0.0 };
        let angle = |k| self.step.angle_after_rad(k);
        angle(ahead) + turn - angle(self.index) - self.step.model.pair_angle_rad(self.index)
    }

    /// Contact angle at the inner raceway, rad, positive where an axial load along +Z presses: 0 in the plane, NaN
    /// without contact in space.
    pub fn inner_contact_angle_rad(&self) -> f64 {
        let ball = self.step.contacts.in_space(self.index);
        ball.map_or(0.0, |contacts| contacts.inner_contact_angle_rad())
    }

    /// Angle of the force at the outer raceway, rad: 0 in the plane, NaN without contact in space.
    pub fn outer_contact_angle_rad(&self) -> f64 {
        let ball = self.step.contacts.in_space(self.index);
        ball.map_or(0.0, |contacts| contacts.outer_contact_angle_rad())
    }

    of_contacts! {
        /// Orbital speed about the bearing, rad/s.
        orbit_speed_rad_s: orbit_speed_rad_s;
        /// Rotation about the ball's own axis along Z, rad/s.
        rotation_rad_s: rotation_rad_s;
        /// Normal force of the inner raceway, N.
        inner_force_n: inner_force_n;
        /// Normal force of the outer raceway, N.
        outer_force_n: outer_force_n;
        /// Sliding speed at the inner raceway, m/s.
        inner_sliding_m_s: inner_sliding_m_s;
        /// Sliding speed at the outer raceway, m/s.
        outer_sliding_m_s: outer_sliding_m_s;
        /// Normal force of the ball ahead, N.
        ahead_force_n: pair_force_n;
    }
}

/// The inner ring at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingView {
    /// X of the centre, m.
    pub x_m: f64,
    /// Y of the centre, m.
    pub y_m: f64,
    /// Ẋ of the centre, m/s.
    pub vx_m_s: f64,
    /// Ẏ of the centre, m/s.
    pub vy_m_s: f64,
    /// ωi, rad/s, counter-clockwise.
    pub speed_rad_s: f64,
    /// Z of the centre, m; like the next three 0 in the plane.
    pub z_m: f64,
    /// Ż of the centre, m/s.
    pub vz_m_s: f64,
    /// Tilt about X, rad.
    pub tilt_x_rad: f64,
    /// Tilt about Y, rad.
    pub tilt_y_rad: f64,
}

/// The rotor at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorView {
    /// X of the mass centre, m.
    pub x_m: f64,
    /// Y of the mass centre, m.
    pub y_m: f64,
    /// Ẋ of the mass centre, m/s.
    pub vx_m_s: f64,
    /// Ẏ of the mass centre, m/s.
    pub vy_m_s: f64,
    /// Angle turned since the start, rad.
    pub angle_rad: f64,
    /// Ω, rad/s, counter-clockwise.
    pub speed_rad_s: f64,
    /// Normal force of the inner ring on the journal, N.
    pub contact_force_n: f64,
    /// Sliding speed of journal and bore, m/s.
    pub contact_sliding_m_s: f64,
}

impl<'a> StepView<'a> {
    /// Simulated time at the end of the step, s.
    pub fn time_s(&self) -> f64 {
        self.step.t1_s
    }

    /// The balls, in their order along the motion.
    pub fn balls(&self) -> impl Iterator<Item = BallView<'a>> + use<'a> {
        let view = *self;
        (0..self.layout().balls).map(move |index| view.ball(index))
    }

    /// Ball `index`, from 0.
    pub fn ball(&self, index: usize) -> BallView<'a> {
        BallView { step: *self, index }
    }

    /// The inner ring.
    pub fn ring(&self) -> RingView {
        let ring = self.layout().ring_motion(&self.step.y1);
        let at = |coordinate| self.layout().at(&self.step.y1, coordinate);
        RingView {
            x_m: ring.x,
            y_m: ring.y,
            vx_m_s: ring.vx,
            vy_m_s: ring.vy,
            speed_rad_s: self.contacts.inner_ring_speed_rad_s(),
            z_m: at(RingCoordinate::Z),
            vz_m_s: at(RingCoordinate::Vz),
            tilt_x_rad: -at(RingCoordinate::TiltQ),
            tilt_y_rad: at(RingCoordinate::TiltP),
        }
    }

    /// The rotor, if one falls.
    pub fn rotor(&self) -> Option<RotorView> {
        let rotor = self.layout().rotor_motion(&self.step.y1)?;
        let contact = self.contacts.rotor()?.contact;
        Some(RotorView {
            x_m: rotor.x,
            y_m: rotor.y,
            vx_m_s: rotor.vx,
            vy_m_s: rotor.vy,
            angle_rad: rotor.angle,
            speed_rad_s: rotor.speed,
            contact_force_n: contact.force,
            contact_sliding_m_s: contact.slip,
        })
    }
}
