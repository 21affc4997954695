// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples as cards, in as many columns as fit, with buttons that filter them by
// kind.
#pragma once

#include "ui/start/samples.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QScrollArea;

namespace keyblock {

class SampleCard;
class Themes;
class Thumbnails;

class Gallery : public QWidget {
    Q_OBJECT

public:
    Gallery(const Themes& themes, Thumbnails& thumbnails, QWidget* parent = nullptr);

Q_SIGNALS:
    void wanted(const keyblock::Sample& sample);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeHeader();
    void makeCards();
    void place();
    void askForPictures();
    bool isShown(const Sample& sample) const;
    void step(SampleCard* from, int columns, int key);

    const Themes& themes_;
    Thumbnails& thumbnails_;
    std::vector<Sample> samples_;
    std::vector<SampleCard*> cards_;
    QButtonGroup* kinds_;
    QScrollArea* scroll_;
    QWidget* sheet_;
    QWidget *title_ = nullptr, *hint_ = nullptr;
    int columns_ = 1;
    double asked_ = 0.0;  // pixel ratio of the requested pictures; 0: none requested yet
};

}  // namespace keyblock
