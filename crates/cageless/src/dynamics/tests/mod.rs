//! The rotor and its contact against closed forms.

mod annular_rub;
mod rotor_in_ring;
mod touchdown_exact;
