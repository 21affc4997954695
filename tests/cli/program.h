// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the program as a shell would: words in; output, errors and exit code out.
#pragma once

#include <filesystem>
#include <map>
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
    /// Starts the program with these words, in this folder, with these variables added to the environment.
    Program(const std::vector<std::string>& words, const std::filesystem::path& folder,
            const std::map<std::string, std::string>& environment = {});
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
