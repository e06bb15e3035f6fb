// Correctly rounded in all but a few in 2^29 cases; IEEE 754 at the edges.

fn sin_f32(x: f32) -> f32 { return sin(x); }
// run: sin_f32(0.0) == 0.0
// run: sin_f32(-0.0) == -0.0
// run: sin_f32(1.0) == 0.84147096
// run: sin_f32(-1.0) == -0.84147096
// run: sin_f32(0.5) == 0.47942555
// run: sin_f32(0.1) == 0.09983342
// run: sin_f32(-0.3) == -0.29552022
// run: sin_f32(2.0) == 0.9092974
// run: sin_f32(3.1415927) == -8.742278e-08
// run: sin_f32(1.5707964) == 1.0
// run: sin_f32(1e+01) == -0.5440211
// run: sin_f32(100.5) == -0.030959968
// run: sin_f32(1e+06) == -0.3499935
// run: sin_f32(1e+20) == 0.6565767
// run: sin_f32(-1e-10) == -1e-10
// run: sin_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: sin_f32(0.99999994) == 0.84147096
// run: sin_f32(bitcast<f32>(0x7fc00000u)) == nan

fn sin_vec3(x: vec3<f32>) -> vec3<f32> { return sin(x); }
// run: sin_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.24740396, 0.58509725, 0.7833269)

fn cos_f32(x: f32) -> f32 { return cos(x); }
// run: cos_f32(0.0) == 1.0
// run: cos_f32(-0.0) == 1.0
// run: cos_f32(1.0) == 0.5403023
// run: cos_f32(-1.0) == 0.5403023
// run: cos_f32(0.5) == 0.87758255
// run: cos_f32(0.1) == 0.9950042
// run: cos_f32(-0.3) == 0.9553365
// run: cos_f32(2.0) == -0.41614684
// run: cos_f32(3.1415927) == -1.0
// run: cos_f32(1.5707964) == -4.371139e-08
// run: cos_f32(1e+01) == -0.8390715
// run: cos_f32(100.5) == 0.9995206
// run: cos_f32(1e+06) == 0.93675214
// run: cos_f32(1e+20) == 0.7542593
// run: cos_f32(-1e-10) == 1.0
// run: cos_f32(bitcast<f32>(0x00000001u)) == 1.0
// run: cos_f32(0.99999994) == 0.54030234
// run: cos_f32(bitcast<f32>(0x7fc00000u)) == nan

fn cos_vec3(x: vec3<f32>) -> vec3<f32> { return cos(x); }
// run: cos_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.9689124, 0.8109631, 0.62161)

fn tan_f32(x: f32) -> f32 { return tan(x); }
// run: tan_f32(0.0) == 0.0
// run: tan_f32(-0.0) == -0.0
// run: tan_f32(1.0) == 1.5574077
// run: tan_f32(-1.0) == -1.5574077
// run: tan_f32(0.5) == 0.5463025
// run: tan_f32(0.1) == 0.100334674
// run: tan_f32(-0.3) == -0.30933627
// run: tan_f32(2.0) == -2.1850398
// run: tan_f32(3.1415927) == 8.742278e-08
// run: tan_f32(1.5707964) == -22877332.0
// run: tan_f32(1e+01) == 0.64836085
// run: tan_f32(100.5) == -0.030974815
// run: tan_f32(1e+06) == -0.37362444
// run: tan_f32(1e+20) == 0.870492
// run: tan_f32(-1e-10) == -1e-10
// run: tan_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: tan_f32(0.99999994) == 1.5574075
// run: tan_f32(bitcast<f32>(0x7fc00000u)) == nan

fn tan_vec3(x: vec3<f32>) -> vec3<f32> { return tan(x); }
// run: tan_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.25534192, 0.7214844, 1.2601582)

fn asin_f32(x: f32) -> f32 { return asin(x); }
// run: asin_f32(0.0) == 0.0
// run: asin_f32(-0.0) == -0.0
// run: asin_f32(1.0) == 1.5707964
// run: asin_f32(-1.0) == -1.5707964
// run: asin_f32(0.5) == 0.5235988
// run: asin_f32(0.1) == 0.10016742
// run: asin_f32(-0.3) == -0.30469266
// run: asin_f32(2.0) == nan
// run: asin_f32(3.1415927) == nan
// run: asin_f32(1.5707964) == nan
// run: asin_f32(1e+01) == nan
// run: asin_f32(100.5) == nan
// run: asin_f32(1e+06) == nan
// run: asin_f32(1e+20) == nan
// run: asin_f32(-1e-10) == -1e-10
// run: asin_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: asin_f32(0.99999994) == 1.570451
// run: asin_f32(bitcast<f32>(0x7fc00000u)) == nan

