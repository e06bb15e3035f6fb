//! Typed bindings in plain Rust: structs whose bytes are WGSL bytes, and binding lists that cannot forget a buffer.
//!
//! [`host!`](crate::host!) declares a `#[repr(C)]` struct and records the name, offset and size of each field;
//! [`bindings!`](crate::bindings!) declares what one entry point is given. Both are checked, name by name and offset
//! by offset, against naga's own layout of the program ([`Bindings::check`]), so a field moved on one side only is an
//! error before anything runs. A binding left out is a missing struct field: a compile error.
//!
//! ```
//! use sightlines_backend::host::{Bindings, Buffer};
//! use sightlines_backend::{Job, Program, bindings, host};
//!
//! host! {
//!     /// Mirrors `struct Params`.
//!     pub struct Params {
//!         /// Number of words.
//!         pub count: u32,
//!         /// Added to each word.
//!         pub bias: u32,
//!     }
//! }
//!
//! bindings! {
//!     /// What `main` is given.
//!     pub struct AddBias {
//!         uniform params @ 0: Params,
//!         read input @ 1: [u32],
//!         write output @ 2: [u32],
//!     }
//! }
//!
//! let wgsl = "
//!     struct Params { count: u32, bias: u32 }
//!     @group(0) @binding(0) var<uniform> params: Params;
//!     @group(0) @binding(1) var<storage, read> input: array<u32>;
//!     @group(0) @binding(2) var<storage, read_write> output: array<u32>;
//!     @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
//!         if id.x < params.count { output[id.x] = input[id.x] + params.bias; }
//!     }
//! ";
//! let program = Program::new("add", "add.wgsl", &|path| (path == "add.wgsl").then(|| wgsl.to_owned()), &[])?;
//! AddBias::check(&program, "main")?;
//!
//! let mut job = Job::new();
//! let id = job.program(&program);
//! let bound = AddBias {
//!     params: job.value("params", &Params { count: 3, bias: 7 }),
//!     input: job.slice("input", &[1_u32, 2, 3]),
//!     output: job.zeroed("output", 3),
//! };
//! job.launch(id, "main", &bound, [1, 1, 1]);
//! job.read("output", bound.output.id());
//! # sightlines_backend::check::job(&job)?;
//! # Ok::<(), sightlines_backend::Error>(())
//! ```
//!
//! The crate that calls [`host!`](crate::host!) needs `bytemuck` (feature `derive`) among its own dependencies.

mod compare;

use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

use crate::{Access, BufferId, Command, Dispatch, Groups, Job, Program, ProgramId, Result, Slot};

/// A scalar that host and kernel may share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// `u32` or `atomic<u32>`.
    U32,
    /// `i32` or `atomic<i32>`.
    I32,
    /// `f32`.
    F32,
}

/// The shape of a type in memory, as Rust lays it out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A scalar.
    Scalar(Scalar),
    /// A vector of 2 to 4 components.
    Vector {
        /// Type of a component.
        scalar: Scalar,
        /// Number of components.
        lanes: u32,
    },
    /// A column-major matrix.
    Matrix {
        /// Type of a component.
        scalar: Scalar,
        /// Number of columns.
        columns: u32,
        /// Number of rows.
        rows: u32,
    },
    /// An array of a fixed length.
    Array {
        /// Shape of an element.
        element: &'static Shape,
        /// Number of elements.
        count: u32,
        /// Bytes from one element to the next.
        stride: u32,
    },
    /// A struct.
    Struct {
        /// Name in Rust.
        name: &'static str,
        /// Its fields, in order.
        fields: &'static [Field],
        /// Size in bytes.
        size: u32,
    },
}

/// A field of a [`Shape::Struct`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Name. A name that begins with `_` is padding and has no counterpart in WGSL.
    pub name: &'static str,
    /// First byte.
    pub offset: u32,
    /// Bytes.
    pub size: u32,
    /// Shape of its type.
    pub shape: &'static Shape,
}

/// A plain type whose bytes are the bytes of a WGSL type. Structs get it from [`host!`](crate::host!).
pub trait Host: bytemuck::Pod {
    /// Its layout in Rust.
    const SHAPE: Shape;
}

macro_rules! host_types {
    ($($ty:ty = $shape:expr;)*) => { $(impl Host for $ty { const SHAPE: Shape = $shape; })* };
}

