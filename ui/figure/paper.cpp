// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/paper.h"

#include "solver/scene/xml_text.h"
#include "ui/figure/application.h"

#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double mmPerInch = 25.4;
constexpr int unitsPerInch = 508;  // 20 units per mm

/// Replaces the text from `begin` to `end` with the same number of spaces, so that offsets in the file stay valid.
void blank(std::string& bytes, const std::string& begin, const std::string& end) {
    const std::size_t from = bytes.find(begin);
    if (from == std::string::npos) return;
    const std::size_t to = bytes.find(end, from + begin.size());
    if (to != std::string::npos) std::fill(bytes.begin() + from, bytes.begin() + to, ' ');
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

}  // namespace

Paper::Paper(PaperFormat format, double width, double height, int dpi, const std::string& title)
    : format_(format), width_(width), height_(height), dpi_(dpi), painter_(std::make_unique<QCPPainter>()) {
    needApplication();
    buffer_.open(QIODevice::WriteOnly);
    switch (format) {
        case PaperFormat::Svg: beginSvg(title); break;
        case PaperFormat::Pdf: beginPdf(title); break;
        case PaperFormat::Png: beginPng(); break;
    }
    painter_->setRenderHint(QPainter::Antialiasing);
    painter_->setRenderHint(QPainter::TextAntialiasing);
    painter_->fillRect(QRectF(0, 0, width * unitsPerMm, height * unitsPerMm), Qt::white);
}

Paper::~Paper() {
    if (painter_->isActive()) painter_->end();
}

void Paper::beginSvg(const std::string& title) {
    auto svg = std::make_unique<QSvgGenerator>();
    const QSize size(static_cast<int>(std::lround(width_ * unitsPerMm)),
                     static_cast<int>(std::lround(height_ * unitsPerMm)));
    svg->setOutputDevice(&buffer_);
    svg->setResolution(unitsPerInch);
    svg->setSize(size);
    svg->setViewBox(QRect(QPoint(0, 0), size));
    svg->setTitle(QString::fromStdString(xmlText(title)));  // Qt writes the title as it is
    svg->setDescription("Keyblock");
    device_ = std::move(svg);
    painter_->begin(device_.get());
    painter_->setModes(QCPPainter::pmVectorized | QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
}

void Paper::beginPdf(const std::string& title) {
    auto pdf = std::make_unique<QPdfWriter>(&buffer_);
    pdf->setResolution(unitsPerInch);
    pdf->setPageSize(QPageSize(QSizeF(width_, height_), QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
    pdf->setPageMargins(QMarginsF(0, 0, 0, 0));
    pdf->setTitle(QString::fromStdString(title));
    pdf->setCreator("Keyblock");
    device_ = std::move(pdf);
    painter_->begin(device_.get());
    painter_->setModes(QCPPainter::pmVectorized | QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
}

void Paper::beginPng() {
    const double perMm = dpi_ / mmPerInch;
    image_ = QImage(static_cast<int>(std::lround(width_ * perMm)), static_cast<int>(std::lround(height_ * perMm)),
                    QImage::Format_RGB32);
    if (image_.isNull())
        throw CannotDraw("an image of " + std::to_string(std::lround(width_)) + " × " +
                         std::to_string(std::lround(height_)) + " mm at " + std::to_string(dpi_) +
                         " dpi does not fit in memory; reduce its size or resolution");
    image_.fill(Qt::white);
    painter_->begin(&image_);
    painter_->setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
    painter_->scale(perMm / unitsPerMm, perMm / unitsPerMm);
}

std::string Paper::finish() {
    painter_->end();
    if (format_ == PaperFormat::Png) {
        const int dotsPerMetre = static_cast<int>(std::lround(dpi_ / mmPerInch * 1000.0));
        image_.setDotsPerMeterX(dotsPerMetre);
        image_.setDotsPerMeterY(dotsPerMetre);
        if (!image_.save(&buffer_, "PNG")) throw CannotDraw("there is not enough memory for an image of this size; reduce it");
    }
    std::string bytes = buffer_.data().toStdString();
    if (format_ == PaperFormat::Pdf) blank(bytes, "/CreationDate", "\n");
    if (format_ == PaperFormat::Svg)  // for viewers that do not have the font Inter
        replaceAll(bytes, "font-family=\"Inter\"", "font-family=\"Inter, 'Noto Sans', Arial, sans-serif\"");
    if (format_ == PaperFormat::Svg) bytes = withoutXmlForbidden(bytes);  // Qt escapes labels, but keeps these
    if (format_ == PaperFormat::Svg) replaceAll(bytes, "font-weight=\"630\"", "font-weight=\"600\"");  // Qt 5's scale
    return bytes;
}

}  // namespace keyblock
