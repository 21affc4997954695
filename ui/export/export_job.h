// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exports in the background, from the run's store, so that neither the window nor a run
// in progress waits for it. Only charts are drawn in the window's thread, a fraction of
// a second each.
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
    std::filesystem::path out;  // a file; for everything a folder
    FigureRequest figure;
    bool withData = false;  // also the data of a figure, as CSV files next to it
    TableKind table = TableKind::History;
    int perSecond = 12;
};

class ExportJob : public QObject {
    Q_OBJECT

public:
    explicit ExportJob(QObject* parent = nullptr);
    /// Stops and waits.
    ~ExportJob() override;

    /// \pre it is not busy.
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

/// Whether the run has data for a figure; figures without data are omitted when everything is exported.
bool isThere(const RunSource& run, FigureKind kind);

}  // namespace keyblock
