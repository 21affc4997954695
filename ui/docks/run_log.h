// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Messages of the runs, one per line, each with the time of day.
#pragma once

#include <QPlainTextEdit>

namespace keyblock {

class Themes;

class RunLog : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit RunLog(const Themes& themes, QWidget* parent = nullptr);

    void tell(const QString& message, bool isError);

private:
    const Themes& themes_;
};

}  // namespace keyblock
