// Comparisons of every ordered type; NaN is unequal to everything, itself too, and zeros of both signs are equal.

fn eq_i32(x: i32, y: i32) -> bool { return x == y; }
// run: eq_i32(0i, 0i) == true
// run: eq_i32(0i, -2i) == false
// run: eq_i32(0i, 2147483647i) == false
// run: eq_i32(0i, -305419896i) == false
// run: eq_i32(1i, 1i) == true
// run: eq_i32(1i, 7i) == false
// run: eq_i32(1i, -2147483648i) == false
// run: eq_i32(1i, 1431655765i) == false
// run: eq_i32(-1i, -1i) == true
// run: eq_i32(-1i, -7i) == false
// run: eq_i32(-1i, -2147483647i) == false
// run: eq_i32(-1i, 65536i) == false
// run: eq_i32(2i, 2i) == true
// run: eq_i32(2i, 100i) == false
// run: eq_i32(2i, 305419896i) == false
// run: eq_i32(-2i, 0i) == false
// run: eq_i32(-2i, -2i) == true
// run: eq_i32(-2i, 2147483647i) == false
// run: eq_i32(-2i, -305419896i) == false
// run: eq_i32(7i, 1i) == false
// run: eq_i32(7i, 7i) == true
// run: eq_i32(7i, -2147483648i) == false
// run: eq_i32(7i, 1431655765i) == false
// run: eq_i32(-7i, -1i) == false
// run: eq_i32(-7i, -7i) == true
// run: eq_i32(-7i, -2147483647i) == false
// run: eq_i32(-7i, 65536i) == false
// run: eq_i32(100i, 2i) == false
// run: eq_i32(100i, 100i) == true
// run: eq_i32(100i, 305419896i) == false
// run: eq_i32(2147483647i, 0i) == false
// run: eq_i32(2147483647i, -2i) == false
// run: eq_i32(2147483647i, 2147483647i) == true
// run: eq_i32(2147483647i, -305419896i) == false
// run: eq_i32(-2147483648i, 1i) == false
// run: eq_i32(-2147483648i, 7i) == false
// run: eq_i32(-2147483648i, -2147483648i) == true
// run: eq_i32(-2147483648i, 1431655765i) == false
// run: eq_i32(-2147483647i, -1i) == false
// run: eq_i32(-2147483647i, -7i) == false
// run: eq_i32(-2147483647i, -2147483647i) == true
// run: eq_i32(-2147483647i, 65536i) == false
// run: eq_i32(305419896i, 2i) == false
// run: eq_i32(305419896i, 100i) == false
// run: eq_i32(305419896i, 305419896i) == true
// run: eq_i32(-305419896i, 0i) == false
// run: eq_i32(-305419896i, -2i) == false
// run: eq_i32(-305419896i, 2147483647i) == false
// run: eq_i32(-305419896i, -305419896i) == true
// run: eq_i32(1431655765i, 1i) == false
// run: eq_i32(1431655765i, 7i) == false
// run: eq_i32(1431655765i, -2147483648i) == false
// run: eq_i32(1431655765i, 1431655765i) == true
// run: eq_i32(65536i, -1i) == false
// run: eq_i32(65536i, -7i) == false
// run: eq_i32(65536i, -2147483647i) == false
// run: eq_i32(65536i, 65536i) == true

fn eq_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<bool> { return x == y; }
// run: eq_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, -1i, 2i)) == vec3<bool>(false, false, false)
// run: eq_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(2i, -2i, 7i)) == vec3<bool>(true, true, true)
// run: eq_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(7i, -7i, 100i)) == vec3<bool>(false, false, false)

fn not_eq_i32(x: i32, y: i32) -> bool { return !(x == y); }
// run: not_eq_i32(-305419896i, -305419896i) == false
// run: not_eq_i32(-305419896i, 1431655765i) == true
// run: not_eq_i32(-305419896i, 65536i) == true
// run: not_eq_i32(1431655765i, -305419896i) == true
// run: not_eq_i32(1431655765i, 1431655765i) == false
// run: not_eq_i32(1431655765i, 65536i) == true
// run: not_eq_i32(65536i, -305419896i) == true
// run: not_eq_i32(65536i, 1431655765i) == true
// run: not_eq_i32(65536i, 65536i) == false

fn ne_i32(x: i32, y: i32) -> bool { return x != y; }
// run: ne_i32(0i, 0i) == false
// run: ne_i32(0i, -2i) == true
// run: ne_i32(0i, 2147483647i) == true
// run: ne_i32(0i, -305419896i) == true
// run: ne_i32(1i, 1i) == false
// run: ne_i32(1i, 7i) == true
// run: ne_i32(1i, -2147483648i) == true
// run: ne_i32(1i, 1431655765i) == true
// run: ne_i32(-1i, -1i) == false
// run: ne_i32(-1i, -7i) == true
// run: ne_i32(-1i, -2147483647i) == true
// run: ne_i32(-1i, 65536i) == true
// run: ne_i32(2i, 2i) == false
// run: ne_i32(2i, 100i) == true
// run: ne_i32(2i, 305419896i) == true
// run: ne_i32(-2i, 0i) == true
// run: ne_i32(-2i, -2i) == false
// run: ne_i32(-2i, 2147483647i) == true
// run: ne_i32(-2i, -305419896i) == true
// run: ne_i32(7i, 1i) == true
// run: ne_i32(7i, 7i) == false
// run: ne_i32(7i, -2147483648i) == true
// run: ne_i32(7i, 1431655765i) == true
// run: ne_i32(-7i, -1i) == true
// run: ne_i32(-7i, -7i) == false
// run: ne_i32(-7i, -2147483647i) == true
// run: ne_i32(-7i, 65536i) == true
// run: ne_i32(100i, 2i) == true
// run: ne_i32(100i, 100i) == false
// run: ne_i32(100i, 305419896i) == true
// run: ne_i32(2147483647i, 0i) == true
// run: ne_i32(2147483647i, -2i) == true
// run: ne_i32(2147483647i, 2147483647i) == false
// run: ne_i32(2147483647i, -305419896i) == true
// run: ne_i32(-2147483648i, 1i) == true
// run: ne_i32(-2147483648i, 7i) == true
// run: ne_i32(-2147483648i, -2147483648i) == false
// run: ne_i32(-2147483648i, 1431655765i) == true
// run: ne_i32(-2147483647i, -1i) == true
// run: ne_i32(-2147483647i, -7i) == true
// run: ne_i32(-2147483647i, -2147483647i) == false
// run: ne_i32(-2147483647i, 65536i) == true
// run: ne_i32(305419896i, 2i) == true
// run: ne_i32(305419896i, 100i) == true
// run: ne_i32(305419896i, 305419896i) == false
// run: ne_i32(-305419896i, 0i) == true
// run: ne_i32(-305419896i, -2i) == true
// run: ne_i32(-305419896i, 2147483647i) == true
// run: ne_i32(-305419896i, -305419896i) == false
// run: ne_i32(1431655765i, 1i) == true
// run: ne_i32(1431655765i, 7i) == true
// run: ne_i32(1431655765i, -2147483648i) == true
// run: ne_i32(1431655765i, 1431655765i) == false
// run: ne_i32(65536i, -1i) == true
// run: ne_i32(65536i, -7i) == true
// run: ne_i32(65536i, -2147483647i) == true
// run: ne_i32(65536i, 65536i) == false

fn ne_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<bool> { return x != y; }
// run: ne_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, -1i, 2i)) == vec3<bool>(true, true, true)
// run: ne_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(2i, -2i, 7i)) == vec3<bool>(false, false, false)
// run: ne_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(7i, -7i, 100i)) == vec3<bool>(true, true, true)

fn not_ne_i32(x: i32, y: i32) -> bool { return !(x != y); }
// run: not_ne_i32(-305419896i, -305419896i) == true
// run: not_ne_i32(-305419896i, 1431655765i) == false
// run: not_ne_i32(-305419896i, 65536i) == false
// run: not_ne_i32(1431655765i, -305419896i) == false
// run: not_ne_i32(1431655765i, 1431655765i) == true
// run: not_ne_i32(1431655765i, 65536i) == false
// run: not_ne_i32(65536i, -305419896i) == false
// run: not_ne_i32(65536i, 1431655765i) == false
// run: not_ne_i32(65536i, 65536i) == true

