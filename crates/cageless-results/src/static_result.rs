//! Results of a static equilibrium and the ratings of the bearing.

use cageless::SMOOTHING_M;
use cageless::equilibrium::space::SpatialEquilibrium;
use cageless::equilibrium::{EquilibriumError, settle};
use cageless::rating::{RatedMaterials, VISCOSITY_RATIO_MIN};
use cageless::{Assembly, Bearing, Case};

use crate::asperities::slippery_asperities;
use crate::film_notes::film_notes;
use crate::number_text::short;
use crate::overheating::overheating;
use crate::thin_inlet::thin_inlet;
use crate::{
    CLEARANCE_RANGE, DEFECTS, FILM, FIT, LUBRICATION, Particulars, Record, Results, SPACE, STATIC,
    Solved, Subject,
};

/// Results of the static equilibrium of a case: values, `warnings`, and `notes` on what they leave out.
pub fn static_record(
    case: &Case,
    particulars: &Particulars,
    settled: &SpatialEquilibrium,
) -> Record {
    let solved = Solved::new(case, particulars, settled);
    let warnings = settled.warnings(case).into_iter();
    let film = solved.film.iter().flat_map(|film| {
        let heat = overheating(&case.bearing, film.power_w);
        film.contact_warnings().into_iter().chain(heat)
    });
    let warnings = warnings.chain(solved.rating.warnings()).chain(film);
    let of_friction = slippery_asperities(case).into_iter();
    let warnings = warnings
        .chain(of_friction.chain(thin_inlet(case)))
        .collect();
    let mut groups = vec![STATIC, DEFECTS];
    groups.extend(particulars.fit.map(|_| FIT));
    let range = particulars.fit.and_then(|fit| fit.range);
    groups.extend(range.map(|_| CLEARANCE_RANGE));
    groups.extend(particulars.lubrication.as_ref().map(|_| LUBRICATION));
    groups.extend(solved.film.as_ref().map(|_| FILM));
    groups.extend(solved.space.map(|_| SPACE));
    let results = groups
        .into_iter()
        .map(|rows| Results::of(rows, Subject::Static(&solved)));
    Record::from(results.reduce(Results::and).unwrap_or_default())
        .with_sentences("warnings", warnings)
        .with_sentences("notes", notes(&solved))
        .with_limits(&particulars.limits)
}

/// Results of the static equilibrium of a case, in space where the case is not planar.
///
/// # Errors
/// The case has no equilibrium, or not one: its speed or load is a table over time.
pub fn equilibrium_record(
    case: &Case,
    particulars: &Particulars,
) -> Result<Record, EquilibriumError> {
    case.check_constant_operation("a static equilibrium")?;
    Ok(static_record(case, particulars, &settle(case)?))
}

/// [`equilibrium_record`] of a bearing with a further note.
///
/// # Errors
/// Those of [`equilibrium_record`].
pub fn equilibrium_record_noted(
    case: &Case,
    particulars: &Particulars,
    note: Option<String>,
) -> Result<Record, EquilibriumError> {
    let record = equilibrium_record(case, particulars)?;
    let notes = record.sentences("notes").iter().cloned();
    let notes = note.into_iter().chain(notes).collect();
    Ok(record.with_sentences("notes", notes))
}

fn notes(solved: &Solved<'_>) -> Vec<String> {
    let case = solved.case;
    let mut notes = vec![
        "ratings and lives are indicative: fatigue of a lubricated, clean bearing with plain \
         grooves"
            .to_owned(),
    ];
    notes.extend(assembly_note(&case.bearing).map(str::to_owned));
    if solved.rating.has_close_grooves {
        notes.push(
            "a groove is closer to the balls than 0.52 Dw: Cr and lives are those of 0.52, as a smaller groove radius \
             does not necessarily raise what a bearing carries (ISO 281, 5.1)"
                .to_owned(),
        );
    }
    if !case.raceways.is_empty() {
        notes.push(
            "lives and C0r take the outer raceway as a plain groove; in the discrete raceway two \
             points share the load of a ball, the ends of the raceway are not rated"
                .to_owned(),
        );
    }
    if case.operation.unbalance.amount_kg_m > 0.0 {
        let force_n = case.operation.unbalance_force_n();
        notes.push(format!(
            "operation.unbalance_g_mm turns a load of {} N with the inner ring, which equilibrium, ratings and \
             lives leave out",
            short(force_n)
        ));
    }
    notes.extend(materials_note(solved.rating.materials).map(str::to_owned));
    notes.extend(of_lubricant(solved));
    if let (Some(film), Some(at_rest)) = (&case.film, &solved.film) {
        notes.extend(film_notes(film, at_rest, case));
    }
    if solved.space.is_some() {
        notes.push(
            "in space: L10r takes the load of every ball under rigid rings that turn exactly, not by \
             small angles; Cr, C0r, P and frequencies take the free contact angle"
                .to_owned(),
        );
    }
    if solved.rating.equivalent.is_none() {
        notes.push(
            "without load, with moments, a tilt or a contact angle above 45° ISO 281 and ISO 76 have no equivalent \
             load: no L10 and no s0; L10r has all loads"
                .to_owned(),
        );
    }
    notes.extend(clearance_note(solved));
    notes.extend(stiffness_note(solved).map(str::to_owned));
    let view = case.operation.view();
    notes.extend((!view.is_empty()).then(|| view.to_owned()));
    notes
}

