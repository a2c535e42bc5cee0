// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/import_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "interchange/import_numbers.hpp"
#include "net/sliding_nodes.hpp"
#include "taut/files/input_error.hpp"
#include "taut/net/cable_runs.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using Slides = ImportSettings::Slides;

/// A name without the number at its end: "ridge" of "ridge_12"; empty where it has no such number.
std::string stem_of(const std::string& id) {
    const size_t digits = id.find_last_not_of("0123456789");
    if (digits == std::string::npos || digits + 1 == id.size()) {
        return {};
    }
    const size_t end = id.find_last_not_of(" _-.:/#", digits);
    return end == std::string::npos ? std::string() : id.substr(0, end + 1);
}

/// Edges that hang together, from one end to the other, as paths: a node with more than two of them
/// ends a path.
std::vector<std::vector<int>> paths_of(const CableNet& net, const std::vector<int>& edges) {
    std::map<int, std::vector<int>> at;
    for (const int edge : edges) {
        for (const int node : net.edges()[edge]) {
            at[node].push_back(edge);
        }
    }
    std::map<int, bool> is_taken;
    std::vector<std::vector<int>> paths;
    const auto follow = [&](int node, int edge) {
        std::vector<int> path;
        while (!is_taken[edge]) {
            is_taken[edge] = true;
            path.push_back(edge);
            const auto [s, t] = net.edges()[edge];
            node = s == node ? t : s;
            const std::vector<int>& here = at[node];
            if (here.size() == 2) {
                edge = here[0] == edge ? here[1] : here[0];
            }
        }
        if (path.size() > 1) {
            paths.push_back(std::move(path));
        }
    };
    for (const auto& [node, here] : at) {
        for (const int edge : here) {
            if (here.size() != 2 && !is_taken[edge]) {
                follow(node, edge);
            }
        }
    }
    // Rings: from a support where they have one.
    for (const bool at_support : {true, false}) {
        for (const int edge : edges) {
            for (const int node : net.edges()[edge]) {
                if (!is_taken[edge] && (!at_support || net.free_index(node) < 0)) {
                    follow(node, edge);
                }
            }
        }
    }
    return paths;
}

std::map<std::string, std::vector<int>> groups_of(const CableNet& net, Slides by) {
    std::map<std::string, std::vector<int>> groups;
    if (by == Slides::names) {
        for (int e = 0; e < net.edge_count(); ++e) {
            const std::string& s = net.node_id(net.edges()[e][0]);
            const std::string& t = net.node_id(net.edges()[e][1]);
            const std::string& id = net.edge_id(e);
            const bool is_named =
                id != fmt::format("{}-{}", s, t) && id != fmt::format("{}-{}", t, s);
            if (const std::string stem = stem_of(id);
                is_named && !stem.empty() && !net.is_strut(e)) {
                groups[stem].push_back(e);
            }
        }
        return groups;
    }
    const std::vector<std::vector<int>> runs = cable_runs(net);
    for (size_t k = 0; k < runs.size(); ++k) {
        groups[fmt::format("run {}", k + 1)] = runs[k];
    }
    return groups;
}

/// Largest ratio of tensions on both sides of a node where a run slides, in the given form.
double largest_ratio(const CableNet& net) {
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), net.nodes());
    double largest = 1.0;
    for (const SlidingNode& at : net.sliding_nodes()) {
        const auto [less, more] = std::minmax(tension(at.before), tension(at.after));
        largest = std::max(largest, more / std::max(less, 1e-9 * more));
    }
    return largest;
}

}  // namespace

ImportSettings::Slides parse_slides(std::string_view text) {
    for (const auto& [by, name] : {std::pair(Slides::none, "none"),
                                   {Slides::names, "names"},
                                   {Slides::straight, "straight"}}) {
        if (text == name) {
            return by;
        }
    }
    throw std::invalid_argument(
        fmt::format("slides: got '{}', expected 'names', 'straight' or 'none'", text));
}

std::vector<CableRun> sliding_runs(const CableNet& net, Slides by) {
    std::vector<CableRun> runs;
    for (const auto& [name, edges] : groups_of(net, by)) {
        const std::vector<std::vector<int>> paths = paths_of(net, edges);
        for (size_t k = 0; k < paths.size(); ++k) {
            CableRun run{.name = paths.size() > 1 ? fmt::format("{} ({})", name, k + 1) : name,
                         .edges = paths[k],
                         .slides_at = net.free_nodes()};
            const std::vector<SlidingNode> passed = sliding_nodes_of(net.edges(), run);
            run.slides_at.clear();
            for (const SlidingNode& at : passed) {
                if (std::ranges::find(run.slides_at, at.node) == run.slides_at.end()) {
                    run.slides_at.push_back(at.node);
                }
            }
            if (!run.slides_at.empty()) {
                runs.push_back(std::move(run));
            }
        }
    }
    return runs;
}

/// Edges of a ring begin where it does not slide.
template <class Slides>
void cut_ring(const CableNet& net, const Slides& slides, std::vector<int>& edges) {
    const auto shared = [&net](int edge, int other) {
        const auto [s, t] = net.edges()[edge];
        const auto [u, v] = net.edges()[other];
        return s == u || s == v ? s : t == u || t == v ? t : -1;
    };
    if (edges.size() < 3 || shared(edges.front(), edges.back()) < 0) {
        return;
    }
    for (size_t k = 0; k < edges.size(); ++k) {
        const int before = edges[(k + edges.size() - 1) % edges.size()];
        if (!slides(shared(before, edges[k]))) {
            std::ranges::rotate(edges, edges.begin() + static_cast<std::ptrdiff_t>(k));
            return;
        }
    }
}

