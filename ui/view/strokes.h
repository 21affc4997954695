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

/// Name of a vertex attribute with four components, which each corner of a line has in addition to its position. The
/// first two are the vector from the start to the end of the line [m]. The third is the line width relative to that of
/// the layer; its sign gives the side of the line on which the corner lies. The fourth gives the end of the line at
/// which the corner lies (−1: start, 1: end).
inline constexpr const char* strokeWay = "strokeWay";

/// Sets the shaders that draw lines on an actor whose mapper has the attribute `strokeWay`. All lines are drawn at the
/// depth `depth`. VTK discards triangles without area, so the corners passed to VTK must differ in depth.
void paintStrokes(vtkActor& actor, float depth);

/// Sets the width of the lines and the scale and size of the view, all in device pixels.
void setStrokes(vtkActor& actor, double width, double pixelsPerMetre, double viewWidth, double viewHeight);

}  // namespace keyblock
