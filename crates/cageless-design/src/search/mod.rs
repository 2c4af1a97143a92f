//! Search for the discrete raceway: which spans and angles, where and how many.
//!
//! In stages, each looking only at what the one before left over:
//! 1. a **map**: closed forms and critical gap on a coarse grid over all that Zhao 2022,
//!    Eq. (8) and (9), allow, at every speed;
//! 2. **candidates**: for each angle the spans whose β0 lies between what spreads the balls and
//!    the depth at which evenly spaced balls collide; critical gap and stress there;
//! 3. **motion**: runs of all balls from uneven starts for what is left; then the same between
//!    the lines of the candidates on which something is acceptable;
//! 4. the Pareto front, the structure nearest to the best in everything, and COBYLA from
//!    there;
//! 5. more starts for the recommendation, which gives way to the next where they reject it, and for the
//!    case's own raceway.
//!
//! With a film the steady gap has the lag of a free ball, and the critical gap has to be 1.0 to 1.1 times as much.
//!
//! Nothing here starts a thread: batches of [`Job`]s go to the caller, who runs them in any
//! order. The same case and seed lead to the same result. Derivations: `docs/theory/design.md`.
//!
//! ```
//! use cageless_design::search::placements;
//!
//! // Places of a single raceway, every 15° within ±90°, the nearest to the load first.
//! let quarter = std::f64::consts::FRAC_PI_2;
//! let places = placements([-quarter, quarter], 1);
//! assert_eq!(places.len(), 13);
//! assert!(places[0][0].abs() < 1e-12);
//! ```

mod axial;
mod axial_runs;
mod budget;
mod evaluation;
mod film_lag;
mod grid;
mod job;
mod local_optimisation;
mod measured_separation;
mod oil;
mod pareto;
mod perturbed_run;
mod placement;
mod raceway_layout;
mod rehearsal;
mod rejection;
mod request;

pub use crate::critical_gap::NEIGHBOURS_WIDER;
pub use axial::AxialSeparation;
pub use budget::BUDGET_LEAST;
pub use evaluation::{Confirmed, Evaluation, Role, Statistics};
pub use grid::{MapCell, SpeedMap};
#[cfg(test)]
pub(crate) use job::Task;
pub use job::{Interrupted, Job, Numbers, Outcome, PairSeparation, run_here, run_jobs};
pub use pareto::ObjectiveScale;
pub(crate) use pareto::pareto_front;
#[cfg(test)]
pub(crate) use perturbed_run::UnevenStart;
#[cfg(test)]
pub(crate) use perturbed_run::perturbed_runs;
pub use perturbed_run::{BUNCHED_TURNS, Motion, VALUES};
pub use placement::placements;
pub use raceway_layout::{ClosedForms, OperatingPoint, RacewayLayout};
pub use rehearsal::{ExpectedRuns, expected_runs};
pub use rejection::{Cause, Rejection};
pub(crate) use request::Execute;
pub use request::{BUDGET, CONFIRMING_STARTS, Request, SEED, Stage};

use std::ops::RangeInclusive;

use crate::{AXIAL_LAG, BOTH_NEIGHBOURS, CauseKind, LAG, SEPARATION, pressure_at_rest_pa};
use cageless::Case;
use cageless::InputError;
use cageless::contact::STRESS_LIMIT_PA;
use cageless::equilibrium::EquilibriumError;
use cageless::raceway::axial_span_limit_m;
use evaluation::Batch;

/// Error of a search.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SearchError {
    /// Interrupted by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// No raceway can help: the operating range itself is impossible.
    #[error("{0}")]
    Impossible(String),
    /// The case is impossible.
    #[error(transparent)]
    Case(#[from] InputError),
}

/// Result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The request.
    pub request: Request,
    /// Maps: one per operating point, then one per further speed.
    pub maps: Vec<SpeedMap>,
    /// Every candidate, with numbers or the reason of its rejection; that of the
    /// optimiser last, if it found a better one.
    pub evaluations: Vec<Evaluation>,
    /// Index of the recommended structure.
    pub recommended: Option<usize>,
    /// From more starts, in this order: candidates that these reject, the recommendation, the case's own
    /// structure.
    pub confirmed: Vec<Confirmed>,
}

