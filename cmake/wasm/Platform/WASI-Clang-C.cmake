# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
set(CMAKE_C_COMPILE_OPTIONS_PIC "")  # all is linked into one module, where it would cost speed
