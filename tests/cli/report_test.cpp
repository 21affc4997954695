// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Design tables, comparisons and reports as a user makes them. The design table must
// agree with the tables of bolts and forces to every digit.
#include "tests/cli/command_line_fixture.h"

#include "solver/files/run_store/build_id.h"
#include "solver/files/sha256.h"
#include "solver/verify/verification_record.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace keyblock::test {
namespace {

/// A table without quoted cells, row by row, by the names of its columns.
using CsvTable = std::vector<std::map<std::string, std::string>>;

std::vector<std::string> csvCells(const std::string& line) {
    std::vector<std::string> list;
    std::istringstream in(line + ",");
    for (std::string cell; std::getline(in, cell, ',');) list.push_back(cell);
    return list;
}

/// A block of 26.5 kN hangs on a bolt through a fixed block above it; with a weaker steel it falls.
std::string hangingScene(const std::string& yield) {
    return R"({ "format": "keyblock-scene", "version": 1, "title": "A block hangs on a bolt",
  "analysis": { "gravity": [0, -9.81] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 10e9, "poissons_ratio": 0.2 } },
  "joint_materials": { "joint": { "friction_angle": 30 } },
  "blocks": [
    { "name": "roof",  "points": [[0,1],[1,1],[1,2],[0,2]], "material": "rock" },
    { "name": "stone", "points": [[0,0],[1,0],[1,1],[0,1]], "material": "rock" } ],
  "supports": [ { "block_at": [0.5,1.5], "fix": "all" } ],
  "bolt_types": { "bar": { "class": "CMC", "diameter": 0.02, "steel": [[0,0],[0.001,)" +
           yield + R"(],[0.01,)" + yield + R"(]],
      "anchors": [ { "from": 0, "to": "head", "per": "length", "law": "elastic", "stiffness": 1e9 } ] } },
  "bolts": [ { "name": "B", "type": "bar", "far_end": [0.5,1.8], "head": [0.5,0.2], "divisions": 8, "plate": "none" } ],
  "stages": [ { "name": "hang", "kind": "static" } ] })";
}

class Reports : public CommandLine {
protected:
    CsvTable tableOf(const std::string& run, const std::string& name) const {
        const std::vector<std::string> rows = lines(table(run, name));
        const std::vector<std::string> names = csvCells(rows.at(0));
        CsvTable result;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const std::vector<std::string> values = csvCells(rows[i]);
            result.emplace_back();
            for (std::size_t c = 0; c < names.size(); ++c) result.back()[names[c]] = values.at(c);
        }
        return result;
    }
    void runHanging(const std::string& name, const std::string& yield) const {
        put(name + ".json", hangingScene(yield));
        const Ended ended = keyblock({"run", name + ".json", "--progress", "none"});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
};

/// The cell of largest magnitude in a column, without the last row, which is that of the face plate.
std::string largestCell(const CsvTable& rows, const std::string& column, bool withLast) {
    std::string largest = "0";
    for (std::size_t i = 0; i + (withLast ? 0 : 1) < rows.size(); ++i)
        if (std::abs(std::stod(rows[i].at(column))) > std::abs(std::stod(largest))) largest = rows[i].at(column);
    return largest;
}

TEST_F(Reports, DesignTableAgreesWithTheOtherTables) {
    runHanging("strong", "400e6");
    const CsvTable design = tableOf("strong.kbrun", "design");
    ASSERT_EQ(design.size(), 1U);
    const CsvTable bolts = tableOf("strong.kbrun", "bolts");
    EXPECT_EQ(design[0].at("axial_force_N"), largestCell(bolts, "axial_force_N", false));
    EXPECT_EQ(design[0].at("shear_force_N"), largestCell(bolts, "shear_force_N", false));
    EXPECT_EQ(design[0].at("moment_Nm"), largestCell(bolts, "moment_Nm", true));
    EXPECT_EQ(design[0].at("plate_normal_force_N"), bolts.back().at("axial_force_N"));
    EXPECT_EQ(design[0].at("status"), "intact");
    EXPECT_EQ(design[0].at("carries"), "stone");
    double fx = 0.0, fy = 0.0;
    std::string weight;
    for (const auto& row : tableOf("strong.kbrun", "forces")) {
        if (row.at("block") != "stone") continue;
        if (row.at("source") == "weight") weight = row.at("fy_N");
        if (row.at("source") == "bolt") fx += std::stod(row.at("fx_N")), fy += std::stod(row.at("fy_N"));
    }
    EXPECT_EQ("-" + design[0].at("carried_weight_N"), weight);
    EXPECT_EQ(std::stod(design[0].at("carrying_force_N")), fy);
    EXPECT_NEAR(fy, 2700.0 * 9.81, 1.0);
    EXPECT_NEAR(std::stod(design[0].at("yield_use")), fy / (400e6 * 1e-4 * std::acos(-1.0)), 1e-3);
}

