//! Peak contact pressures of a run, and the largest product of pressure and sliding speed.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::{Control, run};
//! use cageless::summary::SummaryRecorder;
//!
//! let mut case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! case.solver.duration_s = 0.002;
//! let mut recorder = SummaryRecorder::new();
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! let summary = recorder.summary().unwrap();
//! assert!(summary.peaks.inner.pressure_pa > 1e9);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::ball::BallLanes;
use crate::case::Case;
use crate::contact::flash_temperature::{STEEL_EFFUSIVITY, flash_temperature_k};
use crate::dynamics::Contacts;
use crate::ellipse_edges::EllipseEdges;
use crate::kinematics::rolling_rotation_rad_s;
use crate::raceway::Raceway;
use crate::raceway_contact::{RacewayContact, RacewayPoint};
use crate::simd::BlockResults;

/// Peak loads of one kind of contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactPeak {
    /// Largest normal force, N.
    pub force_n: f64,
    /// Largest Hertz pressure, Pa.
    pub pressure_pa: f64,
    /// Largest product of Hertz pressure and sliding speed in one contact at one time, Pa·m/s.
    pub pressure_velocity_pa_m_s: f64,
    /// Blok's flash temperature of that contact, K.
    pub flash_temperature_k: f64,
}

/// Peak loads of the contacts over the part of a run after its transient.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactPeaks {
    /// Balls against the inner raceway.
    pub inner: ContactPeak,
    /// Balls against the outer raceway; where a ball rests on a discrete raceway at two points,
    /// pressure and sliding are those of the more loaded one.
    pub outer: ContactPeak,
    /// Balls against balls.
    pub balls: ContactPeak,
}

impl ContactPeaks {
    /// Largest Hertz pressure of all, Pa.
    pub fn pressure_max_pa(&self) -> f64 {
        let all = [self.inner, self.outer, self.balls];
        all.iter()
            .fold(0.0, |most, peak| most.max(peak.pressure_pa))
    }
}

/// Point of contact `P` with the sliding speed at the same time.
#[derive(Debug, Clone, Copy)]
struct Sample<P> {
    rank: f64,
    point: P,
    sliding: Sliding,
}

/// Sliding of a contact at a time.
#[derive(Debug, Clone, Copy)]
struct Sliding {
    /// ΔV.
    speed_m_s: f64,
    /// ωi over the largest.
    speed_ratio: f64,
}

/// The most loaded point of a contact, and the force by which it ranks.
struct Loaded<P> {
    point: P,
    rank_n: f64,
}

impl Loaded<RacewayPoint> {
    /// A point at a raceway.
    fn point(point: RacewayPoint) -> Self {
        Self {
            point,
            rank_n: point.force_n,
        }
    }
}

/// Largest force of a ball, and largest force and pressure times sliding speed of a point of contact.
#[derive(Debug, Clone, Copy)]
struct Largest<P> {
    force_n: f64,
    load: Option<Sample<P>>,
    sliding: Option<Sample<P>>,
}

/// Fraction of a rank that rounding may take from it.
const ROUNDING: f64 = 1e-12;

/// Force of a ball and ranks by load and sliding so far.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    force_n: f64,
    load: f64,
    sliding: f64,
}

/// Force of a contact, of which its most loaded point bears the part `over`/`under`.
#[derive(Debug, Clone, Copy)]
struct Pressed {
    force_n: f64,
    over: f64,
    under: f64,
}

impl Bounds {
    /// Whether a contact may exceed them.
    #[inline(always)]
    fn may_be_exceeded(&self, by: Pressed, sliding_m_s: f64) -> bool {
        let (rank, speed) = (by.force_n * by.over, sliding_m_s.abs());
        let least = by.under * (1.0 - ROUNDING);
        (by.force_n > self.force_n)
            | (rank > self.load * least)
            | (rank * speed * speed * speed > self.sliding * least)
    }
}

impl<P: Copy> Largest<P> {
    /// The state before the first contact.
    fn none() -> Self {
        Self {
            force_n: 0.0,
            load: None,
            sliding: None,
        }
    }

    /// Takes a contact under `force_n`. Pressure grows with F^(1/3), so that F·|ΔV|³ ranks pressure times
    /// sliding speed.
    #[inline]
    fn add(&mut self, force_n: f64, loaded: Loaded<P>, sliding: Sliding) {
        self.force_n = self.force_n.max(force_n);
        let (Loaded { point, rank_n }, speed) = (loaded, sliding.speed_m_s.abs());
        for (largest, rank) in [
            (&mut self.load, rank_n),
            (&mut self.sliding, rank_n * speed * speed * speed),
        ] {
            if rank > largest.map_or(0.0, |sample| sample.rank) {
                *largest = Some(Sample {
                    rank,
                    point,
                    sliding,
                });
            }
        }
    }

