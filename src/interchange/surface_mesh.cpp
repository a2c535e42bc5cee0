// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surface_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "files/plain_text.hpp"
#include "interchange/obj_statements.hpp"
#include "interchange/ply_reader.hpp"
#include "interchange/polygon_triangles.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

PlyContent read_obj_faces(std::string_view text, const std::string& file_name) {
    PlyContent content;
    for_each_obj_statement(text, file_name, [&](const ObjStatement& statement) {
        if (statement.keyword == "v") {
            content.vertices.push_back(statement.position());
        } else if (statement.keyword == "f") {
            const size_t corners = statement.arguments.size();
            if (corners < 3 || corners > most_corners) {
                statement.fail(
                    fmt::format("a face has {} corners, expected 3 to {}", corners, most_corners));
            }
            std::vector<int> face;
            face.reserve(corners);
            for (const std::string& argument : statement.arguments) {
                face.push_back(
                    statement.vertex(argument, static_cast<int>(content.vertices.size())));
            }
            content.faces.push_back(std::move(face));
        }
    });
    return content;
}

}  // namespace

bool is_surface_mesh_name(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".obj" || ending == ".ply";
}

SurfaceMesh parse_surface_mesh(std::string_view content, const std::string& file_name) {
    const bool is_ply = content.starts_with("ply\n") || content.starts_with("ply\r\n");
    const PlyContent read = is_ply ? read_ply(content, file_name)
                                   : read_obj_faces(table_text(content, file_name), file_name);
    if (read.faces.empty()) {
        throw InputError(
            file_name, "",
            fmt::format("holds {} vertices and no face, expected a surface", read.vertices.size()));
    }
    SurfaceMesh mesh;
    mesh.faces = static_cast<int>(read.faces.size());
    mesh.vertices.resize(3, std::ssize(read.vertices));
    for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i) {
        mesh.vertices.col(i) = read.vertices[static_cast<size_t>(i)];
    }
    for (size_t f = 0; f < read.faces.size(); ++f) {
        const std::vector<int>& face = read.faces[f];
        for (const int corner : face) {
            if (corner >= mesh.vertices.cols()) {
                throw InputError(file_name, fmt::format("face {}", f),
                                 fmt::format("names the vertex {}, expected 0 to {}", corner,
                                             mesh.vertices.cols() - 1));
            }
        }
        for (const auto& [a, b, c] : triangles_of_polygon(mesh.vertices(Eigen::all, face))) {
            mesh.triangles.push_back({face[static_cast<size_t>(a)], face[static_cast<size_t>(b)],
                                      face[static_cast<size_t>(c)]});
        }
    }
    return mesh;
}

}  // namespace taut
