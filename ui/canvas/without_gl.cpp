// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/without_gl.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QWidget>

namespace keyblock {

namespace {

struct WithoutGlTexts {
    Q_DECLARE_TR_FUNCTIONS(WithoutGl)
};

QString howToGoOn() {
    return WithoutGlTexts::tr("<p>Panels, checks, runs and tables still work. To see the section:</p>"
                "<ul>"
                "<li>on this machine, install software OpenGL: <code>apt install libgl1-mesa-dri libglx-mesa0</code>, "
                "and start the program with <code>LIBGL_ALWAYS_SOFTWARE=1 keyblock-studio</code>;</li>"
                "<li>over a remote connection, unset <code>LIBGL_ALWAYS_INDIRECT</code>, or use a display that has GLX "
                "(<code>Xvfb +extension GLX</code>, a VNC or X2Go session);</li>"
                "<li>without a display, run the scene with <code>keyblock run</code> on the command line and draw the "
                "section with <code>keyblock export --figure</code>.</li>"
                "</ul>");
}

}  // namespace

QWidget* makeWithoutGlPanel(const QString& missing, QWidget* parent) {
    auto* panel = new QWidget(parent);
    panel->setObjectName("withoutGl");
    panel->setAccessibleName(WithoutGlTexts::tr("The section cannot be shown"));
    auto* message = new QLabel(QStringLiteral("<h3>%1</h3><p>%2</p>%3")
                                   .arg(WithoutGlTexts::tr("The section cannot be shown here"), missing.toHtmlEscaped(),
                                        howToGoOn()),
                               panel);
    message->setObjectName("withoutGlMessage");
    message->setWordWrap(true);
    message->setTextFormat(Qt::RichText);
    message->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    message->setFixedWidth(560);
    auto* layout = new QGridLayout(panel);
    layout->addWidget(message, 1, 1);
    for (const int outer : {0, 2}) {
        layout->setRowStretch(outer, 1);
        layout->setColumnStretch(outer, 1);
    }
    return panel;
}

}  // namespace keyblock
