#include "run/state_hash.hpp"

#include <fmt/format.h>

namespace percuss {

std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < size; ++k) seed = (seed ^ bytes[k]) * 0x100000001b3u;
    return seed;
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace percuss
