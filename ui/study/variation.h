// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that vary in a study: how they are given, and a first suggestion for fields of a
// scene.
#pragma once

#include "solver/scene/field.h"
#include "solver/scene/scene.h"
#include "solver/study/study.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// How the values of a parameter are given.
enum class ValueChoice { List, Range, Uniform, Triangular, Normal, Lognormal, Seed };

/// Titles of the choices, in their order.
QStringList valueChoices();

ValueChoice choiceOf(const StudyParameter& parameter);

/// Gives the values in another way. The new numbers lie around those that the parameter has.
void choose(StudyParameter& parameter, ValueChoice choice);

/// Short text of the values, such as "normal, mean 36, deviation 3, 20 to 52".
QString valuesText(const StudyParameter& parameter);

/// Short text of a fault, such as "missing, 5 % of the bolts".
QString faultText(const StudyFault& fault);

/// Path of a value as in `--set`: `bolts.B1.pretension`; names in place of the numbers of list items where that is
/// possible.
std::string studyPathOf(const Scene& scene, const std::string& pointer);

/// The field of the scene at such a path; null if there is none.
const Field* fieldAtPath(const std::string& path);

/// A suggestion to vary a field of one or several objects around its value: a normal distribution for numbers,
/// truncated at the range of the field, all choices for words and flags, another number for seeds. None if a study
/// cannot vary this field.
std::optional<StudyParameter> variationOf(const Scene& scene, const std::vector<std::string>& pointers);

}  // namespace keyblock
