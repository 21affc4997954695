// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Includes only fall: from the programs through the solver to the geometry, and
// within the solver along the arrows of ARCHITECTURE.md. Nothing below the window
// knows Qt or VTK, so that all of it builds and runs on a machine without them.
//
// Within the engine they fall from `setup` and `stage` to the carriers of force
// (contact, glue, support, bolt, damping, boundary), which do not know each other but
// for a boundary, whose dashpots replace supports; from them over `carrier` and `time` to
// `model` and `step`; and from these to `laws`. `step` knows no rock: neither the model
// nor the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Room {
    std::string folder;  // or the name of a file and its header
    std::vector<std::string> mayInclude;  // besides itself
};

/// What the carriers of force may include, and more where a room lies above some of them.
std::vector<std::string> belowCarriers(std::vector<std::string> carriers = {}) {
    for (const char* below : {"solver/engine/carrier", "solver/engine/time", "solver/engine/model", "solver/engine/step",
                              "solver/engine/laws", "solver/results", "solver/scene", "geometry"})
        carriers.push_back(below);
    return carriers;
}

/// The files beside the folders of the geometry.
const std::vector<std::string> geometryBase{"geometry/angle",       "geometry/clip",   "geometry/grid",
                                            "geometry/orientation", "geometry/point",  "geometry/point_set",
                                            "geometry/polygon",     "geometry/random", "geometry/segment"};

/// What every panel may include, and the folders of panels that one of them uses.
std::vector<std::string> belowPanels(std::vector<std::string> panels = {}) {
    for (const char* below :
         {"ui/panels/filter_line", "ui/panels/calm_box", "ui/document", "ui/look", "ui/edit", "ui/figure", "ui/picture",
          "solver/files", "solver/run", "solver/results", "solver/scene", "geometry"})
        panels.push_back(below);
    return panels;
}

/// What the contents of pictures may include, and more where one folder of them uses another.
std::vector<std::string> belowPictures(std::vector<std::string> pictures = {}) {
    for (const char* below : {"ui/picture/captions", "ui/picture/chart", "ui/picture/colour", "ui/picture/event_list",
                              "ui/picture/not_finite", "ui/picture/run_time", "ui/picture/scale_choice",
                              "ui/picture/ticks", "solver/results", "solver/scene", "geometry"})
        pictures.push_back(below);
    return pictures;
}

