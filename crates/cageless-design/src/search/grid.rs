//! The structures that are looked at: a coarse grid for the maps, and candidates for which the
//! closed forms leave a chance.

use std::f64::consts::FRAC_PI_2;
use std::ops::RangeInclusive;

use super::evaluation::{Batch, Evaluation, motions};
use super::job::{Interrupted, Job, Numbers, PairSeparation, Task};
use super::measured_separation::MeasuredSeparation;
use super::perturbed_run::Motion;
use super::raceway_layout::{ClosedForms, OperatingPoint, RacewayLayout};
use super::rejection::Cause;
use super::request::{BUDGET, Request, Stage};
use crate::SEPARATION;
use cageless::Bearing;
use cageless::numerics::last_where;
use cageless::raceway::{RacewayForm, RacewayShape, axial_span_limit_m};

/// Cells of the maps along lC and θ, and the fewest of them.
const MAP: [usize; 2] = [30, 18];
const MAP_LEAST: [usize; 2] = [10, 6];
/// Lines of the candidates along θ, and structures on each; the fewest lines.
const CANDIDATES: [usize; 2] = [26, 9];
const LINES_LEAST: usize = 6;
/// Spans at which β0 is tabulated to find the candidates.
const TABLE: usize = 40;

/// One cell of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapCell {
    /// The raceways.
    pub structure: RacewayLayout,
    /// Closed forms; `None` if the bearing cannot carry the raceways.
    pub forms: Option<ClosedForms>,
    /// Critical gap and stress.
    pub spacing: Option<PairSeparation>,
    /// Reason of the rejection; `None` if acceptable.
    pub cause: Option<Cause>,
}

/// Critical gaps over lC and θ at one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedMap {
    /// Speed and load.
    pub point: OperatingPoint,
    /// lC of the columns.
    pub axial_span_m: Vec<f64>,
    /// θ of the rows.
    pub half_angle_rad: Vec<f64>,
    /// Row by row.
    pub cells: Vec<MapCell>,
}

/// Whole micrometres and hundredths of a degree: what a drawing states.
pub(super) fn snapped(structure: &RacewayLayout) -> RacewayLayout {
    RacewayLayout {
        axial_span_m: (structure.axial_span_m * 1e6).round() / 1e6,
        half_angle_rad: ((structure.half_angle_rad.to_degrees() * 100.0).round() / 100.0)
            .to_radians(),
        ..structure.clone()
    }
}

/// `count` values evenly over a range, the ends included.
fn spread(range: RangeInclusive<f64>, count: usize) -> Vec<f64> {
    let (low, high) = range.into_inner();
    if high <= low {
        return vec![low];
    }
    let step = (high - low) / (count - 1) as f64;
    (0..count).map(|k| low + step * k as f64).collect()
}

/// Ranges of lC and θ to look at: what is asked for of all that Eq. (8) and (9) allow. Empty,
/// its end below its begin, if they allow nothing of it.
pub(super) fn ranges(request: &Request, bearing: &Bearing) -> [[f64; 2]; 2] {
    let limit = axial_span_limit_m(bearing) * (1.0 - 1e-9);
    let step = limit / MAP[0] as f64;
    let [low, high] = request
        .axial_span_range_m
        .unwrap_or([step, limit - 0.5 * step]);
    let spans = [low, high.min(limit)];
    // Shapes that Eq. (9) does not bind are sought where it would have them, unless asked for.
    let widest_of = |form: RacewayForm| widest_angle_rad(form, bearing, spans[1]);
    let widest = request
        .forms
        .iter()
        .copied()
        .map(widest_of)
        .fold(0.0, f64::max);
    let usual = widest_of(RacewayForm::default()).min(widest);
    let [low, high] = request
        .half_angle_range_rad
        .unwrap_or([usual / MAP[1] as f64, usual]);
    [spans, [low, high.min(widest)]]
}

/// Cells of the maps of a request along lC and θ: with less than the default budget fewer, in
/// proportion.
fn map_cells(request: &Request) -> [usize; 2] {
    let share = (request.budget as f64 / BUDGET as f64).min(1.0).sqrt();
    std::array::from_fn(|k| MAP_LEAST[k].max((share * MAP[k] as f64).ceil() as usize))
}

/// Largest θ at which a path of the span is possible; it grows with the span. Nothing binds that of a slot.
fn widest_angle_rad(form: RacewayForm, bearing: &Bearing, axial_span_m: f64) -> f64 {
    let widest = FRAC_PI_2 * 0.999;
    if form.shape == RacewayShape::Slot {
        return widest;
    }
    let possible = |half_angle_rad: f64| {
        let structure = RacewayLayout {
            axial_span_m,
            half_angle_rad,
            form,
            section_angle_rad: 0.0,
            centres_rad: vec![0.0],
        };
        structure.raceways(bearing).is_ok()
    };
    last_where(1e-2, widest, 1e-3, possible)
}

