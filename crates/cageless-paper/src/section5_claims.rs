//! What is found of the claims of Section 5, worded by the numbers.

use cageless_report::{
    Change, Claim, ClaimStatus, ComparisonCell, Difference, Estimate, RingComparison,
};

use crate::claims::Evidence;
use crate::comparison::{FOUND, STRUCTURE_D};
use crate::experiment::Bearing;

/// The claims of Section 5.
pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    let [conventional, discrete] = &e.experiment.bearings[..] else {
        return vec![];
    };
    let mut claims = vec![vibration(e.comparison), spacing(e.comparison)];
    let one_start = [one_start_vibration, one_start_spacing];
    for (claim, one_start) in claims.iter_mut().zip(one_start) {
        claim.numbers += &one_start(conventional, discrete);
    }
    let counts = |t: &[usize; 4]| t.map(|n| n.to_string()).join(", ");
    claims.push(claim(
        ClaimStatus::NotConfirmed,
        "Section 5, Fig. 13, 14",
        "At 0.05, 0.1, 0.15 and 0.2 s balls touch in the conventional bearing and hardly in the \
         discrete one.",
        "The photographs show two different bearings; their starts are not known. From one and \
         the same start the model does not show the difference at these moments.",
        format!(
            "pairs closer than 0.01°: conventional {}, discrete {}",
            counts(&conventional.touching),
            counts(&discrete.touching)
        ),
    ));
    claims.push(claim(
        if conventional.transition_fraction > 0.5 {
            ClaimStatus::Confirmed
        } else {
            ClaimStatus::NotConfirmed
        },
        "Section 4.3, citing [39]",
        "In a conventional bearing balls collide mostly in the transition between the loaded and \
         the unloaded zone.",
        "Where the load lets go of a ball or takes it again, neighbours meet.",
        format!(
            "{:.0} % of the contacts at 60° < |ψ| < 150°",
            100.0 * conventional.transition_fraction
        ),
    ));
    claims
}

fn claim(verdict: ClaimStatus, place: &str, claim: &str, finding: &str, numbers: String) -> Claim {
    Claim {
        claim: claim.to_owned(),
        place: place.to_owned(),
        finding: finding.to_owned(),
        numbers,
        verdict,
    }
}

fn one_start_vibration(conventional: &Bearing, discrete: &Bearing) -> String {
    format!(
        "; the start of Fig. 12: RMS {:.3} m/s² conventional, {:.3} m/s² discrete; {:.0} and {:.0} \
         contacts per second",
        conventional.rms_m_s2,
        discrete.rms_m_s2,
        conventional.collisions_per_s,
        discrete.collisions_per_s
    )
}

fn one_start_spacing(conventional: &Bearing, discrete: &Bearing) -> String {
    format!(
        "; the start of Fig. 12: {:.2}° at the start; after 1 s {:.2}° conventional, {:.2}° \
         discrete",
        discrete.gap_deviation_deg[0],
        conventional.gap_deviation_deg[1],
        discrete.gap_deviation_deg[1]
    )
}

/// How often a quantity of a ring is lower, higher and not significantly different from that of
/// the conventional ring, over speeds and lots of balls.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
struct Tally {
    lower: usize,
    higher: usize,
    undecided: usize,
}

impl Tally {
    fn new(rings: &RingComparison, ring: &str, of: fn(&Difference) -> Estimate) -> Self {
        let mut tally = Self::default();
        let cells = rings.cells.iter().filter(|c| c.ring == ring);
        for difference in cells.filter_map(|c| c.difference.as_ref()) {
            *match of(difference).change() {
                Change::Lower => &mut tally.lower,
                Change::Higher => &mut tally.higher,
                Change::Undecided => &mut tally.undecided,
            } += 1;
        }
        tally
    }

    fn all(self) -> usize {
        self.lower + self.higher + self.undecided
    }

    fn always_lower(self) -> bool {
        self.lower > 0 && self.lower == self.all()
    }

    fn verdict(self) -> ClaimStatus {
        if self.always_lower() {
            ClaimStatus::Confirmed
        } else if self.lower > 0 {
            ClaimStatus::Partly
        } else if self.all() > 0 {
            ClaimStatus::NotConfirmed
        } else {
            ClaimStatus::NotTested
        }
    }

