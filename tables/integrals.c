/* I_n = (1/2 pi) integral of G(jw) / (H(jw) H(-jw)) dw over all w,
 * H(s) = a0 s^n + a1 s^(n-1) + ... + an with all roots in the left half plane,
 * G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).
 * The ratio of the published determinants, in shared minors; written by `gyrospec table`.
 */

double gyrospec_i1(const double a[2], const double b[1])
{
    const double determinant = a[1];
    const double numerator = b[0];
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i2(const double a[3], const double b[2])
{
    const double determinant = a[1] * a[2];
    const double numerator = -b[0] * a[2] + b[1] * a[0];
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i3(const double a[4], const double b[3])
{
    const double determinant = a[1] * a[2] * a[3] - a[3] * a[0] * a[3];
    const double numerator = b[0] * a[2] * a[3] - b[1] * a[0] * a[3] + b[2] * a[0] * a[1];
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i4(const double a[5], const double b[4])
{
    const double m0 = a[2] * a[3] * a[4] - a[4] * a[1] * a[4];
    const double m1 = a[1] * a[2] - a[3] * a[0];
    const double determinant = a[1] * m0 - a[3] * a[0] * a[3] * a[4];
    const double numerator = -b[0] * m0 + b[1] * a[0] * a[3] * a[4] - b[2] * a[0] * a[1] * a[4]
        + b[3] * a[0] * m1;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i5(const double a[6], const double b[5])
{
    const double m0 = a[3] * a[4] * a[5] - a[5] * a[2] * a[5];
    const double m1 = a[1] * a[4] * a[5] - a[5] * a[0] * a[5];
    const double m2 = a[2] * m0 - a[4] * m1;
    const double m3 = a[1] * a[2] * a[5] - a[3] * a[0] * a[5];
    const double m4 = a[2] * a[3] - a[4] * a[1];
    const double m5 = a[1] * m4 - a[3] * a[0] * a[3] + a[5] * a[0] * a[1];
    const double determinant = a[1] * m2 - a[3] * a[0] * m0 + a[5] * a[0] * m1;
    const double numerator = b[0] * m2 - b[1] * a[0] * m0 + b[2] * a[0] * m1 - b[3] * a[0] * m3
        + b[4] * a[0] * m5;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i6(const double a[7], const double b[6])
{
    const double m0 = a[4] * a[5] * a[6] - a[6] * a[3] * a[6];
    const double m1 = a[2] * a[5] * a[6] - a[6] * a[1] * a[6];
    const double m2 = a[3] * m0 - a[5] * m1;
    const double m3 = a[1] * m0 - a[5] * a[0] * a[5] * a[6];
    const double m4 = a[1] * m1 - a[3] * a[0] * a[5] * a[6];
    const double m5 = a[2] * m2 - a[4] * m3 + a[6] * m4;
    const double m6 = a[2] * a[3] * a[6] - a[4] * a[1] * a[6];
    const double m7 = a[1] * m6 - a[3] * a[0] * a[3] * a[6] + a[5] * a[0] * a[1] * a[6];
    const double m8 = a[3] * a[4] - a[5] * a[2];
    const double m9 = a[1] * a[4] - a[5] * a[0];
    const double m10 = a[1] * a[2] - a[3] * a[0];
    const double m11 = a[2] * m8 - a[4] * m9 + a[6] * m10;
    const double m12 = a[1] * m11 - a[3] * a[0] * m8 + a[5] * a[0] * m9;
    const double determinant = a[1] * m5 - a[3] * a[0] * m2 + a[5] * a[0] * m3;
    const double numerator = -b[0] * m5 + b[1] * a[0] * m2 - b[2] * a[0] * m3 + b[3] * a[0] * m4
        - b[4] * a[0] * m7 + b[5] * a[0] * m12;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i7(const double a[8], const double b[7])
{
    const double m0 = a[5] * a[6] * a[7] - a[7] * a[4] * a[7];
    const double m1 = a[3] * a[6] * a[7] - a[7] * a[2] * a[7];
    const double m2 = a[4] * m0 - a[6] * m1;
    const double m3 = a[1] * a[6] * a[7] - a[7] * a[0] * a[7];
    const double m4 = a[2] * m0 - a[6] * m3;
    const double m5 = a[2] * m1 - a[4] * m3;
    const double m6 = a[3] * m2 - a[5] * m4 + a[7] * m5;
    const double m7 = a[1] * m2 - a[5] * a[0] * m0 + a[7] * a[0] * m1;
    const double m8 = a[1] * m4 - a[3] * a[0] * m0 + a[7] * a[0] * m3;
    const double m9 = a[2] * m6 - a[4] * m7 + a[6] * m8;
    const double m10 = a[1] * m5 - a[3] * a[0] * m1 + a[5] * a[0] * m3;
    const double m11 = a[3] * a[4] * a[7] - a[5] * a[2] * a[7];
    const double m12 = a[1] * a[4] * a[7] - a[5] * a[0] * a[7];
    const double m13 = a[1] * a[2] * a[7] - a[3] * a[0] * a[7];
    const double m14 = a[2] * m11 - a[4] * m12 + a[6] * m13;
    const double m15 = a[1] * m14 - a[3] * a[0] * m11 + a[5] * a[0] * m12 - a[7] * a[0] * m13;
    const double m16 = a[4] * a[5] - a[6] * a[3];
    const double m17 = a[2] * a[5] - a[6] * a[1];
    const double m18 = a[2] * a[3] - a[4] * a[1];
    const double m19 = a[3] * m16 - a[5] * m17 + a[7] * m18;
    const double m20 = a[1] * m16 - a[5] * a[0] * a[5] + a[7] * a[0] * a[3];
    const double m21 = a[1] * m17 - a[3] * a[0] * a[5] + a[7] * a[0] * a[1];
    const double m22 = a[2] * m19 - a[4] * m20 + a[6] * m21;
    const double m23 = a[1] * m22 - a[3] * a[0] * m19 + a[5] * a[0] * m20 - a[7] * a[0] * m21;
    const double determinant = a[1] * m9 - a[3] * a[0] * m6 + a[5] * a[0] * m7 - a[7] * a[0] * m8;
    const double numerator = b[0] * m9 - b[1] * a[0] * m6 + b[2] * a[0] * m7 - b[3] * a[0] * m8
        + b[4] * a[0] * m10 - b[5] * a[0] * m15 + b[6] * a[0] * m23;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i8(const double a[9], const double b[8])
{
    const double m0 = a[6] * a[7] * a[8] - a[8] * a[5] * a[8];
    const double m1 = a[4] * a[7] * a[8] - a[8] * a[3] * a[8];
    const double m2 = a[5] * m0 - a[7] * m1;
    const double m3 = a[2] * a[7] * a[8] - a[8] * a[1] * a[8];
    const double m4 = a[3] * m0 - a[7] * m3;
    const double m5 = a[3] * m1 - a[5] * m3;
    const double m6 = a[4] * m2 - a[6] * m4 + a[8] * m5;
    const double m7 = a[1] * m0 - a[7] * a[0] * a[7] * a[8];
    const double m8 = a[1] * m1 - a[5] * a[0] * a[7] * a[8];
    const double m9 = a[2] * m2 - a[6] * m7 + a[8] * m8;
    const double m10 = a[1] * m3 - a[3] * a[0] * a[7] * a[8];
    const double m11 = a[2] * m4 - a[4] * m7 + a[8] * m10;
    const double m12 = a[3] * m6 - a[5] * m9 + a[7] * m11;
    const double m13 = a[1] * m6 - a[5] * a[0] * m2 + a[7] * a[0] * m4;
    const double m14 = a[1] * m9 - a[3] * a[0] * m2 + a[7] * a[0] * m7;
    const double m15 = a[1] * m11 - a[3] * a[0] * m4 + a[5] * a[0] * m7;
    const double m16 = a[2] * m12 - a[4] * m13 + a[6] * m14 - a[8] * m15;
    const double m17 = a[2] * m5 - a[4] * m8 + a[6] * m10;
    const double m18 = a[1] * m17 - a[3] * a[0] * m5 + a[5] * a[0] * m8 - a[7] * a[0] * m10;
    const double m19 = a[4] * a[5] * a[8] - a[6] * a[3] * a[8];
    const double m20 = a[2] * a[5] * a[8] - a[6] * a[1] * a[8];
    const double m21 = a[2] * a[3] * a[8] - a[4] * a[1] * a[8];
    const double m22 = a[3] * m19 - a[5] * m20 + a[7] * m21;
    const double m23 = a[1] * m19 - a[5] * a[0] * a[5] * a[8] + a[7] * a[0] * a[3] * a[8];
    const double m24 = a[1] * m20 - a[3] * a[0] * a[5] * a[8] + a[7] * a[0] * a[1] * a[8];
    const double m25 = a[1] * m21 - a[3] * a[0] * a[3] * a[8] + a[5] * a[0] * a[1] * a[8];
    const double m26 = a[2] * m22 - a[4] * m23 + a[6] * m24 - a[8] * m25;
    const double m27 = a[1] * m26 - a[3] * a[0] * m22 + a[5] * a[0] * m23 - a[7] * a[0] * m24;
    const double m28 = a[5] * a[6] - a[7] * a[4];
    const double m29 = a[3] * a[6] - a[7] * a[2];
    const double m30 = a[3] * a[4] - a[5] * a[2];
    const double m31 = a[4] * m28 - a[6] * m29 + a[8] * m30;
    const double m32 = a[1] * a[6] - a[7] * a[0];
    const double m33 = a[1] * a[4] - a[5] * a[0];
    const double m34 = a[2] * m28 - a[6] * m32 + a[8] * m33;
    const double m35 = a[1] * a[2] - a[3] * a[0];
    const double m36 = a[2] * m29 - a[4] * m32 + a[8] * m35;
    const double m37 = a[3] * m31 - a[5] * m34 + a[7] * m36;
    const double m38 = a[1] * m31 - a[5] * a[0] * m28 + a[7] * a[0] * m29;
    const double m39 = a[1] * m34 - a[3] * a[0] * m28 + a[7] * a[0] * m32;
    const double m40 = a[1] * m36 - a[3] * a[0] * m29 + a[5] * a[0] * m32;
    const double m41 = a[2] * m37 - a[4] * m38 + a[6] * m39 - a[8] * m40;
    const double m42 = a[1] * m41 - a[3] * a[0] * m37 + a[5] * a[0] * m38 - a[7] * a[0] * m39;
    const double determinant = a[1] * m16 - a[3] * a[0] * m12 + a[5] * a[0] * m13 - a[7] * a[0] * m14;
    const double numerator = -b[0] * m16 + b[1] * a[0] * m12 - b[2] * a[0] * m13 + b[3] * a[0] * m14
        - b[4] * a[0] * m15 + b[5] * a[0] * m18 - b[6] * a[0] * m27 + b[7] * a[0] * m42;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i9(const double a[10], const double b[9])
{
    const double m0 = a[7] * a[8] * a[9] - a[9] * a[6] * a[9];
    const double m1 = a[5] * a[8] * a[9] - a[9] * a[4] * a[9];
    const double m2 = a[6] * m0 - a[8] * m1;
    const double m3 = a[3] * a[8] * a[9] - a[9] * a[2] * a[9];
    const double m4 = a[4] * m0 - a[8] * m3;
    const double m5 = a[4] * m1 - a[6] * m3;
    const double m6 = a[5] * m2 - a[7] * m4 + a[9] * m5;
    const double m7 = a[1] * a[8] * a[9] - a[9] * a[0] * a[9];
    const double m8 = a[2] * m0 - a[8] * m7;
    const double m9 = a[2] * m1 - a[6] * m7;
    const double m10 = a[3] * m2 - a[7] * m8 + a[9] * m9;
    const double m11 = a[2] * m3 - a[4] * m7;
    const double m12 = a[3] * m4 - a[5] * m8 + a[9] * m11;
    const double m13 = a[4] * m6 - a[6] * m10 + a[8] * m12;
    const double m14 = a[1] * m2 - a[7] * a[0] * m0 + a[9] * a[0] * m1;
    const double m15 = a[1] * m4 - a[5] * a[0] * m0 + a[9] * a[0] * m3;
    const double m16 = a[2] * m6 - a[6] * m14 + a[8] * m15;
    const double m17 = a[1] * m8 - a[3] * a[0] * m0 + a[9] * a[0] * m7;
    const double m18 = a[2] * m10 - a[4] * m14 + a[8] * m17;
    const double m19 = a[2] * m12 - a[4] * m15 + a[6] * m17;
    const double m20 = a[3] * m13 - a[5] * m16 + a[7] * m18 - a[9] * m19;
    const double m21 = a[1] * m13 - a[5] * a[0] * m6 + a[7] * a[0] * m10 - a[9] * a[0] * m12;
    const double m22 = a[1] * m16 - a[3] * a[0] * m6 + a[7] * a[0] * m14 - a[9] * a[0] * m15;
    const double m23 = a[1] * m18 - a[3] * a[0] * m10 + a[5] * a[0] * m14 - a[9] * a[0] * m17;
    const double m24 = a[2] * m20 - a[4] * m21 + a[6] * m22 - a[8] * m23;
    const double m25 = a[1] * m19 - a[3] * a[0] * m12 + a[5] * a[0] * m15 - a[7] * a[0] * m17;
    const double m26 = a[3] * m5 - a[5] * m9 + a[7] * m11;
    const double m27 = a[1] * m5 - a[5] * a[0] * m1 + a[7] * a[0] * m3;
    const double m28 = a[1] * m9 - a[3] * a[0] * m1 + a[7] * a[0] * m7;
    const double m29 = a[1] * m11 - a[3] * a[0] * m3 + a[5] * a[0] * m7;
    const double m30 = a[2] * m26 - a[4] * m27 + a[6] * m28 - a[8] * m29;
    const double m31 = a[1] * m30 - a[3] * a[0] * m26 + a[5] * a[0] * m27 - a[7] * a[0] * m28
        + a[9] * a[0] * m29;
    const double m32 = a[5] * a[6] * a[9] - a[7] * a[4] * a[9];
    const double m33 = a[3] * a[6] * a[9] - a[7] * a[2] * a[9];
    const double m34 = a[3] * a[4] * a[9] - a[5] * a[2] * a[9];
    const double m35 = a[4] * m32 - a[6] * m33 + a[8] * m34;
    const double m36 = a[1] * a[6] * a[9] - a[7] * a[0] * a[9];
    const double m37 = a[1] * a[4] * a[9] - a[5] * a[0] * a[9];
    const double m38 = a[2] * m32 - a[6] * m36 + a[8] * m37;
    const double m39 = a[1] * a[2] * a[9] - a[3] * a[0] * a[9];
    const double m40 = a[2] * m33 - a[4] * m36 + a[8] * m39;
    const double m41 = a[2] * m34 - a[4] * m37 + a[6] * m39;
    const double m42 = a[3] * m35 - a[5] * m38 + a[7] * m40 - a[9] * m41;
    const double m43 = a[1] * m35 - a[5] * a[0] * m32 + a[7] * a[0] * m33 - a[9] * a[0] * m34;
    const double m44 = a[1] * m38 - a[3] * a[0] * m32 + a[7] * a[0] * m36 - a[9] * a[0] * m37;
    const double m45 = a[1] * m40 - a[3] * a[0] * m33 + a[5] * a[0] * m36 - a[9] * a[0] * m39;
    const double m46 = a[2] * m42 - a[4] * m43 + a[6] * m44 - a[8] * m45;
    const double m47 = a[1] * m46 - a[3] * a[0] * m42 + a[5] * a[0] * m43 - a[7] * a[0] * m44
        + a[9] * a[0] * m45;
    const double m48 = a[6] * a[7] - a[8] * a[5];
    const double m49 = a[4] * a[7] - a[8] * a[3];
    const double m50 = a[4] * a[5] - a[6] * a[3];
    const double m51 = a[5] * m48 - a[7] * m49 + a[9] * m50;
    const double m52 = a[2] * a[7] - a[8] * a[1];
    const double m53 = a[2] * a[5] - a[6] * a[1];
    const double m54 = a[3] * m48 - a[7] * m52 + a[9] * m53;
    const double m55 = a[2] * a[3] - a[4] * a[1];
    const double m56 = a[3] * m49 - a[5] * m52 + a[9] * m55;
    const double m57 = a[4] * m51 - a[6] * m54 + a[8] * m56;
    const double m58 = a[1] * m48 - a[7] * a[0] * a[7] + a[9] * a[0] * a[5];
    const double m59 = a[1] * m49 - a[5] * a[0] * a[7] + a[9] * a[0] * a[3];
    const double m60 = a[2] * m51 - a[6] * m58 + a[8] * m59;
    const double m61 = a[1] * m52 - a[3] * a[0] * a[7] + a[9] * a[0] * a[1];
    const double m62 = a[2] * m54 - a[4] * m58 + a[8] * m61;
    const double m63 = a[2] * m56 - a[4] * m59 + a[6] * m61;
    const double m64 = a[3] * m57 - a[5] * m60 + a[7] * m62 - a[9] * m63;
    const double m65 = a[1] * m57 - a[5] * a[0] * m51 + a[7] * a[0] * m54 - a[9] * a[0] * m56;
    const double m66 = a[1] * m60 - a[3] * a[0] * m51 + a[7] * a[0] * m58 - a[9] * a[0] * m59;
    const double m67 = a[1] * m62 - a[3] * a[0] * m54 + a[5] * a[0] * m58 - a[9] * a[0] * m61;
    const double m68 = a[2] * m64 - a[4] * m65 + a[6] * m66 - a[8] * m67;
    const double m69 = a[1] * m68 - a[3] * a[0] * m64 + a[5] * a[0] * m65 - a[7] * a[0] * m66
        + a[9] * a[0] * m67;
    const double determinant = a[1] * m24 - a[3] * a[0] * m20 + a[5] * a[0] * m21 - a[7] * a[0] * m22
        + a[9] * a[0] * m23;
    const double numerator = b[0] * m24 - b[1] * a[0] * m20 + b[2] * a[0] * m21 - b[3] * a[0] * m22
        + b[4] * a[0] * m23 - b[5] * a[0] * m25 + b[6] * a[0] * m31 - b[7] * a[0] * m47
        + b[8] * a[0] * m69;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i10(const double a[11], const double b[10])
{
    const double m0 = a[8] * a[9] * a[10] - a[10] * a[7] * a[10];
    const double m1 = a[6] * a[9] * a[10] - a[10] * a[5] * a[10];
    const double m2 = a[7] * m0 - a[9] * m1;
    const double m3 = a[4] * a[9] * a[10] - a[10] * a[3] * a[10];
    const double m4 = a[5] * m0 - a[9] * m3;
    const double m5 = a[5] * m1 - a[7] * m3;
    const double m6 = a[6] * m2 - a[8] * m4 + a[10] * m5;
    const double m7 = a[2] * a[9] * a[10] - a[10] * a[1] * a[10];
    const double m8 = a[3] * m0 - a[9] * m7;
    const double m9 = a[3] * m1 - a[7] * m7;
    const double m10 = a[4] * m2 - a[8] * m8 + a[10] * m9;
    const double m11 = a[3] * m3 - a[5] * m7;
    const double m12 = a[4] * m4 - a[6] * m8 + a[10] * m11;
    const double m13 = a[5] * m6 - a[7] * m10 + a[9] * m12;
    const double m14 = a[1] * m0 - a[9] * a[0] * a[9] * a[10];
    const double m15 = a[1] * m1 - a[7] * a[0] * a[9] * a[10];
    const double m16 = a[2] * m2 - a[8] * m14 + a[10] * m15;
    const double m17 = a[1] * m3 - a[5] * a[0] * a[9] * a[10];
    const double m18 = a[2] * m4 - a[6] * m14 + a[10] * m17;
    const double m19 = a[3] * m6 - a[7] * m16 + a[9] * m18;
    const double m20 = a[1] * m7 - a[3] * a[0] * a[9] * a[10];
    const double m21 = a[2] * m8 - a[4] * m14 + a[10] * m20;
    const double m22 = a[3] * m10 - a[5] * m16 + a[9] * m21;
    const double m23 = a[3] * m12 - a[5] * m18 + a[7] * m21;
    const double m24 = a[4] * m13 - a[6] * m19 + a[8] * m22 - a[10] * m23;
    const double m25 = a[1] * m6 - a[7] * a[0] * m2 + a[9] * a[0] * m4;
    const double m26 = a[1] * m10 - a[5] * a[0] * m2 + a[9] * a[0] * m8;
    const double m27 = a[1] * m12 - a[5] * a[0] * m4 + a[7] * a[0] * m8;
    const double m28 = a[2] * m13 - a[6] * m25 + a[8] * m26 - a[10] * m27;
    const double m29 = a[1] * m16 - a[3] * a[0] * m2 + a[9] * a[0] * m14;
    const double m30 = a[1] * m18 - a[3] * a[0] * m4 + a[7] * a[0] * m14;
    const double m31 = a[2] * m19 - a[4] * m25 + a[8] * m29 - a[10] * m30;
    const double m32 = a[1] * m21 - a[3] * a[0] * m8 + a[5] * a[0] * m14;
    const double m33 = a[2] * m22 - a[4] * m26 + a[6] * m29 - a[10] * m32;
    const double m34 = a[3] * m24 - a[5] * m28 + a[7] * m31 - a[9] * m33;
    const double m35 = a[1] * m24 - a[5] * a[0] * m13 + a[7] * a[0] * m19 - a[9] * a[0] * m22;
    const double m36 = a[1] * m28 - a[3] * a[0] * m13 + a[7] * a[0] * m25 - a[9] * a[0] * m26;
    const double m37 = a[1] * m31 - a[3] * a[0] * m19 + a[5] * a[0] * m25 - a[9] * a[0] * m29;
    const double m38 = a[1] * m33 - a[3] * a[0] * m22 + a[5] * a[0] * m26 - a[7] * a[0] * m29;
    const double m39 = a[2] * m34 - a[4] * m35 + a[6] * m36 - a[8] * m37 + a[10] * m38;
    const double m40 = a[2] * m23 - a[4] * m27 + a[6] * m30 - a[8] * m32;
    const double m41 = a[1] * m40 - a[3] * a[0] * m23 + a[5] * a[0] * m27 - a[7] * a[0] * m30
        + a[9] * a[0] * m32;
    const double m42 = a[4] * m5 - a[6] * m9 + a[8] * m11;
    const double m43 = a[2] * m5 - a[6] * m15 + a[8] * m17;
    const double m44 = a[2] * m9 - a[4] * m15 + a[8] * m20;
    const double m45 = a[2] * m11 - a[4] * m17 + a[6] * m20;
    const double m46 = a[3] * m42 - a[5] * m43 + a[7] * m44 - a[9] * m45;
    const double m47 = a[1] * m42 - a[5] * a[0] * m5 + a[7] * a[0] * m9 - a[9] * a[0] * m11;
    const double m48 = a[1] * m43 - a[3] * a[0] * m5 + a[7] * a[0] * m15 - a[9] * a[0] * m17;
    const double m49 = a[1] * m44 - a[3] * a[0] * m9 + a[5] * a[0] * m15 - a[9] * a[0] * m20;
    const double m50 = a[1] * m45 - a[3] * a[0] * m11 + a[5] * a[0] * m17 - a[7] * a[0] * m20;
    const double m51 = a[2] * m46 - a[4] * m47 + a[6] * m48 - a[8] * m49 + a[10] * m50;
    const double m52 = a[1] * m51 - a[3] * a[0] * m46 + a[5] * a[0] * m47 - a[7] * a[0] * m48
        + a[9] * a[0] * m49;
    const double m53 = a[6] * a[7] * a[10] - a[8] * a[5] * a[10];
    const double m54 = a[4] * a[7] * a[10] - a[8] * a[3] * a[10];
    const double m55 = a[4] * a[5] * a[10] - a[6] * a[3] * a[10];
    const double m56 = a[5] * m53 - a[7] * m54 + a[9] * m55;
    const double m57 = a[2] * a[7] * a[10] - a[8] * a[1] * a[10];
    const double m58 = a[2] * a[5] * a[10] - a[6] * a[1] * a[10];
    const double m59 = a[3] * m53 - a[7] * m57 + a[9] * m58;
    const double m60 = a[2] * a[3] * a[10] - a[4] * a[1] * a[10];
    const double m61 = a[3] * m54 - a[5] * m57 + a[9] * m60;
    const double m62 = a[3] * m55 - a[5] * m58 + a[7] * m60;
    const double m63 = a[4] * m56 - a[6] * m59 + a[8] * m61 - a[10] * m62;
    const double m64 = a[1] * m53 - a[7] * a[0] * a[7] * a[10] + a[9] * a[0] * a[5] * a[10];
    const double m65 = a[1] * m54 - a[5] * a[0] * a[7] * a[10] + a[9] * a[0] * a[3] * a[10];
    const double m66 = a[1] * m55 - a[5] * a[0] * a[5] * a[10] + a[7] * a[0] * a[3] * a[10];
    const double m67 = a[2] * m56 - a[6] * m64 + a[8] * m65 - a[10] * m66;
    const double m68 = a[1] * m57 - a[3] * a[0] * a[7] * a[10] + a[9] * a[0] * a[1] * a[10];
    const double m69 = a[1] * m58 - a[3] * a[0] * a[5] * a[10] + a[7] * a[0] * a[1] * a[10];
    const double m70 = a[2] * m59 - a[4] * m64 + a[8] * m68 - a[10] * m69;
    const double m71 = a[1] * m60 - a[3] * a[0] * a[3] * a[10] + a[5] * a[0] * a[1] * a[10];
    const double m72 = a[2] * m61 - a[4] * m65 + a[6] * m68 - a[10] * m71;
    const double m73 = a[3] * m63 - a[5] * m67 + a[7] * m70 - a[9] * m72;
    const double m74 = a[1] * m63 - a[5] * a[0] * m56 + a[7] * a[0] * m59 - a[9] * a[0] * m61;
    const double m75 = a[1] * m67 - a[3] * a[0] * m56 + a[7] * a[0] * m64 - a[9] * a[0] * m65;
    const double m76 = a[1] * m70 - a[3] * a[0] * m59 + a[5] * a[0] * m64 - a[9] * a[0] * m68;
    const double m77 = a[1] * m72 - a[3] * a[0] * m61 + a[5] * a[0] * m65 - a[7] * a[0] * m68;
    const double m78 = a[2] * m73 - a[4] * m74 + a[6] * m75 - a[8] * m76 + a[10] * m77;
    const double m79 = a[1] * m78 - a[3] * a[0] * m73 + a[5] * a[0] * m74 - a[7] * a[0] * m75
        + a[9] * a[0] * m76;
    const double m80 = a[7] * a[8] - a[9] * a[6];
    const double m81 = a[5] * a[8] - a[9] * a[4];
    const double m82 = a[5] * a[6] - a[7] * a[4];
    const double m83 = a[6] * m80 - a[8] * m81 + a[10] * m82;
    const double m84 = a[3] * a[8] - a[9] * a[2];
    const double m85 = a[3] * a[6] - a[7] * a[2];
    const double m86 = a[4] * m80 - a[8] * m84 + a[10] * m85;
    const double m87 = a[3] * a[4] - a[5] * a[2];
    const double m88 = a[4] * m81 - a[6] * m84 + a[10] * m87;
    const double m89 = a[5] * m83 - a[7] * m86 + a[9] * m88;
    const double m90 = a[1] * a[8] - a[9] * a[0];
    const double m91 = a[1] * a[6] - a[7] * a[0];
    const double m92 = a[2] * m80 - a[8] * m90 + a[10] * m91;
    const double m93 = a[1] * a[4] - a[5] * a[0];
    const double m94 = a[2] * m81 - a[6] * m90 + a[10] * m93;
    const double m95 = a[3] * m83 - a[7] * m92 + a[9] * m94;
    const double m96 = a[1] * a[2] - a[3] * a[0];
    const double m97 = a[2] * m84 - a[4] * m90 + a[10] * m96;
    const double m98 = a[3] * m86 - a[5] * m92 + a[9] * m97;
    const double m99 = a[3] * m88 - a[5] * m94 + a[7] * m97;
    const double m100 = a[4] * m89 - a[6] * m95 + a[8] * m98 - a[10] * m99;
    const double m101 = a[1] * m83 - a[7] * a[0] * m80 + a[9] * a[0] * m81;
    const double m102 = a[1] * m86 - a[5] * a[0] * m80 + a[9] * a[0] * m84;
    const double m103 = a[1] * m88 - a[5] * a[0] * m81 + a[7] * a[0] * m84;
    const double m104 = a[2] * m89 - a[6] * m101 + a[8] * m102 - a[10] * m103;
    const double m105 = a[1] * m92 - a[3] * a[0] * m80 + a[9] * a[0] * m90;
    const double m106 = a[1] * m94 - a[3] * a[0] * m81 + a[7] * a[0] * m90;
    const double m107 = a[2] * m95 - a[4] * m101 + a[8] * m105 - a[10] * m106;
    const double m108 = a[1] * m97 - a[3] * a[0] * m84 + a[5] * a[0] * m90;
    const double m109 = a[2] * m98 - a[4] * m102 + a[6] * m105 - a[10] * m108;
    const double m110 = a[3] * m100 - a[5] * m104 + a[7] * m107 - a[9] * m109;
    const double m111 = a[1] * m100 - a[5] * a[0] * m89 + a[7] * a[0] * m95 - a[9] * a[0] * m98;
    const double m112 = a[1] * m104 - a[3] * a[0] * m89 + a[7] * a[0] * m101 - a[9] * a[0] * m102;
    const double m113 = a[1] * m107 - a[3] * a[0] * m95 + a[5] * a[0] * m101 - a[9] * a[0] * m105;
    const double m114 = a[1] * m109 - a[3] * a[0] * m98 + a[5] * a[0] * m102 - a[7] * a[0] * m105;
    const double m115 = a[2] * m110 - a[4] * m111 + a[6] * m112 - a[8] * m113 + a[10] * m114;
    const double m116 = a[1] * m115 - a[3] * a[0] * m110 + a[5] * a[0] * m111 - a[7] * a[0] * m112
        + a[9] * a[0] * m113;
    const double determinant = a[1] * m39 - a[3] * a[0] * m34 + a[5] * a[0] * m35 - a[7] * a[0] * m36
        + a[9] * a[0] * m37;
    const double numerator = -b[0] * m39 + b[1] * a[0] * m34 - b[2] * a[0] * m35 + b[3] * a[0] * m36
        - b[4] * a[0] * m37 + b[5] * a[0] * m38 - b[6] * a[0] * m41 + b[7] * a[0] * m52
        - b[8] * a[0] * m79 + b[9] * a[0] * m116;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i11(const double a[12], const double b[11])
{
    const double m0 = a[9] * a[10] * a[11] - a[11] * a[8] * a[11];
    const double m1 = a[7] * a[10] * a[11] - a[11] * a[6] * a[11];
    const double m2 = a[8] * m0 - a[10] * m1;
    const double m3 = a[5] * a[10] * a[11] - a[11] * a[4] * a[11];
    const double m4 = a[6] * m0 - a[10] * m3;
    const double m5 = a[6] * m1 - a[8] * m3;
    const double m6 = a[7] * m2 - a[9] * m4 + a[11] * m5;
    const double m7 = a[3] * a[10] * a[11] - a[11] * a[2] * a[11];
    const double m8 = a[4] * m0 - a[10] * m7;
    const double m9 = a[4] * m1 - a[8] * m7;
    const double m10 = a[5] * m2 - a[9] * m8 + a[11] * m9;
    const double m11 = a[4] * m3 - a[6] * m7;
    const double m12 = a[5] * m4 - a[7] * m8 + a[11] * m11;
    const double m13 = a[6] * m6 - a[8] * m10 + a[10] * m12;
    const double m14 = a[1] * a[10] * a[11] - a[11] * a[0] * a[11];
    const double m15 = a[2] * m0 - a[10] * m14;
    const double m16 = a[2] * m1 - a[8] * m14;
    const double m17 = a[3] * m2 - a[9] * m15 + a[11] * m16;
    const double m18 = a[2] * m3 - a[6] * m14;
    const double m19 = a[3] * m4 - a[7] * m15 + a[11] * m18;
    const double m20 = a[4] * m6 - a[8] * m17 + a[10] * m19;
    const double m21 = a[2] * m7 - a[4] * m14;
    const double m22 = a[3] * m8 - a[5] * m15 + a[11] * m21;
    const double m23 = a[4] * m10 - a[6] * m17 + a[10] * m22;
    const double m24 = a[4] * m12 - a[6] * m19 + a[8] * m22;
    const double m25 = a[5] * m13 - a[7] * m20 + a[9] * m23 - a[11] * m24;
    const double m26 = a[1] * m2 - a[9] * a[0] * m0 + a[11] * a[0] * m1;
    const double m27 = a[1] * m4 - a[7] * a[0] * m0 + a[11] * a[0] * m3;
    const double m28 = a[2] * m6 - a[8] * m26 + a[10] * m27;
    const double m29 = a[1] * m8 - a[5] * a[0] * m0 + a[11] * a[0] * m7;
    const double m30 = a[2] * m10 - a[6] * m26 + a[10] * m29;
    const double m31 = a[2] * m12 - a[6] * m27 + a[8] * m29;
    const double m32 = a[3] * m13 - a[7] * m28 + a[9] * m30 - a[11] * m31;
    const double m33 = a[1] * m15 - a[3] * a[0] * m0 + a[11] * a[0] * m14;
    const double m34 = a[2] * m17 - a[4] * m26 + a[10] * m33;
    const double m35 = a[2] * m19 - a[4] * m27 + a[8] * m33;
    const double m36 = a[3] * m20 - a[5] * m28 + a[9] * m34 - a[11] * m35;
    const double m37 = a[2] * m22 - a[4] * m29 + a[6] * m33;
    const double m38 = a[3] * m23 - a[5] * m30 + a[7] * m34 - a[11] * m37;
    const double m39 = a[4] * m25 - a[6] * m32 + a[8] * m36 - a[10] * m38;
    const double m40 = a[1] * m13 - a[7] * a[0] * m6 + a[9] * a[0] * m10 - a[11] * a[0] * m12;
    const double m41 = a[1] * m20 - a[5] * a[0] * m6 + a[9] * a[0] * m17 - a[11] * a[0] * m19;
    const double m42 = a[1] * m23 - a[5] * a[0] * m10 + a[7] * a[0] * m17 - a[11] * a[0] * m22;
    const double m43 = a[2] * m25 - a[6] * m40 + a[8] * m41 - a[10] * m42;
    const double m44 = a[1] * m28 - a[3] * a[0] * m6 + a[9] * a[0] * m26 - a[11] * a[0] * m27;
    const double m45 = a[1] * m30 - a[3] * a[0] * m10 + a[7] * a[0] * m26 - a[11] * a[0] * m29;
    const double m46 = a[2] * m32 - a[4] * m40 + a[8] * m44 - a[10] * m45;
    const double m47 = a[1] * m34 - a[3] * a[0] * m17 + a[5] * a[0] * m26 - a[11] * a[0] * m33;
    const double m48 = a[2] * m36 - a[4] * m41 + a[6] * m44 - a[10] * m47;
    const double m49 = a[2] * m38 - a[4] * m42 + a[6] * m45 - a[8] * m47;
    const double m50 = a[3] * m39 - a[5] * m43 + a[7] * m46 - a[9] * m48 + a[11] * m49;
    const double m51 = a[1] * m39 - a[5] * a[0] * m25 + a[7] * a[0] * m32 - a[9] * a[0] * m36
        + a[11] * a[0] * m38;
    const double m52 = a[1] * m43 - a[3] * a[0] * m25 + a[7] * a[0] * m40 - a[9] * a[0] * m41
        + a[11] * a[0] * m42;
    const double m53 = a[1] * m46 - a[3] * a[0] * m32 + a[5] * a[0] * m40 - a[9] * a[0] * m44
        + a[11] * a[0] * m45;
    const double m54 = a[1] * m48 - a[3] * a[0] * m36 + a[5] * a[0] * m41 - a[7] * a[0] * m44
        + a[11] * a[0] * m47;
    const double m55 = a[2] * m50 - a[4] * m51 + a[6] * m52 - a[8] * m53 + a[10] * m54;
    const double m56 = a[1] * m49 - a[3] * a[0] * m38 + a[5] * a[0] * m42 - a[7] * a[0] * m45
        + a[9] * a[0] * m47;
    const double m57 = a[3] * m24 - a[5] * m31 + a[7] * m35 - a[9] * m37;
    const double m58 = a[1] * m24 - a[5] * a[0] * m12 + a[7] * a[0] * m19 - a[9] * a[0] * m22;
    const double m59 = a[1] * m31 - a[3] * a[0] * m12 + a[7] * a[0] * m27 - a[9] * a[0] * m29;
    const double m60 = a[1] * m35 - a[3] * a[0] * m19 + a[5] * a[0] * m27 - a[9] * a[0] * m33;
    const double m61 = a[1] * m37 - a[3] * a[0] * m22 + a[5] * a[0] * m29 - a[7] * a[0] * m33;
    const double m62 = a[2] * m57 - a[4] * m58 + a[6] * m59 - a[8] * m60 + a[10] * m61;
    const double m63 = a[1] * m62 - a[3] * a[0] * m57 + a[5] * a[0] * m58 - a[7] * a[0] * m59
        + a[9] * a[0] * m60 - a[11] * a[0] * m61;
    const double m64 = a[5] * m5 - a[7] * m9 + a[9] * m11;
    const double m65 = a[3] * m5 - a[7] * m16 + a[9] * m18;
    const double m66 = a[3] * m9 - a[5] * m16 + a[9] * m21;
    const double m67 = a[3] * m11 - a[5] * m18 + a[7] * m21;
    const double m68 = a[4] * m64 - a[6] * m65 + a[8] * m66 - a[10] * m67;
    const double m69 = a[1] * m5 - a[7] * a[0] * m1 + a[9] * a[0] * m3;
    const double m70 = a[1] * m9 - a[5] * a[0] * m1 + a[9] * a[0] * m7;
    const double m71 = a[1] * m11 - a[5] * a[0] * m3 + a[7] * a[0] * m7;
    const double m72 = a[2] * m64 - a[6] * m69 + a[8] * m70 - a[10] * m71;
    const double m73 = a[1] * m16 - a[3] * a[0] * m1 + a[9] * a[0] * m14;
    const double m74 = a[1] * m18 - a[3] * a[0] * m3 + a[7] * a[0] * m14;
    const double m75 = a[2] * m65 - a[4] * m69 + a[8] * m73 - a[10] * m74;
    const double m76 = a[1] * m21 - a[3] * a[0] * m7 + a[5] * a[0] * m14;
    const double m77 = a[2] * m66 - a[4] * m70 + a[6] * m73 - a[10] * m76;
    const double m78 = a[2] * m67 - a[4] * m71 + a[6] * m74 - a[8] * m76;
    const double m79 = a[3] * m68 - a[5] * m72 + a[7] * m75 - a[9] * m77 + a[11] * m78;
    const double m80 = a[1] * m68 - a[5] * a[0] * m64 + a[7] * a[0] * m65 - a[9] * a[0] * m66
        + a[11] * a[0] * m67;
    const double m81 = a[1] * m72 - a[3] * a[0] * m64 + a[7] * a[0] * m69 - a[9] * a[0] * m70
        + a[11] * a[0] * m71;
    const double m82 = a[1] * m75 - a[3] * a[0] * m65 + a[5] * a[0] * m69 - a[9] * a[0] * m73
        + a[11] * a[0] * m74;
    const double m83 = a[1] * m77 - a[3] * a[0] * m66 + a[5] * a[0] * m70 - a[7] * a[0] * m73
        + a[11] * a[0] * m76;
    const double m84 = a[2] * m79 - a[4] * m80 + a[6] * m81 - a[8] * m82 + a[10] * m83;
    const double m85 = a[1] * m84 - a[3] * a[0] * m79 + a[5] * a[0] * m80 - a[7] * a[0] * m81
        + a[9] * a[0] * m82 - a[11] * a[0] * m83;
    const double m86 = a[7] * a[8] * a[11] - a[9] * a[6] * a[11];
    const double m87 = a[5] * a[8] * a[11] - a[9] * a[4] * a[11];
    const double m88 = a[5] * a[6] * a[11] - a[7] * a[4] * a[11];
    const double m89 = a[6] * m86 - a[8] * m87 + a[10] * m88;
    const double m90 = a[3] * a[8] * a[11] - a[9] * a[2] * a[11];
    const double m91 = a[3] * a[6] * a[11] - a[7] * a[2] * a[11];
    const double m92 = a[4] * m86 - a[8] * m90 + a[10] * m91;
    const double m93 = a[3] * a[4] * a[11] - a[5] * a[2] * a[11];
    const double m94 = a[4] * m87 - a[6] * m90 + a[10] * m93;
    const double m95 = a[4] * m88 - a[6] * m91 + a[8] * m93;
    const double m96 = a[5] * m89 - a[7] * m92 + a[9] * m94 - a[11] * m95;
    const double m97 = a[1] * a[8] * a[11] - a[9] * a[0] * a[11];
    const double m98 = a[1] * a[6] * a[11] - a[7] * a[0] * a[11];
    const double m99 = a[2] * m86 - a[8] * m97 + a[10] * m98;
    const double m100 = a[1] * a[4] * a[11] - a[5] * a[0] * a[11];
    const double m101 = a[2] * m87 - a[6] * m97 + a[10] * m100;
    const double m102 = a[2] * m88 - a[6] * m98 + a[8] * m100;
    const double m103 = a[3] * m89 - a[7] * m99 + a[9] * m101 - a[11] * m102;
    const double m104 = a[1] * a[2] * a[11] - a[3] * a[0] * a[11];
    const double m105 = a[2] * m90 - a[4] * m97 + a[10] * m104;
    const double m106 = a[2] * m91 - a[4] * m98 + a[8] * m104;
    const double m107 = a[3] * m92 - a[5] * m99 + a[9] * m105 - a[11] * m106;
    const double m108 = a[2] * m93 - a[4] * m100 + a[6] * m104;
    const double m109 = a[3] * m94 - a[5] * m101 + a[7] * m105 - a[11] * m108;
    const double m110 = a[4] * m96 - a[6] * m103 + a[8] * m107 - a[10] * m109;
    const double m111 = a[1] * m89 - a[7] * a[0] * m86 + a[9] * a[0] * m87 - a[11] * a[0] * m88;
    const double m112 = a[1] * m92 - a[5] * a[0] * m86 + a[9] * a[0] * m90 - a[11] * a[0] * m91;
    const double m113 = a[1] * m94 - a[5] * a[0] * m87 + a[7] * a[0] * m90 - a[11] * a[0] * m93;
    const double m114 = a[2] * m96 - a[6] * m111 + a[8] * m112 - a[10] * m113;
    const double m115 = a[1] * m99 - a[3] * a[0] * m86 + a[9] * a[0] * m97 - a[11] * a[0] * m98;
    const double m116 = a[1] * m101 - a[3] * a[0] * m87 + a[7] * a[0] * m97 - a[11] * a[0] * m100;
    const double m117 = a[2] * m103 - a[4] * m111 + a[8] * m115 - a[10] * m116;
    const double m118 = a[1] * m105 - a[3] * a[0] * m90 + a[5] * a[0] * m97 - a[11] * a[0] * m104;
    const double m119 = a[2] * m107 - a[4] * m112 + a[6] * m115 - a[10] * m118;
    const double m120 = a[2] * m109 - a[4] * m113 + a[6] * m116 - a[8] * m118;
    const double m121 = a[3] * m110 - a[5] * m114 + a[7] * m117 - a[9] * m119 + a[11] * m120;
    const double m122 = a[1] * m110 - a[5] * a[0] * m96 + a[7] * a[0] * m103 - a[9] * a[0] * m107
        + a[11] * a[0] * m109;
    const double m123 = a[1] * m114 - a[3] * a[0] * m96 + a[7] * a[0] * m111 - a[9] * a[0] * m112
        + a[11] * a[0] * m113;
    const double m124 = a[1] * m117 - a[3] * a[0] * m103 + a[5] * a[0] * m111 - a[9] * a[0] * m115
        + a[11] * a[0] * m116;
    const double m125 = a[1] * m119 - a[3] * a[0] * m107 + a[5] * a[0] * m112 - a[7] * a[0] * m115
        + a[11] * a[0] * m118;
    const double m126 = a[2] * m121 - a[4] * m122 + a[6] * m123 - a[8] * m124 + a[10] * m125;
    const double m127 = a[1] * m126 - a[3] * a[0] * m121 + a[5] * a[0] * m122 - a[7] * a[0] * m123
        + a[9] * a[0] * m124 - a[11] * a[0] * m125;
    const double m128 = a[8] * a[9] - a[10] * a[7];
    const double m129 = a[6] * a[9] - a[10] * a[5];
    const double m130 = a[6] * a[7] - a[8] * a[5];
    const double m131 = a[7] * m128 - a[9] * m129 + a[11] * m130;
    const double m132 = a[4] * a[9] - a[10] * a[3];
    const double m133 = a[4] * a[7] - a[8] * a[3];
    const double m134 = a[5] * m128 - a[9] * m132 + a[11] * m133;
    const double m135 = a[4] * a[5] - a[6] * a[3];
    const double m136 = a[5] * m129 - a[7] * m132 + a[11] * m135;
    const double m137 = a[6] * m131 - a[8] * m134 + a[10] * m136;
    const double m138 = a[2] * a[9] - a[10] * a[1];
    const double m139 = a[2] * a[7] - a[8] * a[1];
    const double m140 = a[3] * m128 - a[9] * m138 + a[11] * m139;
    const double m141 = a[2] * a[5] - a[6] * a[1];
    const double m142 = a[3] * m129 - a[7] * m138 + a[11] * m141;
    const double m143 = a[4] * m131 - a[8] * m140 + a[10] * m142;
    const double m144 = a[2] * a[3] - a[4] * a[1];
    const double m145 = a[3] * m132 - a[5] * m138 + a[11] * m144;
    const double m146 = a[4] * m134 - a[6] * m140 + a[10] * m145;
    const double m147 = a[4] * m136 - a[6] * m142 + a[8] * m145;
    const double m148 = a[5] * m137 - a[7] * m143 + a[9] * m146 - a[11] * m147;
    const double m149 = a[1] * m128 - a[9] * a[0] * a[9] + a[11] * a[0] * a[7];
    const double m150 = a[1] * m129 - a[7] * a[0] * a[9] + a[11] * a[0] * a[5];
    const double m151 = a[2] * m131 - a[8] * m149 + a[10] * m150;
    const double m152 = a[1] * m132 - a[5] * a[0] * a[9] + a[11] * a[0] * a[3];
    const double m153 = a[2] * m134 - a[6] * m149 + a[10] * m152;
    const double m154 = a[2] * m136 - a[6] * m150 + a[8] * m152;
    const double m155 = a[3] * m137 - a[7] * m151 + a[9] * m153 - a[11] * m154;
    const double m156 = a[1] * m138 - a[3] * a[0] * a[9] + a[11] * a[0] * a[1];
    const double m157 = a[2] * m140 - a[4] * m149 + a[10] * m156;
    const double m158 = a[2] * m142 - a[4] * m150 + a[8] * m156;
    const double m159 = a[3] * m143 - a[5] * m151 + a[9] * m157 - a[11] * m158;
    const double m160 = a[2] * m145 - a[4] * m152 + a[6] * m156;
    const double m161 = a[3] * m146 - a[5] * m153 + a[7] * m157 - a[11] * m160;
    const double m162 = a[4] * m148 - a[6] * m155 + a[8] * m159 - a[10] * m161;
    const double m163 = a[1] * m137 - a[7] * a[0] * m131 + a[9] * a[0] * m134 - a[11] * a[0] * m136;
    const double m164 = a[1] * m143 - a[5] * a[0] * m131 + a[9] * a[0] * m140 - a[11] * a[0] * m142;
    const double m165 = a[1] * m146 - a[5] * a[0] * m134 + a[7] * a[0] * m140 - a[11] * a[0] * m145;
    const double m166 = a[2] * m148 - a[6] * m163 + a[8] * m164 - a[10] * m165;
    const double m167 = a[1] * m151 - a[3] * a[0] * m131 + a[9] * a[0] * m149 - a[11] * a[0] * m150;
    const double m168 = a[1] * m153 - a[3] * a[0] * m134 + a[7] * a[0] * m149 - a[11] * a[0] * m152;
    const double m169 = a[2] * m155 - a[4] * m163 + a[8] * m167 - a[10] * m168;
    const double m170 = a[1] * m157 - a[3] * a[0] * m140 + a[5] * a[0] * m149 - a[11] * a[0] * m156;
    const double m171 = a[2] * m159 - a[4] * m164 + a[6] * m167 - a[10] * m170;
    const double m172 = a[2] * m161 - a[4] * m165 + a[6] * m168 - a[8] * m170;
    const double m173 = a[3] * m162 - a[5] * m166 + a[7] * m169 - a[9] * m171 + a[11] * m172;
    const double m174 = a[1] * m162 - a[5] * a[0] * m148 + a[7] * a[0] * m155 - a[9] * a[0] * m159
        + a[11] * a[0] * m161;
    const double m175 = a[1] * m166 - a[3] * a[0] * m148 + a[7] * a[0] * m163 - a[9] * a[0] * m164
        + a[11] * a[0] * m165;
    const double m176 = a[1] * m169 - a[3] * a[0] * m155 + a[5] * a[0] * m163 - a[9] * a[0] * m167
        + a[11] * a[0] * m168;
    const double m177 = a[1] * m171 - a[3] * a[0] * m159 + a[5] * a[0] * m164 - a[7] * a[0] * m167
        + a[11] * a[0] * m170;
    const double m178 = a[2] * m173 - a[4] * m174 + a[6] * m175 - a[8] * m176 + a[10] * m177;
    const double m179 = a[1] * m178 - a[3] * a[0] * m173 + a[5] * a[0] * m174 - a[7] * a[0] * m175
        + a[9] * a[0] * m176 - a[11] * a[0] * m177;
    const double determinant = a[1] * m55 - a[3] * a[0] * m50 + a[5] * a[0] * m51 - a[7] * a[0] * m52
        + a[9] * a[0] * m53 - a[11] * a[0] * m54;
    const double numerator = b[0] * m55 - b[1] * a[0] * m50 + b[2] * a[0] * m51 - b[3] * a[0] * m52
        + b[4] * a[0] * m53 - b[5] * a[0] * m54 + b[6] * a[0] * m56 - b[7] * a[0] * m63
        + b[8] * a[0] * m85 - b[9] * a[0] * m127 + b[10] * a[0] * m179;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i12(const double a[13], const double b[12])
{
    const double m0 = a[10] * a[11] * a[12] - a[12] * a[9] * a[12];
    const double m1 = a[8] * a[11] * a[12] - a[12] * a[7] * a[12];
    const double m2 = a[9] * m0 - a[11] * m1;
    const double m3 = a[6] * a[11] * a[12] - a[12] * a[5] * a[12];
    const double m4 = a[7] * m0 - a[11] * m3;
    const double m5 = a[7] * m1 - a[9] * m3;
    const double m6 = a[8] * m2 - a[10] * m4 + a[12] * m5;
    const double m7 = a[4] * a[11] * a[12] - a[12] * a[3] * a[12];
    const double m8 = a[5] * m0 - a[11] * m7;
    const double m9 = a[5] * m1 - a[9] * m7;
    const double m10 = a[6] * m2 - a[10] * m8 + a[12] * m9;
    const double m11 = a[5] * m3 - a[7] * m7;
    const double m12 = a[6] * m4 - a[8] * m8 + a[12] * m11;
    const double m13 = a[7] * m6 - a[9] * m10 + a[11] * m12;
    const double m14 = a[2] * a[11] * a[12] - a[12] * a[1] * a[12];
    const double m15 = a[3] * m0 - a[11] * m14;
    const double m16 = a[3] * m1 - a[9] * m14;
    const double m17 = a[4] * m2 - a[10] * m15 + a[12] * m16;
    const double m18 = a[3] * m3 - a[7] * m14;
    const double m19 = a[4] * m4 - a[8] * m15 + a[12] * m18;
    const double m20 = a[5] * m6 - a[9] * m17 + a[11] * m19;
    const double m21 = a[3] * m7 - a[5] * m14;
    const double m22 = a[4] * m8 - a[6] * m15 + a[12] * m21;
    const double m23 = a[5] * m10 - a[7] * m17 + a[11] * m22;
    const double m24 = a[5] * m12 - a[7] * m19 + a[9] * m22;
    const double m25 = a[6] * m13 - a[8] * m20 + a[10] * m23 - a[12] * m24;
    const double m26 = a[1] * m0 - a[11] * a[0] * a[11] * a[12];
    const double m27 = a[1] * m1 - a[9] * a[0] * a[11] * a[12];
    const double m28 = a[2] * m2 - a[10] * m26 + a[12] * m27;
    const double m29 = a[1] * m3 - a[7] * a[0] * a[11] * a[12];
    const double m30 = a[2] * m4 - a[8] * m26 + a[12] * m29;
    const double m31 = a[3] * m6 - a[9] * m28 + a[11] * m30;
    const double m32 = a[1] * m7 - a[5] * a[0] * a[11] * a[12];
    const double m33 = a[2] * m8 - a[6] * m26 + a[12] * m32;
    const double m34 = a[3] * m10 - a[7] * m28 + a[11] * m33;
    const double m35 = a[3] * m12 - a[7] * m30 + a[9] * m33;
    const double m36 = a[4] * m13 - a[8] * m31 + a[10] * m34 - a[12] * m35;
    const double m37 = a[1] * m14 - a[3] * a[0] * a[11] * a[12];
    const double m38 = a[2] * m15 - a[4] * m26 + a[12] * m37;
    const double m39 = a[3] * m17 - a[5] * m28 + a[11] * m38;
    const double m40 = a[3] * m19 - a[5] * m30 + a[9] * m38;
    const double m41 = a[4] * m20 - a[6] * m31 + a[10] * m39 - a[12] * m40;
    const double m42 = a[3] * m22 - a[5] * m33 + a[7] * m38;
    const double m43 = a[4] * m23 - a[6] * m34 + a[8] * m39 - a[12] * m42;
    const double m44 = a[5] * m25 - a[7] * m36 + a[9] * m41 - a[11] * m43;
    const double m45 = a[1] * m6 - a[9] * a[0] * m2 + a[11] * a[0] * m4;
    const double m46 = a[1] * m10 - a[7] * a[0] * m2 + a[11] * a[0] * m8;
    const double m47 = a[1] * m12 - a[7] * a[0] * m4 + a[9] * a[0] * m8;
    const double m48 = a[2] * m13 - a[8] * m45 + a[10] * m46 - a[12] * m47;
    const double m49 = a[1] * m17 - a[5] * a[0] * m2 + a[11] * a[0] * m15;
    const double m50 = a[1] * m19 - a[5] * a[0] * m4 + a[9] * a[0] * m15;
    const double m51 = a[2] * m20 - a[6] * m45 + a[10] * m49 - a[12] * m50;
    const double m52 = a[1] * m22 - a[5] * a[0] * m8 + a[7] * a[0] * m15;
    const double m53 = a[2] * m23 - a[6] * m46 + a[8] * m49 - a[12] * m52;
    const double m54 = a[3] * m25 - a[7] * m48 + a[9] * m51 - a[11] * m53;
    const double m55 = a[1] * m28 - a[3] * a[0] * m2 + a[11] * a[0] * m26;
    const double m56 = a[1] * m30 - a[3] * a[0] * m4 + a[9] * a[0] * m26;
    const double m57 = a[2] * m31 - a[4] * m45 + a[10] * m55 - a[12] * m56;
    const double m58 = a[1] * m33 - a[3] * a[0] * m8 + a[7] * a[0] * m26;
    const double m59 = a[2] * m34 - a[4] * m46 + a[8] * m55 - a[12] * m58;
    const double m60 = a[3] * m36 - a[5] * m48 + a[9] * m57 - a[11] * m59;
    const double m61 = a[1] * m38 - a[3] * a[0] * m15 + a[5] * a[0] * m26;
    const double m62 = a[2] * m39 - a[4] * m49 + a[6] * m55 - a[12] * m61;
    const double m63 = a[3] * m41 - a[5] * m51 + a[7] * m57 - a[11] * m62;
    const double m64 = a[3] * m43 - a[5] * m53 + a[7] * m59 - a[9] * m62;
    const double m65 = a[4] * m44 - a[6] * m54 + a[8] * m60 - a[10] * m63 + a[12] * m64;
    const double m66 = a[1] * m25 - a[7] * a[0] * m13 + a[9] * a[0] * m20 - a[11] * a[0] * m23;
    const double m67 = a[1] * m36 - a[5] * a[0] * m13 + a[9] * a[0] * m31 - a[11] * a[0] * m34;
    const double m68 = a[1] * m41 - a[5] * a[0] * m20 + a[7] * a[0] * m31 - a[11] * a[0] * m39;
    const double m69 = a[1] * m43 - a[5] * a[0] * m23 + a[7] * a[0] * m34 - a[9] * a[0] * m39;
    const double m70 = a[2] * m44 - a[6] * m66 + a[8] * m67 - a[10] * m68 + a[12] * m69;
    const double m71 = a[1] * m48 - a[3] * a[0] * m13 + a[9] * a[0] * m45 - a[11] * a[0] * m46;
    const double m72 = a[1] * m51 - a[3] * a[0] * m20 + a[7] * a[0] * m45 - a[11] * a[0] * m49;
    const double m73 = a[1] * m53 - a[3] * a[0] * m23 + a[7] * a[0] * m46 - a[9] * a[0] * m49;
    const double m74 = a[2] * m54 - a[4] * m66 + a[8] * m71 - a[10] * m72 + a[12] * m73;
    const double m75 = a[1] * m57 - a[3] * a[0] * m31 + a[5] * a[0] * m45 - a[11] * a[0] * m55;
    const double m76 = a[1] * m59 - a[3] * a[0] * m34 + a[5] * a[0] * m46 - a[9] * a[0] * m55;
    const double m77 = a[2] * m60 - a[4] * m67 + a[6] * m71 - a[10] * m75 + a[12] * m76;
    const double m78 = a[1] * m62 - a[3] * a[0] * m39 + a[5] * a[0] * m49 - a[7] * a[0] * m55;
    const double m79 = a[2] * m63 - a[4] * m68 + a[6] * m72 - a[8] * m75 + a[12] * m78;
    const double m80 = a[3] * m65 - a[5] * m70 + a[7] * m74 - a[9] * m77 + a[11] * m79;
    const double m81 = a[1] * m65 - a[5] * a[0] * m44 + a[7] * a[0] * m54 - a[9] * a[0] * m60
        + a[11] * a[0] * m63;
    const double m82 = a[1] * m70 - a[3] * a[0] * m44 + a[7] * a[0] * m66 - a[9] * a[0] * m67
        + a[11] * a[0] * m68;
    const double m83 = a[1] * m74 - a[3] * a[0] * m54 + a[5] * a[0] * m66 - a[9] * a[0] * m71
        + a[11] * a[0] * m72;
    const double m84 = a[1] * m77 - a[3] * a[0] * m60 + a[5] * a[0] * m67 - a[7] * a[0] * m71
        + a[11] * a[0] * m75;
    const double m85 = a[1] * m79 - a[3] * a[0] * m63 + a[5] * a[0] * m68 - a[7] * a[0] * m72
        + a[9] * a[0] * m75;
    const double m86 = a[2] * m80 - a[4] * m81 + a[6] * m82 - a[8] * m83 + a[10] * m84 - a[12] * m85;
    const double m87 = a[2] * m64 - a[4] * m69 + a[6] * m73 - a[8] * m76 + a[10] * m78;
    const double m88 = a[1] * m87 - a[3] * a[0] * m64 + a[5] * a[0] * m69 - a[7] * a[0] * m73
        + a[9] * a[0] * m76 - a[11] * a[0] * m78;
    const double m89 = a[4] * m24 - a[6] * m35 + a[8] * m40 - a[10] * m42;
    const double m90 = a[2] * m24 - a[6] * m47 + a[8] * m50 - a[10] * m52;
    const double m91 = a[2] * m35 - a[4] * m47 + a[8] * m56 - a[10] * m58;
    const double m92 = a[2] * m40 - a[4] * m50 + a[6] * m56 - a[10] * m61;
    const double m93 = a[2] * m42 - a[4] * m52 + a[6] * m58 - a[8] * m61;
    const double m94 = a[3] * m89 - a[5] * m90 + a[7] * m91 - a[9] * m92 + a[11] * m93;
    const double m95 = a[1] * m89 - a[5] * a[0] * m24 + a[7] * a[0] * m35 - a[9] * a[0] * m40
        + a[11] * a[0] * m42;
    const double m96 = a[1] * m90 - a[3] * a[0] * m24 + a[7] * a[0] * m47 - a[9] * a[0] * m50
        + a[11] * a[0] * m52;
    const double m97 = a[1] * m91 - a[3] * a[0] * m35 + a[5] * a[0] * m47 - a[9] * a[0] * m56
        + a[11] * a[0] * m58;
    const double m98 = a[1] * m92 - a[3] * a[0] * m40 + a[5] * a[0] * m50 - a[7] * a[0] * m56
        + a[11] * a[0] * m61;
    const double m99 = a[1] * m93 - a[3] * a[0] * m42 + a[5] * a[0] * m52 - a[7] * a[0] * m58
        + a[9] * a[0] * m61;
    const double m100 = a[2] * m94 - a[4] * m95 + a[6] * m96 - a[8] * m97 + a[10] * m98 - a[12] * m99;
    const double m101 = a[1] * m100 - a[3] * a[0] * m94 + a[5] * a[0] * m95 - a[7] * a[0] * m96
        + a[9] * a[0] * m97 - a[11] * a[0] * m98;
    const double m102 = a[6] * m5 - a[8] * m9 + a[10] * m11;
    const double m103 = a[4] * m5 - a[8] * m16 + a[10] * m18;
    const double m104 = a[4] * m9 - a[6] * m16 + a[10] * m21;
    const double m105 = a[4] * m11 - a[6] * m18 + a[8] * m21;
    const double m106 = a[5] * m102 - a[7] * m103 + a[9] * m104 - a[11] * m105;
    const double m107 = a[2] * m5 - a[8] * m27 + a[10] * m29;
    const double m108 = a[2] * m9 - a[6] * m27 + a[10] * m32;
    const double m109 = a[2] * m11 - a[6] * m29 + a[8] * m32;
    const double m110 = a[3] * m102 - a[7] * m107 + a[9] * m108 - a[11] * m109;
    const double m111 = a[2] * m16 - a[4] * m27 + a[10] * m37;
    const double m112 = a[2] * m18 - a[4] * m29 + a[8] * m37;
    const double m113 = a[3] * m103 - a[5] * m107 + a[9] * m111 - a[11] * m112;
    const double m114 = a[2] * m21 - a[4] * m32 + a[6] * m37;
    const double m115 = a[3] * m104 - a[5] * m108 + a[7] * m111 - a[11] * m114;
    const double m116 = a[3] * m105 - a[5] * m109 + a[7] * m112 - a[9] * m114;
    const double m117 = a[4] * m106 - a[6] * m110 + a[8] * m113 - a[10] * m115 + a[12] * m116;
    const double m118 = a[1] * m102 - a[7] * a[0] * m5 + a[9] * a[0] * m9 - a[11] * a[0] * m11;
    const double m119 = a[1] * m103 - a[5] * a[0] * m5 + a[9] * a[0] * m16 - a[11] * a[0] * m18;
    const double m120 = a[1] * m104 - a[5] * a[0] * m9 + a[7] * a[0] * m16 - a[11] * a[0] * m21;
    const double m121 = a[1] * m105 - a[5] * a[0] * m11 + a[7] * a[0] * m18 - a[9] * a[0] * m21;
    const double m122 = a[2] * m106 - a[6] * m118 + a[8] * m119 - a[10] * m120 + a[12] * m121;
    const double m123 = a[1] * m107 - a[3] * a[0] * m5 + a[9] * a[0] * m27 - a[11] * a[0] * m29;
    const double m124 = a[1] * m108 - a[3] * a[0] * m9 + a[7] * a[0] * m27 - a[11] * a[0] * m32;
    const double m125 = a[1] * m109 - a[3] * a[0] * m11 + a[7] * a[0] * m29 - a[9] * a[0] * m32;
    const double m126 = a[2] * m110 - a[4] * m118 + a[8] * m123 - a[10] * m124 + a[12] * m125;
    const double m127 = a[1] * m111 - a[3] * a[0] * m16 + a[5] * a[0] * m27 - a[11] * a[0] * m37;
    const double m128 = a[1] * m112 - a[3] * a[0] * m18 + a[5] * a[0] * m29 - a[9] * a[0] * m37;
    const double m129 = a[2] * m113 - a[4] * m119 + a[6] * m123 - a[10] * m127 + a[12] * m128;
    const double m130 = a[1] * m114 - a[3] * a[0] * m21 + a[5] * a[0] * m32 - a[7] * a[0] * m37;
    const double m131 = a[2] * m115 - a[4] * m120 + a[6] * m124 - a[8] * m127 + a[12] * m130;
    const double m132 = a[3] * m117 - a[5] * m122 + a[7] * m126 - a[9] * m129 + a[11] * m131;
    const double m133 = a[1] * m117 - a[5] * a[0] * m106 + a[7] * a[0] * m110 - a[9] * a[0] * m113
        + a[11] * a[0] * m115;
    const double m134 = a[1] * m122 - a[3] * a[0] * m106 + a[7] * a[0] * m118 - a[9] * a[0] * m119
        + a[11] * a[0] * m120;
    const double m135 = a[1] * m126 - a[3] * a[0] * m110 + a[5] * a[0] * m118 - a[9] * a[0] * m123
        + a[11] * a[0] * m124;
    const double m136 = a[1] * m129 - a[3] * a[0] * m113 + a[5] * a[0] * m119 - a[7] * a[0] * m123
        + a[11] * a[0] * m127;
    const double m137 = a[1] * m131 - a[3] * a[0] * m115 + a[5] * a[0] * m120 - a[7] * a[0] * m124
        + a[9] * a[0] * m127;
    const double m138 = a[2] * m132 - a[4] * m133 + a[6] * m134 - a[8] * m135 + a[10] * m136
        - a[12] * m137;
    const double m139 = a[1] * m138 - a[3] * a[0] * m132 + a[5] * a[0] * m133 - a[7] * a[0] * m134
        + a[9] * a[0] * m135 - a[11] * a[0] * m136;
    const double m140 = a[8] * a[9] * a[12] - a[10] * a[7] * a[12];
    const double m141 = a[6] * a[9] * a[12] - a[10] * a[5] * a[12];
    const double m142 = a[6] * a[7] * a[12] - a[8] * a[5] * a[12];
    const double m143 = a[7] * m140 - a[9] * m141 + a[11] * m142;
    const double m144 = a[4] * a[9] * a[12] - a[10] * a[3] * a[12];
    const double m145 = a[4] * a[7] * a[12] - a[8] * a[3] * a[12];
    const double m146 = a[5] * m140 - a[9] * m144 + a[11] * m145;
    const double m147 = a[4] * a[5] * a[12] - a[6] * a[3] * a[12];
    const double m148 = a[5] * m141 - a[7] * m144 + a[11] * m147;
    const double m149 = a[5] * m142 - a[7] * m145 + a[9] * m147;
    const double m150 = a[6] * m143 - a[8] * m146 + a[10] * m148 - a[12] * m149;
    const double m151 = a[2] * a[9] * a[12] - a[10] * a[1] * a[12];
    const double m152 = a[2] * a[7] * a[12] - a[8] * a[1] * a[12];
    const double m153 = a[3] * m140 - a[9] * m151 + a[11] * m152;
    const double m154 = a[2] * a[5] * a[12] - a[6] * a[1] * a[12];
    const double m155 = a[3] * m141 - a[7] * m151 + a[11] * m154;
    const double m156 = a[3] * m142 - a[7] * m152 + a[9] * m154;
    const double m157 = a[4] * m143 - a[8] * m153 + a[10] * m155 - a[12] * m156;
    const double m158 = a[2] * a[3] * a[12] - a[4] * a[1] * a[12];
    const double m159 = a[3] * m144 - a[5] * m151 + a[11] * m158;
    const double m160 = a[3] * m145 - a[5] * m152 + a[9] * m158;
    const double m161 = a[4] * m146 - a[6] * m153 + a[10] * m159 - a[12] * m160;
    const double m162 = a[3] * m147 - a[5] * m154 + a[7] * m158;
    const double m163 = a[4] * m148 - a[6] * m155 + a[8] * m159 - a[12] * m162;
    const double m164 = a[5] * m150 - a[7] * m157 + a[9] * m161 - a[11] * m163;
    const double m165 = a[1] * m140 - a[9] * a[0] * a[9] * a[12] + a[11] * a[0] * a[7] * a[12];
    const double m166 = a[1] * m141 - a[7] * a[0] * a[9] * a[12] + a[11] * a[0] * a[5] * a[12];
    const double m167 = a[1] * m142 - a[7] * a[0] * a[7] * a[12] + a[9] * a[0] * a[5] * a[12];
    const double m168 = a[2] * m143 - a[8] * m165 + a[10] * m166 - a[12] * m167;
    const double m169 = a[1] * m144 - a[5] * a[0] * a[9] * a[12] + a[11] * a[0] * a[3] * a[12];
    const double m170 = a[1] * m145 - a[5] * a[0] * a[7] * a[12] + a[9] * a[0] * a[3] * a[12];
    const double m171 = a[2] * m146 - a[6] * m165 + a[10] * m169 - a[12] * m170;
    const double m172 = a[1] * m147 - a[5] * a[0] * a[5] * a[12] + a[7] * a[0] * a[3] * a[12];
    const double m173 = a[2] * m148 - a[6] * m166 + a[8] * m169 - a[12] * m172;
    const double m174 = a[3] * m150 - a[7] * m168 + a[9] * m171 - a[11] * m173;
    const double m175 = a[1] * m151 - a[3] * a[0] * a[9] * a[12] + a[11] * a[0] * a[1] * a[12];
    const double m176 = a[1] * m152 - a[3] * a[0] * a[7] * a[12] + a[9] * a[0] * a[1] * a[12];
    const double m177 = a[2] * m153 - a[4] * m165 + a[10] * m175 - a[12] * m176;
    const double m178 = a[1] * m154 - a[3] * a[0] * a[5] * a[12] + a[7] * a[0] * a[1] * a[12];
    const double m179 = a[2] * m155 - a[4] * m166 + a[8] * m175 - a[12] * m178;
    const double m180 = a[3] * m157 - a[5] * m168 + a[9] * m177 - a[11] * m179;
    const double m181 = a[1] * m158 - a[3] * a[0] * a[3] * a[12] + a[5] * a[0] * a[1] * a[12];
    const double m182 = a[2] * m159 - a[4] * m169 + a[6] * m175 - a[12] * m181;
    const double m183 = a[3] * m161 - a[5] * m171 + a[7] * m177 - a[11] * m182;
    const double m184 = a[3] * m163 - a[5] * m173 + a[7] * m179 - a[9] * m182;
    const double m185 = a[4] * m164 - a[6] * m174 + a[8] * m180 - a[10] * m183 + a[12] * m184;
    const double m186 = a[1] * m150 - a[7] * a[0] * m143 + a[9] * a[0] * m146 - a[11] * a[0] * m148;
    const double m187 = a[1] * m157 - a[5] * a[0] * m143 + a[9] * a[0] * m153 - a[11] * a[0] * m155;
    const double m188 = a[1] * m161 - a[5] * a[0] * m146 + a[7] * a[0] * m153 - a[11] * a[0] * m159;
    const double m189 = a[1] * m163 - a[5] * a[0] * m148 + a[7] * a[0] * m155 - a[9] * a[0] * m159;
    const double m190 = a[2] * m164 - a[6] * m186 + a[8] * m187 - a[10] * m188 + a[12] * m189;
    const double m191 = a[1] * m168 - a[3] * a[0] * m143 + a[9] * a[0] * m165 - a[11] * a[0] * m166;
    const double m192 = a[1] * m171 - a[3] * a[0] * m146 + a[7] * a[0] * m165 - a[11] * a[0] * m169;
    const double m193 = a[1] * m173 - a[3] * a[0] * m148 + a[7] * a[0] * m166 - a[9] * a[0] * m169;
    const double m194 = a[2] * m174 - a[4] * m186 + a[8] * m191 - a[10] * m192 + a[12] * m193;
    const double m195 = a[1] * m177 - a[3] * a[0] * m153 + a[5] * a[0] * m165 - a[11] * a[0] * m175;
    const double m196 = a[1] * m179 - a[3] * a[0] * m155 + a[5] * a[0] * m166 - a[9] * a[0] * m175;
    const double m197 = a[2] * m180 - a[4] * m187 + a[6] * m191 - a[10] * m195 + a[12] * m196;
    const double m198 = a[1] * m182 - a[3] * a[0] * m159 + a[5] * a[0] * m169 - a[7] * a[0] * m175;
    const double m199 = a[2] * m183 - a[4] * m188 + a[6] * m192 - a[8] * m195 + a[12] * m198;
    const double m200 = a[3] * m185 - a[5] * m190 + a[7] * m194 - a[9] * m197 + a[11] * m199;
    const double m201 = a[1] * m185 - a[5] * a[0] * m164 + a[7] * a[0] * m174 - a[9] * a[0] * m180
        + a[11] * a[0] * m183;
    const double m202 = a[1] * m190 - a[3] * a[0] * m164 + a[7] * a[0] * m186 - a[9] * a[0] * m187
        + a[11] * a[0] * m188;
    const double m203 = a[1] * m194 - a[3] * a[0] * m174 + a[5] * a[0] * m186 - a[9] * a[0] * m191
        + a[11] * a[0] * m192;
    const double m204 = a[1] * m197 - a[3] * a[0] * m180 + a[5] * a[0] * m187 - a[7] * a[0] * m191
        + a[11] * a[0] * m195;
    const double m205 = a[1] * m199 - a[3] * a[0] * m183 + a[5] * a[0] * m188 - a[7] * a[0] * m192
        + a[9] * a[0] * m195;
    const double m206 = a[2] * m200 - a[4] * m201 + a[6] * m202 - a[8] * m203 + a[10] * m204
        - a[12] * m205;
    const double m207 = a[1] * m206 - a[3] * a[0] * m200 + a[5] * a[0] * m201 - a[7] * a[0] * m202
        + a[9] * a[0] * m203 - a[11] * a[0] * m204;
    const double m208 = a[9] * a[10] - a[11] * a[8];
    const double m209 = a[7] * a[10] - a[11] * a[6];
    const double m210 = a[7] * a[8] - a[9] * a[6];
    const double m211 = a[8] * m208 - a[10] * m209 + a[12] * m210;
    const double m212 = a[5] * a[10] - a[11] * a[4];
    const double m213 = a[5] * a[8] - a[9] * a[4];
    const double m214 = a[6] * m208 - a[10] * m212 + a[12] * m213;
    const double m215 = a[5] * a[6] - a[7] * a[4];
    const double m216 = a[6] * m209 - a[8] * m212 + a[12] * m215;
    const double m217 = a[7] * m211 - a[9] * m214 + a[11] * m216;
    const double m218 = a[3] * a[10] - a[11] * a[2];
    const double m219 = a[3] * a[8] - a[9] * a[2];
    const double m220 = a[4] * m208 - a[10] * m218 + a[12] * m219;
    const double m221 = a[3] * a[6] - a[7] * a[2];
    const double m222 = a[4] * m209 - a[8] * m218 + a[12] * m221;
    const double m223 = a[5] * m211 - a[9] * m220 + a[11] * m222;
    const double m224 = a[3] * a[4] - a[5] * a[2];
    const double m225 = a[4] * m212 - a[6] * m218 + a[12] * m224;
    const double m226 = a[5] * m214 - a[7] * m220 + a[11] * m225;
    const double m227 = a[5] * m216 - a[7] * m222 + a[9] * m225;
    const double m228 = a[6] * m217 - a[8] * m223 + a[10] * m226 - a[12] * m227;
    const double m229 = a[1] * a[10] - a[11] * a[0];
    const double m230 = a[1] * a[8] - a[9] * a[0];
    const double m231 = a[2] * m208 - a[10] * m229 + a[12] * m230;
    const double m232 = a[1] * a[6] - a[7] * a[0];
    const double m233 = a[2] * m209 - a[8] * m229 + a[12] * m232;
    const double m234 = a[3] * m211 - a[9] * m231 + a[11] * m233;
    const double m235 = a[1] * a[4] - a[5] * a[0];
    const double m236 = a[2] * m212 - a[6] * m229 + a[12] * m235;
    const double m237 = a[3] * m214 - a[7] * m231 + a[11] * m236;
    const double m238 = a[3] * m216 - a[7] * m233 + a[9] * m236;
    const double m239 = a[4] * m217 - a[8] * m234 + a[10] * m237 - a[12] * m238;
    const double m240 = a[1] * a[2] - a[3] * a[0];
    const double m241 = a[2] * m218 - a[4] * m229 + a[12] * m240;
    const double m242 = a[3] * m220 - a[5] * m231 + a[11] * m241;
    const double m243 = a[3] * m222 - a[5] * m233 + a[9] * m241;
    const double m244 = a[4] * m223 - a[6] * m234 + a[10] * m242 - a[12] * m243;
    const double m245 = a[3] * m225 - a[5] * m236 + a[7] * m241;
    const double m246 = a[4] * m226 - a[6] * m237 + a[8] * m242 - a[12] * m245;
    const double m247 = a[5] * m228 - a[7] * m239 + a[9] * m244 - a[11] * m246;
    const double m248 = a[1] * m211 - a[9] * a[0] * m208 + a[11] * a[0] * m209;
    const double m249 = a[1] * m214 - a[7] * a[0] * m208 + a[11] * a[0] * m212;
    const double m250 = a[1] * m216 - a[7] * a[0] * m209 + a[9] * a[0] * m212;
    const double m251 = a[2] * m217 - a[8] * m248 + a[10] * m249 - a[12] * m250;
    const double m252 = a[1] * m220 - a[5] * a[0] * m208 + a[11] * a[0] * m218;
    const double m253 = a[1] * m222 - a[5] * a[0] * m209 + a[9] * a[0] * m218;
    const double m254 = a[2] * m223 - a[6] * m248 + a[10] * m252 - a[12] * m253;
    const double m255 = a[1] * m225 - a[5] * a[0] * m212 + a[7] * a[0] * m218;
    const double m256 = a[2] * m226 - a[6] * m249 + a[8] * m252 - a[12] * m255;
    const double m257 = a[3] * m228 - a[7] * m251 + a[9] * m254 - a[11] * m256;
    const double m258 = a[1] * m231 - a[3] * a[0] * m208 + a[11] * a[0] * m229;
    const double m259 = a[1] * m233 - a[3] * a[0] * m209 + a[9] * a[0] * m229;
    const double m260 = a[2] * m234 - a[4] * m248 + a[10] * m258 - a[12] * m259;
    const double m261 = a[1] * m236 - a[3] * a[0] * m212 + a[7] * a[0] * m229;
    const double m262 = a[2] * m237 - a[4] * m249 + a[8] * m258 - a[12] * m261;
    const double m263 = a[3] * m239 - a[5] * m251 + a[9] * m260 - a[11] * m262;
    const double m264 = a[1] * m241 - a[3] * a[0] * m218 + a[5] * a[0] * m229;
    const double m265 = a[2] * m242 - a[4] * m252 + a[6] * m258 - a[12] * m264;
    const double m266 = a[3] * m244 - a[5] * m254 + a[7] * m260 - a[11] * m265;
    const double m267 = a[3] * m246 - a[5] * m256 + a[7] * m262 - a[9] * m265;
    const double m268 = a[4] * m247 - a[6] * m257 + a[8] * m263 - a[10] * m266 + a[12] * m267;
    const double m269 = a[1] * m228 - a[7] * a[0] * m217 + a[9] * a[0] * m223 - a[11] * a[0] * m226;
    const double m270 = a[1] * m239 - a[5] * a[0] * m217 + a[9] * a[0] * m234 - a[11] * a[0] * m237;
    const double m271 = a[1] * m244 - a[5] * a[0] * m223 + a[7] * a[0] * m234 - a[11] * a[0] * m242;
    const double m272 = a[1] * m246 - a[5] * a[0] * m226 + a[7] * a[0] * m237 - a[9] * a[0] * m242;
    const double m273 = a[2] * m247 - a[6] * m269 + a[8] * m270 - a[10] * m271 + a[12] * m272;
    const double m274 = a[1] * m251 - a[3] * a[0] * m217 + a[9] * a[0] * m248 - a[11] * a[0] * m249;
    const double m275 = a[1] * m254 - a[3] * a[0] * m223 + a[7] * a[0] * m248 - a[11] * a[0] * m252;
    const double m276 = a[1] * m256 - a[3] * a[0] * m226 + a[7] * a[0] * m249 - a[9] * a[0] * m252;
    const double m277 = a[2] * m257 - a[4] * m269 + a[8] * m274 - a[10] * m275 + a[12] * m276;
    const double m278 = a[1] * m260 - a[3] * a[0] * m234 + a[5] * a[0] * m248 - a[11] * a[0] * m258;
    const double m279 = a[1] * m262 - a[3] * a[0] * m237 + a[5] * a[0] * m249 - a[9] * a[0] * m258;
    const double m280 = a[2] * m263 - a[4] * m270 + a[6] * m274 - a[10] * m278 + a[12] * m279;
    const double m281 = a[1] * m265 - a[3] * a[0] * m242 + a[5] * a[0] * m252 - a[7] * a[0] * m258;
    const double m282 = a[2] * m266 - a[4] * m271 + a[6] * m275 - a[8] * m278 + a[12] * m281;
    const double m283 = a[3] * m268 - a[5] * m273 + a[7] * m277 - a[9] * m280 + a[11] * m282;
    const double m284 = a[1] * m268 - a[5] * a[0] * m247 + a[7] * a[0] * m257 - a[9] * a[0] * m263
        + a[11] * a[0] * m266;
    const double m285 = a[1] * m273 - a[3] * a[0] * m247 + a[7] * a[0] * m269 - a[9] * a[0] * m270
        + a[11] * a[0] * m271;
    const double m286 = a[1] * m277 - a[3] * a[0] * m257 + a[5] * a[0] * m269 - a[9] * a[0] * m274
        + a[11] * a[0] * m275;
    const double m287 = a[1] * m280 - a[3] * a[0] * m263 + a[5] * a[0] * m270 - a[7] * a[0] * m274
        + a[11] * a[0] * m278;
    const double m288 = a[1] * m282 - a[3] * a[0] * m266 + a[5] * a[0] * m271 - a[7] * a[0] * m275
        + a[9] * a[0] * m278;
    const double m289 = a[2] * m283 - a[4] * m284 + a[6] * m285 - a[8] * m286 + a[10] * m287
        - a[12] * m288;
    const double m290 = a[1] * m289 - a[3] * a[0] * m283 + a[5] * a[0] * m284 - a[7] * a[0] * m285
        + a[9] * a[0] * m286 - a[11] * a[0] * m287;
    const double determinant = a[1] * m86 - a[3] * a[0] * m80 + a[5] * a[0] * m81 - a[7] * a[0] * m82
        + a[9] * a[0] * m83 - a[11] * a[0] * m84;
    const double numerator = -b[0] * m86 + b[1] * a[0] * m80 - b[2] * a[0] * m81 + b[3] * a[0] * m82
        - b[4] * a[0] * m83 + b[5] * a[0] * m84 - b[6] * a[0] * m85 + b[7] * a[0] * m88
        - b[8] * a[0] * m101 + b[9] * a[0] * m139 - b[10] * a[0] * m207
        + b[11] * a[0] * m290;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i13(const double a[14], const double b[13])
{
    const double m0 = a[11] * a[12] * a[13] - a[13] * a[10] * a[13];
    const double m1 = a[9] * a[12] * a[13] - a[13] * a[8] * a[13];
    const double m2 = a[10] * m0 - a[12] * m1;
    const double m3 = a[7] * a[12] * a[13] - a[13] * a[6] * a[13];
    const double m4 = a[8] * m0 - a[12] * m3;
    const double m5 = a[8] * m1 - a[10] * m3;
    const double m6 = a[9] * m2 - a[11] * m4 + a[13] * m5;
    const double m7 = a[5] * a[12] * a[13] - a[13] * a[4] * a[13];
    const double m8 = a[6] * m0 - a[12] * m7;
    const double m9 = a[6] * m1 - a[10] * m7;
    const double m10 = a[7] * m2 - a[11] * m8 + a[13] * m9;
    const double m11 = a[6] * m3 - a[8] * m7;
    const double m12 = a[7] * m4 - a[9] * m8 + a[13] * m11;
    const double m13 = a[8] * m6 - a[10] * m10 + a[12] * m12;
    const double m14 = a[3] * a[12] * a[13] - a[13] * a[2] * a[13];
    const double m15 = a[4] * m0 - a[12] * m14;
    const double m16 = a[4] * m1 - a[10] * m14;
    const double m17 = a[5] * m2 - a[11] * m15 + a[13] * m16;
    const double m18 = a[4] * m3 - a[8] * m14;
    const double m19 = a[5] * m4 - a[9] * m15 + a[13] * m18;
    const double m20 = a[6] * m6 - a[10] * m17 + a[12] * m19;
    const double m21 = a[4] * m7 - a[6] * m14;
    const double m22 = a[5] * m8 - a[7] * m15 + a[13] * m21;
    const double m23 = a[6] * m10 - a[8] * m17 + a[12] * m22;
    const double m24 = a[6] * m12 - a[8] * m19 + a[10] * m22;
    const double m25 = a[7] * m13 - a[9] * m20 + a[11] * m23 - a[13] * m24;
    const double m26 = a[1] * a[12] * a[13] - a[13] * a[0] * a[13];
    const double m27 = a[2] * m0 - a[12] * m26;
    const double m28 = a[2] * m1 - a[10] * m26;
    const double m29 = a[3] * m2 - a[11] * m27 + a[13] * m28;
    const double m30 = a[2] * m3 - a[8] * m26;
    const double m31 = a[3] * m4 - a[9] * m27 + a[13] * m30;
    const double m32 = a[4] * m6 - a[10] * m29 + a[12] * m31;
    const double m33 = a[2] * m7 - a[6] * m26;
    const double m34 = a[3] * m8 - a[7] * m27 + a[13] * m33;
    const double m35 = a[4] * m10 - a[8] * m29 + a[12] * m34;
    const double m36 = a[4] * m12 - a[8] * m31 + a[10] * m34;
    const double m37 = a[5] * m13 - a[9] * m32 + a[11] * m35 - a[13] * m36;
    const double m38 = a[2] * m14 - a[4] * m26;
    const double m39 = a[3] * m15 - a[5] * m27 + a[13] * m38;
    const double m40 = a[4] * m17 - a[6] * m29 + a[12] * m39;
    const double m41 = a[4] * m19 - a[6] * m31 + a[10] * m39;
    const double m42 = a[5] * m20 - a[7] * m32 + a[11] * m40 - a[13] * m41;
    const double m43 = a[4] * m22 - a[6] * m34 + a[8] * m39;
    const double m44 = a[5] * m23 - a[7] * m35 + a[9] * m40 - a[13] * m43;
    const double m45 = a[6] * m25 - a[8] * m37 + a[10] * m42 - a[12] * m44;
    const double m46 = a[1] * m2 - a[11] * a[0] * m0 + a[13] * a[0] * m1;
    const double m47 = a[1] * m4 - a[9] * a[0] * m0 + a[13] * a[0] * m3;
    const double m48 = a[2] * m6 - a[10] * m46 + a[12] * m47;
    const double m49 = a[1] * m8 - a[7] * a[0] * m0 + a[13] * a[0] * m7;
    const double m50 = a[2] * m10 - a[8] * m46 + a[12] * m49;
    const double m51 = a[2] * m12 - a[8] * m47 + a[10] * m49;
    const double m52 = a[3] * m13 - a[9] * m48 + a[11] * m50 - a[13] * m51;
    const double m53 = a[1] * m15 - a[5] * a[0] * m0 + a[13] * a[0] * m14;
    const double m54 = a[2] * m17 - a[6] * m46 + a[12] * m53;
    const double m55 = a[2] * m19 - a[6] * m47 + a[10] * m53;
    const double m56 = a[3] * m20 - a[7] * m48 + a[11] * m54 - a[13] * m55;
    const double m57 = a[2] * m22 - a[6] * m49 + a[8] * m53;
    const double m58 = a[3] * m23 - a[7] * m50 + a[9] * m54 - a[13] * m57;
    const double m59 = a[4] * m25 - a[8] * m52 + a[10] * m56 - a[12] * m58;
    const double m60 = a[1] * m27 - a[3] * a[0] * m0 + a[13] * a[0] * m26;
    const double m61 = a[2] * m29 - a[4] * m46 + a[12] * m60;
    const double m62 = a[2] * m31 - a[4] * m47 + a[10] * m60;
    const double m63 = a[3] * m32 - a[5] * m48 + a[11] * m61 - a[13] * m62;
    const double m64 = a[2] * m34 - a[4] * m49 + a[8] * m60;
    const double m65 = a[3] * m35 - a[5] * m50 + a[9] * m61 - a[13] * m64;
    const double m66 = a[4] * m37 - a[6] * m52 + a[10] * m63 - a[12] * m65;
    const double m67 = a[2] * m39 - a[4] * m53 + a[6] * m60;
    const double m68 = a[3] * m40 - a[5] * m54 + a[7] * m61 - a[13] * m67;
    const double m69 = a[4] * m42 - a[6] * m56 + a[8] * m63 - a[12] * m68;
    const double m70 = a[4] * m44 - a[6] * m58 + a[8] * m65 - a[10] * m68;
    const double m71 = a[5] * m45 - a[7] * m59 + a[9] * m66 - a[11] * m69 + a[13] * m70;
    const double m72 = a[1] * m13 - a[9] * a[0] * m6 + a[11] * a[0] * m10 - a[13] * a[0] * m12;
    const double m73 = a[1] * m20 - a[7] * a[0] * m6 + a[11] * a[0] * m17 - a[13] * a[0] * m19;
    const double m74 = a[1] * m23 - a[7] * a[0] * m10 + a[9] * a[0] * m17 - a[13] * a[0] * m22;
    const double m75 = a[2] * m25 - a[8] * m72 + a[10] * m73 - a[12] * m74;
    const double m76 = a[1] * m32 - a[5] * a[0] * m6 + a[11] * a[0] * m29 - a[13] * a[0] * m31;
    const double m77 = a[1] * m35 - a[5] * a[0] * m10 + a[9] * a[0] * m29 - a[13] * a[0] * m34;
    const double m78 = a[2] * m37 - a[6] * m72 + a[10] * m76 - a[12] * m77;
    const double m79 = a[1] * m40 - a[5] * a[0] * m17 + a[7] * a[0] * m29 - a[13] * a[0] * m39;
    const double m80 = a[2] * m42 - a[6] * m73 + a[8] * m76 - a[12] * m79;
    const double m81 = a[2] * m44 - a[6] * m74 + a[8] * m77 - a[10] * m79;
    const double m82 = a[3] * m45 - a[7] * m75 + a[9] * m78 - a[11] * m80 + a[13] * m81;
    const double m83 = a[1] * m48 - a[3] * a[0] * m6 + a[11] * a[0] * m46 - a[13] * a[0] * m47;
    const double m84 = a[1] * m50 - a[3] * a[0] * m10 + a[9] * a[0] * m46 - a[13] * a[0] * m49;
    const double m85 = a[2] * m52 - a[4] * m72 + a[10] * m83 - a[12] * m84;
    const double m86 = a[1] * m54 - a[3] * a[0] * m17 + a[7] * a[0] * m46 - a[13] * a[0] * m53;
    const double m87 = a[2] * m56 - a[4] * m73 + a[8] * m83 - a[12] * m86;
    const double m88 = a[2] * m58 - a[4] * m74 + a[8] * m84 - a[10] * m86;
    const double m89 = a[3] * m59 - a[5] * m75 + a[9] * m85 - a[11] * m87 + a[13] * m88;
    const double m90 = a[1] * m61 - a[3] * a[0] * m29 + a[5] * a[0] * m46 - a[13] * a[0] * m60;
    const double m91 = a[2] * m63 - a[4] * m76 + a[6] * m83 - a[12] * m90;
    const double m92 = a[2] * m65 - a[4] * m77 + a[6] * m84 - a[10] * m90;
    const double m93 = a[3] * m66 - a[5] * m78 + a[7] * m85 - a[11] * m91 + a[13] * m92;
    const double m94 = a[2] * m68 - a[4] * m79 + a[6] * m86 - a[8] * m90;
    const double m95 = a[3] * m69 - a[5] * m80 + a[7] * m87 - a[9] * m91 + a[13] * m94;
    const double m96 = a[4] * m71 - a[6] * m82 + a[8] * m89 - a[10] * m93 + a[12] * m95;
    const double m97 = a[1] * m45 - a[7] * a[0] * m25 + a[9] * a[0] * m37 - a[11] * a[0] * m42
        + a[13] * a[0] * m44;
    const double m98 = a[1] * m59 - a[5] * a[0] * m25 + a[9] * a[0] * m52 - a[11] * a[0] * m56
        + a[13] * a[0] * m58;
    const double m99 = a[1] * m66 - a[5] * a[0] * m37 + a[7] * a[0] * m52 - a[11] * a[0] * m63
        + a[13] * a[0] * m65;
    const double m100 = a[1] * m69 - a[5] * a[0] * m42 + a[7] * a[0] * m56 - a[9] * a[0] * m63
        + a[13] * a[0] * m68;
    const double m101 = a[2] * m71 - a[6] * m97 + a[8] * m98 - a[10] * m99 + a[12] * m100;
    const double m102 = a[1] * m75 - a[3] * a[0] * m25 + a[9] * a[0] * m72 - a[11] * a[0] * m73
        + a[13] * a[0] * m74;
    const double m103 = a[1] * m78 - a[3] * a[0] * m37 + a[7] * a[0] * m72 - a[11] * a[0] * m76
        + a[13] * a[0] * m77;
    const double m104 = a[1] * m80 - a[3] * a[0] * m42 + a[7] * a[0] * m73 - a[9] * a[0] * m76
        + a[13] * a[0] * m79;
    const double m105 = a[2] * m82 - a[4] * m97 + a[8] * m102 - a[10] * m103 + a[12] * m104;
    const double m106 = a[1] * m85 - a[3] * a[0] * m52 + a[5] * a[0] * m72 - a[11] * a[0] * m83
        + a[13] * a[0] * m84;
    const double m107 = a[1] * m87 - a[3] * a[0] * m56 + a[5] * a[0] * m73 - a[9] * a[0] * m83
        + a[13] * a[0] * m86;
    const double m108 = a[2] * m89 - a[4] * m98 + a[6] * m102 - a[10] * m106 + a[12] * m107;
    const double m109 = a[1] * m91 - a[3] * a[0] * m63 + a[5] * a[0] * m76 - a[7] * a[0] * m83
        + a[13] * a[0] * m90;
    const double m110 = a[2] * m93 - a[4] * m99 + a[6] * m103 - a[8] * m106 + a[12] * m109;
    const double m111 = a[2] * m95 - a[4] * m100 + a[6] * m104 - a[8] * m107 + a[10] * m109;
    const double m112 = a[3] * m96 - a[5] * m101 + a[7] * m105 - a[9] * m108 + a[11] * m110
        - a[13] * m111;
    const double m113 = a[1] * m96 - a[5] * a[0] * m71 + a[7] * a[0] * m82 - a[9] * a[0] * m89
        + a[11] * a[0] * m93 - a[13] * a[0] * m95;
    const double m114 = a[1] * m101 - a[3] * a[0] * m71 + a[7] * a[0] * m97 - a[9] * a[0] * m98
        + a[11] * a[0] * m99 - a[13] * a[0] * m100;
    const double m115 = a[1] * m105 - a[3] * a[0] * m82 + a[5] * a[0] * m97 - a[9] * a[0] * m102
        + a[11] * a[0] * m103 - a[13] * a[0] * m104;
    const double m116 = a[1] * m108 - a[3] * a[0] * m89 + a[5] * a[0] * m98 - a[7] * a[0] * m102
        + a[11] * a[0] * m106 - a[13] * a[0] * m107;
    const double m117 = a[1] * m110 - a[3] * a[0] * m93 + a[5] * a[0] * m99 - a[7] * a[0] * m103
        + a[9] * a[0] * m106 - a[13] * a[0] * m109;
    const double m118 = a[2] * m112 - a[4] * m113 + a[6] * m114 - a[8] * m115 + a[10] * m116
        - a[12] * m117;
    const double m119 = a[1] * m111 - a[3] * a[0] * m95 + a[5] * a[0] * m100 - a[7] * a[0] * m104
        + a[9] * a[0] * m107 - a[11] * a[0] * m109;
    const double m120 = a[3] * m70 - a[5] * m81 + a[7] * m88 - a[9] * m92 + a[11] * m94;
    const double m121 = a[1] * m70 - a[5] * a[0] * m44 + a[7] * a[0] * m58 - a[9] * a[0] * m65
        + a[11] * a[0] * m68;
    const double m122 = a[1] * m81 - a[3] * a[0] * m44 + a[7] * a[0] * m74 - a[9] * a[0] * m77
        + a[11] * a[0] * m79;
    const double m123 = a[1] * m88 - a[3] * a[0] * m58 + a[5] * a[0] * m74 - a[9] * a[0] * m84
        + a[11] * a[0] * m86;
    const double m124 = a[1] * m92 - a[3] * a[0] * m65 + a[5] * a[0] * m77 - a[7] * a[0] * m84
        + a[11] * a[0] * m90;
    const double m125 = a[1] * m94 - a[3] * a[0] * m68 + a[5] * a[0] * m79 - a[7] * a[0] * m86
        + a[9] * a[0] * m90;
    const double m126 = a[2] * m120 - a[4] * m121 + a[6] * m122 - a[8] * m123 + a[10] * m124
        - a[12] * m125;
    const double m127 = a[1] * m126 - a[3] * a[0] * m120 + a[5] * a[0] * m121 - a[7] * a[0] * m122
        + a[9] * a[0] * m123 - a[11] * a[0] * m124 + a[13] * a[0] * m125;
    const double m128 = a[5] * m24 - a[7] * m36 + a[9] * m41 - a[11] * m43;
    const double m129 = a[3] * m24 - a[7] * m51 + a[9] * m55 - a[11] * m57;
    const double m130 = a[3] * m36 - a[5] * m51 + a[9] * m62 - a[11] * m64;
    const double m131 = a[3] * m41 - a[5] * m55 + a[7] * m62 - a[11] * m67;
    const double m132 = a[3] * m43 - a[5] * m57 + a[7] * m64 - a[9] * m67;
    const double m133 = a[4] * m128 - a[6] * m129 + a[8] * m130 - a[10] * m131 + a[12] * m132;
    const double m134 = a[1] * m24 - a[7] * a[0] * m12 + a[9] * a[0] * m19 - a[11] * a[0] * m22;
    const double m135 = a[1] * m36 - a[5] * a[0] * m12 + a[9] * a[0] * m31 - a[11] * a[0] * m34;
    const double m136 = a[1] * m41 - a[5] * a[0] * m19 + a[7] * a[0] * m31 - a[11] * a[0] * m39;
    const double m137 = a[1] * m43 - a[5] * a[0] * m22 + a[7] * a[0] * m34 - a[9] * a[0] * m39;
    const double m138 = a[2] * m128 - a[6] * m134 + a[8] * m135 - a[10] * m136 + a[12] * m137;
    const double m139 = a[1] * m51 - a[3] * a[0] * m12 + a[9] * a[0] * m47 - a[11] * a[0] * m49;
    const double m140 = a[1] * m55 - a[3] * a[0] * m19 + a[7] * a[0] * m47 - a[11] * a[0] * m53;
    const double m141 = a[1] * m57 - a[3] * a[0] * m22 + a[7] * a[0] * m49 - a[9] * a[0] * m53;
    const double m142 = a[2] * m129 - a[4] * m134 + a[8] * m139 - a[10] * m140 + a[12] * m141;
    const double m143 = a[1] * m62 - a[3] * a[0] * m31 + a[5] * a[0] * m47 - a[11] * a[0] * m60;
    const double m144 = a[1] * m64 - a[3] * a[0] * m34 + a[5] * a[0] * m49 - a[9] * a[0] * m60;
    const double m145 = a[2] * m130 - a[4] * m135 + a[6] * m139 - a[10] * m143 + a[12] * m144;
    const double m146 = a[1] * m67 - a[3] * a[0] * m39 + a[5] * a[0] * m53 - a[7] * a[0] * m60;
    const double m147 = a[2] * m131 - a[4] * m136 + a[6] * m140 - a[8] * m143 + a[12] * m146;
    const double m148 = a[2] * m132 - a[4] * m137 + a[6] * m141 - a[8] * m144 + a[10] * m146;
    const double m149 = a[3] * m133 - a[5] * m138 + a[7] * m142 - a[9] * m145 + a[11] * m147
        - a[13] * m148;
    const double m150 = a[1] * m133 - a[5] * a[0] * m128 + a[7] * a[0] * m129 - a[9] * a[0] * m130
        + a[11] * a[0] * m131 - a[13] * a[0] * m132;
    const double m151 = a[1] * m138 - a[3] * a[0] * m128 + a[7] * a[0] * m134 - a[9] * a[0] * m135
        + a[11] * a[0] * m136 - a[13] * a[0] * m137;
    const double m152 = a[1] * m142 - a[3] * a[0] * m129 + a[5] * a[0] * m134 - a[9] * a[0] * m139
        + a[11] * a[0] * m140 - a[13] * a[0] * m141;
    const double m153 = a[1] * m145 - a[3] * a[0] * m130 + a[5] * a[0] * m135 - a[7] * a[0] * m139
        + a[11] * a[0] * m143 - a[13] * a[0] * m144;
    const double m154 = a[1] * m147 - a[3] * a[0] * m131 + a[5] * a[0] * m136 - a[7] * a[0] * m140
        + a[9] * a[0] * m143 - a[13] * a[0] * m146;
    const double m155 = a[2] * m149 - a[4] * m150 + a[6] * m151 - a[8] * m152 + a[10] * m153
        - a[12] * m154;
    const double m156 = a[1] * m155 - a[3] * a[0] * m149 + a[5] * a[0] * m150 - a[7] * a[0] * m151
        + a[9] * a[0] * m152 - a[11] * a[0] * m153 + a[13] * a[0] * m154;
    const double m157 = a[7] * m5 - a[9] * m9 + a[11] * m11;
    const double m158 = a[5] * m5 - a[9] * m16 + a[11] * m18;
    const double m159 = a[5] * m9 - a[7] * m16 + a[11] * m21;
    const double m160 = a[5] * m11 - a[7] * m18 + a[9] * m21;
    const double m161 = a[6] * m157 - a[8] * m158 + a[10] * m159 - a[12] * m160;
    const double m162 = a[3] * m5 - a[9] * m28 + a[11] * m30;
    const double m163 = a[3] * m9 - a[7] * m28 + a[11] * m33;
    const double m164 = a[3] * m11 - a[7] * m30 + a[9] * m33;
    const double m165 = a[4] * m157 - a[8] * m162 + a[10] * m163 - a[12] * m164;
    const double m166 = a[3] * m16 - a[5] * m28 + a[11] * m38;
    const double m167 = a[3] * m18 - a[5] * m30 + a[9] * m38;
    const double m168 = a[4] * m158 - a[6] * m162 + a[10] * m166 - a[12] * m167;
    const double m169 = a[3] * m21 - a[5] * m33 + a[7] * m38;
    const double m170 = a[4] * m159 - a[6] * m163 + a[8] * m166 - a[12] * m169;
    const double m171 = a[4] * m160 - a[6] * m164 + a[8] * m167 - a[10] * m169;
    const double m172 = a[5] * m161 - a[7] * m165 + a[9] * m168 - a[11] * m170 + a[13] * m171;
    const double m173 = a[1] * m5 - a[9] * a[0] * m1 + a[11] * a[0] * m3;
    const double m174 = a[1] * m9 - a[7] * a[0] * m1 + a[11] * a[0] * m7;
    const double m175 = a[1] * m11 - a[7] * a[0] * m3 + a[9] * a[0] * m7;
    const double m176 = a[2] * m157 - a[8] * m173 + a[10] * m174 - a[12] * m175;
    const double m177 = a[1] * m16 - a[5] * a[0] * m1 + a[11] * a[0] * m14;
    const double m178 = a[1] * m18 - a[5] * a[0] * m3 + a[9] * a[0] * m14;
    const double m179 = a[2] * m158 - a[6] * m173 + a[10] * m177 - a[12] * m178;
    const double m180 = a[1] * m21 - a[5] * a[0] * m7 + a[7] * a[0] * m14;
    const double m181 = a[2] * m159 - a[6] * m174 + a[8] * m177 - a[12] * m180;
    const double m182 = a[2] * m160 - a[6] * m175 + a[8] * m178 - a[10] * m180;
    const double m183 = a[3] * m161 - a[7] * m176 + a[9] * m179 - a[11] * m181 + a[13] * m182;
    const double m184 = a[1] * m28 - a[3] * a[0] * m1 + a[11] * a[0] * m26;
    const double m185 = a[1] * m30 - a[3] * a[0] * m3 + a[9] * a[0] * m26;
    const double m186 = a[2] * m162 - a[4] * m173 + a[10] * m184 - a[12] * m185;
    const double m187 = a[1] * m33 - a[3] * a[0] * m7 + a[7] * a[0] * m26;
    const double m188 = a[2] * m163 - a[4] * m174 + a[8] * m184 - a[12] * m187;
    const double m189 = a[2] * m164 - a[4] * m175 + a[8] * m185 - a[10] * m187;
    const double m190 = a[3] * m165 - a[5] * m176 + a[9] * m186 - a[11] * m188 + a[13] * m189;
    const double m191 = a[1] * m38 - a[3] * a[0] * m14 + a[5] * a[0] * m26;
    const double m192 = a[2] * m166 - a[4] * m177 + a[6] * m184 - a[12] * m191;
    const double m193 = a[2] * m167 - a[4] * m178 + a[6] * m185 - a[10] * m191;
    const double m194 = a[3] * m168 - a[5] * m179 + a[7] * m186 - a[11] * m192 + a[13] * m193;
    const double m195 = a[2] * m169 - a[4] * m180 + a[6] * m187 - a[8] * m191;
    const double m196 = a[3] * m170 - a[5] * m181 + a[7] * m188 - a[9] * m192 + a[13] * m195;
    const double m197 = a[4] * m172 - a[6] * m183 + a[8] * m190 - a[10] * m194 + a[12] * m196;
    const double m198 = a[1] * m161 - a[7] * a[0] * m157 + a[9] * a[0] * m158 - a[11] * a[0] * m159
        + a[13] * a[0] * m160;
    const double m199 = a[1] * m165 - a[5] * a[0] * m157 + a[9] * a[0] * m162 - a[11] * a[0] * m163
        + a[13] * a[0] * m164;
    const double m200 = a[1] * m168 - a[5] * a[0] * m158 + a[7] * a[0] * m162 - a[11] * a[0] * m166
        + a[13] * a[0] * m167;
    const double m201 = a[1] * m170 - a[5] * a[0] * m159 + a[7] * a[0] * m163 - a[9] * a[0] * m166
        + a[13] * a[0] * m169;
    const double m202 = a[2] * m172 - a[6] * m198 + a[8] * m199 - a[10] * m200 + a[12] * m201;
    const double m203 = a[1] * m176 - a[3] * a[0] * m157 + a[9] * a[0] * m173 - a[11] * a[0] * m174
        + a[13] * a[0] * m175;
    const double m204 = a[1] * m179 - a[3] * a[0] * m158 + a[7] * a[0] * m173 - a[11] * a[0] * m177
        + a[13] * a[0] * m178;
    const double m205 = a[1] * m181 - a[3] * a[0] * m159 + a[7] * a[0] * m174 - a[9] * a[0] * m177
        + a[13] * a[0] * m180;
    const double m206 = a[2] * m183 - a[4] * m198 + a[8] * m203 - a[10] * m204 + a[12] * m205;
    const double m207 = a[1] * m186 - a[3] * a[0] * m162 + a[5] * a[0] * m173 - a[11] * a[0] * m184
        + a[13] * a[0] * m185;
    const double m208 = a[1] * m188 - a[3] * a[0] * m163 + a[5] * a[0] * m174 - a[9] * a[0] * m184
        + a[13] * a[0] * m187;
    const double m209 = a[2] * m190 - a[4] * m199 + a[6] * m203 - a[10] * m207 + a[12] * m208;
    const double m210 = a[1] * m192 - a[3] * a[0] * m166 + a[5] * a[0] * m177 - a[7] * a[0] * m184
        + a[13] * a[0] * m191;
    const double m211 = a[2] * m194 - a[4] * m200 + a[6] * m204 - a[8] * m207 + a[12] * m210;
    const double m212 = a[2] * m196 - a[4] * m201 + a[6] * m205 - a[8] * m208 + a[10] * m210;
    const double m213 = a[3] * m197 - a[5] * m202 + a[7] * m206 - a[9] * m209 + a[11] * m211
        - a[13] * m212;
    const double m214 = a[1] * m197 - a[5] * a[0] * m172 + a[7] * a[0] * m183 - a[9] * a[0] * m190
        + a[11] * a[0] * m194 - a[13] * a[0] * m196;
    const double m215 = a[1] * m202 - a[3] * a[0] * m172 + a[7] * a[0] * m198 - a[9] * a[0] * m199
        + a[11] * a[0] * m200 - a[13] * a[0] * m201;
    const double m216 = a[1] * m206 - a[3] * a[0] * m183 + a[5] * a[0] * m198 - a[9] * a[0] * m203
        + a[11] * a[0] * m204 - a[13] * a[0] * m205;
    const double m217 = a[1] * m209 - a[3] * a[0] * m190 + a[5] * a[0] * m199 - a[7] * a[0] * m203
        + a[11] * a[0] * m207 - a[13] * a[0] * m208;
    const double m218 = a[1] * m211 - a[3] * a[0] * m194 + a[5] * a[0] * m200 - a[7] * a[0] * m204
        + a[9] * a[0] * m207 - a[13] * a[0] * m210;
    const double m219 = a[2] * m213 - a[4] * m214 + a[6] * m215 - a[8] * m216 + a[10] * m217
        - a[12] * m218;
    const double m220 = a[1] * m219 - a[3] * a[0] * m213 + a[5] * a[0] * m214 - a[7] * a[0] * m215
        + a[9] * a[0] * m216 - a[11] * a[0] * m217 + a[13] * a[0] * m218;
    const double m221 = a[9] * a[10] * a[13] - a[11] * a[8] * a[13];
    const double m222 = a[7] * a[10] * a[13] - a[11] * a[6] * a[13];
    const double m223 = a[7] * a[8] * a[13] - a[9] * a[6] * a[13];
    const double m224 = a[8] * m221 - a[10] * m222 + a[12] * m223;
    const double m225 = a[5] * a[10] * a[13] - a[11] * a[4] * a[13];
    const double m226 = a[5] * a[8] * a[13] - a[9] * a[4] * a[13];
    const double m227 = a[6] * m221 - a[10] * m225 + a[12] * m226;
    const double m228 = a[5] * a[6] * a[13] - a[7] * a[4] * a[13];
    const double m229 = a[6] * m222 - a[8] * m225 + a[12] * m228;
    const double m230 = a[6] * m223 - a[8] * m226 + a[10] * m228;
    const double m231 = a[7] * m224 - a[9] * m227 + a[11] * m229 - a[13] * m230;
    const double m232 = a[3] * a[10] * a[13] - a[11] * a[2] * a[13];
    const double m233 = a[3] * a[8] * a[13] - a[9] * a[2] * a[13];
    const double m234 = a[4] * m221 - a[10] * m232 + a[12] * m233;
    const double m235 = a[3] * a[6] * a[13] - a[7] * a[2] * a[13];
    const double m236 = a[4] * m222 - a[8] * m232 + a[12] * m235;
    const double m237 = a[4] * m223 - a[8] * m233 + a[10] * m235;
    const double m238 = a[5] * m224 - a[9] * m234 + a[11] * m236 - a[13] * m237;
    const double m239 = a[3] * a[4] * a[13] - a[5] * a[2] * a[13];
    const double m240 = a[4] * m225 - a[6] * m232 + a[12] * m239;
    const double m241 = a[4] * m226 - a[6] * m233 + a[10] * m239;
    const double m242 = a[5] * m227 - a[7] * m234 + a[11] * m240 - a[13] * m241;
    const double m243 = a[4] * m228 - a[6] * m235 + a[8] * m239;
    const double m244 = a[5] * m229 - a[7] * m236 + a[9] * m240 - a[13] * m243;
    const double m245 = a[6] * m231 - a[8] * m238 + a[10] * m242 - a[12] * m244;
    const double m246 = a[1] * a[10] * a[13] - a[11] * a[0] * a[13];
    const double m247 = a[1] * a[8] * a[13] - a[9] * a[0] * a[13];
    const double m248 = a[2] * m221 - a[10] * m246 + a[12] * m247;
    const double m249 = a[1] * a[6] * a[13] - a[7] * a[0] * a[13];
    const double m250 = a[2] * m222 - a[8] * m246 + a[12] * m249;
    const double m251 = a[2] * m223 - a[8] * m247 + a[10] * m249;
    const double m252 = a[3] * m224 - a[9] * m248 + a[11] * m250 - a[13] * m251;
    const double m253 = a[1] * a[4] * a[13] - a[5] * a[0] * a[13];
    const double m254 = a[2] * m225 - a[6] * m246 + a[12] * m253;
    const double m255 = a[2] * m226 - a[6] * m247 + a[10] * m253;
    const double m256 = a[3] * m227 - a[7] * m248 + a[11] * m254 - a[13] * m255;
    const double m257 = a[2] * m228 - a[6] * m249 + a[8] * m253;
    const double m258 = a[3] * m229 - a[7] * m250 + a[9] * m254 - a[13] * m257;
    const double m259 = a[4] * m231 - a[8] * m252 + a[10] * m256 - a[12] * m258;
    const double m260 = a[1] * a[2] * a[13] - a[3] * a[0] * a[13];
    const double m261 = a[2] * m232 - a[4] * m246 + a[12] * m260;
    const double m262 = a[2] * m233 - a[4] * m247 + a[10] * m260;
    const double m263 = a[3] * m234 - a[5] * m248 + a[11] * m261 - a[13] * m262;
    const double m264 = a[2] * m235 - a[4] * m249 + a[8] * m260;
    const double m265 = a[3] * m236 - a[5] * m250 + a[9] * m261 - a[13] * m264;
    const double m266 = a[4] * m238 - a[6] * m252 + a[10] * m263 - a[12] * m265;
    const double m267 = a[2] * m239 - a[4] * m253 + a[6] * m260;
    const double m268 = a[3] * m240 - a[5] * m254 + a[7] * m261 - a[13] * m267;
    const double m269 = a[4] * m242 - a[6] * m256 + a[8] * m263 - a[12] * m268;
    const double m270 = a[4] * m244 - a[6] * m258 + a[8] * m265 - a[10] * m268;
    const double m271 = a[5] * m245 - a[7] * m259 + a[9] * m266 - a[11] * m269 + a[13] * m270;
    const double m272 = a[1] * m224 - a[9] * a[0] * m221 + a[11] * a[0] * m222 - a[13] * a[0] * m223;
    const double m273 = a[1] * m227 - a[7] * a[0] * m221 + a[11] * a[0] * m225 - a[13] * a[0] * m226;
    const double m274 = a[1] * m229 - a[7] * a[0] * m222 + a[9] * a[0] * m225 - a[13] * a[0] * m228;
    const double m275 = a[2] * m231 - a[8] * m272 + a[10] * m273 - a[12] * m274;
    const double m276 = a[1] * m234 - a[5] * a[0] * m221 + a[11] * a[0] * m232 - a[13] * a[0] * m233;
    const double m277 = a[1] * m236 - a[5] * a[0] * m222 + a[9] * a[0] * m232 - a[13] * a[0] * m235;
    const double m278 = a[2] * m238 - a[6] * m272 + a[10] * m276 - a[12] * m277;
    const double m279 = a[1] * m240 - a[5] * a[0] * m225 + a[7] * a[0] * m232 - a[13] * a[0] * m239;
    const double m280 = a[2] * m242 - a[6] * m273 + a[8] * m276 - a[12] * m279;
    const double m281 = a[2] * m244 - a[6] * m274 + a[8] * m277 - a[10] * m279;
    const double m282 = a[3] * m245 - a[7] * m275 + a[9] * m278 - a[11] * m280 + a[13] * m281;
    const double m283 = a[1] * m248 - a[3] * a[0] * m221 + a[11] * a[0] * m246 - a[13] * a[0] * m247;
    const double m284 = a[1] * m250 - a[3] * a[0] * m222 + a[9] * a[0] * m246 - a[13] * a[0] * m249;
    const double m285 = a[2] * m252 - a[4] * m272 + a[10] * m283 - a[12] * m284;
    const double m286 = a[1] * m254 - a[3] * a[0] * m225 + a[7] * a[0] * m246 - a[13] * a[0] * m253;
    const double m287 = a[2] * m256 - a[4] * m273 + a[8] * m283 - a[12] * m286;
    const double m288 = a[2] * m258 - a[4] * m274 + a[8] * m284 - a[10] * m286;
    const double m289 = a[3] * m259 - a[5] * m275 + a[9] * m285 - a[11] * m287 + a[13] * m288;
    const double m290 = a[1] * m261 - a[3] * a[0] * m232 + a[5] * a[0] * m246 - a[13] * a[0] * m260;
    const double m291 = a[2] * m263 - a[4] * m276 + a[6] * m283 - a[12] * m290;
    const double m292 = a[2] * m265 - a[4] * m277 + a[6] * m284 - a[10] * m290;
    const double m293 = a[3] * m266 - a[5] * m278 + a[7] * m285 - a[11] * m291 + a[13] * m292;
    const double m294 = a[2] * m268 - a[4] * m279 + a[6] * m286 - a[8] * m290;
    const double m295 = a[3] * m269 - a[5] * m280 + a[7] * m287 - a[9] * m291 + a[13] * m294;
    const double m296 = a[4] * m271 - a[6] * m282 + a[8] * m289 - a[10] * m293 + a[12] * m295;
    const double m297 = a[1] * m245 - a[7] * a[0] * m231 + a[9] * a[0] * m238 - a[11] * a[0] * m242
        + a[13] * a[0] * m244;
    const double m298 = a[1] * m259 - a[5] * a[0] * m231 + a[9] * a[0] * m252 - a[11] * a[0] * m256
        + a[13] * a[0] * m258;
    const double m299 = a[1] * m266 - a[5] * a[0] * m238 + a[7] * a[0] * m252 - a[11] * a[0] * m263
        + a[13] * a[0] * m265;
    const double m300 = a[1] * m269 - a[5] * a[0] * m242 + a[7] * a[0] * m256 - a[9] * a[0] * m263
        + a[13] * a[0] * m268;
    const double m301 = a[2] * m271 - a[6] * m297 + a[8] * m298 - a[10] * m299 + a[12] * m300;
    const double m302 = a[1] * m275 - a[3] * a[0] * m231 + a[9] * a[0] * m272 - a[11] * a[0] * m273
        + a[13] * a[0] * m274;
    const double m303 = a[1] * m278 - a[3] * a[0] * m238 + a[7] * a[0] * m272 - a[11] * a[0] * m276
        + a[13] * a[0] * m277;
    const double m304 = a[1] * m280 - a[3] * a[0] * m242 + a[7] * a[0] * m273 - a[9] * a[0] * m276
        + a[13] * a[0] * m279;
    const double m305 = a[2] * m282 - a[4] * m297 + a[8] * m302 - a[10] * m303 + a[12] * m304;
    const double m306 = a[1] * m285 - a[3] * a[0] * m252 + a[5] * a[0] * m272 - a[11] * a[0] * m283
        + a[13] * a[0] * m284;
    const double m307 = a[1] * m287 - a[3] * a[0] * m256 + a[5] * a[0] * m273 - a[9] * a[0] * m283
        + a[13] * a[0] * m286;
    const double m308 = a[2] * m289 - a[4] * m298 + a[6] * m302 - a[10] * m306 + a[12] * m307;
    const double m309 = a[1] * m291 - a[3] * a[0] * m263 + a[5] * a[0] * m276 - a[7] * a[0] * m283
        + a[13] * a[0] * m290;
    const double m310 = a[2] * m293 - a[4] * m299 + a[6] * m303 - a[8] * m306 + a[12] * m309;
    const double m311 = a[2] * m295 - a[4] * m300 + a[6] * m304 - a[8] * m307 + a[10] * m309;
    const double m312 = a[3] * m296 - a[5] * m301 + a[7] * m305 - a[9] * m308 + a[11] * m310
        - a[13] * m311;
    const double m313 = a[1] * m296 - a[5] * a[0] * m271 + a[7] * a[0] * m282 - a[9] * a[0] * m289
        + a[11] * a[0] * m293 - a[13] * a[0] * m295;
    const double m314 = a[1] * m301 - a[3] * a[0] * m271 + a[7] * a[0] * m297 - a[9] * a[0] * m298
        + a[11] * a[0] * m299 - a[13] * a[0] * m300;
    const double m315 = a[1] * m305 - a[3] * a[0] * m282 + a[5] * a[0] * m297 - a[9] * a[0] * m302
        + a[11] * a[0] * m303 - a[13] * a[0] * m304;
    const double m316 = a[1] * m308 - a[3] * a[0] * m289 + a[5] * a[0] * m298 - a[7] * a[0] * m302
        + a[11] * a[0] * m306 - a[13] * a[0] * m307;
    const double m317 = a[1] * m310 - a[3] * a[0] * m293 + a[5] * a[0] * m299 - a[7] * a[0] * m303
        + a[9] * a[0] * m306 - a[13] * a[0] * m309;
    const double m318 = a[2] * m312 - a[4] * m313 + a[6] * m314 - a[8] * m315 + a[10] * m316
        - a[12] * m317;
    const double m319 = a[1] * m318 - a[3] * a[0] * m312 + a[5] * a[0] * m313 - a[7] * a[0] * m314
        + a[9] * a[0] * m315 - a[11] * a[0] * m316 + a[13] * a[0] * m317;
    const double m320 = a[10] * a[11] - a[12] * a[9];
    const double m321 = a[8] * a[11] - a[12] * a[7];
    const double m322 = a[8] * a[9] - a[10] * a[7];
    const double m323 = a[9] * m320 - a[11] * m321 + a[13] * m322;
    const double m324 = a[6] * a[11] - a[12] * a[5];
    const double m325 = a[6] * a[9] - a[10] * a[5];
    const double m326 = a[7] * m320 - a[11] * m324 + a[13] * m325;
    const double m327 = a[6] * a[7] - a[8] * a[5];
    const double m328 = a[7] * m321 - a[9] * m324 + a[13] * m327;
    const double m329 = a[8] * m323 - a[10] * m326 + a[12] * m328;
    const double m330 = a[4] * a[11] - a[12] * a[3];
    const double m331 = a[4] * a[9] - a[10] * a[3];
    const double m332 = a[5] * m320 - a[11] * m330 + a[13] * m331;
    const double m333 = a[4] * a[7] - a[8] * a[3];
    const double m334 = a[5] * m321 - a[9] * m330 + a[13] * m333;
    const double m335 = a[6] * m323 - a[10] * m332 + a[12] * m334;
    const double m336 = a[4] * a[5] - a[6] * a[3];
    const double m337 = a[5] * m324 - a[7] * m330 + a[13] * m336;
    const double m338 = a[6] * m326 - a[8] * m332 + a[12] * m337;
    const double m339 = a[6] * m328 - a[8] * m334 + a[10] * m337;
    const double m340 = a[7] * m329 - a[9] * m335 + a[11] * m338 - a[13] * m339;
    const double m341 = a[2] * a[11] - a[12] * a[1];
    const double m342 = a[2] * a[9] - a[10] * a[1];
    const double m343 = a[3] * m320 - a[11] * m341 + a[13] * m342;
    const double m344 = a[2] * a[7] - a[8] * a[1];
    const double m345 = a[3] * m321 - a[9] * m341 + a[13] * m344;
    const double m346 = a[4] * m323 - a[10] * m343 + a[12] * m345;
    const double m347 = a[2] * a[5] - a[6] * a[1];
    const double m348 = a[3] * m324 - a[7] * m341 + a[13] * m347;
    const double m349 = a[4] * m326 - a[8] * m343 + a[12] * m348;
    const double m350 = a[4] * m328 - a[8] * m345 + a[10] * m348;
    const double m351 = a[5] * m329 - a[9] * m346 + a[11] * m349 - a[13] * m350;
    const double m352 = a[2] * a[3] - a[4] * a[1];
    const double m353 = a[3] * m330 - a[5] * m341 + a[13] * m352;
    const double m354 = a[4] * m332 - a[6] * m343 + a[12] * m353;
    const double m355 = a[4] * m334 - a[6] * m345 + a[10] * m353;
    const double m356 = a[5] * m335 - a[7] * m346 + a[11] * m354 - a[13] * m355;
    const double m357 = a[4] * m337 - a[6] * m348 + a[8] * m353;
    const double m358 = a[5] * m338 - a[7] * m349 + a[9] * m354 - a[13] * m357;
    const double m359 = a[6] * m340 - a[8] * m351 + a[10] * m356 - a[12] * m358;
    const double m360 = a[1] * m320 - a[11] * a[0] * a[11] + a[13] * a[0] * a[9];
    const double m361 = a[1] * m321 - a[9] * a[0] * a[11] + a[13] * a[0] * a[7];
    const double m362 = a[2] * m323 - a[10] * m360 + a[12] * m361;
    const double m363 = a[1] * m324 - a[7] * a[0] * a[11] + a[13] * a[0] * a[5];
    const double m364 = a[2] * m326 - a[8] * m360 + a[12] * m363;
    const double m365 = a[2] * m328 - a[8] * m361 + a[10] * m363;
    const double m366 = a[3] * m329 - a[9] * m362 + a[11] * m364 - a[13] * m365;
    const double m367 = a[1] * m330 - a[5] * a[0] * a[11] + a[13] * a[0] * a[3];
    const double m368 = a[2] * m332 - a[6] * m360 + a[12] * m367;
    const double m369 = a[2] * m334 - a[6] * m361 + a[10] * m367;
    const double m370 = a[3] * m335 - a[7] * m362 + a[11] * m368 - a[13] * m369;
    const double m371 = a[2] * m337 - a[6] * m363 + a[8] * m367;
    const double m372 = a[3] * m338 - a[7] * m364 + a[9] * m368 - a[13] * m371;
    const double m373 = a[4] * m340 - a[8] * m366 + a[10] * m370 - a[12] * m372;
    const double m374 = a[1] * m341 - a[3] * a[0] * a[11] + a[13] * a[0] * a[1];
    const double m375 = a[2] * m343 - a[4] * m360 + a[12] * m374;
    const double m376 = a[2] * m345 - a[4] * m361 + a[10] * m374;
    const double m377 = a[3] * m346 - a[5] * m362 + a[11] * m375 - a[13] * m376;
    const double m378 = a[2] * m348 - a[4] * m363 + a[8] * m374;
    const double m379 = a[3] * m349 - a[5] * m364 + a[9] * m375 - a[13] * m378;
    const double m380 = a[4] * m351 - a[6] * m366 + a[10] * m377 - a[12] * m379;
    const double m381 = a[2] * m353 - a[4] * m367 + a[6] * m374;
    const double m382 = a[3] * m354 - a[5] * m368 + a[7] * m375 - a[13] * m381;
    const double m383 = a[4] * m356 - a[6] * m370 + a[8] * m377 - a[12] * m382;
    const double m384 = a[4] * m358 - a[6] * m372 + a[8] * m379 - a[10] * m382;
    const double m385 = a[5] * m359 - a[7] * m373 + a[9] * m380 - a[11] * m383 + a[13] * m384;
    const double m386 = a[1] * m329 - a[9] * a[0] * m323 + a[11] * a[0] * m326 - a[13] * a[0] * m328;
    const double m387 = a[1] * m335 - a[7] * a[0] * m323 + a[11] * a[0] * m332 - a[13] * a[0] * m334;
    const double m388 = a[1] * m338 - a[7] * a[0] * m326 + a[9] * a[0] * m332 - a[13] * a[0] * m337;
    const double m389 = a[2] * m340 - a[8] * m386 + a[10] * m387 - a[12] * m388;
    const double m390 = a[1] * m346 - a[5] * a[0] * m323 + a[11] * a[0] * m343 - a[13] * a[0] * m345;
    const double m391 = a[1] * m349 - a[5] * a[0] * m326 + a[9] * a[0] * m343 - a[13] * a[0] * m348;
    const double m392 = a[2] * m351 - a[6] * m386 + a[10] * m390 - a[12] * m391;
    const double m393 = a[1] * m354 - a[5] * a[0] * m332 + a[7] * a[0] * m343 - a[13] * a[0] * m353;
    const double m394 = a[2] * m356 - a[6] * m387 + a[8] * m390 - a[12] * m393;
    const double m395 = a[2] * m358 - a[6] * m388 + a[8] * m391 - a[10] * m393;
    const double m396 = a[3] * m359 - a[7] * m389 + a[9] * m392 - a[11] * m394 + a[13] * m395;
    const double m397 = a[1] * m362 - a[3] * a[0] * m323 + a[11] * a[0] * m360 - a[13] * a[0] * m361;
    const double m398 = a[1] * m364 - a[3] * a[0] * m326 + a[9] * a[0] * m360 - a[13] * a[0] * m363;
    const double m399 = a[2] * m366 - a[4] * m386 + a[10] * m397 - a[12] * m398;
    const double m400 = a[1] * m368 - a[3] * a[0] * m332 + a[7] * a[0] * m360 - a[13] * a[0] * m367;
    const double m401 = a[2] * m370 - a[4] * m387 + a[8] * m397 - a[12] * m400;
    const double m402 = a[2] * m372 - a[4] * m388 + a[8] * m398 - a[10] * m400;
    const double m403 = a[3] * m373 - a[5] * m389 + a[9] * m399 - a[11] * m401 + a[13] * m402;
    const double m404 = a[1] * m375 - a[3] * a[0] * m343 + a[5] * a[0] * m360 - a[13] * a[0] * m374;
    const double m405 = a[2] * m377 - a[4] * m390 + a[6] * m397 - a[12] * m404;
    const double m406 = a[2] * m379 - a[4] * m391 + a[6] * m398 - a[10] * m404;
    const double m407 = a[3] * m380 - a[5] * m392 + a[7] * m399 - a[11] * m405 + a[13] * m406;
    const double m408 = a[2] * m382 - a[4] * m393 + a[6] * m400 - a[8] * m404;
    const double m409 = a[3] * m383 - a[5] * m394 + a[7] * m401 - a[9] * m405 + a[13] * m408;
    const double m410 = a[4] * m385 - a[6] * m396 + a[8] * m403 - a[10] * m407 + a[12] * m409;
    const double m411 = a[1] * m359 - a[7] * a[0] * m340 + a[9] * a[0] * m351 - a[11] * a[0] * m356
        + a[13] * a[0] * m358;
    const double m412 = a[1] * m373 - a[5] * a[0] * m340 + a[9] * a[0] * m366 - a[11] * a[0] * m370
        + a[13] * a[0] * m372;
    const double m413 = a[1] * m380 - a[5] * a[0] * m351 + a[7] * a[0] * m366 - a[11] * a[0] * m377
        + a[13] * a[0] * m379;
    const double m414 = a[1] * m383 - a[5] * a[0] * m356 + a[7] * a[0] * m370 - a[9] * a[0] * m377
        + a[13] * a[0] * m382;
    const double m415 = a[2] * m385 - a[6] * m411 + a[8] * m412 - a[10] * m413 + a[12] * m414;
    const double m416 = a[1] * m389 - a[3] * a[0] * m340 + a[9] * a[0] * m386 - a[11] * a[0] * m387
        + a[13] * a[0] * m388;
    const double m417 = a[1] * m392 - a[3] * a[0] * m351 + a[7] * a[0] * m386 - a[11] * a[0] * m390
        + a[13] * a[0] * m391;
    const double m418 = a[1] * m394 - a[3] * a[0] * m356 + a[7] * a[0] * m387 - a[9] * a[0] * m390
        + a[13] * a[0] * m393;
    const double m419 = a[2] * m396 - a[4] * m411 + a[8] * m416 - a[10] * m417 + a[12] * m418;
    const double m420 = a[1] * m399 - a[3] * a[0] * m366 + a[5] * a[0] * m386 - a[11] * a[0] * m397
        + a[13] * a[0] * m398;
    const double m421 = a[1] * m401 - a[3] * a[0] * m370 + a[5] * a[0] * m387 - a[9] * a[0] * m397
        + a[13] * a[0] * m400;
    const double m422 = a[2] * m403 - a[4] * m412 + a[6] * m416 - a[10] * m420 + a[12] * m421;
    const double m423 = a[1] * m405 - a[3] * a[0] * m377 + a[5] * a[0] * m390 - a[7] * a[0] * m397
        + a[13] * a[0] * m404;
    const double m424 = a[2] * m407 - a[4] * m413 + a[6] * m417 - a[8] * m420 + a[12] * m423;
    const double m425 = a[2] * m409 - a[4] * m414 + a[6] * m418 - a[8] * m421 + a[10] * m423;
    const double m426 = a[3] * m410 - a[5] * m415 + a[7] * m419 - a[9] * m422 + a[11] * m424
        - a[13] * m425;
    const double m427 = a[1] * m410 - a[5] * a[0] * m385 + a[7] * a[0] * m396 - a[9] * a[0] * m403
        + a[11] * a[0] * m407 - a[13] * a[0] * m409;
    const double m428 = a[1] * m415 - a[3] * a[0] * m385 + a[7] * a[0] * m411 - a[9] * a[0] * m412
        + a[11] * a[0] * m413 - a[13] * a[0] * m414;
    const double m429 = a[1] * m419 - a[3] * a[0] * m396 + a[5] * a[0] * m411 - a[9] * a[0] * m416
        + a[11] * a[0] * m417 - a[13] * a[0] * m418;
    const double m430 = a[1] * m422 - a[3] * a[0] * m403 + a[5] * a[0] * m412 - a[7] * a[0] * m416
        + a[11] * a[0] * m420 - a[13] * a[0] * m421;
    const double m431 = a[1] * m424 - a[3] * a[0] * m407 + a[5] * a[0] * m413 - a[7] * a[0] * m417
        + a[9] * a[0] * m420 - a[13] * a[0] * m423;
    const double m432 = a[2] * m426 - a[4] * m427 + a[6] * m428 - a[8] * m429 + a[10] * m430
        - a[12] * m431;
    const double m433 = a[1] * m432 - a[3] * a[0] * m426 + a[5] * a[0] * m427 - a[7] * a[0] * m428
        + a[9] * a[0] * m429 - a[11] * a[0] * m430 + a[13] * a[0] * m431;
    const double determinant = a[1] * m118 - a[3] * a[0] * m112 + a[5] * a[0] * m113 - a[7] * a[0] * m114
        + a[9] * a[0] * m115 - a[11] * a[0] * m116 + a[13] * a[0] * m117;
    const double numerator = b[0] * m118 - b[1] * a[0] * m112 + b[2] * a[0] * m113 - b[3] * a[0] * m114
        + b[4] * a[0] * m115 - b[5] * a[0] * m116 + b[6] * a[0] * m117 - b[7] * a[0] * m119
        + b[8] * a[0] * m127 - b[9] * a[0] * m156 + b[10] * a[0] * m220
        - b[11] * a[0] * m319 + b[12] * a[0] * m433;
    return numerator / (2.0 * a[0] * determinant);
}

double gyrospec_i14(const double a[15], const double b[14])
{
    const double m0 = a[12] * a[13] * a[14] - a[14] * a[11] * a[14];
    const double m1 = a[10] * a[13] * a[14] - a[14] * a[9] * a[14];
    const double m2 = a[11] * m0 - a[13] * m1;
    const double m3 = a[8] * a[13] * a[14] - a[14] * a[7] * a[14];
    const double m4 = a[9] * m0 - a[13] * m3;
    const double m5 = a[9] * m1 - a[11] * m3;
    const double m6 = a[10] * m2 - a[12] * m4 + a[14] * m5;
    const double m7 = a[6] * a[13] * a[14] - a[14] * a[5] * a[14];
    const double m8 = a[7] * m0 - a[13] * m7;
    const double m9 = a[7] * m1 - a[11] * m7;
    const double m10 = a[8] * m2 - a[12] * m8 + a[14] * m9;
    const double m11 = a[7] * m3 - a[9] * m7;
    const double m12 = a[8] * m4 - a[10] * m8 + a[14] * m11;
    const double m13 = a[9] * m6 - a[11] * m10 + a[13] * m12;
    const double m14 = a[4] * a[13] * a[14] - a[14] * a[3] * a[14];
    const double m15 = a[5] * m0 - a[13] * m14;
    const double m16 = a[5] * m1 - a[11] * m14;
    const double m17 = a[6] * m2 - a[12] * m15 + a[14] * m16;
    const double m18 = a[5] * m3 - a[9] * m14;
    const double m19 = a[6] * m4 - a[10] * m15 + a[14] * m18;
    const double m20 = a[7] * m6 - a[11] * m17 + a[13] * m19;
    const double m21 = a[5] * m7 - a[7] * m14;
    const double m22 = a[6] * m8 - a[8] * m15 + a[14] * m21;
    const double m23 = a[7] * m10 - a[9] * m17 + a[13] * m22;
    const double m24 = a[7] * m12 - a[9] * m19 + a[11] * m22;
    const double m25 = a[8] * m13 - a[10] * m20 + a[12] * m23 - a[14] * m24;
    const double m26 = a[2] * a[13] * a[14] - a[14] * a[1] * a[14];
    const double m27 = a[3] * m0 - a[13] * m26;
    const double m28 = a[3] * m1 - a[11] * m26;
    const double m29 = a[4] * m2 - a[12] * m27 + a[14] * m28;
    const double m30 = a[3] * m3 - a[9] * m26;
    const double m31 = a[4] * m4 - a[10] * m27 + a[14] * m30;
    const double m32 = a[5] * m6 - a[11] * m29 + a[13] * m31;
    const double m33 = a[3] * m7 - a[7] * m26;
    const double m34 = a[4] * m8 - a[8] * m27 + a[14] * m33;
    const double m35 = a[5] * m10 - a[9] * m29 + a[13] * m34;
    const double m36 = a[5] * m12 - a[9] * m31 + a[11] * m34;
    const double m37 = a[6] * m13 - a[10] * m32 + a[12] * m35 - a[14] * m36;
    const double m38 = a[3] * m14 - a[5] * m26;
    const double m39 = a[4] * m15 - a[6] * m27 + a[14] * m38;
    const double m40 = a[5] * m17 - a[7] * m29 + a[13] * m39;
    const double m41 = a[5] * m19 - a[7] * m31 + a[11] * m39;
    const double m42 = a[6] * m20 - a[8] * m32 + a[12] * m40 - a[14] * m41;
    const double m43 = a[5] * m22 - a[7] * m34 + a[9] * m39;
    const double m44 = a[6] * m23 - a[8] * m35 + a[10] * m40 - a[14] * m43;
    const double m45 = a[7] * m25 - a[9] * m37 + a[11] * m42 - a[13] * m44;
    const double m46 = a[1] * m0 - a[13] * a[0] * a[13] * a[14];
    const double m47 = a[1] * m1 - a[11] * a[0] * a[13] * a[14];
    const double m48 = a[2] * m2 - a[12] * m46 + a[14] * m47;
    const double m49 = a[1] * m3 - a[9] * a[0] * a[13] * a[14];
    const double m50 = a[2] * m4 - a[10] * m46 + a[14] * m49;
    const double m51 = a[3] * m6 - a[11] * m48 + a[13] * m50;
    const double m52 = a[1] * m7 - a[7] * a[0] * a[13] * a[14];
    const double m53 = a[2] * m8 - a[8] * m46 + a[14] * m52;
    const double m54 = a[3] * m10 - a[9] * m48 + a[13] * m53;
    const double m55 = a[3] * m12 - a[9] * m50 + a[11] * m53;
    const double m56 = a[4] * m13 - a[10] * m51 + a[12] * m54 - a[14] * m55;
    const double m57 = a[1] * m14 - a[5] * a[0] * a[13] * a[14];
    const double m58 = a[2] * m15 - a[6] * m46 + a[14] * m57;
    const double m59 = a[3] * m17 - a[7] * m48 + a[13] * m58;
    const double m60 = a[3] * m19 - a[7] * m50 + a[11] * m58;
    const double m61 = a[4] * m20 - a[8] * m51 + a[12] * m59 - a[14] * m60;
    const double m62 = a[3] * m22 - a[7] * m53 + a[9] * m58;
    const double m63 = a[4] * m23 - a[8] * m54 + a[10] * m59 - a[14] * m62;
    const double m64 = a[5] * m25 - a[9] * m56 + a[11] * m61 - a[13] * m63;
    const double m65 = a[1] * m26 - a[3] * a[0] * a[13] * a[14];
    const double m66 = a[2] * m27 - a[4] * m46 + a[14] * m65;
    const double m67 = a[3] * m29 - a[5] * m48 + a[13] * m66;
    const double m68 = a[3] * m31 - a[5] * m50 + a[11] * m66;
    const double m69 = a[4] * m32 - a[6] * m51 + a[12] * m67 - a[14] * m68;
    const double m70 = a[3] * m34 - a[5] * m53 + a[9] * m66;
    const double m71 = a[4] * m35 - a[6] * m54 + a[10] * m67 - a[14] * m70;
    const double m72 = a[5] * m37 - a[7] * m56 + a[11] * m69 - a[13] * m71;
    const double m73 = a[3] * m39 - a[5] * m58 + a[7] * m66;
    const double m74 = a[4] * m40 - a[6] * m59 + a[8] * m67 - a[14] * m73;
    const double m75 = a[5] * m42 - a[7] * m61 + a[9] * m69 - a[13] * m74;
    const double m76 = a[5] * m44 - a[7] * m63 + a[9] * m71 - a[11] * m74;
    const double m77 = a[6] * m45 - a[8] * m64 + a[10] * m72 - a[12] * m75 + a[14] * m76;
    const double m78 = a[1] * m6 - a[11] * a[0] * m2 + a[13] * a[0] * m4;
    const double m79 = a[1] * m10 - a[9] * a[0] * m2 + a[13] * a[0] * m8;
    const double m80 = a[1] * m12 - a[9] * a[0] * m4 + a[11] * a[0] * m8;
    const double m81 = a[2] * m13 - a[10] * m78 + a[12] * m79 - a[14] * m80;
    const double m82 = a[1] * m17 - a[7] * a[0] * m2 + a[13] * a[0] * m15;
    const double m83 = a[1] * m19 - a[7] * a[0] * m4 + a[11] * a[0] * m15;
    const double m84 = a[2] * m20 - a[8] * m78 + a[12] * m82 - a[14] * m83;
    const double m85 = a[1] * m22 - a[7] * a[0] * m8 + a[9] * a[0] * m15;
    const double m86 = a[2] * m23 - a[8] * m79 + a[10] * m82 - a[14] * m85;
    const double m87 = a[3] * m25 - a[9] * m81 + a[11] * m84 - a[13] * m86;
    const double m88 = a[1] * m29 - a[5] * a[0] * m2 + a[13] * a[0] * m27;
    const double m89 = a[1] * m31 - a[5] * a[0] * m4 + a[11] * a[0] * m27;
    const double m90 = a[2] * m32 - a[6] * m78 + a[12] * m88 - a[14] * m89;
    const double m91 = a[1] * m34 - a[5] * a[0] * m8 + a[9] * a[0] * m27;
    const double m92 = a[2] * m35 - a[6] * m79 + a[10] * m88 - a[14] * m91;
    const double m93 = a[3] * m37 - a[7] * m81 + a[11] * m90 - a[13] * m92;
    const double m94 = a[1] * m39 - a[5] * a[0] * m15 + a[7] * a[0] * m27;
    const double m95 = a[2] * m40 - a[6] * m82 + a[8] * m88 - a[14] * m94;
    const double m96 = a[3] * m42 - a[7] * m84 + a[9] * m90 - a[13] * m95;
    const double m97 = a[3] * m44 - a[7] * m86 + a[9] * m92 - a[11] * m95;
    const double m98 = a[4] * m45 - a[8] * m87 + a[10] * m93 - a[12] * m96 + a[14] * m97;
    const double m99 = a[1] * m48 - a[3] * a[0] * m2 + a[13] * a[0] * m46;
    const double m100 = a[1] * m50 - a[3] * a[0] * m4 + a[11] * a[0] * m46;
    const double m101 = a[2] * m51 - a[4] * m78 + a[12] * m99 - a[14] * m100;
    const double m102 = a[1] * m53 - a[3] * a[0] * m8 + a[9] * a[0] * m46;
    const double m103 = a[2] * m54 - a[4] * m79 + a[10] * m99 - a[14] * m102;
    const double m104 = a[3] * m56 - a[5] * m81 + a[11] * m101 - a[13] * m103;
    const double m105 = a[1] * m58 - a[3] * a[0] * m15 + a[7] * a[0] * m46;
    const double m106 = a[2] * m59 - a[4] * m82 + a[8] * m99 - a[14] * m105;
    const double m107 = a[3] * m61 - a[5] * m84 + a[9] * m101 - a[13] * m106;
    const double m108 = a[3] * m63 - a[5] * m86 + a[9] * m103 - a[11] * m106;
    const double m109 = a[4] * m64 - a[6] * m87 + a[10] * m104 - a[12] * m107 + a[14] * m108;
    const double m110 = a[1] * m66 - a[3] * a[0] * m27 + a[5] * a[0] * m46;
    const double m111 = a[2] * m67 - a[4] * m88 + a[6] * m99 - a[14] * m110;
    const double m112 = a[3] * m69 - a[5] * m90 + a[7] * m101 - a[13] * m111;
    const double m113 = a[3] * m71 - a[5] * m92 + a[7] * m103 - a[11] * m111;
    const double m114 = a[4] * m72 - a[6] * m93 + a[8] * m104 - a[12] * m112 + a[14] * m113;
    const double m115 = a[3] * m74 - a[5] * m95 + a[7] * m106 - a[9] * m111;
    const double m116 = a[4] * m75 - a[6] * m96 + a[8] * m107 - a[10] * m112 + a[14] * m115;
    const double m117 = a[5] * m77 - a[7] * m98 + a[9] * m109 - a[11] * m114 + a[13] * m116;
    const double m118 = a[1] * m25 - a[9] * a[0] * m13 + a[11] * a[0] * m20 - a[13] * a[0] * m23;
    const double m119 = a[1] * m37 - a[7] * a[0] * m13 + a[11] * a[0] * m32 - a[13] * a[0] * m35;
    const double m120 = a[1] * m42 - a[7] * a[0] * m20 + a[9] * a[0] * m32 - a[13] * a[0] * m40;
    const double m121 = a[1] * m44 - a[7] * a[0] * m23 + a[9] * a[0] * m35 - a[11] * a[0] * m40;
    const double m122 = a[2] * m45 - a[8] * m118 + a[10] * m119 - a[12] * m120 + a[14] * m121;
    const double m123 = a[1] * m56 - a[5] * a[0] * m13 + a[11] * a[0] * m51 - a[13] * a[0] * m54;
    const double m124 = a[1] * m61 - a[5] * a[0] * m20 + a[9] * a[0] * m51 - a[13] * a[0] * m59;
    const double m125 = a[1] * m63 - a[5] * a[0] * m23 + a[9] * a[0] * m54 - a[11] * a[0] * m59;
    const double m126 = a[2] * m64 - a[6] * m118 + a[10] * m123 - a[12] * m124 + a[14] * m125;
    const double m127 = a[1] * m69 - a[5] * a[0] * m32 + a[7] * a[0] * m51 - a[13] * a[0] * m67;
    const double m128 = a[1] * m71 - a[5] * a[0] * m35 + a[7] * a[0] * m54 - a[11] * a[0] * m67;
    const double m129 = a[2] * m72 - a[6] * m119 + a[8] * m123 - a[12] * m127 + a[14] * m128;
    const double m130 = a[1] * m74 - a[5] * a[0] * m40 + a[7] * a[0] * m59 - a[9] * a[0] * m67;
    const double m131 = a[2] * m75 - a[6] * m120 + a[8] * m124 - a[10] * m127 + a[14] * m130;
    const double m132 = a[3] * m77 - a[7] * m122 + a[9] * m126 - a[11] * m129 + a[13] * m131;
    const double m133 = a[1] * m81 - a[3] * a[0] * m13 + a[11] * a[0] * m78 - a[13] * a[0] * m79;
    const double m134 = a[1] * m84 - a[3] * a[0] * m20 + a[9] * a[0] * m78 - a[13] * a[0] * m82;
    const double m135 = a[1] * m86 - a[3] * a[0] * m23 + a[9] * a[0] * m79 - a[11] * a[0] * m82;
    const double m136 = a[2] * m87 - a[4] * m118 + a[10] * m133 - a[12] * m134 + a[14] * m135;
    const double m137 = a[1] * m90 - a[3] * a[0] * m32 + a[7] * a[0] * m78 - a[13] * a[0] * m88;
    const double m138 = a[1] * m92 - a[3] * a[0] * m35 + a[7] * a[0] * m79 - a[11] * a[0] * m88;
    const double m139 = a[2] * m93 - a[4] * m119 + a[8] * m133 - a[12] * m137 + a[14] * m138;
    const double m140 = a[1] * m95 - a[3] * a[0] * m40 + a[7] * a[0] * m82 - a[9] * a[0] * m88;
    const double m141 = a[2] * m96 - a[4] * m120 + a[8] * m134 - a[10] * m137 + a[14] * m140;
    const double m142 = a[3] * m98 - a[5] * m122 + a[9] * m136 - a[11] * m139 + a[13] * m141;
    const double m143 = a[1] * m101 - a[3] * a[0] * m51 + a[5] * a[0] * m78 - a[13] * a[0] * m99;
    const double m144 = a[1] * m103 - a[3] * a[0] * m54 + a[5] * a[0] * m79 - a[11] * a[0] * m99;
    const double m145 = a[2] * m104 - a[4] * m123 + a[6] * m133 - a[12] * m143 + a[14] * m144;
    const double m146 = a[1] * m106 - a[3] * a[0] * m59 + a[5] * a[0] * m82 - a[9] * a[0] * m99;
    const double m147 = a[2] * m107 - a[4] * m124 + a[6] * m134 - a[10] * m143 + a[14] * m146;
    const double m148 = a[3] * m109 - a[5] * m126 + a[7] * m136 - a[11] * m145 + a[13] * m147;
    const double m149 = a[1] * m111 - a[3] * a[0] * m67 + a[5] * a[0] * m88 - a[7] * a[0] * m99;
    const double m150 = a[2] * m112 - a[4] * m127 + a[6] * m137 - a[8] * m143 + a[14] * m149;
    const double m151 = a[3] * m114 - a[5] * m129 + a[7] * m139 - a[9] * m145 + a[13] * m150;
    const double m152 = a[3] * m116 - a[5] * m131 + a[7] * m141 - a[9] * m147 + a[11] * m150;
    const double m153 = a[4] * m117 - a[6] * m132 + a[8] * m142 - a[10] * m148 + a[12] * m151
        - a[14] * m152;
    const double m154 = a[1] * m77 - a[7] * a[0] * m45 + a[9] * a[0] * m64 - a[11] * a[0] * m72
        + a[13] * a[0] * m75;
    const double m155 = a[1] * m98 - a[5] * a[0] * m45 + a[9] * a[0] * m87 - a[11] * a[0] * m93
        + a[13] * a[0] * m96;
    const double m156 = a[1] * m109 - a[5] * a[0] * m64 + a[7] * a[0] * m87 - a[11] * a[0] * m104
        + a[13] * a[0] * m107;
    const double m157 = a[1] * m114 - a[5] * a[0] * m72 + a[7] * a[0] * m93 - a[9] * a[0] * m104
        + a[13] * a[0] * m112;
    const double m158 = a[1] * m116 - a[5] * a[0] * m75 + a[7] * a[0] * m96 - a[9] * a[0] * m107
        + a[11] * a[0] * m112;
    const double m159 = a[2] * m117 - a[6] * m154 + a[8] * m155 - a[10] * m156 + a[12] * m157
        - a[14] * m158;
    const double m160 = a[1] * m122 - a[3] * a[0] * m45 + a[9] * a[0] * m118 - a[11] * a[0] * m119
        + a[13] * a[0] * m120;
    const double m161 = a[1] * m126 - a[3] * a[0] * m64 + a[7] * a[0] * m118 - a[11] * a[0] * m123
        + a[13] * a[0] * m124;
    const double m162 = a[1] * m129 - a[3] * a[0] * m72 + a[7] * a[0] * m119 - a[9] * a[0] * m123
        + a[13] * a[0] * m127;
    const double m163 = a[1] * m131 - a[3] * a[0] * m75 + a[7] * a[0] * m120 - a[9] * a[0] * m124
        + a[11] * a[0] * m127;
    const double m164 = a[2] * m132 - a[4] * m154 + a[8] * m160 - a[10] * m161 + a[12] * m162
        - a[14] * m163;
    const double m165 = a[1] * m136 - a[3] * a[0] * m87 + a[5] * a[0] * m118 - a[11] * a[0] * m133
        + a[13] * a[0] * m134;
    const double m166 = a[1] * m139 - a[3] * a[0] * m93 + a[5] * a[0] * m119 - a[9] * a[0] * m133
        + a[13] * a[0] * m137;
    const double m167 = a[1] * m141 - a[3] * a[0] * m96 + a[5] * a[0] * m120 - a[9] * a[0] * m134
        + a[11] * a[0] * m137;
    const double m168 = a[2] * m142 - a[4] * m155 + a[6] * m160 - a[10] * m165 + a[12] * m166
        - a[14] * m167;
    const double m169 = a[1] * m145 - a[3] * a[0] * m104 + a[5] * a[0] * m123 - a[7] * a[0] * m133
        + a[13] * a[0] * m143;
    const double m170 = a[1] * m147 - a[3] * a[0] * m107 + a[5] * a[0] * m124 - a[7] * a[0] * m134
        + a[11] * a[0] * m143;
    const double m171 = a[2] * m148 - a[4] * m156 + a[6] * m161 - a[8] * m165 + a[12] * m169
        - a[14] * m170;
    const double m172 = a[1] * m150 - a[3] * a[0] * m112 + a[5] * a[0] * m127 - a[7] * a[0] * m137
        + a[9] * a[0] * m143;
    const double m173 = a[2] * m151 - a[4] * m157 + a[6] * m162 - a[8] * m166 + a[10] * m169
        - a[14] * m172;
    const double m174 = a[3] * m153 - a[5] * m159 + a[7] * m164 - a[9] * m168 + a[11] * m171
        - a[13] * m173;
    const double m175 = a[1] * m153 - a[5] * a[0] * m117 + a[7] * a[0] * m132 - a[9] * a[0] * m142
        + a[11] * a[0] * m148 - a[13] * a[0] * m151;
    const double m176 = a[1] * m159 - a[3] * a[0] * m117 + a[7] * a[0] * m154 - a[9] * a[0] * m155
        + a[11] * a[0] * m156 - a[13] * a[0] * m157;
    const double m177 = a[1] * m164 - a[3] * a[0] * m132 + a[5] * a[0] * m154 - a[9] * a[0] * m160
        + a[11] * a[0] * m161 - a[13] * a[0] * m162;
    const double m178 = a[1] * m168 - a[3] * a[0] * m142 + a[5] * a[0] * m155 - a[7] * a[0] * m160
        + a[11] * a[0] * m165 - a[13] * a[0] * m166;
    const double m179 = a[1] * m171 - a[3] * a[0] * m148 + a[5] * a[0] * m156 - a[7] * a[0] * m161
        + a[9] * a[0] * m165 - a[13] * a[0] * m169;
    const double m180 = a[1] * m173 - a[3] * a[0] * m151 + a[5] * a[0] * m157 - a[7] * a[0] * m162
        + a[9] * a[0] * m166 - a[11] * a[0] * m169;
    const double m181 = a[2] * m174 - a[4] * m175 + a[6] * m176 - a[8] * m177 + a[10] * m178
        - a[12] * m179 + a[14] * m180;
    const double m182 = a[2] * m152 - a[4] * m158 + a[6] * m163 - a[8] * m167 + a[10] * m170
        - a[12] * m172;
    const double m183 = a[1] * m182 - a[3] * a[0] * m152 + a[5] * a[0] * m158 - a[7] * a[0] * m163
        + a[9] * a[0] * m167 - a[11] * a[0] * m170 + a[13] * a[0] * m172;
    const double m184 = a[4] * m76 - a[6] * m97 + a[8] * m108 - a[10] * m113 + a[12] * m115;
    const double m185 = a[2] * m76 - a[6] * m121 + a[8] * m125 - a[10] * m128 + a[12] * m130;
    const double m186 = a[2] * m97 - a[4] * m121 + a[8] * m135 - a[10] * m138 + a[12] * m140;
    const double m187 = a[2] * m108 - a[4] * m125 + a[6] * m135 - a[10] * m144 + a[12] * m146;
    const double m188 = a[2] * m113 - a[4] * m128 + a[6] * m138 - a[8] * m144 + a[12] * m149;
    const double m189 = a[2] * m115 - a[4] * m130 + a[6] * m140 - a[8] * m146 + a[10] * m149;
    const double m190 = a[3] * m184 - a[5] * m185 + a[7] * m186 - a[9] * m187 + a[11] * m188
        - a[13] * m189;
    const double m191 = a[1] * m184 - a[5] * a[0] * m76 + a[7] * a[0] * m97 - a[9] * a[0] * m108
        + a[11] * a[0] * m113 - a[13] * a[0] * m115;
    const double m192 = a[1] * m185 - a[3] * a[0] * m76 + a[7] * a[0] * m121 - a[9] * a[0] * m125
        + a[11] * a[0] * m128 - a[13] * a[0] * m130;
    const double m193 = a[1] * m186 - a[3] * a[0] * m97 + a[5] * a[0] * m121 - a[9] * a[0] * m135
        + a[11] * a[0] * m138 - a[13] * a[0] * m140;
    const double m194 = a[1] * m187 - a[3] * a[0] * m108 + a[5] * a[0] * m125 - a[7] * a[0] * m135
        + a[11] * a[0] * m144 - a[13] * a[0] * m146;
    const double m195 = a[1] * m188 - a[3] * a[0] * m113 + a[5] * a[0] * m128 - a[7] * a[0] * m138
        + a[9] * a[0] * m144 - a[13] * a[0] * m149;
    const double m196 = a[1] * m189 - a[3] * a[0] * m115 + a[5] * a[0] * m130 - a[7] * a[0] * m140
        + a[9] * a[0] * m146 - a[11] * a[0] * m149;
    const double m197 = a[2] * m190 - a[4] * m191 + a[6] * m192 - a[8] * m193 + a[10] * m194
        - a[12] * m195 + a[14] * m196;
    const double m198 = a[1] * m197 - a[3] * a[0] * m190 + a[5] * a[0] * m191 - a[7] * a[0] * m192
        + a[9] * a[0] * m193 - a[11] * a[0] * m194 + a[13] * a[0] * m195;
    const double m199 = a[6] * m24 - a[8] * m36 + a[10] * m41 - a[12] * m43;
    const double m200 = a[4] * m24 - a[8] * m55 + a[10] * m60 - a[12] * m62;
    const double m201 = a[4] * m36 - a[6] * m55 + a[10] * m68 - a[12] * m70;
    const double m202 = a[4] * m41 - a[6] * m60 + a[8] * m68 - a[12] * m73;
    const double m203 = a[4] * m43 - a[6] * m62 + a[8] * m70 - a[10] * m73;
    const double m204 = a[5] * m199 - a[7] * m200 + a[9] * m201 - a[11] * m202 + a[13] * m203;
    const double m205 = a[2] * m24 - a[8] * m80 + a[10] * m83 - a[12] * m85;
    const double m206 = a[2] * m36 - a[6] * m80 + a[10] * m89 - a[12] * m91;
    const double m207 = a[2] * m41 - a[6] * m83 + a[8] * m89 - a[12] * m94;
    const double m208 = a[2] * m43 - a[6] * m85 + a[8] * m91 - a[10] * m94;
    const double m209 = a[3] * m199 - a[7] * m205 + a[9] * m206 - a[11] * m207 + a[13] * m208;
    const double m210 = a[2] * m55 - a[4] * m80 + a[10] * m100 - a[12] * m102;
    const double m211 = a[2] * m60 - a[4] * m83 + a[8] * m100 - a[12] * m105;
    const double m212 = a[2] * m62 - a[4] * m85 + a[8] * m102 - a[10] * m105;
    const double m213 = a[3] * m200 - a[5] * m205 + a[9] * m210 - a[11] * m211 + a[13] * m212;
    const double m214 = a[2] * m68 - a[4] * m89 + a[6] * m100 - a[12] * m110;
    const double m215 = a[2] * m70 - a[4] * m91 + a[6] * m102 - a[10] * m110;
    const double m216 = a[3] * m201 - a[5] * m206 + a[7] * m210 - a[11] * m214 + a[13] * m215;
    const double m217 = a[2] * m73 - a[4] * m94 + a[6] * m105 - a[8] * m110;
    const double m218 = a[3] * m202 - a[5] * m207 + a[7] * m211 - a[9] * m214 + a[13] * m217;
    const double m219 = a[3] * m203 - a[5] * m208 + a[7] * m212 - a[9] * m215 + a[11] * m217;
    const double m220 = a[4] * m204 - a[6] * m209 + a[8] * m213 - a[10] * m216 + a[12] * m218
        - a[14] * m219;
    const double m221 = a[1] * m199 - a[7] * a[0] * m24 + a[9] * a[0] * m36 - a[11] * a[0] * m41
        + a[13] * a[0] * m43;
    const double m222 = a[1] * m200 - a[5] * a[0] * m24 + a[9] * a[0] * m55 - a[11] * a[0] * m60
        + a[13] * a[0] * m62;
    const double m223 = a[1] * m201 - a[5] * a[0] * m36 + a[7] * a[0] * m55 - a[11] * a[0] * m68
        + a[13] * a[0] * m70;
    const double m224 = a[1] * m202 - a[5] * a[0] * m41 + a[7] * a[0] * m60 - a[9] * a[0] * m68
        + a[13] * a[0] * m73;
    const double m225 = a[1] * m203 - a[5] * a[0] * m43 + a[7] * a[0] * m62 - a[9] * a[0] * m70
        + a[11] * a[0] * m73;
    const double m226 = a[2] * m204 - a[6] * m221 + a[8] * m222 - a[10] * m223 + a[12] * m224
        - a[14] * m225;
    const double m227 = a[1] * m205 - a[3] * a[0] * m24 + a[9] * a[0] * m80 - a[11] * a[0] * m83
        + a[13] * a[0] * m85;
    const double m228 = a[1] * m206 - a[3] * a[0] * m36 + a[7] * a[0] * m80 - a[11] * a[0] * m89
        + a[13] * a[0] * m91;
    const double m229 = a[1] * m207 - a[3] * a[0] * m41 + a[7] * a[0] * m83 - a[9] * a[0] * m89
        + a[13] * a[0] * m94;
    const double m230 = a[1] * m208 - a[3] * a[0] * m43 + a[7] * a[0] * m85 - a[9] * a[0] * m91
        + a[11] * a[0] * m94;
    const double m231 = a[2] * m209 - a[4] * m221 + a[8] * m227 - a[10] * m228 + a[12] * m229
        - a[14] * m230;
    const double m232 = a[1] * m210 - a[3] * a[0] * m55 + a[5] * a[0] * m80 - a[11] * a[0] * m100
        + a[13] * a[0] * m102;
    const double m233 = a[1] * m211 - a[3] * a[0] * m60 + a[5] * a[0] * m83 - a[9] * a[0] * m100
        + a[13] * a[0] * m105;
    const double m234 = a[1] * m212 - a[3] * a[0] * m62 + a[5] * a[0] * m85 - a[9] * a[0] * m102
        + a[11] * a[0] * m105;
    const double m235 = a[2] * m213 - a[4] * m222 + a[6] * m227 - a[10] * m232 + a[12] * m233
        - a[14] * m234;
    const double m236 = a[1] * m214 - a[3] * a[0] * m68 + a[5] * a[0] * m89 - a[7] * a[0] * m100
        + a[13] * a[0] * m110;
    const double m237 = a[1] * m215 - a[3] * a[0] * m70 + a[5] * a[0] * m91 - a[7] * a[0] * m102
        + a[11] * a[0] * m110;
    const double m238 = a[2] * m216 - a[4] * m223 + a[6] * m228 - a[8] * m232 + a[12] * m236
        - a[14] * m237;
    const double m239 = a[1] * m217 - a[3] * a[0] * m73 + a[5] * a[0] * m94 - a[7] * a[0] * m105
        + a[9] * a[0] * m110;
    const double m240 = a[2] * m218 - a[4] * m224 + a[6] * m229 - a[8] * m233 + a[10] * m236
        - a[14] * m239;
    const double m241 = a[3] * m220 - a[5] * m226 + a[7] * m231 - a[9] * m235 + a[11] * m238
        - a[13] * m240;
    const double m242 = a[1] * m220 - a[5] * a[0] * m204 + a[7] * a[0] * m209 - a[9] * a[0] * m213
        + a[11] * a[0] * m216 - a[13] * a[0] * m218;
    const double m243 = a[1] * m226 - a[3] * a[0] * m204 + a[7] * a[0] * m221 - a[9] * a[0] * m222
        + a[11] * a[0] * m223 - a[13] * a[0] * m224;
    const double m244 = a[1] * m231 - a[3] * a[0] * m209 + a[5] * a[0] * m221 - a[9] * a[0] * m227
        + a[11] * a[0] * m228 - a[13] * a[0] * m229;
    const double m245 = a[1] * m235 - a[3] * a[0] * m213 + a[5] * a[0] * m222 - a[7] * a[0] * m227
        + a[11] * a[0] * m232 - a[13] * a[0] * m233;
    const double m246 = a[1] * m238 - a[3] * a[0] * m216 + a[5] * a[0] * m223 - a[7] * a[0] * m228
        + a[9] * a[0] * m232 - a[13] * a[0] * m236;
    const double m247 = a[1] * m240 - a[3] * a[0] * m218 + a[5] * a[0] * m224 - a[7] * a[0] * m229
        + a[9] * a[0] * m233 - a[11] * a[0] * m236;
    const double m248 = a[2] * m241 - a[4] * m242 + a[6] * m243 - a[8] * m244 + a[10] * m245
        - a[12] * m246 + a[14] * m247;
    const double m249 = a[1] * m248 - a[3] * a[0] * m241 + a[5] * a[0] * m242 - a[7] * a[0] * m243
        + a[9] * a[0] * m244 - a[11] * a[0] * m245 + a[13] * a[0] * m246;
    const double m250 = a[8] * m5 - a[10] * m9 + a[12] * m11;
    const double m251 = a[6] * m5 - a[10] * m16 + a[12] * m18;
    const double m252 = a[6] * m9 - a[8] * m16 + a[12] * m21;
    const double m253 = a[6] * m11 - a[8] * m18 + a[10] * m21;
    const double m254 = a[7] * m250 - a[9] * m251 + a[11] * m252 - a[13] * m253;
    const double m255 = a[4] * m5 - a[10] * m28 + a[12] * m30;
    const double m256 = a[4] * m9 - a[8] * m28 + a[12] * m33;
    const double m257 = a[4] * m11 - a[8] * m30 + a[10] * m33;
    const double m258 = a[5] * m250 - a[9] * m255 + a[11] * m256 - a[13] * m257;
    const double m259 = a[4] * m16 - a[6] * m28 + a[12] * m38;
    const double m260 = a[4] * m18 - a[6] * m30 + a[10] * m38;
    const double m261 = a[5] * m251 - a[7] * m255 + a[11] * m259 - a[13] * m260;
    const double m262 = a[4] * m21 - a[6] * m33 + a[8] * m38;
    const double m263 = a[5] * m252 - a[7] * m256 + a[9] * m259 - a[13] * m262;
    const double m264 = a[5] * m253 - a[7] * m257 + a[9] * m260 - a[11] * m262;
    const double m265 = a[6] * m254 - a[8] * m258 + a[10] * m261 - a[12] * m263 + a[14] * m264;
    const double m266 = a[2] * m5 - a[10] * m47 + a[12] * m49;
    const double m267 = a[2] * m9 - a[8] * m47 + a[12] * m52;
    const double m268 = a[2] * m11 - a[8] * m49 + a[10] * m52;
    const double m269 = a[3] * m250 - a[9] * m266 + a[11] * m267 - a[13] * m268;
    const double m270 = a[2] * m16 - a[6] * m47 + a[12] * m57;
    const double m271 = a[2] * m18 - a[6] * m49 + a[10] * m57;
    const double m272 = a[3] * m251 - a[7] * m266 + a[11] * m270 - a[13] * m271;
    const double m273 = a[2] * m21 - a[6] * m52 + a[8] * m57;
    const double m274 = a[3] * m252 - a[7] * m267 + a[9] * m270 - a[13] * m273;
    const double m275 = a[3] * m253 - a[7] * m268 + a[9] * m271 - a[11] * m273;
    const double m276 = a[4] * m254 - a[8] * m269 + a[10] * m272 - a[12] * m274 + a[14] * m275;
    const double m277 = a[2] * m28 - a[4] * m47 + a[12] * m65;
    const double m278 = a[2] * m30 - a[4] * m49 + a[10] * m65;
    const double m279 = a[3] * m255 - a[5] * m266 + a[11] * m277 - a[13] * m278;
    const double m280 = a[2] * m33 - a[4] * m52 + a[8] * m65;
    const double m281 = a[3] * m256 - a[5] * m267 + a[9] * m277 - a[13] * m280;
    const double m282 = a[3] * m257 - a[5] * m268 + a[9] * m278 - a[11] * m280;
    const double m283 = a[4] * m258 - a[6] * m269 + a[10] * m279 - a[12] * m281 + a[14] * m282;
    const double m284 = a[2] * m38 - a[4] * m57 + a[6] * m65;
    const double m285 = a[3] * m259 - a[5] * m270 + a[7] * m277 - a[13] * m284;
    const double m286 = a[3] * m260 - a[5] * m271 + a[7] * m278 - a[11] * m284;
    const double m287 = a[4] * m261 - a[6] * m272 + a[8] * m279 - a[12] * m285 + a[14] * m286;
    const double m288 = a[3] * m262 - a[5] * m273 + a[7] * m280 - a[9] * m284;
    const double m289 = a[4] * m263 - a[6] * m274 + a[8] * m281 - a[10] * m285 + a[14] * m288;
    const double m290 = a[5] * m265 - a[7] * m276 + a[9] * m283 - a[11] * m287 + a[13] * m289;
    const double m291 = a[1] * m250 - a[9] * a[0] * m5 + a[11] * a[0] * m9 - a[13] * a[0] * m11;
    const double m292 = a[1] * m251 - a[7] * a[0] * m5 + a[11] * a[0] * m16 - a[13] * a[0] * m18;
    const double m293 = a[1] * m252 - a[7] * a[0] * m9 + a[9] * a[0] * m16 - a[13] * a[0] * m21;
    const double m294 = a[1] * m253 - a[7] * a[0] * m11 + a[9] * a[0] * m18 - a[11] * a[0] * m21;
    const double m295 = a[2] * m254 - a[8] * m291 + a[10] * m292 - a[12] * m293 + a[14] * m294;
    const double m296 = a[1] * m255 - a[5] * a[0] * m5 + a[11] * a[0] * m28 - a[13] * a[0] * m30;
    const double m297 = a[1] * m256 - a[5] * a[0] * m9 + a[9] * a[0] * m28 - a[13] * a[0] * m33;
    const double m298 = a[1] * m257 - a[5] * a[0] * m11 + a[9] * a[0] * m30 - a[11] * a[0] * m33;
    const double m299 = a[2] * m258 - a[6] * m291 + a[10] * m296 - a[12] * m297 + a[14] * m298;
    const double m300 = a[1] * m259 - a[5] * a[0] * m16 + a[7] * a[0] * m28 - a[13] * a[0] * m38;
    const double m301 = a[1] * m260 - a[5] * a[0] * m18 + a[7] * a[0] * m30 - a[11] * a[0] * m38;
    const double m302 = a[2] * m261 - a[6] * m292 + a[8] * m296 - a[12] * m300 + a[14] * m301;
    const double m303 = a[1] * m262 - a[5] * a[0] * m21 + a[7] * a[0] * m33 - a[9] * a[0] * m38;
    const double m304 = a[2] * m263 - a[6] * m293 + a[8] * m297 - a[10] * m300 + a[14] * m303;
    const double m305 = a[3] * m265 - a[7] * m295 + a[9] * m299 - a[11] * m302 + a[13] * m304;
    const double m306 = a[1] * m266 - a[3] * a[0] * m5 + a[11] * a[0] * m47 - a[13] * a[0] * m49;
    const double m307 = a[1] * m267 - a[3] * a[0] * m9 + a[9] * a[0] * m47 - a[13] * a[0] * m52;
    const double m308 = a[1] * m268 - a[3] * a[0] * m11 + a[9] * a[0] * m49 - a[11] * a[0] * m52;
    const double m309 = a[2] * m269 - a[4] * m291 + a[10] * m306 - a[12] * m307 + a[14] * m308;
    const double m310 = a[1] * m270 - a[3] * a[0] * m16 + a[7] * a[0] * m47 - a[13] * a[0] * m57;
    const double m311 = a[1] * m271 - a[3] * a[0] * m18 + a[7] * a[0] * m49 - a[11] * a[0] * m57;
    const double m312 = a[2] * m272 - a[4] * m292 + a[8] * m306 - a[12] * m310 + a[14] * m311;
    const double m313 = a[1] * m273 - a[3] * a[0] * m21 + a[7] * a[0] * m52 - a[9] * a[0] * m57;
    const double m314 = a[2] * m274 - a[4] * m293 + a[8] * m307 - a[10] * m310 + a[14] * m313;
    const double m315 = a[3] * m276 - a[5] * m295 + a[9] * m309 - a[11] * m312 + a[13] * m314;
    const double m316 = a[1] * m277 - a[3] * a[0] * m28 + a[5] * a[0] * m47 - a[13] * a[0] * m65;
    const double m317 = a[1] * m278 - a[3] * a[0] * m30 + a[5] * a[0] * m49 - a[11] * a[0] * m65;
    const double m318 = a[2] * m279 - a[4] * m296 + a[6] * m306 - a[12] * m316 + a[14] * m317;
    const double m319 = a[1] * m280 - a[3] * a[0] * m33 + a[5] * a[0] * m52 - a[9] * a[0] * m65;
    const double m320 = a[2] * m281 - a[4] * m297 + a[6] * m307 - a[10] * m316 + a[14] * m319;
    const double m321 = a[3] * m283 - a[5] * m299 + a[7] * m309 - a[11] * m318 + a[13] * m320;
    const double m322 = a[1] * m284 - a[3] * a[0] * m38 + a[5] * a[0] * m57 - a[7] * a[0] * m65;
    const double m323 = a[2] * m285 - a[4] * m300 + a[6] * m310 - a[8] * m316 + a[14] * m322;
    const double m324 = a[3] * m287 - a[5] * m302 + a[7] * m312 - a[9] * m318 + a[13] * m323;
    const double m325 = a[3] * m289 - a[5] * m304 + a[7] * m314 - a[9] * m320 + a[11] * m323;
    const double m326 = a[4] * m290 - a[6] * m305 + a[8] * m315 - a[10] * m321 + a[12] * m324
        - a[14] * m325;
    const double m327 = a[1] * m265 - a[7] * a[0] * m254 + a[9] * a[0] * m258 - a[11] * a[0] * m261
        + a[13] * a[0] * m263;
    const double m328 = a[1] * m276 - a[5] * a[0] * m254 + a[9] * a[0] * m269 - a[11] * a[0] * m272
        + a[13] * a[0] * m274;
    const double m329 = a[1] * m283 - a[5] * a[0] * m258 + a[7] * a[0] * m269 - a[11] * a[0] * m279
        + a[13] * a[0] * m281;
    const double m330 = a[1] * m287 - a[5] * a[0] * m261 + a[7] * a[0] * m272 - a[9] * a[0] * m279
        + a[13] * a[0] * m285;
    const double m331 = a[1] * m289 - a[5] * a[0] * m263 + a[7] * a[0] * m274 - a[9] * a[0] * m281
        + a[11] * a[0] * m285;
    const double m332 = a[2] * m290 - a[6] * m327 + a[8] * m328 - a[10] * m329 + a[12] * m330
        - a[14] * m331;
    const double m333 = a[1] * m295 - a[3] * a[0] * m254 + a[9] * a[0] * m291 - a[11] * a[0] * m292
        + a[13] * a[0] * m293;
    const double m334 = a[1] * m299 - a[3] * a[0] * m258 + a[7] * a[0] * m291 - a[11] * a[0] * m296
        + a[13] * a[0] * m297;
    const double m335 = a[1] * m302 - a[3] * a[0] * m261 + a[7] * a[0] * m292 - a[9] * a[0] * m296
        + a[13] * a[0] * m300;
    const double m336 = a[1] * m304 - a[3] * a[0] * m263 + a[7] * a[0] * m293 - a[9] * a[0] * m297
        + a[11] * a[0] * m300;
    const double m337 = a[2] * m305 - a[4] * m327 + a[8] * m333 - a[10] * m334 + a[12] * m335
        - a[14] * m336;
    const double m338 = a[1] * m309 - a[3] * a[0] * m269 + a[5] * a[0] * m291 - a[11] * a[0] * m306
        + a[13] * a[0] * m307;
    const double m339 = a[1] * m312 - a[3] * a[0] * m272 + a[5] * a[0] * m292 - a[9] * a[0] * m306
        + a[13] * a[0] * m310;
    const double m340 = a[1] * m314 - a[3] * a[0] * m274 + a[5] * a[0] * m293 - a[9] * a[0] * m307
        + a[11] * a[0] * m310;
    const double m341 = a[2] * m315 - a[4] * m328 + a[6] * m333 - a[10] * m338 + a[12] * m339
        - a[14] * m340;
    const double m342 = a[1] * m318 - a[3] * a[0] * m279 + a[5] * a[0] * m296 - a[7] * a[0] * m306
        + a[13] * a[0] * m316;
    const double m343 = a[1] * m320 - a[3] * a[0] * m281 + a[5] * a[0] * m297 - a[7] * a[0] * m307
        + a[11] * a[0] * m316;
    const double m344 = a[2] * m321 - a[4] * m329 + a[6] * m334 - a[8] * m338 + a[12] * m342
        - a[14] * m343;
    const double m345 = a[1] * m323 - a[3] * a[0] * m285 + a[5] * a[0] * m300 - a[7] * a[0] * m310
        + a[9] * a[0] * m316;
    const double m346 = a[2] * m324 - a[4] * m330 + a[6] * m335 - a[8] * m339 + a[10] * m342
        - a[14] * m345;
    const double m347 = a[3] * m326 - a[5] * m332 + a[7] * m337 - a[9] * m341 + a[11] * m344
        - a[13] * m346;
    const double m348 = a[1] * m326 - a[5] * a[0] * m290 + a[7] * a[0] * m305 - a[9] * a[0] * m315
        + a[11] * a[0] * m321 - a[13] * a[0] * m324;
    const double m349 = a[1] * m332 - a[3] * a[0] * m290 + a[7] * a[0] * m327 - a[9] * a[0] * m328
        + a[11] * a[0] * m329 - a[13] * a[0] * m330;
    const double m350 = a[1] * m337 - a[3] * a[0] * m305 + a[5] * a[0] * m327 - a[9] * a[0] * m333
        + a[11] * a[0] * m334 - a[13] * a[0] * m335;
    const double m351 = a[1] * m341 - a[3] * a[0] * m315 + a[5] * a[0] * m328 - a[7] * a[0] * m333
        + a[11] * a[0] * m338 - a[13] * a[0] * m339;
    const double m352 = a[1] * m344 - a[3] * a[0] * m321 + a[5] * a[0] * m329 - a[7] * a[0] * m334
        + a[9] * a[0] * m338 - a[13] * a[0] * m342;
    const double m353 = a[1] * m346 - a[3] * a[0] * m324 + a[5] * a[0] * m330 - a[7] * a[0] * m335
        + a[9] * a[0] * m339 - a[11] * a[0] * m342;
    const double m354 = a[2] * m347 - a[4] * m348 + a[6] * m349 - a[8] * m350 + a[10] * m351
        - a[12] * m352 + a[14] * m353;
    const double m355 = a[1] * m354 - a[3] * a[0] * m347 + a[5] * a[0] * m348 - a[7] * a[0] * m349
        + a[9] * a[0] * m350 - a[11] * a[0] * m351 + a[13] * a[0] * m352;
    const double m356 = a[10] * a[11] * a[14] - a[12] * a[9] * a[14];
    const double m357 = a[8] * a[11] * a[14] - a[12] * a[7] * a[14];
    const double m358 = a[8] * a[9] * a[14] - a[10] * a[7] * a[14];
    const double m359 = a[9] * m356 - a[11] * m357 + a[13] * m358;
    const double m360 = a[6] * a[11] * a[14] - a[12] * a[5] * a[14];
    const double m361 = a[6] * a[9] * a[14] - a[10] * a[5] * a[14];
    const double m362 = a[7] * m356 - a[11] * m360 + a[13] * m361;
    const double m363 = a[6] * a[7] * a[14] - a[8] * a[5] * a[14];
    const double m364 = a[7] * m357 - a[9] * m360 + a[13] * m363;
    const double m365 = a[7] * m358 - a[9] * m361 + a[11] * m363;
    const double m366 = a[8] * m359 - a[10] * m362 + a[12] * m364 - a[14] * m365;
    const double m367 = a[4] * a[11] * a[14] - a[12] * a[3] * a[14];
    const double m368 = a[4] * a[9] * a[14] - a[10] * a[3] * a[14];
    const double m369 = a[5] * m356 - a[11] * m367 + a[13] * m368;
    const double m370 = a[4] * a[7] * a[14] - a[8] * a[3] * a[14];
    const double m371 = a[5] * m357 - a[9] * m367 + a[13] * m370;
    const double m372 = a[5] * m358 - a[9] * m368 + a[11] * m370;
    const double m373 = a[6] * m359 - a[10] * m369 + a[12] * m371 - a[14] * m372;
    const double m374 = a[4] * a[5] * a[14] - a[6] * a[3] * a[14];
    const double m375 = a[5] * m360 - a[7] * m367 + a[13] * m374;
    const double m376 = a[5] * m361 - a[7] * m368 + a[11] * m374;
    const double m377 = a[6] * m362 - a[8] * m369 + a[12] * m375 - a[14] * m376;
    const double m378 = a[5] * m363 - a[7] * m370 + a[9] * m374;
    const double m379 = a[6] * m364 - a[8] * m371 + a[10] * m375 - a[14] * m378;
    const double m380 = a[7] * m366 - a[9] * m373 + a[11] * m377 - a[13] * m379;
    const double m381 = a[2] * a[11] * a[14] - a[12] * a[1] * a[14];
    const double m382 = a[2] * a[9] * a[14] - a[10] * a[1] * a[14];
    const double m383 = a[3] * m356 - a[11] * m381 + a[13] * m382;
    const double m384 = a[2] * a[7] * a[14] - a[8] * a[1] * a[14];
    const double m385 = a[3] * m357 - a[9] * m381 + a[13] * m384;
    const double m386 = a[3] * m358 - a[9] * m382 + a[11] * m384;
    const double m387 = a[4] * m359 - a[10] * m383 + a[12] * m385 - a[14] * m386;
    const double m388 = a[2] * a[5] * a[14] - a[6] * a[1] * a[14];
    const double m389 = a[3] * m360 - a[7] * m381 + a[13] * m388;
    const double m390 = a[3] * m361 - a[7] * m382 + a[11] * m388;
    const double m391 = a[4] * m362 - a[8] * m383 + a[12] * m389 - a[14] * m390;
    const double m392 = a[3] * m363 - a[7] * m384 + a[9] * m388;
    const double m393 = a[4] * m364 - a[8] * m385 + a[10] * m389 - a[14] * m392;
    const double m394 = a[5] * m366 - a[9] * m387 + a[11] * m391 - a[13] * m393;
    const double m395 = a[2] * a[3] * a[14] - a[4] * a[1] * a[14];
    const double m396 = a[3] * m367 - a[5] * m381 + a[13] * m395;
    const double m397 = a[3] * m368 - a[5] * m382 + a[11] * m395;
    const double m398 = a[4] * m369 - a[6] * m383 + a[12] * m396 - a[14] * m397;
    const double m399 = a[3] * m370 - a[5] * m384 + a[9] * m395;
    const double m400 = a[4] * m371 - a[6] * m385 + a[10] * m396 - a[14] * m399;
    const double m401 = a[5] * m373 - a[7] * m387 + a[11] * m398 - a[13] * m400;
    const double m402 = a[3] * m374 - a[5] * m388 + a[7] * m395;
    const double m403 = a[4] * m375 - a[6] * m389 + a[8] * m396 - a[14] * m402;
    const double m404 = a[5] * m377 - a[7] * m391 + a[9] * m398 - a[13] * m403;
    const double m405 = a[5] * m379 - a[7] * m393 + a[9] * m400 - a[11] * m403;
    const double m406 = a[6] * m380 - a[8] * m394 + a[10] * m401 - a[12] * m404 + a[14] * m405;
    const double m407 = a[1] * m356 - a[11] * a[0] * a[11] * a[14] + a[13] * a[0] * a[9] * a[14];
    const double m408 = a[1] * m357 - a[9] * a[0] * a[11] * a[14] + a[13] * a[0] * a[7] * a[14];
    const double m409 = a[1] * m358 - a[9] * a[0] * a[9] * a[14] + a[11] * a[0] * a[7] * a[14];
    const double m410 = a[2] * m359 - a[10] * m407 + a[12] * m408 - a[14] * m409;
    const double m411 = a[1] * m360 - a[7] * a[0] * a[11] * a[14] + a[13] * a[0] * a[5] * a[14];
    const double m412 = a[1] * m361 - a[7] * a[0] * a[9] * a[14] + a[11] * a[0] * a[5] * a[14];
    const double m413 = a[2] * m362 - a[8] * m407 + a[12] * m411 - a[14] * m412;
    const double m414 = a[1] * m363 - a[7] * a[0] * a[7] * a[14] + a[9] * a[0] * a[5] * a[14];
    const double m415 = a[2] * m364 - a[8] * m408 + a[10] * m411 - a[14] * m414;
    const double m416 = a[3] * m366 - a[9] * m410 + a[11] * m413 - a[13] * m415;
    const double m417 = a[1] * m367 - a[5] * a[0] * a[11] * a[14] + a[13] * a[0] * a[3] * a[14];
    const double m418 = a[1] * m368 - a[5] * a[0] * a[9] * a[14] + a[11] * a[0] * a[3] * a[14];
    const double m419 = a[2] * m369 - a[6] * m407 + a[12] * m417 - a[14] * m418;
    const double m420 = a[1] * m370 - a[5] * a[0] * a[7] * a[14] + a[9] * a[0] * a[3] * a[14];
    const double m421 = a[2] * m371 - a[6] * m408 + a[10] * m417 - a[14] * m420;
    const double m422 = a[3] * m373 - a[7] * m410 + a[11] * m419 - a[13] * m421;
    const double m423 = a[1] * m374 - a[5] * a[0] * a[5] * a[14] + a[7] * a[0] * a[3] * a[14];
    const double m424 = a[2] * m375 - a[6] * m411 + a[8] * m417 - a[14] * m423;
    const double m425 = a[3] * m377 - a[7] * m413 + a[9] * m419 - a[13] * m424;
    const double m426 = a[3] * m379 - a[7] * m415 + a[9] * m421 - a[11] * m424;
    const double m427 = a[4] * m380 - a[8] * m416 + a[10] * m422 - a[12] * m425 + a[14] * m426;
    const double m428 = a[1] * m381 - a[3] * a[0] * a[11] * a[14] + a[13] * a[0] * a[1] * a[14];
    const double m429 = a[1] * m382 - a[3] * a[0] * a[9] * a[14] + a[11] * a[0] * a[1] * a[14];
    const double m430 = a[2] * m383 - a[4] * m407 + a[12] * m428 - a[14] * m429;
    const double m431 = a[1] * m384 - a[3] * a[0] * a[7] * a[14] + a[9] * a[0] * a[1] * a[14];
    const double m432 = a[2] * m385 - a[4] * m408 + a[10] * m428 - a[14] * m431;
    const double m433 = a[3] * m387 - a[5] * m410 + a[11] * m430 - a[13] * m432;
    const double m434 = a[1] * m388 - a[3] * a[0] * a[5] * a[14] + a[7] * a[0] * a[1] * a[14];
    const double m435 = a[2] * m389 - a[4] * m411 + a[8] * m428 - a[14] * m434;
    const double m436 = a[3] * m391 - a[5] * m413 + a[9] * m430 - a[13] * m435;
    const double m437 = a[3] * m393 - a[5] * m415 + a[9] * m432 - a[11] * m435;
    const double m438 = a[4] * m394 - a[6] * m416 + a[10] * m433 - a[12] * m436 + a[14] * m437;
    const double m439 = a[1] * m395 - a[3] * a[0] * a[3] * a[14] + a[5] * a[0] * a[1] * a[14];
    const double m440 = a[2] * m396 - a[4] * m417 + a[6] * m428 - a[14] * m439;
    const double m441 = a[3] * m398 - a[5] * m419 + a[7] * m430 - a[13] * m440;
    const double m442 = a[3] * m400 - a[5] * m421 + a[7] * m432 - a[11] * m440;
    const double m443 = a[4] * m401 - a[6] * m422 + a[8] * m433 - a[12] * m441 + a[14] * m442;
    const double m444 = a[3] * m403 - a[5] * m424 + a[7] * m435 - a[9] * m440;
    const double m445 = a[4] * m404 - a[6] * m425 + a[8] * m436 - a[10] * m441 + a[14] * m444;
    const double m446 = a[5] * m406 - a[7] * m427 + a[9] * m438 - a[11] * m443 + a[13] * m445;
    const double m447 = a[1] * m366 - a[9] * a[0] * m359 + a[11] * a[0] * m362 - a[13] * a[0] * m364;
    const double m448 = a[1] * m373 - a[7] * a[0] * m359 + a[11] * a[0] * m369 - a[13] * a[0] * m371;
    const double m449 = a[1] * m377 - a[7] * a[0] * m362 + a[9] * a[0] * m369 - a[13] * a[0] * m375;
    const double m450 = a[1] * m379 - a[7] * a[0] * m364 + a[9] * a[0] * m371 - a[11] * a[0] * m375;
    const double m451 = a[2] * m380 - a[8] * m447 + a[10] * m448 - a[12] * m449 + a[14] * m450;
    const double m452 = a[1] * m387 - a[5] * a[0] * m359 + a[11] * a[0] * m383 - a[13] * a[0] * m385;
    const double m453 = a[1] * m391 - a[5] * a[0] * m362 + a[9] * a[0] * m383 - a[13] * a[0] * m389;
    const double m454 = a[1] * m393 - a[5] * a[0] * m364 + a[9] * a[0] * m385 - a[11] * a[0] * m389;
    const double m455 = a[2] * m394 - a[6] * m447 + a[10] * m452 - a[12] * m453 + a[14] * m454;
    const double m456 = a[1] * m398 - a[5] * a[0] * m369 + a[7] * a[0] * m383 - a[13] * a[0] * m396;
    const double m457 = a[1] * m400 - a[5] * a[0] * m371 + a[7] * a[0] * m385 - a[11] * a[0] * m396;
    const double m458 = a[2] * m401 - a[6] * m448 + a[8] * m452 - a[12] * m456 + a[14] * m457;
    const double m459 = a[1] * m403 - a[5] * a[0] * m375 + a[7] * a[0] * m389 - a[9] * a[0] * m396;
    const double m460 = a[2] * m404 - a[6] * m449 + a[8] * m453 - a[10] * m456 + a[14] * m459;
    const double m461 = a[3] * m406 - a[7] * m451 + a[9] * m455 - a[11] * m458 + a[13] * m460;
    const double m462 = a[1] * m410 - a[3] * a[0] * m359 + a[11] * a[0] * m407 - a[13] * a[0] * m408;
    const double m463 = a[1] * m413 - a[3] * a[0] * m362 + a[9] * a[0] * m407 - a[13] * a[0] * m411;
    const double m464 = a[1] * m415 - a[3] * a[0] * m364 + a[9] * a[0] * m408 - a[11] * a[0] * m411;
    const double m465 = a[2] * m416 - a[4] * m447 + a[10] * m462 - a[12] * m463 + a[14] * m464;
    const double m466 = a[1] * m419 - a[3] * a[0] * m369 + a[7] * a[0] * m407 - a[13] * a[0] * m417;
    const double m467 = a[1] * m421 - a[3] * a[0] * m371 + a[7] * a[0] * m408 - a[11] * a[0] * m417;
    const double m468 = a[2] * m422 - a[4] * m448 + a[8] * m462 - a[12] * m466 + a[14] * m467;
    const double m469 = a[1] * m424 - a[3] * a[0] * m375 + a[7] * a[0] * m411 - a[9] * a[0] * m417;
    const double m470 = a[2] * m425 - a[4] * m449 + a[8] * m463 - a[10] * m466 + a[14] * m469;
    const double m471 = a[3] * m427 - a[5] * m451 + a[9] * m465 - a[11] * m468 + a[13] * m470;
    const double m472 = a[1] * m430 - a[3] * a[0] * m383 + a[5] * a[0] * m407 - a[13] * a[0] * m428;
    const double m473 = a[1] * m432 - a[3] * a[0] * m385 + a[5] * a[0] * m408 - a[11] * a[0] * m428;
    const double m474 = a[2] * m433 - a[4] * m452 + a[6] * m462 - a[12] * m472 + a[14] * m473;
    const double m475 = a[1] * m435 - a[3] * a[0] * m389 + a[5] * a[0] * m411 - a[9] * a[0] * m428;
    const double m476 = a[2] * m436 - a[4] * m453 + a[6] * m463 - a[10] * m472 + a[14] * m475;
    const double m477 = a[3] * m438 - a[5] * m455 + a[7] * m465 - a[11] * m474 + a[13] * m476;
    const double m478 = a[1] * m440 - a[3] * a[0] * m396 + a[5] * a[0] * m417 - a[7] * a[0] * m428;
    const double m479 = a[2] * m441 - a[4] * m456 + a[6] * m466 - a[8] * m472 + a[14] * m478;
    const double m480 = a[3] * m443 - a[5] * m458 + a[7] * m468 - a[9] * m474 + a[13] * m479;
    const double m481 = a[3] * m445 - a[5] * m460 + a[7] * m470 - a[9] * m476 + a[11] * m479;
    const double m482 = a[4] * m446 - a[6] * m461 + a[8] * m471 - a[10] * m477 + a[12] * m480
        - a[14] * m481;
    const double m483 = a[1] * m406 - a[7] * a[0] * m380 + a[9] * a[0] * m394 - a[11] * a[0] * m401
        + a[13] * a[0] * m404;
    const double m484 = a[1] * m427 - a[5] * a[0] * m380 + a[9] * a[0] * m416 - a[11] * a[0] * m422
        + a[13] * a[0] * m425;
    const double m485 = a[1] * m438 - a[5] * a[0] * m394 + a[7] * a[0] * m416 - a[11] * a[0] * m433
        + a[13] * a[0] * m436;
    const double m486 = a[1] * m443 - a[5] * a[0] * m401 + a[7] * a[0] * m422 - a[9] * a[0] * m433
        + a[13] * a[0] * m441;
    const double m487 = a[1] * m445 - a[5] * a[0] * m404 + a[7] * a[0] * m425 - a[9] * a[0] * m436
        + a[11] * a[0] * m441;
    const double m488 = a[2] * m446 - a[6] * m483 + a[8] * m484 - a[10] * m485 + a[12] * m486
        - a[14] * m487;
    const double m489 = a[1] * m451 - a[3] * a[0] * m380 + a[9] * a[0] * m447 - a[11] * a[0] * m448
        + a[13] * a[0] * m449;
    const double m490 = a[1] * m455 - a[3] * a[0] * m394 + a[7] * a[0] * m447 - a[11] * a[0] * m452
        + a[13] * a[0] * m453;
    const double m491 = a[1] * m458 - a[3] * a[0] * m401 + a[7] * a[0] * m448 - a[9] * a[0] * m452
        + a[13] * a[0] * m456;
    const double m492 = a[1] * m460 - a[3] * a[0] * m404 + a[7] * a[0] * m449 - a[9] * a[0] * m453
        + a[11] * a[0] * m456;
    const double m493 = a[2] * m461 - a[4] * m483 + a[8] * m489 - a[10] * m490 + a[12] * m491
        - a[14] * m492;
    const double m494 = a[1] * m465 - a[3] * a[0] * m416 + a[5] * a[0] * m447 - a[11] * a[0] * m462
        + a[13] * a[0] * m463;
    const double m495 = a[1] * m468 - a[3] * a[0] * m422 + a[5] * a[0] * m448 - a[9] * a[0] * m462
        + a[13] * a[0] * m466;
    const double m496 = a[1] * m470 - a[3] * a[0] * m425 + a[5] * a[0] * m449 - a[9] * a[0] * m463
        + a[11] * a[0] * m466;
    const double m497 = a[2] * m471 - a[4] * m484 + a[6] * m489 - a[10] * m494 + a[12] * m495
        - a[14] * m496;
    const double m498 = a[1] * m474 - a[3] * a[0] * m433 + a[5] * a[0] * m452 - a[7] * a[0] * m462
        + a[13] * a[0] * m472;
    const double m499 = a[1] * m476 - a[3] * a[0] * m436 + a[5] * a[0] * m453 - a[7] * a[0] * m463
        + a[11] * a[0] * m472;
    const double m500 = a[2] * m477 - a[4] * m485 + a[6] * m490 - a[8] * m494 + a[12] * m498
        - a[14] * m499;
    const double m501 = a[1] * m479 - a[3] * a[0] * m441 + a[5] * a[0] * m456 - a[7] * a[0] * m466
        + a[9] * a[0] * m472;
    const double m502 = a[2] * m480 - a[4] * m486 + a[6] * m491 - a[8] * m495 + a[10] * m498
        - a[14] * m501;
    const double m503 = a[3] * m482 - a[5] * m488 + a[7] * m493 - a[9] * m497 + a[11] * m500
        - a[13] * m502;
    const double m504 = a[1] * m482 - a[5] * a[0] * m446 + a[7] * a[0] * m461 - a[9] * a[0] * m471
        + a[11] * a[0] * m477 - a[13] * a[0] * m480;
    const double m505 = a[1] * m488 - a[3] * a[0] * m446 + a[7] * a[0] * m483 - a[9] * a[0] * m484
        + a[11] * a[0] * m485 - a[13] * a[0] * m486;
    const double m506 = a[1] * m493 - a[3] * a[0] * m461 + a[5] * a[0] * m483 - a[9] * a[0] * m489
        + a[11] * a[0] * m490 - a[13] * a[0] * m491;
    const double m507 = a[1] * m497 - a[3] * a[0] * m471 + a[5] * a[0] * m484 - a[7] * a[0] * m489
        + a[11] * a[0] * m494 - a[13] * a[0] * m495;
    const double m508 = a[1] * m500 - a[3] * a[0] * m477 + a[5] * a[0] * m485 - a[7] * a[0] * m490
        + a[9] * a[0] * m494 - a[13] * a[0] * m498;
    const double m509 = a[1] * m502 - a[3] * a[0] * m480 + a[5] * a[0] * m486 - a[7] * a[0] * m491
        + a[9] * a[0] * m495 - a[11] * a[0] * m498;
    const double m510 = a[2] * m503 - a[4] * m504 + a[6] * m505 - a[8] * m506 + a[10] * m507
        - a[12] * m508 + a[14] * m509;
    const double m511 = a[1] * m510 - a[3] * a[0] * m503 + a[5] * a[0] * m504 - a[7] * a[0] * m505
        + a[9] * a[0] * m506 - a[11] * a[0] * m507 + a[13] * a[0] * m508;
    const double m512 = a[11] * a[12] - a[13] * a[10];
    const double m513 = a[9] * a[12] - a[13] * a[8];
    const double m514 = a[9] * a[10] - a[11] * a[8];
    const double m515 = a[10] * m512 - a[12] * m513 + a[14] * m514;
    const double m516 = a[7] * a[12] - a[13] * a[6];
    const double m517 = a[7] * a[10] - a[11] * a[6];
    const double m518 = a[8] * m512 - a[12] * m516 + a[14] * m517;
    const double m519 = a[7] * a[8] - a[9] * a[6];
    const double m520 = a[8] * m513 - a[10] * m516 + a[14] * m519;
    const double m521 = a[9] * m515 - a[11] * m518 + a[13] * m520;
    const double m522 = a[5] * a[12] - a[13] * a[4];
    const double m523 = a[5] * a[10] - a[11] * a[4];
    const double m524 = a[6] * m512 - a[12] * m522 + a[14] * m523;
    const double m525 = a[5] * a[8] - a[9] * a[4];
    const double m526 = a[6] * m513 - a[10] * m522 + a[14] * m525;
    const double m527 = a[7] * m515 - a[11] * m524 + a[13] * m526;
    const double m528 = a[5] * a[6] - a[7] * a[4];
    const double m529 = a[6] * m516 - a[8] * m522 + a[14] * m528;
    const double m530 = a[7] * m518 - a[9] * m524 + a[13] * m529;
    const double m531 = a[7] * m520 - a[9] * m526 + a[11] * m529;
    const double m532 = a[8] * m521 - a[10] * m527 + a[12] * m530 - a[14] * m531;
    const double m533 = a[3] * a[12] - a[13] * a[2];
    const double m534 = a[3] * a[10] - a[11] * a[2];
    const double m535 = a[4] * m512 - a[12] * m533 + a[14] * m534;
    const double m536 = a[3] * a[8] - a[9] * a[2];
    const double m537 = a[4] * m513 - a[10] * m533 + a[14] * m536;
    const double m538 = a[5] * m515 - a[11] * m535 + a[13] * m537;
    const double m539 = a[3] * a[6] - a[7] * a[2];
    const double m540 = a[4] * m516 - a[8] * m533 + a[14] * m539;
    const double m541 = a[5] * m518 - a[9] * m535 + a[13] * m540;
    const double m542 = a[5] * m520 - a[9] * m537 + a[11] * m540;
    const double m543 = a[6] * m521 - a[10] * m538 + a[12] * m541 - a[14] * m542;
    const double m544 = a[3] * a[4] - a[5] * a[2];
    const double m545 = a[4] * m522 - a[6] * m533 + a[14] * m544;
    const double m546 = a[5] * m524 - a[7] * m535 + a[13] * m545;
    const double m547 = a[5] * m526 - a[7] * m537 + a[11] * m545;
    const double m548 = a[6] * m527 - a[8] * m538 + a[12] * m546 - a[14] * m547;
    const double m549 = a[5] * m529 - a[7] * m540 + a[9] * m545;
    const double m550 = a[6] * m530 - a[8] * m541 + a[10] * m546 - a[14] * m549;
    const double m551 = a[7] * m532 - a[9] * m543 + a[11] * m548 - a[13] * m550;
    const double m552 = a[1] * a[12] - a[13] * a[0];
    const double m553 = a[1] * a[10] - a[11] * a[0];
    const double m554 = a[2] * m512 - a[12] * m552 + a[14] * m553;
    const double m555 = a[1] * a[8] - a[9] * a[0];
    const double m556 = a[2] * m513 - a[10] * m552 + a[14] * m555;
    const double m557 = a[3] * m515 - a[11] * m554 + a[13] * m556;
    const double m558 = a[1] * a[6] - a[7] * a[0];
    const double m559 = a[2] * m516 - a[8] * m552 + a[14] * m558;
    const double m560 = a[3] * m518 - a[9] * m554 + a[13] * m559;
    const double m561 = a[3] * m520 - a[9] * m556 + a[11] * m559;
    const double m562 = a[4] * m521 - a[10] * m557 + a[12] * m560 - a[14] * m561;
    const double m563 = a[1] * a[4] - a[5] * a[0];
    const double m564 = a[2] * m522 - a[6] * m552 + a[14] * m563;
    const double m565 = a[3] * m524 - a[7] * m554 + a[13] * m564;
    const double m566 = a[3] * m526 - a[7] * m556 + a[11] * m564;
    const double m567 = a[4] * m527 - a[8] * m557 + a[12] * m565 - a[14] * m566;
    const double m568 = a[3] * m529 - a[7] * m559 + a[9] * m564;
    const double m569 = a[4] * m530 - a[8] * m560 + a[10] * m565 - a[14] * m568;
    const double m570 = a[5] * m532 - a[9] * m562 + a[11] * m567 - a[13] * m569;
    const double m571 = a[1] * a[2] - a[3] * a[0];
    const double m572 = a[2] * m533 - a[4] * m552 + a[14] * m571;
    const double m573 = a[3] * m535 - a[5] * m554 + a[13] * m572;
    const double m574 = a[3] * m537 - a[5] * m556 + a[11] * m572;
    const double m575 = a[4] * m538 - a[6] * m557 + a[12] * m573 - a[14] * m574;
    const double m576 = a[3] * m540 - a[5] * m559 + a[9] * m572;
    const double m577 = a[4] * m541 - a[6] * m560 + a[10] * m573 - a[14] * m576;
    const double m578 = a[5] * m543 - a[7] * m562 + a[11] * m575 - a[13] * m577;
    const double m579 = a[3] * m545 - a[5] * m564 + a[7] * m572;
    const double m580 = a[4] * m546 - a[6] * m565 + a[8] * m573 - a[14] * m579;
    const double m581 = a[5] * m548 - a[7] * m567 + a[9] * m575 - a[13] * m580;
    const double m582 = a[5] * m550 - a[7] * m569 + a[9] * m577 - a[11] * m580;
    const double m583 = a[6] * m551 - a[8] * m570 + a[10] * m578 - a[12] * m581 + a[14] * m582;
    const double m584 = a[1] * m515 - a[11] * a[0] * m512 + a[13] * a[0] * m513;
    const double m585 = a[1] * m518 - a[9] * a[0] * m512 + a[13] * a[0] * m516;
    const double m586 = a[1] * m520 - a[9] * a[0] * m513 + a[11] * a[0] * m516;
    const double m587 = a[2] * m521 - a[10] * m584 + a[12] * m585 - a[14] * m586;
    const double m588 = a[1] * m524 - a[7] * a[0] * m512 + a[13] * a[0] * m522;
    const double m589 = a[1] * m526 - a[7] * a[0] * m513 + a[11] * a[0] * m522;
    const double m590 = a[2] * m527 - a[8] * m584 + a[12] * m588 - a[14] * m589;
    const double m591 = a[1] * m529 - a[7] * a[0] * m516 + a[9] * a[0] * m522;
    const double m592 = a[2] * m530 - a[8] * m585 + a[10] * m588 - a[14] * m591;
    const double m593 = a[3] * m532 - a[9] * m587 + a[11] * m590 - a[13] * m592;
    const double m594 = a[1] * m535 - a[5] * a[0] * m512 + a[13] * a[0] * m533;
    const double m595 = a[1] * m537 - a[5] * a[0] * m513 + a[11] * a[0] * m533;
    const double m596 = a[2] * m538 - a[6] * m584 + a[12] * m594 - a[14] * m595;
    const double m597 = a[1] * m540 - a[5] * a[0] * m516 + a[9] * a[0] * m533;
    const double m598 = a[2] * m541 - a[6] * m585 + a[10] * m594 - a[14] * m597;
    const double m599 = a[3] * m543 - a[7] * m587 + a[11] * m596 - a[13] * m598;
    const double m600 = a[1] * m545 - a[5] * a[0] * m522 + a[7] * a[0] * m533;
    const double m601 = a[2] * m546 - a[6] * m588 + a[8] * m594 - a[14] * m600;
    const double m602 = a[3] * m548 - a[7] * m590 + a[9] * m596 - a[13] * m601;
    const double m603 = a[3] * m550 - a[7] * m592 + a[9] * m598 - a[11] * m601;
    const double m604 = a[4] * m551 - a[8] * m593 + a[10] * m599 - a[12] * m602 + a[14] * m603;
    const double m605 = a[1] * m554 - a[3] * a[0] * m512 + a[13] * a[0] * m552;
    const double m606 = a[1] * m556 - a[3] * a[0] * m513 + a[11] * a[0] * m552;
    const double m607 = a[2] * m557 - a[4] * m584 + a[12] * m605 - a[14] * m606;
    const double m608 = a[1] * m559 - a[3] * a[0] * m516 + a[9] * a[0] * m552;
    const double m609 = a[2] * m560 - a[4] * m585 + a[10] * m605 - a[14] * m608;
    const double m610 = a[3] * m562 - a[5] * m587 + a[11] * m607 - a[13] * m609;
    const double m611 = a[1] * m564 - a[3] * a[0] * m522 + a[7] * a[0] * m552;
    const double m612 = a[2] * m565 - a[4] * m588 + a[8] * m605 - a[14] * m611;
    const double m613 = a[3] * m567 - a[5] * m590 + a[9] * m607 - a[13] * m612;
    const double m614 = a[3] * m569 - a[5] * m592 + a[9] * m609 - a[11] * m612;
    const double m615 = a[4] * m570 - a[6] * m593 + a[10] * m610 - a[12] * m613 + a[14] * m614;
    const double m616 = a[1] * m572 - a[3] * a[0] * m533 + a[5] * a[0] * m552;
    const double m617 = a[2] * m573 - a[4] * m594 + a[6] * m605 - a[14] * m616;
    const double m618 = a[3] * m575 - a[5] * m596 + a[7] * m607 - a[13] * m617;
    const double m619 = a[3] * m577 - a[5] * m598 + a[7] * m609 - a[11] * m617;
    const double m620 = a[4] * m578 - a[6] * m599 + a[8] * m610 - a[12] * m618 + a[14] * m619;
    const double m621 = a[3] * m580 - a[5] * m601 + a[7] * m612 - a[9] * m617;
    const double m622 = a[4] * m581 - a[6] * m602 + a[8] * m613 - a[10] * m618 + a[14] * m621;
    const double m623 = a[5] * m583 - a[7] * m604 + a[9] * m615 - a[11] * m620 + a[13] * m622;
    const double m624 = a[1] * m532 - a[9] * a[0] * m521 + a[11] * a[0] * m527 - a[13] * a[0] * m530;
    const double m625 = a[1] * m543 - a[7] * a[0] * m521 + a[11] * a[0] * m538 - a[13] * a[0] * m541;
    const double m626 = a[1] * m548 - a[7] * a[0] * m527 + a[9] * a[0] * m538 - a[13] * a[0] * m546;
    const double m627 = a[1] * m550 - a[7] * a[0] * m530 + a[9] * a[0] * m541 - a[11] * a[0] * m546;
    const double m628 = a[2] * m551 - a[8] * m624 + a[10] * m625 - a[12] * m626 + a[14] * m627;
    const double m629 = a[1] * m562 - a[5] * a[0] * m521 + a[11] * a[0] * m557 - a[13] * a[0] * m560;
    const double m630 = a[1] * m567 - a[5] * a[0] * m527 + a[9] * a[0] * m557 - a[13] * a[0] * m565;
    const double m631 = a[1] * m569 - a[5] * a[0] * m530 + a[9] * a[0] * m560 - a[11] * a[0] * m565;
    const double m632 = a[2] * m570 - a[6] * m624 + a[10] * m629 - a[12] * m630 + a[14] * m631;
    const double m633 = a[1] * m575 - a[5] * a[0] * m538 + a[7] * a[0] * m557 - a[13] * a[0] * m573;
    const double m634 = a[1] * m577 - a[5] * a[0] * m541 + a[7] * a[0] * m560 - a[11] * a[0] * m573;
    const double m635 = a[2] * m578 - a[6] * m625 + a[8] * m629 - a[12] * m633 + a[14] * m634;
    const double m636 = a[1] * m580 - a[5] * a[0] * m546 + a[7] * a[0] * m565 - a[9] * a[0] * m573;
    const double m637 = a[2] * m581 - a[6] * m626 + a[8] * m630 - a[10] * m633 + a[14] * m636;
    const double m638 = a[3] * m583 - a[7] * m628 + a[9] * m632 - a[11] * m635 + a[13] * m637;
    const double m639 = a[1] * m587 - a[3] * a[0] * m521 + a[11] * a[0] * m584 - a[13] * a[0] * m585;
    const double m640 = a[1] * m590 - a[3] * a[0] * m527 + a[9] * a[0] * m584 - a[13] * a[0] * m588;
    const double m641 = a[1] * m592 - a[3] * a[0] * m530 + a[9] * a[0] * m585 - a[11] * a[0] * m588;
    const double m642 = a[2] * m593 - a[4] * m624 + a[10] * m639 - a[12] * m640 + a[14] * m641;
    const double m643 = a[1] * m596 - a[3] * a[0] * m538 + a[7] * a[0] * m584 - a[13] * a[0] * m594;
    const double m644 = a[1] * m598 - a[3] * a[0] * m541 + a[7] * a[0] * m585 - a[11] * a[0] * m594;
    const double m645 = a[2] * m599 - a[4] * m625 + a[8] * m639 - a[12] * m643 + a[14] * m644;
    const double m646 = a[1] * m601 - a[3] * a[0] * m546 + a[7] * a[0] * m588 - a[9] * a[0] * m594;
    const double m647 = a[2] * m602 - a[4] * m626 + a[8] * m640 - a[10] * m643 + a[14] * m646;
    const double m648 = a[3] * m604 - a[5] * m628 + a[9] * m642 - a[11] * m645 + a[13] * m647;
    const double m649 = a[1] * m607 - a[3] * a[0] * m557 + a[5] * a[0] * m584 - a[13] * a[0] * m605;
    const double m650 = a[1] * m609 - a[3] * a[0] * m560 + a[5] * a[0] * m585 - a[11] * a[0] * m605;
    const double m651 = a[2] * m610 - a[4] * m629 + a[6] * m639 - a[12] * m649 + a[14] * m650;
    const double m652 = a[1] * m612 - a[3] * a[0] * m565 + a[5] * a[0] * m588 - a[9] * a[0] * m605;
    const double m653 = a[2] * m613 - a[4] * m630 + a[6] * m640 - a[10] * m649 + a[14] * m652;
    const double m654 = a[3] * m615 - a[5] * m632 + a[7] * m642 - a[11] * m651 + a[13] * m653;
    const double m655 = a[1] * m617 - a[3] * a[0] * m573 + a[5] * a[0] * m594 - a[7] * a[0] * m605;
    const double m656 = a[2] * m618 - a[4] * m633 + a[6] * m643 - a[8] * m649 + a[14] * m655;
    const double m657 = a[3] * m620 - a[5] * m635 + a[7] * m645 - a[9] * m651 + a[13] * m656;
    const double m658 = a[3] * m622 - a[5] * m637 + a[7] * m647 - a[9] * m653 + a[11] * m656;
    const double m659 = a[4] * m623 - a[6] * m638 + a[8] * m648 - a[10] * m654 + a[12] * m657
        - a[14] * m658;
    const double m660 = a[1] * m583 - a[7] * a[0] * m551 + a[9] * a[0] * m570 - a[11] * a[0] * m578
        + a[13] * a[0] * m581;
    const double m661 = a[1] * m604 - a[5] * a[0] * m551 + a[9] * a[0] * m593 - a[11] * a[0] * m599
        + a[13] * a[0] * m602;
    const double m662 = a[1] * m615 - a[5] * a[0] * m570 + a[7] * a[0] * m593 - a[11] * a[0] * m610
        + a[13] * a[0] * m613;
    const double m663 = a[1] * m620 - a[5] * a[0] * m578 + a[7] * a[0] * m599 - a[9] * a[0] * m610
        + a[13] * a[0] * m618;
    const double m664 = a[1] * m622 - a[5] * a[0] * m581 + a[7] * a[0] * m602 - a[9] * a[0] * m613
        + a[11] * a[0] * m618;
    const double m665 = a[2] * m623 - a[6] * m660 + a[8] * m661 - a[10] * m662 + a[12] * m663
        - a[14] * m664;
    const double m666 = a[1] * m628 - a[3] * a[0] * m551 + a[9] * a[0] * m624 - a[11] * a[0] * m625
        + a[13] * a[0] * m626;
    const double m667 = a[1] * m632 - a[3] * a[0] * m570 + a[7] * a[0] * m624 - a[11] * a[0] * m629
        + a[13] * a[0] * m630;
    const double m668 = a[1] * m635 - a[3] * a[0] * m578 + a[7] * a[0] * m625 - a[9] * a[0] * m629
        + a[13] * a[0] * m633;
    const double m669 = a[1] * m637 - a[3] * a[0] * m581 + a[7] * a[0] * m626 - a[9] * a[0] * m630
        + a[11] * a[0] * m633;
    const double m670 = a[2] * m638 - a[4] * m660 + a[8] * m666 - a[10] * m667 + a[12] * m668
        - a[14] * m669;
    const double m671 = a[1] * m642 - a[3] * a[0] * m593 + a[5] * a[0] * m624 - a[11] * a[0] * m639
        + a[13] * a[0] * m640;
    const double m672 = a[1] * m645 - a[3] * a[0] * m599 + a[5] * a[0] * m625 - a[9] * a[0] * m639
        + a[13] * a[0] * m643;
    const double m673 = a[1] * m647 - a[3] * a[0] * m602 + a[5] * a[0] * m626 - a[9] * a[0] * m640
        + a[11] * a[0] * m643;
    const double m674 = a[2] * m648 - a[4] * m661 + a[6] * m666 - a[10] * m671 + a[12] * m672
        - a[14] * m673;
    const double m675 = a[1] * m651 - a[3] * a[0] * m610 + a[5] * a[0] * m629 - a[7] * a[0] * m639
        + a[13] * a[0] * m649;
    const double m676 = a[1] * m653 - a[3] * a[0] * m613 + a[5] * a[0] * m630 - a[7] * a[0] * m640
        + a[11] * a[0] * m649;
    const double m677 = a[2] * m654 - a[4] * m662 + a[6] * m667 - a[8] * m671 + a[12] * m675
        - a[14] * m676;
    const double m678 = a[1] * m656 - a[3] * a[0] * m618 + a[5] * a[0] * m633 - a[7] * a[0] * m643
        + a[9] * a[0] * m649;
    const double m679 = a[2] * m657 - a[4] * m663 + a[6] * m668 - a[8] * m672 + a[10] * m675
        - a[14] * m678;
    const double m680 = a[3] * m659 - a[5] * m665 + a[7] * m670 - a[9] * m674 + a[11] * m677
        - a[13] * m679;
    const double m681 = a[1] * m659 - a[5] * a[0] * m623 + a[7] * a[0] * m638 - a[9] * a[0] * m648
        + a[11] * a[0] * m654 - a[13] * a[0] * m657;
    const double m682 = a[1] * m665 - a[3] * a[0] * m623 + a[7] * a[0] * m660 - a[9] * a[0] * m661
        + a[11] * a[0] * m662 - a[13] * a[0] * m663;
    const double m683 = a[1] * m670 - a[3] * a[0] * m638 + a[5] * a[0] * m660 - a[9] * a[0] * m666
        + a[11] * a[0] * m667 - a[13] * a[0] * m668;
    const double m684 = a[1] * m674 - a[3] * a[0] * m648 + a[5] * a[0] * m661 - a[7] * a[0] * m666
        + a[11] * a[0] * m671 - a[13] * a[0] * m672;
    const double m685 = a[1] * m677 - a[3] * a[0] * m654 + a[5] * a[0] * m662 - a[7] * a[0] * m667
        + a[9] * a[0] * m671 - a[13] * a[0] * m675;
    const double m686 = a[1] * m679 - a[3] * a[0] * m657 + a[5] * a[0] * m663 - a[7] * a[0] * m668
        + a[9] * a[0] * m672 - a[11] * a[0] * m675;
    const double m687 = a[2] * m680 - a[4] * m681 + a[6] * m682 - a[8] * m683 + a[10] * m684
        - a[12] * m685 + a[14] * m686;
    const double m688 = a[1] * m687 - a[3] * a[0] * m680 + a[5] * a[0] * m681 - a[7] * a[0] * m682
        + a[9] * a[0] * m683 - a[11] * a[0] * m684 + a[13] * a[0] * m685;
    const double determinant = a[1] * m181 - a[3] * a[0] * m174 + a[5] * a[0] * m175 - a[7] * a[0] * m176
        + a[9] * a[0] * m177 - a[11] * a[0] * m178 + a[13] * a[0] * m179;
    const double numerator = -b[0] * m181 + b[1] * a[0] * m174 - b[2] * a[0] * m175 + b[3] * a[0] * m176
        - b[4] * a[0] * m177 + b[5] * a[0] * m178 - b[6] * a[0] * m179 + b[7] * a[0] * m180
        - b[8] * a[0] * m183 + b[9] * a[0] * m198 - b[10] * a[0] * m249
        + b[11] * a[0] * m355 - b[12] * a[0] * m511 + b[13] * a[0] * m688;
    return numerator / (2.0 * a[0] * determinant);
}
