// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "memory_limit.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "taut/net/units.hpp"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace taut::app {
namespace {

constexpr double mebibyte = 1024.0 * 1024.0;
constexpr double gibibyte = 1024.0 * mebibyte;

struct Limit {
    double bytes;
    double reserve;    ///< what libraries take when work begins [bytes]
    std::string text;  ///< as given
    std::string note;
};
std::optional<Limit> limit;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// "1.6 GiB", "12 MiB": no less than it is.
std::string at_least_text(double bytes) {
    return bytes < gibibyte ? fmt::format("{:.0f} MiB", std::ceil(bytes / mebibyte))
                            : fmt::format("{:.1f} GiB", std::ceil(10.0 * bytes / gibibyte) / 10.0);
}

#ifdef __wasi__
constexpr double of_thread = 0.0;  // neither OpenBLAS nor threads

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::uint64_t most_bytes = std::numeric_limits<std::uint64_t>::max();

std::uint64_t bytes_in_use() {
    return std::uint64_t{65536} * __builtin_wasm_memory_size(0);
}

double memory_in_use() {
    return static_cast<double>(bytes_in_use());
}

void keep_to(std::uint64_t bytes) {
    most_bytes = bytes;
}
#elif defined(__linux__)
// A buffer of OpenBLAS and a stack.
constexpr double of_thread = (128.0 + 8.0) * mebibyte;

/// What counts against the limit now, by the system [bytes]; 0 where that is not known.
double memory_in_use() {
    std::ifstream status("/proc/self/status");
    for (std::string key; status >> key;) {
        if (double kibibytes = 0.0; key == "VmData:" && status >> kibibytes) {
            return 1024.0 * kibibytes;
        }
    }
    return 0.0;
}

void keep_to(std::uint64_t bytes) {
    rlimit kept{};
    if (getrlimit(RLIMIT_DATA, &kept) != 0) {
        throw std::system_error(errno, std::generic_category(), "--memory cannot be set");
    }
    if (kept.rlim_cur == RLIM_INFINITY || kept.rlim_cur > bytes) {
        kept.rlim_cur = bytes;
        if (setrlimit(RLIMIT_DATA, &kept) != 0) {
            throw std::system_error(errno, std::generic_category(), "--memory cannot be set");
        }
    }
}
#else
constexpr double of_thread = 0.0;

double memory_in_use() {
    return 0.0;
}

void keep_to(std::uint64_t /*bytes*/) {
    throw std::invalid_argument("--memory works on Linux only");
}
#endif

std::invalid_argument refusal_of(const std::string& text) {
    return std::invalid_argument(
        fmt::format("--memory is '{}', expected a number with MB, MiB, GB, GiB, TB or TiB: 8GiB",
                    text.substr(0, 40)));
}

double bytes_of(const std::string& text) {
    double bytes = 0.0;
    try {
        bytes = parse_memory(text);
    } catch (const std::invalid_argument&) {
        throw refusal_of(text);
    }
    if (!(bytes > 0.0)) {
        throw refusal_of(text);
    }
    return bytes;
}

}  // namespace

#ifdef __wasi__
bool keeps_memory_limit() noexcept {
    return bytes_in_use() <= most_bytes;
}
#endif

void limit_memory(const std::string& text, int threads) {
    const auto bytes = static_cast<std::uint64_t>(bytes_of(text));
    const std::string shown = text.substr(0, 40);
    const double reserve = of_thread * threads;
    const double least = memory_in_use() + reserve;
    if (static_cast<double>(bytes) < least) {
        throw std::invalid_argument(
            fmt::format("--memory is {}, but the program takes {} before its work begins, on {} "
                        "thread{} (--threads)",
                        shown, at_least_text(least), threads, threads == 1 ? "" : "s"));
    }
    keep_to(bytes);
    limit = Limit{.bytes = static_cast<double>(bytes),
                  .reserve = reserve,
                  .text = shown,
                  .note = fmt::format(" (--memory is {})", shown)};
}

std::string_view memory_limit_note() noexcept {
    return limit ? std::string_view(limit->note) : std::string_view();
}

void require_memory(double bytes, std::string_view what) {
    if (!limit) {
        return;
    }
    if (const double need = bytes + memory_in_use() + limit->reserve; need > limit->bytes) {
        throw std::invalid_argument(fmt::format("--memory is {}, but the command needs {} for {}",
                                                limit->text, at_least_text(need), what));
    }
}

}  // namespace taut::app
