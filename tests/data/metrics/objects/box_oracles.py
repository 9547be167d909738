#!/usr/bin/env python3
"""Shared areas of oriented boxes from shapely, for tests/metrics/objects. Run: python3 box_oracles.py > box_oracles.csv

A line is x, y, length, width, yaw of one box, the same of another, and the area of their intersection.
"""
from math import cos, sin

import numpy as np
from shapely.geometry import Polygon


def polygon(x, y, length, width, yaw):
    corners = [(0.5 * u * length, 0.5 * v * width) for u, v in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    return Polygon([(x + cos(yaw) * a - sin(yaw) * b, y + sin(yaw) * a + cos(yaw) * b) for a, b in corners])


random = np.random.default_rng(24)
for _ in range(200):
    numbers = random.uniform([-2.0, -2.0, 0.2, 0.2, -7.0], [2.0, 2.0, 6.0, 6.0, 7.0], (2, 5)).round(3)
    boxes = [tuple(map(float, box)) for box in numbers]
    shared = polygon(*boxes[0]).intersection(polygon(*boxes[1])).area
    print(",".join(repr(float(number)) for number in (*boxes[0], *boxes[1], shared)))
