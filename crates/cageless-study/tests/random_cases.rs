//! Random valid runs and drops, bunched starts included: whatever the case, its end is true.
//! `CAGELESS_RANDOM_CASES=3000` tries as many in place of those of the suite.

use cageless::dynamics::{Model, RightHandSide};
use cageless::simulation::{Cause, Ending, RotorDrop, RunOutcome};
use cageless::{BearingDimensions, SHOULDER_HEIGHT};
use cageless_io::case_file::{CaseError, CaseFile};
use cageless_study::Silent;
use cageless_study::drop::{DropRequest, study};
use cageless_study::run::{Options, run};
use rayon::prelude::*;

/// Cases of the suite.
const CASES: u64 = 120;
/// Steps of each at most.
const STEPS: f64 = 12_000.0;

/// Uniform numbers in [0, 1) of splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) as f64 / 2f64.powi(64)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// A number of any order of magnitude between two.
    fn scale(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.next())
    }

    fn pick<'t>(&mut self, from: &[&'t str]) -> &'t str {
        from[(self.next() * from.len() as f64) as usize]
    }
}

/// Case `index` as a file: every second one is a drop.
fn text(index: u64) -> String {
    let mut r = Random(index.wrapping_mul(0x5851_F42D_4C95_7F2D));
    let drops = index % 2 == 1;
    let balls = 3 + (18.0 * r.next()) as usize;
    let diameter = r.scale(2.0, 25.0);
    // From as many balls as there is room for to half of that.
    let around = balls as f64 * r.between(1.02, 2.0);
    let pitch = diameter / (std::f64::consts::PI / around.max(3.2)).sin();
    let clearance = r.between(-10.0, 80.0);
    let law = match r.pick(&["smooth", "coulomb", "stribeck"]) {
        "stribeck" => "\"stribeck\"\nstatic_friction_coefficient = 0.6\nstribeck_speed_m_s = 1.0",
        "coulomb" => "\"coulomb\"",
        _ => "\"smooth\"",
    };
    let (mu, damping) = (r.scale(0.003, 0.4), r.scale(2e4, 1e6));
    let (gaps, lead) = (
        r.pick(&["uniform", "bunched", "random"]),
        r.between(0.0, 360.0),
    );
    let seed = index;
    let gravity = [9.81, 9.81, 0.0][(3.0 * r.next()) as usize];
    let mut text = format!(
        "schema = 1\n[bearing]\nballs = {balls}\nball_diameter_mm = {diameter}\n\
         pitch_diameter_mm = {pitch}\nradial_internal_clearance_um = {clearance}\n"
    );
    let common = format!(
        "[contact]\nfriction_law = {law}\nfriction_coefficient = {mu}\ndamping = {damping}\n\
         [solver]\nmethod = \"verlet\"\nstep_us = \"auto\"\nduration_s = 1.0\nseed = {seed}\n\
         [start]\ngaps = \"{gaps}\"\nlead_ball_angle_deg = {lead}\n"
    );
    let speed = r.scale(0.01, 1.0) * 600e3 / pitch;
    // A static rating of some 12 N per mm² of the balls.
    let rating = 12.0 * balls as f64 * diameter * diameter;
    if drops {
        let (mass, bore) = (
            r.scale(1e-3, 2e-2) * rating / 9.81,
            0.5 * pitch - 0.9 * diameter,
        );
        let (bore, gap) = (bore.max(0.3 * (pitch - diameter)), r.between(50.0, 300.0));
        let fall = (2.0 * 9.81 * gap * 1e-6).sqrt();
        let ring = 8e-6 * (pitch / 46.0).powi(4) * diameter;
        let inertia = 1e-3 * mass * (bore * 1e-3).powi(2) * 1e3;
        let journal = r.scale(0.02, 0.5);
        text += &format!(
            "inner_ring_bore_radius_mm = {bore}\ninner_ring_polar_inertia_kg_m2 = {ring}\n{common}\
             [operation]\ngravity_m_s2 = {gravity}\n\
             [rotor]\nmass_kg = {mass}\npolar_inertia_kg_m2 = {inertia}\nspeed_rpm = {speed}\n\
             radial_clearance_um = {gap}\nfriction_coefficient = {journal}\ncontact_stiffness_n_mp = 1e9\n\
             contact_damping_s_m = 0.3\ny_um = -{}\nvy_m_s = -{fall}\n",
            0.98 * gap
        );
        if r.next() < 0.6 {
            let (mass, damping) = (0.05 * mass + 0.01, 400.0 * mass.sqrt());
            text += &format!(
                "[support]\nmass_kg = {mass}\nstiffness_n_m = 2e7\ndamping_n_s_m = {damping}\n"
            );
        }
    } else {
        let (load, state) = (r.scale(1e-4, 0.1) * rating, r.pick(&["settled", "rolling"]));
        let load = if r.next() < 0.2 { 0.0 } else { load };
        text += &format!(
            "{common}state = \"{state}\"\n[operation]\ninner_speed_rpm = {speed}\n\
             radial_load_n = {load}\ngravity_m_s2 = {gravity}\n"
        );
    }
    text
}

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    Refused,
    Complete,
    Fallen,
    Overloaded,
    /// The step is too long for what happens, and half of it is not, as the message says.
    Coarse,
}

