// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each list or object is written on one line if it fits.
#include "solver/files/json/json_text.h"

#include "solver/scene/number_text.h"


namespace keyblock {

namespace {

constexpr std::size_t widest = 110;  // maximum number of characters per line
constexpr std::size_t indentation = 2;

std::string escaped(char c) {
    switch (c) {
        case '"': return "\\\"";
        case '\\': return "\\\\";
        case '\n': return "\\n";
        case '\t': return "\\t";
        case '\r': return "\\r";
        default: break;
    }
    if (static_cast<unsigned char>(c) >= 0x20)
        return {c};
    constexpr std::string_view digits = "0123456789abcdef";
    return std::string("\\u00") + digits[static_cast<unsigned char>(c) >> 4] + digits[c & 0xF];
}

std::string textOf(std::string_view text) {
    std::string result = "\"";
    for (const char c : text)
        result += escaped(c);
    return result + "\"";
}

struct LinePrinter {
    std::string operator()(std::monostate) const { return "null"; }
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(double number) const { return shortest(number == 0.0 ? 0.0 : number); }  // −0 becomes 0
    std::string operator()(const std::string& text) const { return textOf(text); }
    std::string operator()(const JsonList& list) const {
        std::string text;
        for (const JsonNode& item : list)
            text += (text.empty() ? "" : ", ") + jsonLine(item);
        return "[" + text + "]";
    }
    std::string operator()(const JsonObject& object) const {
        std::string text;
        for (const JsonMember& member : object)
            text += (text.empty() ? "" : ", ") + textOf(member.key) + ": " + jsonLine(member.node);
        return object.empty() ? "{}" : "{ " + text + " }";
    }
};

// The parts of the root are always on separate lines, which makes merging easier.
void print(const JsonNode& node, std::size_t indent, std::size_t used, std::string& out);

void printItem(const std::string& label, const JsonNode& node, std::size_t indent, bool isLast, std::string& out) {
    out += std::string(indent, ' ') + label;
    print(node, indent, indent + label.size(), out);
    out += isLast ? "\n" : ",\n";
}

void printObject(const JsonObject& object, std::size_t indent, std::string& out) {
    out += "{\n";
    for (std::size_t i = 0; i < object.size(); ++i)
        printItem(textOf(object[i].key) + ": ", object[i].node, indent + indentation, i + 1 == object.size(), out);
    out += std::string(indent, ' ') + "}";
}

void printList(const JsonList& list, std::size_t indent, std::string& out) {
    out += "[\n";
    for (std::size_t i = 0; i < list.size(); ++i)
        printItem("", list[i], indent + indentation, i + 1 == list.size(), out);
    out += std::string(indent, ' ') + "]";
}

// Lower bound of the length that is cheap to compute, so that deep trees are not tried on one line at every level.
std::size_t leastLength(const JsonNode& node) {
    if (const auto* list = std::get_if<JsonList>(&node.value))
        return 3 * list->size();
    if (const auto* object = std::get_if<JsonObject>(&node.value))
        return 6 * object->size();
    return 0;
}

void print(const JsonNode& node, std::size_t indent, std::size_t used, std::string& out) {
    const auto* object = std::get_if<JsonObject>(&node.value);
    const auto* list = std::get_if<JsonList>(&node.value);
    const bool isRoot = used == 0;
    if ((!isRoot && used + leastLength(node) <= widest) || (!object && !list)) {
        const std::string line = jsonLine(node);
        if (used + line.size() <= widest || (!object && !list)) {
            out += line;
            return;
        }
    }
    if (object && !object->empty())
        printObject(*object, indent, out);
    else if (list && !list->empty())
        printList(*list, indent, out);
    else
        out += jsonLine(node);
}

}  // namespace

std::string jsonLine(const JsonNode& node) { return std::visit(LinePrinter{}, node.value); }

std::string jsonText(const JsonNode& node) {
    std::string text;
    print(node, 0, 0, text);
    return text + "\n";
}

}  // namespace keyblock
