// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_view.h"

#include "ui/help/help_pages.h"
#include "ui/look/theme.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <QUrlQuery>
#include <QVBoxLayout>
#include <QVariant>

#include <array>

namespace keyblock {

namespace {

constexpr std::array headingSizes{20, 20, 16, 13, 12, 12, 12};  // [px], by level

constexpr int settleTime = 150;  // [ms]

QString linkTo(const HelpHit& hit, const QString& words) {
    QUrlQuery query;
    query.addQueryItem("words", QString::fromLatin1(QUrl::toPercentEncoding(words)));
    query.addQueryItem("n", QString::number(hit.occurrence));
    QUrl url;
    url.setScheme("help");
    url.setPath(hit.page->name);
    url.setQuery(query);
    return url.toString(QUrl::FullyEncoded);
}

}  // namespace

HelpView::HelpView(const Themes& themes, QWidget* parent)
    : QWidget(parent), themes_(themes), pages_(new QComboBox(this)), words_(new QLineEdit(this)),
      text_(new QTextBrowser(this)) {
    setObjectName("helpView");
    pages_->setObjectName("help.pages");
    pages_->setAccessibleName(tr("Help page"));
    for (const HelpPage& page : helpPages()) pages_->addItem(page.title, page.name);
    words_->setObjectName("help.search");
    words_->setAccessibleName(tr("Search help"));
    words_->setPlaceholderText(words_->accessibleName());
    words_->setClearButtonEnabled(true);
    text_->setObjectName("help.text");
    text_->setAccessibleName(tr("Help text"));
    text_->setOpenLinks(false);
    text_->setWordWrapMode(QTextOption::WordWrap);  // wider tables scroll horizontally
    text_->setFrameShape(QFrame::NoFrame);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 6, 8, 6);
    row->setSpacing(8);
    row->addWidget(pages_, 1);
    row->addWidget(words_, 1);
    row->addWidget(makeCloseButton());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(text_, 1);
    connect(pages_, qOverload<int>(&QComboBox::activated), this, [this](int row_) { open(pages_->itemData(row_).toString()); });
    connect(words_, &QLineEdit::returnPressed, this, [this] { search(words_->text()); });
    connect(text_, &QTextBrowser::anchorClicked, this, &HelpView::follow);
    connect(&themes, &Themes::changed, this, [this] {
        const QString again = shown_;
        shown_.clear();
        open(again);
    });
    if (!helpPages().empty()) open(helpPages().front().name);
}

/// A close button of its own, because a dock in a tab group has no header with one.
QWidget* HelpView::makeCloseButton() {
    auto* button = new QToolButton(this);
    button->setObjectName("help.close");
    button->setAccessibleName(tr("Close help"));
    button->setToolTip(button->accessibleName());
    button->setFixedSize(22, 22);
    const auto look = [this, button] { button->setIcon(themes_.icon("close")); };
    look();
    connect(&themes_, &Themes::changed, button, look);
    connect(button, &QToolButton::clicked, this, &HelpView::closeWanted);
    return button;
}

void HelpView::open(const QString& name, const QString& words, int occurrence) {
    const HelpPage* page = findHelpPage(name);
    if (!page) return;
    if (shown_ != name) {
        setPage(page->text);
        shown_ = name;
    }
    pages_->setCurrentIndex(pages_->findData(name));
    if (words.isEmpty() || !goTo(words, occurrence)) {
        text_->moveCursor(QTextCursor::Start);
        text_->verticalScrollBar()->setValue(0);
        return;
    }
    // Repeated later, when a dock that was just opened has its final width, and the page its line breaks.
    QTimer::singleShot(settleTime, this, [=, this] {
        if (shown_ == name) goTo(words, occurrence);
    });
}

/// Formats the page as a separate document before it is shown: laying it out after each change would take seconds.
void HelpView::setPage(const QString& markdown) {
    auto* made = new QTextDocument(text_);
    made->setDefaultFont(text_->font());
    made->setDocumentMargin(12);
    made->setMarkdown(markdown);
    makeReadable(*made);
    QTextDocument* before = text_->document();
    const bool isOurs = before->parent() == text_;  // the browser deletes its first document itself
    text_->setDocument(made);
    if (isOurs) before->deleteLater();
}

