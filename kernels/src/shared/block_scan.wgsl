// Exclusive prefix sums of 1024 values in a workgroup of 256 lanes, modulo 2^32.
//
// The step is the same at three scales: a lane sums four values, then four lanes, sixteen, sixty-four and all. Radix 4
// (Kogge and Stone 1973 has radix 2) halves the barriers. Zeros below lane 0 stand for lanes that do not exist, so no
// step has a branch, and every access but the four neighbours of a lane is contiguous over the lanes.

/// Zeros below lane 0: three lanes of the longest reach.
const LADDER_ZEROS: u32 = 192u;
/// One side of the ladder; a step writes one side while slow lanes still read the other.
const LADDER_SIDE: u32 = 448u;

var<workgroup> block_values: array<u32, 1024>;
var<workgroup> block_ladder: array<u32, 896>;

/// Sums of the first one, two, three and four components.
fn prefix4(v: vec4<u32>) -> vec4<u32> {
    let xy = v.x + v.y;
    let xyz = xy + v.z;
    return vec4<u32>(v.x, xy, xyz, xyz + v.w);
}

/// Sum over `4 * reach` lanes up to `lane`, from sums over `reach` lanes each.
fn ladder_step(lane: u32, side: u32, reach: u32, sum: u32) -> u32 {
    let place = side + LADDER_ZEROS + lane;
    block_ladder[place] = sum;
    workgroupBarrier();
    return sum + block_ladder[place - reach] + block_ladder[place - 2u * reach] + block_ladder[place - 3u * reach];
}

/// Component c of lane l is value number `256 * c + l`; each is answered by the sum of those before it.
/// Every lane of the workgroup must call it. It may be called again at once.
fn block_scan(lane: u32, values: vec4<u32>) -> vec4<u32> {
    block_values[lane] = values.x;
    block_values[lane + 256u] = values.y;
    block_values[lane + 512u] = values.z;
    block_values[lane + 768u] = values.w;
    if (lane < LADDER_ZEROS) {
        block_ladder[lane] = 0u;
        block_ladder[lane + LADDER_SIDE] = 0u;
    }
    workgroupBarrier();

    let first = 4u * lane;
    let quad = prefix4(vec4<u32>(block_values[first], block_values[first + 1u], block_values[first + 2u],
        block_values[first + 3u]));
    var sum = ladder_step(lane, 0u, 1u, quad.w);
    sum = ladder_step(lane, LADDER_SIDE, 4u, sum);
    sum = ladder_step(lane, 0u, 16u, sum);
    sum = ladder_step(lane, LADDER_SIDE, 64u, sum);

    let before = sum - quad.w;
    block_values[first] = before;
    block_values[first + 1u] = before + quad.x;
    block_values[first + 2u] = before + quad.y;
    block_values[first + 3u] = before + quad.z;
    workgroupBarrier();
    return vec4<u32>(block_values[lane], block_values[lane + 256u], block_values[lane + 512u],
        block_values[lane + 768u]);
}

/// The same by rows: component c of lane l is column l of row c, and answered by the sum of those before it in its row,
/// with `left`, one value a row, added. Every lane of the workgroup must call it. It may be called again at once.
fn row_scans(lane: u32, values: vec4<u32>, left: vec4<u32>) -> vec4<u32> {
    let before = block_scan(lane, values);
    // A row is 64 lanes' sums of four. Its side of the ladder keeps them until the second barrier of the next call.
    let row = LADDER_SIDE + LADDER_ZEROS + 63u;
    let sums = prefix4(vec4<u32>(block_ladder[row], block_ladder[row + 64u], block_ladder[row + 128u], 0u));
    return before + (left - vec4<u32>(0u, sums.xyz));
}
