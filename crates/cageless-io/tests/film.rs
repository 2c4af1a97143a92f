//! `[film]`: the ways to give an oil, and what is refused.

use cageless::equilibrium::settle;
use cageless::film::{Film, FilmAtRest, OilGrade, TWO_DROPS, Traction};
use cageless_io::case_file::{CaseFile, template};

fn parse(film: &[&str], more: &[&str]) -> Result<CaseFile, String> {
    let film = film.iter().map(|set| format!("film.{set}"));
    let sets: Vec<String> = film.chain(more.iter().map(|s| (*s).to_owned())).collect();
    let text = template(false).replace("formulation = \"paper\"", "formulation = \"physical\"");
    CaseFile::parse(&text, "case.toml", &sets).map_err(|e| e.to_string())
}

fn film(sets: &[&str]) -> Film {
    parse(sets, &[]).unwrap().case().film.unwrap()
}

fn refused(film: &[&str], more: &[&str], fragments: &[&str]) {
    let error = parse(film, more).map(|_| ()).unwrap_err();
    for fragment in fragments {
        assert!(error.contains(fragment), "{error}: no {fragment}");
    }
}

const OIL: &str = "oil=\"iso-vg-32\"";
const WARM: &str = "temperature_c=70";
const FLOODED: &str = "supply=\"flooded\"";

#[test]
fn an_oil_is_given_in_three_ways() {
    assert_eq!(parse(&[], &[]).unwrap().case().film, None);
    let by_name = film(&[OIL, WARM, FLOODED]);
    assert_eq!(by_name.oil, OilGrade::IsoVg32.at(70.0));
    assert_eq!([by_name.supply, by_name.roughness_m], [1.0, 1e-7]);
    let between = film(&[
        "viscosity_40_mpa_s=27.33",
        "viscosity_100_mpa_s=4.314",
        WARM,
        "supply=\"two-drops\"",
    ]);
    assert!((between.oil.viscosity_pa_s / by_name.oil.viscosity_pa_s - 1.0).abs() < 1e-3);
    assert_eq!(between.supply, TWO_DROPS);
    let at_inlet = film(&[
        "viscosity_mpa_s=5",
        "viscosity_temperature_1_k=0.035",
        "supply=0.1",
    ]);
    assert_eq!([at_inlet.oil.viscosity_pa_s, at_inlet.supply], [5e-3, 0.1]);
    let own = film(&[
        OIL,
        WARM,
        FLOODED,
        "pressure_viscosity_1_pa=1.5e-8",
        "thermal_conductivity_w_m_k=0.13",
        "roughness_um=0.2",
    ]);
    assert_eq!(
        [
            own.oil.pressure_viscosity_1_pa,
            own.oil.thermal_conductivity_w_m_k
        ],
        [1.5e-8, 0.13]
    );
    assert_eq!(own.roughness_m, 2e-7);
    // Written with all defaults and read again.
    let file = parse(&[OIL, WARM, FLOODED], &[]).unwrap();
    let written = file.document().to_toml().unwrap();
    let again = CaseFile::parse(&written, "case.toml", &[]).unwrap();
    assert_eq!(again.case(), file.case(), "{written}");
}

#[test]
fn the_supply_has_to_be_given() {
    refused(
        &[OIL, WARM],
        &[],
        &[
            "film.supply (or inlet_film_um) is missing in [film]",
            "\"flooded\" is 1",
            "\"two-drops\" is 0.65",
            "0.1 is nearly dry",
        ],
    );
    for wrong in [
        "supply=\"dry\"",
        "supply=1.5",
        "supply=-0.1",
        "supply=1e-300",
        "supply=true",
        "supply=[1, 2]",
        "supply={a=1}",
    ] {
        refused(
            &[OIL, WARM, wrong],
            &[],
            &[
                "film.supply = ",
                "\"flooded\"",
                "0, or a number from 0.001 to 1",
            ],
        );
    }
    assert_eq!(film(&[OIL, WARM, "supply=0"]).supply, 0.0);
}

