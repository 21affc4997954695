// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/thumbnails.h"

#include "solver/files/scene/scene_rescue.h"
#include "ui/document/checked.h"
#include "ui/look/theme.h"
#include "ui/start/samples.h"
#include "ui/start/thumbnail.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr int painting = 2;  // to be incremented whenever scenes are painted differently
constexpr qint64 largest = 64 << 20;  // [bytes] size limit of a scene file

struct Painted {
    QImage image;
    SceneFacts facts;
};

/// The name depends on everything that changes the picture: the file's content, the size on the screen, the theme and
/// the program version.
QString cacheFile(const QByteArray& content, QSize size, double ratio, bool dark) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(content);
    hash.addData(QStringLiteral("%1 %2 %3 %4 %5 %6").arg(painting).arg(size.width()).arg(size.height()).arg(ratio).arg(dark)
                     .arg(QCoreApplication::applicationVersion()).toUtf8());
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/thumbnails/" + hash.result().toHex() +
           ".png";
}

bool load(const QString& file, double ratio, Painted& painted) {
    if (!QFile::exists(file) || !painted.image.load(file)) return false;
    painted.image.setDevicePixelRatio(ratio);
    painted.facts = {painted.image.text("blocks").toInt(), painted.image.text("bolts").toInt(),
                     painted.image.text("errors").toInt(), painted.image.text("warnings").toInt(), true};
    return true;
}

/// If a picture cannot be saved, it is painted again next time.
void keep(const QString& file, Painted painted) {
    painted.image.setText("blocks", QString::number(painted.facts.blocks));
    painted.image.setText("bolts", QString::number(painted.facts.bolts));
    painted.image.setText("errors", QString::number(painted.facts.errors));
    painted.image.setText("warnings", QString::number(painted.facts.warnings));
    QDir().mkpath(QFileInfo(file).path());
    const QString part = file + ".part-" + QString::number(QCoreApplication::applicationPid());
    if (painted.image.save(part, "PNG")) QFile::rename(part, file);
    QFile::remove(part);
}

int count(const std::vector<Problem>& problems, Severity severity) {
    return static_cast<int>(std::ranges::count(problems, severity, &Problem::severity));
}

/// Number of errors from reading and checking. A value with errors in both counts once.
int errorsOf(const std::vector<Problem>& reading, const std::vector<Problem>& checking) {
    return count(checking, Severity::Error) +
           static_cast<int>(std::ranges::count_if(reading, [&](const Problem& problem) {
               const auto isSame = [&](const Problem& other) {
                   return other.severity == Severity::Error && other.pointer == problem.pointer;
               };
               return problem.severity == Severity::Error && std::ranges::none_of(checking, isSame);
           }));
}

Painted paint(const QString& path, const QByteArray& content, QSize size, double ratio, const Theme& theme) {
    Painted painted;
    const std::string name = path.toStdString();
    const std::string folder = path.startsWith(':') ? sampleRecordFolder().toStdString()
                                                    : std::filesystem::path(name).parent_path().string();
    SceneRescue rescue =
        rescueSceneText({content.constData(), static_cast<std::size_t>(content.size())}, name, folder);
    SectionPicture picture;
    if (rescue.scene) {
        const auto checked = checkedOf(std::make_shared<const Scene>(std::move(*rescue.scene)));
        if (checked->picture) picture = *checked->picture;
        const Scene& solved = checked->cut ? checked->cut->scene : *checked->scene;
        painted.facts = {static_cast<int>(solved.blocks.size()), static_cast<int>(solved.bolts.size()),
                         errorsOf(rescue.problems, checked->problems), count(checked->problems, Severity::Warning), true};
    }
    painted.image = paintThumbnail(picture, QSize(int(size.width() * ratio), int(size.height() * ratio)), ratio, theme);
    return painted;
}

Painted picture(const QString& path, QSize size, double ratio, const Theme& theme) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > largest) return {};
    const QByteArray content = file.readAll();
    const QString cached = cacheFile(content, size, ratio, theme.dark);
    Painted painted;
    if (load(cached, ratio, painted)) return painted;
    painted = paint(path, content, size, ratio, theme);
    if (painted.facts.isThere) keep(cached, painted);
    return painted;
}

}  // namespace

void Thumbnails::ask(const QString& path, QSize size, double ratio, const Theme& theme) {
    painting_.add([this, path, size, ratio, &theme]() -> Background::Result {
        Painted painted;
        try {
            painted = picture(path, size, ratio, theme);
        } catch (const std::exception&) {
            // If there is not enough memory, for example, the sample is shown without an image.
        }
        return [this, path, size, painted] { Q_EMIT ready(path, size, painted.image, painted.facts); };
    });
}

}  // namespace keyblock
