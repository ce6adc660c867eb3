// I_n = (1/2 pi) integral of G(jw) / (H(jw) H(-jw)) dw over all w,
// H(s) = a0 s^n + a1 s^(n-1) + ... + an with all roots in the left half plane,
// G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).
// The ratio of the published determinants, by Routh's rows.
// Where H is not stable: not a number.
// Relative error measured at 2000 random points an order, damping ratios from 0.2, terms of G of
// one sign: at most 4e-15 up to order 10 and 2e-14 up to order 14. Elsewhere it grows with the
// condition of the integral; `gyrospec integral` gives all digits and a bound for any H and G.
// Written by `gyrospec table`.

/// I_1 from a0 ... a1 and b0 ... b0.
pub fn i1(a: &[f64; 2], b: &[f64; 1]) -> f64 {
    let q1 = a[0] / a[1];
    let y0 = b[0] / a[1];
    let stable = q1 > 0.0;
    if stable { y0 / (2.0 * a[0]) } else { f64::NAN }
}

/// I_2 from a0 ... a2 and b0 ... b1.
pub fn i2(a: &[f64; 3], b: &[f64; 2]) -> f64 {
    let q1 = a[0] / a[1];
    let q2 = a[1] / a[2];
    let y0 = b[0] / a[1];
    let y1 = b[1] / a[2];
    let stable = q1 > 0.0 && q2 > 0.0;
    if stable { (q1 * y1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_3 from a0 ... a3 and b0 ... b2.
pub fn i3(a: &[f64; 4], b: &[f64; 3]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let q2 = a[1] / r2_0;
    let q3 = r2_0 / a[3];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = b[2] / a[3];
    let z1 = y1 - q2 * y2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0;
    if stable { (y0 - q1 * z1) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_4 from a0 ... a4 and b0 ... b3.
pub fn i4(a: &[f64; 5], b: &[f64; 4]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * a[4];
    let q3 = r2_0 / r3_0;
    let q4 = r3_0 / a[4];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[4] * y1) / r3_0;
    let y3 = b[3] / a[4];
    let z2 = y2 - q3 * y3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0;
    if stable { (q1 * z1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_5 from a0 ... a5 and b0 ... b4.
pub fn i5(a: &[f64; 6], b: &[f64; 5]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * a[5];
    let q4 = r3_0 / r4_0;
    let q5 = r4_0 / a[5];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[5] * y2) / r4_0;
    let y4 = b[4] / a[5];
    let z3 = y3 - q4 * y4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0;
    if stable { (y0 - q1 * z1) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_6 from a0 ... a6 and b0 ... b5.
pub fn i6(a: &[f64; 7], b: &[f64; 6]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * a[6];
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * a[6];
    let q5 = r4_0 / r5_0;
    let q6 = r5_0 / a[6];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[6] * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[6] * y3) / r5_0;
    let y5 = b[5] / a[6];
    let z4 = y4 - q5 * y5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0;
    if stable { (q1 * z1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_7 from a0 ... a7 and b0 ... b6.
pub fn i7(a: &[f64; 8], b: &[f64; 7]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * a[7];
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * a[7];
    let q6 = r5_0 / r6_0;
    let q7 = r6_0 / a[7];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[7] * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[7] * y4) / r6_0;
    let y6 = b[6] / a[7];
    let z5 = y5 - q6 * y6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0;
    if stable { (y0 - q1 * z1) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_8 from a0 ... a8 and b0 ... b7.
pub fn i8(a: &[f64; 9], b: &[f64; 8]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * a[8];
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * a[8];
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * a[8];
    let q7 = r6_0 / r7_0;
    let q8 = r7_0 / a[8];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[8] * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[8] * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[8] * y5) / r7_0;
    let y7 = b[7] / a[8];
    let z6 = y6 - q7 * y7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0;
    if stable { (q1 * z1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_9 from a0 ... a9 and b0 ... b8.
pub fn i9(a: &[f64; 10], b: &[f64; 9]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let r2_3 = a[8] - q1 * a[9];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * r2_3;
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let r4_2 = r2_3 - q3 * a[9];
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * r4_2;
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let r6_1 = r4_2 - q5 * a[9];
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * r6_1;
    let q7 = r6_0 / r7_0;
    let r8_0 = r6_1 - q7 * a[9];
    let q8 = r7_0 / r8_0;
    let q9 = r8_0 / a[9];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[9] * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[9] * y4 - r6_1 * y5) / r7_0;
    let y7 = (b[7] - a[9] * y6) / r8_0;
    let y8 = b[8] / a[9];
    let z7 = y7 - q8 * y8;
    let z6 = y6 - q7 * z7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0;
    if stable { (y0 - q1 * z1) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_10 from a0 ... a10 and b0 ... b9.
pub fn i10(a: &[f64; 11], b: &[f64; 10]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let r2_3 = a[8] - q1 * a[9];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * r2_3;
    let r3_3 = a[9] - q2 * a[10];
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let r4_2 = r2_3 - q3 * r3_3;
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * r4_2;
    let r5_2 = r3_3 - q4 * a[10];
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let r6_1 = r4_2 - q5 * r5_2;
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * r6_1;
    let r7_1 = r5_2 - q6 * a[10];
    let q7 = r6_0 / r7_0;
    let r8_0 = r6_1 - q7 * r7_1;
    let q8 = r7_0 / r8_0;
    let r9_0 = r7_1 - q8 * a[10];
    let q9 = r8_0 / r9_0;
    let q10 = r9_0 / a[10];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[10] * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[10] * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    let y7 = (b[7] - a[10] * y5 - r7_1 * y6) / r8_0;
    let y8 = (b[8] - a[10] * y7) / r9_0;
    let y9 = b[9] / a[10];
    let z8 = y8 - q9 * y9;
    let z7 = y7 - q8 * z8;
    let z6 = y6 - q7 * z7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0;
    if stable { (q1 * z1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_11 from a0 ... a11 and b0 ... b10.
pub fn i11(a: &[f64; 12], b: &[f64; 11]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let r2_3 = a[8] - q1 * a[9];
    let r2_4 = a[10] - q1 * a[11];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * r2_3;
    let r3_3 = a[9] - q2 * r2_4;
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let r4_2 = r2_3 - q3 * r3_3;
    let r4_3 = r2_4 - q3 * a[11];
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * r4_2;
    let r5_2 = r3_3 - q4 * r4_3;
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let r6_1 = r4_2 - q5 * r5_2;
    let r6_2 = r4_3 - q5 * a[11];
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * r6_1;
    let r7_1 = r5_2 - q6 * r6_2;
    let q7 = r6_0 / r7_0;
    let r8_0 = r6_1 - q7 * r7_1;
    let r8_1 = r6_2 - q7 * a[11];
    let q8 = r7_0 / r8_0;
    let r9_0 = r7_1 - q8 * r8_1;
    let q9 = r8_0 / r9_0;
    let r10_0 = r8_1 - q9 * a[11];
    let q10 = r9_0 / r10_0;
    let q11 = r10_0 / a[11];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[11] * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    let y7 = (b[7] - a[11] * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    let y8 = (b[8] - a[11] * y6 - r8_1 * y7) / r9_0;
    let y9 = (b[9] - a[11] * y8) / r10_0;
    let y10 = b[10] / a[11];
    let z9 = y9 - q10 * y10;
    let z8 = y8 - q9 * z9;
    let z7 = y7 - q8 * z8;
    let z6 = y6 - q7 * z7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0;
    if stable { (y0 - q1 * z1) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_12 from a0 ... a12 and b0 ... b11.
pub fn i12(a: &[f64; 13], b: &[f64; 12]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let r2_3 = a[8] - q1 * a[9];
    let r2_4 = a[10] - q1 * a[11];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * r2_3;
    let r3_3 = a[9] - q2 * r2_4;
    let r3_4 = a[11] - q2 * a[12];
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let r4_2 = r2_3 - q3 * r3_3;
    let r4_3 = r2_4 - q3 * r3_4;
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * r4_2;
    let r5_2 = r3_3 - q4 * r4_3;
    let r5_3 = r3_4 - q4 * a[12];
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let r6_1 = r4_2 - q5 * r5_2;
    let r6_2 = r4_3 - q5 * r5_3;
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * r6_1;
    let r7_1 = r5_2 - q6 * r6_2;
    let r7_2 = r5_3 - q6 * a[12];
    let q7 = r6_0 / r7_0;
    let r8_0 = r6_1 - q7 * r7_1;
    let r8_1 = r6_2 - q7 * r7_2;
    let q8 = r7_0 / r8_0;
    let r9_0 = r7_1 - q8 * r8_1;
    let r9_1 = r7_2 - q8 * a[12];
    let q9 = r8_0 / r9_0;
    let r10_0 = r8_1 - q9 * r9_1;
    let q10 = r9_0 / r10_0;
    let r11_0 = r9_1 - q10 * a[12];
    let q11 = r10_0 / r11_0;
    let q12 = r11_0 / a[12];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[12] * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    let y7 = (b[7] - a[12] * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    let y8 = (b[8] - a[12] * y5 - r7_2 * y6 - r8_1 * y7) / r9_0;
    let y9 = (b[9] - a[12] * y7 - r9_1 * y8) / r10_0;
    let y10 = (b[10] - a[12] * y9) / r11_0;
    let y11 = b[11] / a[12];
    let z10 = y10 - q11 * y11;
    let z9 = y9 - q10 * z10;
    let z8 = y8 - q9 * z9;
    let z7 = y7 - q8 * z8;
    let z6 = y6 - q7 * z7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0 && q12 > 0.0;
    if stable { (q1 * z1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_13 from a0 ... a13 and b0 ... b12.
pub fn i13(a: &[f64; 14], b: &[f64; 13]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let r2_3 = a[8] - q1 * a[9];
    let r2_4 = a[10] - q1 * a[11];
    let r2_5 = a[12] - q1 * a[13];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * r2_3;
    let r3_3 = a[9] - q2 * r2_4;
    let r3_4 = a[11] - q2 * r2_5;
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let r4_2 = r2_3 - q3 * r3_3;
    let r4_3 = r2_4 - q3 * r3_4;
    let r4_4 = r2_5 - q3 * a[13];
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * r4_2;
    let r5_2 = r3_3 - q4 * r4_3;
    let r5_3 = r3_4 - q4 * r4_4;
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let r6_1 = r4_2 - q5 * r5_2;
    let r6_2 = r4_3 - q5 * r5_3;
    let r6_3 = r4_4 - q5 * a[13];
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * r6_1;
    let r7_1 = r5_2 - q6 * r6_2;
    let r7_2 = r5_3 - q6 * r6_3;
    let q7 = r6_0 / r7_0;
    let r8_0 = r6_1 - q7 * r7_1;
    let r8_1 = r6_2 - q7 * r7_2;
    let r8_2 = r6_3 - q7 * a[13];
    let q8 = r7_0 / r8_0;
    let r9_0 = r7_1 - q8 * r8_1;
    let r9_1 = r7_2 - q8 * r8_2;
    let q9 = r8_0 / r9_0;
    let r10_0 = r8_1 - q9 * r9_1;
    let r10_1 = r8_2 - q9 * a[13];
    let q10 = r9_0 / r10_0;
    let r11_0 = r9_1 - q10 * r10_1;
    let q11 = r10_0 / r11_0;
    let r12_0 = r10_1 - q11 * a[13];
    let q12 = r11_0 / r12_0;
    let q13 = r12_0 / a[13];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[13] * y0 - r2_5 * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    let y7 = (b[7] - a[13] * y2 - r4_4 * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    let y8 = (b[8] - a[13] * y4 - r6_3 * y5 - r7_2 * y6 - r8_1 * y7) / r9_0;
    let y9 = (b[9] - a[13] * y6 - r8_2 * y7 - r9_1 * y8) / r10_0;
    let y10 = (b[10] - a[13] * y8 - r10_1 * y9) / r11_0;
    let y11 = (b[11] - a[13] * y10) / r12_0;
    let y12 = b[12] / a[13];
    let z11 = y11 - q12 * y12;
    let z10 = y10 - q11 * z11;
    let z9 = y9 - q10 * z10;
    let z8 = y8 - q9 * z9;
    let z7 = y7 - q8 * z8;
    let z6 = y6 - q7 * z7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0 && q12 > 0.0 && q13 > 0.0;
    if stable { (y0 - q1 * z1) / (2.0 * a[0]) } else { f64::NAN }
}

/// I_14 from a0 ... a14 and b0 ... b13.
pub fn i14(a: &[f64; 15], b: &[f64; 14]) -> f64 {
    let q1 = a[0] / a[1];
    let r2_0 = a[2] - q1 * a[3];
    let r2_1 = a[4] - q1 * a[5];
    let r2_2 = a[6] - q1 * a[7];
    let r2_3 = a[8] - q1 * a[9];
    let r2_4 = a[10] - q1 * a[11];
    let r2_5 = a[12] - q1 * a[13];
    let q2 = a[1] / r2_0;
    let r3_0 = a[3] - q2 * r2_1;
    let r3_1 = a[5] - q2 * r2_2;
    let r3_2 = a[7] - q2 * r2_3;
    let r3_3 = a[9] - q2 * r2_4;
    let r3_4 = a[11] - q2 * r2_5;
    let r3_5 = a[13] - q2 * a[14];
    let q3 = r2_0 / r3_0;
    let r4_0 = r2_1 - q3 * r3_1;
    let r4_1 = r2_2 - q3 * r3_2;
    let r4_2 = r2_3 - q3 * r3_3;
    let r4_3 = r2_4 - q3 * r3_4;
    let r4_4 = r2_5 - q3 * r3_5;
    let q4 = r3_0 / r4_0;
    let r5_0 = r3_1 - q4 * r4_1;
    let r5_1 = r3_2 - q4 * r4_2;
    let r5_2 = r3_3 - q4 * r4_3;
    let r5_3 = r3_4 - q4 * r4_4;
    let r5_4 = r3_5 - q4 * a[14];
    let q5 = r4_0 / r5_0;
    let r6_0 = r4_1 - q5 * r5_1;
    let r6_1 = r4_2 - q5 * r5_2;
    let r6_2 = r4_3 - q5 * r5_3;
    let r6_3 = r4_4 - q5 * r5_4;
    let q6 = r5_0 / r6_0;
    let r7_0 = r5_1 - q6 * r6_1;
    let r7_1 = r5_2 - q6 * r6_2;
    let r7_2 = r5_3 - q6 * r6_3;
    let r7_3 = r5_4 - q6 * a[14];
    let q7 = r6_0 / r7_0;
    let r8_0 = r6_1 - q7 * r7_1;
    let r8_1 = r6_2 - q7 * r7_2;
    let r8_2 = r6_3 - q7 * r7_3;
    let q8 = r7_0 / r8_0;
    let r9_0 = r7_1 - q8 * r8_1;
    let r9_1 = r7_2 - q8 * r8_2;
    let r9_2 = r7_3 - q8 * a[14];
    let q9 = r8_0 / r9_0;
    let r10_0 = r8_1 - q9 * r9_1;
    let r10_1 = r8_2 - q9 * r9_2;
    let q10 = r9_0 / r10_0;
    let r11_0 = r9_1 - q10 * r10_1;
    let r11_1 = r9_2 - q10 * a[14];
    let q11 = r10_0 / r11_0;
    let r12_0 = r10_1 - q11 * r11_1;
    let q12 = r11_0 / r12_0;
    let r13_0 = r11_1 - q12 * a[14];
    let q13 = r12_0 / r13_0;
    let q14 = r13_0 / a[14];
    let y0 = b[0] / a[1];
    let y1 = (b[1] - a[3] * y0) / r2_0;
    let y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    let y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    let y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    let y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    let y6 = (b[6] - a[13] * y0 - r2_5 * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    let y7 = (b[7] - a[14] * y1 - r3_5 * y2 - r4_4 * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    let y8 = (b[8] - a[14] * y3 - r5_4 * y4 - r6_3 * y5 - r7_2 * y6 - r8_1 * y7) / r9_0;
    let y9 = (b[9] - a[14] * y5 - r7_3 * y6 - r8_2 * y7 - r9_1 * y8) / r10_0;
    let y10 = (b[10] - a[14] * y7 - r9_2 * y8 - r10_1 * y9) / r11_0;
    let y11 = (b[11] - a[14] * y9 - r11_1 * y10) / r12_0;
    let y12 = (b[12] - a[14] * y11) / r13_0;
    let y13 = b[13] / a[14];
    let z12 = y12 - q13 * y13;
    let z11 = y11 - q12 * z12;
    let z10 = y10 - q11 * z11;
    let z9 = y9 - q10 * z10;
    let z8 = y8 - q9 * z9;
    let z7 = y7 - q8 * z8;
    let z6 = y6 - q7 * z7;
    let z5 = y5 - q6 * z6;
    let z4 = y4 - q5 * z5;
    let z3 = y3 - q4 * z4;
    let z2 = y2 - q3 * z3;
    let z1 = y1 - q2 * z2;
    let stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0 && q12 > 0.0 && q13 > 0.0 && q14 > 0.0;
    if stable { (q1 * z1 - y0) / (2.0 * a[0]) } else { f64::NAN }
}
