// Pixel counts of instances and screen tiles: the hierarchical item buffer.
//
// Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 3.2 and figure 4; the
// histogram by scatter is Scheuermann and Hensley, "Efficient Histogram Generation Using Scattering on GPUs" (I3D
// 2007).
//
// `label` writes the id of every pixel of an item buffer: with the screen cut into 2^t by 2^t tiles and (x, y) the tile
// of the pixel,
//
//     id = base[object] + instance * 2^(2t) + x + y * 2^t,
//
// and 0xffffffff for the background and for objects without a base. An item has its instance in its lowest bits, 1 to
// 31 of them, and its object above; with 31 bits and one base, items of any meaning are spread over the tiles. `count`
// adds to counts[id], for id < bins, the number of times that id occurs; other ids are ignored. `weigh` adds to
// counts[id] the weights of its items instead, modulo 2^32 (section 5: visibility that is not binary). `halve` makes
// blocks of s by s bins from blocks of 2s by 2s, each bin the sum of its four children: the next mip level, as sums.

import package::shared::permute::permute;

/// Words of counts of one workgroup, a power of two; 4096 fill its 16 KiB of memory. A word counts two bins of the
/// tile, b and b + TILE_WORDS, in 16 bits each: a workgroup must take fewer than 65,536 items.
const TILE_WORDS: u32 = 4096u;
/// Whether items are taken in a scattered order, so that neighbours of one id do not meet in one bin.
const SCATTERED: bool = false;
/// A pixel of no item.
const NOTHING: u32 = 0xffffffffu;

struct Params {
    items: u32,
    bins: u32,
    /// Items a lane, at most 255.
    rounds: u32,
    /// Places in the order: `items`, or the power of two above it when scattered.
    places: u32,
    /// Logarithm of that power of two.
    bits: u32,
    /// Blocks of items; workgroup `tile * blocks + block` counts a block into a tile of bins.
    blocks: u32,
    /// Number of the first workgroup.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> ids: array<u32>;
@group(0) @binding(2) var<storage, read_write> counts: array<atomic<u32>>;

var<workgroup> tile: array<atomic<u32>, TILE_WORDS>;

/// The item at a place of the order.
fn item_at(place: u32) -> u32 {
    if (SCATTERED) {
        return permute(place, params.bits);
    }
    return place;
}

fn add_to_bin(bin: u32, found: u32) {
    if (found != 0u) {
        if (bin < params.bins) {
            atomicAdd(&counts[bin], found);
        }
    }
}

@compute @workgroup_size(256)
fn count(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = params.first + group.x;
    let first_bin = number / params.blocks * (2u * TILE_WORDS);
    for (var row = 0u; row < TILE_WORDS; row += 256u) {
        atomicStore(&tile[row + lane], 0u);
    }
    workgroupBarrier();
    let first_place = number % params.blocks * params.rounds * 256u + lane;
    for (var round = 0u; round < params.rounds; round += 1u) {
        let place = first_place + round * 256u;
        if (place < params.places) {
            let item = item_at(place);
            if (item < params.items) {
                let bin = ids[item] - first_bin;
                if (bin < 2u * TILE_WORDS) {
                    atomicAdd(&tile[bin & (TILE_WORDS - 1u)], select(1u, 0x10000u, bin >= TILE_WORDS));
                }
            }
        }
    }
    workgroupBarrier();
    for (var row = 0u; row < TILE_WORDS; row += 256u) {
        let found = atomicLoad(&tile[row + lane]);
        let bin = first_bin + row + lane;
        add_to_bin(bin, found & 0xffffu);
        add_to_bin(bin + TILE_WORDS, found >> 16u);
    }
}

@group(0) @binding(10) var<storage, read> weights: array<u32>;

@compute @workgroup_size(256)
fn weigh(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let place = (params.first + group.x) * 256u + lane;
    if (place < params.places) {
        let item = item_at(place);
        if (item < params.items) {
            let bin = ids[item];
            if (bin < params.bins) {
                atomicAdd(&counts[bin], weights[item]);
            }
        }
    }
}

struct Screen {
    width: u32,
    height: u32,
    /// Logarithm of the number of tiles a side.
    depth: u32,
    objects: u32,
    /// Bits of an item that are the instance.
    instance_bits: u32,
    /// Row of the first workgroup.
    first: u32,
}

@group(0) @binding(3) var<uniform> screen: Screen;
/// Object in the upper bits of a word, instance in the lower; `NOTHING` for the background.
@group(0) @binding(4) var<storage, read> items: array<u32>;
@group(0) @binding(5) var<storage, read> base: array<u32>;
@group(0) @binding(6) var<storage, read_write> labels: array<u32>;

/// A row of workgroups takes a row of the screen.
@compute @workgroup_size(256)
fn label(@builtin(global_invocation_id) invocation: vec3<u32>) {
    let pixel = vec2<u32>(invocation.x, screen.first + invocation.y);
    if (pixel.x >= screen.width) {
        return;
    }
    let place = pixel.y * screen.width + pixel.x;
    let item = items[place];
    let object = item >> screen.instance_bits;
    var id = NOTHING;
    if (item != NOTHING && object < screen.objects) {
        let x = (pixel.x << screen.depth) / screen.width;
        let y = (pixel.y << screen.depth) / screen.height;
        let instance = item & ((1u << screen.instance_bits) - 1u);
        id = base[object] + (instance << (2u * screen.depth)) + x + (y << screen.depth);
    }
    labels[place] = id;
}

struct Level {
    /// Bins of the coarse level.
    bins: u32,
    /// Logarithm of the side of a coarse block.
    depth: u32,
    /// Coarse bin of the first invocation.
    first: u32,
}

@group(0) @binding(7) var<uniform> level: Level;
@group(0) @binding(8) var<storage, read> fine: array<u32>;
@group(0) @binding(9) var<storage, read_write> coarse: array<u32>;

@compute @workgroup_size(256)
fn halve(@builtin(global_invocation_id) id: vec3<u32>) {
    let bin = level.first + id.x;
    if (bin >= level.bins) {
        return;
    }
    let side = 1u << level.depth;
    let block = bin >> (2u * level.depth);
    let x = bin & (side - 1u);
    let y = (bin >> level.depth) & (side - 1u);
    let at = (block << (2u * level.depth + 2u)) + y * 4u * side + 2u * x;
    coarse[bin] = fine[at] + fine[at + 1u] + fine[at + 2u * side] + fine[at + 2u * side + 1u];
}
