//! Numbers of a run in space beyond those of the plane.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::{Control, run};
//! use cageless::summary::SummaryRecorder;
//!
//! let mut case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! case.operation.space.axial_load_n = 150.0;
//! case.solver.duration_s = 0.002;
//! let mut recorder = SummaryRecorder::new();
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! let space = recorder.summary().unwrap().space.unwrap();
//! assert!(space.ring_z_mean_m > 0.0 && space.inner_contact_angle_mean_rad > 0.0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::case::Case;
use crate::dynamics::Contacts;
use crate::dynamics::coordinates::{RingCoordinate, SlidingCoordinate};
use crate::dynamics::layout::Layout;
use crate::dynamics::state::State;
use crate::numerics::vector::SectionVector;
use crate::simulation::StepView;

/// Numbers over the part of a run after its transient.
#[derive(Debug, Clone, PartialEq)]
pub struct SpatialSummary {
    /// Mean of the ring's centre along the axis.
    pub ring_z_mean_m: f64,
    /// Mean tilt of the ring about X and Y.
    pub tilt_mean_rad: [f64; 2],
    /// Angle of the sum of all forces at the inner raceway, each in its meridian plane and positive
    /// on the side of the contact sign of its row.
    pub inner_contact_angle_mean_rad: f64,
    /// Angle of the sum of all forces at the outer raceway, rad, signed as that at the inner raceway.
    pub outer_contact_angle_mean_rad: f64,
    /// Largest |α| + a/R to which a contact ellipse reaches: inner, outer groove.
    pub ellipse_edge_max_rad: [f64; 2],
    /// Displacement of the outer ring of each row against its contact sign at the start of the run.
    pub row_preload_start_m: Vec<f64>,
    /// Mean of that.
    pub row_preload_mean_m: Vec<f64>,
    /// Mean axial force of the balls of each row on its outer ring, friction included.
    pub row_axial_force_mean_n: Vec<f64>,
}

/// A row in a run.
#[derive(Debug, Clone, Default)]
struct RowTracker {
    contact_sign: f64,
    /// Index of its outer ring among those that slide.
    sliding: Option<usize>,
    /// Displacement against the contact sign at the start, m.
    start_m: f64,
    /// Integral of that displacement of a ring that slides, m·s.
    displaced_m_s: f64,
    /// Sum of the axial forces on its outer ring, N.
    force_n: f64,
}

impl RowTracker {
    /// Displacement of the outer ring in the housing against the contact sign, m, of one that slides.
    fn slid_m(&self, layout: Layout, y: &[f64]) -> Option<f64> {
        let z = y[layout.sliding(SlidingCoordinate::Z, self.sliding?)];
        Some(-self.contact_sign * (z - layout.outer_ring_along_axis(y).z))
    }
}

/// Follows a run for its [`SpatialSummary`].
#[derive(Debug, Clone, Default)]
pub(crate) struct SpatialSummaryTracker {
    time_s: f64,
    /// Integrals of z, p and q of the ring.
    ring: [f64; 3],
    /// Sums of the forces at the inner and the outer raceway, N; along the axis times the sign of the row.
    forces: [SectionVector; 2],
    rows: Vec<RowTracker>,
    looks: u32,
}

impl SpatialSummaryTracker {
    /// Follows a run of this case from its state at the start; `None` of a ring that stays in its plane.
    pub(crate) fn new(case: &Case, start: &State) -> Option<Self> {
        if !start.layout().moves(RingCoordinate::Z) {
            return None;
        }
        let sprung = case.sprung_rows();
        let rows = case.all_rows().into_iter().enumerate().map(|(k, row)| {
            let tracker = RowTracker {
                contact_sign: row.contact_sign,
                sliding: sprung.iter().position(|sprung| *sprung == k),
                ..RowTracker::default()
            };
            let slid_m = tracker.slid_m(start.layout(), start.values());
            RowTracker {
                start_m: slid_m.unwrap_or(row.preload_m),
                ..tracker
            }
        });
        Some(Self {
            rows: rows.collect(),
            ..Self::default()
        })
    }

    /// Takes a step of a run in space.
    pub(crate) fn step(&mut self, view: &StepView<'_>) {
        let step_s = view.step.size_s();
        let coordinates = [
            RingCoordinate::Z,
            RingCoordinate::TiltP,
            RingCoordinate::TiltQ,
        ];
        for (sum, coordinate) in self.ring.iter_mut().zip(coordinates) {
            let at = view.layout().ring(coordinate);
            *sum += 0.5 * step_s * (view.step.y0[at] + view.step.y1[at]);
        }
        let (layout, step) = (view.layout(), view.step);
        for row in &mut self.rows {
            let slid = [&step.y0, &step.y1].map(|y| row.slid_m(layout, y));
            if let [Some(before), Some(after)] = slid {
                row.displaced_m_s += 0.5 * step_s * (before + after);
            }
        }
        self.time_s += step_s;
    }

    /// Takes the contacts at the end of a step, with the sign of each ball's row.
    pub(crate) fn look(&mut self, contacts: &Contacts<'_>, signs: &[f64]) {
        for (k, row) in self.rows.iter_mut().enumerate() {
            row.force_n += contacts.row_axial_force_n(k);
        }
        self.looks += 1;
        for (k, sign) in signs.iter().enumerate() {
            let Some(ball) = contacts.in_space(k) else {
                return;
            };
            let forces = [ball.inner_force_n(), ball.outer_force_n()];
            for (sum, force) in self.forces.iter_mut().zip(forces) {
                sum.radial += force.radial;
                sum.axial += sign * force.axial;
            }
        }
    }

    /// The numbers so far, with how far ellipses reach; `None` before the first step.
    pub(crate) fn summary(&self, ellipse_edge_max_rad: [f64; 2]) -> Option<SpatialSummary> {
        let [inner, outer] = self.forces.map(|sum| sum.axial.atan2(sum.radial));
        let [z, p, q] = self.ring.map(|sum| sum / self.time_s);
        (self.time_s > 0.0).then_some(SpatialSummary {
            ring_z_mean_m: z,
            tilt_mean_rad: [0.0 - q, p],
            inner_contact_angle_mean_rad: inner,
            outer_contact_angle_mean_rad: outer,
            ellipse_edge_max_rad,
            row_preload_start_m: self.of_rows(|row| row.start_m),
            row_preload_mean_m: self.of_rows(|row| match row.sliding {
                Some(_) => row.displaced_m_s / self.time_s,
                None => row.start_m,
            }),
            row_axial_force_mean_n: self.of_rows(|row| row.force_n / f64::from(self.looks)),
        })
    }

    fn of_rows(&self, value: impl Fn(&RowTracker) -> f64) -> Vec<f64> {
        self.rows.iter().map(value).collect()
    }
}
