// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Malformed and odd drawings and lists, as they come from other programs: each in a
// small file, with what has to be reported of it. Nothing may be left out in silence.
#include "solver/files/drawing/csv_list.h"
#include "solver/files/drawing/dxf_file.h"
#include "solver/files/drawing/section_import.h"

#include "solver/files/csv/csv_rows.h"
#include "solver/files/read_error.h"
#include "solver/files/scene/reference_file.h"
#include "tests/scratch_folder.h"
#include "tests/solver/files/drawing/drawing_text.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cmath>

#include <filesystem>
#include <set>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

const fs::path folder = KEYBLOCK_TEST_DATA_DIR "/import";

struct Odd {
    std::string file;
    bool scene = false;  // whether one comes out
    std::vector<std::string> reports;
};

/// Everything that an import says, a line each.
std::string allOf(const Import& import) {
    std::string text = "units " + import.unit + '\n';
    for (const ImportedLayer& layer : import.layers)
        text += "layer " + layer.name + ": " + (layer.known ? std::string(wordOf(layer.role)) : "?") + ", " +
                layer.source + '\n';
    for (const ImportRow& row : import.rows)
        text += std::to_string(row.count) + " " + row.kind + " on " + row.layer + ": " + row.became + '\n';
    for (const NotTaken& item : import.notTaken)
        text += item.kind + " line " + std::to_string(item.place.line) + " handle " + item.place.handle + ": " +
                item.why + '\n';
    for (const Problem& problem : import.problems) text += oneLine(problem) + '\n';
    for (const std::string& assumed : import.assumed) text += "assumed: " + assumed + '\n';
    if (import.cut) text += "blocks " + std::to_string(import.cut->blocks) + '\n';
    return text;
}