fn lt_i32(x: i32, y: i32) -> bool { return x < y; }
// run: lt_i32(0i, 0i) == false
// run: lt_i32(0i, -2i) == false
// run: lt_i32(0i, 2147483647i) == true
// run: lt_i32(0i, -305419896i) == false
// run: lt_i32(1i, 1i) == false
// run: lt_i32(1i, 7i) == true
// run: lt_i32(1i, -2147483648i) == false
// run: lt_i32(1i, 1431655765i) == true
// run: lt_i32(-1i, -1i) == false
// run: lt_i32(-1i, -7i) == false
// run: lt_i32(-1i, -2147483647i) == false
// run: lt_i32(-1i, 65536i) == true
// run: lt_i32(2i, 2i) == false
// run: lt_i32(2i, 100i) == true
// run: lt_i32(2i, 305419896i) == true
// run: lt_i32(-2i, 0i) == true
// run: lt_i32(-2i, -2i) == false
// run: lt_i32(-2i, 2147483647i) == true
// run: lt_i32(-2i, -305419896i) == false
// run: lt_i32(7i, 1i) == false
// run: lt_i32(7i, 7i) == false
// run: lt_i32(7i, -2147483648i) == false
// run: lt_i32(7i, 1431655765i) == true
// run: lt_i32(-7i, -1i) == true
// run: lt_i32(-7i, -7i) == false
// run: lt_i32(-7i, -2147483647i) == false
// run: lt_i32(-7i, 65536i) == true
// run: lt_i32(100i, 2i) == false
// run: lt_i32(100i, 100i) == false
// run: lt_i32(100i, 305419896i) == true
// run: lt_i32(2147483647i, 0i) == false
// run: lt_i32(2147483647i, -2i) == false
// run: lt_i32(2147483647i, 2147483647i) == false
// run: lt_i32(2147483647i, -305419896i) == false
// run: lt_i32(-2147483648i, 1i) == true
// run: lt_i32(-2147483648i, 7i) == true
// run: lt_i32(-2147483648i, -2147483648i) == false
// run: lt_i32(-2147483648i, 1431655765i) == true
// run: lt_i32(-2147483647i, -1i) == true
// run: lt_i32(-2147483647i, -7i) == true
// run: lt_i32(-2147483647i, -2147483647i) == false
// run: lt_i32(-2147483647i, 65536i) == true
// run: lt_i32(305419896i, 2i) == false
// run: lt_i32(305419896i, 100i) == false
// run: lt_i32(305419896i, 305419896i) == false
// run: lt_i32(-305419896i, 0i) == true
// run: lt_i32(-305419896i, -2i) == true
// run: lt_i32(-305419896i, 2147483647i) == true
// run: lt_i32(-305419896i, -305419896i) == false
// run: lt_i32(1431655765i, 1i) == false
// run: lt_i32(1431655765i, 7i) == false
// run: lt_i32(1431655765i, -2147483648i) == false
// run: lt_i32(1431655765i, 1431655765i) == false
// run: lt_i32(65536i, -1i) == false
// run: lt_i32(65536i, -7i) == false
// run: lt_i32(65536i, -2147483647i) == false
// run: lt_i32(65536i, 65536i) == false

fn lt_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<bool> { return x < y; }
// run: lt_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, -1i, 2i)) == vec3<bool>(true, false, true)
// run: lt_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(2i, -2i, 7i)) == vec3<bool>(false, false, false)
// run: lt_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(7i, -7i, 100i)) == vec3<bool>(true, false, false)

fn not_lt_i32(x: i32, y: i32) -> bool { return !(x < y); }
// run: not_lt_i32(-305419896i, -305419896i) == true
// run: not_lt_i32(-305419896i, 1431655765i) == false
// run: not_lt_i32(-305419896i, 65536i) == false
// run: not_lt_i32(1431655765i, -305419896i) == true
// run: not_lt_i32(1431655765i, 1431655765i) == true
// run: not_lt_i32(1431655765i, 65536i) == true
// run: not_lt_i32(65536i, -305419896i) == true
// run: not_lt_i32(65536i, 1431655765i) == false
// run: not_lt_i32(65536i, 65536i) == true

fn le_i32(x: i32, y: i32) -> bool { return x <= y; }
// run: le_i32(0i, 0i) == true
// run: le_i32(0i, -2i) == false
// run: le_i32(0i, 2147483647i) == true
// run: le_i32(0i, -305419896i) == false
// run: le_i32(1i, 1i) == true
// run: le_i32(1i, 7i) == true
// run: le_i32(1i, -2147483648i) == false
// run: le_i32(1i, 1431655765i) == true
// run: le_i32(-1i, -1i) == true
// run: le_i32(-1i, -7i) == false
// run: le_i32(-1i, -2147483647i) == false
// run: le_i32(-1i, 65536i) == true
// run: le_i32(2i, 2i) == true
// run: le_i32(2i, 100i) == true
// run: le_i32(2i, 305419896i) == true
// run: le_i32(-2i, 0i) == true
// run: le_i32(-2i, -2i) == true
// run: le_i32(-2i, 2147483647i) == true
// run: le_i32(-2i, -305419896i) == false
// run: le_i32(7i, 1i) == false
// run: le_i32(7i, 7i) == true
// run: le_i32(7i, -2147483648i) == false
// run: le_i32(7i, 1431655765i) == true
// run: le_i32(-7i, -1i) == true
// run: le_i32(-7i, -7i) == true
// run: le_i32(-7i, -2147483647i) == false
// run: le_i32(-7i, 65536i) == true
// run: le_i32(100i, 2i) == false
// run: le_i32(100i, 100i) == true
// run: le_i32(100i, 305419896i) == true
// run: le_i32(2147483647i, 0i) == false
// run: le_i32(2147483647i, -2i) == false
// run: le_i32(2147483647i, 2147483647i) == true
// run: le_i32(2147483647i, -305419896i) == false
// run: le_i32(-2147483648i, 1i) == true
// run: le_i32(-2147483648i, 7i) == true
// run: le_i32(-2147483648i, -2147483648i) == true
// run: le_i32(-2147483648i, 1431655765i) == true
// run: le_i32(-2147483647i, -1i) == true
// run: le_i32(-2147483647i, -7i) == true
// run: le_i32(-2147483647i, -2147483647i) == true
// run: le_i32(-2147483647i, 65536i) == true
// run: le_i32(305419896i, 2i) == false
// run: le_i32(305419896i, 100i) == false
// run: le_i32(305419896i, 305419896i) == true
// run: le_i32(-305419896i, 0i) == true
// run: le_i32(-305419896i, -2i) == true
// run: le_i32(-305419896i, 2147483647i) == true
// run: le_i32(-305419896i, -305419896i) == true
// run: le_i32(1431655765i, 1i) == false
// run: le_i32(1431655765i, 7i) == false
// run: le_i32(1431655765i, -2147483648i) == false
// run: le_i32(1431655765i, 1431655765i) == true
// run: le_i32(65536i, -1i) == false
// run: le_i32(65536i, -7i) == false
// run: le_i32(65536i, -2147483647i) == false
// run: le_i32(65536i, 65536i) == true

fn le_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<bool> { return x <= y; }
// run: le_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, -1i, 2i)) == vec3<bool>(true, false, true)
// run: le_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(2i, -2i, 7i)) == vec3<bool>(true, true, true)
// run: le_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(7i, -7i, 100i)) == vec3<bool>(true, false, false)

fn not_le_i32(x: i32, y: i32) -> bool { return !(x <= y); }
// run: not_le_i32(-305419896i, -305419896i) == false
// run: not_le_i32(-305419896i, 1431655765i) == false
// run: not_le_i32(-305419896i, 65536i) == false
// run: not_le_i32(1431655765i, -305419896i) == true
// run: not_le_i32(1431655765i, 1431655765i) == false
// run: not_le_i32(1431655765i, 65536i) == true
// run: not_le_i32(65536i, -305419896i) == true
// run: not_le_i32(65536i, 1431655765i) == false
// run: not_le_i32(65536i, 65536i) == false

fn gt_i32(x: i32, y: i32) -> bool { return x > y; }
// run: gt_i32(0i, 0i) == false
// run: gt_i32(0i, -2i) == true
// run: gt_i32(0i, 2147483647i) == false
// run: gt_i32(0i, -305419896i) == true
// run: gt_i32(1i, 1i) == false
// run: gt_i32(1i, 7i) == false
// run: gt_i32(1i, -2147483648i) == true
// run: gt_i32(1i, 1431655765i) == false
// run: gt_i32(-1i, -1i) == false
// run: gt_i32(-1i, -7i) == true
// run: gt_i32(-1i, -2147483647i) == true
// run: gt_i32(-1i, 65536i) == false
// run: gt_i32(2i, 2i) == false
// run: gt_i32(2i, 100i) == false
// run: gt_i32(2i, 305419896i) == false
// run: gt_i32(-2i, 0i) == false
// run: gt_i32(-2i, -2i) == false
// run: gt_i32(-2i, 2147483647i) == false
// run: gt_i32(-2i, -305419896i) == true
// run: gt_i32(7i, 1i) == true
// run: gt_i32(7i, 7i) == false
// run: gt_i32(7i, -2147483648i) == true
// run: gt_i32(7i, 1431655765i) == false
// run: gt_i32(-7i, -1i) == false
// run: gt_i32(-7i, -7i) == false
// run: gt_i32(-7i, -2147483647i) == true
// run: gt_i32(-7i, 65536i) == false
// run: gt_i32(100i, 2i) == true
// run: gt_i32(100i, 100i) == false
// run: gt_i32(100i, 305419896i) == false
// run: gt_i32(2147483647i, 0i) == true
// run: gt_i32(2147483647i, -2i) == true
// run: gt_i32(2147483647i, 2147483647i) == false
// run: gt_i32(2147483647i, -305419896i) == true
// run: gt_i32(-2147483648i, 1i) == false
// run: gt_i32(-2147483648i, 7i) == false
// run: gt_i32(-2147483648i, -2147483648i) == false
// run: gt_i32(-2147483648i, 1431655765i) == false
// run: gt_i32(-2147483647i, -1i) == false
// run: gt_i32(-2147483647i, -7i) == false
// run: gt_i32(-2147483647i, -2147483647i) == false
// run: gt_i32(-2147483647i, 65536i) == false
// run: gt_i32(305419896i, 2i) == true
// run: gt_i32(305419896i, 100i) == true
// run: gt_i32(305419896i, 305419896i) == false
// run: gt_i32(-305419896i, 0i) == false
// run: gt_i32(-305419896i, -2i) == false
// run: gt_i32(-305419896i, 2147483647i) == false
// run: gt_i32(-305419896i, -305419896i) == false
// run: gt_i32(1431655765i, 1i) == true
// run: gt_i32(1431655765i, 7i) == true
// run: gt_i32(1431655765i, -2147483648i) == true
// run: gt_i32(1431655765i, 1431655765i) == false
// run: gt_i32(65536i, -1i) == true
// run: gt_i32(65536i, -7i) == true
// run: gt_i32(65536i, -2147483647i) == true
// run: gt_i32(65536i, 65536i) == false