/// Tolerances behind the range of the clearance.
fn clearance_note(solved: &Solved<'_>) -> Option<String> {
    solved.particulars.fit?.range?;
    Some(format!(
        "the range of the clearance takes bearings of class Normal (ISO 492) unless fit.tolerance_class is given, \
         {} µm of smoothing unless fit.smoothing_um is, and fit.clearance_tolerance_um about the clearance of \
         the file",
        SMOOTHING_M * 1e6
    ))
}

/// Cause of a stiffness that is not defined.
fn stiffness_note(solved: &Solved<'_>) -> Option<&'static str> {
    let is_free = match solved.space {
        Some(space) => space.stiffness.is_none(),
        None => solved.equilibrium.stiffness_n_m.is_none(),
    };
    is_free.then_some(
        "the stiffness is not defined: without load, or within the clearance, nothing holds \
         the ring in some direction",
    )
}

/// Factor bm of the assembly, where it is not the usual one.
fn assembly_note(bearing: &Bearing) -> Option<&'static str> {
    match bearing.assembly() {
        Assembly::FillingSlot => Some(
            "bearing.assembly is \"filling-slot\": Cr has the factor bm = 1.1 of ISO 281 in place of \
             1.3, which a bearing without slot (fractured or split ring) keeps",
        ),
        Assembly::WithoutSlot if bearing.contact_angle_rad() > 0.0 => Some(
            "bearing.assembly is \"without-slot\": the rings of a bearing with a contact angle go together \
             over a counterbored shoulder, and Cr has the factor bm = 1.3 of ISO 281",
        ),
        Assembly::WithoutSlot => None,
    }
}

/// Ratings of balls of other materials than steel.
fn materials_note(materials: RatedMaterials) -> Option<&'static str> {
    match materials {
        RatedMaterials::Steel => None,
        RatedMaterials::Hybrid => Some(
            "hybrid bearing: Cr and lives are those of the bearing with steel balls, which \
             ISO 20056-1 keeps; C0r and s0 are those of ISO 76 for steel balls; the ratings of \
             ISO 20056-2, with another limit of the contact pressure, are not computed",
        ),
        RatedMaterials::Other => Some(
            "ISO 281, ISO 76 and ISO 20056 rate balls of bearing steel or silicon nitride in steel \
             rings; this case has other materials",
        ),
    }
}

/// Reservations on the ratings with a lubricant; empty without them.
fn of_lubricant(solved: &Solved<'_>) -> Vec<String> {
    let Some(rating) = &solved.lubricated else {
        return vec![];
    };
    let operation = &solved.case.operation;
    let load_n = operation.radial_load_n;
    let thin = (rating.viscosity_ratio < VISCOSITY_RATIO_MIN).then(|| {
        format!(
            "the viscosity ratio κ is {:.3}: ISO 281 rates no modified life below {VISCOSITY_RATIO_MIN}",
            rating.viscosity_ratio
        )
    });
    let light = rating
        .minimum_radial_load_n
        .filter(|least| operation.space.axial_load_n == 0.0 && load_n < *least);
    let light = light.map(|least| {
        format!(
            "the radial load is below the minimum load of SKF's rule, {least:.0} N: balls may slide"
        )
    });
    let own = match &solved.case.film {
        Some(_) => "sliding and the rolling resistance of the film",
        None => "dry sliding",
    };
    let skf = rating.skf_friction.map(|_| {
        format!(
            "SKF's friction model is for lubricated bearings with a cage of SKF's inner geometry; for a full \
             complement of balls SKF has no constants; the friction of the motion is another: {own}"
        )
    });
    let other = solved
        .particulars
        .lubrication
        .as_ref()
        .is_some_and(|l| l.skf_series.is_some());
    let other = (other && rating.skf_friction.is_none()).then(|| {
        "lubrication.skf_series: SKF's friction model is for a single-row deep groove ball bearing without moments \
         and tilt, and left out"
            .to_owned()
    });
    thin.into_iter()
        .chain(light)
        .chain(skf)
        .chain(other)
        .collect()
}
