// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A short text after a name that distinguishes objects: `35° · 1.2 m`.
#pragma once

#include <QString>

#include <string>

namespace keyblock {

class Display;
class Document;

/// For the object at `pointer`, in the units shown; may be empty.
QString detailOf(const Document& document, const Display& display, const std::string& pointer);

/// Icon of the object's kind, by name.
QString iconOf(const Document& document, const std::string& pointer);

}  // namespace keyblock
