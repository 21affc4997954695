// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/import_window.h"

#include "ui/document/background.h"
#include "ui/edit/typed_number.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/start/import_attempt.h"
#include "ui/start/picture_pane.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QTreeWidget>
#include <QVariant>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array roles{LayerRole::Joint, LayerRole::Boundary, LayerRole::Tunnel, LayerRole::Bolt, LayerRole::Ignore};

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), int(text.size())); }
QString textOf(const std::string& text) { return QString::fromStdString(text); }

QTreeWidget* table(const QStringList& headers, const QString& name, const char* id, QWidget* parent) {
    auto* made = new QTreeWidget(parent);
    made->setHeaderLabels(headers);
    made->setRootIsDecorated(false);
    made->setAccessibleName(name);
    made->setObjectName(id);
    return made;
}

/// Remedies that name options of the command line become instructions for this window.
QString remedyHere(const Problem& problem) {
    const QString remedy = textOf(problem.remedy);
    if (remedy.contains("--units")) return ImportWindow::tr("Choose the unit in the box above the list of layers.");
    if (remedy.contains("--role")) return ImportWindow::tr("Choose the roles in the list of layers.");
    return remedy;
}

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setObjectName("listTitle");
    return label;
}

}  // namespace

ImportWindow::ImportWindow(const QString& path, const Themes& themes, QWidget* parent)
    : QWidget(parent, Qt::Window), path_(path), themes_(themes), reading_(new Background(this)),
      unit_(new QComboBox(this)), sagitta_(new QLineEdit(this)),
      layers_(table({tr("Layer"), tr("Role"), tr("Reason")}, tr("Layers and their roles"), "import.layers", this)),
      account_(table({tr("Entity"), tr("Layer"), tr("Count"), tr("Imported as")}, tr("How the entities are imported"),
                     "import.account", this)),
      picture_(new PicturePane(themes, this)), words_(new QLabel(this)), import_(new QPushButton(tr("Import"), this)) {
    setObjectName("importWindow");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
    resize(1080, 680);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 16, 16, 16);
    row->setSpacing(16);
    row->addWidget(makeSettings(), 5);
    row->addWidget(makeResult(), 6);
    ask();
}

QWidget* ImportWindow::makeSettings() {
    auto* side = new QWidget(this);
    unit_->addItem(tr("from file"), QString());
    for (const std::string_view unit : lengthUnits()) unit_->addItem(textOf(unit), textOf(unit));
    unit_->setAccessibleName(tr("Unit of the drawing"));
    unit_->setObjectName("import.unit");
    sagitta_->setPlaceholderText(tr("automatic"));
    sagitta_->setAccessibleName(tr("Arc tolerance"));
    sagitta_->setObjectName("import.sagitta");
    sagitta_->setToolTip(tr("Largest distance between an arc and the straight segments that replace it, in metres."));
    auto* form = new QFormLayout;
    form->addRow(tr("Unit"), unit_);
    form->addRow(tr("Arc tolerance (m)"), sagitta_);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addLayout(form);
    column->addSpacing(4);
    column->addWidget(heading(tr("Layers"), side));
    column->addWidget(layers_, 3);
    column->addWidget(heading(tr("Entities"), side));
    column->addWidget(account_, 4);
    connect(unit_, qOverload<int>(&QComboBox::activated), this, [this] {
        const QString word = unit_->currentData().toString();
        settings_.unit = word.isEmpty() ? nullptr : lengthUnitOf(word.toStdString());
        ask();
    });
    connect(sagitta_, &QLineEdit::editingFinished, this, &ImportWindow::readSagitta);
    return side;
}

QWidget* ImportWindow::makeResult() {
    auto* side = new QWidget(this);
    words_->setObjectName("import.words");
    words_->setWordWrap(true);
    words_->setTextFormat(Qt::PlainText);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setAlignment(Qt::AlignTop);
    import_->setProperty("primary", true);
    import_->setAccessibleName(import_->text());
    import_->setObjectName("import.import");
    auto* cancel = new QPushButton(tr("Cancel"), side);
    cancel->setAccessibleName(cancel->text());
    cancel->setObjectName("import.cancel");
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(import_);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(picture_, 3);
    column->addWidget(words_, 1);
    column->addLayout(buttons);
    connect(cancel, &QPushButton::clicked, this, &QWidget::close);
    connect(import_, &QPushButton::clicked, this, [this] {
        if (!attempt_ || !attempt_->import.scene) return;
        const auto kept = attempt_;  // the window may be closed meanwhile
        Q_EMIT imported(*kept->import.scene, QFileInfo(path_).completeBaseName());
    });
    return side;
}

void ImportWindow::ask() {
    import_->setEnabled(false);
    reading_->ask([this, path = path_.toStdString(), settings = settings_]() -> Background::Result {
        const auto attempt = attemptImport(path, settings);
        return [this, attempt] { showAttempt(attempt); };
    });
}

