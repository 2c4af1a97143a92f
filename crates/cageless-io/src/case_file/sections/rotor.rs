//! `[rotor]`: a rotor that falls onto the inner ring.

use cageless::contact::FrictionTable;
use cageless::{FrictionModel, Shaft};

use crate::case_file::declaration::prelude::*;
use crate::case_file::sections::friction::section_with_friction;

section_with_friction! {
    /// `[rotor]`: a rotor that loses its magnetic bearing and falls onto the inner ring.
    impl cageless::Rotor {
        mass_kg => mass_kg: f64 = Required, Si("kg"); Above(0.0),
            "m, share of the rotor mass that this bearing carries", Shown("20.0", "per bearing");
        polar_inertia_kg_m2 => polar_inertia_kg_m2: f64 = Required, Si("kg m^2"); Above(0.0),
            "Ip of the rotor about its axis", Shown("0.02", "about its axis");
        speed_rpm => speed_rad_s: f64 = Required, RevolutionPerMinute,
            "rotor speed at the start of the drop (loss of AMB power)", Shown("30000.0", "counter-clockwise; negative: clockwise");
        radial_clearance_um formerly air_gap_um => radial_clearance_m: f64 = Required, Micrometre; Above(0.0),
            "r0, touch-down clearance: radial clearance between journal and bore of the inner ring", Shown("200.0", "radial");
        eccentricity_um => eccentricity_m: f64 = default(0.0), Micrometre,
            "distance of the mass centre from the centre of the journal", Shown("0.0", "of the mass centre");
        eccentricity_phase_deg => eccentricity_phase_rad: f64 = default(0.0), Degree,
            "direction of the mass centre from the journal centre at the start, from +X", Shown("0.0", "");
    }
    friction("μr", " between journal and bore") {
        coefficient: Required, Shown("0.15", "between journal and bore");
        law: Absent;
        table: "";
        regularisation: default(0.05), "", Shown("0.05", "");
    }
    {
        shaft => shaft: Shaft = default(Shaft::Horizontal.name()), Plain,
            "\"horizontal\", or \"vertical\" with weights along -z, in space", Absent;
        axial_clearance_um => axial_clearance_m: Option<f64> = Optional, Micrometre; Above(0.0),
            "axial touch-down clearance of either shoulder of the rotor to the face of the inner ring, with the rotor in the middle; the drop is then in space", Absent;
        shoulder_radius_mm => shoulder_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "mean radius of shoulder and face; halfway between bore and raceway unless given", Absent;
        axial_load_n => axial_load_n: f64 = default(0.0), Si("N"),
            "thrust on the rotor along +z", Absent;
        z_um => z_m: f64 = default(0.0), Micrometre,
            "place of the rotor along the axis at the start of the drop, from the middle between its shoulders", Absent;
        vz_m_s => vz_m_s: f64 = default(0.0), Si("m/s"),
            "velocity of the rotor along +z at the start of the drop", Absent;
        contact_stiffness_n_mp formerly contact_stiffness => contact_stiffness_n_mp: f64 = Required, Si("N/m^p"); Above(0.0),
            "K of journal and bore, F = K δ^p (1 + 1.5 α dδ/dt), and of shoulder and face", Shown("1.0e9", "K in N/m^p");
        contact_exponent => contact_exponent: f64 = default(1.0), Plain,
            "p, 1 (conformal) to 1.5 (Hertz)", Shown("1.0", "p, 1 (conformal) to 1.5 (Hertz)");
        contact_damping_s_m => contact_damping_s_m: f64 = Required, Si("s/m"); AtLeast(0.0),
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
        clearance_limit_um => clearance_limit_m: Option<f64> = Optional, Micrometre; Above(0.0),
            "smallest radial clearance of rotor and stator here (magnetic gap, seal); a drop that displaces the journal further from the stator centre fails",
            Absent;
    }
}
