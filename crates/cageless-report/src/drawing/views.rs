//! Views of an outer ring: along its axis, sections, contact track.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use cageless::numerics::Vec3;
use cageless::surface::{DrawnGroove, Meridian, OuterRing, Side};
use cageless::{Bearing, Raceway};

use super::dimension::{angle_text, length_text};
use super::hatch::hatch;
use super::paper::{Anchor, FRAME_MM, Paper, Pen, Place, TEXT_MM, on_circle, width_mm};
use crate::length::mm;

/// Scales of ISO 5455.
const SCALES: [f64; 10] = [50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05];
/// Points on each side of a section.
const PER_SIDE: usize = 60;
/// Points along a track.
const ALONG: usize = 81;
/// Distance of the lines of a hatching, mm.
const HATCH_MM: f64 = 2.2;
/// Size of names of views and sections, mm.
const LETTER_MM: f64 = TEXT_MM + 0.6;

/// A ring to be drawn.
#[derive(Clone, Copy)]
pub(super) struct DrawnRing<'a> {
    pub ring: &'a OuterRing,
    pub bearing: &'a Bearing,
    /// Side to which the balls press the ring along its axis, ±1.
    pub contact_sign: f64,
}

/// Place of a view on the paper: its middle and the room for it, mm.
#[derive(Clone, Copy)]
pub(super) struct Room {
    pub middle: Place,
    pub size_mm: [f64; 2],
}

impl Room {
    /// The largest standard scale at which something so large fits, m.
    fn scale(&self, size_m: [f64; 2]) -> f64 {
        let fits = |scale: &f64| {
            let pairs = size_m.iter().zip(self.size_mm);
            pairs.into_iter().all(|(m, room)| mm(*m) * scale <= room)
        };
        let last = SCALES[SCALES.len() - 1];
        SCALES.into_iter().find(fits).unwrap_or(last)
    }

    fn title(&self, paper: &mut Paper, name: &str, scale: f64) {
        let at = [
            self.middle[0],
            self.middle[1] - 0.5 * self.size_mm[1] - 12.0,
        ];
        let text = format!("{name} ({})", scale_text(scale));
        paper.text(at, Anchor::Middle, LETTER_MM, &text);
    }
}

/// A scale as ISO 5455 writes it.
pub(super) fn scale_text(scale: f64) -> String {
    match scale < 1.0 {
        true => format!("1 : {}", (1.0 / scale).round()),
        false => format!("{scale} : 1"),
    }
}

