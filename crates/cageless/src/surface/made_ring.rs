//! The groove of a ring as it was made and as it lies in a measuring machine.

use super::Meridian;
use super::made_raceway::MadeRaceway;
use super::pose::Pose;
use super::section_frame::SectionFrame;
use crate::case::Case;
use crate::error::InputError;
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::bspline::Vec3;

/// Unknowns of the plain groove: shift, tilt, change of the radius of its bottom and of its curvature.
pub(super) const GROOVE: usize = 7;
/// Unknowns of a raceway: changes of lC, θ, ψ of its middle and depth error.
pub(super) const RACEWAY: usize = 4;
/// Half of the differences for derivatives: of coordinates, radii and depth, of lC, m, and of angles, rad.
const DIFFERENCE_M: f64 = 1e-7;
const SPAN_DIFFERENCE_M: f64 = 1e-6;
const DIFFERENCE_RAD: f64 = 1e-5;
/// Shoulders and what is this close to them are not touched as groove, m.
const SHOULDER_M: f64 = 20e-6;
/// Distance beyond which a point is of another face, m.
const OTHER_FACE_M: f64 = 1e-3;

/// A groove with raceways that are no slots.
#[derive(Debug, Clone)]
pub(super) struct MadeRing {
    /// Where it lies.
    pub pose: Pose,
    /// Changes of Ro and Re, m.
    pub sizes_m: [f64; 2],
    /// Raceways of the ring; `None` in place of a missing one or a slot.
    pub raceways: Vec<Option<MadeRaceway>>,
    /// Sections as drawn.
    pub(super) drawn: SectionFrame,
    /// Slots, as drawn, whose surroundings are left out.
    pub(super) slots: Vec<SlotPlace>,
}

/// Area of the groove taken up by a slot.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlotPlace {
    middle_rad: f64,
    half_angle_rad: f64,
    half_width_m: f64,
}

/// A point as the fit sees it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Observed {
    /// Distance from the groove, positive inside the material, m.
    pub error_m: f64,
    /// Raceway that it lies on.
    pub raceway: Option<usize>,
    /// Derivatives of the distance over the unknowns of the groove.
    pub groove: [f64; GROOVE],
    /// Derivatives over those of the raceway.
    pub dimensions: [f64; RACEWAY],
}

/// Raceways with each of their unknowns a little more and a little less.
pub(super) type Neighbours = Vec<Option<[[MadeRaceway; 2]; RACEWAY]>>;

impl MadeRing {
    /// The ring of a case as drawn, in its own frame.
    pub(super) fn drawn(case: &Case) -> Self {
        let first = &case.raceways[0];
        let slots = case.raceways.iter().filter_map(|raceway| {
            let slot = raceway.slot()?;
            // The drawing may miss the place by as much.
            let room_m = 3.0 * slot.edge_radius_m;
            Some(SlotPlace {
                middle_rad: raceway.dimensions().centre_angle_rad,
                half_angle_rad: raceway.half_angle_rad() + room_m / slot.groove_bottom_radius_m(),
                half_width_m: slot.half_span_m() + room_m,
            })
        });
        let raceways = case.raceways.iter().map(|raceway| {
            raceway.slot().is_none().then(|| MadeRaceway {
                raceway: raceway.clone(),
                depth_error_m: 0.0,
            })
        });
        Self {
            pose: Pose::default(),
            sizes_m: [0.0; 2],
            raceways: raceways.collect(),
            drawn: SectionFrame::of(case, first),
            slots: slots.collect(),
        }
    }

    /// With raceways of the drawing's place and dimensions, and the drawing's groove, turned by as much as they were made.
    pub(super) fn as_drawn(&self, case: &Case, turn_rad: f64) -> Self {
        let mut drawn = Self::drawn(case);
        for (made, drawn) in self.raceways.iter().zip(&mut drawn.raceways) {
            *drawn = drawn.take().filter(|_| made.is_some());
        }
        drawn.turned(case, turn_rad).unwrap_or(drawn)
    }

    /// With all raceways turned about the axis.
    ///
    /// # Errors
    /// That of a raceway beyond a turn.
    pub(super) fn turned(&self, case: &Case, turn_rad: f64) -> Result<Self, InputError> {
        let raceways = self.raceways.iter().map(|raceway| {
            let Some(raceway) = raceway else {
                return Ok(None);
            };
            let at = raceway.raceway.dimensions().centre_angle_rad;
            let turn = wrap_angle_rad(at + turn_rad) - at;
            raceway
                .moved(&case.bearing, [0.0, 0.0, turn, 0.0])
                .map(Some)
        });
        Ok(Self {
            raceways: raceways.collect::<Result<_, _>>()?,
            ..self.clone()
        })
    }

