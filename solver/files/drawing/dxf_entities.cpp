// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names are in UTF-8 since AutoCAD 2007 and in a code page before; in both, `\U+00E4`
// represents a letter. A section without an end mark ends where the next one begins.
#include "solver/files/drawing/dxf_entities.h"

#include "solver/files/csv/number_text_reader.h"
#include "solver/files/text_encoding.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <charconv>

namespace keyblock {

namespace {

class Sorter {
public:
    explicit Sorter(const DxfGroups& read) : groups_(read.groups) { content_.problems = read.problems; }

    DxfContent sort() {
        while (at_ < groups_.size()) {
            const DxfGroup& group = groups_[at_];
            if (group.code == 0 && group.value == "SECTION")
                readSection();
            else if (group.code == 0 && group.value == "EOF")
                break;
            else
                stray(group);
        }
        return std::move(content_);
    }

private:
    bool begins(std::string_view word) const {
        return at_ < groups_.size() && groups_[at_].code == 0 && groups_[at_].value == word;
    }
    bool over() const { return at_ >= groups_.size() || begins("ENDSEC") || begins("SECTION") || begins("EOF"); }

    void stray(const DxfGroup& group) {
        if (group.code == 0 || !reportedStray_)
            warn(group.line, inQuotes(group.value) + " is outside every section and was not read",
                 "Check whether lines before it are missing");
        reportedStray_ = true;
        ++at_;
    }

    void warn(int line, std::string message, std::string remedy) {
        addProblem(content_.problems,
                   {Severity::Warning, "", line, "", std::move(message), std::move(remedy)});
    }

    void readSection() {
        const int line = groups_[at_++].line;
        std::string name;
        if (at_ < groups_.size() && groups_[at_].code == 2) name = groups_[at_++].value;
        if (name == "HEADER")
            readHeader();
        else if (name == "TABLES")
            readTables();
        else if (name == "BLOCKS")
            readBlocks();
        else if (name == "ENTITIES")
            readEntities(content_.entities, "");
        else
            while (!over()) ++at_;
        if (begins("ENDSEC"))
            ++at_;
        else
            warn(line, "the section " + inQuotes(name) + " has no ENDSEC; it ends where the next section begins",
                 "Check whether anything is missing");
    }

    void readHeader() {
        std::string variable;
        for (; !over(); ++at_) {
            const DxfGroup& group = groups_[at_];
            if (group.code == 9)
                variable = group.value;
            else if (variable == "$INSUNITS" && group.code == 70 && !readInteger(group.value, content_.units))
                warn(group.line, "$INSUNITS is " + inQuotes(group.value) + ", which is not a number", "Give --units");
            else if (variable == "$DWGCODEPAGE" && group.code == 3)
                content_.codePage = group.value;
        }
    }

    void readTables() {
        while (!over()) {
            if (groups_[at_].code != 0 || groups_[at_].value != "LAYER") {
                ++at_;
                continue;
            }
            const DxfEntity layer = readEntity();
            const bool frozen = (integerOf(layer, 70, 0) & 1) != 0, off = integerOf(layer, 62, 7) < 0;
            content_.hidden[lowerCase(text(valueOf(layer, 2)))] = frozen || off;
        }
    }

    void readBlocks() {
        while (!over()) {
            if (!begins("BLOCK")) {
                ++at_;
                continue;
            }
            const DxfEntity head = readEntity();
            const Point base(realOf(head, 10, 0.0), realOf(head, 20, 0.0));
            DxfBlock block{text(valueOf(head, 2)), base, {}, head.line};
            readEntities(block.entities, "ENDBLK");
            if (begins("ENDBLK")) readEntity();
            const std::string key = lowerCase(block.name);
            if (!content_.blocks.emplace(key, std::move(block)).second)
                warn(head.line, "a second block is called " + inQuotes(key) + " and was not read", "Rename one of them");
        }
    }

    void readEntities(std::vector<DxfEntity>& entities, std::string_view end) {
        while (!over() && !(begins(end) && !end.empty()) && !(begins("BLOCK") && !end.empty())) {
            if (groups_[at_].code != 0) {
                stray(groups_[at_]);
                continue;
            }
            DxfEntity entity = readEntity();
            if (entity.kind == "POLYLINE" || (entity.kind == "INSERT" && integerOf(entity, 66, 0) == 1))
                readParts(entity);
            entities.push_back(std::move(entity));
        }
    }

    void readParts(DxfEntity& whole) {
        const std::string_view kind = whole.kind == "POLYLINE" ? "VERTEX" : "ATTRIB";
        while (begins(kind)) whole.parts.push_back(readEntity());
        if (begins("SEQEND"))
            readEntity();
        else
            warn(whole.line, "the " + whole.kind + " has no SEQEND", "Check whether any of its parts are missing");
    }

    DxfEntity readEntity() {
        DxfEntity entity;
        entity.kind = groups_[at_].value;
        entity.line = groups_[at_].line;
        const std::size_t first = ++at_;
        while (at_ < groups_.size() && groups_[at_].code != 0) ++at_;
        entity.groups = std::span(groups_).subspan(first, at_ - first);
        entity.layer = text(valueOf(entity, 8));
        if (entity.layer.empty()) entity.layer = "0";
        entity.handle = valueOf(entity, 5);
        entity.paper = integerOf(entity, 67, 0) == 1;
        entity.invisible = integerOf(entity, 60, 0) == 1;
        return entity;
    }

    std::string text(std::string_view raw) const {
        return withDxfEscapes(asUtf8(raw, content_.codePage));
    }

    const std::vector<DxfGroup>& groups_;
    std::size_t at_ = 0;
    bool reportedStray_ = false;
    DxfContent content_;
};

}  // namespace

DxfContent sortDxf(const DxfGroups& groups) { return Sorter(groups).sort(); }

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

std::string_view valueOf(const DxfEntity& entity, int code) {
    for (const DxfGroup& group : entity.groups)
        if (group.code == code) return group.value;
    return {};
}

double realOf(const DxfEntity& entity, int code, double otherwise) {
    double number = 0.0;
    return readReal(valueOf(entity, code), number) ? number : otherwise;
}

int integerOf(const DxfEntity& entity, int code, int otherwise) {
    int number = 0;
    return readInteger(valueOf(entity, code), number) ? number : otherwise;
}

}  // namespace keyblock
