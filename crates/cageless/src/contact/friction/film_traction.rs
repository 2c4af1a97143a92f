//! Traction of a film that carries a contact together with asperities.
//!
//! The film is sheared by F = A τ arsinh(g ΔV/(A τ)) (Eyring) up to its limit μN, and asperities carry the share φ of
//! the load: with the law of the case, f, as their friction
//!
//!   φ f(ΔV) + (1 − φ) F/√(1 + (F/μN)²).

use crate::numerics::exponential::arsinh_and_root;
use crate::numerics::lanes::lane_struct;

/// (S κ)² below which a film is linear to 1e-11.
const LINEAR: f64 = 1e-10;

lane_struct! {
    /// Film of a contact, or of two alike, as its friction over ΔV has it.
    pub(crate) struct FilmTraction per lane FilmTractionLanes {
        /// φ.
        asperity_share,
        /// (1 − φ) μN of all contacts, N.
        limit,
        /// A τ/(μN).
        stress_ratio,
        /// g/(A τ), s/m.
        inverse_speed,
    }
}

impl FilmTraction {
    /// Friction and its slope, N·s/m, of asperities that alone would have these.
    #[inline(always)]
    pub(crate) fn mixed(&self, [force, slope]: [f64; 2], sliding_m_s: f64) -> [f64; 2] {
        let [sheared, root] = arsinh_and_root(sliding_m_s * self.inverse_speed);
        let over = self.stress_ratio * sheared;
        let capped = (1.0 + over * over).sqrt();
        // One division for both.
        let inverse = 1.0 / (root * capped);
        let uncapped = inverse * root;
        let steepest = self.limit * self.stress_ratio * self.inverse_speed;
        [
            self.asperity_share * force + self.limit * over * uncapped,
            self.asperity_share * slope + (steepest * inverse) * (uncapped * uncapped),
        ]
    }

    /// F/S and F′ − F/S of the film alone, sheared at S of this square, N·s/m.
    #[inline(always)]
    pub(crate) fn secant(&self, speed_square: f64) -> [f64; 2] {
        if speed_square * self.inverse_speed * self.inverse_speed < LINEAR {
            return [self.limit * self.stress_ratio * self.inverse_speed, 0.0];
        }
        let speed = speed_square.sqrt();
        let [film, steepness] = self.mixed([0.0; 2], speed);
        let secant = film / speed;
        [secant, steepness - secant]
    }

    /// [`Self::mixed`] of a contact that spins as well: the film is sheared at S² = ΔV² + w², w² `spin_square`, and its
    /// part along ΔV is F(S) ΔV/S.
    #[inline(always)]
    pub(crate) fn mixed_spinning(
        &self,
        [force, slope]: [f64; 2],
        sliding_m_s: f64,
        spin_square: f64,
    ) -> [f64; 2] {
        let square = sliding_m_s * sliding_m_s;
        let sum = square + spin_square;
        if sum * self.inverse_speed * self.inverse_speed < LINEAR {
            return self.mixed([force, slope], sliding_m_s);
        }
        let ([secant, more], share) = (self.secant(sum), square / sum);
        [
            self.asperity_share * force + secant * sliding_m_s,
            self.asperity_share * slope + secant + more * share,
        ]
    }
}
