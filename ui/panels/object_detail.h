// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A few words beside a name that tell one thing from the next: `35° · 1.2 m`.
#pragma once

#include <QString>

#include <string>

namespace keyblock {

class Display;
class Document;

/// Of the object at `pointer`, in the units shown; empty where nothing is worth saying.
QString detailOf(const Document& document, const Display& display, const std::string& pointer);

/// Icon of the object's kind, by name.
QString iconOf(const Document& document, const std::string& pointer);

}  // namespace keyblock
