use cageless::passage::PassageTally;
use cageless::simulation::{Control, RunOutcome, run};
use cageless::summary::{ContactPeak, ContactPeaks};
use cageless::summary::{Summary, SummaryRecorder};
use cageless_design::RunVerdict;
use cageless_io::case_file::{CaseFile, template};
use cageless_results::number_text::short;

use super::*;

/// A short run whose numbers the tests change one at a time.
struct Run {
    case: Case,
    outcome: RunOutcome,
    summary: Option<Summary>,
}

impl Run {
    fn new(changes: &[&str]) -> Self {
        let mut all = vec!["solver.duration_s=0.002".to_owned()];
        all.extend(changes.iter().map(|c| (*c).to_owned()));
        let file = CaseFile::parse(&template(false), "case.toml", &all).unwrap();
        let case = file.case().clone();
        let mut recorder = SummaryRecorder::new();
        let outcome = run(&case, &mut [&mut recorder], &mut |_| Control::Continue(())).unwrap();
        let mut summary = recorder.summary();
        if let Some(summary) = &mut summary {
            summary.peaks = ContactPeaks::default();
            orbits(summary, 1);
        }
        Self {
            case,
            outcome,
            summary,
        }
    }

    fn warnings(&self) -> Vec<String> {
        warnings(&Finished {
            case: &self.case,
            outcome: &self.outcome,
            summary: self.summary.as_ref(),
            passages: &PassageTally::new(),
            verdict: &RunVerdict::unfinished(&self.case, "a test"),
            wall_s: 1.0,
        })
    }

    /// One warning with this in it, on one side of a limit, and none on the other.
    fn changes(&mut self, warned: bool, part: &str, change: impl FnOnce(&mut Self)) {
        change(self);
        let found = self.warnings();
        assert_eq!(found.len(), usize::from(warned), "{part}: {found:?}");
        assert!(
            found.iter().all(|text| text.contains(part)),
            "{part}: {found:?}"
        );
    }
}

/// Structure (d) in oil: balls queue from about 37 mPa·s on, where d exceeds the free share of the pitch circle.
#[test]
fn balls_that_may_queue_in_oil_are_warned_of() {
    let queues = |viscosity: &str| {
        let run = Run::new(&[
            viscosity,
            "film.viscosity_temperature_1_k=0.035",
            "film.supply=flooded",
        ]);
        let found = run.warnings().into_iter();
        found.filter(|text| text.contains("queue")).count()
    };
    assert_eq!(queues("film.viscosity_mpa_s=30"), 0);
    assert_eq!(queues("film.viscosity_mpa_s=45"), 1);
}

fn orbits(summary: &mut Summary, count: u32) {
    summary.means.as_mut().unwrap().orbits = count;
}

#[test]
fn means_of_less_than_an_orbit_are_called_so() {
    let mut run = Run::new(&[]);
    for (count, warned) in [(0, true), (1, false)] {
        let part = "the run ends within an orbit";
        run.changes(warned, part, |run| {
            orbits(run.summary.as_mut().unwrap(), count)
        });
    }
}

#[test]
fn each_peak_of_a_contact_has_its_limit() {
    type Of = fn(&mut ContactPeaks) -> &mut ContactPeak;
    let places: [(Of, &str); 3] = [
        (|p| &mut p.inner, "at the inner raceway"),
        (|p| &mut p.outer, "at the outer raceway"),
        (|p| &mut p.balls, "between balls"),
    ];
    for (of, place) in places {
        let mut run = Run::new(&[]);
        let set = |run: &mut Run, peak: ContactPeak| {
            *of(&mut run.summary.as_mut().unwrap().peaks) = peak;
        };
        let pressure = |pressure_pa: f64| ContactPeak {
            pressure_pa,
            ..ContactPeak::default()
        };
        let text = format!("the contact pressure {place} reaches 4200 MPa, above the 4200 MPa");
        run.changes(false, "", |run| set(run, pressure(4.2e9)));
        run.changes(true, &text, |run| set(run, pressure(4.2e9f64.next_up())));
        // 900 MPa·m/s at 150 K are what 1200 MPa·m/s at 200 K would be at the limit.
        let heated = |flash_temperature_k: f64| ContactPeak {
            pressure_velocity_pa_m_s: 6e6 * flash_temperature_k,
            flash_temperature_k,
            ..ContactPeak::default()
        };
        let text =
            format!("pressure × sliding speed {place} reaches 1200 MPa·m/s, above the 900 that");
        run.changes(false, "", |run| set(run, heated(150.0)));
        run.changes(true, place, |run| set(run, heated(150f64.next_up())));
        run.changes(true, &text, |run| set(run, heated(200.0)));
    }
}

