// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One layer of the section on the GPU: corners joined to lines or to triangles. The
// next frame of the same run only moves the corners, so the connectivity is uploaded
// only when it changes.
#pragma once

#include "ui/picture/colour.h"

#include <vtkNew.h>

#include <cstdint>
#include <vector>

class vtkActor;
class vtkCellArray;
class vtkFloatArray;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace keyblock {

struct LayerShapes {
    std::vector<float> corners;  // x, y of each [m from the view's origin]
    std::vector<std::uint8_t> colours;  // red, green, blue of each; empty: colour of the layer
    std::vector<float> widths;  // of each line over that of the layer; empty: 1
    std::vector<int> cells;  // corners of each line (two) or triangle (three)
};

enum class LayerForm { Lines, Triangles };

class Layer {
public:
    /// Higher layers cover lower ones, counted from 0.
    Layer(vtkRenderer& renderer, LayerForm form, int height);
    ~Layer();
    Layer(const Layer&) = delete;
    Layer& operator=(const Layer&) = delete;

    /// Replaces the previous shape.
    void show(const LayerShapes& shapes);
    void setColour(const Colour& colour, double opacity = 1.0);
    /// Width of lines in device pixels.
    void setWidth(double pixels) { width_ = pixels; }
    /// Set before painting: scale and size of the view, in device pixels.
    void setView(double pixelsPerMetre, double width, double height);
    /// How often the connectivity was rebuilt.
    int joinings() const { return joinings_; }

private:
    void showTriangles(const LayerShapes& shapes);
    void showLines(const LayerShapes& shapes);
    void setCount(std::size_t corners, bool coloured);
    void join(const std::vector<int>& cells);

    vtkRenderer& renderer_;
    LayerForm form_;
    float depth_;
    std::vector<int> cells_;
    int joinings_ = 0;
    double width_ = 1.0;
    vtkNew<vtkFloatArray> places_, ways_;
    vtkNew<vtkUnsignedCharArray> colours_;
    vtkNew<vtkPolyData> data_;
    vtkNew<vtkPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

}  // namespace keyblock
