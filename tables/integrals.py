# I_n = (1/2 pi) integral of G(jw) / (H(jw) H(-jw)) dw over all w,
# H(s) = a0 s^n + a1 s^(n-1) + ... + an with all roots in the left half plane,
# G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).
# The ratio of the published determinants, by Routh's rows.
# Where H is not stable: not a number, or ZeroDivisionError.
# Relative error measured at 2000 random points an order, damping ratios from 0.2, terms of G of
# one sign: at most 4e-15 up to order 10 and 2e-14 up to order 14. Elsewhere it grows with the
# condition of the integral; `gyrospec integral` gives all digits and a bound for any H and G.
# Written by `gyrospec table`.
import math


def i1(a, b):
    """I_1 from a0 ... a1 and b0 ... b0."""
    q1 = a[0] / a[1]
    y0 = b[0] / a[1]
    stable = (q1 > 0.0)
    return y0 / (2.0 * a[0]) if stable else math.nan

def i2(a, b):
    """I_2 from a0 ... a2 and b0 ... b1."""
    q1 = a[0] / a[1]
    q2 = a[1] / a[2]
    y0 = b[0] / a[1]
    y1 = b[1] / a[2]
    stable = (q1 > 0.0 and q2 > 0.0)
    return (q1 * y1 - y0) / (2.0 * a[0]) if stable else math.nan

def i3(a, b):
    """I_3 from a0 ... a3 and b0 ... b2."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    q2 = a[1] / r2_0
    q3 = r2_0 / a[3]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = b[2] / a[3]
    z1 = y1 - q2 * y2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0)
    return (y0 - q1 * z1) / (2.0 * a[0]) if stable else math.nan

def i4(a, b):
    """I_4 from a0 ... a4 and b0 ... b3."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * a[4]
    q3 = r2_0 / r3_0
    q4 = r3_0 / a[4]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[4] * y1) / r3_0
    y3 = b[3] / a[4]
    z2 = y2 - q3 * y3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0)
    return (q1 * z1 - y0) / (2.0 * a[0]) if stable else math.nan

def i5(a, b):
    """I_5 from a0 ... a5 and b0 ... b4."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * a[5]
    q4 = r3_0 / r4_0
    q5 = r4_0 / a[5]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[5] * y2) / r4_0
    y4 = b[4] / a[5]
    z3 = y3 - q4 * y4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0)
    return (y0 - q1 * z1) / (2.0 * a[0]) if stable else math.nan

def i6(a, b):
    """I_6 from a0 ... a6 and b0 ... b5."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * a[6]
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * a[6]
    q5 = r4_0 / r5_0
    q6 = r5_0 / a[6]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[6] * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[6] * y3) / r5_0
    y5 = b[5] / a[6]
    z4 = y4 - q5 * y5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0)
    return (q1 * z1 - y0) / (2.0 * a[0]) if stable else math.nan

def i7(a, b):
    """I_7 from a0 ... a7 and b0 ... b6."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * a[7]
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * a[7]
    q6 = r5_0 / r6_0
    q7 = r6_0 / a[7]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[7] * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[7] * y4) / r6_0
    y6 = b[6] / a[7]
    z5 = y5 - q6 * y6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0)
    return (y0 - q1 * z1) / (2.0 * a[0]) if stable else math.nan

def i8(a, b):
    """I_8 from a0 ... a8 and b0 ... b7."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * a[8]
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * a[8]
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * a[8]
    q7 = r6_0 / r7_0
    q8 = r7_0 / a[8]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[8] * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[8] * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[8] * y5) / r7_0
    y7 = b[7] / a[8]
    z6 = y6 - q7 * y7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0)
    return (q1 * z1 - y0) / (2.0 * a[0]) if stable else math.nan