/// Computes a case. Its end, or what is wrong with it.
fn end(index: u64) -> Result<End, String> {
    let text = text(index);
    let parsed = |sets: &[String]| CaseFile::parse(&text, "case.toml", sets);
    let Ok(file) = parsed(&[]) else {
        return Ok(End::Refused);
    };
    let duration = (STEPS * file.case().solver.step_s).min(0.02);
    let file = parsed(&[format!("solver.duration_s={duration}")]).map_err(|e| e.to_string())?;
    let Some(outcome) = outcome(&file) else {
        return Ok(End::Refused);
    };
    let judged = judged(&file, &outcome);
    if let (Err(_), Ending::Stopped(stop)) = (&judged, &outcome.ending) {
        let half = format!("solver.step_us={}", 0.5e6 * stop.step_s);
        let sets = [format!("solver.duration_s={duration}"), half];
        let energy = matches!(
            stop.cause,
            Cause::EnergyFromNowhere { .. } | Cause::Unbalanced { .. }
        );
        if energy && balanced(&parsed(&sets)) {
            return Ok(End::Coarse);
        }
    }
    judged.map_err(|wrong| format!("{wrong}\n{text}"))
}

/// What comes of a run or drop; `None` if it is refused.
fn outcome(file: &CaseFile) -> Option<RunOutcome> {
    if let Some(drop) = RotorDrop::of_case(file.case()) {
        let variant = file.clone().into();
        let found = study(&variant, drop, DropRequest::default(), vec![None], &Silent).ok()?;
        return Some(found.record.into_last_outcome());
    }
    let options = Options {
        rows: None,
        verify: false,
    };
    Some(run(file, options, &Silent).ok()?.outcome)
}

/// Whether a run or drop completes with its energy accounted for.
fn balanced(file: &Result<CaseFile, CaseError>) -> bool {
    let outcome = file.as_ref().ok().and_then(outcome);
    outcome.is_some_and(|outcome| matches!(outcome.ending, Ending::Complete))
}

/// Distance of the centres of the rings at which their shoulders meet.
fn shoulder_clearance_m(d: &BearingDimensions) -> f64 {
    let inner = d.inner_shoulder_radius_m;
    let inner =
        inner.unwrap_or(d.inner_groove_bottom_radius_m + 2.0 * SHOULDER_HEIGHT * d.ball_radius_m);
    d.outer_shoulder_radius_m - inner
}

