//! The definition: the operation, bit by bit.

use super::Truth;

/// The operation on three bits.
fn bit(operation: Truth, x: bool, y: bool, z: bool) -> bool {
    operation.0 >> (u8::from(x) + 2 * u8::from(y) + 4 * u8::from(z)) & 1 == 1
}

/// The operation on the bits of three words.
pub fn combine(operation: Truth, a: u32, b: u32, c: u32) -> u32 {
    let of = |word: u32, n: u32| word >> n & 1 == 1;
    (0..32).map(|n| u32::from(bit(operation, of(a, n), of(b, n), of(c, n))) << n).sum()
}

/// A word of the operation's table.
pub fn table_word(operation: Truth, word: u32) -> u32 {
    let byte = |at: u32| combine(operation, at % 256, at / 256 % 256, at / 65_536) & 255;
    (0..4).map(|n| byte(4 * word + n) << (8 * n)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_named_operations_are_what_they_are_called() {
        let words = [0, u32::MAX, 0x0123_4567, 0x89ab_cdef, 0x5555_5555, 1 << 31];
        for (a, b, c) in words.iter().flat_map(|a| words.iter().flat_map(move |b| words.map(|c| (*a, *b, c)))) {
            assert_eq!(combine(Truth::AND, a, b, c), a & b & c);
            assert_eq!(combine(Truth::OR, a, b, c), a | b | c);
            assert_eq!(combine(Truth(0b1001_0110), a, b, c), a ^ b ^ c);
            assert_eq!(combine(Truth(0b0010_0010), a, b, c), a & !b);
        }
    }

    #[test]
    fn a_texel_of_the_table_is_the_operation_on_its_coordinates() {
        let (i, j, k) = (0b1010_1100, 0b1111_0000, 0b1000_1101);
        let at = i + 256 * j + 65_536 * k;
        assert_eq!(table_word(Truth::AND, at / 4) >> (8 * (at % 4)) & 255, i & j & k);
    }
}
