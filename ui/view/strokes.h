// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines with a width in pixels, round ends and smooth edges, independent of the line
// drawing of the GPU: each line has four corners, which the vertex shader moves apart,
// and its edge is blended. This costs a tenth of fourfold multisampling.
#pragma once

#include <cstddef>

class vtkActor;

namespace keyblock {

/// Name of the vertex attribute of each line corner, in addition to its position. The components are the vector of the
/// line [m] (x, y), the line width relative to the line width of the layer (its sign gives the side of the line), and
/// the end of the line (−1 or 1).
inline constexpr const char* strokeWay = "strokeWay";

/// Sets the shaders that draw lines on an actor whose mapper has the attribute `strokeWay`. All lines are drawn at the
/// depth `depth`. VTK discards triangles without area, so the corners passed to VTK must differ in depth.
void paintStrokes(vtkActor& actor, float depth);

/// Sets the width of the lines and the scale and size of the view, all in device pixels.
void setStrokes(vtkActor& actor, double width, double pixelsPerMetre, double viewWidth, double viewHeight);

}  // namespace keyblock
