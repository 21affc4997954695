// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A report as one HTML file that needs no other file and no network.
#pragma once

#include "ui/report/report_document.h"

#include <string>

namespace keyblock {

/// The document as HTML 5 with its style and its figures inside. The same document gives the same bytes.
std::string reportHtml(const ReportDocument& document);

}  // namespace keyblock
