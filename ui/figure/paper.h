// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sheet of paper of exact size in one of three file formats. In each of them, one
// unit of the painter is 0.05 mm, so that the same strokes give the same figure.
#pragma once

#include "ui/figure/figure.h"

#include <QBuffer>
#include <QImage>

#include <memory>

class QCPPainter;
class QPaintDevice;

namespace keyblock {

inline constexpr double unitsPerMm = 20.0;

class Paper {
public:
    /// A sheet of `width` × `height` [mm]. \param dpi resolution, for PNG.
    /// \throws CannotDraw if a PNG does not fit in memory.
    Paper(PaperFormat format, double width, double height, int dpi, const std::string& title);
    ~Paper();
    Paper(const Paper&) = delete;
    Paper& operator=(const Paper&) = delete;

    QCPPainter& painter() { return *painter_; }
    /// The image, if the format is PNG; null for the other formats.
    const QImage& image() const { return image_; }
    double width() const { return width_; }
    double height() const { return height_; }

    /// Completes the file and returns its contents, which are the same bytes in every run of the program. Call this
    /// only once.
    /// \throws CannotDraw if there is not enough memory.
    std::string finish();

private:
    void beginSvg(const std::string& title);
    void beginPdf(const std::string& title);
    void beginPng();

    PaperFormat format_;
    double width_, height_;
    int dpi_;
    QBuffer buffer_;
    QImage image_;
    std::unique_ptr<QPaintDevice> device_;
    std::unique_ptr<QCPPainter> painter_;
};

}  // namespace keyblock
