// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Qt asks for runtime folders and displays that a server does not have and says so;
// none of that concerns a figure, so only what ends the program is passed on.
#include "ui/figure/application.h"

#include <QApplication>
#include <QHashFunctions>

#include <cstdio>

namespace keyblock {

namespace {

void onlyFatal(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtFatalMsg) std::fprintf(stderr, "%s\n", message.toUtf8().constData());
}

}  // namespace

void needApplication() {
    if (QCoreApplication::instance()) return;
    qInstallMessageHandler(onlyFatal);
    qSetGlobalQHashSeed(0);  // fonts stand in a PDF in the order of a hash
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int argc = 1;
    static char name[] = "keyblock";
    static char* argv[] = {name, nullptr};
    new QApplication(argc, argv);  // lives until the process ends: Qt's own statics outlive ours
}

}  // namespace keyblock