#[test]
fn ellipses_that_a_shoulder_cuts_off_are_named() {
    let mut run = Run::new(&["model.motion=\"space\""]);
    let ends = run.case.bearing.shoulder_angles_rad();
    for (ring, name) in ["inner", "outer"].into_iter().enumerate() {
        let set = |run: &mut Run, edge: f64| {
            let summary = run.summary.as_mut().unwrap();
            let space = summary.space.as_mut().unwrap();
            space.ellipse_edge_max_rad = [0.0; 2];
            space.ellipse_edge_max_rad[ring] = edge;
        };
        let text = format!("the shoulder of the {name} ring cuts off contact ellipses");
        run.changes(false, "", |run| set(run, ends[ring]));
        run.changes(true, &text, |run| set(run, ends[ring].next_up()));
    }
}

#[test]
fn speed_and_heat_have_their_limits() {
    let mut run = Run::new(&[]);
    // n·Dpw with Dpw = 18.24 + 27.765 mm.
    let rpm = |parameter: f64| parameter / (18.24 + 27.765);
    let turning = |run: &mut Run, rpm: f64| {
        run.case.operation.inner_speed_rad_s = rpm * std::f64::consts::PI / 30.0;
        // What rolls faster carries more load and may slide more: that is not asked here.
        run.case.solver.step_s = 1e-9;
    };
    let text = "n·Dpw is 3.00 million mm/min, above the 3 million";
    run.changes(false, "", |run| turning(run, rpm(3e6 * (1.0 - 1e-9))));
    run.changes(true, text, |run| turning(run, rpm(3e6 * (1.0 + 1e-9))));
    // Either way round.
    run.changes(true, text, |run| turning(run, -rpm(3e6 * (1.0 + 1e-9))));

    let mut run = Run::new(&[]);
    run.changes(true, "ended within its transient: no statistics", |run| {
        run.summary = None
    });

    // A bearing of dm and a width of 1.9 ball diameters gives off 16 kW/m² over 2π·B·dm.
    let means = Run::new(&[]).summary.unwrap().means.unwrap();
    let heat_w = means.heat_w.max(means.power_loss_w);
    let of_size = |run: &mut Run, factor: f64| {
        let mut d = run.case.bearing.dimensions().clone();
        let (ball, dm) = (9.525e-3, 18.24e-3 + 27.765e-3);
        let reference_w = 16e3 * TAU * 1.9 * ball * dm;
        let scale = (factor * heat_w / reference_w).sqrt();
        for length in [
            &mut d.ball_radius_m,
            &mut d.inner_groove_bottom_radius_m,
            &mut d.outer_groove_bottom_radius_m,
            &mut d.outer_shoulder_radius_m,
            &mut d.inner_groove_curvature_radius_m,
            &mut d.outer_groove_curvature_radius_m,
        ] {
            *length *= scale;
        }
        // The raceway belongs to the larger bearing; load and speed are those of this one.
        run.case.raceways = vec![];
        run.case.operation.inner_speed_rad_s = 100.0;
        run.case.operation.radial_load_n = 0.0;
        run.case.solver.step_s = 1e-9;
        run.case.bearing = cageless::Bearing::new(d, *run.case.bearing.materials()).unwrap();
    };
    let mut run = Run::new(&[]);
    run.changes(false, "", |run| of_size(run, 1.0 + 1e-9));
    let mut run = Run::new(&[]);
    run.changes(true, "the power loss of", |run| of_size(run, 1.0 - 1e-9));
    let mut run = Run::new(&[]);
    run.changes(true, "is 2 times the", |run| of_size(run, 0.5));
}

