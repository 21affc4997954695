// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command that makes a report of the run that is shown.
#pragma once

class QMainWindow;

namespace keyblock {

class Commands;
class ReportWindow;
class TimeCursor;

/// Adds the command file.report. \return its window, which makes reports of studies too
ReportWindow* addReportCommand(QMainWindow& window, Commands& commands, const TimeCursor& cursor);

}  // namespace keyblock