impl DrawnRing<'_> {
    fn groove<'r>(&self, raceway: Option<&'r Raceway>) -> DrawnGroove<'r> {
        DrawnGroove::new(self.bearing, raceway, self.contact_sign)
    }

    /// ψ of a section of the plain groove, as near to the top as there is one.
    pub fn plain_rad(&self) -> Option<f64> {
        let mut candidates = (0..72).map(|k| {
            let step = f64::from((k + 1) / 2) * TAU / 72.0;
            PI + if k % 2 == 0 { step } else { -step }
        });
        candidates.find(|angle| !self.ring.raceways().any(|r| r.contains(*angle)))
    }

    /// Draws the ring along its axis, +Z towards the reader.
    pub fn front(&self, paper: &mut Paper, room: Room, toleranced: &dyn Fn(&Raceway) -> String) {
        let outside = self.ring.dimensions.outer_ring_outer_radius_m;
        let scale = room.scale([2.0 * outside, 2.0 * outside]);
        let centre = room.middle;
        let on_paper = |m: f64| mm(m) * scale;
        let [outer, shoulder, bottom] = [
            outside,
            self.ring.shoulder_radius_m,
            self.ring.groove_bottom_radius_m,
        ]
        .map(on_paper);
        paper.circle(centre, outer, Pen::Wide);
        paper.circle(centre, shoulder, Pen::Wide);
        paper.circle(centre, bottom, Pen::Dashed);
        for [x, y] in [[1.0, 0.0], [0.0, 1.0]] {
            let reach = outer + 4.0;
            let end = |sign: f64| [centre[0] + sign * reach * x, centre[1] + sign * reach * y];
            paper.line([end(-1.0), end(1.0)], Pen::Chain);
        }
        // Dimensions of diameters leave to the upper right.
        let diameters = [(outside, outer), (self.ring.shoulder_radius_m, shoulder)];
        for (k, (m, radius)) in diameters.iter().enumerate() {
            let direction = -0.9 + 0.42 * k as f64;
            let elbow = [
                centre[0] + outer + 4.0,
                centre[1] - outer + 6.0 + 8.0 * k as f64,
            ];
            let text = format!("Ø {}", length_text(2.0 * m));
            paper.leader(on_circle(centre, *radius, direction), elbow, &text);
        }
        for (k, raceway) in self.ring.raceways().enumerate() {
            paper.arc(centre, bottom, ends(raceway), Pen::WideChain);
            if k == 0 {
                raceway_angles(paper, centre, outer, raceway, &toleranced(raceway));
            }
        }
        if let Some(plain_rad) = self.plain_rad() {
            cut(paper, centre, outer, turned(plain_rad), "A");
        }
        let corner = [
            centre[0] - 0.5 * room.size_mm[0],
            centre[1] - 0.5 * room.size_mm[1] - 12.0,
        ];
        paper.text(corner, Anchor::Start, LETTER_MM, &scale_text(scale));
    }

    /// Half section of the plain groove.
    pub fn plain_section(&self, paper: &mut Paper, room: Room, plain_rad: f64) {
        let d = self.ring.dimensions;
        let points = self.groove(None).points(plain_rad, PER_SIDE);
        let (scale, place) = self.cut_face(paper, room, &points);
        let half = 0.5 * d.outer_ring_width_m;
        let corners = [-half, half].map(|z_m| {
            place(SectionPoint {
                z_m,
                radius_m: d.outer_ring_outer_radius_m,
            })
        });
        let above = corners[0][1] - 5.0;
        paper.horizontal(corners, above, &length_text(d.outer_ring_width_m));
        let section = self.groove(None).meridian(plain_rad);
        let arc = section.arc(Side::Upper);
        let eta = self.ring.section_angle_rad;
        let tip = place(SectionPoint {
            z_m: arc.height_m(eta - 0.3),
            radius_m: arc.radius_at_m(eta - 0.3),
        });
        let below = room.middle[1] + 0.5 * room.size_mm[1] + 6.0;
        let radius = format!("R {}", length_text(self.ring.curvature_radius_m));
        paper.leader(tip, [tip[0] + 8.0, below], &radius);
        let deepest = place(SectionPoint {
            z_m: self.ring.groove_height_m,
            radius_m: self.ring.groove_bottom_radius_m,
        });
        let diameter = format!("Ø {}", length_text(2.0 * self.ring.groove_bottom_radius_m));
        paper.leader(deepest, [deepest[0] - 8.0, below], &diameter);
        let height = self.ring.groove_height_m;
        if height.abs() > 1e-9 {
            let ends = [0.0, height].map(|z_m| {
                place(SectionPoint {
                    z_m,
                    radius_m: self.ring.shoulder_radius_m,
                })
            });
            paper.horizontal(ends, below + 9.0, &length_text(height.abs()));
        }
        room.title(paper, "A–A", scale);
    }

    /// Half section through the middle of a raceway, with the contact points of a ball that rests in it.
    pub fn raceway_section(&self, paper: &mut Paper, room: Room, raceway: &Raceway, span: &str) {
        let centre_rad = raceway.dimensions().centre_angle_rad;
        let groove = self.groove(Some(raceway));
        let points = groove.points(centre_rad, PER_SIDE);
        let (scale, place) = self.cut_face(paper, room, &points);
        let plain = self.groove(None).points(centre_rad, PER_SIDE);
        paper.line(
            plain.iter().map(|p| place(SectionPoint::of(*p))),
            Pen::Chain,
        );
        let contacts = contacts(&groove.meridian(centre_rad)).map(&place);
        let below = room.middle[1] + 0.5 * room.size_mm[1] + 8.0;
        for contact in contacts {
            paper.circle(contact, 0.5, Pen::Wide);
        }
        paper.horizontal(contacts, below, span);
        room.title(paper, "B–B", scale);
    }

    /// The track of the contact points, unrolled along the bottom of the groove.
    pub fn track(&self, paper: &mut Paper, room: Room, raceway: &Raceway, texts: [&str; 2]) {
        let d = raceway.dimensions();
        let bottom = self.ring.groove_bottom_radius_m;
        let length = 2.0 * d.half_angle_rad * bottom;
        let scale = room.scale([1.3 * length, 1.2 * d.axial_span_m]);
        let groove = self.groove(Some(raceway));
        let at = |local: f64, z: f64| {
            let [x, y] = room.middle;
            [x + scale * mm(local * bottom), y - scale * mm(z)]
        };
        // Denser towards the ends, which may be round.
        let share = |k: usize| (PI * (k as f64 / (ALONG - 1) as f64 - 0.5)).sin();
        let local = |k: usize| d.half_angle_rad * share(k);
        let pairs: Vec<[Place; 2]> = (0..ALONG)
            .map(|k| {
                let section = groove.meridian(d.centre_angle_rad + local(k) * (1.0 - 1e-12));
                contacts(&section).map(|point| at(local(k), point.z_m))
            })
            .collect();
        for side in [0, 1] {
            paper.line(pairs.iter().map(|pair| pair[side]), Pen::Wide);
        }
        let middle_z = self.ring.groove_height_m;
        let beyond = [-1.28, 1.28].map(|share| at(share * d.half_angle_rad, middle_z));
        paper.line(beyond, Pen::Chain);
        let ends = [-1.0, 1.0].map(|sign| at(sign * d.half_angle_rad, middle_z));
        let half_height = 0.5 * scale * mm(d.axial_span_m);
        paper.horizontal(ends, room.middle[1] + half_height + 8.0, texts[0]);
        if let Some(start) = raceway.blend_start_rad() {
            let blend = [start, d.half_angle_rad].map(|local| at(local, middle_z));
            let text = format!("blend {}", length_text(raceway.blend_m()));
            paper.horizontal(blend, room.middle[1] - half_height - 4.0, &text);
        }
        let [upper, lower] = pairs[ALONG / 2];
        paper.line([[upper[0], upper[1] - 6.0], lower], Pen::Narrow);
        paper.arrow(upper, [0.0, upper[1] - lower[1]]);
        paper.arrow(lower, [0.0, lower[1] - upper[1]]);
        let beside = [upper[0] + 1.0, upper[1] - 2.5];
        paper.text(beside, Anchor::Start, TEXT_MM, texts[1]);
        room.title(paper, "Track of the contact points, unrolled", scale);
    }

    /// Draws a half section whose groove has these points, at the largest scale that fits: the scale, and the place of
    /// a point of the section.
    fn cut_face(
        &self,
        paper: &mut Paper,
        room: Room,
        groove: &[[f64; 3]],
    ) -> (f64, impl Fn(SectionPoint) -> Place + use<>) {
        let d = self.ring.dimensions;
        let (outside, shoulder) = (d.outer_ring_outer_radius_m, self.ring.shoulder_radius_m);
        let scale = room.scale([d.outer_ring_width_m, outside - shoulder]);
        let middle_m = 0.5 * (outside + shoulder);
        let place = move |point: SectionPoint| {
            let [x, y] = room.middle;
            [
                x + scale * mm(point.z_m),
                y - scale * mm(point.radius_m - middle_m),
            ]
        };
        let outline = self.outline(groove, &place);
        for stretch in hatch(&outline, HATCH_MM) {
            paper.line(stretch, Pen::Narrow);
        }
        paper.line(outline.iter().copied().chain([outline[0]]), Pen::Wide);
        (scale, place)
    }

    /// Outline of a section whose groove has these points, from the lower to the upper shoulder.
    fn outline(&self, groove: &[[f64; 3]], place: &dyn Fn(SectionPoint) -> Place) -> Vec<Place> {
        let d = self.ring.dimensions;
        let half = 0.5 * d.outer_ring_width_m;
        let (outside, shoulder) = (d.outer_ring_outer_radius_m, self.ring.shoulder_radius_m);
        let corners = [
            [half, shoulder],
            [half, outside],
            [-half, outside],
            [-half, shoulder],
        ]
        .map(|[z_m, radius_m]| SectionPoint { z_m, radius_m });
        let points = groove.iter().map(|p| SectionPoint::of(*p)).chain(corners);
        points.map(place).collect()
    }
}

