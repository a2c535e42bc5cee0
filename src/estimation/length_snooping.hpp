// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "taut/estimation/length_posterior.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// Data snooping of the lengths: the law of an edge's length is tested as targets are, against what
/// survey and statics tell of the length without it, docs/theory.md (length-snooping). An edge
/// beyond its law is released: a law too wide to tell anything takes the place of its own.
class LengthSnooping {
public:
    /// Keeps a reference to the net.
    /// @param laws of the interior edges (m_I)
    /// @param threshold of a statistic, chi-squared of one degree of freedom; infinite: no test
    LengthSnooping(const CableNet& net, std::vector<LengthLaw> laws, double threshold);

    /// The statistics at a fit.
    /// @param told of each interior edge without its law (m_I)
    void evaluate(const std::vector<LengthLikelihood>& told);

    /// The largest (rivals) score of the edges in use at each node (n), to be held
    /// against those of other tests.
    [[nodiscard]] Eigen::VectorXd scores() const;

    /// Releases edges beyond their law that stand out more than all else within two edges.
    /// @param rivals scores of other tests by node (n)
    /// @return whether there were any
    [[nodiscard]] bool release(const Eigen::VectorXd& rivals);
    /// Gives those back their law, for good, that agree with it after all.
    [[nodiscard]] bool readmit();
    void readmit_all() { set_released(std::vector<bool>(m_laws.size(), false)); }
    /// All have their law from now on: where more are beyond it than can be mis-cut it is the law
    /// that is wrong.
    void give_up() {
        m_given_up = released_count();
        readmit_all();
    }
    [[nodiscard]] bool is_active() const { return m_given_up == 0 && std::isfinite(m_threshold); }
    /// Edges beyond the law, where they are more than can be mis-cut; else 0.
    [[nodiscard]] int given_up() const { return m_given_up; }
    /// Lets edges that were readmitted be released again.
    void reopen() { m_readmitted.assign(m_laws.size(), false); }

    [[nodiscard]] const std::vector<bool>& released() const { return m_released; }  ///< m_I
    void set_released(std::vector<bool> released) { m_released = std::move(released); }
    [[nodiscard]] int released_count() const;
    /// Whether more are beyond the law than can be mis-cut: the law is wrong then.
    [[nodiscard]] bool releases_too_many() const;
    /// The laws to fit with: those of released edges are normal and wide (m_I).
    [[nodiscard]] std::vector<LengthLaw> laws() const;
    /// Sum of the thresholds of all that is released.
    [[nodiscard]] double released_cost() const;
    /// DetectableErrors::length, of the edges in use at the fit.
    [[nodiscard]] double detectable(const std::vector<int>& edges) const;
    [[nodiscard]] std::vector<LengthOutlier> outliers() const;  ///< the largest statistic first

private:
    [[nodiscard]] bool is_beyond(size_t i) const;
    [[nodiscard]] bool may_release(size_t i) const;

    const CableNet& m_net;
    std::vector<LengthLaw> m_laws;
    double m_threshold;
    double m_released_std;  ///< of the law of a released edge [m]
    int m_given_up = 0;
    std::vector<bool> m_released;
    std::vector<bool> m_readmitted;  ///< for good
    std::vector<LengthLikelihood> m_told;
    Eigen::VectorXd m_statistics;       ///< of a normal law as wide (m_I)
    Eigen::VectorXd m_core_statistics;  ///< beyond what the law holds for possible (m_I)
};

}  // namespace taut
