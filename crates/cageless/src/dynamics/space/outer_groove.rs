//! Contact of a ball with the outer ring: the plain groove, or the two flanks of a discrete
//! raceway.
//!
//! Geometry and joined law are those of [`crate::equilibrium::space::outer_section`], here with
//! their rates: δe changes with ψ as well, ∂δe/∂ψ, which makes a force along ψ.

use std::f64::consts::LN_2;

use crate::numerics::chebyshev::Polynomial;
use crate::numerics::lanes::lane_struct;
use crate::raceway::{Piece, Raceway};

/// Flank angle below which the raceway is the plain groove, rad.
const PLAIN_RAD: f64 = 1e-5;

/// A stretch of a discrete raceway as the equations in space use it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FlankModel {
    sin_centre: f64,
    cos_centre: f64,
    /// sin²ψ where it begins and where it ends.
    squares: [f64; 2],
    /// sin²θ.
    end: f64,
    /// n.
    order: f64,
    /// αc/(sin²θ − sin²ψ)ⁿ over sin²ψ, smooth up to the ends.
    angle: Polynomial,
    /// sin αg.
    sin_section: f64,
    /// cos αg.
    cos_section: f64,
    /// Depth milled too much in the middle, m.
    depth_error: f64,
    /// How much deeper a ball in the middle sits than on the plain raceway, m.
    depth: f64,
}

/// The flanks at the ψ of a ball.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlanksHere {
    /// αc.
    angle: f64,
    /// dαc/dψ.
    slope: f64,
    sin_section: f64,
    cos_section: f64,
    /// Depth milled too much, m, and its slope over ψ.
    error: [f64; 2],
    /// How much deeper a ball sits than on the plain raceway, m, and its slope over ψ.
    depth: [f64; 2],
}

impl FlanksHere {
    /// Those of a section that is turned to the other side where the sign is −1.
    #[inline(always)]
    pub fn mirrored(self, contact_sign: f64) -> Self {
        Self {
            sin_section: contact_sign * self.sin_section,
            ..self
        }
    }
}

impl FlankModel {
    pub fn new(raceway: &Raceway, piece: &Piece) -> Self {
        let (sin_centre, cos_centre) = raceway.dimensions().centre_angle_rad.sin_cos();
        let (sin_section, cos_section) = raceway.section_angle_rad().sin_cos();
        let end = raceway.half_angle_rad().sin().powi(2);
        let (order, angle) = piece.angle(end);
        Self {
            sin_centre,
            cos_centre,
            squares: piece.squares(),
            end,
            order,
            angle,
            sin_section,
            cos_section,
            depth_error: raceway.depth_error_m(),
            depth: raceway.form().depth_m,
        }
    }

    /// Sine and cosine of the angle from the middle to the direction **e**.
    #[inline(always)]
    fn sine_and_cosine(&self, [ex, ey]: [f64; 2]) -> [f64; 2] {
        [
            ex * self.cos_centre + ey * self.sin_centre,
            ex * self.sin_centre - ey * self.cos_centre,
        ]
    }

    /// sin²ψ at its end less that of the direction **e**, above 0 before the end.
    pub fn left(&self, direction: [f64; 2]) -> f64 {
        let [sine, cosine] = self.sine_and_cosine(direction);
        self.squares[1] - if cosine > 0.0 { sine * sine } else { 1.0 }
    }

    /// leftⁿ and its derivative.
    #[inline(always)]
    fn power(&self, left: f64) -> [f64; 2] {
        if self.order == 1.0 {
            [left, 1.0]
        } else if self.order == 0.0 {
            [1.0, 0.0]
        } else {
            let power = left.powf(self.order);
            [power, self.order * power / left]
        }
    }

    /// The flanks in the direction **e**; `None` outside.
    #[inline]
    pub fn at(&self, direction: [f64; 2]) -> Option<FlanksHere> {
        let [sine, cosine] = self.sine_and_cosine(direction);
        let square = sine * sine;
        let [begin, end] = self.squares;
        if cosine <= 0.0 || square < begin || square >= end {
            return None;
        }
        let left = self.end - square;
        let [value, rise] = self.angle.value_and_slope(square);
        let turning = 2.0 * sine * cosine;
        let [power, fall] = self.power(left);
        let angle = power * value;
        let share = left / self.end;
        let run_out = |depth: f64| {
            let slope = -2.0 * depth * share / self.end * turning;
            [depth * share * share, slope]
        };
        (angle > PLAIN_RAD).then_some(FlanksHere {
            angle,
            slope: (power * rise - fall * value) * turning,
            sin_section: self.sin_section,
            cos_section: self.cos_section,
            error: run_out(self.depth_error),
            depth: run_out(self.depth),
        })
    }
}

