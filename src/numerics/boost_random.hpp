// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/seed_seq.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace taut {

/// Random numbers of simulated surveys, the same for a seed on every platform: Boost fixes the
/// output of its distributions, which the standard does not. The sequences are those of surveys
/// simulated so far. New code uses RandomNumbers.
class BoostRandom {
public:
    explicit BoostRandom(std::uint64_t seed) : m_engine(seed) {}
    BoostRandom(std::uint64_t seed, int stream) {
        boost::random::seed_seq words{static_cast<std::uint32_t>(seed),
                                      static_cast<std::uint32_t>(seed >> 32U),
                                      static_cast<std::uint32_t>(stream)};
        m_engine.seed(words);
    }

    /// 64 random bits.
    std::uint64_t number() { return m_engine(); }
    bool toss() { return uniform(0.0, 1.0) < 0.5; }
    double uniform(double low, double high) { return low + (high - low) * m_uniform(m_engine); }
    /// Standard normal.
    double normal() { return m_normal(m_engine); }
    Eigen::Vector3d normals() {
        const double x = normal();
        const double y = normal();
        return {x, y, normal()};
    }
    /// Uniform in a full circle [rad].
    double angle() {
        const double x = normal();
        return std::atan2(normal(), x);
    }
    template <class T>
    void shuffle(std::vector<T>& values) {
        for (std::size_t i = values.size(); i > 1; --i) {
            const boost::random::uniform_int_distribution<std::size_t> below(0, i - 1);
            std::swap(values[i - 1], values[below(m_engine)]);
        }
    }

private:
    boost::random::mt19937_64 m_engine;
    boost::random::uniform_01<double> m_uniform;
    boost::random::normal_distribution<double> m_normal;
};

}  // namespace taut
