// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "dicts.hpp"
#include "given.hpp"
#include "states.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/io/target_offsets_csv.hpp"
#include "taut/survey/simulation.hpp"
#include "taut/survey/survey.hpp"
#include "words.hpp"

namespace taut::python {
namespace {

SurveyFrame frame_named(const std::string& name) {
    if (name == "auto") {
        return SurveyFrame::automatic;
    }
    if (name == "net" || name == "supports") {
        return name == "net" ? SurveyFrame::net : SurveyFrame::supports;
    }
    throw nb::value_error(
        fmt::format("frame: got '{}', expected 'auto', 'net' or 'supports'", name).c_str());
}

PointMatching matching_named(const std::string& name) {
    if (name == "auto") {
        return PointMatching::automatic;
    }
    if (name == "name" || name == "place") {
        return name == "name" ? PointMatching::name : PointMatching::place;
    }
    throw nb::value_error(
        fmt::format("match: got '{}', expected 'auto', 'name' or 'place'", name).c_str());
}

double unit_named(const std::string& name) {
    const std::optional<double> unit = length_of_unit(name);
    if (!unit) {
        throw nb::value_error(
            fmt::format("unit: got '{}', expected 'mm', 'cm', 'm', 'in', 'ft' or 'us-ft'", name)
                .c_str());
    }
    return *unit;
}

/// Keyword arguments of read_survey() that were given, by their names.
using Given = std::map<std::string, std::string>;

ReadSurveyOptions options_of(std::optional<double> noise, const Given& given) {
    ReadSurveyOptions options{.noise_std = noise};
    const auto take = [&given](const char* name, const auto& use) {
        if (const auto found = given.find(name); found != given.end()) {
            use(found->second);
        }
    };
    take("frame", [&](const std::string& text) { options.frame = frame_named(text); });
    take("control_points", [&](const std::string& text) { options.control = text; });
    take("unit", [&](const std::string& text) { options.unit = unit_named(text); });
    take("match", [&](const std::string& text) { options.matching = matching_named(text); });
    take("file_format",
         [&](const std::string& t) { options.file.format = parse_survey_format(t); });
    take("columns", [&](const std::string& t) { options.file.columns = parse_survey_columns(t); });
    take("separator", [&](const std::string& t) { options.file.separator = parse_separator(t); });
    take("decimal", [&](const std::string& t) { options.file.decimal = parse_decimal_sign(t); });
    take("encoding", [&](const std::string& t) { options.file.encoding = parse_text_encoding(t); });
    take("angle", [&](const std::string& text) {
        const AngleText angle = parse_angle(text);
        if (!(angle.angle > 0.0)) {
            throw nb::value_error(
                fmt::format("angle: got '{}', expected a standard deviation above 0", text)
                    .c_str());
        }
        options.angle_std = angle.angle;
        options.file.angle_unit = angle.full_unit;
        options.file.takes_observations = true;
    });
    take("distance", [&](const std::string& text) {
        options.distance = parse_distance_precision(text);
        options.file.takes_observations = true;
    });
    take("offsets", [&](const std::string& file) {
        options.offsets.of = parse_target_offsets(read_table(file), file);
    });
    take("offset",
         [&](const std::string& text) { options.offsets.all = parse_target_offset(text); });
    return options;
}

/// Points out of arrays.
std::vector<SurveyPoint> points_of(const ArrayLike& positions,
                                   const std::optional<std::vector<std::string>>& ids,
                                   const std::optional<ArrayLike>& noise) {
    const Points places = points_argument(positions, "source", -1);
    const Eigen::Index count = places.cols();
    if (ids && std::cmp_not_equal(ids->size(), count)) {
        throw nb::value_error(
            fmt::format("ids: got {} names, expected {}", ids->size(), count).c_str());
    }
    std::optional<Points> stds;
    if (noise) {
        stds = points_argument(*noise, "noise", count);
    }
    std::vector<SurveyPoint> points(static_cast<size_t>(count));
    for (Eigen::Index i = 0; i < count; ++i) {
        SurveyPoint& point = points[static_cast<size_t>(i)];
        point.position = places.col(i);
        point.line = static_cast<int>(i) + 1;
        if (ids) {
            point.id = (*ids)[static_cast<size_t>(i)];
        }
        if (stds) {
            point.noise_std = stds->col(i);
            if (!(stds->col(i).allFinite() && stds->col(i).minCoeff() >= 0.0)) {
                throw nb::value_error(
                    fmt::format("standard deviations: got ({}, {}, {}) for point {}, expected "
                                "finite ones of 0 or more",
                                (*stds)(0, i), (*stds)(1, i), (*stds)(2, i), i + 1)
                        .c_str());
            }
        }
    }
    return points;
}

/// Points as columns, of which read_survey() and pandas take a mapping.
nb::dict columns_of(const std::vector<SurveyPoint>& points) {
    const auto count = static_cast<Eigen::Index>(points.size());
    nb::list ids;
    Eigen::MatrixXd values(count, 6);
    bool has_noise = false;
    for (Eigen::Index i = 0; i < count; ++i) {
        const SurveyPoint& point = points[static_cast<size_t>(i)];
        ids.append(point.id);
        has_noise = has_noise || point.noise_std.has_value();
        values.row(i) << point.position.transpose(),
            point.noise_std.value_or(Eigen::Vector3d::Zero()).transpose();
    }
    nb::dict columns;
    columns["id"] = ids;
    const char* const names[] = {"x", "y", "z", "sx", "sy", "sz"};
    for (int k = 0; k < (has_noise ? 6 : 3); ++k) {
        columns[names[k]] = array_of(Eigen::VectorXd(values.col(k)));
    }
    return columns;
}

void bind_survey_class(nb::module_& module) {
    nb::class_<Survey> survey(module, "Survey",
                              "A survey brought to the nodes of a net: read_survey().");
    make_picklable(survey);
    bind_fields<Survey>(
        survey, std::identity(),
        {{"noise_correlations",
          "Correlations of the noise of a node, of x and y, x and z, y and z (n, 3), or (0, 3): "
          "none."},
         {"supports",
          "Supports that were surveyed, ascending. Of each: node, position and noise_std (3,) [m], "
          "noise_correlations."},
         {"frame_is_unknown", "Whether the coordinates alone show their frame."},
         {"frame",
          "How the survey was moved to the net: motion (rotation about from, which comes to lie at "
          "to), and residuals of the control points; None where it was in the net's frame."},
         {"placed",
          "On which node each point is: name, line of the file, node, distance [m] to its design, "
          "code."},
         {"unmatched",
          "Points on no node: point, nearest node, its distance [m], reason, swapped_with (-1: "
          "none)."},
         {"contradicted_names",
          "Number of points that lie on other nodes than they name, and were put there; 0: names "
          "hold."},
         {"has_own_noise", "Whether a point brought a noise of its own."},
         {"scale_std", "Standard deviation of the scale that all targets have in common [-]."},
         {"rounding_std", "That of the file's last digit, which noise_std holds [m]."}});
    survey
        .def_prop_ro(
            "form",
            [](nb::handle_t<Survey> self) {
                return view_of(nb::cast<const Survey&>(self).form, self);
            },
            "Surveyed positions, nominal where a node was not surveyed (n, 3) [m].")
        .def_prop_ro(
            "noise_std",
            [](nb::handle_t<Survey> self) {
                return view_of(nb::cast<const Survey&>(self).noise_std, self);
            },
            "Standard deviation of each coordinate (n, 3), or (0, 3): all exact [m].")
        .def_prop_ro(
            "surveyed",
            [](nb::handle_t<Survey> self) {
                return view_of(nb::cast<const Survey&>(self).surveyed, self);
            },
            "Free nodes that were surveyed, ascending.")
        .def_prop_ro(
            "missing",
            [](nb::handle_t<Survey> self) {
                return view_of(nb::cast<const Survey&>(self).missing, self);
            },
            "Free nodes that were not, ascending.")
        .def_prop_ro(
            "warnings", [](const Survey& self) { return in_python(self.warnings); },
            "What is most likely wrong, a line each.")
        .def_prop_ro(
            "notes", [](const Survey& self) { return in_python(self.notes); },
            "How the source was understood, a line each.")
        .def_prop_ro("is_exact", &Survey::is_exact, "Whether all surveyed coordinates are exact.")
        .def(
            "to_dataframe",
            [](nb::handle_t<Survey> self, const CableNet& net) {
                return of_package("taut.tables", "survey_frame")(self, net);
            },
            nb::arg("net"), nb::sig("def to_dataframe(self, net: CableNet) -> object"),
            "The surveyed nodes as a pandas.DataFrame, SI units.")
        .def("to_dict", &dict_of_fields<Survey>, nb::sig("def to_dict(self) -> dict"),
             "All of it, SI units.")
        .def("__repr__", [](const Survey& self) {
            return fmt::format(
                "Survey({} free nodes, {} not surveyed, noise {:.4g} mm{})", self.surveyed.size(),
                self.missing.size(), 1e3 * self.rms_noise_std(),
                self.warnings.empty() ? "" : fmt::format(", {} warnings", self.warnings.size()));
        });
}

}  // namespace

void bind_survey(nb::module_& module) {
    bind_survey_class(module);
    module.def(
        "_read_survey_file",
        [](const CableNet& net, const std::filesystem::path& path, std::optional<double> noise,
           const Given& given) { return read_survey(net, path, options_of(noise, given)); },
        nb::arg("net"), nb::arg("path"), nb::arg("noise").none(), nb::arg("given"));
    module.def(
        "_survey_of_points",
        [](const CableNet& net, const ArrayLike& positions,
           const std::optional<std::vector<std::string>>& ids, const std::optional<ArrayLike>& stds,
           bool in_metres, std::optional<double> noise, const Given& given) {
            const ReadSurveyOptions options = options_of(noise, given);
            std::vector<SurveyPoint> points = points_of(positions, ids, stds);
            if (in_metres && options.unit) {
                // read_survey() takes them in the unit of the coordinates.
                for (SurveyPoint& point : points) {
                    if (point.noise_std) {
                        *point.noise_std /= *options.unit;
                    }
                }
            }
            return read_survey(net, points, options);
        },
        nb::arg("net"), nb::arg("positions"), nb::arg("ids").none(), nb::arg("stds").none(),
        nb::arg("in_metres"), nb::arg("noise").none(), nb::arg("given"));
    module.def("_length_given", [](const QuantityLike& given, const std::string& name) {
        return length_given(given, name.c_str());
    });
    module.def("_length_of_unit", &unit_named);
    module.def("_force_given", [](const QuantityLike& given, const std::string& name) {
        return force_given(given, name.c_str());
    });
    module.def(
        "simulate_survey",
        [](const CableNet& net, const ArrayLike& form, const QuantityLike& noise,
           double hidden_part, bool shuffled, bool random_frame, std::uint64_t seed) {
            return columns_of(simulate_survey(net, points_argument(form, "form", net.node_count()),
                                              {.noise_std = length_given(noise, "noise"),
                                               .dropped_part = hidden_part,
                                               .shuffled = shuffled,
                                               .random_frame = random_frame,
                                               .seed = seed}));
        },
        nb::arg("net"), nb::arg("form"), nb::kw_only(), nb::arg("noise") = 0.0,
        nb::arg("hidden_part") = 0.0, nb::arg("shuffled") = false, nb::arg("random_frame") = false,
        nb::arg("seed") = 1,
        R"(Simulates the survey of a form.

Args:
    form: (n, 3), supports included [m].
    noise: standard deviation of each coordinate [m].
    hidden_part: part of the free nodes that is not surveyed.
    shuffled: points have no names, and any order.
    random_frame: in a frame of the instrument, unknown to the net.

Returns:
    Columns id, x, y, z and, where there is noise, sx, sy, sz [m], as read_survey() takes them.)");
}

}  // namespace taut::python
