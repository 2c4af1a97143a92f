//! `[film]`.

use cageless::film::{OilGrade, TWO_DROPS, Traction};

use crate::case_file::declaration::prelude::*;

section! {
    /// `[film]`: oil film of the contacts of balls with raceways, which resists rolling.
    struct FilmSection {
        supply => supply: Option<Supply> = Optional, Plain,
            "share of the rolling force of a flooded contact, for which there is no safe assumption: \"flooded\" is 1, an oil bath or jet at low speed; \"two-drops\" is 0.65, balls measured with two drops of oil; 0.1 is nearly dry or greased, of which no measurement is known; give 0 or a number from 0.001 to 1, and try the others; needed unless inlet_film_um is given",
            Commented("\"flooded\"", "a bath or jet; or \"two-drops\", or 0.1: nearly dry, greased");
        inlet_film_um => inlet_film_m: Option<f64> = Optional, Micrometre; Within(0.001, 1000.0),
            "thickness of the oil on the track before a contact, in place of supply, which follows from S, that thickness over the least flooded film of all contacts at the speed and load of the case; S from 2 on is computed, below is said", Absent;
        oil => oil: Option<OilGrade> = Optional, Plain,
            "oil by name, with temperature_c; or the viscosities",
            Commented("\"iso-vg-32\"", "or its viscosities");
        viscosity_40_mpa_s => viscosity_40_pa_s: Option<f64> = Optional, MillipascalSecond; Within(0.1, 10_000.0),
            "dynamic viscosity at 40 °C, with viscosity_100_mpa_s and temperature_c", Absent;
        viscosity_100_mpa_s => viscosity_100_pa_s: Option<f64> = Optional, MillipascalSecond; Within(0.1, 10_000.0),
            "dynamic viscosity at 100 °C", Absent;
        viscosity_mpa_s => viscosity_pa_s: Option<f64> = Optional, MillipascalSecond; Within(0.1, 10_000.0),
            "dynamic viscosity at the temperature of the inlet, with viscosity_temperature_1_k", Absent;
        viscosity_temperature_1_k => viscosity_temperature_1_k: Option<f64> = Optional, Si("1/K"); AtLeast(0.0),
            "fall of the logarithm of the viscosity with the temperature, 0.02 to 0.06 of mineral oils, for the heat of the inlet; 0: none", Absent;
        temperature_c => temperature_c: Option<f64> = Optional, Si("C"),
            "temperature of the oil at the inlet of the contacts, that of the rings; needed unless viscosity_mpa_s is given",
            Commented("70.0", "of the inlet: that of the rings");
        pressure_viscosity_1_pa => pressure_viscosity_1_pa: Option<f64> = Optional, Si("1/Pa"); Above(0.0),
            "pressure-viscosity coefficient α, for the thickness of the film alone; that of the oil unless given, of mineral oil with viscosities", Absent;
        thermal_conductivity_w_m_k => thermal_conductivity_w_m_k: Option<f64> = Optional, Si("W/(m K)"); Above(0.0),
            "thermal conductivity of the oil; that of the oil unless given, 0.14 with viscosities", Absent;
        density_kg_m3 => oil_density_kg_m3: Option<f64> = Optional, Si("kg/m^3"); Within(500.0, 2000.0),
            "density of the oil, for the kinematic viscosity of [lubrication]; that of the oil unless given, 860 with viscosities", Absent;
        roughness_um => roughness_m: f64 = default(0.1), Micrometre; Within(0.001, 10.0),
            "Rq, composite roughness of ball and raceway, for Λ", Absent;
        hysteresis => hysteresis: bool = default("no"), Plain,
            "whether the hysteresis of the steel resists rolling as well; its heat is part of rolling_resistance", Absent;
        traction => traction: Traction = default(Traction::Law.name()), Plain,
            "friction at the raceways; \"law\": that of [contact]; \"film\": the film is sheared, and asperities have the smooth law of [contact] for the share of the load that they carry, for which contact.friction_coefficient = 0.11 is measured", Absent;
        traction_coefficient => traction_coefficient: Option<f64> = Optional, Plain; Within(0.0, 0.2),
            "limit of the friction of a sheared film over its load, with traction = \"film\"; 0.03 to 0.05 of mineral oils, 0.05 unless given", Absent;
    }
}

/// `film.supply`: share of the rolling force of a flooded contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Supply(pub f64);

/// Least supply but for none at all; less is none.
const SUPPLY_LEAST: f64 = 1e-3;

/// Supplies by name.
const SUPPLIES: [(&str, f64); 2] = [("flooded", 1.0), ("two-drops", TWO_DROPS)];

field!(
    Supply,
    Kind::NumberOr(&["flooded", "two-drops"]),
    |reader, name, node| {
        let allowed = "\"flooded\" (1: bath or jet), \"two-drops\" (0.65: two drops of oil), 0, or a number from 0.001 to 1 \
                       (0.1: nearly dry or greased)";
        let value = match &node.value {
            Value::Text(text) => {
                let found = SUPPLIES.iter().find(|(name, _)| name == text);
                found.map(|(_, share)| *share)
            }
            Value::Integer(_) | Value::Number(_) => {
                let share = reader.number(name, node)?;
                let is_supply = share == 0.0 || (SUPPLY_LEAST..=1.0).contains(&share);
                is_supply.then_some(share)
            }
            _ => None,
        };
        value
            .map(Self)
            .ok_or_else(|| reader.refuse(name, node, allowed))
    }
);
