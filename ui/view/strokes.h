// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines with a width in pixels, round ends and smooth edges, whatever the card
// does with lines of its own: each is four corners that the card moves apart, and
// what lies on its rim is blended. Costs a tenth of sampling the picture four times.
#pragma once

#include <cstddef>

class vtkActor;

namespace keyblock {

/// Values that each corner has beside its place: the line's way [m] along x and y; its side by the sign of its width over
/// that of the layer; its end (−1 or 1).
inline constexpr const char* strokeWay = "strokeWay";

/// Gives an actor, whose mapper knows `strokeWay`, the programs that paint lines, all at one depth. VTK throws away
/// triangles without area, so the corners of a line must differ in depth when VTK sees them.
void paintStrokes(vtkActor& actor, float depth);

/// Width of the lines and scale of the view, both in pixels of the device.
void setStrokes(vtkActor& actor, double width, double pixelsPerMetre, double viewWidth, double viewHeight);

}  // namespace keyblock
