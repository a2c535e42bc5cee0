// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against tables that were cut within their last line: what is left of its last number is
// mostly another number, which nothing else would show.

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

#include "interchange/surface_mesh.hpp"
#include "io/target_list.hpp"
#include "support/errors.hpp"
#include "support/small_nets.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/interchange/net_csv.hpp"
#include "taut/interchange/obj.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/survey_csv.hpp"

namespace taut {
namespace {

using testing::HasSubstr;

const std::string file_name = "a.txt";

/// A table, and what reads it.
struct Table {
    std::string text;
    std::function<void(const std::string&)> read;
};

TEST(CutTable, IsRefusedWhereverItsLastLineWasCut) {
    const std::vector<Table> tables{
        {"id,x,y,z,sx,sy,sz\nA,1,2,3,0.0005,0.0005,0.0005\nB,1,2,33,0.5,0.5,0.55\n",
         [](const std::string& text) { (void)parse_survey_points(text, file_name); }},
        {"2\n1 2 3\n4 5 66\n",
         [](const std::string& text) { (void)parse_pts_points(text, file_name); }},
        {"Name;X;Y;Z\nA;1;2;3\nB;1;2;33\n",
         [](const std::string& text) { (void)read_foreign_survey(text, file_name); }},
        {"1.25 2 3\n1 2 33\n",
         [](const std::string& text) {
             (void)read_foreign_survey(text, file_name, {.format = SurveyFormat::xyz});
         }},
        {"station,target,hz [gon],v [gon],distance [m]\nS,A,1,99,2.5\nS,B,1,99,2.5\n",
         [](const std::string& text) { (void)parse_polar_csv(text, file_name, {}); }},
        {"edge,tension\naB,1000\nab,20000\n",
         [](const std::string& text) {
             (void)parse_force_measurements(test::two_node_net(), text, file_name, {});
         }},
        {"12\n345\n", [](const std::string& text) { (void)parse_target_list(text, file_name); }},
        {"id,x,y,z,is_free\n0,0,0,0,0\n1,1,0,0,1\n2,2,0,0,0\n",
         [](const std::string& text) {
             (void)parse_net_csv({.nodes = text, .edges = "s,t,q\n0,1,5\n1,2,5\n"}, file_name,
                                 "edges.csv");
         }},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\nl 2 3\n",
         [](const std::string& text) { (void)parse_obj(text, file_name); }},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 2 0 11\n",
         [](const std::string& text) { (void)parse_surface_mesh(text, file_name); }},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement "
         "vertex 3\nproperty double x\nproperty double y\nproperty double z\nend_header\n3 0 1 "
         "2\n0 0 0\n1 0 0\n0 1 12.5\n",
         [](const std::string& text) { (void)parse_surface_mesh(text, file_name); }}};
    for (const Table& table : tables) {
        SCOPED_TRACE(table.text);
        table.read(table.text);
        ASSERT_TRUE(table.text.ends_with('\n'));
        const size_t last = table.text.find_last_of('\n', table.text.size() - 2) + 1;
        for (size_t length = last + 1; length < table.text.size(); ++length) {
            const std::string cut = table.text.substr(0, length);
            EXPECT_FALSE(test::succeeds_or_refuses([&] { return table.read(cut), 0; })) << cut;
        }
        const auto line = 1 + std::ranges::count(table.text.substr(0, last), '\n');
        EXPECT_EQ(
            test::input_error_of(
                [&] { return table.read(table.text.substr(0, table.text.size() - 1)), 0; }),
            fmt::format("{}:{}: is the last line and has no line break, expected one as behind "
                        "all others: is the file whole?",
                        file_name, line));
    }
}

TEST(CutTable, IsNotSeenInASingleLineNorInBlanksBehindTheLast) {
    EXPECT_EQ(parse_survey_points("A,1,2,3", file_name).size(), 1U);
    EXPECT_EQ(parse_survey_points("A,1,2,3\nB,1,2,3\n  ", file_name).size(), 2U);
    EXPECT_EQ(parse_survey_points("A,1,2,3\r\nB,1,2,3\r", file_name).size(), 2U);
    // The sign with which DOS, and instruments of its time, end a file.
    EXPECT_EQ(read_foreign_survey("Name;X;Y;Z\r\nA;1;2;3\r\n\x1A", file_name).points.size(), 1U);
    EXPECT_EQ(read_foreign_survey("Name;X;Y;Z\rA;1;2;3\r", file_name).points.size(), 1U);
    EXPECT_THAT(test::input_error_of(
                    [] { return read_foreign_survey("Name;X;Y;Z\rA;1;2;3\rB;1;2;3", file_name); }),
                HasSubstr(":3: is the last line"));
}

}  // namespace
}  // namespace taut
