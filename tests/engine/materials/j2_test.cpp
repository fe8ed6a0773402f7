// Plastic laws on single elements against closed forms.
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "engine/materials/one_element.hpp"

namespace percuss::testing {
namespace {

constexpr double young = 200, poisson = 0.3, triple_shear = 3 * young / (2 * (1 + poisson));

const VoceHardening linear{0.4, 2, 0, 0}, voce{0.4, 2, 0.3, 20};
const TabulatedHardening table{{{0, 0.4}, {0.01, 0.5}, {0.011, 0.51}, {0.03, 0.6}}};

double yield_of(const VoceHardening& law, double strain) {
    return law.yield + law.linear * strain + law.saturation * (1 - std::exp(-law.rate * strain));
}
double yield_of(const TabulatedHardening& law, double strain) {
    for (std::size_t i = 1; i < law.points.size(); ++i) {
        const auto& [x0, y0] = law.points[i - 1];
        const auto& [x1, y1] = law.points[i];
        if (strain <= x1) return y0 + (y1 - y0) * (strain - x0) / (x1 - x0);
    }
    return law.points.back().second;
}

/// Plastic strain at a total equivalent strain in monotonic loading: yield(ep) + 3 mu ep = 3 mu strain, by
/// bisection.
template <class Hardening>
double plastic_strain_at(const Hardening& law, double strain) {
    double low = 0, high = strain;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (yield_of(law, middle) + triple_shear * middle < triple_shear * strain ? low : high) = middle;
    }
    return low;
}

template <class Hardening>
void check_monotonic(const Hardening& law) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : solid_geometries) {
            OneElement element(law, {.kind = kind, .geometry = geometry});
            constexpr int steps = 400;
            for (int n = 1; n <= steps; ++n) {
                element.move_to(isochoric(geometry, 0.04 * n / steps));
                if (n % 50 != 0) continue;
                const double strain = equivalent_strain(geometry, 0.04 * n / steps),
                             expected = plastic_strain_at(law, strain);
                EXPECT_NEAR(element.plastic().strain, expected, 2e-6) << name_of(kind) << " at " << strain;
                EXPECT_NEAR(element.von_mises(), yield_of(law, expected), 2e-5)
                    << name_of(kind) << " at " << strain;
                EXPECT_NEAR(element.stress()[0] + element.stress()[1] + element.stress()[2], 0, 1e-9);
                EXPECT_GT(element.stress()[1], 0);
            }
        }
    }
}

TEST(Plasticity, MonotonicStretchFollowsTheHardeningCurve) {
    check_monotonic(linear);
    check_monotonic(voce);
    check_monotonic(table);
}

TEST(Plasticity, YieldStressAndStressAgreeToRoundingWhateverTheStep) {
    for (const Plasticity& law : {Plasticity(linear), Plasticity(voce), Plasticity(table)}) {
        for (const double step : {1e-4, 1e-2, 0.3}) {
            OneElement element(law, {});
            for (int n = 1; n <= 5; ++n) {
                element.move_to(isochoric(Geometry::plane_strain, 0.004 + n * step));
                EXPECT_NEAR(element.von_mises(), element.plastic().yield, 4e-15) << "step " << step;
                const double ep = element.plastic().strain;
                const double curve =
                    law.index() == 2 ? yield_of(table, ep) : yield_of(std::get<VoceHardening>(law), ep);
                EXPECT_NEAR(element.plastic().yield, curve, 1e-14) << "step " << step;
            }
        }
    }
}

TEST(Plasticity, ASmallShearYieldsAtItsYieldStressOverRootThree) {
    OneElement element(VoceHardening{0.4, 0, 0, 0}, {});
    for (int n = 1; n <= 100; ++n) {
        Eigen::Matrix2d f = Eigen::Matrix2d::Identity();
        f(0, 1) = 0.02 * n / 100;
        element.move_to(f);
    }
    EXPECT_NEAR(element.stress()[3], 0.4 / std::sqrt(3.0), 2e-4);
    // gamma = gamma_e + sqrt(3) ep
    EXPECT_NEAR(element.plastic().strain, (0.02 - 0.4 / std::sqrt(3.0) / (triple_shear / 3)) / std::sqrt(3.0),
                2e-5);
}

