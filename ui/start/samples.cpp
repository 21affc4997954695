// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/samples.h"

#include "solver/files/json/json_tree.h"
#include "solver/files/scene/scene_rescue.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStringList>

#include <algorithm>

namespace keyblock {

namespace {

constexpr char samplesFolder[] = ":/samples";
constexpr double closeTolerance = 0.05;  // relative

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::optional<JsonNode> treeOf(const QString& path) {
    const QByteArray content = contentOf(path);
    return readJson({content.constData(), static_cast<std::size_t>(content.size())}).root;
}

QString textAt(const JsonNode& root, const char* pointer) {
    const JsonNode* node = nodeAt(root, pointer);
    const auto* text = node ? std::get_if<std::string>(&node->value) : nullptr;
    return text ? QString::fromStdString(*text) : QString();
}

double numberAt(const JsonNode& root, const std::string& pointer) {
    const JsonNode* node = nodeAt(root, pointer);
    const auto* number = node ? std::get_if<double>(&node->value) : nullptr;
    return number ? *number : 0.0;
}

bool hasDynamicStage(const JsonNode& root) {
    const JsonNode* stages = nodeAt(root, "/stages");
    const auto* list = stages ? std::get_if<JsonList>(&stages->value) : nullptr;
    return list && std::ranges::any_of(*list, [](const JsonNode& stage) { return textAt(stage, "/kind") == "dynamic"; });
}

/// Whether all expected values have close tolerances and none is a result of the program itself.
bool isVerification(const JsonNode& root) {
    const JsonNode* expected = nodeAt(root, "/about/expected");
    const auto* list = expected ? std::get_if<JsonList>(&expected->value) : nullptr;
    return list && !list->empty() && std::ranges::all_of(*list, [](const JsonNode& value) {
        return numberAt(value, "/tolerance") <= closeTolerance && !textAt(value, "/source").contains("result of this program");
    });
}

Sample sampleOf(const QString& path, const JsonNode& root, const JsonNode& measured) {
    Sample sample;
    sample.name = QFileInfo(path).completeBaseName();
    sample.path = path;
    sample.title = textAt(root, "/title");
    sample.shows = textAt(root, "/about/shows");
    sample.category = textAt(root, "/about/category");
    sample.isDynamic = hasDynamicStage(root);
    sample.isVerification = isVerification(root);
    const std::string row = "/samples/" + sample.name.toStdString();
    sample.blocks = static_cast<int>(numberAt(measured, row + "/blocks"));
    sample.bolts = static_cast<int>(numberAt(measured, row + "/bolts"));
    sample.seconds = numberAt(measured, row + "/seconds");
    return sample;
}

/// The most instructive samples come first.
std::pair<int, int> rankOf(const Sample& sample) {
    static const QStringList first{"drift-rebar-dbolt", "rebar-stated", "dbolt-text-steel", "drift-bolted",
                                   "drift-unbolted", "rebar-elastic-85", "split-set", "incline", "slope-shaken",
                                   "deep-drift"};
    const int place = first.indexOf(sample.name);
    return {place < 0 ? first.size() : place, QStringList{"drifts", "bolts", "blocks"}.indexOf(sample.category)};
}

}  // namespace

std::vector<Sample> gallerySamples() {
    const JsonNode measured = treeOf(":/gallery/samples.json").value_or(JsonNode{});
    std::vector<Sample> samples;
    for (const QFileInfo& file : QDir(samplesFolder).entryInfoList({"*.json"}, QDir::Files, QDir::Name))
        if (const auto root = treeOf(file.filePath())) samples.push_back(sampleOf(file.filePath(), *root, measured));
    std::ranges::stable_sort(samples, {}, rankOf);
    return samples;
}

QString sampleRecordFolder() {
    const QString records = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/samples";
    QDir().mkpath(records);
    for (const QString& name : QDir(samplesFolder).entryList({"*.csv"})) {
        const QString copy = records + "/" + name;
        if (contentOf(copy) == contentOf(samplesFolder + ("/" + name))) continue;
        QFile::remove(copy);
        QFile::copy(samplesFolder + ("/" + name), copy);
    }
    return records;
}

std::optional<Scene> sampleScene(const Sample& sample) {
    const QByteArray content = contentOf(sample.path);
    SceneRescue rescue = rescueSceneText({content.constData(), static_cast<std::size_t>(content.size())},
                                         sample.path.toStdString(), sampleRecordFolder().toStdString());
    if (!rescue.scene) return {};
    for (Stage& stage : rescue.scene->stages)
        for (auto* acceleration : {&stage.baseAcceleration, &stage.bodyAcceleration})
            if (*acceleration) (*acceleration)->file.clear();
    return std::move(rescue.scene);
}

}  // namespace keyblock
