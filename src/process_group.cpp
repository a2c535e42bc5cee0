// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/process_group.hpp"

#include <fmt/core.h>

#include <atomic>
#include <utility>

#include "shared_work.hpp"

namespace taut {
namespace {

class SingleProcess final : public ProcessGroup {
public:
    [[nodiscard]] int size() const override { return 1; }
    [[nodiscard]] int rank() const override { return 0; }
    [[nodiscard]] std::vector<std::string> gather(std::string part,
                                                  Receivers /*receivers*/) override {
        return {std::move(part)};
    }
};

std::atomic<ProcessGroup*>& group_in_use() {
    static SingleProcess single;
    static std::atomic<ProcessGroup*> group{&single};
    return group;
}

}  // namespace

ProcessGroup::~ProcessGroup() = default;

ProcessGroup& process_group() {
    return *group_in_use();
}

void with_process_group(ProcessGroup& group, const std::function<void()>& work) {
    struct Scope {
        ProcessGroup* before;
        explicit Scope(ProcessGroup& group) : before(group_in_use().exchange(&group)) {}
        ~Scope() { group_in_use() = before; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        Scope(Scope&&) = delete;
        Scope& operator=(Scope&&) = delete;
    };
    const Scope during_work(group);
    work();
}

std::vector<size_t> share_of(size_t count) {
    std::vector<size_t> indices;
    const auto size = static_cast<size_t>(process_group().size());
    for (auto k = static_cast<size_t>(process_group().rank()); k < count; k += size) {
        indices.push_back(k);
    }
    return indices;
}

void require_same(std::string_view what, const std::string& fingerprint) {
    if (process_group().size() == 1) {
        return;
    }
    const std::vector<std::string> all = process_group().gather(fingerprint, Receivers::all);
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
