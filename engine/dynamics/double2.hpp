#pragma once

#include <cstring>

namespace percuss {

/// The two components of a nodal vector, side by side in one register.
using Double2 = double __attribute__((vector_size(16)));

inline Double2 load_pair(const double* from) {
    Double2 pair;
    std::memcpy(&pair, from, sizeof(Double2));
    return pair;
}

inline void store_pair(double* to, const Double2& pair) { std::memcpy(to, &pair, sizeof(Double2)); }

inline Double2 smaller(const Double2& a, const Double2& b) { return a < b ? a : b; }
inline Double2 larger(const Double2& a, const Double2& b) { return a > b ? a : b; }

}  // namespace percuss