TEST_F(Reports, CompareNamesTheBoltThatHolds) {
    runHanging("strong", "400e6");
    runHanging("weak", "40e6");  // 12.6 kN
    const Ended text = keyblock({"compare", "strong.kbrun", "weak.kbrun"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_NE(text.out.find("A: bolt B holds stone (26.49 kN)\n"), std::string::npos) << text.out;
    const auto json = nlohmann::json::parse(keyblock({"compare", "weak.kbrun", "strong.kbrun", "--json"}).out);
    EXPECT_EQ(json["blocks"]["shared"], 2);
    ASSERT_EQ(json["saved"].size(), 1U);
    EXPECT_EQ(json["saved"][0]["falls_in"], "a");
    EXPECT_EQ(json["saved"][0]["block"], "stone");
    EXPECT_EQ(json["saved"][0]["held_by"][0]["bolt"], "B");
    EXPECT_NEAR(json["saved"][0]["held_by"][0]["force_N"].get<double>(), 2700.0 * 9.81, 1.0);
    EXPECT_TRUE(json["bolts"][0]["a"].is_object() && json["bolts"][0]["b"].is_object());
}

#ifdef KEYBLOCK_HAS_FIGURES

TEST_F(Reports, AsHtmlStateTheirInputsAndTheVerification) {
    runHanging("strong", "400e6");
    const std::map<std::string, std::string> home{{"XDG_DATA_HOME", (folder() / "data").string()}};
    const auto report = [&](const std::string& file, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"report", "strong.kbrun", "--out", file});
        return keyblock(more, home);
    };
    Ended ended = report("r.html", {"--project", "Drift 3's", "--date", "1 May"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
    const std::string html = content("r.html");
    EXPECT_NE(html.find("<p>Not verified on this installation."), std::string::npos);
    EXPECT_NE(html.find(sha256(content("strong.kbrun"))), std::string::npos);
    EXPECT_NE(
        html.find("keyblock report strong.kbrun --out r.html --project &#39;Drift 3&#39;\\&#39;&#39;s&#39; --date"),
        std::string::npos);
    EXPECT_EQ(report("r.html").code, 2);  // exists
    EXPECT_EQ(content("r.html"), html);
    const VerificationRecord record{std::string(buildId()), "0.1.0", "2026-01-31", 64, 212, 0};
    writeVerificationRecord(record, folder() / "data/keyblock/verification.json");
    EXPECT_EQ(report("r.html", {"--overwrite"}).code, 0);
    EXPECT_NE(content("r.html").find("<p>Verified on this installation on 2026-01-31"), std::string::npos);
}

TEST_F(Reports, AsPdfHaveTheSameBytesInEveryProcess) {
    runHanging("strong", "400e6");
    put("ours.txt", "title Ours\nlogo logo.svg\n[summary]\n[bolts]\n[text: End]\nNo more.\n");
    put("logo.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 2"><rect width="4" height="2"/></svg>)");
    const auto report = [&](const std::string& layout) {
        return keyblock({"report", "strong.kbrun", "--out", "r.pdf", "--template", layout, "--overwrite"});
    };
    Ended ended = report("ours.txt");
    EXPECT_EQ(ended.code, 0) << ended.err;
    const std::string pdf = content("r.pdf");
    EXPECT_TRUE(pdf.starts_with("%PDF"));
    EXPECT_EQ(report("ours.txt").code, 0);
    EXPECT_EQ(content("r.pdf"), pdf);
    put("wrong.txt", "[summary]\n[bolts of ours]\n");
    ended = report("wrong.txt");
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("wrong.txt: line 2: there is no section 'bolts of ours'"), std::string::npos) << ended.err;
    put("logo.svg", "no picture");
    EXPECT_EQ(report("ours.txt").code, 3);
    EXPECT_EQ(keyblock({"report", "strong.kbrun", "--out", "r.txt"}).code, 2);
    EXPECT_EQ(keyblock({"report", "strong.kbrun", "--out", "ours.txt.pdf", "--template", "missing.txt"}).code, 3);
    EXPECT_EQ(content("r.pdf"), pdf);
}

/// Of a study of a slope whose friction angle varies: statistics in place of sections.
TEST_F(Reports, OfAStudyShowItsStatistics) {
    put("scene.json", contentOf(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / "bolted-incline.json"));
    put("study.json", R"({ "format": "keyblock-study", "version": 1, "title": "A <slope>", "scene": "scene.json",
  "plan": { "cases": 12 },
  "parameters": [ { "name": "friction", "path": "joint_materials.joint.friction_angle",
                    "distribution": { "kind": "normal", "mean": 36, "deviation": 3 } } ],
  "quantities": [ "max key.u" ], "fails": "not stands" })");
    ASSERT_EQ(keyblock({"sweep", "plan", "study.json", "--out", "s"}).code, 0);
    ASSERT_EQ(keyblock({"sweep", "run", "s", "--index", "1-12"}).code, 0);
    ASSERT_EQ(keyblock({"sweep", "collect", "s"}).code, 0);
    for (const std::string file : {"s.html", "s.pdf"}) {
        const Ended ended = keyblock({"report", "s", "--out", file});
        EXPECT_EQ(ended.code, 0) << ended.err;
    }
    const std::string html = content("s.html");
    EXPECT_NE(html.find("<h1>A &lt;slope&gt;</h1>"), std::string::npos);
    EXPECT_NE(html.find("The probability of failure is "), std::string::npos);
    EXPECT_NE(html.find("normal, mean 36, deviation 3"), std::string::npos);
    EXPECT_NE(html.find("Convergence.</figcaption>"), std::string::npos);
    EXPECT_NE(html.find(sha256(content("s/study.json"))), std::string::npos);
    put("run.txt", "[bolts]\n");
    const Ended ended = keyblock({"report", "s", "--out", "t.pdf", "--template", "run.txt"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("'bolts' applies to runs only"), std::string::npos) << ended.err;
}

#else

TEST_F(Reports, AreNotMadeWithoutFigures) {
    const Ended ended = keyblock({"report", "strong.kbrun", "--out", "r.html"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("built without figures"), std::string::npos) << ended.err;
}

#endif

}  // namespace
}  // namespace keyblock::test
