//! Cases as they are when a found raceway is entered in their file.

use cageless::raceway::RacewayDimensions;
use cageless::{Case, RacewayForm, RacewayShape};
use cageless_design::search::OperatingPoint;
use cageless_io::case_file::{CaseDocument, CaseFile, CaseValue, SectionValues};

const SHAPE: &str = "shape";
const BLEND: &str = "blend_mm";
const DEPTH: &str = "depth_um";
const TURNED: &str = "contact_angle_deg";
const EDGE: &str = "edge_radius_mm";

/// The section `[raceway]` of these lengths in mm, angles in degrees and depth error in µm.
pub fn raceway_section(
    axial_span_mm: f64,
    half_angle_deg: f64,
    centre_angle_deg: f64,
    depth_error_um: f64,
) -> SectionValues {
    vec![
        ("axial_span_mm", axial_span_mm.into()),
        ("half_angle_deg", half_angle_deg.into()),
        ("centre_angle_deg", centre_angle_deg.into()),
        ("depth_error_um", depth_error_um.into()),
    ]
}

/// A raceway as it is printed and entered: whole micrometres and thousandths of a degree.
pub fn entered_raceway(dimensions: &RacewayDimensions, depth_error_um: f64) -> SectionValues {
    let degrees = |angle: f64| (angle.to_degrees() * 1e3).round() / 1e3;
    raceway_section(
        (dimensions.axial_span_m * 1e6).round() / 1e3,
        degrees(dimensions.half_angle_rad),
        degrees(dimensions.centre_angle_rad),
        depth_error_um,
    )
}

/// The keys of a shape for a raceway of a case, unless it is that of its first; a slot has the edges that its search
/// asks for.
pub fn reshaped(file: &CaseFile, shape: &str) -> SectionValues {
    if file.case().raceway_form().shape.name() == shape {
        return vec![];
    }
    let slot = shape == RacewayShape::Slot.name();
    let edge = file.document().value(&format!("search.{EDGE}"));
    let edge = edge.filter(|_| slot).map(|radius| (EDGE, radius));
    [(SHAPE, shape.into())].into_iter().chain(edge).collect()
}

/// The key of the angle by which a section is turned, unless it is that of the first raceway of a case.
pub fn turned(file: &CaseFile, section_angle_deg: f64) -> Option<(&'static str, CaseValue)> {
    let own = file.document().number(&format!("raceway.1.{TURNED}"));
    (own.unwrap_or(0.0) != section_angle_deg).then(|| (TURNED, section_angle_deg.into()))
}

/// The document of a case with these raceways, of the form of its first or of their own shape with
/// its blend, in the place of its own.
pub fn with_raceways(file: &CaseFile, raceways: &[SectionValues]) -> CaseDocument {
    let (form, paper) = (file.case().raceway_form(), RacewayForm::default());
    let keys = [
        (SHAPE, form.shape != paper.shape),
        ("profile", form.profile_rad().is_some()),
        (BLEND, true),
        (DEPTH, form.depth_m != paper.depth_m),
        (EDGE, form.edge_radius_m != paper.edge_radius_m),
        ("slot_depth_mm", form.slot_depth_m.is_some()),
        (TURNED, true),
    ];
    let own = |(key, given): (&'static str, bool)| {
        let value = file.document().value(&format!("raceway.1.{key}"));
        value.filter(|_| given).map(|value| (key, value))
    };
    let form: Vec<_> = keys.into_iter().filter_map(own).collect();
    let formed = |values: &SectionValues| {
        let mut values = values.clone();
        let given: Vec<&str> = values.iter().map(|(key, _)| *key).collect();
        let keeps: &[&str] = match (given.contains(&SHAPE), given.contains(&EDGE)) {
            (false, _) => &keys.map(|(key, _)| key),
            (true, false) => &[BLEND, DEPTH, TURNED],
            (true, true) => &[TURNED],
        };
        let kept = form
            .iter()
            .filter(|(key, _)| !given.contains(key) && keeps.contains(key));
        let kept: Vec<_> = kept.cloned().collect();
        values.extend(kept);
        values
    };
    let raceways: Vec<_> = raceways.iter().map(formed).collect();
    let mut document = file.document().clone();
    document.set_sections("raceway", &raceways);
    document
}

/// The case with these raceways in the place of its own, at this speed and load or its own;
/// `None` if that is impossible. An automatic step follows the raceways.
pub fn entered(
    file: &CaseFile,
    raceways: &[SectionValues],
    point: Option<&OperatingPoint>,
) -> Option<Case> {
    let mut document = with_raceways(file, raceways);
    if let Some(point) = point {
        let rpm = point.inner_speed_rad_s * 60.0 / std::f64::consts::TAU;
        // Rounding away what the conversion to SI leaves.
        document.set("operation.inner_speed_rpm", (rpm * 1e6).round() / 1e6);
        document.set("operation.radial_load_n", point.radial_load_n);
        if file.case().moves_in_space() {
            document.set("operation.axial_load_n", point.axial_load_n);
        }
    }
    let entered = CaseFile::from_document(document, "case").ok()?;
    Some(entered.case().clone())
}

#[cfg(test)]
mod tests {
    use cageless::Ends;
    use cageless_io::case_file::template;

    use super::*;

    /// Form of the raceway that is entered in the template with these changes, of its own shape or of another.
    fn form(sets: &[&str], shape: Option<&str>) -> RacewayForm {
        let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
        let file = CaseFile::parse(&template(false), "case", &sets).unwrap();
        let dimensions = RacewayDimensions {
            axial_span_m: 4.5e-3,
            half_angle_rad: 0.4,
            centre_angle_rad: 0.0,
        };
        let mut values = entered_raceway(&dimensions, 0.0);
        values.extend(shape.into_iter().flat_map(|shape| reshaped(&file, shape)));
        let case = entered(&file, &[values], None).unwrap();
        assert_eq!(case.raceways[0].dimensions().axial_span_m, 4.5e-3);
        case.raceway_form()
    }

    #[test]
    fn slots_keep_their_edges_and_others_have_none() {
        let slot = [
            "raceway.shape=slot",
            "raceway.edge_radius_mm=0.3",
            "raceway.slot_depth_mm=0.9",
        ];
        let kept = form(&slot, None);
        assert_eq!(kept.shape, RacewayShape::Slot);
        assert_eq!(
            (kept.edge_radius_m, kept.slot_depth_m),
            (0.3e-3, Some(0.9e-3))
        );
        assert_eq!(form(&slot, Some("slot")), kept);
        let steady = RacewayForm::default().reshaped(RacewayShape::Steady, 0.0);
        assert_eq!(form(&slot, Some("steady")), steady);
        let searched = [
            "model.motion=space",
            "search.shapes=all",
            "search.edge_radius_mm=0.4",
            "raceway.blend_mm=0.5",
            "raceway.depth_um=3",
        ];
        let slot = RacewayForm::default().reshaped(RacewayShape::Slot, 0.4e-3);
        assert_eq!(form(&searched, Some("slot")), slot);
        let steady = form(&searched, Some("steady"));
        assert_eq!((steady.ends, steady.depth_m), (Ends::Blended(0.5e-3), 3e-6));
    }
}
