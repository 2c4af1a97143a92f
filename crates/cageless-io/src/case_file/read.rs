//! Reader of the document: keys, their types and defaults.

use cageless::FrictionLaw;

use super::SCHEMA;
use super::defaults;
use super::document::{
    BearingDocument, CaseDocument, ContactDocument, GapsDocument, HousingDocument,
    MaterialDocument, ModelDocument, OperationDocument, OutputDocument, RacewayDocument,
    SearchDocument, SolverDocument, StartDocument, StartState, StepDocument,
};
use super::error::CaseError;
use super::keys;
use super::reader::Reader;
use super::spanned_toml::{Node, Places, Section, Value, join};

/// More discrete raceways than fit into any ring that balls roll in.
const RACEWAYS_MAX: usize = 64;

/// Reads the document and the dotted keys that took their default.
pub(super) fn document(
    root: &Section,
    places: &Places,
) -> Result<(CaseDocument, Vec<String>), CaseError> {
    let mut file = FileReader {
        root,
        places,
        defaults: Vec::new(),
    };
    // A later schema may have other keys: say so before complaining about them.
    let schema = file.schema()?;
    file.check_names()?;
    let title = file.section("")?.text_or("title", "")?;
    let document = CaseDocument {
        schema,
        title,
        bearing: file.bearing()?,
        material: file.material()?,
        raceway: file.raceways()?,
        operation: file.operation()?,
        contact: file.contact()?,
        model: ModelDocument {
            profile: file
                .section("model")?
                .choice_or("profile", defaults::PROFILE)?,
        },
        start: file.start()?,
        solver: file.solver()?,
        housing: file.housing()?,
        output: OutputDocument {
            interval_us: file
                .section("output")?
                .number_or("interval_us", defaults::INTERVAL_US)?,
        },
        search: file.search()?,
    };
    Ok((document, file.defaults))
}

struct FileReader<'a> {
    root: &'a Section,
    places: &'a Places,
    defaults: Vec<String>,
}

impl<'a> FileReader<'a> {
    fn section(&mut self, name: &'static str) -> Result<Reader<'_>, CaseError> {
        let entries = match self.root.get(name) {
            _ if name.is_empty() => Some(self.root),
            None => None,
            Some(Node {
                value: Value::Section(entries),
                ..
            }) => Some(entries),
            Some(node) => return Err(self.not_a_section(name, node)),
        };
        Ok(Reader::new(
            name,
            name.to_owned(),
            entries,
            self.places,
            &mut self.defaults,
        ))
    }

    fn not_a_section(&self, name: &str, node: &Node) -> CaseError {
        let message = match node.value {
            Value::List(_) => format!("{name} may be given once only: [{name}]"),
            _ => format!(
                "{name} = {} is not possible: it must be a section, [{name}]",
                node.place.written
            ),
        };
        self.places.error_at(&node.place, name, message)
    }

    fn schema(&mut self) -> Result<u64, CaseError> {
        let mut head = self.section("")?;
        let Some(node) = head.get("schema") else {
            head.note_default("schema");
            return Ok(SCHEMA);
        };
        match head.optional_count("schema")? {
            Some(SCHEMA) => Ok(SCHEMA),
            _ => Err(head.refuse(
                "schema",
                node,
                &format!("{SCHEMA}, the only schema that this version of Cageless reads"),
            )),
        }
    }

    /// Refuses names that the table of keys does not have; the first in the file
    /// if there are several.
    fn check_names(&self) -> Result<(), CaseError> {
        let mut wrong: Vec<CaseError> = Vec::new();
        for (name, node) in self.root {
            if keys::section_meaning(name).is_some() {
                match &node.value {
                    Value::Section(entries) => self.check_section(name, name, entries, &mut wrong),
                    Value::List(items) => {
                        for (k, item) in items.iter().enumerate() {
                            if let Value::Section(entries) = &item.value {
                                let path = nth(name, k, items.len());
                                self.check_section(name, &path, entries, &mut wrong);
                            }
                        }
                    }
                    _ => {}
                }
            } else if keys::find("", name).is_none() {
                wrong.push(self.unknown("", "", name, node));
            }
        }
        let first = wrong
            .into_iter()
            .min_by_key(|e| e.line().unwrap_or(usize::MAX));
        first.map_or(Ok(()), Err)
    }

    fn check_section(&self, name: &str, path: &str, entries: &Section, wrong: &mut Vec<CaseError>) {
        for (key, node) in entries {
            if keys::find(name, key).is_none() {
                wrong.push(self.unknown(name, path, key, node));
            }
        }
    }

    fn unknown(&self, section: &str, path: &str, name: &str, node: &Node) -> CaseError {
        let dotted = join(path, name);
        let hint = hint(section, name);
        let what = match node.value {
            Value::Section(_) if section.is_empty() => {
                format!("[{name}] is not a section of a case file")
            }
            _ if section.is_empty() => format!("{dotted} is not a key of a case file"),
            _ => format!("{dotted} is not a key of [{section}]"),
        };
        self.places
            .error_at(&node.place, &dotted, format!("{what}; {hint}"))
    }

    fn bearing(&mut self) -> Result<BearingDocument, CaseError> {
        let r = self.section("bearing")?;
        Ok(BearingDocument {
            // More balls than an address space has are refused by the geometry as well.
            balls: usize::try_from(r.count("balls")?).unwrap_or(usize::MAX),
            ball_radius_mm: r.number("ball_radius_mm")?,
            inner_groove_bottom_radius_mm: r.number("inner_groove_bottom_radius_mm")?,
            outer_groove_bottom_radius_mm: r.number("outer_groove_bottom_radius_mm")?,
            outer_shoulder_radius_mm: r.number("outer_shoulder_radius_mm")?,
            inner_groove_curvature_radius_mm: r.number("inner_groove_curvature_radius_mm")?,
            outer_groove_curvature_radius_mm: r.number("outer_groove_curvature_radius_mm")?,
            inner_ring_mass_kg: r.number("inner_ring_mass_kg")?,
            inner_ring_drag_n_s_m: r.number("inner_ring_drag_n_s_m")?,
            ball_radius_deviation_um: r.optional_list("ball_radius_deviation_um")?,
            outer_ring_outer_radius_mm: r.optional_number("outer_ring_outer_radius_mm")?,
            outer_ring_width_mm: r.optional_number("outer_ring_width_mm")?,
        })
    }

    fn material(&mut self) -> Result<MaterialDocument, CaseError> {
        let mut r = self.section("material")?;
        Ok(MaterialDocument {
            density_kg_m3: r.number_or("density_kg_m3", defaults::DENSITY_KG_M3)?,
            youngs_modulus_gpa: r.number_or("youngs_modulus_gpa", defaults::YOUNGS_MODULUS_GPA)?,
            poisson_ratio: r.number_or("poisson_ratio", defaults::POISSON_RATIO)?,
        })
    }

    fn raceways(&mut self) -> Result<Vec<RacewayDocument>, CaseError> {
        let name = "raceway";
        let Some(node) = self.root.get(name) else {
            return Ok(Vec::new());
        };
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ => std::slice::from_ref(node),
        };
        if items.len() > RACEWAYS_MAX {
            let message = format!(
                "{} sections [[{name}]] are not possible: there may be at most {RACEWAYS_MAX}",
                items.len()
            );
            return Err(self
                .places
                .error_at(&items[RACEWAYS_MAX].place, name, message));
        }
        let mut raceways = Vec::new();
        for (k, item) in items.iter().enumerate() {
            let Value::Section(entries) = &item.value else {
                return Err(self.not_a_section(name, item));
            };
            let path = nth(name, k, items.len());
            let mut r = Reader::new(name, path, Some(entries), self.places, &mut self.defaults);
            raceways.push(RacewayDocument {
                axial_span_mm: r.number("axial_span_mm")?,
                half_angle_deg: r.number("half_angle_deg")?,
                centre_angle_deg: r.number_or("centre_angle_deg", 0.0)?,
                depth_error_um: r.number_or("depth_error_um", 0.0)?,
            });
        }
        Ok(raceways)
    }

