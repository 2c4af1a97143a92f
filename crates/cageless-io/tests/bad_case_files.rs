//! Every way in which a case file can be wrong ends in one message that names the
//! place, the key, the value and what is allowed.

use crate::common::{edited, line_of, refused};
use cageless_io::case_file::{CaseFile, template};

/// What is replaced in the template, by what, the key that the message must name and
/// fragments that it must have.
type Row = (
    &'static str,
    &'static str,
    &'static str,
    &'static [&'static str],
);

const SPAN: &str = "axial_span_mm = 5.1";
const THETA: &str = "half_angle_deg = 25.2";
const START: &str = "# [start]";

#[rustfmt::skip]
const EDITS: &[Row] = &[
    // Names.
    ("balls = 14", "balls = 14\ncolour = 1", "bearing.colour", &["not a key of [bearing]", "its keys are balls"]),
    ("[material]", "[weather]\nfilm_um = 1\n[material]", "weather", &["not a section", "its sections are bearing"]),
    ("[material]", "[materiel]", "materiel", &["did you mean [material]?"]),
    ("axial_span_mm", "axial_spam_mm", "raceway.axial_spam_mm", &["did you mean axial_span_mm?"]),
    ("axial_span_mm = 5.1", "axial_span_m = 0.0051", "raceway.axial_span_m", &["did you mean axial_span_mm?"]),
    ("gravity_m_s2 = 9.81", "gravity_m_s2 = 9.81\ndensity_kg_m3 = 1.0", "operation.density_kg_m3", &["did you mean material.density_kg_m3?"]),
    ("title =", "titel =", "titel", &["did you mean title?"]),
    // At the head of the file as well as in its section.
    ("gravity_m_s2 = 9.81", "gravity_m_s2 = 9.81\nseed = 3", "operation.seed", &["did you mean solver.seed?"]),
    ("title =", "balls = 14\ntitle =", "balls", &["did you mean bearing.balls?"]),
    ("ball_radius_mm = 4.7625", "# ", "bearing.ball_radius_mm", &["missing in [bearing]", "radius of a ball, in mm"]),
    ("inner_speed_rpm = 12000.0", "# ", "operation.inner_speed_rpm", &["missing in [operation]", "in rpm"]),
    ("balls = 14", "balls = 14\nballs = 15", "bearing.balls", &["not TOML", "duplicate key", "balls = 15"]),
    ("[material]", "[bearing]", "bearing", &["not TOML", "duplicate key"]),
    ("balls = 14", "balls = = 14", "bearing.balls", &["not TOML", "balls = = 14"]),
    ("[material]", "[material", "material", &["not TOML"]),
    // Types.
    ("ball_radius_mm = 4.7625", "ball_radius_mm = \"4.7625\"", "bearing.ball_radius_mm", &["= \"4.7625\" is not possible", "a number in mm, without quotes"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = true", "bearing.ball_radius_mm", &["= true", "a number in mm"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = 1979-05-27", "bearing.ball_radius_mm", &["a number in mm"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = [4.7625]", "bearing.ball_radius_mm", &["= [4.7625]", "a number in mm"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = { value = 4.7625 }", "bearing.ball_radius_mm", &["a number in mm"]),
    ("title = \"Zhao 2022, structure (d)\"", "title = 7", "title", &["= 7 ", "text in quotes"]),
    ("formulation = \"physical\"", "formulation = 1", "model.formulation", &["= 1 ", "\"physical\" or \"paper\""]),
    ("balls = 14", "balls = 13.5", "bearing.balls", &["= 13.5", "must be a whole number, 3 or more"]),
    ("balls = 14", "balls = -14", "bearing.balls", &["= -14", "must be a whole number, 3 or more"]),
    ("balls = 14", "balls = 300", "bearing.balls", &["= 300 "]),
    ("friction_coefficient = 0.007", "friction_coefficient = -0.007", "contact.friction_coefficient", &["= -0.007"]),
    ("regularisation_speed_m_s = 0.02", "regularisation_speed_m_s = 0", "contact.regularisation_speed_m_s", &["= 0 "]),
    ("friction_law = \"smooth\"", "friction_law = \"smooth\"\nregularisation = \"creep\"", "contact.regularisation", &["= \"creep\"", "\"speed\" or \"kalker\""]),
    ("friction_law = \"smooth\"", "friction_law = \"coulomb\"\nregularisation = \"kalker\"", "contact.regularisation", &["= \"kalker\"", "must be \"speed\"", "Coulomb's law has no regularisation speed"]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"\nfriction_table = [[0.0, 0.0], [0.1, 0.007]]\nregularisation = \"kalker\"", "contact.regularisation", &["= \"kalker\"", "has no friction at rest"]),
    ("# seed = 0", "seed = -1", "solver.seed", &["= -1", "a whole number, 0 or more"]),
    ("# seed = 0", "seed = 99999999999999999999", "solver.seed", &["below 2^63"]),
    ("# step_us = \"auto\"", "step_us = \"fast\"", "solver.step_us", &["\"auto\" or a number"]),
    ("# step_us = \"auto\"", "step_us = true", "solver.step_us", &["a number in µs"]),
    ("# step_us = \"auto\"", "step_us = 20.0", "solver.step_us", &["= 20.0", "unstable beyond it"]),
    ("# tolerance = 1.0e-8", "tolerance = 0.0", "solver.tolerance", &["more than 0"]),
    ("[material]", "[[material]]", "material", &["once only"]),
    ("schema = 1", "schema = 1\nhousing = 5", "housing", &["= 5 ", "a section, [housing]"]),
    (START, "[start]\ngaps = \"equal\" #", "start.gaps", &["\"equal\"", "\"random\" or a list of gaps in °"]),
    (START, "[start]\ngaps = [1.8, \"a\"] #", "start.gaps", &["\"a\"", "a number in °"]),
    // Search.
    (START, "[search]\ninner_speed_rpm = [12000, 3000] #", "search.inner_speed_rpm", &["= [12000, 3000]", "a number, or [lowest, highest]"]),
    (START, "[search]\ninner_speed_rpm = [0, 3000] #", "search.inner_speed_rpm", &["more than 0 rpm"]),
    (START, "[search]\nradial_load_n = -1 #", "search.radial_load_n", &["at least 0 N"]),
    (START, "[search]\nradial_load_n = [1, 2, 3] #", "search.radial_load_n", &["a number, or [lowest, highest]"]),
    (START, "[search]\nradial_load_n = \"much\" #", "search.radial_load_n", &["a number in N"]),
    (START, "[search]\naxial_span_mm = [0, 5] #", "search.axial_span_mm", &["more than 0 mm"]),
    (START, "[search]\nhalf_angle_deg = [20, 90] #", "search.half_angle_deg", &["less than 90°"]),
    (START, "[search]\ncentre_angle_deg = 270 #", "search.centre_angle_deg", &["between -180 and 180°"]),
    (START, "[search]\nraceways_max = 5 #", "search.raceways_max", &["from 1 to 4"]),
    (START, "[search]\nraceways_max = 1.5 #", "search.raceways_max", &["a whole number from 1 to 4"]),
    (START, "[search]\ninitial_states = \"two\" #", "search.initial_states", &["a whole number from 1 to 64"]),
    ("axial_span_mm = 5.1", "depth_um = -1.0\naxial_span_mm = 5.1", "raceway.depth_um", &["at least 0 µm"]),
    ("axial_span_mm = 5.1", "depth_um = 300.0\naxial_span_mm = 5.1", "raceway.depth_um", &["between 0 µm and 190.5 µm", "curvature radius exceeds the ball's"]),
    (START, "[search]\nshapes = \"steady\" #", "search.shapes", &["\"own\" or \"all\""]),
    (START, "[search]\nshapes = \"all\"\nedge_radius_mm = 0.3 #", "search.edge_radius_mm", &["0.3", "motion = \"space\""]),
    (START, "[search]\nedge_radius_mm = 0.0 #", "search.edge_radius_mm", &["more than 0 mm"]),
    ("flanks = \"rigid\"", "motion = \"space\"\n[search]\nedge_radius_mm = 0.3 #", "search.edge_radius_mm", &["search.shapes = \"all\""]),
    ("blend_mm = 0.0", "shape = \"slot\"\nedge_radius_mm = 0.3\n[search]\nshapes = \"all\"\nedge_radius_mm = 0.4 #", "search.edge_radius_mm", &["raceway.edge_radius_mm"]),
    (START, "[search]\nruns_max = 0.5 #", "search.runs_max", &["a whole number, 32 or more"]),
    (START, "[search]\ncritical_gap_min_fraction = 1.0 #", "search.critical_gap_min_fraction", &["less than 1"]),
    (START, "[search]\naxial_load_max_n = -1.0 #", "search.axial_load_max_n", &["at least 0 N"]),
    (START, "[search]\ninitial_states = 0 #", "search.initial_states", &["from 1 to 64"]),
    (START, "[search]\ninitial_states = 64\nruns_max = 1000 #", "search.runs_max", &["1024 or more with search.initial_states = 64"]),
    (START, "[search]\nmap_speed_rpm = [0] #", "search.map_speed_rpm", &["more than 0 rpm"]),
    (START, "[search]\nraceway_max = 1 #", "search.raceway_max", &["did you mean raceways_max?"]),
    // Numbers.
    ("ball_radius_mm = 4.7625", "ball_radius_mm = 0", "bearing.ball_radius_mm", &["= 0 ", "more than 0 mm"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = -4.7625", "bearing.ball_radius_mm", &["= -4.7625", "more than 0 mm"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = nan", "bearing.ball_radius_mm", &["= nan", "a finite number of mm"]),
    ("inner_speed_rpm = 12000.0", "inner_speed_rpm = inf", "operation.inner_speed_rpm", &["= inf", "a finite number of rpm"]),
    ("youngs_modulus_gpa = 206.0", "youngs_modulus_gpa = 1e305", "material.youngs_modulus_gpa", &["= 1e305", "a finite number of GPa"]),
    ("youngs_modulus_gpa = 206.0", "youngs_modulus_gpa = -206.0", "material.youngs_modulus_gpa", &["= -206.0", "more than 0 GPa"]),
    ("youngs_modulus_gpa = 206.0", "youngs_modulus_gpa = 5e-324", "material.youngs_modulus_gpa", &["= 5e-324", "at least 0.5 GPa"]),
    ("inner_speed_rpm = 12000.0", "inner_speed_rpm = 0.0", "operation.inner_speed_rpm", &["other than 0"]),
    ("radial_load_n = 1500.0", "radial_load_n = -1500.0", "operation.radial_load_n", &["at least 0 N"]),
    ("radial_load_n = 1500.0", "radial_load_n = 1500.0\nunbalance_g_mm = -3", "operation.unbalance_g_mm", &["= -3", "at least 0 g·mm"]),
    ("radial_load_n = 1500.0", "radial_load_n = 1500.0\nunbalance_g_mm = 1e6", "operation.unbalance_g_mm", &["= 1e6", "elastic contact"]),
    ("inner_ring_mass_kg = 0.2", "inner_ring_mass_kg = 0.0", "bearing.inner_ring_mass_kg", &["more than 0 kg"]),
    ("damping_n_s_m1_5 = 2.0e5", "damping_n_s_m1_5 = -1.0", "contact.damping_n_s_m1_5", &["at least 0 N·s/m^1.5"]),
    ("# inner_stiffness_n_m1_5 = 2.8e10", "inner_stiffness_n_m1_5 = 0", "contact.inner_stiffness_n_m1_5", &["more than 0 N/m^1.5"]),
    ("poisson_ratio = 0.3", "poisson_ratio = 0.5", "material.poisson_ratio", &["= 0.5", "less than 0.5"]),
    ("# ball_restitution = 0.95", "ball_friction_factor = -0.5", "contact.ball_friction_factor", &["= -0.5", "at least 0"]),
    ("# ball_restitution = 0.95", "outer_friction_factor = 150", "contact.outer_friction_factor", &["= 150", "at most 100"]),
    ("# ball_restitution = 0.95", "ball_restitution = 0", "contact.ball_restitution", &["more than 0 and at most 1"]),
    ("# ball_restitution = 0.95", "ball_restitution = 1.5", "contact.ball_restitution", &["= 1.5", "more than 0 and at most 1"]),
    // What is meant in another unit.
    ("youngs_modulus_gpa = 206.0", "youngs_modulus_gpa = 206000", "material.youngs_modulus_gpa", &["= 206000", "at most 1300 GPa", "steel has 206 GPa"]),
    ("youngs_modulus_gpa = 206.0", "youngs_modulus_gpa = 0.206", "material.youngs_modulus_gpa", &["= 0.206", "at least 0.5 GPa"]),
    ("density_kg_m3 = 7850.0", "density_kg_m3 = 7.85", "material.density_kg_m3", &["= 7.85", "at least 500 kg/m³", "steel has 7850"]),
    ("density_kg_m3 = 7850.0", "density_kg_m3 = 7.85e6", "material.density_kg_m3", &["at most 25000 kg/m³"]),
    ("poisson_ratio = 0.3", "poisson_ratio = 30", "material.poisson_ratio", &["= 30", "less than 0.5"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = 0.0047625", "bearing.ball_radius_mm", &["at least 0.05 mm", "diameters"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = 4762.5", "bearing.ball_radius_mm", &["at most 500 mm"]),
    ("inner_groove_curvature_radius_mm = 4.953", "inner_groove_curvature_radius_mm = 4953", "bearing.inner_groove_curvature_radius_mm", &["= 4953", "at most 9.525 mm", "diameter of the ball"]),
    ("outer_ring_width_mm = 16.0", "outer_ring_width_mm = 16000", "bearing.outer_ring_width_mm", &["= 16000", "at most 555.3 mm", "groove"]),
    ("outer_ring_outer_radius_mm = 31.0", "outer_ring_outer_radius_mm = 31000", "bearing.outer_ring_outer_radius_mm", &["= 31000", "at most 277.65 mm", "groove"]),
    ("inner_ring_mass_kg = 0.2", "inner_ring_mass_kg = 2e7", "bearing.inner_ring_mass_kg", &["at most 1000000 kg"]),
    ("gravity_m_s2 = 9.81", "gravity_m_s2 = 9810", "operation.gravity_m_s2", &["= 9810", "at most 1000 m/s²"]),
    ("friction_coefficient = 0.007", "friction_coefficient = 7.0", "contact.friction_coefficient", &["= 7.0", "at most 2", "no percentage"]),
    ("regularisation_speed_m_s = 0.02", "regularisation_speed_m_s = 20", "contact.regularisation_speed_m_s", &["= 20", "at most 10 m/s"]),
    ("# inner_stiffness_n_m1_5 = 2.8e10", "inner_stiffness_n_m1_5 = 8.9e5", "contact.inner_stiffness_n_m1_5", &["at least 1000000 N/m^1.5"]),
    ("# tolerance = 1.0e-8", "tolerance = 1.0", "solver.tolerance", &["at most 0.01"]),
    ("# [housing]", "[housing]\nmass_kg = 1.0\nstiffness_n_m = 100.0\ndamping_n_s_m = 500.0 #", "housing.stiffness_n_m", &["= 100.0", "at least 1000 N/m"]),
    ("[raceway]", "[steady]\ngrade = 7\n[raceway]", "steady.grade", &["= 7", "3, 5, 10, 16"]),
    ("[raceway]", "[steady]\nweight_spacing = -1\n[raceway]", "steady.weight_spacing", &["= -1", "at least 0"]),
    ("[raceway]", "[steady]\nweight_contacts = 0\nweight_spacing = 0\nweight_force = 0\n[raceway]", "steady.weight_contacts", &["= 0", "more than 0 where steady.weight_spacing"]),
    // Geometry.
    ("balls = 14", "balls = 16", "bearing.balls", &["= 16", "at most 15", "do not fit"]),
    ("balls = 14", "balls = 2", "bearing.balls", &["= 2 ", "a whole number, 3 or more"]),
    ("ball_radius_mm = 4.7625", "ball_radius_mm = 4.9", "bearing.ball_radius_mm", &["= 4.9", "at most 4.799", "interference", "4200 MPa"]),
    ("inner_groove_curvature_radius_mm = 4.953", "inner_groove_curvature_radius_mm = 4.7", "bearing.inner_groove_curvature_radius_mm", &["= 4.7", "more than 4.7625 mm", "radius of the ball"]),
    ("outer_shoulder_radius_mm = 26.0", "outer_shoulder_radius_mm = 28.0", "bearing.outer_shoulder_radius_mm", &["= 28.0", "between 23.0025 mm and 27.765 mm"]),
    ("outer_shoulder_radius_mm = 26.0", "outer_shoulder_radius_mm = 20.0", "bearing.outer_shoulder_radius_mm", &["between 23.0025 mm and 27.765 mm"]),
    ("outer_shoulder_radius_mm = 26.0", "outer_shoulder_radius_mm = 26.0\ninner_shoulder_radius_mm = 18.0", "bearing.inner_shoulder_radius_mm", &["= 18.0", "between 18.24 mm and 23.0025 mm"]),
    (SPAN, "axial_span_mm = 8.0", "raceway.axial_span_mm", &["= 8.0", "less than 7.4017", "mm", "Eq. (8)"]),
    (SPAN, "axial_span_mm = 0", "raceway.axial_span_mm", &["more than 0 mm"]),
    (THETA, "half_angle_deg = 60", "raceway.half_angle_deg", &["= 60", "Eq. (9)", "axial_span_mm = 5.1"]),
    (THETA, "half_angle_deg = 90", "raceway.half_angle_deg", &["= 90", "less than 90°"]),
    (THETA, "half_angle_deg = -5", "raceway.half_angle_deg", &["more than 0°"]),
    ("# shape = \"quartic\"", "shape = \"oval\"", "raceway.shape", &["= \"oval\"", "\"quartic\", \"ellipse\", \"shuttle\", \"steady\", \"measured\", \"spline\" or \"slot\""]),
    (SPAN, "", "raceway.axial_span_mm", &["(or profile) is missing in [raceway]", "lC"]),
    ("[raceway]", "[[raceway]]\nhalf_angle_deg = 20\ncentre_angle_deg = 180\n[[raceway]]", "raceway.1.axial_span_mm", &["missing in [raceway]"]),
    ("# shape = \"quartic\"", "shape = \"slot\"", "raceway.edge_radius_mm", &["missing in [raceway]", "above 0 with shape = \"slot\""]),
    ("# shape = \"quartic\"", "edge_radius_mm = 0.3", "raceway.edge_radius_mm", &["left out with any other"]),
    ("# shape = \"quartic\"", "shape = \"slot\"\nedge_radius_mm = 0.0", "raceway.edge_radius_mm", &["more than 0"]),
    ("# shape = \"quartic\"", "slot_depth_mm = 0.5", "raceway.slot_depth_mm", &["left out with any shape but \"slot\""]),
    ("# shape = \"quartic\"", "shape = \"slot\"\nedge_radius_mm = 0.3\nslot_depth_mm = 0.3", "raceway.slot_depth_mm", &["0.3", "at least 0.33", "stays their radius above the floor"]),
    ("# shape = \"quartic\"", "shape = \"measured\"", "raceway.profile", &["missing in [raceway]", "given with shape = \"measured\""]),
    ("# shape = \"quartic\"", "profile = [[0, 20], [5, 19], [10, 16], [15, 12], [20, 7], [25, 0]]", "raceway.profile", &["left out, or shape = \"measured\" or \"spline\""]),
    ("# shape = \"quartic\"", "shape = \"spline\"\nprofile = [[0, 20], [25, 0]]", "raceway.profile", &["5 to 30 rows of ψ and flank angle"]),
    ("# shape = \"quartic\"", "shape = \"measured\"\nprofile = [[0, 20], [25, 0]]", "raceway.profile", &["5 to 20000 rows of ψ and flank angle"]),
    ("# shape = \"quartic\"", "shape = \"measured\"\nprofile = [0, 20, 25, 0, 5]", "raceway.profile", &["rows of [ψ in °, flank angle in °]"]),
    ("# shape = \"quartic\"", "shape = \"measured\"\nprofile = [[0, 20], [5, 19], [10, 16], [15, 12], [20, 7]]", "raceway.profile", &["up to an end of the raceway, where the flank angle is 0"]),
    ("# shape = \"quartic\"", "shape = \"measured\"\nprofile = [[0, 2], [5, 4], [10, 8], [15, 16], [20, 20], [25, 0]]", "raceway.profile", &["fall steadily from the middle to 0 at the ends"]),
    ("# shape = \"quartic\"", "shape = \"measured\"\nprofile = [[0, 200], [5, 19], [10, 16], [15, 12], [20, 7], [25, 0]]", "raceway.profile", &["less than 90°"]),
    ("blend_mm = 0.0", "blend_mm = -0.5", "raceway.blend_mm", &["= -0.5", "at least 0 mm"]),
    ("blend_mm = 0.0", "blend_mm = 0.01", "raceway.blend_mm", &["= 0.01", "between 0.02", "mm", "or 0"]),
    ("blend_mm = 0.0", "blend_mm = 9", "raceway.blend_mm", &["= 9", "a quarter of the length"]),
    ("# centre_angle_deg = 0.0", "centre_angle_deg = 400", "raceway.centre_angle_deg", &["between -360° and 360°"]),
    ("[raceway]", "[[raceway]]\naxial_span_mm = 5.1\nhalf_angle_deg = 20\ncentre_angle_deg = 30\n[[raceway]]", "raceway.2.centre_angle_deg", &["45.2° or more away from the middle of raceway 1"]),
    ("[raceway]", "[[raceway]]\naxial_span_mm = 9\nhalf_angle_deg = 20\ncentre_angle_deg = 180\n[[raceway]]", "raceway.1.axial_span_mm", &["= 9 ", "less than 7.4017"]),
    ("outer_ring_outer_radius_mm = 31.0", "outer_ring_outer_radius_mm = 27.0", "bearing.outer_ring_outer_radius_mm", &["= 27.0", "more than 27.765 mm"]),
    ("outer_ring_width_mm = 16.0", "outer_ring_width_mm = 0", "bearing.outer_ring_width_mm", &["more than 0 mm"]),
    ("balls = 14", "balls = 14\nball_radius_deviation_um = [0, 0, 0, 0, 50, 0, 0, 0, 0, 0, 0, 0, 0, 0]", "bearing.ball_radius_deviation_um", &["47.625 µm", "1 % of the ball radius"]),
    ("balls = 14", "balls = 14\nball_radius_deviation_um = [0, 0]", "bearing.ball_radius_deviation_um", &["a list of 14 numbers"]),
    ("balls = 14", "balls = 14\nball_radius_deviation_um = 0", "bearing.ball_radius_deviation_um", &["a list of numbers"]),
    ("outer_groove_curvature_radius_mm = 4.953", "outer_groove_curvature_radius_mm = 4.81\nball_radius_deviation_um = [40, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]", "bearing.ball_radius_deviation_um", &["less than", "um", "both flanks of the raceway"]),
    ("inner_groove_curvature_radius_mm = 4.953", "inner_groove_curvature_radius_mm = 4.78\nball_radius_deviation_um = [0, 20, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]", "bearing.ball_radius_deviation_um", &["less than 17.5", "curvature radius of the grooves"]),
    // What no contact bears, and no step resolves.
    ("radial_load_n = 1500.0", "radial_load_n = 1e6", "operation.radial_load_n", &["= 1e6 ", "at most 285152 N", "elastic contact"]),
    ("inner_speed_rpm = 12000.0", "inner_speed_rpm = 1e6", "operation.inner_speed_rpm", &["= 1e6 ", "at most 850425 rpm", "elastic contact"]),
    ("damping_n_s_m1_5 = 2.0e5", "damping_n_s_m1_5 = 1e300", "solver.step_us", &["\"auto\"", "3e-301 s", "too many for solver.duration_s"]),
    // Start.
    (START, "[start]\ngaps = [1.8, 1.8] #", "start.gaps", &["= [1.8, 1.8]", "a list of 14 gaps", "these are 2"]),
    (START, "[start]\ngaps = [2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2] #", "start.gaps", &["add up to 25.4251°", "these add up to 28.0000"]),
    (START, "[start]\ngaps = [-1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2.4251] #", "start.gaps", &["0° or more", "gap 1 is -1"]),
    (START, "[start]\ngaps = [inf, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2.4251] #", "start.gaps", &["a finite number of °"]),
    (START, "[start]\nring_y_um = -10 #", "start.ring_y_um", &["= -10", "left out unless start.state = \"rolling\""]),
    (START, "[start]\nring_x_um = 0 #", "start.ring_x_um", &["left out unless"]),
    (START, "[start]\nstate = \"rolling\"\nring_y_um = -2200 #", "start.ring_y_um", &["= -2200", "between -476.25 µm and 476.25 µm"]),
    (START, "[start]\nstate = \"rollin\" #", "start.state", &["\"rollin\"", "\"rolling\" or \"at-rest\""]),
    (START, "[start]\nlead_ball_angle_deg = nan #", "start.lead_ball_angle_deg", &["a finite number of °"]),
    (START, "[start]\nlead_ball_angle_deg = 1e15 #", "start.lead_ball_angle_deg", &["between -360° and 360°"]),
    // Choices.
    ("formulation = \"physical\"", "formulation = \"realistic\"", "model.formulation", &["\"realistic\"", "\"physical\" or \"paper\""]),
    ("friction_law = \"smooth\"", "friction_law = \"viscous\"", "contact.friction_law", &["\"viscous\"", "\"smooth\", \"coulomb\", \"stribeck\" or \"table\""]),
    ("friction_law = \"smooth\"", "friction_law = \"stribeck\"", "contact.static_friction_coefficient", &["missing"]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"", "contact.friction_table", &["missing"]),
    ("friction_law = \"smooth\"", "friction_table = [[0, 0.3], [0.5, 0.007]]", "contact.friction_table", &["left out", "\"table\""]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"\nfriction_table = [[0, 0.3], [0.5, 0.2]]", "contact.friction_coefficient", &["= 0.007", "0.2", "last row"]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"\nfriction_table = [[0.5, 0.3], [0.1, 0.007]]", "contact.friction_table", &["increase from 0 m/s"]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"\nfriction_table = [[0, 30], [0.1, 0.007]]", "contact.friction_table", &["0 to 2", "no percentage"]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"\nfriction_table = [0.3, 0.2]", "contact.friction_table", &["rows of [sliding speed in m/s, μ]"]),
    ("friction_law = \"smooth\"", "friction_law = \"table\"\nfriction_table = [[0, 0.3]]", "contact.friction_table", &["2 to 30 rows"]),
    ("# method = \"verlet\"", "method = \"euler\"", "solver.method", &["\"euler\"", "\"abm4\""]),
    ("schema = 1", "schema = 2", "schema", &["= 2 ", "the only schema"]),
    ("schema = 1", "schema = \"1\"", "schema", &["\"1\""]),
    // Run.
    ("# step_us = \"auto\"", "step_us = 0", "solver.step_us", &["= 0 ", "more than 0 µs"]),
    ("# step_us = \"auto\"", "step_us = -1.0", "solver.step_us", &["= -1.0", "more than 0 µs"]),
    ("duration_s = 0.5", "duration_s = 0.5\n[[limit]]\nresult = \"rotor_force_max_n\"\nvalue = 1.0\nsource = \" \"", "limit.source", &["whose limit it is"]),
    ("duration_s = 0.5", "duration_s = 2e8", "solver.duration_s", &["= 2e8", "1e12 steps are the limit"]),
    ("duration_s = 0.5", "duration_s = 1e-300", "solver.duration_s", &["at least", "nothing moves in less"]),
    ("duration_s = 0.5", "duration_s = -0.5", "solver.duration_s", &["more than 0 s"]),
    ("interval_us = 100.0", "interval_us = 0.0", "output.interval_us", &["more than 0 µs"]),
];

/// An override of the template, the key that the message must name and fragments.
type SetRow = (&'static str, Option<&'static str>, &'static [&'static str]);

#[rustfmt::skip]
const SETS: &[SetRow] = &[
    ("raceway.axial_span_mm", None, &["has no `=`"]),
    ("=5", None, &["is not a key"]),
    ("a.b.c.d=5", Some("a.b.c.d"), &["is not a key"]),
    ("raceway..axial_span_mm=5", None, &["is not a key"]),
    ("raceway.axial_span_mm=", Some("raceway.axial_span_mm"), &["has no value"]),
    ("start.gaps=[1.8, 1.8", Some("start.gaps"), &["not a value of TOML"]),
    ("raceway.axial_span_mm=8", Some("raceway.axial_span_mm"), &["raceway.axial_span_mm = 8 is", "less than 7.4017"]),
    ("raceway.axial_spam_mm=5", Some("raceway.axial_spam_mm"), &["did you mean axial_span_mm?"]),
    ("raceways.axial_span_mm=5", Some("raceways"), &["did you mean [raceway]?"]),
    ("axial_span_mm=5", Some("axial_span_mm"), &["did you mean raceway.axial_span_mm?"]),
    ("raceway.2.axial_span_mm=5", Some("raceway.2.axial_span_mm"), &["only one [raceway]"]),
    ("operation.inner_speed_rpm=12k", Some("operation.inner_speed_rpm"), &["= \"12k\"", "a number in rpm"]),
    ("model.formulation=papers", Some("model.formulation"), &["\"papers\"", "\"physical\" or \"paper\""]),
    ("housing.mass_kg=1.0", Some("housing.stiffness_n_m"), &["missing in [housing]"]),
    ("bearing=1", Some("bearing"), &["a section, [bearing]"]),
    // Two letters of three are no slip, a list without rows is shown as it is, and rings have an order.
    ("foo.bar=1", Some("foo"), &["its sections are bearing"]),
    ("operation.inner_speed_rpm=[12000.0]", Some("operation.inner_speed_rpm"), &["= [12000.0] is not", "rows of [time in s, value]"]),
    ("bearing.inner_groove_bottom_radius_mm=27.8", Some("bearing.inner_groove_bottom_radius_mm"), &["less than 27.765 mm"]),
    ("title.text=1", Some("title.text"), &["`title` is not a section"]),
    ("seed=4", None, &[]),
];

#[test]
fn every_bad_value_is_named_with_its_line_and_what_is_allowed() {
    let mut wrong = String::new();
    for &(from, to, key, fragments) in EDITS {
        let text = edited(from, to);
        let error = refused(&text, &[]);
        let message = error.to_string();
        let named = error.key() == Some(key) && message.starts_with("case.toml:");
        if !named || error.line().is_none() || fragments.iter().any(|f| !message.contains(f)) {
            wrong.push_str(&format!("{to}\n  {message}\n  key {:?}\n", error.key()));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_published_equations_have_no_axial_load() {
    let text = edited("[contact]", "[search]\naxial_load_max_n = 100.0\n[contact]");
    let error = refused(&text, &["model.formulation=paper"]);
    assert_eq!(error.key(), Some("search.axial_load_max_n"));
    let message = error.to_string();
    assert!(
        message.contains("0 in the formulation \"paper\""),
        "{message}"
    );
}

#[test]
fn bad_overrides_quote_themselves() {
    let mut wrong = String::new();
    for &(set, key, fragments) in SETS {
        if fragments.is_empty() {
            let file = CaseFile::parse(&template(false), "case.toml", &[set.to_owned()]);
            assert_eq!(file.map(|f| f.particulars().seed), Ok(4));
            continue;
        }
        let error = refused(&template(false), &[set]);
        let message = error.to_string();
        let quoted = message.starts_with(&format!("--set {set}: ")) && error.line().is_none();
        if !quoted || error.key() != key || fragments.iter().any(|f| !message.contains(f)) {
            wrong.push_str(&format!("{set}\n  {message}\n  key {:?}\n", error.key()));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_line_is_that_of_the_key_and_a_missing_key_that_of_its_section() {
    let text = edited("axial_span_mm = 5.1", "axial_span_mm = 8.0");
    let error = refused(&text, &[]);
    let line = line_of(&text, "axial_span_mm");
    assert_eq!(error.line(), Some(line));
    assert_eq!(
        error.to_string(),
        format!(
            "case.toml:{line}: raceway.axial_span_mm = 8.0 is not possible: it must be less than \
             7.40172 mm (the contact points must stay on the groove, Zhao 2022, Eq. (8))"
        )
    );
    let text = edited("half_angle_deg = 25.2", "# ");
    assert_eq!(
        refused(&text, &[]).line(),
        Some(line_of(&text, "[raceway]"))
    );
    // The same with the line ends and the mark of a Windows editor.
    let text = format!("\u{feff}{}", text.replace('\n', "\r\n"));
    assert_eq!(
        refused(&text, &[]).line(),
        Some(line_of(&text, "[raceway]"))
    );
}

#[test]
fn each_of_several_raceways_has_its_own_lines() {
    let second = "[[raceway]]\naxial_span_mm = 9\nhalf_angle_deg = 20\ncentre_angle_deg = 180\n";
    let text =
        edited("[raceway]", "[[raceway]]").replace("[operation]", &format!("{second}[operation]"));
    let error = refused(&text, &[]);
    assert_eq!(error.key(), Some("raceway.2.axial_span_mm"));
    assert_eq!(error.line(), Some(line_of(&text, "axial_span_mm = 9")));
    let good = ["raceway.2.axial_span_mm=5.2".to_owned()];
    let file = CaseFile::parse(&text, "case.toml", &good).unwrap();
    assert_eq!(file.document().number("raceway.2.axial_span_mm"), Some(5.2));
    let error = refused(&text, &["raceway.axial_span_mm=5.2"]);
    assert!(
        error
            .message()
            .contains("write raceway.1.axial_span_mm for the first"),
        "{error}"
    );
    let error = refused(&text, &["raceway.3.axial_span_mm=5.2"]);
    assert!(
        error.message().contains("there are 2 [[raceway]] sections"),
        "{error}"
    );
}

#[test]
fn missing_keys_are_listed_all_at_once() {
    let error = refused("[bearing]\nballs = 12\n[rotor]\nmass_kg = 20\n", &[]);
    let said = error.message();
    for key in [
        "bearing.ball_radius_mm (or ball_diameter_mm)",
        "bearing.inner_groove_bottom_radius_mm and outer_groove_bottom_radius_mm (or \
         pitch_diameter_mm and radial_internal_clearance_um)",
        "bearing.inner_ring_polar_inertia_kg_m2",
        "bearing.inner_ring_bore_radius_mm",
        "rotor.polar_inertia_kg_m2",
        "rotor.speed_rpm",
        "rotor.radial_clearance_um",
        "rotor.friction_coefficient",
        "rotor.contact_stiffness_n_mp",
        "rotor.contact_damping_s_m",
    ] {
        assert!(said.contains(key), "{key}: {said}");
    }
    assert!(!said.contains("operation."), "{said}");
    let error = refused(
        "[bearing]\nballs = 12\npitch_diameter_mm = 46\n\
        radial_internal_clearance_um = 5\n[operation]\ninner_speed_rpm = 1\nradial_load_n = 1\n",
        &[],
    );
    assert!(
        error
            .message()
            .starts_with("bearing.ball_radius_mm (or ball_diameter_mm) is missing in [bearing]"),
        "{error}"
    );
}

#[test]
fn a_missing_section_is_named_with_the_key_that_it_should_hold() {
    let text = template(false);
    for section in ["bearing", "operation"] {
        let (before, rest) = text.split_once(&format!("\n[{section}]")).unwrap();
        let after = rest
            .split_once("\n[")
            .map_or(String::new(), |(_, after)| format!("\n[{after}"));
        let error = refused(&format!("{before}{after}"), &[]);
        assert!(
            error
                .message()
                .contains(&format!("its section [{section}]")),
            "{error}"
        );
        assert!(
            error
                .key()
                .is_some_and(|k| k.starts_with(&format!("{section}."))),
            "{error}"
        );
    }
    let error = refused("", &[]);
    assert_eq!(error.key(), Some("bearing.balls"));
    assert_eq!(error.line(), None);
}

#[test]
fn a_seed_given_twice_is_refused() {
    let text = edited("schema = 1", "schema = 1\nseed = 3").replace("# seed = 0", "seed = 4");
    let error = refused(&text, &[]);
    assert_eq!(error.key(), Some("solver.seed"));
    assert!(error.message().contains("head of the file"), "{error}");
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("none.toml");
    let error = CaseFile::read(&path, &[]).unwrap_err();
    assert!(
        error.to_string().contains("none.toml: cannot be opened"),
        "{error}"
    );
    assert_eq!((error.key(), error.line()), (None, None));

    let error = CaseFile::read(dir.path(), &[]).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("is a directory, not a case file"),
        "{error}"
    );

    let path = dir.path().join("latin1.toml");
    std::fs::write(&path, b"schema = 1\ntitle = \"\xe9\"\n").unwrap();
    let error = CaseFile::read(&path, &[]).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("latin1.toml: is not UTF-8 text: line 2"),
        "{error}"
    );

    let path = dir.path().join("endless.toml");
    std::fs::File::create(&path)
        .unwrap()
        .set_len(1 << 40)
        .unwrap();
    let error = CaseFile::read(&path, &[]).unwrap_err();
    assert!(
        error.to_string().contains("is larger than 16 MiB"),
        "{error}"
    );

    let path = dir.path().join("prose.toml");
    std::fs::write(&path, "Dear all,\n").unwrap();
    let error = CaseFile::read(&path, &[]).unwrap_err();
    assert!(
        error.to_string().contains("prose.toml:1: is not TOML"),
        "{error}"
    );
    let error = CaseFile::parse("[bearing]\nball_radius_mm = 4,7625\n", "comma", &[]).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("`ball_radius_mm = 4,7625`; a decimal sign is a point"),
        "{error}"
    );
}

#[test]
fn a_document_made_by_hand_is_checked_as_well() {
    let document = || {
        CaseFile::parse(&template(false), "t", &[])
            .unwrap()
            .document()
            .clone()
    };
    let refused = |d| CaseFile::from_document(d, "row 3").unwrap_err();

    let mut d = document();
    d.set("raceway.axial_span_mm", 8.0);
    let error = refused(d);
    assert_eq!(error.key(), Some("raceway.axial_span_mm"));
    assert!(
        error
            .to_string()
            .starts_with("row 3: raceway.axial_span_mm = 8 mm is"),
        "{error}"
    );

    let mut d = document();
    d.set("contact.damping_n_s_m1_5", f64::NAN);
    assert_eq!(refused(d).key(), Some("contact.damping_n_s_m1_5"));
    let mut d = document();
    d.set("schema", 7);
    assert_eq!(refused(d).key(), Some("schema"));
    let mut d = document();
    d.set("solver.seed", -1);
    assert_eq!(refused(d).key(), Some("solver.seed"));
    let mut d = document();
    d.set("start.ring_y_um", 1.0);
    assert_eq!(refused(d).key(), Some("start.ring_y_um"));
}
