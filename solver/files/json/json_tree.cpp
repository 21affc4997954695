// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parser is that of nlohmann, used through its SAX interface because its own tree
// drops duplicate keys and positions. It reads through an iterator that records how
// far it has read; lines are counted up to that point. This is the only file of the
// scene reader that includes the parser, which is slow to compile.
#include "solver/files/json/json_tree.h"

#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"
#include "solver/scene/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace keyblock {

namespace {

constexpr std::size_t longestKey = 100000;  // bytes
constexpr std::size_t longestDetail = 160;  // of the parser's message, in characters

// Records in `reached` how far the parser has read.
class TellingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    TellingIterator(const char* position, const char** reached) : position_(position), reached_(reached) {}

    reference operator*() const { return *position_; }
    TellingIterator& operator++() {
        *reached_ = ++position_;
        return *this;
    }
    TellingIterator operator++(int) {
        TellingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const TellingIterator& other) const { return position_ == other.position_; }

private:
    const char* position_;
    const char** reached_;
};

// The parser's message without its prefix, without the text read last (the word around the error is clearer) and
// without bytes that are not plain text.
std::string detailOf(std::string_view what) {
    if (const auto column = what.find("column "); column != std::string_view::npos)
        what.remove_prefix(std::min(what.find(": ", column) + 2, what.size()));
    else if (const auto bracket = what.find("] "); bracket != std::string_view::npos)
        what.remove_prefix(bracket + 2);
    std::string text(what.substr(0, std::min(what.find("; last read"), longestDetail)));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return text;
}

bool isWordCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '+';
}

// Letters, digits and signs around a position in a text.
std::string_view wordAround(std::string_view text, std::size_t place) {
    std::size_t begin = place;
    std::size_t end = place;
    while (begin > 0 && isWordCharacter(text[begin - 1]))
        --begin;
    while (end < text.size() && isWordCharacter(text[end]))
        ++end;
    return text.substr(begin, end - begin);
}

bool isNoFiniteNumber(std::string_view word) {
    std::string letters;
    for (const char c : word)
        if (c != '-' && c != '+')
            letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return letters == "nan" || letters == "inf" || letters == "infinity";
}

std::string remedyFor(std::string_view detail) {
    const auto tells = [&](std::string_view part) { return detail.find(part) != std::string_view::npos; };
    if (tells("UTF-8"))
        return "Save the file as UTF-8";
    if (tells("overflow"))
        return "Give a number below 1.8e308";
    if (tells("unexpected end of input") || tells("missing closing quote"))
        return "The text is incomplete; complete it";
    return "Correct the text here or just before; a comma, quote or bracket may be missing or superfluous";
}

