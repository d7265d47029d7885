//! The search for the balls that one ball may meet, several at a time with vector instructions.

use carom_roots::{Motion, Row};

use super::{Lanes, earlier};
use crate::detect::ball_ball::touching_distance;

/// Number of pairs tested together: the doubles in an AVX2 register. It divides every capacity.
const BLOCK: usize = 4;

const _: () = assert!(super::CAPACITY_STEP.is_multiple_of(BLOCK));

/// The balls that one ball may meet, in ascending order: every pair for which no cheap test has
/// proved that there is no contact.
#[derive(Clone, Debug)]
pub(super) struct PossiblePartners<const N: usize> {
    count: usize,
    balls: [u16; N],
}

impl<const N: usize> PossiblePartners<N> {
    pub(super) const NONE: Self = Self { count: 0, balls: [0; N] };

    #[inline(always)]
    pub(super) fn balls(&self) -> &[u16] {
        &self.balls[..self.count]
    }

    /// Takes every visible ball among the first `n`, without a test.
    #[cfg(feature = "peers")]
    pub(super) fn take_all(&mut self, lanes: &Lanes<N>, n: usize) {
        self.count = 0;
        for j in (0..n).filter(|&j| !lanes.valid_until[j].is_nan()) {
            self.balls[self.count] = j as u16;
            self.count += 1;
        }
    }

    /// Takes the balls that ball `i` may meet, among the first `n`. Its path is valid until `valid_until`,
    /// which its own lane does not hold yet.
    #[inline(always)]
    pub(super) fn search(
        &mut self,
        lanes: &Lanes<N>,
        i: usize,
        valid_until: f64,
        n: usize,
        time: f64,
        wide: bool,
    ) {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        if wide {
            // SAFETY: `wide` is only true where the processor has AVX2 (`has_wide_vectors`).
            // Measured: it saves a third of the time of an eight-ball break.
            #[allow(unsafe_code)]
            unsafe {
                self.search_avx2(lanes, i, valid_until, n, time);
            }
            return;
        }
        let _ = wide;
        self.search_plain(lanes, i, valid_until, n, time);
    }

    /// The same bits as without AVX2: no operation is fused or reordered.
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[target_feature(enable = "avx2")]
    fn search_avx2(&mut self, lanes: &Lanes<N>, i: usize, valid_until: f64, n: usize, time: f64) {
        self.search_plain(lanes, i, valid_until, n, time);
    }

    #[inline(always)]
    fn search_plain(&mut self, lanes: &Lanes<N>, i: usize, valid_until: f64, n: usize, time: f64) {
        self.count = 0;
        let mut from = 0;
        while from < n {
            if let Some(open) = lanes.row(i, valid_until, from, time).open() {
                // Branch-free: which lanes stay open is unpredictable.
                for (k, open) in open.into_iter().enumerate() {
                    self.balls[self.count] = (from + k) as u16;
                    self.count += usize::from(open);
                }
            }
            from += BLOCK;
        }
    }
}

/// The least of the first `n` numbers and the rest of their last block. None may be NaN.
#[inline(always)]
pub(super) fn least<const N: usize>(numbers: &[f64; N], n: usize) -> f64 {
    let mut least = [f64::INFINITY; BLOCK];
    for block in numbers.as_chunks::<BLOCK>().0.iter().take(n.div_ceil(BLOCK)) {
        for (least, &number) in least.iter_mut().zip(block) {
            *least = earlier(number, *least);
        }
    }
    least.into_iter().fold(f64::INFINITY, earlier)
}

/// Calls `visit` with the index of each number that has the bits of `number`, among the first `n`
/// and the rest of their last block. The bits are compared as integers, because that takes fewer
/// instructions than comparing floating-point numbers.
#[inline(always)]
pub(super) fn each_equal<const N: usize>(
    numbers: &[f64; N],
    n: usize,
    number: f64,
    mut visit: impl FnMut(usize),
) {
    let bits = number.to_bits();
    for (block, numbers) in
        numbers.as_chunks::<BLOCK>().0.iter().take(n.div_ceil(BLOCK)).enumerate()
    {
        for (k, number) in numbers.iter().enumerate() {
            if number.to_bits() == bits {
                visit(BLOCK * block + k);
            }
        }
    }
}

impl<const N: usize> Lanes<N> {
    /// The motions, from `time` on, of [`BLOCK`] balls relative to ball `i`. The first of them is
    /// ball `from`; the path of ball `i` is valid until `valid_until`.
    #[inline(always)]
    fn row(&self, i: usize, valid_until: f64, from: usize, time: f64) -> Row<BLOCK> {
        let age = time - self.start[i];
        let (x, vx) = advanced(self.x[i], self.vx[i], self.hx[i], age);
        let (y, vy) = advanced(self.y[i], self.vy[i], self.hy[i], age);
        let mut row = Row {
            dx: [0.0; BLOCK],
            dy: [0.0; BLOCK],
            vx: [0.0; BLOCK],
            vy: [0.0; BLOCK],
            hx: [0.0; BLOCK],
            hy: [0.0; BLOCK],
            distance: [0.0; BLOCK],
            horizon: [0.0; BLOCK],
        };
        for k in 0..BLOCK {
            let j = from + k;
            let age = time - self.start[j];
            let (xj, vxj) = advanced(self.x[j], self.vx[j], self.hx[j], age);
            let (yj, vyj) = advanced(self.y[j], self.vy[j], self.hy[j], age);
            row.dx[k] = xj - x;
            row.dy[k] = yj - y;
            row.vx[k] = vxj - vx;
            row.vy[k] = vyj - vy;
            row.hx[k] = self.hx[j] - self.hx[i];
            row.hy[k] = self.hy[j] - self.hy[i];
            row.distance[k] = self.radius[i] + self.radius[j];
            row.horizon[k] = earlier(valid_until, self.valid_until[j]) - time;
        }
        row
    }

    /// The motion of ball `j` relative to ball `i` from `time` on, the distance at which they
    /// touch, m, and how long the motion is valid, s.
    #[inline(always)]
    pub(super) fn pair(&self, i: usize, j: usize, time: f64) -> (Motion<2>, f64, f64) {
        let (age_i, age_j) = (time - self.start[i], time - self.start[j]);
        let (xi, vxi) = advanced(self.x[i], self.vx[i], self.hx[i], age_i);
        let (yi, vyi) = advanced(self.y[i], self.vy[i], self.hy[i], age_i);
        let (xj, vxj) = advanced(self.x[j], self.vx[j], self.hx[j], age_j);
        let (yj, vyj) = advanced(self.y[j], self.vy[j], self.hy[j], age_j);
        let motion = Motion {
            d: [xj - xi, yj - yi],
            v: [vxj - vxi, vyj - vyi],
            h: [self.hx[j] - self.hx[i], self.hy[j] - self.hy[i]],
        };
        let distance = touching_distance(self.radius[i], self.radius[j]);
        (motion, distance, earlier(self.valid_until[i], self.valid_until[j]) - time)
    }
}

/// Position and velocity along one axis at time `t`, s, on x + vt + ht².
#[inline(always)]
fn advanced(x: f64, v: f64, h: f64, t: f64) -> (f64, f64) {
    (x + (v + h * t) * t, v + h * (2.0 * t))
}