/// Structures that a cause excludes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Excluded {
    /// Kind of the cause.
    pub kind: &'static CauseKind,
    /// Number of structures.
    pub count: usize,
}

impl Found {
    /// The confirmed structures of a role.
    pub fn of_role(&self, role: Role) -> impl Iterator<Item = &Confirmed> {
        self.confirmed.iter().filter(move |c| c.role == role)
    }

    /// Rejects the recommendation: nothing is recommended then.
    pub fn reject_recommended(&mut self, rejection: &Rejection) {
        let Some(k) = self.recommended.take() else {
            return;
        };
        let confirmed = self.confirmed.iter_mut();
        for one in confirmed.filter(|c| c.role == Role::Recommended) {
            one.role = Role::Unconfirmed;
            one.evaluation.reject_with(rejection);
        }
        self.evaluations[k].reject_with(rejection);
    }

    /// The structures on the Pareto front.
    pub fn front(&self) -> impl Iterator<Item = &Evaluation> {
        self.evaluations.iter().filter(|e| e.on_front)
    }

    /// Causes that exclude cells of the maps at the operating points and candidates.
    fn causes(&self) -> impl Iterator<Item = &Cause> {
        let points = self.request.points.len();
        let cells = self.maps[..points].iter().flat_map(|m| &m.cells);
        let cells = cells.filter_map(|c| c.cause.as_ref());
        let candidates = self.evaluations.iter();
        cells.chain(candidates.filter_map(|e| e.rejection.as_ref().map(|r| &r.cause)))
    }

    /// How many cells of the maps at the operating points and candidates each
    /// cause excludes, those that exclude most first.
    pub fn rejections(&self) -> Vec<Excluded> {
        let kinds = Cause::kinds();
        let mut all: Vec<Excluded> = kinds.map(|kind| Excluded { kind, count: 0 }).collect();
        for cause in self.causes() {
            if let Some(excluded) = all.iter_mut().find(|e| e.kind == cause.kind()) {
                excluded.count += 1;
            }
        }
        all.retain(|excluded| excluded.count > 0);
        all.sort_by_key(|excluded| std::cmp::Reverse(excluded.count));
        all
    }

    /// Message of the first run that stopped.
    pub fn first_failure(&self) -> Option<&str> {
        self.causes().find_map(|cause| match cause {
            Cause::Failed(reason) => Some(reason.as_str()),
            _ => None,
        })
    }

    /// The rejected candidate that misses by least at some operating point, of those of which most is known: where some
    /// were moved, of these.
    pub fn closest(&self) -> Option<&Evaluation> {
        let excess = |e: &Evaluation| {
            // What the closed forms exclude lies at the edge of the candidate range by construction.
            e.rejection
                .as_ref()
                .filter(|r| r.point.is_some())
                .map_or(f64::INFINITY, |r| r.cause.excess())
        };
        self.evaluations
            .iter()
            .filter(|e| excess(e).is_finite())
            .min_by(|a, b| {
                let unmoved = [a, b].map(|e| !e.has_moved());
                let known = unmoved[0].cmp(&unmoved[1]);
                known.then(excess(a).total_cmp(&excess(b)))
            })
    }
}

