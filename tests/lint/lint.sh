#!/bin/sh
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: lint.sh BUILD_FOLDER COMMANDS_FOLDER all|COMMIT
# Checks what has changed since COMMIT (in the working folder, committed or not): the
# format of changed lines, the words of texts for users, includes, and C++ files with
# clang-tidy. `all` checks every C++ file with clang-tidy and no format, because the
# tree is not formatted as a whole. An empty COMMIT is where the branch left main, or
# the last commit. Every check runs; the exit code is 1 where one found something.
# COMMANDS_FOLDER has a compile_commands.json with a command for each file.
set -eu
cd "$(dirname "$0")/../.."
build=$1
commands=$2
since=$3
failed=""

if [ "$since" = all ]; then
    files=$(git ls-files '*.cpp')
else
    if [ -z "$since" ]; then
        since=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null || true)
        [ -n "$since" ] && [ "$since" != "$(git rev-parse HEAD)" ] || since=HEAD~1
    fi
    since=$(git rev-parse --verify --short "$since^{commit}")
    files=$(git diff --name-only --diff-filter=d "$since" -- '*.cpp')
    echo "Format of the lines changed since $since"
    git diff -U0 --no-color "$since" -- '*.cpp' '*.h' | clang-format-diff -p1 > "$build/format.diff"
    if [ -s "$build/format.diff" ]; then
        cat "$build/format.diff"
        echo "To format these lines: git diff -U0 --no-color $since -- '*.cpp' '*.h' | clang-format-diff -p1 -i"
        failed="$failed format"
    fi
fi

echo "Words and includes"
"$build/tests/source_tests" --gtest_brief=1 || failed="$failed words-or-includes"

# Only files that the build knows: others (fuzzers, benchmarks) have no compile command.
known=""
for file in $files; do
    if grep -q "\"file\": \"$PWD/$file\"" "$commands/compile_commands.json"; then known="$known $file"; fi
done
if [ -n "$known" ]; then
    echo "clang-tidy:" $(echo $known | wc -w) "files"
    # shellcheck disable=SC2086  # a list of files
    echo $known | xargs -n 1 -P "$(nproc)" clang-tidy -p "$commands" --quiet 2>"$build/tidy.log" || {
        grep -v 'warnings\{0,1\} generated\|warnings\{0,1\} treated as error' "$build/tidy.log" || true
        failed="$failed clang-tidy"
    }
fi

if [ -n "$failed" ]; then
    echo "Lint failed:$failed"
    exit 1
fi
echo "Lint found nothing."
