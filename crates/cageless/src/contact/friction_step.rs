//! Friction of several places between two bodies at the end of a step whose other forces are known, and when
//! the iteration for it ends: of a joint as of a ball.
//!
//! With the N relative velocities **u**, the sliding velocities **s** = J **u** and the loads Jᵀ **f**,
//!
//!   **u** = **u*** + h C Σ Jᵀ ((1 − θ) **f**₀ + θ **f**(J **u**)),
//!
//! C being the compliance of both bodies.

use nalgebra::{Const, DimMin, Matrix2, SMatrix, SVector, Vector2};

use super::Friction;

/// No step of Newton's method follows one that changes no sliding velocity by more than this, in the
/// regularisation speed. The friction is then linear over the step to within half the square of this
/// fraction times μN, and the end of the step satisfies the linear equations exactly.
pub(crate) const LAST_STEP: f64 = 0.05;
/// Multiple of the regularisation speed from which on a contact slides, with a friction that changes in
/// direction alone: tanh misses 1 by less than 1e-3.
pub(crate) const SLIDING: f64 = 4.0;
/// Largest last step of a sliding velocity in the plane of the contact that slides, as a fraction of it.
const LAST_TURN: f64 = 0.03;
/// Iterations after which the matrix is one that no step overshoots.
pub(crate) const PATIENCE: u32 = 6;

/// Largest number of iterations; from anywhere some ten suffice.
pub(crate) const MAX_ITERATIONS: u32 = 30;

/// Weights θ of the end of a step in s₁ = s_free − H·((1 − θ)·f₀ + θ·f₁) for two contacts whose
/// slips decay by z = H·df/ds over the step: (6 + 3z + z²)/(12 + 4z + z²).
///
/// It follows the exponentially fitted 1/(1 − e^(−z)) − 1/z from ½ + z/12 to 1 − 1/z: the
/// trapezoidal rule of order 2 for sliding contacts, backward Euler, which damps any stiffness,
/// for rolling ones (Hairer & Wanner, *Solving Ordinary Differential Equations II*,
/// section IV.3).
#[inline(always)]
pub(crate) fn end_weights(rates: [f64; 2]) -> [f64; 2] {
    // Squares of larger rates could overflow; 1 is exact to six digits there.
    let [y, z] = [rates[0].min(1e6), rates[1].min(1e6)];
    let [below_y, below_z] = [12.0 + (4.0 + y) * y, 12.0 + (4.0 + z) * z];
    // One division for both.
    let inverse = 1.0 / (below_y * below_z);
    [
        (6.0 + (3.0 + y) * y) * below_z * inverse,
        (6.0 + (3.0 + z) * z) * below_y * inverse,
    ]
}

/// Whether a sliding velocity of `speed`, which slides beyond the regularisation speed `knee`, needs no step
/// after one that changes it by `moved`.
#[inline(always)]
pub(crate) fn slides_on(speed: f64, moved: f64, knee: f64) -> bool {
    (speed > SLIDING * knee) & (moved <= LAST_TURN * speed)
}

/// Friction on a body at a place that slides.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct PlaceFriction {
    /// Force, N.
    force: Vector2<f64>,
    /// |f|/|s|, N·s/m.
    secant: f64,
    /// −∂f/∂s, no less than 0 along s, N·s/m.
    tangent: Matrix2<f64>,
}

/// A place at which two bodies slide.
#[derive(Debug, Clone)]
pub(crate) struct SlidingPlace<const N: usize> {
    /// J.
    pub rows: SMatrix<f64, 2, N>,
    /// Normal force, N.
    pub normal_n: f64,
    /// |f|/|s| at the end of the last step of it and of places that slow the bodies with it, N·s/m.
    pub slowing: f64,
    /// Friction at the end of the last step, N.
    force: Vector2<f64>,
    /// |f|/|s| there, N·s/m.
    secant: f64,
}

impl<const N: usize> Default for SlidingPlace<N> {
    fn default() -> Self {
        Self {
            rows: SMatrix::zeros(),
            normal_n: 0.0,
            slowing: 0.0,
            force: Vector2::zeros(),
            secant: 0.0,
        }
    }
}

impl<const N: usize> SlidingPlace<N> {
    /// |f|/|s| at the end of the last step, N·s/m.
    pub(crate) fn secant(&self) -> f64 {
        self.secant
    }