/// The maps at the operating points and at the further speeds.
pub(super) fn maps(batch: &mut Batch<'_, '_>) -> Result<Vec<SpeedMap>, Interrupted> {
    let request = batch.request;
    let [spans, angles] = batch.ranges.map(|[low, high]| low..=high);
    let [columns, rows] = map_cells(request);
    let (spans, angles) = (spread(spans, columns), spread(angles, rows));
    let mut cells = vec![];
    for &half_angle_rad in &angles {
        for &axial_span_m in &spans {
            let structure = snapped(&RacewayLayout {
                axial_span_m,
                half_angle_rad,
                form: request.forms[0],
                section_angle_rad: request.section_angles_rad[0],
                centres_rad: request.placements[0].clone(),
            });
            let (forms, cause) = match structure.raceways(batch.bearing) {
                Ok(raceways) => {
                    let forms = batch.closed_forms(&raceways);
                    let least = *batch.gap_range().start();
                    // With rigid flanks all critical gaps are drawn; with elastic ones they take long.
                    let excluded = batch
                        .elastic()
                        .then(|| Cause::of_closed_forms(&forms, least));
                    (Some(forms), excluded.flatten())
                }
                Err(error) => (None, Some(Cause::of_geometry(structure.form.shape, &error))),
            };
            cells.push(MapCell {
                structure,
                forms,
                spacing: None,
                cause,
            });
        }
    }
    let first = request.points[0];
    let speeds = request.map_speeds_rad_s.iter();
    let further = speeds.map(|&inner_speed_rad_s| OperatingPoint {
        inner_speed_rad_s,
        ..first
    });
    let points: Vec<OperatingPoint> = request.points.iter().copied().chain(further).collect();
    let mut maps: Vec<SpeedMap> = points
        .into_iter()
        .map(|point| SpeedMap {
            point,
            axial_span_m: spans.clone(),
            half_angle_rad: angles.clone(),
            cells: cells.clone(),
        })
        .collect();
    fill(batch, &mut maps)?;
    Ok(maps)
}

/// Fills in the separation of a pair in each cell that closed forms leave.
fn separate(batch: &mut Batch<'_, '_>, maps: &mut [SpeedMap]) -> Result<(), Interrupted> {
    let mut jobs = vec![];
    for map in maps.iter() {
        for cell in map.cells.iter().filter(|c| c.cause.is_none()) {
            jobs.push(Job {
                structure: cell.structure.clone(),
                point: map.point,
                task: Task::PairSeparation,
            });
        }
    }
    let mut outcomes = batch.execute(Stage::Map, &jobs)?.into_iter();
    let gap_range = batch.gap_range();
    for cell in maps.iter_mut().flat_map(|m| &mut m.cells) {
        if cell.cause.is_some() {
            continue;
        }
        cell.cause = match (outcomes.next(), &cell.forms) {
            (Some(Ok(Numbers::PairSeparation(spacing))), Some(forms)) => {
                cell.spacing = Some(spacing);
                let of_spacing = || Cause::of_spacing(forms, &spacing, &gap_range, batch.elastic());
                Cause::of_closed_forms(forms, *gap_range.start()).or_else(of_spacing)
            }
            (Some(Err(reason)), _) => Some(Cause::Failed(reason)),
            _ => unreachable!("one spacing per job"),
        };
    }
    Ok(())
}

/// Fills in what each cell comes to.
fn fill(batch: &mut Batch<'_, '_>, maps: &mut [SpeedMap]) -> Result<(), Interrupted> {
    separate(batch, maps)?;
    // What critical gap and stress leave over has to stand the motion of all balls.
    let left = |maps: &[SpeedMap]| -> Vec<(usize, usize)> {
        let open = |m: &SpeedMap| {
            (0..m.cells.len())
                .filter(|&c| m.cells[c].cause.is_none())
                .collect::<Vec<_>>()
        };
        maps.iter()
            .enumerate()
            .flat_map(|(k, m)| open(m).into_iter().map(move |c| (k, c)))
            .collect()
    };
    let mut places = left(maps);
    while places.len() > batch.request.map_cells_simulated() {
        maps.iter_mut().for_each(thin);
        places = left(maps);
    }
    let starts = batch.request.starts;
    let jobs = places.iter().flat_map(|&(k, c)| {
        batch.motion_jobs_at(&maps[k].cells[c].structure, maps[k].point, starts)
    });
    let jobs: Vec<Job> = jobs.collect();
    let outcomes = batch.execute(Stage::Map, &jobs)?;
    for ((k, c), runs) in places.into_iter().zip(outcomes.chunks(starts as usize)) {
        let cell = &mut maps[k].cells[c];
        cell.cause = match (motions(runs), &cell.spacing) {
            (Ok(all), Some(spacing)) => {
                Cause::of_motion(&Motion::mean(&all), spacing, batch.elastic())
            }
            (Err(reason), _) => Some(Cause::Failed(reason)),
            (Ok(_), None) => None,
        };
    }
    Ok(())
}