host_types! {
    u32 = Shape::Scalar(Scalar::U32);
    i32 = Shape::Scalar(Scalar::I32);
    f32 = Shape::Scalar(Scalar::F32);
    glam::UVec2 = Shape::Vector { scalar: Scalar::U32, lanes: 2 };
    glam::UVec3 = Shape::Vector { scalar: Scalar::U32, lanes: 3 };
    glam::UVec4 = Shape::Vector { scalar: Scalar::U32, lanes: 4 };
    glam::IVec2 = Shape::Vector { scalar: Scalar::I32, lanes: 2 };
    glam::IVec3 = Shape::Vector { scalar: Scalar::I32, lanes: 3 };
    glam::IVec4 = Shape::Vector { scalar: Scalar::I32, lanes: 4 };
    glam::Vec2 = Shape::Vector { scalar: Scalar::F32, lanes: 2 };
    glam::Vec3 = Shape::Vector { scalar: Scalar::F32, lanes: 3 };
    glam::Vec4 = Shape::Vector { scalar: Scalar::F32, lanes: 4 };
    glam::Mat4 = Shape::Matrix { scalar: Scalar::F32, columns: 4, rows: 4 };
}

impl<T: Host, const N: usize> Host for [T; N]
where
    [T; N]: bytemuck::Pod,
{
    const SHAPE: Shape = Shape::Array { element: &T::SHAPE, count: N as u32, stride: size_of::<T>() as u32 };
}

/// What a buffer holds: one value (`T`), or as many as fit (`[T]`, a runtime-sized array).
pub trait Contents {
    /// Its layout in Rust.
    const EXTENT: Extent;
}

/// How many values a buffer holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// One value.
    One(Shape),
    /// A runtime-sized array.
    Many {
        /// Shape of an element.
        element: Shape,
        /// Bytes from one element to the next.
        stride: u32,
    },
}

impl<T: Host> Contents for T {
    const EXTENT: Extent = Extent::One(T::SHAPE);
}

impl<T: Host> Contents for [T] {
    const EXTENT: Extent = Extent::Many { element: T::SHAPE, stride: size_of::<T>() as u32 };
}

/// A range of a job's buffer that holds `T`: a binding's worth of typed bytes.
pub struct Buffer<T: ?Sized> {
    id: BufferId,
    offset: u64,
    size: u64,
    contents: PhantomData<fn(&T)>,
}

impl<T: ?Sized> Clone for Buffer<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: ?Sized> Copy for Buffer<T> {}

impl<T: ?Sized> fmt::Debug for Buffer<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Buffer({}, bytes {}..{})", self.id.0, self.offset, self.offset.saturating_add(self.size))
    }
}

impl<T: ?Sized> Buffer<T> {
    /// Gives a type to `size` bytes of a buffer, from `offset`, a multiple of 256.
    pub fn from_raw(id: BufferId, offset: u64, size: u64) -> Self {
        Buffer { id, offset, size, contents: PhantomData }
    }

    /// The buffer.
    pub fn id(&self) -> BufferId {
        self.id
    }

    /// Bytes.
    pub fn size(&self) -> u64 {
        self.size
    }

    /// The same range, bound to `@group(group) @binding(binding)`.
    pub fn slot(&self, group: u32, binding: u32) -> Slot {
        Slot { group, binding, buffer: self.id, offset: self.offset, size: self.size }
    }
}

impl<T: Host> Buffer<[T]> {
    /// Whole elements that fit.
    pub fn len(&self) -> u64 {
        self.size / size_of::<T>() as u64
    }

    /// Whether no element fits.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Some of the elements; a device wants its first byte at a multiple of 256. Ranges past the end are caught by
    /// [`crate::check`].
    #[must_use]
    pub fn elements(&self, range: Range<u64>) -> Self {
        let size = size_of::<T>() as u64;
        let offset = self.offset.saturating_add(range.start.saturating_mul(size));
        Self::from_raw(self.id, offset, range.end.saturating_sub(range.start).saturating_mul(size))
    }

    /// The first element, for a binding that wants one value.
    #[must_use]
    pub fn first(&self) -> Buffer<T> {
        Buffer::from_raw(self.id, self.offset, size_of::<T>() as u64)
    }
}

/// One binding that a [`bindings!`](crate::bindings!) struct declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Declared {
    /// Name, equal to the WGSL variable's.
    pub name: &'static str,
    /// `@group`.
    pub group: u32,
    /// `@binding`.
    pub binding: u32,
    /// How the kernel uses it.
    pub access: Access,
    /// What it holds.
    pub extent: Extent,
}

/// The typed bindings of an entry point. [`bindings!`](crate::bindings!) implements it.
pub trait Bindings {
    /// Name of the Rust struct, for messages.
    const NAME: &'static str;
    /// Every binding.
    const DECLARED: &'static [Declared];

    /// One slot for each binding, in the order of [`Bindings::DECLARED`].
    fn slots(&self) -> Vec<Slot>;

    /// Checks names, numbers, access, field names, offsets, sizes and strides against what `entry` of `program` uses.
    /// All differences are reported at once.
    fn check(program: &Program, entry: &str) -> Result<()> {
        compare::entry(Self::NAME, Self::DECLARED, program, entry)
    }
}