    /// With all spans a multiple of theirs, without raceways for 0.
    ///
    /// # Errors
    /// No raceway has such a span.
    pub(super) fn scaled(&self, case: &Case, factor: f64) -> Result<Self, InputError> {
        let raceways = self.raceways.iter().map(|raceway| match raceway {
            Some(raceway) if factor > 0.0 => {
                let span_m = raceway.raceway.dimensions().axial_span_m;
                let step = [(factor - 1.0) * span_m, 0.0, 0.0, 0.0];
                raceway.moved(&case.bearing, step).map(Some)
            }
            _ => Ok(None),
        });
        Ok(Self {
            raceways: raceways.collect::<Result<_, _>>()?,
            ..self.clone()
        })
    }

    /// Sections as made.
    fn frame(&self) -> SectionFrame {
        self.frame_of(self.sizes_m)
    }

    /// Sections with these changes of Ro and Re.
    fn frame_of(&self, [bottom, curvature]: [f64; 2]) -> SectionFrame {
        let (sin, cos) = self.drawn.axis_rad.sin_cos();
        let [radius, height] = self.drawn.ball_m;
        SectionFrame {
            ball_m: [
                radius + bottom - curvature * (1.0 - cos),
                height + curvature * sin,
            ],
            offset_m: self.drawn.offset_m + curvature,
            curvature_radius_m: self.drawn.curvature_radius_m + curvature,
            ..self.drawn
        }
    }

    /// Re − Rw as drawn.
    pub(super) fn offset_m(&self) -> f64 {
        self.drawn.offset_m
    }

    fn section(&self, frame: &SectionFrame, angle_rad: f64) -> (Meridian, Option<usize>) {
        let within = |(k, made): (usize, &Option<MadeRaceway>)| {
            Some((made.as_ref()?.meridian(frame, angle_rad)?, Some(k)))
        };
        let found = self.raceways.iter().enumerate().find_map(within);
        found.unwrap_or_else(|| (Meridian::new(frame, angle_rad, [0.0; 2]), None))
    }

    /// Whether a point belongs to the groove: neither to a slot nor to shoulders and faces.
    pub(super) fn has(&self, point_m: Vec3) -> bool {
        let [x, y, z] = self.pose.in_ring_m(point_m);
        let (radius, angle) = (x.hypot(y), x.atan2(-y));
        let frame = self.frame();
        let in_slot = self.slots.iter().any(|slot| {
            let (sin, cos) = frame.axis_rad.sin_cos();
            let [out, up] = [radius - frame.ball_m[0], z - frame.ball_m[1]];
            let across = up * cos - out * sin;
            wrap_angle_rad(angle - slot.middle_rad).abs() < slot.half_angle_rad
                && across.abs() < slot.half_width_m
        });
        let (section, _) = self.section(&frame, angle);
        let [upper, lower] = section.arcs;
        let within = |arc: &super::Arc, z: f64| z < arc.height_m(arc.shoulder_rad());
        let near = section.distance_m(radius, z).abs() < OTHER_FACE_M;
        let on_shoulder = (radius - frame.shoulder_radius_m).abs() < SHOULDER_M;
        near && !in_slot && !on_shoulder && within(&upper, z) && within(&lower, -z)
    }

    /// Distance of a point from the groove, positive inside the material, and the raceway that it lies on.
    pub(super) fn distance_m(&self, point_m: Vec3) -> (f64, Option<usize>) {
        self.distance_in_ring_m(&self.frame(), self.pose.in_ring_m(point_m))
    }

    fn distance_in_ring_m(&self, frame: &SectionFrame, [x, y, z]: Vec3) -> (f64, Option<usize>) {
        let (section, raceway) = self.section(frame, x.atan2(-y));
        (section.distance_m(x.hypot(y), z), raceway)
    }

    /// Raceways next to these.
    ///
    /// # Errors
    /// No raceway has such dimensions.
    pub(super) fn neighbours(&self, case: &Case) -> Result<Neighbours, InputError> {
        let around = |made: &MadeRaceway| {
            let moved = |k: usize, sign: f64| {
                let mut step = [0.0; RACEWAY];
                step[k] = sign * difference(k);
                made.moved(&case.bearing, step)
            };
            let pair = |k| Ok([moved(k, 1.0)?, moved(k, -1.0)?]);
            Ok([pair(0)?, pair(1)?, pair(2)?, pair(3)?])
        };
        let all = self.raceways.iter();
        all.map(|made| made.as_ref().map(around).transpose())
            .collect()
    }