void ImportWindow::readSagitta() {
    const QString typed = sagitta_->text().trimmed();
    const TypedNumber number = typed.isEmpty() ? TypedNumber{} : typedNumber(typed.toStdString(), "m");
    const bool isGood = typed.isEmpty() || (number.value && *number.value > 0.0);
    sagitta_->setProperty("invalid", !isGood);
    sagitta_->style()->polish(sagitta_);
    sagitta_->setToolTip(
        isGood         ? tr("Largest distance between an arc and the straight segments that replace it, in metres.")
        : number.value ? tr("Enter a length greater than 0.")
                       : textOf(number.problem));
    if (!isGood || settings_.sagitta == number.value) return;
    settings_.sagitta = number.value;
    ask();
}

void ImportWindow::setRole(const QString& layer, LayerRole role) {
    auto& given = settings_.roles;
    std::erase_if(given, [&](const auto& entry) { return entry.first == layer.toStdString(); });
    given.emplace_back(layer.toStdString(), role);
    ask();
}

void ImportWindow::showAttempt(std::shared_ptr<const ImportAttempt> attempt) {
    attempt_ = std::move(attempt);
    const Import& import = attempt_->import;
    unit_->setItemText(0, import.unit.empty() ? tr("from file") : tr("from file: %1").arg(textOf(import.unit)));
    showLayers();
    showAccount();
    showWords();
    picture_->show(attempt_->picture, attempt_->unreadable.empty() ? tr("No scene can be created from this file yet")
                                                                   : textOf(attempt_->unreadable));
    import_->setEnabled(import.scene.has_value());
}

void ImportWindow::showLayers() {
    layers_->clear();
    for (const ImportedLayer& layer : attempt_->import.layers) {
        auto* item = new QTreeWidgetItem(layers_, {textOf(layer.name), {}, textOf(layer.source)});
        item->setToolTip(0, asTip(item->text(0)));
        item->setToolTip(2, asTip(item->text(2)));
        auto* role = new QComboBox(layers_);
        if (!layer.known) role->addItem(tr("choose…"), -1);
        for (const LayerRole each : roles) role->addItem(textOf(wordOf(each)), int(each));
        role->setCurrentIndex(layer.known ? role->findData(int(layer.role)) : 0);
        role->setAccessibleName(tr("Role of layer %1").arg(textOf(layer.name)));
        role->setObjectName("import.role." + textOf(layer.name));
        connect(role, qOverload<int>(&QComboBox::activated), this, [this, role, name = textOf(layer.name)] {
            const int chosen = role->currentData().toInt();
            // Deferred, because the new import recreates this box.
            if (chosen >= 0) QTimer::singleShot(0, this, [this, name, chosen] { setRole(name, LayerRole(chosen)); });
        });
        layers_->setItemWidget(item, 1, role);
    }
    layers_->header()->resizeSection(0, 150);
    layers_->header()->resizeSection(1, 110);
}

/// Lists the imported entities with their number, then each skipped entity with its line and the reason.
void ImportWindow::showAccount() {
    account_->clear();
    for (const ImportRow& row : attempt_->import.rows) {
        if (row.became == "skipped") continue;  // skipped entities are listed one by one below
        auto* item = new QTreeWidgetItem(
            account_, {textOf(row.kind), textOf(row.layer), QString::number(row.count), textOf(row.became)});
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(3, asTip(item->text(3)));
    }
    for (const NotTaken& lost : attempt_->import.notTaken) {
        const QString why = tr("skipped, line %1: %2").arg(lost.place.line).arg(textOf(lost.why));
        auto* item = new QTreeWidgetItem(account_, {textOf(lost.kind), textOf(lost.layer), "1", why});
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        item->setForeground(3, themes_.current().warning);
        item->setToolTip(3, asTip(why));
    }
    account_->header()->resizeSection(0, 110);
    account_->header()->resizeSection(1, 100);
    account_->header()->resizeSection(2, 56);
}

void ImportWindow::showWords() {
    constexpr std::size_t most = 6;
    const Import& import = attempt_->import;
    QStringList lines;
    for (const Problem& problem : import.problems) {
        const QString place = problem.line > 0 ? tr("line %1: ").arg(problem.line) : QString();
        lines << textOf(wordOf(problem.severity)) + ", " + place + textOf(problem.message) + ". " + remedyHere(problem);
    }
    for (const std::string& assumed : import.assumed) lines << tr("Assumed: %1").arg(textOf(assumed));
    words_->setToolTip(asTip(lines.join('\n')));
    if (lines.size() > int(most)) lines = lines.mid(0, int(most)) << tr("The tooltip of this text shows all messages.");
    if (import.scene && import.cut) 
        lines.prepend(import.cut->blocks == 1 ? tr("The scene has 1 block.")
                                              : tr("The scene has %1 blocks.").arg(import.cut->blocks));
    words_->setText(lines.join('\n'));
}

}  // namespace keyblock
