// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program `keyblock-studio [SCENE.json | RUN.kbrun]`.
#include "app/start/blas_choice.h"
#include "solver/files/program_version.h"
#include "ui/look/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/software_gl.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

constexpr int noDisplayCode = 2;
constexpr std::chrono::seconds longestEnd{30};

/// Takes the place of Qt's abort if no window can be shown, as without a display.
void endWithReason(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type != QtFatalMsg) return;
    const bool noDisplay = qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
    QByteArray why = noDisplay ? QByteArray("there is no display (DISPLAY is not set)")
                               : message.section('\n', 0, 0).toLocal8Bit();
    if (!noDisplay && message.contains("platform plugin"))
        why = "the display " + (qgetenv("DISPLAY") + ' ' + qgetenv("WAYLAND_DISPLAY")).trimmed() + " cannot be used";
    std::fprintf(stderr,
                 "error: no window can be shown: %s; log in to a desktop or give a display, or use the program "
                 "keyblock, which needs none\n",
                 why.constData());
    std::_Exit(noDisplayCode);
}

/// Work in the background ends when its window is closed. The program ends even if some of it does not: everything that
/// was saved is complete on the disk, and a run can be resumed.
void endSoon(int code) {
    std::thread([code] {
        std::this_thread::sleep_for(longestEnd);
        std::_Exit(code);
    }).detach();
}

}  // namespace

int main(int argc, char** argv) {
    keyblock::chooseBlas();
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    keyblock::leaveProcessorsToRuns();
    qInstallMessageHandler(endWithReason);
    QApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
    QCoreApplication::setApplicationName("keyblock-studio");
    QCoreApplication::setOrganizationName("keyblock");
    QApplication::setWindowIcon(QIcon(":/icons/app.svg"));
    QCoreApplication::setApplicationVersion(QString::fromUtf8(keyblock::programVersion().data(), int(keyblock::programVersion().size())));
    QCommandLineParser parser;
    const auto description = QCoreApplication::translate(
        "main", "Draw a blocky rock mass, place rock bolts, run the analysis and view the results.");
    parser.setApplicationDescription(description);
    parser.addHelpOption();
    parser.addVersionOption();
    const auto file = QCoreApplication::translate("main", "A scene (.json) or a run (.kbrun) to open.");
    parser.addPositionalArgument("file", file, "[SCENE.json | RUN.kbrun]");
    parser.process(application);
    keyblock::Themes themes;
    keyblock::MainWindow window(themes);
    window.show();
    window.begin(parser.positionalArguments().value(0));
    const int code = QApplication::exec();
    endSoon(code);
    return code;
}
