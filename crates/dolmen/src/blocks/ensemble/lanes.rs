//! Numbers, vectors and rotations of several runs side by side, one run per lane.
//!
//! Every operation is that of a single run, lane by lane and in the same order, without fused products. The bits of a run
//! therefore do not depend on the other lanes, on their number, or on the width of the vector registers.

use glam::{DMat3, DQuat, DVec3};
use pulp::{Simd, bytemuck};
use std::ops::{Add, BitOr, Div, Mul, Not, Sub};

#[derive(Clone, Copy, Debug)]
pub(super) struct Real<S: Simd>(pub(super) S, pub(super) S::f64s);

/// A truth value in each run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mask<S: Simd>(S, S::m64s);

#[derive(Clone, Copy, Debug)]
pub(super) struct Vector<S: Simd> {
    pub(super) x: Real<S>,
    pub(super) y: Real<S>,
    pub(super) z: Real<S>,
}

/// A 3 × 3 matrix in each run, by columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns<S: Simd>(pub(super) [Vector<S>; 3]);

/// A quaternion in each run: x, y, z, w.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn<S: Simd>(pub(super) [Real<S>; 4]);

macro_rules! by_lane {
    ($trait:ident, $method:ident, $operation:ident) => {
        impl<S: Simd> $trait for Real<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Real(self.0, self.0.$operation(self.1, other.1))
            }
        }
    };
}
by_lane!(Add, add, add_f64s);
by_lane!(Sub, sub, sub_f64s);
by_lane!(Mul, mul, mul_f64s);
by_lane!(Div, div, div_f64s);

impl<S: Simd> std::ops::Neg for Real<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Real(self.0, self.0.neg_f64s(self.1))
    }
}

impl<S: Simd> Real<S> {
    #[inline(always)]
    pub(super) fn all(simd: S, value: f64) -> Self {
        Real(simd, simd.splat_f64s(value))
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Real(self.0, self.0.abs_f64s(self.1))
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Real(self.0, self.0.sqrt_f64s(self.1))
    }

    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        Real(self.0, self.0.max_f64s(self.1, other.1))
    }

    #[inline(always)]
    pub(super) fn above(self, other: Self) -> Mask<S> {
        Mask(self.0, self.0.greater_than_f64s(self.1, other.1))
    }

    #[inline(always)]
    pub(super) fn at_least(self, other: Self) -> Mask<S> {
        Mask(self.0, self.0.greater_than_or_equal_f64s(self.1, other.1))
    }

    #[inline(always)]
    pub(super) fn lanes(&self) -> &[f64] {
        bytemuck::cast_slice(std::slice::from_ref(&self.1))
    }

    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> f64 {
        self.lanes()[lane]
    }

    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, value: f64) {
        bytemuck::cast_slice_mut(std::slice::from_mut(&mut self.1))[lane] = value;
    }
}

impl<S: Simd> BitOr for Mask<S> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Mask(self.0, self.0.or_m64s(self.1, other.1))
    }
}

impl<S: Simd> Not for Mask<S> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Mask(self.0, self.0.not_m64s(self.1))
    }
}

impl<S: Simd> Mask<S> {
    #[inline(always)]
    pub(super) fn and(self, other: Self) -> Self {
        Mask(self.0, self.0.and_m64s(self.1, other.1))
    }

    #[inline(always)]
    pub(super) fn any(self) -> bool {
        self.0.first_true_m64s(self.1) < S::F64_LANES
    }

    #[inline(always)]
    pub(super) fn select(self, yes: Real<S>, no: Real<S>) -> Real<S> {
        Real(self.0, self.0.select_f64s(self.1, yes.1, no.1))
    }

    /// 1 where the mask is true, otherwise 0.
    #[inline(always)]
    pub(super) fn ones(self) -> Real<S> {
        self.select(Real::all(self.0, 1.0), Real::all(self.0, 0.0))
    }
}

impl<S: Simd> Add for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Vector {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl<S: Simd> Sub for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Vector {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl<S: Simd> Mul<Real<S>> for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, by: Real<S>) -> Self {
        Vector {
            x: self.x * by,
            y: self.y * by,
            z: self.z * by,
        }
    }
}

impl<S: Simd> std::ops::Neg for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Vector {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}

impl<S: Simd> Vector<S> {
    pub(super) fn all(simd: S, value: DVec3) -> Self {
        Vector {
            x: Real::all(simd, value.x),
            y: Real::all(simd, value.y),
            z: Real::all(simd, value.z),
        }
    }