    /// A point with the derivatives of its distance.
    pub(super) fn observed(&self, neighbours: &Neighbours, point_m: Vec3) -> Observed {
        let (frame, place) = (self.frame(), self.pose.in_ring_m(point_m));
        let (error_m, raceway) = self.distance_in_ring_m(&frame, place);
        let [x, y, z] = place;
        let (radius, angle) = (x.hypot(y), x.atan2(-y));
        let nearby = raceway.and_then(|k| neighbours[k].as_ref());
        let (gradient, sizes) = match nearby {
            None => self.plain_slopes(&frame, place),
            Some(_) => self.slopes(&frame, place),
        };
        // Of q = Rᵀ (p − shift) with small tilts.
        let [tilt_x, tilt_y] = [
            gradient[1] * z - gradient[2] * y,
            gradient[2] * x - gradient[0] * z,
        ];
        let dimensions = nearby.map_or([0.0; RACEWAY], |pairs| {
            std::array::from_fn(|k| {
                let [more, less] = [0, 1].map(|side| {
                    let section = pairs[k][side].meridian(&frame, angle);
                    let section = section.unwrap_or_else(|| Meridian::new(&frame, angle, [0.0; 2]));
                    section.distance_m(radius, z)
                });
                (more - less) / (2.0 * difference(k))
            })
        });
        let [gx, gy, gz] = gradient;
        Observed {
            error_m,
            raceway,
            groove: [-gx, -gy, -gz, tilt_x, tilt_y, sizes[0], sizes[1]],
            dimensions,
        }
    }

    /// Gradient over the place and derivatives over Ro and Re of a point on the plain groove.
    fn plain_slopes(&self, frame: &SectionFrame, [x, y, z]: Vec3) -> (Vec3, [f64; 2]) {
        let (sin, cos) = frame.axis_rad.sin_cos();
        let [ball, height] = frame.ball_m;
        let radius = x.hypot(y);
        let [out, up] = [
            radius - (ball - frame.offset_m * cos),
            z - (height - frame.offset_m * sin),
        ];
        let distance = out.hypot(up);
        let [out, up] = [out / distance, up / distance];
        ([out * x / radius, out * y / radius, up], [-out, out - 1.0])
    }

    /// Gradient over the place and derivatives over Ro and Re of a point on a raceway.
    fn slopes(&self, frame: &SectionFrame, place: Vec3) -> (Vec3, [f64; 2]) {
        let half = DIFFERENCE_M;
        let over = |k: usize| {
            let at = |step: f64| {
                let mut place = place;
                place[k] += step;
                self.distance_in_ring_m(frame, place).0
            };
            (at(half) - at(-half)) / (2.0 * half)
        };
        let size = |k: usize| {
            let at = |step: f64| {
                let mut sizes_m = self.sizes_m;
                sizes_m[k] += step;
                self.distance_in_ring_m(&self.frame_of(sizes_m), place).0
            };
            (at(half) - at(-half)) / (2.0 * half)
        };
        ([0, 1, 2].map(over), [0, 1].map(size))
    }

    /// The ring after a step of its unknowns.
    ///
    /// # Errors
    /// No raceway has such dimensions.
    pub(super) fn moved(&self, case: &Case, step: &[f64]) -> Result<Self, InputError> {
        let mut ring = self.clone();
        (0..3).for_each(|k| ring.pose.shift_m[k] += step[k]);
        (0..2).for_each(|k| ring.pose.tilt_rad[k] += step[3 + k]);
        (0..2).for_each(|k| ring.sizes_m[k] += step[5 + k]);
        for (made, step) in ring.raceways.iter_mut().zip(step[GROOVE..].chunks(RACEWAY)) {
            if let Some(raceway) = made {
                let step = std::array::from_fn(|k| step[k]);
                *raceway = raceway.moved(&case.bearing, step)?;
            }
        }
        Ok(ring)
    }

    /// A point of the machine in the frame of the ring, where it would be as far from the groove with the radii of the
    /// drawing.
    pub(super) fn on_drawn_radii_m(&self, point_m: Vec3) -> Vec3 {
        let place = self.pose.in_ring_m(point_m);
        let [x, y, z] = place;
        let frame = self.frame();
        let (section, _) = self.section(&frame, x.atan2(-y));
        let radius = x.hypot(y);
        let arc = match section.arcs[0].has(radius, z) {
            true => &section.arcs[0],
            false => &section.arcs[1],
        };
        let [out, up] = [
            radius - arc.centre_radius_m,
            z - arc.side.sign() * arc.centre_height_m,
        ];
        let length = out.hypot(up);
        let by = self.distance_in_ring_m(&frame, place).0
            - self.distance_in_ring_m(&self.drawn, place).0;
        let outward = 1.0 + by * out / (length * radius);
        [outward * x, outward * y, z + by * up / length]
    }
}

fn difference(unknown: usize) -> f64 {
    match unknown {
        0 => SPAN_DIFFERENCE_M,
        3 => DIFFERENCE_M,
        _ => DIFFERENCE_RAD,
    }
}
