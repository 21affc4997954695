// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/visibility.h"

#include "ui/document/document.h"
#include "ui/edit/locate.h"
#include "ui/edit/names.h"

#include <QHash>

namespace keyblock {

namespace {

/// Names of a list's entries with their indices; empty if it is not a list.
QHash<QString, int> namesIn(const Scene& scene, const QString& list) {
    QHash<QString, int> names;
    const auto place = locate(scene, list.toStdString());
    if (!place || !place->field || place->field->kind != FieldKind::List) return names;
    const std::size_t count = place->field->children.count(place->owner);
    for (std::size_t i = 0; i < count; ++i)
        names.insert(QString::fromStdString(nameAt(scene, (list + '/' + QString::number(i)).toStdString())), int(i));
    return names;
}

}  // namespace

Visibility::Visibility(const Document& document, QObject* parent)
    : QObject(parent), document_(document), seen_(document.committed()) {
    connect(&document, &Document::moved, this, &Visibility::follow);
    connect(&document, &Document::replaced, this, [this] {
        hidden_.clear();
        locked_.clear();
        Q_EMIT changed();
    });
}

QString Visibility::keyOf(const QString& pointer) const {
    const QString list = pointer.section('/', 0, -2);
    if (list.isEmpty()) return pointer;  // a member of the scene itself
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
    seen_ = document_.committed();
    if (keys.contains(key) == in) return;
    if (in)
        keys.insert(key);
    else
        keys.remove(key);
    Q_EMIT changed();
}

void Visibility::follow(const WhereNow& now) {
    const QSet<QString> hidden = followed(hidden_, now), locked = followed(locked_, now);
    const bool same = hidden == hidden_ && locked == locked_;
    hidden_ = hidden;
    locked_ = locked;
    seen_ = document_.committed();
    if (!same) Q_EMIT changed();
}

/// A name that is missing may have been renamed; unnamed objects are found by index. A deleted object that returns
/// under its name is hidden again.
QSet<QString> Visibility::followed(const QSet<QString>& keys, const WhereNow& now) const {
    QHash<QString, QHash<QString, int>> before, after;
    QSet<QString> found;
    for (const QString& key : keys) {
        const QString list = key.section('\n', 0, 0), name = key.section('\n', 1);
        QString pointer = name.isEmpty() && list.count('/') > 1 ? list : QString();
        if (!name.isEmpty()) {
            if (!before.contains(list)) {
                before[list] = namesIn(*seen_, list);
                after[list] = namesIn(*document_.committed(), list);
            }
            if (!after[list].contains(name) && before[list].contains(name))
                pointer = list + '/' + QString::number(before[list].value(name));
        }
        const auto at = pointer.isEmpty() ? std::nullopt : now(pointer.toStdString());
        if (at) found.insert(keyOf(QString::fromStdString(*at)));
        else if (pointer.isEmpty() || !name.isEmpty()) found.insert(key);
    }
    return found;
}

void Visibility::setHidden(const QString& pointer, bool hidden) { put(hidden_, pointer, hidden); }

void Visibility::setLocked(const QString& pointer, bool locked) { put(locked_, pointer, locked); }

void Visibility::showAll() {
    if (hidden_.isEmpty()) return;
    hidden_.clear();
    Q_EMIT changed();
}

}  // namespace keyblock