    fn operation(&mut self) -> Result<OperationDocument, CaseError> {
        let mut r = self.section("operation")?;
        Ok(OperationDocument {
            inner_speed_rpm: r.number("inner_speed_rpm")?,
            radial_load_n: r.number("radial_load_n")?,
            gravity_m_s2: r.number_or("gravity_m_s2", defaults::GRAVITY_M_S2)?,
        })
    }

    fn contact(&mut self) -> Result<ContactDocument, CaseError> {
        let mut r = self.section("contact")?;
        let friction_law = r.choice_or("friction_law", defaults::FRICTION_LAW)?;
        // Needed by this law; refused by the conversion with any other.
        let stribeck = |r: &Reader<'_>, name: &str| match friction_law {
            FrictionLaw::Stribeck => r.number(name).map(Some),
            _ => r.optional_number(name),
        };
        Ok(ContactDocument {
            friction_coefficient: r
                .number_or("friction_coefficient", defaults::FRICTION_COEFFICIENT)?,
            friction_law,
            static_friction_coefficient: stribeck(&r, "static_friction_coefficient")?,
            stribeck_speed_m_s: stribeck(&r, "stribeck_speed_m_s")?,
            slip_scale_m_s: r.number_or("slip_scale_m_s", defaults::SLIP_SCALE_M_S)?,
            damping: r.number_or("damping", defaults::DAMPING)?,
            ball_restitution: r.number_or("ball_restitution", defaults::BALL_RESTITUTION)?,
            inner_stiffness: r.derived_number("inner_stiffness")?,
            outer_stiffness: r.derived_number("outer_stiffness")?,
            ball_stiffness: r.derived_number("ball_stiffness")?,
        })
    }

    fn start(&mut self) -> Result<StartDocument, CaseError> {
        let mut r = self.section("start")?;
        let state = r.choice_or("state", defaults::START_STATE)?;
        let mut ring = |name: &str| match state {
            StartState::Rolling => r.number_or(name, 0.0).map(Some),
            // Refused by the conversion, once for all ways to a document.
            StartState::Settled => r.optional_number(name),
        };
        let (ring_x_um, ring_y_um) = (ring("ring_x_um")?, ring("ring_y_um")?);
        let gaps = match r.get("gaps").map(|node| (&node.value, node)) {
            None => {
                r.note_default("gaps");
                GapsDocument::Uniform
            }
            Some((Value::Text(text), _)) if text == "uniform" => GapsDocument::Uniform,
            Some((Value::List(_), _)) => {
                GapsDocument::ListDeg(r.optional_list("gaps")?.unwrap_or_default())
            }
            Some((_, node)) => {
                return Err(r.refuse("gaps", node, "\"uniform\" or a list of gaps in deg"));
            }
        };
        let lead_ball_angle_deg = r.number_or("lead_ball_angle_deg", 0.0)?;
        Ok(StartDocument {
            state,
            ring_x_um,
            ring_y_um,
            gaps,
            lead_ball_angle_deg,
        })
    }

    fn solver(&mut self) -> Result<SolverDocument, CaseError> {
        let at_head = self.section("")?.optional_count("seed")?;
        let mut r = self.section("solver")?;
        let method = r.choice_or("method", defaults::METHOD)?;
        let step_us = match r.get("step_us").map(|node| (&node.value, node)) {
            None => {
                r.note_default("step_us");
                StepDocument::Auto
            }
            Some((Value::Text(text), _)) if text == "auto" => StepDocument::Auto,
            Some((Value::Text(_), node)) => {
                return Err(r.refuse("step_us", node, "\"auto\" or a number of us"));
            }
            Some(_) => StepDocument::FixedUs(r.number("step_us")?),
        };
        let tolerance = r.number_or("tolerance", defaults::TOLERANCE)?;
        let duration_s = r.number_or("duration_s", defaults::DURATION_S)?;
        let seed = match (r.optional_count("seed")?, at_head) {
            (Some(_), Some(_)) => {
                return Err(r.misplaced("seed", "stands at the head of the file as well: drop one"));
            }
            (Some(seed), None) | (None, Some(seed)) => seed,
            (None, None) => {
                r.note_default("seed");
                0
            }
        };
        Ok(SolverDocument {
            method,
            step_us,
            tolerance,
            duration_s,
            seed,
        })
    }

    fn search(&mut self) -> Result<Option<SearchDocument>, CaseError> {
        if !self.root.contains_key("search") {
            return Ok(None);
        }
        let mut r = self.section("search")?;
        Ok(Some(SearchDocument {
            inner_speed_rpm: r.optional_range("inner_speed_rpm")?,
            radial_load_n: r.optional_range("radial_load_n")?,
            axial_span_mm: r.optional_range("axial_span_mm")?,
            half_angle_deg: r.optional_range("half_angle_deg")?,
            centre_angle_deg: r.optional_range("centre_angle_deg")?,
            raceways_max: r.count_or("raceways_max", 1)? as usize,
            spread_min: r.number_or("spread_min", cageless::design::search::SPREAD_MIN)?,
            starts: r.count_or("starts", 2)?,
            budget: r.count_or("budget", cageless::design::search::BUDGET as u64)? as usize,
            map_speed_rpm: r.optional_list("map_speed_rpm")?,
        }))
    }

    fn housing(&mut self) -> Result<Option<HousingDocument>, CaseError> {
        if !self.root.contains_key("housing") {
            return Ok(None);
        }
        let r = self.section("housing")?;
        Ok(Some(HousingDocument {
            mass_kg: r.number("mass_kg")?,
            stiffness_n_m: r.number("stiffness_n_m")?,
            damping_n_s_m: r.number("damping_n_s_m")?,
        }))
    }
}

