// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/section_view.h"

#include "ui/picture/section/detail.h"
#include "ui/view/force_shapes.h"
#include "ui/view/layer.h"
#include "ui/view/screen_sizes.h"
#include "ui/view/section_shapes.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <array>

namespace keyblock {

namespace {

constexpr double borderWidth = 1.2, wallWidth = 2.0, selectedWidth = 9.0;  // [px]
constexpr double seamsOfJoints = 0.8, seamOpacity = 0.35;

}  // namespace

/// The layers, from bottom to top.
struct SectionView::Layers {
    explicit Layers(vtkRenderer& to)
        : openings(to, LayerForm::Triangles, 0), blocks(to, LayerForm::Triangles, 1), joints(to, LayerForm::Lines, 2),
          seams(to, LayerForm::Lines, 3), borders(to, LayerForm::Lines, 4), walls(to, LayerForm::Lines, 5),
          moved(to, LayerForm::Lines, 6), rims(to, LayerForm::Lines, 7), forces(to, LayerForm::Lines, 8),
          selected(to, LayerForm::Lines, 9), casings(to, LayerForm::Lines, 10), shanks(to, LayerForm::Lines, 11) {}

    std::array<Layer*, 12> all() {
        return {&openings, &blocks, &joints, &seams, &borders, &walls,
                &moved, &rims, &forces, &selected, &casings, &shanks};
    }

    Layer openings, blocks, joints, seams, borders, walls, moved, rims, forces, selected, casings, shanks;
};

SectionView::SectionView(vtkRenderer& renderer) : renderer_(renderer), layers_(std::make_unique<Layers>(renderer)) {
    renderer_.GetActiveCamera()->ParallelProjectionOn();
    renderer_.TwoSidedLightingOff();
}

SectionView::~SectionView() = default;

void SectionView::paint(const ViewColours& colours, const ViewStyle& style) {
    colours_ = colours;
    pixelRatio_ = style.pixelRatio;
    const auto share = [](std::uint8_t value) { return value / 255.0; };
    renderer_.SetBackground(share(colours.ground.red), share(colours.ground.green), share(colours.ground.blue));
    Layers& on = *layers_;
    on.openings.setColour(colours.opening);
    on.joints.setColour(colours.joint, colours.jointOpacity);
    on.seams.setColour(colours.joint, seamOpacity);
    for (Layer* edge : {&on.borders, &on.walls, &on.moved}) edge->setColour(colours.wall);
    on.selected.setColour(colours.accent);
    on.casings.setColour(colours.casing);
    on.borders.setWidth(borderWidth * pixelRatio_);
    for (Layer* edge : {&on.walls, &on.moved}) edge->setWidth(wallWidth * pixelRatio_);
    on.selected.setWidth(selectedWidth * pixelRatio_);
    for (Layer* sized : {&on.rims, &on.forces}) sized->setWidth(pixelRatio_);
}

void SectionView::show(const SectionPicture& picture, const ViewColours& colours, const ViewStyle& style) {
    paint(colours, style);
    origin_ = 0.5 * (picture.model.min + picture.model.max);
    const SectionShapes shapes(picture, origin_);
    Layers& on = *layers_;
    on.openings.show(shapes.openings());
    on.blocks.show(shapes.blocks(colours, style.drawing));
    on.joints.show(shapes.outlines());
    on.seams.show(shapes.lines(picture.seams));
    on.borders.show(shapes.lines(picture.borders));
    on.walls.show(shapes.lines(picture.walls));
    on.selected.show(shapes.whole(style.selectedBolts));
    on.casings.show(shapes.shanks(nullptr));
    on.shanks.show(shapes.shanks(&colours));
    laidAt_ = 0.0;
}

void SectionView::clear(const ViewColours& colours) {
    paint(colours, {});
    for (Layer* layer : layers_->all()) layer->show({});
}

void SectionView::look(const Point& centre, double metresPerPixel, const Point& size, const SectionPicture* picture) {
    const bool isSized = laidAt_ == metresPerPixel;
    const bool isSeen = isSized && seenFrom_ == centre && seenSize_ == size;
    laidAt_ = metresPerPixel;
    seenFrom_ = centre;
    seenSize_ = size;
    const Point reach = 0.5 * metresPerPixel * size;
    if (picture && !isSized) laySized(*picture);
    if (picture && (!isSized || (picture->contacts && !isSeen))) layForces(*picture, {centre - reach, centre + reach});
    vtkCamera& camera = *renderer_.GetActiveCamera();
    const Point at = centre - origin_;
    camera.SetFocalPoint(at.x(), at.y(), 0.0);
    camera.SetPosition(at.x(), at.y(), 10.0);
    camera.SetViewUp(0.0, 1.0, 0.0);
    camera.SetParallelScale(0.5 * size.y() * metresPerPixel);
    camera.SetClippingRange(1.0, 20.0);
    for (Layer* layer : layers_->all()) layer->setView(1.0 / metresPerPixel, size.x(), size.y());
}

void SectionView::laySized(const SectionPicture& picture) {
    const double scale = 1.0 / (laidAt_ * pixelRatio_);  // device-independent pixels per metre
    Layers& on = *layers_;
    on.moved.show(SectionShapes(picture, origin_).outlines(movedBlocks(picture, scale, onTheScreen)));
    const double lines = lineWidth(picture, scale);
    on.joints.setWidth(lines * pixelRatio_);
    on.seams.setWidth(seamsOfJoints * lines * pixelRatio_);
    const double shank = shankWidth(picture, scale);
    on.shanks.setWidth(shank * pixelRatio_);
    on.casings.setWidth(shank * casingOfShank * pixelRatio_);
}

/// Lays out the forces; of the contact forces, only those in `window`, the visible part of the section.
void SectionView::layForces(const SectionPicture& picture, const Box& window) {
    const ForceShapes forces = forceShapes(picture, origin_, 1.0 / (laidAt_ * pixelRatio_), colours_, window);
    layers_->rims.show(forces.rims);
    layers_->forces.show(forces.lines);
}

int SectionView::joinings() const { return layers_->blocks.joinings(); }

}  // namespace keyblock
