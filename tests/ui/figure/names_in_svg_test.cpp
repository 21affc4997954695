// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names that mean something in XML, or that XML forbids: every figure remains a file
// that an XML reader takes, with the names as text.
#include "solver/results/history.h"
#include "tests/ui/bricks.h"
#include "ui/figure/figure.h"

#include <gtest/gtest.h>

#include <QXmlStreamReader>

namespace keyblock {
namespace {

using namespace std::string_literals;

const std::string script = "<script xmlns=\"http://www.w3.org/2000/svg\">alert(1)</script>";
const std::string odd = "\"A\" & 'B' < C > D ]]> <!-- "s + '\0' + "\x01\x1b[2J\x7f\uFFFE\uFFFF\u202E";

class NamesInSvg : public ::testing::Test {
protected:
    NamesInSvg() {
        Scene& scene = bricks.scene;
        scene.title = "T " + script + odd;
        scene.materials = {{odd, scene.materials.front().second}};
        for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
            scene.blocks[i].name = odd + std::to_string(i);
            scene.blocks[i].material = odd;
            scene.blocks[i].jointMaterial = odd;
        }
        scene.bolts.front().name = odd;
        scene.boltTypes.front().name = scene.bolts.front().type = odd;
        scene.stages.front().name = odd;
        Monitor pull;
        pull.name = odd + "pull";
        pull.bolt = odd;
        pull.at = 0.7;
        scene.monitors = {pull};
        bricks.results.columns = historyColumns(scene);
        for (int i = 0; i < 5; ++i) {
            HistoryRow row;
            row.time = 0.1 * i;
            row.values.assign(bricks.results.columns.names.size(), 1e4 * i);
            bricks.results.history.push_back(row);
        }
    }
    QString svg(FigureKind kind) const {
        FigureRequest request;
        request.kind = kind;
        request.runName = "run & <others>";
        return QString::fromStdString(paintFigure(MemoryRun(bricks.scene, bricks.results), request).bytes);
    }
    test::BricksRun bricks;
};

TEST_F(NamesInSvg, EveryFigureCanBeReadAsXml) {
    for (const FigureKind kind : {FigureKind::Section, FigureKind::Bolt, FigureKind::Curves, FigureKind::Events}) {
        QXmlStreamReader xml(svg(kind));
        QString title;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement) continue;
            EXPECT_NE(xml.name(), "script") << int(kind);
            if (xml.name() == "title") title = xml.readElementText();
        }
        EXPECT_FALSE(xml.hasError()) << int(kind) << ": " << xml.errorString().toStdString() << " in line "
                                     << xml.lineNumber();
        EXPECT_TRUE(title.contains("\"A\" & 'B' < C > D ]]>")) << int(kind) << ": " << title.toStdString();
    }
}

TEST_F(NamesInSvg, CharactersThatXmlForbidsAreLeftOut) {
    for (const FigureKind kind : {FigureKind::Section, FigureKind::Bolt, FigureKind::Curves, FigureKind::Events})
        for (const QChar c : svg(kind)) {
            const ushort code = c.unicode();
            const bool isForbidden = (code < 0x20 && code != '\n' && code != '\t' && code != '\r') || code >= 0xFFFE;
            ASSERT_FALSE(isForbidden) << int(kind) << ": " << code;
        }
}

}  // namespace
}  // namespace keyblock
