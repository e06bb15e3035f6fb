//! Fields: receivers at any integer points of the grid, in columns and rows, each with the light's pattern shifted for
//! it.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 6.2 and 8: receivers may be moved by a
//! height map, and samples shifted by a random amount for each receiver, so that noise takes the place of bands. A
//! floor, a height field and a lightmap are fields. Invariant: receivers are on the grid, and so is the shifted
//! pattern's centre; a receiver with z = 0 is none (a texel that no triangle covers, or that lies behind the light),
//! and its mask stays empty.

use glam::IVec4;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Error, Job, Result};

use crate::grid::{Faces, Point, Receivers, Triangle, XY, is_on_grid};
use crate::pattern::Pattern;

/// A receiver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Receiver {
    /// Where it stands; z = 0 where there is none.
    pub at: Point,
    /// How far the pattern is shifted for it.
    pub shift: [i32; 2],
}

/// Receivers in rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    columns: u32,
    receivers: Vec<Receiver>,
}

impl Receiver {
    /// A receiver to which the pattern is not shifted.
    pub fn new(at: Point) -> Self {
        Receiver { at, shift: [0, 0] }
    }

    /// Whether it is one.
    pub fn is_there(&self) -> bool {
        self.at[2] > 0
    }

    /// As kernels are given it: x, y, z, and the shift in 16 bits each, x low.
    fn word(&self) -> IVec4 {
        let [x, y, z] = self.at;
        IVec4::new(x, y, z, self.shift[0] & 0xffff | self.shift[1] << 16)
    }
}

impl From<&Receivers> for Field {
    fn from(receivers: &Receivers) -> Self {
        let at = |r| Receiver::new(receivers.at(r));
        Field { columns: receivers.columns, receivers: (0..receivers.count()).map(at).collect() }
    }
}

impl Field {
    /// Receivers row after row, `columns` of them in a row.
    pub fn new(columns: u32, receivers: Vec<Receiver>) -> Result<Self> {
        let count = receivers.len();
        let sizes = (1..=8192).contains(&columns) && count.is_multiple_of(columns as usize);
        if !sizes || !(1..=8192).contains(&(count / columns as usize)) {
            let what = format!("a field of {count} receivers in rows of {columns}");
            return Err(Error::refused(what, "give 1 to 8192 columns and rows, all full"));
        }
        let short = |shift: i32| (-XY..XY).contains(&shift);
        match receivers.iter().find(|r| !is_on_grid(r.at) || !r.shift.iter().all(|s| short(*s))) {
            None => Ok(Field { columns, receivers }),
            Some(bad) => {
                let remedy = "keep x and y in [-16384, 16384), z in [0, 32768) and shifts below 16384";
                Err(Error::refused(format!("a receiver {bad:?}"), remedy))
            }
        }
    }

    /// Receivers along x.
    pub fn columns(&self) -> u32 {
        self.columns
    }

    /// Receivers along y.
    pub fn rows(&self) -> u32 {
        self.count() / self.columns
    }

    /// Number of receivers.
    pub fn count(&self) -> u32 {
        self.receivers.len() as u32
    }

    /// The receivers, row after row.
    pub fn receivers(&self) -> &[Receiver] {
        &self.receivers
    }

    /// Some of its rows.
    pub fn band(&self, rows: std::ops::Range<u32>) -> Field {
        let [first, end] = [rows.start, rows.end].map(|row| (row * self.columns) as usize);
        Field { columns: self.columns, receivers: self.receivers[first..end].to_vec() }
    }

    /// Refuses a pattern that a shift moves off the grid.
    pub fn check(&self, pattern: &Pattern) -> Result<()> {
        let centre = pattern.centre();
        let beside = |r: &&Receiver| !(0..2).all(|i| (-XY..XY).contains(&(centre[i] + r.shift[i])));
        match self.receivers.iter().find(beside) {
            None => Ok(()),
            Some(bad) => {
                let what = format!("a pattern about {centre:?} shifted by {:?}", bad.shift);
                Err(Error::refused(what, "keep the centre within [-16384, 16384)"))
            }
        }
    }

    /// Puts it on a device.
    pub fn upload(&self, job: &mut Job) -> Buffer<[IVec4]> {
        let words: Vec<IVec4> = self.receivers.iter().map(Receiver::word).collect();
        job.slice("receivers", &words)
    }

    /// The mask of samples that any of `triangles` hides from a receiver, by [`Faces::hide`] alone: empty where it is
    /// none.
    pub fn hidden_set<'a>(
        &self,
        receiver: u32,
        pattern: &Pattern,
        triangles: impl IntoIterator<Item = &'a Triangle>,
    ) -> Vec<u32> {
        self.hidden_set_by(Faces::Both, receiver, pattern, triangles)
    }

    /// The same of triangles that hide by `faces`.
    pub fn hidden_set_by<'a>(
        &self,
        faces: Faces,
        receiver: u32,
        pattern: &Pattern,
        triangles: impl IntoIterator<Item = &'a Triangle>,
    ) -> Vec<u32> {
        let Receiver { at, shift } = self.receivers[receiver as usize];
        let mut mask = vec![0; pattern.words() as usize];
        let samples = |at: &Point| at[2] > 0;
        for triangle in triangles.into_iter().filter(|_| samples(&at)) {
            for sample in 0..pattern.count() {
                let [x, y, _] = pattern.at(sample);
                let bit = u32::from(faces.hide(at, [x + shift[0], y + shift[1], 0], triangle));
                mask[(sample / pattern.bits()) as usize] |= bit << (sample % pattern.bits());
            }
        }
        mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_moves_the_light_and_no_receiver_sees_without_standing() {
        let pattern = Pattern::new(vec![[0, 0], [100, 0]], 32).expect("on the grid");
        let triangle = [[40, -10, 50], [60, -10, 50], [50, 30, 50]];
        let receivers = [(100, [0, 0]), (100, [0, 3]), (100, [-100, 0]), (100, [100, 0]), (0, [100, 0])]
            .map(|(z, shift)| Receiver { at: [50, 0, z], shift });
        let field = Field::new(5, receivers.to_vec()).expect("it fits");
        let masks: Vec<u32> = (0..5).map(|r| field.hidden_set(r, &pattern, [&triangle])[0]).collect();
        // At half way, x = 50 hides x = 50 alone: samples at 0 and 100 pass 25 and 75.
        assert_eq!(masks, [0, 0, 0, 0, 0]);
        let wide = [[20, -10, 50], [80, -10, 50], [50, 300, 50]];
        let masks: Vec<u32> = (0..5).map(|r| field.hidden_set(r, &pattern, [&wide])[0]).collect();
        assert_eq!(masks, [0b11, 0b11, 0b10, 0b01, 0]);
    }

    #[test]
    fn fields_that_do_not_fit_are_refused() {
        let stands = Receiver::new([0, 0, 9]);
        let refused = |columns, receivers| Field::new(columns, receivers).expect_err("refused").to_string();
        assert!(refused(2, vec![stands; 3]).contains("3 receivers in rows of 2"));
        assert!(refused(2, vec![]).contains("0 receivers"));
        assert!(refused(1, vec![Receiver::new([XY, 0, 9])]).contains("16384"));
        assert!(refused(1, vec![Receiver { shift: [0, XY], ..stands }]).contains("16384"));
        let field = Field::new(1, vec![Receiver { shift: [XY - 1, 0], ..stands }]).expect("it fits");
        let at = |x| Pattern::new(vec![[x, 0]], 32).expect("on the grid");
        assert!(field.check(&at(1)).is_err() && field.check(&at(0)).is_ok());
    }
}
