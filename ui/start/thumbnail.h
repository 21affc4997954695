// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene as a small picture for lists and cards: rock and bolts without names,
// numbers or legends. The tints of the blocks only tell one from the next.
#pragma once

#include <QImage>
#include <QSize>

namespace keyblock {

struct SectionPicture;
struct Theme;

enum class ThumbnailView { Heart, Everything };  // what matters, cut off where it must be; or all of it

/// The picture of a scene as drawn, `pixels` large; sizes of strokes are those of a screen whose pixels count `ratio`.
QImage paintThumbnail(const SectionPicture& picture, QSize pixels, double ratio, const Theme& theme,
                      ThumbnailView view = ThumbnailView::Heart);

}  // namespace keyblock