/// Critical gaps over β0 from maps of the same cells; a cell has the mean over the maps.
pub(super) fn measured(maps: &[SpeedMap]) -> MeasuredSeparation {
    let first = &maps[0];
    let columns = first.axial_span_m.len();
    let of_cell = |k: usize| {
        let forms = first.cells[k].forms?;
        let gaps = maps
            .iter()
            .map(|map| Some(map.cells[k].spacing?.critical_gap_rad));
        let gaps: Option<Vec<f64>> = gaps.collect();
        let gap = gaps?.iter().sum::<f64>() / maps.len() as f64;
        let kept = gap / forms.theoretical_gap_rad;
        (forms.theoretical_gap_rad > 0.0).then_some([forms.fraction(), kept])
    };
    let rows = first.half_angle_rad.iter().enumerate();
    MeasuredSeparation::new(rows.map(|(row, &half_angle_rad)| {
        let cells = row * columns..(row + 1) * columns;
        (half_angle_rad, cells.filter_map(of_cell).collect())
    }))
}

/// Leaves out every second line along the longer side of a map.
fn thin(map: &mut SpeedMap) {
    let columns = map.axial_span_m.len();
    let steps = if columns >= map.half_angle_rad.len() {
        [2, 1]
    } else {
        [1, 2]
    };
    let every = |step: usize| move |k: usize| k.is_multiple_of(step);
    let (column, row) = (every(steps[0]), every(steps[1]));
    let mut k = 0..;
    map.cells.retain(|_| {
        k.next()
            .is_some_and(|k: usize| column(k % columns) && row(k / columns))
    });
    let mut k = 0..;
    map.axial_span_m.retain(|_| k.next().is_some_and(column));
    let mut k = 0..;
    map.half_angle_rad.retain(|_| k.next().is_some_and(row));
}

/// Lines of the candidates: no more than structures that are simulated for the front.
fn lines(request: &Request) -> usize {
    request.front_structures().clamp(LINES_LEAST, CANDIDATES[0])
}

/// Raceways that differ in lC and θ alone.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Family {
    placement: usize,
    form: RacewayForm,
    section_angle_rad: f64,
}

impl Family {
    fn of(evaluation: &Evaluation) -> Self {
        Self {
            placement: evaluation.placement,
            form: evaluation.structure.form,
            section_angle_rad: evaluation.structure.section_angle_rad,
        }
    }
}

/// Candidates of all placements, forms and section angles. Without slip the critical gap is β0, with slip it may
/// fall short of it by what `SEPARATION` allows; so β0 over the steady gap must lie between
/// [`Request::critical_gap_min_fraction`] and 1/(1 − that). In space the maps show by how much it falls short.
pub(super) fn candidates(batch: &Batch<'_, '_>) -> Vec<Evaluation> {
    let [_, [narrowest, widest]] = batch.ranges;
    let mut evaluations = vec![];
    for placement in 0..batch.request.placements.len() {
        for (form, section_angle_rad) in batch.request.sections() {
            let family = Family {
                placement,
                form,
                section_angle_rad,
            };
            for half_angle_rad in spread(narrowest..=widest, lines(batch.request)) {
                evaluations.extend(line(batch, family, half_angle_rad));
            }
        }
    }
    evaluations
}

/// Lines of the candidates halfway to the next on both sides of those on which something is
/// acceptable.
pub(super) fn refine(batch: &Batch<'_, '_>, known: &[Evaluation]) -> Vec<Evaluation> {
    let [_, [low, high]] = batch.ranges;
    let half = (high - low) / (lines(batch.request) - 1) as f64 / 2.0;
    let mut lines: Vec<(Family, f64)> = vec![];
    for e in known.iter().filter(|e| e.objectives.is_some()) {
        for half_angle_rad in [
            e.structure.half_angle_rad - half,
            e.structure.half_angle_rad + half,
        ] {
            // Lines of two neighbours meet but for the rounding to hundredths of a degree.
            let family = Family::of(e);
            let new = lines
                .iter()
                .all(|(f, a)| *f != family || (a - half_angle_rad).abs() > 0.5 * half);
            if new && half > 0.0 && (low..=high).contains(&half_angle_rad) {
                lines.push((family, half_angle_rad));
            }
        }
    }
    lines
        .into_iter()
        .flat_map(|(family, half_angle_rad)| line(batch, family, half_angle_rad))
        .collect()
}

