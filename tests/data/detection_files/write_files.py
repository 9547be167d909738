#!/usr/bin/env python3
"""Writes small detection files by their published layouts, independently of Fidelis: only the struct module.

    python3 tests/data/detection_files/write_files.py

Every cloud holds the same three points: (3, 4, 0), (0, -2, 0), (1, 2, 2), that is ranges 5, 2 and 3 m.
"""
import math
import struct
from pathlib import Path

HERE = Path(__file__).parent
POINTS = [(3.0, 4.0, 0.0, 7, 0.5, 11.0), (0.0, -2.0, 0.0, 1, 0.25, 12.0), (1.0, 2.0, 2.0, 3, 0.125, 13.0)]
NAN = float("nan")


def pcd_header(data, points, height=1):
    # COUNT 2 of "skip" is a field that nobody needs, before fields that somebody does.
    return (
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
        "FIELDS x y z skip ring epw_m intensity\nSIZE 4 4 4 1 2 8 4\nTYPE F F F I U F F\nCOUNT 1 1 1 2 1 1 1\n"
        f"WIDTH {points // height}\nHEIGHT {height}\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {points}\nDATA {data}\n"
    ).encode()


def pcd_record(p):
    return struct.pack("<fffbbHdf", p[0], p[1], p[2], -1, 1, p[3], p[4], p[5])


def lzf(data):
    """LZF without a search: runs of one byte as back references of distance 1, the rest as literals."""
    out, literal, i = bytearray(), bytearray(), 0

    def flush():
        while literal:
            piece = literal[:32]
            out.append(len(piece) - 1)
            out.extend(piece)
            del literal[:32]

    while i < len(data):
        run = 1
        while i + run < len(data) and data[i + run] == data[i] and run < 265:
            run += 1
        if run < 5:
            literal.append(data[i])
            i += 1
            continue
        literal.append(data[i])
        flush()
        length = run - 1 - 2  # a reference stands for length + 2 bytes
        if length < 7:
            out.append(length << 5)
        else:
            out.extend([7 << 5, length - 7])
        out.append(0)  # distance 1
        i += run
    flush()
    return bytes(out)


def write_pcd():
    rows = "".join(f"{p[0]} {p[1]} {p[2]} -1 1 {p[3]} {p[4]} {p[5]}\n" for p in POINTS)
    (HERE / "ascii.pcd").write_bytes(pcd_header("ascii", 3) + rows.encode())
    (HERE / "binary.pcd").write_bytes(pcd_header("binary", 3) + b"".join(map(pcd_record, POINTS)))
    # Organised: two lines of four beams; those without return are NaN, as the Point Cloud Library has it.
    grid = [POINTS[0], None, None, POINTS[1], None, POINTS[2], None, None]
    grid = [p or (NAN, NAN, NAN, 9, 0.0, 0.0) for p in grid]
    columns = b"".join(
        b"".join(struct.pack("<" + form, *(value if isinstance(value, tuple) else (value,))) for value in column)
        for form, column in (
            ("f", [p[0] for p in grid]), ("f", [p[1] for p in grid]), ("f", [p[2] for p in grid]),
            ("bb", [(-1, 1) for _ in grid]), ("H", [p[3] for p in grid]), ("d", [p[4] for p in grid]),
            ("f", [p[5] for p in grid]),
        )
    )
    packed = lzf(columns)
    assert len(packed) < len(columns)
    (HERE / "compressed.pcd").write_bytes(
        pcd_header("binary_compressed", 8, 2) + struct.pack("<II", len(packed), len(columns)) + packed
    )


def write_ply():
    def header(encoding):
        return (
            f"ply\nformat {encoding} 1.0\ncomment written by hand\nelement camera 1\n"
            "property list uchar short weights\nproperty double focus\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\nproperty list uchar int neighbours\nproperty uchar ring\n"
            "property double epw_m\nproperty float scalar_Intensity\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n"
        ).encode()

    rows = "2 5 6 0.5\n" + "".join(f"{p[0]} {p[1]} {p[2]} 1 4 {p[3]} {p[4]} {p[5]}\n" for p in POINTS) + "3 0 1 2\n"
    (HERE / "ascii.ply").write_bytes(header("ascii").replace(b"\n", b"\r\n") + rows.replace("\n", "\r\n").encode())
    for order, name in (("<", "little"), (">", "big")):
        body = struct.pack(order + "Bhhd", 2, 5, 6, 0.5)
        for p in POINTS:
            body += struct.pack(order + "fffBiBdf", p[0], p[1], p[2], 1, 4, p[3], p[4], p[5])
        body += struct.pack(order + "Biii", 3, 0, 1, 2)
        (HERE / f"{name}.ply").write_bytes(header(f"binary_{name}_endian") + body)


