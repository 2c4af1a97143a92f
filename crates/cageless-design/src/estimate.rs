//! An estimate of the verdict on a raceway from closed forms, without simulating.

use super::criterion::{FILM_OUTWEIGHS, FILM_QUEUE, IN_OIL};
use super::{LAG, SEPARATION, STEADY_GAP};
use cageless::Case;
use cageless::closed_forms::{
    Eq11, friction_demand, rolling_lag_fraction, steady_gap_rad, theoretical_gap_rad,
};
use cageless::contact::STRESS_LIMIT_PA;
use cageless::equilibrium::Equilibrium;
use cageless::film::FilmAtRest;
use cageless::raceway::Raceway;

/// One term of an estimate, a dimensionless value against its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimateTerm {
    /// Name in files.
    pub name: &'static str,
    /// Meaning of the value.
    pub meaning: &'static str,
    /// The value.
    pub value: f64,
    /// Limit of the value.
    pub limit: f64,
    /// Whether the limit is the least value, else it is the largest.
    pub at_least: bool,
}

impl EstimateTerm {
    /// Distance from the limit as a fraction of it, negative beyond it.
    pub fn margin(&self) -> f64 {
        let excess = (self.value - self.limit) / self.limit;
        if self.at_least { excess } else { -excess }
    }
}

/// Estimate for the raceways of a case, by rolling balls in static equilibrium. The motion of all
/// balls, which decides, is not looked at: see [`super::judge`].
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Terms of the estimate, each against its limit.
    pub terms: Vec<EstimateTerm>,
}

/// Largest friction demand of an estimate. Balls may slide for a moment: of the ten structures of
/// Zhao 2022, in the `physical` formulation, those that pass stay below 1.40 and those that slip
/// begin at 1.51.
const FRICTION_DEMAND_MAX: f64 = 1.45;
/// Largest 2θ of an estimate over the angle of three evenly spaced balls. Of the same structures
/// those that pass stay below 1.07, those hit from both sides begin at 1.18.
const LENGTH_MAX: f64 = 1.12;

impl Estimate {
    /// Estimate for a case and its static equilibrium; of several raceways, the worst of each
    /// term. Without a discrete raceway only the contact stress remains.
    pub fn new(case: &Case, equilibrium: &Equilibrium) -> Self {
        let demand = |r: &Raceway| friction_demand(case, equilibrium, r);
        let sliding = case.raceways.iter().map(demand).fold(0.0, f64::max);
        Self::of(
            case,
            EstimateTerm {
                name: "sliding",
                meaning: "friction that rolling through the raceway demands over that available",
                value: sliding,
                limit: FRICTION_DEMAND_MAX,
                at_least: false,
            },
            Some(equilibrium),
        )
    }

    /// Estimate for a case on elastic flanks or in space: in place of the friction that rolling demands, what contact
    /// angle and deflection of its [`seats`](cageless::closed_forms::seats) leave of the lag; the contact stress only with an
    /// equilibrium.
    pub fn elastic(case: &Case, seats: &[[f64; 2]], equilibrium: Option<&Equilibrium>) -> Self {
        Self::of(
            case,
            EstimateTerm {
                name: "lag",
                meaning: "lag of rolling under load and contact angle over that of rigid parts without one",
                value: rolling_lag_fraction(case, seats),
                limit: LAG.limit(),
                at_least: true,
            },
            equilibrium,
        )
    }

