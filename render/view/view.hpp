#pragma once

#include <memory>

#include "context/context.hpp"
#include "image.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"

namespace percuss::render {

/// Draws snapshots of one run: deformed mesh coloured by a field with colour bar and unit, contact-force
/// arrows with a reference arrow, velocities of the bodies, the time, side charts of histories up to the
/// snapshot's time.
class View {
  public:
    View(Context& context, std::shared_ptr<const RunSetup> setup, ViewOptions options);
    ~View();
    /// @param history may be null: no charts then.
    [[nodiscard]] Image draw(const Snapshot& snapshot, const History* history = nullptr);
    void set_options(const ViewOptions& options);  ///< other field, range, window, ... for the next draw

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace percuss::render
