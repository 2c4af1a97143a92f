//! The case file of a designation.

use cageless::Assembly;

use crate::own_bearing::BallSet;

use super::{BallSource, BoundaryDimensions, InternalGeometry};

/// How far load ratings of balls by the formula are off those of catalogues, which rate bearings with a cage.
fn formula_ratings(balls: usize, caged_balls: usize) -> String {
    match balls == caged_balls {
        true => "load ratings may be up to 17 % off those of catalogues".to_owned(),
        false => format!(
            "with the {caged_balls} that a cage leaves room for, load ratings may be up to 17 % off those of \
             catalogues; this bearing has {balls}, and ratings of its own"
        ),
    }
}

/// Sections of two rows back to back, each of a width, mm.
fn pair_of_rows(width_mm: f64) -> String {
    format!(
        "\
[[row]]
axial_position_mm = {:<26} # -B/2
contact_sign = 1                               # its balls press the outer ring towards +z
preload_um = 5                                 # (assumed) by displacement of the outer ring

[[row]]
axial_position_mm = {:<26} # B/2
contact_sign = -1
preload_um = 5

",
        -0.5 * width_mm,
        0.5 * width_mm
    )
}

/// Assembly of more balls than enter between eccentric rings.
fn filling_slot() -> String {
    format!(
        "assembly = {:<35} # more balls than enter between eccentric rings;\n{:47}# \
         \"without-slot\" for a fractured or split ring\n",
        format!("\"{}\"", Assembly::FillingSlot.name()),
        ""
    )
}

impl InternalGeometry {
    /// Source of the number of balls, in a comment.
    fn number_comment(&self, full_complement: bool) -> String {
        let as_caged = self.balls == self.caged_balls;
        match self.source {
            _ if full_complement => {
                "(assumed) full complement: as many as the pitch circle holds".into()
            }
            BallSource::Maker if as_caged => "(derived) as NSK, from its Cr, C0r and f0".to_owned(),
            BallSource::AngularContact if as_caged => {
                "(assumed) as many as a cage leaves room for: 87 % of the pitch circle".to_owned()
            }
            BallSource::Formula if as_caged => {
                "(assumed) as many as enter between eccentric rings (195° filled)".into()
            }
            _ => format!(
                "(assumed) least that holds the inner ring without a cage; with one {}",
                self.caged_balls
            ),
        }
    }

    /// Source of the diameter of the balls, in a comment.
    fn diameter_comment(&self) -> &'static str {
        match self.source {
            BallSource::Maker => "(derived) Dw as NSK, from its Cr, C0r and f0",
            BallSource::Formula => "(assumed) Dw, 0.29 (D - d) in steps of 1/64 inch",
            BallSource::AngularContact => "(assumed) Dw of the deep groove bearing of this size",
        }
    }

    /// Source of the balls at the head of a case file.
    fn head(&self, full_complement: bool) -> String {
        match self.source {
            BallSource::Maker if full_complement => {
                "# No standard fixes the balls. Their diameter, marked (derived), reproduces NSK's ratings of the bearing
# with a cage (catalogue E1102f, by ISO 281 and ISO 76); other makers differ."
                    .to_owned()
            }
            BallSource::Maker if self.balls == self.caged_balls => {
                "# No standard fixes the balls. Balls marked (derived) reproduce NSK's ratings (catalogue E1102f, by
# ISO 281 and ISO 76); other makers differ."
                    .to_owned()
            }
            BallSource::Maker => format!(
                "# No standard fixes the balls. These are {}
# (catalogue E1102f). Other makers differ.",
                self.maker_ratings()
            ),
            BallSource::AngularContact => {
                "# No standard fixes the balls. Boundary dimensions and contact angle are those of the designation; two
# bearings back to back, as a single one bears no radial load without an axial one: without both [[row]]
# it needs operation.axial_load_n."
                    .to_owned()
            }
            BallSource::Formula => format!(
                "# No standard fixes the balls, and the table of bearings has none for this size. Those of a
# formula: {}.",
                formula_ratings(self.balls, self.caged_balls)
            ),
        }
    }

    /// How far the load ratings of another number of the maker's balls are off its catalogue: Cr ∝ bm Z^(2/3), C0r ∝ Z.
    fn maker_ratings(&self) -> String {
        let [ball_m, pitch_m] =
            [self.ball_diameter_mm, self.pitch_diameter_mm].map(|mm| 0.5e-3 * mm);
        let assembly = Assembly::of(self.balls, ball_m, pitch_m);
        let ratio = self.balls as f64 / self.caged_balls as f64;
        let bm = assembly.rating_factor() / Assembly::WithoutSlot.rating_factor();
        let off = |factor: f64| match 100.0 * (factor - 1.0) {
            less if less < 0.0 => format!("{:.1} % below", -less),
            more => format!("{more:.1} % above"),
        };
        let slot = match assembly {
            Assembly::FillingSlot => ", through a filling slot",
            Assembly::WithoutSlot => "",
        };
        format!(
            "{} balls of NSK's diameter{slot} in place of the {} with a cage: Cr is {}, C0r {} NSK's",
            self.balls,
            self.caged_balls,
            off(bm * ratio.powf(2.0 / 3.0)),
            off(ratio)
        )
    }
}

