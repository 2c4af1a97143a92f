//! The outer ring as faces, edges and vertices, in metres.
//!
//! Meridian planes between sectors cut the groove and the shoulders; the cylinder outside
//! is in two halves and each side face is whole. Plain sectors are tori, around slots with a hole;
//! discrete raceways and their blends two B-spline faces each that meet in the apex between the flanks.

use std::f64::consts::{FRAC_PI_2, PI};

use cageless::numerics::Vec3;
use cageless::surface::{Arc, Meridian, OuterRing, Patch, PatchError, RingSector, Side};

/// Curve of an edge.
#[derive(Debug)]
pub(super) enum Curve {
    /// Along this unit vector.
    Line(Vec3),
    /// About `axis` through `centre`.
    Circle {
        centre: Vec3,
        axis: Vec3,
        reference: Vec3,
        radius_m: f64,
    },
    /// Cubic with these breakpoints.
    Spline { sites: Vec<f64>, control: Vec<Vec3> },
}

/// Surface of a face. The reference direction of a cylinder or a torus points away from
/// the face, so that no face crosses the seam.
#[derive(Debug)]
pub(super) enum Surface {
    /// z = this.
    Plane(f64),
    /// About Z.
    Cylinder { radius_m: f64, reference: Vec3 },
    /// About Z, with this radius at z = `height_m`; along +z or −z, `way`, it grows by the tangent of the angle.
    Cone {
        height_m: f64,
        radius_m: f64,
        way: f64,
        half_angle_rad: f64,
        reference: Vec3,
    },
    /// About Z, in the plane z = `height_m`.
    Torus {
        height_m: f64,
        major_m: f64,
        minor_m: f64,
        reference: Vec3,
    },
    /// One side of a sector's groove, or a part of the end of a slot.
    Spline(Patch),
}

/// A curve between two vertices.
#[derive(Debug)]
pub(super) struct Edge {
    pub curve: Curve,
    pub start: usize,
    pub end: usize,
}

/// An edge in a loop, along its curve or against it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Use {
    pub edge: usize,
    pub forward: bool,
}

/// A surface within loops; the first is the outer one. Seen against the outward normal of
/// the solid, the outer loop goes counter-clockwise.
#[derive(Debug)]
pub(super) struct Face {
    pub surface: Surface,
    /// Whether the surface's own normal points out of the solid.
    pub outward: bool,
    pub loops: Vec<Vec<Use>>,
}

/// A closed shell.
#[derive(Debug, Default)]
pub(super) struct Solid {
    pub vertices: Vec<Vec3>,
    pub edges: Vec<Edge>,
    pub faces: Vec<Face>,
    /// Largest distance of its B-splines from the analytic surface.
    pub deviation_m: f64,
}

/// Edges and vertices in the meridian plane where a sector starts: upper before lower.
struct Station {
    /// At the side faces.
    rim: [usize; 2],
    /// At the edges of the groove.
    shoulder: [usize; 2],
    bottom: usize,
    /// Along ±z: upper from groove to rim, lower from rim to groove.
    wall: [usize; 2],
    /// Upper from shoulder to bottom, lower from bottom to shoulder.
    arc: [usize; 2],
}

/// Stations between which a sector lies.
#[derive(Clone, Copy)]
struct Ends<'a> {
    from: &'a Station,
    to: &'a Station,
}

/// The two sides of a discrete raceway and the edge in which they meet.
struct Flanks {
    upper: Patch,
    lower: Patch,
    ridge: usize,
}

/// Edges along ψ of a sector.
struct Span {
    rim: [usize; 2],
    shoulder: [usize; 2],
    /// `None` where the groove is one face.
    ridge: Option<usize>,
}

