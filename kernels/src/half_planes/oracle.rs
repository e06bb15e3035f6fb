//! The definition knows no special case, so it is the one of [`crate::row_span`].

pub use crate::row_span::oracle::{sets, sets_by};
