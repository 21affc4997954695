// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_window.h"

#include "solver/files/run_store/run_store.h"
#include "ui/document/background.h"
#include "ui/export/export_form.h"
#include "ui/export/stoppable_run.h"
#include "ui/export/tab_separated.h"
#include "ui/look/ask_path.h"
#include "ui/look/question.h"
#include "ui/look/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVariant>
#include <QVBoxLayout>

#include <sstream>

namespace keyblock {

namespace {

constexpr int previewWidth = 620, previewDpi = 110;  // [px], and [dpi] for a sheet 160 mm wide

/// The figure as it will be printed, but smaller. If it cannot be painted, `message` says why.
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

/// The content for the clipboard.
struct Copied {
    QByteArray bytes;
    QString problem;  // empty: none
};

std::string bytesOf(const RunSource& run, const ExportOrder& order) {
    if (order.what == ExportWhat::Numbers) {
        std::ostringstream text;
        writeTable(order.table, run, order.figure.filter, text);
        return tabSeparated(text.str());
    }
    FigureRequest figure = order.figure;
    figure.format = PaperFormat::Png;
    return paintFigure(run, figure).bytes;
}

/// \param run null: the run is read from its store, on another thread
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
      painting_(new Background(this)), copying_(new Background(this)), form_(new ExportForm(this)),
      picture_(new QLabel(this)), message_(new QLabel(this)), progress_(new QProgressBar(this)),
      copy_(new QPushButton(tr("Copy"), this)), export_(new QPushButton(tr("Export…"), this)),
      stop_(new QPushButton(tr("Stop"), this)) {
    setObjectName("exportWindow");
    setWindowTitle(tr("Export"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 16, 16, 16);
    row->setSpacing(16);
    row->addWidget(form_);
    row->addWidget(makeResult(), 1);
    connect(form_, &ExportForm::changed, this, [this] {
        showState();
        preview();
    });
    connect(job_, &ExportJob::advanced, this, [this](const QString& what, int done, int all) {
        progress_->setRange(0, all);
        progress_->setValue(done);
        message_->setText(tr("%1: %2 of %3").arg(what).arg(done).arg(all));
    });
    connect(job_, &ExportJob::ended, this, [this](const QString& message, bool) {
        message_->setText(message);
        showState();
    });
    showState();
}

ExportWindow::~ExportWindow() = default;

QWidget* ExportWindow::makeResult() {
    auto* side = new QWidget(this);
    picture_->setObjectName("export.preview");
    picture_->setAccessibleName(tr("Preview"));
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setWordWrap(true);
    picture_->setMinimumSize(previewWidth, 420);
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->setObjectName("export.message");
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
    form_->take(now_);
    form_->choose(what);
    message_->clear();
    showState();
    show();
    raise();
    activateWindow();
    preview();
}

void ExportWindow::refresh() {
    if (!isVisible()) return;
    const Exportable now = shown_();
    const bool isSame = now.run == now_.run && now.run && now.run->frames().size() == frames_;
    if (isSame) return;
    now_ = now;
    form_->take(now_);
    showState();
    preview();
}

void ExportWindow::showState() {
    const bool busy = job_->isBusy();
    const bool isOne = form_->kind() != ExportForm::Kind::Film && form_->kind() != ExportForm::Kind::Everything;
    progress_->setVisible(busy);
    stop_->setVisible(busy);
    export_->setEnabled(now_.run && !busy);
    copy_->setVisible(isOne);
    copy_->setEnabled(bool(now_.run));
}

void ExportWindow::preview() {
    const ExportForm::Kind what = form_->kind();
    frames_ = now_.run ? now_.run->frames().size() : 0;
    if (!now_.run) return showPreview({}, tr("No results yet. Run the scene first."));
    if (what == ExportForm::Kind::Numbers)
        return showPreview({}, tr("CSV with one row per time and object, in SI units."));
    if (what == ExportForm::Kind::Everything)
        return showPreview({}, tr("Section, curves, events and every bolt as figures, and all tables as CSV."));
    const FigureRequest asked = form_->order().figure;
    if (hasCharts(asked.kind)) {
        const Preview made = previewOf(*now_.run, asked);
        return showPreview(made.image, made.message);
    }
    showPreview(image_, image_.isNull() ? tr("Drawing…") : QString());
    painting_->ask([this, asked, store = now_.store]() -> Background::Result {
        Preview made;
        try {
            const RunStore run(store);
            made = previewOf(StoppableRun(run, painting_->ends()), asked);
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

/// Copies a figure as it would be printed at the chosen resolution, or a table as text.
void ExportWindow::copy() {
    if (!now_.run) return;
    const auto copied = [this, isText = form_->kind() == ExportForm::Kind::Numbers](const Copied& made) -> Background::Result {
        return [this, isText, made] {
            if (made.problem.isEmpty() && isText) QApplication::clipboard()->setText(QString::fromUtf8(made.bytes));
            else if (made.problem.isEmpty()) QApplication::clipboard()->setImage(QImage::fromData(made.bytes, "PNG"));
            message_->setText(made.problem.isEmpty() ? tr("Copied") : made.problem);
        };
    };
    const ExportOrder asked = form_->order();
    if (hasCharts(asked.figure.kind)) return copied(copyOf(now_.run.get(), asked))();
    message_->setText(tr("Copying…"));
    copying_->ask([asked, copied] { return copied(copyOf(nullptr, asked)); });
}

/// Asks for the path of the file, or of the folder if images or all files are exported. Empty: cancelled.
QString ExportWindow::askPlace() {
    const QString start = form_->suggested(), ending = form_->ending();
    if (!ending.isEmpty()) return askSavePath(*this, tr("Export"), start + '.' + ending, "*." + ending, ending);
    const QFileInfo suggested(start);
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Export to a folder"), suggested.absolutePath());
    // Images get a folder of their own, so that a later animation can replace them.
    const bool isFilm = form_->kind() == ExportForm::Kind::Film;
    return folder.isEmpty() || !isFilm ? folder : folder + '/' + suggested.fileName();
}

/// Asks whether the files of an earlier export of all figures and tables may be replaced: their names are not chosen.
bool ExportWindow::mayReplace(const ExportOrder& order) {
    if (order.what != ExportWhat::Everything) return true;
    const QDir folder(QString::fromStdString(order.out.string()));
    const QString start = QString::fromStdString(order.figure.runName) + '-';
    QStringList earlier;
    for (const QString& name : folder.entryList({"*.csv", "*.svg", "*.pdf", "*.png"}, QDir::Files))
        if (name.startsWith(start)) earlier += name;
    if (earlier.isEmpty()) return true;
    const QString more = earlier.size() > 5 ? QStringLiteral(", …") : QString();
    const auto answer = ask(*this, tr("Export to a folder"),
                            tr("%1 contains %2 files of an earlier export. Files with the same names are replaced.")
                                .arg(folder.dirName())
                                .arg(earlier.size()),
                            QStringList(earlier.mid(0, 5)).join(", ") + more,
                            {{QMessageBox::Cancel, {}}, {QMessageBox::Yes, tr("Replace")}});
    return answer == QMessageBox::Yes;
}

void ExportWindow::choosePlace() {
    ExportOrder asked = form_->order();
    const QString out = askPlace();
    if (out.isEmpty()) return;
    asked.out = out.toStdString();
    if (!mayReplace(asked)) return;
    message_->setText(tr("Exporting…"));
    job_->start(std::move(asked));
    showState();
}

}  // namespace keyblock
