// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_form.h"

#include "solver/files/movie_file.h"
#include "solver/results/frame_quantities.h"
#include "ui/picture/section/arrows.h"
#include "ui/picture/section/contact_lines.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QStandardPaths>

#include <array>
#include <cmath>

namespace keyblock {

namespace {

constexpr int formWidth = 300;  // [px]
constexpr double filmWidth = 160.0;  // [mm] paper width of the frames of an animation
constexpr const char* pictureFolder = "png";  // format of an animation saved as a folder of images

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), int(text.size())); }

enum class Extent { Around, Whole, Screen };

/// Shows all entries without a scroll bar, in every style.
void showAllEntries(QComboBox& combo) { combo.setMaxVisibleItems(24); }

QStringList formatsOf(ExportForm::Kind kind) {
    if (kind == ExportForm::Kind::Numbers) return {"csv"};
    if (kind != ExportForm::Kind::Film) return {"pdf", "svg", "png"};
    return canWriteMovies() ? QStringList{"mp4", "webm", pictureFolder} : QStringList{pictureFolder};
}

QString nameOfFormat(ExportForm::Kind kind, const QString& format) {
    const bool isFolder = kind == ExportForm::Kind::Film && format == pictureFolder;
    return isFolder ? ExportForm::tr("PNG images in a folder") : format.toUpper();
}

PaperFormat paperOf(const QString& format) {
    return format == "svg" ? PaperFormat::Svg : format == "png" ? PaperFormat::Png : PaperFormat::Pdf;
}

/// The folder of the run, or the user's documents if the run is in the program's own data folder.
QString folderFor(const std::filesystem::path& store) {
    const QString folder = QString::fromStdString(store.parent_path().string());
    const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    if (!QDir::cleanPath(folder).startsWith(QDir::cleanPath(own))) return folder;
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents).exists() ? documents : QDir::homePath();
}

}  // namespace

ExportForm::ExportForm(QWidget* parent)
    : QWidget(parent), form_(new QFormLayout(this)), title_(new QLineEdit(this)), perSecond_(new QSpinBox(this)),
      data_(new QCheckBox(tr("Also save the values as CSV"), this)), note_(new QLabel(this)) {
    setFixedWidth(formWidth);
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setVerticalSpacing(8);
    addRows();
    fillBlocks();
    fillBolts();
    for (QComboBox* combo : findChildren<QComboBox*>()) {
        showAllEntries(*combo);
        connect(combo, qOverload<int>(&QComboBox::activated), this, [this] {
            showFields();
            Q_EMIT changed();
        });
    }
    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportForm::showFields);
    connect(title_, &QLineEdit::editingFinished, this, &ExportForm::changed);
    showFields();
}

QComboBox* ExportForm::addCombo(const QString& label, const QString& name, const char* id) {
    auto* combo = new QComboBox(this);
    combo->setAccessibleName(name);
    combo->setObjectName(id);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form_->addRow(label, combo);
    return combo;
}

void ExportForm::addRows() {
    kind_ = addCombo(tr("Content"), tr("Content to export"), "export.kind");
    for (const QString& text : {tr("Section"), tr("Bolt"), tr("Curves"), tr("Events"), tr("Table"), tr("Animation"),
                                tr("All figures and tables")})
        kind_->addItem(text);
    blocks_ = addCombo(tr("Blocks"), tr("Quantity shown on blocks"), "export.quantity");
    bolts_ = addCombo(tr("Bolts"), tr("Quantity shown on bolts"), "export.boltQuantity");
    extent_ = addCombo(tr("Extent"), tr("Extent of the section"), "export.extent");
    bolt_ = addCombo(tr("Bolt"), tr("Bolt"), "export.bolt");
    table_ = addCombo(tr("Table"), tr("Table"), "export.table");
    for (const std::string_view word : tableWords()) table_->addItem(textOf(word));
    form_->addRow(tr("Title"), title_);
    title_->setObjectName("export.title");
    title_->setAccessibleName(tr("Title of the figure"));
    title_->setPlaceholderText(tr("title of the scene"));
    format_ = addCombo(tr("Format"), tr("Format"), "export.format");
    width_ = addCombo(tr("Width"), tr("Width"), "export.width");
    for (const int mm : {80, 120, 160, 180, 240}) width_->addItem(tr("%1 mm").arg(mm), mm);
    width_->setCurrentIndex(2);
    pixels_ = addCombo(tr("Width"), tr("Width in pixels"), "export.pixels");
    for (const int pixels : {1280, 1600, 1920, 2560, 3840}) pixels_->addItem(tr("%1 pixels").arg(pixels), pixels);
    pixels_->setCurrentIndex(2);
    dpi_ = addCombo(tr("Resolution"), tr("Resolution"), "export.dpi");
    for (const int dpi : {150, 300, 600}) dpi_->addItem(tr("%1 dpi").arg(dpi), dpi);
    dpi_->setCurrentIndex(1);
    perSecond_->setRange(1, 60);
    perSecond_->setValue(12);
    perSecond_->setAccessibleName(tr("Frames per second"));
    perSecond_->setObjectName("export.perSecond");
    form_->addRow(tr("Frames per second"), perSecond_);
    data_->setObjectName("export.data");
    data_->setToolTip(tr("Writes the values shown in the figure to CSV files next to it."));
    form_->addRow(QString(), data_);
    note_->setObjectName("export.note");
    note_->setWordWrap(true);
    note_->setProperty("role", "detail");
    form_->addRow(note_);
}

