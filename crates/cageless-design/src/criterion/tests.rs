use super::*;

#[test]
fn a_value_that_misses_its_limit_is_not_printed_as_the_limit() {
    assert_eq!(beside(42.0, 25.0, 1), "42.0");
    assert_eq!(beside(5.003, 5.0, 1), "5.003");
    assert_eq!(beside(5.0, 5.0, 1), "5.0");
    let text = SEPARATION.of(0.050_03).to_string();
    assert_eq!(
        text,
        "sliding lowers the critical gap by 5.003 % of β0 (limit 5 %, missed by 0.003 percentage points)"
    );
}

#[test]
fn the_first_failure_decides_and_else_the_smallest_margin() {
    let good = [
        SEPARATION.of(0.01),
        DECELERATION.of(1.0),
        BOTH_NEIGHBOURS.of(0.23),
    ];
    assert_eq!(Criterion::deciding(&good), Some(good[2]));
    let bad = [
        SEPARATION.of(0.01),
        DECELERATION.of(0.5),
        BOTH_NEIGHBOURS.of(0.9),
    ];
    assert_eq!(Criterion::deciding(&bad), Some(bad[1]));
    // The second is missed by 30 points, the third by 65.
    let most = Criterion::missed_by_most(&bad, bad[1]);
    assert_eq!(most, format!("; missed by most: {}", bad[2]));
    assert_eq!(Criterion::missed_by_most(&bad, bad[2]), "");
    assert_eq!(Criterion::missed_by_most(&good, good[2]), "");
    // What is not known is neither kept nor missed, unless another is missed.
    let unknown = DECELERATION.of(f64::NAN);
    assert!(!unknown.is_met());
    assert_eq!(unknown.verdict(), RacewayVerdict::NotJudged);
    assert_eq!(Criterion::deciding(&[good[0], unknown]), None);
    assert_eq!(
        Criterion::verdict_of(&[good[0], unknown]),
        RacewayVerdict::NotJudged
    );
    assert_eq!(Criterion::deciding(&[unknown, bad[2]]), Some(bad[2]));
    let missing = Criterion::missing(&[good[0], unknown]).unwrap();
    assert!(missing.starts_with("the deceleration"), "{missing}");
    assert_eq!(Criterion::missing(&good), None);
    assert_eq!(Criterion::deciding(&[]), None);
    // A pressure by the load that is left, a third here; at the limit none.
    let pressed = [BOTH_NEIGHBOURS.of(0.15), PRESSURE_AT_REST.of(0.874)];
    assert_eq!(Criterion::deciding(&pressed), Some(pressed[1]));
    assert!((pressed[1].relative_margin() - 0.332).abs() < 1e-3);
    assert_eq!(PRESSURE_AT_REST.of(1.0).relative_margin(), 0.0);
    // By the fraction of the possible margin: 0.15 of 0.2, not 0.01 of 0.05.
    let close = [
        SEPARATION.of(0.04),
        DECELERATION.of(0.83),
        BOTH_NEIGHBOURS.of(0.20),
    ];
    assert_eq!(Criterion::deciding(&close), Some(close[1]));
}

#[test]
fn a_pressure_is_in_megapascal() {
    let text = |value: f64| PRESSURE_AT_REST.of(value).to_string();
    assert_eq!(
        text(0.5),
        "the contact pressure at rest reaches 2100 MPa (limit 4200 MPa of ISO 76, margin 2100 MPa)"
    );
    assert_eq!(
        text(1.5),
        "the contact pressure at rest reaches 6300 MPa (limit 4200 MPa of ISO 76, missed by 2100 MPa)"
    );
    assert!(
        text(1.0 + 1e-5).contains("4200.04 MPa"),
        "{}",
        text(1.0 + 1e-5)
    );
    assert!(text(f64::NAN).contains("NaN MPa"));
    for (value, met) in [(1.0, true), (1f64.next_up(), false), (f64::NAN, false)] {
        let pressure = PRESSURE_AT_REST.of(value);
        assert_eq!((pressure.is_met(), pressure.at_least()), (met, false));
        let expected = match met {
            true => RacewayVerdict::Smooth,
            false if value.is_nan() => RacewayVerdict::NotJudged,
            false => RacewayVerdict::Overloaded,
        };
        assert_eq!(pressure.verdict(), expected);
    }
}

