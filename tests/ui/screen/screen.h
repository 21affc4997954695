// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A screen of their own for tests of the window, so that they run on a server and
// never show on anybody's desk.
#pragma once

#include <QObject>

namespace keyblock {

/// Starts Xvfb and the application once per process. False where Xvfb is not installed; the test is then skipped.
bool haveScreen();

/// Handles events until `done`; false if it is not within `milliseconds`, a limit that only ends a broken test.
template <typename Done>
bool waitFor(Done done, int milliseconds = 60000);

/// Handles all events and those that follow from them, among them answers of the X server, timers of 0 ms and
/// deferred deletions.
void settle();

}  // namespace keyblock

/// First line of a test that shows a widget.
#define NEED_SCREEN() \
    if (!keyblock::haveScreen()) GTEST_SKIP() << "Xvfb is not installed"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>

template <typename Done>
bool keyblock::waitFor(Done done, int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (!done()) {
        if (timer.elapsed() > milliseconds) return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        QThread::msleep(1);
    }
    return true;
}
