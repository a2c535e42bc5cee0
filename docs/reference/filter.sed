# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# What Doxygen is shown of a header. Each gets a page, with what it declares; attributes say nothing to
# a reader; and "eq. SOCP" ends no sentence.
s|^#pragma once|/** @file */|
s/\[\[nodiscard\]\] //
/\/\/\//s/\<\(eqs\{0,1\}\)\. /\1.\\ /g
