// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/tree/scene_tree.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/filter_line.h"
#include "ui/panels/tree/tree_model.h"
#include "ui/panels/tree/tree_view.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace keyblock {

namespace {

constexpr int openByItself = 12;  // headings with more rows are closed at first

QToolButton* headerButton(QWidget* header, const QString& name) {
    auto* button = new QToolButton(header);
    button->setFixedSize(22, 22);
    button->setToolTip(name);
    button->setAccessibleName(name);
    return button;
}

std::vector<std::string> textsOf(const QStringList& list) {
    std::vector<std::string> texts;
    for (const QString& text : list) texts.push_back(text.toStdString());
    return texts;
}

}  // namespace

SceneTree::SceneTree(Document& document, Selection& selection, Visibility& visibility, const Display& display,
                     const Commands& commands, const Themes& themes, QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), visibility_(visibility), display_(display),
      commands_(commands), themes_(themes), model_(new TreeModel(this)),
      view_(new TreeView(themes, visibility, *model_, this)), later_(new QTimer(this)) {
    setObjectName("sceneTree");
    makeHeader();
    line_ = new FilterLine(themes, tr("Filter the scene"), this);
    line_->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(4);
    auto* inset = new QHBoxLayout;
    inset->setContentsMargins(8, 0, 8, 0);
    inset->addWidget(line_);
    column->addLayout(inset);
    column->addWidget(view_, 1);
    view_->installEventFilter(this);
    line_->installEventFilter(this);
    later_->setSingleShot(true);
    model_->setFetch([this](const TreeNode& node) { return waitingChildren(source(), node); });
    model_->setRename([this](const QString& pointer, const QString& name) { rename(pointer, name); });
    model_->setMove([this](const QString& pointer, int to) { moveStage(pointer, to); });
    const auto schedule = [this] {
        if (!document_.isPreviewing()) later_->start(0);
    };
    connect(later_, &QTimer::timeout, this, &SceneTree::refresh);
    connect(&document, &Document::changed, this, schedule);
    connect(&document, &Document::checkedChanged, this, schedule);
    connect(&display, &Display::changed, this, schedule);
    connect(&document, &Document::replaced, this, [this] {
        open_.clear();
        seen_.clear();
    });
    connect(&visibility, &Visibility::changed, view_->viewport(), QOverload<>::of(&QWidget::update));
    connect(&selection, &Selection::changed, this, [this] {
        sought_ = true;
        showSelection();
    });
    connect(&themes, &Themes::changed, view_->viewport(), QOverload<>::of(&QWidget::update));
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SceneTree::takeSelection);
    connect(view_, &QTreeView::expanded, this, [this](const QModelIndex& i) { open_.insert(model_->nodeAt(i).id); });
    connect(view_, &QTreeView::collapsed, this, [this](const QModelIndex& i) { open_.remove(model_->nodeAt(i).id); });
    connect(view_, &QTreeView::activated, this, &SceneTree::activate);
    connect(view_, &QWidget::customContextMenuRequested, this, &SceneTree::openMenu);
    connect(view_, &TreeView::eyeClicked, this,
            [this](const QString& id) { visibility_.setHidden(id, !visibility_.isHidden(id)); });
    connect(view_, &TreeView::lockClicked, this,
            [this](const QString& id) { visibility_.setLocked(id, !visibility_.isLocked(id)); });
    connect(line_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filter_ = text.trimmed();
        refresh();
    });
    refresh();
}

void SceneTree::makeHeader() {
    header_ = new QWidget(this);
    header_->setObjectName("dockHeader");
    header_->setAttribute(Qt::WA_StyledBackground);
    header_->setFixedHeight(30);
    auto* row = new QHBoxLayout(header_);
    row->setContentsMargins(12, 4, 6, 4);  // a dock uses the size hint of its header, not its fixed height
    row->setSpacing(4);
    auto* title = new QLabel(tr("Scene"), header_);
    title->setObjectName("dockTitle");
    row->addWidget(title, 1);
    filterButton_ = headerButton(header_, tr("Filter the tree"));
    filterButton_->setCheckable(true);
    addButton_ = headerButton(header_, tr("Add to the scene"));
    addButton_->setPopupMode(QToolButton::InstantPopup);
    addMenu_ = new QMenu(addButton_);
    addButton_->setMenu(addMenu_);
    row->addWidget(filterButton_);
    row->addWidget(addButton_);
    const auto icons = [this] {
        filterButton_->setIcon(themes_.icon("filter"));
        addButton_->setIcon(themes_.icon("plus"));
    };
    icons();
    connect(&themes_, &Themes::changed, this, icons);
    connect(addMenu_, &QMenu::aboutToShow, this, &SceneTree::fillAddMenu);
    connect(filterButton_, &QToolButton::toggled, this, [this](bool on) {
        line_->setVisible(on);
        if (on) line_->setFocus();
        else line_->clear();
    });
}

