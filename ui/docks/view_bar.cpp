// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/view_bar.h"

#include "ui/docks/overflow_menu.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/runs/view_settings.h"

#include <QComboBox>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace keyblock {

namespace {

constexpr int mostOfBox = 240, spaceBeforeToggles = 6;  // [px]; longer choices are elided
constexpr std::array kindsOfArrows{ArrowKind::Displacements, ArrowKind::Velocities, ArrowKind::StressCrosses};  // as offered
constexpr double factors[]{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};

/// A box that shows its title before the current choice.
class TitledChoice : public QComboBox {
public:
    TitledChoice(const QString& title, QWidget* parent) : QComboBox(parent), title_(title) {
        setSizeAdjustPolicy(QComboBox::AdjustToContents);
        setFixedHeight(26);
    }
    QSize sizeHint() const override {
        QFont bold = font();
        bold.setWeight(QFont::DemiBold);
        const QFontMetrics metrics(font());
        const int text = metrics.horizontalAdvance(title_) + 8 + metrics.horizontalAdvance(currentText());
        return {text + 34, 26};
    }
    QSize minimumSizeHint() const override { return {96, 26}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        option.currentText.clear();
        style()->drawComplexControl(QStyle::CC_ComboBox, &option, &painter, this);
        const QRect room = rect().adjusted(9, 0, -20, 0);
        const QFontMetrics metrics(font());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, title_);
        const int at = metrics.horizontalAdvance(title_) + 8;
        painter.setPen(palette().color(isEnabled() ? QPalette::Text : QPalette::PlaceholderText));
        painter.drawText(room.adjusted(at, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         metrics.elidedText(currentText(), Qt::ElideRight, room.width() - at));
    }

private:
    QString title_;
};

/// Shortens "Block stress σ₁" to "σ₁", as the title of the box says "Blocks".
QString shortTitle(std::string_view title) {
    QString all = qt(title);
    if (all.startsWith("Block stress ")) all = all.mid(13);
    return all;
}

}  // namespace

ViewBar::ViewBar(const Themes& themes, Commands& commands, ViewSettings& settings, QWidget* parent)
    : QWidget(parent), themes_(themes), commands_(commands), settings_(settings), row_(new QHBoxLayout(this)) {
    setObjectName("viewBar");
    setAccessibleName(tr("Results display"));
    setFixedHeight(36);
    row_->setContentsMargins(12, 0, 12, 0);
    row_->setSpacing(6);
    blocks_ = addChoice("viewBlocks", tr("Blocks"));
    bolts_ = addChoice("viewBolts", tr("Bolts"));
    ribbon_ = addChoice("viewRibbon", tr("Force diagram"));
    factor_ = addChoice("viewFactor", tr("Deformation"));
    arrows_ = addChoice("viewArrows", tr("Arrows"));
    fill();
    row_->addSpacing(spaceBeforeToggles);
    callOuts_ = addToggle("viewCallOuts", tr("Labels"), tr("Label the events on the section"), "label");
    contacts_ = addToggle("viewContacts", tr("Contact forces"), tr("Draw the forces between blocks as lines"), "contact-force");
    activity_ = addToggle("viewActivity", tr("Modelled blocks"),
                          tr("Colour the blocks that are active, asleep and fixed"), "block");
    for (QToolButton* button : {callOuts_, contacts_, activity_})
        connect(button, &QToolButton::clicked, this, &ViewBar::take);
    row_->addStretch(1);
    connect(&settings, &ViewSettings::changed, this, &ViewBar::showChoice);
    connect(&themes, &Themes::changed, this, &ViewBar::showIcons);
    showChoice();
    showIcons();
}

QComboBox* ViewBar::addChoice(const char* name, const QString& title) {
    auto* choice = new TitledChoice(title, this);
    choice->setObjectName(name);
    choice->setAccessibleName(title);
    choice->setMaximumWidth(mostOfBox);  // so that the others are not narrowed for it
    row_->addWidget(choice);
    connect(choice, QOverload<int>::of(&QComboBox::activated), this, &ViewBar::take);
    return choice;
}

QToolButton* ViewBar::addToggle(const char* name, const QString& text, const QString& tip, const char* icon) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    button->setProperty("iconName", icon);
    button->setCheckable(true);
    button->setFixedSize(28, 28);
    row_->addWidget(button);
    toggles_.push_back(button);
    return button;
}

void ViewBar::fill() {
    blocks_->addItem(tr("plain"));
    for (const auto& quantity : blockQuantities()) blocks_->addItem(shortTitle(quantity.display.title));
    bolts_->addItem(tr("plain"));
    for (const auto& quantity : boltQuantities()) bolts_->addItem(qt(quantity.display.title));
    ribbon_->addItems({tr("none"), tr("selected bolt"), tr("most loaded bolt")});
    arrows_->addItems({tr("none"), tr("displacement"), tr("velocity"), tr("principal stresses")});
    for (const double factor : factors) factor_->addItem(QStringLiteral("×") + Display::number(factor, 4), factor);
}

/// Adds commands that other parts of the window define, if they exist.
void ViewBar::addCommands() {
    for (const char* id : {"view.probe", "view.zoomBox", "view.fit", "export.figure"}) {
        if (!commands_.has(id)) continue;
        auto* button = new QToolButton(this);
        button->setDefaultAction(commands_.action(id));
        button->setObjectName(QString::fromUtf8(id) + "Bar");
        button->setAccessibleName(commands_.action(id)->text());
        button->setFixedHeight(28);
        const bool isExport = QString::fromUtf8(id) == "export.figure";
        if (isExport || QString::fromUtf8(id) == "view.probe") button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        if (isExport) button->setProperty("framed", true);
        row_->addWidget(button);
    }
}

