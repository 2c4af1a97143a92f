//! Friction from measured points of μ over the sliding speed.

use super::friction_table::{FrictionTable, PIECES_MAX, Piece, PieceLanes};
use super::parameters::FrictionParameters;
use super::law::{Law, LawConstants, LawLanes, knee};
use crate::numerics::exponential::tanh;
use crate::numerics::lanes::{LANES, Lanes};

/// μ(|ΔV|)·tanh(ΔV/scale)·N with μ from a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Table {
    pieces: [Piece; PIECES_MAX],
    coefficient: f64,
    inverse_regularisation_speed: f64,
}

/// Force and slope with the piece of the table that holds ΔV.
#[inline(always)]
fn force(piece: &Piece, inverse_regularisation_speed: f64, sliding_m_s: f64, normal_n: f64) -> [f64; 2] {
    let [mu, mu_slope] = piece.coefficient(sliding_m_s.abs());
    let knee = tanh(sliding_m_s * inverse_regularisation_speed);
    let slope = mu * (1.0 - knee * knee) * inverse_regularisation_speed + mu_slope * knee.abs();
    [mu * knee * normal_n, slope * normal_n]
}

/// A function of |ΔV| that is zero at the rows of the table, with one sign in each piece and the
/// other in the next.
fn edge(starts: impl Iterator<Item = f64>, speed: f64) -> f64 {
    let (mut sign, mut nearest) = (1.0, f64::INFINITY);
    for start in starts.filter(|start| *start > 0.0) {
        let beyond = speed - start;
        sign = if beyond > 0.0 { -sign } else { sign };
        nearest = beyond.abs().min(nearest);
    }
    sign * nearest
}

impl Law for Table {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let speed = sliding_m_s.abs();
        let piece = self.pieces.iter().rfind(|p| speed >= p.start);
        let piece = piece.unwrap_or(&self.pieces[0]);
        force(piece, inverse_knee_s_m, sliding_m_s, normal_n)
    }

    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        Some(edge(self.pieces.iter().map(|p| p.start), sliding_m_s.abs()))
    }

    knee!();
}

impl LawConstants for Table {
    const NAME: &'static str = "table";

    /// Without a table, which a checked case has, there is no friction.
    fn new(parameters: &FrictionParameters, _stick_gain_n_s_m: f64) -> Self {
        let mut pieces = [Piece::BEYOND; PIECES_MAX];
        pieces[0] = Piece::default();
        Self {
            pieces: parameters.table.as_ref().map_or(pieces, FrictionTable::pieces),
            coefficient: parameters.coefficient,
            inverse_regularisation_speed: 1.0 / parameters.regularisation_speed_m_s,
        }
    }

    fn describe(parameters: &FrictionParameters) -> String {
        let points = parameters.table.as_ref().map_or(0, |t| t.points().len());
        format!(
            "table of {points} points, {} to {}",
            Self::coefficient_max(parameters),
            parameters.coefficient
        )
    }

    fn coefficient_max(parameters: &FrictionParameters) -> f64 {
        let table = parameters.table.as_ref();
        table.map_or(parameters.coefficient, FrictionTable::coefficient_max)
    }

    fn coefficient_at_rest(parameters: &FrictionParameters) -> f64 {
        let table = parameters.table.as_ref();
        table.map_or(parameters.coefficient, |table| table.coefficient(0.0)[0])
    }

    fn steepest_fall(parameters: &FrictionParameters) -> f64 {
        parameters.table.as_ref().map_or(0.0, FrictionTable::steepest_fall)
    }
}

/// [`Table`] of each lane.
#[derive(Debug, Clone)]
pub(crate) struct TableLanes {
    /// Pieces of the tables, as many as the longest table of a lane has.
    pieces: Vec<PieceLanes>,
    coefficient: Lanes,
    inverse_regularisation_speed: Lanes,
}

/// [`Table`] of one lane. A table is too large to be copied for every contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TableLane<'a> {
    table: &'a TableLanes,
    lane: usize,
}

impl LawLanes for TableLanes {
    type Constants = Table;
    type Law<'a> = TableLane<'a>;
    type Evaluated<'a> = &'a Self;

    #[inline(always)]
    fn lane(&self, lane: usize) -> TableLane<'_> {
        TableLane { table: self, lane }
    }

    #[inline(always)]
    fn evaluated(&self, _: [&Lanes; 2]) -> &Self {
        self
    }

    fn filled(value: impl Fn(usize) -> Table) -> Self {
        let used = |k: usize| (0..LANES).any(|l| value(l).pieces[k].start.is_finite());
        let count = (0..PIECES_MAX).filter(|k| used(*k)).count();
        let pieces = (0..count).map(|k| PieceLanes::from_fn(|lane| value(lane).pieces[k]));
        let all = |of: &dyn Fn(&Table) -> f64| Lanes(std::array::from_fn(|lane| of(&value(lane))));
        Self {
            pieces: pieces.collect(),
            coefficient: all(&|t| t.coefficient),
            inverse_regularisation_speed: all(&|t| t.inverse_regularisation_speed),
        }
    }
}