const std::vector<Odd> oddFiles{
    {"empty.dxf", false, {"the file is empty"}},
    {"binary.dxf", false, {"binary DXF"}},
    {"drawing-as-dwg.dxf", false, {"DWG"}},
    {"utf-16.dxf", false, {"zero bytes"}},
    {"wrong-code.dxf", false, {"wrong-code.dxf:41: error: a group code is expected here, not 'LINE'"}},
    {"truncated.dxf", false, {"truncated.dxf:52: error: the file ends in the middle of a section"}},
    {"missing-endsec.dxf", true, {"missing-endsec.dxf:2: warning: the section 'HEADER' has no ENDSEC",
     "1 LINE on joints: joint"}},
    {"without-eof.dxf", true, {"warning: the file ends without EOF"}},
    {"after-eof.dxf", true, {"after-eof.dxf:59: warning: there are lines after EOF"}},
    {"not-a-number.dxf", true, {"LINE line 56 handle 2A: its value for code 20 in line 64 is 'nan'",
     "1 LINE on joints: skipped"}},
    {"decimal-comma.dxf", true, {"is '1,5', which is not a usable number"}},
    {"huge-numbers.dxf", true, {"line 64 is '1e300'", "line 78 is '1e999'", "2 LINE on joints: skipped"}},
    {"zero-length.dxf", true, {"LINE line 56 handle 2A: it has no length"}},
    {"duplicates.dxf", true, {"LINE line 56 handle 2A: it repeats the entity in line 42",
     "LINE line 70 handle 2B: it repeats the entity in line 42", "1 LINE on joints: joint"}},
    {"unknown-entities.dxf", true, {"ACAD_PROXY_ENTITY line 56 handle 3A: entities of this kind",
     "3DSOLID line 64 handle 3B", "HATCH line 72 handle 3C"}},
    {"spline-without-points.dxf", true, {"SPLINE line 56 handle 4A: it has 0 of the 4 control points"}},
    {"spline-fit-points.dxf", true, {"SPLINE (straight between its fit points) on joints: joint", "blocks 2"}},
    {"spline-counts-lie.dxf", true, {"SPLINE line 56 handle 4A: it has 1 of the 4 control points"}},
    {"polyline-count-lies.dxf", true, {"1 LWPOLYLINE on boundary: boundary of the domain", "blocks 2"}},
    {"half-circle-bulge.dxf", true, {"1 LWPOLYLINE on tunnel: outline of a tunnel"}},
    {"old-polyline.dxf", true, {"1 POLYLINE on tunnel: outline of a tunnel"}},
    {"polyline-without-seqend.dxf", true, {"dxf:42: warning: the POLYLINE has no SEQEND",
     "1 POLYLINE on joints: joint"}},
    {"nested-inserts.dxf", true, {"1 INSERT on joints: block 'Pair', inserted",
     "2 INSERT in block 'Pair' on joints: block 'PIN'", "2 LINE in block 'PIN' on joints: joint"}},
    {"insert-of-itself.dxf", true, {"INSERT in block 'B' line 46 handle 6E: the block 'A' would be inserted into itself"}},
    {"insert-of-nothing.dxf", true, {"INSERT line 56 handle 6C: there is no block 'ghost'"}},
    {"inserts-without-end.dxf", false, {"the number of blocks and entities exceeds 200000"}},
    {"unused-block.dxf", true, {"dxf:16: note: the block 'PIN' is never inserted; entities in it: 1"}},
    {"frozen-layer.dxf", true, {"layer joints-old: ignore, frozen or off", "layer joints-off: ignore, frozen or off",
     "1 LINE on joints-old: ignored"}},
    {"on-a-sheet.dxf", true, {"LINE line 56 handle 2A: it is drawn in paper space",
     "LINE line 72 handle 2A: it is invisible"}},
    {"heights.dxf", true, {"dxf:42: warning: heights z of up to 12.5 were ignored", "1 LINE on joints: joint"}},
    {"tilted-plane.dxf", true, {"ARC line 56 handle 7A: it is drawn on an inclined plane"}},
    {"seen-from-behind.dxf", true, {"1 CIRCLE on tunnel: round tunnel"}},
    {"layer-in-code-page.dxf", false, {"do not show their role", "'Klüfte', 'Störung'", "--role LAYER="}},
    {"unitless.dxf", false, {"does not specify its units", "Give --units"}},
    {"unitless-old.dxf", false, {"does not specify its units", "Give --units"}},
    {"feet.dxf", true, {"units ft (from the file)"}},
    {"open-boundary.dxf", false,
     {"dxf:16: error: the LWPOLYLINE on layer 'boundary' from (0, 0) to (0, 10) does not close an outline"}},
    {"boundary-of-lines.dxf", true, {"3 LINE on boundary: boundary of the domain", "1 ARC on boundary: boundary"}},
    {"two-boundaries.dxf", false, {"dxf:42: error: the boundary has 2 outlines"}},
    {"boundary-crosses-itself.dxf", false, {"dxf:16: error: /domain/boundary: the outline crosses itself"}},
    {"layers-that-say-nothing.dxf", false, {"do not show their role", "'0', 'Layer1'", "layer 0: ?, not known"}},
    {"all-ignored.dxf", false, {"every layer with lines is ignored", "1 LINE on grid: ignored"}},
    {"only-text.dxf", false, {"contains no line that can be imported", "TEXT line 16 handle 9A: text is not geometry",
     "POINT line 30 handle 9B: a point"}},
    {"lacks-a-code.dxf", true, {"LINE line 56 handle AA: it has no code 21", "CIRCLE line 68 handle AB: its radius",
     "LWPOLYLINE line 80 handle AC: it has 2 x and 1 y"}},
    {"bent-bolt.dxf", true, {"LWPOLYLINE line 42 handle 1F: a bolt must be a straight line", "1 LINE on bolts: bolt"}},
    {"bolt-outside.dxf", false, {"dxf:42: error: /bolts/0: the bolt does not run through any block"}},
    {"far-away.dxf", true, {"blocks 2"}},
    {"stray-parts.dxf", true, {"dxf:2: warning: 'LINE' is outside every section",
     "VERTEX line 62 handle BA: it is outside", "SEQEND line 72 handle BB"}},
    {"old-mac.dxf", true, {"1 LINE on joints: joint"}},
    {"windows.dxf", true, {"1 LINE on joints: joint", "layer joints: joint, guessed from its name"}},
    {"semicolons.csv", true, {"2 joint on semicolons: joint"}},
    {"tabs.csv", true, {"2 joint on tabs: joint"}},
    {"quotes-bom-crlf.csv", true, {"2 joint", "joint material 'clay' has the friction of 'assumed-joint'"}},
    {"any-order.csv", true, {"column 2 ('remark') is not used", "1 joint", "widened if it was flat"}},
    {"points.csv", true, {"2 joint on points: joint"}},
    {"bolts.csv", true, {"2 bolt on bolts: bolt", "type 'assumed-bolt'"}},
    {"bolt-directions.csv", true, {"2 bolt on bolt-directions: bolt"}},
    {"latin-1.csv", true, {"1 joint"}},
    {"not-a-number.csv", false, {"csv:3: error: column 2 ('y1_m') holds 'zero'",
     "csv:4: error: column 2 ('y1_m') holds ''", "csv:5: error: column 2 ('y1_m') holds 'inf'"}},
    {"a-cell-too-many.csv", false, {"csv:3: error: the row has 5 cells, and the header 4"}},
    {"mixed-decimals.csv", false, {"csv:3: error: column 3 ('x2_m') has a decimal point, and line 2 has a comma"}},
    {"thousands.csv", false, {"csv:2: error: column 1 ('x1_m') holds '1.000,5'",
     "csv:3: error: column 1 ('x1_m') holds '1,000,5'"}},
    {"without-units.csv", false, {"csv:1: error: column 1 ('x1') has no unit", "--units"}},
    {"unknown-unit.csv", false, {"csv:1: error: column 1 ('x1 [cubit]'): its unit 'cubit'"}},
    {"unknown-header.csv", false, {"csv:1: error: the header has columns of neither joints nor bolts"}},
    {"column-twice.csv", false, {"csv:1: error: column 5 ('x_start_m') means the same as column 1"}},
    {"quote-never-closed.csv", false, {"csv:3: error: a quote is opened here but never closed"}},
    {"same-ends.csv", false, {"csv:3: error: both ends are the same point"}},
    {"joint-in-two-parts.csv", false, {"csv:6: error: the joint 'A' continues here"}},
    {"one-point.csv", false, {"csv:2: error: the joint 'A' has a single point"}},
    {"header-alone.csv", false, {"csv:1: error: there are no rows under the header"}},
    {"empty.csv", false, {"the file is empty"}}};

