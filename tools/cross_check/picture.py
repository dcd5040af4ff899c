"""Pictures for people: both images and the map of z, side by side, as PNG."""
import struct
import zlib

import numpy as np

from agreement import TILE


def srgb(image):
    x = np.clip(image, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)


def z_colours(z):
    """White where z is 0; red where the first image is brighter, blue where it is darker; full at 5."""
    strength = np.clip(z / 5, -1, 1)[..., None]
    red, blue, white = np.array([0.8, 0.1, 0.1]), np.array([0.1, 0.2, 0.8]), np.ones(3)
    end = np.where(strength > 0, red, blue)
    return white + np.abs(strength) * (end - white)


def write_png(path, image):
    """image: (height, width, 3) in [0, 1]."""
    rows = np.round(image * 255).astype(np.uint8)
    raw = b"".join(b"\0" + row.tobytes() for row in rows)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                   chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def side_by_side(path, a, b, z):
    """a, b: mean images; z: one value a tile. Shown at three times their size."""
    exposure = 0.8 / max(np.quantile(b.mean(axis=2), 0.95), 1e-9)
    tiles = np.kron(z_colours(z), np.ones((TILE, TILE, 1)))
    field = np.ones_like(a)  # the rest of the last, incomplete tiles stays white
    field[:tiles.shape[0], :tiles.shape[1]] = tiles
    gap = np.ones((a.shape[0], 2, 3))
    panels = np.concatenate([srgb(a * exposure), gap, srgb(b * exposure), gap, field], axis=1)
    write_png(path, np.kron(panels, np.ones((3, 3, 1))))