impl Law for TableLane<'_> {
    #[inline(always)]
    fn force_with_knee(&self, sliding_m_s: f64, normal_n: f64, inverse_knee_s_m: f64) -> [f64; 2] {
        let (pieces, speed) = (&self.table.pieces, sliding_m_s.abs());
        let mut at = 0;
        for k in 1..pieces.len() {
            at = if speed >= pieces[k].start.0[self.lane] {
                k
            } else {
                at
            };
        }
        let piece = pieces[at].get(self.lane);
        force(&piece, inverse_knee_s_m, sliding_m_s, normal_n)
    }

    fn edge(&self, sliding_m_s: f64) -> Option<f64> {
        let starts = self.table.pieces.iter().map(|p| p.start.0[self.lane]);
        Some(edge(starts, sliding_m_s.abs()))
    }

    #[inline(always)]
    fn coefficient(&self) -> f64 {
        self.table.coefficient.0[self.lane]
    }

    #[inline(always)]
    fn inverse_regularisation_speed(&self) -> f64 {
        self.table.inverse_regularisation_speed.0[self.lane]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dry() -> FrictionTable {
        FrictionTable::new(vec![[0.01, 0.3], [0.1, 0.24], [0.3, 0.26], [0.5, 0.2]]).unwrap()
    }

    /// Through the points, monotone between them, constant beyond, with the slope its derivative.
    #[test]
    fn measured_points_are_kept_and_not_overshot() {
        let table = dry();
        for pair in table.points().windows(2) {
            let [[v0, mu0], [v1, mu1]] = [pair[0], pair[1]];
            assert!((table.coefficient(v0)[0] - mu0).abs() < 1e-15);
            let mut last = mu0;
            for k in 1..=100 {
                let v = v0 + (v1 - v0) * f64::from(k) / 100.0;
                let [mu, slope] = table.coefficient(v);
                assert!((mu - last) * (mu1 - mu0) >= -1e-18, "{v}");
                last = mu;
                let h = 1e-7;
                let expected =
                    (table.coefficient(v + h)[0] - table.coefficient(v - h)[0]) / (2.0 * h);
                assert!((slope - expected).abs() < 1e-4, "{v}: {slope} {expected}");
            }
        }
        assert_eq!(table.coefficient(0.0), [0.3, 0.0]);
        assert_eq!(table.coefficient(7.0), [0.2, 0.0]);
        assert_eq!(table.coefficient_max(), 0.3);
        let speeds = (0..=6000).map(|k| f64::from(k) * 1e-4);
        let steepest = speeds.fold(0.0_f64, |most, v| most.max(-table.coefficient(v)[1]));
        assert!((table.steepest_fall() / steepest - 1.0).abs() < 0.02);
    }

    /// Lanes of different tables each have the bits of their own table.
    #[test]
    fn each_lane_has_its_table() {
        let short = FrictionTable::new(vec![[0.0, 0.1], [1.0, 0.05]]).unwrap();
        let (dry, own) = (dry(), |t: &FrictionTable| {
            let parameters = FrictionParameters {
                table: Some(t.clone()),
                ..FrictionParameters::smooth(t.coefficient_fast(), 0.02)
            };
            Table::new(&parameters, 0.0)
        });
        let tables = [own(&dry), own(&short)];
        let lanes = TableLanes::filled(|lane| tables[lane % 2]);
        for slip in [-2.0, -0.2, -0.05, 0.0, 1e-3, 0.01, 0.1, 0.4, 0.5, 3.0] {
            for (lane, table) in tables.iter().enumerate() {
                let found = lanes.lane(lane).force(slip, 100.0);
                assert_eq!(found, table.force(slip, 100.0), "{slip} {lane}");
            }
        }
    }

    #[test]
    fn impossible_tables_are_refused() {
        for points in [
            vec![],
            vec![[0.0, 0.1]],
            vec![[0.0, 0.1], [0.0, 0.2]],
            vec![[-0.1, 0.1], [0.0, 0.2]],
            vec![[0.0, 0.1], [f64::NAN, 0.2]],
            vec![[0.0, 0.1], [0.1, 2.1]],
            vec![[0.0, -0.1], [0.1, 0.1]],
            (0..40).map(|k| [f64::from(k), 0.1]).collect(),
        ] {
            assert!(FrictionTable::new(points.clone()).is_err(), "{points:?}");
        }
    }
}
