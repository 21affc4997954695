// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document becomes a list of pieces, which are laid out before anything is painted:
// the contents on the first page need the pages of all sections.
#include "ui/report/report_pdf.h"

#include "ui/figure/application.h"
#include "ui/figure/figure.h"
#include "ui/figure/paper.h"
#include "ui/report/report_pages.h"
#include "ui/report/report_tables.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace report_page;

constexpr int pdfUnitsPerInch = 508;  // 20 units per mm, as on `Paper`
constexpr double bodyLine = 4.5, smallGap = 2.0, partGap = 5.0;  // [mm]
constexpr double largestFigure = 205.0;  // height of a figure [mm]
constexpr double halfPage = 116.0;  // height of figures of which two fit on a page, with their captions [mm]
constexpr double leastShrink = 0.85;  // figures are reduced to `halfPage` by no more than this
const TextStyle titleStyle{6.4, true}, headingStyle{4.2, true}, bodyStyle{3.1}, answerStyle{3.8, true},
    warningTextStyle{3.1, true, paper_theme::error}, commandStyle{2.6}, factStyle{3.1, false, paper_theme::softText},
    figureCaptionStyle{2.7, true}, footStyle{2.3, false, paper_theme::softText};

QByteArray bytesOf(const std::string& text) { return {text.data(), static_cast<int>(text.size())}; }

/// A picture in one of the media types of a logo or figure.
class PaperPicture {
public:
    PaperPicture(const std::string& bytes, const std::string& mediaType, const std::string& what) {
        if (mediaType == "image/svg+xml") {
            svg_ = std::make_shared<QSvgRenderer>(bytesOf(bytes));
            size_ = svg_->isValid() ? svg_->viewBoxF().size() : QSizeF();
        } else if (image_.loadFromData(bytesOf(bytes))) {
            size_ = image_.size();
        }
        if (size_.isEmpty()) throw CannotDraw(what + " is damaged; export it again");
    }

    double heightFor(double wide) const { return wide * size_.height() / size_.width(); }

    void draw(Ink& ink, const Box& box) const {
        const QRectF area(QPointF(box.min.x(), box.min.y()) * unitsPerMm,
                          QPointF(box.max.x(), box.max.y()) * unitsPerMm);
        if (svg_) svg_->render(&ink.painter(), area);
        else ink.painter().drawImage(area, image_);
    }

private:
    std::shared_ptr<QSvgRenderer> svg_;
    QImage image_;
    QSizeF size_;
};

PagePiece gap(double high, bool staysWithNext = false) {
    PagePiece piece;
    piece.height = high;
    piece.isGap = true;
    piece.staysWithNext = staysWithNext;
    return piece;
}

/// One line of text. \param high distance to the next line [mm].
PagePiece linePiece(const std::string& text, const TextStyle& style, double high, double indent = 0.0) {
    PagePiece piece;
    piece.height = high;
    piece.draw = [text, style, high, indent](Ink& ink, double top) {
        ink.text({left + indent, top + 0.5 * (high + 0.7 * style.size)}, text, style);
    };
    return piece;
}

class PdfWriter {
public:
    explicit PdfWriter(const ReportDocument& document) : document_(document) {
        needApplication();
        addTitle();
        addContents();
        for (std::size_t i = 0; i < document.sections.size(); ++i) addSection(i);
        layout_ = layOut(pieces_);
    }

    std::string write() const {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter pdf(&buffer);
        pdf.setResolution(pdfUnitsPerInch);
        pdf.setPageSize(QPageSize(QPageSize::A4));
        pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
        pdf.setTitle(QString::fromStdString(document_.title));
        pdf.setCreator("Keyblock");
        QPainter painter(&pdf);
        painter.setRenderHint(QPainter::Antialiasing);
        Ink ink(painter);
        std::size_t page = 0;
        drawFoot(ink, page);
        for (const PlacedPiece& placed : layout_.pieces) {
            for (; page < placed.page; drawFoot(ink, ++page)) pdf.newPage();
            if (placed.piece->draw) placed.piece->draw(ink, placed.top);
        }
        painter.end();
        return withoutDate(buffer.data().toStdString());
    }

private:
    /// Replaces the time of writing by spaces, so that the same document gives the same bytes.
    static std::string withoutDate(std::string bytes) {
        const std::size_t from = bytes.find("/CreationDate");
        const std::size_t to = from == std::string::npos ? from : bytes.find('\n', from);
        if (to != std::string::npos) std::fill(bytes.begin() + from, bytes.begin() + to, ' ');
        return bytes;
    }

    void drawFoot(Ink& ink, std::size_t page) const {
        const double y = height - 12.0;
        ink.line({left, y - 4.0}, {width - left, y - 4.0}, {0.1, paper_theme::axis});
        const std::string number = "Page " + std::to_string(page + 1) + " of " + std::to_string(layout_.pages);
        ink.text({left, y}, elided(document_.foot, footStyle, inner - 30.0), footStyle);
        ink.text({width - left, y}, number, footStyle, Align::Right);
    }

    void addLines(const std::string& text, const TextStyle& style, double high, bool together = false) {
        for (const std::string& line : brokenLines(text, style, inner)) {
            pieces_.push_back(linePiece(line, style, high));
            pieces_.back().staysWithNext = together;
        }
    }