    /// Bounds that a contact must exceed to change anything.
    fn bounds(&self) -> Bounds {
        let rank = |sample: Option<Sample<P>>| sample.map_or(0.0, |sample| sample.rank);
        Bounds {
            force_n: self.force_n,
            load: rank(self.load),
            sliding: rank(self.sliding),
        }
    }

    /// Peaks with pressure and semi-axis in the direction of rolling of a point, and surfaces of
    /// which one moves at `surface_m_s` past the contact at the largest speed of the inner ring.
    fn peak(
        &self,
        friction_coefficient: f64,
        contact: impl Fn(P) -> RacewayContact,
        surface_m_s: f64,
    ) -> ContactPeak {
        let Some(load) = self.load else {
            return ContactPeak::default();
        };
        let Sample { point, sliding, .. } = self.sliding.unwrap_or(load);
        let sliding_m_s = sliding.speed_m_s;
        let surface_m_s = sliding.speed_ratio * surface_m_s;
        let sliding = contact(point);
        ContactPeak {
            force_n: self.force_n,
            pressure_pa: contact(load.point).pressure_pa,
            pressure_velocity_pa_m_s: sliding.pressure_pa * sliding_m_s.abs(),
            flash_temperature_k: flash_temperature_k(
                friction_coefficient,
                sliding.pressure_pa,
                sliding.semi_axes_m[0],
                [surface_m_s, surface_m_s - sliding_m_s],
                STEEL_EFFUSIVITY,
            ),
        }
    }
}

impl ContactPeak {
    /// The larger of each.
    fn or(self, other: Self) -> Self {
        let sliding = if other.pressure_velocity_pa_m_s > self.pressure_velocity_pa_m_s {
            other
        } else {
            self
        };
        Self {
            force_n: self.force_n.max(other.force_n),
            pressure_pa: self.pressure_pa.max(other.pressure_pa),
            ..sliding
        }
    }
}

/// Follows the contacts of a run for [`ContactPeaks`].
#[derive(Debug, Clone)]
pub(crate) struct ContactPeakTracker {
    inner: Largest<RacewayPoint>,
    /// Without and with a contact angle.
    outer: [Largest<RacewayPoint>; 2],
    /// Force on one edge of each slot with the local ψ there, rad.
    edges: Vec<(Raceway, Largest<(f64, f64)>)>,
    /// Force between balls.
    balls: Largest<f64>,
    ellipse_edges: EllipseEdges,
}

impl ContactPeakTracker {
    pub(crate) fn new(case: &Case) -> Self {
        let slots = case.raceways.iter().filter(|r| r.slot().is_some());
        Self {
            inner: Largest::none(),
            outer: [Largest::none(); 2],
            edges: slots.map(|r| (r.clone(), Largest::none())).collect(),
            balls: Largest::none(),
            ellipse_edges: EllipseEdges::default(),
        }
    }

    /// Takes the contacts of the balls with the raceways, at this ωi over the largest.
    pub(crate) fn look(&mut self, contacts: &Contacts<'_>, speed_ratio: f64) {
        if contacts.are_in_space() || !self.edges.is_empty() {
            return (0..contacts.balls()).for_each(|k| self.look_at(contacts, k, speed_ratio));
        }
        let (inner, outer) = (
            self.inner.bounds(),
            self.outer.map(|largest| largest.bounds()),
        );
        let may_exceed = move |balls: &BallLanes, results: &BlockResults, lane: usize| {
            let (radius, effective) = (
                balls.radius.0[lane],
                results.geometry.effective_radius.0[lane],
            );
            let (i, o) = (&results.inner, &results.outer);
            let at_outer = |under: f64| Pressed {
                force_n: o.force.0[lane],
                over: radius,
                under,
            };
            let outer_exceeds = |bounds: Bounds, under: f64| {
                bounds.may_be_exceeded(at_outer(under), o.slip.0[lane])
            };
            let at_inner = Pressed {
                force_n: i.force.0[lane],
                over: 1.0,
                under: 1.0,
            };
            // Both bounds, for a choice between two numbers in memory becomes one between their addresses.
            inner.may_be_exceeded(at_inner, i.slip.0[lane])
                | ((effective < radius) & outer_exceeds(outer[1], 2.0 * effective))
                | (!(effective < radius) & outer_exceeds(outer[0], radius))
        };
        contacts.balls_where(&may_exceed, |k| self.look_at(contacts, k, speed_ratio));
    }

