// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "output_directory.hpp"

#include <stdexcept>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/report/report_html.hpp"
#include "taut/results/result_file.hpp"

namespace taut::app {

void check_output_directory(const std::filesystem::path& directory,
                            const std::vector<std::string>& names,
                            const std::vector<std::string>& inputs) {
    if (directory.empty()) {
        throw std::invalid_argument("the output directory has no name");
    }
    refuse_outputs({directory.string()}, {});
    for (const std::string& name : names) {
        refuse_outputs({(directory / name).string()}, inputs);
    }
    std::filesystem::path first_new = std::filesystem::absolute(directory) / names.front();
    while (!std::filesystem::exists(first_new.parent_path())) {
        first_new = first_new.parent_path();
    }
    AtomicFile{first_new};
    for (const std::string& name : names) {
        note_left_files(directory / name);
    }
}

void write_with_report(const std::filesystem::path& directory, const std::string& name,
                       const std::string& json,
                       std::vector<std::pair<std::string, std::string>> further) {
    further.insert(further.begin(), {name, json});
    if (has_report_viewer()) {
        further.emplace_back("report.html", report_html(parse_result(json, name)));
    }
    write_files(directory, further);
}

std::string report_text(const std::filesystem::path& directory) {
    return has_report_viewer() ? (directory / "report.html").string()
                               : "left out, this taut was built without Node.js";
}

}  // namespace taut::app