fn asin_vec3(x: vec3<f32>) -> vec3<f32> { return asin(x); }
// run: asin_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.25268024, 0.67513156, 1.1197695)

fn acos_f32(x: f32) -> f32 { return acos(x); }
// run: acos_f32(0.0) == 1.5707964
// run: acos_f32(-0.0) == 1.5707964
// run: acos_f32(1.0) == 0.0
// run: acos_f32(-1.0) == 3.1415927
// run: acos_f32(0.5) == 1.0471976
// run: acos_f32(0.1) == 1.4706289
// run: acos_f32(-0.3) == 1.875489
// run: acos_f32(2.0) == nan
// run: acos_f32(3.1415927) == nan
// run: acos_f32(1.5707964) == nan
// run: acos_f32(1e+01) == nan
// run: acos_f32(100.5) == nan
// run: acos_f32(1e+06) == nan
// run: acos_f32(1e+20) == nan
// run: acos_f32(-1e-10) == 1.5707964
// run: acos_f32(bitcast<f32>(0x00000001u)) == 1.5707964
// run: acos_f32(0.99999994) == 0.00034526698
// run: acos_f32(bitcast<f32>(0x7fc00000u)) == nan

fn acos_vec3(x: vec3<f32>) -> vec3<f32> { return acos(x); }
// run: acos_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(1.3181161, 0.8956648, 0.45102686)

fn atan_f32(x: f32) -> f32 { return atan(x); }
// run: atan_f32(0.0) == 0.0
// run: atan_f32(-0.0) == -0.0
// run: atan_f32(1.0) == 0.7853982
// run: atan_f32(-1.0) == -0.7853982
// run: atan_f32(0.5) == 0.4636476
// run: atan_f32(0.1) == 0.09966865
// run: atan_f32(-0.3) == -0.29145682
// run: atan_f32(2.0) == 1.1071488
// run: atan_f32(3.1415927) == 1.2626272
// run: atan_f32(1.5707964) == 1.0038848
// run: atan_f32(1e+01) == 1.4711276
// run: atan_f32(100.5) == 1.5608464
// run: atan_f32(1e+06) == 1.5707953
// run: atan_f32(1e+20) == 1.5707964
// run: atan_f32(-1e-10) == -1e-10
// run: atan_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: atan_f32(0.99999994) == 0.7853981
// run: atan_f32(bitcast<f32>(0x7fc00000u)) == nan

fn atan_vec3(x: vec3<f32>) -> vec3<f32> { return atan(x); }
// run: atan_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.24497867, 0.5585993, 0.7328151)

fn sinh_f32(x: f32) -> f32 { return sinh(x); }
// run: sinh_f32(0.0) == 0.0
// run: sinh_f32(-0.0) == -0.0
// run: sinh_f32(1.0) == 1.1752012
// run: sinh_f32(-1.0) == -1.1752012
// run: sinh_f32(0.5) == 0.5210953
// run: sinh_f32(0.1) == 0.10016675
// run: sinh_f32(-0.3) == -0.3045203
// run: sinh_f32(2.0) == 3.6268604
// run: sinh_f32(3.1415927) == 11.54874
// run: sinh_f32(1.5707964) == 2.301299
// run: sinh_f32(1e+01) == 11013.232
// run: sinh_f32(100.5) == bitcast<f32>(0x7f800000u)
// run: sinh_f32(1e+06) == bitcast<f32>(0x7f800000u)
// run: sinh_f32(1e+20) == bitcast<f32>(0x7f800000u)
// run: sinh_f32(-1e-10) == -1e-10
// run: sinh_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: sinh_f32(0.99999994) == 1.175201
// run: sinh_f32(bitcast<f32>(0x7fc00000u)) == nan

fn sinh_vec3(x: vec3<f32>) -> vec3<f32> { return sinh(x); }
// run: sinh_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.25261232, 0.6664923, 1.0265167)

