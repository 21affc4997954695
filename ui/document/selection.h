// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is selected, as JSON pointers into the scene: tree, canvas and property panel
// all read and write this one list.
#pragma once

#include <QObject>
#include <QStringList>

namespace keyblock {

class Selection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const QStringList& pointers() const { return pointers_; }
    bool contains(const QString& pointer) const { return pointers_.contains(pointer); }
    bool isEmpty() const { return pointers_.isEmpty(); }

    void set(QStringList pointers) {
        pointers.removeDuplicates();
        if (pointers == pointers_) return;
        pointers_ = std::move(pointers);
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
};

}  // namespace keyblock
