// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "fuzz.hpp"
#include "interchange/surface_mesh.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace taut;
    return fuzz::refuse_or_read([&] {
        const SurfaceMesh mesh = parse_surface_mesh(fuzz::text_of(data, size), "roof.ply");
        fuzz::require(mesh.vertices.allFinite());
        for (const auto& triangle : mesh.triangles) {
            for (const int corner : triangle) {
                fuzz::require(corner >= 0 && corner < mesh.vertices.cols());
            }
        }
    });
}
