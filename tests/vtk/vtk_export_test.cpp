// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is exported for ParaView, read by VTK's own readers and held against the
// tables. Built only where VTK is found: the program does not need it.
#include "solver/files/vtk/vtk_export.h"

#include "geometry/polygon.h"
#include "solver/files/scene/scene_file.h"
#include "solver/results/frame_quantities.h"
#include "solver/results/tables.h"
#include "solver/results/result_names.h"
#include "solver/run/write_error.h"
#include "solver/run/run.h"
#include "tests/scratch_folder.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace keyblock {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

// A circular opening that is excavated, so that the blocks round it are concave; displacements begin anew when the bolt
// is installed; then the roof block is pulled down and the bolt lets go.
constexpr const char* sceneWithAll = R"({
  "format": "keyblock-scene", "version": 1,
  "analysis": { "plane": "strain", "gravity": [0, -9.81] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 1e9, "poissons_ratio": 0.2 } },
  "joint_materials": { "joint": { "friction_angle": 30 } },
  "domain": { "boundary": [[1000,-4],[1010,-4],[1010,6],[1000,6]], "material": "rock" },
  "joints": [ { "name": "bedding", "points": [[1000,3],[1010,3]] },
              { "name": "steep", "points": [[1005.3,-4],[1005.4,3]] } ],
  "tunnels": [ { "name": "adit", "profile": "circle", "center": [1005,0], "diameter": 3 } ],
  "bolts": [ { "name": "B & <1>", "type": "rebar-20", "far_end": [1007,3.9], "head": [1007,2.1], "plate": "none" } ],
  "supports": [ { "boundary": "bottom", "fix": "xy" }, { "boundary": "left", "fix": "x" },
                { "boundary": "right", "fix": "x" } ],
  "stages": [ { "name": "settle", "kind": "static" },
              { "name": "excavate", "kind": "static", "excavate": ["adit"], "continue": true },
              { "name": "hang", "kind": "static", "install": ["B & <1>"], "zero_displacements": true },
              { "name": "swing", "kind": "dynamic", "duration": 0.01, "time_step": 0.001 } ],
  "output": { "frames": 16 }
})";

struct Ran {
    Scene scene;
    Results results;
};

const Ran& ran() {
    static const Ran once = [] {
        const SceneReading reading = readSceneText(sceneWithAll, "scene");
        for (const Problem& problem : reading.problems)
            EXPECT_NE(problem.severity, Severity::Error) << oneLine(problem);
        return Ran{*reading.scene, runInMemory(*reading.scene)};
    }();
    return once;
}

struct Listed {
    double time = 0.0;
    vtkSmartPointer<vtkPolyData> data;
};

/// Every file of a `.pvd`.
std::vector<Listed> series(const fs::path& list) {
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
        vtkXMLUtilities::ReadElementFromFile(list.string().c_str()));
    std::vector<Listed> all;
    EXPECT_STREQ(root->GetName(), "VTKFile");
    EXPECT_STREQ(root->GetAttribute("type"), "Collection");
    vtkXMLDataElement* collection = root->GetNestedElement(0);
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* entry = collection->GetNestedElement(i);
        Listed listed;
        EXPECT_EQ(entry->GetScalarAttribute("timestep", listed.time), 1);
        const fs::path file = list.parent_path() / entry->GetAttribute("file");
        vtkNew<vtkXMLPolyDataReader> reader;
        EXPECT_TRUE(reader->CanReadFile(file.string().c_str())) << file;
        reader->SetFileName(file.string().c_str());
        reader->Update();
        EXPECT_EQ(reader->GetErrorCode(), 0U) << file;
        listed.data = reader->GetOutput();
        all.push_back(listed);
    }
    return all;
}

using Table = std::vector<std::vector<std::string>>;

Table tableAt(TableKind kind, const RunSource& run, const std::string& stage, double time) {
    std::ostringstream text;
    TableFilter filter;
    for (std::size_t i = 0; i < run.scene().stages.size(); ++i)
        if (run.scene().stages[i].name == stage) filter.stage = static_cast<int>(i);
    filter.when = When::At;
    filter.time = time;
    writeTable(kind, run, filter, text);
    Table table;
    std::istringstream lines(text.str());
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string>& row = table.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    }
    return table;
}

std::string stageOf(vtkPolyData* data) {
    return vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("stage"))->GetValue(0);
}

double timeOf(vtkPolyData* data) { return data->GetFieldData()->GetArray("time_s")->GetTuple1(0); }

