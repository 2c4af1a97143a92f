//! Contacts of a ball on the unrolled grooves, of a run in space.

use cageless::Raceway;
use serde_json::json;

use super::history::figure;
use super::panels::{Panel, Space, shade_sectors};
use crate::figure::Figure;
use crate::groove_contacts::{ContactHistory, GrooveContacts};
use crate::plot::{Axes, GREY, Margin, PALETTE, Plot, Trace, line, line_of};
use crate::run_data::RunData;
use crate::sampling::{Points, wrapped};
use crate::text::fixed;

/// Points of a line of flanks.
const POINTS: i32 = 60;

/// Contact angles over ψ with the ends of the ellipses, the flanks and the shoulders.
pub fn contact_angles(run: &RunData) -> Option<Figure> {
    let ball = GrooveContacts::of(run)?;
    let shoulders_rad = ball.case.bearing.shoulder_angles_rad();
    let shoulders = degrees(&shoulders_rad);
    let space = Space {
        across: 0.0,
        down: 0.07,
    };
    let panels = Panel::grid(2, 1, space);
    let plot = axes(&panels, &shoulders);
    let [outer, inner] = [&panels[0], &panels[1]].map(Panel::axes);
    let mut plot = shade_sectors(plot, &run.sectors, outer.x, outer.y);
    let slots = ball.case.raceways.iter().any(|r| r.slot().is_some());
    let name = if slots { "flanks or edges" } else { "flanks" };
    for (k, flanks) in flanks(&ball, contact_angle_rad).into_iter().enumerate() {
        let line = line_of(name, flanks, "#333333").dash("dash");
        plot = plot.trace(line.in_group("flanks", k == 0).on(outer));
    }
    let rims = flanks(&ball, rim_rad).into_iter().filter(|_| slots);
    for (k, rim) in rims.enumerate() {
        let line = line_of("rim of a slot", rim, "#333333").dash("dot");
        plot = plot.trace(line.in_group("rims", k == 0).on(outer));
    }
    let outer_names = match ball.outer[1].angle_rad.iter().all(|a| a.is_nan()) {
        true => ["outer contact", ""],
        false => [
            "outer contact, towards +z in the raceway",
            "the other in the raceway",
        ],
    };
    let inner = (&ball.inner, "inner contact", PALETTE[2], inner);
    let outer = [0, 1].map(|k| (&ball.outer[k], outer_names[k], PALETTE[k], outer));
    for (contact, name, colour, axes) in outer.into_iter().chain([inner]) {
        if contact.angle_rad.iter().any(|a| a.is_finite()) {
            let centre = line_of(name, unrolled(&ball, &contact.angle_rad), colour);
            plot = plot.trace(ellipses(&ball, contact, colour).on(axes));
            plot = plot.trace(centre.on(axes));
        }
    }
    let finding = finding(&ball, shoulders_rad);
    let of_slots = match slots {
        true => {
            "Those of a slot are its rounded edges, into which the groove runs at the dotted lines. "
        }
        false => "",
    };
    let caption = format!(
        "Contacts of ball {} with both grooves, unrolled, {}: angle of the normal from the radius, positive \
         where an axial load along +z presses. The shades reach from end to end of the contact ellipse (half its length over the \
         radius of the ball); the lines at the edges are the shoulders, the dashed ones the angles of the \
         flanks, on both of which a ball sits that the raceway slows. {of_slots}{finding}",
        ball.ball, ball.part
    );
    Some(figure(
        run,
        "Contact angles",
        &caption,
        plot.finding(&finding),
    ))
}

/// Axes of the outer and the inner raceway over ψ, between the shoulders of each, degrees.
fn axes(panels: &[Panel], shoulders: &[f64]) -> Plot {
    let mut plot = Plot::new(600).legend().margin(Margin::above(48));
    let names = ["outer", "inner"];
    for ((panel, name), shoulder) in panels.iter().zip(names).zip([shoulders[1], shoulders[0]]) {
        let Axes { x, y } = panel.axes();
        let up = format!("Contact angle,<br>{name} raceway (°)");
        let edge = 1.08 * shoulder;
        plot = plot
            .panel(
                panel,
                [
                    panel.at_bottom("ψ, 0 at the bottom (°)"),
                    panel.at_left(&up),
                ],
                [
                    json!({ "range": [-180, 180], "dtick": 45, "showticklabels": panel.lowest }),
                    json!({ "range": [-edge, edge] }),
                ],
            )
            .horizontal(x, y, shoulder, "solid")
            .horizontal(x, y, -shoulder, "solid")
            .text(
                "shoulder",
                (-178.0, shoulder),
                (x, y),
                json!({
                    "xanchor": "left", "yanchor": "top", "font": { "size": 11, "color": "#666" },
                }),
            );
    }
    plot
}

