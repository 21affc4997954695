// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/software_gl.h"

#include <QByteArray>
#include <QCoreApplication>

#include <algorithm>
#include <cassert>
#include <thread>

namespace keyblock {

void leaveProcessorsToRuns() {
    assert(!QCoreApplication::instance());
    if (qEnvironmentVariableIsSet("LP_NUM_THREADS")) return;
    // Keeps one processor each for the window's thread and the run's. Without threads of its own, Mesa draws on the
    // window's thread.
    const int others = std::clamp(static_cast<int>(std::thread::hardware_concurrency()) - 2, 0, 8);
    qputenv("LP_NUM_THREADS", QByteArray::number(others));
}

}  // namespace keyblock