/// Refuses a run that is named at a node where it does not slide: a slip of the pen, most likely.
void check_slides(const ImportedStructure& structure, const std::vector<CableRun>& runs) {
    for (size_t i = 0; i < structure.nodes.size(); ++i) {
        for (const std::string& name : structure.nodes[i].slides) {
            const auto run = std::ranges::find(runs, name, &CableRun::name);
            if (run == runs.end() ||
                std::ranges::find(run->slides_at, static_cast<int>(i)) == run->slides_at.end()) {
                throw InputError(structure.file, structure.nodes[i].place,
                                 fmt::format("node {} says that the run '{}' slides there, but no "
                                             "two edges of such a run follow each other at it",
                                             structure.nodes[i].id, name));
            }
        }
    }
}

/// The runs that the edges name, sliding where the nodes say so.
std::vector<CableRun> runs_of(const CableNet& net, const ImportedStructure& structure) {
    std::map<std::string, std::vector<int>> edges_of;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (const std::string& run = structure.edges[e].run; !run.empty()) {
            edges_of[run].push_back(e);
        } else if (structure.edges[e].numbers.contains("friction")) {
            fail_at(structure, structure.edges[e], "has a friction, but no run");
        }
    }
    std::vector<CableRun> runs;
    for (const auto& [name, edges] : edges_of) {
        const std::vector<std::vector<int>> paths = paths_of(net, edges);
        if (edges.size() > 1 && (paths.size() != 1 || paths[0].size() != edges.size())) {
            fail_at(structure, structure.edges[edges[0]],
                    fmt::format("is part of the run '{}', whose edges do not follow each other "
                                "along one cable",
                                name));
        }
        std::vector<int> everywhere(static_cast<size_t>(net.node_count()));  // on saddles, too
        std::iota(everywhere.begin(), everywhere.end(), 0);
        CableRun run{.name = name,
                     .edges = edges.size() > 1 ? paths[0] : edges,
                     .slides_at = std::move(everywhere)};
        const auto slides = [&structure, &run](int node) {
            const ImportedNode& at = structure.nodes[node];
            return at.all_slide || std::ranges::find(at.slides, run.name) != at.slides.end();
        };
        cut_ring(net, slides, run.edges);
        const std::vector<SlidingNode> passed = sliding_nodes_of(net.edges(), run);
        run.slides_at.clear();
        for (const SlidingNode& at : passed) {
            if (slides(at.node)) {
                run.slides_at.push_back(at.node);
            }
        }
        for (const int edge : edges) {
            const auto& numbers = structure.edges[edge].numbers;
            const auto found = numbers.find("friction");
            if (found == numbers.end()) {
                continue;
            }
            if (run.friction && *run.friction != found->second) {
                fail_at(structure, structure.edges[edge],
                        fmt::format("has the friction {}, but an edge of the same run has {}",
                                    found->second, *run.friction));
            }
            run.friction = found->second;
        }
        runs.push_back(std::move(run));
    }
    check_slides(structure, runs);
    return runs;
}

/// The net with runs. A broken rule is reported in the name of the run.
CableNet with_runs(const CableNet& net, std::vector<CableRun> runs, const std::string& file) {
    CableNetData data = net.data();
    data.runs = std::move(runs);
    try {
        return CableNet(data);
    } catch (const NetError& error) {
        const bool is_known = error.field() == "runs" && !error.index().empty();
        throw InputError(
            file, "",
            is_known
                ? fmt::format("run '{}' {}", data.runs[error.index().front()].name, error.problem())
                : error.what());
    }
}

CableNet with_sliding_runs(const CableNet& net, Slides by, const ImportedStructure& structure,
                           ImportReport& report) {
    const std::string& file = structure.file;
    const bool gives_runs =
        std::ranges::any_of(structure.edges,
                            [](const ImportedEdge& edge) {
                                return !edge.run.empty() || edge.numbers.contains("friction");
                            }) ||
        std::ranges::any_of(structure.nodes,
                            [](const ImportedNode& node) { return !node.slides.empty(); });
    if (gives_runs && by == Slides::none) {
        CableNet result = with_runs(net, runs_of(net, structure), file);
        report.read.push_back(fmt::format("{} runs of cable, which slide {} times through a node",
                                          result.data().runs.size(),
                                          result.sliding_nodes().size()));
        return result;
    }
    if (gives_runs) {
        report.left_out.emplace_back(
            "the runs of the file, in place of which others are asked for");
    }
    if (by == Slides::none) {
        const size_t named = sliding_runs(net, Slides::names).size();
        const size_t straight = sliding_runs(net, Slides::straight).size();
        report.assumed.push_back(
            named + straight == 0
                ? "cables are clamped at all nodes"
                : fmt::format(
                      "cables are clamped at all nodes, though {} go on by their names, and {} "
                      "straight on: --slides names or straight where they slide",
                      named, straight));
        return net;
    }
    std::vector<CableRun> runs = sliding_runs(net, by);
    if (runs.empty()) {
        throw InputError(file, "",
                         by == Slides::names
                             ? "names no cable that slides, expected two edges or more of one name "
                               "but for the number at its end, one after the other"
                             : "has no cable that goes straight on through a free node");
    }
    size_t edges = 0;
    for (const CableRun& run : runs) {
        edges += run.edges.size();
    }
    report.assumed.push_back(fmt::format(
        "{} cables of {} edges slide through their nodes, with a friction that is not known",
        runs.size(), edges));
    CableNet result = with_runs(net, std::move(runs), file);
    constexpr double alike = 1.02;
    if (const double ratio = largest_ratio(result); ratio > alike) {
        report.warnings.push_back(
            fmt::format("in the given form tensions on both sides of a node where a cable slides "
                        "differ by up to {:.2g} times: 'taut form' lets it slide to another form",
                        ratio));
    }
    return result;
}

}  // namespace taut
