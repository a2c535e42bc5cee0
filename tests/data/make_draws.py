#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Prints the first length deviations of sample 0 under uniform:5mm and seed 1, as pinned in
tests/sampling/test_data_set.cpp.

The seed sequence and the engine are written out here from the C++ standard ([rand.util.seedseq],
[rand.eng.mers]), so that they check the standard library in use as well.
"""


def seed_sequence(values, n):
    """n 32-bit words, n at least 623 (for the constants t)."""
    mask = 0xFFFFFFFF
    words = [0x8B8B8B8B] * n
    s = len(values)
    t = 11
    p = (n - t) // 2
    q = p + t
    m = max(s + 1, n)

    def mix(x):
        return x ^ (x >> 27)

    for k in range(m):
        r1 = 1664525 * mix(words[k % n] ^ words[(k + p) % n] ^ words[(k - 1) % n]) & mask
        r2 = r1 + (s if k == 0 else k % n + values[k - 1] if k <= s else k % n) & mask
        words[(k + p) % n] = words[(k + p) % n] + r1 & mask
        words[(k + q) % n] = words[(k + q) % n] + r2 & mask
        words[k % n] = r2
    for k in range(m, m + n):
        r3 = 1566083941 * mix(words[k % n] + words[(k + p) % n] + words[(k - 1) % n] & mask) & mask
        r4 = r3 - k % n & mask
        words[(k + p) % n] ^= r3
        words[(k + q) % n] ^= r4
        words[k % n] = r4
    return words


def mersenne_twister_64(values, count):
    """The first count numbers, at most 312, of std::mt19937_64 seeded by a sequence of values."""
    n, m = 312, 156
    words = seed_sequence(values, 2 * n)
    state = [words[2 * i] | words[2 * i + 1] << 32 for i in range(n)]
    for k in range(n):
        y = state[k] & ~0x7FFFFFFF | state[(k + 1) % n] & 0x7FFFFFFF
        state[k] = state[(k + m) % n] ^ y >> 1 ^ (0xB5026F5AA96619E9 if y & 1 else 0)
    for y in state[:count]:
        y ^= y >> 29 & 0x5555555555555555
        y ^= y << 17 & 0x71D67FFFEDA60000
        y ^= y << 37 & 0xFFF7EEE000000000
        yield y ^ y >> 43


for number in mersenne_twister_64([1, 0, 0, 0], 3):
    u = ((number >> 12) + 0.5) * 2.0**-52
    print(repr(0.005 * (2.0 * u - 1.0)))
