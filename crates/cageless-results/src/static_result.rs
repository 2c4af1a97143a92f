//! Results of a static equilibrium and the ratings of the bearing.

use cageless::equilibrium::Equilibrium;
use cageless::rating::RatedMaterials;
use cageless::{Assembly, Case};

use crate::{Record, Results, STATIC, Solved, Subject};

/// Results of the static equilibrium of a case: values, `warnings`, and `notes` on what they leave out.
pub fn static_record(case: &Case, equilibrium: &Equilibrium) -> Record {
    let solved = Solved::new(case, equilibrium);
    let overload = equilibrium.overload().into_iter();
    let warnings = overload.chain(solved.rating.warnings()).collect();
    Record::from(Results::of(STATIC, Subject::Static(&solved)))
        .with_sentences("warnings", warnings)
        .with_sentences("notes", notes(&solved))
}

fn notes(solved: &Solved<'_>) -> Vec<String> {
    let case = solved.case;
    let mut notes = vec![
        "ratings and lives are indicative: fatigue of a lubricated, clean bearing with plain \
         grooves"
            .to_owned(),
    ];
    if case.bearing.assembly() == Assembly::FillingSlot {
        notes.push(
            "bearing.assembly is \"filling-slot\": Cr has the factor bm = 1.1 of ISO 281 in place of \
             1.3, which a bearing without slot (fractured or split ring) keeps"
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
    match solved.rating.materials {
        RatedMaterials::Steel => {}
        RatedMaterials::Hybrid => notes.push(
            "hybrid bearing: Cr and lives are those of the bearing with steel balls, which \
             ISO 20056-1 keeps; C0r and s0 are those of ISO 76 for steel balls; the ratings of \
             ISO 20056-2, with another limit of the contact pressure, are not computed"
                .to_owned(),
        ),
        RatedMaterials::Other => notes.push(
            "ISO 281, ISO 76 and ISO 20056 rate balls of bearing steel or silicon nitride in steel \
             rings; this case has other materials"
                .to_owned(),
        ),
    }
    if solved.rating.l10_mrev.is_none() {
        notes.push(
            "without radial load there is no basic rating life and no static safety factor"
                .to_owned(),
        );
    }
    if solved.equilibrium.stiffness_n_m.is_none() {
        notes.push(
            "the stiffness is not defined: without load, or within the clearance, nothing holds \
             the ring in some direction"
                .to_owned(),
        );
    }
    let view = case.operation.view();
    notes.extend((!view.is_empty()).then(|| view.to_owned()));
    notes
}
