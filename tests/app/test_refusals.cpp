// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against work on what makes no sense, and against a failure that spoils what was there:
// each impossible request must end with exit code 2, one line that says what is wrong, and no file
// touched.

#include <algorithm>
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
    std::string told;     ///< what the error must name
};

void PrintTo(const Request& request, std::ostream* stream) {
    *stream << "taut " << request.command;
}

std::vector<std::string> words(const std::string& command) {
    std::istringstream stream(command);
    std::vector<std::string> result;
    for (std::string word; stream >> word;) {
        result.push_back(word == "''" ? "" : word);
    }
    return result;
}

class Refused : public ProgramTest, public testing::WithParamInterface<Request> {
protected:
    Refused() {
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
        write("truncated_result.json", comparison.substr(0, 60));
        write("later_result.json", R"({"format": "taut-study", "version": 2})");
        write("nan_result.json", R"({"format": "taut-study", "version": NaN})");
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
        write("other_survey.csv", form_to_csv(other, other.nodes()));
        write("survey_mm.csv", form_to_csv(net, 1000.0 * net.nodes()));
        write("survey_part.csv", survey.substr(0, survey.rfind('\n', survey.size() / 2) + 1));
        write("survey_twice.csv",
              survey + survey.substr(survey.rfind('\n', survey.size() - 2) + 1));
        write("forces.csv", "edge,tension\n3,5000\n");
        write("forces_of_another_net.csv", "edge,tension\ncable 9,500\n");
        write("forces_negative.csv", "edge,tension\n3,-500\n");
        write("three.txt", "3\n");
        write("survey_unknown.csv", survey + "tower,0,0,0\n");
        write("survey_nan.csv", survey.substr(0, survey.rfind(',') + 1) + "nan\n");
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
    expect_error(run(words(GetParam().command)), 2, GetParam().told);
    EXPECT_EQ(files(), before);
}

std::string name_of(const testing::TestParamInfo<Request>& request) {
    return request.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Program, Refused,
    testing::Values(Request{"no_subcommand", "", "subcommand"},
                    Request{"unknown_subcommand", "tension net.json", "'tension' is no command"},
                    Request{"two_subcommands", "inspect net.json inspect net.json", "inspect"},
                    Request{"unknown_option", "inspect net.json --colour", "--colour"},
                    Request{"no_threads", "inspect net.json --threads 0", "--threads"},
                    Request{"negative_threads", "inspect net.json --threads -2", "--threads"},
                    Request{"too_many_words", "inspect net.json other.json", "other.json"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Example, Refused,
    testing::Values(Request{"unknown_net", "example hilo -o old.json", "'hilo'"},
                    Request{"no_rows", "example hypar:0x5 -o old.json", "0 x 5"},
                    Request{"negative_rows", "example hypar:-2x5 -o old.json", "hypar:-2x5"},
                    Request{"too_many_columns", "example hypar:5x1001 -o old.json", "5 x 1001"},
                    Request{"too_many_rows_to_count", "example hypar:99999999999x2 -o old.json",
                            "hypar:99999999999x2"},
                    Request{"no_name", "example -o old.json", "NAME"},
                    Request{"no_output", "example hypar:2x2", "--output"},
                    Request{"empty_output", "example hypar:2x2 -o ''", "is empty"},
                    Request{"output_in_no_directory", "example hypar:2x2 -o nowhere/net.json",
                            "nowhere/net.json"},
                    Request{"output_is_a_directory", "example hypar:2x2 -o directory", "directory"},
                    Request{"output_below_a_file", "example hypar:2x2 -o text/net.json",
                            "text/net.json"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Net, Refused,
    testing::Values(
        Request{"missing", "inspect nothing.json", "nothing.json"},
        Request{"truncated", "inspect truncated.json", "truncated.json:"},
        Request{"text", "inspect text", "text:"}, Request{"empty", "inspect empty", "empty:"},
        Request{"directory", "inspect directory", "directory"},
        Request{"data_set", "inspect data.h5", "data.h5:"}, Request{"not_given", "inspect", "NET"},
        Request{"form_of_missing", "form nothing.json -o old.csv", "nothing.json"},
        Request{"form_of_truncated", "form truncated.json -o old.csv", "truncated.json:"},
        Request{"form_by_unknown_solver", "form net.json -o old.csv --solver guess", "--solver"},
        Request{"form_by_unknown_cone_form",
                "form net.json -o old.csv --solver socp --cone-form big", "--cone-form"},
        Request{
            "form_of_a_law_beyond_the_shortest_length",
            "form net.json --prior uniform:9m -o old.csv",
            "net.json: the prior uniform:9000mm reaches deviations of 9000 mm, expected less than"},
        Request{"form_of_a_normal_law_beyond_the_shortest_length",
                "form net.json --prior normal:60mm -o old.csv", "net.json: the prior normal:60mm"},
        Request{"form_of_no_law", "form net.json --prior gauss:5mm -o old.csv", "'gauss:5mm'"},
        Request{"form_of_lengths_of_a_net_without_interior_edge",
                "form no_interior.json --prior uniform:1mm -o old.csv",
                "no_interior.json: the net has no interior edge"},
        Request{"form_into_no_directory", "form net.json -o nowhere/form.csv", "nowhere/form.csv"},
        Request{"form_into_a_directory", "form net.json -o directory", "directory"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Sample, Refused,
    testing::Values(
        Request{"none", "sample net.json -n 0 -o old.h5", "--samples"},
        Request{"a_negative_number", "sample net.json -n -3 -o old.h5", "--samples"},
        Request{"half_a_sample", "sample net.json -n 2.5 -o old.h5", "--samples"},
        Request{"a_word", "sample net.json -n many -o old.h5", "--samples"},
        Request{"too_many", "sample net.json -n 99999999999999999999 -o old.h5", "--samples"},
        Request{"no_number", "sample net.json -o old.h5", "--samples"},
        Request{"no_output", "sample net.json -n 5", "--output"},
        Request{"empty_output", "sample net.json -n 5 -o ''", "is empty"},
        Request{"into_no_directory", "sample net.json -n 5 -o nowhere/data.h5", "nowhere/data.h5"},
        Request{"into_a_directory", "sample net.json -n 5 -o directory", "directory"},
        Request{"missing_net", "sample nothing.json -n 5 -o old.h5", "nothing.json"},
        Request{"truncated_net", "sample truncated.json -n 5 -o old.h5", "truncated.json:"},
        Request{"net_without_interior_edge", "sample no_interior.json -n 5 -o old.h5",
                "no interior edge"},
        Request{"unknown_law", "sample net.json -n 5 -o old.h5 --prior gauss:5mm", "'gauss:5mm'"},
        Request{"law_without_bound", "sample net.json -n 5 -o old.h5 --prior uniform", "'uniform'"},
        Request{"negative_bound", "sample net.json -n 5 -o old.h5 --prior uniform:-5mm",
                "uniform:-5mm"},
        Request{"no_bound", "sample net.json -n 5 -o old.h5 --prior uniform:0mm", "uniform:0mm"},
        Request{"bound_of_unknown_unit", "sample net.json -n 5 -o old.h5 --prior uniform:5in",
                "'5in'"},
        Request{"bound_beyond_the_shortest_length",
                "sample net.json -n 5 -o old.h5 --prior uniform:140mm", "uniform:140mm"},
        Request{"normal_beyond_the_shortest_length",
                "sample net.json -n 5 -o old.h5 --prior normal:20mm", "normal:20mm"},
        Request{"bound_too_large_to_be_a_number",
                "sample net.json -n 5 -o old.h5 --prior uniform:1e999mm", "'1e999mm'"},
        Request{"negative_seed", "sample net.json -n 5 -o old.h5 --seed -1", "--seed"},
        Request{"output_that_is_the_net", "sample net.json -n 5 -o net.json",
                "net.json: is an input of this command"},
        Request{"seed_beyond_64_bits", "sample net.json -n 5 -o old.h5 --seed 99999999999999999999",
                "--seed: is '99999999999999999999', expected a whole number from 0 to 2^64 - 1"},
        Request{"seed_that_is_a_word", "sample net.json -n 5 -o old.h5 --seed one", "--seed"},
        Request{"resume_of_another_nets_data", "sample net.json -n 9 -o other_data.h5 --resume",
                hypar(2, 4).fingerprint()},
        Request{"resume_of_text", "sample net.json -n 9 -o old.h5 --resume", "old.h5:"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Compare, Refused,
    testing::Values(Request{"no_net", "compare -o out", "NET"},
                    Request{"missing_net", "compare nothing.json -o out", "nothing.json"},
                    Request{"no_output", "compare net.json", "--output"},
                    Request{"empty_output", "compare net.json -o ''", "is empty"},
                    Request{"output_is_a_file", "compare net.json -o text", "text"},
                    Request{"noise_of_unknown_unit", "compare net.json -o out --noise 0,0.5in",
                            "--noise has the entry '0.5in'"},
                    Request{"noise_beyond_all_measure",
                            "compare net.json -o out --noise 0.5m --training 9", "noise of 0.5 m"},
                    Request{"negative_noise", "compare net.json -o out --noise 0,-1mm",
                            "--noise has the entry '-1mm'"},
                    Request{"no_noise", "compare net.json -o out --noise ''", "is empty"},
                    Request{"an_empty_entry", "compare net.json -o out --noise 0,,1mm",
                            "--noise has the entry ''"},
                    Request{"one_training_sample", "compare net.json -o out --training 100,1",
                            "--training has the entry '1'"},
                    Request{"training_in_words", "compare net.json -o out --training many",
                            "--training has the entry 'many'"},
                    Request{"hidden_without_unit", "compare net.json -o out --hidden 0.1",
                            "--hidden has the entry '0.1'"},
                    Request{"all_hidden", "compare net.json -o out --hidden 100%",
                            "--hidden has the entry '100%'"},
                    Request{"no_surveys", "compare net.json -o out --surveys 0", "0 surveys"},
                    Request{"unknown_law", "compare net.json -o out --prior gauss:5mm",
                            "'gauss:5mm'"},
                    Request{"net_without_interior_edge", "compare no_interior.json -o out",
                            "no interior edge"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Train, Refused,
    testing::Values(Request{"missing_data", "train nothing.h5 -o old.h5", "nothing.h5"},
                    Request{"text_for_data", "train text -o old.h5", "text"},
                    Request{"net_for_data", "train net.json -o old.h5", "net.json"},
                    Request{"empty_data", "train empty -o old.h5", "empty"},
                    Request{"model_for_data", "train model.h5 -o old.h5", "model.h5"},
                    Request{"no_output", "train data.h5", "--output"},
                    Request{"into_no_directory", "train data.h5 -o nowhere/model.h5",
                            "nowhere/model.h5"},
                    Request{"into_a_directory", "train data.h5 -o directory", "directory"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Identify, Refused,
    testing::Values(
        Request{"missing_survey", "identify net.json nothing.csv --model model.h5 -o old.json",
                "nothing.csv"},
        Request{"text_for_survey", "identify net.json text --model model.h5 -o old.json", "text:"},
        Request{"empty_survey", "identify net.json empty --model model.h5 -o old.json", "empty:"},
        Request{"survey_of_another_net",
                "identify net.json other_survey.csv --model model.h5 -o old.json",
                "other_survey.csv:"},
        Request{"survey_in_millimetres",
                "identify net.json survey_mm.csv --model model.h5 -o old.json",
                "--unit mm tells it"},
        Request{"survey_with_missing_nodes",
                "identify net.json survey_part.csv --model model.h5 -o old.json", "first missing"},
        Request{"hidden_nodes_without_noise", "identify net.json survey_part.csv -o old.json",
                "--noise"},
        Request{"hidden_nodes_without_noise_for_map",
                "identify net.json survey_part.csv --method map -o old.json", "--noise"},
        Request{"hidden_nodes_for_balance",
                "identify net.json survey_part.csv --method balance --noise 1mm -o old.json",
                "--method balance"},
        Request{"forces_of_another_net",
                "identify net.json survey.csv --noise 1mm --forces forces_of_another_net.csv -o "
                "old.json",
                "forces_of_another_net.csv:2: 'cable 9' is no edge"},
        Request{"negative_force",
                "identify net.json survey.csv --noise 1mm --forces forces_negative.csv -o old.json",
                "forces_negative.csv:2: tension is '-500'"},
        Request{"forces_missing",
                "identify net.json survey.csv --noise 1mm --forces nothing.csv -o old.json",
                "nothing.csv"},
        Request{"force_of_a_slack_edge",
                "identify net.json survey.csv --noise 1mm --forces forces.csv --slack three.txt -o "
                "old.json",
                "the tension of edge '3' is read, and it is told slack"},
        Request{"taut_and_slack",
                "identify net.json survey.csv --noise 1mm --taut all --slack three.txt -o old.json",
                "edge '3' is seen both taut and slack"},
        Request{"force_noise_of_nothing",
                "identify net.json survey.csv --noise 1mm --forces forces.csv --force-noise 0% -o "
                "old.json",
                "--force-noise"},
        Request{"force_unit_without_forces",
                "identify net.json survey.csv --noise 1mm --force-unit kN -o old.json", "--forces"},
        Request{"forces_for_balance",
                "identify net.json survey.csv --noise 1mm --method balance --forces forces.csv -o "
                "old.json",
                "for --method map"},
        Request{"unknown_without_width",
                "identify net.json survey.csv --noise 1mm --uncertain stiffness -o old.json",
                "tells no width"},
        Request{"unknown_twice",
                "identify net.json survey.csv --noise 1mm --uncertain supports:1mm --uncertain "
                "supports:2mm -o old.json",
                "told twice"},
        Request{
            "unknown_of_no_group",
            "identify net.json survey.csv --noise 1mm --uncertain stiffness:5%@ridge -o old.json",
            "net.json: the uncertain parameter 'stiffness:5%@ridge'"},
        Request{
            "unknown_for_balance",
            "identify net.json survey.csv --noise 1mm --method balance --uncertain supports:1mm "
            "-o old.json",
            "for --method map and gp"},
        Request{
            "unknown_to_a_model_without",
            "identify net.json survey.csv --noise 1mm --model model.h5 --uncertain supports:1mm "
            "-o old.json",
            "was trained with the uncertain parameters none"},
        Request{"noise_of_unknown_unit", "identify net.json survey.csv --noise 0.5in -o old.json",
                "'0.5in'"},
        Request{"noise_to_be_estimated_before_a_survey",
                "inspect net.json --survey survey.csv --noise estimate", "--noise estimate"},
        Request{"negative_noise", "identify net.json survey.csv --noise=-1mm -o old.json",
                "'-1mm'"},
        Request{"survey_with_a_node_twice",
                "identify net.json survey_twice.csv --model model.h5 -o old.json",
                "survey_twice.csv:18: "},
        Request{"survey_with_an_unknown_node",
                "identify net.json survey_unknown.csv --model model.h5 -o old.json",
                "survey_unknown.csv:18: 'tower'"},
        Request{"survey_that_is_not_finite",
                "identify net.json survey_nan.csv --model model.h5 -o old.json",
                "survey_nan.csv:17"},
        Request{"law_lost_in_rounding_errors",
                "identify net.json survey.csv --noise 1mm --prior uniform:1e-12mm -o old.json",
                "is lost in rounding errors"},
        Request{"negative_draws", "identify net.json survey.csv --draws=-1 -o old.json",
                "draws is -1, expected 0 to"},
        Request{"draws_beyond_memory",
                "identify net.json survey.csv --draws 1000000000000 -o old.json",
                "as many as the memory holds"},
        Request{"missing_model", "identify net.json survey.csv --model nothing.h5 -o old.json",
                "nothing.h5"},
        Request{"text_for_model", "identify net.json survey.csv --model text -o old.json", "text"},
        Request{"data_for_model", "identify net.json survey.csv --model data.h5 -o old.json",
                "data.h5"},
        Request{"model_of_another_net",
                "identify net.json survey.csv --model other_model.h5 -o old.json",
                hypar(2, 4).fingerprint()},
        Request{"model_of_another_net_and_this",
                "identify net.json survey.csv --model other_model.h5 -o old.json",
                hypar(2, 3).fingerprint()},
        Request{"model_of_another_law",
                "identify net.json survey.csv --model model.h5 --prior uniform:4mm -o old.json",
                "uniform:5mm"},
        Request{"unknown_law", "identify net.json survey.csv --prior gauss:1mm -o old.json",
                "'gauss:1mm'"},
        Request{"unknown_method", "identify net.json survey.csv --method guess -o old.json",
                "--method"},
        Request{"into_no_directory",
                "identify net.json survey.csv --model model.h5 -o nowhere/result.json",
                "nowhere/result.json"},
        Request{"into_a_directory", "identify net.json survey.csv --model model.h5 -o directory",
                "directory"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Report, Refused,
    testing::Values(
        Request{"missing_result", "report nothing.json -o new.html", "nothing.json"},
        Request{"truncated_result", "report truncated_result.json -o new.html",
                "truncated_result.json:1:61"},
        Request{"later_version", "report later_result.json -o new.html",
                "later_result.json:/version: is 2, expected 1"},
        Request{"not_a_number", "report nan_result.json -o new.html", "nan_result.json:1:"},
        Request{"net_for_a_result", "report net.json -o new.html", "net.json:/format"},
        Request{"data_for_a_result", "report data.h5 -o new.html", "is an HDF5 file"},
        Request{"empty_result", "report empty -o new.html", "empty:"},
        Request{"nothing_to_write", "report result.json", "--output"},
        Request{"into_no_directory", "report result.json -o nowhere/report.html", "report"},
        Request{"into_a_directory", "report result.json -o directory", "directory"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Reproduce, Refused,
    testing::Values(
        Request{"no_samples", "reproduce --net net.json --samples 0 -o directory", "0 samples"},
        Request{"negative_samples", "reproduce --net net.json --samples -10 -o directory",
                "-10 samples"},
        Request{"two_samples", "reproduce --net net.json --samples 2 --validation 1 -o directory",
                "2 samples"},
        Request{"as_many_validation_samples",
                "reproduce --net net.json --samples 10 --validation 10 -o directory",
                "10 validation samples of 10"},
        Request{"one_left_to_train_on",
                "reproduce --net net.json --samples 10 --validation 9 -o directory",
                "9 validation samples of 10"},
        Request{"no_validation_samples",
                "reproduce --net net.json --samples 10 --validation 0 -o directory",
                "0 validation samples"},
        Request{"negative_validation_samples",
                "reproduce --net net.json --samples 10 --validation -1 -o directory",
                "-1 validation samples"},
        Request{"unknown_law", "reproduce --net net.json --prior gauss:5mm -o directory",
                "'gauss:5mm'"},
        Request{"negative_bound", "reproduce --net net.json --prior uniform:-5mm -o directory",
                "uniform:-5mm"},
        Request{"bound_beyond_the_shortest_length",
                "reproduce --net net.json --prior uniform:140mm -o directory", "uniform:140mm"},
        Request{"negative_seed", "reproduce --net net.json --seed -1 -o directory", "--seed"},
        Request{"missing_net", "reproduce --net nothing.json -o new", "nothing.json"},
        Request{"truncated_net", "reproduce --net truncated.json -o new", "truncated.json:"},
        Request{"no_output", "reproduce --net net.json", "--output"},
        Request{"empty_output", "reproduce --net net.json -o ''", "is empty"},
        Request{"into_a_file", "reproduce --net net.json -o text", "text"},
        Request{"below_a_file", "reproduce --net net.json -o text/study", "text"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    OverwritingAnInput, Refused,
    testing::Values(
        Request{"by_import", "import net.json -o net.json", "net.json: is an input"},
        Request{"by_import_by_another_name", "import net.json -o ./directory/../net.json",
                "net.json: is an input"},
        Request{"by_import_of_edges", "import nodes.csv --edges nodes_edges.csv -o nodes_edges.csv",
                "nodes_edges.csv: is an input"},
        Request{"by_import_of_supports", "import net.json --supports list.csv -o list.csv",
                "list.csv: is an input"},
        Request{"by_export", "export net.json --to compas -o net.json", "net.json: is an input"},
        Request{"by_export_of_a_form", "export net.json survey.csv --to obj -o survey.csv",
                "survey.csv: is an input"},
        Request{"by_the_second_file_of_export",
                "export net.json nodes_edges.csv --to csv -o nodes.csv",
                "nodes_edges.csv: is an input"},
        Request{"by_form", "form net.json -o net.json", "net.json: is an input"},
        Request{"by_the_lengths_of_form", "form net.json --lengths net.json",
                "net.json: is an input"},
        Request{"by_train", "train data.h5 -o data.h5", "data.h5: is an input"},
        Request{"by_survey", "survey net.json survey.csv -o survey.csv", "survey.csv: is an input"},
        Request{"by_identify", "identify net.json survey.csv --model model.h5 -o model.h5",
                "model.h5: is an input"},
        Request{"by_identify_of_control_points",
                "identify net.json survey.csv --control list.csv -o list.csv",
                "list.csv: is an input"},
        Request{"by_report", "report result.json -o result.json", ""},
        Request{"by_reproduce",
                "reproduce --net study/results.json --samples 10 --validation 2 -o study",
                "results.json: is an input"},
        Request{"with_another_output", "form net.json -o new.csv --lengths ./new.csv",
                "new.csv: is to be written twice"},
        Request{"with_another_output_that_is_there", "form net.json -o old.csv --lengths old.csv",
                "old.csv: is to be written twice"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    NoFileName, Refused,
    testing::Values(Request{"of_import", "import net.json -o ''", "is empty"},
                    Request{"of_export", "export net.json --to obj -o ''", "is empty"},
                    Request{"of_train", "train data.h5 -o ''", "is empty"},
                    Request{"of_survey", "survey net.json survey.csv -o ''", "is empty"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    ImpossibleOutput, Refused,
    testing::Values(
        Request{"of_import", "import net.json -o nowhere/net.json", "nowhere/net.json: cannot"},
        Request{"of_export", "export net.json --to csv -o nowhere/net.csv",
                "nowhere/net.csv: cannot"},
        Request{"of_the_lengths_of_form", "form net.json -o old.csv --lengths nowhere/truth.csv",
                "nowhere/truth.csv: cannot"}),
    name_of);

}  // namespace