void expectSame(double read, const std::string& written, const std::string& what) {
    const double value = std::stod(written);
    EXPECT_NEAR(read, value, 1e-12 * std::max(1e-300, std::abs(value))) << what;
}

/// Every column of the table that is a number, at the table's row and the arrays' tuple.
void expectRow(const Table& table, std::size_t row, vtkDataSetAttributes* arrays, vtkIdType tuple,
               const std::set<std::string>& words) {
    for (std::size_t column = 2; column < table[0].size(); ++column) {
        const std::string& name = table[0][column];
        if (words.contains(name)) continue;
        vtkDataArray* array = arrays->GetArray(name.c_str());
        ASSERT_TRUE(array) << name;
        ASSERT_LT(tuple, array->GetNumberOfTuples());
        expectSame(array->GetTuple1(tuple), table[row][column], name + " in row " + std::to_string(row));
    }
}

std::string textAt(vtkDataSetAttributes* arrays, const char* name, vtkIdType tuple) {
    vtkStringArray* array = vtkStringArray::SafeDownCast(arrays->GetAbstractArray(name));
    return array ? std::string(array->GetValue(tuple)) : "no array " + std::string(name);
}

class VtkExport : public ::testing::Test {
protected:
    VtkExport() : run_(ran().scene, ran().results) { writeVtkFolder(run_, {}, folder()); }

    fs::path folder() const { return scratch_.path() / "out"; }
    std::vector<Listed> all(const std::string& kind) const { return series(folder() / (kind + ".pvd")); }

    const ScratchFolder scratch_;
    MemoryRun run_;
};

TEST_F(VtkExport, HasEveryMomentInOrder) {
    for (const std::string kind : {"blocks", "bolts", "contacts"}) {
        const std::vector<Listed> moments = all(kind);
        ASSERT_GT(moments.size(), 10U);
        const std::map<std::string, double> starts{{"settle", 0}, {"excavate", 1}, {"hang", 2}, {"swing", 3}};
        double before = -1.0;
        for (const Listed& moment : moments) {
            EXPECT_GT(moment.time, before);
            before = moment.time;
            EXPECT_NEAR(moment.time, starts.at(stageOf(moment.data)) + timeOf(moment.data), 1e-12);
            EXPECT_EQ(moment.data->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), moment.time);
        }
        EXPECT_NEAR(before, 3.01, 1e-12);
    }
}

TEST_F(VtkExport, GivesTheBlocksOfTheTable) {
    for (const Listed& moment : all("blocks")) {
        const Table table = tableAt(TableKind::Blocks, run_, stageOf(moment.data), timeOf(moment.data));
        std::map<std::string, std::vector<vtkIdType>> cells;
        for (vtkIdType cell = 0; cell < moment.data->GetNumberOfCells(); ++cell)
            cells[textAt(moment.data->GetCellData(), "name", cell)].push_back(cell);
        EXPECT_EQ(cells.size(), table.size() - 1);
        for (std::size_t row = 1; row < table.size(); ++row)
            for (const vtkIdType cell : cells[table[row][2]]) {
                expectRow(table, row, moment.data->GetCellData(), cell, {"block"});
                double u[3];
                moment.data->GetCellData()->GetArray("displacement_vector_m")->GetTuple(cell, u);
                EXPECT_EQ(u[0], moment.data->GetCellData()->GetArray("ux_m")->GetTuple1(cell));
                EXPECT_EQ(u[1], moment.data->GetCellData()->GetArray("uy_m")->GetTuple1(cell));
            }
    }
}

TEST_F(VtkExport, GivesEveryQuantityOfTheTable) {
    double largest = 0.0;
    for (const Listed& moment : all("blocks")) {
        vtkCellData* arrays = moment.data->GetCellData();
        for (const FrameQuantity<BlockState>& quantity : blockQuantities())
            EXPECT_TRUE(arrays->GetArray(std::string(quantity.column).c_str())) << quantity.column;
        for (vtkIdType cell = 0; cell < moment.data->GetNumberOfCells(); ++cell) {
            const auto value = [&](const char* name) { return arrays->GetArray(name)->GetTuple1(cell); };
            // Invariants of the stress: the trace and the determinant, compression positive.
            const double one = value("sigma1_compressive_Pa"), three = value("sigma3_compressive_Pa");
            const double x = value("sxx_Pa"), y = value("syy_Pa"), xy = value("sxy_Pa");
            const double scale = std::abs(x) + std::abs(y) + std::abs(xy);
            EXPECT_NEAR(one + three, -x - y, 1e-12 * scale);
            EXPECT_NEAR(one * three, x * y - xy * xy, 1e-12 * scale * scale);
            EXPECT_GE(one, three);
            largest = std::max(largest, one);
        }
    }
    EXPECT_GT(largest, 1e4);
}

