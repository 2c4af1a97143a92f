//! The film of rolling contacts against numbers worked out apart from this program, and closed forms.

use crate::common::oil;
use cageless::contact::friction::Smooth;
use cageless::contact::{AtFlanks, FlankContact, FlankSliding};
use cageless::film::{
    Film, FreeBall, LubricatedContact, Oil, Rolling, asperity_share, starved_share,
};
use cageless::reference;
use cageless::{Bearing, Material};

fn rolling(speed_m_s: f64, load_n: f64) -> Rolling {
    Rolling { load_n, speed_m_s }
}

/// κ, M, both limits, F_R flooded and heated, N, films h_min and h_c, µm.
struct Expected {
    axis_ratio: f64,
    transition: f64,
    limits_n: [f64; 2],
    forces_n: [f64; 2],
    films_um: [f64; 2],
}

fn close(value: f64, expected: f64, what: &str) {
    let relative = value / expected - 1.0;
    assert!(
        relative.abs() < 4e-6,
        "{what}: {value}, expected {expected}"
    );
}

fn compare(contact: &LubricatedContact, oil: &Oil, at: Rolling, expected: &Expected) {
    let force = contact.rolling_force(oil, at);
    let film = contact.film_thickness(oil, at);
    close(contact.axis_ratio, expected.axis_ratio, "κ");
    close(force.transition, expected.transition, "M");
    close(force.rigid_n, expected.limits_n[0], "IVR");
    close(force.elastohydrodynamic_n, expected.limits_n[1], "EHL");
    close(force.isothermal_n(), expected.forces_n[0], "F_R");
    close(force.heated_n(), expected.forces_n[1], "with heat");
    close(1e6 * film.least_m, expected.films_um[0], "h_min");
    close(1e6 * film.central_m, expected.films_um[1], "h_c");
}

#[test]
fn outer_and_inner_contact() {
    let bearing = reference::bearing();
    let expected = Expected {
        axis_ratio: 0.137897,
        transition: 11.8288,
        limits_n: [0.120831, 0.0538211],
        forces_n: [0.0778197, 0.0711246],
        films_um: [0.291645, 0.352439],
    };
    let outer = LubricatedContact::outer(&bearing, 1.0);
    compare(&outer, &oil(5.0), rolling(13.75, 20.0), &expected);
    let expected = Expected {
        axis_ratio: 0.106754,
        transition: 129.932,
        limits_n: [0.760195, 0.406101],
        forces_n: [0.423218, 0.331272],
        films_um: [0.491211, 0.595302],
    };
    let inner = LubricatedContact::inner(&bearing);
    compare(&inner, &oil(20.0), rolling(13.75, 474.0), &expected);
}

/// A round contact of a modulus E′ of 2.3e11 Pa.
#[test]
fn round_contact() {
    let material = Material {
        youngs_modulus_pa: 2.3e11,
        poisson_ratio: 0.0,
        ..Material::STEEL
    };
    let contact = LubricatedContact::between([200.0; 2], [0.0; 2], [&material; 2]);
    let oil = Oil {
        viscosity_temperature_1_k: 0.04,
        thermal_conductivity_w_m_k: 0.134,
        ..oil(100.0)
    };
    let expected = Expected {
        axis_ratio: 1.0,
        transition: 36.3147,
        limits_n: [0.0379797, 0.0136467],
        forces_n: [0.0173889, 0.0170690],
        films_um: [0.183981, 0.314647],
    };
    compare(&contact, &oil, rolling(1.0, 10.0), &expected);
}

/// A flank whose contact lies at Ro.
#[test]
fn flank() {
    let bearing = reference::bearing();
    let d = bearing.dimensions();
    let cosine = 4.0223e-3 / d.ball_radius_m;
    let ring = [
        -cosine / d.outer_groove_bottom_radius_m,
        -1.0 / d.outer_groove_curvature_radius_m,
    ];
    let ball = [1.0 / d.ball_radius_m; 2];
    let contact = LubricatedContact::between(ball, ring, [&Material::STEEL; 2]);
    let expected = Expected {
        axis_ratio: 0.135244,
        transition: 187.465,
        limits_n: [0.275361, 0.122375],
        forces_n: [0.127578, 0.117894],
        films_um: [0.222876, 0.273853],
    };
    compare(&contact, &oil(5.0), rolling(12.6, 290.9), &expected);
}

/// Slopes of ln F_R over ln u and ln Q of the outer contact.
#[test]
fn slopes_of_the_force() {
    let contact = LubricatedContact::outer(&reference::bearing(), 1.0);
    let film = Film::flooded(oil(5.0));
    let ln = |u: f64, q: f64| film.rolling_force_n(&contact, rolling(u, q)).ln();
    let h: f64 = 1e-4;
    let (more, less) = (h.exp(), (-h).exp());
    let over_u = (ln(13.75 * more, 20.0) - ln(13.75 * less, 20.0)) / (2.0 * h);
    let over_q = (ln(13.75, 20.0 * more) - ln(13.75, 20.0 * less)) / (2.0 * h);
    assert!((over_u - 0.717904).abs() < 1e-6, "{over_u}");
    assert!((over_q - 0.135391).abs() < 1e-6, "{over_q}");
}