TEST(Plasticity, LoadCyclesHardenIsotropically) {
    for (const ElementKind kind : all_kinds) {
        OneElement element(linear, {.kind = kind, .geometry = Geometry::axisymmetric});
        double at = 0, signed_stress = 0, ep = 0;
        for (const double turn : {0.03, -0.02, 0.01}) {
            constexpr int steps = 300;
            for (int n = 1; n <= steps; ++n)
                element.move_to(isochoric(Geometry::axisymmetric, at + (turn - at) * n / steps));
            // 3 mu |change| = stress swing + 3 mu plastic strain, stress at the end = yield(ep)
            const double change = std::abs(turn - at), before = std::abs(signed_stress);
            ep = (ep + change - (before + linear.yield) / triple_shear) / (1 + linear.linear / triple_shear);
            signed_stress = std::copysign(yield_of(linear, ep), turn - at);
            EXPECT_NEAR(element.plastic().strain, ep, 1e-5) << name_of(kind) << " at " << turn;
            EXPECT_NEAR(element.stress()[1] - element.stress()[0], signed_stress, 5e-5)
                << name_of(kind) << " at " << turn;
            at = turn;
        }
    }
}

TEST(Plasticity, AnUnloadingIsElastic) {
    OneElement element(linear, {});
    for (int n = 1; n <= 100; ++n) element.move_to(isochoric(Geometry::plane_strain, 0.02 * n / 100));
    const PlasticState loaded = element.plastic();
    const double work = element.plastic_work();
    for (int n = 1; n <= 100; ++n) element.move_to(isochoric(Geometry::plane_strain, 0.02 - 0.002 * n / 100));
    EXPECT_EQ(element.plastic().strain, loaded.strain);
    EXPECT_EQ(element.plastic().yield, loaded.yield);
    EXPECT_EQ(element.plastic_work(), work);
    EXPECT_LT(element.von_mises(), 0.5 * loaded.yield);
}

TEST(Plasticity, StressTurnsWithTheBodyAfterYieldWithoutDrift) {
    for (const ElementKind kind : all_kinds) {
        OneElement element(linear, {.kind = kind});
        const Eigen::Matrix2d stretched = isochoric(Geometry::plane_strain, 0.05);
        for (int n = 1; n <= 100; ++n) element.move_to(isochoric(Geometry::plane_strain, 0.05 * n / 100));
        const auto before = element.stress();
        const PlasticState flowed = element.plastic();
        constexpr int turns = 3, steps = 400 * turns;
        for (int n = 1; n <= steps + 100; ++n) {
            element.move_to(rotation(2 * M_PI * n / 400) * stretched);
            if (n != steps) continue;
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_NEAR(element.stress()[k], before[k], 1e-11) << name_of(kind);
        }
        // A quarter turn more exchanges the directions.
        EXPECT_NEAR(element.stress()[0], before[1], 1e-11) << name_of(kind);
        EXPECT_NEAR(element.stress()[1], before[0], 1e-11) << name_of(kind);
        EXPECT_NEAR(element.plastic().strain, flowed.strain, 1e-12) << name_of(kind);
    }
}

/// Stretch, then shear at constant stretch, in n steps each: the flow direction turns on the way.
std::array<double, 4> after_turning_path(int n) {
    OneElement element(linear, {});
    for (int k = 1; k <= n; ++k) element.move_to(isochoric(Geometry::plane_strain, 0.01 * k / n));
    for (int k = 1; k <= n; ++k) {
        Eigen::Matrix2d shear = Eigen::Matrix2d::Identity();
        shear(0, 1) = 0.01 * k / n;
        element.move_to(shear * isochoric(Geometry::plane_strain, 0.01));
    }
    return element.stress();
}

TEST(Plasticity, ConvergesInTheStepAlongATurningPath) {
    const auto exact = after_turning_path(20'000);
    const auto error = [&](int n) {
        const auto s = after_turning_path(n);
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += (s[k] - exact[k]) * (s[k] - exact[k]);
        return std::sqrt(sum);
    };
    const double coarse = error(50), fine = error(100);
    RecordProperty("order", std::to_string(std::log2(coarse / fine)));
    EXPECT_GT(std::log2(coarse / fine), 0.9);  // radial return is the implicit Euler method
    EXPECT_LT(fine, 0.01 * 0.4);
}

TEST(Plasticity, ElasticEnergyAndPlasticWorkAreTheWorkOfNodalForces) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : solid_geometries) {
            double errors[2];
            for (const int refined : {0, 1}) {
                OneElement element(voce, {.kind = kind, .geometry = geometry, .inner_radius = 0.3});
                const int steps = refined ? 800 : 400;
                for (int n = 1; n <= steps; ++n) {
                    const double t = static_cast<double>(n) / steps;
                    const double angle = geometry == Geometry::plane_strain ? 0.5 * t : 0;
                    element.move_to(rotation(angle) * isochoric(geometry, 0.3 * std::sin(4 * t)) *
                                    (1 + 0.01 * t));
                }
                errors[refined] =
                    std::abs(element.internal_work - element.elastic_energy() - element.plastic_work()) /
                    element.internal_work;
            }
            EXPECT_LT(errors[0], 1e-4) << name_of(kind);
            EXPECT_LT(errors[1], 0.3 * errors[0]) << name_of(kind);  // second order
        }
    }
}

