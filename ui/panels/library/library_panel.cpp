// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/library/library_panel.h"

#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/enum_names.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/display.h"
#include "ui/look/elided_label.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/filter_line.h"
#include "ui/panels/editors/table_chart.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int listWidth = 200, curvesWidth = 260;

QTreeWidget* makeTree(QWidget* parent, const QString& name) {
    auto* tree = new QTreeWidget(parent);
    tree->setAccessibleName(name);
    tree->setRootIsDecorated(false);
    tree->setUniformRowHeights(true);
    tree->setIndentation(10);
    tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return tree;
}

/// Name of the user's own copy of a type, such as `my-rebar-20`: a number after `rebar-20` would suggest another bolt.
std::string nameOfOwn(const Scene& scene, const std::string& name) {
    const std::string base = name.starts_with("my-") ? name : "my-" + name;
    std::string own = base;
    for (int i = 2; findBoltType(scene, own); ++i) own = base + "-" + std::to_string(i);
    return own;
}

QTreeWidgetItem* headingItem(QTreeWidget& tree, const QString& text) {
    auto* item = new QTreeWidgetItem(&tree, {text});
    QFont font = item->font(0);
    font.setWeight(QFont::DemiBold);
    item->setFont(0, font);
    item->setFlags(Qt::ItemIsEnabled);
    item->setFirstColumnSpanned(true);
    return item;
}

}  // namespace

LibraryPanel::LibraryPanel(const FormContext& context, Selection& selection, QWidget* parent)
    : QWidget(parent), context_(context), selection_(selection), later_(new QTimer(this)) {
    setObjectName("libraryPanel");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(makeList());
    auto* middle = new QWidget(this);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(12, 6, 8, 0);
    column->setSpacing(4);
    column->addWidget(makeHead());
    numbers_ = makeTree(middle, tr("Values of the bolt type"));
    numbers_->setObjectName("libraryNumbers");
    numbers_->setHeaderLabels({tr("Field"), tr("Value"), tr("Source")});
    numbers_->setColumnWidth(0, 150);
    numbers_->setColumnWidth(1, 104);
    numbers_->setSelectionMode(QAbstractItemView::NoSelection);
    column->addWidget(numbers_, 1);
    row->addWidget(middle, 1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFixedWidth(curvesWidth);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    curves_ = new QWidget(scroll);
    curves_->setObjectName("libraryCurves");
    curveColumn_ = new QVBoxLayout(curves_);
    curveColumn_->setContentsMargins(8, 8, 12, 8);
    scroll->setWidget(curves_);
    row->addWidget(scroll);
    later_->setSingleShot(true);
    later_->setInterval(0);
    const auto schedule = [this] {
        if (!context_.document.isPreviewing()) later_->start();
    };
    connect(later_, &QTimer::timeout, this, &LibraryPanel::refresh);
    connect(&context.document, &Document::changed, this, schedule);
    connect(&context.display, &Display::changed, this, schedule);
    connect(&context.themes, &Themes::changed, this, schedule);
    connect(filter_, &QLineEdit::textChanged, this, schedule);
    connect(&selection, &Selection::changed, this, &LibraryPanel::showButtons);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!filling_ && item && item->data(0, Qt::UserRole).isValid()) choose(item->data(0, Qt::UserRole).toString());
    });
    refresh();
}

QWidget* LibraryPanel::makeList() {
    auto* side = new QWidget(this);
    side->setObjectName("librarySide");
    side->setAttribute(Qt::WA_StyledBackground);
    side->setFixedWidth(listWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 6, 0, 0);
    auto* inset = new QHBoxLayout;
    inset->setContentsMargins(8, 0, 8, 0);
    filter_ = new FilterLine(context_.themes, tr("Search bolt types"), side);
    inset->addWidget(filter_);
    column->addLayout(inset);
    list_ = makeTree(side, tr("Bolt types"));
    list_->setObjectName("libraryList");
    list_->setHeaderHidden(true);
    list_->setColumnCount(2);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    column->addWidget(list_, 1);
    return side;
}

QWidget* LibraryPanel::makeHead() {
    auto* head = new QWidget(this);
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    title_ = new ElidedLabel(head);
    title_->setProperty("role", "title");
    title_->setObjectName("libraryTitle");
    source_ = new ElidedLabel(head);
    source_->setProperty("role", "detail");
    copy_ = new QPushButton(tr("Copy into scene"), head);
    copy_->setToolTip(tr("Adds an editable copy to the scene."));
    assign_ = new QPushButton(head);
    auto* row = new QHBoxLayout;
    row->addWidget(source_, 1);
    row->addWidget(copy_);
    row->addWidget(assign_);
    column->addWidget(title_);
    column->addLayout(row);
    connect(copy_, &QPushButton::clicked, this, &LibraryPanel::copyIntoScene);
    connect(assign_, &QPushButton::clicked, this, &LibraryPanel::assign);
    return head;
}

void LibraryPanel::refresh() {
    later_->stop();
    const auto entries = libraryEntries(*context_.document.scene(), context_.display, filter_->text().trimmed());
    const auto found = std::ranges::find_if(entries, [&](const LibraryEntry& entry) {
        return QString::fromStdString(entry.type.name) == chosen_;
    });
    fillList(entries);
    if (found != entries.end())
        showType(*found);
    else if (!entries.empty())
        choose(QString::fromStdString(entries.front().type.name));
    showButtons();
}

