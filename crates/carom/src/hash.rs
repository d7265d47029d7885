//! A hash of 64-bit words, with the same value on every platform.
//!
//! Each word is mixed in as FNV-1a mixes in bytes (Fowler, Noll & Vo: xor, then multiply by the
//! prime). Then the upper half is folded into the lower one; without this, a flipped sign bit would
//! change only the top bit of the hash.

const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

/// Hashes words one after the other.
#[derive(Clone, Copy, Debug)]
pub struct WordHasher(u64);

impl Default for WordHasher {
    fn default() -> Self {
        Self(OFFSET_BASIS)
    }
}

impl WordHasher {
    /// Mixes in a word.
    pub fn word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(PRIME);
        self.0 ^= self.0 >> 32;
    }

    /// Mixes in bytes: their number, then eight at a time, little-endian.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.word(bytes.len() as u64);
        for chunk in bytes.chunks(8) {
            let mut eight = [0; 8];
            eight[..chunk.len()].copy_from_slice(chunk);
            self.word(u64::from_le_bytes(eight));
        }
    }

    /// Mixes in a text as its UTF-8 bytes.
    pub fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
    }

    /// The hash of the words so far.
    pub const fn value(&self) -> u64 {
        self.0
    }
}
