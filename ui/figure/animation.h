// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run as a sequence of images: sections drawn as on paper, all of the same size and
// with the same colour ranges, above a timeline of the stages and events. Callers write
// the images to files or encode them as an animation. This header does not need Qt.
#pragma once

#include "ui/figure/figure.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

namespace keyblock {

class Animation {
public:
    /// Prepares images of the frames of the requested stage, or of the whole run. The format and the time in the
    /// request are ignored.
    /// \pre the run outlives this object.
    /// \throws CannotDraw if there are no frames, or if the quantity is unknown or shown by arrows.
    Animation(const RunSource& run, const FigureRequest& request);
    ~Animation();
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    std::size_t size() const;  // number of images
    int columns() const;  // width of an image [px]
    int rows() const;  // height of an image [px]
    /// Index in the run of the frame that image `picture` shows.
    std::size_t frame(std::size_t picture) const;

    /// Pixels of an image, in rows from top to bottom, with four bytes per pixel: blue, green, red, unused.
    std::string pixels(std::size_t picture) const;
    /// An image as the contents of a PNG file. The same run and request always give the same bytes.
    std::string png(std::size_t picture) const;

private:
    class Painter;
    std::unique_ptr<Painter> painter_;
};

/// File name of an image in a folder of images: `frame-0001.png` for index 0.
std::string pictureName(std::size_t picture);

/// True if `name` is the name of a file that belongs to a folder of images: an image or `frames.csv`, the list of
/// images.
bool isOfPictures(const std::string& name);

/// Writes the list of images as CSV: file, stage, time and step of each image.
void writePictureList(const RunSource& run, const Animation& animation, std::ostream& out);

}  // namespace keyblock