    #[inline(always)]
    pub(super) fn dot(self, other: Self) -> Real<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(super) fn cross(self, other: Self) -> Self {
        Vector {
            x: self.y * other.z - other.y * self.z,
            y: self.z * other.x - other.z * self.x,
            z: self.x * other.y - other.x * self.y,
        }
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Vector {
            x: self.x.abs(),
            y: self.y.abs(),
            z: self.z.abs(),
        }
    }

    /// Componentwise product.
    #[inline(always)]
    pub(super) fn by_parts(self, other: Self) -> Self {
        Vector {
            x: self.x * other.x,
            y: self.y * other.y,
            z: self.z * other.z,
        }
    }

    #[inline(always)]
    pub(super) fn sum(self) -> Real<S> {
        self.x + self.y + self.z
    }

    pub(super) fn get(&self, lane: usize) -> DVec3 {
        DVec3::new(self.x.get(lane), self.y.get(lane), self.z.get(lane))
    }

    pub(super) fn set(&mut self, lane: usize, value: DVec3) {
        self.x.set(lane, value.x);
        self.y.set(lane, value.y);
        self.z.set(lane, value.z);
    }
}

impl<S: Simd> Mul<Vector<S>> for Columns<S> {
    type Output = Vector<S>;
    #[inline(always)]
    fn mul(self, by: Vector<S>) -> Vector<S> {
        let [a, b, c] = self.0;
        a * by.x + b * by.y + c * by.z
    }
}

impl<S: Simd> Mul for Columns<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, by: Self) -> Self {
        let [a, b, c] = by.0;
        Columns([self * a, self * b, self * c])
    }
}

impl<S: Simd> Columns<S> {
    pub(super) fn all(simd: S, value: DMat3) -> Self {
        Columns([value.x_axis, value.y_axis, value.z_axis].map(|axis| Vector::all(simd, axis)))
    }

    /// The transpose times a vector.
    #[inline(always)]
    pub(super) fn transposed_times(self, by: Vector<S>) -> Vector<S> {
        let [x, y, z] = self.0;
        Vector {
            x: x.dot(by),
            y: y.dot(by),
            z: z.dot(by),
        }
    }

    pub(super) fn get(&self, lane: usize) -> DMat3 {
        let [x, y, z] = &self.0;
        DMat3::from_cols(x.get(lane), y.get(lane), z.get(lane))
    }

    pub(super) fn set(&mut self, lane: usize, value: DMat3) {
        let axes = [value.x_axis, value.y_axis, value.z_axis];
        for (column, axis) in self.0.iter_mut().zip(axes) {
            column.set(lane, axis);
        }
    }
}

impl<S: Simd> Mul for Turn<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let ([x0, y0, z0, w0], [x1, y1, z1, w1]) = (self.0, other.0);
        Turn([
            w0 * x1 + x0 * w1 + y0 * z1 - z0 * y1,
            w0 * y1 - x0 * z1 + y0 * w1 + z0 * x1,
            w0 * z1 + x0 * y1 - y0 * x1 + z0 * w1,
            w0 * w1 - x0 * x1 - y0 * y1 - z0 * z1,
        ])
    }
}

impl<S: Simd> Turn<S> {
    pub(super) fn all(simd: S, value: DQuat) -> Self {
        Turn([value.x, value.y, value.z, value.w].map(|part| Real::all(simd, part)))
    }

    #[inline(always)]
    pub(super) fn length_squared(self) -> Real<S> {
        let [x, y, z, w] = self.0;
        x * x + y * y + z * z + w * w
    }

    #[inline(always)]
    pub(super) fn times(self, by: Real<S>) -> Self {
        let [x, y, z, w] = self.0;
        Turn([x * by, y * by, z * by, w * by])
    }

    /// The rotation matrix of a unit quaternion.
    #[inline(always)]
    pub(super) fn matrix(self) -> Columns<S> {
        let [x, y, z, w] = self.0;
        let one = Real::all(x.0, 1.0);
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        Columns([
            Vector {
                x: one - (yy + zz),
                y: xy + wz,
                z: xz - wy,
            },
            Vector {
                x: xy - wz,
                y: one - (xx + zz),
                z: yz + wx,
            },
            Vector {
                x: xz + wy,
                y: yz - wx,
                z: one - (xx + yy),
            },
        ])
    }

    pub(super) fn get(&self, lane: usize) -> DQuat {
        let [x, y, z, w] = &self.0;
        DQuat::from_xyzw(x.get(lane), y.get(lane), z.get(lane), w.get(lane))
    }

    pub(super) fn set(&mut self, lane: usize, value: DQuat) {
        for (part, value) in self.0.iter_mut().zip([value.x, value.y, value.z, value.w]) {
            part.set(lane, value);
        }
    }
}
