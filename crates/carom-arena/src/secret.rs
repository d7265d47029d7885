//! The secret of a match, and the seeds that derive from it.
//!
//! A match has one secret of 256 bits. Its SHA-256 is published before the first shot, and the
//! secret itself after the last. So everybody can check afterwards that racks and errors were
//! determined before the match, and they cannot be computed during the match.
//!
//! The seeds of pair k are the first words of ChaCha20 (Bernstein 2008) with the secret as its key
//! and k as its stream. They have 64 bits each and do not reveal each other.

use core::fmt::{self, Write};

use carom::{Error, ErrorKind};
use chacha20::ChaCha20Rng;
use chacha20::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};

/// Number of bytes of a secret.
const BYTES: usize = 32;

/// The label of the generator of the seeds of decisions, in its key behind the seat's own seed.
const DECISION_KEY: &[u8; 24] = b"carom: seed of decisions";
/// The same for the seeds of the racks after the first.
const RACK_KEY: &[u8; 24] = b"carom: seed of next rack";

/// The same of the seeds of fresh errors.
const LUCK_KEY: &[u8; 24] = b"carom: luck of the shots";

/// The secret of a match: 256 random bits.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Secret([u8; BYTES]);

impl Secret {
    /// A given secret, for experiments that can be repeated.
    pub const fn new(bytes: [u8; BYTES]) -> Self {
        Self(bytes)
    }

    /// A secret from the random numbers of the operating system.
    ///
    /// # Errors
    /// [`Error::Input`] at `secret` if the operating system has none.
    #[cfg(feature = "os-secret")]
    pub fn from_os() -> Result<Self, Error> {
        let mut bytes = [0; BYTES];
        match getrandom::fill(&mut bytes) {
            Ok(()) => Ok(Self(bytes)),
            Err(error) => Err(ErrorKind::System.at(
                "secret",
                format!("the operating system gives no random numbers ({error})"),
                "give a secret of your own",
            )),
        }
    }

    /// The secret that is written as 64 hexadecimal digits.
    ///
    /// # Errors
    /// [`Error::Input`] at `secret` for another text.
    pub fn parse(hex: &str) -> Result<Self, Error> {
        let wrong = || {
            ErrorKind::Syntax.at("secret", "it does not have 64 hexadecimal digits", "correct it")
        };
        if hex.len() != 2 * BYTES || !hex.bytes().all(|digit| digit.is_ascii_hexdigit()) {
            return Err(wrong());
        }
        let mut bytes = [0; BYTES];
        for (byte, digits) in bytes.iter_mut().zip(hex.as_bytes().chunks(2)) {
            let digits = core::str::from_utf8(digits).map_err(|_| wrong())?;
            *byte = u8::from_str_radix(digits, 16).map_err(|_| wrong())?;
        }
        Ok(Self(bytes))
    }

    /// The secret as 64 hexadecimal digits.
    pub fn to_hex(&self) -> String {
        hex(&self.0)
    }

    /// SHA-256 of the 32 bytes of the secret, as 64 hexadecimal digits.
    pub fn sha256(&self) -> String {
        sha256(&self.0)
    }

    /// The seeds of pair number `pair`.
    pub fn pair_seeds(&self, pair: u64) -> PairSeeds {
        let mut random = ChaCha20Rng::from_seed(self.0);
        random.set_stream(pair);
        let mut word = || random.next_u64();
        PairSeeds {
            rack: word(),
            errors: [word(), word()],
            sight: [word(), word()],
            decisions: [word(), word()],
            luck: [word(), word()],
            later: word(),
        }
    }
}

/// Shows the hash only: what is printed for a bug report must not reveal the secret.
impl fmt::Debug for Secret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Secret(sha256 {})", self.sha256())
    }
}

/// The seeds of the two frames of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairSeeds {
    /// Of the first rack.
    pub rack: u64,
    /// Of the errors of the strikes, for each seat. The index is the number of the seat's own shots
    /// before.
    pub errors: [u64; 2],
    /// Of the errors of perception, for each seat, with the same index.
    pub sight: [u64; 2],
    /// Of the random numbers that the players are given, for each seat. The index is the number of
    /// the seat's requests before.
    pub decisions: [u64; 2],
    /// Of the fresh errors by which the luck of shots is measured, for each seat. The index is the
    /// number of the seat's own shots before.
    pub luck: [u64; 2],
    /// Of the racks after the first, and of lots. The index is the number of the move.
    pub later: u64,
}

