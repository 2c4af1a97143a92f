//! Criteria on the lag of an oil film.

use super::super::raceway_verdict::RacewayVerdict;
use super::requirement::{Bound, CauseKind, Requirement};
use cageless::film::QUEUE;

/// Speed that free balls lose to the film over the free share of the pitch circle: beyond it they queue.
pub(crate) static FILM_QUEUE: Requirement = Requirement {
    name: "film-queue",
    most: Some(Bound {
        limit: QUEUE,
        verdict: RacewayVerdict::FilmQueue,
        cause: CauseKind {
            name: "film-queue",
            meaning: "balls slowed by the oil film queue",
            remedy: "thinner oil or less of it ([film]), a higher speed, or balls with more room (bearing.balls)",
        },
    }),
    sentence: |_| "free balls lose a share of their speed to the film that is {} of the free share of the pitch circle",
    unknown: "the lag of the balls by the film",
    ..Requirement::PERCENT
};

/// Gap that the film opens over the critical gap: beyond it oil spaces the balls more than the raceway. Above 65 % the
/// gaps of structure (d) of Zhao 2022 scatter on the plain ring no more than with the raceway, at 3000 and 12 000 rpm.
pub(crate) static FILM_OUTWEIGHS: Requirement = Requirement {
    name: "film-outweighs",
    most: Some(Bound {
        limit: 0.65,
        verdict: RacewayVerdict::FilmOutweighs,
        cause: CauseKind {
            name: "film-outweighs",
            meaning: "the oil film spaces the balls more than the raceway",
            remedy: "thinner oil or less of it ([film]), or a deeper raceway",
        },
    }),
    sentence: |_| "the gap that the film opens is {} of the critical gap",
    unknown: "the critical gap or the lag of the balls by the film",
    ..Requirement::PERCENT
};
