// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selection as JSON pointers into the scene, shared by tree, canvas and property
// panel.
#pragma once

#include "ui/edit/pointer_change.h"

#include <QObject>
#include <QSet>
#include <QStringList>

namespace keyblock {

class Document;

/// Maps pointers from before a step; drops deleted objects.
QStringList whereNow(const QStringList& pointers, const WhereNow& now);

class Selection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Follows its objects through all changes of the scene.
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
    QSet<QString> members_;  // the same, for fast lookup
};

}  // namespace keyblock
