//! A ball between the two flanks of a discrete raceway, whose contact angle yields under load.
//!
//! The flanks at a ball of radius R are circles of radius Re + e about two centres. They lie at
//! g = Re + e − R from the centre of a ball that just touches, h of it along the radius; pressed in
//! by u beyond that the ball has
//!
//!   H = √((h + u)² + g² − h²),   cos α = (h + u)/H,   δ = H − g,   r = R cos α
//!
//! with H the distance to either centre and δ the approach of each flank. Both share the ball as one
//! contact does ([`crate::equilibrium::space::outer_section`] with δ₊ = δ₋), αc the angle of the
//! flanks:
//!
//!   δe = δ/cos αc,   F = max(0, K δe^(3/2) + c √δe dδe/dt),   N = F/(2 cos αc).
//!
//! N is the normal force of each flank; the radial sum is F ∂δe/∂ρ = F cos α/cos αc, which is Zhao
//! 2022, Eq. (19), for u → 0. The force along ψ is −F ∂δe/∂ψ/ρ.

use super::positive;

/// Flanks of a discrete raceway at one ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FlankSection {
    /// g, distance of their centres from that of the ball that just touches, m.
    pub gap: f64,
    /// h, part of it along the radius, m.
    pub height: f64,
    /// cos αc of the nominal ball.
    pub cosine: f64,
}

/// A ball pressed into both flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FlankPress {
    /// δe, m; 0 apart.
    pub deflection: f64,
    /// ∂δe/∂ρ.
    pub lever: f64,
    /// ∂²δe/∂ρ², 1/m.
    pub curvature: f64,
    /// cos α.
    pub cosine: f64,
    /// 1/cos α.
    pub inverse_cosine: f64,
    /// sin² α.
    pub sine_square: f64,
    /// 1/cos αc.
    pub inverse_flank_cosine: f64,
    /// 1/(h + u), 1/m.
    pub inverse_height: f64,
}

impl FlankSection {
    /// The ball at `beyond_m` from where it just touches, outwards positive.
    #[inline(always)]
    pub(crate) fn press(&self, beyond_m: f64) -> FlankPress {
        let (g, h, c) = (self.gap, self.height, self.cosine);
        let u = positive(beyond_m);
        // H² − g², without the cancellation of a difference of lengths.
        let risen = u * (2.0 * h + u);
        let square = g * g + risen;
        let (length, height) = (square.sqrt(), h + u);
        let reach = (length + g) * c;
        // One division for all.
        let inverse = 1.0 / (square * height * reach);
        let inverse_square = inverse * height * reach;
        let inverse_reach = inverse * square * height;
        let inverse_height = inverse * square * reach;
        let inverse_flank_cosine = inverse_reach * (length + g);
        let cosine = height * length * inverse_square;
        // At the ends cos αc of a polynomial may exceed 1 by its rounding.
        let sine_square = positive(g * g - h * h) * inverse_square;
        FlankPress {
            deflection: risen * inverse_reach,
            lever: cosine * inverse_flank_cosine,
            curvature: sine_square * inverse_flank_cosine * length * inverse_square,
            cosine,
            inverse_cosine: length * inverse_height,
            sine_square,
            inverse_flank_cosine,
            inverse_height,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::FlankSection;

    #[test]
    fn a_cosine_above_1_by_rounding_leaves_no_negative_square_of_the_sine() {
        let cosine = 1.0 + 1e-13;
        let (gap, offset) = (0.19e-3_f64, 0.19e-3_f64);
        let height = (gap * gap - offset * offset * (1.0 - cosine * cosine)).sqrt();
        assert!(height > gap);
        let section = FlankSection {
            gap,
            height,
            cosine,
        };
        for beyond_m in [-1e-9, 0.0, 1e-9, 5e-6] {
            let press = section.press(beyond_m);
            assert_eq!(press.sine_square, 0.0);
            assert!((press.lever - 1.0).abs() < 1e-12);
        }
    }
}
