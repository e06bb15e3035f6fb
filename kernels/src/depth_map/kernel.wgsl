// Vertex visibility by depth maps: the bits of what the maps show, vertex by vertex, and how far two results differ.
//
// Sattler et al. 2004, sections 3.1 and 3.2: for each light an orthographic depth map, then every
// vertex against it as a point, with an offset. `raster` draws the maps and tests the points, one row of bits a
// direction; here the rows become words of the visibility matrix. `collect` sets bit i of `occluded[row + vertex]` if
// bit `vertex` of row i of `seen` is not set; other bits are left as they are. `differ` adds to `differing[0]` how many
// bits of two matrices differ.

struct Params {
    /// Vertices of `collect`, words of `differ`.
    count: u32,
    /// Directions, up to 32, and words from one row to the next.
    rows: u32,
    stride: u32,
    /// Word of the first vertex.
    row: u32,
    /// Vertex or word of the first invocation.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> seen: array<u32>;
@group(0) @binding(2) var<storage, read_write> occluded: array<u32>;
@group(0) @binding(3) var<storage, read> one: array<u32>;
@group(0) @binding(4) var<storage, read> other: array<u32>;
@group(0) @binding(5) var<storage, read_write> differing: array<atomic<u32>>;

@compute @workgroup_size(256)
fn collect(@builtin(global_invocation_id) id: vec3<u32>) {
    let vertex = params.first + id.x;
    if (vertex >= params.count) {
        return;
    }
    var word = 0u;
    for (var i = 0u; i < params.rows; i += 1u) {
        let bits = seen[i * params.stride + vertex / 32u];
        word |= (1u - ((bits >> (vertex % 32u)) & 1u)) << i;
    }
    occluded[params.row + vertex] |= word;
}

@compute @workgroup_size(256)
fn differ(@builtin(global_invocation_id) id: vec3<u32>) {
    let word = params.first + id.x;
    if (word >= params.count) {
        return;
    }
    let bits = countOneBits(one[word] ^ other[word]);
    if (bits != 0u) {
        atomicAdd(&differing[0], bits);
    }
}
