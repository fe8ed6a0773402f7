// Springs between surfaces: their frequency and energy against closed forms, and what keeps them stable.
#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "contact/joint/penalty_stiffness.hpp"
#include "elements/elastic_stiffness.hpp"
#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

std::string springs(const std::string& scheme, double penalty, const std::string& more = "") {
    return fmt::format("[contact_solver]\nscheme = \"{}\"\npenalty = {:.17g}\n{}", scheme, penalty, more);
}

/// A stiff block of one element, 4 by 4, thrown at the floor: m x'' = k depth with m of half the block at
/// each of two nodes. Soft springs: it bounces as a whole.
Scene thrown(const std::string& solver, const std::string& step = "courant = 0.9") {
    return scene_of(scene_head("plane strain", 0.4, 0.0, step) +
                    box_body("block", {0, 0, 4, 4}, {1, 1}, "velocity = [0, -1]") +
                    "[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n" + solver +
                    contact_pair("hit", "block.bottom", "floor"));
}

TEST(Penalty, BounceOfABlockIsThatOfAMassOnItsSprings) {
    constexpr double factor = 1e-4;
    RecordedRun run(thrown(springs("penalty", factor)));
    run.to_end();
    // Both nodes: f K A^2 / V with K = E / 3 for nu = 0, A = 4, V = 16.
    const double stiffness = 2 * factor * young / 3, mass = 16 * density;
    const double contact_time = M_PI * std::sqrt(mass / stiffness), depth = std::sqrt(mass / stiffness);
    const auto time = run.column("time"), force = run.column("contact.hit.y");
    const auto first = std::find_if(force.begin(), force.end(), [](double f) { return f > 0; });
    const auto last = std::find_if(force.rbegin(), force.rend(), [](double f) { return f > 0; });
    const double lasted = time[static_cast<std::size_t>(force.rend() - last) - 1] -
                          time[static_cast<std::size_t>(first - force.begin())];
    EXPECT_NEAR(lasted, contact_time, 0.01 * contact_time);
    const RunStatistics s = run.solver.statistics();
    EXPECT_NEAR(s.pairs[0].max_penetration, depth, 0.01 * depth);
    EXPECT_NEAR(s.pairs[0].impulse[1], 2 * mass, 0.01 * 2 * mass) << "it comes back as fast as it went";
    EXPECT_EQ(s.pairs[0].events, 2);
    EXPECT_LT(s.maximum_growth, 1e-4) << "what the springs hold is counted";
    EXPECT_LT(run.unexplained_energy(), 1e-12 * s.initial_energy);
    EXPECT_LT(momentum_error(s), 1e-12);
}

/// Two blocks that press on each other through faces that do not match.
Scene pressing(const std::string& solver, const std::string& step = "courant = 0.98", double gap = 0,
               const std::string& rows = "symmetric") {
    return scene_of(scene_head("plane strain", 0.05, 0.3, step) +
                    box_body("upper", {0, 4 + gap, 6, 8 + gap}, {7, 5}, "velocity = [0, -10]") +
                    box_body("lower", {0, 0, 6, 4}, {5, 4}) + solver +
                    bodies_pair("hit", "upper", "lower", rows));
}

