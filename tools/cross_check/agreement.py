"""Do two sets of noisy images have the same mean? From their replicates alone, whatever the sampler."""
import math
from statistics import NormalDist

import numpy as np

TILE = 8  # pixels a side
# What float32 sums of a few thousand samples can be off, relative: images without noise may differ by it.
ROUNDING = 1e-6


def welch_z(a, b):
    """a, b: replicates along axis 0. The standard normal quantile of Welch's t of their means.

    Degrees of freedom by Satterthwaite (1946); t to z by Wallace (1959), whose error stays below
    0.02 for 10 degrees and more. 0 where both are without noise and the same.
    """
    n, m = len(a), len(b)
    va, vb = a.var(axis=0, ddof=1) / n, b.var(axis=0, ddof=1) / m
    difference = a.mean(axis=0) - b.mean(axis=0)
    rounding = (ROUNDING * b.mean(axis=0)) ** 2
    variance = va + vb + rounding
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.where(difference == 0, 0.0, difference / np.sqrt(variance))
        df = np.where(va + vb > 0, (va + vb) ** 2 / (va**2 / (n - 1) + vb**2 / (m - 1)), n + m - 2)
    shrink = (8 * df + 1) / (8 * df + 3)
    return np.sign(t) * shrink * np.sqrt(df * np.log1p(t**2 / df))


def tile_means(images):
    """images: (replicates, height, width, 3) -> (replicates, rows, columns), the channels' mean."""
    r, h, w, _ = images.shape
    rows, columns = h // TILE, w // TILE
    cut = images[:, :rows * TILE, :columns * TILE].mean(axis=3)
    return cut.reshape(r, rows, TILE, columns, TILE).mean(axis=(2, 4))


def chi_square_p(x, k):
    """P(chi^2 with k degrees > x), by Wilson and Hilferty (1931): (x / k)^(1/3) is nearly normal."""
    s = 2 / (9 * k)
    return NormalDist().cdf(-((x / k) ** (1 / 3) - (1 - s)) / math.sqrt(s))


def compare(a, b):
    """a, b: (replicates, height, width, 3), linear radiance. What is known about their means."""
    mean_a, mean_b = a.mean(axis=(1, 2)), b.mean(axis=(1, 2))  # (replicates, 3)
    grey_a, grey_b = mean_a.mean(axis=1), mean_b.mean(axis=1)
    error = math.sqrt(grey_a.var(ddof=1) / len(a) + grey_b.var(ddof=1) / len(b))
    ta, tb = tile_means(a), tile_means(b)
    z = welch_z(ta, tb)
    # Tiles without noise (an even sky, black) are no draws of chance: they must agree, and that is all.
    noisy = ta.std(axis=0) + tb.std(axis=0) > 10 * ROUNDING * tb.mean(axis=0)
    chi_square = float((z[noisy] ** 2).sum())
    return {
        "mean_raylab": mean_a.mean(axis=0).tolist(),
        "mean_other": mean_b.mean(axis=0).tolist(),
        "relative_difference": float((grey_a.mean() - grey_b.mean()) / grey_b.mean()),
        "relative_standard_error": float(error / grey_b.mean()),
        "z": float(welch_z(grey_a, grey_b)),
        "z_rgb": welch_z(mean_a, mean_b).tolist(),
        "tiles": int(noisy.sum()),
        "largest_tile_z": float(z.flat[np.abs(z).argmax()]),
        "chi_square": chi_square,
        "p": chi_square_p(chi_square, int(noisy.sum())) if noisy.any() else 1.0,
    }, z


def disagree(result):
    """By chance about once in 1000 scenes."""
    return (max(map(abs, [result["z"], *result["z_rgb"]])) > 4 or result["p"] < 1e-3 or
            abs(result["largest_tile_z"]) > 6)
