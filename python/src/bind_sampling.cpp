// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "given.hpp"
#include "states.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/sampling/built_net.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut::python {
namespace {

MeanFunction mean_named(const std::string& name) {
    for (const MeanFunction mean : {MeanFunction::zero, MeanFunction::geometry}) {
        if (to_string(mean) == name) {
            return mean;
        }
    }
    throw nb::value_error(
        fmt::format("mean: got '{}', expected 'zero' or 'geometry'", name).c_str());
}

KernelMetric metric_named(const std::string& name) {
    for (const KernelMetric metric :
         {KernelMetric::isotropic, KernelMetric::direction, KernelMetric::node}) {
        if (to_string(metric) == name) {
            return metric;
        }
    }
    throw nb::value_error(
        fmt::format("kernel: got '{}', expected 'isotropic', 'direction' or 'node'", name).c_str());
}

/// @throws nb::value_error for what was made for another net
void check_made_for(const CableNet& net, const std::string& fingerprint) {
    if (net.fingerprint() != fingerprint) {
        throw nb::value_error(
            fmt::format("net: got the one of fingerprint {} ('{}'), expected that of {}",
                        net.fingerprint(), net.name(), fingerprint)
                .c_str());
    }
}

/// @throws nb::value_error for a data set of other settings, whose samples would not go with ours
void check_made_by(const Sampler& sampler, const DataSet& data) {
    const DataSet own = sampler.no_samples();
    const auto words_of = [](const DataSet& of) {
        return fmt::format("the net {}, {}, seed {}{}", of.net_fingerprint, to_string(of.prior),
                           of.seed,
                           of.uncertain.empty() ? "" : ", uncertain " + to_string(of.uncertain));
    };
    if (own.net_fingerprint != data.net_fingerprint || own.prior != data.prior ||
        own.seed != data.seed || own.uncertain != data.uncertain) {
        throw nb::value_error(fmt::format("data: got one of {}, expected one of this sampler: {}",
                                          words_of(data), words_of(own))
                                  .c_str());
    }
}

void bind_data_set(nb::module_& module) {
    nb::class_<DataSet> data(module, "DataSet",
                             "Pairs of form deviation and length deviation from the nominal net "
                             "(Algorithm 2 of the paper), a row a sample.");
    make_picklable(data);
    data.def_prop_ro(
            "form_deviations",
            [](nb::handle_t<DataSet> self) {
                return rows_of_columns(nb::cast<const DataSet&>(self).form_deviations, self);
            },
            "Of the free coordinates x1, y1, z1, x2, ... (samples, 3 n_I) [m].")
        .def_prop_ro(
            "length_deviations",
            [](nb::handle_t<DataSet> self) {
                return rows_of_columns(nb::cast<const DataSet&>(self).length_deviations, self);
            },
            "Of the interior edges (samples, m_I) [m].")
        .def_prop_ro(
            "nominal_form",
            [](nb::handle_t<DataSet> self) {
                return view_of(nb::cast<const DataSet&>(self).nominal_form, self);
            },
            "Free coordinates of the nominal net (3 n_I,) [m].")
        .def_prop_ro(
            "slack_counts",
            [](nb::handle_t<DataSet> self) {
                return view_of(nb::cast<const DataSet&>(self).slack_counts, self);
            },
            "Slack edges in each sample (samples,).")
        .def_prop_ro(
            "converged",
            [](const DataSet& self) { return array_of(self.converged_in(0, self.size())); },
            "Samples whose forces balance.")
        .def_prop_ro("prior", [](const DataSet& self) { return to_string(self.prior); })
        .def_ro("seed", &DataSet::seed)
        .def("__len__", &DataSet::size)
        .def(
            "save",
            [](const DataSet& self, const std::filesystem::path& path, const CableNet& net) {
                check_made_for(net, self.net_fingerprint);
                write_data_set(path, self, {.net = net});
            },
            nb::arg("path"), nb::arg("net"), "Writes data.h5 with the net, whole or not at all.")
        .def_static(
            "load",
            [](const std::filesystem::path& path) {
                StoredDataSet stored = without_lock([&] { return read_data_set(path); });
                return nb::make_tuple(std::move(stored.data), std::move(stored.net.net));
            },
            nb::arg("path"), "Reads data.h5: the data set and its net.")
        .def("__repr__", [](const DataSet& self) {
            return fmt::format("DataSet({} samples, {}, {} with slack edges)", self.size(),
                               to_string(self.prior), self.with_slack());
        });
}

void bind_model(nb::module_& module) {
    nb::class_<LengthModel> model(module, "LengthModel",
                                  "The learnt map from form deviation to length deviations: one "
                                  "Gaussian process an interior edge.");
    make_picklable(model);
    model.def_prop_ro("training_count", &LengthModel::training_count)
        .def_prop_ro("prior", [](const LengthModel& self) { return to_string(self.prior); })
        .def_prop_ro("mean", [](const LengthModel& self) { return to_string(self.mean); })
        .def_prop_ro("kernel", [](const LengthModel& self) { return to_string(self.metric); })
        .def_ro("as_in_paper", &LengthModel::as_in_paper)
        .def_prop_ro("net_fingerprint",
                     [](const LengthModel& self) { return self.net_fingerprint; })
        .def_prop_ro(
            "hyperparameters",
            [](const LengthModel& self) {
                const auto count = static_cast<Eigen::Index>(self.processes.processes.size());
                Eigen::MatrixXd values(3, count);
                for (Eigen::Index i = 0; i < count; ++i) {
                    const gp::Hyperparameters& of =
                        self.processes.processes[static_cast<size_t>(i)].hyperparameters;
                    values.col(i) << of.inverse_length_scale, of.signal_std, of.noise_std;
                }
                return array_of_columns(std::move(values));
            },
            "Of each interior edge: inverse length scale [1/m], signal and noise standard "
            "deviation [m] (m_I, 3).")
        .def_prop_ro(
            "rank", [](const LengthModel& self) { return self.processes.rank(); },
            "Directions of the kernel matrix that were kept, where samples were too many to keep "
            "all; else None.")
        .def_prop_ro(
            "approximation_error",
            [](const LengthModel& self) {
                return array_of_each(self.processes.processes, &gp::Process::approximation_error);
            },
            "By low rank: bound of what the mean of each interior edge is off from the exact one, "
            "root mean square over the training samples; else 0 [m] (m_I,).")
        .def(
            "save",
            [](const LengthModel& self, const std::filesystem::path& path, const CableNet& net) {
                check_made_for(net, self.net_fingerprint);
                write_model(path, self, {.net = net});
            },
            nb::arg("path"), nb::arg("net"), "Writes model.h5 with the net, whole or not at all.")
        .def_static(
            "load",
            [](const std::filesystem::path& path) {
                StoredModel stored = read_model(path);
                return nb::make_tuple(std::move(stored.model), std::move(stored.net.net));
            },
            nb::arg("path"), "Reads model.h5: the model and its net.")
        .def("__repr__", [](const LengthModel& self) {
            return fmt::format("LengthModel({} processes, {} training samples, {}{})",
                               self.processes.processes.size(), self.training_count(),
                               to_string(self.prior), self.as_in_paper ? ", as in the paper" : "");
        });
}

}  // namespace

