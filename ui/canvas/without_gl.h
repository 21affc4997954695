// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panel shown in place of the section if the display has no OpenGL: what is missing and
// how to get it. The rest of the window still works.
#pragma once

class QString;
class QWidget;

namespace keyblock {

QWidget* makeWithoutGlPanel(const QString& missing, QWidget* parent);

}  // namespace keyblock
