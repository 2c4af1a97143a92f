//! The outside of the ring: cylinder and side faces.

use std::f64::consts::PI;

use cageless::surface::OuterRing;

use super::brep::{Curve, Solid, Surface, Use, along, back, circle, radial};

impl Solid {
    /// The cylinder outside, in halves, and the side faces with their bores.
    pub(super) fn outside(&mut self, ring: &OuterRing, start_rad: f64, rims: &[[usize; 2]]) {
        let d = ring.dimensions;
        let (radius_m, half) = (d.outer_ring_outer_radius_m, d.outer_ring_width_m / 2.0);
        let heights = [half, -half];
        let corners = [start_rad, start_rad + PI].map(|psi| {
            let e = radial(psi);
            heights.map(|z| self.vertex([radius_m * e[0], radius_m * e[1], z]))
        });
        let lines =
            corners.map(|[upper, lower]| self.edge(Curve::Line([0.0, 0.0, 1.0]), lower, upper));
        let mut half_circles = |from: usize, to: usize| {
            [0, 1].map(|k| {
                let circle = circle(radius_m, heights[k]);
                self.edge(circle, corners[from][k], corners[to][k])
            })
        };
        let arcs = [half_circles(0, 1), half_circles(1, 0)];
        for half in 0..2 {
            let cylinder = Surface::Cylinder {
                radius_m,
                reference: radial(start_rad + PI * (half as f64 + 1.5)),
            };
            // Outwards, t, k, −t, −k go around counter-clockwise.
            let around = [
                along(arcs[half][1]),
                along(lines[1 - half]),
                back(arcs[half][0]),
                back(lines[half]),
            ];
            self.face(cylinder, true, &[&around]);
        }
        let outer = |k: usize| arcs.map(|pair| pair[k]);
        let upper = outer(0).map(along);
        let lower: Vec<Use> = outer(1).into_iter().rev().map(back).collect();
        let bore_above: Vec<Use> = rims.iter().rev().map(|rim| back(rim[0])).collect();
        let bore_below: Vec<Use> = rims.iter().map(|rim| along(rim[1])).collect();
        self.face(Surface::Plane(half), true, &[&upper, &bore_above]);
        self.face(Surface::Plane(-half), false, &[&lower, &bore_below]);
    }
}
