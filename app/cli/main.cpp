// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the command line, performs the command and returns its exit code. Exceptions
// of a command are reported here, on one line, with the exit code for their kind.
#include "app/cli/command_line.h"
#include "app/cli/output.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/run_store_writer.h"

#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace keyblock::cli {

namespace {

ExitCode obey(int argc, const char* const* argv) {
    const std::variant<Command, Answer> line = readCommandLine(argc, argv);
    if (const Answer* answer = std::get_if<Answer>(&line)) {
        print(answer->text);
        return Done;
    }
    return std::visit([](const auto& options) { return perform(options); }, std::get<Command>(line));
}

ExitCode failed(ExitCode code, const std::string& message) {
    printErrorLine(message);
    return code;
}

ExitCode obeyOrTellWhy(int argc, const char* const* argv) {
    try {
        return obey(argc, argv);
    } catch (const UsageError& error) {
        return failed(Usage, error.what());
    } catch (const StoreExists& error) {
        return failed(Usage, error.what());
    } catch (const CannotRead& error) {
        return failed(Invalid, error.what());
    } catch (const CannotWrite& error) {
        return failed(NotWritten, error.what());
    } catch (const std::bad_alloc&) {
        return failed(Internal, "out of memory; reduce the scene or use a machine with more memory");
    } catch (const std::exception& error) {
        return failed(Internal, "internal: " + std::string(error.what()) + "; please report it with the scene");
    }
}

}  // namespace

}  // namespace keyblock::cli

int main(int argc, char** argv) {
    using namespace keyblock::cli;
    takeFailedWritesAsErrors();
    const ExitCode code = obeyOrTellWhy(argc, argv);
    if (const int failure = outputFailure(); failure != 0 && code == Done)
        return failed(NotWritten, "cannot write to standard output: " + std::string(std::strerror(failure)) +
                                      "; free some space");
    return code;
}
