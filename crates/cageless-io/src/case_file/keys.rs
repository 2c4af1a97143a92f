//! Every key of a case file: its unit, what it means and the field of
//! [`cageless`] that it sets.

use cageless::bearing::BALLS_MIN;

use super::unit::Unit;

/// One key.
#[derive(Debug)]
pub(crate) struct Key {
    /// Section; empty for the head of the file.
    pub section: &'static str,
    pub name: &'static str,
    pub unit: Unit,
    /// Field of [`cageless::InputError`]; empty if none.
    pub field: &'static str,
    pub meaning: &'static str,
}

/// Sections and what each holds, in the order of the template.
pub(crate) const SECTIONS: &[(&str, &str)] = &[
    ("bearing", "dimensions and masses of rings and balls"),
    ("material", "elastic material of rings and balls"),
    ("raceway", "the discrete raceway"),
    ("operation", "speed and load"),
    ("contact", "friction, damping and stiffness"),
    ("model", "the set of equations"),
    ("start", "the initial state"),
    ("solver", "integration"),
    ("housing", "the support of the outer ring"),
    ("output", "what a run writes"),
    ("search", "what a search for the raceway looks at"),
];

const fn key(
    section: &'static str,
    name: &'static str,
    unit: Unit,
    field: &'static str,
    meaning: &'static str,
) -> Key {
    Key {
        section,
        name,
        unit,
        field,
        meaning,
    }
}

use Unit::{
    Degree, Gigapascal, Micrometre, Microsecond, Millimetre, None as Plain, RevolutionPerMinute, Si,
};

/// Unit of K in F = K·δ^1.5.
const HERTZ: Unit = Si("N/m^1.5");

/// Meaning of the seed, which has two places.
const SEED: &str = "seed of random starts (run --verify, design --search) and samples (tolerance)";

