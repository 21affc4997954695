// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program `keyblock-studio [SCENE.json | RUN.kbrun]`.
#include "solver/files/program_version.h"
#include "ui/look/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/software_gl.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    keyblock::leaveProcessorsToRuns();
    QApplication application(argc, argv);
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
    return QApplication::exec();
}
