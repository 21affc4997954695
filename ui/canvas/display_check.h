// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether this display can show what VTK paints, asked before any of VTK's widgets
// is made: on a display without OpenGL those end the program or stay black.
#pragma once

#include <QString>
#include <QSurfaceFormat>

#include <optional>

namespace keyblock {

/// The OpenGL that VTK paints the section with.
QSurfaceFormat sectionFormat();

/// What is missing, as one sentence; nothing where OpenGL 3.2 works. Asks once per process.
const std::optional<QString>& missingOpenGl();

}  // namespace keyblock
