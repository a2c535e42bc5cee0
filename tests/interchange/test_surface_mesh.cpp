// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a surface that is read as another one: coordinates that lose digits, faces of the
// wrong vertices, a polygon that is cut outside of itself, and a file that is cut.
#include "interchange/surface_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstring>

#include "support/errors.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::string& text) {
    return test::input_error_of([&] { return parse_surface_mesh(text, "roof.ply"); });
}

double area_of(const SurfaceMesh& mesh) {
    double area = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        area += 0.5 * (mesh.vertices.col(b) - mesh.vertices.col(a))
                          .cross(mesh.vertices.col(c) - mesh.vertices.col(a))
                          .norm();
    }
    return area;
}

template <typename T>
void append(std::string& bytes, T value, bool big) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, raw.size());
    if (big == (std::endian::native == std::endian::little)) {
        std::ranges::reverse(raw);
    }
    bytes.append(raw.data(), raw.size());
}

/// Two faces, a quadrilateral and a triangle, with more properties than are wanted.
std::string binary_ply(bool big) {
    std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                        "_endian 1.0\ncomment of a test\nelement vertex 5\nproperty double x\n"
                        "property double y\nproperty uchar red\nproperty double z\n"
                        "element face 2\nproperty float quality\n"
                        "property list uchar int vertex_indices\nelement edge 1\n"
                        "property list ushort short nothing\nend_header\n";
    const double far = 500000.0001;
    for (const auto& [x, y] :
         {std::pair{far, 0.0}, {far + 1, 0.0}, {far + 1, 1.0}, {far, 1.0}, {far + 2, 0.5}}) {
        append(bytes, x, big);
        append(bytes, y, big);
        append(bytes, std::uint8_t{200}, big);
        append(bytes, 0.25, big);
    }
    for (const std::vector<int>& face : {std::vector{0, 1, 2, 3}, std::vector{1, 4, 2}}) {
        append(bytes, 0.5F, big);
        append(bytes, static_cast<std::uint8_t>(face.size()), big);
        for (const int corner : face) {
            append(bytes, corner, big);
        }
    }
    append(bytes, std::uint16_t{2}, big);
    append(bytes, std::int16_t{1}, big);
    append(bytes, std::int16_t{-7}, big);
    return bytes;
}

const std::string text_ply =
    "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\n"
    "property float z\r\nelement face 1\r\nproperty list uchar int vertex_index\r\nend_header\r\n"
    "0 0 0\r\n1 0 0\r\n1 1 0\r\n500000.0001 1e0 -0.5\r\n4 0 1 2 3\r\n";

TEST(ParseSurfaceMesh, ReadsBinaryPlyOfBothByteOrdersToTheLastDigit) {
    for (const bool big : {false, true}) {
        const SurfaceMesh mesh = parse_surface_mesh(binary_ply(big), "roof.ply");
        ASSERT_EQ(mesh.vertices.cols(), 5);
        EXPECT_EQ(mesh.vertices.col(0), Eigen::Vector3d(500000.0001, 0.0, 0.25));
        EXPECT_EQ(mesh.faces, 2);
        EXPECT_EQ(mesh.triangles.size(), 3U);
        EXPECT_NEAR(area_of(mesh), 1.5, 1e-9);
    }
}

