// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "mumps.hpp"

#include <dmumps_c.h>

#include <stdexcept>
#include <string>

namespace {

// Jobs of MUMPS.
constexpr int initialise = -1;
constexpr int finish = -2;
constexpr int analyse = 1;
constexpr int factorise = 2;
constexpr int solve_for = 3;

constexpr int general_symmetric = 2;
constexpr int world_communicator = -987654;

}  // namespace

struct Mumps::Instance {
    DMUMPS_STRUC_C mumps{};
    std::vector<int> rows;
    std::vector<int> columns;
    std::vector<double> values;

    /// ICNTL as the manual numbers it.
    [[nodiscard]] int& option(int number) { return mumps.icntl[number - 1]; }
};

Mumps::Mumps(const Eigen::SparseMatrix<double>& lower) : m_instance(std::make_unique<Instance>()) {
    DMUMPS_STRUC_C& mumps = m_instance->mumps;
    mumps.sym = general_symmetric;
    mumps.par = 1;
    mumps.comm_fortran = world_communicator;
    call(initialise);
    for (const int output : {1, 2, 3}) {
        m_instance->option(output) = -1;
    }
    m_instance->option(4) = 0;
    for (Eigen::Index j = 0; j < lower.outerSize(); ++j) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, j); entry; ++entry) {
            if (entry.row() >= j) {
                m_instance->rows.push_back(static_cast<int>(entry.row()) + 1);
                m_instance->columns.push_back(static_cast<int>(j) + 1);
                m_instance->values.push_back(entry.value());
            }
        }
    }
    mumps.n = static_cast<int>(lower.rows());
    mumps.nnz = static_cast<MUMPS_INT8>(m_instance->values.size());
    mumps.irn = m_instance->rows.data();
    mumps.jcn = m_instance->columns.data();
    mumps.a = m_instance->values.data();
    call(analyse);
}

Mumps::~Mumps() {
    m_instance->mumps.job = finish;
    dmumps_c(&m_instance->mumps);
}

void Mumps::call(int job) {
    DMUMPS_STRUC_C& mumps = m_instance->mumps;
    mumps.job = job;
    dmumps_c(&mumps);
    if (mumps.infog[0] < 0) {
        throw std::runtime_error("MUMPS: error " + std::to_string(mumps.infog[0]));
    }
}

void Mumps::factorize() {
    call(factorise);
}

Eigen::VectorXd Mumps::solve(const Eigen::VectorXd& b) {
    Eigen::VectorXd x = b;
    DMUMPS_STRUC_C& mumps = m_instance->mumps;
    mumps.nrhs = 1;
    mumps.lrhs = mumps.n;
    mumps.rhs = x.data();
    call(solve_for);
    return x;
}

std::vector<double> Mumps::inverse_entries(const std::vector<std::vector<int>>& rows) {
    std::vector<int> starts{1};
    std::vector<int> places;
    for (const std::vector<int>& column : rows) {
        for (const int row : column) {
            places.push_back(row + 1);
        }
        starts.push_back(static_cast<int>(places.size()) + 1);
    }
    std::vector<double> entries(places.size());
    DMUMPS_STRUC_C& mumps = m_instance->mumps;
    m_instance->option(30) = 1;
    mumps.nrhs = mumps.n;
    mumps.nz_rhs = static_cast<int>(places.size());
    mumps.irhs_ptr = starts.data();
    mumps.irhs_sparse = places.data();
    mumps.rhs_sparse = entries.data();
    call(solve_for);
    m_instance->option(30) = 0;
    return entries;
}
