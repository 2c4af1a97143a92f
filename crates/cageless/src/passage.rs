//! Passages of the balls through the discrete raceways.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::passage::{PassageRecorder, PassageTally};
//! use cageless::simulation::{Control, run};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let mut tally = PassageTally::new();
//! let mut recorder = PassageRecorder::new(|passage| {
//!     tally.add(&passage);
//!     Ok(())
//! });
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! assert!(tally.count > 10); // in 20 ms
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::f64::consts::TAU;
use std::ops::Range;

use crate::case::Case;
use crate::contact_tracker::ContactTracker;
use crate::dynamics::Contacts;
use crate::dynamics::coordinates::BallCoordinate::{Vx, Vy, X, Y};
use crate::gap::Direction;
use crate::half_turn::rolling_with_film_rad_s;
use crate::integrator::StepState;
use crate::numerics::lane_set::LaneSet;
use crate::numerics::lanes::{LANES, Lanes, larger};
use crate::numerics::root;
use crate::numerics::vector::PlaneVector;
use crate::raceway::Raceway;
use crate::simd::{InstructionSet, with_instructions};
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// One ball through one raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// Index (from 0) of the ball.
    pub ball: usize,
    /// Index (from 0) of the raceway.
    pub raceway: usize,
    /// Time at which the ball enters; like [`Self::leave_s`] located within the step.
    pub enter_s: f64,
    /// Time at which the ball leaves.
    pub leave_s: f64,
    /// Gap to the ball ahead on coming in.
    pub gap_enter_rad: f64,
    /// Gap of the ball behind on coming in: what the critical gap is to be compared with.
    pub gap_behind_rad: f64,
    /// Smallest gap to the ball ahead while inside.
    pub gap_min_rad: f64,
    /// Gap to the ball ahead on going out.
    pub gap_leave_rad: f64,
    /// Contacts with the ball ahead that began while inside.
    pub collisions_ahead: u32,
    /// Contacts with the ball behind that began while inside.
    pub collisions_behind: u32,
    /// Largest |ΔVi| or |ΔVo| while inside.
    pub sliding_max_m_s: f64,
    /// Time inside without force at the inner raceway.
    pub unloaded_s: f64,
    /// Largest and smallest orbital speed while inside.
    pub orbit_speed_range_rad_s: [f64; 2],
    /// Time inside over that of the largest speed of the inner ring: how long it takes that ring to turn as far.
    pub inside_at_largest_s: f64,
    /// Smallest orbital speed while inside, each over ωi of its time, times the largest ωi of the run; infinite where
    /// the inner ring hardly turns (`TURNS_FROM`).
    pub slowest_at_largest_rad_s: f64,
    /// Angle of the raceway.
    pub angle_rad: f64,
    /// Angle and time between the last raceway that the ball left and this one, the time as that inside; `None` on
    /// its first passage. With a film at constant speed the time is that of rolling: a film slows the ball on its way.
    pub way_here: Option<[f64; 2]>,
}

/// Sums over passages of what each has.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct PassageSums {
    inside_s: f64,
    inside_at_largest_s: f64,
    unloaded_s: f64,
    /// Contacts with either neighbour that began inside.
    collisions: f64,
    /// Passages in which both neighbours hit.
    double_collisions: f64,
    sliding_max_m_s: f64,
    gap_min_rad: f64,
    /// Smallest orbital speeds at the largest ωi, of the passages in which the inner ring turns.
    slowest_at_largest_rad_s: f64,
    angle_rad: f64,
    /// Angle and time between passages.
    outside_rad: f64,
    outside_s: f64,
}

