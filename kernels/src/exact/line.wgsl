// Lines of the source plane under test: slivers, samples on the line, offsets on the boundaries of cells.

import package::exact::kernel::{emit, emit2, end_input, finish, first_input, noise, raw};
import package::shared::line::{Line, edge_line, half_plane, line_flip};
import package::shared::line_cell::{CELL_ALL, CELL_NONE, line_cell, line_cell_fast};
import package::shared::wide::{abs64, add64, imul_wide, ltu64, neg64, shl64, shr64, sub64, uabs, umul_wide};

/// A point of the grid from words k to k + 2, its bits flipped by `flips`.
fn grid_point(i: u32, k: u32, flips: vec3<u32>) -> vec3<i32> {
    let v = (vec3<u32>(raw(i, k), raw(i, k + 1u), raw(i, k + 2u)) ^ flips) & vec3<u32>(0x7fffu);
    return bitcast<vec3<i32>>(v) - vec3<i32>(0x4000, 0x4000, 0);
}

/// The line of an edge; in one of four inputs its ends are equal, or neighbours on the grid.
fn grid_line(i: u32) -> Line {
    let p = noise(i, 0u);
    let sliver = (p & 3u) == 0u;
    let flips = select(vec3<u32>(0u), vec3<u32>((p >> 2u) & 1u, (p >> 3u) & 1u, (p >> 4u) & 1u), sliver);
    let second = select(6u, 3u, sliver);
    return edge_line(grid_point(i, 0u, vec3<u32>(0u)), grid_point(i, 3u, vec3<u32>(0u)), grid_point(i, second, flips));
}

fn negated(ln: Line) -> Line {
    return Line(0 - ln.a, 0 - ln.b, neg64(ln.c));
}

/// Any word but -2^31.
fn coefficient(x: u32) -> i32 {
    return max(bitcast<i32>(x), -0x7fffffff);
}

/// -1, 0, 1 or 2 as 64 bits.
fn small64(p: u32) -> vec2<u32> {
    let x = (p & 3u) - 1u;
    return vec2<u32>(x, 0u - (x >> 31u));
}

struct Side {
    ln: Line,
    u: i32,
    v: i32,
}

/// A line and a sample of [-2^30, 2^30)^2; in three of four inputs the value at the sample is -1 to 2.
fn side(i: u32) -> Side {
    let p = noise(i, 0u);
    let a = coefficient(raw(i, 0u));
    let b = coefficient(raw(i, 1u));
    let u = bitcast<i32>(raw(i, 2u)) >> 1u;
    let v = bitcast<i32>(raw(i, 3u)) >> 1u;
    let near = sub64(small64(p >> 2u), add64(imul_wide(a, u), imul_wide(b, v)));
    let any = vec2<u32>(raw(i, 4u), bitcast<u32>(bitcast<i32>(raw(i, 5u)) >> 1u));
    return Side(Line(a, b, select(near, any, (p & 3u) == 0u)), u, v);
}

struct Lookup {
    ln: Line,
    h: u32,
    k: u32,
}

/// A line and the sizes of a table; in three of four inputs it crosses the square, and where word 2 is a power of two
/// its offset is next to a cell's boundary.
fn lookup(i: u32, shift: u32) -> Lookup {
    let p = noise(i, 0u);
    let q = noise(i, 1u);
    let h = q % 16u;
    let k = (q >> 8u) % 15u;
    let a = coefficient(raw(i, 0u)) >> shift;
    let b = coefficient(raw(i, 1u)) >> shift;
    let inside = add64(shr64(umul_wide(uabs(a) + uabs(b), raw(i, 2u)), 32u - h), small64(p >> 2u));
    let c = select(inside, vec2<u32>(raw(i, 2u), raw(i, 3u)), (p & 3u) == 0u);
    return Lookup(Line(a, b, select(c, neg64(c), (p & 16u) != 0u)), h, k);
}

/// Whether a cell is one that `line_cell_fast` may return for a line with |a|, |b| <= 2^30.
fn admissible(p: Lookup, cell: u32) -> bool {
    let ab = uabs(p.ln.b);
    let n1 = uabs(p.ln.a) + ab;
    let ac = abs64(p.ln.c);
    let negative = (p.ln.c.y >> 31u) != 0u;
    if (cell >= CELL_NONE) {
        return !ltu64(ac, shl64(vec2<u32>(n1, 0u), p.h)) & ((cell == CELL_NONE) == negative);
    }
    let flip = line_flip(p.ln);
    let quadrant = ((p.ln.b < 0) != flip) & (p.ln.b != 0);
    let named = (cell >> 31u == u32(flip)) & ((cell >> (2u * p.k + 1u)) & 1u) == u32(quadrant);
    // The slack is 2^-s of a cell; both axes are compared in units of 2^-(k + s).
    let s = min(10u, 16u - p.k);
    let low = ((cell >> (p.k + 1u)) & ((1u << p.k) - 1u)) << s;
    let b_scaled = shl64(vec2<u32>(ab, 0u), p.k + s);
    let least = umul_wide(n1, max(low, 1u) - 1u);
    let direction = !ltu64(b_scaled, least) & !ltu64(umul_wide(n1, low + (1u << s) + 1u), b_scaled);
    // What the offset exceeds the widened cell's low end by must be within its width.
    let start = bitcast<i32>((cell & ((2u << p.k) - 1u)) - (1u << p.k)) * bitcast<i32>(1u << s) - 1;
    let reach = shl64(umul_wide(n1, uabs(start)), p.h);
    let c_scaled = shl64(select(p.ln.c, neg64(p.ln.c), flip), p.k + s);
    let excess = sub64(c_scaled, select(reach, neg64(reach), start < 0));
    let width = shl64(umul_wide(n1, (1u << s) + 2u), p.h);
    let near = ltu64(ac, shl64(vec2<u32>(n1, 0u), p.h + 1u));
    return named & direction & near & !ltu64(width, excess);
}

/// A neighbour of a cell, or the cell itself.
fn displaced(cell: u32, k: u32, p: u32) -> u32 {
    let offset = (cell + (p & 3u) - 1u) & ((2u << k) - 1u);
    let direction = ((cell >> (k + 1u)) + ((p >> 2u) & 3u) - 1u) & ((1u << k) - 1u);
    let names = (cell >> (2u * k + 1u)) << (2u * k + 1u);
    return select(names | (direction << (k + 1u)) | offset, cell ^ (p & 1u), cell >= CELL_NONE);
}

@compute @workgroup_size(256)
fn test_edge_line(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let ln = grid_line(i);
        sum += emit(i, vec4<u32>(bitcast<u32>(ln.a), bitcast<u32>(ln.b), ln.c));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_half_plane(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = side(i);
        sum += emit2(i, vec2<u32>(u32(half_plane(p.ln, p.u, p.v)), u32(half_plane(negated(p.ln), p.u, p.v))));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_line_cell(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = lookup(i, 0u);
        sum += emit2(i, vec2<u32>(line_cell(p.ln, p.h, p.k), line_cell(negated(p.ln), p.h, p.k)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_line_cell_fast(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = lookup(i, 1u);
        let fast = admissible(p, line_cell_fast(p.ln, p.h, p.k));
        let near = admissible(p, displaced(line_cell(p.ln, p.h, p.k), p.k, noise(i, 2u)));
        sum += emit2(i, vec2<u32>(u32(fast), u32(near)));
    }
    finish(group.x, sum);
}
