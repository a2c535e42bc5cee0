// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/polygon_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

namespace taut {
namespace {

class EarCutting {
public:
    explicit EarCutting(const Eigen::Matrix3Xd& corners)
        : m_corners(corners), m_left(static_cast<size_t>(corners.cols())) {
        std::iota(m_left.begin(), m_left.end(), 0);
        // Twice the area vector (M. E. Newell), from the first corner to lose no digits.
        for (Eigen::Index i = 1; i + 1 < corners.cols(); ++i) {
            m_up += (corners.col(i) - corners.col(0)).cross(corners.col(i + 1) - corners.col(0));
        }
    }

    std::vector<std::array<int, 3>> cut() {
        std::vector<std::array<int, 3>> triangles;
        while (m_left.size() > 3) {
            const size_t ear = best_ear();
            triangles.push_back(triple(ear));
            m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        triangles.push_back(triple(1));
        return triangles;
    }

private:
    [[nodiscard]] std::array<int, 3> triple(size_t i) const {
        return {m_left[(i + m_left.size() - 1) % m_left.size()], m_left[i],
                m_left[(i + 1) % m_left.size()]};
    }

    /// Twice the area of three corners, seen along the polygon's normal, in its units.
    [[nodiscard]] double area(int a, int b, int c) const {
        return m_up.dot(
            (m_corners.col(b) - m_corners.col(a)).cross(m_corners.col(c) - m_corners.col(a)));
    }

    [[nodiscard]] bool is_ear(size_t i) const {
        const auto [a, b, c] = triple(i);
        return area(a, b, c) > 0.0 && std::ranges::none_of(m_left, [&, a = a, b = b, c = c](int p) {
                   return p != a && p != b && p != c && area(a, b, p) >= 0.0 &&
                          area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
               });
    }

    /// The ear with the shortest new side; of a polygon without ears, one that crosses itself or
    /// has no area, any corner will do.
    [[nodiscard]] size_t best_ear() const {
        size_t best = 0;
        double shortest = std::numeric_limits<double>::infinity();
        for (size_t i = 0; i < m_left.size(); ++i) {
            const auto [a, b, c] = triple(i);
            const double side = (m_corners.col(a) - m_corners.col(c)).squaredNorm();
            if (side < shortest && is_ear(i)) {
                shortest = side;
                best = i;
            }
        }
        return best;
    }

    const Eigen::Matrix3Xd& m_corners;
    std::vector<int> m_left;
    Eigen::Vector3d m_up = Eigen::Vector3d::Zero();
};

}  // namespace

std::vector<std::array<int, 3>> triangles_of_polygon(const Eigen::Matrix3Xd& corners) {
    return EarCutting(corners).cut();
}

}  // namespace taut
