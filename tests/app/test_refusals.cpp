// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against work on impossible requests, and against a failure that spoils earlier files: each
// must end with exit code 2, one line that names what is wrong, and no file touched. What the
// library refuses is tested there; here, that each command and option comes to it.

#include <map>
#include <ostream>
#include <sstream>

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/form_csv.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/sampler.hpp"

namespace {

using namespace taut;
using namespace taut::test;

struct Request {
    std::string name;
    std::string command;  ///< words between blanks; '' is an empty one
    std::string named;    ///< in the error
};

void PrintTo(const Request& request, std::ostream* stream) {
    *stream << "taut " << request.command;
}

Words words(const std::string& command) {
    std::istringstream stream(command);
    Words result;
    for (std::string word; stream >> word;) {
        result.push_back(word == "''" ? "" : word);
    }
    return result;
}

/// Requests of lines "name | command | text in the error", under lines "# part of a name".
/// "@identify" and others stand for commands that would succeed.
auto requests(const std::string& table) {
    const std::map<std::string, std::string> sound{
        {"@identify", "identify net.json survey.csv --noise 1mm -o old.json"},
        {"@no_noise", "identify net.json survey.csv -o old.json"},
        {"@sample", "sample net.json -n 5 -o old.h5"},
        {"@compare", "compare net.json -o out"},
        {"@reproduce", "reproduce --net net.json -o directory"}};
    std::vector<Request> result;
    std::istringstream stream(table);
    std::string part;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("# ")) {
            part = line.substr(2) + "_";
        } else if (!line.empty()) {
            const size_t first = line.find(" | ");
            const size_t last = line.rfind(" | ");
            std::string command = line.substr(first + 2, last - first - 2);
            for (const auto& [name, whole] : sound) {
                if (const size_t at = command.find(name); at != std::string::npos) {
                    command.replace(at, name.size(), whole);
                }
            }
            result.push_back({part + line.substr(0, first), command, line.substr(last + 3)});
        }
    }
    return testing::ValuesIn(result);
}

class Refused : public ProgramTest, public testing::WithParamInterface<Request> {
protected:
    Refused() {
        static const Files made = make_files();
        for (const auto& [file, content] : made) {
            if (file.ends_with('/')) {
                std::filesystem::create_directory(folder() / file);
            } else {
                write(file, content);
            }
        }
    }

    /// What all requests find, made once.
    Files make_files() const {
        const CableNet net = hypar(2, 3);
        const CableNet other = hypar(2, 4);
        write("net.json", net_to_json(net));
        write("other.json", net_to_json(other));
        write("no_interior.json", net_to_json(hypar(1, 1)));
        write("truncated.json", net_to_json(net).substr(0, 500));
        const std::string comparison =
            R"({"format": "taut-comparison", "version": 1, "net": {"name": "a"},
            "rows": [{"method": "gp", "noise": 0, "mse": 1e-8}]})";
        write("result.json", comparison);
        write("text", "what a net is, in words\n");
        write("empty", "");
        std::filesystem::create_directory(folder() / "directory");
        for (const std::string output : {"old.json", "old.csv", "old.h5"}) {
            write(output, "an earlier outcome\n");
        }
        make_data_and_model(net, "");
        make_data_and_model(other, "other_");

        for (const std::string output : {"nodes.csv", "nodes_edges.csv", "list.csv"}) {
            write(output, form_to_csv(net, net.nodes()));
        }
        std::filesystem::create_directory(folder() / "study");
        write("study/results.json", net_to_json(net));
        const std::string survey = form_to_csv(net, net.nodes());
        write("survey.csv", survey);
        write("survey_mm.csv", form_to_csv(net, 1000.0 * net.nodes()));
        write("survey_part.csv", survey.substr(0, survey.rfind('\n', survey.size() / 2) + 1));
        write("forces.csv", "edge,tension\n3,5000\n");
        write("forces_of_another_net.csv", "edge,tension\ncable 9,500\n");
        write("three.txt", "3\n");
        return files();
    }

    void make_data_and_model(const CableNet& net, const std::string& prefix) const {
        const Sampler sampler(net, {}, 1);
        DataSet data = sampler.empty();
        sampler.extend(data, 8);
        const NetFile file{.net = net, .unknown_keys = "{}"};
        write_data_set(folder() / (prefix + "data.h5"), data, file);
        write_model(folder() / (prefix + "model.h5"), train(net, data, {0, 1, 2, 3, 4, 5, 6, 7}),
                    file);
    }
};

