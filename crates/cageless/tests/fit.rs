//! Fits and temperatures against the formulas of catalogues, the equations of thick cylinders and what
//! must not change.

use crate::common::{dimensions, steel};
use cageless::{BearingDimensions, Fit, Material, Materials, OperatingClearance};

/// 6208 with the mean diameters of its raceways by NTN 2203/E, table 17.4.2:
/// Di = 1.05 (4d + D)/5 = 50.4 mm, De = 0.95 (d + 4D)/5 = 68.4 mm.
fn ntn_6208() -> BearingDimensions {
    BearingDimensions {
        inner_groove_bottom_radius_m: 25.2e-3,
        outer_groove_bottom_radius_m: 34.2e-3,
        ..dimensions()
    }
}

fn in_6208() -> Fit {
    Fit {
        bore_diameter_m: Some(40e-3),
        outside_diameter_m: Some(80e-3),
        ..Fit::default()
    }
}

fn clearance(fit: &Fit) -> OperatingClearance {
    fit.operating_clearance(&ntn_6208(), &steel().into(), 0.0)
        .unwrap()
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found / expected - 1.0).abs() < tolerance,
        "{found} for {expected}"
    );
}

/// NTN 2203/E, tables 8.5 and 17.4.1, one material: what a raceway takes of an interference, d/Di on a solid
/// shaft and De/D in a thick housing, less with a hollow shaft or a thin housing, and the pressure. SKF (PUB
/// 17000, 2018, diagram 2) has factors from 0.7 to 1, HR 1 of Schaeffler about 0.8 inside and 0.7 outside.
#[test]
fn raceways_take_the_share_of_catalogues() {
    let fit = Fit {
        shaft_interference_m: Some(10e-6),
        housing_interference_m: Some(10e-6),
        ..in_6208()
    };
    let thick = clearance(&fit);
    near(thick.shaft_reduction_m, 10e-6 * 40.0 / 50.4, 1e-9);
    near(thick.housing_reduction_m, 10e-6 * 68.4 / 80.0, 1e-9);
    let q = (40.0f64 / 50.4).powi(2);
    let youngs = steel().youngs_modulus_pa;
    near(
        thick.shaft_pressure_pa,
        0.5 * youngs * 2.5e-4 * (1.0 - q),
        1e-9,
    );
    assert_eq!(thick.thermal_change_m, 0.0);

    let thin = clearance(&Fit {
        shaft_bore_diameter_m: 20e-3,
        housing_outside_diameter_m: Some(100e-3),
        ..fit
    });
    let hollow = 0.25;
    let share = 40.0 / 50.4 * (1.0 - hollow) / (1.0 - q * hollow);
    near(share, 0.706, 1e-3);
    near(thin.shaft_reduction_m, 10e-6 * share, 1e-9);
    let (walls, ring) = (0.64, (68.4f64 / 80.0).powi(2));
    let share = 68.4 / 80.0 * (1.0 - walls) / (1.0 - ring * walls);
    near(thin.housing_reduction_m, 10e-6 * share, 1e-9);
    assert!(thin.shaft_pressure_pa < thick.shaft_pressure_pa);
}