/// Searches. The seed is the case's.
///
/// # Errors
/// The operating range is impossible whatever the raceway, or `execute` ended the search. An
/// empty region is no error: [`Found::recommended`] is `None` then.
pub fn search(
    case: &Case,
    request: &Request,
    execute: &mut Execute<'_>,
) -> Result<Found, SearchError> {
    case.check_constant_operation("a search")?;
    oil::check_film(case, request)?;
    let least = request.budget_least();
    if request.budget < least {
        let message = format!("its budget of {} is less than {least}", request.budget);
        return Err(SearchError::Impossible(message));
    }
    case.check_motion()?;
    check_points(case, request)?;
    let film_lag_rad = oil::film_lag_rad(case, &request.points[0]);
    if !film_lag_rad.is_finite() {
        let message = "the film stops a ball that the outer raceway alone carries".to_owned();
        return Err(SearchError::Impossible(message));
    }
    let mut batch = Batch {
        request,
        ranges: ranges(case, request)?,
        execute,
        bearing: &case.bearing,
        seats: seats(case, request)?,
        row_seats: row_seats(case, request)?,
        film_lag_rad,
        measured: None,
        simulations: 0,
    };
    let maps = grid::maps(&mut batch)?;
    if batch.elastic() {
        batch.measured = Some(grid::measured(&maps[..request.points.len()]));
    }
    let mut evaluations = grid::candidates(&batch);
    batch.spacing(Stage::Candidates, &mut evaluations)?;
    let limit = request.front_structures();
    // A third is kept for a closer look at what is acceptable.
    batch.motion(Stage::Motion, &mut evaluations, (limit - limit / 3).max(1))?;
    let done = evaluations.iter().filter(|e| e.motion[0].is_some()).count();
    let mut refined = grid::refine(&batch, &evaluations);
    batch.spacing(Stage::Candidates, &mut refined)?;
    batch.motion(Stage::Motion, &mut refined, limit.saturating_sub(done))?;
    evaluations.append(&mut refined);
    let own = RacewayLayout::from_case(case);
    let reserved = own.as_ref().map_or(0, |_| batch.of_confirmation());
    let (recommended, mut confirmed) = confirmed(&mut batch, &mut evaluations, reserved)?;
    if let Some(own) = own {
        confirmed.push(batch.confirm(Role::Own, &own)?);
    }
    Ok(Found {
        request: request.clone(),
        maps,
        evaluations,
        recommended,
        confirmed,
    })
}

/// The recommendation, if more starts confirm one, after those that they reject. `reserved` simulations of the
/// budget are left for others.
fn confirmed(
    batch: &mut Batch<'_, '_>,
    evaluations: &mut Vec<Evaluation>,
    reserved: usize,
) -> Result<(Option<usize>, Vec<Confirmed>), Interrupted> {
    let mut all = vec![];
    while let Some(best) = recommend(batch, evaluations, &all)? {
        let evaluation = &mut evaluations[best];
        let mut found = batch.confirm(Role::Recommended, &evaluation.structure)?;
        found.evaluation.on_front = evaluation.on_front;
        let Some(rejection) = found.evaluation.rejection.clone() else {
            all.push(found);
            return Ok((Some(best), all));
        };
        (found.role, found.evaluation.on_front) = (Role::Unconfirmed, false);
        all.push(found);
        // It leaves the front to others, of which the next that is no neighbour is confirmed.
        (evaluation.rejection, evaluation.objectives) = (Some(rejection), None);
        let needed = batch.simulations + batch.of_confirmation() + reserved;
        if all.len() == CANDIDATES_MAX || needed > batch.request.budget {
            recommend(batch, evaluations, &all)?;
            break;
        }
    }
    Ok((None, all))
}

/// Indices of the structures on the front.
fn front(evaluations: &[Evaluation]) -> Vec<usize> {
    let rated = evaluations.iter().enumerate();
    let rated = rated.filter_map(|(k, e)| Some((k, e.objectives?)));
    let (rated, objectives): (Vec<usize>, Vec<_>) = rated.unzip();
    let front = pareto_front(&objectives).into_iter();
    front.map(|k| rated[k]).collect()
}

/// The front, the choice and, unless others were `tried` and rejected, the optimiser. Neighbours of these are not chosen.
fn recommend(
    batch: &mut Batch<'_, '_>,
    evaluations: &mut Vec<Evaluation>,
    tried: &[Confirmed],
) -> Result<Option<usize>, Interrupted> {
    let front = loop {
        let front = front(evaluations);
        let of = evaluations.iter_mut().enumerate();
        let of =
            of.filter(|(k, e)| front.contains(k) && e.axial.iter().any(|at| at.lags_rad.is_none()));
        let mut of: Vec<&mut Evaluation> = of.map(|(_, e)| e).collect();
        if of.is_empty() {
            break front;
        }
        // What it rejects leaves room on the front for others.
        batch.axial_lags(&mut of)?;
    };
    for (k, evaluation) in evaluations.iter_mut().enumerate() {
        evaluation.on_front = front.contains(&k);
    }
    let Some(scale) = ObjectiveScale::new(
        front
            .iter()
            .filter_map(|&k| evaluations[k].objectives.as_ref()),
    ) else {
        return Ok(None);
    };
    let distance = |e: &Evaluation| {
        e.objectives
            .as_ref()
            .map_or(f64::INFINITY, |o| scale.distance(o))
    };
    let near = |k: usize| {
        let mut tried = tried.iter().map(|c| &c.evaluation.structure);
        tried.any(|other| evaluations[k].structure.is_near(other))
    };
    let best = front
        .into_iter()
        .filter(|&k| !near(k))
        .min_by(|&a, &b| distance(&evaluations[a]).total_cmp(&distance(&evaluations[b])));
    let Some(best) = best.filter(|_| tried.is_empty()) else {
        return Ok(best);
    };
    let mut optimised = optimise_from(batch, &evaluations[best], &distance)?;
    if let Some(better) = &mut optimised {
        batch.axial_lags(&mut [better])?;
    }
    Ok(Some(match optimised.filter(|e| e.rejection.is_none()) {
        Some(better) => {
            evaluations.push(better);
            evaluations.len() - 1
        }
        None => best,
    }))
}