/// The candidates of a family at one angle.
fn line(batch: &Batch<'_, '_>, family: Family, half_angle_rad: f64) -> Vec<Evaluation> {
    let [[shortest, longest], _] = batch.ranges;
    let at = |axial_span_m: f64| {
        snapped(&RacewayLayout {
            axial_span_m,
            half_angle_rad,
            form: family.form,
            section_angle_rad: family.section_angle_rad,
            centres_rad: batch.request.placements[family.placement].clone(),
        })
    };
    let expected = |fraction: f64| match &batch.measured {
        Some(measured) => measured.expected(half_angle_rad, fraction),
        None => fraction,
    };
    let table: Vec<(f64, f64)> = spread(shortest..=longest, TABLE)
        .into_iter()
        .filter_map(|span| {
            let raceways = at(span).raceways(batch.bearing).ok()?;
            Some((span, expected(batch.closed_forms(&raceways).fraction())))
        })
        .collect();
    // A hair inside, or rounding to micrometres would throw out the first.
    let (least, most) = batch.gap_range().into_inner();
    let most = match batch.measured {
        Some(_) => most,
        None => most / (1.0 - SEPARATION.limit()),
    };
    let mut found: Vec<RacewayLayout> = spread(1.005 * least..=most, CANDIDATES[1])
        .into_iter()
        .filter_map(|fraction| span_of_fraction(&table, fraction))
        .map(at)
        .filter(|structure| batch.within(structure))
        .collect();
    // A range of one span has that one.
    if let ([only], true) = (table.as_slice(), found.is_empty()) {
        found.push(at(only.0));
    }
    found.dedup();
    found
        .into_iter()
        .map(|structure| Evaluation::new(batch, structure, family.placement))
        .collect()
}

