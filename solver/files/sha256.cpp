// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// SHA-256 after FIPS 180-4, in the standard's own symbols. Sixty lines here spare
// a cryptographic library for the one hash that is needed. The round constants are
// computed from their definition, in integers: the first 32 bits of the fractional
// parts of the square and cube roots of the first primes.
#include "solver/files/sha256.h"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace keyblock {

namespace {

using Word = std::uint32_t;
__extension__ using Wide = unsigned __int128;

/// The first 32 fractional bits of the root of `prime` of this order: the integer r with
/// r^order <= prime · 2^(32·order) < (r + 1)^order, its low 32 bits.
Word fractionOfRoot(Word prime, int order) {
    std::uint64_t root = 0;
    for (int bit = 36; bit >= 0; --bit) {
        const std::uint64_t trial = root | (std::uint64_t{1} << bit);
        Wide power = Wide{trial} * trial;
        if (order == 3)
            power *= trial;
        if (power <= Wide{prime} << (32 * order))
            root = trial;
    }
    return static_cast<Word>(root);
}

template <std::size_t Count>
std::array<Word, Count> fractionsOfRoots(int order) {
    std::array<Word, Count> words{};
    std::size_t found = 0;
    for (Word candidate = 2; found < Count; ++candidate) {
        bool prime = true;
        for (Word divisor = 2; divisor * divisor <= candidate; ++divisor)
            prime = prime && candidate % divisor != 0;
        if (prime)
            words[found++] = fractionOfRoot(candidate, order);
    }
    return words;
}

/// The message, one bit, zeros and the length in bits, to a multiple of 64 bytes.
std::vector<std::uint8_t> padded(std::string_view bytes) {
    std::vector<std::uint8_t> message(bytes.begin(), bytes.end());
    message.push_back(0x80);
    while (message.size() % 64 != 56)
        message.push_back(0);
    const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (int shift = 56; shift >= 0; shift -= 8)
        message.push_back(static_cast<std::uint8_t>(bits >> shift));
    return message;
}

std::array<Word, 64> schedule(const std::uint8_t* block) {
    std::array<Word, 64> w{};
    for (std::size_t t = 0; t < 16; ++t)
        for (std::size_t byte = 0; byte < 4; ++byte)
            w[t] = w[t] << 8 | block[4 * t + byte];
    for (std::size_t t = 16; t < 64; ++t) {
        const Word s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
        const Word s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
        w[t] = s1 + w[t - 7] + s0 + w[t - 16];
    }
    return w;
}

void compress(std::array<Word, 8>& hash, const std::uint8_t* block) {
    static const std::array<Word, 64> k = fractionsOfRoots<64>(3);
    const std::array<Word, 64> w = schedule(block);
    auto [a, b, c, d, e, f, g, h] = hash;
    for (std::size_t t = 0; t < 64; ++t) {
        const Word sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const Word t1 = h + sum1 + ((e & f) ^ (~e & g)) + k[t] + w[t];
        const Word sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const Word t2 = sum0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
    }
    const std::array<Word, 8> working{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i)
        hash[i] += working[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
    std::array<Word, 8> hash = fractionsOfRoots<8>(2);
    const std::vector<std::uint8_t> message = padded(bytes);
    for (std::size_t start = 0; start < message.size(); start += 64)
        compress(hash, message.data() + start);
    std::string text;
    for (const Word word : hash)
        for (int shift = 28; shift >= 0; shift -= 4)
            text += "0123456789abcdef"[word >> shift & 0xF];
    return text;
}

}  // namespace keyblock
