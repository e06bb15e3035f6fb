// Chaitin and Briggs' colouring of the conflict graph, by one workgroup of 256 lanes; a lane owns every 256th object.
//
// Invariant: what a lane owns no other lane writes, and the two reductions are a minimum and a union, so one barrier a
// step is enough: of three slots one is used, one was read before the last barrier, one is made ready for the step
// after the next. And an object costs an invocation two steps of at most 8 of its own objects: with all that is
// around them, 41,000 turns of loops for 2,000 objects (docs/numerics.md, Turns of loops).

require NONE: u32;

/// Most objects.
const MAX_OBJECTS: u32 = 2000u;

/// Remaining conflicts of an object, then its channel; `NONE` once it is taken away, and until it is put back.
var<workgroup> vertex_state: array<u32, MAX_OBJECTS>;
/// Objects in the order in which they are taken away.
var<workgroup> stack: array<u32, MAX_OBJECTS>;
var<workgroup> slots: array<atomic<u32>, 3>;

fn in_conflict(a: u32, b: u32) -> bool {
    return ((conflict_bits[a * row_words() + b / 32u] >> (b % 32u)) & 1u) != 0u;
}

/// Leaves every object's channel, or `NONE`, in `vertex_state`.
fn colour_graph(lane: u32) {
    var best = NONE;
    for (var object = lane; object < params.objects; object += 256u) {
        var degree = 0u;
        for (var word = 0u; word < row_words(); word += 1u) {
            degree += countOneBits(conflict_bits[object * row_words() + word]);
        }
        vertex_state[object] = degree;
        best = min(best, (degree << 16u) | object);
    }
    if (lane < 3u) {
        atomicStore(&slots[lane], NONE);
    }
    workgroupBarrier();
    for (var step = 0u; step < params.objects; step += 1u) {
        atomicMin(&slots[step % 3u], best);
        workgroupBarrier();
        let taken = atomicLoad(&slots[step % 3u]) & 0xffffu;
        if (lane == 0u) {
            atomicStore(&slots[(step + 2u) % 3u], NONE);
            stack[step] = taken;
        }
        best = NONE;
        for (var object = lane; object < params.objects; object += 256u) {
            let degree = vertex_state[object];
            let gone = (degree == NONE) | (object == taken);
            let left = select(degree - select(0u, 1u, in_conflict(taken, object)), NONE, gone);
            vertex_state[object] = left;
            best = min(best, select((left << 16u) | object, NONE, gone));
        }
    }
    workgroupBarrier();
    if (lane < 3u) {
        atomicStore(&slots[lane], 0u);
    }
    workgroupBarrier();
    for (var step = 0u; step < params.objects; step += 1u) {
        let taken = stack[params.objects - 1u - step];
        var used = 0u;
        for (var object = lane; object < params.objects; object += 256u) {
            let channel = vertex_state[object];
            if ((channel != NONE) & in_conflict(taken, object)) {
                used |= 1u << channel;
            }
        }
        atomicOr(&slots[step % 3u], used);
        workgroupBarrier();
        let lowest = firstTrailingBit(~atomicLoad(&slots[step % 3u]));
        if (lane == 0u) {
            atomicStore(&slots[(step + 2u) % 3u], 0u);
        }
        if (lane == taken % 256u) {
            vertex_state[taken] = select(NONE, lowest, lowest < params.channels);
        }
    }
    workgroupBarrier();
}
