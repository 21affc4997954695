// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A display without OpenGL is detected before any OpenGL widget is created.
#include "tests/ui/screen/screen.h"
#include "ui/canvas/display_check.h"
#include "ui/canvas/glx_check.h"
#include "ui/canvas/without_gl.h"

#include <QLabel>
#include <QProcess>
#include <QWidget>

#include <gtest/gtest.h>

#include <memory>

namespace keyblock {
namespace {

/// Restores an environment variable.
class Variable {
public:
    Variable(const char* name, const QByteArray& value) : name_(name), before_(qgetenv(name)) { qputenv(name, value); }
    ~Variable() { before_.isNull() ? qunsetenv(name_) : qputenv(name_, before_); }

private:
    const char* name_;
    QByteArray before_;
};

TEST(DisplayCheck, TestScreenHasOpenGl) {
    NEED_SCREEN();
    EXPECT_TRUE(glxWorks());
    EXPECT_FALSE(missingOpenGl());
}

TEST(DisplayCheck, ScreenWithoutGlxHasNoOpenGl) {
    NEED_SCREEN();
    QProcess server;
    server.start("Xvfb", {"-displayfd", "1", "-screen", "0", "320x200x24", "-nolisten", "tcp", "-extension", "GLX"});
    ASSERT_TRUE(server.waitForReadyRead(10000));
    const Variable display("DISPLAY", ':' + server.readAllStandardOutput().trimmed());
    EXPECT_FALSE(glxWorks());
    server.terminate();
    server.waitForFinished(5000);
}

TEST(DisplayCheck, MissingScreenHasNoOpenGl) {
    const Variable display("DISPLAY", ":9987");
    EXPECT_FALSE(glxWorks());
}

TEST(DisplayCheck, PanelShowsAllInstructionsInASmallWindow) {
    NEED_SCREEN();
    const std::unique_ptr<QWidget> panel(makeWithoutGlPanel("This display has no OpenGL.", nullptr));
    panel->resize(700, 420);
    panel->show();
    settle();
    const auto* message = panel->findChild<QLabel*>("withoutGlMessage");
    ASSERT_TRUE(message);
    EXPECT_TRUE(message->text().contains("LIBGL_ALWAYS_SOFTWARE=1"));
    EXPECT_GE(message->height(), message->heightForWidth(message->width()));
    EXPECT_TRUE(panel->rect().contains(message->geometry()));
}

}  // namespace
}  // namespace keyblock
