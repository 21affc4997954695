// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/legend_panel.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/legend_activity.h"
#include "ui/canvas/legend_bar.h"
#include "ui/canvas/legend_forces.h"
#include "ui/canvas/legend_key.h"
#include "ui/look/theme.h"
#include "ui/picture/ticks.h"

#include <QCoreApplication>
#include <QPainter>

#include <cmath>
#include <functional>

namespace keyblock {

namespace {

struct LegendTexts {
    Q_DECLARE_TR_FUNCTIONS(Legend)
};

constexpr double legendInset = 10.0, legendPadding = 13.0, width = legendExtent - legendInset;  // [px]
constexpr double leastCanvas = 480.0;  // [px] on a narrower canvas the legend would hide the section
constexpr double leastNarrow = 260.0;  // [px] smallest width at which the colour bars fit below the section
// [px] from this width on, the colour bars fit next to the scale bar; on a narrower canvas they are above it
constexpr double leastBeside = 400.0;
constexpr double scaleBarRoom = 42.0;  // [px]
constexpr double shareOfNarrow = 0.4;  // largest fraction of the canvas height on a narrow canvas

struct Item {
    double height = 0.0;  // [px]
    std::function<void(QPainter&, const QPointF&)> paint;
    std::optional<LegendPart> part{};
    bool fits = true;
};

QString deformationText(double factor) {
    if (factor == 1.0) return LegendTexts::tr("Deformation drawn true to scale");
    return LegendTexts::tr("Deformation magnified ×%1").arg(QString::fromStdString(numberText(factor)));
}

/// The colour bars, and the entries of arrows and contact forces.
std::vector<Item> quantitiesOf(const Theme& theme, const LegendContent& content, double inner, ForceNotes notes) {
    const SectionPicture& picture = content.picture;
    std::vector<Item> items;
    const auto addBar = [&](const std::optional<LegendBar>& bar, LegendPart part) {
        if (bar)
            items.push_back({legendBarHeight(*bar, inner), [&theme, &bar, inner](QPainter& painter, const QPointF& at) {
                                 paintLegendBar(painter, theme, *bar, at, inner);
                             }, part});
    };
    addBar(picture.blockLegend, LegendPart::Blocks);
    if (picture.activity)
        items.push_back({legendActivityHeight(), [&theme, &picture, inner](QPainter& painter, const QPointF& at) {
                             paintLegendActivity(painter, theme, *picture.activity, at, inner);
                         }});
    if (picture.arrows && picture.arrows->largest > 0.0)
        items.push_back({legendArrowsHeight(*picture.arrows, inner, notes),
                         [&, inner, notes](QPainter& painter, const QPointF& at) {
                             paintLegendArrows(painter, theme, *content.picture.arrows, at, inner, notes);
                         }});
    if (content.contacts)
        items.push_back({legendContactsHeight(*content.contacts, inner, notes),
                         [&, inner, notes](QPainter& painter, const QPointF& at) {
                             paintLegendContacts(painter, theme, *content.contacts, content.scale, at, inner, notes);
                         }});
    addBar(picture.boltLegend, LegendPart::Bolts);
    return items;
}

std::vector<Item> itemsOf(const Theme& theme, const LegendContent& content, ForceNotes notes) {
    const double inner = width - 2.0 * legendPadding;
    std::vector<Item> items = quantitiesOf(theme, content, inner, notes);
    if (items.empty()) return items;
    if (const double height = legendKeyHeight(content.kinds, content.highlighted); height > 0.0)
        items.push_back({height, [&theme, &content](QPainter& painter, const QPointF& at) {
                             paintLegendKey(painter, theme, content.kinds, content.highlighted, at);
                         }});
    items.push_back({16.0, [&theme, &content, inner](QPainter& painter, const QPointF& at) {
                         painter.setFont(screenFont(11));
                         painter.setPen(theme.text2);
                         painter.drawText(QRectF(at, QSizeF(inner, 16.0)), Qt::AlignVCenter,
                                          deformationText(content.picture.factor));
                     }});
    return items;
}

constexpr double between = 20.0, above = 9.0, below = 7.0;  // [px] space between two items, and at the ends

double heightOf(const std::vector<Item>& items) {
    double height = above + below - between;
    for (const Item& item : items) height += item.height + between;
    return height;
}

bool isNarrow(const QSizeF& canvas) { return canvas.width() < leastCanvas; }

/// Removes the items for which there is no room. Colour bars get room before the other items, upper items before lower
/// ones.
void keepFitting(std::vector<Item>& items, double most) {
    double used = heightOf({});
    for (const bool isBar : {true, false})
        for (Item& item : items) {
            if (item.part.has_value() != isBar) continue;
            item.fits = used + item.height + between <= most;
            if (item.fits) used += item.height + between;
        }
    std::erase_if(items, [](const Item& item) { return !item.fits; });
}

/// The items that fit; on a narrow canvas only the colour bars.
std::vector<Item> itemsWithin(const Theme& theme, const LegendContent& content, const QSizeF& canvas) {
    if (canvas.width() < leastNarrow) return {};
    const double most = isNarrow(canvas) ? shareOfNarrow * canvas.height() : canvas.height() - 2.0 * legendInset;
    std::vector<Item> items = itemsOf(theme, content, ForceNotes::Shown);
    if (heightOf(items) > most) items = itemsOf(theme, content, ForceNotes::Omitted);
    if (isNarrow(canvas)) std::erase_if(items, [](const Item& item) { return !item.part; });
    keepFitting(items, most);
    return items;
}

QRectF rectOf(const std::vector<Item>& items, const QSizeF& canvas) {
    if (items.empty()) return {};
    const double height = heightOf(items);
    const double bottom = legendInset + (canvas.width() < leastBeside ? scaleBarRoom : 0.0);
    const double top = isNarrow(canvas) ? std::round(canvas.height() - bottom - height) : legendInset;
    return {canvas.width() - legendInset - width, top, width, height};
}

}  // namespace

QMarginsF legendRoom(const Theme& theme, const LegendContent& content, const QSizeF& canvas) {
    const QRectF rect = legendRect(theme, content, canvas);
    if (isNarrow(canvas)) return {0.0, 0.0, 0.0, rect.isEmpty() ? 0.0 : canvas.height() - rect.top()};
    return {0.0, 0.0, legendExtent, 0.0};
}

QRectF legendRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas) {
    return rectOf(itemsWithin(theme, content, canvas), canvas);
}

QRectF legendPartRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas, LegendPart part) {
    const std::vector<Item> items = itemsWithin(theme, content, canvas);
    QRectF row = rectOf(items, canvas).adjusted(0.0, above, 0.0, 0.0);
    for (const Item& item : items) {
        row.setHeight(item.height);
        if (item.part == part) return row.adjusted(0.0, -0.4 * between, 0.0, 0.4 * between);
        row.translate(0.0, item.height + between);
    }
    return {};
}

void paintLegend(QPainter& painter, const Theme& theme, const LegendContent& content, const QSizeF& canvas) {
    const std::vector<Item> items = itemsWithin(theme, content, canvas);
    if (items.empty()) return;
    const QRectF panel = rectOf(items, canvas);
    paintPanel(painter, theme, panel);
    QPointF at(panel.left() + legendPadding, panel.top() + above);
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i].paint(painter, at);
        at.ry() += items[i].height + between;
        if (i + 1 == items.size()) break;
        painter.fillRect(QRectF(panel.left() + 1.0, std::round(at.y() - 0.55 * between), width - 2.0, 1.0),
                         theme.separator);
    }
}

}  // namespace keyblock