/// Means over passages; NaN without any.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassageMeans {
    /// Time inside, s.
    pub duration_s: f64,
    /// Contacts with either neighbour that began inside.
    pub collisions: f64,
    /// Fraction of the passages in which both neighbours hit.
    pub double_collision_fraction: f64,
    /// Largest |ΔVi| or |ΔVo| in each, m/s.
    pub sliding_m_s: f64,
    /// Smallest gap ahead in each.
    pub gap_min_rad: f64,
    /// Lag of a ball in one passage, rad: the reference speed times the time inside, less the angle of the raceway. The
    /// reference is the mean orbital speed between passages, with a film that of rolling. Where the speed varies, times
    /// are those in which the inner ring would turn as far at its largest. NaN until a ball has passed two.
    pub lag_rad: f64,
    /// Fraction of the time inside without force at the inner raceway.
    pub unloaded_fraction: f64,
    /// Smallest orbital speed in each, at the largest speed of the inner ring, rad/s. NaN where that stands in all.
    pub lowest_orbit_speed_rad_s: f64,
}

/// Sums over passages, accumulated one by one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassageTally {
    /// Number of samples or passages.
    pub count: u64,
    /// Number of those in which the inner ring turns.
    turned: u64,
    sums: PassageSums,
    /// Largest and smallest gap to the ball ahead on going out.
    pub gap_leave_range_rad: [f64; 2],
}

