// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/section_figure.h"

#include "solver/results/tables.h"
#include "ui/figure/paper.h"
#include "ui/figure/section_layout.h"
#include "ui/figure/sheet.h"

#include <qcustomplot.h>

#include <cmath>

namespace keyblock {

namespace {

std::vector<FigureData> dataOf(const RunSource& run, const SectionRequest& section) {
    if (!section.frame) return {};
    TableFilter filter;
    filter.stage = run.frames()[*section.frame].stage;
    filter.when = When::At;
    filter.time = run.frames()[*section.frame].time;
    filter.events = run.frames()[*section.frame].events;
    const auto table = [&run](TableKind kind, const TableFilter& rows) {
        return [&run, kind, rows](std::ostream& out) { writeTable(kind, run, rows, out); };
    };
    std::vector<FigureData> data{{"-blocks", table(TableKind::Blocks, filter)}};
    if (!run.scene().bolts.empty()) data.push_back({"-bolts", table(TableKind::Bolts, filter)});
    if (section.contacts) data.push_back({"-contacts", table(TableKind::Contacts, filter)});
    data.push_back({"-events", table(TableKind::Events, {})});
    return data;
}

std::string arrowNames() {
    std::string names;
    for (const std::string_view word : arrowWords()) names += std::string(word) + ", ";
    return names + std::string(contactWord);
}

/// Sets the requested quantity: of blocks, drawn over blocks, or of bolts.
void chooseQuantity(const FigureRequest& request, SectionRequest& section) {
    if (!request.quantity) return;
    section.arrows = arrowKindOf(*request.quantity);
    section.contacts = *request.quantity == contactWord;
    if (section.arrows || section.contacts || *request.quantity == plainWord) section.blocks = nullptr;
    else if (const auto* ofBlocks = findQuantity(blockQuantities(), *request.quantity)) section.blocks = ofBlocks;
    else if (const auto* ofBolts = findQuantity(boltQuantities(), *request.quantity)) section.bolts = ofBolts;
    else
        throw CannotDraw("a section has no quantity '" + *request.quantity + "'; of blocks: " + namesOf(blockQuantities()) +
                         "; of bolts: " + namesOf(boltQuantities()) + "; drawn over blocks: " + arrowNames());
}

}  // namespace

SectionRequest sectionRequestOf(const RunSource& run, const FigureRequest& request) {
    SectionRequest section;
    section.frame = frameAt(run, request.filter);
    section.blocks = findQuantity(blockQuantities(), "sigma1");
    section.bolts = findQuantity(BoltQuantity::AxialForce);
    section.ribbon = request.filter.bolt;
    section.factor = request.factor;
    section.whole = request.whole;
    section.scales = request.scales;
    section.window = request.window;
    chooseQuantity(request, section);
    if (request.boltQuantity) section.bolts = findQuantity(boltQuantities(), *request.boltQuantity);
    return section;
}

Figure paintSection(const RunSource& run, const FigureRequest& request) {
    const SectionRequest section = sectionRequestOf(run, request);
    SectionPicture picture = sectionPicture(run, section);
    if (!request.title.empty()) picture.title = request.title;
    const Sheet sheet(request.width, picture.title, picture.subtitle,
                      section.frame ? warningsOf(run, section.frame, picture.notFinite) : std::vector<std::string>{});
    const SectionLayout layout(picture, run.scene(), request.width, sheet.top(), sheet.inner());
    const double height = std::ceil(sheet.heightAround(layout.height()));
    Paper paper(request.format, request.width, height, request.dpi, picture.title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, footOf(run, request, section.frame, height));
    layout.draw(ink, picture, run.scene());
    return {paper.finish(), dataOf(run, section)};
}

}  // namespace keyblock
