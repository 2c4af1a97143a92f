//! Notes on the film of a bearing at rest.

use cageless::film::{Film, FilmAtRest, WEIGHT_MAX};
use cageless::{Case, Materials};

use crate::number_text::{short, significant};

/// Λ below which asperities carry three quarters of the load and more.
const NO_FILM: f64 = 0.1;
/// Speed deficit above which oil spaces balls more than a raceway for dry ones.
const OUTWEIGHS: f64 = 0.05;

/// Notes on the film: its effects on the balls, on a plain ring or one with raceways, and effects left out.
pub(crate) fn film_notes(film: &Film, at_rest: &FilmAtRest, case: &Case) -> Vec<String> {
    let starved = (film.supply < 1.0).then(|| {
        let supply = supply(film);
        format!("film thickness and Λ are those of flooded contacts: {supply} lowers the rolling force alone")
    });
    let notes = [
        effect(at_rest, !case.raceways.is_empty()),
        overcome(at_rest.overcome_balls),
        slid(at_rest),
        starved,
        hysteresis(film, case),
        Some(left_out(film)),
    ];
    notes.into_iter().flatten().collect()
}

/// Effect of the film on the spacing of the balls; `None` where it takes nothing from them.
fn effect(at_rest: &FilmAtRest, has_raceway: bool) -> Option<String> {
    let percent = |share: f64| format!("{} %", significant(100.0 * share, 2));
    let lost = at_rest.speed_deficit;
    let lambda = at_rest.film_parameter_mean;
    let taken = format!(
        "the oil takes {} of the speed of a free ball",
        percent(lost)
    );
    let [never, as_a_rule] = at_rest.queue_deficits;
    let limits = format!(
        "balls queue from some {} on, never below {}",
        percent(as_a_rule),
        percent(never)
    );
    let outweighs = match has_raceway && lost > OUTWEIGHS {
        true => format!(
            "; above some {} it spaces them more than a raceway for dry balls",
            percent(OUTWEIGHS)
        ),
        false => String::new(),
    };
    Some(match () {
        () if lost == 0.0 => return None,
        () if lambda < NO_FILM => format!(
            "there is hardly a film: Λ is {} in the mean, and asperities carry the load; lag, speed and gap here are \
             those of a film that does not form",
            short(lambda)
        ),
        () if at_rest.weight_share > WEIGHT_MAX => format!(
            "at this speed a ball weighs {} of its centrifugal force: lag, speed and gap here leave weight out, which \
             moves the balls as much; a run has it",
            short(at_rest.weight_share)
        ),
        () if !at_rest.has_load_zone => {
            "no ball touches the inner raceway: without a load zone lag and speed are those of a whole orbit on the \
             outer raceway alone, and no gap opens"
                .to_owned()
        }
        () if lost >= 1.0 => {
            "the film stops a free ball before it is back in the load zone: it has no lag, and balls will queue"
                .to_owned()
        }
        () if lost > as_a_rule => {
            format!("balls will queue: {taken}; {limits}; slowed balls hit each other all the time")
        }
        () if lost > never => format!("balls may queue: {taken}; {limits}{outweighs}"),
        () => format!(
            "oil spaces the balls: {taken}, and opens a gap behind one that enters the load zone; \
             {limits}{outweighs}"
        ),
    })
}

/// Balls that the film brakes more than the inner raceway drives them.
fn overcome(balls: usize) -> Option<String> {
    let (balls, they) = match balls {
        0 => return None,
        1 => ("1 ball".to_owned(), "it slides and falls"),
        _ => (format!("{balls} balls"), "they slide and fall"),
    };
    Some(format!(
        "under light load the film brakes {balls} more than the inner raceway drives: {they} behind, which lag and speed \
         here leave out; a run has it"
    ))
}

/// Hysteresis of contacts that are not of steel on steel.
fn hysteresis(film: &Film, case: &Case) -> Option<String> {
    let Materials { ball, ring } = *case.bearing.materials();
    let of_steel = ball.is_steel() && ring.is_steel();
    (film.hysteresis && !of_steel).then(|| {
        "film.hysteresis = \"yes\" has the coefficients of bearing steel, which balls and rings here are not both of"
            .to_owned()
    })
}

/// Balls that queue though none is carried by the outer raceway alone.
fn slid(at_rest: &FilmAtRest) -> Option<String> {
    let slides = at_rest.speed_deficit == 0.0 && at_rest.overcome_balls > 0;
    slides.then(|| {
        "balls may queue: they slide in the film though both raceways carry all of them".to_owned()
    })
}

/// Supply by the key that gives it.
fn supply(film: &Film) -> String {
    film.inlet_ratio.map_or("film.supply".to_owned(), |ratio| {
        format!(
            "film.inlet_film_um, {} times the least flooded film, gives a supply of {}, which",
            short(ratio),
            short(film.supply)
        )
    })
}

/// Effects that the film leaves out, and other supplies to try.
fn left_out(film: &Film) -> String {
    let others = match film.supply {
        0.1 => "\"flooded\"",
        1.0 => "0.1",
        _ => "0.1 and \"flooded\"",
    };
    let others = match film.inlet_ratio {
        Some(_) => format!("{others} in place of film.inlet_film_um"),
        None => others.to_owned(),
    };
    format!(
        "the film leaves out drag and churning of oil, and what the ball before leaves on the track; the supply of a \
         bearing is known to a factor of ten: try film.supply = {others}"
    )
}

#[cfg(test)]
mod tests {
    use cageless::film::Oil;

    use super::*;

    /// S and the supply that follows from it stand where the key of the supply does.
    #[test]
    fn a_film_at_the_inlet_is_named_as_the_supply() {
        let film = Film::flooded(Oil::mineral(5e-3, 0.035)).starved(10.0);
        let text = supply(&film);
        assert!(text.contains("film.inlet_film_um, 10 times"), "{text}");
        assert!(text.contains("a supply of 0.526"), "{text}");
        assert!(left_out(&film).ends_with("in place of film.inlet_film_um"));
    }

    #[test]
    fn one_ball_is_no_plural() {
        assert_eq!(overcome(0), None);
        let one = overcome(1).unwrap();
        assert!(one.contains("brakes 1 ball more") && one.contains("drives: it slides"));
        let two = overcome(2).unwrap();
        assert!(two.contains("brakes 2 balls more") && two.contains("drives: they slide"));
    }

    /// No supply is recommended that the case has.
    #[test]
    fn another_supply_is_to_be_tried() {
        for (supply, others) in [
            (0.1, "= \"flooded\""),
            (1.0, "= 0.1"),
            (0.65, "= 0.1 and \"flooded\""),
        ] {
            let film = Film {
                supply,
                ..Film::flooded(Oil::mineral(5e-3, 0.035))
            };
            assert!(left_out(&film).ends_with(others), "{supply}");
        }
    }
}
