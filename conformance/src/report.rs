//! Reports of a run: text for people, JSON and JUnit for machines.

pub mod json;
pub mod junit;
pub mod text;
