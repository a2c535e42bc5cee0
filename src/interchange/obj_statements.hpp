// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// A line of an OBJ file that says something.
struct ObjStatement {
    std::string file_name;
    int line = 0;
    std::string keyword;
    std::vector<std::string> arguments;

    /// @throws InputError with the line
    [[noreturn]] void fail(const std::string& what) const;

    /// "v x y z": the first three coordinates. @throws InputError
    [[nodiscard]] Eigen::Vector3d position() const;

    /// The vertex, from 0, that an argument names: "7", "-1" (the last so far) or "7/1/3".
    /// @param count of the vertices so far
    /// @throws InputError
    [[nodiscard]] int vertex(const std::string& argument, int count) const;
};

/// Reports each statement that may concern vertices and what they make: v, f, l, p and g. Normals,
/// textures and materials are passed over.
/// @throws InputError with the line of a keyword that OBJ does not have
void for_each_obj_statement(std::string_view text, const std::string& file_name,
                            const std::function<void(const ObjStatement&)>& take);

}  // namespace taut
