// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/part_folder.h"

#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"
#include "solver/scene/suggest.h"

#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void failFolder(const fs::path& folder, const std::error_code& error) {
    throw CannotWrite(cannotWriteText(folder, error.value()));
}

}  // namespace

PartFolder::PartFolder(const fs::path& folder, const std::function<bool(const std::string&)>& isOurs)
    : shown_(folder) {
    std::error_code error;
    target_ = fs::weakly_canonical(folder, error);
    if (error) failFolder(folder, error);
    if (!target_.has_filename()) target_ = target_.parent_path();
    checkTarget(isOurs);
    removeOldParts(target_);
    part_ = partPath(target_);
    fs::remove_all(part_, error);
    if (!fs::create_directory(part_, error)) failFolder(folder, error);
}

PartFolder::~PartFolder() {
    std::error_code ignored;
    fs::remove_all(part_, ignored);
}

void PartFolder::putInPlace() const {
    std::error_code error;
    fs::path old = part_;
    old += "-old";
    const bool replaced = fs::exists(target_, error);
    if (replaced) fs::rename(target_, old, error);
    if (!error) fs::rename(part_, target_, error);
    std::error_code ignored;
    if (error) fs::rename(old, target_, ignored);
    if (error) failFolder(shown_, error);
    fs::remove_all(old, ignored);
}

void PartFolder::checkTarget(const std::function<bool(const std::string&)>& isOurs) const {
    std::error_code error;
    const fs::file_status status = fs::status(target_, error);
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status))
        throw CannotWrite("cannot write " + shown_.string() + ": it is not a folder; choose another name");
    for (const auto& entry : fs::directory_iterator(target_, error))
        if (const std::string name = entry.path().filename().string(); !isOurs(name))
            throw CannotWrite("cannot write " + shown_.string() + ": the folder contains " + inQuotes(name) +
                              ", which is not part of such an export; choose a new or empty folder");
    if (error) failFolder(shown_, error);
}

}  // namespace keyblock