fn cosh_f32(x: f32) -> f32 { return cosh(x); }
// run: cosh_f32(0.0) == 1.0
// run: cosh_f32(-0.0) == 1.0
// run: cosh_f32(1.0) == 1.5430807
// run: cosh_f32(-1.0) == 1.5430807
// run: cosh_f32(0.5) == 1.127626
// run: cosh_f32(0.1) == 1.0050042
// run: cosh_f32(-0.3) == 1.0453385
// run: cosh_f32(2.0) == 3.7621956
// run: cosh_f32(3.1415927) == 11.591954
// run: cosh_f32(1.5707964) == 2.5091786
// run: cosh_f32(1e+01) == 11013.233
// run: cosh_f32(100.5) == bitcast<f32>(0x7f800000u)
// run: cosh_f32(1e+06) == bitcast<f32>(0x7f800000u)
// run: cosh_f32(1e+20) == bitcast<f32>(0x7f800000u)
// run: cosh_f32(-1e-10) == 1.0
// run: cosh_f32(bitcast<f32>(0x00000001u)) == 1.0
// run: cosh_f32(0.99999994) == 1.5430806
// run: cosh_f32(bitcast<f32>(0x7fc00000u)) == nan

fn cosh_vec3(x: vec3<f32>) -> vec3<f32> { return cosh(x); }
// run: cosh_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(1.0314131, 1.2017537, 1.4330864)

fn tanh_f32(x: f32) -> f32 { return tanh(x); }
// run: tanh_f32(0.0) == 0.0
// run: tanh_f32(-0.0) == -0.0
// run: tanh_f32(1.0) == 0.7615942
// run: tanh_f32(-1.0) == -0.7615942
// run: tanh_f32(0.5) == 0.46211717
// run: tanh_f32(0.1) == 0.099667996
// run: tanh_f32(-0.3) == -0.29131263
// run: tanh_f32(2.0) == 0.9640276
// run: tanh_f32(3.1415927) == 0.9962721
// run: tanh_f32(1.5707964) == 0.91715235
// run: tanh_f32(1e+01) == 1.0
// run: tanh_f32(100.5) == 1.0
// run: tanh_f32(1e+06) == 1.0
// run: tanh_f32(1e+20) == 1.0
// run: tanh_f32(-1e-10) == -1e-10
// run: tanh_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: tanh_f32(0.99999994) == 0.7615941
// run: tanh_f32(bitcast<f32>(0x7fc00000u)) == nan

fn tanh_vec3(x: vec3<f32>) -> vec3<f32> { return tanh(x); }
// run: tanh_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.24491866, 0.5545997, 0.71629786)

fn asinh_f32(x: f32) -> f32 { return asinh(x); }
// run: asinh_f32(0.0) == 0.0
// run: asinh_f32(-0.0) == -0.0
// run: asinh_f32(1.0) == 0.8813736
// run: asinh_f32(-1.0) == -0.8813736
// run: asinh_f32(0.5) == 0.4812118
// run: asinh_f32(0.1) == 0.09983408
// run: asinh_f32(-0.3) == -0.29567307
// run: asinh_f32(2.0) == 1.4436355
// run: asinh_f32(3.1415927) == 1.8622957
// run: asinh_f32(1.5707964) == 1.2334031
// run: asinh_f32(1e+01) == 2.998223
// run: asinh_f32(100.5) == 5.3033295
// run: asinh_f32(1e+06) == 14.508657
// run: asinh_f32(1e+20) == 46.74485
// run: asinh_f32(-1e-10) == -1e-10
// run: asinh_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: asinh_f32(0.99999994) == 0.8813735
// run: asinh_f32(bitcast<f32>(0x7fc00000u)) == nan

fn asinh_vec3(x: vec3<f32>) -> vec3<f32> { return asinh(x); }
// run: asinh_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.24746646, 0.5901437, 0.8088669)