    /// `higher in all 8 cases`, `lower in 2 and higher in 6 of 8 cases`.
    fn text(self) -> String {
        let parts: Vec<(usize, &str)> = [
            (self.lower, "lower"),
            (self.higher, "higher"),
            (self.undecided, "not significantly different"),
        ]
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .collect();
        match parts[..] {
            [] => "not computed".to_owned(),
            [(count, word)] => format!("{word} in all {count} cases"),
            _ => {
                let parts: Vec<String> = parts
                    .iter()
                    .map(|(count, word)| format!("{word} in {count}"))
                    .collect();
                format!("{} of {} cases", parts.join(", "), self.all())
            }
        }
    }
}

/// Whether lots of unequal balls give the sign of the difference that equal balls give.
fn unequal_balls(rings: &RingComparison) -> String {
    let change = |c: &ComparisonCell| c.difference.map(|d| d.rms_m_s2.change());
    let turned: Vec<String> = rings
        .cells
        .iter()
        .filter(|c| c.lot_diameter_variation_um > 0.0)
        .filter(|c| {
            let equal = rings.cells.iter().find(|e| {
                e.lot_diameter_variation_um == 0.0 && e.speed_rpm == c.speed_rpm && e.ring == c.ring
            });
            equal.is_some_and(|equal| change(equal) != change(c))
        })
        .map(|c| format!("{} with {} at {} rpm", c.lot, c.ring, c.speed_rpm))
        .collect();
    if turned.is_empty() {
        "Balls of unequal size do not change that.".to_owned()
    } else {
        format!("Balls of unequal size change that: {}.", turned.join(", "))
    }
}

fn vibration(rings: &RingComparison) -> Claim {
    let of = |ring: &str| Tally::new(rings, ring, |d| d.rms_m_s2);
    let (rms, found) = (of(STRUCTURE_D), of(FOUND));
    let contacts = Tally::new(rings, STRUCTURE_D, |d| d.contacts_per_s);
    let impulses = Tally::new(rings, STRUCTURE_D, |d| d.impulse_rate_n);
    let without = Tally::new(rings, STRUCTURE_D, |d| d.rms_without_contacts_m_s2);
    let verdict = match rms.verdict() {
        // Lower vibration for another reason is half of the claim.
        ClaimStatus::Confirmed if !impulses.always_lower() => ClaimStatus::Partly,
        verdict => verdict,
    };
    let finding = format!(
        "Against a conventional ring with the same balls from the same starts the vibration with \
         structure (d) is {}, with the raceways that a search recommends {}. {} Structure (d): \
         contacts between balls per second {}, their impulse per second {}, vibration with the \
         contacts cut out of the force {}. The model leaves out {}.",
        rms.text(),
        found.text(),
        unequal_balls(rings),
        contacts
            .text()
            .replace("lower", "fewer")
            .replace("higher", "more"),
        impulses.text(),
        without.text(),
        rings.left_out.join(", "),
    );
    claim(
        verdict,
        "Section 5, Fig. 12",
        "The discrete raceway lowers the vibration, because balls collide less.",
        &finding,
        numbers(rings, "RMS (m/s²)", |c| c.rms_m_s2),
    )
}

fn spacing(rings: &RingComparison) -> Claim {
    let tally = Tally::new(rings, STRUCTURE_D, |d| d.gap_deviation_deg);
    let found = Tally::new(rings, FOUND, |d| d.gap_deviation_deg);
    let finding = format!(
        "Both rings open the bunches of the start. The standard deviation of the gaps at the end \
         is {} with structure (d), {} with the raceways that a search recommends.",
        tally.text(),
        found.text()
    );
    claim(
        tally.verdict(),
        "Sections 5 and 6",
        "The discrete raceway spreads the balls evenly.",
        &finding,
        numbers(rings, "standard deviation of the gaps (°)", |c| {
            c.gap_deviation_deg
        }),
    )
}

