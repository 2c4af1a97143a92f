//! Advice on what to change of a run that stopped, by the names of this crate or by the keys of a case file.

use std::fmt;

use super::guard::{Cause, Stop};

/// Declares what an advice names: a method or field of this crate, and the key of a case file.
macro_rules! quantities {
    ($($name:ident: $rust:literal, $key:literal;)*) => {
        #[derive(Clone, Copy)]
        enum Quantity { $($name,)* }

        impl Quantity {
            fn name(self, names: Names) -> &'static str {
                match (names, self) {
                    $((Names::Rust, Self::$name) => $rust, (Names::Keys, Self::$name) => $key,)*
                }
            }
        }
    };
}

quantities! {
    AirGap: "Rotor::radial_clearance_m", "rotor.radial_clearance_um";
    AxialLoad: "SpatialLoad::axial_load_n, SpatialLoad::tilt", "operation.axial_load_n, moment_x_n_m, tilt_x_mrad";
    AxialLoadOfRotor: "Rotor::axial_load_n, Rotor::axial_clearance_m, Rotor::vz_m_s",
        "rotor.axial_load_n, rotor.axial_clearance_um, rotor.vz_m_s";
    Balls: "BearingDimensions::balls", "bearing.balls";
    ContactSign: "Row::contact_sign", "contact_sign";
    Damping: "Contact::damping_n_s_m1_5, Contact::ball_restitution", "contact.damping_n_s_m1_5, contact.ball_restitution";
    Gaps: "CaseBuilder::gaps", "start.gaps";
    InnerShoulder: "BearingDimensions::inner_shoulder_radius_m", "bearing.inner_shoulder_radius_mm";
    JournalStiffness: "Rotor::contact_stiffness_n_mp", "rotor.contact_stiffness_n_mp";
    OuterShoulder: "BearingDimensions::outer_shoulder_radius_m", "bearing.outer_shoulder_radius_mm";
    Preload: "Row::preload_m", "preload_um of a row";
    RadialLoad: "CaseBuilder::radial_load_n", "operation.radial_load_n";
    RotorMass: "Rotor::mass_kg", "rotor.mass_kg";
    StartOfRing: "Start::state", "start.ring_y_um";
    SupportStiffness: "Support::stiffness_n_m", "support.stiffness_n_m";
}

/// The names that an advice uses.
#[derive(Clone, Copy)]
enum Names {
    Rust,
    Keys,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}. To change: {}.", self.reason(), self.advice())
    }
}

impl std::error::Error for Stop {}

impl Stop {
    /// Time, cause and advice by the keys of a case file.
    pub fn by_key(&self) -> String {
        format!("{}. To change: {}.", self.reason(), self.advice_by_key())
    }

    /// Advice on what to change, by the names of this crate.
    pub fn advice(&self) -> String {
        self.advice_in(Names::Rust)
    }

    /// [`Self::advice`] by the keys of a case file.
    pub fn advice_by_key(&self) -> String {
        self.advice_in(Names::Keys)
    }

    /// Advice on a step that was too long.
    fn shorter_step(&self, names: Names) -> String {
        let is_long = self.automatic_step_s < self.step_s;
        let step_s = match is_long {
            true => self.automatic_step_s,
            false => 0.5 * self.step_s,
        };
        // To the last digit that a case file needs.
        let step_us = (step_s * 1e12).round() / 1e6;
        if step_us * 1e-6 >= self.step_s || step_us == 0.0 {
            return "begin with lower speeds: the step is as short as it can be".to_owned();
        }
        match (names, is_long) {
            (Names::Keys, true) => {
                format!("set solver.step_us to \"auto\", {step_us} µs in this case")
            }
            (Names::Keys, false) => {
                format!("set solver.step_us to {step_us}, half the step of this run")
            }
            (Names::Rust, true) => {
                format!("leave CaseBuilder::step_s out, for {step_us} µs in this case")
            }
            (Names::Rust, false) => {
                format!("give CaseBuilder::step_s {step_us} µs, half the step of this run")
            }
        }
    }

    /// Advice on balls that the forces press over a shoulder.
    fn advice_beyond(&self, ring: usize, names: Names) -> String {
        let less = match self.drop {
            true => Quantity::AxialLoadOfRotor,
            false => Quantity::AxialLoad,
        };
        let higher = match ring {
            0 => Quantity::InnerShoulder,
            _ => Quantity::OuterShoulder,
        };
        let [less, preload, higher] = [less, Quantity::Preload, higher].map(|own| own.name(names));
        format!(
            "press the balls less along the axis ({less}, {preload}); or make the shoulder higher ({higher})"
        )
    }

    /// Advice on parts that go through each other at the same time with any step.
    fn advice_through(&self, names: Names) -> String {
        let name = |quantity: Quantity| quantity.name(names);
        let again = "if it happens again at the same time";
        match self.drop {
            true => format!(
                "{again}, the impact of the rotor ({}, {}) presses the parts through each other, or the balls leave \
                 a gap below it ({})",
                name(Quantity::RotorMass),
                name(Quantity::AirGap),
                name(Quantity::Gaps)
            ),
            false => format!(
                "{again}, the load ({}) or the start ({}) presses the parts through each other",
                name(Quantity::RadialLoad),
                name(Quantity::StartOfRing)
            ),
        }
    }

    fn advice_in(&self, names: Names) -> String {
        let name = |quantity: Quantity| quantity.name(names);
        let halve = self.shorter_step(names);
        let too_soft = |part: &str, quantity: Quantity| {
            let name = name(quantity);
            format!("{halve}; if it happens again at the same time, the {part} ({name})")
        };
        match &self.cause {
            Cause::RingsMeet {
                balls_that_hold: Some(balls),
                ..
            } => format!(
                "spread the balls ({}), or fit {balls} or more ({}), between which the ring cannot fall however they \
                 bunch",
                name(Quantity::Gaps),
                name(Quantity::Balls)
            ),
            Cause::RingsMeet { .. } => format!(
                "spread the balls ({}): between the two next to the widest gap the ring bears too little",
                name(Quantity::Gaps)
            ),
            Cause::ThroughInnerRing(_) | Cause::ThroughOuterRing(_) | Cause::ThroughBall(_) => {
                format!("{halve}; {}", self.advice_through(names))
            }
            Cause::BeyondGroove { ring, .. } => self.advice_beyond(*ring, names),
            Cause::RotorThroughInnerRing => {
                let part = "contact is too soft for the impact";
                too_soft(part, Quantity::JournalStiffness)
            }
            Cause::OffSupport => {
                let part = "support is too soft for the rotor";
                too_soft(part, Quantity::SupportStiffness)
            }
            Cause::OffSpring(row) => {
                let preload = match names {
                    Names::Rust => format!("Row::preload_n of row {}", row + 1),
                    Names::Keys => format!("row.{}.preload_n", row + 1),
                };
                format!(
                    "raise {preload} above the force along the axis that comes onto this row, or let a row that is \
                     held bear it ({})",
                    name(Quantity::ContactSign)
                )
            }
            Cause::Unbalanced { .. } => halve,
            Cause::Friction { .. } => {
                "return μ from 0 to 2 with its finite slope at every sliding speed".to_owned()
            }
            Cause::TimeNotAhead(_) => format!("go on to a time of {} s or later", self.time_s),
            Cause::NotForward { .. } => {
                "let the method set t1_s after t0_s, at most to limit_s".to_owned()
            }
            Cause::NotFinite | Cause::EnergyFromNowhere { .. } | Cause::NotResolved => format!(
                "{halve}; contacts without damping need some ({})",
                name(Quantity::Damping)
            ),
        }
    }
}
