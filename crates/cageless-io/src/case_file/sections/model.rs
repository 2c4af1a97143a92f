//! `[model]`.

use cageless::{FlankModel, Formulation, Motion};

use crate::case_file::declaration::prelude::*;

section! {
    /// `[model]`: the set of equations.
    struct ModelSection {
        formulation formerly profile => formulation: Formulation = default(Formulation::Physical.name()), Plain,
            "formulation of the equations of motion",
            Shown("\"physical\"", "\"physical\": consistent mechanics;\n\
                \"paper\": the equations as published");
        motion => motion: Motion = default(Motion::BySymmetry.name()), Plain,
            "\"auto\": in the plane, or in space where axial load, tilt, moments or contact angles need it; \"space\": in space in any case",
            Commented("\"auto\"", "\"space\": also without axial load");
        flanks => flanks: FlankModel = default(FlankModel::Elastic.name()), Plain,
            "flanks of the discrete raceways in the plane; \"elastic\": contact angle under load, sliding \
             along the flanks and spin on them; \"rigid\": as published, also unless given in \"paper\" and with \
             friction_law = \"coulomb\", which have no others",
            Shown("\"rigid\"", "(paper); \"elastic\", as in a real bearing, unless given");
    }
}
