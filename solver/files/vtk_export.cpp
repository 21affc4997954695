// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every frame is loaded once, in order, also those that are not written: where
// displacements begin anew, they count from the last frame before.
#include "solver/files/vtk_export.h"

#include "solver/files/vtk_frame.h"
#include "solver/files/whole_file.h"
#include "solver/results/words.h"
#include "solver/run/errors.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
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

/// A folder under another name until all of it is written; removed if it is not.
class PartFolder {
public:
    explicit PartFolder(const fs::path& folder) : shown_(folder) {
        std::error_code error;
        target_ = fs::weakly_canonical(folder, error);
        if (error) fail(folder, error);
        if (!target_.has_filename()) target_ = target_.parent_path();
        checkTarget();
        part_ = partPath(target_);
        fs::remove_all(part_, error);
        if (!fs::create_directory(part_, error)) fail(folder, error);
    }
    ~PartFolder() {
        std::error_code ignored;
        fs::remove_all(part_, ignored);
    }
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    const fs::path& path() const { return part_; }

    void putInPlace() const {
        std::error_code error;
        fs::path old = part_;
        old += "-old";
        const bool replaced = fs::exists(target_, error);
        if (replaced) fs::rename(target_, old, error);
        if (!error) fs::rename(part_, target_, error);
        std::error_code ignored;
        if (error) fs::rename(old, target_, ignored);
        if (error) fail(shown_, error);
        fs::remove_all(old, ignored);
    }

private:
    void checkTarget() const {
        std::error_code error;
        const fs::file_status status = fs::status(target_, error);
        if (!fs::exists(status)) return;
        if (!fs::is_directory(status))
            throw CannotWrite("cannot write " + shown_.string() + ": it is no folder; choose another name");
        for (const auto& entry : fs::directory_iterator(target_, error))
            if (const std::string name = entry.path().filename().string(); !isOurs(name))
                throw CannotWrite("cannot write " + shown_.string() + ": the folder holds " + inQuotes(name) +
                                  ", which is no part of such an export; choose a new or an empty folder");
        if (error) fail(shown_, error);
    }

    fs::path shown_;
    fs::path target_;
    fs::path part_;
};

/// One time series.
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
        writeWholeFile(folder_ / file, [&](std::ostream& out) { writeVtkPolyData(data, out); });
        moments_.push_back({time, file});
    }

    void close() const {
        if (!moments_.empty())
            writeWholeFile(folder_ / (kind_ + ".pvd"), [&](std::ostream& out) { writeVtkCollection(moments_, out); });
    }

private:
    fs::path folder_;
    std::string kind_;
    std::vector<VtkMoment> moments_;
};

/// When each stage begins, in the time of the whole run.
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

/// The last frame of each moment that the filter selects.
std::set<std::size_t> framesOf(const RunSource& run, const TableFilter& filter, const std::map<int, double>& starts) {
    std::vector<Moment> moments;
    for (const FrameHead& head : run.frames()) moments.push_back({head.stage, head.time});
    std::map<double, std::size_t> lastAt;
    for (const std::size_t i : selected(moments, filter, When::All))
        lastAt[starts.at(moments[i].stage) + moments[i].time] = i;
    std::set<std::size_t> frames;
    for (const auto& [time, frame] : lastAt) frames.insert(frame);
    return frames;
}

}  // namespace

void writeVtkFolder(const RunSource& run, const TableFilter& filter, const fs::path& folder) {
    const PartFolder part(folder);
    const std::map<int, double> starts = stageStarts(run);
    const std::set<std::size_t> wanted = framesOf(run, filter, starts);
    Series blocks(part.path(), kinds[0]), bolts(part.path(), kinds[1]), contacts(part.path(), kinds[2]);
    VtkBlocks corners(run);
    for (std::size_t i = 0; i < run.frames().size(); ++i) {
        const Frame frame = run.frame(i);
        VtkPolyData data = corners.data(frame);
        if (!wanted.contains(i)) continue;
        const FrameHead& head = run.frames()[i];
        const double time = starts.at(head.stage) + head.time;
        blocks.add(std::move(data), run, head, time);
        if (!run.scene().bolts.empty()) bolts.add(vtkBolts(run, frame), run, head, time);
        contacts.add(vtkContacts(run, frame), run, head, time);
    }
    for (const Series* series : {&blocks, &bolts, &contacts}) series->close();
    part.putInPlace();
}

}  // namespace keyblock
