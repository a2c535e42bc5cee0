// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against results of version 1 of which a key is lost under its new name.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "taut/files/file.hpp"
#include "taut/results/result_file.hpp"

namespace {

using namespace taut;
using nlohmann::json;

/// All keys of a document, those in arrays under "*".
void add_keys(const json& value, const std::string& path, std::set<std::string>& keys) {
    if (value.is_array()) {
        for (const json& entry : value) {
            add_keys(entry, path + "/*", keys);
        }
    } else if (value.is_object()) {
        for (const auto& [key, member] : value.items()) {
            keys.insert(path + "/" + key);
            add_keys(member, path + "/" + key, keys);
        }
    }
}

TEST(OlderResult, IsReadUnderTheKeysOfToday) {
    const auto folder = std::filesystem::path(TAUT_TEST_DATA_DIR) / "results";
    const auto keys_of = [](const std::filesystem::path& file) {
        std::set<std::string> keys;
        add_keys(json::parse(read_result(file).json), "", keys);
        return keys;
    };
    for (const std::string name : {"study", "identification", "comparison", "plan", "control"}) {
        std::set<std::string> today = keys_of(folder / ("full_" + name + ".json"));
        for (const std::string_view since :
             {"/form_covariance", "/planned_form_covariance", "/detectable/force",
              "/detectable/load", "/diagnostics/noise_by_axis", "/diagnostics/missing_load",
              "/prior/common/struts", "/epochs/*/load", "/forces/outliers/*/source",
              "/forces/outliers/*/mode", "/forces/outliers/*/probability",
              "/forces/bias/probability", "/order/stages", "/turns/*/tension_after_step",
              "/turns/*/frequency_after_step", "/target_tensions", "/stretches",
              "/options/form_tolerance", "/suggested_adjustable/*/tension_rmse_after"}) {
            std::erase_if(today, [&](const std::string& key) { return key.starts_with(since); });
        }
        EXPECT_EQ(keys_of(folder / "version_1" / (name + ".json")), today) << name;
    }
}

}  // namespace
