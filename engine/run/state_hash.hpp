#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace percuss {

inline constexpr std::uint64_t hash_seed = 0xcbf29ce484222325u;

/// FNV-1a, 64 bits. @param seed the hash of what came before.
[[nodiscard]] std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed = hash_seed);
/// 16 hexadecimal digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace percuss
