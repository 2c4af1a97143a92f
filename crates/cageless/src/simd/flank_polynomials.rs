//! Polynomials of elastic flanks, those of one ball side by side.

use crate::contact::RacewayValues;
use crate::dynamics::model::RacewayModel;

/// The polynomials of one raceway that a ball on its flanks needs: rows of two coefficients each of r,
/// dr/du and the ellipse.
#[derive(Clone)]
pub(super) struct FlankPolynomials(Vec<[f64; 6]>);

impl FlankPolynomials {
    /// Those of a raceway.
    pub(super) fn new(raceway: Option<&RacewayModel>) -> Self {
        let polynomials = raceway.map_or([&[][..]; 3], |r| {
            [&r.radius[..], &r.radius_slope, &r.ellipse]
        });
        let length = polynomials.iter().map(|p| p.len()).max().unwrap_or(0);
        let row = |k: usize| {
            std::array::from_fn(|j| {
                let coefficient = polynomials[j / 2].get(2 * k + j % 2);
                coefficient.copied().unwrap_or(0.0)
            })
        };
        Self((0..length.div_ceil(2)).map(row).collect())
    }

    /// The values at u; r has the bits of that of rigid flanks.
    #[inline(always)]
    pub(super) fn values(&self, u: f64) -> RacewayValues {
        let square = u * u;
        let mut sums = [0.0; 6];
        for row in self.0.iter().rev() {
            for j in 0..6 {
                sums[j] = sums[j] * square + row[j];
            }
        }
        RacewayValues {
            radius: sums[0] + sums[1] * u,
            radius_slope: sums[2] + sums[3] * u,
            ellipse: sums[4] + sums[5] * u,
        }
    }
}
