// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/team.hpp"

#include <fmt/core.h>

#include <atomic>
#include <utility>

#include "team_work.hpp"

namespace taut {
namespace {

class Alone final : public Team {
public:
    [[nodiscard]] int size() const override { return 1; }
    [[nodiscard]] int rank() const override { return 0; }
    [[nodiscard]] std::vector<std::string> gather(std::string part,
                                                  Receivers /*receivers*/) override {
        return {std::move(part)};
    }
};

std::atomic<Team*>& chosen() {
    static Alone alone;
    static std::atomic<Team*> team{&alone};
    return team;
}

}  // namespace

Team::~Team() = default;

Team& team() {
    return *chosen();
}

void with_team(Team& team, const std::function<void()>& work) {
    struct Chosen {
        Team* before;
        explicit Chosen(Team& team) : before(chosen().exchange(&team)) {}
        ~Chosen() { chosen() = before; }
        Chosen(const Chosen&) = delete;
        Chosen& operator=(const Chosen&) = delete;
        Chosen(Chosen&&) = delete;
        Chosen& operator=(Chosen&&) = delete;
    };
    const Chosen during_work(team);
    work();
}

std::vector<size_t> share_of(size_t count) {
    std::vector<size_t> indices;
    const auto size = static_cast<size_t>(team().size());
    for (auto k = static_cast<size_t>(team().rank()); k < count; k += size) {
        indices.push_back(k);
    }
    return indices;
}

void require_same(std::string_view what, const std::string& fingerprint) {
    if (team().size() == 1) {
        return;
    }
    const std::vector<std::string> all = team().gather(fingerprint, Receivers::all);
    for (size_t rank = 1; rank < all.size(); ++rank) {
        if (all[rank] != all.front()) {
            throw std::runtime_error(fmt::format(
                "process {} of {} has another {} than the first: do all machines see the same "
                "files?",
                rank, all.size(), what));
        }
    }
}

}  // namespace taut