fn gt_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<bool> { return x > y; }
// run: gt_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, -1i, 2i)) == vec3<bool>(false, true, false)
// run: gt_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(2i, -2i, 7i)) == vec3<bool>(false, false, false)
// run: gt_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(7i, -7i, 100i)) == vec3<bool>(false, true, true)

fn not_gt_i32(x: i32, y: i32) -> bool { return !(x > y); }
// run: not_gt_i32(-305419896i, -305419896i) == true
// run: not_gt_i32(-305419896i, 1431655765i) == true
// run: not_gt_i32(-305419896i, 65536i) == true
// run: not_gt_i32(1431655765i, -305419896i) == false
// run: not_gt_i32(1431655765i, 1431655765i) == true
// run: not_gt_i32(1431655765i, 65536i) == false
// run: not_gt_i32(65536i, -305419896i) == false
// run: not_gt_i32(65536i, 1431655765i) == true
// run: not_gt_i32(65536i, 65536i) == true

fn ge_i32(x: i32, y: i32) -> bool { return x >= y; }
// run: ge_i32(0i, 0i) == true
// run: ge_i32(0i, -2i) == true
// run: ge_i32(0i, 2147483647i) == false
// run: ge_i32(0i, -305419896i) == true
// run: ge_i32(1i, 1i) == true
// run: ge_i32(1i, 7i) == false
// run: ge_i32(1i, -2147483648i) == true
// run: ge_i32(1i, 1431655765i) == false
// run: ge_i32(-1i, -1i) == true
// run: ge_i32(-1i, -7i) == true
// run: ge_i32(-1i, -2147483647i) == true
// run: ge_i32(-1i, 65536i) == false
// run: ge_i32(2i, 2i) == true
// run: ge_i32(2i, 100i) == false
// run: ge_i32(2i, 305419896i) == false
// run: ge_i32(-2i, 0i) == false
// run: ge_i32(-2i, -2i) == true
// run: ge_i32(-2i, 2147483647i) == false
// run: ge_i32(-2i, -305419896i) == true
// run: ge_i32(7i, 1i) == true
// run: ge_i32(7i, 7i) == true
// run: ge_i32(7i, -2147483648i) == true
// run: ge_i32(7i, 1431655765i) == false
// run: ge_i32(-7i, -1i) == false
// run: ge_i32(-7i, -7i) == true
// run: ge_i32(-7i, -2147483647i) == true
// run: ge_i32(-7i, 65536i) == false
// run: ge_i32(100i, 2i) == true
// run: ge_i32(100i, 100i) == true
// run: ge_i32(100i, 305419896i) == false
// run: ge_i32(2147483647i, 0i) == true
// run: ge_i32(2147483647i, -2i) == true
// run: ge_i32(2147483647i, 2147483647i) == true
// run: ge_i32(2147483647i, -305419896i) == true
// run: ge_i32(-2147483648i, 1i) == false
// run: ge_i32(-2147483648i, 7i) == false
// run: ge_i32(-2147483648i, -2147483648i) == true
// run: ge_i32(-2147483648i, 1431655765i) == false
// run: ge_i32(-2147483647i, -1i) == false
// run: ge_i32(-2147483647i, -7i) == false
// run: ge_i32(-2147483647i, -2147483647i) == true
// run: ge_i32(-2147483647i, 65536i) == false
// run: ge_i32(305419896i, 2i) == true
// run: ge_i32(305419896i, 100i) == true
// run: ge_i32(305419896i, 305419896i) == true
// run: ge_i32(-305419896i, 0i) == false
// run: ge_i32(-305419896i, -2i) == false
// run: ge_i32(-305419896i, 2147483647i) == false
// run: ge_i32(-305419896i, -305419896i) == true
// run: ge_i32(1431655765i, 1i) == true
// run: ge_i32(1431655765i, 7i) == true
// run: ge_i32(1431655765i, -2147483648i) == true
// run: ge_i32(1431655765i, 1431655765i) == true
// run: ge_i32(65536i, -1i) == true
// run: ge_i32(65536i, -7i) == true
// run: ge_i32(65536i, -2147483647i) == true
// run: ge_i32(65536i, 65536i) == true

fn ge_i32_vec3(x: vec3<i32>, y: vec3<i32>) -> vec3<bool> { return x >= y; }
// run: ge_i32_vec3(vec3<i32>(0i, 1i, -1i), vec3<i32>(1i, -1i, 2i)) == vec3<bool>(false, true, false)
// run: ge_i32_vec3(vec3<i32>(2i, -2i, 7i), vec3<i32>(2i, -2i, 7i)) == vec3<bool>(true, true, true)
// run: ge_i32_vec3(vec3<i32>(-7i, 100i, 2147483647i), vec3<i32>(7i, -7i, 100i)) == vec3<bool>(false, true, true)

fn not_ge_i32(x: i32, y: i32) -> bool { return !(x >= y); }
// run: not_ge_i32(-305419896i, -305419896i) == false
// run: not_ge_i32(-305419896i, 1431655765i) == true
// run: not_ge_i32(-305419896i, 65536i) == true
// run: not_ge_i32(1431655765i, -305419896i) == false
// run: not_ge_i32(1431655765i, 1431655765i) == false
// run: not_ge_i32(1431655765i, 65536i) == false
// run: not_ge_i32(65536i, -305419896i) == false
// run: not_ge_i32(65536i, 1431655765i) == true
// run: not_ge_i32(65536i, 65536i) == false

fn eq_u32(x: u32, y: u32) -> bool { return x == y; }
// run: eq_u32(0u, 0u) == true
// run: eq_u32(0u, 100u) == false
// run: eq_u32(0u, 0xffffffffu) == false
// run: eq_u32(0u, 0x00010000u) == false
// run: eq_u32(1u, 1u) == true
// run: eq_u32(1u, 0x7fffffffu) == false
// run: eq_u32(1u, 0xfffffffeu) == false
// run: eq_u32(1u, 65535u) == false
// run: eq_u32(2u, 2u) == true
// run: eq_u32(2u, 0x80000000u) == false
// run: eq_u32(2u, 0x12345678u) == false
// run: eq_u32(7u, 7u) == true
// run: eq_u32(7u, 0x80000001u) == false
// run: eq_u32(7u, 0xaaaaaaaau) == false
// run: eq_u32(100u, 0u) == false
// run: eq_u32(100u, 100u) == true
// run: eq_u32(100u, 0xffffffffu) == false
// run: eq_u32(100u, 0x00010000u) == false
// run: eq_u32(0x7fffffffu, 1u) == false
// run: eq_u32(0x7fffffffu, 0x7fffffffu) == true
// run: eq_u32(0x7fffffffu, 0xfffffffeu) == false
// run: eq_u32(0x7fffffffu, 65535u) == false
// run: eq_u32(0x80000000u, 2u) == false
// run: eq_u32(0x80000000u, 0x80000000u) == true
// run: eq_u32(0x80000000u, 0x12345678u) == false
// run: eq_u32(0x80000001u, 7u) == false
// run: eq_u32(0x80000001u, 0x80000001u) == true
// run: eq_u32(0x80000001u, 0xaaaaaaaau) == false
// run: eq_u32(0xffffffffu, 0u) == false
// run: eq_u32(0xffffffffu, 100u) == false
// run: eq_u32(0xffffffffu, 0xffffffffu) == true
// run: eq_u32(0xffffffffu, 0x00010000u) == false
// run: eq_u32(0xfffffffeu, 1u) == false
// run: eq_u32(0xfffffffeu, 0x7fffffffu) == false
// run: eq_u32(0xfffffffeu, 0xfffffffeu) == true
// run: eq_u32(0xfffffffeu, 65535u) == false
// run: eq_u32(0x12345678u, 2u) == false
// run: eq_u32(0x12345678u, 0x80000000u) == false
// run: eq_u32(0x12345678u, 0x12345678u) == true
// run: eq_u32(0xaaaaaaaau, 7u) == false
// run: eq_u32(0xaaaaaaaau, 0x80000001u) == false
// run: eq_u32(0xaaaaaaaau, 0xaaaaaaaau) == true
// run: eq_u32(0x00010000u, 0u) == false
// run: eq_u32(0x00010000u, 100u) == false
// run: eq_u32(0x00010000u, 0xffffffffu) == false
// run: eq_u32(0x00010000u, 0x00010000u) == true
// run: eq_u32(65535u, 1u) == false
// run: eq_u32(65535u, 0x7fffffffu) == false
// run: eq_u32(65535u, 0xfffffffeu) == false
// run: eq_u32(65535u, 65535u) == true

fn eq_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<bool> { return x == y; }
// run: eq_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 2u, 7u)) == vec3<bool>(false, false, false)
// run: eq_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(7u, 100u, 0x7fffffffu)) == vec3<bool>(true, true, true)
// run: eq_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == vec3<bool>(false, false, false)

