//! Numbers at the head of the page of a drop.

use cageless::simulation::PlaneDisplacement;
use cageless_study::{Parameter, parameter};

use super::bearing::Bearing;
use super::report::{PRESSURES, pressure_limit_mpa};
use crate::length::um;
use crate::text::short;

/// Parts of a bearing with the names of their temperatures at the end of a drop and at standstill.
const TEMPERATURES: [(&str, [&str; 2]); 3] = [
    (
        "inner ring",
        ["inner_ring_temperature_c", "inner_ring_standstill_c"],
    ),
    ("balls", ["ball_temperature_c", "ball_standstill_c"]),
    (
        "outer ring",
        ["outer_ring_temperature_c", "outer_ring_standstill_c"],
    ),
];

/// Decisive results of a drop, of the worst bearing or plane: force, displacement, spin-up, temperature, pressure.
pub(super) fn facts(bearings: &[Bearing<'_>], planes: &[PlaneDisplacement]) -> Vec<Parameter> {
    [
        force(bearings),
        displacement(bearings, planes),
        spin_up(bearings),
        temperature(bearings),
        pressure(bearings),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The bearing with the largest value of a result, and the value.
fn worst<'b, 's>(bearings: &'b [Bearing<'s>], name: &str) -> Option<(&'b Bearing<'s>, f64)> {
    let values = bearings.iter();
    let values = values.filter_map(|b| Some((b, b.record.result.results.value(name)?)));
    values.max_by(|a, b| a.1.total_cmp(&b.1))
}

fn force(bearings: &[Bearing<'_>]) -> Option<Parameter> {
    let (bearing, force_n) = worst(bearings, "rotor_force_max_n")?;
    let weights = bearing
        .record
        .result
        .results
        .value("rotor_force_max_over_weight");
    let unit = weights.map_or("N".to_owned(), |weights| {
        format!("N, {} × weight", short(weights))
    });
    Some(parameter(
        &bearing.label("largest force on the rotor"),
        short(force_n),
        &unit,
    ))
}

/// The displacement that comes closest to its clearance, or without one the largest.
fn displacement(bearings: &[Bearing<'_>], planes: &[PlaneDisplacement]) -> Option<Parameter> {
    const NAME: &str = "rotor_displacement_max_um";
    let of_planes = planes.iter().map(|plane| {
        let [most, limit] = [plane.displacement_max_m, plane.clearance.radial_m].map(um);
        (
            format!("largest displacement at {}", plane.clearance.name),
            most,
            limit,
        )
    });
    let journals = bearings.iter().filter_map(|bearing| {
        let limit_m = bearing.case.rotor.as_ref()?.clearance_limit_m?;
        let most = bearing.record.result.results.value(NAME)?;
        Some((
            bearing.label("largest displacement of the journal"),
            most,
            um(limit_m),
        ))
    });
    let closest = of_planes
        .chain(journals)
        .min_by(|a, b| (a.2 - a.1).total_cmp(&(b.2 - b.1)));
    if let Some((name, most, limit)) = closest {
        let name = format!("{name}, of its clearance");
        return Some(parameter(
            &name,
            format!("{} of {}", short(most), short(limit)),
            "µm",
        ));
    }
    let (bearing, most) = worst(bearings, NAME)?;
    Some(parameter(
        &bearing.label("largest displacement of the journal"),
        short(most),
        "µm",
    ))
}

/// The last spin-up, or one that was not reached.
fn spin_up(bearings: &[Bearing<'_>]) -> Option<Parameter> {
    const NAME: &str = "spin_up_ms";
    let mut without = bearings.iter().filter_map(|bearing| {
        let results = &bearing.record.result;
        let text = results
            .instead(NAME)
            .filter(|_| results.results.value(NAME).is_none())?;
        Some(parameter(
            &bearing.label("spin-up of the inner ring"),
            text,
            "",
        ))
    });
    without.next().or_else(|| {
        let (bearing, ms) = worst(bearings, NAME)?;
        Some(parameter(
            &bearing.label("spin-up of the inner ring"),
            short(ms),
            "ms",
        ))
    })
}

/// The highest temperature at standstill, or at the end of the drop without one.
fn temperature(bearings: &[Bearing<'_>]) -> Option<Parameter> {
    let found = bearings.iter().flat_map(|bearing| {
        TEMPERATURES
            .into_iter()
            .filter_map(move |(part, [end, standstill])| {
                let warm = bearing
                    .succession
                    .and_then(|record| record.value(standstill));
                let (when, value_c) = match warm {
                    Some(value_c) => ("at standstill", value_c),
                    None => ("at the end", bearing.record.result.results.value(end)?),
                };
                Some((bearing, part, when, value_c))
            })
    });
    let (bearing, part, when, value_c) = found.max_by(|a, b| a.3.total_cmp(&b.3))?;
    let name = bearing.label(&format!("highest temperature, {part}, {when}"));
    Some(parameter(&name, short(value_c), "°C"))
}

fn pressure(bearings: &[Bearing<'_>]) -> Option<Parameter> {
    let all = PRESSURES.iter().filter_map(|name| worst(bearings, name));
    let (bearing, mpa) = all.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let name = bearing.label("largest contact pressure, of the limit of ISO 76");
    Some(parameter(
        &name,
        format!("{mpa:.0} of {:.0}", pressure_limit_mpa()),
        "MPa",
    ))
}
