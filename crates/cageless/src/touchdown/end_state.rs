//! State of a rotor at the end of a drop, in one word.

use crate::rotor::Shaft;

use super::whirl::{ONE_WAY, WHIRL_TURNS, WhirlWindow};

crate::named_enum! {
    /// State of the rotor at the end of a drop.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub enum EndState {
        /// The rotor has not touched the inner ring.
        #[default]
        Falling = "falling",
        /// The rotor lies in the bottom of the bore, or at the angle to which friction carries it; or stands
        /// on its shoulder.
        AtRest = "at-rest",
        /// The rotor swings in the bottom of the bore without leaving it.
        Pendulum = "pendulum",
        /// The rotor leaves the bore and falls back.
        Bouncing = "bouncing",
        /// The rotor stays in contact, and the bearing does not carry its weight yet: both still sink or
        /// rebound.
        Settling = "settling",
        /// The rotor runs round the bore in the direction of its rotation.
        ForwardWhirl = "forward-whirl",
        /// The rotor runs round the bore against the direction of its rotation.
        BackwardWhirl = "backward-whirl",
    }
}

/// Fraction of the time in contact below which the rotor bounces.
const CONTACT: f64 = 0.95;
/// Part of its weight by which the mean force on a rotor that is carried differs from it at most.
const BALANCED: f64 = 0.1;
/// Swing, from end to end, below which the rotor is at rest, rad.
const AT_REST_RAD: f64 = 0.02;

impl EndState {
    /// The state in the words of a report on a rotor drop.
    pub fn text(self) -> &'static str {
        match self {
            Self::Falling => "falling (no contact yet)",
            Self::Settling => "contact, still sinking or rebounding",
            Self::AtRest => "rest on the bearing",
            Self::Pendulum => "oscillation at the bottom (continuous contact)",
            Self::Bouncing => "intermittent contact",
            Self::ForwardWhirl => "forward whirl",
            Self::BackwardWhirl => "backward whirl",
        }
    }

    /// The state of a name in files.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|state| state.name() == name)
    }

    /// State of a rotor that whirls in the sense of `turned` while it turns in that of `rotation`.
    pub(super) fn of_whirl(turned: f64, rotation: f64) -> Self {
        match turned * rotation < 0.0 {
            true => Self::BackwardWhirl,
            false => Self::ForwardWhirl,
        }
    }

    /// State over the last windows of a drop of a rotor that has touched the inner ring.
    /// `weight_n` is the weight that the bearing carries, if it carries any.
    pub(super) fn classify(
        last: &[WhirlWindow],
        rotation: f64,
        weight_n: Option<f64>,
        shaft: Shaft,
    ) -> Self {
        let sum = |of: fn(&WhirlWindow) -> f64| last.iter().map(of).sum::<f64>();
        let (net, path) = (sum(|w| w.turned_rad), sum(|w| w.path_rad));
        let time = sum(|w| w.end_s - w.start_s);
        let in_contact = sum(|w| w.contact_fraction * (w.end_s - w.start_s));
        let turns = net.abs() / std::f64::consts::TAU;
        if turns >= WHIRL_TURNS && net.abs() >= ONE_WAY * path {
            return Self::of_whirl(net, rotation);
        }
        if in_contact < CONTACT * time {
            return Self::Bouncing;
        }
        let lift_n = sum(|w| w.lift_mean_n * (w.end_s - w.start_s)) / time;
        let carried = |weight_n: f64| (lift_n / weight_n - 1.0).abs() < BALANCED;
        if weight_n.is_some_and(|weight_n| weight_n > 0.0 && !carried(weight_n)) {
            return Self::Settling;
        }
        let low = last
            .iter()
            .map(|w| w.angle_min_rad)
            .fold(f64::INFINITY, f64::min);
        let high = last
            .iter()
            .map(|w| w.angle_max_rad)
            .fold(f64::NEG_INFINITY, f64::max);
        // A vertical rotor stands on its shoulder, and has no bottom to swing in.
        if high - low < AT_REST_RAD || shaft == Shaft::Vertical {
            Self::AtRest
        } else {
            Self::Pendulum
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact_tracker::ContactCounts;

    fn window(turned_rad: f64, path_rad: f64, contact_fraction: f64, swing: f64) -> WhirlWindow {
        WhirlWindow {
            start_s: 0.0,
            end_s: 0.01,
            turned_rad,
            path_rad,
            angle_min_rad: -swing / 2.0,
            angle_max_rad: swing / 2.0,
            contact_fraction,
            force_mean_n: 1.0,
            lift_mean_n: 1.0,
            collisions: ContactCounts::default(),
        }
    }

    #[test]
    fn each_motion_has_its_word() {
        let last = |w: WhirlWindow| [w; 3];
        for (windows, rotation, state) in [
            (
                last(window(-9.0, 9.1, 1.0, 9.0)),
                100.0,
                EndState::BackwardWhirl,
            ),
            (
                last(window(-9.0, 9.1, 1.0, 9.0)),
                -100.0,
                EndState::ForwardWhirl,
            ),
            (last(window(0.1, 9.0, 0.5, 3.0)), 100.0, EndState::Bouncing),
            (last(window(0.0, 0.6, 1.0, 0.3)), 100.0, EndState::Pendulum),
            (last(window(0.0, 0.01, 1.0, 0.01)), 100.0, EndState::AtRest),
        ] {
            assert_eq!(
                EndState::classify(&windows, rotation, Some(1.0), Shaft::Horizontal),
                state
            );
        }
        // Within a tenth of the weight, in either direction, the bearing carries the rotor.
        let rest = last(window(0.0, 0.01, 1.0, 0.01));
        let swing = last(window(0.0, 0.6, 1.0, 0.3));
        for (weight, at_rest) in [(1.05, true), (0.95, true), (2.6, false), (0.8, false)] {
            let [rest, swing] = [&rest, &swing]
                .map(|w| EndState::classify(w, 100.0, Some(weight), Shaft::Horizontal));
            assert_eq!(rest == EndState::AtRest, at_rest, "{weight}: {rest:?}");
            assert_eq!(swing == EndState::Pendulum, at_rest, "{weight}: {swing:?}");
            assert!(at_rest || (rest, swing) == (EndState::Settling, EndState::Settling));
        }
        // A bearing that carries none of the rotor has no weight to compare with.
        let unloaded = EndState::classify(&rest, 100.0, None, Shaft::Horizontal);
        assert_eq!(unloaded, EndState::AtRest);
        let standing = EndState::classify(&swing, 100.0, Some(1.0), Shaft::Vertical);
        assert_eq!(standing, EndState::AtRest);
        for state in EndState::ALL {
            assert_eq!(EndState::from_name(state.name()), Some(state));
        }
    }
}
