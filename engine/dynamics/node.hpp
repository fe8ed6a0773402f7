#pragma once

namespace percuss {

/// Motion of one node: position [length] and velocity [velocity] side by side, so that an element corner is one
/// 32-byte load.
struct alignas(32) Node {
    double x[2];
    double v[2];
};

}  // namespace percuss
