// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands in place of the section where the display has no OpenGL: what is
// missing and how to go on. All else of the window works.
#pragma once

class QString;
class QWidget;

namespace keyblock {

QWidget* makeWithoutGlPanel(const QString& missing, QWidget* parent);

}  // namespace keyblock
