//! Natural logarithm and exponential from +, −, ×, ÷ only, so that their bits are equal on every platform.
//!
//! IEEE 754 fixes the bits of these four operations and of the square root. It does not fix `ln` and `exp`, which
//! the standard library takes from the system: seeded samples would differ between Linux, macOS and Windows in the
//! last bit. Only random numbers use these functions; everything else uses the standard library.

/// ln 2 in two parts: the first has 21 trailing zero bits, so its product with an exponent is exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// Number of terms of the series of atanh: with |s| ≤ 0.1716 the first omitted term is below 2e-18 of the sum.
const TERMS_LN: u32 = 11;
/// Number of terms of the series of exp: with |r| ≤ 0.3466 the first omitted term is below 1e-19.
const TERMS_EXP: u32 = 15;
const MANTISSA_BITS: i32 = 52;
const EXPONENT_BIAS: i32 = 1023;

/// 2^exponent for the exponents of normal numbers, −1022 to 1023.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + EXPONENT_BIAS) as u64) << MANTISSA_BITS)
}

/// ln x for a positive, finite, normal x; within 2 units in the last place of the true value.
///
/// ```text
/// x = m 2^e,  √½ ≤ m < √2,  s = (m − 1)/(m + 1):   ln x = e ln 2 + 2 (s + s³/3 + s⁵/5 + …)
/// ```
pub(super) fn ln(x: f64) -> f64 {
    let bits = x.to_bits();
    let mut e = ((bits >> MANTISSA_BITS) & 0x7ff) as i32 - EXPONENT_BIAS;
    let mut m = f64::from_bits((bits & ((1 << MANTISSA_BITS) - 1)) | 1.0_f64.to_bits());
    if m > std::f64::consts::SQRT_2 {
        m *= 0.5;
        e += 1;
    }
    let s = (m - 1.0) / (m + 1.0);
    let mut series = 0.0;
    for k in (0..TERMS_LN).rev() {
        series = series * (s * s) + 1.0 / f64::from(2 * k + 1);
    }
    let e = f64::from(e);
    e * LN_2_HIGH + (e * LN_2_LOW + 2.0 * s * series)
}

/// eˣ within 2 units in the last place of the true value; x is limited to −700 ≤ x ≤ 700.
///
/// ```text
/// x = j ln 2 + r,  |r| ≤ ½ ln 2:   eˣ = 2^j (1 + r + r²/2! + …)
/// ```
pub(super) fn exp(x: f64) -> f64 {
    let x = x.clamp(-700.0, 700.0); // 1e±304: no normal number overflows
    let j = (x * std::f64::consts::LOG2_E).round_ties_even();
    let r = (x - j * LN_2_HIGH) - j * LN_2_LOW;
    let mut series = 1.0;
    for k in (1..TERMS_EXP).rev() {
        series = 1.0 + series * r / f64::from(k);
    }
    series * power_of_two(j as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_standard_library_to_4e_16() {
        let mut x = 1e-300_f64;
        while x < 1e300 {
            let (ours, theirs) = (ln(x), x.ln());
            assert!(
                (ours - theirs).abs() <= 4e-16 * theirs.abs().max(0.1),
                "ln {x}: {ours} {theirs}"
            );
            x *= 1.37;
        }
        let mut x = -690.0_f64;
        while x < 690.0 {
            let (ours, theirs) = (exp(x), x.exp());
            assert!((ours / theirs - 1.0).abs() <= 4.5e-16, "exp {x}: {ours} {theirs}");
            x += 0.317;
        }
    }

    #[test]
    fn exact_values() {
        assert_eq!(ln(1.0), 0.0);
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(ln(2.0), std::f64::consts::LN_2);
        assert!(LN_2_HIGH.to_bits().trailing_zeros() >= 21);
    }
}
