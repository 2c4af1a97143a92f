//! Contact of a ball with the outer ring: the plain groove, or the two flanks of a discrete
//! raceway.
//!
//! Geometry and joined law are those of [`crate::equilibrium::space::outer_section`], here with
//! their rates: δe changes with ψ as well, ∂δe/∂ψ, which makes a force along ψ.

use std::f64::consts::LN_2;

use crate::numerics::chebyshev::Polynomial;
use crate::numerics::lanes::{Lanes, lane_struct};
use crate::numerics::vector::{PlaneVector, SectionVector};
use crate::raceway::{Piece, Raceway, Slot, SlotSection};

/// Flank angle below which the raceway is the plain groove, rad.
const PLAIN_RAD: f64 = 1e-8;

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
    /// The slot, if the raceway is one: all but the error follows from it.
    slot: Option<Slot>,
    /// Number of the raceway, from 0.
    number: usize,
}

/// Angle from the middle of a raceway, by its sine and cosine.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LocalAngle {
    sine: f64,
    cosine: f64,
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
    /// The edges of a slot.
    slot: Option<SlotSection>,
    /// Number of the raceway, from 0.
    number: usize,
}

impl FlanksHere {
    /// Direction of the section.
    #[inline(always)]
    fn section(&self) -> SectionVector {
        SectionVector {
            radial: self.cos_section,
            axial: self.sin_section,
        }
    }
}

impl FlankModel {
    pub(crate) fn new(raceway: &Raceway, number: usize, piece: &Piece) -> Self {
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
            slot: raceway.slot().cloned(),
            number,
        }
    }

    /// Angle from the middle to the direction **e**.
    #[inline(always)]
    fn local(&self, e: PlaneVector) -> LocalAngle {
        LocalAngle {
            sine: e.x * self.cos_centre + e.y * self.sin_centre,
            cosine: e.x * self.sin_centre - e.y * self.cos_centre,
        }
    }

    /// sin²ψ at its end less that of the direction **e**, above 0 before the end.
    pub(crate) fn left(&self, e: PlaneVector) -> f64 {
        let LocalAngle { sine, cosine } = self.local(e);
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

    /// Angle from the middle to the direction **e**; `None` outside.
    #[inline(always)]
    pub(crate) fn within(&self, e: PlaneVector) -> Option<LocalAngle> {
        let angle = self.local(e);
        let square = angle.sine * angle.sine;
        let [begin, end] = self.squares;
        (angle.cosine > 0.0 && square >= begin && square < end).then_some(angle)
    }

    /// The flanks at an angle [`Self::within`]; those of a section that is turned to the other side
    /// where the sign is −1; `None` where they are the plain groove.
    pub(crate) fn at(&self, angle: LocalAngle, contact_sign: f64) -> Option<FlanksHere> {
        let LocalAngle { sine, cosine } = angle;
        let square = sine * sine;
        let left = self.end - square;
        let turning = 2.0 * sine * cosine;
        let slot = self.slot.as_ref().map(|slot| slot.at(sine.asin()));
        let [angle, slope] = match &slot {
            Some(slot) => slot.angle_rad,
            None => {
                let [value, rise] = self.angle.value_and_slope(square);
                let [power, fall] = self.power(left);
                [power * value, (power * rise - fall * value) * turning]
            }
        };
        let share = left / self.end;
        let run_out = |depth: f64| {
            let slope = -2.0 * depth * share / self.end * turning;
            [depth * share * share, slope]
        };
        (angle > PLAIN_RAD).then_some(FlanksHere {
            angle,
            slope,
            sin_section: contact_sign * self.sin_section,
            cos_section: self.cos_section,
            error: run_out(self.depth_error),
            depth: slot.map_or_else(|| run_out(self.depth), |slot| slot.sink_m),
            slot,
            number: self.number,
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
        /// Cube root of the share of the first point.
        root_0,
        /// nρ of the second point.
        radial_1,
        /// nz of the second point.
        axial_1,
        /// Share w of the force of the second point.
        share_1,
        /// Cube root of the share of the second point.
        root_1,
        /// K over that of the plain groove.
        stiffness,
        /// Slope of the stiffness ratio over ψ, 1/rad.
        stiffening,
        /// a/√δ over that of the plain groove, a the semi-axis across it.
        half_length,
        /// Curvature of the ring across the groove less that of the plain one, 1/m.
        curvature_change,
        /// Number of the slot on whose edges the ball is, from 1; 0 elsewhere.
        slot,
        /// σ of these edges.
        merged,
    }
}

/// Point at which a ball bears on the outer ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OuterPoint {
    /// **n**.
    pub normal: SectionVector,
    /// Share w of the force.
    pub share: f64,
}

impl OuterTouch {
    /// Both points.
    #[inline(always)]
    pub(crate) fn points(&self) -> [OuterPoint; 2] {
        [
            OuterPoint {
                normal: SectionVector {
                    radial: self.radial_0,
                    axial: self.axial_0,
                },
                share: self.share_0,
            },
            OuterPoint {
                normal: SectionVector {
                    radial: self.radial_1,
                    axial: self.axial_1,
                },
                share: self.share_1,
            },
        ]
    }

    /// Σ w **n**.
    #[inline(always)]
    pub(crate) fn resultant(&self) -> SectionVector {
        SectionVector {
            radial: self.share_0 * self.radial_0 + self.share_1 * self.radial_1,
            axial: self.share_0 * self.axial_0 + self.share_1 * self.axial_1,
        }
    }
}

/// [`OuterPoint`] of each lane, with the cube roots of the shares.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OuterPointLanes<'a> {
    /// nρ.
    pub radial: &'a Lanes,
    /// nz.
    pub axial: &'a Lanes,
    /// w.
    pub share: &'a Lanes,
    /// ∛w.
    pub root: &'a Lanes,
}