impl Solid {
    /// Builds the shell, its B-splines within `tolerance_m` of the surface.
    pub(super) fn new(ring: &OuterRing, tolerance_m: f64) -> Result<Self, PatchError> {
        let mut solid = Self::default();
        let sectors = ring.sectors();
        let stations: Vec<Station> = (sectors.iter())
            .map(|sector| solid.station(ring, sector))
            .collect();
        let mut rims = Vec::new();
        for (k, sector) in sectors.iter().enumerate() {
            let ends = Ends {
                from: &stations[k],
                to: &stations[(k + 1) % sectors.len()],
            };
            let whole = solid.whole_groove(ring, sector, tolerance_m)?;
            let halves = match &whole {
                Some(_) => None,
                None => Some(Patch::pair(ring, sector, tolerance_m)?),
            };
            for (patch, side) in halves.iter().flatten().zip(Side::BOTH) {
                let off_m = patch.deviation_m(ring, sector, side);
                solid.deviation_m = solid.deviation_m.max(off_m);
            }
            let span = solid.span(ring, sector, ends, halves.as_ref());
            if let Some(whole) = whole {
                let slot = sector.slot.map(|slot| &ring.recesses[slot]);
                let hole = slot.map(|slot| solid.slot(slot, tolerance_m)).transpose()?;
                solid.groove(whole, ends, &span, hole);
            }
            if let (Some([upper, lower]), Some(ridge)) = (halves, span.ridge) {
                let flanks = Flanks {
                    upper,
                    lower,
                    ridge,
                };
                solid.flanks(flanks, ends, &span);
            }
            solid.shoulders(ring, sector, ends, &span);
            rims.push(span.rim);
        }
        solid.outside(ring, sectors[0].start_rad, &rims);
        Ok(solid)
    }

    pub(super) fn vertex(&mut self, position: Vec3) -> usize {
        self.vertices.push(position);
        self.vertices.len() - 1
    }

    pub(super) fn edge(&mut self, curve: Curve, start: usize, end: usize) -> usize {
        self.edges.push(Edge { curve, start, end });
        self.edges.len() - 1
    }

    pub(super) fn face(&mut self, surface: Surface, outward: bool, loops: &[&[Use]]) {
        self.faces.push(Face {
            surface,
            outward,
            loops: loops.iter().map(|l| l.to_vec()).collect(),
        });
    }

    fn station(&mut self, ring: &OuterRing, sector: &RingSector) -> Station {
        let psi = sector.start_rad;
        let (e, t) = (radial(psi), radial(psi + FRAC_PI_2));
        let meridian = ring.meridian_in(sector, psi);
        let half = ring.dimensions.outer_ring_width_m / 2.0;
        let ros = ring.shoulder_radius_m;
        let at = |rho: f64, z: f64| [rho * e[0], rho * e[1], z];
        let rim = [half, -half].map(|z| self.vertex(at(ros, z)));
        let shoulder = edges_of_groove_m(&meridian).map(|z| self.vertex(at(ros, z)));
        let ridge = meridian.arcs[0].ridge_height_m();
        let bottom = self.vertex(at(meridian.arcs[0].radius_m(ridge), ridge));
        let up = || Curve::Line([0.0, 0.0, 1.0]);
        let [upper, lower] = meridian.arcs.map(|arc| Curve::Circle {
            centre: at(arc.centre_radius_m, arc.side.sign() * arc.centre_height_m),
            axis: t,
            reference: e,
            radius_m: arc.curvature_radius_m,
        });
        Station {
            wall: [
                self.edge(up(), shoulder[0], rim[0]),
                self.edge(up(), rim[1], shoulder[1]),
            ],
            // About t the circle runs from +z to −z.
            arc: [
                self.edge(upper, shoulder[0], bottom),
                self.edge(lower, bottom, shoulder[1]),
            ],
            rim,
            shoulder,
            bottom,
        }
    }

    fn span(
        &mut self,
        ring: &OuterRing,
        sector: &RingSector,
        ends: Ends<'_>,
        patches: Option<&[Patch; 2]>,
    ) -> Span {
        let half = ring.dimensions.outer_ring_width_m / 2.0;
        let groove = edges_of_groove_m(&ring.meridian_in(sector, sector.start_rad));
        let ros = ring.shoulder_radius_m;
        let rim = [0, 1].map(|k| {
            let z = [half, -half][k];
            self.edge(circle(ros, z), ends.from.rim[k], ends.to.rim[k])
        });
        let shoulder = [0, 1].map(|k| {
            let curve = match patches {
                Some(patches) => row(&patches[k], patches[k].across.len() + 1),
                None => circle(ros, groove[k]),
            };
            self.edge(curve, ends.from.shoulder[k], ends.to.shoulder[k])
        });
        let ridge = patches.map(|p| self.edge(row(&p[0], 0), ends.from.bottom, ends.to.bottom));
        Span {
            rim,
            shoulder,
            ridge,
        }
    }

