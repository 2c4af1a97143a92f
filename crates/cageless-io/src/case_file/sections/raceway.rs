//! `[raceway]`.

use cageless::RacewayShape;

use crate::case_file::declaration::prelude::*;
use crate::case_file::fields::FlankRows;

section! {
    /// `[raceway]`: a discrete raceway.
    struct RacewaySection {
        axial_span_mm => axial_span_m: Option<f64> = Derived, Millimetre; Above(0.0),
            "lC, largest axial distance between the two contact points; that of a profile unless given, which stretches it",
            Shown("5.1", "lC, axial distance of the two contact points in its middle; the paper has 4.9 to 6");
        half_angle_deg => half_angle_rad: Option<f64> = Derived, Degree; Inside(0.0, 90.0),
            "θ, half the angle that the raceway takes up; that of a profile unless given, which stretches it",
            Shown("25.2", "θ, it reaches from -θ to θ; the paper has 12 to 35");
        centre_angle_deg => centre_angle_rad: f64 = default(0.0), Degree,
            "angular position of raceway centre",
            Commented("0.0", "angular position ψ of raceway centre; 0: load direction");
        shape => shape: RacewayShape = default(RacewayShape::Quartic.name()), Plain,
            RacewayShape::DESCRIPTION,
            Commented("\"quartic\"", "path of the paper; \"ellipse\", \"shuttle\", \"steady\",\n\
                \"measured\" or \"spline\" (profile = [[ψ, angle in °], …])");
        profile => profile: Option<FlankRows> = Optional, Plain,
            "flank angle over ψ from the middle of the raceway up to the ends, where it is 0: of shape = \"measured\", fitted to 5 rows or more of one side or both; of shape = \"spline\", met by 5 to 30 rows of one side from the middle, ψ = 0", Absent;
        blend_mm => blend_m: Option<f64> = Derived, Millimetre; AtLeast(0.0),
            "length of the blend into the plain raceway before each end, along the bottom of the groove; 0: none; unless given that of `export` on elastic flanks, 0.5 or a fifth of half the raceway, and 0 on rigid ones; more than 0 only in \"physical\"",
            Shown("0.0", "(paper) blend before each end; elastic flanks have\n\
                that of `export`, at most 0.5, unless given");
        depth_um => depth_m: f64 = default(0.0), Micrometre; AtLeast(0.0),
            "how much deeper a ball in the middle sits than on the plain raceway, running out at the ends: in a deep raceway balls leave the inner ring; only in \"physical\"",
            Commented("0.0", "how much deeper a ball in the middle sits than on the plain raceway");
        edge_radius_mm => edge_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "radius of the rounded edges on which balls roll, of shape = \"slot\", which is computed in space", Absent;
        slot_depth_mm => slot_depth_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "depth of the floor below the bottom of the plain groove, of shape = \"slot\"; for `export` alone, balls do not reach it. At least edge_radius_mm and the depth by which a ball sinks between the edges; edge_radius_mm more unless given", Absent;
        depth_error_um => depth_error_m: f64 = default(0.0), Micrometre,
            "machining error of the depth at the centre, along the normal",
            Commented("0.0", "machining error of the depth at the centre, along normal");
        contact_angle_deg => contact_angle_rad: Option<f64> = Optional, Degree,
            "angle by which the section is turned about the centre of the ball, for a bearing of this contact angle; 0 unless given", Absent;
    }
}
