// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/visibility.h"

#include "ui/document/document.h"
#include "ui/edit/names.h"

namespace keyblock {

Visibility::Visibility(const Document& document, QObject* parent) : QObject(parent), document_(document) {
    connect(&document, &Document::replaced, this, [this] {
        hidden_.clear();
        locked_.clear();
        Q_EMIT changed();
    });
}

QString Visibility::keyOf(const QString& pointer) const {
    const QString list = pointer.section('/', 0, -2);
    if (list.isEmpty()) return pointer;  // of the scene itself
    const std::string name = nameAt(*document_.scene(), pointer.toStdString());
    return name.empty() ? pointer : list + '\n' + QString::fromStdString(name);
}

bool Visibility::has(const QSet<QString>& keys, const QString& pointer) const {
    if (keys.isEmpty()) return false;
    const QString list = pointer.section('/', 0, -2);
    return keys.contains(keyOf(pointer)) || (!list.isEmpty() && keys.contains(list));
}

void Visibility::put(QSet<QString>& keys, const QString& pointer, bool in) {
    const QString key = keyOf(pointer);
    if (keys.contains(key) == in) return;
    if (in)
        keys.insert(key);
    else
        keys.remove(key);
    Q_EMIT changed();
}

void Visibility::setHidden(const QString& pointer, bool hidden) { put(hidden_, pointer, hidden); }

void Visibility::setLocked(const QString& pointer, bool locked) { put(locked_, pointer, locked); }

void Visibility::showAll() {
    if (hidden_.isEmpty()) return;
    hidden_.clear();
    Q_EMIT changed();
}

}  // namespace keyblock
