// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a report in the background, by the same code as `keyblock report`. Only charts are
// painted in the window's thread.
#pragma once

#include "ui/document/background.h"
#include "ui/report/stored/stored_report.h"

#include <QObject>

#include <atomic>
#include <string>

namespace keyblock {

/// A report with the template that the user chose in the window, if that is not in a file yet.
struct ReportTask {
    ReportOrder order;
    std::string templateText{};  // written to `order.layout` first; empty: nothing is written
};

class ReportJob : public QObject {
    Q_OBJECT

public:
    explicit ReportJob(QObject* parent = nullptr);
    /// Stops the report and waits for its thread.
    ~ReportJob() override;

    /// \pre no report is in progress.
    void start(ReportTask task);
    void stop() { stop_ = true; }
    bool isBusy() const { return busy_; }

Q_SIGNALS:
    void advanced(const QString& what, double done);
    void ended(const QString& message, bool isError, bool isWritten);

private:
    Background::Result work(ReportTask task);
    QString perform(ReportTask& task);
    void inWindow(const std::function<void()>& task);
    void advance(const std::string& heading, double done);

    std::atomic<bool> stop_{false}, ended_{true};
    bool busy_ = false;
    Background working_;
};

}  // namespace keyblock
