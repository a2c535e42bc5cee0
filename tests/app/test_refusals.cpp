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
#include "support/foreign_nets.hpp"
#include "support/studies.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/files/file.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/form_csv.hpp"
#include "taut/io/lengths_csv.hpp"
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
        {"@reproduce", "reproduce --net net.json -o directory"},
        {"@import", "import mesh.json -o old.json"},
        {"@export", "export net.json -o old.json"},
        {"@plan", "plan net.json found.json -o old.json"},
        {"@targets", "inspect net.json --noise 1mm --survey targets.txt"},
        {"@polar", "survey net.json survey.csv -o old.csv"},
        {"@epoch", "identify net.json survey.csv --noise 1mm -o old.json --epoch"}};
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
        write("short.csv", "id,x,y,z\n" + net.node_id(net.free_nodes()[0]) + ",1,2,3\n");
        CableNetData long_data = net.data();
        long_data.unstressed_lengths *= 1000.0;
        write("long.json", net_to_json(CableNet(std::move(long_data))));
        write("found.json", made_up_identification(net).json);
        write("truth.csv", lengths_to_csv(net, net));
        write("mesh.json", old_compas_mesh().dump());
        std::string targets;
        for (const int node : net.free_nodes()) {
            targets += net.node_id(node) + "\n";
        }
        write("targets.txt", targets.substr(0, targets.rfind('\n', targets.size() - 2) + 1));
        write("supports.txt", net.node_id(net.supports()[0]) + "\n");
        write("words.txt", net.node_id(net.free_nodes()[0]) + "\ntower\n");
        write("far.obj", "v 0 0 9\nv 1 0 9\nv 0 1 9\nf 1 2 3\n");
        write("other_names.csv", "nowhere,0,0,-1\n");
        write("turns.csv", "edge,stroke\n0,0.001\n");
        write("far_turns.csv", "edge,stroke\n0,5\n");
        write("stickers.csv", "sticker,3mm\n");
        write("plucked.csv", read_file(TAUT_TEST_DATA_DIR "/records/plucked.csv"));
        write("forces.csv", "edge,tension\n3,5000\n");
        write("forces_of_another_net.csv", "edge,tension\ncable 9,500\n");
        write("three.txt", "3\n");
        return files();
    }

    void make_data_and_model(const CableNet& net, const std::string& prefix) const {
        const Sampler sampler(net, {}, 1);
        DataSet data = sampler.no_samples();
        sampler.extend_to(data, 8);
        const NetFile file{.net = net, .unknown_keys = "{}"};
        write_data_set(folder() / (prefix + "data.h5"), data, file);
        write_model(folder() / (prefix + "model.h5"),
                    train_model(net, data, {0, 1, 2, 3, 4, 5, 6, 7}), file);
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
# import
empty | import empty -o old.json | empty: is empty
words | import text -o old.json | text:
hdf5 | import data.h5 -o old.json | is an HDF5 file
native_net | import other.json -o old.json | other.json:
csv_without_edges | import nodes.csv -o old.json | --edges
wrong_format | @import --from obj | mesh.json:1:
units | @import --force-unit kN --axial-stiffness 30kN | 15 %
stiffness_word | @import --axial-stiffness stiff | 'stiff'
young_alone | @import --young 205GPa | expected both
unknown_diameter | @import --young 205GPa --diameter size | 'size'
unknown_support | @import --supports words.txt | words.txt:2: 'tower'
unknown_selection | @import --select x | 'x'
edges_of_a_mesh | @import --edges words.txt | --edges
force_unit | @import --force-unit lbf | lbf
loads | @import --loads some | some
# export
missing | export no.json --to obj -o old.json | no.json
to_another_format | @export --to dxf | dxf
to_no_format | @export | --to
of_a_short_form | export net.json short.csv --to obj -o old.json | short.csv
of_a_comparison | export result.json --to net -o old.json | result.json:/format
of_a_comparison_to_excel | export result.json --to xlsx -o old.json | result.json:/
of_a_net_to_excel | @export --to xlsx | net.json:/format
of_a_form_to_excel | export found.json survey.csv --to xlsx -o old.json | FORM and --lengths are for a net
of_a_result_with_lengths | export found.json --lengths truth.csv --to net -o old.json | found.json is a result
with_a_form_for_lengths | @export --lengths survey.csv --to net | survey.csv:1:
with_a_result_for_lengths | @export --lengths found.json --to vtk | found.json: is JSON, expected a CSV file of lengths
with_missing_lengths | @export --lengths nothing.csv --to net | nothing.csv
of_a_net_in_another_unit | export long.json --to obj -o old.json | long.json:
# plan
for_no_group | @plan --tension 1kN..@ridge | --tension names the group 'ridge'
for_no_range | @plan --tension 20% | expected a range
for_no_part_of_a_turn | @plan --turn 5mm --step 1/0 | expected a part of a turn
for_a_step_of_no_turn | @plan --step 1/4 | --turn
for_no_stroke | @plan --total-stroke 0mm | --total-stroke is 0mm, expected more than 0
for_other_weights | @plan --weights up:1 | expected weights
for_no_weight | @plan --weights normal:0,tangential:0 | all weights are 0
for_certainty | @plan --confidence 100% | confidence
for_no_thread | @plan --thread up | --thread
for_no_suggestion | @plan --suggest-adjustable 0 | --suggest-adjustable
for_a_form_in_another_unit | @plan --target survey.csv --target-unit mm | --target-unit
for_a_far_surface | @plan --target far.obj | far.obj: node '
for_tensions_of_no_group | @plan --target-tension 12kN@roof | --target-tension names the group 'roof'
for_a_tolerance_of_length | @plan --target-tension 12kN:5mm | '5mm' is no force
for_missing_tensions | @plan --target-tension missing.csv | 'missing.csv' is no force
for_a_form_beside_no_tension | @plan --form-tolerance 2mm | --form-tolerance weighs the form against
for_other_edges | @plan --adjustable other_names.csv | other_names.csv:1:
for_strokes_of_other_edges | @plan --stroke other_names.csv | other_names.csv:1:
for_loads_of_other_nodes | @plan --check other_names.csv | other_names.csv:1:
for_weights_of_other_nodes | @plan --node-weights other_names.csv | other_names.csv:1:
of_another_net | plan other.json found.json -o old.json | found.json:
of_no_result | plan net.json net.json -o old.json | net.json:/format
of_no_simulated_job | control net.json -o out --trials 0 | trials
of_parts_in_simulated_jobs | control net.json -o out --tension 1%..5% | expected forces
# frequency
of_no_edge | frequency plucked.csv -o old.csv | --edge
over_its_record | frequency plucked.csv --edge 3 -o plucked.csv | plucked.csv
of_an_unknown_edge | frequency plucked.csv --edge none --net net.json | 'none'
in_a_reversed_range | frequency plucked.csv --range 30..2Hz | 30..2Hz
in_no_range | frequency plucked.csv --range 2Hz | 2Hz
at_a_negative_rate | frequency plucked.csv --rate -200 | -200
at_a_rate_beside_times | frequency plucked.csv --rate 200Hz | leave it out
# planned_survey
noise_alone | inspect net.json --noise 1mm | --survey
frame_alone | inspect net.json --frame net | --survey
prior_alone | inspect net.json --prior normal:1mm | --survey
without_noise | inspect net.json --survey targets.txt | targets.txt: holds 5 of 6 free nodes
in_the_frame_of_supports | @targets --frame supports | targets.txt:
with_an_unknown_prior | @targets --prior gauss:1mm | 'gauss:1mm'
of_unknown_nodes | inspect net.json --survey words.txt --noise 1mm | words.txt:2: 'tower'
of_supports | inspect net.json --survey supports.txt --noise 1mm | supports.txt:
# units
of_a_shown_net | inspect long.json | long.json:
of_a_form | form long.json | long.json:
of_samples | sample long.json -n 1 -o old.h5 | long.json:
of_noise_in_metres | survey net.json survey.csv --noise 5 -o old.csv | 5mm
# polar
station_in_plan | @polar --station 1,2 | --station is '1,2', expected a place in m
angle_without_station | @polar --angle 0.3mgon | --angle
noise_beside_a_station | @polar --station 1,-6,1.6 --noise 1mm | --noise
angle_of_coordinates | @no_noise --angle 0.3mgon | survey.csv:
angle_without_unit | @no_noise --angle 0.3 | '0.3'
angle_zero | @no_noise --angle 0gon | --angle is '0gon', expected
range_without_unit | @no_noise --range 1mm+1 | '1mm+1'
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
supports_for_a_frame_missing | identify net.json short.csv --frame supports -o old.json | short.csv: holds 0
survey_of_another_format | @identify --format gsi | survey.csv:1:
survey_of_two_columns | @identify --columns id,x | columns
survey_in_furlongs | @identify --unit furlong | --unit
offset_of_another_kind | @identify --offsets stickers.csv | 'sticker'
offset_without_width | @identify --offset 3mm:x | 'x'
epoch_of_far_turns | @epoch survey.csv:far_turns.csv | far_turns.csv:2:
epoch_of_missing_turns | @epoch survey.csv:none.csv | none.csv
epoch_of_a_missing_survey | @epoch none.csv:turns.csv | none.csv
epoch_of_no_turns | @epoch survey.csv: | --epoch is 'survey.csv:', expected a survey
epoch_turned_by_a_survey | @epoch survey.csv:survey.csv | survey.csv:
negative_noise | @no_noise --noise=-1mm | '-1mm'
noise_to_be_estimated_before_a_survey | inspect net.json --survey survey.csv --noise estimate | --noise estimate
negative_draws | @no_noise --draws=-1 | -1
one_draw | @no_noise --draws 1 | draws is 1, expected 0, or 2 to
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
by_export_of_lengths | export net.json --lengths truth.csv --to net -o truth.csv | truth.csv: is an input
by_identify_of_turns | identify net.json survey.csv --epoch survey.csv:turns.csv -o turns.csv | turns.csv: is an input
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
