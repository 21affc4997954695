// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editors/table_editor.h"

#include "ui/document/document.h"
#include "ui/look/display.h"
#include "ui/panels/editors/cell_table.h"
#include "ui/panels/editors/table_chart.h"
#include "ui/panels/fields/field_choices.h"
#include "ui/panels/fields/field_words.h"

#include <QCheckBox>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionButton>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {

namespace {

bool holdsNumbers(const FormRow& row) {
    const FieldKind kind = row.field->kind;
    return kind == FieldKind::Points || kind == FieldKind::PointPair || kind == FieldKind::Pairs;
}

/// A check box that elides a long name in the middle instead of widening the panel; the tooltip shows the full name.
class NameTick : public QCheckBox {
public:
    NameTick(const QString& name, QWidget* parent) : QCheckBox(parent), name_(name) {
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        setToolTip(name);
        setText(plain(name));
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QCheckBox::resizeEvent(event);
        QStyleOptionButton option;
        initStyleOption(&option);
        const int room = style()->subElementRect(QStyle::SE_CheckBoxContents, &option, this).width();
        setText(plain(fontMetrics().elidedText(name_, Qt::ElideMiddle, room)));
    }

private:
    static QString plain(QString text) { return text.replace('&', "&&"); }  // no mnemonic

    QString name_;
};

QString titleWithUnit(const QString& title, const QString& symbol) {
    return symbol.isEmpty() ? title : QString("%1 (%2)").arg(title, symbol);
}

QStringList titles(const FormRow& row) {
    if (row.field->kind == FieldKind::Pairs) return columnTitles(*row.field);
    if (row.field->kind == FieldKind::TextMap) return {TableEditor::tr("Field"), TableEditor::tr("Source")};
    if (row.field->kind == FieldKind::TextList) return {labelOf(*row.field)};
    return {"x", "y"};
}

QVBoxLayout* columnOf(QWidget& widget) {
    auto* layout = new QVBoxLayout(&widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    return layout;
}

}  // namespace

TableEditor::TableEditor(const FormRow& row, const FormContext& context, QWidget* parent)
    : ValueEditor(parent), context_(context), row_(row), table_(new CellTable(titles(row), holdsNumbers(row), this)) {
    QVBoxLayout* layout = columnOf(*this);
    layout->addWidget(table_);
    table_->setGrowing(row.field->kind != FieldKind::PointPair);
    if (row.field->kind == FieldKind::Pairs) layout->addWidget(chart_ = new TableChart(context.themes, this));
    setFocusProxy(table_);
    connect(table_, &CellTable::edited, this, &TableEditor::enter);
    connect(table_, &CellTable::focused, this, &ValueEditor::focused);
}

std::string_view TableEditor::unit(int column) const {
    if (row_.field->kind != FieldKind::Pairs) return holdsNumbers(row_) ? row_.field->unit : std::string_view();
    return columnUnits(row_.at, *row_.field)[column];
}

QStringList TableEditor::headings() const {
    QStringList names = titles(row_);
    for (int i = 0; i < names.size(); ++i) names[i] = titleWithUnit(names[i], context_.display.shown(unit(i)).symbol);
    return names;
}

std::vector<QStringList> TableEditor::textsOf(const FieldValue& value) const {
    std::vector<QStringList> rows;
    const auto number = [&](double x, int column) { return exactNumberText(x, unit(column), context_.display); };
    if (const auto* points = std::get_if<std::vector<Point>>(&value))
        for (const Point& point : *points) rows.push_back({number(point.x(), 0), number(point.y(), 1)});
    if (const auto* table = std::get_if<Table>(&value))
        for (const auto& [a, b] : *table) rows.push_back({number(a, 0), number(b, 1)});
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value))
        for (const std::string& text : *texts) rows.push_back({QString::fromStdString(text)});
    if (const auto* map = std::get_if<std::map<std::string, std::string>>(&value))
        for (const auto& [key, text] : *map)
            rows.push_back({QString::fromStdString(key), QString::fromStdString(text)});
    return rows;
}

void TableEditor::present(const FormRow& row) {
    const bool other = row.pointers != row_.pointers;
    row_ = row;
    table_->setHeadings(headings());
    std::vector<QStringList> texts = row.mixed ? std::vector<QStringList>{} : textsOf(row.value);
    // Keeps input that is not a valid value yet, and does not rewrite an unchanged text while it is edited.
    if (other || (!refused_ && texts != table_->rows())) table_->setRows(texts);
    shown_ = std::move(texts);
    if (!chart_) return;
    Table shown;
    if (const auto* table = std::get_if<Table>(&row.value); table && !row.mixed)
        for (const auto& [a, b] : *table)
            shown.emplace_back(a * context_.display.shown(unit(0)).factor, b * context_.display.shown(unit(1)).factor);
    chart_->present(shown, headings()[0], headings()[1]);
}

