// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A report as PDF on A4 pages with contents, captions and page numbers.
#pragma once

#include "ui/report/report_document.h"

#include <string>

namespace keyblock {

/// The document as PDF. Text can be searched and figures are vector graphics. The same document gives the same bytes.
/// \throws CannotDraw if a figure or the logo cannot be painted.
std::string reportPdf(const ReportDocument& document);

}  // namespace keyblock
