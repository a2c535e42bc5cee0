// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numerics/buffer.hpp"

namespace taut {

/// Two stacks of numbers for the matrices that fronts pass to their parents, or to their children.
/// Each matrix goes onto the stack of its level in the tree, even or odd: the result of a front
/// never overwrites its inputs, and nothing is moved.
class FrontStacks {
public:
    /// The largest number of entries that each stack has held.
    using Heights = std::array<size_t, 2>;

    /// Empties both stacks and reserves these heights.
    void clear(const Heights& heights) {
        for (Stack& stack : m_stacks) {
            const size_t height = heights[&stack - m_stacks.data()];
            if (stack.room.size() < height) {
                stack.room = Buffer(height);
            }
            stack.top = 0;
        }
    }
    /// @return where they begin
    size_t push(int level, size_t count) {
        Stack& stack = m_stacks[level % 2];
        stack.top += count;
        stack.height = std::max(stack.height, stack.top);
        return stack.top - count;
    }
    size_t pop(int level, size_t count) { return m_stacks[level % 2].top -= count; }
    /// The entries pushed there. They stay valid after pop() until the next push.
    [[nodiscard]] double* at(int level, size_t place) const {
        return m_stacks[level % 2].room.data() + place;
    }
    /// Since construction.
    [[nodiscard]] Heights heights() const { return {m_stacks[0].height, m_stacks[1].height}; }

private:
    struct Stack {
        Buffer room;
        size_t top = 0;
        size_t height = 0;
    };
    std::array<Stack, 2> m_stacks;
};

}  // namespace taut