/// Sets our sizes and colours, which Qt's Markdown reader does not know.
void HelpView::makeReadable(QTextDocument& document) const {
    const Theme& t = themes_.current();
    QTextCursor cursor(&document);
    cursor.beginEditBlock();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        cursor.setPosition(block.position());
        QTextBlockFormat room = block.blockFormat();
        room.setTopMargin(level > 0 ? 14 : 3);
        room.setBottomMargin(level > 0 ? 6 : 3);
        room.setLineHeight(125, QTextBlockFormat::ProportionalHeight);
        if (room.hasProperty(QTextFormat::BlockCodeLanguage)) room.setNonBreakableLines(true);  // formulas stay aligned
        cursor.setBlockFormat(room);
        if (level == 0) continue;
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        QTextCharFormat heading;  // replaces the heading sizes of Markdown, which need a size in points
        heading.setProperty(QTextFormat::FontPixelSize, headingSizes[std::min(level, 6)]);
        heading.setFontWeight(QFont::DemiBold);
        heading.setForeground(t.text);
        cursor.setCharFormat(heading);
    }
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) {
            QTextTableFormat format = table->format();
            format.setBorderBrush(t.separator);
            format.setBorderCollapse(true);
            format.setCellPadding(4);
            table->setFormat(format);
        }
    cursor.endEditBlock();
}

/// Scrolls to words on the page. A slash separates a heading from a word below it, as in `bolt/length`.
bool HelpView::goTo(const QString& words, int occurrence) {
    QTextCursor found(text_->document());
    const QStringList steps = words.split('/');
    for (const QString& step : steps)
        for (int i = 0; i <= (&step == &steps.back() ? occurrence : 0); ++i) {
            QTextCursor next = text_->document()->find(step, found, QTextDocument::FindWholeWords);
            if (&step != &steps.back())
                while (!next.isNull() && (next.blockFormat().headingLevel() == 0 || next.block().text() != step))
                    next = text_->document()->find(step, next, QTextDocument::FindWholeWords);
            if (next.isNull()) next = text_->document()->find(step, found);
            if (next.isNull()) break;
            found = next;
        }
    if (!found.hasSelection()) return false;
    text_->moveCursor(QTextCursor::End);  // so that the line that is found is at the top
    text_->setTextCursor(found);
    text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->value() + text_->cursorRect(found).top() - 24);
    return true;
}

void HelpView::search(const QString& words) {
    if (words.simplified().isEmpty()) return;
    const std::vector<HelpHit> hits = searchHelp(words);
    const QString typed = words.toHtmlEscaped();
    const QString found = hits.size() == 1 ? tr("1 result for “%1”").arg(typed)
                                           : tr("%1 results for “%2”").arg(hits.size()).arg(typed);
    QString html = "<h3>" + found + "</h3>";
    const QString colour = themes_.current().accent.name(), soft = themes_.current().text2.name();
    for (const HelpHit& hit : hits)
        html += QStringLiteral("<p><a style='color:%1; text-decoration:none' href='%2'><b>%3</b></a><br>"
                               "<span style='color:%4'>%5</span><br>%6</p>")
                    .arg(colour, linkTo(hit, words.simplified()), hit.heading.toHtmlEscaped(), soft,
                         hit.page->title.toHtmlEscaped(), hit.line.left(160).toHtmlEscaped());
    if (hits.empty()) html += "<p>" + tr("Try other words, or fewer words.") + "</p>";
    text_->setHtml(html);
    shown_.clear();
}

void HelpView::follow(const QUrl& link) {
    if (link.scheme() == "help") {
        const QUrlQuery query(link);
        const QString words = QUrl::fromPercentEncoding(query.queryItemValue("words", QUrl::FullyDecoded).toUtf8());
        return open(link.path(), words, query.queryItemValue("n").toInt());
    }
    const QString file = link.fileName();
    if (link.isRelative() && file.endsWith(".md")) return open(file.chopped(3), QString(link.fragment()).replace('-', ' '));
    if (link.isRelative()) return void(goTo(QString(link.fragment()).replace('-', ' '), 0));
    QDesktopServices::openUrl(link);
}

QString helpTopicOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
        const QString topic = widget->property("helpTopic").toString();
        if (!topic.isEmpty()) return topic;
    }
    return {};
}

}  // namespace keyblock