std::vector<Point> cornersOf(vtkPolyData* data, vtkIdType cell) {
    std::vector<Point> corners;
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
        double p[3];
        data->GetPoint(ids->GetId(i), p);
        EXPECT_EQ(p[2], 0.0);
        corners.emplace_back(p[0], p[1]);
    }
    return corners;
}

TEST_F(VtkExport, DrawsBlocksThatFillTheirArea) {
    int concave = 0;
    for (const Listed& moment : all("blocks")) {
        std::map<std::string, double> left;
        std::map<std::string, int> pieces;
        for (vtkIdType cell = 0; cell < moment.data->GetNumberOfCells(); ++cell) {
            const std::string name = textAt(moment.data->GetCellData(), "name", cell);
            left.try_emplace(name, moment.data->GetCellData()->GetArray("area_m2")->GetTuple1(cell));
            const double own = signedArea(cornersOf(moment.data, cell));
            EXPECT_GT(own, 0.0);
            left[name] -= own;
            ++pieces[name];
        }
        for (const auto& [name, rest] : left) EXPECT_NEAR(rest, 0.0, 1e-10) << name;  // of some 30 m², 1000 m away
        for (const auto& [name, count] : pieces) concave += count > 1;
    }
    EXPECT_GT(concave, 0);
}

TEST_F(VtkExport, PutsCornersWhereTheFrameHasThem) {
    for (const Listed& moment : all("blocks")) {
        const Frame* frame = nullptr;
        for (const Frame& kept : ran().results.frames)
            if (run_.scene().stages[kept.stage].name == stageOf(moment.data) &&
                kept.time == timeOf(moment.data))
                frame = &kept;
        ASSERT_TRUE(frame);
        vtkIdType point = 0;
        for (const BlockState& block : frame->blocks)
            for (const Point& corner : block.points) {
                double p[3];
                moment.data->GetPoint(point++, p);
                EXPECT_EQ(p[0], corner.x());
                EXPECT_EQ(p[1], corner.y());
            }
        EXPECT_EQ(point, moment.data->GetNumberOfPoints());
    }
}

/// Blocks move affinely, so the displacements of the corners, weighted to their centroid where they began, give the
/// one of the table. Also after displacements begin anew, and with blocks that are gone.
TEST_F(VtkExport, MovesCornersAsTheirBlocksMove) {
    for (const Listed& moment : all("blocks")) {
        for (vtkIdType cell = 0; cell < moment.data->GetNumberOfCells(); ++cell) {
            vtkNew<vtkIdList> ids;
            moment.data->GetCellPoints(cell, ids);
            const std::string name = textAt(moment.data->GetCellData(), "name", cell);
            if (ids->GetNumberOfIds() == 3) continue;  // of a concave block; the others are whole
            std::vector<Point> before, now;
            for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
                double p[3], u[3];
                moment.data->GetPoint(ids->GetId(i), p);
                moment.data->GetPointData()->GetArray("displacement_vector_m")->GetTuple(ids->GetId(i), u);
                now.emplace_back(p[0], p[1]);
                before.emplace_back(p[0] - u[0], p[1] - u[1]);
            }
            const Point moved = moments(now).centroid - moments(before).centroid;
            double u[3];
            moment.data->GetCellData()->GetArray("displacement_vector_m")->GetTuple(cell, u);
            EXPECT_NEAR(moved.x(), u[0], 2e-12) << name << " " << stageOf(moment.data);  // differences 1000 m away
            EXPECT_NEAR(moved.y(), u[1], 2e-12) << name << " " << stageOf(moment.data);
        }
    }
}