// Builds the tree; returns false to the parser if a limit is exceeded.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(std::string_view text, const char** reached)
        : text_(text), counted_(text.data()), reached_(reached) {}

    bool null() override { return leaf(std::monostate{}); }
    bool boolean(bool value) override { return leaf(value); }
    bool number_integer(number_integer_t value) override { return leaf(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return leaf(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return leaf(value); }
    bool string(string_t& value) override {
        refuseZeros(value);
        return leaf(std::move(value));
    }
    bool binary(binary_t&) override { return false; }  // does not occur in a text
    bool start_object(std::size_t) override { return open(JsonObject{}); }
    bool start_array(std::size_t) override { return open(JsonList{}); }
    bool end_array() override {
        close();
        return true;
    }
    bool end_object() override {
        dropDuplicates(std::get<JsonObject>(open_.back().node.value));
        close();
        return true;
    }
    bool key(string_t& value) override {
        refuseZeros(value);
        if (value.size() > longestKey) {  // each pointer to what is below would be as long
            fail("the key " + inQuotes(value) + " is longer than " + std::to_string(longestKey) + " bytes",
                 "Shorten it");
            return false;
        }
        open_.back().key = std::move(value);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
        const std::string_view word = wordAround(text_, placeOfError());
        const std::string detail = detailOf(error.what());
        if (isNoFiniteNumber(word))
            fail(inQuotes(word) + " is not valid JSON: numbers must be finite", "Give a finite number");
        else
            fail("not valid JSON: " + detail, remedyFor(detail));
        return false;
    }

    JsonReading take() {
        if (!failed_)
            return {std::move(root_), std::move(problems_)};
        values_ = 0;  // closing nodes must not exceed the limit
        while (!open_.empty())
            close();
        return {{}, std::move(problems_), std::move(root_)};
    }

private:
    struct Open {
        JsonNode node;
        std::optional<std::string> key;  // key of the member that is being read
    };

    // Line that the parser has reached. The last character read is not counted, because the parser may have read one
    // character past a number.
    int line() {
        for (; counted_ + 1 < *reached_; ++counted_)
            line_ += *counted_ == '\n' ? 1 : 0;
        return line_;
    }

    // Position of the last character read.
    std::size_t placeOfError() const {
        const std::size_t read = *reached_ - text_.data();
        return read == 0 ? 0 : read - 1;
    }

    std::string pointer() const {
        std::string text;
        for (const Open& open : open_) {
            if (const auto* list = std::get_if<JsonList>(&open.node.value))
                text = under(text, list->size());
            else if (open.key)
                text = under(text, *open.key);
        }
        return text;
    }

    void fail(std::string message, std::string remedy) {
        failed_ = true;
        addProblem(problems_, {Severity::Error, "", line(), pointer(), std::move(message), std::move(remedy)});
    }

    /// Reports and removes zero characters, at which other programs end a text.
    void refuseZeros(std::string& text) {
        if (std::erase(text, '\0') > 0)
            addProblem(problems_, {Severity::Error, "", line(), pointer(),
                                   "the text " + inQuotes(text) + " contains a zero character (\\u0000)", "Remove it"});
    }

    template <typename Value>
    bool leaf(Value&& value) {
        return place(JsonNode{std::forward<Value>(value), line()});
    }

    bool place(JsonNode node) {
        if (++values_ > mostJsonValues) {
            fail("the text contains more than " + std::to_string(mostJsonValues) + " values", "Split the scene");
            return false;
        }
        if (open_.empty())
            root_ = std::move(node);
        else if (auto* list = std::get_if<JsonList>(&open_.back().node.value))
            list->push_back(std::move(node));
        else
            placeMember(std::move(node));
        return true;
    }

    void placeMember(JsonNode node) {
        Open& parent = open_.back();
        if (!parent.key)
            return;  // closing a node that an error left open
        std::get<JsonObject>(parent.node.value).push_back({std::move(*parent.key), std::move(node)});
        parent.key.reset();
    }

    template <typename Value>
    bool open(Value&& empty) {
        if (static_cast<int>(open_.size()) >= deepestJson) {
            open_.clear();  // the pointer would only be very long
            fail("lists and objects are nested more than " + std::to_string(deepestJson) + " levels deep",
                 "No scene needs this; look for superfluous brackets");
            return false;
        }
        open_.push_back({JsonNode{std::forward<Value>(empty), line()}, {}});
        return true;
    }

    void close() {
        JsonNode node = std::move(open_.back().node);
        open_.pop_back();
        place(std::move(node));
    }

    void dropDuplicates(JsonObject& members) {
        std::vector<std::size_t> order(members.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return members[a].key < members[b].key; });
        std::vector<bool> dropped(members.size(), false);
        for (std::size_t i = 1; i < order.size(); ++i) {
            const JsonMember& again = members[order[i]];
            if (members[order[i - 1]].key != again.key)
                continue;
            dropped[order[i]] = true;
            reportDuplicate(members[order[i - 1]], again);
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < members.size(); ++i)
            if (!dropped[i])
                std::swap(members[kept++], members[i]);
        members.resize(kept);
    }

    void reportDuplicate(const JsonMember& before, const JsonMember& again) {
        open_.back().key = again.key;  // so that the pointer ends with this key
        addProblem(problems_, {Severity::Error, "", again.node.line, pointer(),
                               "the key " + inQuotes(again.key) + " is given twice, first on line " +
                                   std::to_string(before.node.line),
                               "Keep one of the two"});
    }

    std::string_view text_;
    const char* counted_;
    const char** reached_;
    int line_ = 1;
    std::size_t values_ = 0;
    bool failed_ = false;
    std::vector<Open> open_;
    std::optional<JsonNode> root_;
    std::vector<Problem> problems_;
};

