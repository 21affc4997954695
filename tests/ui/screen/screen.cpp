// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/screen/screen.h"

#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cstdlib>
#include <string>

#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace keyblock {

namespace {

pid_t server = 0;

void stopServer() {
    if (server > 0) {
        kill(server, SIGTERM);
        waitpid(server, nullptr, 0);
    }
}

/// Number of the display that a new Xvfb chose; empty when it did not start.
std::string startServer() {
    int ends[2];
    if (pipe(ends) != 0) return {};
    server = fork();
    if (server == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);  // it ends with a test that crashes
        const std::string end = std::to_string(ends[1]);
        execlp("Xvfb", "Xvfb", "-displayfd", end.c_str(), "-screen", "0", "1600x1000x24", "-nolisten", "tcp",
               static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    std::string number;
    for (char c; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    return number;
}

/// Settings, data and runtime files of the tests go to a folder that is gone with the process.
void useFolder(const QTemporaryDir& folder) {
    const QByteArray path = folder.path().toUtf8();
    for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"})
        qputenv(name, path);
    qputenv("QT_QPA_PLATFORM", "xcb");
    qunsetenv("QT_SCALE_FACTOR");
}

bool start() {
    if (QStandardPaths::findExecutable("Xvfb").isEmpty()) return false;
    static QTemporaryDir folder;
    useFolder(folder);
    const std::string number = startServer();
    if (number.empty()) return false;
    std::atexit(stopServer);
    qputenv("DISPLAY", (":" + number).c_str());
    static int argc = 1;
    static char name[] = "keyblock-tests";
    static char* argv[] = {name, nullptr};
    // Never destroyed: static parts of Qt, its cache of pixmaps among them, go before what is static here.
    new QApplication(argc, argv);
    QCoreApplication::setOrganizationName("keyblock");
    QCoreApplication::setApplicationName("keyblock-tests");
    return true;
}

}  // namespace

void settle() {
    constexpr int rounds = 5;  // each waits for the X server and runs the timers of 0 ms twice
    for (int i = 0; i < rounds; ++i) {
        QGuiApplication::sync();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

bool haveScreen() {
    static const bool started = start();
    return started;
}

}  // namespace keyblock
