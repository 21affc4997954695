// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section on the GPU: its layers from the openings up to the shanks of bolts.
// Everything in pixels and in text (marks, names, force diagrams, legends) is
// painted above it by the owner of the window. All decisions are in the picture.
#pragma once

#include "ui/picture/section.h"
#include "ui/view/view_colours.h"

#include <memory>

class vtkRenderer;

namespace keyblock {

class SectionView {
public:
    /// The renderer must outlive it.
    explicit SectionView(vtkRenderer& renderer);
    ~SectionView();
    SectionView(const SectionView&) = delete;
    SectionView& operator=(const SectionView&) = delete;

    /// Line widths are in pixels, independent of the camera. Successive frames of one run are cheap.
    /// Call `look` afterwards.
    void show(const SectionPicture& picture, const ViewColours& colours, const ViewStyle& style);

    /// Shows only the background.
    void clear(const ViewColours& colours);

    /// Centres a viewport of `size` [device px] on `centre` [m], and rebuilds the shapes with a size in
    /// pixels. \param picture what is shown, or null.
    void look(const Point& centre, double metresPerPixel, const Point& size, const SectionPicture* picture);

    /// How often the connectivity of blocks was rebuilt: once for successive frames of one run.
    int joinings() const;

private:
    struct Layers;
    void paint(const ViewColours& colours, const ViewStyle& style);
    void laySized(const SectionPicture& picture);
    void layForces(const SectionPicture& picture, const Box& window);

    vtkRenderer& renderer_;
    std::unique_ptr<Layers> layers_;
    ViewColours colours_;
    double pixelRatio_ = 1.0;
    Point origin_{0.0, 0.0};
    Point seenFrom_{0.0, 0.0}, seenSize_{0.0, 0.0};  // camera for which contact forces were built
    double laidAt_ = 0.0;  // metres per pixel of shapes with a size in pixels; 0: to be built
};

}  // namespace keyblock