impl PassageTally {
    /// Tally without passages.
    pub fn new() -> Self {
        Self {
            count: 0,
            turned: 0,
            sums: PassageSums::default(),
            gap_leave_range_rad: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Adds a passage.
    pub fn add(&mut self, p: &Passage) {
        self.count += 1;
        let turned = p.slowest_at_largest_rad_s.is_finite();
        self.turned += u64::from(turned);
        let twice = p.collisions_ahead > 0 && p.collisions_behind > 0;
        let sums = &mut self.sums;
        sums.inside_s += p.leave_s - p.enter_s;
        sums.inside_at_largest_s += p.inside_at_largest_s;
        sums.unloaded_s += p.unloaded_s;
        sums.collisions += f64::from(p.collisions_ahead + p.collisions_behind);
        sums.double_collisions += f64::from(u8::from(twice));
        sums.sliding_max_m_s += p.sliding_max_m_s;
        sums.gap_min_rad += p.gap_min_rad;
        if turned {
            sums.slowest_at_largest_rad_s += p.slowest_at_largest_rad_s;
        }
        sums.angle_rad += p.angle_rad;
        if let Some([angle_rad, time_s]) = p.way_here {
            sums.outside_rad += angle_rad;
            sums.outside_s += time_s;
        }
        let [low, high] = self.gap_leave_range_rad;
        self.gap_leave_range_rad = [low.min(p.gap_leave_rad), high.max(p.gap_leave_rad)];
    }

    /// Means of the passages so far.
    pub fn means(&self) -> PassageMeans {
        let (sums, count) = (&self.sums, self.count as f64);
        let between_rad_s = sums.outside_rad / sums.outside_s;
        PassageMeans {
            duration_s: sums.inside_s / count,
            collisions: sums.collisions / count,
            double_collision_fraction: sums.double_collisions / count,
            sliding_m_s: sums.sliding_max_m_s / count,
            gap_min_rad: sums.gap_min_rad / count,
            lag_rad: between_rad_s * (sums.inside_at_largest_s / count) - sums.angle_rad / count,
            unloaded_fraction: sums.unloaded_s / sums.inside_s,
            lowest_orbit_speed_rad_s: sums.slowest_at_largest_rad_s / self.turned as f64,
        }
    }
}

impl Default for PassageTally {
    fn default() -> Self {
        Self::new()
    }
}

/// The part of the turn that a raceway takes up.
#[derive(Debug, Clone, Copy)]
struct RacewaySector {
    sin_centre: f64,
    cos_centre: f64,
    cos_half: f64,
    centre_rad: f64,
    half_rad: f64,
    /// Unit vectors from the centre to both ends.
    ends: [PlaneVector; 2],
}

impl RacewaySector {
    fn new(raceway: &Raceway) -> Self {
        let d = raceway.dimensions();
        let (sin_centre, cos_centre) = d.centre_angle_rad.sin_cos();
        Self {
            sin_centre,
            cos_centre,
            cos_half: d.half_angle_rad.cos(),
            centre_rad: d.centre_angle_rad,
            half_rad: d.half_angle_rad,
            ends: [-d.half_angle_rad, d.half_angle_rad].map(|half| {
                let (sin, cos) = (d.centre_angle_rad + half).sin_cos();
                PlaneVector { x: sin, y: -cos }
            }),
        }
    }

    /// |rb|·(cos(ψ − centre) − cos θ): above zero inside, with ψ from −Y.
    #[inline]
    fn inside_by(&self, rb: PlaneVector) -> f64 {
        rb.x * self.sin_centre - rb.y * self.cos_centre - self.cos_half * rb.square().sqrt()
    }

    /// Angle from the end of another raceway, or of this one a turn before, to the begin of this.
    fn begin_behind_rad(&self, other: &Self) -> f64 {
        let end = other.centre_rad + other.half_rad;
        (self.centre_rad - self.half_rad - end).rem_euclid(TAU)
    }

    /// Balls of a block, by x, y, vx and vy, that may get to an end within `until_s`.
    #[inline(always)]
    fn near(&self, [x, y, vx, vy]: &[Lanes; 4], centre_m: PlaneVector, until_s: f64) -> LaneSet {
        LaneSet::of(|lane| {
            let (x, y) = (x.0[lane], y.0[lane]);
            let PlaneVector { x, y } = PlaneVector { x, y }.from(centre_m);
            let speed_m_s = 2.0 * (vx.0[lane].abs() + vy.0[lane].abs()) + GAIN_M_S;
            let reach_m = speed_m_s * until_s;
            let mut near = false;
            for PlaneVector { x: ex, y: ey } in self.ends {
                // Both are lower bounds of the distance.
                let (along, across) = (x * ex + y * ey, (x * ey - y * ex).abs());
                near |= (across < reach_m) & (-along < reach_m);
            }
            near
        })
    }
}

/// All balls are looked at this often, s: seldom, but each time those near an end then are looked at in every step.
const LOOK_EVERY_S: f64 = 2.5e-5;
/// Speed that a ball may gain until the next look beyond as much as it has, m/s: one at rest that is
/// hit does not get to an end unseen.
const GAIN_M_S: f64 = 5.0;

/// Where a ball is, seen from a raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    /// Inside since the start: let out first.
    StartedInside,
    Outside,
    /// On a passage.
    Inside,
}

/// A ball and a raceway whose end it may cross.
#[derive(Debug, Clone, Copy)]
struct BallAtRaceway {
    ball: usize,
    raceway: usize,
}

/// A passage, and where the ball was nearest to the one ahead.
#[derive(Debug, Clone, Copy)]
struct UnderWay {
    passage: Passage,
    nearest: Direction,
    /// Where x and y of the ball are in the state.
    own: PlaneVector<usize>,
    /// Indices of x and y of the ball ahead in the state.
    ahead: PlaneVector<usize>,
}

impl UnderWay {
    /// Follows the ball through a step.
    #[inline(always)] // a centre passed in memory waits for its two stores
    fn follow(
        &mut self,
        step: &StepState,
        centre_m: PlaneVector,
        contacts: &Contacts<'_>,
        speed_ratio: f64,
    ) {
        let Self {
            passage,
            nearest,
            own,
            ahead,
        } = self;
        let about = |at: PlaneVector<usize>| {
            let (x, y) = (step.y1[at.x], step.y1[at.y]);
            PlaneVector { x, y }.from(centre_m)
        };
        let now = Direction::between(about(*own), about(*ahead));
        if now.below(*nearest) {
            *nearest = now;
        }
        let ball = contacts.rolling(passage.ball);
        passage.sliding_max_m_s = larger(passage.sliding_max_m_s, ball.loaded_sliding_m_s);
        if !ball.is_loaded {
            passage.unloaded_s += step.size_s();
        }
        let ([low, high], orbit) = (passage.orbit_speed_range_rad_s, ball.orbit_speed_rad_s);
        let low = if orbit < low { orbit } else { low };
        let slowest = at_largest_rad_s(orbit, speed_ratio);
        if slowest < passage.slowest_at_largest_rad_s {
            passage.slowest_at_largest_rad_s = slowest;
        }
        passage.orbit_speed_range_rad_s = [low, larger(high, orbit)];
    }
}

/// Speed of the inner ring over its largest from which balls are seen to roll: in a slower one weight and the flanks
/// move them as much as it does.
pub(crate) const TURNS_FROM: f64 = 0.1;

/// An orbital speed over that of the inner ring, times the largest; infinite where the ring hardly turns.
#[inline]
fn at_largest_rad_s(orbit_speed_rad_s: f64, speed_ratio: f64) -> f64 {
    if speed_ratio < TURNS_FROM {
        return f64::INFINITY;
    }
    orbit_speed_rad_s / speed_ratio
}

/// Observer that tallies the passages that begin after a time.
#[derive(Default)]
pub(crate) struct SettledPassages {
    follower: PassageFollower,
    /// The time, s.
    after_s: f64,
    /// The passages.
    pub tally: PassageTally,
}

impl SettledPassages {
    /// Tallies the passages after `after_s`.
    pub(crate) fn after(after_s: f64) -> Self {
        Self {
            after_s,
            ..Self::default()
        }
    }
}

impl Observer for SettledPassages {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.follower.begin(context);
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        self.follower.follow(view, |passage| {
            if passage.enter_s > self.after_s {
                self.tally.add(&passage);
            }
            Ok(())
        })
    }
}

