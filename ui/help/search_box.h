// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The box at the right of the menu bar. It looks like a search field and opens the
// command palette.
#pragma once

#include <QAbstractButton>

namespace keyblock {

class Themes;

class SearchBox : public QAbstractButton {
    Q_OBJECT

public:
    /// \param command the command that opens the palette; its shortcut is shown in the box
    SearchBox(QAction& command, const Themes& themes, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {196, 24}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QAction& command_;
    const Themes& themes_;
};

}  // namespace keyblock