def i9(a, b):
    """I_9 from a0 ... a9 and b0 ... b8."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    r2_3 = a[8] - q1 * a[9]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * r2_3
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    r4_2 = r2_3 - q3 * a[9]
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * r4_2
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    r6_1 = r4_2 - q5 * a[9]
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * r6_1
    q7 = r6_0 / r7_0
    r8_0 = r6_1 - q7 * a[9]
    q8 = r7_0 / r8_0
    q9 = r8_0 / a[9]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[9] * y2 - r4_2 * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[9] * y4 - r6_1 * y5) / r7_0
    y7 = (b[7] - a[9] * y6) / r8_0
    y8 = b[8] / a[9]
    z7 = y7 - q8 * y8
    z6 = y6 - q7 * z7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0 and q9 > 0.0)
    return (y0 - q1 * z1) / (2.0 * a[0]) if stable else math.nan

def i10(a, b):
    """I_10 from a0 ... a10 and b0 ... b9."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    r2_3 = a[8] - q1 * a[9]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * r2_3
    r3_3 = a[9] - q2 * a[10]
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    r4_2 = r2_3 - q3 * r3_3
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * r4_2
    r5_2 = r3_3 - q4 * a[10]
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    r6_1 = r4_2 - q5 * r5_2
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * r6_1
    r7_1 = r5_2 - q6 * a[10]
    q7 = r6_0 / r7_0
    r8_0 = r6_1 - q7 * r7_1
    q8 = r7_0 / r8_0
    r9_0 = r7_1 - q8 * a[10]
    q9 = r8_0 / r9_0
    q10 = r9_0 / a[10]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[10] * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[10] * y3 - r5_2 * y4 - r6_1 * y5) / r7_0
    y7 = (b[7] - a[10] * y5 - r7_1 * y6) / r8_0
    y8 = (b[8] - a[10] * y7) / r9_0
    y9 = b[9] / a[10]
    z8 = y8 - q9 * y9
    z7 = y7 - q8 * z8
    z6 = y6 - q7 * z7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0 and q9 > 0.0 and q10 > 0.0)
    return (q1 * z1 - y0) / (2.0 * a[0]) if stable else math.nan

def i11(a, b):
    """I_11 from a0 ... a11 and b0 ... b10."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    r2_3 = a[8] - q1 * a[9]
    r2_4 = a[10] - q1 * a[11]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * r2_3
    r3_3 = a[9] - q2 * r2_4
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    r4_2 = r2_3 - q3 * r3_3
    r4_3 = r2_4 - q3 * a[11]
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * r4_2
    r5_2 = r3_3 - q4 * r4_3
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    r6_1 = r4_2 - q5 * r5_2
    r6_2 = r4_3 - q5 * a[11]
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * r6_1
    r7_1 = r5_2 - q6 * r6_2
    q7 = r6_0 / r7_0
    r8_0 = r6_1 - q7 * r7_1
    r8_1 = r6_2 - q7 * a[11]
    q8 = r7_0 / r8_0
    r9_0 = r7_1 - q8 * r8_1
    q9 = r8_0 / r9_0
    r10_0 = r8_1 - q9 * a[11]
    q10 = r9_0 / r10_0
    q11 = r10_0 / a[11]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[11] * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0
    y7 = (b[7] - a[11] * y4 - r6_2 * y5 - r7_1 * y6) / r8_0
    y8 = (b[8] - a[11] * y6 - r8_1 * y7) / r9_0
    y9 = (b[9] - a[11] * y8) / r10_0
    y10 = b[10] / a[11]
    z9 = y9 - q10 * y10
    z8 = y8 - q9 * z9
    z7 = y7 - q8 * z8
    z6 = y6 - q7 * z7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0 and q9 > 0.0 and q10 > 0.0 and q11 > 0.0)
    return (y0 - q1 * z1) / (2.0 * a[0]) if stable else math.nan

def i12(a, b):
    """I_12 from a0 ... a12 and b0 ... b11."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    r2_3 = a[8] - q1 * a[9]
    r2_4 = a[10] - q1 * a[11]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * r2_3
    r3_3 = a[9] - q2 * r2_4
    r3_4 = a[11] - q2 * a[12]
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    r4_2 = r2_3 - q3 * r3_3
    r4_3 = r2_4 - q3 * r3_4
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * r4_2
    r5_2 = r3_3 - q4 * r4_3
    r5_3 = r3_4 - q4 * a[12]
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    r6_1 = r4_2 - q5 * r5_2
    r6_2 = r4_3 - q5 * r5_3
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * r6_1
    r7_1 = r5_2 - q6 * r6_2
    r7_2 = r5_3 - q6 * a[12]
    q7 = r6_0 / r7_0
    r8_0 = r6_1 - q7 * r7_1
    r8_1 = r6_2 - q7 * r7_2
    q8 = r7_0 / r8_0
    r9_0 = r7_1 - q8 * r8_1
    r9_1 = r7_2 - q8 * a[12]
    q9 = r8_0 / r9_0
    r10_0 = r8_1 - q9 * r9_1
    q10 = r9_0 / r10_0
    r11_0 = r9_1 - q10 * a[12]
    q11 = r10_0 / r11_0
    q12 = r11_0 / a[12]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[12] * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0
    y7 = (b[7] - a[12] * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0
    y8 = (b[8] - a[12] * y5 - r7_2 * y6 - r8_1 * y7) / r9_0
    y9 = (b[9] - a[12] * y7 - r9_1 * y8) / r10_0
    y10 = (b[10] - a[12] * y9) / r11_0
    y11 = b[11] / a[12]
    z10 = y10 - q11 * y11
    z9 = y9 - q10 * z10
    z8 = y8 - q9 * z9
    z7 = y7 - q8 * z8
    z6 = y6 - q7 * z7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0 and q9 > 0.0 and q10 > 0.0 and q11 > 0.0 and q12 > 0.0)
    return (q1 * z1 - y0) / (2.0 * a[0]) if stable else math.nan

