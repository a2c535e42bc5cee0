// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <vector>

namespace taut {

/// Disjoint sets of the numbers 0 to count - 1, each with a root; with path halving.
class UnionFind {
public:
    explicit UnionFind(int count) : m_parent(count) {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }
    int root(int member) {
        while (m_parent[member] != member) {
            int& up = m_parent[member];
            up = m_parent[up];
            member = up;
        }
        return member;
    }
    void join(int a, int b) { m_parent[root(a)] = root(b); }

private:
    std::vector<int> m_parent;
};

}  // namespace taut
