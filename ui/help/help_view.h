// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows the help pages in the window, with a search in all of them. F1 opens the help
// on the field or tool under the cursor.
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

    /// Shows a page.
    /// \param words text to scroll to, e.g. a heading or the name of a field; empty: the top of the page
    /// \param occurrence which occurrence of `words` to show, counted from 0
    void open(const QString& page, const QString& words = {}, int occurrence = 0);
    /// Shows the results of a search for `words`.
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

/// Help topic of a widget, in the form `page` or `page#words`. It is the `helpTopic` property of the widget or of its
/// nearest parent that has this property.
QString helpTopicOf(const QWidget* widget);

}  // namespace keyblock
