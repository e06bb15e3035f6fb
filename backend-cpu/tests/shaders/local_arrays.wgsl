// Arrays in function memory with computed indices: insertion sort, each invocation its own data.
//! buffer 0: zero 24
//! dispatch: main 1 1 1
//! expect 0: u32 0 1 2 4 5 7 1 1 3 3 5 7 0 1 2 5 6 7 1 1 3 5 5 7

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

struct Item {
    key: u32,
    weight: vec2<u32>,
}

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) i: u32) {
    var items: array<Item, 6>;
    for (var k = 0u; k < 6u; k++) {
        let key = (k * 5u + i * k * k + 3u * i) % 8u;
        items[k] = Item(key, vec2(k, key));
    }
    for (var k = 1u; k < 6u; k++) {
        let moving = items[k];
        var at = k;
        while at > 0u && items[at - 1u].key > moving.key {
            items[at] = items[at - 1u];
            at--;
        }
        items[at] = moving;
    }
    for (var k = 0u; k < 6u; k++) {
        out[6u * i + k] = select(99u, items[k].key, items[k].weight.y == items[k].key);
    }
}