def varint(value):
    out = bytearray()
    while True:
        out.append(value & 0x7F | (0x80 if value > 0x7F else 0))
        value >>= 7
        if not value:
            return bytes(out)


def whole(number, value):
    return varint(number << 3) + varint(value)


def real(number, value):
    return varint(number << 3 | 1) + struct.pack("<d", value)


def message(number, *parts):
    body = b"".join(parts)
    return varint(number << 3 | 2) + varint(len(body)) + body


def trace(*messages):
    return b"".join(struct.pack("<I", len(m)) + m for m in messages)


def stamp(number, nanos):
    return message(number, whole(1, 2), whole(2, nanos))


def version(major=3):
    return message(1, whole(1, major), whole(2, 5), whole(3, 0))


def spherical(p):
    x, y, z = p[:3]
    return real(1, math.sqrt(x * x + y * y + z * z)), real(2, math.atan2(y, x)), real(3, math.atan2(z, math.hypot(x, y)))


def detection(p, *more):
    return message(2, message(3, *spherical(p)), real(7, p[5]), real(11, p[4]), *more)


def sensor_data(nanos, *detections, head=None):
    header = message(1, stamp(1, nanos), whole(2, 4), message(7, whole(1, 9)))
    moving = message(13, message(1, whole(1, 5)))  # a moving object, which we do not read
    return (version() if head is None else head) + stamp(2, nanos) + message(5, whole(1, 9)) + moving + message(
        26, message(3, header, *detections))


def write_osi():
    far = (6.0, 8.0, 0.0, 0, 0.75, 14.0)  # behind the first point: the second echo of its beam
    invalid = detection((9.0, 9.0, 9.0, 0, 1.0, 1.0), whole(9, 2))
    (HERE / "detections.osi").write_bytes(
        trace(
            sensor_data(0, detection(far), detection(POINTS[0]), invalid),
            sensor_data(100),  # a frame in which nothing was detected
            sensor_data(200, detection(POINTS[1]), detection(POINTS[2])),
        )
    )
    (HERE / "version_2.osi").write_bytes(trace(sensor_data(0, detection(POINTS[0]), head=version(2))))
    (HERE / "no_version.osi").write_bytes(trace(sensor_data(0, detection(POINTS[0]), head=b"")))

    def ray(p, strength):
        flight = 2.0 * math.dist(p[:3], (0, 0, 0)) / 299792458.0
        return message(2, real(1, strength), real(2, flight), real(3, -4.0),
                       message(5, real(1, -1.0), real(2, 0.0), real(3, 0.0)), message(6, whole(1, 2**64 - 1)))

    def direction(p):
        length = math.dist(p[:3], (0, 0, 0))
        return message(11, *(real(k + 1, p[k] / length) for k in range(3)))

    configuration = message(1, message(1, whole(1, 9)), real(9, 3.3e14), whole(10, 3), direction(POINTS[0]),
                            direction((1.0, 1.0, 0.0)), direction(POINTS[2]))
    lidar = message(1002, configuration, ray(POINTS[0], -80.5), message(2), ray(POINTS[2], -70.25))
    again = message(1002, message(2), message(2), ray(POINTS[2], -70.0))  # the configuration holds on
    (HERE / "reflections.osi").write_bytes(
        trace(version() + stamp(2, 500000000) + message(3, whole(1, 9)) + lidar,
              version() + stamp(2, 600000000) + message(3, whole(1, 9)) + again)
    )


def write_fan():
    """Two rays each of three beams at 1, 0 and -1 degree, from the right to the left; their powers add up to 100 nW of
    75 W. No normals, no objects, no version 3.7; the ray between the beams and the second message's beam ahead met
    nothing."""
    azimuths = [math.radians(d) for d in (-1, -1, -0.5, 0, 0, 1, 1)]
    directions = [message(11, real(1, math.cos(a)), real(2, math.sin(a)), real(3, 0.0)) for a in azimuths]
    decibel = 10.0 * math.log10(50e-9 / 75.0)

    def ray(range_m):
        return message(2, real(1, decibel), real(2, 2.0 * range_m / 299792458.0)) if range_m else message(2)

    def view(nanos, ranges, configuration=b""):
        return version() + stamp(2, nanos) + message(1002, configuration, *(ray(r) for r in ranges))

    (HERE / "fan.osi").write_bytes(trace(
        view(0, (20, 20, None, 30, 30, 40, 40), message(1, *directions)),
        view(100, (21, 21, None, None, None, 41, 41))))


write_pcd()
write_ply()
write_osi()
write_fan()
