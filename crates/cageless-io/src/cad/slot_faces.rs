//! The faces of a slot: rounded edges, walls and floor.

use std::f64::consts::{FRAC_PI_2, PI};

use cageless::numerics::cross;
use cageless::surface::{Edge, EdgePlace, PatchError, Recess, Side};

use super::brep::{Curve, Solid, Surface, Use, along, back, circle, radial, row};

/// Where an end meets the straight edge of a side, or the other end.
#[derive(Clone, Copy)]
struct Joint {
    /// Vertices at the groove, at the top of the wall and at its foot.
    corners: [usize; 3],
    /// Edges from each to the next.
    down: [usize; 2],
}

/// Joints between which faces lie, in the direction of their lines.
#[derive(Clone, Copy)]
struct Stretch {
    from: Joint,
    to: Joint,
}

/// Joints of an end with both sides.
#[derive(Clone, Copy)]
struct Joints {
    upper: Joint,
    lower: Joint,
}

impl Joints {
    /// The end from its lower to its upper joint.
    fn upwards(self) -> Stretch {
        Stretch {
            from: self.lower,
            to: self.upper,
        }
    }
}

/// Edges along the groove, the top of the wall and its foot, from joint to joint.
type Lines = [usize; 3];

impl Solid {
    /// Adds the faces of a slot; the hole that they leave in the groove.
    ///
    /// # Errors
    /// That of [`Recess::end_patches`].
    pub(super) fn slot(
        &mut self,
        recess: &Recess,
        tolerance_m: f64,
    ) -> Result<Vec<Use>, PatchError> {
        let first = self.joints(recess, -1.0);
        let last = match recess.straight_rad {
            Some(_) => self.joints(recess, 1.0),
            None => first,
        };
        let behind = self.end(recess, -1.0, first.upwards(), tolerance_m)?;
        let ahead = self.end(recess, 1.0, last.upwards(), tolerance_m)?;
        let straights = recess.straight_rad.map(|_| {
            let mut straight = |side, from, to| self.straight(recess, side, Stretch { from, to });
            [
                straight(Side::Upper, first.upper, last.upper),
                straight(Side::Lower, first.lower, last.lower),
            ]
        });
        let [upper, lower] = [0, 1].map(|k| straights.map(|lines| lines[k]));
        // Both seen from the axis, where ψ grows to the left: the floor anticlockwise, the hole clockwise.
        let floor = [
            upper.map(|lines| along(lines[2])),
            Some(back(ahead[2])),
            lower.map(|lines| back(lines[2])),
            Some(along(behind[2])),
        ];
        let hole = [
            upper.map(|lines| back(lines[0])),
            Some(back(behind[0])),
            lower.map(|lines| along(lines[0])),
            Some(along(ahead[0])),
        ];
        let [floor, hole] = [floor, hole].map(|uses| uses.into_iter().flatten().collect());
        self.floor(recess, floor);
        Ok(hole)
    }

    fn joints(&mut self, recess: &Recess, end: f64) -> Joints {
        let [upper, lower] = Side::BOTH.map(|side| {
            let edge = recess.edge(EdgePlace::End(end, side.sign() * FRAC_PI_2));
            let points = [edge.arc_m(0.0), edge.arc_m(1.0), edge.wall_m(1.0)];
            let corners = points.map(|point| self.vertex(point));
            let wall = Curve::Line(edge.mill);
            let down = [
                self.edge(across(&edge), corners[0], corners[1]),
                self.edge(wall, corners[1], corners[2]),
            ];
            Joint { corners, down }
        });
        Joints { upper, lower }
    }

    /// The B-splines around an end; its lines go from the lower joint to the upper one.
    fn end(
        &mut self,
        recess: &Recess,
        end: f64,
        stretch: Stretch,
        tolerance_m: f64,
    ) -> Result<Lines, PatchError> {
        let patches = recess.end_patches(end, tolerance_m)?;
        let off_m = recess.end_deviation_m(end, &patches);
        self.deviation_m = self.deviation_m.max(off_m);
        let [rounded, wall] = patches;
        let foot = wall.across.len() + 1;
        let curves = [row(&rounded, 0), row(&wall, 0), row(&wall, foot)];
        let lines = self.lines(curves, stretch);
        let parts = [rounded, wall].map(Surface::Spline);
        self.faces_down(parts, [end < 0.0; 2], end < 0.0, lines, stretch);
        Ok(lines)
    }

    /// Torus and wall of a straight edge; its lines go along ψ.
    fn straight(&mut self, recess: &Recess, side: Side, stretch: Stretch) -> Lines {
        let [groove, centre, top, foot] = recess.straight_m(side);
        let curves = [groove, top, foot].map(|[radius, z]| circle(radius, z));
        let lines = self.lines(curves, stretch);
        let (upper, axis_rad) = (side == Side::Upper, recess.section_angle_rad);
        let reference = radial(recess.middle_rad + PI);
        let rounded = Surface::Torus {
            height_m: centre[1],
            major_m: centre[0],
            minor_m: recess.edge_radius_m,
            reference,
        };
        // Out of the material is down from the upper wall; a cone's own normal is outwards.
        let (wall, outward) = if axis_rad == 0.0 {
            (Surface::Plane(top[1]), !upper)
        } else {
            let wall = Surface::Cone {
                height_m: top[1],
                radius_m: top[0],
                way: axis_rad.signum(),
                half_angle_rad: FRAC_PI_2 - axis_rad.abs(),
                reference,
            };
            (wall, (axis_rad > 0.0) == upper)
        };
        self.faces_down([rounded, wall], [true, outward], upper, lines, stretch);
        lines
    }

    fn lines(&mut self, curves: [Curve; 3], stretch: Stretch) -> Lines {
        let Stretch { from, to } = stretch;
        let mut ends = from.corners.into_iter().zip(to.corners);
        curves.map(|curve| {
            let (start, end) = ends.next().unwrap_or_default();
            self.edge(curve, start, end)
        })
    }

    /// Rounded edge and wall between two joints, anticlockwise seen from the slot if `forward` along their
    /// upper lines.
    fn faces_down(
        &mut self,
        parts: [Surface; 2],
        outward: [bool; 2],
        forward: bool,
        lines: Lines,
        stretch: Stretch,
    ) {
        let Stretch { from, to } = stretch;
        for ((k, part), outward) in parts.into_iter().enumerate().zip(outward) {
            let around = if forward {
                [
                    along(lines[k]),
                    along(to.down[k]),
                    back(lines[k + 1]),
                    back(from.down[k]),
                ]
            } else {
                [
                    along(from.down[k]),
                    along(lines[k + 1]),
                    back(to.down[k]),
                    back(lines[k]),
                ]
            };
            self.face(part, outward, &[&around]);
        }
    }

    fn floor(&mut self, recess: &Recess, around: Vec<Use>) {
        let [.., foot] = recess.straight_m(Side::Lower);
        let axis_rad = recess.section_angle_rad;
        let reference = radial(recess.middle_rad + PI);
        let [radius_m, height_m] = foot;
        let floor = if axis_rad == 0.0 {
            Surface::Cylinder {
                radius_m,
                reference,
            }
        } else {
            Surface::Cone {
                height_m,
                radius_m,
                way: -axis_rad.signum(),
                half_angle_rad: axis_rad.abs(),
                reference,
            }
        };
        self.face(floor, false, &[&around]);
    }
}

/// The arc of an edge, downwards.
fn across(edge: &Edge) -> Curve {
    Curve::Circle {
        centre: edge.centre_m,
        axis: cross(edge.groove, edge.inside),
        reference: edge.groove,
        radius_m: edge.radius_m,
    }
}