    /// Surface of a groove that is one face: an exact torus, or where that would cross itself, which a torus
    /// of STEP must not, or have its seam next to a hole, a B-spline; `None` where it is two.
    fn whole_groove(
        &mut self,
        ring: &OuterRing,
        sector: &RingSector,
        tolerance_m: f64,
    ) -> Result<Option<Surface>, PatchError> {
        let crosses = ring.groove_bottom_radius_m <= 2.0 * ring.curvature_radius_m;
        let slotted = sector.slot.is_some();
        if sector.raceway.is_some() || (crosses && !slotted) {
            return Ok(None);
        }
        if crosses || (slotted && ring.section_angle_rad != 0.0) {
            let (patch, off_m) = Patch::plain(ring, sector, tolerance_m)?;
            self.deviation_m = self.deviation_m.max(off_m);
            return Ok(Some(Surface::Spline(patch)));
        }
        Ok(Some(Surface::Torus {
            height_m: ring.groove_height_m,
            major_m: ring.groove_bottom_radius_m - ring.curvature_radius_m,
            minor_m: ring.curvature_radius_m,
            reference: radial(sector.middle_rad() + PI),
        }))
    }

    /// The groove's outward normal points to the axis, where k, t, −k, −t go around
    /// counter-clockwise.
    fn groove(&mut self, surface: Surface, ends: Ends<'_>, span: &Span, hole: Option<Vec<Use>>) {
        let around = [
            back(ends.from.arc[1]),
            back(ends.from.arc[0]),
            along(span.shoulder[0]),
            along(ends.to.arc[0]),
            along(ends.to.arc[1]),
            back(span.shoulder[1]),
        ];
        let mut loops: Vec<&[Use]> = vec![&around];
        loops.extend(hole.as_deref());
        // t × k = e points into the material.
        self.face(surface, false, &loops);
    }

    /// The two sides of a discrete raceway.
    fn flanks(&mut self, flanks: Flanks, ends: Ends<'_>, span: &Span) {
        let above = [
            back(ends.from.arc[0]),
            along(span.shoulder[0]),
            along(ends.to.arc[0]),
            back(flanks.ridge),
        ];
        let below = [
            back(ends.from.arc[1]),
            along(flanks.ridge),
            along(ends.to.arc[1]),
            back(span.shoulder[1]),
        ];
        // t × (−k) points out of it.
        self.face(Surface::Spline(flanks.upper), false, &[&above]);
        self.face(Surface::Spline(flanks.lower), true, &[&below]);
    }

    fn shoulders(&mut self, ring: &OuterRing, sector: &RingSector, ends: Ends<'_>, span: &Span) {
        let cylinder = || Surface::Cylinder {
            radius_m: ring.shoulder_radius_m,
            reference: radial(sector.middle_rad() + PI),
        };
        let above = [
            along(ends.from.wall[0]),
            along(span.rim[0]),
            back(ends.to.wall[0]),
            back(span.shoulder[0]),
        ];
        let below = [
            along(ends.from.wall[1]),
            along(span.shoulder[1]),
            back(ends.to.wall[1]),
            back(span.rim[1]),
        ];
        self.face(cylinder(), false, &[&above]);
        self.face(cylinder(), false, &[&below]);
    }
}

/// z where the groove reaches its shoulders: upper, lower.
fn edges_of_groove_m(meridian: &Meridian) -> [f64; 2] {
    let height = |arc: Arc| arc.side.sign() * arc.height_m(arc.shoulder_rad());
    meridian.arcs.map(height)
}

pub(super) fn along(edge: usize) -> Use {
    Use {
        edge,
        forward: true,
    }
}

pub(super) fn back(edge: usize) -> Use {
    Use {
        edge,
        forward: false,
    }
}

/// e(ψ).
pub(super) fn radial(psi: f64) -> Vec3 {
    [psi.sin(), -psi.cos(), 0.0]
}

/// About Z at this height.
pub(super) fn circle(radius_m: f64, z: f64) -> Curve {
    Curve::Circle {
        centre: [0.0, 0.0, z],
        axis: [0.0, 0.0, 1.0],
        reference: [0.0, -1.0, 0.0],
        radius_m,
    }
}

