//! The groove of one row around a raceway, section by section as drawings need it.

use super::recess::{Edge, Recess};
use super::section_frame::SectionFrame;
use super::{Meridian, Side};
use crate::bearing::Bearing;
use crate::raceway::Raceway;

/// The groove of a row, with a raceway or plain; needs none of the ring's outer dimensions.
#[derive(Debug, Clone)]
pub struct DrawnGroove<'a> {
    raceway: Option<&'a Raceway>,
    frame: SectionFrame,
    recess: Option<Recess>,
}

/// Shares of the points of one side that lie on the groove and on the rounded edge of a slot; the wall has two, the
/// floor the rest.
const SHARES: [f64; 2] = [0.45, 0.35];

impl<'a> DrawnGroove<'a> {
    /// Groove of a bearing whose balls press the outer ring to the side of this sign along the axis.
    pub fn new(bearing: &Bearing, raceway: Option<&'a Raceway>, contact_sign: f64) -> Self {
        let axis_rad = raceway.map_or(bearing.contact_angle_rad(), Raceway::section_angle_rad);
        let mut frame = SectionFrame::new(bearing, axis_rad);
        if contact_sign < 0.0 {
            frame = frame.mirrored();
        }
        Self {
            raceway,
            frame,
            recess: raceway.and_then(|r| Recess::new(&frame, 0, r, r.slot()?).ok()),
        }
    }

    /// The slot, if the raceway is one whose walls do not meet.
    pub fn recess(&self) -> Option<&Recess> {
        self.recess.as_ref()
    }

    /// Section at ψ whose arcs a ball touches that rests in the groove, in a slot on its edges.
    pub fn meridian(&self, angle_rad: f64) -> Meridian {
        match self.raceway.filter(|raceway| raceway.contains(angle_rad)) {
            Some(raceway) => Meridian::new(
                &self.frame.deeper(raceway.depth_at_m(angle_rad)),
                angle_rad,
                raceway.contact_angle_rad(raceway.local_angle_rad(angle_rad)),
            ),
            None => Meridian::new(&self.frame, angle_rad, [0.0; 2]),
        }
    }

    /// Points at ψ from the lower to the upper shoulder, so many on each side of the apex, which both
    /// sides have. Within a slot they go down one edge and wall and up the other; at its ends those of edges and
    /// walls are square to the edge, beside ψ.
    pub fn points(&self, angle_rad: f64, per_side: usize) -> Vec<[f64; 3]> {
        let inside = self.raceway.filter(|raceway| raceway.contains(angle_rad));
        if let (Some(raceway), Some(recess)) = (inside, &self.recess) {
            let edges = recess.edges_at(raceway.local_angle_rad(angle_rad));
            return self.across(recess, &edges, per_side);
        }
        let section = match self.raceway.and_then(Raceway::slot) {
            Some(_) => Meridian::new(&self.frame, angle_rad, [0.0; 2]),
            None => self.meridian(angle_rad),
        };
        let of = |side: Side, step: usize| {
            let arc = section.arc(side);
            let eta = between(arc.valley_rad(), arc.shoulder_rad(), step, per_side);
            arc.point(angle_rad, eta).position_m
        };
        let lower = (0..per_side).rev().map(|step| of(Side::Lower, step));
        lower
            .chain((0..per_side).map(|step| of(Side::Upper, step)))
            .collect()
    }

    fn across(&self, recess: &Recess, edges: &[Edge; 2], per_side: usize) -> Vec<[f64; 3]> {
        let [groove, rounded] = SHARES.map(|share| (share * per_side as f64) as usize);
        let floor = per_side - groove - rounded - 2;
        let half = |side: Side| {
            let edge = &edges[usize::from(side == Side::Upper)];
            let section = Meridian::new(&self.frame, edge.angle_rad, [0.0; 2]);
            let arc = section.arc(side);
            let (shoulder, end) = (arc.shoulder_rad(), side.sign() * edge.groove_rad);
            let share = |k, count| between(0.0, 1.0, k, count);
            let on_groove = |k| {
                let eta = shoulder + (end - shoulder) * share(k, groove);
                arc.point(edge.angle_rad, eta).position_m
            };
            let mut points: Vec<[f64; 3]> = (0..groove).map(on_groove).collect();
            points.extend((0..rounded).map(|k| edge.arc_m(share(k, rounded))));
            points.extend([0.0, 1.0].map(|share| edge.wall_m(share)));
            points.extend((0..floor).map(|k| recess.floor_m(edges, share(k, floor) / 2.0, side)));
            points
        };
        let mut points = half(Side::Lower);
        points.extend(half(Side::Upper).into_iter().rev());
        points
    }
}

/// Value k of `count` from one end to the other.
fn between(from: f64, to: f64, k: usize, count: usize) -> f64 {
    from + (to - from) * k as f64 / (count - 1) as f64
}