/// A quantity of every ring with the first and the last lot of every speed.
fn numbers(rings: &RingComparison, what: &str, of: fn(&ComparisonCell) -> Estimate) -> String {
    let mut parts = vec![];
    for speed_rpm in rings.speeds_rpm() {
        let mut lots: Vec<&str> = rings.at_speed(speed_rpm).map(|c| c.lot.as_str()).collect();
        lots.dedup();
        let ends = [lots.first(), lots.last()];
        for lot in ends.into_iter().flatten() {
            let values: Vec<String> = rings
                .at_speed(speed_rpm)
                .filter(|c| c.lot == **lot)
                .map(|c| format!("{} {}", c.ring, of(c).text()))
                .collect();
            parts.push(format!("{speed_rpm} rpm, {lot}: {}", values.join(", ")));
        }
    }
    format!("{what}: {}", parts.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::CONVENTIONAL;

    /// Two speeds with equal balls and G28; a quantity of structure (d) differs by `by(speed,
    /// unequal)` from that of the conventional ring.
    fn rings(by: fn(f64, bool) -> f64) -> RingComparison {
        let estimate = |mean: f64| Estimate::new(&[mean - 0.01, mean, mean + 0.01]).unwrap();
        let mut cells = vec![];
        for speed_rpm in [3000.0, 12_000.0] {
            for (lot, variation_um) in [("equal balls", 0.0), ("G28", 1.4)] {
                for ring in [CONVENTIONAL, STRUCTURE_D, FOUND] {
                    let less = estimate(by(speed_rpm, variation_um > 0.0));
                    let value = estimate(1.0);
                    let difference = Difference {
                        rms_m_s2: less,
                        rms_at_passing_m_s2: less,
                        rms_between_m_s2: less,
                        rms_without_contacts_m_s2: less,
                        rms_from_contacts_m_s2: less,
                        gap_deviation_deg: less,
                        contacts_per_s: less,
                        impulse_rate_n: less,
                    };
                    cells.push(ComparisonCell {
                        speed_rpm,
                        lot: lot.to_owned(),
                        lot_diameter_variation_um: variation_um,
                        ring: ring.to_owned(),
                        raceway: None,
                        rms_m_s2: value,
                        rms_at_passing_m_s2: value,
                        rms_between_m_s2: value,
                        rms_without_contacts_m_s2: value,
                        rms_from_contacts_m_s2: value,
                        gap_deviation_deg: value,
                        contacts_per_s: value,
                        approach_speed_m_s: None,
                        impulse_n_s: None,
                        impulse_rate_n: value,
                        difference: (ring != CONVENTIONAL).then_some(difference),
                    });
                }
            }
        }
        RingComparison {
            cells,
            left_out: vec!["tilt".to_owned()],
            ..RingComparison::default()
        }
    }

    /// Opposite numbers must be worded as the opposite claim.
    #[test]
    fn claims_are_worded_by_the_numbers() {
        let higher = rings(|_, _| 0.5);
        let c = vibration(&higher);
        assert_eq!(c.verdict, ClaimStatus::NotConfirmed);
        assert!(c.finding.contains("structure (d) is higher in all 4 cases"));
        assert!(c.finding.contains("do not change that"), "{}", c.finding);
        assert_eq!(spacing(&higher).verdict, ClaimStatus::NotConfirmed);

        let lower = rings(|_, _| -0.5);
        let c = vibration(&lower);
        assert_eq!(c.verdict, ClaimStatus::Confirmed);
        assert!(c.finding.contains("structure (d) is lower in all 4 cases"));
        assert!(c.finding.contains("per second fewer in all 4 cases"));
        assert_eq!(spacing(&lower).verdict, ClaimStatus::Confirmed);

        let turned = rings(|_, unequal| if unequal { -0.5 } else { 0.5 });
        let c = vibration(&turned);
        assert_eq!(c.verdict, ClaimStatus::Partly);
        assert!(c.finding.contains("lower in 2, higher in 2 of 4 cases"));
        assert!(
            c.finding
                .contains("change that: G28 with structure (d) at 3000 rpm")
        );

        let same = rings(|_, _| 0.001);
        assert_eq!(vibration(&same).verdict, ClaimStatus::NotConfirmed);
        assert!(
            vibration(&same)
                .finding
                .contains("not significantly different in all 4")
        );
        assert_eq!(
            vibration(&RingComparison::default()).verdict,
            ClaimStatus::NotTested
        );
    }
}
