//! STEP: ISO 10303-21 with the schema of AP214, one solid, millimetres.

use cageless::numerics::Vec3;
use cageless::surface::{OuterRing, Patch, PatchError};

use super::brep::{Curve, Face, Solid, Surface};
use super::numbers::{Counts, RingFile};
use super::part21::{Id, Part21, list, real, string};
use crate::results::VERSION;

/// Millimetres of a metre.
const MM: f64 = 1e3;

/// Distance, in mm, below which points of the file are one. Edges between a B-spline and
/// a torus or a cylinder are off one of the two by up to the deviation.
const UNCERTAINTY_MM: f64 = 1e-5;

/// The ring as a solid: B-splines within `tolerance_um` for discrete raceways, exact
/// tori, cylinders and planes for the rest, ASCII. The same ring and date give the same bytes.
///
/// # Errors
/// A [`PatchError`] if the tolerance is out of reach.
pub(super) fn write(
    ring: &OuterRing,
    name: &str,
    tolerance_um: f64,
    date: &str,
) -> Result<RingFile, PatchError> {
    let solid = Solid::new(ring, tolerance_um * 1e-6)?;
    let mut data = Part21::default();
    let shell = shell(&mut data, &solid);
    let name = string(name);
    let solid_id = data.add(format!("MANIFOLD_SOLID_BREP({name},{shell})"));
    product(&mut data, &name, solid_id, solid.deviation_m * MM);
    let patches: Vec<&Patch> = (solid.faces.iter())
        .filter_map(|face| match &face.surface {
            Surface::Spline(patch) => Some(patch),
            _ => None,
        })
        .collect();
    Ok(RingFile {
        bytes: format!(
            "ISO-10303-21;\nHEADER;\n\
             FILE_DESCRIPTION(('Outer ring of a ball bearing'),'2;1');\n\
             FILE_NAME({name},'{date}',(''),(''),'Cageless {VERSION}','Cageless {VERSION}','');\n\
             FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\n\
             ENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
            data.text()
        )
        .into_bytes(),
        deviation_m: solid.deviation_m,
        counts: Counts::Step {
            tolerance_um,
            faces: solid.faces.len(),
            bspline_faces: patches.len(),
            edges: solid.edges.len(),
            control_points: patches
                .iter()
                .map(|p| p.control_m.iter().flatten().count())
                .sum(),
        },
    })
}

fn shell(data: &mut Part21, solid: &Solid) -> Id {
    let vertices: Vec<Id> = (solid.vertices.iter())
        .map(|&position| {
            let point = point(data, position);
            data.add(format!("VERTEX_POINT('',{point})"))
        })
        .collect();
    let edges: Vec<Id> = (solid.edges.iter())
        .map(|edge| {
            let curve = curve(data, &edge.curve, solid.vertices[edge.start]);
            let (start, end) = (vertices[edge.start], vertices[edge.end]);
            data.add(format!("EDGE_CURVE('',{start},{end},{curve},.T.)"))
        })
        .collect();
    let faces: Vec<Id> = (solid.faces.iter())
        .map(|face| advanced_face(data, face, &edges))
        .collect();
    data.add(format!("CLOSED_SHELL('',{})", list(faces)))
}

fn advanced_face(data: &mut Part21, face: &Face, edges: &[Id]) -> Id {
    let bounds: Vec<Id> = (face.loops.iter().enumerate())
        .map(|(k, around)| {
            let uses: Vec<Id> = (around.iter())
                .map(|u| {
                    let (edge, sense) = (edges[u.edge], flag(u.forward));
                    data.add(format!("ORIENTED_EDGE('',*,*,{edge},{sense})"))
                })
                .collect();
            let edge_loop = data.add(format!("EDGE_LOOP('',{})", list(uses)));
            let kind = if k == 0 {
                "FACE_OUTER_BOUND"
            } else {
                "FACE_BOUND"
            };
            data.add(format!("{kind}('',{edge_loop},.T.)"))
        })
        .collect();
    let surface = surface(data, &face.surface);
    let (bounds, sense) = (list(bounds), flag(face.outward));
    data.add(format!("ADVANCED_FACE('',{bounds},{surface},{sense})"))
}

fn curve(data: &mut Part21, curve: &Curve, start: Vec3) -> Id {
    match curve {
        Curve::Line(along) => {
            let (origin, along) = (point(data, start), direction(data, *along));
            let vector = data.add(format!("VECTOR('',{along},1.)"));
            data.add(format!("LINE('',{origin},{vector})"))
        }
        Curve::Circle {
            centre,
            axis,
            reference,
            radius_m,
        } => {
            let place = placement(data, *centre, *axis, *reference);
            data.add(format!("CIRCLE('',{place},{})", real(radius_m * MM)))
        }
        Curve::Spline { sites, control } => {
            let points: Vec<Id> = control.iter().map(|&p| point(data, p)).collect();
            data.add(format!(
                "B_SPLINE_CURVE_WITH_KNOTS('',3,{},.UNSPECIFIED.,.F.,.F.,{},{},.UNSPECIFIED.)",
                list(points),
                multiplicities(sites),
                list(sites.iter().map(|&s| real(s))),
            ))
        }
    }
}