    /// Friction at the end of the last step, N.
    pub(crate) fn force(&self) -> Vector2<f64> {
        self.force
    }

    /// Sets the friction to that of velocities **u** and adds it to loads; its heat, W.
    pub(crate) fn slide(
        &mut self,
        law: &Friction,
        velocities: &SVector<f64, N>,
        loads: &mut SVector<f64, N>,
    ) -> f64 {
        let slip = self.rows * velocities;
        let friction = self.friction(law, slip);
        (self.force, self.secant) = (friction.force, friction.secant);
        *loads += self.rows.transpose() * friction.force;
        -friction.force.dot(&slip)
    }

    fn friction(&self, law: &Friction, slip: Vector2<f64>) -> PlaceFriction {
        let speed = slip.norm();
        let [size, steepness] = law.force(speed, self.normal_n);
        let slides = speed * law.inverse_regularisation_speed() > 1e-9;
        let secant = if slides { size / speed } else { steepness };
        let direction = if slides {
            slip / speed
        } else {
            Vector2::zeros()
        };
        let along = direction * direction.transpose() * (steepness.max(0.0) - secant);
        PlaceFriction {
            force: -secant * slip,
            secant,
            tangent: Matrix2::identity() * secant + along,
        }
    }
}

/// A step of two bodies that slide on each other.
pub(crate) struct FrictionStep<'a, const N: usize> {
    /// Law of all places.
    pub law: &'a Friction,
    /// C.
    pub compliance: SMatrix<f64, N, N>,
    /// h, s.
    pub h_s: f64,
    /// Whether the friction at the start is known.
    pub is_known: bool,
}

/// Ends of a step without friction.
pub(crate) struct StepEnds<const N: usize> {
    /// **u** at the start.
    pub start: SVector<f64, N>,
    /// **u***, to which all but friction leads.
    pub free: SVector<f64, N>,
}

/// Outcome of a step.
pub(crate) struct SteppedFriction<const N: usize> {
    /// Loads that changed the velocities over the step.
    pub mean: SVector<f64, N>,
    /// Loads at its end.
    pub end: SVector<f64, N>,
    /// **u** at its end.
    pub velocities: SVector<f64, N>,
    /// Heat, W.
    pub heat: f64,
}

/// An iterate.
struct Iterate<const N: usize, const PLACES: usize> {
    velocities: SVector<f64, N>,
    /// Friction of each place, linear about the last iterate once it has converged, N.
    ends: [Vector2<f64>; PLACES],
}

