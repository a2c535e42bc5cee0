/* SPDX-FileCopyrightText: 2026 The taut authors */
/* SPDX-License-Identifier: MIT */
/* What HDF5 takes for granted and wasi-libc does not have: time zones, and flags of floating point. */
#define FE_INVALID 0

static inline void tzset(void) {}
