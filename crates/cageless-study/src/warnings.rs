//! Warnings of a run: what its numbers do not show, and what no bearing stands.

use std::f64::consts::TAU;

use cageless::contact::FLASH_TEMPERATURE_LIMIT_K;
use cageless::contact::STRESS_LIMIT_PA;
use cageless::equilibrium;
use cageless::film::FilmAtRest;
use cageless::rating::speed_warning;
use cageless::step_limits::StepLimits;
use cageless::summary::{ContactPeak, ContactPeaks};
use cageless::{Case, IntegrationMethod, Raceway, Regularisation};

use cageless_results::number_text::short;
use cageless_results::{DropResult, Finished, overheating, slippery_asperities, thin_inlet};

/// Largest step at which ABM4 stays unbiased without contact damping.
const UNDAMPED_STEP_S: f64 = 0.5e-6;

/// Warnings of a run.
pub(crate) fn warnings(run: &Finished<'_>) -> Vec<String> {
    let mut warnings = of_case(run.case);
    warnings.extend(of_film(run.case));
    warnings.extend(slippery_asperities(run.case));
    warnings.extend(thin_inlet(run.case));
    warnings.extend(beyond_bearings(run));
    match run.summary.map(|summary| summary.means) {
        None => warnings.push("the run ended within its transient: no statistics".to_owned()),
        Some(Some(means)) if means.orbits == 0 => warnings.push(
            "the run ends within an orbit of the balls: powers, torque and mean speeds are those of its end, not of \
             steady operation (solver.duration_s)"
                .to_owned(),
        ),
        Some(_) => {}
    }
    warnings
}

/// Warnings of the film of a case at rest.
fn of_film(case: &Case) -> Vec<String> {
    let settled = case.film.and_then(|_| equilibrium::settle(case).ok());
    let film = settled.and_then(|settled| FilmAtRest::new(case, &settled));
    film.map_or(vec![], |film| film.warnings())
}

/// Warnings of a drop onto a bearing.
pub(crate) fn of_drop(case: &Case, drop: &DropResult) -> Vec<String> {
    // The verdict has the pressures.
    let truncated = |(ring, name): (usize, &str)| truncated(case, ring, drop.results.value(name));
    let mut warnings = of_case(case);
    warnings.extend(DROP_EDGES.into_iter().enumerate().filter_map(truncated));
    warnings
}

/// Warnings of the worst of scattered drops onto a bearing.
pub(crate) fn of_scattered<'d>(
    case: &Case,
    drops: impl Iterator<Item = (u64, &'d DropResult)> + Clone,
) -> Vec<String> {
    let worst = |name: &str| {
        let size = |drop: &DropResult| drop.results.value(name).unwrap_or(0.0).abs();
        let complete = drops.clone().filter(|(_, drop)| drop.stopped.is_none());
        let (number, drop) = complete.max_by(|a, b| size(a.1).total_cmp(&size(b.1)))?;
        Some((number, drop.results.value(name)?))
    };
    let mut found: Vec<(u64, Option<String>)> = vec![];
    for (name, place) in DROP_PRESSURES {
        let pressure = worst(name).map(|(number, mpa)| (number, over_pressure_mpa(place, mpa)));
        found.extend(pressure);
    }
    for (ring, name) in DROP_EDGES.into_iter().enumerate() {
        found.extend(worst(name).map(|(number, edge)| (number, truncated(case, ring, Some(edge)))));
    }
    let texts = found.into_iter().filter_map(|(number, text)| {
        text.map(|text| format!("in scattered drop {number}, the worst: {text}"))
    });
    texts.collect()
}

fn over_pressure_mpa(place: &str, mpa: f64) -> Option<String> {
    over_pressure(place, 1e6 * mpa)
}

/// Largest pressures among the results of a drop, and where they act.
const DROP_PRESSURES: [(&str, &str); 3] = [
    ("inner_pressure_max_mpa", "at the inner raceway"),
    ("outer_pressure_max_mpa", "at the outer raceway"),
    ("ball_pressure_max_mpa", "between balls"),
];