/// The elements and springs of a scene at its start as one linear system.
class Coupled {
  public:
    explicit Coupled(const Scene& scene) : solver_(scene) {
        const Mesh& mesh = solver_.setup()->mesh;
        const auto unknowns = static_cast<Eigen::Index>(2 * mesh.nodes.size());
        elements_ = springs_ = Eigen::MatrixXd::Zero(unknowns, unknowns);
        AlignedVector<Node> nodes(solver_.nodes().begin(), solver_.nodes().end());
        for (std::size_t b = 0; b < mesh.bodies.size(); ++b) {
            const MeshBody& body = mesh.bodies[b];
            for (std::int32_t c = body.cell_begin; c < body.cell_end; ++c) {
                const Cell& cell = mesh.cells[static_cast<std::size_t>(c)];
                const CellStiffness stiffness = elastic_stiffness(
                    cell, body.kind, nodes.data(), 0, solver_.batches()[b].material, scene.geometry);
                for (Eigen::Index i = 0; i < 8; ++i)
                    for (Eigen::Index j = 0; j < 8; ++j)
                        elements_(2 * cell[static_cast<std::size_t>(i / 2)] + i % 2,
                                  2 * cell[static_cast<std::size_t>(j / 2)] + j % 2) += stiffness(i, j);
            }
        }
        Eigen::VectorXd root(unknowns);
        std::vector<double> inverse_mass;
        for (Eigen::Index k = 0; k < unknowns; ++k) {
            inverse_mass.push_back(1 / solver_.lumped_mass()[static_cast<std::size_t>(k / 2)]);
            root(k) = std::sqrt(inverse_mass.back());
        }
        const double dt = solver_.critical_step();
        for (Node& node : nodes)
            for (std::size_t d = 0; d < 2; ++d) node.x[d] += dt * node.v[d];
        const auto contact = make_contact_method(scene, mesh, ContactScheme::penalty);
        std::vector<double> impulse(static_cast<std::size_t>(unknowns), 0);
        std::vector<std::int32_t> touched;
        PredictedMotion motion{dt, dt, nodes.data(), inverse_mass.data(), impulse.data(), &touched};
        RunStatistics unused;
        contact->resolve(motion, unused);
        bound = motion.squared_frequency;
        const PenaltyStiffness stiffness(scene, mesh);
        for (const ContactRow& row : contact->rows(0)) {
            const auto terms = contact->rows(0).terms(row);
            Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns);
            for (const RowTerm& term : terms)
                for (Eigen::Index d = 0; d < 2; ++d)
                    g(2 * term.node + d) += term.g[static_cast<std::size_t>(d)];
            springs_ +=
                scene.contact_solver.penalty * stiffness.of(terms, row.master_terms) * g * g.transpose();
            ++rows;
        }
        elements_ = root.asDiagonal() * elements_ * root.asDiagonal();
        springs_ = root.asDiagonal() * springs_ * root.asDiagonal();
    }
    /// The highest squared frequency of the springs alone, and of all.
    [[nodiscard]] double of_springs() const { return highest(springs_); }
    [[nodiscard]] double of_all() const { return highest(elements_ + springs_); }
    double bound = 0;  ///< of the springs', by the scheme
    int rows = 0;

  private:
    static double highest(const Eigen::MatrixXd& matrix) {
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .maxCoeff();
    }
    Solver solver_;
    Eigen::MatrixXd elements_, springs_;
};

// At 0.98 of critical the step is below that of the eigenvalues of elements and springs together, and not
// much smaller than the rule for springs that come and go, 1/dt for them alone, asks for.
TEST(Penalty, StepIsBelowThatOfElementsAndSpringsTogether) {
    for (const std::string rows : {"symmetric", "node-to-side"})
        for (const double factor : {0.1, 1.0, 10.0, 100.0}) {
            const Scene scene = pressing(springs("penalty", factor), "courant = 0.98", 0, rows);
            const Coupled exact(scene);
            RecordedRun run(scene);
            run.step();
            const double dt = run.solver.statistics().dt_min / 0.98;
            ASSERT_GT(exact.rows, 5);
            EXPECT_GE(exact.bound, exact.of_springs()) << rows << " " << factor;
            EXPECT_LE(exact.bound, 2 * exact.of_springs()) << rows << " " << factor;
            EXPECT_LE(dt * dt, 4 / exact.of_all()) << rows << " " << factor;
            EXPECT_LE(dt * dt, 1 / exact.of_springs()) << rows << " " << factor;
            EXPECT_GE(dt * dt, 0.4 / std::max(exact.of_springs(), exact.of_all() / 4))
                << rows << " " << factor;
        }
}

TEST(Penalty, LowersTheStepAsMuchAsStiffSpringsNeed) {
    for (const double factor : {0.1, 1.0, 10.0, 100.0}) {
        RecordedRun run(pressing(springs("penalty", factor)));
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        EXPECT_LT(s.maximum_growth, 0.02) << factor;
        EXPECT_LT(run.unexplained_energy(), 1e-10 * s.initial_energy);
        EXPECT_LT(momentum_error(s), 1e-12);
    }
}

/// A rod hits another of the same section.
Scene two_rods(double factor, const std::string& step, const std::string& pair) {
    return scene_of(scene_head("axisymmetric", 0.02, 0, "courant = " + step) +
                    box_body("one", {0, 0, 5, 20}, {3, 12}, "velocity = [0, 10]") +
                    box_body("two", {0, 20, 5, 40}, {3, 12}) + springs("penalty", factor) +
                    "[[contact]]\nname = \"hit\"\n" + pair);
}

// What springs hold is a function of where the nodes are: a node deep beside a corner stays with the face
// that it came through (0.05 at a factor of 0.03 where it does not), and one in a shallow valley has one
// spring (0.02 at a factor of 1 where it has two). What is left is of second order in the step.
TEST(Penalty, SpringsBringNoEnergyIn) {
    for (const double factor : {0.03, 0.1, 1.0}) {
        for (const auto& [step, most] : {std::pair{"0.8", 2e-3}, {"0.1", 5e-5}}) {
            Solver solver(two_rods(factor, step, "bodies = [\"one\", \"two\"]\n"));
            while (!solver.finished()) ASSERT_FALSE(solver.step());
            EXPECT_LT(solver.statistics().maximum_growth, most) << factor << " at " << step;
            EXPECT_LT(solver.statistics().maximum_loss, 1e-4) << factor << " at " << step;
        }
    }
}

