// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small drawings of scenes for lists and cards: rock and bolts without names, numbers
// or legends. The colours of blocks only distinguish neighbours.
#pragma once

#include <QImage>
#include <QSize>

namespace keyblock {

struct SectionPicture;
struct Theme;

enum class ThumbnailView { Heart, Everything };  // the relevant part, cropped if necessary; or the whole scene

/// Paints the drawing of a scene as a thumbnail.
/// \param pixels size of the image
/// \param ratio device pixel ratio, which determines the line widths
QImage paintThumbnail(const SectionPicture& picture, QSize pixels, double ratio, const Theme& theme,
                      ThumbnailView view = ThumbnailView::Heart);

}  // namespace keyblock
