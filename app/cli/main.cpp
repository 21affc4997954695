// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the command line, performs the command and returns its exit code. Exceptions
// of a command are reported here, on one line, with the exit code for their kind.
#include "app/cli/command_line.h"
#include "app/cli/output.h"
#include "app/start/blas_choice.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/run_store_writer.h"

#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

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

ExitCode outOfMemory() {
    return failed(
        Internal,
        "out of memory; reduce the scene, or raise the limit of memory (ulimit -v), or use a machine with more "
        "memory");
}

/// True if a thread could not be started, for which there was no memory. TBB says so in the text of its error only.
bool lacksThreads(const std::exception& error) {
    const auto* ofSystem = dynamic_cast<const std::system_error*>(&error);
    return (ofSystem && ofSystem->code() == std::errc::resource_unavailable_try_again) ||
           std::string_view(error.what()).starts_with("pthread_create");
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
        return outOfMemory();
    } catch (const std::exception& error) {
        if (lacksThreads(error)) return outOfMemory();
        return failed(Internal, "internal: " + std::string(error.what()) + "; please report it with the scene");
    }
}

}  // namespace

}  // namespace keyblock::cli

int main(int argc, char** argv) {
    using namespace keyblock::cli;
    keyblock::chooseBlas();
    takeFailedWritesAsErrors();
    const ExitCode code = obeyOrTellWhy(argc, argv);
    if (const int failure = outputFailure(); failure != 0 && code == Done)
        return failed(NotWritten,
                      "cannot write to standard output: " + std::string(std::strerror(failure)) + "; free some space");
    return code;
}