impl BoundaryDimensions {
    /// Source of the balls in a sentence.
    pub fn source_of_balls(&self, full_complement: bool) -> String {
        let name = &self.designation;
        let geometry = self.internal_geometry(full_complement);
        let InternalGeometry {
            source,
            balls,
            caged_balls,
            ..
        } = geometry;
        match source {
            BallSource::Maker if full_complement => format!(
                "balls of {name}: {balls} fill the pitch circle; their diameter is NSK's, from its load ratings with \
                 {caged_balls} in a cage; other makers differ"
            ),
            BallSource::Maker if balls == caged_balls => format!(
                "balls of {name} as NSK: number and diameter follow from the load ratings of its \
                 catalogue; other makers differ"
            ),
            BallSource::Maker => format!(
                "{name} has {}; fewer would let the inner ring fall out",
                geometry.maker_ratings()
            ),
            BallSource::AngularContact if full_complement => format!(
                "balls of {name}: {balls} fill the pitch circle; their diameter is that of the deep groove bearing of \
                 this size"
            ),
            BallSource::AngularContact => format!(
                "balls of {name}: diameter as in the deep groove bearing of this size, as many as a cage leaves \
                 room for; catalogues have one or two more or less"
            ),
            BallSource::Formula => format!(
                "balls of {name} by a formula, as the table of bearings has none for it: {}",
                formula_ratings(balls, caged_balls)
            ),
        }
    }

    /// Contact angle of an angular contact bearing.
    fn contact_angle_line(&self) -> String {
        match self.contact_angle_deg > 0.0 {
            true => format!(
                "contact_angle_deg = {:<26} # that of the suffix, without load\n",
                self.contact_angle_deg
            ),
            false => String::new(),
        }
    }

    /// Source of the clearance, in a comment.
    fn clearance_comment(&self) -> String {
        match self.contact_angle_deg > 0.0 {
            true => "0: the contact angle is that without load".to_owned(),
            false => format!(
                "(assumed) Gr, middle of group {} of ISO 5753-1",
                self.suffixes.clearance_group.name()
            ),
        }
    }

    /// Suffixes that change nothing, each in a comment.
    fn suffixes_without_effect(&self) -> String {
        let suffixes = self.suffixes.without_effect.iter();
        suffixes
            .map(|(suffix, meaning)| format!("# {suffix} ({meaning}) has no effect here.\n"))
            .collect()
    }

    /// Rows of an angular contact bearing, and what follows `[bearing]` in every case file.
    fn sections(&self, geometry: &InternalGeometry) -> String {
        let rows = match self.contact_angle_deg > 0.0 {
            true => pair_of_rows(self.width_mm),
            false => String::new(),
        };
        let ball_set = BallSet {
            balls: geometry.balls as u64,
            ball_diameter_mm: geometry.ball_diameter_mm,
            pitch_diameter_mm: geometry.pitch_diameter_mm,
        };
        ball_set.sections(self.suffixes.hybrid, &rows)
    }

    /// A case file with the source of every number in a comment.
    pub fn case_file(&self, full_complement: bool) -> String {
        let geometry = self.internal_geometry(full_complement);
        let InternalGeometry {
            ball_diameter_mm: ball,
            pitch_diameter_mm: pitch,
            balls,
            clearance_um,
            ..
        } = geometry;
        let (name, d, big, width) = (
            &self.designation,
            self.bore_mm,
            self.outside_mm,
            self.width_mm,
        );
        let number = geometry.number_comment(full_complement);
        let diameter = geometry.diameter_comment();
        let head = geometry.head(full_complement);
        let kind = match full_complement {
            true => "full complement",
            false => "cageless",
        };
        let angular = self.contact_angle_deg > 0.0;
        let pair = if angular { " back to back" } else { "" };
        let contact_angle = self.contact_angle_line();
        let clearance = self.clearance_comment();
        let without_effect = self.suffixes_without_effect();
        let assembly = match full_complement && !angular {
            true => filling_slot(),
            false => String::new(),
        };
        let sections = self.sections(&geometry);
        format!(
            "\
# {name}, {kind}: boundary dimensions d {d} mm, D {big} mm, B {width} mm (ISO 15).
{head}
{without_effect}\
# Measure yours or ask its maker, and replace what is marked (derived) or (assumed). Everything that
# is left out takes a default: `cageless check` lists them with their values.
schema = 1
title = \"{name}{pair}, {kind}\"

[bearing]
balls = {balls:<38} # {number}
ball_diameter_mm = {ball:<27} # {diameter}
pitch_diameter_mm = {pitch:<26} # (assumed) Dpw = (D + d)/2
radial_internal_clearance_um = {clearance_um:<15} # {clearance}
{contact_angle}\
inner_conformity = 0.52                        # (assumed) groove radius over Dw
outer_conformity = 0.52                        # (assumed)
{assembly}\
inner_ring_bore_radius_mm = {bore:<18} # d/2
outer_ring_outer_radius_mm = {outer:<17} # D/2, for the export to CAD
outer_ring_width_mm = {width:<24} # B

{sections}",
            bore = d / 2.0,
            outer = big / 2.0,
        )
    }
}