fn acosh_f32(x: f32) -> f32 { return acosh(x); }
// run: acosh_f32(0.0) == nan
// run: acosh_f32(-0.0) == nan
// run: acosh_f32(1.0) == 0.0
// run: acosh_f32(-1.0) == nan
// run: acosh_f32(0.5) == nan
// run: acosh_f32(0.1) == nan
// run: acosh_f32(-0.3) == nan
// run: acosh_f32(2.0) == 1.316958
// run: acosh_f32(3.1415927) == 1.8115263
// run: acosh_f32(1.5707964) == 1.0232276
// run: acosh_f32(1e+01) == 2.993223
// run: acosh_f32(100.5) == 5.3032804
// run: acosh_f32(1e+06) == 14.508657
// run: acosh_f32(1e+20) == 46.74485
// run: acosh_f32(-1e-10) == nan
// run: acosh_f32(bitcast<f32>(0x00000001u)) == nan
// run: acosh_f32(0.99999994) == nan
// run: acosh_f32(bitcast<f32>(0x7fc00000u)) == nan

fn acosh_vec3(x: vec3<f32>) -> vec3<f32> { return acosh(x); }
// run: acosh_vec3(vec3<f32>(1.25, 7.7, 2.3)) == vec3<f32>(0.6931472, 2.730124, 1.4750447)

fn atanh_f32(x: f32) -> f32 { return atanh(x); }
// run: atanh_f32(0.0) == 0.0
// run: atanh_f32(-0.0) == -0.0
// run: atanh_f32(1.0) == bitcast<f32>(0x7f800000u)
// run: atanh_f32(-1.0) == bitcast<f32>(0xff800000u)
// run: atanh_f32(0.5) == 0.54930615
// run: atanh_f32(0.1) == 0.10033535
// run: atanh_f32(-0.3) == -0.30951962
// run: atanh_f32(2.0) == nan
// run: atanh_f32(3.1415927) == nan
// run: atanh_f32(1.5707964) == nan
// run: atanh_f32(1e+01) == nan
// run: atanh_f32(100.5) == nan
// run: atanh_f32(1e+06) == nan
// run: atanh_f32(1e+20) == nan
// run: atanh_f32(-1e-10) == -1e-10
// run: atanh_f32(bitcast<f32>(0x00000001u)) == bitcast<f32>(0x00000001u)
// run: atanh_f32(0.99999994) == 8.66434
// run: atanh_f32(bitcast<f32>(0x7fc00000u)) == nan

fn atanh_vec3(x: vec3<f32>) -> vec3<f32> { return atanh(x); }
// run: atanh_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(0.25541282, 0.73316854, 1.4722193)

fn exp_f32(x: f32) -> f32 { return exp(x); }
// run: exp_f32(0.0) == 1.0
// run: exp_f32(-0.0) == 1.0
// run: exp_f32(1.0) == 2.7182817
// run: exp_f32(-1.0) == 0.36787945
// run: exp_f32(0.5) == 1.6487212
// run: exp_f32(0.1) == 1.105171
// run: exp_f32(-0.3) == 0.7408182
// run: exp_f32(2.0) == 7.389056
// run: exp_f32(3.1415927) == 23.140696
// run: exp_f32(1.5707964) == 4.8104777
// run: exp_f32(1e+01) == 22026.465
// run: exp_f32(100.5) == bitcast<f32>(0x7f800000u)
// run: exp_f32(1e+06) == bitcast<f32>(0x7f800000u)
// run: exp_f32(1e+20) == bitcast<f32>(0x7f800000u)
// run: exp_f32(-1e-10) == 1.0
// run: exp_f32(bitcast<f32>(0x00000001u)) == 1.0
// run: exp_f32(0.99999994) == 2.7182817
// run: exp_f32(bitcast<f32>(0x7fc00000u)) == nan

fn exp_vec3(x: vec3<f32>) -> vec3<f32> { return exp(x); }
// run: exp_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(1.2840254, 1.868246, 2.459603)

fn exp2_f32(x: f32) -> f32 { return exp2(x); }
// run: exp2_f32(0.0) == 1.0
// run: exp2_f32(-0.0) == 1.0
// run: exp2_f32(1.0) == 2.0
// run: exp2_f32(-1.0) == 0.5
// run: exp2_f32(0.5) == 1.4142135
// run: exp2_f32(0.1) == 1.0717734
// run: exp2_f32(-0.3) == 0.8122524
// run: exp2_f32(2.0) == 4.0
// run: exp2_f32(3.1415927) == 8.824979
// run: exp2_f32(1.5707964) == 2.9706864
// run: exp2_f32(1e+01) == 1024.0
// run: exp2_f32(100.5) == 1.7927286e+30
// run: exp2_f32(1e+06) == bitcast<f32>(0x7f800000u)
// run: exp2_f32(1e+20) == bitcast<f32>(0x7f800000u)
// run: exp2_f32(-1e-10) == 1.0
// run: exp2_f32(bitcast<f32>(0x00000001u)) == 1.0
// run: exp2_f32(0.99999994) == 1.9999999
// run: exp2_f32(bitcast<f32>(0x7fc00000u)) == nan

