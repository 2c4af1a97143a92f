//! Second-order Taylor numbers: a value with its exact gradient and Hessian.
//!
//! A formula that is written once in them gives its derivatives as well, to rounding.

use std::ops::{Add, Mul, Sub};

/// A function of `N` variables at a point, to second order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Taylor<const N: usize> {
    /// Value.
    pub value: f64,
    /// First derivatives.
    pub gradient: [f64; N],
    /// Second derivatives.
    pub hessian: [[f64; N]; N],
}

impl<const N: usize> Taylor<N> {
    /// A constant.
    pub(crate) fn constant(value: f64) -> Self {
        Self {
            value,
            gradient: [0.0; N],
            hessian: [[0.0; N]; N],
        }
    }

    /// The variables at these values.
    pub(crate) fn variables(values: [f64; N]) -> [Self; N] {
        std::array::from_fn(|k| {
            let mut variable = Self::constant(values[k]);
            variable.gradient[k] = 1.0;
            variable
        })
    }

    /// f of this number, by f and its first two derivatives at the value: chain rule.
    pub(crate) fn map(self, [value, first, second]: [f64; 3]) -> Self {
        let mut out = Self::constant(value);
        for i in 0..N {
            out.gradient[i] = first * self.gradient[i];
            for j in 0..N {
                out.hessian[i][j] =
                    first * self.hessian[i][j] + second * (self.gradient[i] * self.gradient[j]);
            }
        }
        out
    }

    /// Square root of a number above 0.
    pub(crate) fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.map([root, 0.5 / root, -0.25 / (root * self.value)])
    }

    /// √(x² + y²), not 0.
    pub(crate) fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }

    /// Natural logarithm of a number above 0.
    pub(crate) fn ln(self) -> Self {
        let x = self.value;
        self.map([x.ln(), 1.0 / x, -1.0 / (x * x)])
    }

    /// ln(1 + x), above −1.
    pub(crate) fn ln_1p(self) -> Self {
        let slope = 1.0 / (1.0 + self.value);
        self.map([self.value.ln_1p(), slope, -slope * slope])
    }

    /// eˣ.
    pub(crate) fn exp(self) -> Self {
        self.map([self.value.exp(); 3])
    }

    /// 1/x.
    pub(crate) fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        let square = inverse * inverse;
        self.map([inverse, -square, 2.0 * inverse * square])
    }

    /// sin x and cos x.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.map([sin, cos, -sin]), self.map([cos, -sin, -cos]))
    }
}

impl<const N: usize> Add for Taylor<N> {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self.value += other.value;
        for i in 0..N {
            self.gradient[i] += other.gradient[i];
            for j in 0..N {
                self.hessian[i][j] += other.hessian[i][j];
            }
        }
        self
    }
}

impl<const N: usize> Add<f64> for Taylor<N> {
    type Output = Self;

    fn add(mut self, other: f64) -> Self {
        self.value += other;
        self
    }
}

impl<const N: usize> Mul<f64> for Taylor<N> {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self.map([self.value * factor, factor, 0.0])
    }
}

impl<const N: usize> Sub for Taylor<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl<const N: usize> Mul for Taylor<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut out = Self::constant(self.value * other.value);
        for i in 0..N {
            out.gradient[i] = self.gradient[i] * other.value + self.value * other.gradient[i];
            for j in 0..N {
                out.hessian[i][j] = self.hessian[i][j] * other.value
                    + (self.gradient[i] * other.gradient[j] + self.gradient[j] * other.gradient[i])
                    + self.value * other.hessian[i][j];
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::Taylor;

    /// Every operation against differences of the one below it.
    #[test]
    fn derivatives_are_those_of_the_formula() {
        let f = |[x, y]: [Taylor<2>; 2]| {
            let (sin, cos) = (x * 0.7).sin_cos();
            (x.hypot(y) * sin + cos * y.ln()).exp().ln_1p() - (x + 2.0).recip() * y
        };
        let at = [0.8, 1.3];
        let exact = f(Taylor::variables(at));
        let step = 1e-6;
        for k in 0..2 {
            let moved = |by: f64| {
                let mut place = at;
                place[k] += by;
                f(Taylor::variables(place))
            };
            let (up, down) = (moved(step), moved(-step));
            let slope = (up.value - down.value) / (2.0 * step);
            assert!((slope - exact.gradient[k]).abs() < 1e-8);
            for j in 0..2 {
                let bend = (up.gradient[j] - down.gradient[j]) / (2.0 * step);
                assert!((bend - exact.hessian[k][j]).abs() < 1e-8, "{k} {j}");
            }
        }
    }
}