/// Results of a drop on how far contact ellipses reach: inner, outer groove.
const DROP_EDGES: [&str; 2] = ["inner_ellipse_edge_max_deg", "outer_ellipse_edge_max_deg"];

fn truncated(case: &Case, ring: usize, edge_deg: Option<f64>) -> Option<String> {
    case.bearing
        .truncation_warning(ring, edge_deg?.to_radians())
}

fn over_pressure(place: &str, pressure_pa: f64) -> Option<String> {
    let mpa = |pa: f64| 1e-6 * pa;
    (pressure_pa > STRESS_LIMIT_PA).then(|| {
        format!(
            "the contact pressure {place} reaches {:.0} MPa, above the {:.0} MPa that leave a \
             lasting indentation (ISO 76)",
            mpa(pressure_pa),
            mpa(STRESS_LIMIT_PA)
        )
    })
}

/// Warning about sliding under pressure that heats the surface of a contact.
fn flash_warning(place: &str, peak: &ContactPeak) -> Option<String> {
    if !(peak.flash_temperature_k > FLASH_TEMPERATURE_LIMIT_K) {
        return None;
    }
    let reached = 1e-6 * peak.pressure_velocity_pa_m_s;
    let limit = reached / peak.flash_temperature_k * FLASH_TEMPERATURE_LIMIT_K;
    Some(format!(
        "pressure × sliding speed {place} reaches {} MPa·m/s, above the {} that heat the \
         surface for a moment by {FLASH_TEMPERATURE_LIMIT_K} K (Blok's flash temperature, \
         here {:.0} K; tempered bearing steel softens above)",
        short(reached),
        short(limit),
        peak.flash_temperature_k
    ))
}

/// Loads that no bearing stands, from the peaks and means of the run.
fn beyond_bearings(run: &Finished<'_>) -> Vec<String> {
    let mut warnings = vec![];
    let bearing = &run.case.bearing;
    let diameter_mm = 2e3 * bearing.pitch_radius_m();
    let speed_rpm = run.case.largest_inner_speed_rad_s() * 60.0 / TAU;
    // Under a falling rotor a bearing does not run continuously.
    let continuous = run.case.rotor.is_none();
    if continuous {
        warnings.extend(speed_warning(speed_rpm.abs() * diameter_mm));
    }
    let Some(summary) = run.summary else {
        return warnings;
    };
    warnings.extend(over_pressures(&summary.peaks));
    let edges_rad = match &summary.space {
        Some(space) => Some(space.ellipse_edge_max_rad),
        None => equilibrium::ellipse_edge_max_rad(run.case),
    };
    warnings.extend(
        edges_rad
            .into_iter()
            .flat_map(|edges_rad| bearing.truncation_warnings(edges_rad)),
    );
    let hot = of_places(&summary.peaks).into_iter();
    warnings.extend(hot.filter_map(|(place, peak)| flash_warning(place, peak)));
    let means = summary.means.as_ref().filter(|_| continuous);
    warnings
        .extend(means.and_then(|means| overheating(bearing, means.heat_w.max(means.power_loss_w))));
    warnings
}

