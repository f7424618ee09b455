#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the inputs in Corpus/PointSearch that are made by hand; PointSearchInput.h reads them."""
from pathlib import Path

FLOAT, DOUBLE = 0, 1
ONE_PER_LEAF, FOUR_PER_LEAF = 0, 3
DEEPEST = 0
MEDIAN, ROOT = 0, 2

# The scales, offsets and border cases are numbered as in BorderNumbers.h.
TO_MINUS_30, NANO, THOUSAND = 4, 5, 10
MILLION = 4
NOT_A_NUMBER, INFINITE, GREATEST, QUARTER_OF_GREATEST, LEAST_NORMAL = 0, 1, 3, 6, 10


def step(number, argument=0):
    return bytes([argument * 16 + number])


def point(x, y, z):
    return step(0) + bytes(c % 256 for c in (x, y, z))


def copies(of, count):
    return step(2, count - 1) + bytes([of])


def lattice(side):
    return step(3, side - 2) + bytes(3)


def cloud(seed):
    return step(4, 15) + bytes([seed])


def scale(number):
    return step(6, number)


def origin(number):
    return step(7, 2 * number)


def special(of, axis, value):
    return step(8, axis) + bytes([of, value])


def ask(argument, *position):
    """All kinds of queries at one position."""
    where = bytes(position)
    closest, closest_within, few, within = (
        step(number, argument) + where for number in (12, 9, 10, 11))
    queries = closest + bytes(1) + few + bytes([20])
    for neighbor in (0, 2, 9):
        for kind in (0, 2, 3):  # at the neighbor, just before, just beyond
            queries += (within if neighbor else closest_within) + bytes([neighbor * 8 + kind])
    return queries


def box(of, other):
    """A query for the points in the box between two of them."""
    return step(15, AT_POINT) + bytes([of, AT_POINT, other])


AT_POINT, NEARBY, BESIDE_POINT, BETWEEN, AT_BORDER = 0, 2, 3, 5, 6

INPUTS = {
    "empty": b"",
    "one-point": bytes([DOUBLE, ONE_PER_LEAF, DEEPEST, MEDIAN]) + point(3, -4, 5)
    + ask(AT_POINT, 0) + ask(NEARBY, 3, 3, 3),
    "all-equal": bytes([FLOAT, FOUR_PER_LEAF, DEEPEST, MEDIAN]) + point(3, -4, 5)
    + 6 * copies(0, 16) + ask(AT_POINT, 0) + ask(BESIDE_POINT, 2, 0),
    "outlier-and-dense-spot": bytes([DOUBLE, ONE_PER_LEAF, DEEPEST, MEDIAN]) + scale(TO_MINUS_30)
    + cloud(1) + cloud(2) + scale(THOUSAND) + point(1, 1, 1) + ask(AT_POINT, 7) + ask(BETWEEN, 7, 9),
    "lattice-ties": bytes([FLOAT, ONE_PER_LEAF, DEEPEST, ROOT]) + lattice(5)
    + ask(AT_POINT, 62) + ask(BETWEEN, 62, 93) + box(0, 62) + box(31, 93),
    "not-finite": bytes([DOUBLE, ONE_PER_LEAF, DEEPEST, MEDIAN]) + lattice(3)
    + special(0, 0, NOT_A_NUMBER) + special(1, 1, INFINITE) + special(2, 2, GREATEST)
    + special(3, 0, QUARTER_OF_GREATEST) + ask(AT_BORDER, 0, 4, NOT_A_NUMBER)
    + ask(AT_BORDER, 0, 4, GREATEST),
    "far-offset": bytes([DOUBLE, FOUR_PER_LEAF, DEEPEST, MEDIAN]) + origin(MILLION) + scale(NANO)
    + cloud(3) + ask(AT_POINT, 5) + ask(BESIDE_POINT, 2, 5),
    "squares-underflow": bytes([DOUBLE, ONE_PER_LEAF, DEEPEST, MEDIAN]) + point(0, 0, 0)
    + special(0, 0, LEAST_NORMAL) + special(0, 1, LEAST_NORMAL) + ask(AT_POINT, 0) + ask(AT_POINT, 2),
}

corpus = Path(__file__).parent / "Corpus" / "PointSearch"
for name, content in INPUTS.items():
    (corpus / name).write_bytes(content)