/// A row of a patch along ψ.
pub(super) fn row(patch: &Patch, across: usize) -> Curve {
    Curve::Spline {
        sites: patch.along_rad.clone(),
        control: patch
            .control_m
            .iter()
            .map(|points| points[across])
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case_file::{CaseFile, template};
    use cageless::surface::OuterRingDimensions;

    fn solid(conventional: bool, contact_angle_deg: f64, blend_m: f64) -> Solid {
        let given = format!("[bearing]\ncontact_angle_deg = {contact_angle_deg}");
        let text = template(conventional).replace("[bearing]", &given);
        let file = CaseFile::parse(&text, "template", &[]).unwrap();
        let mut case = file.case().clone();
        for raceway in &mut case.raceways {
            let angle_rad = contact_angle_deg.to_radians();
            let turned = raceway.clone().with_section_angle(angle_rad, &case.bearing);
            *raceway = turned.unwrap();
        }
        let size = OuterRingDimensions {
            outer_ring_outer_radius_m: 31e-3,
            outer_ring_width_m: 16e-3,
            blend_m,
        };
        let ring = OuterRing::of(&case, size).unwrap();
        Solid::new(&ring, 1e-8).unwrap()
    }

    /// A ring with two slots, whose section is turned.
    fn slotted(half_angle_deg: f64, section_angle_deg: f64) -> Solid {
        let slot = |centre_deg: f64| {
            format!(
                "[[raceway]]\naxial_span_mm = 2.4\nhalf_angle_deg = {half_angle_deg}\n\
                 centre_angle_deg = {centre_deg}\nshape = \"slot\"\nedge_radius_mm = 0.3\n\
                 contact_angle_deg = {section_angle_deg}\n"
            )
        };
        let text = format!("{}\n{}{}", template(true), slot(10.0), slot(170.0));
        let file = CaseFile::parse(&text, "template", &[]).unwrap();
        let size = file.outer_ring_dimensions(0.0).unwrap();
        let ring = OuterRing::of(file.case(), size).unwrap();
        Solid::new(&ring, 1e-8).unwrap()
    }

    /// Every edge bounds two faces, once each way; each loop closes; a ring has genus 1.
    #[test]
    fn shell_is_closed_and_oriented() {
        for (solid, slots) in [
            (solid(true, 0.0, 0.0), 0),
            (solid(false, 0.0, 0.0), 0),
            (solid(false, 0.0, 5e-4), 0),
            (solid(false, 15.0, 5e-4), 0),
            (slotted(25.2, 0.0), 2),
            (slotted(25.2, -15.0), 2),
            // Without a straight stretch.
            (slotted(2.632_305_24, 0.0), 2),
        ] {
            let mut uses = vec![[0; 2]; solid.edges.len()];
            for face in &solid.faces {
                for around in &face.loops {
                    let ends = |u: &Use| {
                        let edge = &solid.edges[u.edge];
                        if u.forward {
                            (edge.start, edge.end)
                        } else {
                            (edge.end, edge.start)
                        }
                    };
                    for (k, one) in around.iter().enumerate() {
                        uses[one.edge][usize::from(one.forward)] += 1;
                        let next = &around[(k + 1) % around.len()];
                        assert_eq!(ends(one).1, ends(next).0);
                    }
                }
            }
            assert!(uses.iter().all(|u| *u == [1, 1]), "{uses:?}");
            let holes: usize = solid.faces.iter().map(|f| f.loops.len() - 1).sum();
            assert_eq!(holes, 2 + slots);
            let euler = solid.vertices.len() as isize - solid.edges.len() as isize
                + solid.faces.len() as isize
                - holes as isize;
            assert_eq!(euler, 0);
        }
    }

    /// Curves start and end at their vertices.
    #[test]
    fn curves_run_between_their_vertices() {
        let distance = |a: Vec3, b: Vec3| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt();
        let check = |solid: &Solid, edge: &Edge| {
            let [start, end] = [edge.start, edge.end].map(|k| solid.vertices[k]);
            match &edge.curve {
                Curve::Line(direction) => {
                    let length = distance(start, end);
                    let reached = [0, 1, 2].map(|c| start[c] + length * direction[c]);
                    assert!(distance(reached, end) < 1e-15);
                }
                Curve::Circle {
                    centre, radius_m, ..
                } => {
                    assert!((distance(start, *centre) - radius_m).abs() < 1e-15);
                    assert!((distance(end, *centre) - radius_m).abs() < 1e-15);
                }
                Curve::Spline { control, .. } => {
                    assert!(distance(start, control[0]) < 1e-15);
                    assert!(distance(end, control[control.len() - 1]) < 1e-15);
                }
            }
        };
        for solid in [
            solid(false, 0.0, 5e-4),
            solid(false, 15.0, 5e-4),
            slotted(25.2, 0.0),
            slotted(25.2, 15.0),
        ] {
            solid.edges.iter().for_each(|edge| check(&solid, edge));
        }
    }
}