TEST_P(Refused, InOneLineAndNoFileIsTouched) {
    const Files before = files();
    expect_error(run(words(GetParam().command)), 2, GetParam().named);
    EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(Of, Refused, requests(R"(
# program
no_subcommand |  | subcommand
unknown_subcommand | tension net.json | 'tension' is not a command
unknown_option | inspect net.json --colour | --colour
negative_threads | inspect net.json --threads -2 | --threads
too_many_words | inspect net.json other.json | other.json
seed_beyond_64_bits | @sample --seed 99999999999999999999 | expected a whole number from 0 to 2^64 - 1
seed_that_is_a_word | @reproduce --seed one | --seed
# example
too_many_columns | example hypar:5x1001 -o old.json | 5 x 1001
no_name | example -o old.json | NAME
# net
missing | inspect nothing.json | nothing.json
truncated | form truncated.json -o old.csv | truncated.json:
empty | sample empty -n 5 -o old.h5 | empty:
directory | compare directory -o out | directory
data_set | reproduce --net data.h5 -o new | data.h5:
not_given | inspect | NET
form_by_unknown_solver | form net.json -o old.csv --solver guess | --solver
form_by_unknown_cone_form | form net.json -o old.csv --solver socp --cone-form big | --cone-form
# suggestions
without_a_survey | inspect net.json --suggest | --survey
of_no_quantity | inspect net.json --survey survey.csv --suggest tension | what is sought is 'tension'
cost_of_no_kind | inspect net.json --survey survey.csv --suggest --cost cell:2 | a kind of measurement is 'cell'
cost_of_nothing | inspect net.json --survey survey.csv --suggest --cost load:0 | --cost is 'load:0'
load_upwards | inspect net.json --survey survey.csv --suggest --load=-5N | --load is '-5N'
# stages
of_no_group | plan net.json result.json -o old.json --stages :50% | --stages is ':50%'
# prior
of_form_above_the_shortest_length | form net.json --prior uniform:9m -o old.csv | net.json: the prior uniform:9000mm
of_form_of_no_kind | form net.json --prior gauss:5mm -o old.csv | 'gauss:5mm'
of_form_without_interior_edge | form no_interior.json --prior uniform:1mm -o old.csv | no_interior.json:
of_sample | @sample --prior uniform:140mm | uniform:140mm
of_identify_lost_in_rounding | @identify --prior uniform:1e-12mm | net.json:
of_another_model | @no_noise --model model.h5 --prior uniform:4mm | uniform:5mm
# sample
none | sample net.json -n 0 -o old.h5 | --samples
resume_of_text | sample net.json -n 9 -o old.h5 --resume | old.h5:
# compare
noise_of_unknown_unit | @compare --noise 0,0.5in | --noise has the entry '0.5in'
absurd_noise | @compare --noise 0.5m --training 9 | 0.5 m
an_empty_entry | @compare --noise 0,,1mm | --noise has the entry ''
one_training_sample | @compare --training 100,1 | 1 training samples, expected 2
all_hidden | @compare --hidden 100% | the hidden part is 1
no_surveys | @compare --surveys 0 | 0 surveys
# train
missing_data | train nothing.h5 -o old.h5 | nothing.h5
model_for_data | train model.h5 -o old.h5 | model.h5
# identify
missing_survey | identify net.json nothing.csv --model model.h5 -o old.json | nothing.csv
text_for_survey | identify net.json text -o old.json | text:
survey_in_millimetres | identify net.json survey_mm.csv --model model.h5 -o old.json | give the unit mm
hidden_nodes_without_noise | identify net.json survey_part.csv -o old.json | survey_part.csv:
hidden_nodes_for_balance | identify net.json survey_part.csv --method balance --noise 1mm -o old.json | balance
forces_of_another_net | @identify --forces forces_of_another_net.csv | forces_of_another_net.csv:2: 'cable 9'
force_of_a_slack_edge | @identify --forces forces.csv --slack three.txt | three.txt:
taut_and_slack | @identify --taut all --slack three.txt | three.txt:
force_noise_of_nothing | @identify --forces forces.csv --force-noise 0% | --force-noise
force_unit_without_forces | @identify --force-unit kN | --forces
uncertain_without_width | @identify --uncertain stiffness | stiffness
uncertain_twice | @identify --uncertain supports:1mm --uncertain supports:2mm | supports
uncertain_of_no_group | @identify --uncertain stiffness:5%@ridge | net.json:
uncertain_to_a_model_without | @identify --model model.h5 --uncertain supports:1mm | none
negative_noise | @no_noise --noise=-1mm | '-1mm'
noise_to_be_estimated_before_a_survey | inspect net.json --survey survey.csv --noise estimate | --noise estimate
negative_draws | @no_noise --draws=-1 | -1
more_draws_than_memory | @no_noise --draws 1000000000000 | 1000000000000
data_for_model | @no_noise --model data.h5 | data.h5
model_of_another_net | @no_noise --model other_model.h5 | other_model.h5
unknown_method | @no_noise --method guess | --method
# report
missing_result | report nothing.json -o new.html | nothing.json
net_for_a_result | report net.json -o new.html | net.json:/format
data_for_a_result | report data.h5 -o new.html | is an HDF5 file
# reproduce
negative_samples | @reproduce --samples -10 | -10 samples
one_left_to_train_on | @reproduce --samples 10 --validation 9 | 9 validation samples of 10
# no_output
of_example | example hypar:2x2 | --output
of_report | report result.json | --output
of_an_empty_name | example hypar:2x2 -o '' | is empty
of_an_empty_directory | compare net.json -o '' | is empty
# standard_output
of_report | report result.json -o - | -: results go to files, not to standard output
of_identify | identify net.json survey.csv --noise 1mm -o - | -: results go to files
of_form | form net.json --lengths - --prior uniform:1mm | -: results go to files
of_export | export net.json --to csv -o - | -: results go to files
of_inspect | inspect net.json --survey survey.csv --noise 1mm --names - | -: results go to files
of_compare | compare net.json -o - | -: results go to files
# output
of_example_in_no_directory | example hypar:2x2 -o nowhere/net.json | nowhere/net.json
of_the_lengths_of_form | form net.json -o old.csv --lengths nowhere/truth.csv | nowhere/truth.csv: cannot
of_sample | sample net.json -n 5 -o nowhere/data.h5 | nowhere/data.h5
of_train | train data.h5 -o nowhere/model.h5 | nowhere/model.h5
of_identify | identify net.json survey.csv --model model.h5 -o nowhere/result.json | nowhere/result.json
of_report | report result.json -o nowhere/report.html | nowhere/report.html
of_compare_that_is_a_file | compare net.json -o text | text
of_reproduce_below_a_file | reproduce --net net.json -o text/study | text
# overwriting
by_import | import net.json -o net.json | net.json: is an input
by_import_by_another_name | import net.json -o ./directory/../net.json | net.json: is an input
by_import_of_edges | import nodes.csv --edges nodes_edges.csv -o nodes_edges.csv | nodes_edges.csv: is an input
by_import_of_supports | import net.json --supports list.csv -o list.csv | list.csv: is an input
by_export_of_a_form | export net.json survey.csv --to obj -o survey.csv | survey.csv: is an input
by_the_second_file_of_export | export net.json nodes_edges.csv --to csv -o nodes.csv | nodes_edges.csv: is an input
by_the_lengths_of_form | form net.json --lengths net.json | net.json: is an input
by_train | train data.h5 -o data.h5 | data.h5: is an input
by_survey | survey net.json survey.csv -o survey.csv | survey.csv: is an input
by_identify | identify net.json survey.csv --model model.h5 -o model.h5 | model.h5: is an input
by_identify_of_control_points | identify net.json survey.csv --control list.csv -o list.csv | list.csv: is an input
by_report | report result.json -o result.json | result.json
by_reproduce | reproduce --net study/results.json --samples 10 --validation 2 -o study | results.json: is an input
with_another_output | form net.json -o new.csv --lengths ./new.csv | new.csv: is to be written twice
with_another_output_that_is_there | form net.json -o old.csv --lengths old.csv | old.csv: is to be written twice
)"),
                         [](const auto& request) { return request.param.name; });

}  // namespace
