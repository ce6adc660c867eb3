/* I_n = (1/2 pi) integral of G(jw) / (H(jw) H(-jw)) dw over all w,
 * H(s) = a0 s^n + a1 s^(n-1) + ... + an with all roots in the left half plane,
 * G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).
 * The ratio of the published determinants, by Routh's rows.
 * Where H is not stable: not a number.
 * Relative error measured at 2000 random points an order, damping ratios from 0.2, terms of G of
 * one sign: at most 4e-15 up to order 10 and 2e-14 up to order 14. Elsewhere it grows with the
 * condition of the integral; `gyrospec integral` gives all digits and a bound for any H and G.
 * Written by `gyrospec table`.
 */
#include <math.h>

double gyrospec_i1(const double a[2], const double b[1])
{
    const double q1 = a[0] / a[1];
    const double y0 = b[0] / a[1];
    const int stable = q1 > 0.0;
    return stable ? y0 / (2.0 * a[0]) : NAN;
}

double gyrospec_i2(const double a[3], const double b[2])
{
    const double q1 = a[0] / a[1];
    const double q2 = a[1] / a[2];
    const double y0 = b[0] / a[1];
    const double y1 = b[1] / a[2];
    const int stable = q1 > 0.0 && q2 > 0.0;
    return stable ? (q1 * y1 - y0) / (2.0 * a[0]) : NAN;
}

double gyrospec_i3(const double a[4], const double b[3])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double q2 = a[1] / r2_0;
    const double q3 = r2_0 / a[3];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = b[2] / a[3];
    const double z1 = y1 - q2 * y2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0;
    return stable ? (y0 - q1 * z1) / (2.0 * a[0]) : NAN;
}

double gyrospec_i4(const double a[5], const double b[4])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * a[4];
    const double q3 = r2_0 / r3_0;
    const double q4 = r3_0 / a[4];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[4] * y1) / r3_0;
    const double y3 = b[3] / a[4];
    const double z2 = y2 - q3 * y3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0;
    return stable ? (q1 * z1 - y0) / (2.0 * a[0]) : NAN;
}

double gyrospec_i5(const double a[6], const double b[5])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * a[5];
    const double q4 = r3_0 / r4_0;
    const double q5 = r4_0 / a[5];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[5] * y2) / r4_0;
    const double y4 = b[4] / a[5];
    const double z3 = y3 - q4 * y4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0;
    return stable ? (y0 - q1 * z1) / (2.0 * a[0]) : NAN;
}

double gyrospec_i6(const double a[7], const double b[6])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * a[6];
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * a[6];
    const double q5 = r4_0 / r5_0;
    const double q6 = r5_0 / a[6];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[6] * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[6] * y3) / r5_0;
    const double y5 = b[5] / a[6];
    const double z4 = y4 - q5 * y5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0;
    return stable ? (q1 * z1 - y0) / (2.0 * a[0]) : NAN;
}

double gyrospec_i7(const double a[8], const double b[7])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * a[7];
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * a[7];
    const double q6 = r5_0 / r6_0;
    const double q7 = r6_0 / a[7];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[7] * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[7] * y4) / r6_0;
    const double y6 = b[6] / a[7];
    const double z5 = y5 - q6 * y6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0;
    return stable ? (y0 - q1 * z1) / (2.0 * a[0]) : NAN;
}

double gyrospec_i8(const double a[9], const double b[8])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * a[8];
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * a[8];
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * a[8];
    const double q7 = r6_0 / r7_0;
    const double q8 = r7_0 / a[8];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[8] * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[8] * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[8] * y5) / r7_0;
    const double y7 = b[7] / a[8];
    const double z6 = y6 - q7 * y7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0;
    return stable ? (q1 * z1 - y0) / (2.0 * a[0]) : NAN;
}

double gyrospec_i9(const double a[10], const double b[9])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double r2_3 = a[8] - q1 * a[9];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * r2_3;
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double r4_2 = r2_3 - q3 * a[9];
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * r4_2;
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double r6_1 = r4_2 - q5 * a[9];
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * r6_1;
    const double q7 = r6_0 / r7_0;
    const double r8_0 = r6_1 - q7 * a[9];
    const double q8 = r7_0 / r8_0;
    const double q9 = r8_0 / a[9];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[9] * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[9] * y4 - r6_1 * y5) / r7_0;
    const double y7 = (b[7] - a[9] * y6) / r8_0;
    const double y8 = b[8] / a[9];
    const double z7 = y7 - q8 * y8;
    const double z6 = y6 - q7 * z7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0;
    return stable ? (y0 - q1 * z1) / (2.0 * a[0]) : NAN;
}