fn not_eq_u32(x: u32, y: u32) -> bool { return !(x == y); }
// run: not_eq_u32(0xaaaaaaaau, 0xaaaaaaaau) == false
// run: not_eq_u32(0xaaaaaaaau, 0x00010000u) == true
// run: not_eq_u32(0xaaaaaaaau, 65535u) == true
// run: not_eq_u32(0x00010000u, 0xaaaaaaaau) == true
// run: not_eq_u32(0x00010000u, 0x00010000u) == false
// run: not_eq_u32(0x00010000u, 65535u) == true
// run: not_eq_u32(65535u, 0xaaaaaaaau) == true
// run: not_eq_u32(65535u, 0x00010000u) == true
// run: not_eq_u32(65535u, 65535u) == false

fn ne_u32(x: u32, y: u32) -> bool { return x != y; }
// run: ne_u32(0u, 0u) == false
// run: ne_u32(0u, 100u) == true
// run: ne_u32(0u, 0xffffffffu) == true
// run: ne_u32(0u, 0x00010000u) == true
// run: ne_u32(1u, 1u) == false
// run: ne_u32(1u, 0x7fffffffu) == true
// run: ne_u32(1u, 0xfffffffeu) == true
// run: ne_u32(1u, 65535u) == true
// run: ne_u32(2u, 2u) == false
// run: ne_u32(2u, 0x80000000u) == true
// run: ne_u32(2u, 0x12345678u) == true
// run: ne_u32(7u, 7u) == false
// run: ne_u32(7u, 0x80000001u) == true
// run: ne_u32(7u, 0xaaaaaaaau) == true
// run: ne_u32(100u, 0u) == true
// run: ne_u32(100u, 100u) == false
// run: ne_u32(100u, 0xffffffffu) == true
// run: ne_u32(100u, 0x00010000u) == true
// run: ne_u32(0x7fffffffu, 1u) == true
// run: ne_u32(0x7fffffffu, 0x7fffffffu) == false
// run: ne_u32(0x7fffffffu, 0xfffffffeu) == true
// run: ne_u32(0x7fffffffu, 65535u) == true
// run: ne_u32(0x80000000u, 2u) == true
// run: ne_u32(0x80000000u, 0x80000000u) == false
// run: ne_u32(0x80000000u, 0x12345678u) == true
// run: ne_u32(0x80000001u, 7u) == true
// run: ne_u32(0x80000001u, 0x80000001u) == false
// run: ne_u32(0x80000001u, 0xaaaaaaaau) == true
// run: ne_u32(0xffffffffu, 0u) == true
// run: ne_u32(0xffffffffu, 100u) == true
// run: ne_u32(0xffffffffu, 0xffffffffu) == false
// run: ne_u32(0xffffffffu, 0x00010000u) == true
// run: ne_u32(0xfffffffeu, 1u) == true
// run: ne_u32(0xfffffffeu, 0x7fffffffu) == true
// run: ne_u32(0xfffffffeu, 0xfffffffeu) == false
// run: ne_u32(0xfffffffeu, 65535u) == true
// run: ne_u32(0x12345678u, 2u) == true
// run: ne_u32(0x12345678u, 0x80000000u) == true
// run: ne_u32(0x12345678u, 0x12345678u) == false
// run: ne_u32(0xaaaaaaaau, 7u) == true
// run: ne_u32(0xaaaaaaaau, 0x80000001u) == true
// run: ne_u32(0xaaaaaaaau, 0xaaaaaaaau) == false
// run: ne_u32(0x00010000u, 0u) == true
// run: ne_u32(0x00010000u, 100u) == true
// run: ne_u32(0x00010000u, 0xffffffffu) == true
// run: ne_u32(0x00010000u, 0x00010000u) == false
// run: ne_u32(65535u, 1u) == true
// run: ne_u32(65535u, 0x7fffffffu) == true
// run: ne_u32(65535u, 0xfffffffeu) == true
// run: ne_u32(65535u, 65535u) == false

fn ne_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<bool> { return x != y; }
// run: ne_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 2u, 7u)) == vec3<bool>(true, true, true)
// run: ne_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(7u, 100u, 0x7fffffffu)) == vec3<bool>(false, false, false)
// run: ne_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == vec3<bool>(true, true, true)

fn not_ne_u32(x: u32, y: u32) -> bool { return !(x != y); }
// run: not_ne_u32(0xaaaaaaaau, 0xaaaaaaaau) == true
// run: not_ne_u32(0xaaaaaaaau, 0x00010000u) == false
// run: not_ne_u32(0xaaaaaaaau, 65535u) == false
// run: not_ne_u32(0x00010000u, 0xaaaaaaaau) == false
// run: not_ne_u32(0x00010000u, 0x00010000u) == true
// run: not_ne_u32(0x00010000u, 65535u) == false
// run: not_ne_u32(65535u, 0xaaaaaaaau) == false
// run: not_ne_u32(65535u, 0x00010000u) == false
// run: not_ne_u32(65535u, 65535u) == true

fn lt_u32(x: u32, y: u32) -> bool { return x < y; }
// run: lt_u32(0u, 0u) == false
// run: lt_u32(0u, 100u) == true
// run: lt_u32(0u, 0xffffffffu) == true
// run: lt_u32(0u, 0x00010000u) == true
// run: lt_u32(1u, 1u) == false
// run: lt_u32(1u, 0x7fffffffu) == true
// run: lt_u32(1u, 0xfffffffeu) == true
// run: lt_u32(1u, 65535u) == true
// run: lt_u32(2u, 2u) == false
// run: lt_u32(2u, 0x80000000u) == true
// run: lt_u32(2u, 0x12345678u) == true
// run: lt_u32(7u, 7u) == false
// run: lt_u32(7u, 0x80000001u) == true
// run: lt_u32(7u, 0xaaaaaaaau) == true
// run: lt_u32(100u, 0u) == false
// run: lt_u32(100u, 100u) == false
// run: lt_u32(100u, 0xffffffffu) == true
// run: lt_u32(100u, 0x00010000u) == true
// run: lt_u32(0x7fffffffu, 1u) == false
// run: lt_u32(0x7fffffffu, 0x7fffffffu) == false
// run: lt_u32(0x7fffffffu, 0xfffffffeu) == true
// run: lt_u32(0x7fffffffu, 65535u) == false
// run: lt_u32(0x80000000u, 2u) == false
// run: lt_u32(0x80000000u, 0x80000000u) == false
// run: lt_u32(0x80000000u, 0x12345678u) == false
// run: lt_u32(0x80000001u, 7u) == false
// run: lt_u32(0x80000001u, 0x80000001u) == false
// run: lt_u32(0x80000001u, 0xaaaaaaaau) == true
// run: lt_u32(0xffffffffu, 0u) == false
// run: lt_u32(0xffffffffu, 100u) == false
// run: lt_u32(0xffffffffu, 0xffffffffu) == false
// run: lt_u32(0xffffffffu, 0x00010000u) == false
// run: lt_u32(0xfffffffeu, 1u) == false
// run: lt_u32(0xfffffffeu, 0x7fffffffu) == false
// run: lt_u32(0xfffffffeu, 0xfffffffeu) == false
// run: lt_u32(0xfffffffeu, 65535u) == false
// run: lt_u32(0x12345678u, 2u) == false
// run: lt_u32(0x12345678u, 0x80000000u) == true
// run: lt_u32(0x12345678u, 0x12345678u) == false
// run: lt_u32(0xaaaaaaaau, 7u) == false
// run: lt_u32(0xaaaaaaaau, 0x80000001u) == false
// run: lt_u32(0xaaaaaaaau, 0xaaaaaaaau) == false
// run: lt_u32(0x00010000u, 0u) == false
// run: lt_u32(0x00010000u, 100u) == false
// run: lt_u32(0x00010000u, 0xffffffffu) == true
// run: lt_u32(0x00010000u, 0x00010000u) == false
// run: lt_u32(65535u, 1u) == false
// run: lt_u32(65535u, 0x7fffffffu) == true
// run: lt_u32(65535u, 0xfffffffeu) == true
// run: lt_u32(65535u, 65535u) == false

fn lt_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<bool> { return x < y; }
// run: lt_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 2u, 7u)) == vec3<bool>(true, true, true)
// run: lt_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(7u, 100u, 0x7fffffffu)) == vec3<bool>(false, false, false)
// run: lt_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == vec3<bool>(false, false, false)

fn not_lt_u32(x: u32, y: u32) -> bool { return !(x < y); }
// run: not_lt_u32(0xaaaaaaaau, 0xaaaaaaaau) == true
// run: not_lt_u32(0xaaaaaaaau, 0x00010000u) == true
// run: not_lt_u32(0xaaaaaaaau, 65535u) == true
// run: not_lt_u32(0x00010000u, 0xaaaaaaaau) == false
// run: not_lt_u32(0x00010000u, 0x00010000u) == true
// run: not_lt_u32(0x00010000u, 65535u) == true
// run: not_lt_u32(65535u, 0xaaaaaaaau) == false
// run: not_lt_u32(65535u, 0x00010000u) == false
// run: not_lt_u32(65535u, 65535u) == true

