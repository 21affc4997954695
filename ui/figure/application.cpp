// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Qt warns about runtime folders and displays that a server does not have; figures do
// not need them, so only fatal messages are passed on.
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
    qSetGlobalQHashSeed(0);  // otherwise the order of the fonts in a PDF would be random
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int argc = 1;
    static char name[] = "keyblock";
    static char* argv[] = {name, nullptr};
    new QApplication(argc, argv);  // never deleted: Qt's own statics are destroyed later
}

}  // namespace keyblock
