// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_write.h"

#include "solver/files/movie_file.h"
#include "solver/files/whole_file.h"
#include "ui/figure/animation.h"

namespace keyblock {

bool hasCharts(FigureKind kind) { return kind == FigureKind::Bolt || kind == FigureKind::Curves; }

std::vector<std::filesystem::path> writeFigureFiles(const RunSource& run, const FigureRequest& request,
                                                    const std::filesystem::path& out) {
    std::vector<std::filesystem::path> written{out};
    const Figure figure = paintFigure(run, request);
    writeWholeFile(out, [&](std::ostream& stream) { stream << figure.bytes; });
    for (const FigureData& data : figure.data) {
        written.push_back(out.parent_path() / (out.stem().string() + data.suffix + ".csv"));
        writeWholeFile(written.back(), data.write);
    }
    return written;
}

void writeTableFile(const RunSource& run, TableKind kind, const TableFilter& filter, const std::filesystem::path& out) {
    writeWholeFile(out, [&](std::ostream& stream) { writeTable(kind, run, filter, stream); });
}

void writeFilm(const RunSource& run, const FigureRequest& request, int perSecond, const std::filesystem::path& out,
               const std::atomic<bool>& stop, const std::function<void(std::size_t, std::size_t)>& done) {
    const Animation animation(run, request);
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

}  // namespace keyblock
