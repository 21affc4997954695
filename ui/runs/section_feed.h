// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the drawings of results on its own thread, for the time shown and with the view
// settings. Colour ranges cover all frames of the run; during a run they grow with the
// frames shown.
#pragma once

#include "ui/document/background.h"
#include "ui/picture/section/section.h"

#include <QObject>

#include <memory>
#include <optional>

namespace keyblock {

class BoltChoice;
class Display;
class LiveRun;
class TimeCursor;
class ViewSettings;

class SectionFeed : public QObject {
    Q_OBJECT

public:
    SectionFeed(const BoltChoice& choice, TimeCursor& cursor, ViewSettings& settings, const Display& display,
                QObject* parent = nullptr);
    ~SectionFeed() override;

    /// True: shows results if there are any. False: shows the drawing.
    void showResults(bool results);
    bool showsResults() const;

    /// Makes the run of this feed share its colour ranges with the run `other`; null: the ranges are not shared.
    /// \param leads true: the steel limits and the round-off threshold of this feed's scene apply to both runs; false:
    /// those of the other run's scene. Must be true for exactly one of the two feeds, and true if `other` is null.
    void shareRanges(std::shared_ptr<const LiveRun> other, bool leads);

    /// The latest drawing of results; null before the first.
    const std::shared_ptr<const SectionPicture>& picture() const { return picture_; }
    /// The frame that `picture` shows; null before the first drawing.
    const std::shared_ptr<const Frame>& frame() const { return frame_; }

Q_SIGNALS:
    void pictureChanged();
    void modeChanged();  // switched between results and drawing
    void failed(const QString& message);  // a frame could not be read

private:
    struct Ranges;

    void runChanged();
    void runEnded();
    void make();
    void gatherRanges();
    std::shared_ptr<Ranges> emptyRanges() const;
    void takeRanges(std::shared_ptr<Ranges> ranges);
    SectionRequest request() const;
    void put(std::shared_ptr<const SectionPicture> picture, std::shared_ptr<const Frame> frame);

    const BoltChoice& choice_;
    TimeCursor& cursor_;
    ViewSettings& settings_;
    const Display& display_;
    bool results_ = true, showed_ = false, goesOn_ = false;
    std::shared_ptr<Ranges> ranges_;  // colour ranges of the run for the quantities shown
    std::shared_ptr<const LiveRun> other_;  // second run with the same colour ranges
    bool leads_ = true;
    std::shared_ptr<const SectionPicture> picture_;
    std::shared_ptr<const Frame> frame_;
    Background painting_, gathering_;
};

}  // namespace keyblock