void LibraryPanel::fillList(const std::vector<LibraryEntry>& entries) {
    const QScopedValueRollback<bool> filling(filling_, true);
    list_->clear();
    QTreeWidgetItem* heading = nullptr;
    for (const LibraryEntry& entry : entries) {
        if (!heading || heading->text(0) != entry.group) heading = headingItem(*list_, entry.group);
        const QString name = QString::fromStdString(entry.type.name);
        auto* item =
            new QTreeWidgetItem(heading, {name, entry.users > 0 ? tr("used %1×").arg(entry.users) : QString()});
        item->setData(0, Qt::UserRole, name);
        item->setToolTip(0, asTip(name + '\n' + entry.detail));
        item->setForeground(1, context_.themes.current().text2);
        if (name == chosen_) list_->setCurrentItem(item);
    }
    list_->expandAll();
}

void LibraryPanel::choose(const QString& name) {
    if (name == chosen_) return;
    chosen_ = name;
    const auto entries = libraryEntries(*context_.document.scene(), context_.display, {});
    for (const LibraryEntry& entry : entries)
        if (QString::fromStdString(entry.type.name) == name) showType(entry);
    for (QTreeWidgetItemIterator at(list_); *at; ++at)
        if ((*at)->data(0, Qt::UserRole).toString() == name) {
            const QScopedValueRollback<bool> filling(filling_, true);
            list_->setCurrentItem(*at);
        }
    const BoltType* own = findBoltType(*context_.document.scene(), name.toStdString());
    if (own && !own->builtIn && assignable().isEmpty())
        selection_.set({QString::fromStdString(under("/bolt_types", own->name))});
    showButtons();
}

void LibraryPanel::showType(const LibraryEntry& entry) {
    const QString cls = fromUtf8(boltClassWords[static_cast<std::size_t>(entry.type.boltClass)]);
    title_->setText(QString::fromUtf8("%1 · %2 · %3").arg(QString::fromStdString(entry.type.name), cls, entry.detail));
    source_->setText(QString::fromStdString(entry.type.source));
    numbers_->clear();
    QTreeWidgetItem* heading = nullptr;
    for (const LibraryNumber& number : libraryNumbers(entry.type, context_.display)) {
        if (!heading || heading->text(0) != number.heading) heading = headingItem(*numbers_, number.heading);
        auto* item = new QTreeWidgetItem(heading, {number.label, number.value, number.source});
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(2, asTip(number.source));
        item->setForeground(2, number.unconfirmed ? context_.themes.current().warning
                            : context_.themes.current().text2);
    }
    numbers_->expandAll();
    showCurves(entry.type);
}

void LibraryPanel::showCurves(const BoltType& type) {
    qDeleteAll(curves_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    while (QLayoutItem* item = curveColumn_->takeAt(0)) delete item;
    std::vector<ShownCurve> shown{steelCurve(type, context_.display)};
    for (ShownCurve& curve : bondCurves(type, context_.display)) shown.push_back(std::move(curve));
    for (const ShownCurve& curve : shown) {
        auto* title =
            new QLabel(curve.points.empty() ? tr("%1: linear, no rupture").arg(curve.title) : curve.title, curves_);
        title->setProperty("role", "title");
        curveColumn_->addWidget(title);
        if (curve.points.empty()) continue;
        auto* chart = new TableChart(context_.themes, curves_);
        chart->setAccessibleName(curve.title);
        chart->present(curve.points, curve.across, curve.up);
        curveColumn_->addWidget(chart);
    }
    curveColumn_->addStretch(1);
}

QStringList LibraryPanel::assignable() const {
    QStringList bolts;
    for (const QString& pointer : selection_.pointers())
        if (pointer.startsWith("/bolts/") || pointer.startsWith("/bolt_patterns/")) bolts << pointer;
    return bolts;
}

void LibraryPanel::showButtons() {
    const QStringList bolts = assignable();
    assign_->setEnabled(!bolts.isEmpty() && !chosen_.isEmpty());
    assign_->setText(bolts.size() == 1 ? tr("Assign to %1").arg(QString::fromStdString(
                                             nameAt(*context_.document.scene(), bolts.front().toStdString())))
                     : bolts.isEmpty() ? tr("Assign") : tr("Assign to selection (%1)").arg(bolts.size()));
    assign_->setToolTip(bolts.isEmpty() ? tr("Select bolts or bolt patterns first") : QString());
    copy_->setEnabled(!chosen_.isEmpty());
}

void LibraryPanel::copyIntoScene() {
    Scene after = *context_.document.scene();
    const auto entries = libraryEntries(after, context_.display, {});
    for (const LibraryEntry& entry : entries) {
        if (QString::fromStdString(entry.type.name) != chosen_) continue;
        BoltType copy = entry.type;
        copy.like = entry.type.name;
        copy.name = nameOfOwn(after, entry.type.name);
        copy.builtIn = false;
        const QString name = QString::fromStdString(copy.name);
        after.boltTypes.push_back(std::move(copy));
        context_.document.apply(tr("Copy %1 into the scene").arg(chosen_), std::move(after));
        chosen_ = name;
        refresh();
        return selection_.set({QString::fromStdString(under("/bolt_types", name.toStdString()))});
    }
}

void LibraryPanel::assign() {
    Edit edit{*context_.document.scene()};
    const QStringList bolts = assignable();
    for (const QString& pointer : bolts)
        if (edit.done())
            edit = setValueAt(std::move(edit.scene), pointer.toStdString() + "/type", chosen_.toStdString());
    const QString to = bolts.size() == 1 ? QString::fromStdString(nameAt(edit.scene, bolts.front().toStdString()))
                                         : tr("%1 bolts and bolt patterns").arg(bolts.size());
    context_.document.apply(tr("Assign %1 to %2").arg(chosen_, to), std::move(edit));
}

}  // namespace keyblock