TEST(ImportFiles, OddFilesAreReported) {
    for (const Odd& odd : oddFiles) {
        const Import import = importFile(folder / odd.file, {});
        const std::string text = allOf(import);
        EXPECT_EQ(import.scene.has_value(), odd.scene) << odd.file << '\n' << text;
        for (const std::string& part : odd.reports)
            EXPECT_NE(text.find(part), std::string::npos) << odd.file << " does not say: " << part << '\n' << text;
        for (const Problem& problem : import.problems)
            EXPECT_FALSE(problem.severity == Severity::Error && problem.remedy.empty()) << oneLine(problem);
    }
}

TEST(ImportFiles, EveryFileOfTheFolderIsInTheTable) {
    std::set<std::string> listed;
    for (const Odd& odd : oddFiles) listed.insert(odd.file);
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_TRUE(listed.contains(entry.path().filename().string())) << entry.path();
}

Scene sceneOf(const std::string& file, const ImportSettings& settings = {}) {
    const Import import = importFile(folder / file, settings);
    EXPECT_TRUE(import.scene) << file << '\n' << allOf(import);
    return import.scene.value_or(Scene{});
}

using Points = std::vector<Point>;

TEST(ImportFiles, CoordinatesFarAwayAreExact) {
    const Scene scene = sceneOf("far-away.dxf");
    EXPECT_EQ(scene.joints[0].points, (Points{{1000000.125, 2000005.3}, {1000010.125, 2000005.7}}));
    EXPECT_EQ(scene.domain->boundary[2], Point(1000010.125, 2000010.0625));
}

TEST(ImportFiles, UnitsAreThoseOfTheFileOrAsked) {
    EXPECT_EQ(sceneOf("feet.dxf").domain->boundary[1].x(), 3.048);
    ImportSettings settings;
    settings.unit = lengthUnitOf("mm");
    EXPECT_EQ(sceneOf("feet.dxf", settings).domain->boundary[1].x(), 0.01);
    EXPECT_EQ(sceneOf("unitless.dxf", settings).domain->boundary[1].x(), 0.01);
    EXPECT_EQ(sceneOf("without-units.csv", settings).joints[0].points[1], Point(1, 1));
    EXPECT_EQ(sceneOf("tabs.csv", settings).joints[1].points, (Points{{0, 5}, {10, 5.2505}}));
}