void ExportForm::fillBlocks() {
    static constexpr std::array arrows{QT_TR_NOOP("Principal stresses as crosses"), QT_TR_NOOP("Displacement arrows"),
                                       QT_TR_NOOP("Velocity arrows")};
    blocks_->addItem(tr("Plain"), textOf(plainWord));
    for (const auto& quantity : blockQuantities()) blocks_->addItem(textOf(quantity.display.title), textOf(quantity.name));
    for (std::size_t i = 0; i < arrows.size(); ++i) blocks_->addItem(tr(arrows[i]), textOf(arrowWords()[i]));
    blocks_->addItem(tr("Contact forces"), textOf(contactWord));
}

void ExportForm::fillBolts() {
    bolts_->addItem(tr("Plain"), textOf(plainWord));
    for (const auto& quantity : boltQuantities()) bolts_->addItem(textOf(quantity.display.title), textOf(quantity.name));
}

void ExportForm::fillExtents() {
    const int before = extent_->currentData().toInt();
    extent_->clear();
    extent_->addItem(tr("Around the opening"), int(Extent::Around));
    extent_->addItem(tr("Whole section"), int(Extent::Whole));
    if (now_.view) extent_->addItem(tr("Current view"), int(Extent::Screen));
    extent_->setCurrentIndex(std::max(0, extent_->findData(before)));
}

void ExportForm::fillFormats() {
    QStringList offered;
    for (int i = 0; i < format_->count(); ++i) offered << format_->itemData(i).toString();
    const QStringList wanted = formatsOf(kind());
    if (offered == wanted) return;
    format_->clear();
    for (const QString& format : wanted) format_->addItem(nameOfFormat(kind(), format), format);
}

void ExportForm::take(const Exportable& now) {
    now_ = now;
    const auto choose = [](QComboBox& combo, const std::string& name, const char* otherwise) {
        const int found = combo.findData(QString::fromStdString(name));
        combo.setCurrentIndex(std::max(0, found >= 0 ? found : combo.findData(otherwise)));
    };
    choose(*blocks_, now.quantity, "sigma1");
    choose(*bolts_, now.boltQuantity, "axial_force");
    fillExtents();
    bolt_->clear();
    if (now_.run)
        for (const Bolt& bolt : now_.run->scene().bolts) bolt_->addItem(QString::fromStdString(bolt.name));
    if (now_.bolt >= 0) bolt_->setCurrentIndex(now_.bolt);
    showFields();
}

void ExportForm::choose(ExportWhat what) {
    switch (what) {
        case ExportWhat::Figure: if (kind() > Kind::Events) kind_->setCurrentIndex(int(Kind::Section)); break;
        case ExportWhat::Numbers: kind_->setCurrentIndex(int(Kind::Numbers)); break;
        case ExportWhat::Film: kind_->setCurrentIndex(int(Kind::Film)); break;
        case ExportWhat::Everything: kind_->setCurrentIndex(int(Kind::Everything)); break;
    }
    showFields();
}

ExportForm::Kind ExportForm::kind() const { return static_cast<Kind>(std::max(0, kind_->currentIndex())); }

/// Arrows are scaled to the largest arrow of their frame, so an animation cannot show them.
void ExportForm::allowArrows(bool allowed) {
    auto* model = qobject_cast<QStandardItemModel*>(blocks_->model());
    for (const std::string_view word : arrowWords()) {
        const int row = blocks_->findData(textOf(word));
        if (model) model->item(row)->setEnabled(allowed);
        if (!allowed && blocks_->currentIndex() == row) blocks_->setCurrentIndex(blocks_->findData("sigma1"));
    }
}

