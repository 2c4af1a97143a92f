//! Change of a state over a step.

use super::body::BodyCoordinate;
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;

/// The state at the end of a step and its rate, to which forces are added that act over the whole step.
pub(crate) struct StepChange<'y> {
    pub layout: Layout,
    /// h, s.
    pub h_s: f64,
    pub y: &'y mut [f64],
    pub dydt: &'y mut [f64],
}

impl StepChange<'_> {
    /// Adds a rate to a place.
    #[inline(always)]
    pub(crate) fn add_at(&mut self, place: usize, rate: f64) {
        self.dydt[place] += rate;
        self.y[place] += self.h_s * rate;
    }

    /// Adds the acceleration of a body, unless the coordinate is held.
    #[inline(always)]
    pub(crate) fn add(&mut self, coordinate: impl Into<BodyCoordinate>, rate: f64) {
        let coordinate = coordinate.into();
        if self.layout.moves(coordinate) {
            self.add_at(self.layout.body(coordinate), rate);
        }
    }

    /// Adds a power to the energy ledger.
    #[inline(always)]
    pub(crate) fn add_energy(&mut self, term: EnergyTerm, power: f64) {
        self.add_at(self.layout.energy_term(term), power);
    }
}
