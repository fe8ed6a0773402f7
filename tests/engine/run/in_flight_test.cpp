#include "run/in_flight.hpp"

#include <gtest/gtest.h>

namespace percuss {
namespace {

TEST(ChangeEffect, TheTimeStepActsFromTheNextStepOn) {
    EXPECT_EQ(effect_of_change("model.step.courant"), ChangeEffect::next_step);
    EXPECT_EQ(effect_of_change("model.step"), ChangeEffect::next_step);
    EXPECT_EQ(effect_of_change("model.stepping"), ChangeEffect::rebuild);
}

TEST(ChangeEffect, WhatTheRunDoesNotReadLeavesItAlone) {
    for (const char* key : {"view.field", "view.size.0", "view", "record.frames", "title", "expect.0.max",
                            "analysis.residual", "figure.waves.range", "figure.0.title"})
        EXPECT_EQ(effect_of_change(key), ChangeEffect::none) << key;
}

TEST(ChangeEffect, AllElseBeginsANewRun) {
    for (const char* key :
         {"material.steel.young", "parameters.shank", "model.duration", "probe.p.at", "contact.hit.master",
          "viewer", "figure.waves.interval", "figure.waves.field", "figure.waves", "figure.\"a.b\".range", "",
          "units.time", "contact_solver.scheme"})
        EXPECT_EQ(effect_of_change(key), ChangeEffect::rebuild) << key;
}

}  // namespace
}  // namespace percuss