/// Candidates that are confirmed at most.
const CANDIDATES_MAX: usize = 3;

/// Steps of the optimiser: about half a cell of the candidates.
const SPAN_STEP: f64 = 0.02;
const ANGLE_STEP: f64 = 0.05;

/// COBYLA from a structure, over shares of its span and angle.
fn optimise_from(
    batch: &mut Batch<'_, '_>,
    from: &Evaluation,
    distance: &dyn Fn(&Evaluation) -> f64,
) -> Result<Option<Evaluation>, Interrupted> {
    let mut interrupted = false;
    let mut seen: Vec<([f64; 2], Evaluation)> = vec![];
    let gap_range = batch.gap_range();
    let tries = batch.request.optimised_structures();
    let elastic = batch.elastic();
    let value = |e: &Evaluation| local_optimisation::Value {
        objective: distance(e).min(2.0),
        constraints: e.slack(&gap_range, elastic),
    };
    let start = value(from);
    let found = local_optimisation::minimise(2.0, tries, start, &mut |[x, y]| {
        let structure = grid::snapped(&RacewayLayout {
            axial_span_m: from.structure.axial_span_m * (1.0 + SPAN_STEP * x),
            half_angle_rad: from.structure.half_angle_rad * (1.0 + ANGLE_STEP * y),
            ..from.structure.clone()
        });
        let mut one = vec![Evaluation::new(batch, structure, from.placement)];
        let allowed = seen.len() < tries && batch.within(&one[0].structure);
        if !interrupted && allowed {
            let done = batch
                .spacing(Stage::Polish, &mut one)
                .and_then(|()| batch.motion(Stage::Polish, &mut one, 1));
            interrupted = done.is_err();
        }
        let one = one.swap_remove(0);
        let mut value = value(&one);
        if !allowed {
            value.constraints[0] = -1.0;
        }
        seen.push(([x, y], one));
        value
    });
    if interrupted {
        return Err(Interrupted);
    }
    Ok(found.and_then(|place| {
        seen.into_iter()
            .find(|(p, _)| *p == place)
            .map(|(_, mut evaluation)| {
                evaluation.on_front = true;
                evaluation
            })
            .filter(|e| e.objectives.is_some())
    }))
}

/// Contact angle and deflection under the largest axial load at each operating point.
fn seats(case: &Case, request: &Request) -> Result<Vec<[f64; 2]>, SearchError> {
    let axial_load_n = request.axial_load_max_n;
    let loaded = request.points.iter().filter(|_| axial_load_n > 0.0);
    let seat = |point| match axial::seat(case, point, axial_load_n) {
        Err(EquilibriumError::Input(error)) => Err(error.into()),
        Err(error) => Err(SearchError::Impossible(format!(
            "under an axial load of {axial_load_n} N {error}"
        ))),
        Ok(seat) => Ok(seat),
    };
    loaded.map(seat).collect()
}

/// Seats of every row at each operating point; empty with rigid flanks.
fn row_seats(case: &Case, request: &Request) -> Result<Vec<[f64; 2]>, SearchError> {
    let mut all = vec![];
    for point in request.points.iter().filter(|_| case.has_elastic_flanks()) {
        match point.row_seats(case) {
            Err(EquilibriumError::Input(error)) => return Err(error.into()),
            Err(error) => {
                let message = format!("at {} {error}", label(point));
                return Err(SearchError::Impossible(message));
            }
            Ok(seats) => all.extend(seats),
        }
    }
    Ok(all)
}

