//! The film of a case.

use cageless::Case;
use cageless::equilibrium::settle;
use cageless::film::{
    Film, FilmAtRest, Oil, OilGrade, TEMPERATURES_C, Traction, VISCOSITIES_PA_S,
    VISCOSITY_TEMPERATURE_MAX_1_K,
};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;
use crate::case_file::named::Named;
use crate::case_file::sections::film::{FilmSection, Supply};
use crate::case_file::unit::Unit;

/// Keys of supply and oil, by the ways to give them.
const SUPPLY: &str = "film.supply";
const INLET_FILM: &str = "film.inlet_film_um";
const OIL: &str = "film.oil";
const COLD: &str = "film.viscosity_40_mpa_s";
const HOT: &str = "film.viscosity_100_mpa_s";
const VISCOSITY: &str = "film.viscosity_mpa_s";
const SLOPE: &str = "film.viscosity_temperature_1_k";
const TEMPERATURE: &str = "film.temperature_c";
const COEFFICIENT: &str = "film.traction_coefficient";

impl Converter<'_> {
    /// The film of `[film]`.
    pub(in crate::case_file) fn film(&self) -> Result<Option<Film>, CaseError> {
        let Some(section) = &self.sections.film else {
            return Ok(None);
        };
        let supply = self.supply(section)?;
        let oil = self.oil(section)?;
        let film = Film {
            oil: Oil {
                pressure_viscosity_1_pa: section
                    .pressure_viscosity_1_pa
                    .unwrap_or(oil.pressure_viscosity_1_pa),
                thermal_conductivity_w_m_k: section
                    .thermal_conductivity_w_m_k
                    .unwrap_or(oil.thermal_conductivity_w_m_k),
                density_kg_m3: section.oil_density_kg_m3.unwrap_or(oil.density_kg_m3),
                ..oil
            },
            supply,
            inlet_ratio: None,
            roughness_m: section.roughness_m,
            inlet_heat: true,
            hysteresis: section.hysteresis,
            traction: section.traction,
            traction_coefficient: (section.traction_coefficient)
                .unwrap_or(Film::TRACTION_COEFFICIENT),
        };
        if film.traction == Traction::Law && section.traction_coefficient.is_some() {
            let allowed = "left out, or film.traction = \"film\": the law has its own coefficient";
            return Err(self.refuse(COEFFICIENT, allowed));
        }
        film.check().map_err(|error| self.refused(&error, None))?;
        Ok(Some(film))
    }

    /// The supply as it is given; of contacts that flood where a film at the inlet gives it.
    fn supply(&self, section: &FilmSection) -> Result<f64, CaseError> {
        match (section.supply, section.inlet_film_m) {
            (Some(_), Some(_)) => {
                let allowed = format!("left out with {SUPPLY}, which gives the supply already");
                Err(self.refuse(INLET_FILM, &allowed))
            }
            (Some(Supply(supply)), None) => Ok(supply),
            (None, Some(_)) => Ok(1.0),
            (None, None) => Err(self.missing("film", "supply")),
        }
    }

    /// The film of a case that a film at the inlet starves; `None` where the supply is given.
    pub(in crate::case_file) fn starved(&self, case: &Case) -> Result<Option<Film>, CaseError> {
        let section = self.sections.film.as_ref();
        let inlet_film_m = section.and_then(|section| section.inlet_film_m);
        let (Some(inlet_film_m), Some(film)) = (inlet_film_m, case.film) else {
            return Ok(None);
        };
        let in_place =
            |why: &str| self.refuse(INLET_FILM, &format!("{SUPPLY} in its place: {why}"));
        if case.check_constant_operation("S").is_err() {
            return Err(in_place(
                "S is that of one speed and load, and here they vary over time",
            ));
        }
        let at_rest = settle(case).ok();
        let at_rest = at_rest.and_then(|settled| FilmAtRest::new(case, &settled));
        let at_rest =
            at_rest.ok_or_else(|| in_place("this case has no film at rest in its load"))?;
        Ok(Some(film.starved(inlet_film_m / at_rest.thickness_min_m)))
    }

    /// The oil by its name, by two viscosities, or by one at the inlet.
    fn oil(&self, section: &FilmSection) -> Result<Oil, CaseError> {
        let given = |path: &str| self.document.has(path);
        // The first way that is given excludes the others.
        let ways: [(&str, &[&str]); 3] = [
            (OIL, &[COLD, HOT, VISCOSITY, SLOPE]),
            (COLD, &[VISCOSITY, SLOPE]),
            (VISCOSITY, &[HOT, TEMPERATURE]),
        ];
        for (way, others) in ways {
            let Some(other) = others.iter().find(|other| given(way) && given(other)) else {
                continue;
            };
            let allowed = format!("left out with {way}, which gives the oil already");
            return Err(self.refuse(other, &allowed));
        }
        if let Some(grade) = section.oil {
            let temperature_c = self.temperature_c(section)?;
            return self.flowing(grade.at(temperature_c), temperature_c, TEMPERATURE);
        }
        if let Some(viscosity_pa_s) = section.viscosity_pa_s {
            let slope = section.viscosity_temperature_1_k;
            let slope = slope.ok_or_else(|| self.missing("film", "viscosity_temperature_1_k"))?;
            return Ok(Oil::mineral(viscosity_pa_s, slope));
        }
        match (section.viscosity_40_pa_s, section.viscosity_100_pa_s) {
            (Some(cold), Some(hot)) => {
                if hot >= cold {
                    let allowed = format!("less than {COLD}: oil thins as it warms");
                    return Err(self.refuse(HOT, &allowed));
                }
                let temperature_c = self.temperature_c(section)?;
                self.flowing(Oil::between([cold, hot], temperature_c), temperature_c, HOT)
            }
            (Some(_), None) => Err(self.missing("film", "viscosity_100_mpa_s")),
            (None, Some(_)) => Err(self.missing("film", "viscosity_40_mpa_s")),
            (None, None) => Err(self.oil_missing()),
        }
    }

    fn temperature_c(&self, section: &FilmSection) -> Result<f64, CaseError> {
        let temperature_c = section.temperature_c;
        let temperature_c = temperature_c.ok_or_else(|| self.missing("film", "temperature_c"))?;
        let [least, most] = TEMPERATURES_C;
        match (least..=most).contains(&temperature_c) {
            true => Ok(temperature_c),
            false => Err(self.refuse(TEMPERATURE, &format!("from {least} to {most} °C"))),
        }
    }

    /// The error of a film without oil.
    fn oil_missing(&self) -> CaseError {
        let key = match self.document.has(SLOPE) {
            true => VISCOSITY,
            false => OIL,
        };
        let grades = OilGrade::choices();
        let message = format!(
            "{key} is missing in [film]: give {VISCOSITY} and {SLOPE}; or {OIL} ({grades}) and {TEMPERATURE}; or \
             {COLD}, {HOT} and {TEMPERATURE}. What a plan varies stands in the case or in [set] as well"
        );
        self.document.tree.error(key, message)
    }

    /// Passes an oil that flows at its temperature; `falling` is the key at fault where it thins too fast there.
    fn flowing(&self, oil: Oil, temperature_c: f64, falling: &str) -> Result<Oil, CaseError> {
        let [least, most] = VISCOSITIES_PA_S;
        let viscosity_pa_s = oil.viscosity_pa_s;
        if !(least..=most).contains(&viscosity_pa_s) {
            let (way, has, end) = match viscosity_pa_s < least {
                true => (
                    "colder",
                    format!(
                        "{:.2e} mPa·s",
                        Unit::MillipascalSecond.of_si(viscosity_pa_s)
                    ),
                    format!(
                        "no oil is below {} mPa·s",
                        Unit::MillipascalSecond.of_si(least)
                    ),
                ),
                false => (
                    "warmer",
                    format!("{viscosity_pa_s:.0} Pa·s"),
                    format!("no bearing starts above {most}"),
                ),
            };
            let allowed = format!("{way}: at {temperature_c} °C this oil has {has}, and {end}");
            return Err(self.refuse(TEMPERATURE, &allowed));
        }
        let slope = oil.viscosity_temperature_1_k;
        if slope <= VISCOSITY_TEMPERATURE_MAX_1_K {
            return Ok(oil);
        }
        let way = match falling {
            HOT => format!("nearer to {COLD}"),
            _ => "warmer".to_owned(),
        };
        let allowed = format!(
            "{way}: at {temperature_c} °C the viscosity would fall by {slope:.4} of itself per K, and that of no oil by \
             more than {VISCOSITY_TEMPERATURE_MAX_1_K}"
        );
        Err(self.refuse(falling, &allowed))
    }
}