double gyrospec_i10(const double a[11], const double b[10])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double r2_3 = a[8] - q1 * a[9];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * r2_3;
    const double r3_3 = a[9] - q2 * a[10];
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double r4_2 = r2_3 - q3 * r3_3;
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * r4_2;
    const double r5_2 = r3_3 - q4 * a[10];
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double r6_1 = r4_2 - q5 * r5_2;
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * r6_1;
    const double r7_1 = r5_2 - q6 * a[10];
    const double q7 = r6_0 / r7_0;
    const double r8_0 = r6_1 - q7 * r7_1;
    const double q8 = r7_0 / r8_0;
    const double r9_0 = r7_1 - q8 * a[10];
    const double q9 = r8_0 / r9_0;
    const double q10 = r9_0 / a[10];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[10] * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[10] * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    const double y7 = (b[7] - a[10] * y5 - r7_1 * y6) / r8_0;
    const double y8 = (b[8] - a[10] * y7) / r9_0;
    const double y9 = b[9] / a[10];
    const double z8 = y8 - q9 * y9;
    const double z7 = y7 - q8 * z8;
    const double z6 = y6 - q7 * z7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0;
    return stable ? (q1 * z1 - y0) / (2.0 * a[0]) : NAN;
}

double gyrospec_i11(const double a[12], const double b[11])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double r2_3 = a[8] - q1 * a[9];
    const double r2_4 = a[10] - q1 * a[11];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * r2_3;
    const double r3_3 = a[9] - q2 * r2_4;
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double r4_2 = r2_3 - q3 * r3_3;
    const double r4_3 = r2_4 - q3 * a[11];
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * r4_2;
    const double r5_2 = r3_3 - q4 * r4_3;
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double r6_1 = r4_2 - q5 * r5_2;
    const double r6_2 = r4_3 - q5 * a[11];
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * r6_1;
    const double r7_1 = r5_2 - q6 * r6_2;
    const double q7 = r6_0 / r7_0;
    const double r8_0 = r6_1 - q7 * r7_1;
    const double r8_1 = r6_2 - q7 * a[11];
    const double q8 = r7_0 / r8_0;
    const double r9_0 = r7_1 - q8 * r8_1;
    const double q9 = r8_0 / r9_0;
    const double r10_0 = r8_1 - q9 * a[11];
    const double q10 = r9_0 / r10_0;
    const double q11 = r10_0 / a[11];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[11] * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    const double y7 = (b[7] - a[11] * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    const double y8 = (b[8] - a[11] * y6 - r8_1 * y7) / r9_0;
    const double y9 = (b[9] - a[11] * y8) / r10_0;
    const double y10 = b[10] / a[11];
    const double z9 = y9 - q10 * y10;
    const double z8 = y8 - q9 * z9;
    const double z7 = y7 - q8 * z8;
    const double z6 = y6 - q7 * z7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0;
    return stable ? (y0 - q1 * z1) / (2.0 * a[0]) : NAN;
}

double gyrospec_i12(const double a[13], const double b[12])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double r2_3 = a[8] - q1 * a[9];
    const double r2_4 = a[10] - q1 * a[11];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * r2_3;
    const double r3_3 = a[9] - q2 * r2_4;
    const double r3_4 = a[11] - q2 * a[12];
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double r4_2 = r2_3 - q3 * r3_3;
    const double r4_3 = r2_4 - q3 * r3_4;
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * r4_2;
    const double r5_2 = r3_3 - q4 * r4_3;
    const double r5_3 = r3_4 - q4 * a[12];
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double r6_1 = r4_2 - q5 * r5_2;
    const double r6_2 = r4_3 - q5 * r5_3;
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * r6_1;
    const double r7_1 = r5_2 - q6 * r6_2;
    const double r7_2 = r5_3 - q6 * a[12];
    const double q7 = r6_0 / r7_0;
    const double r8_0 = r6_1 - q7 * r7_1;
    const double r8_1 = r6_2 - q7 * r7_2;
    const double q8 = r7_0 / r8_0;
    const double r9_0 = r7_1 - q8 * r8_1;
    const double r9_1 = r7_2 - q8 * a[12];
    const double q9 = r8_0 / r9_0;
    const double r10_0 = r8_1 - q9 * r9_1;
    const double q10 = r9_0 / r10_0;
    const double r11_0 = r9_1 - q10 * a[12];
    const double q11 = r10_0 / r11_0;
    const double q12 = r11_0 / a[12];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[12] * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    const double y7 = (b[7] - a[12] * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    const double y8 = (b[8] - a[12] * y5 - r7_2 * y6 - r8_1 * y7) / r9_0;
    const double y9 = (b[9] - a[12] * y7 - r9_1 * y8) / r10_0;
    const double y10 = (b[10] - a[12] * y9) / r11_0;
    const double y11 = b[11] / a[12];
    const double z10 = y10 - q11 * y11;
    const double z9 = y9 - q10 * z10;
    const double z8 = y8 - q9 * z9;
    const double z7 = y7 - q8 * z8;
    const double z6 = y6 - q7 * z7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0 && q12 > 0.0;
    return stable ? (q1 * z1 - y0) / (2.0 * a[0]) : NAN;
}