impl<const N: usize> FrictionStep<'_, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// Solves for the friction of the places, and leaves in them that of the end of the step.
    pub(crate) fn solve<const PLACES: usize>(
        &self,
        places: &mut [SlidingPlace<N>; PLACES],
        ends: &StepEnds<N>,
    ) -> SteppedFriction<N> {
        let weights = self.weights(places);
        let mut rest = ends.free;
        for (place, weight) in places.iter().zip(weights) {
            let share = self.h_s * (1.0 - weight);
            rest += self.compliance * place.rows.transpose() * place.force * share;
        }
        let end = self.iterate(places, &weights, ends.free, rest);
        let mut stepped = SteppedFriction {
            mean: SVector::zeros(),
            end: SVector::zeros(),
            velocities: end.velocities,
            heat: 0.0,
        };
        for ((place, weight), force) in places.iter_mut().zip(weights).zip(end.ends) {
            let mean = place.force * (1.0 - weight) + force * weight;
            place.secant = place.friction(self.law, place.rows * end.velocities).secant;
            place.force = force;
            let rows = place.rows;
            stepped.mean += rows.transpose() * mean;
            stepped.end += rows.transpose() * force;
            stepped.heat -= 0.5 * mean.dot(&(rows * (ends.start + end.velocities)));
        }
        stepped
    }

    /// θ of each place; the friction of places that have opened is no longer known.
    fn weights<const PLACES: usize>(
        &self,
        places: &mut [SlidingPlace<N>; PLACES],
    ) -> [f64; PLACES] {
        places.each_mut().map(|place| {
            if place.normal_n == 0.0 {
                (place.force, place.secant) = (Vector2::zeros(), 0.0);
                return 1.0;
            }
            if !self.is_known {
                return 1.0;
            }
            let mobility = (place.rows * self.compliance * place.rows.transpose()).diagonal();
            let [weight, _] = end_weights([self.h_s * mobility.max() * place.slowing, 0.0]);
            weight
        })
    }

    /// Newton's method from `free`.
    fn iterate<const PLACES: usize>(
        &self,
        places: &[SlidingPlace<N>; PLACES],
        weights: &[f64; PLACES],
        free: SVector<f64, N>,
        rest: SVector<f64, N>,
    ) -> Iterate<N, PLACES> {
        let mut now = free;
        let mut ends = [Vector2::zeros(); PLACES];
        let knee = 1.0 / self.law.inverse_regularisation_speed();
        for iteration in 0..MAX_ITERATIONS {
            let mut matrix = SMatrix::<f64, N, N>::identity();
            let mut missing = rest - now;
            let mut tangents = [Matrix2::zeros(); PLACES];
            for (k, place) in places.iter().enumerate() {
                let friction = place.friction(self.law, place.rows * now);
                let answer = self.compliance * place.rows.transpose() * (self.h_s * weights[k]);
                tangents[k] = match iteration > PATIENCE {
                    true => Matrix2::identity() * friction.secant,
                    false => friction.tangent,
                };
                missing += answer * friction.force;
                matrix += answer * tangents[k] * place.rows;
                ends[k] = friction.force;
            }
            let change = matrix.lu().solve(&missing).unwrap_or(missing);
            let mut done = true;
            for (k, place) in places.iter().enumerate() {
                let turn = place.rows * change;
                let moved = turn.norm();
                let slides = slides_on((place.rows * now).norm(), moved, knee);
                done &= place.normal_n == 0.0 || moved <= LAST_STEP * knee || slides;
                // Linear about the last iterate, so that the equations hold exactly.
                ends[k] -= tangents[k] * turn;
            }
            now += change;
            if done {
                break;
            }
        }
        Iterate {
            velocities: now,
            ends,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::friction::Smooth;

    /// ½ + z/12 for slow decay, 1 − 1/z for fast, and never far from the exponentially fitted
    /// 1/(1 − e^(−z)) − 1/z; each contact by its own rate.
    #[test]
    fn weights_of_the_end_are_those_of_the_decay() {
        for k in 0..160 {
            let z = 10f64.powf(-8.0 + 0.1 * f64::from(k));
            let [weight, other] = end_weights([z, 0.0]);
            assert_eq!([other, weight], end_weights([0.0, z]));
            assert!((other - 0.5).abs() < 1e-15);
            if z < 0.1 {
                let miss = (weight - 0.5 - z / 12.0).abs();
                assert!(miss < 0.02 * z * z + 1e-15, "{z:e}: {miss:e}");
            }
            if z > 30.0 && z < 1e6 {
                let miss = (weight - 1.0 + 1.0 / z).abs();
                assert!(miss < 3.0 / (z * z) + 1e-15, "{z:e}: {miss:e}");
            }
            if z > 1e-3 {
                let fitted = -1.0 / (-z).exp_m1() - 1.0 / z;
                assert!((weight - fitted).abs() < 0.011, "{z:e}: {weight} {fitted}");
            }
        }
    }

    /// A block on a plane that a force pushes in any direction: the end of the step lies on the law, in the
    /// direction of sliding, whatever the mobility.
    #[test]
    fn friction_belongs_to_the_sliding_at_the_end() {
        let law = Friction::Smooth(Smooth {
            coefficient: 0.2,
            inverse_regularisation_speed: 1.0 / 0.02,
        });
        for mobility in [1e-3, 1.0, 1e3] {
            for free in [[3.0, -1.0], [1e-3, 2e-3], [-0.05, 0.01]] {
                let mut places = [SlidingPlace::<2> {
                    rows: Matrix2::identity(),
                    normal_n: 50.0,
                    ..SlidingPlace::default()
                }];
                let step = FrictionStep {
                    law: &law,
                    compliance: Matrix2::identity() * mobility,
                    h_s: 1e-3,
                    is_known: false,
                };
                let free = Vector2::from(free);
                let ends = StepEnds { start: free, free };
                let found = step.solve(&mut places, &ends);
                let slip = found.velocities;
                let [size, _] = law.force(slip.norm(), 50.0);
                let expected = slip * (-size / slip.norm());
                assert!((found.end - expected).norm() < 0.02 * 10.0, "{mobility}");
                let reached = free + found.mean * (1e-3 * mobility);
                assert!((slip - reached).norm() < 1e-12 * free.norm());
                assert!(found.heat > 0.0);
            }
        }
    }
}
