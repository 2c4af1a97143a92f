//! Section of the outer raceway at a ball: one groove, or the two flanks of a discrete raceway.
//!
//! A groove is a circle of radius Re about a centre; a ball at (ρ, ζ) is pressed in by
//! δ = |d| − (Re − R) along **n** = d/|d| with d from that centre. The flanks of a discrete
//! raceway at the angle αc, turned by αg, have their centres at
//!
//!   C± = B − g (cos(αg ± αc), sin(αg ± αc)),   B = (Po + g cos αg, zo + g sin αg),   g = Re − Rw,
//!
//! B where the nominal ball rests. Both share a ball as one contact does,
//!
//!   δe = (δ₊ˢ + δ₋ˢ)^(1/s) (positive parts),   s = ln 2/(−ln cos αc):
//!
//! δ on one flank, δo of Zhao 2022, Eq. (19), where both are pressed in by δo cos αc. Edges of a slot
//! have their own s and the curvature κg of the line that a ball's centre follows along an edge,
//! 1/g at the groove. With **x** from B and **n**c = −(**C** − **B**)/g,
//!
//!   δ = (2 **x**·**n**c + κg x²)/(1 + √q) + R − Rw,   q = |**n**c + κg **x**|²,   **n** = (**n**c + κg **x**)/√q.

use std::f64::consts::LN_2;

use crate::numerics::taylor::Taylor;
use crate::numerics::vector::SectionVector;
use crate::raceway::SlotSection;

/// Flank angle below which the raceway is the plain groove, rad.
const PLAIN_RAD: f64 = 1e-5;
/// Share of one flank in the approach below which it does not touch.
const OPEN: f64 = 1e-60;

/// Two flanks at the ψ of a ball.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flanks {
    /// αc.
    pub angle_rad: f64,
    /// αg.
    pub section_angle_rad: f64,
    /// g = Re − Rw of the nominal ball.
    pub nominal_gap_m: f64,
    /// Depth milled too much along the normals.
    pub depth_error_m: f64,
    /// How much deeper the ball sits than on the plain raceway, along αg.
    pub depth_m: f64,
    /// The edges of a slot, whose sink is the depth.
    pub slot: Option<SlotSection>,
}

/// Section at a ball.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OuterSection {
    /// Re − R of this ball.
    pub gap_m: f64,
    /// zo, of the groove's centre.
    pub axial_m: f64,
    /// Flanks; none outside the raceways.
    pub flanks: Option<Flanks>,
}

/// One contact of a section with a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SectionContact {
    /// Angle of **n** from the radius towards +Z.
    pub angle_rad: f64,
    /// Share w of the contact in the force K δe^(3/2).
    pub share: f64,
}

impl OuterSection {
    /// d and the radius |d| at which the ball touches, of the groove or of flank `sign`; u is ρ less
    /// that of a ball that touches the plain groove in its middle.
    fn relative_to_centre<const N: usize>(
        &self,
        place: SectionVector<Taylor<N>>,
        flank: Option<(&Flanks, Taylor<N>, f64)>,
    ) -> (SectionVector<Taylor<N>>, f64) {
        let d = SectionVector {
            radial: place.radial + self.gap_m,
            axial: place.axial + -self.axial_m,
        };
        let Some((flanks, angle, sign)) = flank else {
            return (d, self.gap_m);
        };
        let g = flanks.nominal_gap_m;
        let (sin, cos) = (angle * sign + flanks.section_angle_rad).sin_cos();
        let (sin_g, cos_g) = flanks.section_angle_rad.sin_cos();
        let back = g + flanks.depth_m;
        let d = SectionVector {
            radial: d.radial + cos * g + -back * cos_g,
            axial: d.axial + sin * g + -back * sin_g,
        };
        (d, self.gap_m + flanks.depth_error_m)
    }

    /// δ of the groove or of a flank, and a vector along its **n**; `None` where it is open.
    fn touch<const N: usize>(
        &self,
        place: SectionVector<Taylor<N>>,
        flank: Option<(&Flanks, Taylor<N>, f64)>,
    ) -> Option<(Taylor<N>, SectionVector<Taylor<N>>)> {
        if let Some((flanks, angle, sign)) = flank
            && let Some(slot) = &flanks.slot
        {
            return self.touch_edge(place, flanks, slot, angle * sign);
        }
        let (d, radius) = self.relative_to_centre(place, flank);
        let SectionVector { radial, axial } = d;
        let delta = radial.hypot(axial) + -radius;
        // The inner half of the circle is no groove.
        (radial.value > 0.0 && delta.value > 0.0).then_some((delta, d))
    }