/// u = A r + B/r and σr = E/(1 − ν²) ((1 + ν) A − (1 − ν) B/r²) in two cylinders of different materials, for
/// the four conditions at their surfaces: displacement at a radius of the first or second.
fn displacement_m(
    radii: [f64; 3],
    inside: Material,
    outside: Material,
    gap_m: f64,
    speed_rad_s: f64,
    at: f64,
) -> f64 {
    let stress = |m: Material, r: f64| {
        let scale = m.youngs_modulus_pa / (1.0 - m.poisson_ratio.powi(2)) * 1e-9;
        [
            scale * (1.0 + m.poisson_ratio),
            -scale * (1.0 - m.poisson_ratio) / (r * r),
        ]
    };
    // By the rotation alone, with A = B = 0: u = −(1 − ν²) ρω²r³/8E, σr = −(3 + ν) ρω²r²/8.
    let pull = |m: Material| m.density_kg_m3 * speed_rad_s.powi(2) / 8.0;
    let turned = |m: Material, r: f64| {
        -(1.0 - m.poisson_ratio.powi(2)) * pull(m) / m.youngs_modulus_pa * r.powi(3)
    };
    let tension = |m: Material, r: f64| (3.0 + m.poisson_ratio) * pull(m) * r * r * 1e-9;
    let [free_in, free_out] = [stress(inside, radii[0]), stress(outside, radii[2])];
    let [near_in, near_out] = [stress(inside, radii[1]), stress(outside, radii[1])];
    let r = radii[1];
    let gap_m = gap_m + turned(inside, r) - turned(outside, r);
    let jump = tension(inside, r) - tension(outside, r);
    let mut rows = [
        [free_in[0], free_in[1], 0.0, 0.0, tension(inside, radii[0])],
        [near_in[0], near_in[1], -near_out[0], -near_out[1], jump],
        [-r, -1.0 / r, r, 1.0 / r, gap_m],
        [
            0.0,
            0.0,
            free_out[0],
            free_out[1],
            tension(outside, radii[2]),
        ],
    ];
    for k in 0..4 {
        let pivot = (k..4)
            .max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))
            .unwrap();
        rows.swap(k, pivot);
        for other in 0..4 {
            if other != k {
                let factor = rows[other][k] / rows[k][k];
                for column in 0..5 {
                    rows[other][column] -= factor * rows[k][column];
                }
            }
        }
    }
    let x: Vec<f64> = (0..4).map(|k| rows[k][4] / rows[k][k]).collect();
    let (of, material) = if at > r { (2, outside) } else { (0, inside) };
    x[of] * at + x[of + 1] / at + turned(material, at)
}

#[test]
fn different_materials_follow_the_equations_of_thick_cylinders() {
    let of = |youngs_modulus_pa, poisson_ratio| Material {
        youngs_modulus_pa,
        poisson_ratio,
        ..steel()
    };
    let (aluminium, titanium) = (of(70e9, 0.34), of(115e9, 0.32));
    let found = clearance(&Fit {
        shaft_interference_m: Some(12e-6),
        housing_interference_m: Some(20e-6),
        shaft_bore_diameter_m: 16e-3,
        housing_outside_diameter_m: Some(110e-3),
        shaft_youngs_modulus_pa: Some(115e9),
        shaft_poisson_ratio: Some(0.32),
        housing_youngs_modulus_pa: Some(70e9),
        housing_poisson_ratio: Some(0.34),
        ..in_6208()
    });
    let ring = steel();
    let inner = displacement_m([8e-3, 20e-3, 25.2e-3], titanium, ring, 6e-6, 0.0, 25.2e-3);
    let outer = displacement_m(
        [34.2e-3, 40e-3, 55e-3],
        ring,
        aluminium,
        10e-6,
        0.0,
        34.2e-3,
    );
    near(found.shaft_reduction_m, 2.0 * inner, 1e-9);
    near(found.housing_reduction_m, -2.0 * outer, 1e-9);
}

/// A ring on a turning shaft against the equations of both cylinders with body forces: a bored shaft of the ring's
/// material and, at 30,000 rpm, one of another Poisson's ratio. The ring grows more than the shaft, which loosens the fit.
#[test]
fn fast_rings_grow_and_loosen_on_their_shaft() {
    let ring = steel();
    for (bore_m, poisson_ratio, rpm) in [(16e-3, 0.3, 12e3), (16e-3, 0.34, 30e3)] {
        let speed_rad_s = rpm / 60.0 * std::f64::consts::TAU;
        let shaft = Material {
            poisson_ratio,
            ..ring
        };
        let fit = Fit {
            shaft_interference_m: Some(24e-6),
            shaft_bore_diameter_m: bore_m,
            shaft_poisson_ratio: Some(poisson_ratio),
            ..in_6208()
        };
        let at = |speed| {
            fit.operating_clearance(&ntn_6208(), &ring.into(), speed)
                .unwrap()
        };
        let (slow, fast) = (at(0.0), at(speed_rad_s));
        let radii = [bore_m / 2.0, 20e-3, 25.2e-3];
        let raceway = displacement_m(radii, shaft, ring, 12e-6, speed_rad_s, 25.2e-3);
        near(-fast.change_m(), 2.0 * raceway, 1e-9);
        assert!(fast.shaft_interference_m < slow.shaft_interference_m - 1e-6);
        assert!(fast.shaft_pressure_pa < slow.shaft_pressure_pa);
    }
}