lane_struct! {
    /// Groove constants of one ball.
    pub(crate) struct OuterGroove per lane OuterGrooveLanes {
        /// Re − R of this ball, m.
        gap,
        /// Re − Rw of the nominal ball, m.
        nominal_gap,
        /// zo of the groove's centre, m.
        axial,
    }
}

lane_struct! {
    /// Contact of one ball with the outer ring, at the plain groove or the flank towards +Z and at the
    /// other flank.
    pub(crate) struct OuterTouch per lane OuterTouchLanes {
        /// δe, m; negative: apart.
        approach,
        /// ∂δe/∂ψ, m/rad.
        slope,
        /// Whether the ball is within a discrete raceway: 1 or 0.
        inside,
        /// nρ of the first point.
        radial_0,
        /// nz of the first point.
        axial_0,
        /// Share w of the force of the first point.
        share_0,
        /// Its cube root.
        root_0,
        /// nρ of the second point.
        radial_1,
        /// nz of the second point.
        axial_1,
        /// Share w of the force of the second point.
        share_1,
        /// Its cube root.
        root_1,
    }
}

impl OuterTouch {
    /// nρ, nz, w and its cube root of both points.
    #[inline(always)]
    pub fn points(&self) -> [[f64; 4]; 2] {
        [
            [self.radial_0, self.axial_0, self.share_0, self.root_0],
            [self.radial_1, self.axial_1, self.share_1, self.root_1],
        ]
    }

    /// Σ w nρ and Σ w nz.
    #[inline(always)]
    pub fn resultant(&self) -> [f64; 2] {
        [
            self.share_0 * self.radial_0 + self.share_1 * self.radial_1,
            self.share_0 * self.axial_0 + self.share_1 * self.axial_1,
        ]
    }
}

/// Approach and normal of a ball at **d** from the centre of a groove of which it may be this far off.
#[inline(always)]
fn approach([radial, axial]: [f64; 2], radius: f64) -> (f64, [f64; 2]) {
    let length = (radial * radial + axial * axial).sqrt();
    // Near the centre there is no direction.
    let near = length < 0.5 * radius;
    (
        if near { -radius } else { length - radius },
        [
            if near { 1.0 } else { radial / length },
            if near { 0.0 } else { axial / length },
        ],
    )
}

impl OuterGroove {
    /// Contact of a ball `beyond` the place at which it touches the plain groove in its middle and
    /// at z, outside the discrete raceways.
    #[inline(always)]
    pub fn touch(&self, beyond: f64, z: f64) -> OuterTouch {
        let (approach, [radial_0, axial_0]) =
            approach([beyond + self.gap, z - self.axial], self.gap);
        OuterTouch {
            approach,
            radial_0,
            axial_0,
            share_0: 1.0,
            root_0: 1.0,
            ..OuterTouch::default()
        }
    }

