// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Translators get a list of the window's texts from Qt's lupdate. Every text shown
// through a translation must be on that list, and every command must have a translated
// text.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "ui/docks/chart_view.h"
#include "ui/docks/curves.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

using Texts = std::set<std::pair<QString, QString>>;  // context and text

/// A translation that puts every text between these signs, and records the requests.
class SignedLanguage : public QTranslator {
public:
    SignedLanguage() { QCoreApplication::installTranslator(this); }
    ~SignedLanguage() override { QCoreApplication::removeTranslator(this); }

    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char*, int) const override {
        const QString of = QString::fromUtf8(context), said = QString::fromUtf8(text);
        if (isOfQt(of)) return {};
        asked_.insert({of, said});
        return QString::fromUtf8("«%1»").arg(said);
    }
    const Texts& asked() const { return asked_; }

private:
    /// Texts of Qt's own keys, buttons and dialogs; functions without a class use one of these three contexts.
    static bool isOfQt(const QString& context) {
        return context.startsWith('Q') && context != "QWidget" && context != "QMainWindow" && context != "QObject";
    }

    mutable Texts asked_;
};

/// All sources of the window.
std::vector<fs::path> sources() {
    std::vector<fs::path> found;
    for (const char* folder : {"ui", "app/studio"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(KEYBLOCK_SOURCE_DIR) / folder))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") found.push_back(entry.path());
    return found;
}

/// The texts that lupdate finds there.
Texts foundTexts(const fs::path& list) {
    QProcess lupdate;
    lupdate.setWorkingDirectory(KEYBLOCK_SOURCE_DIR);
    lupdate.start(KEYBLOCK_LUPDATE, {"-silent", "-recursive", "-I", ".", "-tr-function-alias",
                                     "QT_TRANSLATE_NOOP+=translatable", "ui", "app/studio", "solver/scene", "-ts",
                                     QString::fromStdString(list.string())});
    EXPECT_TRUE(lupdate.waitForFinished(60000));
    EXPECT_EQ(lupdate.exitCode(), 0);
    EXPECT_EQ(lupdate.readAllStandardError().toStdString(), "") << "a tr() whose class Qt does not know";
    QFile file(QString::fromStdString(list.string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    Texts texts;
    QString context;
    for (QXmlStreamReader xml(&file); !xml.atEnd(); xml.readNext()) {
        if (!xml.isStartElement()) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() == QLatin1String("source")) texts.insert({context, xml.readElementText()});
    }
    return texts;
}

/// A text that is not a literal inside tr() is hidden from lupdate, unless a macro marks it.
TEST(Texts, NoTranslatedTextIsHiddenFromLupdate) {
    const QRegularExpression hidden(R"((translate\(\s*"[^"]*"\s*,|\btr\()\s*[^"\s\)])");
    for (const fs::path& path : sources()) {
        const QString text = QString::fromStdString(test::contentOf(path));
        const auto match = hidden.match(text);
        if (!match.hasMatch() || text.contains("_NOOP(") || text.contains("translatable(")) continue;
        ADD_FAILURE() << path << ", line " << text.left(match.capturedStart()).count('\n') + 1
                      << ": write the text itself into tr(), or mark those of a table with QT_TRANSLATE_NOOP, "
                         "in the solver with translatable";
    }
}

TEST(Texts, EveryCommandIsTranslated) {
    NEED_SCREEN();
    const SignedLanguage language;
    Themes themes;
    MainWindow window(themes);
    for (const QAction* action : window.findChild<Commands*>()->all()) {
        EXPECT_TRUE(action->text().contains(QString::fromUtf8("«"))) << action->objectName().toStdString();
        EXPECT_TRUE(action->statusTip().isEmpty() || action->statusTip().contains(QString::fromUtf8("«")))
            << action->objectName().toStdString();
    }
}

#ifdef KEYBLOCK_LUPDATE
TEST(Texts, EveryShownTextIsFoundByLupdate) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const fs::path scene = scratch.path() / "pull.json";
    fs::copy_file(fs::path(KEYBLOCK_SAMPLES_DIR) / "pull-out-gap.json", scene);
    const SignedLanguage language;
    Themes themes;
    MainWindow window(themes);
    window.show();
    window.openPath(QString::fromStdString(scene.string()));
    auto& document = *window.findChild<Document*>();
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    for (const char* pointer : {"/blocks/0", "/bolts/0", "/stages/0", "/materials/0", "/analysis"}) {
        window.findChild<Selection*>()->set({QString(pointer)});
        settle();
    }
    Runs& runs = *window.findChild<Runs*>();
    runs.start();
    ASSERT_TRUE(waitFor([&] { return !runs.isRunning() && window.findChild<TimeCursor*>()->hasMoment(); }, 120000));
    const auto* curves = window.findChild<Curves*>("curves");
    ASSERT_TRUE(curves);
    const auto* chart = curves->findChild<ChartView*>("chart");
    ASSERT_TRUE(waitFor([&] { return !curves->isVisible() || chart->chart(); }));  // read in the background
    settle();
    const Texts found = foundTexts(scratch.path() / "keyblock.ts");
    EXPECT_GT(found.size(), 1000u);
    EXPECT_GT(language.asked().size(), 400u);
    for (const auto& [context, text] : language.asked())
        EXPECT_TRUE(found.contains({context, text})) << context.toStdString() << ": " << text.toStdString();
}
#endif

}  // namespace
}  // namespace keyblock