/// A critical gap has two ends: balls are spread by 80 % of the steady-state gap at least, and evenly spaced ones
/// collide beyond all of it.
#[test]
fn a_critical_gap_has_both_ends() {
    let of = |value: f64| STEADY_GAP.of(value);
    for (value, verdict) in [
        (0.8, RacewayVerdict::Smooth),
        (1.0, RacewayVerdict::Smooth),
        (0.8f64.next_down(), RacewayVerdict::TooShallow),
        (0.0, RacewayVerdict::TooShallow),
        (1f64.next_up(), RacewayVerdict::TooDeep),
        (5.53 / 2.66, RacewayVerdict::TooDeep),
    ] {
        assert_eq!(of(value).verdict(), verdict, "{value}");
    }
    assert_eq!(
        of(1.25).to_string(),
        "the critical gap is 125.0 % of the steady-state gap (80 to 100 % needed, missed by 25.0 percentage points)"
    );
    assert!((of(0.95).relative_margin() - 0.5).abs() < 1e-12);
    assert!((of(0.82).relative_margin() - 0.2).abs() < 1e-12);
}

/// At its limit a criterion is met, the next number beyond it is a failure; half way from the
/// ideal value to the limit half of the margin is left.
#[test]
fn limits_are_met_up_to_themselves() {
    let rows: [(&'static Requirement, &str, f64, f64, RacewayVerdict, &str); 4] = [
        (
            &SEPARATION,
            "separation",
            0.0,
            0.05,
            RacewayVerdict::Slips,
            "sliding lowers the critical gap by 6.0 % of β0 (limit 5 %, missed by 1.0 percentage points)",
        ),
        (
            &DECELERATION,
            "deceleration",
            1.0,
            0.8,
            RacewayVerdict::Slips,
            "balls reach 76.0 % of the kinematic deceleration (80 % needed, missed by 4.0 \
             percentage points)",
        ),
        (
            &BOTH_NEIGHBOURS,
            "both-neighbours",
            0.0,
            0.25,
            RacewayVerdict::DoubleCollision,
            "30.0 % of the passages have a double collision (limit 25 %, missed by 5.0 \
             percentage points)",
        ),
        (
            &LAG,
            "lag",
            1.0,
            0.5,
            RacewayVerdict::LosesLag,
            "balls keep 40.0 % of the lag of rolling on rigid flanks (50 % needed, missed by 10.0 \
             percentage points)",
        ),
    ];
    for (required, name, ideal, limit, failure, text) in rows {
        let of = |value: f64| required.of(value);
        let at = of(limit);
        assert_eq!((at.name(), at.value, at.limit()), (name, limit, limit));
        assert_eq!(at.at_least(), ideal > limit);
        let beyond = |by: f64| limit + by * (limit - ideal);
        let next = if limit > ideal {
            limit.next_up()
        } else {
            limit.next_down()
        };
        assert!(at.is_met() && !of(next).is_met(), "{name}");
        assert_eq!(at.verdict(), RacewayVerdict::Smooth);
        assert_eq!(of(next).verdict(), failure);
        // Better than ideal is no failure: a critical gap above β0, say.
        assert!(of(beyond(-5.0)).is_met(), "{name}");
        for (value, margin) in [(ideal, 1.0), (beyond(-0.5), 0.5), (limit, 0.0)] {
            let found = of(value).relative_margin();
            assert!((found - margin).abs() < 1e-12, "{name} {value}: {found}");
            let found = of(value).margin();
            let expected = margin * (limit - ideal).abs();
            assert!((found - expected).abs() < 1e-12, "{name} {value}: {found}");
        }
        assert_eq!(of(beyond(0.2)).to_string(), text);
    }
    let text = SEPARATION.of(-0.2).to_string();
    assert!(
        text.starts_with("sliding does not lower the critical gap"),
        "{text}"
    );
    assert!(text.ends_with("margin 25.0 percentage points)"), "{text}");
}
