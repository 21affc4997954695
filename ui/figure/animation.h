// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run as a sequence of pictures: sections painted as on paper, all of one size, with
// common ranges and a line with stages and events. Callers write them to files or an
// animation. This header does not need Qt.
#pragma once

#include "ui/figure/figure.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

namespace keyblock {

class Animation {
public:
    /// The frames of the stage in the request's filter, or of the whole run. Format and time of the request are
    /// ignored; the run must outlive this. \throws CannotDraw if there are no frames, or no such quantity.
    Animation(const RunSource& run, const FigureRequest& request);
    ~Animation();
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    std::size_t size() const;  // number of pictures
    int columns() const;  // of a picture [px]
    int rows() const;
    /// Index of the run's frame of a picture.
    std::size_t frame(std::size_t picture) const;

    /// A picture as rows of pixels from the top, four bytes each: blue, green, red, and an unused one.
    std::string pixels(std::size_t picture) const;
    /// A picture as a PNG file. The same run and request give the same bytes.
    std::string png(std::size_t picture) const;

private:
    class Painter;
    std::unique_ptr<Painter> painter_;
};

/// `frame-0001.png` for the first: the picture's file in a folder of pictures.
std::string pictureName(std::size_t picture);

/// Whether a file of this name may be in a folder of pictures: a picture, or the list `frames.csv`.
bool isOfPictures(const std::string& name);

/// The list as CSV: file, stage, time and step of each picture.
void writePictureList(const RunSource& run, const Animation& animation, std::ostream& out);

}  // namespace keyblock
