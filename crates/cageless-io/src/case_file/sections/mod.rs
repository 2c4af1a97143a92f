//! The sections of the case file, one file each: the declaration of their keys, and their
//! conversion to SI units where it is not key by key.

pub(crate) mod bearing;
pub(crate) mod contact;
pub(crate) mod housing;
pub(crate) mod material;
pub(crate) mod model;
pub(crate) mod operation;
pub(crate) mod output;
pub(crate) mod raceway;
pub(crate) mod search;
pub(crate) mod solver;
pub(crate) mod start;