fn le_u32(x: u32, y: u32) -> bool { return x <= y; }
// run: le_u32(0u, 0u) == true
// run: le_u32(0u, 100u) == true
// run: le_u32(0u, 0xffffffffu) == true
// run: le_u32(0u, 0x00010000u) == true
// run: le_u32(1u, 1u) == true
// run: le_u32(1u, 0x7fffffffu) == true
// run: le_u32(1u, 0xfffffffeu) == true
// run: le_u32(1u, 65535u) == true
// run: le_u32(2u, 2u) == true
// run: le_u32(2u, 0x80000000u) == true
// run: le_u32(2u, 0x12345678u) == true
// run: le_u32(7u, 7u) == true
// run: le_u32(7u, 0x80000001u) == true
// run: le_u32(7u, 0xaaaaaaaau) == true
// run: le_u32(100u, 0u) == false
// run: le_u32(100u, 100u) == true
// run: le_u32(100u, 0xffffffffu) == true
// run: le_u32(100u, 0x00010000u) == true
// run: le_u32(0x7fffffffu, 1u) == false
// run: le_u32(0x7fffffffu, 0x7fffffffu) == true
// run: le_u32(0x7fffffffu, 0xfffffffeu) == true
// run: le_u32(0x7fffffffu, 65535u) == false
// run: le_u32(0x80000000u, 2u) == false
// run: le_u32(0x80000000u, 0x80000000u) == true
// run: le_u32(0x80000000u, 0x12345678u) == false
// run: le_u32(0x80000001u, 7u) == false
// run: le_u32(0x80000001u, 0x80000001u) == true
// run: le_u32(0x80000001u, 0xaaaaaaaau) == true
// run: le_u32(0xffffffffu, 0u) == false
// run: le_u32(0xffffffffu, 100u) == false
// run: le_u32(0xffffffffu, 0xffffffffu) == true
// run: le_u32(0xffffffffu, 0x00010000u) == false
// run: le_u32(0xfffffffeu, 1u) == false
// run: le_u32(0xfffffffeu, 0x7fffffffu) == false
// run: le_u32(0xfffffffeu, 0xfffffffeu) == true
// run: le_u32(0xfffffffeu, 65535u) == false
// run: le_u32(0x12345678u, 2u) == false
// run: le_u32(0x12345678u, 0x80000000u) == true
// run: le_u32(0x12345678u, 0x12345678u) == true
// run: le_u32(0xaaaaaaaau, 7u) == false
// run: le_u32(0xaaaaaaaau, 0x80000001u) == false
// run: le_u32(0xaaaaaaaau, 0xaaaaaaaau) == true
// run: le_u32(0x00010000u, 0u) == false
// run: le_u32(0x00010000u, 100u) == false
// run: le_u32(0x00010000u, 0xffffffffu) == true
// run: le_u32(0x00010000u, 0x00010000u) == true
// run: le_u32(65535u, 1u) == false
// run: le_u32(65535u, 0x7fffffffu) == true
// run: le_u32(65535u, 0xfffffffeu) == true
// run: le_u32(65535u, 65535u) == true

fn le_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<bool> { return x <= y; }
// run: le_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 2u, 7u)) == vec3<bool>(true, true, true)
// run: le_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(7u, 100u, 0x7fffffffu)) == vec3<bool>(true, true, true)
// run: le_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == vec3<bool>(false, false, false)

fn not_le_u32(x: u32, y: u32) -> bool { return !(x <= y); }
// run: not_le_u32(0xaaaaaaaau, 0xaaaaaaaau) == false
// run: not_le_u32(0xaaaaaaaau, 0x00010000u) == true
// run: not_le_u32(0xaaaaaaaau, 65535u) == true
// run: not_le_u32(0x00010000u, 0xaaaaaaaau) == false
// run: not_le_u32(0x00010000u, 0x00010000u) == false
// run: not_le_u32(0x00010000u, 65535u) == true
// run: not_le_u32(65535u, 0xaaaaaaaau) == false
// run: not_le_u32(65535u, 0x00010000u) == false
// run: not_le_u32(65535u, 65535u) == false

fn gt_u32(x: u32, y: u32) -> bool { return x > y; }
// run: gt_u32(0u, 0u) == false
// run: gt_u32(0u, 100u) == false
// run: gt_u32(0u, 0xffffffffu) == false
// run: gt_u32(0u, 0x00010000u) == false
// run: gt_u32(1u, 1u) == false
// run: gt_u32(1u, 0x7fffffffu) == false
// run: gt_u32(1u, 0xfffffffeu) == false
// run: gt_u32(1u, 65535u) == false
// run: gt_u32(2u, 2u) == false
// run: gt_u32(2u, 0x80000000u) == false
// run: gt_u32(2u, 0x12345678u) == false
// run: gt_u32(7u, 7u) == false
// run: gt_u32(7u, 0x80000001u) == false
// run: gt_u32(7u, 0xaaaaaaaau) == false
// run: gt_u32(100u, 0u) == true
// run: gt_u32(100u, 100u) == false
// run: gt_u32(100u, 0xffffffffu) == false
// run: gt_u32(100u, 0x00010000u) == false
// run: gt_u32(0x7fffffffu, 1u) == true
// run: gt_u32(0x7fffffffu, 0x7fffffffu) == false
// run: gt_u32(0x7fffffffu, 0xfffffffeu) == false
// run: gt_u32(0x7fffffffu, 65535u) == true
// run: gt_u32(0x80000000u, 2u) == true
// run: gt_u32(0x80000000u, 0x80000000u) == false
// run: gt_u32(0x80000000u, 0x12345678u) == true
// run: gt_u32(0x80000001u, 7u) == true
// run: gt_u32(0x80000001u, 0x80000001u) == false
// run: gt_u32(0x80000001u, 0xaaaaaaaau) == false
// run: gt_u32(0xffffffffu, 0u) == true
// run: gt_u32(0xffffffffu, 100u) == true
// run: gt_u32(0xffffffffu, 0xffffffffu) == false
// run: gt_u32(0xffffffffu, 0x00010000u) == true
// run: gt_u32(0xfffffffeu, 1u) == true
// run: gt_u32(0xfffffffeu, 0x7fffffffu) == true
// run: gt_u32(0xfffffffeu, 0xfffffffeu) == false
// run: gt_u32(0xfffffffeu, 65535u) == true
// run: gt_u32(0x12345678u, 2u) == true
// run: gt_u32(0x12345678u, 0x80000000u) == false
// run: gt_u32(0x12345678u, 0x12345678u) == false
// run: gt_u32(0xaaaaaaaau, 7u) == true
// run: gt_u32(0xaaaaaaaau, 0x80000001u) == true
// run: gt_u32(0xaaaaaaaau, 0xaaaaaaaau) == false
// run: gt_u32(0x00010000u, 0u) == true
// run: gt_u32(0x00010000u, 100u) == true
// run: gt_u32(0x00010000u, 0xffffffffu) == false
// run: gt_u32(0x00010000u, 0x00010000u) == false
// run: gt_u32(65535u, 1u) == true
// run: gt_u32(65535u, 0x7fffffffu) == false
// run: gt_u32(65535u, 0xfffffffeu) == false
// run: gt_u32(65535u, 65535u) == false

fn gt_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<bool> { return x > y; }
// run: gt_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 2u, 7u)) == vec3<bool>(false, false, false)
// run: gt_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(7u, 100u, 0x7fffffffu)) == vec3<bool>(false, false, false)
// run: gt_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == vec3<bool>(true, true, true)

fn not_gt_u32(x: u32, y: u32) -> bool { return !(x > y); }
// run: not_gt_u32(0xaaaaaaaau, 0xaaaaaaaau) == true
// run: not_gt_u32(0xaaaaaaaau, 0x00010000u) == false
// run: not_gt_u32(0xaaaaaaaau, 65535u) == false
// run: not_gt_u32(0x00010000u, 0xaaaaaaaau) == true
// run: not_gt_u32(0x00010000u, 0x00010000u) == true
// run: not_gt_u32(0x00010000u, 65535u) == false
// run: not_gt_u32(65535u, 0xaaaaaaaau) == true
// run: not_gt_u32(65535u, 0x00010000u) == true
// run: not_gt_u32(65535u, 65535u) == true

fn ge_u32(x: u32, y: u32) -> bool { return x >= y; }
// run: ge_u32(0u, 0u) == true
// run: ge_u32(0u, 100u) == false
// run: ge_u32(0u, 0xffffffffu) == false
// run: ge_u32(0u, 0x00010000u) == false
// run: ge_u32(1u, 1u) == true
// run: ge_u32(1u, 0x7fffffffu) == false
// run: ge_u32(1u, 0xfffffffeu) == false
// run: ge_u32(1u, 65535u) == false
// run: ge_u32(2u, 2u) == true
// run: ge_u32(2u, 0x80000000u) == false
// run: ge_u32(2u, 0x12345678u) == false
// run: ge_u32(7u, 7u) == true
// run: ge_u32(7u, 0x80000001u) == false
// run: ge_u32(7u, 0xaaaaaaaau) == false
// run: ge_u32(100u, 0u) == true
// run: ge_u32(100u, 100u) == true
// run: ge_u32(100u, 0xffffffffu) == false
// run: ge_u32(100u, 0x00010000u) == false
// run: ge_u32(0x7fffffffu, 1u) == true
// run: ge_u32(0x7fffffffu, 0x7fffffffu) == true
// run: ge_u32(0x7fffffffu, 0xfffffffeu) == false
// run: ge_u32(0x7fffffffu, 65535u) == true
// run: ge_u32(0x80000000u, 2u) == true
// run: ge_u32(0x80000000u, 0x80000000u) == true
// run: ge_u32(0x80000000u, 0x12345678u) == true
// run: ge_u32(0x80000001u, 7u) == true
// run: ge_u32(0x80000001u, 0x80000001u) == true
// run: ge_u32(0x80000001u, 0xaaaaaaaau) == false
// run: ge_u32(0xffffffffu, 0u) == true
// run: ge_u32(0xffffffffu, 100u) == true
// run: ge_u32(0xffffffffu, 0xffffffffu) == true
// run: ge_u32(0xffffffffu, 0x00010000u) == true
// run: ge_u32(0xfffffffeu, 1u) == true
// run: ge_u32(0xfffffffeu, 0x7fffffffu) == true
// run: ge_u32(0xfffffffeu, 0xfffffffeu) == true
// run: ge_u32(0xfffffffeu, 65535u) == true
// run: ge_u32(0x12345678u, 2u) == true
// run: ge_u32(0x12345678u, 0x80000000u) == false
// run: ge_u32(0x12345678u, 0x12345678u) == true
// run: ge_u32(0xaaaaaaaau, 7u) == true
// run: ge_u32(0xaaaaaaaau, 0x80000001u) == true
// run: ge_u32(0xaaaaaaaau, 0xaaaaaaaau) == true
// run: ge_u32(0x00010000u, 0u) == true
// run: ge_u32(0x00010000u, 100u) == true
// run: ge_u32(0x00010000u, 0xffffffffu) == false
// run: ge_u32(0x00010000u, 0x00010000u) == true
// run: ge_u32(65535u, 1u) == true
// run: ge_u32(65535u, 0x7fffffffu) == false
// run: ge_u32(65535u, 0xfffffffeu) == false
// run: ge_u32(65535u, 65535u) == true

