//! `cageless check`.

use std::f64::consts::TAU;

use cageless::film::{Film, Oil};
use cageless::linear_rotor::LinearRotor;
use cageless::simulation::RotorDrop;
use cageless::{Case, FlankModel, Formulation, Material, RacewayContact, RacewayPoint, SCOPE};
use cageless_io::arrangement::BearingArrangement;
use cageless_io::cad::blend_not_simulated;
use cageless_io::case_file::{Assumption, CaseDocument, CaseFile};
use cageless_io::rotor_file::RotorPlace;
use cageless_results::number_text::significant;
use cageless_results::{millipascal_seconds, slippery_asperities, thin_inlet};
use cageless_study::case_warnings;
use cageless_study::drop::foreseen;
use serde::Serialize;

use super::drop::listed;
use super::steps::{check_warnings, steps_text};
use crate::args::{CaseArgs, CheckArgs};
use crate::driver::{Answer, pretty};
use crate::failure::Failure;
use crate::format::{fixed, pairs, warnings};

const NUMBERS: &str = "check.json";

/// Oil of a film at the inlet of the contacts, in `check.json`.
#[derive(Serialize)]
struct OilAtInlet {
    viscosity_mpa_s: f64,
    viscosity_temperature_1_k: f64,
    pressure_viscosity_1_pa: f64,
    thermal_conductivity_w_m_k: f64,
    density_kg_m3: f64,
}

impl OilAtInlet {
    fn of(oil: Oil) -> Self {
        Self {
            viscosity_mpa_s: millipascal_seconds(oil.viscosity_pa_s),
            viscosity_temperature_1_k: oil.viscosity_temperature_1_k,
            pressure_viscosity_1_pa: oil.pressure_viscosity_1_pa,
            thermal_conductivity_w_m_k: oil.thermal_conductivity_w_m_k,
            density_kg_m3: oil.density_kg_m3,
        }
    }
}

/// `check.json` of a case.
#[derive(Serialize)]
struct Checked<'a> {
    valid: bool,
    case: CaseDocument,
    defaults: &'a [String],
    assumptions: &'a [Assumption],
    scope: [&'static str; SCOPE.len()],
    motion: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    oil: Option<OilAtInlet>,
    #[serde(skip_serializing_if = "Option::is_none")]
    blend_not_simulated: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_expansion_left_out: Option<String>,
    warnings: &'a [String],
}

/// `check.json` of a rotor file.
#[derive(Serialize)]
struct CheckedRotor {
    valid: bool,
    cases: Vec<CaseDocument>,
    mass_kg: f64,
    mass_shares_kg: Vec<f64>,
    step_us: f64,
    natural_frequencies_hz: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_expansion_left_out: Option<String>,
    warnings: Vec<String>,
}

/// Checks a case, or the file of a rotor above several bearings.
pub fn check(args: &CheckArgs) -> Result<(), Failure> {
    let (all, args) = (args.all, &args.case);
    let arrangement = BearingArrangement::read(&args.case, &args.set)?;
    let linear = arrangement
        .drop()
        .and_then(|drop| Some((drop, drop.rotor()?)));
    if let Some((drop, rotor)) = linear {
        return check_rotor(args, &arrangement, drop, rotor);
    }
    let file = &arrangement.cases()[0];
    let mut lines = vec![("case", format!("{} is valid", args.case.display()))];
    lines.extend(bearing_lines(file.case()));
    lines.push(("motion", motion_text(file.case()).to_owned()));
    if file.case().mixes_friction() {
        let friction = file.case().describe_friction();
        lines.push(("friction at the raceways", friction));
    }
    let oil = file.case().film.as_ref().map(|film| film.oil);
    lines.extend(oil.map(|oil| ("oil at the inlet", oil_text(&oil))));
    let supply = file.case().film.as_ref().and_then(supply_text);
    lines.extend(supply.map(|supply| ("supply of the contacts", supply)));
    let blend_not_simulated = blend_not_simulated(file.case());
    if let Some(sentence) = &blend_not_simulated {
        lines.push(("blend of the exported ring", sentence.clone()));
    }
    let speed_expansion_left_out = expansion_left_out([file]);
    lines.extend(expansion_line(&speed_expansion_left_out));
    lines.push(("steps of a run", steps_text(file.case())));
    let notes = notes(file, arrangement.drop());
    let assumptions = file.assumptions();
    for assumption in &assumptions {
        let (value, basis) = (assumption.value, assumption.basis);
        lines.push(("assumed", format!("{} = {value} ({basis})", assumption.key)));
    }
    if all {
        lines.extend(defaults_line(file));
        lines.extend(
            SCOPE
                .into_iter()
                .enumerate()
                .map(|(k, statement)| (if k == 0 { "scope" } else { "" }, statement.to_owned())),
        );
    }
    let result = Checked {
        valid: true,
        case: file.document_as_run(),
        defaults: file.defaults(),
        assumptions: &assumptions,
        scope: SCOPE,
        motion: match file.case().moves_in_space() {
            true => "space",
            false => "plane",
        },
        oil: oil.map(OilAtInlet::of),
        blend_not_simulated,
        speed_expansion_left_out,
        warnings: &notes,
    };
    let text = pairs(&lines) + &warnings(&notes);
    (args.output).deliver_numbers(Answer::new(NUMBERS, pretty(&result)?, text))
}