impl OuterTouchLanes {
    /// Both points.
    #[inline(always)]
    pub(crate) fn points(&self) -> [OuterPointLanes<'_>; 2] {
        [
            OuterPointLanes {
                radial: &self.radial_0,
                axial: &self.axial_0,
                share: &self.share_0,
                root: &self.root_0,
            },
            OuterPointLanes {
                radial: &self.radial_1,
                axial: &self.axial_1,
                share: &self.share_1,
                root: &self.root_1,
            },
        ]
    }
}

/// Approach of a ball to one flank or edge.
#[derive(Debug, Clone, Copy)]
struct Approach {
    /// δ, m.
    depth: f64,
    /// **n**.
    normal: SectionVector,
}

impl Approach {
    /// Before the first evaluation.
    const NONE: Self = Self {
        depth: 0.0,
        normal: SectionVector {
            radial: 0.0,
            axial: 0.0,
        },
    };

    /// Approach of a ball at **d** from the centre of a groove, with contact from the distance `radius` on.
    #[inline(always)]
    fn to_groove(d: SectionVector, radius: f64) -> Self {
        let length = d.length();
        // Near the centre there is no direction.
        let near = length < 0.5 * radius;
        Self {
            depth: if near { -radius } else { length - radius },
            normal: SectionVector {
                radial: if near { 1.0 } else { d.radial / length },
                axial: if near { 0.0 } else { d.axial / length },
            },
        }
    }

    /// Approach to one edge of a slot, with the normal **n**c, of a nominal ball at **x** from its place on both edges;
    /// its slope over ψ with **x** held.
    #[inline(always)]
    fn to_edge(x: SectionVector, nc: SectionVector, slot: &SlotSection, sign: f64) -> (Self, f64) {
        let [curvature, bending] = slot.centre_curvature_per_m;
        let (along, square) = (x.dot(nc), x.dot(x));
        let q = 1.0 + curvature * (2.0 * along + curvature * square);
        // Near the centre there is no direction.
        if q < 0.25 {
            let apart = Self {
                depth: f64::NEG_INFINITY,
                normal: SectionVector {
                    radial: 1.0,
                    axial: 0.0,
                },
            };
            return (apart, 0.0);
        }
        let root = q.sqrt();
        let depth = (2.0 * along + curvature * square) / (1.0 + root);
        let normal = SectionVector {
            radial: nc.radial / root + curvature * x.radial / root,
            axial: nc.axial / root + curvature * x.axial / root,
        };
        let turning = sign * slot.angle_rad[1] * (x.axial * nc.radial - x.radial * nc.axial);
        let slope = (turning + 0.5 * bending * (square - depth * depth)) / root;
        (Self { depth, normal }, slope)
    }
}

impl OuterGroove {
    /// **d** from the centre of the plain groove.
    #[inline(always)]
    fn beyond_centre(&self, beyond: f64, z: f64) -> SectionVector {
        SectionVector {
            radial: beyond + self.gap,
            axial: z - self.axial,
        }
    }

    /// Contact of a ball `beyond` the place at which it touches the plain groove in its middle and
    /// at z, outside the discrete raceways.
    #[inline(always)]
    pub(crate) fn touch(&self, beyond: f64, z: f64) -> OuterTouch {
        let Approach { depth, normal } =
            Approach::to_groove(self.beyond_centre(beyond, z), self.gap);
        OuterTouch {
            approach: depth,
            radial_0: normal.radial,
            axial_0: normal.axial,
            share_0: 1.0,
            root_0: 1.0,
            stiffness: 1.0,
            half_length: 1.0,
            ..OuterTouch::default()
        }
    }