const std::vector<Room> rooms{
    {"geometry/cut", geometryBase},
    {"geometry/cells", geometryBase},
    {"geometry/shape", geometryBase},
    {"geometry", {}},
    {"solver/scene", {"geometry"}},
    {"solver/results", {"solver/scene", "geometry"}},
    {"solver/engine/vector6", {}},
    {"solver/engine/laws", {"geometry"}},
    {"solver/engine/step", {"solver/engine/laws", "solver/engine/vector6", "solver/results/step_work"}},
    {"solver/engine/model",
     {"solver/engine/laws", "solver/engine/vector6", "solver/results", "solver/scene", "geometry"}},
    {"solver/engine/time", {"solver/engine/model", "solver/engine/step", "solver/engine/laws", "solver/scene"}},
    {"solver/engine/carrier",
     {"solver/engine/time", "solver/engine/model", "solver/engine/step", "solver/engine/laws"}},
    {"solver/engine/contact", belowCarriers()},
    {"solver/engine/glue", belowCarriers()},
    {"solver/engine/support", belowCarriers()},
    {"solver/engine/bolt", belowCarriers()},
    {"solver/engine/damping", belowCarriers()},
    {"solver/engine/boundary", belowCarriers({"solver/engine/support"})},
    {"solver/engine/setup",
     belowCarriers({"solver/engine/contact", "solver/engine/glue", "solver/engine/support", "solver/engine/bolt"})},
    {"solver/engine/stage", belowCarriers({"solver/engine/contact", "solver/engine/glue", "solver/engine/support",
                                           "solver/engine/bolt", "solver/engine/damping", "solver/engine/boundary"})},
    {"solver/engine/sleep", belowCarriers({"solver/engine/contact", "solver/engine/stage"})},
    {"solver/engine", {}},  // all of them, for the rooms above; no file lies beside them
    {"solver/run", {"solver/engine", "solver/results", "solver/scene", "geometry"}},
    {"solver/files/json", {"solver/scene"}},
    {"solver/files/csv", {"solver/files/text_encoding", "solver/scene"}},
    {"solver/files/scene",
     {"solver/files/json", "solver/files/csv", "solver/files/atomic_file", "solver/files/read_error",
      "solver/files/regular_file", "solver/files/sha256", "solver/files/text_file", "solver/engine", "solver/results",
      "solver/scene", "geometry"}},
    {"solver/files/drawing",
     {"solver/files/scene", "solver/files/csv", "solver/files/read_error", "solver/files/text_encoding",
      "solver/files/text_file", "solver/scene", "geometry"}},
    {"solver/files/run_store",
     {"solver/files/scene", "solver/files/atomic_file", "solver/files/program_version", "solver/files/read_error",
      "solver/files/sha256", "solver/run", "solver/engine/step/blas_kernel", "solver/results", "solver/scene"}},
    {"solver/files/vtk",
     {"solver/files/run_store", "solver/files/atomic_file", "solver/files/part_folder", "solver/run", "solver/results",
      "solver/scene", "geometry"}},
    {"solver/files", {"solver/run", "solver/engine", "solver/results", "solver/scene", "geometry"}},
    {"solver/verify", {"solver/files", "solver/run", "solver/engine", "solver/results", "solver/scene", "geometry"}},
    {"solver/trade", {"solver/files", "solver/run", "solver/engine", "solver/results", "solver/scene", "geometry"}},
    {"solver/study", {"solver/files", "solver/run", "solver/engine", "solver/results", "solver/scene", "geometry"}},
    {"ui/picture/section", belowPictures()},
    {"ui/picture/charts", belowPictures({"ui/picture/section"})},
    {"ui/picture", {"solver/results", "solver/scene", "geometry"}},
    {"ui/figure", {"ui/picture", "solver/trade", "solver/study", "solver/results", "solver/scene", "geometry"}},
    {"ui/report/stored",
     {"ui/report/report", "ui/report/report_html", "ui/report/report_pdf", "ui/report/study_report", "ui/figure",
      "solver/study", "solver/verify", "solver/files", "solver/run"}},
    {"ui/report",
     {"ui/figure", "ui/picture", "solver/study", "solver/run", "solver/results", "solver/scene", "geometry"}},
    {"ui/edit", {"solver/files", "solver/run", "solver/results", "solver/scene", "geometry"}},
    {"ui/view", {"ui/picture", "solver/results", "solver/scene", "geometry"}},
    {"ui/look", {"ui/picture", "solver/scene"}},
    {"ui/document",
     {"ui/look", "ui/edit", "ui/picture", "solver/files", "solver/run", "solver/results", "solver/scene", "geometry"}},
    {"ui/canvas", {"ui/look", "ui/view", "ui/figure", "ui/picture", "solver/results", "solver/scene", "geometry"}},
    {"ui/tools",
     {"ui/canvas", "ui/document", "ui/look", "ui/edit", "ui/picture", "solver/files", "solver/scene", "geometry"}},
    {"ui/panels/fields", belowPanels()},
    {"ui/panels/editors", belowPanels({"ui/panels/fields"})},
    {"ui/panels/properties", belowPanels({"ui/panels/editors", "ui/panels/fields"})},
    {"ui/panels/tree", belowPanels({"ui/panels/fields"})},
    {"ui/panels/problems", belowPanels({"ui/panels/fields"})},
    {"ui/panels/stages", belowPanels({"ui/panels/editors", "ui/panels/fields"})},
    {"ui/panels/library", belowPanels({"ui/panels/editors", "ui/panels/fields"})},
    {"ui/panels/summary", belowPanels({"solver/trade"})},
    {"ui/panels", belowPanels()},
    {"ui/runs",
     {"ui/document", "ui/look", "ui/picture", "solver/trade", "solver/files", "solver/run", "solver/results",
      "solver/scene", "geometry"}},
    {"ui/docks",
     {"ui/runs", "ui/canvas", "ui/document", "ui/look", "ui/edit", "ui/figure", "ui/picture", "solver/trade",
      "solver/files", "solver/run", "solver/results", "solver/scene", "geometry"}},
    {"ui/start",
     {"ui/runs", "ui/document", "ui/look", "ui/edit", "ui/picture", "solver/files", "solver/scene", "geometry"}},
    {"ui/export",
     {"ui/runs", "ui/document", "ui/look", "ui/report", "ui/figure", "ui/picture", "solver/files", "solver/run",
      "solver/results", "solver/scene", "geometry"}},
    {"ui/study",
     {"ui/document", "ui/look", "ui/edit", "ui/figure", "ui/picture", "solver/study", "solver/files", "solver/run",
      "solver/results", "solver/scene", "geometry"}},
    {"ui/help", {"ui/look", "solver/scene"}},
    {"ui/window",
     {"ui/start",   "ui/export",    "ui/study",     "ui/help",    "ui/docks",       "ui/runs",      "ui/panels",
      "ui/tools",   "ui/canvas",    "ui/document",  "ui/look",    "ui/view",        "ui/edit",      "ui/figure",
      "ui/picture", "solver/study", "solver/files", "solver/run", "solver/results", "solver/scene", "geometry"}},
    {"app/memory", {}},
    {"app/start", {"solver/files/read_error", "solver/engine/step/blas_kernel"}},
    {"app/studio", {"app/start", "ui/window", "ui/document", "ui/look", "solver/files"}},
    {"app/cli",
     {"app/start", "ui/report", "ui/figure", "ui/picture", "solver/study", "solver/trade", "solver/verify",
      "solver/files", "solver/run", "solver/engine", "solver/results", "solver/scene", "geometry"}},
};

