// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "checks_text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "terminal.hpp"

namespace taut::app {
namespace {

/// "target 3.1 mm, length 8 mm, ..., support none", of those that the checks can find.
std::string detectable_text(const DetectableErrors& errors) {
    const auto text = [](const char* name, double error, double unit, const char* unit_name) {
        if (!std::isfinite(error)) {
            return fmt::format("{} none", name);
        }
        const double value = error / unit;
        const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
        return fmt::format("{} {:.6g} {}", name, std::round(value / digit) * digit, unit_name);
    };
    std::string forces;
    for (const auto& [name, error] :
         {std::pair(", one force", errors.force), std::pair(", all forces", errors.force_scale)}) {
        forces += std::isfinite(error) ? text(name, error, 1e-2, "%") : "";
    }
    return fmt::format("{}, {}, {}, {}, {}, {}, {}{}", text("target", errors.target, 1e-3, "mm"),
                       text("length", errors.length, 1e-3, "mm"),
                       text("turnbuckle", errors.adjustable, 1e-3, "mm"),
                       text("support", errors.support, 1e-3, "mm"),
                       text("scale", errors.scale, 1e-6, "ppm"),
                       text("temperature", errors.temperature, 1.0, "K"),
                       text("load at each node", errors.load, 1.0, "N"), forces);
}

/// The next step with the option of its remedy: "Use this standard deviation (--noise 0.71mm)."
std::string advice(const Trust::Finding& finding) {
    if (!finding.remedy) {
        return finding.advice;
    }
    const auto& [parameter, value] = *finding.remedy;
    return fmt::format("{} (--{}{}{}).", finding.advice.substr(0, finding.advice.size() - 1),
                       parameter, value.empty() ? "" : " ", value);
}

}  // namespace

void print_checks(const Trust& trust, const DetectableErrors& detectable) {
    say("Checks: {}.{}", to_string(trust.verdict()), trust.findings.empty() ? " " : "\n");
    constexpr int shown = 6;
    std::map<std::pair<Trust::Finding::Kind, Trust::Verdict>, int> counts;
    const std::vector<Trust::Finding>& all = trust.findings;
    for (size_t i = 0; i < all.size(); ++i) {
        const int count = ++counts[{all[i].kind, all[i].severity}];
        if (count > shown) {
            continue;
        }
        say("  {}: {}\n",
            all[i].severity == Trust::Verdict::passed ? "note" : to_string(all[i].severity),
            all[i].reason);
        const bool is_repeated =
            count < shown && i + 1 < all.size() && advice(all[i + 1]) == advice(all[i]);
        if (!all[i].advice.empty() && !is_repeated) {
            say("    {}\n", advice(all[i]));
        }
    }
    for (const auto& [of, count] : counts) {
        if (count > shown) {
            say("  {} more findings of kind {} are in the result\n", count - shown,
                to_string(of.first));
        }
    }
    say("Smallest error this survey would show (with a probability of 80 %):\n  {}\n\n",
        detectable_text(detectable));
}

void print_assumptions(const Identification& result) {
    if (result.assumptions.empty()) {
        say("uncertain besides lengths: nothing. Stiffness, loads, supports and turnbuckles are "
            "taken as exact\n");
        return;
    }
    std::string text;
    bool has_default = false;
    std::vector<std::string> not_shown;
    for (const Assumption& one : result.assumptions) {
        text += fmt::format("{}{}{}", text.empty() ? "" : ", ", to_string(one.parameter),
                            one.is_default ? " (assumed)" : "");
        has_default = has_default || one.is_default;
        if (!one.is_testable) {
            not_shown.push_back(to_string(one.parameter));
        }
    }
    say("uncertain besides lengths: {}\n  --uncertain NAME:WIDTH changes one, --uncertain none "
        "takes the net as exact{}\n",
        text, has_default ? "; assumed widths are uncertain by a factor of 1.5" : "");
    if (!not_shown.empty()) {
        say("  this survey cannot check {}: intervals depend on {}\n", fmt::join(not_shown, ", "),
            not_shown.size() == 1 ? "this width" : "these widths");
    }
}

}  // namespace taut::app
