// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Atomic writes of export folders: the folder appears complete or not at all, and it
// never replaces anything but an earlier export of the same kind.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace keyblock {

/// A folder that has a temporary name until it is complete. The destructor removes a folder that was not completed.
class PartFolder {
public:
    /// Creates the temporary folder.
    /// \param folder the final path.
    /// \param isOurs returns true for the names of files and folders that belong to an export of this kind.
    /// \throws CannotWrite if an existing folder contains anything else, or the folder cannot be created.
    PartFolder(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& isOurs);
    ~PartFolder();
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    /// Temporary folder to write to; `putInPlace` gives it its final name.
    const std::filesystem::path& path() const { return part_; }

    /// Renames the folder to its final path, replacing an earlier export. \throws CannotWrite
    void putInPlace() const;

private:
    void checkTarget(const std::function<bool(const std::string&)>& isOurs) const;

    std::filesystem::path shown_;
    std::filesystem::path target_;
    std::filesystem::path part_;
};

}  // namespace keyblock
