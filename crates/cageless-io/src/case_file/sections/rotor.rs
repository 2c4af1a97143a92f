//! `[rotor]`: a rotor that falls onto the inner ring.

use cageless::FrictionLaw;
use cageless::contact::FrictionTable;

use crate::case_file::declaration::section;
use crate::case_file::key::Line::{Absent, Shown};
use crate::case_file::key::Presence::{Optional, Required};
use crate::case_file::key::default;
use crate::case_file::unit::Unit::{Degree, Micrometre, None as Plain, RevolutionPerMinute, Si};

section! {
    /// `[rotor]`: a rotor that loses its magnetic bearing and falls onto the inner ring.
    impl cageless::Rotor {
        mass_kg => mass_kg: f64 = Required, Si("kg"),
            "m, share of the rotor mass that this bearing carries", Shown("20.0", "per bearing");
        polar_inertia_kg_m2 => polar_inertia_kg_m2: f64 = Required, Si("kg m^2"),
            "Ip of the rotor about its axis", Shown("0.02", "about its axis");
        speed_rpm => speed_rad_s: f64 = Required, RevolutionPerMinute,
            "rotor speed at the start of the drop (loss of AMB power)", Shown("30000.0", "counter-clockwise; negative: clockwise");
        radial_clearance_um formerly air_gap_um => radial_clearance_m: f64 = Required, Micrometre,
            "r0, touch-down clearance: radial clearance between journal and bore of the inner ring", Shown("200.0", "radial");
        eccentricity_um => eccentricity_m: f64 = default(0.0), Micrometre,
            "distance of the mass centre from the centre of the journal", Shown("0.0", "of the mass centre");
        eccentricity_phase_deg => eccentricity_phase_rad: f64 = default(0.0), Degree,
            "direction of the mass centre from the journal centre at the start, from +X", Shown("0.0", "");
        friction_coefficient => friction_coefficient: f64 = Required, Plain,
            "μr between journal and bore", Shown("0.15", "between journal and bore");
        friction_law => friction_law: FrictionLaw = default(FrictionLaw::Smooth.name()), Plain,
            "friction between journal and bore against sliding speed", Absent;
        static_friction_coefficient => static_friction_coefficient: Option<f64> = Optional, Plain,
            "μs of the Stribeck law between journal and bore", Absent;
        stribeck_speed_m_s => stribeck_speed_m_s: Option<f64> = Optional, Si("m/s"),
            "sliding speed over which the Stribeck law falls from μs to μr", Absent;
        friction_table => friction_table: Option<FrictionTable> = Optional, Plain,
            "measured μr over the sliding speed, of friction_law = \"table\"; friction_coefficient is its last μr",
            Absent;
        regularisation_speed_m_s formerly slip_scale_m_s => regularisation_speed_m_s: f64 = default(0.05), Si("m/s"),
            "regularisation speed v_s: friction reaches 76 % of μr N at ΔV = v_s; \"coulomb\" does not use it", Shown("0.05", "");
        contact_stiffness_n_mp formerly contact_stiffness => contact_stiffness_n_mp: f64 = Required, Si("N/m^p"),
            "K of journal and bore, F = K δ^p (1 + 1.5 α dδ/dt)", Shown("1.0e9", "K in N/m^p");
        contact_exponent => contact_exponent: f64 = default(1.0), Plain,
            "p, 1 (conformal) to 1.5 (Hertz)", Shown("1.0", "p, 1 (conformal) to 1.5 (Hertz)");
        contact_damping_s_m => contact_damping_s_m: f64 = Required, Si("s/m"),
            "α, damping of the contact of journal and bore", Shown("0.3", "α");
        x_um => x_m: f64 = default(0.0), Micrometre,
            "mass centre at the start of the drop", Shown("0.0", "mass centre at the start of the drop");
        y_um => y_m: f64 = default(0.0), Micrometre,
            "mass centre at the start of the drop", Shown("0.0", "");
        vx_m_s => vx_m_s: f64 = default(0.0), Si("m/s"),
            "velocity of the mass centre at the start of the drop", Shown("0.0", "");
        vy_m_s => vy_m_s: f64 = default(0.0), Si("m/s"),
            "velocity of the mass centre at the start of the drop", Shown("0.0", "");
        drive_torque_n_m => drive_torque_n_m: f64 = default(0.0), Si("N m"),
            "torque on the rotor, drag if against the speed", Shown("0.0", "");
        clearance_limit_um => clearance_limit_m: Option<f64> = Optional, Micrometre,
            "smallest radial clearance of rotor and stator here (magnetic gap, seal); a drop that displaces the journal further from the stator centre fails",
            Absent;
    }
}