JsonReading refused(std::string message, std::string remedy) {
    return {{}, {{Severity::Error, "", 1, "", std::move(message), std::move(remedy)}}};
}

/// `UTF-16` or `UTF-32` if the text is in one of these, with or without a byte order mark. JSON begins with two
/// characters of ASCII, so zeros among the first four bytes show it (RFC 4627, section 3).
std::string_view otherEncoding(std::string_view text) {
    const std::string start = std::string(text.substr(0, 4)) + std::string(4, ' ');
    const auto zero = [&](std::size_t at) { return start[at] == '\0'; };
    if (zero(0) && zero(1) && zero(2) && zero(3)) return "";  // no text at all
    if ((zero(0) && zero(1)) || (zero(2) && zero(3))) return "UTF-32";
    const bool marked = text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE");
    return marked || zero(0) || zero(1) ? "UTF-16" : "";
}

const JsonNode* step(const JsonNode& node, const std::string& token) {
    if (const auto* list = std::get_if<JsonList>(&node.value)) {
        std::size_t index = list->size();
        std::from_chars(token.data(), token.data() + token.size(), index);
        return index < list->size() ? &(*list)[index] : nullptr;
    }
    return findMember(node, token);
}

std::string unescaped(std::string_view token) {
    std::string text;
    for (std::size_t i = 0; i < token.size(); ++i) {
        if (token[i] == '~' && i + 1 < token.size())
            text += token[++i] == '1' ? '/' : '~';
        else
            text += token[i];
    }
    return text;
}

}  // namespace

JsonReading readJson(std::string_view text) {
    if (text.size() > longestJson)
        return refused("the text is longer than " + std::to_string(longestJson >> 20) + " MB", "Split the scene");
    if (text.starts_with("\xEF\xBB\xBF"))
        return refused("the text begins with a byte order mark", "Save the file as UTF-8 without one");
    if (const std::string_view encoding = otherEncoding(text); !encoding.empty())
        return refused("the text is " + std::string(encoding), "Save the file as UTF-8");
    const char* reached = text.data();
    TreeBuilder builder(text, &reached);
    nlohmann::json::sax_parse(TellingIterator(text.data(), &reached),
                              TellingIterator(text.data() + text.size(), &reached), &builder);
    return builder.take();
}

const JsonNode* findMember(const JsonNode& node, std::string_view key) {
    const auto* object = std::get_if<JsonObject>(&node.value);
    if (!object)
        return nullptr;
    const auto found =
        std::find_if(object->begin(), object->end(), [&](const JsonMember& member) { return member.key == key; });
    return found == object->end() ? nullptr : &found->node;
}

namespace {

// Last value found on the path of the pointer; the rest of the path remains in `pointer`.
const JsonNode& follow(const JsonNode& root, std::string_view& pointer) {
    const JsonNode* node = &root;
    while (!pointer.empty()) {
        const auto end = std::min(pointer.find('/', 1), pointer.size());
        const JsonNode* next = step(*node, unescaped(pointer.substr(1, end - 1)));
        if (!next)
            break;
        node = next;
        pointer.remove_prefix(end);
    }
    return *node;
}

}  // namespace

const JsonNode* nodeAt(const JsonNode& root, std::string_view pointer) {
    const JsonNode& last = follow(root, pointer);
    return pointer.empty() ? &last : nullptr;
}

int lineAt(const JsonNode& root, std::string_view pointer) { return follow(root, pointer).line; }

std::string_view kindText(const JsonNode& node) {
    constexpr std::array<std::string_view, 6> texts{"null", "true or false", "a number", "a text", "a list",
                                                    "an object"};
    return texts[node.value.index()];
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!character.isValid) return false;
        text.remove_prefix(character.length);
    }
    return true;
}

}  // namespace keyblock