/// Shows only the rows that apply to the chosen kind.
void ExportForm::showFields() {
    const Kind what = kind();
    fillFormats();
    allowArrows(what != Kind::Film);
    const auto row = [this](QWidget* field, bool on) {
        field->setVisible(on);
        if (QWidget* label = form_->labelForField(field)) label->setVisible(on);
    };
    const bool isSection = what == Kind::Section || what == Kind::Film || what == Kind::Everything;
    const bool hasBolts = now_.run && !now_.run->scene().bolts.empty();
    const bool isFigure = what <= Kind::Events;
    const bool isPng = format_->currentData().toString() == "png";
    row(blocks_, isSection);
    row(bolts_, isSection && hasBolts);
    row(extent_, isSection);
    row(bolt_, what == Kind::Bolt);
    row(table_, what == Kind::Numbers);
    row(title_, isFigure || what == Kind::Film);
    row(format_, what != Kind::Numbers);
    row(width_, isFigure || what == Kind::Everything);
    row(pixels_, what == Kind::Film);
    row(dpi_, (isFigure || what == Kind::Everything) && isPng);
    row(perSecond_, what == Kind::Film && !isPng);
    row(data_, isFigure);
    note_->setText(note());
    note_->setVisible(!note_->text().isEmpty());
}

QString ExportForm::note() const {
    if (kind() == Kind::Film && !canWriteMovies())
        return tr("MP4 and WebM export requires ffmpeg, which is not installed.");
    if (kind() != Kind::Everything || !now_.run) return {};
    const QString frame = QString::fromStdString(frameText(*now_.run, request().filter));
    if (frame.isEmpty()) return {};
    return tr("The section, bolt and event figures and the tables of bolts, blocks, contacts and forces show %1. Curves and "
              "the other tables cover the whole run.")
        .arg(frame);
}

void ExportForm::setSize(FigureRequest& request) const {
    request.width = width_->currentData().toDouble();
    request.dpi = dpi_->currentData().toInt();
    if (kind() != Kind::Film) return;
    const double pixels = pixels_->currentData().toDouble();
    request.dpi = static_cast<int>(std::lround(25.4 * pixels / filmWidth));
    request.width = 25.4 * pixels / request.dpi;  // makes the width in pixels exact
}

void ExportForm::setMoment(FigureRequest& request) const {
    const Kind what = kind();
    const bool isOfMoment = what != Kind::Curves && what != Kind::Numbers && what != Kind::Film;
    if (!isOfMoment || !now_.run || !now_.frame || *now_.frame >= now_.run->frames().size()) return;
    const FrameHead& head = now_.run->frames()[*now_.frame];
    request.filter.stage = head.stage;
    request.filter.when = When::At;
    request.filter.time = head.time;
    request.filter.events = head.events;
}

FigureRequest ExportForm::request() const {
    FigureRequest request;
    const Kind what = kind();
    request.kind = what <= Kind::Events ? static_cast<FigureKind>(what) : FigureKind::Section;
    request.format = paperOf(format_->currentData().toString());
    setSize(request);
    request.factor = now_.factor;
    request.scales = now_.scales;
    request.runName = now_.store.stem().string();
    if (what != Kind::Everything) request.title = title_->text().trimmed().toStdString();
    if (request.kind == FigureKind::Section) {
        const auto extent = static_cast<Extent>(extent_->currentData().toInt());
        request.quantity = blocks_->currentData().toString().toStdString();
        request.boltQuantity = bolts_->currentData().toString().toStdString();
        request.whole = extent == Extent::Whole;
        if (extent == Extent::Screen) request.window = now_.view;
    }
    if (request.kind == FigureKind::Bolt && bolt_->currentIndex() >= 0) request.filter.bolt = bolt_->currentIndex();
    setMoment(request);
    return request;
}

ExportOrder ExportForm::order() const {
    ExportOrder order;
    const Kind what = kind();
    order.what = what == Kind::Numbers      ? ExportWhat::Numbers
                 : what == Kind::Film       ? ExportWhat::Film
                 : what == Kind::Everything ? ExportWhat::Everything
                                            : ExportWhat::Figure;
    order.store = now_.store;
    order.figure = request();
    order.withData = data_->isChecked();
    order.table = static_cast<TableKind>(std::max(0, table_->currentIndex()));
    order.perSecond = perSecond_->value();
    return order;
}

QString ExportForm::ending() const {
    const QString format = format_->currentData().toString();
    const bool isFolder = kind() == Kind::Everything || (kind() == Kind::Film && format == pictureFolder);
    return isFolder ? QString() : format;
}

QString ExportForm::suggested() const {
    static constexpr std::array names{"section", "bolt", "curves", "events", "table", "animation", "figures"};
    const QString name = kind() == Kind::Numbers ? table_->currentText() : names[std::size_t(kind())];
    return QDir(folderFor(now_.store)).filePath(QString::fromStdString(now_.store.stem().string()) + '-' + name);
}

}  // namespace keyblock