TEST(ParseSurfaceMesh, ReadsPlyOfText) {
    const SurfaceMesh mesh = parse_surface_mesh(text_ply, "roof.ply");
    ASSERT_EQ(mesh.vertices.cols(), 4);
    EXPECT_EQ(mesh.vertices(0, 3), 500000.0001);
    EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST(ParseSurfaceMesh, ReadsTheFacesOfObj) {
    const SurfaceMesh mesh = parse_surface_mesh(
        "# roof\nmtllib roof.mtl\no roof\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.0 1 0 0\nvn 0 0 1\n"
        "l 1 2\nf 1/1 2/2 3//1 -1\n",
        "roof.obj");
    EXPECT_EQ(mesh.vertices.cols(), 4);
    EXPECT_NEAR(area_of(mesh), 1.0, 1e-15);
}

TEST(ParseSurfaceMesh, CutsPolygonsWithinThemselves) {
    // An L, whose area a fan about its first corner does not have.
    const SurfaceMesh mesh = parse_surface_mesh(
        "v 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4 5 6\n"
        "v 0 0 5\nv 3 1 5\nv 0 2 5\nv 1 1 5\nf 7 8 9 10\n",
        "roof.obj");
    EXPECT_EQ(mesh.triangles.size(), 6U);
    EXPECT_NEAR(area_of(mesh), 3.0 + 2.0, 1e-12);
    // A warped quadrilateral along its shorter diagonal, 2 to 4.
    const SurfaceMesh warped = parse_surface_mesh(
        "v 0 0 0\nv 1.2 0.4 0.1\nv 2 2 0\nv 0.4 1.2 0.1\nf 1 2 3 4\n", "roof.obj");
    for (const auto& triangle : warped.triangles) {
        EXPECT_TRUE(std::ranges::count(triangle, 1) == 1 && std::ranges::count(triangle, 3) == 1);
    }
}

TEST(ParseSurfaceMesh, RefusesWhatIsNoSurfaceAndSaysWhere) {
    EXPECT_THAT(error_of("v 0 0 0\nv 1 0 0\nl 1 2\n"), HasSubstr("2 vertices and no face"));
    EXPECT_THAT(error_of(""), HasSubstr("no face"));
    EXPECT_THAT(error_of("v 0 0 0\nv 1 0 nan\n"), HasSubstr("roof.ply:2: z is 'nan'"));
    EXPECT_THAT(error_of("v 0 0 0\nf 1 2 3\n"), HasSubstr("roof.ply:2: names the vertex '2'"));
    EXPECT_THAT(error_of("v 0 0 0\nv 1 0 0\nf 1 2\n"), HasSubstr("2 corners"));
    EXPECT_THAT(error_of("solid stl\n"), HasSubstr("roof.ply:1: starts with 'solid'"));
    const std::string binary = binary_ply(false);
    for (const size_t cut : {size_t{3}, size_t{60}, binary.size() - 1, binary.size() - 40}) {
        EXPECT_THAT(error_of(binary.substr(0, cut)), HasSubstr("roof.ply:")) << cut;
    }
    EXPECT_THAT(error_of(binary.substr(0, binary.size() - 40)), HasSubstr("roof.ply:face 0: ends"));
    EXPECT_THAT(error_of(binary + "x"), HasSubstr("goes on"));
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = text_ply;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_THAT(error_of(with("4 0 1 2 3", "4 0 1 2 4")), HasSubstr("names the vertex 4"));
    EXPECT_THAT(error_of(with("4 0 1 2 3", "2 0 1")), HasSubstr("roof.ply:14: a face has 2"));
    EXPECT_THAT(error_of(with("4 0 1 2 3", "4 0 1 2 0.5")), HasSubstr("vertex 0.5"));
    EXPECT_THAT(error_of(with("4 0 1 2 3", "4 0 1 2")), HasSubstr("ends before"));
    EXPECT_THAT(error_of(with("1e0", "inf")), HasSubstr("roof.ply:13: holds 'inf'"));
    EXPECT_THAT(error_of(with("vertex 4", "vertex 4.5")), HasSubstr("'4.5' elements"));
    EXPECT_THAT(error_of(with("vertex 4", "vertex 999999999")), HasSubstr("ends before"));
    EXPECT_THAT(error_of(with("property float z", "comment")), HasSubstr("no x, y and z"));
    EXPECT_THAT(error_of(with("vertex_index", "corners")), HasSubstr("no list vertex_indices"));
    EXPECT_THAT(error_of(with("ascii", "binary")), HasSubstr("roof.ply:2: the format is 'binary'"));
    EXPECT_THAT(error_of(with("format ascii 1.0", "comment")), HasSubstr("without a format"));
    EXPECT_THAT(error_of(with("float x", "real x")), HasSubstr("the type 'real'"));
}

TEST(ParseSurfaceMesh, IsChosenByTheEndOfTheName) {
    EXPECT_TRUE(is_surface_mesh_name("a/roof.OBJ"));
    EXPECT_TRUE(is_surface_mesh_name("roof.ply"));
    EXPECT_FALSE(is_surface_mesh_name("roof.csv"));
    EXPECT_FALSE(is_surface_mesh_name("ply"));
}

}  // namespace
}  // namespace taut
