// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Logic of three values: a criterion may be decided although one of its quantities has
// no value.
#include "solver/study/failure_criterion.h"

#include "solver/scene/suggest.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace keyblock {

namespace {

using Decision = std::optional<bool>;

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Parts of a text between a word, e.g. ` or `.
std::vector<std::string_view> partsBetween(std::string_view text, std::string_view word) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto at = text.find(word);
        parts.push_back(trimmed(text.substr(0, at)));
        if (at == std::string_view::npos) return parts;
        text = text.substr(at + word.size());
    }
}

struct TermReading {
    FailureTerm term;
    std::string problem, remedy;
};

constexpr const char* forms =
    "Write e.g. \"max key.u > 0.05\", \"not stands\" or \"lost bolt\", joined by \"and\" and \"or\"";

std::string quantityProblem(const std::string& quantity, const Scene& scene) {
    const QuantityReading reading = readQuantity(quantity, scene);
    if (!reading.quantity) return reading.problem;
    return reading.quantity->kind == QuantityKind::Order ? "an order cannot be compared with a number" : "";
}

TermReading comparison(std::string_view text, std::size_t at, const Scene& scene) {
    FailureTerm term;
    const bool below = text[at] == '<', orEqual = at + 1 < text.size() && text[at + 1] == '=';
    using enum FailureTerm::Compare;
    term.compare = below ? (orEqual ? AtMost : Below) : (orEqual ? AtLeast : Above);
    term.quantity = trimmed(text.substr(0, at));
    const std::string_view number = trimmed(text.substr(at + (orEqual ? 2 : 1)));
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), term.number);
    if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(term.number))
        return {{}, inQuotes(number) + " is not a number", forms};
    return {term, quantityProblem(term.quantity, scene), "Correct the quantity"};
}

TermReading termOf(std::string_view text, const Scene& scene) {
    const bool negated = text.starts_with("not ");
    if (negated) text = trimmed(text.substr(4));
    TermReading reading;
    if (text == "lost bolt" || text == "any lost bolt") reading.term.quantity.clear();
    else if (text == "stands") reading.term = {"stands", FailureTerm::Compare::Above, 0.5};
    else if (const auto at = text.find_first_of("<>"); at != std::string_view::npos)
        reading = comparison(text, at, scene);
    else reading = {{}, inQuotes(text) + " is not a condition", forms};
    reading.term.negated = negated;
    return reading;
}

Decision holds(const FailureTerm& term, const std::function<std::optional<double>(const std::string&)>& value,
               bool lost) {
    if (term.quantity.empty()) return lost != term.negated;
    const std::optional<double> measured = value(term.quantity);
    if (!measured || std::isnan(*measured)) return std::nullopt;
    switch (term.compare) {
        case FailureTerm::Compare::Above: return (*measured > term.number) != term.negated;
        case FailureTerm::Compare::AtLeast: return (*measured >= term.number) != term.negated;
        case FailureTerm::Compare::Below: return (*measured < term.number) != term.negated;
        default: return (*measured <= term.number) != term.negated;
    }
}

}  // namespace

FailureReading readFailure(std::string_view text, const Scene& scene) {
    FailureCriterion criterion;
    for (const std::string_view alternative : partsBetween(text, " or ")) {
        criterion.anyOf.emplace_back();
        for (const std::string_view part : partsBetween(alternative, " and ")) {
            TermReading reading = termOf(part, scene);
            if (!reading.problem.empty()) return {std::nullopt, std::move(reading.problem), std::move(reading.remedy)};
            criterion.anyOf.back().push_back(std::move(reading.term));
        }
    }
    return {std::move(criterion), "", ""};
}

std::vector<std::string> quantitiesOf(const FailureCriterion& criterion) {
    std::vector<std::string> quantities;
    for (const std::vector<FailureTerm>& terms : criterion.anyOf)
        for (const FailureTerm& term : terms)
            if (!term.quantity.empty() && !std::count(quantities.begin(), quantities.end(), term.quantity))
                quantities.push_back(term.quantity);
    return quantities;
}

bool lostBolt(std::span<const Event> events) {
    return std::any_of(events.begin(), events.end(), [](const Event& event) {
        return event.kind == EventKind::TensileRupture || event.kind == EventKind::ShearRupture ||
               event.kind == EventKind::BoltLoss;
    });
}

std::optional<bool> fails(const FailureCriterion& criterion,
                          const std::function<std::optional<double>(const std::string&)>& value, bool lostBolt) {
    bool open = false;  // an alternative is undecided
    for (const std::vector<FailureTerm>& terms : criterion.anyOf) {
        bool unmet = false, unknown = false;
        for (const FailureTerm& term : terms) {
            const Decision decision = holds(term, value, lostBolt);
            unknown = unknown || !decision;
            unmet = unmet || (decision && !*decision);
        }
        if (!unmet && !unknown) return true;
        open = open || (!unmet && unknown);
    }
    return open ? std::nullopt : std::optional(false);
}

}  // namespace keyblock
