// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/study_check.h"

#include "solver/files/json/json_tree.h"
#include "solver/files/scene/overrides.h"
#include "solver/run/strength_reduction.h"
#include "solver/scene/check_report.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/quantity_text.h"
#include "solver/scene/suggest.h"
#include "solver/study/case_plan.h"
#include "solver/study/distributions.h"
#include "solver/study/failure_criterion.h"
#include "solver/study/study_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 8> ownColumns{
    "case", "outcome", "reason", "stands", "fails", "factor_of_safety", "factor_of_safety_upper", ""};

/// The field to which the keys of a path lead, and the first key that no table knows.
struct FieldOnPath {
    const Field* field = nullptr;  // null: an item of a list, or unknown
    std::string unknown;
    std::vector<std::string_view> known;  // keys at the position of the unknown one
};

FieldOnPath fieldAlong(const std::vector<std::string>& keys) {
    FieldOnPath found;
    const Structure* structure = &sceneStructure();
    bool inMembers = true;  // the next key is a field, not an item
    for (const std::string& key : keys) {
        if (!inMembers) {
            inMembers = true;
            found.field = nullptr;
            continue;
        }
        if (found.field && !hasChildren(*found.field)) return found;  // inside a value, such as a point
        found.field = findField(*structure, key);
        if (!found.field) {
            found.unknown = key;
            for (const Field& field : structure->fields) found.known.push_back(field.key);
            return found;
        }
        if (!hasChildren(*found.field)) continue;
        structure = &found.field->children.structure();
        inMembers = found.field->kind == FieldKind::Object;
    }
    return found;
}

bool isNumber(const Field& field) { return field.kind == FieldKind::Number || field.kind == FieldKind::Integer; }

/// The checks of one study.
class StudyCheck {
public:
    StudyCheck(const Study& study, const SceneReading& read, const std::string& sceneText)
        : study_(study), read_(read), sceneText_(sceneText) {}

    std::vector<Problem> problems() {
        checkPlan();
        checkNames();
        for (std::size_t i = 0; i < study_.parameters.size(); ++i) checkParameter(i);
        for (std::size_t i = 0; i < study_.faults.size(); ++i) checkFault(i);
        checkResults();
        if (!hasErrors(report_.problems)) checkMiddle();
        return std::move(report_.problems);
    }

private:
    const Scene& scene() const { return *read_.scene; }
    const Scene& solved() const { return read_.cut ? read_.cut->scene : *read_.scene; }

    void checkPlan() {
        const bool factorial = study_.plan.kind == PlanKind::FullFactorial;
        if (!factorial && !study_.plan.cases)
            report_.error("/plan/cases", "the plan has no number of cases", "Add \"cases\", e.g. 1000");
        if (factorial && combinationsOf(study_) > mostCases)
            report_.error("/plan", "there are more than " + std::to_string(mostCases) + " combinations",
                          "Give fewer values, or draw a number of cases with \"latin-hypercube\"");
        if (study_.parameters.empty() && study_.faults.empty())
            report_.error("/parameters", "nothing varies", "Add a parameter or a fault");
    }

    void checkNames() {
        std::vector<std::string> used;
        const auto check = [&](const std::string& name, const std::string& pointer) {
            if (std::ranges::count(used, name))
                report_.error(pointer, "the name " + inQuotes(name) + " is used twice", "Give another name");
            if (std::ranges::count(ownColumns, name))
                report_.error(pointer, inQuotes(name) + " is a column of the results", "Give another name");
            if (std::ranges::any_of(name, [](unsigned char c) { return c < ' '; }))
                report_.error(pointer, "the name contains a control character", "Give a name on one line");
            used.push_back(name);
        };
        for (std::size_t i = 0; i < study_.parameters.size(); ++i)
            check(study_.parameters[i].name, under(under("/parameters", i), "name"));
        for (std::size_t i = 0; i < study_.faults.size(); ++i)
            check(study_.faults[i].name, under(under("/faults", i), "name"));
    }

    void checkParameter(std::size_t index) {
        const StudyParameter& parameter = study_.parameters[index];
        const std::string pointer = under("/parameters", index);
        const int given = !parameter.values.empty() + parameter.range.has_value() + parameter.distribution.has_value();
        if (given != 1)
            return report_.error(pointer, "the parameter needs exactly one of 'values', 'range' and 'distribution'",
                                 given == 0 ? "Add one of them" : "Remove the others");
        if (parameter.distribution) checkDistribution(*parameter.distribution, under(pointer, "distribution"));
        if (hasErrors(report_.problems)) return;
        checkPath(parameter, parameter.path, under(pointer, "path"), pointer);
        for (std::size_t i = 0; i < parameter.also.size(); ++i)
            checkPath(parameter, parameter.also[i], under(under(pointer, "also"), i), pointer);
    }