/// Follows the balls through the raceways and passes each passage on when the ball goes
/// out; one counts when the ball has come in and gone out during the run.
///
/// Looks at a ball in every step while it is in a raceway or near an end of one, else forty times in
/// a millisecond.
pub struct PassageRecorder<F> {
    follower: PassageFollower,
    sink: F,
}

/// Passages under way.
struct PassageFollower {
    sectors: Vec<RacewaySector>,
    pair_angles: Vec<f64>,
    /// Place of each ball, seen from each raceway.
    places: Vec<Place>,
    under_way: Vec<UnderWay>,
    /// When all balls are looked at again, s.
    look_s: f64,
    /// Balls that may cross an end of a raceway until then; before the first look all.
    near: Vec<BallAtRaceway>,
    /// Raceway that each ball left last, and when.
    left: Vec<Option<(usize, f64)>>,
    contact_tracker: ContactTracker,
    /// The case if its speed varies.
    varying: Option<Case>,
    /// Orbital speed of rolling with a film, rad/s.
    rolling_rad_s: Option<f64>,
}

impl<F: FnMut(Passage) -> Result<(), ObserverError>> PassageRecorder<F> {
    /// Passes each passage to `sink` when it ends; an error of it ends the run.
    pub fn new(sink: F) -> Self {
        Self {
            follower: PassageFollower::default(),
            sink,
        }
    }
}

impl<F: FnMut(Passage) -> Result<(), ObserverError>> Observer for PassageRecorder<F> {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.follower.begin(context);
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        self.follower.follow(view, &mut self.sink)
    }
}

impl Default for PassageFollower {
    fn default() -> Self {
        Self {
            sectors: vec![],
            pair_angles: vec![],
            places: vec![],
            under_way: vec![],
            look_s: 0.0,
            near: vec![],
            left: vec![],
            contact_tracker: ContactTracker::new(0),
            varying: None,
            rolling_rad_s: None,
        }
    }
}

