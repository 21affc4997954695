// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/fields/object_detail.h"

#include "solver/scene/enum_names.h"
#include "ui/document/document.h"
#include "ui/look/display.h"
#include "ui/look/field_text.h"
#include "ui/panels/fields/field_words.h"
#include "ui/panels/fields/object_at.h"
#include "ui/panels/fields/value_text.h"
#include "ui/picture/section/shown_numbers.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

struct DetailTexts {
    Q_DECLARE_TR_FUNCTIONS(ObjectDetail)
};

/// Describes an object in a few words, depending on its kind.
struct Teller {
    const Document& document;
    const Display& display;

    QString length(double metres) const { return QString::fromUtf8("%1 m").arg(numberText(metres, "m", display, 3)); }
    QString angle(double degrees) const { return numberText(degrees, {}, display, 3) + QString::fromUtf8("°"); }
    QString stress(double pascal) const { return quantity(pascal, "Pa"); }

    QString quantity(double value, std::string_view unit) const {
        return numberText(value, unit, display, 3) + ' ' + display.shown(unit).symbol;
    }

    QString box(double width, double height) const {
        return QString::fromUtf8("%1 × %2").arg(numberText(width, "m", display, 3), length(height));
    }

    QString place(const Point& p) const {
        return numberText(p.x(), "m", display, 4) + ", " + numberText(p.y(), "m", display, 4);
    }

    QString boxOf(const std::vector<Point>& points) const {
        if (points.empty()) return {};
        const auto [left, right] = std::ranges::minmax(points, {}, [](const Point& p) { return p.x(); });
        const auto [low, high] = std::ranges::minmax(points, {}, [](const Point& p) { return p.y(); });
        return box(right.x() - left.x(), high.y() - low.y());
    }

    QString of(const Material& m) const { return quantity(m.youngsModulus, Display::modulusUnit); }
    QString of(const JointMaterial& m) const {
        const QString phi = QString::fromUtf8("φ %1").arg(angle(m.frictionAngle));
        return m.cohesion > 0.0 ? phi + QString::fromUtf8(" · c ") + stress(m.cohesion) : phi;
    }
    QString of(const SceneDomain& d) const { return boxOf(d.boundary); }
    QString of(const Block& b) const { return fromUtf8(b.material); }
    QString of(const SceneRegion& r) const { return boxOf(r.points); }
    QString of(const SceneVoronoi& v) const { return length(v.size); }
    QString of(const SceneJointSet& s) const { return angle(s.dip) + QString::fromUtf8(" · ") + length(s.spacing); }
    QString of(const SceneJoint& j) const {
        double run = 0.0;
        for (std::size_t i = 1; i < j.points.size(); ++i) run += (j.points[i] - j.points[i - 1]).norm();
        return length(run);
    }
    QString of(const SceneTunnel& t) const {
        const QString kind = shownText(profileKindLabels[static_cast<std::size_t>(t.profile)]);
        switch (t.profile) {
            case ProfileKind::Circle: return kind + ' ' + length(t.diameter);
            case ProfileKind::Arched: return kind + ' ' + box(t.width, t.wallHeight + t.rise);
            case ProfileKind::Polygon: return kind + ' ' + boxOf(t.points);
            default: return kind + ' ' + box(t.width, t.height);
        }
    }
    QString of(const Bolt& b) const {
        return QString::fromStdString(b.type) + QString::fromUtf8(" · ") + length((b.head - b.farEnd).norm());
    }
    QString of(const ScenePattern& p) const {
        return QString::fromStdString(p.type) + QString::fromUtf8(" · ") + length(p.spacing);
    }
    QString of(const Support& s) const {
        const QString fix = fromUtf8(fixWords[static_cast<std::size_t>(s.fix)]);
        if (s.boundary) return fromUtf8(boundarySideWords[static_cast<std::size_t>(*s.boundary)]) + ' ' + fix;
        return (s.point ? place(*s.point) : s.blockAt ? place(*s.blockAt) : QString()) + ' ' + fix;
    }
    QString of(const Load& l) const {
        if (l.along) return stress(l.pressure);
        return quantity(l.force.norm(), "N");
    }
    QString of(const Stage& s) const {
        return s.kind == StageKind::Static ? DetailTexts::tr("static")
            : DetailTexts::tr("dynamic · %1 s").arg(numberText(s.duration, "s", display, 3));
    }
    QString of(const Monitor& m) const {
        if (m.bolt)
            return QString::fromStdString(*m.bolt) + QStringLiteral(": ") + fromUtf8(plainTitle(rowOf(m.quantity)));
        if (m.between) return DetailTexts::tr("joint opening");
        return m.point ? place(*m.point) : QString();
    }
    QString of(const InSituStress& s) const {
        if (s.sxx == 0.0 && s.syy == 0.0 && !(s.gradientY == StressGradient{})) return DetailTexts::tr("varies with depth");
        const double sign = display.compressionPositive() ? -1.0 : 1.0;
        return QString("%1 / %2").arg(numberText(sign * s.sxx, "Pa", display, 3), stress(sign * s.syy));
    }
    QString of(const BoltType& t) const {
        return fromUtf8(boltClassWords[static_cast<std::size_t>(t.boltClass)]) + QString::fromUtf8(" · ") +
               QString::fromStdString(lengthText(t.diameter, display.numbers()));
    }
};

struct KindRow {
    std::string_view structure;
    const char* icon;
    QString (*tell)(const Teller&, const void*);
};

template <typename T>
QString tell(const Teller& teller, const void* object) {
    return teller.of(*static_cast<const T*>(object));
}

constexpr KindRow kindRows[] = {
    {"material", "material", tell<Material>}, {"joint material", "material", tell<JointMaterial>},
    {"domain", "outline", tell<SceneDomain>}, {"block", "block", tell<Block>},
    {"region", "region", tell<SceneRegion>}, {"voronoi", "voronoi", tell<SceneVoronoi>},
    {"joint set", "joint-set", tell<SceneJointSet>}, {"joint", "joint", tell<SceneJoint>},
    {"tunnel", "tunnel", tell<SceneTunnel>}, {"bolt", "bolt", tell<Bolt>},
    {"bolt pattern", "pattern", tell<ScenePattern>}, {"support", "support", tell<Support>},
    {"load", "load", tell<Load>}, {"stage", "stage", tell<Stage>}, {"monitor", "monitor", tell<Monitor>},
    {"in-situ stress", "load", tell<InSituStress>}, {"bolt type", "book", tell<BoltType>},
};

const KindRow* kindOf(const ObjectAt& at) {
    for (const KindRow& row : kindRows)
        if (row.structure == at.structure->name) return &row;
    return nullptr;
}

}  // namespace

QString detailOf(const Document& document, const Display& display, const std::string& pointer) {
    const auto at = objectAt(*document.scene(), pointer);
    const KindRow* kind = at ? kindOf(*at) : nullptr;
    return kind ? kind->tell(Teller{document, display}, at->object) : QString();
}

QString iconOf(const Document& document, const std::string& pointer) {
    const auto at = objectAt(*document.scene(), pointer);
    const KindRow* kind = at ? kindOf(*at) : nullptr;
    return kind ? kind->icon : "more";
}

}  // namespace keyblock