/// Commands are added here, because other parts of the window may define them after this bar is created.
void ViewBar::showEvent(QShowEvent*) {
    if (!std::exchange(hasCommands_, true)) {
        addCommands();
        makeMore();
    }
    fit();
}

void ViewBar::take() {
    ViewChoice choice = settings_.choice();
    const int block = blocks_->currentIndex() - 1, bolt = bolts_->currentIndex() - 1;
    choice.blocks = block >= 0 ? &blockQuantities()[block] : nullptr;
    choice.bolts = bolt >= 0 ? &boltQuantities()[bolt] : nullptr;
    choice.ribbon = static_cast<RibbonOf>(ribbon_->currentIndex());
    choice.factor = factor_->currentData().toDouble();
    choice.callOuts = callOuts_->isChecked();
    choice.contacts = contacts_->isChecked();
    choice.activity = activity_->isChecked();
    const int arrows = arrows_->currentIndex() - 1;
    choice.arrows = arrows >= 0 ? std::optional(kindsOfArrows[arrows]) : std::nullopt;
    settings_.choose(choice);
    showChoice();
}

void ViewBar::showChoice() {
    const ViewChoice& choice = settings_.choice();
    const auto indexOf = [](const auto& quantities, const auto* chosen) {
        for (std::size_t i = 0; i < quantities.size(); ++i)
            if (&quantities[i] == chosen) return static_cast<int>(i) + 1;
        return 0;
    };
    blocks_->setCurrentIndex(indexOf(blockQuantities(), choice.blocks));
    bolts_->setCurrentIndex(indexOf(boltQuantities(), choice.bolts));
    ribbon_->setCurrentIndex(static_cast<int>(choice.ribbon));
    factor_->setCurrentIndex(factor_->findData(choice.factor));
    ribbon_->setEnabled(choice.bolts != nullptr);
    callOuts_->setChecked(choice.callOuts);
    const auto kind = choice.arrows ? std::ranges::find(kindsOfArrows, *choice.arrows) : kindsOfArrows.end();
    arrows_->setCurrentIndex(kind == kindsOfArrows.end() ? 0 : static_cast<int>(kind - kindsOfArrows.begin()) + 1);
    contacts_->setChecked(choice.contacts);
    activity_->setChecked(choice.activity);
    blocks_->setEnabled(!choice.activity);
    for (QComboBox* box : {blocks_, bolts_, ribbon_, factor_, arrows_}) box->updateGeometry();
    fit();
}

void ViewBar::showIcons() {
    for (QToolButton* button : toggles_)
        button->setIcon(themes_.icon(button->property("iconName").toString()));
    update();
}

/// The last item of the bar: a menu of controls that do not fit.
void ViewBar::makeMore() {
    more_ = new QToolButton(this);
    more_->setObjectName("viewMore");
    more_->setText(QString::fromUtf8("»"));
    more_->setAccessibleName(tr("More view options"));
    more_->setToolTip(more_->accessibleName());
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->setFixedSize(28, 28);
    auto* menu = new QMenu(more_);
    more_->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        for (QWidget* control : hidden_) addToMenu(*menu, *control);
    });
    row_->addWidget(more_);
}

/// Controls that may move into the menu, in that order.
std::vector<QWidget*> ViewBar::dispensable() const {
    std::vector<QWidget*> found;
    for (const char* name : {"view.fitBar", "view.zoomBoxBar"})
        if (auto* button = findChild<QWidget*>(name)) found.push_back(button);
    found.insert(found.end(), {activity_, contacts_, callOuts_, arrows_});
    for (const char* name : {"export.figureBar", "view.probeBar"})
        if (auto* button = findChild<QWidget*>(name)) found.push_back(button);
    found.insert(found.end(), {factor_, ribbon_});
    return found;
}

void ViewBar::fit() {
    const auto widthOf = [this](const QWidget& widget) {
        const bool isBox = qobject_cast<const QComboBox*>(&widget);
        return row_->spacing() + (isBox ? std::min(widget.sizeHint().width(), mostOfBox) : widget.sizeHint().width());
    };
    const int rims = row_->contentsMargins().left() + row_->contentsMargins().right() + spaceBeforeToggles;
    int wanted = rims;
    for (int i = 0; i < row_->count(); ++i)
        if (const QWidget* widget = row_->itemAt(i)->widget(); widget && widget != more_) wanted += widthOf(*widget);
    const std::vector<QWidget*> candidates = dispensable();
    const bool isShort = wanted > width();
    if (isShort && more_) wanted += widthOf(*more_);
    std::vector<QWidget*> gone;
    for (QWidget* widget : candidates) {
        const bool goes = wanted > width();
        widget->setVisible(!goes);
        if (!goes) continue;
        wanted -= widthOf(*widget);
        gone.push_back(widget);
    }
    hidden_.clear();
    for (int i = 0; i < row_->count(); ++i)
        if (QWidget* widget = row_->itemAt(i)->widget(); std::ranges::find(gone, widget) != gone.end())
            hidden_.push_back(widget);
    if (more_) more_->setVisible(isShort);
}

bool ViewBar::event(QEvent* event) {
    if (event->type() == QEvent::Resize) fit();
    return QWidget::event(event);
}

void ViewBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    painter.setPen(themes_.current().separator);
    painter.drawLine(0, height() - 1, width(), height() - 1);
}

}  // namespace keyblock