impl PassageFollower {
    /// When ball `k` crosses the end of a raceway within the step, and the gaps to the ball
    /// ahead and of the ball behind there.
    fn end(&self, view: &StepView<'_>, at: BallAtRaceway) -> (f64, [f64; 2]) {
        let BallAtRaceway {
            ball: k,
            raceway: r,
        } = at;
        let sector = &self.sectors[r];
        let (from, to) = (view.step.t0_s, view.step.t1_s);
        let inside_by = |time_s: f64| {
            let (place, centre) = (view.ball_at_m(k, time_s), view.outer_ring_at_m(time_s));
            sector.inside_by(place.from(centre))
        };
        let time_s = root::brent(inside_by, from, to, 1e-6 * (to - from)).unwrap_or(to);
        let state = view.state(time_s);
        let of = |coordinate| state.layout().balls_of(state.values(), coordinate);
        let (x, y) = (of(X), of(Y));
        let centre = state.outer_ring_motion().place();
        let gap = |k: usize| {
            Direction::to_next(PlaneVector { x, y }, centre, k).gap_rad(self.pair_angles[k])
        };
        (time_s, [k, x.previous(k)].map(gap))
    }

    /// Looks at all balls and keeps in mind which are near an end.
    #[inline(never)] // most steps do without
    fn look(&mut self, view: &StepView<'_>) {
        // The look comes at the end of a step.
        let until_s = LOOK_EVERY_S + view.step.size_s();
        self.look_s = view.step.t1_s + LOOK_EVERY_S;
        self.near.clear();
        let (isa, centre_m) = (InstructionSet::chosen(), view.outer_ring_m());
        let coordinates = [X, Y, Vx, Vy].map(|coordinate| view.after(coordinate));
        for (r, sector) in self.sectors.iter().enumerate() {
            for first in (0..self.pair_angles.len()).step_by(LANES) {
                let mut motion = [Lanes::ZERO; 4];
                for (lanes, balls) in motion.iter_mut().zip(&coordinates) {
                    balls.copy_block(first, lanes);
                }
                let motion = &motion;
                let near = with_instructions!(
                    isa,
                    [](sector: &RacewaySector, motion: &[Lanes; 4], centre_m: PlaneVector, until_s: f64) -> LaneSet,
                    sector.near(motion, centre_m, until_s)
                );
                let own = near.of_bearing(0, true, self.pair_angles.len() - first);
                self.near.extend(own.map(|lane| BallAtRaceway {
                    raceway: r,
                    ball: first + lane,
                }));
            }
        }
    }

    /// Index of the place of a ball, seen from a raceway.
    fn slot(&self, at: BallAtRaceway) -> usize {
        at.raceway * self.pair_angles.len() + at.ball
    }

    /// Begins or ends a passage if the ball has crossed an end of the raceway: the passage that ends.
    #[inline]
    fn look_at(&mut self, view: &StepView<'_>, at: BallAtRaceway) -> Option<Passage> {
        let inside = self.sectors[at.raceway].inside_by(view.about_outer_ring_m(at.ball)) > 0.0;
        let place = self.places[self.slot(at)];
        match inside == (place != Place::Outside) {
            true => None,
            false => self.cross(view, at),
        }
    }

    /// Begins or ends a passage of a ball that has crossed an end of the raceway: the passage that ends.
    #[cold]
    fn cross(&mut self, view: &StepView<'_>, at: BallAtRaceway) -> Option<Passage> {
        let mut ended = None;
        let slot = self.slot(at);
        self.places[slot] = match self.places[slot] {
            Place::StartedInside => Place::Outside,
            Place::Outside => {
                let passage = self.enter(view, at);
                self.under_way.push(passage);
                Place::Inside
            }
            Place::Inside => {
                ended = Some(self.leave(view, at));
                Place::Outside
            }
        };
        ended
    }

    /// ωi at the end of a step over its largest.
    fn speed_ratio(&self, view: &StepView<'_>) -> f64 {
        let varying = self.varying.as_ref();
        varying.map_or(1.0, |case| case.inner_speed_ratio(view.step.t1_s))
    }

