// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The examples that NIST publishes with FIPS 180-4, and the lengths around a block.
#include "solver/files/sha256.h"

#include "solver/files/read_error.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(Sha256, AgreesWithThePublishedExamples) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
    const test::ScratchFolder folder;
    const std::string bytes(200000, 'a');  // more than is read at once
    test::putContent(folder.path() / "bytes", bytes);
    EXPECT_EQ(sha256OfFile(folder.path() / "bytes"), sha256(bytes));
    EXPECT_THROW(sha256OfFile(folder.path()), CannotRead);
    EXPECT_THROW(sha256OfFile(folder.path() / "missing"), CannotRead);
}

}  // namespace
}  // namespace keyblock
