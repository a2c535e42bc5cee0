// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards that what is no survey of the net is refused in one line that says what was expected and
// what was found, and nothing is written.

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/program.hpp"

namespace {

using namespace taut::test;

class WrongSurveys : public ProgramTest {
protected:
    WrongSurveys() { must_run({"example", "hypar:4x5", "-o", "net.json"}); }

    static std::string sound(const std::string& name) {
        std::ifstream file(std::filesystem::path(TAUT_TEST_DATA_DIR) / "surveys" / name,
                           std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// own.csv with other coordinates.
    /// @param change gives the line of a point of its number in the file
    template <class Change>
    static std::string changed(const std::string& header, const Change& change) {
        std::istringstream lines(sound("own.csv"));
        std::string text = header;
        std::string line;
        std::getline(lines, line);
        for (int i = 0; std::getline(lines, line); ++i) {
            std::istringstream fields(line);
            std::string id;
            std::getline(fields, id, ',');
            double p[3];
            for (double& x : p) {
                std::string field;
                std::getline(fields, field, ',');
                x = std::stod(field);
            }
            text += change(i, id, p[0], p[1], p[2]) + "\n";
        }
        return text;
    }

    void expect_refused(const std::string& name, const std::string& content,
                        const std::string& message, std::vector<std::string> options = {}) {
        write(name, content);
        const Files before = files();
        options.insert(options.begin(),
                       {"identify", "net.json", name, "--noise", "0.2mm", "-o", "result.json"});
        const Outcome outcome = run(options);
        expect_error(outcome, 2, name + ":");
        EXPECT_THAT(outcome.err, testing::HasSubstr(message));
        EXPECT_EQ(files(), before) << name;
    }
};

TEST_F(WrongSurveys, OfTwoPointsOfOneName) {
    const std::string header = "Punkt;X [m];Y [m];Z [m]\n";
    const auto twice = [](int i, const std::string& id, double x, double y, double z) {
        const std::string line = fmt::format("{};{};{};{}", id, x, y, z);
        return i == 9 ? line + fmt::format("\n{};{};{};{}", id, x, y, z + 0.1) : line;
    };
    expect_refused("twice.csv", changed(header, twice),
                   ":12: surveys '9' a second time, 100 mm from where line 11 has it, expected at "
                   "most 20 mm: are these two points?");
}

TEST_F(WrongSurveys, WithoutAPointNearAnyNode) {
    const auto far = [](int, const std::string&, double x, double y, double z) {
        return fmt::format(",{},{},{}", x + 500.0, y - 90.0, z);
    };
    expect_refused("far.csv", changed("", far),
                   ": 0 of 38 targets without a name lie on a node beyond doubt, expected at least "
                   "half");
    const auto named = [](int, const std::string& id, double x, double y, double z) {
        return fmt::format("{},{},{},{}", id, x + 500.0, y - 90.0, z);
    };
    expect_refused("named.csv", changed("", named), "it is in another frame",
                   {"--frame", "net", "--match", "name"});
}

TEST_F(WrongSurveys, OfAnotherFormatThanTheirNameSays) {
    expect_refused(
        "a.gsi", sound("landxml.xml"),
        ": is a LandXML file, expected a Leica GSI file by the end of its name: --format "
        "landxml reads it as what it is");
    expect_refused("a.dxf", sound("own.csv"), ": is a table of points, expected a DXF file");
    expect_refused("a.csv", sound("jobxml.jxl"), ": is a Trimble JobXML file, expected a table");
    expect_refused("b.csv", "PK\x03\x04 of a spreadsheet",
                   ": is a ZIP archive, as spreadsheets (xlsx, ods) are: save the table as CSV");
    expect_refused("c.csv", "{\"format\": \"taut-net\"}", ": is JSON, expected a survey");
    expect_refused("d.csv", "Sehr geehrte Damen und Herren,\nanbei das Aufmass.\n",
                   ": holds no point, expected lines of a name and three coordinates");
}

TEST_F(WrongSurveys, ThatAreCut) {
    const auto half = [](const std::string& name) {
        const std::string whole = sound(name);
        // In the middle of a number.
        return whole.substr(0, whole.find_last_of("0123456789", whole.size() / 2 + 12));
    };
    expect_refused("cut.gsi", half("gsi16.gsi"), "is the file whole?");
    expect_refused("cut.xml", half("landxml.xml"), "is the file whole?");
    expect_refused("cut.jxl", half("jobxml.jxl"), "is the file whole?");
    expect_refused("gama.xml", half("gama.xml"), "is the file whole?");
    expect_refused("cut.dxf", half("drawing.dxf"), "is it whole?");
    expect_refused("cut.pts", half("scan.pts"), "is the file whole?");
    const std::string points = sound("scan.pts");
    expect_refused("short.pts", points.substr(0, points.find('\n', points.size() / 2) + 1),
                   "points, expected 38 as its first line says");
    const std::string table = sound("german.csv");
    expect_refused("cut.csv", table.substr(0, table.find(';', table.size() / 2) + 4),
                   "is the file whole?");
    expect_refused("cut.txt", sound("english.txt").substr(0, 1001), "is the file whole?");
}

TEST_F(WrongSurveys, InTwoUnits) {
    const auto mixed = [](int i, const std::string& id, double x, double y, double z) {
        const double k = i < 20 ? 1.0 : 1e3;
        return fmt::format("{},{},{},{}", id, k * x, k * y, k * z);
    };
    expect_refused("mixed.csv", changed("id,x,y,z\n", mixed),
                   "fit it in two units: expected one for all");
    expect_refused("titles.csv", "Punkt;X [m];Y [mm];Z [m]\n1;2;3;4\n",
                   ":1: tells two units of coordinates, expected one for all");
}

TEST_F(WrongSurveys, ThatAreMirroredOrOfAnotherScale) {
    const auto north_first = [](int, const std::string& id, double x, double y, double z) {
        return fmt::format("{},{},{},{}", id, y, x, z);
    };
    expect_refused("north.csv", changed("", north_first),
                   "the survey is mirrored: its x and y are exchanged");
    // As it says:
    write("north.csv", changed("id,y,x,z\n", north_first));
    EXPECT_EQ(run({"identify", "net.json", "north.csv", "--noise", "0.2mm", "--columns", "id,y,x,z",
                   "--draws", "0", "--prior", "uniform:2mm"})
                  .exit_code,
              0);
    const auto inches = [](int, const std::string& id, double x, double y, double z) {
        return fmt::format("{},{},{},{}", id, x / 0.0254, y / 0.0254, z / 0.0254);
    };
    expect_refused("inches.csv", changed("", inches),
                   "its coordinates are in inches, not in metres: --unit in tells it");
    const auto grid = [](int, const std::string& id, double x, double y, double z) {
        return fmt::format("{},{},{},{}", id, 1.03 * x, 1.03 * y, 1.03 * z);
    };
    expect_refused("grid.csv", changed("", grid), "its points are 1.03 times as far apart");
}

}  // namespace