/// Objects to be drawn have commands of their own; other objects are added with default values.
void SceneTree::fillAddMenu() {
    addMenu_->clear();
    for (QAction* action : commands_.all())
        if (commands_.menuOf(action) == "Insert") addMenu_->addAction(action);
    if (!addMenu_->isEmpty()) addMenu_->addSeparator();
    const Scene& scene = *document_.scene();
    const std::vector<std::pair<QString, const char*>> items{
        {tr("Material"), "/materials"}, {tr("Joint material"), "/joint_materials"}, {tr("Stage"), "/stages"},
        {tr("Bolt type"), "/bolt_types"}};
    for (const auto& [text, list] : items)
        addMenu_->addAction(text, this, [this, at = QString(list)] { addItem(at); });
    if (!scene.voronoi) addMenu_->addAction(tr("Voronoi cells"), this, [this] { addItem("/voronoi"); });
}

void SceneTree::addInSituStress() {
    if (document_.scene()->inSituStress) selection_.set({"/in_situ_stress"});
    else addItem("/in_situ_stress");
}

void SceneTree::addItem(const QString& list) {
    Edit edit = appendAt(*document_.scene(), list.toStdString());
    const std::string made = edit.made.empty() ? list.toStdString() : edit.made;
    const QString title = QString::fromStdString(titleAt(edit.scene, made));
    if (document_.apply(tr("Add %1").arg(title), std::move(edit))) selection_.set({QString::fromStdString(made)});
}

TreeSource SceneTree::source() const { return {document_, display_, runs_, filter_}; }

void SceneTree::setRuns(std::vector<RunRow> runs) {
    runs_ = std::move(runs);
    later_->start(0);
}

void SceneTree::refresh() {
    later_->stop();
    if (view_->isEditing()) return later_->start(200);
    const QScopedValueRollback<bool> following(follows_, true);
    const QSet<QString> open = open_;
    const int scrolled = view_->verticalScrollBar()->value();
    if (model_->show(makeTree(source())))
        for (int row = 0; row < model_->rowCount(); ++row) {
            const QModelIndex heading = model_->index(row, 0);
            const TreeNode& node = model_->nodeAt(heading);
            const bool fresh = !seen_.contains(node.id) && !node.children.empty();
            if (fresh) seen_.insert(node.id);
            const bool quiet = node.id == "#loads" || node.id == "/stages" || node.id == "/supports" ||
                               node.id == "/monitors";
            const bool byItself = fresh && !quiet && static_cast<int>(node.children.size()) <= openByItself;
            if (byItself || open.contains(node.id) || !filter_.isEmpty()) view_->expand(heading);
            for (int i = 0; i < model_->rowCount(heading); ++i) {
                const QModelIndex inner = model_->index(i, 0, heading);
                if (open.contains(model_->nodeAt(inner).id)) view_->expand(inner);
            }
        }
    view_->verticalScrollBar()->setValue(scrolled);
    showSelection();
}

/// The row of an object. Opens the lists that contain it.
QModelIndex SceneTree::openTo(const QString& pointer) {
    QModelIndex found = model_->indexOf(pointer);
    if (found.isValid()) return found;
    const QString list = pointer.section('/', 0, -2);
    for (const QString& id : {list, list + '/'}) {
        const QModelIndex heading = model_->indexOf(id);
        if (heading.isValid() && model_->canFetchMore(heading)) model_->fetchMore(heading);
    }
    return model_->indexOf(pointer);
}

/// Selects consecutive rows as one range. Scrolls only to a new selection.
void SceneTree::showSelection() {
    const QScopedValueRollback<bool> following(follows_, true);
    QItemSelection chosen;
    QModelIndex first, last;
    for (const QString& pointer : selection_.pointers()) {
        const QModelIndex index = openTo(pointer);
        if (!index.isValid()) continue;
        for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) view_->expand(above);
        const bool goesOn = last.isValid() && index.parent() == last.parent() && index.row() == last.row() + 1;
        if (!goesOn) {
            if (last.isValid()) chosen.select(first, last);
            first = index;
        }
        last = index;
    }
    if (last.isValid()) chosen.select(first, last);
    view_->selectionModel()->select(chosen, QItemSelectionModel::ClearAndSelect);
    if (!last.isValid() || !sought_) return;
    sought_ = false;
    if (!view_->hasFocus()) view_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
    view_->scrollTo(last);
}

void SceneTree::takeSelection() {
    if (follows_) return;
    const QScopedValueRollback<bool> following(follows_, true);
    QStringList pointers;
    for (const QModelIndex& index : view_->selectionModel()->selectedIndexes())
        if (model_->nodeAt(index).isObject) pointers << model_->nodeAt(index).id;
    selection_.set(pointers);
}

