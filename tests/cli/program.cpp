// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output goes to files rather than pipes, so that no program waits for its reader.
#include "tests/cli/program.h"

#include "tests/scratch_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace keyblock::test {

namespace {

namespace fs = std::filesystem;

void redirect(int descriptor, const fs::path& file) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(opened, descriptor);
}

void limitAddressSpace(std::size_t bytes) {
    const rlimit limit{bytes, bytes};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(125);
}

[[noreturn]] void become(const std::vector<std::string>& words) {
    std::vector<char*> arguments{const_cast<char*>(KEYBLOCK_PROGRAM)};
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(KEYBLOCK_PROGRAM, arguments.data());
    ::_exit(127);
}

}  // namespace

Program::Program(const std::vector<std::string>& words, const fs::path& folder,
                 const std::map<std::string, std::string>& environment, std::optional<std::size_t> addressSpace) {
    static int count = 0;
    const std::string stem = "keyblock-cli-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
    out_ = fs::temp_directory_path() / (stem + ".out");
    err_ = fs::temp_directory_path() / (stem + ".err");
    process_ = ::fork();
    if (process_ != 0)
        return;
    for (const auto& [name, value] : environment)
        ::setenv(name.c_str(), value.c_str(), 1);
    redirect(STDOUT_FILENO, out_);
    redirect(STDERR_FILENO, err_);
    if (::chdir(folder.c_str()) != 0)
        ::_exit(126);
    if (addressSpace) limitAddressSpace(*addressSpace);
    become(words);
}

Program::~Program() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    std::error_code ignored;
    fs::remove(out_, ignored);
    fs::remove(err_, ignored);
}

void Program::signal(int number) const { ::kill(process_, number); }

std::string Program::errors() const { return contentOf(err_); }

Ended Program::wait() {
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(out_), contentOf(err_)};
}

Ended run(const std::vector<std::string>& words, const fs::path& folder,
          const std::map<std::string, std::string>& environment) {
    return Program(words, folder, environment).wait();
}

}  // namespace keyblock::test
