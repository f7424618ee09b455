#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the inputs in Corpus/LeafSearch that are made by hand; LeafSearchInput.h reads them."""
from pathlib import Path

DIMENSIONS = {3: 0, 2: 1, 1: 2, 4: 3}
ONE_PER_LEAF = 0
DEEPEST = 0
GIVEN_POSITION = 1
TO_CORNER, BORDER_CASE = 0, 3
NOT_A_NUMBER, INFINITE, NEGATIVE = 0, 1, 15  # numbered as in BorderNumbers.h


def step(number, argument=0):
    return bytes([argument * 8 + number])


def point(*x):
    """In units of the root's side / 256."""
    return step(0) + bytes(x)


def beside(of, axis, depth):
    """The side of a cell of the depth away."""
    return step(2, 2 * axis) + bytes([of, depth])


def query(x, depth, start_depth, kind, *radius):
    return (step(5, 2 * kind + GIVEN_POSITION) + bytes(x) + bytes([depth, start_depth])
            + bytes(radius))


def ties(dimension, cell, start_depth):
    """A node of depth 3, and balls that just reach the corners of cells around it."""
    x = [32 * cell + 1] * dimension
    tree = bytes([DIMENSIONS[dimension], ONE_PER_LEAF, DEEPEST])
    tree += point(*x) + beside(0, 0, 7) + point(*[10] * dimension)
    tree += point(200, *[100] * (dimension - 1)) + point(*[140] * dimension)
    for halves in ([1, 0, 0], [1, 1, 1], [3, 0, 0], [3, 0, 1], [3, 3, 3], [5, 1, 3], [7, 7, 7]):
        distance = halves[:dimension] + [0] * (dimension - 3)
        tree += query(x, 3, start_depth, TO_CORNER, *distance)
    return tree


INPUTS = {
    f"ties-{dimension}d-around-cell-{cell}": ties(dimension, cell, start_depth)
    for dimension in DIMENSIONS for cell, start_depth in ((3, 0), (5, 5))
}
INPUTS["no-radius"] = bytes([DIMENSIONS[3], ONE_PER_LEAF, DEEPEST]) + point(1, 2, 3) + point(
    9, 9, 9) + b"".join(
        query([1, 2, 3], 4, 2, BORDER_CASE, 2 * radius)
        for radius in (NOT_A_NUMBER, INFINITE, NEGATIVE))

corpus = Path(__file__).parent / "Corpus" / "LeafSearch"
for name, content in INPUTS.items():
    (corpus / name).write_bytes(content)
