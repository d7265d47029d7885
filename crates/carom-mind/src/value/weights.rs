//! The weights of the logistic regression. Written by `scripts/fit_values.py`.

use super::features::COUNT;

/// The games, and the weights of their features in the order of [`super::features::NAMES`].
pub(super) const WEIGHTS: [(&str, [f64; COUNT]); 3] = [
    (
        "eight-ball",
        [
            -0.66488, 0.154085, -0.303049, 0.351126, 0.137994, -0.097223, 0.258138, -0.136257,
            0.825858, 0.0, 0.0, -1.293336, 0.894463, 0.266805, -0.864876,
        ],
    ),
    (
        "nine-ball",
        [
            0.016517, 0.979196, -0.052907, 0.0, 0.0, 0.024718, 0.355524, -0.072291, -0.072291,
            -0.073615, 0.154804, 0.0, 0.037506, -0.116073, -0.116073,
        ],
    ),
    (
        "ten-ball",
        [
            -0.547171, 0.947089, -0.075188, 0.0, 0.0, -0.03508, 0.08052, 0.256331, 0.256331,
            0.023237, 0.083727, 0.0, 0.103307, -0.028052, -0.028052,
        ],
    ),
];
