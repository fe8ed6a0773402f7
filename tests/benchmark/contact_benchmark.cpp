#include <cmath>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "aligned.hpp"
#include "contact/contact_method.hpp"
#include "contact/scheme.hpp"
#include "mesh/build.hpp"
#include "rods.hpp"

namespace percuss::benchmarks {
namespace {

/// A pair of faces pressed into each other by a little, the way a step finds them; `nodes` master nodes.
class PressedFaces {
  public:
    explicit PressedFaces(int nodes) : scene_(rods(nodes - 1)), mesh_(build_mesh(scene_)) {
        const auto& striker = mesh_.bodies[0];
        for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
            const bool moving = static_cast<std::int32_t>(n) < striker.node_end;
            const double push = moving ? 1e-4 * (1 + 0.1 * std::sin(static_cast<double>(n))) : 0;
            nodes_.push_back({{mesh_.nodes[n].x(), mesh_.nodes[n].y() + push}, {0, moving ? 10.0 : 0.0}});
        }
        start_ = nodes_;
        inverse_mass_.assign(2 * nodes_.size(), 1e3);
        impulse_.assign(2 * nodes_.size(), 0);
        pair_ = make_contact_scheme(scene_.contacts[0], mesh_);
        motion_ = {1e-5, 1e-5, nodes_.data(), inverse_mass_.data(), impulse_.data(), &touched_};
    }

    void find() { pair_->find(motion_); }
    void resolve() {
        pair_->resolve(motion_);
        benchmark::DoNotOptimize(pair_->rows().rows.data());
    }
    /// Puts the touched nodes back, so that the next step finds the same.
    void put_back() {
        for (const std::int32_t node : touched_) {
            const auto n = static_cast<std::size_t>(node);
            nodes_[n] = start_[n];
            impulse_[2 * n] = impulse_[2 * n + 1] = 0;
        }
        touched_.clear();
    }

  private:
    Scene scene_;
    Mesh mesh_;
    AlignedVector<Node> nodes_, start_;
    std::vector<double> inverse_mass_, impulse_;
    std::vector<std::int32_t> touched_;
    std::unique_ptr<PairScheme> pair_;
    PredictedMotion motion_;
};

void per_node(benchmark::State& state) {
    const double visits = static_cast<double>(state.iterations()) * static_cast<double>(state.range(0));
    state.counters["seconds_per_node"] =
        benchmark::Counter(visits, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void contact_search(benchmark::State& state) {
    PressedFaces faces(static_cast<int>(state.range(0)));
    for (auto _ : state) faces.find();
    per_node(state);
}

void contact_search_and_solve(benchmark::State& state) {
    PressedFaces faces(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        faces.find();
        faces.resolve();
        faces.put_back();
    }
    per_node(state);
}

/// Two strips of elements whose faces do not match, about to close everywhere: `nodes` contact nodes in the
/// finer face, all in one problem.
/// @param coarse sides of the other face
class PressedStrips {
  public:
    PressedStrips(int nodes, const char* scheme, int coarse)
        : scene_(strips(nodes, scheme, coarse)), mesh_(build_mesh(scene_)) {
        const auto& upper = mesh_.bodies[0];
        for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
            const bool moving = static_cast<std::int32_t>(n) < upper.node_end;
            const double speed = moving ? -10 - 0.1 * std::sin(static_cast<double>(n)) : 0;
            nodes_.push_back({{mesh_.nodes[n].x(), mesh_.nodes[n].y() + dt * speed}, {0, speed}});
        }
        start_ = nodes_;
        inverse_mass_.assign(2 * nodes_.size(), 1e3);
        impulse_.assign(2 * nodes_.size(), 0);
        method_ = make_contact_method(scene_, mesh_, scene_.contact_solver.scheme);
    }

    void step(RunStatistics& statistics) {
        PredictedMotion motion{dt, dt, nodes_.data(), inverse_mass_.data(), impulse_.data(), &touched_};
        method_->resolve(motion, statistics);
        for (const std::int32_t node : touched_) {
            const auto n = static_cast<std::size_t>(node);
            nodes_[n] = start_[n];
            impulse_[2 * n] = impulse_[2 * n + 1] = 0;
        }
        touched_.clear();
    }

  private:
    static constexpr double dt = 1e-5;

    static Scene strips(int nodes, const char* scheme, int coarse) {
        const int fine = nodes - 1;
        const auto body = [&](const char* name, int bottom, int columns) {
            return fmt::format(
                "[[body]]\nname = \"{0}\"\nmaterial = \"steel\"\n[[body.block]]\n"
                "corners = [[0, {1}], [{2}, {1}], [{2}, {3}], [0, {3}]]\ndivisions = [{4}, 1]\n",
                name, bottom, fine, bottom + 1, columns);
        };
        return parse_scene(
            "percuss = 1\n[units]\nlength = \"mm\"\ntime = \"ms\"\nmass = \"kg\"\n[model]\n"
            "geometry = \"plane strain\"\nduration = 1\n[model.step]\ncourant = 0.9\n[[material]]\n"
            "name = \"steel\"\ndensity = 7.85e-6\nyoung = 210\npoisson = 0.3\n" +
                body("upper", 1, fine) + body("lower", 0, coarse) +
                "[contact_solver]\nscheme = \"joint\"\n[[contact]]\nname = \"face\"\n"
                "bodies = [\"upper\", \"lower\"]\nscheme = \"" +
                scheme + "\"\n",
            "strips.toml");
    }

    Scene scene_;
    Mesh mesh_;
    AlignedVector<Node> nodes_, start_;
    std::vector<double> inverse_mass_, impulse_;
    std::vector<std::int32_t> touched_;
    std::unique_ptr<ContactMethod> method_;
};

/// A whole step of contact: how its cost per contact node grows with their number.
void joint_contact(benchmark::State& state, const char* scheme, int (*of_coarse)(int)) {
    const auto nodes = static_cast<int>(state.range(0));
    PressedStrips strips(nodes, scheme, of_coarse(nodes));
    RunStatistics statistics;
    for (auto _ : state) strips.step(statistics);
    per_node(state);
    state.counters["rows"] = statistics.contact_solver.most_rows;
    state.counters["factorisations"] =
        static_cast<double>(statistics.contact_solver.iterations) /
        std::max<double>(1, static_cast<double>(statistics.contact_solver.problems));
}

int five_sixths(int nodes) { return std::max(1, (nodes - 1) * 5 / 6); }
int one(int) { return 1; }

BENCHMARK_CAPTURE(joint_contact, symmetric, "symmetric", five_sixths)->RangeMultiplier(10)->Range(10, 10000);
BENCHMARK_CAPTURE(joint_contact, segment_to_segment, "segment-to-segment", five_sixths)
    ->RangeMultiplier(10)
    ->Range(10, 10000);
BENCHMARK_CAPTURE(joint_contact, node_to_side, "node-to-side", five_sixths)
    ->RangeMultiplier(10)
    ->Range(10, 10000);
BENCHMARK_CAPTURE(joint_contact, on_one_side, "symmetric", one)->RangeMultiplier(10)->Range(10, 10000);
BENCHMARK(contact_search)->Arg(6)->Arg(21)->Arg(101);
BENCHMARK(contact_search_and_solve)->Arg(6)->Arg(21)->Arg(101);

}  // namespace
}  // namespace percuss::benchmarks