/// On how many flanks the ball rides, and how near its ellipses come to the shoulders.
fn finding(ball: &GrooveContacts, shoulders_rad: [f64; 2]) -> String {
    let inside = ball.in_raceway();
    let both = inside.iter().filter(|both| **both).count();
    let ridden = match inside.len() {
        0 => String::new(),
        all => format!(
            "In the raceway the ball sits on both flanks {} % of the time in which it touches. ",
            fixed(Some(100.0 * both as f64 / all as f64), 0)
        ),
    };
    let bearing = &ball.case.bearing;
    let radius_m = bearing.ball((ball.ball - 1) % bearing.balls()).radius_m;
    let room = |contacts: &[ContactHistory], shoulder: f64| {
        let ends = contacts
            .iter()
            .flat_map(|c| [1.0, -1.0].map(|end| c.ends_rad(end, radius_m)));
        let ends = ends.flatten().filter(|end| end.is_finite());
        let far = ends.map(f64::abs).reduce(f64::max)?;
        Some(degrees(&[shoulder - far])[0])
    };
    let near = |room: Option<f64>, ring: &str| {
        let size = fixed(room.map(f64::abs), 1);
        match room {
            None => format!("does not touch the {ring} ring"),
            Some(room) if room < 0.0 => {
                format!("reaches {size}° beyond the shoulder of the {ring} ring")
            }
            Some(_) => format!("stays {size}° inside the shoulder of the {ring} ring"),
        }
    };
    format!(
        "{ridden}The ellipse {} and {}.",
        near(room(&ball.outer, shoulders_rad[1]), "outer"),
        near(
            room(std::slice::from_ref(&ball.inner), shoulders_rad[0]),
            "inner"
        )
    )
}

/// αc of the flanks, or of a ball on both edges of a slot.
fn contact_angle_rad(raceway: &Raceway, local_rad: f64) -> f64 {
    raceway.contact_angle_rad(local_rad)[0].abs()
}

/// Angle at which the plain groove ends at the edges of a slot; NaN of flanks.
fn rim_rad(raceway: &Raceway, local_rad: f64) -> f64 {
    raceway
        .slot()
        .map_or(f64::NAN, |slot| slot.rim_rad(local_rad))
}

/// αg and this angle to both sides over ψ.
fn flanks(ball: &GrooveContacts, angle_rad: fn(&Raceway, f64) -> f64) -> [Points; 2] {
    let sign = ball.row().contact_sign;
    [1.0, -1.0].map(|side| {
        let (mut psi, mut angle) = (vec![], vec![]);
        for raceway in &ball.case.raceways {
            let (d, theta) = (raceway.dimensions(), raceway.half_angle_rad());
            for k in -POINTS..=POINTS {
                let local = theta * f64::from(k) / f64::from(POINTS);
                let turned = sign * raceway.section_angle_rad() + side * angle_rad(raceway, local);
                psi.push(d.centre_angle_rad + local);
                angle.push(turned);
            }
            psi.push(psi[psi.len() - 1]);
            angle.push(f64::NAN);
        }
        wrapped(&degrees(&psi), &degrees(&angle))
    })
}

fn degrees(angles_rad: &[f64]) -> Vec<f64> {
    angles_rad.iter().map(|a| a.to_degrees()).collect()
}

/// Angles at a contact over ψ, in degrees.
fn unrolled(ball: &GrooveContacts, angles_rad: &[f64]) -> Points {
    wrapped(&degrees(&ball.angle_rad), &degrees(angles_rad))
}

/// The shade between the ends of an ellipse, a polygon for each stretch in contact.
fn ellipses(ball: &GrooveContacts, contact: &ContactHistory, colour: &str) -> Trace {
    let radius_m = ball.case.bearing.ball_radius_m();
    let end = |sign: f64| unrolled(ball, &contact.ends_rad(sign, radius_m));
    let Points { x, y: upper } = end(1.0);
    let lower = end(-1.0).y;
    let (mut xs, mut ys) = (vec![], vec![]);
    let mut from = 0;
    for at in (0..=x.len()).filter(|&k| k == x.len() || upper[k].is_nan()) {
        xs.extend(x[from..at].iter().chain(x[from..at].iter().rev()));
        ys.extend(upper[from..at].iter().chain(lower[from..at].iter().rev()));
        xs.push(f64::NAN);
        ys.push(f64::NAN);
        from = at + 1;
    }
    line("contact ellipse", &xs, &ys, GREY).with(json!({
        "fill": "toself", "fillcolor": format!("{colour}30"), "hoverinfo": "skip", "showlegend": false,
        "line": { "width": 0 },
    }))
}