    void checkDistribution(const StudyDistribution& d, const std::string& pointer) {
        const auto needs = [&](const std::optional<double>& number, std::string_view key) {
            if (!number) report_.error(under(pointer, key), "the distribution has no " + inQuotes(key), "Add it");
            return number.has_value();
        };
        const bool seeds = d.kind == DistributionKind::Seed;
        if (seeds) return;
        if (study_.plan.kind == PlanKind::FullFactorial)
            return report_.error(pointer, "a full factorial plan has no draws from distributions",
                                 "Give 'values' or a 'range', or choose another plan");
        const bool normal = d.kind == DistributionKind::Normal || d.kind == DistributionKind::Lognormal;
        bool whole = normal ? needs(d.mean, "mean") & needs(d.deviation, "deviation")
                            : needs(d.least, "least") & needs(d.most, "most");
        if (d.kind == DistributionKind::Triangular) whole = needs(d.peak, "peak") && whole;
        if (!whole) return;
        if (d.least && d.most && *d.least >= *d.most)
            return report_.error(under(pointer, "most"),
                                 "'most' is " + shortest(*d.most) + ", not above 'least', " + shortest(*d.least),
                                 "Give a larger number");
        if (d.peak && (*d.peak < *d.least || *d.peak > *d.most))
            return report_.error(under(pointer, "peak"),
                                 "'peak' is " + shortest(*d.peak) + ", not between 'least' and 'most'",
                                 "Give a number between them");
        if (d.kind == DistributionKind::Lognormal && *d.mean <= 0.0)
            return report_.error(under(pointer, "mean"), "the mean of a lognormal distribution is positive",
                                 "Give a number above 0");
        checkTruncation(d, pointer);
    }

    void checkTruncation(StudyDistribution d, const std::string& pointer) {
        if (d.kind != DistributionKind::Normal && d.kind != DistributionKind::Lognormal) return;
        const std::optional<double> least = d.least, most = d.most;
        d.least.reset();
        d.most.reset();
        const double kept = (most ? shareBelow(d, *most) : 1.0) - (least ? shareBelow(d, *least) : 0.0);
        if (kept < 1e-6)
            report_.error(pointer, "less than a millionth of the distribution lies between 'least' and 'most'",
                          "Give bounds around its mean");
    }

    /// Extreme values of a parameter that is a number.
    std::vector<double> extremesOf(const StudyParameter& parameter) const {
        if (parameter.range) return {parameter.range->from, parameter.range->to};
        std::vector<double> numbers;
        if (!parameter.distribution) {
            for (const std::string& value : parameter.values) {
                double number = 0.0;
                const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
                if (error == std::errc() && end == value.data() + value.size()) numbers.push_back(number);
            }
            return numbers;
        }
        const StudyDistribution& d = *parameter.distribution;
        if (d.least) numbers.push_back(*d.least);
        if (d.most) numbers.push_back(*d.most);
        return numbers;
    }

    void checkPath(const StudyParameter& parameter, const std::string& path, const std::string& pointer,
                   const std::string& parameterPointer) {
        const std::vector<std::string> keys = keysOfPath(path);
        const FieldOnPath place = fieldAlong(keys);
        if (!place.unknown.empty())
            return report_.error(
                pointer,
                "the scene has no field " + inQuotes(path) + ": " + inQuotes(place.unknown) + " is not a key there",
                suggestion(place.unknown, place.known));
        if (std::find(paths_.begin(), paths_.end(), keys) != paths_.end())
            report_.error(pointer, inQuotes(path) + " is set twice", "Name it in one parameter only");
        paths_.push_back(keys);
        checkItems(path, pointer);
        if (place.field) checkRangeOf(*place.field, parameter, pointer, parameterPointer);
    }

    /// Applies a value to the scene's text, which shows whether the items of lists on the path exist.
    void checkItems(const std::string& path, const std::string& pointer) {
        JsonReading json = readJson(sceneText_);
        if (!json.root) return;
        std::vector<Problem> found;
        const std::vector<std::string> option{path + "=0"};
        applyOverrides(*json.root, option, found);
        for (const Problem& problem : found) report_.error(pointer, problem.message, problem.remedy);
    }

    void checkRangeOf(const Field& field, const StudyParameter& parameter, const std::string& pointer,
                      const std::string& parameterPointer) {
        const bool drawn = parameter.distribution && parameter.distribution->kind != DistributionKind::Seed;
        if (!isNumber(field) && (drawn || parameter.range))
            return report_.error(pointer, inQuotes(field.key) + " is not a number", "Give a list of 'values'");
        if (field.kind == FieldKind::Integer && drawn)
            return report_.error(pointer, inQuotes(field.key) + " is a whole number",
                                 "Give 'values' or a 'range' of whole numbers, or for a seed the distribution 'seed'");
        if (!isNumber(field)) return;
        for (const double number : extremesOf(parameter))
            if (!contains(field.range, number))
                return report_.error(parameterPointer, shortest(number) + " is out of range for " + inQuotes(field.key),
                                     "Give numbers " + rangeText(field.range));
        if (drawn) checkTails(field, *parameter.distribution, parameterPointer);
    }

