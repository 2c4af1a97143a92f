//! `[contact]`.

use cageless::STRIPS_MAX;
use cageless::contact::FrictionTable;
use cageless::{FrictionModel, Regularisation};

use crate::case_file::declaration::prelude::*;
use crate::case_file::sections::friction::{LAWS, section_with_friction};

/// Unit of K in F = K·δ^1.5.
const HERTZ: crate::case_file::unit::Unit = Si("N/m^1.5");

section_with_friction! {
    /// `[contact]`: friction, damping and stiffness. The friction coefficient is that of
    /// Zhao 2022, Table 1.
    impl cageless::Contact {}
    friction("μ", "") {
        coefficient: default(0.007), Shown("0.007", "μ (paper)");
        law: LAWS;
        table: ", also if it is left out";
        regularisation: Derived, "; a thousandth of the speed of rolling balls unless given, at most 0.02, and 0.02 in a drop",
            Shown("0.02", "regularisation speed v_s: friction reaches 76 % of μ N\n\
            at ΔV = v_s; a thousandth of the speed of rolling balls\n\
            unless given, at most 0.02; \"coulomb\" does not use it");
    }
    {
        regularisation => regularisation: Regularisation = default(Regularisation::Speed.name()), Plain,
            "where v_s at the raceways comes from; \"speed\": regularisation_speed_m_s; \"kalker\": creep of each rolling \
            contact after Kalker, μ N V/(G ab C11), regularisation_speed_m_s between balls; not with \"coulomb\" or in \"paper\"",
            Commented("\"speed\"", "\"kalker\": v_s at the raceways from load and speed");
        outer_friction_factor => outer_friction_factor: f64 = default(1.0), Plain; AtLeast(0.0),
            "friction at the outer raceway over that of the law, which holds at the inner raceway",
            Commented("1.0", "outer raceway over μ");
        ball_friction_factor => ball_friction_factor: f64 = default(1.0), Plain; AtLeast(0.0),
            "friction between balls over that of the law",
            Commented("1.0", "ball against ball over μ");
        friction_strips => friction_strips: usize = default(3), Plain; Within(1.0, STRIPS_MAX as f64),
            "strips across the groove over which friction acts in space: with 1 there is no differential sliding, and the lag \
            may be 8 % off; with 3 it is within 3.5 % of that of many",
            Commented("3", "strips across the groove, of motion in space");
        damping_n_s_m1_5 formerly damping => damping_n_s_m1_5: f64 = default(2.0e5), Si("N s/m^1.5"); AtLeast(0.0),
            "contact damping c of ball-raceway contacts, F = K δ^1.5 + c √δ dδ/dt",
            Shown("2.0e5", "contact damping c of ball-raceway contacts, N s/m^1.5,\n\
                F = K δ^1.5 + c √δ dδ/dt, usually 1e5 to 5e5");
        ball_restitution => ball_restitution: f64 = default(0.95), Plain,
            "coefficient of restitution between balls",
            Commented("0.95", "ball against ball, above 0 to 1 (no loss)");
        inner_stiffness_n_m1_5 formerly inner_stiffness => inner_stiffness_n_m1_5: Option<f64> = Derived, HERTZ; Above(0.0),
            "K at the inner raceway, in place of Hertz",
            Commented("2.8e10", "K in N/m^1.5, in place of what Hertz gives");
        outer_stiffness_n_m1_5 formerly outer_stiffness => outer_stiffness_n_m1_5: Option<f64> = Derived, HERTZ; Above(0.0),
            "K at the outer raceway, in place of Hertz", Commented("2.9e10", "");
        ball_stiffness_n_m1_5 formerly ball_stiffness => ball_stiffness_n_m1_5: Option<f64> = Derived, HERTZ; Above(0.0),
            "K between balls, in place of Hertz", Commented("7.4e9", "");
    }
}
