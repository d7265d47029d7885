//! The weights of the logistic regression. Written by `scripts/fit_values.py`.

use super::features::COUNT;

/// The games, and the weights of their features in the order of
/// [`super::features::NAMES`].
#[rustfmt::skip]
pub(super) const WEIGHTS: [(&str, [f64; COUNT]); 3] = [
    (
        "eight-ball",
        [
            -0.355449,
            0.203282,
            -0.39629,
            0.297149,
            0.088054,
            -0.111546,
            0.20681,
            0.418515,
            -0.005603,
            0.0,
            0.0,
            -1.467914,
            0.933696,
            0.402569,
            -0.881848,
        ],
    ),
    (
        "nine-ball",
        [
            -0.055645,
            0.985641,
            -0.168903,
            0.0,
            0.0,
            0.047612,
            0.33754,
            -0.072518,
            -0.072518,
            -0.021724,
            0.180429,
            0.0,
            0.095756,
            -0.051031,
            -0.051031,
        ],
    ),
    (
        "ten-ball",
        [
            -0.435893,
            0.840512,
            -0.03901,
            0.0,
            0.0,
            -0.091063,
            0.176011,
            0.179788,
            0.179788,
            -0.234852,
            0.348731,
            0.0,
            0.244942,
            -0.043564,
            -0.043564,
        ],
    ),
];
