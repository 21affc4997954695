// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One layer of the section on the GPU: points connected to lines or triangles. From one
// frame of a run to the next only the points move, so the connectivity is uploaded only
// if it changes.
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
    std::vector<float> corners;  // x and y of each point, relative to the view's origin [m]
    std::vector<std::uint8_t> colours;  // red, green, blue of each point; empty: colour of the layer
    std::vector<float> widths;  // width of each line relative to that of the layer; empty: 1
    std::vector<int> cells;  // indices of the points of each line (two) or triangle (three)
};

enum class LayerForm { Lines, Triangles };

class Layer {
public:
    /// \param height position of the layer in the stack, from 0 at the bottom. Higher layers cover lower ones.
    Layer(vtkRenderer& renderer, LayerForm form, int height);
    ~Layer();
    Layer(const Layer&) = delete;
    Layer& operator=(const Layer&) = delete;

    /// Shows these shapes instead of the previous ones.
    void show(const LayerShapes& shapes);
    void setColour(const Colour& colour, double opacity = 1.0);
    /// Sets the line width in device pixels.
    void setWidth(double pixels) { width_ = pixels; }
    /// Sets the scale of the view, and its width and height [device px]. Must be called before rendering.
    void setView(double pixelsPerMetre, double width, double height);
    /// How often the connectivity has been rebuilt so far. Used by tests.
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