    /// Time in which the inner ring at its largest speed turns as far as between two times, s.
    fn at_largest_s(&self, between_s: Range<f64>) -> f64 {
        let constant = between_s.end - between_s.start;
        let varying = self.varying.as_ref();
        varying.map_or(constant, |case| case.time_at_largest_speed_s(between_s))
    }

    /// The passage of a ball that comes in.
    fn enter(&self, view: &StepView<'_>, at: BallAtRaceway) -> UnderWay {
        let (enter_s, [gap, gap_behind_rad]) = self.end(view, at);
        let BallAtRaceway {
            ball: k,
            raceway: r,
        } = at;
        let layout = view.layout();
        let places = |k: usize| PlaneVector {
            x: layout.ball(X, k),
            y: layout.ball(Y, k),
        };
        let from_end_of = |before: usize| self.sectors[r].begin_behind_rad(&self.sectors[before]);
        let way_here = self.left[k].map(|(before, left_s)| {
            let angle_rad = from_end_of(before);
            let rolling_s = self.rolling_rad_s.map(|speed| angle_rad / speed);
            let time_s = rolling_s.unwrap_or_else(|| self.at_largest_s(left_s..enter_s));
            [angle_rad, time_s]
        });
        let orbit = view.contacts.orbit_speed_rad_s(k);
        UnderWay {
            passage: Passage {
                ball: k,
                raceway: r,
                enter_s,
                leave_s: enter_s,
                gap_enter_rad: gap,
                gap_behind_rad,
                gap_min_rad: gap,
                gap_leave_rad: gap,
                collisions_ahead: 0,
                collisions_behind: 0,
                sliding_max_m_s: 0.0,
                unloaded_s: 0.0,
                orbit_speed_range_rad_s: [orbit; 2],
                inside_at_largest_s: 0.0,
                slowest_at_largest_rad_s: at_largest_rad_s(orbit, self.speed_ratio(view)),
                angle_rad: 2.0 * self.sectors[r].half_rad,
                way_here,
            },
            nearest: Direction::to_next(view.positions(), view.outer_ring_m(), k),
            own: places(k),
            ahead: places(layout.next(k)),
        }
    }

    /// The passage of a ball that goes out.
    fn leave(&mut self, view: &StepView<'_>, at: BallAtRaceway) -> Passage {
        let (leave_s, [gap_leave_rad, _]) = self.end(view, at);
        let BallAtRaceway {
            ball: k,
            raceway: r,
        } = at;
        let of_ball = |u: &UnderWay| (u.passage.ball, u.passage.raceway) == (k, r);
        let at = self.under_way.iter().position(of_ball);
        let UnderWay {
            passage, nearest, ..
        } = self.under_way.swap_remove(at.expect("it came in"));
        let least = passage.gap_enter_rad.min(gap_leave_rad);
        self.left[k] = Some((r, leave_s));
        Passage {
            leave_s,
            inside_at_largest_s: self.at_largest_s(passage.enter_s..leave_s),
            gap_leave_rad,
            gap_min_rad: least.min(nearest.gap_rad(self.pair_angles[k])),
            ..passage
        }
    }

    /// Begins with a run.
    fn begin(&mut self, context: &RunContext<'_>) {
        let n = context.model.balls();
        let raceways = &context.case.raceways;
        self.sectors = raceways.iter().map(RacewaySector::new).collect();
        self.pair_angles = (0..n).map(|k| context.model.pair_angle_rad(k)).collect();
        self.places = vec![Place::StartedInside; n * self.sectors.len()];
        self.under_way.clear();
        self.left = vec![None; n];
        let all_of = |raceway: usize| (0..n).map(move |ball| BallAtRaceway { ball, raceway });
        self.near = (0..raceways.len()).flat_map(all_of).collect();
        self.look_s = 0.0;
        self.contact_tracker = ContactTracker::new(n);
        let varies = context.case.operation.inner_speed_table.is_some();
        self.varying = varies.then(|| context.case.clone());
        self.rolling_rad_s = rolling_with_film_rad_s(context.case);
    }