TEST(ImportFiles, ListsOfAllFormsSayTheSame) {
    const Points expected{{0, 0.5}, {10, 0.5}};
    EXPECT_EQ(sceneOf("semicolons.csv").joints[0].points, expected);
    EXPECT_EQ(sceneOf("tabs.csv").joints[0].points, expected);
    EXPECT_EQ(sceneOf("any-order.csv").joints[0].points, expected);
    const Scene quoted = sceneOf("quotes-bom-crlf.csv");
    EXPECT_EQ(quoted.joints[0].points, expected);
    EXPECT_EQ(quoted.joints[0].name, "Fault, \"main\"");
    EXPECT_EQ(quoted.joints[0].jointMaterial, "clay");
    EXPECT_EQ(quoted.joints[1].points[1].y(), 5.25);
    EXPECT_EQ(sceneOf("points.csv").joints[0].points, (Points{{0, 0}, {5, 1}, {10, 0.5}}));
    EXPECT_EQ(sceneOf("latin-1.csv").joints[0].name, "Kluft süd");
}

TEST(ImportFiles, BoltsOfListsKeepWhatTheListSays) {
    const Scene scene = sceneOf("bolts.csv");
    ASSERT_EQ(scene.bolts.size(), 2U);
    EXPECT_EQ(scene.bolts[0].type, "d-bolt-20");
    EXPECT_EQ(scene.bolts[0].farEnd, Point(0, 2.4));
    EXPECT_EQ(scene.bolts[0].spacingOutOfPlane, 1.5);
    EXPECT_EQ(scene.bolts[0].pretension, 20e3);
    EXPECT_EQ(scene.bolts[1].type, "assumed-bolt");
    EXPECT_FALSE(scene.bolts[1].spacingOutOfPlane);
    const Scene directed = sceneOf("bolt-directions.csv");
    EXPECT_LT((directed.bolts[1].farEnd - Point(2.2, 1.2 * std::sqrt(3.0))).norm(), 1e-15 * 10);
}

