"""A sky at dusk as a Radiance HDR map: a low sun, glowing haze, streaks of cloud, dark ground.

Directions as in common/scene/view.h: u = atan2(z, x) / 2 pi, v = acos(y) / pi, row 0 at the top.
"""
import math

WIDTH, HEIGHT = 256, 128
SUN_AZIMUTH, SUN_HEIGHT, SUN_RADIUS = math.radians(216), math.radians(13), math.radians(4.5)


def mix(a, b, t):
    t = max(0.0, min(1.0, t))
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def hash01(i, j):
    """A random-looking number in [0, 1) for a lattice point: integer arithmetic only."""
    h = (i * 0x9E3779B1 + j * 0x85EBCA77 + 0x1234567) & 0xFFFFFFFF
    h = ((h ^ (h >> 15)) * 0x2C1B3C6D) & 0xFFFFFFFF
    h = ((h ^ (h >> 12)) * 0x297A2D39) & 0xFFFFFFFF
    return ((h ^ (h >> 15)) >> 8) / 2.0 ** 24


def noise(x, y, period):
    """Value noise with period `period` in x."""
    i, j = math.floor(x), math.floor(y)
    fx, fy = x - i, y - j
    sx, sy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    a, b = hash01(i % period, j), hash01((i + 1) % period, j)
    c, d = hash01(i % period, j + 1), hash01((i + 1) % period, j + 1)
    return (a + (b - a) * sx) * (1 - sy) + (c + (d - c) * sx) * sy


def cloud(azimuth, elevation):
    turns = azimuth / (2 * math.pi)
    x, y = turns * 12, elevation * 16
    n = (noise(x, y, 12) + 0.5 * noise(2 * x, 2 * y, 24) + 0.25 * noise(4 * x, 4 * y, 48)) / 1.75
    return max(0.0, min(1.0, (n - 0.5) * 5)) * math.exp(-((elevation - 0.35) / 0.28) ** 2)


def sky(azimuth, elevation):
    x, y, z = (math.cos(elevation) * math.cos(azimuth), math.sin(elevation),
               math.cos(elevation) * math.sin(azimuth))
    sun = (math.cos(SUN_HEIGHT) * math.cos(SUN_AZIMUTH), math.sin(SUN_HEIGHT),
           math.cos(SUN_HEIGHT) * math.sin(SUN_AZIMUTH))
    cos_sun = x * sun[0] + y * sun[1] + z * sun[2]
    towards = 0.5 + 0.5 * cos_sun
    if elevation < 0:
        return mix((0.16, 0.11, 0.09), (0.04, 0.035, 0.04), -elevation / 0.5)
    horizon = mix((0.34, 0.30, 0.46), (1.5, 0.62, 0.26), towards ** 3)
    colour = mix(horizon, (0.10, 0.20, 0.46), (elevation / 1.1) ** 0.55)
    lit = mix((0.30, 0.26, 0.36), (1.9, 0.85, 0.55), towards ** 4)
    colour = mix(colour, lit, 0.75 * cloud(azimuth, elevation))
    glow = math.exp((cos_sun - 1) / 0.03)
    colour = tuple(c + g * glow for c, g in zip(colour, (2.6, 1.3, 0.5)))
    angle = math.acos(max(-1.0, min(1.0, cos_sun)))
    disc = max(0.0, min(1.0, (SUN_RADIUS - angle) / math.radians(1.2) + 0.5))
    return tuple(c + d * disc for c, d in zip(colour, (80, 50, 25)))


def rgbe(colour):
    """Ward's shared exponent: the largest channel has a mantissa in [128, 255]."""
    largest = max(colour)
    if largest < 1e-32:
        return bytes(4)
    mantissa, exponent = math.frexp(largest)
    scale = mantissa * 256 / largest
    return bytes(min(255, int(c * scale)) for c in colour) + bytes([exponent + 128])


def dusk_hdr(samples=3):
    data = bytearray(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n".encode())
    for row in range(HEIGHT):
        for column in range(WIDTH):
            total = [0.0, 0.0, 0.0]
            for i in range(samples):
                for j in range(samples):
                    azimuth = 2 * math.pi * (column + (i + 0.5) / samples) / WIDTH
                    elevation = math.pi * (0.5 - (row + (j + 0.5) / samples) / HEIGHT)
                    for k, c in enumerate(sky(azimuth, elevation)):
                        total[k] += c
            # Six digits first: a last-bit difference between maths libraries must not change a byte.
            data += rgbe([float(f"{c / samples ** 2:.6g}") for c in total])
    return bytes(data)
