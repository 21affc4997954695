// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help pages in the window, with a search over all of them. F1 opens them at the
// field or tool under the cursor.
#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;
class QTextBrowser;
class QTextDocument;
class QUrl;

namespace keyblock {

class Themes;

class HelpView : public QWidget {
    Q_OBJECT

public:
    explicit HelpView(const Themes& themes, QWidget* parent = nullptr);

    /// Shows a page, at the first occurrence of `words` (a heading or a field's name); without words at its beginning.
    void open(const QString& page, const QString& words = {}, int occurrence = 0);
    /// Shows search results for the words.
    void search(const QString& words);

Q_SIGNALS:
    void closeWanted();

private:
    QWidget* makeCloseButton();
    void setPage(const QString& markdown);
    void makeReadable(QTextDocument& document) const;
    void follow(const QUrl& link);
    bool goTo(const QString& words, int occurrence);

    const Themes& themes_;
    QComboBox* pages_;
    QLineEdit* words_;
    QTextBrowser* text_;
    QString shown_;
};

/// The help topic of a widget: the nearest `helpTopic` property of it or its parents, `page` or `page#words`.
QString helpTopicOf(const QWidget* widget);

}  // namespace keyblock