TEST_F(VtkExport, GivesTheBoltsOfTheTable) {
    int present = 0;
    for (const Listed& moment : all("bolts")) {
        const Table table = tableAt(TableKind::Bolts, run_, stageOf(moment.data), timeOf(moment.data));
        vtkPolyData* data = moment.data;
        ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(table.size()) - 1);
        const std::set<std::string> words{"bolt", "block", "anchor", "state", "axial_force_N", "shear_force_N"};
        for (std::size_t row = 1; row < table.size(); ++row) {
            const auto point = static_cast<vtkIdType>(row) - 1;
            expectRow(table, row, data->GetPointData(), point, words);
            const bool real = data->GetPointData()->GetArray("real")->GetTuple1(point) == 1.0;
            EXPECT_EQ(table[row][8], real ? "real" : "artificial");
            const int state = static_cast<int>(data->GetPointData()->GetArray("state")->GetTuple1(point));
            EXPECT_EQ(table[row][9], wordOf(static_cast<NodeState>(state)));
        }
        for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
            const vtkIdType node = data->GetCell(cell)->GetPointId(0);
            const auto row = static_cast<std::size_t>(node) + 1;
            EXPECT_EQ(textAt(data->GetCellData(), "name", cell), "B & <1>");
            EXPECT_EQ(data->GetCell(cell)->GetNumberOfPoints(),
                      data->GetCellData()->GetArray("plate")->GetTuple1(cell) == 1.0 ? 1 : 2);
            expectSame(data->GetCellData()->GetArray("axial_force_N")->GetTuple1(cell), table[row][10], "axial force");
            expectSame(data->GetCellData()->GetArray("shear_force_N")->GetTuple1(cell), table[row][11], "shear force");
        }
        EXPECT_EQ(data->GetNumberOfCells(), data->GetNumberOfPoints());  // a row of the table each
        present += data->GetNumberOfPoints() > 0;
    }
    EXPECT_GT(present, 4);
}

TEST_F(VtkExport, GivesTheContactsOfTheTable) {
    for (const Listed& moment : all("contacts")) {
        const Table table = tableAt(TableKind::Contacts, run_, stageOf(moment.data), timeOf(moment.data));
        ASSERT_EQ(moment.data->GetNumberOfPoints(), static_cast<vtkIdType>(table.size()) - 1);
        ASSERT_EQ(moment.data->GetNumberOfVerts(), moment.data->GetNumberOfPoints());
        for (std::size_t row = 1; row < table.size(); ++row) {
            const auto point = static_cast<vtkIdType>(row) - 1;
            expectRow(table, row, moment.data->GetPointData(), point,
                      {"block_a", "block_b", "joint_material", "state"});
            EXPECT_EQ(textAt(moment.data->GetPointData(), "name_a", point), table[row][2]);
            EXPECT_EQ(textAt(moment.data->GetPointData(), "name_b", point), table[row][3]);
            double p[3];
            moment.data->GetPoint(point, p);
            expectSame(p[0], table[row][5], "x");
            const int state = static_cast<int>(moment.data->GetPointData()->GetArray("state")->GetTuple1(point));
            EXPECT_EQ(table[row][7], wordOf(static_cast<ContactState>(state)));
        }
    }
}

TEST_F(VtkExport, SelectsStageAndMoment) {
    TableFilter filter;
    filter.stage = 1;
    writeVtkFolder(run_, filter, folder());
    for (const Listed& moment : all("blocks")) EXPECT_EQ(stageOf(moment.data), "excavate");
    filter.when = When::Last;
    writeVtkFolder(run_, filter, folder());
    ASSERT_EQ(all("bolts").size(), 1U);
    EXPECT_EQ(all("blocks").front().time, 2.0);
    EXPECT_FALSE(fs::exists(folder() / "blocks/0001.vtp"));  // of the export before
}

TEST_F(VtkExport, LeavesAFolderOfOtherFilesAlone) {
    const fs::path other = scratch_.path() / "mine";
    fs::create_directory(other);
    test::putContent(other / "thesis.txt", "words");
    EXPECT_THROW(writeVtkFolder(run_, {}, other), CannotWrite);
    EXPECT_EQ(test::contentOf(other / "thesis.txt"), "words");
    EXPECT_THROW(writeVtkFolder(run_, {}, other / "thesis.txt"), CannotWrite);
    EXPECT_THROW(writeVtkFolder(run_, {}, scratch_.path() / "not" / "there"), CannotWrite);
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(scratch_.path())) ++entries;
    EXPECT_EQ(entries, 2);  // nothing half-written is left
}

TEST_F(VtkExport, WritesTheSameBytesAgain) {
    const fs::path again = scratch_.path() / "again";
    writeVtkFolder(run_, {}, again);
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder())) {
        if (!entry.is_regular_file()) continue;
        EXPECT_EQ(test::contentOf(entry.path()), test::contentOf(again / entry.path().lexically_relative(folder())));
        ++files;
    }
    EXPECT_GT(files, 30);
}

}  // namespace
}  // namespace keyblock
