//! The edges of f over an attempted step.

use super::system::System;

/// Values up to this are on neither side of an edge: 1e-13 m of a contact, what rounding leaves of
/// its depth many times over and far less than what its force feels.
const BAND: f64 = 1e-8;
/// Samples closer together than this share of the step do not interpolate.
const APART: f64 = 1e-9;
/// The second stage follows the tangent alone; it says on which side of an edge a step is, but not
/// how it turns.
const TANGENT: usize = 1;

/// Values of [`System::edges`] at the start, the stages and the end of an attempted step.
#[derive(Debug, Clone, Default)]
pub(super) struct Edges {
    /// Sample after sample, in the order of evaluation.
    values: Vec<f64>,
    /// Time of each sample as a share of the step.
    nodes: Vec<f64>,
    /// The samples in the order of time.
    order: Vec<usize>,
    /// Sign of each edge over the step so far; 0 where it was on neither side.
    sides: Vec<f64>,
    /// Whether there are such.
    undecided: bool,
    /// Least and greatest distance of each edge over the step.
    ranges: Vec<[f64; 2]>,
}

/// Whether a value lies beyond the edge.
fn beyond(side: f64, value: f64) -> bool {
    side * value < -BAND
}

impl Edges {
    /// Starts at the state of the last evaluation.
    pub(super) fn start<S: System>(&mut self, system: &S, y: &[f64]) {
        self.values.clear();
        system.edges(y, &mut self.values);
        self.sides.resize(self.values.len(), 0.0);
        self.again();
    }

    /// Starts another attempt from the same state.
    pub(super) fn again(&mut self) {
        self.values.truncate(self.sides.len());
        self.nodes.clear();
        self.nodes.push(0.0);
        self.order.clear();
        self.order.push(0);
        self.sides.fill(0.0);
        self.undecided = true;
        self.decide(0);
    }

    /// Takes sides where a sample is the first beyond the band.
    fn decide(&mut self, sample: usize) {
        if !self.undecided {
            return;
        }
        self.undecided = false;
        let values = &self.values[sample * self.sides.len()..];
        for (side, value) in self.sides.iter_mut().zip(values) {
            if *side == 0.0 && value.abs() > BAND {
                *side = value.signum();
            }
            self.undecided |= *side == 0.0;
        }
    }

    /// Takes the state of the last evaluation at a share `node` of the step; returns the share
    /// at which the first edge is crossed, if one is.
    pub(super) fn crossed<S: System>(&mut self, system: &S, y: &[f64], node: f64) -> Option<f64> {
        let (count, sample) = (self.sides.len(), self.nodes.len());
        if count == 0 {
            return None;
        }
        system.edges(y, &mut self.values);
        self.nodes.push(node);
        let later = self.order.partition_point(|k| self.nodes[*k] <= node);
        self.order.insert(later, sample);
        let values = &self.values[sample * count..];
        let any = (self.sides.iter().zip(values)).fold(false, |any, (s, v)| any | beyond(*s, *v));
        if any {
            let crossed = (0..count).filter(|edge| beyond(self.sides[*edge], values[*edge]));
            return crossed.map(|edge| self.zero(edge)).reduce(f64::min);
        }
        self.decide(sample);
        None
    }

    /// Time and value of an edge at a sample, by the order of time.
    fn sample(&self, edge: usize, place: usize) -> [f64; 2] {
        let sample = self.order[place];
        [
            self.nodes[sample],
            self.values[sample * self.sides.len() + edge],
        ]
    }

    /// Where an edge is first crossed, by the parabola through the samples around.
    fn zero(&self, edge: usize) -> f64 {
        let places = 0..self.order.len();
        let at = |place: usize| self.sample(edge, place);
        let behind = places
            .clone()
            .position(|p| beyond(self.sides[edge], at(p)[1]));
        let behind = behind.unwrap_or(places.end - 1).max(1);
        let ([t0, g0], [t1, g1]) = (at(behind - 1), at(behind));
        if g0 * g1 >= 0.0 || t1 - t0 < APART {
            return 0.5 * (t0 + t1);
        }
        let slope = (g1 - g0) / (t1 - t0);
        let linear = t0 - g0 / slope;
        let before = (0..behind).rev().find(|p| at(*p)[0] < t0 - APART);
        let third = before.or_else(|| places.clone().skip(behind).find(|p| at(*p)[0] > t1 + APART));
        let Some([t2, g2]) = third.map(at) else {
            return linear;
        };
        let bend = ((g2 - g1) / (t2 - t1) - slope) / (t2 - t0);
        let root = (0..4).fold(linear, |t, _| t0 - g0 / (slope + bend * (t - t1)));
        if root > t0 && root < t1 { root } else { linear }
    }

    /// Time at which an edge is deepest that the step crosses and crosses back between its
    /// samples, by the parabolas through three of them; the first if there are several.
    pub(super) fn hidden(&mut self) -> Option<f64> {
        let count = self.sides.len();
        self.ranges.clear();
        self.ranges.resize(count, [f64::INFINITY, 0.0]);
        for sample in self.values.chunks_exact(count.max(1)) {
            for ([least, most], value) in self.ranges.iter_mut().zip(sample) {
                let distance = value.abs();
                *least = if distance < *least { distance } else { *least };
                *most = if distance > *most { distance } else { *most };
            }
        }
        // A step that comes as near as it moves may turn beyond an edge.
        let near = (0..count).filter(|edge| {
            let [least, most] = self.ranges[*edge];
            least < most - least
        });
        near.filter_map(|edge| self.turn(edge)).reduce(f64::min)
    }

    /// [`Self::hidden`] of one edge.
    fn turn(&self, edge: usize) -> Option<f64> {
        let places = (0..self.order.len()).filter(|p| self.order[*p] != TANGENT);
        let mut samples = places.map(|p| self.sample(edge, p));
        let ([mut t0, mut g0], [mut t1, mut g1]) = (samples.next()?, samples.next()?);
        for [t2, g2] in samples {
            if t1 - t0 > APART && t2 - t1 > APART {
                let slope = (g1 - g0) / (t1 - t0);
                let bend = ((g2 - g1) / (t2 - t1) - slope) / (t2 - t0);
                let top = 0.5 * (t0 + t1 - slope / bend);
                let value = g0 + (top - t0) * (slope + bend * (top - t1));
                if top > t0 && top < t2 && beyond(self.sides[edge], value) {
                    return Some(top);
                }
            }
            ([t0, g0], [t1, g1]) = ([t1, g1], [t2, g2]);
        }
        None
    }
}