double gyrospec_i13(const double a[14], const double b[13])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double r2_3 = a[8] - q1 * a[9];
    const double r2_4 = a[10] - q1 * a[11];
    const double r2_5 = a[12] - q1 * a[13];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * r2_3;
    const double r3_3 = a[9] - q2 * r2_4;
    const double r3_4 = a[11] - q2 * r2_5;
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double r4_2 = r2_3 - q3 * r3_3;
    const double r4_3 = r2_4 - q3 * r3_4;
    const double r4_4 = r2_5 - q3 * a[13];
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * r4_2;
    const double r5_2 = r3_3 - q4 * r4_3;
    const double r5_3 = r3_4 - q4 * r4_4;
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double r6_1 = r4_2 - q5 * r5_2;
    const double r6_2 = r4_3 - q5 * r5_3;
    const double r6_3 = r4_4 - q5 * a[13];
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * r6_1;
    const double r7_1 = r5_2 - q6 * r6_2;
    const double r7_2 = r5_3 - q6 * r6_3;
    const double q7 = r6_0 / r7_0;
    const double r8_0 = r6_1 - q7 * r7_1;
    const double r8_1 = r6_2 - q7 * r7_2;
    const double r8_2 = r6_3 - q7 * a[13];
    const double q8 = r7_0 / r8_0;
    const double r9_0 = r7_1 - q8 * r8_1;
    const double r9_1 = r7_2 - q8 * r8_2;
    const double q9 = r8_0 / r9_0;
    const double r10_0 = r8_1 - q9 * r9_1;
    const double r10_1 = r8_2 - q9 * a[13];
    const double q10 = r9_0 / r10_0;
    const double r11_0 = r9_1 - q10 * r10_1;
    const double q11 = r10_0 / r11_0;
    const double r12_0 = r10_1 - q11 * a[13];
    const double q12 = r11_0 / r12_0;
    const double q13 = r12_0 / a[13];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[13] * y0 - r2_5 * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    const double y7 = (b[7] - a[13] * y2 - r4_4 * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    const double y8 = (b[8] - a[13] * y4 - r6_3 * y5 - r7_2 * y6 - r8_1 * y7) / r9_0;
    const double y9 = (b[9] - a[13] * y6 - r8_2 * y7 - r9_1 * y8) / r10_0;
    const double y10 = (b[10] - a[13] * y8 - r10_1 * y9) / r11_0;
    const double y11 = (b[11] - a[13] * y10) / r12_0;
    const double y12 = b[12] / a[13];
    const double z11 = y11 - q12 * y12;
    const double z10 = y10 - q11 * z11;
    const double z9 = y9 - q10 * z10;
    const double z8 = y8 - q9 * z9;
    const double z7 = y7 - q8 * z8;
    const double z6 = y6 - q7 * z7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0 && q12 > 0.0 && q13 > 0.0;
    return stable ? (y0 - q1 * z1) / (2.0 * a[0]) : NAN;
}

