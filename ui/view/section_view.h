// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section on the GPU, in layers from the openings at the bottom to the shanks of
// bolts at the top. Text and everything else with a size in pixels (marks, names, force
// diagrams, legends) is painted above it by the owner of the window. The picture alone
// determines what is shown.
#pragma once

#include "ui/picture/section/section.h"
#include "ui/view/view_colours.h"

#include <memory>

class vtkRenderer;

namespace keyblock {

class SectionView {
public:
    /// \pre the renderer outlives this object.
    explicit SectionView(vtkRenderer& renderer);
    ~SectionView();
    SectionView(const SectionView&) = delete;
    SectionView& operator=(const SectionView&) = delete;

    /// Shows a picture; call `look` afterwards. Line widths are in pixels, independent of the zoom. Showing successive
    /// frames of one run is cheap.
    void show(const SectionPicture& picture, const ViewColours& colours, const ViewStyle& style);

    /// Shows only the background.
    void clear(const ViewColours& colours);

    /// Centres a viewport of `size` [device px] on `centre` [m], and rebuilds the shapes that have a size in pixels.
    /// \param picture the picture shown, or null.
    void look(const Point& centre, double metresPerPixel, const Point& size, const SectionPicture* picture);

    /// How often the connectivity of the blocks has been rebuilt so far. Successive frames of a run need it only once.
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
    Point seenFrom_{0.0, 0.0}, seenSize_{0.0, 0.0};  // viewport for which the contact forces were built
    double laidAt_ = 0.0;  // metres per pixel for which shapes with a size in pixels were built; 0: to be rebuilt
};

}  // namespace keyblock