fn exp2_vec3(x: vec3<f32>) -> vec3<f32> { return exp2(x); }
// run: exp2_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(1.1892071, 1.5422108, 1.866066)

fn log_f32(x: f32) -> f32 { return log(x); }
// run: log_f32(0.0) == bitcast<f32>(0xff800000u)
// run: log_f32(-0.0) == bitcast<f32>(0xff800000u)
// run: log_f32(1.0) == 0.0
// run: log_f32(-1.0) == nan
// run: log_f32(0.5) == -0.6931472
// run: log_f32(0.1) == -2.3025851
// run: log_f32(-0.3) == nan
// run: log_f32(2.0) == 0.6931472
// run: log_f32(3.1415927) == 1.14473
// run: log_f32(1.5707964) == 0.45158273
// run: log_f32(1e+01) == 2.3025851
// run: log_f32(100.5) == 4.6101575
// run: log_f32(1e+06) == 13.815511
// run: log_f32(1e+20) == 46.0517
// run: log_f32(-1e-10) == nan
// run: log_f32(bitcast<f32>(0x00000001u)) == -103.27893
// run: log_f32(0.99999994) == -5.9604645e-08
// run: log_f32(bitcast<f32>(0x7fc00000u)) == nan

fn log_vec3(x: vec3<f32>) -> vec3<f32> { return log(x); }
// run: log_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(-1.3862944, -0.47000363, -0.105360545)

fn log2_f32(x: f32) -> f32 { return log2(x); }
// run: log2_f32(0.0) == bitcast<f32>(0xff800000u)
// run: log2_f32(-0.0) == bitcast<f32>(0xff800000u)
// run: log2_f32(1.0) == 0.0
// run: log2_f32(-1.0) == nan
// run: log2_f32(0.5) == -1.0
// run: log2_f32(0.1) == -3.321928
// run: log2_f32(-0.3) == nan
// run: log2_f32(2.0) == 1.0
// run: log2_f32(3.1415927) == 1.6514962
// run: log2_f32(1.5707964) == 0.6514962
// run: log2_f32(1e+01) == 3.321928
// run: log2_f32(100.5) == 6.6510515
// run: log2_f32(1e+06) == 19.931568
// run: log2_f32(1e+20) == 66.43856
// run: log2_f32(-1e-10) == nan
// run: log2_f32(bitcast<f32>(0x00000001u)) == -149.0
// run: log2_f32(0.99999994) == -8.599133e-08
// run: log2_f32(bitcast<f32>(0x7fc00000u)) == nan

fn log2_vec3(x: vec3<f32>) -> vec3<f32> { return log2(x); }
// run: log2_vec3(vec3<f32>(0.25, 0.625, 0.9)) == vec3<f32>(-2.0, -0.6780719, -0.15200312)
// run: sin_f32(bitcast<f32>(0x7f800000u)) == nan
// run: exp2_vec3(vec3<f32>(-149.0, -126.0, 127.0)) == vec3<f32>(bitcast<f32>(0x00000001u), bitcast<f32>(0x00800000u), 1.7014118e+38)
// run: log2_vec3(vec3<f32>(bitcast<f32>(0x00000001u), 0.25, 1.7014118e+38)) == vec3<f32>(-149.0, -2.0, 127.0)

