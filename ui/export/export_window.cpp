// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_window.h"

#include "solver/files/run_store.h"
#include "solver/results/frame_quantities.h"
#include "ui/document/background.h"
#include "ui/look/ask_path.h"
#include "ui/look/theme.h"
#include "ui/picture/arrows.h"
#include "ui/picture/contact_lines.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVariant>
#include <QVBoxLayout>

#include <array>
#include <sstream>

namespace keyblock {

namespace {

constexpr int previewWidth = 620, previewDpi = 110;  // [px], of a sheet of 160 mm about as wide

QString textOf(std::string_view text) { return QString::fromUtf8(text.data(), int(text.size())); }

/// The picture as it will be printed, smaller; errors come as words.
struct Preview {
    QImage image;
    QString message;
};

Preview previewOf(const RunSource& run, FigureRequest request) {
    request.format = PaperFormat::Png;
    request.dpi = static_cast<int>(previewDpi * 160.0 / request.width);
    try {
        const std::string bytes = paintFigure(run, request).bytes;
        return {QImage::fromData(reinterpret_cast<const uchar*>(bytes.data()), int(bytes.size()), "PNG"), {}};
    } catch (const std::exception& error) {
        return {{}, QString::fromUtf8(error.what())};
    }
}

/// What goes to the clipboard.
struct Copied {
    QByteArray bytes;
    QString problem;  // empty: none
};

std::string bytesOf(const RunSource& run, const ExportOrder& order) {
    if (order.what == ExportWhat::Numbers) {
        std::ostringstream text;
        writeTable(order.table, run, order.figure.filter, text);
        return text.str();
    }
    FigureRequest figure = order.figure;
    figure.format = PaperFormat::Png;
    return paintFigure(run, figure).bytes;
}

/// \param run null: as the store has it, for other threads.
Copied copyOf(const RunSource* run, const ExportOrder& order) {
    try {
        return {QByteArray::fromStdString(run ? bytesOf(*run, order) : bytesOf(RunStore(order.store), order)), {}};
    } catch (const std::exception& error) {
        return {{}, QString::fromUtf8(error.what())};
    }
}

}  // namespace

ExportWindow::ExportWindow(std::function<Exportable()> shown, const Themes& themes, QWidget* parent)
    : QWidget(parent, Qt::Window), shown_(std::move(shown)), themes_(themes), job_(new ExportJob(this)),
      painting_(new Background(this)), copying_(new Background(this)), kind_(makeCombo(tr("What to export"), "export.kind")),
      quantity_(makeCombo(tr("Quantity"), "export.quantity")), bolt_(makeCombo(tr("Bolt"), "export.bolt")),
      table_(makeCombo(tr("Table"), "export.table")), format_(makeCombo(tr("Format"), "export.format")),
      width_(makeCombo(tr("Width"), "export.width")), dpi_(makeCombo(tr("Resolution"), "export.dpi")),
      perSecond_(new QSpinBox(this)), picture_(new QLabel(this)), message_(new QLabel(this)),
      progress_(new QProgressBar(this)), copy_(new QPushButton(tr("Copy"), this)),
      export_(new QPushButton(tr("Export…"), this)), stop_(new QPushButton(tr("Stop"), this)) {
    setObjectName("exportWindow");
    setWindowTitle(tr("Export"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 16, 16, 16);
    row->setSpacing(16);
    row->addWidget(makeForm());
    row->addWidget(makeResult(), 1);
    connect(job_, &ExportJob::advanced, this, [this](const QString& what, int done, int all) {
        progress_->setRange(0, all);
        progress_->setValue(done);
        message_->setText(tr("%1: %2 of %3").arg(what).arg(done).arg(all));
    });
    connect(job_, &ExportJob::ended, this, [this](const QString& message, bool) {
        message_->setText(message);
        showFields();
    });
    showFields();
}

ExportWindow::~ExportWindow() = default;

QComboBox* ExportWindow::makeCombo(const QString& name, const char* id) {
    auto* combo = new QComboBox(this);
    combo->setAccessibleName(name);
    combo->setObjectName(id);
    return combo;
}

QWidget* ExportWindow::makeForm() {
    auto* side = new QWidget(this);
    side->setFixedWidth(300);
    for (const QString& text : {tr("Section"), tr("Bolt"), tr("Curves"), tr("Events"), tr("Table"), tr("Film"),
                                tr("Everything into a folder")})
        kind_->addItem(text);
    for (const std::string_view word : tableWords()) table_->addItem(textOf(word));
    for (const int mm : {80, 120, 160, 180}) width_->addItem(tr("%1 mm").arg(mm), mm);
    width_->setCurrentIndex(2);
    for (const int dpi : {150, 240, 300, 600}) dpi_->addItem(tr("%1 dots per inch").arg(dpi), dpi);
    dpi_->setCurrentIndex(2);
    perSecond_->setRange(1, 60);
    perSecond_->setValue(12);
    perSecond_->setAccessibleName(tr("Pictures per second"));
    perSecond_->setObjectName("export.perSecond");
    form_ = new QFormLayout(side);
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setVerticalSpacing(8);
    form_->addRow(tr("What"), kind_);
    form_->addRow(tr("Quantity"), quantity_);
    form_->addRow(tr("Bolt"), bolt_);
    form_->addRow(tr("Table"), table_);
    form_->addRow(tr("Format"), format_);
    form_->addRow(tr("Width"), width_);
    form_->addRow(tr("Resolution"), dpi_);
    form_->addRow(tr("Pictures per second"), perSecond_);
    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportWindow::showFields);
    for (QComboBox* combo : {kind_, quantity_, bolt_, width_, table_})
        connect(combo, qOverload<int>(&QComboBox::activated), this, &ExportWindow::preview);
    connect(format_, qOverload<int>(&QComboBox::activated), this, &ExportWindow::showFields);
    return side;
}

QWidget* ExportWindow::makeResult() {
    auto* side = new QWidget(this);
    picture_->setObjectName("export.preview");
    picture_->setAccessibleName(tr("Preview"));
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setWordWrap(true);
    picture_->setMinimumSize(previewWidth, 420);
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    progress_->setTextVisible(false);
    export_->setProperty("primary", true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(message_, 1);
    for (QPushButton* button : {stop_, copy_, export_}) {
        button->setAccessibleName(button->text().remove(QStringLiteral("…")));
        button->setObjectName("export." + button->accessibleName());
        buttons->addWidget(button);
    }
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(picture_, 1);
    column->addWidget(progress_);
    column->addLayout(buttons);
    connect(copy_, &QPushButton::clicked, this, &ExportWindow::copy);
    connect(export_, &QPushButton::clicked, this, &ExportWindow::choosePlace);
    connect(stop_, &QPushButton::clicked, this, [this] { job_->stop(); });
    return side;
}

void ExportWindow::open(ExportWhat what) {
    now_ = shown_();
    fillQuantities();
    bolt_->clear();
    if (now_.run)
        for (const Bolt& bolt : now_.run->scene().bolts) bolt_->addItem(QString::fromStdString(bolt.name));
    if (now_.bolt >= 0) bolt_->setCurrentIndex(now_.bolt);
    switch (what) {
        case ExportWhat::Figure: if (kind() > Kind::Events) kind_->setCurrentIndex(int(Kind::Section)); break;
        case ExportWhat::Numbers: kind_->setCurrentIndex(int(Kind::Numbers)); break;
        case ExportWhat::Film: kind_->setCurrentIndex(int(Kind::Film)); break;
        case ExportWhat::Everything: kind_->setCurrentIndex(int(Kind::Everything)); break;
    }
    message_->clear();
    showFields();
    show();
    raise();
    activateWindow();
    preview();
}

void ExportWindow::fillQuantities() {
    quantity_->clear();
    for (const auto& quantity : blockQuantities())
        quantity_->addItem(textOf(quantity.display.title), textOf(quantity.name));
    for (const auto& quantity : boltQuantities())
        quantity_->addItem(textOf(quantity.display.title), textOf(quantity.name));
    for (const std::string_view word : arrowWords()) quantity_->addItem(tr("Arrows: %1").arg(textOf(word)), textOf(word));
    quantity_->addItem(tr("Forces of contacts"), textOf(contactWord));
    quantity_->setCurrentIndex(std::max(0, quantity_->findData(QString::fromStdString(now_.quantity))));
}

ExportWindow::Kind ExportWindow::kind() const { return static_cast<Kind>(std::max(0, kind_->currentIndex())); }

/// Shows the rows that mean something for what is chosen, and no others.
void ExportWindow::showFields() {
    const Kind what = kind();
    const QStringList formats = what == Kind::Film    ? QStringList{"mp4", "webm"}
                                : what == Kind::Numbers ? QStringList{"csv"}
                                                      : QStringList{"svg", "pdf", "png"};
    if (format_->count() != formats.size() || format_->itemText(0) != formats[0]) {
        format_->clear();
        format_->addItems(formats);
        if (formats.size() == 3) format_->setCurrentIndex(1);
    }
    const auto row = [this](QWidget* field, bool on) {
        field->setVisible(on);
        form_->labelForField(field)->setVisible(on);
    };
    row(quantity_, what == Kind::Section || what == Kind::Film || what == Kind::Everything);
    row(bolt_, what == Kind::Bolt);
    row(table_, what == Kind::Numbers);
    row(format_, what != Kind::Numbers);
    row(width_, what != Kind::Numbers);
    row(dpi_, what == Kind::Film || format_->currentText() == "png");
    row(perSecond_, what == Kind::Film);
    const bool busy = job_->isBusy();
    progress_->setVisible(busy);
    stop_->setVisible(busy);
    export_->setEnabled(now_.run && !busy);
    copy_->setVisible(what != Kind::Film && what != Kind::Everything);
    copy_->setEnabled(bool(now_.run));
}

FigureRequest ExportWindow::request() const {
    static constexpr std::array formats{PaperFormat::Svg, PaperFormat::Pdf, PaperFormat::Png};
    FigureRequest request;
    const Kind what = kind();
    request.kind = what <= Kind::Events ? static_cast<FigureKind>(what) : FigureKind::Section;
    if (format_->count() == int(formats.size())) request.format = formats[std::size_t(std::max(0, format_->currentIndex()))];
    request.width = width_->currentData().toDouble();
    request.dpi = dpi_->currentData().toInt();
    request.factor = now_.factor;
    request.scales = now_.scales;
    request.runName = now_.store.stem().string();
    if (request.kind == FigureKind::Section) request.quantity = quantity_->currentData().toString().toStdString();
    if (request.kind == FigureKind::Bolt && bolt_->currentIndex() >= 0) request.filter.bolt = bolt_->currentIndex();
    const bool isOfMoment = what != Kind::Curves && what != Kind::Numbers && what != Kind::Film;
    if (!isOfMoment || !now_.run || !now_.frame || *now_.frame >= now_.run->frames().size()) return request;
    const FrameHead& head = now_.run->frames()[*now_.frame];
    request.filter.stage = head.stage;
    request.filter.when = When::At;
    request.filter.time = head.time;
    request.filter.events = head.events;
    return request;
}

void ExportWindow::preview() {
    const Kind what = kind();
    if (!now_.run) return showPreview({}, tr("There is no run yet; run the scene first."));
    if (what == Kind::Numbers) return showPreview({}, tr("The table as CSV: one row for each moment and thing, SI units."));
    if (what == Kind::Everything)
        return showPreview({}, tr("Section, curves, events and every bolt as figures, and all tables."));
    const FigureRequest asked = request();
    if (hasCharts(asked.kind)) {
        const Preview made = previewOf(*now_.run, asked);
        return showPreview(made.image, made.message);
    }
    showPreview(image_, image_.isNull() ? tr("Painting …") : QString());
    painting_->ask([this, asked, store = now_.store]() -> Background::Result {
        Preview made;
        try {
            made = previewOf(RunStore(store), asked);
        } catch (const std::exception& error) {
            made.message = QString::fromUtf8(error.what());
        }
        return [this, made] { showPreview(made.image, made.message); };
    });
}

void ExportWindow::showPreview(const QImage& image, const QString& message) {
    image_ = image;
    if (image.isNull()) picture_->setText(message);
    else picture_->setPixmap(QPixmap::fromImage(image.scaled(picture_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

/// A figure as it would be printed at the chosen resolution; a table as text.
void ExportWindow::copy() {
    if (!now_.run) return;
    const auto copied = [this, isText = kind() == Kind::Numbers](const Copied& made) -> Background::Result {
        return [this, isText, made] {
            if (made.problem.isEmpty() && isText) QApplication::clipboard()->setText(QString::fromUtf8(made.bytes));
            else if (made.problem.isEmpty()) QApplication::clipboard()->setImage(QImage::fromData(made.bytes, "PNG"));
            message_->setText(made.problem.isEmpty() ? tr("Copied") : made.problem);
        };
    };
    const ExportOrder asked = order();
    if (hasCharts(asked.figure.kind)) return copied(copyOf(now_.run.get(), asked))();
    message_->setText(tr("Copying …"));
    copying_->ask([asked, copied] { return copied(copyOf(nullptr, asked)); });
}

ExportOrder ExportWindow::order() const {
    ExportOrder order;
    const Kind what = kind();
    order.what = what == Kind::Numbers        ? ExportWhat::Numbers
                 : what == Kind::Film       ? ExportWhat::Film
                 : what == Kind::Everything ? ExportWhat::Everything
                                            : ExportWhat::Figure;
    order.store = now_.store;
    order.figure = request();
    order.table = static_cast<TableKind>(std::max(0, table_->currentIndex()));
    order.perSecond = perSecond_->value();
    return order;
}

QString ExportWindow::suggested() const {
    static constexpr std::array names{"section", "bolt", "curves", "events", "table", "film", "figures"};
    const QString base = QString::fromStdString((now_.store.parent_path() / now_.store.stem()).string());
    const QString name = kind() == Kind::Numbers ? table_->currentText() : names[std::size_t(kind())];
    const QString ending = kind() == Kind::Numbers ? QString("csv") : format_->currentText();
    return base + "-" + name + (kind() == Kind::Everything ? QString() : "." + ending);
}

void ExportWindow::choosePlace() {
    ExportOrder asked = order();
    const QString ending = kind() == Kind::Numbers ? QString("csv") : format_->currentText();
    const QString out = kind() == Kind::Everything
                            ? QFileDialog::getExistingDirectory(this, tr("Export everything into"), suggested())
                            : askSavePath(*this, tr("Export"), suggested(), "*." + ending, ending);
    if (out.isEmpty()) return;
    asked.out = out.toStdString();
    message_->setText(tr("Exporting …"));
    job_->start(std::move(asked));
    showFields();
}

}  // namespace keyblock
