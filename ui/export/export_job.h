// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exports from the run store in the background, so that neither the window nor a run in
// progress has to wait. Only charts are drawn in the window's thread, each within a
// fraction of a second.
#pragma once

#include "ui/document/background.h"
#include "ui/export/export_write.h"

#include <QObject>

#include <atomic>
#include <functional>
#include <string>

namespace keyblock {

enum class ExportWhat { Figure, Numbers, Film, Everything };

struct ExportOrder {
    ExportWhat what = ExportWhat::Figure;
    std::filesystem::path store;
    std::filesystem::path out;  // file to write; a folder to export everything
    FigureRequest figure;
    bool withData = false;  // also writes the data of a figure as CSV files next to it
    TableKind table = TableKind::History;
    int perSecond = 12;
};

class ExportJob : public QObject {
    Q_OBJECT

public:
    explicit ExportJob(QObject* parent = nullptr);
    /// Stops the export and waits for its thread.
    ~ExportJob() override;

    /// \pre no export is in progress.
    void start(ExportOrder order);
    void stop() { stop_ = true; }
    bool isBusy() const { return busy_; }

Q_SIGNALS:
    void advanced(const QString& what, int done, int all);
    void ended(const QString& message, bool isError);

private:
    Background::Result work(const ExportOrder& order);
    QString perform(const ExportOrder& order);
    std::size_t exportEverything(const RunSource& run, const ExportOrder& order);
    std::size_t exportFigures(const RunSource& run, const ExportOrder& order);
    std::size_t paint(const RunSource& run, const FigureRequest& request, bool withData, const std::filesystem::path& out);
    void tell(const QString& what, std::size_t done, std::size_t all);
    void inWindow(const std::function<void()>& task);

    std::atomic<bool> stop_{false}, ended_{true};
    bool busy_ = false;
    Background working_;
};

/// True if the run has data for this kind of figure. Figures without data are left out when everything is exported.
bool isThere(const RunSource& run, FigureKind kind);

}  // namespace keyblock
