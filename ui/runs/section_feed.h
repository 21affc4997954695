// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes pictures of results on a thread of its own: of the moment that the
// time cursor shows, as the view settings ask for, with ranges over all frames of the
// run. Of a run that goes on the ranges grow with the frames that are shown.
#pragma once

#include "ui/document/background.h"
#include "ui/picture/section.h"

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

    /// Whether results are wanted, where there are any, or the scene as it is drawn.
    void showResults(bool results);
    bool showsResults() const;

    /// Ranges over this run and another that stands beside it, alike in both; null: over this one alone. One of the two
    /// leads: limits of the steel and round-off are those of its scene.
    void shareRanges(std::shared_ptr<const LiveRun> other, bool leads);

    /// The newest picture of results; null before the first.
    const std::shared_ptr<const SectionPicture>& picture() const { return picture_; }
    /// The frame that it is of.
    const std::shared_ptr<const Frame>& frame() const { return frame_; }

Q_SIGNALS:
    void pictureChanged();
    void modeChanged();  // from results to drawing or back
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
    std::shared_ptr<Ranges> ranges_;  // of the run and the quantities shown
    std::shared_ptr<const LiveRun> other_;  // whose ranges are shared
    bool leads_ = true;
    std::shared_ptr<const SectionPicture> picture_;
    std::shared_ptr<const Frame> frame_;
    Background painting_, gathering_;
};

}  // namespace keyblock
