// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Objects that the user has hidden in the section or locked against the mouse. This
// is part of the view, not of the scene: it is not saved and not affected by undo.
// Objects are remembered by name, so that they stay hidden when others are added or
// removed, and follow a new name.
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

    /// For an object (`/joints/3`) or a whole list (`/joints`). Entries of a hidden list are hidden.
    bool isHidden(const QString& pointer) const { return has(hidden_, pointer); }
    bool isLocked(const QString& pointer) const { return has(locked_, pointer); }
    void setHidden(const QString& pointer, bool hidden);
    void setLocked(const QString& pointer, bool locked);

    /// True while nothing is hidden.
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
    std::shared_ptr<const Scene> seen_;  // the scene of these names
};

}  // namespace keyblock