/// Kinds of contacts by their places, with their peaks.
fn of_places(peaks: &ContactPeaks) -> [(&'static str, &ContactPeak); 3] {
    [
        ("at the inner raceway", &peaks.inner),
        ("at the outer raceway", &peaks.outer),
        ("between balls", &peaks.balls),
    ]
}

/// Contact pressures that leave an indentation.
fn over_pressures(peaks: &ContactPeaks) -> impl Iterator<Item = String> {
    let places = of_places(peaks).into_iter();
    places.filter_map(|(place, peak)| over_pressure(place, peak.pressure_pa))
}

/// Largest regularisation speed of the friction over the speed by which a raceway slows a ball at
/// which the friction of balls on each other is that of the law; docs/greaseless.md shows what larger
/// ones do.
const REGULARISATION_FRACTION: f64 = 0.05;

/// The friction law is still a viscous one where a raceway slows the balls.
fn blunt_friction(case: &Case) -> Option<String> {
    if case.contact.regularisation == Regularisation::Kalker {
        return None;
    }
    let rw = case.bearing.ball_radius_m();
    let pitch_speed_m_s = case.rolling_orbit_speed_rad_s().abs() * case.bearing.pitch_radius_m();
    let slowed_m_s = |raceway: &Raceway| {
        let r = raceway.effective_radius_m(raceway.dimensions().centre_angle_rad);
        // Zhao 2022, Eq. (3).
        pitch_speed_m_s * (rw - r) / (rw + r)
    };
    let slowest = case.raceways.iter().map(slowed_m_s).fold(0.0, f64::max);
    let (knee, most) = (
        case.contact.friction.regularisation_speed_m_s,
        REGULARISATION_FRACTION * slowest,
    );
    (most > 0.0 && knee > most).then(|| {
        format!(
            "the raceway slows balls by {} m/s, and friction is that of its law only above {knee} m/s: \
             sliding, friction torque and the lag come out too small. Set \
             contact.regularisation_speed_m_s to {} or less",
            short(slowest),
            short_down(most)
        )
    })
}

/// One digit, down: what is said to be enough is enough.
fn short_down(value: f64) -> String {
    let power = value.log10().floor();
    let digit = (value / 10f64.powf(power)).floor();
    let exact: f64 = format!("{digit}e{power}").parse().unwrap_or(value);
    exact.to_string()
}

/// Warnings that the case alone gives, before a run.
pub fn of_case(case: &Case) -> Vec<String> {
    let mut warnings: Vec<String> = equilibrium::overload(case).into_iter().collect();
    let method = case.solver.method;
    let limits = StepLimits::new(case);
    let resolved = limits.friction_resolved_to_s(method);
    if case.solver.step_s > resolved {
        let speed = match case.contact.regularisation {
            Regularisation::Speed => "contact.regularisation_speed_m_s, ",
            Regularisation::Kalker => "",
        };
        warnings.push(format!(
            "the step is too long for this friction law: sliding speeds near zero are wrong for steps above {} µs \
             (solver.step_us, {speed}or solver.method = \"verlet\", which treats friction implicitly)",
            short(resolved * 1e6)
        ));
    }
    let resolved = limits.falling_resolved_to_s(method);
    if case.solver.step_s > resolved {
        warnings.push(format!(
            "friction falls so steeply with the sliding speed that a contact may jump between \
             rolling and sliding within a step: above {} µs (solver.step_us) such jumps are not \
             resolved",
            short(resolved * 1e6)
        ));
    }
    let (creep, knee) = (
        limits.creep_m_s2(method) * case.solver.step_s,
        case.contact.friction.regularisation_speed_m_s,
    );
    if creep > knee {
        let enough_us = short_down(1e6 * knee / limits.creep_m_s2(method));
        warnings.push(format!(
            "Coulomb friction is far from its limit at this step: contacts that should roll creep \
             by up to {creep:.2} m/s, in proportion to the step, where the smooth law would by \
             {knee} m/s; sliding speeds and friction losses are too large. Set solver.step_us to {enough_us} or less, \
             or contact.friction_law = \"smooth\""
        ));
    }
    warnings.extend(blunt_friction(case));
    let undamped = case.contact.damping_n_s_m1_5 == 0.0;
    if method == IntegrationMethod::Abm4 && undamped && case.solver.step_s > UNDAMPED_STEP_S {
        warnings.push(
            "without contact damping ABM4 gains energy at steps above 0.5 µs: statistics are \
             biased (solver.step_us, or solver.method = \"verlet\")"
                .to_owned(),
        );
    }
    warnings
}

#[cfg(test)]
mod tests;
