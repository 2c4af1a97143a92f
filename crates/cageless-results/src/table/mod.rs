//! Tables of the scalar results: every key, column and line of a table, once.

mod design;
mod drop;
mod measured;
mod run;
mod search;
mod statics;
mod steady;
mod tolerance;
pub(crate) mod unit;
mod verification;

use crate::computation::Computation;
use crate::quantity::{Quantity, bearing_in_column};

pub use design::{
    AXIAL, CONTACT_ANGLE, DESIGN, FILM_VERDICT, GROOVE, PASSAGES, PROFILE, RACEWAY, SLOT, VERDICT,
};
pub(crate) use design::{CURVE, RECOMMENDATION};
pub(crate) use drop::milliseconds;
pub use drop::{DROP, PLANE, ROTOR_DROP, SUCCESSION};
pub use measured::{DIMENSION, FRAME, MEASURED};
pub use run::{COMPARED, RUN};
pub use search::{
    MAP, MOTION, PAPER, PLACEMENT, POINT, REJECTION, SEARCH, STRUCTURE, STRUCTURE_AT,
};
pub use statics::{CLEARANCE_RANGE, DEFECTS, FILM, FIT, LUBRICATION, SPACE, STATIC};
pub use steady::STEADY;
pub use tolerance::{INFLUENCE, SAMPLES, TOLERANCE, VERDICT_COUNT};
pub use verification::{
    DISTANCE, DROP_VERIFICATION, JUDGEMENT, ROTOR_VERIFICATION, VERIFICATION, VERIFIED,
};

/// Tables whose names mean the same wherever they stand in results of static equilibrium, design, run and drop.
pub(crate) const ANYWHERE: [&[Quantity]; 22] = [
    STATIC,
    DEFECTS,
    FIT,
    CLEARANCE_RANGE,
    LUBRICATION,
    FILM,
    SPACE,
    DESIGN,
    CONTACT_ANGLE,
    PROFILE,
    GROOVE,
    SLOT,
    AXIAL,
    VERDICT,
    FILM_VERDICT,
    PASSAGES,
    RACEWAY,
    RECOMMENDATION,
    CURVE,
    RUN,
    DROP,
    ROTOR_DROP,
];

/// All scalar results, in the order of keys, columns and tables.
pub fn quantities() -> impl Iterator<Item = &'static Quantity> {
    let more = [
        MEASURED,
        FRAME,
        DIMENSION,
        PLANE,
        SUCCESSION,
        SEARCH,
        POINT,
        STRUCTURE,
        STRUCTURE_AT,
        MOTION,
        REJECTION,
        PLACEMENT,
        MAP,
        PAPER,
        TOLERANCE,
        INFLUENCE,
        SAMPLES,
        VERDICT_COUNT,
        STEADY,
        COMPARED,
        VERIFICATION,
        VERIFIED,
        DROP_VERIFICATION,
        ROTOR_VERIFICATION,
        JUDGEMENT,
        DISTANCE,
    ];
    ANYWHERE.into_iter().chain(more).flatten()
}

/// Scalar results of a kind of result: `static`, `design` with its verdict, `run` or `drop`.
pub fn of_kind(kind: &str) -> impl Iterator<Item = &'static Quantity> + use<> {
    let tables: &'static [&'static [Quantity]] = match kind {
        "static" => &[
            STATIC,
            DEFECTS,
            FIT,
            CLEARANCE_RANGE,
            LUBRICATION,
            FILM,
            SPACE,
        ],
        "design" => &[DESIGN, CONTACT_ANGLE, PROFILE, VERDICT],
        "run" => &[RUN],
        "drop" => &[DROP],
        "search" => &[SEARCH],
        "tolerance" => &[TOLERANCE],
        _ => &[],
    };
    tables.iter().copied().flatten()
}

/// The result of a column of sweeps, and the bearing from 0 if it is that of one of several.
pub fn of_column(name: &str) -> Option<(&'static Quantity, Option<usize>)> {
    let drop = Computation::Drop.name();
    let in_bearing = || {
        let rest = name.strip_prefix(drop)?.strip_prefix('_')?;
        let (k, rest) = bearing_in_column(rest)?;
        Some((format!("{drop}_{rest}"), Some(k)))
    };
    let (name, bearing) = in_bearing().unwrap_or_else(|| (name.to_owned(), None));
    let quantity = quantities().find(|q| q.in_sweeps && q.column_name() == name)?;
    Some((quantity, bearing))
}