bool liesIn(const std::string& path, const std::string& folder) {
    return path.starts_with(folder + "/") || path.starts_with(folder + ".");
}

const Room* roomOf(const std::string& path) {
    const auto found = std::ranges::find_if(rooms, [&](const Room& room) { return liesIn(path, room.folder); });
    return found == rooms.end() ? nullptr : &*found;
}

bool knowsQt(const Room& room) {
    static const std::vector<std::string> without{"ui/picture", "ui/edit", "ui/view", "app/cli"};
    return (room.folder.starts_with("ui/") || room.folder == "app/studio") && !std::ranges::count(without, room.folder);
}

/// What is wrong with one include, in words; nothing when it may stand.
std::optional<std::string> faultOf(const Room& room, const std::string& included, bool quoted, bool header) {
    static const std::regex windowLibrary("(vtk|VTK).*");
    static const std::regex paperLibrary("(Q[A-Z]|Qt).*|qcustomplot\\.h");
    const bool paper = std::regex_match(included, paperLibrary);
    if (paper && knowsQt(room)) return std::nullopt;
    const bool screen = std::regex_match(included, windowLibrary);
    if (screen && (room.folder == "ui/canvas" || room.folder == "ui/view")) return std::nullopt;
    if (paper || screen) return "Qt stays in the window and on paper, VTK in ui/view and its widget";
    if (header && included.starts_with("CGAL/")) return "CGAL stays in .cpp files";
    if (!quoted) return std::nullopt;
    if (liesIn(included, room.folder)) return std::nullopt;
    const bool falls = std::ranges::any_of(room.mayInclude, [&](const auto& below) { return liesIn(included, below); });
    if (!falls) return "does not fall from " + room.folder;
    return std::nullopt;
}

/// One line for each include that may not stand in the file `path` (relative to the root).
std::vector<std::string> faults(const std::string& path, std::istream& text) {
    const Room* room = roomOf(path);
    if (!room || room->folder == "solver/engine") return {path + ": lies in no room this test knows"};
    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<std::string> found;
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        if (const auto fault = faultOf(*room, match[2], match[1] == "\"", path.ends_with(".h")))
            found.push_back(path + ":" + std::to_string(number) + ": " + match[2].str() + " " + *fault);
    }
    return found;
}

std::vector<std::string> faultsOf(const std::string& path, const std::string& text) {
    std::istringstream stream(text);
    return faults(path, stream);
}

std::vector<fs::path> sourcesBelow(const fs::path& folder) {
    std::vector<fs::path> sources;
    if (!fs::exists(folder)) return sources;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") sources.push_back(entry.path());
    std::sort(sources.begin(), sources.end());
    return sources;
}

TEST(Layers, IncludesOnlyFall) {
    const fs::path root = KEYBLOCK_SOURCE_DIR;
    std::size_t read = 0;
    for (const char* floor : {"geometry", "solver", "ui", "app"})
        for (const fs::path& source : sourcesBelow(root / floor)) {
            std::ifstream text(source);
            ASSERT_TRUE(text) << source;
            for (const std::string& fault : faults(source.lexically_relative(root).generic_string(), text))
                ADD_FAILURE() << fault;
            ++read;
        }
    EXPECT_GT(read, 10u);
}

TEST(Layers, NoRoomIncludesARoomThatIncludesIt) {
    for (const Room& room : rooms)
        for (const std::string& below : room.mayInclude) {
            const Room* lower = roomOf(below + "/");
            ASSERT_TRUE(lower) << below;
            EXPECT_FALSE(std::ranges::count(lower->mayInclude, room.folder)) << room.folder << " and " << below;
        }
}