    /// Takes the contacts of a ball with the raceways.
    fn look_at(&mut self, contacts: &Contacts<'_>, k: usize, speed_ratio: f64) {
        if let Some(ball) = contacts.in_space(k) {
            self.ellipse_edges.look(contacts.radius_m(k), &ball);
        }
        let force_n = contacts.inner_force_n(k);
        if force_n > 0.0 {
            let point = contacts.inner_point(k);
            let sliding = Sliding {
                speed_m_s: contacts.inner_sliding_m_s(k),
                speed_ratio,
            };
            self.inner.add(force_n, Loaded::point(point), sliding);
        }
        let force_n = contacts.outer_force_n(k);
        if force_n > 0.0 {
            let point = contacts.outer_point(k);
            let sliding = Sliding {
                speed_m_s: contacts.outer_sliding_m_s(k),
                speed_ratio,
            };
            if !self.add_edge(contacts, k, point.force_n, sliding) {
                let largest = &mut self.outer[usize::from(point.cosine < 1.0)];
                largest.add(force_n, Loaded::point(point), sliding);
            }
        }
    }

    /// Takes the more loaded edge at a ball in a slot, which carries `point_n`; whether it is in one.
    fn add_edge(
        &mut self,
        contacts: &Contacts<'_>,
        k: usize,
        point_n: f64,
        sliding: Sliding,
    ) -> bool {
        if self.edges.is_empty() {
            return false;
        }
        let angle = contacts.angle_rad(k);
        let found = self.edges.iter_mut().find(|(r, _)| r.contains(angle));
        let Some((raceway, largest)) = found else {
            return false;
        };
        let local = raceway.local_angle_rad(angle);
        let ratio = raceway
            .slot()
            .map_or(1.0, |slot| slot.pressure_ratio(local));
        let loaded = Loaded {
            point: (point_n, local),
            rank_n: point_n * ratio.powi(3),
        };
        largest.add(contacts.outer_force_n(k), loaded, sliding);
        true
    }

    /// Largest |α| + a/R to which a contact ellipse reaches in space: inner, outer groove.
    pub(crate) fn ellipse_edge_max_rad(&self) -> [f64; 2] {
        self.ellipse_edges.largest_rad()
    }

    /// Takes the contacts between balls, which last some tens of microseconds.
    pub(crate) fn look_between_balls(&mut self, contacts: &Contacts<'_>, speed_ratio: f64) {
        for k in 0..contacts.balls() {
            let force_n = contacts.pair_force_n(k);
            if force_n > 0.0 {
                let loaded = Loaded {
                    point: force_n,
                    rank_n: force_n,
                };
                let sliding = Sliding {
                    speed_m_s: contacts.pair_sliding_m_s(k),
                    speed_ratio,
                };
                self.balls.add(force_n, loaded, sliding);
            }
        }
    }

