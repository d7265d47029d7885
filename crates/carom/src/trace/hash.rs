//! The hash of a trace: 64 bits over the exact bits of all events and final states.
//!
//! The input is a sequence of 64-bit words in the order below. Each word is mixed in as FNV-1a
//! mixes in bytes (Fowler, Noll & Vo: xor, then multiply by the prime). Then the upper half is
//! folded into the lower one; without this, a flipped sign bit would change only the top bit of the
//! hash.
//!
//! Per event: the time; the type's number; two details (contacts of the tip − 1 and pushed, rail
//! and part, pocket and 0, from and to, or 0 and 0); the number of balls; per ball its index, its state before, its state after. Then
//! per ball its final state. A state is position, velocity, angular velocity (nine numbers) and the
//! number of its motion state. Rails, parts, pockets and motion states have the numbers of their
//! declaration, from 0. The algorithm belongs to `carom-trace/1` and changes only with that
//! version.

use super::{Trace, TraceEventKind};
use crate::BallState;

const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

struct Hasher(u64);

impl Hasher {
    fn word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(PRIME);
        self.0 ^= self.0 >> 32;
    }

    fn state(&mut self, s: &BallState) {
        for v in [s.position, s.velocity, s.angular_velocity] {
            v.to_array().iter().for_each(|x| self.word(x.to_bits()));
        }
        self.word(s.motion as u64);
    }
}

const fn numbers(kind: TraceEventKind) -> [u64; 3] {
    match kind {
        TraceEventKind::CueStrike { tip_contacts, pushed } => {
            [0, tip_contacts as u64 - 1, pushed as u64]
        }
        TraceEventKind::BallCollision => [1, 0, 0],
        TraceEventKind::RailCollision { rail, part } => [2, rail as u64, part as u64],
        TraceEventKind::PocketCollision(pocket) => [3, pocket as u64, 0],
        TraceEventKind::MotionTransition { from, to } => [4, from as u64, to as u64],
        TraceEventKind::SlateCollision => [5, 0, 0],
        TraceEventKind::OffTable => [6, 0, 0],
    }
}

impl Trace {
    /// 64 bits over the exact bits of all events and final states.
    pub fn hash(&self) -> u64 {
        let mut hasher = Hasher(OFFSET_BASIS);
        for event in self.events() {
            hasher.word(event.time.to_bits());
            numbers(event.kind).into_iter().for_each(|n| hasher.word(n));
            hasher.word(event.balls.len() as u64);
            for (i, &ball) in event.balls.iter().enumerate() {
                hasher.word(u64::from(ball));
                hasher.state(&event.before[i]);
                hasher.state(&event.after[i]);
            }
        }
        self.last.iter().for_each(|s| hasher.state(s));
        hasher.0
    }
}