impl Job {
    /// Adds a buffer that holds one value, uploaded by the current recording.
    pub fn value<T: Host>(&mut self, label: impl Into<String>, value: &T) -> Buffer<T> {
        let id = self.upload(label, std::slice::from_ref(value));
        Buffer::from_raw(id, 0, self.size(id))
    }

    /// Adds a buffer that holds `data`, uploaded by the current recording.
    pub fn slice<T: Host>(&mut self, label: impl Into<String>, data: &[T]) -> Buffer<[T]> {
        let id = self.upload(label, data);
        Buffer::from_raw(id, 0, self.size(id))
    }

    /// Adds a buffer of `len` elements, all zero.
    pub fn zeroed<T: Host>(&mut self, label: impl Into<String>, len: u64) -> Buffer<[T]> {
        let id = self.buffer(label, len.saturating_mul(size_of::<T>() as u64));
        Buffer::from_raw(id, 0, self.size(id))
    }

    /// Appends a dispatch of `groups` workgroups with typed bindings.
    pub fn launch<B: Bindings>(&mut self, program: ProgramId, entry: &str, bindings: &B, groups: [u32; 3]) {
        self.launch_with(program, entry, bindings, &[], Groups::Direct(groups));
    }

    /// Appends a dispatch with typed bindings, override values and any source of the group counts.
    pub fn launch_with<B: Bindings>(
        &mut self,
        program: ProgramId,
        entry: &str,
        bindings: &B,
        overrides: &[(&str, f64)],
        groups: Groups,
    ) {
        let overrides = overrides.iter().map(|&(name, value)| (name.to_owned(), value)).collect();
        let dispatch = Dispatch { program, entry: entry.to_owned(), overrides, slots: bindings.slots(), groups };
        self.record(Command::Dispatch(dispatch));
    }
}

/// Declares `#[repr(C)]` plain structs that mirror WGSL structs, and implements [`Host`] for them.
///
/// Fields are `u32`, `i32`, `f32`, glam vectors, `Mat4`, arrays of these, and other such structs. WGSL pads where Rust
/// does not; write that padding out as a field whose name begins with `_`.
#[macro_export]
macro_rules! host {
    ($($(#[$meta:meta])* $vis:vis struct $name:ident {
        $($(#[$field_meta:meta])* $field_vis:vis $field:ident: $ty:ty),* $(,)?
    })*) => { $(
        $(#[$meta])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, PartialEq, ::bytemuck::Pod, ::bytemuck::Zeroable)]
        $vis struct $name { $($(#[$field_meta])* $field_vis $field: $ty),* }

        impl $crate::host::Host for $name {
            const SHAPE: $crate::host::Shape = $crate::host::Shape::Struct {
                name: stringify!($name),
                fields: &[$($crate::host::Field {
                    name: stringify!($field),
                    offset: ::core::mem::offset_of!($name, $field) as u32,
                    size: ::core::mem::size_of::<$ty>() as u32,
                    shape: &<$ty as $crate::host::Host>::SHAPE,
                }),*],
                size: ::core::mem::size_of::<$name>() as u32,
            };
        }
    )* };
}

/// Declares the typed bindings of an entry point: `uniform`, `read` or `write`, name, number and contents.
///
/// `@ 2` is `@group(0) @binding(2)`; `@ (1, 2)` is `@group(1) @binding(2)`. Each becomes a public field of type
/// [`Buffer`](crate::host::Buffer).
#[macro_export]
macro_rules! bindings {
    (@access uniform) => { $crate::Access::Uniform };
    (@access read) => { $crate::Access::Read };
    (@access write) => { $crate::Access::ReadWrite };
    (@group ($group:literal, $binding:literal)) => { $group };
    (@group $binding:literal) => { 0 };
    (@binding ($group:literal, $binding:literal)) => { $binding };
    (@binding $binding:literal) => { $binding };
    ($($(#[$meta:meta])* $vis:vis struct $name:ident {
        $($(#[$field_meta:meta])* $access:ident $field:ident @ $at:tt: $ty:ty),* $(,)?
    })*) => { $(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug)]
        $vis struct $name { $(
            $(#[$field_meta])*
            #[doc = concat!("`", stringify!($access), " ", stringify!($ty), "`.")]
            pub $field: $crate::host::Buffer<$ty>
        ),* }

        impl $crate::host::Bindings for $name {
            const NAME: &'static str = stringify!($name);
            const DECLARED: &'static [$crate::host::Declared] = &[$($crate::host::Declared {
                name: stringify!($field),
                group: $crate::bindings!(@group $at),
                binding: $crate::bindings!(@binding $at),
                access: $crate::bindings!(@access $access),
                extent: <$ty as $crate::host::Contents>::EXTENT,
            }),*];

            fn slots(&self) -> ::std::vec::Vec<$crate::Slot> {
                ::std::vec![$(self.$field.slot($crate::bindings!(@group $at), $crate::bindings!(@binding $at))),*]
            }
        }
    )* };
}