    /// Follows the balls through a step; passages that end in it go to `sink`.
    fn follow(
        &mut self,
        view: &StepView<'_>,
        mut sink: impl FnMut(Passage) -> Result<(), ObserverError>,
    ) -> Result<Control, ObserverError> {
        self.contact_tracker.update(&view.contacts);
        for at in 0..self.near.len() {
            if let Some(passage) = self.look_at(view, self.near[at]) {
                sink(passage)?;
            }
        }
        if view.step.t1_s >= self.look_s {
            self.look(view);
        }
        let begun = self.contact_tracker.count() > 0;
        let (centre_m, speed_ratio) = (view.outer_ring_m(), self.speed_ratio(view));
        for under_way in &mut self.under_way {
            under_way.follow(view.step, centre_m, &view.contacts, speed_ratio);
            if begun {
                let passage = &mut under_way.passage;
                let started = |k| u32::from(self.contact_tracker.started(k));
                passage.collisions_ahead += started(passage.ball);
                passage.collisions_behind += started(view.after(X).previous(passage.ball));
            }
        }
        Ok(Control::Continue(()))
    }
}

#[cfg(test)]
mod tests {
    use super::{Passage, PassageTally};

    fn passage(number: f64, collisions_ahead: u32, collisions_behind: u32) -> Passage {
        Passage {
            ball: 0,
            raceway: 0,
            enter_s: 1.0,
            leave_s: 1.0 + 2.0 * number,
            gap_enter_rad: 3.0 * number,
            gap_behind_rad: 4.0 * number,
            gap_min_rad: 5.0 * number,
            gap_leave_rad: 6.0 * number,
            collisions_ahead,
            collisions_behind,
            sliding_max_m_s: 7.0 * number,
            unloaded_s: 0.5 * number,
            orbit_speed_range_rad_s: [8.0 * number, 9.0 * number],
            inside_at_largest_s: 2.0 * number,
            slowest_at_largest_rad_s: 8.0 * number,
            angle_rad: 0.5,
            way_here: (number > 1.0).then_some([5.0, 20.0]),
        }
    }

    /// Two contacts with the same neighbour are no hits from both sides.
    #[test]
    fn hits_from_both_sides_need_both_neighbours() {
        let fraction = |hits: [[u32; 2]; 2]| {
            let mut tally = PassageTally::new();
            for [ahead, behind] in hits {
                tally.add(&passage(1.0, ahead, behind));
            }
            tally.means().double_collision_fraction
        };
        assert_eq!(fraction([[2, 0], [0, 3]]), 0.0);
        assert_eq!(fraction([[1, 1], [2, 0]]), 0.5);
    }

    #[test]
    fn every_mean_is_that_of_its_number() {
        let mut tally = PassageTally::new();
        assert!(tally.means().duration_s.is_nan());
        tally.add(&passage(1.0, 3, 0));
        tally.add(&passage(3.0, 1, 4));
        assert_eq!(tally.count, 2);
        assert_eq!(tally.means().duration_s, 4.0);
        // 0.25 rad/s between passages, 4 s within, 0.5 rad.
        assert_eq!(tally.means().lag_rad, 0.5);
        assert_eq!(tally.means().collisions, 4.0);
        assert_eq!(tally.means().double_collision_fraction, 0.5);
        assert_eq!(tally.means().gap_min_rad, 10.0);
        assert_eq!(tally.means().sliding_m_s, 14.0);
        assert_eq!(tally.means().unloaded_fraction, 0.25);
        assert_eq!(tally.means().lowest_orbit_speed_rad_s, 16.0);
        assert_eq!(tally.gap_leave_range_rad, [6.0, 18.0]);
    }
}