double gyrospec_i14(const double a[15], const double b[14])
{
    const double q1 = a[0] / a[1];
    const double r2_0 = a[2] - q1 * a[3];
    const double r2_1 = a[4] - q1 * a[5];
    const double r2_2 = a[6] - q1 * a[7];
    const double r2_3 = a[8] - q1 * a[9];
    const double r2_4 = a[10] - q1 * a[11];
    const double r2_5 = a[12] - q1 * a[13];
    const double q2 = a[1] / r2_0;
    const double r3_0 = a[3] - q2 * r2_1;
    const double r3_1 = a[5] - q2 * r2_2;
    const double r3_2 = a[7] - q2 * r2_3;
    const double r3_3 = a[9] - q2 * r2_4;
    const double r3_4 = a[11] - q2 * r2_5;
    const double r3_5 = a[13] - q2 * a[14];
    const double q3 = r2_0 / r3_0;
    const double r4_0 = r2_1 - q3 * r3_1;
    const double r4_1 = r2_2 - q3 * r3_2;
    const double r4_2 = r2_3 - q3 * r3_3;
    const double r4_3 = r2_4 - q3 * r3_4;
    const double r4_4 = r2_5 - q3 * r3_5;
    const double q4 = r3_0 / r4_0;
    const double r5_0 = r3_1 - q4 * r4_1;
    const double r5_1 = r3_2 - q4 * r4_2;
    const double r5_2 = r3_3 - q4 * r4_3;
    const double r5_3 = r3_4 - q4 * r4_4;
    const double r5_4 = r3_5 - q4 * a[14];
    const double q5 = r4_0 / r5_0;
    const double r6_0 = r4_1 - q5 * r5_1;
    const double r6_1 = r4_2 - q5 * r5_2;
    const double r6_2 = r4_3 - q5 * r5_3;
    const double r6_3 = r4_4 - q5 * r5_4;
    const double q6 = r5_0 / r6_0;
    const double r7_0 = r5_1 - q6 * r6_1;
    const double r7_1 = r5_2 - q6 * r6_2;
    const double r7_2 = r5_3 - q6 * r6_3;
    const double r7_3 = r5_4 - q6 * a[14];
    const double q7 = r6_0 / r7_0;
    const double r8_0 = r6_1 - q7 * r7_1;
    const double r8_1 = r6_2 - q7 * r7_2;
    const double r8_2 = r6_3 - q7 * r7_3;
    const double q8 = r7_0 / r8_0;
    const double r9_0 = r7_1 - q8 * r8_1;
    const double r9_1 = r7_2 - q8 * r8_2;
    const double r9_2 = r7_3 - q8 * a[14];
    const double q9 = r8_0 / r9_0;
    const double r10_0 = r8_1 - q9 * r9_1;
    const double r10_1 = r8_2 - q9 * r9_2;
    const double q10 = r9_0 / r10_0;
    const double r11_0 = r9_1 - q10 * r10_1;
    const double r11_1 = r9_2 - q10 * a[14];
    const double q11 = r10_0 / r11_0;
    const double r12_0 = r10_1 - q11 * r11_1;
    const double q12 = r11_0 / r12_0;
    const double r13_0 = r11_1 - q12 * a[14];
    const double q13 = r12_0 / r13_0;
    const double q14 = r13_0 / a[14];
    const double y0 = b[0] / a[1];
    const double y1 = (b[1] - a[3] * y0) / r2_0;
    const double y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0;
    const double y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0;
    const double y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0;
    const double y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0;
    const double y6 = (b[6] - a[13] * y0 - r2_5 * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0;
    const double y7 = (b[7] - a[14] * y1 - r3_5 * y2 - r4_4 * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0;
    const double y8 = (b[8] - a[14] * y3 - r5_4 * y4 - r6_3 * y5 - r7_2 * y6 - r8_1 * y7) / r9_0;
    const double y9 = (b[9] - a[14] * y5 - r7_3 * y6 - r8_2 * y7 - r9_1 * y8) / r10_0;
    const double y10 = (b[10] - a[14] * y7 - r9_2 * y8 - r10_1 * y9) / r11_0;
    const double y11 = (b[11] - a[14] * y9 - r11_1 * y10) / r12_0;
    const double y12 = (b[12] - a[14] * y11) / r13_0;
    const double y13 = b[13] / a[14];
    const double z12 = y12 - q13 * y13;
    const double z11 = y11 - q12 * z12;
    const double z10 = y10 - q11 * z11;
    const double z9 = y9 - q10 * z10;
    const double z8 = y8 - q9 * z9;
    const double z7 = y7 - q8 * z8;
    const double z6 = y6 - q7 * z7;
    const double z5 = y5 - q6 * z6;
    const double z4 = y4 - q5 * z5;
    const double z3 = y3 - q4 * z4;
    const double z2 = y2 - q3 * z3;
    const double z1 = y1 - q2 * z2;
    const int stable = q1 > 0.0 && q2 > 0.0 && q3 > 0.0 && q4 > 0.0 && q5 > 0.0 && q6 > 0.0 && q7 > 0.0
        && q8 > 0.0 && q9 > 0.0 && q10 > 0.0 && q11 > 0.0 && q12 > 0.0 && q13 > 0.0 && q14 > 0.0;
    return stable ? (q1 * z1 - y0) / (2.0 * a[0]) : NAN;
}