fn label(point: &OperatingPoint) -> String {
    let speed_rpm = point.inner_speed_rad_s * 60.0 / std::f64::consts::TAU;
    match point.axial_load_n {
        0.0 => format!("{speed_rpm:.0} rpm and {} N", point.radial_load_n),
        axial => format!(
            "{speed_rpm:.0} rpm, {} N and {axial} N along the axis",
            point.radial_load_n
        ),
    }
}

/// Refuses operating points that overload the inner raceway, or that have no equilibrium,
/// whatever the outer ring looks like.
fn check_points(case: &Case, request: &Request) -> Result<(), SearchError> {
    for point in &request.points {
        let at = format!("at {}", label(point));
        let plain = point.case(case, vec![]);
        match pressure_at_rest_pa(&plain) {
            Ok([inner, _]) if inner > STRESS_LIMIT_PA => {
                return Err(SearchError::Impossible(format!(
                    "{at} the contact pressure at the inner raceway is {:.0} MPa, above the {:.0} MPa \
                     of ISO 76: no raceway in the outer ring changes that, lower the load or the \
                     speed",
                    inner * 1e-6,
                    STRESS_LIMIT_PA * 1e-6
                )));
            }
            Ok(_) => {}
            Err(EquilibriumError::Input(error)) => return Err(error.into()),
            Err(error) => return Err(SearchError::Impossible(format!("{at} {error}"))),
        }
    }
    Ok(())
}

/// Ranges of lC and θ to look at; refuses those of which Eq. (8) and (9) allow nothing.
fn ranges(case: &Case, request: &Request) -> Result<[[f64; 2]; 2], SearchError> {
    let [spans, angles] = grid::ranges(request, &case.bearing);
    if spans[1] < spans[0] {
        return Err(SearchError::Impossible(format!(
            "search.axial_span_mm begins at {} mm, beyond the limit of {:.4} mm that the groove \
             sets (Zhao 2022, Eq. (8))",
            spans[0] * 1e3,
            axial_span_limit_m(&case.bearing) * 1e3
        )));
    }
    if angles[1] < angles[0] {
        return Err(SearchError::Impossible(format!(
            "search.half_angle_deg begins at {:.2}°, beyond the {:.2}° up to which the contact \
             path of the widest raceway stays in the groove (Zhao 2022, Eq. (9))",
            angles[0].to_degrees(),
            angles[1].to_degrees()
        )));
    }
    Ok([spans, angles])
}

/// Slack of the requirements that change smoothly, each 0 or more if met.
pub(super) const REQUIREMENTS: usize = 4;

impl Evaluation {
    /// Slip, on elastic flanks lag, room in steady flow, spread, double collisions; the worst point of each.
    fn slack(&self, gap_range: &RangeInclusive<f64>, elastic: bool) -> [f64; REQUIREMENTS] {
        let Some(forms) = self.forms else {
            return [-1.0; REQUIREMENTS];
        };
        let mut slack = [f64::INFINITY; REQUIREMENTS];
        for spacing in &self.spacing {
            let Some(s) = spacing else {
                return [-1.0; REQUIREMENTS];
            };
            let fraction = s.critical_gap_rad / forms.steady_gap_rad;
            if !elastic {
                slack[0] = slack[0].min(SEPARATION.of(s.shortfall).margin());
            }
            slack[1] = slack[1].min(gap_range.end() - fraction);
            slack[2] = slack[2].min(fraction - gap_range.start());
        }
        for axial in &self.axial {
            slack[2] = slack[2].min(AXIAL_LAG.of(axial.rolling_fraction).margin());
        }
        for motion in self.motion.iter().flatten() {
            if elastic {
                slack[0] = slack[0].min(LAG.of(motion.lag_fraction).margin());
            }
            let twice = BOTH_NEIGHBOURS.of(motion.double_collision_fraction);
            slack[3] = slack[3].min(twice.margin());
        }
        slack.map(|s| if s.is_finite() { s } else { 0.0 })
    }
}
