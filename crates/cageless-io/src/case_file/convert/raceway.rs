//! Discrete raceways of a case.

use cageless::{Bearing, Raceway, RacewayDimensions};

use crate::case_file::converter::Converter;
use crate::case_file::document::RacewayDocument;
use crate::case_file::error::CaseError;
use crate::case_file::spanned_toml::{join, nth};

impl Converter<'_> {
    /// The discrete raceways.
    pub(in crate::case_file) fn raceways(
        &self,
        bearing: &Bearing,
    ) -> Result<Vec<Raceway>, CaseError> {
        let raceways = &self.document.raceway;
        let one = |(index, raceway): (usize, &RacewayDocument)| {
            let path = nth("raceway", index, raceways.len());
            let si = |name: &str, value| self.si(&join(&path, name), value);
            let dimensions = RacewayDimensions {
                axial_span_m: si("axial_span_mm", raceway.axial_span_mm)?,
                half_angle_rad: si("half_angle_deg", raceway.half_angle_deg)?,
                centre_angle_rad: si("centre_angle_deg", raceway.centre_angle_deg)?,
            };
            let depth_error_m = si("depth_error_um", raceway.depth_error_um)?;
            Raceway::new(dimensions, bearing)
                .and_then(|raceway| raceway.with_depth_error(depth_error_m))
                .map_err(|e| self.refused(&e, Some(index)))
        };
        raceways.iter().enumerate().map(one).collect()
    }
}