/// Each limit of the step, at it and beyond it.
#[test]
fn each_limit_of_the_step_warns_beyond_it() {
    let mut undamped = Run::new(&[
        "contact.damping_n_s_m1_5=0",
        "contact.ball_restitution=1",
        "solver.method=abm4",
    ]);
    undamped.changes(false, "", |run| run.case.solver.step_s = 0.5e-6);
    let text = "ABM4 gains energy at steps above 0.5 µs";
    undamped.changes(true, text, |run| {
        run.case.solver.step_s = 0.5e-6f64.next_up()
    });
    undamped.changes(false, "", |run| run.case.contact.damping_n_s_m1_5 = 2e5);
    undamped.changes(false, "", |run| {
        run.case.contact.damping_n_s_m1_5 = 0.0;
        run.case.solver.method = IntegrationMethod::VelocityVerlet;
    });

    let mut stiff = Run::new(&["solver.method=abm4", "contact.friction_coefficient=0.1"]);
    let resolved = StepLimits::new(&stiff.case).friction_resolved_to_s(IntegrationMethod::Abm4);
    assert!(resolved.is_finite());
    stiff.changes(false, "", |run| run.case.solver.step_s = resolved);
    let text = format!(
        "sliding speeds near zero are wrong for steps above {} µs",
        short(1e6 * resolved)
    );
    stiff.changes(true, &text, |run| {
        run.case.solver.step_s = resolved.next_up()
    });

    let falling = [
        "contact.friction_law=stribeck",
        "contact.friction_coefficient=0.1",
        "contact.static_friction_coefficient=0.2",
        "contact.stribeck_speed_m_s=0.05",
    ];
    let mut falling = Run::new(&falling);
    let method = falling.case.solver.method;
    let resolved = StepLimits::new(&falling.case).falling_resolved_to_s(method);
    falling.changes(false, "", |run| run.case.solver.step_s = resolved);
    let text = "such jumps are not resolved";
    falling.changes(true, text, |run| {
        run.case.solver.step_s = resolved.next_up()
    });

    let mut creeping = Run::new(&[
        "solver.method=abm4",
        "contact.friction_law=coulomb",
        "contact.friction_coefficient=0.3",
    ]);
    let creep = StepLimits::new(&creeping.case).creep_m_s2(IntegrationMethod::Abm4);
    let knee = creeping.case.contact.friction.regularisation_speed_m_s;
    creeping.changes(false, "", |run| {
        run.case.solver.step_s = knee / creep * (1.0 - 1e-12)
    });
    let text = format!("creep by up to {knee:.2} m/s");
    creeping.changes(true, &text, |run| {
        run.case.solver.step_s = knee / creep * (1.0 + 1e-12)
    });
}

/// Of friction that is viscous where the raceway of Zhao 2022, structure (d), slows the balls:
/// cos α = √(1 − (lC/2Rw)²), and a ball that rolls is slowed by (1 − cos α)/(1 + cos α).
#[test]
fn a_regularisation_speed_is_small_against_the_slowing_of_a_raceway() {
    let mut slow = Run::new(&["operation.inner_speed_rpm=1000"]);
    let bearing = &slow.case.bearing;
    let sine = slow.case.raceways[0].dimensions().axial_span_m / (2.0 * bearing.ball_radius_m());
    let cosine = (1.0 - sine * sine).sqrt();
    let slowed = slow.case.rolling_orbit_speed_rad_s() * bearing.pitch_radius_m() * (1.0 - cosine)
        / (1.0 + cosine);
    let knee = |factor: f64| {
        move |run: &mut Run| run.case.contact.friction.regularisation_speed_m_s = factor * slowed
    };
    slow.changes(false, "", knee(0.05 * (1.0 - 1e-9)));
    slow.changes(
        true,
        "the raceway slows balls by",
        knee(0.05 * (1.0 + 1e-9)),
    );
    // Kalker's creep gives one at each contact.
    slow.changes(false, "", |run| {
        run.case.contact.friction.regularisation_speed_m_s = slowed;
        run.case.contact.regularisation = Regularisation::Kalker;
    });
    slow.case.raceways.clear();
    slow.changes(false, "", |_| ());
}
