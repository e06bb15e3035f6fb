// Pointers to variables, elements and members as arguments; private variables are each invocation's own.
//! buffer 0: zero 24
//! dispatch: main 1 1 1
//! expect 0: u32 0 100 7 0 1 101 7 10 2 102 7 20 3 103 7 30 4 104 7 40 5 105 7 50

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

struct Pair {
    first: u32,
    second: array<u32, 4>,
}

var<private> calls: u32 = 5u;

fn bump(x: ptr<function, u32>, by: u32) -> u32 {
    let old = *x;
    *x += by;
    calls += 1u;
    return old;
}

fn assign(a: ptr<function, array<u32, 4>>, i: u32, v: u32) {
    (*a)[i] = v;
}

fn exchange(a: ptr<function, u32>, b: ptr<function, u32>) {
    let t = *a;
    *a = *b;
    *b = t;
}

fn through_private(p: ptr<private, u32>) -> u32 {
    *p += 1u;
    return *p;
}

@compute @workgroup_size(6)
fn main(@builtin(local_invocation_index) i: u32) {
    var pair: Pair;
    pair.first = i;
    assign(&pair.second, i % 4u, 10u * i);
    let element = &pair.second[i % 4u];
    var x = bump(&pair.first, 100u);
    var y = *element;
    exchange(&x, &y);
    exchange(&y, &x);
    out[4u * i] = x;
    out[4u * i + 1u] = pair.first;
    out[4u * i + 2u] = through_private(&calls);
    out[4u * i + 3u] = y;
}
