// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines with a width in pixels, round ends and smooth edges, independent of the
// GPU's own line drawing: each has four corners that the GPU moves apart, and its
// rim is blended. Costs a tenth of fourfold multisampling.
#pragma once

#include <cstddef>

class vtkActor;

namespace keyblock {

/// Attributes of each corner besides its position: the line's vector [m]; its side by the sign of its width over
/// that of the layer; its end (−1 or 1).
inline constexpr const char* strokeWay = "strokeWay";

/// Sets the shaders that paint lines on an actor whose mapper has `strokeWay`, all at one depth. VTK discards
/// triangles without area, so the corners of a line must differ in depth when VTK sees them.
void paintStrokes(vtkActor& actor, float depth);

/// Width of the lines and scale of the view, both in pixels of the device.
void setStrokes(vtkActor& actor, double width, double pixelsPerMetre, double viewWidth, double viewHeight);

}  // namespace keyblock