fn atan2_f32(y: f32, x: f32) -> f32 { return atan2(y, x); }
// run: atan2_f32(0.0, 0.0) == 0.0
// run: atan2_f32(0.0, -0.0) == 3.1415927
// run: atan2_f32(0.0, 1.0) == 0.0
// run: atan2_f32(0.0, -1.0) == 3.1415927
// run: atan2_f32(0.0, -0.7) == 3.1415927
// run: atan2_f32(0.0, bitcast<f32>(0xff800000u)) == 3.1415927
// run: atan2_f32(-0.0, 0.0) == -0.0
// run: atan2_f32(-0.0, -0.0) == -3.1415927
// run: atan2_f32(-0.0, 1.0) == -0.0
// run: atan2_f32(-0.0, -1.0) == -3.1415927
// run: atan2_f32(-0.0, -0.7) == -3.1415927
// run: atan2_f32(-0.0, bitcast<f32>(0xff800000u)) == -3.1415927
// run: atan2_f32(1.0, 0.0) == 1.5707964
// run: atan2_f32(1.0, -0.0) == 1.5707964
// run: atan2_f32(1.0, 1.0) == 0.7853982
// run: atan2_f32(1.0, -1.0) == 2.3561945
// run: atan2_f32(1.0, -0.7) == 2.1815224
// run: atan2_f32(1.0, bitcast<f32>(0xff800000u)) == 3.1415927
// run: atan2_f32(-1.0, 0.0) == -1.5707964
// run: atan2_f32(-1.0, -0.0) == -1.5707964
// run: atan2_f32(-1.0, 1.0) == -0.7853982
// run: atan2_f32(-1.0, -1.0) == -2.3561945
// run: atan2_f32(-1.0, -0.7) == -2.1815224
// run: atan2_f32(-1.0, bitcast<f32>(0xff800000u)) == -3.1415927
// run: atan2_f32(0.3, 0.0) == 1.5707964
// run: atan2_f32(0.3, -0.0) == 1.5707964
// run: atan2_f32(0.3, 1.0) == 0.29145682
// run: atan2_f32(0.3, -1.0) == 2.8501358
// run: atan2_f32(0.3, -0.7) == 2.7367008
// run: atan2_f32(0.3, bitcast<f32>(0xff800000u)) == 3.1415927
// run: atan2_f32(bitcast<f32>(0x7f800000u), 0.0) == 1.5707964
// run: atan2_f32(bitcast<f32>(0x7f800000u), -0.0) == 1.5707964
// run: atan2_f32(bitcast<f32>(0x7f800000u), 1.0) == 1.5707964
// run: atan2_f32(bitcast<f32>(0x7f800000u), -1.0) == 1.5707964
// run: atan2_f32(bitcast<f32>(0x7f800000u), -0.7) == 1.5707964
// run: atan2_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0xff800000u)) == 2.3561945

fn atan2_vec2(y: vec2<f32>, x: vec2<f32>) -> vec2<f32> { return atan2(y, x); }
// run: atan2_vec2(vec2<f32>(1.0, -2.0), vec2<f32>(2.0, 3.0)) == vec2<f32>(0.4636476, -0.5880026)

fn pow_f32(x: f32, y: f32) -> f32 { return pow(x, y); }
// run: pow_f32(2.0, 0.5) == 1.4142135
// run: pow_f32(2.0, 1e+01) == 1024.0
// run: pow_f32(0.1, 3.0) == 0.001
// run: pow_f32(1.1, 1e+02) == 13780.643
// run: pow_f32(-2.0, 3.0) == -8.0
// run: pow_f32(-2.0, 2.0) == 4.0
// run: pow_f32(0.0, 0.0) == 1.0
// run: pow_f32(0.0, 2.0) == 0.0
// run: pow_f32(5.0, 0.0) == 1.0
// run: pow_f32(1e+01, -3.0) == 0.001
// run: pow_f32(1e+01, 38.0) == 1e+38
// run: pow_f32(2.0, -149.0) == bitcast<f32>(0x00000001u)
// run: pow_f32(0.7, 2.2) == 0.45626342
// run: pow_f32(1.0, 1e+30) == 1.0
// run: pow_f32(9.0, 0.5) == 3.0
// run: pow_f32(-2.0, 0.5) == nan
// run: pow_f32(1e+01, 39.0) == bitcast<f32>(0x7f800000u)
// run: pow_f32(0.0, -1.0) == bitcast<f32>(0x7f800000u)

fn pow_vec2(x: vec2<f32>, y: vec2<f32>) -> vec2<f32> { return pow(x, y); }
// run: pow_vec2(vec2<f32>(3.0, 2.0), vec2<f32>(2.0, -1.0)) == vec2<f32>(9.0, 0.5)
