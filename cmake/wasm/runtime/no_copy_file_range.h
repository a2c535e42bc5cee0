/* SPDX-FileCopyrightText: 2026 The taut authors */
/* SPDX-License-Identifier: MIT */
/* A call of Linux, which libc++ takes musl for a sign of. */
#include <errno.h>
#include <sys/types.h>

static inline ssize_t copy_file_range(int in, off_t* in_at, int out, off_t* out_at, size_t size, unsigned flags) {
    (void)in, (void)in_at, (void)out, (void)out_at, (void)size, (void)flags;
    errno = ENOSYS;
    return -1;
}