/// The bearing in lines.
fn bearing_lines(case: &Case) -> Vec<(&'static str, String)> {
    let bearing = &case.bearing;
    let d = bearing.dimensions();
    let mm = |pair: [f64; 2]| {
        let [one, other] = pair.map(|m| format!("{:.4} mm", m * 1e3));
        format!("{one}, {other}")
    };
    let conformity = |radius_m: f64| format!("{:.4}", radius_m / (2.0 * d.ball_radius_m));
    let degrees = |angle: f64| format!("{:.4}°", angle.to_degrees());
    let material = |m: &Material| {
        let gpa = m.youngs_modulus_pa / 1e9;
        format!(
            "{} kg/m³, E {gpa} GPa, ν {}",
            m.density_kg_m3, m.poisson_ratio
        )
    };
    let diameters = [2.0 * d.ball_radius_m, 2.0 * bearing.pitch_radius_m()];
    let bottoms = [
        d.inner_groove_bottom_radius_m,
        d.outer_groove_bottom_radius_m,
    ];
    let inner_conformity = conformity(d.inner_groove_curvature_radius_m);
    let outer_conformity = conformity(d.outer_groove_curvature_radius_m);
    let clearance = fixed(1e6 * bearing.radial_internal_clearance_m(), 3);
    vec![
        ("balls", format!("{}", bearing.balls())),
        ("ball diameter Dw, pitch diameter Dpw", mm(diameters)),
        ("groove bottom radii Ri, Ro", mm(bottoms)),
        (
            "conformities fi, fo",
            format!("{inner_conformity}, {outer_conformity}"),
        ),
        (
            "radial internal clearance Gr",
            format!("{clearance} µm (ISO 5753-1)") + &preload_text(case),
        ),
        ("balls of", material(&bearing.materials().ball)),
        ("rings of", material(&bearing.materials().ring)),
        (
            "ε, angular ball pitch at contact",
            degrees(bearing.ball_angle_rad()),
        ),
        ("nominal gap 360°/N − ε", degrees(bearing.nominal_gap_rad())),
    ]
}

/// Defaults that a case takes; `None` if it takes none.
fn defaults_line(file: &CaseFile) -> Option<(&'static str, String)> {
    let defaults = file.defaults().iter().map(|key| match file.value(key) {
        Some(value) => format!("{key} = {}", value.written()),
        None => key.clone(),
    });
    let defaults: Vec<_> = defaults.collect();
    (!defaults.is_empty()).then(|| ("defaults taken", defaults.join(", ")))
}

/// Warnings about a case.
fn notes(file: &CaseFile, drop: Option<&RotorDrop>) -> Vec<String> {
    let mut notes = check_warnings([file.case()]);
    notes.extend(case_warnings(file.case()));
    notes.extend(dry_motion(file));
    notes.extend(drop.into_iter().flat_map(foreseen));
    notes.extend(file.oil_temperature_warning());
    notes.extend(motion_refused(file));
    notes.extend(search_refused(file));
    notes.extend(slippery_asperities(file.case()));
    notes.extend(thin_inlet(file.case()));
    notes
}

/// Warning about a case at rest whose motion is refused.
fn motion_refused(file: &CaseFile) -> Option<String> {
    let error = file.checked(Case::check_run).err()?;
    let command = match file.case().rotor {
        Some(_) => "drop",
        None => "run",
    };
    Some(format!("`{command}` refuses this case: {error}"))
}

/// Warning about a `[search]` that `design --search` refuses.
fn search_refused(file: &CaseFile) -> Option<String> {
    let error = file.request_to_run().err()?;
    Some(format!("`design --search` refuses this case: {error}"))
}