TEST(Layers, AnIncludeThatRisesIsCaught) {
    EXPECT_EQ(faultsOf("geometry/made_up.h", "#include \"solver/scene/scene.h\"\n").size(), 1u);
    EXPECT_EQ(faultsOf("solver/engine/stage/made_up.cpp", "\n# include \"solver/files/run_store/run_store.h\"\n").front(),
              "solver/engine/stage/made_up.cpp:2: solver/files/run_store/run_store.h does not fall from solver/engine/stage");
    EXPECT_EQ(faultsOf("solver/results/made_up.cpp", "#include \"solver/engine/model/model.h\"\n").size(), 1u);
    EXPECT_EQ(faultsOf("app/cli/made_up.cpp", "#include \"ui/window.h\"\n").size(), 1u);
    EXPECT_EQ(faultsOf("solver/run/made_up.cpp", "#include \"engine/model.h\"\n").size(), 1u);  // not from the root
}

TEST(Layers, AnIncludeThatRisesWithinTheEngineIsCaught) {
    const auto risesFrom = [](const std::string& file, const std::string& included) {
        return faultsOf("solver/engine/" + file, "#include \"solver/engine/" + included + "\"\n").size() == 1u;
    };
    EXPECT_TRUE(risesFrom("step/made_up.h", "model/model.h"));
    EXPECT_TRUE(risesFrom("model/made_up.h", "step/step_problem.h"));
    EXPECT_TRUE(risesFrom("carrier/made_up.h", "bolt/bolt.h"));
    EXPECT_TRUE(risesFrom("bolt/made_up.cpp", "contact/links.h"));
    EXPECT_TRUE(risesFrom("glue.cpp", "stage/engine.h"));
    EXPECT_TRUE(risesFrom("stage/made_up.cpp", "setup/make_model.h"));
    EXPECT_FALSE(risesFrom("boundary.cpp", "support.h"));
    EXPECT_FALSE(risesFrom("stage/made_up.cpp", "glue.h"));
    EXPECT_EQ(faultsOf("solver/engine/step/made_up.h", "#include \"solver/scene/scene.h\"\n").size(), 1u);
    EXPECT_EQ(faultsOf("solver/engine/made_up.cpp", "").size(), 1u);
}

TEST(Layers, AnIncludeThatRisesWithinFilesIsCaught) {
    EXPECT_EQ(faultsOf("solver/files/csv/made_up.cpp", "#include \"solver/files/drawing/dxf_groups.h\"\n").size(), 1u);
    EXPECT_EQ(faultsOf("solver/files/drawing/made_up.cpp", "#include \"solver/files/run_store/run_store.h\"\n").size(), 1u);
}

TEST(Layers, WindowLibrariesAreCaught) {
    EXPECT_EQ(faultsOf("solver/run/made_up.cpp", "#include <QObject>\n").size(), 1u);
    EXPECT_EQ(faultsOf("geometry/made_up.cpp", "#include <QtCore/QPointF>\n").size(), 1u);
    EXPECT_EQ(faultsOf("app/cli/made_up.cpp", "#include <vtkNew.h>\n").size(), 1u);
    EXPECT_EQ(faultsOf("app/cli/made_up.cpp", "#include <QPainter>\n").size(), 1u);
    EXPECT_EQ(faultsOf("ui/picture/made_up.cpp", "#include <QPainter>\n").size(), 1u);
    EXPECT_EQ(faultsOf("ui/figure/made_up.cpp", "#include <vtkNew.h>\n").size(), 1u);
    EXPECT_EQ(faultsOf("ui/picture/made_up.cpp", "#include \"ui/figure/figure.h\"\n").size(), 1u);
    EXPECT_EQ(faultsOf("geometry/made_up.h", "#include <CGAL/Arrangement_2.h>\n").size(), 1u);
}

TEST(Layers, AFileInNoRoomIsCaught) { EXPECT_EQ(faultsOf("solver/stray.cpp", "").size(), 1u); }

TEST(Layers, WhatFallsMayStand) {
    EXPECT_TRUE(faultsOf("app/cli/made_up.cpp", "#include \"solver/run/run.h\"\n#include <vector>\n").empty());
    EXPECT_TRUE(
        faultsOf("ui/figure/made_up.cpp", "#include <QPainter>\n#include \"ui/picture/section/marks.h\"\n").empty());
    EXPECT_TRUE(faultsOf("solver/engine/model/made_up.h", "#include \"solver/engine/laws/beam.h\"\n").empty());
    EXPECT_TRUE(faultsOf("geometry/made_up.cpp", "#include <CGAL/Arrangement_2.h>\n// #include <QObject>\n").empty());
}

}  // namespace
