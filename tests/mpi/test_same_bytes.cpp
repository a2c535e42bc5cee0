// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against results that depend on how many processes shared the work: other random numbers,
// sums in another order, trials lost or counted twice.

#include <map>

#include "app/program.hpp"

namespace {

using namespace taut::test;
using nlohmann::json;

/// Times and dates, by which two runs may differ.
void remove_times(json& document) {
    if (document.is_object()) {
        for (const std::string key :
             {"seconds", "training_seconds", "median_seconds", "largest_seconds", "date"}) {
            document.erase(key);
        }
    }
    if (document.is_structured()) {
        for (json& value : document) {
            remove_times(value);
        }
    }
}

using Printed = std::pair<std::string, std::string>;

class OverRanks : public ProgramTest, public testing::WithParamInterface<std::string> {
protected:
    OverRanks() { must_run({"taut", "example", "hypar:5x5", "-o", "net.json"}); }

    /// What taut prints and writes into a file, which is removed. It works once for all numbers of
    /// processes.
    [[nodiscard]] const Printed& by_taut(const Words& words, const std::string& file) const {
        static std::map<Words, Printed> known;
        const Words key = joined(words, {file});
        const auto found = known.find(key);
        return found != known.end() ? found->second
                                    : known.emplace(key, by("taut", words, file)).first->second;
    }
    [[nodiscard]] Printed by_ranks(const Words& words, const std::string& file) const {
        return by(GetParam(), words, file);
    }

    void expect_same_json(const Words& words, const std::string& file) const {
        json expected = json::parse(by_taut(words, file).second);
        json found = json::parse(by_ranks(words, file).second);
        remove_times(expected);
        remove_times(found);
        EXPECT_EQ(found, expected);
    }

private:
    [[nodiscard]] Printed by(const std::string& who, const Words& words,
                             const std::string& file) const {
        const Outcome outcome = run(joined({who}, words));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        Printed result{outcome.out, read(file)};
        std::filesystem::remove(folder() / file);
        return result;
    }
};

TEST_P(OverRanks, SampleGivesTheSameDataSetAndPrintsTheSame) {
    for (const Words& words :
         {Words{"sample", "net.json", "-n", "150", "-o", "data.h5"},
          Words{"sample", "net.json", "-n", "5", "-o", "data.h5", "--seed", "7", "--prior",
                "normal:2mm", "--uncertain", "supports:2mm", "--json"}}) {
        EXPECT_EQ(by_ranks(words, "data.h5"), by_taut(words, "data.h5"));
    }
    EXPECT_EQ(files().size(), 1U) << "the net alone";
}

TEST_P(OverRanks, SampleExtendsADataSetOfTautToTheSameBytes) {
    must_run({"taut", "sample", "net.json", "-n", "41", "-o", "data.h5"});
    const Words words{"sample", "net.json", "-n", "97", "-o", "data.h5", "--resume"};
    const std::string found = by_ranks(words, "data.h5").second;
    EXPECT_EQ(found == by_taut(words, "data.h5").second, true);
}

TEST_P(OverRanks, TrainGivesTheSameModel) {
    must_run({"taut", "sample", "net.json", "-n", "70", "-o", "data.h5"});
    const Words words{"train", "data.h5", "-o", "model.h5"};
    EXPECT_EQ(by_ranks(words, "model.h5").second == by_taut(words, "model.h5").second, true);
    const Words scaled{"train", "data.h5", "-o", "model.h5", "--kernel", "direction"};
    EXPECT_EQ(by_ranks(scaled, "model.h5").second == by_taut(scaled, "model.h5").second, true);
}

TEST_P(OverRanks, CompareGivesTheSameNumbers) {
    expect_same_json(
        {"compare", "net.json", "-o", "out", "--noise", "0.5mm", "--training", "20", "--hidden",
         "0,25%", "--surveys", "5", "--uncertain", "supports:2mm", "--epochs", "2"},
        "out/comparison.json");
}

TEST_P(OverRanks, ControlGivesTheSameNumbers) {
    const Words words{"control",  "net.json", "-o",      "out", "--trials",  "3",
                      "--rounds", "1",        "--draws", "40",  "--tension", "0.1kN..100kN"};
    expect_same_json(words, "out/control.json");
    EXPECT_EQ(by_ranks(words, "out/control.csv"), by_taut(words, "out/control.csv"));
}

INSTANTIATE_TEST_SUITE_P(Processes, OverRanks, testing::Values("2", "3"),
                         [](const auto& processes) { return processes.param; });

}  // namespace
