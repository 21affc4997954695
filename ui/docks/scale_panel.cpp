// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/scale_panel.h"

#include "ui/edit/typed_number.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/qt_text.h"
#include "ui/runs/view_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int stepCounts[]{0, 4, 5, 8, 10, 20};

/// Factor from numbers in the units of the picture to numbers in the units shown.
double factorOf(const LegendBar& bar, const ShownNumbers& numbers) {
    const auto factor = [&](const QuantityDisplay& display) {
        return shownAs(display.unit, display.convention, numbers).factor;
    };
    if (const auto* quantity = findQuantity(blockQuantities(), bar.quantity)) return factor(quantity->display);
    if (const auto* quantity = findQuantity(boltQuantities(), bar.quantity)) return factor(quantity->display);
    return 1.0;
}

void mark(QLineEdit& edit, const QString& problem) {
    edit.setProperty("invalid", !problem.isEmpty());
    edit.setToolTip(asTip(problem));
    edit.style()->unpolish(&edit);
    edit.style()->polish(&edit);
}

}  // namespace

ScalePanel::ScalePanel(const LegendBar& bar, const ShownNumbers& numbers, bool clips, ViewSettings& settings,
                       QWidget* parent)
    : QFrame(parent, Qt::Popup), bar_(bar), factor_(factorOf(bar, numbers)), settings_(settings),
      all_(new QRadioButton(tr("All frames"), this)), frame_(new QRadioButton(tr("This frame"), this)),
      own_(new QRadioButton(tr("Custom range"), this)),
      from_(makeEnd("scaleFrom", tr("Lower end"), std::min(bar.range.low, bar.range.high))),
      to_(makeEnd("scaleTo", tr("Upper end"), std::max(bar.range.low, bar.range.high))),
      clip_(new QCheckBox(tr("Clip extreme values (2 % of the area)"), this)), steps_(new QComboBox(this)) {
    setObjectName("scalePanel");
    setAccessibleName(tr("Colour scale"));
    setAttribute(Qt::WA_DeleteOnClose);
    all_->setObjectName("scaleAll");
    frame_->setObjectName("scaleFrame");
    own_->setObjectName("scaleOwn");
    clip_->setObjectName("scaleClip");
    clip_->setVisible(clips);
    clip_->setToolTip(tr("Limits the scale to the range from the 2nd to the 98th percentile by area, so that "
                         "extreme values, for example in slivers, do not determine it."));
    steps_->setObjectName("scaleSteps");
    steps_->setAccessibleName(tr("Colours"));
    for (const int count : stepCounts) steps_->addItem(count == 0 ? tr("Continuous") : tr("%1 steps").arg(count), count);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(8);
    auto* title = new QLabel(tr("Scale: %1").arg(qt(bar.title)), this);
    QFont bold = title->font();
    bold.setWeight(QFont::DemiBold);
    title->setFont(bold);
    column->addWidget(title);
    for (QRadioButton* button : {all_, frame_, own_}) column->addWidget(button);
    auto* ends = new QHBoxLayout;
    ends->setContentsMargins(22, 0, 0, 0);
    ends->addWidget(from_);
    ends->addWidget(new QLabel(tr("to"), this));
    ends->addWidget(to_);
    ends->addWidget(new QLabel(qt(bar.unit), this));
    ends->addStretch(1);
    column->addLayout(ends);
    column->addWidget(clip_);
    auto* last = new QHBoxLayout;
    last->addWidget(new QLabel(tr("Colours"), this));
    last->addWidget(steps_);
    last->addStretch(1);
    auto* defaults = new QPushButton(tr("Restore defaults"), this);
    defaults->setObjectName("scaleDefaults");
    last->addWidget(defaults);
    column->addLayout(last);

    fill();
    for (QRadioButton* button : {all_, frame_, own_}) connect(button, &QRadioButton::clicked, this, &ScalePanel::take);
    connect(clip_, &QCheckBox::clicked, this, &ScalePanel::take);
    connect(steps_, QOverload<int>::of(&QComboBox::activated), this, &ScalePanel::take);
    for (QLineEdit* edit : {from_, to_}) {
        connect(edit, &QLineEdit::textEdited, this, &ScalePanel::takeTyped);
        connect(edit, &QLineEdit::returnPressed, this, &QWidget::close);
    }
    connect(defaults, &QPushButton::clicked, this, &ScalePanel::reset);
}

QLineEdit* ScalePanel::makeEnd(const char* name, const QString& title, double shown) {
    auto* edit = new QLineEdit(Display::number(shown, 6), this);
    edit->setObjectName(name);
    edit->setAccessibleName(title);
    edit->setFixedWidth(76);
    edit->setAlignment(Qt::AlignRight);
    return edit;
}

void ScalePanel::openAt(const QPoint& corner) {
    adjustSize();
    QPoint at = corner - QPoint(width(), 0);
    if (const QScreen* screen = QGuiApplication::screenAt(corner)) {
        const QRect room = screen->availableGeometry();
        at.setX(std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - width())));
        at.setY(std::clamp(at.y(), room.top(), std::max(room.top(), room.bottom() - height())));
    }
    move(at);
    show();
    (own_->isChecked() ? own_ : frame_->isChecked() ? frame_ : all_)->setFocus();
}

/// Shows the current choice.
void ScalePanel::fill() {
    const ScaleChoice choice = scaleOf(settings_.choice().scales, bar_.quantity);
    all_->setChecked(choice.of == ScaleOf::AllFrames);
    frame_->setChecked(choice.of == ScaleOf::ThisFrame);
    own_->setChecked(choice.of == ScaleOf::Own);
    clip_->setChecked(choice.clips);
    clip_->setEnabled(choice.of != ScaleOf::Own);
    steps_->setCurrentIndex(std::max(0, steps_->findData(choice.intervals)));
}

/// The typed range in the units of the picture; fields that cannot be read are marked.
std::optional<ValueRange> ScalePanel::typed() {
    const std::string unit = bar_.unit.substr(0, bar_.unit.find(" per "));
    const TypedNumber from = typedNumber(from_->text().toStdString(), unit);
    const TypedNumber to = typedNumber(to_->text().toStdString(), unit);
    mark(*from_, qt(from.problem));
    mark(*to_, qt(to.problem));
    if (!from.value || !to.value) return std::nullopt;
    const auto [low, high] = std::minmax({*from.value / factor_, *to.value / factor_});
    if (low < high) return ValueRange{low, high};
    mark(*to_, tr("Enter two different numbers."));
    return std::nullopt;
}

void ScalePanel::takeTyped() {
    own_->setChecked(true);
    take();
}

void ScalePanel::take() {
    ViewChoice view = settings_.choice();
    ScaleChoice& choice = view.scales[bar_.quantity];
    choice.clips = clip_->isChecked();
    choice.intervals = steps_->currentData().toInt();
    choice.of = own_->isChecked() ? ScaleOf::Own : frame_->isChecked() ? ScaleOf::ThisFrame : ScaleOf::AllFrames;
    if (choice.of == ScaleOf::Own) {
        const auto range = typed();
        if (!range) return;
        choice.own = *range;
    }
    clip_->setEnabled(choice.of != ScaleOf::Own);
    settings_.choose(view);
}

void ScalePanel::reset() {
    ViewChoice view = settings_.choice();
    view.scales.erase(bar_.quantity);
    settings_.choose(view);
    for (QLineEdit* edit : {from_, to_}) mark(*edit, {});
    fill();
}

}  // namespace keyblock
