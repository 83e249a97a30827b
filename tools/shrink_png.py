#!/usr/bin/env python3
"""Writes PNG files of 8-bit RGB smaller, pixel for pixel the same: SimClient's own writer packs badly.

    tools/shrink_png.py [--shades N] FILE.png ...

--shades N: only so many of red, green and blue; 16 are enough to compare with, 32 to look at.
"""
import struct
import sys
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def chunks(data):
    at = 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + size]
        at += size + 12


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def read_rows(path):
    data = open(path, "rb").read()
    if data[:8] != SIGNATURE:
        sys.exit(f"{path}: not a PNG file")
    width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", data[16:29])
    if (depth, colour, interlace) != (8, 2, 0):
        return None  # packed already, or none of ours
    raw = zlib.decompress(b"".join(body for kind, body in chunks(data) if kind == b"IDAT"))
    rows, above, stride = [], bytearray(width * 3), width * 3
    for y in range(height):
        method, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride if method else 0):
            left = row[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            guess = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[method]
            row[i] = (row[i] + guess) & 255
        rows.append(bytes(row))
        above = row
    return width, height, rows


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def packed(width, height, rows):
    pixels = [[row[i:i + 3] for i in range(0, len(row), 3)] for row in rows]
    palette = sorted({pixel for row in pixels for pixel in row})
    if len(palette) <= 256:
        index = {pixel: i for i, pixel in enumerate(palette)}
        colour, head = 3, chunk(b"PLTE", b"".join(palette))
        bodies = [b"".join(b"\0" + bytes(index[p] for p in row) for row in pixels)]
    else:
        colour, head = 2, b""
        above = [bytes(len(rows[0]))] + rows[:-1]
        up = b"".join(b"\2" + bytes((a - b) & 255 for a, b in zip(row, over)) for row, over in zip(rows, above))
        bodies = [b"".join(b"\0" + row for row in rows), up]
    body = min((zlib.compress(b, 9) for b in bodies), key=len)
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0))
    return SIGNATURE + header + head + chunk(b"IDAT", body) + chunk(b"IEND", b"")


names, coarse = sys.argv[1:], None
if names[:1] == ["--shades"]:
    step = 255 / (int(names[1]) - 1)
    names, coarse = names[2:], bytes(round(round(v / step) * step) for v in range(256))
for name in names:
    picture = read_rows(name)
    if picture is None:
        continue
    if coarse:
        picture = (*picture[:2], [row.translate(coarse) for row in picture[2]])
    smaller = packed(*picture)
    if len(smaller) < len(open(name, "rb").read()):
        open(name, "wb").write(smaller)