/// Extent and place of a raceway, and the section through its middle.
fn raceway_angles(paper: &mut Paper, centre: Place, outer: f64, raceway: &Raceway, extent: &str) {
    let d = raceway.dimensions();
    let [from, to] = ends(raceway);
    let middle = turned(d.centre_angle_rad);
    for angle in [from, to] {
        let ends = [0.0, outer + 9.0].map(|radius| on_circle(centre, radius, angle));
        paper.line(ends, Pen::Narrow);
    }
    paper.angle(centre, outer + 7.0, [to, from]);
    let width = width_mm(extent, TEXT_MM);
    if middle.cos() < -0.3 {
        // There is less room to the left.
        let ends = [from, to].map(|angle| on_circle(centre, outer + 9.0, angle));
        let upper = ends.into_iter().min_by(|a, b| a[1].total_cmp(&b[1]));
        let [x, y] = upper.unwrap_or(centre);
        let left = (x - width).max(FRAME_MM + 2.0);
        paper.text([left, y - 2.0], Anchor::Start, TEXT_MM, extent);
    } else {
        let [x, y] = on_circle(centre, outer + 9.0, to + 0.12 * (from - to));
        paper.centred([x + 1.5, y + 2.4], Anchor::Start, TEXT_MM, extent);
    }
    cut(paper, centre, outer, middle, "B");
    let place = d.centre_angle_rad;
    if place.abs() > 1e-9 {
        let radius = outer + 12.0;
        paper.angle(centre, radius, [middle, FRAC_PI_2]);
        let bottom = [
            [centre[0], centre[1] + outer + 5.0],
            [centre[0], centre[1] + radius + 2.0],
        ];
        paper.line(bottom, Pen::Narrow);
        let at = on_circle(centre, radius + 4.0, turned(0.5 * place));
        paper.centred(at, Anchor::Middle, TEXT_MM, &angle_text(place.abs()));
    }
}

