#pragma once

#include <memory>

#include "run/snapshot.hpp"

namespace percuss::app {

/// What was on the screen when the design changed: it stays, faintly, until the new run has come to the same
/// time.
struct Ghost {
    std::shared_ptr<const Snapshot> moment;  ///< null: there is none

    /// A new design has replaced what was shown. A ghost that has not been reached yet stays: a slider that
    /// is drawn along builds many runs, none of which gets far.
    void replaced(const std::shared_ptr<const Snapshot>& shown) {
        if (shown && (!moment || shown->time > moment->time)) moment = shown;
    }
    /// @param reached of the new run [time]; @param ended whether it goes no further: its last step need not
    /// be as late as that of the run before
    void follow(double reached, bool ended) {
        if (moment && (ended || reached >= moment->time)) moment.reset();
    }
};

}  // namespace percuss::app
