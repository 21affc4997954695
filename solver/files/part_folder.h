// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Folders that an export fills appear whole or not at all, as files do, and never
// take the place of anything but an earlier export of their kind.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace keyblock {

/// A folder under another name until all of it is written; removed if it is not.
class PartFolder {
public:
    /// `isOurs` says whether an existing folder may contain a file or folder of this name.
    /// \throws CannotWrite when it holds another, or there is no right to write.
    PartFolder(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& isOurs);
    ~PartFolder();
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    /// Where to write.
    const std::filesystem::path& path() const { return part_; }

    void putInPlace() const;

private:
    void checkTarget(const std::function<bool(const std::string&)>& isOurs) const;

    std::filesystem::path shown_;
    std::filesystem::path target_;
    std::filesystem::path part_;
};

}  // namespace keyblock