/// Span at which the tabulated fraction, which grows with it, reaches `fraction`.
fn span_of_fraction(table: &[(f64, f64)], fraction: f64) -> Option<f64> {
    table.windows(2).find_map(|pair| {
        let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
        (y0 <= fraction && fraction < y1).then(|| x0 + (fraction - y0) / (y1 - y0) * (x1 - x0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::structure;

    #[test]
    fn values_are_spread_from_end_to_end() {
        assert_eq!(spread(1.0..=3.0, 5), [1.0, 1.5, 2.0, 2.5, 3.0]);
        assert_eq!(spread(2.0..=2.0, 5), [2.0]);
        let found = snapped(&RacewayLayout {
            axial_span_m: 5.123_456e-3,
            half_angle_rad: 25.123_456f64.to_radians(),
            form: RacewayForm::default(),
            section_angle_rad: 0.0,
            centres_rad: vec![0.3],
        });
        assert!((found.axial_span_m - 5.123e-3).abs() < 1e-12);
        assert!((found.half_angle_rad.to_degrees() - 25.12).abs() < 1e-9);
        assert_eq!(found.centres_rad, [0.3]);
        let table = [(1.0, 10.0), (2.0, 20.0), (4.0, 30.0)];
        assert_eq!(span_of_fraction(&table, 10.0), Some(1.0));
        assert_eq!(span_of_fraction(&table, 25.0), Some(3.0));
        assert_eq!(span_of_fraction(&table, 30.0), None);
        assert_eq!(span_of_fraction(&table, 9.0), None);
    }

    /// All that Eq. (8) and (9) allow unless less is asked for.
    #[test]
    fn ranges_are_what_is_possible_of_what_is_asked_for() {
        let case = structure(5.1, 25.2);
        let limit = axial_span_limit_m(&case.bearing);
        let mut request = Request::from_case(&case);
        let [spans, angles] = ranges(&request, &case.bearing);
        assert!((spans[0] / limit - 1.0 / 30.0).abs() < 1e-6);
        assert!((spans[1] / limit - 59.0 / 60.0).abs() < 1e-6);
        assert!((angles[0] * 18.0 - angles[1]).abs() < 1e-12);
        let possible = |half_angle_rad| {
            RacewayLayout {
                axial_span_m: spans[1],
                half_angle_rad,
                form: RacewayForm::default(),
                section_angle_rad: 0.0,
                centres_rad: vec![0.0],
            }
            .raceways(&case.bearing)
            .is_ok()
        };
        assert!(possible(angles[1]) && !possible(angles[1] + 1.1e-3));
        request.axial_span_range_m = Some([4e-3, 1.0]);
        request.half_angle_range_rad = Some([0.2, 0.3]);
        let [spans, angles] = ranges(&request, &case.bearing);
        assert!(spans[0] == 4e-3 && spans[1] < limit && spans[1] > 0.999_999 * limit);
        assert_eq!(angles, [0.2, 0.3]);
    }

    /// On each line θ is the same, and β0 over the steady gap rises evenly from what spreads the
    /// balls to where evenly spaced balls collide; closer lines lie halfway to the next.
    #[test]
    fn candidates_fill_what_the_closed_forms_leave() {
        let case = structure(5.1, 25.2);
        let mut request = Request::from_case(&case);
        request.placements = vec![vec![0.0], vec![0.5]];
        request.half_angle_range_rad = Some([20f64.to_radians(), 25f64.to_radians()]);
        let batch = Batch {
            ranges: ranges(&request, &case.bearing),
            request: &request,
            execute: &mut |_, _| unreachable!("nothing to compute"),
            bearing: &case.bearing,
            seats: vec![],
            row_seats: vec![],
            film_lag_rad: 0.0,
            measured: None,
            simulations: 0,
        };
        let found = candidates(&batch);
        assert_eq!(found.len(), 2 * 26 * 9);
        let line = &found[26 * 9 + 5 * 9..26 * 9 + 6 * 9];
        for (k, e) in line.iter().enumerate() {
            assert_eq!(
                (e.placement, e.structure.centres_rad.as_slice()),
                (1, &[0.5][..])
            );
            // Five of 25 steps of 0.2°.
            assert!((e.structure.half_angle_rad.to_degrees() - 21.0).abs() < 1e-9);
            let (low, high) = (1.005 * 0.8, 1.0 / 0.95);
            let expected = low + (high - low) * k as f64 / 8.0;
            let fraction = e.forms.unwrap().fraction();
            assert!(
                (fraction - expected).abs() < 3e-3,
                "{k}: {fraction} {expected}"
            );
            assert!(e.rejection.is_none() && e.objectives.is_none());
        }
        let mut known = found;
        known[9 * 5].objectives = Some([1.0; 7]);
        known[9 * 25 + 3].objectives = Some([1.0; 7]);
        let lines: Vec<(usize, f64)> = refine(&batch, &known)
            .chunks(9)
            .map(|line| {
                let angle = line[0].structure.half_angle_rad.to_degrees();
                (line[0].placement, (angle * 100.0).round() / 100.0)
            })
            .collect();
        // Nothing beyond the end of the range.
        assert_eq!(lines, [(0, 20.9), (0, 21.1), (0, 24.9)]);
        assert!(refine(&batch, &[]).is_empty());
    }

    /// Every form has candidates of its own, and closer lines where they are acceptable.
    #[test]
    fn candidates_of_every_form() {
        let case = structure(5.1, 25.2);
        let mut request = Request::from_case(&case);
        request.half_angle_range_rad = Some([0.4, 0.45]);
        let mut steady = RacewayForm::default();
        steady.shape = RacewayShape::Steady;
        request.forms.push(steady);
        let batch = Batch {
            ranges: ranges(&request, &case.bearing),
            request: &request,
            execute: &mut |_, _| unreachable!("nothing to compute"),
            bearing: &case.bearing,
            seats: vec![],
            row_seats: vec![],
            film_lag_rad: 0.0,
            measured: None,
            simulations: 0,
        };
        let mut found = candidates(&batch);
        let [quartic, of_steady] = [26 * 9 - 1, 26 * 9].map(|k| &found[k].structure);
        assert_eq!(
            [quartic.form, of_steady.form],
            [RacewayForm::default(), steady]
        );
        // At one θ and β0 the steady raceway has another lC.
        let spans = [0, 26 * 9].map(|k| found[k].structure.axial_span_m);
        let fractions = [0, 26 * 9].map(|k| found[k].forms.unwrap().fraction());
        assert!((fractions[0] / fractions[1] - 1.0).abs() < 3e-3);
        assert!((spans[0] - spans[1]).abs() > 0.05e-3, "{spans:?}");
        // Half a line beside that of one form is none of the other's.
        found[0].objectives = Some([1.0; 7]);
        found[26 * 9].objectives = Some([1.0; 7]);
        let forms: Vec<_> = refine(&batch, &found)
            .chunks(9)
            .map(|line| line[0].structure.form)
            .collect();
        assert_eq!(forms, [RacewayForm::default(), steady]);
    }
}