    /// Contact of such a ball within a discrete raceway.
    pub fn touch_flanks(&self, beyond: f64, z: f64, here: &FlanksHere) -> OuterTouch {
        let plain = [beyond + self.gap, z - self.axial];
        let (sin, cos) = here.angle.sin_cos();
        let g = self.nominal_gap;
        let [error, error_slope] = here.error;
        let [depth, depth_slope] = here.depth;
        let mut delta = [0.0; 2];
        let mut slopes = [0.0; 2];
        let mut normals = [[0.0; 2]; 2];
        for (k, sign) in [1.0, -1.0].into_iter().enumerate() {
            let cos_flank = here.cos_section * cos - sign * here.sin_section * sin;
            let sin_flank = here.sin_section * cos + sign * here.cos_section * sin;
            let d = [
                plain[0] + g * (cos_flank - here.cos_section) - depth * here.cos_section,
                plain[1] + g * (sin_flank - here.sin_section) - depth * here.sin_section,
            ];
            (delta[k], normals[k]) = approach(d, self.gap + error);
            let normal = normals[k];
            slopes[k] = -sign * g * here.slope * (normal[0] * sin_flank - normal[1] * cos_flank)
                - error_slope
                - depth_slope * (normal[0] * here.cos_section + normal[1] * here.sin_section);
        }
        let touch = |approach: f64, slope: f64, shares: [f64; 2]| OuterTouch {
            approach,
            slope,
            inside: 1.0,
            radial_0: normals[0][0],
            axial_0: normals[0][1],
            share_0: shares[0],
            root_0: shares[0].cbrt(),
            radial_1: normals[1][0],
            axial_1: normals[1][1],
            share_1: shares[1],
            root_1: shares[1].cbrt(),
        };
        let (most, least) = if delta[0] >= delta[1] { (0, 1) } else { (1, 0) };
        let mut shares = [0.0; 2];
        if delta[least] <= 0.0 || delta[least] < 1e-60 * delta[most] {
            shares[most] = 1.0;
            return touch(delta[most], slopes[most], shares);
        }
        // s = ln 2/(−ln cos αc).
        let inverse = -cos.ln() / LN_2;
        let exponent = 1.0 / inverse;
        let log = (delta[least] / delta[most]).ln();
        let power = (log * exponent).exp();
        let joined = power.ln_1p();
        let effective = delta[most] * (joined * inverse).exp();
        shares[most] = (-(1.0 - inverse) * joined).exp();
        shares[least] = shares[most] * ((exponent - 1.0) * log).exp();
        let by_exponent = effective * inverse * (power / (1.0 + power) * log - joined * inverse);
        let exponent_slope = -exponent * exponent * (sin / cos) * here.slope / LN_2;
        let slope = shares[0] * slopes[0] + shares[1] * slopes[1] + by_exponent * exponent_slope;
        touch(effective, slope, shares)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::structure;
    use crate::equilibrium::space::outer_section::{Flanks, OuterSection};
    use crate::numerics::taylor::Taylor;

    fn direction(psi: f64) -> [f64; 2] {
        [psi.sin(), -psi.cos()]
    }

    /// Over the whole raceway, on one flank and on both: approach and shares are those of the section
    /// in equilibrium, the normals its gradient, the slope the derivative over ψ.
    #[test]
    fn contacts_are_those_of_the_section() {
        let case = structure(5.1, 25.2);
        for (turned, error, depth) in [
            (0.0, 0.0, 0.0),
            (0.1, 0.0, 0.0),
            (0.0, 2e-6, 0.0),
            (0.1, 1e-6, 3e-6),
        ] {
            let raceway = case.raceways[0].clone().with_depth_error(error).unwrap();
            let raceway = raceway.with_depth(depth).unwrap();
            let raceway = raceway.with_section_angle(turned, &case.bearing).unwrap();
            let model = FlankModel::new(&raceway, &raceway.pieces()[0]);
            let d = case.bearing.dimensions();
            let gap = d.outer_groove_curvature_radius_m - d.ball_radius_m;
            let groove = OuterGroove {
                gap,
                nominal_gap: gap,
                axial: 0.0,
            };
            for psi in [-0.43, -0.3, 0.02, 0.2, 0.4395] {
                let [flank, slope] = raceway.contact_angle_rad(psi);
                for place in [[6e-6, 0.0], [6e-6, 3e-6], [8e-6, -30e-6], [5e-6, 80e-6]] {
                    let at = |psi: f64, place: [f64; 2]| match model.at(direction(psi)) {
                        Some(here) => groove.touch_flanks(place[0], place[1], &here),
                        None => groove.touch(place[0], place[1]),
                    };
                    let touch = at(psi, place);
                    let section = OuterSection {
                        gap_m: gap,
                        axial_m: 0.0,
                        flanks: Some(Flanks {
                            angle_rad: flank,
                            section_angle_rad: turned,
                            nominal_gap_m: gap,
                            depth_error_m: raceway.depth_error_at_m(psi),
                            depth_m: raceway.depth_at_m(psi)[0],
                        }),
                    };
                    let [u, z, angle] = Taylor::variables([place[0], place[1], flank]);
                    let Some(exact) = section.approach([u, z], angle) else {
                        assert!(touch.approach <= 0.0);
                        continue;
                    };
                    assert!(
                        (touch.approach - exact.value).abs() < 1e-15,
                        "{psi} {place:?}"
                    );
                    for axis in 0..2 {
                        let found = touch.resultant()[axis];
                        assert!(
                            (found - exact.gradient[axis]).abs() < 1e-9,
                            "{psi} {place:?}"
                        );
                    }
                    let h = 1e-6;
                    let across =
                        (at(psi + h, place).approach - at(psi - h, place).approach) / (2.0 * h);
                    assert!(
                        (touch.slope - across).abs() < 1e-9,
                        "{psi} {place:?} {} {across}",
                        touch.slope
                    );
                    if [error, depth] == [0.0; 2] {
                        assert!((touch.slope - exact.gradient[2] * slope).abs() < 1e-12);
                    }
                }
            }
        }
    }
}
