//! Which balls have just begun to touch.

use crate::dynamics::Contacts;

/// Follows the contacts between neighbouring balls from step to step.
#[derive(Debug, Clone)]
pub struct Onsets {
    touching: Vec<bool>,
    begun: Vec<bool>,
    any_touching: bool,
    any_begun: bool,
}

impl Onsets {
    /// Of so many balls; a contact that there is at the first look counts as begun.
    pub fn new(balls: usize) -> Self {
        Self {
            touching: vec![false; balls],
            begun: vec![false; balls],
            any_touching: false,
            any_begun: false,
        }
    }

    /// Looks at the contacts at the end of a step.
    pub fn look(&mut self, contacts: &Contacts<'_>) {
        let touch = contacts.balls_touch();
        // Most steps have no contact, and none before.
        if !touch && !self.any_touching && !self.any_begun {
            return;
        }
        self.any_begun = false;
        for (k, (touching, begun)) in self.touching.iter_mut().zip(&mut self.begun).enumerate() {
            let now = touch && contacts.pair_deflection_m(k) > 0.0;
            *begun = now && !*touching;
            *touching = now;
            self.any_begun |= *begun;
        }
        self.any_touching = touch;
    }

    /// Whether ball `k` and the ball ahead have touched since the look before.
    pub fn begun(&self, k: usize) -> bool {
        self.begun[k]
    }

    /// How many pairs have touched since the look before.
    pub fn count(&self) -> u32 {
        if !self.any_begun {
            return 0;
        }
        self.begun.iter().map(|&begun| u32::from(begun)).sum()
    }
}