    /// δ of an edge of a slot, and a vector along its **n**; `None` where it is open.
    fn touch_edge<const N: usize>(
        &self,
        place: SectionVector<Taylor<N>>,
        flanks: &Flanks,
        slot: &SlotSection,
        angle: Taylor<N>,
    ) -> Option<(Taylor<N>, SectionVector<Taylor<N>>)> {
        let g = flanks.nominal_gap_m;
        let (sin_g, cos_g) = flanks.section_angle_rad.sin_cos();
        let back = g + flanks.depth_m;
        let x = SectionVector {
            radial: place.radial + (self.gap_m - back * cos_g),
            axial: place.axial + -(self.axial_m + back * sin_g),
        };
        let (sin, cos) = (angle + flanks.section_angle_rad).sin_cos();
        let [curvature, _] = slot.centre_curvature_per_m;
        let along = x.radial * cos + x.axial * sin;
        let bent = (x.radial * x.radial + x.axial * x.axial) * curvature;
        let q = (along * 2.0 + bent) * curvature + 1.0;
        // Near the centre there is no direction.
        if q.value < 0.25 {
            return None;
        }
        let larger = g - self.gap_m - flanks.depth_error_m;
        let delta = (along * 2.0 + bent) * (q.sqrt() + 1.0).recip() + larger;
        let direction = SectionVector {
            radial: cos + x.radial * curvature,
            axial: sin + x.axial * curvature,
        };
        (delta.value > 0.0).then_some((delta, direction))
    }

    /// δe of a ball at (u, ζ); `None` where nothing touches. `flank_angle` is αc, which may
    /// be a function of ψ.
    pub(crate) fn approach<const N: usize>(
        &self,
        place: SectionVector<Taylor<N>>,
        flank_angle: Taylor<N>,
    ) -> Option<Taylor<N>> {
        let approach = |flank| self.touch(place, flank).map(|(delta, _)| delta);
        let Some(flanks) = self
            .flanks
            .as_ref()
            .filter(|_| flank_angle.value > PLAIN_RAD)
        else {
            return approach(None);
        };
        let [one, other] = [1.0, -1.0].map(|sign| approach(Some((flanks, flank_angle, sign))));
        let (one, other) = match (one, other) {
            (Some(one), Some(other)) if one.value >= other.value => (one, other),
            (Some(one), Some(other)) => (other, one),
            (one, other) => return one.or(other),
        };
        if other.value < OPEN * one.value {
            return Some(one);
        }
        let inverse = match &flanks.slot {
            Some(slot) => Taylor::constant(slot.inverse_exponent[0]),
            None => flank_angle.sin_cos().1.ln() * (-1.0 / LN_2),
        };
        let ratio = other * one.recip();
        let power = (ratio.ln() * inverse.recip()).exp();
        Some(one * (power.ln_1p() * inverse).exp())
    }

    /// Contacts at a ball at (u, ζ): one, or both flanks, the one towards +Z first.
    pub(crate) fn contacts(&self, place: SectionVector) -> Vec<SectionContact> {
        let place = place.map(Taylor::<0>::constant);
        let touching = |flank| {
            let (delta, n): (Taylor<0>, _) = self.touch(place, flank)?;
            Some((delta.value, n.axial.value.atan2(n.radial.value)))
        };
        let flanks = self.flanks.as_ref().filter(|f| f.angle_rad > PLAIN_RAD);
        let Some(flanks) = flanks else {
            let one = touching(None).map(|(_, angle_rad)| SectionContact {
                angle_rad,
                share: 1.0,
            });
            return one.into_iter().collect();
        };
        let angle = Taylor::constant(flanks.angle_rad);
        let both = [1.0, -1.0].map(|sign| touching(Some((flanks, angle, sign))));
        let s = match &flanks.slot {
            Some(slot) => 1.0 / slot.inverse_exponent[0],
            None => LN_2 / -flanks.angle_rad.cos().ln(),
        };
        let joined = self.approach(place, angle).map_or(0.0, |d| d.value);
        both.into_iter()
            .flatten()
            .map(|(delta, angle_rad)| SectionContact {
                angle_rad,
                share: (delta / joined).powf(s - 1.0),
            })
            .collect()
    }
}