/// A loose ring grows as a free one: ρω²D/(16 E) ((1 − ν) D² + (3 + ν) d²) on the diameter, 3.3 µm at 30,000 rpm and
/// 13.4 at 60,000 on the inner raceway of Zhao 2022 and a bore of 30 mm. It lets go of a shaft with 2 µm of
/// interference, and so takes no more.
#[test]
fn a_free_ring_grows_with_the_square_of_the_speed() {
    let loose = Fit {
        bore_diameter_m: Some(30e-3),
        shaft_interference_m: Some(2e-6),
        ..Fit::default()
    };
    for (rpm, expected_um) in [(30e3, 3.35), (60e3, 13.4)] {
        let speed_rad_s = rpm / 60.0 * std::f64::consts::TAU;
        let found = loose
            .operating_clearance(&dimensions(), &steel().into(), speed_rad_s)
            .unwrap();
        near(found.speed_reduction_m, 1e-6 * expected_um, 3e-3);
        assert!(found.shaft_interference_m < 0.0, "{found:?}");
        assert_eq!(found.change_m(), -found.speed_reduction_m);
    }
}

/// An inner ring that is 5 K above the outer one. NTN 2203/E, Eq. (8.5), and NSK E1102f, Eq. (9.6), take
/// α ΔT Do with the outer raceway, SKF 0.012 ΔT dm and HR 1 11·10⁻⁶ ΔT dM: 4.5, 3.6 and 3.3 µm for a 6208.
/// The first is that of balls as warm as the inner ring, without clearance; the mean of both rings gives
/// α ΔT dm, which the others have.
#[test]
fn warm_inner_rings_take_the_clearance_of_catalogues() {
    let d = BearingDimensions {
        ball_radius_m: 5.953e-3,
        inner_groove_bottom_radius_m: 30e-3 - 5.953e-3,
        outer_groove_bottom_radius_m: 30e-3 + 5.953e-3,
        ..dimensions()
    };
    let warm = Fit {
        inner_ring_temperature_c: Some(65.0),
        outer_ring_temperature_c: Some(60.0),
        ..Fit::default()
    };
    let reduction = |fit: &Fit| {
        let found = fit.operating_clearance(&d, &steel().into(), 0.0).unwrap();
        assert!(found.initial_m.abs() < 1e-15);
        -found.operating_m()
    };
    let with_ring = reduction(&Fit {
        ball_temperature_c: Some(65.0),
        ..warm.clone()
    });
    near(with_ring, 12.5e-6 * 5.0 * 2.0 * 35.953e-3, 1e-6);
    near(with_ring, 4.5e-6, 0.01);
    let between = reduction(&warm);
    near(between, 12.5e-6 * 5.0 * 60e-3, 1e-6);
    near(between, 0.012e-3 * 5.0 * 60e-3, 0.05);
}

/// Heated as a whole, a bearing grows in proportion.
#[test]
fn uniform_heat_scales_the_clearance() {
    let d = dimensions();
    let gap = 2.0
        * (d.outer_groove_bottom_radius_m - d.inner_groove_bottom_radius_m - 2.0 * d.ball_radius_m);
    let fit = Fit {
        bore_diameter_m: Some(30e-3),
        outside_diameter_m: Some(62e-3),
        inner_ring_temperature_c: Some(120.0),
        outer_ring_temperature_c: Some(120.0),
        ..Fit::default()
    };
    let found = fit.operating_clearance(&d, &steel().into(), 0.0).unwrap();
    assert!((found.change_m() - gap * 12.5e-4).abs() < 1e-12);
    assert!(found.shaft_interference_m.abs() < 1e-15);
}

