// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A short text after the name of an object that helps to tell objects apart, e.g.
// `35° · 1.2 m`.
#pragma once

#include <QString>

#include <string>

namespace keyblock {

class Display;
class Document;

/// The text shown after the name of the object at `pointer`, in display units; may be empty.
QString detailOf(const Document& document, const Display& display, const std::string& pointer);

/// Name of the icon for this kind of object.
QString iconOf(const Document& document, const std::string& pointer);

}  // namespace keyblock
