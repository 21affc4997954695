// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene as a small picture for lists and cards: rock and bolts without names, numbers
// or legends. The tints of blocks only distinguish neighbours.
#pragma once

#include <QImage>
#include <QSize>

namespace keyblock {

struct SectionPicture;
struct Theme;

enum class ThumbnailView { Heart, Everything };  // the relevant part, clipped if necessary; or everything

/// The picture of a scene as drawn, `pixels` large; stroke widths are those of a screen with pixel ratio `ratio`.
QImage paintThumbnail(const SectionPicture& picture, QSize pixels, double ratio, const Theme& theme,
                      ThumbnailView view = ThumbnailView::Heart);

}  // namespace keyblock
