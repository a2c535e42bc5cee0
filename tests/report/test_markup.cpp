// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against text of a net that becomes markup of the page, or makes it unreadable as XML.

#include "report/markup.hpp"

#include <gtest/gtest.h>

namespace taut::report {
namespace {

TEST(Escape, TurnsMarkupAloneIntoEntities) {
    EXPECT_EQ(escape("a net\n\tDübendorf ± 5 µm, ≤ 網 🕸"), "a net\n\tDübendorf ± 5 µm, ≤ 網 🕸");
    EXPECT_EQ(escape("<b a=\"1\" c='2'>&amp;</b>"),
              "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt;");
}

TEST(Escape, ReplacesControlCharacters) {
    EXPECT_EQ(escape(std::string("a\0b\x1b[31m\x7f", 9)), "a\uFFFDb\uFFFD[31m\uFFFD");
    EXPECT_EQ(escape("a\u0085b"), "a\uFFFD\uFFFDb");
    EXPECT_EQ(escape("\uFFFE"), "\uFFFD\uFFFD\uFFFD");
}

TEST(Escape, ReplacesBytesThatAreNotUtf8) {
    EXPECT_EQ(escape("D\xFC"
                     "bendorf"),
              "D\uFFFDbendorf");
    EXPECT_EQ(escape("cut \xE7\xB6"), "cut \uFFFD\uFFFD");
    // "<" in more bytes than it needs, a surrogate, and a code above the last character.
    EXPECT_EQ(escape("\xC0\xBC"), "\uFFFD\uFFFD");
    EXPECT_EQ(escape("\xE0\x80\xBC"), "\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(escape("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(escape("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
    // A started character must not swallow markup that follows it.
    EXPECT_EQ(escape("\xE7<b>"), "\uFFFD&lt;b&gt;");
}

}  // namespace
}  // namespace taut::report
