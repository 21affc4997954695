// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selected objects as JSON pointers into the scene, shared by scene tree, canvas
// and property panel.
#pragma once

#include "ui/edit/pointer_change.h"

#include <QObject>
#include <QSet>
#include <QStringList>

namespace keyblock {

class Document;

/// Maps pointers that were valid before an edit to the corresponding pointers after it. Pointers to deleted objects are
/// dropped.
QStringList whereNow(const QStringList& pointers, const WhereNow& now);

class Selection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Keeps the same objects selected when an edit, undo or redo changes their pointers.
    void follow(const Document& document);

    const QStringList& pointers() const { return pointers_; }
    bool contains(const QString& pointer) const { return members_.contains(pointer); }
    bool isEmpty() const { return pointers_.isEmpty(); }

    void set(QStringList pointers) {
        pointers.removeDuplicates();
        if (pointers == pointers_) return;
        pointers_ = std::move(pointers);
        members_ = QSet<QString>(pointers_.begin(), pointers_.end());
        Q_EMIT changed();
    }
    void add(const QString& pointer) { set(pointers_ + QStringList{pointer}); }
    void remove(const QString& pointer) {
        QStringList left = pointers_;
        left.removeAll(pointer);
        set(left);
    }
    void clear() { set({}); }

Q_SIGNALS:
    void changed();

private:
    QStringList pointers_;
    QSet<QString> members_;  // elements of `pointers_`, for fast lookup
};

}  // namespace keyblock
