//! Pixel counts of instances and screen tiles: labels, histogram and mip levels of a hierarchical item buffer.
//!
//! Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU", section 3.2 and figure 4. `kernel.wgsl` states
//! the three outputs exactly. Bins are counted in workgroup memory, a tile of them at a time, and added to memory once
//! a workgroup. Invariant: counts are sums of atomic additions, so the order of the items, scattered or not, cannot
//! show.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces::{self, MAX_GROUPS};

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "item_histogram",
    summary: "number of pixels of every instance in every screen tile, with mip levels",
    citation: "Engelhardt and Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 3.2 and figure 4",
    programs: || {
        let ItemHistogram { memory, scattered } = ItemHistogram::new()?;
        Ok(memory.into_iter().chain(scattered).collect())
    },
    cases: cases::all,
};

/// Most items, and most bins, of one histogram: they fill a binding of 128 MiB.
pub const MAX_ITEMS: u32 = 1 << 25;

/// Item of a pixel that shows none, and its id.
pub const NOTHING: u32 = u32::MAX;

/// In which order items meet their bins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As they lie in memory: reads are contiguous, neighbours of one id meet in one bin.
    Memory,
    /// In the order of a bijective hash: reads are scattered, neighbours are not.
    Scattered,
}

/// A screen cut into 2^depth by 2^depth tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiling {
    /// Pixels a row, 1 to 65,535.
    pub width: u32,
    /// Rows, 1 to 65,535.
    pub height: u32,
    /// Logarithm of the number of tiles a side, at most 8.
    pub depth: u32,
}

/// Bits of [`item`] that are the instance.
pub const INSTANCE_BITS: u32 = 16;

/// The word of an item buffer for an instance of an object. The last instance of object 65,535 would be [`NOTHING`].
pub fn item(object: u16, instance: u16) -> u32 {
    u32::from(object) << INSTANCE_BITS | u32::from(instance)
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of ids.
        pub items: u32,
        /// Number of bins.
        pub bins: u32,
        /// Items a lane, at most 255.
        pub rounds: u32,
        /// Places in the order.
        pub places: u32,
        /// Logarithm of the places of a scattered order.
        pub bits: u32,
        /// Blocks of items.
        pub blocks: u32,
        /// Number of the first workgroup.
        pub first: u32,
    }

    /// Mirrors `struct Screen`.
    pub struct Screen {
        /// Pixels a row.
        pub width: u32,
        /// Rows.
        pub height: u32,
        /// Logarithm of the number of tiles a side.
        pub depth: u32,
        /// Number of objects.
        pub objects: u32,
        /// Bits of an item that are the instance.
        pub instance_bits: u32,
        /// Row of the first workgroup.
        pub first: u32,
    }

    /// Mirrors `struct Level`.
    pub struct Level {
        /// Bins of the coarse level.
        pub bins: u32,
        /// Logarithm of the side of a coarse block.
        pub depth: u32,
        /// Coarse bin of the first invocation.
        pub first: u32,
    }
}

bindings! {
    /// What `count` is given.
    pub struct Count {
        uniform params @ 0: Params,
        read ids @ 1: [u32],
        write counts @ 2: [u32],
    }

    /// What `weigh` is given.
    pub struct Weigh {
        uniform params @ 0: Params,
        read ids @ 1: [u32],
        write counts @ 2: [u32],
        read weights @ 10: [u32],
    }

    /// What `label` is given.
    pub struct Label {
        uniform screen @ 3: Screen,
        read items @ 4: [u32],
        read base @ 5: [u32],
        write labels @ 6: [u32],
    }

    /// What `halve` is given.
    pub struct Halve {
        uniform level @ 7: Level,
        read fine @ 8: [u32],
        write coarse @ 9: [u32],
    }
}

/// Invocations a workgroup.
const GROUP: u32 = 256;

/// Words of counts of a workgroup, by variant: few bins need little memory, many need all of it. A word counts two
/// bins.
const TILE_WORDS: [u32; 2] = [256, 4096];

/// The compiled kernel: for each order, one program for each of `TILE_WORDS`.
pub struct ItemHistogram {
    memory: [Arc<Program>; 2],
    scattered: [Arc<Program>; 2],
}