    void checkTails(const Field& field, const StudyDistribution& d, const std::string& pointer) {
        const double below = std::isfinite(field.range.least) ? shareBelow(d, field.range.least) : 0.0;
        const double above = std::isfinite(field.range.most) ? 1.0 - shareBelow(d, field.range.most) : 0.0;
        constexpr double none = 1e-9, many = 0.5;
        if (below + above > many)
            report_.error(pointer, "most of the distribution is out of range for " + inQuotes(field.key),
                          "Give numbers " + rangeText(field.range));
        else if (below + above > none)
            report_.warning(pointer,
                            rounded(100.0 * (below + above)) +
                                " % of the cases will be invalid: numbers out of "
                                "range for " +
                                inQuotes(field.key),
                            "Truncate the distribution with 'least' and 'most'");
    }

    void checkFault(std::size_t index) {
        const StudyFault& fault = study_.faults[index];
        const std::string pointer = under("/faults", index);
        if (solved().bolts.empty())
            return report_.error(pointer, "the scene has no bolts", "Remove the faults, or add bolts to the scene");
        std::vector<std::string_view> names;
        for (const ScenePattern& pattern : scene().boltPatterns) names.push_back(pattern.name);
        for (const Bolt& bolt : solved().bolts) names.push_back(bolt.name);
        for (std::size_t i = 0; i < fault.bolts.size(); ++i)
            if (!std::ranges::count(names, fault.bolts[i]))
                report_.error(under(under(pointer, "bolts"), i), "there is no bolt " + inQuotes(fault.bolts[i]),
                              suggestion(fault.bolts[i], names));
        if (fault.kind == FaultKind::BondLost && fault.share.x() > fault.share.y())
            report_.error(under(pointer, "share"), "the least share is above the most", "Write [least, most]");
        if (fault.kind == FaultKind::BondLost && fault.share.y() == 0.0)
            report_.error(under(pointer, "share"), "no bond is lost", "Write [least, most], e.g. [0.1, 0.5]");
        if (fault.kind == FaultKind::Misplaced && fault.offsetDeviation == 0.0 && fault.angleDeviation == 0.0)
            report_.error(pointer, "neither offset nor angle varies", "Give 'offset_deviation' or 'angle_deviation'");
    }

    void checkQuantity(const std::string& text, const std::string& pointer) {
        const QuantityReading reading = readQuantity(text, solved());
        if (!reading.quantity) return report_.error(pointer, reading.problem, "Correct the quantity");
        if (reading.quantity->kind == QuantityKind::FactorOfSafety && !study_.safety)
            report_.error(pointer, "the factor of safety is not searched for", "Write \"safety\": true");
    }

    void checkResults() {
        if (scene().stages.empty())
            report_.error("/scene", "the scene has no stages, so there is nothing to run", "Add a stage to it");
        for (std::size_t i = 0; i < study_.quantities.size(); ++i)
            checkQuantity(study_.quantities[i], under("/quantities", i));
        if (!study_.fails.empty()) {
            const FailureReading reading = readFailure(study_.fails, solved());
            if (!reading.criterion) report_.error("/fails", reading.problem, reading.remedy);
            else
                for (const std::string& quantity : quantitiesOf(*reading.criterion)) checkQuantity(quantity, "/fails");
        }
        if (study_.safety)
            for (const Problem& problem : checkSafety(scene()))
                report_.error("/safety", problem.message, problem.remedy);
    }

    /// Reads the scene with the first value of each parameter, or the median.
    void checkMiddle() {
        std::vector<std::string> row;
        for (const StudyParameter& parameter : study_.parameters) {
            const std::optional<StudyDistribution>& d = parameter.distribution;
            row.push_back(d && d->kind == DistributionKind::Seed ? "1"
                          : d                                    ? shortest(quantileOf(*d, 0.5))
                          : parameter.range                      ? shortest(parameter.range->from)
                                                                 : cellOf(parameter.values.front()));
        }
        const std::vector<std::string> overrides = overridesOf(study_, row);
        const SceneReading middle = readSceneText(sceneText_, study_.scene, overrides, std::nullopt);
        for (const Problem& problem : middle.problems)
            if (problem.severity == Severity::Error)
                report_.error("/parameters", "with the first or median values: " + oneLine(problem),
                              "Correct the parameters");
    }

    const Study& study_;
    const SceneReading& read_;
    const std::string& sceneText_;
    std::vector<std::vector<std::string>> paths_;
    CheckReport report_;
};

}  // namespace

std::vector<Problem> checkStudy(const Study& study, const SceneReading& read, const std::string& sceneText) {
    return StudyCheck(study, read, sceneText).problems();
}

}  // namespace keyblock