// Faces that press on each other hardly move relative to each other: springs of nodes that are just outside
// count in the step all the same, as they may be inside in the next one.
TEST(Penalty, KeepsTheStepSmallWhileStiffSpringsAreOutOfTouchForAMoment) {
    for (const double factor : {30.0, 100.0})
        for (const char* step : {"0.7", "0.9"}) {
            Solver solver(two_rods(factor, step, "master = \"two.bottom\"\nslave = \"one.top\"\n"));
            while (solver.time() < 0.006) ASSERT_FALSE(solver.step()) << factor << " at " << step;
            const RunStatistics s = solver.statistics();
            EXPECT_LT(s.maximum_growth, 0.02) << factor << " at " << step;
            EXPECT_LT(s.dt_max, 1.02 * s.dt_min) << "the pulse of 7.7 us is not over";
        }
}

TEST(Penalty, StiffSpringsBlowUpAtTheStepOfTheElements) {
    Solver solver(pressing(springs("penalty", 10, "step = \"elements\"\n")));
    while (!solver.finished())
        if (const auto divergence = solver.step()) {
            EXPECT_NE(divergence->message.find("energy grew"), std::string::npos) << divergence->message;
            return;
        }
    EXPECT_GT(solver.statistics().maximum_growth, 0.1);
}

TEST(Penalty, AFixedStepThatItsSpringsCannotTakeIsStopped) {
    Solver probe(pressing(springs("penalty", 10)));
    const auto fixed = fmt::format("fixed = {:.17g}", 0.9 * probe.critical_step());
    try {
        Solver touching(pressing(springs("penalty", 10), fixed));
        FAIL() << "it was taken";
    } catch (const SceneError& error) {
        EXPECT_NE(
            std::string(error.what()).find("is above the critical step with the springs of contact; at most"),
            std::string::npos)
            << error.what();
    }
    // Apart, nothing is known of the springs yet.
    constexpr double gap = 0.05;
    Solver solver(pressing(springs("penalty", 10), fixed, gap));
    while (!solver.finished())
        if (const auto divergence = solver.step()) {
            EXPECT_NE(divergence->message.find("with the springs of contact, below the fixed step"),
                      std::string::npos)
                << divergence->message;
            EXPECT_LT(solver.time(), gap / 10) << "before it gets there";
            return;
        }
    FAIL() << "it went through";
}

// Nodes that come and go take inertia up at one speed and give it back at another: see bipenalty_contact.hpp.
TEST(Bipenalty, TakesTheStepOfTheElementsAndAddsLittleEnergyWithSoftSprings) {
    for (const auto& [factor, growth] : {std::pair{0.1, 5e-3}, {1.0, 0.2}}) {
        RecordedRun run(pressing(springs("bipenalty", factor)));
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        EXPECT_LT(s.maximum_growth, growth) << factor;
        EXPECT_GT(s.dt_min, 0.97 * 0.98 * s.critical_step_initial) << "the elements' own change only";
        EXPECT_LT(run.unexplained_energy(), 1e-10 * s.initial_energy);
        EXPECT_LT(momentum_error(s), 1e-12);
        EXPECT_EQ(s.contact_solver.fallbacks, 0);
    }
}

// A row in touch: C = k depth + m_p d2(depth)/dt2 with the acceleration that came of all forces.
TEST(Bipenalty, ForceIsThatOfSpringAndInertia) {
    constexpr double factor = 0.3;
    RecordedRun run(thrown(springs("bipenalty", factor), "fixed = 1e-4"));
    run.to_end();
    const auto force = run.column("contact.hit.y"), depth = run.column("contact.hit.penetration");
    const double dt = 1e-4, stiffness = factor * young / 3, inertia = stiffness * dt * dt / 4;
    int checked = 0;
    for (std::size_t n = 1; n + 1 < force.size(); ++n) {
        if (force[n - 1] <= 0 || force[n] <= 0 || force[n + 1] <= 0) continue;
        const double acceleration = (depth[n + 1] - 2 * depth[n] + depth[n - 1]) / (dt * dt);
        ASSERT_NEAR(force[n], 2 * (stiffness * depth[n] + inertia * acceleration), 1e-8 * force[n]) << n;
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

}  // namespace
}  // namespace percuss::testing
