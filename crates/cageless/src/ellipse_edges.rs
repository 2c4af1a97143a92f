//! How far contact ellipses reach towards the shoulders of their grooves.

use crate::dynamics::BallContacts;

/// Largest |α| + a/R of the contacts of a motion in space at inner and outer ring.
#[derive(Debug, Clone, Default)]
pub(crate) struct EllipseEdges {
    /// The largest so far and its sine: inner, outer.
    largest: [[f64; 2]; 2],
}

impl EllipseEdges {
    /// Takes the contacts of a ball of this radius.
    #[inline]
    pub(crate) fn look(&mut self, radius_m: f64, ball: &BallContacts) {
        for (ring, point) in ball.bearing_points() {
            let [cosine, sine] = [point.normal[0], point.normal[1].abs()];
            let half = point.half_length_m / radius_m;
            // sin(|α| + a/R) but for (a/R)³/6: an angle only of what is larger.
            let rank = sine * (1.0 - 0.5 * half * half) + cosine * half;
            if rank > self.largest[ring][1] {
                self.largest[ring] = [sine.atan2(cosine) + half, rank];
            }
        }
    }

    /// The largest so far; 0 without contacts.
    pub(crate) fn largest_rad(&self) -> [f64; 2] {
        self.largest.map(|[angle, _]| angle)
    }
}
