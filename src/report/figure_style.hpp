// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace taut::report {

/// The style sheet of all drawings, on a light ground. It sets no more than what converters of SVG
/// understand.
[[nodiscard]] std::string figure_style();

/// What differs on a dark ground; stands after figure_style().
[[nodiscard]] std::string dark_figure_style();

/// The classes of drawings, told apart by lightness and shape as well as by hue:
///   frame, grid             axes and their marks
///   interior, adjustable    edges
///   free, support           nodes, as dots and squares
///   true, predicted, error  length deviations, as dots
///   link                    between what belongs together
///   all-errors, mean, std   statistics of the errors
///   slack, unobserved       edges whose length the survey does not tell, as dots
///   bar                     of a histogram
///   series0 ... series5     curves of methods; best: the best possible
///   faint                   a net behind something else
///   outline                 what separates a coloured dot from the ground
///   level                   a dot that brings its colour with it: no rule here
///   arm                     arms of the coordinate cross

}  // namespace taut::report