/// Oil of a film at the inlet of the contacts, in a line.
fn oil_text(oil: &Oil) -> String {
    format!(
        "η {} mPa·s, β_T {} 1/K, α {:.2e} 1/Pa, λ {} W/(m·K), {} kg/m³",
        significant(millipascal_seconds(oil.viscosity_pa_s), 4),
        significant(oil.viscosity_temperature_1_k, 3),
        oil.pressure_viscosity_1_pa,
        significant(oil.thermal_conductivity_w_m_k, 3),
        significant(oil.density_kg_m3, 4)
    )
}

/// Supply that a film at the inlet gives, in a line.
fn supply_text(film: &Film) -> Option<String> {
    let ratio = significant(film.inlet_ratio?, 3);
    let share = significant(film.supply, 3);
    Some(format!(
        "{share} of flooded: film.inlet_film_um is {ratio} times the least flooded film"
    ))
}

/// Warning about a lubricated case whose motion is computed dry.
fn dry_motion(file: &CaseFile) -> Option<String> {
    let dry = file.particulars().lubrication.is_some() && file.case().film.is_none();
    dry.then(|| {
        let add = file.case().why_without_film().unwrap_or(
            "add [film] with supply, oil and temperature_c, and leave out lubrication.viscosity_mm2_s",
        );
        format!(
            "[lubrication] is for ratings: the motion is computed without an oil film; {add}"
        )
    })
}

/// Where the balls of a run move, and whether the plane suffices.
fn motion_text(case: &Case) -> &'static str {
    let elastic = case.flanks == FlankModel::Elastic;
    match (case.moves_in_space(), case.formulation) {
        (true, _) => "in space, which takes many times as long as the plane",
        (false, Formulation::Paper) => "in the plane, as published",
        (false, _) if elastic || case.raceways.is_empty() => {
            "in the plane, which suffices: no axial load, tilt or contact angle"
        }
        (false, _) => {
            "in the plane with rigid flanks, in which balls lag more than in those of metal: \
             model.flanks = \"elastic\" or model.motion = \"space\" has these"
        }
    }
}

/// Lowest natural frequencies of a rotor at its speed without contact.
fn natural_frequencies_hz(
    args: &CaseArgs,
    arrangement: &BearingArrangement,
    drop: &RotorDrop,
    rotor: &LinearRotor,
) -> Result<Vec<f64>, Failure> {
    let at_speed = rotor.eigenvalues(drop.speed_rad_s());
    let at_speed = at_speed.ok_or_else(|| {
        let path = args.case.display();
        let rpm = arrangement.rotor_file().map_or(0.0, |file| file.speed_rpm);
        Failure::Input(format!(
            "{path}: rotor.speed_rpm = {rpm:?} is not possible: forces at this speed are beyond the \
             range of numbers"
        ))
    })?;
    let mut frequencies: Vec<f64> = (at_speed.iter())
        .map(|value| value.im / TAU)
        .filter(|frequency| *frequency > LEAST_FREQUENCY_HZ)
        .collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies.truncate(FREQUENCIES);
    Ok(frequencies)
}

/// Checks a rotor file.
fn check_rotor(
    args: &CaseArgs,
    arrangement: &BearingArrangement,
    drop: &RotorDrop,
    rotor: &LinearRotor,
) -> Result<(), Failure> {
    let cases = drop.cases();
    let frequencies = natural_frequencies_hz(args, arrangement, drop, rotor)?;
    let shares = rotor.mass_shares_kg();
    let step_us = 1e6 * cases[0].solver.step_s;
    let speed_expansion_left_out = expansion_left_out(arrangement.cases());
    let mut lines = vec![
        ("rotor", format!("{} is valid", args.case.display())),
        ("bearings", cases.len().to_string()),
        ("mass", format!("{} kg", significant(rotor.mass_kg, 4))),
        (
            "shares of the mass at the bearings",
            format!("{} kg", listed(&shares)),
        ),
        (
            "lowest natural frequencies at speed, without contact",
            match frequencies.is_empty() {
                true => "–".to_owned(),
                false => format!("{} Hz", listed(&frequencies)),
            },
        ),
        ("steps of a drop", steps_text(&cases[0])),
    ];
    lines.extend(expansion_line(&speed_expansion_left_out));
    let mut notes = check_warnings(cases);
    notes.extend(foreseen(drop));
    notes.extend(plane_meets_the_stator(arrangement));
    let checked = CheckedRotor {
        valid: true,
        cases: arrangement
            .cases()
            .iter()
            .map(|b| b.document_as_run())
            .collect(),
        mass_kg: rotor.mass_kg,
        mass_shares_kg: shares,
        step_us,
        natural_frequencies_hz: frequencies,
        speed_expansion_left_out,
        warnings: notes,
    };
    let text = pairs(&lines) + &warnings(&checked.warnings);
    (args.output).deliver_numbers(Answer::new(NUMBERS, pretty(&checked)?, text))
}

