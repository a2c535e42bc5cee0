// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "taut/error.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// Something asked of a plan that is no such thing, or not for this net. Names the field, so that a
/// program can show it as its option: "the total stroke is 0mm, expected more than 0".
class TAUT_ADJUSTMENT_EXPORT RequestError : public std::invalid_argument, public Error {
public:
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::request;
    }  ///< Error
    /// @param field of PlanRequest, "total_stroke", or "target_unit" of read_target()
    /// @param problem what is wrong with it, "is 0mm, expected more than 0"
    RequestError(const std::string& field, const std::string& problem);

    [[nodiscard]] const std::string& field() const { return m_field; }      ///< as given
    [[nodiscard]] const std::string& problem() const { return m_problem; }  ///< as given

private:
    std::string m_field;
    std::string m_problem;
};

}  // namespace taut