    void addTitle() {
        if (document_.logo) {
            const PaperPicture logo(document_.logo->bytes, document_.logo->mediaType, "the logo");
            const double wide = std::min(45.0, 22.0 / logo.heightFor(1.0)), high = logo.heightFor(wide);
            pieces_.push_back({high + smallGap, [logo, wide, high](Ink& ink, double top) {
                                   logo.draw(ink, {{width - left - wide, top}, {width - left, top + high}});
                               }});
        }
        addLines(document_.title, titleStyle, 8.5);
        pieces_.push_back(gap(smallGap));
        double widest = 0.0;
        for (const auto& [name, value] : document_.facts) widest = std::max(widest, textWidth(name, factStyle));
        for (const auto& [name, value] : document_.facts) addFact(name, value, widest + 5.0);
        pieces_.push_back(
            {smallGap + 1.0, [](Ink& ink, double top) {
                 ink.line({left, top + smallGap}, {width - left, top + smallGap}, {0.35, paper_theme::black});
             }});
    }

    void addFact(const std::string& name, const std::string& value, double indent) {
        bool first = true;
        for (const std::string& line : brokenLines(value, bodyStyle, inner - indent)) {
            PagePiece piece = linePiece(line, bodyStyle, bodyLine, indent);
            if (first)
                piece.draw = [draw = piece.draw, name](Ink& ink, double top) {
                    draw(ink, top);
                    ink.text({left, top + 0.5 * (bodyLine + 0.7 * factStyle.size)}, name, factStyle);
                };
            first = false;
            pieces_.push_back(std::move(piece));
        }
    }

    void addContents() {
        pieces_.push_back(gap(partGap, true));
        pieces_.push_back(linePiece("Contents", headingStyle, 7.0));
        pieces_.back().staysWithNext = true;
        for (std::size_t i = 0; i < document_.sections.size(); ++i) {
            PagePiece piece;
            piece.height = bodyLine;
            piece.draw = [this, i](Ink& ink, double top) {
                const double y = top + 0.5 * (bodyLine + 0.7 * bodyStyle.size);
                const std::string heading = elided(std::to_string(i + 1) + "  " + document_.sections[i].heading,
                                                   bodyStyle, inner - 15.0);
                const std::string page = std::to_string(layout_.sections.at(i) + 1);
                ink.text({left, y}, heading, bodyStyle);
                ink.text({width - left, y}, page, bodyStyle, Align::Right);
                const double from = left + textWidth(heading, bodyStyle) + 2.0;
                const double to = width - left - textWidth(page, bodyStyle) - 2.0;
                ink.line({from, y - 0.2}, {std::max(from, to), y - 0.2}, {0.2, paper_theme::axis, {0.3, 1.2}});
            };
            pieces_.push_back(std::move(piece));
        }
    }

    void addSection(std::size_t i) {
        pieces_.push_back(gap(8.0, true));
        const std::string heading = std::to_string(i + 1) + "  " + document_.sections[i].heading;
        bool first = true;
        for (const std::string& line : brokenLines(heading, headingStyle, inner)) {
            pieces_.push_back(linePiece(line, headingStyle, 6.5));
            pieces_.back().staysWithNext = true;
            if (first) pieces_.back().section = static_cast<int>(i);
            first = false;
        }
        pieces_.push_back(gap(smallGap, !document_.sections[i].parts.empty()));
        for (const ReportPart& part : document_.sections[i].parts) {
            std::visit([this](const auto& one) { add(one); }, part);
            pieces_.push_back(gap(std::holds_alternative<ReportText>(part) ? smallGap : partGap));
        }
    }

    void add(const ReportText& text) {
        switch (text.kind) {
            case ReportTextKind::Body: return addLines(text.text, bodyStyle, bodyLine);
            case ReportTextKind::Answer: return addLines(text.text, answerStyle, 5.5);
            case ReportTextKind::Warning: return addLines(text.text, warningTextStyle, bodyLine);
            case ReportTextKind::Command: return addLines(text.text, commandStyle, 4.0, true);
        }
    }

    void add(const ReportTable& table) {
        for (PagePiece& piece : tablePieces(table, ++tables_)) pieces_.push_back(std::move(piece));
    }

    void add(const ReportFigure& figure) {
        const PaperPicture picture(figure.svg, "image/svg+xml", "the figure '" + figure.caption + "'");
        const double natural = figure.width > 0.0 ? std::min(inner, figure.width) : inner;
        const double whole = std::min(natural, largestFigure / picture.heightFor(1.0));
        const double half = halfPage / picture.heightFor(1.0);
        const double wide = half < whole && half >= leastShrink * whole ? half : whole, high = picture.heightFor(wide);
        pieces_.push_back({high, [picture, wide, high](Ink& ink, double top) {
                               picture.draw(ink, {{left, top}, {left + wide, top + high}});
                           }});
        pieces_.back().staysWithNext = true;
        const std::string caption = "Figure " + std::to_string(++figures_) + ". " + figure.caption + ".";
        const std::vector<std::string> lines = brokenLines(caption, figureCaptionStyle, inner);
        for (std::size_t l = 0; l < lines.size(); ++l) {
            pieces_.push_back(linePiece(lines[l], figureCaptionStyle, 4.0));
            pieces_.back().staysWithNext = l + 1 < lines.size();
        }
    }

    const ReportDocument& document_;
    std::vector<PagePiece> pieces_;
    PageLayout layout_;
    int tables_ = 0, figures_ = 0;
};

}  // namespace

std::string reportPdf(const ReportDocument& document) { return PdfWriter(document).write(); }

}  // namespace keyblock