TEST(ImportFiles, DevicesAndPipesAreNotOpened) {
    const test::ScratchFolder scratch;
    ASSERT_EQ(::mkfifo((scratch.path() / "pipe.csv").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", scratch.path() / "zero.dxf");
    for (const auto& [name, what] :
         {std::pair("pipe.csv", "it is a named pipe"), std::pair("zero.dxf", "it is a device")})
        try {
            importFile(scratch.path() / name, {});
            FAIL() << name << " was read";
        } catch (const CannotRead& problem) {
            EXPECT_NE(std::string(problem.what()).find(what), std::string::npos) << problem.what();
        }
    EXPECT_THROW(readReferenceFile(scratch.path() / "pipe.csv"), CannotRead);
}

TEST(ImportFiles, ListsHaveAsManyRowsAsDrawingsHaveEntities) {
    std::string text = "x1_m,y1_m,x2_m,y2_m\n";
    for (int i = 0; i < 200'001; ++i) text += "0,0,1,1\n";
    const Drawing drawing = readCsvList(text, "joints", nullptr);
    ASSERT_EQ(drawing.problems.size(), 1U);
    EXPECT_EQ(drawing.problems[0].message, "the number of rows exceeds 200000");
    EXPECT_EQ(drawing.problems[0].line, 200'002);
}

TEST(ImportFiles, CellsOfCsvAreLimited) {
    const CsvRows read = readCsvRows("a,b\nx" + std::string(mostCsvCells + 10, ','));
    ASSERT_FALSE(read.problems.empty());
    EXPECT_EQ(read.problems[0].message, "the file has more than 5000000 cells");
}

TEST(ImportFiles, ADrawingOfTooManyEntitiesIsNotToldOfBlocksItHasNot) {
    test::DrawingText d;
    d.section("ENTITIES");
    std::string text = d.text();
    text.erase(text.find("  0\nEOF"));
    for (int i = 0; i < 200'001; ++i) text += "0\nPOINT\n8\nj\n";
    const Drawing drawing = readDxf(text + "0\nENDSEC\n0\nEOF\n");
    ASSERT_EQ(drawing.problems.size(), 1U);
    EXPECT_EQ(drawing.problems[0].remedy, "Export only the section");
}

/// The errors of a list with one joint for each of the given starts.
std::string errorsOfList(const std::string& separator, const std::vector<std::string>& starts) {
    std::string text = "x1_m" + separator + "y1_m" + separator + "x2_m" + separator + "y2_m\n";
    for (const std::string& start : starts) text += start + separator + "0" + separator + "7" + separator + "7\n";
    std::string errors;
    for (const Problem& problem : readCsvList(text, "joints", nullptr).problems) errors += oneLine(problem) + "\n";
    return errors;
}

TEST(ImportFiles, ACommaThatMaySeparateThousandsIsAskedAbout) {
    const std::string errors = errorsOfList(",", {"\"1,000\"", "\"-12,500\"", "3"});
    EXPECT_NE(errors.find("2: error: column 1 ('x1_m') holds '1,000': its comma could be"), std::string::npos)
        << errors;
    EXPECT_NE(errors.find("3: error: column 1 ('x1_m') holds '-12,500'"), std::string::npos) << errors;
    EXPECT_NE(errors.find("separate the cells by semicolons"), std::string::npos) << errors;
    EXPECT_NE(errorsOfList(",", {"\"1,000\"", "2.5"}), "");  // a decimal point elsewhere
    EXPECT_EQ(errorsOfList(",", {"\"1,000\"", "\"2,5\""}), "");  // another number shows decimal commas
    EXPECT_EQ(errorsOfList(",", {"\"0,250\"", "\"1,25\"", "\"1234,567\""}), "");
    EXPECT_EQ(errorsOfList(";", {"1,000"}), "");
    const ReferenceReading reference = readReferenceTable("opening_mm,load_kN\n\"1,000\",2\n", "lab.csv");
    EXPECT_TRUE(hasErrors(reference.problems));
}

TEST(ImportFiles, ALargeCircleDoesNotWidenWhereOutlinesClose) {
    test::DrawingText d;
    d.units(6).section("ENTITIES");
    d.line("boundary", {0, 0}, {10, 0}).line("boundary", {10, 0}, {10, 10});
    d.line("boundary", {10, 10}, {0, 10}).line("boundary", {0, 10}, {0, 0});
    d.line("joints", {0, 5}, {10, 5});
    d.entity("CIRCLE", "joints").at(10, {0, 0}).pair(40, 1e9);
    const Import import = importSection(readDxf(d.end().text()), {}, "circle.dxf");
    EXPECT_EQ(allOf(import).find("does not close"), std::string::npos) << allOf(import);
}

TEST(ImportFiles, LayersTakeTheRolesThatAreGiven) {
    ImportSettings settings;
    settings.roles = {{"KLüFTE", LayerRole::Joint}, {"*", LayerRole::Ignore}};  // letters beyond ASCII as they are
    const Scene scene = sceneOf("layer-in-code-page.dxf", settings);
    ASSERT_EQ(scene.joints.size(), 1U);
    EXPECT_EQ(scene.joints[0].name, "Klüfte");
    settings.roles = {{"joints-old", LayerRole::Joint}};
    EXPECT_EQ(sceneOf("frozen-layer.dxf", settings).joints.size(), 2U);
    settings.roles = {{"jonts", LayerRole::Joint}};
    const Import wrong = importFile(folder / "feet.dxf", settings);
    EXPECT_FALSE(wrong.scene);
    EXPECT_NE(allOf(wrong).find("Did you mean 'joints'?"), std::string::npos) << allOf(wrong);
}

TEST(ImportFiles, InsertsAreTurnedScaledAndNested) {
    // The pin runs from its base (1, 0) to (2, 0), a length of 1 along x. Pair: twice as long along x at (0, 0), and
    // upright at (0, 1); all of it turned by half a turn about (5, 5).
    const Scene scene = sceneOf("nested-inserts.dxf");
    ASSERT_EQ(scene.joints.size(), 3U);
    const auto expectLine = [](const SceneJoint& joint, const Point& a, const Point& b) {
        EXPECT_LT((joint.points[0] - a).norm() + (joint.points[1] - b).norm(), 1e-14);
    };
    expectLine(scene.joints[0], {5, 5}, {3, 5});
    expectLine(scene.joints[1], {5, 4}, {5, 3});
}

TEST(ImportFiles, ADrawingSeenFromBehindIsTurnedRound) {
    const Scene scene = sceneOf("seen-from-behind.dxf");
    EXPECT_EQ(scene.tunnels[0].center, Point(3, 4));
    EXPECT_EQ(scene.tunnels[0].diameter, 2.0);
}

}  // namespace
}  // namespace keyblock
