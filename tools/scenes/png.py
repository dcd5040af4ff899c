"""Palette PNGs whose bytes do not depend on a compressor: deflate's stored blocks (RFC 1951, 3.2.4)."""
import struct
import zlib


def png_bytes(palette, rows, depth, alphas=()):
    """palette: (r, g, b) in 0..255; rows: palette indices, top row first; depth: 1, 2, 4 or 8 bits; alphas: of the
    palette's first colours, 255 for the others."""
    raw = bytearray()
    for row in rows:
        raw.append(0)  # no filter
        bits = "".join(format(i, f"0{depth}b") for i in row)
        bits += "0" * (-len(bits) % 8)
        raw += bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))

    stream = bytearray(b"\x78\x01")  # zlib header
    for start in range(0, len(raw), 65535):
        block = raw[start:start + 65535]
        last = start + 65535 >= len(raw)
        stream += struct.pack("<BHH", last, len(block), 65535 - len(block)) + block
    stream += struct.pack(">I", zlib.adler32(raw))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), depth, 3, 0, 0, 0)
    colours = b"".join(bytes(c) for c in palette)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", colours) + (chunk(b"tRNS", bytes(alphas)) if alphas else b"") +
            chunk(b"IDAT", bytes(stream)) + chunk(b"IEND", b""))


def checker(side, a, b):
    """2 x 2 squares of side / 2 texels; the texture repeats."""
    rows = [[(2 * x // side + 2 * y // side) % 2 for x in range(side)] for y in range(side)]
    return png_bytes([a, b], rows, 1)
