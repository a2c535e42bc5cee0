// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "documents.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/form_vtk.hpp"
#include "taut/interchange/net_import.hpp"
#include "taut/interchange/obj.hpp"
#include "taut/report/report_html.hpp"
#include "taut/results/result_file.hpp"
#include "taut/results/result_xlsx.hpp"
#include "words.hpp"

namespace taut::python {
namespace {

/// Reads a COMPAS structure as JSON.
nb::tuple net_of_compas(const std::string& text, const std::string& name, const std::string& select,
                        const std::optional<double>& axial_stiffness,
                        const std::optional<double>& young, const std::optional<double>& diameter,
                        const std::string& diameter_attribute,
                        const std::optional<double>& force_unit, const std::string& loads,
                        const std::optional<std::vector<std::string>>& supports, bool boundary,
                        const std::string& slides) {
    ImportedStructure structure = parse_compas(text, name, select);
    if (boundary) {
        support_boundary(structure);
    }
    if (supports) {
        std::string list;
        for (const std::string& id : *supports) {
            list += id + "\n";
        }
        support_named(structure, list, "supports");
    }
    using Loads = ImportSettings::Loads;
    ImportedNet imported = import_net(structure, {.axial_stiffness = axial_stiffness,
                                                  .young = young,
                                                  .diameter = diameter,
                                                  .diameter_attribute = diameter_attribute,
                                                  .force_unit = force_unit,
                                                  .loads = loads == "balance" ? Loads::balance
                                                           : loads == "none"  ? Loads::none
                                                                              : Loads::file,
                                                  .slides = parse_slides(slides)});
    const ImportReport& report = imported.report;
    nb::dict notes;
    notes["read"] = report.read;
    notes["left_out"] = report.left_out;
    notes["assumed"] = in_python(report.assumed);
    notes["warnings"] = in_python(report.warnings);
    notes["out_of_balance"] = report.largest_out_of_balance;
    notes["mean_tension"] = report.mean_tension;
    return nb::make_tuple(std::move(imported.net), notes);
}

Points form_or_nodes(const CableNet& net, const std::optional<ArrayLike>& form) {
    return form ? points_argument(*form, "form", net.node_count()) : net.nodes();
}

}  // namespace

void bind_interchange(nb::module_& module) {
    module.def("_net_of_compas", &net_of_compas, nb::arg("text"), nb::arg("name"),
               nb::arg("select"), nb::arg("axial_stiffness").none(), nb::arg("young").none(),
               nb::arg("diameter").none(), nb::arg("diameter_attribute"),
               nb::arg("force_unit").none(), nb::arg("loads"), nb::arg("supports").none(),
               nb::arg("boundary"), nb::arg("slides"));
    module.def(
        "_compas_of_form",
        [](const CableNet& net, const std::optional<ArrayLike>& form) {
            return form_to_compas(net, form_or_nodes(net, form));
        },
        nb::arg("net"), nb::arg("form").none());
    module.def(
        "form_to_obj",
        [](const CableNet& net, const std::optional<ArrayLike>& form) {
            return form_to_obj(net, form_or_nodes(net, form));
        },
        nb::arg("net"), nb::arg("form") = nb::none(),
        "A form (n, 3) as OBJ, by default the nominal one.");
    module.def(
        "_report_html",
        [](const std::string& result) { return report_html(parse_result(result, "result")); },
        nb::arg("result"));
    module.def(
        "write_report",
        [](const std::filesystem::path& result, const std::filesystem::path& output) {
            write_file(output, report_html(read_result(result)));
        },
        nb::arg("result"), nb::arg("output"),
        "A saved result as one HTML page that needs nothing else, as taut report.");
    module.def(
        "_copy_page",
        [](const std::filesystem::path& page, const std::filesystem::path& output) {
            if (is_same_file(page, output)) {
                throw OutputError(output, "is the package's own page, expected another file");
            }
            write_file(output, read_file(page));
        },
        nb::arg("page"), nb::arg("output"));
    module.def(
        "write_xlsx",
        [](const std::filesystem::path& result, const std::filesystem::path& output) {
            ResultXlsx tables = result_to_xlsx(read_result(result), result.string());
            write_file(output, tables.bytes);
            return std::move(tables.remarks);
        },
        nb::arg("result"), nb::arg("output"),
        "The tables of a saved result as an Excel file, as taut export --to xlsx: of a plan the "
        "list for the crews, of an identification edges and nodes. Gives the warnings that stand "
        "above them.");
    module.def("has_report_viewer", &has_report_viewer,
               "Whether reports can be made: this build holds their viewer.");
}

}  // namespace taut::python
