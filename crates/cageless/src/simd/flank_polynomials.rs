//! Polynomials of elastic flanks, those of one ball side by side.

use crate::contact::RacewayValues;
use crate::dynamics::model::RacewayModel;

/// The polynomials of one raceway that a ball on its flanks needs: rows of an even and the next odd coefficient
/// each of r, dr/du and the ellipse.
#[derive(Clone)]
pub(super) struct FlankPolynomials(Vec<[[f64; 2]; 3]>);

impl FlankPolynomials {
    /// Polynomials of a raceway.
    pub(super) fn new(raceway: Option<&RacewayModel>) -> Self {
        let polynomials = raceway.map_or([&[][..]; 3], |r| {
            [&r.radius[..], &r.radius_slope, &r.ellipse]
        });
        let length = polynomials.iter().map(|p| p.len()).max().unwrap_or(0);
        let row = |k: usize| {
            polynomials.map(|polynomial| {
                [2 * k, 2 * k + 1].map(|place| polynomial.get(place).copied().unwrap_or(0.0))
            })
        };
        Self((0..length.div_ceil(2)).map(row).collect())
    }

    /// The values at u; r has the bits of that of rigid flanks.
    #[inline(always)]
    pub(super) fn values(&self, u: f64) -> RacewayValues {
        let square = u * u;
        let mut sums = [[0.0; 2]; 3];
        for row in self.0.iter().rev() {
            for j in 0..3 {
                for half in 0..2 {
                    sums[j][half] = sums[j][half] * square + row[j][half];
                }
            }
        }
        let whole = |halves: [f64; 2]| halves[0] + halves[1] * u;
        let [radius, radius_slope, ellipse] = sums;
        RacewayValues {
            radius: whole(radius),
            radius_slope: whole(radius_slope),
            ellipse: whole(ellipse),
        }
    }
}
