// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run as pictures that follow one another: sections painted as on paper, all of
// one size, with one set of ranges and a line that tells stages and events. What
// becomes of the pictures, files or a film, is for others to say. Nothing of Qt
// shows here.
#pragma once

#include "ui/figure/figure.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

namespace keyblock {

class Animation {
public:
    /// The frames of the stage that the request's filter names, or of the whole run. Format and moment of the request
    /// mean nothing here; the run must outlive this.
    /// \throws CannotDraw where there are no frames, or no such quantity.
    Animation(const RunSource& run, const FigureRequest& request);
    ~Animation();
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    std::size_t size() const;  // pictures
    int columns() const;  // of a picture [px]
    int rows() const;
    /// Index of the run's frame that a picture shows.
    std::size_t frame(std::size_t picture) const;

    /// A picture as rows of pixels from the top, four bytes each: blue, green, red, and one that means nothing.
    std::string pixels(std::size_t picture) const;
    /// A picture as a PNG file. The same run and request give the same bytes.
    std::string png(std::size_t picture) const;

private:
    class Painter;
    std::unique_ptr<Painter> painter_;
};

/// `frame-0001.png` for the first: the picture's file in a folder of pictures.
std::string pictureName(std::size_t picture);

/// Whether a folder of pictures may hold a file of this name: a picture, or the list `frames.csv`.
bool isOfPictures(const std::string& name);

/// The list as CSV: file, stage, time and step of each picture.
void writePictureList(const RunSource& run, const Animation& animation, std::ostream& out);

}  // namespace keyblock