    /// The peaks so far. Surfaces pass the contacts at the speeds of rolling of the time of each.
    pub(crate) fn peaks(&self, case: &Case) -> ContactPeaks {
        let bearing = &case.bearing;
        let orbit = case.rolling_orbit_speed_rad_s();
        let d = bearing.dimensions();
        let contact = &case.contact;
        let friction = contact.friction.coefficient;
        let outer_friction = friction * contact.outer_friction_factor;
        let ball_friction = friction * contact.ball_friction_factor;
        let inner_m_s = (case.largest_inner_speed_rad_s() - orbit) * d.inner_groove_bottom_radius_m;
        let outer_m_s = orbit * d.outer_groove_bottom_radius_m;
        let ball_m_s = rolling_rotation_rad_s(bearing, orbit, d.ball_radius_m) * d.ball_radius_m;
        let inner = |point| RacewayContact::inner(bearing, point);
        let outer = |point| RacewayContact::outer(bearing, point);
        let between = |force_n| RacewayContact::new(bearing.ball_contact(), force_n);
        let edges = self.edges.iter().filter_map(|(raceway, largest)| {
            let slot = raceway.slot()?;
            let edge =
                |(force_n, local)| RacewayContact::new(&slot.contact(local, bearing), force_n);
            Some(largest.peak(outer_friction, edge, outer_m_s))
        });
        let [straight, angled] =
            (self.outer).map(|largest| largest.peak(outer_friction, outer, outer_m_s));
        ContactPeaks {
            inner: self.inner.peak(friction, inner, inner_m_s),
            outer: edges.fold(straight.or(angled), ContactPeak::or),
            balls: self.balls.peak(ball_friction, between, ball_m_s),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ContactPeak, Largest, Loaded, RacewayContact, Sliding};

    /// A contact whose pressure goes with the cube root of the force.
    fn alone(force_n: f64) -> Loaded<f64> {
        Loaded {
            point: force_n,
            rank_n: force_n,
        }
    }

    fn sliding(speed_m_s: f64, speed_ratio: f64) -> Sliding {
        Sliding {
            speed_m_s,
            speed_ratio,
        }
    }

    fn contact(force_n: f64) -> RacewayContact {
        RacewayContact {
            pressure_pa: 1e9 * force_n.cbrt(),
            semi_axes_m: [1e-4; 2],
        }
    }

    /// The largest force, pressure and product come from three contacts; the product and the flash
    /// temperature are those of one and the same.
    #[test]
    fn a_product_is_that_of_one_contact() {
        let mut largest = Largest::none();
        for (force_n, sliding_m_s) in [(1000.0, 0.1), (8.0, 2.0), (27.0, -1.5), (1.0, 3.5)] {
            largest.add(force_n, alone(force_n), sliding(sliding_m_s, 1.0));
        }
        let peak = largest.peak(0.1, contact, 10.0);
        assert_eq!(peak.force_n, 1000.0);
        assert!((peak.pressure_pa / 1e10 - 1.0).abs() < 1e-12);
        // 3 GPa at 1.5 m/s, not 2 GPa at 2 m/s, 1 GPa at 3.5 m/s or 10 GPa at 0.1 m/s.
        assert!((peak.pressure_velocity_pa_m_s / 4.5e9 - 1.0).abs() < 1e-12);
        // Blok: 1.11·μ·(π/2·p·a)·|√V₁ − √V₂|/(B·√(2a)), surfaces at 10 and 11.5 m/s.
        let roots = 11.5f64.sqrt() - 10f64.sqrt();
        let load = std::f64::consts::FRAC_PI_2 * 3e9 * 1e-4;
        let expected = 1.11 * 0.1 * load * roots / (12_888.0 * 2e-4f64.sqrt());
        assert!((peak.flash_temperature_k / expected - 1.0).abs() < 1e-9);
        assert_eq!(
            Largest::none().peak(0.1, contact, 10.0),
            ContactPeak::default()
        );
    }

    /// Surfaces pass the contact at the speed of its time: a quarter of the largest here.
    #[test]
    fn a_flash_temperature_is_that_of_its_time() {
        let mut largest = Largest::none();
        largest.add(27.0, alone(27.0), sliding(-1.5, 0.25));
        let found = largest.peak(0.1, contact, 10.0).flash_temperature_k;
        let roots = 4f64.sqrt() - 2.5f64.sqrt();
        let load = std::f64::consts::FRAC_PI_2 * 3e9 * 1e-4;
        let expected = 1.11 * 0.1 * load * roots / (12_888.0 * 2e-4f64.sqrt());
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }

    /// Where two points share a contact, the force is that of the ball, all else of one point.
    #[test]
    fn a_shared_force_ranks_by_one_point() {
        let mut largest = Largest::none();
        largest.add(1000.0, alone(400.0), sliding(1.0, 1.0));
        largest.add(900.0, alone(450.0), sliding(1.0, 1.0));
        let peak = largest.peak(0.1, contact, 10.0);
        assert_eq!(peak.force_n, 1000.0);
        assert_eq!(peak.pressure_pa, 1e9 * 450f64.cbrt());
        assert_eq!(peak.pressure_velocity_pa_m_s, peak.pressure_pa);
    }

    #[test]
    fn of_two_peaks_the_larger_of_each() {
        let peak =
            |force_n, pressure_pa, pressure_velocity_pa_m_s, flash_temperature_k| ContactPeak {
                force_n,
                pressure_pa,
                pressure_velocity_pa_m_s,
                flash_temperature_k,
            };
        let (a, b) = (peak(1.0, 20.0, 3.0, 5.0), peak(2.0, 10.0, 4.0, 3.0));
        assert_eq!(a.or(b), peak(2.0, 20.0, 4.0, 3.0));
        assert_eq!(b.or(a), peak(2.0, 20.0, 4.0, 3.0));
    }
}