/// The table.
#[rustfmt::skip]
pub(crate) const KEYS: &[Key] = &[
    key("", "schema", Plain, "", "version of the file format"),
    key("", "title", Plain, "", "free text"),
    // The file format shows the seed below [solver]; at the head it means the same.
    key("", "seed", Plain, "", SEED),

    key("bearing", "balls", Plain, "balls", "N, number of balls"),
    key("bearing", "ball_radius_mm", Millimetre, "ball_radius_m", "Rw, radius of a ball"),
    key("bearing", "inner_groove_bottom_radius_mm", Millimetre, "inner_groove_bottom_radius_m", "Ri, radius of the inner ring at the bottom of its groove"),
    key("bearing", "outer_groove_bottom_radius_mm", Millimetre, "outer_groove_bottom_radius_m", "Ro, radius of the outer ring at the bottom of its groove"),
    key("bearing", "outer_shoulder_radius_mm", Millimetre, "outer_shoulder_radius_m", "Ros, shoulder bore radius of the outer ring"),
    key("bearing", "inner_groove_curvature_radius_mm", Millimetre, "inner_groove_curvature_radius_m", "radius of the inner groove in the meridian plane"),
    key("bearing", "outer_groove_curvature_radius_mm", Millimetre, "outer_groove_curvature_radius_m", "Re, radius of the outer groove in the meridian plane"),
    key("bearing", "inner_ring_mass_kg", Si("kg"), "inner_ring_mass_kg", "mass of the inner ring and attached rotating parts"),
    key("bearing", "inner_ring_drag_n_s_m", Si("N s/m"), "inner_ring_drag_n_s_m", "C of Zhao 2022, Eq. (14), viscous damping of inner-ring translation"),
    key("bearing", "ball_radius_deviation_um", Micrometre, "ball_radius_deviation_m", "deviation of each ball's radius"),
    key("bearing", "outer_ring_outer_radius_mm", Millimetre, "outer_ring_outer_radius_m", "outer radius of the outer ring"),
    key("bearing", "outer_ring_width_mm", Millimetre, "outer_ring_width_m", "width of the outer ring"),

    key("material", "density_kg_m3", Si("kg/m^3"), "density_kg_m3", "density of the balls"),
    key("material", "youngs_modulus_gpa", Gigapascal, "youngs_modulus_pa", "E of balls and rings"),
    key("material", "poisson_ratio", Plain, "poisson_ratio", "Poisson's ratio of balls and rings"),

    key("raceway", "axial_span_mm", Millimetre, "axial_span_m", "lC, largest axial distance between the two contact points"),
    key("raceway", "half_angle_deg", Degree, "half_angle_rad", "θ, half the angle that the raceway takes up"),
    key("raceway", "centre_angle_deg", Degree, "centre_angle_rad", "angular position of raceway centre"),
    key("raceway", "depth_error_um", Micrometre, "depth_error_m", "machining error of the depth at the centre, along the normal"),

    key("operation", "inner_speed_rpm", RevolutionPerMinute, "inner_speed_rad_s", "speed of the inner ring"),
    key("operation", "radial_load_n", Si("N"), "radial_load_n", "Fr, load on the inner ring, downwards"),
    key("operation", "gravity_m_s2", Si("m/s^2"), "gravity_m_s2", "g, downwards"),

    key("contact", "friction_coefficient", Plain, "friction_coefficient", "μ"),
    key("contact", "friction_law", Plain, "", "friction against sliding speed"),
    key("contact", "static_friction_coefficient", Plain, "static_friction_coefficient", "μs of the Stribeck law"),
    key("contact", "stribeck_speed_m_s", Si("m/s"), "stribeck_speed_m_s", "sliding speed over which the Stribeck law falls from μs to μ"),
    key("contact", "slip_scale_m_s", Si("m/s"), "slip_scale_m_s", "sliding speed at the knee of the smooth and Stribeck laws"),
    key("contact", "damping", Si("N s/m^1.5"), "damping_n_s_m1_5", "contact damping c of ball-raceway contacts, F = K δ^1.5 + c √δ dδ/dt"),
    key("contact", "ball_restitution", Plain, "ball_restitution", "coefficient of restitution between balls"),
    key("contact", "inner_stiffness", HERTZ, "inner_stiffness_n_m1_5", "K at the inner raceway, in place of Hertz"),
    key("contact", "outer_stiffness", HERTZ, "outer_stiffness_n_m1_5", "K at the outer raceway, in place of Hertz"),
    key("contact", "ball_stiffness", HERTZ, "ball_stiffness_n_m1_5", "K between balls, in place of Hertz"),

    key("model", "profile", Plain, "", "the set of equations"),

    key("start", "state", Plain, "", "kind of initial state"),
    key("start", "ring_x_um", Micrometre, "ring_x_m", "centre of the inner ring"),
    key("start", "ring_y_um", Micrometre, "ring_y_m", "centre of the inner ring"),
    key("start", "gaps", Degree, "gaps", "gaps between neighbouring balls"),
    key("start", "lead_ball_angle_deg", Degree, "lead_ball_angle_rad", "initial position of ball 1"),

    key("solver", "method", Plain, "", "integration method"),
    key("solver", "step_us", Microsecond, "step_s", "step of the integration"),
    key("solver", "tolerance", Plain, "tolerance", "error per step of the adaptive method"),
    key("solver", "duration_s", Si("s"), "duration_s", "simulated time"),
    key("solver", "seed", Plain, "", SEED),

    key("housing", "mass_kg", Si("kg"), "mass_kg", "mass of housing and outer ring"),
    key("housing", "stiffness_n_m", Si("N/m"), "stiffness_n_m", "stiffness of the support"),
    key("housing", "damping_n_s_m", Si("N s/m"), "damping_n_s_m", "damping of the support"),

    key("output", "interval_us", Microsecond, "interval_s", "time between rows of the result"),

    key("search", "inner_speed_rpm", RevolutionPerMinute, "", "speed, or lowest and highest"),
    key("search", "radial_load_n", Si("N"), "", "load, or lowest and highest"),
    key("search", "axial_span_mm", Millimetre, "", "lC, or narrowest and widest"),
    key("search", "half_angle_deg", Degree, "", "θ, or smallest and largest"),
    key("search", "centre_angle_deg", Degree, "", "ψ of the middle of one raceway, or first and last"),
    key("search", "raceways_max", Plain, "", "number of raceways at most"),
    key("search", "spread_min", Plain, "", "least separation, fraction of the mean ball spacing"),
    key("search", "starts", Plain, "", "unevenly spaced starts per design"),
    key("search", "budget", Plain, "", "largest number of simulations"),
    key("search", "map_speed_rpm", RevolutionPerMinute, "", "further speeds to draw maps at"),
];

