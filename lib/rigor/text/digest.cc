// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/digest.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>
#include <vector>

namespace rigor {
namespace {

using DigestWords = std::array<std::uint64_t, 8>;
using DigestBlock = std::array<std::uint64_t, 16>;

// RFC 7693, 2.6: the fractions of the square roots of the first eight primes.
constexpr DigestWords kDigestStart = {0x6a09e667f3bcc908, 0xbb67ae8584caa73b, 0x3c6ef372fe94f82b,
                                      0xa54ff53a5f1d36f1, 0x510e527fade682d1, 0x9b05688c2b3e6c1f,
                                      0x1f83d9abfb41bd6b, 0x5be0cd19137e2179};

// 2.7: which word of the block goes where, a row a round.
constexpr std::uint8_t kDigestOrder[10][16] = {
    {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
    {14, 10, 4, 8, 9, 15, 13, 6, 1, 12, 0, 2, 11, 7, 5, 3},
    {11, 8, 12, 0, 5, 2, 15, 13, 10, 14, 3, 6, 7, 1, 9, 4},
    {7, 9, 3, 1, 13, 12, 11, 14, 2, 6, 5, 10, 4, 0, 15, 8},
    {9, 0, 5, 7, 2, 4, 10, 15, 14, 1, 11, 12, 6, 8, 3, 13},
    {2, 12, 6, 10, 0, 11, 8, 3, 4, 13, 7, 5, 15, 14, 1, 9},
    {12, 5, 1, 15, 14, 13, 4, 10, 0, 7, 6, 3, 9, 2, 8, 11},
    {13, 11, 7, 14, 12, 1, 3, 9, 5, 0, 15, 4, 8, 6, 2, 10},
    {6, 15, 14, 9, 11, 3, 0, 8, 12, 2, 13, 7, 1, 4, 10, 5},
    {10, 2, 8, 4, 7, 6, 1, 5, 15, 11, 9, 14, 3, 12, 13, 0}};
constexpr std::size_t kDigestRounds = 12;  // the first two rows come again

constexpr std::size_t kDigestPiece = std::size_t{1} << 18U;  // of a file, at a time

/// Written so that compilers see one load in it.
std::uint64_t little_endian(const char* bytes) {
  const auto byte = [bytes](int i) {
    return std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  };
  return byte(0) | byte(1) | byte(2) | byte(3) | byte(4) | byte(5) | byte(6) | byte(7);
}

/// 3.1, the function G.
void stir(std::uint64_t& a, std::uint64_t& b, std::uint64_t& c, std::uint64_t& d, std::uint64_t x,
          std::uint64_t y) {
  a += b + x;
  d = std::rotr(d ^ a, 32);
  c += d;
  b = std::rotr(b ^ c, 24);
  a += b + y;
  d = std::rotr(d ^ a, 16);
  c += d;
  b = std::rotr(b ^ c, 63);
}

/// The row is known to the compiler: that doubles the speed.
template <std::size_t round>
void stir_round(DigestBlock& v, const DigestBlock& m) {
  constexpr auto& s = kDigestOrder[round % std::size(kDigestOrder)];
  stir(v[0], v[4], v[8], v[12], m[s[0]], m[s[1]]);
  stir(v[1], v[5], v[9], v[13], m[s[2]], m[s[3]]);
  stir(v[2], v[6], v[10], v[14], m[s[4]], m[s[5]]);
  stir(v[3], v[7], v[11], v[15], m[s[6]], m[s[7]]);
  stir(v[0], v[5], v[10], v[15], m[s[8]], m[s[9]]);
  stir(v[1], v[6], v[11], v[12], m[s[10]], m[s[11]]);
  stir(v[2], v[7], v[8], v[13], m[s[12]], m[s[13]]);
  stir(v[3], v[4], v[9], v[14], m[s[14]], m[s[15]]);
}

}  // namespace

Hasher::Hasher() : state_(kDigestStart) {
  // 2.5: the parameters of a digest without a key: its length, a fan-out and a depth of one.
  state_[0] ^= 0x01010000U ^ std::tuple_size_v<Digest>;
}

void Hasher::add(std::string_view bytes) {
  while (!bytes.empty()) {
    if (filled_ == kBlock) {
      count_ += kBlock;
      mix(rest_.data(), 0);
      filled_ = 0;
    }
    // Whole blocks need not be copied; the last one waits for what follows.
    for (; filled_ == 0 && bytes.size() > kBlock; bytes.remove_prefix(kBlock)) {
      count_ += kBlock;
      mix(bytes.data(), 0);
    }
    const std::size_t taken = bytes.copy(rest_.data() + filled_, kBlock - filled_);
    filled_ += taken;
    bytes.remove_prefix(taken);
  }
}

Digest Hasher::digest() const {
  Hasher end = *this;
  std::fill(end.rest_.begin() + static_cast<std::ptrdiff_t>(filled_), end.rest_.end(), '\0');
  end.count_ += filled_;
  end.mix(end.rest_.data(), ~std::uint64_t{0});
  Digest digest;
  for (std::size_t i = 0; i < digest.size(); ++i) {
    digest[i] = static_cast<std::uint8_t>(end.state_[i / 8] >> (8 * (i % 8)));
  }
  return digest;
}

/// 3.2, the function F; `last` has all bits set at the end of the text. Texts are shorter than 2⁶⁴.
void Hasher::mix(const char* block, std::uint64_t last) {
  DigestBlock m;
  for (std::size_t i = 0; i < m.size(); ++i) m[i] = little_endian(block + 8 * i);
  DigestBlock v;
  std::copy(state_.begin(), state_.end(), v.begin());
  std::copy(kDigestStart.begin(), kDigestStart.end(), v.begin() + 8);
  v[12] ^= count_;
  v[14] ^= last;
  [&]<std::size_t... round>(std::index_sequence<round...>) { (stir_round<round>(v, m), ...); }
  (std::make_index_sequence<kDigestRounds>());
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] ^= v[i] ^ v[i + 8];
}

Digest digest_of(std::string_view bytes) {
  Hasher hasher;
  hasher.add(bytes);
  return hasher.digest();
}

Digest digest_of(const OpenFile& file) {
  Hasher hasher;
  std::vector<char> piece(kDigestPiece);
  for (std::uint64_t at = 0;;) {
    const std::size_t count = file.read(at, piece.data(), piece.size());
    hasher.add({piece.data(), count});
    at += count;
    if (count < piece.size()) return hasher.digest();
  }
}

std::string hex(const Digest& digest) {
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += "0123456789abcdef"[byte >> 4U];
    text += "0123456789abcdef"[byte & 15U];
  }
  return text;
}

std::string_view digest_bytes(const Digest& digest) {
  return {reinterpret_cast<const char*>(digest.data()), digest.size()};
}

}  // namespace rigor
