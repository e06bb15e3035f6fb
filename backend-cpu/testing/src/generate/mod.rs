//! Random WGSL programs that are valid, end, and have no race: what one machine gives, every machine must give.
//!
//! * *Valid*: constant operands never stand where the front end would evaluate an error (a division by zero, a shift by
//!   32, an index out of range).
//! * *Ending*: every loop counts a variable of its own that nothing else assigns; the cost of nested loops and calls is
//!   summed as the text is made.
//! * *Free of races*: an invocation writes its own elements only; workgroup memory changes between "each its own" and
//!   "read by all" at barriers in uniform control flow; shared atomics do one commutative operation, results unused.
//! * *Exact*: the payload of a NaN is never observed.
//!
//! A *wild* program keeps the first and the last of these promises only.
//!
//! Choices come from bytes: a fuzzer's, or those that a seed stands for. The same bytes always make the same program.

mod expression;
mod program;
mod random;
mod shrink;
mod statement;
mod types;

pub use program::{Generated, generate, generate_wild};
pub use random::seeded;
pub use shrink::shrink;
