// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/layer.h"

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
    actor_->ForceOpaqueOn();  // layers are painted in their order, whatever their opacity
    actor_->VisibilityOff();
    renderer_.AddActor(actor_);
}

Layer::~Layer() { renderer_.RemoveActor(actor_); }

void Layer::join(const std::vector<int>& cells) {
    cells_ = cells;
    ++joinings_;
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
    std::copy(cells.begin(), cells.end(), corners->GetPointer(0));
    vtkNew<vtkCellArray> joined;
    joined->SetData(form_ == LayerForm::Lines ? 2 : 3, corners);
    if (form_ == LayerForm::Lines) data_->SetLines(joined);
    else data_->SetPolys(joined);
}

void Layer::show(const LayerShapes& shapes) {
    const auto count = static_cast<vtkIdType>(shapes.corners.size() / 2);
    actor_->SetVisibility(!shapes.cells.empty());
    if (shapes.cells.empty()) return;
    places_->SetNumberOfTuples(count);
    float* place = places_->GetPointer(0);
    for (std::size_t i = 0; i + 1 < shapes.corners.size(); i += 2) {
        *place++ = shapes.corners[i];
        *place++ = shapes.corners[i + 1];
        *place++ = depth_;
    }
    places_->Modified();
    data_->GetPoints()->Modified();
    mapper_->SetScalarVisibility(!shapes.colours.empty());
    if (!shapes.colours.empty()) {
        colours_->SetNumberOfTuples(count);
        std::copy(shapes.colours.begin(), shapes.colours.end(), colours_->GetPointer(0));
        colours_->Modified();
        data_->GetPointData()->SetScalars(colours_);
    } else {
        data_->GetPointData()->SetScalars(nullptr);
    }
    if (cells_ != shapes.cells) join(shapes.cells);
    data_->Modified();
}

void Layer::setColour(const Colour& colour, double opacity) {
    actor_->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    actor_->GetProperty()->SetOpacity(std::min(opacity, 0.999));
}

void Layer::setWidth(double pixels) { actor_->GetProperty()->SetLineWidth(static_cast<float>(pixels)); }

}  // namespace keyblock