TEST(Plasticity, YieldsInCauchyStressAtAnyPressure) {
    // At 0.95 and 1.05 of the volume Kirchhoff and Cauchy stress are 5 % apart; steps much finer than that.
    for (const double change : {-0.05, 0.05}) {
        OneElement element(VoceHardening{0.4, 0, 0, 0}, {});
        constexpr int steps = 2000;
        double highest = 0;
        for (int n = 1; n <= steps; ++n) {
            const double part = static_cast<double>(n) / steps;
            element.move_to(std::sqrt(1 + change * part) * isochoric(Geometry::plane_strain, 0.02 * part));
            highest = std::max(highest, element.von_mises());
        }
        EXPECT_NEAR(element.von_mises(), 0.4, 1e-12);
        EXPECT_NEAR(highest, 0.4, 1e-12);
    }
}

TEST(Plasticity, StressAndPlasticStrainOfAStepSumToItsElasticTrial) {
    for (const Plasticity& law : {Plasticity(linear), Plasticity(voce), Plasticity(table)}) {
        for (const double step : {0.003, 0.02, 0.3}) {
            OneElement element(law, {}), elastic(std::monostate{}, {});
            element.move_to(isochoric(Geometry::plane_strain, step));
            elastic.move_to(isochoric(Geometry::plane_strain, step));
            // Consistency, in Cauchy stress at the volume that rounding left.
            EXPECT_NEAR(element.von_mises() + triple_shear * element.plastic().strain, elastic.von_mises(),
                        4e-15 * elastic.von_mises());
        }
    }
}

TEST(Plasticity, AllInstructionSetsGiveTheSameBits) {
    const JohnsonCook johnson_cook{0.3, 0.4, 0.3, 0.02, 1e-3, 1.1, 293, 1356, 293, 400, 0.9};
    for (const Plasticity& law : {Plasticity(voce), Plasticity(table), Plasticity(johnson_cook)}) {
        for (const ElementKind kind : all_kinds) {
            for (const Geometry geometry : solid_geometries) {
                AlignedVector<double> state, force;
                KernelSums sums;
                for (const InstructionSet set :
                     {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
                    if (set > best_instruction_set()) continue;
                    // Eight cells side by side in one block, shaken apart: each lane yields at its own time.
                    Scene scene;
                    scene.geometry = geometry;
                    scene.materials.push_back({"m", 8, young, poisson, BulkViscosity{0.06, 1.2}, {}, law});
                    Body body;
                    body.material = "m";
                    body.element = kind;
                    scene.bodies.push_back(body);
                    Mesh mesh;
                    for (int i = 0; i <= 8; ++i) {
                        mesh.nodes.emplace_back(1 + i, 0);
                        mesh.nodes.emplace_back(1 + i, 1);
                    }
                    for (int i = 0; i < 8; ++i) {
                        Cell cell{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1};
                        if (is_triangle(kind)) cell[3] = -1;
                        mesh.cells.push_back(cell);
                    }
                    MeshBody part;
                    part.kind = kind;
                    part.node_end = mesh.node_count();
                    part.cell_end = mesh.cell_count();
                    mesh.bodies.push_back(part);
                    Batch batch = make_batch(
                        scene, mesh, 0, std::vector<std::array<bool, 2>>(mesh.nodes.size(), {false, false}));
                    batch.kernel =
                        find_kernel({kind, geometry, true, true, static_cast<PlasticLaw>(law.index())}, set);
                    AlignedVector<Node> nodes;
                    for (const Vec2& x : mesh.nodes) nodes.push_back({{x.x(), x.y()}, {0, 0}});
                    std::mt19937 random(3);
                    std::uniform_real_distribution<double> noise(-0.002, 0.002);
                    KernelSums total;
                    for (int step = 0; step < 200; ++step) {
                        for (Node& node : nodes)
                            for (int d = 0; d < 2; ++d) {
                                node.v[d] = noise(random);
                                node.x[d] += node.v[d];
                            }
                        average_volumes(batch, nodes.data());
                        batch.kernel.forces(batch, nodes.data(), 1, 0, 1, total);
                    }
                    double work = 0;
                    for (const double lane : total.plastic) work += lane;
                    EXPECT_GT(work, 0);
                    if (set == InstructionSet::baseline) {
                        state = batch.state;
                        force = batch.force;
                        sums = total;
                        continue;
                    }
                    EXPECT_EQ(std::memcmp(state.data(), batch.state.data(), state.size() * sizeof(double)), 0)
                        << name_of(kind);
                    EXPECT_EQ(std::memcmp(force.data(), batch.force.data(), force.size() * sizeof(double)), 0)
                        << name_of(kind);
                    EXPECT_EQ(std::memcmp(&sums, &total, sizeof sums), 0) << name_of(kind);
                }
            }
        }
    }
}

}  // namespace
}  // namespace percuss::testing
