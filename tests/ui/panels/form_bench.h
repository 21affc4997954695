// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene with a form over it, composed as in the window.
#pragma once

#include "solver/files/scene/scene_file.h"
#include "tests/ui/screen/screen.h"
#include "ui/document/document.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/properties/field_form.h"
#include "ui/panels/properties/form_row_widget.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

namespace keyblock {

inline Scene sampleScene(const std::string& name) {
    SceneReading reading = readSceneFile(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / (name + ".json"));
    if (!reading.scene) throw std::runtime_error("the sample " + name + " is not sound");
    return *reading.scene;
}

struct FormBench {
    Themes themes;
    Display display;
    Document document;
    FormContext context{document, display, themes};
    FieldForm form{context};

    explicit FormBench(Scene scene) {
        display.setSystem(UnitSystem::Engineering);
        document.startNew(std::move(scene));
        form.resize(300, 900);
        form.show();
        QApplication::setActiveWindow(&form);
    }

    void choose(std::vector<std::string> pointers) {
        form.setObjects(std::move(pointers));
        QCoreApplication::processEvents();
    }

    FormRowWidget* row(const QString& path) { return form.findChild<FormRowWidget*>("row:" + path); }

    QLineEdit* line(const QString& path) {
        FormRowWidget* found = row(path);
        return found ? found->editor().findChild<QLineEdit*>() : nullptr;
    }

    /// Types into the field of that path and presses Enter.
    void type(const QString& path, const QString& text) {
        QLineEdit* field = line(path);
        ASSERT_TRUE(field) << path.toStdString();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents();
    }
};

}  // namespace keyblock