fn ge_u32_vec3(x: vec3<u32>, y: vec3<u32>) -> vec3<bool> { return x >= y; }
// run: ge_u32_vec3(vec3<u32>(0u, 1u, 2u), vec3<u32>(1u, 2u, 7u)) == vec3<bool>(false, false, false)
// run: ge_u32_vec3(vec3<u32>(7u, 100u, 0x7fffffffu), vec3<u32>(7u, 100u, 0x7fffffffu)) == vec3<bool>(true, true, true)
// run: ge_u32_vec3(vec3<u32>(0x80000000u, 0x80000001u, 0xffffffffu), vec3<u32>(0x7fffffffu, 0x80000000u, 0x80000001u)) == vec3<bool>(true, true, true)

fn not_ge_u32(x: u32, y: u32) -> bool { return !(x >= y); }
// run: not_ge_u32(0xaaaaaaaau, 0xaaaaaaaau) == false
// run: not_ge_u32(0xaaaaaaaau, 0x00010000u) == false
// run: not_ge_u32(0xaaaaaaaau, 65535u) == false
// run: not_ge_u32(0x00010000u, 0xaaaaaaaau) == true
// run: not_ge_u32(0x00010000u, 0x00010000u) == false
// run: not_ge_u32(0x00010000u, 65535u) == false
// run: not_ge_u32(65535u, 0xaaaaaaaau) == true
// run: not_ge_u32(65535u, 0x00010000u) == true
// run: not_ge_u32(65535u, 65535u) == false

fn eq_f32(x: f32, y: f32) -> bool { return x == y; }
// run: eq_f32(0.0, 0.0) == true
// run: eq_f32(0.0, -0.0) == true
// run: eq_f32(0.0, 0.5) == false
// run: eq_f32(0.0, bitcast<f32>(0x7f800000u)) == false
// run: eq_f32(0.0, 1.0000001) == false
// run: eq_f32(-0.0, 0.0) == true
// run: eq_f32(-0.0, -0.0) == true
// run: eq_f32(-0.0, bitcast<f32>(0x000116c2u)) == false
// run: eq_f32(-0.0, bitcast<f32>(0xff800000u)) == false
// run: eq_f32(1.0, 1.0) == true
// run: eq_f32(1.0, bitcast<f32>(0x800116c2u)) == false
// run: eq_f32(1.0, bitcast<f32>(0x7fc00000u)) == false
// run: eq_f32(-1.0, -1.0) == true
// run: eq_f32(-1.0, 3.4e+38) == false
// run: eq_f32(-1.0, 1.5) == false
// run: eq_f32(0.5, 0.0) == false
// run: eq_f32(0.5, 0.5) == true
// run: eq_f32(0.5, bitcast<f32>(0x7f800000u)) == false
// run: eq_f32(0.5, 1.0000001) == false
// run: eq_f32(bitcast<f32>(0x000116c2u), -0.0) == false
// run: eq_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0x000116c2u)) == true
// run: eq_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0xff800000u)) == false
// run: eq_f32(bitcast<f32>(0x800116c2u), 1.0) == false
// run: eq_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x800116c2u)) == true
// run: eq_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x7fc00000u)) == false
// run: eq_f32(3.4e+38, -1.0) == false
// run: eq_f32(3.4e+38, 3.4e+38) == true
// run: eq_f32(3.4e+38, 1.5) == false
// run: eq_f32(bitcast<f32>(0x7f800000u), 0.0) == false
// run: eq_f32(bitcast<f32>(0x7f800000u), 0.5) == false
// run: eq_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == true
// run: eq_f32(bitcast<f32>(0x7f800000u), 1.0000001) == false
// run: eq_f32(bitcast<f32>(0xff800000u), -0.0) == false
// run: eq_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x000116c2u)) == false
// run: eq_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == true
// run: eq_f32(bitcast<f32>(0x7fc00000u), 1.0) == false
// run: eq_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x800116c2u)) == false
// run: eq_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == false
// run: eq_f32(1.5, -1.0) == false
// run: eq_f32(1.5, 3.4e+38) == false
// run: eq_f32(1.5, 1.5) == true
// run: eq_f32(1.0000001, 0.0) == false
// run: eq_f32(1.0000001, 0.5) == false
// run: eq_f32(1.0000001, bitcast<f32>(0x7f800000u)) == false
// run: eq_f32(1.0000001, 1.0000001) == true

fn eq_f32_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<bool> { return x == y; }
// run: eq_f32_vec3(vec3<f32>(0.0, -0.0, 1.0), vec3<f32>(-0.0, 1.0, -1.0)) == vec3<bool>(true, false, false)
// run: eq_f32_vec3(vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u)), vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u))) == vec3<bool>(true, true, true)
// run: eq_f32_vec3(vec3<f32>(bitcast<f32>(0x800116c2u), 3.4e+38, bitcast<f32>(0x7f800000u)), vec3<f32>(bitcast<f32>(0x000116c2u), bitcast<f32>(0x800116c2u), 3.4e+38)) == vec3<bool>(false, false, false)

fn not_eq_f32(x: f32, y: f32) -> bool { return !(x == y); }
// run: not_eq_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == true
// run: not_eq_f32(bitcast<f32>(0x7fc00000u), 1.5) == true
// run: not_eq_f32(bitcast<f32>(0x7fc00000u), 1.0000001) == true
// run: not_eq_f32(1.5, bitcast<f32>(0x7fc00000u)) == true
// run: not_eq_f32(1.5, 1.5) == false
// run: not_eq_f32(1.5, 1.0000001) == true
// run: not_eq_f32(1.0000001, bitcast<f32>(0x7fc00000u)) == true
// run: not_eq_f32(1.0000001, 1.5) == true
// run: not_eq_f32(1.0000001, 1.0000001) == false

fn ne_f32(x: f32, y: f32) -> bool { return x != y; }
// run: ne_f32(0.0, 0.0) == false
// run: ne_f32(0.0, -0.0) == false
// run: ne_f32(0.0, 0.5) == true
// run: ne_f32(0.0, bitcast<f32>(0x7f800000u)) == true
// run: ne_f32(0.0, 1.0000001) == true
// run: ne_f32(-0.0, 0.0) == false
// run: ne_f32(-0.0, -0.0) == false
// run: ne_f32(-0.0, bitcast<f32>(0x000116c2u)) == true
// run: ne_f32(-0.0, bitcast<f32>(0xff800000u)) == true
// run: ne_f32(1.0, 1.0) == false
// run: ne_f32(1.0, bitcast<f32>(0x800116c2u)) == true
// run: ne_f32(1.0, bitcast<f32>(0x7fc00000u)) == true
// run: ne_f32(-1.0, -1.0) == false
// run: ne_f32(-1.0, 3.4e+38) == true
// run: ne_f32(-1.0, 1.5) == true
// run: ne_f32(0.5, 0.0) == true
// run: ne_f32(0.5, 0.5) == false
// run: ne_f32(0.5, bitcast<f32>(0x7f800000u)) == true
// run: ne_f32(0.5, 1.0000001) == true
// run: ne_f32(bitcast<f32>(0x000116c2u), -0.0) == true
// run: ne_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0x000116c2u)) == false
// run: ne_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0xff800000u)) == true
// run: ne_f32(bitcast<f32>(0x800116c2u), 1.0) == true
// run: ne_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x800116c2u)) == false
// run: ne_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x7fc00000u)) == true
// run: ne_f32(3.4e+38, -1.0) == true
// run: ne_f32(3.4e+38, 3.4e+38) == false
// run: ne_f32(3.4e+38, 1.5) == true
// run: ne_f32(bitcast<f32>(0x7f800000u), 0.0) == true
// run: ne_f32(bitcast<f32>(0x7f800000u), 0.5) == true
// run: ne_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == false
// run: ne_f32(bitcast<f32>(0x7f800000u), 1.0000001) == true
// run: ne_f32(bitcast<f32>(0xff800000u), -0.0) == true
// run: ne_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x000116c2u)) == true
// run: ne_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == false
// run: ne_f32(bitcast<f32>(0x7fc00000u), 1.0) == true
// run: ne_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x800116c2u)) == true
// run: ne_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == true
// run: ne_f32(1.5, -1.0) == true
// run: ne_f32(1.5, 3.4e+38) == true
// run: ne_f32(1.5, 1.5) == false
// run: ne_f32(1.0000001, 0.0) == true
// run: ne_f32(1.0000001, 0.5) == true
// run: ne_f32(1.0000001, bitcast<f32>(0x7f800000u)) == true
// run: ne_f32(1.0000001, 1.0000001) == false