Typed<FieldValue> TableEditor::readPairs(const std::vector<QStringList>& rows) const {
    std::vector<Point> points;
    Table table;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        double pair[2] = {0.0, 0.0};
        for (int column = 0; column < 2; ++column) {
            const QString& text = rows[i][column];
            if (text.isEmpty()) return {{}, tr("Row %1: enter both numbers").arg(i + 1)};
            const Typed<double> number = readNumber(text, unit(column), context_.display);
            if (!number.value) return {{}, tr("Row %1: %2").arg(i + 1).arg(number.problem)};
            pair[column] = *number.value;
        }
        points.emplace_back(pair[0], pair[1]);
        table.emplace_back(pair[0], pair[1]);
    }
    if (row_.field->kind == FieldKind::Pairs) return {FieldValue(table), {}};
    if (row_.field->kind == FieldKind::PointPair && points.size() != 2) return {{}, tr("Enter two points")};
    return {FieldValue(points), {}};
}

Typed<FieldValue> TableEditor::read(const std::vector<QStringList>& rows) const {
    if (rows.empty() && row_.field->nullable && row_.field->kind != FieldKind::TextList) return {FieldValue(), {}};
    if (holdsNumbers(row_)) return readPairs(rows);
    if (row_.field->kind == FieldKind::TextList) {
        std::vector<std::string> texts;
        for (const QStringList& row : rows) texts.push_back(row[0].toStdString());
        return {FieldValue(texts), {}};
    }
    std::map<std::string, std::string> map;
    for (const QStringList& row : rows)
        if (!row[0].isEmpty()) map[row[0].toStdString()] = row[1].toStdString();
    return {FieldValue(map), {}};
}

void TableEditor::enter() {
    const auto rows = table_->rows();
    if (rows == shown_) return refused_ ? Q_EMIT takenBack() : void();
    const auto typed = read(rows);
    if (!typed.value) return Q_EMIT refused(typed.problem);
    if (!row_.mixed && *typed.value == row_.value) return refused_ ? Q_EMIT takenBack() : void();
    Q_EMIT entered(*typed.value);
}

NamesEditor::NamesEditor(const FormContext& context, QWidget* parent)
    : ValueEditor(parent), context_(context), ticks_(columnOf(*this)) {
    ticks_->setSpacing(2);
}

/// Keeps the check boxes, and with them the focus, if the names have not changed.
void NamesEditor::present(const FormRow& row) {
    row_ = row;
    const auto* chosen = std::get_if<std::vector<std::string>>(&row.value);
    const auto choices = choicesOf(*context_.document.scene(), *row.field);
    std::vector<std::string> names = choices.value_or(std::vector<std::string>{});
    const std::size_t known = names.size();
    for (const std::string& name : chosen ? *chosen : std::vector<std::string>{})
        if (!std::ranges::count(names, name)) names.push_back(name);
    if (names != names_ || known != known_) {
        qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
        names_ = names, known_ = known;
        for (std::size_t i = 0; i < names_.size(); ++i) addTick(QString::fromStdString(names_[i]), i >= known_);
        if (names_.empty()) addNothing();
    }
    const auto boxes = findChildren<QCheckBox*>(QString(), Qt::FindDirectChildrenOnly);
    for (int i = 0; i < boxes.size(); ++i) {
        const bool ticked = chosen && std::ranges::count(*chosen, names_[i]);
        boxes[i]->setTristate(row.mixed);
        boxes[i]->setCheckState(row.mixed ? Qt::PartiallyChecked : ticked ? Qt::Checked : Qt::Unchecked);
    }
}

void NamesEditor::addNothing() {
    auto* none = new QLabel(tr("No objects to choose from yet"), this);
    none->setProperty("role", "hint");
    ticks_->addWidget(none);
}

void NamesEditor::addTick(const QString& name, bool missing) {
    auto* tick = new NameTick(missing ? tr("%1 (missing)").arg(name) : name, this);
    tick->setAccessibleName(tr("%1: %2").arg(labelOf(*row_.field), name));
    connect(tick, &QCheckBox::clicked, this, [this, name, tick] {
        const bool on = tick->checkState() != Qt::Unchecked;
        Q_EMIT focused();
        enter(name, on);
    });
    ticks_->addWidget(tick);
}

void NamesEditor::enter(const QString& name, bool ticked) {
    std::vector<std::string> chosen;
    if (const auto* held = std::get_if<std::vector<std::string>>(&row_.value)) chosen = *held;
    std::erase(chosen, name.toStdString());
    if (ticked) chosen.push_back(name.toStdString());
    Q_EMIT entered(FieldValue(chosen));
}

}  // namespace keyblock
