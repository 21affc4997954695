// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames are painted one at a time. While ffmpeg encodes a frame, the next one is
// painted.
#include "app/cli/export_animation.h"

#include "app/cli/output.h"
#include "app/cli/stop_signals.h"
#include "solver/files/movie_file.h"
#include "solver/files/part_folder.h"
#include "solver/files/atomic_file.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "ui/figure/animation.h"
#endif

#include <atomic>
#include <cassert>

namespace keyblock::cli {

namespace {

namespace fs = std::filesystem;

/// The format of a video; null: a folder of images.
std::optional<MovieFormat> movieFormatOf(const fs::path& out) {
    const std::string ending = out.extension().string();
    if (ending == ".mp4") return MovieFormat::Mp4;
    if (ending == ".webm") return MovieFormat::WebM;
    if (ending.empty() || fs::is_directory(out)) return std::nullopt;
    throw UsageError("'" + out.string() + "': an animation is written as .mp4 or .webm, or as PNG images into a " +
                     "folder, whose name has no extension");
}

}  // namespace

void checkAnimationOptions(const ExportOptions& options) {
#ifndef KEYBLOCK_HAS_FIGURES
    throw UsageError("this program was built without figures; build it with Qt 5 and QCustomPlot, or export tables");
#endif
    if (!options.out.empty()) throw UsageError("--animation already gives the file to write; omit --out");
    if (options.at) throw UsageError("an animation shows all frames; omit --at, or select a stage with --stage");
    if (options.perSecond && !movieFormatOf(*options.animation))
        throw UsageError("--fps applies to .mp4 and .webm only; omit it for images in a folder");
}

#ifdef KEYBLOCK_HAS_FIGURES

namespace {

constexpr int defaultDpi = 240;  // gives 1512 pixels at the default width

FigureRequest requestOf(const ExportOptions& options, const TableFilter& filter) {
    FigureRequest request;
    request.filter = filter;
    request.quantity = options.quantity;
    request.width = options.width.value_or(request.width);
    request.dpi = options.dpi.value_or(defaultDpi);
    request.factor = options.deformed.value_or(request.factor);
    request.whole = options.whole;
    request.runName = options.run.stem().string();
    return request;
}

struct Stopped {};

/// A run that throws at the next frame once the export is stopped.
class StoppableRun : public RunSource {
public:
    StoppableRun(const RunSource& run, const std::atomic<bool>& stop) : run_(run), stop_(stop) {}

    const Scene& scene() const override { return run_.scene(); }
    const std::vector<std::string>& blockNames() const override { return run_.blockNames(); }
    const HistoryColumns& columns() const override { return run_.columns(); }
    std::vector<StageRecord> stages() const override { return run_.stages(); }
    std::vector<Event> events() const override { return run_.events(); }
    std::vector<HistoryRow> history() const override { return run_.history(); }
    const std::vector<FrameHead>& frames() const override { return run_.frames(); }
    Frame frame(std::size_t index) const override {
        if (stop_) throw Stopped();
        return run_.frame(index);
    }

private:
    const RunSource& run_;
    const std::atomic<bool>& stop_;
};

/// Shows on a terminal how many frames are done; its destructor clears the line.
class PictureCount {
public:
    explicit PictureCount(std::size_t all) : all_(all), isShown_(errorIsTerminal()) {}
    ~PictureCount() {
        if (isShown_) replaceErrorLine("");
    }
    PictureCount(const PictureCount&) = delete;
    PictureCount& operator=(const PictureCount&) = delete;

    void tell(std::size_t done) const {
        if (isShown_) replaceErrorLine("frame " + std::to_string(done) + " of " + std::to_string(all_));
    }

private:
    std::size_t all_;
    bool isShown_;
};

void writeMovie(const Animation& animation, const ExportOptions& options, MovieFormat format,
                const std::atomic<bool>& stop) {
    const MovieShape shape{animation.columns(), animation.rows(), options.perSecond.value_or(MovieShape{}.perSecond)};
    MovieFile movie(*options.animation, format, shape, stop);
    const PictureCount count(animation.size());
    for (std::size_t i = 0; i < animation.size(); ++i) {
        movie.add(animation.pixels(i));
        count.tell(i + 1);
    }
    movie.finish();
}

void writeFolder(const RunSource& run, const Animation& animation, const fs::path& folder) {
    const PartFolder part(folder, isOfPictures);
    const PictureCount count(animation.size());
    for (std::size_t i = 0; i < animation.size(); ++i) {
        writeAtomically(part.path() / pictureName(i), [&](std::ostream& out) { out << animation.png(i); });
        count.tell(i + 1);
    }
    writeAtomically(part.path() / "frames.csv", [&](std::ostream& out) { writePictureList(run, animation, out); });
    part.putInPlace();
}

}  // namespace

ExitCode exportAnimation(const ExportOptions& options, const RunSource& run, const TableFilter& filter) {
    assert(options.animation);
    std::atomic<bool> stop{false};
    const StopSignals signals(stop);
    try {
        const StoppableRun frames(run, stop);
        const Animation animation(frames, requestOf(options, filter));
        if (const auto format = movieFormatOf(*options.animation)) writeMovie(animation, options, *format, stop);
        else writeFolder(run, animation, *options.animation);
    } catch (const CannotDraw& problem) {
        throw UsageError(problem.what());
    } catch (const Stopped&) {
    }
    if (!stop) return Done;
    printErrorLine("interrupted; " + options.animation->string() + " is unchanged");
    return Interrupted;
}

#else

ExitCode exportAnimation(const ExportOptions& options, const RunSource&, const TableFilter&) {
    checkAnimationOptions(options);
    return Usage;
}

#endif

}  // namespace keyblock::cli
