// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Objects that the user has hidden in the section or locked against mouse input. This
// is part of the view, not of the scene: it is neither saved nor affected by undo.
// Objects are identified by name, so that they stay hidden when others are added or
// removed, and when they are renamed.
#pragma once

#include "ui/edit/pointer_change.h"

#include <QObject>
#include <QSet>
#include <QString>

#include <memory>

namespace keyblock {

class Document;
struct Scene;

class Visibility : public QObject {
    Q_OBJECT

public:
    explicit Visibility(const Document& document, QObject* parent = nullptr);

    /// True if the object at `pointer` (`/joints/3`) or the list that contains it is hidden. This and the next three
    /// functions also accept a pointer to a whole list (`/joints`).
    bool isHidden(const QString& pointer) const { return has(hidden_, pointer); }
    bool isLocked(const QString& pointer) const { return has(locked_, pointer); }
    void setHidden(const QString& pointer, bool hidden);
    void setLocked(const QString& pointer, bool locked);

    /// True if nothing is hidden.
    bool showsAll() const { return hidden_.isEmpty(); }
    void showAll();

Q_SIGNALS:
    void changed();

private:
    bool has(const QSet<QString>& keys, const QString& pointer) const;
    QString keyOf(const QString& pointer) const;
    void put(QSet<QString>& keys, const QString& pointer, bool in);
    void follow(const WhereNow& now);
    QSet<QString> followed(const QSet<QString>& keys, const WhereNow& now) const;

    const Document& document_;
    QSet<QString> hidden_, locked_;
    std::shared_ptr<const Scene> seen_;  // scene in which the objects have these names
};

}  // namespace keyblock
