//! Shares of a search's budget: how many simulations of all balls each stage may take.

use super::request::{CONFIRMING_STARTS, Request};

/// Structures that are confirmed at most: the recommended one and the case's own.
const CONFIRMED_MAX: usize = 2;
/// The smallest possible budget of one operating point.
pub const BUDGET_LEAST: usize = 8 * CONFIRMED_MAX * STARTS_LEAST;
/// Starts of a confirmation at least.
const STARTS_LEAST: usize = 2;
/// Structures that the optimiser tries at most.
const OPTIMISED_MAX: usize = 24;

/// Shares of the budget: half for the front, a quarter for the maps, an eighth each for the optimiser and
/// the confirmation.
impl Request {
    /// The smallest possible budget: the confirmation needs two starts and as many as any
    /// structure has, each map one cell.
    pub fn budget_least(&self) -> usize {
        let maps = self.points.len() + self.map_speeds_rad_s.len();
        let confirmed =
            CONFIRMED_MAX * self.points.len() * (self.starts as usize).max(STARTS_LEAST);
        (8 * confirmed).max(4 * (maps * self.starts as usize + self.bunched()))
    }

    /// Structures that are simulated for the front.
    pub(crate) fn front_structures(&self) -> usize {
        self.budget / 2 / self.of_structure()
    }

    /// Cells of all maps together that are simulated.
    pub(crate) fn map_cells_simulated(&self) -> usize {
        (self.budget / 4 - self.bunched()) / self.starts as usize
    }

    /// Bunched starts of the confirmation, which the share of the maps bears.
    fn bunched(&self) -> usize {
        CONFIRMED_MAX * self.points.len()
    }

    /// Structures that the optimiser tries.
    pub(crate) fn optimised_structures(&self) -> usize {
        OPTIMISED_MAX.min(self.budget / 8 / self.of_structure())
    }

    /// Drawn starts from which a structure is confirmed, beside the bunched one.
    pub fn confirming_starts(&self) -> u64 {
        let share = self.budget / 8 / (CONFIRMED_MAX * self.points.len());
        (share as u64).clamp(self.starts.max(2), CONFIRMING_STARTS.max(self.starts))
    }

    /// Simulations of one structure.
    fn of_structure(&self) -> usize {
        self.points.len() * self.starts as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::structure;

    /// Whatever the points, starts and maps, the shares add up to no more than the budget.
    #[test]
    fn shares_add_up_to_the_budget_at_most() {
        let case = structure(5.1, 25.2);
        for (points, starts, maps) in [(1, 1, 0), (1, 2, 0), (2, 3, 2), (4, 2, 1), (1, 20, 4)] {
            let mut request = Request::from_case(&case);
            request.points = vec![request.points[0]; points];
            request.map_speeds_rad_s = vec![100.0; maps];
            request.starts = starts;
            let least = request.budget_least();
            for budget in [least, least + 1, 2 * least + 3, 10 * least] {
                request.budget = budget;
                let of_structure = points * starts as usize;
                let sum = request.front_structures() * of_structure
                    + request.map_cells_simulated() * starts as usize
                    + request.optimised_structures() * of_structure
                    + (request.confirming_starts() as usize + 1) * points * 2;
                assert!(sum <= budget, "{sum} of {budget}");
                assert!(request.front_structures() >= 1);
                assert!(request.map_cells_simulated() >= points + maps);
                assert!(request.confirming_starts() >= starts.max(2));
            }
        }
    }

    #[test]
    fn default_shares() {
        let request = Request::from_case(&structure(5.1, 25.2));
        let found = (
            request.front_structures(),
            request.map_cells_simulated(),
            request.optimised_structures(),
            request.confirming_starts(),
            request.budget_least(),
        );
        assert_eq!((request.budget, found), (400, (100, 49, 24, 12, 32)));
    }
}
