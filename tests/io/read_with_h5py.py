#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Reads an HDF5 file with h5py alone and prints all that it holds as JSON.

Usage: read_with_h5py.py FILE

{"attributes": {name: value}, "datasets": {path: {"shape", "type", "attributes", "values"}}}, with
the values of a dataset in one list, row by row, and floating point numbers in digits that read back
to the same bits. Ends with code 77 where h5py is not installed.
"""

import json
import sys

try:
    import h5py
    import numpy
except ImportError:
    sys.exit(77)


def plain(value):
    """What h5py gives as Python's own number or text."""
    if isinstance(value, bytes):
        return value.decode("utf-8")
    return value.item() if isinstance(value, numpy.generic) else value


def attributes_of(item):
    return {name: plain(value) for name, value in item.attrs.items()}


def describe(dataset):
    values = numpy.asarray(dataset[()])
    return {
        "shape": list(dataset.shape),
        "type": str(dataset.dtype),
        "attributes": attributes_of(dataset),
        "values": [plain(value) for value in values.reshape(-1).tolist()],
    }


def main():
    datasets = {}
    with h5py.File(sys.argv[1], "r") as file:

        def visit(name, item):
            if isinstance(item, h5py.Dataset):
                datasets[name] = describe(item)

        file.visititems(visit)
        json.dump({"attributes": attributes_of(file), "datasets": datasets}, sys.stdout)


if __name__ == "__main__":
    main()