    fn of(case: &Case, of_friction: EstimateTerm, equilibrium: Option<&Equilibrium>) -> Self {
        let bearing = &case.bearing;
        // What a raceway must keep of β0, or of the lag, is what it may be too deep by.
        let kept_fraction = match case.has_elastic_flanks() {
            true => LAG.limit(),
            false => 1.0 - SEPARATION.limit(),
        };
        let mut terms = vec![];
        if !case.raceways.is_empty() {
            let largest = |value: &dyn Fn(&Raceway) -> f64| {
                case.raceways.iter().map(value).fold(0.0, f64::max)
            };
            let steady = steady_gap_rad(bearing, &case.raceways);
            let three = 2.0 * (bearing.ball_angle_rad() + bearing.nominal_gap_rad());
            terms.push(EstimateTerm {
                name: "separation",
                meaning: "β0 of Eq. (11) over the gap outside the raceways",
                value: largest(&|r| theoretical_gap_rad(bearing, r, Eq11::Published) / steady),
                limit: STEADY_GAP.limit(),
                at_least: true,
            });
            terms.push(EstimateTerm {
                name: "depth",
                meaning: "the same: beyond its limit evenly spaced balls collide",
                value: largest(&|r| theoretical_gap_rad(bearing, r, Eq11::Published) / steady),
                limit: 1.0 / kept_fraction,
                at_least: false,
            });
            terms.push(of_friction);
            terms.push(EstimateTerm {
                name: "both-neighbours",
                meaning: "2θ over the angle of three evenly spaced balls",
                value: largest(&|r| 2.0 * r.half_angle_rad() / three),
                limit: LENGTH_MAX,
                at_least: false,
            });
        }
        terms.extend(equilibrium.map(|rest| EstimateTerm {
            name: "stress",
            meaning: "contact pressure at rest over the 4200 MPa of ISO 76",
            value: rest.inner_pressure_max_pa.max(rest.outer_pressure_max_pa) / STRESS_LIMIT_PA,
            limit: 1.0,
            at_least: false,
        }));
        Self { terms }
    }

    /// The estimate in oil, by its film on the plain ring at rest: the gap outside the raceways has the lag of a free
    /// ball in it, and may be smaller than β0 by what it may be in a verdict with a film, which has limits of its own.
    pub fn in_oil(mut self, case: &Case, film: &FilmAtRest) -> Self {
        let steady = steady_gap_rad(&case.bearing, &case.raceways);
        let in_oil = steady + film.lag_rad / case.bearing.balls() as f64;
        let of_gaps = ["separation", "depth"];
        let gaps = (self.terms.iter_mut()).filter(|term| of_gaps.contains(&term.name));
        let mut beta0_rad = 0.0;
        for term in gaps {
            beta0_rad = term.value * steady;
            term.value = beta0_rad / in_oil;
            if !term.at_least {
                term.limit *= IN_OIL[1];
            }
        }
        if beta0_rad > 0.0 {
            let mut most = |name, meaning, value, limit| {
                self.terms.push(EstimateTerm {
                    name,
                    meaning,
                    value,
                    limit,
                    at_least: false,
                });
            };
            most(
                "film-queue",
                "speed that free balls lose to the film over the free share of the pitch circle",
                film.speed_deficit / film.free_share,
                FILM_QUEUE.limit(),
            );
            // Nothing opens where the film stops a ball, nor without a load zone.
            let opening_gap_rad = Some(film.opening_gap_rad).filter(|gap| gap.is_finite());
            most(
                "film-outweighs",
                "gap that the film opens over β0",
                opening_gap_rad.unwrap_or(0.0) / beta0_rad,
                FILM_OUTWEIGHS.limit(),
            );
        }
        self
    }

