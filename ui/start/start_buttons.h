// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two kinds of buttons on the start page that open a scene: cards for samples and
// rows for recent files. Both paint themselves.
#pragma once

#include "ui/start/thumbnails.h"

#include <QAbstractButton>
#include <QDateTime>
#include <QImage>

namespace keyblock {

class Themes;
struct RecentFile;
struct Sample;

class SampleCard : public QAbstractButton {
    Q_OBJECT

public:
    static constexpr int picture = 165, height = 265, leastWidth = 300;  // [px]

    SampleCard(const Sample& sample, const Themes& themes, QWidget* parent = nullptr);
    void setPicture(const QImage& image);
    bool hasPicture() const { return !image_.isNull(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Themes& themes_;
    QString line_, facts_;
    QImage image_;
};

class RecentRow : public QAbstractButton {
    Q_OBJECT

public:
    static constexpr int height = 64, thumbWidth = 73, thumbHeight = 49;  // [px]

    RecentRow(const RecentFile& file, const Themes& themes, QWidget* parent = nullptr);
    void setPicture(const QImage& image, const SceneFacts& facts);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QString factsText() const;

    const Themes& themes_;
    QString name_, time_;
    bool exists_;
    bool known_ = false;
    SceneFacts facts_;
    QImage image_;
};

/// A point in time as text, e.g. `today 14:20`, `yesterday`, `18 Nov` or `18 Nov 2025`.
QString whenText(const QDateTime& when, const QDateTime& now = QDateTime::currentDateTime());

/// A duration as text, e.g. `0.3 s`, `8 s` or `2 min`.
QString durationText(double seconds);

}  // namespace keyblock
