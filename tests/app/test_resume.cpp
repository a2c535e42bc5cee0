// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a data set composed of two that do not belong together, and against samples drawn
// again.

#include "app/program.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/sampling/sampler.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using nlohmann::json;

class Resume : public ProgramTest {
protected:
    Resume() { must_run({"example", "hypar:2x3", "-o", "net.json"}); }

    void sample(const std::string& count, const std::string& file,
                const std::string& extra = "--quiet") const {
        must_run({"sample", "net.json", "-n", count, "-o", file, extra});
    }

    /// Samples as an interrupted run leaves them.
    void write_partial(int count, const CableNet& net = hypar(2, 3), const LengthPrior& prior = {},
                       std::uint64_t seed = 1) const {
        const Sampler sampler(net, prior, seed);
        DataSet data = sampler.no_samples();
        sampler.extend_to(data, count);
        write_data_set(folder() / "data.h5.partial", data, {.net = net, .unknown_keys = "{}"});
    }

    void expect_refused(const std::string& text) const {
        const Files before = files();
        expect_error(run({"sample", "net.json", "-n", "40", "-o", "data.h5", "--resume"}), 2, text);
        EXPECT_EQ(files(), before);
    }
};

TEST_F(Resume, ExtendsAFinishedDataSetToTheSameBytes) {
    sample("20", "data.h5");
    sample("50", "data.h5", "--resume");
    sample("50", "straight.h5");
    EXPECT_EQ(read("data.h5"), read("straight.h5"));
    sample("50", "data.h5", "--resume");
    EXPECT_EQ(read("data.h5"), read("straight.h5"));
}

TEST_F(Resume, BeginsWhereThereIsNothingYet) {
    sample("20", "data.h5", "--resume");
    sample("20", "straight.h5");
    EXPECT_EQ(read("data.h5"), read("straight.h5"));
}

TEST_F(Resume, TakesTheLargerOfTheFinishedAndTheUnfinishedDataSet) {
    const auto resumed_from = [this](const std::string& count) {
        return json::parse(must_run({"sample", "net.json", "-n", count, "-o", "data.h5", "--resume",
                                     "--json"}))["resumed_from"];
    };
    sample("20", "data.h5");
    write_partial(35);
    EXPECT_EQ(resumed_from("40"), 35);
    write_partial(10);
    EXPECT_EQ(resumed_from("50"), 40);
    EXPECT_FALSE(exists("data.h5.partial"));
    sample("50", "straight.h5");
    EXPECT_EQ(read("data.h5"), read("straight.h5"));
}

TEST_F(Resume, IsNotDoneUnlessAskedForAndTheInterruptedRunIsKept) {
    write_partial(10);
    const Files before = files();
    expect_error(run({"sample", "net.json", "-n", "12", "-o", "data.h5"}), 2,
                 "data.h5.partial: holds the samples of an interrupted run");
    EXPECT_EQ(files(), before);
}

TEST_F(Resume, RefusesADataSetOfOtherSettingsOrNone) {
    write_partial(10, hypar(2, 4));
    expect_refused("data.h5.partial: was made with net " + hypar(2, 4).fingerprint() +
                   ", expected " + hypar(2, 3).fingerprint());
    write_partial(10, hypar(2, 3), {LengthPrior::Kind::uniform, 0.004});
    expect_refused("prior uniform:4mm, expected uniform:5mm");
    write_partial(10, hypar(2, 3), {}, 2);
    expect_refused("seed 2, expected 1");
    write_partial(41);
    expect_refused("41 samples");
    write("data.h5.partial", read("data.h5.partial").substr(0, 3000));
    expect_refused("data.h5.partial: ");
    write("data.h5.partial", "id,x,y,z\n");
    expect_refused("data.h5.partial: ");
    std::filesystem::remove(folder() / "data.h5.partial");
    must_run({"example", "hypar:2x4", "-o", "other.json"});
    must_run({"sample", "other.json", "-n", "5", "-o", "data.h5"});
    expect_refused("data.h5: was made with net ");
}

}  // namespace