fn ne_f32_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<bool> { return x != y; }
// run: ne_f32_vec3(vec3<f32>(0.0, -0.0, 1.0), vec3<f32>(-0.0, 1.0, -1.0)) == vec3<bool>(false, true, true)
// run: ne_f32_vec3(vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u)), vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u))) == vec3<bool>(false, false, false)
// run: ne_f32_vec3(vec3<f32>(bitcast<f32>(0x800116c2u), 3.4e+38, bitcast<f32>(0x7f800000u)), vec3<f32>(bitcast<f32>(0x000116c2u), bitcast<f32>(0x800116c2u), 3.4e+38)) == vec3<bool>(true, true, true)

fn not_ne_f32(x: f32, y: f32) -> bool { return !(x != y); }
// run: not_ne_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == false
// run: not_ne_f32(bitcast<f32>(0x7fc00000u), 1.5) == false
// run: not_ne_f32(bitcast<f32>(0x7fc00000u), 1.0000001) == false
// run: not_ne_f32(1.5, bitcast<f32>(0x7fc00000u)) == false
// run: not_ne_f32(1.5, 1.5) == true
// run: not_ne_f32(1.5, 1.0000001) == false
// run: not_ne_f32(1.0000001, bitcast<f32>(0x7fc00000u)) == false
// run: not_ne_f32(1.0000001, 1.5) == false
// run: not_ne_f32(1.0000001, 1.0000001) == true

fn lt_f32(x: f32, y: f32) -> bool { return x < y; }
// run: lt_f32(0.0, 0.0) == false
// run: lt_f32(0.0, -0.0) == false
// run: lt_f32(0.0, 0.5) == true
// run: lt_f32(0.0, bitcast<f32>(0x7f800000u)) == true
// run: lt_f32(0.0, 1.0000001) == true
// run: lt_f32(-0.0, 0.0) == false
// run: lt_f32(-0.0, -0.0) == false
// run: lt_f32(-0.0, bitcast<f32>(0x000116c2u)) == true
// run: lt_f32(-0.0, bitcast<f32>(0xff800000u)) == false
// run: lt_f32(1.0, 1.0) == false
// run: lt_f32(1.0, bitcast<f32>(0x800116c2u)) == false
// run: lt_f32(1.0, bitcast<f32>(0x7fc00000u)) == false
// run: lt_f32(-1.0, -1.0) == false
// run: lt_f32(-1.0, 3.4e+38) == true
// run: lt_f32(-1.0, 1.5) == true
// run: lt_f32(0.5, 0.0) == false
// run: lt_f32(0.5, 0.5) == false
// run: lt_f32(0.5, bitcast<f32>(0x7f800000u)) == true
// run: lt_f32(0.5, 1.0000001) == true
// run: lt_f32(bitcast<f32>(0x000116c2u), -0.0) == false
// run: lt_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0x000116c2u)) == false
// run: lt_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0xff800000u)) == false
// run: lt_f32(bitcast<f32>(0x800116c2u), 1.0) == true
// run: lt_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x800116c2u)) == false
// run: lt_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x7fc00000u)) == false
// run: lt_f32(3.4e+38, -1.0) == false
// run: lt_f32(3.4e+38, 3.4e+38) == false
// run: lt_f32(3.4e+38, 1.5) == false
// run: lt_f32(bitcast<f32>(0x7f800000u), 0.0) == false
// run: lt_f32(bitcast<f32>(0x7f800000u), 0.5) == false
// run: lt_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == false
// run: lt_f32(bitcast<f32>(0x7f800000u), 1.0000001) == false
// run: lt_f32(bitcast<f32>(0xff800000u), -0.0) == true
// run: lt_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x000116c2u)) == true
// run: lt_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == false
// run: lt_f32(bitcast<f32>(0x7fc00000u), 1.0) == false
// run: lt_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x800116c2u)) == false
// run: lt_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == false
// run: lt_f32(1.5, -1.0) == false
// run: lt_f32(1.5, 3.4e+38) == true
// run: lt_f32(1.5, 1.5) == false
// run: lt_f32(1.0000001, 0.0) == false
// run: lt_f32(1.0000001, 0.5) == false
// run: lt_f32(1.0000001, bitcast<f32>(0x7f800000u)) == true
// run: lt_f32(1.0000001, 1.0000001) == false

fn lt_f32_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<bool> { return x < y; }
// run: lt_f32_vec3(vec3<f32>(0.0, -0.0, 1.0), vec3<f32>(-0.0, 1.0, -1.0)) == vec3<bool>(false, true, false)
// run: lt_f32_vec3(vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u)), vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u))) == vec3<bool>(false, false, false)
// run: lt_f32_vec3(vec3<f32>(bitcast<f32>(0x800116c2u), 3.4e+38, bitcast<f32>(0x7f800000u)), vec3<f32>(bitcast<f32>(0x000116c2u), bitcast<f32>(0x800116c2u), 3.4e+38)) == vec3<bool>(true, false, false)

fn not_lt_f32(x: f32, y: f32) -> bool { return !(x < y); }
// run: not_lt_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == true
// run: not_lt_f32(bitcast<f32>(0x7fc00000u), 1.5) == true
// run: not_lt_f32(bitcast<f32>(0x7fc00000u), 1.0000001) == true
// run: not_lt_f32(1.5, bitcast<f32>(0x7fc00000u)) == true
// run: not_lt_f32(1.5, 1.5) == true
// run: not_lt_f32(1.5, 1.0000001) == true
// run: not_lt_f32(1.0000001, bitcast<f32>(0x7fc00000u)) == true
// run: not_lt_f32(1.0000001, 1.5) == false
// run: not_lt_f32(1.0000001, 1.0000001) == true

fn le_f32(x: f32, y: f32) -> bool { return x <= y; }
// run: le_f32(0.0, 0.0) == true
// run: le_f32(0.0, -0.0) == true
// run: le_f32(0.0, 0.5) == true
// run: le_f32(0.0, bitcast<f32>(0x7f800000u)) == true
// run: le_f32(0.0, 1.0000001) == true
// run: le_f32(-0.0, 0.0) == true
// run: le_f32(-0.0, -0.0) == true
// run: le_f32(-0.0, bitcast<f32>(0x000116c2u)) == true
// run: le_f32(-0.0, bitcast<f32>(0xff800000u)) == false
// run: le_f32(1.0, 1.0) == true
// run: le_f32(1.0, bitcast<f32>(0x800116c2u)) == false
// run: le_f32(1.0, bitcast<f32>(0x7fc00000u)) == false
// run: le_f32(-1.0, -1.0) == true
// run: le_f32(-1.0, 3.4e+38) == true
// run: le_f32(-1.0, 1.5) == true
// run: le_f32(0.5, 0.0) == false
// run: le_f32(0.5, 0.5) == true
// run: le_f32(0.5, bitcast<f32>(0x7f800000u)) == true
// run: le_f32(0.5, 1.0000001) == true
// run: le_f32(bitcast<f32>(0x000116c2u), -0.0) == false
// run: le_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0x000116c2u)) == true
// run: le_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0xff800000u)) == false
// run: le_f32(bitcast<f32>(0x800116c2u), 1.0) == true
// run: le_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x800116c2u)) == true
// run: le_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x7fc00000u)) == false
// run: le_f32(3.4e+38, -1.0) == false
// run: le_f32(3.4e+38, 3.4e+38) == true
// run: le_f32(3.4e+38, 1.5) == false
// run: le_f32(bitcast<f32>(0x7f800000u), 0.0) == false
// run: le_f32(bitcast<f32>(0x7f800000u), 0.5) == false
// run: le_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == true
// run: le_f32(bitcast<f32>(0x7f800000u), 1.0000001) == false
// run: le_f32(bitcast<f32>(0xff800000u), -0.0) == true
// run: le_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x000116c2u)) == true
// run: le_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == true
// run: le_f32(bitcast<f32>(0x7fc00000u), 1.0) == false
// run: le_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x800116c2u)) == false
// run: le_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == false
// run: le_f32(1.5, -1.0) == false
// run: le_f32(1.5, 3.4e+38) == true
// run: le_f32(1.5, 1.5) == true
// run: le_f32(1.0000001, 0.0) == false
// run: le_f32(1.0000001, 0.5) == false
// run: le_f32(1.0000001, bitcast<f32>(0x7f800000u)) == true
// run: le_f32(1.0000001, 1.0000001) == true

fn le_f32_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<bool> { return x <= y; }
// run: le_f32_vec3(vec3<f32>(0.0, -0.0, 1.0), vec3<f32>(-0.0, 1.0, -1.0)) == vec3<bool>(true, true, false)
// run: le_f32_vec3(vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u)), vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u))) == vec3<bool>(true, true, true)
// run: le_f32_vec3(vec3<f32>(bitcast<f32>(0x800116c2u), 3.4e+38, bitcast<f32>(0x7f800000u)), vec3<f32>(bitcast<f32>(0x000116c2u), bitcast<f32>(0x800116c2u), 3.4e+38)) == vec3<bool>(true, false, false)

