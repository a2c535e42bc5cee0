/* SPDX-FileCopyrightText: 2026 The taut authors */
/* SPDX-License-Identifier: MIT */
#include <pthread.h>

/* The tag that all exceptions of C++ have, and that no library of ziglang defines. */
__asm__(
    ".globl __cpp_exception\n"
    ".tagtype __cpp_exception i32\n"
    "__cpp_exception:\n");

/* There is one thread, so every mutex is free. wasi-libc's own fail for a recursive one: they compare
   its type by "!=", which binds tighter than the "&" before it. */
int pthread_mutex_lock(pthread_mutex_t* mutex) {
    (void)mutex;
    return 0;
}

int pthread_mutex_trylock(pthread_mutex_t* mutex) {
    (void)mutex;
    return 0;
}

int pthread_mutex_unlock(pthread_mutex_t* mutex) {
    (void)mutex;
    return 0;
}