/// S over the least flooded film at rest gives the supply of a starved inlet, here that of S = 10.
#[test]
fn a_film_at_the_inlet_gives_the_supply() {
    let flooded = parse(&[OIL, WARM, FLOODED], &[]).unwrap();
    let at_rest = settle(flooded.case()).unwrap();
    let at_rest = FilmAtRest::new(flooded.case(), &at_rest).unwrap();
    let inlet = format!("inlet_film_um={}", 10.0 * 1e6 * at_rest.thickness_min_m);
    let file = parse(&[OIL, WARM, &inlet], &[]).unwrap();
    let starved = file.case().film.unwrap();
    assert!((starved.supply - 0.525547).abs() < 1e-6, "{starved:?}");
    assert!((starved.inlet_ratio.unwrap() - 10.0).abs() < 1e-9);
    assert_eq!(starved.oil, flooded.case().film.unwrap().oil);
    let slower = parse(&[OIL, WARM, &inlet], &["operation.inner_speed_rpm=3000"]).unwrap();
    assert!(slower.case().film.unwrap().supply > 0.7);
    let written = file.document().to_toml().unwrap();
    let again = CaseFile::parse(&written, "case.toml", &[]).unwrap();
    assert_eq!(again.case(), file.case(), "{written}");
}

/// Two supplies, no thickness, and a bearing in which no film forms are refused by name.
#[test]
fn a_film_at_the_inlet_that_gives_no_supply_is_refused() {
    let thin = "inlet_film_um=0.2";
    refused(
        &[OIL, WARM, FLOODED, thin],
        &[],
        &["film.inlet_film_um = 0.2", "left out with film.supply"],
    );
    for wrong in ["inlet_film_um=0", "inlet_film_um=-1", "inlet_film_um=1e9"] {
        refused(
            &[OIL, WARM, wrong],
            &[],
            &["film.inlet_film_um = ", "between 0.001 and 1000 µm"],
        );
    }
    refused(
        &[OIL, WARM, thin],
        &["operation.inner_speed_rpm=[[0, 0], [0.1, 3000]]"],
        &[
            "film.inlet_film_um = 0.2",
            "film.supply in its place",
            "over time",
        ],
    );
}

#[test]
fn one_way_excludes_the_others() {
    for (other, also) in [
        ("viscosity_mpa_s=5", OIL),
        ("viscosity_40_mpa_s=27", OIL),
        ("viscosity_100_mpa_s=4", OIL),
        ("viscosity_temperature_1_k=0.03", OIL),
        ("viscosity_mpa_s=5", "viscosity_40_mpa_s=27"),
        ("temperature_c=70", "viscosity_mpa_s=5"),
    ] {
        let key = other.split('=').next().unwrap();
        refused(&[also, other, FLOODED], &[], &[key, "left out with film."]);
    }
    refused(&[OIL, FLOODED], &[], &["film.temperature_c is missing"]);
    refused(
        &[FLOODED],
        &[],
        &[
            "film.oil is missing in [film]: give film.viscosity_mpa_s and film.viscosity_temperature_1_k; or film.oil \
             (\"iso-vg-10\"",
            "[set] as well",
        ],
    );
    refused(
        &["viscosity_temperature_1_k=0.035", FLOODED],
        &[],
        &["film.viscosity_mpa_s is missing in [film]"],
    );
    refused(
        &["viscosity_mpa_s=5", FLOODED],
        &[],
        &["film.viscosity_temperature_1_k is missing"],
    );
    refused(
        &["viscosity_40_mpa_s=27", WARM, FLOODED],
        &[],
        &["film.viscosity_100_mpa_s is missing"],
    );
    refused(
        &[
            "viscosity_40_mpa_s=4",
            "viscosity_100_mpa_s=27",
            WARM,
            FLOODED,
        ],
        &[],
        &["film.viscosity_100_mpa_s = 27", "oil thins"],
    );
}

