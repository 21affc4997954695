// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every frame is loaded once and in order, including those that are not written: where
// displacements are reset, they are measured from the previous frame.
#include "solver/files/vtk/vtk_export.h"

#include "solver/files/part_folder.h"
#include "solver/files/vtk/vtk_frame.h"
#include "solver/files/atomic_file.h"
#include "solver/results/result_names.h"
#include "solver/run/write_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kinds{"blocks", "bolts", "contacts"};

bool isOurs(const std::string& name) {
    return std::any_of(kinds.begin(), kinds.end(), [&](std::string_view kind) {
        return name == kind || name == std::string(kind) + ".pvd";
    });
}

[[noreturn]] void fail(const fs::path& folder, const std::error_code& error) {
    throw CannotWrite(cannotWriteText(folder, error.value()));
}

/// A time series of VTK files.
class Series {
public:
    Series(const fs::path& folder, std::string_view kind) : folder_(folder), kind_(kind) {}

    void add(VtkPolyData data, const RunSource& run, const FrameHead& head, double time) {
        data.fieldData = {{"TimeValue", std::vector<double>{time}},
                          {"stage", std::vector<std::string>{stageName(run.scene(), head.stage)}},
                          {"time_s", std::vector<double>{head.time}},
                          {"step", std::vector<std::int32_t>{static_cast<std::int32_t>(head.step)}}};
        std::error_code error;
        if (moments_.empty()) fs::create_directory(folder_ / kind_, error);
        if (error) fail(folder_ / kind_, error);
        std::string number = std::to_string(moments_.size());
        number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
        const std::string file = kind_ + "/" + number + ".vtp";
        writeAtomically(folder_ / file, [&](std::ostream& out) { writeVtkPolyData(data, out); });
        moments_.push_back({time, file});
    }

    void close() const {
        if (!moments_.empty())
            writeAtomically(folder_ / (kind_ + ".pvd"), [&](std::ostream& out) { writeVtkCollection(moments_, out); });
    }

private:
    fs::path folder_;
    std::string kind_;
    std::vector<VtkMoment> moments_;
};

/// Start of each stage in the time of the whole run.
std::map<int, double> stageStarts(const RunSource& run) {
    std::map<int, double> lengths;
    for (const StageRecord& record : run.stages())
        if (record.ended) lengths[record.result.stage] = record.result.time;
    for (const FrameHead& head : run.frames()) lengths[head.stage] = std::max(lengths[head.stage], head.time);
    std::map<int, double> starts;
    double start = 0.0;
    for (const auto& [stage, length] : lengths) {
        starts[stage] = start;
        start += length;
    }
    return starts;
}

/// Frames selected by the filter, each with its time in the whole run. Readers show one frame per time. If the last
/// frame of a stage and the first frame of the next have the same time, the latter is used. If states just before and
/// just after a failure have the same time, that of the former is reduced by the smallest possible amount.
std::map<std::size_t, double> timesOf(const RunSource& run, const TableFilter& filter, const std::map<int, double>& starts) {
    std::vector<RowMoment> moments;
    for (const FrameHead& head : run.frames()) moments.push_back({head.stage, head.time});
    const std::vector<std::size_t> wanted = selected(moments, filter, When::All);
    std::map<std::size_t, double> times;
    const FrameHead* next = nullptr;
    double later = std::numeric_limits<double>::infinity();
    for (auto i = wanted.rbegin(); i != wanted.rend(); ++i) {
        const FrameHead& head = run.frames()[*i];
        const double time = starts.at(head.stage) + head.time;
        if (next && time >= later && (head.stage != next->stage || head.events == next->events || time <= 0.0)) continue;
        later = next && time >= later ? std::nextafter(later, -1.0) : time;
        times[*i] = later;
        next = &head;
    }
    return times;
}

}  // namespace

void writeVtkFolder(const RunSource& run, const TableFilter& filter, const fs::path& folder) {
    const PartFolder part(folder, isOurs);
    const std::map<int, double> starts = stageStarts(run);
    const std::map<std::size_t, double> times = timesOf(run, filter, starts);
    Series blocks(part.path(), kinds[0]), bolts(part.path(), kinds[1]), contacts(part.path(), kinds[2]);
    VtkBlocks corners(run);
    for (std::size_t i = 0; i < run.frames().size(); ++i) {
        const Frame frame = run.frame(i);
        VtkPolyData data = corners.data(frame);
        if (!times.contains(i)) continue;
        const FrameHead& head = run.frames()[i];
        const double time = times.at(i);
        blocks.add(std::move(data), run, head, time);
        if (!run.scene().bolts.empty()) bolts.add(vtkBolts(run, frame), run, head, time);
        contacts.add(vtkContacts(run, frame), run, head, time);
    }
    for (const Series* series : {&blocks, &bolts, &contacts}) series->close();
    part.putInPlace();
}

}  // namespace keyblock
