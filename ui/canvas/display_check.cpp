// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/display_check.h"

#include "ui/canvas/glx_check.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace keyblock {

namespace {

struct DisplayTexts {
    Q_DECLARE_TR_FUNCTIONS(DisplayCheck)
};

/// Creates an OpenGL context like that of the section on an off-screen surface. \return an error text if this fails.
std::optional<QString> tryContext() {
    QOpenGLContext context;
    context.setFormat(sectionFormat());
    if (!context.create()) return DisplayTexts::tr("OpenGL is not available on this display.");
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return DisplayTexts::tr("OpenGL cannot be initialised on this display.");
    const QPair<int, int> version = context.format().version();
    context.doneCurrent();
    if (version >= qMakePair(3, 2)) return std::nullopt;
    return DisplayTexts::tr("This display provides OpenGL %1.%2; the section view requires OpenGL 3.2 or later.")
        .arg(version.first)
        .arg(version.second);
}

std::optional<QString> check() {
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal")
        return DisplayTexts::tr("The Qt platform '%1' does not support OpenGL.").arg(platform);
    if (platform == "xcb" && !glxWorks()) return DisplayTexts::tr("This display does not support OpenGL (GLX).");
    return tryContext();
}

}  // namespace

QSurfaceFormat sectionFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

const std::optional<QString>& missingOpenGl() {
    static const std::optional<QString> missing = check();
    return missing;
}

}  // namespace keyblock