    /// Whether every term keeps its limit; `None` where one is not known and none is missed.
    pub fn passes(&self) -> Option<bool> {
        let margins = || self.terms.iter().map(EstimateTerm::margin);
        match margins().any(|margin| margin < 0.0) {
            true => Some(false),
            false => margins().all(|margin| margin >= 0.0).then_some(true),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::{conventional, dimensions, structure, structures};
    use cageless::FlankModel;
    use cageless::equilibrium;
    use cageless::film::{Film, Oil, Traction};

    fn estimate(case: &Case) -> Estimate {
        Estimate::new(case, &equilibrium::solve(case).unwrap())
    }

    fn value(estimate: &Estimate, name: &str) -> f64 {
        estimate
            .terms
            .iter()
            .find(|t| t.name == name)
            .unwrap()
            .value
    }

    /// The lag of a flooded film lowers β0 over the gap outside, as that of the verdict; thick oil outweighs the
    /// raceway, and thicker makes balls queue.
    #[test]
    fn films_lag_in_the_estimate() {
        let dry = structure(5.1, 25.2);
        let rest = equilibrium::solve(&dry).unwrap();
        let wet = |mpa_s: f64| {
            let film = Some(Film::flooded(Oil::mineral(1e-3 * mpa_s, 0.035)));
            let plain = Case {
                film,
                ..dry.conventional()
            };
            let film = FilmAtRest::new(&plain, &equilibrium::settle(&plain).unwrap()).unwrap();
            (Estimate::new(&dry, &rest).in_oil(&dry, &film), film)
        };
        let of = |estimate: &Estimate, name: &str| {
            *estimate.terms.iter().find(|t| t.name == name).unwrap()
        };
        let (estimate, film) = wet(5.0);
        let steady = steady_gap_rad(&dry.bearing, &dry.raceways);
        let wider = steady + film.lag_rad / 14.0;
        for name in ["separation", "depth"] {
            let [before, after] = [&Estimate::new(&dry, &rest), &estimate].map(|e| of(e, name));
            assert!((before.value * steady - after.value * wider).abs() < 1e-12);
            assert_eq!(
                after.limit,
                before.limit * if name == "depth" { 1.1 } else { 1.0 }
            );
        }
        let missed = |mpa_s: f64| {
            let estimate = wet(mpa_s).0;
            let missed = estimate.terms.iter().filter(|term| term.margin() < 0.0);
            missed.map(|term| term.name).collect::<Vec<_>>()
        };
        assert_eq!(missed(5.0), Vec::<&str>::new());
        for (mpa_s, outweighs, queues) in [(30.0, true, false), (100.0, true, true)] {
            let missed = missed(mpa_s);
            let of = ["film-outweighs", "film-queue"].map(|name| missed.contains(&name));
            assert_eq!(of, [outweighs, queues], "{mpa_s}: {missed:?}");
        }
    }

    /// A film too thin to part the surfaces demands what asperities alone do; a full one leaves μ of the law out, and the
    /// friction that remains is of one contact or two.
    #[test]
    fn films_are_what_friction_is_available() {
        let with = |film: Option<Film>, coefficient: f64| {
            let mut case = structure(5.1, 25.2);
            case.contact.friction.coefficient = coefficient;
            case.film = film;
            value(&estimate(&case), "sliding")
        };
        let film = |mpa_s: f64, roughness_m: f64| {
            Some(Film {
                traction: Traction::Film,
                roughness_m,
                ..Film::flooded(Oil::mineral(1e-3 * mpa_s, 0.035))
            })
        };
        let (thin, dry) = (with(film(0.1, 1e-5), 0.11), with(None, 0.11));
        assert!((thin / dry - 1.0).abs() < 0.02, "{thin} {dry}");
        let [full, other] = [0.007, 0.11].map(|coefficient| with(film(20.0, 1e-9), coefficient));
        assert!((full / other - 1.0).abs() < 1e-9, "{full} {other}");
        assert!(full > 2.0 * dry, "{full} {dry}");
        let rough = with(film(20.0, 1e-6), 0.11);
        assert!(dry < rough && rough < full, "{dry} {rough} {full}");
    }

    #[test]
    fn limits_are_kept_up_to_themselves() {
        let passes = |at_least: bool, value: f64| {
            let term = EstimateTerm {
                name: "",
                meaning: "",
                value,
                limit: 0.8,
                at_least,
            };
            Estimate { terms: vec![term] }.passes()
        };
        for (at_least, beyond) in [(true, 0.8f64.next_down()), (false, 0.8f64.next_up())] {
            assert_eq!(passes(at_least, 0.8), Some(true));
            assert_eq!(passes(at_least, beyond), Some(false));
            assert_eq!(passes(at_least, f64::NAN), None);
        }
        let term = EstimateTerm {
            name: "",
            meaning: "",
            value: 1.2,
            limit: 0.8,
            at_least: true,
        };
        assert!((term.margin() - 0.5).abs() < 1e-12);
    }

    /// Limits of the estimate separate the structures of Zhao 2022: (a) and (b) are too long, (f) to (j) demand
    /// too much friction.
    #[test]
    fn the_structures_of_the_paper_are_told_apart() {
        for (k, (span, angle, beta0, _)) in structures().into_iter().enumerate() {
            let case = structure(span, angle);
            let found = estimate(&case);
            let demand = value(&found, "sliding");
            assert_eq!(demand < 1.40, k < 5, "{span}: {demand}");
            assert_eq!(demand > 1.50, k >= 5, "{span}: {demand}");
            // Two spacings of 360°/14 between three balls.
            let length = value(&found, "both-neighbours");
            assert!((length - 2.0 * angle / (720.0 / 14.0)).abs() < 1e-12);
            let steady = steady_gap_rad(&case.bearing, &case.raceways).to_degrees();
            let separation = value(&found, "separation");
            assert!((separation - beta0 / steady).abs() < 1e-4, "{separation}");
            let e = equilibrium::solve(&case).unwrap();
            let stress = e.inner_pressure_max_pa.max(e.outer_pressure_max_pa) / 4.2e9;
            assert!((value(&found, "stress") - stress).abs() < 1e-12);
            assert_eq!(found.passes(), Some((2..5).contains(&k)), "{span}");
        }
        let plain = conventional(dimensions());
        assert_eq!(estimate(&plain).terms.len(), 1);
        let narrow = structure(4.3, 25.2);
        let found = estimate(&narrow);
        assert!(value(&found, "separation") < 0.8 && found.passes() == Some(false));
    }

    /// β0 has an upper end, beyond which evenly spaced balls collide: 1/0.95 of the steady gap on rigid flanks, on
    /// elastic ones, which may leave half of it, twice the steady gap.
    #[test]
    fn a_raceway_may_be_too_deep() {
        for (flanks, limit) in [(FlankModel::Rigid, 1.0 / 0.95), (FlankModel::Elastic, 2.0)] {
            let mut passed = [false; 2];
            for span in [4.8, 5.1, 5.3, 5.5, 6.0, 6.5, 7.0] {
                let mut case = structure(span, 25.2);
                case.flanks = flanks;
                let found = Estimate::elastic(&case, &[[0.0, 0.0]], None);
                let term = found.terms.iter().find(|t| t.name == "depth").unwrap();
                assert!((term.limit - limit).abs() < 1e-12);
                assert_eq!(term.value, value(&found, "separation"));
                passed[usize::from(term.margin() >= 0.0)] = true;
                if term.margin() < 0.0 {
                    assert_eq!(found.passes(), Some(false), "{span}");
                }
            }
            assert_eq!(passed, [true; 2], "{flanks:?}");
        }
    }

    /// Each term of the estimate of several raceways is that of the worst.
    #[test]
    fn the_worst_raceway_is_estimated() {
        let long = structure(5.1, 25.2);
        let short = structure(5.2, 22.0);
        let other = crate::common::raceway(&long.bearing, 5.2, 22.0, 0.0);
        let of = |raceways: Vec<Raceway>| {
            let case = long.with_raceways(raceways);
            let e = equilibrium::solve(&long).unwrap();
            Estimate::new(&case, &e)
        };
        let both = of(vec![long.raceways[0].clone(), other.clone()]);
        let e = equilibrium::solve(&long).unwrap();
        let demands = [&long.raceways[0], &other].map(|r| friction_demand(&long, &e, r));
        assert!(demands[1] > demands[0]);
        assert_eq!(value(&both, "sliding"), demands[1]);
        let lengths = [&long, &short].map(|case| value(&estimate(case), "both-neighbours"));
        assert_eq!(value(&both, "both-neighbours"), lengths[0]);
    }
}