/// Path of the k-th of several sections of one name.
pub(super) fn nth(name: &str, k: usize, count: usize) -> String {
    if count == 1 {
        name.to_owned()
    } else {
        format!("{name}.{}", k + 1)
    }
}

/// Suggestion for an unknown name.
pub(crate) fn hint(section: &str, name: &str) -> String {
    let known = || keys::of_section(section).map(|k| k.name);
    let sections = || keys::SECTIONS.iter().map(|&(name, _)| name);
    if section.is_empty() {
        if let Some(near) = keys::nearest(name, known().chain(sections())) {
            return match keys::section_meaning(near) {
                Some(_) => format!("did you mean [{near}]?"),
                None => format!("did you mean {near}?"),
            };
        }
    } else if let Some(near) = keys::nearest(name, known()) {
        return format!("did you mean {near}?");
    }
    if let Some(key) = keys::KEYS.iter().find(|k| k.name == name) {
        return format!("did you mean {}?", join(key.section, key.name));
    }
    if section.is_empty() {
        let near = keys::KEYS.iter().map(|k| k.name);
        if let Some(key) =
            keys::nearest(name, near).and_then(|n| keys::KEYS.iter().find(|k| k.name == n))
        {
            return format!("did you mean {}?", join(key.section, key.name));
        }
        return format!(
            "its sections are {}",
            sections().collect::<Vec<_>>().join(", ")
        );
    }
    format!("its keys are {}", known().collect::<Vec<_>>().join(", "))
}
