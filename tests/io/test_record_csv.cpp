// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a column of a record that is taken for another.

#include "taut/io/record_csv.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "taut/files/file.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using testing::HasSubstr;

/// Lines of 0.00, 0.01, ... s with signals k and -2 k.
std::string rows(const std::string& format, int count = 8) {
    std::string text;
    for (int k = 0; k < count; ++k) {
        text += fmt::format(fmt::runtime(format), 0.01 * k, k, -2.0 * k, 1000000000LL * k);
    }
    return text;
}

TEST(RecordCsv, IsReadAsAppsWriteIt) {
    const std::string phyphox = "\"Time (s)\",\"Acceleration x (m/s^2)\",\"y\"\n";
    for (const std::string& text :
         {rows("{:.2f},{},{}\n"), rows("{:.2f};{};{}\n"), rows("{:.2f}\t{}\t{}\n"),
          phyphox + rows("{:.2f},{},{}\n"),
          "\xEF\xBB\xBF\"Time (s)\"\t\"x (g)\"\t\"y (g)\"\r\n" + rows("{:.2f}\t{}\t{}\r\n"),
          "Time (s)\tx axis (g)\ty axis (g)\n" + rows("{:.2f}\t{}\t{}\n"),
          "time,seconds_elapsed,x,y\n" + rows("{3},{0:.2f},{1},{2}\n"),
          "x;y;Zeit [s]\n" + rows("{1};{2};{0:.2f}\n")}) {
        const VibrationRecord record = parse_vibration_record(text, "r.csv");
        ASSERT_EQ(record.signals.rows(), 8) << text;
        EXPECT_NEAR(record.rate, 100.0, 1e-9) << text;
        ASSERT_EQ(record.signals.cols(), 2) << text;
        EXPECT_EQ(record.signals(7, 0), 7.0) << text;
        EXPECT_EQ(record.signals(7, 1), -14.0) << text;
    }
    EXPECT_NEAR(parse_vibration_record("t;a\n0,00;1,5\n0,01;2\n0,02;3\n", "r.csv").signals(0), 1.5,
                1e-12);
    EXPECT_NEAR(parse_vibration_record("time (ms),a\n0,1\n5,2\n10,3\n", "r.csv").rate, 200.0, 1e-9);
    EXPECT_EQ(parse_vibration_record("a\n1\n2\n3\n", "r.csv", 250.0).rate, 250.0);
}

TEST(RecordCsv, OfAPluckedCableHasItsFundamental) {
    // The frequencies of tests/data/records/make_record.py.
    const CableFrequency found = cable_frequency(parse_vibration_record(
        read_file(TAUT_TEST_DATA_DIR "/records/plucked.csv"), "plucked.csv"));
    ASSERT_TRUE(found.fundamental) << found.message;
    EXPECT_NEAR(found.fundamental->frequency, 5.1268, 3.0 * found.fundamental->std_dev);
    EXPECT_LT(found.fundamental->std_dev, 0.02);
}

TEST(RecordCsv, OfAnEdgeIsALineForIdentify) {
    Fundamental fundamental;
    fundamental.frequency = 4.5;
    fundamental.std_dev = 0.01;
    EXPECT_EQ(frequency_to_csv("a,b", fundamental),
              "edge,frequency,mode,std\n\"a,b\",4.5,1,0.01\n");
}

TEST(RecordCsv, IsRefusedWithLineAndRule) {
    expect_refused("r.csv",
                   {{"", ": holds no sample..."},
                    {"t,a\n", ": holds no sample..."},
                    {"a\n1\n2\n", ": has one column..."},
                    {"time,timestamp\n1,1\n2,2\n", ": has no column of..."},
                    {"t,a\n0,1\n0.01,nan\n", ":3: holds 'nan'..."},
                    {"t,a\n0,1\n0.01,high\n", ":3: holds 'high'..."},
                    {"t,a\n0,1\n0.01\n", ":3: has 1 fields..."},
                    {"t,a\n0,1\n0.01,2\n0.02", ":4: is the last line..."},
                    {"t,a\n0,1\n0.01,2\n\n0.01,3\n", ":5: time is 0.01 s..."},
                    {"t,a\n" + rows("{:.2f},{}\n") + "1.5,3\n", ":10: time is 1.43..."},
                    {rows("{1}0,{2}\n"), ":2: the median time step is 10 s..."}},
                   [](const std::string& text) { return parse_vibration_record(text, "r.csv"); });
}

TEST(RecordCsv, WithTimesAndARateIsRefused) {
    EXPECT_THAT(input_error_of([] { return parse_vibration_record("t,a\n0,1\n", "r.csv", 200.0); }),
                HasSubstr("leave it out"));
}

}  // namespace