impl PairSeeds {
    /// The same seeds with the streams of the two seats exchanged.
    #[must_use]
    pub const fn exchanged(self) -> Self {
        Self {
            rack: self.rack,
            errors: [self.errors[1], self.errors[0]],
            sight: [self.sight[1], self.sight[0]],
            decisions: [self.decisions[1], self.decisions[0]],
            luck: [self.luck[1], self.luck[0]],
            later: self.later,
        }
    }

    /// The seed of decision number `index` of `seat`.
    pub(crate) fn decision(&self, seat: usize, index: u64) -> u64 {
        derived(self.decisions[seat], DECISION_KEY, index)
    }

    /// The seed of the fresh errors of shot number `index` of `seat`.
    pub(crate) fn fresh_errors(&self, seat: usize, index: u64) -> u64 {
        derived(self.luck[seat], LUCK_KEY, index)
    }

    /// The seed of the racks and lots that follow from move number `index`.
    pub(crate) fn later_rack(&self, index: u64) -> u64 {
        derived(self.later, RACK_KEY, index)
    }
}

/// Seed number `index` of those that derive from `seed` under this label.
fn derived(seed: u64, label: &[u8; 24], index: u64) -> u64 {
    let mut key = [0; BYTES];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key[8..].copy_from_slice(label);
    let mut random = ChaCha20Rng::from_seed(key);
    random.set_stream(index);
    random.next_u64()
}

/// SHA-256 of `bytes` as 64 hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// A hash that grows with the lines of a file.
#[derive(Clone, Default)]
pub(crate) struct LineHash(Sha256);

impl LineHash {
    /// Adds a line, with its line feed.
    pub(crate) fn add(&mut self, line: &str) {
        self.0.update(line.as_bytes());
        self.0.update(b"\n");
    }

    /// SHA-256 of the lines so far, as 64 hexadecimal digits.
    pub(crate) fn finish(self) -> String {
        hex(&self.0.finalize())
    }
}

/// Bytes as hexadecimal digits.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut text, byte| {
        // Writing to a String cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::{LineHash, Secret, sha256};

    // FIPS 180-4 (NIST), the example "abc".
    #[test]
    fn the_hash_of_abc_is_that_of_the_standard() {
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), expected);
    }

    #[test]
    fn lines_have_the_hash_of_the_text() {
        let mut lines = LineHash::default();
        lines.add("one");
        lines.add("two");
        assert_eq!(lines.finish(), sha256(b"one\ntwo\n"));
    }

    #[test]
    fn a_secret_reads_back_from_its_digits() {
        let secret = Secret::new(core::array::from_fn(|i| 7 * i as u8));
        assert_eq!(Secret::parse(&secret.to_hex()).unwrap(), secret);
        let upper = secret.to_hex().to_uppercase();
        assert_eq!(Secret::parse(&upper).unwrap(), secret);
        for wrong in ["", "00", &"0".repeat(63), &"0".repeat(65), &"g".repeat(64), &"ü".repeat(32)]
        {
            let error = Secret::parse(wrong).unwrap_err().to_string();
            assert!(error.starts_with("secret: "), "{error}");
        }
    }

    #[test]
    fn what_is_printed_for_debugging_does_not_reveal_the_secret() {
        let secret = Secret::new([0xa7; 32]);
        let printed = format!("{secret:?}");
        assert!(printed.contains(&secret.sha256()) && !printed.contains("a7a7a7a7"), "{printed}");
    }

    #[test]
    fn all_seeds_of_all_pairs_differ() {
        let mut seen = std::collections::HashSet::new();
        for bytes in [[0; 32], [1; 32]] {
            for pair in 0..100 {
                let seeds = Secret::new(bytes).pair_seeds(pair);
                let of_seats = [seeds.errors, seeds.sight, seeds.decisions, seeds.luck];
                for seed in of_seats.into_iter().flatten().chain([seeds.rack, seeds.later]) {
                    assert!(seen.insert(seed));
                }
                assert!((0..3).all(|index| seen.insert(seeds.later_rack(index))));
                for (seat, index) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    assert!(seen.insert(seeds.decision(seat, index)));
                    assert!(seen.insert(seeds.fresh_errors(seat, index)));
                }
            }
        }
    }

    #[cfg(feature = "os-secret")]
    #[test]
    fn the_operating_system_gives_another_secret_each_time() {
        assert_ne!(Secret::from_os().unwrap(), Secret::from_os().unwrap());
    }
}
