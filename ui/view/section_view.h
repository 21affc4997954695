// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section on the card: its layers from the openings up to the shanks of bolts.
// What stands in pixels and in words (marks, names, ribbons, legends) is painted
// above it by whoever owns the window. Decides nothing that the picture does not.
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

    /// Lines have their widths in pixels, whatever the camera does. Frames of one run after another are cheap.
    /// To be followed by `look`.
    void show(const SectionPicture& picture, const ViewColours& colours, const ViewStyle& style);

    /// Nothing but the ground.
    void clear(const ViewColours& colours);

    /// Looks at `centre` [m] in the middle of a viewport of `size` [px of the device], and lays what has its size in
    /// pixels. \param picture what is shown, or null.
    void look(const Point& centre, double metresPerPixel, const Point& size, const SectionPicture* picture);

    /// How often corners of blocks were joined anew: once as long as frames of one run follow one another.
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
    Point seenFrom_{0.0, 0.0}, seenSize_{0.0, 0.0};  // camera for which forces of contacts were laid
    double laidAt_ = 0.0;  // metres per pixel of what has its size in pixels; 0: to be laid
};

}  // namespace keyblock