impl ItemHistogram {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let variant = |name: &str, words: u32, scattered: bool| {
            let defines = [Define::new("TILE_WORDS", format!("{words}u")), Define::new("SCATTERED", scattered)];
            let program = crate::program("item_histogram", &format!("{name}_{words}"), &defines)?;
            Count::check(&program, "count")?;
            Weigh::check(&program, "weigh")?;
            Label::check(&program, "label")?;
            Halve::check(&program, "halve")?;
            Ok::<_, Error>(program)
        };
        let [few, many] = TILE_WORDS;
        Ok(ItemHistogram {
            memory: [variant("memory", few, false)?, variant("memory", many, false)?],
            scattered: [variant("scattered", few, true)?, variant("scattered", many, true)?],
        })
    }

    /// Writes the id of every pixel: one word of `items` and of `labels` a pixel, one word of `base` an object. The
    /// lowest `instance_bits` of an item are its instance, the others its object: [`INSTANCE_BITS`] for words made by
    /// [`item`]; 31, with one base, for items that have no objects, such as clusters of triangles.
    pub fn record_labels(
        &self,
        job: &mut Job,
        tiling: Tiling,
        (items, instance_bits): (Buffer<[u32]>, u32),
        base: Buffer<[u32]>,
        labels: Buffer<[u32]>,
    ) -> Result<()> {
        let Tiling { width, height, depth } = tiling;
        let pixels = u64::from(width) * u64::from(height);
        let sides = 1..=MAX_GROUPS;
        if !sides.contains(&width) || !sides.contains(&height) || depth > 8 {
            let what = format!("a screen of {width} by {height} pixels in tiles of depth {depth}");
            return Err(Error::refused(what, "use 1 to 65,535 pixels a side and a depth of at most 8"));
        }
        if !(1..=31).contains(&instance_bits) {
            let what = format!("items with {instance_bits} bits of instance");
            return Err(Error::refused(what, "use 1 to 31 bits"));
        }
        if items.len() < pixels || labels.len() < pixels {
            let what = format!("{} items and {} labels for {pixels} pixels", items.len(), labels.len());
            return Err(Error::refused(what, "give one word a pixel"));
        }
        let objects = base.len() as u32;
        let program = job.program(&self.memory[0]);
        pieces::record(job, height, u64::from(2 * width), |job, rows| {
            let screen = Screen { width, height, depth, objects, instance_bits, first: rows.start };
            let screen = job.value("screen", &screen);
            let bound = Label { screen, items, base, labels };
            job.launch(program, "label", &bound, [width.div_ceil(GROUP), rows.len() as u32, 1]);
        });
        Ok(())
    }

    /// Adds to `counts`, one word for each of `bins` bins, how often each id occurs among the first `items` of `ids`.
    pub fn record_counts(
        &self,
        job: &mut Job,
        order: Order,
        (items, ids): (u32, Buffer<[u32]>),
        (bins, counts): (u32, Buffer<[u32]>),
    ) -> Result<()> {
        check((items, ids.len()), (bins, counts.len()))?;
        let size = usize::from(bins > 2 * TILE_WORDS[0]);
        let words = TILE_WORDS[size];
        let (program, places, bits) = self.ordered(order, size, items);
        // Four items for each word that a workgroup clears and adds, and 16 for each lane at least.
        let rounds = (4 * words / GROUP).max(16);
        let blocks = places.div_ceil(GROUP * rounds).max(1);
        let groups = blocks * bins.div_ceil(2 * words);
        let program = job.program(program);
        pieces::record(job, groups, u64::from(GROUP * rounds + 4 * words), |job, piece| {
            let params = Params { items, bins, rounds, places, bits, blocks, first: piece.start };
            let bound = Count { params: job.value("histogram params", &params), ids, counts };
            job.launch(program, "count", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// Adds to `sums`, one word for each of `bins` bins, the weights of each id's items among the first `items` of
    /// `ids`, modulo 2^32: `weights` has a word an item.
    pub fn record_weights(
        &self,
        job: &mut Job,
        order: Order,
        (items, [ids, weights]): (u32, [Buffer<[u32]>; 2]),
        (bins, sums): (u32, Buffer<[u32]>),
    ) -> Result<()> {
        check((items, ids.len().min(weights.len())), (bins, sums.len()))?;
        let (program, places, bits) = self.ordered(order, 0, items);
        let program = job.program(program);
        pieces::record(job, places.div_ceil(GROUP), u64::from(4 * GROUP), |job, piece| {
            let params = Params { items, bins, rounds: 1, places, bits, blocks: 1, first: piece.start };
            let bound = Weigh { params: job.value("histogram params", &params), ids, counts: sums, weights };
            job.launch(program, "weigh", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// The program of an order, its places, and the logarithm of their number where it is a power of two.
    fn ordered(&self, order: Order, size: usize, items: u32) -> (&Arc<Program>, u32, u32) {
        match order {
            Order::Memory => (&self.memory[size], items, 0),
            Order::Scattered => {
                let places = items.next_power_of_two();
                (&self.scattered[size], places, places.trailing_zeros())
            }
        }
    }

    /// Sums a histogram of blocks of 2^depth by 2^depth bins level by level; the last level has one bin a block.
    /// Yields the levels above `counts`, finest first.
    pub fn record_mips(
        &self,
        job: &mut Job,
        depth: u32,
        blocks: u32,
        counts: Buffer<[u32]>,
    ) -> Result<Vec<Buffer<[u32]>>> {
        let bins = |depth: u32| u64::from(blocks) << (2 * depth);
        if depth > 8 || blocks == 0 || bins(depth) > u64::from(MAX_ITEMS) || counts.len() < bins(depth) {
            let what = format!("mip levels of {blocks} blocks of depth {depth} from {} bins", counts.len());
            return Err(Error::refused(what, format!("use a depth of at most 8 and at most {MAX_ITEMS} bins")));
        }
        let program = job.program(&self.memory[0]);
        let mut fine = counts;
        let mut levels = Vec::new();
        for depth in (0..depth).rev() {
            let coarse = job.zeroed("histogram level", bins(depth));
            let bins = bins(depth) as u32;
            pieces::record(job, bins.div_ceil(GROUP), u64::from(5 * GROUP), |job, piece| {
                let level = job.value("level", &Level { bins, depth, first: piece.start * GROUP });
                job.launch(program, "halve", &Halve { level, fine, coarse }, [piece.len() as u32, 1, 1]);
            });
            levels.push(coarse);
            fine = coarse;
        }
        Ok(levels)
    }
}

fn check((items, ids): (u32, u64), (bins, counts): (u32, u64)) -> Result<()> {
    if items > MAX_ITEMS || bins > MAX_ITEMS || ids < u64::from(items) || counts < u64::from(bins) {
        let what = format!("a histogram of {items} of {ids} ids in {bins} of {counts} bins");
        return Err(Error::refused(what, format!("use at most {MAX_ITEMS} ids and bins, and one word for each")));
    }
    Ok(())
}