def i13(a, b):
    """I_13 from a0 ... a13 and b0 ... b12."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    r2_3 = a[8] - q1 * a[9]
    r2_4 = a[10] - q1 * a[11]
    r2_5 = a[12] - q1 * a[13]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * r2_3
    r3_3 = a[9] - q2 * r2_4
    r3_4 = a[11] - q2 * r2_5
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    r4_2 = r2_3 - q3 * r3_3
    r4_3 = r2_4 - q3 * r3_4
    r4_4 = r2_5 - q3 * a[13]
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * r4_2
    r5_2 = r3_3 - q4 * r4_3
    r5_3 = r3_4 - q4 * r4_4
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    r6_1 = r4_2 - q5 * r5_2
    r6_2 = r4_3 - q5 * r5_3
    r6_3 = r4_4 - q5 * a[13]
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * r6_1
    r7_1 = r5_2 - q6 * r6_2
    r7_2 = r5_3 - q6 * r6_3
    q7 = r6_0 / r7_0
    r8_0 = r6_1 - q7 * r7_1
    r8_1 = r6_2 - q7 * r7_2
    r8_2 = r6_3 - q7 * a[13]
    q8 = r7_0 / r8_0
    r9_0 = r7_1 - q8 * r8_1
    r9_1 = r7_2 - q8 * r8_2
    q9 = r8_0 / r9_0
    r10_0 = r8_1 - q9 * r9_1
    r10_1 = r8_2 - q9 * a[13]
    q10 = r9_0 / r10_0
    r11_0 = r9_1 - q10 * r10_1
    q11 = r10_0 / r11_0
    r12_0 = r10_1 - q11 * a[13]
    q12 = r11_0 / r12_0
    q13 = r12_0 / a[13]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[13] * y0 - r2_5 * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0
    y7 = (b[7] - a[13] * y2 - r4_4 * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0
    y8 = (b[8] - a[13] * y4 - r6_3 * y5 - r7_2 * y6 - r8_1 * y7) / r9_0
    y9 = (b[9] - a[13] * y6 - r8_2 * y7 - r9_1 * y8) / r10_0
    y10 = (b[10] - a[13] * y8 - r10_1 * y9) / r11_0
    y11 = (b[11] - a[13] * y10) / r12_0
    y12 = b[12] / a[13]
    z11 = y11 - q12 * y12
    z10 = y10 - q11 * z11
    z9 = y9 - q10 * z10
    z8 = y8 - q9 * z9
    z7 = y7 - q8 * z8
    z6 = y6 - q7 * z7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0 and q9 > 0.0 and q10 > 0.0 and q11 > 0.0 and q12 > 0.0 and q13 > 0.0)
    return (y0 - q1 * z1) / (2.0 * a[0]) if stable else math.nan

def i14(a, b):
    """I_14 from a0 ... a14 and b0 ... b13."""
    q1 = a[0] / a[1]
    r2_0 = a[2] - q1 * a[3]
    r2_1 = a[4] - q1 * a[5]
    r2_2 = a[6] - q1 * a[7]
    r2_3 = a[8] - q1 * a[9]
    r2_4 = a[10] - q1 * a[11]
    r2_5 = a[12] - q1 * a[13]
    q2 = a[1] / r2_0
    r3_0 = a[3] - q2 * r2_1
    r3_1 = a[5] - q2 * r2_2
    r3_2 = a[7] - q2 * r2_3
    r3_3 = a[9] - q2 * r2_4
    r3_4 = a[11] - q2 * r2_5
    r3_5 = a[13] - q2 * a[14]
    q3 = r2_0 / r3_0
    r4_0 = r2_1 - q3 * r3_1
    r4_1 = r2_2 - q3 * r3_2
    r4_2 = r2_3 - q3 * r3_3
    r4_3 = r2_4 - q3 * r3_4
    r4_4 = r2_5 - q3 * r3_5
    q4 = r3_0 / r4_0
    r5_0 = r3_1 - q4 * r4_1
    r5_1 = r3_2 - q4 * r4_2
    r5_2 = r3_3 - q4 * r4_3
    r5_3 = r3_4 - q4 * r4_4
    r5_4 = r3_5 - q4 * a[14]
    q5 = r4_0 / r5_0
    r6_0 = r4_1 - q5 * r5_1
    r6_1 = r4_2 - q5 * r5_2
    r6_2 = r4_3 - q5 * r5_3
    r6_3 = r4_4 - q5 * r5_4
    q6 = r5_0 / r6_0
    r7_0 = r5_1 - q6 * r6_1
    r7_1 = r5_2 - q6 * r6_2
    r7_2 = r5_3 - q6 * r6_3
    r7_3 = r5_4 - q6 * a[14]
    q7 = r6_0 / r7_0
    r8_0 = r6_1 - q7 * r7_1
    r8_1 = r6_2 - q7 * r7_2
    r8_2 = r6_3 - q7 * r7_3
    q8 = r7_0 / r8_0
    r9_0 = r7_1 - q8 * r8_1
    r9_1 = r7_2 - q8 * r8_2
    r9_2 = r7_3 - q8 * a[14]
    q9 = r8_0 / r9_0
    r10_0 = r8_1 - q9 * r9_1
    r10_1 = r8_2 - q9 * r9_2
    q10 = r9_0 / r10_0
    r11_0 = r9_1 - q10 * r10_1
    r11_1 = r9_2 - q10 * a[14]
    q11 = r10_0 / r11_0
    r12_0 = r10_1 - q11 * r11_1
    q12 = r11_0 / r12_0
    r13_0 = r11_1 - q12 * a[14]
    q13 = r12_0 / r13_0
    q14 = r13_0 / a[14]
    y0 = b[0] / a[1]
    y1 = (b[1] - a[3] * y0) / r2_0
    y2 = (b[2] - a[5] * y0 - r2_1 * y1) / r3_0
    y3 = (b[3] - a[7] * y0 - r2_2 * y1 - r3_1 * y2) / r4_0
    y4 = (b[4] - a[9] * y0 - r2_3 * y1 - r3_2 * y2 - r4_1 * y3) / r5_0
    y5 = (b[5] - a[11] * y0 - r2_4 * y1 - r3_3 * y2 - r4_2 * y3 - r5_1 * y4) / r6_0
    y6 = (b[6] - a[13] * y0 - r2_5 * y1 - r3_4 * y2 - r4_3 * y3 - r5_2 * y4 - r6_1 * y5) / r7_0
    y7 = (b[7] - a[14] * y1 - r3_5 * y2 - r4_4 * y3 - r5_3 * y4 - r6_2 * y5 - r7_1 * y6) / r8_0
    y8 = (b[8] - a[14] * y3 - r5_4 * y4 - r6_3 * y5 - r7_2 * y6 - r8_1 * y7) / r9_0
    y9 = (b[9] - a[14] * y5 - r7_3 * y6 - r8_2 * y7 - r9_1 * y8) / r10_0
    y10 = (b[10] - a[14] * y7 - r9_2 * y8 - r10_1 * y9) / r11_0
    y11 = (b[11] - a[14] * y9 - r11_1 * y10) / r12_0
    y12 = (b[12] - a[14] * y11) / r13_0
    y13 = b[13] / a[14]
    z12 = y12 - q13 * y13
    z11 = y11 - q12 * z12
    z10 = y10 - q11 * z11
    z9 = y9 - q10 * z10
    z8 = y8 - q9 * z9
    z7 = y7 - q8 * z8
    z6 = y6 - q7 * z7
    z5 = y5 - q6 * z6
    z4 = y4 - q5 * z5
    z3 = y3 - q4 * z4
    z2 = y2 - q3 * z3
    z1 = y1 - q2 * z2
    stable = (q1 > 0.0 and q2 > 0.0 and q3 > 0.0 and q4 > 0.0 and q5 > 0.0 and q6 > 0.0 and q7 > 0.0
            and q8 > 0.0 and q9 > 0.0 and q10 > 0.0 and q11 > 0.0 and q12 > 0.0 and q13 > 0.0 and q14 > 0.0)
    return (q1 * z1 - y0) / (2.0 * a[0]) if stable else math.nan