fn judged(file: &CaseFile, outcome: &RunOutcome) -> Result<End, String> {
    match &outcome.ending {
        Ending::Complete => {
            let mut equations = RightHandSide::new(&Model::new(file.case()).unwrap());
            let angles = vec![0.0; outcome.state.layout().balls];
            let end = equations.snapshot(outcome.end_s, &outcome.state, &angles);
            let housing_m = end
                .rotor
                .map_or([0.0; 2], |r| [r.housing_x_m, r.housing_y_m]);
            let off = (end.ring.x_m - housing_m[0]).hypot(end.ring.y_m - housing_m[1]);
            if off > shoulder_clearance_m(file.case().bearing.dimensions()) {
                return Err(format!("the rings overlap: {off:e} m"));
            }
            let residual = outcome.energy_residual_relative;
            if residual.abs() > 0.01 {
                return Err(format!("a residual of {residual:e}"));
            }
            Ok(End::Complete)
        }
        Ending::Stopped(stop) => match stop.cause {
            Cause::RingsMeet { .. } => Ok(End::Fallen),
            Cause::NotFinite
            | Cause::EnergyFromNowhere { .. }
            | Cause::Unbalanced { .. }
            | Cause::NotResolved => Err(format!("a false alarm: {stop}")),
            _ => Ok(End::Overloaded),
        },
        other => Err(format!("{other:?}")),
    }
}

#[test]
fn random_runs_and_drops_end_as_they_say() {
    let asked = std::env::var("CAGELESS_RANDOM_CASES").ok();
    let cases = asked.map_or(CASES, |n| n.parse().expect("a number of cases"));
    let indices = (0..cases).into_par_iter();
    let ends: Vec<(u64, Result<End, String>)> = indices.map(|index| (index, end(index))).collect();
    let wrong: Vec<String> = (ends.iter())
        .filter_map(|(index, end)| Some(format!("case {index}: {}", end.as_ref().err()?)))
        .collect();
    let count = |end: End| ends.iter().filter(|(_, e)| *e == Ok(end)).count();
    let [refused, complete, fallen, overloaded, coarse] = [
        End::Refused,
        End::Complete,
        End::Fallen,
        End::Overloaded,
        End::Coarse,
    ]
    .map(count);
    println!(
        "{cases} cases: {complete} complete, {fallen} rings fell, {overloaded} overloads, \
         {coarse} steps too long, {refused} refused, {} wrong",
        wrong.len()
    );
    let too_long = ends.iter().filter(|(_, end)| *end == Ok(End::Coarse));
    let too_long: Vec<u64> = too_long.map(|(index, _)| *index).collect();
    println!("steps too long: {too_long:?}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    // Forces that nobody can tell beforehand, as of a rotor in dry backward whirl.
    assert!(
        1000 * coarse as u64 <= cases,
        "{coarse} automatic steps are too long"
    );
    // The generator finds what it is to find.
    assert!(complete as f64 > 0.5 * cases as f64, "{complete}");
}

/// Random cases whose automatic step was too long: few balls, or unevenly spaced ones at
/// rest, below a falling rotor, or a ring that is lighter than its balls.
#[test]
fn the_automatic_step_resolves_the_impact_of_a_rotor_on_few_balls() {
    for index in [167, 391, 731, 1399] {
        assert_eq!(end(index), Ok(End::Complete), "case {index}");
    }
    // At half the step next to nothing is unaccounted for.
    let file = |sets: &[String]| CaseFile::parse(&text(1399), "case.toml", sets).unwrap();
    let half = format!("solver.step_us={}", 0.5e6 * file(&[]).case().solver.step_s);
    let file = file(&[half, "solver.duration_s=0.006".to_owned()]);
    let residual = outcome(&file).unwrap().energy_residual_relative;
    assert!(residual.abs() < 1e-3, "{residual}");
    // Dry backward whirl, whose force nothing but the run tells: the alarm is true, and half the step balances.
    assert_eq!(end(407), Ok(End::Coarse));
}