/// Parts that expand differently: the interference changes by (α1 − α2) d ΔT (NTN 2203/E, p. A-78), and a
/// gap has no effect.
#[test]
fn warm_aluminium_lets_go() {
    let fit = Fit {
        housing_interference_m: Some(30e-6),
        housing_youngs_modulus_pa: Some(70e9),
        housing_expansion_per_k: Some(23e-6),
        ..in_6208()
    };
    let warm = |celsius| {
        clearance(&Fit {
            inner_ring_temperature_c: Some(celsius),
            outer_ring_temperature_c: Some(celsius),
            ..fit.clone()
        })
    };
    let (cold, hot) = (warm(20.0), warm(60.0));
    let loss = (23e-6 - 12.5e-6) * 80e-3 * 40.0;
    near(hot.housing_interference_m, 30e-6 - loss, 1e-9);
    assert!(hot.housing_interference_m < 0.0 && cold.housing_reduction_m > 10e-6);
    assert_eq!(
        (hot.housing_reduction_m, hot.housing_pressure_pa),
        (0.0, 0.0)
    );
    let loose = clearance(&Fit {
        shaft_interference_m: Some(-5e-6),
        ..in_6208()
    });
    assert_eq!(loose.change_m(), 0.0);
    assert_eq!(loose.operating_m(), loose.initial_m);
}

type Change = fn(&mut Fit);

#[test]
fn fits_that_cannot_be_are_refused() {
    let refused = |fit: Fit, materials: Materials| {
        let error = fit.operating_clearance(&ntn_6208(), &materials, 0.0);
        error.unwrap_err().field
    };
    let ceramic = Materials {
        ball: Material {
            density_kg_m3: 3200.0,
            youngs_modulus_pa: 310e9,
            poisson_ratio: 0.27,
        },
        ..steel().into()
    };
    let set = |change: Change| {
        let mut fit = in_6208();
        change(&mut fit);
        fit
    };
    #[rustfmt::skip]
    let rows: [(&str, Change); 12] = [
        ("bore_diameter_m", |f| f.bore_diameter_m = Some(50.4e-3)),
        ("bore_diameter_m", |f| (f.bore_diameter_m, f.shaft_interference_m) = (None, Some(1e-6))),
        ("outside_diameter_m", |f| f.outside_diameter_m = Some(68.4e-3)),
        ("outside_diameter_m", |f| (f.outside_diameter_m, f.housing_interference_m) = (None, Some(1e-6))),
        ("shaft_bore_diameter_m", |f| f.shaft_bore_diameter_m = 40e-3),
        ("housing_outside_diameter_m", |f| f.housing_outside_diameter_m = Some(80e-3)),
        ("shaft_interference_m", |f| f.shaft_interference_m = Some(f64::NAN)),
        ("shaft_youngs_modulus_pa", |f| f.shaft_youngs_modulus_pa = Some(0.0)),
        ("housing_poisson_ratio", |f| f.housing_poisson_ratio = Some(0.5)),
        ("ball_temperature_c", |f| f.ball_temperature_c = Some(-274.0)),
        ("ring_expansion_per_k", |f| f.ring_expansion_per_k = Some(-1e-6)),
        ("outer_ring_temperature_c", |f| (f.outer_ring_temperature_c, f.ball_temperature_c) = (Some(2000.0), Some(20.0))),
    ];
    for (field, change) in rows {
        assert_eq!(refused(set(change), steel().into()), field);
    }
    let warm = |f: &mut Fit| f.ball_temperature_c = Some(50.0);
    assert_eq!(refused(set(warm), ceramic), "ball_expansion_per_k");
    assert!(
        in_6208()
            .operating_clearance(&ntn_6208(), &ceramic, 0.0)
            .is_ok()
    );
}
