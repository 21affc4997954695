// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common part of the panels that run a scene many times in the background: what
// has been found, a progress bar, the buttons that start and stop the runs, and below
// them the content of each panel. Everything stays whole in a narrow or low dock, which
// then scrolls.
#pragma once

#include <QScrollArea>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace keyblock {

class TrialPanel : public QScrollArea {
    Q_OBJECT

Q_SIGNALS:
    void startAsked();
    void stopAsked();

protected:
    /// \param key first part of all object names; \param name of the panel; \param start text of the button.
    TrialPanel(const QString& key, const QString& name, const QString& start, QWidget* parent);

    /// Adds the content below the answer, which takes the remaining height.
    void setContent(QWidget* content);
    /// Keeps a line for the detail while it is empty, so that the content does not move.
    void keepDetailLine();
    /// \param fraction that is completed, 0 … 1, while `busy`. \param answer one sentence; \param detail remarks on it.
    void present(bool busy, double fraction, const QString& answer, const QString& detail);

    /// Puts the button below the text where there is little room next to it.
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    QWidget* page_;
    QLabel *answer_, *detail_;
    QBoxLayout* row_;
    QVBoxLayout* column_;
    QProgressBar* progress_;
    QPushButton *start_, *stop_;
    bool keepsDetail_ = false;
};

}  // namespace keyblock
