// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/study_csv.hpp"

#include <fmt/core.h>

#include <iterator>

#include "files/csv_field.hpp"

namespace taut {
namespace {

std::string edges_csv(const Study& study, const Eigen::MatrixXd& truth) {
    const CableNet& net = study.net;
    std::string csv =
        "edge,source,target,nominal,true_deviation,estimated_deviation,estimated_std,error,mean_"
        "error,"
        "std_error\n";
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const auto [s, t] = net.edges()[edge];
        fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{}\n",
                       csv_field(net.edge_id(edge)), csv_field(net.node_id(s)),
                       csv_field(net.node_id(t)), net.unstressed_lengths()(edge), truth(i, 0),
                       study.estimates.mean(i, 0), study.estimates.std_dev(i, 0),
                       truth(i, 0) - study.estimates.mean(i, 0), study.as_in_paper().errors.mean(i),
                       study.as_in_paper().errors.std_dev(i));
    }
    return csv;
}

std::string errors_csv(const Study& study, const Eigen::MatrixXd& truth) {
    const CableNet& net = study.net;
    std::string csv = "edge";
    for (const int sample : study.validation) {
        fmt::format_to(std::back_inserter(csv), ",sample_{}", sample);
    }
    csv += '\n';
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        csv += csv_field(net.edge_id(net.interior_edges()[i]));
        for (Eigen::Index k = 0; k < truth.cols(); ++k) {
            fmt::format_to(std::back_inserter(csv), ",{}",
                           truth(i, k) - study.estimates.mean(i, k));
        }
        csv += '\n';
    }
    return csv;
}

std::string nodes_csv(const Study& study) {
    const CableNet& net = study.net;
    std::string csv = "node,x,y,z,nominal_error,identified_error\n";
    for (int i = 0; i < net.free_node_count(); ++i) {
        const auto place = study.data.nominal_form.segment<3>(3 * i);
        fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{}\n",
                       csv_field(net.node_id(net.free_nodes()[i])), place.x(), place.y(), place.z(),
                       study.nominal_form_error(i), study.identified_form_error(i));
    }
    return csv;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> study_to_csv(const Study& study) {
    const Eigen::MatrixXd truth = study.data.length_deviations(Eigen::all, study.validation);
    return {{"edges.csv", edges_csv(study, truth)},
            {"errors.csv", errors_csv(study, truth)},
            {"nodes.csv", nodes_csv(study)}};
}

}  // namespace taut