#[test]
fn what_no_oil_has_is_refused() {
    refused(
        &["oil=\"olive\"", WARM, FLOODED],
        &[],
        &["film.oil = \"olive\"", "\"iso-vg-10\"", "\"fva-3\""],
    );
    refused(
        &[OIL, "temperature_c=300", FLOODED],
        &[],
        &["film.temperature_c = 300", "from -40 to 250"],
    );
    refused(
        &["oil=\"iso-vg-68\"", "temperature_c=-40", FLOODED],
        &[],
        &["film.temperature_c = -40", "Pa·s"],
    );
    for wrong in [
        "viscosity_mpa_s=0.01",
        "viscosity_40_mpa_s=20000",
        "viscosity_100_mpa_s=0.001",
    ] {
        let key = wrong.split('=').next().unwrap();
        refused(
            &[wrong, FLOODED],
            &[],
            &[key, "between 0.1 and 10000 mPa·s"],
        );
    }
    refused(
        &[OIL, WARM, FLOODED, "pressure_viscosity_1_pa=20"],
        &[],
        &["film.pressure_viscosity_1_pa = 20", "1e-9 to 1e-7"],
    );
    refused(
        &[OIL, WARM, FLOODED, "roughness_um=50"],
        &[],
        &["film.roughness_um = 50"],
    );
    refused(
        &[OIL, WARM, FLOODED, "density_kg_m3=0.9"],
        &[],
        &["film.density_kg_m3 = 0.9"],
    );
}