/// Warnings of planes of a rigid horizontal rotor that meet the stator before it rests in two bearings.
fn plane_meets_the_stator(arrangement: &BearingArrangement) -> Vec<String> {
    let (Some(file), Some(drop)) = (arrangement.rotor_file(), arrangement.drop()) else {
        return vec![];
    };
    let journals = file.rotor.bearings.iter().zip(arrangement.cases());
    let journals: Option<Vec<[f64; 2]>> = journals
        .map(|(place, case)| {
            let clearance_um = case.document().number("rotor.radial_clearance_um")?;
            Some([axial_mm(*place)?, clearance_um])
        })
        .collect();
    let Some([[z_1, sag_1], [z_2, sag_2]]) = journals.as_deref().filter(|_| !drop.is_vertical())
    else {
        return vec![];
    };
    let clearances = file.rotor.clearances.iter();
    let first = clearances.filter_map(|plane| {
        let z = axial_mm(plane.place)?;
        let sag_um = sag_1 + (sag_2 - sag_1) * (z - z_1) / (z_2 - z_1);
        let meets = sag_um.abs() >= plane.radial_um;
        meets.then(|| {
            format!(
                "the rotor meets the stator at {} before it rests in its bearings: there it is displaced by {} µm, of \
                 a clearance of {} µm",
                plane.name,
                significant(sag_um.abs(), 3),
                significant(plane.radial_um, 3)
            )
        })
    });
    first.collect()
}

/// Distance of a place from the mass centre of a rigid rotor, mm.
fn axial_mm(place: RotorPlace) -> Option<f64> {
    match place {
        RotorPlace::AxialMm(axial_mm) => Some(axial_mm),
        RotorPlace::Node(_) => None,
    }
}

/// Expansion of the inner raceway by its speed that a clearance may leave out unsaid, m.
const EXPANSION_UNSAID_M: f64 = 1e-6;
/// Lines on the same values over the clearance.
const EXPANSION_UNSAID: f64 = 0.1;

/// Largest expansion by speed that the clearances of cases leave out, in a sentence, where it is not small.
fn expansion_left_out<'c>(files: impl IntoIterator<Item = &'c CaseFile>) -> Option<String> {
    let left_out = files.into_iter().filter_map(|file| {
        let case = file.case();
        let (growth_m, clearance_m) = (
            case.speed_expansion_m(),
            case.bearing.radial_internal_clearance_m(),
        );
        let share = EXPANSION_UNSAID * clearance_m.abs();
        let is_said = growth_m > EXPANSION_UNSAID_M || clearance_m != 0.0 && growth_m > share;
        // A fit takes the expansion off, but from the clearance of a ring that a drop meets at rest.
        let is_left_out = file.particulars().fit.is_none() || case.rotor.is_some();
        (is_said && is_left_out).then_some((growth_m, case.rotor.is_some()))
    });
    let (growth_m, drops) = left_out.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let remedy = match drops {
        true => "the clearance is that at rest",
        false => "[fit] takes it off the clearance",
    };
    Some(format!(
        "{} µm at the largest speed, a free ring; left out: {remedy}",
        fixed(1e6 * growth_m, 1)
    ))
}

fn expansion_line(left_out: &Option<String>) -> Option<(&'static str, String)> {
    let sentence = left_out.clone()?;
    Some(("expansion of the inner raceway", sentence))
}

/// Natural frequencies that a check lists.
const FREQUENCIES: usize = 8;
/// Below, a rotor moves freely.
const LEAST_FREQUENCY_HZ: f64 = 1e-3;

/// Preload of a bearing with interference, after its clearance; empty for any other.
fn preload_text(case: &Case) -> String {
    let force = case.preload_n();
    if force == 0.0 {
        return String::new();
    }
    let point = RacewayPoint {
        force_n: force,
        cosine: 1.0,
    };
    format!(
        ": preload, unloaded balls are pressed with {} N, {:.0} MPa at the inner raceway",
        significant(force, 3),
        1e-6 * RacewayContact::inner(&case.bearing, point).pressure_pa
    )
}
