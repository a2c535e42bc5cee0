// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The peer of benchmarks/python_calls.py: the same points identified by the same call in C++.
// identify_points NET POINTS NOISE, with a line "id x y z" for each point; for each line that it
// reads from its standard input it identifies once, and prints the seconds that it took and the sum
// of the length deviations.
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "taut/identification/identify.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/read_survey.hpp"

namespace {

std::vector<taut::SurveyPoint> read_points(const char* path) {
    std::ifstream file(path);
    std::vector<taut::SurveyPoint> points;
    std::string id;
    std::string x;
    std::string y;
    std::string z;
    while (file >> id >> x >> y >> z) {
        points.push_back({.id = id, .position = {std::stod(x), std::stod(y), std::stod(z)}});
    }
    return points;
}

void answer_lines(const taut::CableNet& net, const std::vector<taut::SurveyPoint>& points,
                  double noise_std) {
    std::cout.precision(17);
    for (std::string line; std::getline(std::cin, line);) {
        const auto start = std::chrono::steady_clock::now();
        const taut::Survey survey = taut::read_survey(net, points, {.noise_std = noise_std});
        const taut::Identification found = taut::identify(net, survey);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        double sum = 0.0;
        for (const taut::IdentifiedEdge& edge : found.edges) {
            sum += edge.length_deviation;
        }
        std::cout << took.count() << ' ' << sum << std::endl;
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "identify_points NET POINTS NOISE\n";
        return 2;
    }
    try {
        answer_lines(taut::read_net(argv[1]).net, read_points(argv[2]), std::stod(argv[3]));
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
