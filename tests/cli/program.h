// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the program as a shell would: words in; output, errors and exit code out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::test {

struct Ended {
    int code = -1;  // exit code; −1 when a signal ended it
    std::string out;
    std::string err;
};

/// A started program; its output is kept in files of a scratch folder until it ends.
class Program {
public:
    /// Starts the program with these words, in this folder, with these variables added to the environment and with this
    /// limit of its address space [bytes]. The limit is not set in the test: a thread of OpenBLAS that has not got its
    /// buffer yet would then ask for it forever, and `fork` waits for the end of such threads.
    Program(const std::vector<std::string>& words, const std::filesystem::path& folder,
            const std::map<std::string, std::string>& environment = {},
            std::optional<std::size_t> addressSpace = std::nullopt);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void signal(int number) const;
    /// What it has written to its error output so far.
    std::string errors() const;
    Ended wait();

private:
    std::filesystem::path out_;
    std::filesystem::path err_;
    int process_ = -1;
};

/// Runs the program to its end.
Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder,
          const std::map<std::string, std::string>& environment = {});

}  // namespace keyblock::test
