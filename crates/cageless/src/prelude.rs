//! The names of a first program: bearing, case, simulation, and what extends them.
//!
//! ```
//! use cageless::prelude::*;
//!
//! let mut simulation = Simulation::new(&reference::Structure::D.case())?;
//! simulation.advance_to(1e-3)?;
//! assert!(simulation.view().ring().y_m < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::bearing::{Bearing, BearingDimensions, InnerRingBore};
pub use crate::case::{Case, Gaps, Motion};
pub use crate::case_builder::CaseBuilder;
pub use crate::collision::{Collision, CollisionDetector};
pub use crate::contact::{FrictionLaw, FrictionTable};
pub use crate::equilibrium::EquilibriumError;
pub use crate::error::InputError;
pub use crate::flank_model::FlankModel;
pub use crate::formulation::Formulation;
pub use crate::integrator::{
    IntegrationMethod, Method, SecondOrderBlock, StepState, System, UnresolvedStep,
};
pub use crate::material::{Material, Materials};
pub use crate::raceway::{Raceway, RacewayDimensions, RacewayForm, RacewayShape};
pub use crate::recorder::Recorder;
pub use crate::rotor::{Rotor, Shaft, Support};
pub use crate::simulation::{
    BallView, Control, Ending, Observer, ObserverError, RingView, RotorDrop, RotorView, RunContext,
    RunOutcome, Simulation, StepView, Stop, each_step,
};
pub use crate::snapshot::Snapshot;
pub use crate::summary::SummaryRecorder;
pub use crate::time_table::TimeTable;
pub use crate::{equilibrium, reference};
