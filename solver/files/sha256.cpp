// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/sha256.h"

#include "solver/files/read_error.h"
#include "solver/files/regular_file.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace keyblock {

namespace {

using Digest = std::array<unsigned char, EVP_MAX_MD_SIZE>;

void requireSuccess(int result) {
    if (result != 1) throw std::runtime_error("OpenSSL could not compute a SHA-256 hash; check its installation");
}

std::string digitsOf(const Digest& digest, unsigned int length) {
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
        text += "0123456789abcdef"[digest[i] >> 4];
        text += "0123456789abcdef"[digest[i] & 0xF];
    }
    return text;
}

}  // namespace

std::string sha256(std::string_view bytes) {
    Digest digest{};
    unsigned int length = 0;
    requireSuccess(EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr));
    return digitsOf(digest, length);
}

std::string sha256OfFile(const std::filesystem::path& path) {
    const auto refuse = [&path](const std::string& why) {
        throw CannotRead("cannot read " + path.string() + ": " + why + "; give the name of a file that can be read");
    };
    if (const std::string special = specialFileAt(path); !special.empty()) refuse("it is " + special);
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse("it cannot be opened");
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    requireSuccess(context ? EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) : 0);
    std::array<char, 65536> part{};
    while (file.read(part.data(), part.size()) || file.gcount() > 0)
        requireSuccess(EVP_DigestUpdate(context.get(), part.data(), static_cast<std::size_t>(file.gcount())));
    if (file.bad()) refuse("reading failed");
    Digest digest{};
    unsigned int length = 0;
    requireSuccess(EVP_DigestFinal_ex(context.get(), digest.data(), &length));
    return digitsOf(digest, length);
}

}  // namespace keyblock
