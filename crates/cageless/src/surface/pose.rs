//! Where a ring lies in the frame of a measuring machine.

use crate::numerics::bspline::Vec3;

/// Place of a ring: its points are at shift + Rx Ry q, with q in its own frame, Rx and Ry turns about the axes of the
/// machine.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Pose {
    /// Shift of its centre, m.
    pub shift_m: Vec3,
    /// Tilt of its axis about x and y, rad.
    pub tilt_rad: [f64; 2],
}

impl Pose {
    /// Point of the ring where the machine has it.
    #[cfg(test)]
    pub(crate) fn in_machine_m(&self, [x, y, z]: Vec3) -> Vec3 {
        let [(sa, ca), (sb, cb)] = self.tilt_rad.map(f64::sin_cos);
        let [x, z] = [x * cb + z * sb, z * cb - x * sb];
        let [y, z] = [y * ca - z * sa, y * sa + z * ca];
        let [dx, dy, dz] = self.shift_m;
        [x + dx, y + dy, z + dz]
    }

    /// Point of the machine in the frame of the ring.
    pub(crate) fn in_ring_m(&self, [x, y, z]: Vec3) -> Vec3 {
        let [(sa, ca), (sb, cb)] = self.tilt_rad.map(f64::sin_cos);
        let [dx, dy, dz] = self.shift_m;
        let [x, y, z] = [x - dx, y - dy, z - dz];
        let [y, z] = [y * ca + z * sa, z * ca - y * sa];
        [x * cb - z * sb, y, z * cb + x * sb]
    }
}

#[cfg(test)]
mod tests {
    use super::Pose;

    #[test]
    fn points_go_there_and_back() {
        let pose = Pose {
            shift_m: [1e-3, -2e-3, 3e-3],
            tilt_rad: [0.1, -0.2],
        };
        let point = [0.02, -0.03, 0.004];
        let back = pose.in_ring_m(pose.in_machine_m(point));
        for (back, point) in back.iter().zip(point) {
            assert!((back - point).abs() < 1e-17, "{back}");
        }
        // About x, y goes to z; about y, z goes to x.
        let turn = |tilt_rad| Pose {
            shift_m: [0.0; 3],
            tilt_rad,
        };
        assert!(turn([1e-3, 0.0]).in_machine_m([0.0, 1.0, 0.0])[2] > 0.0);
        assert!(turn([0.0, 1e-3]).in_machine_m([0.0, 0.0, 1.0])[0] > 0.0);
    }
}