fn not_le_f32(x: f32, y: f32) -> bool { return !(x <= y); }
// run: not_le_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == true
// run: not_le_f32(bitcast<f32>(0x7fc00000u), 1.5) == true
// run: not_le_f32(bitcast<f32>(0x7fc00000u), 1.0000001) == true
// run: not_le_f32(1.5, bitcast<f32>(0x7fc00000u)) == true
// run: not_le_f32(1.5, 1.5) == false
// run: not_le_f32(1.5, 1.0000001) == true
// run: not_le_f32(1.0000001, bitcast<f32>(0x7fc00000u)) == true
// run: not_le_f32(1.0000001, 1.5) == false
// run: not_le_f32(1.0000001, 1.0000001) == false

fn gt_f32(x: f32, y: f32) -> bool { return x > y; }
// run: gt_f32(0.0, 0.0) == false
// run: gt_f32(0.0, -0.0) == false
// run: gt_f32(0.0, 0.5) == false
// run: gt_f32(0.0, bitcast<f32>(0x7f800000u)) == false
// run: gt_f32(0.0, 1.0000001) == false
// run: gt_f32(-0.0, 0.0) == false
// run: gt_f32(-0.0, -0.0) == false
// run: gt_f32(-0.0, bitcast<f32>(0x000116c2u)) == false
// run: gt_f32(-0.0, bitcast<f32>(0xff800000u)) == true
// run: gt_f32(1.0, 1.0) == false
// run: gt_f32(1.0, bitcast<f32>(0x800116c2u)) == true
// run: gt_f32(1.0, bitcast<f32>(0x7fc00000u)) == false
// run: gt_f32(-1.0, -1.0) == false
// run: gt_f32(-1.0, 3.4e+38) == false
// run: gt_f32(-1.0, 1.5) == false
// run: gt_f32(0.5, 0.0) == true
// run: gt_f32(0.5, 0.5) == false
// run: gt_f32(0.5, bitcast<f32>(0x7f800000u)) == false
// run: gt_f32(0.5, 1.0000001) == false
// run: gt_f32(bitcast<f32>(0x000116c2u), -0.0) == true
// run: gt_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0x000116c2u)) == false
// run: gt_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0xff800000u)) == true
// run: gt_f32(bitcast<f32>(0x800116c2u), 1.0) == false
// run: gt_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x800116c2u)) == false
// run: gt_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x7fc00000u)) == false
// run: gt_f32(3.4e+38, -1.0) == true
// run: gt_f32(3.4e+38, 3.4e+38) == false
// run: gt_f32(3.4e+38, 1.5) == true
// run: gt_f32(bitcast<f32>(0x7f800000u), 0.0) == true
// run: gt_f32(bitcast<f32>(0x7f800000u), 0.5) == true
// run: gt_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == false
// run: gt_f32(bitcast<f32>(0x7f800000u), 1.0000001) == true
// run: gt_f32(bitcast<f32>(0xff800000u), -0.0) == false
// run: gt_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x000116c2u)) == false
// run: gt_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == false
// run: gt_f32(bitcast<f32>(0x7fc00000u), 1.0) == false
// run: gt_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x800116c2u)) == false
// run: gt_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == false
// run: gt_f32(1.5, -1.0) == true
// run: gt_f32(1.5, 3.4e+38) == false
// run: gt_f32(1.5, 1.5) == false
// run: gt_f32(1.0000001, 0.0) == true
// run: gt_f32(1.0000001, 0.5) == true
// run: gt_f32(1.0000001, bitcast<f32>(0x7f800000u)) == false
// run: gt_f32(1.0000001, 1.0000001) == false

fn gt_f32_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<bool> { return x > y; }
// run: gt_f32_vec3(vec3<f32>(0.0, -0.0, 1.0), vec3<f32>(-0.0, 1.0, -1.0)) == vec3<bool>(false, false, true)
// run: gt_f32_vec3(vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u)), vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u))) == vec3<bool>(false, false, false)
// run: gt_f32_vec3(vec3<f32>(bitcast<f32>(0x800116c2u), 3.4e+38, bitcast<f32>(0x7f800000u)), vec3<f32>(bitcast<f32>(0x000116c2u), bitcast<f32>(0x800116c2u), 3.4e+38)) == vec3<bool>(false, true, true)

fn not_gt_f32(x: f32, y: f32) -> bool { return !(x > y); }
// run: not_gt_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == true
// run: not_gt_f32(bitcast<f32>(0x7fc00000u), 1.5) == true
// run: not_gt_f32(bitcast<f32>(0x7fc00000u), 1.0000001) == true
// run: not_gt_f32(1.5, bitcast<f32>(0x7fc00000u)) == true
// run: not_gt_f32(1.5, 1.5) == true
// run: not_gt_f32(1.5, 1.0000001) == false
// run: not_gt_f32(1.0000001, bitcast<f32>(0x7fc00000u)) == true
// run: not_gt_f32(1.0000001, 1.5) == true
// run: not_gt_f32(1.0000001, 1.0000001) == true

fn ge_f32(x: f32, y: f32) -> bool { return x >= y; }
// run: ge_f32(0.0, 0.0) == true
// run: ge_f32(0.0, -0.0) == true
// run: ge_f32(0.0, 0.5) == false
// run: ge_f32(0.0, bitcast<f32>(0x7f800000u)) == false
// run: ge_f32(0.0, 1.0000001) == false
// run: ge_f32(-0.0, 0.0) == true
// run: ge_f32(-0.0, -0.0) == true
// run: ge_f32(-0.0, bitcast<f32>(0x000116c2u)) == false
// run: ge_f32(-0.0, bitcast<f32>(0xff800000u)) == true
// run: ge_f32(1.0, 1.0) == true
// run: ge_f32(1.0, bitcast<f32>(0x800116c2u)) == true
// run: ge_f32(1.0, bitcast<f32>(0x7fc00000u)) == false
// run: ge_f32(-1.0, -1.0) == true
// run: ge_f32(-1.0, 3.4e+38) == false
// run: ge_f32(-1.0, 1.5) == false
// run: ge_f32(0.5, 0.0) == true
// run: ge_f32(0.5, 0.5) == true
// run: ge_f32(0.5, bitcast<f32>(0x7f800000u)) == false
// run: ge_f32(0.5, 1.0000001) == false
// run: ge_f32(bitcast<f32>(0x000116c2u), -0.0) == true
// run: ge_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0x000116c2u)) == true
// run: ge_f32(bitcast<f32>(0x000116c2u), bitcast<f32>(0xff800000u)) == true
// run: ge_f32(bitcast<f32>(0x800116c2u), 1.0) == false
// run: ge_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x800116c2u)) == true
// run: ge_f32(bitcast<f32>(0x800116c2u), bitcast<f32>(0x7fc00000u)) == false
// run: ge_f32(3.4e+38, -1.0) == true
// run: ge_f32(3.4e+38, 3.4e+38) == true
// run: ge_f32(3.4e+38, 1.5) == true
// run: ge_f32(bitcast<f32>(0x7f800000u), 0.0) == true
// run: ge_f32(bitcast<f32>(0x7f800000u), 0.5) == true
// run: ge_f32(bitcast<f32>(0x7f800000u), bitcast<f32>(0x7f800000u)) == true
// run: ge_f32(bitcast<f32>(0x7f800000u), 1.0000001) == true
// run: ge_f32(bitcast<f32>(0xff800000u), -0.0) == false
// run: ge_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0x000116c2u)) == false
// run: ge_f32(bitcast<f32>(0xff800000u), bitcast<f32>(0xff800000u)) == true
// run: ge_f32(bitcast<f32>(0x7fc00000u), 1.0) == false
// run: ge_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x800116c2u)) == false
// run: ge_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == false
// run: ge_f32(1.5, -1.0) == true
// run: ge_f32(1.5, 3.4e+38) == false
// run: ge_f32(1.5, 1.5) == true
// run: ge_f32(1.0000001, 0.0) == true
// run: ge_f32(1.0000001, 0.5) == true
// run: ge_f32(1.0000001, bitcast<f32>(0x7f800000u)) == false
// run: ge_f32(1.0000001, 1.0000001) == true

fn ge_f32_vec3(x: vec3<f32>, y: vec3<f32>) -> vec3<bool> { return x >= y; }
// run: ge_f32_vec3(vec3<f32>(0.0, -0.0, 1.0), vec3<f32>(-0.0, 1.0, -1.0)) == vec3<bool>(true, false, true)
// run: ge_f32_vec3(vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u)), vec3<f32>(-1.0, 0.5, bitcast<f32>(0x000116c2u))) == vec3<bool>(true, true, true)
// run: ge_f32_vec3(vec3<f32>(bitcast<f32>(0x800116c2u), 3.4e+38, bitcast<f32>(0x7f800000u)), vec3<f32>(bitcast<f32>(0x000116c2u), bitcast<f32>(0x800116c2u), 3.4e+38)) == vec3<bool>(false, true, true)

fn not_ge_f32(x: f32, y: f32) -> bool { return !(x >= y); }
// run: not_ge_f32(bitcast<f32>(0x7fc00000u), bitcast<f32>(0x7fc00000u)) == true
// run: not_ge_f32(bitcast<f32>(0x7fc00000u), 1.5) == true
// run: not_ge_f32(bitcast<f32>(0x7fc00000u), 1.0000001) == true
// run: not_ge_f32(1.5, bitcast<f32>(0x7fc00000u)) == true
// run: not_ge_f32(1.5, 1.5) == false
// run: not_ge_f32(1.5, 1.0000001) == false
// run: not_ge_f32(1.0000001, bitcast<f32>(0x7fc00000u)) == true
// run: not_ge_f32(1.0000001, 1.5) == true
// run: not_ge_f32(1.0000001, 1.0000001) == false