/// The power laws of Bălan et al. (2015), Eq. (1) to (4), fitted to the same formula: at the outer contact within 1 %,
/// 10 % above at a round one.
#[test]
fn power_laws() {
    let of = |contact: &LubricatedContact, viscosity_pa_s: f64, at: Rolling| {
        let (e, r) = (contact.modulus_pa, contact.rolling_radius_m);
        let k = contact.cross_radius_m / r;
        let load = at.load_n / (e * r * r);
        let speed = viscosity_pa_s * at.speed_m_s / (e * r);
        let scale = e * r * r * load.cbrt();
        let rigid = 2.9766 * scale * k.powf(0.3316) * speed.powf(2.0 / 3.0);
        let elastic = 7.5826 * scale * k.powf(0.4055) * speed.powf(0.75);
        let transition = 0.5549 * k.powf(-0.6029) * load * speed.powf(-0.75);
        (rigid - elastic) / (1.0 + transition / 6.6) + elastic
    };
    let outer = LubricatedContact::outer(&reference::bearing(), 1.0);
    close(of(&outer, 5e-3, rolling(13.75, 20.0)), 0.0774297, "outer");
    let material = Material {
        youngs_modulus_pa: 2.3e11,
        poisson_ratio: 0.0,
        ..Material::STEEL
    };
    let round = LubricatedContact::between([200.0; 2], [0.0; 2], [&material; 2]);
    close(of(&round, 0.1, rolling(1.0, 10.0)), 0.0190819, "round");
}

#[test]
fn starvation() {
    for (ratio, share) in [
        (2.0, 0.200097),
        (5.0, 0.373304),
        (10.0, 0.525547),
        (100.0, 0.859751),
        (f64::INFINITY, 1.0),
    ] {
        close(starved_share(ratio), share, "T/T*");
    }
}

/// Pivoting of a contact under Coulomb friction over μQa (Bălan et al., Eq. (11)), and fast spin at a flank, whose
/// strip is that of a line.
#[test]
fn pivoting() {
    let moment = |k: f64| {
        let [line, round] = [0.375, 3.0 * std::f64::consts::PI / 16.0];
        line + (round - line) * k.powf(-0.945 - 0.016 * k.ln())
    };
    for (k, expected) in [(1.0, 0.589049), (5.0, 0.419873), (20.0, 0.385932)] {
        close(moment(k), expected, "moment of pivoting");
    }
    let law = Smooth {
        coefficient: 0.1,
        inverse_regularisation_speed: 1e6,
    };
    let (normal_n, semi_axis_m, sine, spin_rad_s) = (300.0, 1e-3, 0.4, 1e3);
    let flanks = FlankContact {
        sine_square: sine * sine,
        axis_square: semi_axis_m * semi_axis_m,
        ..FlankContact::default()
    };
    let sliding = FlankSliding::new(&law, &flanks, 0.0, spin_rad_s);
    let [_, drag] = AtFlanks { law, sliding }.drag(&flanks, 0.0, normal_n);
    let found = drag * spin_rad_s / (0.1 * normal_n * semi_axis_m * sine);
    assert!((found - 0.375).abs() < 1e-6, "{found}");
    let outer = LubricatedContact::outer(&reference::bearing(), 1.0);
    let ellipse = moment(outer.cross_radius_m / outer.rolling_radius_m);
    assert!((ellipse / found - 1.0).abs() < 0.03, "{ellipse}");
}

#[test]
fn asperities_carry_less_under_thicker_films() {
    close(asperity_share(1.0), (-2.1f64).exp(), "φ");
    assert_eq!(asperity_share(0.0), 1.0);
    assert!(asperity_share(3.0) < asperity_share(2.0));
}

/// Odd in the speed, zero without load, supply or speed.
#[test]
fn reversal_and_nothing() {
    let contact = LubricatedContact::inner(&reference::bearing());
    let film = Film::flooded(oil(5.0));
    let force = |film: &Film, u: f64, q: f64| film.rolling_force_n(&contact, rolling(u, q));
    assert_eq!(force(&film, -3.0, 50.0), -force(&film, 3.0, 50.0));
    assert!(force(&film, 3.0, 50.0) > 0.0);
    for (u, q) in [(3.0, 0.0), (3.0, -1.0), (0.0, 50.0)] {
        assert_eq!(force(&film, u, q), 0.0);
    }
    let starved = Film {
        supply: 0.0,
        ..film
    };
    assert_eq!(force(&starved, 3.0, 50.0), 0.0);
    let half = Film {
        supply: 0.5,
        ..film
    };
    assert_eq!(force(&half, 3.0, 50.0), 0.5 * force(&film, 3.0, 50.0));
    let cold = Film {
        inlet_heat: false,
        ..film
    };
    assert!(force(&cold, 3.0, 50.0) > force(&film, 3.0, 50.0));
}

