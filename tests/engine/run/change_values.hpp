#pragma once

#include <memory>

#include "solver.hpp"

namespace percuss::testing {

/// Changes values of a run in flight. @param edit given an InFlight
template <class Edit>
void change_values(Solver& solver, Edit edit) {
    InFlight values = *solver.in_force();
    edit(values);
    solver.change(std::make_shared<const InFlight>(std::move(values)));
}

/// The step is this part of the critical one from the next step on.
inline void change_step(Solver& solver, double courant) {
    change_values(solver, [&](InFlight& values) {
        values.step = {};
        values.step.courant = courant;
    });
}

}  // namespace percuss::testing
