// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/net_or_result.hpp"

#include <fmt/core.h>

#include "files/json_parse.hpp"
#include "files/json_value.hpp"
#include "files/message.hpp"
#include "identification/parameter_spread.hpp"
#include "statics/sliding.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/results/result_file.hpp"
#include "taut/statics/plausibility.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

NetOrResult identified_net(const IdentificationResult& result, const NetFile& designed,
                           const std::string& file_name) {
    Eigen::VectorXd lengths = designed.net.unstressed_lengths();
    std::vector<int> slack;
    std::vector<int> not_determined;
    for (const IdentifiedEdge& edge : result.edges) {
        lengths(edge.edge) += edge.length_deviation;
        if (edge.status == EdgeStatus::slack) {
            slack.push_back(edge.edge);
        } else if (edge.status == EdgeStatus::not_determined) {
            not_determined.push_back(edge.edge);
        }
    }
    for (const EdgeTurned& turned : result.turned) {
        lengths(turned.edge) += turned.stroke;
    }
    for (const BoundaryOutlier& outlier : result.boundary_outliers) {
        if (outlier.kind == BoundaryOutlier::Kind::adjustable_edge) {
            lengths(outlier.index) += outlier.deviation.x();
        }
    }
    try {
        CableNetData data = designed.net.data();
        data.unstressed_lengths = lengths;
        if (!result.uncertain.empty()) {
            data = net_under(designed.net, perturbation_of(designed.net, result.uncertain), lengths)
                       .data();
        }
        data.nodes = result.form;
        if (result.frame_offset) {
            for (ElasticSupport& support : data.elastic_supports) {
                support.place += result.frame_offset->motion_of(support.place).col(0);
            }
        }
        CableNet net(data);
        if (!net.sliding_nodes().empty()) {
            data.runs = runs_from_here(net, net.nodes(),
                                       tensions_of(net, net.unstressed_lengths(), net.nodes()));
            net = CableNet(data);
        }
        return {.file = {.net = net, .unknown_keys = designed.unknown_keys},
                .is_identified = true,
                .slack = std::move(slack),
                .not_determined = std::move(not_determined)};
    } catch (const NetError& error) {
        throw InputError(
            file_name, "",
            fmt::format("is no valid net with the identified lengths and form: {}", error.what()));
    }
}

}  // namespace

NetOrResult parse_net_or_result(std::string_view text, const std::string& file_name) {
    const nlohmann::json json = parse_json(text, file_name);
    const JsonValue root(json, file_name);
    const auto format = json.is_object() ? root.find("format") : std::nullopt;
    const std::string name = format && format->json().is_string() ? format->text() : "";
    if (name == "taut-study" || name == "taut-comparison" || name == "taut-plan" ||
        name == "taut-control") {
        format->fail(fmt::format(
            R"(is {}, expected "taut-net", or "taut-identification", the result of one built net)",
            quote(name)));
    }
    if (name != "taut-identification") {
        return {.file = parse_net(text, file_name)};
    }
    const ResultFile result = parse_result(text, file_name);
    return identified_net(std::get<IdentificationResult>(result.content),
                          parse_net(json.at("cable_net").dump(), file_name), file_name);
}

NetOrResult read_net_or_result(const std::filesystem::path& path) {
    NetOrResult read = parse_net_or_result(read_file(path), path.string());
    try {
        refuse_impossible_units(read.file.net);
    } catch (const NetError& error) {
        throw InputError(path.string(), "/" + error.field(), error.problem());
    }
    return read;
}

}  // namespace taut
