//! The place of a rotor at a bearing.

use crate::contact::JournalMotion;
use crate::numerics::vector::PlaneVector;
use crate::rotor::Rotor;
use crate::world::body::rotor::RotorMotion;

/// Place of the journal from the coordinates of a rotor at a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RotorSeat {
    /// ε of the mass centre from the axis of the journal, m.
    pub eccentricity: f64,
    /// φ, rad.
    pub phase: f64,
    /// Z of the middle between the shoulders less that of the rotor, m.
    pub z: f64,
}

impl RotorSeat {
    /// The seat of the rotor of a case.
    pub(crate) fn of(rotor: &Rotor) -> Self {
        Self {
            eccentricity: rotor.eccentricity_m,
            phase: rotor.eccentricity_phase_rad,
            z: 0.0,
        }
    }

    /// ε·e^(i(θ+φ)), m.
    #[inline(always)]
    pub(crate) fn offset(&self, angle: f64) -> PlaneVector {
        if self.eccentricity == 0.0 {
            return PlaneVector::default();
        }
        let (sin, cos) = (angle + self.phase).sin_cos();
        PlaneVector {
            x: self.eccentricity * cos,
            y: self.eccentricity * sin,
        }
    }

    /// Motion of the centre of the journal: zr = zg − ε·e^(i(θ+φ)), żr = żg − iΩ·ε·e^(i(θ+φ)).
    #[inline(always)]
    pub(crate) fn journal_motion(
        &self,
        motion: &RotorMotion,
        offset: PlaneVector,
    ) -> JournalMotion {
        let PlaneVector { x: ex, y: ey } = offset;
        JournalMotion {
            x: motion.x - ex,
            y: motion.y - ey,
            vx: motion.vx + motion.speed * ey,
            vy: motion.vy - motion.speed * ex,
            speed: motion.speed,
        }
    }
}
