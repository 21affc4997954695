// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks whether the display can show renderings by VTK, before any VTK widget is
// created: without OpenGL, these would terminate the program or stay black.
#pragma once

#include <QString>
#include <QSurfaceFormat>

#include <optional>

namespace keyblock {

/// The OpenGL version and profile that VTK needs for the section.
QSurfaceFormat sectionFormat();

/// Error message that says why the display cannot show the section; null if OpenGL 3.2 works. The display is checked
/// once per process.
const std::optional<QString>& missingOpenGl();

}  // namespace keyblock