fn surface(data: &mut Part21, surface: &Surface) -> Id {
    const UP: Vec3 = [0.0, 0.0, 1.0];
    match surface {
        Surface::Plane(z) => {
            let place = placement(data, [0.0, 0.0, *z], UP, [1.0, 0.0, 0.0]);
            data.add(format!("PLANE('',{place})"))
        }
        Surface::Cylinder {
            radius_m,
            reference,
        } => {
            let place = placement(data, [0.0; 3], UP, *reference);
            let radius = real(radius_m * MM);
            data.add(format!("CYLINDRICAL_SURFACE('',{place},{radius})"))
        }
        Surface::Cone {
            height_m,
            radius_m,
            way,
            half_angle_rad,
            reference,
        } => {
            let axis = [0.0, 0.0, *way];
            let place = placement(data, [0.0, 0.0, *height_m], axis, *reference);
            let (radius, half) = (real(radius_m * MM), real(*half_angle_rad));
            data.add(format!("CONICAL_SURFACE('',{place},{radius},{half})"))
        }
        Surface::Torus {
            height_m,
            major_m,
            minor_m,
            reference,
        } => {
            let place = placement(data, [0.0, 0.0, *height_m], UP, *reference);
            let (major, minor) = (real(major_m * MM), real(minor_m * MM));
            data.add(format!("TOROIDAL_SURFACE('',{place},{major},{minor})"))
        }
        Surface::Spline(patch) => {
            let rows: Vec<String> = (patch.control_m.iter())
                .map(|row| list(row.iter().map(|&p| point(data, p)).collect::<Vec<_>>()))
                .collect();
            data.add(format!(
                "B_SPLINE_SURFACE_WITH_KNOTS('',3,3,{},.UNSPECIFIED.,.F.,.F.,.F.,{},{},{},{},\
                 .UNSPECIFIED.)",
                list(rows),
                multiplicities(&patch.along_rad),
                multiplicities(&patch.across),
                list(patch.along_rad.iter().map(|&s| real(s))),
                list(patch.across.iter().map(|&s| real(s))),
            ))
        }
    }
}

/// `(4,1,…,1,4)`.
fn multiplicities(sites: &[f64]) -> String {
    let last = sites.len() - 1;
    list((0..=last).map(|k| if k == 0 || k == last { 4 } else { 1 }))
}

fn flag(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}

fn point(data: &mut Part21, position_m: Vec3) -> Id {
    let coordinates = list(position_m.map(|c| real(c * MM)));
    data.add(format!("CARTESIAN_POINT('',{coordinates})"))
}

fn direction(data: &mut Part21, unit: Vec3) -> Id {
    data.add(format!("DIRECTION('',{})", list(unit.map(real))))
}

fn placement(data: &mut Part21, origin: Vec3, axis: Vec3, reference: Vec3) -> Id {
    let origin = point(data, origin);
    let (axis, reference) = (direction(data, axis), direction(data, reference));
    data.add(format!(
        "AXIS2_PLACEMENT_3D('',{origin},{axis},{reference})"
    ))
}

/// Entities that AP214 requires around a solid: units, product, and the links between them.
fn product(data: &mut Part21, name: &str, solid: Id, deviation_mm: f64) {
    let length = data.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    let angle = data.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    let solid_angle = data.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    let uncertainty = data.add(format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),{length},'distance_accuracy_value','')",
        real(UNCERTAINTY_MM.max(deviation_mm))
    ));
    let context = data.add(format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)\
         GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))\
         GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))\
         REPRESENTATION_CONTEXT('','3D'))"
    ));
    let origin = placement(data, [0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let shape = data.add(format!(
        "ADVANCED_BREP_SHAPE_REPRESENTATION({name},({origin},{solid}),{context})"
    ));
    let application = data.add("APPLICATION_CONTEXT('automotive design')");
    data.add(format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,\
         {application})"
    ));
    let product_context = data.add(format!("PRODUCT_CONTEXT('',{application},'mechanical')"));
    let product = data.add(format!("PRODUCT({name},{name},'',({product_context}))"));
    data.add(format!(
        "PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))"
    ));
    let formation = data.add(format!("PRODUCT_DEFINITION_FORMATION('','',{product})"));
    let definition_context = data.add(format!(
        "PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')"
    ));
    let definition = data.add(format!(
        "PRODUCT_DEFINITION('design','',{formation},{definition_context})"
    ));
    let definition_shape = data.add(format!("PRODUCT_DEFINITION_SHAPE('','',{definition})"));
    data.add(format!(
        "SHAPE_DEFINITION_REPRESENTATION({definition_shape},{shape})"
    ));
}