    /// Approach to one of the flanks and its slope over ψ, of a ball at this place from the centre of the plain groove;
    /// **n**c that of the flank.
    #[inline(always)]
    fn flank(
        &self,
        place: SectionVector,
        here: &FlanksHere,
        nc: SectionVector,
        sign: f64,
    ) -> (Approach, f64) {
        let (section, g) = (here.section(), self.nominal_gap);
        let [error, error_slope] = here.error;
        let [depth, depth_slope] = here.depth;
        let (approach, turned) = if let Some(slot) = &here.slot {
            let x = SectionVector {
                radial: place.radial - (g + depth) * section.radial,
                axial: place.axial - (g + depth) * section.axial,
            };
            let (edge, slope) = Approach::to_edge(x, nc, slot, sign);
            let larger = g - self.gap - error;
            let depth = edge.depth + larger;
            (Approach { depth, ..edge }, slope)
        } else {
            let d = SectionVector {
                radial: place.radial + g * (nc.radial - section.radial) - depth * section.radial,
                axial: place.axial + g * (nc.axial - section.axial) - depth * section.axial,
            };
            let groove = Approach::to_groove(d, self.gap + error);
            let normal = groove.normal;
            let across = normal.radial * nc.axial - normal.axial * nc.radial;
            (groove, -sign * g * here.slope * across)
        };
        let sunk = depth_slope * approach.normal.dot(section);
        (approach, turned - error_slope - sunk)
    }

    /// Contact of such a ball within a discrete raceway.
    pub(crate) fn touch_flanks(&self, beyond: f64, z: f64, here: &FlanksHere) -> OuterTouch {
        let (place, section) = (self.beyond_centre(beyond, z), here.section());
        let (sin, cos) = here.angle.sin_cos();
        let mut flanks = [Approach::NONE; 2];
        let mut slopes = [0.0; 2];
        for (k, sign) in [1.0, -1.0].into_iter().enumerate() {
            let nc = SectionVector {
                radial: section.radial * cos - sign * section.axial * sin,
                axial: section.axial * cos + sign * section.radial * sin,
            };
            (flanks[k], slopes[k]) = self.flank(place, here, nc, sign);
        }
        let delta = flanks.map(|flank| flank.depth);
        let touch = |approach: f64, slope: f64, shares: [f64; 2], roots: [f64; 2]| OuterTouch {
            approach,
            slope,
            inside: 1.0,
            radial_0: flanks[0].normal.radial,
            axial_0: flanks[0].normal.axial,
            share_0: shares[0],
            root_0: roots[0],
            radial_1: flanks[1].normal.radial,
            axial_1: flanks[1].normal.axial,
            share_1: shares[1],
            root_1: roots[1],
            stiffness: here.slot.map_or(1.0, |slot| slot.stiffness_ratio[0]),
            stiffening: here.slot.map_or(0.0, |slot| slot.stiffness_ratio[1]),
            half_length: here.slot.map_or(1.0, |slot| slot.half_length_ratio),
            curvature_change: here.slot.map_or(0.0, |slot| slot.curvature_change_per_m),
            slot: here.slot.map_or(0.0, |_| (here.number + 1) as f64),
            merged: here.slot.map_or(0.0, |slot| slot.merged),
        };
        let (most, least) = if delta[0] >= delta[1] { (0, 1) } else { (1, 0) };
        let mut shares = [0.0; 2];
        if delta[least] <= 0.0 || delta[least] < 1e-60 * delta[most] {
            shares[most] = 1.0;
            return touch(delta[most], slopes[most], shares, shares);
        }
        // s = ln 2/(−ln cos αc).
        let inverse = match &here.slot {
            Some(slot) => slot.inverse_exponent[0],
            None => -0.5 * (-sin * sin).ln_1p() / LN_2,
        };
        let exponent = 1.0 / inverse;
        let log = (delta[least] / delta[most]).ln();
        let power = (log * exponent).exp();
        let joined = power.ln_1p();
        let effective = delta[most] * (joined * inverse).exp();
        // Shares and cube roots from the same logarithms.
        let logs = [
            -(1.0 - inverse) * joined,
            -(1.0 - inverse) * joined + (exponent - 1.0) * log,
        ];
        let mut roots = [0.0; 2];
        for (at, log) in [most, least].into_iter().zip(logs) {
            (shares[at], roots[at]) = (log.exp(), (log / 3.0).exp());
        }
        let by_exponent = effective * inverse * (power / (1.0 + power) * log - joined * inverse);
        let exponent_slope = match &here.slot {
            Some(slot) => -exponent * exponent * slot.inverse_exponent[1],
            None => -exponent * exponent * (sin / cos) * here.slope / LN_2,
        };
        let slope = shares[0] * slopes[0] + shares[1] * slopes[1] + by_exponent * exponent_slope;
        touch(effective, slope, shares, roots)
    }
}

#[cfg(test)]
mod tests;
