// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/strokes.h"

#include <vtkActor.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace keyblock {

namespace {

// The coordinates of a point relative to a line are in pixels: along the line from its start, and across it. Lines
// thinner than a pixel are drawn fainter.
constexpr const char* cornerValues = R"(//VTK::PositionVC::Dec
in vec4 strokeWay;
out vec2 strokePlace;
out float strokeLength;
out float strokeRim;
out float strokeFaint;
)";

constexpr const char* cornerPlace = R"(//VTK::PositionVC::Impl
  float wayLength = max(length(strokeWay.xy), 1e-9);
  vec2 along = strokeWay.xy / wayLength;
  vec2 aside = vec2(-along.y, along.x);
  float wide = strokeWidth * abs(strokeWay.z);
  strokeFaint = min(wide, 1.0);
  strokeRim = 0.5 * max(wide, 1.0) + 0.5;
  float reach = strokeRim + 0.5, side = sign(strokeWay.z);
  strokeLength = wayLength * strokeScale;
  strokePlace = vec2(strokeWay.w < 0.0 ? -reach : strokeLength + reach, side * reach);
  gl_Position = MCDCMatrix * vec4(vertexMC.xy, strokeDepth, 1.0);
  gl_Position.xy += 2.0 * reach * (strokeWay.w * along + side * aside) * strokePixel * gl_Position.w;
)";

constexpr const char* rimValues = R"(//VTK::PositionVC::Dec
in vec2 strokePlace;
in float strokeLength;
in float strokeRim;
in float strokeFaint;
)";

constexpr const char* rimShader = R"(//VTK::Light::Impl
  float beyond = max(max(-strokePlace.x, strokePlace.x - strokeLength), 0.0);
  float covered = clamp(strokeRim - length(vec2(beyond, strokePlace.y)), 0.0, 1.0);
  if (covered <= 0.0) discard;
  gl_FragData[0].a *= covered * strokeFaint;
)";

}  // namespace

void paintStrokes(vtkActor& actor, float depth) {
    vtkShaderProperty& programs = *actor.GetShaderProperty();
    programs.AddVertexShaderReplacement("//VTK::PositionVC::Dec", true, cornerValues, false);
    programs.AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, cornerPlace, false);
    programs.AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true, rimValues, false);
    programs.AddFragmentShaderReplacement("//VTK::Light::Impl", true, rimShader, false);
    programs.GetVertexCustomUniforms()->SetUniformf("strokeDepth", depth);
    setStrokes(actor, 1.0, 1.0, 1.0, 1.0);
}

void setStrokes(vtkActor& actor, double width, double pixelsPerMetre, double viewWidth, double viewHeight) {
    vtkUniforms& corners = *actor.GetShaderProperty()->GetVertexCustomUniforms();
    const float pixel[2]{static_cast<float>(1.0 / viewWidth), static_cast<float>(1.0 / viewHeight)};
    corners.SetUniformf("strokeWidth", static_cast<float>(width));
    corners.SetUniformf("strokeScale", static_cast<float>(pixelsPerMetre));
    corners.SetUniform2f("strokePixel", pixel);
}

}  // namespace keyblock
