//! Local optimisation from the best design of the grid: Powell's COBYLA, which
//! needs no derivatives and keeps to the constraints.

use std::cell::RefCell;

use cobyla::{Func, RhoBeg, StopTols, minimize};

/// Objective and constraints (0 or more is kept) at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Value<const C: usize> {
    /// Objective to minimise.
    pub objective: f64,
    /// Constraints, each satisfied at 0 or more.
    pub constraints: [f64; C],
}

/// The best place near 0 found by about `evaluations` of the model within ±`reach`, in units of the
/// caller's steps; `None` if no place but the start was better and kept to the constraints.
pub(super) fn minimise<const C: usize>(
    reach: f64,
    evaluations: usize,
    start: Value<C>,
    evaluate: &mut dyn FnMut([f64; 2]) -> Value<C>,
) -> Option<[f64; 2]> {
    // Objective and constraints are asked for one by one at the same place.
    type Seen<const C: usize> = Vec<([f64; 2], Value<C>)>;
    let seen: RefCell<Seen<C>> = RefCell::new(vec![([0.0; 2], start)]);
    let evaluate = RefCell::new(evaluate);
    let at = |x: &[f64]| {
        let place = [x[0], x[1]];
        let known = seen.borrow().iter().find(|(p, _)| *p == place).copied();
        if let Some((_, value)) = known {
            return value;
        }
        let value = (evaluate.borrow_mut())(place);
        seen.borrow_mut().push((place, value));
        value
    };
    let constraints: Vec<_> = (0..C)
        .map(|k| {
            let at = &at;
            move |x: &[f64], _: &mut ()| at(x).constraints[k]
        })
        .collect();
    let constraints: Vec<&dyn Func<()>> = constraints.iter().map(|c| c as &dyn Func<()>).collect();
    // Whatever it ends with, the best of what was seen counts.
    let _ = minimize(
        |x: &[f64], _: &mut ()| at(x).objective,
        &[0.0, 0.0],
        &[(-reach, reach), (-reach, reach)],
        &constraints,
        (),
        evaluations,
        RhoBeg::All(0.5),
        Some(StopTols {
            xtol_abs: vec![0.02; 2],
            ..StopTols::default()
        }),
    );
    let seen = seen.into_inner();
    seen.iter()
        .skip(1)
        .filter(|(_, v)| v.constraints.iter().all(|c| *c >= 0.0))
        .filter(|(_, v)| v.objective < start.objective)
        .min_by(|(_, a), (_, b)| a.objective.total_cmp(&b.objective))
        .map(|(place, _)| *place)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The minimum of a paraboloid lies outside; the best allowed place is where its gradient
    /// is along the constraint.
    #[test]
    fn a_constrained_paraboloid() {
        let value = |[x, y]: [f64; 2]| Value {
            objective: (x - 1.0).powi(2) + (y - 1.0).powi(2),
            constraints: [1.0 - x - y],
        };
        let [x, y] = minimise(2.0, 24, value([0.0; 2]), &mut { value }).unwrap();
        assert!(x + y <= 1.0 + 1e-12);
        assert!((x - 0.5).abs() < 0.1 && (y - 0.5).abs() < 0.1, "{x} {y}");
    }

    #[test]
    fn nothing_better_than_the_start() {
        let value = |[x, y]: [f64; 2]| Value {
            objective: x * x + y * y,
            constraints: [1.0],
        };
        assert_eq!(minimise(1.0, 24, value([0.0; 2]), &mut { value }), None);
    }
}