/// Outside the range of the fit the parameter and its factor: structure (d) at 12 000 rpm leaves U above 5 mPa·s at the inner
/// raceway.
#[test]
fn range_of_the_fit() {
    let contact = LubricatedContact::inner(&reference::bearing());
    let beyond = |mpa_s: f64, u: f64, q: f64| contact.range_exceeded(&oil(mpa_s), rolling(u, q));
    assert_eq!(beyond(4.5, 14.0, 400.0), None);
    let fast = beyond(20.0, 14.0, 400.0).unwrap();
    assert_eq!(fast.parameter, "U");
    let speed = 2.0 * 0.02 * 14.0 / (contact.modulus_pa * contact.rolling_radius_m);
    close(fast.factor, speed / 1.6e-10, "factor");
    let light = beyond(5.0, 1.0, 1e-4).unwrap();
    assert_eq!(light.parameter, "κW");
    assert!(light.factor < 1.0);
    assert_eq!(beyond(5.0, 14.0, 0.0), None);
    let slow = beyond(5.0, 1e-3, 400.0).unwrap();
    assert_eq!(slow.parameter, "U");
}

/// A ball on the outer raceway after 10 ms from 11 m/s, 5 mPa·s: under 20 N, and under its centrifugal force.
#[test]
fn coasting_ball() {
    let heated = Film::flooded(oil(5.0));
    let isothermal = Film {
        inlet_heat: false,
        ..heated
    };
    let bearing = reference::bearing();
    let speed = |film: &Film, load_n: Option<f64>| {
        let ball = FreeBall::new(&bearing, film);
        let ball = load_n.map_or(ball, |load_n| ball.under(load_n));
        ball.speed_after_m_s(11.0, 10e-3)
    };
    for (film, load_n, expected) in [
        (&isothermal, Some(20.0), 10.638478),
        (&heated, Some(20.0), 10.667045),
        (&isothermal, None, 10.643276),
        (&heated, None, 10.671362),
    ] {
        let end = speed(film, load_n);
        assert!((end - expected).abs() < 2e-6, "{end}, expected {expected}");
    }
}

/// Share of its speed that a ball loses in half a turn, and its lag: 12 000 rpm, flooded.
#[test]
fn half_a_turn() {
    let bearing: Bearing = reference::bearing();
    let speed = reference::conventional().operation.inner_speed_rad_s
        * bearing.dimensions().inner_groove_bottom_radius_m
        / 2.0;
    for (mpa_s, lag_deg) in [(2.0, 0.8265), (5.0, 1.7428), (20.0, 4.8236)] {
        let ball = FreeBall::new(&bearing, &Film::flooded(oil(mpa_s)));
        let arc = ball.over(std::f64::consts::PI, speed);
        let lag = arc.lag_rad.to_degrees();
        assert!((lag - lag_deg).abs() < 1e-4, "{lag}, expected {lag_deg}");
        if mpa_s == 5.0 {
            assert!((ball.brake_n(speed) / ball.load_n(speed) - 0.008519).abs() < 1e-6);
            assert!((arc.speed_deficit - 0.01912).abs() < 1e-5);
        }
    }
    let stiff = FreeBall::new(&bearing, &Film::flooded(oil(9000.0)));
    assert_eq!(stiff.over(std::f64::consts::PI, 1e-3).speed_deficit, 1.0);
}

/// Torque of three balls without a cage in a thrust bearing: what `docs/trust.md` sets beside the measurement.
///
/// T = 6 r F_R and u = ω r/2, r = 18 mm, E′ = 2.3e11 Pa, races of 4.16 mm, flat along rolling. Nothing is tuned.
#[test]
fn torque_of_three_balls() {
    let (race_m, track_m): (f64, f64) = (4.16e-3, 18e-3);
    let material = Material {
        youngs_modulus_pa: 2.3e11,
        poisson_ratio: 0.0,
        ..Material::STEEL
    };
    let oil = Oil::mineral(0.05, 0.0);
    let lines = include_str!("../reference/rolling_torque.csv").lines();
    let rows: Vec<Vec<f64>> = lines
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 8);
    for row in rows {
        let [diameter_mm, load_n, speed_rpm, _, _, transition, rigid] = row[..] else {
            panic!("{row:?}");
        };
        let curvature = 2.0 / (1e-3 * diameter_mm);
        let race = [0.0, -1.0 / race_m];
        let contact = LubricatedContact::between([curvature; 2], race, [&material; 2]);
        let speed_m_s = speed_rpm * std::f64::consts::TAU / 60.0 * track_m / 2.0;
        let force = contact.rolling_force(&oil, rolling(speed_m_s, load_n));
        assert_eq!(force.heat_factor, 1.0);
        for (force_n, expected) in [(force.isothermal_n(), transition), (force.rigid_n, rigid)] {
            let torque = 6.0 * track_m * force_n * 1e5;
            assert!(
                (torque / expected - 1.0).abs() < 5e-4,
                "{torque}, expected {expected}"
            );
        }
    }
}