/// A key whose value is a whole number, with the least and the greatest value; none where
/// something else limits it.
pub(crate) struct Whole {
    section: &'static str,
    name: &'static str,
    pub least: u64,
    pub most: Option<u64>,
}

const fn whole(section: &'static str, name: &'static str, least: u64, most: Option<u64>) -> Whole {
    Whole {
        section,
        name,
        least,
        most,
    }
}

/// Every key of this kind. Of raceways, more than four leave hardly any plain raceway between
/// them.
const WHOLE: &[Whole] = &[
    whole("bearing", "balls", BALLS_MIN as u64, None),
    whole("search", "raceways_max", 1, Some(4)),
    whole("search", "starts", 1, Some(64)),
    whole("search", "budget", 1, None),
];

/// Allowed range of a whole number; 0 or more and below 2^63, the range of TOML, unless the key
/// has limits.
pub(crate) fn whole_number(section: &str, name: &str) -> &'static Whole {
    const ANY: &Whole = &whole("", "", 0, Some(i64::MAX as u64));
    let of_key = |w: &&Whole| (w.section, w.name) == (section, name);
    WHOLE.iter().find(of_key).unwrap_or(ANY)
}

impl Whole {
    /// Allowed values as a phrase.
    pub(crate) fn allowed(&self) -> String {
        let least = self.least;
        match self.most {
            None => format!("a whole number, {least} or more"),
            Some(most) if most == i64::MAX as u64 => {
                format!("a whole number, {least} or more and below 2^63")
            }
            Some(most) => format!("a whole number from {least} to {most}"),
        }
    }
}

/// The keys of a section.
pub(crate) fn of_section(section: &str) -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(move |k| k.section == section)
}

/// Looks up a key.
pub(crate) fn find(section: &str, name: &str) -> Option<&'static Key> {
    of_section(section).find(|k| k.name == name)
}

/// The key that sets a field of [`cageless`].
pub(crate) fn of_field(field: &str) -> Option<&'static Key> {
    KEYS.iter()
        .find(|k| !k.field.is_empty() && k.field == field)
}

/// Meaning of a section, if there is one of that name.
pub(crate) fn section_meaning(section: &str) -> Option<&'static str> {
    SECTIONS
        .iter()
        .find(|(name, _)| *name == section)
        .map(|&(_, meaning)| meaning)
}

/// The candidate that `given` was most likely meant to be.
pub fn nearest<'a>(given: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    // A third of the letters wrong is no longer a slip of the pen.
    let most = (given.chars().count() / 3).max(2);
    candidates
        .map(|c| (strsim::damerau_levenshtein(&given.to_lowercase(), c), c))
        .filter(|&(distance, _)| distance <= most)
        .min()
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_stands_in_a_known_section_and_sets_a_field_of_its_own() {
        for (k, one) in KEYS.iter().enumerate() {
            assert!(
                one.section.is_empty() || section_meaning(one.section).is_some(),
                "{one:?}"
            );
            for other in &KEYS[k + 1..] {
                assert!(
                    (one.section, one.name) != (other.section, other.name),
                    "{one:?}"
                );
                assert!(one.field.is_empty() || one.field != other.field, "{one:?}");
            }
        }
    }

    #[test]
    fn a_slip_of_the_pen_finds_its_key() {
        let names = || of_section("raceway").map(|k| k.name);
        assert_eq!(nearest("axial_spam_mm", names()), Some("axial_span_mm"));
        assert_eq!(nearest("axial_span_m", names()), Some("axial_span_mm"));
        assert_eq!(nearest("Half_Angle_Deg", names()), Some("half_angle_deg"));
        assert_eq!(nearest("colour", names()), None);
    }
}
