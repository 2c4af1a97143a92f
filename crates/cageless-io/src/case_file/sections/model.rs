//! `[model]`.

use cageless::Profile;

use crate::case_file::declaration::section;
use crate::case_file::key::Line::Shown;
use crate::case_file::key::Presence::Default;
use crate::case_file::unit::Unit::None as Plain;

section! {
    /// `[model]`: the set of equations.
    ModelDocument {
        formulation formerly profile => profile: Profile = Default(Profile::Physical), Plain,
            "formulation of the equations of motion",
            Shown("\"physical\"", "\"physical\": consistent mechanics;\n\
                \"paper\": the equations as published");
    }
}