void SceneTree::activate(const QModelIndex& index) {
    const QString& id = model_->nodeAt(index).id;
    if (id.startsWith("#run/")) Q_EMIT runChosen(id.mid(5));
}

void SceneTree::rename(const QString& pointer, const QString& name) {
    const QString title = QString::fromStdString(titleAt(*document_.scene(), pointer.toStdString()));
    document_.apply(tr("Rename %1").arg(title),
                    renameAt(*document_.scene(), pointer.toStdString(), name.toStdString()));
}

void SceneTree::moveStage(const QString& pointer, int to) {
    const QString title = QString::fromStdString(titleAt(*document_.scene(), pointer.toStdString()));
    document_.apply(tr("Move %1").arg(title),
                    moveAt(*document_.scene(), pointer.toStdString(), static_cast<std::size_t>(std::max(0, to))));
}

QString SceneTree::chosenTitle() const {
    const QStringList& chosen = selection_.pointers();
    if (chosen.size() == 1) return QString::fromStdString(titleAt(*document_.scene(), chosen.front().toStdString()));
    return tr("%n objects", nullptr, chosen.size());
}

void SceneTree::duplicate() {
    if (selection_.isEmpty()) return;
    std::vector<std::string> made;
    const Scene& scene = *document_.scene();
    const QString step = tr("Duplicate %1").arg(chosenTitle());
    Edit edit = copyAll(scene, scene, textsOf(selection_.pointers()), Point(0.0, 0.0), made);
    if (!document_.apply(step, std::move(edit))) return;
    QStringList copies;
    for (const std::string& pointer : made) copies << QString::fromStdString(pointer);
    selection_.set(copies);
}

void SceneTree::remove() {
    if (selection_.isEmpty()) return;
    const QString step = tr("Delete %1").arg(chosenTitle());
    document_.apply(step, removeAll(*document_.scene(), textsOf(selection_.pointers())));
}

bool SceneTree::isKeyOf(const char* command, const QKeyEvent& key) const {
    const QKeySequence pressed(static_cast<int>(key.modifiers() & ~Qt::KeypadModifier) | key.key());
    return commands_.has(command) && commands_.action(command)->shortcuts().contains(pressed);
}

QString SceneTree::withKeys(const QString& text, const char* command) const {
    return commands_.has(command) ? text + '\t' + keysOf(*commands_.action(command)) : text;
}

void SceneTree::openMenu(const QPoint& place) {
    const QModelIndex index = view_->indexAt(place);
    if (!index.isValid()) return;
    const TreeNode& node = model_->nodeAt(index);
    const QString id = node.id;
    QMenu menu(this);
    if (node.isObject) {
        if (node.hasPlace)
            menu.addAction(tr("Zoom to selection"), this, [this] { Q_EMIT zoomAsked(selection_.pointers()); });
        if (node.canRename)
            menu.addAction(tr("Rename\tF2"), this, [this, at = QPersistentModelIndex(index)] {
                if (at.isValid()) view_->edit(at);  // the tree may have been rebuilt while the menu was open
            });
        if (id != "/analysis") {
            if (id.count('/') > 1) menu.addAction(withKeys(tr("Duplicate"), "edit.duplicate"), this, &SceneTree::duplicate);
            menu.addAction(withKeys(tr("Delete"), "edit.delete"), this, &SceneTree::remove);
        }
        menu.addSeparator();
    } else if (id.startsWith('/') && id.count('/') == 1 && id != "/blocks") {
        menu.addAction(tr("Add"), this, [this, id] { addItem(id); });
    } else if (id == "#loads" && !document_.scene()->inSituStress) {
        menu.addAction(tr("Add in-situ stress"), this, &SceneTree::addInSituStress);
    }
    if (node.canHide) {
        const bool hidden = visibility_.isHidden(id);
        menu.addAction(hidden ? tr("Show") : tr("Hide"), this,
                       [this, id, hidden] { visibility_.setHidden(id, !hidden); });
    }
    if (node.isObject && node.hasPlace) {
        const bool locked = visibility_.isLocked(id);
        menu.addAction(locked ? tr("Unlock") : tr("Lock"), this,
                       [this, id, locked] { visibility_.setLocked(id, !locked); });
    }
    if (!visibility_.showsAll()) menu.addAction(tr("Show all"), this, [this] { visibility_.showAll(); });
    if (!menu.isEmpty()) menu.exec(view_->viewport()->mapToGlobal(place));
}

bool SceneTree::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(object, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (object == line_ && key->key() == Qt::Key_Escape) {
        filterButton_->setChecked(false);
        return true;
    }
    if (object == view_ && isKeyOf("edit.delete", *key)) {
        remove();
        return true;
    }
    if (object == view_ && isKeyOf("edit.duplicate", *key)) {
        duplicate();
        return true;
    }
    return QWidget::eventFilter(object, event);
}

}  // namespace keyblock