/// Derived values that no oil has are refused by the keys that were given.
#[test]
fn derived_values_name_the_keys_that_give_them() {
    refused(
        &["oil=\"iso-vg-10\"", "temperature_c=-40", FLOODED],
        &[],
        &[
            "film.temperature_c = -40",
            "warmer",
            "0.2002 of itself per K",
        ],
    );
    let between = |values: [&'static str; 3]| [values[0], values[1], values[2], FLOODED];
    refused(
        &between([
            "viscosity_40_mpa_s=20",
            "viscosity_100_mpa_s=0.1",
            "temperature_c=250",
        ]),
        &[],
        &["film.temperature_c = 250", "colder", "below 0.1 mPa·s"],
    );
    refused(
        &between([
            "viscosity_40_mpa_s=10000",
            "viscosity_100_mpa_s=0.1",
            "temperature_c=60",
        ]),
        &[],
        &[
            "film.viscosity_100_mpa_s = 0.1",
            "nearer to film.viscosity_40_mpa_s",
            "of itself per K",
        ],
    );
}

/// Oil is as warm as the rings: a contradiction to the fits is said.
#[test]
fn oil_beside_the_temperatures_of_the_rings() {
    let warning = |more: &[&str]| {
        parse(&[OIL, "temperature_c=40", FLOODED], more)
            .unwrap()
            .oil_temperature_warning()
    };
    let warmed = [
        "fit.inner_ring_temperature_c=120",
        "fit.outer_ring_temperature_c=115",
    ];
    let said = warning(&warmed).unwrap();
    for fragment in [
        "film.temperature_c = 40 is 75 K from",
        "fit.inner_ring_temperature_c = 120",
        "fit.outer_ring_temperature_c = 115",
    ] {
        assert!(said.contains(fragment), "{said}");
    }
    assert_eq!(warning(&[]), None);
    let beside = [
        "fit.inner_ring_temperature_c=60",
        "fit.outer_ring_temperature_c=50",
    ];
    assert_eq!(warning(&beside), None);
}

/// A search in oil has one operating point and a gap of its own; the key of `[search]` is at fault.
#[test]
fn a_search_in_oil_names_its_own_keys() {
    for (set, allowed) in [
        (
            "search.inner_speed_rpm=[3000, 12000]",
            "one number or left out",
        ),
        ("search.radial_load_n=[500, 1500]", "one number or left out"),
        ("search.map_speed_rpm=[6000]", "left out"),
        ("search.critical_gap_min_fraction=0.5", "left out, or 0.8"),
    ] {
        let dry = parse(&[], &[set]).unwrap();
        assert!(dry.request_to_run().is_ok(), "{set}");
        let file = parse(&[OIL, WARM, FLOODED], &[set]).unwrap();
        let error = file.request_to_run().unwrap_err().to_string();
        let key = set.split('=').next().unwrap();
        assert!(
            error.contains(&format!("{key} = ")) && error.contains(allowed),
            "{error}"
        );
    }
    let one = parse(&[OIL, WARM, FLOODED], &["search.inner_speed_rpm=9000"]).unwrap();
    assert!(one.request_to_run().is_ok());
}

/// Where no film is computed, one message says so; the name of each is in it.
#[test]
fn a_film_that_is_not_computed_is_refused() {
    let oil = [OIL, WARM, FLOODED];
    refused(
        &oil,
        &[
            "model.formulation=\"paper\"",
            "model.flanks=\"rigid\"",
            "raceway.blend_mm=0",
        ],
        &["film.supply", "published"],
    );
}

/// Hysteresis of the steel is off unless given, and refused by name where it is not computed.
#[test]
fn hysteresis_is_a_switch() {
    assert!(!film(&[OIL, WARM, FLOODED]).hysteresis);
    assert!(film(&[OIL, WARM, FLOODED, "hysteresis=\"yes\""]).hysteresis);
    let with = |value: &'static str| [OIL, WARM, FLOODED, value];
    refused(
        &with("hysteresis=\"maybe\""),
        &[],
        &["film.hysteresis = \"maybe\"", "\"no\" or \"yes\""],
    );
}

/// The traction of the film is off unless given; what has none is refused by name, and what it takes too.
#[test]
fn traction_is_a_choice() {
    let by_default = film(&[OIL, WARM, FLOODED]);
    assert_eq!(by_default.traction, Traction::Law);
    let with = |values: [&'static str; 2]| [OIL, WARM, FLOODED, values[0], values[1]];
    let sheared = film(&with(["traction=\"film\"", "traction_coefficient=0.03"]));
    assert_eq!(sheared.traction, Traction::Film);
    assert_eq!(sheared.traction_coefficient, 0.03);
    let sheared = with(["traction=\"film\"", "roughness_um=0.1"]);
    refused(
        &with(["traction=\"oil\"", "roughness_um=0.1"]),
        &[],
        &["film.traction = \"oil\"", "\"law\" or \"film\""],
    );
    refused(
        &with(["traction=\"law\"", "traction_coefficient=0.03"]),
        &[],
        &["film.traction_coefficient", "left out"],
    );
    refused(
        &with(["traction=\"film\"", "traction_coefficient=-1"]),
        &[],
        &["film.traction_coefficient = -1"],
    );
    for wrong in ["traction_coefficient=5", "traction_coefficient=1e300"] {
        refused(
            &with(["traction=\"film\"", wrong]),
            &[],
            &["film.traction_coefficient = ", "between 0 and 0.2"],
        );
    }
    refused(
        &sheared,
        &["contact.friction_law=\"coulomb\""],
        &["film.traction", "not coulomb"],
    );
    refused(
        &[OIL, WARM, "supply=0", "traction=\"film\""],
        &[],
        &["film.traction", "without supply"],
    );
}

/// The oil of the film gives the viscosity of the ratings; two are refused.
#[test]
fn ratings_take_the_oil_of_the_film() {
    let rated = ["lubrication.contamination_factor=0.5"];
    let file = parse(&[OIL, WARM, FLOODED], &rated).unwrap();
    let case = file.case();
    let viscosity = file
        .particulars()
        .lubrication
        .as_ref()
        .unwrap()
        .viscosity_m2_s;
    assert_eq!(viscosity, case.film.unwrap().oil.kinematic_viscosity_m2_s());
    assert!((5e-6..2e-5).contains(&viscosity), "{viscosity}");
    let both = [rated[0], "lubrication.viscosity_mm2_s=13"];
    refused(
        &[OIL, WARM, FLOODED],
        &both,
        &["lubrication.viscosity_mm2_s = 13", "left out with [film]"],
    );
    let without = parse(&[], &rated).map(|_| ()).unwrap_err();
    assert!(
        without.contains("lubrication.viscosity_mm2_s is missing"),
        "{without}"
    );
}