void bind_sampling(nb::module_& module) {
    bind_data_set(module);
    bind_model(module);
    nb::class_<SamplePart> part(module, "SamplePart",
                                "Some of a sampler's samples, to be joined with others.");
    make_picklable(part);
    part.def_ro("first", &SamplePart::first)
        .def("__len__", [](const SamplePart& self) { return self.samples.size(); })
        .def("__repr__", [](const SamplePart& self) {
            return fmt::format("SamplePart({} samples from {} on)", self.samples.size(),
                               self.first);
        });
    nb::class_<Sampler>(module, "Sampler",
                        "Draws length deviations and solves for the forms that follow, in parallel "
                        "(Algorithm 2 of the paper).")
        .def(
            "__init__",
            [](Sampler* self, const CableNet& net, const std::string& prior, std::uint64_t seed,
               const std::vector<std::string>& uncertain) {
                without_lock([&] {
                    return new (self) Sampler(net, parse_length_prior(prior), seed,
                                              uncertain_given(net, uncertain));
                });
            },
            nb::arg("net"), nb::arg("prior") = "uniform:5mm", nb::arg("seed") = 1,
            nb::arg("uncertain") = std::vector<std::string>(),
            R"(Args:
    prior: of the length deviations: 'uniform:5mm', 'normal:2mm', 'bimodal:5mm'.
    uncertain: what is drawn besides the lengths, as in 'stiffness:5%'.)")
        .def(
            "draw",
            [](const Sampler& self, int count, const nb::object& progress) {
                if (count < 0) {
                    throw nb::value_error(
                        fmt::format("count: got {}, expected 0 or more", count).c_str());
                }
                return interruptible(progress, [&](const Progress& reporter) {
                    return draw_samples(self, count, reporter);
                });
            },
            nb::arg("count"), nb::kw_only(), nb::arg("progress") = nb::none(),
            "The first samples, the same on any number of threads.\n\nArgs:\n    progress: called "
            "with stage, done, total.")
        .def(
            "extend",
            [](const Sampler& self, DataSet data, int count, const nb::object& progress) {
                check_made_by(self, data);
                if (count < data.size()) {
                    throw nb::value_error(
                        fmt::format("count: got {}, expected {} or more, as data has", count,
                                    data.size())
                            .c_str());
                }
                return interruptible(progress, [&](const Progress& reporter) {
                    self.extend_to(data, count, reporter);
                    return std::move(data);
                });
            },
            nb::arg("data"), nb::arg("count"), nb::kw_only(), nb::arg("progress") = nb::none(),
            "A data set of this sampler with more samples, `count` in all.")
        .def(
            "part",
            [](const Sampler& self, int first, int count, const nb::object& progress) {
                return interruptible(progress, [&](const Progress& reporter) {
                    return self.part(first, count, reporter);
                });
            },
            nb::arg("first"), nb::arg("count"), nb::kw_only(), nb::arg("progress") = nb::none(),
            "Samples `first` to `first` + `count` - 1, to be joined with others: for processes "
            "that share the work.")
        .def(
            "joined",
            [](const Sampler& self, std::vector<SamplePart> parts) {
                return without_lock([&] { return self.joined(std::move(parts)); });
            },
            nb::arg("parts"),
            "The data set of all parts, in whatever order: bit for bit that of `draw`.");
    module.def(
        "built_net",
        [](const CableNet& net, const std::string& prior, std::uint64_t seed) {
            return built_net(net, parse_length_prior(prior), seed);
        },
        nb::arg("net"), nb::arg("prior") = "uniform:5mm", nb::arg("seed") = 1,
        "A net as it might be built, for simulations: the lengths of its interior edges are drawn "
        "from the prior.");
    module.def(
        "train",
        [](const CableNet& net, const DataSet& data, const std::optional<ArrayLike>& samples,
           const std::optional<std::string>& mean, const std::optional<std::string>& kernel,
           bool as_in_paper, const nb::object& progress) {
            TrainingSettings settings =
                as_in_paper ? TrainingSettings::paper() : TrainingSettings();
            settings.mean = mean ? mean_named(*mean) : settings.mean;
            settings.metric = kernel ? metric_named(*kernel) : settings.metric;
            const std::vector<int> on =
                samples ? indices_argument(*samples, "samples") : data.converged_in(0, data.size());
            return interruptible(progress, [&](const Progress& reporter) {
                return train_model(net, data, on, settings, reporter);
            });
        },
        nb::arg("net"), nb::arg("data"), nb::arg("samples") = nb::none(), nb::kw_only(),
        nb::arg("mean") = nb::none(), nb::arg("kernel") = nb::none(),
        nb::arg("as_in_paper") = false, nb::arg("progress") = nb::none(),
        R"(One Gaussian process an edge (Algorithm 1 of the paper).

Args:
    samples: which to train on, by default all whose forces balance.
    mean: mean function, by default 'geometry', or 'zero'.
    kernel: metric of two forms, by default 'isotropic'; 'direction' or 'node'.
    as_in_paper: zero mean, isotropic kernel, every survey taken as exact and complete.)");
}

}  // namespace taut::python
