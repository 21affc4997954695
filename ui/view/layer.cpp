// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/layer.h"

#include "ui/view/strokes.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <tuple>

namespace keyblock {

Layer::Layer(vtkRenderer& renderer, LayerForm form, int height)
    : renderer_(renderer), form_(form), depth_(0.01f * static_cast<float>(height)) {
    places_->SetNumberOfComponents(3);
    colours_->SetNumberOfComponents(3);
    vtkNew<vtkPoints> points;
    points->SetData(places_);
    data_->SetPoints(points);
    mapper_->SetInputData(data_);
    mapper_->SetColorModeToDirectScalars();
    mapper_->SetScalarModeToUsePointData();
    mapper_->ScalarVisibilityOff();
    mapper_->StaticOn();
    actor_->SetMapper(mapper_);
    actor_->GetProperty()->LightingOff();
    actor_->ForceOpaqueOn();  // layers are painted in order regardless of opacity
    actor_->VisibilityOff();
    if (form == LayerForm::Lines) {
        ways_->SetName(strokeWay);
        ways_->SetNumberOfComponents(4);
        data_->GetPointData()->AddArray(ways_);
        mapper_->MapDataArrayToVertexAttribute(strokeWay, strokeWay, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
        paintStrokes(*actor_, depth_);
    }
    renderer_.AddActor(actor_);
}

Layer::~Layer() { renderer_.RemoveActor(actor_); }

void Layer::join(const std::vector<int>& cells) {
    if (cells_ == cells) return;
    cells_ = cells;
    ++joinings_;
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
    std::copy(cells.begin(), cells.end(), corners->GetPointer(0));
    vtkNew<vtkCellArray> joined;
    joined->SetData(3, corners);
    data_->SetPolys(joined);
}

void Layer::setCount(std::size_t corners, bool coloured) {
    const auto count = static_cast<vtkIdType>(corners);
    places_->SetNumberOfTuples(count);
    if (form_ == LayerForm::Lines) ways_->SetNumberOfTuples(count);
    colours_->SetNumberOfTuples(coloured ? count : 0);
    mapper_->SetScalarVisibility(coloured);
    data_->GetPointData()->SetScalars(coloured ? colours_.Get() : nullptr);
}

void Layer::show(const LayerShapes& shapes) {
    actor_->SetVisibility(!shapes.cells.empty());
    if (shapes.cells.empty()) return;
    if (form_ == LayerForm::Lines) showLines(shapes);
    else showTriangles(shapes);
    for (vtkDataArray* changed : {static_cast<vtkDataArray*>(places_), static_cast<vtkDataArray*>(ways_),
                                  static_cast<vtkDataArray*>(colours_)})
        changed->Modified();
    data_->GetPoints()->Modified();
    data_->Modified();
}

void Layer::showTriangles(const LayerShapes& shapes) {
    setCount(shapes.corners.size() / 2, !shapes.colours.empty());
    float* place = places_->GetPointer(0);
    for (std::size_t i = 0; i + 1 < shapes.corners.size(); i += 2) {
        *place++ = shapes.corners[i];
        *place++ = shapes.corners[i + 1];
        *place++ = depth_;
    }
    std::copy(shapes.colours.begin(), shapes.colours.end(), colours_->GetPointer(0));
    join(shapes.cells);
}

/// Each line has two vertices at each end, which the GPU moves apart to give the line its width.
void Layer::showLines(const LayerShapes& shapes) {
    const std::size_t lines = shapes.cells.size() / 2;
    setCount(4 * lines, !shapes.colours.empty());
    float *place = places_->GetPointer(0), *way = ways_->GetPointer(0);
    std::uint8_t* colour = colours_->GetPointer(0);
    for (std::size_t i = 0; i < lines; ++i) {
        const std::size_t from = shapes.cells[2 * i];
        const std::size_t to = shapes.cells[2 * i + 1];
        const float* a = &shapes.corners[2 * from];
        const float* b = &shapes.corners[2 * to];
        const float width = shapes.widths.empty() ? 1.0f : shapes.widths[i];
        for (const auto& [end, corner, side] : {std::tuple(-1.0f, from, -1.0f), std::tuple(-1.0f, from, 1.0f),
                                                std::tuple(1.0f, to, -1.0f), std::tuple(1.0f, to, 1.0f)}) {
            for (const float value : {shapes.corners[2 * corner], shapes.corners[2 * corner + 1], 0.5f * side})
                *place++ = value;
            for (const float value : {b[0] - a[0], b[1] - a[1], side * width, end}) *way++ = value;
            if (!shapes.colours.empty()) colour = std::copy_n(&shapes.colours[3 * corner], 3, colour);
        }
    }
    std::vector<int> cells;
    cells.reserve(6 * lines);
    for (int first = 0; first < static_cast<int>(4 * lines); first += 4)
        for (const int corner : {0, 1, 2, 2, 1, 3}) cells.push_back(first + corner);
    join(cells);
}

void Layer::setView(double pixelsPerMetre, double width, double height) {
    if (form_ == LayerForm::Lines) setStrokes(*actor_, width_, pixelsPerMetre, width, height);
}

void Layer::setColour(const Colour& colour, double opacity) {
    actor_->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    actor_->GetProperty()->SetOpacity(opacity);
}

}  // namespace keyblock
