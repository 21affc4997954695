// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_write.h"

#include "solver/files/kept_files.h"
#include "solver/files/movie_file.h"
#include "solver/files/part_folder.h"
#include "solver/files/atomic_file.h"
#include "solver/results/result_names.h"
#include "solver/run/write_error.h"
#include "solver/scene/number_text.h"
#include "ui/figure/animation.h"

namespace keyblock {

namespace {

/// \param files the figure, then its data
void requireFree(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) requireReplaceable(file, {});
    if (std::filesystem::exists(files.front())) return;
    for (std::size_t i = 1; i < files.size(); ++i)
        if (std::filesystem::exists(files[i]))
            throw CannotWrite("cannot write " + files[i].string() +
                              ": it exists and belongs to no earlier export of this figure; choose another name");
}

}  // namespace

std::vector<std::filesystem::path> writeFigureFiles(const RunSource& run, const FigureRequest& request, bool withData,
                                                    const std::filesystem::path& out) {
    std::vector<std::filesystem::path> files{out};
    const Figure figure = paintFigure(run, request);
    if (withData)
        for (const FigureData& data : figure.data)
            files.push_back(out.parent_path() / (out.stem().string() + data.suffix + ".csv"));
    requireFree(files);
    writeAtomically(out, [&](std::ostream& stream) { stream << figure.bytes; });
    for (std::size_t i = 1; i < files.size(); ++i) writeAtomically(files[i], figure.data[i - 1].write);
    return files;
}

void writeTableFile(const RunSource& run, TableKind kind, const TableFilter& filter, const std::filesystem::path& out) {
    requireReplaceable(out, {});
    writeAtomically(out, [&](std::ostream& stream) { writeTable(kind, run, filter, stream); });
}

bool isOfFrame(TableKind kind) {
    return kind == TableKind::Bolts || kind == TableKind::Blocks || kind == TableKind::Contacts ||
           kind == TableKind::Forces || kind == TableKind::Design;
}

std::string frameText(const RunSource& run, const TableFilter& filter) {
    const std::optional<std::size_t> frame = frameAt(run, filter);
    if (!frame) return {};
    const FrameHead& head = run.frames()[*frame];
    return "frame " + std::to_string(*frame + 1) + " of " + std::to_string(run.frames().size()) + ", stage " +
           stageName(run.scene(), head.stage) + " at " + rounded(head.time) +
           (run.scene().stages[head.stage].kind == StageKind::Dynamic ? " s" : "");
}

namespace {

void writeMovie(const Animation& animation, int perSecond, const std::filesystem::path& out, const std::atomic<bool>& stop,
                const std::function<void(std::size_t, std::size_t)>& done) {
    const MovieFormat format = out.extension() == ".webm" ? MovieFormat::WebM : MovieFormat::Mp4;
    MovieFile movie(out, format, {animation.columns(), animation.rows(), perSecond}, stop);
    for (std::size_t i = 0; i < animation.size(); ++i) {
        if (stop) throw ExportStopped();
        movie.add(animation.pixels(i));
        done(i + 1, animation.size());
    }
    movie.finish();
    if (stop) throw ExportStopped();
}

void writePictures(const RunSource& run, const Animation& animation, const std::filesystem::path& folder,
                   const std::atomic<bool>& stop, const std::function<void(std::size_t, std::size_t)>& done) {
    const PartFolder part(folder, isOfPictures);
    for (std::size_t i = 0; i < animation.size(); ++i) {
        if (stop) throw ExportStopped();
        writeAtomically(part.path() / pictureName(i), [&](std::ostream& out) { out << animation.png(i); });
        done(i + 1, animation.size());
    }
    writeAtomically(part.path() / "frames.csv", [&](std::ostream& out) { writePictureList(run, animation, out); });
    part.putInPlace();
}

}  // namespace

void writeFilm(const RunSource& run, const FigureRequest& request, int perSecond, const std::filesystem::path& out,
               const std::atomic<bool>& stop, const std::function<void(std::size_t, std::size_t)>& done) {
    requireReplaceable(out, {});
    const Animation animation(run, request);
    if (out.extension().empty()) writePictures(run, animation, out, stop, done);
    else writeMovie(animation, perSecond, out, stop, done);
}

}  // namespace keyblock