/// Plane of a half section at an angle of the paper, seen against its growth.
fn cut(paper: &mut Paper, centre: Place, outer: f64, angle_rad: f64, letter: &str) {
    let at = |beyond: f64| on_circle(centre, outer + beyond, angle_rad);
    paper.line([centre, at(10.0)], Pen::Chain);
    paper.line([at(10.0), at(15.0)], Pen::Wide);
    let (sin, cos) = angle_rad.sin_cos();
    let [x, y] = at(14.0);
    paper.line([[x, y], [x - 4.0 * sin, y + 4.0 * cos]], Pen::Narrow);
    paper.arrow([x, y], [sin, -cos]);
    paper.centred(at(18.5), Anchor::Middle, LETTER_MM, letter);
}

/// Angle on the paper, from +x towards +y, of ψ.
fn turned(angle_rad: f64) -> f64 {
    FRAC_PI_2 - angle_rad
}

/// Angles on the paper of both ends of a raceway.
fn ends(raceway: &Raceway) -> [f64; 2] {
    let d = raceway.dimensions();
    [-1.0, 1.0].map(|sign| turned(d.centre_angle_rad + sign * d.half_angle_rad))
}

/// A point of a section through the axis, m.
#[derive(Debug, Clone, Copy)]
pub(super) struct SectionPoint {
    pub z_m: f64,
    /// ρ.
    pub radius_m: f64,
}

impl SectionPoint {
    /// Point of the section at the z and ρ of a point in space.
    fn of(point_m: Vec3) -> Self {
        let [x, y, z_m] = point_m;
        Self {
            z_m,
            radius_m: x.hypot(y),
        }
    }
}

/// The contact points with a ball, upper and lower.
pub(super) fn contacts(section: &Meridian) -> [SectionPoint; 2] {
    Side::BOTH.map(|side| {
        let arc = section.arc(side);
        SectionPoint::of(
            arc.point(section.angle_rad, arc.contact_angle_rad)
                .position_m,
        )
    })
}
